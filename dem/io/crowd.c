/*
 * crowd.c -- adding one by one; a tally of each group.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/crowd.h"
#include "base/error.h"
#include "base/memory.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

void dem_crowd_free(struct dem_crowd *c)
{
    dem_memory_free(c->particle);
    dem_memory_free(c->group);
    memset(c, 0, sizeof *c);
}

void dem_crowd_disperse(struct dem_crowd *c)
{
    dem_memory_free(c->particle);
    c->particle = NULL;
    c->n = c->room = 0;
}

int dem_crowd_begin(struct dem_crowd *c, const char *group)
{
    DEM_TRY(DEM_GROW(c->group, c->group_room, c->groups + 1));
    c->group[c->groups] = (struct dem_group){.least = INFINITY};
    snprintf(c->group[c->groups++].name, sizeof c->group->name, "%s", group);
    return DEM_OK;
}

void dem_crowd_count(struct dem_crowd *c, int64_t n, double diameter, double mass, int material)
{
    struct dem_group *const g = &c->group[c->groups - 1];

    g->material = g->n == 0 || g->material == material ? material : -1;
    g->n += n;
    g->least = fmin(g->least, diameter);
    g->most = fmax(g->most, diameter);
    g->sum += (double)n*diameter;
    g->volume += (double)n*dem_sphere_volume(0.5*diameter);
    g->mass += (double)n*mass;
}

int dem_crowd_add(struct dem_crowd *c, struct dem_particle p, const char *where)
{
    DEM_REQUIRE(p.radius > 0.0 && isfinite(p.radius), DEM_ERROR_INPUT, "%s: diameter %g m; give a number above 0", where,
                2.0*p.radius);
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(isfinite(p.x[k] + p.v[k] + p.w[k]), DEM_ERROR_INPUT,
                    "%s: a position, velocity or spin is not a number", where);
        DEM_REQUIRE(fabs(p.x[k]) <= dem_crowd_far*p.radius, DEM_ERROR_INPUT,
                    "%s: particle %lld at (%g %g %g) m is more than %g radii of %g m from the origin, where a double tells no overlaps apart; move it",
                    where, (long long)p.id, p.x[0], p.x[1], p.x[2], dem_crowd_far, p.radius);
        DEM_REQUIRE(!(p.flags & DEM_PARTICLE_FROZEN) || (p.v[k] == 0.0 && p.w[k] == 0.0), DEM_ERROR_INPUT,
                    "%s: a frozen particle never moves, but has a velocity or spin of %g; leave it out, or frozen", where,
                    p.v[k] != 0.0 ? p.v[k] : p.w[k]);
    }
    DEM_REQUIRE(p.id < INT64_MAX, DEM_ERROR_INPUT, "%s: id %lld leaves no next one; give a smaller number", where, (long long)p.id);
    DEM_TRY(DEM_GROW(c->particle, c->room, c->n + 1));
    p.id = p.id < 0 ? c->next_id : p.id;
    c->next_id = p.id >= c->next_id ? p.id + 1 : c->next_id;
    c->particle[c->n++] = p;
    return DEM_OK;
}
