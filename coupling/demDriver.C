/*---------------------------------------------------------------------------*\
    demDriver.C -- moves a demCloud in a solver that knows nothing of it.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demDriver.H"
#include "Time.H"

namespace Foam
{
    defineTypeNameAndDebug(demDriver, 0);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demDriver::tellPlan()
{
    const Time& time = mesh_.time();
    const bool adjusts =
        time.controlDict().lookupOrDefault<Switch>("adjustTimeStep", false);

    cloud_.plan
    (
        fluid_.velocity(),
        fluid_.pressureGradient()(),
        fluid_.density()(),
        fluid_.viscosity()(),
        adjusts ? "the solver's adjustTimeStep" : "deltaT of controlDict"
    );
}


void Foam::demDriver::step()
{
    if (moved_ == mesh_.time().timeIndex())
    {
        return;
    }
    if (moved_ < 0)
    {
        tellPlan();
    }
    moved_ = mesh_.time().timeIndex();

    cloud_.evolve
    (
        fluid_.velocity(),
        fluid_.pressureGradient()(),
        fluid_.density()(),
        fluid_.viscosity()()
    );

    force_ = cloud_.force() + cloud_.pressureReaction();
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demDriver::demDriver(const fvMesh& mesh)
:
    regIOobject
    (
        IOobject
        (
            typeName,
            mesh.time().constant(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    mesh_(mesh),
    cloud_(mesh, false),
    fluid_(mesh, cloud_),
    moved_(-1),
    force_("dem:wholeForce", cloud_.force())
{
    const word ddt
    (
        mesh.schemesDict().subOrEmptyDict("ddtSchemes")
       .lookupOrDefault<word>("default", "none")
    );

    if (ddt == "steadyState")
    {
        FatalErrorInFunction
            << "ddtSchemes default is steadyState, but particles move in time:"
            << " an iteration of " << mesh.time().deltaTValue() << " s is no"
            << " time step. Take a transient solver, pimpleFoam for example"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::volVectorField& Foam::demDriver::force()
{
    step();
    return force_;
}


const Foam::volScalarField& Foam::demDriver::drag()
{
    step();
    return cloud_.drag();
}


void Foam::demDriver::finish()
{
    if (cloud_.twoWay())
    {
        if (moved_ != mesh_.time().timeIndex())
        {
            FatalErrorInFunction
                << "The solver has not asked for the particles' force in this"
                << " time step: it does not call fvOptions for U (icoFoam, for"
                << " one, does not), or demMomentumSource is switched off."
                << " Take a solver that does, pimpleFoam for example, or set"
                << " twoWay no; in coupling of constant/" << demDict::name()
                << exit(FatalError);
        }
        cloud_.correct(fluid_.velocity());
    }
    else
    {
        step();
    }
}

// ************************************************************************* //
