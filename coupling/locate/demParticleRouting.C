/*---------------------------------------------------------------------------*\
    demParticleRouting.C -- mesh side of the particle-to-cell routing: answers queries by
    a walk over all ranks.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demParticleRouting.H"
#include "PstreamReduceOps.H"


bool Foam::demParticleRouting::hasCells(const boundBox& box)
{
    return box.min().x() <= box.max().x();
}


Foam::demParticleRouting::demParticleRouting(const fvMesh& mesh, const demLocator& locator)
:
    locator_(locator),
    bounds_(Pstream::nProcs()),
    found_(Pstream::nProcs()),
    nParticles_(0),
    out_(Pstream::nProcs()),
    in_(Pstream::nProcs())
{
    const boundBox own(mesh.points(), false);

    for (DynamicList<scalar>& message : out_)
    {
        if (mesh.nPoints())
        {
            demAppend(message, own.min());
            demAppend(message, own.max());
        }
    }
    demExchangeBuffers(out_, in_);
    forAll(in_, rank)
    {
        if (in_[rank].size())
        {
            const scalar* b = in_[rank].begin();
            bounds_[rank] = boundBox(point(b[0], b[1], b[2]), point(b[3], b[4], b[5]));
            whole_.add(bounds_[rank]);
        }
    }
    // margin for points on the bounds
    for (boundBox& box : bounds_)
    {
        if (hasCells(box))
        {
            const vector margin(1e-6*whole_.span());
            box.min() -= margin;
            box.max() += margin;
        }
    }
}


// * * * * * * * * * * * * * * * mesh side  * * * * * * * * * * * * * * * * //

void Foam::demParticleRouting::walkOne
(
    const scalar* query,
    demRankBuffers& replies,
    demRankBuffers* forward
)
{
    const demLocator::walkState start
    {
        point(query[0], query[1], query[2]),
        label(query[3]),
        Pstream::myProcNo(),
        label(query[7])
    };
    const label certainty = label(query[4]);
    const label owner = label(query[5]);

    demLocator::walkState t(start);
    demCellLocation location;
    const demLocator::result end = locator_.walk(t, location);
    bool found = end == demLocator::INSIDE;

    if (end == demLocator::OTHER_RANK && forward && certainty < 2)
    {
        DynamicList<scalar>& message = (*forward)[t.rank];
        demAppend(message, t.position);
        message.append(t.cell);
        message.append(0);
        message.append(owner);
        message.append(query[6]);
        message.append(t.passages);
        return;
    }
    if (!found && certainty)
    {
        t = start;
        locator_.clampToCell(t, location);
        found = true;
    }
    if (found)
    {
        locations_.append(location);
        owner_.append(owner);
    }
    replies[owner].append(query[6]);
    replies[owner].append(found ? scalar(t.cell) : scalar(-1));
}


void Foam::demParticleRouting::walkAll()
{
    // more rounds than this are a walk in circles around a distorted cell
    const label maxRounds = 20 + 2*Pstream::nProcs();

    demRankBuffers replies(Pstream::nProcs());
    label underWay = 1;

    for (label round = 0; underWay > 0; ++round)
    {
        demExchangeBuffers(out_, in_);
        underWay = 0;
        for (const DynamicList<scalar>& message : in_)
        {
            for (label k = 0; k < message.size(); k += querySize)
            {
                walkOne(&message[k], replies, round < maxRounds ? &out_ : nullptr);
            }
        }
        for (const DynamicList<scalar>& message : out_)
        {
            underWay += message.size();
        }
        reduce(underWay, sumOp<label>());
    }

    out_.swap(replies);
    demExchangeBuffers(out_, in_);
}


void Foam::demParticleRouting::searchAll()
{
    demExchangeBuffers(out_, in_);
    forAll(in_, rank)
    {
        const DynamicList<scalar>& message = in_[rank];
        label celli = -1;
        for (label k = 0; k < message.size(); k += searchSize)
        {
            const point x(message[k], message[k + 1], message[k + 2]);
            scalar distance;
            celli = locator_.search(x, celli, distance);

            out_[rank].append(message[k + 3]);
            out_[rank].append(celli);
            out_[rank].append(distance);
        }
    }
    demExchangeBuffers(out_, in_);
}
