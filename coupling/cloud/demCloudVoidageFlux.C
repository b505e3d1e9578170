/*---------------------------------------------------------------------------*\
    demCloudVoidageFlux.C -- the volume flux of the particles for the continuity
    equation (demPimpleFoam/voidageFlux.H), and the cells where it is not defined.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demColumns.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// `volume` of each particle that the fluid sees [m3]. Its mean velocity is its
// displacement over the step: the velocity at the end of the step alternates
// where light particles pack. Without fluid forces the core has no displacements.
void Foam::demCloud::depositFlux(const UList<scalar>& volume)
{
    vectorField volumeFlux(view_.n);

    forAll(volumeFlux, i)
    {
        volumeFlux[i] =
            volume[i]
           *(
                fluid_.displacement
              ? vectorAt(fluid_.displacement, i)/window_
              : velocity(view_, i)
            );
    }
    transfer_.deposit(volumeFlux, solidFlux_.ref());
    solidFlux_.correctBoundaryConditions();

    // Near patches the volume that the fluid sees changes as particles move
    if (inletsOutlets_.active())
    {
        scalarField whole;
        transfer_.deposit(volumes(view_), whole);
        markJumps(whole, 1 - voidFraction_.primitiveField());
    }
}


// Mark cells where two solid fractions differ: there the particles' volume changes
// by inflow and outflow, not by a flux between cells
void Foam::demCloud::markJumps
(
    const UList<scalar>& a,
    const UList<scalar>& b
)
{
    jumpCells_.setSize(mesh_.nCells(), false);

    forAll(jumpCells_, celli)
    {
        if (mag(a[celli] - b[celli]) > 1e-9)
        {
            jumpCells_[celli] = true;
        }
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::demCloud::clearJumps(UList<scalar>& cells) const
{
    forAll(jumpCells_, celli)
    {
        if (jumpCells_[celli])
        {
            cells[celli] = 0;
        }
    }
}


// ************************************************************************* //
