/*
 * spring_kinds.h -- what a history column holds, for contacts that share a surface (facet_springs.h).
 *
 * A vector is a history of three consecutive names of which the first ends in _x. The history of
 * effects of the stages BOND and FILM stays with the facet where it was made.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

struct dem_interaction_table;

enum dem_spring_kind
{
    DEM_SPRING_OWN,        /* of a bond or a film: stays with its facet */
    DEM_SPRING_NUMBER,
    DEM_SPRING_VECTOR,     /* and the next two columns */
    DEM_SPRING_REST        /* of a vector */
};

/* The kind of each history column; DEM_HISTORY_COLUMNS numbers. */
void dem_spring_kinds(const struct dem_interaction_table *, enum dem_spring_kind *);
