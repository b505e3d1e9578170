/*---------------------------------------------------------------------------*\
    demPlanWarnings.C -- reports likely mistakes before the first step.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demPlan.H"
#include "demFiles.H"
#include "demCheck.H"
#include "demFluid.H"
#include "demOwnWake.H"
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

// Solid fraction of a loose packing: no stream of particles is denser
static const scalar densest = 0.6;


static std::string vectorText(const vector& v)
{
    std::ostringstream text;
    text<< '(' << v.x() << ' ' << v.y() << ' ' << v.z() << ')';
    return text.str();
}


// Velocity [m/s] at which a lone particle leaves the mesh through a patch, with the fluid there
// and its weight less buoyancy; 0 within round-off. gravity [m/s2]: component out of the mesh.
// Collective.
static scalar outwardDrift
(
    const scalar diameter,
    const scalar density,
    const scalar gravity,
    const demFlow& flow,
    const label patchi
)
{
    const fvPatchVectorField& U = flow.U.boundaryField()[patchi];
    const scalarField& magSf = U.patch().magSf();
    const scalar area = gSum(magSf);
    const scalar rho = gSum((magSf*flow.rho.boundaryField()[patchi])())/area;
    const scalar mu = gSum((magSf*flow.mu.boundaryField()[patchi])())/area;
    const scalar fluid = gSum((U & U.patch().Sf())())/area;
    const scalar settles =
        sign((density - rho)*gravity)
       *dem_sphere_terminal_velocity(diameter, density, rho, mu, mag(gravity));
    const scalar drift = fluid + settles;

    return mag(drift) > 1e-6*(mag(fluid) + mag(settles)) ? drift : 0;
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
        )
        {
            first = open.empty() ? patch.name() : first;
            open += (open.empty() ? "" : ", ") + patch.name();
        }
    }
    demCheck(dem_scene_numbers(particles_.core(), &scene));
    const bool move = scene.moving_mass > 0 || scene.streams;
    if (move && !open.empty())
    {
        warnings.append
        (
            "particles that reach patch " + open + " end the run: let them leave by outlets { NAME"
            " { patch " + first + "; } }, or make it a wall of the particles by coupling { walls ("
          + first + "); }"
        );
    }
}


// Streams through patches: nothing enters, more is due than there is room for, or particles
// return to the patch. Collective.
void Foam::demPlan::streamWarnings(const demFlow& flow, DynamicList<string>& warnings) const
{
    struct ::dem_scene_numbers scene;
    struct ::dem_stream_info s;
    demCheck(dem_scene_numbers(particles_.core(), &scene));

    for (int k = 0; dem_stream_info(particles_.core(), k, &s); k++)
    {
        const label patchi = s.patch ? mesh_.boundaryMesh().findPatchID(s.patch) : -1;
        if (patchi < 0)
        {
            continue;
        }

        const fvPatchVectorField& U = flow.U.boundaryField()[patchi];
        const vectorField& Sf = U.patch().Sf();
        const vectorField normal(U.patch().nf());
        const scalarField& magSf = U.patch().magSf();
        const vector given(s.velocity[0], s.velocity[1], s.velocity[2]);
        const vector spread(s.spread[0], s.spread[1], s.spread[2]);
        const vectorField velocity(s.with_fluid ? vectorField(U) : vectorField(U.size(), given));

        const scalar area = gSum(magSf);
        const vector outward(gSum(Sf)/area);
        const scalar inflow = gSum(max(-(velocity & Sf), scalar(0))());
        const scalarField fastest((spread & cmptMag(normal)) - (velocity & normal));
        const std::string entry(std::string("insert/") + s.name);

        // a fluid velocity that may change says nothing
        const bool lasts = !s.with_fluid || U.type() == "fixedValue";

        if (lasts && gMax(fastest) <= 0)
        {
            std::ostringstream text;
            text<< entry << ": nothing enters through patch " << s.patch << ", as velocity "
                << (s.with_fluid ? "fluid " : "") << vectorText(gSum((magSf*velocity)())/area)
                << " m/s does not point into the mesh; give one with a component along "
                << vectorText(vector(Zero) - outward)
                << (s.with_fluid ? ", here or for the fluid in 0/U" : "");
            warnings.append(text.str());
            continue;
        }

        const scalar fraction = inflow > 0 ? s.volume_rate/inflow : 0;
        if (lasts && fraction > densest)
        {
            const scalar speed = inflow/gSum((magSf*pos(-(velocity & Sf)))());
            std::ostringstream text;
            text<< entry << ": " << s.volume_rate << " m3/s of particles through patch " << s.patch
                << " at " << speed << " m/s have a solid fraction of " << fraction << ", above "
                << densest << ", so not all find free space; give "
                << (s.by_mass ? "a massRate" : "a rate") << " of at most "
                << s.rate*densest/fraction << (s.by_mass ? " kg/s" : " 1/s")
                << ", or a velocity of at least " << speed*fraction/densest << " m/s";
            warnings.append(text.str());
        }

        if (!scene.drag_law || particles_.inletsOutlets().outlets().found(patchi))
        {
            continue;
        }

        const scalar gravity = particles_.gravity() & outward;
        for (const scalar d : {s.max_diameter, s.min_diameter})
        {
            const scalar drift = outwardDrift(d, s.density, gravity, flow, patchi);
            if (drift > 0)
            {
                std::ostringstream text;
                text<< entry << ": particles may return to patch " << s.patch << ", which ends the"
                    << " run: one of " << d << " m drifts out of the mesh at " << drift
                    << " m/s in the fluid there now; add outlets { back { patch " << s.patch
                    << "; } }";
                warnings.append(text.str());
                break;
            }
        }
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
    struct dem_scene_numbers now;
    demCheck(dem_scene_numbers(particles_.core(), &now));

    if (n)
    {
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
    openPatchWarning(own);
    streamWarnings(flow, own);
    ownWakeWarning(own);
    overfullWarning(own);
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
