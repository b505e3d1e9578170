/*
 * stream.c -- streams and outlets: limits, amounts due, and trial positions of particle number k.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/stream.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/random.h"
#include "core/vec.h"
#include "particles/initial_particles.h"
#include <math.h>
#include <string.h>

enum
{
    USE_SPREAD = 201,  /* sequences of random numbers: three for the velocity, */
    USE_PLACE = 1001   /* and from here on four a trial for the position */
};

/* A centre on a face of a mesh belongs to no cell, and a face of four corners is not flat: centres
   are moved inward by this fraction of the radius. */
static const double behind_face = 1e-3;

void dem_streams_free(struct dem_streams *s)
{
    for (int k = 0; k < s->streams; k++)
    {
        dem_size_distribution_free(&s->stream[k].sizes);
        dem_inlet_shape_free(&s->stream[k].inlet);
    }
    dem_memory_free(s->stream);
    dem_memory_free(s->outlet);
    dem_memory_free(s->plane);
    memset(s, 0, sizeof *s);
}

void dem_streams_radii(const struct dem_streams *s, double *min, double *max, double *body)
{
    for (int k = 0; k < s->streams; k++)
    {
        const struct dem_stream *const t = &s->stream[k];
        double *const least = &min[t->material], *const most = &max[t->material];

        for (size_t i = 0; i < (t->clump.shape ? t->clump.shape->n : 1); i++)
        {
            const double *const sphere = t->clump.shape ? t->clump.shape->sphere[i] : NULL;
            const double smallest = sphere ? sphere[3] : 0.5*t->sizes.min;

            *least = *least > 0.0 ? fmin(*least, smallest) : smallest;
            *most = fmax(*most, sphere ? sphere[3] : 0.5*t->sizes.max);
        }
        dem_clump_source_limit(&t->clump, &body[t->material]);
    }
}

void dem_streams_ratios(const struct dem_streams *s, struct dem_interaction_table *r)
{
    for (int k = 0; r->parcels.used && k < s->streams; k++)
    {
        dem_interaction_table_add_parcel(r, s->stream[k].ratio);
    }
}

/* Inlets on patches of a mesh are checked by the program that has the mesh. */
static int check_inlet(const struct dem_stream *s, const struct dem_domain *d)
{
    const double edge = s->inlet.kind == DEM_INLET_REGION ? 0.5*s->sizes.min : 0.0,
                 radius = 0.5*s->sizes.min;
    double min[3], max[3];

    DEM_REQUIRE(!s->inlet.patch || s->inlet.n > 0, DEM_ERROR_INPUT,
                "%s: patch %s, but no mesh has supplied it; run it in OpenFOAM, or give a "
                "region or a surface",
                s->where, s->inlet.patch);
    dem_inlet_shape_bounds(&s->inlet, min, max);
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(
            fmax(fabs(min[k]), fabs(max[k])) <= dem_max_distance*radius, DEM_ERROR_INPUT,
            "%s: it reaches from %g to %g m along %c, more than "
            "%g radii of %g m from the origin, where double precision does not resolve overlaps; move it",
            s->where, min[k], max[k], "xyz"[k], dem_max_distance, radius);
        DEM_REQUIRE(
            d->periodic[k] || (min[k] + edge >= d->min[k] && max[k] - edge <= d->max[k]),
            DEM_ERROR_INPUT,
            "%s: from %g to %g m along %c it is not inside the domain, %g to %g m; make it smaller, or enlarge the domain",
            s->where, min[k], max[k], "xyz"[k], d->min[k], d->max[k]);
    }
    return DEM_OK;
}

int dem_streams_check(const struct dem_streams *s, const struct dem_domain *d)
{
    for (int k = 0; k < s->streams; k++)
    {
        const struct dem_stream *const one = &s->stream[k];

        DEM_TRY(check_inlet(one, d));
        DEM_TRY(dem_initial_particles_check_spin(one->where, one->spin, 0.5*one->sizes.max));
    }
    for (int k = 0; k < s->outlets; k++)
    {
        DEM_REQUIRE(!s->outlet[k].patch || s->meshed, DEM_ERROR_INPUT,
                    "outlets/%s: patch %s, but there is no mesh; run it in OpenFOAM, or give a "
                    "region",
                    s->outlet[k].name, s->outlet[k].patch);
    }
    return DEM_OK;
}

double dem_stream_amount_due(const struct dem_stream *s, double since, double time)
{
    if (s->at_once)
    {
        return since <= s->start && time >= s->start ? s->rate : 0.0;
    }
    return s->rate*fmax(0.0, fmin(time, s->end) - fmax(since, s->start));
}

double dem_stream_diameter(const struct dem_stream *s, int64_t k)
{
    return dem_size_distribution_draw(&s->sizes, (uint64_t)s->seed, (uint64_t)k);
}

double dem_stream_mass(const struct dem_stream *s, const struct dem_interaction_table *r, int64_t k)
{
    return r->material[s->material].density*
           dem_clump_source_volume(&s->clump, dem_stream_diameter(s, k));
}

double dem_stream_mean_mass(const struct dem_stream *s, const struct dem_interaction_table *r)
{
    return s->clump.shape ? dem_stream_mass(s, r, 0)
                          : r->material[s->material].density*
                                dem_size_distribution_mean_volume(&s->sizes);
}

/* How far inside the mesh a centre starts at a patch [m]: all spheres of a clump must lie in a cell. */
static double depth_behind_patch(const struct dem_stream *s, double radius)
{
    return !s->inlet.patch ? 0.0 : ((s->clump.shape ? 1.0 : 0.0) + behind_face)*radius;
}

double dem_stream_max_travel(const struct dem_stream *s, double ago, double radius)
{
    /* twice, to be above any round-off */
    const double behind = 2.0*depth_behind_patch(s, radius);
    double fastest = 0.0;

    for (size_t t = 0; s->with_fluid && t < s->inlet.n; t++)
    {
        fastest = fmax(fastest, dem_vec_norm(s->inlet.flow[t]));
    }
    return s->inlet.kind == DEM_INLET_REGION
               ? 0.0
               : behind + ago*(fastest + dem_vec_norm(s->velocity) + dem_vec_norm(s->spread));
}

int dem_stream_draw_position(const struct dem_stream *s, const struct dem_stream_trial *t,
                             double x[3], double v[3], double start[3])
{
    const uint64_t seed = (uint64_t)s->seed, number = (uint64_t)t->number, step = (uint64_t)t->step,
                   use = USE_PLACE + 4*(uint64_t)t->trial;
    size_t triangle = 0;
    double u[3], inward[3];

    for (unsigned k = 0; k < 3; k++)
    {
        u[k] = dem_random_unit(seed, number, step, use + k);
    }
    if (s->positions)
    {
        memcpy(x, s->positions[t->number], 3*sizeof *x);
    }
    else if (!dem_inlet_shape_draw(&s->inlet, t->radius, u, x, &triangle))
    {
        return 0;
    }
    const double moving = s->inlet.kind == DEM_INLET_REGION
                              ? 0.0
                              : t->ago*dem_random_unit(seed, number, step, use + 3);

    dem_inlet_shape_inward(&s->inlet, triangle, inward);
    for (unsigned k = 0; k < 3; k++)
    {
        v[k] = (s->with_fluid ? s->inlet.flow[triangle][k] : s->velocity[k])
               + s->spread[k]*(2.0*dem_random_unit(seed, number, 0, USE_SPREAD + k) - 1.0);
        start[k] = x[k];
        x[k] += moving*v[k];
    }
    for (int k = 0; k < 3; k++)
    {
        const double behind = depth_behind_patch(s, t->radius)*inward[k];

        start[k] += behind;
        x[k] += behind;
    }
    return (!s->positions || t->trial == 0) && (!s->inlet.patch || dem_vec_dot(v, inward) > 0.0);
}

/* A box, cylinder or sphere. */
static int is_region(const struct dem_outlet *o)
{
    return !o->plane && !o->patch && !o->wall;
}

int dem_outlet_holds(const struct dem_outlet *o, const double x[3])
{
    if (o->plane)
    {
        return (x[0] - o->shape.from[0])*o->shape.axis[0] +
                   (x[1] - o->shape.from[1])*o->shape.axis[1] +
                   (x[2] - o->shape.from[2])*o->shape.axis[2] >
               0.0;
    }
    return is_region(o) && dem_insertion_shape_contains(&o->shape, x);
}

int dem_outlet_meets(const struct dem_outlet *o, const double from[3], const double step[3],
                     const double part[2])
{
    return is_region(o) && dem_insertion_shape_meets(&o->shape, from, step, part);
}

int dem_streams_ask_residence(const struct dem_streams *s)
{
    int any = 0;

    for (int k = 0; k < s->outlets; k++)
    {
        any |= s->outlet[k].residence > 0.0;
    }
    return any;
}

int dem_streams_have_regions(const struct dem_streams *s)
{
    int any = s->planes > 0;

    for (int k = 0; k < s->outlets; k++)
    {
        any |= is_region(&s->outlet[k]);
    }
    return any;
}
