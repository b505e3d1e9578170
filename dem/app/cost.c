/*
 * cost.c -- `dem cost SCENE`: run a window of the scene over refinement series and report errors
 * and processor time of each level.
 *
 * The runs are made one after the other in this process, each from a fresh start of the scene; they
 * write no files.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* mkdir */
#include "app/cost.h"
#include "core/memory.h"
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static const char help[] =
    "Usage: dem cost [OPTION VALUE] ... [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE\n\n"
    "Accuracy against cost: runs a window of the scene in refinement series of the time step,\n"
    "the contact stiffness and the precision, and reports for each level the errors of mean\n"
    "quantities and the processor time; then, in one sentence, the best buy. The only output is\n"
    "the folder named at the end: cost.csv, cost.png and cost.svg (these need python3 with\n"
    "matplotlib).\n\n"
    "    -window T          s of simulated time; default: time/end, or what the budget allows\n"
    "    -restart SNAPSHOT  the window begins at a snapshot and not at the scene's start:\n"
    "                       settle a bed first, then run this\n"
    "    -budget S          s of processor time for all runs together; default 60\n"
    "    -runs N            runs of each level, with steps up to 4 % longer and shorter;\n"
    "                       default 5, 3 to 32\n"
    "    -target E          error that the best buy must not exceed; default 0.01\n"
    "    -of LIST           quantities, separated by commas: kinetic, rotation, height, overlap,\n"
    "                       force, contacts, restitution; default: all that the scene has\n"
    "    -series LIST       series, separated by commas: step, stiffness, precision, friction\n"
    "                       (its three laws); default: all. -ladders is accepted too\n"
    "    -effects           instead: the scene with each effect left out, the change of results\n"
    "                       and the time saved\n"
    "    -steps LIST        levels, as multiples of the scene's step; default 2,1,0.5,0.25,0.125\n"
    "    -stiffnesses LIST  levels, as multiples of all Young's moduli;\n"
    "                       default 0.0625,0.25,1,4,16\n"
    "    -folder NAME       default: the scene's name without its extension, and .cost\n\n"
    "For an OpenFOAM case: demCost -help. It makes the runs and calls\n"
    "    dem cost -judge TABLE FOLDER      errors, times and the best buy of a table of runs\n"
    "                                      (cost_table.c has its format)\n"
    "    dem cost -record FILE GX GY GZ    height, level and kinetic energy from a record of\n"
    "                                      particles, with this gravity\n";

/* ---- the scene as it is ---------------------------------------------------------------------- */

/* Leave out a quantity that the scene does not have, or refuse it if it was asked for by name. */
static int require_quantity(struct dem_cost *c, int quantity, int has, const char *reason)
{
    DEM_REQUIRE(has || !c->wanted[quantity] || !c->request.option[DEM_COST_OPTION_QUANTITIES].given,
                DEM_ERROR_INPUT, "-of %s: %s; leave it out", c->quantity[quantity].name, reason);
    c->wanted[quantity] = c->wanted[quantity] && has;
    return DEM_OK;
}

static int choose_quantities(struct dem_cost *c, const struct dem *d)
{
    DEM_TRY(require_quantity(c, DEM_COST_HEIGHT,
                             c->up[0] != 0.0 || c->up[1] != 0.0 || c->up[2] != 0.0,
                             "the scene has no gravity, so no height"));
    DEM_TRY(require_quantity(c, DEM_COST_FORCE, dem_wall_count(d) > 0, "the scene has no walls"));
    DEM_TRY(require_quantity(c, DEM_COST_RESTITUTION, c->impact.bodies > 0,
                             "for two bodies in head-on impact without other forces, on one rank"));
    return require_quantity(c, DEM_COST_CONTACTS, c->particles > 2,
                            "for scenes of more than two particles");
}

static int read_scene(struct dem_cost *c, struct dem *d, const struct dem_schedule *s)
{
    const double g = sqrt(s->gravity[0]*s->gravity[0] + s->gravity[1]*s->gravity[1]
                          + s->gravity[2]*s->gravity[2]);
    struct dem_totals t;

    DEM_TRY(dem_totals(d, &t));
    DEM_REQUIRE(t.particles > 0, DEM_ERROR_INPUT,
                "the scene has no particles at its start; begin with -restart from a snapshot that "
                "has some");
    for (int k = 0; k < 3; k++)
    {
        c->up[k] = g > 0.0 ? -s->gravity[k]/g : 0.0;
    }
    c->from_snapshot = c->request.restart || dem_dict_has(dem_scene_dict(d), "start");
    DEM_REQUIRE(!c->from_snapshot || !c->request.option[DEM_COST_OPTION_SERIES].given
                    || !c->selection.series[1],
                DEM_ERROR_INPUT,
                "-series stiffness from a snapshot, whose overlaps belong to its own stiffness: "
                "with another one the bed would expand or sink; leave it out, or begin at the "
                "scene's start");
    c->start = t.time;
    c->end = s->end;
    c->step = dem_step_limit(d).used;
    c->limit = dem_step_limit(d).limit;
    c->fall = t.fall_energy;
    c->mass = t.mass;
    c->particles = t.particles;
    c->diameter = cbrt(6.0*t.volume/(3.14159265358979324*(double)t.particles));
    DEM_REQUIRE(c->end > c->start, DEM_ERROR_INPUT,
                "the snapshot is of %g s, not before time/end %g s; give a later end", c->start,
                c->end);
    DEM_REQUIRE(c->window <= (c->end - c->start)*(1.0 + 1e-12), DEM_ERROR_INPUT,
                "-window %g s is longer than the %g s to time/end; give at most that, or a later "
                "end with -set time/end",
                c->window, c->end - c->start);
    dem_cost_find_impact(c, d);
    DEM_TRY(choose_quantities(c, d));
    dem_cost_closed_forms(c, d);
    snprintf(c->acting, sizeof c->acting, "%s", dem_effect_names(d));
    DEM_TRY(dem_cost_find_friction(c, dem_scene_dict(d)));
    return dem_cost_find_moduli(c, dem_scene_dict(d));
}

/* ---- the window ------------------------------------------------------------------------------ */

/* of the coarsest level: in the window, between two samples */
static const double min_steps = 10.0, sample_steps = 40.0;

/* Processor time of a step, from the first `steps` of the window; the same on all ranks. */
static int pilot(struct dem_cost *c, double steps, double *second)
{
    struct dem_cost_run run;
    const struct dem_cost_variation k = {.steps = (int64_t)ceil(steps), .stiffness_factor = 1.0};

    c->samples = 1;
    c->window = (double)k.steps*c->step;
    DEM_TRY(dem_cost_run(c, &k, &run));
    *second = run.seconds/(double)k.steps;
    if (c->prog->comm != MPI_COMM_NULL)
    {
        MPI_Bcast(second, 1, MPI_DOUBLE, 0, c->prog->comm);
    }
    return DEM_OK;
}

/* The window that the budget allows. Later steps may cost more than the first ones (a bed forms),
   so repeat with the result. */
static int affordable_window(struct dem_cost *c, double span, double *window)
{
    double steps = fmin(200.0, span/c->step), second;

    for (int k = 0; k < 3; k++)
    {
        DEM_TRY(pilot(c, steps, &second));
        const double affordable = fmin(span/c->step, c->budget/dem_cost_relative(c)/second);

        if (k > 0 && affordable >= 0.8*steps)
        {
            break;
        }
        steps = affordable;
    }
    *window = fmin(span, steps*c->step);
    return DEM_OK;
}

static int choose_window(struct dem_cost *c)
{
    const double span = c->end - c->start;
    const double coarsest = fmax(1.0, c->selection.series[0] ? c->selection.steps[0] : 1.0);
    double window = c->window;

    DEM_TRY(window > 0.0 ? DEM_OK : affordable_window(c, span, &window));
    const double steps = window/c->step/coarsest;

    c->window = window;
    DEM_REQUIRE(steps >= min_steps, DEM_ERROR_INPUT,
                "a window of %.3g s has only %.3g steps of the coarsest level; give a longer "
                "-window, a larger -budget, or finer levels",
                window, steps);
    c->samples = c->impact.bodies > 0
                   ? 1
                   : (int)fmax(1.0, fmin(DEM_COST_MAX_SAMPLES, floor(steps/sample_steps)));
    return DEM_OK;
}

/* ---- the command ----------------------------------------------------------------------------- */

static int make_folder(const struct dem_cost *c)
{
    errno = 0;
    DEM_REQUIRE(c->prog->rank != 0 || mkdir(c->folder, 0777) == 0 || errno == EEXIST,
                DEM_ERROR_FILE, "cannot make the folder %s: %s; give another -folder", c->folder,
                strerror(errno));
    return DEM_OK;
}

static int cost_of_scene(struct dem_cost *c)
{
    struct dem_schedule s;
    struct dem *d;

    DEM_TRY(dem_scene_open(c->prog, &c->request, &d, &s));
    const int status = read_scene(c, d, &s);

    dem_free(d);
    DEM_TRY(status);
    DEM_TRY(choose_window(c));
    DEM_TRY(dem_program_agree(c->prog, make_folder(c)));
    DEM_TRY(dem_cost_run_series(c));
    dem_cost_find_errors(c);
    if (c->prog->rank == 0)
    {
        dem_cost_report(c);
    }
    return dem_program_agree(c->prog, c->prog->rank == 0 ? dem_cost_write(c) : DEM_OK);
}

/* A scene is run on all ranks; a table or a record is read by the first rank alone. */
static int dispatch(struct dem_cost *c, int argc, char **argv)
{
    struct dem_option option[DEM_COST_OPTIONS];

    if (argc > 0 && strcmp(argv[0], "-judge") == 0)
    {
        return c->prog->rank == 0 ? dem_cost_report_table(c, argc, argv) : DEM_OK;
    }
    if (argc > 0 && strcmp(argv[0], "-record") == 0)
    {
        return c->prog->rank == 0 ? dem_cost_report_record(argc, argv) : DEM_OK;
    }
    dem_cost_options(option);
    dem_cost_scene_quantities(c);
    c->request =
        (struct dem_request){.option = option, .options = DEM_COST_OPTIONS, .no_output = 1};
    DEM_TRY(dem_request_read(&c->request, "cost", argc, argv));
    if (c->request.help)
    {
        fputs(c->prog->rank == 0 ? help : "", stdout);
        return DEM_OK;
    }
    DEM_TRY(dem_cost_read_options(c));
    return cost_of_scene(c);
}

int dem_main_cost(struct dem_program *prog, int argc, char **argv)
{
    struct dem_cost *c;

    DEM_TRY(DEM_NEW(c, 1));
    c->prog = prog;
    const int status = dispatch(c, argc, argv);

    dem_memory_free(c);
    return status;
}
