/*
 * zero.c -- run the steps of a scene under an instruction counter.
 *
 * Prints the fingerprint, the number of steps, the bytes that the core holds and, with `needs`, the
 * bytes that it needs.
 *
 *     valgrind --tool=callgrind --toggle-collect=dem_advance zero SCENE STEPS
 *     zero SCENE STEPS needs
 *
 * Without MPI, so that only the core is counted.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "dem_query.h"
#include "dem_plan.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failed(void)
{
    fprintf(stderr, "%s\n", dem_error_text());
    return EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    struct dem_profile profile;
    struct dem_totals tally;
    const char *plan;
    uint64_t hash;
    struct dem_case *c;
    struct dem *d;

    if (argc < 3)
    {
        return EXIT_FAILURE;
    }
    if (dem_case_create(&c, MPI_COMM_NULL) || dem_case_scene_file(c, argv[1]) || dem_start(&c, &d) ||
        dem_advance(d, atof(argv[2])*dem_step_limit(d).used))
    {
        return failed();
    }
    if (dem_profile(d, &profile) || dem_totals(d, &tally) || dem_hash(d, &hash))
    {
        return failed();
    }
    printf("hash %016" PRIx64 " steps %" PRId64 " particles %" PRId64 " contacts %" PRId64
           " held %.0f\n",
           hash, profile.steps, tally.particles, tally.contacts, profile.bytes);
    if (argc > 3)
    {
        if (dem_plan(d, &(struct dem_run_info){.duration = 0.0}, &plan))
        {
            return failed();
        }
        const char *const memory = strstr(plan, "Memory\n    ");

        printf("needs %.*s\n", (int)strcspn(memory + 11, "\n"), memory + 11);
    }
    dem_free(d);
    return EXIT_SUCCESS;
}
