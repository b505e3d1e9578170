/*
 * fuzz_snapshot.h -- make a snapshot of the scene of fuzz_snapshot.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

/* Write the state after some steps; 0 on success. */
int fuzz_snapshot(const char *path, int steps);
