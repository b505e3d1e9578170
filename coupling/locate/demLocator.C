/*---------------------------------------------------------------------------*\
    demLocator.C -- sets up the cell search: face planes of the cells, other side of
    boundary faces.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demLocator.H"
#include "syncTools.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"


void Foam::demLocator::addPlanes()
{
    const cellList& cells = mesh_.cells();
    const vectorField& Sf = mesh_.faceAreas();
    const pointField& Cf = mesh_.faceCentres();
    const pointField& C = mesh_.cellCentres();

    start_.setSize(cells.size() + 1);
    start_[0] = 0;
    forAll(cells, celli)
    {
        start_[celli + 1] = start_[celli] + cells[celli].size();
    }

    face_.setSize(start_.last());
    plane_.setSize(start_.last());

    faceMean_.setSize(mesh_.nFaces(), point::zero);
    forAll(faceMean_, facei)
    {
        const face& f = mesh_.faces()[facei];
        for (const label pointi : f)
        {
            faceMean_[facei] += mesh_.points()[pointi]/f.size();
        }
    }

    label slot = 0;
    forAll(cells, celli)
    {
        for (const label facei : cells[celli])
        {
            const vector arm(Cf[facei] - C[celli]);
            const vector n(mesh_.faceOwner()[facei] == celli ? Sf[facei] : -Sf[facei]);

            // a cell centre on or behind its own face: keep the plane finite
            const scalar distance = max(arm & n, 0.01*mag(arm)*mag(n) + VSMALL);

            face_[slot] = facei;
            plane_[slot++] = n/distance;
        }
    }
}


void Foam::demLocator::addOtherSide(const labelUList& outlets)
{
    const label nBoundary = mesh_.nBoundaryFaces();
    const label nInternal = mesh_.nInternalFaces();

    otherRank_.setSize(nBoundary, BOUNDARY);
    otherCell_.setSize(nBoundary, -1);
    shift_ = pointField(SubList<point>(mesh_.faceCentres(), nBoundary, nInternal));

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const label start = patch.start() - nInternal;
        const bool processor = isA<processorPolyPatch>(patch);

        if (!patch.coupled())
        {
            continue;
        }
        if (!processor && !isA<cyclicPolyPatch>(patch))
        {
            FatalErrorInFunction
                << "patch " << patch.name() << " is of type " << patch.type()
                << "; particles pass only cyclic and processor patches: make"
                << " the faces match and use cyclic" << exit(FatalError);
        }
        if
        (
            patch.type() != processorPolyPatch::typeName
         && !refCast<const coupledPolyPatch>(patch).parallel()
        )
        {
            FatalErrorInFunction
                << "patch " << patch.name() << " is rotational, but particles"
                << " pass cyclic patches by a translation only; use the whole"
                << " domain, or a box" << exit(FatalError);
        }

        forAll(patch, i)
        {
            otherRank_[start + i] =
                processor
              ? refCast<const processorPolyPatch>(patch).neighbProcNo()
              : Pstream::myProcNo();
            otherCell_[start + i] = patch.faceCells()[i];
        }
    }
    for (const label patchi : outlets)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        SubList<label>(otherRank_, patch.size(), patch.start() - nInternal) = OUTLET;
    }
    if (interface_)
    {
        for (const demSlidingInterface::link& l : interface_->links())
        {
            otherRank_[l.face - nInternal] = SLIDES;
        }
    }

    syncTools::swapBoundaryFaceList(mesh_, otherCell_);

    // Difference of the two sides' face centres: the period at cyclic patches;
    // between ranks only round-off, which must not move a point
    const pointField own(shift_);
    syncTools::swapBoundaryFaceList(mesh_, shift_);
    shift_ -= own;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const label start = patch.start() - nInternal;
        const bool rankBoundary = patch.type() == processorPolyPatch::typeName;

        for (label i = 0; patch.coupled() && i < patch.size(); i++)
        {
            shift_[start + i] = rankBoundary ? point::zero : shift_[start];
        }
    }
}


Foam::demLocator::demLocator
(
    const fvMesh& mesh,
    const labelUList& outlets,
    const demSlidingInterface* sliding
)
:
    mesh_(mesh),
    interface_(sliding)
{
    addPlanes();
    addOtherSide(outlets);

    // collective; needed by the search tree
    (void)mesh_.tetBasePtIs();
}
