/*
 * verdicts.c -- which effects a scene needs: the relevance that each effect states (dem_effect_relevance),
 * in the order of mechanisms, and the drag laws, judged by their range of validity.
 *
 * Drag, the law in use or one proposed:
 *
 *   drag at the slip over the weight, by the law in use (without one, Schiller and Naumann) at the
 *       mean void fraction; without gravity the fraction of a slip that has decayed at the
 *       end of the run, 1 - exp(-T/tau)
 *   a law of creeping flow lacks 0.15 Re^0.687 of its drag
 *       (Schiller and Naumann, VDI Z. 77 (1933) 318)
 *   a law of a single sphere lacks (1 - phi)^-3.65 - 1 of it in a suspension
 *       (Wen and Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100); above phi = 0.2 a law for beds is
 *       proposed, below it one for suspensions (Gidaspow 1994)
 *
 * Nothing is said about effects that depend on properties of surfaces and shapes that the scene does
 * not contain (restitution, friction, rolling and torsional resistance, surface energy in a liquid),
 * nor about unknown quantities: lift and stress in a coupled fluid that has no shear yet, spins
 * without friction or in an open domain.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/regime.h"
#include <math.h>
#include <stdio.h>

static const double threshold = 0.01, pi = 3.14159265358979323846;

static struct dem_verdict *add(struct dem_verdicts *all, const struct dem_effect_info *effect,
                               const struct dem_relevance *r)
{
    if ((!effect->in_use && !(r->fraction > r->threshold)) || all->n == DEM_MAX_VERDICTS)
    {
        return NULL;
    }
    struct dem_verdict *const v = &all->verdict[all->n++];

    *v = (struct dem_verdict){.effect = effect->name,
                              .word = !effect->in_use ? DEM_MISSING
                                      : r->fraction > r->threshold ? DEM_NEEDED
                                                                   : DEM_NEGLIGIBLE,
                              .fraction = r->fraction,
                              .missing_setting = effect->in_use ? NULL : r->missing_setting};
    snprintf(v->why, sizeof v->why, "%s", r->quantity);
    return v;
}

/* ---- drag ------------------------------------------------------------------------------------ */

/* kg/s: drag coefficient at a slip, of the law in use at the mean void fraction, without one by
   Schiller and Naumann. */
static double drag_coefficient(const struct dem_plan *p, const struct dem_regime *g, double u)
{
    const struct dem_suspension *const b = &g->suspension;

    return p->scene.drag_law
               ? dem_drag_coefficient(p->d, b, 1.0 - fmin(g->solid_fraction, 0.64), u)
               : 3.0*pi*b->viscosity*b->diameter*
                     dem_single_sphere_drag(b->fluid_density*u*b->diameter/b->viscosity);
}

/* Drag over weight at the largest slip given in the scene; not a number: unknown. */
static double drag_fraction(const struct dem_plan *p, const struct dem_regime *g)
{
    const double u = fmax(g->speed, g->flow);

    if (g->weight > 0.0)
    {
        return u > 0.0 ? drag_coefficient(p, g, u)*u/g->weight : NAN;
    }
    return p->run.duration > 0.0
               ? -expm1(-p->run.duration*drag_coefficient(p, g, g->slip)/(2.0*g->mass))
               : NAN;
}

/* Relative increase of drag in a suspension: (1 - phi)^-3.65 - 1 */
static double suspension_excess(const struct dem_regime *g)
{
    return pow(1.0 - fmin(g->solid_fraction, 0.64), -3.65) - 1.0;
}

/* The first drag law of the library with this range of validity. */
static struct dem_effect_info drag_law(const struct dem_plan *p, enum dem_drag range)
{
    struct dem_effect_info law = {.name = NULL};

    for (int k = 0; law.drag != range && dem_effect_info(p->d, k, &law); k++)
    {
    }
    return law;
}

/* Drag law proposed for a suspension. */
static struct dem_effect_info suspension_law(const struct dem_plan *p, const struct dem_regime *g)
{
    return drag_law(p, g->solid_fraction > 0.2 ? DEM_DRAG_BED : DEM_DRAG_SUSPENSION);
}

/* The drag law in use; its name is NULL without one. */
static struct dem_effect_info drag_in_use(const struct dem_plan *p)
{
    struct dem_effect_info law;

    for (int k = 0; dem_effect_info(p->d, k, &law); k++)
    {
        if (law.drag && law.in_use)
        {
            return law;
        }
    }
    return (struct dem_effect_info){.name = NULL};
}

/* A single-sphere law used in a suspension, or one of creeping flow beyond it. */
static void judge_range(const struct dem_plan *p, const struct dem_regime *g,
                        const struct dem_effect_info *law, struct dem_verdicts *all)
{
    struct dem_effect_info other = {.name = NULL};
    struct dem_relevance v = {.threshold = threshold};
    char quantity[200];

    if ((law->drag == DEM_DRAG_CREEPING || law->drag == DEM_DRAG_SINGLE) &&
        suspension_excess(g) > threshold)
    {
        other = suspension_law(p, g);
        v.fraction = suspension_excess(g);
        v.quantity =
            "of the drag at this solid fraction is missing in a single-sphere law (Wen and Yu 1966)";
    }
    else if (law->drag == DEM_DRAG_CREEPING)
    {
        other = drag_law(p, DEM_DRAG_SINGLE);
        v.fraction = g->drag_factor - 1.0;
        v.quantity = quantity;
        snprintf(quantity, sizeof quantity,
                 "of the drag at this Reynolds number is missing in %s (%s)", law->name,
                 other.source);
    }
    struct dem_verdict *const verdict = other.name ? add(all, &other, &v) : NULL;

    if (verdict)
    {
        verdict->replaces = law->name;
    }
}

static void judge_drag(const struct dem_plan *p, const struct dem_regime *g,
                       struct dem_verdicts *all)
{
    const struct dem_effect_info law = drag_in_use(p);
    const struct dem_effect_info proposed = suspension_excess(g) > threshold
                                                ? suspension_law(p, g)
                                                : drag_law(p, DEM_DRAG_SINGLE);
    char quantity[200];
    const struct dem_relevance v = {.fraction = drag_fraction(p, g),
                                    .threshold = threshold,
                                    .quantity = quantity};

    snprintf(quantity, sizeof quantity, "of %s (%s)",
             g->weight > 0.0 ? "the weight is drag, at the speed of the fluid or of impacts"
                             : "a slip has decayed when the run ends",
             law.name ? law.source : "Schiller and Naumann 1933");
    if (isfinite(v.fraction))
    {
        (void)add(all, law.name ? &law : &proposed, &v);
    }
    if (law.name)
    {
        judge_range(p, g, &law, all);
    }
}

/* ---- all effects ----------------------------------------------------------------------------- */

static void judge(const struct dem_plan *p, const struct dem_regime *g, enum dem_mechanism m,
                  struct dem_verdicts *all)
{
    struct dem_effect_info effect;
    struct dem_relevance v;

    for (int k = 0; dem_effect_info(p->d, k, &effect); k++)
    {
        if (effect.mechanism == m && !effect.excluded && dem_effect_relevance(p->d, k, g, &v))
        {
            struct dem_verdict *const verdict = add(all, &effect, &v);

            if (verdict && verdict->word == DEM_MISSING)
            {
                verdict->replaces = effect.replaces;
            }
        }
    }
}

void dem_verdicts(const struct dem_plan *p, const struct dem_regime *g, struct dem_verdicts *all)
{
    all->n = 0;
    if (g->fluid)
    {
        judge_drag(p, g, all);
    }
    for (enum dem_mechanism m = 0; m < DEM_MECHANISMS; m++)
    {
        if (m == DEM_MECHANISM_REPULSION ||
            (m < DEM_MECHANISM_REPULSION ? g->fluid : g->modulus > 0.0))
        {
            judge(p, g, m, all);
        }
    }
}
