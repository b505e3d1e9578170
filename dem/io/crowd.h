/*
 * crowd.h -- particles of the start, before they are handed to the owners of their places: each rank has a share of them, and all
 * know the groups.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_CROWD_H
#define DEM_IO_CROWD_H

#include "state/particles.h"

struct dem_group                                          /* what one group of the text has become, for the plan */
{
    char name[48];
    int material;                                         /* -1: several */
    int64_t n;
    double least, most, sum;                              /* m  of the diameters */
    double volume, mass;                                  /* m3, kg */
};

static const double dem_crowd_far = 1e12;                 /* radii: places have 1e-4 of one there, as much as overlaps */

struct dem_crowd
{
    size_t n, room;
    struct dem_particle *particle;
    int64_t next_id;
    size_t groups, group_room;
    struct dem_group *group;
};

void dem_crowd_free(struct dem_crowd *);

/* A group of this name begins; count n equal spheres [m, kg] into it, those of all ranks on each. */
int dem_crowd_begin(struct dem_crowd *, const char *group);
void dem_crowd_count(struct dem_crowd *, int64_t n, double diameter, double mass, int material);

/* Add one; id < 0 takes the next free number. Refuses what is not a sphere. `where` starts messages. */
int dem_crowd_add(struct dem_crowd *, struct dem_particle, const char *where);

/* Give the particles back, when ranks have them; what is known of the groups stays. */
void dem_crowd_disperse(struct dem_crowd *);

#endif
