/*
 * tangential.h -- a contact row for friction laws, and the claims common to them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "law_rows.h"

static const struct dem_material tangential_oxide =
    {"aluminium oxide", 4000.0, 380e9, .poissons_ratio = 0.23};
static const struct dem_material tangential_soda =
    {"soda-lime glass", 2500.0, 70e9, .poissons_ratio = 0.25};
static const double tangential_pi = 3.14159265358979324;

/* one row at rest: normal z, R* = 4 mm, overlap 1 um, k_n = 1e6 N/m, fn = 1 kN, no tangential
   damping */
static inline struct rows_effect *tangential_row(struct law_rows *w, const struct dem_effect *law,
                                                    double friction, double damping)
{
    rows_wall(w, &tangential_oxide, &tangential_soda, 0.004);
    w->pair.exponent = 1.5;
    struct rows_effect *const l = rows_add(w, law, "friction", friction);

    apply_setting(law, l->settings, &w->pair, "tangentialDamping", damping);
    w->b.n = 1;
    w->b.dt = 1e-6;
    w->b.nz[0] = w->b.hz[0] = 1.0;
    w->b.touching[0] = 1.0;
    w->b.overlap[0] = 1e-6;
    w->b.reduced_radius[0] = 0.004;
    w->b.kn[0] = 1e6;
    w->b.fn[0] = 1e3;
    return l;
}

static inline void tangential_evaluate(struct law_rows *w, struct rows_effect *l)
{
    w->b.fx[0] = w->b.fy[0] = w->b.fz[0] = 0.0;
    l->effect->apply(l->settings, &w->b, l->history);
}

static inline double tangential_size(const struct law_rows *w)
{
    return sqrt(w->b.fx[0]*w->b.fx[0] + w->b.fy[0]*w->b.fy[0] + w->b.fz[0]*w->b.fz[0]);
}

/* A loaded spring of a pair that spins about n as one body rotates with it and keeps its length.
   Slip at a constant rate in space during the rotation describes a circle, and vanishes after each
   turn. */
static inline void tangential_rotation(struct law_rows *w, const struct dem_effect *law)
{
    enum { TURN = 1000 };
    const double angle = 2.0*tangential_pi/TURN, slip = 1e-3;
    struct rows_effect *l = tangential_row(w, law, 0.5, 0.0);

    w->b.sx[0] = slip;
    tangential_evaluate(w, l);
    const double kt = w->b.kt[0], force = kt*slip*w->b.dt;

    /* 2 atan(angle/2) a step is less than the angle by angle^3/12; rounding of TURN/4 steps */
    w->b.sx[0] = 0.0, w->b.normal_spin[0] = angle/w->b.dt;
    const double behind = TURN/4*angle*angle*angle/12.0;

    for (int k = 0; k < TURN/4; k++)
    {
        tangential_evaluate(w, l);
    }
    TAP_NEAR(w->b.fy[0], -force*cos(behind), 1e-12*force,
             "a quarter turn of the pair rotates the force");
    TAP_NEAR(w->b.fx[0], -force*sin(behind), 1e-3*force*behind, "by the same angle, to third order");
    TAP_NEAR(tangential_size(w), force, 1e-12*force, "its magnitude does not change");

    /* xi' = i rate xi + s, s constant: xi = s (e^(i rate t) - 1)/(i rate), across s after half a
       turn */
    l = tangential_row(w, law, 0.5, 0.0);
    w->b.sx[0] = slip, w->b.normal_spin[0] = angle/w->b.dt;
    for (int k = 0; k < TURN/2; k++)
    {
        tangential_evaluate(w, l);
    }
    const double across = kt*slip*2.0*w->b.dt/angle;

    TAP_NEAR(w->b.fy[0], -across, angle*angle*across,
             "after half a turn steady slip gives a force across");    /* second order */
    for (int k = 0; k < TURN/2; k++)
    {
        tangential_evaluate(w, l);
    }
    TAP_NEAR(tangential_size(w), 0.0, 4.0*angle*angle*across,
             "after a whole turn the force is zero");      /* 2 pi angle^2/12 less */
    w->b.normal_spin[0] = 0.0;
}

/* Slip to and fro under a varying normal force: in no step does the stored energy grow by more than
   the work done, with little or much damping. */
static inline void tangential_energy(struct law_rows *w, const struct dem_effect *law)
{
    static const double eta[] = {0.0, 0.1, 3.0, 30.0};

    for (int m = 0; m < 4; m++)
    {
        struct rows_effect *const l = tangential_row(w, law, 0.5, 1.0);
        double worst = 0.0, most = 0.0, before = 0.0;
        int slips = 0;

        tangential_evaluate(w, l);
        const double fast =
            1.0/(w->b.kt[0]*
                   /* a step loads the spring by up to 1 N; the limit goes up to 5 N */
                   w->b.dt);

        w->b.eta[0] = eta[m];
        for (int n = 0; n < 2000; n++)
        {
            w->b.sx[0] = 0.6*fast*sin(0.37*n), w->b.sy[0] = 0.8*fast*sin(1.91*n + 0.3);
            w->b.fn[0] = 12.0*sin(0.11*n) - 2.0;
            tangential_evaluate(w, l);
            const double x = l->column[0][0], y = l->column[1][0],
                         held = 0.5*w->b.kt[0]*(x*x + y*y);

            worst = fmax(worst, held - before +
                                    (w->b.fx[0]*w->b.sx[0] + w->b.fy[0]*w->b.sy[0])*w->b.dt);
            before = held;
            most = fmax(most, held);
            slips += tangential_size(w) > 0.0 &&
                     fabs(tangential_size(w)/(0.5*w->b.fn[0]) - 1.0) < 1e-9;
        }
        TAP_OK(most > 0.0 && slips > 100 && worst < 1e-12*most,
               "eta %g kg/s: slipping in %d steps of 2000 it stores up to %.3g J, and gains "
               "at most %.2g of that in a step",
               eta[m], slips, most, worst/most);
    }
}

/* sticking, sliding, attraction, separation; the spring has the stiffness k_t */
static inline void tangential_claims(struct law_rows *w, const struct dem_effect *law)
{
    tangential_rotation(w, law);
    tangential_energy(w, law);
    struct rows_effect *l = tangential_row(w, law, 0.5, 0.0);

    /* a few rounded factors */
    w->b.sx[0] = 2e-3, w->b.sy[0] = -1e-3;
    tangential_evaluate(w, l);
    tangential_evaluate(w, l);
    const double kt = w->b.kt[0];

    TAP_OK(kt > 0.0, "a stiffness of %g N/m", kt);
    TAP_NEAR(w->b.fx[0], -kt*4e-9, 1e-14*kt*4e-9, "two steps of slip load the spring against it");
    TAP_NEAR(w->b.fy[0], kt*2e-9, 1e-14*kt*2e-9, "in both tangential directions");
    w->b.sx[0] = -4e-3, w->b.sy[0] = 2e-3;
    tangential_evaluate(w, l);
    TAP_NEAR(tangential_size(w), 0.0, 1e-14*kt*4e-9, "slip back unloads it");
    l = tangential_row(w, law, 0.5, 1.0);
    w->b.eta[0] = 30.0;
    w->b.sx[0] = 1e-3;
    tangential_evaluate(w, l);
    TAP_NEAR(w->b.fx[0], -kt*1e-9 - 30.0*1e-3, 1e-14*30.0,
             "with tangential damping the coefficient of the normal law is added");

    l = tangential_row(w, law, 0.5, 1.0);
    w->b.eta[0] = 30.0;
    w->b.fn[0] = 10.0;
    w->b.sx[0] = 3.0, w->b.sy[0] = 4.0;
    tangential_evaluate(w, l);
    TAP_NEAR(tangential_size(w), 5.0, 5e-15, "sliding: mu fn");
    TAP_NEAR(w->b.fx[0], -3.0, 5e-15, "against the slip");
    /* round-off of a trial force of 30 times the limit */
    TAP_NEAR(-(kt + 30.0/w->b.dt)*l->column[1][0], -4.0, 1e-13,
             "spring and dashpot are cut in the same proportion");
    for (int k = 0; k < 5000; k++)                        /* c/k is 100 steps at most */
    {
        tangential_evaluate(w, l);
    }
    TAP_NEAR(tangential_size(w), 5.0, 5e-15, "sliding for long: mu fn");
    TAP_NEAR(-kt*l->column[1][0], -4.0, 1e-13, "sliding for long: the spring carries all of it");
    w->b.sx[0] = -1e-5, w->b.sy[0] = 0.0;
    tangential_evaluate(w, l);
    TAP_OK(tangential_size(w) < 5.0 && w->b.fx[0] < 0.0,
           "a small slip back unloads; the force does not reverse at once");
    w->b.fn[0] = -1.0;
    tangential_evaluate(w, l);
    TAP_OK(tangential_size(w) == 0.0 && l->column[0][0] == 0.0,
           "an attractive contact has no friction and no elongation");
    l = tangential_row(w, law, 0.5, 1.0);
    w->b.touching[0] = w->b.overlap[0] = w->b.kn[0] = w->b.fn[0] = 0.0;
    w->b.sx[0] = 3.0;
    l->column[0][0] = 1e-6;
    tangential_evaluate(w, l);
    TAP_OK(tangential_size(w) == 0.0 && w->b.kt[0] == 0.0 && l->column[0][0] == 0.0,
           "a row apart has no force and no elongation");
    TAP_OK(apply_setting(law, l->settings, &w->pair, "friction", -0.1) == DEM_ERROR_INPUT, "%s",
           dem_error_text());
    w->pair.exponent = 0.0;
    TAP_OK(dem_effect_prepare(law, l->settings, &w->pair) == DEM_ERROR_INPUT, "%s", dem_error_text());
}
