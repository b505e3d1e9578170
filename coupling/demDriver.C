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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// A running mean must go on after a restart
static IOobject meanField(const fvMesh& mesh, const word& name, const bool kept)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        kept ? IOobject::READ_IF_PRESENT : IOobject::NO_READ,
        kept ? IOobject::AUTO_WRITE : IOobject::NO_WRITE
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// Walls that have moved on without the particles would pass through them
void Foam::demDriver::refuseRest() const
{
    const Time& time = mesh_.time();

    if (time.timeIndex() > time.startTimeIndex() + 1)
    {
        FatalErrorInFunction
            << "The mesh moves, but the particles have stood still until now;"
            << " let them move from the start, without timeStart"
            << exit(FatalError);
    }
}


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
        steady_ ? "interval of coupling"
      : adjusts ? "the solver's adjustTimeStep" : "deltaT of controlDict"
    );
}


void Foam::demDriver::step()
{
    if (moved_ == mesh_.time().timeIndex())
    {
        return;
    }

    // OpenFOAM tells function objects nothing of a mesh while they rest
    if (mesh_.topoChanging() || mesh_.nCells() != cells_)
    {
        refuseChange();
    }
    if (moved_ < 0 && mesh_.moving())
    {
        refuseRest();
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

    if (!steady_)
    {
        force_ = cloud_.force() + cloud_.pressureReaction();
        return;
    }

    const volVectorField now(cloud_.force() + cloud_.pressureReaction());
    given_ = total(now, cloud_.drag());
    force_ += relaxation_*(now - force_);
    drag_ += relaxation_*(cloud_.drag() - drag_);
}


Foam::vector Foam::demDriver::total
(
    const volVectorField& F,
    const volScalarField& K
) const
{
    const vectorField& f = F;
    const scalarField& k = K;
    const vectorField& u = fluid_.velocity();
    return gSum((mesh_.V().field()*(f - k*u))());
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
    steady_(demFluid::steady(mesh)),
    cells_(mesh.nCells()),
    moved_(-1),
    from_(-VGREAT),
    until_(VGREAT),
    relaxation_(cloud_.dict().coupling().getOrDefault<scalar>("relaxation", 0.1)),
    force_(meanField(mesh, "particleForce", steady_), cloud_.force()),
    drag_(meanField(mesh, "particleDrag", steady_), cloud_.drag()),
    given_(Zero)
{
    if (relaxation_ <= 0 || relaxation_ > 1)
    {
        FatalIOErrorInFunction(cloud_.dict().coupling())
            << "relaxation is " << relaxation_ << "; it must be above 0 and at"
            << " most 1" << exit(FatalIOError);
    }
    force_.note() = drag_.note() = cloud_.heading();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demDriver::refuseChange() const
{
    FatalErrorInFunction
        << "The mesh changes, but the particles' cells and walls are those"
        << " of a mesh that keeps its faces: it may move, but not be refined or"
        << " cut anew; take another dynamicFvMesh in constant/dynamicMeshDict,"
        << " or leave the particles out" << exit(FatalError);
}


void Foam::demDriver::meshMoves() const
{
    if (moved_ == mesh_.time().timeIndex())
    {
        FatalErrorInFunction
            << "The mesh moves again in a step in which the particles have gone"
            << " along already; take moveMeshOuterCorrectors out of PIMPLE in"
            << " system/fvSolution" << exit(FatalError);
    }
}


bool Foam::demDriver::active() const
{
    const Time& time = mesh_.time();
    const scalar half = 0.5*time.deltaTValue();

    // as functionObjects::timeControl
    return time.value() >= from_ - half && time.value() <= until_ + half;
}


const Foam::volVectorField& Foam::demDriver::force()
{
    step();
    return force_;
}


const Foam::volScalarField& Foam::demDriver::drag()
{
    step();
    return steady_ ? drag_ : cloud_.drag();
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

        if (steady_)
        {
            Info<< "Suna: particles give " << given_ << " N, the fluid gets "
                << total(force_, drag_) << " N" << endl;
        }
        else
        {
            cloud_.correct(fluid_.velocity(), fluid_.density()());
        }
    }
    else
    {
        step();
    }
}

// ************************************************************************* //
