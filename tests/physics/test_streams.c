/*
 * test_streams.c -- streams insert the number, mass, sizes, positions and velocities that are due;
 * outlets keep the balance; ids are unique.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"
#include "dem_numbers.h"

#define BEADS "materials { glass { density 2500; youngsModulus 1e5; } } effects { hertz { } dry { restitution 0.9; } %s } " \
              "time { step 1e-5; } "
#define FALL "gravity { acceleration (0 0 -9.81); }"

/* s: streams are evaluated in the last of its 32 steps */
static const double window = 32e-5;

static struct dem_flow flow(struct dem *d, int k)
{
    return world_flow(d, k);
}

/* windows of 32 steps */
static void run_windows(struct dem *d, int n)
{
    for (int k = 0; k < n; k++)
    {
        world_run(d, window);
    }
}

static struct dem *stream(const char *effects, const char *groups)
{
    return world(world_text(BEADS "%s", effects, groups), 0, NULL);
}

/* the smallest gap of any two [m] */
static double min_gap(const struct dem *d)
{
    struct dem_view v;
    double least = INFINITY;

    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        for (size_t j = 0; j < i; j++)
        {
            double square = 0.0;

            for (int k = 0; k < 3; k++)
            {
                const double apart =
                    dem_at(v.position, v.stride, i)[k] - dem_at(v.position, v.stride, j)[k];

                square += apart*apart;
            }
            least = fmin(least, sqrt(square) - *dem_at(v.radius, v.stride, i) -
                                    *dem_at(v.radius, v.stride, j));
        }
    }
    return least;
}

/* ---- number ---------------------------------------------------------------------------------- */

static void test_rate(void)
{
    struct dem *const d = stream(
        "",
        "insert { feed { type stream; rate 3000; start 0.01; end 0.05; diameter 1e-3; "
        "min (0 0 0); max (0.1 0.1 0.1); } } ");
    int exact = 1;

    for (int k = 1; k <= 250; k++)
    {
        run_windows(d, 1);
        const double owed = 3000.0*(fmin(world_tally(d).time, 0.05) - 0.01);

        /* round-off of time */
        exact &= flow(d, 0).particles == (int64_t)floor(fmax(0.0, owed) + 1e-9);
    }
    TAP_OK(exact, "by number: the whole number due, at each of 250 checks");
    TAP_OK(flow(d, 0).particles == 120, "3000 a second in 0.04 s are 120, found %lld",
           (long long)flow(d, 0).particles);
    TAP_OK(world_tally(d).particles == 120 && world_tally(d).inserted == 120,
           "all of them are present");
    dem_free(d);
}

static void test_mass_rate(void)
{
    struct dem *const d = stream(
        "",
        "insert { feed { type stream; massRate 5e-3; sizes { type uniform; min 1e-3; max 2e-3; } "
        "min (0 0 0); "
        "max (0.2 0.2 0.2); } } ");
    const double largest = 2500.0*world_pi/6.0*8e-9;
    int exact = 1;

    for (int k = 0; k < 100; k++)
    {
        run_windows(d, 1);
        const double behind = 5e-3*world_tally(d).time - flow(d, 0).mass;

        exact &= behind > -1e-6*largest && behind < largest;
    }
    TAP_OK(exact, "by mass: never above the mass due, and below it by less than one particle");
    /* round-off of 1e-4 kg */
    TAP_NEAR(world_tally(d).mass, flow(d, 0).mass, 1e-14, "the mass present is the mass inserted");
    TAP_OK(flow(d, 0).particles > 20, "these are %lld particles", (long long)flow(d, 0).particles);
    dem_free(d);
}

static void test_limits(void)
{
    struct dem *d = stream(
        "",
        "insert { few { type stream; rate 1e4; count 17; diameter 1e-3; min (0 0 0); "
        "max (0.1 0.1 0.1); } "
        "heap { type stream; massRate 1; mass 1e-4; diameter 1e-3; min (0 0 0.2); "
        "max (0.1 0.1 0.3); } } ");

    run_windows(d, 40);
    TAP_OK(flow(d, 0).particles == 17 && flow(d, 0).waiting == 0,
           "a limit of 17 inserts 17, none waits");
    TAP_NEAR(flow(d, 1).mass, 1e-4, 0.5*2500.0*world_pi/6.0*1e-9,
             "a limit of mass is met to half a particle");
    dem_free(d);
}

/* ---- sizes and positions --------------------------------------------------------------------- */

static void test_sizes(void)
{
    static const char sizes[] =
        "sizes { type logNormal; median 1e-3; deviation 0.3; by volume; } seed 5; min (0 0 0); "
        "max (0.007 0.007 0.007);";
    enum {MOST = 400};
    static double expected[MOST];
    char text[1024];
    struct dem_view v;
    int same = 1;

    snprintf(text, sizeof text, "insert { all { type random; count %d; %s } }", (int)MOST, sizes);
    struct dem *d = stream("", text);

    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        expected[world_id(&v, i)] = *dem_at(v.radius, v.stride, i);
    }
    dem_free(d);
    /* far more than fit: most wait, large ones longest */
    snprintf(text, sizeof text,
             "insert { feed { type stream; rate 1e8; count %d; %s velocity (3 0 0); } }", (int)MOST,
             sizes);
    d = stream("", text);
    run_windows(d, 1);
    TAP_OK(flow(d, 0).waiting > 0 && flow(d, 0).waiting + flow(d, 0).particles == MOST, "%lld wait",
           (long long)flow(d, 0).waiting);
    run_windows(d, 40);
    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        same &= *dem_at(v.radius, v.stride, i) == expected[world_id(&v, i)];
    }
    TAP_OK(v.n == MOST && same,
           "all %zu are inserted in the end, and number k has the diameter of number k of a group",
           v.n);
    dem_free(d);
}

static void test_full_region(void)
{
    struct dem *d = stream(
        "",
        "insert { still { type lattice; count 300; diameter 1e-3; min (0 0 0); "
        "max (0.01 0.01 0.01); } "
        "feed { type stream; rate 1e6; diameter 0.7e-3; min (0 0 0); max (0.01 0.01 0.01); } } ");

    run_windows(d, 3);
    TAP_OK(flow(d, 0).particles > 50 && flow(d, 0).waiting > 0,
           "into a bed %lld are inserted, then it is full and %lld wait",
           (long long)flow(d, 0).particles, (long long)flow(d, 0).waiting);
    TAP_OK(min_gap(d) >= 0.0, "no overlap");
    TAP_OK((double)(flow(d, 0).particles + flow(d, 0).waiting) ==
               floor(1e6*world_tally(d).time + 1e-9),
           "those inserted and those waiting are those due");
    dem_free(d);
}

/* the smallest distance of a surface from the sphere and the plane below */
static double min_clearance(const struct dem *d)
{
    struct dem_view v;
    double least = INFINITY;

    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        const double *const x = dem_at(v.position, v.stride, i),
                            radius = *dem_at(v.radius, v.stride, i);
        const double away =
            sqrt(pow(x[0] - 0.005, 2.0) + pow(x[1] - 0.005, 2.0) + pow(x[2] - 0.005, 2.0)) - 0.003;

        least = fmin(least, fmin(away, x[2] - 0.002) - radius);
        least = fmin(least, fabs(x[0] - 0.008) - radius);
    }
    return least;
}

static void test_walls(void)
{
    struct dem *const d = stream(
        "",
        "walls { floor { type plane; point (0 0 0.002); normal (0 0 1); } "
        "ball { type sphere; centre (0.005 0.005 0.005); radius 0.003; particles outside; } "
        "sheet { type triangles; corners ((0.008 -1 -1) (0.008 2 -1) (0.008 0 3)); } } "
        "insert { feed { type stream; rate 1e6; diameter 1e-3; min (0 0 0); "
        "max (0.01 0.01 0.01); } } ");

    run_windows(d, 2);
    TAP_OK(world_tally(d).particles > 100,
           "%lld between a plane, a sphere and a sheet of triangles",
           (long long)world_tally(d).particles);
    TAP_OK(min_clearance(d) >= 0.0, "they touch no wall and are not behind one");
    dem_free(d);
}

/* A disc: all centres within its radius, and as far past it as they fly in the time since they may
   have come. */
static void test_face(void)
{
    struct dem *const d = stream(
        "",
        "insert { feed { type stream; rate 2e4; diameter 1e-3; disc { centre (0 0 0.1); "
        "normal (0 0 1); radius 0.02; } "
        "velocity (0 0 -2); } } ");
    struct dem_view v;
    double lowest = INFINITY, highest = -INFINITY, widest = 0.0, late = 0.0;

    run_windows(d, 25);
    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        const double *const x = dem_at(v.position, v.stride, i);

        lowest = fmin(lowest, x[2]);
        highest = fmax(highest, x[2]);
        widest = fmax(widest, hypot(x[0], x[1]));
        late += (0.1 - x[2])/2.0;
    }
    const double time = world_tally(d).time;

    TAP_OK(widest <= 0.02 && widest > 0.019, "all within the disc, %g m", widest);
    TAP_OK(highest <= 0.1 && lowest >= 0.1 - 2.0*time,
           "between the disc and the largest distance below it");
    /* uniform in [0, time]: mean time/2, within 4 standard errors */
    TAP_NEAR(late/(double)v.n, 0.5*time, 4.0*time/sqrt(12.0*(double)v.n),
             "uniform along the velocity, without layers");
    dem_free(d);
}

/* A disc closer to the top of the domain than its radius: it has no height, so it is inside. */
static void test_near_top(void)
{
    struct dem *const d = stream(
        "",
        "domain { min (-0.05 -0.05 0); max (0.05 0.05 0.1); } insert { feed { type stream; "
        "rate 1e4; diameter 1e-3; "
        "disc { centre (0 0 0.099); normal (0 0 1); radius 0.02; } velocity (0 0 -1); } } ");

    run_windows(d, 20);
    TAP_OK(flow(d, 0).particles + flow(d, 0).waiting == 64 && flow(d, 0).particles > 50,
           "near the top of the domain: %lld", (long long)flow(d, 0).particles);
    dem_free(d);
}

/* ---- velocity -------------------------------------------------------------------------------- */

/* One particle, at a known position and time, then a parabola: the leapfrog is exact under constant
   acceleration, in any windows. */
static void test_free_fall(void)
{
    static const char one[] =
        "insert { one { type stream; rate 1000; count 1; diameter 1e-3; min (-5e-4 -5e-4 -5e-4); "
        "max (5e-4 5e-4 5e-4); "
        "velocity (1 0 2); spin (0 30 0); } } ";

    for (int windows = 1; windows <= 7; windows += 6)
    {
        struct dem *const d = stream(FALL, one);

        world_run(d, windows*64e-5);
        world_run(d, 0.05);
        /* the first step of 32 at which 1000 t is 1 */
        const double t = world_tally(d).time - 128e-5;
        const struct world_particle p = world_at(d, 0);

        /* round-off of 0.05 */
        TAP_NEAR(p.x[0], t, 1e-14, "position x, %s",
                 windows == 1 ? "a window begins after it" : "it enters within a window");
        TAP_NEAR(p.x[2], 2.0*t - 0.5*9.81*t*t, 1e-14, "position z");
        TAP_NEAR(p.v[2], 2.0 - 9.81*t, 1e-13, "velocity z");   /* of thousands of kicks */
        TAP_OK(p.w[1] == 30.0, "spin");
        dem_free(d);
    }
}

/* Drag relaxes the velocity, v = u + (v0 - u) exp(-t/tau): the start between two kicks keeps second
   order. */
static void test_drag(void)
{
    const double tau = 2500.0*1e-6/(18.0*1e-3);
    double error[2];

    for (int fine = 0; fine < 2; fine++)
    {
        struct dem *const d = world(world_text(
            "materials { glass { density 2500; youngsModulus 1e5; } } "
            "effects { hertz { } stokesDrag { } } "
            "fluid { density 1; viscosity 1e-3; velocity (0 0 1); pressureGradient (0 0 0); } "
            "time { step %g; } "
            "insert { one { type stream; rate 1000; count 1; diameter 1e-3; "
            "min (-5e-4 -5e-4 -5e-4); max (5e-4 5e-4 5e-4); "
            "velocity (2 0 0); } }",
            fine ? 0.5e-5 : 1e-5), 0, NULL);

        world_run(d, 0.05);
        const double t = world_tally(d).time - (fine ? 112e-5 : 128e-5);

        error[fine] = fabs(world_at(d, 0).x[0] - 2.0*tau*(1.0 - exp(-t/tau))) +
                      fabs(world_at(d, 0).v[0] - 2.0*exp(-t/tau));
        dem_free(d);
    }
    /* (h/tau)^2/24 of 2 m/s is 4e-10 */
    TAP_OK(error[0] < 1e-8, "relaxes to the fluid's velocity, error %g", error[0]);
    TAP_OK(error[1] < 0.3*error[0] || error[0] < 1e-12,
           "a quarter of the error at half the step, %g", error[1]);
}

/* ---- outlets, balances ----------------------------------------------------------------------- */

static void test_balance(void)
{
    struct dem *const d = stream(
        FALL,
        "insert { feed { type stream; rate 4e4; diameter 1e-3; disc { centre (0 0 0.05); "
        "normal (0 0 1); radius 0.02; } "
        "velocity (0.2 0 -1); spread (0.3 0.3 0.2); } } "
        "outlets { below { point (0 0 0); normal (0 0 -1); } aside { min (0.01 -1 0.01); "
        "max (1 1 0.03); } } ");
    double weight[3] = {0.0, 0.0, 0.0}, worst = 0.0, seen = -1.0;
    int64_t twice = 0;
    int balanced = 1;

    for (int k = 0; k < 300; k++)
    {
        const struct dem_totals before = world_tally(d);

        run_windows(d, 1);
        const struct dem_totals t = world_tally(d);
        const struct dem_flow in = flow(d, 0), below = flow(d, 1), aside = flow(d, 2);
        struct dem_view v;

        /* particles are inserted and removed at the ends of these windows */
        weight[2] -= 9.81*before.mass*(t.time - before.time);
        for (int a = 0; a < 3; a++)
        {
            const double found = t.momentum[a] - (in.momentum[a] - below.momentum[a] -
                                                  aside.momentum[a] + weight[a]);

            worst = fmax(worst, fabs(found));
        }
        balanced &= t.particles == in.particles - below.particles - aside.particles &&
                    t.inserted == in.particles && t.removed == below.particles + aside.particles;
        balanced &= fabs(t.mass - (in.mass - below.mass - aside.mass)) < 1e-15;
        dem_view(d, &v);
        for (size_t i = 0; i < v.n; i++)
        {
            const double *const x = dem_at(v.position, v.stride, i);

            balanced &= x[2] >= 0.0 && !(x[0] >= 0.01 && x[2] >= 0.01 && x[2] <= 0.03);
            seen = fmax(seen, (double)world_id(&v, i));
            twice += i > 0 && world_id(&v, i) == world_id(&v, i - 1);
        }
    }
    const struct dem_totals t = world_tally(d);

    TAP_OK(balanced,
           "particles present are those inserted less those removed, none in an outlet, at 300 "
           "checks");
    TAP_OK(flow(d, 1).particles > 100 && flow(d, 2).particles > 100,
           "%lld removed below, %lld at the side", (long long)flow(d, 1).particles,
           (long long)flow(d, 2).particles);
    TAP_OK(twice == 0 && seen == (double)(flow(d, 0).particles - 1),
           "ids are consecutive, none is used twice");
    /* round-off of 300 windows of 32 kicks each, 2e-16 of 1e-3 kg m/s a kick at most */
    TAP_OK(worst < 1e4*2e-16*t.mass,
           "momentum is that inserted less that removed plus the impulse of gravity, error %.2g of "
           "%.2g kg m/s",
           worst, t.mass);
    dem_free(d);
}

/* ---- copies, patches ------------------------------------------------------------------------- */

/* A particle leaves the domain in the step in which 32 are inserted, so the run returns to its
   backup, which has none of them. */
static void test_back(void)
{
    struct dem *const d = world(world_text(
        BEADS
        "domain { min (0 0 0); max (1 1 1); } outlets { o { min (0.25 0.25 0.25); "
        "max (0.35 0.35 0.35); } } insert { "
        "shot { type list; diameter 1e-3; positions ((0.5 0.5 0.9972)); velocity (0 0 10); } "
        "outgoing { type list; diameter 1e-3; positions ((0.3 0.3 0.3)); } "
        "feed { type stream; rate 1e5; start 0.0003; diameter 1e-3; min (0.1 0.1 0.1); "
        "max (0.4 0.4 0.2); } } ",
        ""), 0, NULL);
    struct dem_view v;
    double time;
    int64_t twice = 0;

    WORLD_TRY(dem_backup_every(d, 0));
    TAP_OK(dem_advance(d, 1e-3) != 0, "a particle leaves while others are inserted: %s",
           dem_error_text());
    WORLD_TRY(dem_restore(d, &time));
    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        ((double *)dem_at(v.velocity, v.stride, i))[2] = 0.0;
    }
    world_run(d, 1e-3);
    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        for (size_t j = 0; j < i; j++)
        {
            twice += world_id(&v, i) == world_id(&v, j);
        }
    }
    TAP_OK(flow(d, 0).particles == 66 && v.n == 67 && flow(d, 1).particles == 1,
           "after the backup %lld are inserted, one is removed, %zu are present",
           (long long)flow(d, 0).particles, v.n);
    TAP_OK(twice == 0, "no id is used twice, found %lld", (long long)twice);
    dem_free(d);
}

/* Two spheres of 2 mm, apart, have the volume of one of 2 mm cbrt(2). */
static void test_info(void)
{
    struct dem *const d = stream("",
        "parcels { ratio 8; }"
        "insert { a { type stream; rate 1; sizes { type uniform; min 1e-3; max 2e-3; } min (0 0 0); max (1 1 1); } } ");
    struct dem *const clumps = stream("",
        "shapes { pair { spheres ((-2e-3 0 0 1e-3) (2e-3 0 0 1e-3)); } }"
        "insert { a { type stream; rate 1; shape pair; min (0 0 0); max (1 1 1); } } ");
    struct dem_stream_info s;

    TAP_OK(dem_stream_info(d, 0, &s) == 1 && !dem_stream_info(d, 1, &s), "a stream");
    dem_stream_info(d, 0, &s);
    TAP_OK(fabs(s.min_diameter - 1e-3) < 1e-18 && fabs(s.max_diameter - 2e-3) < 1e-18,
           "of parcels: diameters of the grains");
    TAP_NEAR(s.volume_rate, 512.0*world_pi/6.0*3.75e-9, 1e-12, "of parcels: their volume");
    dem_free(d);
    dem_stream_info(clumps, 0, &s);
    TAP_NEAR(s.max_diameter, 2e-3*cbrt(2.0), 1e-15, "of clumps: the diameter of the sphere of the same volume");
    TAP_OK(s.min_diameter == s.max_diameter, "of clumps: one diameter");
    dem_free(clumps);
}

/* A particle starts a thousandth of its radius behind the patch; at 1 mm/s it crosses half of that
   in 0.5 ms. */
static void test_patch(void)
{
    static const double corners[18] = {0.0, 0.0, 0.0, 0.0, 0.1, 0.0, 0.1, 0.0, 0.0,
                                       0.1, 0.1, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0};
    struct dem_case *const c = world_begin(
        "materials { glass { density 2500; youngsModulus 1e5; } } "
        "effects { hertz { } dry { restitution 0.9; } } "
        "time { step 1e-5; } domain { min (0 0 0); max (0.1 0.1 0.1); } "
        "insert { feed { type stream; rate 1e4; "
        "diameter 2e-3; patch inlet; velocity (0 0 1e-3); } }");
    int changed;

    WORLD_TRY(dem_case_flows_on_request(c));
    WORLD_TRY(dem_case_add_patch(c, "inlet", 2, corners, NULL));
    struct dem *const d = world_start(c);

    for (int k = 0; k < 50; k++)
    {
        WORLD_TRY(dem_flow_apply(d, &changed));
        WORLD_TRY(dem_advance(d, 5e-4));
    }
    TAP_OK(flow(d, 0).particles + flow(d, 0).waiting == 245 && flow(d, 0).waiting == 0,
           "slow through a patch: 49 times 5 inserted, found %lld",
           (long long)flow(d, 0).particles);
    dem_free(d);
}

/* Sent aside by up to 2 m/s, beads could fly through the plates of a channel, or a rod in it, before the first check after they
   entered. Each is where its line from the inlet leads without meeting them, or still on the inlet. */
static void test_aside(void)
{
    static const double corners[18] = {0.0, 0.5e-3, 0.0,  0.0, 0.5e-3, 8e-3,  0.0, 3.5e-3, 8e-3,
                                       0.0, 0.5e-3, 0.0,  0.0, 3.5e-3, 8e-3,  0.0, 3.5e-3, 0.0};
    static const double r = 0.1e-3, rod[3] = {2.5e-3, 2e-3, 0.6e-3};                     /* x, y, radius */
    struct dem_case *c;
    struct dem *d;
    struct dem_view v;
    int changed, beyond = 0, through = 0, overlapping = 0, begun = 0;
    int64_t before = 0;
    double momentum = 0.0;

    WORLD_TRY(dem_case_create(&c, MPI_COMM_NULL));
    WORLD_TRY(dem_case_flows_on_request(c));
    WORLD_TRY(dem_case_scene_text(c, "materials { glass { density 2500; youngsModulus 2e7; } } effects { hertz { impactSpeed 3; } dry { restitution 0.5; } } walls { "
                             "plates { type triangles; corners ((0 0 -0.01) (0.02 0 -0.01) (0.02 0 0.02)  (0 0 -0.01) (0.02 0 0.02) (0 0 0.02)  "
                             "(0 0.004 -0.01) (0.02 0.004 -0.01) (0.02 0.004 0.02)  (0 0.004 -0.01) (0.02 0.004 0.02) (0 0.004 0.02)); } "
                             "rod { type cylinder; point (0.0025 0.002 0); axis (0 0 1); radius 0.6e-3; particles outside; } } "
                             "outlets { end { point (0.004 0 0); normal (1 0 0); } } "
                             "insert { feed { type stream; rate 2e4; diameter 0.2e-3; patch inlet; velocity (1.2 0 0); spread (0.6 2 0); } }", "aside"));
    WORLD_TRY(dem_case_add_patch(c, "inlet", 2, corners, NULL));
    WORLD_TRY(dem_start(&c, &d));
    for (int k = 0; k < 25; k++)
    {
        WORLD_TRY(dem_flow_apply(d, &changed));
        dem_view(d, &v);
        for (size_t i = 0; i < v.n; i++)
        {
            const double *const x = dem_at(v.position, v.stride, i), *const u = dem_at(v.velocity, v.stride, i);
            const double ago = x[0]/u[0], y = x[1] - ago*u[1], a = x[0] - rod[0], b = x[1] - rod[1];
            const double t = fmin(ago, fmax(0.0, (a*u[0] + b*u[1])/(u[0]*u[0] + u[1]*u[1])));

            if (world_id(&v, i) >= before)
            {
                beyond += x[1] < 0.0 || x[1] > 4e-3 || y < 0.49e-3 || y > 3.51e-3;
                through += hypot(a - t*u[0], b - t*u[1]) < rod[2];
                overlapping += x[1] < r || x[1] > 4e-3 - r || hypot(a, b) < rod[2] + r;
                begun += x[0] < 1e-6;
                momentum += 2500.0*world_pi/6.0*8e-12*u[0];
            }
        }
        before = flow(d, 0).particles;
        WORLD_TRY(dem_advance(d, 2e-3));
    }
    TAP_OK(before == 960 && flow(d, 0).waiting == 0, "sent aside: %lld beads entered of 960 due", (long long)before);
    TAP_OK(beyond == 0, "none came through a plate, found %d", beyond);
    TAP_OK(through == 0, "none came through the rod, found %d", through);
    TAP_OK(overlapping == 0, "none overlaps a wall, found %d", overlapping);
    TAP_OK(begun > 50 && begun < 480, "%d begin on the inlet", begun);
    TAP_OK(fabs(flow(d, 0).momentum[0] - momentum) < 1e-12*momentum, "their momentum is counted");
    TAP_OK(world_tally(d).particles == 960 - flow(d, 1).particles, "all are there or went out");
    dem_free(d);
}

/* ---- stiff drag, other units, fluid of the caller -------------------------------------------- */

/* b h/m = 90: integrating backwards by exp(45) would lose all digits. */
static void test_heavy(void)
{
    struct dem *const d = world(world_text(
        "materials { glass { density 2500; youngsModulus 1e5; } } "
        "effects { hertz { } dry { restitution 0.9; } stokesDrag { } } "
        "time { step 5e-7; } fluid { density 1000; viscosity 10; velocity (0 0 1); "
        "voidFraction 1; } insert { "
        "feed { type stream; rate 1e6; diameter 2e-5; min (0 0 0); max (0.01 0.01 0.01); "
        "velocity (2 0 0); } } "), 0, NULL);
    struct dem_view v;
    double worst = 0.0;

    run_windows(d, 1);
    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        const double *const u = dem_at(v.velocity, v.stride, i);

        worst = fmax(worst, fmax(fabs(u[0]), fmax(fabs(u[1]), fabs(u[2] - 1.0))));
    }
    /* round-off of 2 m/s; exp(-45) is far below it */
    TAP_OK(v.n > 200 && worst < 1e-14,
           "%zu in a liquid with a response time below the step have its velocity, error %g m/s",
           v.n, worst);
    dem_free(d);
}

static void test_units(void)
{
    static const char rest[] = "diameter 1e-3; min (0 0 0); max (0.2 0.2 0.2); } } ",
                      file[] = "test_streams.snapshot";
    const double one = 2500.0*world_pi/6.0*1e-9;

    for (int to_mass = 0; to_mass < 2; to_mass++)
    {
        const char *const first = to_mass ? "rate 1e4;" : "massRate 1e-2;",
                          *const second = to_mass ? "massRate 5e-3;" : "rate 5e3;";
        char *text = world_text(BEADS "insert { feed { type stream; %s %s", "", first, rest);
        struct dem *d = world(text, 0, NULL);

        run_windows(d, 20);
        const struct dem_flow before = flow(d, 0);

        WORLD_TRY(dem_save(d, file));
        dem_free(d);
        text = world_text(BEADS "insert { feed { type stream; %s %s", "", second, rest);
        struct dem_case *const c = world_begin(text);

        WORLD_TRY(dem_case_load(c, file));
        d = world_start(c);
        run_windows(d, 20);
        const double owed = 20.0*window*(to_mass ? 5e-3/one : 5e3);

        TAP_OK(before.particles > 40 &&
                   fabs((double)(flow(d, 0).particles - before.particles) - owed) <= 1.0,
               "%s then %s: %lld, then %g are due: %lld", first, second,
               (long long)before.particles, owed, (long long)flow(d, 0).particles);
        dem_free(d);
    }
    remove(file);
}

static void test_own_fluid(void)
{
    struct dem *const d = world(
        "materials { glass { density 2500; youngsModulus 1e5; } } "
        "effects { hertz { } dry { restitution 0.9; } schillerNaumann { } } "
        "time { step 1e-5; } insert { one { type list; diameter 1e-3; positions ((1 1 1)); } "
        "feed { type stream; rate 1e5; diameter 1e-3; min (0.1 0.1 0.1); max (0.4 0.4 0.2); } }",
        0, NULL);
    struct dem_fluid f;

    WORLD_TRY(dem_fluid(d, &f));
    TAP_OK(dem_advance(d, window) != 0 && strstr(dem_error_text(), "dem_case_flows_on_request"),
           "a stream and a fluid of the caller without announcement: %s", dem_error_text());
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    test_rate();
    test_mass_rate();
    test_limits();
    test_sizes();
    test_full_region();
    test_walls();
    test_face();
    test_near_top();
    test_free_fall();
    test_drag();
    test_balance();
    test_back();
    test_info();
    test_patch();
    test_aside();
    test_heavy();
    test_units();
    test_own_fluid();
    TAP_DONE;
}
