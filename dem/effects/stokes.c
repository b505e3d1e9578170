/*
 * stokes.c -- in a viscous fluid two bodies part the slower, the less inertia they meet with.
 *
 *   F_n = ... - eta v_n,       eta = alpha(e) sqrt(m* k_n)
 *   ln e = ln e_max - beta/St,  St = m* v/(6 pi mu R*^2)
 *
 *   v      |normal relative speed| when the surfaces first overlap, kept until they separate   [m/s]
 *   mu     viscosity, of the setting or of the running fluid       [Pa s]
 *   m*     reduced mass, added mass of the fluid included          [kg]
 *   R*     reduced radius                                          [m]
 *   e_max  restitution without fluid                               [1]
 *   beta   35 in Legendre et al.                                   [1]
 *   alpha  depends on e and the exponent of the normal law         [1]   see restitution.h
 *
 * For a sphere and a wall St is the usual rho_p d v/(9 mu). alpha needs L = -ln e = A + beta/St, A = -ln e_max, only as
 * L/sqrt(pi^2 + L^2), so with St = S/D, S = m* v, D = 6 pi mu R*^2, it is computed as
 *
 *   alpha = sqrt(2 (p + 1)) T/sqrt(pi^2 S^2 + T^2),   T = A S + beta D
 *
 * which is finite for v = 0, mu = 0, e_max = 0 and e_max = 1: St -> 0 ends in critical damping, mu = 0 in e_max. No
 * logarithm is taken of anything that changes.
 *
 * Added mass (St only; the motion itself is not changed here): each particle counts m_i + C_M rho_f V_i. With
 * f = 1 + C_M rho_f/rho_p, m* becomes f_a m* at a wall and f_a f_b (rho_a + rho_b)/(f_a rho_a + f_b rho_b) m* in
 * a pair. That is exact at a wall, for two of the same density whatever their sizes, and for two of the same size
 * whatever their densities; for unequal sizes and densities it lies between f_a and f_b times m*, as the truth does.
 *
 * Why the speed is latched: with the signed speed of the moment in St, as LIGGGHTS has it, e = 0.48 is asked for at
 * St = 50 and 0.08 comes out. That is an option (speed instantaneous) to compare with, and for nothing else.
 * The dashpot may pull when the contact opens; clamped, small e is far too large (0.15 instead of 0.001).
 *
 * Source: Legendre, Zenit, Daniel, Guiraud, Chem. Eng. Sci. 61 (2006) 3543; measured: Gondret, Lance, Petit, Phys.
 * Fluids 14 (2002) 643; Joseph, Zenit, Hunt, Rosenwinkel, J. Fluid Mech. 433 (2001) 329. Eq. (8) of Open DEM Japan,
 * Hooke/Hysteresis normal contact model (in Japanese, 2025) takes its ln e "by the Stokes number", without a formula.
 * Changed from how that is read elsewhere: ln e_max - beta/St with St above 0 (a plus and a velocity that is negative
 * on approach return too much); the speed is of the first touch, see above.
 * Not here: lubrication before touching. Never use both: the film's loss is already in e.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/restitution.h"

struct stokes
{
    double restitution;
    double beta;
    double viscosity;
    double added_mass;
    double fluid_density;
    int speed, attraction;
    double critical;                                      /* 1    alpha at critical damping, derived */
    double loss;                                          /* 1    -ln e_max, derived */
    double more_mass;                                     /* 1    m* with added mass over m*, derived */
};

enum
{
    IMPACT,
    INSTANTANEOUS
};
static const char *const speeds[] = {"impact", "instantaneous", NULL};

static const struct dem_field settings[] = {
    DEM_FIELD(stokes, restitution, "1", DEM_FIELD_REQUIRED, 0.0, 1.0, "e_max, the restitution without fluid"),
    DEM_FIELD(stokes, beta, "1", 35.0, 0.0, 1e6, "ln e = ln e_max - beta/St"),
    DEM_FIELD(stokes, viscosity, "Pa s", 0.0, 0.0, INFINITY, "of the fluid in the gap; 0: that of the running fluid"),
    DEM_FIELD_AS(stokes, added_mass, "addedMass", "1", 0.0, 0.0, 10.0,
                 "C_M in St: each particle counts m + C_M rho_f V (0.5 for a sphere far from others); 0: none, or what virtualMass adds"),
    DEM_FIELD_AS(stokes, fluid_density, "fluidDensity", "kg/m3", 0.0, 0.0, INFINITY, "rho_f for addedMass"),
    DEM_FIELD_CHOICE(stokes, speed, "speed", IMPACT, speeds,
                     "in St: that of the impact, or for comparison that of the moment as in LIGGGHTS, which at St = 50 "
                     "makes 0.08 of 0.48, at 100 0.55 of 0.68 and at 1000 0.956 of 0.937"),
    DEM_FIELD_CHOICE(stokes, attraction, "attraction", DEM_ATTRACTION_ALLOWED, dem_attractions,
                     "whether the dashpot may pull when a contact opens; clamped 0.20 comes out for 0.03, 0.54 for 0.48, 0.70 "
                     "for 0.68"),
    {0},
};

static const char *const memory[] = {"impact_speed", NULL};

/* 1: reduced mass with added mass over that without; see the top of this page for where it is exact */
static double more_mass(const struct stokes *stokes, const struct dem_pair_class *pair)
{
    const double added = stokes->added_mass*stokes->fluid_density;    /* kg/m3 */
    const double rho_a = pair->a->density, rho_b = pair->b->density;
    const double with_a = rho_a + added, with_b = rho_b + added;

    if (pair->with_wall)
    {
        return with_a/rho_a;
    }
    return with_a/rho_a*(with_b/rho_b)*((rho_a + rho_b)/(with_a + with_b));
}

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct stokes *stokes = of;

    DEM_REQUIRE(pair->exponent > 0.0, DEM_ERROR_INPUT,
                "stokes between %s and %s: there is no normal law to damp; add one to the effects, hertz for example",
                pair->a->name, pair->b->name);
    DEM_REQUIRE(stokes->added_mass == 0.0 || stokes->fluid_density > 0.0, DEM_ERROR_INPUT,
                "stokes: addedMass %g has no effect without fluidDensity, which is %g kg/m3; give the fluid's density, "
                "or addedMass 0", stokes->added_mass, stokes->fluid_density);
    stokes->critical = dem_restitution_critical(pair->exponent);
    stokes->loss = dem_restitution_loss(stokes->restitution);
    stokes->more_mass = stokes->added_mass > 0.0 ? more_mass(stokes, pair) : 1.0;
    return DEM_OK;
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *remembered)
{
    const struct stokes *stokes = of;
    const dem_real own = stokes->viscosity, beta = stokes->beta;
    const dem_real critical = stokes->critical, loss = stokes->loss, more = stokes->more_mass;
    const dem_real six_pi = 18.8495559215387594, pi2 = DEM_RESTITUTION_PI2;
    const dem_real at_rest = 1e-30;                       /* m/s: marks a latched speed of zero */
    const dem_real least = dem_attraction_least(stokes->attraction);
    const int latch = stokes->speed == IMPACT;
    dem_real *restrict impact_speed = remembered[0];

    for (int c = 0; c < b->n; c++)
    {
        const dem_real R = b->reduced_radius[c], m = b->reduced_mass[c], before = impact_speed[c];
        const dem_real mu = dem_pick(own > 0.0, own, b->viscosity[c]);

        /* the first step of a contact finds nothing remembered */
        const dem_real now = dem_pick(fabs(b->vn[c]) > at_rest, fabs(b->vn[c]), at_rest);
        const dem_real latched = dem_pick(before > 0.0, before, now);
        const dem_real speed = dem_pick(b->touching[c] > 0.0, dem_pick(latch, latched, now), 0.0);

        /* of the moment: parting has a negative Stokes number, as LIGGGHTS has it */
        const dem_real S = more*m*speed, D = beta*(six_pi*mu*R*R);
        const dem_real T = dem_pick(latch | (b->vn[c] < 0.0), loss*S + D, fabs(loss*S - D));
        const dem_real size = sqrt(pi2*S*S + T*T);
        const dem_real eta = critical*(T/dem_pick(size > 0.0, size, 1.0))*sqrt(m*b->kn[c]);

        impact_speed[c] = speed;
        b->eta[c] = eta;
        b->fn[c] = dem_attraction(b->fn[c], eta*b->vn[c], least);
    }
}

static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    (void)of, (void)before, (void)memory;
    dem_restitution_energy(b, e);
}

const struct dem_effect dem_stokes = {
    .name = "stokes",
    .says = "viscous damping in a fluid: restitution e_max exp(-beta/St) by the Stokes number of the impact",
    .source = "Legendre, Zenit, Daniel, Guiraud 2006",
    .stage = DEM_STAGE_DAMP,
    .needs = DEM_NEEDS_VISCOSITY,
    .size = sizeof(struct stokes),
    .settings = settings,
    .memory = memory,
    .prepare = prepare,
    .act = act,
    .energy = energy,
};
