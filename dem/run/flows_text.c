/*
 * flows_text.c -- streams of particles into the domain, and outlets, as text.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/scene_text.h"
#include <math.h>

static void write_inlet(struct dem_text *t, const struct dem_inlet_shape *m)
{
    if (m->patch)
    {
        dem_text_add(t, "through patch %s of %.4g m2", m->patch, dem_inlet_shape_area(m));
    }
    else if (m->kind == DEM_INLET_REGION)
    {
        dem_text_add(t, "in a %s of %.4g m3", dem_insertion_shape_name(&m->shape),
                     dem_insertion_shape_volume(&m->shape));
    }
    else
    {
        dem_text_add(t, "through a %s of %.4g m2", m->kind == DEM_INLET_DISC ? "disc" : "surface",
                     dem_inlet_shape_area(m));
    }
}

static void write_limits(struct dem_text *t, const struct dem_stream *s)
{
    if (s->start > 0.0 && isfinite(s->start))
    {
        dem_text_add(t, ", from %g s", s->start);
    }
    if (isfinite(s->end) && !s->at_once)
    {
        dem_text_add(t, ", until %g s", s->end);
    }
    if (s->count < INT64_MAX)
    {
        dem_text_add(t, ", at most %lld", (long long)s->count);
    }
    if (isfinite(s->mass))
    {
        dem_text_add(t, ", at most %g kg", s->mass);
    }
}

static void write_stream(struct dem_text *t, const struct dem_interaction_table *r,
                         const struct dem_stream *s)
{
    const double each = dem_stream_mean_mass(s, r),
                 rate = s->by_mass ? s->rate/each : s->rate;

    dem_text_add(t, s->at_once ? "    %-18s in: %.4g particles at once, %.4g kg of %s, diameter %g"
                               : "    %-18s in: %.4g particles a second, %.4g kg/s of %s, diameter %g",
                 s->name, rate, rate*each, r->material[s->material].name, s->sizes.min);
    if (s->sizes.max > s->sizes.min)
    {
        dem_text_add(t, " to %g", s->sizes.max);
    }
    dem_text_add(t, " m, ");
    write_inlet(t, &s->inlet);
    if (s->with_fluid)
    {
        dem_text_add(t, " with the fluid");
    }
    else
    {
        dem_text_add(t, " at (%g %g %g) m/s", s->velocity[0], s->velocity[1], s->velocity[2]);
    }
    write_limits(t, s);
    dem_text_add(t, "\n");
}

void dem_flows_text_add(struct dem_text *t, const struct dem *d)
{
    const struct dem_streams *const s = &d->scene.streams;

    if (s->streams + s->outlets + s->planes == 0)
    {
        return;
    }
    dem_text_add(t, "Streams and outlets\n");
    for (int k = 0; k < s->streams; k++)
    {
        write_stream(t, &d->state.interaction_table, &s->stream[k]);
    }
    for (int k = 0; k < s->outlets; k++)
    {
        const struct dem_outlet *const o = &s->outlet[k];

        dem_text_add(t, "    %-18s out: %s%s\n", o->name,
                     o->patch ? "through patch "
                     : o->wall ? "absorbed by this wall"
                     : o->plane ? "beyond a plane"
                                : "in a ",
                     o->patch ? o->patch
                     : o->plane || o->wall ? ""
                                           : dem_insertion_shape_name(&o->shape));
    }
    for (int k = 0; k < s->planes; k++)
    {
        dem_text_add(t, "    %-18s counts what passes it\n", s->plane[k].name);
    }
}
