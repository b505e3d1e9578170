/*
 * test_virtual_mass.c -- added mass.
 *
 * - Half the displaced fluid for a single sphere, Zuber's and Felderhof's in a suspension, and
 *   never negative.
 * - The reported force is the added mass times the fluid's acceleration, and the fluid gets the
 *   opposite.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "bodies.h"

static double settings[4];

/* C of a sphere of this density ratio in a suspension of this void fraction */
static double C(const char *swarm, double e, double ratio)
{
    static struct dem_body_batch b;

    dem_settings_set_defaults(dem_virtual_mass.settings, settings);
    dem_settings_set_word(dem_virtual_mass.settings, settings, "virtualMass", "swarm", swarm);
    memset(&b, 0, sizeof b);
    b.n = 1;
    body_fill(&b, 0, 2e-3, 800.0, 1e-3, e, 5.0);
    b.mass[0] = ratio*800.0*b.volume[0];
    dem_virtual_mass.prepare_bodies(settings, &b);
    return b.added_mass[0]/(800.0*b.volume[0]);
}

int main(void)
{
    static struct dem_body_batch b;
    int negative = 0;

    TAP_TRAPS;
    /* rounding in all of these */
    TAP_NEAR(C("none", 1.0, 2.5), 0.5, 1e-15, "half the displaced fluid");
    TAP_NEAR(C("none", 0.5, 2.5), 0.5, 1e-15, "independent of the void fraction by default");
    TAP_NEAR(C("zuber", 1.0, 2.5), 0.5, 1e-15, "Zuber: a single sphere");
    TAP_NEAR(C("zuber", 0.7, 2.5), 0.5*1.6/0.7, 1e-14, "Zuber: 0.3 of solid");
    TAP_NEAR(C("zuber", 0.99, 2.5), 0.5 + 1.5*0.01, 2e-4,
             "Zuber: to first order 1/2 + 3/2 s");      /* the next is 3/2 s^2 */
    TAP_NEAR(C("felderhof", 1.0, 0.001), 0.5, 1e-15, "Felderhof: a single sphere");
    TAP_NEAR(C("felderhof", 0.7, 1.0), 0.5 + 0.13*0.3 - 0.58*0.09 + 1.42*0.027, 1e-14,
             "Felderhof: as dense as the fluid");
    TAP_NEAR(C("felderhof", 0.8, 2.5),
             0.5 + (0.047*log(2.5) + 0.13)*0.2 - (0.066*log(2.5) + 0.58)*0.04 +
                 1.42*0.008,
             1e-14, "Felderhof: 2.5 times as dense");
    TAP_OK(C("zuber", 0.1, 1.0) == C("zuber", 0.2, 1.0) && C("zuber", 1.2, 1.0) == 0.5,
           "out of range: as at the limits");
    for (double e = 0.2; e <= 1.0; e += 0.05)
    {
        for (double ratio = 1e-6; ratio < 1e5; ratio *= 3.0)
        {
            negative += !(C("felderhof", e, ratio) >= 0.0);
        }
    }
    TAP_OK(negative == 0, "never negative");

    dem_settings_set_defaults(dem_virtual_mass.settings, settings);
    memset(&b, 0, sizeof b);
    b.n = 2;
    body_fill(&b, 0, 2e-3, 800.0, 1e-3, 0.9, 5.0);
    b.ax[0] = 3.0, b.ay[0] = -2.0, b.az[0] = 9.81;
    dem_effect_apply_to_bodies(&dem_virtual_mass, settings, &b);
    const double a = 0.5*800.0*b.volume[0];

    TAP_OK(b.added_mass[0] == a && b.rx[0] == a*3.0 && b.ry[0] == -a*2.0 && b.rz[0] == a*9.81,
           "a Du/Dt, in the column that the fluid receives");
    TAP_OK(b.fx[0] == 0.0 && b.drag[0] == 0.0, "in no other column");
    TAP_OK(b.added_mass[1] == 0.0 && b.rx[1] == 0.0, "an empty row: zero");
    TAP_OK(dem_virtual_mass.has_added_mass && dem_virtual_mass.has_reaction &&
               dem_virtual_mass.needs & DEM_NEEDS_ACCELERATION,
           "it needs the fluid's acceleration");
    TAP_DONE;
}
