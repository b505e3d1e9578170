/*---------------------------------------------------------------------------*\
    demSettle.C -- settles the particles of a case in the walls of its mesh.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSettle.H"
#include "dem_plan.h"
#include "demFiles.H"
#include "demCheck.H"
#include "demCommunicator.H"
#include "demInteger.H"
#include "demMeshCheck.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "Time.H"

namespace Foam
{

// Kinetic energy above which a particle moves, over the energy of a fall by a
// diameter: a speed of 0.014 sqrt(g d)
static const scalar restless = 1e-4;

// Longest time of settling, in falls by the height of the mesh
static const scalar falls = 100;

} // End namespace Foam


void Foam::demSettle::check() const
{
    if (dict_.scene().subOrEmptyDict("insert").empty())
    {
        FatalErrorInFunction
            << "There are no particles to settle: insert of constant/"
            << demDict::name() << " has no group besides streams; add one, for"
            << " example type random with inside mesh" << exit(FatalError);
    }
    if (mag(dict_.gravity()) <= 0)
    {
        FatalErrorInFunction
            << "Particles do not settle without gravity; add constant/g or"
            << " effects/gravity" << exit(FatalError);
    }
}


Foam::scalar Foam::demSettle::viscosity(const word& effect) const
{
    const IOdictionary transport
    (
        demFileAt
        (
            mesh_.time().constant(), "transportProperties", mesh_, IOobject::READ_IF_PRESENT
        )
    );
    const dictionary& own = dict_.coupling();
    const dictionary& rho = own.found("rho") ? own : transport;
    const dictionary& nu = own.found("nu") ? own : transport;

    if (!rho.found("rho") || !nu.found("nu"))
    {
        FatalErrorInFunction
            << "effects/" << effect << " takes the viscosity of the fluid, which"
            << " is not known here; give rho in coupling of constant/"
            << demDict::name() << " and nu in constant/transportProperties,"
            << " or viscosity in effects/" << effect << exit(FatalError);
    }
    return
        dimensionedScalar("rho", dimDensity, rho).value()
       *dimensionedScalar("nu", dimViscosity, nu).value();
}


void Foam::demSettle::leaveOutFluid()
{
    DynamicList<word> left;

    for (const entry& effect : dict_.scene().subOrEmptyDict("effects"))
    {
        const word name(effect.keyword());
        const unsigned traits = dem_effect_traits(name.c_str());

        if (traits & DEM_TRAIT_FLUID)
        {
            demCheck(dem_case_remove_effect(case_, name.c_str()));
            left.append(name);
        }
        else if
        (
            (traits & DEM_TRAIT_VISCOSITY)
         && !(effect.isDict() && effect.dict().found("viscosity"))
        )
        {
            std::ostringstream value;
            value.precision(17);
            value << viscosity(name);
            demCheck
            (
                dem_case_set
                (
                    case_,
                    ("effects/" + name + "/viscosity").c_str(),
                    value.str().c_str()
                )
            );
        }
    }

    if (left.size())
    {
        Info<< "Suna: settling without the fluid; left out: "
            << flatOutput(left) << endl;
    }
}


Foam::scalar Foam::demSettle::limit() const
{
    const vector& g = dict_.gravity();
    const scalar height = mag(mesh_.bounds().span() & cmptMag(g))/mag(g);

    return dict_.settlingEnd() > 0 ? dict_.settlingEnd() : falls*sqrt(2*height/mag(g));
}


void Foam::demSettle::build()
{
    check();
    demMeshCheck::check(mesh_);
    demCreate(case_);
    demCheck
    (
        dem_case_scene_text(case_, dict_.text().c_str(), "constant/demProperties")
    );
    leaveOutFluid();

    const label walls = walls_.add(case_);
    regions_.add(case_);

    demCheck(dem_case_read_quiet(case_, &quiet_));
    if (!quiet_.wanted)
    {
        quiet_.wanted = 1;
        quiet_.kinetic = restless;
    }
    demCheck(dem_case_check(case_));
    demCheck(dem_quiet_check(dem_case_checked(case_), &quiet_));
    demCheck(dem_start(&case_, &dem_));
    demCheck(dem_totals(dem_, &totals_));

    const struct dem_step_limit step = dem_step_limit(dem_);
    Info<< "Suna: settling " << demInteger(totals_.particles).c_str()
        << " particles in " << walls << " walls of the mesh, steps of at most "
        << step.used << " s: " << step.why << nl << endl;
}


// Tests are equally spaced; the log has one line in eight of them
void Foam::demSettle::advance()
{
    const scalar end = limit();
    const scalar part =
        end/max(scalar(1), scalar(dem_quiet_tests(dem_, &quiet_, end)));
    scalar overlap = 0;

    for (label k = 1; totals_.time < end*(1 - 1e-9) && !quiet_.reached; k++)
    {
        demCheck(dem_advance(dem_, part));
        demCheck(dem_totals(dem_, &totals_));
        demCheck(dem_quiet_test(dem_, &quiet_, &totals_));
        overlap = max(overlap, totals_.largest_overlap);

        if (k % 8 == 0 || quiet_.reached)
        {
            Info<< "t " << totals_.time << " s  kinetic " << totals_.kinetic
                << " J  overlap " << overlap << " diameters  "
                << demInteger(quiet_.move).c_str() << " of "
                << demInteger(totals_.particles).c_str() << " move" << endl;
            overlap = 0;
        }
    }

    if (!quiet_.reached)
    {
        WarningInFunction
            << "The particles do not rest after " << totals_.time << " s: "
            << demInteger(quiet_.move).c_str() << " of "
            << demInteger(totals_.particles).c_str() << " move; give them more"
            << " time by time/end of constant/" << demDict::name()
            << ", or more damping" << endl;
    }
}


void Foam::demSettle::save()
{
    fileName root(mesh_.time().globalPath());
    demBroadcast(root);
    const bool named = !dict_.snapshot().empty();
    const fileName file(named ? dict_.snapshot() : root/"settled.dem");

    demCheck(dem_save(dem_, file.c_str()));
    Info<< nl << "Suna: " << (quiet_.reached ? "at rest" : "not at rest")
        << " at t " << totals_.time << " s, written to " << file << endl;

    if (!named)
    {
        Info<< "Suna: for the coupled run add to constant/" << demDict::name()
            << ": start { snapshot \"settled.dem\"; }" << endl;
    }
}


Foam::demSettle::demSettle(const fvMesh& mesh)
:
    mesh_(mesh),
    dict_(mesh, true),
    walls_(mesh, dict_),
    regions_(mesh, dict_),
    case_(nullptr),
    dem_(nullptr),
    quiet_(),
    totals_()
{}


Foam::demSettle::~demSettle()
{
    dem_case_free(case_);
    dem_free(dem_);
}


void Foam::demSettle::run()
{
    build();
    advance();
    save();
}
