/*
 * test_chung_ooi.c -- tests 4 to 8 of Chung and Ooi: oblique impacts with every law of friction
 * and damping agree with an independent integration and with the published values.
 *
 * Sources: Chung and Ooi, Granul. Matter 13 (2011) 643; chung_ooi.csv by oblique_impacts.py.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

enum
{
    COLUMNS = 9, ROWS = 400, MOST = 24
};

static const char *const friction[3] = {"mindlin", "mindlinIncremental", "linear"};

/* of one test, of each of its two materials */
struct set
{
    double radius, density[2], E[2], nu[2], mu, e, speed;
};

static const struct set sets[3] = {
    {0.0025, {4000, 2700}, {380e9, 70e9}, {0.23, 0.33}, 0.092, 0.98, 3.9},
    {1e-5, {7850, 1400}, {208e9, 1e9}, {0.30, 0.40}, 0.3, 1.0, 5.0},
    {0.1, {2700, 1000}, {70e9, 2.5e9}, {0.33, 0.40}, 0.4, 0.5, 0.2},
};

/* N/m of a linear spring that yields as far as Hertz's on a rigid plane at the set's speed */
static double stiffness(const struct set *s, int material)
{
    const double m = world_sphere_mass(s->radius, s->density[material]),
                 E = s->E[material]/(1.0 - s->nu[material]*s->nu[material]);
    const double deepest = pow(15.0*m*s->speed*s->speed/(16.0*E*sqrt(s->radius)), 0.4);

    return m*(s->speed/deepest)*(s->speed/deepest);
}

static double contact_time(const struct set *s, int material)
{
    const double E = s->E[material]/(1.0 - s->nu[material]*s->nu[material]);

    return world_contact_time(world_sphere_mass(s->radius, s->density[material]), s->radius, E,
                              s->speed);
}

/* n spheres over z = 0, a quarter of a step and more above it; motion in x and z, spin about y */
static struct dem *launch_all(const struct set *s, int material, int law, const char *damping,
                              int n, const double *row, double step)
{
    struct dem_new_particle seed[MOST];
    char normal[64] = "hertz { impactSpeed 1; }";

    memset(seed, 0, sizeof seed);
    for (int k = 0; k < n; k++)
    {
        const double *const r = row + COLUMNS*k,
                            phase = (k*0.618033988749895 - floor(k*0.618033988749895))*step;

        seed[k] = (struct dem_new_particle){
            .position = {0.0, 4.0*s->radius*k, s->radius + r[3]*phase}, .diameter = 2.0*s->radius,
            .velocity = {r[4], 0.0, -r[3]}, .spin = {0.0, r[5], 0.0}, .id = k, .material = "ball"};
    }
    if (law == 2)
    {
        snprintf(normal, sizeof normal, "hooke { stiffness %.17g; }", stiffness(s, material));
    }
    return world(world_text(
        "materials { ball { density %g; youngsModulus %g; poissonsRatio %g; } rigid { density 1;"
        "youngsModulus 1e30; } } effects { %s %s %s { friction %g; } } time { step %.17g; }"
        "walls { plate { type plane; material rigid; point (0 0 0); normal (0 0 1); } }",
        s->density[material], s->E[material], s->nu[material], normal, damping, friction[law],
        s->mu, step), n, seed);
}

/* ---- tests 4 to 6 against the independent integration ---------------------------------------- */

static void sweep(int test, int material, int law, int n, const double *row)
{
    const struct set *const s = &sets[test - 4];
    const double step = contact_time(s, material)/2000.0;
    char damping[64] = "";
    double speed = 0.0, spin = 0.0, normal = 0.0;

    if (s->e < 1.0)
    {
        snprintf(damping, sizeof damping, "dry { restitution %g; }", s->e);
    }
    struct dem *const d = launch_all(s, material, law, damping, n, row, step);

    /* 1.63 t_c at 85 degrees, 1.1 t_c with the dashpot */
    world_run(d, 3600*step);
    TAP_OK(world_tally(d).contacts == 0, "test %d, material %d, %s: all have separated", test,
           material + 1, friction[law]);
    for (int k = 0; k < n; k++)
    {
        const double *const r = row + COLUMNS*k;
        const struct world_particle p = world_at(d, k);
        /* largest change of speed and spin by friction, in full sliding */
        const double able = s->mu*(1.0 + s->e)*r[3];

        speed = fmax(speed, fabs(p.v[0] - r[7])/able);
        spin = fmax(spin, fabs(p.w[1] - r[8])*s->radius/(2.5*able));
        normal = fmax(normal, fabs(p.v[2] - r[6])/r[3]);
    }
    /* whole steps at both ends of the contact and a dashpot of first order: 1/2000 each, times the
       oscillations of the friction spring in it (a ratio of 2 k_t/k_n, so up to pi sqrt(7 k_t/2
       k_n) = 5) */
    TAP_NEAR(speed, 0.0, 3e-3, "test %d, material %d, %s: %d tangential speeds", test, material + 1,
             friction[law], n);
    TAP_NEAR(spin, 0.0, 3e-3, "test %d, material %d, %s: and spins", test, material + 1,
             friction[law]);
    TAP_NEAR(normal, 0.0, 5e-4, "test %d, material %d, %s: and normal speeds", test, material + 1,
             friction[law]);
    dem_free(d);
}

static int group(const double *table, int rows, int test, int material, int law, double *out)
{
    int n = 0;

    for (int k = 0; k < rows; k++)
    {
        const double *const r = table + COLUMNS*k;

        if ((int)r[0] == test && (int)r[1] == material + 1 && (int)r[2] == law + 1 && n < MOST)
        {
            memcpy(out + COLUMNS*n++, r, COLUMNS*sizeof *r);
        }
    }
    return n;
}

static void against_integration(void)
{
    static double table[ROWS*COLUMNS], row[MOST*COLUMNS];
    const int rows = world_table("physics/chung_ooi.csv", COLUMNS, ROWS, table);

    TAP_OK(rows == 282, "%d rows in chung_ooi.csv", rows);
    for (int g = 0; g < 18; g++)
    {
        const int test = 4 + g/6, material = g/3%2, law = g%3;

        sweep(test, material, law, group(table, rows, test, material, law, row), row);
    }
}

/* ---- against published values ---------------------------------------------------------------- */

/* one impact on the plane; *pushed: normal impulse of repulsion [N s], summed over the steps */
static struct world_particle one(const struct set *s, int material, int law, const char *damping,
                                 double vn, double vt, double w, double *pushed)
{
    const double step = contact_time(s, material)/1000.0, row[COLUMNS] = {0, 0, 0, vn, vt, w};
    struct dem *const d = launch_all(s, material, law, damping, 1, row, step);

    *pushed = 0.0;
    for (int k = 0; k < 12000 && (k < 10 || world_tally(d).contacts > 0); k++)
    {
        world_step(d);
        *pushed += fmax(world_at(d, 0).f[2], 0.0)*step;
    }
    const struct world_particle p = world_at(d, 0);

    dem_free(d);
    return p;
}

static void published_4(const double *t)
{
    const double a = t[1]*world_pi/180.0;
    double pushed;
    const struct world_particle p =
        one(&sets[0], 0, 0, "dry { restitution 0.98; }", 3.9*cos(a), 3.9*sin(a), 0.0, &pushed);
    /* from 30 degrees on it slides throughout, and only reading the figures adds an error, 1 % of
       the largest value; below, laws of friction differ between slip and stick: 3 % */
    const double share = t[1] >= 30.0 ? 1e-2 : 3e-2;

    TAP_NEAR(p.v[0]/(3.9*sin(a)), t[2], share, "test 4, %g degrees: e_t %.4f, published %.4f",
             t[1], p.v[0]/(3.9*sin(a)), t[2]);
    TAP_NEAR(p.w[1], t[3], share*616.5, "test 4, %g degrees: spin %.1f, published %.1f", t[1],
             p.w[1], t[3]);
}

static void published_5(const double *t, int law)
{
    const double vn = 5.0, mu = 0.3, R = 1e-5;
    double pushed;
    const struct world_particle p = one(&sets[1], 0, law, "", vn, t[1]*mu*vn, 0.0, &pushed);
    const double slip = (p.v[0] - R*p.w[1])/(mu*p.v[2]), spin = -R*p.w[1]/(mu*vn);

    /* rigid: x - 7 and -5. The published points are 0.013 from that; the lever is shorter by 0.5 %
       of 5 on the mean of an impact (0.8176 of the largest overlap, 0.64 % of the radius); at x = 6
       the last 0.02 of slip load the spring (0.981 in the independent integration) */
    TAP_NEAR(slip, t[2], 0.06, "test 5, %s, v_t/(mu v_n) = %g: slip %.3f, published %.3f",
             friction[law], t[1], slip, t[2]);
    TAP_NEAR(spin, t[3], 0.06, "test 5, %s, v_t/(mu v_n) = %g: spin %.3f, published %.3f",
             friction[law], t[1], spin, t[3]);
    if (t[1] >= 7.0)
    {
        TAP_NEAR(slip, t[1] - 7.0, 0.03, "test 5, %s, v_t/(mu v_n) = %g: rigid", friction[law],
                 t[1]);
    }
}

/* the published points lie on the line of the friction impulse mu m (1 + e) v_n; while the dashpot
   attracts at the end there is no friction, so the repulsive impulse is 1.067 of it here */
static void published_6(const double *t, int law)
{
    const struct set *const s = &sets[2];
    const double slip = 3.5*s->mu*1.5*s->speed/t[1],
                 m = world_sphere_mass(s->radius, s->density[0]);
    double pushed;
    const struct world_particle p =
        one(s, 0, law, "dry { restitution 0.5; }", s->speed, 0.0, slip/s->radius, &pushed);
    const double beta = -(s->radius*p.w[1] - p.v[0])/slip, rigid = 3.5*s->mu*pushed/m/slip - 1.0;

    /* the lever is shorter than R by 0.03 %; a step or two of sticking at the first touch */
    TAP_NEAR(beta, rigid, 1e-3,
             "test 6, %s, x = %g: beta %.4f is 7/2 mu of the normal impulse over the slip, less 1",
             friction[law], t[1], beta);
    /* these 6.7 %, and 0.01 of reading */
    TAP_NEAR(beta, t[2], 0.067*t[1] + 0.01, "test 6, %s, x = %g: published %.3f", friction[law],
             t[1], t[2]);
}

static void against_publication(void)
{
    double table[64*4];
    const int rows = world_table("physics/chung_ooi_published.csv", 4, 64, table);

    TAP_OK(rows == 19, "%d published points", rows);
    for (int k = 0; k < rows; k++)
    {
        const double *const t = table + 4*k;

        for (int law = 0; law < 3; law++)
        {
            if (t[0] == 4.0 && law == 0)
            {
                published_4(t);
            }
            else if (t[0] == 5.0)
            {
                published_5(t, law);
            }
            else if (t[0] == 6.0)
            {
                published_6(t, law);
            }
        }
    }
}

/* ---- the friction impulse -------------------------------------------------------------------- */

static void impulses(void)
{
    static const char *const damping[] = {"",
                                          "dry { restitution 0.5; }",
                                          "dry { restitution 0.5; attraction clamped; }",
                                          "viscous { coefficient 3000; }",
                                          "viscous { coefficient 3000; attraction clamped; }",
                                          "stokesDamping { restitution 0.97; viscosity 3; }"};
    const struct set *const s = &sets[2];
    const double m = world_sphere_mass(s->radius, s->density[0]);

    for (int c = 0; c < 6; c++)
    {
        for (int law = 0; law < 3; law++)
        {
            for (int k = 0; k < 2; k++)
            {
                const double x = k ? 0.6 : 0.184, slip = 3.5*s->mu*1.5*s->speed/x;
                double pushed;
                const struct world_particle p =
                    one(s, 0, law, damping[c], s->speed, 0.0, slip/s->radius, &pushed);

                /* a step or two of sticking at the first touch */
                TAP_NEAR(m*p.v[0]/(s->mu*pushed), 1.0, 1e-3,
                         "%s, %s, x = %g: the friction impulse is mu times the normal impulse",
                         damping[c][0] ? damping[c] : "no damping", friction[law], x);
            }
        }
    }
}

/* ---- tests 7 and 8: two spheres -------------------------------------------------------------- */

/* spheres 0 and 1 meet along x; radii 0.1 and `larger`, the second `heavier` and stiffer;
   velocities along x, spins about y */
static void meet(const char *law, const double material[3], double larger, double heavier,
                 double v0, double v1, double w0, double w1, struct world_particle p[2])
{
    struct dem_new_particle seed[2];
    const double E = material[1]/(1.0 - material[2]*material[2]),
                 m = world_sphere_mass(0.1, material[0]);
    /* no softer than a pair of the first */
    const double step = world_contact_time(0.5*m, 0.05, 0.5*E, v0 - v1)/1000.0;

    memset(seed, 0, sizeof seed);
    seed[0] = (struct dem_new_particle){
        .position = {-0.1 - 0.3*step*(v0 - v1), 0, 0}, .velocity = {v0, 0, 0}, .spin = {0, w0, 0},
        .diameter = 0.2, .material = "a"};
    seed[1] = (struct dem_new_particle){
        .position = {larger, 0, 0}, .velocity = {v1, 0, 0}, .spin = {0, w1, 0},
        .diameter = 2.0*larger, .id = 1, .material = "b"};
    struct dem *const d = world(world_text(
        "materials { a { density %g; youngsModulus %g; poissonsRatio %g; } b { density %g; "
        "youngsModulus %g;"
        "poissonsRatio %g; } } effects { %s dry { restitution 0.5; } } time { step %.17g; }",
        material[0], material[1], material[2], heavier*material[0], heavier*material[1],
        material[2], law, step), 2, seed);

    for (int k = 0; k < 12000 && (k < 10 || world_tally(d).contacts > 0); k++)
    {
        world_step(d);
    }
    world_all(d, p);
    dem_free(d);
}

static void matching_spins(void)
{
    static const double metals[2][3] = {{2700, 70e9, 0.33}, {8900, 120e9, 0.35}},
                        spins[] = {0.175, 1.4, 7.46, 22.86};

    for (int k = 0; k < 24; k++)
    {
        const int law = k%3, metal = k/3%2;
        const double w = spins[k/6];
        struct world_particle p[2];
        char words[96];

        snprintf(words, sizeof words, "%s %s { friction 0.4; }",
                 law == 2 ? "hooke { stiffness 1e9; }" : "hertz { }", friction[law]);
        meet(words, metals[metal], 0.1, 1.0, 0.2, -0.2, w, -w, p);
        /* the points of contact move alike: no slip; rounding of spin times radius, and of the
           spring */
        TAP_NEAR(fmax(fabs(p[0].w[1] - w), fabs(p[1].w[1] + w)), 0.0, 1e-12*w,
                 "test 7, metal %d, %s: spins %g stay", metal + 1, friction[law], w);
        TAP_NEAR(fabs(p[0].v[2]) + fabs(p[1].v[2]), 0.0, 1e-13, "test 7: no velocity across");
        /* one phase of contact: a step of 1/1000 more or less, of 0.4 m/s */
        TAP_NEAR(p[1].v[0] - p[0].v[0], 0.2, 4e-4, "test 7: they separate with half the speed");
    }
}

/* -slip after/slip before is the same function of x as in test 6: friction knows 2/7 m*, pressure
   m* */
static void heavy_partner(const double *table, int rows)
{
    static double row[MOST*COLUMNS];

    for (int g = 0; g < 8; g++)
    {
        const int law = g%2, material = g/2%2, real = g/4;
        const struct set *const s = &sets[2];
        const double stuff[3] = {s->density[material], s->E[material], s->nu[material]};
        const int n = group(table, rows, 6, material, law, row);
        double worst = 0.0;

        for (int k = 0; k < n; k += 2)
        {
            const double *const r = row + COLUMNS*k, w = r[5];
            struct world_particle p[2];
            char words[64];

            snprintf(words, sizeof words, "hertz { } %s { friction 0.4; }", friction[law]);
            meet(words, stuff, 0.5, real ? 1.0 : 1000.0, 0.2, 0.0, w, 0.0, p);
            /* spin about +y, the partner towards +x: the point of contact moves along -z */
            const double slip = p[0].v[2] - p[1].v[2] - 0.1*p[0].w[1] - 0.5*p[1].w[1],
                         beta = slip/(0.1*w);
            const double plane = -(0.1*r[8] - r[7])/(0.1*w);

            worst = fmax(worst, fabs(beta - plane)*w*0.1/(3.5*s->mu*1.5*s->speed));
        }
        /* as in the sweeps; besides, the line of centres rotates by 1e-4, and the lever arms are
           shorter by another 1e-3 */
        TAP_NEAR(worst, 0.0, 5e-3, "test 8%s, material %d, %s: %d spins as on a plane",
                 real ? "b" : "a", material + 1, friction[law], (n + 1)/2);
    }
}

int main(void)
{
    static double table[ROWS*COLUMNS];

    TAP_TRAPS;
    against_integration();
    against_publication();
    impulses();
    matching_spins();
    heavy_partner(table, world_table("physics/chung_ooi.csv", COLUMNS, ROWS, table));
    TAP_DONE;
}
