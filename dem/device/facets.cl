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
    return h->touch[row] & DEM_DEVICE_TOUCHES ? h->history[(size_t)m*h->stride + row] : 0.0;
}

static void dem_spring_put(const struct dem_spring_rows *h, int m, uint row, double value)
{
    for (int c = 0; !(h->touch[row] & DEM_DEVICE_TOUCHES) && c < h->columns; c++)
    {
        h->history[(size_t)c*h->stride + row] = 0.0;
    }
    h->touch[row] = DEM_DEVICE_TOUCHES;
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
