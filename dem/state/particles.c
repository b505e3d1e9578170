/*
 * particles.c -- grow, reorder, pack and append: everything a store of records and columns must be able to do.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "state/particles.h"
#include "base/error.h"
#include "base/memory.h"
#include <string.h>

static const struct dem_column columns[DEM_COLUMNS] =
{
    [DEM_COLUMN_FORCE] = {"force", 3, 0, NULL},
    [DEM_COLUMN_TORQUE] = {"torque", 3, 0, NULL},
    [DEM_COLUMN_FLUID_VELOCITY] = {"fluidVelocity", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_PRESSURE_GRADIENT] = {"pressureGradient", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_VOID_FRACTION] = {"voidFraction", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_FLUID_DENSITY] = {"fluidDensity", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_FLUID_VISCOSITY] = {"fluidViscosity", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_FLUID_ACCELERATION] = {"fluidAcceleration", 3, DEM_GROUP_FLUID | DEM_GROUP_ACCELERATION, NULL},
    [DEM_COLUMN_VORTICITY] = {"fluidVorticity", 3, DEM_GROUP_FLUID | DEM_GROUP_VORTICITY, NULL},
    [DEM_COLUMN_STRESS] = {"fluidStress", 3, DEM_GROUP_FLUID | DEM_GROUP_STRESS, NULL},
    [DEM_COLUMN_MEAN_DIAMETER] = {"meanDiameter", 1, DEM_GROUP_FLUID | DEM_GROUP_MEAN_DIAMETER, NULL},
    [DEM_COLUMN_COUNTERFLOW] = {"counterflow", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_PLACE] = {"place", 2, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_DRAG_IMPULSE] = {"dragImpulse", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_KEPT] = {"kept", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_DRAG_TIME] = {"dragTime", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_START_VELOCITY] = {"startVelocity", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_WAY] = {"way", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_RESPONSE] = {"response", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_PASSED] = {"passed", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_PENDING] = {"pending", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_SWARM_FIRST] = {"swarmFirst", 1, DEM_GROUP_FLUID | DEM_GROUP_SWARM, NULL},
    [DEM_COLUMN_SWARM_SECOND] = {"swarmSecond", 1, DEM_GROUP_FLUID | DEM_GROUP_SWARM, NULL},
    [DEM_COLUMN_ADDED_MASS] = {"addedMass", 1, DEM_GROUP_FLUID | DEM_GROUP_ADDED, NULL},
    [DEM_COLUMN_FLUID_CHANGE] = {"fluidChange", 3, DEM_GROUP_FLUID | DEM_GROUP_ADDED, NULL},
    [DEM_COLUMN_FORESEEN] = {"foreseen", 3, DEM_GROUP_FLUID | DEM_GROUP_ADDED, NULL},
    [DEM_COLUMN_OTHER_IMPULSE] = {"otherImpulse", 3, DEM_GROUP_FLUID | DEM_GROUP_REACTS, NULL},
    [DEM_COLUMN_TURN_IMPULSE] = {"turnImpulse", 3, DEM_GROUP_FLUID | DEM_GROUP_TURNS, NULL},
    [DEM_COLUMN_LOST] = {"lostEnergy", 1, DEM_GROUP_BOOKS, NULL},
    [DEM_COLUMN_BROKEN] = {"brokenBonds", 1, DEM_GROUP_BOOKS, NULL},
    [DEM_COLUMN_ORIENTATION] = {"orientation", 4, DEM_GROUP_TURNED, NULL},
};

enum
{
    RECORD_DOUBLES = (int)(sizeof(struct dem_particle)/sizeof(double)),
    WIDEST_COLUMN = 4
};

struct spare                                              /* room for one particle, aside */
{
    struct dem_particle record;
    double column[WIDEST_COLUMN*DEM_COLUMNS];
};

static int used(const struct dem_particles *p, int c)
{
    return (columns[c].group & ~p->groups) == 0;
}

void dem_particles_init(struct dem_particles *p, unsigned groups)
{
    memset(p, 0, sizeof *p);
    p->groups = groups;
    memcpy(p->column, columns, sizeof columns);
}

void dem_particles_free(struct dem_particles *p)
{
    for (int c = 0; c < DEM_COLUMNS; c++)
    {
        dem_memory_free(p->column[c].data);
    }
    dem_memory_free(p->record);
    memset(p, 0, sizeof *p);
}

int dem_particles_grow(struct dem_particles *p, size_t count)
{
    const size_t room = dem_memory_room(p->room, count);

    if (room == p->room && p->record)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_RESIZE(p->record, p->room, room));
    for (int c = 0; c < DEM_COLUMNS; c++)
    {
        const size_t width = (size_t)p->column[c].width;

        if (used(p, c))
        {
            DEM_TRY(DEM_RESIZE(p->column[c].data, p->room*width, room*width));
        }
    }
    p->room = room;
    return DEM_OK;
}

int dem_particles_copy(struct dem_particles *p, const struct dem_particles *from)
{
    const size_t room = dem_memory_room(p->room, from->n);

    DEM_TRY(DEM_RESIZE(p->record, p->room, room));
    memcpy(p->record, from->record, from->n*sizeof *p->record);
    for (int c = 0; c < DEM_COLUMNS; c++)
    {
        struct dem_column *const to = &p->column[c];
        const size_t width = (size_t)from->column[c].width;

        if (from->column[c].data)
        {
            double *const data = to->data;

            *to = from->column[c];
            to->data = data;
            DEM_TRY(DEM_RESIZE(to->data, p->room*width, room*width));
            memcpy(to->data, from->column[c].data, from->n*width*sizeof *to->data);
        }
    }
    p->room = room;
    p->n = from->n;
    p->ghosts = 0;
    return DEM_OK;
}

/* One particle, record and columns: from `from` to `to`, each the place of a particle or -1 for the spare one. */
static void move(struct dem_particles *p, struct spare *spare, ptrdiff_t from, ptrdiff_t to)
{
    const double *at = spare->column;

    *(to < 0 ? &spare->record : &p->record[to]) = from < 0 ? spare->record : p->record[from];
    for (int c = 0; c < DEM_COLUMNS; c++)
    {
        const size_t width = (size_t)p->column[c].width;
        double *const data = p->column[c].data;

        if (data)
        {
            double *const held = spare->column + (at - spare->column);

            memcpy(to < 0 ? held : data + (size_t)to*width, from < 0 ? held : data + (size_t)from*width, width*sizeof *data);
            at += width;
        }
    }
}

/* Those that stay close up; none overtakes another. */
static void close_up(struct dem_particles *p, const uint32_t *order, size_t count)
{
    struct spare spare;

    for (size_t k = 0; k < count; k++)
    {
        if (order[k] != k)
        {
            move(p, &spare, (ptrdiff_t)order[k], (ptrdiff_t)k);
        }
    }
}

/* Cycle by cycle, each with one particle aside; done ones are marked as being where they belong. */
static void permute(struct dem_particles *p, uint32_t *order, size_t count)
{
    struct spare spare;

    for (size_t k = 0; k < count; k++)
    {
        size_t to = k;

        if (order[k] == k)
        {
            continue;
        }
        move(p, &spare, (ptrdiff_t)k, -1);
        while (order[to] != k)
        {
            const size_t from = order[to];

            move(p, &spare, (ptrdiff_t)from, (ptrdiff_t)to);
            order[to] = (uint32_t)to;
            to = from;
        }
        move(p, &spare, -1, (ptrdiff_t)to);
        order[to] = (uint32_t)to;
    }
}

void dem_particles_reorder(struct dem_particles *p, uint32_t *order, size_t count)
{
    if (count < p->n)
    {
        close_up(p, order, count);
    }
    else
    {
        permute(p, order, count);
    }
    p->n = count;
    p->ghosts = 0;
}

size_t dem_particles_each(const struct dem_particles *p)
{
    size_t each = sizeof *p->record;

    for (int c = 0; c < DEM_COLUMNS; c++)
    {
        each += used(p, c) ? (size_t)p->column[c].width*sizeof *p->column[c].data : 0;
    }
    return each;
}

size_t dem_particles_bytes(const struct dem_particles *p)
{
    return p->room*dem_particles_each(p);
}

size_t dem_particles_packed_size(const struct dem_particles *p)
{
    size_t size = RECORD_DOUBLES;

    for (int c = 0; c < DEM_COLUMNS; c++)
    {
        size += used(p, c) ? (size_t)p->column[c].width : 0;
    }
    return size;
}

void dem_particles_pack(const struct dem_particles *p, size_t particle, double *out)
{
    memcpy(out, &p->record[particle], sizeof *p->record);
    out += RECORD_DOUBLES;
    for (int c = 0; c < DEM_COLUMNS; c++)
    {
        const size_t width = (size_t)p->column[c].width;

        if (p->column[c].data)
        {
            memcpy(out, p->column[c].data + particle*width, width*sizeof *out);
            out += width;
        }
    }
}

int dem_particles_append(struct dem_particles *p, const double *packed)
{
    const size_t place = p->n;

    DEM_TRY(dem_particles_grow(p, place + 1));
    memcpy(&p->record[place], packed, sizeof *p->record);
    packed += RECORD_DOUBLES;
    for (int c = 0; c < DEM_COLUMNS; c++)
    {
        const size_t width = (size_t)p->column[c].width;

        if (p->column[c].data)
        {
            memcpy(p->column[c].data + place*width, packed, width*sizeof *packed);
            packed += width;
        }
    }
    p->n = place + 1;
    p->ghosts = 0;
    return DEM_OK;
}

int dem_particles_add(struct dem_particles *p, const struct dem_particle *record)
{
    const size_t place = p->n;

    DEM_TRY(dem_particles_grow(p, place + 1));
    p->record[place] = *record;
    for (int c = 0; c < DEM_COLUMNS; c++)
    {
        const size_t width = (size_t)p->column[c].width;

        if (p->column[c].data)
        {
            memset(p->column[c].data + place*width, 0, width*sizeof(double));
        }
    }
    p->n = place + 1;
    p->ghosts = 0;
    return DEM_OK;
}

struct dem_particle dem_particle_sphere(int64_t id, const double x[3], double diameter, double density, int material)
{
    struct dem_particle p = {.radius = 0.5*diameter, .id = id, .material = (uint16_t)material};

    memcpy(p.x, x, sizeof p.x);
    p.mass = density*dem_particle_volume(&p);
    p.inverse_mass = 1.0/p.mass;
    p.inverse_inertia = 1.0/(0.4*p.mass*p.radius*p.radius);
    return p;
}
