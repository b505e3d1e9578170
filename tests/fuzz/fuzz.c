/*
 * fuzz.c -- see fuzz.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fuzz.h"
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

static int last;

const char *fuzz_file(const void *data, size_t size)
{
    static char path[64];
    static int fd = -1;

    if (fd < 0)
    {
        fd = memfd_create("fuzz", 0);
        snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    }
    if (fd < 0 || ftruncate(fd, 0) != 0 || pwrite(fd, data, size, 0) != (ssize_t)size)
    {
        perror("fuzz_file");
        exit(1);
    }
    return path;
}

void fuzz_trap(void)
{
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
}

void fuzz_untrap(void)
{
    fedisableexcept(FE_ALL_EXCEPT);
}

void fuzz_judge(int status)
{
    const char *const text = dem_error_text();

    last = status;
    if (status && (!text[0] || strchr(text, '\n')))
    {
        fprintf(stderr, "status %d comes with \"%s\", which is not one sentence\n", status, text);
        abort();
    }
}

void fuzz_scene(const char *text)
{
    struct dem_case *c;
    struct dem *d = NULL;

    fuzz_trap();
    int status = dem_case_create(&c, MPI_COMM_NULL);

    if (!status)
    {
        status = dem_case_scene_text(c, text, "scene");
        status = status ? status : dem_start(&c, &d);
        status =
            status
                ? status
                : dem_advance(d,
                              fmin(1e-9,
                                   dem_step_limit(d)
                                       /* a sphere of 1e-13 m takes 1e7 steps for 1e-9 s */
                                       .used));
        fuzz_judge(status);
        dem_case_free(c);
        dem_free(d);
    }
    fuzz_untrap();
}

int fuzz_status(void)
{
    return last;
}
