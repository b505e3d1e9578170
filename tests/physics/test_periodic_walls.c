/*
 * test_periodic_walls.c -- walls of triangles at periodic faces are periodic, as particles are:
 * seams cannot be felt, moving walls and restarts included.
 *
 * References: the same surface as a plane; the same surface with the periodic face elsewhere; the
 * same surface in a domain without periodic faces.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"
#include "physics/mesh.h"

static const double R = 1e-3, L = 0.016;                  /* m: radius, period along x */

static const char along_x[] = "x (0 0.016); periodic (x);", apart_faces[] = "x (-1 1);";

static const char plane[] = "walls { f { type plane; point (0 0 0); normal (0 0 1); %s } }";

static char *scene(const char *laws, const char *domain, const char *walls)
{
    return world_text("materials { g { density 2500; youngsModulus 1e7; } }"
                      " effects { hertz {} %s }"
                      " domain { %s } %s time { step 5e-6; }",
                      laws, domain, walls);
}

static const char down[] = "gravity { acceleration (0 0 -9.81); }",
                  rough[] = "gravity { acceleration (0 0 -9.81); } dry { restitution 0.5; }"
                            " mindlin { friction 0.5; }",
                  lean[] = "gravity { acceleration (3 0 -9.3); } dry { restitution 0.5; }"
                           " mindlin { friction 0.5; }";

/* ---- walls as text --------------------------------------------------------------------------- */

/* A wall from a mesh, with corners of `digits` digits. */
static char *wall_of(const struct mesh *m, const char *more, int digits)
{
    char *const text = world_room(200 + 80*m->n*3);
    int at = sprintf(text, "walls { f { type triangles; %s corners (", more);

    for (size_t k = 0; k < 3*m->n; k++)
    {
        at += sprintf(text + at, "(%.*g %.*g %.*g) ", digits, m->corner[3*k], digits,
                      m->corner[3*k + 1], digits, m->corner[3*k + 2]);
    }
    sprintf(text + at, "); } }");
    return text;
}

/* Add the part of a surface between two lines along y. */
static void strip(struct mesh *m, double x0, double z0, double x1, double z1, double half)
{
    const double a[3] = {x0, -half, z0}, b[3] = {x1, -half, z1}, c[3] = {x1, half, z1},
                 d[3] = {x0, half, z0};

    mesh_quad(m, a, b, c, d);
}

static char *flat(double from, double to, const char *more)
{
    struct mesh m = {0};

    strip(&m, from, 0.0, to, 0.0, 0.05);
    char *const text = wall_of(&m, more, 17);

    free(m.corner);
    return text;
}

/* ---- a seam that cannot be felt -------------------------------------------------------------- */

struct result
{
    struct world_particle ball;
    double residual, scale;       /* J */
    uint64_t hash;
};

static struct result roll(const char *text, double duration)
{
    const struct dem_new_particle seed = {
        .position = {0.5*L, 0.0, R}, .velocity = {0.5, 0.0, 0.0}, .diameter = 2.0*R,
        .material = "g"};
    struct dem *const d = energy_world(text, 1, &seed);
    struct result r = {.scale = 0.0};

    world_run(d, duration);
    r.ball = world_at(d, 0);
    r.residual = fabs(energy_term(d, "residual"));
    r.scale = 0.5*r.ball.mass*0.25;
    r.hash = world_hash(d);
    dem_free(d);
    return r;
}

static struct result roll_on(char *walls)
{
    char *const text = scene(rough, along_x, walls);
    const struct result r = roll(text, 0.25);

    return r;
}

static void rolls_as_on_plane(const struct result *expected, char *walls, const char *what)
{
    const struct result r = roll_on(walls);

    TAP_OK(r.hash == expected->hash, "%s: the bits of a plane (%.9g m/s at %.9g m)", what,
           r.ball.v[0], r.ball.x[2]);
    /* 1e-12: round-off of the sums of the balance */
    TAP_NEAR(r.residual/r.scale, expected->residual/r.scale, 1e-12, "%s: energy as on a plane",
             what);
}

/* Ends at both faces, but is cut in three on one side and in two on the other. */
static char *cut_unevenly(void)
{
    struct mesh m = {0};
    const double middle[3] = {0.5*L, 0.0, 0.0};
    double line[9][3] = {{0, -0.01, 0}, {0, -0.003, 0}, {0, 0.004, 0}, {0, 0.01, 0},
                         {L, 0.01, 0}, {L, 0.0, 0}, {L, -0.01, 0}, {0, -0.01, 0}};

    for (int k = 0; k < 7; k++)
    {
        mesh_triangle(&m, line[k], line[k + 1], middle);
    }
    char *const text = wall_of(&m, "", 17);

    free(m.corner);
    return text;
}

/* In several pieces, some beyond the faces. */
static char *in_pieces(void)
{
    struct mesh m = {0};

    strip(&m, -0.3*L, 0.0, 0.2*L, 0.0, 0.01);
    strip(&m, 1.2*L, 0.0, 1.7*L, 0.0, 0.01);
    char *const text = wall_of(&m, "", 17);

    free(m.corner);
    return text;
}

static char *in_single_precision(void)
{
    struct mesh m = {0};

    strip(&m, 0.0, 0.0, 0.3*L, 0.0, 0.01);
    strip(&m, 0.3*L, 0.0, L, 0.0, 0.01);
    for (size_t k = 0; k < 9*m.n; k++)
    {
        m.corner[k] = (float)m.corner[k];
    }
    char *const text = wall_of(&m, "", 17);

    free(m.corner);
    return text;
}

static void test_rolling(void)
{
    const struct result expected = roll_on(world_text(plane, ""));

    /* 5/7 of 0.5 m/s, less what damping takes at first */
    TAP_NEAR(expected.ball.v[0], 0.3571, 2e-4, "a ball rolls on a plane");
    rolls_as_on_plane(&expected, flat(0.0, L, ""), "plate that ends at both faces");
    rolls_as_on_plane(&expected, flat(-0.7*L, 0.3*L, ""), "plate that ends inside the domain");
    rolls_as_on_plane(&expected, flat(-2.0*R, L + 2.0*R, ""), "plate longer than the period");
    rolls_as_on_plane(&expected, flat(-3.3*L, 4.1*L, ""), "plate of many periods");
    rolls_as_on_plane(&expected, flat(-L, 2.0*L, ""), "plate of three whole periods");
    rolls_as_on_plane(&expected, cut_unevenly(), "plate cut in different ways at both faces");
    rolls_as_on_plane(&expected, in_pieces(), "plate of two pieces");
    rolls_as_on_plane(&expected, in_single_precision(), "plate in single precision");
}

/* ---- many grains ----------------------------------------------------------------------------- */

enum
{
    GRAINS = 120
};

static void scatter(struct dem_new_particle *seed, double low)
{
    for (int k = 0; k < GRAINS; k++)
    {
        seed[k] = (struct dem_new_particle){
            .id = k,
            .position = {(k%6 + 0.5)*L/6.0, -0.008 + (k/6%5 + 0.5)*0.016/5.0,
                         low + (k/30 + 0.5)*2.4e-3},
            .velocity = {0.2*mesh_random((uint64_t)k, 1), 0.1*(mesh_random((uint64_t)k, 2) - 0.5), 0.0},
            .diameter = (1.6 + 0.4*mesh_random((uint64_t)k, 3))*1e-3,
            .material = "g"};
    }
}

/* The hash of a flow after 0.1 s; with a file also after a restart at half of it. */
static uint64_t flow(const char *laws, const char *domain, const char *walls, double low,
                     const char *file)
{
    struct dem_new_particle seed[GRAINS];
    char *const text = scene(laws, domain, walls);

    scatter(seed, low);
    struct dem *d = world(text, GRAINS, seed);

    world_run(d, 0.05);
    if (file)
    {
        WORLD_TRY(dem_save(d, file));
        dem_free(d);
        struct dem_case *c = world_begin(text);
        WORLD_TRY(dem_case_load(c, file));
        d = world_start(c);
        remove(file);
    }
    world_run(d, 0.05);
    const uint64_t hash = world_hash(d);

    dem_free(d);
    return hash;
}

static void test_chute(void)
{
    char *const smooth = world_text(plane, ""), *const cut = in_pieces(),
         *const mesh = flat(0.0, L, "");
    const uint64_t expected = flow(lean, "x (0 0.016); y (-0.008 0.008); periodic (x y);", smooth, 0.0, NULL);

    TAP_OK(flow(lean, "x (0 0.016); y (-0.008 0.008); periodic (x y);", mesh, 0.0, NULL) == expected,
           "120 grains on triangles, periodic along x and y: the bits of a plane");
    TAP_OK(flow(lean, "x (0 0.016); y (-0.008 0.008); periodic (x y);", cut, 0.0, NULL) == expected, "also in pieces");
}

/* ---- edges on the face ----------------------------------------------------------------------- */

/* A surface along y; its section is a line through n points (x, z), begun at x = `from`. */
static char *profile(int n, const double (*at)[2], double from, const char *more)
{
    struct mesh m = {0};

    for (int k = 0; k + 1 < n; k++)
    {
        strip(&m, from + at[k][0], at[k][1], from + at[k + 1][0], at[k + 1][1], 0.05);
    }
    char *const text = wall_of(&m, more, 17);

    free(m.corner);
    return text;
}

static const double groove[3][2] = {{0.0, 0.0}, {0.008, 0.0025}, {0.016, 0.0}},
                    steps[3][2] = {{0.0, 0.0}, {0.016, 0.0006}, {0.016, 0.0}};

/* The difference of two positions along x, in the nearest images. */
static double apart(double a, double b)
{
    return remainder(a - b, L);
}

/* A ball that starts at x = from + 0.3 L, with the velocity v along x. */
static struct result bounce(int n, const double (*at)[2], double from, double v, const char *more)
{
    char *const walls = profile(n, at, from, more), *const text = scene(rough, along_x, walls);
    const struct dem_new_particle seed = {
        .position = {from + 0.3*L, 0.0, 4.0*R}, .velocity = {v, 0.01, 0.0}, .diameter = 2.0*R,
        .material = "g"};
    struct dem *const d = energy_world(text, 1, &seed);
    struct result r = {.scale = 0.0};

    world_run(d, 0.25);
    r.ball = world_at(d, 0);
    r.residual = fabs(energy_term(d, "residual"));
    r.scale = r.ball.mass*9.81*4.0*R;
    dem_free(d);
    return r;
}

static void acts_as_inside(int n, const double (*at)[2], double v, const char *what)
{
    const struct result inside = bounce(n, at, -0.25*L, v, "");

    for (int k = 0; k < 2; k++)
    {
        const double from = k*0.5*L;
        const struct result r = bounce(n, at, from, v, "");

        /* round-off of 1e-18 m, grown by some tens of impacts on edges */
        TAP_NEAR(apart(r.ball.x[0] - from, inside.ball.x[0] + 0.25*L), 0.0, 1e-9,
                 "%s, face at %g L: position", what, 1.0 - 0.5*k);
        TAP_NEAR(r.ball.x[2], inside.ball.x[2], 1e-9, "%s, face at %g L: height", what,
                 1.0 - 0.5*k);
        TAP_NEAR(r.ball.w[1], inside.ball.w[1], 1e-5, "%s, face at %g L: spin", what, 1.0 - 0.5*k);
        /* as inside, where the first order of damping misses up to 0.5 % */
        TAP_NEAR(r.residual/r.scale, inside.residual/r.scale, 1e-9, "%s, face at %g L: energy",
                 what, 1.0 - 0.5*k);
    }
}

static void test_edges(void)
{
    acts_as_inside(3, groove, 0.0, "groove and ridge");
    acts_as_inside(3, groove, 0.9, "groove and ridge, fast");
    acts_as_inside(3, steps, 0.3, "step");
    acts_as_inside(3, steps, -0.3, "step, upwards");
}

/* ---- moving walls ---------------------------------------------------------------------------- */

static void test_moving(void)
{
    static const char *const motion[] = {
        "motion { type oscillation; amplitude (0.003 0 0); frequency 20; }",
        "motion { type translation; velocity (0.3 0 0); }",
        "motion { type translation; velocity (-0.3 0.1 0); start 0.1; end 0.15; }",
        "motion { type oscillation; amplitude (0 0 1e-4); frequency 20; }"};

    for (int k = 0; k < 4; k++)
    {
        const struct result expected = roll_on(world_text(plane, motion[k]));

        rolls_as_on_plane(&expected, flat(0.0, L, motion[k]), motion[k]);
    }
    /* a wavy belt: seen from the belt, the ball moves as on the belt at rest; it covers 4.7 periods */
    const struct result rest = bounce(3, groove, 0.0, 0.2, ""),
                        moving = bounce(3, groove, 0.0, 0.5,
                                        "motion { type translation; velocity (0.3 0 0); }");

    TAP_NEAR(apart(moving.ball.x[0] - 0.3*0.25, rest.ball.x[0]), 0.0, 1e-9,
             "wavy belt without end: position on the belt");
    TAP_NEAR(moving.ball.x[2], rest.ball.x[2], 1e-9, "wavy belt without end: height");
    TAP_NEAR(moving.ball.v[0] - 0.3, rest.ball.v[0], 1e-6, "wavy belt without end: velocity");
}

/* A tube of 24 facets along x. */
static char *tube(double r, double from, double to, const char *more)
{
    struct mesh m = {0};

    for (int k = 0; k < 24; k++)
    {
        const double a = k*world_pi/12.0, b = (k + 1)%24*world_pi/12.0;
        const double y[2] = {r*sin(a), r*sin(b)}, z[2] = {-r*cos(a), -r*cos(b)};

        mesh_quad(&m, (const double[3]){from, y[0], z[0]}, (const double[3]){to, y[0], z[0]},
                  (const double[3]){to, y[1], z[1]}, (const double[3]){from, y[1], z[1]});
    }
    char *const text = wall_of(&m, more, 17);

    free(m.corner);
    return text;
}

static struct world_particle tumble(const char *domain, char *walls)
{
    char *const text = scene(rough, domain, walls);
    const struct dem_new_particle seed = {
        .position = {0.5*L, 0.0, -4.9*R}, .velocity = {0.3, 0.0, 0.0}, .diameter = 2.0*R,
        .material = "g"};
    struct dem *const d = world(text, 1, &seed);

    world_run(d, 0.3);
    const struct world_particle ball = world_at(d, 0);

    dem_free(d);
    return ball;
}

static void test_tube(void)
{
    static const char turn[] = "motion { type rotation; origin (0.1 0 0); axis (1 0 0); omega 8; }";
    const struct world_particle expected = tumble(apart_faces, tube(6.0*R, -1.0, 1.0, turn)),
                                seam = tumble(along_x, tube(6.0*R, 0.0, L, turn));

    /* round-off of positions, 1e-17 m, grown while the ball rolls over 60 edges */
    TAP_NEAR(apart(seam.x[0], expected.x[0]), 0.0, 1e-9, "rotating tube: position along it");
    TAP_NEAR(seam.x[1], expected.x[1], 1e-9, "rotating tube: position across");
    TAP_NEAR(seam.x[2], expected.x[2], 1e-9, "rotating tube: height");
    TAP_NEAR(seam.w[0], expected.w[0], 1e-4, "rotating tube: spin");
}

/* A floor that follows a mesh: it rises, and moves along x. */
static struct world_particle follow(const char *domain, double from, double to)
{
    char *const text = scene(rough, domain, "");
    const struct dem_new_particle seed = {
        .position = {0.9*L, 0.0, R}, .velocity = {0.3, 0.0, 0.0}, .diameter = 2.0*R,
        .material = "g"};
    struct dem_case *const made = world_begin(text);
    struct mesh m = {0};

    strip(&m, from, 0.0, 0.5*(from + to), 0.0, 0.02);
    strip(&m, 0.5*(from + to), 0.0, to, 0.0, 0.02);
    WORLD_TRY(dem_case_add_wall(made, "f", "g", (int64_t)m.n, m.corner));
    WORLD_TRY(dem_case_add_particles(made, 1, &seed));
    struct dem *const d = world_start(made);
    for (int k = 1; k <= 250; k++)
    {
        for (size_t c = 0; c < 3*m.n; c++)
        {
            m.corner[3*c] += 2e-4*0.1;
            m.corner[3*c + 2] += 2e-4*0.05;
        }
        WORLD_TRY(dem_wall_move(d, "f", (int64_t)m.n, m.corner));
        world_run(d, 2e-4);
    }
    const struct world_particle ball = world_at(d, 0);

    dem_free(d);
    free(m.corner);
    return ball;
}

static void test_following(void)
{
    const struct world_particle expected = follow(apart_faces, -0.1, 0.1), seam = follow(along_x, 0.0, L);

    /* round-off of corners, 1e-17 m, over 250 windows */
    TAP_NEAR(apart(seam.x[0], expected.x[0]), 0.0, 1e-10, "floor that follows a mesh: position");
    TAP_NEAR(seam.x[2], expected.x[2], 1e-12, "floor that follows a mesh: height");
    TAP_NEAR(seam.w[1], expected.w[1], 1e-6, "floor that follows a mesh: spin");
}

/* ---- restarts and skins ---------------------------------------------------------------------- */

static void keeps_its_bits(const char *domain, char *walls, double low, const char *what)
{
    const char *const file = "test_periodic_walls.dem";
    char *const thin =
        world_text("%s neighbours { outerSkin 0.06; innerSkin 0.01; }", walls);
    const uint64_t expected = flow(rough, domain, walls, low, NULL);

    TAP_OK(flow(rough, domain, walls, low, file) == expected, "%s: bits after a restart", what);
    TAP_OK(flow(rough, domain, thin, low, NULL) == expected, "%s: bits with thin skins", what);
}

static void test_bits(void)
{
    keeps_its_bits(along_x, profile(3, groove, 0.0, ""), 3e-3, "groove");
    keeps_its_bits(along_x,
                   profile(3, groove, 0.1*L,
                           "motion { type oscillation; amplitude (0.005 0 0); frequency 30; }"),
                   3e-3, "wavy floor that oscillates");
    keeps_its_bits(along_x,
                   tube(12.0*R, 0.0, L,
                        "motion { type rotation; origin (0 0 0.001); axis (1 0 0); omega 8; }"),
                   -4.8e-3, "rotating tube");
}

/* ---- a plate that fills a cell with two periodic axes ------------------------------------------ */

/* Bonds of a sphere with a plate across the axis `normal`, which ends at both pairs of periodic faces: two
   triangles, or (hole) a frame around a hole of an eighth of the plate's width. The sphere touches it 0.3 R from a
   face along the next axis, or from both faces. */
static int64_t bonds_on(int normal, int diagonal, int hole, int corner)
{
    static const double ring[4][2] = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    double outer[4][3], inner[4][3];
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "g"};
    struct mesh m = {0};

    for (int k = 0; k < 4; k++)
    {
        for (int a = 0; a < 3; a++)
        {
            const int across = (a - normal + 3)%3;    /* 0: the normal */
            const double of = across ? ring[(k + diagonal)%4][across - 1] : 0.0;

            outer[k][a] = L*of;
            inner[k][a] = across ? L*(0.5 + 0.125*(of - 0.5)) : 0.0;
        }
    }
    for (int k = 0; k < 4 && hole; k++)
    {
        mesh_quad(&m, outer[k], outer[(k + 1)%4], inner[(k + 1)%4], inner[k]);
    }
    if (!hole)
    {
        mesh_quad(&m, outer[0], outer[1], outer[2], outer[3]);
    }
    seed.position[normal] = R;
    seed.position[(normal + 1)%3] = corner ? 0.3*R : 0.25*L;
    seed.position[(normal + 2)%3] = 0.3*R;
    char *const walls = wall_of(&m, "", 17);
    struct dem *const w = world(scene("bondLinear { normalStiffness 1e9; shearStiffness 0; walls yes; "
                                      "dampingRatio 0.1; }",
                                      world_text("%c (0 0.016); %c (0 0.016); periodic (%c %c);",
                                                 "xyz"[(normal + 1)%3], "xyz"[(normal + 2)%3],
                                                 "xyz"[(normal + 1)%3], "xyz"[(normal + 2)%3]), walls), 1, &seed);
    const int64_t bonds = world_tally(w).bonds;

    dem_free(w);
    free(m.corner);
    return bonds;
}

static void test_filled_cell(void)
{
    for (int k = 0; k < 24; k++)
    {
        const int normal = k%3, diagonal = k/3%2, hole = k/6%2, corner = k/12;

        TAP_OK(bonds_on(normal, diagonal, hole, corner) == 1,
               "a plate across %c, diagonal %d%s, has one bond with a sphere near %s", "xyz"[normal], diagonal,
               hole ? ", with a hole" : "", corner ? "a corner" : "a face");
    }
}

/* ---- insertion and absorption ---------------------------------------------------------------- */

/* A plate across x near the face. */
static char *plate(const char *more)
{
    struct mesh m = {0};

    mesh_quad(&m, (const double[3]){3e-4, -0.05, -0.05}, (const double[3]){3e-4, 0.05, -0.05},
              (const double[3]){3e-4, 0.05, 0.05}, (const double[3]){3e-4, -0.05, 0.05});
    char *const text = wall_of(&m, more, 17);

    free(m.corner);
    return text;
}

static void keeps_off(const char *insert, const char *what)
{
    char *const walls = plate(""), *const with = world_text("%s insert { g { %s } }", walls, insert),
         *const text = scene("", along_x, with);
    struct dem *const d = world(text, 0, NULL);
    struct dem_view v;
    double nearest = L;

    world_run(d, 2e-3);
    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        nearest = fmin(nearest, fabs(apart(*dem_at(v.position, v.stride, k), 3e-4)));
    }
    TAP_OK(v.n >= 20, "%s: %zu particles", what, v.n);
    /* spheres at rest: what is placed stays */
    TAP_OK(nearest >= R*(1.0 - 1e-6), "%s: the nearest centre is %.3g radii off the plate", what,
           nearest/R);
    dem_free(d);
}

static void test_insertion(void)
{
    char *const walls = plate("absorb yes;"), *const text = scene("", along_x, walls);
    const struct dem_new_particle seed = {
        .position = {L - 0.9*R, 0.0, 0.0}, .velocity = {0.1, 0.0, 0.0}, .diameter = 2.0*R,
        .material = "g"};
    struct dem *const d = world(text, 1, &seed);

    world_run(d, 4e-3);
    TAP_OK(world_tally(d).particles == 0, "an absorbing wall acts through the face");
    dem_free(d);
    keeps_off("type stream; rate 1e5; count 40; diameter 0.002;"
              " min (0.012 -0.02 -0.02); max (0.02 0.02 0.02);", "stream");
    keeps_off("type random; inside walls; count 60; diameter 0.002;"
              " min (0 -0.02 -0.01); max (0.016 0.02 0.01);", "group inside walls");
}

/* ---- refusals -------------------------------------------------------------------------------- */

static void refused(char *walls, const char *sentence)
{
    char *const text = scene(down, along_x, walls);
    const struct dem_new_particle seed = {
        .position = {0.5*L, 0.0, 0.1}, .diameter = 2.0*R, .material = "g"};
    struct dem_case *const c = world_begin(text);

    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    TAP_OK(world_status(c) != DEM_OK && strstr(dem_error_text(), sentence), "refused: %s",
           dem_error_text());
}

/* A flap from x to x + 0.3 L between periodic faces. */
static void accepted(double x, const char *motion, const char *what)
{
    const struct dem_new_particle seed = {.position = {0.5*L, 0.0, 0.1}, .diameter = 2.0*R, .material = "g"};
    struct dem_case *const c = world_begin(scene(down, along_x, flat(x, x + 0.3*L, motion)));

    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    TAP_OK(world_status(c) == DEM_OK, "%s: %s", what, dem_error_text());
}

/* It keeps away from the faces on a hinge in the middle of the period, and behind or before other motions that are short,
   or turn little; elsewhere, or with more motion, it does not. */
static void test_flap(void)
{
    static const char hinge[] = "{ type hinge; origin (%g 0 0); axis (0 1 0); inertia 1e-7; }",
                      swings[] = "motion ( { type oscillation; amplitude (%g 0 0); frequency 30; } %s );",
                      turns[] = "{ type rotation; origin (0.008 0 0); axis (0 1 0); omega 5; }",
                      part[] = "motion ( { type rotation; origin (0.004 0 0); axis (0 1 0); omega -1; end %g; } "
                               "{ type translation; velocity (-0.001 0 0); end 1; } );",
                      closed[] = "only a rotation about x is periodic";
    char in_middle[120];

    snprintf(in_middle, sizeof in_middle, hinge, 0.5*L);
    accepted(0.5*L, world_text("motion %s", in_middle), "a flap in the middle of the period may turn");
    refused(flat(0.2*L, 0.5*L, world_text("motion { type hinge; origin (%g 0 0); axis (0 1 0); inertia 1e-7; }", 0.2*L)),
            closed);
    accepted(0.5*L, world_text(swings, 0.0005, in_middle), "it may swing a little, and turn on a hinge");
    refused(flat(0.5*L, 0.8*L, world_text(swings, 0.004, in_middle)), closed);
    accepted(0.5*L, world_text(swings, 0.0005, turns), "it may swing a little, and turn");
    refused(flat(0.5*L, 0.8*L, world_text(swings, 0.004, turns)), closed);
    accepted(0.6*L, world_text(part, 0.3), "about another place it may turn by part of a turn, and move on");
    refused(flat(0.6*L, 0.9*L, world_text(part, 6.0)), closed);
}

static void test_refusals(void)
{
    refused(flat(0.0, L, "motion { type rotation; origin (0.008 0 0); axis (0 1 0); omega 1; }"),
            "only a rotation about x is periodic");
    refused(flat(0.3*L, 0.4*L,
                 "motion { type rotation; origin (0.008 0 0); axis (0 0 1); omega 1; }"),
            "only a rotation about x is periodic");
    refused(flat(0.0, L, "surfaceRotation { origin (0 0 0); axis (0 0 1); omega 1; }"),
            "surfaceRotation about (0 0 1)");
    refused(profile(3, (const double[3][2]){{0.0, 0.0}, {0.01, 0.0}, {0.02, 0.005}}, 0.0, ""),
            "where it meets its own image");
    refused(world_text("walls { f { type sphere; centre (0 0 0); radius 0.002; particles outside; } }"),
            "build it from triangles");
    refused(world_text("walls { f { type plane; point (0 0 0); normal (0 0 1); "
                       "motion { type rotation; origin (0.008 0 0); axis (0 0 1); omega 1; } } }"),
            "its rotation is about (0 0 1)");
    refused(world_text("walls { f { type plane; point (0 0 0); normal (0 0 1); "
                       "surfaceRotation { origin (0.008 0 0); axis (0 0 1); omega 2; } } }"),
            "surfaceRotation is about (0 0 2)");
}

int main(void)
{
    TAP_TRAPS;
    test_rolling();
    test_chute();
    test_edges();
    test_moving();
    test_tube();
    test_following();
    test_bits();
    test_filled_cell();
    test_insertion();
    test_flap();
    test_refusals();
    return tap_done();
}
