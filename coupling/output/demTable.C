/*---------------------------------------------------------------------------*\
    demTable.C -- CSV table of a run, made with its first row.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demTable.H"
#include "demCheck.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demTable::demTable
(
    const Time& time,
    const word& name,
    const label digits
)
:
    time_(time),
    file_(folder(time)/name),
    dem_(nullptr),
    digits_(digits)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
    return time_.relativePath(file_);
}


void Foam::demTable::begin(const ::dem* d, const string& columns)
{
    if (!head_.empty())
    {
        return;
    }
    if (isFile(file_, false))
    {
        rm(file_);
    }
    dem_ = d;
    head_ = columns;
}


std::ostream& Foam::demTable::rows()
{
    if (!rows_.is_open())
    {
        recordEffects(time_, dem_);
        rows_.open(file_.c_str());
        rows_.precision(int(digits_));
        rows_ << head_ << '\n';
        end();
    }
    return rows_;
}


void Foam::demTable::end()
{
    rows_.flush();
    if (!rows_)
    {
        FatalErrorInFunction
            << "Cannot write all of " << file_ << "; free disk space, or correct"
            << " the permissions of its folder" << exit(FatalError);
    }
}

// ************************************************************************* //
