/*
 * backup.c -- copies particles and contact history into the backup and back.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/backup.h"
#include "core/error.h"
#include <string.h>

void dem_backup_free(struct dem_backup *b)
{
    dem_particles_free(&b->particles);
    dem_contacts_free(&b->history);
    memset(b, 0, sizeof *b);
}

int dem_backup_save(struct dem_backup *b, const struct dem_particles *p,
                    const struct dem_contacts *c, const struct dem_facet_key *wall_facet)
{
    b->valid = 0;
    DEM_TRY(dem_particles_copy(&b->particles, p));
    b->history.history.columns = c->history.columns;
    b->history.history.saved = 0;
    DEM_TRY(dem_contacts_copy_saved(&b->history, c, p, wall_facet));
    b->valid = 1;
    return DEM_OK;
}

int dem_backup_restore(const struct dem_backup *b, struct dem_particles *p, struct dem_contacts *c)
{
    DEM_TRY(dem_particles_grow(p, b->particles.n));
    DEM_TRY(dem_particles_copy(p, &b->particles));
    c->pairs.n = c->history.saved = 0;
    c->rows.n = 0;
    c->forces.touching = 0;
    return dem_contacts_copy_saved(c, &b->history, p, NULL);
}
