/*---------------------------------------------------------------------------*\
    demSmootherLumps.C -- join thin cells with their neighbours to lumps
    (agglomeration).

    The values of two lumps of volumes V_a, V_b with the conductance k = S.d/d.d
    between them approach each other at the rate k (1/V_a + 1/V_b) [1/m2], which
    is 2/h^2 for two equal boxes of thickness h. Each round joins a lump with one
    neighbour at most: the pair with the highest rate first, and among equal rates the
    pair with the first face. The thickness doubles with each round.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSmoother.H"
#include "ListOps.H"
#include <algorithm>
#include <map>


void Foam::demSmoother::findLinks(labelList& from, labelList& to, vectorField& area) const
{
    std::map<std::pair<label, label>, label> known;
    DynamicList<label> a, b;
    DynamicList<vector> S;

    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        const label o = lump_[mesh_.faceOwner()[facei]];
        const label n = lump_[mesh_.faceNeighbour()[facei]];
        if (o == n) continue;

        const std::pair<label, label> ends(min(o, n), max(o, n));
        const auto found = known.insert({ends, a.size()});
        if (found.second)
        {
            a.append(ends.first);
            b.append(ends.second);
            S.append(Zero);
        }
        const vector& Sf = mesh_.faceAreas()[facei];
        S[found.first->second] += o < n ? Sf : -Sf;
    }
    from.transfer(a);
    to.transfer(b);
    area.transfer(S);
}


Foam::label Foam::demSmoother::join(const scalar limit)
{
    labelList from, to;
    vectorField area;
    findLinks(from, to, area);

    vectorField d(from.size());
    forAll(d, l)
    {
        d[l] = centre_[to[l]] - centre_[from[l]];
    }
    const scalarField k(conductance(area, d));
    labelList rateClass(from.size());
    DynamicList<label> order;
    forAll(k, l)
    {
        // compared in thousandths of a factor of 2, so that round-off does not decide
        const scalar rate = k[l]*(1/volume_[from[l]] + 1/volume_[to[l]]);
        rateClass[l] = label(std::lround(1000*std::log2(rate/limit)));
        if (rate > limit)
        {
            order.append(l);
        }
    }
    std::sort
    (
        order.begin(),
        order.end(),
        [&](const label l, const label m)
        {
            return rateClass[l] > rateClass[m] || (rateClass[l] == rateClass[m] && l < m);
        }
    );

    // The second of a pair is joined to the first
    labelList into(identity(volume_.size()));
    labelList joined(volume_.size(), Zero);
    label pairs = 0;
    for (const label l : order)
    {
        if (!joined[from[l]] && !joined[to[l]])
        {
            joined[from[l]] = joined[to[l]] = 1;
            into[to[l]] = from[l];
            ++pairs;
        }
    }

    // Renumber without gaps
    labelList number(volume_.size(), -1);
    scalarField volume(volume_.size() - pairs, Zero);
    pointField centre(volume.size(), Zero);
    label next = 0;
    forAll(into, l)
    {
        if (into[l] == l)
        {
            number[l] = next++;
        }
    }
    forAll(into, l)
    {
        const label n = number[into[l]];
        volume[n] += volume_[l];
        centre[n] += volume_[l]*centre_[l];
    }
    centre /= volume;
    for (label& l : lump_)
    {
        l = number[into[l]];
    }
    volume_.transfer(volume);
    centre_.transfer(centre);
    return pairs;
}


void Foam::demSmoother::lumpCells(const scalar limit)
{
    // Most meshes have no cells to lump
    const scalarField k(conductance(mesh_.faceAreas(), centreLines()));
    bool found = false;
    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        found =
            found
         || k[facei]*(1/volume_[mesh_.faceOwner()[facei]] + 1/volume_[mesh_.faceNeighbour()[facei]])
          > limit;
    }
    if (found)
    {
        lump_ = identity(mesh_.nCells());
        while (join(limit))
        {}
    }
}
