/*
 * stages.c -- the entry `stages`, and the times that it sets: see stages.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/stages.h"
#include "case/dem_case.h"
#include "case/scene_internal.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/text.h"
#include "core/vec.h"
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- reading --------------------------------------------------------------------------------- */

static int read_load(struct dem_run_stage *s, const struct dem_dict *dict, const struct dem_walls *w)
{
    static const double none[3] = {0.0, 0.0, 0.0};
    const char *wall;

    s->until = DEM_UNTIL_LOAD;
    DEM_TRY(dem_dict_word(dict, "force", &wall));
    s->wall_index = dem_walls_named(w, wall);
    DEM_REQUIRE(s->wall_index < w->walls, DEM_ERROR_INPUT,
                "%s: stages/%s waits for a force on wall %.63s, but the scene has no such wall; a side "
                "of a box is named like boxMaxZ", dem_dict_where(dict), s->name, wall);
    const struct dem_wall_body *const b = dem_walls_body(w, s->wall_index);
    const int servo = b && b->kind == DEM_WALL_BODY_SERVO && !b->table;

    s->load = servo ? fabs(b->force[0]*b->area) : 0.0;
    DEM_TRY(servo ? dem_dict_number_or(dict, "value", "N", s->load, &s->load)
                  : dem_dict_number(dict, "value", "N", &s->load));
    DEM_TRY(dem_dict_number_or(dict, "within", "1", servo ? 0.01 : 0.0, &s->within));
    DEM_TRY(dem_dict_number_or(dict, "lasting", "s", 0.0, &s->lasting));
    DEM_TRY(dem_dict_vector_or(dict, "direction", "1", none, s->direction));
    const double size = dem_vec_norm(s->direction);

    DEM_REQUIRE(s->load > 0.0 && s->within >= 0.0 && s->within < 1.0 && s->lasting >= 0.0
                    && isfinite(size) && (size > 0.0 || !dem_dict_has(dict, "direction")),
                DEM_ERROR_INPUT,
                "%s: stages/%s: value %g N, within %g, lasting %g s, direction of length %g; give a "
                "value above 0, a fraction below 1, a time of 0 or more, and a vector",
                dem_dict_where(dict), s->name, s->load, s->within, s->lasting, size);
    for (int k = 0; k < 3 && size > 0.0; k++)
    {
        s->direction[k] /= size;
    }
    return DEM_OK;
}

static int read_condition(struct dem_run_stage *s, const struct dem_dict *dict, const struct dem_walls *w)
{
    const struct dem_dict *until = NULL;
    const char *word = "";

    DEM_TRY(dem_dict_has_dict(dict, "until") ? dem_dict_sub(dict, "until", &until) : DEM_OK);
    if (until && dem_dict_has(until, "force"))
    {
        return read_load(s, until, w);
    }
    if (until)
    {
        s->until = DEM_UNTIL_QUIET;
        return dem_scene_read_quiet(until, &s->quiet);
    }
    if (dem_dict_has(dict, "until"))
    {
        s->until = DEM_UNTIL_QUIET;
        DEM_TRY(dem_dict_word(dict, "until", &word));
        DEM_REQUIRE(strcmp(word, "quiet") == 0, DEM_ERROR_INPUT,
                    "%s: stages/%s: until %s; give quiet, { settings of untilQuiet } or { force WALL; "
                    "value N; }; a time is a duration", dem_dict_where(dict), s->name, word);
        DEM_TRY(dem_scene_read_quiet(NULL, &s->quiet));
        s->quiet.wanted = 1;
    }
    return DEM_OK;
}

static int read_time(const struct dem_dict *dict, const char *entry, double *value)
{
    DEM_TRY(dem_dict_number_or(dict, entry, "s", INFINITY, value));
    DEM_REQUIRE(*value > 0.0, DEM_ERROR_INPUT, "%s: %s/%s %g s; give a time above 0",
                dem_dict_where(dict), dem_dict_path(dict), entry, *value);
    return DEM_OK;
}

static int read_stage(struct dem_run_stage *s, const struct dem_dict *dict, const struct dem_walls *w)
{
    *s = (struct dem_run_stage){.begin = INFINITY, .since = INFINITY, .why = ""};
    DEM_REQUIRE(strlen(dem_dict_name(dict)) < sizeof s->name
                    && isalpha((unsigned char)dem_dict_name(dict)[0]), DEM_ERROR_INPUT,
                "%s: stages/%s: give a name that begins with a letter, of at most %zu characters",
                dem_dict_where(dict), dem_dict_name(dict), sizeof s->name - 1);
    snprintf(s->name, sizeof s->name, "%s", dem_dict_name(dict));
    DEM_TRY(read_condition(s, dict, w));
    DEM_TRY(read_time(dict, "duration", &s->duration));
    DEM_TRY(read_time(dict, "atMost", &s->at_most));
    DEM_REQUIRE(!s->until || !dem_dict_has(dict, "duration"), DEM_ERROR_INPUT,
                "%s: stages/%s has both until and duration; keep one, or give atMost beside until",
                dem_dict_where(dict), s->name);
    DEM_REQUIRE(s->until || !dem_dict_has(dict, "atMost"), DEM_ERROR_INPUT,
                "%s: stages/%s has atMost without until; give duration", dem_dict_where(dict), s->name);
    return DEM_OK;
}

int dem_scene_read_stages(struct dem_run_stages *s, const struct dem_dict *scene, const struct dem_walls *w)
{
    const struct dem_dict *stages;

    s->over = INFINITY;
    DEM_TRY(dem_dict_sub_if(scene, "stages", &stages));
    for (size_t k = 0; stages && k < dem_dict_count(stages); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(stages, k);

        DEM_REQUIRE(dem_entry_is_dict(e), DEM_ERROR_INPUT,
                    "%s: stages holds stages like %s { until quiet; }", dem_entry_where(e),
                    dem_entry_name(e));
        DEM_REQUIRE(s->n < INT16_MAX, DEM_ERROR_INPUT, "%s: more than %d stages; join some",
                    dem_entry_where(e), INT16_MAX);
        DEM_TRY(DEM_GROW(s->stage, s->capacity, s->n + 1));
        DEM_TRY(read_stage(&s->stage[s->n++], dem_entry_dict(e), w));
        const struct dem_run_stage *const before = s->n > 1 ? &s->stage[s->n - 2] : NULL;

        DEM_REQUIRE(!before || before->until || isfinite(before->duration), DEM_ERROR_INPUT,
                    "%s: stages/%s has neither until nor duration, so that %s never begins; give one "
                    "of them", dem_entry_where(e), before->name, dem_entry_name(e));
    }
    return DEM_OK;
}

/* ---- times that a stage sets ----------------------------------------------------------------- */

static void set_time(double *time, int stage, int begun, double begin)
{
    *time = stage == begun ? begin : *time;
}

static void set_frame_times(struct dem_wall_frame *f, int side, int begun, double begin)
{
    struct dem_compound_motion *const c = f->compound;

    set_time(side ? &f->motion.end : &f->motion.start, f->motion.stage[side], begun, begin);
    for (int k = 0; c && k < c->parts; k++)
    {
        struct dem_motion *const m = &c->part[k].motion;

        set_time(side ? &m->end : &m->start, m->stage[side], begun, begin);
    }
    if (c && c->body)
    {
        set_time(side ? &c->body->end : &c->body->start, c->body->stage[side], begun, begin);
    }
}

void dem_stages_begin(struct dem *d, int k, double time, const char *why)
{
    struct dem_run_stages *const s = &d->scene.stages;
    struct dem_walls *const w = &d->state.walls;
    struct dem_streams *const streams = &d->scene.streams;
    const int begun = k + 1;

    s->stage[k].begin = time;
    s->stage[k].why = why;
    s->present = k;
    s->part = 0.0;
    for (int side = 0; side < 2; side++)
    {
        for (int n = 0; n < w->walls; n++)
        {
            set_time(&w->wall[n].there[side], w->wall[n].there_stage[side], begun, time);
        }
        for (int n = 0; n < w->frames; n++)
        {
            set_frame_times(&w->frame[n], side, begun, time);
        }
    }
    for (int n = 0; n < 4; n++)
    {
        struct dem_cell_axis *const a = n < 3 ? &d->state.cell.axis[n] : &d->state.cell.shear;

        set_time(&a->start, a->stage[0], begun, time);
        set_time(&a->end, a->stage[1], begun, time);
    }
    for (int n = 0; n < streams->streams; n++)
    {
        struct dem_stream *const stream = &streams->stream[n];

        set_time(&stream->start, stream->stage[0], begun, time);
        set_time(&stream->end, stream->stage[1], begun, time);
    }
}

/* ---- how long a motion lasts at most --------------------------------------------------------- */

/* Stages [from, to) [s]: at most, or at least. */
static double length_of(const struct dem_run_stages *s, int from, int to, int most)
{
    double length = 0.0;

    for (int k = from; k < to; k++)
    {
        length += s->stage[k].until == DEM_UNTIL_TIME ? s->stage[k].duration : most ? s->stage[k].at_most : 0.0;
    }
    return length;
}

static void limit_motion(const struct dem_run_stages *s, double first, struct dem_motion *m)
{
    const int from = m->stage[0] - 1, to = m->stage[1] - 1;
    const double longest = from >= 0 && to >= 0 ? length_of(s, from, to, 1)
                           : from >= 0          ? m->end - first - length_of(s, 0, from, 0)
                                                : first + length_of(s, 0, to, 1) - m->start;

    m->longest = fmax(longest, 0.0);
}

void dem_stages_limit_motions(struct dem *d)
{
    const struct dem_run_stages *const s = &d->scene.stages;
    const struct dem_walls *const w = &d->state.walls;
    /* not when later stages have begun: a restart comes to the same result */
    const double first = s->n > 0 && isfinite(s->stage[0].begin) ? s->stage[0].begin : d->state.time;

    for (int n = 0; n < w->frames && s->n > 0; n++)
    {
        struct dem_compound_motion *const c = w->frame[n].compound;

        limit_motion(s, first, &w->frame[n].motion);
        for (int k = 0; c && k < c->parts; k++)
        {
            limit_motion(s, first, &c->part[k].motion);
        }
    }
}

/* ---- restart --------------------------------------------------------------------------------- */

static const char stage_mark[] = "@stage ", test_mark[] = "@test ";

void dem_stages_describe(const struct dem_run_stages *s, struct dem_text *t)
{
    for (int k = 0; k < s->n && k <= s->present; k++)
    {
        dem_text_add(t, "%s%s %a\n", stage_mark, s->stage[k].name, s->stage[k].begin);
    }
    if (s->n > 0)
    {
        const struct dem_run_stage *const now = &s->stage[s->present];
        const struct dem_quiet *const q = &now->quiet;

        dem_text_add(t, "%s%a %a %a %a %a %a %a %a %a\n", test_mark, s->part, s->end, s->over, now->since,
                     q->since, q->tested, q->momentum[0], q->momentum[1], q->momentum[2]);
    }
}

static void resume_test(struct dem_run_stages *s, const char *line)
{
    double x[9];
    struct dem_run_stage *const now = &s->stage[s->present];

    if (dem_text_numbers(line, x, 9) == 9)
    {
        s->part = x[0];
        s->end = x[1];
        s->over = x[2];
        now->since = x[3];
        now->quiet.since = x[4];
        now->quiet.tested = x[5];
        memcpy(now->quiet.momentum, x + 6, sizeof now->quiet.momentum);
    }
}

static int resume(struct dem *d, const char *text)
{
    struct dem_run_stages *const s = &d->scene.stages;
    const char *words, *rest;
    int last = -1;

    for (const char *at = text; (words = dem_text_marked(&at, stage_mark));)
    {
        for (int k = 0; k < s->n; k++)
        {
            double begin;

            if ((rest = dem_text_after(words, s->stage[k].name)) && dem_text_numbers(rest, &begin, 1) == 1)
            {
                last = k > last ? k : last;
                dem_stages_begin(d, k, begin, "");
            }
        }
    }
    if (last >= 0 && (words = dem_text_marked(&text, test_mark)))
    {
        s->present = last;
        resume_test(s, words);
    }
    for (int k = 0; k < last; k++)
    {
        DEM_REQUIRE(isfinite(s->stage[k].begin), DEM_ERROR_INPUT,
                    "stages/%s is new, but stages/%s, which comes after it, has begun in the snapshot; "
                    "put it behind", s->stage[k].name, s->stage[last].name);
    }
    if (last < 0)
    {
        dem_stages_begin(d, 0, d->state.time, "");
    }
    return DEM_OK;
}

int dem_stages_start(struct dem *d, int continues)
{
    if (d->scene.stages.n > 0)
    {
        DEM_TRY(resume(d, continues && d->before.text ? d->before.text : ""));
    }
    (void)dem_walls_come_and_go(&d->state.walls, d->state.time);
    return DEM_OK;
}
