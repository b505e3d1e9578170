/*---------------------------------------------------------------------------*\
    demWayOut.C -- one line before and one behind each particle, on all ranks.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demWayOut.H"
#include "DynamicList.H"
#include "StringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::demWayOut::first
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


Foam::labelList Foam::demWayOut::nearest
(
    const UList<point>& points,
    const UList<vector>& velocities,
    scalarList& distance
) const
{
    // Twice the diagonal crosses the mesh from wherever it starts
    const scalar far = 2*mesh_.bounds().mag();

    // 2 patch + (1: behind); patches that are no seam between ranks have the
    // same number on all of them
    distance.setSize(points.size());
    distance = GREAT;
    labelList code(points.size(), -1);

    forAll(points, k)
    {
        const scalar speed = mag(velocities[k]);
        const vector way(far*velocities[k]/(speed + VSMALL));

        for (label behind = 0; speed > 0 && behind < 2; behind++)
        {
            label patch = -1;
            const scalar here =
                first(points[k], points[k] + (behind ? -way : way), patch);

            if (here < distance[k])
            {
                distance[k] = here;
                code[k] = 2*patch + behind;
            }
        }
    }

    const scalarList mine(distance);
    Pstream::listCombineGather(distance, minEqOp<scalar>());
    demBroadcast(distance);
    forAll(code, k)
    {
        code[k] = mine[k] <= distance[k] ? code[k] : -1;
    }
    Pstream::listCombineGather(code, maxEqOp<label>());
    demBroadcast(code);
    return code;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demWayOut::demWayOut(const fvMesh& mesh)
:
    mesh_(mesh)
{
    DynamicList<label> faces;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        forAll(patch, k)
        {
            if (!patch.coupled())
            {
                faces.append(patch.start() + k);
            }
        }
    }
    faces_.transfer(faces);

    if (faces_.size())
    {
        // An octree wants room around what it holds
        const vector room(1e-4*mesh.bounds().mag()*vector::one);
        const treeBoundBox box
        (
            mesh.bounds().min() - room,
            mesh.bounds().max() + room
        );

        tree_.reset
        (
            new indexedOctree<treeDataFace>
            (
                treeDataFace(false, mesh, faces_),
                box,
                8,      // levels at most
                10,     // faces in a leaf
                3.0     // times that a face may be listed, on average
            )
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::string> Foam::demWayOut::say
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


Foam::labelList Foam::demWayOut::patches
(
    const UList<point>& points,
    const UList<vector>& velocities
) const
{
    scalarList distance;
    labelList patch(nearest(points, velocities, distance));

    for (label& p : patch)
    {
        p = p < 0 ? -1 : p/2;
    }
    return patch;
}

// ************************************************************************* //
