/*---------------------------------------------------------------------------*\
    demDictWalls.C -- the walls of the scene that are patches or surface files, and their materials.

    Part of demDict: entries of walls that name a patch, or are of type surface, are
    checked and removed from the scene; demWalls passes their triangles to the core.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demDict.H"
#include "demPassable.H"
#include "demRotatingFrame.H"
#include "demWallEntries.H"
#include "DynamicList.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wallPolyPatch.H"

using namespace Foam::demWallEntries;

void Foam::demDict::checkPatchNames() const
{
    const wordList patches(patchNames(mesh_));

    for (const wordRe& pattern : extraWalls_)
    {
        if (!matches(pattern, patches))
        {
            refuseUnmatched(coupling_, "coupling/walls", pattern, patches);
        }
    }
}


// Give the core the settings of patch walls other than their triangles and material
void Foam::demDict::addPatchSettings(const entry& e)
{
    dictionary plain(e.dict());
    plain.remove("type");
    plain.remove("material");

    if (plain.empty())
    {
        return;
    }

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (wordRe(e.keyword()).match(patch.name()) && isWall(patch))
        {
            dictionary wall(plain);
            wall.add("type", "patch");
            wall.add("material", material(patch));
            dict_.subDict("walls").add(patch.name(), wall);
        }
    }
}


// Give the core these settings of a patch, in addition to other entries of the wall
void Foam::demDict::addToWall(const polyPatch& patch, const dictionary& settings)
{
    dictionary wall(settings);
    wall.add("type", "patch");
    wall.add("material", material(patch));

    dictionary walls(dict_.subOrEmptyDict("walls"));
    walls.add(patch.name(), wall, true);
    dict_.set("walls", walls);
}


// Does the scene say what the patch is to particles: a wall, an inlet or an outlet?
bool Foam::demDict::isNamed(const polyPatch& patch) const
{
    bool named = extraWalls_.match(patch.name()) || patches_.found(patch.name());

    for (const char* list : {"insert", "outlets"})
    {
        const dictionary groups(dict_.subOrEmptyDict(list));
        for (const entry& group : groups)
        {
            named = named
             || (
                    group.isDict()
                 && group.dict().getOrDefault<word>("patch", word::null) == patch.name()
                );
        }
    }
    return named;
}


// A symmetry plane of the fluid mirrors the particles as well
bool Foam::demDict::isMirror(const polyPatch& patch) const
{
    return
        (isA<symmetryPlanePolyPatch>(patch) || isA<symmetryPolyPatch>(patch))
     && !isNamed(patch);
}


void Foam::demDict::addMirrors()
{
    DynamicList<word> names;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isMirror(patch))
        {
            dictionary settings;
            settings.add("frictionless", word("yes"));
            addToWall(patch, settings);
            names.append(patch.name());
        }
    }
    if (names.size())
    {
        Info<< "Suna: frictionless walls, as symmetry planes: " << flatOutput(names)
            << "; an entry of walls for the patch makes it another wall" << endl;
    }
}


// Walls in a zone that rotates (MRF) have its velocity, unless the user gives another
void Foam::demDict::addFrameMotion()
{
    for (const demRotatingFrame& frame : demRotatingFrame::all(mesh_))
    {
        for (const polyPatch& patch : mesh_.boundaryMesh())
        {
            if
            (
                demPassable::is(patch) || !isWall(patch) || isMirror(patch)
             || !frame.rotates(patch)
            )
            {
                continue;
            }

            const dictionary* given = patches_.findDict(patch.name());
            if (given && (given->found("surfaceVelocity") || given->found("surfaceRotation")))
            {
                continue;
            }
            frame.checkWall(patch);

            dictionary settings;
            settings.add("surfaceRotation", frame.surfaceRotation());
            addToWall(patch, settings);
            Info<< "Suna: the surface of wall " << patch.name() << " rotates by "
                << frame.omega() << " rad/s with its zone (MRF)" << endl;
        }
    }
}


// Walls of type surface: the file is read by demWalls, the core gets the triangles
void Foam::demDict::separateSurfaceWall(const word& name)
{
    dictionary& wall = dict_.subDict("walls").subDict(name);

    checkMaterial(dict_, wall, "walls/" + name);
    if (!wall.found("material"))
    {
        wall.add("material", materials(dict_)[0]);
    }
    if (!wall.found("file"))
    {
        FatalIOErrorInFunction(wall)
            << "walls/" << name << " is a surface without a file; add file,"
            << " the name of one in constant/triSurface" << exit(FatalIOError);
    }
    if (wall.getOrDefault<scalar>("scale", 1) <= 0)
    {
        FatalIOErrorInFunction(wall)
            << "walls/" << name << "/scale " << wall.get<scalar>("scale")
            << "; give a number above 0, metres per unit of the file"
            << exit(FatalIOError);
    }

    surfaces_.add(name, wall);
    wall.remove("file");
    wall.remove("scale");
}


void Foam::demDict::separatePatchWalls()
{
    if (!dict_.isDict("walls"))
    {
        return;                     // none, or the core reports the error
    }

    dictionary& walls = dict_.subDict("walls");
    const wordList patches(patchNames(mesh_));

    // A copy of the names: entries are removed in the loop
    DynamicList<keyType> names;
    forAllConstIters(walls, iter)
    {
        names.append(iter().keyword());
    }

    forAll(names, i)
    {
        const entry& e = *walls.findEntry(names[i], keyType::LITERAL);

        if (!matches(wordRe(names[i]), patches))
        {
            checkOwn(mesh_, walls, e);
            if (e.isDict() && e.dict().getOrDefault<word>("type", "") == "surface")
            {
                separateSurfaceWall(names[i]);
            }
            continue;
        }

        checkPatch(dict_, e);

        const label patchi = mesh_.boundaryMesh().findPatchID(names[i]);
        if (patchi >= 0 && demPassable::is(mesh_.boundaryMesh()[patchi]))
        {
            FatalIOErrorInFunction(walls)
                << "walls/" << names[i] << " is a patch of type "
                << mesh_.boundaryMesh()[patchi].type() << ", which particles"
                << " pass; take the entry out, or make the patch a wall"
                << exit(FatalIOError);
        }

        patches_.add(e);
        walls.remove(names[i]);
    }

    // All patch walls are known only now
    forAllConstIters(patches_, iter)
    {
        addPatchSettings(*iter);
    }

    if (walls.empty())
    {
        dict_.remove("walls");
    }
}


// Without the fluid particles fall out of open patches, which are walls while they settle
void Foam::demDict::closePatches()
{
    DynamicList<word> closed;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if
        (
            patch.type() == polyPatch::typeName && !isWall(patch)
         && returnReduce(patch.size(), sumOp<label>()) > 0
        )
        {
            dictionary wall;
            wall.add("material", materials(dict_)[0]);
            patches_.add(patch.name(), wall);
            closed.append(patch.name());
        }
    }
    if (closed.size())
    {
        Info<< "Suna: while particles settle, open patches are walls of " << materials(dict_)[0] << ": "
            << flatOutput(closed) << endl;
    }
}


bool Foam::demDict::isWall(const polyPatch& patch) const
{
    return
        isA<wallPolyPatch>(patch)
     || extraWalls_.match(patch.name())
     || patches_.found(patch.name())
     || isMirror(patch);
}


Foam::word Foam::demDict::material(const polyPatch& patch) const
{
    const dictionary* wall = patches_.findDict(patch.name());
    const wordList known(materials(dict_));
    word name(known[0]);

    // A particle meets its own image at a mirror: any material will do
    if
    (
        !(wall && wall->readIfPresent("material", name)) && known.size() != 1
     && !isMirror(patch)
    )
    {
        FatalIOErrorInFunction(dict_)
            << "What is wall " << patch.name() << " made of? Add"
            << " walls { " << patch.name() << " { material name; } } with one"
            << " of the materials " << flatOutput(known)
            << exit(FatalIOError);
    }
    return name;
}
