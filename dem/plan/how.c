/*
 * how.c -- the step, the fluid, the bed's weight, bytes and time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/plan.h"
#include <float.h>
#include <math.h>

/* ---- the step ------------------------------------------------------------------------------------------------ */

/* Steps of one span: as dem_advance cuts it. */
static double steps_of(double span, double step)
{
    return fmax(1.0, ceil(span/step*(1.0 - 1e-12)));
}

void dem_plan_step(struct dem_text *t, const struct dem_plan *p)
{
    const struct dem_recipe *const r = &p->parts->recipe;
    const struct dem_prospect *const ahead = &p->prospect;
    struct dem_bed b;

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
    if (ahead->window > 0.0)
    {
        dem_text_add(t, "Coupling\n    fluid step %.4g s%s%s: %.0f DEM steps of %.4g s\n", ahead->window, ahead->why ? ", set by " : "",
                     ahead->why ? ahead->why : "", steps_of(ahead->window, p->step), ahead->window/steps_of(ahead->window, p->step));
        if (dem_plan_kind(p, &b))
        {
            dem_text_add(t, "    fluid step over response time %.3g\n", ahead->window/dem_bed_response(&b));
        }
    }
}

/* ---- the bed ------------------------------------------------------------------------------------------------- */

/* Width [m] of the room along an axis: between two planes that face each other, or of a periodic domain; 0 unknown. */
static double width(const struct dem_parts *p, int axis)
{
    double low = -INFINITY, high = INFINITY;

    if (p->domain.periodic[axis])
    {
        return p->domain.length[axis];
    }
    for (int k = 0; k < p->walls.walls; k++)
    {
        const struct dem_wall *const w = &p->walls.wall[k];
        const double along = w->shape == DEM_SHAPE_PLANE ? w->normal[axis] : 0.0;

        low = along == 1.0 ? fmax(low, w->point[axis]) : low;
        high = along == -1.0 ? fmin(high, w->point[axis]) : high;
    }
    return isfinite(high - low) && high > low ? high - low : 0.0;
}

double dem_plan_width(const struct dem_plan *p, int axis)
{
    return width(p->parts, axis);
}

/* 1 when a wall may narrow or slant the room along an axis: neither a plane nor a tube around it lies along it or across it. */
static int bends(const struct dem_wall *w, int axis)
{
    const double along = fabs(w->normal[axis]);

    return w->shape == DEM_SHAPE_PLANE ? along != 1.0 && along != 0.0
         : w->shape == DEM_SHAPE_CYLINDER ? w->outside || along != 1.0 : 1;
}

/* m2 of a straight room along an axis: of the narrowest tube, or between planes, or of a periodic domain; 0 unknown. */
static double straight(const struct dem_parts *p, int axis)
{
    const double flat = width(p, (axis + 1)%3)*width(p, (axis + 2)%3);
    double least = flat > 0.0 ? flat : INFINITY;

    for (int k = 0; k < p->walls.walls; k++)
    {
        const struct dem_wall *const w = &p->walls.wall[k];

        if (bends(w, axis))
        {
            return 0.0;
        }
        least = w->shape == DEM_SHAPE_CYLINDER ? fmin(least, 3.14159265358979324*w->radius*w->radius) : least;
    }
    return isfinite(least) ? least : 0.0;
}

/* m2 that the bed stands on: given, or of a straight room along gravity; 0 unknown. */
static double cross_section(const struct dem_plan *p, const double g[3])
{
    if (p->prospect.cross_section > 0.0)
    {
        return p->prospect.cross_section;
    }
    for (int axis = 0; axis < 3; axis++)
    {
        if (g[axis] != 0.0 && g[(axis + 1)%3] == 0.0 && g[(axis + 2)%3] == 0.0)
        {
            return straight(p->parts, axis);
        }
    }
    return 0.0;
}

void dem_plan_bed(struct dem_text *t, const struct dem_plan *p)
{
    const struct dem_stock *const all = &p->survey.all;
    struct dem_bed b;
    double g[3];

    dem_recipe_vector(&p->parts->recipe, "gravity", "acceleration", g);
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
    if (dem_plan_kind(p, &b))
    {
        const double less = (all->moving_mass - b.fluid_density*all->moving_volume)*size;

        dem_text_add(t, "\n    less buoyancy %.4g N", less);
        if (area > 0.0)
        {
            dem_text_add(t, ", %.4g Pa: the pressure drop that carries it", less/area);
        }
    }
    dem_text_add(t, "\n");
}

/* ---- the fluid ----------------------------------------------------------------------------------------------- */

static const char *drag_law(const struct dem_recipe *r)
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

static void tell_fluidisation(struct dem_text *t, const struct dem_plan *p, const struct dem_bed *b)
{
    const struct dem_recipe *const r = &p->parts->recipe;
    const char *const law = drag_law(r);
    const double e = DEM_BED_VOID;

    dem_text_add(t, "    minimum fluidisation at %.4g m/s (superficial; Wen and Yu 1966)\n", dem_bed_wen_yu(b));
    if (law)
    {
        const double u = dem_bed_balance(r, b, e)/e, drag = dem_bed_drag(r, b, e, u);

        dem_text_add(t, "    and at %.4g m/s where %s carries a bed of void fraction %.4g%s\n", e*u, law, e,
                     b->feels_gradient ? "" : " (without pressureGradient: no buoyancy)");
        dem_text_add(t, "    response time %.4g s there\n", drag > 0.0 ? b->density/drag*3.14159265358979323846/6.0*b->diameter
                                                                        *b->diameter*b->diameter : INFINITY);
        dem_text_add(t, "    a single one sinks at %.4g m/s\n", dem_bed_terminal(r, b));
    }
}

void dem_plan_fluid(struct dem_text *t, const struct dem_plan *p)
{
    struct dem_bed b;

    if (!dem_plan_kind(p, &b))
    {
        return;
    }
    dem_text_add(t, "Fluid\n    density %.6g kg/m3, viscosity %.6g Pa s\n", b.fluid_density, b.viscosity);
    dem_text_add(t, "    response time of a particle %.4g s (Stokes), density ratio %.4g", dem_bed_response(&b), b.density/b.fluid_density);
    if (p->survey.all.least < p->survey.all.most)
    {
        dem_text_add(t, ", for the Sauter diameter %.4g m", b.diameter);
    }
    dem_text_add(t, "\n");
    if (b.gravity > 0.0)
    {
        dem_text_add(t, "    Archimedes number %.4g\n", dem_bed_archimedes(&b));
        tell_fluidisation(t, p, &b);
    }
}

/* ---- what it takes ------------------------------------------------------------------------------------------- */

static void tell_memory(struct dem_text *t, const struct dem_plan *p)
{
    struct dem_need need;
    double pairs, rows;

    dem_need_count(p->parts, &p->survey, &need);
    dem_need_lists(p->parts, &p->survey, &pairs, &rows);
    dem_text_add(t, "Memory\n    %.0f bytes a particle, %.0f a listed pair, %.0f a near contact\n", need.particle, need.pair, need.row);
    dem_text_add(t, "    now %s", dem_text_bytes(p->survey.bytes));
    if (p->survey.pairs > 0)
    {
        dem_text_add(t, " (%lld pairs, %lld near)", (long long)p->survey.pairs, (long long)p->survey.rows);
    }
    if (p->parts->pieces.ranks > 1)
    {
        dem_text_add(t, ", at most %s a rank", dem_text_bytes(p->survey.most_bytes));
    }
    dem_text_add(t, "; as a dense bed %s (%.1f pairs, %.1f near a particle)", dem_text_bytes(need.bed), pairs, rows);
    dem_text_add(t, ", and %s for its copy (lastGood)\n", dem_text_bytes(need.copy));
}

/* Not a number where no normal law has an impact speed. */
static double impact_speed(const struct dem_recipe *r)
{
    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k]->stage == DEM_STAGE_NORMAL)
        {
            return dem_recipe_number(r, r->effect[k]->name, "impactSpeed");
        }
    }
    return NAN;
}

void dem_plan_cost(struct dem_text *t, const struct dem_plan *p)
{
    const struct dem_prospect *const ahead = &p->prospect;
    const struct dem_pairs *const s = &p->parts->pairs;
    const double n = (double)p->survey.all.n, speed = impact_speed(&p->parts->recipe), duration = ahead->duration;

    if (n == 0.0)
    {
        return;
    }
    tell_memory(t, p);
    dem_text_add(t, "Time\n    %.3g us of one processor a particle and step, measured in a dense bed of %lld at rest\n", 1e6*p->pace.step,
                 (long long)p->pace.particles);
    if (duration <= 0.0)
    {
        return;
    }
    const double span = ahead->window > 0.0 ? ahead->window : duration;
    const double steps = steps_of(span, p->step)*duration/span;
    const double quiet = steps*n*p->pace.step;

    dem_text_add(t, "    %.4g s ahead: %.4g steps, %.4g particle-steps: %s of one processor at rest", duration, steps, steps*n,
                 dem_text_time(quiet));
    if (isgreater(speed, 0.0))
    {
        const double lists = n*duration*speed*(p->pace.renew/s->half_outer + p->pace.prune/s->half_inner);
        const double most = steps*n*(p->pace.renew + p->pace.step);

        dem_text_add(t, ", %s with particles at %g m/s", dem_text_time(fmin(quiet + lists, most)), speed);
    }
    dem_text_add(t, "%s\n", ahead->window > 0.0 ? ", the fluid not counted" : "");
}
