/*
 * test_flat.c -- with a flat axis all centres stay exactly in the plane, and motion in it has the
 * bits of three dimensions between planes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"

#include "core/random.h"

enum
{
    N = 60, SIDES = 23
};

static const char *const physics =
    "materials { glass { density 2500; youngsModulus 1e6; } }"
    "effects { gravity { acceleration (0 -9.81 %g); } hertz {} dry { restitution 0.8; } "
    "mindlin { friction 0.4; } }"
    "time { step 5e-6; }";

static struct dem_new_particle seed[N];

/* rows in a disc of 12 mm, thrown about, in the plane z = 0.3 mm */
static void fill(void)
{
    for (int i = 0; i < N; i++)
    {
        struct dem_new_particle *const s = &seed[i];

        *s = (struct dem_new_particle){
            .position = {-4.2e-3 + 1.2e-3*(i%8), -4.2e-3 + 1.2e-3*(i/8), 3e-4}, .diameter = 1e-3,
            .id = i, .material = "glass"};
        for (int k = 0; k < 2; k++)
        {
            s->velocity[k] = 0.4*(dem_random_unit(1, (uint64_t)i, 0, (uint64_t)k) - 0.5);
        }
        s->spin[2] = 200.0*(dem_random_unit(1, (uint64_t)i, 0, 2) - 0.5);
    }
}

/* an upright tube with SIDES sides and arbitrary coordinates */
static void add_tube(struct dem_case *made)
{
    double corners[SIDES*2*9];

    for (int s = 0; s < SIDES; s++)
    {
        const double a = 2.0*world_pi*s/SIDES, b = 2.0*world_pi*(s + 1)/SIDES, r = 7.1e-3;
        const double p[4][3] = {{r*cos(a), r*sin(a), -1.3e-3},
                                {r*cos(b), r*sin(b), -1.3e-3},
                                {r*cos(b), r*sin(b), 1.7e-3},
                                {r*cos(a), r*sin(a), 1.7e-3}};
        const int corner[6] = {0, 1, 2, 0, 2, 3};

        for (int k = 0; k < 18; k++)
        {
            corners[18*s + k] = p[corner[k/3]][k%3];
        }
    }
    WORLD_TRY(dem_case_add_wall(made, "tube", "glass", 2*SIDES, corners));
}

static struct dem *tube(const char *domain, double across)
{
    struct dem_case *const c = world_begin(world_text(
        "%s domain { %s }", world_text(physics, across), domain));

    add_tube(c);
    WORLD_TRY(dem_case_enable_energy(c));
    WORLD_TRY(dem_case_add_particles(c, N, seed));
    return world_start(c);
}

/* largest distance from the plane, velocity across it or spin out of it; -1 when particles are
   missing */
static double off_plane(struct dem *d, double plane)
{
    double worst = 0.0;
    struct dem_view v;

    dem_view(d, &v);
    for (int i = 0; i < N; i++)
    {
        const struct world_particle p = world_at(d, i);

        worst += fabs(p.x[2] - plane) + fabs(p.v[2]) + fabs(p.w[0]) + fabs(p.w[1]);
    }
    return v.n == N ? worst : -1.0;
}

/* the largest difference of positions in the plane */
static double apart(struct dem *a, struct dem *b)
{
    double worst = 0.0;

    for (int i = 0; i < N; i++)
    {
        for (int k = 0; k < 2; k++)
        {
            worst = fmax(worst, fabs(world_at(a, i).x[k] - world_at(b, i).x[k]));
        }
    }
    return worst;
}

static void inserts_onto_plane(const char *region, const char *what)
{
    const double low = -9e-4, high = 1.5e-3;
    struct dem *const d = world(
        world_text("%s domain { z (%g %g); flat (z); } insert { mixed { type random; count %d; "
                   "sizes { type uniform; min 5e-4; max 2e-3; } %s } }",
                   world_text(physics, 0.0), low, high, N, region),
        0, NULL);

    TAP_OK(off_plane(d, 0.5*(low + high)) == 0.0 && world_tally(d).largest_overlap == 0.0,
           "random centres in %s lie in the plane, without overlap", what);
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    fill();

    struct dem *const flat = tube("z (-1e-4 7e-4); flat (z);", -5.0);

    world_run(flat, 0.1);
    TAP_OK(off_plane(flat, 0.5*(-1e-4 + 7e-4)) == 0.0,
           "in an irregular tube, with gravity across, all stay exactly in the plane");
    TAP_OK(world_at(flat, 0).x[1] < -3.5e-3, "they have fallen");
    TAP_OK(fabs(energy_term(flat, "residual")) <= 1e-3*fabs(energy_term(flat, "gravity")),
           "the energy balance closes");      /* 1.8e-4, as in three dimensions */

    WORLD_TRY(dem_save(flat, "flat.dem"));
    world_run(flat, 0.02);
    struct dem_case *const c = world_begin(
        world_text("%s domain { z (-1e-4 7e-4); flat (z); }", world_text(physics, -5.0)));

    add_tube(c);
    WORLD_TRY(dem_case_load(c, "flat.dem"));
    struct dem *const again = world_start(c);
    world_run(again, 0.02);
    remove("flat.dem");
    TAP_OK(apart(flat, again) == 0.0, "continues from a snapshot with the same bits");

    /* planes exert no force across: in three dimensions all stay in the plane, too */
    const char *const box = "walls { box { type box; min (-6e-3 -6e-3 -1); max (6e-3 6e-3 1); } }";
    char *const scene = world_text(physics, 0.0);
    struct dem *const two =
        world(world_text("%s %s domain { z (-1e-4 7e-4); flat (z); }", scene, box), N, seed);
    struct dem *const three = world(world_text("%s %s", scene, box), N, seed);

    world_run(two, 0.1);
    world_run(three, 0.1);
    TAP_OK(apart(two, three) == 0.0, "in the plane the same bits as in three dimensions");
    TAP_OK(world_at(two, 0).v[0] != 0.0, "and the spheres do move");

    /* a stream with an inlet thicker than a sphere and scattered velocities */
    struct dem *const stream = world(
        world_text(
            "%s domain { z (-9e-4 1.5e-3); flat (z); } insert { rain { type stream; diameter 1e-3;"
            " count 60; rate 3000; velocity (0.1 -0.3 0); spread (0.02 0.02 0.02); "
            "min (-5e-3 -5e-3 -9e-4); max (5e-3 5e-3 1.5e-3); } }",
            world_text(physics, -5.0)),
        0, NULL);

    world_run(stream, 0.1);
    TAP_OK(off_plane(stream, 0.5*(-9e-4 + 1.5e-3)) == 0.0, "a stream inserts onto the plane");

    /* the thinnest that hold the smallest of them */
    inserts_onto_plane("min (0 0 5e-5); max (0.02 0.02 5.5e-4);", "a box");
    inserts_onto_plane("cylinder { from (0 0 -2e-4); to (0 0 8e-4); radius 0.012; }", "a disc");
    TAP_DONE;
}
