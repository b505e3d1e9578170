/*
 * fuzz.h -- shared by the harnesses: bytes become a file, floating-point traps are on while a
 * reader works, and a refusal is one sentence.
 *
 * Each reader has one file with LLVMFuzzerTestOneInput, the name that libFuzzer and AFL++ call;
 * replay.c calls it, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_query.h"
#include <stddef.h>
#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* A file in memory with these bytes; the path is valid until the next call. */
const char *fuzz_file(const void *data, size_t size);

/* Floating-point traps on, as OpenFOAM has them, and off again. */
void fuzz_trap(void);
void fuzz_untrap(void);

/* A status is success or comes with one sentence, of one line: else the program aborts. */
void fuzz_judge(int status);

/* Read, set up and advance a scene of this text by one step, and check its status; with traps
   on. */
void fuzz_scene(const char *text);

/* Status of the last input. */
int fuzz_status(void);
