/*
 * sweep_bodies.c -- body effects block by block, then the kick.
 *
 * With all explicit forces F (contacts, gravity, pressure gradient, pending) and drag b (u - v) constant in b and u over
 * the kick h, the exact solution of m dv/dt = F + b u - b v is
 *
 *     v' = v + phi(z) h/m (F + b u - b v)        z = b h/m,  phi(z) = (1 - exp(-z))/z,  phi(0) = 1
 *
 * which needs no case for b = 0 and stays bounded for any h: a heavy drag brings v to u, never past it. The drag's own
 * share of the impulse is J = m (v' - v) - F h = h [phi (b u - b v) - (1 - phi) F]; written like this it also holds for
 * a frozen particle (1/m = 0, phi = 1), which passes on h b (u - v). Backwards (who comes in by a stream) drag grows as exp(-z): where
 * that is more than e, drag is left out of such a kick, and the one that follows brings v to u.
 *
 * Added mass a (column addedMass) is part of the inertia m in these formulas; the particle's weight and momentum are without it. Forces
 * that react (lift, and a Du/Dt) are in F. What the fluid gets of the two is the opposite of
 *
 *     J_other = r h - a (v' - v)
 *
 * so that J + J_other is what the fluid has changed the particle's momentum by, to the last digit, whatever a becomes in the next
 * window. Rotational drag is integrated like b, on the spin.
 *
 * Du/Dt is that of the window before, so where a is more than the fluid's own mass (Zuber's in a dense bed) the exchange would diverge for
 * short windows. The fluid is therefore told how J_other answers to its new velocity, too: R_a (u' - u - w T) with w its change of the last
 * window over that one's length and R_a = a m/(m + a) of a free particle, a of a frozen one. R_a joins R; R_a w T is taken off what the
 * fluid is told, and off the impulse that is left for the next window. In a steady flow, however it varies in space, all of this is zero;
 * in models of one cell it is stable, with the fluid free or blocked, from packed to dilute, up to a void fraction of 0.5 for bubbles
 * whatever the drag, and below with T b/m above 0.1.
 *
 * What the fluid must know of the answer to a change of its velocity over a whole window T is R = dJ/du. A free particle
 * has R = m E, E = 1 - product of exp(-b h/m). One held by its neighbours answers more stiffly, up to b T when it can't
 * move at all; with R = m E alone the exchange diverges there. The impulse itself tells which: R = |J|/|u - v(start)|,
 * kept between m E and b T.
 *
 * Counterflow. In an incompressible fluid of void fraction e the fluid makes room: where particles gain dv the fluid
 * loses dv (1 - e)/e, the slip changes by -dv/e, and with the pressure gradient that comes with it the force on a
 * particle by -b dv/e^2. Frozen u and grad p know nothing of that, and for T above the relaxation time the exchange then
 * diverges in dense suspensions whatever R is (found with particles, fluid and pressure in one dimension: from
 * T b/m = 0.1 at e = 0.4, density ratio 2.5). So where the coupling asks for it (column counterflow, c = 1/e^2) the
 * slip of a window is
 *
 *     u - v  ->  u - v(start) - c (v - v(start))
 *
 * which changes nothing at first order in T, and R = m E/c with E from c b. A steady force F leaves the share
 * (1 - exp(-Z))/Z, Z = c b T/m, of its impulse with a free particle; drag passes the rest on to the fluid (column passed):
 * that is how J answers to a change of the pressure gradient, and the fluid must treat it as implicitly as R. With both,
 * the exchange is stable for any T b/m from a density ratio of (1 - e)/e on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/sweep_bodies.h"
#include "base/math.h"
#include "step/body_tray.h"
#include "step/sum_contacts.h"
#include <math.h>
#include <string.h>

/* ---- the kick ------------------------------------------------------------------------------------------------ */

DEM_KERNEL
static void kick_with_drag(struct dem_body_tray *restrict t, double h)
{
    struct dem_body_block *const b = &t->block;

    for (int c = 0; c < b->n; c++)
    {
        const double z = b->b[c]*h*t->over_m[c], phi = dem_phi(z), step = phi*h*t->over_m[c];
        const double dx = b->bux[c] - b->b[c]*b->vx[c], dy = b->buy[c] - b->b[c]*b->vy[c], dz = b->buz[c] - b->b[c]*b->vz[c];

        b->vx[c] += step*(b->fx[c] + dx);
        b->vy[c] += step*(b->fy[c] + dy);
        b->vz[c] += step*(b->fz[c] + dz);
        t->jx[c] = h*(phi*dx - (1.0 - phi)*b->fx[c]);
        t->jy[c] = h*(phi*dy - (1.0 - phi)*b->fy[c]);
        t->jz[c] = h*(phi*dz - (1.0 - phi)*b->fz[c]);
        t->kept[c] = 1.0 - z*phi;
    }
}

DEM_KERNEL
static void kick_without_drag(struct dem_body_tray *restrict t, double h)
{
    struct dem_body_block *const b = &t->block;

    for (int c = 0; c < b->n; c++)
    {
        const double step = h*t->over_m[c];

        b->vx[c] += step*b->fx[c];
        b->vy[c] += step*b->fy[c];
        b->vz[c] += step*b->fz[c];
    }
}

/* The kick, and what the fluid is told of it. */
static void kick_in_fluid(struct dem_body_tray *t, struct dem_particles *p, size_t first, int rows, double h)
{
    const int reacts = dem_column(p, DEM_COLUMN_OTHER_IMPULSE) != NULL;

    if (reacts)
    {
        dem_body_tray_join(t);
    }
    dem_body_tray_counterflow(t, p, first, rows);
    if (h < 0.0)
    {
        dem_body_tray_spare(t, p, first, rows, h);
    }
    kick_with_drag(t, h);
    dem_body_tray_book(t, p, first, rows, h);
    if (reacts)
    {
        dem_body_tray_react(t, p, first, rows, h);
    }
    if (dem_column(p, DEM_COLUMN_TURN_IMPULSE))
    {
        dem_body_tray_turn(t, p, first, rows, h);
    }
}

static int rows_from(const struct dem_particles *p, size_t first)
{
    return p->n - first < DEM_BLOCK ? (int)(p->n - first) : DEM_BLOCK;
}

/* What acts on a block; the ledger, where there is one, looks on. */
static void act(struct dem_body_tray *t, const struct dem_chain *bodies, struct dem_ledger *ledger)
{
    for (int k = 0; k < bodies->links; k++)
    {
        if (ledger)
        {
            dem_ledger_body_before(ledger, &t->block);
        }
        bodies->link[k].effect->act_on_bodies(bodies->link[k].settings, &t->block);
        if (ledger)
        {
            dem_ledger_body_after(ledger, &t->block, k);
        }
    }
}

static void sweep_block(struct dem_body_pass *pass, size_t first, int rows)
{
    struct dem_particles *const p = pass->particles;
    struct dem_body_tray *const t = &pass->tray;
    const struct dem_body_sweep *const s = pass->sweep;
    const int fluid = dem_column(p, DEM_COLUMN_FLUID_VELOCITY) != NULL;

    dem_body_tray_forces(t, p, first, pass->quiet);
    if (s->contacts)
    {
        const struct dem_sum_part part = {.first = first, .end = first + (size_t)rows, .force = t->force, .torque = t->torque,
                                          .quiet = pass->quiet};

        dem_sum_part(p, s->contacts, &part);
    }
    dem_body_tray_gather(t, p, first, rows, (pass->bodies->needs & DEM_NEEDS_SPIN) != 0);
    if (fluid)
    {
        dem_body_tray_fluid(t, p, first, rows, s->window > 0.0 ? 1.0/s->window : 0.0);
    }
    act(t, pass->bodies, s->ledger);
    if (fluid && pass->bodies->whole_drag)
    {
        dem_body_tray_whole_drag(t);
    }
    if (fluid)
    {
        kick_in_fluid(t, p, first, rows, s->kick);
    }
    else
    {
        kick_without_drag(t, s->kick);
    }
    if (s->ledger)
    {
        const struct dem_ledger_kick k = {.bodies = pass->bodies, .block = &t->block, .j = {t->jx, t->jy, t->jz}, .first = first,
                                          .turn = {t->turn[0], t->turn[1], t->turn[2]}, .rows = rows, .h = s->kick, .window = s->window};

        dem_ledger_kicked(s->ledger, p, &k);
    }
    dem_body_tray_scatter(t, p, first, rows, s->kick);
    if (dem_column(p, DEM_COLUMN_TURN_IMPULSE))
    {
        dem_body_tray_turned(t, p, first, rows);
    }
    if (pass->quiet && s->round)
    {
        dem_motion_drift(p->record + first, (size_t)rows, s->kick, s->round, &pass->seen);
    }
}

void dem_bodies_begin(struct dem_body_pass *pass, struct dem_particles *p, const struct dem_chain *bodies, const struct dem_body_sweep *s)
{
    pass->particles = p;
    pass->bodies = bodies;
    pass->sweep = s;
    pass->next = 0;
    pass->quiet = s->quiet;
    memset(&pass->seen, 0, sizeof pass->seen);
    memset(&pass->tray, 0, sizeof pass->tray);
    pass->tray.block.dt = s->kick;
}

void dem_bodies_until(struct dem_body_pass *pass, size_t end)
{
    for (; pass->next < end; pass->next += DEM_BLOCK)
    {
        sweep_block(pass, pass->next, rows_from(pass->particles, pass->next));
    }
}

void dem_sweep_bodies(struct dem_particles *p, const struct dem_chain *bodies, const struct dem_body_sweep *s)
{
    struct dem_body_pass pass;

    dem_bodies_begin(&pass, p, bodies, s);
    dem_bodies_until(&pass, p->n);
}

/* ---- windows ------------------------------------------------------------------------------------------------- */

/* What laws of drag make of the fluid alone, and the added mass. */
void dem_bodies_open_laws(struct dem_particles *p, const struct dem_chain *bodies)
{
    const int swarm = dem_column(p, DEM_COLUMN_SWARM_FIRST) != NULL, added = dem_column(p, DEM_COLUMN_ADDED_MASS) != NULL;
    struct dem_body_tray t;

    memset(&t, 0, sizeof t);
    for (size_t first = 0; (swarm || added) && first < p->n; first += DEM_BLOCK)
    {
        const int rows = rows_from(p, first);

        dem_body_tray_forces(&t, p, first, 0);
        dem_body_tray_gather(&t, p, first, rows, 0);
        dem_body_tray_fluid(&t, p, first, rows, 0.0);
        memset(t.block.added, 0, sizeof t.block.added);
        for (int k = 0; k < bodies->links; k++)
        {
            if (bodies->link[k].effect->open_bodies)
            {
                bodies->link[k].effect->open_bodies(bodies->link[k].settings, &t.block);
            }
        }
        if (swarm)
        {
            dem_body_tray_keep_swarm(&t, p, first, rows);
        }
        if (added)
        {
            dem_body_tray_inertia(&t, p, first, rows);
        }
    }
}

/* What the fluid will be told begins at nothing. */
static void clear(struct dem_particles *p, enum dem_column_name column)
{
    if (dem_column(p, column))
    {
        memset(dem_column(p, column), 0, (size_t)p->column[column].width*p->n*sizeof(double));
    }
}

void dem_bodies_open(struct dem_particles *p, const struct dem_chain *bodies)
{
    if (!dem_column(p, DEM_COLUMN_FLUID_VELOCITY))
    {
        return;
    }
    dem_bodies_open_laws(p, bodies);
    clear(p, DEM_COLUMN_DRAG_IMPULSE);
    clear(p, DEM_COLUMN_OTHER_IMPULSE);
    clear(p, DEM_COLUMN_TURN_IMPULSE);
    clear(p, DEM_COLUMN_DRAG_TIME);
    for (size_t i = 0; i < p->n; i++)
    {
        dem_column(p, DEM_COLUMN_KEPT)[i] = 1.0;
        memcpy(dem_column(p, DEM_COLUMN_START_VELOCITY) + 3*i, p->record[i].v, sizeof p->record[i].v);
        memcpy(dem_column(p, DEM_COLUMN_WAY) + 3*i, p->record[i].x, sizeof p->record[i].x);
    }
}

/* From where they were to where they are; who was wrapped has gone less than half a box. */
static void ways(struct dem_particles *p, const struct dem_domain *domain)
{
    double *const way = dem_column(p, DEM_COLUMN_WAY);

    for (size_t i = 0; i < 3*p->n; i++)
    {
        const double length = domain->length[i%3], gone = p->record[i/3].x[i%3] - way[i];

        way[i] = gone - (length > 0.0 ? length*nearbyint(gone/length) : 0.0);
    }
}

/* Frozen ones answer with all of a, free ones with what they don't follow. */
static void answer_of_added_mass(struct dem_particles *p, double window)
{
    const double *const added = dem_column(p, DEM_COLUMN_ADDED_MASS), *const change = dem_column(p, DEM_COLUMN_FLUID_CHANGE);

    for (size_t i = 0; added && i < p->n; i++)
    {
        const struct dem_particle *const r = &p->record[i];
        const double answer = added[i]*(r->inverse_mass > 0.0 ? r->mass*r->inverse_mass : 1.0);

        dem_column(p, DEM_COLUMN_RESPONSE)[i] += answer;
        for (size_t k = 3*i; k < 3*i + 3; k++)
        {
            dem_column(p, DEM_COLUMN_FORESEEN)[k] = answer*change[k]*window;
            dem_column(p, DEM_COLUMN_OTHER_IMPULSE)[k] -= dem_column(p, DEM_COLUMN_FORESEEN)[k];
        }
    }
}

void dem_bodies_close(struct dem_particles *p, const struct dem_domain *domain, double window)
{
    const double *const u = dem_column(p, DEM_COLUMN_FLUID_VELOCITY), *const start = dem_column(p, DEM_COLUMN_START_VELOCITY);
    const double *const J = dem_column(p, DEM_COLUMN_DRAG_IMPULSE);

    for (size_t i = 0; u && i < p->n; i++)
    {
        const double free = p->record[i].inverse_mass > 0.0 ? (1.0 - dem_column(p, DEM_COLUMN_KEPT)[i])/p->record[i].inverse_mass : 0.0;
        const double held = dem_column(p, DEM_COLUMN_DRAG_TIME)[i], counterflow = dem_column(p, DEM_COLUMN_COUNTERFLOW)[i];
        double slip = 0.0, impulse = 0.0;

        for (size_t k = 3*i; k < 3*i + 3; k++)
        {
            slip += (u[k] - start[k])*(u[k] - start[k]);
            impulse += J[k]*J[k];
        }
        slip = sqrt(slip);
        impulse = sqrt(impulse);
        const double shown = p->record[i].inverse_mass == 0.0 || impulse >= held*slip ? held : impulse/slip;

        const double least = free/counterflow;

        dem_column(p, DEM_COLUMN_RESPONSE)[i] = shown > least ? shown : least;
        dem_column(p, DEM_COLUMN_PASSED)[i] = free > 0.0 ? 1.0 - free/(counterflow*held) : 0.0;
    }
    answer_of_added_mass(p, window);
    if (u)
    {
        ways(p, domain);
    }
}
