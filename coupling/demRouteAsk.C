/*---------------------------------------------------------------------------*\
    demRouteAsk.C -- the owner's side: ask, search, name what is lost, keep the route.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRoute.H"
#include "ListOps.H"
#include "PstreamReduceOps.H"
#include <algorithm>

namespace Foam
{
    static point positionOf(const demView& view, const label i)
    {
        const double* x = dem_at(view.position, view.stride, size_t(i));
        return point(x[0], x[1], x[2]);
    }

    static vector velocityOf(const demView& view, const label i)
    {
        const double* v = dem_at(view.velocity, view.stride, size_t(i));
        return vector(v[0], v[1], v[2]);
    }

    static int64_t idOf(const demView& view, const label i)
    {
        const char* first = reinterpret_cast<const char*>(view.id);
        return *reinterpret_cast<const int64_t*>(first + view.stride*size_t(i));
    }
}


void Foam::demRoute::ask
(
    const demView& view,
    double* place,
    const UList<label>& who,
    DynamicList<label>& lost
)
{
    for (const label i : who)
    {
        const label rank = label(place[2*i]);
        if (rank < 0 || rank >= Pstream::nProcs())
        {
            lost.append(i);
            continue;
        }
        DynamicList<scalar>& letter = out_[rank];
        write(letter, positionOf(view, i));
        letter.append(place[2*i + 1]);
        letter.append(sure_[i]);
        letter.append(Pstream::myProcNo());
        letter.append(i);
    }

    walkAll();

    forAll(in_, rank)
    {
        const DynamicList<scalar>& letter = in_[rank];
        for (label k = 0; k < letter.size(); k += answerSize)
        {
            const label i = label(letter[k]);
            if (letter[k + 1] < 0)
            {
                lost.append(i);
                continue;
            }
            asked_[rank].append(i);
            place[2*i] = rank;
            place[2*i + 1] = letter[k + 1];
        }
    }
}


void Foam::demRoute::search(const demView& view, double* place, const UList<label>& who)
{
    for (const label i : who)
    {
        // a point beyond a cyclic patch starts from the bounds and walks through
        const point x(min(max(positionOf(view, i), whole_.min()), whole_.max()));
        forAll(bounds_, rank)
        {
            if (filled(bounds_[rank]) && bounds_[rank].contains(x))
            {
                write(out_[rank], x);
                out_[rank].append(i);
            }
        }
        place[2*i] = place[2*i + 1] = -1;
    }
    searchAll();

    // the nearest wins: distance 0 inside a cell; of equals the lowest rank.
    // A tree is not sure about a point that was moved to the bounds.
    scalarField nearest(nParticles_, GREAT);
    forAll(in_, rank)
    {
        const DynamicList<scalar>& letter = in_[rank];
        for (label k = 0; k < letter.size(); k += foundSize)
        {
            const label i = label(letter[k]);
            if (letter[k + 2] < nearest[i])
            {
                nearest[i] = letter[k + 2];
                place[2*i] = rank;
                place[2*i + 1] = letter[k + 1];
                sure_[i] = nearest[i] <= 0 && whole_.contains(positionOf(view, i));
            }
        }
    }
}


Foam::demRoute::stray Foam::demRoute::firstOf
(
    const demView& view,
    const UList<label>& lost
) const
{
    // the lowest id of all ranks, so that all say the same
    scalar id = GREAT;
    label mine = -1;
    for (const label i : lost)
    {
        const scalar here = scalar(idOf(view, i));
        if (mine < 0 || here < id)
        {
            id = here;
            mine = i;
        }
    }
    const scalar lowest = returnReduce(id, minOp<scalar>());
    const bool ours = mine >= 0 && id == lowest;
    const vector none(-GREAT, -GREAT, -GREAT);

    stray s;
    s.count = returnReduce(lost.size(), sumOp<label>());
    s.id = int64_t(lowest);
    s.position = returnReduce(ours ? positionOf(view, mine) : none, maxOp<vector>());
    s.velocity = returnReduce(ours ? velocityOf(view, mine) : none, maxOp<vector>());
    return s;
}


Foam::demRoute::stray Foam::demRoute::locate
(
    const demView& view,
    double* place,
    exits* out
)
{
    nParticles_ = label(view.n);
    sure_.setSize(nParticles_);
    sure_ = 0;
    spots_.clear();
    asker_.clear();
    for (DynamicList<label>& list : asked_)
    {
        list.clear();
    }

    DynamicList<label> who(identity(nParticles_));
    DynamicList<label> lost;

    ask(view, place, who, lost);
    if (returnReduce(lost.size(), sumOp<label>()) > 0)
    {
        who.transfer(lost);
        search(view, place, who);
        ask(view, place, who, lost);

        // between warped faces a walk may not end in the cell that a tree is sure of
        who.transfer(lost);
        for (const label i : who)
        {
            sure_[i] *= 2;
        }
        ask(view, place, who, lost);
        if (out && returnReduce(lost.size(), sumOp<label>()) > 0)
        {
            who.transfer(lost);
            const boolList leaves(out->leave(view, who));
            forAll(who, k)
            {
                sure_[who[k]] = leaves[k] ? 2 : 0;
            }
            ask(view, place, who, lost);
        }
        if (returnReduce(lost.size(), sumOp<label>()) > 0)
        {
            return firstOf(view, lost);
        }
    }

    build();
    sort(view);

    return stray{0, -1, Zero, Zero};
}


void Foam::demRoute::build()
{
    labelListList particles(Pstream::nProcs());
    labelListList spots(Pstream::nProcs());
    labelList count(Pstream::nProcs(), Zero);

    for (const label owner : asker_)
    {
        ++count[owner];
    }
    forAll(spots, rank)
    {
        particles[rank] = asked_[rank];
        spots[rank].setSize(count[rank]);
        count[rank] = 0;
    }
    forAll(asker_, k)
    {
        const label owner = asker_[k];
        spots[owner][count[owner]++] = k;
    }
    map_.reset
    (
        new mapDistributeBase(spots_.size(), std::move(particles), std::move(spots))
    );
}


void Foam::demRoute::sort(const demView& view)
{
    // exact in a double, as ids are counted up
    scalarList id(nParticles_);
    forAll(id, i)
    {
        id[i] = scalar(idOf(view, i));
    }
    map_().distribute(id);

    labelList order(identity(spots_.size()));
    std::sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            return
                spots_[a].cell < spots_[b].cell
             || (spots_[a].cell == spots_[b].cell && id[a] < id[b]);
        }
    );

    const List<demSpot> spots(spots_);
    const labelList asker(asker_);
    labelList now(order.size());

    forAll(order, k)
    {
        spots_[k] = spots[order[k]];
        asker_[k] = asker[order[k]];
        now[order[k]] = k;
    }

    labelListList to(map_().constructMap());
    for (labelList& list : to)
    {
        for (label& k : list)
        {
            k = now[k];
        }
    }
    labelListList from(map_().subMap());
    map_.reset
    (
        new mapDistributeBase(spots_.size(), std::move(from), std::move(to))
    );
}


// ************************************************************************* //
