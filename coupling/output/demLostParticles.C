/*---------------------------------------------------------------------------*\
    demLostParticles.C -- report and table of lost particles.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demLostParticles.H"
#include "demCheck.H"
#include "demColumns.H"
#include "demInteger.H"
#include "OSspecific.H"
#include "Time.H"

namespace Foam
{

// Largest number of ids on a line of the log; the file has all
enum { MAX_IDS = 10 };

// Number of losses in one search for patches
enum { BLOCK = 100000 };

static void reportIds
(
    const struct ::dem_loss* loss,
    const int64_t n,
    const int removed
)
{
    label reported = 0;

    for (int64_t k = 0; k < n && reported <= MAX_IDS; k++)
    {
        if (loss[k].removed == removed && reported++ < MAX_IDS)
        {
            Info<< ' ' << demInteger(loss[k].id).c_str();
        }
    }
    Info<< (reported > MAX_IDS ? " ..." : "");
}

} // End namespace Foam


Foam::List<Foam::string> Foam::demLostParticles::describePatch
(
    const UList<point>& points,
    const UList<vector>& velocities
)
{
    if (!exitPatch_ || mesh_.moving())
    {
        exitPatch_.reset(new demOutletPatch(mesh_));
    }
    return exitPatch_().describe(points, velocities);
}


void Foam::demLostParticles::writeRows
(
    const ::dem* d,
    const struct ::dem_loss* loss,
    const label n,
    const scalar offset
)
{
    // Append a patch to the cause of a removed particle; if a particle passed through
    // a wall, the cause names the wall already
    pointField points(n);
    vectorField velocities(n, Zero);
    for (label k = 0; k < n; k++)
    {
        points[k] = vectorAt(loss[k].position, 0);
        if (loss[k].removed)
        {
            velocities[k] = vectorAt(loss[k].velocity, 0);
        }
    }
    const List<string> patch(describePatch(points, velocities));

    List<const char*> text(n);
    forAll(text, k)
    {
        text[k] = patch[k].c_str();
    }
    if (Pstream::master())
    {
        demCheck(dem_table_add_losses(table_.rows(d), d, n, loss, offset, text.cdata()));
    }
}


Foam::demLostParticles::demLostParticles(const fvMesh& mesh)
:
    mesh_(mesh),
    table_(mesh.time(), "lost.csv"),
    removed_(0)
{}


void Foam::demLostParticles::report(::dem* d, const scalar offset)
{
    table_.begin(d);

    const struct ::dem_loss* loss = nullptr;
    int64_t n = 0;
    demCheck(dem_lost(d, &n, &loss));

    if (n == 0)
    {
        return;
    }

    int64_t removed = 0;
    for (int64_t k = 0; k < n; k++)
    {
        removed += loss[k].removed ? 1 : 0;
    }
    removed_ += removed;

    if (removed)
    {
        Info<< "Suna: lost " << demInteger(removed).c_str() << " particles, "
            << demInteger(removed_).c_str() << " in this run:";
        reportIds(loss, n, 1);
        Info<< "; where and why is in " << table_.name().c_str()
            << endl;
    }
    if (removed < n)
    {
        Info<< "Suna: " << demInteger(n - removed).c_str()
            << " passages of particles through walls:";
        reportIds(loss, n, 0);
        Info<< "; where and why is in " << table_.name().c_str()
            << endl;
    }

    for (int64_t first = 0; first < n; first += BLOCK)
    {
        writeRows(d, loss + first, label(min(n - first, int64_t(BLOCK))), offset);
    }
}
