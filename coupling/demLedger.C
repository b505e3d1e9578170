/*---------------------------------------------------------------------------*\
    demLedger.C -- momentum: is what the fluid got what the particles got?

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demLedger.H"
#include "demColumns.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demLedger::demLedger()
:
    since_(clock::now()),
    worst_(0),
    most_(0)
{
    for (scalar& s : spent_)
    {
        s = 0;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demLedger::charge(const account who)
{
    const clock::time_point now = clock::now();
    spent_[who] += std::chrono::duration<double>(now - since_).count();
    since_ = now;
}


Foam::scalar Foam::demLedger::exchange
(
    const scalar window,
    const volVectorField& force,
    const struct ::dem_fluid& fluid,
    const UList<vector>& velocity,
    const UList<vector>& push,
    const scalar share,
    const tensor& whole
)
{
    const scalarField& V = force.mesh().V();
    vector toFluid(Zero);
    vector toParticles(Zero);
    scalar moved = 0;

    forAll(V, celli)
    {
        toFluid += window*V[celli]*force[celli];
    }

    forAll(velocity, i)
    {
        const vector J(impulse(fluid, i));
        const vector more
        (
            fluid.response[i]*(velocity[i] - three(fluid.velocity, i))
          + fluid.passed[i]*window*push[i]
        );

        toParticles += J + more;
        moved += mag(J) + mag(more);
    }

    reduce(toFluid, sumOp<vector>());
    reduce(toParticles, sumOp<vector>());
    reduce(moved, sumOp<scalar>());

    // Fluid and particles that go together exchange nothing but round-off of
    // what the fluid's two parts, F and K u, differ in
    most_ = max(most_, moved);
    const scalar error =
        mag(whole & (toFluid + share*toParticles))
       /(max(moved, 1e-3*most_) + VSMALL);
    worst_ = max(worst_, error);
    return error;
}


Foam::vector Foam::demLedger::owed(const struct ::dem_fluid& fluid)
{
    vector sum(Zero);

    for (size_t i = 0; i < fluid.n; i++)
    {
        sum += three(fluid.pending, i);
    }

    reduce(sum, sumOp<vector>());
    return sum;
}


void Foam::demLedger::close() const
{
    Info<< "Suna: time spent on fluid " << spent_[FLUID]
        << " s, particles " << spent_[PARTICLES]
        << " s, exchange " << spent_[EXCHANGE]
        << " s; largest error of the exchange " << worst_ << nl << endl;
}

// ************************************************************************* //
