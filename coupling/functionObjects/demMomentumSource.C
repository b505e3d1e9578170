/*---------------------------------------------------------------------------*\
    demMomentumSource.C -- the particles' force on the fluid as an fvOption.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demMomentumSource.H"
#include "demEntries.H"
#include "fvMatrices.H"
#include "fvmSup.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(demMomentumSource, 0);
    addToRunTimeSelectionTable(option, demMomentumSource, dictionary);
}
}

Foam::fv::demMomentumSource::demMomentumSource
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    option(name, modelType, dict, mesh)
{
    read(dict);
}


bool Foam::fv::demMomentumSource::read(const dictionary& dict)
{
    if (!option::read(dict))
    {
        return false;
    }
    if (dict.getOrDefault<word>("selectionMode", "all") != "all")
    {
        FatalIOErrorInFunction(dict)
            << "fvOptions/" << name_ << " has a selectionMode, but the fluid gets the particles' reaction"
            << " wherever particles are; take it out" << exit(FatalIOError);
    }
    demCheckSourceEntries(dict, name_, typeName, wordList());

    fieldNames_ = wordList(1, "U");
    applied_.setSize(1, false);
    return true;
}


void Foam::fv::demMomentumSource::addSup
(
    fvMatrix<vector>& eqn,
    const label
)
{
    demDriver& driver = demDriver::of(mesh_, name_);

    if (!driver.active())
    {
        return;
    }

    const dimensionedScalar rho
    (
        "rho",
        dimDensity,
        driver.cloud().particles().fluidDensity()
    );

    eqn += driver.force()/rho - fvm::Sp(driver.drag()/rho, eqn.psi());
}


void Foam::fv::demMomentumSource::addSup
(
    const volScalarField&,
    fvMatrix<vector>& eqn,
    const label
)
{
    demDriver& driver = demDriver::of(mesh_, name_);

    if (!driver.active())
    {
        return;
    }

    eqn += driver.force() - fvm::Sp(driver.drag(), eqn.psi());
}
