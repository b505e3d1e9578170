/*---------------------------------------------------------------------------*\
    demPace.C -- which criterion bounds the step.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demPace.H"
#include "Time.H"

namespace Foam
{
    // Beyond this a step is longer than the particles' time of relaxation, which
    // the user should know
    static const scalar relaxed = 1;
}


Foam::demPace::demPace(const Time& time, demCloud& cloud)
:
    time_(time),
    cloud_(cloud),
    names_({"maxCo", "maxParticleCo", "maxVoidFractionChange", "maxRelaxation"}),
    value_(nCriteria, Zero),
    most_(nCriteria, Zero),
    told_(nCriteria, Zero)
{}


void Foam::demPace::read(const scalar maxCo)
{
    const scalar usual[nCriteria] = {maxCo, 0.5, 0.1, 0};

    most_[FLUID] = maxCo;
    for (label k = PARTICLES; k < nCriteria; ++k)
    {
        const dictionary& control = time_.controlDict();
        most_[k] = control.getOrDefault<scalar>(names_[k], usual[k]);
        if (most_[k] < 0 || (control.found(names_[k]) && most_[k] == 0))
        {
            FatalIOErrorInFunction(control)
                << names_[k] << " is " << most_[k] << "; it must be positive."
                << " Leave it out for "
                << (usual[k] > 0 ? "its default" : "no such bound")
                << exit(FatalIOError);
        }
    }
}


void Foam::demPace::look(const bool adjust, const scalar Co, const scalar maxCo)
{
    read(maxCo);
    value_[FLUID] = Co;
    value_[PARTICLES] = cloud_.courant();
    value_[VOLUME] = cloud_.changeRate()*time_.deltaTValue();
    value_[RELAXATION] = cloud_.relaxationRate()*time_.deltaTValue();

    Info<< "Particle Courant Number max: " << value_[PARTICLES]
        << ", change of void fraction " << value_[VOLUME];
    if (value_[RELAXATION] > 0)
    {
        Info<< ", step over time of relaxation " << value_[RELAXATION];
    }
    Info<< endl;

    if (!adjust)
    {
        tell();
    }
}


void Foam::demPace::tell()
{
    static const char* says[nCriteria] =
    {
        "fluid crosses cells", "a particle crosses lengths of the kernel or cells",
        "the void fraction of a cell changes", "times of relaxation of a particle in a step"
    };
    for (label k = 0; k < nCriteria; ++k)
    {
        const scalar most = most_[k] > 0 ? most_[k] : relaxed;
        if (!told_[k] && value_[k] > most)
        {
            told_[k] = 1;
            Info<< "Suna: deltaT " << time_.deltaTValue() << " s is long: " << says[k]
                << ": " << value_[k] << ", more than " << most << " (" << names_[k]
                << "); take " << time_.deltaTValue()*most/value_[k]
                << " s, or adjustTimeStep yes" << endl;
        }
    }
}


Foam::label Foam::demPace::pressing() const
{
    label worst = FLUID;
    for (label k = 0; k < nCriteria; ++k)
    {
        if (most_[k] > 0 && value_[k]*most_[worst] > value_[worst]*most_[k])
        {
            worst = k;
        }
    }
    return worst;
}


Foam::scalar Foam::demPace::strain() const
{
    const label worst = pressing();
    return value_[worst]/most_[worst];
}


// ************************************************************************* //
