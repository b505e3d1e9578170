/*---------------------------------------------------------------------------*\
    demCloudFeedback.C -- the fluid is solved: what the particles get of it, and the books.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demCheck.H"
#include "demColumns.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// `change` of the pressure gradient since evolve, on the mesh: so the fluid
// and the particles answer to one and the same field
void Foam::demCloud::settle
(
    const volVectorField& U,
    const volVectorField& change
)
{
    vectorField velocity(view_.n);
    vectorField gradient(view_.n, Zero);

    if (form_.returns())
    {
        velocity = transfer_.sample(U);
        if (!form_.wholeDrag())
        {
            gradient = transfer_.sample(change);
        }
    }
    else
    {
        // as it was: nothing is owed
        forAll(velocity, i)
        {
            velocity[i] = three(fluid_.velocity, i);
        }
    }

    const volVectorField onFluid(force_ - drag_*U - yielding_*change);
    bookExchange(U, onFluid);

    Info<< "Suna: exchange error "
        << ledger_.exchange
           (
               window_,
               onFluid,
               fluid_,
               velocity,
               makesRoom_ ? volumes(view_)*gradient : 0*gradient,
               transfer_.share(),
               transfer_.whole()
           )
        << endl;

    forAll(gradient, i)
    {
        gradient[i] += three(fluid_.pressure_gradient, i);
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
    ledger_.charge(demLedger::EXCHANGE);
}


void Foam::demCloud::report()
{
    struct dem_tally now;
    demCheck(dem_tally(dem_, &now));

    const scalarField& e = voidFraction_;
    const demRelief& relief = transfer_.relief();
    const scalar solid = gSum(mesh_.V().field()*(1 - e));

    Info<< "Suna: " << now.particles << " particles, "
        << now.steps - before_.steps << " DEM steps, void fraction at least "
        << gMin(e) << ", overlap at most " << now.largest_overlap
        << ", volume error " << mag(solid - deposited_)/(deposited_ + VSMALL)
        << endl;

    if (relief.crowded())
    {
        Info<< "Suna: void fraction below " << transfer_.minVoidFraction()
            << " in " << relief.crowded() << " cells, smoothed further into "
            << relief.full() << ", to " << gMin(e)
            << " at least: particles are too soft, or cells"
            << " too small for the kernel's width" << endl;
    }

    before_ = now;
}


// Of the particles on all walls since the record looked last
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


// What this step did to the particles from outside; called while the columns
// still hold what acted
void Foam::demCloud::bookParticles()
{
    if (!budget_.on())
    {
        return;
    }

    struct dem_tally now;
    demCheck(dem_tally(dem_, &now));
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
                    impulse(fluid_, i) + three(fluid_.pending, i)
                  - window_*(V[i]*three(fluid_.pressure_gradient, i) - displaced);
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


// The impulse on the fluid, and the power that drag takes from both
void Foam::demCloud::bookExchange
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

    if (form_.set() == demForm::I)
    {
        const vectorField p(pressureReaction());
        toFluid_ += window_*gSum((V*p)());
    }
}


void Foam::demCloud::reportMomentum
(
    const vector& ofMesh,
    const vector& alsoOwed
)
{
    struct dem_tally now;
    demCheck(dem_tally(dem_, &now));
    refresh();

    const vector fluid(transfer_.whole() & ofMesh);
    const vector particles(now.momentum[0], now.momentum[1], now.momentum[2]);
    const vector owed(demLedger::owed(fluid_) + alsoOwed);

    Info<< "Suna: momentum fluid " << fluid << " particles " << particles
        << " owed " << owed << " sum " << fluid + particles + owed << endl;

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
    accelerate(U);

    if (reacts())
    {
        ledger_.charge(demLedger::FLUID);
        settle(U, (gradP - gradP_)());

        // In set II the pressure gradient has moved the fluid in this step and
        // will move the particles in the next: their share is owed to them, too
        vector owed(Zero);
        if (form_.set() == demForm::II)
        {
            const vectorField dynamic
            (
                transfer_.sample(gradP)() - density()*gravity()
            );
            owed -= window_*gSum((volumes(view_)*dynamic)());
            toFluid_ -= owed;
        }

        const vectorField& u = U;
        const scalarField& e = voidFraction_;
        reportMomentum(density()*gSum((mesh_.V().field()*e*u)()), owed);
    }
}


void Foam::demCloud::correct
(
    const volVectorField& U,
    const volScalarField& rho
)
{
    accelerate(U);

    if (reacts())
    {
        ledger_.charge(demLedger::FLUID);
        settle(U, (0*gradP_)());

        const vectorField& u = U;
        const scalarField& density = rho;
        reportMomentum(gSum((mesh_.V().field()*density*u)()), vector::zero);
    }
}


Foam::tmp<Foam::volVectorField> Foam::demCloud::pressureReaction() const
{
    tmp<volVectorField> treaction
    (
        new volVectorField("dem:pressureReaction", 0*force_)
    );

    if (reacts() && dict_.acts("pressureGradient"))
    {
        const scalarField V(volumes(view_));
        vectorField force(view_.n);

        forAll(force, i)
        {
            force[i] =
                V[i]
               *(
                    three(fluid_.pressure_gradient, i)
                  - fluid_.density[i]*gravity()
                );
        }

        transfer_.deposit(force, treaction.ref().ref());
        treaction.ref().correctBoundaryConditions();
    }

    return treaction;
}

// ************************************************************************* //
