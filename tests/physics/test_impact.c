/*
 * test_impact.c -- head-on impacts with Hertz's law have the peak force, overlap and duration of
 * the closed form, the order of the leapfrog, and the restitution that is set.
 *
 * Sources: Chung and Ooi, Granul. Matter 13 (2011) 643; closed forms of hertz_normal.csv.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

enum
{
    /* impacts that begin at evenly spaced fractions of a step */
    PHASES = 16
};

/* what is needed to set up a head-on impact */
struct impact
{
    const char *name;
    double radius, E, nu, density,
        speed;                 /* m, Pa, 1, kg/m3, m/s: of each sphere; the wall is rigid */
    int wall;
    double force, overlap, time;                          /* N, m, s: expected */
};

/* the reduced quantities: two equal spheres, or a sphere and a rigid wall */
static double reduced_modulus(const struct impact *i)
{
    return (i->wall ? 1.0 : 0.5)*i->E/(1.0 - i->nu*i->nu);
}

static double contact_time(const struct impact *i)
{
    const double share = i->wall ? 1.0 : 0.5;

    return world_contact_time(share*world_sphere_mass(i->radius, i->density), share*i->radius,
                              reduced_modulus(i), i->wall ? i->speed : 2.0*i->speed);
}

static struct dem *start(const struct impact *i, double step, const char *damping)
{
    const double approach = i->wall ? i->speed : 2.0*i->speed;
    struct dem_new_particle seed[2*PHASES];
    int n = 0;

    memset(seed, 0, sizeof seed);
    for (int k = 0; k < PHASES; k++)
    {
        const double gap = approach*step*(3.0 + (k + 0.5)/PHASES), y = 4.0*i->radius*k;

        for (int s = 0; s < (i->wall ? 1 : 2); s++, n++)
        {
            seed[n] =
                (struct dem_new_particle){
                    .position = {0.0, y, s ? -i->radius - gap : i->radius},
                    .diameter = 2.0*i->radius, .id = n, .material = "ball"};
            seed[n].velocity[2] = s ? i->speed : -i->speed;
            seed[n].position[2] += i->wall ? gap : 0.0;
        }
    }
    return world(world_text(
        "materials { ball { density %.17g; youngsModulus %.17g; poissonsRatio %.17g; }"
        " rigid { density 1; youngsModulus 1e30; } }"
        "effects { hertz { impactSpeed %g; } %s } time { step %.17g; } %s",
        i->density, i->E, i->nu, approach, damping, step,
        i->wall ? "walls { floor { type plane; material rigid; point (0 0 0); normal (0 0 1); } }"
        : ""), n, seed);
}

struct outcome
{
    double restitution[PHASES], mean, worst;              /* worst: largest |e - 1| */
    /* N, m, s: peaks of the first impact, its duration in steps */
    double force, overlap, time;
};

/* Step until all have separated. */
static struct outcome run(const struct impact *i, double step, const char *damping)
{
    struct dem *const d = start(i, step, damping);
    struct outcome o = {.mean = 0.0};
    int touched = 0;

    for (int k = 0; k < 100000; k++)
    {
        world_step(d);
        const struct dem_totals t = world_tally(d);
        const struct world_particle p = world_at(d, 0);
        const double overlap =
            i->wall ? p.radius - p.x[2] : 2.0*p.radius - p.x[2] + world_at(d, 1).x[2];

        o.force = fmax(o.force, p.f[2]);
        o.overlap = fmax(o.overlap, overlap);
        o.time += overlap > 0.0 ? step : 0.0;
        touched |= t.contacts > 0;
        if (touched && t.contacts == 0)
        {
            break;
        }
    }
    for (int k = 0; k < PHASES; k++)
    {
        const double out = i->wall ? world_at(d, k).v[2]
                                   : 0.5*(world_at(d, 2*k).v[2] - world_at(d, 2*k + 1).v[2]);

        o.restitution[k] = out/i->speed;
        o.mean += o.restitution[k]/PHASES;
        o.worst = fmax(o.worst, fabs(o.restitution[k] - 1.0));
    }
    dem_free(d);
    return o;
}

static void elastic(const struct impact *i)
{
    const double step = contact_time(i)/400.0;
    const struct outcome o = run(i, step, "");

    /* the peak lies between two steps: (pi/800)^2/2 of the overlap at most; the rest is the
       published rounding */
    TAP_NEAR(o.force, i->force, 2e-3*i->force, "%s: peak force", i->name);
    TAP_NEAR(o.overlap, i->overlap, 2e-3*i->overlap, "%s: peak overlap", i->name);
    /* counted in whole steps, 1/400 each */
    TAP_NEAR(o.time, i->time, 1e-2*i->time, "%s: contact time", i->name);
    /* Verlet of order 2: (1/400)^2 times a constant of order 10 */
    TAP_NEAR(o.mean, 1.0, 1e-4, "%s: no speed is lost", i->name);
}

/* Error of the speed after an elastic impact, worst of the phases. */
static void order(const struct impact *i)
{
    const double coarse = contact_time(i)/40.0;
    double before = 0.0;

    for (int k = 0; k < 4; k++)
    {
        const struct outcome o = run(i, coarse/(1 << k), "");

        if (k > 0)
        {
            /* order 2 or better: a half step leaves a quarter of the error */
            TAP_OK(before >= 4.0*o.worst,
                   "%s: halving the step to t_c/%d divides the error by %.2f, at least 4", i->name,
                   40 << k, before/o.worst);
        }
        before = o.worst;
    }
}

static void damped(const struct impact *i, double e)
{
    char words[64];

    snprintf(words, sizeof words, "dry { restitution %g; }", e);
    const struct outcome o = run(i, contact_time(i)/400.0, words);

    /* the dashpot sees the speed of half a step before: order 1, 5e-4 at e = 0.2 and less above */
    TAP_NEAR(o.mean, e, 6e-4, "%s: restitution %g comes out as %.5f", i->name, e, o.mean);
}

/* e = 0 is critical damping of the last moments: a Hertzian contact creeps apart, ever slower, and
   never bounces */
static void plastic(const struct impact *i)
{
    const double step = contact_time(i)/400.0;
    struct dem *const d = start(i, step, "dry { restitution 0; }");
    double fastest = 0.0;

    world_run(d, 10.0*contact_time(i));
    for (int k = 0; k < PHASES; k++)
    {
        fastest = fmax(fastest, fabs(world_at(d, k).v[2])/i->speed);
    }
    /* 1 % required */
    TAP_NEAR(fastest, 0.0, 1e-2,
             "%s: restitution 0 leaves %.2g of the speed after ten contact times", i->name,
             fastest);
    dem_free(d);
}

/* d = 0.16 mm on a spring of 1000 N/m: the speed of separation is d sqrt(k/m*). The step of 1/200 of
   the contact time makes an error of 1e-4 of it. */
static void overlap_at_start(void)
{
    static const char scene[] =
        "materials { clay { density 2500; youngsModulus 1e7; } } effects { hooke { stiffness 1000; } }"
        "insert { two { type list; diameter 2e-3; positions ((0 0 0) (0 0 1.84e-3)); } }"
        "time { %s step %.17g; }";
    const double m = 0.5*world_sphere_mass(1e-3, 2500.0), d = 0.16e-3, time = world_pi*sqrt(m/1000.0);
    char *const tight = world_text(scene, "", time/200.0),
         *const loose = world_text(scene, "maxStartOverlap 0.1;", time/200.0);
    world_refused(tight,
                  "maxStartOverlap");
    struct dem *const w = world(loose, 0, NULL);

    world_run(w, time);
    const double speed = world_at(w, 1).v[2] - world_at(w, 0).v[2];

    TAP_NEAR(speed, d*sqrt(1000.0/m), 1e-3*speed, "maxStartOverlap 0.1: they part at d sqrt(k/m*)");
    dem_free(w);
}

int main(void)
{
    static const struct impact cases[] =
    {
        {"glass pair", 0.01, 48e9, 0.20, 2800.0, 10.0, 0, 0, 0, 0},
        {"limestone pair", 0.01, 20e9, 0.25, 2500.0, 10.0, 0, 0, 0, 0},
        {"aluminium on a rigid wall", 0.1, 70e9, 0.30, 2699.0, 0.2, 1, 0, 0, 0},
        {"magnesium on a rigid wall", 0.1, 40e9, 0.35, 1800.0, 0.2, 1, 0, 0, 0},
    };
    static const struct impact oxide =
        {"aluminium oxide", 0.0025, 380e9, 0.23, 4000.0, 3.9, 1, 0, 0, 0};
    double table[4*5];

    if (!TAP_OK(world_table("physics/hertz_normal.csv", 5, 4, table) == 4,
                "four rows in hertz_normal.csv"))
    {
        TAP_DONE;
    }
    TAP_TRAPS;
    overlap_at_start();
    for (int k = 0; k < 4; k++)
    {
        struct impact i = cases[k];

        i.overlap = 1e-6*table[5*k + 2];
        i.force = 1e3*table[5*k + 3];
        i.time = 1e-6*table[5*k + 4];
        elastic(&i);
    }
    order(&cases[0]);
    order(&cases[2]);
    plastic(&oxide);
    for (int k = 1; k <= 5; k++)
    {
        damped(&oxide, 0.2*k);
        damped(&cases[0], 0.2*k);
    }
    TAP_DONE;
}
