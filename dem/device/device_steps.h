/*
 * device_steps.h -- steps on a device, with the same bits as on the CPU.
 *
 * The host owns the state between advances. Within an advance it makes the steps that something reads: samples,
 * backups, the last one of a window. From a step on whose lists are valid the device makes the steps up to the next of
 * these: the state is copied to it, steps and new lists are made, the state is copied back (dem_device_advance).
 * Whatever reads the state finds it on the host, and files do not know of the device.
 *
 * After dem_device_keep the device makes the last step of a window, too, and contacts stay there (device_window.c).
 *
 * Events that the host has to report or to handle take the device back to the state before its last
 * batch of steps; the host makes the steps up to the event from there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

struct dem_device;

/* Why the steps of this run cannot be made on a device, as a sentence, or "". */
void dem_device_refusal(const struct dem_state *, char *why, size_t size);

/* Collective. Open the device (opencl_device.h: wanted), one for each rank of a machine where there are
   enough, build the program, and compare its bits with the CPU's if
   this program has not been tested with this driver. An error is a sentence; the state is unchanged
   then. */
int dem_device_begin(struct dem_state *, const char *wanted);
void dem_device_free(struct dem_state *);

/* Device and driver. */
const char *dem_device_name(const struct dem_device *);

/* Memory that these particles need as a dense bed [byte]. */
double dem_device_memory(const struct dem_state *);

/* The skins of the next lists, for particles of up to this speed [m/s]. */
void dem_device_set_skins(struct dem_state *, double speed);

/* How much further [m] ghosts and triangles are held, for lists that the device makes. */
double dem_device_ghost_reach(const struct dem_state *);

/* 1: the host has to make this step, up to an event or some steps after it. */
int dem_device_waits(const struct dem_state *);

/* Rows of a class of contacts in its present lists. */
int64_t dem_device_rows_of(const struct dem_device *, int class);

struct dem_device_counts
{
    int64_t steps, parts;     /* made on the device, in so many parts between copies of the state */
    int64_t lists;            /* neighbor lists made on the device */
    int64_t repeated;         /* given up by the device, for an event that the host handles */
};
void dem_device_count(const struct dem_device *, struct dem_device_counts *);

struct dem_device_steps
{
    int64_t first, most;      /* number of the first step in the window; so many steps, at most */
    int64_t last;             /* the last step of the window, if the device makes it and keeps the contacts; else 0 */
    /* m  of a particle, from its position now, up to which the host's lists are valid, with the walls
       where they are */
    double (*rest)(const struct dem_state *);
    double max_displacement;  /* m  of a wall in a step, above which the host makes it */
    double max_speed;         /* m/s  of a particle, above which the host makes the step */
    /* particles may enter or leave in steps whose number in the run is a multiple of this; 0: never.
       Then the first function is called, collective, with the records of the step on the host. If particles
       do, the host makes this step (end), or the second function is called, with all that belongs to them;
       particles that stay keep their order, and new ones follow. */
    int64_t check;
    int (*enter_or_leave)(struct dem_state *, int *changes, int *end);
    int (*change)(struct dem_state *);
    /* called before each batch of steps, by all ranks; end: 1 to end here */
    int (*ends)(struct dem_state *, int64_t made, int *end);
    int64_t made;             /* result: 0: the host has to make the first one */
    int lists;                /* result: 1: lists were made; ghosts and marks of walls are theirs, not the host's */
    const double *speed;      /* m/s  largest of each drift, one for each step made; rounded up */
};

/* Collective. Make steps. Before the call positions have been drifted and lists are valid for the first step; after
   it positions have been drifted for the step that follows the last one made, unless that has ended the window. */
int dem_device_advance(struct dem_state *, struct dem_device_steps *);

/* ---- contacts that stay on the device between windows (state->contacts_on_device) ---------------- */

/* From now on they may; walls have sums of impulses then. */
int dem_device_keep(struct dem_state *);

/* 1 when the device can make the last step of this window, and keep its contacts. */
int dem_device_makes_last_step(const struct dem_state *);

/* The forces of the last step on walls, times the kick [s], to the sums of each wall; as the saved ones of
   records/wall_statistics.h. */
int dem_device_kick_walls(struct dem_state *, double kick);
int dem_device_save_wall_forces(struct dem_state *);

/* Collective. The history of contacts to the host, which makes new lists in its next step; nothing if it is there.
   between: 1: between two windows; the next half kick needs wall forces, which are saved. */
int dem_device_return_contacts(struct dem_state *, int between);

/* Copy the contacts for a backup, if they are on the device; give them to the host when the backup is restored. */
int dem_device_backup(struct dem_state *);
int dem_device_restore(struct dem_state *);
