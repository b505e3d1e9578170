/*---------------------------------------------------------------------------*\
    demWallEntries.C -- checks entries of walls that name patches or surface files.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demWallEntries.H"
#include "demCheck.H"
#include "DynamicList.H"
#include "HashSet.H"
#include "processorPolyPatch.H"

Foam::wordList Foam::demWallEntries::patchNames(const polyMesh& mesh)
{
    DynamicList<word> names;

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!isA<processorPolyPatch>(patch))
        {
            names.append(patch.name());
        }
    }
    return wordList(names);
}


void Foam::demWallEntries::refuseUnmatched
(
    const dictionary& dict,
    const std::string& where,
    const wordRe& pattern,
    const UList<word>& patches
)
{
    if (!pattern.isPattern())
    {
        demUnknown(dict, where, "patch", pattern, patches);
    }
    FatalIOErrorInFunction(dict)
        << where.c_str() << ": \"" << pattern.c_str() << "\" matches no patch;"
        << " there are " << flatOutput(patches) << exit(FatalIOError);
}


bool Foam::demWallEntries::matches(const wordRe& pattern, const UList<word>& names)
{
    for (const word& name : names)
    {
        if (pattern.match(name))
        {
            return true;
        }
    }
    return false;
}


Foam::wordList Foam::demWallEntries::materials(const dictionary& scene)
{
    const wordList names(scene.subOrEmptyDict("materials").toc());

    if (names.empty())
    {
        FatalIOErrorInFunction(scene)
            << "The scene has no materials; add"
            << " materials { glass { density 2500; youngsModulus 1e7; } }"
            << exit(FatalIOError);
    }
    return names;
}


void Foam::demWallEntries::checkMaterial
(
    const dictionary& scene,
    const dictionary& wall,
    const std::string& where
)
{
    const wordList known(materials(scene));
    word name;

    if (wall.readIfPresent("material", name))
    {
        if (!known.found(name))
        {
            demUnknown(wall, where, "material", name, known);
        }
    }
    else if (known.size() != 1)
    {
        FatalIOErrorInFunction(wall)
            << where.c_str() << " misses its material, as the scene has "
            << known.size() << "; add material, one of "
            << flatOutput(known) << exit(FatalIOError);
    }
}


void Foam::demWallEntries::checkOwn
(
    const polyMesh& mesh,
    const dictionary& walls,
    const entry& e
)
{
    const word type
    (
        e.isDict() ? e.dict().getOrDefault<word>("type", "patch") : "patch"
    );

    if (e.keyword().isPattern() || type == "patch")
    {
        refuseUnmatched
        (
            walls,
            "walls/" + e.keyword() + " has no other type (plane, box,"
            " cylinder, sphere, triangles, stl, surface), so it must be a"
            " patch",
            wordRe(e.keyword()),
            patchNames(mesh)
        );
    }
}


void Foam::demWallEntries::checkPatch(const dictionary& scene, const entry& e)
{
    const std::string where("walls/" + e.keyword());

    if (!e.isDict())
    {
        FatalIOErrorInFunction(scene.subDict("walls"))
            << where.c_str() << " is not a dictionary; write " << e.keyword()
            << " { material " << flatOutput(materials(scene)) << "; } with one of"
            << " these" << exit(FatalIOError);
    }

    const dictionary& wall = e.dict();
    const wordHashSet known
    (
        {
            "type", "material", "surfaceVelocity", "surfaceRotation", "absorb",
            "frictionless", "temperature", "wear"
        }
    );

    forAllConstIters(wall, iter)
    {
        const keyType& key = iter().keyword();

        if
        (
            !known.found(key)
         || (key == "type" && wall.get<word>("type") != "patch")
        )
        {
            FatalIOErrorInFunction(wall)
                << where.c_str() << " is made from a patch; such a wall has the"
                << " position of the mesh, a material, surfaceVelocity,"
                << " surfaceRotation, absorb, frictionless, temperature and wear, nothing else."
                << " Take out " << key << exit(FatalIOError);
        }
    }

    checkMaterial(scene, wall, where);
}
