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
    ALWAYS_TIMED = 5000    /* particles whose step takes 0.3 ms, 1000 times ten readings */
};

/* End an interval that began at the last reading, and begin the next one. */
static void end_interval(struct dem_timers *t, double *spent)
{
    const double now = dem_clock_wall();

    *spent += now - t->last;
    t->last = now;
}

static void end_phase(struct dem_timers *t, enum dem_phase phase)
{
    end_interval(t, t->timed ? &t->spent[phase] : &t->untimed);
}

void dem_timers_begin(struct dem_timers *t, int64_t rebuilds, int64_t prunes, int64_t agreements)
{
    *t = (struct dem_timers){.last = dem_clock_wall(),
                             .first_processor = dem_clock_processor(),
                             .every = 1,
                             .rebuilds = rebuilds,
                             .prunes = prunes,
                             .agreements = agreements};
}

void dem_timers_begin_advance(struct dem_timers *t, size_t particles)
{
    end_interval(t, &t->spent[DEM_PHASE_OUTSIDE]);
    t->every = (ALWAYS_TIMED + (int64_t)particles)/((int64_t)particles + 1);
    t->timed = 1;
}

/* The last half kick takes the time since the last phase. */
void dem_timers_end_advance(struct dem_timers *t)
{
    end_phase(t, DEM_PHASE_BODIES);
}

void dem_timers_begin_step(struct dem_timers *t)
{
    const int was_timed = t->timed;

    t->timed = t->every <= 1 || t->steps%t->every == t->every - 1;
    t->steps++;
    if (t->timed && !was_timed)
    {
        end_interval(t, &t->untimed);
    }
}

void dem_timers_end_phase(struct dem_timers *t, enum dem_phase phase)
{
    if (t->timed)
    {
        end_interval(t, &t->spent[phase]);
    }
}

void dem_timers_begin_rare_phase(struct dem_timers *t, enum dem_phase before)
{
    end_phase(t, before);
}

void dem_timers_end_rare_phase(struct dem_timers *t, enum dem_phase phase)
{
    end_interval(t, &t->spent[phase]);
}

void dem_timers_end_outside(struct dem_timers *t)
{
    end_interval(t, &t->spent[DEM_PHASE_OUTSIDE]);
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

const char *dem_phase_name(enum dem_phase phase)
{
    static const char *const names[DEM_PHASES] = {"drift", "agree", "refresh", "prune",
                                                  "contacts", "sums", "bodies", "rebuild",
                                                  "averages", "backup", "device", "outside"};

    return names[phase];
}
