/*---------------------------------------------------------------------------*\
    demCloud.C -- construction of the coupled particles, and their output at write times.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demCheck.H"
#include "demColumns.H"
#include "demCommunicator.H"
#include "demFluid.H"
#include "demInteger.H"
#include "demRegions.H"
#include "demRotatingFrame.H"
#include "demSlidingInterface.H"
#include "demSnapshot.H"
#include "demWriter.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Of a diameter; less is nothing to warn of
static const scalar slightOverlap = 1e-3;


static IOobject fieldAt
(
    const fvMesh& mesh,
    const word& name,
    const IOobject::readOption read = IOobject::NO_READ
)
{
    return IOobject(name, mesh.time().timeName(), mesh, read);
}


// Refuses interfaces and frames first: other checks would find what follows from them,
// such as periodic patches of a zone that slides
static const fvMesh& supported(const fvMesh& mesh, const bool demPimpleFoam)
{
    demSlidingInterface::check(mesh);
    demRotatingFrame::check(mesh, demPimpleFoam);
    return mesh;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// A steady solver needs coupling/interval, a transient one must not have it
void Foam::demCloud::checkInterval() const
{
    const dictionary& own = dict_.coupling();
    const bool steady = demFluid::steady(mesh_);

    if (steady && !own.found("interval"))
    {
        FatalIOErrorInFunction(own)
            << "This solver is steady (ddtSchemes): its iterations have no"
            << " time step, but particles move in time. Add interval <s> to"
            << " coupling in constant/" << demDict::name() << ", the time that"
            << " particles move in each iteration, or take a transient solver"
            << exit(FatalIOError);
    }

    for (const char* name : {"interval", "relaxation"})
    {
        if (!steady && own.found(name))
        {
            FatalIOErrorInFunction(own)
                << name << " is for steady solvers; here particles move by the"
                << " solver's time step. Take it out of coupling in constant/"
                << demDict::name() << exit(FatalIOError);
        }
    }

    if (steady && interval_ <= 0)
    {
        FatalIOErrorInFunction(own)
            << "interval is " << interval_ << " s; it must be positive"
            << exit(FatalIOError);
    }
}


void Foam::demCloud::build()
{
    checkInterval();

    demCreate(dem_);
    demCheck
    (
        dem_scene_text(dem_, dict_.text().c_str(), "constant/demProperties")
    );

    const label walls = walls_.add(dem_);
    inletsOutlets_.add(dem_);
    demRegions(mesh_, dict_).add(dem_);

    const fileName start(demSnapshot::start(mesh_.time(), dict_));
    if (!start.empty())
    {
        demCheck
        (
            demSnapshot::exists(mesh_.time())
          ? dem_load(dem_, start.c_str())
          : dem_start(dem_, start.c_str())
        );
    }
    if (diameter_ <= 0)
    {
        diameter_ = demSnapshot::readNumber(mesh_.time(), "diameter");
    }
    changeRate_ = demSnapshot::readNumber(mesh_.time(), "changeRate");
    relaxationRate_ = demSnapshot::readNumber(mesh_.time(), "relaxationRate");

    record_.prepare(dem_);
    if (volumeAveraged_ && scheme_.underRelaxes())
    {
        dem_fluid_set_displaced(dem_, density());
    }
    if (demFluid::hasUniformDensity(mesh_, dict_.coupling()))
    {
        dem_fluid_set_density(dem_, density());
    }
    demCheck(dem_setup(dem_));
    refresh();
    withoutFactors_ = demSnapshot::exists(mesh_.time())
     && demUnderRelaxation::withoutFactors(fluid_);
    reportStart();
    record_.watch(dem_);
    budget_.watch(dem_);
    if (budget_.on() && !(volumeAveraged_ && dem_needs_fluid(dem_)))
    {
        FatalIOErrorInFunction(dict_.coupling())
            << "coupling/record/budget needs a fluid and particles that"
            << " exchange momentum in demPimpleFoam; take it out, or give"
            << " twoWay yes and a drag law in effects"
            << exit(FatalIOError);
    }
    if (volumeAveraged_ && dem_needs_fluid(dem_))
    {
        scheme_.checkEffects();
        dem_fluid_whole_drag(dem_, scheme_.wholeDrag());
    }
    demCheck(dem_totals(dem_, &lastTotals_));
    progress_.watch(dem_);

    const struct dem_step_limit step = dem_step_limit(dem_);
    Info<< "Suna: " << demInteger(lastTotals_.particles).c_str() << " particles, " << walls
        << " walls; time step of the particles at most " << step.limit << " s: "
        << step.why << endl;

    if (dem_needs_fluid(dem_))
    {
        Info<< "Suna: fluid effects: " << dem_fluid_effect_names(dem_) << endl;
    }
}


// A snapshot made in other walls overlaps those of the mesh
void Foam::demCloud::reportStart() const
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


// The header of each written field names the active effects
void Foam::demCloud::noteEffects()
{
    voidFraction_.note() = heading();
    fields_.note(heading());
    if (acceleration_)
    {
        acceleration_().note() = heading();
    }
}


void Foam::demCloud::writeMeans()
{
    if (!dem_averages_count(dem_))
    {
        return;
    }

    const fileName folder(demTable::folder(mesh_.time()));

    if (Pstream::master())
    {
        demTable::recordEffects(mesh_.time(), dem_);
    }
    demCheck(dem_averages(dem_, folder.c_str()));
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demCloud::demCloud
(
    const fvMesh& mesh,
    const bool volumeAveraged,
    const word& file
)
:
    mesh_(supported(mesh, volumeAveraged)),
    dict_(mesh, file),
    twoWay_(dict_.coupling().getOrDefault("twoWay", true)),
    volumeAveraged_(volumeAveraged && twoWay_),
    scheme_(dict_, volumeAveraged),
    inletsOutlets_(mesh, dict_),
    transfer_(mesh, dict_.coupling(), inletsOutlets_.outlets()),
    walls_(mesh, dict_),
    dem_(nullptr),
    view_(),
    fluid_(),
    voidFraction_
    (
        fieldAt(mesh, "voidFraction", IOobject::READ_IF_PRESENT),
        mesh,
        dimensionedScalar("clear", dimless, 1),
        patchTypes(mesh)
    ),
    dsdt_
    (
        fieldAt(mesh, "dem:dsdt"),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero)
    ),
    solidFlux_
    (
        fieldAt(mesh, "dem:solidFlux"),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        wordList(mesh.boundary().size(), "zeroGradient")
    ),
    force_
    (
        fieldAt(mesh, "dem:force"),
        mesh,
        dimensionedVector(dimForce/dimVolume, Zero)
    ),
    drag_
    (
        fieldAt(mesh, "dem:drag"),
        mesh,
        dimensionedScalar(dimDensity/dimTime, Zero)
    ),
    pressureResponse_
    (
        fieldAt(mesh, "dem:pressureResponse"),
        mesh,
        dimensionedScalar(dimless, Zero)
    ),
    gradP_
    (
        fieldAt(mesh, "dem:gradP"),
        mesh,
        dimensionedVector(dimPressure/dimLength, Zero)
    ),
    clear_
    (
        fieldAt(mesh, "dem:clear"),
        mesh,
        dimensionedScalar("clear", dimless, 1)
    ),
    acceleration_
    (
        dict_.effectWith(DEM_TRAIT_FLUID_ACCELERATION).empty()
      ? nullptr
      : new volVectorField
        (
            fieldAt(mesh, "fluidAcceleration", IOobject::READ_IF_PRESENT),
            mesh,
            dimensionedVector(dimAcceleration, Zero)
        )
    ),
    deposited_(0),
    frames_(demRotatingFrame::all(mesh)),
    diameter_(dict_.coupling().getOrDefault<scalar>("diameter", 0)),
    interval_(dict_.coupling().getOrDefault<scalar>("interval", 0)),
    lastTotals_(),
    window_(0),
    withoutFactors_(false),
    toldRelaxation_(0.5),
    changeRate_(0),
    relaxationRate_(0),
    plannedWindow_(0),
    plannedSteps_(0),
    trial_(false),
    offset_(0),
    particlesFirst_(volumeAveraged),
    lastGood_(dict_.coupling().getOrDefault("lastGood", true)),
    backupSteps_(-1),
    record_(mesh.time(), dict_.coupling()),
    budget_(mesh.time(), dict_.coupling()),
    toFluid_(Zero),
    onWalls_(Zero),
    fields_(mesh, dict_.coupling()),
    flowTable_(mesh.time()),
    losses_(mesh),
    progress_(mesh.time()),
    edits_(mesh.time(), dict_.file()),
    bonds_(mesh.time())
{
    findClosedWalls();
    build();
    flowTable_.begin(dem_, particleTime());
    noteEffects();
    locate();
    checkIds();
    depositVolume();
    dsdt_ = dimensionedScalar(dsdt_.dimensions(), Zero);
    fields_.update(dem_, transfer_, view_);
    profile_.end(demProfile::START);
}


Foam::demCloud::~demCloud()
{
    const char* text = nullptr;

    profile_.end(demProfile::FLUID);
    Info<< "Suna: time spent on fluid " << demProfile::fluid(profile_.spent())
        << " s, particles " << profile_.spent(demProfile::PARTICLES)
        << " s, exchange " << demProfile::exchange(profile_.spent())
        << " s; largest exchange error " << balance_.maxError() << nl << endl;
    if (!dem_profile_text(dem_, &text))
    {
        Info<< text << endl;
    }
    profile_.report();
    dem_free(dem_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::demCloud::density() const
{
    return demFluid::uniformDensity(mesh_, dict_.coupling());
}


Foam::scalar Foam::demCloud::courant()
{
    refresh();
    scalar fastest = 0;
    for (size_t i = 0; i < view_.n; i++)
    {
        fastest = max(fastest, mag(velocity(view_, i)));
    }

    return
        returnReduce(fastest, maxOp<scalar>())*mesh_.time().deltaTValue()
       /transfer_.length();
}


void Foam::demCloud::write()
{
    profile_.end(demProfile::FLUID);
    const fileName file(demSnapshot::present(mesh_.time()));
    if (Pstream::master())
    {
        mkDir(file.path());
    }

    // No rank may open a file before the master has made the folder
    bool made = true;
    reduce(made, andOp<bool>());

    dictionary numbers;
    numbers.add("diameter", diameter_);
    numbers.add("changeRate", changeRate_);
    numbers.add("relaxationRate", relaxationRate_);

    demCheck(dem_save(dem_, file.c_str()));
    demSnapshot::writeNumbers(mesh_.time(), numbers);
    refresh();
    demWriter::write
    (
        mesh_,
        view_,
        transfer_.inMeshFrame(view_),
        fluid_.location ? fluid_.location : address_.cdata(),
        heading()
    );
    voidFraction_.write();
    if (acceleration_)
    {
        acceleration_().write();
    }
    bonds_.writeVtk(dem_);
    flowTable_.report(dem_, true, particleTime());
    writeMeans();
    profile_.end(demProfile::OUTPUT);
}

// ************************************************************************* //
