/*
 * shared.h -- structs and constants that host and device have in common.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "walls/pose.h"

enum
{
    DEM_DEVICE_GROUP = 64,      /* work items of a group */
    DEM_DEVICE_BATCH = 256,     /* steps between two looks of the host, at most */
    DEM_DEVICE_SUM = 72,        /* digits of an exact sum, and some */
    DEM_DEVICE_WAKE_DRAG = 9,   /* DEM_OWN_WAKE_DRAG */
    DEM_DEVICE_WAKE = 11,       /* numbers of an own wake (DEM_OWN_WAKE_WIDTH) */
    DEM_DEVICE_COPIES = 32,     /* of an exact sum, at most */
    DEM_DEVICE_WALL_SUMS = 7,   /* load and work of a wall */
    DEM_DEVICE_LAWS = 16,       /* DEM_EFFECT_LIST_LIMIT */
    DEM_DEVICE_MATERIALS = 32,  /* as DEM_MATERIALS */
    DEM_DEVICE_LEVELS = 8,      /* grids of cells, at most */
    DEM_DEVICE_NEAR = 16,       /* facets that one particle touches, at most */
    DEM_DEVICE_TRIANGLE_BITS = 23,    /* of a candidate; above them its image: three bits an axis */
    DEM_DEVICE_TRIANGLES = 1 << DEM_DEVICE_TRIANGLE_BITS,
    DEM_DEVICE_NO_IMAGE = 4 << 6 | 4 << 3 | 4
};

enum    /* columns of the exchange of a scalar, as enum dem_scalar_column */
{
    DEM_DEVICE_SOURCE, DEM_DEVICE_COEFFICIENT, DEM_DEVICE_TARGET, DEM_DEVICE_RECEIVED,
    DEM_DEVICE_TIME, DEM_DEVICE_TARGET_TIME, DEM_DEVICE_DECAY, DEM_DEVICE_CARRIED_OVER = 9
};

enum dem_device_event           /* what the host has to handle; it repeats the steps then */
{
    DEM_DEVICE_OVERLAP = 1,     /* above time/maxOverlap */
    DEM_DEVICE_NOT_FINITE = 2,  /* a force; or a scalar is out of its range */
    DEM_DEVICE_CROSSED = 4,     /* a wall with two sides */
    DEM_DEVICE_BROKE = 8,       /* a bond */
    DEM_DEVICE_FACETS = 16,     /* a particle touches too many facets */
    DEM_DEVICE_ABSORBED = 32    /* one touches a wall that absorbs it */
};

enum    /* of a contact row, in a byte */
{
    DEM_DEVICE_TOUCHES = 1,     /* it has a force and a history */
    DEM_DEVICE_RATED = 2        /* it has come apart in this step, and has rates of scalars */
};

/* a moving wall in a step. On the device the member `wall` of a facet is its frame, -1: at rest; and
   `largest` its wall times four, with these bits */
enum
{
    DEM_DEVICE_ABSORBS = 1,     /* it absorbs particles */
    DEM_DEVICE_DRIVEN = 2       /* its surface slides in itself */
};

struct dem_device_frame
{
    struct dem_pose pose;
    struct dem_wall_displacement displacement;
};

/* a triangle, in its wall's frame: -1 at rest; the rest as in struct dem_triangle */
struct dem_device_triangle
{
    double corner[3][3];                    /* m */
    int frame;
    uint32_t facet, rim, place;
};

/* periodic images of the triangles of a frame; walls at rest come first */
struct dem_device_images
{
    double period[3];                       /* m */
    int turns[3], triangles;                /*    dem_walls_turns; 1: there are triangles */
};

/* what a wall gives to a particle scalar: struct dem_wall_scalar; never, where end is -infinity */
struct dem_device_condition
{
    double value, flux, film, start, end;
    int given;
};

/* a force of the scene on chosen particles: struct dem_applied_force */
struct dem_device_applied
{
    double force[3], torque[3], from, until, min[3], max[3];    /* N, N m, s, s, m, m */
    int material, all;                      /*    all: not by ids */
    uint32_t first, end;                    /*    of its ids */
};

/* rounding of the drift along each axis, axes without motion, and the periodic box (dem_domain) */
struct dem_device_axes
{
    double round[3], min[3], length[3];
    int flat[3];
};

/* cells of the particles with at most this radius, and more than the next level's */
struct dem_device_level
{
    double radius, over_edge[3];            /* m, 1/m */
    int cells[3];
    uint32_t first;                         /*    its first cell; the levels share one list of cells */
};

/* new lists, and the lists that they replace */
struct dem_device_lists
{
    struct dem_device_level level[DEM_DEVICE_LEVELS];
    double origin[3];                       /* m  of the cells */
    double min[3], max[3], length[3], unit[3];    /* m  dem_domain */
    double gap;                             /* m  of pairs, at most */
    double grid_origin[3], grid_edge;       /* m  of the cells of triangles */
    int levels, periodic[3], grid_cells[3];
    int frames;                             /*    of walls */
    uint32_t walls;                         /*    the first row of a wall */
    uint32_t particles, all;                /*    owned ones; and ghosts */
    uint32_t facets, materials, columns;
    uint32_t stride, old_stride, old_walls; /*    rows; rows before, the first one of a wall */
    int renumbered;                         /* 1: particles have other places than in the lists before */
    int keep_all;                           /* 1: laws act past touching */
    int keep_frozen;                        /* 1: frozen particles have contacts, for scalars */
};

/* what the device tells after a batch of steps */
struct dem_device_report
{
    uint32_t events;                        /* enum dem_device_event, or-ed */
    uint32_t event_step;                    /* the first step of the batch with one */
    float overlap;                          /* 1  largest overlap over the smaller diameter */
    float fastest[DEM_DEVICE_BATCH];        /* m2/s2  square of the largest speed of each step,
                                               rounded up */
    float bound[DEM_DEVICE_BATCH];          /* m  bound of the displacement before each step */
};

/* constants of a batch of steps */
struct dem_device_batch
{
    double dt, inverse_dt, max_dt;          /* s, 1/s, s */
    double window_start;                    /* s  step k of the window ends at start + k dt */
    double window, over_window;             /* s, 1/s  the window's length; 0 without */
    int64_t first, first_of_all;            /*    k of the first step of the batch; of its advance */
    double overlap_limit;                   /* 1  of the smaller diameter: such an overlap ends the run */
    float overlap;                          /* 1  of the report, so far */
    float start;                            /* m  bound of the displacement now */
    float limit[DEM_DEVICE_BATCH];          /* m  up to which the lists are valid; never increases */
    uint32_t particles, stride;             /*    owned ones; stride: rows of a history column */
    uint32_t column;                        /*    particles of a column, with ghosts */
    uint32_t walls;                         /*    the first row of a wall */
    uint32_t frames;                        /*    of moving walls, for each step */
    uint32_t applied;                       /*    forces of the scene */
    uint32_t copies;                        /*    of each exact sum: a power of two */
    int loads, work;                        /* 1: sums of loads on walls; of the work of walls that move */
    int64_t number;                         /*    of the first step of the batch, in the run */
    uint32_t last;                          /*    the step that ends a window: half a kick, no drift */
};
