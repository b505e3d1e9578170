/*---------------------------------------------------------------------------*\
    demFlowTable.C -- tables of inflow, outflow and residence times.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFlowTable.H"
#include "demCheck.H"
#include "demInteger.H"
#include "demStop.H"

Foam::demFlowTable::demFlowTable(const Time& time, const dictionary& coupling)
:
    time_(time),
    interval_(coupling.subOrEmptyDict("record").getOrDefault<scalar>("interval", 0)),
    table_(time, "flows.csv"),
    residence_(time, "residence.csv"),
    last_()
{}


void Foam::demFlowTable::begin(::dem* d, const scalar now)
{
    demCheck(dem_flow_sums_set(&last_, d, now));
    if (interval_.on())
    {
        interval_.begin(time_.value());
    }
}


void Foam::demFlowTable::addRows(::dem* d, const scalar now)
{
    const struct ::dem_flow* flow = nullptr;
    int n = 0;
    demCheck(dem_flows(d, &n, &flow));

    if (!n || now <= last_.time)
    {
        return;
    }
    demCheck(dem_table_add_flows(table_.rows(d), d, now, &last_));
    if (Pstream::master())
    {
        demCheck(dem_table_add_residence(residence_.rows(d), d, now));
    }
}


void Foam::demFlowTable::endStep(::dem* d, const scalar now)
{
    const struct ::dem_flow* flow = nullptr;
    int n = 0;
    demCheck(dem_flows(d, &n, &flow));

    if (!n)
    {
        return;
    }
    table_.begin(d);
    residence_.begin(d);

    int64_t in = 0;
    int64_t out = 0;
    int64_t waiting = 0;
    for (int k = 0; k < n; k++)
    {
        in += flow[k].enters == DEM_FLOW_WAY_IN ? flow[k].particles : 0;
        out += flow[k].enters == DEM_FLOW_WAY_OUT ? flow[k].particles : 0;
        waiting += flow[k].waiting;
    }
    Info<< "Suna: since the start " << demInteger(in).c_str()
        << " particles entered, " << demInteger(out).c_str() << " left, "
        << demInteger(waiting).c_str() << " wait for free space" << endl;

    if ((interval_.on() && interval_.pass(time_.value())) || demStop::atEnd(time_))
    {
        addRows(d, now);
    }
}


void Foam::demFlowTable::write(::dem* d, const scalar now)
{
    if (!interval_.on() || demStop::atEnd(time_))
    {
        addRows(d, now);
    }
}
