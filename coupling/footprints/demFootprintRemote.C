/*---------------------------------------------------------------------------*\
    demFootprintRemote.C -- footprints that extend to other ranks or through cyclic
    patches.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFootprint.H"
#include "PstreamReduceOps.H"

namespace Foam
{
    // Numbers in a record: rank, location number and position of the owner, shift,
    // radius, cell from which the flood fill continues
    static const label recordSize = 10;
}


Foam::label Foam::demFootprint::footprintOf(const image& v)
{
    std::array<int64_t, 5> key = {{v.rank, v.location, 0, 0, 0}};
    for (direction c = 0; c < 3; ++c)
    {
        key[2 + c] = std::llround(v.shift[c]/(1e-6*meshSize_));
    }
    if (v.rank == Pstream::myProcNo() && !key[2] && !key[3] && !key[4])
    {
        return v.location;
    }
    const auto inserted = imageIndex_.insert({key, nLocal_ + remote_.size()});
    if (inserted.second)
    {
        remote_.append(v);
    }
    return inserted.first->second;
}


void Foam::demFootprint::sendAcross(const image& v, const label facei)
{
    demLocator::walkState t{v.shift, -1, -1, 0};
    locator_.cross(facei, t);
    send(v, t);
}


void Foam::demFootprint::send(const image& v, const demLocator::walkState& t)
{
    DynamicList<scalar>& message = out_[t.rank];
    message.append(v.rank);
    message.append(v.location);
    demAppend(message, v.origin);
    demAppend(message, t.position);
    message.append(v.radius);
    message.append(t.cell);
}


Foam::demFootprint::image Foam::demFootprint::decode(const scalar* s) const
{
    return image
    {
        label(s[0]), label(s[1]), point(s[2], s[3], s[4]), vector(s[5], s[6], s[7]), s[8]
    };
}


void Foam::demFootprint::floodAll
(
    const UList<demCellLocation>& locations,
    const UList<scalar>& radius
)
{
    nLocal_ = locations.size();
    remote_.clear();
    footprint_.clear();
    coveredCell_.clear();
    integral_.clear();
    visited_.clear();
    imageIndex_.clear();

    forAll(locations, i)
    {
        const image v
        {
            Pstream::myProcNo(), i, locator_.position(locations[i]), vector::zero, radius[i]
        };
        flood(i, v, locations[i].cell);
    }

    label pending = 1;
    while (pending)
    {
        demExchangeBuffers(out_, in_);
        for (const DynamicList<scalar>& message : in_)
        {
            for (label k = 0; k < message.size(); k += recordSize)
            {
                const image v(decode(&message[k]));
                flood(footprintOf(v), v, label(message[k + 9]));
            }
        }
        pending = 0;
        for (const DynamicList<scalar>& message : out_)
        {
            pending += message.size();
        }
        reduce(pending, sumOp<label>());
    }
    connectRemote();
}


// Build the map between locations and their remote footprints: inform the owner of each
void Foam::demFootprint::connectRemote()
{
    labelListList send(Pstream::nProcs()), remote(Pstream::nProcs());
    List<DynamicList<label>> own(Pstream::nProcs());

    forAll(remote_, g)
    {
        out_[remote_[g].rank].append(remote_[g].location);
        own[remote_[g].rank].append(g);
    }
    demExchangeBuffers(out_, in_);

    DynamicList<label> origin;
    forAll(in_, rank)
    {
        send[rank].setSize(in_[rank].size());
        forAll(send[rank], k)
        {
            send[rank][k] = origin.size();
            origin.append(label(in_[rank][k]));
        }
        remote[rank].transfer(own[rank]);
    }
    ownerLocation_.transfer(origin);
    anyRemote_ = returnReduce(ownerLocation_.size(), sumOp<label>()) > 0;
    map_.reset
    (
        new mapDistributeBase(remote_.size(), std::move(send), std::move(remote))
    );
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::demFootprint::toRemote(const UList<Type>& values) const
{
    List<Type> out(ownerLocation_.size());
    forAll(out, k)
    {
        out[k] = values[ownerLocation_[k]];
    }
    map_().distribute(out);
    return tmp<Field<Type>>(new Field<Type>(std::move(out)));
}


template<class Type>
void Foam::demFootprint::addRemote(Field<Type>& remote, UList<Type>& values) const
{
    if (anyRemote_)
    {
        List<Type> back(remote);
        map_().reverseDistribute(ownerLocation_.size(), back);
        forAll(ownerLocation_, k)
        {
            values[ownerLocation_[k]] += back[k];
        }
    }
}


#define INSTANTIATE(Type)                                                      \
    template Foam::tmp<Foam::Field<Type>>                                      \
    Foam::demFootprint::toRemote(const UList<Type>&) const;                    \
    template void Foam::demFootprint::addRemote(Field<Type>&, UList<Type>&) const;

INSTANTIATE(Foam::scalar)
INSTANTIATE(Foam::vector)

#undef INSTANTIATE
