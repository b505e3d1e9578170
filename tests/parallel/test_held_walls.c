/*
 * test_held_walls.c -- triangles of walls on several ranks.
 *
 * - Each rank holds the triangles that its particles may reach before the next rebuild, in the same
 *   order and with the same facets as a run on one rank.
 * - A rank of a long channel holds a fraction of the triangles.
 * - A channel with a rotating screw of triangles, a stream that ends at the channel, and a floor
 *   that begins to follow a mesh during the run: the same hash as on one rank.
 * - The first rank gets the corners of all triangles.
 *
 *     mpirun -np N test_held_walls    prints failures; status 0 if there are none
 *
 * Reference: the same run on each rank alone, and every triangle against every particle. The
 * channel is a wavy floor along x, without a facet of two triangles; all ranks give triangles in
 * turn.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "parallel/ranks.h"

#include "case/simulation.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum
{
    ALONG = 160,                  /* quadrilaterals of the floor along x and y, of the screw */
    ACROSS = 12,
    TURNS = 60,
    TRIANGLES = 2*ALONG*ACROSS
};

static const double length = 0.08, width = 0.012, pi = 3.14159265358979324;

/* ---- scene ----------------------------------------------------------------------------------- */

/* A corner of the floor; `risen` [m]: by how much its middle is higher. */
static void floor_point(int i, int k, double risen, double x[3])
{
    x[0] = length*i/ALONG;
    x[1] = width*k/ACROSS;
    x[2] = 5e-4*sin(40.0*pi*i/ALONG + 0.5*k) + risen*sin(pi*i/ALONG);
}

static void floor_triangle(int t, double risen, double corner[3][3])
{
    static const int quad[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};

    for (int c = 0; c < 3; c++)
    {
        const int *const at = quad[t%2][c];

        floor_point(t/2%ALONG + at[0], t/2/ALONG + at[1], risen, corner[c]);
    }
}

/* The triangles that this rank gives, of `parts` ranks. Returns their number. */
static int floor_part(int part, int parts, double risen, double (*corner)[3][3])
{
    int n = 0;

    for (int t = part; t < TRIANGLES; t += parts)
    {
        floor_triangle(t, risen, corner[n++]);
    }
    return n;
}

/* A helicoid about the axis of the channel. */
static char *screw(void)
{
    char *const text = calloc(400*2*TURNS + 400, 1);
    size_t used = (size_t)sprintf(text, "screw { type triangles; motion { type rotation; "
                                        "origin (0 0.006 0.008); axis (1 0 0); omega 60; } corners (");

    for (int t = 0; t < 2*TURNS; t++)
    {
        for (int c = 0; c < 3; c++)
        {
            const int i = t/2 + (c > 0 && !(t%2 && c == 1)), out = t%2 ? c > 0 : c == 2;
            const double a = 0.4*i;

            used += (size_t)sprintf(text + used, "(%.17g %.17g %.17g)", length*i/TURNS,
                                    0.006 + (out ? 0.005 : 0.001)*cos(a),
                                    0.008 + (out ? 0.005 : 0.001)*sin(a));
        }
    }
    sprintf(text + used, "); }");
    return text;
}

static struct dem *make(MPI_Comm comm)
{
    static const char scene[] =
        "materials { glass { density 2500; youngsModulus 1e6; } }"
        "effects { hertz {} dry { restitution 0.5; } mindlin { friction 0.3; }"
        " gravity { acceleration (0 0 -9.81); } }"
        "domain { min (-0.02 -0.02 -0.02); max (0.1 0.05 0.1); leaving remove; }"
        "walls { left { type plane; point (0 0 0); normal (0 1 0); }"
        " right { type plane; point (0 0.012 0); normal (0 -1 0); } %s }"
        "insert { row { type lattice; count 600; diameter 1e-3; spacing 1.2; jitter 0.5;"
        " min (0 0 0.0145); max (0.08 0.012 0.03); velocity (0.5 0 -1.5); seed 3; }"
        " feed { type stream; rate 4000; diameter 1.2e-3; velocity (0.3 0 -1); seed 4;"
        " min (0.03 0.001 0.0005); max (0.06 0.011 0.003); } }";
    const int alone = comm == MPI_COMM_SELF;
    double(*const corner)[3][3] = calloc(TRIANGLES, sizeof *corner);
    char *const turning = screw(), *const text = calloc(sizeof scene + strlen(turning) + 1, 1);
    struct dem_case *c;
    struct dem *d;

    sprintf(text, scene, turning);
    try(dem_case_create(&c, comm));
    try(dem_case_scene_text(c, text, "channel"));
    const int n = floor_part(alone ? 0 : rank, alone ? 1 : ranks, 0.0, corner);

    try(dem_case_add_wall(c, "floor", "glass", n, &corner[0][0][0]));
    try(dem_start(&c, &d));
    free(corner);
    free(turning);
    free(text);
    return d;
}

static void move(struct dem *d, int alone, double risen)
{
    double(*const corner)[3][3] = calloc(TRIANGLES, sizeof *corner);
    const int n = floor_part(alone ? 0 : rank, alone ? 1 : ranks, risen, corner);

    try(dem_wall_move(d, "floor", n, &corner[0][0][0]));
    free(corner);
}

/* ---- the triangles of a rank ----------------------------------------------------------------- */

/* For each particle as many wall neighbors, with the same facets and triangles, as among all. */
static void check_held(const struct dem *d, const struct dem *alone)
{
    const struct dem_state *const p = &d->state;
    const struct dem_walls *const all = &alone->state.walls;
    const double reach = p->pairs.outer;
    size_t found = 0, held = 0;

    for (size_t k = 0; k < p->pairs.wall_search.neighbors; k++)
    {
        held += p->pairs.wall_search.neighbor[k].count;
    }
    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];

        for (size_t t = 0; t < all->triangles; t++)
        {
            double own[3], on[3];
            const double *const x = dem_walls_to_frame(&p->walls, all->triangle[t].wall, q->x, own);

            found += dem_triangle_nearest(&all->triangle[t], x, on) <
                     (q->radius + reach)*(q->radius + reach);
        }
    }
    check(held == found, "triangles within reach of particles", (double)held, (double)found);
    for (size_t t = 0; t < p->walls.triangles; t++)
    {
        const struct dem_triangle *const here = &p->walls.triangle[t],
                                  *const there = &all->triangle[here->index];
        const struct dem_facet *const f = &p->walls.facet[here->facet],
                               *const g = &all->facet[there->facet];

        if (memcmp(here->corner, there->corner, sizeof here->corner) != 0 ||
            here->wall != there->wall || here->rim != there->rim || f->number != g->number ||
            memcmp(f->normal, g->normal, sizeof f->normal) != 0 ||
            memcmp(&f->offset, &g->offset, sizeof f->offset) != 0)
        {
            check(0, "a triangle with its facet", (double)t, here->index);
        }
    }
}

/* The floor is even along x: a rank's part has the columns within reach of its subdomain, as far as
   there are particles. The reach is below a tenth of the channel. */
static void check_fraction(const struct dem *d)
{
    const struct dem_wall_store *const s = &d->state.wall_store;
    const double held = (double)d->state.walls.triangles, all = TRIANGLES + 2*TURNS;
    double min[3], max[3];

    dem_decomposition_box(s->decomposition, rank, min, max);
    const double along = fmin(max[0], s->box[1][0]) - fmax(min[0], s->box[0][0]) +
                         2.0*(s->reach + length/ALONG);

    check(ranks == 1 ? held >= all : held <= TRIANGLES*along/length + 2*TURNS, "triangles held",
          held, TRIANGLES*along/length);
    check(ranks == 1 || s->reach < 0.1*length, "reach, m", s->reach, 0.1*length);
    check((double)s->n <= all/ranks + 1.0, "triangles stored", (double)s->n, all/ranks);
}

static void check_corners(struct dem *d, struct dem *alone)
{
    for (int wall = 0; wall < dem_wall_count(d); wall++)
    {
        struct dem_wall_info info;

        dem_wall_info(d, wall, &info);
        const size_t n = 9*(size_t)info.triangles;
        double *const here = calloc(n + 1, sizeof *here), *const there = calloc(n + 1, sizeof *there);

        try(dem_wall_corners(d, wall, here));
        try(dem_wall_corners(alone, wall, there));
        check(rank > 0 || memcmp(here, there, n*sizeof *here) == 0, "corners of wall", wall, wall);
        free(here);
        free(there);
    }
}

static void check_same(struct dem *d, struct dem *alone, const char *what)
{
    uint64_t here, there;
    struct dem_totals total;

    try(dem_hash(d, &here));
    try(dem_hash(alone, &there));
    check(here == there, what, (double)here, (double)there);
    try(dem_totals(d, &total));
    check(total.particles > 620, "particles, with the stream's", (double)total.particles,
          620.0);
}

/* ---- the run --------------------------------------------------------------------------------- */

static void advance(struct dem *d, struct dem *alone, double time)
{
    try(dem_advance(d, time));
    try(dem_advance(alone, time));
}

int main(int argc, char **argv)
{
    struct dem *d, *alone;

    ranks_begin(&argc, &argv);
    d = make(MPI_COMM_WORLD);
    alone = make(MPI_COMM_SELF);
    check_held(d, alone);
    check_fraction(d);
    for (int k = 0; k < 4; k++)
    {
        advance(d, alone, 5e-3);
        check_fraction(d);
    }
    check_same(d, alone, "hash with a screw and a stream");
    check(ranks == 1 || d->state.wall_store.selections > 2, "selections",
          (double)d->state.wall_store.selections, 2.0);
    check_corners(d, alone);
    for (int k = 1; k < 4; k++)
    {
        move(d, 0, 3e-4*k);
        move(alone, 1, 3e-4*k);
        advance(d, alone, 2e-3);
    }
    check_same(d, alone, "hash with a floor that follows a mesh");
    check_corners(d, alone);
    dem_free(d);
    dem_free(alone);
    return ranks_end();
}
