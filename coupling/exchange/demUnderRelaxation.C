/*---------------------------------------------------------------------------*\
    demUnderRelaxation.C -- under-relaxation of the pressure gradient and of Du/Dt
    at light particles.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demUnderRelaxation.H"
#include "demColumns.H"
#include "PstreamReduceOps.H"

Foam::demUnderRelaxation::demUnderRelaxation
(
    const struct ::dem_fluid& fluid,
    const scalarField& V,
    const vector& gravity,
    const scalar window,
    const bool owes
)
:
    fluid_(fluid),
    V_(V),
    gravity_(gravity),
    window_(window),
    owes_(owes)
{}


Foam::vector Foam::demUnderRelaxation::hydrostatic(const label i) const
{
    return fluid_.density[i]*gravity_;
}


Foam::vector Foam::demUnderRelaxation::next
(
    const label i,
    const vector& gradient
) const
{
    const scalar w = fluid_.under_relaxation[i];

    if (!owes_)
    {
        const vector felt(vectorAt(fluid_.pressure_gradient, i));
        return felt + w*(gradient - felt);
    }

    const vector dynamic
    (
        vectorAt(fluid_.owed_pressure_impulse, i)/(window_*V_[i])
      + gradient - hydrostatic(i)
    );
    return hydrostatic(i) + w*dynamic;
}


void Foam::demUnderRelaxation::begin
(
    const UList<vector>& gradient,
    const bool withoutFactors
)
{
    forAll(gradient, i)
    {
        double* felt = fluid_.pressure_gradient + 3*i;
        double* owed = fluid_.owed_pressure_impulse + 3*i;
        const vector rhoG(hydrostatic(i));
        const bool isNew = fluid_.under_relaxation[i] == 0;

        for (direction d = 0; d < 3; d++)
        {
            if (isNew)
            {
                felt[d] = owes_ && !withoutFactors ? rhoG[d] : gradient[i][d];
                owed[d] = owes_ ? window_*V_[i]*(felt[d] - rhoG[d]) : 0;
            }
            if (owes_)
            {
                owed[d] -= window_*V_[i]*(felt[d] - rhoG[d]);
            }
        }
    }
}


void Foam::demUnderRelaxation::relaxAcceleration
(
    const UList<vector>& acceleration
)
{
    forAll(acceleration, i)
    {
        for (direction d = 0; d < 3; d++)
        {
            double& felt = fluid_.acceleration[3*i + d];
            felt += fluid_.under_relaxation[i]*(acceleration[i][d] - felt);
        }
    }
}


void Foam::demUnderRelaxation::response(UList<scalar>& volumeResponse) const
{
    forAll(volumeResponse, i)
    {
        volumeResponse[i] *= fluid_.under_relaxation[i];
    }
}


Foam::tmp<Foam::vectorField> Foam::demUnderRelaxation::explicitForce
(
    const UList<vector>& gradient
) const
{
    tmp<vectorField> tforce(next(gradient));
    vectorField& force = tforce.ref();

    forAll(force, i)
    {
        force[i] =
           -fluid_.transmitted_fraction[i]*V_[i]
           *(force[i] - vectorAt(fluid_.pressure_gradient, i));
    }
    return tforce;
}


Foam::tmp<Foam::vectorField> Foam::demUnderRelaxation::next
(
    const UList<vector>& gradient
) const
{
    tmp<vectorField> tfelt(new vectorField(gradient.size()));
    vectorField& felt = tfelt.ref();

    forAll(felt, i)
    {
        felt[i] = next(i, gradient[i]);
    }
    return tfelt;
}


void Foam::demUnderRelaxation::finish(const UList<vector>& gradient)
{
    forAll(gradient, i)
    {
        const vector felt(next(i, gradient[i]));
        const vector dynamic(gradient[i] - hydrostatic(i));

        for (direction d = 0; d < 3; d++)
        {
            fluid_.pressure_gradient[3*i + d] = felt[d];
            if (owes_)
            {
                fluid_.owed_pressure_impulse[3*i + d] += window_*V_[i]*dynamic[d];
            }
        }
    }
}


void Foam::demUnderRelaxation::changeDensity(const UList<scalar>& density)
{
    forAll(density, i)
    {
        for (direction d = 0; d < 3; d++)
        {
            fluid_.pressure_gradient[3*i + d] += (density[i] - fluid_.density[i])*gravity_[d];
        }
    }
}


bool Foam::demUnderRelaxation::withoutFactors(const struct ::dem_fluid& fluid)
{
    bool none = true, some = false;

    for (size_t i = 0; fluid.under_relaxation && i < fluid.n; i++)
    {
        some = true;
        none = none && fluid.under_relaxation[i] == 0;
    }
    reduce(none, andOp<bool>());
    reduce(some, orOp<bool>());
    return some && none;
}


Foam::vector Foam::demUnderRelaxation::owed() const
{
    vector sum(Zero);

    for (size_t i = 0; i < fluid_.n; i++)
    {
        sum -= vectorAt(fluid_.owed_pressure_impulse, i);
    }
    reduce(sum, sumOp<vector>());
    return sum;
}
