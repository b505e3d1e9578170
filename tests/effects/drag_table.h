/*
 * drag_table.h -- a table of all drag laws, and the claims that hold for each of them.
 *
 * The table gives G, drag over Stokes drag 3 pi mu d (u - v), with superficial Re. It was computed
 * from the papers' formulas in another program and rounded to two places. In a packing the laws
 * differ by up to a factor of 1.8.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "bodies.h"

enum
{
    DRAG_DI_FELICE,
    DRAG_RONG,
    DRAG_KOCH_HILL,
    DRAG_BEETSTRA,
    DRAG_TENNETI,
    DRAG_COLUMNS
};

static const struct
{
    double e, re, G[DRAG_COLUMNS];
} drag_table[] = {
    /*  e     Re     Di Felice  Rong   Koch-Hill  Beetstra  Tenneti */
    {0.42,   1.0, {10.64, 11.16, 13.98, 13.98, 13.09}},
    {0.42, 200.0, {54.12, 56.25, 48.48, 50.35, 37.46}},
    {0.60,  20.0, { 6.93,  7.11,  8.29,  9.43,  8.97}},
    {0.70, 200.0, {17.34, 19.05, 17.80, 21.36, 15.34}},
    {0.80,  20.0, { 3.83,  3.95,  4.49,  4.96,  4.71}},
    {0.90,  20.0, { 3.00,  3.09,  3.32,  3.53,  3.35}},
    {0.99,  20.0, { 2.47,  2.48,  2.16,  2.36,  2.36}},
};

static inline void drag_in_table(const struct dem_effect *law, const void *settings, int column)
{
    for (int k = 0; k < (int)(sizeof drag_table/sizeof drag_table[0]); k++)
    {
        /* rounded to two places */
        TAP_NEAR(body_drag(law, settings, drag_table[k].e, drag_table[k].re),
                 drag_table[k].G[column], 0.00501, "table: e = %g, Re = %g", drag_table[k].e,
                 drag_table[k].re);
    }
}

/* at rest and out of range finite and bounded; the force grows with the slip */
static inline void drag_limits(const struct dem_effect *law, const void *settings)
{
    int falls = 0, bad = 0;

    for (int k = 0; k <= 80; k++)
    {
        const double e = 0.2 + 0.01*k;
        double before = 0.0;

        for (double re = 1e-15; re < 1e6; re *= 1.5)
        {
            const double force = body_drag(law, settings, e, re)*re;

            falls += !(force > before);
            before = force;
        }
        bad +=
            !isfinite(body_drag(law, settings, e, 0.0)) || body_drag(law, settings, e, 0.0) < 0.0;
    }
    TAP_OK(falls == 0,
           "the force grows with the slip, at every e from 0.2 to 1 and Re from 1e-15 to 1e6");
    TAP_OK(bad == 0, "finite and not negative at rest");
    TAP_OK(body_drag(law, settings, 0.1, 0.0) == body_drag(law, settings, 0.2, 0.0) &&
               body_drag(law, settings, 0.0, 0.0) == body_drag(law, settings, 0.2, 0.0),
           "below e = 0.2 as at 0.2");
    TAP_OK(body_drag(law, settings, 1.1, 0.0) == body_drag(law, settings, 1.0, 0.0),
           "above e = 1 as at 1");
}

/* drag depends on the slip alone, equally in all directions; target and coefficient belong
   together; no other column is written */
static inline void drag_form(const struct dem_effect *law, const void *settings)
{
    static struct dem_body_batch b;
    const double stokes = 3.0*3.14159265358979324*1e-6;

    memset(&b, 0, sizeof b);
    b.n = 6;
    for (int c = 0; c < b.n; c++)    /* as for all rows of a batch */
    {
        b.sphericity[c] = b.crosswise[c] = b.lengthwise[c] = 1.0;
    }
    for (int c = 0; c < 4; c++)
    {
        body_fill(&b, c, 1e-3, 1000.0, 1e-3, 0.6, 20.0);
        b.vx[c] = 3.0, b.vy[c] = -2.0, b.vz[c] = 1.0;
        b.ux[c] = b.vx[c] + (c == 1 ? 0.04 : 0.0), b.uy[c] = b.vy[c] + (c == 2 ? 0.04 : 0.0);
        b.uz[c] = b.vz[c] + (c == 3 ? 0.04 : 0.0);
    }
    body_fill(&b, 4, 1e-3, 1000.0, 0.0, 0.6, 0.0);
    b.ux[4] = 5.0;
    dem_effect_apply_to_bodies(law, settings, &b);
    /* a few rounded factors; 0.04 is 3.04 - 3, with a rounding of 1e-14 */
    TAP_NEAR(b.drag[0]/stokes/body_drag(law, settings, 0.6, 0.0), 1.0, 1e-13,
             "moving with the fluid: as at rest in it");
    for (int c = 1; c < 4; c++)
    {
        TAP_NEAR(b.drag[c]/stokes/body_drag(law, settings, 0.6, 24.0), 1.0, 1e-12,
                 "slip along axis %d alone", c - 1);
    }
    TAP_OK(b.drag_ux[1] == b.drag[1]*b.ux[1] && b.drag_uy[2] == b.drag[2]*b.uy[2] &&
           b.drag_uz[3] == b.drag[3]*b.uz[3], "target: b times the fluid velocity");
    TAP_OK(b.drag[4] == 0.0 && b.drag_ux[4] == 0.0 && b.drag[5] == 0.0 && b.drag_ux[5] == 0.0,
           "no viscosity or empty row: no drag");
    TAP_OK(b.fx[1] == 0.0 && b.fy[2] == 0.0 && b.fz[3] == 0.0, "no explicit force");
    const double once = b.drag[1];

    dem_effect_apply_to_bodies(law, settings, &b);
    TAP_OK(b.drag[1] == 2.0*once, "adds to the value in the column");
    TAP_OK(law->drag != DEM_DRAG_NONE && (law->needs | DEM_NEEDS_FORM) == (DEM_NEEDS_FLUID | DEM_NEEDS_FORM),
           "it is declared as a drag law that needs the fluid");
}
