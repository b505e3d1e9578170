/*---------------------------------------------------------------------------*\
    demOutletPatch.C -- nearest boundary patch on a line and the boundary face nearest
    to a point, over all ranks.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demOutletPatch.H"
#include "demPassable.H"
#include "DynamicList.H"
#include "StringStream.H"

namespace Foam
{
    // Distances that differ by less than this fraction of the size of the mesh are equal
    static const scalar maxRoundOff = 1e-10;

    // A line through an edge meets its faces: how far beside a triangle, as a fraction of
    // its size
    static const scalar edgeTolerance = 1e-8;

    // 0 for a patch that comes first, else 1; centre of the face; centre of its cell
    typedef FixedList<scalar, 7> demFaceKey;

    struct demFirstKey
    {
        void operator()(demFaceKey& x, const demFaceKey& y) const
        {
            x = y < x ? y : x;
        }
    };


    // The result of op over all ranks, on all ranks. Collective.
    template<class Type, class Op>
    static void combine(List<Type>& values, const Op& op)
    {
        Pstream::listCombineGather(values, op);
        demBroadcast(values);
    }
}


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
    combine(distance, minEqOp<scalar>());
    forAll(code, k)
    {
        code[k] = own[k] <= distance[k] ? code[k] : -1;
    }
    combine(code, maxEqOp<label>());
    return code;
}


Foam::scalar Foam::demOutletPatch::exitDistance(const point& from, const point& to) const
{
    // Test each face: which faces a search tree tests depends on the others
    const vector line(to - from);
    const vector reach(maxRoundOff*mesh_.bounds().mag()*vector::one);
    const treeBoundBox box(min(from, to) - reach, max(from, to) + reach);
    scalar least = GREAT;

    for (const label i : tree_().findBox(box))
    {
        const label facei = faces_[i];
        const pointHit hit
        (
            mesh_.faces()[facei].intersection
            (
                from,
                line,
                mesh_.faceCentres()[facei],
                mesh_.points(),
                intersection::HALF_RAY,
                edgeTolerance
            )
        );
        if (hit.hit() && hit.distance() <= 1)
        {
            least = min(least, hit.distance()*mag(line));
        }
    }
    return least;
}


void Foam::demOutletPatch::firstFaces
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    labelList& faces,
    labelList& ranks
) const
{
    List<demFaceKey> keys(centres.size(), demFaceKey(GREAT));

    faces.setSize(centres.size());
    faces = -1;
    for (label k = 0; tree_ && k < centres.size(); k++)
    {
        if (radii[k] < 0)
        {
            continue;
        }
        const vector reach(1.01*radii[k]*vector::one);
        for (const label i : tree_().findBox(treeBoundBox(centres[k] - reach, centres[k] + reach)))
        {
            const label facei = faces_[i];
            const pointHit hit(mesh_.faces()[facei].nearestPoint(centres[k], mesh_.points()));
            if (hit.distance() > radii[k])
            {
                continue;
            }
            const point& c = mesh_.faceCentres()[facei];
            const point& behind = mesh_.cellCentres()[mesh_.faceOwner()[facei]];
            demFaceKey mine;
            mine[0] = isFirst_[mesh_.boundaryMesh().whichPatch(facei)] ? 0 : 1;
            for (direction d = 0; d < 3; d++)
            {
                mine[1 + d] = c[d];
                mine[4 + d] = behind[d];
            }
            if (faces[k] < 0 || mine < keys[k])
            {
                faces[k] = facei;
                keys[k] = mine;
            }
        }
    }

    List<demFaceKey> firstKeys(keys);
    combine(firstKeys, demFirstKey());

    // two ranks have equal keys only if two cells coincide
    ranks.setSize(centres.size());
    forAll(ranks, k)
    {
        const bool isFirst = faces[k] >= 0 && !(firstKeys[k] < keys[k]);
        ranks[k] = isFirst ? Pstream::myProcNo() : labelMax;
    }
    combine(ranks, minEqOp<label>());
    forAll(faces, k)
    {
        faces[k] = ranks[k] == Pstream::myProcNo() ? faces[k] : -1;
    }
}


Foam::demOutletPatch::demOutletPatch(const fvMesh& mesh, const labelUList& first)
:
    mesh_(mesh),
    isFirst_(mesh.boundaryMesh().size(), false)
{
    for (const label patchi : first)
    {
        isFirst_[patchi] = true;
    }

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


Foam::List<Foam::string> Foam::demOutletPatch::describe
(
    const UList<point>& points,
    const UList<vector>& velocities,
    labelList* patch
) const
{
    scalarList distance;
    const labelList code(nearest(points, velocities, distance));

    List<string> texts(points.size());
    if (patch)
    {
        *patch = labelList(points.size(), -1);
    }
    forAll(texts, k)
    {
        if (code[k] >= 0)
        {
            OStringStream os;
            os  << "; out through patch " << mesh_.boundary()[code[k]/2].name()
                << ", " << distance[k] << " m "
                << (code[k] % 2 ? "behind" : "ahead");
            texts[k] = os.str();
            if (patch)
            {
                (*patch)[k] = code[k]/2;
            }
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

    // per point: along the line, to the nearest face
    scalarList distance(2*n, GREAT);
    for (label k = 0; tree_ && k < n; k++)
    {
        distance[2*k] = exitDistance(from[k], to[k]);

        const pointIndexHit hit(tree_().findNearest(to[k], sqr(GREAT)));
        if (hit.hit())
        {
            distance[2*k + 1] = mag(hit.hitPoint() - to[k]);
        }
    }
    combine(distance, minEqOp<scalar>());

    // faces that touch the ball around where the line leaves the mesh, or around the point
    pointField centres(2*n);
    scalarField radii(2*n);
    const scalar roundOff = maxRoundOff*mesh_.bounds().mag();
    forAll(centres, k)
    {
        const point& start = from[k/2];
        const vector line(to[k/2] - start);

        centres[k] = k % 2 ? to[k/2] : start + distance[k]/(mag(line) + VSMALL)*line;
        radii[k] =
            distance[k] >= GREAT ? -1
          : k % 2 ? distance[k] + roundOff
          : roundOff;
    }
    labelList face, rank;
    firstFaces(centres, radii, face, rank);

    labelList patch(2*n, -1), cell(n, -1);
    scalarList warped(n, Zero);
    forAll(patch, k)
    {
        if (face[k] >= 0)
        {
            patch[k] = mesh_.boundaryMesh().whichPatch(face[k]);
        }
        if (face[k] >= 0 && k % 2)
        {
            cell[k/2] = mesh_.faceOwner()[face[k]];
            warped[k/2] = warp(face[k]);
        }
    }
    combine(patch, maxEqOp<label>());
    combine(cell, maxEqOp<label>());
    combine(warped, maxEqOp<scalar>());

    List<boundaryPoint> points(n);
    forAll(points, k)
    {
        points[k] = boundaryPoint
        {
            patch[2*k], patch[2*k + 1], rank[2*k + 1], cell[k], distance[2*k + 1], warped[k]
        };
    }
    return points;
}
