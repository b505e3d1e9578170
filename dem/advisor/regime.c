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
#include "advisor/minimum_fluidisation.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

/* ---- the numbers ---------------------------------------------------------------------------------------------- */

/* m3: volume of a domain that is closed on all sides; 0 unknown */
static double domain_volume(const struct dem_plan *p)
{
    const double *const w = p->scene.width;

    return p->run.volume > 0.0 ? p->run.volume : w[0]*w[1]*w[2];
}

/* m: smallest width between planes; 0 if no axis is bounded by planes */
static double narrowest(const struct dem_scene_numbers *s)
{
    double smallest = INFINITY;

    for (int axis = 0; axis < 3; axis++)
    {
        const double w = s->periodic[axis] ? 0.0 : s->width[axis];

        smallest = w > 0.0 ? fmin(smallest, w) : smallest;
    }
    return isfinite(smallest) ? smallest : 0.0;
}

static void set_fluid_numbers(const struct dem_plan *p, struct dem_regime *g)
{
    const struct dem_scene_numbers *const n = &p->scene;
    const struct dem_suspension *const b = &g->suspension;
    const double stokes = dem_suspension_response_time(b),
                 sinks = n->drag_law ? dem_suspension_terminal_velocity(p->d, b) : 0.0;

    g->flow = n->uniform ? n->fluid_speed : p->run.speed;
    g->vorticity = n->uniform ? n->vorticity : p->run.vorticity;
    g->stress = n->stress;
    /* particles lighter than the fluid rise with the slip of a single sphere */
    g->slip = fmax(b->gravity <= 0.0 ? 0.0
                   : sinks > 0.0     ? sinks
                                     : dem_sphere_terminal_velocity(b->diameter, b->density, b->fluid_density,
                                                                    b->viscosity, b->gravity),
                   g->flow);
    g->reynolds = b->fluid_density*g->slip*b->diameter/b->viscosity;
    g->drag_factor = dem_single_sphere_drag(g->reynolds);
    g->response = stokes/g->drag_factor;
    g->stokes = g->mass*g->speed/(6.0*pi*b->viscosity*g->radius*g->radius);
    g->collision_speed =
        g->slip > 0.0 && g->speed > 0.0 ? fmin(g->slip, g->speed) : fmax(g->slip, g->speed);
    g->collision_time =
        g->solid_fraction > 0.0 && g->collision_speed > 0.0 && n->particles > 1.0
            ? b->diameter/(6.0*g->solid_fraction*g->collision_speed)
            : 0.0;
}

/* m/s: slowest impact that yields, of two equal spheres with the modulus of the scene (too large
   if that is softened); 0 if no material has a yield strength. */
static double yield_speed(double yield_strength, const struct dem_regime *g)
{
    return yield_strength > 0.0 && g->modulus > 0.0
               ? sqrt(16.0/15.0*g->modulus*pow(g->radius, 3.0)/g->mass*
                      pow(1.6*pi*yield_strength/(2.0*g->modulus), 5.0))
               : 0.0;
}

void dem_regime_set(const struct dem_plan *p, struct dem_regime *g)
{
    const struct dem_scene_numbers *const n = &p->scene;

    *g = (struct dem_regime){.uniform = n->uniform,
                             .particles = n->particles,
                             .cell = p->run.cell,
                             .modulus = n->modulus,
                             .exponent = n->exponent,
                             .speed = n->impact_speed,
                             .friction = n->friction,
                             .has_restitution = isfinite(n->restitution) != 0,
                             .adhesive = n->adhesive};
    g->fluid = dem_plan_suspension(p, &g->suspension);
    g->solid_fraction = domain_volume(p) > 0.0 ? n->volume/domain_volume(p) : 0.0;
    g->width = narrowest(n);
    g->mass = 0.5*g->suspension.density*pi/6.0*pow(g->suspension.diameter, 3.0);
    g->weight = 2.0*g->mass*g->suspension.gravity;
    g->radius = 0.25*g->suspension.diameter;
    g->restitution = g->has_restitution ? n->restitution : n->damped ? 0.0 : 1.0;
    g->overlap =
        g->modulus > 0.0
            ? pow(15.0*g->mass*g->speed*g->speed/(16.0*g->modulus*pow(g->radius, 3.0)),
                  0.4)
            : 0.0;
    g->yield_speed = yield_speed(n->yield_strength, g);
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
                 g->response/p->scene.step);
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
    const double sauter = p->scene.volume/(pi/6.0*p->scene.squares), cell = p->run.cell/sauter;

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

static void write_biot(struct dem_text *t, const struct dem_plan *p, const struct dem_regime *g)
{
    struct dem_biot biot;

    dem_biot_number(p->d, g->suspension.diameter, g->slip, &biot);
    if (biot.number > 0.0)
    {
        dem_text_add(t, "    Biot number of %s %s%s %.2g: %s %g\n", biot.material,
                     biot.other ? "in contact with " : "in the fluid", biot.other ? biot.other : "",
                     biot.number,
                     biot.number > DEM_BIOT_LIMIT
                         ? "the temperature in a particle is not uniform as assumed, the limit is"
                         : "the temperature in a particle is uniform below",
                     DEM_BIOT_LIMIT);
    }
}

static void write_contacts(struct dem_text *t, const struct dem_plan *p, const struct dem_regime *g)
{
    struct dem_effect_info effect;
    char line[200];

    for (int k = 0; dem_effect_info(p->d, k, &effect); k++)
    {
        if (dem_effect_line(p->d, k, g, line, sizeof line))
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

    dem_text_add(t, "    %-18s %s: %.2g %% %s", v->effect, says[v->word], 100.0*v->fraction, v->why);
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

void dem_plan_regime(struct dem_text *t, const struct dem_plan *p)
{
    struct dem_verdicts verdicts;
    struct dem_regime g;

    if (p->scene.particles == 0.0)
    {
        return;
    }
    dem_regime_set(p, &g);
    dem_verdicts(p, &g, &verdicts);
    dem_text_add(t, "Regime (needed: more than 1 %%)\n");
    if (g.fluid)
    {
        write_flow(t, p, &g);
        write_cells(t, p, &g);
    }
    write_biot(t, p, &g);
    write_contacts(t, p, &g);
    for (int k = 0; k < verdicts.n; k++)
    {
        write_verdict(t, &verdicts.verdict[k]);
    }
}
