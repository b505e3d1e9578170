/*---------------------------------------------------------------------------*\
    demCloudLastGood.C -- when the particles fail: report lost particles and write the
    last good state, that of the beginning of the step or of a few steps before.

    Where particles move before the fluid is solved (demPimpleFoam) the fields
    are still those of the beginning of the step, and a whole time folder is
    written. In other solvers some fields may be ahead already, such as a mesh
    that moves; in these, and when the backup is older than the step, the
    particles alone are written to a file lastGood.dem.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demCheck.H"
#include "demColumns.H"
#include "demInteger.H"
#include "demSnapshot.H"
#include "demWriter.H"
#include "fileOperation.H"
#include "OSspecific.H"
#include "StringStream.H"
#include "Time.H"
#include <stdexcept>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// A backup takes as long as half a DEM step. Once in 25 DEM steps it costs 2 % at
// most, even where fluid steps are as short as DEM steps.
void Foam::demCloud::backup()
{
    const int64_t interval = 25;

    if (lastGood_ && (backupSteps_ < 0 || lastTotals_.steps >= backupSteps_ + interval))
    {
        demCheck(dem_backup_every(dem_, 0));
        backupSteps_ = lastTotals_.steps;
    }
}


// Restore the core's backup, of this time [s], and write it to a file (unless its
// name is empty). False, and the reason, when that fails. Collective.
bool Foam::demCloud::restore(const fileName& file, scalar& time, string& why)
{
    if (dem_restore(dem_, &time) || (!file.empty() && dem_save(dem_, file.c_str())))
    {
        why = string("; the last good state cannot be written: ") + dem_error_text();
        return false;
    }
    return true;
}


Foam::string Foam::demCloud::saveLastGood()
{
    Time& time = const_cast<Time&>(mesh_.time());
    const scalar before = time.value() - time.deltaTValue();
    const label index = time.timeIndex() - 1;
    scalar backupTime;
    string why;

    if (index <= time.startTimeIndex())
    {
        return "; its last good state is the one that it started from";
    }

    if (!particlesFirst_ || backupSteps_ != lastTotals_.steps || mesh_.moving())
    {
        fileName file(time.globalPath()/"lastGood.dem");
        demBroadcast(file);
        if (!restore(file, backupTime, why))
        {
            return why;
        }

        OStringStream os;
        const word written(demSnapshot::latestBefore(time));

        os  << "; the particles' last good state, of time " << backupTime + offset_
            << " s, is in lastGood.dem: ";
        if (written.empty())
        {
            os  << "start { snapshot \"lastGood.dem\"; } in constant/" << demDict::name()
                << " begins with these particles, and the fluid at time "
                << Time::timeName(time.startTime().value());
        }
        else
        {
            os  << "look at it, or go on with fluid and particles of time " << written
                << ", the last that was written: startFrom startTime; startTime "
                << written << ";";
        }
        return os.str();
    }

    time.setTime(before, index);

    if (!demSnapshot::exists(time))
    {
        if (!restore(fileName::null, backupTime, why))
        {
            return why;
        }
        locate();
        write();
        mesh_.write();
        fileHandler().flush();
    }

    // The first rank that exits ends all: wait until all have written
    bool written = true;
    reduce(written, andOp<bool>());

    return "; its last good state is time " + time.timeName() + ", fluid and"
        " particles: look at it, or go on from it with startFrom latestTime";
}


// Ids of the core have 64 bits, those in lagrangian/particles may have fewer
void Foam::demCloud::checkIds()
{
    const int64_t largest = largestId(view_);

    if (largest > demWriter::maxId())
    {
        OStringStream os;
        os  << "Particle id " << demInteger(largest).c_str() << " does not fit into lagrangian/particles,"
            << " which holds ids up to " << demInteger(demWriter::maxId()).c_str() << " (a label of this"
            << " OpenFOAM has " << 8*int(sizeof(label)) << " bits); give smaller ids in"
            << " insert of constant/demProperties, or build with WM_LABEL_SIZE=64";
        fail(string(os.str()));
    }
}


void Foam::demCloud::fail(const string& sentence)
{
    string also;

    // Otherwise ranks failed at different places and must not communicate
    if (dem_ranks_agree(dem_))
    {
        if (trial_)
        {
            throw std::runtime_error(sentence);
        }
        losses_.report(dem_, offset_);
        bonds_.report(dem_, offset_);
        if (lastGood_ && backupSteps_ >= 0)
        {
            also = saveLastGood();
        }
    }

    FatalErrorInFunction << sentence.c_str() << also.c_str() << exit(FatalError);
}


void Foam::demCloud::fail(const demParticleRouting::lostParticles& outside)
{
    OStringStream os;

    const string longer(window_ > 0 ? longStep(outside.velocity) : string::null);

    os  << demInteger(outside.count).c_str() << " particle(s) outside the mesh, whose bounds are "
        << boundBox(mesh_.points(), true) << "; the first is particle "
        << demInteger(outside.id).c_str() << " at " << outside.position << " m, with "
        << mag(outside.velocity) << " m/s"
        << losses_.exitPatch(outside.position, outside.velocity).c_str();

    if (longer.empty())
    {
        os  << ". Start particles inside the mesh, make walls of all patches that"
            << " particles must not pass, and let them leave through others by"
            << " outlets { NAME { patch ...; } }";
    }
    else
    {
        os  << longer.c_str();
    }

    fail(string(os.str()));
}

// ************************************************************************* //
