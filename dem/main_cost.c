/*
 * main_cost.c -- `dem cost SCENE`: a window of the scene over ladders of its knobs, each rung with its errors and its time.
 *
 * Runs are made one after the other in this process, from a fresh start of the scene each; they write nothing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* strtok_r, isatty */
#include "main_cost.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/unknown.h"
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char help[] =
    "Usage: dem cost [OPTION VALUE] ... [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE\n\n"
    "What accuracy costs in time: runs a window of the scene with other time steps, contact stiffnesses and in mixed precision, and\n"
    "tells of each rung the error of what users mean, and its processor time; last, in a sentence, the best buy. Nothing is\n"
    "written but the folder that is named in the end: cost.csv, cost.png and cost.svg (python3 with matplotlib).\n\n"
    "    -window T          s of simulated time; default: time/end, or what the budget allows\n"
    "    -restart SNAPSHOT  the window begins there, and not at the scene's start: settle a bed first, then ask\n"
    "    -budget S          s of processor time for all runs together; default 60\n"
    "    -runs N            of a rung, with steps that differ by some per cent; default 5, 3 to 32\n"
    "    -target E          the error to be bought; default 0.01\n"
    "    -of LIST           quantities, with commas: kinetic, rotation, height, overlap, force, contacts, restitution; default all it has\n"
    "    -ladders LIST      step, stiffness, precision; default all\n"
    "    -steps LIST        rungs, as shares of the scene's step; default 2,1,0.5,0.25,0.125\n"
    "    -stiffnesses LIST  rungs, as multiples of all Young's moduli; default 0.0625,0.25,1,4,16\n"
    "    -folder NAME       default: the scene's name without its ending, and .cost\n";

enum
{
    WINDOW, BUDGET, RUNS, TARGET, OF, LADDERS, STEPS, STIFFNESSES, FOLDER, OPTIONS
};

static const char *const ladders[] = {"step", "stiffness", "precision"};

struct plan                                               /* what the options say */
{
    double steps[DEM_LADDER_RUNGS], stiffnesses[DEM_LADDER_RUNGS];
    int step_rungs, stiffness_rungs;
    int ladder[DEM_COST_LADDERS];
};

/* ---- options --------------------------------------------------------------------------------------------------- */

static int read_number(const struct dem_option *o, double least, double most, double fallback, double *value)
{
    char *end;

    *value = fallback;
    if (!o->given)
    {
        return DEM_OK;
    }
    *value = strtod(o->given, &end);
    DEM_REQUIRE(end != o->given && !*end && *value >= least && *value <= most, DEM_ERROR_INPUT, "%s %s; give a number from %g to %g", o->name,
                o->given, least, most);
    return DEM_OK;
}

static int descending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x < y) - (x > y);
}

/* Numbers with commas, and 1 among them; the first is the coarsest. */
static int read_rungs(const struct dem_option *o, const char *fallback, double *value, int *n)
{
    const char *at = o->given ? o->given : fallback;
    char *end;
    int one = 0;

    for (*n = 0; *at; at = *end ? end + 1 : end)
    {
        DEM_REQUIRE(*n < DEM_LADDER_RUNGS, DEM_ERROR_INPUT, "%s %s; give at most %d numbers", o->name, o->given, DEM_LADDER_RUNGS);
        value[*n] = strtod(at, &end);
        DEM_REQUIRE(end != at && (!*end || *end == ',') && value[*n] >= 1e-6 && value[*n] <= 1e6, DEM_ERROR_INPUT,
                    "%s %s; give numbers from 1e-6 to 1e6 with commas between, as in %s", o->name, o->given, fallback);
        one |= value[(*n)++] == 1.0;
    }
    qsort(value, (size_t)*n, sizeof *value, descending);
    for (int k = 1; k < *n; k++)
    {
        DEM_REQUIRE(value[k] < value[k - 1], DEM_ERROR_INPUT, "%s %s has %g twice; give each rung once", o->name, o->given, value[k]);
    }
    DEM_REQUIRE(*n >= 3 && one, DEM_ERROR_INPUT, "%s %s; give three rungs or more, 1 (the scene as it is) among them", o->name, o->given);
    return DEM_OK;
}

/* Words with commas: chosen[k] is 1 for those that are there. Without the option it is left as it is. */
static int read_words(const struct dem_option *o, const char *what, const char *const *known, int n, int *chosen)
{
    char text[256], *word, *rest;

    if (!o->given)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(o->given[0] && strlen(o->given) < sizeof text, DEM_ERROR_INPUT, "%s \"%s\"; give words with commas between", o->name, o->given);
    snprintf(text, sizeof text, "%s", o->given);
    memset(chosen, 0, (size_t)n*sizeof *chosen);
    for (word = strtok_r(text, ",", &rest); word; word = strtok_r(NULL, ",", &rest))
    {
        int found = 0;

        for (int k = 0; k < n; k++)
        {
            found |= strcmp(word, known[k]) == 0;
            chosen[k] |= strcmp(word, known[k]) == 0;
        }
        if (!found)
        {
            return dem_unknown_word(what, word, known, n);
        }
    }
    return DEM_OK;
}

static int name_folder(struct dem_cost *c, const char *given)
{
    const char *const slash = strrchr(c->request.scene, '/'), *const name = slash ? slash + 1 : c->request.scene;
    const char *const dot = strrchr(name, '.');
    const int length = given ? (int)strlen(given) : (int)(dot && dot > name ? dot - name : (long)strlen(name));

    DEM_REQUIRE(length > 0 && (size_t)length + 6 < sizeof c->folder, DEM_ERROR_INPUT, "a folder's name of %d letters; give another -folder", length);
    snprintf(c->folder, sizeof c->folder, "%.*s%s", length, given ? given : name, given ? "" : ".cost");
    return DEM_OK;
}

static int read_options(struct dem_cost *c, struct plan *p)
{
    static const char *const quantities[] = {"kinetic", "rotation", "height", "overlap", "force", "contacts", "restitution"};
    const struct dem_option *const o = c->request.option;
    double runs;

    DEM_TRY(read_number(&o[WINDOW], 0.0, DBL_MAX, 0.0, &c->window));
    DEM_REQUIRE(!o[WINDOW].given || c->window > 0.0, DEM_ERROR_INPUT, "-window %s; give a number of seconds above 0", o[WINDOW].given);
    DEM_TRY(read_number(&o[BUDGET], 0.1, 1e9, 60.0, &c->budget));
    DEM_TRY(read_number(&o[RUNS], 3.0, DEM_LADDER_RUNS, 5.0, &runs));
    DEM_REQUIRE(runs == floor(runs), DEM_ERROR_INPUT, "-runs %g; give a whole number", runs);
    c->runs = (int)runs;
    DEM_TRY(read_number(&o[TARGET], 1e-12, 1.0, 0.01, &c->target));
    for (int k = 0; k < DEM_COST_QUANTITIES; k++)
    {
        c->wanted[k] = 1;
    }
    DEM_TRY(read_words(&o[OF], "quantity", quantities, DEM_COST_QUANTITIES, c->wanted));
    p->ladder[0] = p->ladder[1] = p->ladder[2] = 1;
    DEM_TRY(read_words(&o[LADDERS], "ladder", ladders, DEM_COST_LADDERS, p->ladder));
    DEM_TRY(read_rungs(&o[STEPS], "2,1,0.5,0.25,0.125", p->steps, &p->step_rungs));
    DEM_TRY(read_rungs(&o[STIFFNESSES], "0.0625,0.25,1,4,16", p->stiffnesses, &p->stiffness_rungs));
    return name_folder(c, o[FOLDER].given);
}

/* ---- the scene as it is ---------------------------------------------------------------------------------------- */

/* A quantity that the scene does not have: left out, or refused when it was asked for by name. */
static int drop(struct dem_cost *c, int quantity, int has, const char *why)
{
    DEM_REQUIRE(has || !c->wanted[quantity] || !c->request.option[OF].given, DEM_ERROR_INPUT, "-of %s: %s; leave it out", dem_cost_name(quantity),
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
    return dem_cost_moduli(c, dem_scene_dict(d));
}

/* ---- the window ------------------------------------------------------------------------------------------------ */

static const double few_steps = 10.0, look_steps = 40.0;  /* of the coarsest rung: in a window, between looks */

/* As many runs of the window as all ladders make together, in runs of the scene as it is. */
static double weight(const struct dem_cost *c, const struct plan *p)
{
    double sum = 0.0;

    for (int k = 0; k < p->step_rungs && p->ladder[0]; k++)
    {
        sum += 1.0/p->steps[k];
    }
    for (int k = 0; k < p->stiffness_rungs && p->ladder[1]; k++)
    {
        sum += pow(p->stiffnesses[k], 0.4);               /* as contact times go */
    }
    return c->runs*(sum + (p->ladder[2] ? 2.0 : 0.0));
}

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
static int afford(struct dem_cost *c, const struct plan *p, double span, double *window)
{
    double steps = fmin(200.0, span/c->step), second;

    for (int k = 0; k < 3; k++)
    {
        DEM_TRY(pilot(c, steps, &second));
        const double may = fmin(span/c->step, c->budget/weight(c, p)/second);

        if (k > 0 && may >= 0.8*steps)
        {
            break;
        }
        steps = may;
    }
    *window = fmin(span, steps*c->step);
    return DEM_OK;
}

static int choose_window(struct dem_cost *c, const struct plan *p)
{
    const double span = c->end - c->start, coarsest = fmax(1.0, p->ladder[0] ? p->steps[0] : 1.0);
    double window = c->window;

    DEM_TRY(window > 0.0 ? DEM_OK : afford(c, p, span, &window));
    const double steps = window/c->step/coarsest;

    c->window = window;
    DEM_REQUIRE(steps >= few_steps, DEM_ERROR_INPUT, "a window of %.3g s has only %.3g steps of the coarsest rung; give a longer -window, a larger "
                "-budget, or finer rungs", window, steps);
    c->looks = c->pair.bodies > 0 ? 1 : (int)fmax(1.0, fmin(DEM_COST_LOOKS, floor(steps/look_steps)));
    return DEM_OK;
}

/* ---- ladders --------------------------------------------------------------------------------------------------- */

/* For whoever waits at a terminal. */
static void show_life(const struct dem_cost *c, const char *text)
{
    if (c->prog->rank == 0 && isatty(STDERR_FILENO))
    {
        fputs(text, stderr);
        fflush(stderr);
    }
}

/* Runs of some per cent more and less steps. One that fails ends its rung, and is told. */
static int climb(const struct dem_cost *c, struct dem_cost_rung *r, struct dem_cost_knobs k)
{
    const double steps = fmax(1.0, round(c->window/c->looks/r->step)), apart = fmax(1.0, round(0.02*steps));

    for (r->runs = 0; r->runs < c->runs; r->runs++)
    {
        k.steps = (int64_t)fmax(1.0, steps + apart*(r->runs - (c->runs - 1)/2));
        if (dem_cost_run(c, &k, &r->run[r->runs]))
        {
            snprintf(r->failed, sizeof r->failed, "%s", dem_error_text());
            r->runs = 0;
            return DEM_OK;
        }
    }
    show_life(c, ".");
    return DEM_OK;
}

static struct dem_cost_ladder *new_ladder(struct dem_cost *c, const char *knob, const char *says)
{
    struct dem_cost_ladder *const l = &c->ladder[c->ladders++];

    l->knob = knob;
    l->says = says;
    l->base = -1;
    memcpy(l->told, c->wanted, sizeof l->told);
    return l;
}

static int climb_steps(struct dem_cost *c, const struct plan *p)
{
    struct dem_cost_ladder *const l = new_ladder(c, "step", "time step, in steps of the scene as it is");

    l->exact = 1;
    for (int k = 0; k < p->step_rungs; k++)
    {
        struct dem_cost_rung *const r = &l->rung[l->rungs++];

        l->base = p->steps[k] == 1.0 ? k : l->base;
        snprintf(r->name, sizeof r->name, "%.4g", p->steps[k]);
        r->size = p->steps[k];
        r->step = c->step*p->steps[k];
        DEM_TRY(climb(c, r, (struct dem_cost_knobs){.stiffer = 1.0}));
    }
    return DEM_OK;
}

/* The step is as long beside its limit in all rungs: what it errs by is much the same in all. Soft first. */
static int climb_stiffnesses(struct dem_cost *c, const struct plan *p)
{
    struct dem_cost_ladder *const l = new_ladder(c, "stiffness", "stiffness, in that of the scene; errors against hard spheres");

    l->told[DEM_COST_OVERLAP] = 0;                        /* there are none */
    for (int k = p->stiffness_rungs - 1; k >= 0; k--)
    {
        struct dem_cost_rung *const r = &l->rung[l->rungs];
        double limit;

        l->base = p->stiffnesses[k] == 1.0 ? l->rungs : l->base;
        l->rungs++;
        snprintf(r->name, sizeof r->name, "%.4g", p->stiffnesses[k]);
        DEM_TRY(dem_cost_limit(c, p->stiffnesses[k], &limit));
        r->size = limit/c->limit;
        r->step = c->step*r->size;
        DEM_TRY(climb(c, r, (struct dem_cost_knobs){.stiffer = p->stiffnesses[k]}));
    }
    return DEM_OK;
}

static int climb_precisions(struct dem_cost *c)
{
    struct dem_cost_ladder *const l = new_ladder(c, "precision", "precision; errors against double");

    for (int k = 0; k < 2; k++)
    {
        struct dem_cost_rung *const r = &l->rung[l->rungs++];

        snprintf(r->name, sizeof r->name, "%s", k ? "double" : "mixed");
        r->size = k ? 0.5 : 1.0;
        r->step = c->step;
        DEM_TRY(climb(c, r, (struct dem_cost_knobs){.stiffer = 1.0, .precision = r->name}));
    }
    l->base = 1;
    l->paired = 1;
    return DEM_OK;
}

static int climb_all(struct dem_cost *c, const struct plan *p)
{
    DEM_TRY(p->ladder[0] ? climb_steps(c, p) : DEM_OK);
    /* else nothing is stiff in it; and what comes of a head-on impact owes nothing to stiffness */
    if (p->ladder[1] && c->limit < DBL_MAX && (c->pair.bodies == 0 || c->request.option[LADDERS].given))
    {
        DEM_TRY(climb_stiffnesses(c, p));
    }
    DEM_TRY(p->ladder[2] ? climb_precisions(c) : DEM_OK);
    show_life(c, "\n");
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

static int ask(struct dem_cost *c, const struct plan *p)
{
    struct dem_schedule s;
    struct dem *d;

    DEM_TRY(dem_scene_open(c->prog, &c->request, &d, &s));
    const int status = take_scene(c, d, &s);

    dem_free(d);
    DEM_TRY(status);
    DEM_TRY(choose_window(c, p));
    DEM_TRY(dem_program_together(c->prog, make_folder(c)));
    DEM_TRY(climb_all(c, p));
    dem_cost_judge(c);
    if (c->prog->rank == 0)
    {
        dem_cost_tell(c);
    }
    return dem_program_together(c->prog, c->prog->rank == 0 ? dem_cost_write(c) : DEM_OK);
}

int dem_main_cost(struct dem_program *prog, int argc, char **argv)
{
    struct dem_option option[OPTIONS] = {{.name = "-window"}, {.name = "-budget"}, {.name = "-runs"}, {.name = "-target"}, {.name = "-of"},
                                         {.name = "-ladders"}, {.name = "-steps"}, {.name = "-stiffnesses"}, {.name = "-folder"}};
    struct plan p = {.step_rungs = 0};
    struct dem_cost *c;

    DEM_TRY(DEM_NEW(c, 1));
    c->prog = prog;
    c->request = (struct dem_request){.option = option, .options = OPTIONS, .bare = 1};
    int status = dem_request_read(&c->request, "cost", argc, argv);

    if (!status && c->request.help)
    {
        fputs(prog->rank == 0 ? help : "", stdout);
    }
    else if (!status)
    {
        status = read_options(c, &p);
        status = status ? status : ask(c, &p);
    }
    dem_memory_free(c);
    return status;
}
