/*---------------------------------------------------------------------------*\
    demFlows.C -- feeding patches, outlets, and what the fluid feels of them.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFlows.H"
#include "demCheck.H"
#include "demColumns.H"
#include "OSspecific.H"
#include "Time.H"
#include "triPointRef.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Three points a triangle, corners as the faces have them
static pointField trianglesOf(const polyPatch& patch, labelList& face)
{
    DynamicList<::Foam::face> split(2*patch.size());
    DynamicList<label> of(2*patch.size());

    forAll(patch, i)
    {
        patch[i].triangles(patch.points(), split);
        while (of.size() < split.size())
        {
            of.append(i);
        }
    }

    pointField points(3*split.size());
    forAll(points, k)
    {
        points[k] = patch.points()[split[k/3][k%3]];
    }
    face.transfer(of);
    return points;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::demFlows::patches
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
        if (patch.coupled() || dict.isWall(patch))
        {
            const std::string what
            (
                patch.coupled() ? "of type " + patch.type()
                                : "a wall of the particles"
            );

            FatalIOErrorInFunction(group)
                << groups.dictName() << "/" << iter().keyword() << ": patch "
                << name << " is " << what.c_str()
                << ", through which nobody comes or goes; name a patch of type"
                << " patch, or take it out of the walls" << exit(FatalIOError);
        }
        if (!found.found(patchi))
        {
            found.append(patchi);
        }
    }
    return labelList(found);
}


// Patches are small; each rank knows them whole
void Foam::demFlows::gather()
{
    labelList all(feeds_);
    for (const label patchi : outlets_)
    {
        if (!all.found(patchi))
        {
            all.append(patchi);
        }
    }

    open_.setSize(all.size());
    box_.setSize(all.size());
    forAll(all, k)
    {
        labelList face;
        List<pointField> parts(Pstream::nProcs());
        parts[Pstream::myProcNo()] =
            trianglesOf(mesh_.boundaryMesh()[all[k]], face);
        Pstream::gatherList(parts);
        Pstream::scatterList(parts);

        open_[k].clear();
        for (const pointField& part : parts)
        {
            open_[k].append(part);
        }
        box_[k] = treeBoundBox(open_[k]);
    }
}


void Foam::demFlows::hand(::dem* d, const volVectorField* U) const
{
    for (const label patchi : feeds_)
    {
        labelList face;
        const pointField points
        (
            trianglesOf(mesh_.boundaryMesh()[patchi], face)
        );
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
            dem_patch
            (
                d,
                mesh_.boundaryMesh()[patchi].name().c_str(),
                face.size(),
                reinterpret_cast<const double*>(points.cdata()),
                velocity.cdata()
            )
        );
    }
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demFlows::demFlows(const fvMesh& mesh, const demDict& dict)
:
    mesh_(mesh),
    feeds_(patches(dict.scene().subOrEmptyDict("insert"), dict)),
    outlets_(patches(dict.scene().subOrEmptyDict("outlets"), dict))
{
    gather();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demFlows::add(::dem* d)
{
    demCheck(dem_flow_between(d));
    hand(d, nullptr);
}


bool Foam::demFlows::pass(::dem* d, const volVectorField& U)
{
    int changed = 0;

    if (mesh_.moving() && active())
    {
        gather();
        wayOut_.clear();
    }
    hand(d, &U);

    forAll(gone_, k)
    {
        const word& name = mesh_.boundaryMesh()[through_[k]].name();
        demCheck(dem_take_out(d, name.c_str(), 1, &gone_[k]));
    }
    gone_.clear();
    through_.clear();

    demCheck(dem_let_through(d, &changed));
    return changed;
}


Foam::boolList Foam::demFlows::leave
(
    const demView& view,
    const UList<label>& who
)
{
    boolList leaves(who.size(), false);

    gone_.clear();
    through_.clear();
    if (outlets_.empty())
    {
        return leaves;
    }

    // Any rank may have the patch
    const label me = Pstream::myProcNo();
    List<pointField> points(Pstream::nProcs());
    List<vectorField> velocities(Pstream::nProcs());
    points[me].setSize(who.size());
    velocities[me].setSize(who.size());
    forAll(who, k)
    {
        const size_t i = size_t(who[k]);
        points[me][k] = three(dem_at(view.position, view.stride, i), 0);
        velocities[me][k] = three(dem_at(view.velocity, view.stride, i), 0);
    }
    Pstream::gatherList(points);
    Pstream::scatterList(points);
    Pstream::gatherList(velocities);
    Pstream::scatterList(velocities);

    pointField allPoints;
    vectorField allVelocities;
    label first = 0;
    forAll(points, rank)
    {
        first = rank == me ? allPoints.size() : first;
        allPoints.append(points[rank]);
        allVelocities.append(velocities[rank]);
    }

    if (!wayOut_)
    {
        wayOut_.reset(new demWayOut(mesh_));
    }
    const labelList patch(wayOut_().patches(allPoints, allVelocities));

    forAll(who, k)
    {
        leaves[k] = outlets_.found(patch[first + k]);
        if (leaves[k])
        {
            const char* ids = reinterpret_cast<const char*>(view.id);
            gone_.append
            (
                *reinterpret_cast<const int64_t*>
                (
                    ids + view.stride*size_t(who[k])
                )
            );
            through_.append(patch[first + k]);
        }
    }
    return leaves;
}


void Foam::demFlows::share(const demView& view, scalarField& volume) const
{
    scalarField least(volume.size(), GREAT);
    boolList beyond(volume.size(), false);

    forAll(open_, k)
    {
        forAll(volume, i)
        {
            const scalar d = 2*(*dem_at(view.radius, view.stride, size_t(i)));
            const point x(three(dem_at(view.position, view.stride, size_t(i)), 0));

            if
            (
                magSqr(max(min(x, box_[k].max()), box_[k].min()) - x) >= sqr(d)
            )
            {
                continue;
            }
            for (label t = 0; t < open_[k].size(); t += 3)
            {
                const pointField& p = open_[k];
                const scalar h =
                    triPointRef(p[t], p[t + 1], p[t + 2]).nearestPoint(x)
                   .distance();

                if (h < least[i]*d)
                {
                    // Straight out from the nearest, not past its edge
                    const vector n((p[t + 1] - p[t]) ^ (p[t + 2] - p[t]));
                    beyond[i] = (n & (x - p[t])) > 0.9*h*mag(n);
                    least[i] = h/d;
                }
            }
        }
    }

    // Who has passed an outlet is through, however far
    forAll(gone_, k)
    {
        forAll(volume, i)
        {
            const char* ids = reinterpret_cast<const char*>(view.id);
            if
            (
                *reinterpret_cast<const int64_t*>(ids + view.stride*size_t(i))
             == gone_[k]
            )
            {
                least[i] = 0;
            }
        }
    }

    forAll(volume, i)
    {
        const scalar t = beyond[i] ? 0 : min(least[i], scalar(1));
        volume[i] *= t*t*(3 - 2*t);
    }
}

// ************************************************************************* //
