/*
 * test_limits.c -- the limit of the time step of each effect: at the limit the error has the value
 * in the effect's head comment; at three times the limit it is far larger.
 *
 * Oscillations. The leapfrog of a spring with the frequency w obeys v(t + dt) + v(t - dt) =
 * 2 cos(w' dt) v(t) with sin(w' dt/2) = w dt/2, so that w' is too high by w^2 dt^2/24: 0.10 % where
 * dt is 1/20 of half a period, 0.68 % where it is 1/5 of the limit of stability 2/w. The closed
 * form of w comes from the physics; w' is measured in the core.
 *
 * Dampers. A dashpot c alone makes v decay as exp(-c t/m). In a step of q m/c, 1 - q is left: the
 * rate is too high by -ln(1 - q)/q - 1.
 *
 * Impacts of Hertz's law: 32 spheres that touch at different phases within a step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

enum
{
    MAX_BODIES = 32
};

/* one scene, its motion, and what is known of it */
struct motion
{
    const char *name, *scene, *why;
    int n;
    struct dem_new_particle seed[MAX_BODIES];
    /* the velocity that oscillates: sum of these factors times vx, vy, vz, wx, wy, wz of id 0 */
    double mode[6];
    double frequency;                                     /* 1/s  closed form */
    double error;                                         /* of the frequency at the limit */
    double phase;                                         /* 1    w dt at the limit */
};

/* the scene at `factor` times its limit; 0: asks for the limit only */
static struct dem *start(const struct motion *m, double step)
{
    char *const scene = step > 0.0 ? world_text("%s time { step %.17g; force yes; maxOverlap 1; }",
                                                m->scene, step)
                                   : world_text("%s", m->scene);
    return world(scene, m->n, m->seed);
}

static double limit_of(const struct motion *m)
{
    struct dem *const d = start(m, 0.0);
    const struct dem_step_limit step = dem_step_limit(d);

    TAP_OK(strstr(step.why, m->why) != NULL, "%s: the step is limited by %s", m->name, step.why);
    dem_free(d);
    return step.limit;
}

static double velocity(const struct dem *d, const double mode[6])
{
    const struct world_particle p = world_at(d, 0);
    double sum = 0.0;

    for (int k = 0; k < 3; k++)
    {
        sum += mode[k]*p.v[k] + mode[3 + k]*p.w[k];
    }
    return sum;
}

/* w' by least squares of v(t + dt) + v(t - dt) = 2 cos(w' dt) v(t) over 40 steps */
static double frequency(const struct motion *m, double step)
{
    struct dem *const d = start(m, step);
    double before, now, sum = 0.0, square = 0.0;

    before = velocity(d, m->mode);
    world_step(d);
    now = velocity(d, m->mode);
    for (int k = 0; k < 40; k++)
    {
        world_step(d);
        const double after = velocity(d, m->mode);

        sum += now*(before + after);
        square += now*now;
        before = now;
        now = after;
    }
    dem_free(d);
    return acos(0.5*sum/square)/step;
}

static void oscillates(const struct motion *m)
{
    const double limit = limit_of(m), at = frequency(m, limit)/m->frequency - 1.0,
                 beyond = frequency(m, 3.0*limit)/m->frequency - 1.0;

    /* overlaps of 1e-6 of a radius shorten lever arms; 8 digits of constants */
    TAP_NEAR(limit*m->frequency/m->phase, 1.0, 1e-5, "%s: w dt is %.4f at the limit", m->name,
             limit*m->frequency);
    /* amplitudes of 1e-4 of what would matter; three digits of the error are in the header */
    TAP_NEAR(at, m->error, 0.01*m->error, "%s: at the limit the frequency is %.3g %% too high",
             m->name, 100.0*at);
    TAP_OK(beyond > 8.0*m->error, "%s: at three times the limit it is %.3g %% too high", m->name,
           100.0*beyond);
}

/* errors of the frequency: asin(x)/x - 1 at x = w dt/2 = pi/40, and at 1/5 */
static const double twentieth = 1.030330e-3, fifth = 6.789604e-3;

/* ---- springs of contacts --------------------------------------------------------------------- */

static const double R = 1e-3, density = 2500.0;

/* the floor is of another material, so that contacts between spheres, which do not occur, can be
   made too soft to limit the step */
#define MATERIALS                                                                                  \
    "materials { a { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } "                       \
    "b { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } }"
#define SOFT(settings) " pairs { soft { between (a a); " settings " } } "
#define FLOOR "walls { floor { type plane; material b; point (0 0 0); normal (0 0 1); } }"

static struct dem_new_particle sphere(double height, double vz)
{
    return (struct dem_new_particle){.position = {0.0, 0.0, height}, .velocity = {0.0, 0.0, vz},
                                     .diameter = 2.0*R, .id = 0, .material = "a"};
}

/* a sphere that lies on a floor with the overlap d */
static void springs(void)
{
    const double m = world_sphere_mass(R, density), k = 1000.0;
    struct motion on_hooke = {.name = "hooke", .why = "of the contact time", .n = 1,
                              .mode = {[2] = 1.0}, .frequency = sqrt(k/m), .error = twentieth,
                              .phase = world_pi/20.0};

    on_hooke.scene = world_text("%s effects { hooke { stiffness %g; } gravity { acceleration "
                                "(0 0 -1); } }" SOFT("hooke { stiffness 1; }") "%s", MATERIALS, k,
                                FLOOR);
    on_hooke.seed[0] = sphere(R - m/k, 1e-6);
    oscillates(&on_hooke);

    /* beyond d_lim = 5/4 phi 2 R both ways follow the line of k_m = 5 k */
    const double d_lim = 1.25*1e-3*2.0*R, d = 1.2*d_lim, F = 5.0*k*(d - d_lim) + k*d_lim;
    struct motion yields = {.name = "hookeHysteresis", .why = "of the contact time", .n = 1,
                            .mode = {[2] = 1.0}, .frequency = sqrt(5.0*k/m), .error = twentieth,
                            .phase = world_pi/20.0};

    yields.scene = world_text("%s effects { hookeHysteresis { stiffness %g; unloading 5; adhesion "
                              "0; plasticDepth 1e-3; } gravity { acceleration (0 0 %.17g); } }"
                              SOFT("hookeHysteresis { stiffness 1; }") "%s", MATERIALS, k, -F/m,
                              FLOOR);
    yields.seed[0] = sphere(R - d, 1e-5);
    oscillates(&yields);

    /* slip at the contact of a sphere that sticks: k_t (1/m + R^2/I) = 7/2 k_t/m */
    struct motion sticks = {.name = "linear", .why = "tangential spring (linear)", .n = 1,
                            .mode = {[0] = 1.0, [4] = -R}, .frequency = sqrt(3.5*4000.0/m),
                            .error = twentieth,
                            .phase = world_pi/20.0};

    sticks.scene = world_text("%s effects { hooke { stiffness %g; } linear { friction 10; "
                              "stiffness 4000; } gravity { acceleration (0 0 -0.01); } }"
                              SOFT("hooke { stiffness 1; } linear { stiffness 1; }") "%s",
                              MATERIALS, k, FLOOR);
    sticks.seed[0] = sphere(R - 0.01*m/k, 0.0);
    sticks.seed[0].velocity[0] = 1e-8;
    oscillates(&sticks);

    /* with a ratio the limit equals hooke's: w dt/2 = sqrt(7/2 2) pi/40 */
    const double x = sqrt(7.0)*world_pi/40.0;

    sticks.name = "linear, ratio 2";
    sticks.why = "of the contact time";
    sticks.frequency = sqrt(7.0*k/m);
    sticks.error = asin(x)/x - 1.0;
    sticks.phase = 2.0*x;
    sticks.scene = world_text("%s effects { hooke { stiffness %g; } linear { friction 10; "
                              "ratio 2; } gravity { acceleration (0 0 -0.01); } }"
                              SOFT("hooke { stiffness 1; }") "%s",
                              MATERIALS, k, FLOOR);
    oscillates(&sticks);

    /* a sphere that adheres without load, x^3 = 6 of jkr.c: with F(a) and d(a) of Johnson, Kendall
       and Roberts, dF/dd = 6/5 6^(2/3) E* a_t */
    const double E = 1e7/(1.0 - 0.09)/2.0, w = 2.0,
                 a = pow(world_pi*w*R*R/(8.0*E), 1.0/3.0), x_0 = pow(6.0, 1.0/3.0);
    struct motion adheres = {.name = "jkr", .why = "(jkr)", .n = 1, .mode = {[2] = 1.0},
                             .frequency = sqrt(1.2*x_0*x_0*E*a/m), .error = twentieth,
                             .phase = world_pi/20.0};

    adheres.scene = world_text("%s effects { hertz { stiffness %.17g; impactSpeed 1e-6; } jkr { "
                               "workOfAdhesion %g; } }" SOFT("hertz { stiffness 1; } jkr { "
                               "workOfAdhesion 1e-9; }") "%s", MATERIALS, 4.0/3.0*E, w, FLOOR);
    adheres.seed[0] = sphere(R - a*a/R*x_0*(x_0*x_0*x_0 - 4.0), 1e-6);
    oscillates(&adheres);
}

/* ---- bonds ----------------------------------------------------------------------------------- */

/* A ring of 8 bonded spheres (periodic). In the fastest motion of each kind neighbors move against
   each other, in rocking they spin alike. */
static void chain(const char *name, double kn, double kt, double lambda, int axis, double alternate,
                  double frequency)
{
    struct motion m = {.name = name, .why = "chain of linear bonds", .n = 8,
                       .frequency = frequency, .error = fifth, .phase = 0.4};

    m.scene = world_text("%s effects { bondLinear { normalStiffness %.17g; shearStiffness %.17g; "
                         "radius %g; } } domain { min (0 -0.1 -0.1); max (%.17g 0.1 0.1); periodic "
                         "(x); }", MATERIALS, kn, kt, lambda, 16.0*R);
    m.mode[axis] = 1.0;
    for (int k = 0; k < 8; k++)
    {
        const double sign = k % 2 ? alternate : 1.0;

        m.seed[k] = (struct dem_new_particle){
            .position = {(2.0*k + 1.0)*R, 0.0, 0.0}, .diameter = 2.0*R, .id = k, .material = "a"};
        (axis < 3 ? m.seed[k].velocity : m.seed[k].spin)[axis % 3] = sign*(axis < 3 ? 1e-6 : 1e-3);
    }
    oscillates(&m);
}

static void bonds(void)
{
    const double m = world_sphere_mass(R, density), I_p = 0.4*m*R*R, k = 1e10;

    for (double lambda = 1.0; lambda < 2.5; lambda += 1.0)
    {
        const double r = lambda*R, A = world_pi*r*r, I = world_pi*r*r*r*r/4.0, J = 2.0*I;

        if (lambda == 1.0)
        {
            chain("bondLinear, stretching", k, 0.01*k, lambda, 0, -1.0, sqrt(4.0*k*A/m));
            chain("bondLinear, rocking", 0.1*k, k, lambda, 4, 1.0,
                  sqrt(k*A*4.0*R*R/I_p));
        }
        else
        {
            chain("bondLinear, twist", 0.1*k, k, lambda, 3, -1.0, sqrt(4.0*k*J/I_p));
            chain("bondLinear, bending", k, 0.01*k, lambda, 4, -1.0, sqrt(4.0*k*I/I_p));
        }
    }
}

/* ---- dampers --------------------------------------------------------------------------------- */

/* error of the rate of v = exp(-rate t) over 4 steps, after the first two */
static double decay(const struct motion *m, double step, double rate)
{
    struct dem *const d = start(m, step);

    world_step(d);
    world_step(d);
    const double from = velocity(d, m->mode);

    for (int k = 0; k < 4; k++)
    {
        world_step(d);
    }
    const double to = velocity(d, m->mode);

    dem_free(d);
    return log(from/to)/(4.0*step*rate) - 1.0;
}

static void dampers(void)
{
    const double damper = 0.115718;                       /* -ln(0.8)/0.2 - 1 */
    const double m = world_sphere_mass(R, density), c = 1e-2, mu = 0.02, gap = 2e-6, cut = 1e-4;
    struct motion dashpot = {.name = "viscous", .why = "(viscous)", .n = 1, .mode = {[2] = 1.0}};

    dashpot.scene = world_text("%s effects { hooke { stiffness 1e-9; } viscous { coefficient %g; } "
                               "}" SOFT("viscous { coefficient 1e-9; }") "%s", MATERIALS, c, FLOOR);
    dashpot.seed[0] = sphere(R*0.99, -1e-6);
    const double limit = limit_of(&dashpot), at = decay(&dashpot, limit, c/m),
                 beyond = decay(&dashpot, 3.0*limit, c/m);

    TAP_NEAR(limit*c/m, 0.2, 1e-12, "viscous: the limit is m/(5 c)");
    /* a spring of 1e-9 N/m does 1e-9 of the damping */
    TAP_NEAR(at, damper, 1e-4*damper, "viscous: at the limit the decay is %.3g %% too fast",
             100.0*at);
    TAP_NEAR(beyond, 0.527151, 1e-4, "viscous: at three times the limit it is %.3g %% too fast",
             100.0*beyond);

    /* below the roughness the film keeps its thickness, so it is a dashpot */
    const double film = 6.0*world_pi*mu*R*R*(1.0/gap - 1.0/cut);
    struct motion squeezes = {.name = "lubrication", .why = "(lubrication)", .n = 1,
                              .mode = {[2] = 1.0}};

    squeezes.scene = world_text("%s effects { lubrication { viscosity %g; roughness %g; cutOff %g; "
                                "} }" SOFT("lubrication { viscosity 1e-9; }") "%s", MATERIALS, mu,
                                gap, cut, FLOOR);
    squeezes.seed[0] = sphere(R + 0.5*gap, -1e-6);
    const double limit2 = limit_of(&squeezes), at2 = decay(&squeezes, limit2, film/m),
                 beyond2 = decay(&squeezes, 3.0*limit2, film/m);

    TAP_NEAR(limit2*film/m, 0.2, 1e-12, "lubrication: the limit is m*/(5 c), c that at h_r");
    TAP_NEAR(at2, damper, 1e-4*damper, "lubrication: at the limit the decay is %.3g %% too fast",
             100.0*at2);
    /* at most m/(4 dt): of 0.6 only 0.25 is taken, -ln(0.75)/0.6 - 1 */
    TAP_NEAR(beyond2, -0.520530, 1e-4,
             "lubrication: at three times the limit, where the damper is limited, %.3g %%",
             100.0*beyond2);
}

/* ---- impacts --------------------------------------------------------------------------------- */

/* largest error of the rebound speed of 32 spheres that touch at phases of a step; `inertia` times
   as heavy by added mass */
static double rebound(double speed, double factor, const char *soft, const char *why,
                      double inertia)
{
    struct motion m = {.name = "hertz", .why = why, .n = 32};
    double worst = 0.0;

    m.scene = world_text("%s effects { hertz { impactSpeed %.17g; } } %s %s", MATERIALS, speed,
                         soft, FLOOR);
    for (int k = 0; k < m.n; k++)
    {
        m.seed[k] = sphere(R, -speed);
        m.seed[k].position[0] = 4.0*R*k, m.seed[k].id = k;
    }
    const double step = factor*limit_of(&m);

    for (int k = 0; k < m.n; k++)
    {
        m.seed[k].position[2] = R + speed*step*(1.0 + (k + 0.5)/m.n);
    }
    struct dem *const d = start(&m, step);
    const double E = 1e7/(1.0 - 0.09)/2.0,
                 duration =
                     world_contact_time(inertia*world_sphere_mass(R, density), R, E, speed);
    struct world_particle p[MAX_BODIES];

    if (inertia != 1.0)
    {
        TAP_NEAR(step/(factor*duration/20.0), 1.0, 1e-7,
                 "hertz: the limit is 1/20 of the duration of the impact, with added mass");
    }

    world_run(d, step*ceil(1.2*duration/step + 5.0));
    world_all(d, p);
    for (int k = 0; k < m.n; k++)
    {
        worst = fmax(worst, fabs(p[k].v[2]/speed - 1.0));
    }
    dem_free(d);
    return worst;
}

/* c_R/c_S of a surface wave: y = (c_R/c_S)^2 is the root in 0 .. 1 of Rayleigh's equation
   y^3 - 8 y^2 + (24 - 16 q) y - 16 (1 - q) = 0, q = (1 - 2 nu)/(2 (1 - nu)) */
static double surface_wave(double nu)
{
    const double q = (1.0 - 2.0*nu)/(2.0*(1.0 - nu));
    double low = 0.0, high = 1.0 - 1e-9;

    for (int k = 0; k < 60; k++)
    {
        const double y = 0.5*(low + high);

        (y*y*y - 8.0*y*y + (24.0 - 16.0*q)*y - 16.0*(1.0 - q) < 0.0) ? (low = y) : (high = y);
    }
    return sqrt(low);
}

static void impacts(void)
{
    const char *const soft = SOFT("hertz { stiffness 1; }");
    const double at = rebound(1.0, 1.0, soft, "1/20 of the Hertz contact time", 1.0),
                 beyond = rebound(1.0, 3.0, soft, "1/20 of the Hertz contact time", 1.0);

    TAP_OK(at < 1e-3, "hertz: at the limit an impact keeps its speed within %.2g %%", 100.0*at);
    TAP_OK(beyond > 5e-3, "hertz: at three times the limit within %.2g %%", 100.0*beyond);

    /* bubbles: the mass that bounces is nearly all added, 20 times the sphere's */
    char *const bubbles = world_text(
        "%s effects { virtualMass {} } fluid { density %.17g; viscosity 1e-30; }", soft,
        40.0*density);
    const double of_bubbles = rebound(1.0, 1.0, bubbles, "1/20 of the Hertz contact time", 21.0),
                 beyond_of_bubbles =
                     rebound(1.0, 3.0, bubbles, "1/20 of the Hertz contact time", 21.0);

    TAP_OK(of_bubbles < 1e-3, "hertz, added mass: at the limit within %.2g %%", 100.0*of_bubbles);
    TAP_OK(beyond_of_bubbles > 5e-3, "hertz, added mass: at three times the limit within %.2g %%",
           100.0*beyond_of_bubbles);

    /* with friction they turn, without added inertia: the sphere's own mass sets the step */
    struct motion dry = {.name = "hertz, mindlin", .why = "1/20 of the Hertz contact time", .n = 1},
                  wet = {.name = "hertz, mindlin, added mass", .why = dry.why, .n = 1};

    dry.seed[0] = wet.seed[0] = sphere(R, -1.0);
    dry.scene = world_text("%s effects { hertz { impactSpeed 1; } mindlin { friction 0.5; } } %s",
                           MATERIALS, FLOOR);
    wet.scene = world_text("%s effects { virtualMass {} } fluid { density 1e5; viscosity 1e-30; }",
                           dry.scene);
    TAP_OK(limit_of(&wet) == limit_of(&dry), "with friction added mass does not lengthen the step");

    /* T_R/5 = t_c/20 at v_0; t_c ~ v^(-1/5), so at v_0/3^5 three times T_R/5 is t_c/20 */
    const double E = 1e7/(1.0 - 0.09)/2.0, m = world_sphere_mass(R, density),
                 wave = world_pi*R*sqrt(density/(1e7/2.6))/surface_wave(0.3),
                 v_0 = m*m/(R*E*E)*pow(2.8682656992/(4.0*wave), 5.0);
    const double strict = rebound(v_0/243.0, 3.0, "", "0.2 of the Rayleigh time", 1.0);

    TAP_OK(rebound(v_0/243.0, 1.0, "", "0.2 of the Rayleigh time", 1.0) < 1e-4,
           "hertz, slow: at the Rayleigh limit an impact keeps its speed within 0.01 %%");
    TAP_OK(strict < 1e-3,
           "hertz, slow: the Rayleigh limit is strict, at three times of it within %.2g %%",
           100.0*strict);

    for (double nu = 0.0; nu < 0.5; nu += 0.12)
    {
        struct motion still = {.name = "Rayleigh time", .why = "0.2 of the Rayleigh time", .n = 1};

        still.scene = world_text("materials { a { density 2500; youngsModulus 1e7; poissonsRatio "
                                 "%g; } } effects { hooke { impactSpeed 1e-9; } }", nu);
        still.seed[0] = sphere(0.0, 0.0);
        /* 0.1631 nu + 0.8766 is a fit of three to four digits */
        TAP_NEAR(5.0*limit_of(&still)*surface_wave(nu)/
                     (world_pi*R*sqrt(density*2.0*(1.0 + nu)/1e7)), 1.0, 3.5e-3,
                 "a Rayleigh wave goes around half a sphere, nu = %g", nu);
    }
}

int main(void)
{
    TAP_TRAPS;
    springs();
    bonds();
    dampers();
    impacts();
    TAP_DONE;
}
