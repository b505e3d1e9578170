/*---------------------------------------------------------------------------*\
    demDomain.C -- derive periodic and flat axes of the particles' domain from
    cyclic and empty patches.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demDomain.H"
#include "emptyPolyPatch.H"
#include "pointIOField.H"
#include "processorCyclicPolyPatch.H"
#include "SubField.H"
#include "Time.H"


// Translation from this half of a cyclic pair to the other, over all ranks; false if
// it is not a translation. Faces with their other half on another rank are in
// processorCyclic patches.
bool Foam::demDomain::translation(const cyclicPolyPatch& half, vector& offset) const
{
    vector lowest(vector::uniform(GREAT)), highest(vector::uniform(-GREAT));
    bool rotates = half.size() && !half.parallel();

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
            const vector d(other[i] - patch.faceCentres()[i]);
            lowest = min(lowest, d);
            highest = max(highest, d);
        }
    }

    reduce(lowest, minOp<vector>());
    reduce(highest, maxOp<vector>());
    reduce(rotates, orOp<bool>());

    offset = 0.5*(lowest + highest);
    return !rotates && mag(highest - lowest) <= tolerance*mag(offset);
}


void Foam::demDomain::addPoints(const polyPatch& patch, boundBox& box) const
{
    const pointField& points = points_();

    for (const label pointi : patch.meshPoints())
    {
        box.add(points[pointi]);
    }
}


// Bounding box of this half of a cyclic pair, over all ranks
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
    const vector& offset
) const
{
    for (direction k = 0; k < 3; k++)
    {
        vector rest(offset);
        rest[k] = 0;

        if (mag(rest) <= tolerance*mag(offset))
        {
            return k;
        }
    }

    FatalErrorInFunction
        << "Patch " << half.name() << " is cyclic along " << offset
        << ", which is not x, y or z, but the particles' domain can only be"
        << " periodic along these; rotate the mesh (transformPoints), or use walls"
        << exit(FatalError);
    return 0;
}


void Foam::demDomain::add(const cyclicPolyPatch& half)
{
    vector offset;
    if (!translation(half, offset))
    {
        return;
    }

    const direction k = axisOf(half, offset);
    const boundBox here(planes(half)), there(planes(half.neighbPatch()));
    const boundBox& low = offset[k] > 0 ? here : there;
    const boundBox& high = offset[k] > 0 ? there : here;
    const scalar length = mag(offset);

    if
    (
        kind_[k] == CYCLIC
     && max(mag(low.min()[k] - low_[k]), mag(high.min()[k] - high_[k])) > tolerance*length
    )
    {
        FatalErrorInFunction
            << "Cyclic patches " << patch_[k] << " and " << half.name()
            << " are periodic along " << vector::componentNames[k] << " in different planes, ("
            << low_[k] << ' ' << high_[k] << ") m and (" << low.min()[k] << ' '
            << high.min()[k] << ") m, but particles have one domain; put them"
            << " in the same planes, or use walls" << exit(FatalError);
    }

    kind_[k] = CYCLIC;
    low_[k] = low.min()[k];
    high_[k] = high.min()[k];
    planar_[k] = max(low.span()[k], high.span()[k]) <= tolerance*length;
    patch_[k] = half.name();
}


// The extent of the mesh between its empty patches along k
void Foam::demDomain::addEmpty(const direction k)
{
    const boundBox all(points_(), true);
    const scalar thickness = all.span()[k];
    label offPlane = -1;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        for (label i = 0; isA<emptyPolyPatch>(patch) && i < patch.size(); i++)
        {
            for (const label pointi : patch[i])
            {
                const scalar x = points_()[pointi][k];
                if (min(x - all.min()[k], all.max()[k] - x) > tolerance*thickness)
                {
                    offPlane = patch.index();
                }
            }
        }
        if (isA<emptyPolyPatch>(patch))
        {
            patch_[k] = patch.name();
        }
    }

    if (returnReduce(offPlane, maxOp<label>()) >= 0)
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


Foam::demDomain::demDomain(const polyMesh& mesh)
:
    mesh_(mesh),
    points_(firstPoints(mesh))
{
    for (direction k = 0; k < 3; k++)
    {
        kind_[k] = OPEN;
        planar_[k] = true;
        low_[k] = high_[k] = 0;
    }

    // Processor patches come last, so all ranks reach the collective calls for the
    // other patches in the same order
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
