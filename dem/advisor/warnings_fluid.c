/*
 * warnings_fluid.c -- warnings of a fluid: drag, fluid step, cells.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/warning_list.h"
#include "core/error.h"
#include <math.h>

static const double costly_window = 1e4;       /* DEM steps in a fluid step */
static const double max_cell = 1000.0;         /* diameters  above it: a slip of the unit */
static const double min_resolution = 0.75;     /* diameters  below it: cells become too full */
static const double max_crossing = 0.5;        /* of the resolution: default of maxParticleCo */

double dem_warning_fluid_speed(const struct dem_warning_list *w)
{
    return w->p->scene.uniform ? w->p->scene.fluid_speed
                               : fmax(w->p->run.speed, w->p->run.patch_speed);
}

void dem_warning_of_drag(struct dem_warning_list *w)
{
    if ((w->p->scene.coupled || w->p->scene.uniform) && !w->p->scene.drag_law)
    {
        dem_warning_begin(w);
        dem_text_add(
            w->t,
            "a fluid, and no drag: particles do not feel its flow; add a drag law to effects, gidaspow {} or "
            "diFelice {} for example (`dem effects` lists them)\n");
    }
}

/* ---- fluid step ------------------------------------------------------------------------------ */

int dem_warning_of_window(struct dem_warning_list *w)
{
    const struct dem_run_info *const run = &w->p->run;
    const double steps = fmax(1.0, ceil(run->window/w->p->scene.step*(1.0 - 1e-12)));

    if (run->window > 0.0 && steps > costly_window && dem_warning_has_particles(w))
    {
        DEM_TRY(dem_warning_measure_step(w));
        dem_warning_begin(w);
        dem_text_add(w->t, "a fluid step of %g s is %.0f DEM steps", run->window, steps);
        dem_warning_add_time(w, steps);
        if (run->duration > run->window && w->step_cost > 0.0)
        {
            dem_text_add(w->t, ", %s for the run",
                         dem_text_time(steps*w->p->scene.particles*w->step_cost*run->duration/
                                       run->window));
        }
        dem_text_add(
            w->t, "; take a shorter deltaT and endTime in system/controlDict, or a softer material\n");
    }
    return DEM_OK;
}

/* m/s: speed that a particle may reach within a fluid step, and whose it is */
static double reached(const struct dem_warning_list *w, const char **whose)
{
    const struct dem_run_info *const run = &w->p->run;
    const struct dem_regime *const g = &w->regime;
    const int drag = w->p->scene.drag_law != NULL, present = w->p->scene.particles > 0.0;
    double most = w->p->scene.max_speed;

    *whose = "of a particle";
    if (g->fluid && drag && g->response > 0.0)
    {
        const double taken = dem_warning_fluid_speed(w)*(1.0 - exp(-run->window/g->response));

        *whose = taken > most ? "that the fluid gives to a particle in it" : *whose;
        most = fmax(most, taken);
    }
    const double fall = dem_plan_gravity(w->p)*run->window;
    const double terminal = g->fluid && drag && g->slip > 0.0 ? fmin(fall, g->slip) : fall;

    *whose = present && terminal > most ? "that gravity gives to a particle in it" : *whose;
    return present ? fmax(most, terminal) : most;
}

void dem_warning_of_crossing(struct dem_warning_list *w)
{
    const struct dem_run_info *const run = &w->p->run;
    const char *whose;
    const double speed = reached(w, &whose);
    const double crossing = run->resolution > 0.0 ? speed*run->window/run->resolution : 0.0;

    if (crossing > max_crossing)
    {
        dem_warning_begin(w);
        dem_text_add(
            w->t,
            "a fluid step of %g s is long: at %.3g m/s, the speed %s, particles cross %.3g cells or half kernel widths "
            "(maxParticleCo %g); take deltaT %.2g s in system/controlDict, or adjustTimeStep yes\n",
            run->window, speed, whose, crossing, max_crossing,
            max_crossing*run->resolution/speed);
    }
}

/* ---- cells ----------------------------------------------------------------------------------- */

void dem_warning_of_cells(struct dem_warning_list *w)
{
    const struct dem_run_info *const run = &w->p->run;
    const double d = w->regime.suspension.diameter;

    if (run->resolution > 0.0 && !run->one_way && run->resolution < min_resolution*d*(1.0 - 1e-9))
    {
        dem_warning_begin(w);
        dem_text_add(
            w->t,
            "the smallest cell, %.3g m, or half the kernel's width, is less than 3/4 of a particle of %.3g m: cells "
            "become too full, and without ownWake each particle feels mainly its own wake; take kernel diffusion "
            "with width 3 in coupling, or cells of two diameters\n",
            run->cell, d);
    }
    else if (d > 0.0 && run->cell > max_cell*d)
    {
        dem_warning_begin(w);
        dem_text_add(
            w->t, "the smallest cell, %.3g m, is %.3g diameters wide; if the mesh is in mm, give scale 0.001 in "
            "system/blockMeshDict, or use transformPoints -scale\n",
            run->cell, run->cell/d);
    }
}
