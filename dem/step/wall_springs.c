/*
 * wall_springs.c -- one pass over the touches, particle by particle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/wall_springs.h"
#include "base/vec.h"
#include <math.h>
#include <string.h>

/* Cosine of the angle between the normals of two regions of one surface. A choice: facets of a round wall of 12 sides and
   more are one surface, the sides of a groove are two. */
static const double nearly_flat = 0.86602540378443865;    /* 30 degrees */

enum
{
    NOBODY = DEM_ROW_NONE
};

enum column                                               /* what a remembered column is */
{
    OWN,                                                  /* of a bond or a film: stays where it was made */
    NUMBER,
    VECTOR,                                               /* and the next two columns */
    REST_OF_VECTOR
};

struct surface                                            /* contacts of one particle, of which some are on one surface */
{
    size_t first, end;
    const enum column *column;
    uint32_t leader;                                      /* the deepest of them */
    double radius;                                        /* m */
};

static int is_vector(const struct dem_recipe *r, int m)
{
    const size_t length = strlen(r->memory[m]);

    return m + 2 < r->memories && length > 2 && strcmp(r->memory[m] + length - 2, "_x") == 0;
}

static void tell_columns(const struct dem_recipe *r, enum column *column)
{
    for (int m = 0; m < r->memories; m++)
    {
        column[m] = is_vector(r, m) ? VECTOR : NUMBER;
        column[m] = m > 0 && column[m - 1] == VECTOR ? REST_OF_VECTOR : column[m];
        column[m] = m > 1 && column[m - 2] == VECTOR ? REST_OF_VECTOR : column[m];
    }
    for (int s = 0; s < r->classes; s++)
    {
        for (int k = 0; k < r->chain[s].links; k++)
        {
            const struct dem_link *const link = &r->chain[s].link[k];

            for (int m = 0; m < dem_effect_memories(link->effect) && link->effect->stage >= DEM_STAGE_BOND; m++)
            {
                column[link->memory + m] = OWN;
            }
        }
    }
}

/* ---- handing on ---------------------------------------------------------------------------------------------- */

/* The smallest rotation that takes unit vector a to b: v - (a + b) (a + b).v/(1 + a.b) + 2 b (a.v). */
static void turn(const double a[3], const double b[3], double v[3])
{
    const double c[3] = {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const double share = dem_vec_dot(c, v)/(1.0 + dem_vec_dot(a, b)), twice = 2.0*dem_vec_dot(a, v);

    for (int k = 0; k < 3; k++)
    {
        v[k] += twice*b[k] - share*c[k];
    }
}

static double overlap(const struct dem_wall_touch *t, double radius)
{
    return t->distance < radius ? radius - t->distance : 0.0;
}

/* Tangential stiffness of a contact over that of another of the same materials. */
static double weight(const struct dem_parts *p, const struct dem_wall_touch *t, double radius)
{
    const struct dem_pair *const q = &p->contacts.pair[p->contacts.row_pair[t->row]];
    const double exponent = p->recipe.chain[q->class].pair.exponent, d = overlap(t, radius);

    return exponent > 1.25 ? sqrt(d) : 1.0;
}

static void divide(struct dem_parts *p, const struct surface *s, int m)
{
    const struct dem_wall_touch *const touch = p->touches.touch;
    double *const *const memory = p->contacts.memory, total[3] = {0.0, 0.0, 0.0}, sum = 0.0;

    for (size_t k = s->first; k < s->end; k++)
    {
        if (touch[k].surface == s->leader)
        {
            const double d = overlap(&touch[k], s->radius), w = weight(p, &touch[d > 0.0 ? k : s->leader], s->radius);
            double v[3] = {memory[m][touch[k].row], memory[m + 1][touch[k].row], memory[m + 2][touch[k].row]};

            turn(touch[k].normal, touch[s->leader].normal, v);
            for (int a = 0; a < 3; a++)
            {
                total[a] += w*v[a];
            }
            sum += w*d;
        }
    }
    for (size_t k = s->first; k < s->end; k++)
    {
        if (touch[k].surface == s->leader && overlap(&touch[k], s->radius) > 0.0)
        {
            const double share = overlap(&touch[k], s->radius)/sum;
            double v[3] = {share*total[0], share*total[1], share*total[2]};

            turn(touch[s->leader].normal, touch[k].normal, v);
            for (int a = 0; a < 3; a++)
            {
                memory[m + a][touch[k].row] = v[a];
            }
        }
    }
}

/* Numbers that are no vector go from contacts that have ended to those that are new. */
static void pass_numbers(struct dem_parts *p, const struct surface *s)
{
    const struct dem_wall_touch *const touch = p->touches.touch;
    struct dem_contacts *const c = &p->contacts;
    size_t ended = s->end;

    for (size_t k = s->first; k < s->end; k++)
    {
        ended = touch[k].surface == s->leader && touch[k].drop ? k : ended;
    }
    for (size_t k = s->first; k < s->end && ended < s->end; k++)
    {
        if (touch[k].surface == s->leader && !touch[k].drop && !dem_contacts_remembers(c, touch[k].row))
        {
            for (int m = 0; m < c->memories; m++)
            {
                c->memory[m][touch[k].row] = s->column[m] == NUMBER ? c->memory[m][touch[ended].row] : c->memory[m][touch[k].row];
            }
        }
    }
}

/* Mark as the leader's all contacts on its surface: that touch, or that another region has taken over just now. */
static int gather_surface(struct dem_parts *p, const struct surface *s)
{
    struct dem_wall_touch *const touch = p->touches.touch;
    int count = 0;

    for (size_t k = s->first; k < s->end; k++)
    {
        const int ended = touch[k].drop && touch[k].row != DEM_ROW_NONE && dem_contacts_remembers(&p->contacts, touch[k].row);

        if (touch[k].surface == NOBODY && touch[k].row != DEM_ROW_NONE && (ended || overlap(&touch[k], s->radius) > 0.0)
            && dem_vec_dot(touch[k].normal, touch[s->leader].normal) > nearly_flat)
        {
            touch[k].surface = s->leader;
            count++;
        }
    }
    return count;
}

static void share_of_particle(struct dem_parts *p, const enum column *column, size_t first, size_t end, double radius)
{
    struct dem_wall_touch *const touch = p->touches.touch;
    struct surface s = {.first = first, .end = end, .column = column, .radius = radius};

    for (size_t k = first; k < end; k++)
    {
        touch[k].surface = NOBODY;
    }
    for (;;)
    {
        s.leader = NOBODY;
        for (size_t k = first; k < end; k++)
        {
            if (touch[k].surface == NOBODY && touch[k].row != DEM_ROW_NONE && touch[k].distance < radius
                && (s.leader == NOBODY || touch[k].distance < touch[s.leader].distance))
            {
                s.leader = (uint32_t)k;
            }
        }
        if (s.leader == NOBODY)
        {
            return;
        }
        if (gather_surface(p, &s) > 1)
        {
            pass_numbers(p, &s);
            for (int m = 0; m < p->contacts.memories; m++)
            {
                if (column[m] == VECTOR)
                {
                    divide(p, &s, m);
                }
            }
        }
    }
}

void dem_wall_springs(struct dem_parts *p)
{
    const struct dem_wall_search *const s = &p->pairs.search;
    enum column column[DEM_MEMORY_COLUMNS];

    if (p->contacts.memories == 0 || p->touches.shared == 0)
    {
        return;
    }
    tell_columns(&p->recipe, column);
    for (size_t k = 0; k < p->touches.shared; k++)
    {
        const size_t first = p->touches.share[k];
        size_t end = first + 1;

        while (end < s->nears && s->near[end].particle == s->near[first].particle)
        {
            end++;
        }
        share_of_particle(p, column, first, end, p->particles.record[s->near[first].particle].radius);
    }
}
