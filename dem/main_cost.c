/*
 * main_cost.c -- `dem cost SCENE`: a window of the scene over ladders of its knobs, each rung with its errors and its time.
 *
 * Runs are made one after the other in this process, from a fresh start of the scene each; they write nothing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* mkdir */
#include "main_cost.h"
#include "base/memory.h"
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static const char help[] =
    "Usage: dem cost [OPTION VALUE] ... [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE\n\n"
    "What accuracy costs in time: runs a window of the scene with other time steps, contact stiffnesses and in mixed precision, and\n"
    "tells of each rung the error of what users mean, and its processor time; last, in a sentence, the best buy. Nothing is\n"
    "written but the folder that is named in the end: cost.csv, cost.png and cost.svg (python3 with matplotlib).\n\n"
    "    -window T          s of simulated time; default: time/end, or what the budget allows\n"
    "    -restart SNAPSHOT  the window begins there, and not at the scene's start: settle a bed first, then ask\n"
    "    -budget S          s of processor time for all runs together; default 60\n"
    "    -runs N            of a rung, with steps up to 4 % longer and shorter; default 5, 3 to 32\n"
    "    -target E          the error to be bought; default 0.01\n"
    "    -of LIST           quantities, with commas: kinetic, rotation, height, overlap, force, contacts, restitution; default all it has\n"
    "    -ladders LIST      step, stiffness, precision, friction (its three laws); default all\n"
    "    -effects           instead: the scene with each effect left out, what that changes and what it saves\n"
    "    -steps LIST        rungs, as shares of the scene's step; default 2,1,0.5,0.25,0.125\n"
    "    -stiffnesses LIST  rungs, as multiples of all Young's moduli; default 0.0625,0.25,1,4,16\n"
    "    -folder NAME       default: the scene's name without its ending, and .cost\n\n"
    "Of an OpenFOAM case: demCost -help. It makes the runs and asks here:\n"
    "    dem cost -judge TABLE FOLDER      errors, times and the best buy of a table of runs (main_cost_table.c says what is in it)\n"
    "    dem cost -record FILE GX GY GZ    height, level and kinetic energy of a record of particles, gravity given\n";

/* ---- the scene as it is ---------------------------------------------------------------------------------------- */

/* A quantity that the scene does not have: left out, or refused when it was asked for by name. */
static int drop(struct dem_cost *c, int quantity, int has, const char *why)
{
    DEM_REQUIRE(has || !c->wanted[quantity] || !c->request.option[DEM_ASK_OF].given, DEM_ERROR_INPUT, "-of %s: %s; leave it out", c->quantity[quantity].name,
                why);
    c->wanted[quantity] = c->wanted[quantity] && has;
    return DEM_OK;
}

static int choose_quantities(struct dem_cost *c, const struct dem *d)
{
    DEM_TRY(drop(c, DEM_COST_HEIGHT, c->up[0] != 0.0 || c->up[1] != 0.0 || c->up[2] != 0.0, "the scene has no gravity, so no height"));
    DEM_TRY(drop(c, DEM_COST_FORCE, dem_wall_count(d) > 0, "the scene has no walls"));
    DEM_TRY(drop(c, DEM_COST_RESTITUTION, c->pair.bodies > 0, "for two bodies that meet head on, and nothing else, on one rank"));
    return drop(c, DEM_COST_CONTACTS, c->particles > 2, "for scenes of more than two particles");
}

static int take_scene(struct dem_cost *c, struct dem *d, const struct dem_schedule *s)
{
    const double g = sqrt(s->gravity[0]*s->gravity[0] + s->gravity[1]*s->gravity[1] + s->gravity[2]*s->gravity[2]);
    struct dem_tally t;

    DEM_TRY(dem_tally(d, &t));
    DEM_REQUIRE(t.particles > 0, DEM_ERROR_INPUT, "the scene has no particles at its start; begin with -restart from a snapshot that has some");
    for (int k = 0; k < 3; k++)
    {
        c->up[k] = g > 0.0 ? -s->gravity[k]/g : 0.0;
    }
    c->from_snapshot = c->request.restart || dem_dict_has(dem_scene_dict(d), "start");
    DEM_REQUIRE(!c->from_snapshot || !c->request.option[DEM_ASK_WHICH].given || !c->wish.ladder[1], DEM_ERROR_INPUT, "-ladders stiffness from a "
                "snapshot, whose overlaps are those of its own stiffness: others would let it burst or sink; leave it out, or begin at the "
                "scene's start");
    c->start = t.time;
    c->end = s->end;
    c->step = dem_step_limit(d).used;
    c->limit = dem_step_limit(d).limit;
    c->fall = t.fall;
    c->mass = t.mass;
    c->particles = t.particles;
    c->diameter = cbrt(6.0*t.volume/(3.14159265358979324*(double)t.particles));
    DEM_REQUIRE(c->end > c->start, DEM_ERROR_INPUT, "the snapshot is of %g s, and so is time/end; give a later end", c->start);
    DEM_REQUIRE(c->window <= (c->end - c->start)*(1.0 + 1e-12), DEM_ERROR_INPUT, "-window %g s is longer than the %g s to time/end; give "
                "at most that, or a later end with -set time/end", c->window, c->end - c->start);
    dem_cost_meet(c, d);
    DEM_TRY(choose_quantities(c, d));
    dem_cost_closed(c, d);
    snprintf(c->acting, sizeof c->acting, "%s", dem_acting(d));
    DEM_TRY(dem_cost_find_friction(c, dem_scene_dict(d)));
    return dem_cost_moduli(c, dem_scene_dict(d));
}

/* ---- the window ------------------------------------------------------------------------------------------------ */

static const double few_steps = 10.0, look_steps = 40.0;  /* of the coarsest rung: in a window, between looks */

/* How long a step takes in the first `steps` of them; the same on all ranks. */
static int pilot(struct dem_cost *c, double steps, double *second)
{
    struct dem_cost_run run;
    const struct dem_cost_knobs k = {.steps = (int64_t)ceil(steps), .stiffer = 1.0};

    c->looks = 1;
    c->window = (double)k.steps*c->step;
    DEM_TRY(dem_cost_run(c, &k, &run));
    *second = run.seconds/(double)k.steps;
    if (c->prog->comm != MPI_COMM_NULL)
    {
        MPI_Bcast(second, 1, MPI_DOUBLE, 0, c->prog->comm);
    }
    return DEM_OK;
}

/* Steps that the budget allows. What is to come may cost more than the beginning (a bed forms), so try again with what was found. */
static int afford(struct dem_cost *c, double span, double *window)
{
    double steps = fmin(200.0, span/c->step), second;

    for (int k = 0; k < 3; k++)
    {
        DEM_TRY(pilot(c, steps, &second));
        const double may = fmin(span/c->step, c->budget/dem_cost_weight(c)/second);

        if (k > 0 && may >= 0.8*steps)
        {
            break;
        }
        steps = may;
    }
    *window = fmin(span, steps*c->step);
    return DEM_OK;
}

static int choose_window(struct dem_cost *c)
{
    const double span = c->end - c->start, coarsest = fmax(1.0, c->wish.ladder[0] ? c->wish.steps[0] : 1.0);
    double window = c->window;

    DEM_TRY(window > 0.0 ? DEM_OK : afford(c, span, &window));
    const double steps = window/c->step/coarsest;

    c->window = window;
    DEM_REQUIRE(steps >= few_steps, DEM_ERROR_INPUT, "a window of %.3g s has only %.3g steps of the coarsest rung; give a longer -window, a larger "
                "-budget, or finer rungs", window, steps);
    c->looks = c->pair.bodies > 0 ? 1 : (int)fmax(1.0, fmin(DEM_COST_LOOKS, floor(steps/look_steps)));
    return DEM_OK;
}

/* ---- the command ----------------------------------------------------------------------------------------------- */

static int make_folder(const struct dem_cost *c)
{
    errno = 0;
    DEM_REQUIRE(c->prog->rank != 0 || mkdir(c->folder, 0777) == 0 || errno == EEXIST, DEM_ERROR_FILE, "can't make the folder %s: %s; give "
                "another -folder", c->folder, strerror(errno));
    return DEM_OK;
}

static int ask(struct dem_cost *c)
{
    struct dem_schedule s;
    struct dem *d;

    DEM_TRY(dem_scene_open(c->prog, &c->request, &d, &s));
    const int status = take_scene(c, d, &s);

    dem_free(d);
    DEM_TRY(status);
    DEM_TRY(choose_window(c));
    DEM_TRY(dem_program_together(c->prog, make_folder(c)));
    DEM_TRY(dem_cost_climb(c));
    dem_cost_judge(c);
    if (c->prog->rank == 0)
    {
        dem_cost_tell(c);
    }
    return dem_program_together(c->prog, c->prog->rank == 0 ? dem_cost_write(c) : DEM_OK);
}

/* Scenes have their own runs; for a table the first rank does it all. */
static int cost_of(struct dem_cost *c, int argc, char **argv)
{
    struct dem_option option[DEM_ASK_OPTIONS];

    if (argc > 0 && strcmp(argv[0], "-judge") == 0)
    {
        return c->prog->rank == 0 ? dem_cost_judge_table(c, argc, argv) : DEM_OK;
    }
    if (argc > 0 && strcmp(argv[0], "-record") == 0)
    {
        return c->prog->rank == 0 ? dem_cost_tell_record(argc, argv) : DEM_OK;
    }
    dem_cost_options(option);
    dem_cost_name_own(c);
    c->request = (struct dem_request){.option = option, .options = DEM_ASK_OPTIONS, .bare = 1};
    DEM_TRY(dem_request_read(&c->request, "cost", argc, argv));
    if (c->request.help)
    {
        fputs(c->prog->rank == 0 ? help : "", stdout);
        return DEM_OK;
    }
    DEM_TRY(dem_cost_read_options(c));
    return ask(c);
}

int dem_main_cost(struct dem_program *prog, int argc, char **argv)
{
    struct dem_cost *c;

    DEM_TRY(DEM_NEW(c, 1));
    c->prog = prog;
    const int status = cost_of(c, argc, argv);

    dem_memory_free(c);
    return status;
}
