/*---------------------------------------------------------------------------*\
    demLinearWeights.C -- linear point-to-cell weights of the mesh, deposition and
    interpolation with them.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demLinearWeights.H"
#include "wedgePolyPatch.H"
#include <vector>

namespace Foam
{

// To suppress the component of k normal to a wall, the dyad of the normal times this
// factor is added to the covariance. The remainder changes weights by a thousandth at
// most.
static const scalar wallFactor = 1e3;

// The set of cell centres around a point is flat in a direction if its variance
// there is less than this times its total variance: an aspect ratio of 30 000
static const scalar flat = 1e-9;


//- Solve m.k = b by elimination, largest pivot first. Directions with pivots below
//  `minPivot` are flat: k has no influence there and is set to 0.
static vector solve(const symmTensor& m, const vector& b, const scalar minPivot)
{
    scalar a[3][4] =
    {
        {m.xx(), m.xy(), m.xz(), b.x()},
        {m.xy(), m.yy(), m.yz(), b.y()},
        {m.xz(), m.yz(), m.zz(), b.z()}
    };
    bool done[3] = {false, false, false};
    vector k(Zero);

    for (label round = 0; round < 3; ++round)
    {
        label p = -1;
        for (label i = 0; i < 3; ++i)
        {
            p = !done[i] && (p < 0 || a[i][i] > a[p][p]) ? i : p;
        }
        if (a[p][p] <= minPivot) break;
        done[p] = true;
        for (label i = 0; i < 3; ++i)
        {
            const scalar factor = i == p ? 0 : a[i][p]/a[p][p];
            for (label j = 0; j < 4; ++j)
            {
                a[i][j] -= factor*a[p][j];
            }
        }
    }
    for (direction i = 0; i < 3; ++i)
    {
        k[i] = done[i] ? a[i][3]/a[i][i] : 0;
    }
    return k;
}


} // End namespace Foam


void Foam::demLinearWeights::moments
(
    scalarField& count,
    vectorField& mean,
    symmTensorField& spread
) const
{
    forAll(count, pointi)
    {
        for (const label celli : mesh_.pointCells()[pointi])
        {
            const vector d(mesh_.cellCentres()[celli] - mesh_.points()[pointi]);
            count[pointi] += 1;
            mean[pointi] += d;
            spread[pointi] += sqr(d);
        }
    }
    addCopies(count);
    addCopies(mean);
    addCopies(spread);

    forAll(count, pointi)
    {
        const scalar n = max(count[pointi], scalar(1));     // a point may belong to no cell
        mean[pointi] /= n;
        spread[pointi] = spread[pointi]/n - sqr(mean[pointi]);
    }
}


Foam::tmp<Foam::symmTensorField> Foam::demLinearWeights::walls() const
{
    tmp<symmTensorField> tdyads(new symmTensorField(mesh_.nPoints(), Zero));
    symmTensorField& dyads = tdyads.ref();

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!patch.coupled())
        {
            // particles are in the middle plane of a wedge
            const bool wedge = isA<wedgePolyPatch>(patch);

            forAll(patch, i)
            {
                const vector n
                (
                    wedge
                  ? refCast<const wedgePolyPatch>(patch).centreNormal()
                  : vector(normalised(patch.faceAreas()[i]))
                );
                for (const label pointi : patch[i])
                {
                    dyads[pointi] += sqr(n);
                }
            }
        }
    }
    addCopies(dyads);
    return tdyads;
}


void Foam::demLinearWeights::setPointWeights()
{
    const pointField& points = mesh_.points();
    scalarField total(points.size(), Zero);
    vectorField mean(points.size(), Zero);
    symmTensorField spread(points.size(), Zero);
    moments(total, mean, spread);
    const symmTensorField wallDyads(walls());

    start_.setSize(points.size() + 1);
    start_[0] = 0;
    forAll(points, pointi)
    {
        start_[pointi + 1] = start_[pointi] + mesh_.pointCells()[pointi].size();
    }
    cell_.setSize(start_.last());
    weight_.setSize(start_.last());

    total = 0;
    label slot = 0;
    forAll(points, pointi)
    {
        const scalar size = tr(spread[pointi]);
        const symmTensor extent(spread[pointi] + wallFactor*size*wallDyads[pointi]);
        const vector k(-solve(extent, mean[pointi], flat*size));
        for (const label celli : mesh_.pointCells()[pointi])
        {
            const vector d(mesh_.cellCentres()[celli] - points[pointi]);
            cell_[slot] = celli;
            weight_[slot] = min(max(1 + (k & (d - mean[pointi])), scalar(0)), scalar(2));
            total[pointi] += weight_[slot++];
        }
    }
    addCopies(total);

    forAll(points, pointi)
    {
        for (slot = start_[pointi]; slot < start_[pointi + 1]; ++slot)
        {
            weight_[slot] /= total[pointi];
        }
    }
}


void Foam::demLinearWeights::setLinkWeights()
{
    const UList<demSlidingInterface::link>& links = interface_->links();
    scalarList own(links.size());
    forAll(links, l)
    {
        const demSlidingInterface::link& to = links[l];
        const vector arm(mesh_.faceCentres()[to.face] - mesh_.cellCentres()[to.cell]);
        own[l] = mag(arm & to.area)/mag(to.area);
    }
    scalarList other(own);
    interface_->swap(other);

    // Per point: area, and area times distance on the own side and between the cells
    scalarField area(mesh_.nPoints(), Zero), near(area), both(area);
    forAll(links, l)
    {
        const scalar S = mag(links[l].area);
        for (const label pointi : mesh_.faces()[links[l].face])
        {
            area[pointi] += S;
            near[pointi] += S*own[l];
            both[pointi] += S*(own[l] + other[l]);
        }
    }
    addCopies(area);
    addCopies(near);
    addCopies(both);

    scalarField share(mesh_.nPoints(), Zero);
    forAll(share, pointi)
    {
        if (area[pointi] > 0)
        {
            share[pointi] = near[pointi]/both[pointi];
        }
        for (label slot = start_[pointi]; slot < start_[pointi + 1]; ++slot)
        {
            weight_[slot] *= 1 - share[pointi];
        }
    }

    linkWeight_.setSize(links.size());
    forAll(links, l)
    {
        const face& f = mesh_.faces()[links[l].face];
        linkWeight_[l].setSize(f.size());
        forAll(f, k)
        {
            linkWeight_[l][k] = share[f[k]]*mag(links[l].area)/area[f[k]];
        }
    }
}


Foam::demLinearWeights::demLinearWeights
(
    const fvMesh& mesh,
    const demSlidingInterface* sliding
)
:
    mesh_(mesh),
    interface_(sliding),
    shared_(Pstream::parRun()),
    knowsAround_(false),
    firstCell_(0)
{
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        shared_ = shared_ || patch.coupled();
    }
    setPointWeights();
    if (interface_)
    {
        setLinkWeights();
    }
}


template<class Type>
void Foam::demLinearWeights::spread
(
    const UList<demCellLocation>& locations,
    const UList<Type>& values,
    UList<Type>& cells
) const
{
    const faceList& faces = mesh_.faces();
    Field<Type> atFaces(mesh_.nFaces(), Zero);
    Field<Type> atPoints(mesh_.nPoints(), Zero);

    forAll(locations, i)
    {
        const demCellLocation& s = locations[i];
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
            const face& f = faces[facei];
            const Type part(atFaces[facei]/f.size());
            for (const label pointi : f)
            {
                atPoints[pointi] += part;
            }
        }
    }

    addCopies(atPoints);

    forAll(atPoints, pointi)
    {
        if (atPoints[pointi] != Type(Zero))
        {
            for (label k = start_[pointi]; k < start_[pointi + 1]; ++k)
            {
                cells[cell_[k]] += weight_[k]*atPoints[pointi];
            }
        }
    }

    if (interface_)
    {
        const UList<demSlidingInterface::link>& links = interface_->links();
        List<Type> across(links.size(), Type(Zero));
        forAll(links, l)
        {
            const face& f = faces[links[l].face];
            forAll(f, k)
            {
                across[l] += linkWeight_[l][k]*atPoints[f[k]];
            }
        }
        interface_->swap(across);
        forAll(links, l)
        {
            cells[links[l].cell] += across[l];
        }
    }
}


template<class Type>
void Foam::demLinearWeights::collect
(
    const UList<demCellLocation>& locations,
    const UList<Type>& cells,
    UList<Type>& values
) const
{
    const faceList& faces = mesh_.faces();
    Field<Type> atPoints(mesh_.nPoints(), Zero);
    Field<Type> atFaces(mesh_.nFaces());            // of faces that have been used
    std::vector<char> used(size_t(mesh_.nFaces()), 0);

    forAll(atPoints, pointi)
    {
        for (label k = start_[pointi]; k < start_[pointi + 1]; ++k)
        {
            atPoints[pointi] += weight_[k]*cells[cell_[k]];
        }
    }

    if (interface_)
    {
        const UList<demSlidingInterface::link>& links = interface_->links();
        List<Type> across(links.size());
        forAll(links, l)
        {
            across[l] = cells[links[l].cell];
        }
        interface_->swap(across);
        forAll(links, l)
        {
            const face& f = faces[links[l].face];
            forAll(f, k)
            {
                atPoints[f[k]] += linkWeight_[l][k]*across[l];
            }
        }
    }

    addCopies(atPoints);

    forAll(locations, i)
    {
        const demCellLocation& s = locations[i];
        if (!used[s.face])
        {
            const face& f = faces[s.face];
            Type sum(Zero);
            for (const label pointi : f)
            {
                sum += atPoints[pointi];
            }
            atFaces[s.face] = sum/f.size();
            used[s.face] = 1;
        }
        values[i] =
            s.wCell*cells[s.cell]
          + s.wFace*atFaces[s.face]
          + s.wp*atPoints[s.p]
          + s.wq*atPoints[s.q];
    }
}


#define INSTANTIATE(Type)                                                      \
    template void Foam::demLinearWeights::spread                                     \
    (const UList<demCellLocation>&, const UList<Type>&, UList<Type>&) const;           \
    template void Foam::demLinearWeights::collect                                    \
    (const UList<demCellLocation>&, const UList<Type>&, UList<Type>&) const;

INSTANTIATE(Foam::scalar)
INSTANTIATE(Foam::vector)

#undef INSTANTIATE
