/*
 * test_symmetry.c -- every contact law, and every combination of normal law, damping and friction,
 * is invariant under rotation, reflection, swapped ids and Galilean transformation, and keeps
 * momentum and angular momentum. A new law needs settings here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "core/random.h"
#include "laws/effects.h"

enum
{
    SIDE = 3, PAIRS = SIDE*SIDE*SIDE, N = 2*PAIRS
};

static const double time_step = 1e-6, duration = 8e-4;

/* ---- laws ------------------------------------------------------------------------------------ */

/* settings under which the law changes an impact of spheres of 1 mm and 10 MPa at 0.5 m/s */
static const char *const settings[][2] = {
    {"hertz", ""},
    {"hooke", "stiffness 1000;"},
    {"hookeHysteresis", "stiffness 1000; unloading 4; adhesion 0.3; plasticDepth 0.02;"},
    {"dry", "restitution 0.7;"},
    {"viscous", "coefficient 0.01;"},
    {"stokesDamping", "restitution 0.97; viscosity 0.01;"},
    {"mindlin", "friction 0.3;"},
    {"mindlinIncremental", "friction 0.3;"},
    {"linear", "friction 0.3;"},
    {"rollingConstant", "friction 0.2;"},
    {"rollingSpring", "friction 0.2; damping 0.3;"},
    {"rollingViscous", "time 1e-3;"},
    {"twistingSpring", "friction 0.3; lever reduced; damping 0.2;"},
    {"sjkr", "energyDensity 3e5;"},
    {"jkr", "workOfAdhesion 1;"},
    {"liquidBridge", "surfaceTension 0.5; viscosity 0.02; roughness 1e-6;"},
    {"lubrication", "viscosity 0.02; roughness 1e-6; cutOff 1e-4;"},
    {"bondLinear",
     "normalStiffness 3e8; shearStiffness 1e8; make always; makeDistance 1.005; breakDistance 1.05;"
     " shearStrength 2e4; dampingRatio 0.1; walls yes;"},
};

static const char *settings_of(const char *word)
{
    for (size_t k = 0; k < sizeof settings/sizeof *settings; k++)
    {
        if (strcmp(settings[k][0], word) == 0)
        {
            return settings[k][1];
        }
    }
    return NULL;
}

/* ---- frames ---------------------------------------------------------------------------------- */

struct frame
{
    const char *what;
    /* orthogonal matrix; its determinant, by which spins are multiplied, too */
    double turn[3][3], mirror;
    double speed[3];                                      /* m/s, added to all */
    int swapped;                                          /* ids in reverse order */
};

static struct frame straight = {"as it is", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1.0, {0, 0, 0}, 0};

static void turned(const double *A, const double v[3], double factor, double out[3])
{
    for (int k = 0; k < 3; k++)
    {
        out[k] = factor*(A[3*k]*v[0] + A[3*k + 1]*v[1] + A[3*k + 2]*v[2]);
    }
}

/* a rotation matrix from a random unit quaternion */
static void random_turn(struct frame *f, uint64_t seed)
{
    double q[4], size = 0.0;

    for (int k = 0; k < 4; k++)
    {
        q[k] = 2.0*dem_random_unit(seed, 0, 0, (uint64_t)k) - 1.0;
        size += q[k]*q[k];
    }
    for (int k = 0; k < 4; k++)
    {
        q[k] /= sqrt(size);
    }
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double turn[3][3] = {{1 - 2*(y*y + z*z), 2*(x*y - z*w), 2*(x*z + y*w)},
                               {2*(x*y + z*w), 1 - 2*(x*x + z*z), 2*(y*z - x*w)},
                               {2*(x*z - y*w), 2*(y*z + x*w), 1 - 2*(x*x + y*y)}};

    memcpy(f->turn, turn, sizeof turn);
    for (int k = 0; k < 3; k++)
    {
        for (int l = 0; l < 3; l++)
        {
            /* a rotated point reflection is a mirror */
            f->turn[k][l] *= f->mirror;
        }
    }
}

/* ---- scenes ---------------------------------------------------------------------------------- */

static double drawn(int k, int use)
{
    return 2.0*dem_random_unit(11, (uint64_t)k, 0, (uint64_t)use) - 1.0;
}

/* particles 2 p and 2 p + 1 fly at each other, pairs 1 cm apart; on a wall all fly down, from above
   z = 0 */
static void place(struct dem_new_particle seed[N], int wall)
{
    memset(seed, 0, N*sizeof *seed);
    for (int i = 0; i < N; i++)
    {
        const int p = i/2, at[3] = {p%SIDE, p/SIDE%SIDE, p/(SIDE*SIDE)};
        const double size =
            sqrt(drawn(p, 0)*drawn(p, 0) + drawn(p, 1)*drawn(p, 1) + drawn(p, 2)*drawn(p, 2));
        const double radius[2] = {1e-3*(0.8 + 0.2*drawn(2*p, 3)),
                                  1e-3*(0.8 + 0.2*drawn(2*p + 1, 3))};
        const double sign = i % 2 ? 1.0 : -1.0,
                     apart = 0.5*(radius[0] + radius[1]) + 1e-6*(5.0 + drawn(p, 12));

        seed[i] = (struct dem_new_particle){
            .diameter = 2.0*radius[i%2], .id = i, .material = i%2 ? "clay" : "glass"};
        for (int k = 0; k < 3; k++)
        {
            const double along = drawn(p, k)/size;

            seed[i].position[k] = 0.01*(at[k] - 1) + sign*apart*along;
            seed[i].velocity[k] = -sign*(0.2 + 0.05*drawn(p, 4))*along + 0.1*drawn(i, 5 + k);
            seed[i].spin[k] = 300.0*drawn(i, 8 + k);
        }
        if (wall)
        {
            seed[i].position[0] = 0.004*(i%8 - 4), seed[i].position[1] = 0.004*(i/8 - 4);
            seed[i].position[2] =
                radius[i%2] +
                1e-5*(2.0 + drawn(i, 11));   /* no two touch it at the same phase of a step */
            seed[i].velocity[2] = -0.4;
        }
    }
}

static struct dem *start(const char *laws, int wall, const struct frame *f,
                         struct world_particle *before)
{
    const double up[3] = {0.0, 0.0, 1.0};
    double normal[3];
    struct dem_new_particle seed[N], given[N];
    char floor[256] = "";

    place(seed, wall);
    turned(f->turn[0], up, 1.0, normal);
    if (wall)
    {
        snprintf(
            floor, sizeof floor,
            "walls { floor { type plane; material clay; point (0 0 0); "
            "normal (%.17g %.17g %.17g); } }",
            normal[0], normal[1], normal[2]);
    }
    for (int i = 0; i < N; i++)
    {
        struct dem_new_particle *const s = &given[f->swapped ? N - 1 - i : i];

        *s = seed[i];
        s->id = f->swapped ? N - 1 - i : i;
        turned(f->turn[0], seed[i].position, 1.0, s->position);
        turned(f->turn[0], seed[i].velocity, 1.0, s->velocity);
        turned(f->turn[0], seed[i].spin, f->mirror, s->spin);
        for (int k = 0; k < 3; k++)
        {
            s->velocity[k] += f->speed[k];
        }
    }
    struct dem *const d = world(world_text(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.2; }"
        " clay { density 1500; youngsModulus 6e6; poissonsRatio 0.35; } }"
        "effects { %s } %s time { step %.17g; maxOverlap 0.3; }",
        laws, floor, time_step), N, given);
    const int wet = dem_scalar_index(d, "liquidVolume");

    for (int i = 0; wet >= 0 && i < N; i++)
    {
        dem_scalar(d, wet)[i] = 1e-11;      /* m3, 2 % of a sphere of 1 mm */
    }
    world_all(d, before);
    return d;
}

/* particle i, transformed back to the first frame */
static struct world_particle back(const struct world_particle *all, int i, const struct frame *f,
                                  double time)
{
    struct world_particle p = all[f->swapped ? N - 1 - i : i];
    double inverse[3][3], x[3], v[3];

    for (int k = 0; k < 3; k++)
    {
        x[k] = p.x[k] - time*f->speed[k];
        v[k] = p.v[k] - f->speed[k];
        for (int l = 0; l < 3; l++)
        {
            inverse[k][l] = f->turn[l][k];
        }
    }
    const double w[3] = {p.w[0], p.w[1], p.w[2]};

    turned(inverse[0], x, 1.0, p.x);
    turned(inverse[0], v, 1.0, p.v);
    turned(inverse[0], w, f->mirror, p.w);
    return p;
}

/* ---- conditions ------------------------------------------------------------------------------ */

/* largest difference, scaled by 1 mm, 1 m/s and 1000 1/s, typical of the impacts */
static double difference(const struct world_particle *a, const struct world_particle *b)
{
    double worst = 0.0;

    for (int k = 0; k < 3; k++)
    {
        worst = fmax(worst, fabs(a->x[k] - b->x[k])/1e-3);
        worst = fmax(worst, fmax(fabs(a->v[k] - b->v[k])/1.0, fabs(a->w[k] - b->w[k])/1000.0));
    }
    return worst;
}

/* of a pair, angular momentum about the origin; scales: sums of sizes */
struct totals
{
    double p[3], L[3], p_scale, L_scale, kinetic;
};

static struct totals totals_of(const struct world_particle *pair)
{
    struct totals s = {.kinetic = 0.0};

    for (int i = 0; i < 2; i++)
    {
        const struct world_particle *const q = pair + i;
        const double inertia = 0.4*q->mass*q->radius*q->radius;

        for (int a = 0; a < 3; a++)
        {
            const int b = (a + 1)%3, c = (a + 2)%3;

            s.p[a] += q->mass*q->v[a];
            s.L[a] += q->mass*(q->x[b]*q->v[c] - q->x[c]*q->v[b]) + inertia*q->w[a];
            s.p_scale += fabs(q->mass*q->v[a]);
            s.L_scale += fabs(q->mass*q->x[b]*q->v[c]) + fabs(q->mass*q->x[c]*q->v[b]) +
                         fabs(inertia*q->w[a]);
            s.kinetic += 0.5*q->mass*q->v[a]*q->v[a] + 0.5*inertia*q->w[a]*q->w[a];
        }
    }
    return s;
}

static void conserves(const char *laws, const struct world_particle *before,
                  const struct world_particle *after)
{
    double p = 0.0, L = 0.0, gain = -1.0, loss = 0.0;

    for (int k = 0; k < PAIRS; k++)
    {
        const struct totals a = totals_of(before + 2*k), b = totals_of(after + 2*k);

        for (int i = 0; i < 3; i++)
        {
            p = fmax(p, fabs(b.p[i] - a.p[i])/a.p_scale);
            L = fmax(L, fabs(b.L[i] - a.L[i])/a.L_scale);
        }
        gain = fmax(gain, b.kinetic/a.kinetic - 1.0);
        loss = fmax(loss, 1.0 - b.kinetic/a.kinetic);
    }
    /* rounding of 800 steps */
    TAP_NEAR(p, 0.0, 1e-12, "%s: momentum", laws);
    TAP_NEAR(L, 0.0, 1e-12, "%s: angular momentum", laws);
    /* without damping the speed after an impact has an error of 1e-4 at t_c/200, its energy of
       twice that; the secant spring of mindlin returns more than it stored, see mindlin.c: 1 % on
       linear springs, some 0.1 % with hertz */
    const int secant = strstr(laws, "no damping, mindlin") && !strstr(laws, "Incremental");

    TAP_OK(gain < (secant ? 1e-2 : 3e-4), "%s: no pair gains energy, %.2g at most", laws, gain);
    TAP_OK(loss > 0.0, "%s: some lose energy, %.2g at most", laws, loss);
}

static int compare(const struct world_particle *plain, const struct world_particle *other,
                   const struct frame *f, double *worst)
{
    int same = 0;

    *worst = 0.0;
    for (int i = 0; i < N; i++)
    {
        const struct world_particle p = back(other, i, f, duration);

        *worst = fmax(*worst, difference(&plain[i], &p));
        same +=
            memcmp(plain[i].v, p.v, sizeof p.v) == 0 && memcmp(plain[i].w, p.w, sizeof p.w) == 0;
    }
    return same;
}

static struct frame frames[5];

static void run(const char *laws, int wall, const struct frame *f, struct world_particle *before,
                struct world_particle *after)
{
    struct dem *const d = start(laws, wall, f, before);

    world_run(d, duration);
    world_all(d, after);
    dem_free(d);
}

/* laws: text of the scene; name: for the claim; plain: final state in the first frame */
static void symmetric(const char *name, const char *laws, int wall, struct world_particle *plain)
{
    static struct world_particle before[N], other[N], unused[N];
    double worst;

    run(laws, wall, &straight, before, plain);
    if (!wall)
    {
        conserves(name, before, plain);
    }
    for (int k = 0; k < 5; k++)
    {
        if (wall && frames[k].speed[0] != 0.0)
        {
            continue;                                     /* the wall rests */
        }
        run(laws, wall, &frames[k], unused, other);
        const int same = compare(plain, other, &frames[k], &worst);

        /* rounding: 1e-18 m of an overlap of 1e-5 m, in all steps */
        TAP_NEAR(worst, 0.0, 1e-10, "%s%s: the same %s", name, wall ? " at a wall" : "",
                 frames[k].what);
        if (frames[k].swapped && frames[k].turn[0][0] == 1.0)
        {
            TAP_OK(same == N, "%s%s: to the last bit", name, wall ? " at a wall" : "");
        }
    }
}

/* ---- all laws -------------------------------------------------------------------------------- */

static const struct dem_effect *of_stage(enum dem_stage stage, int k)
{
    for (const struct dem_effect *const *e = dem_effects; *e; e++)
    {
        if ((*e)->stage == stage && k-- == 0)
        {
            return *e;
        }
    }
    return NULL;
}

/* append an effect with its settings to the text of the scene */
static void add(char *text, size_t size, const struct dem_effect *e)
{
    const size_t at = strlen(text);

    snprintf(text + at, size - at, "%s { %s } ", e->name, settings_of(e->name));
}

static void has_effect(const char *name, const struct world_particle *with,
                 const struct world_particle *without)
{
    int changed = 0;

    for (int i = 0; i < N; i++)
    {
        changed += difference(&with[i], &without[i]) > 1e-4;
    }
    TAP_OK(changed > N/2, "%s changes the motion of %d of %d", name, changed, N);
}

/* every normal law with every damping law, or none, and every friction law */
static void combinations(void)
{
    static struct world_particle plain[N], without[N];
    const struct dem_effect *normal, *damp, *friction;

    for (int n = 0; (normal = of_stage(DEM_STAGE_NORMAL, n)); n++)
    {
        for (int t = 0; (friction = of_stage(DEM_STAGE_TANGENT, t)); t++)
        {
            for (int c = -1; c < 0 || of_stage(DEM_STAGE_DAMP, c); c++)
            {
                char name[128], laws[1024] = "";

                damp = c < 0 ? NULL : of_stage(DEM_STAGE_DAMP, c);
                snprintf(name, sizeof name, "%s, %s, %s", normal->name,
                         damp ? damp->name : "no damping", friction->name);
                add(laws, sizeof laws, normal);
                if (damp)
                {
                    add(laws, sizeof laws, damp);
                }
                add(laws, sizeof laws, friction);
                symmetric(name, laws, 0, plain);
                if (damp)
                {
                    has_effect(damp->name, plain, without);
                }
                else
                {
                    memcpy(without, plain, sizeof plain);
                }
            }
        }
    }
}

/* every other contact law with hertz, dry, mindlin; on a wall, too */
static void one_by_one(void)
{
    static struct world_particle plain[N], base[2][N], before[N];
    const char *const basis = "hertz { } dry { restitution 0.7; } mindlin { friction 0.3; } ";

    run(basis, 0, &straight, before, base[0]);
    run(basis, 1, &straight, before, base[1]);
    for (const struct dem_effect *const *e = dem_effects; *e; e++)
    {
        char laws[1024] = "";

        /* effects of scalars do not move particles */
        if ((*e)->stage >= DEM_STAGE_SCALAR ||
            !TAP_OK(settings_of((*e)->name), "%s has settings here", (*e)->name))
        {
            continue;
        }
        if ((*e)->stage == DEM_STAGE_NORMAL || (*e)->stage == DEM_STAGE_DAMP ||
            (*e)->stage == DEM_STAGE_TANGENT)
        {
            /* in place of the one of its stage */
            snprintf(laws, sizeof laws, "%s %s %s ",
                     (*e)->stage == DEM_STAGE_NORMAL ? "" : "hertz { }",
                     (*e)->stage == DEM_STAGE_DAMP ? "" : "dry { restitution 0.65; }",
                     (*e)->stage == DEM_STAGE_TANGENT ? "" : "mindlin { friction 0.25; }");
        }
        else
        {
            snprintf(laws, sizeof laws, "%s", basis);
        }
        add(laws, sizeof laws, *e);
        for (int wall = 0; wall < 2; wall++)
        {
            symmetric((*e)->name, laws, wall, plain);
            if ((*e)->stage >= DEM_STAGE_MOMENT)
            {
                has_effect((*e)->name, plain, base[wall]);
            }
        }
    }
}

int main(void)
{
    static const char *const what[5] = {"in randomly rotated axes", "in a second rotation", "in a mirror",
                                        "with swapped ids", "in a moving frame"};

    TAP_TRAPS;
    for (int k = 0; k < 5; k++)
    {
        frames[k] = straight;
        frames[k].what = what[k];
        frames[k].mirror = k == 2 ? -1.0 : 1.0;
        frames[k].swapped = k == 1 || k == 3;
        if (k < 3)
        {
            random_turn(&frames[k], 20 + (uint64_t)k);
        }
    }
    frames[1].what = "in a second rotation, with swapped ids";
    frames[4].speed[0] = 0.7, frames[4].speed[1] = -0.4, frames[4].speed[2] = 0.3;
    combinations();
    one_by_one();
    TAP_DONE;
}
