/*---------------------------------------------------------------------------*\
    demVoidFraction.C -- void fraction from the volumes of the particles, and its rate.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demVoidFraction.H"
#include "demSelfCheck.H"
#include "demSnapshot.H"

namespace Foam
{

// Void fractions that the user gives at patches
static void checkPatches(const volScalarField& voidFraction)
{
    if (voidFraction.dimensions() != dimless)
    {
        FatalErrorInFunction
            << voidFraction.objectPath() << " has dimensions " << voidFraction.dimensions()
            << "; give [0 0 0 0 0 0 0]" << exit(FatalError);
    }
    forAll(voidFraction.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = voidFraction.boundaryField()[patchi];
        const scalarMinMax found
        (
            patch.type() == "fixedValue" ? gMinMax(patch) : scalarMinMax(1, 1)
        );

        if (!(found.min() > 0 && found.max() <= 1))
        {
            FatalErrorInFunction
                << "voidFraction of patch " << patch.patch().name() << " in "
                << voidFraction.objectPath() << " is "
                << (found.min() > 0 ? found.max() : found.min())
                << "; give the volume of the fluid over the whole, above 0 and at most 1"
                << exit(FatalError);
        }
    }
}

} // End namespace Foam


Foam::demVoidFraction::demVoidFraction(demParticles& particles)
:
    mesh_(particles.mesh()),
    particles_(particles),
    view_(particles.view()),
    fluid_(particles.fluid()),
    transfer_(particles.transfer()),
    inletsOutlets_(particles.inletsOutlets()),
    voidFraction_
    (
        demFieldAt(mesh_, "voidFraction", IOobject::READ_IF_PRESENT),
        mesh_,
        dimensionedScalar("clear", dimless, 1),
        demPassedWalls::types(mesh_)
    ),
    dsdt_
    (
        demFieldAt(mesh_, "dem:dsdt"),
        mesh_,
        dimensionedScalar(dimless/dimTime, Zero)
    ),
    solidSuperficialVelocity_
    (
        demFieldAt(mesh_, "dem:solidSuperficialVelocity"),
        mesh_,
        dimensionedVector(dimVelocity, Zero),
        wordList(mesh_.boundary().size(), "zeroGradient")
    ),
    clear_
    (
        demFieldAt(mesh_, "dem:clear"),
        mesh_,
        dimensionedScalar("clear", dimless, 1)
    ),
    deposited_(0),
    volumeError_(0),
    changeRate_(demSnapshot::readNumber(mesh_.time(), "changeRate"))
{
    checkPatches(voidFraction_);
    if (particles_.displaceFluid())
    {
        passedWalls_.reset(new demPassedWalls(voidFraction_));
    }
}


void Foam::demVoidFraction::begin()
{
    const scalar changeRate = changeRate_;      // of the step before a restart

    deposit();
    dsdt_ = dimensionedScalar(dsdt_.dimensions(), Zero);
    changeRate_ = changeRate;
}


void Foam::demVoidFraction::passInletsOutlets(const volVectorField& U)
{
    if (passedWalls_.valid())
    {
        passedWalls_().check(U);
    }
    if (particles_.displaceFluid() && inletsOutlets_.active())
    {
        passWithVolumes(U);
    }
    else if (particles_.passInletsOutlets(U))
    {
        particles_.locateInserted();
    }
}


void Foam::demVoidFraction::deposit()
{
    scalarField old(voidFraction_.primitiveField());

    volScalarField::Internal solid
    (
        IOobject("solid", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero)
    );
    scalarField behind;
    const scalarField V(reducedVolumes(behind));
    if (throughPatches_.size())
    {
        throughPatches_ = transfer_.fraction()*(throughPatches_ - behind);
    }
    deposited_ = transfer_.fraction()*gSum(V);
    transfer_.depositVolume(V, solid);

    voidFraction_.primitiveFieldRef() = 1 - solid.field();
    voidFraction_.correctBoundaryConditions();

    changeRate_ = 0;
    if (particles_.twoWay())
    {
        changeRate_ =
            gMax(mag(old - voidFraction_.primitiveField())())/mesh_.time().deltaTValue();

        // From the void fractions, so that it agrees with their ddt. In a moving mesh
        // with the cell's volumes before and after, divided by the new one
        if (mesh_.moving())
        {
            old *= mesh_.V0().field()/mesh_.V().field();
        }
        dsdt_.primitiveFieldRef() =
            (old - voidFraction_.primitiveField())/mesh_.time().deltaTValue();
    }
    if (particles_.displaceFluid() && particles_.window() > 0)
    {
        depositFlux(V);
    }
    volumeError_ =
        mag(gSum((mesh_.V().field()*solid.field())()) - deposited_)/(deposited_ + VSMALL);
    demSelfCheck::volume(volumeError_);
}
