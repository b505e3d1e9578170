/*
 * impacts.h -- contact batches filled by hand, and impacts of two bodies in each row, integrated by
 * the leapfrog of the core.
 *
 * Every row is an impact of two spheres, or of a sphere on the plane z = 0. Rows differ in the
 * contact phase: when, within a time step, the surfaces touch. Means over the rows therefore depend
 * little on the step.
 *
 *   struct impacts w;
 *   impacts_spheres(&w, &glass, &glass, 0.01, 0.01);    or impacts_wall(&w, &glass, &glass, 0.01)
 *   impacts_add(&w, &dem_hertz, "impactSpeed", 1.0);    an effect with one setting
 *   impacts_aim(&w, 16, dt, normal_speed); then velocities and spins may be set by hand
 *   impacts_impact(&w, dt, most_steps);                 until all rows have touched and separated
 *
 * Lever arms are the radii, not shortened by the overlap, as in the closed forms.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef TESTS_EFFECTS_IMPACTS_H
#define TESTS_EFFECTS_IMPACTS_H

#include "laws/interaction_table.h"
#include "laws/effects.h"
#include "unit/tap.h"

#include <stdlib.h>
#include <string.h>

enum
{
    IMPACTS_EFFECTS = 4,
    IMPACTS_HISTORY = 4
};

struct impacts_effect
{
    const struct dem_effect *effect;
    /* large enough for any settings struct, aligned */
    double settings[32];
    _Alignas(64) double column[IMPACTS_HISTORY][DEM_BATCH_ROWS];
    double *history[IMPACTS_HISTORY];
};

struct impacts
{
    struct dem_pair_class pair;
    /* the wall: radius 0, mass 0 for infinite */
    double radius[2], mass[2];
    /* m/s2, gravity on body i along -z; set it for a contact at rest */
    double weight;
    int effects;
    struct impacts_effect effect_entry[IMPACTS_EFFECTS];
    struct dem_contact_batch b;

    double x[2][3][DEM_BATCH_ROWS], v[2][3][DEM_BATCH_ROWS],
        w[2][3][DEM_BATCH_ROWS];    /* v, w: half a step behind x */
    double touched[DEM_BATCH_ROWS], peak_force[DEM_BATCH_ROWS], peak_overlap[DEM_BATCH_ROWS];
    double normal_impulse[DEM_BATCH_ROWS],
        friction_impulse[DEM_BATCH_ROWS];         /* N s, of max(fn, 0) and of |ft| */
    double friction;                                      /* given: worst_friction is measured */
    /* N, largest |ft| - friction*max(fn, 0) of all rows and steps */
    double worst_friction;
    int steps_touching[DEM_BATCH_ROWS];
};

static inline struct dem_material material(const char *name, double E, double nu, double rho)
{
    struct dem_material m = {.density = rho, .youngs_modulus = E, .poissons_ratio = nu};

    snprintf(m.name, sizeof m.name, "%s", name);
    return m;
}

static inline double sphere_mass(double radius, double density)
{
    return 4.0/3.0*3.14159265358979324*radius*radius*radius*density;
}

/* E* and G* of the class; a rigid wall has an infinite modulus and adds nothing */
static inline void impacts_class(struct impacts *w, const struct dem_material *a,
                                 const struct dem_material *b, int wall)
{
    double e = 0.0, g = 0.0;
    const struct dem_material *const both[2] = {a, b};

    for (int k = 0; k < 2; k++)
    {
        const double nu = both[k]->poissons_ratio, E = both[k]->youngs_modulus;

        e += isfinite(E) ? (1.0 - nu*nu)/E : 0.0;
        g += isfinite(E) ? 2.0*(2.0 - nu)*(1.0 + nu)/E : 0.0;
    }
    w->pair = (struct dem_pair_class){.a = a, .b = b, .with_wall = wall, .reduced_modulus = 1.0/e,
                                      .reduced_shear = 1.0/g, .exponent = 1.0};
}

static inline void impacts_spheres(struct impacts *w, const struct dem_material *a,
                                   const struct dem_material *b, double radius_a, double radius_b)
{
    memset(w, 0, sizeof *w);
    impacts_class(w, a, b, 0);
    w->radius[0] = radius_a;
    w->radius[1] = radius_b;
    w->mass[0] = sphere_mass(radius_a, a->density);
    w->mass[1] = sphere_mass(radius_b, b->density);
    w->pair.min_radius = radius_a*radius_b/(radius_a + radius_b);
    w->pair.min_mass = w->mass[0]*w->mass[1]/(w->mass[0] + w->mass[1]);
}

static inline void impacts_wall(struct impacts *w, const struct dem_material *a,
                                const struct dem_material *b, double radius)
{
    memset(w, 0, sizeof *w);
    impacts_class(w, a, b, 1);
    w->radius[0] = radius;
    w->mass[0] = sphere_mass(radius, a->density);
    w->pair.min_radius = radius;
    w->pair.min_mass = w->mass[0];
}

/* 4/3 E* sqrt(R*): F = this d^1.5 */
static inline double impacts_hertz(const struct impacts *w)
{
    return 4.0/3.0*w->pair.reduced_modulus*sqrt(w->pair.min_radius);
}

/* duration of an elastic Hertzian impact */
static inline double impacts_contact_time(const struct impacts *w, double speed)
{
    const double E = w->pair.reduced_modulus, m = w->pair.min_mass, R = w->pair.min_radius;

    return 2.8682656992*pow(m*m/(R*E*E*speed), 0.2);
}

/* set one number or choice (by its index), check that all required settings are given, prepare; 0
   or the status */
static inline int apply_setting(const struct dem_effect *effect, void *settings,
                         const struct dem_pair_class *pair, const char *name, double value)
{
    const struct dem_setting *const f = dem_settings_find(effect->settings, name);

    if (f && (f->kind == DEM_SETTING_CHOICE || f->kind == DEM_SETTING_SWITCH))
    {
        const int choice = (int)value;

        memcpy((char *)settings + f->offset, &choice, sizeof choice);
    }
    else
    {
        DEM_TRY(dem_settings_set_number(effect->settings, settings, effect->name, name, &value, 1));
    }
    DEM_TRY(dem_settings_check_complete(effect->settings, settings, effect->name));
    return effect->prepare ? effect->prepare(settings, pair) : DEM_OK;
}

/* append an effect with one setting; more by apply_setting(w.effect_entry[k].effect,
   w.effect_entry[k].settings, &w.pair, ...) */
static inline struct impacts_effect *impacts_add(struct impacts *w, const struct dem_effect *effect,
                                                 const char *name, double value)
{
    struct impacts_effect *const l = &w->effect_entry[w->effects++];

    l->effect = effect;
    for (int k = 0; k < IMPACTS_HISTORY; k++)
    {
        l->history[k] = l->column[k];
    }
    if (effect->stage == DEM_STAGE_NORMAL)
    {
        w->pair.exponent = effect->exponent;
    }
    if (effect->size > sizeof l->settings)
    {
        printf("Bail out! settings of %s are larger than the test's buffer\n", effect->name);
        exit(1);
    }
    dem_settings_set_defaults(effect->settings, l->settings);
    if (apply_setting(effect, l->settings, &w->pair, name, value))
    {
        printf("Bail out! %s\n", dem_error_text());
        exit(1);
    }
    return l;
}

/* n rows, body i over body j (or the plane) along z; gaps such that contact begins in the first
   step, at n evenly spaced phases */
static inline void impacts_aim(struct impacts *w, int n, double dt, double speed)
{
    memset(w->x, 0, sizeof w->x);
    memset(w->v, 0, sizeof w->v);
    memset(w->w, 0, sizeof w->w);
    w->b.n = n;
    for (int c = 0; c < n; c++)
    {
        w->x[0][2][c] = w->radius[0] + w->radius[1] + speed*dt*((double)c + 0.5)/(double)n;
        w->v[0][2][c] = -speed;
        w->touched[c] = w->peak_force[c] = w->peak_overlap[c] = w->normal_impulse[c] =
            w->friction_impulse[c] = 0.0;
        w->steps_touching[c] = 0;
    }
    for (int k = 0; k < w->effects; k++)
    {
        memset(w->effect_entry[k].column, 0, sizeof w->effect_entry[k].column);
    }
    w->worst_friction = -1e300;
}

static inline double dot(const double a[3], const double b[3])
{
    return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

static inline void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1]*b[2] - a[2]*b[1];
    out[1] = a[2]*b[0] - a[0]*b[2];
    out[2] = a[0]*b[1] - a[1]*b[0];
}

/* the geometry of row c, as the core's sweep would fill it */
static inline void impacts_gather(struct impacts *w, int c, double dt)
{
    struct dem_contact_batch *const b = &w->b;
    const int wall = w->pair.with_wall;
    double r[3], h[3], v[3], spin[3], turn[3];

    for (int k = 0; k < 3; k++)
    {
        r[k] = wall && k < 2 ? 0.0 : w->x[0][k][c] - w->x[1][k][c];
        v[k] = w->v[0][k][c] - w->v[1][k][c];
        h[k] = r[k] - (wall && k < 2 ? 0.0 : 0.5*dt*v[k]);
        spin[k] = w->radius[0]*w->w[0][k][c] + w->radius[1]*w->w[1][k][c];
    }
    const double distance = sqrt(dot(r, r)), before = sqrt(dot(h, h));

    for (int k = 0; k < 3; k++)
    {
        r[k] /= distance;
        h[k] /= before;
    }
    const double overlap = w->radius[0] + w->radius[1] - distance;

    b->nx[c] = r[0], b->ny[c] = r[1], b->nz[c] = r[2];
    b->hx[c] = h[0], b->hy[c] = h[1], b->hz[c] = h[2];
    b->overlap[c] = overlap > 0.0 ? overlap : 0.0;
    b->touching[c] = overlap > 0.0 ? 1.0 : 0.0;
    b->reduced_radius[c] = w->pair.min_radius;
    b->reduced_mass[c] = w->pair.min_mass;
    b->vn[c] = dot(v, r);
    cross(spin, h, turn);
    b->sx[c] = v[0] - dot(v, h)*h[0] - turn[0];
    b->sy[c] = v[1] - dot(v, h)*h[1] - turn[1];
    b->sz[c] = v[2] - dot(v, h)*h[2] - turn[2];
    b->wx[c] = w->w[0][0][c] - w->w[1][0][c];
    b->wy[c] = w->w[0][1][c] - w->w[1][1][c];
    b->wz[c] = w->w[0][2][c] - w->w[1][2][c];
    b->kn[c] = b->kt[c] = b->eta[c] = b->fn[c] = b->fx[c] = b->fy[c] = b->fz[c] = 0.0;
    b->mx[c] = b->my[c] = b->mz[c] = 0.0;
}

static inline void impacts_kick(struct impacts *w, int c, double dt)
{
    const struct dem_contact_batch *const b = &w->b;
    const double n[3] = {b->nx[c], b->ny[c], b->nz[c]}, ft[3] = {b->fx[c], b->fy[c], b->fz[c]};
    const double moment[3] = {b->mx[c], b->my[c], b->mz[c]};
    double turn[3];

    cross(n, ft, turn);
    for (int side = 0; side < 2 && w->mass[side] > 0.0; side++)
    {
        const double sign = side ? -1.0 : 1.0, m = w->mass[side], R = w->radius[side];

        for (int k = 0; k < 3; k++)
        {
            w->v[side][k][c] += dt*sign*(b->fn[c]*n[k] + ft[k])/m;
            w->w[side][k][c] -= dt*(R*turn[k] - sign*moment[k])/
                                (0.4*m*R*R);    /* contact point at -R n of i, +R n of j */
        }
    }
    w->v[0][2][c] -= dt*w->weight;

    const double friction = sqrt(dot(ft, ft)), push = b->fn[c] > 0.0 ? b->fn[c] : 0.0;

    w->normal_impulse[c] += dt*push;
    w->friction_impulse[c] += dt*friction;
    w->worst_friction = fmax(w->worst_friction, friction - w->friction*push);
    w->peak_force[c] = fmax(w->peak_force[c], b->fn[c]);
    w->peak_overlap[c] = fmax(w->peak_overlap[c], b->overlap[c]);
}

/* one leapfrog step: drift, forces at the new position with the mid-step velocity, kick */
static inline void impacts_step(struct impacts *w, double dt)
{
    w->b.dt = dt;
    for (int c = 0; c < w->b.n; c++)
    {
        for (int k = 0; k < 3; k++)
        {
            w->x[0][k][c] += dt*w->v[0][k][c];
            w->x[1][k][c] += dt*w->v[1][k][c];
        }
        impacts_gather(w, c, dt);
    }
    for (int k = 0; k < w->effects; k++)
    {
        w->effect_entry[k].effect->apply(w->effect_entry[k].settings, &w->b,
                                         w->effect_entry[k].history);
    }
    for (int c = 0; c < w->b.n; c++)
    {
        const double touching = w->b.touching[c];

        for (int k = 0; k < w->effects; k++)
        {
            for (int m = 0;
                 w->effect_entry[k].effect->history && w->effect_entry[k].effect->history[m]; m++)
            {
                w->effect_entry[k].column[m][c] =
                    touching > 0.0 ? w->effect_entry[k].column[m][c] : 0.0;
            }
        }
        impacts_kick(w, c, dt);
        w->steps_touching[c] += touching > 0.0;
    }
}

/* one row: body i lies at rest on the plane, pressed by its weight at this overlap */
static inline void impacts_rest(struct impacts *w, double weight, double overlap)
{
    impacts_aim(w, 1, 0.0, 0.0);
    w->weight = weight;
    w->x[0][2][0] = w->radius[0] - overlap;
}

/* step until every row has touched and separated; number of steps, or -1 if some still touch after
   most_steps */
static inline int impacts_impact(struct impacts *w, double dt, int most_steps)
{
    for (int s = 1; s <= most_steps; s++)
    {
        int parted = 0;

        impacts_step(w, dt);
        for (int c = 0; c < w->b.n; c++)
        {
            w->touched[c] = w->b.touching[c] > 0.0 ? 1.0 : w->touched[c];
            parted += w->touched[c] > 0.0 && w->b.touching[c] == 0.0 && w->b.vn[c] > 0.0;
        }
        if (parted == w->b.n)
        {
            return s;
        }
    }
    return -1;
}

static inline double mean(const double *value, int n)
{
    double sum = 0.0;

    for (int c = 0; c < n; c++)
    {
        sum += value[c];
    }
    return sum/(double)n;
}

/* mean over the rows of the speed of separation */
static inline double impacts_rebound_speed(const struct impacts *w)
{
    double sum = 0.0;

    for (int c = 0; c < w->b.n; c++)
    {
        sum += w->v[0][2][c] - w->v[1][2][c];
    }
    return sum/(double)w->b.n;
}

#endif
