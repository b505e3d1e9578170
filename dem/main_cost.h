/*
 * main_cost.h -- `dem cost`: what accuracy costs in time. A window of the scene is run over ladders of its knobs.
 *
 *   main_cost.c          the command: the scene as it is, the window
 *   main_cost_options.c  what may be asked
 *   main_cost_ladders.c  the ladders: steps, stiffnesses, precisions, laws of friction; each effect left out
 *   main_cost_run.c      one run of the window: its quantities and its processor time
 *   main_cost_closed.c   what a head-on impact must give
 *   main_cost_judge.c    errors of all rungs (plan/ladder.h), and which are worth their time
 *   main_cost_tell.c     the tables, cost.csv, the picture
 *   main_cost_buy.c      the best buy, in a sentence
 *   main_cost_table.c    the same of runs that another program made: a table of them, as demCost writes it
 *   main_cost_record.c   what a record of particles says, for demCost
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_COST_H
#define DEM_MAIN_COST_H

#include "main_scene.h"
#include "base/error.h"
#include "plan/ladder.h"

enum dem_cost_quantity
{
    DEM_COST_KINETIC,                                     /* J   translation and rotation, mean of the looks */
    DEM_COST_ROTATION,                                    /* J   of it rotation */
    DEM_COST_HEIGHT,                                      /* m   of the centre of mass against gravity, mean of the looks */
    DEM_COST_OVERLAP,                                     /* 1   largest between two looks, mean of those; of the smaller diameter */
    DEM_COST_FORCE,                                       /* N   on the wall that bears most: mean between two looks, the largest */
    DEM_COST_CONTACTS,                                    /* 1   touching partners a particle (a contact counts for each of two), mean of the looks */
    DEM_COST_RESTITUTION,                                 /* 1   of a head-on impact: speed of parting over that of meeting */
    DEM_COST_OWN,                                         /* of a scene; a table has its own names */
    DEM_COST_QUANTITIES = 12
};

enum                                                      /* options */
{
    DEM_ASK_WINDOW, DEM_ASK_BUDGET, DEM_ASK_RUNS, DEM_ASK_TARGET, DEM_ASK_OF, DEM_ASK_WHICH, DEM_ASK_STEPS, DEM_ASK_STIFFNESSES,
    DEM_ASK_FOLDER, DEM_ASK_EFFECTS, DEM_ASK_OPTIONS
};

enum
{
    DEM_COST_LADDERS = 4,                                 /* that may be named; the one of effects stands alone */
    DEM_COST_MOST_LADDERS = 8,                            /* of a table */
    DEM_COST_LOOKS = 32,                                  /* at most */
    DEM_COST_MODULI = 36
};

struct dem_cost_pair                                      /* two bodies that meet head on, and nothing else acts */
{
    int bodies;                                           /* 2: two particles; 1: a particle and a plane; 0: no such scene */
    double normal[3];                                     /* from the second to the first, or the plane's */
    double speed;                                         /* m/s   at which they meet */
    double mass[2], radius[2];                            /* kg, m */
};

struct dem_cost_run
{
    double value[DEM_COST_QUANTITIES];                    /* not a number where it has none */
    double most_kinetic;                                  /* J   of all looks */
    double seconds;                                       /* of processor, all ranks, in steps alone */
    int64_t steps;
};

struct dem_cost_rung
{
    char name[40];                                        /* "1/2" */
    double size;                                          /* 1   what its error goes to zero with, 1 in the scene as it is */
    double step;                                          /* s */
    int runs;
    struct dem_cost_run run[DEM_LADDER_RUNS];
    char failed[DEM_ERROR_TEXT_SIZE];                     /* why it has no runs */

    double seconds, spread;                               /* derived: the least and the largest over it, at the rung's own step */
    double error[DEM_COST_QUANTITIES], unsure[DEM_COST_QUANTITIES];     /* 1   of the quantity's scale; not a number: none */
    int worst;                                            /* the quantity with the largest; -1: none */
    int front;                                            /* 1: no other rung of these is both better and cheaper */
};

struct dem_cost_ladder
{
    char knob[40], says[160];                             /* "step" */
    char entry[40];                                       /* what a user writes for it: "time/step" */
    int exact;                                            /* 1: closed forms hold where the error is gone */
    int paired;                                           /* 1: rungs are compared run by run with the last, the base */
    int rungs;
    struct dem_cost_rung rung[DEM_LADDER_RUNGS];          /* from coarse to fine */
    int base;                                             /* the scene as it is; -1: not among them */
    int told[DEM_COST_QUANTITIES];                        /* 1: its errors are told */
    struct dem_ladder judged[DEM_COST_QUANTITIES];
};

struct dem_cost_named
{
    char name[24], unit[12];
};

struct dem_cost_wish                                      /* what the options say of ladders */
{
    double steps[DEM_LADDER_RUNGS], stiffnesses[DEM_LADDER_RUNGS];
    int step_rungs, stiffness_rungs;
    int ladder[DEM_COST_LADDERS];                         /* 1: step, stiffness, precision, friction */
};

struct dem_cost_friction                                  /* the scene's law, whose settings all three know */
{
    const char *law;                                      /* NULL: none, or not the same for all pairs */
    int settings;
    char setting[3][2][64];                               /* name, value */
};

struct dem_cost
{
    const struct dem_program *prog;
    struct dem_request request;
    char folder[512];
    int from_snapshot;                                    /* 1: the window begins there */
    double start, end, step, limit;                       /* s; of the scene as it is */
    double window;                                        /* s */
    int looks, runs;                                      /* of a run; of a rung */
    const char *noun;                                     /* "scene"; "case" of a table, whose limit is not known */
    char title[400];                                      /* of a table */
    struct dem_cost_named quantity[DEM_COST_QUANTITIES];
    int quantities;
    double budget, target;                                /* s of processor; 1 */
    double fall, diameter, mass;                          /* J, m, kg: dem_tally's fall, mean diameter, all particles */
    double up[3];                                         /* against gravity; zero without */
    int64_t particles;
    struct dem_cost_pair pair;
    int wanted[DEM_COST_QUANTITIES], closed[DEM_COST_QUANTITIES];
    double form[DEM_COST_QUANTITIES];                     /* the closed forms */
    double scale[DEM_COST_QUANTITIES];                    /* what errors are shares of, in the quantity's unit */
    struct
    {
        char path[128];
        double value;
    } modulus[DEM_COST_MODULI];                           /* all that makes contacts stiff, as the scene has it */
    int moduli;
    struct dem_cost_wish wish;
    struct dem_cost_friction friction;
    char acting[800];                                     /* all effects, with blanks between */
    struct dem_cost_ladder ladder[DEM_COST_MOST_LADDERS];
    int ladders;
};

/* main_cost_judge.c. The quantities of scenes. */
void dem_cost_name_own(struct dem_cost *);

/* main_cost_options.c. The command's own options; what they say, checked. */
void dem_cost_options(struct dem_option option[DEM_ASK_OPTIONS]);
int dem_cost_read_options(struct dem_cost *);

/* main_cost_ladders.c. How many runs of the window as the scene is all ladders are worth; run them, collective. */
double dem_cost_weight(const struct dem_cost *);
int dem_cost_climb(struct dem_cost *);
int dem_cost_find_friction(struct dem_cost *, const struct dem_dict *scene);

/* main_cost_run.c, collective. One run of the window in looks*steps equal steps, with further overrides on top of the request. */
struct dem_cost_knobs
{
    int64_t steps;                                        /* between two looks */
    const char *precision;                                /* NULL: the scene's */
    const char *without;                                  /* an effect that is left out; NULL: none */
    const char *friction;                                 /* the law in place of the scene's; NULL: the scene's */
    double stiffer;                                       /* all Young's moduli, and stiffnesses that are given, times this */
};
int dem_cost_run(const struct dem_cost *, const struct dem_cost_knobs *, struct dem_cost_run *);
int dem_cost_moduli(struct dem_cost *, const struct dem_dict *scene);

/* The longest step [s] that the scene stands with so much stiffer contacts. */
int dem_cost_limit(const struct dem_cost *, double stiffer, double *limit);

/* main_cost_closed.c. Are there two bodies that meet head on? And what comes of it, where that is known. */
void dem_cost_meet(struct dem_cost *, const struct dem *);
double dem_cost_parting(const struct dem_cost_pair *, const struct dem *);      /* m/s along the normal */
void dem_cost_closed(struct dem_cost *, struct dem *);

/* main_cost_judge.c */
void dem_cost_judge(struct dem_cost *);

/* main_cost_tell.c, main_cost_buy.c: by the first rank. */
void dem_cost_tell(const struct dem_cost *);
int dem_cost_write(const struct dem_cost *);
void dem_cost_buy(const struct dem_cost *, char *sentence, size_t size);

/* main_cost_table.c, main_cost_record.c: `dem cost -judge TABLE FOLDER` and `dem cost -record FILE GX GY GZ`. */
int dem_cost_judge_table(struct dem_cost *, int argc, char **argv);
int dem_cost_tell_record(int argc, char **argv);

#endif
