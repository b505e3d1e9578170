/*
 * test_pair.c -- two spheres that collide, step by step as in LIGGGHTS.
 *
 * Head-on and oblique impacts, with spin, with hertz, hooke and hookeHysteresis and their friction.
 * The remaining difference is of first order in the step and halves with it; where definitions
 * differ, the difference is bounded and printed.
 *
 * Reads the dumps that run made in the folder of the first argument: one a case, NAME.dump.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

static const struct dem_new_particle head_on[2] = {
    {.position = {0, 0, 1.0e-3},
     .velocity = {0, 0, -0.4},
     .diameter = 2e-3,
     .id = 1,
     .material = "glass"},
    {.position = {0, 0, -0.705e-3},
     .velocity = {0, 0, 0.6},
     .diameter = 1.4e-3,
     .id = 2,
     .material = "glass"},
};
/* in a plane: no spin about the normal */
static const struct dem_new_particle oblique[2] = {
    {.position = {0.2e-3, 0, 1.02e-3},
     .velocity = {0.2, 0, -0.4},
     .spin = {0, -50, 0},
     .diameter = 2e-3,
     .id = 1,
     .material = "glass"},
    {.position = {-0.1e-3, 0, -0.66e-3},
     .velocity = {-0.1, 0, 0.5},
     .spin = {0, 200, 0},
     .diameter = 1.4e-3,
     .id = 2,
     .material = "glass"},
};
static const struct dem_new_particle twisted[2] = {
    {.position = {0.2e-3, -0.1e-3, 1.0e-3},
     .velocity = {0.2, 0.1, -0.4},
     .spin = {100, -50, 30},
     .diameter = 2e-3,
     .id = 1,
     .material = "glass"},
    {.position = {-0.1e-3, 0.2e-3, -0.66e-3},
     .velocity = {-0.1, 0.05, 0.5},
     .spin = {-80, 200, -40},
     .diameter = 1.4e-3,
     .id = 2,
     .material = "glass"},
};

static const struct
{
    const char *name, *laws;
    const struct dem_new_particle *seed;
    /* m/s, of velocities, and of spins times the smaller radius */
    double within;
    int first_order;                                      /* half the step halves it */
    const char *why;
} cases[] = {
    /* the same formulas in the same order of integration: rounding of 1600 steps remains */
    {"hertz-head-on", "hertz { } dry { restitution 0.8; } mindlin { friction 0.3; }", head_on,
     1e-12, 0, "rounding"},
    {"hooke-head-on", "hooke { } dry { restitution 0.8; } linear { friction 0.3; }", head_on, 1e-12,
     0, "rounding"},
    {"hysteresis-head-on",
     "hookeHysteresis { unloading 5; adhesion 0.2; } linear { friction 0.3; }", head_on, 1e-12, 0,
     "rounding"},

    /* friction springs without dashpots: the codes rotate and load them in a different order within
       a step, in which the pair rotates by 1e-3 and the spring is loaded by 1/400: some 1e-5, and
       half of it with half the step */
    {"hertz-oblique",
     "hertz { } dry { restitution 0.8; attraction clamped; } mindlin { friction 0.3; "
     "tangentialDamping no; }",
     oblique, 5e-5, 1, "order of a step"},
    {"hooke-oblique",
     "hooke { } dry { restitution 0.8; attraction clamped; } linear { friction 0.3; "
     "tangentialDamping no; }",
     oblique, 5e-5, 1, "order of a step"},
    {"hysteresis-oblique",
     "hookeHysteresis { unloading 5; adhesion 0; } linear { friction 0.3; ratio 1; "
     "tangentialDamping no; }",
     oblique, 5e-5, 1, "order of a step"},

    /* where definitions differ, the difference is printed and bounded. In Suna springs rotate about
       the normal with the mean spin of the pair, in LIGGGHTS they do not: 16 1/s for 2e-4 s, an
       angle of 3e-3, by which the direction of up to 0.1 m/s from friction differs */
    {"hertz-twisted",
     "hertz { } dry { restitution 0.8; attraction clamped; } mindlin { friction 0.3; "
     "tangentialDamping no; }",
     twisted, 5e-4, 0, "springs rotate about the normal"},
    {"hooke-twisted",
     "hooke { } dry { restitution 0.8; attraction clamped; } linear { friction 0.3; "
     "tangentialDamping no; }",
     twisted, 5e-4, 0, "springs rotate about the normal"},
    {"hysteresis-twisted",
     "hookeHysteresis { unloading 5; adhesion 0; } linear { friction 0.3; ratio 1; "
     "tangentialDamping no; }",
     twisted, 5e-4, 0, "springs rotate about the normal"},
    /* the friction limit of an adhesive contact is mu |F_n| in LIGGGHTS and mu (F_n + k_c d) in
       Suna: they differ by up to a fifth of the normal force in unloading */
    {"hysteresis-twisted-sticky",
     "hookeHysteresis { unloading 5; adhesion 0.2; } linear { friction 0.3; ratio 1; "
     "tangentialDamping no; }",
     twisted, 0.1, 0, "friction where it sticks"},
    /* in LIGGGHTS the friction dashpot has sqrt(4 G* / E*) = 0.91 of the coefficient in Suna, and
       acts while the contact attracts */
    {"hertz-twisted-damped", "hertz { } dry { restitution 0.8; } mindlin { friction 0.3; }",
     twisted, 0.03, 0, "coefficient of friction's dashpot"},
    /* in LIGGGHTS it is added in full while the spring alone sticks, in Suna spring and dashpot
       together obey mu F_n; on a linear spring it is largest at first contact, at zero normal
       force. With a friction of 100 in both codes 0.005 m/s remain of 0.18 */
    {"hooke-twisted-damped", "hooke { } dry { restitution 0.8; } linear { friction 0.3; }", twisted,
     0.3, 0, "friction's dashpot past the limit"},
};

/* the next two rows of a dump: id, position, velocity, spin; 0 at its end */
static int next(FILE *f, double row[2][10])
{
    char line[1024];
    int n = 0;

    while (n < 2 && fgets(line, sizeof line, f))
    {
        double *const r = row[n];

        n += sscanf(line, "%lf %lf %lf %lf %lf %lf %lf %lf %lf %lf", r, r + 1, r + 2, r + 3, r + 4,
                    r + 5, r + 6, r + 7, r + 8, r + 9) == 10;
    }
    return n == 2;
}

static double difference_of(const double *a, const double *b)
{
    return sqrt((a[0] - b[0])*(a[0] - b[0]) + (a[1] - b[1])*(a[1] - b[1]) +
                (a[2] - b[2])*(a[2] - b[2]));
}

/* largest distance over all rows [m/s], with `halves` halvings of the step; negative: no dump */
static double distance(const char *folder, size_t k, int halves, double *place, double *changed)
{
    char *const name = world_text("%s/%s%s.dump", folder, cases[k].name, halves ? "-half" : "");
    char *const scene =
        world_text("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } }"
                   "effects { %s } time { step %.17g; maxOverlap 0.5; }",
                   cases[k].laws, halves ? 2.5e-7 : 5e-7);
    FILE *const f = fopen(name, "r");
    double row[2][10], worst = 0.0;
    int rows = 0;

    *place = *changed = 0.0;
    if (!f)
    {
        return -1.0;
    }
    struct dem *const d = world(scene, 2, cases[k].seed);

    for (; next(f, row); rows++)
    {
        for (int step = 0; rows > 0 && step < (halves ? 20 : 10); step++)
        {
            world_step(d);
        }
        for (int i = 0; i < 2; i++)
        {
            const struct world_particle p = world_at(d, i + 1);

            *place = fmax(*place, difference_of(p.x, row[i] + 1)/7e-4);
            *changed = fmax(*changed, difference_of(p.v, cases[k].seed[i].velocity));
            worst = fmax(
                worst, fmax(difference_of(p.v, row[i] + 4), difference_of(p.w, row[i] + 7)*7e-4));
        }
    }
    fclose(f);
    dem_free(d);
    return rows == 161 ? worst : -1.0;
}

static void compare(const char *folder, size_t k)
{
    const char *const name = cases[k].name;
    double place, changed, again[2];
    const double worst = distance(folder, k, 0, &place, &changed),
                 half = distance(folder, k, 1, &again[0], &again[1]);

    if (!TAP_OK(worst >= 0.0 && half >= 0.0, "%s: the dumps have 161 states each", name))
    {
        return;
    }
    TAP_OK(changed > 0.3, "%s: they collide, a velocity changes by %.3f m/s", name, changed);
    TAP_NEAR(worst, 0.0, cases[k].within, "%s: difference %.2g m/s, %.2g of a radius: %s", name,
             worst, place, cases[k].why);
    if (cases[k].first_order)
    {
        TAP_NEAR(worst/half, 2.0, 0.2, "%s: half the step leaves 1/%.2f of the error", name,
                 worst/half);       /* terms of order 2: 5 % */
    }
    else if (cases[k].within > 1e-6)
    {
        TAP_OK(half > 0.5*worst,
               "%s: with half the step still %.2g m/s: due to the law, not the step", name, half);
    }
}

int main(int count, char **argument)
{
    if (count < 2)
    {
        printf("1..0 # SKIP give the folder with the dumps\n");
        return 0;
    }
    TAP_TRAPS;
    for (size_t k = 0; k < sizeof cases/sizeof *cases; k++)
    {
        compare(argument[1], k);
    }
    TAP_DONE;
}
