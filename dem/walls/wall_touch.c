/*
 * wall_touch.c -- contact points with walls: distance to planes and curved walls, nearest points of
 * triangles, removal of duplicates.
 *
 * A moving wall is treated in its own reference frame; the contact point and the normal are
 * returned in the fixed frame.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_touch.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* Points nearer than this fraction of the radius are one point: far above round-off, far below any
   overlap that matters. */
static const double same_point = 1e-7;

/* Cosine of the angle below which an edge is blunt: facets at larger angles are in reach together
   only at overlaps of more than 6 % of the radius. */
static const double blunt = 0.93969262078590838;           /* 20 degrees */

/* Sine of an angle below which the nearer facet counts alone: the exponent of overlaps is its
   inverse. */
static const double coplanar = 1e-3;

enum
{
    KEEP, DROP, CONTINUE    /* what becomes of a contact; CONTINUE: as a plane beyond its edge */
};

void dem_wall_touches_free(struct dem_wall_touches *t)
{
    dem_memory_free(t->touch);
    dem_memory_free(t->shared_first);
    dem_memory_free(t->list);
    memset(t, 0, sizeof *t);
}

int dem_wall_touches_reserve(struct dem_wall_touches *t, const struct dem_wall_search *s)
{
    t->shared = t->listed = 0;
    DEM_TRY(DEM_GROW(t->list, t->list_capacity, s->neighbors + 1));
    DEM_TRY(DEM_GROW(t->touch, t->capacity, s->neighbors + 1));
    return DEM_GROW(t->shared_first, t->shared_capacity, s->neighbors + 1);
}

static void touch_triangles(const struct dem_wall_search *s, const struct dem_walls *w,
                            const struct dem_wall_neighbor *near, const double x[3], double radius,
                            struct dem_wall_touch *t)
{
    struct dem_wall_touch face;
    double moved[3], away[3], apart[3];
    const double *const from = dem_wall_from_facet(w, near, x, moved);

    t->distance = dem_wall_search_nearest(s, w, near, x, t->point, away);
    face.distance =
        dem_facet_touch(&w->facet[near->facet], from, x, face.point, face.normal);
    for (int k = 0; k < 3; k++)
    {
        apart[k] = away[k] - face.distance*face.normal[k];
    }
    if ((dem_vec_norm(apart) < same_point*radius && !w->facet[near->facet].bent) ||
        t->distance == 0.0)
    {
        /* inside a facet: the plane's own normal, free of the round-off at edges */
        t->distance = dem_facet_touch(&w->facet[near->facet], from, x, t->point, t->normal);
        return;
    }
    for (int k = 0; k < 3; k++)
    {
        t->normal[k] = away[k]/t->distance;
    }
}

/* Contact with a facet, or (whole) with its plane or surface, unbounded. */
static void touch_facet(const struct dem_wall_search *s, const struct dem_walls *w,
                         const struct dem_wall_neighbor *near, const struct dem_particle *i,
                         int whole, struct dem_wall_touch *t)
{
    const struct dem_facet *const r = &w->facet[near->facet];
    const int frame = w->wall[r->wall].frame;
    struct dem_wall_touch own;
    double scratch[3], moved[3];
    const double *const x = dem_walls_to_frame(w, r->wall, i->x, scratch);

    if (whole || dem_wall_neighbor_open(w, near))
    {
        t->distance =
            dem_facet_touch(r, dem_wall_from_facet(w, near, x, moved), x, t->point, t->normal);
    }
    else
    {
        touch_triangles(s, w, near, x, i->radius, t);
    }
    if (frame >= 0)
    {
        own = *t;
        dem_pose_direction(&w->frame[frame].pose, own.normal, t->normal);
        dem_pose_point(&w->frame[frame].pose, own.point, t->point);
    }
}

/* 1 when a point, in the fixed frame, lies on the facet of a wall neighbor. */
static int lies_on(const struct dem_wall_search *s, const struct dem_walls *w,
                   const struct dem_wall_neighbor *near, const double point[3], double tolerance)
{
    const struct dem_facet *const r = &w->facet[near->facet];
    double on[3], scratch[3], moved[3], normal[3];
    const double *const x = dem_walls_to_frame(w, r->wall, point, scratch);

    if (dem_wall_neighbor_open(w, near))
    {
        return fabs(dem_facet_height(r, dem_wall_from_facet(w, near, x, moved), normal)) <
               tolerance;
    }
    return dem_wall_search_nearest(s, w, near, x, on, moved) < tolerance;
}

/* 1 when b takes precedence over a: a strict order, so that no two contacts are dropped in favour
   of each other. */
static int takes_precedence(size_t b, size_t a, const struct dem_wall_touch *touch)
{
    return touch[b].distance < touch[a].distance ||
           (touch[b].distance <= touch[a].distance && b < a);
}

static double square_apart(size_t a, size_t b, const struct dem_wall_touch *touch)
{
    double apart[3];

    dem_vec_minus(touch[a].point, touch[b].point, apart);
    return dem_vec_dot(apart, apart);
}

/* A point of a wall neighbor's facet, in the fixed frame: the middle of its triangle nearest to the
   particle. */
static void inner_point(const struct dem_wall_search *s, const struct dem_walls *w,
                        const struct dem_wall_neighbor *near, const struct dem_particle *i,
                        double point[3])
{
    const int wall = w->facet[near->facet].wall, frame = w->wall[wall].frame;
    double scratch[3], middle[3], moved[3];
    const double *const x = dem_walls_to_frame(w, wall, i->x, scratch);
    const uint32_t candidate = dem_wall_neighbor_candidate(s, w, near, x);
    const struct dem_triangle *const t = &w->triangle[s->candidate[candidate]];
    const double *const from = dem_wall_from_candidate(s, w, candidate, x, moved);

    for (int k = 0; k < 3; k++)
    {
        middle[k] = (t->corner[0][k] + t->corner[1][k] + t->corner[2][k])/3.0;
        middle[k] += from == x ? 0.0 : x[k] - from[k];
        point[k] = middle[k];
    }
    if (frame >= 0)
    {
        dem_pose_point(&w->frame[frame].pose, middle, point);
    }
}

/* What becomes of contact a: of the facets on which its nearest point lies the one nearest to the
   particle decides. Where a rises from that facet, on the particle's side, the surface of a is
   continued beyond the edge; else the other facet has the contact. */
static int fate(const struct dem_wall_search *s, const struct dem_walls *w, size_t a, size_t first,
                size_t end, const struct dem_particle *i, const struct dem_wall_touch *touch)
{
    const struct dem_wall_neighbor *const near = &s->neighbor[a];
    double inside[3], into[3];
    size_t by = end;

    for (size_t b = first; b < end; b++)
    {
        if (b != a && takes_precedence(b, a, touch) &&
            (by == end || takes_precedence(b, by, touch)) &&
            lies_on(s, w, &s->neighbor[b], touch[a].point, same_point*i->radius))
        {
            by = b;
        }
    }
    if (by == end)
    {
        return KEEP;
    }
    if (w->facet[near->facet].bent || dem_wall_neighbor_open(w, near))
    {
        return DROP;
    }
    inner_point(s, w, near, i, inside);
    dem_vec_minus(inside, touch[a].point, into);
    return dem_vec_dot(touch[by].normal, into) > same_point*i->radius ? CONTINUE : DROP;
}

/* Of facets that touch in the same point the first gets the contact. There the order by distance
   is round-off, and the contact history has to stay with one facet. */
static size_t first_there(size_t of, size_t first, double tolerance,
                          const struct dem_wall_touch *touch)
{
    size_t a = first;

    while (a < of &&
           (touch[a].distance >= DBL_MAX || square_apart(a, of, touch) >= tolerance*tolerance))
    {
        a++;
    }
    return a;
}

/* The deepest of the contacts that are kept and shallower than `last`; end: none. last = end: of
   all. */
static size_t next_deepest(size_t last, size_t first, size_t end, double radius,
                           const struct dem_wall_touch *touch)
{
    size_t deepest = end;

    for (size_t k = first; k < end; k++)
    {
        if (touch[k].drop == KEEP && touch[k].distance < radius &&
            (last == end || takes_precedence(last, k, touch)) &&
            (deepest == end || takes_precedence(k, deepest, touch)))
        {
            deepest = k;
        }
    }
    return deepest;
}

/* Contacts with facets at blunt angles to the deepest one, `leader`: one contact, see the header. */
static void blend(size_t leader, size_t first, size_t end, const struct dem_particle *i,
                  struct dem_wall_touch *touch)
{
    struct dem_wall_touch *const l = &touch[leader];
    const double deepest = i->radius - l->distance;
    double sum = 1.0, inverse = 0.0, along[3] = {l->normal[0], l->normal[1], l->normal[2]};

    for (size_t k = first; k < end; k++)
    {
        const double c = dem_vec_dot(touch[k].normal, l->normal);

        if (touch[k].drop || touch[k].distance >= i->radius || c <= blunt ||
            !takes_precedence(leader, k, touch))
        {
            continue;
        }
        const double sine = sqrt(fmax(1.0 - c*c, 0.0)), r = (i->radius - touch[k].distance)/deepest;

        touch[k].drop = DROP;
        if (sine > coplanar)
        {
            const double share = pow(r, 1.0/sine);

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
        /* the overlap d over the deepest one; the gradient of d */
        const double wider = pow(sum, inverse/(sum - 1.0)),
                     slope = wider*dem_vec_norm(along)/sum,
                     overlap = deepest*wider*pow(slope, 1.0/fmax(l->exponent, 1.0));

        l->distance = i->radius - overlap;
        for (int m = 0; m < 3; m++)
        {
            l->normal[m] = along[m]/dem_vec_norm(along);
            l->point[m] = i->x[m] - l->distance*l->normal[m];
        }
    }
}

/* Mark first, drop afterwards: a contact may duplicate one that is a duplicate itself, down to the
   nearest one of a curved surface. */
static void drop_duplicates(const struct dem_wall_search *s, const struct dem_walls *w,
                            size_t first, size_t end, const struct dem_particle *i,
                            struct dem_wall_touch *touch)
{
    const double radius = i->radius;

    for (size_t a = first; a < end; a++)
    {
        if (touch[a].distance < radius)
        {
            touch[a].drop = fate(s, w, a, first, end, i, touch);
        }
    }
    for (size_t a = first; a < end; a++)
    {
        if (touch[a].drop == KEEP && touch[a].distance < radius)
        {
            touch[a].drop = DROP;
            touch[first_there(a, first, same_point*radius, touch)].drop = KEEP;
        }
    }
    for (size_t a = first; a < end; a++)
    {
        if (touch[a].drop == CONTINUE)
        {
            touch_facet(s, w, &s->neighbor[a], i, 1, &touch[a]);
            touch[a].drop = KEEP;
        }
    }
    /* from the deepest contact on; what is left is at larger angles to it */
    for (size_t leader = next_deepest(end, first, end, radius, touch); leader < end;
         leader = next_deepest(leader, first, end, radius, touch))
    {
        blend(leader, first, end, i, touch);
    }
    for (size_t a = first; a < end; a++)
    {
        touch[a].distance = touch[a].drop ? DBL_MAX : touch[a].distance;
    }
}

/* A wall neighbor without a row is too far away to touch or to take over a contact, until lists are
   pruned again. */
void dem_wall_touches_update(struct dem_wall_touches *t, const struct dem_wall_search *s,
                             const struct dem_walls *w, const struct dem_particles *p)
{
    size_t k = 0;

    t->shared = 0;
    while (k < t->listed)
    {
        const uint32_t first = t->list[k], particle = s->neighbor[first].particle;
        const struct dem_particle *const i = &p->record[particle];
        uint32_t last = first;
        int touching = 0;

        for (; k < t->listed && s->neighbor[t->list[k]].particle == particle; k++)
        {
            last = t->list[k];
            touch_facet(s, w, &s->neighbor[last], i, 0, &t->touch[last]);
            t->touch[last].drop = 0;
            touching += t->touch[last].distance < i->radius;
        }
        if (touching > 1)
        {
            drop_duplicates(s, w, first, last + 1, i, t->touch);
            t->shared_first[t->shared++] = first;
        }
    }
}
