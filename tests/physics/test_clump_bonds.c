/*
 * test_clump_bonds.c -- bonds between rigid bodies of several spheres, and of them with single spheres:
 * bodies of one sphere move as the spheres; a beam under its load; breaking; conservation; the step.
 *
 * A straight rod of 3 spheres, bonded to a fixed sphere L before its first one, under the force F on its
 * centre, at the distance a = 3/2 L from the middle of the bond, and the moment T about it (bonded.h):
 *
 *   along the axis    the centre moves by F/(k_n A)
 *   across it         the rod turns by phi = (F a + T)/(k_n I), its centre moves by F/(k_t A) + a phi
 *   about the axis    it turns by T/(k_t J)
 *   it breaks at      |F|/A + |F a + T| R/I = normalStrength
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/bonded.h"
#include "physics/energy.h"

#include "case/simulation.h"
#include "particles/clump.h"
#include <math.h>

static const char *const rock =
    "materials { rock { density 2500; youngsModulus 1e9; poissonsRatio 0.25; } }"
    "shapes { rod { spheres ((-2e-3 0 0 1e-3) (0 0 0 1e-3) (2e-3 0 0 1e-3)); } one { spheres ((0 0 0 1e-3)); } }";

static const struct dem_clump *body(const struct dem *d, size_t k)
{
    return dem_clump_at(&d->state.particles, d->state.clumps.member[d->state.clumps.start[k]]);
}

/* Kick body k over h by a force and a moment. */
static void load(struct dem *d, size_t k, const double force[3], const double moment[3], double h)
{
    const struct dem_clumps *const c = &d->state.clumps;
    const double none[3] = {0.0, 0.0, 0.0};

    for (size_t m = c->start[k]; m < c->start[k + 1]; m++)
    {
        struct dem_clump *const b = dem_clump_at(&d->state.particles, c->member[m]);

        for (int a = 0; a < 3; a++)
        {
            b->v[a] += h*force[a]/b->mass;
            b->momentum[a] += h*moment[a];
        }
        dem_clump_fall(&d->state.particles, c->member[m], none, 0.0);
    }
}

/* ---- bodies of one sphere -------------------------------------------------------------------- */

static void single(void)
{
    const char *const scene =
        "%s effects { hertz { } dry { restitution 0.7; } mindlin { friction 0.3; } gravity { acceleration (0 0 -9.81); }"
        " bondLinear { normalStiffness 1e8; shearStiffness 0.5e8; make once; dampingRatio 0.05; walls yes; } }"
        "walls { floor { type plane; material rock; point (0 0 0); normal (0 0 1); } }"
        "insert { a { type list; material rock; %s positions ((0 0 1e-3) (1.8e-3 0.4e-3 1.7e-3)); velocity (0.01 0.02 0); }"
        " b { type list; material rock; %s positions ((3.6e-3 0 1.05e-3) (3.6e-3 1.9e-3 1.3e-3)); spin (0 5 20); } }";
    struct dem *const s = world(world_text(scene, rock, "diameter 2e-3;", "diameter 2e-3;"), 0, NULL),
               *const b = world(world_text(scene, rock, "shape one;", "shape one;"), 0, NULL),
               *const m = world(world_text(scene, rock, "shape one;", "diameter 2e-3;"), 0, NULL);
    double worst[2] = {0.0, 0.0}, moved = 0.0;

    TAP_NEAR(b->step/s->step, 1.0, 1e-12, "bodies of one sphere have the step of spheres");
    for (int k = 0; k < 20; k++)
    {
        struct dem *const all[3] = {s, b, m};

        for (int n = 0; n < 3; n++)
        {
            world_run(all[n], 5e-4);
        }
        for (int i = 0; i < 4; i++)
        {
            const struct world_particle p = world_at(s, i), q[2] = {world_at(b, i), world_at(m, i)};

            for (int c = 0; c < 3; c++)
            {
                worst[0] = fmax(worst[0], fabs(p.x[c] - q[0].x[c]));
                worst[1] = fmax(worst[1], fabs(p.x[c] - q[1].x[c]));
                moved = fmax(moved, fabs(p.v[c]));
            }
        }
    }
    TAP_OK(world_tally(s).bonds >= 4 && world_tally(b).bonds == world_tally(s).bonds,
           "%lld bonds of spheres and a wall", (long long)world_tally(s).bonds);
    TAP_OK(moved > 0.02 && worst[0] < 1e-12, "bonded bodies of one sphere move as spheres, to %.2g m", worst[0]);
    TAP_OK(worst[1] < 1e-12, "so do bodies bonded to spheres, to %.2g m", worst[1]);
    dem_free(s);
    dem_free(b);
    dem_free(m);
}

/* ---- a beam ---------------------------------------------------------------------------------- */

/* Body 0 is bonded to a fixed sphere. */
static struct dem *beam(double soft, const char *more)
{
    struct dem_new_particle root[1];

    chain_seeds(root, 1, 1);
    root[0].position[0] = -L;
    struct dem_case *const c = world_begin(world_text(
        "%s effects { bondLinear { normalStiffness %.17g; shearStiffness %.17g; %s } } time { maxOverlap 1; }"
        "insert { r { type list; material rock; shape rod; orientation (1 0 0 0); positions ((%g 0 0)); } }",
        rock, kn*soft, kt*soft, more, L));

    root[0].id = 100;
    WORLD_TRY(dem_case_add_particles(c, 1, root));
    return world_start(c);
}

static void rest(struct dem *d, const double force[3], const double moment[3])
{
    const double dt = d->step;

    for (int k = 0; k < 30000; k++)
    {
        load(d, 0, force, moment, 0.5*dt);
        world_step(d);
        load(d, 0, force, moment, 0.5*dt);
    }
}

static void bend(void)
{
    const double soft = 1e-4, F = 1e-5, T = 2e-8, a = 1.5*L, none[3] = {0.0, 0.0, 0.0};
    struct dem *d = beam(soft, "dampingRatio 1;");
    const struct dem_clump *b = body(d, 0);
    const double x = b->x[0];

    rest(d, (const double[3]){F, 0.0, 0.0}, none);
    TAP_NEAR((body(d, 0)->x[0] - x)*kn*soft*A/F, 1.0, 1e-6, "a rod under tension");
    dem_free(d);
    d = beam(soft, "dampingRatio 1;");
    rest(d, (const double[3]){0.0, F, 0.0}, (const double[3]){0.0, 0.0, T});
    b = body(d, 0);
    const double phi = (F*a + T)/(kn*soft*I);

    TAP_NEAR(2.0*asin(b->q[3])/phi, 1.0, 1e-4, "bent, it turns by %.3g", phi);
    TAP_NEAR(b->x[1]/(F/(kt*soft*A) + a*phi), 1.0, 1e-4, "and deflects by %.3g m", b->x[1]);
    TAP_NEAR(world_tally(d).stored/(0.5*F*b->x[1] + 0.5*T*phi), 1.0, 1e-4, "the bond has the work of the load");
    dem_free(d);
    d = beam(soft, "dampingRatio 1;");
    rest(d, none, (const double[3]){T, 0.0, 0.0});
    TAP_NEAR(2.0*asin(body(d, 0)->q[1])*kt*soft*J/T, 1.0, 1e-4, "twisted");
    dem_free(d);
}

/* The load rises in many periods to 0.999 or 1.001 of the strength. */
static void strength(void)
{
    const double soft = 1e-2, a = 1.5*L, none[3] = {0.0, 0.0, 0.0};

    for (int k = 0; k < 4; k++)
    {
        const int over = k%2, across = k/2, steps = 40000;
        const double limit = 1e5, full = (over ? 1.001 : 0.999)*limit/(across ? a*R/I : 1.0/A);
        struct dem *const d = beam(soft, "dampingRatio 1; normalStrength 1e5;");

        for (int n = 0; n < steps + 2000 && world_tally(d).broken == 0.0; n++)
        {
            double force[3] = {0.0, 0.0, 0.0};

            force[across ? 2 : 0] = full*chain_ramp(n, steps);
            load(d, 0, force, none, 0.5*d->step);
            world_step(d);
            load(d, 0, force, none, 0.5*d->step);
        }
        TAP_OK((world_tally(d).broken > 0.0) == over, "%s at %s of its strength: %s", across ? "bent" : "pulled",
               over ? "1.001" : "0.999", over ? "breaks" : "holds");
        dem_free(d);
    }
}

/* ---- conservation ---------------------------------------------------------------------------- */

static void moments(const struct dem *d, double p[3], double M[3])
{
    const struct dem_particles *const all = &d->state.particles;

    memset(p, 0, 3*sizeof *p);
    memset(M, 0, 3*sizeof *M);
    for (size_t i = 0; i < all->n; i++)
    {
        const struct dem_particle *const r = &all->record[i];
        const struct dem_clump *const b = dem_clump_of(all, i);
        const double m = b ? b->mass : r->mass;
        double orbit[3];

        vector_cross(b ? b->x : r->x, b ? b->v : r->v, orbit);
        for (int k = 0; k < 3 && dem_clump_counts(r); k++)
        {
            p[k] += m*(b ? b->v[k] : r->v[k]);
            M[k] += m*orbit[k] + (b ? b->momentum[k] : 0.4*m*r->radius*r->radius*r->w[k]);
        }
    }
}

/* Two rods, bent against each other, and a sphere. Returns the drift of the energy. */
static double chain(double step)
{
    struct dem *const d = energy_world(world_text(
        "%s effects { hertz { } mindlin { friction 0.4; } bondLinear { normalStiffness 5e9; shearStiffness 2e9; } }"
        "insert { a { type list; material rock; shape rod; orientation (1 0 0 0); positions ((0 0 0));"
        " velocity (0 0.02 0.03); spin (20 0 10); }"
        " b { type list; material rock; shape rod; orientation (0.9238795325112867 0 0 0.3826834323650898);"
        " positions ((0.005414213562373095 0.001414213562373095 0)); spin (0 -10 15); }"
        " c { type list; material rock; diameter 2e-3; positions ((0.008242640687119286 0.004242640687119286 0));"
        " velocity (0 0 -0.04); } } time { step %g; maxOverlap 1; }", rock, step), 0, NULL);
    double before[2][3], after[2][3], off[2] = {0.0, 0.0};
    const double start = energy_term(d, "kinetic_translation") + energy_term(d, "kinetic_rotation");

    moments(d, before[0], before[1]);
    world_run(d, 0.02);
    moments(d, after[0], after[1]);
    for (int k = 0; k < 3; k++)
    {
        off[0] = fmax(off[0], fabs(after[0][k] - before[0][k]));
        off[1] = fmax(off[1], fabs(after[1][k] - before[1][k]));
    }
    TAP_OK(world_tally(d).bonds == 2 && world_tally(d).stored > 1e-3*start, "two rods and a sphere: 2 bonds, %.2g "
           "of the energy in them", world_tally(d).stored/start);
    /* round-off of some 1e5 kicks; mass 3e-5 kg, speed 0.04 m/s, size 0.01 m */
    TAP_OK(off[0] < 1e-13*3e-5*0.04, "momentum is kept, to %.2g", off[0]/(3e-5*0.04));
    TAP_OK(off[1] < 1e-12*3e-5*0.04*0.01, "angular momentum is kept, to %.2g", off[1]/(3e-5*0.04*0.01));
    const double left = fabs(energy_term(d, "residual"))/start;

    dem_free(d);
    return left;
}

static void conservation(void)
{
    const double left[2] = {chain(4e-7), chain(2e-7)};

    TAP_OK(left[0] < 1e-3 && left[1] < 0.35*left[0],
           "energy balance: residual %.2g of the energy at the start, %.2g at half the step", left[0], left[1]);
}

/* ---- limits ---------------------------------------------------------------------------------- */

/* A plate of 64 small spheres with a large one, bonded to a wall by all: no speed comes from nothing, with the
   automatic step. */
static void plate(const char *damping)
{
    static char text[8000];
    size_t used = 0;

    for (int k = 0; k < 64; k++)
    {
        used += (size_t)snprintf(text + used, sizeof text - used, "(%g %g 0 1e-3) ", 3e-4*(k%8), 3e-4*(k/8));
    }
    struct dem *const d = world(world_text(
        "materials { rock { density 2500; youngsModulus 1e9; poissonsRatio 0.25; } }"
        "shapes { s { spheres (%s (1e-3 1e-3 4e-3 3e-3) (1e-3 1e-3 4e-3 3e-3) (1e-3 1e-3 8e-3 2e-4)); } }"
        "effects { bondLinear { normalStiffness 5e11; shearStiffness 2e11; walls yes; breakDistance 1.5; makeDistance 1.4; %s } }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }"
        "insert { one { type list; material rock; shape s; orientation (1 0 0 0);"
        " positions ((0 0 0.0043)); velocity (1e-3 0 -1e-3); spin (1 1 1); } }", text, damping), 0, NULL);
    const double start = world_tally(d).kinetic;
    double most = 0.0;

    for (int n = 0; n < 4000; n++)
    {
        world_step(d);
        most = fmax(most, world_tally(d).kinetic + world_tally(d).stored);
    }
    TAP_OK(world_tally(d).bonds > 60 && most < 1.02*start, "a plate on %lld bonds, %s: energy up to %.4g of its start",
           (long long)world_tally(d).bonds, damping, most/start);
    dem_free(d);
}

static void refusals(void)
{
    world_refused(world_text("%s effects { bondLinear { normalStiffness 1e9; shearStiffness 1e9; make listed; } }"
                             "bonds { pairs (0 1); } insert { r { type list; material rock; shape rod; positions ((0 0 0)); } }",
                             rock), "of one clump");
}

int main(void)
{
    TAP_TRAPS;
    single();
    bend();
    strength();
    conservation();
    plate("dampingRatio 0;");
    plate("dampingRatio 1;");
    refusals();
    TAP_DONE;
}
