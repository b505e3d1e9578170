/*
 * restart_walls.c -- walls at a restart: they go on from where they stood and with their wear, and
 * their contacts find their facets, whose numbers change when walls are added or removed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/restart.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/text.h"
#include "records/wall_wear.h"
#include <stdlib.h>
#include <string.h>

/* The wall of the snapshot with this name, as a rule number k; NULL: none. */
static const struct dem_snapshot_wall *find_wall(const struct dem_snapshot_scene *s, int k,
                                                 const char *name)
{
    if (k < s->tail.walls && strcmp(s->wall[k].name, name) == 0)
    {
        return &s->wall[k];
    }
    for (int64_t w = 0; w < s->tail.walls; w++)
    {
        if (strcmp(s->wall[w].name, name) == 0)
        {
            return &s->wall[w];
        }
    }
    return NULL;
}

static int is_reformed(const struct dem_case *c, const char *name)
{
    int found = 0;

    for (size_t k = 0; k < c->reformed_walls; k++)
    {
        found |= strcmp(c->reformed[k], name) == 0;
    }
    return found;
}

/* Of triangles the form is known only when the walls are finished. */
static int is_same_wall(const struct dem_case *c, const struct dem_wall *of,
                        const struct dem_snapshot_wall *was, int finished)
{
    const int triangles = of->shape == DEM_SHAPE_TRIANGLES;
    double form[DEM_WALL_FORM];

    dem_walls_form(of, form);
    return was && was->shape == of->shape && was->outside == of->outside
        && !is_reformed(c, of->name) && (triangles && !finished ? 1
                                         : dem_walls_same_form(form, was->form, triangles));
}

int dem_sim_wall_goes_on(const struct dem_case *c, int k)
{
    const struct dem_wall *const of = &c->d->state.walls.wall[k];

    return is_same_wall(c, of, find_wall(&c->d->before, k, of->name), 1);
}

/* ---- compound motions ------------------------------------------------------------------------ */

/* A line of the scene's text for each wall with a compound motion; words of 16 hexadecimal digits: the
   hashes of the motion, the pose of the frame, the state of a body. */
static const char mark[] = "@wall ";

enum
{
    HASHES = sizeof(struct dem_motion_hash)/sizeof(uint64_t),
    POSE_WORDS = sizeof(struct dem_pose)/sizeof(double),
    WORDS = HASHES + POSE_WORDS + DEM_WALL_BODY_WORDS
};

static void write_words(struct dem_text *t, const void *from, int n)
{
    for (int k = 0; k < n; k++)
    {
        uint64_t bits;

        memcpy(&bits, (const char *)from + 8*k, sizeof bits);
        dem_text_add(t, "%016llx ", (unsigned long long)bits);
    }
}

void dem_sim_describe_motions(const struct dem_walls *w, double time, struct dem_text *t)
{
    static const struct dem_wall_body_state none;

    for (int k = 0; k < w->walls; k++)
    {
        const int frame = w->wall[k].frame;
        const struct dem_wall_frame *const f = frame < 0 ? NULL : &w->frame[frame];

        if (f && f->compound)
        {
            const struct dem_motion_hash hash = dem_compound_motion_hash(f->compound);
            struct dem_pose pose;

            dem_wall_frame_pose(f, time, &pose);
            dem_text_add(t, "%s", mark);
            write_words(t, &hash, HASHES);
            write_words(t, &pose, POSE_WORDS);
            write_words(t, f->compound->body ? &f->compound->body->state : &none,
                        DEM_WALL_BODY_WORDS);
            dem_text_add(t, "%s\n", w->wall[k].name);
        }
    }
}

/* Do the words of a line stand for this wall? They go to `was`. */
static int read_line(const char *words, const char *name, struct dem_wall_before *was)
{
    const size_t length = strlen(name);
    const char *at = words;
    uint64_t word[WORDS];

    for (int k = 0; k < WORDS; k++)
    {
        char *end;

        word[k] = strtoull(at, &end, 16);

        if (end != at + 16 || *end != ' ')
        {
            return 0;
        }
        at = end + 1;
    }
    memcpy(&was->hash, word, sizeof was->hash);
    memcpy(&was->stood, word + HASHES, sizeof was->stood);
    memcpy(&was->body, word + HASHES + POSE_WORDS, sizeof was->body);
    return strncmp(at, name, length) == 0 && at[length] == '\n';
}

/* The motion of a wall in the snapshot. */
static struct dem_wall_before find_motion(const char *text, const struct dem_snapshot_wall *w)
{
    struct dem_wall_before was = {.motion = w->motion, .base = w->base};

    for (const char *words; !was.compound && (words = dem_text_marked(&text, mark));)
    {
        was.compound = read_line(words, w->name, &was);
    }
    return was;
}

/* A hinge that goes on would be put between narrower stops in one step. */
static int refuse_beyond_stops(const struct dem_wall *of, const struct dem_wall_body *b)
{
    static const double rounding = 1e-9;

    DEM_REQUIRE(!b || b->kind != DEM_WALL_BODY_HINGE
                    || (b->state.q[0] >= b->stops[0] - rounding && b->state.q[0] <= b->stops[1] + rounding),
                DEM_ERROR_INPUT,
                "walls/%s/motion/stops (%g %g) rad, but in the snapshot the hinge has turned by %.9g rad; give stops "
                "with this angle between them", of->name, b->stops[0], b->stops[1], b->state.q[0]);
    return DEM_OK;
}

int dem_sim_resume_walls(struct dem_case *c)
{
    struct dem_walls *const w = &c->d->state.walls;

    for (int k = 0; k < w->walls; k++)
    {
        const struct dem_snapshot_wall *const was = find_wall(&c->d->before, k, w->wall[k].name);

        if (is_same_wall(c, &w->wall[k], was, 0))
        {
            const struct dem_wall_before before = find_motion(c->d->before.text, was);

            int rows;

            DEM_TRY(dem_walls_resume_motion(w, k, &before, c->d->state.time, &rows));
            DEM_TRY(rows ? dem_sim_note(c->d, "restart: the table of the motion of wall %s has other "
                                        "rows than before: the wall goes on from where it stood",
                                        was->name)
                         : DEM_OK);
            const struct dem_wall_body *const b = dem_walls_body(w, k);

            DEM_TRY(refuse_beyond_stops(&w->wall[k], b));
            DEM_TRY(b && b->state.loaded > 0.0
                        ? dem_sim_note(c->d, "restart: wall %s has the load that the program has set, not the "
                                       "scene's", was->name)
                        : DEM_OK);
        }
    }
    return DEM_OK;
}

/* A wall that has the facets of the snapshot. */
static int keeps_facets(const struct dem_case *c, const struct dem_wall *of,
                        const struct dem_snapshot_wall *was)
{
    return is_same_wall(c, of, was, 1) && was->facets == of->facets
        && was->triangles == (int64_t)of->triangles;
}

int dem_sim_map_facets(struct dem_case *c, struct dem_snapshot_facets *map)
{
    const struct dem_walls *const w = &c->d->state.walls;

    *map = (struct dem_snapshot_facets){.changed = c->d->before.tail.walls != w->walls};
    DEM_TRY(DEM_NEW(map->wall, w->walls));
    for (int k = 0; k < w->walls; k++)
    {
        const struct dem_wall *const of = &w->wall[k];
        const struct dem_snapshot_wall *const was = find_wall(&c->d->before, k, of->name);
        const int keeps = keeps_facets(c, of, was);

        map->changed |= !keeps || was->first_facet != of->first_facet;
        if (keeps)
        {
            map->wall[map->walls++] =
                (struct dem_facet_range){was->first_facet, was->facets, of->first_facet};
        }
        else if (was && is_same_wall(c, of, was, 0) && !c->new_run)
        {
            DEM_TRY(dem_sim_note(c->d, "restart: wall %s has other triangles than in the snapshot: it "
                                 "goes on without the history of its contacts", was->name));
        }
    }
    return DEM_OK;
}

int dem_sim_resume_wear(struct dem_case *c)
{
    struct dem *const d = c->d;

    for (int k = 0; k < d->state.walls.walls && d->before.text && d->state.decomposition.rank == 0; k++)
    {
        const struct dem_wall *const of = &d->state.walls.wall[k];
        const struct dem_snapshot_wall *const was = find_wall(&d->before, k, of->name);

        if (of->wear > 0.0 && keeps_facets(c, of, was))
        {
            DEM_TRY(dem_wall_wear_resume(&d->state, k, d->before.text, c->load_path));
        }
    }
    return DEM_OK;
}
