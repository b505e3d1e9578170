/*---------------------------------------------------------------------------*\
    demParticleRoutingMap.C -- map of the particle-to-cell routing: from particles to their
    locations on the ranks of the cells, in the order of cells and ids.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demParticleRouting.H"
#include "demColumns.H"
#include "UIndirectList.H"
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>


Foam::List<int64_t> Foam::demParticleRouting::buildMap(const demView& view)
{
    List<int64_t> id(nParticles_);
    forAll(id, i)
    {
        id[i] = idOf(view, i);
    }
    if (!Pstream::parRun())
    {
        particle_ = found_[0];
        return List<int64_t>(id, particle_);
    }

    labelListList particles(Pstream::nProcs());
    labelListList locations(Pstream::nProcs());
    labelList count(Pstream::nProcs(), Zero);

    for (const label owner : owner_)
    {
        ++count[owner];
    }
    forAll(locations, rank)
    {
        particles[rank] = found_[rank];
        locations[rank].setSize(count[rank]);
        count[rank] = 0;
    }
    forAll(owner_, k)
    {
        const label owner = owner_[k];
        locations[owner][count[owner]++] = k;
    }
    map_.reset
    (
        new mapDistributeBase(locations_.size(), std::move(particles), std::move(locations))
    );
    map_().distribute(id);
    return id;
}


Foam::labelList Foam::demParticleRouting::orderByCell(const UList<int64_t>& id) const
{
    typedef std::pair<int64_t, label> entry;

    label nCells = 0;
    for (const demCellLocation& location : locations_)
    {
        nCells = max(nCells, location.cell + 1);
    }
    labelList end(nCells + 1, Zero);
    for (const demCellLocation& location : locations_)
    {
        ++end[location.cell + 1];
    }
    for (label cell = 0; cell < nCells; ++cell)
    {
        end[cell + 1] += end[cell];
    }

    std::vector<entry> entries(locations_.size());
    forAll(locations_, k)
    {
        entries[end[locations_[k].cell]++] = entry(id[k], k);
    }
    label begin = 0;
    for (label cell = 0; cell < nCells; ++cell)
    {
        std::sort(entries.begin() + begin, entries.begin() + end[cell]);
        begin = end[cell];
    }

    labelList order(locations_.size());
    forAll(order, k)
    {
        order[k] = entries[k].second;
    }
    return order;
}


void Foam::demParticleRouting::sort(const UList<int64_t>& id)
{
    const labelList order(orderByCell(id));

    List<demCellLocation> locations(locations_, order);
    locations_.transfer(locations);
    if (!Pstream::parRun())
    {
        particle_ = labelList(UIndirectList<label>(particle_, order));
        return;
    }
    owner_ = labelList(UIndirectList<label>(owner_, order));

    labelList index(order.size());
    forAll(order, k)
    {
        index[order[k]] = k;
    }
    labelListList to(map_().constructMap());
    for (labelList& list : to)
    {
        for (label& k : list)
        {
            k = index[k];
        }
    }
    labelListList from(map_().subMap());
    map_.reset
    (
        new mapDistributeBase(locations_.size(), std::move(from), std::move(to))
    );
}
