/*---------------------------------------------------------------------------*\
    demSlidingInterface.C -- links between the cells on the two sides of sliding
    interfaces.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSlidingInterface.H"
#include "demPassable.H"
#include "cyclicAMIPolyPatch.H"
#include "wedgePolyPatch.H"

namespace Foam
{
    // Overlaps below this fraction of a face are left out: their flow is round-off
    static const scalar minOverlap = 1e-9;

    // Numbers in the description of a link: face, other cell, its rank's cell and
    // centre, area
    static const label linkSize = 9;
}


bool Foam::demSlidingInterface::any(const polyMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (demPassable::slides(patch))
        {
            return true;
        }
    }
    return false;
}


void Foam::demSlidingInterface::check(const polyMesh& mesh)
{
    const bool sliding = any(mesh);

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (sliding && isA<wedgePolyPatch>(patch))
        {
            FatalErrorInFunction
                << "The mesh is a wedge with sliding interfaces, which particles do not"
                << " pass in a wedge; mesh the whole circle" << exit(FatalError);
        }
        if (!demPassable::slides(patch))
        {
            continue;
        }
        if (patch.type() != cyclicAMIPolyPatch::typeName)
        {
            FatalErrorInFunction
                << "patch " << patch.name() << " is of type " << patch.type()
                << ", but of the sliding interfaces particles pass cyclicAMI only, without"
                << " blockage or periods; extend both zones so that their interfaces cover"
                << " each other, and use cyclicAMI" << exit(FatalError);
        }

        const coupledPolyPatch& coupled = refCast<const coupledPolyPatch>(patch);
        if
        (
            coupled.transform() == coupledPolyPatch::ROTATIONAL
         || coupled.transform() == coupledPolyPatch::TRANSLATIONAL
        )
        {
            FatalErrorInFunction
                << "patch " << patch.name() << " is of type " << patch.type() << " with transform "
                << coupledPolyPatch::transformTypeNames[coupled.transform()]
                << ", but particles pass an interface only where its two sides lie on each"
                << " other; take transform out, or use the whole domain" << exit(FatalError);
        }
    }
}


void Foam::demSlidingInterface::addOwned
(
    const polyPatch& patch,
    demRankBuffers& messages,
    labelListList& sent
)
{
    const cyclicAMIPolyPatch& own = refCast<const cyclicAMIPolyPatch>(patch);
    const cyclicAMIPolyPatch& other = own.neighbPatch();
    const AMIPatchToPatchInterpolation& ami = own.AMI();

    // Per face of the other side, as this rank's addresses see them
    labelList rank(other.size(), Pstream::myProcNo());
    labelList face(identity(other.size(), other.start()));
    labelList cell(other.faceCells());
    pointField centre(other.size());
    forAll(centre, g)
    {
        centre[g] = mesh_.cellCentres()[cell[g]];
    }
    if (ami.singlePatchProc() == -1)
    {
        ami.tgtMap().distribute(rank);
        ami.tgtMap().distribute(face);
        ami.tgtMap().distribute(cell);
        ami.tgtMap().distribute(centre);
    }

    List<DynamicList<label>> mine(Pstream::nProcs());
    forAll(own, f)
    {
        const labelList& address = ami.srcAddress()[f];
        const scalarList& weight = ami.srcWeights()[f];
        forAll(address, k)
        {
            if (weight[k] <= minOverlap)
            {
                continue;
            }
            const label g = address[k];
            const link l
            {
                own.start() + f, own.faceCells()[f], rank[g], cell[g],
                weight[k]*own.faceAreas()[f], centre[g]
            };
            DynamicList<scalar>& message = messages[l.rank];
            const point& here = mesh_.cellCentres()[l.cell];

            mine[l.rank].append(links_.size());
            links_.append(l);
            message.append(face[g]);
            message.append(l.otherCell);
            message.append(l.cell);
            demAppend(message, here);
            demAppend(message, l.area);
        }
    }
    forAll(mine, r)
    {
        sent[r].append(mine[r]);
    }
}


void Foam::demSlidingInterface::addReceived(const UList<scalar>& message, labelList& received)
{
    const label n = message.size()/linkSize;

    received.setSize(n);
    for (label k = 0; k < n; ++k)
    {
        const scalar* s = &message[k*linkSize];

        received[k] = links_.size();
        links_.append
        (
            link
            {
                label(s[0]), label(s[1]), 0, label(s[2]),
                -vector(s[6], s[7], s[8]), point(s[3], s[4], s[5])
            }
        );
    }
}


Foam::demSlidingInterface::demSlidingInterface(const fvMesh& mesh)
:
    mesh_(mesh),
    linksOf_(mesh.nBoundaryFaces())
{
    const label nRanks = Pstream::nProcs();
    demRankBuffers out(nRanks), in(nRanks);
    labelListList owned(nRanks), received(nRanks);

    // All ranks have these patches, in the same order
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (demPassable::slides(patch) && refCast<const cyclicAMIPolyPatch>(patch).owner())
        {
            addOwned(patch, out, owned);
        }
    }
    demExchangeBuffers(out, in);
    forAll(in, rank)
    {
        const label first = links_.size();
        addReceived(in[rank], received[rank]);
        for (label l = first; l < links_.size(); ++l)
        {
            links_[l].rank = rank;
        }
    }

    List<DynamicList<label>> perFace(linksOf_.size());
    forAll(links_, l)
    {
        perFace[links_[l].face - mesh.nInternalFaces()].append(l);
    }
    forAll(perFace, i)
    {
        linksOf_[i].transfer(perFace[i]);
    }

    // The owner's links go first on the way out, the others' on the way in
    labelListList from(nRanks), to(nRanks);
    forAll(from, rank)
    {
        from[rank] = owned[rank];
        from[rank].append(received[rank]);
        to[rank] = received[rank];
        to[rank].append(owned[rank]);
    }
    map_.reset(new mapDistributeBase(links_.size(), std::move(from), std::move(to)));
}


const Foam::demSlidingInterface::link& Foam::demSlidingInterface::nearest
(
    const label facei,
    const point& x
) const
{
    const labelUList& candidates = linksOf(facei);
    label found = candidates[0];

    for (const label l : candidates)
    {
        if (magSqr(links_[l].otherCentre - x) < magSqr(links_[found].otherCentre - x))
        {
            found = l;
        }
    }
    return links_[found];
}
