/*---------------------------------------------------------------------------*\
    demFlowQuantities.C -- quantities of the fluid that only some effects need.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFlowQuantities.H"
#include "dem_plan.h"
#include "demColumns.H"
#include "demFiles.H"
#include "demUnderRelaxation.H"
#include "turbulenceModel.H"
#include "fvcGrad.H"
#include "fvcSnGrad.H"
#include "fvcSurfaceIntegrate.H"
#include "linear.H"

namespace Foam
{

// Divergence of the stress from face fluxes: needs no entry in fvSchemes that
// the solver itself does not use
static tmp<volVectorField> divStress
(
    const volVectorField& U,
    const volScalarField& mu
)
{
    const fvMesh& mesh = U.mesh();
    const volTensorField gradU(fvc::grad(U));

    return fvc::surfaceIntegrate
    (
        linearInterpolate(mu)*mesh.magSf()*fvc::snGrad(U)
      + (mesh.Sf() & linearInterpolate(mu*dev2(T(gradU))))
    );
}

} // End namespace Foam


void Foam::demFlowQuantities::setTurbulence() const
{
    const turbulenceModel* model =
        mesh_.findObject<turbulenceModel>(turbulenceModel::propertiesName);

    // These have no k
    if
    (
        !model
     || word(model->lookup("simulationType")) == "laminar"
     || model->type().find("SpalartAllmaras") != std::string::npos
    )
    {
        FatalErrorInFunction
            << "The effect " << particles_.dict().effectWith(DEM_TRAIT_TURBULENCE)
            << " needs the turbulent kinetic energy of the fluid and its"
            << " dissipation, but "
            << (model ? "the model " + model->type() : string("the solver"))
            << " has none"
            << "; choose another model, of type RAS or LES, in"
            << " constant/turbulenceProperties, or leave the effect out"
            << exit(FatalError);
    }

    const scalarField k(transfer_.sample(model->k()()));
    const scalarField epsilon(transfer_.sample(model->epsilon()()));

    forAll(k, i)
    {
        fluid_.turbulence[2*i] = k[i];
        fluid_.turbulence[2*i + 1] = epsilon[i];
    }
}


void Foam::demFlowQuantities::setMeanDiameter() const
{
    scalarField V(volumes(particles_.view()));
    scalarField volume, perDiameter;

    // Whole spheres, as below, even near patches, where the void fraction counts only a
    // fraction of their volume
    transfer_.deposit(V, volume);
    forAll(V, i)
    {
        V[i] /= 2*(*dem_at(particles_.view().radius, particles_.view().stride, i));
    }
    transfer_.deposit(V, perDiameter);

    const scalarField n(transfer_.sample(perDiameter));
    const scalarField s(transfer_.sample(volume));

    forAll(V, i)
    {
        fluid_.mean_diameter[i] = dem_sauter_diameter(s[i], n[i]);
    }
}


Foam::demFlowQuantities::demFlowQuantities(const demParticles& particles)
:
    mesh_(particles.mesh()),
    particles_(particles),
    fluid_(particles.fluid()),
    transfer_(particles.transfer()),
    frames_(demRotatingFrame::all(mesh_)),
    acceleration_
    (
        particles.dict().effectWith(DEM_TRAIT_FLUID_ACCELERATION).empty()
      ? nullptr
      : new volVectorField
        (
            demFieldAt(mesh_, "fluidAcceleration", IOobject::READ_IF_PRESENT),
            mesh_,
            dimensionedVector(dimAcceleration, Zero)
        )
    )
{}


void Foam::demFlowQuantities::updateAcceleration(const volVectorField& U)
{
    if (!acceleration_)
    {
        return;
    }

    volVectorField& a = acceleration_();
    const volTensorField gradU(fvc::grad(U));

    a = U & gradU;

    // On a moving mesh du/dt, below, is the derivative along the cells. Their motion is found from
    // their points, as the reconstruction of meshPhi is 1.5 % off in the cells of a ring
    // (tests/coupled/rotating).
    if (mesh_.moving())
    {
        const pointField path(mesh_.points() - mesh_.oldPoints());

        forAll(gradU, celli)
        {
            const vector moved(average(vectorField(path, mesh_.cellPoints()[celli])));
            a[celli] -= moved/mesh_.time().deltaTValue() & gradU[celli];
        }
    }

    // In a rotating frame du/dt, below, is the derivative in that frame (demRotatingFrame.H)
    for (const demRotatingFrame& frame : frames_)
    {
        for (const label celli : frame.cells())
        {
            a[celli] +=
                (frame.omega() ^ U[celli])
              - (frame.velocity(mesh_.C()[celli]) & gradU[celli]);
        }
    }

    if (particles_.interval() <= 0)
    {
        a += (U - U.oldTime())/mesh_.time().deltaT();
    }
}


void Foam::demFlowQuantities::set
(
    const volVectorField& U,
    const volScalarField& mu
) const
{
    if (fluid_.acceleration && !demUnderRelaxation::active(fluid_))
    {
        toColumn(sampleAcceleration()(), fluid_.acceleration);
    }

    if (fluid_.vorticity)
    {
        const volVectorField curl(2*(*skew(fvc::grad(U)())));
        toColumn(transfer_.sample(curl)(), fluid_.vorticity);
    }

    if (fluid_.stress)
    {
        const turbulenceModel* model =
            mesh_.findObject<turbulenceModel>(turbulenceModel::propertiesName);

        const volScalarField muEff
        (
            model ? mu*model->nuEff()/model->nu() : tmp<volScalarField>(mu)
        );
        toColumn(transfer_.sample(divStress(U, muEff)())(), fluid_.stress);
    }

    if (fluid_.turbulence)
    {
        setTurbulence();
    }

    if (fluid_.mean_diameter)
    {
        setMeanDiameter();
    }
}


void Foam::demFlowQuantities::note(const string& heading)
{
    if (acceleration_)
    {
        acceleration_().note() = heading;
    }
}


void Foam::demFlowQuantities::write() const
{
    if (acceleration_)
    {
        acceleration_().write();
    }
}
