/*
 * accuracy.c -- the entry `accuracy` of a scene: read it, start the search, print whether the run
 * meets the target.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/accuracy.h"
#include "app/main.h"
#include "app/scene_options.h"
#include "core/error.h"
#include "core/memory.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int read_found(struct dem_accuracy *a, const struct dem_dict *dict)
{
    const char *of;

    DEM_TRY(dem_dict_number(dict, "reached", "1", &a->reached));
    DEM_TRY(dem_dict_number(dict, "window", "s", &a->window));
    DEM_TRY(dem_dict_number(dict, "step", "s", &a->step));
    DEM_TRY(dem_dict_word(dict, "of", &of));
    snprintf(a->of, sizeof a->of, "%s", of);
    DEM_REQUIRE(a->reached > 0.0 && a->window > 0.0 && a->step > 0.0, DEM_ERROR_INPUT,
                "accuracy has reached %g, window %g s, step %g s; leave the three out, and the search "
                "is made again", a->reached, a->window, a->step);
    return DEM_OK;
}

int dem_accuracy_read(struct dem_accuracy *a, const struct dem_dict *scene)
{
    const struct dem_dict *dict;

    *a = (struct dem_accuracy){.target = 0.0};
    DEM_TRY(dem_dict_sub_if(scene, "accuracy", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_number(dict, "target", "1", &a->target));
    DEM_TRY(dem_dict_number_or(dict, "budget", "s", 60.0, &a->budget));
    DEM_REQUIRE(a->target >= 1e-12 && a->target <= 1.0, DEM_ERROR_INPUT,
                "accuracy/target %g; give a relative error from 1e-12 to 1", a->target);
    DEM_REQUIRE(a->budget >= 0.1, DEM_ERROR_INPUT,
                "accuracy/budget %g s; give 0.1 s or more of processor time", a->budget);
    return dem_dict_has(dict, "reached") ? read_found(a, dict) : DEM_OK;
}

int dem_accuracy_search(const struct dem_accuracy *a, const struct dem_program *prog,
                        const struct dem_request *r)
{
    char target[32], budget[32];
    char **words;
    int n = 0;

    if (a->target == 0.0 || a->reached > 0.0)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(prog->ranks == 1, DEM_ERROR_INPUT, "accuracy/target %g is searched on one rank; make "
                "the scene with `dem cost -target %g %s` and run what it writes", a->target, a->target,
                r->scene);
    snprintf(target, sizeof target, "%.9g", a->target);
    snprintf(budget, sizeof budget, "%.9g", a->budget);
    DEM_TRY(DEM_NEW(words, 3*r->sets + 8));
    words[n++] = "-run";
    words[n++] = "-target";
    words[n++] = target;
    words[n++] = "-budget";
    words[n++] = budget;
    for (int k = 0; k < r->sets; k++)
    {
        words[n++] = "-set";
        words[n++] = (char *)r->set[k][0];
        words[n++] = (char *)r->set[k][1];
    }
    if (r->restart)
    {
        words[n++] = "-restart";
        words[n++] = (char *)r->restart;
    }
    words[n++] = (char *)r->scene;
    printf("accuracy: searching the step for errors within %g %%\n", 100.0*a->target);
    fflush(stdout);
    MPI_Finalize();
    const int status = dem_main_python("cost", n, words);

    fprintf(stderr, "dem: %s\n", dem_error_text());
    _Exit(status);
}

void dem_accuracy_print(const struct dem_accuracy *a, double step)
{
    if (a->target == 0.0)
    {
        return;
    }
    printf("accuracy: target %g %%, ", 100.0*a->target);
    if (step > a->step*(1.0 + 1e-6))
    {
        printf("NOT met: the step is %.4g s, the step of the search was %.4g s\n", step, a->step);
        return;
    }
    printf("%s: %s, the worst quantity, is within %.3g %% over the %g s of the search\n",
           a->reached <= a->target ? "met" : "NOT met", a->of, 100.0*a->reached, a->window);
}
