/*
 * Claims for scenes drawn at random: numbers stay finite; momentum and angular momentum are conserved without external forces; energy
 * is not created beyond the error of the integrator; several ranks have the bits of one; a restarted run has the bits of a straight one.
 *
 *     mpirun -np 3 test_random FIRST COUNT FOLDER     scenes of seeds FIRST ...; snapshots go into the folder; prints the worst of all
 *     test_random -print SEED                         that scene, for `dem run`
 *
 * Drawn are: materials and pairs, laws of contact, resistance, adhesion and bonds, sizes, groups with velocity and spin, gravity, domain,
 * walls at rest and moving, a uniform fluid with a drag law and related effects. Not included: streams, coupled runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/random.h"
#include "dem.h"
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
                                         "energy above what was put in"};

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

/* ---- drawing --------------------------------------------------------------------------------- */

static double unit(struct scene *s)
{
    return dem_random_unit(s->seed, s->drawn++, 77, 0);
}

static double between(struct scene *s, double low, double high)
{
    return low + (high - low)*unit(s);
}

static int one_of(struct scene *s, int n)
{
    const int k = (int)(n*unit(s));

    return k < n ? k : n - 1;
}

__attribute__((format(printf, 2, 3)))
static void say(struct scene *s, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    s->used += (size_t)vsnprintf(s->text + s->used, TEXT - s->used, format, arguments);
    va_end(arguments);
}

static const char *pick(struct scene *s, const char *const *words, int n)
{
    return words[one_of(s, n)];
}

static void draw_contacts(struct scene *s)
{
    static const char *const resists[] = {"", "rollingConstant { friction 0.1; }",
                                          "rollingSpring { friction 0.2; damping 0.3; }",
                                          "rollingViscous { time 1e-4; }"};
    const int normal = one_of(s, 4), damping = one_of(s, 3), friction = one_of(s, 4),
              adheres = one_of(s, 6);

    say(s, "    %s\n",
        normal < 2 ? "hertz { impactSpeed 2; }"
        : normal == 2 ? "hooke { impactSpeed 2; }"
                      : "");
    if (normal == 3)
    {
        say(s,
            "    hookeHysteresis { impactSpeed 2; unloading %.3g; adhesion %.3g; plasticDepth %.3g; }\n",
            between(s, 1.0, 6.0), between(s, 0.0, 3.0), between(s, 0.0, 0.1));
    }
    if (damping)
    {
        say(s,
            damping == 1 ? "    dry { restitution %.3g; }\n"
                         : "    viscous { coefficient %.3g; }\n",
            damping == 1 ? unit(s) : between(s, 0.0, 2e-3));
    }
    if (friction)
    {
        static const char *const laws[] = {"mindlin", "mindlinIncremental", "linear"};
        say(s, "    %s { friction %.3g; }\n", laws[friction - 1], between(s, 0.0, 1.0));
    }
    say(s, "    %s\n", pick(s, resists, 4));
    say(s, one_of(s, 4) == 0 ? "    twistingSpring { friction 0.3; damping 0.2; }\n" : "\n");
    if (adheres == 1 && normal < 2)
    {
        say(s, "    jkr { workOfAdhesion %.3g; }\n", between(s, 0.0, 0.2));
    }
    if (adheres == 2)
    {
        say(s, "    sjkr { energyDensity %.3g; }\n", between(s, 0.0, 1e4));
    }
    if (adheres == 3)
    {
        say(s,
            "    bondLinear { normalStiffness %.3g; shearStiffness %.3g; makeDistance 1.1; breakDistance 1.3; make %s; normalStrength %.3g; shearStrength %.3g; dampingRatio %.2g; }\n",
            between(s, 1e8, 1e9), between(s, 1e7, 5e8), one_of(s, 2) ? "once" : "always",
            between(s, 1e4, 1e6), between(s, 1e4, 1e6), between(s, 0.0, 0.2));
    }
}

static void draw_fluid(struct scene *s)
{
    static const char *const drags[] = {"stokesDrag", "schillerNaumann", "wenYu",
                                        "gidaspow", "diFelice", "rong",
                                        "kochHill", "tenneti"};
    const char *const drag = pick(s, drags, 8);

    s->fluid = one_of(s, 3) == 0;
    if (s->fluid)
    {
        const int lift = one_of(s, 3) == 0;

        say(s, "    %s { } pressureGradient { }%s%s\n", drag,
            one_of(s, 3) ? "" : " virtualMass { }",
            lift ? " saffmanMei { } magnus { } viscousTorque { }" : "");
        say(s,
            "}\nfluid { density %.4g; viscosity %.3g; velocity (%.3g %.3g %.3g); voidFraction %.3g;%s }\n",
            one_of(s, 2) ? 1000.0 : 1.2, pow(10.0, between(s, -5.0, 0.0)), between(s, -0.5, 0.5),
            between(s, -0.5, 0.5), between(s, -0.5, 0.5), between(s, 0.5, 1.0),
            lift ? " vorticity (20 -10 5);" : "");
    }
    else
    {
        say(s, "}\n");
    }
}

static void draw_surroundings(struct scene *s)
{
    const double L = s->side;

    switch (s->around)
    {
    case PERIODIC:
        say(s, "domain { min (0 0 0); max (%.9g %.9g %.9g); periodic (x y z); }\n", L, L, L);
        break;
    case BOX:
        say(s, "walls { box { type box; material a; min (0 0 0); max (%.9g %.9g %.9g); } }\n", L, L,
            L);
        break;
    case FLOOR:
        say(s,
            "domain { x (0 %.9g); y (0 %.9g); periodic (x y); }\nwalls { floor { type plane; material b; point (0 0 0); normal (0 0 1); surfaceVelocity (%.3g 0 0); } }\n",
            L, L, between(s, -1.0, 1.0));
        break;
    case TUBE:
        say(s,
            "walls { tube { type cylinder; material a; point (%.9g %.9g 0); axis (0 0 1); radius %.9g; particles inside; motion { type rotation; origin (%.9g %.9g 0);"
            " axis (0 0 1); omega %.3g; } } lid { type plane; material a; point (0 0 0); normal (0 0 1); } }\n",
            0.5*L, 0.5*L, 0.75*L, 0.5*L, 0.5*L, between(s, -30.0, 30.0));
        break;
    case FACETS:
        say(s,
            "walls { roof { type triangles; material b; corners ((%.9g %.9g 0) (%.9g %.9g 0) (%.9g %.9g 0)  (%.9g %.9g 0) (%.9g %.9g 0) (%.9g %.9g 0)); } }\n",
            -L, -L, 2.0*L, -L, 2.0*L, 2.0*L, -L, -L, 2.0*L, 2.0*L, -L, 2.0*L);
        break;
    case SHAKER:
        say(s,
            "walls { floor { type plane; material a; point (0 0 %.9g); normal (0 0 1); motion { type oscillation; amplitude (0 %.3g %.3g); frequency %.4g; } } }\n",
            -2e-4, between(s, 0.0, 1e-4), between(s, 0.0, 2e-4), between(s, 10.0, 300.0));
        break;
    default:
        break;
    }
}

static void draw_particles(struct scene *s, double d)
{
    const int groups = 2 + one_of(s, 3);

    say(s, "insert\n{\n");
    for (int k = 0; k < groups; k++)
    {
        const double least = d*between(s, 0.3, k == 0 ? 0.9 : 0.95), fast = between(s, 0.0, 0.8);

        say(s,
            "    g%d { type random; material %s; count %d; seed %d; min (0 0 0); max (%.9g %.9g %.9g); ",
            k, one_of(s, 2) ? "a" : "b", 3 + one_of(s, 15), k + 1, s->side, s->side, s->side);
        say(s, one_of(s, 2) ? "diameter %.6g; " : "sizes { type uniform; min %.6g; max %.6g; } ",
            least, d);
        say(s, "velocity (%.4g %.4g %.4g); spin (%.4g %.4g %.4g); }\n",
            fast*between(s, -1.0, 1.0), fast*between(s, -1.0, 1.0),
            fast*between(s, -1.0, 1.0), between(s, -300.0, 300.0), between(s, -300.0, 300.0),
            between(s, -300.0, 300.0));
    }
    say(s, "}\n");
}

static void draw(struct scene *s, uint64_t seed)
{
    memset(s, 0, sizeof *s);
    s->seed = seed;
    const double d = between(s, 0.5e-3, 2e-3);

    s->side = d*between(s, 4.6, 8.0);
    s->around = (enum surroundings)one_of(s, SURROUNDINGS);
    say(s,
        "// seed %llu\nmaterials { a { density %.4g; youngsModulus %.4g; poissonsRatio %.3g; } b { density %.4g; youngsModulus %.4g; } }\n",
        (unsigned long long)seed, between(s, 800.0, 8000.0), pow(10.0, between(s, 6.3, 8.0)),
        between(s, 0.0, 0.49), between(s, 800.0, 8000.0), pow(10.0, between(s, 6.3, 8.0)));
    say(s, "effects\n{\n");
    s->gravity = one_of(s, 2);
    if (s->gravity)
    {
        say(s, "    gravity { acceleration (1 -2 -9.81); }\n");
    }
    draw_contacts(s);
    draw_fluid(s);
    draw_surroundings(s);
    draw_particles(s, d);
}

/* ---- running --------------------------------------------------------------------------------- */

static int make(struct dem **d, const struct scene *s, MPI_Comm comm, const char *from)
{
    int status = dem_create(d, comm);

    status = status ? status : dem_scene_text(*d, s->text, "scene");
    status = status ? status : comm == MPI_COMM_NULL && !from ? dem_energy_enable(*d) : 0;
    status = status ? status : from ? dem_load(*d, from) : 0;
    return status ? status : dem_setup(*d);
}

struct sums                                               /* of everybody: kg m/s, kg m2/s; and of their sizes */
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

/* Nothing outside acts on an open or periodic crowd without a fluid but gravity: M g t. */
static void judge_motion(const struct scene *s, const struct sums *now, const struct sums *then,
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

static int begins(const char *name, const char *word)
{
    return strncmp(name, word, strlen(word)) == 0;
}

/* Springs of friction may be cut to hold more than slip has put in (the dashpot's share, docs/energy-balance.md): they give it to heat,
   and here what they hold counts for nothing. */
static int counts(const char *name)
{
    return begins(name, "kinetic") || begins(name, "gravity") ||
           (begins(name, "elastic") && !strstr(name, "mindlin") && !strstr(name, "linear") &&
            !strstr(name, "ingSpring"));
}

/* The residual, and motion and what contacts hold less what walls and fluid put in and what there was, over what there is: motion at the
   start, or the work of gravity, walls and fluid. */
static int judge_energy(struct dem *d, double start, struct result *r)
{
    const struct dem_energy_item *item;
    double since, scale = start, held = 0.0;
    int n, status = dem_energy(d, &since, &n, &item);

    for (int k = 0; !status && k < n; k++)
    {
        const int gives = begins(item[k].name, "gravity") || begins(item[k].name, "work") ||
                          begins(item[k].name, "kinetic");

        scale = most(scale, gives ? fabs(item[k].value) : 0.0);
        held += counts(item[k].name) ? item[k].value
                : begins(item[k].name, "work") ? -item[k].value
                                               : 0.0;
    }
    if (!status && scale > 0.0)
    {
        r->worst[CREATED] = most(r->worst[CREATED], item[n - 1].value/scale);
        r->worst[ABOVE] = most(r->worst[ABOVE], (held - start)/scale);
    }
    return status;
}

/* Alone: to the half, saved, to the end; then from the half to the end again. */
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
        status = status ? status : judge_energy(d, start, r);
        status = status || k ? status : dem_save(d, file);
        const struct sums now = sums_of(d);
        r->failed |= !now.finite;
        judge_motion(s, &now, &then, half*(k + 1), r);
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

static void complain(uint64_t seed, const char *what, double value)
{
    printf("# seed %llu: %s %.3g %s\n", (unsigned long long)seed, what, value, dem_error_text());
    fflush(stdout);
}

int main(int argc, char **argv)
{
    /* round-off of sums; of the energy, the largest that dashpots, jumps and bonds leave at the longest step: README.md */
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
            complain(first + k, r[k].failed ? "fails:" : "another end after a restart", 0.0);
            bad++;
        }
        for (int j = 0; j < KINDS; j++)
        {
            worst[j] = most(worst[j], r[k].worst[j]);
            if (!(r[k].worst[j] <= limit[j]))
            {
                complain(first + k, kinds[j], r[k].worst[j]);
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
            complain(first + k, "others on several ranks,", status);
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
