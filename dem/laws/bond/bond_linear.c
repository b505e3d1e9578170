/*
 * bond_linear.c -- an elastic bond between two bodies: a short beam that can break.
 *
 *   F_n = k_n A (l - r) n      F_t = -k_t A u      T_n = -k_t J theta_n n      T_t = -k_n I theta_t
 *   (forces and torques on i)
 *
 *   r, l     distance of the centres (height over a wall), and its force-free value   [m]
 *   n        unit vector from j to i                                                   [1]
 *   u        displacement of the end of the beam at i relative to that at j since the bond was
 *            made, normal to n (history)                                               [m]
 *   theta    rotation of i relative to j since then: twist about n, bending normal to n
 *            (history)                                                                 [rad]
 *   k_n, k_t stiffness per area (E/L and G/L of a beam of length L)                    [Pa/m]
 *   r_b      radius of the bond, lambda min(R_i, R_j); lambda R_i at a wall            [m]
 *   A, J, I  pi r_b^2, A r_b^2/2, J/2                                                  [m2], [m4]
 *
 * Rotation of u and theta_t with the pair: by the reflection of slider.h into the new plane (the
 * smallest rotation from the old normal to the new one), then about n by the mean spin of both;
 * both keep the length (rotate.h).
 *
 * Making: `make` once at `time`, always from then on, or once for the pairs listed in the scene;
 * where r is at most makeDistance (R_i + R_j), with a probability that depends on the seed and the
 * two ids only, with `redraw` on the time of the meeting, too. New bonds are free of stress.
 * Damping (added to the forces, not to the breaking criteria): viscous, c = 2 zeta sqrt(k m), with
 * m = m*, 2/7 m* for slip and I* for rotations; or a fraction of the force of each spring against
 * its velocity v, F - eta |F| v/max(|v|, v_s), v_s = |F| dt/m (eta may differ between stretching,
 * shear, twist and bending): the velocity change by the force in one step, so that the damping
 * never reverses a motion. Relaxation: every spring is multiplied by exp(-eta dt) in a step, the
 * normal one by a change of l.
 *
 * Breaking, when any of these is reached (0 switches the first two off):
 *
 *   sigma = -F_n/A + |T_t| r_b/I >= normalStrength    (times strengthRatio while r > l)
 *   tau   =  |F_t|/A + |T_n| r_b/J >= max(0, shearStrength + internalFriction F_n/A)
 *   r >= breakDistance (R_i + R_j)                    (F_n > 0 is compression)
 *
 * Then the stored energy is dissipated, and the bond has no effect any more. A broken pair bonds
 * again only after it has been farther apart than makeDistance.
 *
 * Contact of a bonded pair: with `contact replaced`, the default, no contact law acts while the
 * bond holds (its k_n is the stiffness of the material between the centres; both together would
 * count it twice). Contact energy at the making is dissipated. When the bond breaks, the contact
 * takes over as much of the compressive force as its overlap can carry, and none in tension: the
 * surfaces count as worn by the rest of the overlap, so that the force does not jump up, and the
 * wear decreases as they separate. Adhesion (jkr, sjkr) belongs to the surfaces: it ends where a
 * bond is made and returns after they have separated. With `contact parallel`, as in Potyondy and
 * Cundall, the bond is added to the contact.
 *
 * Largest time step: 0.2 of 2/w, w = the largest of 2 sqrt(k_n A/m), sqrt(k_t A L^2/I_p),
 * 2 sqrt(k_t J/I_p), 2 sqrt(k_n I/I_p) of a chain of the smallest particles, L = 2 R. There the
 * fastest of these motions is 0.68 % too fast (7.2 % at three times that). Clumps count with a sphere of
 * a smaller radius (particles/clump_shape.h).
 *
 * Source: the note "linear bond model" of Open DEM Japan (2025), after Potyondy and Cundall, Int.
 * J. Rock Mech. Min. Sci. 41 (2004) 1329. Changed from the note:
 *   (5)        slip is v_t - (a_i w_i + a_j w_j) x n with n from j to i (two signs; as printed, a
 *              pair that rotates as a rigid body is sheared); the lever arms a meet in the middle
 *              of the gap and sum to r, instead of R_i, R_j.
 *   (6)        the old force is rotated; the note drops its component along the new n.
 *   (7), (8)   rotations are of the relative spin w_i - w_j.
 *   (9), (10)  sgn of a vector depends on the axes: replaced by its smoothed direction; viscous
 *              damping is the default.
 *   (11)       exp(-eta dt), not 1 - eta dt; the loss is E (1 - exp(-2 eta dt)), the integrals of
 *              the note are powers.
 *   (12)       T_i = -a_i n x F_t + T_n + T_t and T_j = -a_j n x F_t - T_n - T_t: with T_j = -T_i a
 *              sheared pair would gain spin.
 *   (13)       tension has a sign; absNormal counts both, as the note does.
 *   (14) (ii)  sigma is a stress already and not divided by A; of it only F_n/A counts, and the
 *              limit is at least 0.
 * Not here: strain-dependent stiffness, bonds of three bodies, heating by the dissipated energy.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/bond/bond_linear.h"
#include "laws/effect.h"

static const char *const makings[] = {"once", "always", "listed", NULL};

static const char *const contacts[] = {"replaced", "parallel", NULL};

static const struct dem_setting settings[] = {
    DEM_SETTING_AS(dem_bond_linear, normal_stiffness, "normalStiffness", "Pa/m",
                   DEM_SETTING_REQUIRED, DEM_ABOVE_ZERO, INFINITY,
                   "force per area and elongation: Young's modulus over length of a beam"),
    DEM_SETTING_AS(dem_bond_linear, shear_stiffness, "shearStiffness", "Pa/m", DEM_SETTING_REQUIRED,
                   0.0, INFINITY, "force per area and slip: shear modulus over length"),
    DEM_SETTING(dem_bond_linear, radius, "1", 1.0, DEM_ABOVE_ZERO, 10.0,
                "lambda: radius of the bond over the radius of the smaller partner"),
    DEM_SETTING_CHOICE(
        dem_bond_linear, make, "make", DEM_BOND_MAKE_ONCE, makings,
        "once at time, always from time on, or once at time for the pairs in bonds"),
    DEM_SETTING(dem_bond_linear, time, "s", 0.0, 0.0, INFINITY,
                "when make acts"),
    DEM_SETTING_AS(dem_bond_linear, make_distance, "makeDistance", "1", 1.001, 0.5, 10.0,
                   "bonds are made up to this distance of the centres over R_i + R_j"),
    DEM_SETTING(dem_bond_linear, probability, "1", 1.0, 0.0, 1.0,
                "that a pair within makeDistance is bonded"),
    DEM_SETTING_COUNT(dem_bond_linear, seed, "seed", 1.0, 0.0, 1e15,
                      "of the random numbers of probability"),
    DEM_SETTING_SWITCH(dem_bond_linear, redraw, "redraw", 0,
                       "draw probability again each time a pair comes within makeDistance"),
    DEM_SETTING_SWITCH(dem_bond_linear, walls, "walls", 0, "bonds are also made to walls"),
    DEM_SETTING_CHOICE(dem_bond_linear, contact, "contact", DEM_BOND_CONTACT_REPLACED, contacts,
                       "contact laws of a bonded pair: replaced by the bond, or parallel to it"),
    DEM_SETTING_AS(dem_bond_linear, damping_ratio, "dampingRatio", "1", 0.0, 0.0, 1.0,
                   "zeta: viscous damping, 1 is critical for an isolated pair"),
    DEM_SETTING_AS(dem_bond_linear, damping_share, "dampingShare", "1", 0.0, 0.0, 1.0,
                   "damping force as a fraction of the force of each spring, against its velocity"),
    DEM_SETTING_AS(dem_bond_linear, own_share[0], "normalDampingShare", "1", -1.0, 0.0, 1.0,
                   "of stretching; -1: dampingShare"),
    DEM_SETTING_AS(dem_bond_linear, own_share[1], "shearDampingShare", "1", -1.0, 0.0, 1.0,
                   "of shear; -1: dampingShare"),
    DEM_SETTING_AS(dem_bond_linear, own_share[2], "twistDampingShare", "1", -1.0, 0.0, 1.0,
                   "of twist; -1: dampingShare"),
    DEM_SETTING_AS(dem_bond_linear, own_share[3], "bendingDampingShare", "1", -1.0, 0.0, 1.0,
                   "of bending; -1: dampingShare"),
    DEM_SETTING(dem_bond_linear, relaxation, "1/s", 0.0, 0.0, INFINITY,
                "eta: forces decay as exp(-eta t)"),
    DEM_SETTING_AS(dem_bond_linear, normal_strength, "normalStrength", "Pa", 0.0, 0.0, INFINITY,
                   "tensile stress of tension and bending at which bonds break; 0: never"),
    DEM_SETTING_AS(dem_bond_linear, strength_ratio, "strengthRatio", "1", 1.0, DEM_ABOVE_ZERO, 1e3,
                   "factor on normalStrength while the bond is stretched"),
    DEM_SETTING_SWITCH(dem_bond_linear, abs_normal, "absNormal", 0,
                       "compression counts like tension against normalStrength"),
    DEM_SETTING_AS(dem_bond_linear, shear_strength, "shearStrength", "Pa", 0.0, 0.0, INFINITY,
                   "shear stress of shear and twist at which bonds break; 0: never"),
    DEM_SETTING_AS(dem_bond_linear, friction, "internalFriction", "1", 0.0, 0.0, 100.0,
                   "tan(phi): increase of shearStrength per compressive stress (Drucker-Prager)"),
    DEM_SETTING_AS(
        dem_bond_linear, break_distance, "breakDistance", "1", 1.1, DEM_ABOVE_ZERO, 100.0,
        "bonds break at this distance of the centres over R_i + R_j; widens the pair search"),
    {0},
};

static const char *const history_names[] =
    {"bond_length", "bond_worn", "bond_shear_x", "bond_shear_y", "bond_shear_z",
     "bond_twist",  "bond_bend_x", "bond_bend_y", "bond_bend_z", "bond_asked",
     NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_bond_linear *bond = of;

    DEM_REQUIRE(
        bond->break_distance > bond->make_distance, DEM_ERROR_INPUT,
        "bondLinear between %s and %s: breakDistance %g is not above makeDistance %g, so bonds would break when made; raise "
        "breakDistance",
        pair->a->name, pair->b->name, bond->break_distance, bond->make_distance);
    DEM_REQUIRE(
        bond->friction == 0.0 || bond->shear_strength > 0.0, DEM_ERROR_INPUT,
        "bondLinear between %s and %s: internalFriction %g adds to shearStrength, which is not given; give it, or internalFriction 0",
        pair->a->name, pair->b->name, bond->friction);
    DEM_REQUIRE(
        bond->friction <= 10.0, DEM_ERROR_INPUT,
        "bondLinear between %s and %s: internalFriction %g is the tangent of the friction angle, tan(phi), at most 10 (84 "
        "degrees); for an angle of %g degrees give %.4g",
        pair->a->name, pair->b->name, bond->friction, bond->friction,
        tan(bond->friction*(3.14159265358979324/180.0)));
    for (int k = 0; k < 4; k++)
    {
        bond->share[k] = bond->own_share[k] < 0.0 ? bond->damping_share : bond->own_share[k];
    }
    DEM_REQUIRE(
        !bond->redraw || bond->make == DEM_BOND_MAKE_ALWAYS, DEM_ERROR_INPUT,
        "bondLinear between %s and %s: redraw yes needs make always: with make %s each pair is drawn once; change one of them",
        pair->a->name, pair->b->name, makings[bond->make]);
    bond->inverse_exponent = pair->exponent > 0.0 ? 1.0/pair->exponent : 1.0;
    bond->inertia = pair->with_wall ? 0.4 : 1.6;    /* 2/5 m R^2; of two equal spheres R = 2 R* */
    bond->idle = pair->with_wall && !bond->walls;
    return DEM_OK;
}

static double reach(const void *of, const struct dem_pair_class *pair)
{
    const struct dem_bond_linear *bond = of;

    return bond->idle || bond->break_distance < 1.0
               ? 0.0
               : (bond->break_distance - 1.0)*pair->max_radius_sum;
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const struct dem_bond_linear *bond = of;
    const double equal = pair->with_wall ? 1.0 : 2.0, R = equal*pair->bond_radius,
                 m = equal*pair->bond_mass, I_p = 0.4*m*R*R;
    const double rb = bond->radius*R, A = 3.14159265358979324*rb*rb, J = 0.5*A*rb*rb;
    const double axial = 4.0*bond->normal_stiffness*A/m,
                 rocking = bond->shear_stiffness*A*4.0*R*R/I_p;
    const double twist = 4.0*bond->shear_stiffness*J/I_p, bend = 2.0*bond->normal_stiffness*J/I_p;

    *why = "0.2 of the stability limit of a chain of linear bonds";
    return bond->idle ? DBL_MAX : 0.4/sqrt(fmax(fmax(axial, rocking), fmax(twist, bend)));
}

/* ---- loops ----------------------------------------------------------------------------------- */

#define LOOP replace_contact
#define LAW dem_bond_linear
#define ROW dem_bond_linear_replace_row
#define COLUMNS (DEM_BOND_WORN + 1)
#define SETS DEM_SETS_REPLACED | DEM_SETS_TOUCHING
#include "laws/contact_loop.h"

#define LOOP make
#define LAW dem_bond_linear
#define COLUMNS dem_bond_linear_columns
#define ROW dem_bond_linear_make_row
#define SETS DEM_SETS_REPLACED | DEM_SETS_LOST
#define ENERGY
#include "laws/contact_loop.h"

#define LOOP hold
#define LAW dem_bond_linear
#define ROW dem_bond_linear_hold_row
#define COLUMNS DEM_BOND_ASKED
#define SETS DEM_SETS_FN | DEM_SETS_FORCE | DEM_SETS_MOMENT | DEM_SETS_STORED | \
    DEM_SETS_LOST | DEM_SETS_BONDS
#include "laws/contact_loop.h"

#define LOOP hand_over
#define LAW dem_bond_linear
#define ROW dem_bond_linear_hand_over_row
#define COLUMNS (DEM_BOND_WORN + 1)
#define SETS DEM_SETS_FN | DEM_SETS_LOST
#include "laws/contact_loop.h"

static int any_broke(const struct dem_contact_batch *b)
{
    double broken = 0.0;

    for (int c = 0; c < b->n; c++)
    {
        broken += b->broke[c];
    }
    return broken > 0.0;
}

/* dem_bond_linear_row in loops, two of which are needed in few steps only */
static void apply(const void *of, struct dem_contact_batch *restrict b, double *const *history)
{
    if (dem_bond_linear_makes(of, b->time, b->previous_time))
    {
        make(of, b, history);
    }
    hold(of, b, history);
    if (any_broke(b))
    {
        hand_over(of, b, history);
    }
}

static int makes_listed(const void *of)
{
    return ((const struct dem_bond_linear *)of)->make == DEM_BOND_MAKE_LISTED;
}

const struct dem_effect dem_bond_linear = {
    .name = "bondLinear",
    .summary =
        "elastic bond in tension, shear, twist and bending, with rules for making and breaking",
    .source = "Open DEM Japan 2025, corrected; Potyondy and Cundall 2004",
    .stage = DEM_STAGE_BOND,
    .needs = DEM_NEEDS_SPIN | DEM_NEEDS_NORMAL_SPIN | DEM_NEEDS_RANDOM,
    .example = "normalStiffness 1e9; shearStiffness 1e9;",
    .size = sizeof(struct dem_bond_linear),
    .settings = settings,
    .history = history_names,
    .listed_column = "bond_asked",
    .makes_listed = makes_listed,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .replace_contact = replace_contact,
    .apply = apply,
    .energy = energy,
    .adhesive = dem_effect_always,
};
