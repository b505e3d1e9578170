/*
 * dictionary_tree.h -- internal interface of the files dictionary*.c: tree, memory pool, scanner,
 * macros.
 *
 * All memory of a tree comes from one pool and is freed with it. No part is freed alone, so a list
 * that was replaced or inserted elsewhere stays valid. Other files include dictionary.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/name_index.h"
#include "input/dictionary.h"

enum dem_token_kind
{
    DEM_TOKEN_END,     /* of the text */
    DEM_TOKEN_WORD,    /* not quoted: a word or a number */
    DEM_TOKEN_STRING,  /* was quoted */
    DEM_TOKEN_SIGN,    /* one of ( ) [ ] { } ; */
    DEM_TOKEN_DICT     /* a dictionary inside a list */
};

struct dem_token
{
    const char *text;
    struct dem_dict *dict;
    int line;
    enum dem_token_kind kind;
};

struct dem_entry
{
    const char *name, *file;
    int line;
    int block, block_line;     /* braces of a file in which it was read last, and its line there */
    bool used;
    struct dem_dict *dict;     /* null for a value */
    struct dem_dict *parent;   /* contains the entry */
    size_t place, number;      /* index among the entries of the parent, of the tree */
    struct dem_token *tokens;  /* of a value */
    size_t count, capacity;
    size_t items;              /* dictionaries among the tokens */
};

struct dem_dict
{
    const char *name, *file;
    const char *list;         /* name of the list that contains this dictionary, or null */
    size_t item;              /* index in that list */
    int line;
    struct dem_dict *parent;  /* null at the top */
    struct dem_dict_pool *pool;
    struct dem_entry **entries;
    size_t count, capacity;
    struct dem_dict_known_names *known_names;
};

/* Every name that was requested from a dictionary: its known words. */
struct dem_dict_known_names
{
    const char **names;
    size_t count, capacity;
};

/* Memory of one tree. A chunk begins with the pointer to the previous one. */
struct dem_dict_pool
{
    const char **repeats;    /* sentences on entries given twice */
    size_t repeat_count, repeat_capacity;
    struct dem_entry **entry;       /* all of the tree; null: removed */
    size_t entries, entry_capacity;
    struct dem_name_index names;    /* of these */
    char *chunk;
    size_t used, capacity;  /* of the chunk [byte] */
    size_t copies;          /* made by macros so far */
    size_t files, bytes;    /* included so far */
    int blocks;             /* braces opened so far, and files */
    bool failed;            /* there was no memory for a chunk */
};

/* dem_dict_pool_alloc: zeroed, aligned for any type. dem_dict_pool_grow makes an array hold count
   elements and keeps its contents. */
int dem_dict_pool_alloc(struct dem_dict_pool *pool, size_t size, void **p);
int dem_dict_pool_copy(struct dem_dict_pool *pool, const char *text, size_t length,
                       const char **copy);
int dem_dict_pool_grow(struct dem_dict_pool *pool, void **array, size_t *capacity, size_t count,
                       size_t size);

void dem_dict_pool_free(struct dem_dict_pool *pool);

/* Count an included file, or an entry or word that a macro copies; an error beyond the limits of one
   tree. */
int dem_dict_count_file(struct dem_dict_pool *pool, size_t bytes);
int dem_dict_count_copy(struct dem_dict_pool *pool);

/* The tree. An entry is first created outside the dictionary (new), then added in place of the
   one of its name (put); put_dict keeps an existing dictionary. Names and files must come from
   the pool. */
int dem_dict_new_top(struct dem_dict **d, const char *file);
int dem_dict_new(struct dem_dict *parent, const char *name, const char *file, int line,
                 struct dem_dict **d);
struct dem_entry *dem_dict_find(const struct dem_dict *d, const char *name, size_t length);
int dem_dict_new_entry(struct dem_dict *parent, const char *name, const char *file, int line,
                       struct dem_entry **e);
int dem_dict_put(struct dem_entry *e);
bool dem_dict_remove_entry(struct dem_dict *d, const char *name);    /* false: there is none */
int dem_dict_put_dict(struct dem_dict *d, const char *name, const char *file, int line,
                      struct dem_dict **sub);
int dem_dict_append(struct dem_entry *e, struct dem_token token);
int dem_dict_new_item(struct dem_entry *list, const char *name, const char *file, int line,
                      struct dem_dict **item);
int dem_dict_append_copies(struct dem_entry *e, const struct dem_entry *from, int line);

/* An entry has been read in these braces. When they have one of its name already, a sentence says
   which acts; a repeated entry of an included file, or of other braces that merge, is meant, and so
   is a section of the scene in two parts. */
int dem_dict_note(const struct dem_dict *d, const char *name, const char *file, int line,
                  int block);

/* Add copies of all entries of `from`; neither dictionary may contain the other. */
int dem_dict_merge(struct dem_dict *into, const struct dem_dict *from);

/* Print tokens on one line, cut with "..." to fit, into out[size]. */
void dem_dict_print(const struct dem_token *tokens, size_t count, char *out, size_t size);

/* Look-up: record a requested name; an entry that must exist; the unread entry whose name looks
   like a misspelling of it, or null; the message about a wrong value. */
void dem_dict_add_known_name(const struct dem_dict *d, const char *name);
int dem_dict_require(const struct dem_dict *d, const char *name, const char *unit,
                     const struct dem_entry **e);
const struct dem_entry *dem_dict_find_misspelt(const struct dem_dict *d, const char *name);
int dem_dict_refuse_value(const struct dem_entry *e, const char *expected, const char *unit);

/* Position in the tokens of a value. Each take advances it and returns true, or leaves it
   unchanged. */
struct dem_cursor
{
    const struct dem_token *at, *end;
};
bool dem_dict_take_sign(struct dem_cursor *c, char sign);
bool dem_dict_take_number(struct dem_cursor *c, double *value);
bool dem_dict_take_row(struct dem_cursor *c, int n, double *value);    /* n numbers in ( ) */
bool dem_dict_take_vector(struct dem_cursor *c, double value[3]);
bool dem_dict_take_word(struct dem_cursor *c, const char **word);
/* [0 1 -1 0 0 0 0], maybe with a name in front */
void dem_dict_skip_dimensions(struct dem_cursor *c);
/* refuses those that differ from the unit of the entry */
int dem_dict_check_dimensions(const struct dem_entry *e, const char *unit);

/* The scanner: text to tokens. */
struct dem_scan
{
    const char *at, *end, *file;
    int line;
    struct dem_dict_pool *pool;
};
void dem_dict_scan_start(struct dem_scan *s, const char *text, size_t length, const char *file,
                         struct dem_dict_pool *pool);
int dem_dict_scan(struct dem_scan *s, struct dem_token *token);
int dem_dict_scan_line_mark(struct dem_scan *s);    /* the rest of a line after the word #line */

/* The parser: entries up to the } that closes d (opened: the line of its {) or to the end of
   the file (opened: 0). */
enum
{
    DEM_DICT_MAX_DEPTH = 64  /* nested brackets or dictionaries; limits the use of the stack */
};

struct dem_reader
{
    struct dem_scan scan;
    int depth;  /* of dictionaries */
    int includes;
    bool may_include;
};
int dem_dict_read_entries(struct dem_reader *r, struct dem_dict *d, int opened);
int dem_dict_read_value(struct dem_reader *r, struct dem_entry *e, struct dem_token first);

bool dem_dict_is_sign(const struct dem_token *t, char sign);
bool dem_dict_is_name(const struct dem_token *t);

/* A finite decimal number and nothing else? Raises no floating-point exception. */
bool dem_dict_is_number(const char *text, double *value);
bool dem_dict_is_whole(const char *text, int64_t *value);

/* The entry that "$name" in the dictionary `here` refers to; an error when there is none. */
int dem_dict_macro(const struct dem_dict *here, const char *file, const struct dem_token *token,
                   const struct dem_entry **e);
