/*---------------------------------------------------------------------------*\
    slidingFlux.C -- fluxes through sliding interfaces that both sides agree on.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "slidingFlux.H"
#include "cyclicAMIFvPatch.H"
#include "mapDistribute.H"
#include "PstreamBuffers.H"

namespace Foam
{

// Areas w_ij times other[j], summed for each face i of the owning side. Collective.
static tmp<scalarField> toOwner(const cyclicAMIPolyPatch& owner, const scalarField& other)
{
    const AMIPatchToPatchInterpolation& ami = owner.AMI();
    const bool distributed = ami.singlePatchProc() == -1;
    const scalarField area(ami.tgtWeightsSum()*scalarField(ami.tgtMagSf()));
    tmp<scalarField> tsum(new scalarField(owner.size(), Zero));
    scalarField& sum = tsum.ref();
    scalarField remote(distributed ? ami.srcMap().constructSize() : 0, Zero);
    scalarField& faces = distributed ? remote : sum;

    forAll(other, j)
    {
        const labelList& overlapping = ami.tgtAddress()[j];
        forAll(overlapping, k)
        {
            faces[overlapping[k]] += ami.tgtWeights()[j][k]*area[j]*other[j];
        }
    }
    if (distributed)
    {
        const mapDistribute& map = ami.srcMap();
        PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);

        forAll(map.constructMap(), proc)
        {
            UOPstream to(proc, buffers);
            to << scalarField(faces, map.constructMap()[proc]);
        }
        buffers.finishedSends();
        forAll(map.subMap(), proc)
        {
            UIPstream from(proc, buffers);
            const scalarField part(from);
            forAll(part, k)
            {
                sum[map.subMap()[proc][k]] += part[k];
            }
        }
    }
    return tsum;
}


// Areas w_ij times own[i], summed for each face j of the other side. Collective.
static tmp<scalarField> toOther(const cyclicAMIPolyPatch& owner, const scalarField& own)
{
    const AMIPatchToPatchInterpolation& ami = owner.AMI();
    const scalarField area(ami.tgtWeightsSum()*scalarField(ami.tgtMagSf()));
    tmp<scalarField> tsum(new scalarField(area.size(), Zero));
    scalarField faces(own);

    if (ami.singlePatchProc() == -1)
    {
        ami.srcMap().distribute(faces);
    }
    forAll(area, j)
    {
        const labelList& overlapping = ami.tgtAddress()[j];
        forAll(overlapping, k)
        {
            tsum.ref()[j] += ami.tgtWeights()[j][k]*area[j]*faces[overlapping[k]];
        }
    }
    return tsum;
}


// Sum of w_ij over the other side's faces, for each face of the owning side; at least
// VSMALL. Collective.
static tmp<scalarField> covered(const cyclicAMIPolyPatch& owner)
{
    const label n = owner.neighbPatch().size();

    return max(toOwner(owner, scalarField(n, scalar(1))), VSMALL);
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


// Flux of alpha by upwind interpolation on a side by itself
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
        const scalarField area(covered(owner));
        fvsPatchScalarField& out = flux.boundaryFieldRef()[own];

        // A face without overlap is a wall
        out == out*pos(area - VSMALL);
        flux.boundaryFieldRef()[other] == -toOther(owner, (out/area)());
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
        const scalarField perArea(flux.boundaryField()[own]/covered(owner));
        const scalarField out(max(perArea, scalar(0)));
        const scalarField in(min(perArea, scalar(0)));
        const scalarField inside(alpha.boundaryField()[own].patchInternalField());
        const scalarField outside(alpha.boundaryField()[other].patchInternalField());

        alphaFlux.boundaryFieldRef()[own] ==
            max(flux.boundaryField()[own], scalar(0))*inside + in*toOwner(owner, outside);
        alphaFlux.boundaryFieldRef()[other] ==
          - toOther(owner, (out*inside)()) - toOther(owner, in)*outside;
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
