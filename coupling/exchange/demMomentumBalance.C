/*---------------------------------------------------------------------------*\
    demMomentumBalance.C -- momentum balance of the exchange.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demMomentumBalance.H"
#include "demColumns.H"
#include "PstreamReduceOps.H"

Foam::demMomentumBalance::demMomentumBalance()
:
    maxError_(0),
    ofLargestTerm_(0),
    maxMoved_(0)
{}


Foam::scalar Foam::demMomentumBalance::update
(
    const scalar window,
    const volVectorField& force,
    const struct ::dem_fluid& fluid,
    const UList<vector>& velocity,
    const UList<vector>& pressureForce,
    const scalar fraction,
    const tensor& whole
)
{
    const scalarField& V = force.mesh().V();
    vector toFluid(Zero);
    vector toParticles(Zero);
    scalar moved = 0;
    scalar terms = 0;

    // Fluid and particles at rest have velocities of round-off: an impulse that moves
    // neither by 1e-9 of a cell in a window is no term to compare with
    const scalar least = 1e-9*cbrt(gAverage(V))/window;

    forAll(V, celli)
    {
        toFluid += window*V[celli]*force[celli];
        terms += window*V[celli]*mag(force[celli]);
    }

    forAll(velocity, i)
    {
        const vector J(impulse(fluid, i));
        const vector correction
        (
            fluid.response[i]*(velocity[i] - vectorAt(fluid.velocity, i))
          + fluid.transmitted_fraction[i]*window*pressureForce[i]
        );

        toParticles += J + correction;
        moved += mag(J) + mag(correction);
        terms +=
            fluid.response[i]
           *(mag(velocity[i]) + mag(vectorAt(fluid.velocity, i)) + least);
    }

    reduce(toFluid, sumOp<vector>());
    reduce(toParticles, sumOp<vector>());
    reduce(moved, sumOp<scalar>());
    reduce(terms, sumOp<scalar>());

    // If fluid and particles move together only round-off of F - K u is exchanged:
    // then compare with the largest exchange so far
    maxMoved_ = max(maxMoved_, moved);
    const scalar difference = mag(whole & (toFluid + fraction*toParticles));
    const scalar error = difference/(max(moved, 1e-3*maxMoved_) + VSMALL);

    ofLargestTerm_ = difference/(max(terms, max(moved, 1e-3*maxMoved_)) + VSMALL);
    maxError_ = max(maxError_, error);
    return error;
}


Foam::vector Foam::demMomentumBalance::owed(const struct ::dem_fluid& fluid)
{
    vector sum(Zero);

    for (size_t i = 0; i < fluid.n; i++)
    {
        sum += vectorAt(fluid.carried_over_impulse, i);
    }

    reduce(sum, sumOp<vector>());
    return sum;
}
