/*
 * test_blow_up.c -- unphysical velocities end a run with one sentence: the particle, the value, the
 * limit and the cure.
 *
 * - Starts at 1e30 and 1e200 m/s, with and without contacts (the limit is the speed of light).
 * - A force so large that the sums of the means (momentum, m v v) cannot be represented.
 * - Values that can be summed are accepted: 1e8 m/s.
 *
 * Source: the contract of records/grid_averages.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "core/error.h"

#define MEANS "averages { box { min (-1 -1 -1); max (1 1 1); cells (2 2 2); interval 1e-9; } } "

static void try_velocity(const char *what, const char *effects, const char *velocity,
                         const char *first, const char *second)
{
    struct dem_case *const c = world_begin(world_text(
        "materials { glass { density 2500; youngsModulus 1e7; } } "
        "effects { %s } time { step 1e-6; force yes; } " MEANS
        "insert { a { type list; diameter 1e-3; positions ((0 0 0)); velocity %s; } "
        "b { type list; diameter 1e-3; positions ((0.0010005 0 0)); } }",
        effects, velocity));
    const char *const text = dem_error_text();

    struct dem *const d = world_start(c);
    const int status = dem_advance(d, 1e-6);

    TAP_OK(first ? status == DEM_ERROR_NUMBER && strstr(text, first) && strstr(text, second)
                 : status == 0,
           "%s: %s", what, status ? text : "accepted");
    dem_free(d);
}

int main(void)
{
    static const char gravity[] = "gravity { acceleration (0 0 -9.81); }";
    static const char contacts[] = "hertz {} dry { restitution 0.8; }";

    TAP_TRAPS;
    try_velocity("1e30 m/s, no contacts", gravity, "(1e30 0 0)", "particle 0 at (1e+24 0 ",
          "speed of light");
    try_velocity("1e30 m/s, contacts", contacts, "(1e30 0 0)", "particle 0 at (1e+24 0 ",
          "has 1e+30 m/s in step 1; the limit is 2.99792e+08 m/s");
    try_velocity("1e200 m/s, no contacts", gravity, "(-1e200 0 0)", "particle 0 at (-1e+194 0 ",
          "has inf m/s in step 1");
    try_velocity("1e8 m/s, no contacts", gravity, "(0 1e8 0)", NULL, NULL);
    try_velocity("a force of 1e293 N", "hooke { stiffness 1e300; }", "(1 0 0)",
          "averages/box: particle 0 at (1e-06 0 0) m with (-1.90986e+293 0 0) m/s has momentum",
          "the limit is 1e+60; look at the forces on it");
    try_velocity("a force of 1e60 N", "hooke { stiffness 1e67; }", "(1 0 0)",
                 "averages/box: particle 0", "the limit is 1e+60");
    try_velocity("a force of 1e303 N", "hooke { stiffness 1e308; } dry { restitution 0.5; }",
                 "(100 0 0)", "averages/box: particle 0", "in step 1");
    TAP_DONE;
}
