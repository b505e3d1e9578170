/*
 * test_clump_heat.c -- temperature of rigid bodies of several spheres: a stream cools them, contacts conduct, what
 * the fluid gets is what they lose, friction heats them.
 *
 * Two touching spheres of radius R have V = 8/3 pi R^3 and the surface 8 pi R^2; the sphere of this volume has
 * d = 2 cbrt(2) R. In a stream B = Nu k_f/d times the surface, C = M c, and T - T_f decays as exp(-B t/C).
 * Two bodies with n contacts of the conductance H each: the difference decays as (1 - n H h (1/C_1 + 1/C_2)) a step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"

#include "case/simulation.h"
#include "particles/clump.h"
#include <float.h>
#include <math.h>

static const double R = 1e-3, rho = 1.2, mu = 1.8e-5, k_f = 0.026, c_f = 1007.0, c = 840.0;

static const char *const shapes =
    "shapes { pair { spheres ((-1e-3 0 0 1e-3) (1e-3 0 0 1e-3)); } one { spheres ((0 0 0 1e-3)); }"
    " bent { spheres ((0 0 0 1e-3) (1.2e-3 0 0 0.8e-3) (1.2e-3 1e-3 0 0.6e-3)); } }";

/* ---- a stream -------------------------------------------------------------------------------- */

static struct dem *in_stream(const char *shape, double step, double heat_capacity)
{
    return world(world_text(
        "materials { glass { density 2500; youngsModulus 1e5; heatCapacity %.17g; } } %s"
        "effects { hertz { } ranzMarshall { } }"
        "fluid { density %g; viscosity %g; velocity (0 2 0); voidFraction 0.7; temperature 300; conductivity %g;"
        " heatCapacity %g; } time { step %g; }"
        "insert { one { type list; %s positions ((0 0 0)); temperature 400; } }",
        heat_capacity, shapes, rho, mu, k_f, c_f, step, shape), 0, NULL);
}

static void stream(void)
{
    const double d = 2.0*cbrt(2.0)*R, B = k_f/d*8.0*world_pi*R*R*(2.0 + 0.6*sqrt(rho*2.0*d/mu)*cbrt(mu*c_f/k_f)),
                 m = 2500.0*8.0/3.0*world_pi*R*R*R, step = 1e-5;

    for (double ratio = 0.01; ratio < 20.0; ratio *= 10.0)
    {
        const int steps = ratio < 1.0 ? 100 : 2;
        struct dem *const s = in_stream("shape pair;", step, B*step/ratio/m);

        world_run(s, steps*step);
        /* the surface of the union is known to 1e-4 */
        TAP_NEAR(log((world_scalar(s, "temperature", 0) - 300.0)/100.0)/(-ratio*steps), 1.0, 1e-4,
                 "a stream cools a pair: %d steps of %g tau", steps, ratio);
        TAP_OK(world_scalar(s, "temperature", 0) == world_scalar(s, "temperature", 1), "its spheres have one temperature");
        dem_free(s);
    }
    struct dem *const b = in_stream("shape one;", step, c), *const s = in_stream("diameter 2e-3;", step, c);

    world_run(b, 1e-2);
    world_run(s, 1e-2);
    TAP_NEAR(world_scalar(b, "temperature", 0), world_scalar(s, "temperature", 0), 1e-10,
             "a body of one sphere cools as the sphere");
    dem_free(b);
    dem_free(s);
}

/* ---- what the fluid gets --------------------------------------------------------------------- */

static double *scalar(struct dem *d, const char *name)
{
    return dem_scalar(d, dem_scalar_index(d, name));
}

/* A window of 4 steps, in a fluid that is warmer by `rise` from sphere to sphere; returns what it got. */
static double window(struct dem *d, double rise, double step)
{
    struct dem_scalar_exchange x;
    struct dem_fluid f;
    double received = 0.0;

    WORLD_TRY(dem_fluid(d, &f));
    for (size_t i = 0; i < f.n; i++)
    {
        f.velocity[3*i] = 1.0 + (double)i;
        f.void_fraction[i] = 0.6;
        f.density[i] = rho;
        f.viscosity[i] = mu;
        scalar(d, "fluidTemperature")[i] = 300.0 + rise*(double)i;
        scalar(d, "fluidConductivity")[i] = k_f;
        scalar(d, "fluidHeatCapacity")[i] = c_f;
    }
    world_run(d, 4.0*step);
    WORLD_TRY(dem_scalar_exchange(d, dem_scalar_index(d, "temperature"), &x));
    for (size_t i = 0; i < x.n; i++)
    {
        received -= x.received[i];
    }
    return received;
}

/* A bent body; a window is of the order of `ratio` tau. In a fluid of one temperature the response R = dJ/dT_f is
   C (1 - exp(-B t/C)), what the body loses over its difference. */
static void exchange(double ratio)
{
    const double step = 1e-5, m = 2500.0*6e-9, heat_capacity = 1e-3*4.0*step/ratio/m;
    struct dem *const d = world(world_text(
        "materials { glass { density 2500; youngsModulus 1e5; heatCapacity %.17g; } } %s"
        "effects { hertz { } gunn { } } time { step %g; }"
        "insert { one { type list; shape bent; positions ((0 0 0)); temperature 400; } }",
        heat_capacity, shapes, step), 0, NULL);
    const double got = window(d, 0.0, step), C = dem_clump_at(&d->state.particles, 0)->mass*heat_capacity,
                 T = scalar(d, "temperature")[0], lost = C*(400.0 - T);
    const double target[3] = {330.0, 340.0, 350.0};
    struct dem_scalar_exchange x;
    double response = 0.0, carried = 0.0;

    TAP_NEAR(got/lost, 1.0, 1e-12, "a window of %.3g tau: the fluid gets what the body loses",
             -log(1.0 - lost/C/100.0));
    WORLD_TRY(dem_scalar_correct(d, dem_scalar_index(d, "temperature"), target));
    WORLD_TRY(dem_scalar_exchange(d, dem_scalar_index(d, "temperature"), &x));
    for (size_t i = 0; i < x.n; i++)
    {
        response += x.response[i];
        carried += x.carried_over[i];
    }
    TAP_NEAR(response/(lost/100.0), 1.0, 1e-12, "the responses of its spheres are the body's, %.3g of C", response/C);
    TAP_OK(carried > 30.0*response && carried < 50.0*response, "they give it heat of the next window");
    const double next = window(d, 20.0, step);

    TAP_NEAR((C*(scalar(d, "temperature")[0] - T) + next)/carried, 1.0, 1e-10, "which arrives");
    dem_free(d);
}

/* ---- conduction ------------------------------------------------------------------------------ */

/* Bodies without force to speak of; `contacts` of the same overlap between them. */
static void conduction(const char *second, int contacts, double C2)
{
    const double overlap = 1e-5, k = 2.0, H = 2.0*k*sqrt(0.5*R*overlap), M = 2500.0*8.0/3.0*world_pi*R*R*R;
    struct dem *const d = world(world_text(
        "materials { glass { density 2500; youngsModulus 1e-6; poissonsRatio 0.3; conductivity %g; heatCapacity %g; } }"
        "%s effects { hertz { } conduction { } } time { step 0.01; force yes; }"
        "insert { a { type list; shape pair; orientation (1 0 0 0); positions ((0 0 0)); temperature 400; }"
        " b { type list; %s temperature 300; } }", k, c, shapes, second), 0, NULL);
    const double C[2] = {M*c, C2*M*c}, rate = contacts*H*(1.0/C[0] + 1.0/C[1]);

    world_run(d, 1.0);
    const double T[2] = {world_scalar(d, "temperature", 0), world_scalar(d, "temperature", 2)};

    TAP_NEAR((T[0] - T[1])/(100.0*pow(1.0 - 0.01*rate, 100.0)), 1.0, 1e-6,
             "%d contact(s): the difference falls to %.3g", contacts, (T[0] - T[1])/100.0);
    TAP_NEAR((C[0]*(T[0] - 400.0) + C[1]*(T[1] - 300.0))/(C[0]*(400.0 - T[0])), 0.0, 1e-9, "heat is kept");
    dem_free(d);
}

/* ---- friction -------------------------------------------------------------------------------- */

/* A heap falls, slides and is heated by friction, impacts and its floor; all heat is accounted for. */
static void friction(void)
{
    struct dem *const d = energy_world(world_text(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; conductivity 1; heatCapacity 0.5; } }"
        "%s effects { hertz { } dry { restitution 0.5; } mindlin { friction 0.3; } conduction { } frictionHeat { }"
        " gravity { acceleration (0 0 -9.81); } }"
        "walls { cup { type box; min (0 0 0); max (0.012 0.012 0.03); temperature { value 310; } } }"
        "insert { a { type random; shape bent; count 12; min (0 0 0); max (0.012 0.012 0.02); seed 3;"
        " temperature { min 300; max 320; } }"
        " b { type lattice; diameter 1e-3; count 10; min (0 0 0.021); max (0.012 0.012 0.03); temperature 290; } }",
        shapes), 0, NULL);
    const struct dem_particles *const p = &d->state.particles;
    const double *const T = dem_scalar(d, dem_scalar_index(d, "temperature"));
    int uneven = 0, spread = 0;

    world_run(d, 0.15);
    for (size_t i = 0; i < p->n; i++)
    {
        for (size_t j = 0; j < p->n; j++)
        {
            uneven += p->record[i].body && p->record[i].body == p->record[j].body && T[i] != T[j];
            spread += p->record[i].body && p->record[j].body && T[i] != T[j];
        }
    }
    const double gain = energy_term(d, "heat_content"), heated = energy_term(d, "heat_dissipated");

    TAP_OK(uneven == 0 && spread > 0, "temperatures differ between bodies only");
    TAP_OK(heated > 0.0 && fabs(energy_term(d, "heat_walls")) > 0.1*heated, "contacts and walls heat them");
    /* half a unit in the last place of 330 K a step and body */
    TAP_NEAR(gain - heated - energy_term(d, "heat_walls"), 0.0,
             22.0*(double)d->state.steps*2.5e-5*0.5*330.0*0.5*DBL_EPSILON, "the heat is accounted for");
    dem_free(d);
}

/* ---- refusals -------------------------------------------------------------------------------- */

static void refused(const char *effect)
{
    world_refused(world_text("materials { glass { density 2500; youngsModulus 1e7; conductivity 1; heatCapacity 1; emissivity 1; } }"
                             "effects { hertz { } %s { } } %s insert { a { type list; shape pair; positions ((0 0 0)); } }",
                             effect, shapes), "over gaps");
}

int main(void)
{
    TAP_TRAPS;
    stream();
    exchange(0.1);
    exchange(3.0);
    conduction("shape pair; orientation (1 0 0 0); positions ((3.99e-3 0 0));", 1, 1.0);
    conduction("shape pair; orientation (1 0 0 0); positions ((0 1.99e-3 0));", 2, 1.0);
    conduction("diameter 2e-3; positions ((2.99e-3 0 0));", 1, 0.5);
    friction();
    refused("gasFilm");
    refused("radiation");
    TAP_DONE;
}
