/*
 * contacts_carry.c -- what rows remember, lifted out of them by name before a rebuild and given back after it: through new lists, and
 * from rank to rank.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/memory.h"
#include "base/random.h"
#include "state/contacts.h"
#include "state/image.h"
#include <string.h>

struct dem_carried dem_contacts_name(const struct dem_contacts *c, const struct dem_particles *p, const int *wall_region,
                                     uint32_t row)
{
    const struct dem_pair *const q = &c->pair[c->row_pair[row]];
    const struct dem_particle *const i = &p->record[q->i];

    if (q->wall)
    {
        return (struct dem_carried){.low = i->id, .high = -1 - wall_region[q->j]};
    }
    const struct dem_particle *const j = &p->record[q->j];

    return (struct dem_carried){.low = i->id, .high = j->id, .image = dem_image_of_pair(q->shift, i->image, j->image)};
}

int dem_contacts_remembers(const struct dem_contacts *c, uint32_t row)
{
    int some = 0;

    for (int m = 0; m < c->memories; m++)
    {
        some |= c->memory[m][row] != 0.0;
    }
    return some;
}

void dem_contacts_recall(const struct dem_contacts *c, uint32_t row, double *memory)
{
    for (int m = 0; m < c->memories; m++)
    {
        memory[m] = c->memory[m][row];
    }
}

int dem_contacts_carry(struct dem_contacts *c, const struct dem_carried *name, const double *memory)
{
    DEM_TRY(DEM_GROW(c->carry, c->carried_room, c->carried + 1));
    DEM_TRY(DEM_GROW(c->kept, c->kept_room, (c->carried + 1)*(size_t)c->memories));
    c->carry[c->carried] = *name;
    memcpy(c->kept + c->carried*(size_t)c->memories, memory, (size_t)c->memories*sizeof *memory);
    c->carried++;
    return DEM_OK;
}

/* Rows with memory of `from`, each counted by the owner of its lower particle, to the carried ones of c. */
static int carry_rows(struct dem_contacts *c, const struct dem_contacts *from, const struct dem_particles *p, const int *wall_region)
{
    double memory[DEM_MEMORY_COLUMNS];
    size_t more = 0;

    for (uint32_t r = 0; r < from->rows; r++)
    {
        more += from->row_pair[r] != DEM_ROW_NONE && dem_contacts_remembers(from, r);
    }
    DEM_TRY(DEM_GROW(c->carry, c->carried_room, c->carried + more));
    DEM_TRY(DEM_GROW(c->kept, c->kept_room, (c->carried + more)*(size_t)c->memories));
    for (uint32_t r = 0; r < from->rows; r++)
    {
        if (from->row_pair[r] != DEM_ROW_NONE && dem_contacts_remembers(from, r))
        {
            struct dem_carried name = dem_contacts_name(from, p, wall_region, r);

            name.counted = from->pair[from->row_pair[r]].i < p->n;
            dem_contacts_recall(from, r, memory);
            DEM_TRY(dem_contacts_carry(c, &name, memory));
        }
    }
    return DEM_OK;
}

int dem_contacts_lift(struct dem_contacts *c, const struct dem_particles *p, const int *wall_region)
{
    dem_contacts_drop_pushes(c);
    DEM_TRY(carry_rows(c, c, p, wall_region));
    dem_contacts_drop_rows(c);
    return DEM_OK;
}

int dem_contacts_copy_rows(struct dem_contacts *c, const struct dem_contacts *from, const struct dem_particles *p,
                           const int *wall_region)
{
    for (size_t k = 0; k < from->carried; k++)
    {
        DEM_TRY(dem_contacts_carry(c, &from->carry[k], from->kept + k*(size_t)from->memories));
    }
    return carry_rows(c, from, p, wall_region);
}

static size_t slot_of(const struct dem_carried *name, size_t mask)
{
    return dem_random_bits((uint64_t)name->low, (uint64_t)name->high, name->image, 0) & mask;
}

static int same_name(const struct dem_carried *a, const struct dem_carried *b)
{
    return a->low == b->low && a->high == b->high && a->image == b->image;
}

int dem_contacts_settle(struct dem_contacts *c, const struct dem_particles *p, const int *wall_region)
{
    size_t mask = 15;
    uint32_t *table;

    if (c->carried == 0)
    {
        return DEM_OK;
    }
    while (mask < 2*c->carried)
    {
        mask = 2*mask + 1;
    }
    DEM_TRY(DEM_NEW(table, mask + 1));
    for (size_t k = 0; k < c->carried; k++)
    {
        size_t slot = slot_of(&c->carry[k], mask);

        while (table[slot])
        {
            slot = (slot + 1) & mask;
        }
        table[slot] = (uint32_t)k + 1;
    }
    for (uint32_t r = 0; r < c->rows; r++)
    {
        if (c->row_pair[r] == DEM_ROW_NONE)
        {
            continue;
        }
        const struct dem_carried name = dem_contacts_name(c, p, wall_region, r);
        size_t slot = slot_of(&name, mask);

        while (table[slot] && !same_name(&c->carry[table[slot] - 1], &name))
        {
            slot = (slot + 1) & mask;
        }
        for (int m = 0; table[slot] && m < c->memories; m++)
        {
            c->memory[m][r] = c->kept[(table[slot] - 1)*(size_t)c->memories + (size_t)m];
        }
    }
    dem_memory_free(table);
    dem_memory_free(c->carry);
    dem_memory_free(c->kept);
    c->carry = NULL;
    c->kept = NULL;
    c->carried = c->carried_room = c->kept_room = 0;
    return dem_contacts_make_pushes(c);
}
