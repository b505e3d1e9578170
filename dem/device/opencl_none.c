/*
 * opencl_none.c -- the calls of opencl_device.h in a build without OpenCL's headers: each says so.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/opencl_calls.h"
#include "core/error.h"

#ifndef DEM_OPENCL

static int refuse(void)
{
    return dem_error(DEM_ERROR_STATE, "this build has no devices: the headers of OpenCL were not "
                     "found when it was made (Debian: opencl-c-headers)");
}

int dem_opencl_list(struct dem_opencl_info list[DEM_OPENCL_DEVICES], int *n)
{
    (void)list;
    *n = 0;
    return refuse();
}

int dem_opencl_open(struct dem_opencl **opened, const char *wanted, int rank, int *fitting)
{
    (void)wanted, (void)rank;
    *opened = NULL;
    *fitting = 0;
    return refuse();
}

/* Never called, because no device can be opened. */
void dem_opencl_close(struct dem_opencl *cl)
{
    (void)cl;
}

const struct dem_opencl_info *dem_opencl_device(const struct dem_opencl *cl)
{
    (void)cl;
    return NULL;
}

int dem_opencl_build(struct dem_opencl *cl, const char *text, uint64_t *key)
{
    (void)cl, (void)text;
    *key = 0;
    return refuse();
}

int dem_opencl_kernel(struct dem_opencl *cl, const char *name, struct dem_opencl_kernel **k)
{
    (void)cl, (void)name;
    *k = NULL;
    return refuse();
}

int dem_opencl_reserve(struct dem_opencl *cl, struct dem_opencl_memory *m, size_t bytes)
{
    (void)cl, (void)m, (void)bytes;
    return refuse();
}

void dem_opencl_release(struct dem_opencl *cl, struct dem_opencl_memory *m)
{
    (void)cl, (void)m;
}

int dem_opencl_give(struct dem_opencl *cl, struct dem_opencl_kernel *k, int argument, int n,
                    const struct dem_opencl_memory *const *m)
{
    (void)cl, (void)k, (void)argument, (void)n, (void)m;
    return refuse();
}

int dem_opencl_give_number(struct dem_opencl *cl, struct dem_opencl_kernel *k, int argument,
                           uint32_t number)
{
    (void)cl, (void)k, (void)argument, (void)number;
    return refuse();
}

int dem_opencl_launch(struct dem_opencl *cl, struct dem_opencl_kernel *k, size_t items)
{
    (void)cl, (void)k, (void)items;
    return refuse();
}

int dem_opencl_copy(struct dem_opencl *cl, const struct dem_opencl_memory *from,
                    const struct dem_opencl_memory *to, size_t bytes)
{
    (void)cl, (void)from, (void)to, (void)bytes;
    return refuse();
}

int dem_opencl_write(struct dem_opencl *cl, const struct dem_opencl_memory *m, size_t offset,
                     size_t bytes, const void *from)
{
    (void)cl, (void)m, (void)offset, (void)bytes, (void)from;
    return refuse();
}

int dem_opencl_read(struct dem_opencl *cl, const struct dem_opencl_memory *m, size_t offset,
                    size_t bytes, void *to)
{
    (void)cl, (void)m, (void)offset, (void)bytes, (void)to;
    return refuse();
}

#endif
