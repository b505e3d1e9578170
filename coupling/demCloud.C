/*---------------------------------------------------------------------------*\
    demCloud.C -- building the particles and saving them.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demCheck.H"
#include "demFluid.H"
#include "demSnapshot.H"
#include "demWriter.H"
#include "OSspecific.H"
#include "Time.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// A serial OpenFOAM has no MPI, and the core then needs none
static MPI_Comm communicator()
{
    if (!Pstream::parRun())
    {
        return MPI_COMM_NULL;
    }

    int size = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    if (size == Pstream::nProcs())
    {
        return MPI_COMM_WORLD;
    }

    // Several worlds share MPI_COMM_WORLD: ours are the ranks of procID
    List<int> ranks(Pstream::nProcs());
    forAll(ranks, i)
    {
        ranks[i] = Pstream::procID(Pstream::worldComm)[i];
    }

    MPI_Group world, ours;
    MPI_Comm comm;
    MPI_Comm_group(MPI_COMM_WORLD, &world);
    MPI_Group_incl(world, ranks.size(), ranks.cdata(), &ours);
    MPI_Comm_create_group(MPI_COMM_WORLD, ours, 0, &comm);
    MPI_Group_free(&ours);
    MPI_Group_free(&world);
    return comm;
}


// Clear fluid comes in where the velocity is given: users give the superficial
// velocity. Elsewhere the particles go on behind the patch.
static wordList patchTypes(const fvMesh& mesh)
{
    wordList types(mesh.boundary().size(), "zeroGradient");
    const volVectorField* U = mesh.findObject<volVectorField>("U");

    forAll(types, patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];

        if
        (
            U
         && !patch.coupled()
         && !isA<wallFvPatch>(patch)
         && U->boundaryField()[patchi].fixesValue()
         && !U->boundaryField()[patchi].assignable()     // not an outlet
        )
        {
            types[patchi] = "fixedValue";
        }
    }

    return types;
}


static IOobject fieldAt
(
    const fvMesh& mesh,
    const word& name,
    const IOobject::readOption read = IOobject::NO_READ
)
{
    return IOobject(name, mesh.time().timeName(), mesh, read);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// Iterations of a steady solver are no time; steps of others are
void Foam::demCloud::checkInterval() const
{
    const dictionary& own = dict_.coupling();
    const bool steady = demFluid::steady(mesh_);

    if (steady && makesRoom_)
    {
        FatalErrorInFunction
            << "ddtSchemes in system/fvSchemes knows no time, but this solver"
            << " follows moving particles in time; take Euler"
            << exit(FatalError);
    }

    if (steady && !own.found("interval"))
    {
        FatalIOErrorInFunction(own)
            << "This solver is steady (ddtSchemes): its iterations take no"
            << " time, but particles move in time. Add interval <s> to coupling"
            << " in constant/" << demDict::name() << ", how long particles move"
            << " in each iteration, or take a transient solver"
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

    demCheck(dem_create(&dem_, communicator()));
    demCheck
    (
        dem_scene_text(dem_, dict_.text().c_str(), "constant/demProperties")
    );

    const label walls = walls_.add(dem_);
    flows_.add(dem_);

    const fileName start(demSnapshot::start(mesh_.time(), dict_));
    if (!start.empty())
    {
        demCheck(dem_load(dem_, start.c_str()));
    }
    if (diameter_ <= 0)
    {
        diameter_ = demSnapshot::kept(mesh_.time(), "diameter");
    }
    changeRate_ = demSnapshot::kept(mesh_.time(), "changeRate");
    relaxationRate_ = demSnapshot::kept(mesh_.time(), "relaxationRate");

    record_.prepare(dem_);
    demCheck(dem_ready(dem_));
    record_.watch(dem_);
    budget_.watch(dem_);
    if (budget_.on() && !(makesRoom_ && dem_needs_fluid(dem_)))
    {
        FatalIOErrorInFunction(dict_.coupling())
            << "coupling/record/budget is the budget of a fluid and particles"
            << " that exchange momentum in demPimpleFoam; take it out, or let"
            << " them: twoWay yes, and a law of drag in effects"
            << exit(FatalIOError);
    }
    if (makesRoom_ && dem_needs_fluid(dem_))
    {
        form_.checkEffects();
        dem_fluid_whole_drag(dem_, form_.wholeDrag());
    }
    demCheck(dem_tally(dem_, &before_));

    const struct dem_step_limit step = dem_step_limit(dem_);
    Info<< "Suna: " << before_.particles << " particles, " << walls
        << " wall patches; DEM steps of at most " << step.limit << " s: "
        << step.why << endl;

    if (dem_needs_fluid(dem_))
    {
        Info<< "Suna: of the fluid: " << dem_acting_fluid(dem_) << endl;
    }
}


// In the head of each field that is written
void Foam::demCloud::nameEffects()
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
        mkDir(folder);
    }
    demCheck(dem_averages(dem_, folder.c_str()));
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demCloud::demCloud
(
    const fvMesh& mesh,
    const bool makesRoom,
    const word& file
)
:
    mesh_(mesh),
    dict_(mesh, file),
    twoWay_(dict_.coupling().getOrDefault("twoWay", true)),
    makesRoom_(makesRoom && twoWay_),
    form_(dict_, makesRoom),
    transfer_(mesh, dict_.coupling()),
    walls_(mesh, dict_),
    flows_(mesh, dict_),
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
    yielding_
    (
        fieldAt(mesh, "dem:yielding"),
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
        dict_.acts("virtualMass")
      ? new volVectorField
        (
            fieldAt(mesh, "fluidAcceleration", IOobject::READ_IF_PRESENT),
            mesh,
            dimensionedVector(dimAcceleration, Zero)
        )
      : nullptr
    ),
    deposited_(0),
    diameter_(dict_.coupling().getOrDefault<scalar>("diameter", 0)),
    interval_(dict_.coupling().getOrDefault<scalar>("interval", 0)),
    before_(),
    window_(0),
    changeRate_(0),
    relaxationRate_(0),
    offset_(0),
    first_(makesRoom),
    lastGood_(dict_.coupling().getOrDefault("lastGood", true)),
    kept_(-1),
    record_(mesh.time(), dict_.coupling()),
    budget_(mesh.time(), dict_.coupling()),
    toFluid_(Zero),
    onWalls_(Zero),
    fields_(mesh, dict_.coupling()),
    passed_(mesh.time()),
    losses_(mesh),
    bonds_(mesh.time())
{
    build();
    passed_.begin(dem_);
    nameEffects();
    look();
    depositVolume();
    dsdt_ = dimensionedScalar(dsdt_.dimensions(), Zero);
    fields_.update(dem_, transfer_, view_);
    ledger_.charge(demLedger::EXCHANGE);
}


Foam::demCloud::~demCloud()
{
    const char* text = nullptr;

    ledger_.close();
    if (!dem_profile_text(dem_, &text))
    {
        Info<< text << endl;
    }
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
        const double* v = dem_at(view_.velocity, view_.stride, i);
        fastest = max(fastest, mag(vector(v[0], v[1], v[2])));
    }

    return
        returnReduce(fastest, maxOp<scalar>())*mesh_.time().deltaTValue()
       /transfer_.length();
}


void Foam::demCloud::write()
{
    const fileName file(demSnapshot::present(mesh_.time()));
    if (Pstream::master())
    {
        mkDir(file.path());
    }

    // Nobody opens a file in a folder that is not there yet
    bool made = true;
    reduce(made, andOp<bool>());

    dictionary numbers;
    numbers.add("diameter", diameter_);
    numbers.add("changeRate", changeRate_);
    numbers.add("relaxationRate", relaxationRate_);

    demCheck(dem_save(dem_, file.c_str()));
    demSnapshot::keep(mesh_.time(), numbers);
    refresh();
    demWriter::write
    (
        mesh_,
        view_,
        transfer_.seen(view_),
        fluid_.place ? fluid_.place : place_.cdata(),
        heading()
    );
    voidFraction_.write();
    if (acceleration_)
    {
        acceleration_().write();
    }
    bonds_.draw(dem_);
    passed_.tell(dem_, true);
    writeMeans();
}

// ************************************************************************* //
