/*
 * opencl_device.h -- an OpenCL device: found, opened, given a program, memory and work.
 *
 * libOpenCL is opened at run time, so that a machine without it runs everything else. What the calls
 * of a device return and take hides OpenCL's types: opencl_device.c and opencl_program.c alone
 * include its headers (Debian: opencl-c-headers). Built without them, every call says so.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

struct dem_opencl_info
{
    char name[128], platform[128], driver[128];
    double memory;                /* byte */
    int units, gpu, doubles;      /* compute units; 1: a GPU; 1: computes in double precision */
};

enum
{
    DEM_OPENCL_DEVICES = 32       /* limit of those that are looked at */
};

struct dem_opencl;
struct dem_opencl_kernel;
struct dem_opencl_memory
{
    void *buffer;                 /* NULL: none */
    size_t bytes;
};

/* The devices of this machine. DEM_ERROR_STATE with a sentence when there is none, or no OpenCL. */
int dem_opencl_list(struct dem_opencl_info list[DEM_OPENCL_DEVICES], int *n);

/* Open a device whose name or platform contains `wanted`, upper or lower case; "gpu": a GPU. `rank`: number of this
   rank on its machine, from 0; the ranks take the devices that fit in turn. `fitting`: number of these devices.
   DEM_ERROR_STATE when none has double precision. */
int dem_opencl_open(struct dem_opencl **, const char *wanted, int rank, int *fitting);
void dem_opencl_close(struct dem_opencl *);
const struct dem_opencl_info *dem_opencl_device(const struct dem_opencl *);

/* Build a program from its text, or take it from the cache on disk, which then has it. `key`: names
   the program with this device and driver in the cache. DEM_ERROR_STATE with the compiler's first
   words. */
int dem_opencl_build(struct dem_opencl *, const char *text, uint64_t *key);

/* Whether the cache has a note of this kind for a program; make one. */
int dem_opencl_has_note(uint64_t key, const char *kind);
void dem_opencl_make_note(uint64_t key, const char *kind);

/* A kernel of the program; freed with the device. */
int dem_opencl_kernel(struct dem_opencl *, const char *name, struct dem_opencl_kernel **);

/* Memory for at least so many bytes; its content is lost when it grows. */
int dem_opencl_reserve(struct dem_opencl *, struct dem_opencl_memory *, size_t bytes);
void dem_opencl_release(struct dem_opencl *, struct dem_opencl_memory *);

/* Arguments of a kernel: n memories, from this one on; an integer. Then make `items` work items of
   it. */
int dem_opencl_give(struct dem_opencl *, struct dem_opencl_kernel *, int argument, int n,
                    const struct dem_opencl_memory *const *);
#define DEM_OPENCL_GIVE(cl, kernel, argument, ...)                                             \
    dem_opencl_give(cl, kernel, argument,                                                      \
                    (int)(sizeof(const struct dem_opencl_memory *[]){__VA_ARGS__}/             \
                          sizeof(struct dem_opencl_memory *)),                                 \
                    (const struct dem_opencl_memory *const[]){__VA_ARGS__})
int dem_opencl_give_number(struct dem_opencl *, struct dem_opencl_kernel *, int argument,
                           uint32_t number);
int dem_opencl_launch(struct dem_opencl *, struct dem_opencl_kernel *, size_t items);

/* Copy bytes from one memory of the device to another. */
int dem_opencl_copy(struct dem_opencl *, const struct dem_opencl_memory *from,
                    const struct dem_opencl_memory *to, size_t bytes);

/* Copy bytes to the memory of the device; from it, after all work before. */
int dem_opencl_write(struct dem_opencl *, const struct dem_opencl_memory *, size_t offset,
                     size_t bytes, const void *from);
int dem_opencl_read(struct dem_opencl *, const struct dem_opencl_memory *, size_t offset,
                    size_t bytes, void *to);

/* Memory for these bytes, and the bytes. */
static inline int dem_opencl_put(struct dem_opencl *cl, struct dem_opencl_memory *m, size_t bytes,
                                 const void *from)
{
    const int status = dem_opencl_reserve(cl, m, bytes);

    return status ? status : dem_opencl_write(cl, m, 0, bytes, from);
}
