/*---------------------------------------------------------------------------*\
    demFlowTable.C -- table of sums and rates of inflow and outflow.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFlowTable.H"
#include "demCheck.H"
#include "demInteger.H"

Foam::demFlowTable::demFlowTable(const Time& time)
:
    table_(time, "flows.csv"),
    last_()
{}


void Foam::demFlowTable::begin(::dem* d, const scalar now)
{
    demCheck(dem_flow_sums_set(&last_, d, now));
}


void Foam::demFlowTable::report(::dem* d, const bool rows, const scalar now)
{
    const struct ::dem_flow* flow = nullptr;
    int n = 0;
    demCheck(dem_flows(d, &n, &flow));

    if (!n)
    {
        return;
    }
    table_.begin(d);
    if (rows)
    {
        demCheck(dem_table_add_flows(table_.rows(d), d, now, &last_));
        return;
    }

    int64_t in = 0;
    int64_t out = 0;
    int64_t waiting = 0;
    for (int k = 0; k < n; k++)
    {
        (flow[k].enters ? in : out) += flow[k].particles;
        waiting += flow[k].waiting;
    }
    Info<< "Suna: since the start " << demInteger(in).c_str()
        << " particles entered, " << demInteger(out).c_str() << " left, "
        << demInteger(waiting).c_str() << " wait for free space" << endl;
}
