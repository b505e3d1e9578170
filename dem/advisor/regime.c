/*
 * regime.c -- dimensionless numbers of a scene, and their text in a plan.
 *
 *   density ratio: rho_p/rho_f
 *   solid fraction phi: volume of particles over volume of the domain, if it is closed by walls,
 *       periodic boundaries or a mesh
 *   mass loading: phi rho_p/((1 - phi) rho_f)
 *   Reynolds number: rho_f u d/mu; u is the terminal velocity with the drag law of the scene (of
 *       a single sphere if it has none), or the fluid velocity, if given and larger
 *   relaxation time: m/b at that slip, rho_p d^2/(18 mu f), f = 1 + 0.15 Re^0.687, above Re = 1000
 *       0.44 Re/24 (Schiller and Naumann 1933)
 *   Stokes number of particles in the flow: relaxation time over L/u_f, L the smallest width of the
 *       domain
 *   Stokes number of impacts: m* v/(6 pi mu R*^2) of two particles at the speed v of the normal law
 *       (impactSpeed) (Legendre et al. 2006)
 *   time between collisions: d/(6 phi v), v at most u. Relaxation time shorter: dilute, fluid
 *       forces dominate; longer: dense, collisions dominate
 *       (Crowe, Sommerfeld, Tsuji, Multiphase Flows with Droplets and Particles, 1998)
 *   pressure of an impact: 2/pi E* sqrt(d/R*), d = R* (15 m* v^2/(16 E* R*^3))^(2/5); it yields if
 *       that is above 1.6 Y, Y the yield strength, hence from
 *       v^2 = 16/15 E* R*^3 (1.6 pi Y/(2 E*))^5/m* on (Hertz 1882; Johnson 1985; Thornton 1997)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/regime.h"
#include "advisor/biot.h"
#include "laws/fluid/drag.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* ---- the numbers ---------------------------------------------------------------------------------------------- */

static double length(const double v[3])
{
    return sqrt(v[0]*v[0] + v[1]*v[1] + v[2]*v[2]);
}

/* m3: volume of a domain that is closed on all sides; 0 unknown */
static double domain_volume(const struct dem_plan *p)
{
    return p->run.volume > 0.0 ? p->run.volume
                               : dem_plan_width(p, 0)*dem_plan_width(p, 1)*dem_plan_width(p, 2);
}

/* m: smallest width between planes; 0 if no axis is bounded by planes */
static double narrowest(const struct dem_plan *p)
{
    double smallest = INFINITY;

    for (int axis = 0; axis < 3; axis++)
    {
        const double w = p->state->domain.periodic[axis] ? 0.0 : dem_plan_width(p, axis);

        smallest = w > 0.0 ? fmin(smallest, w) : smallest;
    }
    return isfinite(smallest) ? smallest : 0.0;
}

/* The effect in use of a stage, NULL without one. */
static const struct dem_effect *effect_at(const struct dem_plan *p, enum dem_stage stage)
{
    const struct dem_interaction_table *const r = &p->state->interaction_table;

    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k]->stage == stage)
        {
            return r->effect[k];
        }
    }
    return NULL;
}

/* A number of the effect of a stage; not a number without one, or if it has no such setting. */
static double number_at(const struct dem_plan *p, enum dem_stage stage, const char *entry)
{
    const struct dem_effect *const effect = effect_at(p, stage);
    const void *const settings = effect ? dem_regime_settings(p, effect) : NULL;
    const struct dem_setting *const f =
        settings && effect->settings ? dem_settings_find(effect->settings, entry) : NULL;

    return f ? *(const double *)(const void *)((const char *)settings + f->offset) : NAN;
}

/* The same, 0 in place of not a number. */
static double number_or_zero(const struct dem_plan *p, enum dem_stage stage, const char *entry)
{
    const double number = number_at(p, stage, entry);

    return isgreater(number, 0.0) ? number : 0.0;
}

static int is_adhesive(const struct dem_plan *p)
{
    const struct dem_interaction_table *const r = &p->state->interaction_table;
    int adhesive = 0;

    for (int k = 0; r->classes > 0 && k < r->list[0].entries; k++)
    {
        const struct dem_effect_entry *const entry = &r->list[0].entry[k];

        adhesive |= entry->effect->adhesive && entry->effect->adhesive(entry->settings);
    }
    return adhesive;
}

static int with_drag(const struct dem_interaction_table *r)
{
    int drag = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        drag |= r->effect[k]->drag != DEM_DRAG_NONE;
    }
    return drag;
}

static void set_fluid_numbers(const struct dem_plan *p, struct dem_regime *g)
{
    const struct dem_uniform_fluid *const given = &p->scene->fluid;
    const struct dem_suspension *const b = &g->suspension;
    const double stokes = dem_suspension_response_time(b),
                 sinks = with_drag(&p->state->interaction_table)
                             ? dem_suspension_terminal_velocity(&p->state->interaction_table, b)
                             : 0.0;

    g->flow = given->given ? length(given->velocity) : p->run.speed;
    g->vorticity = given->given ? length(given->vorticity) : p->run.vorticity;
    g->stress = given->given ? length(given->stress) : 0.0;
    /* particles lighter than the fluid rise with the slip of a single sphere */
    g->slip = fmax(b->gravity > 0.0 ? sinks > 0.0 ? sinks : dem_suspension_single_sphere_velocity(b)
                                    : 0.0,
                   g->flow);
    g->reynolds = b->fluid_density*g->slip*b->diameter/b->viscosity;
    g->drag_factor = dem_drag_single_sphere(g->reynolds);
    g->response = stokes/g->drag_factor;
    g->stokes = g->mass*g->speed/(6.0*pi*b->viscosity*g->radius*g->radius);
    g->collision_speed =
        g->slip > 0.0 && g->speed > 0.0 ? fmin(g->slip, g->speed) : fmax(g->slip, g->speed);
    g->collision_time =
        g->solid_fraction > 0.0 && g->collision_speed > 0.0 && p->inventory.all.n > 1
            ? b->diameter/(6.0*g->solid_fraction*g->collision_speed)
            : 0.0;
}

/* m/s: slowest impact that yields, of two equal spheres with the modulus of the scene (too large
   if that is softened); 0 if no material has a yield strength. */
static double yield_speed(const struct dem_interaction_table *r, const struct dem_regime *g)
{
    double smallest = INFINITY;

    for (int m = 0; m < r->materials; m++)
    {
        smallest = r->material[m].yield_strength > 0.0
                       ? fmin(smallest, r->material[m].yield_strength)
                       : smallest;
    }
    return isfinite(smallest) && g->modulus > 0.0
               ? sqrt(16.0/15.0*g->modulus*pow(g->radius, 3.0)/g->mass*
                      pow(1.6*pi*smallest/(2.0*g->modulus), 5.0))
               : 0.0;
}

void dem_regime_set(const struct dem_plan *p, struct dem_regime *g)
{
    const struct dem_interaction_table *const r = &p->state->interaction_table;

    *g = (struct dem_regime){.uniform = p->scene->fluid.given,
                             .particles = (double)p->inventory.all.n,
                             .cell = p->run.cell};
    g->fluid = dem_plan_suspension(p, &g->suspension);
    g->solid_fraction = domain_volume(p) > 0.0 ? p->inventory.all.volume/domain_volume(p) : 0.0;
    g->width = narrowest(p);
    g->mass = 0.5*g->suspension.density*pi/6.0*pow(g->suspension.diameter, 3.0);
    g->weight = 2.0*g->mass*g->suspension.gravity;
    g->radius = 0.25*g->suspension.diameter;
    g->modulus = r->classes > 0 ? r->list[0].pair.reduced_modulus : 0.0;
    g->exponent = effect_at(p, DEM_STAGE_NORMAL) ? effect_at(p, DEM_STAGE_NORMAL)->exponent : 0.0;
    g->speed = number_or_zero(p, DEM_STAGE_NORMAL, "impactSpeed");
    g->friction = number_or_zero(p, DEM_STAGE_TANGENT, "friction");
    g->has_restitution = isfinite(number_at(p, DEM_STAGE_DAMP, "restitution")) != 0;
    g->restitution = g->has_restitution ? number_at(p, DEM_STAGE_DAMP, "restitution")
                     : effect_at(p, DEM_STAGE_DAMP) ? 0.0
                                                    : 1.0;
    g->adhesive = is_adhesive(p);
    g->overlap =
        g->modulus > 0.0
            ? pow(15.0*g->mass*g->speed*g->speed/(16.0*g->modulus*pow(g->radius, 3.0)),
                  0.4)
            : 0.0;
    g->yield_speed = yield_speed(r, g);
    if (g->fluid)
    {
        set_fluid_numbers(p, g);
    }
}

/* ---- text ----------------------------------------------------------------------------------------------------- */

static void write_flow(struct dem_text *t, const struct dem_plan *p, const struct dem_regime *g)
{
    const double ratio = g->suspension.density/g->suspension.fluid_density;

    dem_text_add(t, "    density ratio %.4g", ratio);
    if (g->solid_fraction > 0.0 && g->solid_fraction < 1.0)
    {
        dem_text_add(t, ", solid fraction of the domain %.3g, mass loading %.3g", g->solid_fraction,
                     g->solid_fraction*ratio/(1.0 - g->solid_fraction));
    }
    if (g->reynolds > 0.0)
    {
        dem_text_add(t, ", Reynolds number %.3g", g->reynolds);
    }
    if (g->stokes > 0.0)
    {
        dem_text_add(t, ", Stokes number of impacts %.3g at %g m/s", g->stokes, g->speed);
    }
    if (g->flow > 0.0 && g->width > 0.0)
    {
        dem_text_add(t, ", of particles in the flow %.3g", g->response*g->flow/g->width);
    }
    dem_text_add(t, "\n    relaxation time %.3g s at that Reynolds number, %.3g steps", g->response,
                 g->response/p->step);
    if (p->run.window > 0.0)
    {
        dem_text_add(t, ", %.3g fluid steps", g->response/p->run.window);
    }
    if (g->collision_time > 0.0)
    {
        dem_text_add(t, "; time between collisions %.3g s: %s", g->collision_time,
                     g->response < g->collision_time ? "dilute, fluid forces dominate"
                                                     : "dense, collisions dominate");
    }
    dem_text_add(t, "\n");
}

/* Below 3 diameters a kernel must spread the particle volume over several cells: Peng,
   Doroodchi, Luo, Moghtaderi, AIChE J. 60 (2014) 2000 find 1.6 to be the limit for void fractions
   of single cells, and 3 to 5 common practice. */
static void write_cells(struct dem_text *t, const struct dem_plan *p, const struct dem_regime *g)
{
    const double cell = p->run.cell/dem_plan_sauter_diameter(p);

    if (cell > 0.0)
    {
        dem_text_add(t, "    smallest cell %.3g diameters%s\n", cell,
                     cell < 3.0
                         ? ": below 3 the void fraction must be smoothed by a kernel (Peng et al. "
                           "2014): do not use particleCentre"
                         : "");
    }
    if (p->run.cell > 0.0 && g->solid_fraction > 0.0 && g->solid_fraction < 1.0)
    {
        const double load =
            fmax(g->solid_fraction, g->solid_fraction*g->suspension.density/
                                        g->suspension.fluid_density/(1.0 - g->solid_fraction));
        const int two_way = !p->run.one_way;

        dem_text_add(
            t,
            "    coupling %s: %.2g %% is the larger of mass loading and solid fraction (Elghobashi 1994)\n",
            two_way ? load > 0.01 ? "two-way, on and needed" : "two-way, on but negligible"
            : load > 0.01 ? "one-way though the scene calls for two-way"
                          : "one-way, as the scene calls for",
            100.0*load);
    }
}

static void write_contacts(struct dem_text *t, const struct dem_plan *p, const struct dem_regime *g)
{
    const struct dem_interaction_table *const r = &p->state->interaction_table;
    struct dem_biot biot;
    char line[200];

    dem_biot_number(p, g, &biot);
    if (biot.number > 0.0)
    {
        dem_text_add(t, "    Biot number of %s %s%s %.2g: %s %g\n", biot.material->name,
                     biot.other ? "in contact with " : "in the fluid",
                     biot.other ? biot.other->name : "", biot.number,
                     biot.number > DEM_BIOT_LIMIT
                         ? "the temperature in a particle is not uniform as assumed, the limit is"
                         : "the temperature in a particle is uniform below",
                     DEM_BIOT_LIMIT);
    }

    for (int k = 0; k < r->chosen; k++)
    {
        const struct dem_effect *const e = r->effect[k];
        const void *const settings = e->describe ? dem_regime_settings(p, e) : NULL;

        if (settings && e->describe(settings, g, line, sizeof line))
        {
            dem_text_add(t, "    %s\n", line);
        }
    }
    if (g->speed > 0.0 && g->modulus > 0.0)
    {
        dem_text_add(
            t,
            "    impacts at %g m/s have a contact pressure of %.3g Pa with the modulus of the scene",
            g->speed, 2.0*g->modulus/pi*sqrt(g->overlap));
        if (g->yield_speed > 0.0)
        {
            dem_text_add(t, ", and yield from %.3g m/s on (Thornton 1997)\n", g->yield_speed);
        }
        else
        {
            dem_text_add(
                t,
                ": they yield if the yield strength is below that over 1.6 (materials/NAME/yieldStrength)\n");
        }
    }
}

static void write_verdict(struct dem_text *t, const struct dem_verdict *v)
{
    static const char *const says[] = {"on and needed", "on but negligible",
                                       "off though the scene calls for it"};

    dem_text_add(t, "    %-18s %s", v->effect, says[v->word]);
    if (v->word == DEM_NEGLIGIBLE && isfinite(v->cost))
    {
        dem_text_add(t,
                     v->cost < 0.01 ? " (costs less than 1 %% of the run)"
                                    : " (costs %.0f %% of the run)",
                     100.0*v->cost);
    }
    dem_text_add(t, ": %.2g %% %s", 100.0*v->fraction, v->why);
    if (v->replaces)
    {
        dem_text_add(t, "; in place of %s", v->replaces);
    }
    if (v->missing_setting)
    {
        dem_text_add(t, "; give it %s", v->missing_setting);
    }
    dem_text_add(t, "\n");
}

int dem_plan_regime(struct dem_text *t, struct dem_plan *p)
{
    struct dem_regime g;

    p->verdicts.n = 0;
    if (p->inventory.all.n == 0)
    {
        return DEM_OK;
    }
    dem_regime_set(p, &g);
    dem_verdicts_add(p, &g);
    DEM_TRY(dem_verdicts_measure_costs(p));
    dem_text_add(t, "Regime (needed: more than 1 %%)\n");
    if (g.fluid)
    {
        write_flow(t, p, &g);
        write_cells(t, p, &g);
    }
    write_contacts(t, p, &g);
    for (int k = 0; k < p->verdicts.n; k++)
    {
        write_verdict(t, &p->verdicts.verdict[k]);
    }
    return DEM_OK;
}
