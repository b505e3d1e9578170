/*
 * test_roll.c -- a sliding sphere begins to roll when and as fast as a rigid one does, on a plane,
 * on triangles and down a slope (DEM04 of the MFiX-DEM suite).
 *
 * Sources: Garg, Galvin, Li, Pannala, Powder Technol. 220 (2012) 122; slip_to_roll.csv, exact for a
 * rigid sphere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/mesh.h"
#include "physics/world.h"

enum
{
    CASES = 9, COLUMNS = 6
};

static const double R = 5e-4, density = 1e4, u0 = 0.1, g = 9.80665, E = 1e7;

/* overlap at which a Hertzian contact with a rigid floor (nu 0.3) carries the weight */
static double rest_overlap(double pull)
{
    const double modulus = E/(1.0 - 0.09);

    return pow(0.75*world_sphere_mass(R, density)*pull/(modulus*sqrt(R)), 2.0/3.0);
}

/* One material a case: the same ball, its own friction with the floor. */
static void list_materials(const double *table, char *materials, char *pairs, size_t capacity)
{
    size_t m = 0, p = 0;

    for (int k = 0; k < CASES; k++)
    {
        m += (size_t)snprintf(materials + m, capacity - m,
                              "b%d { density %g; youngsModulus %g; poissonsRatio 0.3; }", k,
                              density, E);
        p += (size_t)snprintf(pairs + p, capacity - p,
                              "p%d { between (b%d rigid); mindlin { friction %g; } }", k, k,
                              table[COLUMNS*k]);
    }
}

static struct dem *start(const double *table, const char *wall, const char *tangential)
{
    static const char *const names[CASES] = {"b0", "b1", "b2", "b3", "b4", "b5", "b6", "b7", "b8"};
    struct dem_new_particle seed[CASES];
    char materials[2048], pairs[2048];

    memset(seed, 0, sizeof seed);
    list_materials(table, materials, pairs, sizeof pairs);
    for (int k = 0; k < CASES; k++)
    {
        seed[k] = (struct dem_new_particle){
            .position = {0.0, 4.0*R*k, R - rest_overlap(g)}, .velocity = {u0, 0.0, 0.0},
            .diameter = 2.0*R, .id = k, .material = names[k]};
    }
    struct dem_case *const c = world_begin(world_text(
        "materials { %s rigid { density 1; youngsModulus 1e30; } } "
        "effects { hertz { impactSpeed 0.1; }"
        "dry { restitution 0.9; } mindlin { friction 0.1; "
        "%s } gravity { acceleration (0 0 -%.17g); } }"
        "pairs { %s } %s",
        materials, tangential, g, pairs, wall));

    if (!wall[0])
    {
        mesh_add_floor(c, "floor", "rigid", -4.0*R, 40.0*R, 3.0*R);
    }
    WORLD_TRY(dem_case_add_particles(c, CASES, seed));
    return world_start(c);
}

/* Times at which slip ends: where the straight line through its last step crosses zero. */
static void slip_ends(struct dem *d, double until, double ends[CASES])
{
    double before[CASES];
    const double step = dem_step_limit(d).used;

    for (int k = 0; k < CASES; k++)
    {
        before[k] = u0;
        ends[k] = 0.0;
    }
    for (int64_t s = 1; (double)s*step < until; s++)
    {
        world_step(d);
        for (int k = 0; k < CASES; k++)
        {
            const struct world_particle p = world_at(d, k);
            const double slip = p.v[0] - p.w[1]*R;

            ends[k] = ends[k] == 0.0 && slip <= 0.0
                          ? ((double)s - 1.0 + before[k]/(before[k] - slip))*step
                          : ends[k];
            before[k] = slip;
        }
    }
}

static void slip_to_roll(const double *table, const char *wall, const char *what)
{
    struct dem *const d = start(table, wall, "");
    double ends[CASES];

    slip_ends(d, 0.018, ends);
    for (int k = 0; k < CASES; k++)
    {
        const double *const t = table + COLUMNS*k;
        const struct world_particle p = world_at(d, k);

        /* the friction spring of E = 1e7 elongates by some 1e-8 m, less than 1e-3 of the slip */
        TAP_NEAR(ends[k], t[2], 5e-3*t[2], "%s, mu %g: slips for %.4f ms", what, t[0], 1e3*ends[k]);
        TAP_NEAR(p.v[0], t[3], 5e-3*t[3], "%s, mu %g: then rolls at %.5f m/s", what, t[0], p.v[0]);
        TAP_NEAR(p.w[1], t[4], 5e-3*t[4], "%s, mu %g: with a forward spin of %.3f 1/s", what,
                 t[0], p.w[1]);
        /* an error of the normal force or of the plane's direction would show here */
        TAP_NEAR(fabs(p.v[1]) + fabs(p.v[2]), 0.0, 1e-9, "%s, mu %g: no velocity across or normal", what,
                 t[0]);
    }
    dem_free(d);
}

/* Down a slope of 20 degrees: the plane z = 0, gravity is inclined. */
static void slope(double friction, double acceleration, const char *what)
{
    const double angle = 20.0*world_pi/180.0, time = 0.05;
    const struct dem_new_particle seed = {
        .position = {0.0, 0.0, R - rest_overlap(g*cos(angle))}, .diameter = 2.0*R, .material = "b"};
    struct dem *const d = world(world_text(
        "materials { b { density %g; youngsModulus %g; poissonsRatio 0.3; }"
        "rigid { density 1; youngsModulus 1e30; } } effects { hertz { impactSpeed 0.1; }"
        "dry { restitution 0.9; } mindlin { friction %g; }"
        "gravity { acceleration (%.17g 0 %.17g); } } walls { floor { type plane; material rigid;"
        "point (0 0 0); normal (0 0 1); } }",
        density, E, friction, g*sin(angle), -g*cos(angle)), 1, &seed);

    world_run(d, time);
    const struct world_particle p = world_at(d, 0);

    /* the spring elongates before it holds: some 10 us of 50 ms */
    TAP_NEAR(p.v[0], acceleration*time, 2e-3*acceleration*time, "%s on a slope: %.5f m/s",
             what, p.v[0]);
    dem_free(d);
}

int main(void)
{
    static const char plane[] =
        "walls { floor { type plane; material rigid; point (0 0 0); normal (0 0 1); } }";
    const double angle = 20.0*world_pi/180.0;
    double table[CASES*COLUMNS];

    if (!TAP_OK(world_table("physics/slip_to_roll.csv", COLUMNS, CASES, table) == CASES,
                "nine frictions in slip_to_roll.csv"))
    {
        TAP_DONE;
    }
    TAP_TRAPS;
    slip_to_roll(table, plane, "plane");
    slip_to_roll(table, "", "triangles");
    slope(0.5, 5.0/7.0*g*sin(angle), "rolling");
    slope(0.05, g*(sin(angle) - 0.05*cos(angle)), "sliding");
    TAP_DONE;
}
