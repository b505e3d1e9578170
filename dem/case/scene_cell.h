/*
 * scene_cell.h -- the entry domain/cell: read, refuse what does not go with it, keep it in snapshots.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "input/dictionary.h"
#include "particles/cell.h"
#include "particles/domain.h"

struct dem;
struct dem_state;
struct dem_text;

/* Read it once the domain is complete, which gets a unit of length with room to grow. */
int dem_scene_read_cell(struct dem_cell *, struct dem_domain *, const struct dem_dict *domain);

/* Once effects, walls and insertion are known. */
int dem_cell_refuse(const struct dem *);

/* Collective. Once particles are there: none is frozen or driven. */
int dem_cell_refuse_fixed(const struct dem_state *);

/* A line with @ of the text of the scene in a snapshot, and the state that it holds. Axes that have deformed keep
   their length at a restart, also without an entry. A new run takes lengths and offset where its domain is the
   one of the snapshot's scene. */
void dem_cell_describe(const struct dem *, struct dem_text *);
int dem_cell_resume(struct dem *, const char *path);
int dem_cell_start(struct dem *, const char *path);
