/*---------------------------------------------------------------------------*\
    demSnapshot.C -- finds the snapshot from which a run starts, and writes snapshots.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSnapshot.H"
#include "demCheck.H"
#include "dictionary.H"
#include "fileOperation.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include <cstdio>

namespace Foam
{

static const fileName snapshotFile("uniform/dem.snapshot");
static const fileName numbersFile("uniform/dem.kernel");


// Folders of the first rank, where file handlers write: the collated one first, as OpenFOAM
// reads. (Handlers that search communicate, but not in the same way on all ranks.)
static fileNameList caseFolders(const Time& time)
{
    fileNameList folders;

    if (time.processorCase())
    {
        const std::string collated("processors" + std::to_string(Pstream::nProcs()));

        for (const fileName& folder : readDir(time.globalPath(), fileName::DIRECTORY))
        {
            if (folder == collated || folder.find(collated + "_0-") == 0)
            {
                folders.append(time.globalPath()/folder);
            }
        }
    }
    folders.append(time.path());
    return folders;
}


// A file or folder of a time, of the first rank; or empty. Collective.
static fileName findFirst(const Time& time, const word& instant, const fileName& name)
{
    fileName file;

    if (Pstream::master())
    {
        for (const fileName& folder : caseFolders(time))
        {
            if (file.empty() && exists(folder/instant/name))
            {
                file = folder/instant/name;
            }
        }
    }
    demBroadcast(file);
    return file;
}


// Where this run writes a file of the folder uniform, the same on all ranks. Collective.
static fileName target(const Time& time, const fileName& name)
{
    const IOobject io
    (
        word(name.name()),
        time.timeName(),
        name.path(),
        time,
        IOobject::NO_READ,
        IOobject::NO_WRITE,
        false
    );
    fileName file(fileHandler().objectPath(io, word::null));
    demBroadcast(file);
    return file;
}


static bool onMaster(const fileName& file)
{
    bool found = Pstream::master() && isFile(file, false);
    reduce(found, orOp<bool>());
    return found;
}


// A file or folder of the present time, of any rank, that only a run with particles writes; empty
// without. Collective.
static fileName trace(const Time& time)
{
    for
    (
        const fileName& name :
        {fileName("lagrangian/particles"), numbersFile, fileName("uniform/lagrangian/particles")}
    )
    {
        const bool first = !findFirst(time, time.timeName(), name).empty();
        const bool found = first || exists(time.path()/time.timeName()/name);

        if (returnReduce(found, orOp<bool>()))
        {
            return name;
        }
    }
    return fileName::null;
}


static std::string hexadecimal(const uint64_t hash)
{
    char text[24];
    snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}


// Refuse the snapshot unless it is the one that was written with these numbers, at this time
static void checkIdentity(const Time& time, const fileName& snapshot, const dictionary& numbers)
{
    const scalar written = numbers.get<scalar>("time");
    const scalar off = mag(written - time.value());

    // The name of a time has six digits or more, unless timePrecision is less
    if (Time::timeName(written) != time.timeName() && off > 1e-6*mag(time.value()))
    {
        FatalErrorInFunction
            << snapshot.c_str() << " is of time "
            << Time::timeName(written) << " s, but the run starts at "
            << time.timeName() << " s; put back the files dem.snapshot and dem.kernel of this"
            << " time. To begin a new run with these particles give start { snapshot <file>; } in"
            << " constant/" << demDict::name() << "; if only the folder was renamed, correct"
            << " `time` in dem.kernel beside it" << exit(FatalError);
    }

    uint64_t hash = 0;
    demCheck(dem_snapshot_hash(snapshot.c_str(), &hash));
    const string known(numbers.get<string>("fingerprint"));

    if (known != hexadecimal(hash))
    {
        FatalErrorInFunction
            << snapshot.c_str() << " is not the snapshot that was written here: its fingerprint is "
            << hexadecimal(hash).c_str() << ", dem.kernel beside it says " << known.c_str()
            << ". It is of another time or case; put back the right one, or begin a new run with"
            << " it by start { snapshot <file>; } in constant/" << demDict::name()
            << exit(FatalError);
    }
}


// On the master: the numbers beside the present snapshot
static dictionary readNumbers(const fileName& snapshot)
{
    const fileName file(snapshot.path()/numbersFile.name());

    if (!isFile(file, false))
    {
        FatalErrorInFunction
            << "There is no file " << file << ", which belongs to the snapshot beside it: the"
            << " width of the kernel and the limits of the next step are in it. Put it back, or"
            << " remove this time's folder and start from the time before" << exit(FatalError);
    }
    IFstream is(file);
    return dictionary(is);
}


// The mesh may be another one, such as a finer one with mapped fields
static void reportMesh(const scalar before, const scalar now)
{
    if (before != now)
    {
        Info<< "Suna: the snapshot was written on a mesh of " << before << " cells, this one has "
            << now << ": the particles continue in this one" << endl;
    }
}


static void refuseMissing(const Time& time, const word& latest)
{
    const fileName left(trace(time));

    if (!left.empty())
    {
        FatalErrorInFunction
            << "Time " << time.timeName() << " has particles (" << left.c_str()
            << "), but no snapshot " << snapshotFile.c_str() << ", without which they would begin"
            << " anew; put the snapshot back, start from a time that has one, or remove"
            << " lagrangian/particles, uniform/lagrangian/particles and uniform/dem.kernel of this"
            << " time to begin with new particles" << exit(FatalError);
    }
    if (!latest.empty())
    {
        FatalErrorInFunction
            << "Time " << time.timeName() << " has no particles (no file "
            << time.timeName()/snapshotFile << "), but time " << latest << " has. If the run was"
            << " killed or the disk was full while it wrote time " << time.timeName()
            << ", remove this time's folder" << (Pstream::parRun() ? "s processor*/" : " ")
            << time.timeName() << " and start again from " << latest << "; if the particles had ended"
            << " before (timeEnd), take their function object out of system/controlDict to go on"
            << " without them; to begin with new particles, remove the snapshots"
            << " uniform/dem.snapshot of earlier times"
            << exit(FatalError);
    }
}

} // End namespace Foam


Foam::fileName Foam::demSnapshot::present(const Time& time)
{
    return findFirst(time, time.timeName(), snapshotFile);
}


bool Foam::demSnapshot::exists(const Time& time)
{
    return !present(time).empty();
}


Foam::word Foam::demSnapshot::latestBefore(const Time& time)
{
    wordList earlier;

    for (const instant& t : time.times())
    {
        if (t.name() != time.constant() && t.value() < time.value())
        {
            earlier.append(t.name());
        }
    }
    demBroadcast(earlier);

    for (label k = earlier.size() - 1; k >= 0; k--)
    {
        if (!findFirst(time, earlier[k], snapshotFile).empty())
        {
            return earlier[k];
        }
    }
    return word::null;
}


Foam::scalar Foam::demSnapshot::readNumber(const Time& time, const word& name)
{
    const fileName snapshot(present(time));
    scalar number = 0;

    if (Pstream::master() && !snapshot.empty())
    {
        number = readNumbers(snapshot).get<scalar>(name);
    }
    demBroadcast(number);
    return number;
}


void Foam::demSnapshot::write(const polyMesh& mesh, ::dem* d, const dictionary& numbers)
{
    const fileName file(target(mesh.time(), snapshotFile));
    const label cells = returnReduce(mesh.nCells(), sumOp<label>());
    uint64_t hash = 0;

    if (Pstream::master())
    {
        mkDir(file.path());
    }

    // No rank may open a file before the master has made the folder
    bool made = true;
    reduce(made, andOp<bool>());

    demCheck(dem_save(d, file.c_str()));
    demCheck(dem_hash(d, &hash));

    if (Pstream::master())
    {
        OFstream os(file.path()/numbersFile.name());
        os.precision(17);
        for (const entry& e : numbers)
        {
            os  << e.keyword() << ' ' << numbers.get<scalar>(e.keyword()) << ";" << nl;
        }
        os  << "time " << mesh.time().value() << ";" << nl
            << "cells " << cells << ";" << nl
            << "fingerprint " << string(hexadecimal(hash)) << ";" << nl;
    }
}


Foam::fileName Foam::demSnapshot::start(const polyMesh& mesh, const demDict& dict)
{
    const Time& time = mesh.time();
    const fileName here(present(time));

    if (!here.empty())
    {
        scalar cells = 0;
        if (Pstream::master())
        {
            const dictionary numbers(readNumbers(here));
            checkIdentity(time, here, numbers);
            cells = numbers.get<scalar>("cells");
        }
        Info<< "Suna: particles from " << time.relativePath(here);
        if (!dict.snapshot().empty())
        {
            Info<< "; start/snapshot is for times without particles";
        }
        Info<< endl;
        reportMesh(cells, returnReduce(mesh.nCells(), sumOp<label>()));
        return here;
    }

    refuseMissing(time, latestBefore(time));

    if (time.value() > 0)
    {
        Info<< "Suna: the fluid of time " << time.timeName() << " was computed without particles;"
            << " they begin here" << endl;
    }
    if (dict.snapshot().empty())
    {
        Info<< "Suna: new particles, as insert of constant/demProperties says" << endl;
    }
    else if (!onMaster(dict.snapshot()))
    {
        FatalErrorInFunction
            << "There is no file " << dict.snapshot() << ", which start/snapshot"
            << " of constant/" << demDict::name() << " names; make it by"
            << " demPimpleFoam -settle, which settles the groups of insert in"
            << " the walls of the mesh, or correct the name" << exit(FatalError);
    }
    else
    {
        Info<< "Suna: particles from " << dict.snapshot() << endl;
    }
    return dict.snapshot();
}
