/*---------------------------------------------------------------------------*\
    demCloudRoom.C -- the flux of the particles' volume, and where it tells nothing.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demColumns.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// `share` of each particle's volume that the fluid sees. It has gone a way in
// the step, which is not its end's velocity times the step: where light ones
// pack, that alternates. Without fluid forces the core keeps no ways.
void Foam::demCloud::depositFlux(const UList<scalar>& share)
{
    vectorField carried(view_.n);

    forAll(carried, i)
    {
        carried[i] =
            share[i]
           *(
                fluid_.way
              ? three(fluid_.way, i)/window_
              : velocity(view_, i)
            );
    }
    transfer_.deposit(carried, solidFlux_.ref());
    solidFlux_.correctBoundaryConditions();

    // Near patches the share grows on the way
    if (flows_.active())
    {
        scalarField whole;
        transfer_.deposit(volumes(view_), whole);
        markUnlike(whole, 1 - voidFraction_.primitiveField());
    }
}


// Where the particles' volume changes by who comes and goes, in all of a cell
// or in what patches let see of it, no flux tells of that
void Foam::demCloud::markUnlike
(
    const UList<scalar>& a,
    const UList<scalar>& b
)
{
    unlike_.setSize(mesh_.nCells(), false);

    forAll(unlike_, celli)
    {
        if (mag(a[celli] - b[celli]) > 1e-9)
        {
            unlike_[celli] = true;
        }
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::demCloud::clearUnlike(UList<scalar>& cells) const
{
    forAll(unlike_, celli)
    {
        if (unlike_[celli])
        {
            cells[celli] = 0;
        }
    }
}


// ************************************************************************* //
