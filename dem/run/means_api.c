/*
 * means_api.c -- means of time series with their intervals, for programs around the library.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/block_means.h"
#include "core/error.h"
#include "core/memory.h"
#include "dem_tables.h"

struct dem_means
{
    struct dem_block_means blocks;
};

int dem_means_create(struct dem_means **m, size_t columns)
{
    *m = NULL;
    DEM_TRY(DEM_NEW(*m, 1));
    const int status = dem_block_means_init(&(*m)->blocks, columns);

    if (status)
    {
        dem_means_free(*m);
        *m = NULL;
    }
    return status;
}

void dem_means_add(struct dem_means *m, const double *sample, double weight)
{
    dem_block_means_add(&m->blocks, sample, weight);
}

void dem_means_free(struct dem_means *m)
{
    if (m)
    {
        dem_block_means_free(&m->blocks);
        dem_memory_free(m);
    }
}

static void mean_itself(const double *mean, double *result)
{
    result[0] = mean[0];
}

int dem_means_get(const struct dem_means *m, double *mean, double *half_width)
{
    for (size_t c = 0; c < m->blocks.columns; c++)
    {
        dem_block_means_derive(&m->blocks, c, 1, mean_itself, 1, &mean[c], &half_width[c]);
    }
    return m->blocks.full;
}
