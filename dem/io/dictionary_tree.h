/*
 * dictionary_tree.h -- what the files dictionary*.c share: the tree itself, its memory, the scanner, macros.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Everything of one tree comes from one pool and goes with it: no piece is freed alone, so a list that was
 * replaced or inserted elsewhere stays valid. Others include dictionary.h.
 */
#ifndef DEM_IO_DICTIONARY_TREE_H
#define DEM_IO_DICTIONARY_TREE_H

#include "io/dictionary.h"

enum dem_token_kind
{
    DEM_TOKEN_END,       /* of the text                                      */
    DEM_TOKEN_WORD,      /* not quoted: a word or a number                   */
    DEM_TOKEN_STRING,    /* was quoted                                       */
    DEM_TOKEN_SIGN,      /* one of ( ) [ ] { } ;                             */
    DEM_TOKEN_DICT       /* a dictionary inside a list                       */
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
    bool used;
    struct dem_dict *dict;        /* null for a value  */
    struct dem_dict *home;        /* where it stands   */
    struct dem_token *tokens;     /* of a value        */
    size_t count, room;
    size_t items;                 /* dictionaries among the tokens */
};

struct dem_dict
{
    const char *name, *file;
    const char *list;             /* name of the list this is an item of, or null */
    size_t item;                  /* its place there                               */
    int line;
    struct dem_dict *parent;      /* null at the top */
    struct dem_pool *pool;
    struct dem_entry **entries;
    size_t count, room;
    struct dem_questions *questions;
};

/* Every name anybody asked a dictionary for: the words known there. */
struct dem_questions
{
    const char **names;
    size_t count, room;
};

/* Memory of one tree. */
int dem_dict_take(struct dem_pool *pool, size_t size, void **p);    /* zeroed, aligned for anything */
int dem_dict_take_text(struct dem_pool *pool, const char *text, size_t length, const char **copy);
int dem_dict_take_room(struct dem_pool *pool, void **array, size_t *room, size_t count, size_t size);

/* The tree. An entry is made loose, then put in place of the one of its name; put_dict keeps a dictionary that is
   there. Names and files must come from the pool. */
int dem_dict_new_top(struct dem_dict **d, const char *file);
int dem_dict_new(struct dem_dict *parent, const char *name, const char *file, int line, struct dem_dict **d);
struct dem_entry *dem_dict_find(const struct dem_dict *d, const char *name, size_t length);
int dem_dict_new_entry(struct dem_dict *home, const char *name, const char *file, int line, struct dem_entry **e);
int dem_dict_put(struct dem_entry *e);
int dem_dict_put_dict(struct dem_dict *d, const char *name, const char *file, int line, struct dem_dict **sub);
int dem_dict_append(struct dem_entry *e, struct dem_token token);
int dem_dict_new_item(struct dem_entry *list, const char *name, const char *file, int line, struct dem_dict **item);
int dem_dict_append_copies(struct dem_entry *e, const struct dem_entry *from, int line);
int dem_dict_merge(struct dem_dict *into, const struct dem_dict *from);    /* copies; neither holds the other */

/* Print tokens on one line, cut with "..." to fit, into out[size]. */
void dem_dict_print(const struct dem_token *tokens, size_t count, char *out, size_t size);

/* Asking: an entry that must be there; the unread one whose name looks like a slip for it; the sentence about one
   that is not what was wanted. */
void dem_dict_remember_question(const struct dem_dict *d, const char *name);
int dem_dict_need(const struct dem_dict *d, const char *name, const char *unit, const struct dem_entry **e);
const struct dem_entry *dem_dict_slip(const struct dem_dict *d, const char *name);    /* or null */
int dem_dict_refuse_value(const struct dem_entry *e, const char *wants, const char *unit);

/* Where a reader of a value stands. Each take moves on and says true, or leaves it where it is. */
struct dem_cursor
{
    const struct dem_token *at, *end;
};
bool dem_dict_take_sign(struct dem_cursor *c, char sign);
bool dem_dict_take_number(struct dem_cursor *c, double *value);
bool dem_dict_take_vector(struct dem_cursor *c, double value[3]);
bool dem_dict_take_word(struct dem_cursor *c, const char **word);
void dem_dict_skip_dimensions(struct dem_cursor *c);    /* [0 1 -1 0 0 0 0], also with a name before it */

/* The scanner: text to tokens. */
struct dem_scan
{
    const char *at, *end, *file;
    int line;
    struct dem_pool *pool;
};
void dem_dict_scan_start(struct dem_scan *s, const char *text, size_t length, const char *file,
                         struct dem_pool *pool);
int dem_dict_scan(struct dem_scan *s, struct dem_token *token);
int dem_dict_scan_line_mark(struct dem_scan *s);    /* after the word #line: the rest of that line */

/* The reader: entries up to the } that closes d (opened: the line of its {) or to the end of the file (opened: 0). */
enum
{
    DEM_DICT_DEEPEST = 64    /* nested brackets or dictionaries: far beyond use, and kind to the stack */
};

struct dem_reader
{
    struct dem_scan scan;
    int depth;               /* of dictionaries */
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

/* The entry that "$name" means when written in here; an error when there is none. */
int dem_dict_macro(const struct dem_dict *here, const char *file, const struct dem_token *token,
                   const struct dem_entry **e);

#endif
