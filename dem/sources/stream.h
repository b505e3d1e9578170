/*
 * stream.h -- streams that insert particles and outlets that remove them during a run, as the scene
 * defines them.
 *
 *     insert  { feed { type stream; rate 1000; | massRate 0.01; material; diameter; | sizes { }
 *                      velocity; spread; spin; start; end; count; mass; seed;
 *                      and an inlet (inlet_shape.h) }
 *               more { type random; at 0.5; count 1000; ... }
 *               ball { type list; at 0.5; positions ((0 0 0.1)); diameter; velocity; } }
 *     planes  { neck { point; normal; radius; } }
 *     outlets { drain { min; max; | cylinder { } | sphere { } | point; normal; | patch NAME; } }
 *
 * At time t a stream has rate (t - start) particles due, or massRate (t - start) kilograms; the
 * next particle is inserted when all of it is due. Number k of a stream has the diameter, velocity
 * and spin given by (seed, k), whenever it finds a free position, so that waiting changes no
 * distribution.
 *
 * A group of `insert` with a time `at` is a stream whose particles are all due then. Each has 200 random
 * positions in the region to try at a check, or its own one of a list; it waits while none is free.
 *
 * Not here: free positions and totals (sources/flows.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "sources/inlet_shape.h"
#include "sources/insert_clump.h"
#include "sources/size_distribution.h"
#include "records/snapshot.h"
#include "laws/interaction_table.h"
#include "particles/scalar_entry.h"

enum
{
    DEM_FLOW_NAME = sizeof((struct dem_snapshot_flow *)0)->name
};

struct dem_stream
{
    char name[DEM_FLOW_NAME];
    char where[256];                         /* starts messages */
    int material, by_mass;                   /* 1: mass rate, 0: particle rate */
    struct dem_clump_source clump;           /* with a shape: rigid bodies, and `sizes` has the
                                                diameter that holds them */
    struct dem_size_distribution sizes;
    struct dem_inlet_shape inlet;
    int64_t seed, count;                     /* count: limit of the number of particles */
    double rate, mass;                       /* 1/s or kg/s; limit of the mass, kg */
    double start, end;                       /* s  infinite before the stage of the scene begins, */
    int stage[2];                            /* from 1, that gives it; 0: none */
    int at_once;                             /* 1: a group with `at`: `rate` particles are due at start */
    const double (*positions)[3];            /* m  of a list, in the scene; NULL: trials in the inlet */
    double velocity[3], spread[3], spin[3];  /* m/s, 1/s; velocities are uniform
                                                in velocity +- spread */
    int with_fluid;                          /* 1: with the velocity of the fluid at the patch */
    struct dem_scalar_entry scalar[DEM_SCALARS];
    double ratio;                                /* 1  of its parcels; 1: none */
};

struct dem_outlet
{
    char name[DEM_FLOW_NAME];
    int plane;                          /* 1: beyond a plane, 0: inside a region */
    struct dem_insertion_shape shape;  /* region; of a plane its point and
                                           normal in `from` and `axis` */
    const char *patch;                  /* name of the patch; NULL: not a patch */
    int wall;                           /* 1: counts what walls with `absorb yes` take */
    double residence;                   /* s  end of the histogram of residence times; 0: none */
};

struct dem_flow_plane               /* counts what passes, and removes nothing */
{
    char name[DEM_FLOW_NAME];
    double point[3], normal[3];     /* m, unit */
    double radius;                  /* m  of a disc; infinite: the whole plane */
};

struct dem_streams
{
    int streams, outlets, planes;
    size_t stream_capacity, outlet_capacity, plane_capacity;
    struct dem_stream *stream;
    struct dem_outlet *outlet;
    const struct dem_clump_shapes *shapes;  /* of the scene, before streams are read */
    struct dem_flow_plane *plane;
    int meshed;  /* 1: a program with a mesh handles patches */
};

/* Read the streams of `insert` and the outlets of `outlets`, each of which may be NULL. The
   dictionaries must outlive the result. */
int dem_streams_read(struct dem_streams *, const struct dem_dict *insert,
                     const struct dem_dict *outlets, const struct dem_interaction_table *,
                     const struct dem_domain *);
/* Add the outlet that counts what walls of this entry of the scene absorb, unless it is there;
   *outlet: its index. */
int dem_streams_add_wall(struct dem_streams *, const char *name, int *outlet);
void dem_streams_free(struct dem_streams *);

/* Extend the smallest and the largest radius [m], by material, to the radii of the streams; 0 means
   none so far. Likewise the smallest volume of clumps for the limit of the time step [m3]. */
void dem_streams_radii(const struct dem_streams *, double *min, double *max, double *body);

/* Extend the range of ratios of parcels by the streams' ratios. */
void dem_streams_ratios(const struct dem_streams *, struct dem_interaction_table *);

/* Refuse inlets that lie outside the domain, and patches that no mesh has supplied. */
int dem_streams_check(const struct dem_streams *, const struct dem_domain *);

/* Amount due, particles or kg, between the times `since` and `time` [s]. */
double dem_stream_amount_due(const struct dem_stream *, double since, double time);

/* Diameter [m] and mass [kg] of particle number k, and the mean mass of a particle [kg]. */
double dem_stream_diameter(const struct dem_stream *, int64_t k);
double dem_stream_mass(const struct dem_stream *, const struct dem_interaction_table *, int64_t k);
double dem_stream_mean_mass(const struct dem_stream *, const struct dem_interaction_table *);

/* Position x and velocity v of a trial for particle `number` in step `step`. `ago` [s]: time since
   the last check, in which it may have entered through a face; `start` [m]: where it entered, or x
   in a region. Returns 0 when this trial gives no position. */
struct dem_stream_trial
{
    int64_t number, step, trial;
    double radius, ago;                                   /* m, s */
};
int dem_stream_draw_position(const struct dem_stream *, const struct dem_stream_trial *,
                             double x[3], double v[3], double start[3]);

/* Largest distance [m] from the inlet that a particle of this radius [m] may have after `ago`
   [s]. */
double dem_stream_max_travel(const struct dem_stream *, double ago, double radius);

/* 1 when the outlet contains the point x [m]. */
int dem_outlet_holds(const struct dem_outlet *, const double x[3]);

/* 1 when a part (insertion_shape.h) of a path meets the outlet and its region. An outlet behind a
   plane needs no path: a particle that was not there before ends there. */
int dem_outlet_meets(const struct dem_outlet *, const double from[3], const double step[3],
                     const double part[2]);

/* Read what a group with `at`, of this type, has instead of a rate and an inlet. */
int dem_stream_read_group(struct dem_stream *, const struct dem_dict *, const char *type,
                          const struct dem_interaction_table *, const struct dem_domain *);

/* Read the planes that count, after streams and outlets. */
int dem_streams_read_planes(struct dem_streams *, const struct dem_dict *planes);

/* 1 when a part of a path goes through the plane along its normal, -1 against it, else 0. */
int dem_flow_plane_crossed(const struct dem_flow_plane *, const double from[3], const double step[3],
                           const double part[2]);

/* 1 when any outlet asks for the residence time. */
int dem_streams_ask_residence(const struct dem_streams *);

/* 1 when any outlet is a region, which a fast particle may pass between two checks, or a plane counts. */
int dem_streams_have_regions(const struct dem_streams *);
