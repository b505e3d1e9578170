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
 * fastest of these motions is 0.68 % too fast (7.2 % at three times that).
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
#include "laws/effect.h"

#include "core/math.h"
#include "core/random.h"
#include "laws/bond/bond_springs.h"

enum
{
    ONCE,
    ALWAYS,
    LISTED
};
static const char *const makings[] = {"once", "always", "listed", NULL};

enum
{
    REPLACED,
    PARALLEL
};
static const char *const contacts[] = {"replaced", "parallel", NULL};

struct bond
{
    double normal_stiffness, shear_stiffness, radius;
    int make, walls, contact, abs_normal, redraw;
    double time, make_distance, break_distance, probability, seed;
    double damping_ratio, damping_share, relaxation;
    double own_share[4];                                  /* 1  dampingShare of each motion */
    double normal_strength, strength_ratio, shear_strength, friction;
    double inverse_exponent, inertia;                     /* 1, 1: derived; I* = inertia m* R*^2 */
    double share[4];                                      /* 1  used, derived */
    int idle;                                             /* 1: no bonds in this pair class */
};

static const struct dem_setting settings[] = {
    DEM_SETTING_AS(bond, normal_stiffness, "normalStiffness", "Pa/m", DEM_SETTING_REQUIRED,
                   DEM_ABOVE_ZERO, INFINITY,
                   "force per area and elongation: Young's modulus over length of a beam"),
    DEM_SETTING_AS(bond, shear_stiffness, "shearStiffness", "Pa/m", DEM_SETTING_REQUIRED, 0.0,
                   INFINITY, "force per area and slip: shear modulus over length"),
    DEM_SETTING(bond, radius, "1", 1.0, DEM_ABOVE_ZERO, 10.0,
                "lambda: radius of the bond over the radius of the smaller partner"),
    DEM_SETTING_CHOICE(
        bond, make, "make", ONCE, makings,
        "when bonds are made: once at time, always from time on, or once at time for the pairs "
        "in bonds"),
    DEM_SETTING(bond, time, "s", 0.0, 0.0, INFINITY, "at which bonds are made (see make)"),
    DEM_SETTING_AS(bond, make_distance, "makeDistance", "1", 1.001, DEM_ABOVE_ZERO, 10.0,
                   "bonds are made up to this distance of the centres over R_i + R_j"),
    DEM_SETTING(bond, probability, "1", 1.0, 0.0, 1.0, "that a pair within makeDistance is bonded"),
    DEM_SETTING_COUNT(bond, seed, "seed", 1.0, 0.0, 1e15, "of the random numbers of probability"),
    DEM_SETTING_SWITCH(bond, redraw, "redraw", 0,
                       "draw probability again each time a pair comes within makeDistance"),
    DEM_SETTING_SWITCH(bond, walls, "walls", 0, "bonds are also made to walls"),
    DEM_SETTING_CHOICE(bond, contact, "contact", REPLACED, contacts,
                       "contact laws of a bonded pair: replaced by the bond, or acting parallel "
                       "to it"),
    DEM_SETTING_AS(bond, damping_ratio, "dampingRatio", "1", 0.0, 0.0, 1.0,
                   "zeta: viscous damping, 1 is critical for an isolated pair"),
    DEM_SETTING_AS(bond, damping_share, "dampingShare", "1", 0.0, 0.0, 1.0,
                   "damping force as a fraction of the force of each spring, against its velocity"),
    DEM_SETTING_AS(bond, own_share[0], "normalDampingShare", "1", -1.0, 0.0, 1.0,
                   "dampingShare of stretching; -1, not given: dampingShare"),
    DEM_SETTING_AS(bond, own_share[1], "shearDampingShare", "1", -1.0, 0.0, 1.0,
                   "dampingShare of shear; -1, not given: dampingShare"),
    DEM_SETTING_AS(bond, own_share[2], "twistDampingShare", "1", -1.0, 0.0, 1.0,
                   "dampingShare of twist; -1, not given: dampingShare"),
    DEM_SETTING_AS(bond, own_share[3], "bendingDampingShare", "1", -1.0, 0.0, 1.0,
                   "dampingShare of bending; -1, not given: dampingShare"),
    DEM_SETTING(bond, relaxation, "1/s", 0.0, 0.0, INFINITY, "eta: forces decay as exp(-eta t)"),
    DEM_SETTING_AS(bond, normal_strength, "normalStrength", "Pa", 0.0, 0.0, INFINITY,
                   "tensile stress of tension and bending at which bonds break; 0: never"),
    DEM_SETTING_AS(bond, strength_ratio, "strengthRatio", "1", 1.0, DEM_ABOVE_ZERO, 1e3,
                   "factor on normalStrength while the bond is stretched"),
    DEM_SETTING_SWITCH(bond, abs_normal, "absNormal", 0,
                       "compression counts like tension against normalStrength"),
    DEM_SETTING_AS(bond, shear_strength, "shearStrength", "Pa", 0.0, 0.0, INFINITY,
                   "shear stress of shear and twist at which bonds break; 0: never"),
    DEM_SETTING_AS(bond, friction, "internalFriction", "1", 0.0, 0.0, 100.0,
                   "tan(phi): increase of shearStrength per compressive stress (Drucker-Prager)"),
    DEM_SETTING_AS(
        bond, break_distance, "breakDistance", "1", 1.1, DEM_ABOVE_ZERO, 100.0,
        "bonds break at this distance of the centres over R_i + R_j; a larger one widens "
        "the pair search"),
    {0},
};

static const char *const history_names[] =
    {"bond_length", "bond_worn", "bond_shear_x", "bond_shear_y", "bond_shear_z",
     "bond_twist",  "bond_bend_x", "bond_bend_y", "bond_bend_z", "bond_asked",
     NULL};

/* values of LENGTH of a broken bond: the pair has not yet been farther apart than makeDistance;
   and the surfaces have not separated yet. REFUSED: with redraw, the pair was drawn and not bonded,
   and has not been farther apart since */
#define PARTED (-1.0)
#define BROKEN (-2.0)
#define REFUSED (-3.0)

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct bond *bond = of;

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
        !bond->redraw || bond->make == ALWAYS, DEM_ERROR_INPUT,
        "bondLinear between %s and %s: redraw yes needs make always: with make %s each pair is drawn once; change one of them",
        pair->a->name, pair->b->name, makings[bond->make]);
    bond->inverse_exponent = pair->exponent > 0.0 ? 1.0/pair->exponent : 1.0;
    bond->inertia = pair->with_wall ? 0.4 : 1.6;    /* 2/5 m R^2; of two equal spheres R = 2 R* */
    bond->idle = pair->with_wall && !bond->walls;
    return DEM_OK;
}

static double reach(const void *of, const struct dem_pair_class *pair)
{
    const struct bond *bond = of;

    return bond->idle || bond->break_distance < 1.0
               ? 0.0
               : (bond->break_distance - 1.0)*pair->max_radius_sum;
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const struct bond *bond = of;
    const double equal = pair->with_wall ? 1.0 : 2.0, R = equal*pair->min_radius,
                 m = equal*pair->min_mass, I_p = 0.4*m*R*R;
    const double rb = bond->radius*R, A = 3.14159265358979324*rb*rb, J = 0.5*A*rb*rb;
    const double axial = 4.0*bond->normal_stiffness*A/m,
                 rocking = bond->shear_stiffness*A*4.0*R*R/I_p;
    const double twist = 4.0*bond->shear_stiffness*J/I_p, bend = 2.0*bond->normal_stiffness*J/I_p;

    *why = "0.2 of the stability limit of a chain of linear bonds";
    return bond->idle ? DBL_MAX : 0.4/sqrt(fmax(fmax(axial, rocking), fmax(twist, bend)));
}

/* ---- before the contact laws --------------------------------------------------------------------------------- */

DEM_MATH void shield_row(const struct bond *bond, struct dem_contact_row *r, double *values)
{
    const double replaces = dem_select(bond->contact == REPLACED, 1.0, 0.0);
    /* a pair that never bonds again must not keep a history: it would depend on how long the
       pair has been in the list */
    const double parted = dem_select(bond->make == ALWAYS, PARTED, 0.0);
    const double length = values[LENGTH], worn = values[WORN];

    /* a bonded pair keeps its overlap (needed by hand_over), but not the history of its contact */
    const double replaced = dem_select(length > 0.0, replaces, 0.0);
    const double less = dem_select(worn < r->overlap, worn, r->overlap), left = r->overlap - less;

    /* after a bond has broken, surfaces do not adhere before they have separated */
    const double now = dem_select((length == BROKEN) & (r->overlap == 0.0), parted, length);

    r->bond_replaces = dem_select(now == BROKEN, replaces, replaced);
    r->overlap = left;
    r->touching = (1.0 - replaced)*dem_select(left > 0.0, r->touching, 0.0);
    values[LENGTH] = now;
    values[WORN] = less;
}

#define LOOP shield
#define LAW bond
#define ROW shield_row
#define COLUMNS (WORN + 1)
#define SETS DEM_SETS_REPLACED
#include "laws/contact_loop.h"

/* ---- making -------------------------------------------------------------------------------------------------- */

/* random number in 0 .. 1 of a pair; with redraw of the time, too, at which it meets */
static double drawn(const struct bond *bond, double chance, double time)
{
    return dem_random_unit((uint64_t)bond->seed, dem_math_bits(chance),
                           bond->redraw ? dem_math_bits(time) : 0, 0);
}

/* Makes bonds. In the first evaluation of a run, `previous_time` is -infinity: bonds are made if `time`
   has been reached; afterwards in the step that passes it. */
static void make(const struct bond *bond, struct dem_contact_batch *b, double *const *history)
{
    const int once = b->previous_time < bond->time && b->time >= bond->time,
              from_now_on = b->time >= bond->time;
    double *const length = history[LENGTH];

    for (int c = 0; (bond->make == ALWAYS ? from_now_on : once) && !bond->idle && c < b->n; c++)
    {
        const double width = b->distance[c] - b->gap[c];
        const int near = b->is_primary[c] > 0.0 && b->distance[c] > 0.0 &&
                         b->distance[c] <= bond->make_distance*width;

        length[c] = length[c] < 0.0 && !near ? 0.0 : length[c];
        if (!near || length[c] != 0.0 || (bond->make == LISTED && !(history[ASKED][c] > 0.0)))
        {
            continue;
        }
        if (drawn(bond, b->pair_random[c], b->time) >= bond->probability)
        {
            length[c] = bond->redraw ? REFUSED : 0.0;
        }
        else
        {
            length[c] = b->distance[c];
            history[WORN][c] = 0.0;
            b->bond_replaces[c] = bond->contact == REPLACED ? 2.0 : 0.0;
            /* energy of the replaced contact is dissipated; F = k d ~ d^p stores F d/(p + 1) */
            b->lost[c] += bond->contact == REPLACED ? b->kn[c]*b->overlap[c]*b->overlap[c]/
                                                          (1.0 + 1.0/bond->inverse_exponent)
                                                    : 0.0;
        }
    }
}

/* ---- forces -------------------------------------------------------------------------------------------------- */

/* Damping coefficient of a spring with |F| = force and |v| = rate: viscous, and the fraction of
   the force. mass: effective mass or inertia. */
DEM_MATH double damper(const struct bond *bond, int motion, double stiffness, double force,
                         double rate, double mass, double dt)
{
    const double min_rate =
        dem_select(mass > 0.0, force*dt/dem_select(mass > 0.0, mass, 1.0), 0.0);
    const double speed = dem_select(rate > min_rate, rate, min_rate);

    return 2.0*bond->damping_ratio*sqrt(stiffness*mass) +
           bond->share[motion]*force/dem_select(speed > 0.0, speed, 1.0);
}

/* 0: the bond holds, 1: sigma breaks it, 2: tau breaks it. force: F_n, positive in compression,
   |F_t|, |T_n|, |T_t|. */
DEM_MATH double breaks(const struct bond *bond, double rb, const double force[4],
                         double stretched)
{
    const double A = 3.14159265358979324*rb*rb,
                   inverse_area = dem_select(A > 0.0, 1.0/dem_select(A > 0.0, A, 1.0), 0.0);
    const double inverse_section =
        dem_select(rb > 0.0, inverse_area/dem_select(rb > 0.0, rb, 1.0), 0.0);
    const double tension = bond->abs_normal ? fabs(force[0]) : -force[0];
    const double sigma = tension*inverse_area + 4.0*force[3]*inverse_section, 
        tau = force[1]*inverse_area + 2.0*force[2]*inverse_section;
    const double sigma_limit =
        dem_select(stretched > 0.0, bond->strength_ratio, 1.0)*bond->normal_strength;
    const double tau_raw = bond->shear_strength + force[0]*inverse_area*bond->friction;
    const double tau_limit = dem_select(tau_raw > 0.0, tau_raw, 0.0);

    const double sheared =
        dem_select((bond->shear_strength > 0.0) & (tau >= tau_limit), 2.0, 0.0);

    return dem_select((bond->normal_strength > 0.0) & (sigma >= sigma_limit), 1.0, sheared);
}

/* One bond: increments of the springs, relaxation, breaking criteria, forces. In rows without a
   bond all terms are zero. */
DEM_MATH void row(const struct bond *bond, struct dem_contact_row *r, double *values)
{
    const double decay = dem_exp(-bond->relaxation*r->dt);
    const double dt = r->dt, holds = dem_select(values[LENGTH] > 0.0, 1.0, 0.0);
    const double rb = holds*bond->radius*r->min_radius, A = 3.14159265358979324*rb*rb,
                   J = 0.5*A*rb*rb;
    const double kn = bond->normal_stiffness*A, kt = bond->shear_stiffness*A;
    const double kw = bond->shear_stiffness*J, kb = 0.5*bond->normal_stiffness*J;
    const struct dem_bond_springs l = dem_bond_springs(r, values);
    const struct dem_history_vector n = l.n, slip = l.slip, turn = l.turn, u = l.u, bend = l.bend;
    const double spin = l.spin, twist = l.twist, squeezed = l.squeezed, vn = r->distance_rate;
    const double energy = 0.5*(kn*squeezed*squeezed + kt*dem_rotate_dot(u, u) +
                                   kw*twist*twist + kb*dem_rotate_dot(bend, bend));

    /* forces after relaxation, and whether the bond breaks */
    const double size[4] = {decay*kn*squeezed, decay*kt*sqrt(dem_rotate_dot(u, u)),
                              decay*kw*fabs(twist),
                              decay*kb*sqrt(dem_rotate_dot(bend, bend))};
    const double width = r->distance - r->gap;
    const double stressed = breaks(bond, rb, size, -squeezed),
                   too_far = dem_select(r->distance >= bond->break_distance*width, 3.0, 0.0);
    const double cause = dem_select(stressed > 0.0, stressed, too_far);
    const double on = dem_select(cause > 0.0, 0.0, holds), left = on*decay;

    /* damping dissipates kinetic energy, relaxation and breaking elastic energy */
    const double m = r->reduced_mass,
                   I = bond->inertia*m*r->reduced_radius*r->reduced_radius;
    const double cn = on*damper(bond, 0, kn, fabs(size[0]), fabs(vn), m, dt);
    const double ct =
        on*damper(bond, 1, kt, size[1], sqrt(dem_rotate_dot(slip, slip)), m*(2.0/7.0), dt);
    const double cw = on*damper(bond, 2, kw, size[2], fabs(spin), I, dt);
    const double cb = on*damper(bond, 3, kb, size[3], sqrt(dem_rotate_dot(turn, turn)), I, dt);
    const double taken = dt*(cn*vn*vn + ct*dem_rotate_dot(slip, slip) + cw*spin*spin +
                                 cb*dem_rotate_dot(turn, turn));
    const double other = dem_select(holds > 0.0, bond->contact == REPLACED ? 0.0 : 1.0, 1.0);

    r->fn = other*r->fn + on*size[0] - cn*vn;
    r->fx = other*r->fx - left*kt*u.x - ct*slip.x;
    r->fy = other*r->fy - left*kt*u.y - ct*slip.y;
    r->fz = other*r->fz - left*kt*u.z - ct*slip.z;
    const double twist_moment = -left*kw*twist - cw*spin;

    r->mx = other*r->mx + twist_moment*n.x - left*kb*bend.x - cb*turn.x;
    r->my = other*r->my + twist_moment*n.y - left*kb*bend.y - cb*turn.y;
    r->mz = other*r->mz + twist_moment*n.z - left*kb*bend.z - cb*turn.z;
    r->stored += on*decay*decay*energy;
    r->lost += holds*energy - on*decay*decay*energy + taken;
    r->bonds += on;
    r->broke += holds - on;
    r->cause = cause;

    values[SHEAR] = left*u.x;
    values[SHEAR + 1] = left*u.y;
    values[SHEAR + 2] = left*u.z;
    values[TWIST] = left*twist;
    values[BEND] = left*bend.x;
    values[BEND + 1] = left*bend.y;
    values[BEND + 2] = left*bend.z;
    /* of a broken bond WORN is, until hand_over, its normal force */
    values[LENGTH] = dem_select(holds > on, BROKEN, values[LENGTH] + on*(decay - 1.0)*squeezed);
    values[WORN] = dem_select(holds > on, size[0], values[WORN]);
}

#define LOOP hold
#define LAW bond
#define ROW row
#define COLUMNS ASKED
#define SETS DEM_SETS_FN | DEM_SETS_FORCE | DEM_SETS_MOMENT | DEM_SETS_STORED | \
    DEM_SETS_LOST | DEM_SETS_BONDS
#include "laws/contact_loop.h"

/* ---- breaking ------------------------------------------------------------------------------------------------ */

/* The contact takes over the smaller of the compressive bond force (in WORN) and the force of
   its own overlap; WORN becomes the overlap without force. */
static void hand_over(const struct bond *bond, struct dem_contact_batch *b, double *worn)
{
    for (int c = 0; c < b->n; c++)
    {
        if (b->broke[c] == 0.0)
        {
            continue;
        }
        const double capacity = b->kn[c]*b->overlap[c],
                       compression = worn[c] > 0.0 ? worn[c] : 0.0;
        const double taken_over = compression < capacity ? compression : capacity;
        const double share =
            capacity > 0.0 ? dem_pow(taken_over/capacity, bond->inverse_exponent) : 0.0;

        const double taken = bond->contact == REPLACED ? taken_over : 0.0;

        worn[c] = bond->contact == REPLACED ? b->overlap[c]*(1.0 - share) : 0.0;
        b->fn[c] += taken;
        /* the elastic energy of the contact is not dissipated */
        b->lost[c] -= taken*b->overlap[c]*share/(1.0 + 1.0/bond->inverse_exponent);
    }
}

static int any_broke(const struct dem_contact_batch *b)
{
    double broken = 0.0;

    for (int c = 0; c < b->n; c++)
    {
        broken += b->broke[c];
    }
    return broken > 0.0;
}

static void apply(const void *of, struct dem_contact_batch *restrict b, double *const *history)
{
    const struct bond *bond = of;

    make(bond, b, history);
    hold(of, b, history);
    if (any_broke(b))
    {
        hand_over(bond, b, history[WORN]);
    }
}

/* ---- energy -------------------------------------------------------------------------------------------------- */

/* Correction for a bond that broke in this step [J]. `lost` contains k x'^2/2, but the last
   drift, from x to x', ended without force, or with F of the contact that takes over, so that the
   work done was (k x + F) (x' - x)/2 only. A bond made in this step has no length from the last
   step and no normal elongation. */
static double unspent(const struct bond *bond, const struct dem_contact_batch *b,
                        double *const *before, int c, double taken_over)
{
    const double rb = bond->radius*b->min_radius[c], A = 3.14159265358979324*rb*rb,
                   J = 0.5*A*rb*rb;
    const struct dem_contact_row r = dem_contact_row_load(b, c, dem_contact_batch_inverse_dt(b));
    double values[DEM_LAW_HISTORY];

    dem_history_load(before, BOND_HISTORY, c, values);
    const struct dem_bond_springs l = dem_bond_springs(&r, values);
    const double slid = dem_rotate_dot(l.u, dem_rotate_about_normal(l.slip, l.n, l.q)),
                   bent = dem_rotate_dot(l.bend, dem_rotate_about_normal(l.turn, l.n, l.q));

    return 0.5*b->dt*
           (bond->shear_stiffness*(A*slid + J*l.twist*l.spin) +
            0.5*bond->normal_stiffness*J*bent -
            (bond->normal_stiffness*A*(before[LENGTH][c] > 0.0 ? l.squeezed : 0.0) -
             taken_over)*
                b->distance_rate[c]);
}

/* Energy as set by act, corrected in two steps in which the normal law does not know of the bond
   yet: it still counts the energy that a bond just made has dissipated, and does not count the
   energy that it takes over from a bond just broken. */
static void energy(const void *of, const struct dem_contact_batch *restrict b,
                   double *const *before, double *const *history, struct dem_energy *restrict e)
{
    const struct bond *bond = of;
    const double exponent = 1.0/bond->inverse_exponent, more = 1.0 + exponent;

    for (int c = 0; c < b->n; c++)
    {
        const double from = before[LENGTH][c], to = history[LENGTH][c], d = b->overlap[c];
        const int replaced = bond->contact == REPLACED;
        const double share =
            replaced && b->broke[c] > 0.0 && d > 0.0 ? 1.0 - history[WORN][c]/d : 0.0;

        e->stored[c] += share > 0.0 ? b->kn[c]*d*d*dem_pow(share, more)/more : 0.0;
        e->stored[c] -= replaced && from <= 0.0 && to > 0.0 ? b->kn[c]*d*d/more : 0.0;
        e->lost[c] -= b->broke[c] > 0.0
                          ? unspent(bond, b, before, c,
                                    share > 0.0 ? b->kn[c]*d*dem_pow(share, exponent) : 0.0)
                          : 0.0;
    }
}

static int makes_listed(const void *of)
{
    return ((const struct bond *)of)->make == LISTED;
}

static int adhesive(const void *of)
{
    (void)of;
    return 1;
}

const struct dem_effect dem_bond_linear = {
    .name = "bondLinear",
    .summary =
        "elastic bond in tension, shear, twist and bending, with rules for making and breaking",
    .source = "Open DEM Japan 2025, corrected; Potyondy and Cundall 2004",
    .stage = DEM_STAGE_BOND,
    .needs = DEM_NEEDS_SPIN | DEM_NEEDS_NORMAL_SPIN | DEM_NEEDS_RANDOM,
    .example = "normalStiffness 1e9; shearStiffness 1e9;",
    .size = sizeof(struct bond),
    .settings = settings,
    .history = history_names,
    .listed_column = "bond_asked",
    .makes_listed = makes_listed,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .replace_contact = shield,
    .apply = apply,
    .energy = energy,
    .adhesive = adhesive,
};
