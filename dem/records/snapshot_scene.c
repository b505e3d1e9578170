/*
 * snapshot_scene.c -- the scene in a snapshot: make its parts, read and check them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/snapshot_scene.h"
#include "core/error.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include "ranks/mpi_error.h"
#include <limits.h>
#include <math.h>
#include <string.h>

void dem_snapshot_scene_free(struct dem_snapshot_scene *s)
{
    dem_memory_free(s->wall);
    dem_memory_free(s->text);
    *s = (struct dem_snapshot_scene){.text = NULL};
}

struct dem_snapshot_wall dem_snapshot_scene_wall(const struct dem_walls *w, int wall)
{
    const struct dem_wall *const of = &w->wall[wall];
    struct dem_snapshot_wall record;

    memset(&record, 0, sizeof record);    /* padding, too, goes into the file */
    memcpy(record.name, of->name, sizeof of->name);
    record.shape = of->shape;
    record.outside = of->outside;
    record.first_facet = of->first_facet;
    record.facets = of->facets;
    record.triangles = (int64_t)of->triangles;
    dem_walls_form(of, record.form);
    record.base = dem_pose_identity;
    if (of->frame >= 0)
    {
        const struct dem_wall_frame *const f = &w->frame[of->frame];

        /* what a compound motion is stands in the text (case/restart_walls.c) */
        if (!f->compound)
        {
            memcpy(&record.motion, &f->motion, sizeof record.motion);
        }
        record.base = f->base;
    }
    return record;
}

static size_t text_bytes(const struct dem_snapshot_scene_tail *t)
{
    return (size_t)t->text;
}

static size_t wall_bytes(const struct dem_snapshot_scene_tail *t)
{
    return (size_t)t->walls*sizeof(struct dem_snapshot_wall);
}

void dem_snapshot_scene_spans(struct dem_snapshot_scene *s, struct dem_span *span)
{
    span[0] = (struct dem_span){s->wall, wall_bytes(&s->tail)};
    span[1] = (struct dem_span){s->text, text_bytes(&s->tail)};
    span[2] = (struct dem_span){&s->tail, sizeof s->tail};
}

/* ---- reading --------------------------------------------------------------------------------- */

int dem_snapshot_scene_size(struct dem_parallel_file *file, const struct dem_snapshot_header *h,
                            struct dem_snapshot_scene_tail *t, size_t *size)
{
    const size_t all = (size_t)h->caller_data;

    *t = (struct dem_snapshot_scene_tail){.walls = 0};
    *size = 0;
    if (all >= sizeof *t)
    {
        dem_parallel_file_read(file, dem_snapshot_caller_data_offset(h) + all - sizeof *t, t,
                               sizeof *t);
        DEM_TRY(file->status);
    }
    DEM_REQUIRE(all >= sizeof *t && t->walls >= 0 && t->text >= 8 && t->text%8 == 0
                    && (size_t)t->walls <= (all - sizeof *t)/sizeof(struct dem_snapshot_wall)
                    && (size_t)t->text <= all - sizeof *t - wall_bytes(t) && t->next_id >= 0
                    && t->text < INT_MAX,
                DEM_ERROR_FILE, "%s is damaged: its scene has %lld walls and %lld bytes of text, in "
                "%zu bytes; use another one", file->path, (long long)t->walls, (long long)t->text,
                all);
    *size = wall_bytes(t) + text_bytes(t) + sizeof *t;
    return DEM_OK;
}

static int is_finite(const double *number, size_t n)
{
    int good = 1;

    for (size_t k = 0; k < n; k++)
    {
        good &= isfinite(number[k]) != 0;
    }
    return good;
}

static int is_below_limit(double number)
{
    return isless(fabs(number), DEM_MOTION_LIMIT);
}

/* The facets of all walls are numbered one after the other, so their number is known. */
static int is_valid(const struct dem_snapshot_wall *w, int64_t facets)
{
    const struct dem_motion *const m = &w->motion;

    return dem_snapshot_is_name(w->name, sizeof w->name) && w->facets >= 0 && w->first_facet >= 0
        && w->facets <= INT_MAX && w->first_facet <= facets - w->facets && facets <= INT_MAX
        && is_finite(w->form, DEM_WALL_FORM) && m->kind >= DEM_MOTION_REST
        && m->kind <= DEM_MOTION_OSCILLATION && !isnan(m->end)
        && (m->stage[0] ? !isnan(m->start) : is_below_limit(m->start))
        && is_finite(m->velocity, 3) && is_finite(m->amplitude, 3) && is_below_limit(m->frequency)
        && is_below_limit(m->phase) && is_finite(m->origin, 3) && is_finite(m->axis, 3)
        && is_below_limit(m->omega) && is_finite(&w->base.rotation[0][0], 9)
        && is_finite(w->base.shift, 3);
}

static int check(const char *path, const struct dem_snapshot_scene *s)
{
    int64_t facets = 0;

    for (int64_t k = 0; k < s->tail.walls && facets <= INT_MAX; k++)
    {
        facets += s->wall[k].facets > 0 ? s->wall[k].facets : 0;
    }
    for (int64_t k = 0; k < s->tail.walls; k++)
    {
        DEM_REQUIRE(is_valid(&s->wall[k], facets), DEM_ERROR_FILE,
                    "%s is damaged: wall %lld of its scene has an invalid name, motion or number of "
                    "facets; use another one", path, (long long)k + 1);
    }
    DEM_REQUIRE(s->text[s->tail.text - 1] == '\0', DEM_ERROR_FILE,
                "%s is damaged: the text of its scene has no end; use another one", path);
    return DEM_OK;
}

/* On the first rank. */
static int read_parts(const char *path, struct dem_snapshot_scene *s)
{
    struct dem_parallel_file file;
    struct dem_snapshot_header h;
    size_t size;

    DEM_TRY(dem_snapshot_open(&file, &(const struct dem_file_ranks){.comm = MPI_COMM_NULL}, path,
                              &h));
    file.status = dem_snapshot_scene_size(&file, &h, &s->tail, &size);
    if (!file.status)
    {
        const size_t at = dem_snapshot_caller_data_offset(&h) + (size_t)h.caller_data - size;

        file.status = DEM_NEW(s->wall, s->tail.walls + 1);
        file.status = file.status ? file.status : DEM_NEW(s->text, s->tail.text);
        dem_parallel_file_read(&file, at, s->wall, wall_bytes(&s->tail));
        dem_parallel_file_read(&file, at + wall_bytes(&s->tail), s->text, text_bytes(&s->tail));
    }
    DEM_TRY(dem_parallel_file_close(&file));
    return check(path, s);
}

static int broadcast(const struct dem_decomposition *q, struct dem_snapshot_scene *s)
{
    if (q->ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY_MPI(MPI_Bcast(&s->tail, (int)sizeof s->tail, MPI_BYTE, 0, q->comm));
    int status = q->rank > 0 ? DEM_NEW(s->wall, s->tail.walls + 1) : DEM_OK;

    status = status || q->rank == 0 ? status : DEM_NEW(s->text, s->tail.text);
    DEM_TRY(dem_collect_agree(q, status));
    for (int64_t k = 0; k < s->tail.walls; k++)    /* one by one: an int counts the bytes */
    {
        DEM_TRY_MPI(MPI_Bcast(&s->wall[k], (int)sizeof *s->wall, MPI_BYTE, 0, q->comm));
    }
    DEM_TRY_MPI(MPI_Bcast(s->text, (int)s->tail.text, MPI_BYTE, 0, q->comm));
    return DEM_OK;
}

int dem_snapshot_read_scene(const char *path, const struct dem_decomposition *q,
                            struct dem_snapshot_scene *s)
{
    *s = (struct dem_snapshot_scene){.text = NULL};
    DEM_TRY(dem_collect_agree(q, q->rank == 0 ? read_parts(path, s) : DEM_OK));
    return broadcast(q, s);
}
