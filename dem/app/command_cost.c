/*
 * command_cost.c -- `dem cost`, `dem plot` and `dem import`: replace this program by a Python
 * program: suna_cost makes and draws studies, suna_import translates cases.
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

/* The path of dem-cost, dem-plot or dem-import, the script beside this program. */
static int find_script(const char *command, char *path, size_t size)
{
    const ssize_t n = readlink("/proc/self/exe", path, size - 1);

    DEM_REQUIRE(n > 0 && (size_t)n + strlen(command) + 2 < size, DEM_ERROR_FILE,
                "cannot find the folder of the program: %s", n < 0 ? strerror(errno) : "its name is "
                                                                                    "too long");
    snprintf(path + n, size - (size_t)n, "-%s", command);
    DEM_REQUIRE(access(path, R_OK) == 0, DEM_ERROR_FILE, "there is no %s; make -C dem puts it beside "
                "the program", path);
    return DEM_OK;
}

int dem_main_python(const char *command, int argc, char **argv)
{
    const char *const named = getenv("SUNA_PYTHON");
    const char *const python = named && named[0] ? named : "python3";
    char path[1024], **arguments;

    DEM_TRY(find_script(command, path, sizeof path));
    DEM_TRY(DEM_NEW(arguments, argc + 3));
    arguments[0] = strdup(python);
    arguments[1] = path;
    memcpy(arguments + 2, argv, (size_t)argc*sizeof *argv);
    execvp(python, arguments);
    return dem_error(DEM_ERROR_FILE, "dem %s is written in Python, and cannot start %s: %s; install "
                     "python3-cffi, python3-numpy, python3-scipy and python3-matplotlib (Debian), or "
                     "name another Python by SUNA_PYTHON", command, python, strerror(errno));
}
