/*
 * main_plan_write.c -- `dem plan -write`: what the verdicts say goes into the scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_plan.h"
#include "base/error.h"
#include <stdio.h>

struct asked
{
    struct dem_program *prog;
    const struct dem_request *request;
    struct dem *d;                                        /* whose verdicts are looked at */
};

/* The scene of the request, its text in this file; see dem_rewriter. */
static const char *judge(void *self, const char *file, const struct dem_verdict **verdict, int *n)
{
    struct asked *const a = self;
    struct dem_request r = *a->request;
    struct dem_schedule s;
    const char *text;
    struct dem *d;

    r.scene = file;
    r.bare = 1;
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
    if (dem_plan(d, &(struct dem_prospect){.duration = s.end}, &text))
    {
        return dem_error_text();
    }
    *n = dem_verdicts(d, verdict);
    return NULL;
}

static void tell(void *self, const char *lines)
{
    (void)self;
    fputs(lines, stdout);
}

int dem_plan_rewrite(struct dem_program *prog, const struct dem_request *r)
{
    struct asked a = {.prog = prog, .request = r};

    DEM_REQUIRE(prog->ranks == 1, DEM_ERROR_INPUT, "-write on %d ranks; one writes the scene: leave mpirun out", prog->ranks);
    DEM_REQUIRE(r->sets == 0, DEM_ERROR_INPUT, "-write with -set %s, which is not in the scene; write it there first", r->set[0][0]);
    const int status = dem_rewrite(&(struct dem_rewriter){.scene = r->scene, .judge = judge, .tell = tell, .self = &a});

    dem_free(a.d);
    return status;
}
