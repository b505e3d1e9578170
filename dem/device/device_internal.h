/*
 * device_internal.h -- what is on the device: for device.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_DEVICE_DEVICE_INTERNAL_H
#define DEM_DEVICE_DEVICE_INTERNAL_H

#include "device/device.h"
#include "device/opencl.h"
#include "device/shared.h"
#include "laws/interaction_table.h"

enum
{
    DEM_DEVICE_CLASSES = DEM_PARTNERS*DEM_MATERIALS*DEM_MATERIALS
};

struct dem_device
{
    struct dem_opencl *cl;
    char name[400];
    struct dem_opencl_kernel *rows[DEM_DEVICE_CLASSES];    /* one per pair class; NULL: no laws */
    struct dem_opencl_kernel *bodies, *clear;

    /* constants, a batch of steps and its report */
    struct dem_opencl_memory axes, shift, batch, report;
    /* lists: partners of rows, rows of particles, facets of walls */
    struct dem_opencl_memory partners, start, entry, facets;
    /* particles: records, lost energy; rows: whether they touch, history, results */
    struct dem_opencl_memory record, lost, touch, history, force, moment, energy;

    int64_t lists;                      /* rebuilds and prunes of the lists that are there */
    int64_t host_until;                 /* up to this step the host makes the steps */
    double min_skin, max_skin;          /* m */
    struct dem_device_counts counts;
    double last_speed;                  /* m/s  largest of the last drift */
    struct dem_device_report seen;
    double *speed;
    uint32_t *word;                     /* scratch */
    size_t speeds, words;
};

#endif
