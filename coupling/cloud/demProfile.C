/*---------------------------------------------------------------------------*\
    demProfile.C -- clock and processor time of the phases of a coupled step.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demProfile.H"
#include "scalarField.H"
#include "PstreamReduceOps.H"
#include "messageStream.H"
#include <cstdio>
#include <ctime>

namespace Foam
{

static const char* const phaseNames[demProfile::nPhases] =
{
    "start", "voidage", "interface", "momentum", "pressure", "fluid", "sample", "particles",
    "deposit", "correct", "output"
};


// Processor time of the process, all threads [s]
static scalar processorClock()
{
    return scalar(std::clock())/CLOCKS_PER_SEC;
}


// Means over the ranks
static scalarField means(const scalar* values)
{
    scalarField sums(demProfile::nPhases, Zero);
    forAll(sums, k)
    {
        sums[k] = returnReduce(values[k], sumOp<scalar>())/Pstream::nProcs();
    }
    return sums;
}

} // End namespace Foam


Foam::demProfile::demProfile()
:
    last_(clock::now()),
    lastProcessor_(processorClock()),
    steps_(0)
{
    for (label k = 0; k < nPhases; k++)
    {
        spent_[k] = processor_[k] = 0;
    }
}


void Foam::demProfile::end(const phase which)
{
    const clock::time_point now = clock::now();
    const scalar processor = processorClock();

    spent_[which] += std::chrono::duration<double>(now - last_).count();
    processor_[which] += processor - lastProcessor_;
    last_ = now;
    lastProcessor_ = processor;
}


Foam::scalar Foam::demProfile::fluid() const
{
    return
        spent_[VOIDAGE] + spent_[INTERFACE] + spent_[MOMENTUM] + spent_[PRESSURE] + spent_[FLUID];
}


Foam::scalar Foam::demProfile::exchange() const
{
    return spent_[SAMPLE] + spent_[DEPOSIT] + spent_[CORRECT] + spent_[OUTPUT];
}


void Foam::demProfile::report() const
{
    const scalarField spent(means(spent_));
    const scalarField processor(means(processor_));
    const scalar wall = sum(spent);
    char line[160];

    snprintf
    (
        line, sizeof line,
        "profile of fluid and coupling: wall clock %.3g s, processor %.3g s, %ld fluid steps",
        wall, sum(processor)*Pstream::nProcs(), long(steps_)
    );
    Info<< line << nl << "    phase         share  time       processor"
        << (Pstream::parRun() ? "  of the slowest rank" : "") << nl;

    for (label k = 0; k < nPhases; k++)
    {
        const scalar slowest = returnReduce(spent_[k], maxOp<scalar>());
        char time[3][24];

        snprintf(time[0], sizeof time[0], "%.3g s", spent[k]);
        snprintf(time[1], sizeof time[1], "%.3g s", processor[k]);
        snprintf(time[2], sizeof time[2], "%.3g s", slowest);
        snprintf
        (
            line, sizeof line, "    %-12s %5.1f %%  %-10s %-10s %s", phaseNames[k],
            wall > 0 ? 100*spent[k]/wall : 0, time[0], time[1],
            Pstream::parRun() ? time[2] : ""
        );
        if (spent[k] >= 1e-3*wall)
        {
            // Without the blanks at its end
            std::string text(line);
            text.erase(text.find_last_not_of(' ') + 1);
            Info<< text.c_str() << nl;
        }
    }
    Info<< endl;
}
