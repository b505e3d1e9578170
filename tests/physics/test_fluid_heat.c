/*
 * test_fluid_heat.c -- heat transfer to a fluid is exact at any ratio of the step to the
 * relaxation time, and the implicit exchange with a cell conserves energy at any ratio of
 * capacities.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "world.h"

#include <math.h>

static const double rho_p = 2500.0, d = 1e-3, rho = 1.2, mu = 1.8e-5, k_f = 0.026, c_f = 1007.0;

/* ---- a stream -------------------------------------------------------------------------------- */

/* Ranz and Marshall */
static double coefficient(double speed)
{
    return world_pi*d*k_f*(2.0 + 0.6*sqrt(rho*speed*d/mu)*cbrt(mu*c_f/k_f));
}

static void test_stream(void)
{
    const double B = coefficient(2.0), m = rho_p*world_pi/6.0*d*d*d, step = 1e-5;

    for (double ratio = 0.01; ratio < 200.0; ratio *= 10.0)
    {
        const int steps = ratio < 1.0 ? 100 : 3;
        struct dem *const s = world(world_text(
            "materials { glass { density %g; youngsModulus 1e5; heatCapacity %.17g; } }"
            "effects { hertz { } ranzMarshall { } }"
            "fluid { density %g; viscosity %g; velocity (0 2 0); voidFraction 0.7; temperature 300; "
            "conductivity %g; heatCapacity %g; } time { step %g; }"
            "insert { one { type list; diameter %g; positions ((0 0 0)); temperature 400; } }",
            rho_p, B*step/ratio/m, rho, mu, k_f, c_f, step, d),
            0, NULL);

        world_run(s, steps*step);
        /* exponents have the rounding of `steps` products; T the rounding of 400 K */
        TAP_NEAR(dem_scalar(s, dem_scalar_index(s, "temperature"))[0],
                 300.0 + 100.0*exp(-ratio*steps), 400.0*3e-16*steps,
                 "a stream cools a sphere: %d steps of %g tau", steps, ratio);
        dem_free(s);
    }
}

/* ---- a cell of fluid ------------------------------------------------------------------------- */

enum
{
    N = 12
};

struct cell
{
    struct dem *d;
    double heat[N];                         /* J/K  of each particle */
    double capacity, temperature;           /* J/K, K  of the fluid */
};

static struct dem *particles(double heat_capacity)
{
    return world(world_text(
        "materials { glass { density %g; youngsModulus 1e7; heatCapacity %.17g; } }"
        "effects { hertz { } gunn { } } time { step 1e-6; }"
        "insert { some { type random; sizes { type uniform; min 0.5e-3; max 1e-3; } count %d; "
        "min (0 0 0); max (0.02 0.02 0.02); temperature { min 300; max 400; } } }",
        rho_p, heat_capacity, N), 0, NULL);
}

static double *scalar(struct dem *s, const char *name)
{
    return dem_scalar(s, dem_scalar_index(s, name));
}

/* fluid values at the particles before a window */
static void give_fluid(struct cell *q)
{
    struct dem_fluid f;

    WORLD_TRY(dem_fluid(q->d, &f));
    for (size_t i = 0; i < f.n; i++)
    {
        f.velocity[3*i] = 1.0;
        f.void_fraction[i] = 0.6;
        f.density[i] = rho;
        f.viscosity[i] = mu;
        scalar(q->d, "fluidTemperature")[i] = q->temperature;
        scalar(q->d, "fluidConductivity")[i] = k_f;
        scalar(q->d, "fluidHeatCapacity")[i] = c_f;
    }
}

static struct dem_scalar_exchange exchange(struct cell *q)
{
    struct dem_scalar_exchange x;

    WORLD_TRY(dem_scalar_exchange(q->d, dem_scalar_index(q->d, "temperature"), &x));
    return x;
}

/* C_f (T' - T) = -sum (J + R (T' - T)); the particles get R (T' - T) in the next window */
static void window(struct cell *q, double time, int implicit)
{
    double J = 0.0, R = 0.0, target[N];

    give_fluid(q);
    world_run(q->d, time);
    const struct dem_scalar_exchange x = exchange(q);

    for (size_t i = 0; i < x.n; i++)
    {
        J += x.received[i];
        R += implicit ? x.response[i] : 0.0;
    }
    q->temperature -= J/(q->capacity + R);
    for (size_t i = 0; i < x.n; i++)
    {
        target[i] = q->temperature;
    }
    if (implicit)
    {
        WORLD_TRY(dem_scalar_correct(q->d, dem_scalar_index(q->d, "temperature"), target));
    }
}

/* fluid, particles, and what the particles are still to get */
static double energy(struct cell *q)
{
    const double *const T = scalar(q->d, "temperature");
    const struct dem_scalar_exchange x = exchange(q);
    double sum = q->capacity*q->temperature;

    for (size_t i = 0; i < x.n; i++)
    {
        sum += q->heat[i]*T[i] + x.carried_over[i];
    }
    return sum;
}

static double deviation(struct cell *q, double from)
{
    const double *const T = scalar(q->d, "temperature");
    double max = fabs(q->temperature - from);

    for (int i = 0; i < N; i++)
    {
        max = fmax(max, fabs(T[i] - from));
    }
    return max;
}

/* particles of `loading` times the fluid's capacity; returns the deviation that is left */
static double relax(double ratio, double loading, int windows, int implicit, double *lost)
{
    const double time = 4e-6;
    double all = 0.0;
    struct cell q;
    struct dem_view v;

    /* the window is `ratio` tau of a particle of 0.7 mm with Gunn's Nu at Re = 28, about 11 */
    const double B = 11.0*world_pi*0.7e-3*k_f, m = rho_p*world_pi/6.0*0.343e-9;
    const double heat_capacity = B*time/ratio/m;

    q.d = particles(heat_capacity);
    dem_view(q.d, &v);
    for (int i = 0; i < N; i++)
    {
        q.heat[i] = heat_capacity*world_take(&v, (size_t)i).mass;
        all += q.heat[i];
    }
    q.capacity = all/loading;
    q.temperature = 500.0;
    const double first = energy(&q), mixed = first/(all + q.capacity);
    double worst = 0.0;

    for (int k = 0; k < windows; k++)
    {
        window(&q, time, implicit);
        worst = fmax(worst, fabs(energy(&q) - first)/first);
        if (!(deviation(&q, mixed) < 1e4) || q.temperature <= 0.0)
        {
            break;
        }
    }
    *lost = worst;
    const double left = deviation(&q, mixed);

    dem_free(q.d);
    return left;
}

static void test_cell(void)
{
    static const double ratio[] = {0.1, 1.0, 10.0, 100.0}, loading[] = {1.0, 10.0, 100.0, 1000.0};
    double lost, most = 0.0;

    for (int r = 0; r < 4; r++)
    {
        for (int l = 0; l < 4; l++)
        {
            const double left = relax(ratio[r], loading[l], 400, 1, &lost);

            most = fmax(most, lost);
            TAP_OK(left < 1e-6, "window of %g tau, loading %g: %.1e K from the mixed temperature",
                   ratio[r], loading[l], left);
        }
    }
    TAP_OK(most < 1e-13, "energy of fluid and particles is conserved: %.1e", most);
    TAP_OK(relax(1.0, 10.0, 400, 0, &lost) > 10.0, "an explicit exchange is unstable there");
}

static void test_total(void)
{
    struct dem *const s = particles(800.0);
    const double *const T = scalar(s, "temperature");
    double sum = 0.0, total = 0.0;
    struct dem_view v;

    dem_view(s, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        sum += 800.0*world_take(&v, i).mass*T[i];
    }
    WORLD_TRY(dem_scalar_total(s, dem_scalar_index(s, "temperature"), &total));
    TAP_NEAR(total, sum, 1e-15*N*sum, "heat of all particles (J)");
    TAP_OK(dem_scalar_total(s, 99, &total) == DEM_ERROR_INPUT, "%s", dem_error_text());
    dem_free(s);
}

/* ---- particles that enter ---------------------------------------------------------------------- */

/* As for all others: C (1 - exp(-B t/C)) <= R <= B t, with the time t that they have been there. */
static void test_entering(void)
{
    struct dem *const s = world(world_text(
        "materials { glass { density %g; youngsModulus 1e5; heatCapacity 800; } } effects { hertz { } "
        "gunn { } } fluid { density %g; viscosity %g; temperature 300; conductivity %g; heatCapacity "
        "%g; } time { step 1e-5; } insert { rain { type stream; diameter %g; rate 1e5; min (0 0 0); "
        "max (0.02 0.02 0.01); velocity (0 0 -1); temperature 400; } }",
        rho_p, rho, mu, k_f, c_f, d),
        0, NULL);
    struct dem_scalar_exchange x;
    int bad = 0;

    world_run(s, 2e-3);
    WORLD_TRY(dem_scalar_exchange(s, dem_scalar_index(s, "temperature"), &x));
    for (size_t i = 0; i < x.n; i++)
    {
        bad += !(x.response[i] <= x.coefficient_time[i]*(1.0 + 1e-9));
    }
    TAP_OK(x.n > 50 && bad == 0, "the response of %zu particles that entered is bounded", x.n);
    dem_free(s);
}

/* ---- input ----------------------------------------------------------------------------------- */

static void refused(const char *effects, const char *fluid, const char *insert, const char *words)
{
    char *const text = world_text(
        "materials { glass { density 2500; youngsModulus 1e7; heatCapacity 800; } } effects { hertz "
        "{ } %s } fluid { density 1.2; viscosity 1.8e-5; %s } insert { a { type list; diameter "
        "1e-3; positions ((0 0 0)); %s } }", effects, fluid, insert);
    world_refused(text, words);
}

static void test_input(void)
{
    static const char whole[] = "temperature 300; conductivity 0.026; heatCapacity 1007;";
    struct cell q = {.d = particles(800.0), .temperature = 0.0};

    refused("gunn { } wakao { }", whole, "", "are of the same kind");
    refused("gunn { }", "temperature 300; conductivity 0.026;", "", "heatCapacity");
    refused("gunn { }", "temperature 0; conductivity 0.026; heatCapacity 1007;", "",
            "temperature 0 K");
    refused("", whole, "", "fluid/temperature acts only with one of these effects: gunn, ranzMarshall, wakao;");
    refused("gunn { }", whole, "fluidTemperature 300;", "fluidTemperature");
    give_fluid(&q);
    TAP_OK(dem_advance(q.d, 1e-6) == DEM_ERROR_INPUT &&
               strstr(dem_error_text(), "fluidTemperature"),
           "a coupled fluid without temperature: %s", dem_error_text());
    dem_free(q.d);
}

int main(void)
{
    TAP_TRAPS;
    test_stream();
    test_cell();
    test_total();
    test_entering();
    test_input();
    TAP_DONE;
}
