/*
 * run_cost.c -- estimate memory by counting, processor time by timing a sample.
 *
 * The block (sample_block.h), as large as the part of the scene that a rank has, up to 250000
 * spheres, makes steps for 0.02 s of processor time, at least 10, after one that fills caches and
 * memory; then its lists are made as long. It has other walls and communication between ranks
 * than the scene: the estimate is good to a factor of 2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/run_cost.h"
#include "records/totals.h"
#include "step/neighbor_rebuild.h"
#include "step/sample_block.h"
#include "step/step_window.h"
#include <math.h>
#include <string.h>
#include <time.h>

/* ---- bytes --------------------------------------------------------------------------------------------------- */

/* Mean coordination number of a settled bed. */
static const double in_contact = 5.8;

/* Neighbors (walls included) of a sphere in a settled bed within a gap, in diameters. Counted in
   beds of 1000 to 9000 equal spheres of friction 0.3 in a box 10 diameters deep: 6.3 to 6.4 at
   0.04, 9.7 to 10.0 at 0.3. */
static double neighbors(double gap)
{
    const double per_diameter = 14.0;

    return in_contact + per_diameter*gap;
}

/* Skins in mean diameters if they are tuned: as for a bed that comes to rest, for which memory
   is kept. */
static const double tuned_skin[2] = {0.3, 0.04};

/* Listed pairs and candidate contacts per particle of a dense bed with the present skins. */
static void count_lists(const struct dem_state *state, const struct dem_inventory *s,
                        struct dem_run_cost *c)
{
    const double mean = s->all.diameters/(double)s->all.n, reach = state->pairs.reach/mean;
    const int tuned = state->pairs.skins.tuned;

    c->pairs = 0.5*neighbors(tuned ? reach + tuned_skin[0] : state->pairs.outer/mean);
    c->rows = 0.5*neighbors(tuned ? reach + tuned_skin[1] : state->pairs.inner/mean);
}

/* Lists grow by at most 1/8 when they are full: on average their capacity is (1/8)/ln(9/8) times
   their length. */
static const double capacity = 1.061;

static void count_bytes(const struct dem_state *state, const struct dem_inventory *s,
                        struct dem_run_cost *c)
{
    const double n = (double)s->all.n;
    const int ring = n*c->rows > DEM_FORCE_BUFFER_ROWS;

    c->particle = (double)dem_particles_bytes_per_particle(&state->particles) + 8.0*sizeof(uint32_t);
    c->pair = (double)dem_contacts_bytes_per_pair(&state->contacts);
    c->row = (double)dem_contacts_bytes_per_row(&state->contacts, ring);
    c->bed = n*(c->particle + capacity*(c->pairs*c->pair + c->rows*c->row));
    c->bed += ring ? (double)dem_contact_forces_ring_bytes(&state->contacts.forces) : 0.0;
    c->copy = n*sizeof(double)*(double)dem_particles_packed_size(&state->particles);
    if (state->contacts.history.columns > 0)
    {
        c->copy += n*0.5*in_contact*
                   (double)(sizeof(struct dem_contact_key) +
                            sizeof(double)*(size_t)state->contacts.history.columns);
    }
}

/* ---- the block ----------------------------------------------------------------------------------------------- */

enum
{
    STEPS = 10                                            /* of a window */
};

static const double long_enough = 0.02;                   /* s of processor time */

/* Spheres, some 200 MB: past any cache near a core, more change the time no further. */
static const int64_t max_block = 250000;

static double now(void)
{
    return (double)clock()/CLOCKS_PER_SEC;
}

/* Times windows until they took long enough, without the first step, which fills caches and
   memory. */
static int time_steps(struct dem_state *q, double dt, double *each)
{
    double start = 0.0;
    int windows = 0;

    for (; windows < 2 || now() - start < long_enough; windows++)
    {
        start = windows == 1 ? now() : start;
        DEM_TRY(dem_step_window(q, dt, windows == 0 ? 1 : STEPS));
        for (size_t i = 0; i < q->particles.n; i++)    /* nothing holds the block: it would fall */
        {
            memset(q->particles.record[i].v, 0, sizeof q->particles.record[i].v);
        }
    }
    *each = (now() - start)/(STEPS*(windows - 1)*(double)q->particles.n);
    return DEM_OK;
}

static int time_lists(struct dem_state *q, double *renew, double *prune)
{
    const double start = now();
    double middle, end;
    int renewed = 0, pruned = 0;

    do
    {
        DEM_TRY(dem_neighbor_rebuild(q));
        renewed++;
        middle = now();
    } while (middle - start < long_enough);
    do
    {
        DEM_TRY(dem_pairs_prune(&q->pairs, &q->particles, &q->walls, &q->contacts));
        pruned++;
        end = now();
    } while (end - middle < long_enough);
    *renew = (middle - start)/(renewed*(double)q->particles.n);
    *prune = (end - middle)/(pruned*(double)q->particles.n);
    return DEM_OK;
}

int dem_run_cost_measure(const struct dem_state *state, const struct dem_inventory *s, double dt,
                         struct dem_run_cost *c)
{
    struct dem_sample q;
    double slowest[4];
    int failed = 0;

    /* as many spheres as a rank has, so that they use the caches as the run will */
    const int64_t per_rank = s->all.n/state->decomposition.ranks;

    *c = (struct dem_run_cost){.ranks = state->decomposition.ranks,
                               .outer = state->pairs.half_outer,
                               .inner = state->pairs.half_inner,
                               .now = s->bytes,
                               .max_now = s->max_bytes,
                               .listed = s->pairs,
                               .candidates = s->rows};
    count_lists(state, s, c);
    count_bytes(state, s, c);
    int status = dem_sample_block_make(&q, state, s, per_rank < max_block ? per_rank : max_block);

    if (!status)
    {
        status = time_steps(&q.state, dt, &c->step);
        failed = status == DEM_ERROR_NUMBER || status == DEM_ERROR_LOST;
        status = failed ? DEM_OK : status;
    }
    status = status || failed ? status : time_lists(&q.state, &c->rebuild, &c->prune);
    c->particles = (int64_t)q.state.particles.n;
    dem_sample_block_free(&q);
    slowest[0] = status ? INFINITY : c->step;
    slowest[1] = c->rebuild;
    slowest[2] = c->prune;
    slowest[3] = failed;
    dem_totals_reduce_max(state, slowest, 4);
    c->step = slowest[3] > 0.0 ? 0.0 : slowest[0];
    c->rebuild = slowest[1];
    c->prune = slowest[2];
    return isfinite(slowest[0]) || status
               ? status
               : dem_error(DEM_ERROR_STATE, "another rank failed; see the message of that rank");
}
