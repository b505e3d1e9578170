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

    Info<< "Suna: exchange error "
        << ledger_.exchange
           (
               window_,
               force_ - drag_*U - yielding_*change,
               fluid_,
               velocity,
               makesRoom_ ? volumes(view_)*gradient : 0*gradient
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
            << " in " << relief.crowded() << " cells, smoothed further in "
            << relief.passes() << " passes: particles are too soft, or cells"
            << " too small for the kernel's width" << endl;
    }

    before_ = now;
}


void Foam::demCloud::reportMomentum
(
    const vector& fluid,
    const vector& alsoOwed
)
{
    struct dem_tally now;
    demCheck(dem_tally(dem_, &now));
    refresh();

    const vector particles(now.momentum[0], now.momentum[1], now.momentum[2]);
    const vector owed(demLedger::owed(fluid_) + alsoOwed);

    Info<< "Suna: momentum fluid " << fluid << " particles " << particles
        << " owed " << owed << " sum " << fluid + particles + owed << endl;
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
