/*
 * verdicts.c -- which effects a scene needs: the relevance that each effect states (laws/relevance.h),
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
#include "laws/effects.h"
#include "laws/fluid/drag.h"
#include <math.h>
#include <stdio.h>

static const double threshold = 0.01, pi = 3.14159265358979323846;

static struct dem_verdict *add(struct dem_plan *p, const struct dem_effect *effect,
                               const struct dem_relevance *r)
{
    const int on = dem_interaction_table_has_effect(&p->state->interaction_table, effect->name);
    struct dem_verdicts *const all = &p->verdicts;

    if ((!on && !(r->fraction > r->threshold)) || all->n == DEM_MAX_VERDICTS)
    {
        return NULL;
    }
    struct dem_verdict *const v = &all->verdict[all->n++];

    *v = (struct dem_verdict){.effect = effect->name,
                              .word = !on ? DEM_MISSING
                                      : r->fraction > r->threshold ? DEM_NEEDED
                                                                   : DEM_NEGLIGIBLE,
                              .fraction = r->fraction,
                              .cost = NAN,
                              .missing_setting = on ? NULL : r->missing_setting};
    snprintf(v->why, sizeof v->why, "%s", r->quantity);
    return v;
}

/* ---- drag ------------------------------------------------------------------------------------ */

/* kg/s: drag coefficient at a slip, of the law in use at the mean void fraction, without one by
   Schiller and Naumann. */
static double drag_coefficient(const struct dem_plan *p, const struct dem_regime *g,
                               const struct dem_effect *law, double u)
{
    const struct dem_suspension *const b = &g->suspension;

    return law ? dem_suspension_drag(&p->state->interaction_table, b,
                                     1.0 - fmin(g->solid_fraction, 0.64), u)
               : 3.0*pi*b->viscosity*b->diameter*
                     dem_drag_single_sphere(b->fluid_density*u*b->diameter/b->viscosity);
}

/* Drag over weight at the largest slip given in the scene; not a number: unknown. */
static double drag_fraction(const struct dem_plan *p, const struct dem_regime *g,
                            const struct dem_effect *law)
{
    const double u = fmax(g->speed, g->flow);

    if (g->weight > 0.0)
    {
        return u > 0.0 ? drag_coefficient(p, g, law, u)*u/g->weight : NAN;
    }
    return p->run.duration > 0.0
               ? -expm1(-p->run.duration*drag_coefficient(p, g, law, g->slip)/(2.0*g->mass))
               : NAN;
}

/* Relative increase of drag in a suspension: (1 - phi)^-3.65 - 1 */
static double suspension_excess(const struct dem_regime *g)
{
    return pow(1.0 - fmin(g->solid_fraction, 0.64), -3.65) - 1.0;
}

/* Drag law proposed for a suspension. */
static const struct dem_effect *suspension_law(const struct dem_regime *g)
{
    return dem_effects_drag_law(g->solid_fraction > 0.2 ? DEM_DRAG_BED : DEM_DRAG_SUSPENSION);
}

static const struct dem_effect *drag_in_use(const struct dem_interaction_table *r)
{
    const struct dem_effect *law = NULL;

    for (int k = 0; k < r->chosen; k++)
    {
        law = r->effect[k]->drag ? r->effect[k] : law;
    }
    return law;
}

/* A single-sphere law used in a suspension, or one of creeping flow beyond it. */
static void judge_range(struct dem_plan *p, const struct dem_regime *g,
                        const struct dem_effect *law)
{
    const struct dem_effect *other = NULL;
    struct dem_relevance v = {.threshold = threshold};
    char quantity[200];

    if ((law->drag == DEM_DRAG_CREEPING || law->drag == DEM_DRAG_SINGLE) &&
        suspension_excess(g) > threshold)
    {
        other = suspension_law(g);
        v.fraction = suspension_excess(g);
        v.quantity =
            "of the drag at this solid fraction is missing in a single-sphere law (Wen and Yu 1966)";
    }
    else if (law->drag == DEM_DRAG_CREEPING)
    {
        other = dem_effects_drag_law(DEM_DRAG_SINGLE);
        v.fraction = g->drag_factor - 1.0;
        v.quantity = quantity;
        snprintf(quantity, sizeof quantity,
                 "of the drag at this Reynolds number is missing in %s (%s)", law->name,
                 other->source);
    }
    struct dem_verdict *const verdict = other ? add(p, other, &v) : NULL;

    if (verdict)
    {
        verdict->replaces = law->name;
    }
}

static void judge_drag(struct dem_plan *p, const struct dem_regime *g)
{
    const struct dem_effect *const law = drag_in_use(&p->state->interaction_table);
    const struct dem_effect *const proposed = suspension_excess(g) > threshold
                                                  ? suspension_law(g)
                                                  : dem_effects_drag_law(DEM_DRAG_SINGLE);
    char quantity[200];
    const struct dem_relevance v = {.fraction = drag_fraction(p, g, law),
                                    .threshold = threshold,
                                    .quantity = quantity};

    snprintf(quantity, sizeof quantity, "of %s (%s)",
             g->weight > 0.0 ? "the weight is drag, at the speed of the fluid or of impacts"
                             : "a slip has decayed when the run ends",
             law ? law->source : "Schiller and Naumann 1933");
    if (isfinite(v.fraction))
    {
        (void)add(p, law ? law : proposed, &v);
    }
    if (law)
    {
        judge_range(p, g, law);
    }
}

/* ---- all other effects ----------------------------------------------------------------------- */

/* The effect in use that another one of its kind would replace; NULL: none, or both may be used. */
static const char *replaced_by(const struct dem_interaction_table *r,
                               const struct dem_effect *effect)
{
    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k]->stage == effect->stage &&
            (effect->stage == DEM_STAGE_NORMAL || effect->stage == DEM_STAGE_DAMP))
        {
            return r->effect[k]->name;
        }
    }
    return NULL;
}

static void judge(struct dem_plan *p, const struct dem_regime *g, const struct dem_effect *effect)
{
    const struct dem_interaction_table *const r = &p->state->interaction_table;
    struct dem_relevance v = {.threshold = threshold};

    if (!dem_interaction_table_excludes(r, effect) &&
        effect->relevance(dem_regime_settings(p, effect), g, &v))
    {
        struct dem_verdict *const verdict = add(p, effect, &v);

        if (verdict && verdict->word == DEM_MISSING)
        {
            verdict->replaces = replaced_by(r, effect);
        }
    }
}

void dem_verdicts_add(struct dem_plan *p, const struct dem_regime *g)
{
    if (g->fluid)
    {
        judge_drag(p, g);
    }
    for (enum dem_mechanism m = 0; m < DEM_MECHANISMS; m++)
    {
        const int known = m == DEM_MECHANISM_REPULSION ||
                          (m < DEM_MECHANISM_REPULSION ? g->fluid : g->modulus > 0.0);

        for (const struct dem_effect *const *e = dem_effects; *e && known; e++)
        {
            if ((*e)->relevance && (*e)->mechanism == m)
            {
                judge(p, g, *e);
            }
        }
    }
}
