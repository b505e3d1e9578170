/*---------------------------------------------------------------------------*\
    slidingFlux.C -- fluxes through sliding interfaces that both sides agree on.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "slidingFlux.H"
#include "cyclicAMIFvPatch.H"

namespace Foam
{

// Sum over the faces of the owning side of the parts that pass to each face of the other
// side. Collective.
static tmp<scalarField> passed(const cyclicAMIPolyPatch& owner, const scalarField& flux)
{
    const AMIPatchToPatchInterpolation& ami = owner.AMI();
    const scalarField from(ami.srcWeightsSum()*scalarField(ami.srcMagSf()));
    const scalarField to(ami.tgtWeightsSum()*scalarField(ami.tgtMagSf()));

    return to*owner.neighbPatch().interpolate((flux/max(from, VSMALL))());
}


// Call action(side that owns, index of the patch, index of the other side) for each interface
template<class Action>
static void forInterfaces(const fvMesh& mesh, const Action& action)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const cyclicAMIPolyPatch* side = isA<cyclicAMIPolyPatch>(patch);

        if (side && side->owner())
        {
            action(*side, patch.index(), side->neighbPatchID());
        }
    }
}


// Flux of alpha by upwind interpolation on a side
static tmp<scalarField> upwind(const scalarField& flux, const fvPatchScalarField& alpha)
{
    return
        max(flux, scalar(0))*alpha.patchInternalField()
      + min(flux, scalar(0))*alpha.patchNeighbourField();
}

} // End namespace Foam


void Foam::slidingFlux::conserve(surfaceScalarField& flux)
{
    forInterfaces(flux.mesh(), [&](const cyclicAMIPolyPatch& owner, label own, label other)
    {
        flux.boundaryFieldRef()[other] == -passed(owner, flux.boundaryField()[own]);
    });
}


void Foam::slidingFlux::setUpwind
(
    surfaceScalarField& alphaFlux,
    const surfaceScalarField& flux,
    const volScalarField& alpha
)
{
    forInterfaces(flux.mesh(), [&](const cyclicAMIPolyPatch& owner, label own, label other)
    {
        const scalarField& out = flux.boundaryField()[own];
        const scalarField inside(alpha.boundaryField()[own].patchInternalField());
        const scalarField outside(alpha.boundaryField()[other].patchInternalField());

        alphaFlux.boundaryFieldRef()[own] == upwind(out, alpha.boundaryField()[own]);
        alphaFlux.boundaryFieldRef()[other] ==
           -passed(owner, (max(out, scalar(0))*inside)())
          - passed(owner, (min(out, scalar(0)))())*outside;
    });
}


Foam::tmp<Foam::volScalarField::Internal> Foam::slidingFlux::setOneSided
(
    surfaceScalarField& alphaFlux,
    const surfaceScalarField& flux,
    const volScalarField& alpha
)
{
    const fvMesh& mesh = flux.mesh();
    surfaceScalarField agreed("agreed", alphaFlux);
    setUpwind(agreed, flux, alpha);

    tmp<volScalarField::Internal> tgain
    (
        new volScalarField::Internal
        (
            IOobject("gain", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE),
            mesh,
            dimensionedScalar(dimless/dimTime, Zero)
        )
    );
    scalarField& gain = tgain.ref().field();

    auto add = [&](const label patchi)
    {
        const scalarField own(upwind(flux.boundaryField()[patchi], alpha.boundaryField()[patchi]));
        const labelUList& cells = mesh.boundary()[patchi].faceCells();

        alphaFlux.boundaryFieldRef()[patchi] == own;
        forAll(own, facei)
        {
            gain[cells[facei]] +=
                (own[facei] - agreed.boundaryField()[patchi][facei])/mesh.V()[cells[facei]];
        }
    };
    forInterfaces(mesh, [&](const cyclicAMIPolyPatch&, label own, label other)
    {
        add(own);
        add(other);
    });
    return tgain;
}
