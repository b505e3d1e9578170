/*
 * kept.c -- whole arrays, copied.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/kept.h"
#include "base/error.h"
#include <string.h>

void dem_kept_free(struct dem_kept *k)
{
    dem_particles_free(&k->particles);
    dem_contacts_free(&k->rows);
    memset(k, 0, sizeof *k);
}

int dem_kept_take(struct dem_kept *k, const struct dem_particles *p, const struct dem_contacts *c, const int *wall_region)
{
    k->held = 0;
    DEM_TRY(dem_particles_copy(&k->particles, p));
    k->rows.memories = c->memories;
    k->rows.carried = 0;
    DEM_TRY(dem_contacts_copy_rows(&k->rows, c, p, wall_region));
    k->held = 1;
    return DEM_OK;
}

int dem_kept_give(const struct dem_kept *k, struct dem_particles *p, struct dem_contacts *c)
{
    DEM_TRY(dem_particles_grow(p, k->particles.n));
    DEM_TRY(dem_particles_copy(p, &k->particles));
    c->pairs = c->carried = 0;
    c->rows = 0;
    return dem_contacts_copy_rows(c, &k->rows, p, NULL);
}
