/*
 * plan_write.c -- `dem plan -write`: put the verdicts on effects into the scene file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/command_plan.h"
#include "core/error.h"
#include <stdio.h>

struct context
{
    struct dem_program *prog;
    const struct dem_request *request;
    struct dem *d;  /* owns the verdicts returned last */
};

/* dem_scene_rewriter.evaluate: check and plan the scene of the command line with the text of this
   file. */
static const char *plan_file(void *self, const char *file, const struct dem_verdict **verdict,
                             int *n)
{
    struct context *const a = self;
    struct dem_request r = *a->request;
    struct dem_schedule s;
    const char *text;
    struct dem *d;

    r.scene = file;
    r.no_output = 1;
    if (dem_scene_open(a->prog, &r, &d, &s))
    {
        return dem_error_text();
    }
    if (!verdict)
    {
        dem_free(d);
        return NULL;
    }
    dem_free(a->d);
    a->d = d;
    if (dem_plan(d, &(struct dem_run_info){.duration = s.end}, &text))
    {
        return dem_error_text();
    }
    *n = dem_verdicts(d, verdict);
    return NULL;
}

static void print(void *self, const char *lines)
{
    (void)self;
    fputs(lines, stdout);
}

int dem_plan_rewrite(struct dem_program *prog, const struct dem_request *r)
{
    struct context a = {.prog = prog, .request = r};

    DEM_REQUIRE(prog->ranks == 1, DEM_ERROR_INPUT, "-write on %d ranks; run it without mpirun",
                prog->ranks);
    DEM_REQUIRE(r->sets == 0, DEM_ERROR_INPUT,
                "-write with -set %s, which is not in the scene; write it there first",
                r->set[0][0]);
    const int status = dem_scene_rewrite(&(struct dem_scene_rewriter){.scene = r->scene,
                                                                      .evaluate = plan_file,
                                                                      .report = print,
                                                                      .self = &a});

    dem_free(a.d);
    return status;
}
