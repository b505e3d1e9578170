/*
 * cost_closed_forms.c -- closed forms of the head-on impact of two bodies.
 *
 *   restitution e                      1 without damping, `restitution` of dry (attraction
 *                                      allowed); none for other damping laws
 *   kinetic energy after the impact    K - (1 - e^2) m* v^2/2
 *   largest overlap without damping    hertz  (15 m* v^2/(16 E* sqrt(R*)))^(2/5)
 *                                      hooke  v sqrt(m* /k)
 *
 *   m*, R*, E*   reduced mass, radius, modulus                     [kg], [m], [Pa]
 *   v            approach speed                                    [m/s]
 *   k            stiffness of hooke, given in the scene            [N/m]
 *
 * Limits: two particles, or one and a plane at rest, on one line, without spin, with contact forces
 * only; other scenes have no closed form here. Impacts with hookeHysteresis, jkr and stokes have
 * one (tests/physics), with constants that are not in the scene.
 *
 * Source: Hertz 1882 as in Johnson, Contact Mechanics (1985), 11.4; for e of dry see
 * effects/contact/restitution.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* strtok_r */
#include "app/cost.h"
#include "effects/effects.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static double dot(const double a[3], const double b[3])
{
    return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

struct body
{
    double x[3], v[3], w[3], mass, radius;
};

static void read_body(const struct dem_view *v, size_t i, struct body *b)
{
    memcpy(b->x, dem_at(v->position, v->stride, i), sizeof b->x);
    memcpy(b->v, dem_at(v->velocity, v->stride, i), sizeof b->v);
    memcpy(b->w, dem_at(v->spin, v->stride, i), sizeof b->w);
    b->mass = *dem_at(v->mass, v->stride, i);
    b->radius = *dem_at(v->radius, v->stride, i);
}

/* Both bodies in the order of their ids, which does not change. */
static void read_bodies(const struct dem *d, struct body b[2])
{
    struct dem_view v;

    dem_view(d, &v);
    memset(b, 0, 2*sizeof *b);
    for (size_t i = 0; i < v.n && i < 2; i++)
    {
        const int64_t id = *(const int64_t *)(const void *)((const char *)v.id + v.stride*i);
        const int64_t other =
            *(const int64_t *)(const void *)((const char *)v.id + v.stride*(v.n - 1 - i));

        read_body(&v, i, &b[v.n == 2 && id > other]);
    }
}

/* Normal of the only wall, if it is a plane at rest; 0: it is not. */
static int plane_of(const struct dem *d, double normal[3])
{
    const struct dem_dict *walls, *wall;
    const char *type;

    if (dem_wall_count(d) != 1 || dem_dict_sub_if(dem_scene_dict(d), "walls", &walls) || !walls
        || dem_dict_sub_if(walls, dem_wall_name(d, 0), &wall) || !wall
        || dem_dict_word(wall, "type", &type) || strcmp(type, "plane") != 0
        || dem_dict_has(wall, "motion") || dem_dict_has(wall, "surfaceVelocity")
        || dem_dict_has(wall, "surfaceRotation"))
    {
        return 0;
    }
    if (dem_dict_vector(wall, "normal", "1", normal))
    {
        return 0;
    }
    const double size = sqrt(dot(normal, normal));

    for (int k = 0; k < 3; k++)
    {
        normal[k] /= size;
    }
    return 1;
}

double dem_cost_separation_speed(const struct dem_cost_impact *p, const struct dem *d)
{
    struct body b[2];

    read_bodies(d, b);
    const double rate[3] = {b[0].v[0] - b[1].v[0], b[0].v[1] - b[1].v[1], b[0].v[2] - b[1].v[2]};

    return dot(rate, p->normal);
}

/* 1: an impact of two bodies under this effect ends when they part. Bonds and films may hold or slow
   them further; body and fluid forces act all the time. */
static int ends_with_contact(const struct dem_effect *e)
{
    return e && (e->stage < DEM_STAGE_BOND || (e->stage == DEM_STAGE_FILM && e->adhesive));
}

/* 1: all effects act along the line of centres, or across it only with tangential motion. */
static int only_contacts(const struct dem *d)
{
    char acting[800], *word, *rest;

    snprintf(acting, sizeof acting, "%s", dem_effect_names(d));
    for (word = strtok_r(acting, " ", &rest); word; word = strtok_r(NULL, " ", &rest))
    {
        if (!ends_with_contact(dem_effects_find(word)))
        {
            return 0;
        }
    }
    return 1;
}

void dem_cost_find_impact(struct dem_cost *c, const struct dem *d)
{
    struct dem_cost_impact *const p = &c->impact;
    struct body b[2];

    p->bodies = 0;
    if (c->prog->ranks > 1 || c->particles > 2 || c->particles < 1 || !only_contacts(d))
    {
        return;
    }
    read_bodies(d, b);
    for (int k = 0; k < 3; k++)
    {
        p->normal[k] = b[0].x[k] - b[1].x[k];
    }
    const double distance = sqrt(dot(p->normal, p->normal));

    for (int k = 0; k < 3; k++)
    {
        p->normal[k] /= distance;
    }
    if (c->particles == 1 ? !plane_of(d, p->normal) : dem_wall_count(d) > 0 || distance == 0.0)
    {
        return;
    }
    const double rate[3] = {b[0].v[0] - b[1].v[0], b[0].v[1] - b[1].v[1], b[0].v[2] - b[1].v[2]};
    const double speed = -dot(rate, p->normal);
    const double tangential = dot(rate, rate) - speed*speed;
    const double spin = dot(b[0].w, b[0].w) + dot(b[1].w, b[1].w);

    if (speed > 0.0 && tangential <= 1e-18*speed*speed && spin == 0.0)
    {
        *p = (struct dem_cost_impact){.bodies = (int)c->particles,
                                      .normal = {p->normal[0], p->normal[1], p->normal[2]},
                                      .speed = speed,
                                      .mass = {b[0].mass, b[1].mass},
                                      .radius = {b[0].radius, b[1].radius}};
    }
}

/* ---- closed forms ---------------------------------------------------------------------------- */

static double reduced(const double value[2], int bodies)
{
    return bodies == 2 ? value[0]*value[1]/(value[0] + value[1]) : value[0];
}

/* Reduced modulus E* [Pa] of two bodies of the same material; 0: the scene has more than one
   material. */
static int modulus(const struct dem_dict *scene, double *reduced_modulus)
{
    const struct dem_dict *all, *one;
    double E, nu;

    if (dem_dict_sub(scene, "materials", &all) || dem_dict_count(all) != 1
        || dem_dict_sub(all, dem_entry_name(dem_dict_entry(all, 0)), &one)
        || dem_dict_number(one, "youngsModulus", "Pa", &E)
        || dem_dict_number_or(one, "poissonsRatio", "1", 0.3, &nu))
    {
        return 0;
    }
    *reduced_modulus = 0.5*E/(1.0 - nu*nu);
    return 1;
}

/* Largest overlap [m] of an elastic impact; 0: no closed form. */
static double largest_overlap(const struct dem_cost_impact *p, const struct dem_dict *scene,
                              const struct dem_dict *effects)
{
    const double m = reduced(p->mass, p->bodies), R = reduced(p->radius, p->bodies), v = p->speed;
    const struct dem_dict *law;
    double k = 0.0;

    if (dem_dict_sub_if(effects, "hertz", &law) == DEM_OK && law)
    {
        double E;
        const int given = !dem_dict_number_or(law, "stiffness", "Pa", 0.0, &k) && k > 0.0;

        E = given ? 0.75*k : 0.0;
        return given || modulus(scene, &E) ? pow(15.0/16.0*m*v*v/(E*sqrt(R)), 0.4) : 0.0;
    }
    if (dem_dict_sub_if(effects, "hooke", &law) == DEM_OK && law
        && !dem_dict_number_or(law, "stiffness", "N/m", 0.0, &k) && k > 0.0)
    {
        return v*sqrt(m/k);
    }
    return 0.0;
}

/* 1: an effect that changes restitution and has no closed form here. */
static int has_other_losses(const struct dem_dict *effects)
{
    static const char *const known[] = {"hertz", "hooke", "dry"};

    for (const struct dem_effect *const *e = dem_effects; *e; e++)
    {
        const enum dem_stage stage = (*e)->stage;
        int other = stage == DEM_STAGE_NORMAL || stage == DEM_STAGE_DAMP || stage == DEM_STAGE_FILM;

        for (size_t k = 0; k < sizeof known/sizeof known[0]; k++)
        {
            other &= strcmp((*e)->name, known[k]) != 0;
        }
        if (other && dem_dict_has(effects, (*e)->name))
        {
            return 1;
        }
    }
    return 0;
}

/* Restitution; below 0: no closed form. */
static double restitution(const struct dem_dict *effects)
{
    const struct dem_dict *dry;
    const char *attraction;
    double e = 1.0;

    if (has_other_losses(effects))
    {
        return -1.0;
    }
    if (dem_dict_sub_if(effects, "dry", &dry) || !dry)
    {
        return dry ? -1.0 : 1.0;
    }
    return dem_dict_number(dry, "restitution", "1", &e)
                || dem_dict_word_or(dry, "attraction", "allowed", &attraction)
                || strcmp(attraction, "allowed") != 0
             ? -1.0
             : e;
}

static void set_closed_form(struct dem_cost *c, int quantity, double value)
{
    c->has_closed_form[quantity] = c->wanted[quantity];
    c->closed_form[quantity] = value;
}

void dem_cost_closed_forms(struct dem_cost *c, struct dem *d)
{
    const struct dem_dict *const scene = dem_scene_dict(d), *effects;
    const struct dem_cost_impact *const p = &c->impact;
    struct dem_totals t;

    if (p->bodies == 0 || dem_dict_has(scene, "pairs")
        || dem_dict_sub_if(scene, "effects", &effects) || !effects || dem_totals(d, &t))
    {
        return;
    }
    const double e = restitution(effects), m = reduced(p->mass, p->bodies);

    if (e <= 0.0)    /* after e = 0 the time of separation is not known */
    {
        return;
    }
    set_closed_form(c, DEM_COST_RESTITUTION, e);
    set_closed_form(c, DEM_COST_KINETIC, t.kinetic - 0.5*(1.0 - e*e)*m*p->speed*p->speed);
    if (e == 1.0 && largest_overlap(p, scene, effects) > 0.0)
    {
        const double smaller = p->bodies == 2 ? fmin(p->radius[0], p->radius[1]) : p->radius[0];

        set_closed_form(c, DEM_COST_OVERLAP, 0.5*largest_overlap(p, scene, effects)/smaller);
    }
}
