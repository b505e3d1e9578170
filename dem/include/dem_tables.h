/*
 * dem_tables.h -- files that programs around the library write: CSV tables of a run, averages and
 * bonds for ParaView; means of time series; and what a program needs that is stopped by signals or
 * a file and that writes into a folder of its own.
 *
 * dem.h has the rules for return values, ownership and collective calls.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_TABLES_H
#define DEM_TABLES_H

#include "dem_types.h"

#include <signal.h>

#ifdef __cplusplus
extern "C" {
#endif

struct dem;

/* ---- tables of a run ------------------------------------------------------------------------- */

/* CSV tables that grow by rows: lost.csv, bonds.csv, flows.csv, walls.csv, energy.csv, and others
   of the caller; docs/output.md describes their columns. The first line has the names of the
   columns; the file is made with the first row, and effects.csv beside it names the effects of the
   run. What follows is called on one rank, unless it says collective. */
/* a table of a run: dem_table_name */
struct dem_table
{
    char folder[512], path[640];
    double start;     /* s  time at which the run starts */
};

/* Name a table, for example "lost.csv" in a folder. Touches no file. The calls below refuse a
   folder whose path is too long. */
void dem_table_name(struct dem_table *, const char *folder, const char *file, double start);

/* Before the first row: what an earlier run may have left. The file is removed if the run starts at
   0 or time_column is negative; else the rows with a time after the start are, the number in
   time_column (from 0). */
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

enum
{
    DEM_FLOWS = 64    /* limit of streams and outlets; a scene may have fewer */
};

/* sums of streams and outlets at the last rows of flows.csv, for their rates */
struct dem_flow_sums
{
    double time;                                    /* s */
    double particles[DEM_FLOWS], mass[DEM_FLOWS];   /* 1, kg */
};

/* Collective. Set the sums to their values at the time `now` [s], without rows. */
int dem_flow_sums_set(struct dem_flow_sums *, struct dem *, double now);

/* Collective. Rows of flows.csv: a row for each stream and outlet with its rates since `last`,
   which becomes now. Written where table is not NULL. */
int dem_table_add_flows(const struct dem_table *, struct dem *, double now,
                        struct dem_flow_sums *last);

/* Collective. Rows of walls.csv: mean forces and torques since `elapsed` [s], when the sums were
   reset, and present ones; the sums are reset. Written where table is not NULL. */
int dem_table_add_walls(const struct dem_table *, struct dem *, double now, double elapsed);

/* Rows of residence.csv, one for each outlet with the entry `residence`. */
int dem_table_add_residence(const struct dem_table *, struct dem *, double now);

/* Collective. Row of cell.csv: dem_cell. Written where table is not NULL. */
int dem_table_add_cell(const struct dem_table *, struct dem *, double now);

/* Row of energy.csv with n items of dem_energy. */
int dem_table_add_energy(const struct dem_table *, const struct dem *, double now, double since,
                         int n, const struct dem_energy_item *);

/* ---- effects behind results ------------------------------------------------------------------ */

/* The comment at the head of result files: "effects: " and dem_effect_names. Valid until the run is
   freed. */
const char *dem_heading(const struct dem *);

/* By one rank. Enter the active effects into FOLDER/effects.csv, for the CSV tables
   beside it, which have no comments: they act in a run that starts at this time [s]. The rows of an
   earlier run from then on are removed; no row is added while its effects are those above. The
   folder must exist. */
int dem_effects_record(const struct dem *, const char *folder, double start);

/* ---- averages, bonds ------------------------------------------------------------------------- */

/* Averages on the grids of the scene's `averages`, also of particle scalars, sampled during
   dem_advance. dem_averages: the first rank writes NAME.csv and NAME.vti of each grid that has
   samples into the folder, which must exist. All ranks call it; only the first can fail. */
int dem_averages_count(const struct dem *);
int dem_averages(struct dem *, const char *folder);

/* Collective. Write the intact bonds for ParaView: a line between partners, in FOLDER/FILE, and
   its entry for this time [s] in FOLDER/bonds.pvd. The folder must exist. */
int dem_bonds_draw(struct dem *, const char *folder, const char *file, double time);

/* Collective. Write the triangles of the walls that are present to FOLDER/FILE for ParaView, with the depth of
   wear [m] if a wall wears, and an entry for this time [s] to FOLDER/walls.pvd, unless it is NaN. The folder
   must exist. dem_walls_wear: 1 if a wall wears. */
int dem_walls_draw(struct dem *, const char *folder, const char *file, double time);
int dem_walls_wear(const struct dem *);

/* ---- means of time series -------------------------------------------------------------------- */

/* Means of many time series with 95 % intervals by block means (core/block_means.h); needs no
   simulation. `columns` numbers a sample, with a weight > 0 such as the time step; free with
   dem_means_free. DEM_ERROR_MEMORY when the blocks do not fit. */
struct dem_means;
int dem_means_create(struct dem_means **, size_t columns);
void dem_means_add(struct dem_means *, const double *sample, double weight);
void dem_means_free(struct dem_means *);    /* NULL is allowed */

/* The mean of each column and half the width of its interval; NaN with fewer than
   DEM_MEANS_MIN_BLOCKS full blocks, whose number is returned. */
int dem_means_get(const struct dem_means *, double *mean, double *half_width);

/* ---- signals, stop file, lock ---------------------------------------------------------------- */

enum
{
    DEM_STOP_FILE = 1000    /* asked to stop by a file; other numbers are signals */
};

/* Catch SIGTERM, SIGUSR1 and SIGINT from now on, except the signals in `except` (NULL for none).
   Returns where the number of the last one is stored, 0 before the first. A second SIGINT ends the
   program. */
const volatile sig_atomic_t *dem_catch_signals(const int *except, int exceptions);
const char *dem_signal_name(int signal);                  /* of these and DEM_STOP_FILE; else "" */

/* Take signals of dem_catch_signals back from a library that has put a handler of its own there. */
void dem_keep_signals(void);

/* A stop for a run that signals do not reach: a file, as a rule `stop` in the run's folder.
   dem_stop_file_look, between two steps on one rank, also in the function of dem_set_progress: look
   for it, at most once a second of the clock; when it is there, remove it and store DEM_STOP_FILE
   where dem_catch_signals stores the number of a signal. dem_stop_file_clear, before the first
   step: remove one that was there before; *found: 1 when it was. An error when it is there and
   cannot be removed. */
int dem_stop_file_clear(const char *path, int *found);
void dem_stop_file_look(const char *path);

/* Where the number of a second request is stored, a signal or the file, that comes two seconds or
   more after the first: stop without waiting. 0 before. Needs no simulation. */
const volatile sig_atomic_t *dem_repeated_signal(void);

/* a folder that one run at a time writes into */
struct dem_folder_lock
{
    int file;               /* descriptor; 0: not locked */
    char path[640];
    char before[300];       /* "process 123 on host box" of a run that has left its lock; or "" */
};

/* On one rank: lock a folder, which must exist, by a file `lock` with process and host. The kernel
   frees the lock of a process that has been killed; the next run takes the file over, and `before`
   names the process. DEM_ERROR_STATE when another run has the folder. dem_folder_unlock removes
   the file; it does nothing without a lock. */
int dem_folder_lock(struct dem_folder_lock *, const char *folder);
void dem_folder_unlock(struct dem_folder_lock *);

#ifdef __cplusplus
}
#endif
#endif
