/*
 * lubrication.c -- the fluid between two surfaces must be squeezed out before they meet, and sucked in before they part.
 *
 *   F_n = -c v_n,    c = 6 pi mu R*^2 (1/max(h, h_r) - 1/h_c)    for h < h_c,    0 beyond
 *
 *   h    gap between the surfaces, negative in contact             [m]
 *   v_n  normal relative speed, negative on approach               [m/s]
 *   mu   viscosity, of the setting or of the running fluid         [Pa s]
 *   R*   reduced radius, R_i R_j/(R_i + R_j); R_i at a wall        [m]
 *   h_r  roughness: nearer than this, and in contact, the fluid still finds ways out between the asperities   [m]
 *   h_c  cut-off: further than this the pair's share of the flow is left to the drag of the whole             [m]
 *
 * The leading term of the squeeze film, good for h << R*; less its value at h_c, so that the force begins at zero. A
 * sphere that comes from h_c with the speed v meets the asperities with v - v_c, v_c = (c_0/m*) (ln(h_c/h_r) - 1 + h_r/h_c),
 * c_0 = 6 pi mu R*^2, and the surface with v - v_t, v_t = (c_0/m*) ln(h_c/h_r). With a dry restitution e it comes back to h_c
 * with e (v - v_t) - v_t, so not below v = v_t (1 + 1/e), when the film rests while surfaces touch (contact rests): what is
 * pressed flat has no liquid left to squeeze, and most who resolve the flow have it so. By default it acts on, at the
 * thickness of the asperities, and takes more the longer the contact lasts: exp(-c_0 t_c/(2 h_r m*)) of the speed, which in
 * a contact that was made softer than real may be all of it. Of 6 mm steel at St = 27, h_r = 1e-4 R, h_c = 0.1 R, 0.46 comes
 * back with the film at rest in contact (0.48 was measured), 0.09 when it acts on for as long as steel touches, and nothing
 * with a modulus of 1e9 Pa (tutorials/rebound).
 *
 * The damper of a thin film is stiff. It acts as min(c, m* / (4 dt)), so that a particle with films all around it (12
 * neighbours) never overshoots, whatever the viscosity of a running fluid is. With a viscosity of its own the longest step
 * is 0.2 m* / c at h_r, and the least never acts.
 *
 * Source: Brenner, Chem. Eng. Sci. 16 (1961) 242 (leading term); the subtraction: Nguyen and Ladd, Phys. Rev. E 66 (2002)
 * 046708; roughness: Davis, Serayssol, Hinch, J. Fluid Mech. 163 (1986) 479, and Smart and Leighton, Phys. Fluids A 1
 * (1989) 52.
 * At rest in contact: Kempe, Froehlich, J. Fluid Mech. 709 (2012) 445; Biegert, Vowinckel, Meiburg, J. Comput. Phys. 340 (2017) 105.
 * Not here: shearing and rolling films (ln(1/h) terms), elastohydrodynamic deformation. Never beside stokes: that one's
 * restitution has the film's loss in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "base/math.h"

struct lubrication
{
    double viscosity;
    double roughness;
    double cut_off;
    int contact;
};

enum
{
    ACTS,
    RESTS
};
static const char *const contacts[] = {"acts", "rests", NULL};

static const struct dem_field settings[] = {
    DEM_FIELD(lubrication, viscosity, "Pa s", 0.0, 0.0, INFINITY, "of the fluid in the gap; 0: that of the running fluid"),
    DEM_FIELD(lubrication, roughness, "m", DEM_FIELD_REQUIRED, DEM_ABOVE_ZERO, INFINITY,
              "height of the asperities: the film gets no thinner than this"),
    DEM_FIELD_AS(lubrication, cut_off, "cutOff", "m", DEM_FIELD_REQUIRED, DEM_ABOVE_ZERO, INFINITY,
                 "gap beyond which nothing acts; far below the radius (the law holds there), and far above roughness"),
    DEM_FIELD_CHOICE(lubrication, contact, "contact", ACTS, contacts,
                     "what the film does while surfaces touch; acting it takes more the softer, that is longer, the contact: rests "
                     "where bodies are softer than real"),
    {0},
};

static const double six_pi = 18.8495559215387594;

static int prepare(void *of, const struct dem_pair_class *pair)
{
    const struct lubrication *film = of;

    DEM_REQUIRE(film->cut_off > film->roughness, DEM_ERROR_INPUT,
                "lubrication between %s and %s: cutOff %g m is not above roughness %g m; the film acts between the two, so raise "
                "cutOff or take a smoother surface", pair->a->name, pair->b->name, film->cut_off, film->roughness);
    return DEM_OK;
}

static double reach(const void *of, const struct dem_pair_class *pair)
{
    (void)pair;
    return ((const struct lubrication *)of)->cut_off;
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const struct lubrication *film = of;
    const double R = pair->least_radius, c = six_pi*film->viscosity*R*R*(1.0/film->roughness - 1.0/film->cut_off);

    *why = "0.2 of the time in which the thinnest film stops a particle";
    return c > 0.0 ? 0.2*pair->least_mass/c : DBL_MAX;
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *memory)
{
    const struct lubrication *film = of;
    const dem_real own = film->viscosity, least = film->roughness, most = film->cut_off, dt = b->dt, step = b->longest;
    const dem_real nearest = film->contact == RESTS ? 0.0 : -INFINITY;      /* m    gap at which it ends */

    (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        const dem_real R = b->reduced_radius[c], m = b->reduced_mass[c], vn = b->vn[c];
        const dem_real mu = dem_pick(b->gap[c] > nearest, dem_pick(own > 0.0, own, b->viscosity[c]), 0.0);
        const dem_real h = dem_pick(b->gap[c] > least, b->gap[c], least);
        const dem_real thin = dem_pick(h < most, 1.0/h - 1.0/most, 0.0);
        const dem_real film_c = b->counts[c]*(six_pi*mu*R*R*thin);
        const dem_real stiff = m/(4.0*step);
        const dem_real damper = dem_pick(film_c < stiff, film_c, stiff);

        b->fn[c] -= damper*vn;
        b->lost[c] += damper*vn*dt*(vn - 0.5*damper*vn*dt/dem_pick(m > 0.0, m, 1.0));    /* exact for a pair alone */
    }
}

const struct dem_effect dem_lubrication = {
    .name = "lubrication",
    .says = "the film squeezed between two surfaces near each other: F_n = -6 pi mu R*^2 (1/h - 1/h_c) v_n",
    .source = "Brenner 1961; Nguyen and Ladd 2002",
    .stage = DEM_STAGE_FILM,
    .needs = DEM_NEEDS_VISCOSITY,
    .excludes = "stokes",
    .size = sizeof(struct lubrication),
    .settings = settings,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .act = act,
};
