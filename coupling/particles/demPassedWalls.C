/*---------------------------------------------------------------------------*\
    demPassedWalls.C -- void fraction of patches of given velocity.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demPassedWalls.H"
#include "demFiles.H"
#include "movingWallVelocityFvPatchVectorField.H"
#include "wallFvPatch.H"

namespace Foam
{

// Flux through a patch over the largest possible one at the same speeds: below this a
// wall slides in its own plane, such as a rotating wall with flat faces
static const scalar minNormalFraction = 1e-3;


// Is the velocity given, other than at an outlet?
static bool isGiven(const fvPatchVectorField& Up)
{
    return Up.fixesValue() && !Up.assignable();
}

} // End namespace Foam


bool Foam::demPassedWalls::isPassed(const fvPatchVectorField& Up)
{
    if (!isGiven(Up) || isA<movingWallVelocityFvPatchVectorField>(Up))
    {
        return false;
    }

    const vectorField& Sf = Up.patch().Sf();
    return
        gSum(mag(Up & Sf)()) > minNormalFraction*gSum((mag(Up)*mag(Sf))());
}


Foam::wordList Foam::demPassedWalls::types(const fvMesh& mesh)
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


Foam::demPassedWalls::demPassedWalls(const volScalarField& voidFraction)
:
    mesh_(voidFraction.mesh())
{
    const volVectorField* U = mesh_.findObject<volVectorField>("U");
    IOobject file(demFieldAt(mesh_, "voidFraction", IOobject::MUST_READ));
    const bool given = file.typeHeaderOk<volScalarField>(true);

    DynamicList<label> walls;

    if (!U || given)
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
         && voidFraction.boundaryField()[patchi].type() == "zeroGradient"
        )
        {
            walls.append(patchi);
        }
    }

    closed_.transfer(walls);
}


void Foam::demPassedWalls::check(const volVectorField& U) const
{
    for (const label patchi : closed_)
    {
        if (isPassed(U.boundaryField()[patchi]))
        {
            const word& name = mesh_.boundary()[patchi].name();

            FatalErrorInFunction
                << "The wall " << name << " lets fluid in since time "
                << mesh_.time().value() << " s, but it takes the void fraction of the"
                << " cell behind it, because no fluid passed it at the start; add 0/voidFraction"
                << " with " << name << " { type fixedValue; value uniform 1; } for its"
                << " superficial velocity, or { type zeroGradient; } for the interstitial one"
                << exit(FatalError);
        }
    }
}
