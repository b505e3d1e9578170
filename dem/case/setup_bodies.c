/*
 * setup_bodies.c -- mass, centre and inertia of free walls that are the surfaces of solids, and the spin
 * with which walls begin.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "core/error.h"
#include "ranks/collect.h"
#include "ranks/mpi_error.h"
#include "sources/closed_surface.h"
#include "walls/wall_rotation.h"
#include <string.h>

struct solid    /* over the density */
{
    double volume, centre[3], inertia[3][3];
};

/* The first rank has the triangles. */
static int measure(const struct dem *d, int wall, struct solid *s)
{
    struct dem_closed_surface surface = {.n = 0};

    if (d->state.decomposition.rank > 0)
    {
        return DEM_OK;
    }
    const int status = dem_closed_surface_of_wall(&surface, &d->state.walls, wall);

    if (!status)
    {
        s->volume = surface.volume;
        dem_closed_surface_inertia(&surface, s->centre, s->inertia);
    }
    dem_closed_surface_free(&surface);
    return status;
}

static void take_mass(struct dem_wall_body *b, const struct solid *s)
{
    const double density = b->rotation.density;

    b->mass = density*s->volume;
    b->weighs *= b->mass;
    memcpy(b->rotation.centre, s->centre, sizeof s->centre);
    for (int k = 0; k < 9; k++)
    {
        b->rotation.tensor[k/3][k%3] = density*s->inertia[k/3][k%3];
    }
    dem_wall_rotation_prepare(&b->rotation, &dem_pose_identity);
}

int dem_sim_begin_bodies(struct dem *d)
{
    const struct dem_walls *const w = &d->state.walls;

    for (int k = 0; k < w->walls && w->bodies > 0; k++)
    {
        struct dem_wall_body *const b = dem_walls_body(w, k);
        struct solid s = {.volume = 0.0};

        if (b && b->rotation.density > 0.0)
        {
            DEM_TRY(dem_sim_agree(d, measure(d, k, &s)));
            DEM_TRY(d->state.decomposition.ranks == 1
                        ? DEM_OK
                        : DEM_MPI_STATUS(MPI_Bcast(&s, (int)sizeof s, MPI_BYTE, 0, d->state.decomposition.comm)));
            take_mass(b, &s);
        }
        if (b && b->rotation.axes > 0)
        {
            dem_wall_rotation_start(b);
        }
    }
    return DEM_OK;
}
