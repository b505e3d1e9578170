/*---------------------------------------------------------------------------*\
    demOverpackingLimiter.C -- move excess solid volume of overpacked cells to their
    neighbours.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demOverpackingLimiter.H"
#include "demConductance.H"
#include "volFields.H"
#include "syncTools.H"

namespace Foam
{
    // Excess solid fraction that may remain [1]: far above round-off, without
    // influence on results
    static const scalar tolerance = 1e-10;

    // Round-off of a flow over the sum of magnitudes of its terms: the resolution of
    // the excess in slivers
    static const scalar roundOff = 1e-14;

    // The limit is at least the mean times 1 + margin [1], so that a solution exists
    static const scalar margin = 1e-6;

    // Limits of rounds (each fills at least one more layer of cells) and of steps of
    // the conjugate gradients. What remains beyond them stays in its cells and is
    // reported.
    static const label maxRounds = 1000;
    static const label maxSteps = 5000;
}


Foam::demOverpackingLimiter::demOverpackingLimiter
(
    const fvMesh& mesh,
    const demSlidingInterface* sliding
)
:
    mesh_(mesh),
    interface_(sliding),
    internalK_(mesh.nInternalFaces(), Zero),
    boundaryK_(mesh.nBoundaryFaces() + (sliding ? sliding->links().size() : 0), Zero),
    sumK_(mesh.nCells(), Zero),
    coupled_(false),
    nExchanges_(0),
    nOverfull_(0),
    nFull_(0)
{
    const label nInternal = mesh_.nInternalFaces();
    const label nBoundary = mesh_.nBoundaryFaces();
    const labelUList& owner = mesh_.faceOwner();
    const vectorField& S = mesh_.faceAreas();
    const pointField& C = mesh_.cellCentres();

    forAll(internalK_, facei)
    {
        const label n = mesh_.faceNeighbour()[facei];
        internalK_[facei] = demConductance(S[facei], C[n] - C[owner[facei]]);
        sumK_[owner[facei]] += internalK_[facei];
        sumK_[n] += internalK_[facei];
    }

    // Over coupled faces: from the distance of each side's own cell to its face
    vectorField arm(boundaryK_.size());
    forAll(arm, i)
    {
        arm[i] = (i < nBoundary ? mesh_.faceCentres()[nInternal + i] : point::zero) - C[cellOf(i)];
    }
    List<vector> other(arm);
    swap(other);
    const auto connect = [&](const label i, const vector& area)
    {
        boundaryK_[i] = demConductance(area, arm[i] - other[i]);
        sumK_[cellOf(i)] += boundaryK_[i];
    };
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        coupled_ = coupled_ || patch.coupled();
        for (label j = 0; patch.coupled() && j < patch.size(); ++j)
        {
            const label i = patch.start() - nInternal + j;
            connect(i, S[nInternal + i]);
        }
    }
    for (label i = nBoundary; i < boundaryK_.size(); ++i)
    {
        connect(i, interface_->links()[i - nBoundary].area);
    }
    coupled_ = coupled_ || interface_;
    reduce(coupled_, orOp<bool>());
}


void Foam::demOverpackingLimiter::clear()
{
    from_.clear();
    to_.clear();
    fraction_.clear();
    remaining_.clear();
    nOverfull_ = nFull_ = 0;
}


// * * * * * * * * * * * * * * * * solving * * * * * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::demOverpackingLimiter::netOutflow(const scalarField& f) const
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    tmp<scalarField> toutflow(new scalarField(f.size(), Zero));
    scalarField& outflow = toutflow.ref();

    forAll(internalK_, facei)
    {
        const label o = owner[facei];
        const label n = neighbour[facei];
        const scalar flow = internalK_[facei]*(f[o] - f[n]);
        outflow[o] += flow;
        outflow[n] -= flow;
    }
    if (coupled_)
    {
        List<scalar> across;
        cellsAcross(f, across);
        forAll(across, i)
        {
            const label o = cellOf(i);
            outflow[o] += boundaryK_[i]*(f[o] - across[i]);
        }
    }
    return toutflow;
}


// Conjugate gradients with diagonal preconditioner
void Foam::demOverpackingLimiter::solve
(
    const boolList& active,
    const scalarField& target,
    scalarField& u
) const
{
    const scalarField& V = mesh_.V();
    scalarField r(target - netOutflow(u));
    scalarField p(u.size(), Zero);
    scalar previous = 0;

    for (label step = 0; step < maxSteps; ++step)
    {
        const scalar resolution = roundOff*gMax(u);
        bool unconverged = false;
        scalar rz = 0;
        forAll(r, c)
        {
            if (active[c])
            {
                unconverged = unconverged || mag(r[c]) > 0.5*tolerance*V[c] + resolution*sumK_[c];
                rz += sqr(r[c])/sumK_[c];
            }
        }
        if (!returnReduce(unconverged, orOp<bool>()))
        {
            return;
        }
        reduce(rz, sumOp<scalar>());

        forAll(p, c)
        {
            p[c] = active[c] ? r[c]/sumK_[c] + (step ? rz/previous : 0)*p[c] : 0;
        }
        previous = rz;

        const scalarField q(netOutflow(p));
        const scalar pq = gSumProd(p, q);
        if (pq <= 0)
        {
            return;                         // no cell left to move to
        }
        u += (rz/pq)*p;
        r -= (rz/pq)*q;
    }
}


void Foam::demOverpackingLimiter::limitSolid(UList<scalar>& solid, const scalar limit)
{
    clear();

    const scalarField& V = mesh_.V();
    const scalarField s(solid);
    boolList active(s.size());
    label count = 0;
    forAll(s, c)
    {
        active[c] = s[c] > limit;
        count += active[c];
    }
    nOverfull_ = returnReduce(count, sumOp<label>());
    if (!nOverfull_)
    {
        return;
    }

    const scalar mean = gSumProd(V, s)/gSum(V);
    const scalarField target(V*(s - max(limit, mean*(1 + margin))));
    scalarField u(s.size(), Zero);

    for (label round = 0, added = 1; added && round < maxRounds; ++round)
    {
        solve(active, target, u);

        const scalarField remaining(target - netOutflow(u));
        const scalar resolution = 2*roundOff*gMax(u);
        added = 0;
        forAll(remaining, c)
        {
            if (!active[c] && remaining[c] > tolerance*V[c] + resolution*sumK_[c])
            {
                active[c] = true;
                ++added;
            }
        }
        reduce(added, sumOp<label>());
    }

    count = 0;
    for (const bool c : active)
    {
        count += c;
    }
    nFull_ = returnReduce(count, sumOp<label>());

    const scalarField moved(netOutflow(u));
    forAll(solid, c)
    {
        solid[c] -= moved[c]/V[c];
    }
    setTransport(u, s, solid);
}
