/*---------------------------------------------------------------------------*\
    demThermoHeat.C -- heat exchange with a fluid of a thermophysical model.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demThermoHeat.H"
#include "basicThermo.H"
#include "fvMatrices.H"
#include "fvmSup.H"

Foam::demThermoHeat::demThermoHeat(const fvMesh& mesh, demCloud& cloud)
:
    cloud_(cloud),
    exchange_(cloud.heat()),
    thermo_(thermo(mesh, exchange_)),
    kappa_("dem:kappa", thermo_.kappa()),
    Cp_("dem:Cp", thermo_.Cp()),
    asked_(-1)
{
    exchange_.setFluid(thermo_.T(), kappa_, Cp_);
}


Foam::basicThermo& Foam::demThermoHeat::thermo
(
    const fvMesh& mesh,
    const demHeatExchange& exchange
)
{
    basicThermo* found = mesh.getObjectPtr<basicThermo>(basicThermo::dictName);

    if (!found)
    {
        FatalErrorInFunction
            << exchange.reason().c_str() << ", but this solver has no thermophysical"
            << " model with the fluid's temperature; take demPimpleFoam,"
            << " buoyantPimpleFoam or rhoPimpleFoam, or leave the effect out"
            << exit(FatalError);
    }
    return *found;
}


void Foam::demThermoHeat::beginStep()
{
    kappa_ = thermo_.kappa();
    Cp_ = thermo_.Cp();
    T_ = thermo_.T().primitiveField();
    energy_ = thermo_.he().primitiveField();
    Cpv_ = thermo_.Cpv()().primitiveField();
}


void Foam::demThermoHeat::addTo(const volScalarField& rho, fvMatrix<scalar>& eqn)
{
    const fvMesh& mesh = thermo_.T().mesh();
    volScalarField::Internal explicitPart("dem:heatExplicit", exchange_.source()());
    volScalarField::Internal coefficient
    (
        IOobject("dem:heatImplicit", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimDensity/dimTime, Zero)
    );

    forAll(T_, celli)
    {
        const scalar K = exchange_.coefficient()[celli];

        explicitPart[celli] += K*(energy_[celli]/Cpv_[celli] - T_[celli]);
        coefficient[celli] = K/Cpv_[celli];
    }

    rho_ = rho.primitiveField();
    eqn += explicitPart - fvm::Sp(coefficient, eqn.psi());
    asked_ = mesh.time().timeIndex();
}


void Foam::demThermoHeat::correct(const volScalarField& rho)
{
    const fvMesh& mesh = thermo_.T().mesh();

    if (asked_ != mesh.time().timeIndex())
    {
        FatalErrorInFunction
            << "The solver has not asked for the particles' heat in this time step: it"
            << " does not call fvOptions for " << thermo_.he().name() << ", or"
            << " demEnergySource is switched off, or not in the case's fvOptions. Take a"
            << " solver that does, buoyantPimpleFoam or rhoPimpleFoam for example, or set"
            << " twoWay no; in coupling of constant/" << demDict::name()
            << exit(FatalError);
    }

    const scalarField& V = mesh.V();
    const scalarField& he = thermo_.he();

    const demHeatExchange::contribution density
    {
        "density",
        gSum((V*(rho.primitiveField() - rho_)*he)())
    };

    cloud_.correctHeat
    (
        (T_ + (he - energy_)/Cpv_)(),
        gSum((V*rho.primitiveField()*he)()),
        List<demHeatExchange::contribution>(1, density)
    );
}
