/*
 * test_balance.c -- subdomains have equal work, and space is repartitioned when that pays.
 *
 * - Each rank has its fraction of the weights to 1 %.
 * - An imbalance that a repartition cannot reduce causes no further one.
 * - A growing imbalance causes a repartition, on all ranks together, when its accumulated loss
 *   reaches the price of one.
 *
 *     mpirun -np N test_balance    prints failures; status 0 if there are none
 *
 * Reference: sums of weights by rank; the price in ranks/load_balance.c, 10 steps of mean work.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "parallel/ranks.h"

#include "core/random.h"
#include "ranks/decomposition.h"
#include "ranks/load_balance.h"
#include <math.h>
#include <stdlib.h>

enum
{
    EACH = 20000
};

/* Particles of all ranks lie anywhere in a box of 3 x 1 x 2, those beyond x = 1 weigh ten times as
   much. */
static void shares(struct dem_decomposition *decomposition)
{
    struct dem_particles p = {.n = EACH};
    uint32_t *const weight = calloc(EACH, sizeof *weight);
    double *const sum = calloc((size_t)ranks, sizeof *sum), total = 0.0;

    p.record = calloc(EACH, sizeof *p.record);
    for (size_t i = 0; i < EACH; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            p.record[i].x[k] = (3.0 - k)*(k == 1 ? 0.5 : 1.0)*
                               dem_random_unit(5, i, (uint64_t)rank, (uint64_t)k);
        }
        weight[i] = p.record[i].x[0] > 1.0 ? 20 : 2;
    }
    check(dem_decomposition_balance(decomposition, &p, weight) == 0, "balance", 0, 0);
    for (size_t i = 0; i < EACH; i++)
    {
        const int owner = dem_decomposition_owner(decomposition, p.record[i].x);
        double min[3], max[3];

        dem_decomposition_box(decomposition, owner, min, max);
        for (int k = 0; k < 3; k++)
        {
            check(p.record[i].x[k] >= min[k] && p.record[i].x[k] < max[k],
                  "the owner's box holds the particle", p.record[i].x[k], min[k]);
        }
        sum[owner] += weight[i];
    }
    MPI_Allreduce(MPI_IN_PLACE, sum, ranks, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    for (int k = 0; k < ranks; k++)
    {
        total += sum[k];
    }
    for (int k = 0; k < ranks; k++)
    {
        /* 0.005 of a part at each level of the tree, of parts that halve: below 0.01 */
        check(fabs(sum[k]*ranks/total - 1.0) < 0.01, "share of a rank", sum[k]*ranks/total, 1.0);
    }
    free(p.record);
    free(weight);
    free(sum);
}

/* Intervals of ten steps until a cut pays, at most `most`; rank 0 has 1 + excess of the mean
   work. */
static int until(struct dem_load_balance *b, const struct dem_decomposition *decomposition, double excess,
                 int most)
{
    const struct dem_contacts none = {.rows.classes = 0};
    const double others = 1.0 - excess/(ranks - 1);
    const size_t particles = (size_t)(1e6*(rank == 0 ? 1.0 + excess : others));

    for (int k = 1; k <= most; k++)
    {
        for (int step = 0; step < 10; step++)
        {
            dem_load_balance_count(b, particles, &none);
        }
        int pays = dem_load_balance_pays(b, decomposition), all = pays;

        MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
        check(all == pays*ranks, "ranks that decide for a cut", all, pays*ranks);
        if (pays)
        {
            return k;
        }
    }
    return 0;
}

static void prices(const struct dem_decomposition *decomposition)
{
    struct dem_load_balance b = {.cuts = 0};
    int k = until(&b, decomposition, 0.26, 100);

    /* 2.6 steps are lost in an interval of ten */
    check(k == 4, "intervals to the first cut", k, 4);
    k = until(&b, decomposition, 0.2, 1000);
    check(k == 0, "an imbalance that a cut cannot reduce causes no other cut", k, 0);
    k = until(&b, decomposition, 0.33, 100);
    check(k == 8, "intervals until a growing loss has cost a cut", k, 8);
    check(b.cuts == 2, "cuts", b.cuts, 2);
    dem_load_balance_free(&b);
}

int main(int argc, char **argv)
{
    struct dem_decomposition decomposition;

    ranks_begin(&argc, &argv);
    check(ranks > 1, "ranks; run it on two or more", ranks, 2);
    check(dem_decomposition_init(&decomposition, MPI_COMM_WORLD, rank, ranks) == 0, "pieces", 0, 0);
    shares(&decomposition);
    prices(&decomposition);
    dem_decomposition_free(&decomposition);
    return ranks_end();
}
