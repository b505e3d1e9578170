/*---------------------------------------------------------------------------*\
    fluidBudget.C -- terms of the fluid's budget, from the matrix and the patches.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidBudget.H"
#include "fixedFlux.H"
#include "fvc.H"
#include "fvm.H"
#include "emptyFvPatch.H"
#include "jumpCyclicFvPatchFields.H"

void Foam::fluidBudget::keepFluxes()
{
    continuityDefect_ = fvc::ddt(mass_)().primitiveField();
    continuityDefect_ += fvc::div(massFlux_)().primitiveField();

    forAll(fluxes_, patchi)
    {
        fluxes_[patchi] = massFlux_.boundaryField()[patchi];
    }
}


Foam::fluidBudget::fluidBudget
(
    demBudget& budget,
    const volVectorField& U,
    const volScalarField& voidFraction,
    const surfaceScalarField& alphaPhi,
    const volScalarField& mass,
    const surfaceScalarField& massFlux,
    const scalar rho
)
:
    budget_(budget),
    U_(U),
    voidFraction_(voidFraction),
    alphaPhi_(alphaPhi),
    mass_(mass),
    massFlux_(massFlux),
    rho_(rho),
    explicitStress_(mesh().boundary().size(), Zero),
    fluxes_(mesh().boundary().size()),
    flow_(mesh().boundary().size(), Zero),
    stress_(mesh().boundary().size(), Zero),
    continuity_(Zero),
    iterations_(Zero)
{}


bool Foam::fluidBudget::isCounted(const fvPatch& patch)
{
    return !patch.coupled() && !isA<emptyFvPatch>(patch);
}


void Foam::fluidBudget::beforePredictor(const volScalarField& nuEff)
{
    if (!budget_.on())
    {
        return;
    }
    keepFluxes();

    const volTensorField stress(nuEff*dev2(T(fvc::grad(U_))));

    forAll(fluxes_, patchi)
    {
        if (isCounted(mesh().boundary()[patchi]))
        {
            explicitStress_[patchi] = gSum
            (
                (
                    mesh().Sf().boundaryField()[patchi]
                  & stress.boundaryField()[patchi]
                )()
            );
        }
    }
}


void Foam::fluidBudget::beforePredictor
(
    const volSymmTensorField& stress,
    const fvVectorMatrix& divStress
)
{
    if (!budget_.on())
    {
        return;
    }
    keepFluxes();

    forAll(fluxes_, patchi)
    {
        if (isCounted(mesh().boundary()[patchi]))
        {
            // The coefficients contain the rest of the stress
            explicitStress_[patchi] = gSum
            (
                (
                    (
                        mesh().Sf().boundaryField()[patchi]
                      & stress.boundaryField()[patchi]
                    )
                  + cmptMultiply
                    (
                        divStress.internalCoeffs()[patchi],
                        U_.boundaryField()[patchi].patchInternalField()
                    )
                  - divStress.boundaryCoeffs()[patchi]
                )()
            );
        }
    }
}


// The coefficients of a patch in UEqn contain convection and stress together;
// convection is massFlux U of the patch, stress the difference
void Foam::fluidBudget::afterCorrector
(
    fvVectorMatrix& UEqn,
    const volScalarField& A,
    const volVectorField& H,
    const fixedFlux& fixed
)
{
    if (!budget_.on())
    {
        return;
    }

    const scalarField& V = mesh().V();

    forAll(fluxes_, patchi)
    {
        if (!isCounted(mesh().boundary()[patchi]))
        {
            continue;
        }

        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        const vectorField convectionAndStress
        (
            cmptMultiply(UEqn.internalCoeffs()[patchi], Up.patchInternalField())
          - UEqn.boundaryCoeffs()[patchi]
        );
        vectorField convection(fluxes_[patchi]*Up);

        if (fixed.at(patchi))
        {
            convection = fluxes_[patchi]*fixed.inner(patchi, Up);
        }

        flow_[patchi] = -gSum(convection);
        stress_[patchi] =
            explicitStress_[patchi] - gSum(convectionAndStress) - flow_[patchi];
    }

    continuity_ = gSum((V*continuityDefect_*U_.primitiveField())());

    // Residual of the momentum equation for the corrected velocity
    const volVectorField residual((UEqn & U_) - A*U_ + H);
    iterations_ = gSum((V*residual.primitiveField())());
}


// On the fluid in this step; returns the impulse [N s]
Foam::vector Foam::fluidBudget::addPressure(const volScalarField& p, const label patchi)
{
    const scalar rhoDeltaT = rho_*mesh().time().deltaTValue();
    const fvPatch& patch = mesh().boundary()[patchi];
    const scalarField& pp = p.boundaryField()[patchi];
    const scalarField& flux = alphaPhi_.boundaryField()[patchi];
    const vector impulse(-rhoDeltaT*gSum((patch.Sf()*pp)()));

    budget_.gain("pressure:" + patch.name(), impulse);
    budget_.gain
    (
        demBudget::ENERGY,
        "pressure:" + patch.name(),
        -rhoDeltaT*gSum((pp*flux)())
    );
    return impulse;
}


void Foam::fluidBudget::endStep
(
    const volScalarField& p,
    const vectorField& ofFaces,
    const UList<force>& known,
    const vector& toFluid,
    const volScalarField& dsdt
)
{
    const scalar deltaT = mesh().time().deltaTValue(), rhoDeltaT = rho_*deltaT;
    const scalarField& V = mesh().V();
    const vectorField& u = U_;
    const scalarField& e = voidFraction_;

    vector faces(rhoDeltaT*gSum((V*ofFaces)()) - toFluid);
    for (const force& one : known)
    {
        faces -= rhoDeltaT*one.second();
    }

    budget_.state(demBudget::VOLUME, "fluid", gSum((V*e)()));
    budget_.state
    (
        demBudget::ENERGY,
        "fluid",
        0.5*rho_*gSum((V*mass_.primitiveField()*magSqr(u))())
    );

    forAll(mesh().boundary(), patchi)
    {
        const fvPatch& patch = mesh().boundary()[patchi];

        if (isA<jumpCyclicFvPatchScalarField>(p.boundaryField()[patchi]))
        {
            faces -= addPressure(p, patchi);
        }
        if (!isCounted(patch))
        {
            continue;
        }

        const scalarField& flux = alphaPhi_.boundaryField()[patchi];
        const vectorField& Up = U_.boundaryField()[patchi];

        faces -= addPressure(p, patchi);
        budget_.gain("flow:" + patch.name(), rhoDeltaT*flow_[patchi]);
        budget_.gain("stress:" + patch.name(), rhoDeltaT*stress_[patchi]);
        budget_.gain
        (
            demBudget::VOLUME,
            "flow:" + patch.name(),
            -deltaT*gSum(flux)
        );
        budget_.gain
        (
            demBudget::ENERGY,
            "flow:" + patch.name(),
            -rhoDeltaT*gSum((0.5*massFlux_.boundaryField()[patchi]*magSqr(Up))())
        );
    }

    budget_.gain("continuity", rhoDeltaT*continuity_);
    budget_.gain("iterations", rhoDeltaT*iterations_);
    budget_.gain("faces", faces);
    for (const force& one : known)
    {
        budget_.gain(one.first(), rhoDeltaT*one.second());
    }
    budget_.gain
    (
        demBudget::VOLUME,
        "continuity",
        deltaT
       *gSum
        (
            (
                V
               *(
                    fvc::div(alphaPhi_)().primitiveField()
                  - dsdt.primitiveField()
                )
            )()
        )
    );
    budget_.endStep();
}
