/*
 * opencl_device.c -- find libOpenCL and its devices; memory and work of a device.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* strncasecmp */

#include "device/opencl_calls.h"
#include "core/error.h"
#include "core/memory.h"
#include "device/shared.h"
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#ifdef DEM_OPENCL

/* ---- the library ----------------------------------------------------------------------------- */

int dem_opencl_load(const struct dem_opencl_calls **calls)
{
    static struct dem_opencl_calls found;
    static int loaded;

    *calls = &found;
    if (loaded)
    {
        return DEM_OK;
    }
    /* MPI's hwloc would otherwise bring OpenCL into mpirun and every rank, with its signal handlers */
    void *const library = dlopen("libOpenCL.so.1", RTLD_NOW | RTLD_LOCAL);

    DEM_REQUIRE(library, DEM_ERROR_STATE, "there is no OpenCL on this machine: libOpenCL.so.1 is not "
                "found (Debian: ocl-icd-libopencl1, and a driver of the device)");
#define LOAD(call)                                                                             \
    do                                                                                         \
    {                                                                                          \
        void *const at = dlsym(library, #call);                                                \
                                                                                               \
        DEM_REQUIRE(at, DEM_ERROR_STATE, "libOpenCL.so.1 lacks the function " #call);           \
        memcpy(&found.call, &at, sizeof at);                                                   \
    } while (0);
    DEM_OPENCL_CALLS(LOAD)
    loaded = 1;
    return DEM_OK;
}

int dem_opencl_status(const struct dem_opencl *cl, cl_int error, const char *what)
{
    DEM_REQUIRE(error == CL_SUCCESS, DEM_ERROR_STATE, "the device %s: cannot %s, OpenCL error %d%s",
                cl->info.name, what, error,
                error == CL_MEM_OBJECT_ALLOCATION_FAILURE || error == CL_OUT_OF_RESOURCES ||
                        error == CL_OUT_OF_HOST_MEMORY
                    ? "; its memory may be too small"
                    : "");
    return DEM_OK;
}

/* ---- devices --------------------------------------------------------------------------------- */

struct devices
{
    int n;
    cl_device_id id[DEM_OPENCL_DEVICES];
    struct dem_opencl_info info[DEM_OPENCL_DEVICES];
};

/* A text of a device; blanks at the begin are left out, which some drivers have. */
static void device_text(const struct dem_opencl_calls *calls, cl_device_id id, cl_device_info what,
                        char text[128])
{
    char all[512] = "";

    (void)calls->clGetDeviceInfo(id, what, sizeof all - 1, all, NULL);
    strncpy(text, all + strspn(all, " "), 127);
    text[127] = '\0';
}

static void describe(const struct dem_opencl_calls *calls, cl_platform_id platform, cl_device_id id,
                     struct dem_opencl_info *info)
{
    cl_device_type type = 0;
    cl_device_fp_config doubles = 0;
    cl_ulong memory = 0;
    cl_uint units = 0;

    memset(info, 0, sizeof *info);
    device_text(calls, id, CL_DEVICE_NAME, info->name);
    device_text(calls, id, CL_DRIVER_VERSION, info->driver);
    (void)calls->clGetPlatformInfo(platform, CL_PLATFORM_NAME, sizeof info->platform - 1,
                                   info->platform, NULL);
    (void)calls->clGetDeviceInfo(id, CL_DEVICE_TYPE, sizeof type, &type, NULL);
    (void)calls->clGetDeviceInfo(id, CL_DEVICE_DOUBLE_FP_CONFIG, sizeof doubles, &doubles, NULL);
    (void)calls->clGetDeviceInfo(id, CL_DEVICE_GLOBAL_MEM_SIZE, sizeof memory, &memory, NULL);
    (void)calls->clGetDeviceInfo(id, CL_DEVICE_MAX_COMPUTE_UNITS, sizeof units, &units, NULL);
    info->gpu = (type & CL_DEVICE_TYPE_GPU) != 0;
    info->doubles = doubles != 0;
    info->memory = (double)memory;
    info->units = (int)units;
}

static int find_devices(const struct dem_opencl_calls *calls, struct devices *found)
{
    cl_platform_id platform[16];
    cl_uint platforms = 0;

    found->n = 0;
    if (calls->clGetPlatformIDs(16, platform, &platforms) != CL_SUCCESS)
    {
        platforms = 0;
    }
    for (cl_uint p = 0; p < platforms && p < 16; p++)
    {
        cl_device_id id[DEM_OPENCL_DEVICES];
        cl_uint n = 0;

        if (calls->clGetDeviceIDs(platform[p], CL_DEVICE_TYPE_ALL, DEM_OPENCL_DEVICES, id, &n))
        {
            n = 0;
        }
        for (cl_uint k = 0; k < n && found->n < DEM_OPENCL_DEVICES; k++, found->n++)
        {
            found->id[found->n] = id[k];
            describe(calls, platform[p], id[k], &found->info[found->n]);
        }
    }
    DEM_REQUIRE(found->n > 0, DEM_ERROR_STATE, "OpenCL knows no device on this machine; install the "
                "driver of the device (Debian: nvidia-opencl-icd, mesa-opencl-icd, or "
                "pocl-opencl-icd, which computes on CPUs)");
    return DEM_OK;
}

int dem_opencl_list(struct dem_opencl_info list[DEM_OPENCL_DEVICES], int *n)
{
    const struct dem_opencl_calls *calls;
    struct devices found;

    *n = 0;
    DEM_TRY(dem_opencl_load(&calls));
    DEM_TRY(find_devices(calls, &found));
    memcpy(list, found.info, sizeof found.info);
    *n = found.n;
    return DEM_OK;
}

static int contains(const char *text, const char *word)
{
    const size_t length = strlen(word);

    while (*text && strncasecmp(text, word, length) != 0)
    {
        text++;
    }
    return *text != '\0';
}

static int is_wanted(const struct dem_opencl_info *info, const char *wanted)
{
    return strcmp(wanted, "gpu") == 0
               ? info->gpu
               : contains(info->name, wanted) || contains(info->platform, wanted);
}

static int choose(const struct devices *found, const char *wanted, int rank, int *chosen, int *fitting)
{
    int without = -1, fit[DEM_OPENCL_DEVICES], n = 0;

    for (int k = 0; k < found->n; k++)
    {
        const int fits = is_wanted(&found->info[k], wanted);

        if (fits && found->info[k].doubles)
        {
            fit[n++] = k;
        }
        without = fits && without < 0 && !found->info[k].doubles ? k : without;
    }
    *chosen = n > 0 ? fit[rank%n] : -1;
    *fitting = n;
    DEM_REQUIRE(n > 0 || without < 0, DEM_ERROR_STATE,
                "the device %s does not compute in double precision", found->info[without].name);
    DEM_REQUIRE(n > 0, DEM_ERROR_STATE, "no device %s among the %d that OpenCL knows here "
                "(dem run -device list)", strcmp(wanted, "gpu") == 0 ? "is a GPU" : wanted, found->n);
    return DEM_OK;
}

int dem_opencl_open(struct dem_opencl **opened, const char *wanted, int rank, int *fitting)
{
    const struct dem_opencl_calls *calls;
    struct devices found;
    struct dem_opencl *cl;
    int chosen;
    cl_int error;

    *opened = NULL;
    DEM_TRY(dem_opencl_load(&calls));
    DEM_TRY(find_devices(calls, &found));
    DEM_TRY(choose(&found, wanted, rank, &chosen, fitting));
    DEM_TRY(DEM_NEW(cl, 1));
    cl->calls = calls;
    cl->info = found.info[chosen];
    cl->device = found.id[chosen];
    cl->context = calls->clCreateContext(NULL, 1, &cl->device, NULL, NULL, &error);
    int status = dem_opencl_status(cl, error, "open it");

    if (!status)
    {
        status = dem_opencl_begin_times(cl);
    }
    if (!status)
    {
        cl->queue = calls->clCreateCommandQueue(cl->context, cl->device,
                                                cl->times ? CL_QUEUE_PROFILING_ENABLE : 0, &error);
        status = dem_opencl_status(cl, error, "make a queue");
    }
    if (status)
    {
        dem_opencl_close(cl);
        return status;
    }
    *opened = cl;
    return DEM_OK;
}

void dem_opencl_close(struct dem_opencl *cl)
{
    if (cl)
    {
        dem_opencl_end_times(cl);
    }
    while (cl && cl->kernels)
    {
        struct dem_opencl_kernel *const k = cl->kernels;

        cl->kernels = k->next;
        (void)cl->calls->clReleaseKernel(k->kernel);
        dem_memory_free(k);
    }
    if (cl && cl->program)
    {
        (void)cl->calls->clReleaseProgram(cl->program);
    }
    if (cl && cl->queue)
    {
        (void)cl->calls->clReleaseCommandQueue(cl->queue);
    }
    if (cl && cl->context)
    {
        (void)cl->calls->clReleaseContext(cl->context);
    }
    dem_memory_free(cl);
}

const struct dem_opencl_info *dem_opencl_device(const struct dem_opencl *cl)
{
    return &cl->info;
}

/* ---- memory ---------------------------------------------------------------------------------- */

void dem_opencl_release(struct dem_opencl *cl, struct dem_opencl_memory *m)
{
    if (m->buffer)
    {
        (void)cl->calls->clReleaseMemObject(m->buffer);
    }
    *m = (struct dem_opencl_memory){NULL, 0};
}

int dem_opencl_reserve(struct dem_opencl *cl, struct dem_opencl_memory *m, size_t bytes)
{
    cl_int error;

    if (m->buffer && m->bytes >= bytes)
    {
        return DEM_OK;
    }
    dem_opencl_release(cl, m);
    /* some room, as the number of rows changes from list to list; never nothing */
    const size_t size = bytes + bytes/16 + 64;

    m->buffer = cl->calls->clCreateBuffer(cl->context, CL_MEM_READ_WRITE, size, NULL, &error);
    DEM_TRY(dem_opencl_status(cl, error, "allocate memory"));
    m->bytes = size;
    return DEM_OK;
}

int dem_opencl_write(struct dem_opencl *cl, const struct dem_opencl_memory *m, size_t offset,
                     size_t bytes, const void *from)
{
    return bytes == 0 ? DEM_OK
                      : dem_opencl_status(cl, cl->calls->clEnqueueWriteBuffer(
                                                  cl->queue, m->buffer, CL_TRUE, offset, bytes,
                                                  from, 0, NULL, dem_opencl_time(cl, "(up)")),
                                          "write to its memory");
}

int dem_opencl_read(struct dem_opencl *cl, const struct dem_opencl_memory *m, size_t offset,
                    size_t bytes, void *to)
{
    return bytes == 0 ? DEM_OK
                      : dem_opencl_status(cl, cl->calls->clEnqueueReadBuffer(
                                                  cl->queue, m->buffer, CL_TRUE, offset, bytes, to,
                                                  0, NULL, dem_opencl_time(cl, "(down)")),
                                          "read its memory");
}

int dem_opencl_copy(struct dem_opencl *cl, const struct dem_opencl_memory *from,
                    const struct dem_opencl_memory *to, size_t bytes)
{
    return bytes == 0 ? DEM_OK
                      : dem_opencl_status(cl, cl->calls->clEnqueueCopyBuffer(
                                                  cl->queue, from->buffer, to->buffer, 0, 0, bytes,
                                                  0, NULL, dem_opencl_time(cl, "(copy)")),
                                          "copy its memory");
}

/* ---- work ------------------------------------------------------------------------------------ */

int dem_opencl_give(struct dem_opencl *cl, struct dem_opencl_kernel *k, int argument, int n,
                    const struct dem_opencl_memory *const *m)
{
    for (int a = 0; a < n; a++)
    {
        cl_mem buffer = m[a]->buffer;

        DEM_TRY(dem_opencl_status(cl, cl->calls->clSetKernelArg(k->kernel, (cl_uint)(argument + a),
                                                                sizeof buffer, &buffer),
                                  "set an argument"));
    }
    return DEM_OK;
}

int dem_opencl_give_number(struct dem_opencl *cl, struct dem_opencl_kernel *k, int argument,
                           uint32_t number)
{
    return dem_opencl_status(cl, cl->calls->clSetKernelArg(k->kernel, (cl_uint)argument,
                                                           sizeof number, &number),
                             "set an argument");
}

int dem_opencl_launch(struct dem_opencl *cl, struct dem_opencl_kernel *k, size_t items)
{
    const size_t group = DEM_DEVICE_GROUP, all = (items + group - 1)/group*group;

    return items == 0 ? DEM_OK
                      : dem_opencl_status(cl, cl->calls->clEnqueueNDRangeKernel(
                                                  cl->queue, k->kernel, 1, NULL, &all, &group, 0,
                                                  NULL, dem_opencl_time(cl, k->name)),
                                          "start a kernel");
}

#endif
