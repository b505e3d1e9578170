/*---------------------------------------------------------------------------*\
    demLastGood.C -- keeps the last good state, written if the particles fail.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demLastGood.H"
#include "demCheck.H"
#include "demSnapshot.H"
#include "StringStream.H"
#include "Time.H"
#include "fileOperation.H"

// Restore the core's backup, of this time [s], and write it to a file (unless its
// name is empty). False, and the reason, when that fails. Collective.
bool Foam::demLastGood::restore(const fileName& file, scalar& time, string& why)
{
    ::dem* d = particles_.core();

    if (dem_restore(d, &time) || (!file.empty() && dem_save(d, file.c_str())))
    {
        why = string("; the last good state cannot be written: ") + dem_error_text();
        return false;
    }
    return true;
}


// The particles alone
Foam::string Foam::demLastGood::writeParticles()
{
    const Time& time = particles_.mesh().time();
    fileName file(time.globalPath()/"lastGood.dem");
    scalar backupTime;
    string why;

    demBroadcast(file);
    if (!restore(file, backupTime, why))
    {
        return why;
    }

    OStringStream os;
    const word written(demSnapshot::latestBefore(time));

    os  << "; the particles' last good state, of time " << backupTime + particles_.offset()
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


// A folder of the time before this step, fluid and particles
Foam::string Foam::demLastGood::writeAll(const std::function<void()>& write)
{
    Time& time = const_cast<Time&>(particles_.mesh().time());
    scalar backupTime;
    string why;

    time.setTime(time.value() - time.deltaTValue(), time.timeIndex() - 1);

    if (!demSnapshot::exists(time))
    {
        if (!restore(fileName::null, backupTime, why))
        {
            return why;
        }
        particles_.locate();
        write();
        particles_.mesh().write();
        fileHandler().flush();
    }

    // The first rank that exits ends all: wait until all have written
    bool written = true;
    reduce(written, andOp<bool>());

    return "; its last good state is time " + time.timeName() + ", fluid and"
        " particles: look at it, or go on from it with startFrom latestTime";
}


Foam::demLastGood::demLastGood(demParticles& particles, const bool volumeAveraged)
:
    particles_(particles),
    volumeAveraged_(volumeAveraged),
    on_(particles.dict().coupling().getOrDefault("lastGood", true)),
    steps_(-1)
{}


// A backup takes as long as half a DEM step. Once in 25 DEM steps it costs 2 % at
// most, even where fluid steps are as short as DEM steps.
void Foam::demLastGood::backup()
{
    const int64_t interval = 25;

    if (on_ && (steps_ < 0 || particles_.totals().steps >= steps_ + interval))
    {
        demCheck(dem_backup_every(particles_.core(), 0));
        steps_ = particles_.totals().steps;
    }
}


Foam::string Foam::demLastGood::save(const std::function<void()>& write)
{
    const fvMesh& mesh = particles_.mesh();
    const Time& time = mesh.time();

    if (!on_ || steps_ < 0)
    {
        return string::null;
    }
    if (time.timeIndex() - 1 <= time.startTimeIndex())
    {
        return "; its last good state is the one that it started from";
    }
    return
        volumeAveraged_ && steps_ == particles_.totals().steps && !mesh.moving()
      ? writeAll(write)
      : writeParticles();
}
