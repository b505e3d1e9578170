/*
 * test_oblique.c -- oblique impacts on a plane and of pairs, with Hertz-Mindlin and with linear
 * springs.
 *
 * - In full sliding the tangential speed and spin agree with rigid sliding, below it with a
 *   sticking Hertz-Mindlin contact. The spin has the sign of rolling.
 * - Two equal spheres of opposite spin keep it; spheres of like spin exchange mu times the normal
 *   impulse. Angular momentum is conserved.
 * - Angles of rebound agree with the measurement, and with the results of MFiX-DEM for its DEM05
 *   within the tolerance of its authors.
 *
 * Sources: Kharaz, Gorham, Salman, Powder Technol. 120 (2001) 281 (5 mm aluminium oxide on glass,
 * 3.9 m/s); tests 4 and 7 of Chung and Ooi, Granul. Matter 13 (2011) 643.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

enum
{
    COLUMNS = 4, MOST = 40
};

static const double radius = 0.0025, density = 4000.0, friction = 0.092, speed = 3.9;

static const char materials[] =
    "materials { oxide { density 4000; youngsModulus 380e9; poissonsRatio 0.23; }"
    " glass { density 2500; youngsModulus 70e9; poissonsRatio 0.25; } }";

/* contact time of oxide on glass at this normal speed: 1/E* from both materials */
static double contact_time(double normal_speed)
{
    const double modulus = 1.0/((1.0 - 0.23*0.23)/380e9 + (1.0 - 0.25*0.25)/70e9);

    return world_contact_time(world_sphere_mass(radius, density), radius, modulus, normal_speed);
}

/* One sphere for each angle, all in one scene, from above onto z = 0, towards +x. */
static struct dem *launch_all(const char *laws, const double *table, int columns, int rows,
                             double step)
{
    struct dem_new_particle seed[MOST];

    memset(seed, 0, sizeof seed);
    for (int k = 0; k < rows; k++)
    {
        const double angle = table[columns*k]*world_pi/180.0;
        const double phase = (k*0.618033988749895 - floor(k*0.618033988749895))*step;

        seed[k] =
            (struct dem_new_particle){.position = {0.0, 4.0*radius*k,
                                                   radius + speed*cos(angle)*phase},
                                      .diameter = 2.0*radius,
                                      .velocity = {speed*sin(angle), 0.0, -speed*cos(angle)},
                                      .id = k,
                                      .material = "oxide"};
    }
    char *const scene =
        world_text("%s effects { %s } time { step %.17g; }"
                   "walls { plate { type plane; material glass; point (0 0 0); normal (0 0 1); } }",
                   materials, laws, step);
    struct dem *const d = world(scene, rows, seed);

    free(scene);
    return d;
}

static const char mindlin[] = "hertz { impactSpeed 4; } mindlin { friction 0.092; }";
static const char linear[] =
    "hooke { stiffness 1.72e7; } linear { friction 0.092; stiffness 1.48e7; }";

/* mean of the overlap of an impact, weighted with the force: over its largest, 0.5 Gamma(1.4)
   Gamma(0.5)/Gamma(1.9) of Hertz, pi/4 of a linear spring */
static double mean_overlap(const char *laws, double mass, double modulus, double normal)
{
    return laws == linear ? 0.25*world_pi*normal*sqrt(mass/1.72e7)
                          : 0.8176*pow(15.0*mass*normal*normal/(16.0*modulus*sqrt(radius)), 0.4);
}

static void kharaz(const char *name, const char *laws)
{
    double table[COLUMNS*MOST];
    const double modulus = 1.0/((1.0 - 0.23*0.23)/380e9 + (1.0 - 0.25*0.25)/70e9);
    const int rows = world_table(name, COLUMNS, MOST, table);
    const double step = contact_time(speed)/400.0;
    struct dem *const d = launch_all(laws, table, COLUMNS, rows, step);

    /* the slowest strikes at 5 degrees from grazing: (1/cos 85)^(1/5) = 1.63 times as long */
    world_run(d, 2.0*contact_time(speed));
    TAP_OK(rows == 26 && world_tally(d).contacts == 0, "%d angles, all have separated", rows);
    for (int k = 0; k < rows; k++)
    {
        const double *const t = table + COLUMNS*k;
        const double angle = t[0]*world_pi/180.0;
        const struct world_particle p = world_at(d, k);
        const double et = p.v[0]/(speed*sin(angle)), rebound = atan2(p.v[0], p.v[2])*180.0/world_pi;

        /* from 30 degrees on it slides all the way: exact except for the step. Sticking depends on the
           law of the spring between slip and stick: 2 %; near the normal the speed is a difference
           of small numbers, 2 % of e_t = 1. */
        const double share = t[0] >= 30.0 ? 3e-3 : 2e-2;

        /* the contact point lies on the wall, so the lever arm is shorter than R by the overlap */
        const double normal = speed*cos(angle),
                     lever =
                         t[0] >= 30.0 ? 1.0 - mean_overlap(laws, p.mass, modulus, normal)/radius : 1.0;
        /* in sticking, the spin depends on the oscillation of the spring: 2 % of rolling */
        const double spin = t[0] >= 30.0 ? share*t[2] : share*fmax(t[2], speed*sin(angle)/radius);

        TAP_NEAR(et, t[1], share*t[1], "%g degrees: e_t %.4f", t[0], et);
        if (t[0] >= 7.5)
        {
            TAP_NEAR(p.w[1], lever*t[2], spin,
                     "%g degrees: spin %.2f 1/s about +y, as of rolling", t[0], p.w[1]);
            TAP_NEAR(rebound, t[3], share*t[3], "%g degrees: leaves at %.3f degrees", t[0],
                     rebound);
        }
        if (t[0] >= 30.0)
        {
            /* rigid sliding: v_t' = v_t - mu (1 + e) v_n, w' = 5/2 mu (1 + e) v_n/R, with e = 1; a
               small elongation is left at separation, and the step adds 1e-4 */
            const double impulse = 2.0*friction*normal;

            TAP_NEAR(p.v[0], speed*sin(angle) - impulse, 3e-4*p.v[0],
                     "%g degrees: mu times the normal impulse", t[0]);
            TAP_NEAR(p.w[1], 2.5*impulse*lever/radius, 3e-4*p.w[1],
                     "%g degrees: the moment of this impulse", t[0]);
        }
        TAP_NEAR(fabs(p.v[1]) + fabs(p.w[0]) + fabs(p.w[2]), 0.0, 1e-12*speed,
                 "%g degrees: stays in its plane", t[0]);
    }
    dem_free(d);
}

/* Root mean square of the distance from the measured points, between 20 and 60 degrees. */
static void measured(const char *name, const char *laws)
{
    double table[3*64], point[2*64] = {0}, square = 0.0;
    const double step = contact_time(speed)/400.0;
    const int rows = world_table("physics/kharaz_measured.csv", 3, 64, table);
    int n = 0;

    for (int k = 0; k < rows; k++)
    {
        if (table[3*k] == 1.0 && table[3*k + 1] > 20.0 && table[3*k + 1] < 60.5)
        {
            memcpy(point + 2*n++, table + 3*k + 1, 2*sizeof *point);
        }
    }
    struct dem *const d = launch_all(laws, point, 2, n, step);

    world_run(d, 2.0*contact_time(speed));
    for (int k = 0; k < n; k++)
    {
        const struct world_particle p = world_at(d, k);
        const double off = atan2(p.v[0], p.v[2])*180.0/world_pi - point[2*k + 1];

        square += off*off/n;
    }
    /* the figures read to half a degree; e is 1 here and 0.98 there, half a degree at 45 */
    TAP_OK(n == 5 && sqrt(square) < 1.5,
           "%s: rebounds %.2f degrees from the measured ones (root mean square of %d)", name,
           sqrt(square), n);
    dem_free(d);
}

/* MFiX-DEM's own output: angle; e_t, spin, angle of rebound with Hertz's law; e_t with linear
   springs */
static void mfix(void)
{
    static const double table[][5] = {
        {5, 0.940, 20.3, 4.702, 0.798}, {10, 0.690, 208.4, 6.940, 0.656},
        {20, 0.6150, 510.5, 12.618, 0.595},  {25, 0.6343, 599.5, 16.477, 0.622},
        {30, 0.6813, 618.4, 21.472, 0.6813}, {45, 0.8160, 505.3, 39.214, 0.8160},
        {60, 0.8938, 357.7, 57.139, 0.8938},
    };
    const double step = contact_time(speed)/400.0;

    for (int law = 0; law < 2; law++)
    {
        struct dem *const d = launch_all(law ? linear : mindlin, table[0], 5, 7, step);

        world_run(d, 2.0*contact_time(speed));
        for (int k = 0; k < 7; k++)
        {
            const double *const t = table[k], angle = t[0]*world_pi/180.0;
            const struct world_particle p = world_at(d, k);
            const double et = p.v[0]/(speed*sin(angle));

            /* MFiX-DEM takes fewer steps a contact; its suite requires 5 %; sticking impacts differ
               by 1 to 2 %, sliding is exact */
            TAP_NEAR(et, t[law ? 4 : 1], (t[0] >= 30.0 ? 2e-3 : 2e-2)*et,
                     "%g degrees, %s: e_t %.4f as with MFiX-DEM", t[0], law ? "linear" : "mindlin",
                     et);
            if (law == 0)
            {
                TAP_NEAR(p.w[1], t[2], 1e-2*599.5, "%g degrees: spin %.1f, MFiX-DEM %.1f", t[0],
                         p.w[1], t[2]);
                TAP_NEAR(atan2(p.v[0], p.v[2])*180.0/world_pi, t[3], 2e-2*t[3],
                         "%g degrees: rebound as with MFiX-DEM", t[0]);
            }
        }
        dem_free(d);
    }
}

/* Two equal aluminium spheres, head-on at 0.2 m/s each, along x; spins about y. Returns the impulse
   of repulsion [N s], without the attraction at the end of the damped contact. */
static double spinning_pair(double w0, double w1, struct world_particle p[2])
{
    const double R = 0.1, v = 0.2, m = world_sphere_mass(R, 2700.0), modulus = 0.5*70e9/(1.0 - 0.33*0.33);
    const double time = world_contact_time(0.5*m, 0.5*R, modulus, 2.0*v);
    struct dem_new_particle seed[2] = {{.position = {-R - 1e-7, 0, 0},
                                        .velocity = {v, 0, 0},
                                        .spin = {0, w0, 0},
                                        .material = "al"},
                                       {.position = {R, 0, 0},
                                        .velocity = {-v, 0, 0},
                                        .spin = {0, w1, 0},
                                        .id = 1,
                                        .material = "al"}};

    seed[0].diameter = seed[1].diameter = 2.0*R;
    char *const scene =
        world_text("materials { al { density 2700; youngsModulus 70e9; poissonsRatio 0.33; } }"
                   "effects { hertz {} dry { restitution 0.5; } mindlin { friction 0.4; } }"
                   "time { step %.17g; }",
                   time/400.0);
    struct dem *const d = world(scene, 2, seed);

    double pushed = 0.0;

    for (int k = 0; k < 1200; k++)
    {
        world_step(d);
        pushed += fmax(-world_at(d, 0).f[0], 0.0)*time/400.0;
    }
    TAP_OK(world_tally(d).contacts == 0, "spins %g and %g: separated", w0, w1);
    p[0] = world_at(d, 0);
    p[1] = world_at(d, 1);
    free(scene);
    dem_free(d);
    return pushed;
}

static double angular(const struct world_particle *p)
{
    const double inertia = 0.4*p->mass*p->radius*p->radius;

    return inertia*p->w[1] + p->mass*(p->x[2]*p->v[0] - p->x[0]*p->v[2]);
}

static void pairs(void)
{
    struct world_particle p[2];

    spinning_pair(8.0, -8.0, p);
    /* the contact points move alike: no slip; round-off of spin times radius */
    TAP_NEAR(p[0].w[1], 8.0, 1e-11, "opposite spins do not change");
    TAP_NEAR(p[1].w[1], -8.0, 1e-11, "opposite spins do not change, second sphere");
    TAP_NEAR(p[0].v[2], 0.0, 1e-12, "opposite spins: no velocity across");
    for (double w = 8.0; w < 40.0; w *= 2.0)
    {
        const double pushed = spinning_pair(w, w, p);
        const double change = w - p[0].w[1], rigid = 2.5*0.4*pushed/(p[0].mass*0.1);
        const double before = 2.0*0.4*p[0].mass*0.01*w;

        /* the lever arm is shorter than R by half the overlap, 60 um of 100 mm; the centres move
           past each other by as much */
        TAP_NEAR(change, rigid, 2e-3*rigid,
                 "like spins %g: mu times the normal impulse changes the spin by %.4f", w, change);
        TAP_NEAR(p[0].v[2], 0.4*0.1*change, 2e-3*p[0].v[2], "like spins: velocity across by the same impulse");
        TAP_NEAR(angular(&p[0]) + angular(&p[1]), before, 1e-12*before, "angular momentum is kept");
    }
}

int main(void)
{
    TAP_TRAPS;
    kharaz("physics/oblique_kharaz.csv", mindlin);
    kharaz("physics/oblique_kharaz_linear.csv", linear);
    measured("mindlin", mindlin);
    measured("linear", linear);
    mfix();
    pairs();
    TAP_DONE;
}
