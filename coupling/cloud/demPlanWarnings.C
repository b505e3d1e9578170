/*---------------------------------------------------------------------------*\
    demPlanWarnings.C -- what is likely to be a mistake or cannot work, told before
    the first step.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demPlan.H"
#include "demCheck.H"
#include "demFluid.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool isCalledInlet(const word& name)
{
    return name.find("inlet") != string::npos || name.find("Inlet") != string::npos;
}


// Largest speed of the fluid on the patches where it is given. Collective.
static scalar patchSpeed(const volVectorField& U)
{
    scalar fastest = 0;
    for (const fvPatchVectorField& Up : U.boundaryField())
    {
        if (!Up.coupled() && Up.fixesValue() && Up.size())
        {
            fastest = max(fastest, max(mag(Up)()));
        }
    }
    return returnReduce(fastest, maxOp<scalar>());
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// Patches through which fluid should enter, and where nothing says how much
void Foam::demPlan::inletWarnings
(
    const volVectorField& U,
    DynamicList<string>& warnings
) const
{
    const volScalarField* p = mesh_.findObject<volScalarField>("p_rgh");
    p = p ? p : mesh_.findObject<volScalarField>("p");

    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const word& name = Up.patch().name();

        if
        (
            Up.type() == "zeroGradient"
         && !isA<wallFvPatch>(Up.patch())
         && (isCalledInlet(name) || (p && p->boundaryField()[patchi].type() == "zeroGradient"))
        )
        {
            warnings.append
            (
                string("U on patch ") + name + " is zeroGradient: nothing drives the fluid in"
                " there; give fixedValue in 0/U, or a pressure on the patch and"
                " pressureInletOutletVelocity"
            );
        }
    }
}


// The exchange gives the fluid its impulse within one step. Schemes of two steps
// add a part of the change of the last one to it: what the fluid receives in all
// is off by half the impulse of the first step.
void Foam::demPlan::timeSchemeWarning(DynamicList<string>& warnings) const
{
    const word scheme(demFluid::timeScheme(mesh_));

    if (particles_.react() && (scheme == "backward" || scheme == "CrankNicolson"))
    {
        warnings.append
        (
            string("ddtSchemes ") + scheme + " does not keep the momentum that fluid and"
            " particles exchange (3 % off where they are brought to one velocity);"
            " give Euler in system/fvSchemes"
        );
    }
}


void Foam::demPlan::warn(const volVectorField& U, struct ::dem_run_info& ahead) const
{
    DynamicList<string> own;
    inletWarnings(U, own);
    timeSchemeWarning(own);
    List<const char*> sentences(own.size());
    const char* text = nullptr;

    forAll(own, k)
    {
        sentences[k] = own[k].c_str();
    }
    ahead.patch_speed = patchSpeed(U);
    ahead.resolution = transfer_.length();

    demCheck(dem_warnings(particles_.core(), &ahead, int(own.size()), sentences.cdata(), &text));
    if (text[0])
    {
        Info<< text << endl;
    }
}

// ************************************************************************* //
