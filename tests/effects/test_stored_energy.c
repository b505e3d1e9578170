/*
 * test_stored_energy.c -- the force of normal laws and adhesion is the slope of the stored energy;
 * work is stored or lost. The energies of jkr: physics/test_jkr.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "law_rows.h"

static const struct dem_material bead = {"bead", 2500.0, 1e7, .poissons_ratio = 0.3};
static const double pi = 3.14159265358979324;
static struct law_rows w;
static struct dem_energy e;

static void start(void)
{
    rows_spheres(&w, &bead, &bead, 1e-3, 1e-3);
    w.b.n = 1;
    w.b.dt = w.b.max_dt = 1e-6;
    w.b.reduced_radius[0] = w.pair.min_radius;
    w.b.reduced_mass[0] = w.pair.min_mass;
    w.b.min_radius[0] = 1e-3;
    w.b.nz[0] = w.b.hz[0] = w.b.is_primary[0] = 1.0;
}

/* normal force, stored and lost energy at this gap; bonded: bond_replaces of the batch */
static double evaluate(double gap, double bonded, double *stored, double *lost)
{
    w.b.gap[0] = gap;
    w.b.distance[0] = 2e-3 + gap;
    w.b.overlap[0] = gap < 0.0 ? -gap : 0.0;
    w.b.touching[0] = gap < 0.0 ? 1.0 : 0.0;
    w.b.kn[0] = w.b.kt[0] = w.b.eta[0] = w.b.fn[0] = w.b.stored[0] = w.b.lost[0] = 0.0;
    w.b.adhesive_force[0] = w.b.scratch[0] = 0.0;
    *stored = *lost = 0.0;
    for (int k = 0; k < w.effects; k++)
    {
        struct rows_effect *const l = &w.effect_entry[k];
        double held[ROWS_HISTORY], *before[ROWS_HISTORY];

        for (int m = 0; m < ROWS_HISTORY; m++)
        {
            held[m] = l->column[m][0];
            before[m] = &held[m];
        }
        w.b.bond_replaces[0] = 0.0;
        if (l->effect->set_adhesion)
        {
            l->effect->set_adhesion(l->settings, &w.b, l->history);
        }
        w.b.bond_replaces[0] = bonded;                    /* a bond is made after set_adhesion */
        l->effect->apply(l->settings, &w.b, l->history);
        e.stored[0] = l->effect->stage == DEM_STAGE_FILM ? w.b.stored[0] : 0.0;
        e.lost[0] = l->effect->stage == DEM_STAGE_FILM ? w.b.lost[0] : 0.0;
        l->effect->energy(l->settings, &w.b, before, l->history, &e);
        *stored += e.stored[0];
        *lost += e.lost[0];
    }
    return w.b.fn[0];
}

/* after loading to `deepest`, at overlaps from `from` to `to`: F = dU/dd, by central differences
   that are exact to (h/d)^2 */
static void slope(const char *name, double deepest, double from, double to)
{
    double worst = 0.0, lost, U, unused;

    evaluate(-1e-9, 0.0, &U, &lost);
    evaluate(-deepest, 0.0, &U, &lost);
    for (int k = 0; k < 9; k++)
    {
        const double d = from + (to - from)*k/8.0, h = 1e-4*fabs(to - from);
        double low, high;

        evaluate(-(d - h), 0.0, &low, &lost);
        evaluate(-(d + h), 0.0, &high, &lost);
        const double F = evaluate(-d, 0.0, &U, &unused);

        worst = fmax(worst, fabs((high - low)/(2.0*h*F) - 1.0));
    }
    TAP_OK(worst < 1e-5, "%s: the force is the slope of the stored energy, within %.2g", name,
           worst);
}

static void stores(void)
{
    start();
    rows_add(&w, &dem_hertz, "impactSpeed", 1.0);
    slope("hertz", 1e-5, 2e-6, 1e-5);
    start();
    rows_add(&w, &dem_hooke, "stiffness", 1e3);
    slope("hooke", 1e-5, 2e-6, 1e-5);
    start();
    struct rows_effect *const l = rows_add(&w, &dem_hooke_hysteresis, "unloading", 4.0);

    apply_setting(l->effect, l->settings, &w.pair, "stiffness", 1e3);
    apply_setting(l->effect, l->settings, &w.pair, "adhesion", 0.5);
    slope("hookeHysteresis", 1e-5, 8e-6, 9.9e-6);
    start();
    rows_add(&w, &dem_hertz, "impactSpeed", 1.0);
    rows_add(&w, &dem_sjkr, "energyDensity", 1e4);
    slope("hertz and sjkr", 1e-5, 2e-6, 1e-5);
    start();
    rows_add(&w, &dem_hertz, "impactSpeed", 1.0);
    rows_add(&w, &dem_jkr, "workOfAdhesion", 0.5);
    slope("jkr in contact", 1e-4, 5e-5, 1e-4);
    slope("jkr on its tail", 1e-5, -2e-6, -1e-6);
}

/* ---- hookeHysteresis ------------------------------------------------------------------------- */

/* turning points over d_lim = 4/3 phi 2 R* = 1.3333e-5 m; the force is linear in between but for
   kinks, which are met with (d/steps)^2 */
static void yields(double adhesion)
{
    static const double turn[] = {0.6, 0.45, 0.55, 0.3, 0.5, 0.9, 0.7, 1.4, 0.8, 1.2, 0.2, 0.5,
                                  0.01};
    const double d_lim = 4.0/3.0*0.01*2.0*0.5e-3;
    double from = 0.0, F = 0.0, held = 0.0, work = 0.0, spent = 0.0, worst = 0.0, scale = 0.0;

    start();
    struct rows_effect *const l = rows_add(&w, &dem_hooke_hysteresis, "unloading", 4.0);

    apply_setting(l->effect, l->settings, &w.pair, "stiffness", 1e3);
    apply_setting(l->effect, l->settings, &w.pair, "adhesion", adhesion);
    apply_setting(l->effect, l->settings, &w.pair, "plasticDepth", 0.01);
    for (size_t k = 0; k < sizeof turn/sizeof *turn; k++)
    {
        const double to = turn[k]*d_lim;

        for (int s = 1; s <= 2000; s++)
        {
            const double d = from + (to - from)*s/2000.0, step = (to - from)/2000.0;
            double lost;
            const double now = evaluate(-d, 0.0, &held, &lost);

            work += 0.5*(F + now)*step;
            spent += lost;
            F = now;
            scale = fmax(scale, held);
        }
        from = to;
        worst = fmax(worst, fabs(work - held - spent));
    }
    TAP_NEAR(worst/scale, 0.0, 1e-5,
             "hookeHysteresis, k_c/k %g: the work is stored or lost at each of 13 turns", adhesion);
    TAP_OK(spent > 0.1*scale,
           "hookeHysteresis, k_c/k %g: %.3g of the largest stored energy is lost", adhesion,
           spent/scale);
}

/* The force of jkr jumps at touching and at the end of its tail, 3 a_t^2/R: so does the stored energy,
   and the difference is lost. */
static void jkr_jumps(void)
{
    const double R = 0.5e-3;
    double U, lost, at_end;

    start();
    rows_add(&w, &dem_hertz, "impactSpeed", 1.0);
    rows_add(&w, &dem_jkr, "workOfAdhesion", 0.5);
    const double a = cbrt(pi*0.5*R*R/(8.0*w.pair.reduced_modulus)), tail = 3.0*a*a/R;

    evaluate(1e-6, 0.0, &U, &lost);
    TAP_OK(lost == 0.0 && U == 0.0, "jkr: nothing before touching");
    evaluate(-1e-15, 0.0, &U, &lost);
    TAP_NEAR(lost/-U, 1.0, 1e-4, "jkr: lost at touching");    /* six digits in the law */
    evaluate(tail*(1.0 - 1e-9), 0.0, &at_end, &lost);
    TAP_OK(lost == 0.0 && at_end > 0.0, "jkr: nothing is lost on the tail");
    evaluate(tail*(1.0 + 1e-9), 0.0, &U, &lost);
    /* the slope of the energy is vertical there: sqrt(1e-9) */
    TAP_NEAR(lost/at_end, 1.0, 1e-4, "jkr: lost at separation");
    TAP_OK(U == 0.0, "jkr: nothing stored after separation");
}

static void sealed(void)
{
    const double d = 1e-6, density = 1e4, R = 0.5e-3, held = -pi*density*R*d*d;
    double U, lost, U_hertz;

    start();
    rows_add(&w, &dem_hertz, "impactSpeed", 1.0);
    evaluate(-d, 0.0, &U_hertz, &lost);
    rows_add(&w, &dem_sjkr, "energyDensity", density);
    evaluate(-d, 0.0, &U, &lost);
    TAP_NEAR((U - U_hertz)/held, 1.0, 1e-10, "sjkr: -pi w R* d^2 is stored");
    TAP_OK(lost == 0.0, "sjkr: nothing is lost");
    evaluate(-d, 2.0, &U, &lost);
    TAP_NEAR(lost/held, 1.0, 1e-12, "sjkr: lost where a bond replaces the contact");
    TAP_NEAR(U/U_hertz, 1.0, 1e-12, "sjkr: nothing is stored then");
    evaluate(-d, 1.0, &U, &lost);
    TAP_OK(lost == 0.0, "sjkr: lost once");
}

int main(void)
{
    TAP_TRAPS;
    stores();
    yields(0.0);
    yields(0.5);
    jkr_jumps();
    sealed();
    TAP_DONE;
}
