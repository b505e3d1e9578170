/*---------------------------------------------------------------------------*\
    demBonds.C -- table of broken bonds, and VTK files of intact ones.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demBonds.H"
#include "demCheck.H"
#include "demInteger.H"
#include "OSspecific.H"

void Foam::demBonds::begin(const ::dem* d)
{
    if (!begun_ && Pstream::master())
    {
        const fileName list(folder_/"bonds.pvd");

        table_.begin(d);
        if (isFile(list, false))
        {
            rm(list);
        }
    }
    begun_ = true;
}


Foam::demBonds::demBonds(const Time& time)
:
    time_(time),
    folder_(demTable::folder(time)),
    table_(time, "bonds.csv"),
    begun_(false),
    broken_(0)
{
    // All ranks open one file, also where their cases have different roots
    demBroadcast(folder_);
}


void Foam::demBonds::report(::dem* d, const scalar offset)
{
    begin(d);
    if (!dem_has_bonds(d))
    {
        return;
    }

    const struct ::dem_broken_bond* broke = nullptr;
    int64_t n = 0;
    demCheck(dem_broken_bonds(d, &n, &broke));

    if (n == 0)
    {
        return;
    }

    broken_ += n;
    Info<< "Suna: " << demInteger(n).c_str() << (n == 1 ? " bond" : " bonds") << " broke, "
        << demInteger(broken_).c_str() << " in this run; where and why is in "
        << table_.name().c_str() << endl;

    if (Pstream::master())
    {
        demCheck(dem_table_add_bonds(table_.rows(d), d, n, broke, offset));
    }
}


void Foam::demBonds::writeVtk(::dem* d)
{
    begin(d);
    if (!dem_has_bonds(d))
    {
        return;
    }

    if (Pstream::master())
    {
        mkDir(folder_);
    }
    const fileName file("bonds_" + time_.timeName() + ".vtp");
    demCheck(dem_bonds_draw(d, folder_.c_str(), file.c_str(), time_.value()));
}
