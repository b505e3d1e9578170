/*---------------------------------------------------------------------------*\
    demParticleBudget.C -- the budget of the particles and of the exchange.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demParticleBudget.H"
#include "demCheck.H"
#include "demColumns.H"
#include "demFluid.H"
#include "demRecord.H"

// Impulse of the particles on all walls since the record reset it [N s]
Foam::vector Foam::demParticleBudget::wallImpulse() const
{
    ::dem* d = particles_.core();
    vector sum(Zero);

    for (int wall = 0; wall < dem_wall_count(d); wall++)
    {
        double impulse[3], twist[3];
        demCheck(dem_wall_impulse(d, wall, impulse, twist));
        sum += vector(impulse[0], impulse[1], impulse[2]);
    }
    return sum;
}


// Work of moving walls on the particles since the start of the run [J], counted by the
// energy balance of the core
Foam::scalar Foam::demParticleBudget::wallWork() const
{
    const ::dem_energy_item* item = nullptr;
    double since;
    int n = 0;

    demCheck(dem_energy(particles_.core(), &since, &n, &item));
    for (int k = 0; k < n; k++)
    {
        if (std::string(item[k].name) == "work_walls")
        {
            return item[k].value;
        }
    }
    return 0;
}


Foam::demParticleBudget::demParticleBudget
(
    demParticles& particles,
    const demExchange& exchange
)
:
    particles_(particles),
    exchange_(exchange),
    view_(particles.view()),
    fluid_(particles.fluid()),
    budget_(particles.mesh().time(), particles.dict().coupling()),
    toFluid_(Zero),
    onWalls_(Zero),
    countsWork_(demRecord::energy(particles.dict().coupling())),
    workOfWalls_(0),
    before_{0, Zero, 0}
{}


void Foam::demParticleBudget::begin(const bool volumeAveraged)
{
    budget_.watch(particles_.core());
    if (!budget_.on())
    {
        return;
    }

    string reason;

    if (!volumeAveraged)
    {
        reason =
            "the equations of this solver have no void fraction; take it out, or take"
            " demPimpleFoam or demInterFoam. The log has the momentum of fluid and particles in each"
            " step, and the heat where it is exchanged";
    }
    else if (!particles_.twoWay())
    {
        reason =
            "twoWay is no, so the fluid receives nothing from the particles; take it"
            " out, or give twoWay yes";
    }
    else if (!particles_.needsFluid())
    {
        reason =
            "no effect of the fluid is in effects, so nothing is exchanged; take it out,"
            " or add a drag law, for example gidaspow {}";
    }

    if (!reason.empty())
    {
        FatalIOErrorInFunction(particles_.dict().coupling())
            << "coupling/record/budget is yes, but " << reason.c_str()
            << exit(FatalIOError);
    }
}


// Potential energy of the free particles in weight less buoyancy, in fluid of this density at
// each particle. Along periods gravity has no height
Foam::scalar Foam::demParticleBudget::height(const UList<scalar>& density) const
{
    const vector& g = particles_.gravity();
    const vector upright(g - demFluid::alongPeriods(particles_.mesh(), g));
    const scalarField V(volumes(view_));
    scalar sum = 0;

    forAll(V, i)
    {
        if (!isFrozen(view_, i))
        {
            const scalar displaced = particles_.react() ? density[i]*V[i] : 0;
            const scalar m = *dem_at(view_.mass, view_.stride, i);
            sum -= (m - displaced)*(upright & position(view_, i));
        }
    }
    return returnReduce(sum, sumOp<scalar>());
}


// Sums over all particles, momentum with the impulses owed to them
Foam::demParticleBudget::sums Foam::demParticleBudget::sumParticles(const demFlow& flow) const
{
    struct ::dem_totals now;
    demCheck(dem_totals(particles_.core(), &now));

    sums s{0, Zero, now.kinetic + height(particles_.sample(flow.rho)())};

    if (particles_.react())
    {
        s.momentum =
            demMomentumBalance::owed(fluid_)
          + exchange_.owedPressureImpulse(exchange_.pressureImpulse(flow.gradP));
    }
    vector own(Zero);

    for (size_t i = 0; i < view_.n; i++)
    {
        const scalar m = *dem_at(view_.mass, view_.stride, i);
        s.mass += m;
        own += m*velocity(view_, i);
    }
    reduce(s.mass, sumOp<scalar>());
    reduce(own, sumOp<vector>());
    s.momentum += own;
    return s;
}


bool Foam::demParticleBudget::countsPassed() const
{
    const demInletsOutlets& passages = particles_.inletsOutlets();

    return budget_.on() && (passages.active() || passages.insideMesh());
}


void Foam::demParticleBudget::beforePassing(const demFlow& flow)
{
    if (countsPassed())
    {
        before_ = sumParticles(flow);
    }
}


void Foam::demParticleBudget::countPassed(const demFlow& flow)
{
    if (countsPassed())
    {
        const sums now(sumParticles(flow));

        budget_.gain(demBudget::MASS, "passed", now.mass - before_.mass);
        budget_.gain("passed", now.momentum - before_.momentum);
        budget_.gain(demBudget::ENERGY, "passed", now.energy - before_.energy);
    }
}


void Foam::demParticleBudget::addParticles()
{
    if (!budget_.on())
    {
        return;
    }

    const vector& g = particles_.gravity();
    const scalar T = particles_.window();
    const scalarField V(volumes(view_));
    const UList<scalar> fluidDensity(fluid_.density, label(view_.n));
    vector weight(Zero);
    vector held(Zero);

    forAll(V, i)
    {
        const scalar m = *dem_at(view_.mass, view_.stride, i);
        const scalar displacedMass = particles_.react() ? fluid_.density[i]*V[i] : 0;

        if (isFrozen(view_, i))
        {
            if (particles_.react())
            {
                held +=
                    impulse(fluid_, i) + vectorAt(fluid_.carried_over_impulse, i)
                  - T*(V[i]*vectorAt(fluid_.pressure_gradient, i) - displacedMass*g);
            }
        }
        else
        {
            weight += T*(m - displacedMass)*g;
        }
    }

    if (exchange_.capillary() && particles_.react())
    {
        vector pull(exchange_.capillary()->onParticles());
        held += T*exchange_.capillary()->onFrozen();
        reduce(pull, sumOp<vector>());
        budget_.gain("particleTension", T*pull);
    }
    reduce(weight, sumOp<vector>());
    reduce(held, sumOp<vector>());

    budget_.gain("weight", weight);
    budget_.gain("held", -held);
    budget_.gain("walls", onWalls_ - wallImpulse());
    if (countsWork_)
    {
        const scalar before = workOfWalls_;
        workOfWalls_ = wallWork();
        budget_.gain(demBudget::ENERGY, "walls", workOfWalls_ - before);
    }
    budget_.state(demBudget::MASS, "particles", particles_.totals().mass);
    budget_.state(demBudget::ENERGY, "particles", particles_.totals().kinetic);
    budget_.state(demBudget::ENERGY, "height", height(fluidDensity));
}


void Foam::demParticleBudget::readWalls()
{
    if (budget_.on())
    {
        onWalls_ = wallImpulse();
    }
}


void Foam::demParticleBudget::addExchange
(
    const volVectorField& U,
    const volVectorField& onFluid
)
{
    if (!budget_.on())
    {
        return;
    }

    const scalar T = particles_.window();
    const scalarField& V = particles_.mesh().V();
    const vectorField& f = onFluid;
    const vectorField& u = U;
    scalar work = 0;

    for (size_t i = 0; i < view_.n; i++)
    {
        work += impulse(fluid_, i) & velocity(view_, i);
    }

    toFluid_ = T*gSum((V*f)());
    budget_.gain
    (
        demBudget::ENERGY,
        "drag",
        T*gSum((V*(f & u))()) + returnReduce(work, sumOp<scalar>())
    );

    if (exchange_.scheme().set() == demCouplingScheme::I)
    {
        const vectorField p(exchange_.pressureReaction());
        toFluid_ += T*gSum((V*p)());
    }
}


void Foam::demParticleBudget::setMomentum
(
    const vector& fluid,
    const vector& particles,
    const vector& owed
)
{
    if (budget_.on())
    {
        budget_.state("fluid", fluid);
        budget_.state("particles", particles);
        budget_.state("owed", owed);
    }
}
