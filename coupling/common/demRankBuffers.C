/*---------------------------------------------------------------------------*\
    demRankBuffers.C -- sparse exchange of messages between ranks.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRankBuffers.H"
#include "PstreamBuffers.H"

void Foam::demExchangeBuffers(demRankBuffers& out, demRankBuffers& in)
{
    const label self = Pstream::myProcNo();

    for (DynamicList<scalar>& message : in)
    {
        message.clear();
    }
    in[self].swap(out[self]);

    if (Pstream::parRun())
    {
        PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
        forAll(out, rank)
        {
            if (out[rank].size())
            {
                UOPstream to(rank, buffers);
                to << static_cast<const List<scalar>&>(out[rank]);
                out[rank].clear();
            }
        }

        labelList sizes;
        buffers.finishedSends(sizes);
        forAll(sizes, rank)
        {
            if (rank != self && sizes[rank])
            {
                UIPstream from(rank, buffers);
                List<scalar> message(from);
                in[rank].transfer(message);
            }
        }
    }
}
