/*
 * device_columns.c -- columns of particles on the device: a fluid's, orientations, scalars; one after the other in one
 * memory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/device_columns.h"
#include "core/error.h"
#include "dem_types.h"
#include "device/shared.h"

_Static_assert((int)DEM_DEVICE_WAKE == (int)DEM_OWN_WAKE_WIDTH &&
                   (int)DEM_DEVICE_WAKE_DRAG == (int)DEM_OWN_WAKE_DRAG,
               "fluid.cl reads the column own_wake");

/* Columns that the kernel of particles reads; in `changes` steps add to them. */
static const struct
{
    enum dem_column_name column;
    const char *name;
    int changes;
} list[] = {
    {DEM_COLUMN_FLUID_VELOCITY, "FLUID_VELOCITY", 0},
    {DEM_COLUMN_PRESSURE_GRADIENT, "PRESSURE_GRADIENT", 0},
    {DEM_COLUMN_VOID_FRACTION, "VOID_FRACTION", 0},
    {DEM_COLUMN_FLUID_DENSITY, "FLUID_DENSITY", 0},
    {DEM_COLUMN_FLUID_ACCELERATION, "FLUID_ACCELERATION", 0},
    {DEM_COLUMN_VORTICITY, "VORTICITY", 0},
    {DEM_COLUMN_STRESS, "STRESS", 0},
    {DEM_COLUMN_TENSION, "TENSION", 0},
    {DEM_COLUMN_INTERFACE_DISTANCE, "INTERFACE_DISTANCE", 0},
    {DEM_COLUMN_MEAN_DIAMETER, "MEAN_DIAMETER", 0},
    {DEM_COLUMN_ADDED_MASS, "ADDED_MASS", 0},
    {DEM_COLUMN_VOIDAGE_FACTOR_FIRST, "VOIDAGE_FACTOR_FIRST", 0},
    {DEM_COLUMN_VOIDAGE_FACTOR_SECOND, "VOIDAGE_FACTOR_SECOND", 0},
    {DEM_COLUMN_SLIP_FACTOR, "SLIP_FACTOR", 0},
    {DEM_COLUMN_START_VELOCITY, "START_VELOCITY", 0},
    {DEM_COLUMN_CARRIED_OVER_IMPULSE, "CARRIED_OVER_IMPULSE", 0},
    {DEM_COLUMN_DRAG_IMPULSE, "DRAG_IMPULSE", 1},
    {DEM_COLUMN_DECAY_FACTOR, "DECAY_FACTOR", 1},
    {DEM_COLUMN_DRAG_INTEGRAL, "DRAG_INTEGRAL", 1},
    {DEM_COLUMN_OTHER_IMPULSE, "OTHER_IMPULSE", 1},
    {DEM_COLUMN_ANGULAR_IMPULSE, "ANGULAR_IMPULSE", 1},
    {DEM_COLUMN_OWN_WAKE, "OWN_WAKE", 0},
    {DEM_COLUMN_TURBULENCE, "TURBULENCE", 0},
    {DEM_COLUMN_EDDY, "EDDY", 1},
    {DEM_COLUMN_ORIENTATION, "ORIENTATION", 1},
};

enum
{
    NAMED = (int)(sizeof list/sizeof *list),
    COLUMNS = NAMED + DEM_FURTHER_COLUMNS    /* columns of scalars follow */
};

struct column
{
    const char *name;
    const struct dem_column *of;    /* NULL: these particles have none */
    int changes;
};

static struct column column_at(const struct dem_particles *p, int k)
{
    const struct dem_column *const of =
        &p->column[k < NAMED ? (int)list[k].column : DEM_COLUMNS + k - NAMED];

    return (struct column){.name = k < NAMED ? list[k].name : NULL,
                           .of = of->data ? of : NULL,
                           .changes = k < NAMED ? list[k].changes : 1};
}

int dem_device_columns_text(const struct dem_particles *p, struct dem_text *text)
{
    size_t before = 0;

    for (int k = 0; k < COLUMNS; k++)
    {
        const struct column c = column_at(p, k);

        if (c.of && c.name)
        {
            dem_text_add(text, "#define COLUMN_%s %zu\n", c.name, before);
        }
        else if (c.of)
        {
            dem_text_add(text, "#define COLUMN_FURTHER_%d %zu\n", k - NAMED, before);
        }
        before += c.of ? (size_t)c.of->width : 0;
    }
    dem_text_add(text, "#define GHOST_COLUMNS %d\nconstant uint dem_ghost_column[] = {0", p->ghost_step.n);
    for (int k = 0; k < p->ghost_step.n; k++)
    {
        dem_text_add(text, ", COLUMN_FURTHER_%d", p->ghost_step.column[k] - DEM_COLUMNS);
    }
    dem_text_add(text, "};\n");
    if (p->batch.n == 1)
    {
        dem_text_add(text, "#define COLUMN_VISCOSITY COLUMN_FURTHER_%d\n",
                     p->batch.at[0].column - DEM_COLUMNS);
    }
    return dem_column(p, DEM_COLUMN_FLUID_VELOCITY) != NULL;
}

size_t dem_device_columns_width(const struct dem_particles *p)
{
    size_t width = 0;

    for (int k = 0; k < COLUMNS; k++)
    {
        const struct column c = column_at(p, k);

        width += c.of ? (size_t)c.of->width : 0;
    }
    return width;
}

/* Each column with its ghosts, or those that change without, one way or the other. */
static int copy(struct dem_opencl *cl, const struct dem_opencl_memory *m,
                const struct dem_particles *p, int back)
{
    size_t before = 0;

    for (int k = 0; k < COLUMNS; k++)
    {
        const struct column c = column_at(p, k);
        const size_t one = c.of ? (size_t)c.of->width*sizeof(double) : 0, all = (p->n + p->ghosts)*one;

        if (c.of && !back)
        {
            DEM_TRY(dem_opencl_write(cl, m, before, all, c.of->data));
        }
        if (c.of && back && c.changes)
        {
            DEM_TRY(dem_opencl_read(cl, m, before, p->n*one, c.of->data));
        }
        before += all;
    }
    return DEM_OK;
}

int dem_device_put_columns(struct dem_opencl *cl, const struct dem_opencl_memory *m,
                           const struct dem_particles *p)
{
    return copy(cl, m, p, 0);
}

int dem_device_get_columns(struct dem_opencl *cl, const struct dem_opencl_memory *m,
                           const struct dem_particles *p)
{
    return copy(cl, m, p, 1);
}
