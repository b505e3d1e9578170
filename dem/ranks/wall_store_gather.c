/*
 * wall_store_gather.c -- triangles that all ranks hold: all of a wall that follows a mesh, and
 * all near a box.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/wall_store.h"
#include "core/error.h"
#include "core/memory.h"
#include "ranks/collect.h"

/* Collective. The records of all ranks that `own` lists, on each rank. */
static int gather_records(const struct dem_decomposition *d, int status,
                          const struct dem_wall_record *own, size_t n,
                          struct dem_wall_record **records, size_t *number)
{
    const struct dem_collect_items items = {"triangles (make the wall of several)", own, n,
                                            sizeof *own};
    void *all = NULL;

    status = dem_collect_gather(d, status, &items, &all, number);
    *records = all;
    return status;
}

/* After n records, those for triangles of other walls at rest or in a reference frame. */
static int hold_besides(struct dem_walls *w, int wall, struct dem_wall_record *all, size_t n)
{
    for (size_t t = 0; t < w->triangles; t++)
    {
        if (w->triangle[t].wall != wall && !w->wall[w->triangle[t].wall].follows_mesh)
        {
            dem_walls_record(w, t, &all[n++]);
        }
    }
    return dem_walls_hold(w, n, all);
}

int dem_wall_store_follow(struct dem_wall_store *s, struct dem_walls *w, int wall)
{
    size_t first = 0, end, n;
    struct dem_wall_record *all;
    int status = DEM_OK;

    if (s->decomposition->ranks == 1 || w->wall[wall].follows_mesh)
    {
        return DEM_OK;
    }
    while (first < s->n && s->record[first].triangle.wall != wall)
    {
        first++;
    }
    for (end = first; end < s->n && s->record[end].triangle.wall == wall; end++)
    {
    }
    DEM_TRY(gather_records(s->decomposition, DEM_OK, s->record + first, end - first, &all, &n));
    status = DEM_RESIZE(all, n, n + w->triangles);
    status = status ? status : hold_besides(w, wall, all, n);
    dem_memory_free(all);
    return dem_collect_agree(s->decomposition, status);
}

/* 1 when a box, or a periodic image of it, comes within reach of the other. */
static int meets_image(const struct dem_domain *d, double box[2][3], double other[2][3],
                       double reach)
{
    int meets = 1, range[2];

    for (int k = 0; k < 3; k++)
    {
        const double extent[2] = {box[0][k], box[1][k]},
                     around[2] = {other[0][k] - reach, other[1][k] + reach};

        dem_walls_image_range(d->length[k], extent, around, range);
        meets &= d->periodic[k] ? range[0] <= range[1]
                                : extent[0] <= around[1] && extent[1] >= around[0];
    }
    return meets;
}

int dem_wall_store_gather(const struct dem_wall_store *s, int status, const struct dem_walls *w,
                          const struct dem_domain *d, double box[2][3], double reach,
                          struct dem_walls *near)
{
    struct dem_wall_record *own = NULL, *all = NULL;
    size_t n = 0, total;

    *near = (struct dem_walls){.walls = 0};
    status = status ? status : DEM_NEW(own, s->n + 1);
    for (size_t t = 0; t < s->n && !status; t++)
    {
        double here[2][3];

        dem_walls_triangle_box(w, &s->record[t].triangle, here);
        if (!w->wall[s->record[t].triangle.wall].follows_mesh &&
            meets_image(d, box, here, reach))
        {
            own[n++] = s->record[t];
        }
    }
    status = gather_records(s->decomposition, status, own, n, &all, &total);
    dem_memory_free(own);
    DEM_TRY(status);
    status = dem_walls_copy_part(w, total, all, near);
    dem_memory_free(all);
    return status;
}
