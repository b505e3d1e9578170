/*
 * cost_run.c -- one run of the window, from a fresh start of the scene: its quantities and its
 * processor time.
 *
 * Nothing is written, and there is no energy balance. The processor time is that of the steps, with
 * neighbor lists and migration; reading the scene and sampling are not counted. The impulses on
 * walls are summed only if forces on walls are reported.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/cost.h"
#include "core/clock.h"
#include "effects/effects.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- the scene with other parameters --------------------------------------------------------- */

static int set_entry(struct dem_request *r, const char *path, const char *value)
{
    DEM_REQUIRE(r->sets < 2*DEM_MAX_SETS, DEM_ERROR_INPUT,
                "more than %d overrides; give fewer -set", 2*DEM_MAX_SETS);
    r->set[r->sets][0] = path;
    r->set[r->sets++][1] = value;
    return DEM_OK;
}

/* All Young's moduli, and the stiffness of the normal law if the scene gives one. */
int dem_cost_find_moduli(struct dem_cost *c, const struct dem_dict *scene)
{
    const struct dem_dict *all, *one;

    c->moduli = 0;
    DEM_TRY(dem_dict_sub(scene, "materials", &all));
    for (size_t k = 0; k < dem_dict_count(all) && c->moduli < DEM_COST_MAX_MODULI; k++)
    {
        const char *const name = dem_entry_name(dem_dict_entry(all, k));

        DEM_TRY(dem_dict_sub(all, name, &one));
        snprintf(c->modulus[c->moduli].path, sizeof c->modulus[0].path,
                 "materials/%s/youngsModulus", name);
        DEM_TRY(dem_dict_number(one, "youngsModulus", "Pa", &c->modulus[c->moduli++].value));
    }
    DEM_TRY(dem_dict_sub_if(scene, "effects", &all));
    for (const struct dem_effect *const *e = dem_effects;
         *e && all && c->moduli < DEM_COST_MAX_MODULI; e++)
    {
        one = NULL;
        DEM_TRY((*e)->stage == DEM_STAGE_NORMAL ? dem_dict_sub_if(all, (*e)->name, &one) : DEM_OK);
        if (one && dem_dict_has(one, "stiffness"))
        {
            snprintf(c->modulus[c->moduli].path, sizeof c->modulus[0].path, "effects/%s/stiffness",
                     (*e)->name);
            DEM_TRY(dem_dict_number(one, "stiffness", "N/m", &c->modulus[c->moduli++].value));
        }
    }
    return DEM_OK;
}

static int open_variation(const struct dem_cost *c, const struct dem_cost_variation *k,
                          struct dem **d, struct dem_schedule *s)
{
    char step[32], modulus[DEM_COST_MAX_MODULI][32], friction[DEM_COST_FRICTION_SETTINGS][160];
    struct dem_request r = c->request;

    /* slightly longer than wanted: dem_advance divides the interval into the wanted number of equal
       steps */
    if (k->steps > 0)
    {
        snprintf(step, sizeof step, "%.17g", c->window/c->samples/(double)k->steps*(1.0 + 1e-10));
        DEM_TRY(set_entry(&r, "time/step", step));
        DEM_TRY(set_entry(&r, "time/force", "yes"));
    }
    else
    {
        DEM_TRY(set_entry(&r, "time/step", "auto"));
    }
    if (k->friction)
    {
        r.without = c->friction.law;
        for (int n = 0; n < c->friction.settings; n++)
        {
            snprintf(friction[n], sizeof friction[n], "effects/%s/%s", k->friction,
                     c->friction.setting[n][0]);
            DEM_TRY(set_entry(&r, friction[n], c->friction.setting[n][1]));
        }
    }
    r.without = k->without ? k->without : r.without;
    DEM_TRY(k->precision ? set_entry(&r, "time/precision", k->precision) : DEM_OK);
    for (int m = 0; m < c->moduli && k->stiffness_factor != 1.0; m++)
    {
        snprintf(modulus[m], sizeof modulus[m], "%.17g", k->stiffness_factor*c->modulus[m].value);
        DEM_TRY(set_entry(&r, c->modulus[m].path, modulus[m]));
    }
    return dem_scene_open(c->prog, &r, d, s);
}

int dem_cost_step_limit(const struct dem_cost *c, double stiffness_factor, double *limit)
{
    const struct dem_cost_variation k = {.stiffness_factor = stiffness_factor};
    struct dem_schedule s;
    struct dem *d;

    DEM_TRY(open_variation(c, &k, &d, &s));
    *limit = dem_step_limit(d).limit;
    dem_free(d);
    return DEM_OK;
}

/* ---- samples --------------------------------------------------------------------------------- */

static void sum_ranks(const struct dem_program *prog, double *value, int n)
{
    if (prog->comm != MPI_COMM_NULL)
    {
        MPI_Allreduce(MPI_IN_PLACE, value, n, MPI_DOUBLE, MPI_SUM, prog->comm);
    }
}

struct sums
{
    double kinetic, rotation, height, overlap, force, contacts, max_kinetic;
};

/* Of all particles: sum of m x.up [kg m] and of m [kg] without frozen ones, kinetic energy of
   rotation [J]. */
static void sum_particles(const struct dem_cost *c, const struct dem *d, double sum[3])
{
    struct dem_view v;

    dem_view(d, &v);
    sum[0] = sum[1] = sum[2] = 0.0;
    for (size_t i = 0; i < v.n; i++)
    {
        const double *const x = dem_at(v.position, v.stride, i);
        const double *const w = dem_at(v.spin, v.stride, i);
        const double m = *dem_at(v.mass, v.stride, i), r = *dem_at(v.radius, v.stride, i);
        const uint16_t flags =
            *(const uint16_t *)(const void *)((const char *)v.flags + v.stride*i);

        if (!(flags & 1))
        {
            sum[0] += m*(x[0]*c->up[0] + x[1]*c->up[1] + x[2]*c->up[2]);
            sum[1] += m;
        }
        sum[2] += 0.2*m*r*r*(w[0]*w[0] + w[1]*w[1] + w[2]*w[2]);
    }
    sum_ranks(c->prog, sum, 3);
}

static int sample_walls(const struct dem_cost *c, struct dem *d, double *max_force)
{
    double impulse[3], angular_impulse[3];

    for (int w = 0; w < dem_wall_count(d) && c->wanted[DEM_COST_FORCE]; w++)
    {
        DEM_TRY(dem_wall_impulse(d, w, impulse, angular_impulse));
        *max_force = fmax(*max_force, sqrt(impulse[0]*impulse[0] + impulse[1]*impulse[1]
                                           + impulse[2]*impulse[2])
                                          /(c->window/c->samples));
    }
    return c->wanted[DEM_COST_FORCE] ? dem_wall_impulse_reset(d) : DEM_OK;
}

static int sample(const struct dem_cost *c, struct dem *d, struct sums *s, struct dem_totals *t)
{
    double sum[3];

    DEM_TRY(dem_totals(d, t));
    sum_particles(c, d, sum);
    s->kinetic += t->kinetic;
    s->max_kinetic = fmax(s->max_kinetic, t->kinetic);
    s->rotation += sum[2];
    s->height += sum[1] > 0.0 ? sum[0]/sum[1] : 0.0;
    s->overlap += t->largest_overlap;
    s->contacts += t->particles > 0 ? 2.0*(double)t->contacts/(double)t->particles : 0.0;
    return sample_walls(c, d, &s->force);
}

/* ---- the run --------------------------------------------------------------------------------- */

static int advance(const struct dem_cost *c, struct dem *d, struct sums *s, struct dem_totals *t,
                   double *seconds)
{
    DEM_TRY(dem_totals(d, t));    /* resets the largest overlap */
    DEM_TRY(c->wanted[DEM_COST_FORCE] ? dem_wall_impulse_reset(d) : DEM_OK);
    for (int k = 0; k < c->samples; k++)
    {
        const double before = dem_clock_processor();

        DEM_TRY(dem_advance(d, c->window/c->samples));
        *seconds += dem_clock_processor() - before;
        DEM_TRY(sample(c, d, s, t));
    }
    return DEM_OK;
}

int dem_cost_run(const struct dem_cost *c, const struct dem_cost_variation *k,
                 struct dem_cost_run *run)
{
    const double n = c->samples;
    struct sums s = {.kinetic = 0.0};
    struct dem_schedule schedule;
    struct dem_totals t = {.steps = 0};
    struct dem *d;

    *run = (struct dem_cost_run){.steps = k->steps*c->samples};
    DEM_TRY(open_variation(c, k, &d, &schedule));
    const int status = advance(c, d, &s, &t, &run->seconds);
    const double separation = !status && c->impact.bodies > 0 && t.contacts == 0
                                ? dem_cost_separation_speed(&c->impact, d)
                                : 0.0;

    dem_free(d);
    DEM_TRY(status);
    sum_ranks(c->prog, &run->seconds, 1);
    run->max_kinetic = s.max_kinetic;
    run->value[DEM_COST_KINETIC] = s.kinetic/n;
    run->value[DEM_COST_ROTATION] = s.rotation/n;
    run->value[DEM_COST_HEIGHT] = s.height/n;
    run->value[DEM_COST_OVERLAP] = s.overlap/n;
    run->value[DEM_COST_FORCE] = s.force;
    run->value[DEM_COST_CONTACTS] = s.contacts/n;
    run->value[DEM_COST_RESTITUTION] = separation > 0.0 ? separation/c->impact.speed : NAN;
    return DEM_OK;
}
