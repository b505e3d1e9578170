/*
 * regime.c -- the numbers that decide which effects a scene needs, and the lines that tell them and the verdicts.
 *
 *   density ratio     rho_p/rho_f
 *   solid fraction    volume of particles over that of the room, where walls, a periodic domain or a mesh close one: phi
 *   mass loading      phi rho_p/((1 - phi) rho_f)
 *   Reynolds number   rho_f u d/mu; u is the speed at which a single one sinks by the scene's law of drag (the lone sphere's, where it has
 *                     none), or the fluid's, if given and faster
 *   relaxation time   m/b at that slip: rho_p d^2/(18 mu f), f = 1 + 0.15 Re^0.687, above Re = 1000 0.44 Re/24     Schiller and Naumann 1933
 *   Stokes number     of particles in the flow: relaxation time over L/u_f, L the narrowest width of the room
 *                     of impacts: m* v/(6 pi mu R*^2) of two at the speed v of the normal law (impactSpeed)        Legendre et al. 2006
 *   from collision to collision   d/(6 phi v), v no faster than u      Crowe, Sommerfeld, Tsuji, Multiphase Flows with Droplets and Particles, 1998:
 *                     where the relaxation time is shorter the fluid rules (dilute), where longer collisions do (dense)
 *   Bond number       3/2 pi w R* over the weight; sticks below sqrt(2 7.09 (w^5 R*^4/E*^2)^(1/3)/m*)             Thornton and Ning 1998
 *   pressure of an impact   2/pi E* sqrt(d/R*), d = R* (15 m* v^2/(16 E* R*^3))^(2/5); it yields where that is above the limit 1.6 Y, Y the
 *                     yield strength, and from v^2 = 16/15 E* R*^3 (1.6 pi Y/(2 E*))^5/m* on       Hertz 1882; Johnson 1985; Thornton 1997
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/regime.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

double dem_regime_drag(double reynolds)
{
    return reynolds < 1000.0 ? 1.0 + 0.15*pow(reynolds, 0.687) : 0.44*reynolds/24.0;
}

/* ---- what is known -------------------------------------------------------------------------------------------- */

static double length(const double v[3])
{
    return sqrt(v[0]*v[0] + v[1]*v[1] + v[2]*v[2]);
}

/* m3 of a room that is closed on all sides; 0 unknown */
static double room(const struct dem_plan *p)
{
    return p->prospect.volume > 0.0 ? p->prospect.volume : dem_plan_width(p, 0)*dem_plan_width(p, 1)*dem_plan_width(p, 2);
}

/* m, of the axes that are bounded by planes; 0 where none is */
static double narrowest(const struct dem_plan *p)
{
    double least = INFINITY;

    for (int axis = 0; axis < 3; axis++)
    {
        const double w = p->parts->domain.periodic[axis] ? 0.0 : dem_plan_width(p, axis);

        least = w > 0.0 ? fmin(least, w) : least;
    }
    return isfinite(least) ? least : 0.0;
}

double dem_regime_number(const struct dem_plan *p, const char *effect, const char *entry)
{
    const struct dem_recipe *const r = &p->parts->recipe;

    for (int k = 0; r->classes > 0 && k < r->chain[0].links; k++)
    {
        const struct dem_link *const link = &r->chain[0].link[k];
        const struct dem_field *const f = strcmp(link->effect->name, effect) == 0 ? dem_field_find(link->effect->settings, entry) : NULL;

        if (f)
        {
            return *(const double *)(const void *)((const char *)link->settings + f->offset);
        }
    }
    return NAN;
}

/* That number of the law of a stage; 0 without. */
static double number_at(const struct dem_plan *p, enum dem_stage stage, const char *entry)
{
    const struct dem_recipe *const r = &p->parts->recipe;

    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k]->stage == stage)
        {
            const double number = dem_regime_number(p, r->effect[k]->name, entry);

            return isgreater(number, 0.0) ? number : 0.0;
        }
    }
    return 0.0;
}

static int with_drag(const struct dem_recipe *r)
{
    int drag = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        drag |= r->effect[k]->drag;
    }
    return drag;
}

/* m/s at which a lone sphere sinks by Schiller and Naumann: 3 pi mu d f u carries the weight less buoyancy */
static double alone(const struct dem_bed *b)
{
    const double stokes = fabs(b->density - b->fluid_density)*b->gravity*b->diameter*b->diameter/(18.0*b->viscosity);
    double low = 0.0, high = stokes;

    for (int k = 0; k < 100; k++)
    {
        const double u = 0.5*(low + high);
        const int less = dem_regime_drag(b->fluid_density*u*b->diameter/b->viscosity)*u < stokes;

        low = less ? u : low;
        high = less ? high : u;
    }
    return 0.5*(low + high);
}

static void take_fluid(const struct dem_plan *p, struct dem_regime *g)
{
    const struct dem_uniform_fluid *const given = &p->scene->fluid;
    const struct dem_bed *const b = &g->bed;
    const double stokes = dem_bed_response(b), sinks = with_drag(&p->parts->recipe) ? dem_bed_terminal(&p->parts->recipe, b) : 0.0;

    g->flow = given->given ? length(given->velocity) : p->prospect.speed;
    g->vorticity = given->given ? length(given->vorticity) : p->prospect.vorticity;
    g->stress = given->given ? length(given->stress) : 0.0;
    /* what is lighter than the fluid rises: the lone sphere's law stands for its drag */
    g->slip = fmax(b->gravity > 0.0 ? sinks > 0.0 ? sinks : alone(b) : 0.0, g->flow);
    g->reynolds = b->fluid_density*g->slip*b->diameter/b->viscosity;
    g->more = dem_regime_drag(g->reynolds);
    g->response = stokes/g->more;
    g->stokes = g->mass*g->speed/(6.0*pi*b->viscosity*g->radius*g->radius);
    g->meets = g->slip > 0.0 && g->speed > 0.0 ? fmin(g->slip, g->speed) : fmax(g->slip, g->speed);
    g->between = g->phi > 0.0 && g->meets > 0.0 && p->survey.all.n > 1 ? b->diameter/(6.0*g->phi*g->meets) : 0.0;
}

/* Two of the commonest material, by the scene's modulus: a softened one yields later than it should. */
static double yield_speed(const struct dem_recipe *r, const struct dem_regime *g)
{
    double least = INFINITY;

    for (int m = 0; m < r->materials; m++)
    {
        least = r->material[m].yield_strength > 0.0 ? fmin(least, r->material[m].yield_strength) : least;
    }
    return isfinite(least) && g->modulus > 0.0
           ? sqrt(16.0/15.0*g->modulus*pow(g->radius, 3.0)/g->mass*pow(1.6*pi*least/(2.0*g->modulus), 5.0)) : 0.0;
}

void dem_regime_take(const struct dem_plan *p, struct dem_regime *g)
{
    const struct dem_recipe *const r = &p->parts->recipe;

    *g = (struct dem_regime){.fluid = dem_plan_kind(p, &g->bed)};
    g->fluid = dem_plan_kind(p, &g->bed);
    g->phi = room(p) > 0.0 ? p->survey.all.volume/room(p) : 0.0;
    g->width = narrowest(p);
    g->mass = 0.5*g->bed.density*pi/6.0*pow(g->bed.diameter, 3.0);
    g->weight = 2.0*g->mass*g->bed.gravity;
    g->radius = 0.25*g->bed.diameter;
    g->modulus = r->classes > 0 ? r->chain[0].pair.reduced_modulus : 0.0;
    g->speed = number_at(p, DEM_STAGE_NORMAL, "impactSpeed");
    g->friction = number_at(p, DEM_STAGE_TANGENT, "friction");
    g->overlap = g->modulus > 0.0 ? pow(15.0*g->mass*g->speed*g->speed/(16.0*g->modulus*pow(g->radius, 3.0)), 0.4) : 0.0;
    g->yields = yield_speed(r, g);
    if (g->fluid)
    {
        take_fluid(p, g);
    }
}

/* ---- judging -------------------------------------------------------------------------------------------------- */

struct dem_verdict *dem_judge(struct dem_plan *p, const char *effect, double share, double limit, const char *why)
{
    const int on = dem_recipe_acts(&p->parts->recipe, effect);
    struct dem_verdicts *const all = &p->verdicts;

    if ((!on && !(share > limit)) || all->n == DEM_MOST_VERDICTS)
    {
        return NULL;
    }
    struct dem_verdict *const v = &all->verdict[all->n++];

    *v = (struct dem_verdict){.effect = effect, .word = !on ? DEM_CALLED_FOR : share > limit ? DEM_NEEDED : DEM_NEGLIGIBLE, .share = share,
                              .cost = NAN};
    snprintf(v->why, sizeof v->why, "%s", why);
    return v;
}

/* ---- telling -------------------------------------------------------------------------------------------------- */

static void tell_flow(struct dem_text *t, const struct dem_plan *p, const struct dem_regime *g)
{
    const double ratio = g->bed.density/g->bed.fluid_density;

    dem_text_add(t, "    density ratio %.4g", ratio);
    if (g->phi > 0.0 && g->phi < 1.0)
    {
        dem_text_add(t, ", solid fraction of the room %.3g, mass loading %.3g", g->phi, g->phi*ratio/(1.0 - g->phi));
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
    dem_text_add(t, "\n    relaxation time %.3g s at that Reynolds number, %.3g steps", g->response, g->response/p->step);
    if (p->prospect.window > 0.0)
    {
        dem_text_add(t, ", %.3g of the fluid", g->response/p->prospect.window);
    }
    if (g->between > 0.0)
    {
        dem_text_add(t, "; from collision to collision %.3g s: %s", g->between, g->response < g->between ? "dilute, the fluid rules"
                     : "dense, collisions do");
    }
    dem_text_add(t, "\n");
}

/* Below 3 diameters a kernel must spread what cells can't hold: Peng, Doroodchi, Luo, Moghtaderi, AIChE J. 60 (2014) 2000 find 1.6 the
   least at which void fractions of whole cells hold, and 3 to 5 what is common. */
static void tell_cells(struct dem_text *t, const struct dem_plan *p, const struct dem_regime *g)
{
    const double cell = p->prospect.cell/g->bed.diameter;

    if (cell > 0.0)
    {
        dem_text_add(t, "    smallest cell %.3g diameters%s\n", cell, cell < 3.0 ? ": below 3 the void fraction is the kernel's, not the cells' "
                     "(Peng et al. 2014); never particleCentre" : "");
    }
    if (p->prospect.cell > 0.0 && g->phi > 0.0 && g->phi < 1.0)
    {
        const double load = fmax(g->phi, g->phi*g->bed.density/g->bed.fluid_density/(1.0 - g->phi));
        const int feels = !p->prospect.one_way;

        dem_text_add(t, "    coupling %s: %.2g %% is what particles weigh in the fluid's momentum or take of its room (Elghobashi 1994)\n",
                     feels ? load > 0.01 ? "two-way, on and needed" : "two-way, on but negligible"
                           : load > 0.01 ? "one-way though the scene calls for two-way" : "one-way, as the scene calls for", 100.0*load);
    }
}

static void tell_contacts(struct dem_text *t, const struct dem_plan *p, const struct dem_regime *g)
{
    const double w = dem_regime_number(p, "jkr", "workOfAdhesion");

    if (w > 0.0 && g->weight > 0.0)
    {
        dem_text_add(t, "    Bond number %.3g: pull of jkr over weight; two stick below %.3g m/s\n", 1.5*pi*w*g->radius/g->weight,
                     sqrt(2.0*7.09*cbrt(pow(w, 5.0)*pow(g->radius, 4.0)/(g->modulus*g->modulus))/g->mass));
    }
    if (g->speed > 0.0 && g->modulus > 0.0)
    {
        dem_text_add(t, "    impacts at %g m/s press with %.3g Pa by the scene's modulus", g->speed, 2.0*g->modulus/pi*sqrt(g->overlap));
        if (g->yields > 0.0)
        {
            dem_text_add(t, ", and yield from %.3g m/s on (Thornton 1997)\n", g->yields);
        }
        else
        {
            dem_text_add(t, ": weaker than that over 1.6 they yield (materials/NAME/yieldStrength)\n");
        }
    }
}

static void tell_verdict(struct dem_text *t, const struct dem_verdict *v)
{
    static const char *const says[] = {"on and needed", "on but negligible", "off though the scene calls for it"};

    dem_text_add(t, "    %-18s %s", v->effect, says[v->word]);
    if (v->word == DEM_NEGLIGIBLE && isfinite(v->cost))
    {
        dem_text_add(t, v->cost < 0.01 ? " (costs less than 1 %% of the run)" : " (costs %.0f %% of the run)", 100.0*v->cost);
    }
    dem_text_add(t, ": %.2g %% %s", 100.0*v->share, v->why);
    if (v->instead_of)
    {
        dem_text_add(t, "; in place of %s", v->instead_of);
    }
    if (v->lacks)
    {
        dem_text_add(t, "; give it %s", v->lacks);
    }
    dem_text_add(t, "\n");
}

int dem_plan_regime(struct dem_text *t, struct dem_plan *p)
{
    struct dem_regime g;

    p->verdicts.n = 0;
    if (p->survey.all.n == 0)
    {
        return DEM_OK;
    }
    dem_regime_take(p, &g);
    dem_judge_fluid(p, &g);
    dem_judge_contacts(p, &g);
    DEM_TRY(dem_judge_costs(p));
    dem_text_add(t, "Regime (needed: more than 1 %%)\n");
    if (g.fluid)
    {
        tell_flow(t, p, &g);
        tell_cells(t, p, &g);
    }
    tell_contacts(t, p, &g);
    for (int k = 0; k < p->verdicts.n; k++)
    {
        tell_verdict(t, &p->verdicts.verdict[k]);
    }
    return DEM_OK;
}
