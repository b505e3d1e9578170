/*
 * particles.c -- grows, copies, reorders and packs the records and columns of particles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/particles.h"
#include "core/error.h"
#include "core/memory.h"
#include <string.h>

static const struct dem_column columns[DEM_COLUMNS] = {
    [DEM_COLUMN_FORCE] = {"force", 3, 0, NULL},
    [DEM_COLUMN_TORQUE] = {"torque", 3, 0, NULL},
    [DEM_COLUMN_FLUID_VELOCITY] = {"fluidVelocity", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_PRESSURE_GRADIENT] = {"pressureGradient", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_VOID_FRACTION] = {"voidFraction", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_FLUID_DENSITY] = {"fluidDensity", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_FLUID_ACCELERATION] = {"fluidAcceleration", 3,
                                       DEM_GROUP_FLUID | DEM_GROUP_ACCELERATION, NULL},
    [DEM_COLUMN_VORTICITY] = {"fluidVorticity", 3, DEM_GROUP_FLUID | DEM_GROUP_VORTICITY, NULL},
    [DEM_COLUMN_STRESS] = {"fluidStress", 3, DEM_GROUP_FLUID | DEM_GROUP_STRESS, NULL},
    [DEM_COLUMN_TENSION] = {"tension", 3, DEM_GROUP_FLUID | DEM_GROUP_INTERFACE, NULL},
    [DEM_COLUMN_INTERFACE_DISTANCE] = {"interfaceDistance", 1, DEM_GROUP_FLUID | DEM_GROUP_INTERFACE, NULL},
    [DEM_COLUMN_MEAN_DIAMETER] = {"meanDiameter", 1, DEM_GROUP_FLUID | DEM_GROUP_MEAN_DIAMETER,
                                  NULL},
    [DEM_COLUMN_TURBULENCE] = {"fluidTurbulence", 2, DEM_GROUP_FLUID | DEM_GROUP_TURBULENCE, NULL},
    [DEM_COLUMN_EDDY] = {"eddy", 4, DEM_GROUP_FLUID | DEM_GROUP_TURBULENCE, NULL},
    [DEM_COLUMN_SLIP_FACTOR] = {"slipFactor", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_COUPLING_INDEX] = {"couplingIndex", 2, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_DRAG_IMPULSE] = {"dragImpulse", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_DECAY_FACTOR] = {"decayFactor", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_DRAG_INTEGRAL] = {"dragIntegral", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_START_VELOCITY] = {"startVelocity", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_DISPLACEMENT] = {"displacement", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_RESPONSE] = {"response", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_TRANSMITTED_FRACTION] = {"transmittedFraction", 1, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_CARRIED_OVER_IMPULSE] = {"carriedOverImpulse", 3, DEM_GROUP_FLUID, NULL},
    [DEM_COLUMN_UNDER_RELAXATION] = {"underRelaxation", 1,
                                     DEM_GROUP_FLUID | DEM_GROUP_UNDER_RELAXATION, NULL},
    [DEM_COLUMN_OWED_PRESSURE_IMPULSE] = {"owedPressureImpulse", 3,
                                          DEM_GROUP_FLUID | DEM_GROUP_UNDER_RELAXATION, NULL},
    [DEM_COLUMN_OWN_WAKE] = {"ownWake", DEM_OWN_WAKE_WIDTH, DEM_GROUP_FLUID | DEM_GROUP_OWN_WAKE, NULL},
    [DEM_COLUMN_VOIDAGE_FACTOR_FIRST] = {"voidageFactorFirst", 1,
                                         DEM_GROUP_FLUID | DEM_GROUP_VOIDAGE_FACTOR, NULL},
    [DEM_COLUMN_VOIDAGE_FACTOR_SECOND] = {"voidageFactorSecond", 1,
                                          DEM_GROUP_FLUID | DEM_GROUP_VOIDAGE_FACTOR, NULL},
    [DEM_COLUMN_ADDED_MASS] = {"addedMass", 1, DEM_GROUP_FLUID | DEM_GROUP_ADDED_MASS, NULL},
    [DEM_COLUMN_FLUID_CHANGE] = {"fluidChange", 3, DEM_GROUP_FLUID | DEM_GROUP_ADDED_MASS, NULL},
    [DEM_COLUMN_PREDICTED_ADDED_IMPULSE] = {"predictedAddedImpulse", 3,
                                            DEM_GROUP_FLUID | DEM_GROUP_ADDED_MASS, NULL},
    [DEM_COLUMN_OTHER_IMPULSE] = {"otherImpulse", 3, DEM_GROUP_FLUID | DEM_GROUP_REACTION, NULL},
    [DEM_COLUMN_ANGULAR_IMPULSE] = {"angularImpulse", 3,
                                    DEM_GROUP_FLUID | DEM_GROUP_ROTATIONAL_DRAG, NULL},
    [DEM_COLUMN_LOST_ENERGY] = {"lostEnergy", 1, DEM_GROUP_PAIR_ENERGY, NULL},
    [DEM_COLUMN_BROKEN_BONDS] = {"brokenBonds", 1, DEM_GROUP_PAIR_ENERGY, NULL},
    [DEM_COLUMN_ORIENTATION] = {"orientation", 4, DEM_GROUP_ORIENTATION, NULL},
    [DEM_COLUMN_CHECKED_POSITION] = {"checkedPosition", 4, DEM_GROUP_OUTLETS, NULL},
    [DEM_COLUMN_BIRTH] = {"birth", 1, DEM_GROUP_BIRTH, NULL},
    [DEM_COLUMN_CLUMP] = {"clump", DEM_CLUMP_WIDTH, DEM_GROUP_CLUMP, NULL},
};

enum
{
    RECORD_DOUBLES = (int)(sizeof(struct dem_particle)/sizeof(double)),
    WIDEST_COLUMN = DEM_CLUMP_WIDTH
};

struct spare                                              /* temporary copy of one particle */
{
    struct dem_particle record;
    double column[WIDEST_COLUMN*DEM_COLUMNS + DEM_FURTHER_COLUMNS];
};

static int is_used(const struct dem_particles *p, int c)
{
    return (p->column[c].group & ~p->groups) == 0;
}

void dem_particles_init(struct dem_particles *p, unsigned groups)
{
    memset(p, 0, sizeof *p);
    p->groups = groups;
    p->columns = DEM_COLUMNS;
    memcpy(p->column, columns, sizeof columns);
}

int dem_particles_add_column(struct dem_particles *p, const char *name)
{
    p->column[p->columns] = (struct dem_column){name, 1, 0, NULL};
    return p->columns++;
}

void dem_particles_add_columns_of(struct dem_particles *p, const struct dem_particles *from)
{
    while (p->columns < from->columns)
    {
        (void)dem_particles_add_column(p, from->column[p->columns].name);
    }
    p->ghost_step = from->ghost_step;
    p->ghost_window = from->ghost_window;
}

void dem_particles_free(struct dem_particles *p)
{
    for (int c = 0; c < p->columns; c++)
    {
        dem_memory_free(p->column[c].data);
    }
    dem_memory_free(p->record);
    memset(p, 0, sizeof *p);
}

int dem_particles_grow(struct dem_particles *p, size_t count)
{
    const size_t capacity = dem_memory_capacity(p->capacity, count);

    if (capacity == p->capacity && p->record)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_RESIZE(p->record, p->capacity, capacity));
    for (int c = 0; c < p->columns; c++)
    {
        const size_t width = (size_t)p->column[c].width;

        if (is_used(p, c))
        {
            DEM_TRY(DEM_RESIZE(p->column[c].data, p->capacity*width, capacity*width));
        }
    }
    p->capacity = capacity;
    return DEM_OK;
}

int dem_particles_copy(struct dem_particles *p, const struct dem_particles *from)
{
    const size_t capacity = dem_memory_capacity(p->capacity, from->n);

    DEM_TRY(DEM_RESIZE(p->record, p->capacity, capacity));
    memcpy(p->record, from->record, from->n*sizeof *p->record);
    p->columns = from->columns;
    p->batch = from->batch;
    for (int c = 0; c < p->columns; c++)
    {
        struct dem_column *const to = &p->column[c];
        const size_t width = (size_t)from->column[c].width;

        if (from->column[c].data)
        {
            double *const data = to->data;

            *to = from->column[c];
            to->data = data;
            DEM_TRY(DEM_RESIZE(to->data, p->capacity*width, capacity*width));
            memcpy(to->data, from->column[c].data, from->n*width*sizeof *to->data);
        }
    }
    p->capacity = capacity;
    p->n = from->n;
    p->ghosts = 0;
    return DEM_OK;
}

/* Move one particle, record and columns, from `from` to `to`: an index, or -1 for the temporary
   copy. */
static void move(struct dem_particles *p, struct spare *spare, ptrdiff_t from, ptrdiff_t to)
{
    const double *at = spare->column;

    *(to < 0 ? &spare->record : &p->record[to]) = from < 0 ? spare->record : p->record[from];
    for (int c = 0; c < p->columns; c++)
    {
        const size_t width = (size_t)p->column[c].width;
        double *const data = p->column[c].data;

        if (data)
        {
            double *const held = spare->column + (at - spare->column);

            memcpy(to < 0 ? held : data + (size_t)to*width,
                   from < 0 ? held : data + (size_t)from*width, width*sizeof *data);
            at += width;
        }
    }
}

/* Remove particles that are not in `order`; it is ascending, so no particle is overwritten before
   it moves. */
static void compact(struct dem_particles *p, const uint32_t *order, size_t count)
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

/* Permute cycle by cycle with one temporary copy; order[k] = k marks particles that are in
   place. */
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
        compact(p, order, count);
    }
    else
    {
        permute(p, order, count);
    }
    p->n = count;
    p->ghosts = 0;
}

size_t dem_particles_bytes_per_particle(const struct dem_particles *p)
{
    size_t each = sizeof *p->record;

    for (int c = 0; c < p->columns; c++)
    {
        each += is_used(p, c) ? (size_t)p->column[c].width*sizeof *p->column[c].data : 0;
    }
    return each;
}

size_t dem_particles_bytes(const struct dem_particles *p)
{
    return p->capacity*dem_particles_bytes_per_particle(p);
}

size_t dem_particles_packed_size(const struct dem_particles *p)
{
    size_t size = RECORD_DOUBLES;

    for (int c = 0; c < p->columns; c++)
    {
        size += is_used(p, c) ? (size_t)p->column[c].width : 0;
    }
    return size;
}

void dem_particles_pack(const struct dem_particles *p, size_t particle, double *out)
{
    memcpy(out, &p->record[particle], sizeof *p->record);
    out += RECORD_DOUBLES;
    for (int c = 0; c < p->columns; c++)
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
    const size_t index = p->n;

    DEM_TRY(dem_particles_grow(p, index + 1));
    memcpy(&p->record[index], packed, sizeof *p->record);
    packed += RECORD_DOUBLES;
    for (int c = 0; c < p->columns; c++)
    {
        const size_t width = (size_t)p->column[c].width;

        if (p->column[c].data)
        {
            memcpy(p->column[c].data + index*width, packed, width*sizeof *packed);
            packed += width;
        }
    }
    p->n = index + 1;
    p->ghosts = 0;
    return DEM_OK;
}

int dem_particles_add(struct dem_particles *p, const struct dem_particle *record)
{
    const size_t index = p->n;

    DEM_TRY(dem_particles_grow(p, index + 1));
    p->record[index] = *record;
    for (int c = 0; c < p->columns; c++)
    {
        const size_t width = (size_t)p->column[c].width;

        if (p->column[c].data)
        {
            memset(p->column[c].data + index*width, 0, width*sizeof(double));
        }
    }
    p->n = index + 1;
    p->ghosts = 0;
    return DEM_OK;
}

struct dem_particle dem_particle_sphere(int64_t id, const double x[3], double diameter,
                                        double density, int material)
{
    struct dem_particle p = {.radius = 0.5*diameter, .id = id, .material = (uint16_t)material};

    memcpy(p.x, x, sizeof p.x);
    p.mass = density*dem_particle_volume(&p);
    p.inverse_mass = 1.0/p.mass;
    p.inverse_inertia = 1.0/(0.4*p.mass*p.radius*p.radius);
    return p;
}
