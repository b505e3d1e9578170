/*
 * test_heat_transfer.c -- gunn, ranzMarshall and wakao have the Nusselt numbers of their formulas,
 * computed in another program, and depend on the slip alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "bodies.h"
#include "scalar_columns.h"

enum
{
    LAWS = 3
};

static const struct dem_effect *const law[LAWS] = {&dem_gunn, &dem_ranz_marshall, &dem_wakao};

/* e, superficial Re (ranzMarshall has Re/e), Pr, Nu of each law */
static const struct
{
    double e, re, pr, nu[LAWS];
} table[] = {
    {1.00,    0.1,   0.7, {2.8074, 2.1685, 2.2453}},
    {1.00,  100.0,   0.7, {8.0218, 7.3274, 17.480}},
    {0.40,    1.0,   0.7, {6.6608, 2.8423, 2.9767}},
    {0.40,   50.0,   0.7, {16.680, 7.9562, 12.213}},
    {0.40, 1000.0,   0.7, {76.023, 28.637, 63.625}},
    {0.60,   50.0,   7.0, {20.523, 12.478, 24.003}},
    {0.60, 3000.0,   7.0, {188.71, 83.159, 258.66}},
    {0.90,   20.0, 100.0, {19.543, 15.128, 32.809}},
    {0.35, 8000.0,   0.7, {324.80, 82.543, 216.59}},
};

static const double d = 1e-3, rho = 1000.0, mu = 1e-3, pi = 3.14159265358979324;
static struct dem_body_batch b;

/* one row of a sphere of 1 mm; its slip is turned into `axis`. Pr = mu c_f/k_f */
static void fill(double e, double re, double pr, double fluid_temperature, double conductivity,
                 int axis)
{
    memset(&b, 0, sizeof b);
    b.n = 2;                                              /* the second row is empty */
    body_fill(&b, 0, d, rho, mu, e, re);
    const double slip = b.ux[0], turned[3] = {axis == 0 ? slip : 0.0, axis == 1 ? slip : 0.0,
                                              axis == 2 ? slip : 0.0};

    b.vx[0] = 3.0, b.vy[0] = -2.0, b.vz[0] = 1.0;
    b.ux[0] = b.vx[0] + turned[0], b.uy[0] = b.vy[0] + turned[1], b.uz[0] = b.vz[0] + turned[2];
    scalar_columns_bodies(&b);
    scalar_columns.value[0][0][0] = 300.0;
    scalar_columns.value[0][1][0] = fluid_temperature;
    scalar_columns.value[0][2][0] = conductivity;
    scalar_columns.value[0][3][0] = pr*conductivity/mu;
}

static double coefficient(int k, double e, double re, double pr, int axis)
{
    fill(e, re, pr, 350.0, 0.6, axis);
    dem_effect_apply_to_bodies(law[k], NULL, &b);
    return scalar_columns.result[1][0][0];
}

/* Nu = B/(pi d k_f) */
static double nusselt(int k, double e, double re, double pr)
{
    return coefficient(k, e, re, pr, 0)/(pi*d*0.6);
}

static void formula(int k)
{
    int falls = 0;

    for (size_t n = 0; n < sizeof table/sizeof table[0]; n++)
    {
        TAP_NEAR(nusselt(k, table[n].e, table[n].re, table[n].pr)/table[n].nu[k], 1.0, 5e-5,
                 "%s: e = %g, Re = %g, Pr = %g", law[k]->name, table[n].e, table[n].re,
                 table[n].pr);
    }
    for (double e = 0.35; e < 1.0; e += 0.05)
    {
        for (double re = 1e-9, before = nusselt(k, e, 0.0, 0.7); re < 1e5; re *= 4.0)
        {
            const double now = nusselt(k, e, re, 0.7);

            falls += !(now >= before);
            before = now;
        }
    }
    TAP_OK(falls == 0, "%s: grows with the slip", law[k]->name);
    TAP_NEAR(nusselt(k, 1.0, 0.0, 0.7), 2.0, 1e-14, "%s: Nu = 2 for a single sphere at rest",
             law[k]->name);
    /* 7 - 10 e + 5 e^2 */
    TAP_NEAR(nusselt(k, 0.4, 0.0, 0.7), k == 0 ? 3.8 : 2.0, 1e-14, "%s: at rest in a bed",
             law[k]->name);
}

static void form(int k)
{
    const double along = coefficient(k, 0.6, 24.0, 0.7, 0);

    for (int axis = 1; axis < 3; axis++)
    {
        /* 0.04 is 3.04 - 3, with a rounding of 1e-14 */
        TAP_NEAR(coefficient(k, 0.6, 24.0, 0.7, axis)/along, 1.0, 1e-12,
                 "%s: the slip along axis %d alone", law[k]->name, axis);
    }
    TAP_OK(scalar_columns.result[2][0][0] == scalar_columns.result[1][0][0]*350.0 &&
               scalar_columns.result[0][0][0] == 0.0,
           "%s: the target is the fluid's temperature, and there is no explicit rate", law[k]->name);
    TAP_OK(scalar_columns.result[1][0][1] == 0.0 && scalar_columns.result[2][0][1] == 0.0,
           "%s: nothing in an empty row", law[k]->name);
    TAP_OK(b.drag[0] == 0.0 && b.fx[0] == 0.0 && b.rx[0] == 0.0 && b.spin_drag[0] == 0.0,
           "%s: no force",
           law[k]->name);
    fill(0.6, 24.0, 0.0, 350.0, 0.0, 0);
    dem_effect_apply_to_bodies(law[k], NULL, &b);
    TAP_OK(scalar_columns.result[1][0][0] == 0.0, "%s: nothing without conductivity",
           law[k]->name);
    TAP_OK(coefficient(k, 0.1, 5.0, 0.7, 0) > 0.0 &&
               nusselt(k, 1.1, 0.0, 0.7) == nusselt(k, 1.0, 0.0, 0.7),
           "%s: void fractions out of range", law[k]->name);
}

int main(void)
{
    TAP_TRAPS;
    for (int k = 0; k < LAWS; k++)
    {
        formula(k);
        form(k);
    }
    TAP_DONE;
}
