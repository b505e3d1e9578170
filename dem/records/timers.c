/*
 * timers.c -- read the clocks at the ends of phases, and distribute the time of steps that were not
 * timed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/timers.h"
#include "core/clock.h"
#include <string.h>

enum
{
    ALWAYS_TIMED = 5000,     /* particles whose step takes 0.3 ms, 1000 times ten readings */
    ALWAYS_MEASURED = 200000,  /* particles whose step takes 12 ms, 1000 times ten readings of the
                                  processor clock */
    LONG_ADVANCE = 50000,    /* particle-steps, 3 ms: 1000 times two such readings */
    LONG_REBUILD = 4000,     /* particles whose rebuild takes as long */
    STEP_WITHOUT_PARTICLES = 20  /* particles that cost as much as the rest of a step */
};

enum
{
    NO_PHASE = -1
};

/* End an interval that began at the last reading, and begin the next one. `measured`: read the
   processor clock, too. Between two such readings in succession the processor time belongs to the
   phase; otherwise it is distributed later. */
static void end_interval(struct dem_timers *t, double *spent, int phase, int measured)
{
    const double now = dem_clock_wall(), seconds = now - t->last;

    *spent += seconds;
    t->last = now;
    if (measured)
    {
        const double processor = dem_clock_processor();

        if (t->exact && phase != NO_PHASE)
        {
            t->processor[phase] += processor - t->last_processor;
            t->clock[phase] += seconds;
        }
        else
        {
            t->unmeasured += processor - t->last_processor;
        }
        t->last_processor = processor;
    }
    t->exact = measured;
}

static void end_phase(struct dem_timers *t, enum dem_phase phase, int measured)
{
    if (t->timed)
    {
        end_interval(t, &t->spent[phase], (int)phase, measured);
    }
    else
    {
        end_interval(t, &t->untimed, NO_PHASE, measured);
    }
}

void dem_timers_begin(struct dem_timers *t, int64_t rebuilds, int64_t prunes, int64_t agreements)
{
    *t = (struct dem_timers){.last = dem_clock_wall(),
                             .last_processor = dem_clock_processor(),
                             .exact = 1,
                             .every = 1,
                             .measure_every = 1,
                             .rebuilds = rebuilds,
                             .prunes = prunes,
                             .agreements = agreements};
}

void dem_timers_begin_advance(struct dem_timers *t, size_t particles, int64_t steps)
{
    const int64_t n = (int64_t)particles;
    const int64_t work = (n + STEP_WITHOUT_PARTICLES)*(steps > 0 ? steps : 1);

    t->advance_measured = t->advances++%((LONG_ADVANCE + work)/(work + 1)) == 0;
    /* what was measured up to the end of the last advance is measured up to here */
    end_interval(t, &t->spent[DEM_PHASE_OUTSIDE], DEM_PHASE_OUTSIDE,
                 t->advance_measured || t->exact);
    t->every = (ALWAYS_TIMED + n)/(n + 1);
    t->measure_every = (ALWAYS_MEASURED + n)/(n + 1);
    t->rare_every = (LONG_REBUILD + n)/(n + 1);
    t->timed = 1;
    t->measured = t->advance_measured;
}

/* The last half kick takes the time since the last phase. */
void dem_timers_end_advance(struct dem_timers *t)
{
    end_phase(t, DEM_PHASE_BODIES, t->measured || t->advance_measured);
}

void dem_timers_begin_step(struct dem_timers *t)
{
    const int was_timed = t->timed;

    t->measured = t->measure_every <= 1 || t->steps%t->measure_every == t->measure_every/2;
    t->timed = t->measured || t->every <= 1 || t->steps%t->every == t->every - 1;
    t->steps++;
    if ((t->timed && !was_timed) || (t->measured && !t->exact))
    {
        end_interval(t, was_timed ? &t->spent[DEM_PHASE_BODIES] : &t->untimed, NO_PHASE,
                     t->measured);
    }
}

void dem_timers_end_phase(struct dem_timers *t, enum dem_phase phase)
{
    if (t->timed)
    {
        end_interval(t, &t->spent[phase], (int)phase, t->measured);
    }
}

void dem_timers_begin_rare_phase(struct dem_timers *t, enum dem_phase before)
{
    t->rare_measured = t->measured || t->rare++%t->rare_every == 0;
    end_phase(t, before, t->rare_measured);
}

void dem_timers_end_rare_phase(struct dem_timers *t, enum dem_phase phase)
{
    end_interval(t, &t->spent[phase], (int)phase, t->rare_measured);
}

void dem_timers_end_outside(struct dem_timers *t)
{
    end_interval(t, &t->spent[DEM_PHASE_OUTSIDE], DEM_PHASE_OUTSIDE, 1);
}

void dem_timers_seconds(const struct dem_timers *t, double spent[DEM_PHASES])
{
    double timed = 0.0;

    memcpy(spent, t->spent, sizeof t->spent);
    for (int k = 0; k < DEM_PHASE_EVERY_STEP; k++)
    {
        timed += spent[k];
    }
    for (int k = 0; k < DEM_PHASE_EVERY_STEP; k++)
    {
        spent[k] += timed > 0.0 ? t->untimed*t->spent[k]/timed : t->untimed/DEM_PHASE_EVERY_STEP;
    }
}

/* Phases differ in the processor time of a second: a rank that waits may sleep. The time that was
   not measured by phase is distributed over the seconds in which it passed, each with the quotient
   of the measured seconds of its phase, or of all phases. */
void dem_timers_processor_seconds(const struct dem_timers *t, double processor[DEM_PHASES])
{
    double spent[DEM_PHASES], weight[DEM_PHASES], sum = 0.0, clock = 0.0, measured = 0.0;

    dem_timers_seconds(t, spent);
    for (int k = 0; k < DEM_PHASES; k++)
    {
        clock += t->clock[k];
        measured += t->processor[k];
    }
    for (int k = 0; k < DEM_PHASES; k++)
    {
        const double rest = spent[k] > t->clock[k] ? spent[k] - t->clock[k] : 0.0;

        weight[k] = rest*(t->clock[k] > 0.0 ? t->processor[k]/t->clock[k]
                          : clock > 0.0 ? measured/clock : 1.0);
        sum += weight[k];
    }
    for (int k = 0; k < DEM_PHASES; k++)
    {
        processor[k] = t->processor[k] + (sum > 0.0 ? t->unmeasured*weight[k]/sum
                                                    : t->unmeasured/DEM_PHASES);
    }
}

const char *dem_phase_name(enum dem_phase phase)
{
    static const char *const names[DEM_PHASES] = {"drift", "agree", "refresh", "prune",
                                                  "contacts", "sums", "bodies", "rebuild",
                                                  "averages", "backup", "device", "outside"};

    return names[phase];
}
