/*---------------------------------------------------------------------------*\
    demWalls.C -- wall patches and surfaces become triangles of the core.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demWalls.H"
#include "demCheck.H"
#include "DynamicList.H"
#include "OSspecific.H"
#include "Time.H"
#include "triSurface.H"

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

// The first rank reads the file, the others have no triangles of it
static List<double> triangles(const Time& time, const dictionary& wall)
{
    List<double> corners;

    if (!Pstream::master())
    {
        return corners;
    }

    const fileName file
    (
        time.globalPath()/"constant"/"triSurface"/wall.get<fileName>("file")
    );

    if (!isFile(file))
    {
        FatalIOErrorInFunction(wall)
            << "There is no file " << file << exit(FatalIOError);
    }

    const triSurface surface(file);
    const scalar scale = wall.getOrDefault<scalar>("scale", 1);
    label n = 0;

    corners.setSize(9*surface.size());
    for (const labelledTri& triangle : surface)
    {
        for (const label pointi : triangle)
        {
            for (direction k = 0; k < 3; k++)
            {
                corners[n++] = scale*surface.points()[pointi][k];
            }
        }
    }

    if (surface.empty())
    {
        FatalIOErrorInFunction(wall)
            << "The surface " << file << " holds no triangle"
            << exit(FatalIOError);
    }
    return corners;
}


static void hand
(
    ::dem* d,
    const word& name,
    const word& material,
    const List<double>& corners
)
{
    demCheck
    (
        dem_add_wall
        (
            d,
            name.c_str(),
            material.c_str(),
            corners.size()/9,
            corners.cdata()
        )
    );
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

        hand(d, patch.name(), dict.material(patch), triangles(patch));
        walls++;
    }

    forAllConstIters(dict.surfaces(), iter)
    {
        const dictionary& wall = iter().dict();

        hand
        (
            d,
            iter().keyword(),
            wall.get<word>("material"),
            triangles(mesh.time(), wall)
        );
        walls++;
    }

    return walls;
}

// ************************************************************************* //
