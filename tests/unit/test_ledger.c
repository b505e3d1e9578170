/*
 * Claims: an effect that tells no energies has the work of its force measured, normal, tangential and of its moment; one that
 * does is told the overlap and the stiffness of a step ago, also of partners that have parted since, its own push and moment and what
 * moments and forces in the contact plane move, added mass included; heat counts only after the beginning, elastic energies only in sweeps that tell, and rows of other ranks never; of a bond that breaks
 * in a row, that row's heat alone is told as broken.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"

#include "step/ledger.h"
#include "step/parts.h"
#include "step/tray.h"

#include <string.h>

static struct dem_parts p;
static struct dem_tray t;
static struct dem_pair pair[8];
static struct dem_particle record[2];
static uint32_t row_pair[8] = {0, 1, 2, 3, 4, 5, 6, 7};
static struct dem_energy seen;

static const double push = -3.0, pull[3] = {0.5, -1.0, 2.0}, moment[3] = {0.1, 0.2, -0.3};

/* the same for all rows */
static void act(const void *of, struct dem_block *restrict b, dem_real *const *memory)
{
    (void)of, (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        b->fn[c] += push;
        b->fx[c] += pull[0], b->fy[c] += pull[1], b->fz[c] += pull[2];
        b->mx[c] += moment[0], b->my[c] += moment[1], b->mz[c] += moment[2];
    }
}

static void spring(const void *of, struct dem_block *restrict b, dem_real *const *memory)
{
    (void)of, (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        b->kn[c] = 1000.0*sqrt(b->overlap[c]);
    }
}

static void tell(const void *of, const struct dem_block *b, dem_real *const *before, dem_real *const *memory, struct dem_energy *restrict e)
{
    (void)of;
    seen = *e;
    for (int c = 0; c < b->n; c++)
    {
        e->stored[c] = 7.0;
        e->lost[c] = memory[0][c] - before[0][c];
    }
}

static void glue(const void *of, struct dem_block *restrict b, dem_real *const *memory)
{
    (void)of, (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        b->lost[c] += 1.0 + c;
        b->broke[c] += c == 2 ? 1.0 : 0.0;
    }
}

static void remember(const void *of, struct dem_block *restrict b, dem_real *const *memory)
{
    act(of, b, memory);
    for (int c = 0; c < b->n; c++)
    {
        memory[0][c] += 0.25;
    }
}

static const char *const names[] = {"a", NULL};
static const struct dem_effect normal = {.name = "normal", .stage = DEM_STAGE_NORMAL, .act = spring};
static const struct dem_effect mute = {.name = "mute", .stage = DEM_STAGE_DAMP, .act = act};
static const struct dem_effect speaks = {.name = "speaks", .stage = DEM_STAGE_MOMENT, .act = remember, .memory = names, .energy = tell};
static const struct dem_effect bond = {.name = "bond", .stage = DEM_STAGE_BOND, .act = glue};

static double sum_of(const struct dem_effect *e, enum dem_ledger_sum which)
{
    return dem_sum_value(&dem_ledger_of(&p.ledger, e)[which]);
}

/* 8 rows, the last two of other ranks */
static void sweep(void)
{
    static double column[8];
    static struct dem_chain chain = {.links = 4, .link = {{.effect = &normal}, {.effect = &mute}, {.effect = &speaks}, {.effect = &bond}},
                                     .pair = {.exponent = 1.5}};
    double *memory[] = {column};
    struct dem_ledger_rows r = {.chain = &chain, .memory = memory, .row = 0, .rows = 8};

    memset(t.block.fn, 0, sizeof t.block.fn);
    dem_ledger_sweep(&p.ledger);
    dem_ledger_block(&p, &t, &r);
    for (int k = 0; k < chain.links; k++)
    {
        r.link = &chain.link[k];
        dem_ledger_before(&p, &t, &r);
        chain.link[k].effect->act(NULL, &t.block, memory);
        dem_ledger_after(&p, &t, &r);
    }
}

static void set_up(void)
{
    struct dem_block *const b = &t.block;
    static struct dem_recipe recipe = {.chosen = 4, .effect = {&normal, &mute, &speaks, &bond}};

    p.particles.n = 1;
    p.particles.record = record;
    p.contacts.pair = pair;
    p.contacts.row_pair = row_pair;
    record[0] = (struct dem_particle){.radius = 1.02, .inverse_mass = 0.5, .inverse_inertia = 2.0};     /* some of the mass does not turn */
    record[1] = (struct dem_particle){.radius = 2.02, .inverse_mass = 4.0, .inverse_inertia = 6.0};
    b->n = 8;
    b->dt = 0.01;
    for (int c = 0; c < 8; c++)
    {
        pair[c] = (struct dem_pair){.i = c < 6 ? 0 : 1, .j = 1};
        b->touching[c] = 1.0;
        b->overlap[c] = 0.04;
        t.g.radii[c] = 2.0;
        t.g.rx[c] = 1.96;
        b->hx[c] = b->nx[c] = 1.0;
        t.g.vx[c] = -3.0;                                 /* 0.03 of the overlap are of this drift */
        b->sx[c] = 0.2, b->sy[c] = 0.4, b->sz[c] = 0.8;
        b->wx[c] = 1.0, b->wy[c] = 2.0, b->wz[c] = 3.0;
    }
    /* a row of another rank, so that no sum feels it: apart by 0.02, before by an overlap of 0.01 */
    b->overlap[7] = b->touching[7] = 0.0;
    t.g.rx[7] = 2.02;
    t.g.vx[7] = 3.0;
    if (dem_ledger_open(&p.ledger, &recipe))
    {
        printf("Bail out! no memory\n");
    }
}

int main(void)
{
    TAP_TRAPS;
    set_up();

    sweep();
    TAP_OK(sum_of(&mute, DEM_LEDGER_LOST) == 0.0 && sum_of(&speaks, DEM_LEDGER_LOST) == 0.0, "before the beginning no heat counts");
    TAP_NEAR(sum_of(&speaks, DEM_LEDGER_STORED), 6.0*7.0, 1e-15, "but what is held does, of our own rows");

    p.ledger.begun = 1;
    p.ledger.tells = 0;
    sweep();
    const double power = push*-3.0 + 0.2*pull[0] + 0.4*pull[1] + 0.8*pull[2] + moment[0] + 2.0*moment[1] + 3.0*moment[2];

    TAP_NEAR(sum_of(&mute, DEM_LEDGER_LOST), -6.0*0.01*power, 1e-14, "who tells nothing has the work of its force measured");
    TAP_NEAR(sum_of(&speaks, DEM_LEDGER_LOST), 6.0*0.25, 1e-15, "who tells is asked, with its memory of before and after");
    TAP_NEAR(sum_of(&speaks, DEM_LEDGER_STORED), 6.0*7.0, 1e-15, "elastic energies stay those of the last sweep that told");
    TAP_NEAR(seen.was[3], 0.01, 1e-14, "the overlap of before the drift");
    TAP_NEAR(seen.kn_was[3], 1000.0*0.1, 1e-12, "the stiffness of then, by the normal law");
    TAP_NEAR(seen.was[7], 0.01, 1e-14, "and where they have parted since");
    TAP_NEAR(seen.kn_was[7], 1000.0*0.1, 1e-12, "the stiffness, too");
    TAP_OK(t.block.kn[7] == 0.0, "which is not that of now");
    TAP_NEAR(seen.push[3], push, 1e-15, "its own push");
    TAP_NEAR(seen.mz[3], moment[2], 1e-15, "its own moment");
    TAP_NEAR(seen.inertia[3], 1.0/8.0, 1e-15, "the inertia of both");
    TAP_NEAR(seen.slip_mass[3], 1.0/(0.5 + 4.0 + 2.0*1.0 + 6.0*4.0), 1e-16, "and what slips at a force between them, by the arms to their contact");
    TAP_NEAR(sum_of(&bond, DEM_LEDGER_LOST), 1.0 + 2.0 + 4.0 + 5.0 + 6.0, 1e-15, "books of bonds are taken");
    TAP_NEAR(dem_sum_value(&p.ledger.sum[DEM_LEDGER_BROKEN]), 3.0, 1e-15, "and told as broken where one broke");

    p.ledger.tells = 1;
    sweep();
    TAP_NEAR(sum_of(&speaks, DEM_LEDGER_STORED), 6.0*7.0, 1e-15, "the next that tells counts anew");
    dem_ledger_free(&p.ledger);
    TAP_DONE;
}
