/*
 * opencl_program.c -- build the program of a device, or take it from the cache on disk: the folder
 * suna/opencl of $XDG_CACHE_HOME, or of ~/.cache. A file of it is named by the hash of the text, the
 * device and its driver; deleting it costs a build.
 *
 * A machine without a place for it builds the program in each run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/opencl_calls.h"
#include "core/error.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/memory.h"
#include "dem_tables.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
    PATH = 1024,
    LOG = 20000
};

/* ---- the cache --------------------------------------------------------------------------------- */

/* The path of a file of the cache, whose folders are made; 0 where there is no place for it. */
static int cache_path(uint64_t key, const char *kind, char path[PATH])
{
    const char *const cache = getenv("XDG_CACHE_HOME"), *const home = getenv("HOME");
    static const char *const folders[] = {"", "/suna", "/opencl"};
    size_t n = (size_t)snprintf(path, PATH, "%s%s", cache && cache[0] ? cache : home ? home : "",
                                cache && cache[0] ? "" : "/.cache");

    if (path[0] != '/')
    {
        return 0;
    }
    for (size_t k = 0; k < sizeof folders/sizeof *folders && n < PATH; k++)
    {
        n += (size_t)snprintf(path + n, PATH - n, "%s", folders[k]);
        if (n >= PATH || dem_file_make_folder(path) != DEM_OK)
        {
            return 0;
        }
    }
    n += n < PATH ? (size_t)snprintf(path + n, PATH - n, "/%016llx.%s", (unsigned long long)key, kind)
                  : 0;
    return n < PATH;
}

int dem_opencl_has_note(uint64_t key, const char *kind)
{
    char path[PATH];

    return cache_path(key, kind, path) && dem_file_exists(path);
}

static void store(uint64_t key, const char *kind, const void *bytes, size_t n)
{
    struct dem_file f;
    char path[PATH];

    if (cache_path(key, kind, path) && dem_file_begin(&f, path) == DEM_OK)
    {
        (void)fwrite(bytes, 1, n, f.stream);
        (void)dem_file_finish(&f, DEM_OK);
    }
}

void dem_opencl_make_note(uint64_t key, const char *kind)
{
    store(key, kind, "yes\n", 4);
}

#ifdef DEM_OPENCL

/* SUNA_OPENCL_OPTIONS adds further ones, where a driver needs them. */
static const char *options(void)
{
    static char all[1000];
    const char *const more = getenv("SUNA_OPENCL_OPTIONS");

    snprintf(all, sizeof all, "-cl-std=CL1.2 %s", more ? more : "");
    return all;
}

static uint64_t key_of(const struct dem_opencl *cl, const char *text)
{
    struct dem_hash h;

    dem_hash_start(&h, 'd');
    dem_hash_bytes(&h, text, strlen(text));
    dem_hash_bytes(&h, options(), strlen(options()));
    dem_hash_bytes(&h, cl->info.name, sizeof cl->info.name);
    dem_hash_bytes(&h, cl->info.platform, sizeof cl->info.platform);
    dem_hash_bytes(&h, cl->info.driver, sizeof cl->info.driver);
    return dem_hash_value(&h);
}

/* Keep the program for the next run, behind its hash: drivers do not survive a damaged one. */
static void keep(const struct dem_opencl *cl, uint64_t key)
{
    size_t size = 0;
    unsigned char *file, *binary;

    if (cl->calls->clGetProgramInfo(cl->program, CL_PROGRAM_BINARY_SIZES, sizeof size, &size, NULL) ||
        size == 0 || DEM_NEW(file, size + sizeof key))
    {
        return;
    }
    binary = file + sizeof key;
    if (cl->calls->clGetProgramInfo(cl->program, CL_PROGRAM_BINARIES, sizeof binary, &binary, NULL) ==
        CL_SUCCESS)
    {
        const uint64_t hash = dem_hash_record(binary, size, key);

        memcpy(file, &hash, sizeof hash);
        store(key, "program", file, size + sizeof hash);
    }
    dem_memory_free(file);
}

static void drop(struct dem_opencl *cl)
{
    if (cl->program)
    {
        (void)cl->calls->clReleaseProgram(cl->program);
        cl->program = NULL;
    }
}

/* The program of a file of the cache; 0 when it is damaged. */
static int is_sound(const char *file, size_t n, uint64_t key)
{
    uint64_t hash;

    if (n <= sizeof hash)
    {
        return 0;
    }
    memcpy(&hash, file, sizeof hash);
    return hash == dem_hash_record(file + sizeof hash, n - sizeof hash, key);
}

/* 1 when the cache has it. */
static int take(struct dem_opencl *cl, uint64_t key)
{
    char path[PATH], *file = NULL;
    size_t n = 0;
    cl_int error = CL_INVALID_BINARY, of_device = CL_SUCCESS;

    if (!cache_path(key, "program", path) || !dem_file_exists(path) ||
        dem_file_load(path, &file, &n) != DEM_OK)
    {
        return 0;
    }
    if (is_sound(file, n, key))
    {
        const unsigned char *const binary = (const unsigned char *)file + sizeof key;
        const size_t size = n - sizeof key;

        cl->program = cl->calls->clCreateProgramWithBinary(cl->context, 1, &cl->device, &size,
                                                           (const unsigned char *[]){binary},
                                                           &of_device, &error);
        error = error || of_device
                    ? CL_INVALID_BINARY
                    : cl->calls->clBuildProgram(cl->program, 1, &cl->device, options(), NULL, NULL);
    }
    dem_memory_free(file);
    if (error)
    {
        drop(cl);
    }
    return !error;
}

static int compile(struct dem_opencl *cl, const char *text)
{
    cl_int error;
    char *log;

    cl->program = cl->calls->clCreateProgramWithSource(cl->context, 1, &text, NULL, &error);
    DEM_TRY(dem_opencl_status(cl, error, "take a program"));
    error = cl->calls->clBuildProgram(cl->program, 1, &cl->device, options(), NULL, NULL);
    if (error == CL_SUCCESS)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(log, LOG));
    (void)cl->calls->clGetProgramBuildInfo(cl->program, cl->device, CL_PROGRAM_BUILD_LOG, LOG - 1,
                                           log, NULL);
    drop(cl);
    dem_error(DEM_ERROR_STATE, "the device %s: its compiler refuses the program, OpenCL error %d: "
              "%.1500s", cl->info.name, error, log);
    dem_memory_free(log);
    return DEM_ERROR_STATE;
}

int dem_opencl_build(struct dem_opencl *cl, const char *text, uint64_t *key)
{
    *key = key_of(cl, text);
    if (!take(cl, *key))
    {
        DEM_TRY(compile(cl, text));
        keep(cl, *key);
    }
    /* LLVM, which compiles for some devices, takes SIGUSR1 */
    dem_keep_signals();
    return DEM_OK;
}

int dem_opencl_kernel(struct dem_opencl *cl, const char *name, struct dem_opencl_kernel **kernel)
{
    struct dem_opencl_kernel *k;
    cl_int error;

    *kernel = NULL;
    DEM_TRY(DEM_NEW(k, 1));
    k->kernel = cl->calls->clCreateKernel(cl->program, name, &error);
    if (error)
    {
        dem_memory_free(k);
        return dem_opencl_status(cl, error, "find a kernel of the program");
    }
    snprintf(k->name, sizeof k->name, "%s", name);
    k->next = cl->kernels;
    cl->kernels = *kernel = k;
    return DEM_OK;
}

#endif
