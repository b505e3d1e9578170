/*---------------------------------------------------------------------------*\
    demSmootherLumps.C -- thin cells are joined with their neighbours.

    Two lumps of volumes V_a, V_b, linked by k = S.d/d.d, come together at the
    rate k (1/V_a + 1/V_b) [1/m2]: 2/h^2 for two equal boxes of thickness h. In
    a round each lump is joined with one neighbour at most, the tightest links
    first; of equal ones that of the first face. Thickness doubles with the
    rounds.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSmoother.H"
#include "ListOps.H"
#include <algorithm>
#include <map>


void Foam::demSmoother::link(labelList& from, labelList& to, vectorField& area) const
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


Foam::label Foam::demSmoother::join(const scalar most)
{
    labelList from, to;
    vectorField area;
    link(from, to, area);

    vectorField d(from.size());
    forAll(d, l)
    {
        d[l] = centre_[to[l]] - centre_[from[l]];
    }
    const scalarField k(conductance(area, d));
    labelList tight(from.size());
    DynamicList<label> order;
    forAll(k, l)
    {
        // equal to a thousandth of an octave: not for round-off to decide
        const scalar rate = k[l]*(1/volume_[from[l]] + 1/volume_[to[l]]);
        tight[l] = label(std::lround(1000*std::log2(rate/most)));
        if (rate > most)
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
            return tight[l] > tight[m] || (tight[l] == tight[m] && l < m);
        }
    );

    // The first of a pair takes the other in
    labelList into(identity(volume_.size()));
    labelList taken(volume_.size(), Zero);
    label pairs = 0;
    for (const label l : order)
    {
        if (!taken[from[l]] && !taken[to[l]])
        {
            taken[from[l]] = taken[to[l]] = 1;
            into[to[l]] = from[l];
            ++pairs;
        }
    }

    // Numbers without gaps
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


void Foam::demSmoother::lump(const scalar most)
{
    // Most meshes have nothing to lump
    const scalarField k(conductance(mesh_.faceAreas(), lines()));
    bool any = false;
    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        any =
            any
         || k[facei]*(1/volume_[mesh_.faceOwner()[facei]] + 1/volume_[mesh_.faceNeighbour()[facei]])
          > most;
    }
    if (any)
    {
        lump_ = identity(mesh_.nCells());
        while (join(most))
        {}
    }
}


// ************************************************************************* //
