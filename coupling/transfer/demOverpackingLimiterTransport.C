/*---------------------------------------------------------------------------*\
    demOverpackingLimiterTransport.C -- move other deposited quantities along with the
    excess solid, and the adjoint for sampling.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demOverpackingLimiter.H"
#include "volFields.H"
#include "syncTools.H"
#include <algorithm>


template<class Type>
void Foam::demOverpackingLimiter::swap(List<Type>& values) const
{
    SubList<Type> faces(values, mesh_.nBoundaryFaces());
    syncTools::swapBoundaryFaceList(mesh_, faces);
    if (interface_)
    {
        SubList<Type> part(values, values.size() - faces.size(), faces.size());
        List<Type> across(part);
        interface_->swap(across);
        part = across;
    }
}


template<class Type>
void Foam::demOverpackingLimiter::cellsAcross(const UList<Type>& cells, List<Type>& across) const
{
    across.setSize(boundaryK_.size());
    forAll(across, i)
    {
        across[i] = cells[cellOf(i)];
    }
    swap(across);
}


void Foam::demOverpackingLimiter::setTransport
(
    const scalarField& u,
    const UList<scalar>& before,
    const UList<scalar>& after
)
{
    const labelUList& owner = mesh_.faceOwner();
    const label nInternal = internalK_.size();
    scalarField through(mesh_.V().field()*before);
    scalarField flow(nInternal);
    DynamicList<label> order;

    forAll(flow, facei)
    {
        const label o = owner[facei];
        const label n = mesh_.faceNeighbour()[facei];
        flow[facei] = internalK_[facei]*(u[o] - u[n]);
        if (flow[facei] != 0)
        {
            order.append(facei);
            through[flow[facei] > 0 ? n : o] += mag(flow[facei]);
        }
    }

    out_.setSize(boundaryK_.size());
    out_ = 0;
    if (coupled_)
    {
        List<scalar> across;
        cellsAcross(u, across);
        forAll(across, i)
        {
            const label o = cellOf(i);
            const scalar outward = boundaryK_[i]*(u[o] - across[i]);
            out_[i] = max(outward, scalar(0));
            through[o] += max(-outward, scalar(0));
        }
    }

    const auto upstream = [&](const label facei)
    {
        return flow[facei] > 0 ? owner[facei] : mesh_.faceNeighbour()[facei];
    };
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            return u[upstream(a)] > u[upstream(b)];
        }
    );

    from_.setSize(order.size());
    to_.setSize(order.size());
    fraction_.setSize(order.size());
    forAll(order, k)
    {
        const label facei = order[k];
        from_[k] = upstream(facei);
        to_[k] = flow[facei] > 0 ? mesh_.faceNeighbour()[facei] : owner[facei];
        fraction_[k] = mag(flow[facei])/through[from_[k]];
    }
    forAll(out_, i)
    {
        if (out_[i] > 0)
        {
            out_[i] /= through[cellOf(i)];
        }
    }

    remaining_.setSize(through.size());
    forAll(remaining_, c)
    {
        remaining_[c] = through[c] > 0 ? mesh_.V()[c]*after[c]/through[c] : 1;
    }

    // Exchange between ranks until the inflow over coupled faces no longer changes
    scalarField volume(mesh_.V().field()*before);
    nExchanges_ = 0;
    nExchanges_ = transport(volume, mesh_.globalData().nTotalCells());
}


template<class Type>
Foam::label Foam::demOverpackingLimiter::transport
(
    Field<Type>& cells,
    const label maxExchanges
) const
{
    const label nBoundary = mesh_.nBoundaryFaces();
    const Field<Type> own(cells);
    Field<Type> inflow(boundaryK_.size(), Zero);

    for (label exchange = 0;; ++exchange)
    {
        cells = own;
        forAll(inflow, i)
        {
            cells[cellOf(i)] += inflow[i];
        }
        forAll(from_, k)
        {
            cells[to_[k]] += fraction_[k]*cells[from_[k]];
        }
        if (!coupled_ || exchange >= maxExchanges)
        {
            return exchange;
        }

        Field<Type> outflow(inflow.size());
        forAll(outflow, i)
        {
            outflow[i] = out_[i]*cells[cellOf(i)];
        }
        swap(outflow);

        bool changed = false;
        const auto take = [&](const label i)
        {
            changed = changed || outflow[i] != inflow[i];
            inflow[i] = outflow[i];
        };
        for (const polyPatch& patch : mesh_.boundaryMesh())
        {
            for (label j = 0; patch.coupled() && j < patch.size(); ++j)
            {
                take(patch.start() - mesh_.nInternalFaces() + j);
            }
        }
        for (label i = nBoundary; i < inflow.size(); ++i)
        {
            take(i);
        }
        if (!returnReduce(changed, orOp<bool>()))
        {
            return exchange;
        }
    }
}


template<class Type>
void Foam::demOverpackingLimiter::spread(UList<Type>& cells) const
{
    if (remaining_.empty() && !nOverfull_)
    {
        return;
    }

    const scalarField& V = mesh_.V();
    Field<Type> amounts(V*Field<Type>(cells));
    transport(amounts, nExchanges_);
    forAll(cells, c)
    {
        cells[c] = (remaining_[c]/V[c])*amounts[c];
    }
}


template<class Type>
void Foam::demOverpackingLimiter::collect(UList<Type>& cells) const
{
    if (remaining_.empty() && !nOverfull_)
    {
        return;
    }

    const Field<Type> own(remaining_*Field<Type>(cells));
    Field<Type> inflow(boundaryK_.size(), Zero);

    for (label exchange = 0;; ++exchange)
    {
        Field<Type> sum(own);
        forAll(inflow, i)
        {
            sum[cellOf(i)] += out_[i]*inflow[i];
        }
        forAllReverse(from_, k)
        {
            sum[from_[k]] += fraction_[k]*sum[to_[k]];
        }
        if (!coupled_ || exchange >= nExchanges_)
        {
            forAll(cells, c)
            {
                cells[c] = sum[c];
            }
            return;
        }

        List<Type> across;
        cellsAcross(sum, across);
        forAll(inflow, i)
        {
            inflow[i] = out_[i] > 0 ? across[i] : Type(Zero);
        }
    }
}


#define INSTANTIATE(Type)                                                      \
    template void Foam::demOverpackingLimiter::swap(List<Type>&) const;        \
    template void Foam::demOverpackingLimiter::cellsAcross                     \
    (const UList<Type>&, List<Type>&) const;                                   \
    template void Foam::demOverpackingLimiter::spread(UList<Type>&) const;     \
    template void Foam::demOverpackingLimiter::collect(UList<Type>&) const;

INSTANTIATE(Foam::scalar)
INSTANTIATE(Foam::vector)

#undef INSTANTIATE
