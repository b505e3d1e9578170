/*---------------------------------------------------------------------------*\
    demPlanWarnings.C -- reports likely mistakes before the first step.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demPlan.H"
#include "checkRelaxation.H"
#include "cyclicAMIPolyPatch.H"
#include "demFiles.H"
#include "demCheck.H"
#include "demFluid.H"
#include "demHeatExchange.H"
#include "demOwnWake.H"
#include "demSnapshot.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "wallFvPatch.H"
#include "dem_numbers.h"
#include <sstream>

namespace Foam
{

static bool isCalledInlet(const word& name)
{
    return name.find("inlet") != string::npos || name.find("Inlet") != string::npos;
}


// Largest speed of the fluid on the patches where it is given. Collective.
static scalar patchSpeed(const volVectorField& U)
{
    scalar fastest = 0;
    for (const fvPatchVectorField& Up : U.boundaryField())
    {
        if (!Up.coupled() && Up.fixesValue() && Up.size())
        {
            fastest = max(fastest, max(mag(Up)()));
        }
    }
    return returnReduce(fastest, maxOp<scalar>());
}

// Is the library of a decomposition method a stand-in that only says that it is one?
// OpenFOAM has these in a folder `dummy`, the last of the library path.
static bool isDummy(const word& method)
{
    const fileName library("lib" + method + "Decomp.so");

    std::istringstream folders(getEnv("LD_LIBRARY_PATH"));
    std::string folder;

    while (std::getline(folders, folder, ':'))
    {
        if (isFile(fileName(folder)/library, false))
        {
            return fileName(folder).name() == "dummy";
        }
    }
    return false;
}

} // End namespace Foam


// Patches through which fluid should enter, and where nothing says how much
void Foam::demPlan::inletWarnings
(
    const volVectorField& U,
    DynamicList<string>& warnings
) const
{
    const volScalarField* p = mesh_.findObject<volScalarField>("p_rgh");
    p = p ? p : mesh_.findObject<volScalarField>("p");

    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const word& name = Up.patch().name();

        if
        (
            Up.type() == "zeroGradient"
         && !isA<wallFvPatch>(Up.patch())
         && returnReduce(Up.size(), sumOp<label>()) > 0
         && (isCalledInlet(name) || (p && p->boundaryField()[patchi].type() == "zeroGradient"))
        )
        {
            warnings.append
            (
                string("U on patch ") + name + " is zeroGradient: nothing drives the fluid in"
                " there; give fixedValue in 0/U, or a pressure on the patch and"
                " pressureInletOutletVelocity"
            );
        }
    }
}


// The exchange gives the fluid its impulse within one step. Schemes of two steps add
// a part of the previous change: the total impulse on the fluid is then off by half
// the impulse of the first step.
void Foam::demPlan::timeSchemeWarning(DynamicList<string>& warnings) const
{
    const word scheme(demFluid::timeScheme(mesh_));

    if (particles_.react() && (scheme == "backward" || scheme == "CrankNicolson"))
    {
        warnings.append
        (
            string("ddtSchemes ") + scheme + " does not keep the momentum that fluid and"
            " particles exchange (3 % off where they are brought to one velocity);"
            " give Euler in system/fvSchemes"
        );
    }
}


// demPimpleFoam and demInterFoam refuse this; other solvers converge by it at times
void Foam::demPlan::relaxationWarning(DynamicList<string>& warnings) const
{
    DynamicList<word> names(1, "U");
    for (const word energy : {"e", "h"})
    {
        if (demHeatExchange::needed(particles_) && mesh_.foundObject<volScalarField>(energy))
        {
            names.append(energy);
        }
    }

    for (const word& name : names)
    {
        const scalar factor = lastRelaxation(mesh_, name);

        if (particles_.react() && !demFluid::steady(mesh_) && factor != 1)
        {
            warnings.append(relaxationSentence(mesh_, name, factor));
        }
    }
}


// Patches that are neither walls nor passages: particles are lost there. Collective.
void Foam::demPlan::openPatchWarning(DynamicList<string>& warnings) const
{
    struct ::dem_scene_numbers scene;
    string open;
    word first;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if
        (
            patch.type() == polyPatch::typeName
         && !particles_.dict().isWall(patch)
         && !particles_.inletsOutlets().passages().found(patch.index())
         && returnReduce(patch.size(), sumOp<label>()) > 0
        )
        {
            first = open.empty() ? patch.name() : first;
            open += (open.empty() ? "" : ", ") + patch.name();
        }
    }
    if (open.empty())
    {
        return;
    }
    demCheck(dem_scene_numbers(particles_.core(), &scene));
    if (scene.moving_mass > 0 || scene.streams)
    {
        warnings.append
        (
            "particles that reach patch " + open + " end the run: let them leave by outlets { NAME"
            " { patch " + first + "; } }, or make it a wall of the particles by coupling { walls ("
          + first + "); }"
        );
    }
}


// Faces of sliding interfaces that the other side covers in part, which OpenFOAM takes with
// lowWeightCorrection. Collective.
void Foam::demPlan::interfaceWarning(DynamicList<string>& warnings) const
{
    const scalar whole = 0.9;    // curved sides whose faces do not match are near 1
    label n = 0;
    label all = 0;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<cyclicAMIPolyPatch>(patch))
        {
            const cyclicAMIPolyPatch& own = refCast<const cyclicAMIPolyPatch>(patch);
            const scalarField& covered =
                own.owner() ? own.AMI().srcWeightsSum() : own.neighbPatch().AMI().tgtWeightsSum();

            all += covered.size();
            for (const scalar part : covered)
            {
                n += part < whole;
            }
        }
    }
    reduce(n, sumOp<label>());
    reduce(all, sumOp<label>());
    if (n)
    {
        warnings.append
        (
            "the other side covers less than 90 % of " + name(n) + " of " + name(all)
          + " faces of cyclicAMI patches: fluid and particles do not pass them alike, and a"
            " particle that reaches a face without any cover ends the run; extend both zones so"
            " that their interfaces cover each other"
        );
    }
}


// A particle that is in its own wake is too fast. Collective.
void Foam::demPlan::ownWakeWarning(DynamicList<string>& warnings) const
{
    const scalar excess = demOwnWake(particles_).uncorrected();

    // below this the kernel matters less than the drag law, whose error is some per cent
    if (excess > 0.03)
    {
        warnings.append
        (
            "particles that fall alone are some " + name(label(100*excess + 0.5)) + " % too fast:"
            " they sample fluid that they drag along; give ownWake yes, or a wider kernel, in"
            " coupling (docs/kernels.md)"
        );
    }
}


// Particles that are too large for cells and kernel, as the first deposit found. Collective.
void Foam::demPlan::overfullWarning(DynamicList<string>& warnings) const
{
    const label n = transfer_.limiter().nOverfull();

    if (n)
    {
        struct dem_scene_numbers now;
        demCheck(dem_scene_numbers(particles_.core(), &now));
        warnings.append
        (
            "the particles leave less than minVoidFraction " + name(transfer_.minVoidFraction())
          + " in " + name(n) + " cells, whose excess is moved to their neighbours: the largest, "
          + name(now.max_diameter) + " m, are too large for these cells; use kernel diffusion,"
          + " with diameter " + name(now.max_diameter)
          + " in coupling if sizes differ much, or larger cells"
        );
    }
}


// Files that the run, or decomposePar, does not read as the user expects
void Foam::demPlan::filesWarnings(DynamicList<string>& warnings) const
{
    const Time& time = mesh_.time();
    const fileName constant(time.globalPath()/time.constant());
    const IOdictionary decomposition
    (
        demFileAt(time.system(), "decomposeParDict", time, IOobject::READ_IF_PRESENT)
    );
    const word method(decomposition.getOrDefault<word>("method", word::null));
    DynamicList<string> found;

    // FOLDER/snapshot.dem is of FOLDER.dem. A copied case has new dates, less than a minute apart
    const fileName snapshot(demSnapshot::exists(time) ? fileName() : particles_.dict().snapshot());
    const fileName scene(snapshot.path() + ".dem");
    if
    (
        snapshot.name() == "snapshot.dem" && isFile(snapshot, false) && isFile(scene, false)
     && lastModified(scene) > lastModified(snapshot) + 60
    )
    {
        found.append
        (
            time.relativePath(scene) + " is newer than " + time.relativePath(snapshot)
          + ", with whose particles the run begins: if it has changed, run it again by dem run "
          + scene.name()
        );
    }
    for (const fileName& region : readDir(constant, fileName::DIRECTORY))
    {
        if (isFile(constant/region/demDict::name(), false))
        {
            found.append
            (
                "constant/" + region + "/" + demDict::name() + " is not read, also with a region:"
                " put it into constant/"
            );
        }
    }
    if (!Pstream::parRun() && !method.empty() && isDummy(method))
    {
        found.append
        (
            "method " + method + " of system/decomposeParDict is not in this OpenFOAM (only a"
            " stand-in), so decomposePar will fail: take hierarchical or simple"
        );
    }

    // All ranks need the same list, and only the first surely sees the files
    List<string> ofAll(found);
    demBroadcast(ofAll);
    warnings.append(ofAll);
}


void Foam::demPlan::warn(const demFlow& flow, struct ::dem_run_info& ahead) const
{
    const volVectorField& U = flow.U;
    DynamicList<string> own;
    inletWarnings(U, own);
    timeSchemeWarning(own);
    relaxationWarning(own);
    openPatchWarning(own);
    interfaceWarning(own);
    streamWarnings(flow, own);
    ownWakeWarning(own);
    overfullWarning(own);
    baffleWarning(own);
    filesWarnings(own);
    List<const char*> sentences(own.size());
    const char* text = nullptr;

    forAll(own, k)
    {
        sentences[k] = own[k].c_str();
    }
    ahead.patch_speed = patchSpeed(U);
    ahead.resolution = transfer_.length();

    demCheck(dem_warnings(particles_.core(), &ahead, int(own.size()), sentences.cdata(), &text));
    if (text[0])
    {
        Info<< text << endl;
    }
}
