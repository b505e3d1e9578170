/*---------------------------------------------------------------------------*\
    demSmoother.C -- explicit diffusion that keeps totals and extremes.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSmoother.H"
#include "surfaceFields.H"
#include "volFields.H"
#include "syncTools.H"

namespace Foam
{
    // Share of its value that a lump may give away in one sub-step
    static const scalar mostGiven = 2.0/3.0;

    // Widths per thickness of the thinnest cells that are smoothed one by one:
    // a quarter of a particle with the default width of 3 diameters
    static const scalar thinnest = 12;
}


Foam::tmp<Foam::scalarField> Foam::demSmoother::conductance
(
    const vectorField& S,
    const vectorField& d
)
{
    // d is never taken to lie flatter on the face than this, as in OpenFOAM
    return max(S & d, 0.05*mag(S)*mag(d))/max(magSqr(d), VSMALL);
}


Foam::demSmoother::demSmoother(const fvMesh& mesh, const demWedge* wedge)
:
    mesh_(mesh),
    wedge_(wedge),
    border_(mesh.nBoundaryFaces(), Zero),
    coupled_(false),
    steps_(0)
{
    for (const fvPatch& patch : mesh_.boundary())
    {
        coupled_ = coupled_ || patch.coupled();
    }
    reduce(coupled_, orOp<bool>());
}


// * * * * * * * * * * * * * * * set-up  * * * * * * * * * * * * * * * * * * //

// Over coupled faces from what each side sees of its own cell or lump, as the
// two sides may be a period apart
Foam::tmp<Foam::vectorField> Foam::demSmoother::lines() const
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& owner = mesh_.faceOwner();
    tmp<vectorField> tlines(new vectorField(mesh_.nFaces(), Zero));
    vectorField& d = tlines.ref();

    for (label facei = 0; facei < nInternal; ++facei)
    {
        d[facei] =
            centre_[lumpOf(mesh_.faceNeighbour()[facei])]
          - centre_[lumpOf(owner[facei])];
    }

    vectorField arm(mesh_.nBoundaryFaces());
    forAll(arm, i)
    {
        const label facei = nInternal + i;
        arm[i] = mesh_.faceCentres()[facei] - centre_[lumpOf(owner[facei])];
    }
    vectorField other(arm);
    syncTools::swapBoundaryFaceList(mesh_, other);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        for (label i = 0; patch.coupled() && i < patch.size(); ++i)
        {
            const label k = patch.start() - nInternal + i;
            d[nInternal + k] = arm[k] - other[k];
        }
    }
    return tlines;
}


void Foam::demSmoother::setLinks(const scalarField& share, const scalar most)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& owner = mesh_.faceOwner();
    const scalarField k
    (
        share*conductance(mesh_.faceAreas(), lines())
    );

    DynamicList<label> from, to;
    DynamicList<scalar> inside;
    for (label facei = 0; facei < nInternal; ++facei)
    {
        const label a = lumpOf(owner[facei]);
        const label b = lumpOf(mesh_.faceNeighbour()[facei]);
        if (a != b && k[facei] > 0)
        {
            from.append(a);
            to.append(b);
            inside.append(k[facei]);
        }
    }
    from_.transfer(from);
    to_.transfer(to);
    inside_.transfer(inside);

    // Over borders nothing is lumped: a tighter link would not change a result
    // any more, only the number of sub-steps
    scalarField mine(mesh_.nBoundaryFaces());
    forAll(mine, i)
    {
        mine[i] = volume_[lumpOf(owner[nInternal + i])];
    }
    scalarField other(mine);
    syncTools::swapBoundaryFaceList(mesh_, other);
    border_ = 0;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        for (label i = 0; patch.coupled() && i < patch.size(); ++i)
        {
            const label b = patch.start() - nInternal + i;
            border_[b] = min(k[nInternal + b], most*mine[b]*other[b]/(mine[b] + other[b]));
        }
    }
}


void Foam::demSmoother::setTurning()
{
    turning_.clear();
    if (!wedge_)
    {
        return;
    }

    scalarField r(volume_.size());
    forAll(r, l)
    {
        r[l] = wedge_->radius(centre_[l]);
    }

    turning_.setSize(r.size(), Zero);
    forAll(inside_, l)
    {
        const scalar flow = inside_[l]*(r[to_[l]] - r[from_[l]]);
        turning_[from_[l]] += flow;
        turning_[to_[l]] -= flow;
    }
    if (coupled_)
    {
        scalarField cells(mesh_.nCells());
        List<scalar> across;
        scatter(r, cells);
        syncTools::swapBoundaryCellList(mesh_, cells, across);
        forAll(across, i)
        {
            const label o = lumpOf(mesh_.faceOwner()[mesh_.nInternalFaces() + i]);
            turning_[o] += border_[i]*(across[i] - r[o]);
        }
    }
    turning_ = max(turning_, scalar(0))/r;
}


void Foam::demSmoother::turn(const Field<vector>& lumps, Field<vector>& gain) const
{
    forAll(turning_, l)
    {
        gain[l] -= turning_[l]*wedge_->across(lumps[l]);
    }
}


void Foam::demSmoother::setWidth(const scalar width, const scalar c, const scalar a)
{
    const scalar area = sqr(width)/4;

    lump_.clear();
    volume_ = mesh_.V().field();
    centre_ = mesh_.cellCentres();
    steps_ = 0;
    if (area <= 0)
    {
        return;
    }

    const scalarField share
    (
        max(scalar(0), 1 - (c*magSqr(lines()) + a)/(2*area))
    );
    const scalar most = 2*sqr(thinnest/width);

    lump(most);
    setLinks(share, most);
    setTurning();

    scalarField sum(volume_.size(), Zero);
    forAll(inside_, l)
    {
        sum[from_[l]] += inside_[l];
        sum[to_[l]] += inside_[l];
    }
    forAll(border_, i)
    {
        sum[lumpOf(mesh_.faceOwner()[mesh_.nInternalFaces() + i])] += border_[i];
    }

    forAll(turning_, l)
    {
        sum[l] += turning_[l];
    }

    const scalar stiffest = returnReduce(max(scalarField(sum/volume_)), maxOp<scalar>());

    steps_ = label(std::ceil(area*max(stiffest, scalar(0))/mostGiven));
    rate_ = (area/max(steps_, 1))/volume_;
}


Foam::label Foam::demSmoother::nLumped() const
{
    label count = 0;
    if (lump_.size())
    {
        labelList cells(volume_.size(), Zero);
        for (const label l : lump_)
        {
            count += ++cells[l] == 2;
        }
    }
    return returnReduce(count, sumOp<label>());
}


// * * * * * * * * * * * * * * * use  * * * * * * * * * * * * * * * * * * * * //

template<class Type>
void Foam::demSmoother::gather(const UList<Type>& cells, Field<Type>& lumps) const
{
    if (!lump_.size())
    {
        lumps = cells;
        return;
    }
    const scalarField& V = mesh_.V();
    lumps.setSize(volume_.size());
    lumps = Zero;
    forAll(lump_, celli)
    {
        lumps[lump_[celli]] += V[celli]*cells[celli];
    }
    lumps /= volume_;
}


template<class Type>
void Foam::demSmoother::scatter(const UList<Type>& lumps, UList<Type>& cells) const
{
    forAll(cells, celli)
    {
        cells[celli] = lumps[lumpOf(celli)];
    }
}


template<class Type>
void Foam::demSmoother::smooth(UList<Type>& cells) const
{
    if (!steps_)
    {
        return;
    }
    const labelUList& owner = mesh_.faceOwner();
    const label nInternal = mesh_.nInternalFaces();

    Field<Type> lumps;
    gather(cells, lumps);
    Field<Type> gain(lumps.size());
    List<Type> across;

    for (label step = 0; step < steps_; ++step)
    {
        gain = Zero;
        forAll(inside_, l)
        {
            const label o = from_[l];
            const label n = to_[l];
            const Type flow(inside_[l]*(lumps[n] - lumps[o]));
            gain[o] += flow;
            gain[n] -= flow;
        }
        if (coupled_)
        {
            scatter(lumps, cells);
            syncTools::swapBoundaryCellList(mesh_, cells, across);
            forAll(across, i)
            {
                const label o = lumpOf(owner[nInternal + i]);
                gain[o] += border_[i]*(across[i] - lumps[o]);
            }
        }
        turn(lumps, gain);
        forAll(lumps, l)
        {
            lumps[l] += rate_[l]*gain[l];
        }
    }
    scatter(lumps, cells);
}


template void Foam::demSmoother::smooth(UList<Foam::scalar>&) const;
template void Foam::demSmoother::smooth(UList<Foam::vector>&) const;


// ************************************************************************* //
