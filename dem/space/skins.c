/*
 * skins.c -- the least of the work, and when to look.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/skins.h"
#include <math.h>
#include <string.h>

enum
{
    FIRST_LOOK = 50,                                      /* steps; then four times as many each time */
    LATER = 4
};

/* In near rows of one step, which take 40 ns, touching or not: measured with 20 000 spheres, 12 ns
   a particle looked at, 25 ns a pair pruned, 850 ns a particle and 30 ns
   a pair renewed. Half of the 850 is put in: thick lists also cost memory, and beds thrown into disorder were fastest so (outer skin 0.3
   to 0.4). The minimum is flat. */
static const double look = 0.3, prune = 0.6, renew = 11.0, pair = 0.8;

/* Skins change by no more at a time. */
static const double most_change = 4.0;

void dem_skins_init(struct dem_skins *s, const double skin[DEM_LISTS], int tuned, double least, double most)
{
    memset(s, 0, sizeof *s);
    s->tuned = tuned;
    s->least = least;
    s->most = most;
    s->look = FIRST_LOOK;
    for (int l = 0; l < DEM_LISTS; l++)
    {
        s->skin[l] = skin[l];
        s->rate[l] = -1.0;
    }
}

int dem_skins_are_sound(const struct dem_skins *s)
{
    const double most = 0x1p53;                           /* whole numbers that a double tells apart */
    int sound = s->look > 0 && (double)s->look < most && s->pace >= 0.0 && isfinite(s->pace);

    for (int l = 0; l < DEM_LISTS; l++)
    {
        sound = sound && s->skin[l] >= 0.0 && s->skin[l] <= s->most && s->in_use[l] >= 0.0 && s->in_use[l] <= s->most && s->wide[l] >= 0.0
             && s->wide[l] <= s->most && isfinite(s->rate[l]) && s->rate[l] != 0.0 && s->steps[l] >= 0 && (double)s->steps[l] < most;
    }
    for (int k = 0; k < 3; k++)
    {
        sound = sound && s->counted[k] >= 0 && (double)s->counted[k] < most;
    }
    return sound;
}

void dem_skins_made(struct dem_skins *s, enum dem_list list)
{
    s->steps[list] = 0;
    s->in_use[list] = s->skin[list];
    s->look = FIRST_LOOK;
}

void dem_skins_count(struct dem_skins *s, const int64_t counted[3])
{
    memcpy(s->counted, counted, sizeof s->counted);
    memcpy(s->wide, s->in_use, sizeof s->wide);
}

int dem_skins_step(struct dem_skins *s, double fastest)
{
    s->pace = fastest;
    s->steps[DEM_LIST_OUTER]++;
    s->steps[DEM_LIST_INNER]++;
    if (!s->tuned || s->steps[DEM_LIST_INNER] < s->look)
    {
        return 0;
    }
    s->look *= LATER;
    return 1;
}

static double between(double least, double x, double most)
{
    return x < least ? least : x > most ? most : x;
}

/* The two formulas of the header in turn: S enters the first under a root, so a few rounds do. */
static void least_work(const struct dem_skins *s, double n, double R, double k, double best[DEM_LISTS])
{
    const double u = s->rate[DEM_LIST_INNER], U = s->rate[DEM_LIST_OUTER], v = fmax(s->pace, u);

    best[DEM_LIST_OUTER] = s->skin[DEM_LIST_OUTER];
    for (int round = 0; round < 8; round++)
    {
        best[DEM_LIST_INNER] = between(s->least, sqrt(2.0*(v*look*n + u*prune*(R + k*best[DEM_LIST_OUTER]))/k), s->most);
        best[DEM_LIST_OUTER] = between(s->least, sqrt(U/u*(renew*n + pair*R)*best[DEM_LIST_INNER]/(prune*k)), s->most);
    }
    best[DEM_LIST_OUTER] = fmax(best[DEM_LIST_OUTER], best[DEM_LIST_INNER]);
}

void dem_skins_choose(struct dem_skins *s, enum dem_list list, double way)
{
    const double n = (double)s->counted[0], pairs = (double)s->counted[1], rows = (double)s->counted[2];
    const double thick = s->wide[DEM_LIST_OUTER] - s->wide[DEM_LIST_INNER];
    double best[DEM_LISTS], k;

    if (!s->tuned || s->steps[list] == 0 || n == 0.0)
    {
        return;
    }
    s->rate[list] = fmax(way, 1e-12*s->most)/(double)s->steps[list];    /* who rests comes no nearer: rates are divided by */
    for (int l = 0; l < DEM_LISTS; l++)
    {
        s->rate[l] = s->rate[l] < 0.0 ? s->rate[list] : s->rate[l];
    }
    /* a list without room between its skins, or without pairs there, says nothing: then one row a particle in the widest skin */
    k = thick > 0.0 ? (pairs - rows)/thick : 0.0;
    k = fmax(k, n/s->most);
    least_work(s, n, fmax(rows - k*s->wide[DEM_LIST_INNER], 0.0), k, best);
    for (int l = 0; l < DEM_LISTS; l++)
    {
        s->skin[l] = between(s->skin[l]/most_change, best[l], s->skin[l]*most_change);
    }
    s->skin[DEM_LIST_INNER] = fmin(s->skin[DEM_LIST_INNER], s->skin[DEM_LIST_OUTER]);
}

int dem_skins_pays(const struct dem_skins *s, enum dem_list list)
{
    /* a prune is cheap; a renewal saves few rows, and memory is lifted into arrays of its own for it */
    return s->tuned && s->skin[list] < (list == DEM_LIST_INNER ? 0.6 : 0.3)*s->in_use[list];
}
