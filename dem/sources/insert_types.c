/*
 * insert_types.c -- read the settings of each type of a group of `insert`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/insert_group.h"
#include "core/did_you_mean.h"
#include "core/error.h"
#include "sources/insert_amount.h"
#include "sources/packing.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double
    pi = 3.14159265358979323846,
    max_width = 1e9,  /* diameters along an edge: positions have 1e-7 diameters of rounding there */
    many = 1e6;       /* particles: the sum of drawn volumes is close to the multiple of the mean */

/* ---- region ---------------------------------------------------------------------------------- */

/* Random centres in a box, or in a cylinder along the flat axis, lie in the plane of a flat domain, whatever their
   diameters; the volume stays. */
static int flatten(struct dem_insert_group *b, const struct dem_domain *d)
{
    struct dem_insertion_shape *const v = &b->shape;

    v->region = dem_insertion_shape_volume(v);
    for (int k = 0; k < 3; k++)
    {
        const int cylinder = v->kind == DEM_INSERTION_SHAPE_CYLINDER && fabs(v->axis[k]) > 1.0 - 1e-12;

        if (d->flat[k] && (cylinder || v->kind == DEM_INSERTION_SHAPE_BOX))
        {
            DEM_REQUIRE(v->min[k] <= d->plane[k] && v->max[k] >= d->plane[k], DEM_ERROR_INPUT,
                        "%s: the %s is from %g to %g m along %c, but the domain is flat there and holds all "
                        "centres at %g m; make it hold this plane",
                        b->where, dem_insertion_shape_name(v), v->min[k], v->max[k], "xyz"[k], d->plane[k]);
            v->min[k] = v->max[k] = d->plane[k];
            v->open[k][0] = v->open[k][1] = !cylinder;
            v->from[k] = cylinder ? d->plane[k] : v->from[k];
            v->length = cylinder ? 0.0 : v->length;
            v->open_end[0] |= cylinder;
            v->open_end[1] |= cylinder;
        }
    }
    return DEM_OK;
}

/* A mesh or zone is its own region, unless a shape is given within it. */
static int read_shape(struct dem_insert_group *b, const struct dem_domain *d)
{
    const struct dem_closed_surface *const s = b->limits ? b->limits->surface : NULL;
    const bool whole = s && !dem_dict_has(b->dict, "min") && !dem_dict_has(b->dict, "max")
                    && !dem_dict_has(b->dict, "cylinder") && !dem_dict_has(b->dict, "sphere");

    if (whole)
    {
        b->shape = (struct dem_insertion_shape){.kind = DEM_INSERTION_SHAPE_BOX,
                                                .region = s->volume};
        memcpy(b->shape.min, s->min, sizeof s->min);
        memcpy(b->shape.max, s->max, sizeof s->max);
    }
    else
    {
        DEM_TRY(dem_insertion_shape_read(&b->shape, b->dict));
    }
    b->shape.limits = b->limits;
    DEM_TRY(dem_insertion_shape_open(&b->shape, d, b->where));
    if (b->type == DEM_INSERT_RANDOM)
    {
        DEM_TRY(flatten(b, d));
    }
    if (b->type == DEM_INSERT_LATTICE)
    {
        memset(b->shape.open, 0, sizeof b->shape.open);    /* its sites are half a pitch inside */
    }
    DEM_REQUIRE(!s || whole || !dem_dict_has(b->dict, "solidFraction"), DEM_ERROR_INPUT,
                "%s: solidFraction of a part of the mesh, whose volume is not known; give count or "
                "mass, or a zone without a box, cylinder or sphere", b->where);
    return DEM_OK;
}

static int read_region(struct dem_insert_group *b, const struct dem_domain *d,
                       const struct dem_size_distribution *sizes)
{
    DEM_TRY(read_shape(b, d));
    for (int k = 0; k < 3; k++)
    {
        const double wide = b->shape.max[k] - b->shape.min[k];

        DEM_REQUIRE(wide <= max_width*sizes->max, DEM_ERROR_INPUT,
                    "%s: the %s is %g m wide along %c, more than %g times the diameter %g m; make "
                    "it smaller",
                    b->where, dem_insertion_shape_name(&b->shape), wide, "xyz"[k], max_width,
                    sizes->max);
    }
    return dem_insertion_shape_check_fits(&b->shape, 0.5*sizes->min, b->where);
}

/* A body has the diameter of the sphere that holds it in any orientation. */
static int read_sizes(struct dem_insert_group *b, struct dem_size_distribution *sizes)
{
    if (b->clump.shape)
    {
        *sizes = (struct dem_size_distribution){.min = 2.0*b->clump.shape->bound,
                                                .max = 2.0*b->clump.shape->bound};
        return DEM_OK;
    }
    return dem_size_distribution_read(sizes, b->dict, b->ratio);
}

/* ---- lattice --------------------------------------------------------------------------------- */

static int read_lattice_box(struct dem_insert_group *b, const struct dem_domain *d)
{
    struct dem_size_distribution sizes;

    DEM_REQUIRE(!dem_dict_has(b->dict, "sizes") && !dem_dict_has(b->dict, "cylinder")
                    && !dem_dict_has(b->dict, "sphere"),
                DEM_ERROR_INPUT,
                "%s: a lattice has one diameter and fills a box; use type random, or diameter, min "
                "and max",
                b->where);
    DEM_TRY(read_sizes(b, &sizes));
    b->diameter = sizes.min;
    return read_region(b, d, &sizes);
}

static int read_pitch(struct dem_insert_group *b)
{
    double spacing, jitter;

    DEM_TRY(dem_dict_number_or(b->dict, "spacing", "1", 1.1, &spacing));
    DEM_TRY(dem_dict_number_or(b->dict, "jitter", "1", 0.5, &jitter));
    DEM_REQUIRE(spacing >= 1.0 && jitter >= 0.0 && jitter <= 1.0, DEM_ERROR_INPUT,
                "%s: spacing %g, jitter %g; give a spacing of 1 diameter or more and a jitter in 0 "
                ".. 1",
                b->where, spacing, jitter);
    b->pitch = spacing*b->diameter;
    b->amplitude = jitter*(b->pitch - b->diameter);
    return DEM_OK;
}

static int read_lattice(struct dem_insert_group *b, const struct dem_interaction_table *r,
                        const struct dem_domain *d)
{
    struct dem_amount amount;
    double sites = 1.0;

    DEM_TRY(read_lattice_box(b, d));
    DEM_TRY(read_pitch(b));
    const double one = b->clump.shape ? b->clump.shape->volume : pi/6.0*b->diameter*b->diameter*b->diameter;

    DEM_TRY(dem_amount_read(&amount, b, r, one));
    for (int k = 0; k < 3; k++)
    {
        b->sites[k] = (int64_t)((b->shape.max[k] - b->shape.min[k])/b->pitch*(1.0 + 1e-12));
        b->sites[k] = b->sites[k] < 1 ? 1 : b->sites[k];
        sites *= (double)b->sites[k];
    }
    const bool fill = amount.count == 0 && amount.volume == 0.0;
    const double asked = fill ? sites
                       : amount.count > 0 ? (double)amount.count
                                          : floor(amount.volume/one + 0.5);

    DEM_REQUIRE(!fill || asked <= dem_amount_max, DEM_ERROR_INPUT,
                "%s: without count the whole box is filled, and %.0f particles are more than %.0f; "
                "give count, or a smaller box",
                b->where, asked, dem_amount_max);
    DEM_REQUIRE(!b->limits || sites <= dem_amount_max, DEM_ERROR_INPUT,
                "%s: the lattice has %.3g sites, each to be tested for walls, the limit is %.0f; "
                "give a smaller box",
                b->where, sites, dem_amount_max);
    DEM_REQUIRE(asked >= 1.0, DEM_ERROR_INPUT, "%s: less than half a particle; ask for more",
                b->where);
    DEM_REQUIRE(asked <= sites, DEM_ERROR_INPUT,
                "%s: count %.0f, but the box holds %.0f (%lld x %lld x %lld) at a spacing of %g "
                "diameters; enlarge the box or ask for fewer",
                b->where, asked, sites, (long long)b->sites[0], (long long)b->sites[1],
                (long long)b->sites[2], b->pitch/b->diameter);
    b->count = (int64_t)asked;
    b->fill = fill;
    return DEM_OK;
}

/* ---- random ---------------------------------------------------------------------------------- */

/* A large group that cannot fit is refused by its mean volume before diameters are drawn, a
   small one by the drawn volume. */
static int read_drawn(struct dem_insert_group *b, const struct dem_interaction_table *r,
                      const struct dem_domain *d, const struct dem_size_distribution *sizes)
{
    const double mean = b->clump.shape ? b->clump.shape->volume : dem_size_distribution_mean_volume(sizes);
    struct dem_amount amount;

    DEM_TRY(read_region(b, d, sizes));
    DEM_TRY(dem_amount_read(&amount, b, r, mean));
    const double expected = amount.count > 0 ? (double)amount.count*mean : amount.volume;

    if (expected > many*mean)
    {
        DEM_TRY(dem_packing_check_fraction(&b->shape, expected, expected/mean,
                                           b->clump.shape ? "clumps" : "particles", b->where));
    }
    DEM_TRY(dem_amount_draw(b, &amount, sizes));
    return DEM_OK;
}

static int read_random(struct dem_insert_group *b, const struct dem_interaction_table *r,
                       const struct dem_domain *d)
{
    struct dem_size_distribution sizes;
    double volume = 0.0;
    int status = read_sizes(b, &sizes);

    status = status ? status : read_drawn(b, r, d, &sizes);
    dem_size_distribution_free(&sizes);
    DEM_TRY(status);
    for (int64_t k = 0; k < b->count; k++)
    {
        const double d = dem_insert_group_diameter(b, k);

        volume += pi/6.0*d*d*d;
        DEM_TRY(dem_insertion_shape_check_fits(&b->shape, 0.5*d, b->where));
    }
    return dem_packing_check_fraction(&b->shape, volume, (double)b->count,
                                      b->clump.shape ? "spheres, one around each clump," : "particles", b->where);
}

/* ---- list and table -------------------------------------------------------------------------- */

static int read_diameters(struct dem_insert_group *b, size_t n)
{
    size_t diameters;

    if (b->clump.shape)
    {
        b->diameter = 2.0*b->clump.shape->bound;
        return DEM_OK;
    }
    if (!dem_dict_has(b->dict, "diameters"))
    {
        DEM_TRY(dem_dict_number(b->dict, "diameter", "m", &b->diameter));
        DEM_REQUIRE(b->diameter > 0.0, DEM_ERROR_INPUT, "%s: diameter %g m; give a number above 0",
                    b->where, b->diameter);
        return DEM_OK;
    }
    DEM_TRY(dem_dict_numbers(b->dict, "diameters", "m", &b->diameters, &diameters));
    DEM_REQUIRE(diameters == n, DEM_ERROR_INPUT,
                "%s: %zu positions, but %zu diameters; give as many of each, or one diameter",
                b->where, n, diameters);
    for (size_t m = 0; m < n; m++)
    {
        DEM_REQUIRE(b->diameters[m] > 0.0, DEM_ERROR_INPUT,
                    "%s: number %zu of diameters is %g m; give a number above 0", b->where, m + 1,
                    b->diameters[m]);
    }
    return DEM_OK;
}

static int check_ids(const struct dem_insert_group *b)
{
    for (int64_t m = 0; b->ids && m < b->count; m++)
    {
        DEM_REQUIRE(b->ids[m] >= 0 && b->ids[m] < INT64_MAX, DEM_ERROR_INPUT,
                    "%s: number %lld of its ids is %lld; give whole numbers from 0 to %lld",
                    b->where, (long long)m + 1, (long long)b->ids[m], (long long)INT64_MAX - 1);
    }
    return DEM_OK;
}

/* Lists of scalars, by their names in the plural. */
static int read_scalar_lists(struct dem_insert_group *b, const struct dem_interaction_table *r,
                             size_t n)
{
    for (int k = 0; k < r->scalars; k++)
    {
        const struct dem_scalar *const s = r->scalar[k];
        char plural[64];
        size_t values;

        snprintf(plural, sizeof plural, "%ss", s->name);
        if (s->fluid_entry || !dem_dict_has(b->dict, plural))
        {
            continue;
        }
        DEM_TRY(dem_dict_numbers(b->dict, plural, s->unit, &b->scalars[k], &values));
        DEM_REQUIRE(values == n, DEM_ERROR_INPUT,
                    "%s: %zu positions, but %zu %s; give as many of each, or one %s", b->where, n,
                    values, plural, s->name);
        for (size_t m = 0; m < n; m++)
        {
            DEM_TRY(dem_scalar_require(r, k, b->scalars[k][m], b->where));
        }
    }
    return DEM_OK;
}

static int read_list(struct dem_insert_group *b, const struct dem_interaction_table *r)
{
    size_t n, velocities = 0, spins = 0, ids = 0;

    DEM_TRY(dem_dict_vectors(b->dict, "positions", "m", &b->positions, &n));
    DEM_REQUIRE(n > 0, DEM_ERROR_INPUT,
                "%s: the list positions is empty; give at least one, or remove the group", b->where);
    DEM_TRY(read_diameters(b, n));
    if (dem_dict_has(b->dict, "velocities"))
    {
        DEM_TRY(dem_dict_vectors(b->dict, "velocities", "m/s", &b->velocities, &velocities));
    }
    if (dem_dict_has(b->dict, "spins"))
    {
        DEM_TRY(dem_dict_vectors(b->dict, "spins", "1/s", &b->spins, &spins));
    }
    if (dem_dict_has(b->dict, "ids"))
    {
        DEM_TRY(dem_dict_int64s(b->dict, "ids", &b->ids, &ids));
    }
    DEM_REQUIRE(!b->ids || ids == n, DEM_ERROR_INPUT,
                "%s: %zu positions, but %zu ids; give as many of each, or leave the list out",
                b->where, n, ids);
    DEM_REQUIRE((!b->velocities || velocities == n) && (!b->spins || spins == n), DEM_ERROR_INPUT,
                "%s: %zu positions, but %zu velocities, %zu spins; give as many of each, or leave "
                "the list out",
                b->where, n, velocities, spins);
    b->count = (int64_t)n;
    DEM_TRY(read_scalar_lists(b, r, n));
    return check_ids(b);
}

static int read_table(struct dem_insert_group *b, const struct dem_interaction_table *r)
{
    DEM_TRY(dem_insert_group_read_table(b, r));
    if (!b->diameters)
    {
        DEM_TRY(read_diameters(b, (size_t)b->count));
    }
    return check_ids(b);
}

/* ---- all ------------------------------------------------------------------------------------- */

int dem_insert_group_read_type(struct dem_insert_group *b, const struct dem_interaction_table *r,
                     const struct dem_insertion *i, const struct dem_walls *w, const char *type)
{
    static const char *const known[] = {"lattice", "random", "list", "table", "stream"};
    int k = 0;

    while (k < DEM_INSERT_TYPES && strcmp(type, known[k]) != 0)
    {
        k++;
    }
    b->type = (enum dem_insert_type)k;
    if (k == DEM_INSERT_LATTICE || k == DEM_INSERT_RANDOM)
    {
        DEM_TRY(dem_insertion_limits_read(&b->limits, b->dict, &i->regions, w));
        DEM_TRY(dem_dict_int64_or(b->dict, "seed", 1, &b->seed));
    }
    switch (k)
    {
    case DEM_INSERT_LATTICE: return read_lattice(b, r, i->domain);
    case DEM_INSERT_RANDOM: return read_random(b, r, i->domain);
    case DEM_INSERT_LIST: return read_list(b, r);
    case DEM_INSERT_TABLE: return read_table(b, r);
    default:
        return dem_error_prefix(dem_did_you_mean_error("type of insertion", type, known,
                                                       DEM_INSERT_TYPES + 1),
                                "%s: ", b->where);
    }
}
