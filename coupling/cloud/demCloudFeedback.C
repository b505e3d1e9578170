/*---------------------------------------------------------------------------*\
    demCloudFeedback.C -- after the fluid is solved: the deferred correction of the
    particles (algebra: demCloudExchange.C), the momentum balance, the budget.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demCheck.H"
#include "demColumns.H"
#include "demInteger.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// With the pressure gradient that the particles feel in the next step, so that
// fluid and particles respond to the same change of it
void Foam::demCloud::returnImpulse
(
    const volVectorField& U,
    const volVectorField& gradP
)
{
    const volVectorField change(gradP - gradP_);
    const bool relaxed = demUnderRelaxation::active(fluid_);
    vectorField velocity(view_.n);
    vectorField gradient(view_.n, Zero);    // its change at the particles
    vectorField reached(relaxed ? view_.n : 0);

    if (scheme_.isDeferred())
    {
        velocity = transfer_.sample(U);
        if (relaxed)
        {
            reached = transfer_.sample(gradP);
            gradient = underRelaxation().next(reached);
            forAll(gradient, i)
            {
                gradient[i] -= vectorAt(fluid_.pressure_gradient, i);
            }
        }
        else if (!scheme_.wholeDrag())
        {
            gradient = transfer_.sample(change);
        }
    }
    else
    {
        // The velocity of before: no impulse is carried over
        forAll(velocity, i)
        {
            velocity[i] = vectorAt(fluid_.velocity, i);
        }
    }

    const volVectorField onFluid(force_ - drag_*U - pressureResponse_*change);
    budgetExchange(U, onFluid);

    Info<< "Suna: exchange error "
        << balance_.exchange
           (
               window_,
               onFluid,
               fluid_,
               velocity,
               volumeAveraged_ ? volumes(view_)*gradient : 0*gradient,
               transfer_.fraction(),
               transfer_.toFullCircle()
           )
        << endl;

    forAll(gradient, i)
    {
        gradient[i] += vectorAt(fluid_.pressure_gradient, i);
    }

    refresh();
    demCheck
    (
        dem_fluid_correct
        (
            dem_,
            reinterpret_cast<const double*>(velocity.cdata()),
            reinterpret_cast<const double*>(gradient.cdata())
        )
    );
    if (relaxed)
    {
        demUnderRelaxation relaxation(underRelaxation());
        relaxation.finish(reached);
        if (fluid_.acceleration)
        {
            relaxation.relaxAcceleration(transfer_.sample(acceleration_())());
        }
    }
}


void Foam::demCloud::report()
{
    struct dem_totals now;
    demCheck(dem_totals(dem_, &now));

    const scalarField& e = voidFraction_;
    const demOverpackingLimiter& limiter = transfer_.limiter();
    const scalar solid = gSum(mesh_.V().field()*(1 - e));

    Info<< "Suna: " << demInteger(now.particles).c_str() << " particles, "
        << demInteger(now.steps - lastTotals_.steps).c_str() << " DEM steps, void fraction at least "
        << gMin(e) << ", overlap at most " << now.largest_overlap
        << " diameters, volume error " << mag(solid - deposited_)/(deposited_ + VSMALL)
        << endl;

    if (limiter.nOverfull())
    {
        Info<< "Suna: void fraction below " << transfer_.minVoidFraction()
            << " in " << limiter.nOverfull() << " cells; solid was moved to their"
            << " neighbours, " << limiter.nFull() << " cells are at this limit now,"
            << " minimum " << gMin(e) << "; particles are too soft, or cells too"
            << " small for the kernel's width" << endl;
    }

    progress_.end(now.steps - lastTotals_.steps);
    edits_.report();
    lastTotals_ = now;
    warnOfImpacts(now.largest_overlap);
}


// Impulse of the particles on all walls since the record reset it [N s]
Foam::vector Foam::demCloud::wallImpulse()
{
    vector sum(Zero);

    for (int wall = 0; wall < dem_wall_count(dem_); wall++)
    {
        double impulse[3], twist[3];
        demCheck(dem_wall_impulse(dem_, wall, impulse, twist));
        sum += vector(impulse[0], impulse[1], impulse[2]);
    }
    return sum;
}


// Impulses of weight, walls and held particles in this step, and the particles'
// states; called while the columns still hold the fluid of this step
void Foam::demCloud::budgetParticles()
{
    if (!budget_.on())
    {
        return;
    }

    struct dem_totals now;
    demCheck(dem_totals(dem_, &now));
    refresh();

    const scalarField V(volumes(view_));
    vector weight(Zero);
    vector held(Zero);
    scalar height = 0;

    forAll(V, i)
    {
        const scalar m = *dem_at(view_.mass, view_.stride, i);
        const double* x = dem_at(view_.position, view_.stride, i);
        const uint16_t flags =
            *reinterpret_cast<const uint16_t*>
            (
                reinterpret_cast<const char*>(view_.flags) + view_.stride*i
            );
        const vector displaced
        (
            reacts() ? fluid_.density[i]*V[i]*gravity() : vector::zero
        );

        if (flags & 1)
        {
            if (reacts())
            {
                held +=
                    impulse(fluid_, i) + vectorAt(fluid_.carried_over_impulse, i)
                  - window_*(V[i]*vectorAt(fluid_.pressure_gradient, i) - displaced);
            }
        }
        else
        {
            const vector w(m*gravity() - displaced);
            weight += window_*w;
            height -= w & vector(x[0], x[1], x[2]);
        }
    }

    reduce(weight, sumOp<vector>());
    reduce(held, sumOp<vector>());
    reduce(height, sumOp<scalar>());

    budget_.gain("weight", weight);
    budget_.gain("held", -held);
    budget_.gain("walls", onWalls_ - wallImpulse());
    budget_.state(demBudget::MASS, "particles", now.mass);
    budget_.state(demBudget::ENERGY, "particles", now.kinetic);
    budget_.state(demBudget::ENERGY, "height", height);
}


// Impulse on the fluid, and energy that the exchange takes from both phases
void Foam::demCloud::budgetExchange
(
    const volVectorField& U,
    const volVectorField& onFluid
)
{
    if (!budget_.on())
    {
        return;
    }

    const scalarField& V = mesh_.V();
    const vectorField& f = onFluid;
    const vectorField& u = U;
    scalar work = 0;

    for (size_t i = 0; i < view_.n; i++)
    {
        work += impulse(fluid_, i) & velocity(view_, i);
    }

    toFluid_ = window_*gSum((V*f)());
    budget_.gain
    (
        demBudget::ENERGY,
        "drag",
        window_*gSum((V*(f & u))()) + returnReduce(work, sumOp<scalar>())
    );

    if (scheme_.set() == demCouplingScheme::I)
    {
        const vectorField p(pressureReaction());
        toFluid_ += window_*gSum((V*p)());
    }
}


void Foam::demCloud::reportMomentum
(
    const vector& ofMesh,
    const vector& moreOwed
)
{
    struct dem_totals now;
    demCheck(dem_totals(dem_, &now));
    refresh();

    const vector fluid(transfer_.toFullCircle() & ofMesh);
    const vector particles(now.momentum[0], now.momentum[1], now.momentum[2]);
    const vector owed(demMomentumBalance::owed(fluid_) + moreOwed);

    Info<< "Suna: momentum fluid " << fluid << " particles " << particles
        << " owed " << owed << " sum " << fluid + particles + owed << " N s" << endl;

    if (budget_.on())
    {
        budget_.state("fluid", fluid);
        budget_.state("particles", particles);
        budget_.state("owed", owed);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demCloud::correct
(
    const volVectorField& U,
    const volVectorField& gradP
)
{
    updateAcceleration(U);

    if (reacts())
    {
        profile_.end(demProfile::FLUID);
        returnImpulse(U, gradP);

        // In set II the pressure gradient drives the fluid in this step and the
        // particles in the next: their fraction of it is carried over, too
        vector owed(Zero);
        if (scheme_.set() == demCouplingScheme::II)
        {
            const vectorField dynamic
            (
                transfer_.sample(gradP)() - density()*gravity()
            );
            owed -= window_*gSum((volumes(view_)*dynamic)());
            toFluid_ -= owed;
            if (demUnderRelaxation::active(fluid_))
            {
                owed = underRelaxation().owed();
            }
        }

        const vectorField& u = U;
        const scalarField& e = voidFraction_;
        reportMomentum(density()*gSum((mesh_.V().field()*e*u)()), owed);
        profile_.end(demProfile::CORRECT);
    }
}


void Foam::demCloud::correct
(
    const volVectorField& U,
    const volScalarField& rho
)
{
    updateAcceleration(U);

    if (reacts())
    {
        profile_.end(demProfile::FLUID);
        returnImpulse(U, gradP_);

        const vectorField& u = U;
        const scalarField& density = rho;
        reportMomentum(gSum((mesh_.V().field()*density*u)()), vector::zero);
        profile_.end(demProfile::CORRECT);
    }
}


Foam::tmp<Foam::volVectorField> Foam::demCloud::pressureReaction() const
{
    tmp<volVectorField> treaction
    (
        new volVectorField("dem:pressureReaction", 0*force_)
    );

    const bool felt =
        !dict_.effectWith(DEM_TRAIT_PRESSURE_GRADIENT).empty();

    if (reacts() && felt)
    {
        const scalarField V(volumes(view_));
        vectorField force(view_.n);

        forAll(force, i)
        {
            force[i] =
                V[i]
               *(
                    vectorAt(fluid_.pressure_gradient, i)
                  - fluid_.density[i]*gravity()
                );
        }

        transfer_.deposit(force, treaction.ref().ref());
        treaction.ref().correctBoundaryConditions();
    }

    return treaction;
}

// ************************************************************************* //
