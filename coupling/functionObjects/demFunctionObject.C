/*---------------------------------------------------------------------------*\
    demFunctionObject.C -- particles in any solver as a function object.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFunctionObject.H"
#include "demEnergySource.H"
#include "demEntries.H"
#include "demFiles.H"
#include "demFluid.H"
#include "demMeshCheck.H"
#include "demMomentumSource.H"
#include "fvOptions.H"
#include "mapPolyMesh.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(demFunctionObject, 0);
    addToRunTimeSelectionTable(functionObject, demFunctionObject, dictionary);
}
}

namespace Foam
{

// Does the case have a file fvOptions? OpenFOAM reads such a list again when the
// file changes, and fails at a source that is not in the file.
static bool hasFile(const fvMesh& mesh)
{
    for (const word& folder : {mesh.time().constant(), mesh.time().system()})
    {
        IOobject io(demFileAt(folder, "fvOptions", mesh, IOobject::MUST_READ));

        if (io.typeHeaderOk<IOdictionary>(true))
        {
            return true;
        }
    }
    return false;
}


// Own entries, and those that OpenFOAM v1912 or later reads of any function object
static void checkEntries(const dictionary& dict)
{
    dictionary own(dict);
    own.remove("FoamFile");     // of a file that #includeFunc reads

    demCheckOwnEntries
    (
        own,
        "functions/" + dict.dictName(),
        wordList
        ({
            "type", "libs", "plan", "timeStart", "timeEnd", "enabled", "region", "log",
            "writeControl", "writeInterval", "executeControl", "executeInterval", "errors",
            "controlMode", "triggerStart", "triggerEnd", "deltaTCoeff", "nStepsToStartTimeChange",
            "outputControl", "outputInterval", "functionObjectLibs", "subRegion", "useNamePrefix"
        })
    );
}


// The particles must move in each time step
static void checkControl(const dictionary& dict)
{
    const bool each =
        dict.getOrDefault<word>("executeControl", "timeStep") == "timeStep"
     && dict.getOrDefault<scalar>("executeInterval", 1) == 1;

    if (!each || dict.found("triggerStart"))
    {
        FatalIOErrorInFunction(dict)
            << "functions/" << dict.dictName() << " in system/controlDict skips"
            << " time steps, but particles must move in each one. Take out"
            << " executeControl, executeInterval and triggerStart; timeStart and"
            << " timeEnd may stay"
            << exit(FatalIOError);
    }
}

} // End namespace Foam


template<class Source>
void Foam::functionObjects::demFunctionObject::addSource(const word& name)
{
    fv::optionList& sources = fv::options::New(mesh_);
    DynamicList<word> given;

    for (const fv::option& source : sources)
    {
        if (isA<Source>(source))
        {
            given.append(source.name());
        }
    }
    if (given.size() > 1)
    {
        FatalErrorInFunction
            << "fvOptions has " << given.size() << " sources of type " << Source::typeName << ' '
            << flatOutput(given) << ": the fluid would get the particles' reaction as many times;"
            << " keep one" << exit(FatalError);
    }
    if (given.size())
    {
        return;
    }

    if (hasFile(mesh_))
    {
        FatalErrorInFunction
            << "The coupling is two-way, and this case has its own file"
            << " fvOptions; add to it" << nl
            << "    " << name << " { type " << Source::typeName << ';'
            << " libs (\"libdemCoupling.so\"); }" << exit(FatalError);
    }

    dictionary dict;
    dict.add("type", Source::typeName);

    const label n = sources.size();
    sources.setSize(n + 1);
    sources.set(n, fv::option::New(name, dict, mesh_).ptr());
}


// OpenFOAM makes a function object anew when it is enabled again and when it gets a time
// control in a run: takes the particles over. False if there are none
bool Foam::functionObjects::demFunctionObject::takeOver()
{
    const demDriver* found = mesh_.findObject<demDriver>(demDriver::typeName);

    if (!found || (found->user() && found->user()->name() != name()))
    {
        return false;
    }
    demFunctionObject* before = found->user();

    if (before)
    {
        before->driver_.release();
        stop_ = std::move(before->stop_);
    }
    else
    {
        Info<< "Suna: functions/" << name() << " is enabled again: the particles move on"
            << endl;
    }
    driver_.reset(const_cast<demDriver*>(found));
    return true;
}


void Foam::functionObjects::demFunctionObject::refuseOtherRegion() const
{
    for (const word& other : time_.sortedNames<fvMesh>())
    {
        if (time_.lookupObject<fvMesh>(other).foundObject<demDriver>(demDriver::typeName))
        {
            FatalErrorInFunction
                << "functions/" << name() << " adds particles to region " << region_
                << ", but region " << other << " has some already, and their files have the same"
                << " names; a run has particles in one region" << exit(FatalError);
        }
    }
}


Foam::functionObjects::demFunctionObject::demFunctionObject
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    region_(mesh_.name()),
    timeStart_(-VGREAT),
    timeEnd_(VGREAT),
    ownTimes_
    (
        dict.found("writeControl")
     || dict.found("outputControl")
     || dict.found("writeInterval")
    )
{
    // Post-processing reads results and must not advance them
    if (postProcess)
    {
        Info<< "Suna: post-processing, the particles stay as they are" << endl;
        return;
    }

    // OpenFOAM turns an exception in this constructor into a warning and runs on
    // without particles, or hangs if only one rank fails. Here errors end the run.
    const bool throwing = FatalError.throwExceptions(false);
    const bool throwingIO = FatalIOError.throwExceptions(false);

    if (!takeOver())
    {
        if (mesh_.foundObject<volScalarField>("dem:drag"))
        {
            FatalErrorInFunction
                << "This solver or another function object has particles already;"
                << " take out " << name << exit(FatalError);
        }
        refuseOtherRegion();
        driver_.reset(new demDriver(mesh_));
    }
    driver_().begin(*this);
    read(dict);

    if (dict.getOrDefault("plan", false))
    {
        driver_().reportPlan();
        Info<< "End\n" << endl;
        UPstream::exit(0);
    }

    // Outside its own period it would not notice a signal
    if (dict.found("timeStart") || dict.found("timeEnd"))
    {
        stop_.clear();
    }
    else if (!stop_)
    {
        stop_.reset(new demStop(time_));
    }

    demFluid::checkGravity(mesh_, driver_().cloud().particles().gravity());

    // One-way, only a solver that takes sources has a list of them
    const bool twoWay = driver_().cloud().particles().twoWay();
    const fv::options* sources =
        twoWay
      ? &fv::options::New(mesh_)
      : mesh_.findObject<fv::options>(fv::options::typeName);

    if (sources)
    {
        demFluid::checkSources(*sources);
    }
    if (twoWay)
    {
        addSource<fv::demMomentumSource>(name);
        if (driver_().cloud().transfersHeat())
        {
            addSource<fv::demEnergySource>(name + "Heat");
        }
    }

    FatalIOError.throwExceptions(throwingIO);
    FatalError.throwExceptions(throwing);
}


Foam::functionObjects::demFunctionObject::~demFunctionObject()
{
    // At the end of a run the mesh goes first
    if (!driver_ || !time_.foundObject<fvMesh>(region_))
    {
        return;
    }

    // OpenFOAM deletes it before the end of the step that the solver has just made
    if (driver_().active() && !driver_().ended())
    {
        demFunctionObject::execute();
        demFunctionObject::write();
    }
    Info<< "Suna: functions/" << name() << " is disabled: the particles stand still and do not"
        << " act on the fluid" << endl;
    driver_().rest();
    driver_.release();
}


bool Foam::functionObjects::demFunctionObject::read(const dictionary& dict)
{
    if (driver_)
    {
        checkEntries(dict);
        checkControl(dict);

        // As functionObjects::timeControl: an entry that is taken out stays in force
        if (dict.readIfPresent("timeStart", timeStart_))
        {
            timeStart_ = time_.userTimeToTime(timeStart_);
        }
        if (dict.readIfPresent("timeEnd", timeEnd_))
        {
            timeEnd_ = time_.userTimeToTime(timeEnd_);
        }
        driver_().setActivePeriod(timeStart_, timeEnd_);
    }
    return fvMeshFunctionObject::read(dict);
}


bool Foam::functionObjects::demFunctionObject::execute()
{
    if (driver_)
    {
        driver_().endStep();
        if (stop_)
        {
            stop_().atStepEnd(time_);
        }
    }
    return true;
}


bool Foam::functionObjects::demFunctionObject::write()
{
    // Without a writeControl OpenFOAM calls this in every step
    if (driver_ && (ownTimes_ || time_.writeTime()))
    {
        driver_().cloud().write();
    }
    return true;
}


bool Foam::functionObjects::demFunctionObject::adjustTimeStep()
{
    if (driver_)
    {
        driver_().adjustStep();
    }
    return true;
}


void Foam::functionObjects::demFunctionObject::updateMesh
(
    const mapPolyMesh& map
)
{
    if (driver_ && &map.mesh() == &mesh_)
    {
        demMeshCheck::refuseTopologyChange();
    }
}


void Foam::functionObjects::demFunctionObject::movePoints(const polyMesh& mesh)
{
    if (driver_ && &mesh == &mesh_)
    {
        driver_().meshMoves();
    }
}
