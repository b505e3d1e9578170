/*
 * skins.c -- skins of minimal work (formulas in skins.h), and when to check them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/skins.h"
#include <math.h>
#include <string.h>

enum
{
    FIRST_CHECK = 50,             /* steps after the list was made */
    CHECK_FACTOR = 4              /* factor of each further interval */
};

/* Costs in units of one row in one step, which takes 40 ns, touching or not. Measured with 20 000
   spheres: 12 ns per particle whose displacement is evaluated, 25 ns per pair pruned, 850 ns per
   particle and 30 ns per pair searched. Half of the 850 ns is used: thick lists also cost memory,
   and agitated beds were fastest with it (outer skin 0.3 to 0.4). The minimum is flat. */
static const double displacement_cost = 0.3, prune_cost = 0.6, search_cost = 11.0, pair_cost = 0.8;

/* Limit of the factor by which skins change at a time. */
static const double max_change = 4.0;

void dem_skins_init(struct dem_skins *s, const double skin[DEM_LISTS], int tuned, double min,
                    double max)
{
    memset(s, 0, sizeof *s);
    s->tuned = tuned;
    s->min = min;
    s->max = max;
    s->next_check = FIRST_CHECK;
    for (int l = 0; l < DEM_LISTS; l++)
    {
        s->skin[l] = skin[l];
        s->rate[l] = -1.0;
    }
}

int dem_skins_are_valid(const struct dem_skins *s)
{
    /* larger integers are not exact in a double */
    const double max = 0x1p53;
    int sound = s->next_check > 0 && (double)s->next_check < max && s->fastest >= 0.0 &&
                isfinite(s->fastest);

    for (int l = 0; l < DEM_LISTS; l++)
    {
        sound = sound && s->skin[l] >= 0.0 && s->skin[l] <= s->max && s->in_use[l] >= 0.0 &&
                s->in_use[l] <= s->max && s->counted_skin[l] >= 0.0 &&
                s->counted_skin[l] <= s->max && isfinite(s->rate[l]) && s->rate[l] != 0.0 &&
                s->steps[l] >= 0 && (double)s->steps[l] < max;
    }
    for (int k = 0; k < 3; k++)
    {
        sound = sound && s->counted[k] >= 0 && (double)s->counted[k] < max;
    }
    return sound;
}

void dem_skins_list_made(struct dem_skins *s, enum dem_list list)
{
    s->steps[list] = 0;
    s->in_use[list] = s->skin[list];
    s->next_check = FIRST_CHECK;
}

void dem_skins_count(struct dem_skins *s, const int64_t counted[3])
{
    memcpy(s->counted, counted, sizeof s->counted);
    memcpy(s->counted_skin, s->in_use, sizeof s->counted_skin);
}

int dem_skins_step(struct dem_skins *s, double fastest)
{
    s->fastest = fastest;
    s->steps[DEM_LIST_OUTER]++;
    s->steps[DEM_LIST_INNER]++;
    if (!s->tuned || s->steps[DEM_LIST_INNER] < s->next_check)
    {
        return 0;
    }
    s->next_check *= CHECK_FACTOR;
    return 1;
}

static double clamp(double min, double x, double max)
{
    return x < min ? min : x > max ? max : x;
}

/* Fixed-point iteration of the two formulas; S enters the first under a root, so a few rounds
   suffice. */
static void minimize_work(const struct dem_skins *s, double n, double R, double k,
                          double best[DEM_LISTS])
{
    const double u = s->rate[DEM_LIST_INNER], U = s->rate[DEM_LIST_OUTER], v = fmax(s->fastest, u);

    best[DEM_LIST_OUTER] = s->skin[DEM_LIST_OUTER];
    for (int round = 0; round < 8; round++)
    {
        best[DEM_LIST_INNER] = clamp(s->min,
                                     sqrt(2.0*
                                          (v*displacement_cost*n +
                                           u*prune_cost*(R + k*best[DEM_LIST_OUTER]))/
                                          k),
                                     s->max);
        best[DEM_LIST_OUTER] = clamp(s->min,
                                     sqrt(U/u*(search_cost*n + pair_cost*R)*
                                          best[DEM_LIST_INNER]/(prune_cost*k)),
                                     s->max);
    }
    best[DEM_LIST_OUTER] = fmax(best[DEM_LIST_OUTER], best[DEM_LIST_INNER]);
}

void dem_skins_choose(struct dem_skins *s, enum dem_list list, double displacement)
{
    const double n = (double)s->counted[0], pairs = (double)s->counted[1],
                 rows = (double)s->counted[2];
    const double thick = s->counted_skin[DEM_LIST_OUTER] - s->counted_skin[DEM_LIST_INNER];
    double best[DEM_LISTS], k;

    if (!s->tuned || s->steps[list] == 0 || n == 0.0)
    {
        return;
    }
    /* not zero at rest, because rates are divisors */
    s->rate[list] = fmax(displacement, 1e-12*s->max)/(double)s->steps[list];
    for (int l = 0; l < DEM_LISTS; l++)
    {
        s->rate[l] = s->rate[l] < 0.0 ? s->rate[list] : s->rate[l];
    }
    /* with equal skins, or no pairs between them, k is unknown: assume one row per particle in the
       widest skin */
    k = thick > 0.0 ? (pairs - rows)/thick : 0.0;
    k = fmax(k, n/s->max);
    minimize_work(s, n, fmax(rows - k*s->counted_skin[DEM_LIST_INNER], 0.0), k, best);
    for (int l = 0; l < DEM_LISTS; l++)
    {
        s->skin[l] = clamp(s->skin[l]/max_change, best[l], s->skin[l]*max_change);
    }
    s->skin[DEM_LIST_INNER] = fmin(s->skin[DEM_LIST_INNER], s->skin[DEM_LIST_OUTER]);
}

int dem_skins_pays(const struct dem_skins *s, enum dem_list list)
{
    /* a prune is cheap; a search saves few rows, and needs memory for the saved history */
    return s->tuned && s->skin[list] < (list == DEM_LIST_INNER ? 0.6 : 0.3)*s->in_use[list];
}
