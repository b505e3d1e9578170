/*
 * Claims: of scenes whose regime the literature knows the plan tells the numbers, and the effects that it calls for: Gondret's balls in
 * oil, glass in water, bubbles, dust, sand and a suspension in a law for single spheres, fine powder that sticks and beads that do not.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

struct known
{
    const char *name, *material, *fluid, *effects;
    double diameter;                                      /* m */
    int count;                                            /* in a box of 20 diameters, that closes a room */
    const char *tells[4], *silent[4];                     /* beginnings of lines that are there, words that are not in the regime */
};

static const char air[] = "density 1.2; viscosity 1.8e-5;", water[] = "density 1000; viscosity 1e-3;", oil[] = "density 935; viscosity 0.01;",
                  fall[] = "gravity { acceleration (0 0 -9.81); }";

/* What each is known for stands in the papers named in plan/regime.c; numbers are those of its formulas, worked out by hand. */
static const struct known scenes[] =
{
    {"steel in oil (Gondret)", "density 7800;", oil, "hertz { impactSpeed 0.5; } dry { restitution 0.97; } pressureGradient {} schillerNaumann {}", 3e-3, 2,
     {"stokes             off, called for: 13 %", "pressureGradient   on, needed: 12 %", "virtualMass        off, called for: 6 %"}, {"wenYu"}},
    {"the same with the film", "density 7800;", oil, "hertz { impactSpeed 0.5; } stokes { restitution 0.97; } pressureGradient {} schillerNaumann {} virtualMass {}",
     3e-3, 2, {"stokes             on, needed: 13 %", "virtualMass        on, needed: 6 %"}, {"called for"}},
    {"glass in water", "density 2500;", water, "hertz {} dry { restitution 0.9; } wenYu {}", 1e-3, 20,
     {"pressureGradient   off, called for: 40 %", "virtualMass        off, called for: 20 %", "stokes             off, called for: 6.1 %"}, {"negligible"}},
    {"poppy seeds in air", "density 1000;", air, "hertz {} dry { restitution 0.66; } gidaspow {} virtualMass {}", 1.2e-3, 100,
     {"virtualMass        on, negligible: 0.06 %"}, {"stokes ", "wenYu", "pressureGradient"}},
    {"bubbles", "density 1.2;", water, "hertz {} schillerNaumann {} pressureGradient {} virtualMass {}", 1e-3, 2,
     {"virtualMass        on, needed: 4.2e+04 %", "pressureGradient   on, needed: 8.3e+04 %"}, {"negligible"}},
    {"dust of 10 um in air", "density 2500;", air, "hertz {} stokesDrag {}", 1e-5, 2, {"density ratio 2083"}, {"schillerNaumann"}},
    {"sand in air by Stokes' law", "density 2650;", air, "hertz {} stokesDrag {}", 5e-4, 2, {"schillerNaumann    off, called for"}, {"virtualMass"}},
    {"a suspension by a single sphere's law", "density 1050;", water, "hertz {} schillerNaumann {}", 1e-3, 3000, {"wenYu              off, called for"}, {"negligible"}},
    {"a dilute one", "density 1050;", water, "hertz {} schillerNaumann {}", 1e-3, 10, {"virtualMass        off, called for: 48 %"}, {"wenYu"}},
    {"powder of 10 um", "density 2500;", NULL, "hertz {} jkr { workOfAdhesion 0.05; }", 1e-5, 2, {"jkr                on, needed", "Bond number 4.59e+04"}, {"stokes"}},
    {"beads that hardly stick", "density 2500;", NULL, "hertz {} jkr { workOfAdhesion 1e-5; }", 1e-2, 2, {"jkr                on, negligible"}, {"stokes"}},
    {"a dry cup", "density 2500;", NULL, "hertz {} dry { restitution 0.9; } mindlin { friction 0.3; }", 1e-3, 100, {""}, {"Regime"}},
};

static const char *regime(const struct known *k, struct dem **d)
{
    const double box = 20.0*k->diameter;
    char *const text = world_text("materials { stuff { %s youngsModulus 1e7; } } effects { %s %s } fluid { %s } walls { room { type box; min (0 0 0); "
                                  "max (%g %g %g); } } insert { grains { type lattice; count %d; diameter %g; spacing 1.2; min (0 0 0); max (%g %g %g); } }",
                                  k->material, fall, k->effects, k->fluid ? k->fluid : "", box, box, box, k->count, k->diameter, box, box, box);
    char *const at = k->fluid ? NULL : strstr(text, "fluid {  }");
    const char *plan;

    if (at)
    {
        memset(at, ' ', strlen("fluid {  }"));
    }
    *d = world(text, 0, NULL);
    free(text);
    WORLD_TRY(dem_plan(*d, &(struct dem_prospect){.duration = 0.0}, &plan));
    const char *const begins = strstr(plan, "Regime");

    return begins ? begins : "";
}

int main(void)
{
    for (size_t n = 0; n < sizeof scenes/sizeof scenes[0]; n++)
    {
        struct dem *d;
        const char *const text = regime(&scenes[n], &d);

        for (int k = 0; k < 4; k++)
        {
            TAP_OK(!scenes[n].tells[k] || strstr(text, scenes[n].tells[k]), "%s: %s", scenes[n].name, scenes[n].tells[k] ? scenes[n].tells[k] : "");
            TAP_OK(!scenes[n].silent[k] || !strstr(text, scenes[n].silent[k]), "%s: nothing of %s", scenes[n].name,
                   scenes[n].silent[k] ? scenes[n].silent[k] : "");
        }
        dem_free(d);
    }
    TAP_DONE;
}
