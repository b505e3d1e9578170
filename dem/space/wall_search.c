/*
 * wall_search.c -- a dense grid of triangles, and for each particle the regions in its reach.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/wall_search.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/vec.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* Far above round-off and what counts as flat, and little: a triangle further off than the plane of its region is not looked at. */
static const double surely_out = 1.001;

enum
{
    MOST_CELLS = 1 << 21
};

void dem_wall_search_free(struct dem_wall_search *s)
{
    dem_memory_free(s->start);
    dem_memory_free(s->entry);
    dem_memory_free(s->near);
    dem_memory_free(s->candidate);
    dem_memory_free(s->seen);
    memset(s, 0, sizeof *s);
}

/* ---- nearest point ------------------------------------------------------------------------------------------- */

static double nearest_on_edge(const double a[3], const double b[3], const double x[3], double nearest[3])
{
    double ab[3], ax[3], d[3];

    dem_vec_minus(b, a, ab);
    dem_vec_minus(x, a, ax);
    const double along = dem_vec_dot(ax, ab)/dem_vec_dot(ab, ab);
    const double t = along < 0.0 ? 0.0 : along > 1.0 ? 1.0 : along;

    for (int k = 0; k < 3; k++)
    {
        nearest[k] = a[k] + t*ab[k];
        d[k] = x[k] - nearest[k];
    }
    return dem_vec_dot(d, d);
}

double dem_triangle_nearest(const struct dem_triangle *t, const double x[3], double nearest[3])
{
    double ab[3], ac[3], n[3], d[3], best = INFINITY;
    int inside = 1;

    dem_vec_minus(t->corner[1], t->corner[0], ab);
    dem_vec_minus(t->corner[2], t->corner[0], ac);
    dem_vec_cross(ab, ac, n);
    for (int k = 0; k < 3 && inside; k++)
    {
        const double *const a = t->corner[k];
        double edge[3], to[3], out[3];

        dem_vec_minus(t->corner[(k + 1)%3], a, edge);
        dem_vec_minus(x, a, to);
        dem_vec_cross(edge, n, out);
        inside = dem_vec_dot(to, out) <= 0.0;
    }
    if (inside)
    {
        dem_vec_minus(x, t->corner[0], d);
        const double height = dem_vec_dot(d, n)/dem_vec_dot(n, n);

        for (int k = 0; k < 3; k++)
        {
            nearest[k] = x[k] - height*n[k];
        }
        return height*height*dem_vec_dot(n, n);
    }
    for (int k = 0; k < 3; k++)
    {
        double on[3];
        const double square = nearest_on_edge(t->corner[k], t->corner[(k + 1)%3], x, on);

        if (square < best)
        {
            best = square;
            memcpy(nearest, on, sizeof on);
        }
    }
    return best;
}

double dem_wall_search_nearest(const struct dem_wall_search *s, const struct dem_walls *w, const struct dem_wall_near *near,
                               const double x[3], double point[3])
{
    double best = DBL_MAX, here[3];

    for (uint32_t c = near->first; c < near->first + near->count; c++)
    {
        const double square = dem_triangle_nearest(&w->triangle[s->candidate[c]], x, here);

        if (square < best)
        {
            best = square;
            memcpy(point, here, sizeof here);
        }
    }
    return sqrt(best);
}

double dem_wall_search_distance(const struct dem_wall_search *s, const struct dem_walls *w, const struct dem_wall_near *near,
                                const double world[3])
{
    const struct dem_region *const r = &w->region[near->region];
    double room[3], there[3];
    const double *const x = dem_walls_own(w, r->wall, world, room);

    if (!dem_wall_near_open(w, near))
    {
        return dem_wall_search_nearest(s, w, near, x, there);
    }
    const double h = dem_region_height(r, x, there);

    return r->shape == DEM_SHAPE_TRIANGLES ? fabs(h) : h;
}

/* ---- the grid ------------------------------------------------------------------------------------------------ */

static void triangle_box(const struct dem_triangle *t, double box[2][3])
{
    for (int k = 0; k < 3; k++)
    {
        box[0][k] = fmin(t->corner[0][k], fmin(t->corner[1][k], t->corner[2][k]));
        box[1][k] = fmax(t->corner[0][k], fmax(t->corner[1][k], t->corner[2][k]));
    }
}

static void cell_range(const struct dem_wall_search *s, double box[2][3], double margin, int from[3], int to[3])
{
    for (int k = 0; k < 3; k++)
    {
        const double a = floor((box[0][k] - margin - s->origin[k])/s->edge);
        const double b = floor((box[1][k] + margin - s->origin[k])/s->edge);

        from[k] = a < 0.0 ? 0 : a > s->cells[k] ? s->cells[k] : (int)a;
        to[k] = b < -1.0 ? -1 : b > s->cells[k] - 1 ? s->cells[k] - 1 : (int)b;
    }
}

/* Call for each cell of a range; with entry NULL only count. */
static void enter(struct dem_wall_search *s, const struct dem_walls *w, size_t *place, uint32_t *entry)
{
    for (size_t t = 0; t < w->triangles; t++)
    {
        double box[2][3];
        int from[3], to[3];

        triangle_box(&w->triangle[t], box);
        cell_range(s, box, 1e-9*s->edge, from, to);
        for (int z = from[2]; z <= to[2]; z++)
        {
            for (int y = from[1]; y <= to[1]; y++)
            {
                for (int x = from[0]; x <= to[0]; x++)
                {
                    const size_t cell = ((size_t)z*(size_t)s->cells[1] + (size_t)y)*(size_t)s->cells[0] + (size_t)x;

                    if (entry)
                    {
                        entry[place[cell]] = (uint32_t)t;
                    }
                    place[cell]++;
                }
            }
        }
    }
}

static void size_grid(struct dem_wall_search *s, const struct dem_walls *w, double radius)
{
    double all[2][3] = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}}, cells = 1.0;

    for (size_t t = 0; t < w->triangles; t++)
    {
        double box[2][3];

        triangle_box(&w->triangle[t], box);
        for (int k = 0; k < 3; k++)
        {
            all[0][k] = fmin(all[0][k], box[0][k]);
            all[1][k] = fmax(all[1][k], box[1][k]);
        }
    }
    s->edge = 3.0*radius;
    do
    {
        cells = 1.0;
        for (int k = 0; k < 3; k++)
        {
            s->origin[k] = all[0][k];
            cells *= s->cells[k] = (int)fmin(2.0*MOST_CELLS, (all[1][k] - all[0][k])/s->edge) + 1;
        }
        s->edge *= cells > MOST_CELLS ? 1.26 : 1.0;
    } while (cells > MOST_CELLS);
}

int dem_wall_search_prepare(struct dem_wall_search *s, const struct dem_walls *w, double radius)
{
    size_t *place;

    if (w->triangles == 0)
    {
        return DEM_OK;
    }
    dem_memory_free(s->start);
    dem_memory_free(s->entry);
    dem_memory_free(s->seen);
    s->stamp = 0;
    s->radius = radius;
    s->journey = w->journey;
    size_grid(s, w, radius);
    const size_t cells = (size_t)s->cells[0]*(size_t)s->cells[1]*(size_t)s->cells[2];

    DEM_TRY(DEM_NEW(s->start, cells + 1));
    DEM_TRY(DEM_NEW(place, cells + 1));
    DEM_TRY(DEM_NEW(s->seen, w->triangles));
    enter(s, w, place, NULL);
    for (size_t c = 0; c < cells; c++)
    {
        s->start[c + 1] = s->start[c] + place[c];
        place[c] = s->start[c];
    }
    DEM_TRY(DEM_NEW(s->entry, s->start[cells] + 1));
    enter(s, w, place, s->entry);
    dem_memory_free(place);
    return DEM_OK;
}

/* ---- looking ------------------------------------------------------------------------------------------------- */

static int new_near(struct dem_wall_search *s, uint32_t particle, int region, int open, struct dem_wall_near **near)
{
    DEM_TRY(DEM_GROW(s->near, s->near_room, s->nears + 1));
    *near = &s->near[s->nears++];
    **near = (struct dem_wall_near){.particle = particle, .region = region, .open = open, .first = (uint32_t)s->candidates};
    return DEM_OK;
}

/* Regions without triangles come first. */
static int wholes_near(struct dem_wall_search *s, const struct dem_walls *w, const struct dem_particle *p, uint32_t particle,
                       double skin)
{
    struct dem_wall_near *near;
    double room[3], normal[3];

    for (int r = 0; r < w->regions && w->region[r].shape != DEM_SHAPE_TRIANGLES; r++)
    {
        const double *const x = dem_walls_own(w, w->region[r].wall, p->x, room);

        if (dem_region_height(&w->region[r], x, normal) < p->radius + skin)
        {
            DEM_TRY(new_near(s, particle, r, 1, &near));
        }
    }
    return DEM_OK;
}

static inline double plane_height(const struct dem_walls *w, uint32_t t, const double x[3])
{
    const struct dem_region *const r = &w->region[w->triangle[t].region];

    return dem_vec_dot(r->normal, x) - r->offset;
}

/* The triangles in reach, each once, of the walls that move this way (-1: rest), in whose frame x is. */
static int gather_triangles(struct dem_wall_search *s, const struct dem_walls *w, int moving, const double x[3], double reach)
{
    double box[2][3], nearest[3];
    int from[3], to[3];

    memcpy(box[0], x, sizeof box[0]);
    memcpy(box[1], x, sizeof box[1]);
    cell_range(s, box, reach, from, to);
    s->stamp++;
    for (int z = from[2]; z <= to[2]; z++)
    {
        for (int y = from[1]; y <= to[1]; y++)
        {
            const size_t row = ((size_t)z*(size_t)s->cells[1] + (size_t)y)*(size_t)s->cells[0];

            for (size_t e = s->start[row + (size_t)from[0]]; from[0] <= to[0] && e < s->start[row + (size_t)to[0] + 1]; e++)
            {
                const uint32_t t = s->entry[e];

                if (s->seen[t] != s->stamp && w->wall[w->triangle[t].wall].moving == moving
                    && fabs(plane_height(w, t, x)) < surely_out*reach && dem_triangle_nearest(&w->triangle[t], x, nearest) < reach*reach)
                {
                    DEM_TRY(DEM_GROW(s->candidate, s->candidate_room, s->candidates + 1));
                    s->candidate[s->candidates++] = t;
                }
                s->seen[t] = s->stamp;
            }
        }
    }
    return DEM_OK;
}

static void sort_by_region(const struct dem_walls *w, uint32_t *t, size_t n)
{
    for (size_t k = 1; k < n; k++)
    {
        const uint32_t here = t[k];
        size_t m = k;

        for (; m > 0 && (w->triangle[t[m - 1]].region > w->triangle[here].region
                         || (w->triangle[t[m - 1]].region == w->triangle[here].region && t[m - 1] > here)); m--)
        {
            t[m] = t[m - 1];
        }
        t[m] = here;
    }
}

static int rim_in_reach(const struct dem_triangle *t, const double x[3], double reach)
{
    double on[3];

    for (int k = 0; k < 3; k++)
    {
        if ((t->rim >> k & 1u) && nearest_on_edge(t->corner[k], t->corner[(k + 1)%3], x, on) < reach*reach)
        {
            return 1;
        }
    }
    return 0;
}

static int regions_near(struct dem_wall_search *s, const struct dem_walls *w, const struct dem_particle *p, uint32_t particle,
                        double skin)
{
    const size_t first = s->candidates;
    const double reach = p->radius + skin;
    struct dem_wall_near *near = NULL;
    double room[3];

    DEM_TRY(gather_triangles(s, w, -1, p->x, reach));
    for (int k = 0; k < w->movings; k++)
    {
        if (w->moving[k].triangles)
        {
            dem_pose_own(&w->moving[k].pose, p->x, room);
            DEM_TRY(gather_triangles(s, w, k, room, reach));
        }
    }
    if (s->candidates > first)                            /* no list may be there yet */
    {
        sort_by_region(w, s->candidate + first, s->candidates - first);
    }
    for (size_t c = first; c < s->candidates; c++)
    {
        const struct dem_triangle *const t = &w->triangle[s->candidate[c]];

        if (!near || near->region != t->region)
        {
            DEM_TRY(new_near(s, particle, t->region, 1, &near));
            near->first = (uint32_t)c;
        }
        near->count++;
        near->open &= !rim_in_reach(t, dem_walls_own(w, t->wall, p->x, room), reach);
    }
    return DEM_OK;
}

int dem_wall_search_find(struct dem_wall_search *s, const struct dem_walls *w, const struct dem_particles *q, double skin)
{
    s->nears = s->candidates = 0;
    if (w->journey > s->journey)
    {
        DEM_TRY(dem_wall_search_prepare(s, w, s->radius));
    }
    for (size_t i = 0; i < q->n; i++)
    {
        DEM_TRY(wholes_near(s, w, &q->record[i], (uint32_t)i, skin));
        if (w->triangles > 0)
        {
            DEM_TRY(regions_near(s, w, &q->record[i], (uint32_t)i, skin));
        }
    }
    return DEM_OK;
}

int dem_wall_search_is_clear(struct dem_wall_search *s, const struct dem_walls *w, const struct dem_particle *q, int *clear)
{
    const size_t nears = s->nears, candidates = s->candidates;

    if (w->journey > s->journey)
    {
        DEM_TRY(dem_wall_search_prepare(s, w, s->radius));
    }
    DEM_TRY(wholes_near(s, w, q, 0, 0.0));
    if (w->triangles > 0)
    {
        DEM_TRY(regions_near(s, w, q, 0, 0.0));
    }
    *clear = s->nears == nears;
    s->nears = nears;
    s->candidates = candidates;
    return DEM_OK;
}

uint32_t dem_wall_near_triangle(const struct dem_wall_search *s, const struct dem_walls *w, const struct dem_wall_near *near,
                                const double x[3])
{
    uint32_t nearest = s->candidate[near->first];
    double best = INFINITY, on[3];

    for (uint32_t c = near->first; c < near->first + near->count; c++)
    {
        const double square = dem_triangle_nearest(&w->triangle[s->candidate[c]], x, on);

        if (square < best)
        {
            best = square;
            nearest = s->candidate[c];
        }
    }
    return nearest;
}
