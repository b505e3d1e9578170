/*
 * scene.c -- any bytes as the text of a scene: read and checked as dem plan does, up to the placing of particles.
 *
 * A zero ends the text, as in a string. Files that it names are looked for in the folder that the harness runs in.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fuzz.h"
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *const text = malloc(size + 1);
    struct dem *d;

    memcpy(text, data, size);
    text[size] = '\0';
    fuzz_trap();
    int status = dem_create(&d, MPI_COMM_NULL);

    if (!status)
    {
        status = dem_scene_text(d, text, "scene");
        status = status ? status : dem_check(d);
        fuzz_judge(status);
        dem_free(d);
    }
    fuzz_untrap();
    free(text);
    return 0;
}
