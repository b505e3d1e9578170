/*
 * linear.c -- friction: a linear spring in the contact plane that slips at mu F_n.
 *
 *   F_t = -k_t xi - eta_t s,    |F_t| <= mu max(F_n, 0)
 *
 *   xi     elongation of the spring, in the contact plane          [m]    remembered
 *   s      slip velocity of i's contact point over j's             [m/s]
 *   k_t    tangential stiffness: given, or a share of the normal law's secant stiffness k_n         [N/m]
 *   eta_t  the normal law's damping coefficient, or 0              [kg/s]
 *   mu     coefficient of friction                                 [1]
 *   F_n    total normal force, repulsion positive                  [N]
 *
 * The spring turns with the pair, gives way where it slips, and slips in the direction of spring and dashpot together: see
 * slider.h. Two spheres that stick all through an impact on linear springs return -cos(pi sqrt(7 k_t/2 k_n)) of their slip
 * with the sign turned: nothing for k_t/k_n = 1/14, all of it for 2/7, where both springs swing alike; that is the default.
 *
 * Source: Cundall and Strack, Geotechnique 29 (1979) 47; friction: Coulomb; eqs. (15) to (17) and (20) to (23) of
 * Kasuga, Discrete element method (in Japanese, 2012). Changed from the note: see mindlin.c, the same as there and why.
 * Not here: a stiffness of the materials (see mindlin); rolling.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/slider.h"

struct linear
{
    double friction, stiffness, ratio;
    int damping, adhesion;
};

static const struct dem_field settings[] = {
    DEM_FIELD(linear, friction, "1", DEM_FIELD_REQUIRED, 0.0, 100.0, "tangential force limit per normal force"),
    DEM_FIELD(linear, stiffness, "N/m", 0.0, 0.0, INFINITY, "k_t; 0: by ratio"),
    DEM_FIELD(linear, ratio, "1", 2.0/7.0, 0.0, 2.0, "without stiffness: k_t over the normal law's k_n"),
    DEM_FIELD_SWITCH(linear, damping, "tangentialDamping", 1,
                     "damp slip with the coefficient of the normal law as long as the contact sticks"),
    DEM_FIELD_SWITCH(linear, adhesion, "adhesion", 1, "adhesion presses, too: limit mu (F_n + 2 F_c) with jkr, mu (F_n + k_c d) with hookeHysteresis"),
    {0},
};

static const char *const memory[] = {"slip_x", "slip_y", "slip_z", NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct linear *linear = of;

    DEM_REQUIRE(pair->exponent > 0.0, DEM_ERROR_INPUT,
                "linear between %s and %s: there is no normal law to rub under; add one to the effects, hooke for example",
                pair->a->name, pair->b->name);
    linear->ratio = linear->stiffness > 0.0 ? 0.0 : linear->ratio;
    return DEM_OK;
}

/* the contact of a sphere that slips in place swings at sqrt(7/2 k_t/m) */
static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const double stiffness = ((const struct linear *)of)->stiffness;

    *why = "1/20 of the half swing of the spring of linear";
    return stiffness > 0.0 ? 0.05*3.14159265358979324*sqrt(pair->least_mass/(3.5*stiffness)) : DBL_MAX;
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *remembered)
{
    const struct linear *linear = of;
    const dem_real given = linear->stiffness, ratio = linear->ratio;
    const struct dem_rubbing rubs = {linear->friction, linear->damping ? 1.0 : 0.0, linear->adhesion ? 1.0 : 0.0,
                                     dem_slider_often(b)};
    dem_real *restrict xi_x = remembered[0], *restrict xi_y = remembered[1], *restrict xi_z = remembered[2];

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_row r = dem_row_at(b, c);
        const dem_real kt = given*b->touching[c] + ratio*b->kn[c];
        struct dem_slider s = dem_slider_friction(&r, kt, rubs);

        s.xi_x = xi_x[c];
        s.xi_y = xi_y[c];
        s.xi_z = xi_z[c];
        s = dem_slider_load(&r, s);

        xi_x[c] = s.xi_x;
        xi_y[c] = s.xi_y;
        xi_z[c] = s.xi_z;
        b->kt[c] = kt;
        dem_slider_begin(b, c, &s);
    }
    dem_slider_finish(b, (dem_real *const[3]){b->fx, b->fy, b->fz}, xi_x, xi_y, xi_z);
}

DEM_KERNEL
static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    const struct linear *linear = of;
    const struct dem_rubbing rubs = {linear->friction, linear->damping ? 1.0 : 0.0, linear->adhesion ? 1.0 : 0.0,
                                     dem_slider_often(b)};
    const dem_real given = linear->stiffness, ratio = linear->ratio;
    const dem_real *restrict x = before[0], *restrict y = before[1], *restrict z = before[2];

    (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        const struct dem_row r = dem_row_at(b, c);
        struct dem_slider s = dem_slider_friction(&r, b->kt[c], rubs);

        s.xi_x = x[c];
        s.xi_y = y[c];
        s.xi_z = z[c];
        s.mass = e->slip_mass[c];
        s.stiffness_was = dem_pick(e->was[c] > 0.0, given, 0.0) + ratio*e->kn_was[c];
        dem_slider_energy(b, c, s, e);
    }
}

const struct dem_effect dem_linear = {
    .name = "linear",
    .says = "friction: a linear spring in the contact plane that slips at mu F_n",
    .source = "Cundall and Strack 1979; Coulomb",
    .stage = DEM_STAGE_TANGENT,
    .needs = DEM_NEEDS_SWING,
    .size = sizeof(struct linear),
    .settings = settings,
    .memory = memory,
    .forgets = 1,
    .prepare = prepare,
    .time_limit = time_limit,
    .act = act,
    .energy = energy,
};
