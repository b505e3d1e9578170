/*---------------------------------------------------------------------------*\
    demTurbulenceSource.C -- turbulence that particles make, as an fvOption.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demTurbulenceSource.H"
#include "demEntries.H"
#include "demTurbulenceProduction.H"
#include "fvMatrices.H"
#include "fvmSup.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(demTurbulenceSource, 0);
    addToRunTimeSelectionTable(option, demTurbulenceSource, dictionary);
}
}

Foam::wordList Foam::fv::demTurbulenceSource::fields() const
{
    const bool stresses = mesh_.foundObject<volSymmTensorField>("R");
    wordList names;

    for (const char* name : {"k", "epsilon", "omega"})
    {
        if (!stresses && mesh_.foundObject<volScalarField>(name))
        {
            names.append(name);
        }
    }
    if (names.empty() || names[0] != "k")
    {
        FatalErrorInFunction
            << "The source " << name_ << " adds to the equations of k, epsilon and"
            << " omega, but the turbulence model of this case has no equation of k;"
            << " take another model in constant/turbulenceProperties, or remove the"
            << " source from constant/fvOptions" << exit(FatalError);
    }
    return names;
}


// Where turbulence is lost the source is implicit
void Foam::fv::demTurbulenceSource::add
(
    const volScalarField& production,
    fvMatrix<scalar>& eqn,
    const word& name
) const
{
    if (!mesh_.foundObject<volScalarField>("voidFraction"))
    {
        FatalErrorInFunction
            << "There are no particles for source " << name_ << ": add to"
            << " functions in system/controlDict" << nl
            << "    particles { type demCloud; libs (\"libdemCoupling.so\"); }"
            << nl << "(demPimpleFoam has its own.)" << exit(FatalError);
    }

    const scalar factor =
        name == "k" ? 1 : name == "epsilon" ? Cepsilon_ : Cepsilon_ - 1;
    const volScalarField& k = mesh_.lookupObject<volScalarField>("k");
    const dimensionedScalar least("least", k.dimensions(), VSMALL);
    const volScalarField::Internal rate(factor*production()/max(k, least)()());
    const dimensionedScalar none(rate.dimensions(), Zero);

    if (name == "k")
    {
        eqn += max(production(), dimensionedScalar(production.dimensions(), Zero));
    }
    else
    {
        eqn += max(rate, none)*eqn.psi()();
    }
    eqn += fvm::Sp(min(rate, none), eqn.psi());
}


Foam::fv::demTurbulenceSource::demTurbulenceSource
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    option(name, modelType, dict, mesh),
    Cepsilon_(1.8),
    production_
    (
        IOobject(demTurbulenceProduction::name(), mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(sqr(dimVelocity)/dimTime, Zero)
    )
{
    read(dict);
}


bool Foam::fv::demTurbulenceSource::read(const dictionary& dict)
{
    if (!option::read(dict))
    {
        return false;
    }
    demCheckSourceEntries(dict, name_, typeName, wordList(1, "Cepsilon"));

    Cepsilon_ = coeffs_.lookupOrDefault<scalar>("Cepsilon", 1.8);

    if (Cepsilon_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "Cepsilon of source " << name_ << " is " << Cepsilon_
            << "; it must be at least 1" << exit(FatalIOError);
    }

    fieldNames_ = fields();
    applied_.setSize(fieldNames_.size(), false);
    return true;
}


void Foam::fv::demTurbulenceSource::addSup
(
    fvMatrix<scalar>& eqn,
    const label fieldi
)
{
    add(production_, eqn, fieldNames_[fieldi]);
}


void Foam::fv::demTurbulenceSource::addSup
(
    const volScalarField& rho,
    fvMatrix<scalar>& eqn,
    const label fieldi
)
{
    const volScalarField production(rho*production_);
    add(production, eqn, fieldNames_[fieldi]);
}


void Foam::fv::demTurbulenceSource::addSup
(
    const volScalarField&,
    const volScalarField& rho,
    fvMatrix<scalar>& eqn,
    const label fieldi
)
{
    addSup(rho, eqn, fieldi);
}
