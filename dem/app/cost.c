/*
 * cost.c -- `dem cost`: starts the Python program suna.cost, which makes the study, in place of this
 * one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* readlink */
#include "app/main.h"
#include "core/error.h"
#include "core/memory.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The path of dem-cost, the script beside this program. */
static int find_script(char *path, size_t size)
{
    const ssize_t n = readlink("/proc/self/exe", path, size - 1);

    DEM_REQUIRE(n > 0 && (size_t)n + sizeof "-cost" < size, DEM_ERROR_FILE,
                "cannot find the folder of the program: %s", n < 0 ? strerror(errno) : "its name is "
                                                                                    "too long");
    memcpy(path + n, "-cost", sizeof "-cost");
    DEM_REQUIRE(access(path, R_OK) == 0, DEM_ERROR_FILE, "there is no %s; make -C dem puts it beside "
                "the program", path);
    return DEM_OK;
}

int dem_main_cost(int argc, char **argv)
{
    const char *const named = getenv("SUNA_PYTHON");
    const char *const python = named && named[0] ? named : "python3";
    char path[1024], **arguments;

    DEM_TRY(find_script(path, sizeof path));
    DEM_TRY(DEM_NEW(arguments, argc + 3));
    arguments[0] = strdup(python);
    arguments[1] = path;
    memcpy(arguments + 2, argv, (size_t)argc*sizeof *argv);
    execvp(python, arguments);
    return dem_error(DEM_ERROR_FILE, "dem cost needs python3 with cffi, numpy and scipy, and cannot "
                     "start %s: %s; install it, or name another one by SUNA_PYTHON", python,
                     strerror(errno));
}
