/*
 * test_forces.c -- spheres rise, spin, bend and collide in a fluid as the laws of added mass, lift and
 * torque say, and the fluid gets the momentum that they lose.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

/* (rho_f - rho_p) V g = (rho_p + rho_f/2) V dv/dt; drag takes 1e-3 of it after 1e-5 s at most.
   Terminal speeds with added mass: stability/31. */
static void rises(void)
{
    struct dem *const d = world(
        "materials { bead { density 0.001; youngsModulus 1e5; } }"
        "effects { schillerNaumann {} pressureGradient {} gravity { acceleration (0 0 -9.81); } "
        "virtualMass {} } fluid { density 1000; viscosity 1e-3; } time { step 1e-7; }"
        "insert { one { type list; diameter 2e-3; positions ((0 0 0)); } }", 0, NULL);

    world_run(d, 1e-5);
    TAP_NEAR(world_at(d, 0).v[2]/(2.0*9.81*1e-5), 1.0, 2e-3,
             "a massless bubble starts to rise with 2 g");
    dem_free(d);
}

/* Two spheres collide in a fluid without drag: e, and m v + a v, which is conserved. */
static void impacts(void)
{
    static const struct
    {
        double rho[2], e;
    } cases[] = {{{2500.0, 2500.0}, 0.9}, {{2500.0, 2500.0}, 0.5}, {{1.2, 2500.0}, 0.9}};

    for (int k = 0; k < 3; k++)
    {
        double sum = 0.0, kept = 0.0;

        for (int phase = 0; phase < 16; phase++)
        {
            const double apart = 1e-6*phase/16.0;
            struct dem *const d = world(world_text(
                "materials { a { density %g; youngsModulus 1e7; } b { density %g; "
                "youngsModulus 1e7; } }"
                "effects { hooke { stiffness 1000; } dry { restitution %g; } virtualMass {} }"
                "fluid { density 1000; viscosity 1e-3; } time { step 1e-7; }"
                "insert { one { type list; material a; diameter 2e-3; positions ((0 0 0)); "
                "velocity (0.2 0 0); }"
                "two { type list; material b; diameter 2e-3; positions ((%.12g 0 0)); "
                "velocity (-0.1 0 0); } }",
                cases[k].rho[0], cases[k].rho[1], cases[k].e, 2.00001e-3 + apart), 0, NULL);
            const double V = 4.0/3.0*world_pi*1e-9, m0 = (cases[k].rho[0] + 500.0)*V,
                         m1 = (cases[k].rho[1] + 500.0)*V;

            world_run(d, 5e-4);
            sum += (world_at(d, 1).v[0] - world_at(d, 0).v[0])/0.3;
            kept += m0*world_at(d, 0).v[0] + m1*world_at(d, 1).v[0] - (m0*0.2 - m1*0.1);
            dem_free(d);
        }
        /* t_c is 9e-5 s and more: hooke at t_c/900 and first order with damping */
        TAP_NEAR(sum/16.0, cases[k].e, 1e-3, "%g on %g kg/m3: returns %.4f", cases[k].rho[0],
                 cases[k].rho[1], sum/16.0);
        /* rounding of 5000 steps; the sum is 5e-6 kg m/s */
        TAP_NEAR(kept, 0.0, 1e-17, "momentum including the added mass is conserved");
    }
}

static void added_mass_counts_once(void)
{
    static const char scene[] =
        "materials { a { density 2500; youngsModulus 1e7; } }"
        "effects { hertz {} stokesDamping { restitution 0.9; addedMass 0.5; fluidDensity 1000; } "
        "virtualMass {} }"
        "fluid { density 1000; viscosity 1e-3; }"
        "insert { one { type list; diameter 2e-3; positions ((0 0 0)); } }";
    world_refused(scene,
                  "addedMass");
}

/* Without drag: (m + a) dv/dt = a A - V grad p. */
static void accelerating_fluid(void)
{
    static const char scene[] =
        "materials { a { density 500; youngsModulus 1e7; } }"
        "effects { virtualMass { coefficient 0.6; } pressureGradient {} viscousStress {} }"
        "fluid { density 1000; viscosity 1e-3; acceleration (3 0 -1); "
        "pressureGradient (-2000 0 500); viscousStress (100 0 50); }"
        "time { step 1e-3; } insert { one { type list; diameter 2e-3; positions ((0 0 0)); } }";
    struct dem *const d = world(scene, 0, NULL);

    world_run(d, 0.1);
    /* rounding */
    TAP_NEAR(world_at(d, 0).v[0], 0.1*(600.0*3.0 + 2000.0 + 100.0)/(500.0 + 600.0), 1e-13,
             "accelerated by Du/Dt, grad p and div tau");
    TAP_NEAR(world_at(d, 0).v[2], 0.1*(-600.0 - 500.0 + 50.0)/(500.0 + 600.0), 1e-13,
             "accelerated along each axis");
    dem_free(d);
}

static void spins(double step)
{
    struct dem *const d = world(world_text(
        "materials { a { density 2000; youngsModulus 1e7; } } "
        "effects { viscousTorque { correction no; } }"
        "fluid { density 1000; viscosity 1e-3; vorticity (4 0 -2); } time { step %g; }"
        "insert { one { type list; diameter 1e-3; positions ((0 0 0)); spin (10 5 0); } }",
        step), 0, NULL);
    const double tau = 2000.0*1e-6/(60.0*1e-3);           /* I/(pi mu d^3), I = pi rho d^5/60 */
    const double left = exp(-1.0);

    world_run(d, tau);
    const struct world_particle p = world_at(d, 0);

    /* exact in each step: rounding */
    TAP_NEAR(p.w[0], 2.0 + 8.0*left, 1e-12,
             "spin after tau, steps of %g s: towards half the vorticity", step);
    TAP_NEAR(p.w[1], 5.0*left, 1e-12, "spin after tau: decay about y");
    TAP_NEAR(p.w[2], -1.0 + left, 1e-12, "spin after tau: rise about z");
    dem_free(d);
}

/* A spinning sphere in a fluid at rest, without drag: the lift is normal to the slip, so the path
   is a circle. */
static void bends(void)
{
    static const char scene[] =
        "materials { a { density 2000; youngsModulus 1e7; } } effects { magnus {} }"
        "fluid { density 1000; viscosity 1; } time { step 1e-5; }"
        "insert { one { type list; diameter 1e-3; positions ((0 0 0)); velocity (1e-3 0 0); "
        "spin (0 0 50); } }";
    struct dem *const d = world(scene, 0, NULL);

    world_run(d, 0.1);
    const struct world_particle p = world_at(d, 0);
    /* F = pi/8 rho d^3 C W x v, m = pi/6 rho_p d^3: turns by 3/4 rho/rho_p C W t. Re_p = 1e-3, S =
       50: C = 1 - 0.975 tanh(0.18 sqrt Re_p) */
    const double C = 1.0 - 0.975*tanh(0.18*sqrt(1e-3)), angle = 0.75*0.5*C*50.0*0.1;

    /* the force of a kick's start: the speed grows by (angle per step)^2/2 a step, 2e-4 in all */
    TAP_NEAR(sqrt(p.v[0]*p.v[0] + p.v[1]*p.v[1])/1e-3, 1.0, 5e-4, "lift does no work");
    TAP_NEAR(atan2(p.v[1], p.v[0]), angle, 1e-4,
             "it bends the path to the side to which the front of the sphere rotates: %.4f", angle);
    dem_free(d);
}

/* Fluid of the k-th coupled window, different in each. Returns what is reported to the fluid, with
   its new velocity. */
static void give(struct dem *d, int k, struct dem_fluid *f)
{
    WORLD_TRY(dem_fluid(d, f));
    for (size_t i = 0; i < 3*f->n; i++)
    {
        f->velocity[i] = 0.3*sin(1.0 + (double)i + 0.7*k);
        f->pressure_gradient[i] = 0.0;
        f->acceleration[i] = 9.0*cos(2.0*(double)i + k);
        f->vorticity[i] = 50.0*sin(3.0*(double)i - k);
        f->stress[i] = 200.0*cos((double)i + 3.0*k);
    }
    for (size_t i = 0; i < f->n; i++)
    {
        f->void_fraction[i] = 0.9 - 0.08*k;
        f->density[i] = 1000.0 + 20.0*k;
        f->viscosity[i] = 1e-3;
        f->slip_factor[i] = 1.0/(f->void_fraction[i]*f->void_fraction[i]);
    }
}

/* Windows with changing added mass: the fluid gets the momentum (J and R (u' - u)) that particles
   and carried-over impulse lose. */
static void exchanges(double density)
{
    struct dem_case *const c = world_begin(world_text(
        "materials { a { density %g; youngsModulus 1e7; } }"
        "effects { schillerNaumann {} viscousStress {} virtualMass { swarm zuber; } "
        "saffmanMei {} magnus {} }"
        "time { step 1e-4; } insert { two { type list; diameter 2e-3; "
        "positions ((0 0 0) (1 0 0)); spin (0 30 9); } }",
        density));
    double got[3] = {0.0, 0.0, 0.0}, owed[3] = {0.0, 0.0, 0.0}, size = 0.0, worst = 0.0;

    struct dem *const d = world_start(c);
    for (int k = 0; k < 7; k++)
    {
        struct dem_fluid f;
        double velocity[6], gradient[6] = {0.0};

        give(d, k, &f);
        world_run(d, 1e-3*(1 + k%3));
        WORLD_TRY(dem_fluid(d, &f));
        for (size_t i = 0; i < 6; i++)
        {
            velocity[i] = f.velocity[i] + 0.02*sin(5.0*(double)i + k);
            got[i%3] += f.drag_impulse[i] + f.other_impulse[i] +
                          f.response[i/3]*(velocity[i] - f.velocity[i]);
            size += fabs(f.drag_impulse[i]) + fabs(f.other_impulse[i]);
        }
        WORLD_TRY(dem_fluid_correct(d, velocity, gradient));
        WORLD_TRY(dem_fluid(d, &f));
        owed[0] = f.carried_over_impulse[0] + f.carried_over_impulse[3],
        owed[1] = f.carried_over_impulse[1] + f.carried_over_impulse[4],
        owed[2] = f.carried_over_impulse[2] + f.carried_over_impulse[5];
        for (int i = 0; i < 3; i++)
        {
            const double has = world_at(d, 0).mass*world_at(d, 0).v[i] +
                               world_at(d, 1).mass*world_at(d, 1).v[i];

            worst = fmax(worst, fabs(has + owed[i] - got[i]));
        }
    }
    /* rounding of 140 kicks of 1e-4 of the sum */
    TAP_NEAR(
        worst/size, 0.0, 1e-14,
        "%g kg/m3: the fluid gets the momentum of the particles and the carried-over impulse, "
        "while added mass changes",
        density);
    dem_free(d);
}

/* In a fluid at rest with Stokes' drag slip fades as exp(-t/tau), tau = (rho_p + rho/2) d^2/(18
   mu): of a bubble 400 times as long with added mass as without. The reported relaxation rate is
   that one, whatever the void fraction and the slip factor; a frozen particle has none. */
static void relaxes(double density, const char *added, double extra)
{
    const double window = 1e-6, d = 1e-3, mu = 1e-3, rate = 18.0*mu/((density + extra)*d*d);
    struct dem_case *const c = world_begin(world_text(
        "materials { a { density %g; youngsModulus 1e7; } } "
        "effects { stokesDrag {} %s } time { step 1e-7; }"
        "insert { one { type list; diameter 1e-3; positions ((0 0 0)); velocity (0.3 0 0); }"
        "two { type list; diameter 1e-4; positions ((1 0 0)); frozen yes; } }",
        density, added));
    struct dem_fluid f;

    struct dem *const run = world_start(c);
    TAP_OK(dem_fluid_relaxation(run) == 0.0,
           "%g kg/m3 %s: no rate before the first window", density, added);
    WORLD_TRY(dem_fluid(run, &f));
    for (size_t i = 0; i < 2; i++)
    {
        f.void_fraction[i] = 1.0, f.density[i] = 1000.0, f.viscosity[i] = mu,
        f.slip_factor[i] = 1.0;
        for (size_t k = 3*i; k < 3*i + 3; k++)
        {
            f.velocity[k] = f.pressure_gradient[k] = 0.0;
            if (f.acceleration)
            {
                f.acceleration[k] = 0.0;
            }
        }
    }
    world_run(run, window);
    /* round-off of the sum of ten steps, over the 1e-5 that the slip loses */
    TAP_NEAR(dem_fluid_relaxation(run)/rate, 1.0, 1e-12,
             "%g kg/m3 %s: relaxes at 18 mu/((rho_p + a/V) d^2) = %.6g /s", density, added, rate);
    TAP_NEAR(-log(world_at(run, 0).v[0]/0.3)/(rate*window), 1.0, 1e-9,
             "the slip decays at this rate");
    dem_free(run);
}

int main(void)
{
    TAP_TRAPS;
    relaxes(1.2, "virtualMass {}", 500.0);
    relaxes(1.2, "", 0.0);
    relaxes(2500.0, "virtualMass { coefficient 0.8; }", 800.0);
    exchanges(1.2);
    exchanges(2500.0);
    rises();
    impacts();
    added_mass_counts_once();
    accelerating_fluid();
    spins(1e-5);
    spins(1.0);
    bends();
    TAP_DONE;
}
