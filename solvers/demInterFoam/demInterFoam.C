/*---------------------------------------------------------------------------*\
    demInterFoam.C -- transient flow of two fluids coupled with particles.

Application
    demInterFoam

Description
    Two incompressible, immiscible fluids (volume of fluid) and discrete particles,
    volume-averaged, set II ("model A") of Zhou, Kuang, Chu and Yu, J. Fluid Mech.
    661 (2010) 482:

        d(e alpha)/dt + div(alpha F) = 0
        d(e (1 - alpha))/dt + div((1 - alpha) F) = 0,    div F = ds/dt
        d(e rho U)/dt + div(rhoPhi U) = - e B + div(e tau) + F_p - K U

        B = grad p_rgh + g.x grad rho - (rho - rho_0) gc - sigma kappa grad alpha

    e       void fraction, 1 - s                                       [1]
    alpha   fraction of phase 1 in the void space                      [1]
    F       volume flux of the fluids (phaseTransport.H, totalFlux.H)
    U       interstitial velocity                                    [m/s]
    p_rgh   pressure without the hydrostatic part rho g.x, with g here without gc [Pa]
    gc, rho_0  gravity along the periods of cyclic patches, least density now [m/s2], [kg/m3]
    rho, tau  density and stress of the mixture (twoFluids.H)
    F_p, K  explicit part of the particles' reaction, and coefficient of the
            implicit part (demExchange.H)                 [N/m3], [kg/m3/s]

    Pressure, gravity and surface tension at the interface have the same factor on each
    face (pEqn.H), so fluids at rest stay at rest with particles of any kind across the
    interface. Particles feel B + rho g: the full pressure gradient without the capillary
    jump, with density and viscosity of the fluids around them.

    Momentum and pressure are solved as in demPimpleFoam, times the density. Two cells
    share the net force of a face in proportion to their density, not by geometry: else
    the light fluid would get half of a force on the heavy one.

    The mesh may move (dynamicFvMesh) without changes of topology, as in demPimpleFoam.

    Surface tension on particles (effect capillaryForce) and its reaction are a part of the
    tension at the interface (demCapillaryForce.H).

    Not included: the sets I and III, heat, implicit MULES.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "dynamicFvMesh.H"
#include "volumeAveragedTurbulenceModel.H"
#include "pimpleControl.H"
#include "fvOptions.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "meanVelocityForce.H"
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
#include "cellVector.H"
#include "halfCellMean.H"
#include "faceVector.H"
#include "potentialFlux.H"
#include "phaseTransport.H"
#include "slidingFlux.H"
#include "twoFluids.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

// Refuse what the equations of two fluids do not have
static void checkParticles(const demCloud& cloud)
{
    const demDict& dict = cloud.particles().dict();

    dict.refuseDuplicate("rho", "the phases of constant/transportProperties");
    if (cloud.exchange().scheme().set() != demCouplingScheme::II)
    {
        FatalErrorInFunction
            << "equations is not II in coupling of constant/" << demDict::name()
            << "; demInterFoam has the set II only: take the entry out" << exit(FatalError);
    }
    if (dict.coupling().found("mixtureFlux"))
    {
        FatalErrorInFunction
            << "mixtureFlux is given in coupling of constant/" << demDict::name()
            << "; only demPimpleFoam has it: take the entry out, and give 0/U of the fluids"
            << exit(FatalError);
    }
    if (cloud.transfersHeat())
    {
        FatalErrorInFunction
            << "The effects of constant/" << demDict::name() << " transfer heat, but"
            << " demInterFoam has no temperature: take these effects out, or use"
            << " demPimpleFoam for one fluid" << exit(FatalError);
    }
}


static void checkFluid(const fv::optionList& options, const bool newtonian, const word& model)
{
    for (const fv::option& option : options)
    {
        if (isA<fv::meanVelocityForce>(option))
        {
            FatalErrorInFunction
                << "fvOptions has " << option.name() << " of type " << option.type()
                << ", one force for both fluids, which drives the light one away: use"
                << " demPimpleFoam for one fluid, or tilt constant/g" << exit(FatalError);
        }
    }
    if (!newtonian)
    {
        FatalErrorInFunction
            << "The model " << model << " of constant/turbulenceProperties has a stress of"
            << " its own; demInterFoam needs a model with an eddy viscosity, or laminar"
            << exit(FatalError);
    }
}

} // End namespace Foam

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Transient flow of two immiscible fluids coupled with particles (CFD-DEM)"
    );

    #define NO_CONTROL
    #define CREATE_FIELDS createPostInterFields.H
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
    checkTimeScheme(mesh, "ddt(mass)");
    checkTimeScheme(mesh, "ddt(mass,U)");
    checkRelaxation(mesh, "U");
    #include "createTimeControls.H"
    #include "createInterFields.H"

    demTimeStepControl stepControl(runTime, cloud);
    const label interfaceCo = stepControl.add("maxAlphaCo", "Courant number of the interface");
    const label capillaryCo = stepControl.add
    (
        "maxCapillaryCo",
        cloud.exchange().capillary()
      ? "step over the longest one that resolves capillary waves and particles at the interface"
      : "step over the longest one that resolves capillary waves"
    );
    run.begin();

    while (runTime.run())
    {
        #include "readTimeControls.H"
        #include "CourantNo.H"
        stepControl.set
        (
            interfaceCo,
            phases.courant(),
            runTime.controlDict().getOrDefault<scalar>("maxAlphaCo", 0.5)
        );
        stepControl.set
        (
            capillaryCo,
            runTime.deltaTValue()
           /min
            (
                fluids.capillaryStep(),
                cloud.exchange().capillary() ? cloud.exchange().capillary()->longestStep() : GREAT
            ),
            runTime.controlDict().getOrDefault<scalar>("maxCapillaryCo", 1)
        );
        #include "setParticleDeltaT.H"
        #include "planStep.H"

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        #include "moveMesh.H"
        if (mesh.moving())
        {
            gh = (upright & mesh.C()) - ghRef;
            ghf = (upright & mesh.Cf()) - ghRef;
            fluids.correct();
        }

        // One exchange per step: the forces of the particles stay constant during
        // the iterations of the fluids. gradP differs from the one that the particles
        // felt in its dynamic part only; the new density acts in the next step.
        cloud.evolve({U, gradP, rho, mu()});
        const volVectorField weight("weight", rho*gravity);
        #include "interEquations.H"
        #include "continuity.H"
        gradP = toCells(gradpf) + weight;
        cloud.correct
        (
            U,
            gradP,
            rho,
            gSum((mesh.V().field()*mass.primitiveField()*U.primitiveField())())
        );
        gradP = toCells(gradpf) + rho*gravity;

        if (cloud.budget().table().on())
        {
            auto sumOf = [&](const tmp<surfaceScalarField>& force)
            {
                return vector(-gSum((mesh.V().field()*toCells(force())().primitiveField())()));
            };
            const demCapillaryForce* onParticles = cloud.exchange().capillary();
            List<fluidBudget::force> known(onParticles ? 4 : 3);
            known[0] = fluidBudget::force("interfaceGravity", sumOf(gravityForce()));
            known[1] = fluidBudget::force("interfaceTension", sumOf(fluids.capillarity()));
            known[2] = fluidBudget::force("sources", forceOfSources());
            if (onParticles)
            {
                known[3] = fluidBudget::force("particleTension", sumOf(-onParticles->onFaces()));
            }
            // rho g z over whole cells, without the void fraction: `height` of the particles
            // subtracts the buoyancy. Along periods it has no potential
            cloud.budget().table().state
            (
                demBudget::ENERGY,
                "fluidHeight",
                -gSum
                (
                    (
                        mesh.V().field()*rho.primitiveField()
                       *(upright.value() & mesh.C().primitiveField())
                    )()
                )
            );
            #include "endBudget.H"
        }
        run.endStep(cloud);
    }
    run.end();

    return 0;
}
