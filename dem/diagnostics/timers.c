/*
 * timers.c -- read the clock at the ends of phases, and distribute the time of steps that were not
 * timed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "diagnostics/timers.h"
#include "core/clock.h"
#include <string.h>

enum
{
    ALWAYS_TIMED = 5000  /* particles whose step takes 0.3 ms, 1000 times ten readings */
};

static void read_clock(struct dem_timers *t, double *spent)
{
    const double now = dem_clock_wall();

    *spent += now - t->last;
    t->last = now;
}

void dem_timers_begin(struct dem_timers *t, int64_t rebuilds, int64_t prunes, int64_t agreements)
{
    *t = (struct dem_timers){.last = dem_clock_wall(),
                             .processor = dem_clock_processor(),
                             .every = 1,
                             .rebuilds = rebuilds,
                             .prunes = prunes,
                             .agreements = agreements};
}

void dem_timers_begin_advance(struct dem_timers *t, size_t particles)
{
    read_clock(t, &t->spent[DEM_PHASE_OUTSIDE]);
    t->every = (ALWAYS_TIMED + (int64_t)particles)/((int64_t)particles + 1);
    t->timed = 1;
}

/* The time since the last phase is that of the last half kick. */
void dem_timers_end_advance(struct dem_timers *t)
{
    read_clock(t, t->timed ? &t->spent[DEM_PHASE_BODIES] : &t->untimed);
}

void dem_timers_begin_step(struct dem_timers *t)
{
    const int was_timed = t->timed;

    t->timed = t->every <= 1 || t->steps%t->every == t->every - 1;
    t->steps++;
    if (t->timed && !was_timed)
    {
        read_clock(t, &t->untimed);
    }
}

void dem_timers_end_phase(struct dem_timers *t, enum dem_phase phase)
{
    if (t->timed)
    {
        read_clock(t, &t->spent[phase]);
    }
}

void dem_timers_begin_rare_phase(struct dem_timers *t, enum dem_phase before)
{
    read_clock(t, t->timed ? &t->spent[before] : &t->untimed);
}

void dem_timers_end_rare_phase(struct dem_timers *t, enum dem_phase phase)
{
    read_clock(t, &t->spent[phase]);
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
                                                  "averages", "backup", "outside"};

    return names[phase];
}
