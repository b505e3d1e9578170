/*---------------------------------------------------------------------------*\
    demWeights.C -- weights of the mesh, and their use in both directions.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demWeights.H"
#include "syncTools.H"
#include "symmTensorField.H"

namespace Foam
{

// A wall's normal is held by adding its dyad, this many times stiffer than the
// cloud: what is left of k there changes weights by a thousandth at most
static const scalar stiff = 1e3;

//- k of w = 1 + k.(x_c - x) from the sums of (x_c - x) and its dyad over the
//  cloud; `hold` is the weighted sum of dyads of directions in which k must vanish
static vector slope(const vector& sum, const symmTensor& dyads, const symmTensor& hold)
{
    const scalar size = tr(dyads);
    if (size <= VSMALL)
    {
        return vector::zero;
    }
    // dimensionless; the last term keeps a flat cloud (all in one plane) solvable
    const symmTensor m(dyads/size + hold + 1e-14*symmTensor::I);
    return -(inv(m) & sum)/size;
}


static scalar clipped(const scalar w)
{
    return min(max(w, scalar(0)), scalar(2));
}

} // End namespace Foam


// * * * * * * * * * * * * * * * set-up  * * * * * * * * * * * * * * * * * * //

void Foam::demWeights::weighFaces()
{
    const faceList& faces = mesh_.faces();
    const pointField& points = mesh_.points();

    facePointStart_.setSize(faces.size() + 1);
    facePointStart_[0] = 0;
    forAll(faces, facei)
    {
        facePointStart_[facei + 1] = facePointStart_[facei] + faces[facei].size();
    }
    facePoint_.setSize(facePointStart_.last());
    facePointWeight_.setSize(facePointStart_.last());

    forAll(faces, facei)
    {
        const point& centre = mesh_.faceCentres()[facei];
        const vector n(normalised(mesh_.faceAreas()[facei]));
        vector sum(Zero);
        symmTensor dyads(Zero);

        for (const label pointi : faces[facei])
        {
            const vector d(points[pointi] - centre);
            sum += d;
            dyads += sqr(d);
        }

        const vector k(slope(sum, dyads, sqr(n)));
        scalar total = 0;
        label slot = facePointStart_[facei];

        for (const label pointi : faces[facei])
        {
            facePoint_[slot] = pointi;
            total += facePointWeight_[slot++] = clipped(1 + (k & (points[pointi] - centre)));
        }
        for (slot = facePointStart_[facei]; slot < facePointStart_[facei + 1]; ++slot)
        {
            facePointWeight_[slot] /= total;
        }
    }
}


void Foam::demWeights::weighPoints()
{
    const labelListList& pointCells = mesh_.pointCells();
    const pointField& points = mesh_.points();
    const pointField& C = mesh_.cellCentres();

    pointCellStart_.setSize(points.size() + 1);
    pointCellStart_[0] = 0;

    vectorField sum(points.size(), Zero);
    symmTensorField dyads(points.size(), Zero);
    symmTensorField walls(points.size(), Zero);
    scalarField total(points.size(), Zero);

    forAll(points, pointi)
    {
        pointCellStart_[pointi + 1] = pointCellStart_[pointi] + pointCells[pointi].size();
        for (const label celli : pointCells[pointi])
        {
            const vector d(C[celli] - points[pointi]);
            sum[pointi] += d;
            dyads[pointi] += sqr(d);
        }
    }
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!patch.coupled())
        {
            forAll(patch, i)
            {
                const vector n(normalised(patch.faceAreas()[i]));
                const symmTensor nn(stiff*sqr(n));
                for (const label pointi : patch[i])
                {
                    walls[pointi] += nn;
                }
            }
        }
    }
    addCopies(sum);
    addCopies(dyads);
    addCopies(walls);

    pointCell_.setSize(pointCellStart_.last());
    pointCellWeight_.setSize(pointCellStart_.last());

    label slot = 0;
    forAll(points, pointi)
    {
        const vector k(slope(sum[pointi], dyads[pointi], walls[pointi]));
        for (const label celli : pointCells[pointi])
        {
            pointCell_[slot] = celli;
            total[pointi] +=
                pointCellWeight_[slot++] = clipped(1 + (k & (C[celli] - points[pointi])));
        }
    }
    addCopies(total);

    forAll(points, pointi)
    {
        for (slot = pointCellStart_[pointi]; slot < pointCellStart_[pointi + 1]; ++slot)
        {
            pointCellWeight_[slot] /= total[pointi];
        }
    }
}


Foam::demWeights::demWeights(const fvMesh& mesh)
:
    mesh_(mesh),
    shared_(Pstream::parRun())
{
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        shared_ = shared_ || patch.coupled();
    }
    weighFaces();
    weighPoints();
}


// * * * * * * * * * * * * * * * use  * * * * * * * * * * * * * * * * * * * * //

template<class Type>
void Foam::demWeights::addCopies(Field<Type>& atPoints) const
{
    if (shared_)
    {
        syncTools::syncPointList(mesh_, atPoints, plusEqOp<Type>(), Type(Zero));
    }
}


template<class Type>
void Foam::demWeights::spread
(
    const UList<demSpot>& spots,
    const UList<Type>& values,
    UList<Type>& cells
) const
{
    Field<Type> atFaces(mesh_.nFaces(), Zero);
    Field<Type> atPoints(mesh_.nPoints(), Zero);

    forAll(spots, i)
    {
        const demSpot& s = spots[i];
        const Type& value = values[i];

        cells[s.cell] += s.wCell*value;
        atFaces[s.face] += s.wFace*value;
        atPoints[s.p] += s.wp*value;
        atPoints[s.q] += s.wq*value;
    }

    forAll(atFaces, facei)
    {
        if (atFaces[facei] != Type(Zero))
        {
            for (label k = facePointStart_[facei]; k < facePointStart_[facei + 1]; ++k)
            {
                atPoints[facePoint_[k]] += facePointWeight_[k]*atFaces[facei];
            }
        }
    }

    addCopies(atPoints);

    forAll(atPoints, pointi)
    {
        if (atPoints[pointi] != Type(Zero))
        {
            for (label k = pointCellStart_[pointi]; k < pointCellStart_[pointi + 1]; ++k)
            {
                cells[pointCell_[k]] += pointCellWeight_[k]*atPoints[pointi];
            }
        }
    }
}


template<class Type>
void Foam::demWeights::collect
(
    const UList<demSpot>& spots,
    const UList<Type>& cells,
    UList<Type>& values
) const
{
    Field<Type> atPoints(mesh_.nPoints(), Zero);
    Field<Type> atFaces(mesh_.nFaces(), Zero);

    forAll(atPoints, pointi)
    {
        for (label k = pointCellStart_[pointi]; k < pointCellStart_[pointi + 1]; ++k)
        {
            atPoints[pointi] += pointCellWeight_[k]*cells[pointCell_[k]];
        }
    }

    addCopies(atPoints);

    forAll(atFaces, facei)
    {
        for (label k = facePointStart_[facei]; k < facePointStart_[facei + 1]; ++k)
        {
            atFaces[facei] += facePointWeight_[k]*atPoints[facePoint_[k]];
        }
    }

    forAll(spots, i)
    {
        const demSpot& s = spots[i];
        values[i] =
            s.wCell*cells[s.cell]
          + s.wFace*atFaces[s.face]
          + s.wp*atPoints[s.p]
          + s.wq*atPoints[s.q];
    }
}


#define INSTANTIATE(Type)                                                      \
    template void Foam::demWeights::spread                                     \
    (const UList<demSpot>&, const UList<Type>&, UList<Type>&) const;           \
    template void Foam::demWeights::collect                                    \
    (const UList<demSpot>&, const UList<Type>&, UList<Type>&) const;

INSTANTIATE(Foam::scalar)
INSTANTIATE(Foam::vector)

#undef INSTANTIATE


// ************************************************************************* //
