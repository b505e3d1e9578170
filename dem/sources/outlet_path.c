/*
 * outlet_path.c -- the outlet that a particle has met, and the planes that it has passed, on the straight
 * line from its position at the last check.
 *
 * The column DEM_COLUMN_CHECKED_POSITION holds this position and the image counter that belongs to
 * it. With the counters the displacement is exact along periodic axes, whenever the particle was
 * wrapped. For a clump its centre counts. The line leads through images of the domain; the part in
 * each is tested there, so an outlet acts where it lies in the domain.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/flows.h"
#include "ranks/dem_state.h"
#include <math.h>
#include <string.h>

/* numbers of the column: x, y, z, and 1 + the image counter; all 0 before the first check */
enum
{
    LAST = 4
};

int dem_flows_outlet_at(const struct dem_flows *f, const double x[3])
{
    for (int k = 0; f->n > 0 && k < f->plan->outlets; k++)
    {
        if (dem_outlet_holds(&f->plan->outlet[k], x))
        {
            return f->plan->streams + k;
        }
    }
    return DEM_FLOW_NONE;
}

/* Finite, and in the box along periodic axes. */
static int is_wrapped(const struct dem_domain *d, const double x[3])
{
    int wrapped = 1;

    for (int k = 0; k < 3; k++)
    {
        wrapped = wrapped && isfinite(x[k]) &&
                  (!d->periodic[k] || (x[k] >= d->min[k] && x[k] <= d->max[k]));
    }
    return wrapped;
}

struct path               /* of a particle since the last check, through images of the domain */
{
    const struct dem_flows *flows;
    double from[3], step[3];
    int outlet;                            /* the first that it meets */
    int planes, passed[DEM_SNAPSHOT_FLOWS];  /* of each plane: times forth less times back */
};

/* Test the part of the path that lies in the domain when it is shifted by `at` boxes. */
static void test_image(struct path *p, const struct dem_domain *d, const int at[3])
{
    double part[2] = {0.0, 1.0}, image[3];

    for (int k = 0; k < 3; k++)
    {
        image[k] = p->from[k] + at[k]*d->length[k];
        if (d->periodic[k] &&
            !dem_insertion_shape_clip(image[k], p->step[k], d->min[k], d->max[k], part))
        {
            return;
        }
    }
    for (int k = 0; k < p->flows->plan->outlets && !p->planes && p->outlet == DEM_FLOW_NONE; k++)
    {
        if (dem_outlet_meets(&p->flows->plan->outlet[k], image, p->step, part))
        {
            p->outlet = p->flows->plan->streams + k;
        }
    }
    for (int k = 0; k < p->planes; k++)
    {
        p->passed[k] += dem_flow_plane_crossed(&p->flows->plan->plane[k], image, p->step, part);
    }
}

static void test_path(struct path *p, const struct dem_domain *d)
{
    int first[3] = {0, 0, 0}, last[3] = {0, 0, 0}, at[3];

    for (int k = 0; k < 3; k++)
    {
        const double low = fmin(p->from[k], p->from[k] + p->step[k]),
                     high = fmax(p->from[k], p->from[k] + p->step[k]);

        if (d->periodic[k])
        {
            first[k] = (int)ceil((d->min[k] - high)/d->length[k]);
            last[k] = (int)floor((d->max[k] - low)/d->length[k]);
        }
    }
    for (at[2] = first[2]; at[2] <= last[2]; at[2]++)
    {
        for (at[1] = first[1]; at[1] <= last[1]; at[1]++)
        {
            for (at[0] = first[0]; at[0] <= last[0]; at[0]++)
            {
                test_image(p, d, at);
            }
        }
    }
}

/* The path of particle i, which is wrapped in q. Returns 0 when it is not known. */
static int begin_path(const struct dem_state *state, size_t i, const struct dem_particle *q,
                      struct path *path)
{
    const double *const column = dem_column(&state->particles, DEM_COLUMN_CHECKED_POSITION);

    if (!column || column[LAST*i + 3] <= 0.0 || !is_wrapped(&state->domain, q->x))
    {
        return 0;
    }
    *path = (struct path){.flows = state->flows, .outlet = DEM_FLOW_NONE};
    for (size_t k = 0; k < 3; k++)
    {
        const uint32_t image = (uint32_t)(column[LAST*i + 3] - 1.0);

        path->step[k] = q->x[k] - column[LAST*i + k];
        /* the centre of a body has no counter; it moves by less than half a box between checks */
        path->step[k] += q->body == 0 ? dem_image_difference(q->image, image, (int)k)*state->domain.length[k]
                         : state->domain.periodic[k]
                             ? -state->domain.length[k]*rint(path->step[k]/state->domain.length[k])
                             : 0.0;
        path->from[k] = q->x[k] - path->step[k];
    }
    return 1;
}

int dem_flows_outlet(const struct dem_state *state, size_t i)
{
    struct dem_particle q = state->particles.record[i];
    struct path path;

    if (state->flows->n == 0)
    {
        return DEM_FLOW_NONE;
    }
    memcpy(q.x, dem_clump_home(&state->particles, i), sizeof q.x);
    dem_domain_wrap(&state->domain, &q);
    const int holds = dem_flows_outlet_at(state->flows, q.x);

    if (holds != DEM_FLOW_NONE || state->flows->plan->outlets == 0 || !begin_path(state, i, &q, &path))
    {
        return holds;
    }
    test_path(&path, &state->domain);
    return path.outlet;
}

int dem_flows_planes_passed(const struct dem_state *state, size_t i, int passed[DEM_SNAPSHOT_FLOWS])
{
    struct dem_particle q = state->particles.record[i];
    struct path path;

    memcpy(q.x, dem_clump_home(&state->particles, i), sizeof q.x);
    dem_domain_wrap(&state->domain, &q);
    if (!begin_path(state, i, &q, &path))
    {
        return 0;
    }
    path.planes = state->flows->plan->planes;
    test_path(&path, &state->domain);
    memcpy(passed, path.passed, sizeof path.passed);
    return 1;
}

void dem_flows_end_check(struct dem_state *state)
{
    double *const column = dem_column(&state->particles, DEM_COLUMN_CHECKED_POSITION);

    for (size_t i = 0; column && i < state->particles.n; i++)
    {
        const struct dem_particle *const q = &state->particles.record[i];

        memcpy(column + LAST*i, dem_clump_home(&state->particles, i), sizeof q->x);
        column[LAST*i + 3] = 1.0 + (double)q->image;
    }
}
