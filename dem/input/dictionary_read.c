/*
 * dictionary_read.c -- parser of dictionaries: builds entries from the tokens of the scanner.
 *
 *   dictionary  { entry }
 *   entry       name value ;  |  name { dictionary }  |  name $dict ;  |  $dict ;  |
 *               #include "file"
 *   value       words, strings, lists ( ... ), dimension sets [ ... ]; in a list also
 *               { dictionary }, with or without a name
 *
 * Every error message gives the file, the line and the correction.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary_tree.h"

#include "core/error.h"
#include "core/memory.h"
#include "core/file.h"

#include <string.h>

enum
{
    MAX_INCLUDES = 16  /* depth of nested includes; a file that includes itself goes deeper */
};

static int read_included(struct dem_reader *r, struct dem_dict *d, const char *path, int line);

static int read_entry(struct dem_reader *r, struct dem_dict *d, const struct dem_token *name,
                      int block)
{
    struct dem_token t;
    struct dem_entry *e;
    struct dem_dict *sub;

    DEM_REQUIRE(!strpbrk(name->text, ",\"\n\r"), DEM_ERROR_INPUT,
                "%s, line %d: the name of this entry has a comma, a quote or a line end, which "
                "would break the rows of tables; use other characters", r->scan.file, name->line);
    DEM_TRY(dem_dict_scan(&r->scan, &t));
    if (dem_dict_is_sign(&t, '{'))
    {
        DEM_TRY(dem_dict_put_dict(d, name->text, r->scan.file, name->line, &sub));
        DEM_TRY(dem_dict_note(d, name->text, r->scan.file, name->line, block));
        return dem_dict_read_entries(r, sub, t.line);
    }
    DEM_TRY(dem_dict_note(d, name->text, r->scan.file, name->line, block));
    DEM_TRY(dem_dict_new_entry(d, name->text, r->scan.file, name->line, &e));
    e->block = block;
    e->block_line = name->line;
    return dem_dict_read_value(r, e, t);
}

/* `$dict;` between entries. Copied first, so that a dictionary may insert a part of itself. */
static int insert_dict(struct dem_reader *r, struct dem_dict *d, const struct dem_token *t)
{
    const struct dem_entry *from;
    struct dem_dict *copy;
    struct dem_token end;

    DEM_TRY(dem_dict_macro(d, r->scan.file, t, &from));
    DEM_REQUIRE(from->dict, DEM_ERROR_INPUT,
                "%s, line %d: %s is a value; only a dictionary can be inserted here. Write name "
                "%s;",
                r->scan.file, t->line, t->text, t->text);
    for (const struct dem_dict *out = d; out; out = out->parent)
    {
        DEM_REQUIRE(out != from->dict, DEM_ERROR_INPUT,
                    "%s, line %d: %s; would insert the dictionary into itself", r->scan.file,
                    t->line, t->text);
    }
    DEM_TRY(dem_dict_scan(&r->scan, &end));
    DEM_REQUIRE(dem_dict_is_sign(&end, ';'), DEM_ERROR_INPUT,
                "%s, line %d: found %s, expected ; after %s; end line %d with ;", r->scan.file,
                end.line, end.text, t->text, t->line);
    DEM_TRY(dem_dict_new(d, "", r->scan.file, t->line, &copy));
    DEM_TRY(dem_dict_merge(copy, from->dict));
    return dem_dict_merge(d, copy);
}

static int read_directive(struct dem_reader *r, struct dem_dict *d, const struct dem_token *t)
{
    struct dem_token path;

    if (strcmp(t->text, "#line") == 0)
    {
        return dem_dict_scan_line_mark(&r->scan);
    }
    DEM_REQUIRE(strcmp(t->text, "#include") == 0, DEM_ERROR_INPUT,
                "%s, line %d: %s is not known here; of OpenFOAM's directives this reader has "
                "#include only",
                r->scan.file, t->line, t->text);
    DEM_REQUIRE(r->may_include, DEM_ERROR_INPUT,
                "%s, line %d: a text passed in memory cannot #include; expand it first",
                r->scan.file, t->line);
    DEM_TRY(dem_dict_scan(&r->scan, &path));
    DEM_REQUIRE(path.kind == DEM_TOKEN_STRING, DEM_ERROR_INPUT,
                "%s, line %d: found %s, expected #include \"file\"", r->scan.file, path.line,
                path.text);
    return read_included(r, d, path.text, t->line);
}

/* Read entries up to the } that closes d, or to the end of the file when `opened` is 0. */
int dem_dict_read_entries(struct dem_reader *r, struct dem_dict *d, int opened)
{
    const char *file = r->scan.file;
    const int block = ++d->pool->blocks;
    struct dem_token t;

    DEM_REQUIRE(++r->depth <= DEM_DICT_MAX_DEPTH, DEM_ERROR_INPUT,
                "%s, line %d: more than %d dictionaries are open here; close some with }", file,
                r->scan.line, DEM_DICT_MAX_DEPTH);
    for (;;)
    {
        DEM_TRY(dem_dict_scan(&r->scan, &t));
        if (opened > 0 ? dem_dict_is_sign(&t, '}') : t.kind == DEM_TOKEN_END)
        {
            break;
        }
        DEM_REQUIRE(t.kind != DEM_TOKEN_END, DEM_ERROR_INPUT,
                    "%s, line %d: found end of file, expected } to close %s%s{ of line %d",
                    r->scan.file, t.line, dem_dict_path(d), *dem_dict_path(d) ? " " : "", opened);
        DEM_REQUIRE(!dem_dict_is_sign(&t, '}'), DEM_ERROR_INPUT,
                    "%s, line %d: found } that no { opened; remove it", r->scan.file, t.line);
        if (dem_dict_is_sign(&t, ';'))
        {
            continue;
        }
        DEM_REQUIRE(t.kind != DEM_TOKEN_SIGN, DEM_ERROR_INPUT,
                    "%s, line %d: found %s, expected the name of an entry; write name value; or "
                    "name { ... }",
                    r->scan.file, t.line, t.text);
        DEM_TRY(dem_dict_is_name(&t) ? read_entry(r, d, &t, block)
                            : t.text[0] == '$' ? insert_dict(r, d, &t) : read_directive(r, d, &t));
    }
    r->depth--;
    return DEM_OK;
}

/* The bytes of a file, stored in the pool. */
static int load(struct dem_dict_pool *pool, const char *path, const char **text, size_t *length)
{
    char *bytes;
    int status;

    DEM_TRY(dem_file_load(path, &bytes, length));
    status = dem_dict_pool_copy(pool, bytes, *length, text);
    dem_memory_free(bytes);
    return status;
}

/* Read path, which is relative to the including file. */
static int read_included(struct dem_reader *r, struct dem_dict *d, const char *path, int line)
{
    const char *slash = path[0] == '/' ? NULL : strrchr(r->scan.file, '/');
    const size_t folder = slash ? (size_t)(slash + 1 - r->scan.file) : 0;
    struct dem_reader inner = {.depth = r->depth, .includes = r->includes + 1, .may_include = true};
    const char *text;
    size_t length;
    char *full;
    void *p;
    int status;

    DEM_REQUIRE(inner.includes <= MAX_INCLUDES, DEM_ERROR_INPUT,
                "%s, line %d: includes are nested more than %d deep; does \"%s\" include itself?",
                r->scan.file, line, MAX_INCLUDES, path);
    DEM_TRY(dem_dict_pool_alloc(d->pool, folder + strlen(path) + 1, &p));
    full = p;
    memcpy(full, r->scan.file, folder);
    memcpy(full + folder, path, strlen(path) + 1);
    status = load(d->pool, full, &text, &length);
    status = status == DEM_OK ? dem_dict_count_file(d->pool, length) : status;
    if (status != DEM_OK)
    {
        return dem_error_prefix(status, "%s, line %d: ", r->scan.file, line);
    }
    dem_dict_scan_start(&inner.scan, text, length, full, d->pool);
    return dem_dict_read_entries(&inner, d, 0);
}

/* Merge a text into d, which may contain entries already. */
static int read_into(struct dem_dict *d, const char *text, size_t length, const char *file,
                     bool may_include)
{
    struct dem_reader r = {.may_include = may_include};
    struct dem_entry *header;

    dem_dict_scan_start(&r.scan, text, length, file, d->pool);
    DEM_TRY(dem_dict_read_entries(&r, d, 0));
    header = dem_dict_find(d, "FoamFile", strlen("FoamFile"));
    if (header && header->dict)
    {
        header->used = true;
        dem_dict_mark_read(header->dict);
    }
    return DEM_OK;
}

static int read_top(struct dem_dict **d, const char *text, size_t length, const char *name,
                    bool is_file)
{
    int status;

    DEM_TRY(dem_dict_new_top(d, name));
    status = is_file ? load((*d)->pool, name, &text, &length) : DEM_OK;
    status = status == DEM_OK ? read_into(*d, text, length, (*d)->file, is_file) : status;
    if (status != DEM_OK)
    {
        dem_dict_free(*d);
        *d = NULL;
    }
    return status;
}

int dem_dict_read_file(struct dem_dict **d, const char *path)
{
    return read_top(d, NULL, 0, path, true);
}

int dem_dict_read_text(struct dem_dict **d, const char *text, const char *name)
{
    return read_top(d, text, strlen(text), name, false);
}

/* A step of a path, which is to be one word. */
static int path_step(struct dem_dict_pool *pool, const char *step, size_t length, const char *path,
                     struct dem_token *name)
{
    struct dem_scan scan;
    struct dem_token end;

    dem_dict_scan_start(&scan, step, length, path, pool);
    DEM_TRY(dem_dict_scan(&scan, name));
    DEM_TRY(dem_dict_scan(&scan, &end));
    DEM_REQUIRE(dem_dict_is_name(name) && end.kind == DEM_TOKEN_END, DEM_ERROR_INPUT,
                "%s: \"%.*s\" is no name of an entry; write words with / between them", path,
                (int)length, step);
    return DEM_OK;
}

int dem_dict_set(struct dem_dict *d, const char *path, const char *value)
{
    struct dem_reader r = {.depth = 0};
    struct dem_token name, end;
    const char *file, *at = path;
    char *text;
    void *p;

    DEM_TRY(dem_dict_pool_copy(d->pool, path, strlen(path), &file));
    for (size_t n = strcspn(at, "/"); at[n]; n = strcspn(at, "/"))
    {
        DEM_TRY(path_step(d->pool, at, n, file, &name));
        DEM_TRY(dem_dict_put_dict(d, name.text, file, 1, &d));
        at += n + 1;
    }
    DEM_TRY(path_step(d->pool, at, strlen(at), file, &name));
    /* the scanner needs the sign that ends a value */
    DEM_TRY(dem_dict_pool_alloc(d->pool, strlen(value) + 3, &p));
    text = p;
    memcpy(text, value, strlen(value));
    memcpy(text + strlen(value), " ;", 3);
    dem_dict_scan_start(&r.scan, text, strlen(text), file, d->pool);
    /* braces of its own: a value that is set again is meant */
    DEM_TRY(read_entry(&r, d, &name, ++d->pool->blocks));
    DEM_TRY(dem_dict_scan(&r.scan, &end));
    DEM_TRY(dem_dict_is_sign(&end, ';') ? dem_dict_scan(&r.scan, &end) : DEM_OK);
    DEM_REQUIRE(end.kind == DEM_TOKEN_END, DEM_ERROR_INPUT,
                "%s: the value \"%s\" goes on after its end; set one entry at a time", file, value);
    return DEM_OK;
}
