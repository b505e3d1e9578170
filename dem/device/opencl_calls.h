/*
 * opencl_calls.h -- the functions of libOpenCL, found at run time; for the files opencl*.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "device/opencl_device.h"

#if defined(__has_include)
#if __has_include(<CL/cl.h>)
#define DEM_OPENCL 1
#endif
#endif

#ifdef DEM_OPENCL

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>

/* deprecated calls are the ones that every version of OpenCL has */
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

#define DEM_OPENCL_CALLS(CALL)                                                                 \
    CALL(clGetPlatformIDs) CALL(clGetPlatformInfo) CALL(clGetDeviceIDs) CALL(clGetDeviceInfo)  \
    CALL(clCreateContext) CALL(clReleaseContext) CALL(clCreateCommandQueue)                    \
    CALL(clReleaseCommandQueue) CALL(clCreateProgramWithSource)                                \
    CALL(clCreateProgramWithBinary) CALL(clBuildProgram) CALL(clGetProgramInfo)                \
    CALL(clGetProgramBuildInfo) CALL(clReleaseProgram) CALL(clCreateKernel)                    \
    CALL(clReleaseKernel) CALL(clSetKernelArg) CALL(clCreateBuffer) CALL(clReleaseMemObject)   \
    CALL(clEnqueueNDRangeKernel) CALL(clEnqueueWriteBuffer) CALL(clEnqueueReadBuffer)          \
    CALL(clEnqueueCopyBuffer)                                                                  \
    CALL(clGetEventProfilingInfo) CALL(clReleaseEvent) CALL(clFinish) CALL(clFlush)

#define DEM_OPENCL_MEMBER(call) __typeof__(&call) call;

struct dem_opencl_calls
{
    DEM_OPENCL_CALLS(DEM_OPENCL_MEMBER)
};

struct dem_opencl_kernel
{
    cl_kernel kernel;
    char name[32];
    struct dem_opencl_kernel *next;
};

struct dem_opencl
{
    const struct dem_opencl_calls *calls;
    struct dem_opencl_info info;
    cl_device_id device;
    cl_context context;
    cl_command_queue queue;
    cl_program program;
    struct dem_opencl_kernel *kernels;
    struct dem_opencl_times *times;    /* NULL: commands are not timed */
};

/* The functions, or an error with a sentence. */
int dem_opencl_load(const struct dem_opencl_calls **);

/* DEM_OK, or an error that names what was tried and OpenCL's number. */
int dem_opencl_status(const struct dem_opencl *, cl_int error, const char *what);

/* opencl_times.c. dem_opencl_time: where a command puts its event, to be timed under a name that is
   not copied; NULL where commands are not timed. */
int dem_opencl_begin_times(struct dem_opencl *);
cl_event *dem_opencl_time(struct dem_opencl *, const char *name);
void dem_opencl_end_times(struct dem_opencl *);

#endif
