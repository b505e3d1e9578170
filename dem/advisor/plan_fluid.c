/*
 * plan_fluid.c -- paragraphs of a plan: bed and fluid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"
#include "advisor/minimum_fluidisation.h"
#include <math.h>

/* ---- bed ----------------------------------------------------------------------------------------------------- */

/* m2: cross-section of the bed: given, or the constant one normal to gravity; 0 unknown. */
static double cross_section(const struct dem_plan *p)
{
    const double *const g = p->scene.gravity;

    if (p->run.cross_section > 0.0)
    {
        return p->run.cross_section;
    }
    for (int axis = 0; axis < 3; axis++)
    {
        if (g[axis] != 0.0 && g[(axis + 1)%3] == 0.0 && g[(axis + 2)%3] == 0.0)
        {
            return p->scene.section[axis];
        }
    }
    return 0.0;
}

void dem_plan_bed(struct dem_text *t, const struct dem_plan *p)
{
    const struct dem_scene_numbers *const s = &p->scene;
    const double g = dem_plan_gravity(p), area = cross_section(p);
    struct dem_suspension b;

    if (g == 0.0 || s->moving_mass == 0.0)
    {
        return;
    }
    dem_text_add(t, "Bed\n    weight %.4g N", s->moving_mass*g);
    if (area > 0.0)
    {
        dem_text_add(t, ", %.4g Pa over %.4g m2", s->moving_mass*g/area, area);
    }
    if (dem_plan_suspension(p, &b))
    {
        const double less = (s->moving_mass - b.fluid_density*s->moving_volume)*g;

        dem_text_add(t, "\n    less buoyancy %.4g N", less);
        if (area > 0.0)
        {
            dem_text_add(t, ", %.4g Pa: the pressure drop at minimum fluidisation", less/area);
        }
    }
    dem_text_add(t, "\n");
}

/* ---- fluid --------------------------------------------------------------------------------------------------- */

/* Void fraction of the bed if its particles touch; 0: unknown, or they do not. */
static double packed_void_fraction(const struct dem_plan *p)
{
    const double e = dem_bed_void_fraction(p->d, cross_section(p));

    return e > 0.0 && e <= DEM_BED_VOID_FRACTION ? e : 0.0;
}

/* The homogeneous expansion at the velocity of the fluid that enters. */
static void write_expansion(struct dem_text *t, const struct dem_plan *p,
                            const struct dem_suspension *b, const char *law, double packed)
{
    const double U = p->run.inflow, e = dem_suspension_expanded_void_fraction(p->d, b, packed, U);
    const double measured = dem_suspension_richardson_zaki(b, U);

    dem_text_add(t, "    the inlet's %.4g m/s %s ", U,
                 p->run.inflow_varies ? "at the start (superficial)" : "(superficial)");
    if (e <= 0.0)
    {
        dem_text_add(t, "is below the value of %s: the bed stays packed\n", law);
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
    const char *const law = p->scene.drag_law;
    const double packed = law ? packed_void_fraction(p) : 0.0;
    const double e = packed > 0.0 ? packed : DEM_SUSPENSION_VOID_FRACTION;

    dem_text_add(t, "    minimum fluidisation at %.4g m/s (superficial; Wen and Yu 1966)\n",
                 dem_suspension_wen_yu_velocity(b));
    if (law)
    {
        const double u = dem_suspension_fluidisation_velocity(p->d, b, e)/e,
                     drag = dem_drag_coefficient(p->d, b, e, u);

        dem_text_add(t, "    and at %.4g m/s with %s for a bed of void fraction %.4g, %s%s\n",
                     e*u, law, e,
                     packed > 0.0 ? "of the particles as they are"
                                  : "assumed: the particles are no bed of known section",
                     b->feels_gradient ? "" : " (without pressureGradient: no buoyancy)");
        dem_text_add(t, "    response time %.4g s there\n",
                     drag > 0.0 ? b->density/drag*3.14159265358979323846/6.0*b->diameter *
                                      b->diameter*b->diameter
                                : INFINITY);
        dem_text_add(t, "    terminal velocity of a single particle %.4g m/s\n",
                     dem_suspension_terminal_velocity(p->d, b));
        if (p->run.inflow > 0.0 && dem_suspension_terminal_velocity(p->d, b) > 0.0)
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
    if (p->scene.min_diameter < p->scene.max_diameter)
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
