/*
 * dictionary.h -- a text in OpenFOAM's dictionary syntax becomes a tree that is asked by name and knows its lines.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     struct dem_dict *scene = NULL;
 *     const struct dem_dict *glass;
 *     double density;
 *
 *     DEM_TRY(dem_dict_read_file(&scene, "scene.dem"));
 *     DEM_TRY(dem_dict_sub(scene, "glass", &glass));
 *     DEM_TRY(dem_dict_number(glass, "density", "kg/m3", &density));
 *     DEM_TRY(dem_dict_refuse_unread(scene));      what nobody asked for is a slip of the pen
 *     dem_dict_free(scene);                        also owns every string, list and sub-dictionary handed out
 *
 * Syntax: `name value;`, `name { ... }`, words, "strings", numbers, lists ( ... ) with or without a leading
 * count, dictionaries in lists with or without names, dimension sets [ ... ] (skipped), C and C++ comments,
 * $name, ${name}, $dict.sub.name, $..name (one dictionary out for every dot after the first), $:name (from the
 * top), `$name;` to insert a dictionary, and #include "file" relative to the including file. A later entry
 * replaces an earlier one of its name; dictionaries merge. A FoamFile header is ignored. Where a text was
 * generated, a line of its own `#line 12 "file"` says where the next line really stands.
 *
 * Asking marks an entry as read, hence a tree must not be shared by threads. Every failure is
 * DEM_ERROR_INPUT (or _FILE, _MEMORY) with file and line.
 */
#ifndef DEM_IO_DICTIONARY_H
#define DEM_IO_DICTIONARY_H

#include "base/field.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct dem_dict;
struct dem_entry;

/* Read a file, or a text (name stands for the file in errors; a text may not #include). On failure *d is null. */
int dem_dict_read_file(struct dem_dict **d, const char *path);
int dem_dict_read_text(struct dem_dict **d, const char *text, const char *name);

/* Merge a further text into a tree, as if it stood at the end of the first one. After an error free the tree: the
   entries before the error are in it. */
int dem_dict_read_more(struct dem_dict *d, const char *text, const char *name);
void dem_dict_free(struct dem_dict *d);    /* the top only; null is fine */

/* Take out the entry of this name from the dictionary d/within, and with `deep` from each dictionary in that. False when there was none. */
bool dem_dict_remove(struct dem_dict *d, const char *within, bool deep, const char *name);

/* Is there such an entry? Does not count as reading it. */
bool dem_dict_has(const struct dem_dict *d, const char *name);

/* Sub-dictionary: must be there, or (_if) null when absent. */
int dem_dict_sub(const struct dem_dict *d, const char *name, const struct dem_dict **sub);
int dem_dict_sub_if(const struct dem_dict *d, const char *name, const struct dem_dict **sub);

/* One value: must be there, or (_or) the fallback when absent. unit is for the sentence: "kg/m3", "1" for none. */
int dem_dict_number(const struct dem_dict *d, const char *name, const char *unit, double *value);
int dem_dict_number_or(const struct dem_dict *d, const char *name, const char *unit, double fallback,
                       double *value);
int dem_dict_vector(const struct dem_dict *d, const char *name, const char *unit, double value[3]);
int dem_dict_vector_or(const struct dem_dict *d, const char *name, const char *unit, const double fallback[3],
                       double value[3]);
int dem_dict_int64(const struct dem_dict *d, const char *name, int64_t *value);
int dem_dict_int64_or(const struct dem_dict *d, const char *name, int64_t fallback, int64_t *value);
int dem_dict_switch(const struct dem_dict *d, const char *name, bool *value);    /* yes no on off true false */
int dem_dict_switch_or(const struct dem_dict *d, const char *name, bool fallback, bool *value);
int dem_dict_word(const struct dem_dict *d, const char *name, const char **word);    /* without white space */
int dem_dict_word_or(const struct dem_dict *d, const char *name, const char *fallback, const char **word);
int dem_dict_text(const struct dem_dict *d, const char *name, const char **text);    /* a word or a "string" */
int dem_dict_text_or(const struct dem_dict *d, const char *name, const char *fallback, const char **text);

/* Lists; they live as long as the tree. A list may be empty; ask dem_dict_has first if the entry is optional. */
int dem_dict_numbers(const struct dem_dict *d, const char *name, const char *unit, const double **values,
                     size_t *n);
int dem_dict_int64s(const struct dem_dict *d, const char *name, const int64_t **values, size_t *n);
int dem_dict_vectors(const struct dem_dict *d, const char *name, const char *unit, const double (**values)[3],
                     size_t *n);
int dem_dict_words(const struct dem_dict *d, const char *name, const char *const **words, size_t *n);
int dem_dict_dicts(const struct dem_dict *d, const char *name, const struct dem_dict *const **dicts, size_t *n);

/* Fill a struct from its table of fields: defaults, then what is written here, then what is missing is refused. */
int dem_dict_fields(const struct dem_dict *d, const struct dem_field *fields, void *settings);

/* Entries in the order of the text. Taking an entry's dictionary or a token counts as reading it, looking does not. */
size_t dem_dict_count(const struct dem_dict *d);
const struct dem_entry *dem_dict_entry(const struct dem_dict *d, size_t i);    /* null past the end */
const char *dem_entry_name(const struct dem_entry *e);
bool dem_entry_is_dict(const struct dem_entry *e);
const struct dem_dict *dem_entry_dict(const struct dem_entry *e);              /* null for a value */
size_t dem_entry_tokens(const struct dem_entry *e);                            /* how many the value has */
const char *dem_entry_token(const struct dem_entry *e, size_t i);              /* null past the end, "{}" for a
                                                                                  dictionary in a list */

/* Call `read` for each dictionary in d/name, in the order of the text; nothing when d/name is absent. */
int dem_dict_each(const struct dem_dict *d, const char *name, int (*read)(void *, const struct dem_dict *), void *with);

/* Places for sentences: "glass", "materials/glass", "scene.dem, line 12". Name and path of the top are empty. */
const char *dem_dict_name(const struct dem_dict *d);
const char *dem_dict_path(const struct dem_dict *d);
const char *dem_dict_where(const struct dem_dict *d);
const char *dem_entry_where(const struct dem_entry *e);

/* Fail with a sentence about the first entry, here or further in, that nobody read. The known words are those
   that were asked for. accept marks all of d as read: somebody else reads it. */
int dem_dict_refuse_unread(const struct dem_dict *d);
void dem_dict_accept(const struct dem_dict *d);

#endif
