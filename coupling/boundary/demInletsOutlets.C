/*---------------------------------------------------------------------------*\
    demInletsOutlets.C -- inlet and outlet patches of particles, and the void fraction near
    them.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demInletsOutlets.H"
#include "dem_fluid.h"
#include "demCheck.H"
#include "demColumns.H"
#include "demPassable.H"
#include "OSspecific.H"
#include "Time.H"
#include <cmath>
#include <map>

Foam::labelList Foam::demInletsOutlets::patches
(
    const dictionary& groups,
    const demDict& dict
) const
{
    DynamicList<label> found;

    forAllConstIters(groups, iter)
    {
        word name;
        if (!iter().isDict() || !iter().dict().readIfPresent("patch", name))
        {
            continue;
        }

        const dictionary& group = iter().dict();
        const label patchi = mesh_.boundaryMesh().findPatchID(name);
        if (patchi < 0)
        {
            demUnknown
            (
                group,
                groups.dictName() + "/" + iter().keyword(),
                "patch",
                name,
                mesh_.boundaryMesh().names()
            );
        }

        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        if (demPassable::is(patch) || dict.isWall(patch))
        {
            const std::string what
            (
                demPassable::is(patch) ? "of type " + patch.type()
                                : "a wall of the particles"
            );

            FatalIOErrorInFunction(group)
                << groups.dictName() << "/" << iter().keyword() << ": patch "
                << name << " is " << what.c_str()
                << ", which particles cannot pass; name a patch of type"
                << " patch, or take it out of the walls" << exit(FatalIOError);
        }
        if (!found.found(patchi))
        {
            found.append(patchi);
        }
    }
    return labelList(found);
}


template<class Give>
void Foam::demInletsOutlets::givePatches
(
    const Give& give,
    const volVectorField* U
) const
{
    for (const label patchi : inlets_)
    {
        labelList face;
        const pointField points(demPatchTriangles::of(mesh_.boundaryMesh()[patchi], face));
        List<double> velocity(3*face.size(), Zero);

        for (label k = 0; U && k < face.size(); k++)
        {
            const vector& u = U->boundaryField()[patchi][face[k]];
            for (direction c = 0; c < 3; c++)
            {
                velocity[3*k + c] = u[c];
            }
        }

        demCheck
        (
            give
            (
                mesh_.boundaryMesh()[patchi].name().c_str(),
                face.size(),
                reinterpret_cast<const double*>(points.cdata()),
                velocity.cdata()
            )
        );
    }
}


// Does a wall absorb particles?
bool Foam::demInletsOutlets::absorbs(const dictionary& walls)
{
    bool any = false;

    forAllConstIters(walls, iter)
    {
        any = any || (iter().isDict() && iter().dict().getOrDefault<Switch>("absorb", false));
    }
    return any;
}


bool Foam::demInletsOutlets::withoutPatch(const dictionary& groups, const bool streamsOnly)
{
    bool any = false;

    forAllConstIters(groups, iter)
    {
        any = any
         || (
                iter().isDict() && !iter().dict().found("patch")
             && (!streamsOnly || iter().dict().getOrDefault<word>("type", "") == "stream")
            );
    }
    return any;
}


Foam::demInletsOutlets::demInletsOutlets(const fvMesh& mesh, const demDict& dict)
:
    mesh_(mesh),
    inlets_(patches(dict.scene().subOrEmptyDict("insert"), dict)),
    outlets_(patches(dict.scene().subOrEmptyDict("outlets"), dict)),
    isWall_(mesh.boundaryMesh().size()),
    absorbs_(absorbs(dict.scene().subOrEmptyDict("walls"))),
    regions_
    (
        withoutPatch(dict.scene().subOrEmptyDict("insert"), true)
     || withoutPatch(dict.scene().subOrEmptyDict("outlets"), false)
    ),
    passages_(inlets_)
{
    for (const label patchi : outlets_)
    {
        if (!passages_.found(patchi))
        {
            passages_.append(patchi);
        }
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        isWall_[patch.index()] = dict.isWall(patch);
    }
    triangles_.gather(mesh, passages_);
}


void Foam::demInletsOutlets::add(::dem_case* c)
{
    demCheck(dem_case_flows_on_request(c));
    givePatches
    (
        [c](const char* name, const label n, const double* points, const double* U)
        {
            return dem_case_add_patch(c, name, n, points, U);
        },
        nullptr
    );
}


bool Foam::demInletsOutlets::pass(::dem* d, const volVectorField& U)
{
    int changed = 0;

    if (mesh_.moving() && active())
    {
        triangles_.gather(mesh_, passages_);
    }
    givePatches
    (
        [d](const char* name, const label n, const double* points, const double* U)
        {
            return dem_flow_patch(d, name, n, points, U);
        },
        &U
    );

    forAll(outgoingId_, k)
    {
        const word& name = mesh_.boundaryMesh()[outgoingPatch_[k]].name();
        demCheck(dem_flow_remove(d, name.c_str(), 1, &outgoingId_[k]));
    }
    outgoingId_.clear();
    outgoingPatch_.clear();

    demCheck(dem_flow_apply(d, &changed));
    return changed;
}


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


Foam::labelList Foam::demInletsOutlets::reduceVolumes
(
    const demView& view,
    scalarField& volume
) const
{
    labelList passage;
    scalarField distance;
    boolList beyond;
    triangles_.distances(view, passage, distance, beyond);

    // A particle that has passed an outlet displaces no fluid, at any distance
    forAll(outgoingId_, k)
    {
        forAll(volume, i)
        {
            if (idOf(view, i) == outgoingId_[k])
            {
                distance[i] = 0;
                passage[i] = passages_.find(outgoingPatch_[k]);
            }
        }
    }

    forAll(volume, i)
    {
        const scalar t = beyond[i] ? 0 : distance[i];
        volume[i] *= t*t*(3 - 2*t);
    }
    return passage;
}


Foam::label Foam::demInletsOutlets::inletWithin(const point& x, const scalar reach) const
{
    label nearest = -1;
    scalar distance = reach;

    forAll(passages_, k)
    {
        if (inlets_.found(passages_[k]))
        {
            const scalar h = triangles_.distance(k, x);
            if (h <= distance)
            {
                distance = h;
                nearest = k;
            }
        }
    }
    return nearest;
}
