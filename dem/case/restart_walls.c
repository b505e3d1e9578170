/*
 * restart_walls.c -- walls at a restart: they go on from where they stood, and their contacts find
 * their facets, whose numbers change when walls are added or removed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/restart.h"
#include "core/error.h"
#include "core/memory.h"
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

int dem_api_resume_walls(struct dem_case *c)
{
    struct dem_walls *const w = &c->d->state.walls;

    for (int k = 0; k < w->walls; k++)
    {
        const struct dem_snapshot_wall *const was = find_wall(&c->d->before, k, w->wall[k].name);

        DEM_TRY(is_same_wall(c, &w->wall[k], was, 0)
                    ? dem_walls_resume_motion(w, k, &was->motion, &was->base, c->d->state.time)
                    : DEM_OK);
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

int dem_api_map_facets(struct dem_case *c, struct dem_snapshot_facets *map)
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
            DEM_TRY(dem_api_note(c->d, "restart: wall %s has other triangles than in the snapshot: it "
                                 "goes on without the history of its contacts", was->name));
        }
    }
    return DEM_OK;
}
