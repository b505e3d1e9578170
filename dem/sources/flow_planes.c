/*
 * flow_planes.c -- planes and discs that count the particles that pass them: reading, and whether a path goes
 * through one.
 *
 *     planes { neck { point (0 0 0.1); normal (0 0 -1); radius 0.02; } }
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/stream.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static int refuse_same(const char *name, const char *other)
{
    DEM_REQUIRE(strcmp(name, other) != 0, DEM_ERROR_INPUT,
                "planes/%s has the name of a stream, outlet or plane; rename one of them", name);
    return DEM_OK;
}

static int check_names(const struct dem_streams *s, int k)
{
    const char *const name = s->plane[k].name;

    DEM_TRY(refuse_same(name, "domain"));
    for (int o = 0; o < s->streams; o++)
    {
        DEM_TRY(refuse_same(name, s->stream[o].name));
    }
    for (int o = 0; o < s->outlets; o++)
    {
        DEM_TRY(refuse_same(name, s->outlet[o].name));
    }
    return DEM_OK;
}

static int read_plane(struct dem_flow_plane *p, const struct dem_dict *dict)
{
    char where[256];

    memset(p, 0, sizeof *p);
    snprintf(where, sizeof where, "%s: %s", dem_dict_where(dict), dem_dict_path(dict));
    DEM_REQUIRE(strlen(dem_dict_name(dict)) < DEM_FLOW_NAME, DEM_ERROR_INPUT,
                "%s: a name longer than %d characters; shorten it", where, DEM_FLOW_NAME - 1);
    snprintf(p->name, sizeof p->name, "%s", dem_dict_name(dict));
    DEM_TRY(dem_dict_vector(dict, "point", "m", p->point));
    DEM_TRY(dem_dict_vector(dict, "normal", "1", p->normal));
    DEM_TRY(dem_dict_number_or(dict, "radius", "m", INFINITY, &p->radius));
    const double size = dem_vec_norm(p->normal);

    DEM_REQUIRE(size > 0.0 && isfinite(size) && p->radius > 0.0, DEM_ERROR_INPUT,
                "%s: normal of length %g, radius %g m; give the direction that counts as forth and a "
                "radius above 0, or none for the whole plane", where, size, p->radius);
    for (int k = 0; k < 3; k++)
    {
        p->normal[k] /= size;
    }
    return DEM_OK;
}

int dem_streams_read_planes(struct dem_streams *s, const struct dem_dict *planes)
{
    for (size_t k = 0; planes && k < dem_dict_count(planes); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(planes, k);

        DEM_REQUIRE(dem_entry_is_dict(e), DEM_ERROR_INPUT,
                    "%s: planes holds planes like %s { point (0 0 0); normal (0 0 -1); radius 0.01; }",
                    dem_entry_where(e), dem_entry_name(e));
        DEM_TRY(DEM_GROW(s->plane, s->plane_capacity, s->planes + 1));
        DEM_TRY(read_plane(&s->plane[s->planes++], dem_entry_dict(e)));
        DEM_TRY(check_names(s, s->planes - 1));
    }
    /* one more is used for the domain */
    DEM_REQUIRE(s->streams + s->outlets + 2*s->planes < DEM_SNAPSHOT_FLOWS, DEM_ERROR_INPUT,
                "%d streams and groups with `at`, %d outlets and %d planes, which count twice; the limit "
                "is %d in all; join some", s->streams, s->outlets, s->planes, DEM_SNAPSHOT_FLOWS - 1);
    return DEM_OK;
}

int dem_flow_plane_crossed(const struct dem_flow_plane *p, const double from[3], const double step[3],
                           const double part[2])
{
    double away[3];

    dem_vec_minus(from, p->point, away);
    const double height = dem_vec_dot(away, p->normal), rise = dem_vec_dot(step, p->normal);
    const int way = (height + rise >= 0.0) - (height >= 0.0);

    if (way == 0)
    {
        return 0;
    }
    const double at = -height/rise;

    for (int k = 0; k < 3; k++)
    {
        away[k] += at*step[k];
    }
    return at >= part[0] && at <= part[1] && dem_vec_dot(away, away) <= p->radius*p->radius ? way : 0;
}
