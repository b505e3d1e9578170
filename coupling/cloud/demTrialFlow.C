/*---------------------------------------------------------------------------*\
    demTrialFlow.C -- momentum and pressure equation on fields of their own.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demTrialFlow.H"
#include "fvMatrices.H"
#include "fvcSurfaceIntegrate.H"
#include "fvmSup.H"
#include "gaussConvectionScheme.H"
#include "gaussGrad.H"
#include "gaussLaplacianScheme.H"
#include "linear.H"
#include "uncorrectedSnGrad.H"
#include "upwind.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Patches where the field is fixed have its values, others no gradient
template<class Type>
static wordList trialTypes(const fvMesh& mesh, const GeometricField<Type, fvPatchField, volMesh>& f)
{
    wordList types(mesh.boundary().size(), "zeroGradient");

    forAll(types, patchi)
    {
        if (f.boundaryField()[patchi].fixesValue())
        {
            types[patchi] = "fixedValue";
        }
    }
    return types;
}


template<class Type>
static tmp<fvMatrix<Type>> trialLaplacian
(
    const surfaceScalarField& gamma,
    const GeometricField<Type, fvPatchField, volMesh>& f
)
{
    const fvMesh& mesh = f.mesh();

    return fv::gaussLaplacianScheme<Type, scalar>
    (
        mesh,
        tmp<surfaceInterpolationScheme<scalar>>(new linear<scalar>(mesh)),
        tmp<fv::snGradScheme<Type>>(new fv::uncorrectedSnGrad<Type>(mesh))
    ).fvmLaplacian(gamma, f);
}


static label iterations(const fvMesh& mesh, const char* name, const label usual)
{
    for (const char* algorithm : {"PIMPLE", "PISO", "SIMPLE"})
    {
        if (mesh.solutionDict().found(algorithm))
        {
            return mesh.solutionDict().subDict(algorithm).getOrDefault<label>(name, usual);
        }
    }
    return usual;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::demTrialFlow::pressureName(const fvMesh& mesh)
{
    return mesh.foundObject<volScalarField>("p_rgh") ? "p_rgh" : "p";
}


Foam::dictionary Foam::demTrialFlow::linearSolver(const word& name, const bool final) const
{
    const dictionary& solvers = mesh_.solutionDict().subDict("solvers");

    const word last(name + "Final");

    return solvers.subDict(final && solvers.found(last) ? last : name);
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demTrialFlow::demTrialFlow
(
    fvMesh& mesh,
    const demCloud& cloud,
    const volVectorField& U,
    const scalar rho,
    const scalar nu
)
:
    mesh_(mesh),
    cloud_(cloud),
    pName_(pressureName(mesh)),
    outer_(max(iterations(mesh, "nOuterCorrectors", 1), label(1))),
    pressure_(max(iterations(mesh, "nCorrectors", 1), label(1))),
    nonOrthogonal_(iterations(mesh, "nNonOrthogonalCorrectors", 0)),
    U_
    (
        IOobject("dem:trialU", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        trialTypes(mesh, U)
    ),
    p_
    (
        IOobject("dem:trialP", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(sqr(dimVelocity), Zero),
        trialTypes(mesh, mesh.lookupObject<volScalarField>(pName_))
    ),
    nu_
    (
        IOobject("dem:trialNu", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("nu", dimViscosity, nu)
    ),
    rho_("rho", dimDensity, rho)
{
    U_.primitiveFieldRef() = U.primitiveField();
    forAll(U_.boundaryField(), patchi)
    {
        if (U_.boundaryField()[patchi].fixesValue())
        {
            U_.boundaryFieldRef()[patchi] == U.boundaryField()[patchi];
        }
    }
    U_.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::demTrialFlow::possible(const fvMesh& mesh)
{
    const dictionary solvers(mesh.solutionDict().subOrEmptyDict("solvers"));
    const word p(pressureName(mesh));

    return
        mesh.foundObject<volScalarField>(p) && solvers.found("U") && solvers.found(p);
}


void Foam::demTrialFlow::solve(const scalar deltaT)
{
    const dimensionedScalar perTime("perTime", dimless/dimTime, 1/deltaT);
    const volVectorField old(U_);
    const linear<vector> onFaces(mesh_);
    const linear<scalar> scalarOnFaces(mesh_);
    const bool twoWay = cloud_.particles().twoWay();

    for (label i = 0; i < outer_; i++)
    {
        const surfaceScalarField phi(onFaces.interpolate(U_) & mesh_.Sf());

        fvVectorMatrix equation
        (
            fvm::Sp(perTime, U_) - perTime*old
          + fv::gaussConvectionScheme<vector>
            (
                mesh_,
                phi,
                tmp<surfaceInterpolationScheme<vector>>(new upwind<vector>(mesh_, phi))
            ).fvmDiv(phi, U_)
          - trialLaplacian(nu_, U_)
        );
        if (twoWay)
        {
            equation -= cloud_.exchange().force()/rho_;
            equation += fvm::Sp(cloud_.exchange().drag()/rho_, U_);
        }

        const volVectorField gradP(fv::gaussGrad<scalar>(mesh_).calcGrad(p_, "dem:trialGradP"));
        Foam::solve(equation == -gradP, linearSolver("U", false));

        for (label k = 0; k < pressure_; k++)
        {
            const volScalarField rA(1/equation.A());
            const volVectorField HbyA(rA*equation.H());
            const surfaceScalarField flux(onFaces.interpolate(HbyA) & mesh_.Sf());
            const surfaceScalarField rAf(scalarOnFaces.interpolate(rA));

            for (label n = 0; n <= nonOrthogonal_; n++)
            {
                fvScalarMatrix pressureEquation
                (
                    trialLaplacian(rAf, p_) == fvc::surfaceIntegrate(flux)
                );
                pressureEquation.setReference(0, 0);
                pressureEquation.solve
                (
                    linearSolver(pName_, i == outer_ - 1 && k == pressure_ - 1)
                );
            }
            U_ =
                HbyA
              - rA*fv::gaussGrad<scalar>(mesh_).calcGrad(p_, "dem:trialGradP");
            U_.correctBoundaryConditions();
        }
    }
}

// ************************************************************************* //
