/*---------------------------------------------------------------------------*\
    demBudget.C -- accounts, and a table of them.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demBudget.H"
#include "OSspecific.H"
#include "Switch.H"
#include "error.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// As they stand in the table's head
static const char* const account_[] =
{
    ".px", ".py", ".pz", ".volume", ".mass", ".energy"
};
static const char* const unit_[] =
{
    "[Ns]", "[Ns]", "[Ns]", "[m3]", "[kg]", "[J]"
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demBudget::open()
{
    const fileName folder
    (
        time_.globalPath()/"postProcessing"/"dem"
       /Time::timeName(time_.value() - time_.deltaTValue())
    );
    mkDir(folder);
    file_.open((folder/"budget.csv").c_str());

    if (!file_)
    {
        FatalErrorInFunction
            << "Can't write " << folder/"budget.csv" << "; take out"
            << " coupling/record/budget, or make room" << exit(FatalError);
    }
    file_.precision(16);
}


void Foam::demBudget::writeHead()
{
    file_ << "time[s],since[s]";
    for (label which = 0; which < ACCOUNTS; which++)
    {
        forAll(items_[which], i)
        {
            file_ << ',' << items_[which][i].name << account_[which]
                << unit_[which];
        }
        file_ << ",rest" << account_[which] << unit_[which];
    }
    file_ << std::endl;
}


Foam::demBudget::item& Foam::demBudget::find
(
    const account which,
    const std::string& name,
    const bool state
)
{
    DynamicList<item>& items = items_[which];

    forAll(items, i)
    {
        if (items[i].name == name && items[i].state == state)
        {
            return items[i];
        }
    }

    items.append(item{name, state, 0, 0});
    return items[items.size() - 1];
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demBudget::demBudget(const Time& time, const dictionary& coupling)
:
    time_(time),
    interval_(0),
    entries_(0),
    since_(-GREAT)
{
    const dictionary record(coupling.subOrEmptyDict("record"));

    if (record.getOrDefault<Switch>("budget", false))
    {
        interval_ = record.get<scalar>("interval");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demBudget::state
(
    const account which,
    const std::string& name,
    const scalar value
)
{
    find(which, name, true).value = value;
}


void Foam::demBudget::state(const std::string& name, const vector& momentum)
{
    for (direction d = 0; d < 3; d++)
    {
        state(account(PX + d), name, momentum[d]);
    }
}


void Foam::demBudget::gain
(
    const account which,
    const std::string& name,
    const scalar value
)
{
    find(which, name, false).value += value;
}


void Foam::demBudget::gain(const std::string& name, const vector& impulse)
{
    for (direction d = 0; d < 3; d++)
    {
        gain(account(PX + d), name, impulse[d]);
    }
}


void Foam::demBudget::close()
{
    if (since_ == -GREAT)
    {
        since_ = time_.value();
        entries_ = std::floor(since_/interval_ + 1e-6);
        for (DynamicList<item>& items : items_)
        {
            for (item& i : items)
            {
                i.begin = i.value;
                i.value = i.state ? i.value : 0;
            }
        }
        if (Pstream::master())
        {
            open();
            writeHead();
        }
        return;
    }

    const scalar passed = std::floor(time_.value()/interval_ + 1e-6);
    if (passed <= entries_)
    {
        return;
    }
    entries_ = passed;

    if (!Pstream::master())
    {
        return;
    }
    file_ << time_.value() << ',' << since_;
    for (const DynamicList<item>& items : items_)
    {
        scalar rest = 0;
        for (const item& i : items)
        {
            file_ << ',' << i.value;
            rest += i.state ? i.value - i.begin : -i.value;
        }
        file_ << ',' << rest;
    }
    file_ << std::endl;
}

// ************************************************************************* //
