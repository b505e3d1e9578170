/*
 * fuzz.h -- what the harnesses share: bytes become a file, traps are on while a reader works, and a refusal is one sentence.
 *
 * Each reader has one file with LLVMFuzzerTestOneInput, the name that libFuzzer and AFL++ call; replay.c calls it, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef FUZZ_H
#define FUZZ_H

#include "dem.h"
#include <stddef.h>
#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* A file in memory with these bytes; the path stays good until the next call. */
const char *fuzz_file(const void *data, size_t size);

/* Floating-point traps on, as OpenFOAM has them, and off again. */
void fuzz_trap(void);
void fuzz_untrap(void);

/* A status is success or comes with one sentence, of one line: else the program aborts. */
void fuzz_judge(int status);

/* A scene of this text: read, made ready, advanced by one step, judged; with traps on. */
void fuzz_scene(const char *text);

/* Of the last input: its status. */
int fuzz_status(void);

#endif
