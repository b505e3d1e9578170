/*---------------------------------------------------------------------------*\
    demExchange.C -- the exchange of momentum between fluid and particles.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demExchange.H"
#include "demCheck.H"
#include "demColumns.H"
#include "demFiles.H"
#include "demReaction.H"
#include "demSelfCheck.H"
#include "demSnapshot.H"
#include "demTurbulenceProduction.H"

Foam::demUnderRelaxation Foam::demExchange::underRelaxation() const
{
    return demUnderRelaxation
    (
        fluid_,
        volumes(view_),
        particles_.gravity(),
        particles_.window(),
        scheme_.set() == demCouplingScheme::II
    );
}


// With the hydrostatic part of the density that the particles have in this step, also when
// they have moved in a density that varies
Foam::tmp<Foam::vectorField> Foam::demExchange::sampleGradient(const volVectorField& gradP) const
{
    tmp<vectorField> tgradient(transfer_.sample(gradP));
    vectorField& gradient = tgradient.ref();
    const scalarField rho(particles_.sample(rho_()));

    forAll(gradient, i)
    {
        gradient[i] += (fluid_.density[i] - rho[i])*particles_.gravity();
    }
    return tgradient;
}


// Logged once, if the particles would oscillate without it, and again whenever it falls
void Foam::demExchange::reportRelaxation()
{
    const scalar factor =
        returnReduce(scalar(dem_fluid_under_relax(particles_.core())), minOp<scalar>());

    if (factor < 0.9*toldRelaxation_)
    {
        toldRelaxation_ = factor;
        Info<< "Suna: under-relaxation of the pressure gradient and of Du/Dt down"
            << " to " << factor << " at light particles in a dense suspension,"
            << " which would oscillate from step to step; they feel a change of"
            << " it " << 1/factor << " steps late" << endl;
    }
}


// Y; `reaction` receives the explicit part of an under-relaxed gradient
void Foam::demExchange::depositPressureResponse(vectorField& reaction)
{
    scalarField volumeResponse(volumes(view_));     // q_i V_i
    forAll(volumeResponse, i)
    {
        volumeResponse[i] *= fluid_.transmitted_fraction[i];
    }
    if (demUnderRelaxation::active(fluid_))
    {
        reportRelaxation();
        const demUnderRelaxation relaxation(underRelaxation());
        relaxation.response(volumeResponse);
        reaction += relaxation.explicitForce(sampleGradient(gradP_)());
    }

    transfer_.deposit(volumeResponse, pressureResponse_.ref());
    pressureResponse_.correctBoundaryConditions();
}


Foam::demExchange::demExchange
(
    demParticles& particles,
    const demVoidFraction& volume,
    const bool volumeAveraged
)
:
    particles_(particles),
    volume_(volume),
    view_(particles.view()),
    fluid_(particles.fluid()),
    transfer_(particles.transfer()),
    scheme_(particles.dict(), volumeAveraged),
    quantities_(particles),
    ownWake_(particles),
    force_
    (
        demFieldAt(particles.mesh(), "dem:force"),
        particles.mesh(),
        dimensionedVector(dimForce/dimVolume, Zero)
    ),
    drag_
    (
        demFieldAt(particles.mesh(), "dem:drag"),
        particles.mesh(),
        dimensionedScalar(dimDensity/dimTime, Zero)
    ),
    pressureResponse_
    (
        demFieldAt(particles.mesh(), "dem:pressureResponse"),
        particles.mesh(),
        dimensionedScalar(dimless, Zero)
    ),
    gradP_
    (
        demFieldAt(particles.mesh(), "dem:gradP"),
        particles.mesh(),
        dimensionedVector(dimPressure/dimLength, Zero)
    ),
    relaxationRate_(demSnapshot::readNumber(particles.mesh().time(), "relaxationRate")),
    withoutFactors_(false),
    toldRelaxation_(0.5)
{}


void Foam::demExchange::prepare()
{
    if (particles_.displaceFluid() && !scheme_.wholeDrag())
    {
        dem_case_fluid_displaced(particles_.described(), particles_.densestFluid());
    }
    ownWake_.prepare(scheme_.wholeDrag());
}


void Foam::demExchange::begin()
{
    withoutFactors_ =
        demSnapshot::exists(particles_.mesh().time())
     && demUnderRelaxation::withoutFactors(fluid_);

    if (fluid_.own_wake)
    {
        particles_.transfer().keepOwnWeights();
    }
    if (demCapillaryForce::needed(fluid_))
    {
        capillary_.reset(new demCapillaryForce(particles_));
    }
    if (particles_.displaceFluid() && particles_.needsFluid())
    {
        scheme_.checkEffects();
        dem_fluid_whole_drag(particles_.core(), scheme_.wholeDrag());
    }
}


void Foam::demExchange::setDensity(const volScalarField& rho)
{
    rho_.reset(new volScalarField("dem:rho", rho));
}


void Foam::demExchange::toParticles(const demFlow& flow)
{
    gradP_.ref() = flow.gradP();
    if (!particles_.needsFluid())
    {
        return;
    }

    toColumn(transfer_.sample(flow.U)(), fluid_.velocity);
    const scalarField rho(particles_.sample(flow.rho));
    toColumn(rho, fluid_.density);
    if (scheme_.wholeDrag())
    {
        toColumn(vectorField(rho*particles_.gravity()), fluid_.pressure_gradient);
    }
    else if (demUnderRelaxation::active(fluid_))
    {
        underRelaxation().begin(transfer_.sample(flow.gradP)(), withoutFactors_);
    }
    else
    {
        toColumn(transfer_.sample(flow.gradP)(), fluid_.pressure_gradient);
    }
    toColumn(transfer_.sample(volume_.voidFraction())(), fluid_.void_fraction);
    toColumn(particles_.sample(flow.mu)(), fluid_.viscosity);
    quantities_.set(flow.U, flow.mu);
    if (capillary_)
    {
        capillary_().toParticles();
    }

    for (size_t i = 0; i < fluid_.n; i++)
    {
        fluid_.slip_factor[i] =
            particles_.displaceFluid()
          ? dem_fluid_slip_factor(particles_.core(), fluid_.void_fraction[i])
          : 1;
    }
    ownWake_.toParticles(volume_.voidFractionForFluid());
}


void Foam::demExchange::toFluid(const demFlow& flow)
{
    withoutFactors_ = false;

    if (particles_.react())
    {
        scalarField response(view_.n);
        vectorField reaction(view_.n);

        demCheck
        (
            dem_fluid_reaction
            (
                particles_.core(),
                particles_.window(),
                response.begin(),
                reinterpret_cast<scalar*>(reaction.begin())
            )
        );

        if (particles_.displaceFluid() && !scheme_.wholeDrag())
        {
            depositPressureResponse(reaction);
        }
        demTurbulenceProduction::deposit
        (
            particles_.mesh(), transfer_, fluid_, particles_.window()
        );

        scalarField following(response);
        dem_fluid_following(particles_.core(), following.begin());
        demReaction::deposit
        (
            transfer_, response, following, flow.U, reaction,
            force_.primitiveFieldRef(), drag_.primitiveFieldRef()
        );
        drag_.correctBoundaryConditions();
        force_.correctBoundaryConditions();
    }

    relaxationRate_ =
        returnReduce(dem_fluid_relaxation(particles_.core()), maxOp<scalar>());
}


Foam::tmp<Foam::volVectorField> Foam::demExchange::onFluid
(
    const volVectorField& U,
    const volVectorField& gradP
) const
{
    return force_ - drag_*U - pressureResponse_*(gradP - gradP_);
}


// With the pressure gradient that the particles feel in the next step, so that
// fluid and particles respond to the same change of it
void Foam::demExchange::correct
(
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho,
    const volVectorField& onFluid
)
{
    const bool relaxed = demUnderRelaxation::active(fluid_);
    const vectorField velocity(transfer_.sample(U));
    vectorField gradientChange(view_.n, Zero);
    vectorField reached(relaxed ? view_.n : 0);

    if (relaxed)
    {
        reached = sampleGradient(gradP);
        gradientChange = underRelaxation().next(reached);
        forAll(gradientChange, i)
        {
            gradientChange[i] -= vectorAt(fluid_.pressure_gradient, i);
        }
    }
    else if (!scheme_.wholeDrag())
    {
        gradientChange = transfer_.sample(volVectorField(gradP - gradP_));
    }

    const scalar error = balance_.update
    (
        particles_.window(),
        onFluid,
        fluid_,
        velocity,
        particles_.displaceFluid() ? volumes(view_)*gradientChange : 0*gradientChange,
        transfer_.fraction(),
        transfer_.toFullCircle()
    );
    Info<< "Suna: exchange error " << error << endl;
    demSelfCheck::momentum(balance_.ofLargestTerm());

    vectorField gradient(gradientChange);
    forAll(gradient, i)
    {
        gradient[i] += vectorAt(fluid_.pressure_gradient, i);
    }

    particles_.refresh();
    ownWake_.update(velocity);
    demCheck
    (
        dem_fluid_correct
        (
            particles_.core(),
            reinterpret_cast<const double*>(velocity.cdata()),
            reinterpret_cast<const double*>(gradient.cdata())
        )
    );
    if (relaxed)
    {
        demUnderRelaxation relaxation(underRelaxation());
        relaxation.finish(reached);
        relaxation.changeDensity(particles_.sample(rho)());
        if (fluid_.acceleration)
        {
            relaxation.relaxAcceleration(quantities_.sampleAcceleration()());
        }
    }
}


Foam::vector Foam::demExchange::pressureImpulse(const volVectorField& gradP) const
{
    if (scheme_.set() != demCouplingScheme::II)
    {
        return Zero;
    }
    const vectorField dynamic
    (
        transfer_.sample(gradP)() - particles_.sample(rho_())()*particles_.gravity()
    );
    return -particles_.window()*gSum((volumes(view_)*dynamic)());
}


Foam::vector Foam::demExchange::owedPressureImpulse(const vector& last) const
{
    return
        scheme_.set() == demCouplingScheme::II && demUnderRelaxation::active(fluid_)
      ? underRelaxation().owed()
      : last;
}


Foam::tmp<Foam::volVectorField> Foam::demExchange::pressureReaction() const
{
    tmp<volVectorField> treaction
    (
        new volVectorField("dem:pressureReaction", 0*force_)
    );

    const bool felt =
        !particles_.dict().effectWith(DEM_TRAIT_PRESSURE_GRADIENT).empty();

    if (particles_.react() && felt)
    {
        const scalarField V(volumes(view_));
        vectorField force(view_.n);

        forAll(force, i)
        {
            force[i] =
                V[i]
               *(
                    vectorAt(fluid_.pressure_gradient, i)
                  - fluid_.density[i]*particles_.gravity()
                );
        }

        transfer_.deposit(force, treaction.ref().ref());
        treaction.ref().correctBoundaryConditions();
    }

    return treaction;
}
