/*
 * lubrication.c -- normal lubrication force of the fluid film between two close surfaces.
 *
 *   F_n = -c v_n,    c = 6 pi mu R*^2 (1/max(h, h_r) - 1/h_c)    for h < h_c,    0 beyond
 *
 *   h    gap between the surfaces, negative in contact             [m]
 *   v_n  normal relative velocity, negative on approach            [m/s]
 *   mu   viscosity, a setting or the coupled fluid's               [Pa s]
 *   R*   reduced radius, R_i R_j/(R_i + R_j); R_i at a wall        [m]
 *   h_r  roughness: at smaller gaps, and in contact, fluid escapes between the asperities   [m]
 *   h_c  cut-off: at larger gaps the drag law contains the interaction                      [m]
 *
 * This is the leading term of the squeeze film, valid for h << R*, less its value at h_c, so that
 * the force begins at zero. With c_0 = 6 pi mu R*^2, a sphere that comes from h_c with the speed v
 *
 *   meets the asperities with  v - v_c,  v_c = (c_0/m*) (ln(h_c/h_r) - 1 + h_r/h_c)
 *   meets the surface with     v - v_t,  v_t = (c_0/m*) ln(h_c/h_r)
 *
 * and with a dry restitution e returns to h_c with e (v - v_t) - v_t, hence not at all below
 * v = v_t (1 + 1/e). In contact the film does not act (`contact rests`, the default): no liquid is
 * left to be squeezed out between surfaces in contact, and most resolved simulations do it so. With
 * `contact acts` it continues to act with the thickness of the asperities and dissipates more the
 * longer the contact lasts: the factor exp(-c_0 t_c/(2 h_r m*)) on the speed, which may be
 * the whole of it for a contact softer than real. Steel of 6 mm at St = 27, h_r = 1e-4 R, h_c = 0.1
 * R: restitution is 0.46 with `rests` (measured 0.48), 0.09 with `acts` and the contact time of
 * steel, and 0 with a modulus of 1e9 Pa (tutorials/rebound).
 *
 * The damper of a thin film is stiff. It is limited to min(c, m* / (4 dt)), so that a particle
 * surrounded by films (12 neighbours) does not overshoot at any viscosity of a coupled fluid. With
 * the setting `viscosity` the largest time step is 0.2 m* / c at h_r, and this limiter is never
 * active. At that step the thinnest film stops a particle 12 % too fast, at three times that the
 * limiter makes it 52 % too slow.
 *
 * Source: Brenner, Chem. Eng. Sci. 16 (1961) 242 (leading term); the subtraction: Nguyen and Ladd,
 * Phys. Rev. E 66 (2002) 046708; roughness: Davis, Serayssol, Hinch, J. Fluid Mech. 163 (1986) 479,
 * and Smart and Leighton, Phys. Fluids A 1 (1989) 52; no film force in contact: Kempe, Froehlich,
 * J. Fluid Mech. 709 (2012) 445; Biegert, Vowinckel, Meiburg, J. Comput. Phys. 340 (2017) 105.
 * Not here: tangential and rolling films (ln(1/h) terms), elastohydrodynamic deformation. It cannot
 * be combined with stokesDamping, whose restitution already contains the loss in the film.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/film_loss.h"
#include "laws/contact/lubrication.h"
#include "laws/effect.h"

static const char *const contacts[] = {"acts", "rests", NULL};

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_lubrication, viscosity, "Pa s", 0.0, 0.0, INFINITY,
                "of the fluid in the gap; 0: of the run's fluid"),
    DEM_SETTING(dem_lubrication, roughness, "m", DEM_SETTING_REQUIRED, DEM_ABOVE_ZERO, INFINITY,
                "height of the asperities: the thinnest film"),
    DEM_SETTING_AS(dem_lubrication, cut_off, "cutOff", "m", DEM_SETTING_REQUIRED, DEM_ABOVE_ZERO,
                   INFINITY,
                   "gap beyond which the force is zero; much smaller than the radius, much "
                   "larger than roughness"),
    DEM_SETTING_CHOICE(
        dem_lubrication, contact, "contact", DEM_LUBRICATION_RESTS, contacts,
        "whether the film acts while surfaces touch; it then stops particles that are softer "
        "than real"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    const struct dem_lubrication *film = of;

    DEM_REQUIRE(
        film->cut_off > film->roughness, DEM_ERROR_INPUT,
        "lubrication between %s and %s: cutOff %g m is not above roughness %g m; the film acts between the two, so raise "
        "cutOff or reduce roughness",
        pair->a->name, pair->b->name, film->cut_off, film->roughness);
    return DEM_OK;
}

static double reach(const void *of, const struct dem_pair_class *pair)
{
    (void)pair;
    return ((const struct dem_lubrication *)of)->cut_off;
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const struct dem_lubrication *film = of;
    const double over_thickness = 1.0/film->roughness - 1.0/film->cut_off,
                 c = dem_lubrication_damping(film->viscosity, pair->min_radius, over_thickness);

    *why = "0.2 of the time in which the thinnest film stops a particle (lubrication)";
    return c > 0.0 ? 0.2*pair->min_mass/c : DBL_MAX;
}

#define LAW dem_lubrication
#define SETS DEM_SETS_FN | DEM_SETS_LOST
#include "laws/contact_loop.h"

/* judged in use only: where a film is missing, stokesDamping is the simpler law */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    return of && dem_film_loss(g, v);
}

const struct dem_effect dem_lubrication = {
    .name = "lubrication",
    .summary = "squeeze film between two close surfaces: F_n = -6 pi mu R*^2 (1/h - 1/h_c) v_n",
    .source = "Brenner 1961; Nguyen and Ladd 2002",
    .stage = DEM_STAGE_FILM,
    .needs = DEM_NEEDS_VISCOSITY,
    .excludes = "stokesDamping",
    .example = "roughness 1e-6; cutOff 5e-5;",
    .size = sizeof(struct dem_lubrication),
    .settings = settings,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .apply = apply,
    .relevance = relevance,
    .mechanism = DEM_MECHANISM_FILM,
};
