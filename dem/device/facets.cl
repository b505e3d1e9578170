/*
 * facets.cl -- contacts of particles with facets, where a scene has triangles or several facets, or
 * walls that absorb: one work item a particle finds the contact with each facet near it, drops those that others have, and
 * divides the springs of those on one surface. Kernels of wall rows read the contacts.
 *
 * The host defines CLASS_EXPONENTS, the exponents of the normal laws by pair class, SPRING_KINDS, and
 * HISTORY, the number of history columns.
 *
 * A wall row has a uint4: the first of its candidate triangles; their number; 1 when the contact is with
 * the unbounded surface; the image of the facet. A candidate is a triangle, above it its image.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/facet_image.h"
#include "walls/triangle_nearest.h"
#include "walls/facet_touch.h"

constant double dem_exponents[] = {CLASS_EXPONENTS};

/* The whole periods n of an image from its code; codes are in the order of n. */
static void dem_image_numbers(uint code, int8_t n[3])
{
    n[0] = (int8_t)((int)(code >> 6 & 7) - 4);
    n[1] = (int8_t)((int)(code >> 3 & 7) - 4);
    n[2] = (int8_t)((int)(code & 7) - 4);
}

struct dem_facets_near    /* of a particle: those whose contact may matter, in the order of rows */
{
    global const struct dem_facet *facets;
    global const struct dem_device_frame *frames;
    global const struct dem_device_images *images;    /* of each frame, after those at rest */
    global const struct dem_device_triangle *triangles;
    global const uint *candidates;
    uint facet[DEM_DEVICE_NEAR];
    uint4 row[DEM_DEVICE_NEAR];
};

static void dem_to_frame(const struct dem_facets_near *v, int frame, const double x[3],
                         double own[3])
{
    if (frame >= 0)
    {
        const struct dem_pose pose = v->frames[frame].pose;

        dem_pose_to_frame(&pose, x, own);
        return;
    }
    for (int k = 0; k < 3; k++)
    {
        own[k] = x[k];
    }
}

/* Where a particle at x, in the frame, is when an image is taken back. Returns 1 when it is elsewhere. */
static int dem_from_image(const struct dem_facets_near *v, int frame, uint code, const double x[3],
                          double from[3])
{
    int8_t n[3];

    dem_image_numbers(code, n);
    for (int k = 0; k < 3; k++)
    {
        from[k] = n[k] ? x[k] - n[k]*v->images[frame + 1].period[k] : x[k];
    }
    return code != DEM_DEVICE_NO_IMAGE;
}

/* As dem_wall_search_nearest. `middle`: of the triangle. */
static double dem_nearest_of_row(const struct dem_facets_near *v, uint4 row, int frame,
                                 const double x[3], double point[3], double away[3],
                                 double middle[3])
{
    double best = DBL_MAX, here[3], from[3];

    for (uint c = row.x; c < row.x + row.y; c++)
    {
        const uint candidate = v->candidates[c];
        const struct dem_device_triangle t =
            v->triangles[candidate & (DEM_DEVICE_TRIANGLES - 1)];
        const int moved = dem_from_image(v, frame, candidate >> DEM_DEVICE_TRIANGLE_BITS, x, from);
        const double square = dem_corners_nearest(t.corner, from, here);

        if (square < best)
        {
            best = square;
            dem_vec_minus(from, here, away);
            for (int k = 0; k < 3; k++)
            {
                const double off = x[k] - from[k];

                point[k] = moved ? here[k] + off : here[k];
                middle[k] = (t.corner[0][k] + t.corner[1][k] + t.corner[2][k])/3.0;
                middle[k] += moved ? off : 0.0;
            }
        }
    }
    return sqrt(best);
}

/* The contact of a particle with a facet; whole: with its unbounded surface, if it has a limit. */
static void dem_touch_row(const struct dem_facets_near *v, uint f, uint4 row, int whole,
                          const double at[3], double radius, struct dem_wall_touch *t)
{
    const struct dem_facet facet = v->facets[f];
    double x[3], from[3], away[3], middle[3];

    dem_to_frame(v, facet.wall, at, x);
    dem_from_image(v, facet.wall, row.w, x, from);
    if (whole || row.z)
    {
        t->distance = dem_facet_touch(&facet, from, x, t->point, t->normal);
    }
    else
    {
        t->distance = dem_nearest_of_row(v, row, facet.wall, x, t->point, away, middle);
        dem_facet_touch_triangles(&facet, from, x, away, radius, t);
    }
    if (facet.wall >= 0)
    {
        const struct dem_wall_touch own = *t;
        const struct dem_pose pose = v->frames[facet.wall].pose;

        dem_pose_direction(&pose, own.normal, t->normal);
        dem_pose_point(&pose, own.point, t->point);
    }
}

/* ---- several facets ---------------------------------------------------------------------------- */

static int dem_facets_near_whole(const struct dem_facets_near *v, size_t k)
{
    return v->row[k].z != 0;
}

static int dem_facets_near_lies_on(const struct dem_facets_near *v, size_t k, const double point[3],
                                   double tolerance)
{
    const struct dem_facet facet = v->facets[v->facet[k]];
    double x[3], from[3], on[3], away[3], middle[3];

    dem_to_frame(v, facet.wall, point, x);
    if (v->row[k].z)
    {
        dem_from_image(v, facet.wall, v->row[k].w, x, from);
        return fabs(dem_facet_height(&facet, from, on)) < tolerance;
    }
    return dem_nearest_of_row(v, v->row[k], facet.wall, x, on, away, middle) < tolerance;
}

static void dem_facets_near_inner(const struct dem_facets_near *v, size_t k, const double at[3],
                                  double point[3])
{
    const int frame = v->facets[v->facet[k]].wall;
    double x[3], on[3], away[3], middle[3];

    dem_to_frame(v, frame, at, x);
    dem_nearest_of_row(v, v->row[k], frame, x, on, away, middle);
    for (int m = 0; m < 3; m++)
    {
        point[m] = middle[m];
    }
    if (frame >= 0)
    {
        const struct dem_pose pose = v->frames[frame].pose;

        dem_pose_point(&pose, middle, point);
    }
}

static void dem_facets_near_continue(const struct dem_facets_near *v, size_t k, const double x[3],
                                     struct dem_wall_touch *touch)
{
    dem_touch_row(v, v->facet[k], v->row[k], 1, x, 0.0, touch);
}

#include "walls/facet_contacts.h"

/* ---- springs ----------------------------------------------------------------------------------- */

#if HISTORY
constant int dem_spring_kinds_of[] = {SPRING_KINDS};

struct dem_spring_rows    /* zero where touch is 0 */
{
    global double *history;
    global uchar *touch;
    uint stride;
    int columns;
};

static int dem_spring_kind(const struct dem_spring_rows *h, int m)
{
    return dem_spring_kinds_of[m];
}

static double dem_spring_get(const struct dem_spring_rows *h, int m, uint row)
{
    return h->touch[row] ? h->history[(size_t)m*h->stride + row] : 0.0;
}

static void dem_spring_put(const struct dem_spring_rows *h, int m, uint row, double value)
{
    for (int c = 0; !h->touch[row] && c < h->columns; c++)
    {
        h->history[(size_t)c*h->stride + row] = 0.0;
    }
    h->touch[row] = 1;
    h->history[(size_t)m*h->stride + row] = value;
}

static int dem_spring_any(const struct dem_spring_rows *h, uint row)
{
    int any = 0;

    for (int m = 0; m < h->columns; m++)
    {
        any |= dem_spring_get(h, m, row) != 0.0;
    }
    return any;
}

#include "walls/facet_springs.h"
#endif

/* ---- the kernel -------------------------------------------------------------------------------- */

static void dem_store_contact(global double4 *contact, const struct dem_wall_touch *t)
{
    contact[0] = (double4)(t->point[0], t->point[1], t->point[2], t->distance);
    contact[1] = (double4)(t->normal[0], t->normal[1], t->normal[2], 0.0);
}

/* The contacts of all rows in memory; returns how many facets may matter, which are in `touch`: all
   that touch, and those that touch but for rounding. *touching: how many do. */
static size_t dem_touch_rows(constant struct dem_device_batch *b,
                             global struct dem_device_report *report, uint s,
                             struct dem_facets_near *v, uint first, uint end, global const uint *restrict entry,
                             global const uint2 *restrict partners,
                             global const uint4 *restrict near, const double x[3], double radius,
                             struct dem_wall_touch *touch, global double4 *restrict contact,
                             int *touching)
{
    size_t n = 0;

    for (uint e = first; e < end; e++)
    {
        const uint row = entry[e] >> 1, facet = partners[row].y;
#if TRIANGLES
        const uint4 of = near[row - b->walls];
#else
        const uint4 of = (uint4)(0, 0, 1, DEM_DEVICE_NO_IMAGE);
#endif
        struct dem_wall_touch t;

        t.drop = 0;
        t.row = row;
        dem_touch_row(v, facet, of, 0, x, radius, &t);
        dem_store_contact(contact + 2*(size_t)(row - b->walls), &t);
        *touching += t.distance < radius;
        if (t.distance < radius*(1.0 + 1e-6) && v->facets[facet].largest & DEM_DEVICE_ABSORBS)
        {
            dem_report_event(report, DEM_DEVICE_ABSORBED, s);
        }
        if (t.distance < radius*(1.0 + 1e-6) && n++ < DEM_DEVICE_NEAR)
        {
            v->facet[n - 1] = facet;
            v->row[n - 1] = of;
            touch[n - 1] = t;
        }
    }
    return n;
}

kernel void wall_contacts(constant struct dem_device_batch *b,
                          global struct dem_device_report *report, uint s, uint materials,
                          global const double4 *restrict record,
                          global const uint2 *restrict partners,
                          global const struct dem_facet *restrict facets,
                          global const struct dem_device_frame *restrict frames,
                          global const uint *restrict start, global const uint *restrict entry,
                          global uchar *restrict touched, global double *restrict history,
                          global const uint4 *restrict near, global const uint *restrict candidates,
                          global const struct dem_device_triangle *restrict triangles,
                          global const struct dem_device_images *restrict images,
                          global const int *restrict wall_classes, global double4 *restrict contact)
{
    const uint i = get_global_id(0);

    if (dem_used_up(b, report, s) || i >= b->particles)
    {
        return;
    }
    uint first = start[i + 1];

    while (first > start[i] && entry[first - 1] >> 1 >= b->walls)
    {
        first--;
    }
    if (first == start[i + 1])
    {
        return;
    }
    const double4 at = record[4*(size_t)i];
    const uint material = (uint)as_ulong(record[4*(size_t)i + 3].z) & 0xffffu;
    struct dem_facets_near v = {.facets = facets, .frames = frames + s*b->frames, .images = images,
                                .triangles = triangles, .candidates = candidates};
    struct dem_wall_touch touch[DEM_DEVICE_NEAR];
    struct dem_facet_contacts c = {.near = &v, .touch = touch, .x = {at.x, at.y, at.z},
                                   .radius = at.w};
    int touching = 0;

    c.end = dem_touch_rows(b, report, s, &v, first, start[i + 1], entry, partners, near, c.x, at.w, touch,
                           contact, &touching);
    if (touching < 2)
    {
        return;
    }
    if (c.end > DEM_DEVICE_NEAR)
    {
        dem_report_event(report, DEM_DEVICE_FACETS, s);
        return;
    }
    for (size_t k = 0; k < c.end; k++)
    {
        touch[k].exponent = dem_exponents[wall_classes[v.facet[k]*materials + material]];
    }
    dem_contact_drop_duplicates(&c);
#if HISTORY
    const struct dem_spring_rows rows = {.history = history, .touch = touched, .stride = b->stride,
                                         .columns = HISTORY};
    struct dem_facet_springs springs = {.rows = &rows, .touch = touch, .end = c.end, .radius = at.w};

    dem_springs_redistribute(&springs);
#endif
    for (size_t k = 0; k < c.end; k++)
    {
        dem_store_contact(contact + 2*(size_t)(touch[k].row - b->walls), &touch[k]);
    }
}

#if TRIANGLES
/* ---- candidates for lists ---------------------------------------------------------------------- */

/* The first and last cell of the grid of triangles along an axis, as wall_grid.c finds them. */
static void dem_triangle_cells(constant struct dem_device_lists *l, int axis, double low, double high,
                               int range[2])
{
    const double a = floor((low - l->grid_origin[axis])/l->grid_edge),
                 b = floor((high - l->grid_origin[axis])/l->grid_edge);

    range[0] = a < 0.0 ? 0 : a > l->grid_cells[axis] ? l->grid_cells[axis] : (int)a;
    range[1] = b < -1.0 ? -1 : b > l->grid_cells[axis] - 1 ? l->grid_cells[axis] - 1 : (int)b;
}

/* 1 in the first of the cells of a search that have this triangle. */
static int dem_first_cell(constant struct dem_device_lists *l, const double corner[3][3],
                          int range[3][2], const int cell[3])
{
    int first = 1;

    for (int k = 0; k < 3; k++)
    {
        const double low = fmin(corner[0][k], fmin(corner[1][k], corner[2][k]));
        int own[2];

        dem_triangle_cells(l, k, low - 1e-9*l->grid_edge, low, own);
        first &= cell[k] == max(own[0], range[k][0]);
    }
    return first;
}

/* The image of a triangle's facet, from the image of the triangle. */
static uint dem_image_of_facet(uint image, uint place, uint endless)
{
    int8_t n[3];

    dem_image_numbers(image, n);
    for (int k = 0; k < 3; k++)
    {
        n[k] = endless >> k & 1 ? 0 : (int8_t)(n[k] - dem_shift_axis((int)place, k));
    }
    return (uint)((n[0] + 4) << 6 | (n[1] + 4) << 3 | (n[2] + 4));
}

/* Where a candidate is in the order: facet, image of the facet, triangle, image of the triangle. */
static ulong2 dem_candidate_order(global const struct dem_device_triangle *triangles,
                                  global const struct dem_facet *facets, uint candidate)
{
    const uint t = candidate & (DEM_DEVICE_TRIANGLES - 1),
               image = candidate >> DEM_DEVICE_TRIANGLE_BITS, f = triangles[t].facet;

    return (ulong2)((ulong)f << 16 | dem_image_of_facet(image, triangles[t].place, facets[f].endless),
                    (ulong)t << 16 | image);
}

static void dem_insert_candidate(global const struct dem_device_triangle *triangles,
                                 global const struct dem_facet *facets, global uint *list, uint n,
                                 uint candidate)
{
    const ulong2 order = dem_candidate_order(triangles, facets, candidate);
    uint at = n;

    for (; at > 0; at--)
    {
        const ulong2 other = dem_candidate_order(triangles, facets, list[at - 1]);

        if (other.x < order.x || (other.x == order.x && other.y < order.y))
        {
            break;
        }
        list[at] = list[at - 1];
    }
    list[at] = candidate;
}

/* Triangles of a frame within reach of x, in it, counted and inserted into the list unless that is
   NULL. Returns the number of candidates. */
static uint dem_gather_image(constant struct dem_device_lists *l,
                             global const struct dem_device_triangle *triangles,
                             global const struct dem_facet *facets, global const uint *first,
                             global const uint *grid, int frame, const double x[3], double reach,
                             uint image, global uint *list, uint n)
{
    int range[3][2], cell[3];

    for (int k = 0; k < 3; k++)
    {
        dem_triangle_cells(l, k, x[k] - reach, x[k] + reach, range[k]);
    }
    for (cell[2] = range[2][0]; cell[2] <= range[2][1]; cell[2]++)
    {
        for (cell[1] = range[1][0]; cell[1] <= range[1][1]; cell[1]++)
        {
            for (cell[0] = range[0][0]; cell[0] <= range[0][1]; cell[0]++)
            {
                const size_t at = ((size_t)cell[2]*l->grid_cells[1] + cell[1])*l->grid_cells[0] +
                                  cell[0];

                for (uint e = first[at]; e < first[at + 1]; e++)
                {
                    const struct dem_device_triangle t = triangles[grid[e]];
                    double on[3];

                    if (t.frame == frame && dem_first_cell(l, t.corner, range, cell) &&
                        dem_corners_nearest(t.corner, x, on) < reach*reach)
                    {
                        if (list)
                        {
                            dem_insert_candidate(triangles, facets, list, n,
                                                 grid[e] | image << DEM_DEVICE_TRIANGLE_BITS);
                        }
                        n++;
                    }
                }
            }
        }
    }
    return n;
}

/* The same with periodic images. */
static uint dem_gather_frame(constant struct dem_device_lists *l,
                             global const struct dem_device_triangle *triangles,
                             global const struct dem_facet *facets,
                             global const struct dem_device_images *images,
                             global const uint *first, global const uint *grid, int frame,
                             const double x[3], double reach, global uint *list, uint n)
{
    const struct dem_device_images of = images[frame + 1];
    int range[3][2];

    for (int k = 0; k < 3; k++)
    {
        const double all[2] = {l->grid_origin[k], l->grid_origin[k] + l->grid_cells[k]*l->grid_edge},
                     around[2] = {x[k] - reach, x[k] + reach};

        dem_walls_image_range(of.period[k], all, around, range[k]);
    }
    for (int a = range[0][0]; a <= range[0][1]; a++)
    {
        for (int b = range[1][0]; b <= range[1][1]; b++)
        {
            for (int c = range[2][0]; c <= range[2][1]; c++)
            {
                const double from[3] = {a ? x[0] - a*of.period[0] : x[0],
                                        b ? x[1] - b*of.period[1] : x[1],
                                        c ? x[2] - c*of.period[2] : x[2]};

                n = dem_gather_image(l, triangles, facets, first, grid, frame, from, reach,
                                     (uint)((a + 4) << 6 | (b + 4) << 3 | (c + 4)), list, n);
            }
        }
    }
    return n;
}

/* counting: the number of candidates of each particle; then the candidates, in order. */
kernel void lists_triangles(constant struct dem_device_lists *l, uint counting,
                            global const double4 *restrict record,
                            global const struct dem_device_triangle *restrict triangles,
                            global const struct dem_facet *restrict facets,
                            global const struct dem_device_frame *restrict frames,
                            global const struct dem_device_images *restrict images,
                            global const uint *restrict first, global const uint *restrict grid,
                            global uint *start, global uint *candidates)
{
    const uint i = get_global_id(0);

    if (i >= l->particles ||
        (!l->keep_frozen && (as_ulong(record[4*(size_t)i + 3].z) >> 16 & 1)))
    {
        return;
    }
    const double4 at = record[4*(size_t)i];
    const double x[3] = {at.x, at.y, at.z};
    global uint *const list = counting ? 0 : candidates + start[i];
    uint n = 0;

    for (int frame = -1; frame < l->frames; frame++)
    {
        double own[3] = {at.x, at.y, at.z};

        if (!images[frame + 1].triangles)
        {
            continue;
        }
        if (frame >= 0)
        {
            const struct dem_pose pose = frames[frame].pose;

            dem_pose_to_frame(&pose, x, own);
        }
        n = dem_gather_frame(l, triangles, facets, images, first, grid, frame, own, at.w + l->gap,
                             list, n);
    }
    if (counting)
    {
        start[i] = n;
    }
}

/* 1 when the rim of the facet of a candidate is within reach. */
static int dem_rim_in_reach(const struct dem_facets_near *v, uint candidate, int frame,
                            const double x[3], double reach)
{
    const struct dem_device_triangle t = v->triangles[candidate & (DEM_DEVICE_TRIANGLES - 1)];
    double from[3], on[3];
    int found = 0;

    dem_from_image(v, frame, candidate >> DEM_DEVICE_TRIANGLE_BITS, x, from);
    for (int k = 0; k < 3; k++)
    {
        found |= (t.rim >> k & 1) &&
                 dem_edge_nearest(t.corner[k], t.corner[(k + 1)%3], from, on) < reach*reach;
    }
    return found;
}

/* What wall rows have to know of each facet: from the candidates of their particle. */
kernel void lists_near(constant struct dem_device_lists *l, global const double4 *restrict record,
                       global const struct dem_device_triangle *restrict triangles,
                       global const struct dem_facet *restrict facets,
                       global const struct dem_device_frame *restrict frames,
                       global const struct dem_device_images *restrict images,
                       global const uint *restrict start, global const uint *restrict entry,
                       global const uint2 *restrict partners,
                       global const uint *restrict candidate_start,
                       global const uint *restrict candidates, global uint4 *restrict near)
{
    const uint i = get_global_id(0);
    struct dem_facets_near v = {.facets = facets, .frames = frames, .images = images,
                                .triangles = triangles, .candidates = candidates};

    if (i >= l->particles)
    {
        return;
    }
    const double4 at = record[4*(size_t)i];
    const double global_x[3] = {at.x, at.y, at.z};
    uint c = candidate_start[i];

    for (uint e = start[i]; e < start[i + 1]; e++)
    {
        const uint row = entry[e] >> 1;
        uint4 of = (uint4)(c, 0, 1, DEM_DEVICE_NO_IMAGE);

        if (row < l->walls)
        {
            continue;
        }
        const uint f = partners[row].y;
        const int frame = facets[f].wall;
        double x[3];

        if (facets[f].shape == DEM_SHAPE_TRIANGLES)
        {
            const ulong order = dem_candidate_order(triangles, facets, candidates[c]).x;

            dem_to_frame(&v, frame, global_x, x);
            of.w = (uint)order & 0xffffu;
            for (; c < candidate_start[i + 1] &&
                   dem_candidate_order(triangles, facets, candidates[c]).x == order;
                 c++)
            {
                of.z &= !dem_rim_in_reach(&v, candidates[c], frame, x, at.w + l->gap);
                of.y++;
            }
        }
        near[row - l->walls] = of;
    }
}
#endif
