/*
 * main_scene.c -- the command line of the commands that take a scene, and the scene that it names.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_scene.h"
#include "base/error.h"
#include "base/unknown.h"
#include "io/dictionary.h"
#include <stdio.h>
#include <string.h>

static struct dem_option *find_option(const struct dem_request *r, const char *word)
{
    for (int k = 0; k < r->options; k++)
    {
        if (strcmp(r->option[k].name, word) == 0)
        {
            return &r->option[k];
        }
    }
    return NULL;
}

static int refuse_option(const struct dem_request *r, const char *command, const char *word)
{
    const char *known[DEM_MOST_OPTIONS + 3] = {"-restart", "-set", "-help"};

    for (int k = 0; k < r->options; k++)
    {
        known[3 + k] = r->option[k].name;
    }
    for (int k = 0; k < 3 + r->options; k++)
    {
        DEM_REQUIRE(strcmp(word, known[k]) != 0, DEM_ERROR_INPUT, "%s lacks its value%s; dem %s -help tells how", word,
                    strcmp(word, "-set") == 0 ? "s" : "", command);
    }
    return dem_unknown_word("option", word, known, 3 + r->options);
}

int dem_request_read(struct dem_request *r, const char *command, int argc, char **argv)
{
    for (int k = 0; k < argc; k++)
    {
        struct dem_option *const own = find_option(r, argv[k]);

        if (strcmp(argv[k], "-help") == 0)
        {
            r->help = 1;
        }
        else if (own && (own->flag || k + 1 < argc))
        {
            own->given = own->flag ? "" : argv[++k];
        }
        else if (strcmp(argv[k], "-restart") == 0 && k + 1 < argc)
        {
            r->restart = argv[++k];
        }
        else if (strcmp(argv[k], "-set") == 0 && k + 2 < argc && r->sets < DEM_MOST_SETS)
        {
            r->set[r->sets][0] = argv[++k];
            r->set[r->sets++][1] = argv[++k];
        }
        else if (argv[k][0] == '-')
        {
            return refuse_option(r, command, argv[k]);
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

static const double
    most_steps = 0x1p53,                                  /* whole numbers that a double tells apart */
    most_outputs = 1e6,                                   /* files are numbered up to 999999 */
    most_rows = 1e9;                                      /* more are a slip of the pen */

/* s between the rows of a table; 0 when it is not asked for */
static int read_rows(const struct dem_dict *write, const char *entry, double end, double *interval)
{
    *interval = 0.0;
    if (dem_dict_has(write, entry))
    {
        DEM_TRY(dem_dict_number(write, entry, "s", interval));
        DEM_REQUIRE(*interval > 0.0, DEM_ERROR_INPUT, "write/%s %g s; give a time above 0, or leave it out", entry, *interval);
        DEM_REQUIRE(end <= most_rows**interval, DEM_ERROR_INPUT, "write/%s %g s makes more than %g rows up to time/end %g s; give %g s or more",
                    entry, *interval, most_rows, end, end/most_rows);
    }
    return DEM_OK;
}

/* Energy from nowhere is seen in the ledger's rows. */
static int read_most_created(const struct dem_dict *time, struct dem_output *o)
{
    if (dem_dict_has(time, "maxCreated"))
    {
        DEM_TRY(dem_dict_number(time, "maxCreated", "1", &o->most_created));
        DEM_REQUIRE(o->most_created > 0.0, DEM_ERROR_INPUT, "time/maxCreated %g; give a share above 0, or leave it out", o->most_created);
        DEM_REQUIRE(o->energy > 0.0, DEM_ERROR_INPUT, "time/maxCreated %g is looked at in each row of the ledger of energy, and there are "
                    "none; add write/energy, a time between rows", o->most_created);
    }
    return DEM_OK;
}

static int read_schedule(struct dem_schedule *s, const struct dem_dict *scene, const char *path)
{
    const struct dem_dict *time, *write;

    DEM_TRY(dem_dict_sub(scene, "time", &time));
    DEM_TRY(dem_dict_number(time, "end", "s", &s->end));
    DEM_REQUIRE(s->end > 0.0, DEM_ERROR_INPUT, "time/end %g s; give a time above 0", s->end);
    DEM_TRY(dem_quiet_read(&s->quiet, time));
    DEM_TRY(dem_dict_sub_if(scene, "write", &write));
    s->interval = s->end;
    if (write)
    {
        DEM_TRY(dem_dict_number_or(write, "interval", "s", s->end, &s->interval));
        DEM_TRY(read_rows(write, "walls", s->end, &s->output.walls));
        DEM_TRY(read_rows(write, "energy", s->end, &s->output.energy));
    }
    DEM_TRY(read_most_created(time, &s->output));
    DEM_REQUIRE(s->interval > 0.0, DEM_ERROR_INPUT, "write/interval %g s; give a time above 0", s->interval);
    DEM_REQUIRE(s->end <= most_outputs*s->interval, DEM_ERROR_INPUT, "write/interval %g s makes more than %g outputs up to time/end %g s; "
                "give an interval of %g s or more", s->interval, most_outputs, s->end, s->end/most_outputs);
    DEM_REQUIRE(!s->quiet.wanted || s->end <= most_rows*s->quiet.lasting, DEM_ERROR_INPUT, "time/untilQuiet/lasting %g s makes more than %g "
                "looks up to time/end %g s; give %g s or more", s->quiet.lasting, most_rows, s->end, s->end/most_rows);
    return dem_output_read(&s->output, write, path);
}

/* The core has checked its words. */
static int read_gravity(struct dem_schedule *s, const struct dem_dict *scene)
{
    const struct dem_dict *effects, *gravity = NULL;

    DEM_TRY(dem_dict_sub_if(scene, "effects", &effects));
    if (effects)
    {
        DEM_TRY(dem_dict_sub_if(effects, "gravity", &gravity));
    }
    s->with_gravity = gravity != NULL;
    return gravity ? dem_dict_vector(gravity, "acceleration", "m/s2", s->gravity) : DEM_OK;
}

static int count_steps(const struct dem_schedule *s, const struct dem *d)
{
    const double step = dem_step_limit(d).used;

    DEM_REQUIRE(s->end < most_steps*step, DEM_ERROR_INPUT, "time/end %g s at steps of %g s is more than %g steps; give a longer time/step or "
                "an earlier end", s->end, step, most_steps);
    return DEM_OK;
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

/* A scene may serve both: what is OpenFOAM's alone is left unread, and told. */
static int leave_to_openfoam(const struct dem_dict *scene, int *there)
{
    const struct dem_dict *coupling;

    DEM_TRY(dem_dict_sub_if(scene, "coupling", &coupling));
    *there = coupling != NULL;
    if (coupling)
    {
        dem_dict_accept(coupling);
    }
    return DEM_OK;
}

static int make_ready(const struct dem_program *prog, const struct dem_request *r, struct dem *d, struct dem_schedule *s)
{
    DEM_TRY(dem_scene_file(d, r->scene));
    for (int k = 0; k < r->sets; k++)
    {
        DEM_TRY(dem_set(d, r->set[k][0], r->set[k][1]));
    }
    DEM_TRY(r->without ? dem_leave_out(d, r->without) : DEM_OK);
    if (r->restart)
    {
        DEM_TRY(dem_load(d, r->restart));
    }
    DEM_TRY(read_schedule(s, dem_scene_dict(d), r->scene));
    DEM_TRY(r->bare ? DEM_OK : dem_output_check(&s->output, prog));
    DEM_TRY(leave_to_openfoam(dem_scene_dict(d), &s->coupling));
    DEM_TRY(s->output.energy > 0.0 && !r->bare ? dem_energy_watch(d) : DEM_OK);
    DEM_TRY(s->output.profile && !r->bare ? dem_contacts_watch(d) : DEM_OK);
    DEM_TRY(s->output.orientation ? dem_orientation_watch(d) : DEM_OK);
    DEM_TRY(dem_check(d));
    DEM_TRY(read_gravity(s, dem_scene_dict(d)));
    DEM_TRY(dem_quiet_check(&s->quiet, s->gravity));
    DEM_TRY(need_no_solver(d));
    /* with a snapshot the step is known when that has been read */
    DEM_TRY(dem_step_limit(d).used > 0.0 ? count_steps(s, d) : DEM_OK);
    DEM_TRY(dem_ready(d));
    DEM_TRY(check_end(s, d));
    return count_steps(s, d);
}

int dem_scene_open(const struct dem_program *prog, const struct dem_request *r, struct dem **made, struct dem_schedule *s)
{
    struct dem *d;

    *made = NULL;
    *s = (struct dem_schedule){.end = 0.0};
    DEM_TRY(dem_create(&d, prog->comm));
    const int status = make_ready(prog, r, d, s);

    if (status)
    {
        dem_free(d);
        return status;
    }
    *made = d;
    return DEM_OK;
}

int dem_scene_serve(struct dem_program *prog, const struct dem_command *c, int argc, char **argv)
{
    struct dem_request r = {.scene = NULL};
    struct dem_schedule s;
    struct dem *d;

    DEM_TRY(dem_request_read(&r, c->name, argc, argv));
    if (r.help)
    {
        if (prog->rank == 0)
        {
            fputs(c->help, stdout);
        }
        return DEM_OK;
    }
    DEM_TRY(dem_scene_open(prog, &r, &d, &s));
    const int status = c->serve(prog, d, &s);

    dem_free(d);
    return status;
}
