/*
 * snapshot.h -- the scene whose snapshots are spoilt, and how one is made.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef FUZZ_SNAPSHOT_H
#define FUZZ_SNAPSHOT_H

/* Write the state after some steps: 0 is well. */
int fuzz_snapshot(const char *path, int steps);

#endif
