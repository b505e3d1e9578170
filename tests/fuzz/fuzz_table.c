/*
 * fuzz_table.c -- any bytes as a table of particles: read, placed, checked for overlaps, and advanced by
 * one step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fuzz.h"
#include <stdio.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const scene =
        "materials { glass { density 2500; youngsModulus 1e7; } } "
        "effects { hertz {} dry { restitution 0.9; } "
        "mindlin { friction 0.3; } } domain { min (-1 -1 -1); max (1 1 1); periodic (x); "
        "leaving remove; } "
        "insert { t { type table; file \"%s\"; %s } }";
    const int own = memmem(data, size, "diameter", 8) !=
                    NULL;     /* a value with a column must not be in the scene */
    char text[512];

    snprintf(text, sizeof text, scene, fuzz_file(data, size), own ? "" : "diameter 1e-3;");
    fuzz_scene(text);
    return 0;
}
