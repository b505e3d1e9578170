/*
 * fuzz_stl.c -- any bytes as a surface: read, made a wall, searched for a particle near it, and advanced
 * by one step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fuzz.h"
#include <stdio.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char text[512];

    snprintf(
        text, sizeof text,
        "materials { glass { density 2500; youngsModulus 1e7; } } "
        "effects { hertz {} dry { restitution 0.9; } "
        "mindlin { friction 0.3; } } walls { w { type stl; file \"%s\"; scale 1e-3; } } "
        "insert { p { type list; diameter 1e-3; "
        "positions ((0 0 6e-4) (0.01 0 0)); } }",
        fuzz_file(data, size));
    fuzz_scene(text);
    return 0;
}
