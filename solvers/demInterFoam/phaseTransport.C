/*---------------------------------------------------------------------------*\
    phaseTransport.C -- bounded and conservative transport of alpha.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "phaseTransport.H"
#include "slidingFlux.H"
#include "demFiles.H"
#include "fvcAverage.H"
#include "fvcDiv.H"
#include "fvcFlux.H"
#include "fvcSurfaceIntegrate.H"
#include "linear.H"
#include "MULES.H"

namespace Foam
{

// What MULES takes as the density: e* at the end and at the beginning of a sub-cycle.
// On a moving mesh MULES multiplies the latter by the ratio of the volumes in the whole step.
class subCycleWeight
{
    const scalarField& now_;
    const scalarField& old_;

public:

    subCycleWeight(const scalarField& now, const scalarField& old)
    :
        now_(now),
        old_(old)
    {}

    const scalarField& field() const { return now_; }

    subCycleWeight oldTime() const { return subCycleWeight(old_, old_); }
};

} // End namespace Foam


Foam::label Foam::phaseTransport::nSubCycles() const
{
    return mesh_.solverDict(alpha_.name()).getOrDefault<label>("nAlphaSubCycles", 1);
}


Foam::tmp<Foam::surfaceScalarField> Foam::phaseTransport::unlimitedFlux() const
{
    surfaceScalarField compression
    (
        interface_.cAlpha()*mag(flux_/mesh_.magSf())*interface_.nHatf()
    );
    forAll(compression.boundaryField(), patchi)
    {
        fvsPatchScalarField& part = compression.boundaryFieldRef()[patchi];
        if (!part.coupled())
        {
            part == 0;
        }
    }
    const surfaceScalarField alphaf(linearInterpolate(alpha_));

    return fvc::flux(flux_, alpha_, "div(phi,alpha)") + alphaf*(1 - alphaf)*compression;
}


// Flux of alpha out of the mesh, through all patches that are not coupled [m3/s]. Collective.
Foam::scalar Foam::phaseTransport::outflow() const
{
    scalar sum = 0;

    forAll(alphaFlux_.boundaryField(), patchi)
    {
        const fvsPatchScalarField& flux = alphaFlux_.boundaryField()[patchi];
        sum += flux.coupled() ? 0 : Foam::sum(flux);
    }
    return returnReduce(sum, sumOp<scalar>());
}


void Foam::phaseTransport::subCycle
(
    const scalarField& weight,
    const scalarField& oldWeight,
    const scalar rDeltaT
)
{
    scalarField before(oldWeight);
    if (mesh_.moving())
    {
        before *= mesh_.V().field()/mesh_.V0().field();
    }
    const subCycleWeight rho(weight, before);
    surfaceScalarField limited(unlimitedFlux());

    // MULES knows the fluxes of either side of a sliding interface only, so the difference
    // from the flux that both agree on is a source for its limits
    const tmp<volScalarField::Internal> gain(slidingFlux::setOneSided(limited, flux_, alpha_));

    alpha_.oldTime().primitiveFieldRef() = alpha_.primitiveField();
    MULES::limit
    (
        rDeltaT, rho, alpha_, flux_, limited, zeroField(), gain(), oneField(), zeroField(), false
    );
    slidingFlux::setUpwind(limited, flux_, alpha_);
    MULES::explicitSolve(rDeltaT, rho, alpha_, limited, zeroField(), zeroField());
    interface_.correct();

    alphaFlux_ += limited/scalar(nSubCycles());
}


Foam::phaseTransport::phaseTransport
(
    volScalarField& alpha,
    interfaceProperties& interface,
    const volScalarField& voidFraction,
    const surfaceScalarField& flux
)
:
    mesh_(alpha.mesh()),
    alpha_(alpha),
    interface_(interface),
    flux_(flux),
    weight_
    (
        demFieldAt
        (
            mesh_,
            "transportedVoidFraction",
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        voidFraction
    ),
    alphaFlux_("alphaFlux", 0*flux),
    oldAlpha_(alpha.primitiveField()),
    oldWeight_(weight_.primitiveField()),
    oldLeft_(0),
    left_(0),
    moved_(false)
{}


void Foam::phaseTransport::beginStep()
{
    alpha_.oldTime();
    oldAlpha_ = alpha_.primitiveField();
    oldWeight_ = weight_.primitiveField();
    if (mesh_.moving())
    {
        oldWeight_ *= mesh_.V0().field()/mesh_.V().field();
    }
    oldLeft_ = left_;
    moved_ = false;
}


void Foam::phaseTransport::solve()
{
    if (moved_)
    {
        alpha_.primitiveFieldRef() = oldAlpha_;
        alpha_.correctBoundaryConditions();
        interface_.correct();
    }
    moved_ = true;

    const scalar deltaT = mesh_.time().deltaTValue();
    const scalarField change(-deltaT*fvc::div(flux_)().primitiveField());
    const label n = nSubCycles();
    scalarField before(oldWeight_);

    alphaFlux_ = 0*flux_;
    for (label k = 1; k <= n; k++)
    {
        const scalarField after(oldWeight_ + (scalar(k)/n)*change);
        subCycle(after, before, n/deltaT);
        before = after;
    }
    weight_.primitiveFieldRef() = before;
    weight_.correctBoundaryConditions();
    left_ = oldLeft_ + deltaT*outflow();

    const scalarField& alpha = alpha_.primitiveField();
    Info<< alpha_.name() << " between " << gMin(alpha) << " and 1 + " << gMax((alpha - 1)())
        << ", volume " << gSum((mesh_.V().field()*weight_.primitiveField()*alpha)())
        << " m3, left " << left_ << " m3" << endl;
}


Foam::tmp<Foam::volScalarField> Foam::phaseTransport::continuityRate
(
    const volScalarField& voidFraction,
    const volScalarField& dsdt,
    const bool last
) const
{
    tmp<volScalarField> trate(new volScalarField("continuityRate", dsdt));
    scalarField& rate = trate.ref().primitiveFieldRef();
    const scalarField& e = voidFraction.primitiveField();
    const scalar deltaT = mesh_.time().deltaTValue();

    if (last)
    {
        rate += (weight_.primitiveField() - e)/deltaT;
    }
    else
    {
        rate = (oldWeight_ - e)/deltaT;
    }
    return trate;
}


Foam::scalar Foam::phaseTransport::courant() const
{
    const scalar deltaT = mesh_.time().deltaTValue()/nSubCycles();

    // Cells that contain both fluids, and their neighbours
    const volScalarField both(pos0(alpha_ - 1e-3)*pos0(1 - 1e-3 - alpha_));
    const scalarField near(fvc::average(linearInterpolate(both))().primitiveField());

    // Half of the magnitudes of all fluxes: what leaves
    const scalarField leaving
    (
        (0.5*(1 + 0.25*interface_.cAlpha()))*fvc::surfaceSum(mag(flux_))().primitiveField()
    );
    return gMax((pos(near)*deltaT*leaving/(weight_.primitiveField()*mesh_.V().field()))());
}
