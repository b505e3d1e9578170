/*
 * insertion_limits.c -- read and test the limits of inserted groups: walls, mesh, zones.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/insertion_limits.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

enum
{
    PUSHES = 8  /* out of one wall after the other; more would be a corner that is too narrow */
};

static const double
    gap = 1e-9,        /* of a radius: left between a wall and a sphere that was moved off it */
    longest = 0.9;     /* of a radius: so far a sphere does not pass through a wall */

/* ---- reading --------------------------------------------------------------------------------- */

static int find_mesh(const struct dem_insertion_regions *g, const struct dem_dict *group,
                     const struct dem_closed_surface **found)
{
    for (size_t k = 0; k < g->n; k++)
    {
        *found = g->surface[k].zone ? *found : &g->surface[k];
    }
    DEM_REQUIRE(*found, DEM_ERROR_INPUT,
                "%s: inside mesh, but this run has no mesh; give inside walls and a box, cylinder "
                "or sphere", dem_dict_where(group));
    return DEM_OK;
}

/* The number of a wall of triangles of this name, -1 without one. */
static int find_wall(const struct dem_walls *w, const char *name)
{
    int wall = 0;

    while (wall < w->walls
           && (w->wall[wall].shape != DEM_SHAPE_TRIANGLES || strcmp(w->wall[wall].name, name) != 0))
    {
        wall++;
    }
    return wall < w->walls ? wall : -1;
}

static int read_inside(struct dem_insertion_limits *l, const struct dem_dict *group,
                       const struct dem_insertion_regions *g, const struct dem_walls *w)
{
    const char *word;

    DEM_TRY(dem_dict_word(group, "inside", &word));
    const int wall = find_wall(w, word);

    if (strcmp(word, "mesh") == 0)
    {
        return find_mesh(g, group, &l->surface);
    }
    if (strcmp(word, "walls") != 0 && wall >= 0)
    {
        l->surface = &l->own;
        return dem_error_prefix(dem_closed_surface_of_wall(&l->own, w, wall), "%s: ", dem_dict_where(group));
    }
    DEM_REQUIRE(strcmp(word, "walls") == 0, DEM_ERROR_INPUT,
                "%s: inside %s; give walls, mesh (in OpenFOAM), or the name of a wall of triangles "
                "that is closed", dem_dict_where(group), word);
    return DEM_OK;
}

static int read_zone(const struct dem_insertion_regions *g, const struct dem_dict *group,
                     const struct dem_closed_surface **found)
{
    const char *word;

    DEM_TRY(dem_dict_word(group, "zone", &word));
    for (size_t k = 0; k < g->n; k++)
    {
        *found = g->surface[k].zone && strcmp(g->surface[k].name, word) == 0 ? &g->surface[k]
                                                                              : *found;
    }
    DEM_REQUIRE(*found, DEM_ERROR_INPUT,
                "%s: zone %s, but this run has no mesh with such a zone of cells; make it "
                "(topoSet), or give inside walls and a box, cylinder or sphere",
                dem_dict_where(group), word);
    return DEM_OK;
}

int dem_insertion_limits_read(struct dem_insertion_limits **limits, const struct dem_dict *group,
                              const struct dem_insertion_regions *g, const struct dem_walls *w)
{
    const bool inside = dem_dict_has(group, "inside"), zone = dem_dict_has(group, "zone");

    *limits = NULL;
    DEM_REQUIRE(!inside || !zone, DEM_ERROR_INPUT,
                "%s: both inside and zone; keep one, as a zone is inside the mesh",
                dem_dict_where(group));
    if (!inside && !zone)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(*limits, 1));
    return inside ? read_inside(*limits, group, g, w) : read_zone(g, group, &(*limits)->surface);
}

void dem_insertion_limits_free(struct dem_insertion_limits *l)
{
    if (l)
    {
        dem_wall_search_free(&l->search);
        dem_closed_surface_free(&l->own);
        dem_memory_free(l);
    }
}

void dem_insertion_regions_free(struct dem_insertion_regions *g)
{
    for (size_t k = 0; k < g->n; k++)
    {
        dem_closed_surface_free(&g->surface[k]);
    }
    dem_memory_free(g->surface);
    *g = (struct dem_insertion_regions){.n = 0};
}

/* ---- test ------------------------------------------------------------------------------------ */

int dem_insertion_limits_prepare(struct dem_insertion_limits *l, const struct dem_walls *walls,
                                 const struct dem_domain *domain, double radius)
{
    l->walls = walls;
    l->domain = domain;
    return dem_wall_search_prepare(&l->search, walls, radius);
}

/* Does the surface contain x or one of its periodic images? x is in the domain. */
static int surface_contains(const struct dem_insertion_limits *l, const double x[3])
{
    const struct dem_domain *const d = l->domain;
    double image[3];

    for (int code = 0; code < DEM_SHIFTS; code++)
    {
        int exists = 1;

        for (int k = 0; k < 3; k++)
        {
            image[k] = x[k] + dem_shift_axis(code, k)*d->length[k];
            exists &= d->periodic[k] || dem_shift_axis(code, k) == 0;
        }
        if (exists && dem_closed_surface_contains(l->surface, image))
        {
            return 1;
        }
    }
    return 0;
}

int dem_insertion_limits_allow(struct dem_insertion_limits *l, double radius, const double x[3])
{
    struct dem_particle sphere = {.radius = radius};
    int clear = 0;

    memcpy(sphere.x, x, sizeof sphere.x);
    dem_domain_wrap(l->domain, &sphere);
    const int status = dem_wall_search_is_clear(&l->search, l->walls, &sphere, &clear);

    l->status = l->status ? l->status : status;
    return clear && (!l->surface || surface_contains(l, sphere.x));
}

void dem_insertion_limits_confine(struct dem_insertion_limits *l, double radius,
                                  const double from[3], double x[3])
{
    struct dem_particle sphere = {.radius = radius*(1.0 + gap)};
    double step[3], shift[3];
    int pushed = 1, status = DEM_OK;

    dem_vec_minus(x, from, step);
    const double size = dem_vec_norm(step);
    const double share = size > longest*radius ? longest*radius/size : 1.0;

    for (int k = 0; k < 3; k++)
    {
        sphere.x[k] = shift[k] = from[k] + share*step[k];
    }
    dem_domain_wrap(l->domain, &sphere);
    for (int k = 0; k < 3; k++)    /* from x to the image in the domain, where the walls are */
    {
        const double length = l->domain->length[k];

        shift[k] = length > 0.0 ? length*rint((sphere.x[k] - shift[k])/length) : 0.0;
    }
    for (int k = 0; k < PUSHES && pushed && !status; k++)
    {
        status = dem_wall_search_push_out(&l->search, l->walls, &sphere, &pushed);
    }
    l->status = l->status ? l->status : status;
    const int allowed = dem_insertion_limits_allow(l, radius, sphere.x);

    for (int k = 0; k < 3; k++)
    {
        x[k] = allowed ? sphere.x[k] - shift[k] : from[k];
    }
}
