/*
 * test_gas_film.c -- heat through the gas between spheres, and at walls, is the published
 * integral, by quadrature.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "world.h"

#include <math.h>

static const double k = 0.026, c = 464.0, rho = 7800.0;

struct film    /* as laws/heat/gas_film.c names them; wall: 1 */
{
    double R, L, gap, s0, t;
    int wall;
};

static double gap_at(const struct film *f, double r)
{
    const double over = f->wall ? 0.0 : sqrt(f->L*f->L - r*r);

    return f->R + (f->wall ? 0.0 : f->L) + f->gap - over - sqrt(f->R*f->R - r*r);
}

/* r_b: the largest r at which the surface of the smaller sphere, or the wall, is in the film */
static double film_edge(const struct film *f)
{
    const double l = f->R + (f->wall ? 0.0 : f->L) + f->gap, film = (1.0 + f->t)*f->L;
    double low = 0.0, high = f->R;

    for (int n = 0; n < 200; n++)
    {
        const double r = 0.5*(low + high), z = f->wall ? 0.0 : sqrt(f->R*f->R - r*r);
        const double height = f->wall ? l : l - z;

        *(r*r + height*height < film*film ? &low : &high) = r;
    }
    return low;
}

/* r_a: the edge of the contact; apart, small */
static double contact_edge(const struct film *f)
{
    double low = 1e-10, high = f->R;

    for (int n = 0; n < 200; n++)
    {
        const double r = 0.5*(low + high);

        *(gap_at(f, r) < 0.0 ? &low : &high) = r;
    }
    return low;
}

/* Simpson's rule in ln r, from the contact to the edge of the film */
static double published(const struct film *f)
{
    enum { N = 400000 };
    const double edge = film_edge(f), from = log(contact_edge(f)), step = (log(edge) - from)/N;
    double sum = 0.0;

    for (int n = 0; n <= N && edge > 1e-9; n++)
    {
        const double r = fmin(exp(from + n*step), edge), s = gap_at(f, r);
        const double weight = n == 0 || n == N ? 1.0 : n%2 ? 4.0 : 2.0;

        sum += weight*2.0*world_pi*r*r/fmax(s, f->s0);
    }
    return k*sum*step/3.0;
}

static double mass(double R)
{
    return world_sphere_mass(R, rho);
}

static double temperature(struct dem *d, int64_t id)
{
    return world_scalar(d, "temperature", id);
}

/* From the heat that a frozen sphere at 400 K loses in a step to one, or a wall, of 300 K. `soft`:
   E over the real material's; the overlap is the real one over soft^(2/3). */
static double conductance(const struct film *f, double soft)
{
    const double dt = 1.0, overlap = f->gap < 0.0 ? f->gap*pow(soft, -2.0/3.0) : f->gap;
    char *const other =
        f->wall ? world_text("walls { wall { type plane; point (%.17g 0 0); normal (-1 0 0); "
                             "temperature { value 300; } } }", f->R + overlap)
                : world_text(" ");
    char *const pair =
        f->wall ? world_text(" ")
                : world_text("b { type list; frozen yes; diameter %.17g; positions ((%.17g 0 0)); "
                             "temperature 300; }", 2.0*f->L, f->R + f->L + overlap);
    struct dem *const d = world(world_text(
        "materials { steel { density 7800; youngsModulus 1e7; realModulus %.17g; "
        "heatCapacity 464; conductivity 42; } }"
        "effects { hertz { } gasFilm { conductivity %.17g; minGap %.17g; thickness %.17g; } } "
        "time { step %g; force yes; maxStartOverlap 0.1; } %s "
        "insert { a { type list; frozen yes; diameter %.17g; positions ((0 0 0)); temperature 400; } "
        "%s }", 1e7/soft, k, f->s0, f->t, dt, other, 2.0*f->R, pair),
        0, NULL);

    world_step(d);
    const double H = mass(f->R)*c*(400.0 - temperature(d, 0))/(dt*100.0);

    dem_free(d);
    return H;
}

static void conductances(void)
{
    static const struct
    {
        struct film film;
        double soft;
        const char *claim;
    } set[] = {
        {{3e-3, 3e-3, 3e-4, 4e-10, 0.2, 0}, 1.0, "half the reach apart"},
        {{3e-3, 3e-3, 1e-5, 1e-6, 0.2, 0}, 1.0, "near"},
        {{3e-3, 3e-3, 1e-7, 1e-6, 0.2, 0}, 1.0, "nearer than minGap"},
        {{3e-3, 3e-3, -1e-6, 4e-7, 0.2, 0}, 1.0, "touching"},
        {{3e-3, 3e-3, -1e-6, 4e-7, 0.2, 0}, 1e-2, "touching, 100 times softer than real"},
        {{1e-3, 3e-3, 2e-5, 1e-6, 0.2, 0}, 1.0, "unlike radii"},
        {{1e-3, 3e-3, -1e-6, 1e-6, 0.1, 0}, 1.0, "unlike radii, touching, in a thin film"},
        {{1e-3, 9e-3, 2e-5, 1e-6, 0.5, 0}, 1.0, "a small sphere within the film"},
        {{3e-3, 3e-3, 1e-4, 4e-7, 0.2, 1}, 1.0, "a wall"},
        {{3e-3, 3e-3, -1e-6, 4e-7, 0.2, 1}, 1.0, "a wall, touching"},
        {{3e-3, 3e-3, 1e-4, 4e-7, 1.0, 1}, 1.0, "a wall, in a film as thick as the radius"},
    };

    for (size_t n = 0; n < sizeof set/sizeof *set; n++)
    {
        const double expected = published(&set[n].film);

        TAP_NEAR(conductance(&set[n].film, set[n].soft)/expected, 1.0, 1e-6,
                 /* Simpson's rule over the kink at minGap */
                 "%s: the published integral, %.4g W/K", set[n].claim, expected);
    }
}

static void cut_off(void)
{
    const struct film within = {3e-3, 3e-3, 0.1999*3e-3, 1e-7, 0.2, 0},
                      beyond = {3e-3, 3e-3, 0.2001*3e-3, 1e-7, 0.2, 0};
    const struct film wall = {3e-3, 3e-3, 0.2001*3e-3, 1e-7, 0.2, 1};

    TAP_NEAR(conductance(&within, 1.0)/published(&within), 1.0, 1e-6, "within the film");
    TAP_OK(published(&within) < 2e-3*2.0*world_pi*k*3e-3, "it begins at zero: %.3g W/K",
           published(&within));
    TAP_OK(conductance(&beyond, 1.0) == 0.0 && conductance(&wall, 1.0) == 0.0,
           "none beyond, nor at a wall");
}

static void chain(void)
{
    enum { N = 6 };
    const double R = 3e-3, gap = 3e-5, dt = 20.0;
    const struct film pair = {R, R, gap, 1e-7, 0.2, 0}, wall = {R, R, gap, 1e-7, 0.2, 1};
    const double Hp = published(&pair), Hw = published(&wall);
    char positions[64*N] = "";
    double worst = 0.0;

    for (int n = 0; n < N; n++)
    {
        snprintf(positions + strlen(positions), 64, "(0 0 %.17g) ", R + gap + n*(2.0*R + gap));
    }
    struct dem *const d = world(world_text(
        "materials { steel { density 7800; youngsModulus 1e7; heatCapacity 464; } }"
        "effects { hertz { } gasFilm { conductivity %g; minGap 1e-7; } } time { step %g; force yes; } "
        "walls { low { type plane; point (0 0 0); normal (0 0 1); temperature { value 300; } } "
        "high { type plane; point (0 0 %.17g); normal (0 0 -1); temperature { value 400; } } } "
        "insert { chain { type list; frozen yes; diameter %g; positions (%s); temperature 320; } }",
        k, dt, N*(2.0*R + gap) + gap, 2.0*R, positions),
        0, NULL);

    world_run(d, 3000.0*dt);
    for (int n = 0; n < N; n++)
    {
        const double expected =
            300.0 + 100.0*(1.0/Hw + n/Hp)/(2.0/Hw + (N - 1)/Hp);

        worst = fmax(worst, fabs(temperature(d, n) - expected));
    }
    TAP_NEAR(worst, 0.0, 1e-4, "a chain: films in series");    /* 1e-6 of the range, as above */
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    conductances();
    cut_off();
    chain();
    TAP_DONE;
}
