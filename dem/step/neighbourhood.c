/*
 * neighbourhood.c -- lists kept good: looked at, pruned, renewed; particles wrapped, removed, handed to their owners.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/neighbourhood.h"
#include "base/memory.h"
#include "step/agree.h"
#include "step/loss_cause.h"
#include "step/step.h"
#include "step/uniform.h"
#include <math.h>

/* Who has left the domain is removed at steps that are multiples of this, not when lists happen to be renewed: their cost must not
   change results. */
enum
{
    STEPS_OF_LEAVE = DEM_FLOW_STEPS
};

/* ---- renewing ------------------------------------------------------------------------------------------------ */

/* Who is outside is noted, to be removed, or an error. */
static int send_off(struct dem_parts *p, size_t i)
{
    const struct dem_particle *const q = &p->particles.record[i];
    char cause[DEM_CAUSE_SIZE];

    DEM_REQUIRE(isfinite(q->x[0] + q->x[1] + q->x[2]), DEM_ERROR_NUMBER,
                "the position of particle %lld is not a number at step %lld; look at its input and at the fluid around it",
                (long long)q->id, (long long)p->steps);
    dem_loss_cause_outside(p, i, cause);
    if (p->ledger.open)
    {
        dem_ledger_leaves(p, q, 0.5*p->dt);
    }
    DEM_REQUIRE(p->domain.remove, DEM_ERROR_LOST,
                "particle %lld left the domain at (%g %g %g) m at time %g s: %s; enlarge the domain, close it with a wall, or set "
                "domain/leaving remove", (long long)q->id, q->x[0], q->x[1], q->x[2], p->time, cause);
    if (p->flows.n > 0)
    {
        DEM_TRY(dem_flows_note(p, DEM_FLOW_DOMAIN, q, 0.5*p->dt));
    }
    return dem_losses_note(&p->losses, q, p->time, 1, cause);
}

/* Who is where an outlet takes particles out goes in steps in which outlets are looked at, and only then. */
static int drain(struct dem_parts *p, size_t i, int outlet)
{
    if (p->ledger.open)
    {
        dem_ledger_leaves(p, &p->particles.record[i], 0.5*p->dt);
    }
    return dem_flows_note(p, outlet, &p->particles.record[i], 0.5*p->dt);
}

static int leave_is_over(const struct dem_parts *p)
{
    return !p->domain.remove || p->steps%STEPS_OF_LEAVE == 0;
}

/* Where a particle is told to be. */
static int outlet_of(const struct dem_parts *p, const struct dem_particle *q)
{
    struct dem_particle home = *q;

    if (p->flows.n == 0)
    {
        return DEM_FLOW_NONE;
    }
    dem_domain_wrap(&p->domain, &home);
    return dem_flows_outlet(&p->flows, home.x);
}

/* 1 on all ranks when somebody is to be removed now. */
static int somebody_goes(struct dem_parts *p, int *goes)
{
    const int drains = dem_flows_step(p) && p->flows.plan->outlets > 0;
    double outside = 0.0;

    *goes = 0;
    if (!drains && (!p->domain.remove || !leave_is_over(p)))
    {
        return DEM_OK;
    }
    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];

        outside = p->domain.remove && !dem_domain_holds(&p->domain, q->x) ? 1.0 : outside;
        outside = drains && outlet_of(p, q) != DEM_FLOW_NONE ? 1.0 : outside;
    }
    DEM_TRY(dem_agree_most(p, DEM_OK, &outside, 1));
    *goes = outside > 0.0;
    return DEM_OK;
}

/* Wrap along periodic axes; who is outside then goes, with its weight if there are weights. */
static int bring_home(struct dem_parts *p, int weighed)
{
    struct dem_particle *const record = p->particles.record;
    const size_t n = p->particles.n;
    int status = DEM_OK;
    uint32_t *order;
    size_t kept = 0;

    DEM_TRY(DEM_NEW(order, n + 1));
    for (size_t i = 0; i < n && !status; i++)
    {
        dem_domain_wrap(&p->domain, &record[i]);
        const int outlet = dem_flows_outlet(&p->flows, record[i].x);

        if (outlet != DEM_FLOW_NONE && p->flows.now)
        {
            status = drain(p, i, outlet);
        }
        else if (outlet != DEM_FLOW_NONE || dem_domain_holds(&p->domain, record[i].x) || (!leave_is_over(p) && isfinite(record[i].x[0] + record[i].x[1] + record[i].x[2])))
        {
            order[kept++] = (uint32_t)i;
        }
        else
        {
            status = send_off(p, i);
        }
    }
    if (!status && kept < n)
    {
        dem_particles_reorder(&p->particles, order, kept);
        if (weighed)
        {
            dem_balance_keep(&p->balance, order, kept);
        }
    }
    dem_memory_free(order);
    return status;
}

static int hand_over(struct dem_parts *p, int cut, int weighed)
{
    if (cut)
    {
        DEM_TRY(dem_pieces_balance(&p->pieces, &p->particles, weighed ? p->balance.weight : NULL));
    }
    if (p->flows.arrivals > 0)
    {
        DEM_TRY(dem_flows_let_in(p, 0.5*p->dt));
    }
    else if (p->flows.left)
    {
        dem_uniform_renew(p, p->flows.fluid);
    }
    return dem_halo_migrate(&p->halo, &p->particles, &p->contacts);
}

static int prune(struct dem_parts *p)
{
    p->prunes++;
    dem_walls_remark(&p->walls, DEM_LIST_INNER);
    DEM_TRY(dem_pairs_prune(&p->pairs, &p->particles, &p->walls, &p->contacts));
    dem_wall_touches_rows(&p->touches, &p->pairs.search, &p->contacts);
    return dem_halo_choose_near(&p->halo, &p->particles, &p->contacts);
}

/* Particles, and pairs and near rows by who owns the lower id. */
static void count_lists(struct dem_parts *p)
{
    const struct dem_contacts *const c = &p->contacts;
    int64_t counted[3] = {(int64_t)p->particles.n, 0, 0};

    for (size_t k = 0; p->pairs.skins.tuned && k < c->pairs; k++)
    {
        const int mine = c->pair[k].i < p->particles.n;

        counted[1] += mine;
        counted[2] += mine && c->pair[k].row != DEM_ROW_NONE;
    }
    if (p->pairs.skins.tuned && p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, counted, 3, MPI_INT64_T, MPI_SUM, p->pieces.comm);
    }
    dem_skins_count(&p->pairs.skins, counted);
}

int dem_step_renew(struct dem_parts *p)
{
    const int cut = dem_balance_pays(&p->balance, &p->pieces), weighed = cut && p->stale < 2;
    int status = weighed ? dem_balance_weigh(&p->balance, &p->particles, &p->contacts) : DEM_OK;

    status = status ? status : dem_contacts_lift(&p->contacts, &p->particles, p->pairs.wall_region);
    status = status ? status : bring_home(p, weighed);
    DEM_TRY(dem_agree(p, status));
    if (p->flows.n > 0 && p->steps%STEPS_OF_LEAVE == 0)
    {
        DEM_TRY(dem_flows_book(p));
    }
    DEM_TRY(hand_over(p, cut, weighed));
    dem_pairs_thicken(&p->pairs);
    DEM_TRY(dem_pairs_order(&p->pairs, &p->particles));
    DEM_TRY(dem_halo_renew(&p->halo, &p->particles, &p->domain, p->pairs.most_radius, p->pairs.outer));
    status = dem_pairs_find(&p->pairs, &p->domain, &p->particles, &p->walls, &p->recipe, &p->contacts);
    DEM_TRY(dem_agree(p, status));
    DEM_TRY(dem_wall_touches_fit(&p->touches, &p->pairs.search));
    dem_walls_remark(&p->walls, DEM_LIST_OUTER);
    DEM_TRY(prune(p));
    count_lists(p);
    DEM_TRY(dem_contacts_settle(&p->contacts, &p->particles, p->pairs.wall_region));
    p->stale = 0;
    p->rebuilds++;
    return DEM_OK;
}

/* ---- when ---------------------------------------------------------------------------------------------------- */

/* How much of a skin [m] is used up: two particles, or one and a wall, may have come nearer by so much. */
static double used(const struct dem_parts *p, enum dem_list list)
{
    const struct dem_drift *const d = &p->pairs.drift[list];

    return d->spread + fmax(d->spread, dem_walls_moved(&p->walls, list, d->centre));
}

/* The bound has run out, so positions are looked at. What all have gone together does not count; but nobody goes further than half
   a periodic box from where he is told to be, and along an axis with a limit everybody counts from where he was. */
static int look(struct dem_parts *p, enum dem_list list)
{
    struct dem_drift *const d = &p->pairs.drift[list];
    double most[DEM_DRIFT_NUMBERS], centre[3], spread;
    int free[3];

    for (int k = 0; k < 3; k++)
    {
        free[k] = p->domain.periodic[k] || !(isfinite(p->domain.min[k]) || isfinite(p->domain.max[k]));
    }
    dem_drift_look(d, &p->particles, most);
    DEM_TRY(dem_agree_most(p, DEM_OK, most, DEM_DRIFT_NUMBERS));
    if (!dem_drift_take(d, most, free, centre))
    {
        return DEM_OK;
    }
    spread = dem_drift_spread(d, &p->particles, centre);
    DEM_TRY(dem_agree_most(p, DEM_OK, &spread, 1));
    dem_drift_settle(d, spread, centre);
    return DEM_OK;
}

/* 1 when particles may be further than half a skin outside of a periodic box and somebody will see them, or half a box at any time. */
static int strays(const struct dem_parts *p, int seen)
{
    const struct dem_drift *const d = &p->pairs.drift[DEM_LIST_OUTER];
    int stray = 0;

    for (int k = 0; k < 3; k++)
    {
        const double way = fabs(d->centre[k]) + d->spread;

        stray |= p->domain.periodic[k] && d->centre[k] != 0.0 && way > (seen ? p->pairs.half_outer : 0.5*p->domain.length[k]);
    }
    return stray;
}

/* Look at the lists whose bound has run out, or at both; `stale` by list. */
static int look_at_lists(struct dem_parts *p, int both, int stale[DEM_LISTS])
{
    for (enum dem_list l = 0; l < DEM_LISTS; l++)
    {
        const double skin = p->pairs.drift[l].skin;

        stale[l] = used(p, l) > skin;
        if (stale[l] || both)
        {
            DEM_TRY(look(p, l));
            stale[l] = used(p, l) > skin;
            if (stale[l] || both)
            {
                dem_skins_choose(&p->pairs.skins, l, 0.5*used(p, l));
            }
        }
    }
    return DEM_OK;
}

int dem_neighbourhood(struct dem_parts *p, double fastest, int seen)
{
    struct dem_pairs *const s = &p->pairs;
    int goes, stale[DEM_LISTS] = {0, 0};

    DEM_TRY(somebody_goes(p, &goes));
    p->flows.left = goes;
    p->flows.now = dem_flows_step(p);
    if (p->flows.now && p->flows.plan->streams > 0)
    {
        DEM_TRY(dem_agree(p, dem_flows_call(p, p->steps)));
        goes |= p->flows.arrivals > 0;
    }
    s->drift[DEM_LIST_OUTER].spread += fastest;
    s->drift[DEM_LIST_INNER].spread += fastest;
    if (!p->stale)
    {
        const int both = dem_skins_step(&s->skins, fastest);

        DEM_TRY(look_at_lists(p, both, stale));
        stale[DEM_LIST_OUTER] |= strays(p, seen) || (both && dem_skins_pays(&s->skins, DEM_LIST_OUTER));
        stale[DEM_LIST_INNER] |= both && dem_skins_pays(&s->skins, DEM_LIST_INNER);
    }
    dem_phases_end(&p->phases, DEM_PHASE_AGREE);
    if (p->stale || goes || stale[DEM_LIST_OUTER])
    {
        dem_phases_rare(&p->phases, DEM_PHASE_AGREE);
        dem_halo_wait(&p->halo);
        DEM_TRY(dem_step_renew(p));
        p->flows.now = p->flows.left = 0;
        dem_phases_rare_end(&p->phases, DEM_PHASE_RENEW);
        return DEM_OK;
    }
    dem_halo_receive(&p->halo, &p->particles);
    dem_phases_end(&p->phases, DEM_PHASE_REFRESH);
    if (stale[DEM_LIST_INNER])
    {
        dem_halo_send(&p->halo, &p->particles, DEM_HALO_ALL);
        dem_halo_receive(&p->halo, &p->particles);
        DEM_TRY(prune(p));
        dem_phases_end(&p->phases, DEM_PHASE_PRUNE);
    }
    return DEM_OK;
}
