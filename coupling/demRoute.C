/*---------------------------------------------------------------------------*\
    demRoute.C -- questions, walks across ranks, answers.

    Letters are lists of numbers (cells and ranks are exact in a double):
    question  x y z cell sure owner particle   answer  particle cell (-1: nowhere)
    search    x y z particle                   found   particle cell distance

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRoute.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"

namespace Foam
{
    static const label questionSize = 7, answerSize = 2, searchSize = 4, foundSize = 3;

    static point positionOf(const demView& view, const label i)
    {
        const double* x = dem_at(view.position, view.stride, size_t(i));
        return point(x[0], x[1], x[2]);
    }

    static int64_t idOf(const demView& view, const label i)
    {
        const char* first = reinterpret_cast<const char*>(view.id);
        return *reinterpret_cast<const int64_t*>(first + view.stride*size_t(i));
    }

    static void write(DynamicList<scalar>& letter, const point& x)
    {
        letter.append(x.x());
        letter.append(x.y());
        letter.append(x.z());
    }
}


Foam::demRoute::demRoute(const fvMesh& mesh, const demLocator& locator)
:
    locator_(locator),
    bounds_(Pstream::nProcs()),
    asked_(Pstream::nProcs()),
    nParticles_(0),
    out_(Pstream::nProcs()),
    in_(Pstream::nProcs())
{
    const boundBox mine(mesh.points(), false);

    for (DynamicList<scalar>& letter : out_)
    {
        if (mesh.nPoints())
        {
            write(letter, mine.min());
            write(letter, mine.max());
        }
    }
    post();
    forAll(in_, rank)
    {
        if (in_[rank].size())
        {
            const scalar* b = in_[rank].begin();
            bounds_[rank] = boundBox(point(b[0], b[1], b[2]), point(b[3], b[4], b[5]));
            whole_.add(bounds_[rank]);
        }
    }
    // room for points on the bounds
    for (boundBox& box : bounds_)
    {
        if (box.valid())
        {
            const vector room(1e-6*whole_.span());
            box.min() -= room;
            box.max() += room;
        }
    }
}


void Foam::demRoute::post()
{
    const label self = Pstream::myProcNo();

    for (DynamicList<scalar>& letter : in_)
    {
        letter.clear();
    }
    in_[self].swap(out_[self]);

    if (Pstream::parRun())
    {
        PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
        forAll(out_, rank)
        {
            if (out_[rank].size())
            {
                UOPstream to(rank, buffers);
                to << static_cast<const List<scalar>&>(out_[rank]);
                out_[rank].clear();
            }
        }

        labelList sizes;
        buffers.finishedSends(sizes);
        forAll(sizes, rank)
        {
            if (rank != self && sizes[rank])
            {
                UIPstream from(rank, buffers);
                List<scalar> letter(from);
                in_[rank].transfer(letter);
            }
        }
    }
}


// * * * * * * * * * * * * * * * mesh's side * * * * * * * * * * * * * * * * //

void Foam::demRoute::walkOne(const scalar* question, mail& answers, mail* onward)
{
    const demLocator::traveller start
    {
        point(question[0], question[1], question[2]),
        label(question[3]),
        Pstream::myProcNo()
    };
    const label sure = label(question[4]);
    const label owner = label(question[5]);

    demLocator::traveller t(start);
    demSpot spot;
    const demLocator::ending end = locator_.walk(t, spot);
    bool found = end == demLocator::INSIDE;

    if (end == demLocator::LEFT && onward && sure < 2)
    {
        DynamicList<scalar>& letter = (*onward)[t.rank];
        write(letter, t.position);
        letter.append(t.cell);
        letter.append(0);
        letter.append(owner);
        letter.append(question[6]);
        return;
    }
    if (!found && sure)
    {
        t = start;
        locator_.settle(t, spot);
        found = true;
    }
    if (found)
    {
        spots_.append(spot);
        asker_.append(owner);
    }
    answers[owner].append(question[6]);
    answers[owner].append(found ? scalar(t.cell) : scalar(-1));
}


void Foam::demRoute::walkAll()
{
    // more hand-overs than this are a walk in circles around an odd cell
    const label mostRounds = 20 + 2*Pstream::nProcs();

    mail answers(Pstream::nProcs());
    label underWay = 1;

    for (label round = 0; underWay > 0; ++round)
    {
        post();
        underWay = 0;
        for (const DynamicList<scalar>& letter : in_)
        {
            for (label k = 0; k < letter.size(); k += questionSize)
            {
                walkOne(&letter[k], answers, round < mostRounds ? &out_ : nullptr);
            }
        }
        for (const DynamicList<scalar>& letter : out_)
        {
            underWay += letter.size();
        }
        reduce(underWay, sumOp<label>());
    }

    out_.swap(answers);
    post();
}


// * * * * * * * * * * * * * * * owner's side  * * * * * * * * * * * * * * * //

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
            if (bounds_[rank].valid() && bounds_[rank].contains(x))
            {
                write(out_[rank], x);
                out_[rank].append(i);
            }
        }
        place[2*i] = place[2*i + 1] = -1;
    }
    post();

    forAll(in_, rank)
    {
        const DynamicList<scalar>& letter = in_[rank];
        for (label k = 0; k < letter.size(); k += searchSize)
        {
            const point x(letter[k], letter[k + 1], letter[k + 2]);
            scalar distance;
            const label celli = locator_.search(x, distance);

            out_[rank].append(letter[k + 3]);
            out_[rank].append(celli);
            out_[rank].append(distance);
        }
    }
    post();

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


void Foam::demRoute::complain(const demView& view, const UList<label>& lost) const
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
    const point none(-GREAT, -GREAT, -GREAT);
    const point where
    (
        returnReduce(mine >= 0 && id == lowest ? positionOf(view, mine) : none, maxOp<point>())
    );
    const label count = returnReduce(lost.size(), sumOp<label>());

    FatalErrorInFunction
        << count << " particle(s) outside the mesh, whose bounds are " << whole_
        << "; the first is particle " << int64_t(lowest) << " at " << where
        << ". Start particles inside the mesh, and make walls of all patches"
        << " that particles must not pass" << exit(FatalError);
}


void Foam::demRoute::locate(const demView& view, double* place)
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
        if (returnReduce(lost.size(), sumOp<label>()) > 0)
        {
            complain(view, lost);
        }
    }

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


void Foam::demRoute::toCentres()
{
    for (demSpot& spot : spots_)
    {
        spot.wCell = 1;
        spot.wFace = spot.wp = spot.wq = 0;
    }
}


// ************************************************************************* //
