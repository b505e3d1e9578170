/*
 * aliases.h -- words of other DEM codes that mean the same as a word of Suna.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

/* The note about the value (mostly "") when `foreign` is another code's word for `ours`; else null.
   The note belongs to the table. */
const char *dem_alias_note(const char *foreign, const char *ours);

/* 1 if `word` is one of the words separated by blanks. */
int dem_alias_is_among(const char *words, const char *word);
