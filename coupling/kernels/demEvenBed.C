/*---------------------------------------------------------------------------*\
    demEvenBed.C -- what cells pass on so that an even bed stays even.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demEvenBed.H"

namespace Foam
{
    // Round-off of the parts of cells at a point: cells of equal size pass on nothing
    static const scalar negligible = 1e-9;
}


// The tetrahedra of demLocator: cell centre, mean of a face's points, edge
Foam::scalarList Foam::demEvenBed::parts() const
{
    const pointField& points = mesh_.points();
    const labelList& start = weights_.start();
    const labelList& cell = weights_.cell();
    scalarList part(cell.size(), Zero);

    forAll(mesh_.cells(), celli)
    {
        const point& centre = mesh_.cellCentres()[celli];

        for (const label facei : mesh_.cells()[celli])
        {
            const face& f = mesh_.faces()[facei];
            point middle(Zero);
            for (const label pointi : f)
            {
                middle += points[pointi]/f.size();
            }
            scalarList corner(f.size(), Zero);
            scalar whole = 0;

            forAll(f, k)
            {
                const vector p(points[f[k]] - middle);
                const vector q(points[f.nextLabel(k)] - middle);
                const scalar quarter = mag((middle - centre) & (p ^ q))/24;

                corner[k] += quarter;
                corner[f.fcIndex(k)] += quarter;
                whole += quarter;
            }
            forAll(f, k)
            {
                label slot = start[f[k]];
                while (cell[slot] != celli)
                {
                    ++slot;
                }
                part[slot] += corner[k] + whole/f.size();
            }
        }
    }
    return part;
}


Foam::demEvenBed::demEvenBed(const demLinearWeights& weights)
:
    mesh_(weights.mesh()),
    weights_(weights),
    passesOn_(false)
{
    const labelList& start = weights.start();
    const labelList& cell = weights.cell();
    const scalarList& weight = weights.weight();
    const scalarList part(parts());
    scalarField total(mesh_.nPoints(), Zero), lacking(total);
    scalarField received(mesh_.nCells(), Zero);

    forAll(total, pointi)
    {
        for (label slot = start[pointi]; slot < start[pointi + 1]; ++slot)
        {
            total[pointi] += part[slot];
            received[cell[slot]] += part[slot]/3;      // at the cell's own centre
        }
    }
    weights.addCopies(total);

    scalarList excess(part);
    forAll(total, pointi)
    {
        for (label slot = start[pointi]; slot < start[pointi + 1]; ++slot)
        {
            const scalar receives = weight[slot]*total[pointi];
            received[cell[slot]] += receives;
            excess[slot] = receives - part[slot];
            lacking[pointi] += max(-excess[slot], scalar(0));
        }
    }
    weights.addCopies(lacking);

    // At a sliding interface a part goes to the other side
    if (weights.sliding())
    {
        for (const demSlidingInterface::link& l : weights.sliding()->links())
        {
            for (const label pointi : mesh_.faces()[l.face])
            {
                lacking[pointi] = 0;
            }
        }
    }
    if (weights.shared())
    {
        syncTools::syncPointList(mesh_, lacking, minEqOp<scalar>(), GREAT);
    }

    forAll(total, pointi)
    {
        if (lacking[pointi] > negligible*total[pointi])
        {
            for (label slot = start[pointi]; slot < start[pointi + 1]; ++slot)
            {
                const label celli = cell[slot];
                if (excess[slot] > 0)
                {
                    gives_.append(fraction{celli, pointi, excess[slot]/received[celli]});
                }
                else if (excess[slot] < 0)
                {
                    takes_.append(fraction{celli, pointi, -excess[slot]/lacking[pointi]});
                }
            }
        }
    }
    passesOn_ = returnReduce(gives_.size() + takes_.size() > 0, orOp<bool>());
}


template<class Type>
void Foam::demEvenBed::apply(UList<Type>& cells) const
{
    if (!passesOn_)
    {
        return;
    }
    Field<Type> atPoints(mesh_.nPoints(), Zero);
    const List<Type> before(cells);

    for (const fraction& g : gives_)
    {
        const Type part(g.value*before[g.cell]);
        atPoints[g.point] += part;
        cells[g.cell] -= part;
    }
    weights_.addCopies(atPoints);
    for (const fraction& t : takes_)
    {
        cells[t.cell] += t.value*atPoints[t.point];
    }
}


template<class Type>
void Foam::demEvenBed::applyAdjoint(UList<Type>& cells) const
{
    if (!passesOn_)
    {
        return;
    }
    Field<Type> atPoints(mesh_.nPoints(), Zero);
    const List<Type> before(cells);

    for (const fraction& t : takes_)
    {
        atPoints[t.point] += t.value*before[t.cell];
    }
    weights_.addCopies(atPoints);
    for (const fraction& g : gives_)
    {
        cells[g.cell] += g.value*(atPoints[g.point] - before[g.cell]);
    }
}


#define INSTANTIATE(Type)                                                      \
    template void Foam::demEvenBed::apply(UList<Type>&) const;                 \
    template void Foam::demEvenBed::applyAdjoint(UList<Type>&) const;

INSTANTIATE(Foam::scalar)
INSTANTIATE(Foam::vector)
