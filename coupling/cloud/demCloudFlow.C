/*---------------------------------------------------------------------------*\
    demCloudFlow.C -- quantities of the fluid that only some effects need.

    Each fills a column of the core that exists only when an effect asks for it:

        acceleration   Du/Dt = du/dt + u.grad u                        [m/s2]
                       in rotating frames (MRF) see demRotatingFrame
        vorticity      curl u                                           [1/s]
        stress         div tau, viscous and turbulent                  [N/m3]
        turbulence     k and epsilon                        [m2/s2], [m2/s3]
        meanDiameter   sum V_i w_ic / sum (V_i/d_i) w_ic, Sauter mean     [m]

    The acceleration is that of the previous step, from the velocities at its
    ends, since the fluid is frozen while particles move. It is a field of its
    own, written for a restart.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demColumns.H"
#include "turbulenceModel.H"
#include "fvcGrad.H"
#include "fvcMeshPhi.H"
#include "fvcReconstruct.H"
#include "fvcSnGrad.H"
#include "fvcSurfaceIntegrate.H"
#include "linear.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// At the end of a step, while the old velocity is still available
void Foam::demCloud::updateAcceleration(const volVectorField& U)
{
    if (!acceleration_)
    {
        return;
    }

    volVectorField& a = acceleration_();
    const volTensorField gradU(fvc::grad(U));

    // On a moving mesh, relative to the cells
    if (mesh_.moving())
    {
        a = (U - fvc::reconstruct(fvc::meshPhi(U))) & gradU;
    }
    else
    {
        a = U & gradU;
    }

    // In a rotating frame the old velocity is that of the frame's past
    for (const demRotatingFrame& frame : frames_)
    {
        for (const label celli : frame.cells())
        {
            a[celli] +=
                (frame.omega() ^ U[celli])
              - (frame.velocity(mesh_.C()[celli]) & gradU[celli]);
        }
    }

    if (interval_ <= 0)
    {
        a += (U - U.oldTime())/mesh_.time().deltaT();
    }
}


void Foam::demCloud::setFluidGradients
(
    const volVectorField& U,
    const volScalarField& mu
)
{
    if (fluid_.acceleration)
    {
        // Under-relaxed values have been set in correct()
        if (!demUnderRelaxation::active(fluid_))
        {
            toColumn(transfer_.sample(acceleration_())(), fluid_.acceleration);
        }
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


void Foam::demCloud::setTurbulence()
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
            << "The effect " << dict_.effectWith(DEM_TRAIT_TURBULENCE)
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


void Foam::demCloud::setMeanDiameter()
{
    scalarField V(volumes(view_));
    scalarField volume, perDiameter;

    // Of whole spheres, as below, also near patches where the void fraction
    // contains a fraction of their volume
    transfer_.deposit(V, volume);
    forAll(V, i)
    {
        V[i] /= 2*(*dem_at(view_.radius, view_.stride, i));
    }
    transfer_.deposit(V, perDiameter);

    const scalarField n(transfer_.sample(perDiameter));
    const scalarField s(transfer_.sample(volume));

    forAll(V, i)
    {
        fluid_.mean_diameter[i] = dem_sauter_diameter(s[i], n[i]);
    }
}

// ************************************************************************* //
