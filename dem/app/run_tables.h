/*
 * run_tables.h -- tables of `dem run` and their lines in the log: lost particles, broken bonds,
 * streams and outlets, forces on walls.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "app/main.h"
#include "app/output_files.h"
#include "dem_tables.h"

struct dem_run_tables
{
    struct dem_table lost, bonds, flows, walls, cell, residence;
    int64_t removed;                /* particles, in this run */
    struct dem_flow_sums sums;      /* at the last rows of flows.csv */
    double cell_interval;           /* s  between rows of cell.csv, 0: none */
    double wall_interval, wall_since;   /* s  between rows of walls.csv, 0: none; of the last */
};

/* Collective. Tables of an earlier run in the same folder lose their rows that are later than the
   start of this one; effects.csv likewise. */
int dem_run_tables_begin(struct dem_run_tables *, const struct dem_program *,
                         const struct dem_output *, struct dem *);

/* Collective. Print and write the particles lost and the bonds broken since the last call. */
int dem_run_tables_losses(struct dem_run_tables *, const struct dem_program *, struct dem *);

/* Collective. Print a line, and write a row for each stream and outlet. */
int dem_run_tables_flows(struct dem_run_tables *, const struct dem_program *, struct dem *,
                         double now);

/* Collective. Write the rows of walls and of the cell if they are due. */
int dem_run_tables_walls(struct dem_run_tables *, const struct dem_program *, struct dem *,
                         double now);

/* Print a line for each stream and outlet, on the first rank. */
void dem_run_tables_print_flows(const struct dem_program *, struct dem *);

/* Rows are written at integer multiples of an interval [s], so that a restarted run writes the
   same; 0: never. dem_next_due: the time of the next row, or `next` if that is earlier.
   dem_is_due: 1 when a row is due now. */
double dem_next_due(double interval, double now, double next);
int dem_is_due(double interval, double now);
