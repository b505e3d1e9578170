/*---------------------------------------------------------------------------*\
    twoFluids.C -- properties of two fluids and forces at their interface.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "twoFluids.H"
#include "mixedFvPatchFields.H"
#include "surfaceTensionModel.H"
#include "demFiles.H"
#include "fvcSnGrad.H"
#include "mathematicalConstants.H"

namespace Foam
{

static const char* const where = "constant/transportProperties";


// The entry of a dictionary, or an error that says what is missing
static void require(const dictionary& dict, const word& entry, const string& meaning)
{
    if (!dict.found(entry))
    {
        FatalIOErrorInFunction(dict)
            << entry << " is missing in " << dict.dictName() << " of " << where
            << ": give " << meaning.c_str() << exit(FatalIOError);
    }
}


// The two names of phases, with their properties
static wordList checkedPhases(const dictionary& transport)
{
    require(transport, "phases", "the names of the two fluids, as phases (water air)");
    const wordList phases(transport.lookup("phases"));

    if (phases.size() != 2 || phases[0] == phases[1])
    {
        FatalIOErrorInFunction(transport)
            << "phases of " << where << " are " << flatOutput(phases)
            << "; demInterFoam needs two different names" << exit(FatalIOError);
    }
    for (const word& phase : phases)
    {
        if (!transport.isDict(phase))
        {
            FatalIOErrorInFunction(transport)
                << "phases of " << where << " names " << phase << ", but there is no"
                << " dictionary " << phase << " with its rho and nu; there are "
                << flatOutput(transport.sortedToc()) << exit(FatalIOError);
        }
        const dictionary& own = transport.subDict(phase);
        require(own, "rho", "the density of this fluid [kg/m3]");
        require(own, "transportModel", "the model of its viscosity, for example Newtonian");

        const scalar rho = dimensionedScalar("rho", dimDensity, own).value();
        if (!(rho > 0))
        {
            FatalIOErrorInFunction(own)
                << "rho of " << phase << " in " << where << " is " << rho
                << " kg/m3; it must be positive" << exit(FatalIOError);
        }
    }
    require
    (
        transport, "sigma", "the surface tension between the fluids [N/m], 0 for none"
    );
    return phases;
}


// Settings of the transport of alpha
static void checkControls(const fvMesh& mesh, const word& alpha)
{
    const dictionary& solvers = mesh.solutionDict().subDict("solvers");

    if (!solvers.found(alpha))
    {
        FatalIOErrorInFunction(solvers)
            << "system/fvSolution has no entry " << alpha << " in solvers: give "
            << alpha << " { cAlpha 1; nAlphaSubCycles 1; }" << exit(FatalIOError);
    }
    const dictionary& own = mesh.solverDict(alpha);

    if (!own.found("cAlpha"))
    {
        FatalIOErrorInFunction(own)
            << "cAlpha is missing in solvers/" << alpha << " of system/fvSolution: give"
            << " the strength of the interface compression, 1 for one" << exit(FatalIOError);
    }
    if (own.getOrDefault("MULESCorr", false))
    {
        FatalIOErrorInFunction(own)
            << "MULESCorr is yes in solvers/" << alpha << " of system/fvSolution;"
            << " demInterFoam has the explicit MULES only: give MULESCorr no, and"
            << " a step or nAlphaSubCycles with an interface Courant number below 0.5"
            << exit(FatalIOError);
    }
    const label n = own.getOrDefault<label>("nAlphaSubCycles", 1);
    if (n < 1)
    {
        FatalIOErrorInFunction(own)
            << "nAlphaSubCycles is " << n << " in solvers/" << alpha
            << " of system/fvSolution; it must be 1 or more" << exit(FatalIOError);
    }
}


static tmp<volScalarField> sigmaOf(const fvMesh& mesh)
{
    return mesh.lookupObject<surfaceTensionModel>(surfaceTensionModel::typeName).sigma();
}

} // End namespace Foam


const Foam::volVectorField& Foam::twoFluids::checked(const volVectorField& U)
{
    const fvMesh& mesh = U.mesh();
    const Time& time = mesh.time();
    IOobject file(demFileAt(time.constant(), "transportProperties", mesh, IOobject::MUST_READ));

    if (!file.typeHeaderOk<IOdictionary>(true))
    {
        FatalErrorInFunction
            << where << " is missing: demInterFoam needs phases, their rho and nu, and"
            << " sigma there" << exit(FatalError);
    }
    const wordList phases(checkedPhases(IOdictionary(file)));
    const word alpha(IOobject::groupName("alpha", phases[0]));
    IOobject initial(demFileAt(time.timeName(), alpha, mesh, IOobject::MUST_READ));

    if (!initial.typeHeaderOk<volScalarField>(true))
    {
        FatalErrorInFunction
            << time.timeName() << '/' << alpha << " is missing: give the volume fraction of "
            << phases[0] << ", the first of the phases of " << where << exit(FatalError);
    }
    checkControls(mesh, alpha);
    return U;
}


// More than round-off, which a restart may read
void Foam::twoFluids::checkAlpha() const
{
    const volScalarField& alpha = mixture_.alpha1();
    const scalar least = gMin(alpha.primitiveField());
    const scalar most = gMax(alpha.primitiveField());

    if (!(least > -1e-6 && most < 1 + 1e-6))
    {
        FatalErrorInFunction
            << alpha.name() << " of " << alpha.time().timeName() << " lies between "
            << least << " and " << most << "; it is a volume fraction, from 0 to 1"
            << exit(FatalError);
    }

    const fvBoundaryMesh& patches = alpha.mesh().boundary();
    for (label patchi = 0; patchi < alpha.mesh().boundaryMesh().nNonProcessor(); ++patchi)
    {
        const fvPatchScalarField& field = alpha.boundaryField()[patchi];
        const auto* mixed = isA<mixedFvPatchScalarField>(field);    // inletOutlet, say

        if (!mixed && !field.fixesValue())
        {
            continue;
        }
        const scalarField& value = mixed ? mixed->refValue() : field;
        const scalar low = gMin(value);
        const scalar high = gMax(value);

        if (!(low > -1e-6 && high < 1 + 1e-6))
        {
            FatalErrorInFunction
                << alpha.name() << " of " << alpha.time().timeName() << " on patch "
                << patches[patchi].name() << " lies between " << low << " and " << high
                << "; it is a volume fraction: give a fixed value from 0 to 1"
                << exit(FatalError);
        }
    }
}


void Foam::twoFluids::checkTension() const
{
    const scalar least = gMin(sigmaOf(rho_.mesh())().primitiveField());

    if (!(least >= 0))
    {
        FatalErrorInFunction
            << "sigma of " << where << " is " << least << " N/m; it must be positive, or 0 for"
            << " no surface tension" << exit(FatalError);
    }
}


Foam::twoFluids::twoFluids
(
    const volVectorField& U,
    const surfaceScalarField& phi
)
:
    mixture_(checked(U), phi),
    rho_
    (
        demFieldAt(U.mesh(), "rho"),
        mixture_.alpha1()*mixture_.rho1() + (1 - mixture_.alpha1())*mixture_.rho2()
    )
{
    checkAlpha();
    checkTension();
}


void Foam::twoFluids::correct()
{
    mixture_.correct();
    rho_ = mixture_.alpha1()*mixture_.rho1() + (1 - mixture_.alpha1())*mixture_.rho2();
}


Foam::tmp<Foam::surfaceScalarField> Foam::twoFluids::massFlux
(
    const surfaceScalarField& flux,
    const surfaceScalarField& alphaFlux
) const
{
    return (mixture_.rho1() - mixture_.rho2())*alphaFlux + mixture_.rho2()*flux;
}


Foam::tmp<Foam::surfaceScalarField> Foam::twoFluids::gravity
(
    const surfaceScalarField& ghf
) const
{
    return ghf*fvc::snGrad(rho_)*rho_.mesh().magSf();
}


Foam::tmp<Foam::surfaceScalarField> Foam::twoFluids::capillarity() const
{
    return -mixture_.surfaceTensionForce()*rho_.mesh().magSf();
}


Foam::scalar Foam::twoFluids::capillaryStep() const
{
    const fvMesh& mesh = rho_.mesh();
    const scalar sigma = gMax(sigmaOf(mesh)().primitiveField());
    const surfaceScalarField& inverse = mesh.nonOrthDeltaCoeffs();
    scalar most = max(scalar(0), max(inverse.primitiveField()));

    // of all faces between two cells, on any number of ranks
    for (const fvsPatchScalarField& patch : inverse.boundaryField())
    {
        most = patch.coupled() ? max(most, max(patch)) : most;
    }
    reduce(most, maxOp<scalar>());
    if (!(sigma > 0 && most > 0))
    {
        return GREAT;
    }
    const scalar h = 1/most;

    return sqrt
    (
        (mixture_.rho1().value() + mixture_.rho2().value())*pow3(h)
       /(4*constant::mathematical::pi*sigma)
    );
}
