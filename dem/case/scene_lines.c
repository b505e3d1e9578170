/*
 * scene_lines.c -- lines of scenes: sort, compare values, and the rules of a restart.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_lines.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A / comes before all else, so that the entries of a dictionary follow it at once. */
int dem_scene_lines_compare(const void *a, const void *b)
{
    const struct dem_scene_line *const p = a, *const q = b;
    const size_t n = p->length < q->length ? p->length : q->length;

    for (size_t k = 0; k < n; k++)
    {
        const int c = p->path[k] == '/' ? 0 : (unsigned char)p->path[k];
        const int e = q->path[k] == '/' ? 0 : (unsigned char)q->path[k];

        if (c != e)
        {
            return c - e;
        }
    }
    return (p->length > q->length) - (p->length < q->length);
}

int dem_scene_lines_split(const char *text, struct dem_scene_lines *all)
{
    size_t n = 0;

    for (const char *c = text; *c; c++)
    {
        n += *c == '\n';
    }
    DEM_TRY(DEM_NEW(all->line, n + 1));
    for (const char *at = text, *end; (end = strchr(at, '\n')); at = end + 1)
    {
        const char *const blank = memchr(at, ' ', (size_t)(end - at));

        if (at[0] != '@' && blank)
        {
            all->line[all->n++] = (struct dem_scene_line){.path = at,
                                                .value = blank + 1,
                                                .length = (size_t)(blank - at),
                                                .size = (size_t)(end - blank) - 1};
        }
    }
    dem_sort_by(all->line, all->n, sizeof *all->line, dem_scene_lines_compare);
    return DEM_OK;
}

/* The number at the beginning of a value, and what follows. */
static int take_number(const char **at, const char *end, double *number)
{
    char word[64], *rest;
    const size_t left = (size_t)(end - *at), n = left < sizeof word - 1 ? left : sizeof word - 1;

    memcpy(word, *at, n);
    word[n] = '\0';
    word[strcspn(word, " ()")] = '\0';
    *number = strtod(word, &rest);
    *at += strlen(word);
    return word[0] && !*rest;
}

/* The same words, and the same numbers: 0.1 and 1e-1. */
int dem_scene_lines_same(const struct dem_scene_line *a, const struct dem_scene_line *b)
{
    const char *p = a->value, *q = b->value, *const p_end = p + a->size, *const q_end = q + b->size;

    while (p < p_end && q < q_end)
    {
        const char *const word = p, *const other = q;
        double x, y;
        const int numbers = take_number(&p, p_end, &x) & take_number(&q, q_end, &y);

        if (!(numbers && x == y)
            && (p - word != q - other || memcmp(word, other, (size_t)(p - word)) != 0))
        {
            return 0;
        }
        while (p < p_end && q < q_end && *p == *q && strchr(" ()", *p))
        {
            p++;
            q++;
        }
        if (p == word)
        {
            break;    /* different signs */
        }
    }
    return p == p_end && q == q_end;
}

/* ---- what becomes of a difference ------------------------------------------------------------ */

/* a rule for a section, an entry of its dictionaries ("" is the dictionary itself, NULL any) */
static const struct rule
{
    const char *section, *entry, *becomes[3];
} rules[] =
{
    {"walls", "motion",
     {"the wall goes on from where it stood, with this motion",
      "the wall goes on from where it stood, with this motion",
      "the wall stays where it stood"}},
    {"walls", "", {"", "the wall stands where the scene puts it", "its contacts have ended"}},
    {"insert", "", {"", "the stream begins now", "its particles stay"}},
    {"parcels", NULL,
     {"parcels of the snapshot keep their ratio, new ones have this one", "it applies from now on",
      "it applies no longer"}},
    {"planes", "", {"", "it counts from now on", "its sums are not continued"}},
    {"outlets", "residence",
     {"its residence times are counted anew", "residence times are counted from now on",
      "residence times are counted no longer"}},
    {"outlets", "", {"", "it acts from now on", "its sums are not continued"}},
    {"shapes", NULL,
     {"clumps of the snapshot keep their form", "it applies from now on",
      "clumps of the snapshot keep their form"}},
    {"averages", NULL,
     {"the means of this grid begin anew", "the means of this grid begin now",
      "the means of this grid end"}},
    {"bonds", NULL,
     {"not applied, a list makes bonds at the start of a run only",
      "not applied, a list makes bonds at the start of a run only",
      "not applied, the bonds stay"}},
    {NULL, NULL, {"it applies from now on", "it applies from now on", "it applies no longer"}},
};

static const char not_again[] =
    "not applied, the particles of this group are in the snapshot; give the group another name to "
    "insert it again";

static const char anew[] =
    "the wall begins anew where the scene puts it, without the history of its contacts";

static const char keeps_length[] = "the cell keeps its length and offset, as with rate 0";

static const char comes[] = "the group comes at its time `at`";

/* entries that give a wall its form and place */
static const char *const forms[] = {"type", "point", "normal", "centre", "axis", "radius",
                                    "particles", "min", "max", "corners", "file", "scale"};

/* Component k of a path, from 0, into `part`; "" behind the last. */
const char *dem_scene_line_part(const struct dem_scene_line *l, int k, char part[64])
{
    const char *at = l->path, *const end = l->path + l->length;
    const char *slash = at;

    for (int c = 0; c <= k; c++)
    {
        at = c == 0 ? at : slash < end ? slash + 1 : end;
        slash = memchr(at, '/', (size_t)(end - at));
        slash = slash ? slash : end;
    }
    snprintf(part, 64, "%.*s", (int)(slash - at), at);
    return part;
}

int dem_scene_line_is_form(const char *entry)
{
    int found = 0;

    for (size_t k = 0; k < sizeof forms/sizeof *forms; k++)
    {
        found |= strcmp(entry, forms[k]) == 0;
    }
    return found;
}

/* The line of this path; NULL: there is none. */
static const struct dem_scene_line *find_line(const struct dem_scene_lines *all, const char *path)
{
    const struct dem_scene_line key = {.path = path, .length = strlen(path)};
    size_t from = 0, to = all->n;

    while (from < to)
    {
        const size_t middle = from + (to - from)/2;
        const int before = dem_scene_lines_compare(&all->line[middle], &key) < 0;

        from = before ? middle + 1 : from;
        to = before ? to : middle;
    }
    return from < all->n && dem_scene_lines_compare(&all->line[from], &key) == 0 ? &all->line[from] : NULL;
}

/* An entry of the group of `insert` that this line belongs to. */
static const struct dem_scene_line *find_of_group(const struct dem_scene_lines *all,
                                                  const struct dem_scene_line *l, const char *entry)
{
    char path[128], name[64];

    snprintf(path, sizeof path, "insert/%s/%s", dem_scene_line_part(l, 1, name), entry);
    return find_line(all, path);
}

/* 1 when the group of `insert` that this line belongs to is a stream, or comes later. */
int dem_scene_line_is_stream(const struct dem_scene_lines *all, const struct dem_scene_line *l)
{
    const struct dem_scene_line *const type = find_of_group(all, l, "type");

    return find_of_group(all, l, "at") || (type && type->size == 6 && memcmp(type->value, "stream", 6) == 0);
}

/* domain/cell or an axis of it */
static int is_of_cell(const struct dem_scene_line *l)
{
    char part[64];

    return strcmp(dem_scene_line_part(l, 0, part), "domain") == 0
        && strcmp(dem_scene_line_part(l, 1, part), "cell") == 0
        && !dem_scene_line_part(l, 3, part)[0] && (!dem_scene_line_part(l, 2, part)[0] || strlen(part) == 2);
}

const char *dem_scene_line_becomes(const struct dem_scene_lines *all, const struct dem_scene_line *l, enum dem_line_change change)
{
    char section[64], entry[64];
    const struct rule *r = rules;

    dem_scene_line_part(l, 0, section);
    dem_scene_line_part(l, 2, entry);
    if (strcmp(section, "walls") == 0 && dem_scene_line_is_form(entry))
    {
        return anew;
    }
    if (change == DEM_LINE_GONE && is_of_cell(l))
    {
        return keeps_length;
    }
    if (strcmp(section, "insert") == 0 && entry[0] && !dem_scene_line_is_stream(all, l))
    {
        return not_again;
    }
    if (strcmp(section, "insert") == 0 && change == DEM_LINE_NEW && !entry[0] && find_of_group(all, l, "at"))
    {
        return comes;
    }
    while (r->section
           && !(strcmp(r->section, section) == 0 && (!r->entry || strcmp(r->entry, entry) == 0)))
    {
        r++;
    }
    return r->becomes[change];
}
