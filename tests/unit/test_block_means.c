/*
 * test_block_means.c -- 95 % intervals from block means.
 *
 * - The interval contains the true mean in 95 of 100 series, also when successive samples are
 *   correlated.
 * - A ratio of means has the interval of the delta method.
 *
 * References: series with known means: uniform numbers in (0, 1), and x' = a x + noise. The mean of
 * the latter has the variance s2/n (1 + a)/(1 - a), s2 = noise variance/(1 - a^2), so its interval
 * is sqrt((1 + a)/(1 - a)) times wider than with as many independent samples.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/block_means.h"
#include "dem_tables.h"
#include "core/random.h"

enum
{
    SERIES = 2000
};

static double uniform(uint64_t series, uint64_t step, uint64_t use)
{
    return dem_random_unit(11, series, step, use);
}

static void mean_of(const double *mean, double *result)
{
    result[0] = mean[0];
}

static void ratio(const double *mean, double *result)
{
    result[0] = mean[0]/mean[1];
}

struct outcome
{
    /* fraction of series with the true mean in the interval; mean half width */
    double covered, width;
};

/* n samples of x' = a x + noise, noise uniform in (-1/2, 1/2); the true mean is 0 */
static struct outcome correlated(double a, int n)
{
    struct outcome o = {0.0, 0.0};

    for (uint64_t s = 0; s < SERIES; s++)
    {
        struct dem_block_means b;
        double value, ci, x = 0.0;

        dem_block_means_init(&b, 1);
        /* the first 200 samples are discarded */
        for (int k = -200; k < n; k++)
        {
            x = a*x + uniform(s, (uint64_t)(k + 200), 0) - 0.5;
            if (k >= 0)
            {
                dem_block_means_add(&b, &x, 1.0);
            }
        }
        dem_block_means_derive(&b, 0, 1, mean_of, 1, &value, &ci);
        o.covered += fabs(value) <= ci;
        o.width += ci/SERIES;
        dem_block_means_free(&b);
    }
    o.covered /= SERIES;
    return o;
}

static void intervals(void)
{
    const double noise = sqrt(1.0/12.0);
    const struct outcome alone = correlated(0.0, 1000), correlated_samples = correlated(0.8, 5000);
    /* the fraction of 2000 series has a standard deviation of sqrt(0.05 0.95/2000) = 0.005: four of
       these */
    const double scatter = 0.02;

    TAP_NEAR(alone.covered, 0.95, scatter,
             "independent samples: 95 of 100 intervals contain the mean (%.3f)", alone.covered);
    /* t of about 22 degrees of freedom is 2.07; the mean of s is below the true one by 1/(4 22) */
    TAP_NEAR(alone.width, 2.07*noise/sqrt(1000.0), 0.03*2.07*noise/sqrt(1000.0), "width of the intervals");
    /* blocks of 256 samples hold 28 correlation times of 4.5; successive blocks are still
       correlated: 2 % fewer */
    TAP_NEAR(correlated_samples.covered, 0.95, 2.0*scatter,
             "correlated samples (a = 0.8): 95 of 100 (%.3f)", correlated_samples.covered);
    const double wide = 2.09*noise/sqrt(1.0 - 0.64)*sqrt(9.0/5000.0);

    TAP_NEAR(correlated_samples.width, wide, 0.06*wide, "the width is three times the width for independent samples");
}

/* mean x/mean y, x = y + noise: variance by the delta method is var(x - r y)/(n <y>^2) */
static void ratios(void)
{
    const int n = 4096;
    double width = 0.0, covered = 0.0;

    for (uint64_t s = 0; s < SERIES/4; s++)
    {
        struct dem_block_means b;
        double value, ci;

        dem_block_means_init(&b, 2);
        for (int k = 0; k < n; k++)
        {
            const double y = 1.0 + uniform(s, (uint64_t)k, 1),
                         x = 2.0*y + uniform(s, (uint64_t)k, 2) - 0.5;

            dem_block_means_add(&b, (double[]){x, y}, 1.0);
        }
        dem_block_means_derive(&b, 0, 2, ratio, 1, &value, &ci);
        width += ci/(SERIES/4);
        covered += fabs(value - 2.0) <= ci;
        dem_block_means_free(&b);
    }
    const double expected = 2.09*sqrt(1.0/12.0/n)/1.5;

    TAP_NEAR(width, expected, 0.06*expected, "a ratio has the interval of the delta method");
    TAP_NEAR(covered/(SERIES/4), 0.95, 0.04,
             "it contains the true ratio");      /* four times sqrt(0.05 0.95/500) */
}

static void means(void)
{
    struct dem_block_means b;
    double value, ci, sum = 0.0;
    const int most = 1000;

    dem_block_means_init(&b, 1);
    dem_block_means_derive(&b, 0, 1, mean_of, 1, &value, &ci);
    TAP_OK(value == 0.0 && isnan(ci), "no sample: 0, and no interval");
    for (int k = 0; k < most; k++)
    {
        const double x = (double)k;

        dem_block_means_add(&b, &x, 1.0);
        sum += x;
        if (k == 2)
        {
            dem_block_means_derive(&b, 0, 1, mean_of, 1, &value, &ci);
            TAP_OK(value == 1.0 && isnan(ci), "three samples: their mean, and no interval");
        }
    }
    dem_block_means_derive(&b, 0, 1, mean_of, 1, &value, &ci);
    TAP_OK(value == sum/most,
           "a thousand samples: the mean of all, through five doublings and a half-filled block");
    TAP_OK(b.samples == most && b.length == 32 && b.full == 31, "31 blocks of 32");
    dem_block_means_free(&b);
}

/* Four samples 0, 0, 0, 8 with weights 1, 1, 1, 5: mean 5; without one of the first three the mean is
   40/7, without the last 0. The jackknife's variance of n = 4 is (n - 1)/n times the sum of their
   squared distances from the centre 30/7: 3/4 (3 (10/7)^2 + (30/7)^2) = 900/49. */
static void weights(void)
{
    struct dem_means *m;
    double mean, half;

    TAP_OK(dem_means_create(&m, 1) == DEM_OK, "means of the public interface");
    for (int k = 0; k < 4; k++)
    {
        dem_means_add(m, k < 3 ? &(double){0.0} : &(double){8.0}, k < 3 ? 1.0 : 5.0);
    }
    TAP_OK(dem_means_get(m, &mean, &half) == 4, "four blocks of one sample");
    TAP_NEAR(mean, 5.0, 1e-14, "the mean counts weights");
    TAP_NEAR(half, 3.182*30.0/7.0, 1e-12, "and so does the interval");
    dem_means_free(m);
}

int main(void)
{
    TAP_TRAPS;
    means();
    weights();
    intervals();
    ratios();
    TAP_DONE;
}
