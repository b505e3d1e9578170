/*
 * clump_index.c -- lists the spheres of rigid bodies, and brings the state of the bodies from the columns into lanes
 * (clump_lanes.h) and back.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "core/vec.h"
#include "particles/clump_lanes.h"
#include <string.h>

double dem_clumps_reach(const struct dem_particles *p)
{
    double reach = 0.0;

    for (size_t i = 0; i < p->n; i++)
    {
        const struct dem_clump *const b = dem_clump_of(p, i);

        reach = b ? fmax(reach, dem_vec_norm(b->offset)) : reach;
    }
    return reach;
}

void dem_clumps_free(struct dem_clumps *c)
{
    dem_memory_free(c->start);
    dem_memory_free(c->member);
    dem_memory_free(c->contact);
    dem_memory_free(c->applied);
    dem_memory_free(c->place);
    dem_memory_free(c->group);
    dem_memory_free(c->slot);
    memset(c, 0, sizeof *c);
}

/* ---- state ----------------------------------------------------------------------------------- */

static void load_body(struct dem_clump_group *g, int lane, const struct dem_clump *b)
{
    g->mass[lane] = b->mass;
    for (int a = 0; a < 3; a++)
    {
        g->inertia[a][lane] = b->inertia[a];
        g->x[a][lane] = b->x[a];
        g->v[a][lane] = b->v[a];
        g->momentum[a][lane] = b->momentum[a];
    }
    for (int a = 0; a < 4; a++)
    {
        g->q[a][lane] = b->q[a];
    }
}

static void store_body(const struct dem_clump_group *g, int lane, struct dem_clump *b)
{
    for (int a = 0; a < 3; a++)
    {
        b->x[a] = g->x[a][lane];
        b->v[a] = g->v[a][lane];
        b->momentum[a] = g->momentum[a][lane];
    }
    for (int a = 0; a < 4; a++)
    {
        b->q[a] = g->q[a][lane];
    }
}

void dem_clumps_load(struct dem_clumps *c, const struct dem_particles *p)
{
    c->ahead = 0;
    for (size_t k = 0; k < c->groups; k++)
    {
        struct dem_clump_group *const g = &c->group[k];

        for (int lane = 0; lane < DEM_CLUMP_LANES; lane++)
        {
            load_body(g, lane, dem_clump_at(p, c->slot[g->first].particle[lane < g->n ? lane : 0]));
        }
        dem_clump_keep_turns(g);
        for (size_t s = g->first; s < g->end; s++)
        {
            dem_clump_turn_arms(g, &c->slot[s]);
        }
    }
}

void dem_clumps_store(struct dem_clumps *c, struct dem_particles *p)
{
    if (!c->ahead)
    {
        return;
    }
    for (size_t k = 0; k < c->groups; k++)
    {
        const struct dem_clump_group *const g = &c->group[k];

        for (size_t s = g->first; s < g->end; s++)
        {
            for (int lane = 0; lane < g->n; lane++)
            {
                if (c->slot[s].particle[lane] != DEM_CLUMP_NO_SPHERE)
                {
                    store_body(g, lane, dem_clump_at(p, c->slot[s].particle[lane]));
                }
            }
        }
    }
    c->ahead = 0;
}

void dem_clumps_body(const struct dem_clumps *c, size_t body, const struct dem_particles *p, struct dem_clump *b)
{
    *b = *dem_clump_at(p, c->member[c->start[body]]);
    store_body(&c->group[c->place[body]/DEM_CLUMP_LANES], (int)(c->place[body]%DEM_CLUMP_LANES), b);
}

void dem_clumps_arm(const struct dem_clumps *c, size_t body, size_t k, double arm[3])
{
    const struct dem_clump_slot *const s = &c->slot[c->group[c->place[body]/DEM_CLUMP_LANES].first + k];

    for (int a = 0; a < 3; a++)
    {
        arm[a] = s->arm[a][c->place[body]%DEM_CLUMP_LANES];
    }
}

/* ---- lists ----------------------------------------------------------------------------------- */

/* Sorted by id, the spheres of a body follow each other. */
static void list_members(struct dem_clumps *c, const struct dem_particles *p, size_t members, uint64_t *key,
                         uint32_t *scratch)
{
    size_t k = 0;

    for (size_t i = 0; i < p->n; i++)
    {
        if (p->record[i].body)
        {
            key[k] = (uint64_t)p->record[i].id;
            c->member[k++] = (uint32_t)i;
        }
    }
    dem_sort_keys(key, c->member, members, key + members, scratch);
    for (k = 0; k < members; k++)
    {
        if (k == 0 || p->record[c->member[k]].body != p->record[c->member[k - 1]].body)
        {
            c->start[c->n++] = k;
        }
    }
    c->start[c->n] = members;
}

/* Bodies in the order of their first spheres in memory, those that move first; `order` gets their numbers.
   Returns how many move. */
static size_t order_bodies(const struct dem_clumps *c, const struct dem_particles *p, uint64_t *key,
                           uint32_t *order, uint32_t *scratch)
{
    size_t moving = 0;

    for (size_t body = 0; body < c->n; body++)
    {
        const int frozen = dem_clumps_frozen(c, body, p);

        key[body] = (uint64_t)frozen << 32 | c->member[c->start[body]];
        order[body] = (uint32_t)body;
        moving += !frozen;
    }
    dem_sort_keys(key, order, c->n, key + c->n, scratch);
    return moving;
}

/* Put a body into the next lane; `slots`: the last one in use of all groups. */
static void place(struct dem_clumps *c, const struct dem_particles *p, size_t body, int moves, size_t *slots)
{
    const size_t spheres = c->start[body + 1] - c->start[body];
    struct dem_clump_group *g = c->groups > 0 ? &c->group[c->groups - 1] : NULL;

    if (!g || g->n == DEM_CLUMP_LANES || g->moves != moves)
    {
        g = &c->group[c->groups++];
        g->first = g->end = *slots;
        g->n = 0;
        g->moves = moves;
    }
    for (; g->end < g->first + spheres; g->end++)
    {
        memset(&c->slot[g->end], 0, sizeof *c->slot);
        memset(c->slot[g->end].particle, 0xff, sizeof c->slot->particle);    /* DEM_CLUMP_NO_SPHERE */
    }
    *slots = g->end;
    for (size_t k = 0; k < spheres; k++)
    {
        struct dem_clump_slot *const s = &c->slot[g->first + k];

        s->particle[g->n] = c->member[c->start[body] + k];
        for (int a = 0; a < 3; a++)
        {
            s->offset[a][g->n] = dem_clump_at(p, s->particle[g->n])->offset[a];
        }
    }
    c->place[body] = (uint32_t)((c->groups - 1)*DEM_CLUMP_LANES + (size_t)g->n++);
}

static void fill(struct dem_clumps *c, const struct dem_particles *p, size_t members, uint64_t *key,
                 uint32_t *scratch)
{
    uint32_t *const order = scratch + members;
    size_t slots = 0;

    list_members(c, p, members, key, scratch);
    const size_t moving = order_bodies(c, p, key, order, scratch);

    for (size_t k = 0; k < c->n; k++)
    {
        place(c, p, order[k], k < moving, &slots);
    }
    dem_clumps_load(c, p);
}

int dem_clumps_index(struct dem_clumps *c, const struct dem_particles *p)
{
    uint32_t *scratch = NULL;
    uint64_t *key = NULL;
    size_t members = 0;

    c->n = c->groups = 0;
    c->ahead = 0;
    if (!dem_column(p, DEM_COLUMN_CLUMP))
    {
        return DEM_OK;
    }
    for (size_t i = 0; i < p->n; i++)
    {
        members += p->record[i].body != 0;
    }
    DEM_TRY(DEM_GROW(c->start, c->start_capacity, members + 1));
    DEM_TRY(DEM_GROW(c->member, c->member_capacity, members + 1));
    DEM_TRY(DEM_GROW(c->contact, c->contact_capacity, p->n + 1));
    DEM_TRY(DEM_GROW(c->place, c->place_capacity, members + 1));
    DEM_TRY(DEM_GROW(c->group, c->group_capacity, members/DEM_CLUMP_LANES + 3));
    DEM_TRY(DEM_GROW(c->slot, c->slot_capacity, members + 1));
    int status = DEM_NEW(key, 2*members + 1);

    status = status ? status : DEM_NEW(scratch, 2*members + 1);
    if (!status)
    {
        fill(c, p, members, key, scratch);
    }
    dem_memory_free(key);
    dem_memory_free(scratch);
    return status;
}
