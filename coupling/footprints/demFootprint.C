/*---------------------------------------------------------------------------*\
    demFootprint.C -- cells in the support of a kernel, their weights, deposition
    and sampling with them.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFootprint.H"
#include "volFields.H"
#include "PstreamReduceOps.H"


Foam::demFootprint::demFootprint
(
    const fvMesh& mesh,
    const demLocator& locator,
    const demCellIntegral& kernel
)
:
    mesh_(mesh),
    locator_(locator),
    kernel_(kernel),
    nLocal_(0),
    start_(1, label(0)),
    anyRemote_(false),
    visitedBy_(mesh.nCells(), -1),
    nFloods_(0),
    out_(Pstream::nProcs()),
    in_(Pstream::nProcs()),
    meshSize_(mesh.bounds().mag()),
    faceMin_(mesh.nFaces(), point::uniform(GREAT)),
    faceMax_(mesh.nFaces(), point::uniform(-GREAT))
{
    const pointField& points = mesh.points();

    forAll(faceMin_, facei)
    {
        for (const label pointi : mesh.faces()[facei])
        {
            faceMin_[facei] = min(faceMin_[facei], points[pointi]);
            faceMax_[facei] = max(faceMax_[facei], points[pointi]);
        }
    }
}


// * * * * * * * * * * * * * * *  flood fill * * * * * * * * * * * * * * * * //

bool Foam::demFootprint::isWithinReach
(
    const label facei,
    const point& x,
    const scalar reach
) const
{
    return magSqr(max(max(faceMin_[facei] - x, x - faceMax_[facei]), vector::zero)) < sqr(reach);
}


void Foam::demFootprint::flood(const label footprint, const image& v, const label cell)
{
    const point x(v.origin + v.shift);
    const scalar reach = kernel_.reach(v.radius);
    const auto earlier = visited_.find(footprint);
    DynamicList<label> queue;
    bool crosses = false;

    ++nFloods_;
    const auto enter = [&](const label celli)
    {
        if
        (
            visitedBy_[celli] != nFloods_
         && (earlier == visited_.end() || !earlier->second.count(celli))
        )
        {
            visitedBy_[celli] = nFloods_;
            queue.append(celli);
        }
    };

    enter(cell);
    for (label k = 0; k < queue.size(); ++k)
    {
        for (const label facei : mesh_.cells()[queue[k]])
        {
            if (locator_.isBoundary(facei) || !isWithinReach(facei, x, reach))
            {
                continue;
            }
            if (facei < mesh_.nInternalFaces())
            {
                const label owner = mesh_.faceOwner()[facei];
                enter(owner == queue[k] ? mesh_.faceNeighbour()[facei] : owner);
            }
            else if (locator_.isSliding(facei))
            {
                const demSlidingInterface& sliding = locator_.interface();
                for (const label l : sliding.linksOf(facei))
                {
                    const demSlidingInterface::link& to = sliding.links()[l];
                    if (to.rank == Pstream::myProcNo())
                    {
                        enter(to.otherCell);
                    }
                    else
                    {
                        send(v, demLocator::walkState{v.shift, to.otherCell, to.rank, 0});
                        crosses = true;
                    }
                }
            }
            else
            {
                sendAcross(v, facei);
                crosses = true;
            }
        }
    }

    const bool inOneCell =
        footprint < nLocal_ && queue.size() == 1 && !crosses && earlier == visited_.end();
    for (const label celli : queue)
    {
        const scalar integral = inOneCell ? 1 : kernel_.integral(celli, x, v.radius);
        if (integral > 0)
        {
            footprint_.append(footprint);
            coveredCell_.append(celli);
            integral_.append(integral);
        }
    }
    if (crosses || footprint >= nLocal_ || earlier != visited_.end())
    {
        visited_[footprint].insert(queue.begin(), queue.end());
    }
}


// Sort the weights by footprint, cells in the order in which they were found, and
// normalise them: sum 1 over the local and remote footprints of each location
void Foam::demFootprint::sort(const UList<demCellLocation>& locations)
{
    const label n = nLocal_ + remote_.size();
    scalarField sum(n, Zero);
    forAll(footprint_, k)
    {
        sum[footprint_[k]] += integral_[k];
    }
    {
        scalarField remote(SubList<scalar>(sum, remote_.size(), nLocal_));
        addRemote(remote, sum);
    }
    for (label i = 0; i < nLocal_; ++i)
    {
        // no cell contains a part of the kernel: use the particle's own cell
        if (sum[i] <= 0)
        {
            footprint_.append(i);
            coveredCell_.append(locations[i].cell);
            integral_.append(1);
            sum[i] = 1;
        }
    }
    if (anyRemote_)
    {
        const scalarField remote(toRemote(sum));
        forAll(remote, g)
        {
            sum[nLocal_ + g] = remote[g];
        }
    }

    start_.setSize(n + 1);
    start_ = 0;
    for (const label footprint : footprint_)
    {
        ++start_[footprint + 1];
    }
    for (label i = 0; i < n; ++i)
    {
        start_[i + 1] += start_[i];
    }
    labelList next(start_);
    cell_.setSize(footprint_.size());
    weight_.setSize(footprint_.size());
    forAll(footprint_, k)
    {
        const label slot = next[footprint_[k]]++;
        cell_[slot] = coveredCell_[k];
        weight_[slot] = integral_[k]/sum[footprint_[k]];
    }
}


void Foam::demFootprint::update
(
    const UList<demCellLocation>& locations,
    const UList<scalar>& radius
)
{
    floodAll(locations, radius);
    sort(locations);
}


// * * * * * * * * * * * * * * * * use  * * * * * * * * * * * * * * * * * * * //

template<class Type>
void Foam::demFootprint::spread(const UList<Type>& values, UList<Type>& cells) const
{
    for (label i = 0; i < nLocal_; ++i)
    {
        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            cells[cell_[k]] += weight_[k]*values[i];
        }
    }
    if (anyRemote_)
    {
        const Field<Type> remote(toRemote(values));
        forAll(remote, g)
        {
            for (label k = start_[nLocal_ + g]; k < start_[nLocal_ + g + 1]; ++k)
            {
                cells[cell_[k]] += weight_[k]*remote[g];
            }
        }
    }
}


template<class Type>
void Foam::demFootprint::collect(const UList<Type>& cells, UList<Type>& values) const
{
    Field<Type> remote(remote_.size(), Zero);
    for (label i = 0; i < nLocal_ + remote.size(); ++i)
    {
        Type& sum = i < nLocal_ ? values[i] : remote[i - nLocal_];
        sum = Zero;
        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            sum += weight_[k]*cells[cell_[k]];
        }
    }
    addRemote(remote, values);
}


void Foam::demFootprint::ownWeights(UList<scalar>& values) const
{
    scalarField remote(remote_.size(), Zero);
    for (label i = 0; i < nLocal_ + remote.size(); ++i)
    {
        scalar& sum = i < nLocal_ ? values[i] : remote[i - nLocal_];
        sum = 0;
        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            sum += sqr(weight_[k])/mesh_.V()[cell_[k]];
        }
    }
    addRemote(remote, values);
}


#define INSTANTIATE(Type)                                                      \
    template void Foam::demFootprint::spread                                   \
    (const UList<Type>&, UList<Type>&) const;                                  \
    template void Foam::demFootprint::collect                                  \
    (const UList<Type>&, UList<Type>&) const;

INSTANTIATE(Foam::scalar)
INSTANTIATE(Foam::vector)

#undef INSTANTIATE
