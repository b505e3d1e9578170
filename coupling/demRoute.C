/*---------------------------------------------------------------------------*\
    demRoute.C -- the mesh's side: walk what is asked, here and over ranks, and answer.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRoute.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"


void Foam::demRoute::write(DynamicList<scalar>& letter, const point& x)
{
    letter.append(x.x());
    letter.append(x.y());
    letter.append(x.z());
}


bool Foam::demRoute::filled(const boundBox& box)
{
    return box.min().x() <= box.max().x();
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
        if (filled(box))
        {
            const vector room(1e-6*whole_.span());
            box.min() -= room;
            box.max() += room;
        }
    }
}


void Foam::demRoute::post(mail& out, mail& in)
{
    const label self = Pstream::myProcNo();

    for (DynamicList<scalar>& letter : in)
    {
        letter.clear();
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
                List<scalar> letter(from);
                in[rank].transfer(letter);
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


void Foam::demRoute::searchAll()
{
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
