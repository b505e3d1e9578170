/*---------------------------------------------------------------------------*\
    demOutletPatch.C -- nearest boundary patch on a line and the boundary face nearest
    to a point, over all ranks.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demOutletPatch.H"
#include "demPassable.H"
#include "DynamicList.H"
#include "StringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::demOutletPatch::distanceTo
(
    const point& from,
    const point& to,
    label& patch
) const
{
    if (!tree_)
    {
        return GREAT;
    }

    const pointIndexHit hit(tree_().findLine(from, to));
    if (!hit.hit())
    {
        return GREAT;
    }

    patch = mesh_.boundaryMesh().whichPatch(faces_[hit.index()]);
    return mag(hit.hitPoint() - from);
}


Foam::labelList Foam::demOutletPatch::nearest
(
    const UList<point>& points,
    const UList<vector>& velocities,
    scalarList& distance
) const
{
    // Twice the diagonal: long enough to cross the mesh from any start
    const scalar length = 2*mesh_.bounds().mag();

    // 2 patch + (1: behind); patches other than processor patches have the same
    // number on all ranks
    distance.setSize(points.size());
    distance = GREAT;
    labelList code(points.size(), -1);

    forAll(points, k)
    {
        const scalar speed = mag(velocities[k]);
        const vector line(length*velocities[k]/(speed + VSMALL));

        for (label behind = 0; speed > 0 && behind < 2; behind++)
        {
            label patch = -1;
            const scalar d =
                distanceTo(points[k], points[k] + (behind ? -line : line), patch);

            if (d < distance[k])
            {
                distance[k] = d;
                code[k] = 2*patch + behind;
            }
        }
    }

    const scalarList own(distance);
    Pstream::listCombineGather(distance, minEqOp<scalar>());
    demBroadcast(distance);
    forAll(code, k)
    {
        code[k] = own[k] <= distance[k] ? code[k] : -1;
    }
    Pstream::listCombineGather(code, maxEqOp<label>());
    demBroadcast(code);
    return code;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demOutletPatch::demOutletPatch(const fvMesh& mesh)
:
    mesh_(mesh)
{
    DynamicList<label> faces;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        forAll(patch, k)
        {
            if (!demPassable::is(patch))
            {
                faces.append(patch.start() + k);
            }
        }
    }
    faces_.transfer(faces);

    if (faces_.size())
    {
        // The octree needs a margin around the faces
        const vector margin(1e-4*mesh.bounds().mag()*vector::one);
        const treeBoundBox box
        (
            mesh.bounds().min() - margin,
            mesh.bounds().max() + margin
        );

        tree_.reset
        (
            new indexedOctree<treeDataFace>
            (
                treeDataFace(false, mesh, faces_),
                box,
                8,      // maximum number of levels
                10,     // faces in a leaf
                3.0     // maximum of the mean number of leaves of a face
            )
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::string> Foam::demOutletPatch::describe
(
    const UList<point>& points,
    const UList<vector>& velocities
) const
{
    scalarList distance;
    const labelList code(nearest(points, velocities, distance));

    List<string> texts(points.size());
    forAll(texts, k)
    {
        if (code[k] >= 0)
        {
            OStringStream os;
            os  << "; out through patch " << mesh_.boundary()[code[k]/2].name()
                << ", " << distance[k] << " m "
                << (code[k] % 2 ? "behind" : "ahead");
            texts[k] = os.str();
        }
    }
    return texts;
}


Foam::scalar Foam::demOutletPatch::warp(const label facei) const
{
    const vector n(mesh_.faceAreas()[facei]/(mag(mesh_.faceAreas()[facei]) + VSMALL));
    scalar largest = 0;

    for (const label pointi : mesh_.faces()[facei])
    {
        const vector arm(mesh_.points()[pointi] - mesh_.faceCentres()[facei]);
        largest = max(largest, mag(arm & n));
    }
    return largest;
}


Foam::List<Foam::demOutletPatch::boundaryPoint> Foam::demOutletPatch::relate
(
    const UList<point>& from,
    const UList<point>& to
) const
{
    const label n = to.size();
    const label self = Pstream::myProcNo();

    // per point: along the line, to the nearest face
    scalarList distance(2*n, GREAT);
    labelList patch(2*n, -1), face(n, -1);

    for (label k = 0; tree_ && k < n; k++)
    {
        distance[2*k] = distanceTo(from[k], to[k], patch[2*k]);

        const pointIndexHit hit(tree_().findNearest(to[k], sqr(GREAT)));
        if (hit.hit())
        {
            face[k] = faces_[hit.index()];
            distance[2*k + 1] = mag(hit.hitPoint() - to[k]);
            patch[2*k + 1] = mesh_.boundaryMesh().whichPatch(face[k]);
        }
    }

    // the smallest distance of all ranks, of equal ones the lowest rank
    scalarList smallest(distance);
    Pstream::listCombineGather(smallest, minEqOp<scalar>());
    demBroadcast(smallest);
    labelList rank(2*n);
    forAll(rank, k)
    {
        rank[k] = patch[k] >= 0 && distance[k] <= smallest[k] ? self : labelMax;
    }
    Pstream::listCombineGather(rank, minEqOp<label>());
    demBroadcast(rank);

    labelList cell(n, -1);
    scalarList warped(n, Zero);
    forAll(patch, k)
    {
        patch[k] = rank[k] == self ? patch[k] : -1;
        if (rank[k] == self && k % 2)
        {
            cell[k/2] = mesh_.faceOwner()[face[k/2]];
            warped[k/2] = warp(face[k/2]);
        }
    }
    Pstream::listCombineGather(patch, maxEqOp<label>());
    demBroadcast(patch);
    Pstream::listCombineGather(cell, maxEqOp<label>());
    demBroadcast(cell);
    Pstream::listCombineGather(warped, maxEqOp<scalar>());
    demBroadcast(warped);

    List<boundaryPoint> points(n);
    forAll(points, k)
    {
        points[k] = boundaryPoint
        {
            patch[2*k], patch[2*k + 1], rank[2*k + 1], cell[k], smallest[2*k + 1], warped[k]
        };
    }
    return points;
}

// ************************************************************************* //
