/*
 * wall_wear.h -- volume that particles wear off each triangle of a wall.
 *
 *   V = sum k/H F_n |v_t| dt      archard: in each step                                    [m3]
 *   V = sum k/H m f(v_n, v_t)     finnie: in the step in which a contact begins
 *
 *   f = 2 v_n v_t - 3 v_n^2  where 3 v_n <= v_t, else v_t^2/3                               [m2/s2]
 *
 *   k      coefficient of wear of the wall                                                 [1]
 *   H      its hardness                                                                    [Pa]
 *   F_n    normal force of a contact, where it presses                                     [N]
 *   v_t    velocity of the particle's surface along the wall's, in the middle of a step;
 *          finnie: of its centre                                                           [m/s]
 *   m, v_n mass of the particle (of its clump); its speed towards the wall                 [kg], [m/s]
 *
 * A contact wears the triangle on which it is. The wall keeps its form.
 *
 * f is largest, v^2 (sqrt(13) - 3)/2, at tan 2a = 2/3 (16.8 degrees between path and wall). In Finnie's
 * terms k = c/(psi K) with K = 2 and H his flow stress p.
 *
 * Sources: Archard, J. Appl. Phys. 24 (1953) 981; Finnie, Wear 3 (1960) 87.
 *
 * Terms are rounded to 2^-120 m3 (8e-37 m3) and summed as integers, so the sums do not depend on ranks and
 * order. A snapshot holds them in the text of its scene, in a line for each wall that wears:
 *
 *   @wear NAME TRIANGLE DIGIT DIGIT DIGIT DIGIT TRIANGLE ...
 *
 * Triangles are counted from 0 within the wall; the lowest digit comes first.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/contact_batch.h"
#include "core/text.h"
#include <stdint.h>

struct dem_state;

enum
{
    DEM_WEAR_DIGITS = 4
};

struct dem_wear_sum    /* digits of 32 bits, the lowest first; the highest holds the rest */
{
    int64_t digit[DEM_WEAR_DIGITS];
};

/* Make room for the triangles of all walls; none when no wall wears. */
int dem_wall_wear_begin(struct dem_state *);

/* After the effects have acted on the rows of a batch. */
int dem_wall_wear_add(struct dem_state *, const struct dem_contact_workspace *, uint32_t row, int rows);

/* Collective. The volume [m3] worn off each triangle of a wall, on the first rank, in the order of
   dem_wall_corners. */
int dem_wall_wear_volumes(struct dem_state *, int wall, double *volume);

/* Collective. The first rank takes over the sums of all ranks. */
void dem_wall_wear_gather(struct dem_state *);

/* The sums of the last backup hold again. */
void dem_wall_wear_backup(struct dem_state *);
void dem_wall_wear_restore(struct dem_state *);

/* The lines of a snapshot, after dem_wall_wear_gather, on the first rank. */
void dem_wall_wear_describe(const struct dem_state *, struct dem_text *);

/* On the first rank: a wall takes its sums from the text of a snapshot's scene. DEM_ERROR_FILE when its line is
   damaged; `path` names the snapshot. */
int dem_wall_wear_resume(struct dem_state *, int wall, const char *text, const char *path);
