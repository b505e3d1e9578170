/*---------------------------------------------------------------------------*\
    demRelief.C -- what is too much in a cell goes to its neighbours.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRelief.H"
#include "volFields.H"
#include "syncTools.H"

namespace Foam
{
    // Share of its excess that a cell may give away in one pass
    static const scalar mostGiven = 2.0/3.0;

    // Excess that is left [1], and passes after which the rest stays: an
    // excess spreads by about a cell in a pass, so nearly the whole mesh is full
    static const scalar little = 1e-3;
    static const label mostPasses = 300;
}


Foam::demRelief::demRelief(const fvMesh& mesh)
:
    mesh_(mesh),
    inside_(mesh.nInternalFaces(), Zero),
    border_(mesh.nBoundaryFaces(), Zero),
    coupled_(false),
    crowded_(0)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& owner = mesh_.faceOwner();
    const scalarField area(mag(mesh_.faceAreas()));
    scalarField skin(mesh_.nCells(), Zero);
    labelList open(mesh_.nFaces(), label(1));

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        coupled_ = coupled_ || patch.coupled();
        for (label i = 0; i < patch.size(); ++i)
        {
            open[patch.start() + i] = patch.coupled();
        }
    }
    reduce(coupled_, orOp<bool>());

    forAll(area, facei)
    {
        if (open[facei])
        {
            skin[owner[facei]] += area[facei];
            if (facei < nInternal)
            {
                skin[mesh_.faceNeighbour()[facei]] += area[facei];
            }
        }
    }

    const scalarField deep(mostGiven*mesh_.V().field()/max(skin, VSMALL));
    forAll(inside_, facei)
    {
        inside_[facei] =
            area[facei]*min(deep[owner[facei]], deep[mesh_.faceNeighbour()[facei]]);
    }

    scalarField other(mesh_.nBoundaryFaces());
    forAll(other, i)
    {
        other[i] = deep[owner[nInternal + i]];
    }
    syncTools::swapBoundaryFaceList(mesh_, other);
    forAll(border_, i)
    {
        if (open[nInternal + i])
        {
            border_[i] = area[nInternal + i]*min(deep[owner[nInternal + i]], other[i]);
        }
    }
}


void Foam::demRelief::clear()
{
    full_.clear();
    given_.clear();
    crowded_ = 0;
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::demRelief::balance(const UList<Type>& cells) const
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    tmp<Field<Type>> tgain(new Field<Type>(cells.size(), Zero));
    Field<Type>& gain = tgain.ref();

    forAll(inside_, facei)
    {
        const label o = owner[facei];
        const label n = neighbour[facei];
        const Type flow(inside_[facei]*(cells[n] - cells[o]));
        gain[o] += flow;
        gain[n] -= flow;
    }
    if (coupled_)
    {
        List<Type> across;
        syncTools::swapBoundaryCellList(mesh_, cells, across);
        forAll(across, i)
        {
            const label o = owner[inside_.size() + i];
            gain[o] += border_[i]*(across[i] - cells[o]);
        }
    }
    return tgain;
}


void Foam::demRelief::relieve(UList<scalar>& solid, const scalar most)
{
    clear();
    const scalarField& V = mesh_.V();
    DynamicList<labelList> full;
    DynamicList<scalarField> given;

    for (label pass = 0; pass <= mostPasses; ++pass)
    {
        scalar worst = 0;
        scalarField excess(solid.size(), Zero);
        DynamicList<label> cells;
        DynamicList<scalar> share;
        forAll(solid, celli)
        {
            if (solid[celli] > most)
            {
                excess[celli] = solid[celli] - most;
                worst = max(worst, excess[celli]);
                cells.append(celli);
                share.append(excess[celli]/solid[celli]);
            }
        }
        if (pass == 0)
        {
            crowded_ = returnReduce(cells.size(), sumOp<label>());
        }
        if (pass == mostPasses || returnReduce(worst, maxOp<scalar>()) <= little)
        {
            break;
        }
        const scalarField gain(balance(excess));
        forAll(solid, celli)
        {
            solid[celli] += gain[celli]/V[celli];
        }
        full.append(labelList());
        full.last().transfer(cells);
        given.append(scalarField());
        given.last().transfer(share);
    }
    full_.transfer(full);
    given_.transfer(given);
}


template<class Type>
void Foam::demRelief::spread(UList<Type>& cells) const
{
    const scalarField& V = mesh_.V();
    forAll(full_, pass)
    {
        Field<Type> goes(cells.size(), Zero);
        forAll(full_[pass], k)
        {
            const label celli = full_[pass][k];
            goes[celli] = given_[pass][k]*cells[celli];
        }
        const Field<Type> gain(balance(goes));
        forAll(cells, celli)
        {
            cells[celli] += gain[celli]/V[celli];
        }
    }
}


template<class Type>
void Foam::demRelief::collect(UList<Type>& cells) const
{
    const scalarField& V = mesh_.V();
    forAllReverse(full_, pass)
    {
        const Field<Type> gain(balance(cells));
        forAll(full_[pass], k)
        {
            const label celli = full_[pass][k];
            cells[celli] += (given_[pass][k]/V[celli])*gain[celli];
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
