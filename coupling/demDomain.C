/*---------------------------------------------------------------------------*\
    demDomain.C -- cyclic and empty patches become the particles' domain.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demDomain.H"
#include "emptyPolyPatch.H"
#include "pointIOField.H"
#include "processorCyclicPolyPatch.H"
#include "SubField.H"
#include "Time.H"


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// From this half to its other one, over all ranks: false if it is no translation.
// Faces whose other half is on another rank are in a patch of their own.
bool Foam::demDomain::translation(const cyclicPolyPatch& half, vector& way) const
{
    vector least(vector::uniform(GREAT)), most(vector::uniform(-GREAT));
    bool turns = half.size() && !half.parallel();

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const bool split =
            isA<processorCyclicPolyPatch>(patch)
         && refCast<const processorCyclicPolyPatch>(patch).referPatchID() == half.index();

        if (!split && patch.index() != half.index())
        {
            continue;
        }

        const pointField other
        (
            split
          ? refCast<const processorCyclicPolyPatch>(patch).neighbFaceCentres()
          : pointField(half.neighbPatch().faceCentres())
        );
        forAll(patch, i)
        {
            const vector here(other[i] - patch.faceCentres()[i]);
            least = min(least, here);
            most = max(most, here);
        }
    }

    reduce(least, minOp<vector>());
    reduce(most, maxOp<vector>());
    reduce(turns, orOp<bool>());

    way = 0.5*(least + most);
    return !turns && mag(most - least) <= same*mag(way);
}


void Foam::demDomain::addPoints(const polyPatch& patch, boundBox& box) const
{
    const pointField& points = points_();

    for (const label pointi : patch.meshPoints())
    {
        box.add(points[pointi]);
    }
}


// The box that this half lies in, over all ranks
Foam::boundBox Foam::demDomain::planes(const cyclicPolyPatch& half) const
{
    boundBox box;

    addPoints(half, box);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if
        (
            isA<processorCyclicPolyPatch>(patch)
         && refCast<const processorCyclicPolyPatch>(patch).referPatchID() == half.index()
        )
        {
            addPoints(patch, box);
        }
    }
    box.reduce();
    return box;
}


Foam::direction Foam::demDomain::axisOf
(
    const cyclicPolyPatch& half,
    const vector& way
) const
{
    for (direction k = 0; k < 3; k++)
    {
        vector rest(way);
        rest[k] = 0;

        if (mag(rest) <= same*mag(way))
        {
            return k;
        }
    }

    FatalErrorInFunction
        << "Patch " << half.name() << " is cyclic along " << way
        << ", which is not x, y or z, but particles can only go round along"
        << " these; turn the mesh (transformPoints), or use walls"
        << exit(FatalError);
    return 0;
}


void Foam::demDomain::add(const cyclicPolyPatch& half)
{
    vector way;
    if (!translation(half, way))
    {
        return;
    }

    const direction k = axisOf(half, way);
    const boundBox here(planes(half)), there(planes(half.neighbPatch()));
    const boundBox& low = way[k] > 0 ? here : there;
    const boundBox& high = way[k] > 0 ? there : here;
    const scalar length = mag(way);

    if
    (
        kind_[k] == CYCLIC
     && max(mag(low.min()[k] - low_[k]), mag(high.min()[k] - high_[k])) > same*length
    )
    {
        FatalErrorInFunction
            << "Cyclic patches " << patch_[k] << " and " << half.name()
            << " go round along " << vector::componentNames[k] << " in other planes, ("
            << low_[k] << ' ' << high_[k] << ") m and (" << low.min()[k] << ' '
            << high.min()[k] << ") m, but particles have one domain; let them"
            << " meet in one plane, or use walls" << exit(FatalError);
    }

    kind_[k] = CYCLIC;
    low_[k] = low.min()[k];
    high_[k] = high.min()[k];
    plane_[k] = max(low.span()[k], high.span()[k]) <= same*length;
    patch_[k] = half.name();
}


// The mesh between its empty patches along k
void Foam::demDomain::addEmpty(const direction k)
{
    const boundBox all(points_(), true);
    const scalar thick = all.span()[k];
    label off = -1;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        for (label i = 0; isA<emptyPolyPatch>(patch) && i < patch.size(); i++)
        {
            for (const label pointi : patch[i])
            {
                const scalar x = points_()[pointi][k];
                if (min(x - all.min()[k], all.max()[k] - x) > same*thick)
                {
                    off = patch.index();
                }
            }
        }
        if (isA<emptyPolyPatch>(patch))
        {
            patch_[k] = patch.name();
        }
    }

    if (returnReduce(off, maxOp<label>()) >= 0)
    {
        FatalErrorInFunction
            << "The empty patches do not lie in two planes across "
            << vector::componentNames[k] << ", but particles move in a slab of one thickness;"
            << " make it one cell thick, with the same thickness everywhere"
            << exit(FatalError);
    }

    kind_[k] = EMPTY;
    low_[k] = all.min()[k];
    high_[k] = all.max()[k];
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demDomain::demDomain(const polyMesh& mesh)
:
    mesh_(mesh),
    points_(firstPoints(mesh))
{
    for (direction k = 0; k < 3; k++)
    {
        kind_[k] = OPEN;
        plane_[k] = true;
        low_[k] = high_[k] = 0;
    }

    // Patches to other ranks come last, so all ranks meet at the others in step
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch) && refCast<const cyclicPolyPatch>(patch).owner())
        {
            add(refCast<const cyclicPolyPatch>(patch));
        }
    }
    for (direction k = 0; k < 3; k++)
    {
        if (mesh_.solutionD()[k] < 0)
        {
            addEmpty(k);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::pointField> Foam::demDomain::firstPoints(const polyMesh& mesh)
{
    if (mesh.pointsInstance() == mesh.facesInstance())
    {
        return tmp<pointField>(mesh.points());
    }

    return tmp<pointField>
    (
        new pointField
        (
            pointIOField
            (
                IOobject
                (
                    "points",
                    mesh.facesInstance(),
                    polyMesh::meshSubDir,
                    mesh,
                    IOobject::MUST_READ,
                    IOobject::NO_WRITE,
                    false
                )
            )
        )
    );
}

// ************************************************************************* //
