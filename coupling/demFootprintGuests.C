/*---------------------------------------------------------------------------*\
    demFootprintGuests.C -- footprints that reach over borders.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFootprint.H"
#include "PstreamReduceOps.H"

namespace Foam
{
    // A letter: rank and spot of its home, place there, shift, radius, cell to go on from
    static const label letterSize = 10;
}


Foam::label Foam::demFootprint::printOf(const visitor& v)
{
    std::array<int64_t, 5> key = {{v.rank, v.spot, 0, 0, 0}};
    for (direction c = 0; c < 3; ++c)
    {
        key[2 + c] = std::llround(v.shift[c]/(1e-6*period_));
    }
    if (v.rank == Pstream::myProcNo() && !key[2] && !key[3] && !key[4])
    {
        return v.spot;
    }
    const auto found = known_.insert({key, nSpots_ + guests_.size()});
    if (found.second)
    {
        guests_.append(v);
    }
    return found.first->second;
}


void Foam::demFootprint::tell(const visitor& v, const label facei)
{
    demLocator::traveller t{v.shift, -1, -1};
    locator_.cross(facei, t);

    DynamicList<scalar>& letter = out_[t.rank];
    letter.append(v.rank);
    letter.append(v.spot);
    for (const vector& x : {vector(v.home), vector(t.position)})
    {
        letter.append(x.x());
        letter.append(x.y());
        letter.append(x.z());
    }
    letter.append(v.radius);
    letter.append(t.cell);
}


Foam::demFootprint::visitor Foam::demFootprint::read(const scalar* s) const
{
    return visitor
    {
        label(s[0]), label(s[1]), point(s[2], s[3], s[4]), vector(s[5], s[6], s[7]), s[8]
    };
}


void Foam::demFootprint::floodAll
(
    const UList<demSpot>& spots,
    const UList<scalar>& radius
)
{
    nSpots_ = spots.size();
    guests_.clear();
    print_.clear();
    covered_.clear();
    share_.clear();
    seen_.clear();
    known_.clear();

    forAll(spots, i)
    {
        const visitor v
        {
            Pstream::myProcNo(), i, locator_.position(spots[i]), vector::zero, radius[i]
        };
        flood(i, v, spots[i].cell);
    }

    label underWay = 1;
    while (underWay)
    {
        demRoute::post(out_, in_);
        for (const DynamicList<scalar>& letters : in_)
        {
            for (label k = 0; k < letters.size(); k += letterSize)
            {
                const visitor v(read(&letters[k]));
                flood(printOf(v), v, label(letters[k + 9]));
            }
        }
        underWay = 0;
        for (const DynamicList<scalar>& letters : out_)
        {
            underWay += letters.size();
        }
        reduce(underWay, sumOp<label>());
    }
    meet();
}


// Each guest's home learns of it
void Foam::demFootprint::meet()
{
    labelListList slots(Pstream::nProcs()), guests(Pstream::nProcs());
    List<DynamicList<label>> mine(Pstream::nProcs());

    forAll(guests_, g)
    {
        out_[guests_[g].rank].append(guests_[g].spot);
        mine[guests_[g].rank].append(g);
    }
    demRoute::post(out_, in_);

    DynamicList<label> home;
    forAll(in_, rank)
    {
        slots[rank].setSize(in_[rank].size());
        forAll(slots[rank], k)
        {
            slots[rank][k] = home.size();
            home.append(label(in_[rank][k]));
        }
        guests[rank].transfer(mine[rank]);
    }
    home_.transfer(home);
    away_ = returnReduce(home_.size(), sumOp<label>()) > 0;
    map_.reset
    (
        new mapDistributeBase(guests_.size(), std::move(slots), std::move(guests))
    );
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::demFootprint::toGuests(const UList<Type>& values) const
{
    List<Type> out(home_.size());
    forAll(out, slot)
    {
        out[slot] = values[home_[slot]];
    }
    map_().distribute(out);
    return tmp<Field<Type>>(new Field<Type>(std::move(out)));
}


template<class Type>
void Foam::demFootprint::addGuests(Field<Type>& guests, UList<Type>& values) const
{
    if (away_)
    {
        List<Type> back(guests);
        map_().reverseDistribute(home_.size(), back);
        forAll(home_, slot)
        {
            values[home_[slot]] += back[slot];
        }
    }
}


#define INSTANTIATE(Type)                                                      \
    template Foam::tmp<Foam::Field<Type>>                                      \
    Foam::demFootprint::toGuests(const UList<Type>&) const;                    \
    template void Foam::demFootprint::addGuests(Field<Type>&, UList<Type>&) const;

INSTANTIATE(Foam::scalar)
INSTANTIATE(Foam::vector)

#undef INSTANTIATE


// ************************************************************************* //
