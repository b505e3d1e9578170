/*
 * plan_cost.c -- paragraphs of a plan: time step, coupling, memory and processor time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"
#include "advisor/minimum_fluidisation.h"
#include <math.h>

/* ---- time step ----------------------------------------------------------------------------------------------- */

/* Time steps in one span [s], as dem_advance divides it. */
static double steps_of(double span, double step)
{
    return fmax(1.0, ceil(span/step*(1.0 - 1e-12)));
}

void dem_plan_step(struct dem_text *t, const struct dem_plan *p)
{
    const struct dem_scene_numbers *const s = &p->scene;
    const struct dem_run_info *const run = &p->run;
    struct dem_suspension b;

    dem_text_add(t, "Time step\n    %.4g s", s->step);
    if (isfinite(s->limit))
    {
        dem_text_add(t, "; the limit is %.4g s: %s", s->limit, s->why);
    }
    if (isfinite(s->next_limit))
    {
        dem_text_add(t, "\n    next would be %.4g s: %s", s->next_limit, s->next_why);
    }
    dem_text_add(t, "\n");
    if (run->window > 0.0)
    {
        dem_text_add(t, "Coupling\n    fluid step %.4g s%s%s: %.0f DEM steps of %.4g s\n",
                     run->window, run->why ? ", set by " : "", run->why ? run->why : "",
                     steps_of(run->window, s->step), run->window/steps_of(run->window, s->step));
        if (run->reached_window > 0.0)
        {
            const double steps = steps_of(run->reached_window, s->step);

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

/* ---- memory and time ----------------------------------------------------------------------------------------- */

static void write_memory(struct dem_text *t, const struct dem_run_cost *c)
{
    dem_text_add(
        t, "Memory\n    %.0f bytes a particle, %.0f a listed pair, %.0f a candidate contact\n",
        c->particle, c->pair, c->row);
    dem_text_add(t, "    now %s", dem_text_bytes(c->now));
    if (c->listed > 0)
    {
        dem_text_add(t, " (%lld pairs, %lld candidate contacts)", (long long)c->listed,
                     (long long)c->candidates);
    }
    if (c->ranks > 1)
    {
        dem_text_add(t, ", at most %s a rank", dem_text_bytes(c->max_now));
    }
    dem_text_add(t, "; as a dense bed %s (%.1f pairs, %.1f candidate contacts a particle)",
                 dem_text_bytes(c->bed), c->pairs, c->rows);
    dem_text_add(t, ", and %s for its backup copy (lastGood)\n", dem_text_bytes(c->copy));
}

static void write_device(struct dem_text *t, const struct dem *d, int ranks)
{
    const double bytes = dem_device_bytes(d);

    if (dem_device(d)[0])
    {
        dem_text_add(t, "Device\n    %s\n", dem_device(d));
    }
    if (bytes > 0.0)
    {
        dem_text_add(t, "    %s of its memory%s as a dense bed; its run time is not known before a run, "
                     "the time below is the CPU's\n", dem_text_bytes(bytes),
                     ranks > 1 ? " per rank" : "");
    }
}

void dem_plan_cost(struct dem_text *t, const struct dem_plan *p)
{
    const struct dem_run_info *const run = &p->run;
    const struct dem_run_cost *const c = &p->cost;
    const double n = p->scene.particles, speed = p->scene.impact_speed, duration = run->duration;

    const double span = run->reached_window > 0.0 ? run->reached_window
                        : run->window > 0.0 ? run->window
                                                  : duration;
    const double steps = duration > 0.0 ? steps_of(span, p->scene.step)*duration/span : 0.0;

    if (n == 0.0)
    {
        if (steps > 0.0 && p->scene.streams > 0)
        {
            dem_text_add(t, "Time\n    %.4g s ahead: %.4g steps; how long they take depends on the particles that "
                         "streams insert\n", duration, steps);
        }
        return;
    }
    write_memory(t, c);
    write_device(t, p->d, c->ranks);
    if (c->step == 0.0)
    {
        dem_text_add(t,
                     "Time\n    unknown: particles of a dense bed at rest move too far or overlap too much in steps of "
                     "%.3g s with these laws; take a smaller step or stiffer particles\n",
                     p->scene.step);
        return;
    }
    dem_text_add(
        t,
        "Time\n    %.3g us of processor time a particle and step, measured in a dense bed of %lld particles at rest\n",
        1e6*c->step, (long long)c->particles);
    if (duration <= 0.0)
    {
        return;
    }
    const double at_rest = steps*n*c->step;

    dem_text_add(t,
                 "    %.4g s ahead: %.4g steps, %.4g particle-steps: %s of processor time at rest",
                 duration, steps, steps*n, dem_text_time(at_rest));
    if (speed > 0.0)
    {
        const double lists = n*duration*speed*(c->rebuild/c->outer + c->prune/c->inner);
        const double limit = steps*n*(c->rebuild + c->step);

        dem_text_add(t, ", %s with particles at %g m/s", dem_text_time(fmin(at_rest + lists, limit)),
                     speed);
    }
    dem_text_add(t, "%s\n", run->window > 0.0 ? ", for the particles alone" : "");
}
