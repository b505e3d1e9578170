/*---------------------------------------------------------------------------*\
    demParticles.C -- the particles in the mesh.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demParticles.H"
#include "demCheck.H"
#include "demColumns.H"
#include "demCommunicator.H"
#include "demFluid.H"
#include "demInteger.H"
#include "demMeshCheck.H"
#include "demRegions.H"
#include "demRotatingFrame.H"
#include "demSlidingInterface.H"
#include "demSnapshot.H"
#include "demWriter.H"
#include "StringStream.H"
#include "Time.H"

namespace Foam
{

// Refuses interfaces and frames first: other checks would report their consequences,
// such as periodic patches of a zone that slides
static const fvMesh& supported(const fvMesh& mesh, const bool volumeAveraged)
{
    demSlidingInterface::check(mesh);
    demRotatingFrame::check(mesh, volumeAveraged);
    demMeshCheck::check(mesh);
    return mesh;
}

} // End namespace Foam


void Foam::demParticles::checkDeltaT() const
{
    const scalar deltaT = mesh_.time().deltaTValue();

    if (deltaT <= 0)
    {
        FatalErrorInFunction
            << "deltaT is " << deltaT << " s; give a time step above 0 in"
            << " system/controlDict" << exit(FatalError);
    }
}


void Foam::demParticles::load()
{
    demCreate(case_);
    demCheck
    (
        dem_case_scene_text(case_, dict_.text().c_str(), "constant/demProperties")
    );

    nWalls_ = walls_.add(case_);
    inletsOutlets_.add(case_);
    demRegions(mesh_, dict_).add(case_);

    const fileName start(demSnapshot::start(mesh_, dict_));
    if (start.empty())
    {
        dem_case_start_time(case_, interval_ > 0 ? 0 : mesh_.time().value());
    }
    else
    {
        demCheck
        (
            demSnapshot::exists(mesh_.time())
          ? dem_case_load(case_, start.c_str())
          : dem_case_start_from(case_, start.c_str())
        );
    }
    if (diameter_ <= 0)
    {
        diameter_ = demSnapshot::readNumber(mesh_.time(), "diameter");
    }
}


// The width of the kernel must not change during a run: that would move volume.
// It is set by the first particles, unless the user gives the diameter.
void Foam::demParticles::setDiameter()
{
    if (diameter_ <= 0)
    {
        struct dem_totals now;
        demCheck(dem_totals(dem_, &now));

        if (now.particles > 0)
        {
            diameter_ = std::cbrt
            (
                6*now.volume/(constant::mathematical::pi*scalar(now.bodies))
            );
        }
    }

    transfer_.setDiameter(diameter_);
}


// Ids of the core have 64 bits, ids in lagrangian/particles may have fewer
void Foam::demParticles::checkIds() const
{
    const int64_t largest = largestId(view_);

    if (largest > demWriter::maxId())
    {
        OStringStream os;
        os  << "Particle id " << demInteger(largest).c_str()
            << " does not fit into lagrangian/particles, which holds ids up to "
            << demInteger(demWriter::maxId()).c_str() << " (a label of this"
            << " OpenFOAM has " << 8*int(sizeof(label)) << " bits); give smaller ids in"
            << " insert of constant/demProperties, or build with WM_LABEL_SIZE=64";
        throw demFailure(os.str());
    }
}


Foam::demParticles::demParticles(const fvMesh& mesh, const bool volumeAveraged)
:
    mesh_(supported(mesh, volumeAveraged)),
    dict_(mesh),
    twoWay_(dict_.coupling().getOrDefault("twoWay", true)),
    displaceFluid_(volumeAveraged && twoWay_),
    inletsOutlets_(mesh, dict_),
    transfer_(mesh, dict_.coupling(), inletsOutlets_.outlets()),
    walls_(mesh, dict_),
    nWalls_(0),
    case_(nullptr),
    dem_(nullptr),
    view_(),
    fluid_(),
    diameter_(dict_.coupling().getOrDefault<scalar>("diameter", 0)),
    interval_(demFluid::interval(mesh, dict_.coupling())),
    window_(0),
    offset_(0),
    totals_()
{
    checkDeltaT();
    load();
}


Foam::demParticles::~demParticles()
{
    dem_case_free(case_);
    dem_free(dem_);
}


void Foam::demParticles::setUp()
{
    if (demFluid::hasUniformDensity(mesh_, dict_.coupling()))
    {
        dem_case_fluid_density(case_, fluidDensity());
    }
    demCheck(dem_start(&case_, &dem_));
    demCheck(dem_device_keep_contacts(dem_));
    dem_set_stop_flag(dem_, dem_repeated_signal());
    refresh();
    reportStart();
    readTotals();
}


Foam::scalar Foam::demParticles::fluidDensity() const
{
    return demFluid::uniformDensity(mesh_, dict_.coupling());
}


Foam::scalar Foam::demParticles::densestFluid() const
{
    return demFluid::largestDensity(mesh_, dict_.coupling());
}


Foam::scalar Foam::demParticles::maxCo() const
{
    return mesh_.time().controlDict().getOrDefault<scalar>("maxParticleCo", 0.5);
}


Foam::scalar Foam::demParticles::time() const
{
    return interval_ > 0 ? totals_.time : mesh_.time().value();
}


// Iterations of a steady solver have no time step in which the mesh could move
void Foam::demParticles::beginStep()
{
    const Time& time = mesh_.time();
    const bool steady = interval_ > 0;

    checkDeltaT();
    if (mesh_.moving() && steady)
    {
        FatalErrorInFunction
            << "The mesh moves, but this solver is steady (ddtSchemes) and its"
            << " iterations have no time step; take a transient solver, or"
            << " dynamicFvMesh staticFvMesh in constant/dynamicMeshDict"
            << exit(FatalError);
    }
    window_ = steady ? interval_ : time.deltaTValue();

    const scalar offset = steady ? 0 : time.value() - time.deltaTValue() - totals_.time;

    if (mag(offset - offset_) > window_)
    {
        Info<< "Suna: at time " << time.value() - time.deltaTValue() << " s the particles' clock, to which"
            << " times in constant/" << demDict::name() << " refer, is at " << totals_.time << " s" << endl;
    }
    offset_ = offset;
}


void Foam::demParticles::refresh()
{
    dem_view(dem_, &view_);
    demCheck(dem_fluid(dem_, &fluid_));
}


void Foam::demParticles::locate()
{
    setDiameter();
    refresh();

    if (!fluid_.location)
    {
        address_.setSize(2*view_.n);
        address_ = -1;
    }

    const demParticleRouting::lostParticles outside
    (
        transfer_.locate
        (
            view_,
            fluid_.location ? fluid_.location : address_.begin(),
            &inletsOutlets_
        )
    );
    if (outside.count)
    {
        throw demFailure(lostSentence(outside));
    }
    refresh();
}


void Foam::demParticles::locateInserted()
{
    locate();
    checkIds();
}


void Foam::demParticles::advance()
{
    if (mesh_.moving())
    {
        walls_.move(dem_);
    }
    if (dem_advance(dem_, window_))
    {
        throw demFailure(dem_error_text());
    }
    if (const int signal = dem_stopped(dem_))
    {
        throw demFailure(string("stopped within a fluid step by a second signal, ")
            + dem_signal_name(signal));
    }
}


void Foam::demParticles::readTotals()
{
    demCheck(dem_totals(dem_, &totals_));
}


Foam::tmp<Foam::scalarField> Foam::demParticles::sample(const volScalarField& field) const
{
    const scalar largest = gMax(field.primitiveField());

    if (largest > gMin(field.primitiveField()))
    {
        return transfer_.sample(field);
    }
    return tmp<scalarField>(new scalarField(view_.n, largest));
}


void Foam::demParticles::write(dictionary& numbers)
{
    numbers.add("diameter", diameter_);
    demSnapshot::write(mesh_, dem_, numbers);
    refresh();
    demWriter::write(mesh_, dem_, view_, transfer_.inMeshFrame(view_), location(), heading());
}
