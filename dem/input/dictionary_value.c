/*
 * dictionary_value.c -- parse the value of an entry, from its first word to its semicolon, with
 * matched brackets.
 *
 * A value is stored as its tokens: only the caller that reads it knows whether it is a number or a
 * list of vectors. The commonest mistake is a missing semicolon. It shows as a { or } inside a
 * value, or as a value of several lines, and the message names it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary_tree.h"

#include "core/error.h"

#include <stdio.h>
#include <string.h>

struct opened
{
    char close;
    int line;
};

/* The entry with the first words of its value, for a message. */
static const char *so_far(const struct dem_entry *e, size_t count, char out[80])
{
    const size_t n = strlen(e->name);
    char value[48];

    dem_dict_print(e->tokens, count, value, sizeof value);
    snprintf(out, 80, "%.24s%s%s%s", e->name, n > 24 ? "..." : "", count > 0 ? " " : "", value);
    return out;
}

/* The line where the first words of the value end. */
static int last_line(const struct dem_entry *e, size_t count)
{
    return count > 0 ? e->tokens[count - 1].line : e->line;
}

/* { or } inside a value. The last word before { is probably the name of a dictionary. */
static int refuse_brace(const struct dem_reader *r, const struct dem_entry *e,
                        const struct dem_token *t)
{
    const size_t count = t->text[0] == '{' && e->count > 0 ? e->count - 1 : e->count;
    char text[80];

    if (t->text[0] == '{' && count == 0)
    {
        return dem_error(DEM_ERROR_INPUT,
                         "%s, line %d: { cannot follow \"%s\"; a dictionary has one name: name { "
                         "... }",
                         r->scan.file, t->line, so_far(e, e->count, text));
    }
    return dem_error(DEM_ERROR_INPUT,
                     "%s, line %d: found %s in the value of %s, expected ; after \"%s\"; end line "
                     "%d with ;",
                     r->scan.file, t->line, t->text, e->name, so_far(e, count, text),
                     last_line(e, count));
}

/* An item of a list: { ... }, and the word before it, if it stands in the same list, is its
   name. */
static int read_item(struct dem_reader *r, struct dem_entry *e, const struct dem_token *brace)
{
    const struct dem_token *before = &e->tokens[e->count - 1];
    const char *name = "";
    struct dem_dict *item;

    if (dem_dict_is_name(before))
    {
        name = before->text;
        e->count--;
    }
    DEM_TRY(dem_dict_new_item(e, name, r->scan.file, brace->line, &item));
    return dem_dict_read_entries(r, item, brace->line);
}

/* `$name` in a value: insert its words, or in a list a copy of its dictionary. */
static int insert_value(struct dem_reader *r, struct dem_entry *e, const struct dem_token *t,
                        bool in_list)
{
    const struct dem_entry *from;

    DEM_TRY(dem_dict_macro(e->parent, r->scan.file, t, &from));
    if (!from->dict)
    {
        return dem_dict_append_copies(e, from, t->line);
    }

    struct dem_dict *item;

    DEM_REQUIRE(in_list, DEM_ERROR_INPUT,
                "%s, line %d: %s is a dictionary, and %s takes a value; write %s { %s; } to insert "
                "it",
                r->scan.file, t->line, t->text, e->name, e->name, t->text);
    DEM_TRY(dem_dict_new_item(e, "", r->scan.file, t->line, &item));
    return dem_dict_merge(item, from->dict);
}

static int close_bracket(const struct dem_reader *r, const struct dem_token *t,
                         const struct opened *open, int *depth)
{
    DEM_REQUIRE(*depth > 0, DEM_ERROR_INPUT, "%s, line %d: found %s that nothing opened; remove it",
                r->scan.file, t->line, t->text);
    DEM_REQUIRE(open[*depth - 1].close == t->text[0], DEM_ERROR_INPUT,
                "%s, line %d: found %s, expected %c to close what line %d opened", r->scan.file,
                t->line, t->text, open[*depth - 1].close, open[*depth - 1].line);
    (*depth)--;
    return DEM_OK;
}

static int open_bracket(const struct dem_reader *r, const struct dem_token *t, struct opened *open,
                        int *depth)
{
    DEM_REQUIRE(*depth < DEM_DICT_MAX_DEPTH, DEM_ERROR_INPUT,
                "%s, line %d: more than %d brackets are open here; close some", r->scan.file,
                t->line, DEM_DICT_MAX_DEPTH);
    open[*depth] = (struct opened){.close = t->text[0] == '(' ? ')' : ']', .line = t->line};
    (*depth)++;
    return DEM_OK;
}

/* The value ends too early: at the end of the file, or at ; or } inside brackets. */
static int refuse_end(const struct dem_reader *r, const struct dem_entry *e,
                      const struct dem_token *t, const struct opened *open)
{
    char text[80];

    if (open)
    {
        return dem_error(DEM_ERROR_INPUT,
                         "%s, line %d: found %s, expected %c to close what line %d opened in %s",
                         r->scan.file, t->line, t->text, open->close, open->line, e->name);
    }
    return dem_error(DEM_ERROR_INPUT,
                     "%s, line %d: found end of file, expected ; after \"%s\"; end line %d with ;",
                     r->scan.file, t->line, so_far(e, e->count, text), last_line(e, e->count));
}

/* One token of a value; depth counts the open brackets. */
static int read_token(struct dem_reader *r, struct dem_entry *e, const struct dem_token *t,
                      struct opened *open, int *depth)
{
    const bool in_list = *depth > 0 && open[*depth - 1].close == ')';

    if (t->kind == DEM_TOKEN_WORD && t->text[0] == '$')
    {
        return insert_value(r, e, t, in_list);
    }
    DEM_REQUIRE(t->kind != DEM_TOKEN_WORD || t->text[0] != '#', DEM_ERROR_INPUT,
                "%s, line %d: %s cannot stand inside the value of %s; put it on a line of its own, "
                "between entries, or in quotes if it is a text",
                r->scan.file, t->line, t->text, e->name);
    if (dem_dict_is_sign(t, '{') && in_list)
    {
        return read_item(r, e, t);
    }
    if (dem_dict_is_sign(t, '{') || (dem_dict_is_sign(t, '}') && *depth == 0))
    {
        return refuse_brace(r, e, t);
    }
    if (dem_dict_is_sign(t, '}') || dem_dict_is_sign(t, ';') || t->kind == DEM_TOKEN_END)
    {
        return refuse_end(r, e, t, *depth > 0 ? &open[*depth - 1] : NULL);
    }
    if (dem_dict_is_sign(t, '(') || dem_dict_is_sign(t, '['))
    {
        DEM_TRY(open_bracket(r, t, open, depth));
    }
    else if (t->kind == DEM_TOKEN_SIGN)
    {
        DEM_TRY(close_bracket(r, t, open, depth));
    }
    return dem_dict_append(e, *t);
}

/* `name $dict;` makes a dictionary; everything else is a value from token t to the semicolon. */
int dem_dict_read_value(struct dem_reader *r, struct dem_entry *e, struct dem_token t)
{
    struct opened open[DEM_DICT_MAX_DEPTH];
    int depth = 0;

    if (t.kind == DEM_TOKEN_WORD && t.text[0] == '$')
    {
        const struct dem_entry *from;
        struct dem_scan ahead = r->scan;
        struct dem_token next;

        DEM_TRY(dem_dict_macro(e->parent, r->scan.file, &t, &from));
        DEM_TRY(dem_dict_scan(&ahead, &next));
        if (from->dict && dem_dict_is_sign(&next, ';'))
        {
            r->scan = ahead;
            DEM_TRY(dem_dict_new(e->parent, e->name, e->file, e->line, &e->dict));
            DEM_TRY(dem_dict_merge(e->dict, from->dict));
            return dem_dict_put(e);
        }
    }
    while (!(depth == 0 && dem_dict_is_sign(&t, ';')))
    {
        DEM_TRY(read_token(r, e, &t, open, &depth));
        DEM_TRY(dem_dict_scan(&r->scan, &t));
    }
    return dem_dict_put(e);
}
