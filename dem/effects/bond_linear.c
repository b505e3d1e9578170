/*
 * bond_linear.c -- two bodies hold together by a short elastic beam that can break.
 *
 *   F_n = k_n A (l - r) n        F_t = -k_t A u        T_n = -k_t J theta_n n        T_t = -k_n I theta_t        on i
 *
 *   r, l     distance of the centres (height over a wall), and the one without force    [m]
 *   n        unit vector from j to i                                                     [1]
 *   u        slip of i's end of the beam over j's since the making, normal to n          [m]      remembered
 *   theta    turn of i against j since then: twist about n, bend normal to it            [rad]    remembered
 *   k_n, k_t stiffness per area (E/L and G/L of a beam of length L)                      [Pa/m]
 *   r_b      radius of the bond, lambda min(R_i, R_j); lambda R_i at a wall              [m]
 *   A, J, I  pi r_b^2, A r_b^2/2, J/2                                                    [m2], [m4]
 *
 * Carrying u and theta_t along: by the mirror of mindlin.c into today's plane (the smallest rotation from the old normal
 * to the new one), then by the mean spin of both about n; both keep the length. Nothing is ever projected on a spin.
 *
 * Making: `make` once at `time`, always from then on, or once for the pairs that the scene lists; where r is at most
 * makeDistance (R_i + R_j), with a probability that depends on the seed and the two ids only. New bonds are at rest: the
 * pair's load is whatever acts later. Damping (forces only, never the criteria): viscous, c = 2 zeta sqrt(k m), m = m*,
 * 2/7 m* for slip, I* for turns; or a share of each spring's force against its rate v, F - eta |F| v/max(|v|, v_s), v_s
 * = |F| dt/m: what the force changes in a step, so that the share never reverses a motion.
 * Relaxation: every spring forgets by exp(-eta dt) a step, the normal one by moving l.
 *
 * Breaking, when any of these is reached (0: is not asked):
 *
 *   sigma = -F_n/A + |T_t| r_b/I >= normalStrength    (times strengthRatio while r > l)    F_n > 0 compression
 *   tau   =  |F_t|/A + |T_n| r_b/J >= max(0, shearStrength + internalFriction F_n/A)
 *   r >= breakDistance (R_i + R_j)
 *
 * What was stored is lost then, and nothing of the bond acts any more. A broken pair bonds anew only after it was out of
 * makeDistance.
 *
 * The contact of a bonded pair: `replaced`, the default, does without all laws of contact while the bond holds (its k_n
 * is the stiffness of what lies between the centres; both would count that twice). What contact was there when the bond
 * was made is lost. When it breaks, the contact takes over as much of the push as its overlap can carry, and none in
 * tension: the surfaces count as worn, so that no force jumps up, and they wear in as they part. Adhesion (jkr, sjkr) is a matter
 * of the surfaces: it ends where a bond is made and comes back after they have parted. `parallel`, as in
 * Potyondy and Cundall, adds the bond to the contact.
 *
 * Longest step: 0.2 of 2/w, w = the largest of 2 sqrt(k_n A/m), sqrt(k_t A L^2/I_p), 2 sqrt(k_t J/I_p), 2 sqrt(k_n I/I_p)
 * of a chain of the smallest particles, L = 2 R.
 *
 * Source: the note "linear bond model" of Open DEM Japan (2025), after Potyondy and Cundall, Int. J. Rock Mech. Min.
 * Sci. 41 (2004) 1329. Changed from the note:
 *   (5)        slip is v_t - (a_i w_i + a_j w_j) x n with n from j to i (two signs; as printed, a pair that turns as a
 *              whole is sheared); the arms a meet in the middle of the gap and sum to r, instead of R_i, R_j.
 *   (6)        the old force is rotated, instead of losing what points along the new n.
 *   (7), (8)   turns are of the relative spin w_i - w_j.
 *   (9), (10)  sgn of a vector depends on the axes: its direction is taken, smoothed; viscous is the default.
 *   (11)       exp(-eta dt), not 1 - eta dt; the loss is E (1 - exp(-2 eta dt)), the note's integrals are powers.
 *   (12)       T_i = -a_i n x F_t + T_n + T_t and T_j = -a_j n x F_t - T_n - T_t: with T_j = -T_i a sheared pair spins up.
 *   (13)       tension has a sign; absNormal counts both as the note does.
 *   (14) (ii)  sigma is a stress already, not to be divided by A; of it only F_n/A counts, and the limit ends at 0.
 * Not here: strain-dependent stiffness, bonds of three bodies, the heat of what is lost.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "base/math.h"
#include "base/random.h"
#include "effects/bond_springs.h"

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
    int make, walls, contact, abs_normal;
    double time, make_distance, break_distance, probability, seed;
    double damping_ratio, damping_share, relaxation;
    double normal_strength, strength_ratio, shear_strength, friction;
    double inverse_exponent, inertia;                     /* 1, 1: derived; I* = inertia m* R*^2 */
    int idle;                                             /* 1: makes no bonds in this class */
};

static const struct dem_field settings[] = {
    DEM_FIELD_AS(bond, normal_stiffness, "normalStiffness", "Pa/m", DEM_FIELD_REQUIRED, DEM_ABOVE_ZERO, INFINITY,
                 "force per area and elongation: Young's modulus over length of a beam"),
    DEM_FIELD_AS(bond, shear_stiffness, "shearStiffness", "Pa/m", DEM_FIELD_REQUIRED, 0.0, INFINITY,
                 "force per area and slip: shear modulus over length"),
    DEM_FIELD(bond, radius, "1", 1.0, DEM_ABOVE_ZERO, 10.0, "lambda, radius of the bond over that of the smaller partner"),
    DEM_FIELD_CHOICE(bond, make, "make", ONCE, makings,
                     "when bonds are made: once at time, always from time on, or once at time for the pairs of the scene's entry bonds"),
    DEM_FIELD(bond, time, "s", 0.0, 0.0, INFINITY, "of making"),
    DEM_FIELD_AS(bond, make_distance, "makeDistance", "1", 1.001, DEM_ABOVE_ZERO, 10.0,
                 "bonds are made up to this distance of the centres over R_i + R_j"),
    DEM_FIELD(bond, probability, "1", 1.0, 0.0, 1.0, "that a pair near enough bonds"),
    DEM_FIELD_COUNT(bond, seed, "seed", 1.0, 0.0, 1e15, "of that probability"),
    DEM_FIELD_SWITCH(bond, walls, "walls", 0, "bonds to walls, too"),
    DEM_FIELD_CHOICE(bond, contact, "contact", REPLACED, contacts,
                     "of a bonded pair: replaced by the bond until it breaks, or parallel to it"),
    DEM_FIELD_AS(bond, damping_ratio, "dampingRatio", "1", 0.0, 0.0, 1.0, "viscous damping, 1 is critical for a pair alone"),
    DEM_FIELD_AS(bond, damping_share, "dampingShare", "1", 0.0, 0.0, 1.0, "share of each spring's force against its rate"),
    DEM_FIELD(bond, relaxation, "1/s", 0.0, 0.0, INFINITY, "eta: forces fade as exp(-eta t)"),
    DEM_FIELD_AS(bond, normal_strength, "normalStrength", "Pa", 0.0, 0.0, INFINITY, "largest stress of tension and bending; 0: any"),
    DEM_FIELD_AS(bond, strength_ratio, "strengthRatio", "1", 1.0, DEM_ABOVE_ZERO, 1e3, "on normalStrength while the bond is stretched"),
    DEM_FIELD_SWITCH(bond, abs_normal, "absNormal", 0, "compression counts as tension in normalStrength"),
    DEM_FIELD_AS(bond, shear_strength, "shearStrength", "Pa", 0.0, 0.0, INFINITY, "largest stress of shear and twist; 0: any"),
    DEM_FIELD_AS(bond, friction, "internalFriction", "1", 0.0, 0.0, 100.0, "tan(phi), by which pressure adds to shearStrength (Drucker-Prager)"),
    DEM_FIELD_AS(bond, break_distance, "breakDistance", "1", 1.1, DEM_ABOVE_ZERO, 100.0,
                 "bonds break at this distance of the centres over R_i + R_j; costs a wider search"),
    {0},
};

static const char *const memory[] = {"bond_length", "bond_worn", "bond_shear_x", "bond_shear_y", "bond_shear_z", "bond_twist",
                                     "bond_bend_x", "bond_bend_y", "bond_bend_z", "bond_asked", NULL};

/* lengths of one that broke: it has not yet been out of makeDistance; and the surfaces have not even parted */
#define PARTED (-1.0)
#define BROKEN (-2.0)

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct bond *bond = of;

    DEM_REQUIRE(bond->break_distance > bond->make_distance, DEM_ERROR_INPUT,
                "bondLinear between %s and %s: breakDistance %g is not above makeDistance %g, so bonds would break when made; raise "
                "breakDistance", pair->a->name, pair->b->name, bond->break_distance, bond->make_distance);
    DEM_REQUIRE(bond->friction == 0.0 || bond->shear_strength > 0.0, DEM_ERROR_INPUT,
                "bondLinear between %s and %s: internalFriction %g adds to shearStrength, which is not given; give it, or internalFriction 0",
                pair->a->name, pair->b->name, bond->friction);
    bond->inverse_exponent = pair->exponent > 0.0 ? 1.0/pair->exponent : 1.0;
    bond->inertia = pair->with_wall ? 0.4 : 1.6;          /* 2/5 m R^2; of two equal spheres R = 2 R* */
    bond->idle = pair->with_wall && !bond->walls;
    return DEM_OK;
}

static double reach(const void *of, const struct dem_pair_class *pair)
{
    const struct bond *bond = of;

    return bond->idle || bond->break_distance < 1.0 ? 0.0 : (bond->break_distance - 1.0)*pair->widest;
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const struct bond *bond = of;
    const double equal = pair->with_wall ? 1.0 : 2.0, R = equal*pair->least_radius, m = equal*pair->least_mass, I_p = 0.4*m*R*R;
    const double rb = bond->radius*R, A = 3.14159265358979324*rb*rb, J = 0.5*A*rb*rb;
    const double axial = 4.0*bond->normal_stiffness*A/m, rocking = bond->shear_stiffness*A*4.0*R*R/I_p;
    const double twist = 4.0*bond->shear_stiffness*J/I_p, bend = 2.0*bond->normal_stiffness*J/I_p;

    *why = "0.2 of the stability limit of a chain of linear bonds";
    return bond->idle ? DBL_MAX : 0.4/sqrt(fmax(fmax(axial, rocking), fmax(twist, bend)));
}

/* ---- before the laws of contact ------------------------------------------------------------------------------ */

DEM_KERNEL
static void shield(const void *of, struct dem_block *restrict b, dem_real *const *remembered)
{
    const struct bond *bond = of;
    const dem_real hides = bond->contact == REPLACED ? 1.0 : 0.0;
    /* a pair that never bonds again has nothing to remember, or its memory would tell how long it stayed in the list */
    const dem_real parted = bond->make == ALWAYS ? PARTED : 0.0;
    dem_real *restrict length = remembered[LENGTH], *restrict worn = remembered[WORN];

    for (int c = 0; c < b->n; c++)
    {
        /* a bonded pair keeps its overlap, for the hand-over, but nothing is remembered of its contact */
        const dem_real hidden = dem_pick(length[c] > 0.0, hides, 0.0);
        const dem_real less = dem_pick(worn[c] < b->overlap[c], worn[c], b->overlap[c]), left = b->overlap[c] - less;

        /* and surfaces that a bond left behind don't stick before they have parted */
        length[c] = dem_pick((length[c] == BROKEN) & (b->overlap[c] == 0.0), parted, length[c]);
        b->sealed[c] = dem_pick(length[c] == BROKEN, hides, hidden);
        worn[c] = less;
        b->overlap[c] = left;
        b->touching[c] = (1.0 - hidden)*dem_pick(left > 0.0, b->touching[c], 0.0);
    }
}

/* ---- making -------------------------------------------------------------------------------------------------- */

static double lucky(double seed, double chance)
{
    return dem_random_unit((uint64_t)seed, dem_math_bits(chance), 0, 0);
}

/* In the first sweep of a run the time of making has come when it is not later; afterwards when a step passes it. */
static void make(const struct bond *bond, struct dem_block *b, dem_real *const *remembered)
{
    const int now = b->since < bond->time && b->time >= bond->time, later = b->time >= bond->time;
    dem_real *const length = remembered[LENGTH];

    for (int c = 0; (bond->make == ALWAYS ? later : now) && !bond->idle && c < b->n; c++)
    {
        const dem_real width = b->distance[c] - b->gap[c];
        const int near = b->counts[c] > 0.0 && b->distance[c] > 0.0 && b->distance[c] <= bond->make_distance*width;

        length[c] = length[c] < 0.0 && !near ? 0.0 : length[c];
        if (near && length[c] == 0.0 && (bond->make != LISTED || remembered[ASKED][c] > 0.0)
            && lucky(bond->seed, b->chance[c]) < bond->probability)
        {
            length[c] = b->distance[c];
            remembered[WORN][c] = 0.0;
            b->sealed[c] = bond->contact == REPLACED ? 2.0 : 0.0;
            /* the contact that the bond replaces keeps its energy for itself; F = k d ~ d^p holds F d/(p + 1) */
            b->lost[c] += bond->contact == REPLACED ? b->kn[c]*b->overlap[c]*b->overlap[c]/(1.0 + 1.0/bond->inverse_exponent) : 0.0;
        }
    }
}

/* ---- holding ------------------------------------------------------------------------------------------------- */

/* What a spring of force size F takes per rate v: viscous, and its share. `mass` is what it moves. */
DEM_MATH dem_real damper(const struct bond *bond, dem_real stiffness, dem_real force, dem_real rate, dem_real mass, dem_real dt)
{
    const dem_real least = dem_pick(mass > 0.0, force*dt/dem_pick(mass > 0.0, mass, 1.0), 0.0);
    const dem_real speed = dem_pick(rate > least, rate, least);

    return 2.0*bond->damping_ratio*sqrt(stiffness*mass) + bond->damping_share*force/dem_pick(speed > 0.0, speed, 1.0);
}

/* 0 when the bond holds, 1 when sigma breaks it, 2 when tau does. Fn is positive in compression; the others are sizes. */
DEM_MATH dem_real breaks(const struct bond *bond, dem_real rb, const dem_real force[4], dem_real stretched)
{
    const dem_real A = 3.14159265358979324*rb*rb, over = dem_pick(A > 0.0, 1.0/dem_pick(A > 0.0, A, 1.0), 0.0);
    const dem_real per = dem_pick(rb > 0.0, over/dem_pick(rb > 0.0, rb, 1.0), 0.0);
    const dem_real pull = bond->abs_normal ? fabs(force[0]) : -force[0];
    const dem_real sigma = pull*over + 4.0*force[3]*per, tau = force[1]*over + 2.0*force[2]*per;
    const dem_real most_sigma = dem_pick(stretched > 0.0, bond->strength_ratio, 1.0)*bond->normal_strength;
    const dem_real most_tau = bond->shear_strength + force[0]*over*bond->friction;
    const dem_real limit = dem_pick(most_tau > 0.0, most_tau, 0.0);

    const dem_real sheared = dem_pick((bond->shear_strength > 0.0) & (tau >= limit), 2.0, 0.0);

    return dem_pick((bond->normal_strength > 0.0) & (sigma >= most_sigma), 1.0, sheared);
}

/* One bond: load, relax, judge, push. Rows without one come through with zeros. */
DEM_MATH void hold(const struct bond *bond, struct dem_block *b, dem_real *const *r, int c, dem_real kept)
{
    const dem_real dt = b->dt, holds = dem_pick(r[LENGTH][c] > 0.0, 1.0, 0.0);
    const dem_real rb = holds*bond->radius*b->least_radius[c], A = 3.14159265358979324*rb*rb, J = 0.5*A*rb*rb;
    const dem_real kn = bond->normal_stiffness*A, kt = bond->shear_stiffness*A;
    const dem_real kw = bond->shear_stiffness*J, kb = 0.5*bond->normal_stiffness*J;
    const struct dem_bond_springs l = dem_bond_springs(b, r, c);
    const struct dem_carried n = l.n, slip = l.slip, turn = l.turn, u = l.u, bend = l.bend;
    const dem_real spin = l.spin, twist = l.twist, squeezed = l.squeezed, vn = b->rate[c];
    const dem_real energy = 0.5*(kn*squeezed*squeezed + kt*dem_carry_inner(u, u) + kw*twist*twist + kb*dem_carry_inner(bend, bend));

    /* what is left of the springs, and whether they still hold */
    const dem_real size[4] = {kept*kn*squeezed, kept*kt*sqrt(dem_carry_inner(u, u)), kept*kw*fabs(twist), kept*kb*sqrt(dem_carry_inner(bend, bend))};
    const dem_real width = b->distance[c] - b->gap[c];
    const dem_real stressed = breaks(bond, rb, size, -squeezed), far = dem_pick(b->distance[c] >= bond->break_distance*width, 3.0, 0.0);
    const dem_real gone = dem_pick(stressed > 0.0, stressed, far);
    const dem_real on = dem_pick(gone > 0.0, 0.0, holds), stays = on*kept;

    /* damping takes from the motion, relaxation and breaking from the springs */
    const dem_real m = b->reduced_mass[c], I = bond->inertia*m*b->reduced_radius[c]*b->reduced_radius[c];
    const dem_real cn = on*damper(bond, kn, fabs(size[0]), fabs(vn), m, dt);
    const dem_real ct = on*damper(bond, kt, size[1], sqrt(dem_carry_inner(slip, slip)), m*(2.0/7.0), dt);
    const dem_real cw = on*damper(bond, kw, size[2], fabs(spin), I, dt);
    const dem_real cb = on*damper(bond, kb, size[3], sqrt(dem_carry_inner(turn, turn)), I, dt);
    const dem_real taken = dt*(cn*vn*vn + ct*dem_carry_inner(slip, slip) + cw*spin*spin + cb*dem_carry_inner(turn, turn));
    const dem_real other = dem_pick(holds > 0.0, bond->contact == REPLACED ? 0.0 : 1.0, 1.0);

    b->fn[c] = other*b->fn[c] + on*size[0] - cn*vn;
    b->fx[c] = other*b->fx[c] - stays*kt*u.x - ct*slip.x;
    b->fy[c] = other*b->fy[c] - stays*kt*u.y - ct*slip.y;
    b->fz[c] = other*b->fz[c] - stays*kt*u.z - ct*slip.z;
    const dem_real about = -stays*kw*twist - cw*spin;

    b->mx[c] = other*b->mx[c] + about*n.x - stays*kb*bend.x - cb*turn.x;
    b->my[c] = other*b->my[c] + about*n.y - stays*kb*bend.y - cb*turn.y;
    b->mz[c] = other*b->mz[c] + about*n.z - stays*kb*bend.z - cb*turn.z;
    b->stored[c] += on*kept*kept*energy;
    b->lost[c] += holds*energy - on*kept*kept*energy + taken;
    b->bonds[c] += on;
    b->broke[c] += holds - on;
    b->cause[c] = gone;

    r[SHEAR][c] = stays*u.x;
    r[SHEAR + 1][c] = stays*u.y;
    r[SHEAR + 2][c] = stays*u.z;
    r[TWIST][c] = stays*twist;
    r[BEND][c] = stays*bend.x;
    r[BEND + 1][c] = stays*bend.y;
    r[BEND + 2][c] = stays*bend.z;
    /* a broken one lends the hand-over its push, which is below any length by then: see there */
    r[LENGTH][c] = dem_pick(holds > on, BROKEN, r[LENGTH][c] + on*(kept - 1.0)*squeezed);
    r[WORN][c] = dem_pick(holds > on, size[0], r[WORN][c]);
}

/* ---- breaking ------------------------------------------------------------------------------------------------ */

/* The contact that takes over carries the least of the bond's push and what its own overlap can; WORN comes with the push. */
static void hand_over(const struct bond *bond, struct dem_block *b, dem_real *worn)
{
    for (int c = 0; c < b->n; c++)
    {
        if (b->broke[c] == 0.0)
        {
            continue;
        }
        const dem_real able = b->kn[c]*b->overlap[c], asked = worn[c] > 0.0 ? worn[c] : 0.0, carried_on = asked < able ? asked : able;
        const dem_real share = able > 0.0 ? dem_pow(carried_on/able, bond->inverse_exponent) : 0.0;

        const dem_real taken = bond->contact == REPLACED ? carried_on : 0.0;

        worn[c] = bond->contact == REPLACED ? b->overlap[c]*(1.0 - share) : 0.0;
        b->fn[c] += taken;
        /* what the contact holds from now on is not lost */
        b->lost[c] -= taken*b->overlap[c]*share/(1.0 + 1.0/bond->inverse_exponent);
    }
}

DEM_KERNEL
static dem_real hold_all(const struct bond *bond, struct dem_block *b, dem_real *const *remembered, dem_real kept)
{
    dem_real broken = 0.0;

    for (int c = 0; c < b->n; c++)
    {
        hold(bond, b, remembered, c, kept);
    }
    for (int c = 0; c < b->n; c++)
    {
        broken += b->broke[c];
    }
    return broken;
}

static void act(const void *of, struct dem_block *restrict b, dem_real *const *remembered)
{
    const struct bond *bond = of;

    make(bond, b, remembered);
    if (hold_all(bond, b, remembered, dem_exp(-bond->relaxation*b->dt)) > 0.0)
    {
        hand_over(bond, b, remembered[WORN]);
    }
}

/* ---- the ledger ---------------------------------------------------------------------------------------------- */

/* What the books have of a bond that broke in this step and its springs never got: k x'^2/2 is lost, though the last drift, x to x',
   ended with no force or with F of the contact that takes over, so what was put in is (k x + F) (x' - x)/2. One made in this very step
   had no length a step ago, and is neither squeezed nor drawn. */
static dem_real spared(const struct bond *bond, const struct dem_block *b, dem_real *const *before, int c, dem_real carried_on)
{
    const dem_real rb = bond->radius*b->least_radius[c], A = 3.14159265358979324*rb*rb, J = 0.5*A*rb*rb;
    const struct dem_bond_springs l = dem_bond_springs(b, before, c);
    const dem_real slid = dem_carry_inner(l.u, dem_carry_turned(l.slip, l.n, l.q)), bent = dem_carry_inner(l.bend, dem_carry_turned(l.turn, l.n, l.q));

    return 0.5*b->dt*(bond->shear_stiffness*(A*slid + J*l.twist*l.spin) + 0.5*bond->normal_stiffness*J*bent
                      - (bond->normal_stiffness*A*(before[LENGTH][c] > 0.0 ? l.squeezed : 0.0) - carried_on)*b->rate[c]);
}

/* What act has booked, but for two steps in which the contact's own law knows nothing of the bond yet: it still tells what a
   bond just made has declared lost, and tells nothing of what it takes over from one that has just broken. */
static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    const struct bond *bond = of;
    const dem_real exponent = 1.0/bond->inverse_exponent, more = 1.0 + exponent;

    for (int c = 0; c < b->n; c++)
    {
        const dem_real from = before[LENGTH][c], to = memory[LENGTH][c], d = b->overlap[c];
        const int replaced = bond->contact == REPLACED;
        const dem_real share = replaced && b->broke[c] > 0.0 && d > 0.0 ? 1.0 - memory[WORN][c]/d : 0.0;

        e->stored[c] += share > 0.0 ? b->kn[c]*d*d*dem_pow(share, more)/more : 0.0;
        e->stored[c] -= replaced && from <= 0.0 && to > 0.0 ? b->kn[c]*d*d/more : 0.0;
        e->lost[c] -= b->broke[c] > 0.0 ? spared(bond, b, before, c, share > 0.0 ? b->kn[c]*d*dem_pow(share, exponent) : 0.0) : 0.0;
    }
}

const struct dem_effect dem_bond_linear = {
    .name = "bondLinear",
    .says = "an elastic bond in tension, shear, twist and bending, made and broken as asked",
    .source = "Open DEM Japan 2025, corrected; Potyondy and Cundall 2004",
    .stage = DEM_STAGE_BOND,
    .needs = DEM_NEEDS_SPIN | DEM_NEEDS_SWING | DEM_NEEDS_CHANCE,
    .size = sizeof(struct bond),
    .settings = settings,
    .memory = memory,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .shield = shield,
    .act = act,
    .energy = energy,
};
