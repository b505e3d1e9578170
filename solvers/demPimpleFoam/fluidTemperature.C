/*---------------------------------------------------------------------------*\
    fluidTemperature.C -- temperature of the fluid, which exchanges heat with particles.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidTemperature.H"
#include "checkRelaxation.H"
#include "checkTimeScheme.H"
#include "demFiles.H"
#include "fluidBudget.H"
#include "fvCFD.H"
#include "fvOptions.H"

namespace Foam
{

static IOobject temperatureFile(const fvMesh& mesh, const demHeatExchange& exchange)
{
    IOobject io(demFieldAt(mesh, "T", IOobject::MUST_READ, IOobject::AUTO_WRITE));

    if (!io.typeHeaderOk<volScalarField>(true))
    {
        FatalErrorInFunction
            << exchange.reason().c_str() << ", but there is no field "
            << io.instance().c_str() << "/T; give it, the temperature of the fluid [K],"
            << " or leave the effect out" << exit(FatalError);
    }
    return io;
}


// A number of transportProperties above zero
static dimensionedScalar positive
(
    const dictionary& transport,
    const word& name,
    const dimensionSet& dimensions,
    const char* what,
    const demHeatExchange& exchange
)
{
    if (!transport.found(name))
    {
        FatalIOErrorInFunction(transport)
            << exchange.reason().c_str() << ", which needs the " << what
            << " of the fluid: add " << name << " to constant/transportProperties"
            << exit(FatalIOError);
    }

    const dimensionedScalar value(name, dimensions, transport);

    if (value.value() <= 0)
    {
        FatalIOErrorInFunction(transport)
            << name << ", the " << what << " of the fluid, is " << value.value()
            << "; it must be positive" << exit(FatalIOError);
    }
    return value;
}


static volScalarField uniform(const fvMesh& mesh, const dimensionedScalar& value)
{
    return volScalarField
    (
        IOobject("dem:" + value.name(), mesh.time().timeName(), mesh),
        mesh,
        value
    );
}

} // End namespace Foam


Foam::fluidTemperature::fluidTemperature
(
    demCloud& cloud,
    const dictionary& transport,
    const volScalarField& voidFraction,
    const surfaceScalarField& alphaPhi,
    const dimensionedScalar& rho
)
:
    cloud_(cloud),
    exchange_(cloud.heat()),
    twoWay_(cloud.particles().twoWay()),
    voidFraction_(voidFraction),
    alphaPhi_(alphaPhi),
    T_(temperatureFile(voidFraction.mesh(), exchange_), voidFraction.mesh()),
    kappa_
    (
        uniform
        (
            T_.mesh(),
            positive
            (
                transport,
                "kappa",
                dimPower/dimLength/dimTemperature,
                "thermal conductivity [W/m/K]",
                exchange_
            )
        )
    ),
    Cp_
    (
        uniform
        (
            T_.mesh(),
            positive
            (
                transport,
                "Cp",
                dimSpecificHeatCapacity,
                "specific heat capacity [J/kg/K]",
                exchange_
            )
        )
    ),
    rhoCp_(rho*dimensionedScalar("Cp", dimSpecificHeatCapacity, transport)),
    Prt_
    (
        transport.found("Prt")
      ? positive(transport, "Prt", dimless, "turbulent Prandtl number", exchange_)
      : dimensionedScalar("Prt", dimless, 0.85)
    ),
    beta_
    (
        transport.found("beta")
      ? dimensionedScalar("beta", dimless/dimTemperature, transport)
      : dimensionedScalar(dimless/dimTemperature, Zero)
    ),
    TRef_
    (
        transport.found("beta")
      ? positive
        (
            transport, "TRef", dimTemperature, "temperature [K] of density rho", exchange_
        )
      : dimensionedScalar(dimTemperature, Zero)
    )
{
    checkTimeScheme(T_.mesh(), "ddt(voidFraction,T)");
    checkRelaxation(T_.mesh(), T_.name());
    exchange_.setFluid(T_, kappa_, Cp_);
}


Foam::tmp<Foam::surfaceScalarField> Foam::fluidTemperature::buoyancy
(
    const dimensionedVector& g
) const
{
    return -beta_*(fvc::interpolate(T_) - TRef_)*(g & T_.mesh().Sf());
}


void Foam::fluidTemperature::solve(const volScalarField& nut, const bool last)
{
    const fvMesh& mesh = T_.mesh();
    fv::options& fvOptions(fv::options::New(mesh));
    const volScalarField alphaEff
    (
        "alphaEff",
        voidFraction_*(kappa_/rhoCp_ + nut/Prt_)
    );
    const volScalarField continuityError(fvc::ddt(voidFraction_) + fvc::div(alphaPhi_));

    const tmp<fvScalarMatrix> sources(fvOptions(T_));

    fvScalarMatrix TEqn
    (
        fvm::ddt(voidFraction_, T_)
      + fvm::div(alphaPhi_, T_)
      - fvm::Sp(continuityError, T_)
      - fvm::laplacian(alphaEff, T_)
     ==
        exchange_.source()/rhoCp_
      - fvm::Sp(exchange_.coefficient()/rhoCp_, T_)
      + sources()
    );

    TEqn.relax();
    fvOptions.constrain(TEqn);
    TEqn.solve();
    fvOptions.correct(T_);

    if (last)
    {
        count(TEqn, sources(), continuityError);
    }
}


void Foam::fluidTemperature::count
(
    const fvScalarMatrix& TEqn,
    const fvScalarMatrix& sources,
    const volScalarField& continuityError
)
{
    const scalar rhoCpDeltaT = rhoCp_.value()*T_.mesh().time().deltaTValue();
    const scalarField& V = T_.mesh().V();

    // The coefficients of a patch contain convection and conduction together; convection
    // is alphaPhi T of the patch, conduction the difference
    received_.clear();
    forAll(T_.boundaryField(), patchi)
    {
        const fvPatchScalarField& Tp = T_.boundaryField()[patchi];

        if (fluidBudget::isCounted(Tp.patch()))
        {
            const scalar total = gSum
            (
                (
                    TEqn.boundaryCoeffs()[patchi]
                  - TEqn.internalCoeffs()[patchi]*Tp.patchInternalField()
                )()
            );
            const scalar flow = -gSum((alphaPhi_.boundaryField()[patchi]*Tp)());
            const std::string& name = Tp.patch().name();

            received_.append({"flow:" + name, rhoCpDeltaT*flow});
            received_.append({"conduction:" + name, rhoCpDeltaT*(total - flow)});
        }
    }
    received_.append
    ({
        "continuity",
        rhoCpDeltaT
       *gSum((V*continuityError.primitiveField()*T_.primitiveField())())
    });
    if (fv::options::New(T_.mesh()).appliesToField(T_.name()))
    {
        const volScalarField rate(sources & T_);
        received_.append({"sources", rhoCpDeltaT*gSum((V*rate.primitiveField())())});
    }
}


void Foam::fluidTemperature::correct()
{
    if (twoWay_)
    {
        const scalarField& V = T_.mesh().V();

        cloud_.correctHeat
        (
            T_.primitiveField(),
            rhoCp_.value()*gSum((V*voidFraction_.primitiveField()*T_.primitiveField())()),
            received_
        );
    }
}
