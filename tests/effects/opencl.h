/*
 * opencl.h -- the first OpenCL device with doubles: build a text, run a kernel over rows.
 *
 * libOpenCL is opened at run time, so tests need neither it nor a device to be linked.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define OPENCL_CALLS(CALL)                                                                     \
    CALL(clGetPlatformIDs) CALL(clGetDeviceIDs) CALL(clGetDeviceInfo) CALL(clCreateContext)    \
    CALL(clCreateCommandQueue) CALL(clCreateProgramWithSource) CALL(clBuildProgram)            \
    CALL(clGetProgramBuildInfo) CALL(clCreateKernel) CALL(clCreateBuffer) CALL(clSetKernelArg) \
    CALL(clEnqueueNDRangeKernel) CALL(clEnqueueReadBuffer) CALL(clReleaseMemObject)            \
    CALL(clReleaseKernel)

/* deprecated calls are the ones that every version of OpenCL has */
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

#define OPENCL_MEMBER(call) __typeof__(&call) call;

static struct
{
    OPENCL_CALLS(OPENCL_MEMBER)
    cl_device_id device;
    cl_context context;
    cl_command_queue queue;
    cl_program program;
    char name[200];
} opencl;

/* Finds a device; NULL, or why there is none. */
static const char *opencl_open(void)
{
    void *const library = dlopen("libOpenCL.so.1", RTLD_NOW);
    cl_platform_id platform[8];
    cl_uint platforms = 0;
    cl_int error = 0;

    if (!library)
    {
        return "no libOpenCL (Debian: ocl-icd-libopencl1, pocl-opencl-icd)";
    }
#define OPENCL_LOAD(call)                                                                      \
    {                                                                                          \
        void *const found = dlsym(library, #call);                                             \
                                                                                               \
        memcpy(&opencl.call, &found, sizeof found);                                            \
        if (!found) { return "libOpenCL lacks " #call; }                                       \
    }
    OPENCL_CALLS(OPENCL_LOAD)
    if (opencl.clGetPlatformIDs(8, platform, &platforms) != CL_SUCCESS)
    {
        platforms = 0;
    }
    for (cl_uint k = 0; k < platforms && k < 8 && !opencl.device; k++)
    {
        cl_device_fp_config doubles = 0;

        if (opencl.clGetDeviceIDs(platform[k], CL_DEVICE_TYPE_ALL, 1, &opencl.device, NULL) ||
            opencl.clGetDeviceInfo(opencl.device, CL_DEVICE_DOUBLE_FP_CONFIG, sizeof doubles,
                                   &doubles, NULL) || !doubles)
        {
            opencl.device = NULL;
        }
    }
    if (!opencl.device)
    {
        return "no OpenCL device with doubles (Debian: pocl-opencl-icd)";
    }
    opencl.clGetDeviceInfo(opencl.device, CL_DEVICE_NAME, sizeof opencl.name - 1, opencl.name,
                           NULL);
    opencl.context = opencl.clCreateContext(NULL, 1, &opencl.device, NULL, NULL, &error);
    if (!error)
    {
        opencl.queue = opencl.clCreateCommandQueue(opencl.context, opencl.device, 0, &error);
    }
    return error ? "the OpenCL device cannot be used" : NULL;
}

/* Builds a program with these options; prints the compiler's messages. Returns 1 for success. */
static int opencl_build(const char *text, const char *options)
{
    static char log[20000];
    cl_int error;

    opencl.program = opencl.clCreateProgramWithSource(opencl.context, 1, &text, NULL, &error);
    if (!error)
    {
        error = opencl.clBuildProgram(opencl.program, 1, &opencl.device, options, NULL, NULL);
    }
    if (error)
    {
        opencl.clGetProgramBuildInfo(opencl.program, opencl.device, CL_PROGRAM_BUILD_LOG,
                                     sizeof log - 1, log, NULL);
        printf("# %.4000s\n", log);
    }
    return !error;
}

static cl_mem opencl_buffer(const void *from, size_t size)
{
    cl_int error;
    void *copy = malloc(size);
    cl_mem buffer;

    memcpy(copy, from, size);
    buffer = opencl.clCreateBuffer(opencl.context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, size,
                                   copy, &error);
    free(copy);
    return error ? NULL : buffer;
}

/* Runs a kernel of so many work items; its arguments are buffers of these sizes, the last of which
   is read back. Returns 1 for success. */
static int opencl_run(const char *kernel, size_t items, int buffers, void *const *data,
                      const size_t *size)
{
    cl_int error;
    cl_mem buffer[8];
    cl_kernel k = opencl.clCreateKernel(opencl.program, kernel, &error);

    for (int a = 0; a < buffers && !error; a++)
    {
        buffer[a] = opencl_buffer(data[a], size[a]);
        error = opencl.clSetKernelArg(k, (cl_uint)a, sizeof buffer[a], &buffer[a]);
    }
    if (error)
    {
        return 0;
    }
    error = opencl.clEnqueueNDRangeKernel(opencl.queue, k, 1, NULL, &items, NULL, 0, NULL, NULL);
    error = error ? error
                  : opencl.clEnqueueReadBuffer(opencl.queue, buffer[buffers - 1], CL_TRUE, 0,
                                               size[buffers - 1], data[buffers - 1], 0, NULL, NULL);
    for (int a = 0; a < buffers; a++)
    {
        opencl.clReleaseMemObject(buffer[a]);
    }
    opencl.clReleaseKernel(k);
    return !error;
}
