/*
 * facet_springs.h -- friction springs and other history of a particle with several wall contacts:
 * grouped by surface, springs divided by overlap, numbers handed on. Devices compile it, too.
 *
 * Before this file is included, define `struct dem_spring_rows`, the history of rows, with the member
 * `columns`, and
 *
 *   dem_spring_kind(h, m)             what column m holds (spring_kinds.h)
 *   dem_spring_get(h, m, row)         its value in a row
 *   dem_spring_put(h, m, row, value)
 *   dem_spring_any(h, row)            1: a value of the row is not zero
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/vec.h"
#include "walls/facet_touch.h"
#include "walls/spring_kinds.h"

/* Cosine of the largest angle between the normals of two facets of one surface. A choice: facets of
   a round wall of 12 sides and more are one surface, the sides of a groove are two. */
#define DEM_NEARLY_FLAT 0.86602540378443865    /* 30 degrees */

#define DEM_SPRINGS_NONE 0x7fffffffu

struct dem_facet_springs    /* wall contacts of one particle, some of them on one surface */
{
    const struct dem_spring_rows *rows;
    struct dem_wall_touch *touch;
    size_t first, end;
    uint32_t leader;        /* the deepest contact of the surface */
    double radius;          /* m */
};

/* The smallest rotation that takes unit vector a to b: v - (a + b) (a + b).v/(1 + a.b) + 2 b
   (a.v). */
static inline void dem_spring_rotate(const double a[3], const double b[3], double v[3])
{
    const double c[3] = {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const double factor = dem_vec_dot(c, v)/(1.0 + dem_vec_dot(a, b)),
                 twice = 2.0*dem_vec_dot(a, v);

    for (int k = 0; k < 3; k++)
    {
        v[k] += twice*b[k] - factor*c[k];
    }
}

static inline double dem_spring_overlap(const struct dem_wall_touch *t, double radius)
{
    return t->distance < radius ? radius - t->distance : 0.0;
}

/* Tangential stiffness of a contact, up to a factor common to contacts of the same materials. */
static inline double dem_spring_weight(const struct dem_wall_touch *t, double radius)
{
    return t->exponent > 1.25 ? sqrt(dem_spring_overlap(t, radius)) : 1.0;
}

/* Divide the sum of the springs of a surface among its contacts, by overlap; m: first history
   column of the spring. */
static inline void dem_springs_divide(const struct dem_facet_springs *s, int m)
{
    const struct dem_wall_touch *const touch = s->touch, *const leader = &touch[s->leader];
    double total[3] = {0.0, 0.0, 0.0}, sum = 0.0, v[3];

    for (size_t k = s->first; k < s->end; k++)
    {
        if (touch[k].surface == s->leader)
        {
            const double d = dem_spring_overlap(&touch[k], s->radius),
                         w = dem_spring_weight(d > 0.0 ? &touch[k] : leader, s->radius);

            for (int a = 0; a < 3; a++)
            {
                v[a] = dem_spring_get(s->rows, m + a, touch[k].row);
            }
            dem_spring_rotate(touch[k].normal, leader->normal, v);
            for (int a = 0; a < 3; a++)
            {
                total[a] += w*v[a];
            }
            sum += w*d;
        }
    }
    for (size_t k = s->first; k < s->end; k++)
    {
        if (touch[k].surface == s->leader && dem_spring_overlap(&touch[k], s->radius) > 0.0)
        {
            const double fraction = dem_spring_overlap(&touch[k], s->radius)/sum;

            for (int a = 0; a < 3; a++)
            {
                v[a] = fraction*total[a];
            }
            dem_spring_rotate(leader->normal, touch[k].normal, v);
            for (int a = 0; a < 3; a++)
            {
                dem_spring_put(s->rows, m + a, touch[k].row, v[a]);
            }
        }
    }
}

/* Scalar history goes from a contact that has ended to those that are new. */
static inline void dem_springs_transfer_numbers(const struct dem_facet_springs *s)
{
    const struct dem_wall_touch *const touch = s->touch;
    size_t ended = s->end;

    for (size_t k = s->first; k < s->end; k++)
    {
        ended = touch[k].surface == s->leader && touch[k].drop ? k : ended;
    }
    for (size_t k = s->first; k < s->end && ended < s->end; k++)
    {
        if (touch[k].surface != s->leader || touch[k].drop ||
            dem_spring_any(s->rows, touch[k].row))
        {
            continue;
        }
        for (int m = 0; m < s->rows->columns; m++)
        {
            if (dem_spring_kind(s->rows, m) == DEM_SPRING_NUMBER)
            {
                dem_spring_put(s->rows, m, touch[k].row,
                               dem_spring_get(s->rows, m, touch[ended].row));
            }
        }
    }
}

/* Mark all contacts on the surface of the leader: those that touch, or that another facet has just
   taken over. Returns their number. */
static inline int dem_springs_gather(const struct dem_facet_springs *s)
{
    struct dem_wall_touch *const touch = s->touch;
    int count = 0;

    for (size_t k = s->first; k < s->end; k++)
    {
        const int ended = touch[k].drop && touch[k].row != DEM_SPRINGS_NONE &&
                          dem_spring_any(s->rows, touch[k].row);

        if (touch[k].surface == DEM_SPRINGS_NONE && touch[k].row != DEM_SPRINGS_NONE &&
            (ended || dem_spring_overlap(&touch[k], s->radius) > 0.0) &&
            dem_vec_dot(touch[k].normal, touch[s->leader].normal) > DEM_NEARLY_FLAT)
        {
            touch[k].surface = s->leader;
            count++;
        }
    }
    return count;
}

/* All surfaces of a particle. */
static inline void dem_springs_redistribute(struct dem_facet_springs *s)
{
    struct dem_wall_touch *const touch = s->touch;

    for (size_t k = s->first; k < s->end; k++)
    {
        touch[k].surface = DEM_SPRINGS_NONE;
    }
    for (;;)
    {
        s->leader = DEM_SPRINGS_NONE;
        for (size_t k = s->first; k < s->end; k++)
        {
            if (touch[k].surface == DEM_SPRINGS_NONE && touch[k].row != DEM_SPRINGS_NONE &&
                touch[k].distance < s->radius &&
                (s->leader == DEM_SPRINGS_NONE || touch[k].distance < touch[s->leader].distance))
            {
                s->leader = (uint32_t)k;
            }
        }
        if (s->leader == DEM_SPRINGS_NONE)
        {
            return;
        }
        if (dem_springs_gather(s) > 1)
        {
            dem_springs_transfer_numbers(s);
            for (int m = 0; m < s->rows->columns; m++)
            {
                if (dem_spring_kind(s->rows, m) == DEM_SPRING_VECTOR)
                {
                    dem_springs_divide(s, m);
                }
            }
        }
    }
}
