/*
 * bond_linear.h -- row function of bond_linear.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/random.h"
#include "laws/bond/bond_springs.h"
#include "laws/energy_row.h"

enum    /* `make` */
{
    DEM_BOND_MAKE_ONCE,
    DEM_BOND_MAKE_ALWAYS,
    DEM_BOND_MAKE_LISTED
};

enum    /* `contact` */
{
    DEM_BOND_CONTACT_REPLACED,
    DEM_BOND_CONTACT_PARALLEL
};

struct dem_bond_linear
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

enum
{
    dem_bond_linear_columns = DEM_BOND_HISTORY
};

/* values of DEM_BOND_LENGTH of a broken bond: the pair has not yet been farther apart than
   makeDistance; and the surfaces have not separated yet. DEM_BOND_REFUSED: with redraw, the pair was
   drawn and not bonded, and has not been farther apart since */
#define DEM_BOND_PARTED (-1.0)
#define DEM_BOND_BROKEN (-2.0)
#define DEM_BOND_REFUSED (-3.0)

/* ---- before the contact laws ----------------------------------------------------------------- */

DEM_MATH void dem_bond_linear_replace_row(const struct dem_bond_linear *bond,
                                          struct dem_contact_row *r, double *values)
{
    const double replaces = dem_select(bond->contact == DEM_BOND_CONTACT_REPLACED, 1.0, 0.0);
    /* a pair that never bonds again must not keep a history: it would depend on how long the
       pair has been in the list */
    const double parted = dem_select(bond->make == DEM_BOND_MAKE_ALWAYS, DEM_BOND_PARTED, 0.0);
    const double length = values[DEM_BOND_LENGTH], worn = values[DEM_BOND_WORN];

    /* a bonded pair keeps its overlap (needed by hand_over), but not the history of its contact */
    const double replaced = dem_select(length > 0.0, replaces, 0.0);
    const double less = dem_select(worn < r->overlap, worn, r->overlap), left = r->overlap - less;

    /* after a bond has broken, surfaces do not adhere before they have separated */
    const double now =
        dem_select((length == DEM_BOND_BROKEN) & (r->overlap == 0.0), parted, length);

    r->bond_replaces = dem_select(now == DEM_BOND_BROKEN, replaces, replaced);
    r->overlap = left;
    r->touching = (1.0 - replaced)*dem_select(left > 0.0, r->touching, 0.0);
    values[DEM_BOND_LENGTH] = now;
    values[DEM_BOND_WORN] = less;
}

/* ---- making --------------------------------------------------------------------------------- */

/* Whether bonds are made now. In the first evaluation of a run, previous_time is -infinity: `once`,
   they are made if `time` has been reached; afterwards in the step that passes it. */
DEM_MATH int dem_bond_linear_makes(const struct dem_bond_linear *bond, double time,
                                   double previous_time)
{
    const int new_now = bond->make == DEM_BOND_MAKE_ALWAYS || previous_time < bond->time;

    return new_now && time >= bond->time && !bond->idle;
}

/* random number in 0 .. 1 of a pair; with redraw of the time, too, at which it meets */
DEM_MATH double dem_bond_drawn(const struct dem_bond_linear *bond, double chance, double time)
{
    return dem_random_unit((uint64_t)bond->seed, dem_math_bits(chance),
                           bond->redraw ? dem_math_bits(time) : 0, 0);
}

/* Makes the bond of a row, if there is to be one. */
DEM_MATH void dem_bond_linear_make_row(const struct dem_bond_linear *bond,
                                       struct dem_contact_row *r, double *values)
{
    const int replaces = bond->contact == DEM_BOND_CONTACT_REPLACED;
    const int meets = r->is_primary > 0.0 && r->distance > 0.0 &&
                      r->distance <= bond->make_distance*(r->distance - r->gap);

    values[DEM_BOND_LENGTH] =
        values[DEM_BOND_LENGTH] < 0.0 && !meets ? 0.0 : values[DEM_BOND_LENGTH];
    if (!meets || values[DEM_BOND_LENGTH] != 0.0 ||
        (bond->make == DEM_BOND_MAKE_LISTED && !(values[DEM_BOND_ASKED] > 0.0)))
    {
        return;
    }
    if (dem_bond_drawn(bond, r->pair_random, r->time) >= bond->probability)
    {
        values[DEM_BOND_LENGTH] = bond->redraw ? DEM_BOND_REFUSED : 0.0;
        return;
    }
    values[DEM_BOND_LENGTH] = r->distance;
    values[DEM_BOND_WORN] = 0.0;
    r->bond_replaces = replaces ? 2.0 : 0.0;
    /* energy of the replaced contact is dissipated; F = k d ~ d^p stores F d/(p + 1) */
    r->lost += replaces ? r->kn*r->overlap*r->overlap/(1.0 + 1.0/bond->inverse_exponent) : 0.0;
}

/* ---- forces --------------------------------------------------------------------------------- */

/* Damping coefficient of a spring with |F| = force and |v| = rate: viscous, and the fraction of
   the force. mass: effective mass or inertia. */
DEM_MATH double dem_bond_damper(const struct dem_bond_linear *bond, int motion, double stiffness,
                                double force, double rate, double mass, double dt)
{
    const double min_rate =
        dem_select(mass > 0.0, force*dt/dem_select(mass > 0.0, mass, 1.0), 0.0);
    const double speed = dem_select(rate > min_rate, rate, min_rate);

    return 2.0*bond->damping_ratio*sqrt(stiffness*mass) +
           bond->share[motion]*force/dem_select(speed > 0.0, speed, 1.0);
}

/* 0: the bond holds, 1: sigma breaks it, 2: tau breaks it. force: F_n, positive in compression,
   |F_t|, |T_n|, |T_t|. */
DEM_MATH double dem_bond_breaks(const struct dem_bond_linear *bond, double rb,
                                const double force[4], double stretched)
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
DEM_MATH void dem_bond_linear_hold_row(const struct dem_bond_linear *bond,
                                       struct dem_contact_row *r, double *values)
{
    const double decay = dem_exp(-bond->relaxation*r->dt);
    const double dt = r->dt, holds = dem_select(values[DEM_BOND_LENGTH] > 0.0, 1.0, 0.0);
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
    const double stressed = dem_bond_breaks(bond, rb, size, -squeezed),
                   too_far = dem_select(r->distance >= bond->break_distance*width, 3.0, 0.0);
    const double cause = dem_select(stressed > 0.0, stressed, too_far);
    const double on = dem_select(cause > 0.0, 0.0, holds), left = on*decay;

    /* damping dissipates kinetic energy, relaxation and breaking elastic energy */
    const double m = r->reduced_mass,
                   I = bond->inertia*m*r->reduced_radius*r->reduced_radius;
    const double cn = on*dem_bond_damper(bond, 0, kn, fabs(size[0]), fabs(vn), m, dt);
    const double ct =
        on*dem_bond_damper(bond, 1, kt, size[1], sqrt(dem_rotate_dot(slip, slip)), m*(2.0/7.0), dt);
    const double cw = on*dem_bond_damper(bond, 2, kw, size[2], fabs(spin), I, dt);
    const double cb =
        on*dem_bond_damper(bond, 3, kb, size[3], sqrt(dem_rotate_dot(turn, turn)), I, dt);
    const double taken = dt*(cn*vn*vn + ct*dem_rotate_dot(slip, slip) + cw*spin*spin +
                                 cb*dem_rotate_dot(turn, turn));
    const double other =
        dem_select(holds > 0.0, bond->contact == DEM_BOND_CONTACT_REPLACED ? 0.0 : 1.0, 1.0);

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

    values[DEM_BOND_SHEAR] = left*u.x;
    values[DEM_BOND_SHEAR + 1] = left*u.y;
    values[DEM_BOND_SHEAR + 2] = left*u.z;
    values[DEM_BOND_TWIST] = left*twist;
    values[DEM_BOND_BEND] = left*bend.x;
    values[DEM_BOND_BEND + 1] = left*bend.y;
    values[DEM_BOND_BEND + 2] = left*bend.z;
    /* of a broken bond DEM_BOND_WORN is, until hand_over, its normal force */
    values[DEM_BOND_LENGTH] = dem_select(holds > on, DEM_BOND_BROKEN,
                                         values[DEM_BOND_LENGTH] + on*(decay - 1.0)*squeezed);
    values[DEM_BOND_WORN] = dem_select(holds > on, size[0], values[DEM_BOND_WORN]);
}

/* ---- breaking ------------------------------------------------------------------------------- */

/* Where a bond broke, the contact takes over the smaller of the compressive bond force (in
   DEM_BOND_WORN) and the force of its own overlap; DEM_BOND_WORN becomes the overlap without force. */
DEM_MATH void dem_bond_linear_hand_over_row(const struct dem_bond_linear *bond,
                                            struct dem_contact_row *r, double *values)
{
    if (r->broke == 0.0)
    {
        return;
    }
    const int replaces = bond->contact == DEM_BOND_CONTACT_REPLACED;
    const double worn = values[DEM_BOND_WORN], capacity = r->kn*r->overlap,
                 compression = worn > 0.0 ? worn : 0.0;
    const double taken_over = compression < capacity ? compression : capacity;
    const double share =
        capacity > 0.0 ? dem_pow(taken_over/capacity, bond->inverse_exponent) : 0.0;
    const double taken = replaces ? taken_over : 0.0;

    values[DEM_BOND_WORN] = replaces ? r->overlap*(1.0 - share) : 0.0;
    r->fn += taken;
    /* the elastic energy of the contact is not dissipated */
    r->lost -= taken*r->overlap*share/(1.0 + 1.0/bond->inverse_exponent);
}

/* The whole law, after the contact laws. */
DEM_MATH void dem_bond_linear_row(const struct dem_bond_linear *bond, struct dem_contact_row *r,
                                  double *values)
{
    if (dem_bond_linear_makes(bond, r->time, r->previous_time))
    {
        dem_bond_linear_make_row(bond, r, values);
    }
    dem_bond_linear_hold_row(bond, r, values);
    dem_bond_linear_hand_over_row(bond, r, values);
}

/* ---- energy ---------------------------------------------------------------------------------- */

/* Correction for a bond that broke in this step [J]. `lost` contains k x'^2/2, but the last
   drift, from x to x', ended without force, or with F of the contact that takes over, so that the
   work done was (k x + F) (x' - x)/2 only. A bond made in this step has no length from the last
   step and no normal elongation. */
DEM_MATH double dem_bond_linear_unspent(const struct dem_bond_linear *bond,
                                        const struct dem_contact_row *r, const double *before,
                                        double taken_over)
{
    const double rb = bond->radius*r->min_radius, A = 3.14159265358979324*rb*rb, J = 0.5*A*rb*rb;
    const struct dem_bond_springs l = dem_bond_springs(r, before);
    const double slid = dem_rotate_dot(l.u, dem_rotate_about_normal(l.slip, l.n, l.q)),
                 bent = dem_rotate_dot(l.bend, dem_rotate_about_normal(l.turn, l.n, l.q));

    return 0.5*r->dt*
           (bond->shear_stiffness*(A*slid + J*l.twist*l.spin) +
            0.5*bond->normal_stiffness*J*bent -
            (bond->normal_stiffness*A*(before[DEM_BOND_LENGTH] > 0.0 ? l.squeezed : 0.0) -
             taken_over)*
                r->distance_rate);
}

/* Energy as set by the row, corrected in two steps in which the normal law does not know of the bond
   yet: it still counts the energy that a bond just made has dissipated, and does not count the
   energy that it takes over from a bond just broken. */
DEM_MATH void dem_bond_linear_energy_row(const struct dem_bond_linear *bond, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    const double exponent = 1.0/bond->inverse_exponent, more = 1.0 + exponent;
    const double from = before[DEM_BOND_LENGTH], to = after[DEM_BOND_LENGTH], d = r->overlap;
    const int replaced = bond->contact == DEM_BOND_CONTACT_REPLACED;
    const double share =
        replaced && r->broke > 0.0 && d > 0.0 ? 1.0 - after[DEM_BOND_WORN]/d : 0.0;

    e->stored += share > 0.0 ? r->kn*d*d*dem_pow(share, more)/more : 0.0;
    e->stored -= replaced && from <= 0.0 && to > 0.0 ? r->kn*d*d/more : 0.0;
    e->lost -= r->broke > 0.0
                   ? dem_bond_linear_unspent(bond, r, before,
                                             share > 0.0 ? r->kn*d*dem_pow(share, exponent) : 0.0)
                   : 0.0;
}
