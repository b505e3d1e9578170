/*
 * cost.c -- counting bytes, and timing a block of spheres.
 *
 * The block (sample.h) runs for a tenth of a second of processor time. Its walls, its size in the caches and the talk between ranks are not the scene's: the
 * figure is good for a factor of 2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/cost.h"
#include "plan/sample.h"
#include "step/measure.h"
#include "step/step.h"
#include <math.h>
#include <time.h>

/* ---- bytes --------------------------------------------------------------------------------------------------- */

/* Partners of a sphere in a settled bed that touch it. */
static const double in_contact = 5.8;

/* Partners of a sphere in a settled bed to within a gap of g diameters, walls among them. Counted in beds of 1000 to 9000
   equal spheres of friction 0.3 in a box 10 diameters deep: 6.3 to 6.4 at 0.04, 9.7 to 10.0 at 0.3. */
static double partners(double gap)
{
    const double a_diameter = 14.0;

    return in_contact + a_diameter*gap;
}

/* Skins in mean diameters where skins tune themselves: those of a bed on its way to rest, for whose lists the room is kept. */
static const double tuned_skin[2] = {0.3, 0.04};

void dem_need_lists(const struct dem_parts *p, const struct dem_survey *s, double *pairs, double *rows)
{
    const double mean = s->all.n > 0 ? s->all.diameters/(double)s->all.n : 1.0;

    const double reach = p->pairs.reach/mean;
    const int tuned = p->pairs.skins.tuned;

    *pairs = 0.5*partners(tuned ? reach + tuned_skin[0] : p->pairs.outer/mean);
    *rows = 0.5*partners(tuned ? reach + tuned_skin[1] : p->pairs.inner/mean);
}

/* Lists grow by an eighth or less when they are full: on the mean their room is (1/8)/ln(9/8) times what is in them. */
static const double room = 1.061;

void dem_need_count(const struct dem_parts *p, const struct dem_survey *s, struct dem_need *need)
{
    const double n = (double)s->all.n;
    double pairs, rows;

    dem_need_lists(p, s, &pairs, &rows);
    need->particle = (double)dem_particles_each(&p->particles) + 8.0*sizeof(uint32_t);
    need->pair = (double)dem_contacts_each_pair(&p->contacts);
    need->row = (double)dem_contacts_each_row(&p->contacts);
    need->bed = n*(need->particle + room*(pairs*need->pair + rows*need->row));
    need->bed += n*rows > DEM_RING ? (double)dem_contacts_ring(&p->contacts) : 0.0;
    need->copy = n*sizeof(double)*(double)dem_particles_packed_size(&p->particles);
    if (p->contacts.memories > 0)
    {
        need->copy += n*0.5*in_contact*(double)(sizeof(struct dem_carried) + sizeof(double)*(size_t)p->contacts.memories);
    }
}

/* ---- the block ----------------------------------------------------------------------------------------------- */

enum
{
    STEPS = 10                                            /* of a window */
};

static const double long_enough = 0.1;                    /* s of processor time */

static double now(void)
{
    return (double)clock()/CLOCKS_PER_SEC;
}

/* Windows until they took long enough, the first left out: it fills caches and memory. */
static int time_steps(struct dem_parts *q, double dt, double *each)
{
    double start = 0.0;
    int windows = 0;

    for (; windows < 2 || now() - start < long_enough; windows++)
    {
        start = windows == 1 ? now() : start;
        DEM_TRY(dem_step_window(q, dt, STEPS));
    }
    *each = (now() - start)/(STEPS*(windows - 1)*(double)q->particles.n);
    return DEM_OK;
}

static int time_lists(struct dem_parts *q, double *renew, double *prune)
{
    const double start = now();
    double middle;

    for (int k = 0; k < 3; k++)
    {
        DEM_TRY(dem_step_renew(q));
    }
    middle = now();
    for (int k = 0; k < 10; k++)
    {
        DEM_TRY(dem_pairs_prune(&q->pairs, &q->particles, &q->walls, &q->contacts));
    }
    *renew = (middle - start)/(3.0*(double)q->particles.n);
    *prune = (now() - middle)/(10.0*(double)q->particles.n);
    return DEM_OK;
}

int dem_pace_take(const struct dem_parts *p, const struct dem_survey *s, double dt, struct dem_pace *pace)
{
    struct dem_parts q;
    double slowest[3];

    int status = dem_sample_make(&q, p, s, NULL);

    status = status ? status : time_steps(&q, dt, &pace->step);
    status = status ? status : time_lists(&q, &pace->renew, &pace->prune);
    pace->particles = (int64_t)q.particles.n;
    dem_sample_free(&q);
    slowest[0] = status ? INFINITY : pace->step;
    slowest[1] = pace->renew;
    slowest[2] = pace->prune;
    dem_measure_most(p, slowest, 3);
    pace->step = slowest[0];
    pace->renew = slowest[1];
    pace->prune = slowest[2];
    return isfinite(slowest[0]) || status ? status : dem_error(DEM_ERROR_STATE, "another rank failed; its message tells why");
}
