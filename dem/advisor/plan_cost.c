/*
 * plan_cost.c -- paragraphs of a plan: time step, coupling, bed, fluid, memory and processor time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"
#include <float.h>
#include <math.h>

/* ---- time step ----------------------------------------------------------------------------------------------- */

/* Time steps in one span [s], as dem_advance divides it. */
static double steps_of(double span, double step)
{
    return fmax(1.0, ceil(span/step*(1.0 - 1e-12)));
}

void dem_plan_step(struct dem_text *t, const struct dem_plan *p)
{
    const struct dem_interaction_table *const r = &p->state->interaction_table;
    const struct dem_run_info *const run = &p->run;
    struct dem_suspension b;

    dem_text_add(t, "Time step\n    %.4g s", p->step);
    if (r->step_limit < DBL_MAX)
    {
        dem_text_add(t, "; the limit is %.4g s: %s", r->step_limit, r->why);
    }
    if (r->next_limit < DBL_MAX)
    {
        dem_text_add(t, "\n    next would be %.4g s: %s", r->next_limit, r->next_why);
    }
    dem_text_add(t, "\n");
    if (run->window > 0.0)
    {
        dem_text_add(t, "Coupling\n    fluid step %.4g s%s%s: %.0f DEM steps of %.4g s\n",
                     run->window, run->why ? ", set by " : "", run->why ? run->why : "",
                     steps_of(run->window, p->step), run->window/steps_of(run->window, p->step));
        if (run->reached_window > 0.0)
        {
            const double steps = steps_of(run->reached_window, p->step);

            dem_text_add(t, "    it %s to %.4g s, set by %s: %.0f DEM steps of %.4g s\n",
                         run->reached_window > run->window ? "grows" : "falls", run->reached_window,
                         run->reached_why, steps, run->reached_window/steps);
        }
        if (dem_plan_suspension(p, &b))
        {
            dem_text_add(t, "    fluid step over response time %.3g\n",
                         run->window/dem_suspension_response_time(&b));
        }
    }
}

/* ---- bed ----------------------------------------------------------------------------------------------------- */

/* 1 if the cross-section normal to an axis may vary because of this wall: it is neither a plane
   normal or parallel to the axis nor a cylinder around it. */
static int varies(const struct dem_wall *w, int axis)
{
    const double along = fabs(w->normal[axis]);

    return w->shape == DEM_SHAPE_PLANE ? along != 1.0 && along != 0.0
         : w->shape == DEM_SHAPE_CYLINDER ? w->outside || along != 1.0 : 1;
}

/* m2: constant cross-section normal to an axis: of the narrowest tube, between planes, or
   periodic; 0 unknown. */
static double constant_section(const struct dem_plan *plan, int axis)
{
    const struct dem_state *const p = plan->state;
    const double flat = dem_plan_width(plan, (axis + 1)%3)*dem_plan_width(plan, (axis + 2)%3);
    double min_area = flat > 0.0 ? flat : INFINITY;

    for (int k = 0; k < p->walls.walls; k++)
    {
        const struct dem_wall *const w = &p->walls.wall[k];

        if (varies(w, axis))
        {
            return 0.0;
        }
        min_area = w->shape == DEM_SHAPE_CYLINDER
                       ? fmin(min_area, 3.14159265358979324*w->radius*w->radius)
                       : min_area;
    }
    return isfinite(min_area) ? min_area : 0.0;
}

/* m2: cross-section of the bed: given, or the constant one normal to gravity; 0 unknown. */
static double cross_section(const struct dem_plan *p, const double g[3])
{
    if (p->run.cross_section > 0.0)
    {
        return p->run.cross_section;
    }
    for (int axis = 0; axis < 3; axis++)
    {
        if (g[axis] != 0.0 && g[(axis + 1)%3] == 0.0 && g[(axis + 2)%3] == 0.0)
        {
            return constant_section(p, axis);
        }
    }
    return 0.0;
}

void dem_plan_bed(struct dem_text *t, const struct dem_plan *p)
{
    const struct dem_material_inventory *const all = &p->inventory.all;
    struct dem_suspension b;
    double g[3];

    dem_interaction_table_gravity(&p->state->interaction_table, g);
    const double size = sqrt(g[0]*g[0] + g[1]*g[1] + g[2]*g[2]), area = cross_section(p, g);

    if (size == 0.0 || all->moving_mass == 0.0)
    {
        return;
    }
    dem_text_add(t, "Bed\n    weight %.4g N", all->moving_mass*size);
    if (area > 0.0)
    {
        dem_text_add(t, ", %.4g Pa over %.4g m2", all->moving_mass*size/area, area);
    }
    if (dem_plan_suspension(p, &b))
    {
        const double less = (all->moving_mass - b.fluid_density*all->moving_volume)*size;

        dem_text_add(t, "\n    less buoyancy %.4g N", less);
        if (area > 0.0)
        {
            dem_text_add(t, ", %.4g Pa: the pressure drop at minimum fluidisation", less/area);
        }
    }
    dem_text_add(t, "\n");
}

/* ---- fluid --------------------------------------------------------------------------------------------------- */

static const char *drag_law(const struct dem_interaction_table *r)
{
    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k]->drag)
        {
            return r->effect[k]->name;
        }
    }
    return NULL;
}

/* Void fraction of the bed if its particles touch; 0: unknown, or they do not. Random loose
   packings of spheres have up to 0.45 (Onoda and Liniger, Phys. Rev. Lett. 64 (1990) 2727), of
   cohesive ones up to 0.6. */
static double packed_void_fraction(const struct dem_plan *p)
{
    struct dem_bed_packing bed;
    double g[3];

    dem_interaction_table_gravity(&p->state->interaction_table, g);
    const double area = cross_section(p, g), max = DEM_BED_VOID_FRACTION;

    if (area <= 0.0 || !dem_bed_packing_measure(p->state, &bed) || bed.high <= bed.low)
    {
        return 0.0;
    }
    const double e = dem_bed_packing_void_fraction(&bed, area);

    return e > 0.0 && e <= max ? e : 0.0;
}

/* The homogeneous expansion at the velocity of the fluid that enters. */
static void write_expansion(struct dem_text *t, const struct dem_plan *p,
                            const struct dem_suspension *b, const char *law, double packed)
{
    const struct dem_interaction_table *const r = &p->state->interaction_table;
    const double U = p->run.inflow, e = dem_suspension_expanded_void_fraction(r, b, packed, U);
    const double measured = dem_suspension_richardson_zaki(b, U);

    dem_text_add(t, "    the inlet's %.4g m/s (superficial) ", U);
    if (e <= 0.0)
    {
        dem_text_add(t, "is below that of %s: the bed stays packed\n", law);
    }
    else if (e >= 1.0)
    {
        dem_text_add(t, "is above the terminal velocity: particles are carried along\n");
    }
    else
    {
        dem_text_add(t, "expands the bed with %s to void fraction %.4g, if it stays homogeneous",
                     law, e);
        if (measured > packed && measured < 1.0)
        {
            dem_text_add(t, "; to %.4g by Richardson and Zaki (1954): %+.2g %% of height", measured,
                         100.0*((1.0 - measured)/(1.0 - e) - 1.0));
        }
        dem_text_add(t, "\n");
    }
}

static void write_fluidisation(struct dem_text *t, const struct dem_plan *p,
                               const struct dem_suspension *b)
{
    const struct dem_interaction_table *const r = &p->state->interaction_table;
    const char *const law = drag_law(r);
    const double packed = law ? packed_void_fraction(p) : 0.0;
    const double e = packed > 0.0 ? packed : DEM_SUSPENSION_VOID_FRACTION;

    dem_text_add(t, "    minimum fluidisation at %.4g m/s (superficial; Wen and Yu 1966)\n",
                 dem_suspension_wen_yu_velocity(b));
    if (law)
    {
        const double u = dem_suspension_fluidisation_velocity(r, b, e)/e,
                     drag = dem_suspension_drag(r, b, e, u);

        dem_text_add(t, "    and at %.4g m/s with %s for a bed of void fraction %.4g, %s%s\n",
                     e*u, law, e,
                     packed > 0.0 ? "that of the particles as they are"
                                  : "assumed: the particles are no bed of known section",
                     b->feels_gradient ? "" : " (without pressureGradient: no buoyancy)");
        dem_text_add(t, "    response time %.4g s there\n",
                     drag > 0.0 ? b->density/drag*3.14159265358979323846/6.0*b->diameter *
                                      b->diameter*b->diameter
                                : INFINITY);
        dem_text_add(t, "    terminal velocity of a single particle %.4g m/s\n",
                     dem_suspension_terminal_velocity(r, b));
        if (p->run.inflow > 0.0 && dem_suspension_terminal_velocity(r, b) > 0.0)
        {
            write_expansion(t, p, b, law, e);
        }
    }
}

void dem_plan_fluid(struct dem_text *t, const struct dem_plan *p)
{
    struct dem_suspension b;

    if (!dem_plan_suspension(p, &b))
    {
        return;
    }
    dem_text_add(t, "Fluid\n    density %.6g kg/m3, viscosity %.6g Pa s\n", b.fluid_density,
                 b.viscosity);
    dem_text_add(t, "    response time of a particle %.4g s (Stokes), density ratio %.4g",
                 dem_suspension_response_time(&b), b.density/b.fluid_density);
    if (p->inventory.all.min_diameter < p->inventory.all.max_diameter)
    {
        dem_text_add(t, ", for the Sauter diameter %.4g m", b.diameter);
    }
    dem_text_add(t, "\n");
    if (b.gravity > 0.0)
    {
        dem_text_add(t, "    Archimedes number %.4g\n", dem_suspension_archimedes(&b));
        write_fluidisation(t, p, &b);
    }
}

/* ---- memory and time ----------------------------------------------------------------------------------------- */

static void write_memory(struct dem_text *t, const struct dem_plan *p)
{
    struct dem_memory_need need;
    double pairs, rows;

    dem_memory_need_count(p->state, &p->inventory, &need);
    dem_memory_need_lists(p->state, &p->inventory, &pairs, &rows);
    dem_text_add(
        t, "Memory\n    %.0f bytes a particle, %.0f a listed pair, %.0f a candidate contact\n",
        need.particle, need.pair, need.row);
    dem_text_add(t, "    now %s", dem_text_bytes(p->inventory.bytes));
    if (p->inventory.pairs > 0)
    {
        dem_text_add(t, " (%lld pairs, %lld candidate contacts)", (long long)p->inventory.pairs,
                     (long long)p->inventory.rows);
    }
    if (p->state->decomposition.ranks > 1)
    {
        dem_text_add(t, ", at most %s a rank", dem_text_bytes(p->inventory.max_bytes));
    }
    dem_text_add(t, "; as a dense bed %s (%.1f pairs, %.1f candidate contacts a particle)",
                 dem_text_bytes(need.bed), pairs, rows);
    dem_text_add(t, ", and %s for its backup copy (lastGood)\n", dem_text_bytes(need.copy));
}

/* m/s: impactSpeed of the normal law; not a number without one. */
static double impact_speed(const struct dem_interaction_table *r)
{
    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k]->stage == DEM_STAGE_NORMAL)
        {
            return dem_interaction_table_get_number(r, r->effect[k]->name, "impactSpeed");
        }
    }
    return NAN;
}

void dem_plan_cost(struct dem_text *t, const struct dem_plan *p)
{
    const struct dem_run_info *const run = &p->run;
    const struct dem_pairs *const s = &p->state->pairs;
    const double n = (double)p->inventory.all.n, speed = impact_speed(&p->state->interaction_table),
                 duration = run->duration;

    if (n == 0.0)
    {
        return;
    }
    write_memory(t, p);
    dem_text_add(
        t,
        "Time\n    %.3g us of processor time a particle and step, measured in a dense bed of %lld particles at rest\n",
        1e6*p->step_cost.step, (long long)p->step_cost.particles);
    if (duration <= 0.0)
    {
        return;
    }
    const double span = run->reached_window > 0.0 ? run->reached_window
                        : run->window > 0.0 ? run->window
                                                  : duration;
    const double steps = steps_of(span, p->step)*duration/span;
    const double at_rest = steps*n*p->step_cost.step;

    dem_text_add(t,
                 "    %.4g s ahead: %.4g steps, %.4g particle-steps: %s of processor time at rest",
                 duration, steps, steps*n, dem_text_time(at_rest));
    if (isgreater(speed, 0.0))
    {
        const double lists =
            n*duration*speed*
            (p->step_cost.rebuild/s->half_outer + p->step_cost.prune/s->half_inner);
        const double limit = steps*n*(p->step_cost.rebuild + p->step_cost.step);

        dem_text_add(t, ", %s with particles at %g m/s", dem_text_time(fmin(at_rest + lists, limit)),
                     speed);
    }
    dem_text_add(t, "%s\n", run->window > 0.0 ? ", for the particles alone" : "");
}
