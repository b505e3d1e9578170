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
 * a frozen particle (1/m = 0, phi = 1), which passes on h b (u - v).
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
#include <math.h>
#include <string.h>

struct tray
{
    struct dem_body_block block;
    _Alignas(64) double over_m[DEM_BLOCK];                /* 1/kg  inverse inertial mass */
    _Alignas(64) double jx[DEM_BLOCK], jy[DEM_BLOCK], jz[DEM_BLOCK];          /* N s   drag impulse of this kick */
    _Alignas(64) double kept[DEM_BLOCK];                  /* 1     exp(-z) */
    _Alignas(64) double drag[DEM_BLOCK];                  /* kg/s  b without counterflow */
};

/* ---- gathering ----------------------------------------------------------------------------------------------- */

static void gather_records(struct tray *t, const struct dem_particle *record, const double *force, int rows)
{
    struct dem_body_block *const b = &t->block;

    b->n = (rows + 7)/8*8;
    for (int c = 0; c < b->n; c++)
    {
        const int k = c < rows ? c : rows - 1;
        const struct dem_particle *const i = &record[k];

        b->radius[c] = i->radius;
        b->mass[c] = i->mass;
        b->volume[c] = dem_particle_volume(i);
        b->vx[c] = i->v[0];
        b->vy[c] = i->v[1];
        b->vz[c] = i->v[2];
        b->wx[c] = i->w[0];
        b->wy[c] = i->w[1];
        b->wz[c] = i->w[2];
        b->fx[c] = force[3*k];
        b->fy[c] = force[3*k + 1];
        b->fz[c] = force[3*k + 2];
        b->b[c] = b->bux[c] = b->buy[c] = b->buz[c] = 0.0;
        t->over_m[c] = i->inverse_mass;
    }
}

static void gather_fluid(struct tray *t, const struct dem_particles *p, size_t first, int rows, double over_window)
{
    const double *const u = dem_column(p, DEM_COLUMN_FLUID_VELOCITY) + 3*first;
    const double *const g = dem_column(p, DEM_COLUMN_PRESSURE_GRADIENT) + 3*first;
    const double *const pending = dem_column(p, DEM_COLUMN_PENDING) + 3*first;
    struct dem_body_block *const b = &t->block;

    for (int c = 0; c < b->n; c++)
    {
        const int k = c < rows ? c : rows - 1;

        b->ux[c] = u[3*k];
        b->uy[c] = u[3*k + 1];
        b->uz[c] = u[3*k + 2];
        b->gx[c] = g[3*k];
        b->gy[c] = g[3*k + 1];
        b->gz[c] = g[3*k + 2];
        b->fx[c] += over_window*pending[3*k];
        b->fy[c] += over_window*pending[3*k + 1];
        b->fz[c] += over_window*pending[3*k + 2];
        b->void_fraction[c] = dem_column(p, DEM_COLUMN_VOID_FRACTION)[first + (size_t)k];
        b->density[c] = dem_column(p, DEM_COLUMN_FLUID_DENSITY)[first + (size_t)k];
        b->viscosity[c] = dem_column(p, DEM_COLUMN_FLUID_VISCOSITY)[first + (size_t)k];
    }
}

/* The fluid makes room for what particles have moved since the window's start. */
static void add_counterflow(struct tray *t, const struct dem_particles *p, size_t first, int rows)
{
    const double *const counterflow = dem_column(p, DEM_COLUMN_COUNTERFLOW) + first;
    const double *const start = dem_column(p, DEM_COLUMN_START_VELOCITY) + 3*first;
    struct dem_body_block *const b = &t->block;

    for (int c = 0; c < b->n; c++)
    {
        const int k = c < rows ? c : rows - 1;
        const double more = (counterflow[k] - 1.0)*b->b[c];

        t->drag[c] = b->b[c];
        b->b[c] += more;
        b->bux[c] += more*start[3*k];
        b->buy[c] += more*start[3*k + 1];
        b->buz[c] += more*start[3*k + 2];
    }
}

/* ---- the kick ------------------------------------------------------------------------------------------------ */

DEM_KERNEL
static void kick_with_drag(struct tray *restrict t, double h)
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
static void kick_without_drag(struct tray *restrict t, double h)
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

static void scatter(const struct tray *t, struct dem_particle *record, const double *torque, double h, int rows)
{
    for (int k = 0; k < rows; k++)
    {
        const double spin_up = h*record[k].inverse_inertia;

        record[k].v[0] = t->block.vx[k];
        record[k].v[1] = t->block.vy[k];
        record[k].v[2] = t->block.vz[k];
        record[k].w[0] += spin_up*torque[3*k];
        record[k].w[1] += spin_up*torque[3*k + 1];
        record[k].w[2] += spin_up*torque[3*k + 2];
    }
}

static void book_drag(const struct tray *t, const struct dem_particles *p, size_t first, double h, int rows)
{
    double *const impulse = dem_column(p, DEM_COLUMN_DRAG_IMPULSE) + 3*first;
    double *const kept = dem_column(p, DEM_COLUMN_KEPT) + first;
    double *const time = dem_column(p, DEM_COLUMN_DRAG_TIME) + first;

    for (int k = 0; k < rows; k++)
    {
        impulse[3*k] += t->jx[k];
        impulse[3*k + 1] += t->jy[k];
        impulse[3*k + 2] += t->jz[k];
        kept[k] *= t->kept[k];
        time[k] += t->drag[k]*h;
    }
}

void dem_sweep_bodies(struct dem_particles *p, const struct dem_chain *bodies, double kick, double window)
{
    const int fluid = dem_column(p, DEM_COLUMN_FLUID_VELOCITY) != NULL;
    struct tray t;

    memset(&t, 0, sizeof t);
    t.block.dt = kick;
    for (size_t first = 0; first < p->n; first += DEM_BLOCK)
    {
        const int rows = p->n - first < DEM_BLOCK ? (int)(p->n - first) : DEM_BLOCK;

        gather_records(&t, p->record + first, dem_column(p, DEM_COLUMN_FORCE) + 3*first, rows);
        if (fluid)
        {
            gather_fluid(&t, p, first, rows, window > 0.0 ? 1.0/window : 0.0);
        }
        for (int k = 0; k < bodies->links; k++)
        {
            bodies->link[k].effect->act_on_bodies(bodies->link[k].settings, &t.block);
        }
        if (fluid)
        {
            add_counterflow(&t, p, first, rows);
            kick_with_drag(&t, kick);
            book_drag(&t, p, first, kick, rows);
        }
        else
        {
            kick_without_drag(&t, kick);
        }
        scatter(&t, p->record + first, dem_column(p, DEM_COLUMN_TORQUE) + 3*first, kick, rows);
    }
}

/* ---- windows ------------------------------------------------------------------------------------------------- */

void dem_bodies_open(struct dem_particles *p)
{
    if (!dem_column(p, DEM_COLUMN_FLUID_VELOCITY))
    {
        return;
    }
    memset(dem_column(p, DEM_COLUMN_DRAG_IMPULSE), 0, 3*p->n*sizeof(double));
    memset(dem_column(p, DEM_COLUMN_DRAG_TIME), 0, p->n*sizeof(double));
    for (size_t i = 0; i < p->n; i++)
    {
        dem_column(p, DEM_COLUMN_KEPT)[i] = 1.0;
        memcpy(dem_column(p, DEM_COLUMN_START_VELOCITY) + 3*i, p->record[i].v, sizeof p->record[i].v);
    }
}

void dem_bodies_close(struct dem_particles *p)
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
}
