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

// The core's columns: its pointers hold until its next collective call
void Foam::demCloud::refresh()
{
    dem_view(dem_, &view_);
    demCheck(dem_fluid(dem_, &fluid_));
}


// Every particle's cell. To be called whenever the core may have moved
// particles or handed them to other ranks.
void Foam::demCloud::look()
{
    refresh();

    if (!fluid_.place)
    {
        place_.setSize(2*view_.n);
        place_ = -1;
    }

    transfer_.locate(view_, fluid_.place ? fluid_.place : place_.begin());
    setDiameter();
    refresh();
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


// At the particles; what is uniform needs no transfer
Foam::tmp<Foam::scalarField> Foam::demCloud::values
(
    const volScalarField& field
) const
{
    const scalar most = gMax(field.primitiveField());

    if (most > gMin(field.primitiveField()))
    {
        return transfer_.sample(field);
    }
    return tmp<scalarField>(new scalarField(view_.n, most));
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
    toColumn(values(rho)(), fluid_.density);
    toColumn(values(mu)(), fluid_.viscosity);

    for (size_t i = 0; i < fluid_.n; i++)
    {
        const scalar e = max(fluid_.void_fraction[i], 0.1);
        fluid_.counterflow[i] = makesRoom_ ? 1/(e*e) : 1;
    }
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
    if (!reacts())
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

    if (makesRoom_ && dict_.acts("pressureGradient"))
    {
        scalarField yields(volumes(view_));
        forAll(yields, i)
        {
            yields[i] *= fluid_.passed[i];
        }

        transfer_.deposit(yields, yielding_.ref());
        yielding_.correctBoundaryConditions();
    }
}


bool Foam::demCloud::reacts() const
{
    return twoWay_ && dem_needs_fluid(dem_);
}


// `change` of the pressure gradient since evolve, on the mesh: so the fluid
// and the particles answer to one and the same field
void Foam::demCloud::settle
(
    const volVectorField& U,
    const volVectorField& change
)
{
    const vectorField velocity(transfer_.sample(U));
    vectorField gradient(transfer_.sample(change));

    Info<< "Suna: exchange error "
        << ledger_.exchange
           (
               window_,
               force_ - drag_*U - yielding_*change,
               fluid_,
               velocity,
               makesRoom_ ? volumes(view_)*gradient : 0*gradient
           )
        << endl;

    forAll(gradient, i)
    {
        gradient[i] += three(fluid_.pressure_gradient, i);
    }

    refresh();
    demCheck
    (
        dem_fluid_correct
        (
            dem_,
            reinterpret_cast<const double*>(velocity.cdata()),
            reinterpret_cast<const double*>(gradient.cdata())
        )
    );
    ledger_.charge(demLedger::EXCHANGE);
}


void Foam::demCloud::report()
{
    struct dem_tally now;
    demCheck(dem_tally(dem_, &now));

    const scalarField& e = voidFraction_;
    const label crowded = transfer_.crowded(e);
    const scalar solid = gSum(mesh_.V().field()*(1 - e));

    Info<< "Suna: " << now.particles << " particles, "
        << now.steps - before_.steps << " DEM steps, void fraction at least "
        << gMin(e) << ", overlap at most " << now.largest_overlap
        << ", volume error " << mag(solid - now.volume)/(now.volume + VSMALL)
        << endl;

    if (crowded)
    {
        Info<< "Suna: void fraction below " << transfer_.minVoidFraction()
            << " in " << crowded << " cells: particles are too soft, or cells"
            << " too small for the kernel's width" << endl;
    }

    before_ = now;
}


// The pressure gradient has moved the fluid in this step and will move the
// particles in the next: their share of it is owed to them, too.
void Foam::demCloud::reportMomentum
(
    const volVectorField& U,
    const volVectorField& gradP
)
{
    struct dem_tally now;
    demCheck(dem_tally(dem_, &now));

    const vectorField& u = U;
    const vector fluid
    (
        density()*gSum(mesh_.V().field()*voidFraction_.primitiveField()*u)
    );
    refresh();
    const vector particles(now.momentum[0], now.momentum[1], now.momentum[2]);
    vector owed(demLedger::owed(fluid_));

    if (dict_.acts("pressureGradient"))
    {
        const vectorField dynamic
        (
            transfer_.sample(gradP)() - density()*gravity()
        );
        owed -= window_*gSum((volumes(view_)*dynamic)());
    }

    Info<< "Suna: momentum fluid " << fluid << " particles " << particles
        << " owed " << owed << " sum " << fluid + particles + owed << endl;
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
    gradP_ = gradP;
    ledger_.charge(demLedger::EXCHANGE);

    demCheck(dem_advance(dem_, window_));
    ledger_.charge(demLedger::PARTICLES);

    look();
    depositVolume();
    depositReaction();
    report();
    refresh();
    record_.add(dem_, view_);
    ledger_.charge(demLedger::EXCHANGE);
}


void Foam::demCloud::correct
(
    const volVectorField& U,
    const volVectorField& gradP
)
{
    if (reacts())
    {
        ledger_.charge(demLedger::FLUID);
        settle(U, (gradP - gradP_)());
        reportMomentum(U, gradP);
    }
}


void Foam::demCloud::correct(const volVectorField& U)
{
    if (reacts())
    {
        ledger_.charge(demLedger::FLUID);
        settle(U, (0*gradP_)());
    }
}


Foam::tmp<Foam::volVectorField> Foam::demCloud::pressureReaction() const
{
    tmp<volVectorField> treaction
    (
        new volVectorField("dem:pressureReaction", 0*force_)
    );

    if (reacts() && dict_.acts("pressureGradient"))
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
