/*
 * test_clumps.c -- rigid bodies of several spheres: mass and inertia of the union, impact on a plane,
 * free rotation, conservation, weight of a heap; a body of one sphere moves as the sphere.
 *
 * Closed forms, with spheres of radius R and mass m:
 *
 * - Two spheres, centres R apart: a half of the union reaches from -R/2 to R of its sphere, so
 *   V = 2 pi (R^3 - R^3/3 + R^3/2 - R^3/24) = 27/12 pi R^3, 27/16 spheres;
 *   I = 17/40 M R^2 along the axis, 59/80 across it (integrals of pi/2 (R^2 - z^2)^2 and of
 *   pi (R^2 - z^2)(z + R/2)^2).
 * - Two touching spheres at 45 degrees meet a plane without friction at the speed v, e = 1:
 *   I = 7/5 M R^2, 1/m_eff = (1 + R^2/2/(7/5 R^2))/M = 19/14/M, impulse 2 v m_eff = 28/19 M v:
 *   v' = (28/19 - 1) v = 0.473684 v, omega = 28/19 v R/sqrt(2)/(7/5 R^2) = 0.744323 v/R.
 * - Euler's top, I = (1 2 3), omega = (1/2 0 1) along the principal axes: L^2 = 9.25, 2 E = 3.25,
 *   period 4 K(m) sqrt(I1 I2 I3/((I3 - I2)(L^2 - 2 E I1))) = 4 K(1/12) = 6.420600
 *   (Landau and Lifshitz, Mechanics, 37).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"
#include <unistd.h>

#include "case/simulation.h"
#include "core/vec.h"
#include "input/dictionary.h"
#include "particles/clump_shape.h"

static const char *const materials =
    "materials { glass { density 2500; youngsModulus 1e8; poissonsRatio 0.25; } }";

/* ---- templates ------------------------------------------------------------------------------- */

static struct dem_clump_shapes shapes_of(const char *text, struct dem_dict **dict)
{
    struct dem_clump_shapes s = {.n = 0};

    WORLD_TRY(dem_dict_read_text(dict, text, "shapes"));
    WORLD_TRY(dem_clump_shapes_read(&s, *dict));
    return s;
}

static int rises(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;

    return (p > q) - (p < q);
}

static void unions(void)
{
    struct dem_dict *dict;
    /* R = 2; the axis of the second one is askew */
    struct dem_clump_shapes all = shapes_of(
        "shapes { a { spheres ((0 0 0 2) (0 0 2 2)); }"
        "         b { spheres ((1 2 3 2) (2.2 3.6 3 2)); }"
        "         one { spheres ((5 0 0 2)); }"
        "         twice { spheres ((1 0 0 2) (1 0 0 2) (1.5 0 0 0.5)); } }", &dict);
    const double sphere = 4.0/3.0*world_pi*8.0;

    for (size_t k = 0; k < 2; k++)
    {
        struct dem_clump_shape *const s = &all.shape[k];
        const double M = s->volume, unit = M*4.0;
        double I[3] = {s->inertia[0], s->inertia[1], s->inertia[2]};

        qsort(I, 3, sizeof *I, rises);
        /* columns of 1/512 R: errors of 1e-6 */
        TAP_NEAR(M/sphere, 27.0/16.0, 1e-5, "%s: volume of the union", s->name);
        TAP_NEAR(I[0]/unit, 17.0/40.0, 1e-5, "%s: moment along the axis", s->name);
        TAP_NEAR(I[1]/unit, 59.0/80.0, 1e-5, "%s: moment across it", s->name);
        TAP_NEAR(I[2]/unit, 59.0/80.0, 1e-5, "%s: the other moment across it", s->name);
        TAP_NEAR(dem_vec_norm(s->offset[0]), 1.0, 1e-5, "%s: the centre is in the middle", s->name);
        TAP_NEAR(s->bound, 3.0, 1e-5, "%s: the sphere that holds it", s->name);
    }
    const struct dem_clump_shape *const b = &all.shape[1];
    double back[3];

    dem_clump_rotate(b->principal, b->offset[1], back);
    TAP_OK(fabs(back[0] - 0.6) + fabs(back[1] - 0.8) + fabs(back[2]) < 1e-5,
           "b: principal axes turn its spheres back into place (%.9g %.9g %.9g)", back[0], back[1], back[2]);
    TAP_OK(all.shape[2].volume == dem_sphere_volume(2.0) &&
               fabs(all.shape[2].inertia[1]/all.shape[2].volume - 0.4*4.0) < 1e-14,
           "one sphere: exact");
    TAP_NEAR(all.shape[3].volume/sphere, 1.0, 1e-5, "what spheres share counts once");
    TAP_NEAR(all.shape[3].centre[0], 1.0, 1e-5, "also for the centre");
    dem_clump_shapes_free(&all);
    dem_dict_free(dict);
}

/* Spheres along (1 1 0) that share lenses: V = n sphere - (n - 1) pi (4 r + d)(2 r - d)^2/12, d = 3/2 r. */
static void chains(void)
{
    for (int n = 100; n <= 250; n += 150)
    {
        static char text[20000];
        size_t used = (size_t)snprintf(text, sizeof text, "shapes { chain { spheres (");
        struct dem_dict *dict;

        for (int k = 0; k < n; k++)
        {
            used += (size_t)snprintf(text + used, sizeof text - used, "(%.17g %.17g 0 1) ",
                                     1.5*k/sqrt(2.0), 1.5*k/sqrt(2.0));
        }
        snprintf(text + used, sizeof text - used, "); } }");
        struct dem_clump_shapes all = shapes_of(text, &dict);
        const double exact = n*4.0/3.0*world_pi - (n - 1)*world_pi*5.5*0.25/12.0;

        TAP_NEAR(all.shape[0].volume/exact, 1.0, 1e-5, "a chain of %d spheres: volume", n);
        dem_clump_shapes_free(&all);
        dem_dict_free(dict);
    }
}

/* ---- free rotation --------------------------------------------------------------------------- */

/* |error of the phase| over the period after one period in n steps; *swing: of the energy */
static double top(int n, double *swing, double *lost)
{
    const double T = 6.420600;
    struct dem_clump b = {.mass = 1.0, .inertia = {1.0, 2.0, 3.0}, .q = {1.0, 0.0, 0.0, 0.0},
                          .momentum = {0.5, 0.0, 3.0}};
    double body[3];

    *swing = 0.0;
    for (int k = 0; k < n; k++)
    {
        double energy = 0.0;

        dem_clump_turn(&b, T/n);
        dem_clump_rotate_back(b.q, b.momentum, body);
        for (int a = 0; a < 3; a++)
        {
            energy += 0.5*body[a]*body[a]/b.inertia[a];
        }
        *swing = fmax(*swing, fabs(energy/1.625 - 1.0));
    }
    *lost = fabs(dem_vec_norm(body) - sqrt(9.25));
    /* the rate of omega_2 is (I3 - I1)/I2 omega_3 omega_1 = 1/2 */
    return fabs(body[1]/2.0/0.5)/T;
}

static void euler(void)
{
    double swing[2], lost[2];
    const double error[2] = {top(200, &swing[0], &lost[0]), top(400, &swing[1], &lost[1])};

    TAP_OK(error[0] < 1e-4, "Euler's top: period 6.420600 to %.2g in 200 steps", error[0]);
    TAP_NEAR(error[0]/error[1], 4.0, 0.1, "Euler's top: second order in the period");
    TAP_NEAR(swing[0]/swing[1], 4.0, 0.1, "Euler's top: the energy swings by %.2g, second order", swing[0]);
    TAP_OK(lost[0] < 1e-13, "Euler's top: angular momentum is kept (%.2g)", lost[0]);
}

/* ---- impacts --------------------------------------------------------------------------------- */

/* spheres of 1 mm radius at 45 degrees, their lower one above the plane, at 0.1 m/s */
static void dumbbell(double modulus, double tolerance)
{
    const double v = 0.1, R = 1e-3;
    struct dem *const d = world(
        world_text("materials { glass { density 2500; youngsModulus %g; poissonsRatio 0.25; } }"
                   "effects { hertz { } dry { restitution 1; } }"
                   "shapes { pair { spheres ((-0.001 0 0 0.001) (0.001 0 0 0.001)); } }"
                   "walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); } }"
                   "insert { one { type list; material glass; shape pair; positions ((0 0 0.001710106781));"
                   /* by -45 degrees about y: x rises */
                   " orientation (0.9238795325112867 0 -0.3826834323650898 0); velocity (0 0 -%g); } }",
                   modulus, v), 0, NULL);

    for (int n = 0; n < 100000 && !(world_at(d, 0).f[2] == 0.0 && world_at(d, 0).v[2] > 0.0); n++)
    {
        world_step(d);
    }
    const struct world_particle a = world_at(d, 0), b = world_at(d, 1);

    TAP_NEAR(0.5*(a.v[2] + b.v[2])/v, 9.0/19.0, tolerance, "dumbbell, %g Pa: velocity after the impact",
             modulus);
    TAP_NEAR(fabs(a.w[1])*R/v, 28.0/19.0/sqrt(2.0)/1.4, tolerance, "dumbbell, %g Pa: spin after it",
             modulus);
    TAP_OK(fabs(a.w[0]) + fabs(a.w[2]) + fabs(a.v[0] + b.v[0]) < 1e-9, "dumbbell: nothing else moves");
    TAP_OK(a.mass > 0.0 && fabs(a.mass + b.mass - 2.0*2500.0*4.0/3.0*world_pi*1e-9) < 1e-18,
           "dumbbell: mass");
    dem_free(d);
}

static const char *const springs = "rollingSpring { friction 0.1; damping 0.3; } "
                                   "twistingSpring { friction 0.2; damping 0.3; lever reduced; }";

/* a sphere, and a body of one, thrown at a floor and a wall with spin */
static void single(const char *laws)
{
    const char *const scene =
        "%s effects { hertz { } dry { restitution 0.7; } mindlin { friction 0.3; }"
        " gravity { acceleration (0 0 -9.81); } %s } %s"
        "walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); }"
        " side { type plane; material glass; point (0.003 0 0); normal (-1 0 0); } }"
        "insert { one { type list; material glass; %s positions ((0 0 0.0015)); velocity (0.2 0.1 -0.3);"
        " spin (30 -200 50); } }";
    struct dem *const sphere = world(world_text(scene, materials, laws, "", "diameter 2e-3;"), 0, NULL),
               *const body = world(world_text(scene, materials, laws, "shapes { s { spheres ((0 0 0 1e-3)); } }",
                                              "shape s;"), 0, NULL);
    double worst = 0.0, spun = 0.0;

    for (int k = 0; k < 40; k++)
    {
        world_run(sphere, 1e-3);
        world_run(body, 1e-3);
        const struct world_particle a = world_at(sphere, 0), b = world_at(body, 0);

        for (int c = 0; c < 3; c++)
        {
            worst = fmax(worst, fabs(a.x[c] - b.x[c]));
            spun = fmax(spun, fabs(a.w[c] - b.w[c]));
        }
    }
    TAP_OK(worst < 1e-12, "one sphere moves as a body of one, to %.2g m after impacts", worst);
    TAP_OK(spun < 1e-6, "and spins so, to %.2g/s", spun);
    dem_free(sphere);
    dem_free(body);
}

/* ---- conservation ---------------------------------------------------------------------------- */

/* momentum, and angular momentum about the origin, of the bodies */
static void moments(const struct dem *d, double p[3], double L[3])
{
    const struct dem_particles *const all = &d->state.particles;

    memset(p, 0, 3*sizeof *p);
    memset(L, 0, 3*sizeof *L);
    for (size_t i = 0; i < all->n; i++)
    {
        const struct dem_clump *const b = dem_clump_of(all, i);
        double orbit[3];

        if (dem_clump_counts(&all->record[i]))
        {
            dem_vec_cross(b->x, b->v, orbit);
            for (int k = 0; k < 3; k++)
            {
                p[k] += b->mass*b->v[k];
                L[k] += b->mass*orbit[k] + b->momentum[k];
            }
        }
    }
}

/* the largest distance [m] of a sphere from its place in its body */
static double bent(const struct dem *d)
{
    const struct dem_particles *const all = &d->state.particles;
    double worst = 0.0;

    for (size_t i = 0; i < all->n; i++)
    {
        const struct dem_clump *const b = dem_clump_of(all, i);
        double arm[3];

        dem_clump_rotate(b->q, b->offset, arm);
        for (int k = 0; k < 3; k++)
        {
            worst = fmax(worst, fabs(b->x[k] + arm[k] - all->record[i].x[k]));
        }
    }
    return worst;
}

static const char *const bent_shape =
    "shapes { bent { spheres ((0 0 0 1e-3) (1.2e-3 0 0 0.8e-3) (1.2e-3 1e-3 0 0.6e-3)); } }";

static struct dem *cloud(double step, const char *laws)
{
    return energy_world(
        world_text("%s %s effects { hertz { } mindlin { friction 0.4; } %s }"
                   "insert { a { type lattice; material glass; shape bent; count 8; min (0 0 0);"
                   " max (0.012 0.012 0.012); velocity (0.5 0 0); spin (100 0 200); }"
                   " b { type lattice; material glass; shape bent; count 8; min (0.0125 0.0005 0.0005);"
                   " max (0.0245 0.0125 0.0125); seed 5; velocity (-0.5 0.1 0); } } time { step %g; }",
                   materials, bent_shape, laws, step), 0, NULL);
}

static void conservation(const char *laws)
{
    double before[2][3], after[2][3], left[2];

    for (int k = 0; k < 2; k++)
    {
        struct dem *const d = cloud(k ? 5e-7 : 1e-6, laws);

        moments(d, before[0], before[1]);
        const double start = energy_term(d, "kinetic_translation") + energy_term(d, "kinetic_rotation");

        world_run(d, 0.03);
        moments(d, after[0], after[1]);
        left[k] = fabs(energy_term(d, "residual"))/start;
        if (k == 0)
        {
            const double size = 16.0*2500.0*6e-9*0.5;    /* M v of all */

            TAP_OK(energy_term(d, "kinetic_rotation") > 0.1*start, "bodies spin after impacts");
            TAP_OK(fabs(after[0][0] - before[0][0]) + fabs(after[0][1] - before[0][1]) < 1e-13*size,
                   "momentum is kept");
            TAP_OK(fabs(after[1][0] - before[1][0]) + fabs(after[1][2] - before[1][2]) < 1e-12*size*0.01,
                   "angular momentum is kept, to %.2g", fabs(after[1][2] - before[1][2])/(size*0.01));
            TAP_OK(bent(d) < 1e-16, "spheres stay in their places, to %.2g m", bent(d));
        }
        dem_free(d);
    }
    TAP_OK(left[0] < 2e-3 && left[1] < 0.7*left[0],
           "energy balance: residual %.2g of the energy at the start, %.2g at half the step", left[0], left[1]);
}

/* ---- frozen bodies ----------------------------------------------------------------------------- */

/* Spheres thrown on frozen bodies move as on frozen spheres at the same places, also in a fluid. */
static void frozen(const char *effects, const char *fluid)
{
    const char *const scene =
        "%s %s effects { hertz { } dry { restitution 0.7; } mindlin { friction 0.3; } gravity { acceleration (0 0 -9.81); }"
        " %s } %s insert { a { type list; material glass; frozen yes; %s }"
        " b { type list; material glass; diameter 1e-3; ids (10 11); positions ((0.0004 0.0003 0.0019) (0.0017 0.0001 0.0016));"
        " velocity (0.05 0.1 -0.3); } } time { step 1e-6; }";
    struct dem *const d = world(world_text(scene, materials, bent_shape, effects, fluid,
                                           "shape bent; orientation (1 0 0 0); positions ((0 0 0));"), 0, NULL);
    char places[400] = "";
    double worst = 0.0, moved = 0.0, forces = 0.0;

    for (int64_t k = 0; k < 3; k++)
    {
        const struct world_particle at = world_at(d, k);

        snprintf(places + strlen(places), 100, "(%.17g %.17g %.17g) ", at.x[0], at.x[1], at.x[2]);
    }
    struct dem *const s = world(world_text(scene, materials, "", effects, fluid,
                                           world_text("diameters (2e-3 1.6e-3 1.2e-3); positions (%s);", places)), 0, NULL);

    for (int k = 0; k < 10; k++)
    {
        world_run(d, 2e-3);
        world_run(s, 2e-3);
        for (int64_t i = 0; i < 12; i += i == 2 ? 8 : 1)
        {
            const struct world_particle a = world_at(d, i), b = world_at(s, i);

            for (int c = 0; c < 3; c++)
            {
                worst = fmax(worst, fabs(a.x[c] - b.x[c]));
                moved = i < 3 ? fmax(moved, fabs(a.v[c]) + fabs(a.w[c])) : moved;
                forces = i > 2 ? fmax(forces, fabs(a.v[c] - (c == 2 ? -0.3 - 9.81*2e-3*(k + 1) : c ? 0.1 : 0.05))) : forces;
            }
        }
    }
    TAP_OK(worst < 1e-12 && moved == 0.0, "spheres on a frozen body move as on frozen spheres, to %.2g m", worst);
    TAP_OK(forces > 0.1, "and rebound from it");
    dem_free(d);
    dem_free(s);
}

/* ---- a heap ---------------------------------------------------------------------------------- */

static void heap(void)
{
    struct dem *const d = world(
        world_text("%s %s effects { hertz { } dry { restitution 0.3; } mindlin { friction 0.5; }"
                   " gravity { acceleration (0 0 -9.81); } }"
                   "walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); }"
                   " tube { type cylinder; material glass; point (0.008 0.008 0); axis (0 0 1); radius 0.008; particles inside; } }"
                   "insert { nuts { type random; material glass; shape bent; count 40;"
                   " cylinder { from (0.008 0.008 0); to (0.008 0.008 0.04); radius 0.008; } } }", materials, bent_shape),
        0, NULL);
    double force[3], kinetic = 1.0;

    for (int k = 0; k < 12 && kinetic > 1e-13; k++)
    {
        world_run(d, 0.05);
        kinetic = world_tally(d).kinetic;
    }
    const struct dem_totals t = world_tally(d);
    double mass = 0.0;

    for (size_t i = 0; i < d->state.particles.n; i++)
    {
        mass += d->state.particles.record[i].mass;
    }
    world_wall(d, "floor", force);
    TAP_OK(t.particles == 120, "40 bodies are 120 spheres");
    TAP_OK(kinetic < 1e-10, "a heap comes to rest: %.2g J", kinetic);
    TAP_NEAR(t.mass/mass, 1.0, 1e-12, "masses of spheres are shares of their body's");
    double tube[3];

    world_wall(d, "tube", tube);
    TAP_NEAR(-(force[2] + tube[2])/(9.81*t.mass), 1.0, 1e-3, "floor and tube bear its weight");
    dem_free(d);
}

/* ---- streams and outlets ----------------------------------------------------------------------- */

/* bodies rain through a box with a hole in its floor */
static void rain(void)
{
    struct dem *const d = energy_world(
        world_text("%s %s effects { hertz { } dry { restitution 0.5; } mindlin { friction 0.5; }"
                   " gravity { acceleration (0 0 -9.81); } }"
                   "domain { min (0 0 -0.01); max (0.02 0.02 0.06); periodic (x y); }"
                   "walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); } }"
                   "insert { drops { type stream; material glass; shape bent; rate 1000; seed 2;"
                   " min (0 0 0.03); max (0.02 0.02 0.05); velocity (0.1 0.2 -1); spin (0 300 100); } }"
                   "outlets { hole { min (0 0 0); max (0.007 0.02 0.0015); } }", materials, bent_shape),
        0, NULL);

    world_run(d, 0.12);
    const struct dem_flow in = world_flow(d, 0), out = world_flow(d, 1);
    const struct dem_totals t = world_tally(d);
    const double M = d->scene.shapes.shape[0].volume*2500.0;
    const double scale = energy_term(d, "came");

    TAP_OK(in.particles >= 110 && in.particles <= 121, "a stream brings %lld bodies", (long long)in.particles);
    TAP_NEAR(in.mass/(M*(double)in.particles), 1.0, 1e-12, "each with its mass");
    TAP_OK(out.particles > 5, "an outlet takes %lld whole bodies", (long long)out.particles);
    TAP_NEAR(out.mass/(M*(double)out.particles), 1.0, 1e-12, "each with its mass");
    TAP_OK(t.particles == 3*(in.particles - out.particles), "%lld spheres are left", (long long)t.particles);
    /* the elastic energy of bodies that leave while they touch the floor is not in the balance */
    TAP_OK(fabs(energy_term(d, "residual")) < 0.02*scale, "energy balance: residual %.2g of what came in",
           energy_term(d, "residual")/scale);
    dem_free(d);
}

/* ---- time step ------------------------------------------------------------------------------- */

static double step_of(const char *shape)
{
    struct dem *const d = world(
        world_text("%s effects { hooke { stiffness 1e4; } } shapes { s { spheres (%s); } }"
                   "walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); } }"
                   "insert { one { type list; material glass; shape s; positions ((0 0 0.01)); } }",
                   materials, shape), 0, NULL);
    const double step = d->step;

    dem_free(d);
    return step;
}

/* One sphere: as without shapes. Two at one place have one mass and two springs. */
static void limits(void)
{
    struct dem *const d = world(
        world_text("%s effects { hooke { stiffness 1e4; } }"
                   "walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); } }"
                   "insert { one { type list; material glass; diameter 2e-3; positions ((0 0 0.01)); } }",
                   materials), 0, NULL);
    const double sphere = d->step;

    dem_free(d);
    TAP_NEAR(step_of("(0 0 0 1e-3)")/sphere, 1.0, 1e-12, "step of a body of one sphere");
    TAP_NEAR(step_of("(0 0 0 1e-3) (0 0 1e-9 1e-3)")/sphere, sqrt(0.5), 1e-4,
             "of two spheres at one place: 1/sqrt 2 of it");
    TAP_NEAR(step_of("(0 0 0 1e-3) (0.01 0 0 1e-3)")/sphere, 1.0, 1e-12, "of two far apart: as of one");
}

/* A plate of 16 x 16 spheres falls flat on a floor, with the automatic step. */
static void plate(void)
{
    static char text[20000];
    size_t used = 0;

    for (int k = 0; k < 256; k++)
    {
        used += (size_t)snprintf(text + used, sizeof text - used, "(%g %g 0 1e-3) ", 1e-4*(k%16), 1e-4*(k/16));
    }
    struct dem *const d = world(
        world_text("%s effects { hooke { stiffness 1e4; } dry { restitution 0.5; } }"
                   "shapes { s { spheres (%s); } }"
                   "walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); } }"
                   "insert { one { type list; material glass; shape s; orientation (1 0 0 0);"
                   " positions ((0 0 0.001)); velocity (0 0 -0.1); } }", materials, text), 0, NULL);
    double fastest = 0.0;

    for (int n = 0; n < 4000; n++)
    {
        world_step(d);
        fastest = fmax(fastest, fabs(world_at(d, 0).v[2]));
    }
    TAP_OK(fastest <= 0.1, "a plate of 256 spheres that falls flat gains no speed: %.3g of 0.1 m/s", fastest);
    TAP_OK(world_at(d, 0).x[2] > 0.9e-3, "and does not go through the floor");
    dem_free(d);
}

/* ---- rest ------------------------------------------------------------------------------------ */

/* Of 4 bodies of 8 spheres one moves: a quarter, and 1 of 32 spheres. */
static void quiet(void)
{
    struct dem *const d = world(
        world_text("%s effects { hertz { } } shapes { s { spheres ((0 0 0 1e-3) (1e-3 0 0 1e-3) (2e-3 0 0 1e-3)"
                   " (3e-3 0 0 1e-3) (0 1e-3 0 1e-3) (1e-3 1e-3 0 1e-3) (2e-3 1e-3 0 1e-3) (3e-3 1e-3 0 1e-3)); } }"
                   "insert { still { type list; material glass; shape s; positions ((0 0 0) (0.02 0 0) (0.04 0 0)); }"
                   " moving { type list; material glass; shape s; positions ((0.06 0 0)); velocity (0 0 0.1); } }",
                   materials), 0, NULL);
    struct dem_quiet q = {.wanted = 1, .moving = 0.1, .speed = 0.03, .lasting = 1e-9, .imbalance = 1.0,
                          .since = INFINITY};
    struct dem_totals t = world_tally(d);

    TAP_OK(t.particles == 32 && t.bodies == 4, "%lld spheres are %lld bodies", (long long)t.particles,
           (long long)t.bodies);
    TAP_NEAR(t.volume, 4.0*d->scene.shapes.shape[0].volume, 1e-20, "their volume is of the unions");
    TAP_NEAR(d->scene.initial.group[1].volume/d->scene.shapes.shape[0].volume, 1.0, 1e-12,
             "so it is in the summary of a group");
    for (int k = 0; k < 3; k++)
    {
        world_step(d);
        t = world_tally(d);
        WORLD_TRY(dem_quiet_test(d, &q, &t));
    }
    TAP_OK(!q.reached && q.move == 1, "1 of 4 bodies moves: not quiet at moving 0.1");
    q.moving = 0.3;
    for (int k = 0; k < 3; k++)
    {
        world_step(d);
        t = world_tally(d);
        WORLD_TRY(dem_quiet_test(d, &q, &t));
    }
    TAP_OK(q.reached, "quiet at moving 0.3");
    dem_free(d);
}

/* ---- restarts -------------------------------------------------------------------------------- */

static const char *restart_scene(const char *density, const char *shape)
{
    return world_text("materials { glass { density %s; youngsModulus 1e8; poissonsRatio 0.25; } }"
                      " effects { hertz { } } shapes { s { spheres (%s); } }"
                      "insert { g { type list; material glass; shape s; positions ((0 0 0)); } }", density, shape);
}

static void restart_refused(const char *file, const char *scene, const char *words)
{
    struct dem_case *const c = world_begin(scene);

    WORLD_TRY(dem_case_load(c, file));
    TAP_OK(world_status(c) != DEM_OK && strstr(dem_error_text(), words), "a restart is refused: %s",
           dem_error_text());
}

static void restarts(void)
{
    char file[] = "/tmp/clumps.XXXXXX";
    struct dem *const d = world(restart_scene("2500", "(0 0 0 1e-3) (1e-3 0 0 1e-3)"), 0, NULL);

    world_make_file(file);
    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    restart_refused(file, restart_scene("2600", "(0 0 0 1e-3) (1e-3 0 0 1e-3)"), "keep the shapes and densities");
    restart_refused(file, restart_scene("2500", "(0 0 0 1e-3) (1.1e-3 0 0 1e-3)"), "keep the shapes and densities");
    unlink(file);
}

/* ---- refusals -------------------------------------------------------------------------------- */

static void refused(const char *more, const char *group, const char *words)
{
    world_refused(world_text("%s effects { hertz { } } shapes { s { spheres ((0 0 0 1e-3)); } } %s"
                             "insert { g { type lattice; material glass; shape s; min (0 0 0);"
                             " max (0.01 0.01 0.01); %s } }", materials, more, group), words);
}

static void refusals(void)
{
    refused("", "diameter 1e-3;", "for spheres");
    refused("", "driven yes;", "not driven");
    world_refused(world_text("%s effects { hertz { } } shapes { s { spheres ((0 0 0 1e-3) (1e-3 0 0 1e-3)); } }"
                             "insert { g { type random; count 100; material glass; shape s; min (0 0 0);"
                             " max (0.01 0.01 0.01); } }", materials), "100 spheres, one around each clump");
    refused("", "orientation (1 1 0 0);", "unit quaternion");
    refused("", "shape t;", "shape");
    refused("shapes { t { spheres ((0 0 0 0)); } }", "", "radius above 0");
    refused("shapes { t { spheres (); } }", "", "has 0 spheres");
    refused("shapes { t { spheres ((0 0 0)); } }", "", "four numbers");
    refused("domain { min (0 0 0); max (0.02 0.02 0.02); flat (z); }", "", "domain/flat");
    refused("domain { min (0 0 0); max (0.0025 0.02 0.02); periodic (x); }", "max (0.0025 0.01 0.01);",
            "reaches its own image");
    refused("effects { rollingConstant { friction 0.1; } }", "", "rollingConstant resists the rotation");
    refused("effects { rollingViscous { time 1e-3; } }", "", "rollingViscous");
    refused("effects { liquidBridge { surfaceTension 0.07; } }", "liquidVolume 1e-12;", "liquidBridge changes liquidVolume");
    refused("", "spin (0 0 1e6);", "the limit is 0.3 rad");
}

int main(void)
{
    TAP_TRAPS;
    unions();
    chains();
    limits();
    plate();
    quiet();
    restarts();
    euler();
    dumbbell(1e8, 2e-3);
    dumbbell(1e13, 2e-5);
    single("");
    single(springs);
    conservation("");
    conservation(springs);
    frozen("", "");
    frozen("stokesDrag { }", "fluid { density 1; viscosity 1e-3; velocity (0.1 0 0.2); }");
    heap();
    rain();
    refusals();
    TAP_DONE;
}
