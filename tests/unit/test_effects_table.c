/*
 * test_effects_table.c -- effects.csv, the table of effects and the times from which they act.
 *
 * - It has a row where effects change, and none where they do not.
 * - A run that begins earlier replaces the later rows.
 *
 * Reference: the text of the file, written by hand.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/file.h"
#include "core/memory.h"
#include "run/effects_table.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/effects.XXXXXX", path[64];

static void holds(const char *rows, const char *what)
{
    char *text = NULL, expected[400];

    snprintf(expected, sizeof expected, "time[s],effects\n%s", rows);
    TAP_OK(dem_file_load_text(path, &text) == 0 && strcmp(text, expected) == 0, "%s", what);
    dem_memory_free(text);
}

int main(void)
{
    TAP_TRAPS;
    if (!TAP_OK(mkdtemp(folder) != NULL, "a folder"))
    {
        return 1;
    }
    snprintf(path, sizeof path, "%s/effects.csv", folder);

    dem_effects_table_begin(folder, 0.0, "hertz dry");
    holds("0,hertz dry\n", "a run begins");
    dem_effects_table_begin(folder, 0.5, "hertz dry");
    holds("0,hertz dry\n", "continued with the same effects");
    dem_effects_table_begin(folder, 0.7, "hertz stokesDamping");
    holds("0,hertz dry\n0.7,hertz stokesDamping\n", "with others");
    dem_effects_table_begin(folder, 0.7*(1.0 + 1e-12), "hertz viscous");
    holds("0,hertz dry\n0.7,hertz viscous\n", "once more from there, the last digit off");
    dem_effects_table_begin(folder, 0.6, "hertz dry mindlin");
    holds("0,hertz dry\n0.6,hertz dry mindlin\n", "from before that");
    dem_effects_table_begin(folder, 0.0, "hooke");
    holds("0,hooke\n", "all again");
    TAP_OK(dem_effects_table_begin("/nowhere/at/all", 0.0, "hertz") != 0, "no folder, no table");
    unlink(path);
    rmdir(folder);
    TAP_DONE;
}
