/*
 * body_tray.c -- records by fours, columns by whole vectors.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/body_tray.h"
#include "base/math.h"
#include "effects/drag.h"
#include "effects/effect.h"
#include "step/quad.h"
#include <stddef.h>
#include <string.h>

static const enum dem_column_name swarm[DEM_SWARM] = {DEM_COLUMN_SWARM_FIRST, DEM_COLUMN_SWARM_SECOND};

/* What is seen of the fluid: a column and where it goes in the tray, three rows of a vector behind each other. */
static const struct
{
    enum dem_column_name column;
    size_t place;
} vectors[] =
{
    {DEM_COLUMN_FLUID_VELOCITY, offsetof(struct dem_body_block, ux)},
    {DEM_COLUMN_PRESSURE_GRADIENT, offsetof(struct dem_body_block, gx)},
    {DEM_COLUMN_FLUID_ACCELERATION, offsetof(struct dem_body_block, ax)},
    {DEM_COLUMN_VORTICITY, offsetof(struct dem_body_block, ox)},
    {DEM_COLUMN_STRESS, offsetof(struct dem_body_block, sx)},
}, numbers[] =
{
    {DEM_COLUMN_VOID_FRACTION, offsetof(struct dem_body_block, void_fraction)},
    {DEM_COLUMN_FLUID_DENSITY, offsetof(struct dem_body_block, density)},
    {DEM_COLUMN_FLUID_VISCOSITY, offsetof(struct dem_body_block, viscosity)},
    {DEM_COLUMN_MEAN_DIAMETER, offsetof(struct dem_body_block, mean_diameter)},
    {DEM_COLUMN_ADDED_MASS, offsetof(struct dem_body_block, added)},
};
_Static_assert(offsetof(struct dem_body_block, uz) == offsetof(struct dem_body_block, ux) + 2*DEM_BLOCK*sizeof(double),
               "the rows of a vector lie behind each other");

static double *row_at(struct dem_body_block *b, size_t place)
{
    return (double *)(void *)((char *)b + place);
}

/* ---- in ------------------------------------------------------------------------------------------------------ */

/* Four records into the lanes from c on. */
__attribute__((always_inline)) static inline void take(struct dem_body_tray *t, const struct dem_particle *const four[4], int c)
{
    struct dem_body_block *const b = &t->block;
    dem_quad v[4];

    for (int k = 0; k < 4; k++)
    {
        v[k] = DEM_QUAD(four[k]->v);
        b->radius[c + k] = four[k]->radius;
        b->mass[c + k] = four[k]->mass;
    }
    dem_quad_turn(v);
    DEM_QUAD_AT(b->vx + c) = v[0];
    DEM_QUAD_AT(b->vy + c) = v[1];
    DEM_QUAD_AT(b->vz + c) = v[2];
    DEM_QUAD_AT(t->over_m + c) = v[3];
}

DEM_KERNEL
static void take_records(struct dem_body_tray *restrict t, const struct dem_particle *record, int rows)
{
    struct dem_body_block *const b = &t->block;
    const int whole = rows/4*4;

    for (int c = 0; c < whole; c += 4)
    {
        take(t, (const struct dem_particle *const[4]){record + c, record + c + 1, record + c + 2, record + c + 3}, c);
    }
    if (whole < rows)
    {
        const struct dem_particle *const from = record + whole, *const last = record + rows - 1;

        take(t, (const struct dem_particle *const[4]){from, from + 1 < last ? from + 1 : last, from + 2 < last ? from + 2 : last, last},
             whole);
    }
    for (int c = 0; c < b->n; c++)
    {
        b->volume[c] = dem_sphere_volume(b->radius[c]);
        b->b[c] = b->bux[c] = b->buy[c] = b->buz[c] = 0.0;
    }
}

static void take_spins(struct dem_body_block *b, const struct dem_particle *record, int rows)
{
    for (int c = 0; c < rows; c++)
    {
        b->wx[c] = record[c].w[0];
        b->wy[c] = record[c].w[1];
        b->wz[c] = record[c].w[2];
    }
}

/* A column of vectors as three of numbers. */
DEM_KERNEL
static void split(const double *restrict from, int rows, double *restrict x, double *restrict y, double *restrict z)
{
    for (int c = 0; c < rows; c++)
    {
        x[c] = from[3*c];
        y[c] = from[3*c + 1];
        z[c] = from[3*c + 2];
    }
}

/* The same, `share` of it, added. */
DEM_KERNEL
static void split_add(const double *restrict from, int rows, double share, double *restrict x, double *restrict y, double *restrict z)
{
    for (int c = 0; c < rows; c++)
    {
        x[c] += share*from[3*c];
        y[c] += share*from[3*c + 1];
        z[c] += share*from[3*c + 2];
    }
}

void dem_body_tray_forces(struct dem_body_tray *t, const struct dem_particles *p, size_t first, int own)
{
    t->force = own ? t->own[0] : dem_column(p, DEM_COLUMN_FORCE) + 3*first;
    t->torque = own ? t->own[1] : dem_column(p, DEM_COLUMN_TORQUE) + 3*first;
}

void dem_body_tray_gather(struct dem_body_tray *t, const struct dem_particles *p, size_t first, int rows, int spin)
{
    struct dem_body_block *const b = &t->block;

    b->n = (rows + 7)/8*8;
    take_records(t, p->record + first, rows);
    if (spin)
    {
        take_spins(b, p->record + first, rows);
    }
    if (dem_column(p, DEM_COLUMN_OTHER_IMPULSE))
    {
        memset(b->rx, 0, 3*sizeof b->rx);
    }
    if (dem_column(p, DEM_COLUMN_TURN_IMPULSE))
    {
        memset(b->t, 0, 4*sizeof b->t);
    }
    split(t->force, rows, b->fx, b->fy, b->fz);
}

void dem_body_tray_fluid(struct dem_body_tray *t, const struct dem_particles *p, size_t first, int rows, double over_window)
{
    struct dem_body_block *const b = &t->block;
    const size_t size = (size_t)rows*sizeof(double);

    for (size_t k = 0; k < sizeof vectors/sizeof vectors[0]; k++)
    {
        const double *const from = dem_column(p, vectors[k].column);
        double *const to = row_at(b, vectors[k].place);

        if (from)
        {
            split(from + 3*first, rows, to, to + DEM_BLOCK, to + 2*DEM_BLOCK);
        }
    }
    for (size_t k = 0; k < sizeof numbers/sizeof numbers[0]; k++)
    {
        const double *const from = dem_column(p, numbers[k].column);

        if (from)
        {
            memcpy(row_at(b, numbers[k].place), from + first, size);
        }
    }
    split_add(dem_column(p, DEM_COLUMN_PENDING) + 3*first, rows, over_window, b->fx, b->fy, b->fz);
    for (int k = 0; k < DEM_SWARM && dem_column(p, swarm[k]); k++)
    {
        memcpy(b->swarm[k], dem_column(p, swarm[k]) + first, size);
    }
}

/* b/e, with the law's own least void fraction; lift likewise */
DEM_KERNEL
static void raise(struct dem_body_block *restrict b)
{
    for (int c = 0; c < b->n; c++)
    {
        const double over = 1.0/dem_drag_void(b->void_fraction[c]);

        b->b[c] *= over;
        b->bux[c] *= over;
        b->buy[c] *= over;
        b->buz[c] *= over;
        b->rx[c] *= over;
        b->ry[c] *= over;
        b->rz[c] *= over;
    }
}

void dem_body_tray_whole_drag(struct dem_body_tray *t)
{
    raise(&t->block);
}

DEM_KERNEL
static void resist(struct dem_body_tray *restrict t, const double *restrict counterflow, const double *restrict start, int rows)
{
    struct dem_body_block *const b = &t->block;

    for (int c = 0; c < rows; c++)
    {
        const double more = (counterflow[c] - 1.0)*b->b[c];

        t->drag[c] = b->b[c];
        b->b[c] += more;
        b->bux[c] += more*start[3*c];
        b->buy[c] += more*start[3*c + 1];
        b->buz[c] += more*start[3*c + 2];
    }
}

void dem_body_tray_counterflow(struct dem_body_tray *t, const struct dem_particles *p, size_t first, int rows)
{
    resist(t, dem_column(p, DEM_COLUMN_COUNTERFLOW) + first, dem_column(p, DEM_COLUMN_START_VELOCITY) + 3*first, rows);
}

void dem_body_tray_spare(struct dem_body_tray *t, const struct dem_particles *p, size_t first, int rows, double h)
{
    struct dem_body_block *const b = &t->block;

    for (int c = 0; c < rows; c++)
    {
        const double moves = b->b[c]*h*t->over_m[c] < -1.0 ? 0.0 : 1.0;
        const double turns = b->t[c]*h*p->record[first + (size_t)c].inverse_inertia < -1.0 ? 0.0 : 1.0;

        t->drag[c] *= moves;
        b->b[c] *= moves;
        b->bux[c] *= moves;
        b->buy[c] *= moves;
        b->buz[c] *= moves;
        b->t[c] *= turns;
        b->tx[c] *= turns;
        b->ty[c] *= turns;
        b->tz[c] *= turns;
    }
}

void dem_body_tray_keep_swarm(const struct dem_body_tray *t, struct dem_particles *p, size_t first, int rows)
{
    for (int k = 0; k < DEM_SWARM; k++)
    {
        memcpy(dem_column(p, swarm[k]) + first, t->block.swarm[k], (size_t)rows*sizeof(double));
    }
}

void dem_body_tray_inertia(const struct dem_body_tray *t, struct dem_particles *p, size_t first, int rows)
{
    double *const added = dem_column(p, DEM_COLUMN_ADDED_MASS) + first;

    for (int c = 0; c < rows; c++)
    {
        struct dem_particle *const r = &p->record[first + (size_t)c];

        added[c] = t->block.added[c];
        r->inverse_mass = r->inverse_mass > 0.0 ? 1.0/(r->mass + added[c]) : 0.0;
    }
}

/* ---- besides drag ---------------------------------------------------------------------------------------------- */

DEM_KERNEL
static void join(struct dem_body_block *restrict b)
{
    for (int c = 0; c < b->n; c++)
    {
        b->fx[c] += b->rx[c];
        b->fy[c] += b->ry[c];
        b->fz[c] += b->rz[c];
    }
}

void dem_body_tray_join(struct dem_body_tray *t)
{
    join(&t->block);
}

/* The added mass takes its share of whatever changes the velocity. */
void dem_body_tray_react(const struct dem_body_tray *t, struct dem_particles *p, size_t first, int rows, double h)
{
    const struct dem_body_block *const b = &t->block;
    double *const impulse = dem_column(p, DEM_COLUMN_OTHER_IMPULSE) + 3*first;

    for (int c = 0; c < rows; c++)
    {
        const double *const before = p->record[first + (size_t)c].v;

        impulse[3*c] += h*b->rx[c] - b->added[c]*(b->vx[c] - before[0]);
        impulse[3*c + 1] += h*b->ry[c] - b->added[c]*(b->vy[c] - before[1]);
        impulse[3*c + 2] += h*b->rz[c] - b->added[c]*(b->vz[c] - before[2]);
    }
}

/* Like the kick with drag: I dw/dt = M + t o - t w with M of the contacts and t constant over h. */
void dem_body_tray_turn(struct dem_body_tray *t, const struct dem_particles *p, size_t first, int rows, double h)
{
    struct dem_body_block *const b = &t->block;
    const double *const moment = t->torque;
    double *const spin[3] = {b->wx, b->wy, b->wz}, *const target[3] = {b->tx, b->ty, b->tz};

    for (int c = 0; c < rows; c++)
    {
        const double over = p->record[first + (size_t)c].inverse_inertia;
        const double z = b->t[c]*h*over, phi = dem_phi(z), step = phi*h*over;

        for (int k = 0; k < 3; k++)
        {
            const double M = moment[3*c + k], pull = target[k][c] - b->t[c]*spin[k][c];

            t->turn[k][c] = h*(phi*pull - (1.0 - phi)*M);
            spin[k][c] += step*(M + pull);
        }
    }
}

void dem_body_tray_turned(const struct dem_body_tray *t, struct dem_particles *p, size_t first, int rows)
{
    const double *const spin[3] = {t->block.wx, t->block.wy, t->block.wz};
    double *const impulse = dem_column(p, DEM_COLUMN_TURN_IMPULSE) + 3*first;

    for (int c = 0; c < rows; c++)
    {
        for (int k = 0; k < 3; k++)
        {
            p->record[first + (size_t)c].w[k] = spin[k][c];
            impulse[3*c + k] += t->turn[k][c];
        }
    }
}

/* ---- out ----------------------------------------------------------------------------------------------------- */

DEM_KERNEL
static void put_records(const struct dem_body_tray *restrict t, struct dem_particle *restrict record, const double *restrict torque,
                        int rows, double h)
{
    for (int c = 0; c < rows; c += 4)
    {
        dem_quad v[4] = {DEM_QUAD(t->block.vx + c), DEM_QUAD(t->block.vy + c), DEM_QUAD(t->block.vz + c), DEM_QUAD(t->over_m + c)};

        dem_quad_turn(v);
        for (int k = 0; k < 4 && c + k < rows; k++)
        {
            struct dem_particle *const i = &record[c + k];
            const double up = h*i->inverse_inertia, *const m = torque + 3*(c + k);
            const dem_quad turn = {up*m[0], up*m[1], up*m[2], 0.0};

            DEM_QUAD_AT(i->v) = v[k];
            DEM_QUAD_AT(i->w) += turn;
        }
    }
}

void dem_body_tray_scatter(const struct dem_body_tray *t, struct dem_particles *p, size_t first, int rows, double h)
{
    put_records(t, p->record + first, t->torque, rows, h);
}

DEM_KERNEL
static void book(const struct dem_body_tray *restrict t, int rows, double h, double *restrict impulse, double *restrict kept,
                 double *restrict time)
{
    for (int c = 0; c < rows; c++)
    {
        impulse[3*c] += t->jx[c];
        impulse[3*c + 1] += t->jy[c];
        impulse[3*c + 2] += t->jz[c];
    }
    for (int c = 0; c < rows; c++)
    {
        kept[c] *= t->kept[c];
        time[c] += t->drag[c]*h;
    }
}

void dem_body_tray_book(const struct dem_body_tray *t, struct dem_particles *p, size_t first, int rows, double h)
{
    book(t, rows, h, dem_column(p, DEM_COLUMN_DRAG_IMPULSE) + 3*first, dem_column(p, DEM_COLUMN_KEPT) + first,
         dem_column(p, DEM_COLUMN_DRAG_TIME) + first);
}
