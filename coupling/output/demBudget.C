/*---------------------------------------------------------------------------*\
    demBudget.C -- sums of the budget's states and contributions, and their table.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demBudget.H"
#include "demCheck.H"
#include "Switch.H"
#include "error.H"
#include <sstream>

namespace Foam
{

// As in the header of the table
static const char* const suffix_[] =
{
    ".px", ".py", ".pz", ".volume", ".mass", ".energy", ".heat"
};
static const char* const unit_[] =
{
    "[Ns]", "[Ns]", "[Ns]", "[m3]", "[kg]", "[J]", "[J]"
};

} // End namespace Foam


Foam::string Foam::demBudget::columns() const
{
    string names("time[s],since[s]");

    for (label which = 0; which < nQuantities; which++)
    {
        const string ending(string(suffix_[which]) + unit_[which]);

        for (const item& i : items_[which])
        {
            names += "," + i.name + ending;
        }
        if (items_[which].size())
        {
            names += ",rest" + ending;
        }
    }
    return names;
}


// At the end of the first step, which sets the initial states
void Foam::demBudget::begin()
{
    since_ = time_.value();
    interval_.begin(since_);
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
        table_.begin(dem_);
    }
}


Foam::demBudget::item& Foam::demBudget::find
(
    const quantity which,
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


Foam::demBudget::demBudget(const Time& time, const dictionary& coupling)
:
    time_(time),
    dem_(nullptr),
    interval_(0),
    since_(0),
    table_(time, "budget.csv")
{
    const dictionary record(coupling.subOrEmptyDict("record"));

    if (record.getOrDefault<Switch>("budget", false))
    {
        interval_ = demInterval(record.get<scalar>("interval"));
    }
}


void Foam::demBudget::state
(
    const quantity which,
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
        state(quantity(PX + d), name, momentum[d]);
    }
}


void Foam::demBudget::gain
(
    const quantity which,
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
        gain(quantity(PX + d), name, impulse[d]);
    }
}


void Foam::demBudget::endStep()
{
    if (!interval_.begun())
    {
        begin();
        return;
    }
    if (!interval_.pass(time_.value()) || !Pstream::master())
    {
        return;
    }

    std::ostringstream row;
    row.precision(16);
    row << time_.value() << ',' << since_;
    for (const DynamicList<item>& items : items_)
    {
        scalar rest = 0;
        for (const item& i : items)
        {
            row << ',' << i.value;
            rest += i.state ? i.value - i.begin : -i.value;
        }
        if (items.size())
        {
            row << ',' << rest;
        }
    }
    row << '\n';
    demCheck
    (
        dem_table_append(table_.rows(dem_), dem_, columns().c_str(), row.str().c_str())
    );
}
