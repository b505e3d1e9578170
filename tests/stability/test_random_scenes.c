/*
 * test_random_scenes.c -- invariants of random scenes.
 *
 * - Numbers stay finite.
 * - Momentum and angular momentum are conserved without external forces.
 * - Energy is not created beyond the error of the integrator.
 * - Several ranks have the bits of one; a restarted run has the bits of the uninterrupted one.
 *
 *     mpirun -np 3 test_random_scenes FIRST COUNT FOLDER    scenes of seeds FIRST ...; snapshots go
 *                                                           to the folder; prints the largest errors
 *     test_random_scenes -print SEED                        prints that scene, for `dem run`
 *
 * Random are: materials and pairs, contact laws, rolling resistance, adhesion and bonds, sizes,
 * groups with velocity and spin, gravity, domain, walls at rest and in motion, a uniform fluid with
 * a drag law and related effects. Not included: streams, coupled runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/random.h"
#include "dem_query.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
    TEXT = 8192,
    HALF = 500                               /* steps to the snapshot, and from there on */
};

enum surroundings
{
    OPEN, PERIODIC, BOX, FLOOR, TUBE, FACETS, SHAKER, SURROUNDINGS
};

enum worst
{
    MOMENTUM, ANGULAR, CREATED, ABOVE, KINDS
};
static const char *const kinds[KINDS] = {"momentum", "angular momentum", "energy created",
                                         "energy above the input"};

struct scene
{
    char text[TEXT];
    size_t used;
    uint64_t seed, drawn;
    enum surroundings around;
    int gravity, fluid;
    double side;                                          /* m */
};

struct result
{
    uint64_t hash, again;
    int failed;
    double worst[KINDS];                                  /* relative */
};

/* ---- random scenes --------------------------------------------------------------------------------- */

static double random_unit(struct scene *s)
{
    return dem_random_unit(s->seed, s->drawn++, 77, 0);
}

static double random_between(struct scene *s, double low, double high)
{
    return low + (high - low)*random_unit(s);
}

static int random_index(struct scene *s, int n)
{
    const int k = (int)(n*random_unit(s));

    return k < n ? k : n - 1;
}

__attribute__((format(printf, 2, 3)))
static void append(struct scene *s, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    s->used += (size_t)vsnprintf(s->text + s->used, TEXT - s->used, format, arguments);
    va_end(arguments);
}

static const char *select_word(struct scene *s, const char *const *words, int n)
{
    return words[random_index(s, n)];
}

static void draw_contacts(struct scene *s)
{
    static const char *const resists[] = {"", "rollingConstant { friction 0.1; }",
                                          "rollingSpring { friction 0.2; damping 0.3; }",
                                          "rollingViscous { time 1e-4; }"};
    const int normal = random_index(s, 4), damping = random_index(s, 3),
              friction = random_index(s, 4), adheres = random_index(s, 6);

    append(s, "    %s\n",
        normal < 2 ? "hertz { impactSpeed 2; }"
        : normal == 2 ? "hooke { impactSpeed 2; }"
                      : "");
    if (normal == 3)
    {
        append(s,
            "    hookeHysteresis { impactSpeed 2; unloading %.3g; adhesion %.3g; "
            "plasticDepth %.3g; }\n",
            random_between(s, 1.0, 6.0), random_between(s, 0.0, 3.0), random_between(s, 0.0, 0.1));
    }
    if (damping)
    {
        append(s,
            damping == 1 ? "    dry { restitution %.3g; }\n"
                         : "    viscous { coefficient %.3g; }\n",
            damping == 1 ? random_unit(s) : random_between(s, 0.0, 2e-3));
    }
    if (friction)
    {
        static const char *const laws[] = {"mindlin", "mindlinIncremental", "linear"};
        append(s, "    %s { friction %.3g; }\n", laws[friction - 1], random_between(s, 0.0, 1.0));
    }
    append(s, "    %s\n", select_word(s, resists, 4));
    append(s,
           random_index(s, 4) == 0 ? "    twistingSpring { friction 0.3; damping 0.2; }\n" : "\n");
    if (adheres == 1 && normal < 2)
    {
        append(s, "    jkr { workOfAdhesion %.3g; }\n", random_between(s, 0.0, 0.2));
    }
    if (adheres == 2)
    {
        append(s, "    sjkr { energyDensity %.3g; }\n", random_between(s, 0.0, 1e4));
    }
    if (adheres == 3)
    {
        append(
            s,
            "    bondLinear { normalStiffness %.3g; shearStiffness %.3g; makeDistance 1.1; "
            "breakDistance 1.3; make %s; normalStrength %.3g; shearStrength %.3g; "
            "dampingRatio %.2g; }\n",
            random_between(s, 1e8, 1e9), random_between(s, 1e7, 5e8),
            random_index(s, 2) ? "once" : "always", random_between(s, 1e4, 1e6),
            random_between(s, 1e4, 1e6), random_between(s, 0.0, 0.2));
    }
}

static void draw_fluid(struct scene *s)
{
    static const char *const drags[] = {"stokesDrag", "schillerNaumann", "wenYu",
                                        "gidaspow", "diFelice", "rong",
                                        "kochHill", "tenneti"};
    const char *const drag = select_word(s, drags, 8);

    s->fluid = random_index(s, 3) == 0;
    if (s->fluid)
    {
        const int lift = random_index(s, 3) == 0;

        append(s, "    %s { } pressureGradient { }%s%s\n", drag,
            random_index(s, 3) ? "" : " virtualMass { }",
            lift ? " saffmanMei { } magnus { } viscousTorque { }" : "");
        append(
            s,
            "}\nfluid { density %.4g; viscosity %.3g; velocity (%.3g %.3g %.3g); "
            "voidFraction %.3g;%s }\n",
            random_index(s, 2) ? 1000.0 : 1.2, pow(10.0, random_between(s, -5.0, 0.0)),
            random_between(s, -0.5, 0.5), random_between(s, -0.5, 0.5),
            random_between(s, -0.5, 0.5), random_between(s, 0.5, 1.0),
            lift ? " vorticity (20 -10 5);" : "");
    }
    else
    {
        append(s, "}\n");
    }
}

static void draw_surroundings(struct scene *s)
{
    const double L = s->side;

    switch (s->around)
    {
    case PERIODIC:
        append(s, "domain { min (0 0 0); max (%.9g %.9g %.9g); periodic (x y z); }\n", L, L, L);
        break;
    case BOX:
        append(s, "walls { box { type box; material a; min (0 0 0); max (%.9g %.9g %.9g); } }\n", L,
               L, L);
        break;
    case FLOOR:
        append(s,
            "domain { x (0 %.9g); y (0 %.9g); periodic (x y); }\nwalls { floor { type plane; "
            "material b; point (0 0 0); normal (0 0 1); surfaceVelocity (%.3g 0 0); } }\n",
            L, L, random_between(s, -1.0, 1.0));
        break;
    case TUBE:
        append(s,
            "walls { tube { type cylinder; material a; point (%.9g %.9g 0); axis (0 0 1); "
            "radius %.9g; particles inside; motion { type rotation; origin (%.9g %.9g 0);"
            " axis (0 0 1); omega %.3g; } } lid { type plane; material a; point (0 0 0); "
            "normal (0 0 1); } }\n",
            0.5*L, 0.5*L, 0.75*L, 0.5*L, 0.5*L, random_between(s, -30.0, 30.0));
        break;
    case FACETS:
        append(s,
            "walls { roof { type triangles; material b; "
            "corners ((%.9g %.9g 0) (%.9g %.9g 0) (%.9g %.9g 0)  (%.9g %.9g 0) (%.9g %.9g 0) "
            "(%.9g %.9g 0)); } }\n",
            -L, -L, 2.0*L, -L, 2.0*L, 2.0*L, -L, -L, 2.0*L, 2.0*L, -L, 2.0*L);
        break;
    case SHAKER:
        append(
            s,
            "walls { floor { type plane; material a; point (0 0 %.9g); normal (0 0 1); "
            "motion { type oscillation; amplitude (0 %.3g %.3g); frequency %.4g; } } }\n",
            -2e-4, random_between(s, 0.0, 1e-4), random_between(s, 0.0, 2e-4),
            random_between(s, 10.0, 300.0));
        break;
    default:
        break;
    }
}

static void draw_particles(struct scene *s, double d)
{
    const int groups = 2 + random_index(s, 3);

    append(s, "insert\n{\n");
    for (int k = 0; k < groups; k++)
    {
        const double least = d*random_between(s, 0.3, k == 0 ? 0.9 : 0.95),
                     fast = random_between(s, 0.0, 0.8);

        append(
            s,
            "    g%d { type random; material %s; count %d; seed %d; min (0 0 0); "
            "max (%.9g %.9g %.9g); ",
            k, random_index(s, 2) ? "a" : "b", 3 + random_index(s, 15), k + 1, s->side, s->side,
            s->side);
        append(s,
               random_index(s, 2) ? "diameter %.6g; "
                                  : "sizes { type uniform; min %.6g; max %.6g; } ",
               least, d);
        append(s, "velocity (%.4g %.4g %.4g); spin (%.4g %.4g %.4g); }\n",
               fast*random_between(s, -1.0, 1.0), fast*random_between(s, -1.0, 1.0),
               fast*random_between(s, -1.0, 1.0), random_between(s, -300.0, 300.0),
               random_between(s, -300.0, 300.0), random_between(s, -300.0, 300.0));
    }
    append(s, "}\n");
}

static void draw(struct scene *s, uint64_t seed)
{
    memset(s, 0, sizeof *s);
    s->seed = seed;
    const double d = random_between(s, 0.5e-3, 2e-3);

    s->side = d*random_between(s, 4.6, 8.0);
    s->around = (enum surroundings)random_index(s, SURROUNDINGS);
    append(
        s,
        "// seed %llu\nmaterials { a { density %.4g; youngsModulus %.4g; poissonsRatio %.3g; } "
        "b { density %.4g; youngsModulus %.4g; } }\n",
        (unsigned long long)seed, random_between(s, 800.0, 8000.0),
        pow(10.0, random_between(s, 6.3, 8.0)), random_between(s, 0.0, 0.49),
        random_between(s, 800.0, 8000.0), pow(10.0, random_between(s, 6.3, 8.0)));
    append(s, "effects\n{\n");
    s->gravity = random_index(s, 2);
    if (s->gravity)
    {
        append(s, "    gravity { acceleration (1 -2 -9.81); }\n");
    }
    draw_contacts(s);
    draw_fluid(s);
    draw_surroundings(s);
    draw_particles(s, d);
}

/* ---- running --------------------------------------------------------------------------------- */

static int make(struct dem **d, const struct scene *s, MPI_Comm comm, const char *from)
{
    struct dem_case *c;
    int status = dem_case_create(&c, comm);

    status = status ? status : dem_case_scene_text(c, s->text, "scene");
    status = status ? status : comm == MPI_COMM_NULL && !from ? dem_case_enable_energy(c) : 0;
    status = status ? status : from ? dem_case_load(c, from) : 0;
    status = status ? status : dem_start(&c, d);
    dem_case_free(c);
    return status;
}

/* over all particles: kg m/s, kg m2/s; and sums of magnitudes */
struct sums
{
    double p[3], l[3], all_p, all_l, mass;
    int finite;
};

static struct sums sums_of(struct dem *d)
{
    struct sums t = {.finite = 1};
    struct dem_view w;

    dem_view(d, &w);
    for (size_t i = 0; i < w.n; i++)
    {
        const double *const x = dem_at(w.position, w.stride, i),
                            *const v = dem_at(w.velocity, w.stride, i),
                            *const spin = dem_at(w.spin, w.stride, i);
        const double m = *dem_at(w.mass, w.stride, i), r = *dem_at(w.radius, w.stride, i);

        for (int a = 0; a < 3; a++)
        {
            const int b = (a + 1)%3, c = (a + 2)%3;
            const double l = m*(x[b]*v[c] - x[c]*v[b]), turn = 0.4*m*r*r*spin[a];

            t.p[a] += m*v[a], t.l[a] += l + turn;
            t.all_p += fabs(m*v[a]), t.all_l += fabs(l) + fabs(turn);
            t.finite = t.finite && isfinite(x[a]) && isfinite(v[a]) && isfinite(spin[a]);
        }
        t.mass += m;
    }
    return t;
}

static double most(double a, double b)
{
    return a > b ? a : b;
}

/* Gravity is the only external force on particles in an open or periodic domain without a fluid: M
   g t. */
static void check_motion(const struct scene *s, const struct sums *now, const struct sums *then,
                         double time, struct result *r)
{
    static const double g[3] = {1.0, -2.0, -9.81};

    for (int a = 0; a < 3 && s->around <= PERIODIC && !s->fluid; a++)
    {
        const double p = now->p[a] - then->p[a] - (s->gravity ? then->mass*g[a]*time : 0.0),
                     l = now->l[a] - then->l[a];

        r->worst[MOMENTUM] = most(r->worst[MOMENTUM], fabs(p)/(then->all_p + now->all_p));
        r->worst[ANGULAR] = s->around == OPEN && !s->gravity
                                ? most(r->worst[ANGULAR], fabs(l)/(then->all_l + now->all_l))
                                : r->worst[ANGULAR];
    }
}

static int starts_with(const char *name, const char *word)
{
    return strncmp(name, word, strlen(word)) == 0;
}

/* Friction springs may be cut to store more than the work of slip (the part of the dashpot,
   docs/energy-balance.md). They dissipate it later, so their energy is not counted here. */
static int is_counted(const char *name)
{
    return starts_with(name, "kinetic") || starts_with(name, "gravity") ||
           (starts_with(name, "elastic") && !strstr(name, "mindlin") && !strstr(name, "linear") &&
            !strstr(name, "ingSpring"));
}

/* The residual, and kinetic and elastic energy less the work of walls and fluid and the initial
   energy, over the larger of the initial kinetic energy and the work of gravity, walls and fluid.
   */
static int check_energy(struct dem *d, double start, struct result *r)
{
    const struct dem_energy_item *item;
    double since, scale = start, held = 0.0;
    int n, status = dem_energy(d, &since, &n, &item);

    for (int k = 0; !status && k < n; k++)
    {
        const int is_input = starts_with(item[k].name, "gravity") ||
                             starts_with(item[k].name, "work") ||
                             starts_with(item[k].name, "kinetic");

        scale = most(scale, is_input ? fabs(item[k].value) : 0.0);
        held += is_counted(item[k].name) ? item[k].value
                : starts_with(item[k].name, "work") ? -item[k].value
                                               : 0.0;
    }
    if (!status && scale > 0.0)
    {
        r->worst[CREATED] = most(r->worst[CREATED], item[n - 1].value/scale);
        r->worst[ABOVE] = most(r->worst[ABOVE], (held - start)/scale);
    }
    return status;
}

/* On one rank: to the half, save, to the end; then from the half to the end again. */
static int run_alone(const struct scene *s, const char *file, struct result *r)
{
    struct dem *d = NULL, *e = NULL;
    struct dem_totals t;
    int status = make(&d, s, MPI_COMM_NULL, NULL);

    status = status ? status : dem_totals(d, &t);
    const struct sums then = status ? (struct sums){.finite = 1} : sums_of(d);
    const double start = status ? 0.0 : t.kinetic,
                 half = status ? 0.0 : HALF*dem_step_limit(d).limit;

    for (int k = 0; k < 2 && !status; k++)
    {
        status = dem_advance(d, half);
        status = status ? status : check_energy(d, start, r);
        status = status || k ? status : dem_save(d, file);
        const struct sums now = sums_of(d);
        r->failed |= !now.finite;
        check_motion(s, &now, &then, half*(k + 1), r);
    }
    status = status ? status : dem_hash(d, &r->hash);
    status = status ? status : make(&e, s, MPI_COMM_NULL, file);
    status = status ? status : dem_advance(e, half);
    status = status ? status : dem_hash(e, &r->again);
    dem_free(d), dem_free(e);
    remove(file);
    return status;
}

static int run_together(const struct scene *s, uint64_t *hash)
{
    struct dem *d = NULL;
    int status = make(&d, s, MPI_COMM_WORLD, NULL);
    const double half = status ? 0.0 : HALF*dem_step_limit(d).limit;

    status = status ? status : dem_advance(d, half);
    status = status ? status : dem_advance(d, half);
    status = status ? status : dem_hash(d, hash);
    dem_free(d);
    return status;
}

static void report(uint64_t seed, const char *what, double value)
{
    printf("# seed %llu: %s %.3g %s\n", (unsigned long long)seed, what, value, dem_error_text());
    fflush(stdout);
}

int main(int argc, char **argv)
{
    /* round-off of sums; for the energy the largest error due to dashpots, jumps and bonds at the
       longest step: README.md */
    static const double limit[KINDS] = {1e-11, 1e-10, 0.02, 0.02};
    static struct scene s;
    double worst[KINDS] = {0.0};
    int rank, ranks, bad = 0;
    char file[512];

    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (argc == 3)
    {
        draw(&s, strtoull(argv[2], NULL, 10));
        printf("%stime { end 0.01; }\nwrite { energy 0.001; }\n", s.text);
    }
    const uint64_t first = argc == 4 ? strtoull(argv[1], NULL, 10) : 0,
                   count = argc == 4 ? strtoull(argv[2], NULL, 10) : 0;
    struct result *const r = calloc(count + 1, sizeof *r);

    for (uint64_t k = (uint64_t)rank; k < count; k += (uint64_t)ranks)
    {
        snprintf(file, sizeof file, "%s/random%llu.dem", argv[3], (unsigned long long)(first + k));
        draw(&s, first + k);
        r[k].failed |= run_alone(&s, file, &r[k]) != 0;
        if (r[k].failed || r[k].hash != r[k].again)
        {
            report(first + k, r[k].failed ? "fails:" : "a different end after a restart", 0.0);
            bad++;
        }
        for (int j = 0; j < KINDS; j++)
        {
            worst[j] = most(worst[j], r[k].worst[j]);
            if (!(r[k].worst[j] <= limit[j]))
            {
                report(first + k, kinds[j], r[k].worst[j]);
                bad++;
            }
        }
    }
    for (uint64_t k = 0; k < count && ranks > 1; k++)
    {
        uint64_t hash = 0, alone = r[k].hash;

        draw(&s, first + k);
        const int status = run_together(&s, &hash);
        MPI_Bcast(&alone, 1, MPI_UINT64_T, (int)(k%(uint64_t)ranks), MPI_COMM_WORLD);
        if (rank == 0 && (status || hash != alone))
        {
            report(first + k, "different bits on several ranks,", status);
            bad++;
        }
    }
    MPI_Allreduce(MPI_IN_PLACE, worst, KINDS, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    MPI_Allreduce(MPI_IN_PLACE, &bad, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    for (int j = 0; rank == 0 && count && j < KINDS; j++)
    {
        printf("worst %s: %.3g limit %.3g\n", kinds[j], worst[j], limit[j]);
    }
    if (rank == 0 && count)
    {
        printf("scenes %llu bad %d ranks %d\n", (unsigned long long)count, bad, ranks);
    }
    free(r);
    MPI_Finalize();
    return bad > 0;
}
