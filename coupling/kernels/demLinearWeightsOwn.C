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


void Foam::demLinearWeights::add(const share& more, DynamicList<share>& sum) const
{
    const label celli = local(more.cell);
    label k = celli >= 0 ? place_[celli] : 0;

    while (celli < 0 && k < sum.size() && sum[k].cell != more.cell)
    {
        ++k;
    }
    if (k >= 0 && k < sum.size())
    {
        sum[k].weight += more.weight;
        return;
    }
    if (celli >= 0)
    {
        place_[celli] = sum.size();
    }
    sum.append(more);
}


void Foam::demLinearWeights::addPoint
(
    const label pointi,
    const scalar factor,
    DynamicList<share>& sum
) const
{
    if (shared_ && around_[pointi].size())
    {
        const scalarList& cells = around_[pointi];
        for (label k = 0; k < cells.size(); k += 3)
        {
            add({label(cells[k]), factor*cells[k + 1], cells[k + 2]}, sum);
        }
        return;
    }
    for (label k = start_[pointi]; k < start_[pointi + 1]; ++k)
    {
        add({firstCell_ + cell_[k], factor*weight_[k], 0}, sum);
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
    const scalarField& V = mesh_.V();
    place_.setSize(mesh_.nCells(), -1);
    DynamicList<share> sum(64);
    forAll(locations, i)
    {
        const demCellLocation& s = locations[i];
        const face& f = mesh_.faces()[s.face];

        sum.clear();
        add({firstCell_ + s.cell, s.wCell, 0}, sum);
        for (const label pointi : f)
        {
            const scalar more = (pointi == s.p ? s.wp : 0) + (pointi == s.q ? s.wq : 0);
            addPoint(pointi, s.wFace/f.size() + more, sum);
        }
        q[i] = 0;
        for (const share& at : sum)
        {
            const label celli = local(at.cell);
            q[i] += sqr(at.weight)*(celli >= 0 ? 1/V[celli] : at.inverse);
            if (celli >= 0)
            {
                place_[celli] = -1;
            }
        }
    }
}
