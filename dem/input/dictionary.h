/*
 * dictionary.h -- reader of OpenFOAM's dictionary syntax: text becomes a tree of named entries with
 * their line numbers.
 *
 *     struct dem_dict *scene = NULL;
 *     const struct dem_dict *glass;
 *     double density;
 *
 *     DEM_TRY(dem_dict_read_file(&scene, "scene.dem"));
 *     DEM_TRY(dem_dict_sub(scene, "glass", &glass));
 *     DEM_TRY(dem_dict_number(glass, "density", "kg/m3", &density));
 *     DEM_TRY(dem_dict_refuse_unread(scene));      an entry that was never read is misspelt
 *     dem_dict_free(scene);                        frees its strings, lists, sub-dictionaries too
 *
 * Syntax: `name value;`, `name { ... }`, words, "strings", numbers, lists ( ... ) with or without a
 * leading count, dictionaries in lists with or without names, dimension sets [ ... ] (skipped), C
 * and C++ comments, $name, ${name}, $dict.sub.name, $..name (one dictionary outward for every dot
 * after the first), $:name (from the top), `$name;` to insert a dictionary, and #include "file"
 * relative to the including file. A later entry replaces an earlier one of its name; dictionaries
 * are merged. A FoamFile header is ignored. In generated text, a line `#line 12 "file"` gives the
 * origin of the line that follows.
 *
 * Reading marks an entry as read, hence threads must not share a tree. Every failure is
 * DEM_ERROR_INPUT (or _FILE, _MEMORY) with file and line.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/settings_table.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct dem_dict;
struct dem_entry;

/* Read a file, or a text (`name` is the file name in messages; a text cannot #include). The caller
   frees *d with dem_dict_free; on failure it is null. */
int dem_dict_read_file(struct dem_dict **d, const char *path);
int dem_dict_read_text(struct dem_dict **d, const char *text, const char *name);

/* Set one entry: `path` is its name behind the names of the dictionaries around it, "effects/dry/restitution",
   which are made where they are missing; `value` a value or { entries }. An entry of this name is
   replaced, a dictionary is merged. The path is the file name in messages. After an error free the
   tree. */
int dem_dict_set(struct dem_dict *d, const char *path, const char *value);
void dem_dict_free(struct dem_dict *d);    /* the top only; null is allowed */

/* Remove the entry of this name from the dictionary d/within, or with `deep` from each
   dictionary in it. False when there was none. */
bool dem_dict_remove(struct dem_dict *d, const char *within, bool deep, const char *name);

/* Remove the entry or dictionary of this path, "walls/gate"; false when there is none. */
bool dem_dict_unset(struct dem_dict *d, const char *path);

/* Does the entry exist? Does not mark it as read. */
bool dem_dict_has(const struct dem_dict *d, const char *name);
/* Is it there, and a dictionary? */
bool dem_dict_has_dict(const struct dem_dict *d, const char *name);

/* Sub-dictionary: an error when it is missing, or (_if) null. */
int dem_dict_sub(const struct dem_dict *d, const char *name, const struct dem_dict **sub);
int dem_dict_sub_if(const struct dem_dict *d, const char *name, const struct dem_dict **sub);

/* One value: an error when it is missing, or (_or) the fallback. `unit` is for the message:
   "kg/m3", "1" for a pure number. */
int dem_dict_number(const struct dem_dict *d, const char *name, const char *unit, double *value);
int dem_dict_number_or(const struct dem_dict *d, const char *name, const char *unit,
                       double fallback, double *value);
int dem_dict_vector(const struct dem_dict *d, const char *name, const char *unit, double value[3]);
int dem_dict_vector_or(const struct dem_dict *d, const char *name, const char *unit,
                       const double fallback[3], double value[3]);
int dem_dict_int64(const struct dem_dict *d, const char *name, int64_t *value);
int dem_dict_int64_or(const struct dem_dict *d, const char *name, int64_t fallback, int64_t *value);
/* A time [s]: a number, or the name of a stage of the scene's `stages`: then *value is infinite and
   *stage its number from 1, else 0. */
int dem_dict_time_or(const struct dem_dict *d, const char *name, double fallback, double *value,
                     int *stage);
/* The entry `last` must come after `first`: as stages, or as times [s]. */
int dem_dict_check_times(const struct dem_dict *d, const char *first, const char *last,
                         const double time[2], const int stage[2]);
/* yes no on off true false */
int dem_dict_switch(const struct dem_dict *d, const char *name, bool *value);
int dem_dict_switch_or(const struct dem_dict *d, const char *name, bool fallback, bool *value);
/* without white space */
int dem_dict_word(const struct dem_dict *d, const char *name, const char **word);
int dem_dict_word_or(const struct dem_dict *d, const char *name, const char *fallback,
                     const char **word);
/* a word or a "string" */
int dem_dict_text(const struct dem_dict *d, const char *name, const char **text);
int dem_dict_text_or(const struct dem_dict *d, const char *name, const char *fallback,
                     const char **text);

/* Lists; they belong to the tree. A list may be empty. For an optional entry call dem_dict_has
   first. */
int dem_dict_numbers(const struct dem_dict *d, const char *name, const char *unit,
                     const double **values, size_t *n);
int dem_dict_int64s(const struct dem_dict *d, const char *name, const int64_t **values, size_t *n);
int dem_dict_vectors(const struct dem_dict *d, const char *name, const char *unit,
                     const double (**values)[3], size_t *n);
int dem_dict_fours(const struct dem_dict *d, const char *name, const char *unit,
                   const double (**values)[4], size_t *n);
int dem_dict_words(const struct dem_dict *d, const char *name, const char *const **words,
                   size_t *n);

/* Fill a struct from its table of settings: defaults, then the entries of d; an error when a
   required setting is missing. */
int dem_dict_settings(const struct dem_dict *d, const struct dem_setting *table, void *settings);

/* Entries in the order of the text. dem_entry_dict and dem_entry_token mark the entry as read, the
   other functions do not. */
size_t dem_dict_count(const struct dem_dict *d);
/* null past the end */
const struct dem_entry *dem_dict_entry(const struct dem_dict *d, size_t i);
const char *dem_entry_name(const struct dem_entry *e);
bool dem_entry_is_dict(const struct dem_entry *e);
const struct dem_dict *dem_entry_dict(const struct dem_entry *e);    /* null for a value */
size_t dem_entry_tokens(const struct dem_entry *e);    /* tokens of the value */
/* The i-th token of the value; null past the end, "{}" for a dictionary in a list. */
const char *dem_entry_token(const struct dem_entry *e, size_t i);
/* The k-th dictionary of a list ( {...} {...} ) of some; null past the end. Marks the entry as read. */
const struct dem_dict *dem_entry_item(const struct dem_entry *e, size_t k);

/* Call read(context, ...) for each dictionary in d/name, in the order of the text; no call when
   d/name does not exist. Stops at the first failure and returns its status. */
int dem_dict_each(const struct dem_dict *d, const char *name,
                  int (*read)(void *, const struct dem_dict *), void *context);

/* The same for d/name that is a dictionary, or a list ( {...} {...} ) of some. */
int dem_dict_each_item(const struct dem_dict *d, const char *name,
                       int (*read)(void *, const struct dem_dict *), void *context);

/* Append a line for each entry of these sections: its path and its value, a long value as its hash; a
   dictionary has a line with {}. Marks nothing as read. */
struct dem_text;
void dem_dict_flatten(const struct dem_dict *d, const char *const *section, int sections,
                      struct dem_text *t);

/* Sentences on entries that are given twice in the same braces of a file, of the whole tree; the
   array belongs to it. */
size_t dem_dict_repeats(const struct dem_dict *d, const char *const **sentences);

/* For messages: name "glass", path "materials/glass", location "scene.dem, line 12". Name and
   path of the top are empty. The texts belong to the tree. */
const char *dem_dict_name(const struct dem_dict *d);
const char *dem_dict_path(const struct dem_dict *d);
const char *dem_dict_where(const struct dem_dict *d);
const char *dem_entry_where(const struct dem_entry *e);

/* DEM_ERROR_INPUT with a message about the first entry, in d or a dictionary inside it, that
   was never read; the known words in it are the names that were requested. dem_dict_mark_read
   marks all of d as read, for entries that other code reads. */
int dem_dict_refuse_unread(const struct dem_dict *d);
void dem_dict_mark_read(const struct dem_dict *d);
