/*
 * balance.cl -- energy balance of a contact row, law by law, and of a particle: the arithmetic of
 * records/energy_balance.c and energy_work.c, which have the formulas, in the same order.
 *
 * The host composes the calls (program_balance.c) and defines ENERGY_<SUM>, the numbers of sums.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/energy_row.h"

/* ---- contacts ---------------------------------------------------------------------------------- */

struct dem_row_balance
{
    struct dem_exact_sums to;
    struct dem_gathered gathered;
    struct dem_energy_row energy;
    struct dem_contact_row then, was;     /* before the law; with the overlap of a step ago */
    double before[DEM_LAW_HISTORY];       /* history before the law */
    double rate;                          /* m/s  of change of the distance */
    double radius[2], inverse_inertia[2], inverse_mass[2];    /* 0: of a wall */
};

/* Before the laws of a row: what the balance reads of the partners. wall: there is no second one. */
static void dem_balance_gather(global const double4 *restrict record, uint2 partners, int wall,
                               const struct dem_gathered *g, struct dem_row_balance *b)
{
    const uint other = wall ? partners.x : partners.y & ((1u << 27) - 1);
    global const double4 *const i = record + 4*(size_t)partners.x, *const j = record + 4*(size_t)other;

    b->gathered = *g;
    b->radius[0] = i[0].w;
    b->inverse_mass[0] = i[1].w;
    b->inverse_inertia[0] = i[2].w;
    b->radius[1] = wall ? 0.0 : j[0].w;
    b->inverse_mass[1] = wall ? 0.0 : j[1].w;
    b->inverse_inertia[1] = wall ? 0.0 : j[2].w;
}

/* After laws have replaced contacts (dem_energy_balance_begin_batch). b NULL, here and below: nothing is
   asked for. */
static void dem_balance_begin(struct dem_row_balance *b, const struct dem_contact_row *r, int wall)
{
    if (!b)
    {
        return;
    }
    const struct dem_gathered *const g = &b->gathered;
    const double distance = sqrt(g->rx[0]*g->rx[0] + g->ry[0]*g->ry[0] + g->rz[0]*g->rz[0]);
    const double raw = (wall ? r->min_radius : g->radii[0]) - distance,
                 now = r->overlap > 0.0 ? r->overlap : raw;
    const double depth = (wall ? 1.0 : 0.5)*r->overlap, a = b->radius[0] - depth,
                 other = wall ? 0.0 : b->radius[1] - depth;
    const double turn = b->inverse_inertia[0] + b->inverse_inertia[1],
                 move = b->inverse_mass[0] + b->inverse_mass[1];
    const double slip = move + a*a*b->inverse_inertia[0] +
                        (wall ? 0.0 : other*other*b->inverse_inertia[1]);

    b->rate = g->vx[0]*r->hx + g->vy[0]*r->hy + g->vz[0]*r->hz;
    b->energy.previous_overlap = fmax(now + r->dt*b->rate, 0.0);
    b->energy.previous_kn = 0.0;
    b->energy.inertia = turn > 0.0 ? 1.0/turn : INFINITY;
    b->energy.slip_mass = slip > 0.0 ? 1.0/slip : INFINITY;
}

static void dem_balance_before(struct dem_row_balance *b, const struct dem_contact_row *r,
                               const double *history, int columns)
{
    if (b)
    {
        b->then = *r;
        for (int m = 0; m < columns; m++)
        {
            b->before[m] = history[m];
        }
    }
}

/* What a law has added to forces, moments and energies of the row. */
static void dem_balance_contribution(struct dem_row_balance *b, const struct dem_contact_row *r)
{
    struct dem_energy_row *const e = &b->energy;

    e->normal_force = r->fn - b->then.fn;
    e->mx = r->mx - b->then.mx;
    e->my = r->my - b->then.my;
    e->mz = r->mz - b->then.mz;
    e->stored = r->stored - b->then.stored;
    e->lost = r->lost - b->then.lost;
}

/* A law without energy: the work of its force and moment. */
static void dem_balance_measure(struct dem_row_balance *b, const struct dem_contact_row *r)
{
    struct dem_energy_row *const e = &b->energy;
    const double along = e->normal_force*b->rate;
    const double slip = (r->fx - b->then.fx)*r->sx + (r->fy - b->then.fy)*r->sy +
                        (r->fz - b->then.fz)*r->sz;
    const double spin = e->mx*r->wx + e->my*r->wy + e->mz*r->wz;

    e->lost = -r->touching*(along + slip + spin)*r->dt;
}

/* The row in which the normal law is evaluated again, with the overlap before the drift. */
static struct dem_contact_row *dem_balance_row_before(struct dem_row_balance *b,
                                                      const struct dem_contact_row *r)
{
    b->was = *r;
    b->was.overlap = b->energy.previous_overlap;
    b->was.touching = b->energy.previous_overlap > 0.0 ? 1.0 : 0.0;
    b->was.kn = b->was.fn = 0.0;
    return &b->was;
}

#ifdef ENERGY_HEATED
/* Heat of a row: what the first partner receives, and what was dissipated. */
static void dem_balance_heat(const struct dem_row_balance *b, const struct dem_contact_row *r,
                             int heats, int wall, double rate)
{
    const double heat = heats ? r->dissipated : 0.0;

    dem_exact_add(&b->to, ENERGY_HEATED, heat);
    if (wall)
    {
        dem_exact_add(&b->to, ENERGY_HEAT_WALLS, rate*r->dt);
        dem_exact_add(&b->to, ENERGY_HEAT_WALLS, -heat);
    }
}
#endif

/* ---- particles --------------------------------------------------------------------------------- */

struct dem_particle_balance
{
    struct dem_exact_sums to;
    double own[DEM_DEVICE_LAWS][3];       /* N  of each law */
    double v[3], w[3];                    /* m/s, 1/s  before the kick */
    double drag_impulse[3], spin_impulse[3], carried[3];    /* N s, N m s, N s */
    double window, h;                     /* s */
    int driven, moves;                    /* moves: 1/m is above zero */
};

/* Before the laws, with the sums of contacts: work of what moves a driven particle against them in the
   second half of the drift behind. */
static void dem_balance_particle(constant struct dem_device_batch *batch, double4 v, double4 w, double4 rest,
                                 const double f[3], const double t[3], struct dem_particle_balance *b)
{
    b->h = batch->dt;
    b->window = batch->window;
    b->moves = v.w > 0.0;
    b->driven = (as_ulong(rest.z) >> 16 & 2u) != 0;    /* DEM_PARTICLE_DRIVEN */
    b->v[0] = v.x;
    b->v[1] = v.y;
    b->v[2] = v.z;
    b->w[0] = w.x;
    b->w[1] = w.y;
    b->w[2] = w.z;
    for (int k = 0; k < 3; k++)
    {
        b->drag_impulse[k] = b->spin_impulse[k] = b->carried[k] = 0.0;
    }
    if (b->driven)
    {
        dem_exact_add(&b->to, ENERGY_DRIVEN, -(dem_vec_dot(f, b->v) + dem_vec_dot(t, b->w))*(0.5*b->h));
    }
}

/* The forces of the scene on the particle, which now has v and w. */
static void dem_balance_applied(const struct dem_particle_balance *b, const double force[3],
                                const double torque[3], double4 v, double4 w)
{
    const double after[3] = {v.x, v.y, v.z}, turned[3] = {w.x, w.y, w.z};
    double work = 0.0;

    for (int k = 0; k < 3; k++)
    {
        work += 0.5*b->h*(force[k]*(b->v[k] + after[k]) + torque[k]*(b->w[k] + turned[k]));
    }
    dem_exact_add(&b->to, ENERGY_APPLIED, work);
}

/* After the kick: the drift that follows (dem_energy_balance_after_drift). */
static void dem_balance_drift(const struct dem_particle_balance *b, double4 v, double4 w, double mass,
                              const double f[3], const double t[3])
{
    const double g[3] = {BALANCE_GRAVITY}, moved[3] = {v.x, v.y, v.z}, turned[3] = {w.x, w.y, w.z};

    dem_exact_add(&b->to, ENERGY_GRAVITY, mass*dem_vec_dot(g, moved)*b->h);
    if (b->driven)
    {
        const double power = dem_vec_dot(f, moved) + dem_vec_dot(t, turned),
                     weight = mass*dem_vec_dot(g, moved);

        dem_exact_add(&b->to, ENERGY_DRIVEN, -power*(0.5*b->h) - weight*b->h);
    }
}

static void dem_balance_before_law(struct dem_particle_balance *b, const struct dem_body_row *r, int k)
{
    b->own[k][0] = r->fx + r->rx;
    b->own[k][1] = r->fy + r->ry;
    b->own[k][2] = r->fz + r->rz;
}

static void dem_balance_after_law(struct dem_particle_balance *b, const struct dem_body_row *r, int k)
{
    b->own[k][0] = r->fx + r->rx - b->own[k][0];
    b->own[k][1] = r->fy + r->ry - b->own[k][1];
    b->own[k][2] = r->fz + r->rz - b->own[k][2];
}

/* The work of a law over the kick, to the sums of lost energy and of work. r has the velocities after
   it. */
static void dem_balance_kick(const struct dem_particle_balance *b, const struct dem_body_row *r, int k,
                             int drag, int added_mass, int rotational, uint lost, uint done)
{
    const double after[3] = {r->vx, r->vy, r->vz}, u[3] = {r->ux, r->uy, r->uz};
    const double v[3] = {0.5*(b->v[0] + after[0]), 0.5*(b->v[1] + after[1]),
                         0.5*(b->v[2] + after[2])};
    const double f[3] = {b->own[k][0], b->own[k][1], b->own[k][2]};

    if (drag && b->moves)
    {
        const double work = dem_vec_dot(b->drag_impulse, u);
        const double carried =
            b->window > 0.0 ? dem_vec_dot(b->carried, v)*b->h/b->window : 0.0;

        dem_exact_add(&b->to, done, work + carried);
        dem_exact_add(&b->to, lost, work - dem_vec_dot(b->drag_impulse, v));
    }
    if (added_mass)
    {
        const double gain[3] = {after[0] - b->v[0], after[1] - b->v[1], after[2] - b->v[2]};

        dem_exact_add(&b->to, done, -r->added_mass*dem_vec_dot(gain, v));
    }
    if (rotational)
    {
        const double w[3] = {0.5*(b->w[0] + r->wx), 0.5*(b->w[1] + r->wy), 0.5*(b->w[2] + r->wz)};

        dem_exact_add(&b->to, done, dem_vec_dot(b->spin_impulse, w));
    }
    dem_exact_add(&b->to, done, b->driven ? 0.0 : dem_vec_dot(f, v)*b->h);
}
