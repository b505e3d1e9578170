/*
 * restart.c -- compare the scene of a restart with the one of its snapshot, line by line.
 *
 * Both scenes are lines "path value" (dem_dict_flatten), sorted by path. A line with @ names a group
 * whose particles have been inserted.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/restart.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "core/text.h"
#include "input/dictionary.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* the entries that the core and the coupling take; write and accuracy change no result */
static const char *const sections[] = {
    "materials", "effects", "pairs", "parcels", "walls", "domain", "insert", "outlets", "bonds",
    "fluid", "forces", "time", "neighbours", "averages", "coupling"};

static const char group_mark[] = "@group ", program_mark[] = "@program";

int dem_api_note(struct dem *d, const char *format, ...)
{
    char text[1024];
    va_list arguments;

    va_start(arguments, format);
    const int n = vsnprintf(text, sizeof text, format, arguments);

    va_end(arguments);
    DEM_TRY(DEM_GROW(d->note, d->note_capacity, d->notes + 1));
    DEM_TRY(DEM_NEW(d->note[d->notes], sizeof text));
    memcpy(d->note[d->notes++], text, n < 0 ? 1 : sizeof text);
    return DEM_OK;
}

/* ---- text ------------------------------------------------------------------------------------ */

struct line
{
    const char *path, *value;     /* not ended by zeros */
    size_t length, size;          /* of the path, of the value */
};

struct lines
{
    struct line *line;
    size_t n;
};

/* A / comes before all else, so that the entries of a dictionary follow it at once. */
static int compare_lines(const void *a, const void *b)
{
    const struct line *const p = a, *const q = b;
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

static int split(const char *text, struct lines *all)
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
            all->line[all->n++] = (struct line){.path = at,
                                                .value = blank + 1,
                                                .length = (size_t)(blank - at),
                                                .size = (size_t)(end - blank) - 1};
        }
    }
    dem_sort_by(all->line, all->n, sizeof *all->line, compare_lines);
    return DEM_OK;
}

/* 1 when this line is in the text, for lines with @. */
static int has_mark(const char *text, const char *mark, const char *name)
{
    char line[256];
    const int n = snprintf(line, sizeof line, "%s%s\n", mark, name);

    for (const char *at = text; n > 0 && at && *at; at = strchr(at, '\n'), at = at ? at + 1 : NULL)
    {
        if (strncmp(at, line, (size_t)n) == 0)
        {
            return 1;
        }
    }
    return 0;
}

/* The groups that were inserted before, and those of this scene. */
static void add_marks(const struct dem *d, struct dem_text *t)
{
    const char *const before = d->start_checked || !d->before.text ? "" : d->before.text;
    const struct dem_dict *insert = NULL;

    for (const char *at = before, *end; (end = strchr(at, '\n')); at = end + 1)
    {
        if (at[0] == '@')
        {
            dem_text_add(t, "%.*s\n", (int)(end - at), at);
        }
    }
    (void)dem_dict_sub_if(d->dict, "insert", &insert);
    for (size_t k = 0; insert && k < dem_dict_count(insert); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(insert, k);

        if (!dem_insert_is_stream(dem_entry_dict(e)) && !has_mark(before, group_mark, dem_entry_name(e)))
        {
            dem_text_add(t, "%s%s\n", group_mark, dem_entry_name(e));
        }
    }
    if (d->program_particles && !has_mark(before, program_mark, ""))
    {
        dem_text_add(t, "%s\n", program_mark);
    }
}

static int write_text(const struct dem *d, struct dem_text *t)
{
    dem_dict_flatten(d->dict, sections, (int)(sizeof sections/sizeof *sections), t);
    add_marks(d, t);
    return t->status;
}

int dem_api_describe_scene(const struct dem *d, struct dem_snapshot_scene *s)
{
    const struct dem_state *const p = &d->state;
    struct dem_text t = {0};

    *s = (struct dem_snapshot_scene){.text = NULL};
    int status = write_text(d, &t);

    s->tail.text = (int64_t)(t.n/8 + 1)*8;    /* ends in a zero */
    s->tail.walls = p->walls.walls;
    s->tail.next_id = d->next_id > p->flows->next_id ? d->next_id : p->flows->next_id;
    status = status ? status : DEM_NEW(s->text, s->tail.text);
    status = status ? status : DEM_NEW(s->wall, s->tail.walls + 1);
    if (!status && t.n > 0)
    {
        memcpy(s->text, t.text, t.n);
    }
    for (int k = 0; k < p->walls.walls && !status; k++)
    {
        s->wall[k] = dem_snapshot_scene_wall(&p->walls, k);
    }
    for (int k = 0; k < 3; k++)
    {
        const int periodic = p->domain.periodic[k];

        s->tail.domain[k][0] = periodic;
        s->tail.domain[k][1] = periodic ? p->domain.min[k] : 0.0;
        s->tail.domain[k][2] = periodic ? p->domain.max[k] : 0.0;
    }
    dem_text_free(&t);
    return status;
}

/* ---- what becomes of a difference ------------------------------------------------------------ */

enum change
{
    CHANGED, NEW, GONE
};

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
    {"outlets", "", {"", "it acts from now on", "its sums are not continued"}},
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

/* entries that give a wall its form and place */
static const char *const forms[] = {"type", "point", "normal", "centre", "axis", "radius",
                                    "particles", "min", "max", "corners", "file", "scale"};

/* Component k of a path, from 0, into `part`; "" behind the last. */
static const char *component(const struct line *l, int k, char part[64])
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

static int is_form(const char *entry)
{
    int found = 0;

    for (size_t k = 0; k < sizeof forms/sizeof *forms; k++)
    {
        found |= strcmp(entry, forms[k]) == 0;
    }
    return found;
}

/* 1 when the group of `insert` that this line belongs to is a stream. */
static int is_stream(const struct lines *all, const struct line *l)
{
    char path[128], name[64];
    const int n = snprintf(path, sizeof path, "insert/%s/type", component(l, 1, name));
    const struct line key = {.path = path, .length = (size_t)n};
    size_t from = 0, to = all->n;

    while (from < to)
    {
        const size_t middle = from + (to - from)/2;

        from = compare_lines(&all->line[middle], &key) < 0 ? middle + 1 : from;
        to = compare_lines(&all->line[middle], &key) < 0 ? to : middle;
    }
    return from < all->n && compare_lines(&all->line[from], &key) == 0
        && all->line[from].size == 6 && memcmp(all->line[from].value, "stream", 6) == 0;
}

static const char *what_becomes(const struct lines *all, const struct line *l, enum change change)
{
    char section[64], entry[64];
    const struct rule *r = rules;

    component(l, 0, section);
    component(l, 2, entry);
    if (strcmp(section, "walls") == 0 && is_form(entry))
    {
        return anew;
    }
    if (strcmp(section, "insert") == 0 && entry[0] && !is_stream(all, l))
    {
        return not_again;
    }
    while (r->section
           && !(strcmp(r->section, section) == 0 && (!r->entry || strcmp(r->entry, entry) == 0)))
    {
        r++;
    }
    return r->becomes[change];
}

/* ---- comparison ------------------------------------------------------------------------------ */

struct comparison
{
    struct dem *d;
    struct lines before, now;
};

/* A wall whose form has changed does not go on. */
static int remember_form(struct dem *d, const struct line *l)
{
    char name[64], part[64];

    if (strcmp(component(l, 0, part), "walls") != 0 || !is_form(component(l, 2, part)))
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_GROW(d->reformed, d->reformed_capacity, d->reformed_walls + 1));
    snprintf(d->reformed[d->reformed_walls++], sizeof *d->reformed, "%s",
             component(l, 1, name));
    return DEM_OK;
}

static int is_left_out(const struct comparison *c, const struct line *l, enum change change)
{
    char part[64];

    if (l->length == 8 && memcmp(l->path, "time/end", 8) == 0)
    {
        return 1;
    }
    /* new groups have their sentence when they are inserted */
    return change == NEW && strcmp(component(l, 0, part), "insert") == 0
        && component(l, 1, part)[0] && !component(l, 2, part)[0] && !is_stream(&c->now, l);
}

static int tell(struct comparison *c, const struct line *was, const struct line *is)
{
    const enum change change = was && is ? CHANGED : is ? NEW : GONE;
    const struct line *const l = is ? is : was;
    const char *const becomes = what_becomes(is ? &c->now : &c->before, l, change);

    DEM_TRY(remember_form(c->d, l));
    if (is_left_out(c, l, change))
    {
        return DEM_OK;
    }
    if (change == CHANGED)
    {
        return dem_api_note(c->d, "restart: %.*s was %.*s, now %.*s: %s", (int)l->length, l->path,
                            (int)was->size, was->value, (int)is->size, is->value, becomes);
    }
    const int whole = l->size == 2 && memcmp(l->value, "{}", 2) == 0;

    return dem_api_note(c->d, "restart: %.*s%s%.*s is %s: %s", (int)l->length, l->path,
                        whole ? "" : " ", whole ? 0 : (int)l->size, l->value,
                        change == NEW ? "new" : "gone", becomes);
}

/* A section as a whole is not told of, but its entries are. */
static int is_section(const struct line *l)
{
    return !memchr(l->path, '/', l->length);
}

/* The line behind those of the same dictionary. */
static size_t skip(const struct lines *all, size_t k)
{
    const struct line *const head = &all->line[k];
    size_t next = k + 1;

    while (next < all->n && !is_section(head) && all->line[next].length > head->length
           && memcmp(all->line[next].path, head->path, head->length) == 0
           && all->line[next].path[head->length] == '/')
    {
        next++;
    }
    return next;
}

/* The number at the begin of a value, and what follows. */
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
static int same_value(const struct line *a, const struct line *b)
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

static int compare_texts(struct comparison *c)
{
    size_t i = 0, j = 0;

    while (i < c->before.n || j < c->now.n)
    {
        const struct line *const was = i < c->before.n ? &c->before.line[i] : NULL;
        const struct line *const is = j < c->now.n ? &c->now.line[j] : NULL;
        const int order = !was ? 1 : !is ? -1 : compare_lines(was, is);

        if (order < 0)
        {
            DEM_TRY(is_section(was) ? DEM_OK : tell(c, was, NULL));
            i = skip(&c->before, i);
        }
        else if (order > 0)
        {
            DEM_TRY(is_section(is) ? DEM_OK : tell(c, NULL, is));
            j = skip(&c->now, j);
        }
        else
        {
            DEM_TRY(same_value(was, is) ? DEM_OK : tell(c, was, is));
            i++;
            j++;
        }
    }
    return DEM_OK;
}

static int compare(struct dem *d)
{
    struct comparison c = {.d = d};
    struct dem_text now = {0};
    int status = write_text(d, &now);

    status = status ? status : split(d->before.text, &c.before);
    status = status ? status : split(now.text ? now.text : "", &c.now);
    status = status ? status : compare_texts(&c);
    dem_memory_free(c.before.line);
    dem_memory_free(c.now.line);
    dem_text_free(&now);
    return status;
}

static int check_periodic(const struct dem *d)
{
    const struct dem_domain *const box = &d->state.domain;

    for (int k = 0; k < 3; k++)
    {
        const double *const was = d->before.tail.domain[k];
        const int same = (was[0] != 0.0) == (box->periodic[k] != 0)
                      && (was[0] == 0.0 || (was[1] == box->min[k] && was[2] == box->max[k]));

        DEM_REQUIRE(same, DEM_ERROR_INPUT,
                    "%s: its domain is %speriodic along %c, from %g to %g m, and the scene's is %s "
                    "or has other limits; contacts of the snapshot cross these faces: give the "
                    "domain of the snapshot, or take its particles into a new run with start { "
                    "snapshot; }", d->load_path, was[0] != 0.0 ? "" : "not ", "xyz"[k], was[1],
                    was[2], box->periodic[k] ? "periodic" : "not");
    }
    return DEM_OK;
}

/* ---- groups ---------------------------------------------------------------------------------- */

/* A snapshot without a scene has all groups. */
static int is_inserted(const struct dem *d, const char *mark, const char *name)
{
    return !d->before.text || has_mark(d->before.text, mark, name);
}

/* A group that an edit of the scene has left out for a while. */
static int tell_of_return(struct dem *d, const char *group)
{
    char path[128];

    snprintf(path, sizeof path, "insert/%s {}", group);
    return !d->before.text || has_mark(d->before.text, path, "")
             ? DEM_OK
             : dem_api_note(d, "restart: insert/%s is back in the scene: its particles were inserted "
                            "before, and are not inserted again", group);
}

static int keep_new_groups(struct dem *d)
{
    for (size_t k = d->scene.insertion.n; k > 0; k--)
    {
        const char *const name = dem_insert_name(&d->scene.insertion, k - 1);

        if (is_inserted(d, group_mark, name))
        {
            DEM_TRY(tell_of_return(d, name));
            dem_insert_drop(&d->scene.insertion, k - 1);
        }
    }
    if (d->initial.n > 0 && is_inserted(d, program_mark, ""))
    {
        dem_initial_particles_release(&d->initial);
    }
    return dem_insert_check_domain(&d->scene.insertion, &d->state.domain);
}

int dem_api_compare_scene(struct dem *d)
{
    DEM_TRY(dem_snapshot_read_scene(d->load_path, &d->state.decomposition, &d->before));
    if (d->start_checked)
    {
        return DEM_OK;    /* particles for another run */
    }
    if (d->before.text)
    {
        DEM_TRY(check_periodic(d));
        DEM_TRY(compare(d));
        DEM_TRY(dem_api_resume_walls(d));
    }
    else
    {
        DEM_TRY(dem_api_note(d, "restart: %s has no scene to compare with: changes of the scene are "
                             "not told, and no group of insert is inserted", d->load_path));
    }
    return keep_new_groups(d);
}
