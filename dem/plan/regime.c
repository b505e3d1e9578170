/*
 * regime.c -- the numbers that decide which effects a scene needs, and what they say of the ones it has and has not.
 *
 *   density ratio     rho_p/rho_f
 *   solid fraction    volume of particles over that of the room, where walls or a periodic domain close one: phi
 *   mass loading      phi rho_p/((1 - phi) rho_f)
 *   Reynolds number   rho_f u d/mu; u is the speed at which a single one sinks by the scene's law of drag, or the fluid's, if given and faster
 *   Stokes number     m* v/(6 pi mu R*^2) of an impact of two at the speed v of the normal law (impactSpeed)
 *
 * An effect is needed when it changes what it acts on by more than 1 %, and negligible when it changes less:
 *
 *   pressureGradient  buoyancy over weight, rho_f/rho_p                                    Archimedes
 *                     in coupled runs also phi: of the drag on a bed as much stands in the pressure gradient    Gidaspow 1994, 2.5
 *   virtualMass       added inertia over inertia, rho_f/(2 rho_p)                          Auton, Hunt, Prud'homme, J. Fluid Mech. 197 (1988) 241
 *   stokesDrag        lacks 0.15 Re^0.687 of its drag                                      Schiller and Naumann, VDI Z. 77 (1933) 318
 *   stokesDrag, schillerNaumann   lack (1 - phi)^-3.65 - 1 of it among others              Wen and Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100
 *   stokes, lubrication   take 1 - exp(-35/St) of the speed of rebound                     Legendre, Zenit, Daniel, Guiraud, Chem. Eng. Sci. 61 (2006) 3543
 *   jkr               the pull 3/2 pi w R* over the weight, or what a contact loses, 7.09 (w^5 R*^4/E*^2)^(1/3), over m* v^2/2
 *                                                                                          Johnson, Kendall, Roberts 1971; Thornton and Ning 1998
 *
 * Spheres of the Sauter diameter stand for all. Not here: what needs numbers that the scene does not have (yield stress, surface energy
 * where none is given, vorticity and void fraction of a fluid that is coupled), lift, rolling, and what an effect takes: dem cost -effects.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/plan.h"
#include <math.h>

static const double matters = 0.01, pi = 3.14159265358979323846;

struct regime
{
    struct dem_bed bed;                                   /* of one kind of sphere */
    double phi;                                           /* 1; 0 unknown */
    double reynolds, stokes;                              /* 1; 0 unknown */
    double mass, radius, modulus, speed;                  /* kg, m, Pa, m/s: m*, R*, E*, v; 0 unknown */
};

/* m3 of a room that is closed on all sides; 0 unknown */
static double room(const struct dem_plan *p)
{
    return dem_plan_width(p, 0)*dem_plan_width(p, 1)*dem_plan_width(p, 2);
}

static double impact_speed(const struct dem_recipe *r)
{
    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k]->stage == DEM_STAGE_NORMAL)
        {
            const double v = dem_recipe_number(r, r->effect[k]->name, "impactSpeed");

            return isgreater(v, 0.0) ? v : 0.0;
        }
    }
    return 0.0;
}

/* 1: there is a fluid */
static int look(const struct dem_plan *p, struct regime *g)
{
    const struct dem_recipe *const r = &p->parts->recipe;
    const double *const u = p->scene->fluid.velocity;
    const int fluid = dem_plan_kind(p, &g->bed);
    const struct dem_bed *const b = &g->bed;
    const double sinks = fluid && b->gravity > 0.0 ? dem_bed_terminal(r, b) : 0.0, flows = p->scene->fluid.given ? sqrt(u[0]*u[0] + u[1]*u[1] + u[2]*u[2]) : 0.0;

    g->phi = room(p) > 0.0 ? p->survey.all.volume/room(p) : 0.0;
    g->mass = 0.5*b->density*pi/6.0*b->diameter*b->diameter*b->diameter;
    g->radius = 0.25*b->diameter;
    g->modulus = r->classes > 0 ? r->chain[0].pair.reduced_modulus : 0.0;
    g->speed = impact_speed(r);
    g->reynolds = fluid ? b->fluid_density*fmax(sinks, flows)*b->diameter/b->viscosity : 0.0;
    g->stokes = fluid ? g->mass*g->speed/(6.0*pi*b->viscosity*g->radius*g->radius) : 0.0;
    return fluid;
}

/* One line where there is something to say: an effect that is there, or one that is called for. */
static void judge(struct dem_text *t, const struct dem_plan *p, const char *effect, double share, const char *why)
{
    const int on = dem_recipe_acts(&p->parts->recipe, effect);

    if (on || share > matters)
    {
        dem_text_add(t, "    %-18s %s: %.2g %% %s\n", effect, on ? share > matters ? "on, needed" : "on, negligible" : "off, called for",
                     100.0*share, why);
    }
}

static void judge_fluid(struct dem_text *t, const struct dem_plan *p, const struct regime *g)
{
    const struct dem_recipe *const r = &p->parts->recipe;
    const double light = g->bed.fluid_density/g->bed.density, lost = g->stokes > 0.0 ? 1.0 - exp(-35.0/g->stokes) : 0.0;
    const double inertia = 0.15*pow(g->reynolds, 0.687), crowd = g->phi < 0.64 ? pow(1.0 - g->phi, -3.65) - 1.0 : 0.0;
    const int alone = dem_recipe_acts(r, "stokesDrag") || dem_recipe_acts(r, "schillerNaumann");

    const double shared = p->scene->fluid.given ? 0.0 : g->phi;

    /* a coupled bed of unknown void fraction may live by it: nothing is said */
    if (g->bed.gravity > 0.0 && (light > matters || shared > 0.0 || p->scene->fluid.given))
    {
        judge(t, p, "pressureGradient", fmax(light, shared), light >= shared ? "of the weight is buoyancy"
              : "of what carries a sphere is the gradient that the drag on all makes (set II)");
    }
    judge(t, p, "virtualMass", 0.5*light, "of the inertia is the fluid's");
    if (dem_recipe_acts(r, "stokesDrag") && inertia > matters)
    {
        dem_text_add(t, "    %-18s off, called for: stokesDrag lacks %.2g %% of the drag at this Reynolds number (Schiller and Naumann 1933)\n",
                     "schillerNaumann", 100.0*inertia);
    }
    if (alone && crowd > matters)
    {
        dem_text_add(t, "    %-18s off, called for: a single sphere's law lacks %.2g %% of the drag at this solid fraction (Wen and Yu 1966); "
                     "or another of suspensions\n", "wenYu", 100.0*crowd);
    }
    if (g->stokes > 0.0)
    {
        judge(t, p, dem_recipe_acts(r, "lubrication") ? "lubrication" : "stokes", lost,
              "of the speed of rebound goes into the film (Legendre et al. 2006)");
    }
}

static void judge_adhesion(struct dem_text *t, const struct dem_plan *p, const struct regime *g)
{
    const double w = dem_recipe_number(&p->parts->recipe, "jkr", "workOfAdhesion"), pull = 1.5*pi*w*g->radius;
    const double weight = 2.0*g->mass*g->bed.gravity, energy = 0.5*g->mass*g->speed*g->speed;
    const double loss = 7.09*cbrt(pow(w, 5.0)*pow(g->radius, 4.0)/(g->modulus*g->modulus));

    if (weight > 0.0)
    {
        dem_text_add(t, "    Bond number %.3g: pull of jkr over weight\n", pull/weight);
    }
    judge(t, p, "jkr", fmax(weight > 0.0 ? pull/weight : 0.0, energy > 0.0 ? loss/energy : 0.0),
          "of a particle's weight, or of an impact's energy, is adhesion's (Johnson, Kendall, Roberts 1971; Thornton and Ning 1998)");
}

static void tell_numbers(struct dem_text *t, const struct regime *g)
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
    dem_text_add(t, "\n");
}

void dem_plan_regime(struct dem_text *t, const struct dem_plan *p)
{
    const int adhesion = dem_recipe_acts(&p->parts->recipe, "jkr");
    struct regime g = {.phi = 0.0};

    if (p->survey.all.n == 0)
    {
        return;
    }
    const int fluid = look(p, &g);

    if (fluid || adhesion)
    {
        dem_text_add(t, "Regime (needed: more than 1 %%)\n");
    }
    if (fluid)
    {
        tell_numbers(t, &g);
        judge_fluid(t, p, &g);
    }
    if (adhesion && g.modulus > 0.0)
    {
        judge_adhesion(t, p, &g);
    }
}
