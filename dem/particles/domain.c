/*
 * domain.c -- wrapping and image counters, projection onto flat axes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/domain.h"
#include "core/error.h"
#include <math.h>
#include <string.h>

void dem_domain_init(struct dem_domain *d)
{
    memset(d, 0, sizeof *d);
    for (int k = 0; k < 3; k++)
    {
        d->min[k] = -INFINITY;
        d->max[k] = INFINITY;
    }
}

/* The unit is the spacing of doubles two boxes away from the domain. A double of 2^52 units has no
   fractional bits: adding 1.5 * 2^52 units and subtracting them again rounds to whole units. */
void dem_domain_finish(struct dem_domain *d)
{
    for (int k = 0; k < 3; k++)
    {
        if (d->periodic[k])
        {
            const double length = d->max[k] - d->min[k];
            int binary;

            frexp(fmax(fabs(d->min[k]), fabs(d->max[k])) + 2.0*length, &binary);
            d->unit[k] = ldexp(1.0, binary - 53);
            d->round[k] = ldexp(1.5, binary - 1);
            d->length[k] = d->unit[k]*rint(length/d->unit[k]);
        }
        if (d->flat[k])
        {
            d->plane[k] = 0.5*(d->min[k] + d->max[k]);
            d->round[k] = 1e300;
        }
    }
}

void dem_domain_shifts(const struct dem_domain *d, double shift[DEM_SHIFTS][4])
{
    for (int code = 0; code < DEM_SHIFTS; code++)
    {
        for (int k = 0; k < 3; k++)
        {
            shift[code][k] = dem_shift_axis(code, k)*d->length[k];
        }
        shift[code][0] += dem_shift_axis(code, 1)*d->offset;
        shift[code][3] = 0.0;
    }
}

enum
{
    MAX_BOXES = 1024              /* a particle further from a periodic box is lost */
};

static int can_wrap(const struct dem_domain *d, int k, double x)
{
    return d->periodic[k] && fabs(x - d->min[k]) < MAX_BOXES*d->length[k];
}

double dem_domain_offset_turns(const struct dem_domain *d)
{
    return d->offset != 0.0 ? rint(d->offset/d->length[0]) : 0.0;
}

/* Across y first: an image there has another x. */
void dem_domain_wrap(const struct dem_domain *d, struct dem_particle *p)
{
    static const int order[] = {1, 0, 2};

    for (int n = 0; n < 3; n++)
    {
        const int k = order[n];
        const double aside = k == 1 ? d->offset : 0.0;
        const int wraps = can_wrap(d, k, p->x[k]);

        p->x[k] = wraps ? d->unit[k]*rint(p->x[k]/d->unit[k]) : p->x[k];
        while (wraps && p->x[k] < d->min[k])
        {
            p->x[k] += d->length[k];
            p->x[0] += aside;
            p->image = dem_image_add(p->image, k, -1);
        }
        while (wraps && p->x[k] >= d->max[k])
        {
            p->x[k] -= d->length[k];
            p->x[0] -= aside;
            p->image = dem_image_add(p->image, k, 1);
        }
    }
}

int dem_domain_contains(const struct dem_domain *d, const double x[3])
{
    int inside = 1;

    for (int k = 0; k < 3; k++)
    {
        inside &= can_wrap(d, k, x[k]) || (x[k] >= d->min[k] && x[k] <= d->max[k]);
    }
    return inside;
}

/* ---- flat axes ------------------------------------------------------------------------------- */

int dem_domain_project(const struct dem_domain *d, struct dem_particle *p)
{
    for (int k = 0; k < 3; k++)
    {
        if (d->flat[k] && fabs(p->x[k] - d->plane[k]) > p->radius)
        {
            return 0;
        }
    }
    for (int k = 0; k < 3; k++)
    {
        p->x[k] = d->flat[k] ? d->plane[k] : p->x[k];
        p->v[k] = d->flat[k] ? 0.0 : p->v[k];
        p->w[k] = d->flat[(k + 1)%3] || d->flat[(k + 2)%3] ? 0.0 : p->w[k];
    }
    return 1;
}

int dem_domain_project_all(const struct dem_domain *d, struct dem_particles *p)
{
    for (size_t i = 0; i < p->n; i++)
    {
        struct dem_particle *const q = &p->record[i];

        for (int k = 0; k < 3; k++)
        {
            DEM_REQUIRE(
                !d->flat[k] || fabs(q->x[k] - d->plane[k]) <= q->radius, DEM_ERROR_INPUT,
                "particle %lld is at %c = %g m, but the domain is flat there and holds all centres at %g m; start it "
                "within one radius (%g m) of that plane",
                (long long)q->id, "xyz"[k], q->x[k], d->plane[k], q->radius);
            DEM_REQUIRE(
                !d->flat[k] || q->v[k] == 0.0, DEM_ERROR_INPUT,
                "particle %lld moves by %g m/s along %c, where the domain is flat; set this component of its "
                "velocity to 0",
                (long long)q->id, q->v[k], "xyz"[k]);
        }
        dem_domain_project(d, q);
    }
    return DEM_OK;
}

void dem_domain_constrain(const struct dem_domain *d, struct dem_particles *p)
{
    for (int k = 0; k < 3; k++)
    {
        for (size_t i = 0; d->flat[k] && i < p->n; i++)
        {
            p->record[i].v[k] = 0.0;
            p->record[i].w[(k + 1)%3] = 0.0;
            p->record[i].w[(k + 2)%3] = 0.0;
        }
    }
}
