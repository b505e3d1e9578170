/*---------------------------------------------------------------------------*\
    demSmoother.C -- smooths cell values by explicit diffusion; conserves totals and
    makes no new extremes.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSmoother.H"
#include "demConductance.H"
#include "surfaceFields.H"
#include "volFields.H"
#include "syncTools.H"

namespace Foam
{
    // Largest fraction of its value that a lump may give away in one sub-step
    static const scalar maxGiven = 2.0/3.0;

    // Smoothing width over the thickness of the thinnest cells that are not lumped:
    // a quarter of a diameter with the default width of 3 diameters
    static const scalar maxRatio = 12;
}


Foam::tmp<Foam::scalarField> Foam::demSmoother::conductance
(
    const vectorField& S,
    const vectorField& d
)
{
    tmp<scalarField> tk(new scalarField(S.size()));

    forAll(S, i)
    {
        tk.ref()[i] = demConductance(S[i], d[i]);
    }
    return tk;
}


Foam::demSmoother::demSmoother
(
    const fvMesh& mesh,
    const demWedge* wedge,
    const demSlidingInterface* sliding
)
:
    mesh_(mesh),
    wedge_(wedge),
    interface_(sliding),
    boundaryK_(mesh.nBoundaryFaces(), Zero),
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

// Over coupled faces: from the distance of each side's own cell or lump to its face,
// as the two sides may be a period apart
Foam::tmp<Foam::vectorField> Foam::demSmoother::centreLines() const
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


void Foam::demSmoother::setLinks(const scalarField& factor, const scalar limit)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& owner = mesh_.faceOwner();
    const scalarField k
    (
        factor*conductance(mesh_.faceAreas(), centreLines())
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
    linkK_.transfer(inside);

    // Nothing is lumped over coupled faces. The conductance is limited there: a larger
    // one would not change the result, only the number of sub-steps.
    scalarField own(mesh_.nBoundaryFaces());
    forAll(own, i)
    {
        own[i] = volume_[lumpOf(owner[nInternal + i])];
    }
    scalarField other(own);
    syncTools::swapBoundaryFaceList(mesh_, other);
    boundaryK_ = 0;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        for (label i = 0; patch.coupled() && i < patch.size(); ++i)
        {
            const label b = patch.start() - nInternal + i;
            boundaryK_[b] = min(k[nInternal + b], limit*own[b]*other[b]/(own[b] + other[b]));
        }
    }
}


// As over coupled faces nothing is lumped, and the conductance is limited. Both sides
// compute the same numbers.
void Foam::demSmoother::setSliding
(
    const scalar area,
    const scalar c,
    const scalar a,
    const scalar limit
)
{
    slidingK_.clear();
    if (!interface_)
    {
        return;
    }

    const UList<demSlidingInterface::link>& links = interface_->links();
    vectorField S(links.size()), line(links.size());
    scalarField own(links.size());
    forAll(links, l)
    {
        const label lump = lumpOf(links[l].cell);
        S[l] = links[l].area;
        line[l] = centre_[lump];
        own[l] = volume_[lump];
    }
    const vectorField here(line);
    scalarField other(own);
    interface_->swap(line);
    interface_->swap(other);
    line -= here;

    slidingK_ = min
    (
        max(scalar(0), 1 - (c*magSqr(line) + a)/(2*area))*conductance(S, line),
        limit*(own*other)/(own + other)
    );
}


void Foam::demSmoother::setAzimuthalLoss()
{
    azimuthalLoss_.clear();
    if (!wedge_)
    {
        return;
    }

    scalarField r(volume_.size());
    forAll(r, l)
    {
        r[l] = wedge_->radius(centre_[l]);
    }

    azimuthalLoss_.setSize(r.size(), Zero);
    forAll(linkK_, l)
    {
        const scalar flow = linkK_[l]*(r[to_[l]] - r[from_[l]]);
        azimuthalLoss_[from_[l]] += flow;
        azimuthalLoss_[to_[l]] -= flow;
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
            azimuthalLoss_[o] += boundaryK_[i]*(across[i] - r[o]);
        }
    }
    azimuthalLoss_ = max(azimuthalLoss_, scalar(0))/r;
}


void Foam::demSmoother::subtractAzimuthalLoss(const Field<vector>& lumps, Field<vector>& gain) const
{
    forAll(azimuthalLoss_, l)
    {
        gain[l] -= azimuthalLoss_[l]*wedge_->across(lumps[l]);
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

    const scalarField factor
    (
        max(scalar(0), 1 - (c*magSqr(centreLines()) + a)/(2*area))
    );
    const scalar limit = 2*sqr(maxRatio/width);

    lumpCells(limit);
    setLinks(factor, limit);
    setSliding(area, c, a, limit);
    setAzimuthalLoss();

    scalarField sum(volume_.size(), Zero);
    forAll(linkK_, l)
    {
        sum[from_[l]] += linkK_[l];
        sum[to_[l]] += linkK_[l];
    }
    forAll(boundaryK_, i)
    {
        sum[lumpOf(mesh_.faceOwner()[mesh_.nInternalFaces() + i])] += boundaryK_[i];
    }

    forAll(slidingK_, l)
    {
        sum[lumpOf(interface_->links()[l].cell)] += slidingK_[l];
    }

    forAll(azimuthalLoss_, l)
    {
        sum[l] += azimuthalLoss_[l];
    }

    const scalar maxRate = returnReduce(max(scalarField(sum/volume_)), maxOp<scalar>());

    steps_ = label(std::ceil(area*max(maxRate, scalar(0))/maxGiven));
    rate_ = (area/max(steps_, 1))/volume_;
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
        forAll(linkK_, l)
        {
            const label o = from_[l];
            const label n = to_[l];
            const Type flow(linkK_[l]*(lumps[n] - lumps[o]));
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
                gain[o] += boundaryK_[i]*(across[i] - lumps[o]);
            }
        }
        if (interface_)
        {
            const UList<demSlidingInterface::link>& links = interface_->links();
            across.setSize(links.size());
            forAll(links, l)
            {
                across[l] = lumps[lumpOf(links[l].cell)];
            }
            interface_->swap(across);
            forAll(links, l)
            {
                const label o = lumpOf(links[l].cell);
                gain[o] += slidingK_[l]*(across[l] - lumps[o]);
            }
        }
        subtractAzimuthalLoss(lumps, gain);
        forAll(lumps, l)
        {
            lumps[l] += rate_[l]*gain[l];
        }
    }
    scatter(lumps, cells);
}


template void Foam::demSmoother::smooth(UList<Foam::scalar>&) const;
template void Foam::demSmoother::smooth(UList<Foam::vector>&) const;
