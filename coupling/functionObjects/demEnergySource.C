/*---------------------------------------------------------------------------*\
    demEnergySource.C -- the heat of the particles as an fvOption.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demEnergySource.H"
#include "demEntries.H"
#include "basicThermo.H"
#include "fvMatrices.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(demEnergySource, 0);
    addToRunTimeSelectionTable(option, demEnergySource, dictionary);
}
}

Foam::fv::demEnergySource::demEnergySource
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


bool Foam::fv::demEnergySource::read(const dictionary& dict)
{
    if (!option::read(dict))
    {
        return false;
    }
    demCheckSourceEntries(dict, name_, typeName, wordList());

    const basicThermo* thermo = mesh_.findObject<basicThermo>(basicThermo::dictName);

    if (!thermo)
    {
        FatalIOErrorInFunction(dict)
            << "The source " << name_ << " adds to the equation of energy, but this solver"
            << " has no thermophysical model; remove the source from constant/fvOptions"
            << exit(FatalIOError);
    }
    fieldNames_ = wordList(1, thermo->he().name());
    applied_.setSize(1, false);
    return true;
}


void Foam::fv::demEnergySource::addSup
(
    const volScalarField& rho,
    fvMatrix<scalar>& eqn,
    const label
)
{
    demDriver& driver = demDriver::of(mesh_, name_);

    if (driver.active())
    {
        driver.addHeat(rho, eqn);
    }
}
