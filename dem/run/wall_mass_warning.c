/*
 * wall_mass_warning.c -- free walls and hinges that are too light for the time step, before the run.
 * The limit is the one of a sweep (step/wall_bodies.c), K dt^2 < 0.04 m, with the expected contacts:
 *
 *   k_1 = p F_1/d,  F_1 = (p + 1) m_p v^2/(2 d),  d = v t_c/c      an impact of the largest particle on a wall at rest
 *   K = k_1 (m/(m + m_p))^((p - 1)/(p + 1))                        on the free wall, or, where that is more,
 *   K = N k_1 (L/(N F_1))^(1 - 1/p)                                the load L on N contacts
 *
 *   K, k_1, d   stiffness of all contacts, of one; largest overlap of the impact           [N/m], [m]
 *   m           mass of the wall                                                           [kg]
 *   p, t_c, v   exponent of the normal law F ~ d^p, contact time at impactSpeed v          [1], [s], [m/s]
 *   c           2.943 for p = 3/2 (Hertz), pi for p = 1
 *   m_p         mass of the particle                                                       [kg]
 *   L           given force of the start and weight of the wall, along its axes            [N]
 *   N           particles that lie side by side on the wall, and are there                 [1]
 *
 * A wall that rotates has K r^2 dt^2 < 0.04 I, so it is a free wall of the mass I/r^2 for the impact.
 *
 *   I, r        moment of inertia, the least of several; largest distance of a corner from the axis, or from the
 *               centre of a rotation about all axes                                    [kg m2], [m]
 *
 * Not here: loads on walls that rotate, whose contacts may be anywhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "core/memory.h"
#include "core/vec.h"
#include "dem_numbers.h"
#include "particles/particles.h"
#include "ranks/collect.h"
#include "records/totals.h"
#include "step/wall_bodies.h"
#include "walls/wall_rotation.h"
#include <fenv.h>
#include <math.h>

struct contact                   /* an impact of the largest particle of a material */
{
    double exponent, stiffness, force, mass, diameter, speed;
};

/* Returns 0 for a normal law without contact time. */
static int impact_on_wall(const struct dem_effect_list *list, struct contact *c)
{
    struct dem_pair_class largest = list->pair;
    const double radius = largest.max_radius_sum;

    largest.min_radius = radius;
    largest.min_mass = dem_sphere_volume(radius)*largest.a->density;
    for (int k = 0; k < list->entries; k++)
    {
        const struct dem_effect_entry *const e = &list->entry[k];
        const double v = e->effect->stage == DEM_STAGE_NORMAL && e->effect->contact_time
                             ? dem_settings_number(e->effect->settings, e->settings, "impactSpeed") : 0.0;

        if (v > 0.0 && radius > 0.0)
        {
            const double p = e->effect->exponent, angle = p > 1.0 ? 2.9432751 : 3.14159265358979324,
                         d = v*e->effect->contact_time(e->settings, &largest)/angle,
                         force = 0.5*(p + 1.0)*largest.min_mass*v*v/d;

            *c = (struct contact){p, p*force/d, force, largest.min_mass, 2.0*radius, v};
            return 1;
        }
    }
    return 0;
}

/* Collective. The area on which particles may lie [m2]; across a plane the extent of the bed. */
static double area_of(const struct dem_state *state, const struct dem_wall *of, double diameter)
{
    double area = 1.0;

    if (of->shape == DEM_SHAPE_TRIANGLES)
    {
        return of->area;
    }
    const int normal = fabs(of->normal[0]) > 0.7 ? 0 : fabs(of->normal[1]) > 0.7 ? 1 : 2;

    for (int k = 1; k < 3; k++)
    {
        double along[3] = {0.0, 0.0, 0.0};

        along[(normal + k)%3] = 1.0;
        area *= dem_totals_extent(state, along) + diameter;
    }
    return area;
}

static double load_on(const struct dem_state *state, const struct dem_wall_body *b)
{
    double given[DEM_TIME_TABLE_COLUMNS], gravity[3], sum[3], along[3] = {0.0, 0.0, 0.0};

    dem_interaction_table_gravity(&state->interaction_table, gravity);
    dem_wall_body_load(b, fmax(state->time, b->start), given);
    for (int k = 0; k < 3; k++)
    {
        sum[k] = given[k] + b->weighs*gravity[k];
    }
    for (int k = 0; k < b->axes; k++)
    {
        along[k] = dem_vec_dot(sum, b->axis[k]);
    }
    return dem_vec_norm(along);
}

/* Stiffness [N/m] that the impact of one particle finds at a free wall of this mass. */
static double impact_stiffness(const struct contact *c, double mass)
{
    return c->stiffness*pow(mass/(mass + c->mass), (c->exponent - 1.0)/(c->exponent + 1.0));
}

/* The least mass for a load, or 0, and for an impact. */
static double least_mass(const struct contact *c, double load_stiffness, double dt)
{
    const double per_stiffness = dt*dt/DEM_WALL_BODY_MAX_SWING;
    double least = c->stiffness*per_stiffness;

    for (int k = 0; k < 40; k++)
    {
        least = impact_stiffness(c, least)*per_stiffness;
    }
    return fmax(least, load_stiffness*per_stiffness);
}

/* Collective. A line when the wall is too light for this contact. */
static int describe(const struct dem *d, const struct dem_wall *of, const struct dem_wall_body *b,
                    const struct contact *c, double most, struct dem_text *t)
{
    const double fit = floor(area_of(&d->state, of, c->diameter)/(c->diameter*c->diameter)),
                 contacts = fmax(1.0, fmin(fit, most)), load = load_on(&d->state, b),
                 share = load/(contacts*c->force),
                 pressed = share > 0.0 ? contacts*c->stiffness*pow(share, 1.0 - 1.0/c->exponent) : 0.0,
                 hit = impact_stiffness(c, b->mass), dt = d->step, least = least_mass(c, pressed, dt),
                 swing = fmax(pressed, hit)/b->mass;

    if (b->mass >= least)
    {
        return 0;
    }
    dem_text_add(t, "walls/%s/motion: %.3g kg is too light for the step %.3g s: ", of->name, b->mass, dt);
    if (pressed > hit)
    {
        dem_text_add(t, "its load, %.3g N on %.0f contacts, meets %.3g N/m", load, contacts, pressed);
    }
    else
    {
        dem_text_add(t, "the impact of one particle at impactSpeed, %g m/s, meets %.3g N/m", c->speed, hit);
    }
    dem_text_add(t, "; by this estimate, use at least %.3g kg, a time/step of at most %.3g s, or type servo\n", least,
                 sqrt(DEM_WALL_BODY_MAX_SWING/swing));
    return 1;
}

/* Collective. The largest distance of a corner of a wall from the point about which it rotates, or from the axis, if
   not NULL [m]. */
static int find_arm(struct dem *d, int wall, const double centre[3], const double *axis, double *arm)
{
    const size_t triangles = d->state.walls.wall[wall].triangles;
    double *corner, square = 0.0;
    int status = DEM_NEW(corner, 9*triangles + 1);

    status = dem_sim_agree(d, status);
    status = status ? status : dem_wall_corners(d, wall, corner);
    for (size_t k = 0; k < 3*triangles && !status && d->state.decomposition.rank == 0; k++)
    {
        double away[3], across[3];

        dem_vec_minus(corner + 3*k, centre, away);
        dem_vec_cross(axis ? axis : away, away, across);
        square = fmax(square, axis ? dem_vec_dot(across, across) : dem_vec_dot(away, away));
    }
    dem_memory_free(corner);
    dem_collect_max_double(&d->state.decomposition, &square, 1);
    *arm = sqrt(square);
    return status;
}

/* Collective. A line when the wall has too small a moment of inertia for this contact. */
static int describe_rotation(struct dem *d, int wall, const struct dem_wall_body *b, const struct contact *c,
                             struct dem_text *t)
{
    const int hinge = b->kind == DEM_WALL_BODY_HINGE;
    const double I = hinge ? b->mass : dem_wall_rotation_least_inertia(&b->rotation), dt = d->step;
    double centre[3], arm;

    dem_wall_body_centre(b, centre);
    if (find_arm(d, wall, centre, hinge ? b->axis[0] : b->rotation.axes == 1 ? b->rotation.axis : NULL, &arm))
    {
        return 0;
    }
    const double least = arm*arm*least_mass(c, 0.0, dt);

    if (I >= least)
    {
        return 0;
    }
    const double hit = impact_stiffness(c, I/(arm*arm));

    dem_text_add(t, "walls/%s/motion: %.3g kg m2 is too little inertia for the step %.3g s: the impact of one particle "
                 "at impactSpeed, %g m/s, meets %.3g N/m, at most %.3g m from the %s; by this estimate, use at least "
                 "%.3g kg m2, or a time/step of at most %.3g s\n", d->state.walls.wall[wall].name, I, dt, c->speed, hit,
                 arm, !hinge && b->rotation.axes == 3 ? "centre" : "axis", least,
                 sqrt(DEM_WALL_BODY_MAX_SWING*I/(hit*arm*arm)));
    return 1;
}

int dem_wall_mass_text(struct dem *d, double particles, const char **text)
{
    static _Thread_local struct dem_text t;
    const struct dem_state *const state = &d->state;
    const struct dem_interaction_table *const r = &state->interaction_table;
    fenv_t caller;

    dem_text_free(&t);
    feholdexcept(&caller);
    for (int k = 0; k < state->walls.walls; k++)
    {
        const struct dem_wall *const of = &state->walls.wall[k];
        const struct dem_wall_body *const b = dem_walls_body(&state->walls, k);
        int said = !b || b->kind == DEM_WALL_BODY_SERVO;

        for (int s = 0; s < r->classes && !said; s++)
        {
            struct contact c;

            if (r->list[s].pair.with_wall && r->list[s].pair.b == &r->material[of->material]
                && impact_on_wall(&r->list[s], &c))
            {
                said = b->kind == DEM_WALL_BODY_FREE && describe(d, of, b, &c, particles, &t);
                said |= (b->kind == DEM_WALL_BODY_HINGE || b->rotation.axes > 0)
                        && describe_rotation(d, k, b, &c, &t);
            }
        }
    }
    fesetenv(&caller);
    *text = t.text ? t.text : "";
    return t.status ? t.status : dem_collect_status(&state->decomposition);
}
