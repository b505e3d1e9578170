/*
 * verdicts_fluid.c -- which effects of the fluid a scene needs.
 *
 * An effect is needed when it changes what it acts on by more than 1 %, and negligible when it changes less:
 *
 *   laws of drag      drag at the slip over the weight; without gravity what of a slip is gone when the run ends, 1 - exp(-T/tau)
 *   pressureGradient  buoyancy over weight, rho_f/rho_p                                    Archimedes
 *                     in coupled runs also phi: of the drag on a bed as much stands in the pressure gradient    Gidaspow 1994, 2.5
 *   virtualMass       added inertia over inertia, rho_f/(2 rho_p)                          Auton, Hunt, Prud'homme, J. Fluid Mech. 197 (1988) 241
 *   stokesDrag        lacks 0.15 Re^0.687 of its drag                                      Schiller and Naumann, VDI Z. 77 (1933) 318
 *   stokesDrag, schillerNaumann   lack (1 - phi)^-3.65 - 1 of it among others              Wen and Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100
 *                     above phi = 0.2 gidaspow is named, below wenYu                       Gidaspow 1994
 *   saffmanMei        lift over drag, 1.615 d sqrt(o/nu) J/(3 pi f)                        Saffman 1965; Mei 1992 (effects/saffman_mei.c)
 *   magnus            lift over drag, rho d^2 C W/(24 mu f), times what of a response fits between two collisions, which turn spins anew;
 *                     W = 10/7 v/d of a sphere that slid on another until it rolled        Rubinow and Keller 1961; Loth and Dorgan 2009
 *   viscousTorque     spin that is lost from collision to collision, 1 - exp(-t/(rho_p d^2/(60 mu)))     Stokes 1845; Dennis, Singh, Ingham 1980
 *   viscousStress     div tau over drag, V |div tau|/(3 pi mu d f u); in coupled runs mu o over a cell stands for div tau    Zhou et al. 2010
 *   stokes, lubrication   take 1 - exp(-35/St) of the speed of rebound                     Legendre, Zenit, Daniel, Guiraud, Chem. Eng. Sci. 61 (2006) 3543
 *
 * Nothing is said of what is not known: lift and stress in a coupled fluid that has no shear yet, spins without friction or room.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/regime.h"
#include <math.h>
#include <stddef.h>

static const double matters = 0.01, pi = 3.14159265358979323846;

/* The effect of that stage which acts, NULL: none. */
static const char *acting(const struct dem_recipe *r, enum dem_stage stage, int drag)
{
    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k]->stage == stage && r->effect[k]->drag == drag)
        {
            return r->effect[k]->name;
        }
    }
    return NULL;
}

/* ---- drag ------------------------------------------------------------------------------------------------------ */

/* What drag does at the fastest slip that the scene speaks of; not a number: unknown. */
static double drag_share(const struct dem_plan *p, const struct dem_regime *g)
{
    const double u = fmax(g->speed, g->flow), re = g->bed.fluid_density*u*g->bed.diameter/g->bed.viscosity;

    if (g->weight > 0.0)
    {
        return u > 0.0 ? 3.0*pi*g->bed.viscosity*g->bed.diameter*dem_regime_drag(re)*u/g->weight : NAN;
    }
    return p->prospect.duration > 0.0 ? -expm1(-p->prospect.duration/g->response) : NAN;
}

static double crowd(const struct dem_regime *g)
{
    return pow(1.0 - fmin(g->phi, 0.64), -3.65) - 1.0;
}

static const char *suspension(const struct dem_regime *g)
{
    return g->phi > 0.2 ? "gidaspow" : "wenYu";
}

/* The law that acts falls short of another. */
static void judge_law(struct dem_plan *p, const struct dem_regime *g, const char *law)
{
    const double inertia = g->more - 1.0;
    const int creeping = dem_recipe_acts(&p->parts->recipe, "stokesDrag");
    struct dem_verdict *v = NULL;

    if ((creeping || dem_recipe_acts(&p->parts->recipe, "schillerNaumann")) && crowd(g) > matters)
    {
        v = dem_judge(p, suspension(g), crowd(g), matters, "of the drag at this solid fraction a single sphere's law lacks (Wen and Yu 1966)");
    }
    else if (creeping)
    {
        v = dem_judge(p, "schillerNaumann", inertia, matters, "of the drag at this Reynolds number stokesDrag lacks (Schiller and Naumann 1933)");
    }
    if (v)
    {
        v->instead_of = law;
    }
}

static void judge_drag(struct dem_plan *p, const struct dem_regime *g)
{
    const char *const law = acting(&p->parts->recipe, DEM_STAGE_FLUID, 1);
    const double share = drag_share(p, g);
    const char *const why = g->weight > 0.0 ? "of the weight is drag, at the speed of the fluid or of impacts (Schiller and Naumann 1933)"
                          : "of a slip is gone when the run ends (Schiller and Naumann 1933)";

    if (isfinite(share))
    {
        dem_judge(p, law ? law : crowd(g) > matters ? suspension(g) : "schillerNaumann", share, matters, why);
    }
    if (law)
    {
        judge_law(p, g, law);
    }
}

/* ---- buoyancy, inertia, stress ---------------------------------------------------------------------------------- */

static void judge_gradient(struct dem_plan *p, const struct dem_regime *g)
{
    const int given = p->scene->fluid.given;
    const double light = g->bed.fluid_density/g->bed.density, shared = given ? 0.0 : g->phi;

    /* a coupled bed of unknown void fraction may live by it: nothing is said */
    if (g->bed.gravity > 0.0 && (light > matters || shared > 0.0 || given))
    {
        dem_judge(p, "pressureGradient", fmax(light, shared), matters, light >= shared ? "of the weight is buoyancy (Archimedes)"
                  : "of what carries a sphere is the gradient that the drag on all makes (set II; Gidaspow 1994)");
    }
}

/* N of Schiller and Naumann's drag at the slip; 0 where that is 0 */
static double drag(const struct dem_regime *g)
{
    return 3.0*pi*g->bed.viscosity*g->bed.diameter*g->more*g->slip;
}

static void judge_stress(struct dem_plan *p, const struct dem_regime *g)
{
    const int given = p->scene->fluid.given, known = given || (g->vorticity > 0.0 && p->prospect.cell > 0.0);
    const double divergence = given ? g->stress : known ? g->bed.viscosity*g->vorticity/p->prospect.cell : 0.0;
    const double against = drag(g) > 0.0 ? drag(g) : g->weight;

    if (known && against > 0.0)
    {
        dem_judge(p, "viscousStress", divergence*pi/6.0*pow(g->bed.diameter, 3.0)/against, matters,
                  "of the drag is the stress of the mean flow (Zhou, Kuang, Chu, Yu 2010)");
    }
}

/* ---- lift ------------------------------------------------------------------------------------------------------- */

static double saffman(const struct dem_regime *g)
{
    const double d = g->bed.diameter, nu = g->bed.viscosity/g->bed.fluid_density, k = 0.5*d*g->vorticity/g->slip, root = 0.3314*sqrt(k);
    const double J = g->reynolds <= 40.0 ? (1.0 - root)*exp(-0.1*g->reynolds) + root : 0.0524*sqrt(k*g->reynolds);

    return 1.615*d*sqrt(g->vorticity/nu)*J/(3.0*pi*g->more);
}

static void judge_lift(struct dem_plan *p, const struct dem_regime *g)
{
    const struct dem_bed *const b = &g->bed;

    if (g->slip > 0.0 && (p->scene->fluid.given || g->vorticity > 0.0))
    {
        dem_judge(p, "saffmanMei", g->vorticity > 0.0 ? saffman(g) : 0.0, matters, "of the drag is the lift of shear (Saffman 1965; Mei 1992)");
    }
    if (g->friction > 0.0 && g->between > 0.0 && g->slip > 0.0)
    {
        const double spin = 10.0/7.0*g->meets/b->diameter, S = b->diameter*spin/g->slip, fits = fmin(1.0, g->between/g->response);
        const double C = 1.0 - (0.675 + 0.15*(1.0 + tanh(0.28*(S - 2.0))))*tanh(0.18*sqrt(g->reynolds));
        const double turns = b->density*b->diameter*b->diameter/(60.0*b->viscosity);

        dem_judge(p, "magnus", fits*b->fluid_density*b->diameter*b->diameter*C*spin/(24.0*b->viscosity*g->more), matters,
                  "of the drag is the lift of a spin that a collision gave, as long as it lasts (Rubinow and Keller 1961; Loth and Dorgan 2009)");
        dem_judge(p, "viscousTorque", -expm1(-g->between/turns), matters, "of a spin the fluid takes from collision to collision (Dennis, "
                  "Singh, Ingham 1980)");
    }
}

/* ---- the film --------------------------------------------------------------------------------------------------- */

static void judge_film(struct dem_plan *p, const struct dem_regime *g)
{
    const struct dem_recipe *const r = &p->parts->recipe;
    const char *const damping = acting(r, DEM_STAGE_DAMP, 0);
    struct dem_verdict *const v = g->stokes > 0.0 ? dem_judge(p, dem_recipe_acts(r, "lubrication") ? "lubrication" : "stokes",
                                                              1.0 - exp(-35.0/g->stokes), matters,
                                                              "of the speed of rebound goes into the film (Legendre et al. 2006)") : NULL;

    if (v && v->word == DEM_CALLED_FOR)
    {
        v->instead_of = damping;
        v->lacks = dem_recipe_acts(r, "dry") ? NULL : "restitution, of the impact without fluid";
    }
}

void dem_judge_fluid(struct dem_plan *p, const struct dem_regime *g)
{
    if (g->fluid)
    {
        judge_drag(p, g);
        judge_gradient(p, g);
        dem_judge(p, "virtualMass", 0.5*g->bed.fluid_density/g->bed.density, matters, "of the inertia is the fluid's (Auton, Hunt, Prud'homme 1988)");
        judge_stress(p, g);
        judge_lift(p, g);
        judge_film(p, g);
    }
}
