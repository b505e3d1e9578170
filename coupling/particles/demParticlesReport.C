/*---------------------------------------------------------------------------*\
    demParticlesReport.C -- what the log says about the particles in the mesh: overlaps at
    the start, the limit of the step, particles outside the mesh.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demParticles.H"
#include "demInteger.H"
#include "demOutletPatch.H"
#include "StringStream.H"

namespace Foam
{

// Fraction of a diameter; do not warn below it
static const scalar slightOverlap = 1e-3;

} // End namespace Foam


// A snapshot made with other walls overlaps the walls of the mesh
void Foam::demParticles::reportStart() const
{
    struct dem_start_overlap start;

    dem_start_overlap(dem_, &start);
    if (start.wall <= 0)
    {
        return;
    }

    Info<< "Suna: at the start overlap of at most " << start.wall
        << " diameters with a wall (" << start.name << ", particle "
        << demInteger(start.id).c_str() << " at ("
        << start.position[0] << ' ' << start.position[1] << ' '
        << start.position[2] << ") m) and " << start.particles
        << " between particles" << endl;

    if (start.wall > 2*start.particles && start.wall > slightOverlap)
    {
        WarningInFunction
            << "The particles overlap a wall more than each other: they were"
            << " settled in other walls, and the wall will throw them; settle"
            << " them in the walls of the mesh by demPimpleFoam -settle" << endl;
    }
}


void Foam::demParticles::reportStep() const
{
    const struct dem_step_limit step = dem_step_limit(dem_);
    Info<< "Suna: " << demInteger(totals_.particles).c_str() << " particles, " << nWalls_
        << " walls; time step of the particles at most " << step.limit << " s: "
        << step.why << endl;

    if (needsFluid())
    {
        Info<< "Suna: fluid effects: " << dem_fluid_effect_names(dem_) << endl;
    }
    if (dem_device(dem_)[0])
    {
        Info<< "Suna: device: " << dem_device(dem_) << endl;
    }
}


Foam::string Foam::demParticles::lostSentence
(
    const demParticleRouting::lostParticles& outside
) const
{
    const string longer(window_ > 0 ? longStep(outside.velocity) : string::null);
    labelList exit;
    const List<string> patch
    (
        demOutletPatch(mesh_).describe
        (
            pointField(1, outside.position), vectorField(1, outside.velocity), &exit
        )
    );

    OStringStream os;
    os  << demInteger(outside.count).c_str() << " particle(s) outside the mesh, whose bounds are "
        << boundBox(mesh_.points(), true) << "; the first is particle "
        << demInteger(outside.id).c_str() << " at " << outside.position << " m, with "
        << mag(outside.velocity) << " m/s"
        << patch[0].c_str();

    if (longer.empty())
    {
        os  << ". Start particles inside the mesh, make walls of all patches that"
            << " particles must not pass, and let them leave through others by"
            << " outlets { NAME { patch ...; } }";
    }
    else
    {
        os  << longer.c_str();
        if (exit[0] >= 0 && !dict().isWall(mesh_.boundaryMesh()[exit[0]]))
        {
            os  << "; where particles may pass it, give outlets { NAME { patch "
                << mesh_.boundaryMesh()[exit[0]].name() << "; } }";
        }
    }
    return os.str();
}


// End of a message on a particle of this velocity that is outside: empty if the step is
// short enough
Foam::string Foam::demParticles::longStep(const vector& velocity) const
{
    const scalar limit = maxCo();
    const scalar Co = mag(velocity)*window_/transfer_.length();

    if (Co <= limit)
    {
        return string::null;
    }

    OStringStream os;
    os  << ". " << (interval_ > 0 ? "coupling/interval " : "deltaT ") << window_
        << " s is long: Courant number of particles " << Co << ", above " << limit
        << " (maxParticleCo); take " << window_*limit/Co << " s"
        << (interval_ > 0 ? "" : ", or adjustTimeStep yes");
    return os.str();
}
