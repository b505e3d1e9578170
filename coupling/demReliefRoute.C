/*---------------------------------------------------------------------------*\
    demReliefRoute.C -- which way the excess went, and what goes that way with it.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRelief.H"
#include "volFields.H"
#include "syncTools.H"
#include <algorithm>


void Foam::demRelief::route
(
    const scalarField& u,
    const UList<scalar>& before,
    const UList<scalar>& after
)
{
    const labelUList& owner = mesh_.faceOwner();
    const label nInternal = inside_.size();
    scalarField through(mesh_.V().field()*before);
    scalarField flow(nInternal);
    DynamicList<label> order;

    forAll(flow, facei)
    {
        const label o = owner[facei];
        const label n = mesh_.faceNeighbour()[facei];
        flow[facei] = inside_[facei]*(u[o] - u[n]);
        if (flow[facei] != 0)
        {
            order.append(facei);
            through[flow[facei] > 0 ? n : o] += mag(flow[facei]);
        }
    }

    out_.setSize(border_.size());
    out_ = 0;
    if (coupled_)
    {
        List<scalar> across;
        syncTools::swapBoundaryCellList(mesh_, u, across);
        forAll(across, i)
        {
            const label o = owner[nInternal + i];
            const scalar away = border_[i]*(u[o] - across[i]);
            out_[i] = max(away, scalar(0));
            through[o] += max(-away, scalar(0));
        }
    }

    const auto up = [&](const label facei)
    {
        return flow[facei] > 0 ? owner[facei] : mesh_.faceNeighbour()[facei];
    };
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            return u[up(a)] > u[up(b)];
        }
    );

    from_.setSize(order.size());
    to_.setSize(order.size());
    part_.setSize(order.size());
    forAll(order, k)
    {
        const label facei = order[k];
        from_[k] = up(facei);
        to_[k] = flow[facei] > 0 ? mesh_.faceNeighbour()[facei] : owner[facei];
        part_[k] = mag(flow[facei])/through[from_[k]];
    }
    forAll(out_, i)
    {
        if (out_[i] > 0)
        {
            out_[i] /= through[owner[nInternal + i]];
        }
    }

    stays_.setSize(through.size());
    forAll(stays_, c)
    {
        stays_[c] = through[c] > 0 ? mesh_.V()[c]*after[c]/through[c] : 1;
    }

    // As often as borders are crossed: until what comes over them stays as it is
    scalarField all(mesh_.V().field()*before);
    crossings_ = 0;
    crossings_ = pass(all, mesh_.globalData().nTotalCells());
}


template<class Type>
Foam::label Foam::demRelief::pass(Field<Type>& cells, const label most) const
{
    const labelUList& owner = mesh_.faceOwner();
    const label nInternal = inside_.size();
    const Field<Type> own(cells);
    Field<Type> come(border_.size(), Zero);

    for (label crossing = 0;; ++crossing)
    {
        cells = own;
        forAll(come, i)
        {
            cells[owner[nInternal + i]] += come[i];
        }
        forAll(from_, k)
        {
            cells[to_[k]] += part_[k]*cells[from_[k]];
        }
        if (!coupled_ || crossing >= most)
        {
            return crossing;
        }

        Field<Type> go(come.size());
        forAll(go, i)
        {
            go[i] = out_[i]*cells[owner[nInternal + i]];
        }
        syncTools::swapBoundaryFaceList(mesh_, go);

        bool changed = false;
        for (const polyPatch& patch : mesh_.boundaryMesh())
        {
            for (label j = 0; patch.coupled() && j < patch.size(); ++j)
            {
                const label i = patch.start() - nInternal + j;
                changed = changed || go[i] != come[i];
                come[i] = go[i];
            }
        }
        if (!returnReduce(changed, orOp<bool>()))
        {
            return crossing;
        }
    }
}


template<class Type>
void Foam::demRelief::spread(UList<Type>& cells) const
{
    if (stays_.empty() && !crowded_)
    {
        return;
    }

    const scalarField& V = mesh_.V();
    Field<Type> amounts(V*Field<Type>(cells));
    pass(amounts, crossings_);
    forAll(cells, c)
    {
        cells[c] = (stays_[c]/V[c])*amounts[c];
    }
}


template<class Type>
void Foam::demRelief::collect(UList<Type>& cells) const
{
    if (stays_.empty() && !crowded_)
    {
        return;
    }

    const labelUList& owner = mesh_.faceOwner();
    const label nInternal = inside_.size();
    const Field<Type> own(stays_*Field<Type>(cells));
    Field<Type> come(border_.size(), Zero);

    for (label crossing = 0;; ++crossing)
    {
        Field<Type> sum(own);
        forAll(come, i)
        {
            sum[owner[nInternal + i]] += out_[i]*come[i];
        }
        forAllReverse(from_, k)
        {
            sum[from_[k]] += part_[k]*sum[to_[k]];
        }
        if (!coupled_ || crossing >= crossings_)
        {
            forAll(cells, c)
            {
                cells[c] = sum[c];
            }
            return;
        }

        List<Type> across;
        syncTools::swapBoundaryCellList(mesh_, sum, across);
        forAll(come, i)
        {
            come[i] = out_[i] > 0 ? across[i] : Type(Zero);
        }
    }
}


#define INSTANTIATE(Type)                                                      \
    template void Foam::demRelief::spread(UList<Type>&) const;                 \
    template void Foam::demRelief::collect(UList<Type>&) const;

INSTANTIATE(Foam::scalar)
INSTANTIATE(Foam::vector)

#undef INSTANTIATE


// ************************************************************************* //
