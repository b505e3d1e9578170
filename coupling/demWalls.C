/*---------------------------------------------------------------------------*\
    demWalls.C -- wall patches become triangles of the core.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demWalls.H"
#include "demCheck.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Nine numbers per triangle
static List<double> triangles(const polyPatch& patch)
{
    DynamicList<face> split(2*patch.size());

    forAll(patch, i)
    {
        patch[i].triangles(patch.points(), split);
    }

    List<double> corners(9*split.size());
    label n = 0;

    forAll(split, i)
    {
        for (label corner = 0; corner < 3; corner++)
        {
            const point& p = patch.points()[split[i][corner]];
            corners[n++] = p.x();
            corners[n++] = p.y();
            corners[n++] = p.z();
        }
    }

    return corners;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::demWalls::add
(
    ::dem* d,
    const polyMesh& mesh,
    const demDict& dict
)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    label walls = 0;

    forAll(patches, patchi)
    {
        // Patches to other ranks come last, so all ranks meet here in step
        const polyPatch& patch = patches[patchi];

        if (patch.coupled() || !dict.isWall(patch))
        {
            continue;
        }

        const List<double> corners(triangles(patch));

        demCheck
        (
            dem_add_wall
            (
                d,
                patch.name().c_str(),
                dict.material(patch).c_str(),
                corners.size()/9,
                corners.cdata()
            )
        );
        walls++;
    }

    return walls;
}

// ************************************************************************* //
