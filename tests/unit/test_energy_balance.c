/*
 * test_energy_balance.c -- how the energy balance obtains the terms of an effect.
 *
 * - The work of forces and moments is measured for an effect without an energy function.
 * - An effect with one is given the overlap and stiffness of the previous step, also for partners
 *   that have separated since, its own forces and moments, and the velocities on which they act,
 *   added mass included.
 * - Dissipated energy counts from the start of the balance, elastic energy only in sweeps that
 *   report it, rows of other ranks never.
 * - When a bond breaks in a row, the loss of that row alone is reported as broken.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"

#include "records/energy_balance.h"
#include "ranks/dem_state.h"
#include "contacts/contact_batch.h"

#include <string.h>

static struct dem_energy_balance balance;
static struct dem_state p = {.energy_balance = &balance};
static struct dem_contact_workspace t;
static struct dem_pair pair[8];
static struct dem_particle record[2];
static uint32_t row_pair[8] = {0, 1, 2, 3, 4, 5, 6, 7};
static struct dem_energy seen;

static const double push = -3.0, pull[3] = {0.5, -1.0, 2.0}, moment[3] = {0.1, 0.2, -0.3};

/* the same for all rows */
static void act(const void *of, struct dem_contact_batch *restrict b, double *const *memory)
{
    (void)of, (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        b->fn[c] += push;
        b->fx[c] += pull[0], b->fy[c] += pull[1], b->fz[c] += pull[2];
        b->mx[c] += moment[0], b->my[c] += moment[1], b->mz[c] += moment[2];
    }
}

static void spring(const void *of, struct dem_contact_batch *restrict b, double *const *memory)
{
    (void)of, (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        b->kn[c] = 1000.0*sqrt(b->overlap[c]);
    }
}

static void report_energy(const void *of, const struct dem_contact_batch *b,
                          double *const *before, double *const *memory,
                          struct dem_energy *restrict e)
{
    (void)of;
    seen = *e;
    for (int c = 0; c < b->n; c++)
    {
        e->stored[c] = 7.0;
        e->lost[c] = memory[0][c] - before[0][c];
    }
}

static void bond_force(const void *of, struct dem_contact_batch *restrict b,
                       double *const *memory)
{
    (void)of, (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        b->lost[c] += 1.0 + c;
        b->broke[c] += c == 2 ? 1.0 : 0.0;
    }
}

static void store_history(const void *of, struct dem_contact_batch *restrict b,
                          double *const *memory)
{
    act(of, b, memory);
    for (int c = 0; c < b->n; c++)
    {
        memory[0][c] += 0.25;
    }
}

static const char *const names[] = {"a", NULL};
static const struct dem_effect normal = {.name = "normal",
                                         .stage = DEM_STAGE_NORMAL,
                                         .apply = spring};
static const struct dem_effect without_energy = {
    .name = "mute", .stage = DEM_STAGE_DAMP, .apply = act};
static const struct dem_effect with_energy = {.name = "speaks",
                                         .stage = DEM_STAGE_MOMENT,
                                         .apply = store_history,
                                         .history = names,
                                         .energy = report_energy};
static const struct dem_effect bond = {
    .name = "bond", .stage = DEM_STAGE_BOND, .apply = bond_force};

static double sum_of(const struct dem_effect *e, enum dem_energy_balance_sum which)
{
    return dem_sum_value(&dem_energy_balance_sums_of(p.energy_balance, e)[which]);
}

/* 8 rows, the last two of other ranks */
static void sweep(void)
{
    static double column[8];
    static struct dem_effect_list chain = {.entries = 4,
                                           .entry = {{.effect = &normal},
                                                     {.effect = &without_energy},
                                                     {.effect = &with_energy},
                                                     {.effect = &bond}},
                                           .pair = {.exponent = 1.5}};
    double *memory[] = {column};
    struct dem_energy_balance_rows r = {.list = &chain, .memory = memory, .row = 0, .rows = 8};

    memset(t.batch.fn, 0, sizeof t.batch.fn);
    dem_energy_balance_begin_sweep(&p);
    dem_energy_balance_begin_batch(&p, &t, &r);
    for (int k = 0; k < chain.entries; k++)
    {
        r.entry = &chain.entry[k];
        dem_energy_balance_before_effect(&p, &t, &r);
        chain.entry[k].effect->apply(NULL, &t.batch, memory);
        dem_energy_balance_after_effect(&p, &t, &r);
    }
}

static void set_up(void)
{
    struct dem_contact_batch *const b = &t.batch;
    static struct dem_interaction_table recipe = {
        .chosen = 4,
        .effect = {&normal, &without_energy, &with_energy, &bond}};

    p.particles.n = 1;
    p.particles.record = record;
    p.contacts.pairs.pair = pair;
    p.contacts.rows.pair = row_pair;
    record[0] = (struct dem_particle){.radius = 1.02,
                                      .inverse_mass = 0.5,
                                      /* some of the mass does not rotate */
                                      .inverse_inertia = 2.0};
    record[1] = (struct dem_particle){.radius = 2.02, .inverse_mass = 4.0, .inverse_inertia = 6.0};
    b->n = 8;
    b->dt = 0.01;
    for (int c = 0; c < 8; c++)
    {
        pair[c] = (struct dem_pair){.i = c < 6 ? 0 : 1, .j = 1};
        b->touching[c] = 1.0;
        b->overlap[c] = 0.04;
        t.gathered.radii[c] = 2.0;
        t.gathered.rx[c] = 1.96;
        b->hx[c] = b->nx[c] = 1.0;
        /* 0.03 of the overlap are due to this drift */
        t.gathered.vx[c] = -3.0;
        b->sx[c] = 0.2, b->sy[c] = 0.4, b->sz[c] = 0.8;
        b->wx[c] = 1.0, b->wy[c] = 2.0, b->wz[c] = 3.0;
    }
    /* a row of another rank, which no sum includes: apart by 0.02, with an overlap of 0.01
       before */
    b->overlap[7] = b->touching[7] = 0.0;
    t.gathered.rx[7] = 2.02;
    t.gathered.vx[7] = 3.0;
    if (dem_energy_balance_open(p.energy_balance, &recipe))
    {
        printf("Bail out! no memory\n");
    }
}

int main(void)
{
    TAP_TRAPS;
    set_up();

    sweep();
    TAP_OK(sum_of(&without_energy, DEM_ENERGY_BALANCE_LOST) == 0.0 &&
               sum_of(&with_energy, DEM_ENERGY_BALANCE_LOST) == 0.0,
           "no dissipation before the start");
    TAP_NEAR(sum_of(&with_energy, DEM_ENERGY_BALANCE_ELASTIC), 6.0*7.0, 1e-15,
             "elastic energy of own rows counts before the start");

    p.energy_balance->begun = 1;
    p.energy_balance->sums_elastic = 0;
    sweep();
    const double power = push*-3.0 + 0.2*pull[0] + 0.4*pull[1] + 0.8*pull[2] + moment[0] +
                         2.0*moment[1] + 3.0*moment[2];

    TAP_NEAR(sum_of(&without_energy, DEM_ENERGY_BALANCE_LOST), -6.0*0.01*power, 1e-14,
             "an effect without an energy function has the work of its force measured");
    TAP_NEAR(sum_of(&with_energy, DEM_ENERGY_BALANCE_LOST), 6.0*0.25, 1e-15,
             "an effect with an energy function is called with its history before and after");
    TAP_NEAR(sum_of(&with_energy, DEM_ENERGY_BALANCE_ELASTIC), 6.0*7.0, 1e-15,
             "elastic energies stay as in the last sweep that reports them");
    TAP_NEAR(seen.previous_overlap[3], 0.01, 1e-14, "the overlap before the drift");
    TAP_NEAR(seen.previous_kn[3], 1000.0*0.1, 1e-12, "the previous stiffness, by the normal law");
    TAP_NEAR(seen.previous_overlap[7], 0.01, 1e-14, "the overlap before separation");
    TAP_NEAR(seen.previous_kn[7], 1000.0*0.1, 1e-12, "the stiffness before separation");
    TAP_OK(t.batch.kn[7] == 0.0, "the present stiffness is 0");
    TAP_NEAR(seen.normal_force[3], push, 1e-15, "its own force");
    TAP_NEAR(seen.mz[3], moment[2], 1e-15, "its own moment");
    TAP_NEAR(seen.inertia[3], 1.0/8.0, 1e-15, "the inertia of both");
    TAP_NEAR(seen.slip_mass[3], 1.0/(0.5 + 4.0 + 2.0*1.0 + 6.0*4.0), 1e-16,
             "the effective mass of slip, with the lever arms");
    TAP_NEAR(sum_of(&bond, DEM_ENERGY_BALANCE_LOST), 1.0 + 2.0 + 4.0 + 5.0 + 6.0, 1e-15,
             "the energies of bonds are counted");
    TAP_NEAR(dem_sum_value(&p.energy_balance->sum[DEM_ENERGY_BALANCE_BROKEN]), 3.0, 1e-15,
             "the loss is reported as broken where one broke");

    p.energy_balance->sums_elastic = 1;
    sweep();
    TAP_NEAR(sum_of(&with_energy, DEM_ENERGY_BALANCE_ELASTIC), 6.0*7.0, 1e-15,
             "the next reporting sweep starts at 0");
    dem_energy_balance_free(p.energy_balance);
    TAP_DONE;
}
