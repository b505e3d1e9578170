/*
 * unknown.h -- a word nobody knows gets an answer: the word that was probably meant, and all that are known.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     unknown effect "hertzz"; did you mean hertz? known: hertz, hooke, mindlin, ...
 *
 * Nearness is the number of letters to insert, remove, change or swap with a neighbour, whatever their case
 * (Damerau, Commun. ACM 7 (1964) 171, in the restricted form where no letter moves twice). What another code calls it
 * (base/habits.h) is nearest of all.
 */
#ifndef DEM_BASE_UNKNOWN_H
#define DEM_BASE_UNKNOWN_H

/* The known word nearest to word, or null when none is near enough to be a slip of the pen. */
const char *dem_unknown_nearest(const char *word, const char *const *known, int n);

/* Always fails with DEM_ERROR_INPUT and a sentence that lists the known words, nearest first. */
int dem_unknown_word(const char *what, const char *word, const char *const *known, int n);

#endif
