/*
 * test_law_energy.c -- laws with a slipping spring store or lose the work of the motion, step by
 * step, to round-off, also where a contact ends.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "law_rows.h"

#include "core/random.h"

enum
{
    LEGS = 8, STEPS = 40
};

static const struct dem_material bead = {"bead", 2500.0, 1e7, .poissons_ratio = 0.3};
static const double dt = 1e-6, deepest = 5e-5, apart = 5e-6;        /* s, m, m */
static struct law_rows w;
static struct dem_energy e;
static struct rows_effect *normal, *law;
static _Alignas(64) double column[ROWS_HISTORY][DEM_BATCH_ROWS];

static const struct known
{
    const struct dem_effect *effect;
    const char *setting;
    /* m or rad: largest displacement of a leg, large enough to slip at times */
    double value, way;
} laws[] = {{&dem_mindlin, "friction", 0.4, 2e-5},
            {&dem_mindlin_incremental, "friction", 0.4, 2e-5},
            {&dem_linear, "friction", 0.4, 2e-5},
            {&dem_linear, "stiffness", 500.0, 2e-5},
            {&dem_rolling_spring, "damping", 0.0, 2e-2},
            {&dem_twisting_spring, "friction", 0.4, 2e-2}};

static double drawn(int row, int leg, int use)
{
    return dem_random_unit(33, (uint64_t)row, (uint64_t)leg, (uint64_t)use);
}

static void start(const struct dem_effect *normal_law, const struct known *k)
{
    rows_spheres(&w, &bead, &bead, 1e-3, 1e-3);
    w.b.n = DEM_BATCH_ROWS;
    w.b.dt = dt;
    for (int c = 0; c < DEM_BATCH_ROWS; c++)
    {
        w.b.reduced_radius[c] = w.pair.min_radius;
        w.b.reduced_mass[c] = w.pair.min_mass;
        w.b.min_radius[c] = 1e-3;
        w.b.nz[c] = w.b.hz[c] = 1.0;
        w.b.overlap[c] = w.b.kn[c] = 0.0;
        e.slip_mass[c] = e.inertia[c] =
            HUGE_VAL;         /* prescribed motion: no force changes it */
    }
    normal = rows_add(&w, normal_law, normal_law == &dem_hooke ? "stiffness" : "impactSpeed",
                         normal_law == &dem_hooke ? 1e3 : 1.0);
    law = rows_add(&w, k->effect, "friction", k->effect == &dem_rolling_spring ? 0.2 : 0.4);
    if (strcmp(k->setting, "friction") != 0)
    {
        apply_setting(k->effect, law->settings, &w.pair, k->setting, k->value);
    }
}

/* advance row c by a step, displaced along x and y or, for moments, rotated about x, y and z */
static void place(int c, double overlap, double x, double y, double z)
{
    e.previous_overlap[c] = w.b.overlap[c];
    e.previous_kn[c] = w.b.kn[c];
    w.b.overlap[c] = overlap > 0.0 ? overlap : 0.0;
    w.b.touching[c] = overlap > 0.0 ? 1.0 : 0.0;
    w.b.sx[c] = w.b.wx[c] = x/dt, w.b.sy[c] = w.b.wy[c] = y/dt, w.b.wz[c] = z/dt;
    w.b.kn[c] = w.b.fn[c] = w.b.fx[c] = w.b.fy[c] = w.b.fz[c] = w.b.mx[c] = w.b.my[c] = w.b.mz[c] =
        0.0;
}

/* as the core's loop over contacts */
static void evaluate(void)
{
    double *before[ROWS_HISTORY];

    memcpy(column, law->column, sizeof column);
    normal->effect->apply(normal->settings, &w.b, normal->history);
    law->effect->apply(law->settings, &w.b, law->history);
    for (int m = 0; m < ROWS_HISTORY; m++)
    {
        before[m] = column[m];
        for (int c = 0; c < DEM_BATCH_ROWS; c++)
        {
            law->column[m][c] *= w.b.touching[c];
        }
    }
    law->effect->energy(law->settings, &w.b, before, law->history, &e);
}

/* Work of this step's force, and of the previous step's. */
static double power(int c, const double f[6])
{
    return -(f[0]*w.b.sx[c] + f[1]*w.b.sy[c] + f[3]*w.b.wx[c] + f[4]*w.b.wy[c] + f[5]*w.b.wz[c])*dt;
}

static void force(int c, double f[6])
{
    const double now[6] = {w.b.fx[c], w.b.fy[c], w.b.fz[c], w.b.mx[c], w.b.my[c], w.b.mz[c]};

    memcpy(f, now, sizeof now);
}

static void closes(const struct dem_effect *normal_law, const struct known *k)
{
    static double f[DEM_BATCH_ROWS][6], held[DEM_BATCH_ROWS];
    double worst = 0.0, scale = 0.0, last = 0.0;

    start(normal_law, k);
    memset(f, 0, sizeof f);
    memset(held, 0, sizeof held);
    for (int leg = 0; leg < LEGS; leg++)
    {
        for (int s = 1; s <= STEPS; s++)
        {
            for (int c = 0; c < DEM_BATCH_ROWS; c++)
            {
                const double to = leg%4 == 3 ? -apart : deepest*drawn(c, leg, 0) - apart;
                const double from =
                    leg == 0 || leg%4 == 0 ? -apart : deepest*drawn(c, leg - 1, 0) - apart;
                const double angle = 6.28*drawn(c, leg, 1), way = k->way*drawn(c, leg, 2)/STEPS;

                place(c, from + (to - from)*s/STEPS, way*cos(angle), way*sin(angle),
                    way*cos(2.0*angle));
            }
            evaluate();
            for (int c = 0; c < DEM_BATCH_ROWS; c++)
            {
                double now[6];

                force(c, now);
                const double gain =
                    0.5*(power(c, f[c]) + power(c, now)) - (e.stored[c] - held[c]) - e.lost[c];

                last += w.b.touching[c] == 0.0 ? e.lost[c] : 0.0;
                worst = fmax(worst, fabs(gain));
                scale = fmax(scale, e.stored[c]);
                held[c] = e.stored[c];
                memcpy(f[c], now, sizeof now);
            }
        }
    }
    /* a hundred roundings of the largest stored energy */
    TAP_OK(worst < 1e-14*scale,
           "%s, %s (%s): residual of a step at most %.2g of the stored energy", normal_law->name,
           k->effect->name, k->setting, worst/scale);
    TAP_OK(last > 0.0, "some contacts end with loaded springs");
}

/* `slip`: over the displacement before */
static void ends_in_one_step(const struct known *k, double slip)
{
    const double way = 1e-3*k->way, twists = k->effect == &dem_twisting_spring ? 1.0 : 0.0,
                 along = 1.0 - twists;

    start(&dem_hertz, k);
    for (int s = 0; s < 10; s++)
    {
        for (int c = 0; c < DEM_BATCH_ROWS; c++)
        {
            place(c, 1e-5, along*0.6*way, along*0.8*way, twists*way);
        }
        evaluate();
    }
    const double held = e.stored[0], stiffness = 2.0*held/(100.0*way*way);
    double f[6];

    force(0, f);
    const double size = sqrt(f[0]*f[0] + f[1]*f[1] + f[2]*f[2] + f[3]*f[3] + f[4]*f[4] + f[5]*f[5]);

    TAP_NEAR(size, stiffness*10.0*way, 1e-13*size, "%s (%s): sticks, and stores k xi^2/2",
             k->effect->name, k->setting);
    for (int c = 0; c < DEM_BATCH_ROWS; c++)
    {
        place(c, -apart, along*0.6*slip*way, along*0.8*slip*way, twists*slip*way);
    }
    evaluate();
    TAP_OK(e.stored[0] == 0.0, "apart it stores no energy");
    TAP_NEAR(e.lost[0], held*(1.0 + 0.1*slip), 1e-13*held,
             "that is lost, plus half of k xi s for a slip of %g of a step", slip);
}

/* `inertia`: mass, or moment of inertia; `critical`: the one to which zeta refers, 0: the dashpot of
   the normal law */
static void damps(const struct known *k, double inertia, double critical)
{
    const double zeta = 0.3, own = 0.01, way = 1e-3*k->way;
    const int twists = k->effect == &dem_twisting_spring;
    double f[6];

    start(&dem_hooke, k);
    if (critical > 0.0)
    {
        apply_setting(k->effect, law->settings, &w.pair, "damping", zeta);
    }
    for (int c = 0; c < DEM_BATCH_ROWS; c++)
    {
        e.slip_mass[c] = e.inertia[c] = inertia;
        w.b.eta[c] = critical > 0.0 ? 0.0 : own;
    }
    for (int s = 0; s < 2; s++)
    {
        for (int c = 0; c < DEM_BATCH_ROWS; c++)
        {
            place(c, 1e-5, twists ? 0.0 : way, 0.0, twists ? way : 0.0);
        }
        evaluate();
    }
    force(0, f);
    const double F = f[0] + f[3] + f[5], v = way/dt, xi = 2.0*way,
                 stiffness = 2.0*e.stored[0]/(xi*xi),
                 c = critical > 0.0 ? 2.0*zeta*sqrt(stiffness*critical) : own;

    TAP_NEAR(F/(-stiffness*xi - c*v), 1.0, 1e-12, "%s: spring and dashpot", k->effect->name);
    /* the last digits of the mean velocity */
    TAP_NEAR(e.lost[0]/(c*v*(v + 0.5*dt*F/inertia)*dt), 1.0, 1e-10, "%s: lost by the dashpot",
             k->effect->name);
}

int main(void)
{
    const double m = 0.5*sphere_mass(1e-3, 2500.0), R = 0.5e-3;

    TAP_TRAPS;
    damps(&laws[3], 2.0/7.0*m, 0.0);
    damps(&laws[4], 1.6*m*R*R, 1.4*m*R*R);
    damps(&laws[5], 1.6*m*R*R, 0.4*m*R*R);
    for (size_t k = 0; k < sizeof laws/sizeof *laws; k++)
    {
        closes(&dem_hooke, &laws[k]);
        closes(&dem_hertz, &laws[k]);
        ends_in_one_step(&laws[k], 0.0);
        ends_in_one_step(&laws[k], -3.0);
        ends_in_one_step(&laws[k], 2.0);
    }
    TAP_DONE;
}
