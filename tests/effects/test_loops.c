/*
 * test_loops.c -- two bodies on any closed path of their contact take work or none; without
 * damping and yield the work is zero. mindlin does not fulfil this (test_mindlin_incremental.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "impacts.h"

#include "core/random.h"

enum
{
    LEGS = 12, STEPS = 500
};

static const struct dem_material bead = {"bead", 2500.0, 1e7, .poissons_ratio = 0.3};
static const double dt = 1e-6, deepest = 5e-5;            /* s, m: a fortieth of the diameter */
static struct impacts w;

static double drawn(int row, int leg, int use)
{
    return dem_random_unit(21, (uint64_t)row, (uint64_t)leg, (uint64_t)use);
}

static void start(void)
{
    impacts_spheres(&w, &bead, &bead, 1e-3, 1e-3);
    w.b.n = DEM_BATCH_ROWS;
    w.b.dt = w.b.max_dt = dt;
    for (int c = 0; c < DEM_BATCH_ROWS; c++)
    {
        w.b.reduced_radius[c] = w.pair.min_radius;
        w.b.reduced_mass[c] = w.pair.min_mass;
        w.b.min_radius[c] = 1e-3;
        w.b.nz[c] = w.b.hz[c] = w.b.is_primary[c] = 1.0;
    }
}

/* an effect with settings at which it acts at some 0.1 m/s */
static void add(const struct dem_effect *e)
{
    static const struct
    {
        const char *word, *setting;
        double value;
    } known[] = {{"hertz", "impactSpeed", 1.0}, {"hooke", "stiffness", 1e3},
                {"hookeHysteresis", "unloading", 4.0}, {"dry", "restitution", 0.7},
                {"viscous", "coefficient", 0.01}, {"stokesDamping", "restitution", 0.9},
                {"sjkr", "energyDensity", 1e4},        {"jkr", "workOfAdhesion", 0.5},
                {"linear", "friction", 0.4}, {"mindlinIncremental", "friction", 0.4}};

    for (size_t k = 0; k < sizeof known/sizeof *known; k++)
    {
        if (strcmp(known[k].word, e->name) == 0)
        {
            struct impacts_effect *const l = impacts_add(&w, e, known[k].setting, known[k].value);

            if (strcmp(e->name, "hookeHysteresis") == 0)
            {
                apply_setting(e, l->settings, &w.pair, "stiffness", 1e3);
                apply_setting(e, l->settings, &w.pair, "adhesion", 0.5);
                apply_setting(e, l->settings, &w.pair, "plasticDepth", 0.01);
            }
            if (strcmp(e->name, "stokesDamping") == 0)
            {
                apply_setting(e, l->settings, &w.pair, "viscosity", 0.01);
            }
            if (e->stage == DEM_STAGE_TANGENT)
            {
                apply_setting(e, l->settings, &w.pair, "tangentialDamping", 0.0);
            }
            return;
        }
    }
    printf("Bail out! %s is not known here\n", e->name);
    exit(1);
}

/* forces at this gap (negative: pressed) and rate of the gap, of row c; slip in the plane */
static void place(int c, double gap, double rate, double slip_x, double slip_y)
{
    w.b.gap[c] = gap;
    w.b.distance[c] = 2e-3 + gap;
    w.b.overlap[c] = gap < 0.0 ? -gap : 0.0;
    w.b.touching[c] = gap < 0.0 ? 1.0 : 0.0;
    w.b.vn[c] = w.b.distance_rate[c] = rate;
    w.b.sx[c] = slip_x, w.b.sy[c] = slip_y;
    w.b.kn[c] = w.b.kt[c] = w.b.eta[c] = w.b.fn[c] = w.b.fx[c] = w.b.fy[c] = w.b.fz[c] =
        w.b.stored[c] = w.b.lost[c] = 0.0;
    w.b.adhesive_force[c] = w.b.scratch[c] = 0.0;
}

static void evaluate(void)
{
    for (int k = 0; k < w.effects; k++)
    {
        struct impacts_effect *const l = &w.effect_entry[k];

        if (l->effect->set_adhesion)
        {
            l->effect->set_adhesion(l->settings, &w.b, l->history);
        }
        l->effect->apply(l->settings, &w.b, l->history);
        for (int m = 0;
             l->effect->stage < DEM_STAGE_BOND && l->effect->history && l->effect->history[m]; m++)
        {
            for (int c = 0; c < DEM_BATCH_ROWS; c++)
            {
                l->column[m][c] *= w.b.touching[c];
            }
        }
    }
}

/* Random gaps, and slips if requested, separated at the end; smallest and largest work of all rows,
   over the scale of force times displacement. */
static void closed_paths(double slips, double apart, double *least, double *greatest)
{
    double gap[DEM_BATCH_ROWS], work[DEM_BATCH_ROWS] = {0}, force[DEM_BATCH_ROWS][3];
    double scale = 0.0;

    *least = 1e300, *greatest = -1e300;
    for (int c = 0; c < DEM_BATCH_ROWS; c++)
    {
        gap[c] = apart;
    }
    for (int leg = 0; leg < LEGS; leg++)
    {
        for (int s = 0; s <= STEPS; s++)
        {
            for (int c = 0; c < DEM_BATCH_ROWS; c++)
            {
                const double to =
                    leg == LEGS - 1 ? apart : apart - (apart + deepest)*drawn(c, leg, 0);
                const double from = leg == 0 ? apart
                                             : apart - (apart + deepest)*drawn(c, leg - 1, 0),
                             rate = (to - from)/(STEPS*dt);
                const double angle = 6.28*drawn(c, leg, 1),
                             slip = s ? slips*drawn(c, leg, 2)/(STEPS*dt) : 0.0;

                gap[c] = from + (to - from)*s/STEPS;
                place(c, gap[c], rate, slip*cos(angle), slip*sin(angle));
            }
            evaluate();
            for (int c = 0; c < DEM_BATCH_ROWS; c++)
            {
                /* the first force of a leg is evaluated at its own rate, without displacement */
                work[c] -= s ? 0.5*dt*
                                   ((force[c][0] + w.b.fn[c])*w.b.distance_rate[c] +
                                    (force[c][1] + w.b.fx[c])*w.b.sx[c] +
                                    (force[c][2] + w.b.fy[c])*w.b.sy[c])
                             : 0.0;
                force[c][0] = w.b.fn[c], force[c][1] = w.b.fx[c], force[c][2] = w.b.fy[c];
                scale = fmax(scale, fabs(w.b.fn[c])*deepest);
            }
        }
    }
    for (int c = 0; c < DEM_BATCH_ROWS; c++)
    {
        *least = fmin(*least, work[c]/scale);
        *greatest = fmax(*greatest, work[c]/scale);
    }
}

static const struct dem_effect *of_stage(enum dem_stage stage, int k)
{
    for (const struct dem_effect *const *e = dem_effects; *e; e++)
    {
        if ((*e)->stage == stage && k-- == 0)
        {
            return *e;
        }
    }
    return NULL;
}

/* error of the trapezoidal rule at kinks and jumps, about 12 of 1/500 of a leg each */
static const double kinks = 1e-3;

static void pressed(void)
{
    const struct dem_effect *normal;
    double least, greatest;

    for (int n = 0; (normal = of_stage(DEM_STAGE_NORMAL, n)); n++)
    {
        start();
        add(normal);
        closed_paths(0.0, 5e-6, &least, &greatest);
        if (normal->history)
        {
            TAP_OK(least > 0.0, "%s: %d paths take work, %.2g or more of force times displacement",
                   normal->name, DEM_BATCH_ROWS, least);
        }
        else
        {
            TAP_NEAR(fmax(-least, greatest), 0.0, kinks, "%s: %d paths give zero work",
                     normal->name, DEM_BATCH_ROWS);
        }
        for (int k = 0; of_stage(DEM_STAGE_DAMP, k); k++)
        {
            start();
            add(normal);
            add(of_stage(DEM_STAGE_DAMP, k));
            closed_paths(0.0, 5e-6, &least, &greatest);
            TAP_OK(least > 0.0 && greatest > kinks, "%s, %s: all take work, %.2g or more",
                   normal->name, of_stage(DEM_STAGE_DAMP, k)->name, least);
        }
    }
}

static void adhesive(void)
{
    double least, greatest;

    start();
    add(&dem_hertz);
    add(&dem_sjkr);
    closed_paths(0.0, 5e-6, &least, &greatest);
    TAP_NEAR(fmax(-least, greatest), 0.0, kinks, "hertz, sjkr: zero work");
    start();
    add(&dem_hertz);
    add(&dem_jkr);
    closed_paths(0.0, 3e-5, &least, &greatest);
    TAP_OK(least > -kinks && greatest > kinks, "hertz, jkr, separated: take work, %.2g or more",
           least);
}

static void sheared(void)
{
    static const struct dem_effect *const pair[2][2] = {{&dem_hooke, &dem_linear},
                                                        {&dem_hertz, &dem_mindlin_incremental}};

    for (int k = 0; k < 2; k++)
    {
        for (int fine = 0; fine < 2; fine++)
        {
            const double way = fine ? 2e-7 : 2e-5;        /* mostly sticks; mostly slips */
            double least, greatest;

            start();
            add(pair[k][0]);
            add(pair[k][1]);
            closed_paths(way, 5e-6, &least, &greatest);
            TAP_OK(least > -kinks*way/deepest && greatest > 0.0,
                   "%s, %s, sheared by up to %g m a leg: take work, %.2g or more", pair[k][0]->name,
                   pair[k][1]->name, way, least);
        }
    }
}

int main(void)
{
    TAP_TRAPS;
    pressed();
    adhesive();
    sheared();
    TAP_DONE;
}
