/*
 * stages.h -- stages of a run: each begins when the one before has ended, the first with the run.
 *
 *     stages
 *     {
 *         fill   { until quiet; atMost 2; }                   until the particles rest, 2 s at most
 *         settle { until { moving 0.02; lasting 0.05; } }     the same, with settings of untilQuiet
 *         press  { until { force lid; value 50; within 0.01; lasting 0.01; } }
 *         shear  { duration 1; }
 *     }
 *
 * Wherever a time stands in the scene, the name of a stage means its beginning: `start`, `end` of motions
 * and streams, `at` of groups, `from`, `until` of walls. Before that these times are infinite.
 * What can never end is refused (stages_check.c). run/stage_tests.c tests whether a stage has ended; here the entry
 * is read, times that a stage sets are handed on, and what a snapshot knows of them is written and read.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_types.h"

struct dem;
struct dem_dict;
struct dem_text;
struct dem_walls;

enum dem_until
{
    DEM_UNTIL_TIME,               /* never, or after a time alone */
    DEM_UNTIL_QUIET,
    DEM_UNTIL_LOAD
};

struct dem_run_stage
{
    char name[48];
    enum dem_until until;
    double duration, at_most;     /* s  infinite: not given */
    struct dem_quiet quiet;
    int wall_index;               /* of the wall whose load ends it */
    double load, within, lasting; /* N  of the wall; 1  0: that load or more; s */
    double direction[3];          /* unit; zero: the size of the force counts */
    double since;                 /* s  the load is there since; infinite: it is not */
    double begin;                 /* s  infinite: it has not begun */
    const char *why;              /* what has ended the stage before it */
};

struct dem_run_stages
{
    int n, present;
    size_t capacity;
    struct dem_run_stage *stage;
    double part;                  /* s  between tests of the present stage; 0: not chosen yet */
    double end;                   /* s  to which the present advance goes */
    double over;                  /* s  when the last stage has ended; infinite: it has not */
};

/* Read the entry. Walls have been read. */
int dem_scene_read_stages(struct dem_run_stages *, const struct dem_dict *scene, const struct dem_walls *);

/* What can be checked once effects and program are known (stages_check.c). */
int dem_stages_check(const struct dem *);

/* Stage k begins at `time` [s]: all times that name it become known. */
void dem_stages_begin(struct dem *, int k, double time, const char *why);

/* Find how long motions that a stage begins or ends last at most, dem_motion.longest: infinite where a stage
   between has until without atMost. A coupled stage may last one exchange longer. */
void dem_stages_limit_motions(struct dem *);

/* At the start: the first stage begins, or the stages go on from the snapshot of a restart. Then the walls
   that are there now. */
int dem_stages_start(struct dem *, int continues);

/* Lines with @ of the text of the scene in a snapshot: times of stages, and the state of the test. */
void dem_stages_describe(const struct dem_run_stages *, struct dem_text *);
