/*---------------------------------------------------------------------------*\
    demOwnWake.C -- own volume and own wake of the particles.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demOwnWake.H"
#include "demColumns.H"
#include "dem_plan.h"
#include "turbulenceModel.H"

namespace Foam
{

using constant::mathematical::pi;

//- Numbers of a particle in the column own_wake: wake, two memories, r - 1, e less the cells'
static const label width = DEM_OWN_WAKE_WIDTH;

//- Limits of the slip of the law over the slip of the exchange
static const scalar minRatio = 0.5, maxRatio = 2;

//- xi: longitudinal part of q; 0.17 for linear, up to 1/3 for kernels so wide that V q is small
static const scalar longitudinal = 0.17;

//- chi: structure factor S(0) of a random suspension of hard spheres, Percus and Yevick
static scalar structure(const scalar s)
{
    return pow4(1 - s)/sqr(1 + 2*s);
}


//- X
static scalar partOfOwn(const scalar chi, const scalar own)
{
    return chi + (1 - chi)*own/(own + 0.4);
}


//- Void fraction from the sampled one and the own part
static scalar withoutOwn(const scalar sampled, const scalar own)
{
    const scalar read = 1 - sampled;
    scalar s = max(read - own, scalar(0));      // of a lone particle

    for (label pass = 0; pass < 3; ++pass)
    {
        const scalar chi = structure(s);
        s = max(read - own*partOfOwn(chi, own), scalar(0));
    }
    return 1 - s;
}


//- b [m] of the Gaussian with this q
static scalar radiusOf(const scalar q)
{
    return 1/(std::cbrt(q)*std::sqrt(2*pi));
}

//- Psi: wake at the Reynolds number R of the kernel over the one in creeping flow
static scalar inertia(const scalar R)
{
    return 1/std::sqrt(1 + 0.920*R + 0.282*sqr(R));
}

} // End namespace Foam


Foam::tmp<Foam::scalarField> Foam::demOwnWake::grains() const
{
    const int k = dem_scalar_index(particles_.core(), "parcelRatio");
    tmp<scalarField> tn(new scalarField(view_.n, 1));

    for (size_t i = 0; k >= 0 && i < view_.n; i++)
    {
        tn.ref()[i] = pow3(dem_scalar(particles_.core(), k)[i]);
    }
    return tn;
}


Foam::vector Foam::demOwnWake::wake(const label i) const
{
    const double* w = fluid_.own_wake + width*i;
    return vector(w[0], w[1], w[2]);
}


Foam::vector Foam::demOwnWake::slip(const label i) const
{
    const vector law(vectorAt(fluid_.velocity, i) - wake(i) - velocity(view_, i));
    return law/(1 + fluid_.own_wake[width*i + DEM_OWN_WAKE_DRAG]);
}


Foam::scalar Foam::demOwnWake::reynolds(const label i, const scalar b) const
{
    const scalar speed = mag(slip(i));
    const scalar R = speed*b*fluid_.density[i]/viscosity_[i];
    const vector w(vectorAt(fluid_.velocity, i) - velocity(view_, i) - slip(i));
    const scalar carried = min(1, mag(w)/(speed + VSMALL));
    return R*(1 - 0.5*carried*R/(1 + R));
}


Foam::scalar Foam::demOwnWake::screening
(
    const label i,
    const scalar e,
    const scalar b
) const
{
    const scalar speed = mag(slip(i));
    const scalar drag = fluid_.drag_integral[i]/particles_.window();
    const scalar mass = *dem_at(view_.mass, view_.stride, i);
    const scalar A = std::sqrt((1 - e)*drag/(volume(view_, i)*viscosity_[i]*e))*b;
    const scalar a = isFrozen(view_, i) ? 1 : mass*speed/(mass*speed + drag*b + VSMALL);

    return (1 - a)/(1 + 0.4*sqr(A)) + a*std::pow(1 + 0.768*A, -1.49);
}


Foam::tmp<Foam::scalarField> Foam::demOwnWake::effectiveViscosity() const
{
    tmp<scalarField> tmu(new scalarField(view_.n));
    scalarField& mu = tmu.ref();

    forAll(mu, i)
    {
        mu[i] = fluid_.viscosity[i];
    }
    const turbulenceModel* model =
        particles_.mesh().findObject<turbulenceModel>(turbulenceModel::propertiesName);

    if (model && word(model->lookup("simulationType")) != "laminar")
    {
        const scalarField nut(particles_.sample(model->nut()()));
        forAll(mu, i)
        {
            mu[i] += fluid_.density[i]*nut[i];
        }
    }
    return tmu;
}


Foam::demOwnWake::demOwnWake(const demParticles& particles)
:
    particles_(particles),
    view_(particles.view()),
    fluid_(particles.fluid()),
    reads_(0),
    wakes_
    (
        particles.dict().coupling().getOrDefault("ownWake", false)
     && particles.mesh().nGeometricD() == 3
    )
{}


void Foam::demOwnWake::prepare(const bool wholeDrag)
{
    if (wakes_ || particles_.transfer().lawWidth() > 0)
    {
        dem_case_fluid_own_wake(particles_.described());
    }
    if (particles_.displaceFluid())
    {
        reads_ = wholeDrag ? 1 : 2;
    }
}


void Foam::demOwnWake::toParticles(const volScalarField& e)
{
    if (!fluid_.own_wake || particles_.window() <= 0)      // the plan, before the first step
    {
        return;
    }
    const demTransfer& transfer = particles_.transfer();
    const bool twoWay = particles_.twoWay() && particles_.interval() <= 0;
    const bool narrow = transfer.lawWidth() > 0;
    const scalarField volume(volumes(view_)/grains());
    const scalarField& q = transfer.ownWeights();
    const scalarField own(volume*q);
    const scalarField ownRead(volume*(narrow ? transfer.ownLawWeights() : q));
    const scalarField solid(narrow ? transfer.sampleSolidForLaw() : tmp<scalarField>(new scalarField));
    const scalarField inverse
    (
        narrow && twoWay && reads_
      ? transfer.sample(scalarField(1/e.primitiveField()))
      : tmp<scalarField>(new scalarField)
    );

    viscosity_ = effectiveViscosity();
    forAll(q, i)
    {
        double* column = fluid_.own_wake + width*i;
        const scalar cells = fluid_.void_fraction[i];
        const scalar read = narrow ? max(1 - solid[i], transfer.minVoidFraction()) : cells;
        fluid_.void_fraction[i] = withoutOwn(read, ownRead[i]);
        column[DEM_OWN_WAKE_VOID] = fluid_.void_fraction[i] - cells;
        if (wakes_ && twoWay)
        {
            setWake(i, q[i], own[i]);           // reads the last r
        }
        else
        {
            column[0] = column[1] = column[2] = 0;
        }
        column[DEM_OWN_WAKE_DRAG] = 0;
        if (inverse.size())
        {
            setRatio(i, withoutOwn(1/inverse[i], own[i])/fluid_.void_fraction[i]);
        }
    }
}


// The law's slip changes by r times what the motion of the particle in the step changes it
void Foam::demOwnWake::setRatio(const label i, const scalar ratio)
{
    double* column = fluid_.own_wake + width*i;
    const scalar r = min(max(ratio, minRatio), maxRatio);
    const vector w(wake(i));
    const vector slip(vectorAt(fluid_.velocity, i) - w - velocity(view_, i));

    for (direction k = 0; k < 3; ++k)
    {
        column[k] = w[k] + (1 - r)*slip[k];
    }
    column[DEM_OWN_WAKE_DRAG] = r - 1;
    fluid_.slip_factor[i] *= r;
}


void Foam::demOwnWake::setWake(const label i, const scalar q, const scalar own)
{
    const scalar e = max(fluid_.void_fraction[i], scalar(0.1));
    const scalar b = radiusOf(q);
    const scalar R = reynolds(i, b);
    const scalar chi = structure(1 - e);
    const scalar drag =
        std::sqrt(std::cbrt(q))*chi*screening(i, e, b)*inertia(R)/(3*pi*viscosity_[i]*e);
    const scalar displaced = reads_*longitudinal*own*partOfOwn(chi, own)/e;
    const vector slip(this->slip(i));

    double* column = fluid_.own_wake + width*i;
    for (direction k = 0; k < 3; ++k)
    {
        column[k] = drag*(0.6*column[3 + k] + 0.4*column[6 + k]) + displaced*slip[k];
    }
}


Foam::scalar Foam::demOwnWake::uncorrected() const
{
    if
    (
        wakes_
     || !particles_.react()
     || particles_.dict().effectWith(DEM_TRAIT_VISCOSITY).empty()
     || particles_.interval() > 0
     || particles_.mesh().nGeometricD() != 3
    )
    {
        return 0;
    }
    const scalarField q(particles_.transfer().findOwnWeights());
    const scalarField n(grains());
    scalar sum = 0;

    forAll(q, i)
    {
        const scalar V = volume(view_, i)/n[i];
        const scalar d = std::cbrt(6*V/pi);
        const scalar rho = fluid_.density[i];
        const scalar mu = fluid_.viscosity[i];
        const scalar density = *dem_at(view_.mass, view_.stride, i)/(n[i]*V);
        const scalar Re =
            dem_sphere_terminal_velocity(d, density, rho, mu, mag(particles_.gravity()))*d*rho/mu;
        const scalar solid = max(1 - fluid_.void_fraction[i] - V*q[i], scalar(0));
        sum += d*std::cbrt(q[i])*structure(solid)*inertia(Re*radiusOf(q[i])/d);
    }
    return returnReduce(sum, sumOp<scalar>())/max(returnReduce(q.size(), sumOp<label>()), 1);
}


void Foam::demOwnWake::update(const UList<vector>& velocity)
{
    if (!wakes_ || !particles_.twoWay() || particles_.interval() > 0)
    {
        return;
    }
    const scalar T = particles_.window();
    const scalarField& q = particles_.transfer().ownWeights();
    const scalarField n(grains());

    viscosity_ = effectiveViscosity();
    forAll(q, i)
    {
        const scalar b = radiusOf(q[i]);
        const scalar nu = viscosity_[i]/fluid_.density[i];
        const scalar R = reynolds(i, b);
        const scalar fast = T*(1.1 + R)*nu/sqr(b);
        const scalar slow = T*(0.03 + 0.33*R)*nu/sqr(b);
        const vector F
        (
            -(
                impulse(fluid_, i)
              + fluid_.response[i]*(velocity[i] - vectorAt(fluid_.velocity, i))
             )/(T*n[i])
        );
        const vector part(std::sqrt(std::cbrt(q[i]))*F);

        double* phi = fluid_.own_wake + width*i + 3;
        for (direction k = 0; k < 3; ++k)
        {
            phi[k] = (phi[k] + fast*part[k])/(1 + fast);
            phi[3 + k] = (phi[3 + k] + slow*part[k])/(1 + slow);
        }
    }
}
