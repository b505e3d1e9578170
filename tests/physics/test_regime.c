/*
 * test_regime.c -- verdicts of `dem plan` for scenes in regimes known from the literature.
 *
 * For each effect the plan reports its number and whether it is needed, negligible or missing:
 * Gondret's balls in oil, glass in water, bubbles, dust, powders of Geldart's groups A to
 * C, the beds of Mueller and Goldschmidt, grains in a pipe, a suspension, a drum, a hopper,
 * tablets, and yielding steel (Johnson). Other effects are not reported. A negligible effect is
 * reported with its cost.
 *
 * Tolerance: 1 % of the formulas in advisor/verdicts.c, evaluated in another program.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"
#include "advisor/regime.h"
#include <math.h>

struct claim
{
    const char *effect;
    enum dem_verdict_word word;
    double share;                                         /* 1; negative: any */
};

struct known
{
    const char *name, *material, *fluid, *effects;
    double diameter;                                      /* m */
    int count;                                            /* in a closed box of 20 diameters */
    struct claim verdicts[8];                                 /* all verdicts */
    const char *lines[3];
};

#define AIR "density 1.2; viscosity 1.8e-5;"
#define WATER "density 1000; viscosity 1e-3;"
#define OIL "density 935; viscosity 0.01;"

static const struct known scenes[] = {
    /* Gondret, Lance, Petit 2002: oil reduces the rebound; buoyancy and added mass act on a falling
       ball */
    {"steel in oil (Gondret)", "density 7800;", OIL,
     "hertz { impactSpeed 0.5; } dry { restitution 0.97; } pressureGradient {} schillerNaumann {}",
     3e-3, 2,
     {{"schillerNaumann", DEM_NEEDED, 0.7158},
      {"pressureGradient", DEM_NEEDED, 0.11987},
      {"virtualMass", DEM_MISSING, 0.059936},
      {"stokesDamping", DEM_MISSING, 0.119271}}, {NULL}},
    {"the same with the film", "density 7800;", OIL,
     "hertz { impactSpeed 0.5; } stokesDamping { restitution 0.97; } "
     "pressureGradient {} schillerNaumann {} "
     "virtualMass {}", 3e-3, 2,
     {{"schillerNaumann", DEM_NEEDED, 0.7158},
      {"pressureGradient", DEM_NEEDED, 0.11987},
      {"virtualMass", DEM_NEEDED, 0.059936},
      {"stokesDamping", DEM_NEEDED, 0.119271}}, {NULL}},
    {"glass in water", "density 2500;", WATER,
     "hertz {} dry { restitution 0.9; } wenYu {}", 1e-3, 20,
     {{"wenYu", DEM_NEEDED, 13.4557},
      {"pressureGradient", DEM_MISSING, 0.4},
      {"virtualMass", DEM_MISSING, 0.2},
      {"stokesDamping", DEM_MISSING, 0.0511461}}, {NULL}},
    /* Mueller et al. 2008 */
    {"poppy seeds in air (Mueller)", "density 1000;", AIR,
     "hertz {} dry { restitution 0.66; } gidaspow {} virtualMass {}",
     1.2e-3, 100,
     /* its own law: Wen and Yu at void fraction 0.993455 */
     {{"gidaspow", DEM_NEEDED, 0.094072}, {"virtualMass", DEM_NEGLIGIBLE, 6e-4}}, {NULL}},
    {"bubbles", "density 1.2;", WATER,
     "hertz {} schillerNaumann {} pressureGradient {} virtualMass {}", 1e-3, 2,
     {{"schillerNaumann", DEM_NEEDED, -1.0},
      {"pressureGradient", DEM_NEEDED, 833.33},
      {"virtualMass", DEM_NEEDED, 416.67},
      {"stokesDamping", DEM_MISSING, 0.269656}}, {NULL}},
    {"dust of 10 um in air", "density 2500;", AIR,
     "hertz {} stokesDrag {}", 1e-5, 2,
     {{"stokesDrag", DEM_NEEDED, -1.0},
      {"stokesDamping", DEM_MISSING, -1.0},
      {"jkr", DEM_MISSING, 1834.86}},
     {"density ratio 2083", "dilute, fluid forces dominate"}},
    {"sand in air with Stokes' law", "density 2650;", AIR,
     "hertz {} stokesDrag {}", 5e-4, 2,
     {{"stokesDrag", DEM_NEEDED, -1.0}, {"schillerNaumann", DEM_MISSING, 13.0917}},
     {"Reynolds number 669"}},
    {"a suspension by a single sphere's law", "density 1050;", WATER,
     "hertz {} schillerNaumann {}", 1e-3, 3000,
     {{"schillerNaumann", DEM_NEEDED, -1.0},
      {"wenYu", DEM_MISSING, 1.22078},
      {"pressureGradient", DEM_MISSING, 0.95238},
      {"virtualMass", DEM_MISSING, 0.47619},
      {"stokesDamping", DEM_MISSING, -1.0}},
     {"solid fraction of the domain 0.196"}},
    {"a dilute suspension", "density 1050;", WATER,
     "hertz {} schillerNaumann {}", 1e-3, 10,
     {{"schillerNaumann", DEM_NEEDED, -1.0},
      {"pressureGradient", DEM_MISSING, 0.95238},
      {"virtualMass", DEM_MISSING, 0.47619},
      {"stokesDamping", DEM_MISSING, -1.0}}, {NULL}},
    {"powder of 10 um (group C)", "density 2500;", NULL,
     "hertz {} jkr { workOfAdhesion 0.05; }", 1e-5, 2,
     {{"jkr", DEM_NEEDED, 45871.6}},
     {"Bond number 4.59e+04"}},
    {"beads that hardly stick", "density 2500;", NULL,
     "hertz {} jkr { workOfAdhesion 1e-5; }", 1e-2, 2,
     {{"jkr", DEM_NEGLIGIBLE, -1.0}}, {NULL}},
    {"catalyst in air (group A)", "density 1500;", AIR,
     "hertz {} dry { restitution 0.9; } gidaspow {}", 6e-5, 100,
     {{"gidaspow", DEM_NEEDED, -1.0},
      {"stokesDamping", DEM_MISSING, 0.03101},
      {"jkr", DEM_MISSING, 14.158}}, {NULL}},
    {"sand in air (group B)", "density 2650;", AIR,
     "hertz {} dry { restitution 0.9; } gidaspow {}", 3e-4, 100,
     {{"gidaspow", DEM_NEEDED, -1.0}}, {NULL}},
    /* Goldschmidt, Beetstra, Kuipers 2004: collisions dominate, lift is left out */
    {"glass in air (Goldschmidt)", "density 2526;", AIR,
     "hertz {} dry { restitution 0.97; } mindlin { friction 0.1; } gidaspow {} pressureGradient {} "
     "magnus {} viscousTorque {}", 2.5e-3, 4000,
     {{"gidaspow", DEM_NEEDED, -1.0},
      {"pressureGradient", DEM_NEGLIGIBLE, 4.75e-4},
      {"magnus", DEM_NEGLIGIBLE, 8.022e-5},
      {"viscousTorque", DEM_NEGLIGIBLE, 1.0887e-4}},
     {"dense, collisions dominate"}},
    /* Tsuji, Morikawa et al. 1985; Sommerfeld 2003: spin due to wall collisions lifts grains in a
       pipe */
    {"sand in a pipe", "density 2650;", AIR " velocity (15 0 0);",
     "hertz {} dry { restitution 0.9; } mindlin { friction 0.3; } schillerNaumann {}", 5e-4, 4,
     {{"schillerNaumann", DEM_NEEDED, -1.0},
      {"magnus", DEM_MISSING, 0.04209},
      {"viscousTorque", DEM_MISSING, 0.40481}},
     {"dilute, fluid forces dominate"}},
    {"dust in a wall's shear", "density 2500;", AIR " vorticity (0 0 1e4);",
     "hertz {} schillerNaumann {} saffmanMei {} viscousStress {}", 5e-5, 2,
     {{"schillerNaumann", DEM_NEEDED, -1.0},
      {"viscousStress", DEM_NEGLIGIBLE, 0.0},
      {"saffmanMei", DEM_NEEDED, 0.19400},
      {"stokesDamping", DEM_MISSING, -1.0},
      {"jkr", DEM_MISSING, -1.0}}, {NULL}},
    {"a steel ball in air", "density 7800;", AIR,
     "hertz {} dry { restitution 0.9; } schillerNaumann {}", 5e-3, 2,
     {{"schillerNaumann", DEM_NEGLIGIBLE, 1.5439e-3}}, {NULL}},
    {"spheres in water without drag", "density 2500;", WATER,
     "hertz {} dry { restitution 0.9; } pressureGradient {} virtualMass {}", 1e-3, 2,
     {{"schillerNaumann", DEM_MISSING, 13.4557},
      {"pressureGradient", DEM_NEEDED, 0.4},
      {"virtualMass", DEM_NEEDED, 0.2},
      {"stokesDamping", DEM_MISSING, -1.0}}, {NULL}},
    {"many particles without contacts", "density 2500;", NULL,
     "", 1e-3, 1000,
     {{"hertz", DEM_MISSING, 0.06545}}, {NULL}},
    {"a dry cup", "density 2500;", NULL,
     "hertz {} dry { restitution 0.9; } mindlin { friction 0.3; }", 1e-3, 100,
     {{NULL, DEM_NEEDED, 0.0}},
     {"contact pressure of 1.3e+06 Pa"}},
    {"a drum", "density 2500;", NULL,
     "hertz {} dry { restitution 0.7; } mindlin { friction 0.5; } rollingSpring { friction 0.1; } "
     "twistingSpring { friction 0.5; }", 1e-3, 100,
     {{"rollingSpring", DEM_NEEDED, 0.2}, {"twistingSpring", DEM_NEEDED, 0.21927}}, {NULL}},
    /* Zhou et al. 2002: without rolling friction the slope of a heap of spheres is too low */
    {"a heap of rough grains", "density 2500;", NULL,
     "hertz {} dry { restitution 0.5; } mindlinIncremental { friction 0.6; }", 1e-3, 100,
     {{NULL, DEM_NEEDED, 0.0}},
     {"no rolling resistance at a friction of 0.6",
      "limitation: creeps where the normal force changes in cycles"}},
    {"a heap with rolling resistance that does not hold", "density 2500;", NULL,
     "hertz {} dry { restitution 0.5; } mindlin { friction 0.6; } "
     "rollingConstant { friction 0.1; }", 1e-3, 100,
     {{"rollingConstant", DEM_NEEDED, 0.16667}},
     {"limitation: holds nothing at rest: on a slope a sphere creeps at 5/2 g sin(slope) dt"}},
    /* Zhou et al. 1999: rolling of steel balls is four orders below their friction */
    {"a hopper of steel balls", "density 7800;", NULL,
     "hertz {} dry { restitution 0.9; } mindlin { friction 0.3; } "
     "rollingConstant { friction 5e-5; }", 1e-3, 100,
     {{"rollingConstant", DEM_NEGLIGIBLE, 1.6667e-4}}, {NULL}},
    {"tablets", "density 1500;", NULL,
     "hookeHysteresis { unloading 5; }", 2e-3, 100,
     {{"hookeHysteresis", DEM_NEEDED, 0.7833}}, {NULL}},
    /* Johnson 1985, 11.5: hard steel on steel begins to yield at 0.14 m/s against a plane; two
       equal spheres at half of that */
    {"hard steel at 1 m/s", "density 7800; youngsModulus 210e9; yieldStrength 1e9;", NULL,
     "hertz {} dry { restitution 0.97; }", 5e-3, 2,
     {{"hookeHysteresis", DEM_MISSING, 0.58062}},
     {"and yield from 0.068 m/s"}},
    {"hard steel at 5 cm/s", "density 7800; youngsModulus 210e9; yieldStrength 1e9;", NULL,
     "hertz { impactSpeed 0.05; } dry { restitution 0.97; }", 5e-3, 2,
     {{NULL, DEM_NEEDED, 0.0}}, {NULL}},
};

static const char *plan(const struct known *k, struct dem **d)
{
    const double box = 20.0*k->diameter;
    char *const scene = world_text(
        "materials { stuff { youngsModulus 1e7; "
        "%s } } effects { gravity { acceleration (0 0 -9.81); } %s } %s%s%s "
        "walls { room { type box; min (0 0 0); max (%g %g %g); } } "
        "insert { grains { type lattice; count %d; diameter %g; "
        "spacing 1.2; min (0 0 0); max (%g %g %g); } } %s",
        k->material, k->effects, k->fluid ? "fluid { " : "", k->fluid ? k->fluid : "",
        k->fluid ? " }" : "", box, box, box, k->count, k->diameter, box, box, box,
        k->effects[0] ? "" : "time { step 1e-5; }");
    const char *text;

    *d = world(scene, 0, NULL);
    WORLD_TRY(dem_plan(*d, &(struct dem_run_info){.duration = 0.0}, &text));
    return text;
}

static void check(const struct known *k, struct dem *d)
{
    struct dem_plan plan;
    struct dem_regime regime;
    struct dem_verdicts verdicts;
    int claims = 0;

    WORLD_TRY(dem_plan_begin(&plan, d, &(struct dem_run_info){.duration = 0.0}));
    dem_regime_set(&plan, &regime);
    dem_verdicts(&plan, &regime, &verdicts);
    const struct dem_verdict *const v = verdicts.verdict;
    const int n = verdicts.n;

    for (; claims < 8 && k->verdicts[claims].effect; claims++)
    {
        const struct claim *const c = &k->verdicts[claims];
        int at = 0;

        while (at < n && strcmp(v[at].effect, c->effect) != 0)
        {
            at++;
        }
        TAP_OK(at < n && v[at].word == c->word, "%s: %s is %s", k->name, c->effect,
               c->word == DEM_NEEDED ? "needed"
               : c->word == DEM_NEGLIGIBLE ? "negligible"
                                           : "called for");
        if (at < n && c->share >= 0.0)
        {
            TAP_NEAR(v[at].fraction, c->share, 0.01*c->share, "%s: fraction", c->effect);
        }
    }
    TAP_OK(n == claims, "%s: no other verdict: %d for %d", k->name, n, claims);
}

int main(void)
{
    for (size_t n = 0; n < sizeof scenes/sizeof scenes[0]; n++)
    {
        struct dem *d;
        const char *const text = plan(&scenes[n], &d);

        check(&scenes[n], d);
        for (int k = 0; k < 3 && scenes[n].lines[k]; k++)
        {
            TAP_OK(strstr(text, scenes[n].lines[k]) != NULL, "%s: %s", scenes[n].name,
                   scenes[n].lines[k]);
        }
        dem_free(d);
    }
    TAP_DONE;
}
