/*---------------------------------------------------------------------------*\
    demDriver.C -- runs a demCloud in a solver that has no equations for particles.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demDriver.H"
#include "demFiles.H"
#include "demMeshCheck.H"
#include "fvcSurfaceIntegrate.H"
#include "surfaceFields.H"
#include "Time.H"

namespace Foam
{
    defineTypeNameAndDebug(demDriver, 0);
}

namespace Foam
{

// A relaxed field is written, so that a restart continues with it
static IOobject relaxedField(const fvMesh& mesh, const word& name, const bool written)
{
    return
        written
      ? demFieldAt(mesh, name, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE)
      : demFieldAt(mesh, name);
}

} // End namespace Foam


// Walls that move while the particles stand still would pass through them
void Foam::demDriver::refuseLateStart() const
{
    const Time& time = mesh_.time();

    if (time.timeIndex() > time.startTimeIndex() + 1)
    {
        FatalErrorInFunction
            << "The mesh moves, but the particles have stood still until now;"
            << " let them move in all time steps, without timeStart"
            << exit(FatalError);
    }
}


void Foam::demDriver::reportPlan()
{
    const Time& time = mesh_.time();
    const bool adjusts =
        time.controlDict().lookupOrDefault<Switch>("adjustTimeStep", false);

    const string limit
    (
        steady_ ? "interval of coupling"
      : adjusts ? "the solver's adjustTimeStep" : "deltaT of controlDict"
    );

    cloud_.plan
    (
        {fluid_.velocity(), fluid_.pressureGradient()(), fluid_.density()(), fluid_.viscosity()()},
        {limit, 0, 0, word::null}
    );
}


// Largest Courant number of the fluid, 0 in a solver without a flux
Foam::scalar Foam::demDriver::courant() const
{
    const surfaceScalarField* phi = mesh_.findObject<surfaceScalarField>("phi");

    if (!phi)
    {
        return 0;
    }

    scalarField sum(fvc::surfaceSum(mag(*phi))().primitiveField());
    if (phi->dimensions() == dimMass/dimTime)
    {
        sum /= fluid_.density()().primitiveField();
    }
    return 0.5*gMax((sum/mesh_.V().field())())*mesh_.time().deltaTValue();
}


// The solver has chosen its step; one that is too long for the particles is reported.
// In a steady solver particles move by coupling/interval
void Foam::demDriver::checkStep()
{
    const dictionary& control = mesh_.time().controlDict();

    if (!steady_)
    {
        stepControl_.evaluate
        (
            control.lookupOrDefault<Switch>("adjustTimeStep", false),
            courant(),
            control.lookupOrDefault<scalar>("maxCo", 1)
        );
    }
}


void Foam::demDriver::evolve()
{
    if (heat_)
    {
        heat_->beginStep();
    }
    cloud_.evolve
    ({
        fluid_.velocity(), fluid_.pressureGradient()(), fluid_.density()(), fluid_.viscosity()()
    });
}


void Foam::demDriver::step()
{
    if (lastStep_ == mesh_.time().timeIndex())
    {
        return;
    }

    // OpenFOAM does not notify function objects of mesh changes before timeStart
    if (mesh_.topoChanging() || mesh_.nCells() != cells_)
    {
        demMeshCheck::refuseTopologyChange();
    }
    if (lastStep_ < mesh_.time().timeIndex() - 1 && mesh_.moving())
    {
        refuseLateStart();
    }

    if (lastStep_ < 0)
    {
        reportPlan();
    }
    lastStep_ = mesh_.time().timeIndex();
    checkStep();
    evolve();

    if (!steady_)
    {
        force_ = cloud_.exchange().force() + cloud_.exchange().pressureReaction();
        return;
    }

    const volVectorField now(cloud_.exchange().force() + cloud_.exchange().pressureReaction());
    exerted_ = total(now, cloud_.exchange().drag());
    force_ += relaxation_*(now - force_);
    drag_ += relaxation_*(cloud_.exchange().drag() - drag_);
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
    fluid_(mesh, cloud_.particles().dict()),
    stepControl_(mesh.time(), cloud_),
    steady_(demFluid::steady(mesh)),
    cells_(mesh.nCells()),
    lastStep_(-1),
    ended_(-1),
    without_(labelMax),
    adjusting_(false),
    user_(nullptr),
    from_(-VGREAT),
    until_(VGREAT),
    relaxation_(cloud_.particles().dict().coupling().getOrDefault<scalar>("relaxation", 0.1)),
    force_(relaxedField(mesh, "particleForce", steady_), cloud_.exchange().force()),
    drag_(relaxedField(mesh, "particleDrag", steady_), cloud_.exchange().drag()),
    exerted_(Zero)
{
    if (relaxation_ <= 0 || relaxation_ > 1)
    {
        FatalIOErrorInFunction(cloud_.particles().dict().coupling())
            << "relaxation is " << relaxation_ << "; it must be above 0 and at"
            << " most 1" << exit(FatalIOError);
    }
    force_.note() = drag_.note() = cloud_.particles().heading();

    if (cloud_.transfersHeat())
    {
        if (steady_)
        {
            FatalErrorInFunction
                << cloud_.heat().reason().c_str() << ", but this solver is steady"
                << " (ddtSchemes), and heat is exchanged over a time step; take a"
                << " transient solver, or leave the effect out" << exit(FatalError);
        }
        heat_.reset(new demThermoHeat(mesh, cloud_));
    }
}


Foam::demDriver& Foam::demDriver::of(const fvMesh& mesh, const word& source)
{
    const demDriver* found = mesh.findObject<demDriver>(typeName);

    if (!found)
    {
        FatalErrorInFunction
            << "There are no particles for source " << source << ": add to"
            << " functions in system/controlDict" << nl
            << "    particles { type demCloud; libs (\"libdemCoupling.so\"); }"
            << nl << "(demPimpleFoam has its own and needs neither.)"
            << exit(FatalError);
    }
    return const_cast<demDriver&>(*found);
}


void Foam::demDriver::begin(functionObjects::demFunctionObject& user)
{
    // OpenFOAM makes function objects between two steps and calls them for the step
    // before, in which the fluid did not feel these particles
    without_ = user_ ? without_ : mesh_.time().timeIndex();
    user_ = &user;
}


void Foam::demDriver::rest()
{
    without_ = labelMax;
    user_ = nullptr;
}


void Foam::demDriver::meshMoves() const
{
    if (lastStep_ == mesh_.time().timeIndex())
    {
        FatalErrorInFunction
            << "The mesh moves again in a step in which the particles have moved"
            << " already; take moveMeshOuterCorrectors out of PIMPLE in"
            << " system/fvSolution" << exit(FatalError);
    }
}


bool Foam::demDriver::inPeriod() const
{
    const Time& time = mesh_.time();
    const scalar half = 0.5*time.deltaTValue();

    // Same tolerance as functionObjects::timeControl
    return time.value() >= from_ - half && time.value() <= until_ + half;
}


bool Foam::demDriver::active() const
{
    return mesh_.time().timeIndex() > without_ && inPeriod();
}


void Foam::demDriver::adjustStep()
{
    if (adjusting_)
    {
        return;                 // called by setDeltaT below
    }

    Time& time = const_cast<Time&>(mesh_.time());
    word name;
    const scalar deltaT = time.deltaTValue();
    const scalar ratio = steady_ || !inPeriod() ? 0 : stepControl_.particleRatio(deltaT, name);

    if (ratio > 1)
    {
        // Time and function objects fit the shorter step to the next time that they write
        adjusting_ = true;
        time.setDeltaT(deltaT/ratio);
        adjusting_ = false;
        Info<< "Suna: time step limited by " << name << " to " << time.deltaTValue() << " s" << endl;
    }
}


const Foam::volVectorField& Foam::demDriver::force()
{
    step();
    return force_;
}


const Foam::volScalarField& Foam::demDriver::drag()
{
    step();
    return steady_ ? drag_ : cloud_.exchange().drag();
}


void Foam::demDriver::addHeat(const volScalarField& rho, fvMatrix<scalar>& eqn)
{
    step();
    if (heat_)
    {
        heat_->addTo(rho, eqn);
    }
}


void Foam::demDriver::endStep()
{
    if (ended() || mesh_.time().timeIndex() <= without_)
    {
        return;
    }
    ended_ = mesh_.time().timeIndex();

    if (cloud_.particles().twoWay())
    {
        if (lastStep_ != mesh_.time().timeIndex())
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
            Info<< "Suna: force of the particles " << exerted_ << " N, on the fluid "
                << total(force_, drag_) << " N" << endl;
        }
        else
        {
            cloud_.correct(fluid_.velocity(), fluid_.density()());
            if (heat_)
            {
                heat_->correct(fluid_.density()());
            }
        }
    }
    else
    {
        step();
    }
}
