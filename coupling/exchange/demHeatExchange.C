/*---------------------------------------------------------------------------*\
    demHeatExchange.C -- the exchange of heat between fluid and particles.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demHeatExchange.H"
#include "demCheck.H"
#include "demColumns.H"
#include "demFiles.H"
#include "demReaction.H"
#include "demRecord.H"
#include "demSelfCheck.H"

struct ::dem_scalar_exchange Foam::demHeatExchange::columns() const
{
    struct ::dem_scalar_exchange x;

    demCheck(dem_scalar_exchange(particles_.core(), temperature_, &x));
    return x;
}


// T* at the particles
const Foam::scalar* Foam::demHeatExchange::fluidTemperature() const
{
    return dem_scalar(particles_.core(), fluidTemperature_);
}


Foam::scalar Foam::demHeatExchange::particles() const
{
    scalar total;

    demCheck(dem_scalar_total(particles_.core(), temperature_, &total));
    return total;
}


Foam::scalar Foam::demHeatExchange::owed() const
{
    const struct ::dem_scalar_exchange x = columns();
    scalar sum = 0;

    for (size_t i = 0; i < x.n; i++)
    {
        sum += x.carried_over[i];
    }
    return returnReduce(sum, sumOp<scalar>());
}


// Error of the exchange, relative to the sum of the magnitudes of its terms J, R T* and R T'
Foam::scalar Foam::demHeatExchange::error
(
    const UList<scalar>& temperature,
    const UList<scalar>& target
)
{
    const struct ::dem_scalar_exchange x = columns();
    const scalar* const before = fluidTemperature();
    const scalarField& V = particles_.mesh().V();
    scalar toFluid = 0;
    scalar toParticles = 0;
    scalar moved = 0;

    forAll(V, celli)
    {
        toFluid +=
            particles_.window()*V[celli]
           *(source_[celli] - coefficient_[celli]*temperature[celli]);
    }
    forAll(target, i)
    {
        const scalar correction = x.response[i]*(target[i] - before[i]);

        toParticles += x.received[i] + correction;
        moved += mag(x.received[i]) + mag(correction) + x.response[i]*before[i];
    }

    reduce(toFluid, sumOp<scalar>());
    reduce(toParticles, sumOp<scalar>());
    reduce(moved, sumOp<scalar>());

    const scalar relative =
        mag(toFluid + transfer_.fraction()*toParticles)
       /(transfer_.fraction()*moved + VSMALL);
    maxError_ = max(maxError_, relative);
    return relative;
}


void Foam::demHeatExchange::gain(const std::string& name, const scalar heat)
{
    received_ += heat;
    if (budget_.on())
    {
        budget_.gain(demBudget::HEAT, name, heat);
    }
}


void Foam::demHeatExchange::countContacts()
{
    const ::dem_energy_item* item = nullptr;
    double since;
    int n = 0;

    demCheck(dem_energy(particles_.core(), &since, &n, &item));
    for (int k = 0; k < n; k++)
    {
        const std::string name(item[k].name);

        if (name == "heat_walls")
        {
            gain("walls", item[k].value - ofWalls_);
            ofWalls_ = item[k].value;
        }
        else if (name == "heat_dissipated")
        {
            gain("friction", item[k].value - ofFriction_);
            ofFriction_ = item[k].value;
        }
    }
}


Foam::demHeatExchange::demHeatExchange(demParticles& particles, demBudget& budget)
:
    particles_(particles),
    budget_(budget),
    transfer_(particles.transfer()),
    temperature_(dem_scalar_index(particles.core(), "temperature")),
    fluidTemperature_(dem_scalar_index(particles.core(), "fluidTemperature")),
    conductivity_(dem_scalar_index(particles.core(), "fluidConductivity")),
    heatCapacity_(dem_scalar_index(particles.core(), "fluidHeatCapacity")),
    T_(nullptr),
    kappa_(nullptr),
    Cp_(nullptr),
    source_
    (
        demFieldAt(particles.mesh(), "dem:heatSource"),
        particles.mesh(),
        dimensionedScalar(dimPower/dimVolume, Zero)
    ),
    coefficient_
    (
        demFieldAt(particles.mesh(), "dem:heatCoefficient"),
        particles.mesh(),
        dimensionedScalar(dimPower/dimVolume/dimTemperature, Zero)
    ),
    ofParticles_(this->particles() + owed()),
    received_(0),
    counted_(demRecord::energy(particles.dict().coupling())),
    ofWalls_(0),
    ofFriction_(0),
    maxError_(0)
{}


bool Foam::demHeatExchange::needed(const demParticles& particles)
{
    return dem_scalar_index(particles.core(), "fluidTemperature") >= 0;
}


Foam::string Foam::demHeatExchange::reason() const
{
    return
        string("The effects of constant/") + demDict::name()
      + " transfer heat between fluid and particles ("
      + dem_fluid_effect_names(particles_.core()) + ")";
}


void Foam::demHeatExchange::setFluid
(
    const volScalarField& T,
    const volScalarField& kappa,
    const volScalarField& Cp
)
{
    T_ = &T;
    kappa_ = &kappa;
    Cp_ = &Cp;
}


void Foam::demHeatExchange::countPassed()
{
    // Without reaction there is no balance
    if (!particles_.twoWay())
    {
        return;
    }

    const scalar before = ofParticles_;

    ofParticles_ = particles() + owed();
    gain("passed", ofParticles_ - before);
}


void Foam::demHeatExchange::toParticles()
{
    ::dem* const d = particles_.core();

    if (!T_)
    {
        FatalErrorInFunction
            << reason().c_str() << ", but the solver gives no temperature; leave the"
            << " effect out, or take demPimpleFoam, buoyantPimpleFoam or rhoPimpleFoam"
            << exit(FatalError);
    }
    toColumn(transfer_.sample(*T_)(), dem_scalar(d, fluidTemperature_));
    toColumn(particles_.sample(*kappa_)(), dem_scalar(d, conductivity_));
    toColumn(particles_.sample(*Cp_)(), dem_scalar(d, heatCapacity_));
}


void Foam::demHeatExchange::toFluid()
{
    if (!particles_.twoWay())
    {
        return;
    }

    const struct ::dem_scalar_exchange x = columns();
    const scalar* const before = fluidTemperature();
    const scalar T = particles_.window();
    scalarField source(x.n);
    scalarField coefficient(x.n);

    forAll(source, i)
    {
        source[i] = (x.response[i]*before[i] - x.received[i])/T;
        coefficient[i] = x.response[i]/T;
    }
    // C = R for all particles: frozen and heavy ones would conduct as well
    demReaction::deposit
    (
        transfer_, coefficient, coefficient, *T_, source,
        source_.primitiveFieldRef(), coefficient_.primitiveFieldRef()
    );
}


void Foam::demHeatExchange::correct
(
    const UList<scalar>& temperature,
    const scalar ofFluid,
    const UList<contribution>& received
)
{
    const scalarField target(transfer_.sample(temperature));

    const scalar off = error(temperature, target);

    Info<< "Suna: heat exchange error " << off << endl;
    demSelfCheck::heat(off);
    demCheck(dem_scalar_correct(particles_.core(), temperature_, target.cdata()));

    const scalar fluid = ofFluid/transfer_.fraction();
    const scalar inParticles = particles();
    const scalar toCome = owed();
    ofParticles_ = inParticles + toCome;

    for (const contribution& c : received)
    {
        gain(c.name, c.heat/transfer_.fraction());
    }
    if (counted_)
    {
        countContacts();
    }
    if (budget_.on())
    {
        budget_.state(demBudget::HEAT, "fluid", fluid);
        budget_.state(demBudget::HEAT, "particles", inParticles);
        budget_.state(demBudget::HEAT, "owed", toCome);
    }

    Info<< "Suna: heat fluid " << fluid << " particles " << inParticles
        << " owed " << toCome << " sum " << fluid + ofParticles_
        << " received " << received_ << " J" << endl;
}
