/*
 * walls.c -- adding walls and their triangles; height of a point over a facet.
 *
 * The facets of triangulated walls are built in wall_facets.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/walls.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

void dem_walls_free(struct dem_walls *w)
{
    for (int k = 0; k < w->walls; k++)
    {
        dem_memory_free(w->wall[k].scalars);
    }
    for (int k = 0; k < w->frames; k++)
    {
        dem_compound_motion_free(w->frame[k].compound);
    }
    dem_memory_free(w->wall);
    dem_name_index_free(&w->names);
    dem_memory_free(w->triangle);
    dem_memory_free(w->facet);
    dem_memory_free(w->frame);
    dem_memory_free(w->mark);
    dem_memory_free(w->trajectory);
    memset(w, 0, sizeof *w);
}

int dem_walls_named(const struct dem_walls *w, const char *name)
{
    const uint64_t hash = dem_name_hash(name, strlen(name), 0);
    size_t at = 0, k = 0;

    while (dem_name_index_next(&w->names, hash, &at, &k))
    {
        if (strcmp(w->wall[k].name, name) == 0)
        {
            return (int)k;
        }
    }
    return w->walls;
}

int dem_walls_add(struct dem_walls *w, const char *name, int material, int *wall)
{
    DEM_REQUIRE(dem_walls_named(w, name) == w->walls, DEM_ERROR_INPUT,
                "wall %s is given twice; rename one of them", name);
    DEM_REQUIRE(strlen(name) < sizeof w->wall->name, DEM_ERROR_INPUT,
                "wall name %s is longer than %zu characters; shorten it", name,
                sizeof w->wall->name - 1);
    DEM_REQUIRE(w->walls <= UINT16_MAX, DEM_ERROR_INPUT,
                "wall %s: there are %d walls, the limit; join some of them", name, w->walls);
    DEM_TRY(DEM_GROW(w->wall, w->wall_capacity, w->walls + 1));
    DEM_TRY(dem_name_index_add(&w->names, dem_name_hash(name, strlen(name), 0), (size_t)w->walls));
    *wall = w->walls++;
    w->wall[*wall] = (struct dem_wall){
        .material = material, .frame = -1, .there = {-INFINITY, INFINITY}};
    memcpy(w->wall[*wall].name, name, strlen(name));
    return DEM_OK;
}

/* A plane's normal or a cylinder's axis. */
static int unit_vector(const char *name, const char *what, const double v[3], double out[3])
{
    const double size = dem_vec_norm(v);

    DEM_REQUIRE(size > 0.0 && isfinite(size), DEM_ERROR_INPUT,
                "wall %s: %s (%g %g %g) has no direction; give a vector that %s", name, what, v[0],
                v[1], v[2], what[0] == 'n' ? "points to the particles" : "is parallel to the axis");
    for (int k = 0; k < 3; k++)
    {
        out[k] = v[k]/size;
    }
    return DEM_OK;
}

int dem_walls_add_plane(struct dem_walls *w, const char *name, int material, const double point[3],
                        const double normal[3])
{
    double direction[3];
    int wall;

    DEM_TRY(unit_vector(name, "normal", normal, direction));
    DEM_TRY(dem_walls_add(w, name, material, &wall));
    w->wall[wall].shape = DEM_SHAPE_PLANE;
    memcpy(w->wall[wall].point, point, sizeof w->wall[wall].point);
    memcpy(w->wall[wall].normal, direction, sizeof direction);
    return DEM_OK;
}

int dem_walls_add_round(struct dem_walls *w, const char *name, int material, const double point[3],
                        const double *axis, double radius, int outside)
{
    double direction[3] = {0.0, 0.0, 1.0};
    int wall;

    DEM_REQUIRE(radius > 0.0 && isfinite(radius), DEM_ERROR_INPUT,
                "wall %s: radius %g m; give a length above 0", name, radius);
    if (axis)
    {
        DEM_TRY(unit_vector(name, "axis", axis, direction));
    }
    DEM_TRY(dem_walls_add(w, name, material, &wall));
    w->wall[wall].shape = axis ? DEM_SHAPE_CYLINDER : DEM_SHAPE_SPHERE;
    w->wall[wall].radius = radius;
    w->wall[wall].outside = outside;
    memcpy(w->wall[wall].point, point, sizeof w->wall[wall].point);
    memcpy(w->wall[wall].normal, direction, sizeof direction);
    return DEM_OK;
}

/* m: limit of coordinates, so that areas and their squares stay finite */
static const double max_coordinate = 1e50;

int dem_walls_add_triangles(struct dem_walls *w, int wall, size_t n, const double *corners)
{
    if (w->elsewhere)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_GROW(w->triangle, w->triangle_capacity, w->triangles + n));
    for (size_t t = 0; t < n; t++)
    {
        struct dem_triangle *const new = &w->triangle[w->triangles];

        memcpy(new->corner, corners + 9*t, sizeof new->corner);
        new->wall = (uint16_t)wall;
        new->place = DEM_SHIFT_NONE;
        new->given_index = (uint32_t)w->wall[wall].given++;
        for (int k = 0; k < 9; k++)
        {
            DEM_REQUIRE(
                fabs(corners[9*t + (size_t)k]) < max_coordinate, DEM_ERROR_INPUT,
                "wall %s: triangle %zu has a corner at %g m, not a number below %g; repair the surface",
                w->wall[wall].name, t, corners[9*t + (size_t)k], max_coordinate);
        }
        w->triangles++;
    }
    return DEM_OK;
}

size_t dem_walls_count_triangles(const struct dem_walls *w)
{
    size_t n = 0;

    for (int k = 0; k < w->walls; k++)
    {
        n += w->wall[k].triangles;
    }
    return n;
}

int dem_walls_with_facet(const struct dem_walls *w, int number)
{
    int k = 0;

    while (number < w->wall[k].first_facet ||
           number >= w->wall[k].first_facet + w->wall[k].facets)
    {
        k++;
    }
    return k;
}

/* ---- form ------------------------------------------------------------------------------------ */

void dem_walls_form(const struct dem_wall *w, double form[DEM_WALL_FORM])
{
    const int triangles = w->shape == DEM_SHAPE_TRIANGLES;

    memset(form, 0, DEM_WALL_FORM*sizeof *form);
    memcpy(form, triangles ? w->centroid : w->point, 3*sizeof *form);
    memcpy(form + 3, w->normal, sizeof w->normal);
    form[6] = triangles ? w->area : w->radius;
}

int dem_walls_same_form(const double *a, const double *b, int triangles)
{
    /* 1  of the size of the wall: ten times the rounding of a corner in a text of six digits */
    static const double rounding = 1e-5;

    if (!triangles)
    {
        return memcmp(a, b, DEM_WALL_FORM*sizeof *a) == 0;
    }
    double moved[3];

    dem_vec_minus(a, b, moved);
    return fabs(a[6] - b[6]) <= rounding*a[6]
        && dem_vec_norm(moved) <= rounding*(sqrt(a[6]) + dem_vec_norm(a));
}
