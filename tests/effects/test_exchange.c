/*
 * test_exchange.c -- the exchange gives the fluid the impulse that its formulas state, and is
 * stable with the under-relaxation factor where it is not without.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"
#include "laws/fluid/particle_exchange.h"
#include <math.h>

/* ---- one cell ------------------------------------------------------------------------------------------------ */

/*
 * Particles (solid fraction s, density ratio mu, added-mass coefficient C, drag b) in a fluid of
 * density 1 that they displace, e u = -s times their mean velocity in a step, which lasts 1. Written
 * from the equations of the coupled solver (docs/theory-coupling.md), independent of its code.
 */
struct cell
{
    double s, mu, C, b;
};

struct flow
{
    double v, u;                            /* velocities */
    double felt, gradient;                  /* pressure gradient: that particles feel, of the fluid */
    double acceleration, change;            /* Du/Dt that they feel; last change of u */
    double carried;                         /* impulse of the last exchange */
};

static void advance(const struct cell *q, double w, struct flow *x)
{
    const double s = q->s, e = 1.0 - s, M = q->mu + q->C, c = dem_exchange_slip_factor(e, 0);
    const double Z = c*q->b/M, E = -expm1(-Z), R = M*E/c, Ra = q->C*q->mu/M;
    const double transmitted = 1.0 - E/Z;
    /* particles, in a frozen fluid */
    const double F = q->C*x->acceleration - x->felt + x->carried, all = F + q->b*(x->u - x->v);
    const double dv = all*E/(c*q->b), mean = x->v + all*transmitted/(c*q->b);
    const double J = M*dv - F + q->C*x->acceleration - q->C*dv - Ra*x->change;
    /* fluid: continuity gives u, its equation the pressure gradient */
    const double du = -s/e*mean - x->u, Y = s*transmitted*w;
    const double gradient = (Y*x->felt - e*du - s*(J + (R + Ra)*du))/(e + Y);
    const double next = x->felt + w*(gradient - x->felt);

    x->carried = (R + Ra)*du + transmitted*(next - x->felt) - Ra*x->change;
    x->v += dv;
    x->u += du;
    x->felt = next;
    x->gradient = gradient;
    x->acceleration += w*(du - x->acceleration);
    x->change = du;
}

/* the largest of the state in `steps` steps */
static double largest(const struct cell *q, double w, struct flow *x, int steps)
{
    double max = 0.0;

    for (int k = 0; k < steps && max < 1e100; k++)
    {
        advance(q, w, x);
        max = fmax(max, fmax(fmax(fabs(x->v), fabs(x->u)), fmax(fabs(x->felt), fabs(x->change))));
    }
    return max;
}

/* 1 when what is left after 4000 steps is no more than at first */
static int stable(const struct cell *q, int relaxed)
{
    const double Z = q->b/(q->mu + q->C)/((1.0 - q->s)*(1.0 - q->s));
    const double w = relaxed ? dem_exchange_under_relaxation(1.0 - q->s, q->mu, q->C,
                                                             1.0 + expm1(-Z)/Z)
                             : 1.0;
    struct flow x = {.v = 1.0, .u = -0.3, .felt = 0.7, .gradient = 0.7, .acceleration = 0.2};
    const double first = largest(q, w, &x, 1000);

    largest(q, w, &x, 2000);
    return largest(q, w, &x, 1000) <= 1.001*first;
}

static void suspensions(void)
{
    static const double ratio[] = {0.0012, 0.1, 0.5, 1.0, 2.5, 8.0, 100.0};
    int cells = 0, with = 0, without = 0, light = 0;

    for (int k = 1; k <= 14; k++)
    {
        const double s = 0.05*k, zuber = 0.5*(1.0 + 2.0*s)/(1.0 - s);
        const double coefficient[] = {0.0, 0.5, zuber};

        for (int r = 0; r < 7; r++)
        {
            for (int a = r == 0; a < 3; a++)              /* bubbles without added mass: never */
            {
                for (double z = 1e-4; z < 200.0; z *= 3.0)
                {
                    const struct cell q = {s, ratio[r], coefficient[a],
                                           z*(ratio[r] + coefficient[a])};

                    cells++;
                    with += stable(&q, 1);
                    without += stable(&q, 0);
                    light += ratio[r] >= DEM_EXCHANGE_LIGHT && !stable(&q, 0);
                }
            }
        }
    }
    TAP_OK(with == cells, "with under-relaxation: %d of %d suspensions are stable", with, cells);
    TAP_OK(without < cells - 100, "without: %d of %d", without, cells);
    TAP_OK(light == 0, "particles of %g times the density need no factor", DEM_EXCHANGE_LIGHT);
}

int main(void)
{
    TAP_TRAPS;
    /* products of round numbers: rounding */
    TAP_NEAR(dem_exchange_slip_factor(0.4, 0), 6.25, 1e-14, "the slip factor at e = 0.4");
    TAP_NEAR(dem_exchange_slip_factor(0.4, 1), 2.5, 1e-15, "with whole drag");
    TAP_OK(dem_exchange_slip_factor(1.0, 0) == 1.0 && dem_exchange_slip_factor(1.0, 1) == 1.0,
           "slip factor without particles");
    TAP_OK(dem_exchange_slip_factor(-0.2, 0) == dem_exchange_slip_factor(0.1, 0),
           "bounded at void fraction 0");

    /* b = 2e-6 kg/s for T = 1e-3 s at u = 0.5, v = 0.2 m/s held still: J = b T (u - v), R = B =
       b T */
    const double T = 1e-3, B = 2e-6*T, u = 0.5, v = 0.2, J = B*(u - v), K = B/T;

    TAP_NEAR(dem_exchange_force(K, u, J, T) - K*u, -J/T, 1e-15*K,
             "-J/T at the previous velocity");
    TAP_NEAR(dem_exchange_force(K, u, J, T) - K*(u + 0.1), -(J + B*0.1)/T, 1e-15*K,
             "R du more at another velocity");

    /* 8 spheres of d = 1, one of d = 2: sum d^3/sum d^2 = 16/12 */
    TAP_NEAR(dem_exchange_sauter(8.0 + 8.0, 8.0 + 4.0), 4.0/3.0, 1e-15, "Sauter's mean");
    TAP_OK(dem_exchange_sauter(0.0, 0.0) == 0.0 && dem_exchange_sauter(-1e-30, 1e-40) == 0.0,
           "Sauter mean without particles: 0");

    /* bubbles at e = 0.7, C = 1/2: 0.3/0.7/(2*0.5) (2 + sqrt(4 - 1)) = 1.5995, rho_p/rho = 0 */
    TAP_NEAR(1.0/dem_exchange_under_relaxation(0.7, 0.0, 0.5, 0.0) - 1.0,
             0.3/0.7*(2.0 + sqrt(3.0)), 1e-14, "the eigenvalue of bubbles");
    TAP_NEAR(1.0/dem_exchange_under_relaxation(0.5, 0.25, 0.0, 0.0) - 1.0, 4.0, 1e-14,
             "and without added mass: the density ratio's");
    TAP_OK(dem_exchange_under_relaxation(1.0, 0.001, 0.5, 0.0) == 1.0 &&
               dem_exchange_under_relaxation(0.4, 0.001, 0.5, 1.0) == 1.0,
           "none of a single particle, and none where drag transmits all");
    suspensions();
    TAP_DONE;
}
