/*---------------------------------------------------------------------------*\
    demCloudExchange.C -- what the particles are told, and what they bring back.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demCheck.H"
#include "demColumns.H"
#include "gaussGrad.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// The core's columns: its pointers hold until its next collective call
void Foam::demCloud::refresh()
{
    dem_view(dem_, &view_);
    demCheck(dem_fluid(dem_, &fluid_));
}


// Every particle's cell. To be called whenever the core may have moved
// particles or handed them to other ranks.
void Foam::demCloud::look()
{
    setDiameter();
    refresh();

    if (!fluid_.place)
    {
        place_.setSize(2*view_.n);
        place_ = -1;
    }

    const demRoute::stray outside
    (
        transfer_.locate
        (
            view_,
            fluid_.place ? fluid_.place : place_.begin(),
            &flows_
        )
    );
    if (outside.count)
    {
        fail(outside);
    }
    refresh();
}


// The width of the kernel must not change while particles move: it would move
// volume. So the first particles set it, unless the user does.
void Foam::demCloud::setDiameter()
{
    if (diameter_ <= 0)
    {
        struct dem_tally now;
        demCheck(dem_tally(dem_, &now));

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


// At the particles; what is uniform needs no transfer
Foam::tmp<Foam::scalarField> Foam::demCloud::values
(
    const volScalarField& field
) const
{
    const scalar most = gMax(field.primitiveField());

    if (most > gMin(field.primitiveField()))
    {
        return transfer_.sample(field);
    }
    return tmp<scalarField>(new scalarField(view_.n, most));
}


void Foam::demCloud::tellParticles
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
    if (form_.wholeDrag())
    {
        const vectorField hydrostatic(values(rho)()*gravity());
        toColumn(hydrostatic, fluid_.pressure_gradient);
    }
    else
    {
        toColumn(transfer_.sample(gradP)(), fluid_.pressure_gradient);
    }
    toColumn(transfer_.sample(voidFraction_)(), fluid_.void_fraction);
    toColumn(values(rho)(), fluid_.density);
    toColumn(values(mu)(), fluid_.viscosity);
    tellFlow(U, mu);

    // Particles lose their slip faster where the fluid makes room
    const bool counterflow = makesRoom_ && form_.returns();
    for (size_t i = 0; i < fluid_.n; i++)
    {
        fluid_.counterflow[i] =
            counterflow
          ? dem_fluid_counterflow(dem_, fluid_.void_fraction[i])
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
    scalarField V(volumes(view_));
    if (flows_.active())
    {
        flows_.share(transfer_.seen(view_), V);
    }
    deposited_ = transfer_.share()*gSum(V);
    transfer_.depositVolume(V, solid);

    voidFraction_.primitiveFieldRef() = 1 - solid.field();
    voidFraction_.correctBoundaryConditions();

    if (twoWay_)
    {
        // From the void fractions, so that it agrees with their ddt. Of a cell
        // that grows: what it makes room for, per its volume now
        if (mesh_.moving())
        {
            old *= mesh_.V0().field()/mesh_.V().field();
        }
        dsdt_.primitiveFieldRef() =
            (old - voidFraction_.primitiveField())/mesh_.time().deltaTValue();
    }
    if (makesRoom_ && window_ > 0)
    {
        depositFlux(V);
    }
}


// Before the particles move: who is in the step is in all of it
void Foam::demCloud::letThrough(const volVectorField& U)
{
    unlike_.clear();

    if (flows_.pass(dem_, U))
    {
        look();

        if (makesRoom_)
        {
            scalarField V(volumes(view_));
            scalarField now;
            flows_.share(transfer_.seen(view_), V);
            transfer_.deposit(V, now);
            markUnlike(now, 1 - voidFraction_.primitiveField());
        }
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
            form_.how(),
            window_,
            response.begin(),
            reinterpret_cast<scalar*>(reaction.begin())
        )
    );

    transfer_.deposit(response, drag_.ref());
    transfer_.deposit(reaction, force_.ref());
    drag_.correctBoundaryConditions();
    force_.correctBoundaryConditions();

    if (makesRoom_ && form_.returns() && !form_.wholeDrag())
    {
        scalarField yields(volumes(view_));
        forAll(yields, i)
        {
            yields[i] *= fluid_.passed[i];
        }

        transfer_.deposit(yields, yielding_.ref());
        yielding_.correctBoundaryConditions();
    }
}


// What bounds the next step: the void fraction's change, and the rate at which
// drag takes up slip, 1/tau, on the mean over this one
void Foam::demCloud::rates()
{
    changeRate_ = max(gMax(dsdt_.primitiveField()), -gMin(dsdt_.primitiveField()));

    relaxationRate_ =
        returnReduce(dem_fluid_relaxation(dem_), maxOp<scalar>());
}


bool Foam::demCloud::reacts() const
{
    return twoWay_ && dem_needs_fluid(dem_);
}


// Mean section of the mesh across gravity, which a bed stands on [m2]
Foam::scalar Foam::demCloud::crossSection() const
{
    const scalar g = mag(gravity());
    const scalar height =
        g > 0 ? mag(mesh_.bounds().span() & gravity())/g : 0;

    return height > 0 ? gSum(mesh_.V().field())/height/transfer_.share() : 0;
}


// Iterations take no time to move in
void Foam::demCloud::checkMesh() const
{
    if (mesh_.moving() && interval_ > 0)
    {
        FatalErrorInFunction
            << "The mesh moves, but this solver is steady (ddtSchemes) and its"
            << " iterations take no time; take a transient solver, or"
            << " dynamicFvMesh staticFvMesh in constant/dynamicMeshDict"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demCloud::plan
(
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho,
    const volScalarField& mu,
    const string& why
)
{
    const Time& time = mesh_.time();
    const char* text = nullptr;

    struct dem_prospect ahead;
    ahead.window = interval_ > 0 ? interval_ : time.deltaTValue();
    ahead.duration =
        (time.endTime().value() - time.value())/time.deltaTValue()*ahead.window;
    ahead.why = why.c_str();
    ahead.cross_section = crossSection();
    ahead.volume = gSum(mesh_.V().field())/transfer_.share();
    ahead.cell = cbrt(gMin(mesh_.V().field()));
    ahead.speed = gMax(mag(U.primitiveField()));

    // By a scheme of its own: a case may name none for the gradient of U
    const volTensorField gradU(fv::gaussGrad<vector>(mesh_).calcGrad(U, "dem:gradU"));
    ahead.vorticity = 2*gMax(mag(skew(gradU.primitiveField()))()/sqrt(scalar(2)));
    ahead.one_way = !twoWay_;

    tellParticles(U, gradP, rho, mu);
    demCheck(dem_plan(dem_, &ahead, &text));
    Info<< nl << text << endl;
}


void Foam::demCloud::evolve
(
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho,
    const volScalarField& mu
)
{
    ledger_.charge(demLedger::FLUID);
    window_ = interval_ > 0 ? interval_ : mesh_.time().deltaTValue();
    offset_ =
        interval_ > 0
      ? 0
      : mesh_.time().value() - mesh_.time().deltaTValue() - before_.time;

    checkMesh();
    keep();
    letThrough(U);

    if (!first_ && (!twoWay_ || interval_ > 0))     // else in correct()
    {
        accelerate(U);
    }

    // By the weights of the mesh as it was when the particles were found
    tellParticles(U, gradP, rho, mu);
    gradP_ = gradP;
    if (mesh_.moving())
    {
        walls_.move(dem_);
    }
    ledger_.charge(demLedger::EXCHANGE);

    if (dem_advance(dem_, window_))
    {
        fail(string(dem_error_text()));
    }
    ledger_.charge(demLedger::PARTICLES);

    look();
    depositVolume();
    depositReaction();
    rates();
    report();
    passed_.tell(dem_, false);
    losses_.tell(dem_, offset_);
    bonds_.tell(dem_, offset_);
    refresh();
    bookParticles();
    record_.add(dem_, view_, window_);
    if (budget_.on())
    {
        onWalls_ = wallImpulse();       // the record may have begun anew
    }
    fields_.update(dem_, transfer_, view_);
    ledger_.charge(demLedger::EXCHANGE);
}

// ************************************************************************* //
