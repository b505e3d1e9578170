/*---------------------------------------------------------------------------*\
    demFlowTable.C -- table of sums and rates of inflow and outflow.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFlowTable.H"
#include "demCheck.H"
#include "demInteger.H"

// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demFlowTable::demFlowTable(const Time& time)
:
    table_(time, "flows.csv"),
    since_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demFlowTable::begin(::dem* d, const scalar now)
{
    const struct ::dem_flow* flow = nullptr;
    int n = 0;
    demCheck(dem_flows(d, &n, &flow));

    particles_.setSize(n);
    mass_.setSize(n);
    for (int k = 0; k < n; k++)
    {
        particles_[k] = scalar(flow[k].particles);
        mass_[k] = flow[k].mass;
    }
    since_ = now;
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
    if (Pstream::master())
    {
        table_.begin
        (
            d,
            "time[s],name,way,particles,mass[kg],px[Ns],py[Ns],pz[Ns],energy[J],"
            "waiting,rate[1/s],massRate[kg/s]"
        );
    }

    int64_t in = 0;
    int64_t out = 0;
    int64_t waiting = 0;
    for (int k = 0; k < n; k++)
    {
        (flow[k].enters ? in : out) += flow[k].particles;
        waiting += flow[k].waiting;
    }
    if (!rows)
    {
        Info<< "Suna: since the start " << demInteger(in).c_str()
            << " particles entered, " << demInteger(out).c_str() << " left, "
            << demInteger(waiting).c_str() << " wait for free space" << endl;
        return;
    }

    const scalar perTime = now > since_ ? 1/(now - since_) : 0;

    for (int k = 0; k < n; k++)
    {
        const struct ::dem_flow& f = flow[k];

        if (Pstream::master())
        {
            table_.rows()
                << now << ',' << f.name << ',' << (f.enters ? "in" : "out")
                << ',' << f.particles << ',' << f.mass << ',' << f.momentum[0]
                << ',' << f.momentum[1] << ',' << f.momentum[2] << ','
                << f.energy << ',' << f.waiting << ','
                << perTime*(f.particles - particles_[k]) << ','
                << perTime*(f.mass - mass_[k]) << '\n';
            table_.end();
        }
        particles_[k] = scalar(f.particles);
        mass_[k] = f.mass;
    }
    since_ = now;
}

// ************************************************************************* //
