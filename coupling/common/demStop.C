/*---------------------------------------------------------------------------*\
    demStop.C -- signals, and a file, that end a coupled run with its state written;
    one run at a time in a case.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demStop.H"
#include "demCheck.H"
#include "debug.H"
#include "PstreamReduceOps.H"

namespace Foam
{

//- Of the case; static, so that it also goes when a run exits with an error
static struct caseLock
{
    struct dem_folder_lock file;

    ~caseLock()
    {
        dem_folder_unlock(&file);
    }
} lock;


static fileName stopFile(const Time& time)
{
    return time.globalPath()/"stop";
}

} // End namespace Foam


Foam::demStop::demStop(const Time& time)
:
    caught_(nullptr),
    stopped_(false)
{
    if (Pstream::master())
    {
        demCheck(dem_folder_lock(&lock.file, time.globalPath().c_str()));
    }
    if (lock.file.before[0])
    {
        Info<< "Suna: the lock of an earlier run in this case, " << lock.file.before
            << ", which has ended, is taken over" << endl;
    }

    const int ofFoam[] =
    {
        debug::optimisationSwitch("stopAtWriteNowSignal", -1),
        debug::optimisationSwitch("writeNowSignal", -1)
    };
    caught_ = dem_catch_signals(ofFoam, 2);

    int found = 0;
    if (Pstream::master())
    {
        demCheck(dem_stop_file_clear(stopFile(time).c_str(), &found));
    }
    if (found)
    {
        Info<< "Suna: the file stop, which was there before this run, is removed; made again, it"
            << " ends the run" << endl;
    }
}


Foam::demStop::~demStop()
{
    dem_folder_unlock(&lock.file);
}


bool Foam::demStop::atEnd(const Time& time)
{
    return time.value() > time.endTime().value() - 0.5*time.deltaTValue();
}


void Foam::demStop::look(const Time& time)
{
    if (Pstream::master())
    {
        dem_stop_file_look(stopFile(time).c_str());
    }
}


bool Foam::demStop::atStepEnd(const Time& time)
{
    look(time);
    dem_keep_signals();

    const label signal = returnReduce(label(*caught_), maxOp<label>());

    if (stopped_ || signal == 0)
    {
        return false;
    }
    stopped_ = true;
    const_cast<Time&>(time).writeAndEnd();

    Info<< "Suna: stopped by " << dem_signal_name(signal) << " after time "
        << time.timeName() << ": fluid and particles are written there; startFrom"
        << " latestTime in system/controlDict continues" << nl << endl;
    return true;
}
