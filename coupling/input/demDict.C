/*---------------------------------------------------------------------------*\
    demDict.C -- reads constant/demProperties, separates the settings of the coupling
    from the scene of the core.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demDict.H"
#include "dem_plan.h"
#include "demFiles.H"
#include "demCheck.H"
#include "demDomain.H"
#include "emptyPolyPatch.H"
#include "uniformDimensionedFields.H"
#include "OStringStream.H"
#include "DynamicList.H"
#include "Time.H"
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>

namespace Foam
{

// The fewest digits with which its numbers arrive with the same bits
static int digitsOf(const entry& e)
{
    int digits = 15;

    for (const token& t : e.stream())
    {
        char text[32];

        digits = t.isCompound() ? 17 : digits;
        while
        (
            t.isScalar() && digits < 17
         && (std::snprintf(text, sizeof text, "%.*g", digits, double(t.scalarToken())),
             std::strtod(text, nullptr) != double(t.scalarToken()))
        )
        {
            ++digits;
        }
    }
    return digits;
}


// Each entry is preceded by its line, so that messages of the core can name it
static void writeEntries(const dictionary& dict, OStringStream& os)
{
    forAllConstIters(dict, iter)
    {
        const entry& e = *iter;

        // Entries that were added by this class have no line
        if (e.startLineNumber() > 0)
        {
            os  << nl << "#line " << e.startLineNumber() << " \"constant/"
                << demDict::name().c_str() << "\"" << nl;
        }

        if (e.isDict())
        {
            os.writeKeyword(e.keyword());
            os  << nl << "{" << nl;
            writeEntries(e.dict(), os);
            os  << nl << "}" << nl;
        }
        else
        {
            os.precision(digitsOf(e));
            e.write(os);
        }
    }
}

} // End namespace Foam


Foam::wordList Foam::demDict::couplingEntries()
{
    return
    {
        "twoWay", "rho", "nu", "walls", "diameter", "interval", "relaxation", "kernel", "width",
        "lawWidth", "base", "minVoidFraction", "record", "fields", "lastGood", "equations",
        "mixtureFlux", "ownWake"
    };
}


void Foam::demDict::checkCoupling() const
{
    // of CFDEMcoupling; no entry here has its meaning
    if (coupling_.found("couplingInterval"))
    {
        FatalIOErrorInFunction(coupling_)
            << "coupling: unknown entry \"couplingInterval\"; fluid and particles exchange forces in each"
            << " step of the fluid, deltaT of system/controlDict" << exit(FatalIOError);
    }

    demCheckEntries(coupling_, "coupling", couplingEntries());
}


// End and output of a run are controlled by system/controlDict
void Foam::demDict::dropControlDictEntries(const bool settle)
{
    DynamicList<word> dropped;

    if (dict_.remove("write"))
    {
        dropped.append("write");
    }
    if (dict_.isDict("time"))
    {
        dictionary& time = dict_.subDict("time");

        time.readIfPresent("end", settlingEnd_);
        if (time.remove("end") && !settle)
        {
            dropped.append("time/end");
        }
        if (!settle)
        {
            time.remove("untilQuiet");
        }
    }

    if (dropped.size() && !settle)
    {
        Info<< "Suna: not read from constant/" << name() << ": "
            << flatOutput(dropped) << "; here system/controlDict decides"
            << endl;
    }
}


void Foam::demDict::dropFlowEntries()
{
    dict_.remove("outlets");
    dict_.remove("averages");
    dropGroups(true);
}


// Drop groups of insert: streams, or all others
void Foam::demDict::dropGroups(const bool streams)
{
    DynamicList<word> dropped;
    const dictionary groups(dict_.subOrEmptyDict("insert"));

    for (const entry& group : groups)
    {
        const bool stream =
            group.isDict()
         && group.dict().getOrDefault<word>("type", word::null) == "stream";

        if (stream == streams)
        {
            dict_.subDict("insert").remove(group.keyword());
            dropped.append(group.keyword());
        }
    }

    if (dropped.size() && !streams)
    {
        Info<< "Suna: not read from insert, as the particles come from"
            << " start/snapshot: " << flatOutput(dropped)
            << "; demPimpleFoam -settle inserts them" << endl;
    }
}


// Numbers for macros, which OpenFOAM has put in: the core does not know their names
void Foam::demDict::dropVariables()
{
    DynamicList<word> entries;
    wordList macros;

    for (const entry& e : dict_)
    {
        if (!e.isDict())
        {
            entries.append(e.keyword());
        }
    }
    if (entries.size() && Pstream::master())
    {
        std::ifstream stream(file());
        const std::string text(std::istreambuf_iterator<char>(stream), {});
        const std::regex macro("\\$[{:!]*([A-Za-z_][A-Za-z0-9_]*)");

        for (std::sregex_iterator at(text.begin(), text.end(), macro), end; at != end; ++at)
        {
            macros.append(word((*at)[1].str()));
        }
    }
    demBroadcast(macros);

    for (const word& name : entries)
    {
        if (macros.found(name))
        {
            dict_.remove(name);
        }
    }
}


void Foam::demDict::readStart(const bool settle)
{
    if (!dict_.found("start"))
    {
        return;
    }

    dict_.subDict("start").readEntry("snapshot", snapshot_);
    snapshot_.expand();

    if (!snapshot_.isAbsolute())
    {
        snapshot_ = mesh_.time().globalPath()/snapshot_;
    }
    demBroadcast(snapshot_);            // the roots of the ranks may differ
    if (settle)
    {
        dict_.remove("start");
    }
    else
    {
        // The core reads frozen and particle scalars
        dict_.subDict("start").set("snapshot", snapshot_);
        dropGroups(false);
    }
}


void Foam::demDict::resolveGravity()
{
    IOobject io(demFileAt(mesh_.time().constant(), "g", mesh_.time(), IOobject::MUST_READ));

    const dictionary& effects = dict_.subOrEmptyDict("effects");
    const dictionary& own = effects.subOrEmptyDict("gravity");
    const bool inScene = own.readIfPresent("acceleration", gravity_);

    if (!io.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        reportGravity(inScene ? "effects/gravity/acceleration" : "");
        return;
    }

    const uniformDimensionedVectorField given(io);
    const vector g = given.value();

    if (given.dimensions() != dimAcceleration)
    {
        FatalErrorInFunction
            << "constant/g has dimensions " << given.dimensions() << "; give "
            << dimAcceleration << exit(FatalError);
    }

    if (inScene && mag(g - gravity_) > 1e-9*mag(g))
    {
        FatalIOErrorInFunction(own)
            << "Gravity is " << gravity_ << " in effects/gravity/acceleration"
            << " and " << g << " in constant/g; write it in one place only"
            << exit(FatalIOError);
    }

    gravity_ = g;

    if (!inScene && mag(g) > 0)
    {
        dictionary gravity;
        dictionary added;
        gravity.add("acceleration", g);
        added.add("gravity", gravity);

        dictionary all;
        all.add("effects", added);
        dict_.merge(all);
    }
    reportGravity("constant/g");
}


bool Foam::demDict::emptyWalls() const
{
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch) && isWall(patch))
        {
            return true;
        }
    }
    return false;
}


void Foam::demDict::reportGravity(const char* source) const
{
    if (mag(gravity_) > 0)
    {
        Info<< "Suna: gravity " << gravity_ << " m/s2 from " << source << endl;
    }
    else
    {
        Info<< "Suna: no gravity: "
            << (*source ? source : "neither constant/g nor effects/gravity")
            << (*source ? " is zero" : " is there") << endl;
    }
}


Foam::demDict::demDict(const polyMesh& mesh, const bool settle)
:
    mesh_(mesh),
    dict_(demFileAt(mesh.time().constant(), name(), mesh.time(), IOobject::MUST_READ)),
    coupling_(dict_.subOrEmptyDict("coupling")),
    settlingEnd_(0),
    gravity_(Zero)
{
    dict_.remove("coupling");
    dict_.remove("FoamFile");

    dropVariables();
    dropControlDictEntries(settle);

    if (dict_.found("fluid"))
    {
        FatalIOErrorInFunction(dict_.subDict("fluid"))
            << "The scene has a uniform fluid, but in this run the fluid is the"
            << " solver's; take out fluid { ... }" << exit(FatalIOError);
    }

    readStart(settle);
    if (settle)
    {
        dropFlowEntries();
    }

    checkCoupling();
    coupling_.readIfPresent("walls", extraWalls_);
    checkPatchNames();
    separatePatchWalls();
    addMirrors();
    addFrameMotion();
    if (settle)
    {
        closePatches();
    }
    demDomain(mesh_).complete(dict_, emptyWalls());
    resolveGravity();
}


Foam::word Foam::demDict::effectWith(const unsigned traits) const
{
    for (const entry& effect : dict_.subOrEmptyDict("effects"))
    {
        if (dem_effect_traits(effect.keyword().c_str()) & traits)
        {
            return effect.keyword();
        }
    }

    return word::null;
}


void Foam::demDict::refuseDuplicate(const word& name, const char* where) const
{
    if (coupling_.found(name))
    {
        FatalIOErrorInFunction(coupling_)
            << name << " comes from " << where << " here; take it out of"
            << " coupling in constant/" << demDict::name()
            << exit(FatalIOError);
    }
}


std::string Foam::demDict::text() const
{
    dictionary scene(dict_);
    dictionary coupling(coupling_);

    for (const char* name : {"record", "fields", "lastGood"})
    {
        coupling.remove(name);  // they change no result
    }
    scene.add("coupling", coupling);

    OStringStream os;
    writeEntries(scene, os);
    return os.str();
}
