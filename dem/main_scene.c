/*
 * main_scene.c -- the command line of `dem run` and `dem plan`, and the scene that it names.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_scene.h"
#include "base/error.h"
#include "base/unknown.h"
#include "io/dictionary.h"
#include <stdio.h>
#include <string.h>

struct request                                            /* the command line */
{
    const char *scene, *restart;
    const char *set[64][2];
    int sets, help;
};

static int read_arguments(struct request *r, const char *command, int argc, char **argv)
{
    static const char *const known[] = {"-restart", "-set", "-help"};

    for (int k = 0; k < argc; k++)
    {
        if (strcmp(argv[k], "-help") == 0)
        {
            r->help = 1;
        }
        else if (strcmp(argv[k], "-restart") == 0 && k + 1 < argc)
        {
            r->restart = argv[++k];
        }
        else if (strcmp(argv[k], "-set") == 0 && k + 2 < argc && r->sets < 64)
        {
            r->set[r->sets][0] = argv[++k];
            r->set[r->sets++][1] = argv[++k];
        }
        else if (strcmp(argv[k], "-restart") == 0 || strcmp(argv[k], "-set") == 0)
        {
            return dem_error(DEM_ERROR_INPUT, "%s lacks its value%s; dem %s -help tells how", argv[k], argv[k][1] == 's' ? "s" : "",
                             command);
        }
        else if (argv[k][0] == '-')
        {
            return dem_unknown_word("option", argv[k], known, 3);
        }
        else
        {
            DEM_REQUIRE(!r->scene, DEM_ERROR_INPUT, "two scenes, %s and %s; %s one", r->scene, argv[k], command);
            r->scene = argv[k];
        }
    }
    DEM_REQUIRE(r->scene || r->help, DEM_ERROR_INPUT, "no scene; dem %s -help tells how", command);
    return DEM_OK;
}

/* s between the rows of a table; 0 when it is not asked for */
static int read_rows(const struct dem_dict *write, const char *entry, double *interval)
{
    *interval = 0.0;
    if (dem_dict_has(write, entry))
    {
        DEM_TRY(dem_dict_number(write, entry, "s", interval));
        DEM_REQUIRE(*interval > 0.0, DEM_ERROR_INPUT, "write/%s %g s; give a time above 0, or leave it out", entry, *interval);
    }
    return DEM_OK;
}

static int read_schedule(struct dem_schedule *s, const struct dem_dict *scene, const char *path)
{
    const struct dem_dict *time, *write;

    DEM_TRY(dem_dict_sub(scene, "time", &time));
    DEM_TRY(dem_dict_number(time, "end", "s", &s->end));
    DEM_TRY(dem_quiet_read(&s->quiet, time));
    DEM_TRY(dem_dict_sub_if(scene, "write", &write));
    s->interval = s->end;
    if (write)
    {
        DEM_TRY(dem_dict_number_or(write, "interval", "s", s->end, &s->interval));
        DEM_TRY(read_rows(write, "walls", &s->output.walls));
        DEM_TRY(read_rows(write, "energy", &s->output.energy));
    }
    DEM_REQUIRE(s->end > 0.0, DEM_ERROR_INPUT, "time/end %g s; give a time above 0", s->end);
    DEM_REQUIRE(s->interval > 0.0, DEM_ERROR_INPUT, "write/interval %g s; give a time above 0", s->interval);
    return dem_output_read(&s->output, write, path);
}

/* No fluid solver will ever come: say so before anything is written. */
static int need_no_solver(struct dem *d)
{
    DEM_REQUIRE(!dem_needs_fluid(d) || dem_dict_has(dem_scene_dict(d), "fluid"), DEM_ERROR_INPUT,
                "an effect of the scene needs a fluid, and there is none; add fluid { density; viscosity; velocity; } or run it "
                "in OpenFOAM");
    return DEM_OK;
}

/* Time goes on from a snapshot, so an end before it would leave nothing to run. */
static int check_end(const struct dem_schedule *s, struct dem *d)
{
    struct dem_tally t;

    DEM_TRY(dem_tally(d, &t));
    DEM_REQUIRE(s->end >= t.time*(1.0 - 1e-12), DEM_ERROR_INPUT,
                "time/end %.6g s is over: time goes on from the snapshot, which is of %.6g s; give a later end", s->end, t.time);
    return DEM_OK;
}

/* The ledger begins with the first forces, before the schedule is read. */
static int watch_energy(struct dem *d)
{
    const struct dem_dict *write;

    DEM_TRY(dem_dict_sub_if(dem_scene_dict(d), "write", &write));
    return write && dem_dict_has(write, "energy") ? dem_energy_watch(d) : DEM_OK;
}

static int open_scene(const struct request *r, struct dem *d, struct dem_schedule *s)
{
    DEM_TRY(dem_scene_file(d, r->scene));
    for (int k = 0; k < r->sets; k++)
    {
        DEM_TRY(dem_set(d, r->set[k][0], r->set[k][1]));
    }
    if (r->restart)
    {
        DEM_TRY(dem_load(d, r->restart));
    }
    DEM_TRY(watch_energy(d));
    DEM_TRY(dem_ready(d));
    DEM_TRY(read_schedule(s, dem_scene_dict(d), r->scene));
    DEM_TRY(dem_scene_check(d));
    DEM_TRY(dem_quiet_check(&s->quiet, d));
    DEM_TRY(check_end(s, d));
    return need_no_solver(d);
}

int dem_scene_serve(struct dem_program *prog, const struct dem_command *c, int argc, char **argv)
{
    struct request r = {.scene = NULL};
    struct dem_schedule s = {.end = 0.0};
    struct dem *d;

    DEM_TRY(read_arguments(&r, c->name, argc, argv));
    if (r.help)
    {
        if (prog->rank == 0)
        {
            fputs(c->help, stdout);
        }
        return DEM_OK;
    }
    DEM_TRY(dem_create(&d, prog->comm));
    int status = open_scene(&r, d, &s);

    status = status ? status : c->serve(prog, d, &s);
    dem_free(d);
    return status;
}
