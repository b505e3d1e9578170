/*---------------------------------------------------------------------------*\
    demInletsOutletsJudge.C -- particles and bodies outside the mesh: have they passed an
    outlet, do they touch a wall, or are they lost?

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demInletsOutlets.H"
#include "demColumns.H"
#include <cmath>
#include <map>

Foam::List<Foam::demOutletPatch::boundaryPoint> Foam::demInletsOutlets::relate
(
    const UList<point>& from,
    const UList<point>& to
)
{
    // Any rank may own the faces
    const label self = Pstream::myProcNo();
    pointField own(2*to.size());
    forAll(to, k)
    {
        own[2*k] = from[k];
        own[2*k + 1] = to[k];
    }
    const List<pointField> lines(demGather(own));

    label first = 0, n = 0;
    forAll(lines, rank)
    {
        first = rank == self ? n : first;
        n += lines[rank].size()/2;
    }
    pointField start(n), end(n);
    label i = 0;
    for (const pointField& points : lines)
    {
        for (label k = 0; k < points.size(); k += 2, i++)
        {
            start[i] = points[k];
            end[i] = points[k + 1];
        }
    }

    if (!outletPatch_ || mesh_.moving())
    {
        outletPatch_.reset(new demOutletPatch(mesh_, outlets_));
    }
    const List<demOutletPatch::boundaryPoint> points(outletPatch_().relate(start, end));

    return SubList<demOutletPatch::boundaryPoint>(points, to.size(), first);
}


Foam::label Foam::demInletsOutlets::outletOf
(
    const demOutletPatch::boundaryPoint& at,
    const scalar radius
) const
{
    const bool throughWall = at.exit >= 0 && isWall_[at.exit];

    return
        outlets_.found(at.exit) ? at.exit
      : outlets_.found(at.patch) && (!throughWall || at.distance <= radius) ? at.patch
      : -1;
}


void Foam::demInletsOutlets::judgeBodies
(
    const demView& view,
    const UList<label>& particles,
    const UList<point>& from
)
{
    std::map<int64_t, label> bodies;
    DynamicList<label> sphere;    // one of each body, and a point of the mesh
    DynamicList<point> start;

    forAll(particles, k)
    {
        const int64_t body = clumpOf(view, particles[k]);
        if (body && bodies.emplace(body, sphere.size()).second)
        {
            sphere.append(particles[k]);
            start.append(from[k]);
        }
    }

    // The mean of the spheres by mass is the centre of mass of the body
    scalarField mass(sphere.size(), Zero);
    pointField centre(sphere.size(), Zero);
    labelList bodyOf(bodies.empty() ? 0 : label(view.n), -1);
    forAll(bodyOf, i)
    {
        const auto found = bodies.find(clumpOf(view, i));
        if (found == bodies.end())
        {
            continue;
        }
        const label b = bodyOf[i] = found->second;
        const scalar m = *dem_at(view.mass, view.stride, size_t(i));
        vector d(position(view, i) - position(view, sphere[b]));

        for (direction c = 0; c < 3; c++)
        {
            d[c] -= view.period[c] > 0 ? view.period[c]*std::round(d[c]/view.period[c]) : 0;
        }
        mass[b] += m;
        centre[b] += m*d;
    }
    forAll(centre, b)
    {
        centre[b] = position(view, sphere[b]) + centre[b]/mass[b];
    }

    const List<demOutletPatch::boundaryPoint> points(relate(start, centre));
    forAll(bodyOf, i)
    {
        const label b = bodyOf[i];
        const label outlet =
            b < 0 || points[b].exit < 0 ? -1
          : outletOf(points[b], *dem_at(view.radius, view.stride, size_t(sphere[b])));

        if (outlet >= 0)
        {
            outgoingId_.append(idOf(view, i));
            outgoingPatch_.append(outlet);
        }
    }
}


Foam::List<Foam::demParticleRouting::verdict> Foam::demInletsOutlets::judge
(
    const demView& view,
    const UList<label>& particles,
    const UList<point>& from,
    const UList<demParticleRouting::verdict>& nearest
)
{
    pointField to(particles.size());
    forAll(particles, k)
    {
        to[k] = position(view, particles[k]);
    }
    const List<demOutletPatch::boundaryPoint> points(relate(from, to));

    outgoingId_.clear();
    outgoingPatch_.clear();

    List<demParticleRouting::verdict> verdicts(nearest);
    forAll(particles, k)
    {
        const demOutletPatch::boundaryPoint& at = points[k];
        const scalar radius = *dem_at(view.radius, view.stride, size_t(particles[k]));
        const bool atWall =
            at.patch >= 0 && isWall_[at.patch] && at.distance <= radius + at.warp;
        const label outlet = outletOf(at, radius);

        if (outlet >= 0 && !isOfClump(view, particles[k]))
        {
            outgoingId_.append(idOf(view, particles[k]));
            outgoingPatch_.append(outlet);
        }
        if (outlet >= 0 || atWall)
        {
            verdicts[k] = demParticleRouting::verdict{false, at.rank, at.cell};
        }
        else if (at.exit >= 0)
        {
            verdicts[k].lost = true;
        }
    }
    if (view.clump)
    {
        judgeBodies(view, particles, from);
    }
    return verdicts;
}
