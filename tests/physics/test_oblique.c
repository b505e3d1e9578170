/*
 * test_oblique.c -- oblique impacts of unlike materials, with Hertz-Mindlin and with linear springs,
 * have the angles of rebound that were measured, and the results of MFiX-DEM for its DEM05.
 * test_chung_ooi.c has the same impacts against an integration of the laws.
 *
 * Sources: Kharaz, Gorham, Salman, Powder Technol. 120 (2001) 281 (5 mm aluminium oxide on glass,
 * 3.9 m/s); Garg, Galvin, Li, Pannala, Powder Technol. 220 (2012) 122.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

enum
{
    MOST = 40
};

static const double radius = 0.0025, density = 4000.0, speed = 3.9;

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
            (struct dem_new_particle){
                .position = {0.0, 4.0*radius*k, radius + speed*cos(angle)*phase},
                .diameter = 2.0*radius, .velocity = {speed*sin(angle), 0.0, -speed*cos(angle)},
                .id = k, .material = "oxide"};
    }
    return world(world_text(
        "%s effects { %s } time { step %.17g; }"
        "walls { plate { type plane; material glass; point (0 0 0); normal (0 0 1); } }",
        materials, laws, step), rows, seed);
}

static const char mindlin[] = "hertz { impactSpeed 4; } mindlin { friction 0.092; }";
static const char linear[] =
    "hooke { stiffness 1.72e7; } linear { friction 0.092; stiffness 1.48e7; }";

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

int main(void)
{
    TAP_TRAPS;
    measured("mindlin", mindlin);
    measured("linear", linear);
    mfix();
    TAP_DONE;
}
