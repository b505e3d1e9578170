/*---------------------------------------------------------------------------*\
    demSelfCheck.C -- limits of the balances that the coupling keeps by construction.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSelfCheck.H"
#include "demFailure.H"
#include "StringStream.H"
#include <cmath>

namespace Foam
{

static const scalar largestError = 1e-6;


// Not a number is above the limit, too: a comparison that raises no exception
static void check(const scalar error, const char* what, const char* cause)
{
    if (std::islessequal(error, largestError))
    {
        return;
    }

    OStringStream os;
    os.precision(3);            // whatever the case writes with
    os  << what << " is " << error << ", above the limit of " << largestError << ": " << cause;
    throw demFailure(os.str());
}

} // End namespace Foam


void Foam::demSelfCheck::momentum(const scalar error)
{
    check
    (
        error,
        "the error of the exchange of momentum, relative to its largest term,",
        "fluid and particles do not receive the same impulse. The fluid's velocity is not a"
        " number, or particles are in cells that overlap or that the solver does not solve"
    );
}


void Foam::demSelfCheck::heat(const scalar error)
{
    check
    (
        error,
        "the error of the exchange of heat, relative to its largest term,",
        "fluid and particles do not receive the same heat. The fluid's temperature is not a"
        " number, or particles are in cells that overlap or that the solver does not solve"
    );
}


void Foam::demSelfCheck::volume(const scalar error)
{
    check
    (
        error,
        "the error of the particles' volume in the mesh",
        "cells lack volume of particles, or have too much. The mesh is smaller than the"
        " particles in it, or its cells overlap (checkMesh)"
    );
}
