/*
 * restart.c -- compare the scene of a restart with the one of its snapshot, line by line.
 *
 * Both scenes are lines "path value" (dem_dict_flatten), sorted by path. A line with @ names a group
 * whose particles have been inserted.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/restart.h"
#include "case/scene_lines.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/text.h"
#include "input/dictionary.h"
#include "laws/effects.h"
#include "records/wall_wear.h"
#include "sources/residence.h"
#include <stdio.h>
#include <string.h>

/* the entries that the core and the coupling take; write and accuracy change no result */
static const char *const sections[] = {
    "materials", "effects", "pairs", "parcels", "walls", "domain", "insert", "outlets", "bonds",
    "fluid", "forces", "time", "neighbours", "averages", "coupling", "stages", "planes",
    "shapes"};

static const char group_mark[] = "@group ", program_mark[] = "@program";

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

/* The groups inserted before and the groups of this scene. */
static void add_marks(const struct dem *d, struct dem_text *t)
{
    const char *const before = d->before.text ? d->before.text : "";
    const struct dem_dict *insert = NULL;

    for (const char *at = before, *end; (end = strchr(at, '\n')); at = end + 1)
    {
        if (strncmp(at, group_mark, sizeof group_mark - 1) == 0
            || strncmp(at, program_mark, sizeof program_mark - 1) == 0)
        {
            dem_text_add(t, "%.*s\n", (int)(end - at), at);
        }
    }
    (void)dem_dict_sub_if(d->dict, "insert", &insert);
    for (size_t k = 0; insert && k < dem_dict_count(insert); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(insert, k);

        if (!dem_insert_is_stream(dem_entry_dict(e))
            && !has_mark(before, group_mark, dem_entry_name(e)))
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
    dem_stages_describe(&d->scene.stages, t);
    dem_cell_describe(d, t);
    dem_residence_describe(d->state.flows, t);
    return t->status;
}

int dem_sim_describe_scene(const struct dem *d, struct dem_snapshot_scene *s)
{
    const struct dem_state *const state = &d->state;
    struct dem_text t = {0};

    *s = (struct dem_snapshot_scene){.text = NULL};
    int status = write_text(d, &t);

    dem_sim_describe_motions(&state->walls, state->time, &t);
    dem_wall_wear_describe(state, &t);
    status = status ? status : t.status;
    s->tail.text = (int64_t)(t.n/8 + 1)*8;    /* ends in a zero */
    s->tail.walls = state->walls.walls;
    s->tail.next_id = d->next_id > state->flows->next_id ? d->next_id : state->flows->next_id;
    status = status ? status : DEM_NEW(s->text, s->tail.text);
    status = status ? status : DEM_NEW(s->wall, s->tail.walls + 1);
    if (!status && t.n > 0)
    {
        memcpy(s->text, t.text, t.n);
    }
    for (int k = 0; k < state->walls.walls && !status; k++)
    {
        s->wall[k] = dem_snapshot_scene_wall(&state->walls, k);
    }
    for (int k = 0; k < 3; k++)
    {
        const int periodic = state->domain.periodic[k];

        s->tail.domain[k][0] = periodic;
        s->tail.domain[k][1] = periodic ? state->domain.min[k] : 0.0;
        s->tail.domain[k][2] = !periodic ? 0.0 : state->cell.active ? state->cell.first_max[k] : state->domain.max[k];
    }
    dem_text_free(&t);
    return status;
}

/* ---- comparison ------------------------------------------------------------------------------ */

struct comparison
{
    struct dem_case *c;
    struct dem_scene_lines before, now;
};

/* A wall whose form has changed does not go on. */
static int remember_form(struct dem_case *c, const struct dem_scene_line *l)
{
    char name[64], part[64];

    if (strcmp(dem_scene_line_part(l, 0, part), "walls") != 0
        || !dem_scene_line_is_form(dem_scene_line_part(l, 2, part)))
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_GROW(c->reformed, c->reformed_capacity, c->reformed_walls + 1));
    snprintf(c->reformed[c->reformed_walls++], sizeof *c->reformed, "%s",
             dem_scene_line_part(l, 1, name));
    return DEM_OK;
}

static int is_left_out(const struct comparison *c, const struct dem_scene_line *l,
                       enum dem_line_change change)
{
    char part[64];

    if (l->length == 8 && memcmp(l->path, "time/end", 8) == 0)
    {
        return 1;
    }
    /* new groups have their sentence when they are inserted */
    return change == DEM_LINE_NEW && strcmp(dem_scene_line_part(l, 0, part), "insert") == 0
        && dem_scene_line_part(l, 1, part)[0] && !dem_scene_line_part(l, 2, part)[0]
        && !dem_scene_line_is_stream(&c->now, l);
}

/* An effect that is gone has particle scalars that no effect of the scene has. */
static int loses_scalars(const struct dem_interaction_table *r, const struct dem_scene_line *l)
{
    char section[64], name[64], part[64];
    const int whole = strcmp(dem_scene_line_part(l, 0, section), "effects") == 0 && !dem_scene_line_part(l, 2, part)[0];
    const struct dem_effect *const gone = whole ? dem_effects_find(dem_scene_line_part(l, 1, name)) : NULL;
    int loses = 0;

    for (const struct dem_scalar *const *s = gone ? gone->scalars : NULL; s && *s; s++)
    {
        loses |= !(*s)->fluid_entry && dem_interaction_table_find_scalar(r, (*s)->name) < 0;
    }
    return loses;
}

static int tell(struct comparison *c, const struct dem_scene_line *was,
                const struct dem_scene_line *is)
{
    const enum dem_line_change change =
        was && is ? DEM_LINE_CHANGED : is ? DEM_LINE_NEW : DEM_LINE_GONE;
    const struct dem_scene_line *const l = is ? is : was;
    const char *const becomes =
        change == DEM_LINE_GONE && loses_scalars(&c->c->d->state.interaction_table, l)
            ? "it applies no longer; its particle scalars are lost, and begin at the scene's values when it is back"
            : dem_scene_line_becomes(is ? &c->now : &c->before, l, change);

    DEM_TRY(remember_form(c->c, l));
    if (is_left_out(c, l, change))
    {
        return DEM_OK;
    }
    if (change == DEM_LINE_CHANGED)
    {
        return dem_sim_note(c->c->d, "restart: %.*s was %.*s, now %.*s: %s", (int)l->length, l->path,
                            (int)was->size, was->value, (int)is->size, is->value, becomes);
    }
    const int whole = l->size == 2 && memcmp(l->value, "{}", 2) == 0;

    return dem_sim_note(c->c->d, "restart: %.*s%s%.*s is %s: %s", (int)l->length, l->path,
                        whole ? "" : " ", whole ? 0 : (int)l->size, l->value,
                        change == DEM_LINE_NEW ? "new" : "gone", becomes);
}

/* A section as a whole is not reported, but its entries are. */
static int is_section(const struct dem_scene_line *l)
{
    return !memchr(l->path, '/', l->length);
}

/* The first line after the dictionary that begins at line k. */
static size_t skip(const struct dem_scene_lines *all, size_t k)
{
    const struct dem_scene_line *const head = &all->line[k];
    size_t next = k + 1;

    while (next < all->n && !is_section(head) && all->line[next].length > head->length
           && memcmp(all->line[next].path, head->path, head->length) == 0
           && all->line[next].path[head->length] == '/')
    {
        next++;
    }
    return next;
}

static int compare_texts(struct comparison *c)
{
    size_t i = 0, j = 0;

    while (i < c->before.n || j < c->now.n)
    {
        const struct dem_scene_line *const was = i < c->before.n ? &c->before.line[i] : NULL;
        const struct dem_scene_line *const is = j < c->now.n ? &c->now.line[j] : NULL;
        const int order = !was ? 1 : !is ? -1 : dem_scene_lines_compare(was, is);

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
            DEM_TRY(dem_scene_lines_same(was, is) ? DEM_OK : tell(c, was, is));
            i++;
            j++;
        }
    }
    return DEM_OK;
}

static int compare(struct dem_case *of)
{
    const struct dem *const d = of->d;
    struct comparison c = {.c = of};
    struct dem_text now = {0};
    int status = write_text(d, &now);

    status = status ? status : dem_scene_lines_split(d->before.text, &c.before);
    status = status ? status : dem_scene_lines_split(now.text ? now.text : "", &c.now);
    status = status ? status : compare_texts(&c);
    dem_memory_free(c.before.line);
    dem_memory_free(c.now.line);
    dem_text_free(&now);
    return status;
}

static int check_periodic(const struct dem_case *c)
{
    const struct dem *const d = c->d;
    const struct dem_domain *const box = &d->state.domain;

    for (int k = 0; k < 3; k++)
    {
        const double *const was = d->before.tail.domain[k],
                     max = d->state.cell.active ? d->state.cell.first_max[k] : box->max[k];
        const int same = (was[0] != 0.0) == (box->periodic[k] != 0)
                      && (was[0] == 0.0 || (was[1] == box->min[k] && was[2] == max));

        DEM_REQUIRE(same, DEM_ERROR_INPUT,
                    "%s: its domain is %speriodic along %c, from %g to %g m, and the scene's is %s "
                    "or has other limits; contacts of the snapshot cross these faces: give the "
                    "domain of the snapshot, or take its particles into a new run with start { "
                    "snapshot; }", c->load_path, was[0] != 0.0 ? "" : "not ", "xyz"[k], was[1],
                    was[2], box->periodic[k] ? "periodic" : "not");
    }
    return DEM_OK;
}

/* ---- groups ---------------------------------------------------------------------------------- */

/* A group that an edit of the scene has left out for a while. */
static int tell_of_return(struct dem *d, const char *group)
{
    char path[128];

    snprintf(path, sizeof path, "insert/%s {}", group);
    return has_mark(d->before.text, path, "")
             ? DEM_OK
             : dem_sim_note(d, "restart: insert/%s is back in the scene: its particles were inserted "
                            "before, and are not inserted again", group);
}

static int keep_new_groups(struct dem_case *c)
{
    struct dem *const d = c->d;

    for (size_t k = d->scene.insertion.n; k > 0; k--)
    {
        const char *const name = dem_insert_name(&d->scene.insertion, k - 1);

        if (has_mark(d->before.text, group_mark, name))
        {
            DEM_TRY(tell_of_return(d, name));
            dem_insert_drop(&d->scene.insertion, k - 1);
        }
    }
    if (c->initial.n > 0 && has_mark(d->before.text, program_mark, ""))
    {
        dem_initial_particles_release(&c->initial);
    }
    return dem_insert_check_domain(&d->scene.insertion, &d->state.domain);
}

int dem_sim_compare_scene(struct dem_case *c)
{
    struct dem *const d = c->d;

    DEM_TRY(dem_snapshot_read_scene(c->load_path, &d->state.decomposition, &d->before));
    if (c->new_run)
    {
        DEM_TRY(dem_cell_start(d, c->load_path));
        d->before.text[0] = '\0';    /* of another run: nothing of this one is inserted yet */
        return dem_stages_start(d, 0);
    }
    DEM_TRY(check_periodic(c));
    DEM_TRY(compare(c));
    DEM_TRY(dem_cell_resume(d, c->load_path));
    DEM_TRY(dem_stages_start(d, 1));
    DEM_TRY(dem_sim_resume_walls(c));
    return keep_new_groups(c);
}
