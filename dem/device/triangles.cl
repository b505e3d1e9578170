/*
 * triangles.cl -- candidates for lists: triangles near each particle, with their periodic images, in the
 * order of facets; and what wall rows have to know of them (facets.cl).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */

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
