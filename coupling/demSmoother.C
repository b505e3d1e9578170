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
    // Share of its value that a cell may give away in one sub-step
    static const scalar mostGiven = 2.0/3.0;
}


Foam::tmp<Foam::scalarField> Foam::demSmoother::conductance
(
    const vectorField& S,
    const vectorField& d
)
{
    // d is never taken to lie flatter on the face than this, as in OpenFOAM
    return max(S & d, 0.05*mag(S)*mag(d))/magSqr(d);
}


Foam::demSmoother::demSmoother(const fvMesh& mesh)
:
    mesh_(mesh),
    border_(mesh.nBoundaryFaces(), Zero),
    stiffest_(0),
    coupled_(false),
    steps_(0),
    rate_(mesh.nCells(), Zero)
{
    const pointField& C = mesh_.cellCentres();
    const label nInternal = mesh_.nInternalFaces();
    vectorField d(nInternal);

    forAll(d, facei)
    {
        d[facei] = C[mesh_.faceNeighbour()[facei]] - C[mesh_.faceOwner()[facei]];
    }
    inside_ = conductance(vectorField(SubField<vector>(mesh_.faceAreas(), nInternal)), d);

    scalarField sum(mesh_.nCells(), Zero);

    forAll(inside_, facei)
    {
        sum[mesh_.faceOwner()[facei]] += inside_[facei];
        sum[mesh_.faceNeighbour()[facei]] += inside_[facei];
    }
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (patch.coupled())
        {
            const scalarField k(conductance(patch.Sf(), patch.delta()));
            forAll(k, i)
            {
                border_[patch.start() - nInternal + i] = k[i];
                sum[patch.faceCells()[i]] += k[i];
            }
            coupled_ = true;
        }
    }
    reduce(coupled_, orOp<bool>());

    stiffest_ = returnReduce(max(scalarField(sum/mesh_.V().field())), maxOp<scalar>());
}


void Foam::demSmoother::setWidth(const scalar width)
{
    const scalar area = sqr(width)/4;

    steps_ = label(std::ceil(area*stiffest_/mostGiven));
    if (steps_ > 0)
    {
        rate_ = (area/steps_)/mesh_.V().field();
    }
}


template<class Type>
void Foam::demSmoother::smooth(UList<Type>& cells) const
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    Field<Type> gain(cells.size());
    List<Type> across;

    for (label step = 0; step < steps_; ++step)
    {
        gain = Zero;
        for (label facei = 0; facei < nInternal; ++facei)
        {
            const label o = owner[facei];
            const label n = neighbour[facei];
            const Type flow(inside_[facei]*(cells[n] - cells[o]));
            gain[o] += flow;
            gain[n] -= flow;
        }
        if (coupled_)
        {
            syncTools::swapBoundaryCellList(mesh_, cells, across);
            forAll(across, i)
            {
                const label o = owner[nInternal + i];
                gain[o] += border_[i]*(across[i] - cells[o]);
            }
        }
        forAll(cells, celli)
        {
            cells[celli] += rate_[celli]*gain[celli];
        }
    }
}


template void Foam::demSmoother::smooth(UList<Foam::scalar>&) const;
template void Foam::demSmoother::smooth(UList<Foam::vector>&) const;


// ************************************************************************* //
