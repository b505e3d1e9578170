/*---------------------------------------------------------------------------*\
    demCloud.C -- particles coupled with the fluid of a mesh: the order of a step.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demCheck.H"
#include "demColumns.H"
#include "StringStream.H"

// The particles' part of evolve()
void Foam::demCloud::advance(const demFlow& flow)
{
    exchange_.setDensity(flow.rho);
    budget_.beforePassing(flow);
    volume_.passInletsOutlets(flow.U);
    budget_.countPassed(flow);
    if (heat_.valid())
    {
        heat_().countPassed();
    }

    // Else in correct()
    if (!volumeAveraged_ && (!particles_.twoWay() || particles_.interval() > 0))
    {
        exchange_.updateAcceleration(flow.U);
    }

    // With the weights of the mesh at which the particles were located
    exchange_.toParticles(flow);
    if (heat_.valid())
    {
        heat_().toParticles();
    }
    profile_.end(demProfile::SAMPLE);

    reports_.beginStep();
    particles_.advance();
    profile_.end(demProfile::PARTICLES);

    particles_.locate();
    volume_.deposit();
    exchange_.toFluid(flow);
    if (heat_.valid())
    {
        heat_().toFluid();
    }
    profile_.end(demProfile::DEPOSIT);
}


// False if fluid and particles exert no forces on each other
bool Foam::demCloud::correctParticles
(
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho
)
{
    exchange_.updateAcceleration(U);

    if (!particles_.react())
    {
        return false;
    }
    profile_.end(demProfile::FLUID);

    const volVectorField onFluid(exchange_.onFluid(U, gradP));
    budget_.addExchange(U, onFluid);
    attempt([&] { exchange_.correct(U, gradP, rho, onFluid); });
    return true;
}


void Foam::demCloud::reportMomentum(const vector& ofMesh, const vector& moreOwed)
{
    particles_.refresh();

    // As evolve() left it: the correction acts in the next step
    const double* now = particles_.totals().momentum;
    const vector fluid(particles_.transfer().toFullCircle() & ofMesh);
    const vector particles(now[0], now[1], now[2]);
    const vector owed(demMomentumBalance::owed(particles_.fluid()) + moreOwed);

    Info<< "Suna: momentum fluid " << fluid << " particles " << particles
        << " owed " << owed << " sum " << fluid + particles + owed << " N s" << endl;

    budget_.setMomentum(fluid, particles, owed);
    profile_.end(demProfile::CORRECT);
}


Foam::string Foam::demCloud::divergence() const
{
    const scalar limit = 100;
    const volVectorField* U = mesh_.findObject<volVectorField>("U");

    if (!U || particles_.interval() > 0)
    {
        return string::null;
    }
    const scalarField crossed
    (
        mag(U->primitiveField())*mesh_.time().deltaTValue()/cbrt(mesh_.V().field())
    );
    label celli = -1;
    scalar most = limit;

    // The first value that is not a number is the most, too
    for (label i = 0; i < crossed.size() && most == most; ++i)
    {
        if (!(crossed[i] <= most))
        {
            celli = i;
            most = crossed[i];
        }
    }
    // Of the first rank with such a cell
    const bool mine =
        returnReduce(celli < 0 ? labelMax : UPstream::myProcNo(), minOp<label>())
     == UPstream::myProcNo();

    if (!returnReduce(mine, orOp<bool>()))
    {
        return string::null;
    }
    const scalar speed = returnReduce(mine ? mag((*U)[celli]) : 0, sumOp<scalar>());
    const vector at = returnReduce(mine ? mesh_.C()[celli] : vector(Zero), sumOp<vector>());
    const scalar cells = returnReduce(mine ? most : 0, sumOp<scalar>());
    OStringStream os;

    os  << "; the fluid has diverged, with " << speed << " m/s at (" << at.x() << ' ' << at.y()
        << ' ' << at.z() << ") m, " << cells << " cells in a time step: look at its schemes,"
        << " boundary conditions and mesh there, and go on from an earlier time";
    return os.str();
}


void Foam::demCloud::fail(const string& sentence)
{
    string also;

    // Otherwise ranks have failed at different places and must not communicate
    if (dem_ranks_agree(particles_.core()))
    {
        reports_.reportLosses();
        also = divergence();
        if (also.empty())
        {
            also = lastGood_.save([this] { write(); });
        }
    }

    FatalErrorInFunction << sentence.c_str() << also.c_str() << exit(FatalError);
}


void Foam::demCloud::attempt(const std::function<void()>& part)
{
    try
    {
        part();
    }
    catch (const demFailure& failure)
    {
        fail(failure.what());
    }
}


Foam::demCloud::demCloud(const fvMesh& mesh, const bool volumeAveraged)
:
    mesh_(mesh),
    volumeAveraged_(volumeAveraged),
    particles_(mesh, volumeAveraged),
    volume_(particles_),
    exchange_(particles_, volume_, volumeAveraged),
    budget_(particles_, exchange_),
    reports_(particles_, volume_),
    lastGood_(particles_, volumeAveraged),
    plan_(particles_, volume_)
{
    reports_.prepare();
    exchange_.prepare();
    particles_.setUp();
    exchange_.begin();
    if (demHeatExchange::needed(particles_))
    {
        heat_.reset(new demHeatExchange(particles_, budget_.table()));
    }
    reports_.begin();
    budget_.begin(volumeAveraged);
    particles_.reportStep();

    volume_.note(particles_.heading());
    exchange_.note(particles_.heading());
    attempt([this]
    {
        particles_.locateInserted();
        volume_.begin();
    });
    reports_.updateFields();
    profile_.end(demProfile::START);
}


Foam::demCloud::~demCloud()
{
    if (!profile_.stepped())
    {
        return;                 // no step: a plan, for example
    }
    const char* text = nullptr;

    profile_.end(demProfile::FLUID);
    Info<< "Suna: time spent on fluid " << profile_.fluid()
        << " s, particles " << profile_.spent(demProfile::PARTICLES)
        << " s, exchange " << profile_.exchange()
        << " s; largest exchange error " << exchange_.balance().maxError() << nl << endl;
    if (!dem_profile_text(particles_.core(), &text))
    {
        Info<< text << endl;
    }
    profile_.report();
}


void Foam::demCloud::evolve(const demFlow& flow)
{
    profile_.end(demProfile::FLUID);
    profile_.countStep();
    particles_.beginStep();
    lastGood_.backup();

    attempt([&] { advance(flow); });

    reports_.endStep();
    particles_.refresh();
    budget_.addParticles();
    reports_.record();
    budget_.readWalls();
    reports_.updateFields();
    profile_.end(demProfile::OUTPUT);
}


void Foam::demCloud::correct
(
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho,
    const vector& momentum
)
{
    if (correctParticles(U, gradP, rho))
    {
        const vector impulse(exchange_.pressureImpulse(gradP));
        budget_.addPressureImpulse(impulse);
        reportMomentum(momentum, exchange_.owedPressureImpulse(impulse));
    }
}


void Foam::demCloud::correct(const volVectorField& U, const volScalarField& rho)
{
    if (correctParticles(U, exchange_.pressureGradient(), rho))
    {
        const vectorField& u = U;
        const scalarField& density = rho;
        reportMomentum(gSum((mesh_.V().field()*density*u)()), vector::zero);
    }
}


void Foam::demCloud::correctHeat
(
    const UList<scalar>& temperature,
    const scalar ofFluid,
    const UList<demHeatExchange::contribution>& received
)
{
    attempt([&] { heat_().correct(temperature, ofFluid, received); });
}


void Foam::demCloud::plan(const demFlow& flow, const demPlan::step& ahead)
{
    exchange_.toParticles(flow);
    if (heat_.valid())
    {
        heat_().toParticles();
    }
    plan_.report(flow, ahead);
}


Foam::scalar Foam::demCloud::courant()
{
    particles_.refresh();
    const struct ::dem_view& view = particles_.view();
    scalar fastest = 0;

    for (size_t i = 0; i < view.n; i++)
    {
        fastest = max(fastest, mag(velocity(view, i)));
    }

    return
        returnReduce(fastest, maxOp<scalar>())*mesh_.time().deltaTValue()
       /particles_.transfer().length();
}


void Foam::demCloud::write()
{
    profile_.end(demProfile::FLUID);

    dictionary numbers;
    numbers.add("changeRate", volume_.changeRate());
    numbers.add("relaxationRate", exchange_.relaxationRate());
    particles_.write(numbers);

    volume_.voidFraction().write();
    exchange_.write();
    reports_.write();
    profile_.end(demProfile::OUTPUT);
}
