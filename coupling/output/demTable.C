/*---------------------------------------------------------------------------*\
    demTable.C -- CSV table of a run.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demTable.H"
#include "demCheck.H"
#include "OSspecific.H"

Foam::demTable::demTable(const Time& time, const word& name)
:
    time_(time),
    begun_(false)
{
    if (folder(time).size() + name.size() + 2 > sizeof(table_.folder))
    {
        FatalErrorInFunction
            << "The path of " << folder(time)/name << " is longer than "
            << sizeof(table_.folder) << " characters; move the case to a shorter one"
            << exit(FatalError);
    }
    dem_table_name(&table_, folder(time).c_str(), name.c_str(), time.startTime().value());
}


Foam::fileName Foam::demTable::folder(const Time& time)
{
    return
        time.globalPath()/"postProcessing"/"dem"
       /Time::timeName(time.startTime().value());
}


void Foam::demTable::recordEffects(const Time& time, const ::dem* d)
{
    const fileName to(folder(time));

    mkDir(to);
    demCheck(dem_effects_record(d, to.c_str(), time.startTime().value()));
}


Foam::string Foam::demTable::name() const
{
    return time_.relativePath(fileName(table_.path));
}


void Foam::demTable::begin(const ::dem* d)
{
    if (!begun_ && Pstream::master())
    {
        demCheck(dem_table_begin(&table_, d, -1));
    }
    begun_ = true;
}


const struct ::dem_table* Foam::demTable::rows(const ::dem* d)
{
    if (!Pstream::master())
    {
        return nullptr;
    }
    begin(d);
    mkDir(fileName(table_.folder));
    return &table_;
}
