/*
 * test_walls.c -- walls of triangles give the forces of the surface that they describe: over seams,
 * slivers and faulty meshes, in corners, at convex and concave edges and tips, on both sides; and the
 * torque on a wall. A wall that is `frictionless` has its normal force and damping only.
 *
 * Sources: geometry and statics.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/mesh.h"
#include "physics/world.h"

#include "core/vec.h"

static const double R = 1e-3, density = 2500.0, E = 1e7, g = 9.81;

static const char materials[] =
    "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; }"
    " rigid { density 1; youngsModulus 1e30; } }";

static double weight(void)
{
    return world_sphere_mass(R, density)*g;
}

/* overlap at which the Hertzian contact with a rigid wall carries this force */
static double overlap_of(double force)
{
    return pow(0.75*force*(1.0 - 0.09)/(E*sqrt(R)), 2.0/3.0);
}

/* A right-handed frame in no special direction. */
static const double frame[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0.0}, {0.48, 0.64, 0.6}};

static void rotate(const double flat[3], double out[3])
{
    double in[3];

    memcpy(in, flat, sizeof in);
    for (int k = 0; k < 3; k++)
    {
        out[k] = frame[0][k]*in[0] + frame[1][k]*in[1] + frame[2][k]*in[2];
    }
}

static void rotate_mesh(struct mesh *m)
{
    for (size_t k = 0; k < 3*m->n; k++)
    {
        rotate(m->corner + 3*k, m->corner + 3*k);
    }
}

/* One sphere at the rest overlap on z = 0, sliding along it; mesh NULL: on a plane. */
static struct dem *slide(struct mesh *m, int rotated, const char *effects, double speed)
{
    double x[3] = {0.0013, 0.0007, R - overlap_of(weight())}, v[3] = {speed, 0.37*speed, 0.0},
           down[3] = {0.0, 0.0, -g};
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass"};

    if (rotated)
    {
        rotate(x, x), rotate(v, v), rotate(down, down);
    }
    memcpy(seed.position, x, sizeof x);
    memcpy(seed.velocity, v, sizeof v);
    struct dem_case *const c = world_begin(world_text(
        "%s effects { hertz {} %s gravity { acceleration (%.17g %.17g %.17g); } } "
        "time { step 8e-6; } %s",
        materials, effects, down[0], down[1], down[2],
        m ? "" : "walls { floor { type plane; material rigid; point (0 0 0); normal (0 0 1); } }"));

    if (m)
    {
        mesh_hand_over(c, "floor", "rigid", m);
    }
    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    return world_start(c);
}

/* along the frame's third axis, or z */
static double height(const double a[3], int rotated)
{
    return rotated ? a[0]*frame[2][0] + a[1]*frame[2][1] + a[2]*frame[2][2] : a[2];
}

static void smooth(struct mesh m, int rotated, const char *what)
{
    const size_t triangles = m.n;
    double worst_force = 0.0, worst_speed = 0.0;
    int64_t most = 0;

    if (rotated)
    {
        rotate_mesh(&m);
    }
    struct dem *const d = slide(&m, rotated, "dry { restitution 0.9; }", 1.0);

    for (int k = 0; k < 3750; k++)
    {
        world_step(d);
        const struct world_particle p = world_at(d, 0);
        const int64_t contacts = world_tally(d).contacts;

        worst_force = fmax(worst_force, fabs(height(p.f, rotated)/weight() - 1.0));
        worst_speed = fmax(worst_speed, fabs(height(p.v, rotated)));
        most = contacts > most ? contacts : most;
    }
    const struct world_particle p = world_at(d, 0);

    /* positions are known to 1e-17 m of an overlap of 4e-6 m, in a turned frame some ten times
       worse */
    TAP_NEAR(worst_force, 0.0, 1e-6, "%s (%zu triangles): normal force m g within %.0e", what,
             triangles, worst_force);
    TAP_NEAR(worst_speed, 0.0, 1e-9, "%s: normal velocity at most %.0e m/s", what, worst_speed);
    TAP_OK(most == 1, "%s: one contact, never %lld", what, (long long)most);
    /* 30 mm at 1 m/s without friction */
    const double square = p.v[0]*p.v[0] + p.v[1]*p.v[1] + p.v[2]*p.v[2];

    TAP_NEAR(sqrt(square), sqrt(1.0 + 0.37*0.37), 1e-12, "%s: keeps its speed", what);
    dem_free(d);
}

/* With friction and spin: the triangles of z = 0 give the bits of a plane. */
static void like_a_plane(void)
{
    static const char effects[] = "dry { restitution 0.9; } mindlin { friction 0.3; }";
    struct mesh m = mesh_floor(-0.01, 0.05, 2.5e-3);
    struct dem *const a = slide(NULL, 0, effects, 0.5), *const b = slide(&m, 0, effects, 0.5);

    world_run(a, 0.05);
    world_run(b, 0.05);
    const struct world_particle p = world_at(a, 0), q = world_at(b, 0);

    TAP_OK(memcmp(p.x, q.x, sizeof p.x) == 0 && memcmp(p.v, q.v, sizeof p.v) == 0 &&
               memcmp(p.w, q.w, sizeof p.w) == 0,
           "with friction: the same bits as on a plane");
    dem_free(a);
    dem_free(b);
}

/* Faults that occur in surface files. */
static void faulty_meshes(void)
{
    struct mesh m = mesh_floor(-0.01, 0.05, 4e-3);
    const size_t clean = m.n;
    const double a[3] = {0.0, 0.0, 0.0}, b[3] = {0.01, 0.0, 0.0}, c[3] = {0.02, 0.0, 0.0};

    for (size_t k = 0; k < clean; k += 7)
    {
        double t[9];

        memcpy(t, m.corner + 9*k, sizeof t);
        mesh_triangle(&m, t, t + 3, t + 6);               /* again */
        mesh_triangle(&m, t + 6, t + 3, t);               /* again, flipped */
        mesh_triangle(&m, t, t, t + 3);                   /* no area */
    }
    mesh_triangle(&m, a, b, c);                           /* no area, a line */
    smooth(m, 0, "repeated, flipped, without area");

    /* T-joints: strips cut at different places */
    struct mesh t = {0};

    for (int row = 0; row < 20; row++)
    {
        const double y0 = -0.01 + 3e-3*row, y1 = y0 + 3e-3;

        for (int k = 0; k < 12; k++)
        {
            const double shift = row%2 ? 2.1e-3 : 0.0;
            const double x0 = k > 0 ? -0.01 + 5e-3*k + shift : -0.01,
                         x1 = k < 11 ? -0.005 + 5e-3*k + shift : 0.05;
            const double corner[4][3] = {{x0, y0, 0.0},
                                         {x1, y0, 0.0},
                                         {x1, y1, 0.0},
                                         {x0, y1, 0.0}};

            mesh_quad(&t, corner[0], corner[1], corner[2], corner[3]);
        }
    }
    smooth(t, 0, "T-joints");
}

/* ---- edges ----------------------------------------------------------------------------------- */

/* A sphere placed on surfaces; returns the number of contacts and the force. */
static int64_t place_on(struct mesh *m, const double x[3], double force[3])
{
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass"};
    struct dem_case *const c = world_begin(world_text(
        "%s effects { hertz {} } time { step 1e-9; }", materials));

    memcpy(seed.position, x, sizeof seed.position);
    mesh_hand_over(c, "surface", "rigid", m);
    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    struct dem *const d = world_start(c);
    world_step(d);
    const int64_t contacts = world_tally(d).contacts;

    memcpy(force, world_at(d, 0).f, 3*sizeof *force);
    dem_free(d);
    return contacts;
}

/* Two rectangles that meet along the y axis; heights of their far sides. */
static struct mesh roof(double left, double right)
{
    const double a[3] = {-0.01, -0.01, left}, b[3] = {0.0, -0.01, 0.0}, c[3] = {0.0, 0.01, 0.0},
                 e[3] = {-0.01, 0.01, left};
    const double f[3] = {0.01, -0.01, right}, h[3] = {0.01, 0.01, right};
    struct mesh m = {0};

    mesh_quad(&m, a, b, c, e);
    mesh_quad(&m, b, f, h, c);
    return m;
}

static void edges(void)
{
    const double d = 5e-6;                                /* m, overlap */
    const double push = 4.0/3.0*E/(1.0 - 0.09)*sqrt(R)*d*sqrt(d);
    double f[3];

    struct mesh valley = roof(0.01, 0.01);
    const double in_valley[3] = {0.0, 0.0, (R - d)*sqrt(2.0)};

    int64_t n = place_on(&valley, in_valley, f);

    TAP_OK(n == 2, "concave edge: two contacts (%lld)", (long long)n);
    TAP_NEAR(f[2], 2.0*push/sqrt(2.0), 1e-9*push, "concave edge: two forces");

    /* without an angle it is a floor */
    struct mesh level = roof(0.0, 0.0);
    const double on_floor[3] = {0.0, 0.0, R - d};

    n = place_on(&level, on_floor, f);
    TAP_OK(n == 1, "flat edge: one contact (%lld)", (long long)n);
    TAP_NEAR(f[2], push, 1e-9*push, "flat edge: as on a plane");

    /* the free edge of a sheet */
    struct mesh sheet = {0};
    const double a[3] = {-0.01, -0.01, 0.0}, b[3] = {0.0, -0.01, 0.0}, c[3] = {0.0, 0.01, 0.0},
                 e[3] = {-0.01, 0.01, 0.0};
    const double rim[3] = {R - d, 0.0, 0.0};

    mesh_quad(&sheet, a, b, c, e);
    n = place_on(&sheet, rim, f);
    TAP_OK(n == 1, "free edge of a sheet: one contact (%lld)", (long long)n);
    TAP_NEAR(f[0], push, 1e-9*push, "free edge of a sheet: force in its plane");
}

/* A random tetrahedron, corners in an order that makes its faces look outward. */
static void tetrahedron(uint64_t number, double corner[4][3])
{
    double side[3][3], normal[3];

    for (int k = 0; k < 12; k++)
    {
        corner[k/3][k%3] = 0.05 + 8e-3*(mesh_random(number, 100 + (uint64_t)k) - 0.5);
    }
    for (int k = 0; k < 3; k++)
    {
        dem_vec_minus(corner[k + 1], corner[0], side[k]);
    }
    dem_vec_cross(side[0], side[1], normal);
    for (int k = 0; k < 3 && dem_vec_dot(normal, side[2]) > 0.0; k++)
    {
        const double swap = corner[1][k];

        corner[1][k] = corner[2][k];
        corner[2][k] = swap;
    }
}

/* Corner number k of face f of a tetrahedron: all but corner 3 - f, clockwise about the outward
   normal. */
static int corner_of(int f, int k)
{
    static const int face[4][3] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};

    return face[f][k];
}

static void outward(double corner[4][3], int f, double normal[3])
{
    double a[3], b[3];

    dem_vec_minus(corner[corner_of(f, 1)], corner[corner_of(f, 0)], a);
    dem_vec_minus(corner[corner_of(f, 2)], corner[corner_of(f, 0)], b);
    dem_vec_cross(a, b, normal);
    const double length = dem_vec_norm(normal);

    for (int k = 0; k < 3; k++)
    {
        normal[k] /= length;
    }
}

/* A point of a convex body and a direction u in which it is the nearest point: a corner (any u), a
   point of the edge of faces 0 and 1 (u between their normals), a point of face 0 (its normal). */
static void convex_point(uint64_t number, double corner[4][3], double at[3], double u[3])
{
    double n[2][3], s = mesh_random(number, 1), t = 0.1 + 0.8*mesh_random(number, 2);
    const int kind = (int)(number%3);
    int tip = 0;

    outward(corner, 0, n[0]);
    outward(corner, 1, n[1]);
    for (int k = 0; k < 3; k++)
    {
        u[k] = kind == 0 ? mesh_random(number, 3 + (uint64_t)k) - 0.5
               : kind == 1 ? s*n[0][k] + (1.0 - s)*n[1][k]
                           : n[0][k];
    }
    const double length = dem_vec_norm(u);

    for (int c = 1; c < 4; c++)
    {
        tip = dem_vec_dot(corner[c], u) > dem_vec_dot(corner[tip], u) ? c : tip;
    }
    for (int k = 0; k < 3; k++)
    {
        u[k] /= length;
        at[k] = kind == 0 ? corner[tip][k] : kind == 1 ? t*corner[0][k] + (1.0 - t)*corner[1][k]
              : 0.5*t*corner[0][k] + 0.5*(1.0 - t)*corner[1][k] + 0.5*corner[2][k];
    }
}

/* The nearest point of a convex body is unique: one contact, with the force of a plane, in any
   orientation. */
static void convex(void)
{
    const double d = 5e-6, push = 4.0/3.0*E/(1.0 - 0.09)*sqrt(R)*d*sqrt(d);
    int wrong[3] = {0}, more[3] = {0};

    for (uint64_t number = 0; number < 300; number++)
    {
        double corner[4][3], at[3], u[3], f[3], off = 0.0;
        struct mesh m = {0};

        tetrahedron(number, corner);
        convex_point(number, corner, at, u);
        for (int k = 0; k < 4; k++)
        {
            mesh_triangle(&m, corner[corner_of(k, 0)], corner[corner_of(k, 1)],
                          corner[corner_of(k, 2)]);
        }
        const double x[3] = {at[0] + (R - d)*u[0], at[1] + (R - d)*u[1], at[2] + (R - d)*u[2]};

        more[number%3] += place_on(&m, x, f) != 1;
        for (int k = 0; k < 3; k++)
        {
            off = fmax(off, fabs(f[k] - push*u[k]));
        }
        wrong[number%3] +=
            off >
            /* coordinates of 0.05 m are known to 1e-17 m: 2e-12 of the overlap */
            1e-8*push;
    }
    for (int k = 0; k < 3; k++)
    {
        const char *const what = k == 0 ? "tips" : k == 1 ? "edges" : "faces";

        TAP_OK(more[k] == 0, "%s of random tetrahedra: one contact (%d of 100 have another number)",
               what, more[k]);
        TAP_OK(wrong[k] == 0, "%s of random tetrahedra: the force of a plane (%d of 100 differ)",
               what, wrong[k]);
    }
}

/* Facets far smaller than the contact area: one contact everywhere. */
static void facets(void)
{
    const double d = 2e-5, push = 4.0/3.0*E/(1.0 - 0.09)*sqrt(R)*d*sqrt(d);
    const double out = 0.005, step = 0.01, wide = 5e-5;
    int wrong = 0, more = 0;

    for (int place = 0; place < 40; place++)
    {
        /* a round bar of radius 5 mm along y, facets of 50 um; positions from an edge to the middle
           of a facet */
        const double angle = step*0.5*place/39.0;
        struct mesh bar = {0}, strips = {0};
        double f[3];

        for (int k = -40; k < 40; k++)
        {
            const double p[2] = {k*step, (k + 1)*step};
            const double corner[4][3] = {{out*sin(p[0]), -0.01, out*cos(p[0])},
                                         {out*sin(p[1]), -0.01, out*cos(p[1])},
                                         {out*sin(p[1]), 0.01, out*cos(p[1])},
                                         {out*sin(p[0]), 0.01, out*cos(p[0])}};
            /* flat strips of 50 um that share no corner with their neighbours */
            const double low = -0.01 - 1e-4*(k & 1), x0 = wide*k, x1 = wide*(k + 1);
            const double strip[4][3] = {{x0, low, 0.0},
                                        {x1, low, 0.0},
                                        {x1, 0.01, 0.0},
                                        {x0, 0.01 + 1e-4*(k & 1), 0.0}};

            mesh_quad(&bar, corner[0], corner[1], corner[2], corner[3]);
            mesh_quad(&strips, strip[0], strip[1], strip[2], strip[3]);
        }
        const double far = out + R - d, over[3] = {far*sin(angle), 1e-4, far*cos(angle)},
                     above[3] = {wide*place/39.0, 1e-4, R - d};

        more += place_on(&bar, over, f) != 1;
        more += place_on(&strips, above, f) != 1;
        wrong += fabs(f[2] - push) > 1e-6*push;
    }
    TAP_OK(more == 0,
           "small facets, round and flat: one contact (%d of 80 positions have another "
           "number)", more);
    TAP_OK(wrong == 0, "small facets: the force of a plane (%d of 40 positions differ)", wrong);
}

/* m x × v + I w about the origin */
static void angular_momentum(const struct world_particle *p, double out[3])
{
    dem_vec_cross(p->x, p->v, out);
    for (int k = 0; k < 3; k++)
    {
        out[k] = p->mass*(out[k] + 0.4*p->radius*p->radius*p->w[k]);
    }
}

/* A sphere that spins, slides, rolls and twists in a box far from the origin: the box gets the
   angular momentum that it loses. */
static void torque(void)
{
    static const double min[3] = {0.5, -0.2, 0.3}, max[3] = {0.506, -0.195, 0.305};
    const struct dem_new_particle seed = {
        .position = {0.5025, -0.1976, 0.302}, .velocity = {0.7, -0.4, 0.5},
        .spin = {300.0, 900.0, -500.0}, .diameter = 2.0*R, .material = "glass"};
    struct mesh m = mesh_box(min, max);
    struct dem_case *const c = world_begin(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } "
        "rigid { density 1; youngsModulus 1e30; } }"
        "effects { hertz {} dry { restitution 0.8; } mindlin { friction 0.3; } "
        "rollingSpring { friction 0.1; }"
        "          twistingSpring { friction 0.3; } }");
    double before[3], after[3], impulse[3], twist[3], size = 0.0;

    mesh_hand_over(c, "box", "rigid", &m);
    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    struct dem *const d = world_start(c);
    WORLD_TRY(dem_wall_impulse_reset(d));
    const struct world_particle p = world_at(d, 0);

    world_run(d, 0.03);
    const struct world_particle q = world_at(d, 0);

    WORLD_TRY(dem_wall_impulse(d, 0, impulse, twist));
    angular_momentum(&p, before);
    angular_momentum(&q, after);
    for (int k = 0; k < 3; k++)
    {
        size = fmax(size, fabs(after[k] - before[k]));
    }
    TAP_OK(fabs(q.w[0] - 300.0) > 30.0 && fabs(q.w[1] - 900.0) > 30.0,
           "torque: friction has reduced its spin");
    for (int k = 0; k < 3; k++)
    {
        TAP_NEAR(twist[k], before[k] - after[k], 1e-11*size,
                 "torque: the wall has the angular momentum that the sphere has lost, axis %d",
                 k);    /* rounding of 4000 steps */
    }
    dem_free(d);
}

/* Against a sheet of triangles from both sides, as fast as the limit of the step allows. */
static void both_sides(void)
{
    struct mesh m = mesh_floor(-0.05, 0.05, 5e-3);
    struct dem_new_particle seed[40];
    struct dem_case *const c = world_begin(world_text(
        "%s effects { hertz { impactSpeed 5; } }", materials));
    int wrong = 0;

    memset(seed, 0, sizeof seed);
    for (int k = 0; k < 40; k++)
    {
        const double side = k%2 ? 1.0 : -1.0;

        seed[k] = (struct dem_new_particle){
            .position = {-0.045 + 0.0023*k, 0.002*(k%7), side*3e-3},
            .velocity = {0.5, 0.1, -5.0*side}, .diameter = 2.0*R, .id = k, .material = "glass"};
        seed[k].position[1] += 0.02*(k%3) - 0.03;
    }
    mesh_hand_over(c, "sheet", "rigid", &m);
    WORLD_TRY(dem_case_add_particles(c, 40, seed));
    struct dem *const d = world_start(c);
    world_run(d, 2e-3);
    for (int k = 0; k < 40; k++)
    {
        const struct world_particle p = world_at(d, k);
        const double side = k%2 ? 1.0 : -1.0;

        wrong += p.x[2]*side < R || fabs(p.v[2] - 5.0*side) > 5e-3 || fabs(p.v[0] - 0.5) > 1e-9;
    }
    TAP_OK(wrong == 0, "a sheet reflects spheres on both sides (%d wrong)", wrong);
    dem_free(d);
}

/* A plate without thickness, as a baffle in a mesh: its two sides have the same corners and need not have the same triangles.
   Spheres pass each edge at 1.2 R. */
static void both_sides_of_a_plate(void)
{
    static const double corner[4][3] = {
        {-0.01, -0.01, 0.0}, {0.01, -0.01, 0.0}, {0.01, 0.01, 0.0}, {-0.01, 0.01, 0.0}};
    struct mesh m = {0};
    struct dem_new_particle seed[4];
    struct dem_case *const c = world_begin(world_text("%s effects { hertz {} }", materials));
    int wrong = 0;

    mesh_quad(&m, corner[0], corner[1], corner[2], corner[3]);
    mesh_quad(&m, corner[1], corner[0], corner[3], corner[2]);
    mesh_hand_over(c, "plate", "rigid", &m);
    for (int k = 0; k < 4; k++)
    {
        const double away = (k < 2 ? -1.0 : 1.0)*(0.01 + 1.2*R);

        seed[k] = (struct dem_new_particle){
            .position = {k%2 ? away : 0.002, k%2 ? 0.002 : away, 4.0*R},
            .velocity = {0.0, 0.0, -1.0}, .diameter = 2.0*R, .id = k, .material = "glass"};
    }
    WORLD_TRY(dem_case_add_particles(c, 4, seed));
    struct dem *const d = world_start(c);
    world_run(d, 8.0*R);
    for (int k = 0; k < 4; k++)
    {
        const struct world_particle p = world_at(d, k);

        wrong += p.v[2] > -1.0 || p.v[2] < -1.0 || fabs(p.x[2] + 4.0*R) > 1e-9;
    }
    TAP_OK(wrong == 0,
           "beside a plate with sides cut along different diagonals spheres fly on (%d wrong)",
           wrong);
    dem_free(d);
}

/* ---- a gap between two floors ---------------------------------------------------------------- */

/* A sphere thrown at a floor, or at a wall beside it, with spin; 1: after the bounce. */
static struct world_particle thrown(const char *effects, const char *floor, int at_side)
{
    const struct dem_new_particle seed = {
        .position = {5e-3, 5e-3, 5e-3},
        .velocity = {at_side ? -1.0 : 0.3, 0.2, at_side ? 0.3 : -1.0}, .spin = {20.0, -30.0, 40.0},
        .diameter = 2.0*R, .material = "glass"};
    struct dem *const d = world(world_text(
        "%s effects { hertz {} dry { restitution 0.9; } %s } time { step 4e-6; } walls {"
        " floor { type plane; material glass; point (0 0 0); normal (0 0 1); %s }"
        " side { type plane; material glass; point (0 0 0); normal (1 0 0); } }",
        materials, effects, floor), 1, &seed);

    world_run(d, 8e-3);
    const struct world_particle p = world_at(d, 0);

    dem_free(d);
    return p;
}

static void frictionless(void)
{
    static const char rough[] =
        "mindlin { friction 0.3; } rollingConstant { friction 0.1; } twistingSpring { friction 0.1; }"
        " lubrication { viscosity 1e-3; roughness 1e-6; cutOff 1e-4; }";
    const struct world_particle mirror = thrown(rough, "frictionless yes;", 0),
                                smooth_wall = thrown("", "", 0), floor = thrown(rough, "", 0),
                                side = thrown(rough, "frictionless yes;", 1),
                                rough_side = thrown(rough, "", 1);

    TAP_OK(mirror.v[2] > 0.85 && mirror.v[0] == 0.3 && mirror.v[1] == 0.2 && mirror.w[0] == 20.0
               && mirror.w[1] == -30.0 && mirror.w[2] == 40.0,
           "frictionless: velocity along the wall and spin stay, exactly");
    TAP_OK(memcmp(mirror.x, smooth_wall.x, sizeof mirror.x) == 0
               && memcmp(mirror.v, smooth_wall.v, sizeof mirror.v) == 0,
           "frictionless: the bits of a scene without the other effects");
    TAP_OK(floor.v[0] != 0.3 && floor.w[0] != 20.0,
           "frictionless: the same wall without the word has friction");
    TAP_OK(memcmp(side.v, rough_side.v, sizeof side.v) == 0 && side.v[1] != 0.2,
           "frictionless: another wall of the same material keeps its friction");
}

static void refuse_driven_mirror(void)
{
    world_refused(
        "materials { glass { density 2500; youngsModulus 1e7; } } effects { hertz {} dry {"
        " restitution 0.9; } } walls { belt { type plane; point (0 0 0); normal (0 0 1);"
        " frictionless yes; surfaceVelocity (1 0 0); } } insert { one { type list; diameter 1e-3;"
        " positions ((0 0 0.01)); } }",
                  "belt is frictionless, so the velocity of its surface");
}

int main(void)
{
    static const double sizes[] = {0.4e-3, 2.5e-3, 0.03};

    TAP_TRAPS;
    for (int k = 0; k < 3; k++)
    {
        char what[64];

        snprintf(what, sizeof what, "triangles of %g R", sizes[k]/R);
        smooth(mesh_floor(-0.01, 0.05, sizes[k]), 0, what);
        snprintf(what, sizeof what, "triangles of %g R, turned", sizes[k]/R);
        smooth(mesh_floor(-0.01, 0.05, sizes[k]), 1, what);
    }
    like_a_plane();
    faulty_meshes();
    edges();
    convex();
    facets();
    torque();
    both_sides();
    both_sides_of_a_plate();
    frictionless();
    refuse_driven_mirror();
    TAP_DONE;
}
