/*
 * test_moving_bed.c -- the neighbor lists of a bed that moves as a whole miss no contact and are
 * rebuilt as rarely as at rest.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "world.h"
#include "core/random.h"

#include <stdlib.h>
#include <string.h>

#define LAWS "materials { glass { density 2500; youngsModulus 1e7; } }" \
             "effects { hertz { impactSpeed 1; } dry { restitution 0.5; } " \
             "mindlin { friction 0.5; } %s } time { step 5e-6; }"

/* ---- through a periodic box ------------------------------------------------------------------ */

enum
{
    SIDE = 8
};

static const double BOX = 0.00792;                        /* m */

/* 512 spheres of 1 mm at the corners of a lattice that overlaps by 1 %, in a periodic box of 8 of
   them; random shifts rattle them. */
static struct dem *packing(double speed)
{
    static struct dem_new_particle seed[SIDE*SIDE*SIDE];
    char *const scene = world_text(LAWS "domain { min (0 0 0); max (%g %g %g); periodic (x y z); }",
                                   "", BOX, BOX, BOX);

    for (int k = 0; k < SIDE*SIDE*SIDE; k++)
    {
        const int cell[3] = {k%SIDE, k/SIDE%SIDE, k/(SIDE*SIDE)};

        seed[k] = (struct dem_new_particle){
            .diameter = 1e-3, .id = k, .material = "glass",
            .velocity = {speed, 0.7*speed, -0.4*speed}};
        for (int a = 0; a < 3; a++)
        {
            seed[k].position[a] =
                BOX/SIDE*(cell[a] + 0.5) +
                1e-5*(2.0*dem_random_unit(5, (uint64_t)k, 0, (uint64_t)a) - 1.0);
        }
    }
    return world(scene, SIDE*SIDE*SIDE, seed);
}

static void fly(void)
{
    struct dem_totals rest, flight;
    struct dem *d = packing(0.0);
    const double duration = 0.01;                         /* 10 diameters at 1 m/s */

    world_run(d, duration);
    rest = world_tally(d);
    dem_free(d);
    d = packing(1.0);
    world_run(d, duration);
    flight = world_tally(d);
    dem_free(d);
    TAP_NOTE("at rest %lld rebuilds and %lld prunes, in motion %lld and %lld, in %lld steps",
             (long long)rest.rebuilds, (long long)rest.prunes, (long long)flight.rebuilds,
             (long long)flight.prunes, (long long)flight.steps);
    TAP_OK(rest.contacts >= 2*512, "at rest: %lld contacts of 512 spheres",
           (long long)rest.contacts);
    TAP_OK(flight.contacts == rest.contacts, "in motion as many contacts as at rest, %lld",
           (long long)flight.contacts);
    /* one rebuild after each half box (3.96 of 10 mm: two or three), one at the end, so that
       positions are reported within the box, and one or two more by other skins. Displacements from
       the start, without the mean motion, would need one every quarter of a diameter */
    TAP_OK(flight.rebuilds <= rest.rebuilds + 5, "lists rebuilt %lld times in 10 diameters",
           (long long)flight.rebuilds);
    TAP_OK(flight.prunes <= rest.prunes + 6, "lists pruned %lld times", (long long)flight.prunes);
}

/* ---- past walls and frozen spheres ----------------------------------------------------------- */

struct slide
{
    const char *name, *walls, *others, *domain;
};

static struct dem *sliding(const struct slide *s, const char *skins)
{
    return world(world_text(
        LAWS
        "walls { %s } domain { %s } %s insert { bed { type lattice; diameter"
        " 1e-3; count 150; min (0 0 0.0005); max (0.012 0.006 0.02); jitter 0.8; "
        "velocity (1 0.2 -0.4); } %s }",
        "gravity { acceleration (0 0 -9.81); }", s->walls,
        s->domain ? s->domain : "x (0 0.012); y (0 0.006); periodic (x y);", skins, s->others),
        0, NULL);
}

static void pass(const struct slide *s)
{
    static const char *const skins[] = {"neighbours { outerSkin 2; innerSkin 2; }",
                                        "neighbours { outerSkin 0.3; innerSkin 0.04; }",
                                        "neighbours { outerSkin 0.02; innerSkin 0.005; }", ""};
    enum { CASES = sizeof skins/sizeof *skins };
    struct dem_totals t[CASES], again;
    uint64_t hash[CASES];

    for (int k = 0; k <= CASES; k++)
    {
        struct dem *const d = sliding(s, k < CASES ? skins[k] : "");

        world_run(d, 0.01);
        *(k < CASES ? &t[k] : &again) = world_tally(d);
        hash[k < CASES ? k : CASES - 1] = world_hash(d);
        dem_free(d);
    }
    TAP_NOTE(
        "%s: %lld contacts; rebuilds %lld, %lld, %lld, tuned %lld; "
        "prunes %lld, %lld, %lld, tuned %lld",
        s->name, (long long)t[0].contacts, (long long)t[0].rebuilds, (long long)t[1].rebuilds,
        (long long)t[2].rebuilds, (long long)t[3].rebuilds, (long long)t[0].prunes,
        (long long)t[1].prunes, (long long)t[2].prunes, (long long)t[3].prunes);
    TAP_OK(t[0].largest_overlap > 0.005 && t[0].rebuilds < t[2].rebuilds,
           "%s: overlap %.3f of a diameter, and the lists differ in age", s->name,
           t[0].largest_overlap);
    for (int k = 1; k < CASES; k++)
    {
        TAP_OK(hash[k] == hash[0], "%s: with %s the same bits as with skins of 2 diameters",
               s->name, skins[k][0] ? skins[k] : "tuned skins");
    }
    TAP_OK(again.rebuilds == t[3].rebuilds && again.prunes == t[3].prunes,
           "%s: a second run has the same rebuilds and prunes", s->name);
}

int main(void)
{
    static const struct slide slides[] = {
        {.name = "over a plane",
         .walls = "floor { type plane; point (0 0 0); normal (0 0 1); }",
         .others = ""},
        {.name = "over triangles",
         .others = "",
         .walls =
             "floor { type triangles; corners ((-1 -1 0) (1 -1 0) (1 1 0) (-1 -1 0) (1 1 0) (-1 "
             "1 0)); }"},
        {.name = "over a shaking plane, under another",
         .others = "",
         .walls =
             "floor { type plane; point (0 0 0); normal (0 0 1); motion { type oscillation; "
             "amplitude (0 0 1e-4); frequency 300; } }"
             "roof { type plane; point (0 0 0.008); normal (0 0 -1); motion { type oscillation; "
             "amplitude (0 0 -2e-4); frequency 100; } }"},
        {.name = "over a row that is frozen",
         .walls = "floor { type plane; point (0 0 0); normal (0 0 1); }",
         .others =
             "row { type list; diameter 1e-3; frozen yes; "
             "positions ((0.0005 0.003 -1e-4) (0.0045 0.003 -1e-4) (0.0085 0.003 -1e-4)); }"},
        {.name = "along a tube",
         .domain = "x (0 0.012); periodic (x);",
         .others = "",
         .walls =
             "tube { type cylinder; point (0 0.003 0.005); axis (1 0 0); radius 0.0066; "
             "particles inside; }"},
    };

    TAP_TRAPS;
    fly();
    for (size_t k = 0; k < sizeof slides/sizeof *slides; k++)
    {
        pass(&slides[k]);
    }
    TAP_DONE;
}
