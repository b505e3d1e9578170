/*
 * wall_springs.c -- one pass over the particles with several wall contacts: group these by surface,
 * divide their friction springs, transfer other history.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/wall_springs.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

/* Cosine of the largest angle between the normals of two facets of one surface. A choice: facets of
   a round wall of 12 sides and more are one surface, the sides of a groove are two. */
static const double nearly_flat = 0.86602540378443865;    /* 30 degrees */

enum
{
    NONE = DEM_ROW_NONE
};

enum column                                               /* kind of a history column */
{
    OWN,     /* of a bond or a film: stays with its facet */
    NUMBER,
    VECTOR,  /* and the next two columns */
    REST_OF_VECTOR
};

struct surface    /* wall contacts of one particle, some of them on one surface */
{
    size_t first, end;
    const enum column *column;
    uint32_t leader;                                      /* the deepest contact of the surface */
    double radius;                                        /* m */
};

static int is_vector(const struct dem_interaction_table *r, int m)
{
    const size_t length = strlen(r->history_name[m]);

    return m + 2 < r->history_columns && length > 2 &&
           strcmp(r->history_name[m] + length - 2, "_x") == 0;
}

static void classify_columns(const struct dem_interaction_table *r, enum column *column)
{
    for (int m = 0; m < r->history_columns; m++)
    {
        column[m] = is_vector(r, m) ? VECTOR : NUMBER;
        column[m] = m > 0 && column[m - 1] == VECTOR ? REST_OF_VECTOR : column[m];
        column[m] = m > 1 && column[m - 2] == VECTOR ? REST_OF_VECTOR : column[m];
    }
    for (int s = 0; s < r->classes; s++)
    {
        for (int k = 0; k < r->list[s].entries; k++)
        {
            const struct dem_effect_entry *const entry = &r->list[s].entry[k];

            for (int m = 0; m < dem_effect_history_columns(entry->effect) &&
                            entry->effect->stage >= DEM_STAGE_BOND;
                 m++)
            {
                column[entry->first_column + m] = OWN;
            }
        }
    }
}

/* ---- transfer -------------------------------------------------------------------------------- */

/* The smallest rotation that takes unit vector a to b: v - (a + b) (a + b).v/(1 + a.b) + 2 b
   (a.v). */
static void rotate(const double a[3], const double b[3], double v[3])
{
    const double c[3] = {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const double factor = dem_vec_dot(c, v)/(1.0 + dem_vec_dot(a, b)),
                 twice = 2.0*dem_vec_dot(a, v);

    for (int k = 0; k < 3; k++)
    {
        v[k] += twice*b[k] - factor*c[k];
    }
}

static double overlap(const struct dem_wall_touch *t, double radius)
{
    return t->distance < radius ? radius - t->distance : 0.0;
}

/* Tangential stiffness of a contact, up to a factor common to contacts of the same materials. */
static double weight(const struct dem_state *state, const struct dem_wall_touch *t, double radius)
{
    const struct dem_pair *const q = dem_contacts_pair(&state->contacts, t->row);
    const double exponent = state->interaction_table.list[q->class].pair.exponent,
                 d = overlap(t, radius);

    return exponent > 1.25 ? sqrt(d) : 1.0;
}

/* Divide the sum of the springs of a surface among its contacts, by overlap; m: first history
   column of the spring. */
static void divide_springs(struct dem_state *state, const struct surface *s, int m)
{
    const struct dem_wall_touch *const touch = state->touches.touch;
    double *const *const history = state->contacts.history.column;
    double total[3] = {0.0, 0.0, 0.0}, sum = 0.0;

    for (size_t k = s->first; k < s->end; k++)
    {
        if (touch[k].surface == s->leader)
        {
            const double d = overlap(&touch[k], s->radius),
                         w = weight(state, &touch[d > 0.0 ? k : s->leader], s->radius);
            double v[3] = {history[m][touch[k].row], history[m + 1][touch[k].row],
                           history[m + 2][touch[k].row]};

            rotate(touch[k].normal, touch[s->leader].normal, v);
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
            const double fraction = overlap(&touch[k], s->radius)/sum;
            double v[3] = {fraction*total[0], fraction*total[1], fraction*total[2]};

            rotate(touch[s->leader].normal, touch[k].normal, v);
            for (int a = 0; a < 3; a++)
            {
                history[m + a][touch[k].row] = v[a];
            }
        }
    }
}

/* Scalar history goes from a contact that has ended to those that are new. */
static void transfer_numbers(struct dem_state *state, const struct surface *s)
{
    const struct dem_wall_touch *const touch = state->touches.touch;
    struct dem_contacts *const c = &state->contacts;
    size_t ended = s->end;

    for (size_t k = s->first; k < s->end; k++)
    {
        ended = touch[k].surface == s->leader && touch[k].drop ? k : ended;
    }
    for (size_t k = s->first; k < s->end && ended < s->end; k++)
    {
        if (touch[k].surface == s->leader && !touch[k].drop &&
            !dem_contact_history_any(&c->history, touch[k].row))
        {
            for (int m = 0; m < c->history.columns; m++)
            {
                c->history.column[m][touch[k].row] = s->column[m] == NUMBER
                                                  ? c->history.column[m][touch[ended].row]
                                                  : c->history.column[m][touch[k].row];
            }
        }
    }
}

/* Mark all contacts on the surface of the leader: those that touch, or that another facet has just
   taken over. Returns their number. */
static int gather_surface(struct dem_state *state, const struct surface *s)
{
    struct dem_wall_touch *const touch = state->touches.touch;
    int count = 0;

    for (size_t k = s->first; k < s->end; k++)
    {
        const int ended = touch[k].drop && touch[k].row != DEM_ROW_NONE &&
                          dem_contact_history_any(&state->contacts.history, touch[k].row);

        if (touch[k].surface == NONE && touch[k].row != DEM_ROW_NONE &&
            (ended || overlap(&touch[k], s->radius) > 0.0) &&
            dem_vec_dot(touch[k].normal, touch[s->leader].normal) > nearly_flat)
        {
            touch[k].surface = s->leader;
            count++;
        }
    }
    return count;
}

static void redistribute(struct dem_state *state, const enum column *column, size_t first,
                         size_t end, double radius)
{
    struct dem_wall_touch *const touch = state->touches.touch;
    struct surface s = {.first = first, .end = end, .column = column, .radius = radius};

    for (size_t k = first; k < end; k++)
    {
        touch[k].surface = NONE;
    }
    for (;;)
    {
        s.leader = NONE;
        for (size_t k = first; k < end; k++)
        {
            if (touch[k].surface == NONE && touch[k].row != DEM_ROW_NONE &&
                touch[k].distance < radius &&
                (s.leader == NONE || touch[k].distance < touch[s.leader].distance))
            {
                s.leader = (uint32_t)k;
            }
        }
        if (s.leader == NONE)
        {
            return;
        }
        if (gather_surface(state, &s) > 1)
        {
            transfer_numbers(state, &s);
            for (int m = 0; m < state->contacts.history.columns; m++)
            {
                if (column[m] == VECTOR)
                {
                    divide_springs(state, &s, m);
                }
            }
        }
    }
}

void dem_wall_springs_redistribute(struct dem_state *state)
{
    const struct dem_wall_search *const s = &state->pairs.wall_search;
    enum column column[DEM_HISTORY_COLUMNS];

    if (state->contacts.history.columns == 0 || state->touches.shared == 0)
    {
        return;
    }
    classify_columns(&state->interaction_table, column);
    for (size_t k = 0; k < state->touches.shared; k++)
    {
        const size_t first = state->touches.shared_first[k];
        size_t end = first + 1;

        while (end < s->neighbors && s->neighbor[end].particle == s->neighbor[first].particle)
        {
            end++;
        }
        redistribute(state, column, first, end,
                     state->particles.record[s->neighbor[first].particle].radius);
    }
}
