/*
 * phases.c -- reading the clock, or not.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/phases.h"
#include "base/clock.h"
#include <string.h>

enum
{
    ENOUGH = 5000                                         /* particles whose step takes 1000 times ten readings, 0.3 ms */
};

static void read_clock(struct dem_phases *t, double *spent)
{
    const double now = dem_clock_wall();

    *spent += now - t->last;
    t->last = now;
}

void dem_phases_begin(struct dem_phases *t, int64_t rebuilds, int64_t prunes)
{
    *t = (struct dem_phases){.last = dem_clock_wall(), .processor = dem_clock_processor(), .every = 1, .rebuilds = rebuilds,
                             .prunes = prunes};
}

void dem_phases_enter(struct dem_phases *t, size_t particles)
{
    read_clock(t, &t->spent[DEM_PHASE_OUTSIDE]);
    t->every = (ENOUGH + (int64_t)particles)/((int64_t)particles + 1);
    t->looks = 1;
}

/* The last half kick of an advance ends with it. */
void dem_phases_leave(struct dem_phases *t)
{
    read_clock(t, t->looks ? &t->spent[DEM_PHASE_BODIES] : &t->unseen);
}

void dem_phases_step(struct dem_phases *t)
{
    const int looked = t->looks;

    t->looks = t->every <= 1 || t->steps%t->every == t->every - 1;
    t->steps++;
    if (t->looks && !looked)
    {
        read_clock(t, &t->unseen);
    }
}

void dem_phases_end(struct dem_phases *t, enum dem_phase phase)
{
    if (t->looks)
    {
        read_clock(t, &t->spent[phase]);
    }
}

void dem_phases_rare(struct dem_phases *t, enum dem_phase before)
{
    read_clock(t, t->looks ? &t->spent[before] : &t->unseen);
}

void dem_phases_rare_end(struct dem_phases *t, enum dem_phase phase)
{
    read_clock(t, &t->spent[phase]);
}

void dem_phases_shares(const struct dem_phases *t, double spent[DEM_PHASES])
{
    double seen = 0.0;

    memcpy(spent, t->spent, sizeof t->spent);
    for (int k = 0; k < DEM_PHASE_EVERY_STEP; k++)
    {
        seen += spent[k];
    }
    for (int k = 0; k < DEM_PHASE_EVERY_STEP; k++)
    {
        spent[k] += seen > 0.0 ? t->unseen*t->spent[k]/seen : t->unseen/DEM_PHASE_EVERY_STEP;
    }
}

const char *dem_phase_name(enum dem_phase phase)
{
    static const char *const names[DEM_PHASES] = {"drift", "agree", "refresh", "prune", "contacts", "sums", "bodies", "renew",
                                                  "averages", "keep", "outside"};

    return names[phase];
}
