/*---------------------------------------------------------------------------*\
    demCloudExchange.C -- the exchange of momentum between fluid and particles.

    One exchange per step T, with the fluid's velocity u* frozen while the
    particles advance. For each particle i the core gives:

        J_i     impulse of drag, lift, added mass and viscous stress on the
                particle during T                                      [N s]
        R_i     response dJ_i/du of J_i to the fluid's velocity         [kg]
        q_i     response of drag to the pressure gradient, below         [1]

    With mass m, drag coefficient b, velocity v(start) at the start of the step
    and J_d the part of J that is drag,

        free particle       R = m E,  E = 1 - product of exp(-b h/m) over the
                            DEM steps h
        held by neighbours  R = |J_d|/|u* - v(start)|, limited to m E .. b T
        frozen              R = b T

    Added mass a increases m in E to m + a. It adds r = a m/(m + a) to R (a if the
    particle is frozen); its response to the fluid's last change of velocity is
    subtracted from J and from what is carried over (dem/step/sweep_bodies.c).

    Deposit. With the weights w_ic of demTransfer of particle i in cell c (sum
    over c is 1; deposit and sample are adjoint), V_i and V_c their volumes:

        s     = sum_i w_ic V_i/V_c                     solid fraction     [1]
        ds/dt = (s - s_old)/T                                           [1/s]
        F     = - sum_i w_ic (J_i - R_i u*_i)/(V_c T)                  [N/m3]
        K     =   sum_i w_ic R_i/(V_c T)                           [kg/m3/s]

    Deferred correction. The fluid receives F - K u' with its new velocity u',
    which contains the reaction to J_i and to R_i (u'_i - u*_i), u'_i = sum_c
    w_ic u'_c. The particle receives this second impulse, too, as a constant
    force over the next step (carried-over impulse; in snapshots the column
    pending). So momentum is exchanged exactly whatever R is; demMomentumBalance
    checks it each step.

    Slip factor and pressure response. Where the solver's continuity equation
    contains the void fraction e, particles that accelerate displace fluid, which
    changes slip and pressure gradient. With frozen u* and grad p* the exchange
    diverges as soon as T exceeds the relaxation time. The core then computes drag
    with the slip u* - v(start) - c (v - v(start)), slip factor c = 1/e^2, 1/e in
    set III; so E has c b for b, and R = m E/c. The fraction q_i = 1 - m E/(c b T)
    of a steady force that drag passes on to the fluid during T is the response of
    drag to a change of the pressure gradient, and acts both ways like R:

        Y     =   sum_i w_ic q_i V_i/V_c               pressure response  [1]
        fluid:     - Y (grad p' - grad p*)                             [N/m3]
        particle:  + q_i V_i T (grad p'_i - grad p*_i), next step       [N s]

    Elsewhere c = 1 and Y = 0.

    Pressure gradient and weight. The particles receive the full gradient, rho g
    included, so that its force -V_i grad p contains buoyancy. Which part of it
    acts on the fluid depends on the set of equations (demCouplingScheme); in set
    I, and in solvers without void fraction, the fluid receives the reaction
    sum_i w_ic V_i (grad p_i - rho g)/V_c (pressureReaction).

    *, '     before and after the fluid is solved
    _i       at particle i: sampled with w_ic
    Other schemes (semiImplicit, explicit): demCouplingScheme.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demCheck.H"
#include "demColumns.H"
#include "demTurbulenceProduction.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// Columns of the core: the pointers hold until its next collective call
void Foam::demCloud::refresh()
{
    dem_view(dem_, &view_);
    demCheck(dem_fluid(dem_, &fluid_));
}


// Rank and cell of every particle. To be called whenever the core may have moved
// particles or passed them to other ranks.
void Foam::demCloud::locate()
{
    setDiameter();
    refresh();

    if (!fluid_.location)
    {
        address_.setSize(2*view_.n);
        address_ = -1;
    }

    const demParticleRouting::lostParticles outside
    (
        transfer_.locate
        (
            view_,
            fluid_.location ? fluid_.location : address_.begin(),
            &inletsOutlets_
        )
    );
    if (outside.count)
    {
        fail(outside);
    }
    refresh();
}


// The width of the kernel must not change during a run: that would move volume.
// It is set by the first particles, unless the user gives the diameter.
void Foam::demCloud::setDiameter()
{
    if (diameter_ <= 0)
    {
        struct dem_totals now;
        demCheck(dem_totals(dem_, &now));

        if (now.particles > 0)
        {
            diameter_ = std::cbrt
            (
                6*now.volume/(constant::mathematical::pi*scalar(now.particles))
            );
        }
    }

    transfer_.setDiameter(diameter_);
}


// Field values at the particles; a uniform field needs no transfer
Foam::tmp<Foam::scalarField> Foam::demCloud::atParticles
(
    const volScalarField& field
) const
{
    const scalar largest = gMax(field.primitiveField());

    if (largest > gMin(field.primitiveField()))
    {
        return transfer_.sample(field);
    }
    return tmp<scalarField>(new scalarField(view_.n, largest));
}


Foam::demUnderRelaxation Foam::demCloud::underRelaxation() const
{
    return demUnderRelaxation
    (
        fluid_,
        volumes(view_),
        gravity(),
        window_,
        scheme_.set() == demCouplingScheme::II
    );
}


// Told where the particles would oscillate without it, and again when it falls
void Foam::demCloud::updateRelaxation()
{
    const scalar factor =
        returnReduce(scalar(dem_fluid_under_relax(dem_)), minOp<scalar>());

    if (factor < 0.9*toldRelaxation_)
    {
        toldRelaxation_ = factor;
        Info<< "Suna: under-relaxation of the pressure gradient and of Du/Dt down"
            << " to " << factor << " at light particles in a dense suspension,"
            << " which would oscillate from step to step; they feel a change of"
            << " it " << 1/factor << " steps late" << endl;
    }
}


void Foam::demCloud::setFluid
(
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho,
    const volScalarField& mu
)
{
    if (!dem_needs_fluid(dem_))
    {
        return;
    }

    toColumn(transfer_.sample(U)(), fluid_.velocity);
    toColumn(atParticles(rho)(), fluid_.density);
    if (scheme_.wholeDrag())
    {
        const vectorField hydrostatic(atParticles(rho)()*gravity());
        toColumn(hydrostatic, fluid_.pressure_gradient);
    }
    else if (demUnderRelaxation::active(fluid_))
    {
        underRelaxation().begin(transfer_.sample(gradP)(), withoutFactors_);
    }
    else
    {
        toColumn(transfer_.sample(gradP)(), fluid_.pressure_gradient);
    }
    toColumn(transfer_.sample(voidFraction_)(), fluid_.void_fraction);
    toColumn(atParticles(mu)(), fluid_.viscosity);
    setFluidGradients(U, mu);

    // Slip factor
    const bool slipDecaysFaster = volumeAveraged_ && scheme_.isDeferred();
    for (size_t i = 0; i < fluid_.n; i++)
    {
        fluid_.slip_factor[i] =
            slipDecaysFaster
          ? dem_fluid_slip_factor(dem_, fluid_.void_fraction[i])
          : 1;
    }
}


void Foam::demCloud::depositVolume()
{
    scalarField old(voidFraction_.primitiveField());

    volScalarField::Internal solid
    (
        IOobject("solid", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero)
    );
    scalarField behind;
    const scalarField V(reducedVolumes(behind));
    if (throughPatches_.size())
    {
        throughPatches_ = transfer_.fraction()*(throughPatches_ - behind);
    }
    deposited_ = transfer_.fraction()*gSum(V);
    transfer_.depositVolume(V, solid);

    voidFraction_.primitiveFieldRef() = 1 - solid.field();
    voidFraction_.correctBoundaryConditions();

    if (twoWay_)
    {
        // From the void fractions, so that it agrees with their ddt. In a mesh
        // that moves, of volumes of the cell before and after, per its new one
        if (mesh_.moving())
        {
            old *= mesh_.V0().field()/mesh_.V().field();
        }
        dsdt_.primitiveFieldRef() =
            (old - voidFraction_.primitiveField())/mesh_.time().deltaTValue();
    }
    if (volumeAveraged_ && window_ > 0)
    {
        depositFlux(V);
    }
}


// Inflow and outflow take place before the particles advance, so that each
// particle takes part in the whole step
void Foam::demCloud::passInletsOutlets(const volVectorField& U)
{
    if (volumeAveraged_ && twoWay_ && inletsOutlets_.active())
    {
        passWithVolumes(U);
    }
    else if (inletsOutlets_.pass(dem_, U))
    {
        locate();
        checkIds();
    }
}


void Foam::demCloud::depositReaction()
{
    if (!reacts())
    {
        return;
    }

    scalarField response(view_.n);
    vectorField reaction(view_.n);

    demCheck
    (
        dem_fluid_reaction
        (
            dem_,
            scheme_.exchange(),
            window_,
            response.begin(),
            reinterpret_cast<scalar*>(reaction.begin())
        )
    );

    if (volumeAveraged_ && scheme_.isDeferred() && !scheme_.wholeDrag())
    {
        scalarField volumeResponse(volumes(view_));     // q_i V_i
        forAll(volumeResponse, i)
        {
            volumeResponse[i] *= fluid_.transmitted_fraction[i];
        }
        if (demUnderRelaxation::active(fluid_))
        {
            updateRelaxation();
            const demUnderRelaxation relaxation(underRelaxation());
            relaxation.response(volumeResponse);
            reaction += relaxation.explicitForce(transfer_.sample(gradP_)());
        }

        transfer_.deposit(volumeResponse, pressureResponse_.ref());
        pressureResponse_.correctBoundaryConditions();
    }

    if
    (
        volScalarField* production =
            mesh_.getObjectPtr<volScalarField>(demTurbulenceProduction::name())
    )
    {
        transfer_.deposit
        (
            demTurbulenceProduction::ofParticles(fluid_, window_)(),
            production->ref()
        );
        production->correctBoundaryConditions();
    }

    transfer_.deposit(response, drag_.ref());
    transfer_.deposit(reaction, force_.ref());
    drag_.correctBoundaryConditions();
    force_.correctBoundaryConditions();
}


// Rates that limit the next step: of the void fraction's change, and of the
// relaxation of slip by drag, 1/tau, as a mean over this step
void Foam::demCloud::updateRates()
{
    changeRate_ = max(gMax(dsdt_.primitiveField()), -gMin(dsdt_.primitiveField()));

    relaxationRate_ =
        returnReduce(dem_fluid_relaxation(dem_), maxOp<scalar>());
}


bool Foam::demCloud::reacts() const
{
    return twoWay_ && dem_needs_fluid(dem_);
}


// Iterations of a steady solver have no time step in which the mesh could move
void Foam::demCloud::checkMesh() const
{
    if (mesh_.moving() && interval_ > 0)
    {
        FatalErrorInFunction
            << "The mesh moves, but this solver is steady (ddtSchemes) and its"
            << " iterations have no time step; take a transient solver, or"
            << " dynamicFvMesh staticFvMesh in constant/dynamicMeshDict"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demCloud::evolve
(
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho,
    const volScalarField& mu
)
{
    profile_.end(demProfile::FLUID);
    profile_.countStep();
    window_ = interval_ > 0 ? interval_ : mesh_.time().deltaTValue();
    offset_ =
        interval_ > 0
      ? 0
      : mesh_.time().value() - mesh_.time().deltaTValue() - lastTotals_.time;

    checkMesh();
    checkClosedWalls(U);
    if (!trial_)
    {
        backup();
    }
    passInletsOutlets(U);

    if (!particlesFirst_ && (!twoWay_ || interval_ > 0))     // else in correct()
    {
        updateAcceleration(U);
    }

    // With the weights of the mesh at which the particles were located
    setFluid(U, gradP, rho, mu);
    withoutFactors_ = false;
    gradP_ = gradP;
    if (mesh_.moving())
    {
        walls_.move(dem_);
    }
    profile_.end(demProfile::SAMPLE);

    progress_.begin(lastTotals_, window_);
    if (dem_advance(dem_, window_))
    {
        fail(string(dem_error_text()));
    }
    profile_.end(demProfile::PARTICLES);

    locate();
    depositVolume();
    depositReaction();
    updateRates();
    profile_.end(demProfile::DEPOSIT);
    if (trial_)
    {
        refresh();
        demCheck(dem_totals(dem_, &lastTotals_));
        return;
    }
    report();
    flowTable_.report(dem_, false, particleTime());
    losses_.report(dem_, offset_);
    bonds_.report(dem_, offset_);
    refresh();
    budgetParticles();
    record_.add(dem_, view_, window_);
    if (budget_.on())
    {
        onWalls_ = wallImpulse();       // the record may have reset its sums
    }
    fields_.update(dem_, transfer_, view_);
    profile_.end(demProfile::OUTPUT);
}

// ************************************************************************* //
