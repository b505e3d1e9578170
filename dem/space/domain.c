/*
 * domain.c -- wrapping and counting images.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/domain.h"
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

void dem_domain_shifts(const struct dem_domain *d, double shift[DEM_SHIFTS][4])
{
    for (int code = 0; code < DEM_SHIFTS; code++)
    {
        for (int k = 0; k < 3; k++)
        {
            shift[code][k] = dem_shift_axis(code, k)*d->length[k];
        }
        shift[code][3] = 0.0;
    }
}

enum
{
    MOST_BOXES = 1024                                     /* who is further from a periodic box than so many is lost */
};

static int can_wrap(const struct dem_domain *d, int k, double x)
{
    return d->periodic[k] && fabs(x - d->min[k]) < MOST_BOXES*d->length[k];
}

void dem_domain_wrap(const struct dem_domain *d, struct dem_particle *p)
{
    for (int k = 0; k < 3; k++)
    {
        const int wraps = can_wrap(d, k, p->x[k]);

        while (wraps && p->x[k] < d->min[k])
        {
            p->x[k] += d->length[k];
            p->image = dem_image_add(p->image, k, -1);
        }
        while (wraps && p->x[k] >= d->max[k])
        {
            p->x[k] -= d->length[k];
            p->image = dem_image_add(p->image, k, 1);
        }
    }
}

int dem_domain_holds(const struct dem_domain *d, const double x[3])
{
    int inside = 1;

    for (int k = 0; k < 3; k++)
    {
        inside &= can_wrap(d, k, x[k]) || (x[k] >= d->min[k] && x[k] <= d->max[k]);
    }
    return inside;
}
