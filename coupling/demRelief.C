/*---------------------------------------------------------------------------*\
    demRelief.C -- what is too much in a cell goes to its neighbours.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRelief.H"
#include "volFields.H"
#include "syncTools.H"

namespace Foam
{
    // Excess that is left [1]: far above round-off, and far below what matters
    static const scalar little = 1e-10;

    // Round-off of a flow, over what its sum of magnitudes may be: it is all that
    // can be seen of the excess of a sliver
    static const scalar roundOff = 1e-14;

    // Room that is made where the mesh has none [1], so that there is an end
    static const scalar room = 1e-6;

    // Rounds: each fills at least one layer of cells more. Beyond these, and
    // beyond steps of the conjugate gradients, the rest stays, and is told
    static const label mostRounds = 1000;
    static const label mostSteps = 5000;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demRelief::demRelief(const fvMesh& mesh)
:
    mesh_(mesh),
    inside_(mesh.nInternalFaces(), Zero),
    border_(mesh.nBoundaryFaces(), Zero),
    sum_(mesh.nCells(), Zero),
    coupled_(false),
    crossings_(0),
    crowded_(0),
    full_(0)
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& owner = mesh_.faceOwner();
    const vectorField& S = mesh_.faceAreas();
    const pointField& C = mesh_.cellCentres();

    // d is never taken to lie flatter on the face than this, as in OpenFOAM
    const auto k = [](const vector& area, const vector& d)
    {
        return max(area & d, 0.05*mag(area)*mag(d))/max(magSqr(d), VSMALL);
    };

    forAll(inside_, facei)
    {
        const label n = mesh_.faceNeighbour()[facei];
        inside_[facei] = k(S[facei], C[n] - C[owner[facei]]);
        sum_[owner[facei]] += inside_[facei];
        sum_[n] += inside_[facei];
    }

    // Over coupled faces from what each side sees of its own cell
    vectorField arm(mesh_.nBoundaryFaces());
    forAll(arm, i)
    {
        arm[i] = mesh_.faceCentres()[nInternal + i] - C[owner[nInternal + i]];
    }
    vectorField other(arm);
    syncTools::swapBoundaryFaceList(mesh_, other);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        coupled_ = coupled_ || patch.coupled();
        for (label j = 0; patch.coupled() && j < patch.size(); ++j)
        {
            const label i = patch.start() - nInternal + j;
            border_[i] = k(S[nInternal + i], arm[i] - other[i]);
            sum_[owner[nInternal + i]] += border_[i];
        }
    }
    reduce(coupled_, orOp<bool>());
}


void Foam::demRelief::clear()
{
    from_.clear();
    to_.clear();
    part_.clear();
    stays_.clear();
    crowded_ = full_ = 0;
}


// * * * * * * * * * * * * * * * * solving * * * * * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::demRelief::excess(const scalarField& f) const
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    tmp<scalarField> tgives(new scalarField(f.size(), Zero));
    scalarField& gives = tgives.ref();

    forAll(inside_, facei)
    {
        const label o = owner[facei];
        const label n = neighbour[facei];
        const scalar flow = inside_[facei]*(f[o] - f[n]);
        gives[o] += flow;
        gives[n] -= flow;
    }
    if (coupled_)
    {
        List<scalar> across;
        syncTools::swapBoundaryCellList(mesh_, f, across);
        forAll(across, i)
        {
            const label o = owner[inside_.size() + i];
            gives[o] += border_[i]*(f[o] - across[i]);
        }
    }
    return tgives;
}


// Conjugate gradients, with the diagonal as preconditioner
void Foam::demRelief::level
(
    const boolList& these,
    const scalarField& asked,
    scalarField& u
) const
{
    const scalarField& V = mesh_.V();
    scalarField r(asked - excess(u));
    scalarField p(u.size(), Zero);
    scalar last = 0;

    for (label step = 0; step < mostSteps; ++step)
    {
        const scalar seen = roundOff*gMax(u);
        bool more = false;
        scalar rz = 0;
        forAll(r, c)
        {
            if (these[c])
            {
                more = more || mag(r[c]) > 0.5*little*V[c] + seen*sum_[c];
                rz += sqr(r[c])/sum_[c];
            }
        }
        if (!returnReduce(more, orOp<bool>()))
        {
            return;
        }
        reduce(rz, sumOp<scalar>());

        forAll(p, c)
        {
            p[c] = these[c] ? r[c]/sum_[c] + (step ? rz/last : 0)*p[c] : 0;
        }
        last = rz;

        const scalarField q(excess(p));
        const scalar pq = gSumProd(p, q);
        if (pq <= 0)
        {
            return;                         // nowhere to go
        }
        u += (rz/pq)*p;
        r -= (rz/pq)*q;
    }
}


void Foam::demRelief::relieve(UList<scalar>& solid, const scalar most)
{
    clear();

    const scalarField& V = mesh_.V();
    const scalarField s(solid);
    boolList these(s.size());
    label count = 0;
    forAll(s, c)
    {
        these[c] = s[c] > most;
        count += these[c];
    }
    crowded_ = returnReduce(count, sumOp<label>());
    if (!crowded_)
    {
        return;
    }

    const scalar mean = gSumProd(V, s)/gSum(V);
    const scalarField asked(V*(s - max(most, mean*(1 + room))));
    scalarField u(s.size(), Zero);

    for (label round = 0, more = 1; more && round < mostRounds; ++round)
    {
        level(these, asked, u);

        const scalarField left(asked - excess(u));
        const scalar seen = 2*roundOff*gMax(u);
        more = 0;
        forAll(left, c)
        {
            if (!these[c] && left[c] > little*V[c] + seen*sum_[c])
            {
                these[c] = true;
                ++more;
            }
        }
        reduce(more, sumOp<label>());
    }

    count = 0;
    for (const bool c : these)
    {
        count += c;
    }
    full_ = returnReduce(count, sumOp<label>());

    const scalarField given(excess(u));
    forAll(solid, c)
    {
        solid[c] -= given[c]/V[c];
    }
    route(u, s, solid);
}


// ************************************************************************* //
