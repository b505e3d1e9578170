/*---------------------------------------------------------------------------*\
    demLocatorWalk.C -- walking search from cell to cell.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demLocator.H"
#include "demCellTree.H"

namespace Foam
{
    // Cells in a walk, at most: a longer one is circling or far away, and the
    // octree is faster
    static const label maxCells = 200;

    // Round-off: a point this far behind a face, in units of the distance
    // between cell centre and face, is on it. Two cells, or two ranks, may
    // both find such a point; its weights agree to this precision.
    static const scalar onFace = 1e-9;

    // Up to this distance, in the same unit, the triangles of a face decide, not its
    // plane, as it may be warped; always after this number of cells, as planes may lead
    // in circles
    static const scalar nearFace = 1.2;
    static const label maxPlaneSteps = 50;

    // Up to this distance, in the same unit, a point behind the domain's boundary
    // is on the boundary
    static const scalar onWall = 1.1;
    static const label maxSlides = 3;

    // A point that is still behind a face of an interface after several passages lies in
    // a gap between the two sides, up to this distance in the same unit
    static const label maxPassages = 4;
    static const scalar inGap = 2;
}


Foam::label Foam::demLocator::farthestFace
(
    const label cell,
    const vector& d,
    scalar& distance
) const
{
    label farthest = start_[cell];
    distance = d & plane_[farthest];

    for (label slot = farthest + 1; slot < start_[cell + 1]; ++slot)
    {
        const scalar here = d & plane_[slot];
        if (here > distance)
        {
            distance = here;
            farthest = slot;
        }
    }
    return farthest;
}


bool Foam::demLocator::isOutlet(const label facei) const
{
    return
        facei >= mesh_.nInternalFaces()
     && otherRank_[facei - mesh_.nInternalFaces()] == OUTLET;
}


bool Foam::demLocator::isBoundary(const label facei) const
{
    return
        isOutlet(facei)
     || (
            facei >= mesh_.nInternalFaces()
         && otherRank_[facei - mesh_.nInternalFaces()] == BOUNDARY
        );
}


bool Foam::demLocator::isSliding(const label facei) const
{
    return
        facei >= mesh_.nInternalFaces()
     && otherRank_[facei - mesh_.nInternalFaces()] == SLIDES;
}


bool Foam::demLocator::leavesRank(const label facei) const
{
    return
        facei >= mesh_.nInternalFaces()
     && otherRank_[facei - mesh_.nInternalFaces()] != Pstream::myProcNo();
}


void Foam::demLocator::cross(const label facei, walkState& t) const
{
    if (facei < mesh_.nInternalFaces())
    {
        const label owner = mesh_.faceOwner()[facei];
        t.cell = owner == t.cell ? mesh_.faceNeighbour()[facei] : owner;
    }
    else if (isSliding(facei))
    {
        const demSlidingInterface::link& l = interface_->nearest(facei, t.position);
        t.cell = l.otherCell;
        t.rank = l.rank;
        ++t.passages;
    }
    else
    {
        const label i = facei - mesh_.nInternalFaces();
        t.position += shift_[i];
        t.cell = otherCell_[i];
        t.rank = otherRank_[i];
    }
}


void Foam::demLocator::setPeriods(const vector& period)
{
    for (vector& shift : shift_)
    {
        const vector mesh(shift);

        // nothing along the other axes, where face centres differ by rounding
        for (direction k = 0; k < 3 && mag(mesh) > 0; k++)
        {
            const bool along = mag(mesh[k]) > 0.5*mag(mesh);
            shift[k] = !along ? 0 : period[k] > 0 ? sign(mesh[k])*period[k] : mesh[k];
        }
    }
}


Foam::point Foam::demLocator::centre(const label cell) const
{
    return cell >= 0 && cell < mesh_.nCells() ? mesh_.cellCentres()[cell] : point::zero;
}


Foam::point Foam::demLocator::position(const demCellLocation& location) const
{
    return
        location.wCell*mesh_.cellCentres()[location.cell]
      + location.wFace*faceMean_[location.face]
      + location.wp*mesh_.points()[location.p]
      + location.wq*mesh_.points()[location.q];
}


Foam::label Foam::demLocator::farthestOpenFace(const label cell, const vector& d) const
{
    label found = -1;
    scalar distance = 1 + onFace;

    for (label slot = start_[cell]; slot < start_[cell + 1]; ++slot)
    {
        const scalar here = d & plane_[slot];
        if (here > distance && !isBoundary(face_[slot]))
        {
            distance = here;
            found = face_[slot];
        }
    }
    return found;
}


bool Foam::demLocator::behindOutlet(const label cell, const vector& d) const
{
    for (label slot = start_[cell]; slot < start_[cell + 1]; ++slot)
    {
        if (isOutlet(face_[slot]) && (d & plane_[slot]) > 1 + onFace)
        {
            return true;
        }
    }
    return false;
}


Foam::demLocator::result Foam::demLocator::walk(walkState& t, demCellLocation& location) const
{
    if (t.cell < 0 || t.cell >= mesh_.nCells())
    {
        return OUTSIDE;
    }

    label slides = 0;
    for (label step = 0; step < maxCells; ++step)
    {
        const vector d(t.position - mesh_.cellCentres()[t.cell]);
        scalar distance;
        const label farthest = farthestFace(t.cell, d, distance);
        const bool byTriangles = distance <= nearFace || step >= maxPlaneSteps;
        label through = face_[farthest];

        if (byTriangles)
        {
            findTet(t.cell, d, farthest, location);
            through = location.face;

            // wCell is 1 at the centre, 0 on the face
            if (-location.wCell <= onFace)
            {
                normalise(location);
                return INSIDE;
            }
        }
        if (isBoundary(through))
        {
            const bool onBoundary = byTriangles && -location.wCell <= onWall - 1;

            // Around a corner of the domain, or along the wall to the nearest part
            // of it. Only a few times, and not to other ranks, if the point may stay
            // in this cell: cells with warped faces may send it to each other.
            through = farthestOpenFace(t.cell, d);
            if (onBoundary && (through < 0 || leavesRank(through) || ++slides > maxSlides))
            {
                if (isOutlet(location.face) || behindOutlet(t.cell, d))
                {
                    return OUTSIDE;
                }
                normalise(location);
                return INSIDE;
            }
            if (through < 0)
            {
                return OUTSIDE;
            }
        }
        if (isSliding(through) && t.passages >= maxPassages)
        {
            if (!byTriangles)
            {
                findTet(t.cell, d, farthest, location);
            }
            if (-location.wCell > inGap - 1)
            {
                return OUTSIDE;
            }
            normalise(location);
            return INSIDE;
        }
        cross(through, t);
        if (t.rank != Pstream::myProcNo())
        {
            return OTHER_RANK;
        }
    }
    return OUTSIDE;
}


void Foam::demLocator::clampToCell(const walkState& t, demCellLocation& location) const
{
    const vector d(t.position - mesh_.cellCentres()[t.cell]);
    scalar distance;

    findTet(t.cell, d, farthestFace(t.cell, d, distance), location);
    normalise(location);
}


// The walk counts only if it ends inside a cell, not on its faces, and without a passage
Foam::label Foam::demLocator::search
(
    const point& position,
    const label near,
    scalar& distance
) const
{
    distance = GREAT;
    if (mesh_.nCells() == 0)
    {
        return -1;
    }

    walkState t{position, near, Pstream::myProcNo(), 0};
    demCellLocation location;
    if
    (
        walk(t, location) == INSIDE && location.wCell > onFace
     && t.passages == 0 && t.position == position
    )
    {
        distance = 0;
        return t.cell;
    }

    const label celli = demCellTree::New(mesh_).cell(position);
    if (celli >= 0)
    {
        distance = 0;
        return celli;
    }

    const label nearest = demCellTree::New(mesh_).nearest(position);
    distance = mag(mesh_.cellCentres()[nearest] - position);
    return nearest;
}
