/*
 * test_energy_laws.c -- the energy balance closes for every contact law among many colliding
 * spheres.
 *
 * The laws report the kinetic energy lost as stored and dissipated. The residual is small and
 * decreases when the step is halved: by 2 for dashpots and force jumps, by 4 for elastic laws.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"

#include "core/random.h"

enum
{
    SIDE = 5, N = SIDE*SIDE*SIDE
};

static void random_lattice(struct dem_new_particle *seed, double pitch, double speed)
{
    for (int k = 0; k < N; k++)
    {
        const int at[3] = {k%SIDE, k/SIDE%SIDE, k/(SIDE*SIDE)};

        seed[k] = (struct dem_new_particle){
            .diameter = 2e-3* (1.0 - 0.2*dem_random_unit(3, (uint64_t)k, 2, 0)), .id = k,
            .material = "glass"};
        for (int a = 0; a < 3; a++)
        {
            seed[k].position[a] = pitch*(at[a] + 0.5);
            seed[k].velocity[a] = speed*(2.0*dem_random_unit(7, (uint64_t)k, 0, (uint64_t)a) - 1.0);
            seed[k].spin[a] =
                speed/1e-3*(2.0*dem_random_unit(7, (uint64_t)k, 1, (uint64_t)a) - 1.0);
        }
    }
}

struct law_case
{
    const char *effects;
    double speed;                                         /* m/s */
    const char *term;                                    /* a term that must not be zero */
    /* limit of residual over kinetic energy at 4 us; least factor between 4 us and 1 us */
    double max_residual, min_factor;
};

/*
 * 4 us is 1/25 of an impact at 1 m/s. Elastic laws: second order, 16 times less expected. Dashpots,
 * friction that begins to slip and jumps of a force: first order, 4 times less expected; force
 * jumps in a few contacts scatter, so a little more than 2 is required. A bond that breaks loses
 * the energy stored by the motion: second order. One damped by 0.1 of critical oscillates for 30
 * steps.
 */
static const struct law_case cases[] = {
    {"hertz {}", 0.5, "elastic_hertz", 2e-4, 6.0},
    {"hooke { stiffness 2000; }", 0.5, "elastic_hooke", 5e-4, 6.0},
    {"hooke {}", 0.5, "elastic_hooke", 5e-4, 6.0},
    {"hookeHysteresis { stiffness 1000; unloading 4; }", 0.5, "lost_hookeHysteresis", 2e-4, 6.0},
    {"hookeHysteresis { stiffness 1000; unloading 4; adhesion 0.5; }", 0.5, "lost_hookeHysteresis",
     5e-4, 6.0},
    {"hookeHysteresis { stiffness 200; unloading 4; adhesion 0.5; plasticDepth 0.005; }", 0.5,
     "lost_hookeHysteresis", 2e-3, 6.0},
    {"hertz {} sjkr { energyDensity 1e5; }", 0.5, "elastic_sjkr", 2e-4, 6.0},
    {"hertz {} jkr { workOfAdhesion 0.1; }", 0.5, "lost_jkr", 5e-4, 2.2},
    {"hertz {} dry { restitution 0.8; }", 0.5, "lost_dry", 2e-3, 2.5},
    {"hertz {} dry { restitution 0.2; }", 0.5, "lost_dry", 2e-3, 2.5},
    {"hertz {} dry { restitution 0.5; attraction clamped; }", 0.5, "lost_dry", 2e-3, 2.5},
    {"hooke { stiffness 2000; } viscous { coefficient 0.02; }", 0.5, "lost_viscous", 2e-3, 2.5},
    {"hertz {} stokesDamping { restitution 0.97; viscosity 1e-3; }", 0.5, "lost_stokesDamping", 2e-3, 2.5},
    {"hertz {} lubrication { viscosity 1e-3; roughness 1e-6; cutOff 1e-5; }", 0.5,
     "lost_lubrication", 2e-3, 2.5},
    {"hertz {} mindlin { friction 0.3; }", 0.5, "lost_mindlin", 5e-4, 2.5},
    {"hertz {} dry { restitution 0.8; } mindlin { friction 0.3; }", 0.5, "lost_mindlin", 2e-3, 2.5},
    {"hertz {} mindlinIncremental { friction 0.3; }", 0.5, "lost_mindlinIncremental", 5e-4, 2.5},
    {"hooke { stiffness 2000; } linear { friction 0.3; }", 0.5, "lost_linear", 2e-3, 2.5},
    {"hertz {} linear { friction 0.3; stiffness 500; }", 0.5, "lost_linear", 2e-3, 2.5},
    {"hertz {} dry { restitution 0.8; } linear { friction 0.3; ratio 0; }", 0.5, "lost_linear",
     2e-3, 2.5},
    {"hertz {} rollingConstant { friction 0.2; }", 0.5, "lost_rollingConstant", 2e-3, 2.5},
    {"hertz {} rollingViscous { time 1e-3; }", 0.5, "lost_rollingViscous", 2e-3, 2.5},
    {"hertz {} rollingSpring { friction 0.2; damping 0.3; }", 0.5, "lost_rollingSpring", 5e-4, 2.5},
    {"hertz {} twistingSpring { friction 0.3; damping 0.3; }", 0.5, "lost_twistingSpring", 5e-4,
     2.5},
    {"hertz {} twistingSpring { friction 0.3; lever reduced; }", 0.5, "lost_twistingSpring", 5e-4,
     2.5},
    {"hertz {} bondLinear { normalStiffness 3e8; shearStiffness 1e8; makeDistance 1.2; "
     "breakDistance 1.5; }",
     0.1, "elastic_bondLinear", 2e-3, 6.0},
    {"hertz {} bondLinear { normalStiffness 3e8; shearStiffness 1e8; makeDistance 1.2; "
     "breakDistance 1.5; dampingRatio 0.1; }",
     0.1, "lost_bondLinear", 2e-2, 2.5},
    {"hertz {} bondLinear { normalStiffness 3e8; shearStiffness 1e8; makeDistance 1.2; "
     "breakDistance 1.5; normalStrength 1e4; }",
     0.2, "broken", 2e-3, 6.0},
};

/* Over the kinetic energy at the start: the largest residual of 20 samples, and the term of the
   case. */
static double run(const struct law_case *w, double step, double *term_value)
{
    static struct dem_new_particle seed[N];
    char *const scene = world_text(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } "
        "effects { %s } "
        "domain { min (0 0 0); max (0.0105 0.0105 0.0105); periodic (x y z); } "
        "time { step %.17g; }",
        w->effects, step);
    double worst = 0.0;

    random_lattice(seed, 0.0021, w->speed);
    struct dem *const d = energy_world(scene, N, seed);
    const double kinetic =
        energy_term(d, "kinetic_translation") + energy_term(d, "kinetic_rotation");

    for (int k = 0; k < 20; k++)
    {
        world_run(d, 2.5e-4);
        worst = fmax(worst, fabs(energy_term(d, "residual")));
    }
    *term_value = energy_term(d, w->term)/kinetic;
    dem_free(d);
    return worst/kinetic;
}

int main(void)
{
    TAP_TRAPS;
    for (size_t k = 0; k < sizeof cases/sizeof cases[0]; k++)
    {
        const struct law_case *const w = &cases[k];
        double term_value;
        const double coarse = run(w, 4e-6, &term_value), fine = run(w, 1e-6, &term_value);

        TAP_OK(coarse < w->max_residual && coarse > w->min_factor*fine,
               "%s: residual %.2g, %.2g at a quarter of the step", w->effects, coarse, fine);
        TAP_OK(strstr(w->term, "sjkr") ? term_value < 0.0 : term_value > 1e-4, "%s: %s is %.3g",
               w->effects, w->term, term_value);
    }
    TAP_DONE;
}
