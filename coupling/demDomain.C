/*---------------------------------------------------------------------------*\
    demDomain.C -- cyclic and empty patches become the particles' domain.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demDomain.H"
#include "demDict.H"
#include "DynamicList.H"
#include "emptyPolyPatch.H"
#include "FixedList.H"
#include "pointIOField.H"
#include "processorCyclicPolyPatch.H"
#include "SubField.H"
#include "Time.H"
#include "Vector2D.H"

namespace Foam
{
    // blockMesh writes points with 10 digits or more; two planes are one, and
    // a way is along an axis, when they differ by no more than this share
    static const scalar same = 1e-6;

    static const char* const axisName[] = {"x", "y", "z"};
}

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
            << " go round along " << axisName[k] << " in other planes, ("
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
            << axisName[k] << ", but particles move in a slab of one thickness;"
            << " make it one cell thick, with the same thickness everywhere"
            << exit(FatalError);
    }

    kind_[k] = EMPTY;
    low_[k] = all.min()[k];
    high_[k] = all.max()[k];
}


// Does the list of axes hold this one?
bool Foam::demDomain::says
(
    const dictionary& domain,
    const word& list,
    const direction k
) const
{
    const entry* e = domain.findEntry(list, keyType::LITERAL);

    if (!e || !e->isStream())
    {
        return false;                       // the core complains of a dictionary
    }
    for (const token& t : e->stream())
    {
        if (t.isWord() && t.wordToken() == axisName[k])
        {
            return true;
        }
    }
    return false;
}


// Limits of an axis, if the scene has some, are the mesh's
void Foam::demDomain::checkLimits
(
    const dictionary& domain,
    const direction k
) const
{
    scalar low = low_[k], high = high_[k];
    vector corner;

    if (domain.readIfPresent("min", corner))
    {
        low = corner[k];
    }
    if (domain.readIfPresent("max", corner))
    {
        high = corner[k];
    }
    if (domain.found(axisName[k]))
    {
        const List<scalar> both(domain.get<List<scalar>>(axisName[k]));
        low = both.size() > 0 ? both[0] : low;
        high = both.size() > 1 ? both[1] : high;
    }

    // Those that lean may begin anywhere
    const scalar off =
        plane_[k]
      ? max(mag(low - low_[k]), mag(high - high_[k]))
      : mag(high - low - (high_[k] - low_[k]));

    if (off > same*(high_[k] - low_[k]))
    {
        FatalIOErrorInFunction(domain)
            << "domain ends at " << low << " and " << high << " m along "
            << axisName[k] << ", but the mesh, between its "
            << (kind_[k] == CYCLIC ? "cyclic" : "empty") << " patches ("
            << patch_[k] << "), at " << low_[k] << " and " << high_[k]
            << " m; take " << axisName[k] << " out of domain, the mesh tells"
            << exit(FatalIOError);
    }
}


// Where the scene lists periodic axes they are those of the mesh
void Foam::demDomain::checkPeriodic(const dictionary& domain) const
{
    for (direction k = 0; k < 3; k++)
    {
        const bool periodic = says(domain, "periodic", k);

        if (kind_[k] == CYCLIC && !periodic)
        {
            FatalIOErrorInFunction(domain)
                << "domain/periodic is without " << axisName[k] << ", but patch "
                << patch_[k] << " is cyclic along it; take periodic out of"
                << " domain, the mesh tells" << exit(FatalIOError);
        }
        if (kind_[k] != CYCLIC && periodic)
        {
            FatalIOErrorInFunction(domain)
                << "domain/periodic has " << axisName[k] << ", but the mesh has"
                << " no cyclic patches along it; make its ends cyclic, or take "
                << axisName[k] << " out of periodic" << exit(FatalIOError);
        }
    }
}


// The list, with these axes; lists of a fixed size are written without it
void Foam::demDomain::addWords
(
    dictionary& domain,
    const word& list,
    const UList<word>& axes
) const
{
    typedef FixedList<word, 1> one;
    typedef FixedList<word, 2> two;
    typedef FixedList<word, 3> three;

    switch (axes.size())
    {
        case 1: domain.set(list, one(axes)); break;
        case 2: domain.set(list, two(axes)); break;
        case 3: domain.set(list, three(axes)); break;
    }
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


void Foam::demDomain::complete(dictionary& scene, const bool walls) const
{
    if (scene.found("domain") && !scene.isDict("domain"))
    {
        return;                             // the core complains
    }

    dictionary domain(scene.subOrEmptyDict("domain"));
    const bool corners = domain.found("min") || domain.found("max");
    DynamicList<word> round, flat;

    if (domain.found("periodic"))
    {
        checkPeriodic(domain);
    }
    for (direction k = 0; k < 3; k++)
    {
        const bool plane = kind_[k] == EMPTY && !walls && !domain.found("flat");

        if (kind_[k] != CYCLIC && !plane)
        {
            continue;
        }
        checkLimits(domain, k);
        if (!corners && !domain.found(axisName[k]))
        {
            domain.set(axisName[k], Vector2D<scalar>(low_[k], high_[k]));
        }
        if (kind_[k] == CYCLIC)
        {
            round.append(axisName[k]);
        }
        if (plane)
        {
            flat.append(axisName[k]);
        }
    }

    if (!domain.found("periodic"))
    {
        addWords(domain, "periodic", round);
    }
    addWords(domain, "flat", flat);

    if (round.size() || flat.size())
    {
        scene.set("domain", domain);
    }
}

// ************************************************************************* //
