/*
 * hooke_hysteresis.c -- a contact yields when pressed, unloads more steeply than it was loaded, and sticks.
 *
 *   F_n = k d                          loading, while d_max < d_lim
 *         k_2 (d - d_r) + k d_r        unloading and loading again, and all loading past d_lim
 *         -k_c d                       where that would be less: sticking
 *
 *   k_2 = k + (k_m - k) d_max/d_lim, at most k_m,    d_r = min(d_max, d_lim),    d_lim = k_m/(k_m - k) phi 2 R*
 *   d_max' = (d + sqrt(d^2 + 4 (k + k_c) d_lim/(k_m - k) d))/2    while sticking
 *
 *   d      overlap; d_max the largest so far                       [m]    remembered
 *   k      stiffness of the first loading: given, or from a characteristic speed (see impact.h)     [N/m]
 *   k_m    stiffness of unloading at its largest, a multiple of k  [N/m]
 *   k_c    stiffness of sticking, a multiple of k                  [N/m]
 *   phi    plastic depth: the overlap, over 2 R*, at which yielding ends (with k_m large)           [1]
 *
 * While sticking, d_max is taken back to the value whose line k_2 passes through (d, -k_c d); so pressing again goes up
 * that line. Every closed loop takes work from the motion, none gives any. Damping (dry, viscous, stokes) refers to k.
 * No adhesion: k_c = 0. Longest step: pi sqrt(m/k_m)/20.
 *
 * Guards: k_m = k is a linear spring, without yield and adhesion; phi = 0 a linear spring of k_m.
 *
 * Source: Open DEM Japan, Hooke/Hysteresis normal contact model (in Japanese, 2025), after Luding, Granul. Matter 10
 * (2008) 235 and Walton and Braun, J. Rheol. 30 (1986) 949. Changed from the note:
 *   (6), (7)    past d_lim it prints loading on k for ever and unloading from there; here as in Luding the line of
 *               k_m through (d_lim, k d_lim) is followed both ways. At 1.5 d_lim that is 3.5 k d_lim for 1.5, with k_m = 5 k.
 *   after (7)   "d_max is re-updated" has no formula there; the one above, from the condition that it names.
 *   (2)         divides by zero for k_m = k, and (4) for phi = 0: see the guards. At a wall 2 R* = 2 R_i.
 *   (8)         is dry's; the Stokes number is stokes', with the speed of the impact.
 *   (10)        max(F_n, 0) of the whole force would undo the adhesion: dry's clamped attraction clamps the dashpot's pull only.
 * Friction's limit is mu (F_n + k_c d), as in Luding: it falls to nothing where sticking is strongest (slider.h).
 * Not here: k_2 in the dashpot.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/impact.h"

struct hysteresis
{
    double stiffness, impact_speed;
    double unloading, adhesion, depth;
    struct dem_impact_spring spring;                      /* derived */
    double limit;                                         /* 1    d_lim over R*, derived */
    double stiffer;                                       /* 1    (k_m - k)/k, derived; 0: a linear spring */
};

static const struct dem_field settings[] = {
    DEM_FIELD(hysteresis, stiffness, "N/m", 0.0, 0.0, INFINITY, "k: force per overlap of first loading; 0: from the materials "
              "and impactSpeed"),
    DEM_FIELD_AS(hysteresis, impact_speed, "impactSpeed", "m/s", 1.0, DEM_ABOVE_ZERO, INFINITY,
                 "without stiffness: first loading overlaps as with hertz in an impact at this speed"),
    DEM_FIELD(hysteresis, unloading, "1", DEM_FIELD_REQUIRED, 1.0, 1e6, "k_m/k: largest stiffness of unloading; 1: no hysteresis"),
    DEM_FIELD(hysteresis, adhesion, "1", 0.0, 0.0, 1e6, "k_c/k: stiffness of sticking; 0: none"),
    DEM_FIELD_AS(hysteresis, depth, "plasticDepth", "1", 0.05, 0.0, 1.0, "phi: overlap over 2 R* at which yielding ends"),
    {0},
};

static const char *const memory[] = {"largest_overlap", NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct hysteresis *h = of;
    const int plain = h->unloading <= 1.0 + 1e-12;        /* k_m/(k_m - k) has no meaning */

    h->spring = (struct dem_impact_spring){.stiffness = h->stiffness, .speed = h->impact_speed};
    h->stiffer = plain ? 0.0 : h->unloading - 1.0;
    h->limit = plain ? 0.0 : h->unloading/h->stiffer*2.0*h->depth;
    return dem_impact_prepare(&h->spring, "hookeHysteresis", pair);
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const struct hysteresis *h = of;

    return dem_impact_limit(&h->spring, h->unloading, pair, why);
}

/* of first loading: unloading is faster */
static double contact_time(const void *of, const struct dem_pair_class *pair)
{
    return dem_impact_contact(&((const struct hysteresis *)of)->spring, 1.0, pair);
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *remembered)
{
    const struct hysteresis *h = of;
    const dem_real limit = h->limit, stiffer = h->stiffer, adhesion = h->adhesion;
    const dem_real back = 4.0*(1.0 + adhesion)/dem_pick(stiffer > 0.0, stiffer, 1.0);
    dem_real *restrict largest = remembered[0];

    dem_impact_stiffness(&h->spring, b);
    for (int c = 0; c < b->n; c++)
    {
        const dem_real k = b->kn[c], d = b->overlap[c], d_lim = limit*b->reduced_radius[c];
        const dem_real most = dem_pick(largest[c] > d, largest[c], d);
        const int hard = most >= d_lim;
        const dem_real reference = dem_pick(hard, d_lim, most);
        const dem_real k_2 = k*(1.0 + stiffer*dem_pick(hard, 1.0, most/dem_pick(d_lim > 0.0, d_lim, 1.0)));

        /* the line of unloading, between first loading and sticking */
        const dem_real line = k_2*(d - reference) + k*reference, load = k*d, stick = -adhesion*k*d;
        const dem_real upper = dem_pick(hard | (line < load), line, load);
        const int sticks = upper < stick;

        largest[c] = dem_pick(sticks, 0.5*(d + sqrt(d*d + back*d_lim*d)), most);
        b->fn[c] += dem_pick(sticks, stick, upper);
        b->grip[c] = -stick;
    }
}

/* ---- the ledger ---------------------------------------------------------------------------------------------- */

/* all in units of k of first loading: forces are lengths, energies squares of them */
struct yielded
{
    dem_real slope, start;                                /* 1, m: k_2/k of the line of unloading, and where it is zero */
    dem_real spent;                                       /* m2: plastic work of pressing to d_max */
};

/* First loading to d_max takes d_max^2/2, of which unloading gives back d_max^2/2 k/k_2; past d_lim nothing yields. */
static struct yielded yielded(const struct hysteresis *h, dem_real most, dem_real d_lim)
{
    const dem_real reference = dem_pick(most < d_lim, most, d_lim);
    const dem_real slope = 1.0 + h->stiffer*dem_pick(most < d_lim, most/dem_pick(d_lim > 0.0, d_lim, 1.0), 1.0);

    return (struct yielded){.slope = slope, .start = reference - reference/slope, .spent = 0.5*reference*reference*(1.0 - 1.0/slope)};
}

/* k_2 (d - d_0)^2/2 on the line of unloading: what comes back, pressed or stretched */
static dem_real held(struct yielded y, dem_real d)
{
    return 0.5*y.slope*(d - y.start)*(d - y.start);
}

/* Yielding spends as d_max grows. While sticking, from where the old line meets the one of k_c to here, the motion gives
   k_c d^2/2, and the line holds less and less. */
static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    const struct hysteresis *h = of;

    for (int c = 0; c < b->n; c++)
    {
        const dem_real k = b->kn[c], d = b->overlap[c], d_lim = h->limit*b->reduced_radius[c];
        const dem_real old = dem_pick(before[0][c] > d, before[0][c], d), now = memory[0][c];
        const struct yielded from = yielded(h, old, d_lim), to = yielded(h, dem_pick(now > d, now, d), d_lim);
        const struct yielded first = yielded(h, before[0][c], d_lim);

        /* memory fell: it sticks; the old line of unloading met that of sticking at `meets`, at once if it stuck before */
        const dem_real meets = from.slope*from.start/(from.slope + h->adhesion);
        const dem_real sticking = 0.5*h->adhesion*(meets*meets - d*d) + held(from, meets) - held(to, d);

        e->stored[c] = k*held(to, d);
        e->lost[c] = k*dem_pick(now < old, sticking, from.spent - first.spent);
    }
}

const struct dem_effect dem_hooke_hysteresis = {
    .name = "hookeHysteresis",
    .says = "elastic, plastic, adhesive contact of linear springs: loading k, unloading k_2, sticking k_c",
    .source = "Luding 2008; Walton and Braun 1986",
    .stage = DEM_STAGE_NORMAL,
    .exponent = 1.0,
    .size = sizeof(struct hysteresis),
    .settings = settings,
    .memory = memory,
    .prepare = prepare,
    .time_limit = time_limit,
    .contact_time = contact_time,
    .act = act,
    .energy = energy,
};
