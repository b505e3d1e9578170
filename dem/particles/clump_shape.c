/*
 * clump_shape.c -- reads templates of rigid bodies; their centre, principal axes and moments of inertia.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/clump_shape.h"
#include "core/did_you_mean.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "particles/clump.h"
#include "particles/particles.h"
#include "particles/principal_axes.h"
#include "particles/sphere_union.h"
#include <math.h>
#include <string.h>

/* of the bound: thinner shapes are flat, and centres nearer to each other equal, as a union has its
   centre to 1e-5 */
#define CENTRE_ERROR 1e-4

/* See clump_shape.h. */
static void limit_step(struct dem_clump_shape *s)
{
    double contacts = (double)s->n, area = 0.0, most = 0.0;

    for (size_t k = 0; k < s->n; k++)
    {
        area += s->sphere[k][3]*s->sphere[k][3];
    }
    for (int a = 0; a < 3; a++)
    {
        const int b = (a + 1)%3, c = (a + 2)%3;
        double squares = 0.0, offsets = 0.0, arms = 0.0;

        for (size_t k = 0; k < s->n; k++)
        {
            const double *const r = s->offset[k], square = r[b]*r[b] + r[c]*r[c],
                         of_radius = s->sphere[k][3]*s->sphere[k][3];

            squares += square;
            offsets += of_radius*square;
            arms += 0.4*of_radius*of_radius;
        }
        contacts = fmax(contacts, s->volume*squares/s->inertia[a]);
        most = fmax(most, fmax(offsets, arms)/s->inertia[a]);
    }
    s->step_volume = s->volume/contacts*fmin(1.0, 4.0/contacts);
    s->bond_radius = 0.75/(3.14159265358979323846*fmax(area/s->volume, most))*fmin(1.0, 4.0/contacts);
}

/* One axis: make the shares' centre 0 along it, with factors 1 + t (x - centre) of at least 1/10. */
static double centre_shares(struct dem_clump_shape *s, int a)
{
    double centre = 0.0, square = 0.0, most = 0.0, sum = 0.0;

    for (size_t k = 0; k < s->n; k++)
    {
        centre += s->share[k]*s->offset[k][a];
    }
    for (size_t k = 0; k < s->n; k++)
    {
        const double d = s->offset[k][a] - centre;

        square += s->share[k]*d*d;
        most = fmax(most, fabs(d));
    }
    if (square <= CENTRE_ERROR*CENTRE_ERROR*s->bound*s->bound)
    {
        return 0.0;
    }
    const double t = fmax(-0.9/most, fmin(0.9/most, -centre/square));

    for (size_t k = 0; k < s->n; k++)
    {
        s->share[k] *= 1.0 + t*(s->offset[k][a] - centre);
        sum += s->share[k];
    }
    for (size_t k = 0; k < s->n; k++)
    {
        s->share[k] /= sum;
    }
    return fabs(centre);
}

/* The shares by r^3, then with the body's centre, axis by axis. What is left, as the centre of the union is
   not exact, moves the body's centre; more is refused. */
static int find_shares(struct dem_clump_shape *s)
{
    double off = INFINITY, left[3] = {0.0, 0.0, 0.0}, scene[3];

    DEM_TRY(DEM_NEW(s->share, s->n));
    for (size_t k = 0; k < s->n; k++)
    {
        s->share[k] = dem_sphere_volume(s->sphere[k][3])/s->solid;
    }
    for (int turn = 0; turn < 300 && off > 1e-15*s->reach && s->volume < s->solid*(1.0 - 1e-12); turn++)
    {
        off = fmax(centre_shares(s, 0), fmax(centre_shares(s, 1), centre_shares(s, 2)));
    }
    for (size_t k = 0; k < 3*s->n; k++)
    {
        left[k%3] += s->share[k/3]*s->offset[k/3][k%3];
    }
    DEM_REQUIRE(dem_vec_norm(left) <= CENTRE_ERROR*s->bound, DEM_ERROR_INPUT,
                "shapes/%s: no weights of the spheres have the centre of their union, the best is %g m beside "
                "it; leave out spheres that others nearly hold", s->name, dem_vec_norm(left));
    if (dem_vec_norm(left) <= 1e-12*s->bound)
    {
        return DEM_OK;
    }
    s->reach += dem_vec_norm(left);
    s->bound += dem_vec_norm(left);
    dem_clump_rotate(s->principal, left, scene);
    for (size_t k = 0; k < 3*s->n; k++)
    {
        s->offset[k/3][k%3] -= left[k%3];
    }
    for (int a = 0; a < 3; a++)
    {
        s->centre[a] += scene[a];
    }
    return DEM_OK;
}

/* Centre, inertia and offsets from the integrals. */
static int finish(struct dem_clump_shape *s, const struct dem_union_moments *m)
{
    double A[3][3], R[3][3], square[3];

    s->volume = m->volume;
    for (int a = 0; a < 3; a++)
    {
        s->centre[a] = m->origin[a] + m->first[a]/m->volume;
        for (int b = 0; b < 3; b++)
        {
            A[a][b] = m->second[a][b] - m->first[a]*m->first[b]/m->volume;
        }
    }
    dem_principal_axes(A, R, s->principal);
    for (int a = 0; a < 3; a++)
    {
        square[a] = A[a][a];
    }
    for (int a = 0; a < 3; a++)
    {
        s->inertia[a] = square[(a + 1)%3] + square[(a + 2)%3];
    }
    DEM_TRY(DEM_NEW(s->offset, s->n));
    for (size_t k = 0; k < s->n; k++)
    {
        double d[3];

        dem_vec_minus(s->sphere[k], s->centre, d);
        for (int a = 0; a < 3; a++)
        {
            s->offset[k][a] = R[0][a]*d[0] + R[1][a]*d[1] + R[2][a]*d[2];
        }
        s->reach = fmax(s->reach, dem_vec_norm(d));
        s->bound = fmax(s->bound, dem_vec_norm(d) + s->sphere[k][3]);
        s->solid += dem_sphere_volume(s->sphere[k][3]);
    }
    limit_step(s);
    return find_shares(s);
}

/* ---- reading --------------------------------------------------------------------------------- */

static int read_shape(struct dem_clump_shape *s, const struct dem_dict *dict)
{
    *s = (struct dem_clump_shape){.name = dem_dict_name(dict)};
    DEM_TRY(dem_dict_fours(dict, "spheres", "m", &s->sphere, &s->n));
    DEM_REQUIRE(s->n > 0 && s->n <= DEM_CLUMP_SPHERES, DEM_ERROR_INPUT,
                "%s: shapes/%s has %zu spheres; give 1 to %d", dem_dict_where(dict), s->name, s->n,
                DEM_CLUMP_SPHERES);
    for (size_t k = 0; k < s->n; k++)
    {
        const double *const at = s->sphere[k], r = at[3];

        DEM_REQUIRE(isnormal(r*r*r*r*r) && r > 0.0 &&
                        fmax(fabs(at[0]), fmax(fabs(at[1]), fabs(at[2]))) <= 1e3*s->sphere[0][3],
                    DEM_ERROR_INPUT,
                    "%s: shapes/%s: sphere %zu at (%g %g %g) m has radius %g m; give a radius above 0, "
                    "and coordinates of at most 1000 radii of the first sphere",
                    dem_dict_where(dict), s->name, k + 1, at[0], at[1], at[2], r);
    }
    struct dem_union_moments m;

    dem_sphere_union(s->n, s->sphere, &m);
    return finish(s, &m);
}

int dem_clump_shapes_read(struct dem_clump_shapes *all, const struct dem_dict *scene)
{
    const struct dem_dict *shapes;

    DEM_TRY(dem_dict_sub_if(scene, "shapes", &shapes));
    for (size_t k = 0; shapes && k < dem_dict_count(shapes); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(shapes, k);

        DEM_REQUIRE(dem_entry_is_dict(e), DEM_ERROR_INPUT,
                    "%s: shapes holds entries like %s { spheres ((x y z r) ...); }",
                    dem_entry_where(e), dem_entry_name(e));
        DEM_TRY(DEM_GROW(all->shape, all->capacity, all->n + 1));
        DEM_TRY(read_shape(&all->shape[all->n++], dem_entry_dict(e)));
    }
    return DEM_OK;
}

void dem_clump_shapes_free(struct dem_clump_shapes *all)
{
    for (size_t k = 0; k < all->n; k++)
    {
        dem_memory_free(all->shape[k].offset);
        dem_memory_free(all->shape[k].share);
    }
    dem_memory_free(all->shape);
    memset(all, 0, sizeof *all);
}

int dem_clump_shapes_find(const struct dem_clump_shapes *all, const char *name, const char *where,
                          const struct dem_clump_shape **found)
{
    const char **names;

    for (size_t k = 0; k < all->n; k++)
    {
        if (strcmp(all->shape[k].name, name) == 0)
        {
            *found = &all->shape[k];
            return DEM_OK;
        }
    }
    DEM_REQUIRE(all->n > 0, DEM_ERROR_INPUT,
                "%s: shape %s, but the scene has no shapes; add shapes { %s { spheres ((x y z r) ...); "
                "} }", where, name, name);
    DEM_TRY(DEM_NEW(names, all->n));
    for (size_t k = 0; k < all->n; k++)
    {
        names[k] = all->shape[k].name;
    }
    const int status = dem_did_you_mean_error("shape", name, names, (int)all->n);

    dem_memory_free(names);
    return dem_error_prefix(status, "%s: ", where);
}

const struct dem_clump_shape *dem_clump_shapes_with_volume(const struct dem_clump_shapes *all,
                                                           double volume)
{
    const struct dem_clump_shape *found = NULL;

    for (size_t k = 0; k < all->n; k++)
    {
        const struct dem_clump_shape *const s = &all->shape[k];

        if (fabs(volume - s->volume) < 1e-9*volume && (!found || s->step_volume < found->step_volume))
        {
            found = s;
        }
    }
    return found;
}

double dem_clump_shapes_bond_radius(const struct dem_clump_shapes *all)
{
    double least = 0.0;

    for (size_t k = 0; k < all->n; k++)
    {
        least = k == 0 ? all->shape[k].bond_radius : fmin(least, all->shape[k].bond_radius);
    }
    return least;
}
