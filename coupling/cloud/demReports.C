/*---------------------------------------------------------------------------*\
    demReports.C -- log, tables and files of a run with particles.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demReports.H"
#include "dem_plan.h"
#include "demCheck.H"
#include "demInteger.H"
#include "OSspecific.H"

void Foam::demReports::reportStep(const struct ::dem_totals& before)
{
    const struct dem_totals& now = particles_.totals();
    const scalarField& e = volume_.voidFraction();
    const demOverpackingLimiter& limiter = particles_.transfer().limiter();

    Info<< "Suna: " << demInteger(now.particles).c_str() << " particles, "
        << demInteger(now.steps - before.steps).c_str() << " DEM steps, void fraction at least "
        << gMin(e) << ", overlap at most " << now.largest_overlap
        << " diameters, volume error " << volume_.volumeError() << endl;

    if (limiter.nOverfull())
    {
        Info<< "Suna: void fraction below " << particles_.transfer().minVoidFraction()
            << " in " << limiter.nOverfull() << " cells; solid was moved to their"
            << " neighbours, " << limiter.nFull() << " cells are at this limit now,"
            << " minimum " << gMin(e) << "; particles are too soft, or cells too"
            << " small for the kernel's width" << endl;
    }
}


// A line for each stage that has begun since the last call
void Foam::demReports::reportStages()
{
    const char* name = nullptr;
    const char* why = nullptr;
    double begin = 0;

    while
    (
        (name = dem_run_stage(particles_.core(), stages_, &begin, &why))
     && begin <= particles_.totals().time
    )
    {
        Info<< "Suna: stage " << name << " begins at " << begin + particles_.offset() << " s"
            << (why[0] ? ": " : "") << why << endl;
        stages_++;
    }
}


// Contacts that are too soft for the speeds and weights of this run
void Foam::demReports::reportImpacts() const
{
    const char* text = nullptr;

    demCheck
    (
        dem_impact_warning(particles_.core(), particles_.totals().largest_overlap, &text)
    );
    if (text[0])
    {
        Info<< "Suna: " << text << endl;
    }
}


void Foam::demReports::writeMeans() const
{
    ::dem* d = particles_.core();
    const Time& time = particles_.mesh().time();

    if (!dem_averages_count(d))
    {
        return;
    }
    if (Pstream::master())
    {
        demTable::recordEffects(time, d);
    }
    demCheck(dem_averages(d, demTable::folder(time).c_str()));
}


Foam::demReports::demReports(demParticles& particles, const demVoidFraction& volume)
:
    particles_(particles),
    volume_(volume),
    record_(particles.mesh().time(), particles.dict().coupling()),
    fields_(particles.mesh(), particles.dict().coupling()),
    flowTable_(particles.mesh().time(), particles.dict().coupling()),
    losses_(particles.mesh()),
    bonds_(particles.mesh().time()),
    wearWritten_(false),
    progress_(particles.mesh().time()),
    edits_(particles.mesh().time(), particles.dict().file()),
    stages_(0)
{}


void Foam::demReports::begin()
{
    record_.watch(particles_.core());
    progress_.watch(particles_.core());
    flowTable_.begin(particles_.core(), particles_.time());
    fields_.note(particles_.heading());

    for (int wall = 0; wall < dem_wall_count(particles_.core()); wall++)
    {
        struct dem_wall_position place;
        dem_wall_position(particles_.core(), wall, &place);
        if (place.axes > 0)
        {
            Info<< "Suna: wall " << dem_wall_name(particles_.core(), wall) << " is moved by force;"
                << " the fluid does not feel it and exerts no force on it" << endl;
        }
    }
}


void Foam::demReports::endStep()
{
    const struct dem_totals before(particles_.totals());

    particles_.readTotals();
    reportStep(before);
    reportStages();
    progress_.end(particles_.totals().steps - before.steps);
    edits_.report();
    reportImpacts();
    flowTable_.endStep(particles_.core(), particles_.time());
    reportLosses();
}


void Foam::demReports::reportLosses()
{
    losses_.report(particles_.core(), particles_.offset());
    bonds_.report(particles_.core(), particles_.offset());
}


void Foam::demReports::writeWear()
{
    ::dem* d = particles_.core();

    if (!dem_walls_wear(d))
    {
        return;
    }

    const Time& time = particles_.mesh().time();
    fileName folder(demTable::folder(time));
    demBroadcast(folder);

    if (Pstream::master())
    {
        mkDir(folder);
        if (!wearWritten_ && isFile(folder/"walls.pvd", false))
        {
            rm(folder/"walls.pvd");     // of a run that began at the same time
        }
    }
    wearWritten_ = true;

    const fileName file("walls_" + time.timeName() + ".vtp");
    demCheck(dem_walls_draw(d, folder.c_str(), file.c_str(), time.value()));
}


void Foam::demReports::write()
{
    bonds_.writeVtk(particles_.core());
    writeWear();
    flowTable_.write(particles_.core(), particles_.time());
    writeMeans();
}
