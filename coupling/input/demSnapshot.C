/*---------------------------------------------------------------------------*\
    demSnapshot.C -- finds the snapshot from which a run starts.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSnapshot.H"
#include "dictionary.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static fileName fileAt(const Time& time, const word& instant)
{
    fileName file(time.path()/instant/"uniform"/"dem.snapshot");
    demBroadcast(file);
    return file;
}


static bool onMaster(const fileName& file)
{
    bool found = Pstream::master() && isFile(file, false);
    reduce(found, orOp<bool>());
    return found;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::demSnapshot::present(const Time& time)
{
    return fileAt(time, time.timeName());
}


bool Foam::demSnapshot::exists(const Time& time)
{
    return onMaster(present(time));
}


Foam::word Foam::demSnapshot::latestBefore(const Time& time)
{
    word latest;

    if (Pstream::master())
    {
        for (const instant& t : Time::findTimes(time.path(), time.constant()))
        {
            if
            (
                t.value() < time.value()
             && isFile(time.path()/t.name()/"uniform"/"dem.snapshot", false)
            )
            {
                latest = t.name();
            }
        }
    }

    demBroadcast(latest);
    return latest;
}


Foam::scalar Foam::demSnapshot::readNumber(const Time& time, const word& name)
{
    const fileName file(present(time).path()/"dem.kernel");
    scalar number = 0;

    if (Pstream::master() && isFile(file, false))
    {
        IFstream is(file);
        number = dictionary(is).getOrDefault<scalar>(name, 0);
    }
    demBroadcast(number);
    return number;
}


void Foam::demSnapshot::writeNumbers(const Time& time, const dictionary& numbers)
{
    const fileName file(present(time).path()/"dem.kernel");

    if (Pstream::master())
    {
        OFstream os(file);
        os.precision(17);
        for (const entry& e : numbers)
        {
            os  << e.keyword() << ' ' << numbers.get<scalar>(e.keyword()) << ";" << nl;
        }
    }
}


Foam::fileName Foam::demSnapshot::start
(
    const Time& time,
    const demDict& dict
)
{
    const fileName here(present(time));

    if (onMaster(here))
    {
        Info<< "Suna: particles from " << time.relativePath(here);
        if (!dict.snapshot().empty())
        {
            Info<< "; start/snapshot is for times without particles";
        }
        Info<< endl;
        return here;
    }

    const word latest(latestBefore(time));

    if (!latest.empty())
    {
        FatalErrorInFunction
            << "Time " << time.timeName() << " has no particles (no file "
            << time.relativePath(here) << "), but time " << latest << " has;"
            << " start from that time, or remove the snapshots"
            << " uniform/dem.snapshot of earlier times to begin with new particles"
            << exit(FatalError);
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

// ************************************************************************* //
