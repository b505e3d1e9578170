/*---------------------------------------------------------------------------*\
    demCloudRescue.C -- when the particles fail: who was lost, and the last good
    state, which is that of the step's beginning or of a few steps before.

    Where particles move before the fluid is solved (demPimpleFoam) the fields
    are still those of the step's beginning, and a whole time folder is written.
    In other solvers some fields may be ahead already, as a mesh that moves is;
    there, and when the copy is older, the particles go to a file of their own.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demCheck.H"
#include "demSnapshot.H"
#include "fileOperation.H"
#include "OSspecific.H"
#include "StringStream.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// A copy takes as long as half a DEM step: at most 2 %, even where fluid steps
// are as short as those
void Foam::demCloud::keep()
{
    const int64_t apart = 25;

    if (lastGood_ && (kept_ < 0 || before_.steps >= kept_ + apart))
    {
        demCheck(dem_keep(dem_, 0));
        kept_ = before_.steps;
    }
}


// The core's copy back, and then into a file. Collective.
bool Foam::demCloud::restore(const fileName& file, scalar& then, string& why)
{
    if (dem_restore(dem_, &then) || (!file.empty() && dem_save(dem_, file.c_str())))
    {
        why = string("; the last good state can't be written: ") + dem_error_text();
        return false;
    }
    return true;
}


Foam::string Foam::demCloud::rescue()
{
    Time& time = const_cast<Time&>(mesh_.time());
    const scalar before = time.value() - time.deltaTValue();
    const label index = time.timeIndex() - 1;
    scalar then;
    string why;

    if (index <= time.startTimeIndex())
    {
        return "; its last good state is the one that it started from";
    }

    if (!first_ || kept_ != before_.steps || mesh_.moving())
    {
        fileName file(time.globalPath()/"lastGood.dem");
        demBroadcast(file);
        if (!restore(file, then, why))
        {
            return why;
        }

        OStringStream os;
        os  << "; the particles' last good state, of time " << then + offset_
            << " s, is in lastGood.dem: start { snapshot \"lastGood.dem\"; }"
            << " takes them from there";
        return os.str();
    }

    time.setTime(before, index);

    if (!demSnapshot::there(time))
    {
        if (!restore(fileName::null, then, why))
        {
            return why;
        }
        look();
        write();
        mesh_.write();
        fileHandler().flush();
    }

    // Whoever ends first ends all: let the others finish writing
    bool written = true;
    reduce(written, andOp<bool>());

    return "; its last good state is time " + time.timeName() + ", fluid and"
        " particles: look at it, or go on from it with startFrom latestTime";
}


void Foam::demCloud::fail(const string& sentence)
{
    string also;

    // Else ranks have failed apart and can't talk
    if (dem_ranks_agree(dem_))
    {
        losses_.tell(dem_, offset_);
        bonds_.tell(dem_, offset_);
        if (lastGood_ && kept_ >= 0)
        {
            also = rescue();
        }
    }

    FatalErrorInFunction << sentence.c_str() << also.c_str() << exit(FatalError);
}


void Foam::demCloud::fail(const demRoute::stray& outside)
{
    OStringStream os;

    os  << outside.count << " particle(s) outside the mesh, whose bounds are "
        << boundBox(mesh_.points(), true) << "; the first is particle "
        << outside.id << " at " << outside.position << " m, with "
        << mag(outside.velocity) << " m/s"
        << losses_.wayOut(outside.position, outside.velocity).c_str()
        << ". Start particles inside the mesh, make walls of all patches that"
        << " particles must not pass, and let them leave through others by"
        << " outlets { NAME { patch ...; } }";

    fail(string(os.str()));
}

// ************************************************************************* //
