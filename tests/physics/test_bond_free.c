/*
 * test_bond_free.c -- bonded particles in free motion keep momentum and energy; contact and adhesion return when a bond breaks; bonds are damped, made by chance,
 * removed and reported as documented.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/bonded.h"

#include "core/random.h"

static double drawn(int k, int use)
{
    return 2.0*dem_random_unit(7, (uint64_t)k, 0, (uint64_t)use) - 1.0;
}

static double apart(const double a[3], const double b[3])
{
    const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};

    return sqrt(vector_dot(d, d));
}

static double size(const double a[3])
{
    return sqrt(vector_dot(a, a));
}

/* Advance and compare; scales are sums of magnitudes, because the totals may vanish. */
static void conserves(const char *what, struct dem *d, int n, double time, double energy_within)
{
    struct world_particle p[MAX_CHAIN];
    double momentum[2][3], angular[2][3], kinetic[2], scale[2] = {0.0, 0.0};
    const double before = world_tally(d).stored;

    world_all(d, p);
    for (int k = 0; k < n; k++)
    {
        scale[0] += p[k].mass*size(p[k].v);
        scale[1] += p[k].mass*size(p[k].x)*size(p[k].v) +
                    0.4*p[k].mass*p[k].radius*p[k].radius*size(p[k].w);
    }
    chain_totals(d, n, momentum[0], angular[0], &kinetic[0]);
    world_run(d, time);
    chain_totals(d, n, momentum[1], angular[1], &kinetic[1]);
    const struct dem_totals t = world_tally(d);

    TAP_NEAR(apart(momentum[1], momentum[0]), 0.0, 1e-12*scale[0], "%s: momentum", what);
    TAP_NEAR(apart(angular[1], angular[0]), 0.0, 1e-12*scale[1], "%s: angular momentum", what);
    TAP_NEAR(kinetic[1] + t.stored, kinetic[0] + before, energy_within*kinetic[0], "%s: energy",
             what);
    TAP_OK(t.lost == 0.0 && t.broken == 0.0 && t.bonds >= n - 1,
           "%s: %d bonds hold, nothing is lost", what, (int)t.bonds);
}

/* |F_t| of the bond between particles 0 and 1 */
static double shear_of(const struct dem *d)
{
    const struct world_particle a = world_at(d, 0), b = world_at(d, 1);
    const double r[3] = {a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]},
                 along = vector_dot(a.f, r)/vector_dot(r, r);
    const double shear[3] = {a.f[0] - along*r[0], a.f[1] - along*r[1], a.f[2] - along*r[2]};

    return size(shear);
}

static struct dem *turning(const double omega[3], double soft, const char *more)
{
    struct dem_new_particle seed[2];

    chain_seeds(seed, 2, 0);
    for (int k = 0; k < 2; k++)
    {
        const double arm[3] = {k ? 0.5*L : -0.5*L, 0.0, 0.0};

        vector_cross(omega, arm, seed[k].velocity);
        memcpy(seed[k].spin, omega, 3*sizeof *omega);
    }
    return bonded(soft, 0.0, more, 2, seed);
}

/* At 10 1/s; bonds are soft, for long steps. With the slip as printed in Kasuga's note the shear
   force would be k_t A r Omega t = 628 k_t A L. */
static void turning_pair(void)
{
    const double soft = 1e-4, slanted[3] = {4.8, -6.0, 6.4}, upright[3] = {0.0, -6.0, 8.0},
                 m = world_sphere_mass(R, 2500.0);
    struct dem *d = turning(slanted, soft, "");

    conserves("a pair that turns ten times about a slanted axis", d, 2, 2.0*world_pi, 1e-6);
    /* its axis is not a principal axis, so shear keeps it rotating: less than the centripetal
       force, and as much again during the transient */
    TAP_OK(shear_of(d) < m*100.0*L, "it is sheared by inertia alone, %.3g k_t A L",
           shear_of(d)/(soft*kt*A*L));
    dem_free(d);
    d = turning(upright, soft, "dampingRatio 0.5;");
    const double before = world_tally(d).kinetic;

    world_run(d, 2.0*world_pi);
    const struct dem_totals t = world_tally(d);

    TAP_NEAR(shear_of(d), 0.0, 1e-9*soft*kt*A*L,
             "rotating about an axis normal to it, it is not sheared after the transient");
    TAP_NEAR(t.kinetic + t.stored + t.lost, before, 1e-8*before,
             "the loss of the transient is in the totals");
    dem_free(d);
}

/* n spheres of different sizes in a row with a bend, with random velocities and spins; steps of
   1/100 of the limit */
static struct dem *random_chain(int n, double fraction)
{
    struct dem_new_particle seed[MAX_CHAIN];
    double x = 0.0, before = 0.0;

    memset(seed, 0, sizeof seed);
    for (int k = 0; k < n; k++)
    {
        const double radius = R*(1.0 + 0.3*drawn(k, 0));

        seed[k] = (struct dem_new_particle){
            .position = {x += k ? before + radius : 0.0, 0.0, 0.0}, .diameter = 2.0*radius,
            .velocity = {0.05*drawn(k, 1), 0.05*drawn(k, 2), 0.05*drawn(k, 3)},
            .spin = {30.0*drawn(k, 4), 30.0*drawn(k, 5), 30.0*drawn(k, 6)}, .id = k,
            .material = "rock"};
        before = radius;
    }
    /* automatic step of spheres of 0.7 R: 0.7 of 5.16e-7 s */
    return bonded(1e-2, fraction*3e-6, "", n, seed);
}

static void triangle(void)
{
    struct dem_new_particle seed[3];

    memset(seed, 0, sizeof seed);
    for (int k = 0; k < 3; k++)
    {
        const double angle = 2.0*world_pi*k/3.0, r = L/sqrt(3.0);

        seed[k] = (struct dem_new_particle){
            .position = {r*cos(angle), r*sin(angle), 0.0},
            .velocity = {0.02*drawn(k, 7), 0.02*drawn(k, 8), 0.02*drawn(k, 9)},
            .spin = {9.0*drawn(k, 1), 9.0*drawn(k, 2), 9.0*drawn(k, 3)}, .diameter = 2.0*R, .id = k,
            .material = "rock"};
    }
    struct dem *const d = bonded(1e-2, 2e-8, "", 3, seed);

    conserves("a triangle", d, 3, 2e-3, 1e-6);
    dem_free(d);
}

/* ---- contact and bond ------------------------------------------------------------------------ */

/* A pair made with an overlap of 0.5 %, with Hertz's law beside the bond; moved apart or together,
   and broken by a twist. */
static struct dem *bonded_contact(const char *adhesion, const char *more)
{
    char *const scene = world_text(
        "materials { rock { density 2500; youngsModulus 1e9; poissonsRatio 0.25; } }"
        "effects { hertz { } dry { restitution 0.9; } mindlin { friction 0.5; } %s"
        " bondLinear { normalStiffness %g; shearStiffness %g; %s } } time { step 1e-7; }",
        adhesion, kn, kt, more);
    const struct dem_new_particle seed[2] =
        {{.position = {0, 0, 0}, .diameter = 2.0*R, .id = 0, .material = "rock", .frozen = 1},
         {.position = {0.995*L, 0, 0}, .diameter = 2.0*R, .id = 1, .material = "rock"}};
    return world(scene, 2, seed);
}

static struct dem *overlapping(const char *more)
{
    return bonded_contact("", more);
}

static void move_steps(struct dem *d, double along, double twist, int steps)
{
    const double dt = dem_step_limit(d).used, v[3] = {along/dt, 0.0, 0.0},
                 w[3] = {twist/dt, 0.0, 0.0};

    for (int k = 0; k < steps && world_tally(d).broken == 0.0; k++)
    {
        const struct world_particle p = world_at(d, 1);

        chain_set(d, 1, v, w);
        chain_kick(d, 1, p.f, p.t, -0.5*dt);
        world_step(d);
    }
}

static void hand_over(void)
{
    const double E = 1e9/(2.0*(1.0 - 0.0625)), able = 4.0/3.0*E*sqrt(0.5*R)*pow(0.005*L, 1.5);
    struct dem *d = overlapping("shearStrength 5e6;");
    const double none[3] = {0.0, 0.0, 0.0};

    TAP_NEAR(world_at(d, 1).f[0], 0.0, 0.0, "the contact of a bonded pair has no force");
    TAP_NEAR(world_tally(d).lost, 0.4*able*0.005*L, 1e-9*able*L,
             "its elastic energy is reported as lost");
    move_steps(d, 0.0, 0.0, 3);
    TAP_NEAR(world_at(d, 1).f[0], 0.0, 1e-12*able, "nor after ten steps");
    dem_free(d);

    /* the bond carries half of the contact force of this overlap; then a twist breaks it */
    d = overlapping("shearStrength 5e6;");
    move_steps(d, -0.5*able/(kn*A)/50.0, 0.0, 50);
    const double pressed = world_at(d, 1).f[0];

    move_steps(d, 0.0, 1e-4, 10000);
    TAP_OK(world_tally(d).broken == 1.0, "a twist breaks it");
    TAP_NEAR(world_at(d, 1).f[0], pressed, 1e-9*pressed,
             "in the step in which it breaks the contact has the bond's force");
    chain_set(d, 1, none, none);
    chain_kick(d, 1, world_at(d, 1).f, world_at(d, 1).t, -0.5e-7);
    world_step(d);
    TAP_NEAR(world_at(d, 1).f[0], pressed, 1e-9*pressed, "and in the next step");
    dem_free(d);

    /* broken in tension the force is 0, though the surfaces still overlap */
    d = overlapping("shearStrength 5e6;");
    move_steps(d, 0.5*able/(kn*A)/50.0, 0.0, 50);
    TAP_OK(world_at(d, 1).f[0] < -0.4*able, "the bond pulls");
    move_steps(d, 0.0, 1e-4, 10000);
    chain_set(d, 1, none, none);
    world_step(d);
    TAP_NEAR(world_at(d, 1).f[0], 0.0, 1e-9*able, "broken in tension, there is no force");
    const double in[3] = {-0.1, 0.0, 0.0};

    chain_set(d, 1, in, none);
    world_run(d, 1e-6);
    TAP_OK(world_at(d, 1).f[0] > 0.0, "a force acts when they come nearer");
    dem_free(d);

    d = overlapping("contact parallel;");
    TAP_NEAR(world_at(d, 1).f[0], able, 1e-9*able,
             "in parallel the contact force is that without a bond");
    dem_free(d);
}

/* Surfaces of a bonded pair, and of a broken one that have not separated since, do not adhere. */
static void adhesion_of_bonded(const char *adhesion, double pull)
{
    const double E = 1e9/(2.0*(1.0 - 0.0625)),
                 able = 4.0/3.0*E*sqrt(0.5*R)*pow(0.005*L, 1.5),
                 none[3] = {0.0, 0.0, 0.0};
    struct dem *d = bonded_contact(adhesion, "shearStrength 5e6;"), *const bare =
                                                                  overlapping("shearStrength 5e6;");

    TAP_NEAR(world_at(d, 1).f[0], 0.0, 0.0, "%s: no force on a pair just bonded", adhesion);
    move_steps(d, -0.5*able/(kn*A)/50.0, 0.0, 50);
    move_steps(bare, -0.5*able/(kn*A)/50.0, 0.0, 50);
    const double pressed = world_at(d, 1).f[0];

    TAP_NEAR(pressed, world_at(bare, 1).f[0], 0.0,
             "%s: a bonded pair has the force of its bond alone", adhesion);
    move_steps(d, 0.0, 1e-4, 10000);
    TAP_OK(world_tally(d).broken == 1.0, "%s: a twist breaks it", adhesion);
    TAP_NEAR(world_at(d, 1).f[0], pressed, 1e-9*pressed,
             "%s: in that step the contact has the bond's force", adhesion);
    chain_set(d, 1, none, none);
    chain_kick(d, 1, world_at(d, 1).f, world_at(d, 1).t, -0.5e-7);
    world_step(d);
    TAP_NEAR(world_at(d, 1).f[0], pressed, 1e-9*pressed, "%s: and in the next step", adhesion);

    /* out until they have separated; then in again, where they adhere */
    double least = 0.0;

    for (int k = 0; k < 60; k++)
    {
        const double v[3] = {0.02*0.005*L/1e-7, 0.0, 0.0};

        chain_set(d, 1, v, none);
        world_step(d);
    }
    TAP_NEAR(world_at(d, 1).f[0], 0.0, 0.0, "%s: no force when separated", adhesion);
    const double in[3] = {-1e-3*0.005*L/1e-7, 0.0, 0.0};

    for (int k = 0; k < 400; k++)
    {
        chain_set(d, 1, in, none);
        world_step(d);
        least = fmin(least, world_at(d, 1).f[0]);
    }
    TAP_OK(least < -0.5*pull, "%s: surfaces that meet again adhere: %g N", adhesion, least);
    dem_free(d);
    dem_free(bare);

    d = bonded_contact(adhesion, "contact parallel;");
    TAP_OK(world_at(d, 1).f[0] < able - 0.5*pull,
           "%s: with contact parallel they adhere beside the bond", adhesion);
    dem_free(d);
}

/* ---- damping --------------------------------------------------------------------------------- */

/* An isolated pair, or one sphere at a wall, starts with the velocity (axis 0 to 2) or spin
   (3 to 5) of one mode, with bonds of these damping entries; what is left of it after the time. */
static double left_of_mode(const char *entries, int wall, int axis, double time)
{
    const double v = axis < 3 ? 1e-6 : 1e-3, share = wall ? 1.0 : 0.5;
    struct dem_new_particle seed[2];
    char *const scene = world_text(
        "materials { rock { density 2500; youngsModulus 1e9; poissonsRatio 0.25; } }"
        "effects { bondLinear { normalStiffness %.17g; shearStiffness %.17g; %s walls yes; } }"
        "%s time { step %.17g; maxOverlap 1; }",
        kn*0.01, kt*0.01, entries,
        wall ? "walls { side { type plane; point (-1e-3 0 0); normal (1 0 0); } }" : "",
        time/20000.0);

    chain_seeds(seed, 2, 0);
    for (int i = 0; i < 2; i++)
    {
        double *const motion = axis < 3 ? seed[i].velocity : seed[i].spin;

        motion[axis%3] = (i ? -share : share)*v;
    }
    /* slip without rolling: the momentum of the force, and its moments on both */
    if (axis == 1)
    {
        seed[0].spin[2] = seed[1].spin[2] = 2.5*share*v/R;
    }
    struct dem *const d = world(scene, wall ? 1 : 2, seed);

    world_run(d, time);
    const struct world_particle p = world_at(d, 0);

    dem_free(d);
    return (axis < 3 ? p.v : p.w)[axis%3]/(share*v);
}

/* Damped by zeta of critical it is v = exp(-zeta w t) (cos w_d t - zeta w/w_d sin w_d t),
   w_d = w sqrt(1 - zeta^2): -exp(-pi zeta/sqrt(1 - zeta^2)) after half a period. */
static void damped(const char *what, int wall, int axis, double frequency)
{
    const double root = sqrt(1.0 - 0.3*0.3);

    /* 1/20000 of half a period, first order with damping */
    TAP_NEAR(left_of_mode("dampingRatio 0.3;", wall, axis, world_pi/(frequency*root)),
             -exp(-world_pi*0.3/root), 5e-5, "%s: damped by 0.3 of critical", what);
}

/* A share eta of the spring's force against its velocity: outwards the stiffness is k (1 + eta), back
   k (1 - eta), so that -sqrt((1 - eta)/(1 + eta)) of the velocity is left at the next passage. With
   shares of the other motions only, nothing is lost. */
static void damped_by_share(const char *what, const char *word, int axis, double frequency)
{
    static const char *const words[] = {"normal", "shear", "twist", "bending"};
    const double eta = 0.3, half = world_pi/frequency,
                 slower = 0.5/sqrt(1.0 + eta) + 0.5/sqrt(1.0 - eta);

    for (int own = 0; own < 2; own++)
    {
        char shares[256] = "";

        for (int k = 0; k < 4; k++)
        {
            const int here = strcmp(words[k], word) == 0;

            snprintf(shares + strlen(shares), sizeof shares - strlen(shares), "%sDampingShare %g; ",
                     words[k], here == own ? eta : 0.0);
        }
        /* first order in 1/20000 of the half period, and the smoothing where it reverses */
        TAP_NEAR(left_of_mode(shares, 0, axis, own ? slower*half : half),
                 own ? -sqrt((1.0 - eta)/(1.0 + eta)) : -1.0, 5e-4, "%s: %s", what, shares);
    }
}

static void damping(void)
{
    const double m = world_sphere_mass(R, 2500.0), I_p = 0.4*m*R*R, k = kn*0.01, g = kt*0.01;

    damped("a pair, stretched", 0, 0, sqrt(k*A*2.0/m));
    damped("a pair, sheared", 0, 1, sqrt(g*A*7.0/m));
    damped("a pair, twisted", 0, 3, sqrt(g*J*2.0/I_p));
    damped("a pair, bent", 0, 4, sqrt(k*I*2.0/I_p));
    damped_by_share("a pair, stretched", "normal", 0, sqrt(k*A*2.0/m));
    damped_by_share("a pair, sheared", "shear", 1, sqrt(g*A*7.0/m));
    damped_by_share("a pair, twisted", "twist", 3, sqrt(g*J*2.0/I_p));
    damped_by_share("a pair, bent", "bending", 4, sqrt(k*I*2.0/I_p));
    damped("at a wall, twisted", 1, 3, sqrt(g*J/I_p));
}

/* ---- walls, removal, probability ------------------------------------------------------------- */

static void hanging(void)
{
    char *const scene = world_text(
        "materials { rock { density 2500; youngsModulus 1e9; poissonsRatio 0.25; } }"
        "effects { gravity { acceleration (0 0 -9.81); }"
        " bondLinear { normalStiffness %g; shearStiffness %g; walls yes; dampingRatio 0.3; } }"
        "walls { lid { type plane; point (0 0 %.17g); normal (0 0 -1); } side { type triangles; "
        "corners"
        " ((0.05 -1 -1) (0.05 1 -1) (0.05 1 1)); } }",
        kn*1e-4, kt*1e-4, R);
    const struct dem_new_particle seed[2] =
        {{.position = {0, 0, 0}, .diameter = 2.0*R, .id = 0, .material = "rock"},
         {.position = {0.05 - R, -0.5, -0.8}, .diameter = 2.0*R, .id = 1, .material = "rock"}};
    struct dem *const d = world(scene, 2, seed);
    const double weight = 9.81*world_sphere_mass(R, 2500.0), ktA = kt*1e-4*A,
                 arm = R*R*ktA/(kn*1e-4*I);

    world_run(d, 0.05);
    const struct world_particle p = world_at(d, 0), q = world_at(d, 1);

    TAP_OK(world_tally(d).bonds == 2, "bonded to a plane and to a triangle");
    TAP_NEAR(p.x[2], -weight/(kn*1e-4*A), 1e-3*weight/(kn*1e-4*A),
             "one hangs at the elongation of its bond");
    /* a cantilever of one element: shear, and bending by weight times arm, which rotates the arm */
    TAP_NEAR(q.x[2] + 0.8, -weight/ktA*(1.0 + arm), 2e-3*weight/ktA*(1.0 + arm),
             "one is held as a cantilever, by shear and bending");
    dem_free(d);
}

/* The middle one of five leaves the domain and is removed; the bonds of the others stay. */
static void removal(void)
{
    char *const scene =
        world_text("materials { rock { density 2500; youngsModulus 1e9; poissonsRatio 0.25; } }"
                   "domain { min (-1 -1 -1); max (1 1 1); leaving remove; }"
                   "effects { bondLinear { normalStiffness %g; shearStiffness %g; } }",
                   kn, kt);
    struct dem_new_particle seed[5];

    chain_seeds(seed, 5, 0);
    for (int k = 0; k < 5; k++)
    {
        seed[k].position[0] += 1.0 - 4.5*L;               /* the last one half out */
        seed[k].velocity[0] = 0.05;
    }
    struct dem *const d = world(scene, 5, seed);

    world_run(d, 0.05);
    const struct dem_totals t = world_tally(d);

    TAP_OK(t.particles < 5 && t.particles > 1 && t.bonds == t.particles - 1 && t.broken == 0.0,
           "%d of a chain are left, with %d bonds", (int)t.particles, (int)t.bonds);
    dem_free(d);
}

/* A pair through a periodic face, loaded and broken: the list of bonds and the list of broken
   bonds. */
static void reported_bonds(double along, double across, int cause, const char *more)
{
    char *const scene = world_text(
        "materials { rock { density 2500; youngsModulus 1e9; poissonsRatio 0.25; } }"
        "domain { min (0 0 0); max (%g 0.01 0.01); periodic (x); }"
        "effects { bondLinear { normalStiffness %.17g; shearStiffness %.17g; "
        "%s } } time { step 1e-7; }",
        5.0*L, kn, kt, more);
    const struct dem_new_particle seed[2] = {
        {.position = {0.25*L, 0.005, 0.005}, .diameter = 2.0*R, .id = 4, .material = "rock",
         .frozen = 1},
        {.position = {4.25*L, 0.005, 0.005}, .diameter = 2.0*R, .id = 7, .material = "rock"}};
    struct dem *const d = world(scene, 2, seed);
    const double v[3] = {-along/1e-7, across/1e-7, 0.0}, none[3] = {0.0, 0.0, 0.0};
    const struct dem_bond *bond;
    const struct dem_broken_bond *broke;
    int64_t n;

    chain_set(d, 7, v, none);
    world_step(d);
    WORLD_TRY(dem_bonds(d, &n, &bond));
    TAP_OK(dem_has_bonds(d) && n == 1 && bond->id[0] == 4 && bond->id[1] == 7,
           "%s: one bond, of 4 and 7", more);
    /* the neighbour through the face is at -0.75 L; moved by along away from it; shear is one of
       second order longer */
    TAP_NEAR(bond->branch[0], L + along, 1e-12*L, "%s: branch to the neighbor through the face",
             more);
    TAP_NEAR(bond->force[0], -kn*A*along, 1e-3*kn*A*(along + across),
             "%s: the lower id is pulled", more);
    TAP_NEAR(bond->force[1], kt*A*across, 1e-3*kn*A*(along + across), "%s: and sheared", more);
    const double stored = bond->stored;

    TAP_NEAR(stored, 0.5*kn*A*along*along + 0.5*kt*A*across*across, 1e-3*stored,
             "%s: its energy", more);
    WORLD_TRY(dem_broken_bonds(d, &n, &broke));
    TAP_OK(n == 0, "%s: no bond broken yet", more);
    for (int k = 0; k < 10000 && world_tally(d).broken == 0.0; k++)
    {
        chain_set(d, 7, v, none);
        world_step(d);
    }
    WORLD_TRY(dem_bonds(d, &n, &bond));
    TAP_OK(n == 0, "%s: then no bond is left", more);
    WORLD_TRY(dem_broken_bonds(d, &n, &broke));
    TAP_OK(n == 1 && broke->id[0] == 4 && broke->id[1] == 7 && broke->cause == cause,
           "%s: broken by cause %d", more, cause);
    TAP_NEAR(broke->energy, world_tally(d).lost, 0.0, "%s: with its energy", more);
    TAP_NEAR(broke->time, world_tally(d).time, 1e-12, "%s: at its time", more);
    WORLD_TRY(dem_broken_bonds(d, &n, &broke));
    TAP_OK(n == 0, "%s: reported once", more);
    dem_free(d);
}

static int64_t lattice_bonds(int seed, double probability)
{
    struct dem *const d = world(world_text(
        "materials { rock { density 2500; youngsModulus 1e9; poissonsRatio 0.25; } }"
        "effects { bondLinear { normalStiffness %g; shearStiffness %g; makeDistance 1.05; "
        "probability %g; seed %d; } }"
        "insert { all { type lattice; count 1000; diameter 1e-3; spacing 1.02; jitter 0; "
        "min (0 0 0);"
        " max (0.01025 0.01025 0.01025); } }",
        kn, kt, probability, seed), 0, NULL);
    const int64_t bonds = world_tally(d).bonds;

    dem_free(d);
    return bonds;
}

/* relative change of the kinetic energy of two spheres that meet and are bonded by a spring that
   bears next to no tension; 1/part of the automatic step */
static double pushed(int part)
{
    const struct dem_new_particle two[2] = {
        {.diameter = 2e-3, .material = "a"},
        {.position = {2.05e-3, 0.0, 0.0}, .velocity = {-0.2, 0.0, 0.0}, .diameter = 2e-3, .id = 1,
         .material = "a"}};
    static const char *const text =
        "materials { a { density 2500; youngsModulus 1e7; } } effects { hertz { impactSpeed 1; } "
        "bondLinear { normalStiffness 3e9; shearStiffness 0; make always; normalStrength 1; } } %s";
    struct dem *d = world(world_text(text, ""), 2, two);
    const double step = dem_step_limit(d).used/part;

    dem_free(d);
    d = world(world_text(text, world_text("time { step %.17g; }", step)), 2, two);
    world_run(d, 0.01);

    const double square = pow(world_at(d, 0).v[0], 2) + pow(world_at(d, 1).v[0], 2);
    const double away = world_at(d, 1).x[0] - world_at(d, 0).x[0];

    dem_free(d);
    return away > 2.01e-3 ? fabs(square/0.04 - 1.0) : 1.0;
}

int main(void)
{
    TAP_TRAPS;
    turning_pair();
    triangle();
    struct dem *const d = random_chain(20, 0.01);

    conserves("a chain of 20", d, 20, 2e-4, 1e-6);
    dem_free(d);
    hand_over();
    /* 3/2 pi w R*; w 2 pi R* d at a tenth of the first overlap */
    adhesion_of_bonded("jkr { workOfAdhesion 10; }", 1.5*world_pi*10.0*0.5*R);
    adhesion_of_bonded("sjkr { energyDensity 1e8; }", 1e8*2.0*world_pi*0.5*R*0.1*0.005*L);
    damping();
    hanging();

    const double coarse = pushed(1), fine = pushed(16);

    TAP_OK(coarse < 5e-3 && fine < coarse/32.0,
           "a bond that is made by a push and breaks after it: energy to second order in the step "
           "(%.1e, a sixteenth of the step %.1e)", coarse, fine);
    removal();
    reported_bonds(1e-5*L, 0.0, 1, "normalStrength 1e6;");
    reported_bonds(0.0, 1e-5*L, 2, "shearStrength 1e6;");
    reported_bonds(1e-4*L, 0.0, 3, "breakDistance 1.01;");

    const int64_t all = lattice_bonds(1, 1.0), some = lattice_bonds(1, 0.3);

    TAP_OK(all == 2700, "all %d neighbors of a lattice bond", (int)all);
    TAP_NEAR((double)some, 810.0, 4.0*sqrt(2700.0*0.3*0.7), "of probability 0.3, %d",
             (int)some);   /* four standard deviations */
    TAP_OK(lattice_bonds(1, 0.3) == some && lattice_bonds(2, 0.3) != some,
           "the same seed gives the same bonds, another seed others");
    TAP_DONE;
}
