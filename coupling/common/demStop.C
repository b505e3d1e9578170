/*---------------------------------------------------------------------------*\
    demStop.C -- signals that end a coupled run with its state written.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demStop.H"
#include "debug.H"
#include "PstreamReduceOps.H"
#include "dem.h"

// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demStop::demStop()
:
    caught_(nullptr),
    stopped_(false)
{
    const int ofFoam[] =
    {
        debug::optimisationSwitch("stopAtWriteNowSignal", -1),
        debug::optimisationSwitch("writeNowSignal", -1)
    };
    caught_ = dem_catch_signals(ofFoam, 2);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::demStop::atStepEnd(const Time& time)
{
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

// ************************************************************************* //
