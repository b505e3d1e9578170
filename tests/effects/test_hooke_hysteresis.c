/*
 * test_hooke_hysteresis.c -- the hysteretic linear law (Luding 2008): a scripted path has the forces,
 * history and work of an independent program (hysteresis_loop.csv); k_m = k and phi = 0 are linear springs; friction has the limit mu (F_n + k_c d).
 * A pair that sticks: stability/22.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "law_rows.h"

static const struct dem_material bead = {"bead", 2500.0, 1e7, .poissons_ratio = 0.3};
static const double pi = 3.14159265358979324;
static struct law_rows w;

/* the reference pair: two spheres of 1 mm radius, k_m = 5 k, phi = 0.05, k from 1 m/s */
static const double k = 1090.8212625, d_lim = 6.25e-5;

static struct rows_effect *pair_of(double unloading, double adhesion, double depth)
{
    rows_spheres(&w, &bead, &bead, 1e-3, 1e-3);
    struct rows_effect *const l = rows_add(&w, &dem_hooke_hysteresis, "unloading", unloading);

    apply_setting(&dem_hooke_hysteresis, l->settings, &w.pair, "adhesion", adhesion);
    apply_setting(&dem_hooke_hysteresis, l->settings, &w.pair, "plasticDepth", depth);
    w.b.n = 1;
    w.b.dt = 1e-6;
    for (int c = 0; c < DEM_BATCH_ROWS; c++)
    {
        w.b.reduced_radius[c] = w.pair.min_radius;
        w.b.reduced_mass[c] = w.pair.min_mass;
    }
    return l;
}

/* the force of row 0 at this overlap; history is cleared where surfaces are apart, as in the
   core */
static double at(struct rows_effect *l, double overlap)
{
    w.b.overlap[0] = overlap > 0.0 ? overlap : 0.0;
    w.b.touching[0] = overlap > 0.0 ? 1.0 : 0.0;
    w.b.fn[0] = 0.0;
    l->effect->apply(l->settings, &w.b, l->history);
    l->column[0][0] *= w.b.touching[0];
    return w.b.fn[0];
}

/* to this overlap in 1000 increments, work by the trapezoidal rule */
static double load_to(struct rows_effect *l, double *from, double to, double *work)
{
    const double start = *from;
    double force = at(l, start);

    for (int s = 1; s <= 1000; s++)
    {
        const double next = start + (to - start)*s/1000.0, then = at(l, next);

        *work += 0.5*(force + then)*(next - *from);
        force = then;
        *from = next;
    }
    return force;
}

/* ---- the scripted path ----------------------------------------------------------------------- */

static void path(void)
{
    static const double turn[] = {0.5, 0.3, 0.5, 0.8, 0.2, 0.05, 0.4, 0.8, 1.0, 1.5,
                                  1.1, 0.7, 0.3, 0.1, 0.6, 1.2, 0.0, 0.2, 0.0};
    struct rows_effect *const l = pair_of(5.0, 1.0, 0.05);
    FILE *const table = fopen("effects/hysteresis_loop.csv", "r");
    double work = 0.0, before = 0.0, d = 0.0;
    double worst[3] = {0.0, 0.0, 0.0};
    int rows = 0;

    if (!TAP_OK(table && fscanf(table, "%*[^\n]\n%*[^\n]\n") == 0, "the table can be read"))
    {
        return;
    }
    for (int t = 0; t < 19; t++)
    {
        const double start = d;

        for (int s = 1; s <= 1000; s++)
        {
            const double next = start + (turn[t]*d_lim - start)*s/1000.0, force = at(l, next);
            double overlap, expected, largest, sum;

            work += 0.5*(before + force)*(next - d);
            before = force;
            d = next;
            if (s % 100 == 0 &&
                fscanf(table, "%lf,%lf,%lf,%*[^,],%lf", &overlap, &expected, &largest, &sum) == 4)
            {
                rows += fabs(overlap*d_lim - d) < 1e-9*d_lim;
                worst[0] = fmax(worst[0], fabs(force - expected));
                worst[1] = fmax(worst[1], fabs(l->column[0][0] - largest*d_lim)/d_lim);
                worst[2] = fmax(worst[2], fabs(work - sum));
            }
        }
    }
    fclose(table);
    TAP_OK(rows == 190, "%d of 190 rows", rows);
    /* nine digits printed; k and d_lim of this test have eleven */
    TAP_NEAR(worst[0], 0.0, 1e-8*k*d_lim, "forces");
    TAP_NEAR(worst[1], 0.0, 1e-8, "largest overlaps remembered");
    TAP_NEAR(worst[2], 0.0, 1e-8*k*d_lim*d_lim, "work");
}

/* ---- other claims -------------------------------------------------------------------------------- */

static void evaluated_twice(void)
{
    struct rows_effect *const l = pair_of(5.0, 1.0, 0.05);
    static const double turn[] = {0.7, 0.5, 0.2, 0.05, 0.3, 1.3, 0.8, 0.1};
    double worst = 0.0, d = 0.0, unused = 0.0;

    for (int t = 0; t < 8; t++)
    {
        const double force = load_to(l, &d, turn[t]*d_lim, &unused), largest = l->column[0][0];

        worst = fmax(worst, fabs(at(l, d) - force)/(k*d_lim));
        worst = fmax(worst, fabs(l->column[0][0] - largest)/d_lim);
    }
    /* rounding */
    TAP_NEAR(worst, 0.0, 1e-14, "a second evaluation changes nothing");
}

static void limits_of_law(void)
{
    struct rows_effect *l = pair_of(1.0, 1.0, 0.05);
    double d = 0.0, work = 0.0;

    TAP_NEAR(load_to(l, &d, d_lim, &work), k*d_lim, 1e-9*k*d_lim, "k_m = k: a linear spring");
    TAP_NEAR(load_to(l, &d, 0.5*d_lim, &work), 0.5*k*d_lim, 1e-9*k*d_lim, "also in unloading");
    TAP_NEAR(load_to(l, &d, 0.0, &work), 0.0, 1e-15, "without attraction");
    /* rounding of 3000 steps */
    TAP_NEAR(work, 0.0, 1e-12*k*d_lim*d_lim, "without loss");
    l = pair_of(5.0, 1.0, 0.0);
    d = 0.0;
    TAP_NEAR(load_to(l, &d, d_lim, &work), 5.0*k*d_lim, 1e-9*k*d_lim,
             "phi = 0: a linear spring of k_m");
    TAP_NEAR(load_to(l, &d, 0.5*d_lim, &work), 2.5*k*d_lim, 1e-9*k*d_lim, "also in unloading");

    l = pair_of(5.0, 1.0, 0.05);
    const char *why = "";
    const double limit = 0.05*pi*sqrt(w.pair.min_mass/(5.0*k));

    TAP_NEAR(dem_hooke_hysteresis.time_limit(l->settings, &w.pair, &why), limit, 1e-9*limit, "%s",
             why);    /* digits of k */
    apply_setting(&dem_hooke_hysteresis, l->settings, &w.pair, "stiffness", 100.0);
    TAP_NEAR(at(l, 1e-6), 1e-4, 1e-19, "a given stiffness");

    /* with dry the dashpot refers to k; clamped it does not change the attraction of adhesion */
    l = pair_of(5.0, 1.0, 0.05);
    struct rows_effect *const dry = rows_add(&w, &dem_dry, "restitution", 0.5);

    apply_setting(&dem_dry, dry->settings, &w.pair, "attraction", 1.0);
    d = 0.0;
    load_to(l, &d, 0.8*d_lim, &work);
    load_to(l, &d, 0.2*d_lim, &work);
    w.b.vn[0] = 0.01;
    const double loss = log(2.0),
                 eta = 2.0*loss/sqrt(pi*pi + loss*loss)*sqrt(k*w.pair.min_mass),
                 pull = w.b.fn[0];

    dem_dry.apply(dry->settings, &w.b, dry->history);
    /* digits of k */
    TAP_NEAR(w.b.eta[0], eta, 1e-9*eta, "dry: the dashpot refers to k");
    TAP_NEAR(w.b.fn[0], pull - 0.01*eta, 1e-12*k*d_lim,
             "dry, clamped: the attraction of %g N is not changed", pull);
    TAP_OK(pull < 0.0, "dry, clamped: this is an attraction");
}

/* with attraction none the contact never pulls, not even on the adhesive branch */
static void no_tension(void)
{
    double d = 0.0, work = 0.0;
    struct rows_effect *const l = pair_of(5.0, 1.0, 0.05), *const dry =
                                                                  rows_add(&w, &dem_dry,
                                                                              "restitution", 1.0);
    apply_setting(&dem_dry, dry->settings, &w.pair, "attraction", 2.0);
    load_to(l, &d, 0.8*d_lim, &work);
    load_to(l, &d, 0.2*d_lim, &work);
    TAP_OK(w.b.fn[0] < 0.0 && w.b.adhesive_force[0] > 0.0, "the spring pulls");
    dem_dry.apply(dry->settings, &w.b, dry->history);
    TAP_OK(w.b.fn[0] == 0.0 && w.b.adhesive_force[0] == 0.0,
           "no tension: no force, and none in the limit of friction");
}

/* the limit of friction is mu (F_n + k_c d): mu k_c d at zero normal force, zero at the strongest
   attraction; or mu max(F_n, 0) */
static void friction(void)
{
    struct rows_effect *const l = pair_of(5.0, 1.0, 0.05), *const friction_effect =
                                                                  rows_add(&w, &dem_linear,
                                                                              "friction", 0.4);
    double d = 0.0, work = 0.0, limit = 0.0;
    const double k_2 = 1.0 + 4.0*0.8,
                 balance = (1.0 - 1.0/k_2)*0.8*d_lim;    /* k_2 (d - d_max) + k d_max = 0 */

    load_to(l, &d, 0.8*d_lim, &work);
    for (int part = 0; part < 3; part++)
    {
        apply_setting(&dem_linear, friction_effect->settings, &w.pair, "adhesion",
                      part == 2 ? 0.0 : 1.0);
        load_to(l, &d, part == 1 ? 0.1*d_lim : balance, &work);
        limit = part == 0 ? 0.4*k*balance : 0.0;
        w.b.hz[0] = w.b.nz[0] = 1.0;
        w.b.nx[0] = w.b.ny[0] = w.b.hx[0] = w.b.hy[0] = 0.0;
        w.b.dt = 1.0, w.b.sx[0] = 1.0,
        w.b.sy[0] = w.b.sz[0] = w.b.fx[0] = w.b.fy[0] = w.b.fz[0] = 0.0;
        dem_linear.apply(friction_effect->settings, &w.b, friction_effect->history);
        TAP_NEAR(-w.b.fx[0], limit, 1e-6*k*d_lim, "friction at %g N: %g N", w.b.fn[0],
                 limit);     /* of 1000 increments of a leg */
        load_to(l, &d, 0.8*d_lim, &work);
    }
}

int main(void)
{
    TAP_TRAPS;
    friction();
    path();
    evaluated_twice();
    limits_of_law();
    no_tension();
    TAP_DONE;
}
