/*---------------------------------------------------------------------------*\
    demLinearWeightsOwn.C -- part of its own deposit that a particle reads with the
    kernel linear: the squared weights of its cells, across ranks.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demLinearWeights.H"
#include "globalIndex.H"
#include "ListOps.H"
#include "syncTools.H"
#include "volFields.H"

void Foam::demLinearWeights::setAround() const
{
    firstCell_ = globalIndex(mesh_.nCells()).toGlobal(0);
    boolList coupled(mesh_.nPoints(), false);

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.coupled())
        {
            UIndirectList<bool>(coupled, patch.meshPoints()) = true;
        }
    }
    around_.setSize(mesh_.nPoints());
    forAll(around_, pointi)
    {
        for (label k = start_[pointi]; coupled[pointi] && k < start_[pointi + 1]; ++k)
        {
            around_[pointi].append(scalar(firstCell_ + cell_[k]));
            around_[pointi].append(weight_[k]);
            around_[pointi].append(1/mesh_.V()[cell_[k]]);
        }
    }
    syncTools::syncPointList(mesh_, around_, ListOps::appendEqOp<scalar>(), scalarList());
    knowsAround_ = true;
}


void Foam::demLinearWeights::addPoint
(
    const label pointi,
    const scalar factor,
    DynamicList<share>& sum
) const
{
    const auto add = [&](const label cell, const scalar weight, const scalar inverse)
    {
        for (share& s : sum)
        {
            if (s.cell == cell)
            {
                s.weight += weight;
                return;
            }
        }
        sum.append({cell, weight, inverse});
    };

    if (shared_ && around_[pointi].size())
    {
        const scalarList& cells = around_[pointi];
        for (label k = 0; k < cells.size(); k += 3)
        {
            add(label(cells[k]), factor*cells[k + 1], cells[k + 2]);
        }
        return;
    }
    for (label k = start_[pointi]; k < start_[pointi + 1]; ++k)
    {
        add(firstCell_ + cell_[k], factor*weight_[k], 1/mesh_.V()[cell_[k]]);
    }
}


void Foam::demLinearWeights::ownWeights
(
    const UList<demCellLocation>& locations,
    UList<scalar>& q
) const
{
    if (shared_ && !knowsAround_)
    {
        setAround();
    }
    DynamicList<share> sum(64);
    forAll(locations, i)
    {
        const demCellLocation& s = locations[i];
        const face& f = mesh_.faces()[s.face];

        sum.clear();
        sum.append({firstCell_ + s.cell, s.wCell, 1/mesh_.V()[s.cell]});
        for (const label pointi : f)
        {
            const scalar more = (pointi == s.p ? s.wp : 0) + (pointi == s.q ? s.wq : 0);
            addPoint(pointi, s.wFace/f.size() + more, sum);
        }
        q[i] = 0;
        for (const share& at : sum)
        {
            q[i] += sqr(at.weight)*at.inverse;
        }
    }
}
