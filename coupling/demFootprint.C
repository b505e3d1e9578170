/*---------------------------------------------------------------------------*\
    demFootprint.C -- the cells that a body covers, and their weights.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFootprint.H"
#include "PstreamReduceOps.H"


Foam::demFootprint::demFootprint
(
    const fvMesh& mesh,
    const demLocator& locator,
    const demShape& shape
)
:
    mesh_(mesh),
    locator_(locator),
    shape_(shape),
    nSpots_(0),
    start_(1, label(0)),
    away_(false),
    stamp_(mesh.nCells(), -1),
    stamps_(0),
    out_(Pstream::nProcs()),
    in_(Pstream::nProcs()),
    period_(mesh.bounds().mag()),
    low_(mesh.nFaces(), point::uniform(GREAT)),
    high_(mesh.nFaces(), point::uniform(-GREAT))
{
    const pointField& points = mesh.points();

    forAll(low_, facei)
    {
        for (const label pointi : mesh.faces()[facei])
        {
            low_[facei] = min(low_[facei], points[pointi]);
            high_[facei] = max(high_[facei], points[pointi]);
        }
    }
}


// * * * * * * * * * * * * * * *  covering * * * * * * * * * * * * * * * * * //

bool Foam::demFootprint::touches
(
    const label facei,
    const point& x,
    const scalar reach
) const
{
    return magSqr(max(max(low_[facei] - x, x - high_[facei]), vector::zero)) < sqr(reach);
}


void Foam::demFootprint::flood(const label print, const visitor& v, const label cell)
{
    const point x(v.home + v.shift);
    const scalar reach = shape_.reach(v.radius);
    const auto before = seen_.find(print);
    DynamicList<label> queue;
    bool crosses = false;

    ++stamps_;
    const auto enter = [&](const label celli)
    {
        if
        (
            stamp_[celli] != stamps_
         && (before == seen_.end() || !before->second.count(celli))
        )
        {
            stamp_[celli] = stamps_;
            queue.append(celli);
        }
    };

    enter(cell);
    for (label k = 0; k < queue.size(); ++k)
    {
        for (const label facei : mesh_.cells()[queue[k]])
        {
            if (locator_.isWall(facei) || !touches(facei, x, reach))
            {
                continue;
            }
            if (facei < mesh_.nInternalFaces())
            {
                const label owner = mesh_.faceOwner()[facei];
                enter(owner == queue[k] ? mesh_.faceNeighbour()[facei] : owner);
            }
            else
            {
                tell(v, facei);
                crosses = true;
            }
        }
    }

    const bool whole = print < nSpots_ && queue.size() == 1 && !crosses && before == seen_.end();
    for (const label celli : queue)
    {
        const scalar share = whole ? 1 : shape_.share(celli, x, v.radius);
        if (share > 0)
        {
            print_.append(print);
            covered_.append(celli);
            share_.append(share);
        }
    }
    if (crosses || print >= nSpots_ || before != seen_.end())
    {
        seen_[print].insert(queue.begin(), queue.end());
    }
}


// Weights by footprint, in the order in which cells were found, and in sum 1 for
// each spot and its guests
void Foam::demFootprint::sort(const UList<demSpot>& spots)
{
    const label n = nSpots_ + guests_.size();
    scalarField sum(n, Zero);
    forAll(print_, k)
    {
        sum[print_[k]] += share_[k];
    }
    {
        scalarField guests(SubList<scalar>(sum, guests_.size(), nSpots_));
        addGuests(guests, sum);
    }
    for (label i = 0; i < nSpots_; ++i)
    {
        // nowhere: in its own cell
        if (sum[i] <= 0)
        {
            print_.append(i);
            covered_.append(spots[i].cell);
            share_.append(1);
            sum[i] = 1;
        }
    }
    if (away_)
    {
        const scalarField theirs(toGuests(sum));
        forAll(theirs, g)
        {
            sum[nSpots_ + g] = theirs[g];
        }
    }

    start_.setSize(n + 1);
    start_ = 0;
    for (const label print : print_)
    {
        ++start_[print + 1];
    }
    for (label i = 0; i < n; ++i)
    {
        start_[i + 1] += start_[i];
    }
    labelList next(start_);
    cell_.setSize(print_.size());
    weight_.setSize(print_.size());
    forAll(print_, k)
    {
        const label slot = next[print_[k]]++;
        cell_[slot] = covered_[k];
        weight_[slot] = share_[k]/sum[print_[k]];
    }
}


void Foam::demFootprint::update(const UList<demSpot>& spots, const UList<scalar>& radius)
{
    floodAll(spots, radius);
    sort(spots);
}


// * * * * * * * * * * * * * * * * use  * * * * * * * * * * * * * * * * * * * //

template<class Type>
void Foam::demFootprint::spread(const UList<Type>& values, UList<Type>& cells) const
{
    for (label i = 0; i < nSpots_; ++i)
    {
        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            cells[cell_[k]] += weight_[k]*values[i];
        }
    }
    if (away_)
    {
        const Field<Type> guests(toGuests(values));
        forAll(guests, g)
        {
            for (label k = start_[nSpots_ + g]; k < start_[nSpots_ + g + 1]; ++k)
            {
                cells[cell_[k]] += weight_[k]*guests[g];
            }
        }
    }
}


template<class Type>
void Foam::demFootprint::collect(const UList<Type>& cells, UList<Type>& values) const
{
    Field<Type> guests(guests_.size(), Zero);
    for (label i = 0; i < nSpots_ + guests.size(); ++i)
    {
        Type& sum = i < nSpots_ ? values[i] : guests[i - nSpots_];
        sum = Zero;
        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            sum += weight_[k]*cells[cell_[k]];
        }
    }
    addGuests(guests, values);
}


#define INSTANTIATE(Type)                                                      \
    template void Foam::demFootprint::spread                                   \
    (const UList<Type>&, UList<Type>&) const;                                  \
    template void Foam::demFootprint::collect                                  \
    (const UList<Type>&, UList<Type>&) const;

INSTANTIATE(Foam::scalar)
INSTANTIATE(Foam::vector)

#undef INSTANTIATE


// ************************************************************************* //
