/*---------------------------------------------------------------------------*\
    demCouplingScheme.C -- reads and checks the set of equations.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCouplingScheme.H"
#include "fvMesh.H"
#include "surfaceFields.H"
#include "volFields.H"
#include "demCheck.H"
#include "demPassedWalls.H"
#include "wallPolyPatch.H"

namespace Foam
{

static const wordList sets({"I", "II", "III"});

} // End namespace Foam


void Foam::demCouplingScheme::checkGiven(const word& name, const bool volumeAveraged) const
{
    const dictionary& own = dict_.coupling();

    if (own.found(name) && !own.getOrDefault("twoWay", true))
    {
        FatalIOErrorInFunction(own)
            << name << " says how the fluid feels the particles, but with"
            << " twoWay no it does not; take one of them out of coupling in"
            << " constant/" << demDict::name() << exit(FatalIOError);
    }

    if (own.found(name) && !volumeAveraged)
    {
        FatalIOErrorInFunction(own)
            << name << " is for demPimpleFoam and demInterFoam; the equations of this solver have"
            << " no void fraction. Take it out of coupling in constant/"
            << demDict::name() << exit(FatalIOError);
    }
}


Foam::demCouplingScheme::demCouplingScheme(const demDict& dict, const bool volumeAveraged)
:
    dict_(dict),
    set_(II)
{
    const word chosen(dict.coupling().getOrDefault<word>("equations", sets[II]));
    const label index = sets.find(chosen);

    if (index < 0)
    {
        demUnknown(dict.coupling(), "coupling", "equations", chosen, sets);
    }
    set_ = equations(index);
    checkGiven("equations", volumeAveraged);
    checkGiven("mixtureFlux", volumeAveraged);
}


// Nothing flows through a wall whose constant velocity has no normal part
void Foam::demCouplingScheme::checkPasses(const volVectorField& U, const label patchi) const
{
    const fvPatchVectorField& Ub = U.boundaryField()[patchi];
    const word& type = Ub.type();

    if
    (
        isA<wallPolyPatch>(U.mesh().boundaryMesh()[patchi])
     && (type == "noSlip" || type == "fixedValue")
     && !demPassedWalls::isPassed(Ub)
    )
    {
        FatalIOErrorInFunction(dict_.coupling())
            << "mixtureFlux names patch " << U.mesh().boundaryMesh()[patchi].name()
            << ", a wall without flow through it (0/U is " << type
            << "); name inlets or outlets with a fixed velocity, or take the patch out"
            << exit(FatalIOError);
    }
}


Foam::boolList Foam::demCouplingScheme::mixturePatches(const volVectorField& U) const
{
    const polyBoundaryMesh& patches = U.mesh().boundaryMesh();
    const dictionary& own = dict_.coupling();
    boolList chosen(patches.size(), false);

    for (const word& name : own.getOrDefault<wordList>("mixtureFlux", wordList()))
    {
        const label patchi = patches.findPatchID(name);
        if (patchi < 0)
        {
            demUnknown(own, "coupling", "mixtureFlux", name, patches.names());
        }
        if (patches[patchi].coupled() || U.boundaryField()[patchi].assignable())
        {
            FatalIOErrorInFunction(own)
                << "mixtureFlux names patch " << name << ", on which 0/U does not fix"
                << " the velocity (it is " << U.boundaryField()[patchi].type()
                << "); give the velocity of fluid and particles together there,"
                << " fixedValue for one, or take the patch out of mixtureFlux"
                << exit(FatalIOError);
        }
        checkPasses(U, patchi);
        chosen[patchi] = true;
    }
    return chosen;
}


void Foam::demCouplingScheme::checkEffects() const
{
    if (dict_.effectWith(DEM_TRAIT_PRESSURE_GRADIENT).empty())
    {
        FatalErrorInFunction
            << "Equations " << sets[set_] << " need pressureGradient {} in"
            << " effects of constant/" << demDict::name() << ": "
            << (
                   set_ == III
                 ? "it contains the particles' buoyancy"
                 : "their fraction of the pressure gradient is taken from the"
                   " fluid to be applied to them"
               )
            << ", and without it momentum is lost" << exit(FatalError);
    }

    const word unsteady
    (
        dict_.effectWith(DEM_TRAIT_FLUID_ACCELERATION | DEM_TRAIT_FLUID_STRESS)
    );

    if (set_ == III && !unsteady.empty())
    {
        FatalErrorInFunction
            << "Equations III hold for a steady, uniform flow, without the"
            << " acceleration and stress that " << unsteady << " needs: take equations I or II"
            << " in coupling of constant/" << demDict::name() << ", or leave " << unsteady
            << " out" << exit(FatalError);
    }
}
