/*---------------------------------------------------------------------------*\
    demCloudExchange.C -- one exchange: fluid -> particles -> fluid.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demCheck.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static void toColumn(const UList<scalar>& values, double* column)
{
    forAll(values, i)
    {
        column[i] = values[i];
    }
}


static void toColumn(const UList<vector>& values, double* column)
{
    forAll(values, i)
    {
        for (direction d = 0; d < 3; d++)
        {
            column[3*i + d] = values[i][d];
        }
    }
}


static inline vector three(const double* column, const label i)
{
    return vector(column[3*i], column[3*i + 1], column[3*i + 2]);
}


// Volumes [m3]
static scalarField volumes(const struct ::dem_view& view)
{
    scalarField V(view.n);
    forAll(V, i)
    {
        const scalar r = *dem_at(view.radius, view.stride, i);
        V[i] = 4.0/3.0*constant::mathematical::pi*r*r*r;
    }
    return V;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// The core's columns, and every particle's cell. To be called whenever the
// core may have moved particles or handed them to other ranks.
void Foam::demCloud::look()
{
    dem_view(dem_, &view_);
    demCheck(dem_fluid(dem_, &fluid_));

    if (!fluid_.place)
    {
        place_.setSize(2*view_.n);
        place_ = -1;
    }

    transfer_.locate(view_, fluid_.place ? fluid_.place : place_.begin());
    setDiameter();
}


// The width of the kernel must not change while particles move: it would move
// volume. So the first particles set it, unless the user does.
void Foam::demCloud::setDiameter()
{
    if (diameter_ <= 0)
    {
        struct dem_tally now;
        demCheck(dem_tally(dem_, &now));

        if (now.particles > 0)
        {
            diameter_ = std::cbrt
            (
                6*now.volume/(constant::mathematical::pi*scalar(now.particles))
            );
        }
    }

    transfer_.setDiameter(diameter_);
}


void Foam::demCloud::tellParticles
(
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho,
    const volScalarField& mu
)
{
    if (!dem_needs_fluid(dem_))
    {
        return;
    }

    toColumn(transfer_.sample(U)(), fluid_.velocity);
    toColumn(transfer_.sample(gradP)(), fluid_.pressure_gradient);
    toColumn(transfer_.sample(voidFraction_)(), fluid_.void_fraction);
    toColumn(transfer_.sample(rho)(), fluid_.density);
    toColumn(transfer_.sample(mu)(), fluid_.viscosity);
}


void Foam::demCloud::depositVolume()
{
    const scalarField old(voidFraction_.primitiveField());

    volScalarField::Internal solid
    (
        IOobject("solid", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero)
    );
    transfer_.deposit(volumes(view_), solid);

    voidFraction_.primitiveFieldRef() = 1 - solid.field();
    voidFraction_.correctBoundaryConditions();

    if (twoWay_)
    {
        // From the void fractions, so that it agrees with their ddt
        dsdt_.primitiveFieldRef() =
            (old - voidFraction_.primitiveField())/mesh_.time().deltaTValue();
    }
}


void Foam::demCloud::depositReaction()
{
    if (!twoWay_ || !dem_needs_fluid(dem_))
    {
        return;
    }

    scalarField response(view_.n);
    vectorField reaction(view_.n);

    forAll(response, i)
    {
        response[i] = fluid_.response[i]/window_;
        reaction[i] =
            response[i]*three(fluid_.velocity, i)
          - three(fluid_.drag_impulse, i)/window_;
    }

    transfer_.deposit(response, drag_.ref());
    transfer_.deposit(reaction, force_.ref());
    drag_.correctBoundaryConditions();
    force_.correctBoundaryConditions();
}


void Foam::demCloud::settle
(
    const volVectorField& U,
    const UList<vector>& velocity,
    const double* gradient
)
{
    Info<< "Suna: exchange error "
        << ledger_.exchange(window_, force_, drag_, U, fluid_, velocity)
        << endl;

    demCheck
    (
        dem_fluid_correct
        (
            dem_,
            reinterpret_cast<const double*>(velocity.cdata()),
            gradient
        )
    );
    ledger_.charge(demLedger::EXCHANGE);
}


void Foam::demCloud::report()
{
    struct dem_tally now;
    demCheck(dem_tally(dem_, &now));

    const scalarField& e = voidFraction_;
    label dense = 0;
    forAll(e, celli)
    {
        dense += e[celli] < leastVoidFraction_;
    }
    reduce(dense, sumOp<label>());

    Info<< "Suna: " << now.particles << " particles, "
        << now.steps - before_.steps << " DEM steps, void fraction at least "
        << gMin(e) << ", overlap at most " << now.largest_overlap << endl;

    if (dense)
    {
        Info<< "Suna: void fraction below " << leastVoidFraction_ << " in "
            << dense << " cells: particles are too soft, or cells too small"
            << " for the kernel's width" << endl;
    }

    before_ = now;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demCloud::evolve
(
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho,
    const volScalarField& mu
)
{
    ledger_.charge(demLedger::FLUID);
    window_ = mesh_.time().deltaTValue();

    tellParticles(U, gradP, rho, mu);
    ledger_.charge(demLedger::EXCHANGE);

    demCheck(dem_advance(dem_, window_));
    ledger_.charge(demLedger::PARTICLES);

    look();
    depositVolume();
    depositReaction();
    report();
    ledger_.charge(demLedger::EXCHANGE);
}


void Foam::demCloud::correct
(
    const volVectorField& U,
    const volVectorField& gradP
)
{
    if (!twoWay_ || !dem_needs_fluid(dem_))
    {
        return;
    }

    ledger_.charge(demLedger::FLUID);

    const vectorField gradient(transfer_.sample(gradP));
    settle
    (
        U,
        transfer_.sample(U)(),
        reinterpret_cast<const double*>(gradient.cdata())
    );
}


void Foam::demCloud::correct(const volVectorField& U)
{
    if (!twoWay_ || !dem_needs_fluid(dem_))
    {
        return;
    }

    ledger_.charge(demLedger::FLUID);
    settle(U, transfer_.sample(U)(), fluid_.pressure_gradient);
}


Foam::tmp<Foam::volVectorField> Foam::demCloud::pressureReaction() const
{
    tmp<volVectorField> treaction
    (
        new volVectorField("dem:pressureReaction", 0*force_)
    );

    if (twoWay_ && dem_needs_fluid(dem_) && dict_.acts("pressureGradient"))
    {
        const scalarField V(volumes(view_));
        vectorField force(view_.n);

        forAll(force, i)
        {
            force[i] =
                V[i]
               *(
                    three(fluid_.pressure_gradient, i)
                  - fluid_.density[i]*gravity()
                );
        }

        transfer_.deposit(force, treaction.ref().ref());
        treaction.ref().correctBoundaryConditions();
    }

    return treaction;
}

// ************************************************************************* //
