/*
 * warning_list.c -- items of the list of warnings: see warning_list.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/warning_list.h"
#include "core/error.h"
#include <string.h>

void dem_warning_begin(struct dem_warning_list *w)
{
    dem_text_add(w->t, w->n == 0 ? "WARNINGS\n%4d. " : "%4d. ", w->n + 1);
    w->n++;
}

int dem_warning_has_particles(const struct dem_warning_list *w)
{
    return w->p->scene.particles > 0.0 || w->p->scene.streams > 0;
}

void dem_warning_lines(struct dem_warning_list *w, const char *line)
{
    for (size_t n; *line; line += n + 1)
    {
        n = strcspn(line, "\n");
        dem_warning_begin(w);
        dem_text_add(w->t, "%.*s\n", (int)n, line);
    }
}

int dem_warning_measure_step(struct dem_warning_list *w)
{
    struct dem_run_cost cost;

    if (!w->measured && w->p->scene.particles > 0.0)
    {
        DEM_TRY(dem_run_cost(w->p->d, &cost));
        w->step_cost = cost.step;
        w->measured = 1;
    }
    return DEM_OK;
}

void dem_warning_add_time(struct dem_warning_list *w, double steps)
{
    if (w->step_cost > 0.0)
    {
        dem_text_add(w->t, ", %s of processor time for %.0f particles",
                     dem_text_time(steps*w->p->scene.particles*w->step_cost), w->p->scene.particles);
    }
}
