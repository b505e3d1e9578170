/*
 * stream.h -- particles that come in and go out while a run goes on, as the scene words it.
 *
 *     insert  { feed { type stream; rate 1000; | massRate 0.01; material; diameter; | sizes { } velocity; spread; spin; start; end;
 *                      count; mass; seed; and a mouth (mouth.h) } }
 *     outlets { drain { min; max; | cylinder { } | sphere { } | point; normal; | patch NAME; } }
 *
 * A stream owes rate (t - start) particles at time t, or massRate (t - start) kilograms: the next comes when all of it is owed. Number k of
 * a stream has the diameter, velocity and spin that (seed, k) gives, whenever it finds room, so that waiting changes no distribution.
 *
 * Not here: finding room and keeping account (step/flows.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_STREAM_H
#define DEM_IO_STREAM_H

#include "io/mouth.h"
#include "io/sizes.h"
#include "io/snapshot.h"
#include "state/recipe.h"

enum
{
    DEM_FLOW_NAME = sizeof((struct dem_snapshot_flow *)0)->name
};

struct dem_stream
{
    char name[DEM_FLOW_NAME];
    char where[256];                                      /* starts messages */
    int material, by_mass;                                /* 1: kilograms are owed, 0: particles */
    struct dem_sizes sizes;
    struct dem_mouth mouth;
    int64_t seed, count;                                  /* count: no more than so many */
    double rate, mass;                                    /* 1/s or kg/s; no more than so much, kg */
    double start, end;                                    /* s */
    double velocity[3], spread[3], spin[3];               /* m/s, 1/s; velocities are even in velocity +- spread */
    int with_fluid;                                       /* 1: the velocity is the fluid's at the patch, and `velocity` more */
};

struct dem_outlet
{
    char name[DEM_FLOW_NAME];
    int plane;                                            /* 1: beyond a plane, 0: in the vessel */
    struct dem_vessel vessel;                             /* of a plane: its point and normal in from and axis */
    const char *patch;                                    /* NULL: of no mesh */
};

struct dem_streams
{
    int streams, outlets;
    size_t stream_room, outlet_room;
    struct dem_stream *stream;
    struct dem_outlet *outlet;
    int meshed;                                           /* 1: a program with a mesh looks at patches */
};

/* 1 when a group of `insert` is a stream. */
int dem_stream_is(const struct dem_dict *group);

/* Those of `insert` and of `outlets`, each of which may be NULL. The dictionaries must outlive them. */
int dem_streams_read(struct dem_streams *, const struct dem_dict *insert, const struct dem_dict *outlets, const struct dem_recipe *);
void dem_streams_free(struct dem_streams *);

/* Least and most radius [m] that will come, by material; those of none stay. */
void dem_streams_radii(const struct dem_streams *, double *least, double *most);

/* Refuse what lies outside the domain, and patches that no mesh has handed in. */
int dem_streams_inside(const struct dem_streams *, const struct dem_domain *);

/* What is owed at a time [s], particles or kg, since `since`. */
double dem_stream_owes(const struct dem_stream *, double since, double time);

/* Diameter [m] and mass [kg] of number k, and the mean mass. */
double dem_stream_diameter(const struct dem_stream *, int64_t k);
double dem_stream_mean_mass(const struct dem_stream *, const struct dem_recipe *);

/* The `trial`-th place for number k when so many steps have been made, and its velocity and spin there. `ago` [s]: since the last look, when
   it may have come through a face. 0: this trial gives none. */
struct dem_stream_trial
{
    int64_t number, step, trial;
    double radius, ago;                                   /* m, s */
};
int dem_stream_place(const struct dem_stream *, const struct dem_stream_trial *, double x[3], double v[3]);

/* How far [m] beyond its mouth a particle of this radius may be after `ago` seconds, at most. */
double dem_stream_way(const struct dem_stream *, double ago, double radius);

/* 1 when a point is where the outlet takes particles out. */
int dem_outlet_holds(const struct dem_outlet *, const double x[3]);

#endif
