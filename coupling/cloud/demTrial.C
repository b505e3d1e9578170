/*---------------------------------------------------------------------------*\
    demTrial.C -- measured fluid steps, for the plan of a run.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demTrial.H"
#include "Time.H"
#include "fvMesh.H"
#include <cstdio>
#include <string>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

enum { LEFT_OUT = 2, MAX_STEPS = 10 };

static const scalar longEnough = 10;    // s on the clock
static const scalar longMotion = 1;     // s of DEM steps in a trial step


static std::string inSeconds(const scalar t)
{
    char text[32];
    snprintf(text, sizeof text, "%.3g s", t);
    return text;
}


static std::string range(const scalar low, const scalar high)
{
    const std::string from(inSeconds(low)), to(inSeconds(high));
    return from == to ? from : from.substr(0, from.size() - 2) + " to " + to;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demTrial::setDeltaT(const scalar deltaT)
{
    time_.setDeltaT(deltaT, false);
}


void Foam::demTrial::remember()
{
    const demProfile& p = cloud_.profile();

    fluidBefore_ = demProfile::fluid(p.processor());
    exchangeBefore_ = demProfile::exchange(p.processor());
    clockBefore_ = demProfile::fluid(p.spent()) + demProfile::exchange(p.spent());
}


void Foam::demTrial::add()
{
    const demProfile& p = cloud_.profile();
    const scalar clock = demProfile::fluid(p.spent()) + demProfile::exchange(p.spent());

    fluid_ += returnReduce(demProfile::fluid(p.processor()) - fluidBefore_, sumOp<scalar>());
    exchange_ +=
        returnReduce(demProfile::exchange(p.processor()) - exchangeBefore_, sumOp<scalar>());
    clock_ += returnReduce(clock - clockBefore_, maxOp<scalar>());
    measured_++;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demTrial::demTrial(fvMesh& mesh, demCloud& cloud)
:
    time_(const_cast<Time&>(mesh.time())),
    cloud_(cloud),
    level_(messageStream::level),
    deltaT_(time_.deltaTValue()),
    window_(cloud.lastPlan().window()),
    motion_(window_),
    begun_(0),
    measured_(0),
    started_(0),
    fluid_(0),
    exchange_(0),
    clock_(0),
    fluidBefore_(0),
    exchangeBefore_(0),
    clockBefore_(0)
{
    const scalar particles =
        cloud.lastPlan().seconds(true)/cloud.lastPlan().steps()/Pstream::nProcs();

    if (particles > longMotion)
    {
        motion_ = window_*longMotion/particles;
    }
    cloud_.profile().end(demProfile::START);
    cloud_.beginTrial();
    messageStream::level = 0;
}


Foam::demTrial::~demTrial()
{
    messageStream::level = level_;
    setDeltaT(deltaT_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::demTrial::next()
{
    cloud_.profile().end(demProfile::FLUID);
    if (begun_ == 0)
    {
        started_ = time_.elapsedClockTime();
    }

    bool late = time_.elapsedClockTime() - started_ > longEnough;
    reduce(late, orOp<bool>());

    if (begun_ > LEFT_OUT || (begun_ && late))
    {
        add();
    }
    if (measured_ >= MAX_STEPS || (measured_ && late))
    {
        return false;
    }
    begun_++;
    remember();
    setDeltaT(window_);
    return true;
}


void Foam::demTrial::beginExchange()
{
    setDeltaT(motion_);
}


void Foam::demTrial::beginFluid()
{
    setDeltaT(window_);
}


void Foam::demTrial::report(const char* how)
{
    messageStream::level = level_;

    const scalar steps = cloud_.lastPlan().steps();
    const scalar fluid = fluid_/measured_;
    const scalar exchange = exchange_/measured_;
    const scalar low = cloud_.lastPlan().seconds(false);
    const scalar high = max(low, cloud_.lastPlan().seconds(true));
    const scalar more = steps*(fluid + exchange);
    const label ranks = Pstream::nProcs();
    char number[32];

    snprintf(number, sizeof number, "%.4g", steps);
    Info<< "Fluid and exchange" << nl << "    " << inSeconds(fluid).c_str()
        << " of processor time a fluid step for the fluid, "
        << inSeconds(exchange).c_str() << " for the exchange with the particles: "
        << how << ", mean of " << measured_ << nl << "    " << number << " fluid steps of "
        << inSeconds(window_).c_str() << ": fluid " << inSeconds(steps*fluid).c_str()
        << ", exchange " << inSeconds(steps*exchange).c_str() << ", particles "
        << range(low, high).c_str() << " of processor time" << nl << "Run" << nl << "    "
        << range(low + more, high + more).c_str() << " of processor time in all, "
        << range(low/ranks + steps*clock_/measured_, high/ranks + steps*clock_/measured_).c_str()
        << " on the clock of " << ranks << (ranks > 1 ? " ranks" : " rank")
        << " with a free core each; without output" << nl << endl;
}


void Foam::demTrial::fail(const char* why)
{
    messageStream::level = level_;
    Info<< "Fluid and exchange" << nl << "    not measured, as trial step " << begun_
        << " failed, as that of the run will: " << why << nl << endl;
}

// ************************************************************************* //
