/*---------------------------------------------------------------------------*\
    demLocatorTets.C -- the tetrahedron of a cell that holds a point, and the
    weights of its corners.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demLocator.H"

namespace Foam
{
    // Square of a tetrahedron's height over its largest possible one: below this
    // it is degenerate
    static const scalar degenerate = 1e-20;

    // Weights w of e, p and q for which w.x e + w.y p + w.z q = d, and the least of the
    // three: below 0 if d leaves through a side of the tetrahedron; -GREAT if its corners
    // have no interior. pd, qd: (d ^ e) & p, (d ^ e) & q
    static inline scalar cornerWeights
    (
        const vector& d,
        const vector& e,
        const vector& p,
        const vector& q,
        const scalar pd,
        const scalar qd,
        vector& w
    )
    {
        const vector pxq(p ^ q);
        const scalar volume = e & pxq;

        if (sqr(volume) <= degenerate*magSqr(e)*magSqr(pxq))
        {
            return -GREAT;
        }
        w = vector((d & pxq)/volume, -qd/volume, pd/volume);
        return min(w.x(), min(w.y(), w.z()));
    }

}


// First only the triangles whose points p and q lie on either side of the plane through d
// and e: no other contains d
void Foam::demLocator::tryFace
(
    const label facei,
    const point& centre,
    const vector& d,
    scalar& best,
    demCellLocation& location
) const
{
    const pointField& points = mesh_.points();
    const face& f = mesh_.faces()[facei];
    const vector e(faceMean_[facei] - centre);
    const vector dxe(d ^ e);

    for (const bool all : {false, true})
    {
        label pi = f.last();
        vector p(points[pi] - centre);
        scalar pd = dxe & p;

        for (const label qi : f)
        {
            const vector q(points[qi] - centre);
            const scalar qd = dxe & q;
            vector w(Zero);

            if (all || pd*qd <= 0)
            {
                const scalar smallest = cornerWeights(d, e, p, q, pd, qd, w);

                if (smallest > best && (all || smallest >= 0))
                {
                    best = smallest;
                    location.face = facei;
                    location.p = pi;
                    location.q = qi;
                    location.wFace = w.x();
                    location.wp = w.y();
                    location.wq = w.z();
                    if (best >= 0)
                    {
                        return;
                    }
                }
            }
            pi = qi;
            p = q;
            pd = qd;
        }
    }
}


void Foam::demLocator::findTet
(
    const label cell,
    const vector& d,
    const label first,
    demCellLocation& location
) const
{
    const point& centre = mesh_.cellCentres()[cell];
    scalar best = -GREAT;

    location = demCellLocation{cell, face_[first], 0, 0, 1, 0, 0, 0};

    tryFace(face_[first], centre, d, best, location);
    for (label slot = start_[cell]; best < 0 && slot < start_[cell + 1]; ++slot)
    {
        if (slot != first)
        {
            tryFace(face_[slot], centre, d, best, location);
        }
    }
    location.wCell = 1 - location.wFace - location.wp - location.wq;
}


void Foam::demLocator::normalise(demCellLocation& location)
{
    location.wCell = max(location.wCell, scalar(0));
    location.wFace = max(location.wFace, scalar(0));
    location.wp = max(location.wp, scalar(0));
    location.wq = max(location.wq, scalar(0));

    const scalar sum = location.wCell + location.wFace + location.wp + location.wq;

    location.wCell /= sum;
    location.wFace /= sum;
    location.wp /= sum;
    location.wq /= sum;
}
