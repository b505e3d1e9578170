/*---------------------------------------------------------------------------*\
    demBonds.C -- which bonds broke, and pictures of those that hold.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demBonds.H"
#include "demCheck.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demBonds::begin()
{
    if (!begun_ && Pstream::master())
    {
        for (const char* name : {"bonds.csv", "bonds.pvd"})
        {
            if (isFile(folder_/name, false))
            {
                rm(folder_/name);
            }
        }
    }
    begun_ = true;
}


void Foam::demBonds::open()
{
    if (rows_.is_open())
    {
        return;
    }

    mkDir(folder_);
    rows_.open((folder_/"bonds.csv").c_str());

    if (!rows_)
    {
        FatalErrorInFunction
            << "Can't write " << folder_/"bonds.csv" << "; make room, or mend"
            << " its folder's rights" << exit(FatalError);
    }

    rows_.precision(9);
    rows_ << "time,id1,id2,x,y,z,cause,energy" << std::endl;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demBonds::demBonds(const Time& time)
:
    time_(time),
    folder_(time.globalPath()/"postProcessing"/"dem"/time.timeName()),
    begun_(false),
    broke_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demBonds::tell(::dem* d, const scalar offset)
{
    begin();
    if (!dem_has_bonds(d))
    {
        return;
    }

    const struct ::dem_break* broke = nullptr;
    int64_t n = 0;
    demCheck(dem_broken_bonds(d, &n, &broke));

    if (n == 0)
    {
        return;
    }

    broke_ += n;
    Info<< "Suna: " << n << (n == 1 ? " bond" : " bonds") << " broke, "
        << broke_ << " in this run; where and why is in "
        << time_.relativePath(folder_/"bonds.csv").c_str() << endl;

    if (Pstream::master())
    {
        open();
        for (int64_t k = 0; k < n; k++)
        {
            const double* x = broke[k].position;

            rows_ << broke[k].time + offset << ',' << broke[k].id[0] << ','
                << broke[k].id[1] << ',' << x[0] << ',' << x[1] << ',' << x[2]
                << ',' << dem_break_cause(broke[k].cause) << ','
                << broke[k].energy << '\n';
        }
        rows_.flush();

        if (!rows_)
        {
            FatalErrorInFunction
                << "Can't write all of " << folder_/"bonds.csv" << "; make room"
                << exit(FatalError);
        }
    }
}


void Foam::demBonds::draw(::dem* d)
{
    begin();
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

// ************************************************************************* //
