/*---------------------------------------------------------------------------*\
    demFluidGradient.C -- pressure gradient of any solver, hydrostatic part included.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFluid.H"
#include "demDict.H"
#include "demDrivingForce.H"
#include "fvcGrad.H"
#include "fvcSnGrad.H"
#include "extrapolatedCalculatedFvPatchFields.H"
#include "fvcSurfaceIntegrate.H"
#include "surfaceInterpolate.H"
#include "surfaceFields.H"
#include "surfaceTensionModel.H"

// Particles do not feel the jump of the pressure across a curved interface: fluid and
// particles together would gain momentum from a drop at rest. Null without an interface. The
// solver's interfaceProperties registers the curvature and the model of surface tension.
Foam::tmp<Foam::surfaceScalarField> Foam::demFluid::capillaryGradient() const
{
    const volScalarField* curvature =
        mesh_.findObject<volScalarField>("interfaceProperties:K");
    const surfaceTensionModel* tension =
        mesh_.findObject<surfaceTensionModel>(surfaceTensionModel::typeName);

    for (const char* name : {"transportProperties", "thermophysicalProperties"})
    {
        const dictionary* properties = mesh_.findObject<dictionary>(name);

        if (curvature && tension && properties && properties->found("phases"))
        {
            const word phase(wordList(properties->lookup("phases"))[0]);
            const volScalarField& alpha =
                lookup<volScalarField>(mesh_, IOobject::groupName("alpha", phase));

            return fvc::interpolate(tension->sigma()*(*curvature))*fvc::snGrad(alpha);
        }
    }
    return nullptr;
}


// p = p_rgh + rho gh, so grad p - rho g = grad p_rgh + gh grad rho. On faces, as
// the solver balances it, this is zero in a fluid at rest, less the force of surface
// tension. The gradient of p in cells is not, where the density jumps.
Foam::tmp<Foam::volVectorField> Foam::demFluid::dynamicGradient
(
    const volScalarField& p_rgh
) const
{
    const volScalarField& rho = lookup<volScalarField>(mesh_, "rho");
    const surfaceScalarField& ghf = lookup<surfaceScalarField>(mesh_, "ghf");

    surfaceScalarField gradient(fvc::snGrad(p_rgh) + ghf*fvc::snGrad(rho));
    const tmp<surfaceScalarField> tcapillary(capillaryGradient());
    if (tcapillary.valid())
    {
        gradient -= tcapillary();
    }

    // As fvc::reconstruct, but with names for both factors: it multiplies a tensor by a
    // temporary vector, and a compiler may overwrite a component before it reads it
    const volTensorField inverse(inv(fvc::surfaceSum(mesh_.Sf()*mesh_.Sf()/mesh_.magSf())));
    const volVectorField sum(fvc::surfaceSum(mesh_.Sf()*gradient));
    tmp<volVectorField> tresult
    (
        new volVectorField
        (
            IOobject("dynamicGradient", mesh_.time().timeName(), mesh_),
            mesh_,
            gradient.dimensions(),
            extrapolatedCalculatedFvPatchVectorField::typeName
        )
    );
    tresult.ref().primitiveFieldRef() = inverse.primitiveField() & sum.primitiveField();
    tresult.ref().correctBoundaryConditions();
    return tresult;
}


Foam::tmp<Foam::volVectorField> Foam::demFluid::pressureGradient() const
{
    const dimensionedVector g("g", dimAcceleration, dict_.gravity());
    const volScalarField* p = mesh_.findObject<volScalarField>("p");
    const volScalarField* p_rgh = mesh_.findObject<volScalarField>("p_rgh");
    const tmp<volScalarField> trho(density());

    if (demDrivingForce::active(mesh_))
    {
        const volVectorField& U = velocity();
        const bool withDensity = p && p->dimensions() == dimPressure;
        const tmp<volVectorField> tdriving
        (
            withDensity
          ? demDrivingForce::source(U, dimForce/dimVolume)
          : trho()*demDrivingForce::source(U, dimAcceleration)
        );
        return solverGradient(p, p_rgh, trho(), g) - tdriving;
    }
    return solverGradient(p, p_rgh, trho(), g);
}


// Full pressure gradient from the pressure field of the solver
Foam::tmp<Foam::volVectorField> Foam::demFluid::solverGradient
(
    const volScalarField* p,
    const volScalarField* p_rgh,
    const volScalarField& rho,
    const dimensionedVector& g
) const
{
    if (p_rgh && p_rgh->dimensions() == dimPressure)
    {
        return dynamicGradient(*p_rgh) + rho*g;
    }
    if (!p)
    {
        return rho*g;
    }
    if (p_rgh)                  // over density: the Boussinesq solvers
    {
        return rho*fvc::grad(*p);
    }
    if (p->dimensions() == dimPressure)
    {
        return fvc::grad(*p) + rho*g;
    }
    return rho*(fvc::grad(*p) + g);
}
