/*---------------------------------------------------------------------------*\
    demDict.C -- what the user wrote: this side's part and the core's part.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demDict.H"
#include "wallPolyPatch.H"
#include "uniformDimensionedFields.H"
#include "OStringStream.H"
#include "DynamicList.H"
#include "HashSet.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Every entry says where it stood, so that the core can name the user's line
static void writeEntries(const dictionary& dict, OStringStream& os)
{
    forAllConstIters(dict, iter)
    {
        const entry& e = *iter;

        // What was added here stands in no line
        if (e.startLineNumber() > 0)
        {
            os  << nl << "#line " << e.startLineNumber() << " \"constant/"
                << demDict::name().c_str() << "\"" << nl;
        }

        if (e.isDict())
        {
            os.writeKeyword(e.keyword());
            os  << nl << "{" << nl;
            writeEntries(e.dict(), os);
            os  << nl << "}" << nl;
        }
        else
        {
            e.write(os);
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demDict::checkCoupling() const
{
    const wordHashSet known
    ({
        "twoWay", "rho", "nu", "walls", "diameter",
        "kernel", "width", "base", "minVoidFraction", "record"
    });

    forAllConstIters(coupling_, iter)
    {
        const keyType& key = iter().keyword();

        if (!known.found(key))
        {
            FatalIOErrorInFunction(coupling_)
                << "There is no entry " << key << " in coupling; there are "
                << flatOutput(known.sortedToc()) << exit(FatalIOError);
        }
    }
}


void Foam::demDict::keepBackPatches()
{
    if (!dict_.found("walls"))
    {
        return;
    }

    dictionary& walls = dict_.subDict("walls");

    // A copy of the names: entries go while we look
    DynamicList<keyType> names;
    forAllConstIters(walls, iter)
    {
        names.append(iter().keyword());
    }

    forAll(names, i)
    {
        const wordRe pattern(names[i]);
        bool aPatch = false;

        forAll(mesh_.boundaryMesh(), patchi)
        {
            aPatch = aPatch || pattern.match(mesh_.boundaryMesh()[patchi].name());
        }

        if (aPatch)
        {
            patches_.add(*walls.findEntry(names[i], keyType::LITERAL));
            walls.remove(names[i]);
        }
        else if (names[i].isPattern())
        {
            FatalIOErrorInFunction(walls)
                << "walls/" << names[i] << " matches no patch; there are "
                << flatOutput(mesh_.boundaryMesh().names())
                << exit(FatalIOError);
        }
    }

    if (walls.empty())
    {
        dict_.remove("walls");
    }
}


void Foam::demDict::settleGravity()
{
    IOobject io
    (
        "g",
        mesh_.time().constant(),
        mesh_.time(),
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    const dictionary& effects = dict_.subOrEmptyDict("effects");
    const dictionary& own = effects.subOrEmptyDict("gravity");
    const bool inScene = own.readIfPresent("acceleration", gravity_);

    if (!io.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        return;
    }

    const vector g = uniformDimensionedVectorField(io).value();

    if (inScene && mag(g - gravity_) > 1e-9*mag(g))
    {
        FatalIOErrorInFunction(own)
            << "Gravity is " << gravity_ << " in effects/gravity/acceleration"
            << " and " << g << " in constant/g; write it in one place only"
            << exit(FatalIOError);
    }

    gravity_ = g;

    if (!inScene && mag(g) > 0)
    {
        dictionary gravity;
        dictionary added;
        gravity.add("acceleration", g);
        added.add("gravity", gravity);

        dictionary all;
        all.add("effects", added);
        dict_.merge(all);
    }
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demDict::demDict(const polyMesh& mesh)
:
    mesh_(mesh),
    dict_
    (
        IOobject
        (
            name(),
            mesh.time().constant(),
            mesh.time(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    ),
    coupling_(dict_.subOrEmptyDict("coupling")),
    gravity_(Zero)
{
    dict_.remove("coupling");
    dict_.remove("FoamFile");

    // The end and the output of a run are controlDict's here
    dict_.remove("write");
    if (dict_.found("time"))
    {
        dict_.subDict("time").remove("end");
    }

    if (dict_.found("fluid"))
    {
        FatalIOErrorInFunction(dict_.subDict("fluid"))
            << "The scene brings a uniform fluid, but here a solver does;"
            << " take out fluid { ... }" << exit(FatalIOError);
    }

    if (dict_.found("start"))
    {
        dict_.subDict("start").readEntry("snapshot", snapshot_);
        dict_.remove("start");
        snapshot_.expand();

        if (!snapshot_.isAbsolute())
        {
            snapshot_ = mesh.time().globalPath()/snapshot_;
        }
    }

    checkCoupling();
    coupling_.readIfPresent("walls", alsoWalls_);
    keepBackPatches();
    settleGravity();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::demDict::acts(const word& effect) const
{
    return dict_.subOrEmptyDict("effects").found(effect);
}


bool Foam::demDict::periodic() const
{
    return dict_.subOrEmptyDict("domain").found("periodic");
}


bool Foam::demDict::isWall(const polyPatch& patch) const
{
    return
        isA<wallPolyPatch>(patch)
     || alsoWalls_.match(patch.name())
     || patches_.found(patch.name());
}


Foam::word Foam::demDict::material(const polyPatch& patch) const
{
    const dictionary* wall = patches_.findDict(patch.name());

    if (wall)
    {
        forAllConstIters(*wall, iter)
        {
            const keyType& key = iter().keyword();

            if
            (
                key != "material"
             && !(key == "type" && wall->get<word>("type") == "patch")
            )
            {
                FatalIOErrorInFunction(*wall)
                    << "A wall made from a patch has a material and nothing"
                    << " else; take out " << key << exit(FatalIOError);
            }
        }
        return wall->get<word>("material");
    }

    const wordList materials(dict_.subOrEmptyDict("materials").toc());

    if (materials.size() != 1)
    {
        FatalIOErrorInFunction(dict_)
            << "What is wall " << patch.name() << " made of? Add"
            << " walls { " << patch.name() << " { material name; } } with one"
            << " of the materials " << flatOutput(materials)
            << exit(FatalIOError);
    }

    return materials[0];
}


std::string Foam::demDict::text() const
{
    OStringStream os;
    os.precision(17);           // doubles arrive with the same bits
    writeEntries(dict_, os);
    return os.str();
}

// ************************************************************************* //
