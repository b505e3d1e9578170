/*---------------------------------------------------------------------------*\
    demPimpleFoam.C -- transient, incompressible flow coupled with particles.

Application
    demPimpleFoam

Description
    Transient, incompressible, volume-averaged flow coupled with discrete
    particles. Set II ("model A") of Zhou, Kuang, Chu and Yu, J. Fluid Mech.
    661 (2010) 482, divided by the fluid's density:

        d(e U)/dt + div(e U U) = - e grad p + div(e tau) + (F - K U)/rho
        div(e U) = ds/dt

    e       void fraction, 1 - s                                       [1]
    U       interstitial velocity                                    [m/s]
    p       pressure over density, *without* the hydrostatic part  [m2/s2]
    tau     viscous and turbulent stress over density              [m2/s2]
    F       explicit part of the particles' reaction                [N/m3]
    K       coefficient of its implicit part                     [kg/m3/s]
    ds/dt   change of the solid fraction over the step, from the
            particles' positions                                     [1/s]

    F and K are defined in demExchange.H, with the pressure response that
    adds to -e grad p while the pressure changes. Where the particles feel the
    stress (effect viscousStress) F contains their fraction of it, - s div tau,
    and div(tau) replaces div(e tau).

    With p free of the hydrostatic part gravity drops out of the equation:
    -e grad(p + g.x) + e g = -e grad p; a bed of any shape at rest in a fluid
    at rest is exact. The particles receive the full pressure gradient,
    rho (grad p + g), which includes buoyancy.

    Sets I and III of the same paper are available for comparison (entry equations,
    demCouplingScheme): grad p acts on the fluid in full, and the reaction is to the
    whole force (I) or to drag over e (III).

    The momentum equation is interpolated to the faces as a whole, with drag
    (pEqn.H). There the pressure gradient balances the particles' force on
    one stencil, so a sharp bed surface causes no checkerboard pressure, and a
    thin first cell above a distributor carries the full flux.

    The mesh may move (dynamicFvMesh) without changes of topology: cell volumes
    before and after the step enter the time derivatives and ds/dt, fluxes are
    relative to the faces, and wall patches move the walls of the particles.

    Turbulence models are OpenFOAM's, weighted by the void fraction
    (volumeAveragedTurbulenceModel.H). If the scene transfers heat between fluid and
    particles, the fluid has a temperature (fluidTemperature.H).

    Not included: species, more than one fluid, mesh refinement.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "dynamicFvMesh.H"
#include "singlePhaseTransportModel.H"
#include "volumeAveragedTurbulenceModel.H"
#include "pimpleControl.H"
#include "fvOptions.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "demDrivingForce.H"
#include "demFiles.H"
#include "demFluid.H"
#include "demMeshCheck.H"
#include "demRun.H"
#include "demTimeStepControl.H"
#include "checkCorrectors.H"
#include "checkRelaxation.H"
#include "checkTimeScheme.H"
#include "fixedFlux.H"
#include "fluidBudget.H"
#include "fluidTemperature.H"
#include "cellVector.H"
#include "halfCellMean.H"
#include "faceVector.H"
#include "potentialFlux.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Transient incompressible flow coupled with particles (CFD-DEM)"
    );

    #define NO_CONTROL
    #define CREATE_FIELDS createPostFields.H
    #include "postProcess.H"

    demRun::addOptions();

    #include "setRootCaseLists.H"
    #include "createTime.H"
    demRun run(args, runTime);
    #include "createDynamicFvMesh.H"

    if (run.settle(mesh))
    {
        return 0;
    }

    pimpleControl pimple(mesh);

    checkCorrectors(pimple.dict());
    checkTimeScheme(mesh, "ddt(voidFraction)");
    checkTimeScheme(mesh, "ddt(voidFraction,U)");
    checkRelaxation(mesh, "U");
    #include "createTimeControls.H"
    #include "createFields.H"

    demTimeStepControl stepControl(runTime, cloud);
    run.begin();

    while (runTime.run())
    {
        #include "readTimeControls.H"
        #include "CourantNo.H"
        #include "setParticleDeltaT.H"
        #include "planStep.H"

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        #include "moveMesh.H"

        // One exchange per step: the forces of the particles stay constant during
        // the iterations of the fluid
        cloud.evolve({U, gradP, rho, mu()});
        #include "fluidEquations.H"
        #include "continuity.H"
        cloud.correct
        (
            U,
            gradP,
            rho,
            rhoFluid.value()*gSum((mesh.V().field()*voidFraction.primitiveField()*U.primitiveField())())
        );
        if (temperature)
        {
            temperature->correct();
        }
        if (cloud.budget().table().on())
        {
            const List<fluidBudget::force> known
            (
                1, fluidBudget::force("sources", forceOfSources())
            );
            #include "endBudget.H"
        }
        run.endStep(cloud);
    }
    run.end();

    return 0;
}
