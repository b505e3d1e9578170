/*
 * dem_tables.h -- the CSV tables of a run that grow by rows: lost.csv, bonds.csv, flows.csv,
 * walls.csv, energy.csv, and others of the caller.
 *
 * The first line of a table has the names of its columns; it is made with the first row, and
 * effects.csv beside it names the effects of the run (dem_effects_record). What follows is called
 * on one rank, unless it says collective. docs/output.md describes the columns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_TABLES_H
#define DEM_TABLES_H

#include "dem.h"

#ifdef __cplusplus
extern "C" {
#endif

enum
{
    DEM_FLOWS = 64    /* limit of streams and outlets; a scene may have fewer */
};

struct dem_table
{
    char folder[512], path[640];
    double start;     /* s  time at which the run starts */
};

/* Name a table, for example "lost.csv" in a folder. Touches no file. */
void dem_table_name(struct dem_table *, const char *folder, const char *file, double start);

/* Before the first row: what an earlier run may have left. The file is removed if the run starts at
   0 or time_column is negative; else the rows with a time after the start are, the number in
   time_column (from 0). Comments of earlier versions, which name the effects, are moved into
   effects.csv. */
int dem_table_begin(const struct dem_table *, const struct dem *, int time_column);

/* Append lines, each with its line's end. A new table gets the line `columns`. The folder is made,
   but not those around it. DEM_ERROR_FILE when not all could be written. */
int dem_table_append(const struct dem_table *, const struct dem *, const char *columns,
                     const char *rows);

/* Rows of lost.csv: n losses of dem_lost, with `offset` [s] added to their times; patch[k] is added
   to the cause, unless patch is NULL. */
int dem_table_add_losses(const struct dem_table *, const struct dem *, int64_t n,
                         const struct dem_loss *, double offset, const char *const *patch);

/* Rows of bonds.csv: n bonds of dem_broken_bonds, with `offset` [s] added to their times. */
int dem_table_add_bonds(const struct dem_table *, const struct dem *, int64_t n,
                        const struct dem_broken_bond *, double offset);

/* Sums of streams and outlets at the last rows of flows.csv, for their rates */
struct dem_flow_sums
{
    double time;                                 /* s */
    double particles[DEM_FLOWS], mass[DEM_FLOWS];   /* 1, kg */
};

/* Collective. Set the sums to those of now [s], without rows. */
int dem_flow_sums_set(struct dem_flow_sums *, struct dem *, double now);

/* Collective. Rows of flows.csv: a row for each stream and outlet with its rates since `last`,
   which becomes now. Written where table is not NULL. */
int dem_table_add_flows(const struct dem_table *, struct dem *, double now,
                        struct dem_flow_sums *last);

/* Collective. Rows of walls.csv: mean forces and torques since `elapsed` [s], when the sums were
   reset, and present ones; the sums are reset. Written where table is not NULL. */
int dem_table_add_walls(const struct dem_table *, struct dem *, double now, double elapsed);

/* Row of energy.csv with n items of dem_energy. */
int dem_table_add_energy(const struct dem_table *, const struct dem *, double now, double since,
                         int n, const struct dem_energy_item *);

#ifdef __cplusplus
}
#endif

#endif
