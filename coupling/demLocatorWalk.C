/*---------------------------------------------------------------------------*\
    demLocatorWalk.C -- walk from cell to cell until the point is inside.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demLocator.H"
#include "indexedOctree.H"
#include "treeDataCell.H"

namespace Foam
{
    // A walk longer than this is circling or far off: the tree is faster
    static const label longestWalk = 200;

    // Round-off: a point this far behind a face, in units of the distance
    // between cell centre and face, is on it. Two cells, or two ranks, may
    // both claim such a point; its weights are the same to this precision.
    static const scalar onFace = 1e-9;

    // Up to here the face's triangles decide, not its plane, as it may be warped;
    // and always after so many steps, as planes may lead in circles
    static const scalar nearFace = 1.2;
    static const label planeSteps = 50;

    // Square of a tetrahedron's height over its longest possible one
    static const scalar flat = 1e-20;

    // Up to here a point behind the domain's boundary is on the boundary
    static const scalar onWall = 1.1;
    static const label mostSlides = 3;
}


// * * * * * * * * * * * * * * * tetrahedra  * * * * * * * * * * * * * * * * //

void Foam::demLocator::tryFace
(
    const label facei,
    const point& centre,
    const vector& d,
    scalar& best,
    demSpot& spot
) const
{
    const pointField& points = mesh_.points();
    const face& f = mesh_.faces()[facei];
    const vector e(middle_[facei] - centre);
    const vector dxe(d ^ e);

    label pi = f.last();
    vector p(points[pi] - centre);

    for (const label qi : f)
    {
        // d = wFace*e + wp*p + wq*q
        const vector q(points[qi] - centre);
        const vector pxq(p ^ q);
        const scalar volume = e & pxq;

        // flat tetrahedra have no inside
        if (sqr(volume) > flat*magSqr(e)*magSqr(pxq))
        {
            const scalar wFace = (d & pxq)/volume;
            const scalar wp = -(dxe & q)/volume;
            const scalar wq = (dxe & p)/volume;
            const scalar least = min(wFace, min(wp, wq));

            if (least > best)
            {
                best = least;
                spot.face = facei;
                spot.p = pi;
                spot.q = qi;
                spot.wFace = wFace;
                spot.wp = wp;
                spot.wq = wq;
                if (best >= 0)
                {
                    return;
                }
            }
        }
        pi = qi;
        p = q;
    }
}


void Foam::demLocator::aim
(
    const label cell,
    const vector& d,
    const label first,
    demSpot& spot
) const
{
    const point& centre = mesh_.cellCentres()[cell];
    scalar best = -GREAT;

    spot = demSpot{cell, face_[first], 0, 0, 1, 0, 0, 0};

    tryFace(face_[first], centre, d, best, spot);
    for (label slot = start_[cell]; best < 0 && slot < start_[cell + 1]; ++slot)
    {
        if (slot != first)
        {
            tryFace(face_[slot], centre, d, best, spot);
        }
    }
    spot.wCell = 1 - spot.wFace - spot.wp - spot.wq;
}


void Foam::demLocator::clean(demSpot& spot)
{
    spot.wCell = max(spot.wCell, scalar(0));
    spot.wFace = max(spot.wFace, scalar(0));
    spot.wp = max(spot.wp, scalar(0));
    spot.wq = max(spot.wq, scalar(0));

    const scalar sum = spot.wCell + spot.wFace + spot.wp + spot.wq;

    spot.wCell /= sum;
    spot.wFace /= sum;
    spot.wp /= sum;
    spot.wq /= sum;
}


// * * * * * * * * * * * * * * * the walk  * * * * * * * * * * * * * * * * * //

Foam::label Foam::demLocator::behind
(
    const label cell,
    const vector& d,
    scalar& most
) const
{
    label worst = start_[cell];
    most = d & plane_[worst];

    for (label slot = worst + 1; slot < start_[cell + 1]; ++slot)
    {
        const scalar here = d & plane_[slot];
        if (here > most)
        {
            most = here;
            worst = slot;
        }
    }
    return worst;
}


bool Foam::demLocator::isWall(const label facei) const
{
    return
        facei >= mesh_.nInternalFaces()
     && otherRank_[facei - mesh_.nInternalFaces()] < 0;
}


bool Foam::demLocator::isBorder(const label facei) const
{
    return
        facei >= mesh_.nInternalFaces()
     && otherRank_[facei - mesh_.nInternalFaces()] != Pstream::myProcNo();
}


void Foam::demLocator::cross(const label facei, traveller& t) const
{
    if (facei < mesh_.nInternalFaces())
    {
        const label owner = mesh_.faceOwner()[facei];
        t.cell = owner == t.cell ? mesh_.faceNeighbour()[facei] : owner;
    }
    else
    {
        const label i = facei - mesh_.nInternalFaces();
        t.position += shift_[i];
        t.cell = otherCell_[i];
        t.rank = otherRank_[i];
    }
}


Foam::point Foam::demLocator::position(const demSpot& spot) const
{
    return
        spot.wCell*mesh_.cellCentres()[spot.cell]
      + spot.wFace*middle_[spot.face]
      + spot.wp*mesh_.points()[spot.p]
      + spot.wq*mesh_.points()[spot.q];
}


Foam::label Foam::demLocator::wayAround(const label cell, const vector& d) const
{
    label way = -1;
    scalar most = 1 + onFace;

    for (label slot = start_[cell]; slot < start_[cell + 1]; ++slot)
    {
        const scalar here = d & plane_[slot];
        if (here > most && !isWall(face_[slot]))
        {
            most = here;
            way = face_[slot];
        }
    }
    return way;
}


Foam::demLocator::ending Foam::demLocator::walk(traveller& t, demSpot& spot) const
{
    if (t.cell < 0 || t.cell >= mesh_.nCells())
    {
        return OUTSIDE;
    }

    label slides = 0;
    for (label step = 0; step < longestWalk; ++step)
    {
        const vector d(t.position - mesh_.cellCentres()[t.cell]);
        scalar most;
        const label worst = behind(t.cell, d, most);
        const bool close = most <= nearFace || step >= planeSteps;
        label through = face_[worst];

        if (close)
        {
            aim(t.cell, d, worst, spot);
            through = spot.face;

            // wCell is 1 at the centre, 0 on the face
            if (-spot.wCell <= onFace)
            {
                clean(spot);
                return INSIDE;
            }
        }
        if (isWall(through))
        {
            const bool onIt = close && -spot.wCell <= onWall - 1;

            // around a corner of the domain, or along the wall to where it is
            // nearest. Not for long and not to other ranks if it may stay here:
            // cells with warped sides may send the point to each other.
            through = wayAround(t.cell, d);
            if (onIt && (through < 0 || isBorder(through) || ++slides > mostSlides))
            {
                clean(spot);
                return INSIDE;
            }
            if (through < 0)
            {
                return OUTSIDE;
            }
        }
        cross(through, t);
        if (t.rank != Pstream::myProcNo())
        {
            return LEFT;
        }
    }
    return OUTSIDE;
}


void Foam::demLocator::settle(const traveller& t, demSpot& spot) const
{
    const vector d(t.position - mesh_.cellCentres()[t.cell]);
    scalar most;

    aim(t.cell, d, behind(t.cell, d, most), spot);
    clean(spot);
}


Foam::label Foam::demLocator::search(const point& position, scalar& distance) const
{
    distance = GREAT;
    if (mesh_.nCells() == 0)
    {
        return -1;
    }

    const label celli = mesh_.cellTree().findInside(position);
    if (celli >= 0)
    {
        distance = 0;
        return celli;
    }

    const label nearest = mesh_.cellTree().findNearest(position, sqr(GREAT)).index();
    distance = mag(mesh_.cellCentres()[nearest] - position);
    return nearest;
}


// ************************************************************************* //
