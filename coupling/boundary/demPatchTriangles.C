/*---------------------------------------------------------------------------*\
    demPatchTriangles.C -- distances of particles from patches, as triangles on all ranks.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demPatchTriangles.H"
#include "demColumns.H"
#include "DynamicList.H"
#include "triPointRef.H"

Foam::pointField Foam::demPatchTriangles::of(const polyPatch& patch, labelList& face)
{
    DynamicList<::Foam::face> split(2*patch.size());
    DynamicList<label> index(2*patch.size());

    forAll(patch, i)
    {
        patch[i].triangles(patch.points(), split);
        while (index.size() < split.size())
        {
            index.append(i);
        }
    }

    pointField points(3*split.size());
    forAll(points, k)
    {
        points[k] = patch.points()[split[k/3][k%3]];
    }
    face.transfer(index);
    return points;
}


void Foam::demPatchTriangles::gather(const polyMesh& mesh, const labelUList& patches)
{
    triangles_.setSize(patches.size());
    bounds_.setSize(patches.size());
    forAll(patches, k)
    {
        labelList face;

        triangles_[k].clear();
        for (const pointField& points : demGather(of(mesh.boundaryMesh()[patches[k]], face)))
        {
            triangles_[k].append(points);
        }
        bounds_[k] = treeBoundBox(triangles_[k]);
    }
}


void Foam::demPatchTriangles::distances
(
    const demView& view,
    labelList& patch,
    scalarField& distance,
    boolList& beyond
) const
{
    patch = labelList(label(view.n), -1);
    distance = scalarField(label(view.n), 1);
    beyond = boolList(label(view.n), false);

    forAll(triangles_, k)
    {
        forAll(patch, i)
        {
            const scalar d = 2*(*dem_at(view.radius, view.stride, size_t(i)));
            const point x(position(view, i));

            if
            (
                magSqr(max(min(x, bounds_[k].max()), bounds_[k].min()) - x) >= sqr(d)
            )
            {
                continue;
            }
            for (label t = 0; t < triangles_[k].size(); t += 3)
            {
                const pointField& p = triangles_[k];
                const scalar h =
                    triPointRef(p[t], p[t + 1], p[t + 2]).nearestPoint(x)
                   .distance();

                if (h < distance[i]*d)
                {
                    // Outside: on the normal of the nearest triangle, not beside it
                    const vector n((p[t + 1] - p[t]) ^ (p[t + 2] - p[t]));
                    beyond[i] = (n & (x - p[t])) > 0.9*h*mag(n);
                    distance[i] = h/d;
                    patch[i] = k;
                }
            }
        }
    }
}


Foam::scalar Foam::demPatchTriangles::distance(const label k, const point& x) const
{
    const pointField& p = triangles_[k];
    scalar least = GREAT;

    for (label t = 0; t < p.size(); t += 3)
    {
        least = min(least, triPointRef(p[t], p[t + 1], p[t + 2]).nearestPoint(x).distance());
    }
    return least;
}
