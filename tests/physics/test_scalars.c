/*
 * test_scalars.c -- particle scalars: walls and the program change a temperature by closed forms;
 * insertion sets it; scenes without scalars have no column; the fluid's viscosity reaches contact
 * laws.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "world.h"
#include "case/simulation.h"

#include <math.h>

enum
{
    RING = 4
};

static const double R = 3.2e-3, overlap = 6.4e-5, k = 42.0, c = 4.64, rho = 7800.0;

static struct dem *ring(const char *temperature)
{
    const double d = 2.0*R - overlap;
    return world(world_text(
        "materials { steel { density %g; youngsModulus 1e7; conductivity %g; heatCapacity %g; } }"
        "effects { hertz { } conduction { } }"
        "domain { min (0 -1 -1); max (%.17g 1 1); periodic (x); }"
        "time { step 1e-6; maxStartOverlap 0.1; }"
        "insert { ring { type list; diameter %g; %s"
        "positions ((%.17g 0 0) (%.17g 0 0) (%.17g 0 0) (%.17g 0 0)); } }",
        rho, k, c, RING*d, 2.0*R, temperature, 0.5*d, 1.5*d, 2.5*d, 3.5*d), 0, NULL);
}

static double at(struct dem *d, int64_t id)
{
    return world_scalar(d, "temperature", id);
}

static double mass(void)
{
    return rho*4.0/3.0*world_pi*R*R*R;
}

/* a sphere on a wall with this condition, one step */
static double warmed(const char *condition, double dt)
{
    struct dem *const d = world(world_text(
        "materials { steel { density %g; youngsModulus 1e7; conductivity %g; heatCapacity %g; } }"
        "effects { hertz { } conduction { } }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); %s } }"
        "time { step %g; maxStartOverlap 0.1; }"
        "insert { one { type list; diameter %g; positions ((0 0 %.17g)); temperature 300; } }",
        rho, k, c, condition, dt, 2.0*R, R - overlap), 0, NULL);

    world_step(d);
    const double T = at(d, 0);

    dem_free(d);
    return T - 300.0;
}

static void test_walls(void)
{
    const double dt = 1e-7, C = mass()*c, area = world_pi*R*R;

    /* the sphere has not moved yet in the first half of the kick; rounding of T */
    TAP_NEAR(warmed("temperature { value 400; }", dt)*C/dt, 2.0*k*sqrt(R*overlap)*100.0,
             300.0*2e-16*C/dt + 1e-6*2.0*k*sqrt(R*overlap)*100.0, "wall of a given temperature");
    TAP_NEAR(warmed("temperature { flux 1e6; }", dt)*C/dt, 1e6*area, 300.0*2e-16*C/dt,
             "wall with a flux");
    TAP_NEAR(warmed("temperature { value 400; film 1e5; }", dt)*C/dt, 1e5*area*100.0,
             300.0*2e-16*C/dt, "wall with a film");
    TAP_OK(warmed("", dt) == 0.0, "a wall without an entry is insulated");
    TAP_OK(warmed("temperature { value 400; start 1; }", dt) == 0.0, "before its start, too");
}

/* T -> T* + (T - T*) exp(-b t/C) + q/b (1 - exp(-b t/C)) */
static void test_exchange(void)
{
    struct dem *d;
    struct dem_scalar_exchange x;
    const double C = mass()*c, t = 1e-4;
    const double stiff[] = {1e-3, 1.0, 1e3};

    for (int n = 0; n < 3; n++)
    {
        const double b = stiff[n]*C/t, q = 0.5*b*20.0, T0 = 300.0, target = 350.0;

        struct dem_case *made = world_begin("materials { steel { density 7800; youngsModulus 1e7; conductivity 42; "
                        "heatCapacity 4.64; } } effects { hertz { } conduction { } }"
                        "time { step 1e-5; }"
                        "insert { one { type list; diameter 6.4e-3; positions ((0 0 0)); "
                        "temperature 300; } }");
        WORLD_TRY(dem_case_exchange_scalar(made, "temperature"));
        d = world_start(made);
        WORLD_TRY(dem_scalar_exchange(d, 0, &x));
        x.source[0] = q, x.coefficient[0] = b, x.target[0] = target;
        world_run(d, t);
        WORLD_TRY(dem_scalar_exchange(d, 0, &x));

        const double rest = exp(-stiff[n]);
        const double exact = target + (T0 - target)*rest + q/b*(1.0 - rest);

        /* ten steps of rounding */
        TAP_NEAR(at(d, 0), exact, 1e-12*exact, "b t/C = %g: exact", stiff[n]);
        TAP_NEAR(x.received[0] + q*t, C*(at(d, 0) - T0), 1e-10*C*50.0,
                 "received and source make the gain");
        TAP_OK(x.response[0] > 0.0 && x.response[0] <= b*t*(1.0 + 1e-12)
                   && x.response[0] >= C*(1.0 - rest)*(1.0 - 1e-12),
               "response between a free value's and a held one's");
        /* the partner's value rises by 1: the particle gets R in the next advance */
        const double one = target + 1.0, R_ = x.response[0], before = at(d, 0);

        WORLD_TRY(dem_scalar_correct(d, 0, &one));
        WORLD_TRY(dem_scalar_exchange(d, 0, &x));
        x.source[0] = x.coefficient[0] = 0.0;
        world_run(d, t);
        TAP_NEAR(C*(at(d, 0) - before), R_, 1e-9*R_ + 1e-12*C*300.0, "the correction arrives");
        dem_free(d);
    }
}

static void refused(const char *entry, const char *words)
{
    char *const text = world_text(
        "materials { steel { density 7800; youngsModulus 1e7; conductivity 42; heatCapacity 4.64; } }"
        "effects { hertz { } conduction { } } insert { a { type list; diameter 1e-3; "
        "positions ((0 0 0)); %s } }", entry);
    world_refused(text, words);
}

static void test_insertion(void)
{
    struct dem *const d = ring("temperature { min 290; max 310; } ");
    double min = INFINITY, max = 0.0;

    for (int64_t id = 0; id < RING; id++)
    {
        min = fmin(min, at(d, id));
        max = fmax(max, at(d, id));
    }
    TAP_OK(min >= 290.0 && max <= 310.0 && min < max, "a range: from %g to %g K", min, max);
    dem_scalar(d, 0)[0] = 777.0;
    TAP_OK(at(d, 0) == 777.0 || at(d, 1) == 777.0 || at(d, 2) == 777.0 || at(d, 3) == 777.0,
           "the program may write values");
    dem_free(d);
    refused("temperature -1;", "from 2.22507e-308 to 100000");
    refused("temperature { min 300; max 200; }", "min 300 K is above max 200 K");
    refused("temperatures (300 310);", "1 positions, but 2 temperatures");
    refused("temperature warm;", "temperature");
    refused("liquid 1;", "liquid");
}

static void test_nothing(void)
{
    struct dem *const d = world("materials { steel { density 7800; youngsModulus 1e7; } }"
                                "effects { hertz { } } insert { a { type lattice; diameter 1e-3; "
                                "min (0 0 0); max (4e-3 4e-3 4e-3); spacing 1; jitter 0; } }",
                                0, NULL);
    const struct dem_state *const p = &d->state;

    world_step(d);
    TAP_OK(dem_scalar_count(d) == 0 && p->particles.columns == DEM_COLUMNS
               && p->particles.ghost_step.n == 0 && p->particles.ghost_window.n == 0,
           "without an effect that names one there is no column");
    TAP_OK(p->contacts.forces.rates == 0 && !p->contacts.forces.rate, "and no rate of contacts");
    /* record, force, torque */
    TAP_OK(dem_particles_bytes_per_particle(&p->particles) == 128 + 48, "a particle has 176 bytes");
    dem_free(d);
}

/* ---- viscosity ------------------------------------------------------------------------------- */

enum
{
    STEPS = 400
};

/* Two spheres that collide with each other, and the second with a wall. */
static struct dem *impacts(const char *stokes, const char *rest)
{
    const struct dem_new_particle seed[2] = {
        {.position = {-1.01e-3, 0.0, 1e-4}, .velocity = {0.3, 0.0, 0.0}, .diameter = 2e-3,
         .id = 0, .material = "steel"},
        {.position = {1.01e-3, 0.0, 0.0}, .velocity = {0.0, 0.1, 0.0}, .diameter = 2e-3,
         .id = 1, .material = "steel"}};
    struct dem_case *const c = world_begin(world_text(
        "materials { steel { density 7800; youngsModulus 1e8; } }"
        "effects { hertz { } stokesDamping { restitution 0.95; %s } mindlin { friction 0.3; } }"
        "walls { end { type plane; point (2.03e-3 0 0); normal (-1 0 0); } }"
        "domain { min (-1 -1 -1); max (1 1 1); } time { step 1e-6; } %s", stokes, rest));

    dem_case_fluid_density(c, 1000.0);    /* of a coupled fluid; else the scene's counts */
    WORLD_TRY(dem_case_add_particles(c, 2, seed));
    return world_start(c);
}

/* Hash after the impacts; `mu`, if given: what a program writes for the two spheres [Pa s]. */
static uint64_t collide(struct dem *d, const double *mu)
{
    for (int n = 0; n < STEPS; n++)
    {
        struct dem_fluid f;
        struct dem_view v;

        if (mu)
        {
            WORLD_TRY(dem_fluid(d, &f));
            dem_view(d, &v);
            for (size_t i = 0; i < v.n; i++)
            {
                f.viscosity[i] = mu[world_id(&v, i)];
            }
        }
        world_step(d);
    }
    TAP_OK(world_at(d, 0).v[0] < 0.1 && world_at(d, 1).v[0] < 0.0, "both have hit: %g %g m/s",
           world_at(d, 0).v[0], world_at(d, 1).v[0]);
    const uint64_t hash = world_hash(d);

    dem_free(d);
    return hash;
}

static size_t bytes(const struct dem *d)
{
    return dem_particles_bytes_per_particle(&d->state.particles);
}

static void test_viscosity(void)
{
    const double both[2] = {0.25, 0.25}, thick[2] = {0.375, 0.375}, apart[2] = {0.125, 0.375};
    struct dem *const setting = impacts("viscosity 0.25; fluidDensity 1000;", ""),
               *const uniform = impacts("", "fluid { density 1000; viscosity 0.25; }"),
               *const coupled = impacts("", "");

    TAP_OK(dem_scalar_count(setting) == 0 && bytes(setting) == 176,
           "with a viscosity of its own the law needs no column");
    TAP_OK(dem_scalar_count(uniform) == 1 && dem_scalar_index(uniform, "fluidViscosity") == 0 &&
           dem_scalar(uniform, 0)[0] == 0.25, "in a fluid the viscosity is a scalar");
    TAP_OK(bytes(uniform) == 184 && uniform->state.contacts.forces.rates == 0
               && !dem_column(&uniform->state.particles, DEM_COLUMN_FLUID_VELOCITY),
           "and the only column: %zu bytes", bytes(uniform));
    TAP_OK(uniform->state.particles.ghost_window.n == 1, "which ghosts have");
    TAP_OK(dem_fluid_reaction(uniform, 1.0, NULL, NULL) == DEM_ERROR_STATE,
           "such a fluid gets no force: %s", dem_error_text());
    TAP_OK(dem_column(&coupled->state.particles, DEM_COLUMN_FLUID_VELOCITY) != NULL,
           "a coupled program finds all columns");

    const uint64_t as_set = collide(setting, NULL);

    TAP_OK(collide(uniform, NULL) == as_set, "a uniform fluid gives the bits of the setting");
    TAP_OK(collide(coupled, both) == as_set, "and so does a program");
    TAP_OK(collide(impacts("", ""), apart) != as_set, "at the wall the viscosity is the sphere's");
    TAP_OK(collide(impacts("", ""), thick) != as_set, "a viscosity of half as much again counts");
}

/* Between two spheres alone it is the mean of both. */
static void test_mean_viscosity(void)
{
    const double mu[2][2] = {{0.25, 0.25}, {0.125, 0.375}};
    struct world_particle q[2];

    for (int k = 0; k < 2; k++)
    {
        struct dem *const d = impacts("", "");

        for (int n = 0; n < 120; n++)    /* before the wall is touched */
        {
            struct dem_fluid f;
            struct dem_view v;

            WORLD_TRY(dem_fluid(d, &f));
            dem_view(d, &v);
            for (size_t i = 0; i < v.n; i++)
            {
                f.viscosity[i] = mu[k][world_id(&v, i)];
            }
            world_step(d);
        }
        q[k] = world_at(d, 0);
        dem_free(d);
    }
    TAP_OK(q[0].v[0] < 0.25, "the spheres have touched: %g m/s", q[0].v[0]);
    TAP_OK(memcmp(q[0].v, q[1].v, sizeof q[0].v) == 0, "0.125 and 0.375 Pa s act as 0.25");
}

int main(void)
{
    TAP_TRAPS;
    test_walls();
    test_exchange();
    test_insertion();
    test_nothing();
    test_viscosity();
    test_mean_viscosity();
    TAP_DONE;
}
