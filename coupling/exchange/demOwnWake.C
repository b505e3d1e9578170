/*---------------------------------------------------------------------------*\
    demOwnWake.C -- own volume and own wake of the particles.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demOwnWake.H"
#include "demColumns.H"
#include "turbulenceModel.H"

namespace Foam
{

using constant::mathematical::pi;

//- chi: structure factor S(0) of a random suspension of hard spheres, Percus and Yevick
static scalar structure(const scalar s)
{
    return pow4(1 - s)/sqr(1 + 2*s);
}


//- Void fraction from the sampled one and the own part
static scalar withoutOwn(const scalar sampled, const scalar own)
{
    const scalar read = 1 - sampled;
    scalar s = max(read - own, scalar(0));      // of a lone particle

    for (label pass = 0; pass < 3; ++pass)
    {
        const scalar chi = structure(s);
        s = max(read - own*(chi + (1 - chi)*own/(own + 0.4)), scalar(0));
    }
    return 1 - s;
}


static uint16_t flagsOf(const struct ::dem_view& view, const label i)
{
    const char* first = reinterpret_cast<const char*>(view.flags);
    return *reinterpret_cast<const uint16_t*>(first + view.stride*size_t(i));
}


//- b [m] of the Gaussian with this q
static scalar radiusOf(const scalar q)
{
    return 1/(std::cbrt(q)*std::sqrt(2*pi));
}

} // End namespace Foam


bool Foam::demOwnWake::isActive(const demParticles& particles)
{
    return
        particles.dict().coupling().getOrDefault("ownWake", false)
     && particles.mesh().nGeometricD() == 3;
}


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


Foam::scalar Foam::demOwnWake::slip(const label i) const
{
    return mag
    (
        vectorAt(fluid_.velocity, i) - vectorAt(fluid_.own_wake, 3*i) - velocity(view_, i)
    );
}


Foam::scalar Foam::demOwnWake::screening
(
    const label i,
    const scalar e,
    const scalar b,
    const scalar slip
) const
{
    const scalar drag = fluid_.drag_time[i]/particles_.window();
    const scalar radius = *dem_at(view_.radius, view_.stride, i);
    const scalar volume = 4.0/3.0*pi*pow3(radius);
    const scalar mass = *dem_at(view_.mass, view_.stride, i);
    const scalar A = std::sqrt((1 - e)*drag/(volume*viscosity_[i]*e))*b;
    const bool frozen = flagsOf(view_, i) & 1;
    const scalar a = frozen ? 1 : mass*slip/(mass*slip + drag*b + VSMALL);

    return 1 - a + a*std::pow(1 + 0.768*A, -1.49);
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
    active_(isActive(particles))
{}


void Foam::demOwnWake::prepare() const
{
    if (active_ && particles_.twoWay() && particles_.interval() == 0)
    {
        dem_case_fluid_own_wake(particles_.described());
    }
}


void Foam::demOwnWake::toParticles()
{
    if (!active_)
    {
        return;
    }
    const scalarField& q = particles_.transfer().ownWeights();
    const scalarField own(volumes(view_)*q/grains());

    forAll(q, i)
    {
        fluid_.void_fraction[i] = withoutOwn(fluid_.void_fraction[i], own[i]);
    }
    if (!fluid_.own_wake || particles_.window() <= 0)      // the plan, before the first step
    {
        return;
    }

    viscosity_ = effectiveViscosity();
    forAll(q, i)
    {
        const scalar e = max(fluid_.void_fraction[i], scalar(0.1));
        const scalar b = radiusOf(q[i]);
        const scalar speed = slip(i);
        const scalar R = speed*b*fluid_.density[i]/viscosity_[i];
        const scalar factor =
            std::sqrt(std::cbrt(q[i]))*structure(1 - e)*screening(i, e, b, speed)
           /(std::sqrt(1 + 0.920*R + 0.282*sqr(R))*3*pi*viscosity_[i]*e);

        double* wake = fluid_.own_wake + 9*i;
        for (direction k = 0; k < 3; ++k)
        {
            wake[k] = factor*(0.6*wake[3 + k] + 0.4*wake[6 + k]);
        }
    }
}


void Foam::demOwnWake::update(const UList<vector>& velocity)
{
    if (!active_ || !fluid_.own_wake)
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
        const scalar R = slip(i)*b/nu;
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

        double* phi = fluid_.own_wake + 9*i + 3;
        for (direction k = 0; k < 3; ++k)
        {
            phi[k] = (phi[k] + fast*part[k])/(1 + fast);
            phi[3 + k] = (phi[3 + k] + slow*part[k])/(1 + slow);
        }
    }
}
