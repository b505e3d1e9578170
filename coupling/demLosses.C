/*---------------------------------------------------------------------------*\
    demLosses.C -- who was lost, where and why.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demLosses.H"
#include "demCheck.H"
#include "demColumns.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Ids on a line of the log; all are in the file
enum { MOST_IDS = 10 };

static void sayIds
(
    const struct ::dem_loss* loss,
    const label n,
    const int removed
)
{
    label said = 0;

    for (label k = 0; k < n && said <= MOST_IDS; k++)
    {
        if (loss[k].removed == removed && said++ < MOST_IDS)
        {
            Info<< ' ' << loss[k].id;
        }
    }
    Info<< (said > MOST_IDS ? " ..." : "");
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demLosses::demLosses(const fvMesh& mesh)
:
    mesh_(mesh),
    table_(mesh.time(), "lost.csv"),
    removed_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::demLosses::wayOut(const point& x, const vector& v)
{
    if (!wayOut_ || mesh_.moving())
    {
        wayOut_.reset(new demWayOut(mesh_));
    }
    return wayOut_().say(pointField(1, x), vectorField(1, v))[0];
}


void Foam::demLosses::tell(::dem* d, const scalar offset)
{
    if (Pstream::master())
    {
        table_.begin(d, "id,time,x,y,z,vx,vy,vz,diameter,cause");
    }

    const struct ::dem_loss* loss = nullptr;
    int64_t count = 0;
    demCheck(dem_lost(d, &count, &loss));
    const label n = label(count);

    if (n == 0)
    {
        return;
    }

    // Who was taken out has a patch; who passed a wall, its wall
    pointField points(n);
    vectorField velocities(n, Zero);
    label removed = 0;
    for (label k = 0; k < n; k++)
    {
        points[k] = three(loss[k].position, 0);
        if (loss[k].removed)
        {
            velocities[k] = three(loss[k].velocity, 0);
            removed++;
        }
    }
    if (!wayOut_ || mesh_.moving())
    {
        wayOut_.reset(new demWayOut(mesh_));
    }
    const List<string> patch(wayOut_().say(points, velocities));

    removed_ += removed;
    if (removed)
    {
        Info<< "Suna: lost " << removed << " particles, " << removed_
            << " in this run:";
        sayIds(loss, n, 1);
        Info<< "; where and why is in " << table_.name().c_str()
            << endl;
    }
    if (removed < n)
    {
        Info<< "Suna: " << n - removed << " passages of particles through walls:";
        sayIds(loss, n, 0);
        Info<< "; where and why is in " << table_.name().c_str()
            << endl;
    }

    if (Pstream::master())
    {
        for (label k = 0; k < n; k++)
        {
            const double* v = loss[k].velocity;

            table_.rows()
                << loss[k].id << ',' << loss[k].time + offset << ',' << points[k].x()
                << ',' << points[k].y() << ',' << points[k].z() << ',' << v[0]
                << ',' << v[1] << ',' << v[2] << ',' << loss[k].diameter
                << ",\"" << loss[k].cause << patch[k].c_str() << '"' << '\n';
        }
        table_.end();
    }
}

// ************************************************************************* //
