/*
 * lists.cl -- new neighbor lists on the device: pairs within the outer skin, the entries that each
 * particle sums, and the history of the pairs that stay.
 *
 * With several ranks the host finds ghosts, for many lists (device_renewal.c). They have no list; a pair with one
 * is in the row of the owned particle.
 *
 * Particles are wrapped and counted into the cells of their level: those of about one size, and cells
 * as wide as the longest reach of a pair of them. Each particle looks at the cells of all levels within
 * its reach, across periodic faces with the shift of the image. It lists its partners by id, then by
 * shift; then the facets that it is near. Rows are numbered by pair class, then by the particle with the
 * lower id, then by partner. So lists depend on positions and ids only.
 *
 * An entry of a list is a particle or facet, and above it the shift code of the pair (as the particle
 * with the lower id sees it), or FACET.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/periodic_image.h"

#define FACET 31u
#define SHIFT_BITS 27

static ulong dem_bits(global const double4 *restrict record, uint i)
{
    return as_ulong(record[4*(size_t)i + 3].z);    /* material, flags, image */
}

static long dem_id(global const double4 *restrict record, uint i)
{
    return as_long(record[4*(size_t)i + 3].y);
}

static uint dem_material(ulong bits) { return (uint)bits & 0xffffu; }
static uint dem_frozen(ulong bits) { return (uint)(bits >> 16) & 1u; }    /* DEM_PARTICLE_FROZEN */
static uint dem_image(ulong bits) { return (uint)(bits >> 32); }

/* The image of a facet as a particle with these bits meets it, which stays. */
static uint dem_image_of_row(ulong bits, uint facet, global const struct dem_facet *restrict facets,
                             global const struct dem_device_images *restrict images,
                             global const uint4 *restrict near, uint at)
{
#if TRIANGLES
    const struct dem_device_images of = images[facets[facet].wall + 1];
    int8_t n[3];

    dem_image_numbers(near[at].w, n);
    return dem_facet_image(facets[facet].distinct, of.turns, n, dem_image(bits));
#else
    return 0;
#endif
}

/* Before particles are wrapped: the image of each pair, which stays. */
kernel void lists_images(uint rows, uint walls, global const double4 *restrict record,
                         global const uint2 *restrict partners, global uint *restrict image,
                         global const struct dem_facet *restrict facets,
                         global const struct dem_device_images *restrict images,
                         global const uint4 *restrict near)
{
    const uint row = get_global_id(0);

    if (row >= walls && row < rows)
    {
        image[row] = dem_image_of_row(dem_bits(record, partners[row].x), partners[row].y, facets,
                                      images, near, row - walls);
    }
    else if (row < rows)
    {
        const uint j = partners[row].y & ((1u << SHIFT_BITS) - 1);

        image[row] = dem_image_of_pair((int)(partners[row].y >> SHIFT_BITS),
                                       dem_image(dem_bits(record, partners[row].x)),
                                       dem_image(dem_bits(record, j)));
    }
}

static int dem_cell_of(constant struct dem_device_lists *l, int level, int axis, double x)
{
    const double at = (x - l->origin[axis])*l->level[level].over_edge[axis];

    return at > 0.0 ? (int)fmin(at, (double)(l->level[level].cells[axis] - 1)) : 0;
}

static int dem_level_of(constant struct dem_device_lists *l, double radius)
{
    int level = 0;

    while (level + 1 < l->levels && radius <= l->level[level + 1].radius)
    {
        level++;
    }
    return level;
}

static uint dem_cell_at(constant struct dem_device_lists *l, int level, const int c[3])
{
    constant struct dem_device_level *const grid = &l->level[level];

    return grid->first + (uint)((c[2]*grid->cells[1] + c[1])*grid->cells[0] + c[0]);
}

/* Wrap (as dem_domain_wrap), take the position as reference of displacements, count into a cell.
   outside: 1 when a particle has left the domain. */
kernel void lists_cells(constant struct dem_device_lists *l, global double4 *restrict record,
                        global double4 *restrict reference, global uint *restrict cell,
                        global uint *restrict place, global uint *restrict count,
                        global uint *outside)
{
    const uint i = get_global_id(0);

    if (i >= l->all)
    {
        return;
    }
    const double4 at = record[4*(size_t)i];
    double x[3] = {at.x, at.y, at.z};
    double4 rest = record[4*(size_t)i + 3];
    uint image = dem_image(as_ulong(rest.z));
    const int level = dem_level_of(l, at.w);
    int c[3];

    for (int k = 0; k < 3; k++)
    {
        /* what is further away is lost: the host says so */
        if (l->periodic[k] && fabs(x[k] - l->min[k]) < 1024.0*l->length[k])
        {
            x[k] = l->unit[k]*rint(x[k]/l->unit[k]);
            while (x[k] < l->min[k])
            {
                x[k] += l->length[k];
                image = dem_image_add(image, k, -1);
            }
            while (x[k] >= l->max[k])
            {
                x[k] -= l->length[k];
                image = dem_image_add(image, k, 1);
            }
        }
        if (i < l->particles && !(x[k] >= l->min[k] && x[k] <= l->max[k]))
        {
            *outside = 1;
        }
        c[k] = dem_cell_of(l, level, k, x[k]);
    }
    rest.z = as_double((as_ulong(rest.z) & 0xffffffffu) | (ulong)image << 32);
    record[4*(size_t)i] = reference[i] = (double4)(x[0], x[1], x[2], at.w);
    record[4*(size_t)i + 3] = rest;
    cell[i] = dem_cell_at(l, level, c);
    place[i] = atomic_inc((volatile global uint *)count + cell[i]);
}

kernel void lists_order(constant struct dem_device_lists *l, global const uint *restrict cell,
                        global const uint *restrict place, global const uint *restrict first,
                        global uint *restrict order)
{
    const uint i = get_global_id(0);

    if (i < l->all)
    {
        order[first[cell[i]] + place[i]] = i;
    }
}

/* ---- partners of a particle -------------------------------------------------------------------- */

/* Order of a list: by id, then by shift; facets after all particles. 1: a belongs after b. */
static int dem_partner_after(global const double4 *restrict record, uint a, uint b)
{
    const uint shift_a = a >> SHIFT_BITS, shift_b = b >> SHIFT_BITS, place = (1u << SHIFT_BITS) - 1;

    if (shift_a == FACET || shift_b == FACET)
    {
        return shift_b != FACET;
    }
    const long id_a = dem_id(record, a & place), id_b = dem_id(record, b & place);

    return id_a > id_b || (id_a == id_b && shift_a > shift_b);
}

/* Sort the n partners of a list, by Shell's method: a large particle may have thousands. */
static void dem_sort_partners(global const double4 *restrict record, global uint *list, uint n)
{
    uint gap = 1;

    while (3*gap + 1 < n)
    {
        gap = 3*gap + 1;
    }
    for (; gap > 0; gap /= 3)
    {
        for (uint k = gap; k < n; k++)
        {
            const uint here = list[k];
            uint at = k;

            for (; at >= gap && dem_partner_after(record, list[at - gap], here); at -= gap)
            {
                list[at] = list[at - gap];
            }
            list[at] = here;
        }
    }
}

/* The class of a pair, the one with the lower id first. */
static uint dem_class_of(constant struct dem_device_lists *l, global const int *classes, ulong low, ulong high)
{
    return (uint)classes[dem_material(low)*l->materials + dem_material(high)];
}

/* A partner that may be near: counted in its class if the row is this particle's, and appended to
   the list unless that is NULL. Returns 1 if it is one. */
static uint dem_try_partner(constant struct dem_device_lists *l,
                            global const double4 *restrict record, global const int *classes,
                            uint i, uint j, const int s[3], global uint *rows, global uint *list,
                            uint n)
{
    const double4 a = record[4*(size_t)i], b = record[4*(size_t)j];
    const double dx = a.x - b.x + s[0]*l->length[0], dy = a.y - b.y + s[1]*l->length[1],
                 dz = a.z - b.z + s[2]*l->length[2], reach = a.w + b.w + l->gap;
    const ulong bits_i = dem_bits(record, i), bits_j = dem_bits(record, j);

    if (i == j || !(dx*dx + dy*dy + dz*dz < reach*reach) ||
        (dem_frozen(bits_i) && dem_frozen(bits_j) && !l->keep_frozen))
    {
        return 0;
    }
    const long id_i = dem_id(record, i), id_j = dem_id(record, j);
    const int first = id_i < id_j, sign = first ? 1 : -1;

    if (list)
    {
        const uint code = (uint)dem_shift_code(sign*s[0], sign*s[1], sign*s[2]);

        list[n] = j | code << SHIFT_BITS;
    }
    else if (first || j >= l->particles)
    {
        rows[(size_t)dem_class_of(l, classes, first ? bits_i : bits_j, first ? bits_j : bits_i)*l->particles +
             i]++;
    }
    return 1;
}

/* The cells of a level along an axis within a distance of x; below 0 and past the last they are of
   periodic images. */
static void dem_cell_range(constant struct dem_device_lists *l, int level, int axis, double x,
                           double distance, int range[2])
{
    constant struct dem_device_level *const grid = &l->level[level];

    for (int side = 0; side < 2; side++)
    {
        const double end = x + (side ? distance : -distance);

        range[side] = l->periodic[axis]
                          ? (int)floor((end - l->origin[axis])*grid->over_edge[axis])
                          : dem_cell_of(l, level, axis, end);
    }
    range[0] = max(range[0], -grid->cells[axis]);
    range[1] = min(range[1], 2*grid->cells[axis] - 1);
}

/* All particles near this one. Returns their number. */
static uint dem_find_partners(constant struct dem_device_lists *l,
                              global const double4 *restrict record,
                              global const uint *restrict first, global const uint *restrict order,
                              global const int *classes, uint i, global uint *rows,
                              global uint *list)
{
    const double4 at = record[4*(size_t)i];
    const double x[3] = {at.x, at.y, at.z};
    uint n = 0;

    for (int level = 0; level < l->levels; level++)
    {
        /* wider than rounding */
        const double distance = (at.w + l->level[level].radius + l->gap)*(1.0 + 1e-6);
        int range[3][2], c[3];

        for (int k = 0; k < 3; k++)
        {
            dem_cell_range(l, level, k, x[k], distance, range[k]);
        }
        for (c[2] = range[2][0]; c[2] <= range[2][1]; c[2]++)
        {
            for (c[1] = range[1][0]; c[1] <= range[1][1]; c[1]++)
            {
                for (c[0] = range[0][0]; c[0] <= range[0][1]; c[0]++)
                {
                    int in[3], s[3];    /* r = x_i - x_j + s L */

                    for (int k = 0; k < 3; k++)
                    {
                        s[k] = (c[k] < 0) - (c[k] >= l->level[level].cells[k]);
                        in[k] = c[k] + s[k]*l->level[level].cells[k];
                    }
                    const uint cell = dem_cell_at(l, level, in);

                    for (uint e = first[cell]; e < first[cell + 1]; e++)
                    {
                        n += dem_try_partner(l, record, classes, i, order[e], s, rows, list, n);
                    }
                }
            }
        }
    }
    return n;
}

/* A facet: counted in its class, or appended to the list. */
static void dem_add_facet(constant struct dem_device_lists *l, global const int *wall_classes,
                          uint material, uint facet, uint i, global uint *rows, global uint *list,
                          uint n)
{
    if (list)
    {
        list[n] = facet | FACET << SHIFT_BITS;
    }
    else
    {
        rows[(size_t)wall_classes[facet*l->materials + material]*l->particles + i]++;
    }
}

/* The facets near a particle: l->facets without triangles come first; frozen particles have none
   but for scalars.
   Returns their number. */
static uint dem_find_facets(constant struct dem_device_lists *l,
                            global const double4 *restrict record,
                            global const struct dem_facet *restrict facets,
                            global const struct dem_device_frame *restrict frames,
                            global const int *wall_classes,
                            global const struct dem_device_triangle *restrict triangles,
                            global const uint *restrict candidate_start,
                            global const uint *restrict candidates, uint i, global uint *rows,
                            global uint *list)
{
    const double4 x = record[4*(size_t)i];
    const double at[3] = {x.x, x.y, x.z};
    const ulong bits = dem_bits(record, i);
    uint n = 0;

    for (uint f = 0; f < l->facets && (l->keep_frozen || !dem_frozen(bits)); f++)
    {
        double point[3], normal[3];

        if (dem_wall_touch(facets + f, frames, at, point, normal) < x.w + l->gap)
        {
            dem_add_facet(l, wall_classes, dem_material(bits), f, i, rows, list, n++);
        }
    }
#if TRIANGLES
    for (uint c = candidate_start[i]; c < candidate_start[i + 1]; c++)
    {
        const ulong order = dem_candidate_order(triangles, facets, candidates[c]).x;

        if (c == candidate_start[i] ||
            order != dem_candidate_order(triangles, facets, candidates[c - 1]).x)
        {
            dem_add_facet(l, wall_classes, dem_material(bits), (uint)(order >> 16), i, rows, list,
                          n++);
        }
    }
#endif
    return n;
}

kernel void lists_count(constant struct dem_device_lists *l, global const double4 *restrict record,
                        global const uint *restrict first, global const uint *restrict order,
                        global const int *classes, global const int *wall_classes,
                        global const struct dem_facet *restrict facets,
                        global const struct dem_device_frame *restrict frames,
                        global const struct dem_device_triangle *restrict triangles,
                        global const uint *restrict candidate_start,
                        global const uint *restrict candidates, global uint *entries,
                        global uint *rows)
{
    const uint i = get_global_id(0);

    if (i < l->particles)
    {
        entries[i] = dem_find_partners(l, record, first, order, classes, i, rows, 0) +
                     dem_find_facets(l, record, facets, frames, wall_classes, triangles,
                                     candidate_start, candidates, i, rows, 0);
    }
}

kernel void lists_find(constant struct dem_device_lists *l, global const double4 *restrict record,
                       global const uint *restrict first, global const uint *restrict order,
                       global const int *classes, global const int *wall_classes,
                       global const struct dem_facet *restrict facets,
                       global const struct dem_device_frame *restrict frames,
                       global const struct dem_device_triangle *restrict triangles,
                       global const uint *restrict candidate_start,
                       global const uint *restrict candidates, global const uint *restrict start,
                       global uint *list)
{
    const uint i = get_global_id(0);

    if (i < l->particles)
    {
        global uint *const own = list + start[i];
        const uint n = dem_find_partners(l, record, first, order, classes, i, 0, own);

        dem_sort_partners(record, own, n);
        dem_find_facets(l, record, facets, frames, wall_classes, triangles, candidate_start,
                        candidates, i, 0, own + n);
    }
}

/* ---- rows -------------------------------------------------------------------------------------- */

/* Number the rows of each particle; next: the next row of each class and particle. */
kernel void lists_rows(constant struct dem_device_lists *l, global const double4 *restrict record,
                       global const int *classes, global const int *wall_classes,
                       global const uint *restrict start, global const uint *restrict list,
                       global uint *next, global uint2 *restrict partners,
                       global uint *restrict entry)
{
    const uint i = get_global_id(0);

    for (uint e = i < l->particles ? start[i] : 0; i < l->particles && e < start[i + 1]; e++)
    {
        const uint j = list[e] & ((1u << SHIFT_BITS) - 1), code = list[e] >> SHIFT_BITS;
        const ulong bits = dem_bits(record, i);
        const int wall = code == FACET, low = wall || dem_id(record, i) < dem_id(record, j);

        if (low || j >= l->particles)
        {
            const uint c = wall  ? (uint)wall_classes[j*l->materials + dem_material(bits)]
                           : low ? dem_class_of(l, classes, bits, dem_bits(record, j))
                                 : dem_class_of(l, classes, dem_bits(record, j), bits);
            const uint row = next[(size_t)c*l->particles + i]++;

            partners[row] = low ? (uint2)(i, wall ? j : list[e]) : (uint2)(j, i | code << SHIFT_BITS);
            entry[e] = 2*row + !low;
        }
    }
}

/* The entries of owned partners with higher ids: found in the list of the other. */
kernel void lists_entries(constant struct dem_device_lists *l,
                          global const double4 *restrict record, global const uint *restrict start,
                          global const uint *restrict list, global uint *entry)
{
    const uint i = get_global_id(0);

    for (uint e = i < l->particles ? start[i] : 0; i < l->particles && e < start[i + 1]; e++)
    {
        const uint j = list[e] & ((1u << SHIFT_BITS) - 1), code = list[e] >> SHIFT_BITS;

        if (code != FACET && j < l->particles && dem_id(record, j) < dem_id(record, i))
        {
            const uint mine = i | code << SHIFT_BITS;
            uint at = start[j], end = start[j + 1];

            while (at + 1 < end)
            {
                const uint middle = at + (end - at)/2;

                *(dem_partner_after(record, list[middle], mine) ? &end : &at) = middle;
            }
            entry[e] = entry[at] + 1;
        }
    }
}

/* History of the rows that stay, zero for others. former_place: of particles, in the lists before. keep_all:
   laws act past touching, so that the history of rows that do not touch counts. */
kernel void lists_history(constant struct dem_device_lists *l,
                          global const double4 *restrict record, global const uint *restrict start,
                          global const uint *restrict list, global const uint *restrict entry,
                          global const uint *restrict old_start,
                          global const uint *restrict old_entry,
                          global const uint2 *restrict old_partners,
                          global const uint *restrict old_image,
                          global const uchar *restrict old_touch,
                          global const double *restrict old_history,
                          global uchar *restrict touch, global double *restrict history,
                          global const struct dem_facet *restrict facets,
                          global const struct dem_device_images *restrict images,
                          global const uint4 *restrict near, global const uint *restrict former_place)
{
    const uint i = get_global_id(0);
    uint next = 0;    /* both lists are in the same order: where a pair is likely to be */

    for (uint e = i < l->particles ? start[i] : 0; i < l->particles && e < start[i + 1]; e++)
    {
        const uint j = list[e] & ((1u << SHIFT_BITS) - 1), code = list[e] >> SHIFT_BITS,
                   row = entry[e] >> 1;
        const int wall = code == FACET, ghost = !wall && j >= l->particles, side = entry[e] & 1;
        const uint former_i = l->renumbered ? former_place[i] : i,
                   former_j = l->renumbered && !wall ? former_place[j] : j,
                   first = former_i == UINT_MAX ? 0 : old_start[former_i],
                   end = former_i == UINT_MAX ? 0 : old_start[former_i + 1];
        uint former = UINT_MAX;

        if (side && !ghost)
        {
            continue;
        }
        const ulong bits = dem_bits(record, i);
        const uint own = dem_image(bits), its = wall ? 0 : dem_image(dem_bits(record, j)),
                   image = wall ? dem_image_of_row(bits, j, facets, images, near, row - l->walls)
                                : dem_image_of_pair((int)code, side ? its : own, side ? own : its);

        for (uint k = 0; k < end - first && former == UINT_MAX; k++)
        {
            const uint o = first + (next + k)%(end - first), r = old_entry[o] >> 1;
            const uint other = side ? old_partners[r].x : old_partners[r].y & ((1u << SHIFT_BITS) - 1);

            if ((int)(old_entry[o] & 1) == side && (r >= l->old_walls) == wall && other == former_j &&
                old_image[r] == image)
            {
                former = r;
                next = o + 1 - first;
            }
        }
        const int known = former != UINT_MAX && old_touch[former] & DEM_DEVICE_TOUCHES;

        touch[row] = l->keep_all || known;
        for (uint m = 0; (known || l->keep_all) && m < l->columns; m++)
        {
            history[(size_t)m*l->stride + row] =
                known ? old_history[(size_t)m*l->old_stride + former] : 0.0;
        }
    }
}

/* Largest displacement^2 since the lists were made, rounded up. */
kernel __attribute__((reqd_work_group_size(DEM_DEVICE_GROUP, 1, 1)))
void lists_displacement(uint particles, global const double4 *restrict record,
                        global const double4 *restrict reference, global uint *largest)
{
    local uint part[DEM_DEVICE_GROUP];
    const uint i = get_global_id(0), l = get_local_id(0);

    part[l] = 0;
    if (i < particles)
    {
        const double4 d = record[4*(size_t)i] - reference[i];

        part[l] = as_uint(convert_float_rtp(d.x*d.x + d.y*d.y + d.z*d.z));
    }
    dem_group_max(part, largest);
}

kernel void lists_refer(uint particles, global const double4 *restrict record,
                        global double4 *restrict reference)
{
    const uint i = get_global_id(0);

    if (i < particles)
    {
        reference[i] = record[4*(size_t)i];
    }
}

/* The first row of each class, the number of rows, the number of entries. */
kernel void lists_totals(uint particles, uint classes, global const uint *restrict rows,
                         global const uint *restrict start, global uint *restrict totals)
{
    const uint c = get_global_id(0);

    if (c <= classes)
    {
        totals[c] = rows[(size_t)c*particles];
    }
    if (c == 0)
    {
        totals[classes + 1] = start[particles];
    }
}

/* The ghosts in rows of pairs, from the particle number `owned` on. */
kernel void lists_needed(uint rows, uint owned, global const uint2 *restrict partners,
                         global uint *restrict needed)
{
    const uint row = get_global_id(0);

    if (row < rows)
    {
        const uint i = partners[row].x, j = partners[row].y & ((1u << SHIFT_BITS) - 1);

        if (i >= owned || j >= owned)
        {
            needed[(i >= owned ? i : j) - owned] = 1;
        }
    }
}
