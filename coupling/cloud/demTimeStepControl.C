/*---------------------------------------------------------------------------*\
    demTimeStepControl.C -- criteria of the time step, and which one limits it.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demTimeStepControl.H"
#include "Time.H"

namespace Foam
{
    // Step over the relaxation time of particles; reported above this
    static const scalar relaxationWarning = 1;
}


Foam::demTimeStepControl::demTimeStepControl(const Time& time, demCloud& cloud)
:
    time_(time),
    cloud_(cloud),
    names_({"maxCo", "maxParticleCo", "maxVoidFractionChange", "maxRelaxation"}),
    what_
    ({
        "Courant number of the fluid", "Courant number of particles",
        "change of the void fraction of a cell", "step over the relaxation time of a particle"
    }),
    value_(nCriteria, Zero),
    limit_(nCriteria, Zero),
    reported_(nCriteria, Zero)
{}


Foam::label Foam::demTimeStepControl::add(const word& name, const string& what)
{
    names_.append(name);
    what_.append(what);
    value_.append(0);
    limit_.append(0);
    reported_.append(0);
    return names_.size() - 1;
}


void Foam::demTimeStepControl::set
(
    const label criterion,
    const scalar value,
    const scalar limit
)
{
    if (!(limit > 0))
    {
        FatalIOErrorInFunction(time_.controlDict())
            << names_[criterion] << " is " << limit << "; it must be positive."
            << " Leave it out for its default" << exit(FatalIOError);
    }
    value_[criterion] = value;
    limit_[criterion] = limit;
}


void Foam::demTimeStepControl::read(const scalar maxCo)
{
    const scalar defaultLimit[nCriteria] = {maxCo, cloud_.particles().maxCo(), 0.1, 0};

    for (label k = FLUID; k < nCriteria; ++k)   // those that a solver adds have a limit already
    {
        const dictionary& control = time_.controlDict();
        limit_[k] = control.getOrDefault<scalar>(names_[k], defaultLimit[k]);
        if (limit_[k] < 0 || (control.found(names_[k]) && limit_[k] == 0))
        {
            FatalIOErrorInFunction(control)
                << names_[k] << " is " << limit_[k] << "; it must be positive."
                << " Leave it out for "
                << (defaultLimit[k] > 0 ? "its default" : "no such limit")
                << exit(FatalIOError);
        }
    }
}


void Foam::demTimeStepControl::evaluate(const bool adjust, const scalar Co, const scalar maxCo)
{
    read(maxCo);
    value_[FLUID] = Co;
    value_[PARTICLES] = cloud_.courant();
    value_[VOLUME] = cloud_.volume().changeRate()*time_.deltaTValue();
    value_[RELAXATION] = cloud_.exchange().relaxationRate()*time_.deltaTValue();

    Info<< "Particle Courant Number max: " << value_[PARTICLES]
        << ", change of void fraction " << value_[VOLUME];
    if (value_[RELAXATION] > 0)
    {
        Info<< ", step over relaxation time " << value_[RELAXATION];
    }
    Info<< endl;

    if (!adjust)
    {
        report();
    }
}


Foam::scalar Foam::demTimeStepControl::particleRatio(const scalar deltaT, word& name)
{
    read(1);
    const scalar scale = deltaT/time_.deltaTValue();
    value_[FLUID] = 0;
    value_[PARTICLES] = cloud_.courant()*scale;
    value_[VOLUME] = cloud_.volume().changeRate()*deltaT;
    value_[RELAXATION] = cloud_.exchange().relaxationRate()*deltaT;
    name = this->name();
    return limitRatio();
}


void Foam::demTimeStepControl::report()
{
    for (label k = 0; k < names_.size(); ++k)
    {
        const scalar limit = limit_[k] > 0 ? limit_[k] : relaxationWarning;
        if (!reported_[k] && value_[k] > limit)
        {
            reported_[k] = 1;
            Info<< "Suna: deltaT " << time_.deltaTValue() << " s is long: " << what_[k].c_str()
                << " " << value_[k] << ", above " << limit << " (" << names_[k]
                << "); take " << time_.deltaTValue()*limit/value_[k]
                << " s, or adjustTimeStep yes" << endl;
        }
    }
}


Foam::label Foam::demTimeStepControl::limiting() const
{
    label tightest = FLUID;
    for (label k = 0; k < names_.size(); ++k)
    {
        if (limit_[k] > 0 && value_[k]*limit_[tightest] > value_[tightest]*limit_[k])
        {
            tightest = k;
        }
    }
    return tightest;
}


Foam::scalar Foam::demTimeStepControl::limitRatio() const
{
    const label tightest = limiting();
    return value_[tightest]/limit_[tightest];
}
