/*---------------------------------------------------------------------------*\
    demWalls.C -- pass wall patches and surface files to the core as triangles.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demWalls.H"
#include "dem_query.h"
#include "demCheck.H"
#include "demDomain.H"
#include "demPassable.H"
#include "demWedge.H"
#include "DynamicList.H"
#include "OSspecific.H"
#include "Time.H"
#include "triSurface.H"

namespace Foam
{

static List<double> triangles(const pointField& corners)
{
    return List<double>
    (
        UList<double>
        (
            const_cast<double*>(reinterpret_cast<const double*>(corners.cdata())),
            3*corners.size()
        )
    );
}


// Coordinates of triangles, nine numbers each
static List<double> triangles
(
    const labelUList& corners,
    const pointField& points
)
{
    List<double> numbers(3*corners.size());
    label n = 0;

    for (const label pointi : corners)
    {
        for (direction k = 0; k < 3; k++)
        {
            numbers[n++] = points[pointi][k];
        }
    }

    return numbers;
}


// Triangles of a surface file: the master reads them all, the other ranks have none
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


static void addWall
(
    ::dem_case* c,
    const word& name,
    const word& material,
    const List<double>& corners
)
{
    demCheck
    (
        dem_case_add_wall
        (
            c,
            name.c_str(),
            material.c_str(),
            corners.size()/9,
            corners.cdata()
        )
    );
}

} // End namespace Foam


// Processor patches come last, so all ranks reach the collective calls for the other
// patches in the same order
bool Foam::demWalls::isWall(const polyPatch& patch) const
{
    return !demPassable::is(patch) && dict_.isWall(patch);
}


Foam::labelList Foam::demWalls::triangulate
(
    const polyPatch& patch,
    const pointField& points
) const
{
    DynamicList<face> split(2*patch.size());

    forAll(patch, i)
    {
        patch[i].triangles(points, split);
    }

    labelList corners(3*split.size());

    forAll(corners, k)
    {
        corners[k] = split[k/3][k%3];
    }
    return corners;
}


template<class Move>
void Foam::demWalls::movePatches(const Move& move)
{
    if (corners_.empty())
    {
        const tmp<pointField> tpoints(demDomain::firstPoints(mesh_));

        corners_.setSize(mesh_.boundaryMesh().size());
        for (const polyPatch& patch : mesh_.boundaryMesh())
        {
            if (isWall(patch))
            {
                corners_[patch.index()] = triangulate(patch, tpoints());
            }
        }
    }

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isWall(patch))
        {
            move
            (
                patch.name().c_str(),
                triangles(corners_[patch.index()], mesh_.points())
            );
        }
    }
}


Foam::demWalls::demWalls(const polyMesh& mesh, const demDict& dict)
:
    mesh_(mesh),
    dict_(dict)
{}


Foam::label Foam::demWalls::add(::dem_case* c)
{
    const tmp<pointField> tpoints(demDomain::firstPoints(mesh_));
    autoPtr<demWedge> wedge;
    label walls = 0;

    if (demWedge::is(mesh_))
    {
        wedge.reset(new demWedge(mesh_));
        wedge().check(dict_);
    }

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isWall(patch))
        {
            addWall
            (
                c,
                patch.name(),
                dict_.material(patch),
                wedge.valid()
              ? triangles(wedge().sweep(patch, tpoints())())
              : triangles(triangulate(patch, tpoints()), tpoints())
            );
            walls++;
        }
    }

    if (mesh_.pointsInstance() != mesh_.facesInstance())
    {
        movePatches
        (
            [c](const char* name, const List<double>& corners)
            {
                demCheck(dem_case_move_wall(c, name, corners.size()/9, corners.cdata()));
            }
        );
    }

    forAllConstIters(dict_.surfaces(), iter)
    {
        const dictionary& wall = iter().dict();

        addWall
        (
            c,
            iter().keyword(),
            wall.get<word>("material"),
            triangles(mesh_.time(), wall)
        );
        walls++;
    }

    return walls;
}


void Foam::demWalls::move(::dem* d)
{
    for (int k = 0; k < dem_wall_count(d); k++)
    {
        if (dem_wall_wears(d, k) && mesh_.boundaryMesh().findPatchID(dem_wall_name(d, k)) >= 0)
        {
            FatalErrorInFunction
                << "walls/" << dem_wall_name(d, k) << "/wear: the mesh moves, and wear is summed on"
                << " patches at rest only; take it out" << exit(FatalError);
        }
    }

    movePatches
    (
        [d](const char* name, const List<double>& corners)
        {
            demCheck(dem_wall_move(d, name, corners.size()/9, corners.cdata()));
        }
    );
}
