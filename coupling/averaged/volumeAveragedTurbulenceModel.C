/*---------------------------------------------------------------------------*\
    volumeAveragedTurbulenceModel.C -- models of turbulence in the void space, and their
    selection.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "volumeAveragedTurbulenceModel.H"
#include "demFiles.H"
#include "linearViscousStress.H"
#include "makeTurbulenceModel.H"
#include "fvcGrad.H"
#include "fvMatrix.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{

static const geometricOneField whole;


// The model of a type by its name in constant/turbulenceProperties
template<class Family>
static autoPtr<volumeAveragedTurbulenceModel> select
(
    const dictionary& properties,
    const word& type,
    const volScalarField& voidFraction,
    const volVectorField& U,
    const surfaceScalarField& alphaPhi,
    const transportModel& transport
)
{
    const dictionary& dict = properties.subOrEmptyDict(type);

    // "model" of newer versions has the name of the type before it in older ones
    for (const word& key : {word("model"), word(type + "Model")})
    {
        const word name(dict.lookupOrDefault<word>(key, word::null));

        if (!name.empty() && !Family::dictionaryConstructorTablePtr_->found(name))
        {
            FatalIOErrorInFunction(dict)
                << key << ' ' << name << " of constant/turbulenceProperties has no"
                << " form for the fluid among particles, whose volume fraction"
                << " varies; of type " << type << " there are";

            for (const word& one : Family::dictionaryConstructorTablePtr_->sortedToc())
            {
                FatalIOError<< ' ' << one;
            }
            FatalIOError<< exit(FatalIOError);
        }
    }

    return autoPtr<volumeAveragedTurbulenceModel>
    (
        Family::New
        (
            voidFraction,
            whole,
            U,
            alphaPhi,
            alphaPhi,
            transport,
            turbulenceModel::propertiesName
        ).ptr()
    );
}

} // End namespace Foam


Foam::volumeAveragedTurbulenceModel::volumeAveragedTurbulenceModel
(
    const word& type,
    const volScalarField& voidFraction,
    const geometricOneField& rho,
    const volVectorField& U,
    const surfaceScalarField& alphaPhi,
    const surfaceScalarField& phi,
    const transportModel& transport,
    const word& propertiesName
)
:
    incompressible::turbulenceModel
    (
        type,
        whole,
        rho,
        U,
        alphaPhi,
        phi,
        transport,
        propertiesName
    ),
    alpha_(voidFraction)
{}


Foam::autoPtr<Foam::volumeAveragedTurbulenceModel>
Foam::volumeAveragedTurbulenceModel::New
(
    const volScalarField& voidFraction,
    const volVectorField& U,
    const surfaceScalarField& alphaPhi,
    const transportModel& transport
)
{
    const IOdictionary properties
    (
        demFileAt(U.time().constant(), propertiesName, U.db(), IOobject::MUST_READ)
    );
    const word type(properties.lookup("simulationType"));

    Info<< "Selecting turbulence model type " << type << endl;

    if (type == "laminar")
    {
        return select<laminarvolumeAveragedTurbulenceModel>
        (
            properties, type, voidFraction, U, alphaPhi, transport
        );
    }
    if (type == "RAS")
    {
        return select<RASvolumeAveragedTurbulenceModel>
        (
            properties, type, voidFraction, U, alphaPhi, transport
        );
    }
    if (type == "LES")
    {
        return select<LESvolumeAveragedTurbulenceModel>
        (
            properties, type, voidFraction, U, alphaPhi, transport
        );
    }

    FatalIOErrorInFunction(properties)
        << "simulationType of constant/turbulenceProperties is " << type
        << "; there are laminar, RAS and LES" << exit(FatalIOError);

    return nullptr;
}


Foam::tmp<Foam::surfaceScalarField>
Foam::volumeAveragedTurbulenceModel::phi() const
{
    tmp<surfaceScalarField> tphi
    (
        new surfaceScalarField
        (
            demFileAt(runTime_.timeName(), "none", mesh_, IOobject::NO_READ),
            mesh_,
            dimensionedScalar(alphaRhoPhi_.dimensions(), Zero)
        )
    );
    tphi.ref().setOriented();

    if (mesh_.moving())
    {
        tphi.ref() -= mesh_.phi();
    }
    return tphi;
}


bool Foam::volumeAveragedTurbulenceModel::isNewtonian() const
{
    return
        isA<linearViscousStress<laminarvolumeAveragedTurbulenceModel>>(*this)
     || isA<linearViscousStress<RASvolumeAveragedTurbulenceModel>>(*this)
     || isA<linearViscousStress<LESvolumeAveragedTurbulenceModel>>(*this);
}


Foam::tmp<Foam::volSymmTensorField>
Foam::volumeAveragedTurbulenceModel::stress() const
{
    return ((2.0/3.0)*alpha_*k())*symmTensor::I - devReff();
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::volumeAveragedTurbulenceModel::divStress(volVectorField& U) const
{
    return divDevReff(U) - fvc::grad((2.0/3.0)*alpha_*k());
}


// * * * * * * * * * * * * * * * * * Types * * * * * * * * * * * * * * * * * //

namespace Foam
{
    defineNamedTemplateTypeNameAndDebug(laminarvolumeAveragedTurbulenceModel, 0);
    defineTemplateRunTimeSelectionTable(laminarvolumeAveragedTurbulenceModel, dictionary);

    defineNamedTemplateTypeNameAndDebug(RASvolumeAveragedTurbulenceModel, 0);
    defineTemplateRunTimeSelectionTable(RASvolumeAveragedTurbulenceModel, dictionary);

    defineNamedTemplateTypeNameAndDebug(LESvolumeAveragedTurbulenceModel, 0);
    defineTemplateRunTimeSelectionTable(LESvolumeAveragedTurbulenceModel, dictionary);
}

#define laminarType(Type) \
    makeTemplatedTurbulenceModel(volumeAveragedTurbulenceModel, laminar, Type)
#define RASType(Type) \
    makeTemplatedTurbulenceModel(volumeAveragedTurbulenceModel, RAS, Type)
#define LESType(Type) \
    makeTemplatedTurbulenceModel(volumeAveragedTurbulenceModel, LES, Type)

#include "Stokes.H"
laminarType(Stokes)

#include "Maxwell.H"
laminarType(Maxwell)

// In some versions only
#if __has_include(<generalizedNewtonian.H>)
#include <generalizedNewtonian.H>
laminarType(generalizedNewtonian)
#endif

#include "SpalartAllmaras.H"
RASType(SpalartAllmaras)

#include "kEpsilon.H"
RASType(kEpsilon)

#include "RNGkEpsilon.H"
RASType(RNGkEpsilon)

#include "realizableKE.H"
RASType(realizableKE)

#include "LaunderSharmaKE.H"
RASType(LaunderSharmaKE)

#include "kOmega.H"
RASType(kOmega)

#include "kOmegaSST.H"
RASType(kOmegaSST)

#include "kOmegaSSTSAS.H"
RASType(kOmegaSSTSAS)

#include "kOmegaSSTLM.H"
RASType(kOmegaSSTLM)

#include "kEpsilonPhitF.H"
RASType(kEpsilonPhitF)

#include "LRR.H"
RASType(LRR)

#include "SSG.H"
RASType(SSG)

// In some versions only
#if __has_include(<v2f.H>)
#include <v2f.H>
RASType(v2f)
#endif
#if __has_include(<EBRSM.H>)
#include <EBRSM.H>
RASType(EBRSM)
#endif

#include "Smagorinsky.H"
LESType(Smagorinsky)

#include "WALE.H"
LESType(WALE)

#include "kEqn.H"
LESType(kEqn)

#include "dynamicKEqn.H"
LESType(dynamicKEqn)

#include "dynamicLagrangian.H"
LESType(dynamicLagrangian)

#include "DeardorffDiffStress.H"
LESType(DeardorffDiffStress)

#include "SpalartAllmarasDES.H"
LESType(SpalartAllmarasDES)

#include "SpalartAllmarasDDES.H"
LESType(SpalartAllmarasDDES)

#include "SpalartAllmarasIDDES.H"
LESType(SpalartAllmarasIDDES)

#include "kOmegaSSTDES.H"
LESType(kOmegaSSTDES)

#include "kOmegaSSTDDES.H"
LESType(kOmegaSSTDDES)

#include "kOmegaSSTIDDES.H"
LESType(kOmegaSSTIDDES)
