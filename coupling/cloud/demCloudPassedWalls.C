/*---------------------------------------------------------------------------*\
    demCloudPassedWalls.C -- void fraction of the patches whose velocity is given,
    walls of the mesh that fluid passes among them.

    Where the velocity and so the flux is given it is the superficial one: the void
    fraction of the patch is 1, unless voidFraction of the start time says otherwise.
    Elsewhere it is that of the cell behind the patch.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "movingWallVelocityFvPatchVectorField.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Flux through a patch over the largest one of the same speeds: below it a wall
// slides in itself, as a rotating one does on flat faces
static const scalar minNormalFraction = 1e-3;


// Is the velocity given, and not that of an outlet?
static bool isGiven(const fvPatchVectorField& Up)
{
    return Up.fixesValue() && !Up.assignable();
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// Does fluid pass a patch that is a wall, at a given velocity? A wall that moves with
// the mesh takes the fluid along. Collective.
bool Foam::demCloud::isPassed(const fvPatchVectorField& Up)
{
    if (!isGiven(Up) || isA<movingWallVelocityFvPatchVectorField>(Up))
    {
        return false;
    }

    const vectorField& Sf = Up.patch().Sf();
    return
        gSum(mag(Up & Sf)()) > minNormalFraction*gSum((mag(Up)*mag(Sf))());
}


// Types of voidFraction on the patches where no file gives them. Collective.
Foam::wordList Foam::demCloud::patchTypes(const fvMesh& mesh)
{
    wordList types(mesh.boundary().size(), "zeroGradient");
    const volVectorField* U = mesh.findObject<volVectorField>("U");

    forAll(types, patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];

        if (!U || patch.coupled())
        {
            continue;
        }

        const fvPatchVectorField& Up = U->boundaryField()[patchi];

        if
        (
            isA<wallFvPatch>(patch)
          ? isPassed(Up)
          : isGiven(Up)
        )
        {
            types[patchi] = "fixedValue";
        }
    }

    return types;
}


// Walls without flow at the start whose velocity may change during the run, and
// whose void fraction the user has not given
void Foam::demCloud::findClosedWalls()
{
    const volVectorField* U = mesh_.findObject<volVectorField>("U");
    const bool given = IOobject
    (
        "voidFraction",
        mesh_.time().timeName(),
        mesh_,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    ).typeHeaderOk<volScalarField>(true);

    DynamicList<label> walls;

    if (!U || !volumeAveraged_ || given)
    {
        return;
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatchVectorField& Up = U->boundaryField()[patchi];

        if
        (
            isA<wallFvPatch>(Up.patch())
         && isGiven(Up)
         && Up.type() != "fixedValue"
         && Up.type() != "noSlip"
         && !isA<movingWallVelocityFvPatchVectorField>(Up)
         && voidFraction_.boundaryField()[patchi].type() == "zeroGradient"
        )
        {
            walls.append(patchi);
        }
    }

    closedWalls_.transfer(walls);
}


void Foam::demCloud::checkClosedWalls(const volVectorField& U) const
{
    for (const label patchi : closedWalls_)
    {
        if (isPassed(U.boundaryField()[patchi]))
        {
            const word& name = mesh_.boundary()[patchi].name();

            FatalErrorInFunction
                << "The wall " << name << " lets fluid in since time "
                << mesh_.time().value() << " s, but its void fraction is that of the cell"
                << " behind it, because no fluid passed it at the start; add 0/voidFraction"
                << " with " << name << " { type fixedValue; value uniform 1; } for its"
                << " superficial velocity, or { type zeroGradient; } for the interstitial one"
                << exit(FatalError);
        }
    }
}


// ************************************************************************* //
