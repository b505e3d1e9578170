/*---------------------------------------------------------------------------*\
    demRecord.C -- record of particles, walls and energy at short intervals.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRecord.H"
#include "demCheck.H"
#include "demColumns.H"
#include "demInteger.H"
#include "OSspecific.H"
#include <cstdint>

namespace Foam
{

// Numbers per particle: 0 id, 1 position, 4 velocity, 7 diameter
enum { RECORD_NUMBERS = 8 };

// The file holds ids in 32 bits
static scalarList pack(const demView& v)
{
    scalarList all(RECORD_NUMBERS*label(v.n));
    label to = 0;

    for (size_t i = 0; i < v.n; i++)
    {
        const double* x = dem_at(v.position, v.stride, i);
        const double* u = dem_at(v.velocity, v.stride, i);

        all[to++] = scalar(idOf(v, label(i)));
        for (int k = 0; k < 3; k++) all[to++] = x[k];
        for (int k = 0; k < 3; k++) all[to++] = u[k];
        all[to++] = 2*(*dem_at(v.radius, v.stride, i));
    }
    return all;
}


template<class Type>
static void put(std::ofstream& os, const Type value)
{
    os.write(reinterpret_cast<const char*>(&value), sizeof(value));
}

} // End namespace Foam


// At the first step, so that a run without steps leaves no empty files
void Foam::demRecord::begin(const ::dem* d)
{
    interval_.begin(time_.value() - time_.deltaTValue());

    if (!Pstream::master())
    {
        return;
    }

    const fileName folder(demTable::folder(time_));
    mkDir(folder);
    particles_.open((folder/"particles.bin").c_str(), std::ios::binary);
    if (!particles_)
    {
        FatalErrorInFunction
            << "Cannot write " << folder/"particles.bin" << "; take out"
            << " coupling/record, or free disk space" << exit(FatalError);
    }

    walls_.begin(d);
}


void Foam::demRecord::writeParticles(const demView& view)
{
    const int64_t largest = largestId(view);
    if (largest > INT32_MAX)
    {
        FatalErrorInFunction
            << "Particle id " << demInteger(largest).c_str()
            << " does not fit into particles.bin, which"
            << " holds ids up to " << INT32_MAX << "; give smaller ids in"
            << " insert of constant/demProperties, or take out coupling/record"
            << exit(FatalError);
    }

    List<scalarList> parts(Pstream::nProcs());
    parts[Pstream::myProcNo()] = pack(view);
    Pstream::gatherList(parts);

    if (!Pstream::master())
    {
        return;
    }

    int64_t n = 0;
    forAll(parts, rank)
    {
        n += parts[rank].size()/RECORD_NUMBERS;
    }
    put<double>(particles_, time_.value());
    put<int64_t>(particles_, n);

    forAll(parts, rank)
    {
        const scalarList& part = parts[rank];

        forAll(part, i)
        {
            if (i % RECORD_NUMBERS == 0)
            {
                put<int32_t>(particles_, int32_t(part[i]));
            }
            else
            {
                put<float>(particles_, float(part[i]));
            }
        }
    }
    particles_.flush();
}


void Foam::demRecord::writeWalls(::dem* d)
{
    demCheck(dem_table_add_walls(walls_.rows(d), d, time_.value(), elapsed_));
    elapsed_ = 0;
}


void Foam::demRecord::writeEnergy(::dem* d)
{
    const ::dem_energy_item* item = nullptr;
    double since = 0;
    int n = 0;
    demCheck(dem_energy(d, &since, &n, &item));

    if (Pstream::master())
    {
        demCheck
        (
            dem_table_add_energy(energies_.rows(d), d, time_.value(), since, n, item)
        );
    }
}


Foam::demRecord::demRecord(const Time& time, const dictionary& coupling)
:
    time_(time),
    interval_(0),
    elapsed_(0),
    walls_(time, "walls.csv"),
    energy_(energy(coupling)),
    energies_(time, "energy.csv")
{
    if (coupling.found("record"))
    {
        const dictionary& record = coupling.subDict("record");
        demCheckEntries(record, "coupling/record", wordList({"interval", "energy", "budget"}));

        const scalar interval = record.get<scalar>("interval");

        if (interval < SMALL)
        {
            FatalIOErrorInFunction(record)
                << "coupling/record/interval " << interval << " s; give a time above 0, or"
                << " take out record" << exit(FatalIOError);
        }
        interval_ = demInterval(interval);
    }
}


bool Foam::demRecord::energy(const dictionary& coupling)
{
    return coupling.subOrEmptyDict("record").getOrDefault<Switch>("energy", false);
}


void Foam::demRecord::prepare(::dem_case* c)
{
    if (energy_)
    {
        demCheck(dem_case_enable_energy(c));
    }
}


void Foam::demRecord::watch(::dem* d)
{
    if (interval_.on())
    {
        demCheck(dem_wall_impulse_reset(d));
        elapsed_ = 0;
    }
}


void Foam::demRecord::add(::dem* d, const demView& view, const scalar elapsed)
{
    if (!interval_.on())
    {
        return;
    }
    if (!interval_.begun())
    {
        begin(d);
    }

    elapsed_ += elapsed;

    if (interval_.pass(time_.value()))
    {
        writeParticles(view);
        writeWalls(d);
        if (energy_)
        {
            writeEnergy(d);
        }
    }
}
