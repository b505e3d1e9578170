/*
 * cost.h -- `dem cost`: errors and processor time of a scene over refinement series of its
 * parameters (accuracy against cost).
 *
 * A series varies one parameter: time step, contact stiffness, precision, law of friction, or each
 * effect left out. Each level of a series is run several times over the same window of simulated
 * time.
 *
 *   cost.c               the command: reads the scene, chooses the window
 *   cost_options.c       command-line options
 *   cost_series.c        the series and the runs of their levels
 *   cost_run.c           one run of the window: its quantities and its processor time
 *   cost_closed_forms.c  closed forms of a head-on impact
 *   cost_errors.c        errors of all levels (advisor/refinement_series.h), Pareto front
 *   cost_report.c        tables on the terminal, cost.csv, the picture
 *   cost_best_buy.c      the best buy: cheapest level within the target error, in one sentence
 *   cost_table.c         the same for a table of runs of another program (demCost: OpenFOAM cases)
 *   cost_record.c        height, level and kinetic energy from a record of particles, for demCost
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_COST_H
#define DEM_APP_COST_H

#include "app/scene_options.h"
#include "core/error.h"
#include "advisor/refinement_series.h"

/* "mean" is that over the samples of a run */
enum dem_cost_quantity
{
    DEM_COST_KINETIC,           /* J   kinetic energy of translation and rotation, mean */
    DEM_COST_ROTATION,          /* J   kinetic energy of rotation, mean */
    DEM_COST_HEIGHT,            /* m   of the centre of mass against gravity, mean */
    DEM_COST_OVERLAP,           /* 1   largest between two samples over the smaller diameter,
                                   mean */
    DEM_COST_FORCE,             /* N   largest force on a wall, as mean between two samples */
    DEM_COST_CONTACTS,          /* 1   coordination number (a contact counts for both particles),
                                   mean */
    DEM_COST_RESTITUTION,       /* 1   of a head-on impact: separation speed over approach speed */
    DEM_COST_SCENE_QUANTITIES,  /* number of quantities of a scene; a table has its own names */
    DEM_COST_MAX_QUANTITIES = 12
};

/* index of the command-line options */
enum
{
    DEM_COST_OPTION_WINDOW, DEM_COST_OPTION_BUDGET, DEM_COST_OPTION_RUNS, DEM_COST_OPTION_TARGET,
    DEM_COST_OPTION_QUANTITIES, DEM_COST_OPTION_SERIES, DEM_COST_OPTION_STEPS,
    DEM_COST_OPTION_STIFFNESSES, DEM_COST_OPTION_FOLDER, DEM_COST_OPTION_EFFECTS, DEM_COST_OPTIONS
};

enum
{
    DEM_COST_NAMED_SERIES = 4,      /* that -series may name; -effects is separate */
    DEM_COST_MAX_SERIES = 8,        /* in a table */
    DEM_COST_MAX_SAMPLES = 32,      /* in a run */
    DEM_COST_MAX_MODULI = 36,
    DEM_COST_FRICTION_SETTINGS = 3  /* that all laws of friction have */
};

/* two bodies in head-on impact without other forces */
struct dem_cost_impact
{
    int bodies;                 /* 2: two particles; 1: a particle and a plane; 0: no such scene */
    double normal[3];           /* from the second to the first, or the normal of the plane */
    double speed;               /* m/s   approach speed */
    double mass[2], radius[2];  /* kg, m */
};

struct dem_cost_run
{
    double value[DEM_COST_MAX_QUANTITIES];  /* not a number: none */
    double max_kinetic;                     /* J   over all samples */
    double seconds;                         /* processor time of the steps, sum of all ranks */
    int64_t steps;
};

struct dem_cost_level
{
    char name[40];                     /* "1/2" */
    double size;                       /* 1   what the error goes to zero with; 1 for the scene as
                                          it is */
    double step;                       /* s */
    int runs;
    struct dem_cost_run run[DEM_REFINEMENT_RUNS];
    char failed[DEM_ERROR_TEXT_SIZE];  /* error text if there are no runs */

    /* derived by dem_cost_find_errors */
    double seconds, spread;            /* s, 1: smallest time at the level's step; largest over
                                          smallest */
    /* 1   over the scale; not a number: none */
    double error[DEM_COST_MAX_QUANTITIES], uncertainty[DEM_COST_MAX_QUANTITIES];
    int worst;                         /* the quantity with the largest error; -1: none */
    int pareto;                        /* 1: no other level of the series is both better and
                                          cheaper */
};

struct dem_cost_series
{
    char parameter[40], description[160];                /* "step" */
    char entry[40];                                      /* the entry that a user changes:
                                                            "time/step" */
    int exact;                                           /* 1: the exact solution is that of the
                                                            scene, so closed forms hold */
    int paired;                                          /* 1: levels are compared with the base,
                                                            the last one, run by run */
    int levels;
    struct dem_cost_level level[DEM_REFINEMENT_LEVELS];  /* from coarse to fine */
    int base;                                            /* level of the scene as it is; -1: none */
    int reported[DEM_COST_MAX_QUANTITIES];               /* 1: errors of the quantity are
                                                            reported */
    struct dem_refinement_series analysis[DEM_COST_MAX_QUANTITIES];
};

struct dem_cost_quantity_name
{
    char name[24], unit[12];
};

/* the series that the options ask for, and their levels */
struct dem_cost_selection
{
    double steps[DEM_REFINEMENT_LEVELS], stiffnesses[DEM_REFINEMENT_LEVELS];
    int step_levels, stiffness_levels;
    int series[DEM_COST_NAMED_SERIES];  /* 1: wanted; step, stiffness, precision, friction */
};

/* the scene's law of friction, with the settings that all laws have */
struct dem_cost_friction
{
    const char *law;                                  /* NULL: none, or not the same for all
                                                         pairs */
    int settings;
    char setting[DEM_COST_FRICTION_SETTINGS][2][64];  /* name, value */
};

struct dem_cost
{
    const struct dem_program *prog;
    struct dem_request request;
    char folder[512];
    int from_snapshot;                      /* 1: the window begins at a snapshot */
    double start, end, step, limit;         /* s   of the scene as it is; limit: largest stable
                                               step */
    double window;                          /* s */
    int samples, runs;                      /* in a run; in a level */
    const char *noun;                       /* "scene"; "case" of a table, whose limit is not
                                               known */
    char title[400];                        /* of a table */
    struct dem_cost_quantity_name quantity[DEM_COST_MAX_QUANTITIES];
    int quantities;
    double budget, target;                  /* s of processor time; 1 */
    /* J, m, kg: fall of dem_totals, mean diameter, mass of all particles */
    double fall, diameter, mass;
    double up[3];                           /* unit vector against gravity; zero without gravity */
    int64_t particles;
    struct dem_cost_impact impact;
    int wanted[DEM_COST_MAX_QUANTITIES], has_closed_form[DEM_COST_MAX_QUANTITIES];
    double closed_form[DEM_COST_MAX_QUANTITIES];
    double scale[DEM_COST_MAX_QUANTITIES];  /* errors are divided by it; in the quantity's unit */
    struct
    {
        char path[128];
        double value;
    } modulus[DEM_COST_MAX_MODULI];         /* all entries of the scene that set contact
                                               stiffness */
    int moduli;
    struct dem_cost_selection selection;
    struct dem_cost_friction friction;
    char acting[800];                       /* names of all effects, separated by blanks */
    struct dem_cost_series series[DEM_COST_MAX_SERIES];
    int n_series;
};

/* cost_errors.c. Set the quantities of scenes. */
void dem_cost_scene_quantities(struct dem_cost *);

/* cost_options.c. Set the command's options; read and check their values. */
void dem_cost_options(struct dem_option option[DEM_COST_OPTIONS]);
int dem_cost_read_options(struct dem_cost *);

/* cost_series.c. Processor time of all series in units of one run of the window of the scene as it
   is. */
double dem_cost_relative(const struct dem_cost *);

/* Make all series and run their levels. Collective. A level that fails keeps the error text. */
int dem_cost_run_series(struct dem_cost *);
int dem_cost_find_friction(struct dem_cost *, const struct dem_dict *scene);

/* cost_run.c. One run of the window, in samples*steps equal steps, with overrides on top of those
   of the request. Collective. */
struct dem_cost_variation
{
    int64_t steps;            /* between two samples */
    const char *precision;    /* NULL: the scene's */
    const char *without;      /* an effect that is left out; NULL: none */
    const char *friction;     /* law of friction instead of the scene's; NULL: the scene's */
    double stiffness_factor;  /* multiplies all Young's moduli and stiffnesses of the scene */
};
int dem_cost_run(const struct dem_cost *, const struct dem_cost_variation *, struct dem_cost_run *);
int dem_cost_find_moduli(struct dem_cost *, const struct dem_dict *scene);

/* The largest stable step [s] with this factor of the stiffness. */
int dem_cost_step_limit(const struct dem_cost *, double stiffness_factor, double *limit);

/* cost_closed_forms.c. Detect a head-on impact of two bodies; set the closed forms that are known
   for it. */
void dem_cost_find_impact(struct dem_cost *, const struct dem *);
/* m/s along the normal */
double dem_cost_separation_speed(const struct dem_cost_impact *, const struct dem *);
void dem_cost_closed_forms(struct dem_cost *, struct dem *);

/* cost_errors.c. Errors, processor times and Pareto fronts from the runs of all series. */
void dem_cost_find_errors(struct dem_cost *);

/* cost_report.c, cost_best_buy.c: on the first rank. */
void dem_cost_report(const struct dem_cost *);
int dem_cost_write(const struct dem_cost *);
void dem_cost_best_buy(const struct dem_cost *, char *sentence, size_t size);

/* cost_table.c, cost_record.c: `dem cost -judge TABLE FOLDER` and `dem cost -record FILE GX GY GZ`.
   */
int dem_cost_report_table(struct dem_cost *, int argc, char **argv);
int dem_cost_report_record(int argc, char **argv);

#endif
