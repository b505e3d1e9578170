/*
 * stage_tests.h -- the advance of a run with stages, or with walls that come and go.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

struct dem;

/* Collective. Advance by `duration` [s] in several windows, each made by `window`. */
int dem_stages_advance(struct dem *, double duration, int (*window)(struct dem *, double duration));

/* The state has gone back to a backup: so do the stages. */
void dem_stages_rewind(struct dem *);
