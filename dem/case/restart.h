/*
 * restart.h -- a restart with a scene that differs from the snapshot's. What the snapshot
 * holds wins; every difference is a sentence, which dem_warnings lists.
 *
 *   groups of insert    new ones are inserted at the restart; the snapshot's are not inserted again
 *   walls               go on from where they stood, with the motion of the scene from then on, and
 *                       with their wear
 *   periodic axes       a change is refused: contacts cross their faces
 *   all else            applies from then on
 *
 * Used by setup.c and setup_particles.c, in this order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "case/dem_case.h"
#include "core/text.h"

/* Collective, when the particles of the snapshot have been read: read its scene and compare. Only new
   groups and new particles of the program stay in the case. */
int dem_sim_compare_scene(struct dem_case *);

/* Collective, when the walls are finished: insert the new groups. */
int dem_sim_insert_new_groups(struct dem_case *);

/* When the scenes have been compared and before the walls are finished: walls whose form is the same go
   on from where they stood. */
int dem_sim_resume_walls(struct dem_case *);

/* 1: wall k goes on from the snapshot; 0: it is new, or has another form. */
int dem_sim_wall_goes_on(const struct dem_case *, int k);

/* Append the lines of a snapshot's scene text that hold compound motions at a time [s]. */
void dem_sim_describe_motions(const struct dem_walls *, double time, struct dem_text *);

/* New numbers of the facets of the snapshot's walls; the caller frees map->wall. */
int dem_sim_map_facets(struct dem_case *, struct dem_snapshot_facets *);

/* On the first rank, when the walls are finished: walls that keep their triangles keep their wear. */
int dem_sim_resume_wear(struct dem_case *);

/* Add a sentence. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
int dem_sim_note(struct dem *, const char *format, ...);
