/*---------------------------------------------------------------------------*\
    demParticleRoutingQuery.C -- particle side of the particle-to-cell routing: queries and
    octree search.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demParticleRouting.H"
#include "demColumns.H"
#include "ListOps.H"
#include "Map.H"
#include "PstreamReduceOps.H"
#include <cstdint>


namespace Foam
{

// Rank and cell of some of the particles that the pairs belong to
static List<scalar> pick
(
    const UList<scalar>& pairs,
    const UList<label>& of,
    const UList<label>& particles
)
{
    Map<label> at(2*of.size());
    forAll(of, k)
    {
        at.insert(of[k], k);
    }

    List<scalar> picked(2*particles.size());
    forAll(particles, k)
    {
        const label from = at[particles[k]];
        picked[2*k] = pairs[2*from];
        picked[2*k + 1] = pairs[2*from + 1];
    }
    return picked;
}

} // End namespace Foam


void Foam::demParticleRouting::query
(
    const demView& view,
    double* rankCell,
    const UList<label>& particles,
    DynamicList<label>& lost
)
{
    for (const label i : particles)
    {
        const label rank = label(rankCell[2*i]);
        if (rank < 0 || rank >= Pstream::nProcs())
        {
            lost.append(i);
            continue;
        }

        // Nearly all stay on this rank: no message
        demLocator::walkState t{position(view, i), label(rankCell[2*i + 1]), rank, 0};
        demCellLocation location;
        if (rank == Pstream::myProcNo() && locator_.walk(t, location) == demLocator::INSIDE)
        {
            locations_.append(location);
            owner_.append(rank);
            found_[rank].append(i);
            rankCell[2*i + 1] = t.cell;
            continue;
        }
        DynamicList<scalar>& message = out_[rank];
        demAppend(message, position(view, i));
        message.append(rankCell[2*i + 1]);
        message.append(certainty_[i]);
        message.append(Pstream::myProcNo());
        message.append(i);
        message.append(0);
    }

    walkAll();

    forAll(in_, rank)
    {
        const DynamicList<scalar>& message = in_[rank];
        for (label k = 0; k < message.size(); k += replySize)
        {
            const label i = label(message[k]);
            if (message[k + 1] < 0)
            {
                lost.append(i);
                continue;
            }
            found_[rank].append(i);
            rankCell[2*i] = rank;
            rankCell[2*i + 1] = message[k + 1];
        }
    }
}


void Foam::demParticleRouting::search
(
    const demView& view,
    double* rankCell,
    const UList<label>& particles
)
{
    for (const label i : particles)
    {
        // a point beyond a cyclic patch: search on the bounds, the walk then passes
        // the patch
        const point x(min(max(position(view, i), whole_.min()), whole_.max()));
        forAll(bounds_, rank)
        {
            if (hasCells(bounds_[rank]) && bounds_[rank].contains(x))
            {
                demAppend(out_[rank], x);
                out_[rank].append(i);
            }
        }
        rankCell[2*i] = rankCell[2*i + 1] = -1;
    }
    searchAll();

    // Take the smallest distance (0 inside a cell), of equal ones the lowest rank.
    // The cell is not certain for a point that was moved to the bounds.
    scalarField nearest(nParticles_, GREAT);
    forAll(in_, rank)
    {
        const DynamicList<scalar>& message = in_[rank];
        for (label k = 0; k < message.size(); k += searchReplySize)
        {
            const label i = label(message[k]);
            if (message[k + 2] < nearest[i])
            {
                nearest[i] = message[k + 2];
                rankCell[2*i] = rank;
                rankCell[2*i + 1] = message[k + 1];
                certainty_[i] = nearest[i] <= 0 && whole_.contains(position(view, i));
            }
        }
    }
}


Foam::demParticleRouting::lostParticles Foam::demParticleRouting::summarise
(
    const demView& view,
    const UList<label>& lost
) const
{
    // the lowest id of all ranks, so that all ranks report the same particle
    int64_t id = INT64_MAX;
    label first = -1;
    for (const label i : lost)
    {
        const int64_t own = idOf(view, i);
        if (first < 0 || own < id)
        {
            id = own;
            first = i;
        }
    }
    const int64_t lowest = returnReduce(id, minOp<int64_t>());
    const bool ours = first >= 0 && id == lowest;
    const vector none(-GREAT, -GREAT, -GREAT);

    lostParticles s;
    s.count = returnReduce(int64_t(lost.size()), sumOp<int64_t>());
    s.id = lowest;
    s.position = returnReduce(ours ? position(view, first) : none, maxOp<vector>());
    s.velocity = returnReduce(ours ? velocity(view, first) : none, maxOp<vector>());
    return s;
}


Foam::pointField Foam::demParticleRouting::centres
(
    const double* rankCell,
    const UList<label>& particles,
    const UList<scalar>& previous
)
{
    forAll(particles, k)
    {
        const bool known = previous[2*k] >= 0 && previous[2*k] < Pstream::nProcs();
        const label i = particles[k];
        const label rank = label(known ? previous[2*k] : rankCell[2*i]);

        if (rank >= 0)
        {
            out_[rank].append(known ? previous[2*k + 1] : rankCell[2*i + 1]);
            out_[rank].append(k);
        }
    }
    demExchangeBuffers(out_, in_);
    forAll(in_, rank)
    {
        const DynamicList<scalar>& message = in_[rank];
        for (label k = 0; k < message.size(); k += centreSize)
        {
            demAppend(out_[rank], locator_.centre(label(message[k])));
            out_[rank].append(message[k + 1]);
        }
    }
    demExchangeBuffers(out_, in_);

    pointField found(particles.size(), Zero);
    for (const DynamicList<scalar>& message : in_)
    {
        for (label k = 0; k < message.size(); k += centreReplySize)
        {
            found[label(message[k + 3])] =
                point(message[k], message[k + 1], message[k + 2]);
        }
    }
    return found;
}


void Foam::demParticleRouting::judge
(
    const demView& view,
    double* rankCell,
    const UList<scalar>& previous,
    boundaryCheck& boundary,
    DynamicList<label>& lost
)
{
    DynamicList<label> particles;
    particles.transfer(lost);

    List<verdict> nearest(particles.size());
    forAll(particles, k)
    {
        const double* at = rankCell + 2*particles[k];
        nearest[k] = verdict{at[0] < 0, label(at[0]), label(at[1])};
    }
    const List<verdict> verdicts
    (
        boundary.judge(view, particles, centres(rankCell, particles, previous), nearest)
    );

    forAll(particles, k)
    {
        const label i = particles[k];
        certainty_[i] = verdicts[k].lost ? 0 : 2;
        if (!verdicts[k].lost)
        {
            rankCell[2*i] = verdicts[k].rank;
            rankCell[2*i + 1] = verdicts[k].cell;
        }
    }
    query(view, rankCell, particles, lost);
}


Foam::demParticleRouting::lostParticles Foam::demParticleRouting::locate
(
    const demView& view,
    double* rankCell,
    boundaryCheck* boundary
)
{
    nParticles_ = label(view.n);
    certainty_.setSize(nParticles_);
    certainty_ = 0;
    locations_.clear();
    owner_.clear();
    for (DynamicList<label>& list : found_)
    {
        list.clear();
    }

    DynamicList<label> particles(identity(nParticles_));
    DynamicList<label> lost;

    query(view, rankCell, particles, lost);
    if (returnReduce(lost.size(), sumOp<label>()) > 0)
    {
        particles.transfer(lost);
        List<scalar> previous(2*particles.size());
        forAll(particles, k)
        {
            previous[2*k] = rankCell[2*particles[k]];
            previous[2*k + 1] = rankCell[2*particles[k] + 1];
        }
        const labelList first(particles);

        search(view, rankCell, particles);
        query(view, rankCell, particles, lost);

        // between warped faces a walk may not end in the cell that the octree found
        particles.transfer(lost);
        for (const label i : particles)
        {
            certainty_[i] *= 2;
        }
        query(view, rankCell, particles, lost);
        if (boundary && returnReduce(lost.size(), sumOp<label>()) > 0)
        {
            judge(view, rankCell, pick(previous, first, lost), *boundary, lost);
        }
        if (returnReduce(lost.size(), sumOp<label>()) > 0)
        {
            return summarise(view, lost);
        }
    }

    sort(buildMap(view));

    return lostParticles{0, -1, Zero, Zero};
}
