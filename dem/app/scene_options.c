/*
 * scene_options.c -- read the command line of a command that takes a scene, and set up that scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/scene_options.h"
#include "dem_fluid.h"
#include "core/error.h"
#include "core/did_you_mean.h"
#include "input/dictionary.h"
#include <stdio.h>
#include <string.h>

/* A word that begins with - and was not read: its value is missing, or it is unknown. */
static int refuse_option(const char *command, const char *word)
{
    const char *const known[] = {"-restart", "-device", "-set", "-help"};

    DEM_REQUIRE(strcmp(word, "-restart") != 0 && strcmp(word, "-device") != 0 &&
                    strcmp(word, "-set") != 0,
                DEM_ERROR_INPUT,
                "%s lacks its value%s; see dem %s -help", word,
                strcmp(word, "-set") == 0 ? "s" : "", command);
    return dem_did_you_mean_error("option", word, known, 4);
}

static int read_request(struct dem_request *r, const char *command, int argc, char **argv)
{
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
        else if (strcmp(argv[k], "-device") == 0 && k + 1 < argc)
        {
            r->device = argv[++k];
        }
        else if (strcmp(argv[k], "-set") == 0 && k + 1 < argc && strchr(argv[k + 1], '=')
                 && r->sets < DEM_MAX_SETS)
        {
            char *const equals = strchr(argv[++k], '=');

            *equals = 0;  /* paths have no = */
            r->set[r->sets][0] = argv[k];
            r->set[r->sets++][1] = equals + 1;
        }
        else if (strcmp(argv[k], "-set") == 0 && k + 2 < argc && r->sets < DEM_MAX_SETS)
        {
            r->set[r->sets][0] = argv[++k];
            r->set[r->sets++][1] = argv[++k];
        }
        else if (argv[k][0] == '-')
        {
            return refuse_option(command, argv[k]);
        }
        else
        {
            DEM_REQUIRE(!r->scene, DEM_ERROR_INPUT, "two scenes, %s and %s; %s one", r->scene,
                        argv[k], command);
            r->scene = argv[k];
        }
    }
    r->lists_devices = r->device && strcmp(r->device, "list") == 0;
    DEM_REQUIRE(r->scene || r->help || r->lists_devices, DEM_ERROR_INPUT,
                "no scene; see dem %s -help", command);
    return DEM_OK;
}

static const double
    max_steps = 0x1p53,  /* larger whole numbers are not exact in a double */
    max_outputs = 1e6,   /* files are numbered up to 999999 */
    max_rows = 1e9;      /* more are an error of input */

/* The time between the rows of a table [s]; 0 when the entry is missing. */
static int read_rows(const struct dem_dict *write, const char *entry, double end, double *interval)
{
    *interval = 0.0;
    if (dem_dict_has(write, entry))
    {
        DEM_TRY(dem_dict_number(write, entry, "s", interval));
        DEM_REQUIRE(*interval > 0.0, DEM_ERROR_INPUT,
                    "write/%s %g s; give a time above 0, or leave it out", entry, *interval);
        DEM_REQUIRE(end <= max_rows**interval, DEM_ERROR_INPUT, "write/%s %g s makes more than %g "
                    "rows up to time/end %g s; give %g s or more",
                    entry, *interval, max_rows, end, end/max_rows);
    }
    return DEM_OK;
}

/* Created energy is found in the rows of the energy balance. */
static int read_max_created(const struct dem_dict *time, struct dem_output *o)
{
    if (dem_dict_has(time, "maxCreated"))
    {
        DEM_TRY(dem_dict_number(time, "maxCreated", "1", &o->max_created));
        DEM_REQUIRE(o->max_created > 0.0, DEM_ERROR_INPUT, "time/maxCreated %g; give a fraction "
                    "above 0, or leave it out", o->max_created);
        DEM_REQUIRE(o->energy > 0.0, DEM_ERROR_INPUT, "time/maxCreated %g is checked in each row "
                    "of the energy balance, and there are none; add write/energy, the time between "
                    "rows", o->max_created);
    }
    return DEM_OK;
}

static int read_schedule(struct dem_schedule *s, const struct dem_case *c, const char *path)
{
    const struct dem_dict *const scene = dem_case_dict(c), *time, *write;

    DEM_TRY(dem_dict_sub(scene, "time", &time));
    DEM_TRY(dem_dict_number(time, "end", "s", &s->end));
    DEM_REQUIRE(s->end > 0.0, DEM_ERROR_INPUT, "time/end %g s; give a time above 0", s->end);
    DEM_TRY(dem_case_read_quiet(c, &s->quiet));
    DEM_TRY(dem_dict_sub_if(scene, "write", &write));
    s->interval = s->end;
    if (write)
    {
        DEM_TRY(dem_dict_number_or(write, "interval", "s", s->end, &s->interval));
        DEM_TRY(read_rows(write, "walls", s->end, &s->output.walls));
        DEM_TRY(read_rows(write, "cell", s->end, &s->output.cell));
        DEM_TRY(read_rows(write, "energy", s->end, &s->output.energy));
    }
    DEM_TRY(read_max_created(time, &s->output));
    DEM_REQUIRE(s->interval > 0.0, DEM_ERROR_INPUT, "write/interval %g s; give a time above 0",
                s->interval);
    DEM_REQUIRE(s->end <= max_outputs*s->interval, DEM_ERROR_INPUT, "write/interval %g s makes "
                "more than %g outputs up to time/end %g s; give an interval of %g s or more",
                s->interval, max_outputs, s->end,
                s->end/max_outputs);
    DEM_REQUIRE(!s->quiet.wanted || s->quiet.lasting == 0.0 ||
                    s->end <= max_rows*s->quiet.lasting,
                DEM_ERROR_INPUT,
                "time/untilQuiet/lasting %g s makes more than %g checks up to time/end %g s; give "
                "%g s or more",
                s->quiet.lasting, max_rows, s->end, s->end/max_rows);
    return dem_output_read(&s->output, write, path);
}

static int count_steps(const struct dem_schedule *s, const struct dem *d)
{
    const double step = dem_step_limit(d).used;

    DEM_REQUIRE(s->end < max_steps*step, DEM_ERROR_INPUT,
                "time/end %g s at steps of %g s is more than %g steps; give a longer time/step or "
                "an earlier end",
                s->end, step, max_steps);
    return DEM_OK;
}

/* Time continues from a snapshot: an end before that time leaves nothing to run. */
static int check_end(const struct dem_schedule *s, struct dem *d)
{
    struct dem_totals t;

    DEM_TRY(dem_totals(d, &t));
    DEM_REQUIRE(s->end >= t.time*(1.0 - 1e-12), DEM_ERROR_INPUT,
                "time/end %.6g s is before the time of the snapshot, %.6g s, from which the run "
                "continues; give a later end", s->end, t.time);
    return DEM_OK;
}

/* Names of devices have blanks: a text in quotes. */
static int set_device(const struct dem_request *r, struct dem_case *c)
{
    char text[256];

    DEM_REQUIRE(!r->device || (strlen(r->device) < 200 && !strchr(r->device, '"')), DEM_ERROR_INPUT,
                "-device %.200s: give gpu, or a part of a name of dem run -device list",
                r->device);
    if (!r->device)
    {
        return DEM_OK;
    }
    snprintf(text, sizeof text, "\"%s\"", r->device);
    return dem_case_set(c, "device", text);
}

/* Each rank reads the scene and the options by itself. */
static int read_scene(const struct dem_request *r, struct dem_case *c, struct dem_schedule *s)
{
    DEM_TRY(dem_case_scene_file(c, r->scene));
    for (int k = 0; k < r->sets; k++)
    {
        DEM_TRY(dem_case_set(c, r->set[k][0], r->set[k][1]));
    }
    DEM_TRY(set_device(r, c));
    if (r->restart)
    {
        DEM_TRY(dem_case_load(c, r->restart));
    }
    DEM_TRY(read_schedule(s, c, r->scene));
    DEM_TRY(dem_accuracy_read(&s->accuracy, dem_case_dict(c)));
    s->coupling = dem_dict_has(dem_case_dict(c), "coupling");
    DEM_TRY(s->output.energy > 0.0 ? dem_case_enable_energy(c) : DEM_OK);
    return s->output.orientation ? dem_case_enable_orientation(c) : DEM_OK;
}

/* Before particles are placed, which may take long. */
static int check(const struct dem_program *prog, const struct dem_request *r, struct dem_case *c,
                 struct dem_schedule *s)
{
    DEM_TRY(dem_program_agree(prog, read_scene(r, c, s)));
    DEM_TRY(dem_output_check(&s->output, prog, r->scene));
    DEM_TRY(dem_case_check(c));
    const struct dem *const checked = dem_case_checked(c);

    DEM_REQUIRE(s->output.cell == 0.0 || dem_has_cell(checked), DEM_ERROR_INPUT,
                "write/cell, but the domain has no cell that deforms; add domain/cell, or leave it out");
    s->with_gravity = dem_gravity_acceleration(checked, s->gravity);
    DEM_TRY(dem_quiet_check(checked, &s->quiet));
    DEM_TRY(dem_require_fluid(checked));
    /* with a snapshot the step is known only after dem_start */
    return dem_step_limit(checked).used > 0.0 ? count_steps(s, checked) : DEM_OK;
}

/* Read, check and start the scene of a command line. The caller frees the run, also after an error;
   NULL where it has not started. */
static int start(const struct dem_program *prog, const struct dem_request *r, struct dem **d,
                 struct dem_schedule *s)
{
    struct dem_case *c;

    *s = (struct dem_schedule){.request = r};
    DEM_TRY(dem_case_create(&c, prog->comm));
    const int status = check(prog, r, c, s);

    if (status)
    {
        dem_case_free(c);
        return status;
    }
    DEM_TRY(dem_start(&c, d));
    DEM_TRY(check_end(s, *d));
    return count_steps(s, *d);
}

int dem_command_run(struct dem_program *prog, const struct dem_command *c, int argc, char **argv)
{
    struct dem_request r = {.scene = NULL};
    struct dem_schedule s;
    struct dem *d = NULL;

    DEM_TRY(read_request(&r, c->name, argc, argv));
    if (r.help || r.lists_devices)
    {
        if (prog->rank == 0)
        {
            fputs(r.help ? c->help : dem_devices_text(), stdout);
        }
        return DEM_OK;
    }
    int status = start(prog, &r, &d, &s);

    status = status ? status : c->run(prog, d, &s);
    dem_free(d);
    return status;
}
