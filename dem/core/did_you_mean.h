/*
 * did_you_mean.h -- error message for an unknown word: the nearest known word and all known words.
 *
 *     unknown effect "hertzz"; did you mean hertz? known: hertz, hooke, mindlin, ...
 *
 * Nearness is the number of letters to insert, delete, substitute or swap with a neighbour,
 * whatever their case (Damerau, Commun. ACM 7 (1964) 171, in the restricted form where no letter
 * moves twice). The word that another code uses for it (core/aliases.h) has distance 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

/* The known word nearest to `word`, or null when none is near enough to be a misspelling. */
const char *dem_did_you_mean_nearest(const char *word, const char *const *known, int n);

/* Always fails with DEM_ERROR_INPUT and a message that lists the n known words, nearest first.
   `what` names the kind of word: "effect", "setting". */
int dem_did_you_mean_error(const char *what, const char *word, const char *const *known, int n);

/* The same, with the words that other codes use for each known word: aliases[i], separated by
   blanks, or NULL. `aliases` NULL: only core/aliases.h. */
int dem_did_you_mean_alias_error(const char *what, const char *word, const char *const *known,
                                 const char *const *aliases, int n);
