/*
 * rolling_spring.c -- a contact resists rolling like a spring that can slip.
 *
 *   M = -k_r theta - c_r w_r,   |M| <= mu_r R* max(F_n, 0),   k_r = K k_n R*^2
 *   c_r = 2 zeta sqrt(k_r I),   I = 7/5 m* R*^2
 *
 *   M      moment on i, the opposite on j                          [N m]
 *   theta  angle of rolling, normal to n                           [rad]  remembered
 *   w_r    relative spin w_i - w_j without its twist about n       [1/s]
 *   R*     reduced radius, R_i R_j/(R_i + R_j); R_i at a wall      [m]
 *   F_n    total normal force, repulsion positive                  [N]
 *   k_n    secant stiffness, from the normal law's effect          [N/m]
 *   K      stiffness, a setting; 0: 6 G* / E*, which makes k_r = k_t R*^2 with mindlin's k_t = 8 G* sqrt(R* d)        [1]
 *   m*     reduced mass                                            [kg]
 *   mu_r   rolling friction, a setting                             [1]
 *   zeta   damping, a setting                                      [1]
 *
 * It carries a sphere on a slope up to tan(slope) = mu_r, and lets it roll above with 5/7 g (sin - mu_r cos). Without a
 * dashpot a sphere that came to rest swings about its place, at sqrt(k_r/I) on a plane that it does not slip on.
 *
 * I is the inertia of a sphere that rolls on a plane, for which zeta = 1 is critical; two equal spheres, turning against
 * each other, have 8/5 m* R*^2 and are damped by 0.94 zeta. The dashpot counts to the limit, as with friction: see
 * slider.h, also for how theta turns with the pair.
 *
 * Source: type C of Ai, Chen, Rotter, Ooi, Powder Technol. 206 (2011) 269; stiffness: Iwashita and Oda, J. Eng. Mech. 124
 * (1998) 285. Changed from Ai et al.:
 *   k_r        theirs, 2.25 k_n mu_r^2 R*^2, is the setting 2.25 mu_r^2; Iwashita and Oda's is the default.
 *   the angle  is remembered and not the moment: a moment kept while k_n falls gives back more work than it took.
 *   in space   theirs is a plane model; here theta is a vector that turns with the contact.
 *   the limit  holds for spring and dashpot together; pulling (F_n < 0) does not count.
 *   I          theirs, 1/(1/(I_i + m_i R_i^2) + 1/(I_j + m_j R_j^2)), is 4 times as large for equal spheres, and the
 *              same at a wall.
 * Not here: twisting about the normal (see twistingSpring); rolling under a pull of adhesion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/slider.h"

struct rolling_spring
{
    double friction;
    double stiffness;
    double damping;
    double ratio;                                         /* 1    K, derived */
};

static const struct dem_field settings[] = {
    DEM_FIELD(rolling_spring, friction, "1", DEM_FIELD_REQUIRED, 0.0, 10.0, "largest moment per R* F_n; slope that holds"),
    DEM_FIELD(rolling_spring, stiffness, "1", 0.0, 0.0, 3.0,
              "k_r per k_n R*^2; 0: as that of mindlin, k_t R*^2. Ai et al.: 2.25 friction^2"),
    DEM_FIELD(rolling_spring, damping, "1", 0.0, 0.0, 1.0, "of rolling to and fro on a plane, 1 is critical"),
    {0},
};

static const char *const memory[] = {"rolling_x", "rolling_y", "rolling_z", NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct rolling_spring *rolling = of;

    DEM_REQUIRE(pair->exponent > 0.0, DEM_ERROR_INPUT,
                "rollingSpring between %s and %s: there is no normal law to roll under; add one to the effects, hertz for "
                "example", pair->a->name, pair->b->name);
    rolling->ratio = rolling->stiffness > 0.0 ? rolling->stiffness : 6.0*pair->reduced_shear/pair->reduced_modulus;
    return DEM_OK;
}

/* the slider of row c, its spring still to be put in */
static inline __attribute__((always_inline)) struct dem_slider
slider_at(const struct dem_block *b, int c, dem_real friction, dem_real ratio, dem_real twice_zeta, dem_real often)
{
    const dem_real hx = b->hx[c], hy = b->hy[c], hz = b->hz[c], R = b->reduced_radius[c];
    const dem_real twist = b->wx[c]*hx + b->wy[c]*hy + b->wz[c]*hz;
    const dem_real stiffness = ratio*b->kn[c]*R*R;
    const dem_real damping = twice_zeta*R*sqrt(1.4*b->reduced_mass[c]*stiffness);

    return (struct dem_slider){.stiffness = stiffness, .damping = damping,
                               .limit = dem_pick(b->fn[c] > 0.0, friction*R*b->fn[c], 0.0), .often = often,
                               .sx = b->wx[c] - twist*hx, .sy = b->wy[c] - twist*hy, .sz = b->wz[c] - twist*hz};
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *remembered)
{
    const struct rolling_spring *rolling = of;
    const dem_real friction = rolling->friction, ratio = rolling->ratio, twice_zeta = 2.0*rolling->damping, often = dem_slider_often(b);
    dem_real *restrict x = remembered[0], *restrict y = remembered[1], *restrict z = remembered[2];

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_row r = dem_row_at(b, c);
        struct dem_slider s = slider_at(b, c, friction, ratio, twice_zeta, often);

        s.xi_x = x[c];
        s.xi_y = y[c];
        s.xi_z = z[c];
        s = dem_slider_load(&r, s);

        x[c] = s.xi_x;
        y[c] = s.xi_y;
        z[c] = s.xi_z;
        dem_slider_begin(b, c, &s);
    }
    dem_slider_finish(b, (dem_real *const[3]){b->mx, b->my, b->mz}, x, y, z);
}

DEM_KERNEL
static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    const struct rolling_spring *rolling = of;
    const dem_real friction = rolling->friction, ratio = rolling->ratio, twice_zeta = 2.0*rolling->damping, often = dem_slider_often(b);
    const dem_real *restrict x = before[0], *restrict y = before[1], *restrict z = before[2];

    (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        struct dem_slider s = slider_at(b, c, friction, ratio, twice_zeta, often);

        s.xi_x = x[c];
        s.xi_y = y[c];
        s.xi_z = z[c];
        s.mass = e->inertia[c];
        s.stiffness_was = ratio*e->kn_was[c]*b->reduced_radius[c]*b->reduced_radius[c];
        dem_slider_energy(b, c, s, e);
    }
}

const struct dem_effect dem_rolling_spring = {
    .name = "rollingSpring",
    .says = "resistance to rolling: a spring that slips at mu_r R* F_n, with a dashpot if wanted",
    .source = "Ai, Chen, Rotter, Ooi 2011, type C; Iwashita and Oda 1998",
    .stage = DEM_STAGE_MOMENT,
    .needs = DEM_NEEDS_SPIN | DEM_NEEDS_SWING,
    .size = sizeof(struct rolling_spring),
    .settings = settings,
    .memory = memory,
    .forgets = 1,
    .prepare = prepare,
    .act = act,
    .energy = energy,
};
