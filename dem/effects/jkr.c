/*
 * jkr.c -- surfaces that stick: the whole law of Johnson, Kendall and Roberts, its tail past touching included.
 *
 *   d = a^2/R - sqrt(2 pi w a/E)        F_n = 4 E a^3/(3 R) - sqrt(8 pi w E a^3)
 *
 *   d    overlap, negative past touching                           [m]
 *   a    radius of the area of contact                             [m]
 *   w    work of adhesion, both surfaces together                  [J/m2]
 *   E, R reduced modulus, reduced radius                           [Pa], [m]
 *
 * With a_t^3 = pi w R^2/(8 E) and a = a_t x^2 this is
 *
 *   d = (a_t^2/R) (x^4 - 4 x)            F_n = (pi w R/6) (x^6 - 6 x^3)            x >= 1
 *   U = (E a_t^5/R^2) (8/15 x^10 - 16/3 x^7 + 8 x^4)                               energy, F_n = dU/dd
 *
 * The largest root of x^4 - 4 x = D in closed form: s^3 + 4 D s = 16, x = (sqrt(s) + sqrt(8/sqrt(s) - s))/2.
 * Contact begins at touching (d = 0), where the force jumps to -4/3 pi w R, and ends at d = -3 a_t^2/R (x = 1), where it
 * jumps back from -5/6 pi w R; between them it pulls at most 3/2 pi w R. Both jumps lose energy, together 7.09 (w^5 R^4/
 * E^2)^(1/3) for every contact: slower than that, bodies stick. It is booked.
 *
 * Acts beside `hertz` and takes that law's place: what is added is the difference. Damping and rolling see Hertz's part; friction's
 * limit is mu (F_n + 2 F_c), F_c = 3/2 pi w R* (Thornton 1991: slider.h). Where a bond stands in place of the surfaces (sealed)
 * nothing acts; what they held when it was made is lost (Hertz's part the bond books itself), and after it broke they stick anew when they have parted. Longest step: 1/20 of half a swing about equilibrium.
 *
 * Source: Johnson, Kendall, Roberts, Proc. R. Soc. A 324 (1971) 301; loss: Thornton and Ning, Powder Technol. 99 (1998) 154.
 * Not here: long-range attraction of stiff small bodies (DMT), peeling in shear, liquid bridges.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "base/math.h"

struct jkr
{
    double work;
    double scale;                                         /* m    pi w/(8 E*): a_t^3 = this R*^2; derived */
};

static const double pi = 3.14159265358979324;

static const struct dem_field settings[] = {
    DEM_FIELD_AS(jkr, work, "workOfAdhesion", "J/m2", DEM_FIELD_REQUIRED, 0.0, INFINITY,
                 "to part both surfaces: twice the surface energy of two alike; pull-off is 3/2 pi of it R*"),
    {0},
};

static const char *const memory[] = {"jkr_holds", NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct jkr *jkr = of;

    DEM_REQUIRE(pair->exponent == 1.5, DEM_ERROR_INPUT, "jkr between %s and %s takes the place of hertz, and there is none; add hertz to "
                "the effects", pair->a->name, pair->b->name);
    jkr->scale = pi*jkr->work/(8.0*pair->reduced_modulus);
    return DEM_OK;
}

/* a_t of a reduced radius */
static double tearing(const struct jkr *jkr, double R)
{
    return dem_pow(jkr->scale*R*R, 1.0/3.0);
}

/* R_i R_j/(R_i + R_j) is at most a quarter of the widest sum; at a flat wall it is all of it. */
static double reach(const void *of, const struct dem_pair_class *pair)
{
    const double R = pair->with_wall ? pair->widest : 0.25*pair->widest, a = tearing(of, R);

    return 3.0*a*a/R;
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    /* stiffness at x^3 = 6, where the force is zero: 0.9 6^(2/3) 4/3 E a_t */
    const double stiffness = 3.9623127*pair->reduced_modulus*tearing(of, pair->least_radius);

    *why = "1/20 of half a swing of two bodies that stick";
    return stiffness > 0.0 ? 0.05*pi*sqrt(pair->least_mass/stiffness) : DBL_MAX;
}

/* Who holds, and how: x, or 0. Friction sees it before the force is there. */
DEM_KERNEL
static void adhere(const void *of, struct dem_block *restrict b, dem_real *const *remembered)
{
    const struct jkr *jkr = of;
    const dem_real scale = jkr->scale, third = 1.0/3.0, pull = jkr->work*pi;
    const dem_real *restrict holds = remembered[0];

    for (int c = 0; c < b->n; c++)
    {
        const dem_real R = b->reduced_radius[c], a = dem_pow(scale*R*R, third), unit = a*a/dem_pick(R > 0.0, R, 1.0);
        const dem_real raw = -b->gap[c]/dem_pick(unit > 0.0, unit, 1.0), D = dem_pick(raw > -3.0, raw, -3.0);

        /* begins at touching, goes on to the end of the tail */
        const dem_real held = dem_pick(raw > -3.0, holds[c], 0.0), bare = dem_pick(b->sealed[c] > 0.0, 0.0, 1.0);
        const dem_real now = dem_pick(b->touching[c] > 0.0, 1.0, held)*dem_pick(unit > 0.0, bare, 0.0);

        const dem_real B = D*(4.0/3.0), rest = 64.0 + B*B*B, A = dem_pow(8.0 + sqrt(dem_pick(rest > 0.0, rest, 0.0)), third);
        const dem_real s = 16.0/(A*A + B + B*B/(A*A)), p = sqrt(s), under = 8.0/p - s;
        const dem_real x = 0.5*(p + sqrt(dem_pick(under > 0.0, under, 0.0))), x3 = x*x*x;

        b->note[c] = now*x;
        b->grip[c] = now*(pull*R*(x3/6.0*(x3 - 6.0) + 3.0) - b->kn[c]*b->overlap[c]);
    }
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *remembered)
{
    const struct jkr *jkr = of;
    const dem_real scale = jkr->scale, third = 1.0/3.0, pull = jkr->work*pi;
    dem_real *restrict holds = remembered[0];

    for (int c = 0; c < b->n; c++)
    {
        /* a bond may have been made since */
        const dem_real bare = dem_pick(b->sealed[c] > 0.0, 0.0, 1.0), before = holds[c], now = dem_pick(b->note[c] > 0.0, bare, 0.0);
        const dem_real R = b->reduced_radius[c], a = dem_pow(scale*R*R, third), x = b->note[c], x3 = x*x*x, x4 = x3*x;
        const dem_real hertz = b->kn[c]*b->overlap[c];

        /* the unit of energy, E a_t^5/R^2 with the reduced ones, is (pi w/8) a_t^2 */
        const dem_real energy = pull/8.0*a*a*x4*(8.0 + x3*(x3*(8.0/15.0) - 16.0/3.0));
        const dem_real torn = pull/8.0*a*a*3.2, joined = pull/8.0*a*a*30.4780;    /* x = 1; x^3 = 4: 4.8 x^4 */
        const dem_real left = dem_pick(bare > 0.0, torn, energy - 0.4*hertz*b->overlap[c]);

        b->fn[c] += now*(pull*R/6.0*x3*(x3 - 6.0) - hertz);
        b->stored[c] += now*energy;
        b->lost[c] += dem_pick(now > before, joined, dem_pick(now < before, left, 0.0));
        holds[c] = now;
    }
}

/* what act has booked is the whole law's; 2/5 F_n d of it is told by hertz */
static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    (void)of, (void)before;
    for (int c = 0; c < b->n; c++)
    {
        e->stored[c] -= memory[0][c]*0.4*b->kn[c]*b->overlap[c]*b->overlap[c];
    }
}

const struct dem_effect dem_jkr = {
    .name = "jkr",
    .says = "adhesion of elastic spheres after Johnson, Kendall and Roberts, past touching to the distance where they tear apart",
    .source = "Johnson, Kendall, Roberts 1971; Thornton and Ning 1998",
    .stage = DEM_STAGE_FILM,
    .excludes = "sjkr",
    .size = sizeof(struct jkr),
    .settings = settings,
    .memory = memory,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .adhere = adhere,
    .act = act,
    .energy = energy,
};
