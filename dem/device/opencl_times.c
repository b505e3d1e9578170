/*
 * opencl_times.c -- the time that each kernel and each kind of copy takes on the device, as a table in
 * the file that SUNA_OPENCL_TIMES in the environment names, written when the device is closed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/opencl_calls.h"
#include "core/error.h"
#include "core/file.h"
#include "core/memory.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef DEM_OPENCL

enum
{
    PENDING = 4096,    /* commands whose times are not read yet */
    KINDS = 64
};

struct kind
{
    const char *name;
    long commands;
    double seconds;
};

struct dem_opencl_times
{
    int pending, kinds;
    cl_event event[PENDING];
    int kind_of[PENDING];
    struct kind kind[KINDS];
    struct dem_file file;
};

int dem_opencl_begin_times(struct dem_opencl *cl)
{
    const char *const path = getenv("SUNA_OPENCL_TIMES");

    if (!path)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(cl->times, 1));
    const int status = dem_file_begin(&cl->times->file, path);

    if (status)
    {
        dem_memory_free(cl->times);
        cl->times = NULL;
    }
    return status;
}

/* KINDS: there are too many, and this one is not timed. */
static int find_kind(struct dem_opencl_times *t, const char *name)
{
    int k = 0;

    while (k < t->kinds && strcmp(t->kind[k].name, name) != 0)
    {
        k++;
    }
    if (k == t->kinds && k < KINDS)
    {
        t->kind[t->kinds++].name = name;
    }
    return k;
}

static void collect(struct dem_opencl *cl, struct dem_opencl_times *t)
{
    (void)cl->calls->clFinish(cl->queue);
    for (int k = 0; k < t->pending; k++)
    {
        struct kind *const of = &t->kind[t->kind_of[k]];
        cl_ulong begin = 0, end = 0;

        if (!t->event[k])
        {
            continue;    /* the command has failed */
        }
        (void)cl->calls->clGetEventProfilingInfo(t->event[k], CL_PROFILING_COMMAND_START,
                                                 sizeof begin, &begin, NULL);
        (void)cl->calls->clGetEventProfilingInfo(t->event[k], CL_PROFILING_COMMAND_END,
                                                 sizeof end, &end, NULL);
        (void)cl->calls->clReleaseEvent(t->event[k]);
        t->event[k] = NULL;
        of->commands++;
        of->seconds += 1e-9*(double)(end - begin);
    }
    t->pending = 0;
}

cl_event *dem_opencl_time(struct dem_opencl *cl, const char *name)
{
    struct dem_opencl_times *const t = cl->times;
    const int kind = t ? find_kind(t, name) : KINDS;

    if (kind == KINDS)
    {
        return NULL;
    }
    if (t->pending == PENDING)
    {
        collect(cl, t);
    }
    t->kind_of[t->pending] = kind;
    return &t->event[t->pending++];
}

static void write_table(struct dem_opencl_times *t)
{
    fprintf(t->file.stream, "command,number,time[s]\r\n");
    for (int k = 0; k < t->kinds; k++)
    {
        fprintf(t->file.stream, "%s,%ld,%.9g\r\n", t->kind[k].name, t->kind[k].commands,
                t->kind[k].seconds);
    }
    (void)dem_file_finish(&t->file, DEM_OK);
}

void dem_opencl_end_times(struct dem_opencl *cl)
{
    if (!cl->times)
    {
        return;
    }
    if (cl->queue)
    {
        collect(cl, cl->times);
    }
    write_table(cl->times);
    dem_memory_free(cl->times);
    cl->times = NULL;
}

#endif
