/*---------------------------------------------------------------------------*\
    demProgress.C -- share done, time left and speed of a run, in its log.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demProgress.H"
#include "demStop.H"
#include <cstdio>

namespace Foam
{

//- Wall-clock time [s] between lines, and between checks for a request to stop
static const scalar silence = 10;
static const scalar between = 1;

} // End namespace Foam

Foam::demProgress::demProgress(const Time& time)
:
    time_(time),
    began_(clock::now()),
    said_(began_),
    particleSteps_(0),
    particles_(0),
    steps_(0),
    start_(0),
    window_(0)
{}


// The core is at this time within the fluid step that ends at time_
void Foam::demProgress::tell(void* self, double time, int64_t steps)
{
    demProgress& p = *static_cast<demProgress*>(self);
    demStop::look(p.time_);
    const scalar part = p.window_ > 0 ? (time - p.start_)/p.window_ : 0;

    p.say
    (
        p.time_.value() - (1 - part)*p.time_.deltaTValue(),
        p.time_.timeIndex() - p.time_.startTimeIndex() - 1 + part,
        p.particleSteps_ + p.particles_*scalar(steps - p.steps_)
    );
}


void Foam::demProgress::say
(
    const scalar time,
    const scalar fluidSteps,
    const scalar particleSteps
)
{
    const clock::time_point now = clock::now();

    if (!Pstream::master() || std::chrono::duration<double>(now - said_).count() < silence)
    {
        return;
    }
    said_ = now;

    const scalar spent = std::chrono::duration<double>(now - began_).count();
    const scalar first = time_.startTime().value();
    const scalar last = time_.endTime().value();
    const scalar done = time - first;

    if (done > 0 && last > first)
    {
        char line[160];

        snprintf
        (
            line,
            sizeof line,
            "Suna: progress %.1f %%, %.0f s left, %.3g fluid steps/s, %.3g particle-steps/s",
            100*done/(last - first),
            spent/done*(last - time),
            fluidSteps/spent,
            particleSteps/spent
        );
        Info<< line << endl;
    }
}


void Foam::demProgress::watch(::dem* d)
{
    if (Pstream::master())
    {
        dem_set_progress(d, between, tell, this);
    }
}


void Foam::demProgress::begin(const struct ::dem_totals& now, const scalar window)
{
    particles_ = scalar(now.particles);
    steps_ = now.steps;
    start_ = now.time;
    window_ = window;
}


void Foam::demProgress::end(const int64_t steps)
{
    particleSteps_ += particles_*scalar(steps);
    say
    (
        time_.value(),
        time_.timeIndex() - time_.startTimeIndex(),
        particleSteps_
    );
}
