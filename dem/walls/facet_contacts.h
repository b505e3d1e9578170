/*
 * facet_contacts.h -- contacts of one particle with several facets: which of them count, and blunt
 * edges as one contact (wall_touch.h). Devices compile it, too.
 *
 * Before this file is included, define `struct dem_facets_near`, the facets that the particle is near,
 * in the order of their numbers and images, and for facet k of them
 *
 *   dem_facets_near_whole(v, k)          1: a contact with its unbounded surface
 *   dem_facets_near_lies_on(v, k, ...)   1: a point, in the fixed frame, lies on the facet
 *   dem_facets_near_inner(v, k, ...)     a point of the facet, in the fixed frame: the middle of its
 *                                        triangle nearest to the particle
 *   dem_facets_near_continue(v, k, ...)  the contact with its unbounded surface
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/math.h"
#include "core/vec.h"
#include "walls/facet_touch.h"

/* Cosine of the angle below which an edge is blunt: facets at larger angles are in reach together
   only at overlaps of more than 6 % of the radius. */
#define DEM_BLUNT 0.93969262078590838           /* 20 degrees */

/* Sine of an angle below which the nearer facet counts alone: the exponent of overlaps is its
   inverse. */
#define DEM_COPLANAR 1e-3

enum
{
    DEM_CONTACT_KEEP, DEM_CONTACT_DROP,
    DEM_CONTACT_CONTINUE    /* as a plane beyond its edge */
};

struct dem_facet_contacts    /* facets [first, end) of those near a particle */
{
    const struct dem_facets_near *near;
    struct dem_wall_touch *touch;
    size_t first, end;
    double x[3], radius;    /* m  of the particle */
};

/* 1 when b takes precedence over a: a strict order, so that no two contacts are dropped in favour
   of each other. */
static inline int dem_contact_precedes(size_t b, size_t a, const struct dem_wall_touch *touch)
{
    return touch[b].distance < touch[a].distance ||
           (touch[b].distance <= touch[a].distance && b < a);
}

/* What becomes of contact a: of the facets on which its nearest point lies the one nearest to the
   particle decides. Where a rises from that facet, on the particle's side, the surface of a is
   continued beyond the edge; else the other facet has the contact. */
static inline int dem_contact_fate(const struct dem_facet_contacts *c, size_t a)
{
    const double near = DEM_SAME_POINT*c->radius;
    double inside[3], into[3];
    size_t by = c->end;

    for (size_t b = c->first; b < c->end; b++)
    {
        if (b != a && dem_contact_precedes(b, a, c->touch) &&
            (by == c->end || dem_contact_precedes(b, by, c->touch)) &&
            dem_facets_near_lies_on(c->near, b, c->touch[a].point, near))
        {
            by = b;
        }
    }
    if (by == c->end)
    {
        return DEM_CONTACT_KEEP;
    }
    if (dem_facets_near_whole(c->near, a))
    {
        return DEM_CONTACT_DROP;
    }
    dem_facets_near_inner(c->near, a, c->x, inside);
    dem_vec_minus(inside, c->touch[a].point, into);
    return dem_vec_dot(c->touch[by].normal, into) > near ? DEM_CONTACT_CONTINUE : DEM_CONTACT_DROP;
}

/* Of facets that touch in the same point the first gets the contact. There the order by distance
   is round-off, and the contact history has to stay with one facet. */
static inline size_t dem_contact_first_there(const struct dem_facet_contacts *c, size_t of)
{
    const double tolerance = DEM_SAME_POINT*c->radius;
    size_t a = c->first;

    for (; a < of; a++)
    {
        double apart[3];

        dem_vec_minus(c->touch[a].point, c->touch[of].point, apart);
        if (c->touch[a].distance < DBL_MAX && dem_vec_dot(apart, apart) < tolerance*tolerance)
        {
            break;
        }
    }
    return a;
}

/* The deepest of the contacts that are kept and shallower than `last`; end: none. last = end: of
   all. */
static inline size_t dem_contact_next_deepest(const struct dem_facet_contacts *c, size_t last)
{
    size_t deepest = c->end;

    for (size_t k = c->first; k < c->end; k++)
    {
        if (c->touch[k].drop == DEM_CONTACT_KEEP && c->touch[k].distance < c->radius &&
            (last == c->end || dem_contact_precedes(last, k, c->touch)) &&
            (deepest == c->end || dem_contact_precedes(k, deepest, c->touch)))
        {
            deepest = k;
        }
    }
    return deepest;
}

/* The contact of a blunt edge, from the deepest one: `sum` and `inverse` of the shares of all
   contacts, and `along`, their normals by share. */
static inline void dem_contact_set_blunt(const struct dem_facet_contacts *c, double sum,
                                         double inverse, const double along[3],
                                         struct dem_wall_touch *l)
{
    /* the overlap d over the deepest one; the gradient of d */
    const double deepest = c->radius - l->distance, wider = dem_pow(sum, inverse/(sum - 1.0)),
                 slope = wider*dem_vec_norm(along)/sum,
                 overlap = deepest*wider*dem_pow(slope, 1.0/fmax(l->exponent, 1.0));

    l->distance = c->radius - overlap;
    for (int m = 0; m < 3; m++)
    {
        l->normal[m] = along[m]/dem_vec_norm(along);
        l->point[m] = c->x[m] - l->distance*l->normal[m];
    }
}

/* Contacts with facets at blunt angles to the deepest one, `leader`: one contact. */
static inline void dem_contact_blend(const struct dem_facet_contacts *c, size_t leader)
{
    struct dem_wall_touch *const touch = c->touch, *const l = &touch[leader];
    const double deepest = c->radius - l->distance;
    double sum = 1.0, inverse = 0.0, along[3] = {l->normal[0], l->normal[1], l->normal[2]};

    for (size_t k = c->first; k < c->end; k++)
    {
        const double cosine = dem_vec_dot(touch[k].normal, l->normal);

        if (touch[k].drop || touch[k].distance >= c->radius || cosine <= DEM_BLUNT ||
            !dem_contact_precedes(leader, k, touch))
        {
            continue;
        }
        const double sine = sqrt(fmax(1.0 - cosine*cosine, 0.0)),
                     r = (c->radius - touch[k].distance)/deepest;

        touch[k].drop = DEM_CONTACT_DROP;
        if (sine > DEM_COPLANAR)
        {
            const double share = dem_pow(r, 1.0/sine);

            sum += share;
            inverse += share*sine;
            for (int m = 0; m < 3; m++)
            {
                along[m] += share/r*touch[k].normal[m];
            }
        }
    }
    if (inverse > 0.0)
    {
        dem_contact_set_blunt(c, sum, inverse, along, l);
    }
}

/* Mark first, drop afterwards: a contact may duplicate one that is a duplicate itself, down to the
   nearest one of a curved surface. A dropped contact has the distance DBL_MAX. */
static inline void dem_contact_drop_duplicates(const struct dem_facet_contacts *c)
{
    struct dem_wall_touch *const touch = c->touch;

    for (size_t a = c->first; a < c->end; a++)
    {
        if (touch[a].distance < c->radius)
        {
            touch[a].drop = dem_contact_fate(c, a);
        }
    }
    for (size_t a = c->first; a < c->end; a++)
    {
        if (touch[a].drop == DEM_CONTACT_KEEP && touch[a].distance < c->radius)
        {
            touch[a].drop = DEM_CONTACT_DROP;
            touch[dem_contact_first_there(c, a)].drop = DEM_CONTACT_KEEP;
        }
    }
    for (size_t a = c->first; a < c->end; a++)
    {
        if (touch[a].drop == DEM_CONTACT_CONTINUE)
        {
            dem_facets_near_continue(c->near, a, c->x, &touch[a]);
            touch[a].drop = DEM_CONTACT_KEEP;
        }
    }
    /* from the deepest contact on; what is left is at larger angles to it */
    for (size_t leader = dem_contact_next_deepest(c, c->end); leader < c->end;
         leader = dem_contact_next_deepest(c, leader))
    {
        dem_contact_blend(c, leader);
    }
    for (size_t a = c->first; a < c->end; a++)
    {
        touch[a].distance = touch[a].drop ? DBL_MAX : touch[a].distance;
    }
}
