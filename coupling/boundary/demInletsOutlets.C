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
#include "emptyPolyPatch.H"
#include "Time.H"

Foam::labelList Foam::demInletsOutlets::patches
(
    const dictionary& groups,
    const demDict& dict
) const
{
    DynamicList<label> found;

    forAllConstIters(groups, iter)
    {
        if (!iter().isDict() || !iter().dict().found("patch"))
        {
            continue;
        }

        const dictionary& group = iter().dict();
        ITstream& given = group.lookup("patch");
        if (given.size() != 1)
        {
            FatalIOErrorInFunction(group)
                << groups.dictName() << "/" << iter().keyword() << ": patch needs one name;"
                << " make an entry for each patch" << exit(FatalIOError);
        }
        const word name(given);
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
        if (isA<emptyPolyPatch>(patch) || returnReduce(patch.size(), sumOp<label>()) == 0)
        {
            FatalIOErrorInFunction(group)
                << groups.dictName() << "/" << iter().keyword() << ": patch " << name
                << (isA<emptyPolyPatch>(patch) ? " is of type empty" : " has no faces")
                << ", so particles cannot pass it; name another one" << exit(FatalIOError);
        }
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
