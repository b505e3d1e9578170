/*
 * test_bond_linear.c -- stresses at which a bond breaks, and its forces, for one contact row.
 *
 * - In tension, shear, twist and bending it breaks where the stress of a beam of circular section,
 *   k_n elongation, k_t slip, k_t twist r_b and k_n bending r_b, reaches the strength, also with
 *   strengthRatio, absNormal, breakDistance and internalFriction; 1e-6 before it holds.
 * - Until then its forces and moments are k_n A, k_t A, k_t pi r_b^4/2 and k_n pi r_b^4/4 times
 *   the deformation, and their energy is stored.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/bond/bond_springs.h"
#include "law_rows.h"

enum
{
    COLUMNS = 10
};

static const struct dem_material rock = {"rock", 2500.0, 1e9, .poissons_ratio = 0.25};
static const double pi = 3.14159265358979324, kn = 5e11, kt = 2e11, R = 1e-3, lambda = 0.8,
                    strength = 1e6;
static struct law_rows w;
static _Alignas(64) double column[COLUMNS][DEM_BATCH_ROWS];
static double *history[COLUMNS];
static double settings[64];

static void prepare(const char *const *names, const double *values, int n)
{
    const struct dem_effect *const bond = &dem_bond_linear;

    rows_spheres(&w, &rock, &rock, R, R);
    w.pair.exponent = 1.5;
    if (bond->size > sizeof settings)
    {
        printf("Bail out! settings of bondLinear are larger than the test's buffer\n");
        exit(1);
    }
    dem_settings_set_defaults(bond->settings, settings);
    for (int k = 0; k < n; k++)
    {
        dem_settings_set_number(bond->settings, settings, bond->name, names[k], &values[k], 1);
    }
    if (bond->prepare(settings, &w.pair))
    {
        printf("Bail out! %s\n", dem_error_text());
        exit(1);
    }
}

/* one bond, stretched, sheared, twisted and bent by these */
static void deform(double stretched, double slip, double twist, double bend)
{
    struct dem_contact_batch *const b = &w.b;

    memset(b, 0, sizeof *b);
    memset(column, 0, sizeof column);
    for (int k = 0; k < COLUMNS; k++)
    {
        history[k] = column[k];
    }
    b->n = 1;
    b->dt = b->max_dt = 1e-9;
    b->time = 1.0, b->previous_time = 1.0;                /* none is made */
    b->nz[0] = b->hz[0] = b->is_primary[0] = 1.0;
    b->distance[0] = 2.0*R + stretched;
    b->gap[0] = stretched;
    b->reduced_radius[0] = 0.5*R, b->min_radius[0] = R, b->reduced_mass[0] = w.pair.min_mass;
    column[DEM_BOND_LENGTH][0] = 2.0*R;
    column[DEM_BOND_SHEAR][0] = slip;
    column[DEM_BOND_TWIST][0] = twist;
    column[DEM_BOND_BEND][0] = bend;
    dem_bond_linear.apply(settings, b, history);
}

static void breaks(const char *what, double stretched, double slip, double twist, double bend)
{
    const double less = 1.0 - 1e-6, more = 1.0 + 1e-6;

    deform(stretched*(stretched < 0.0 ? 1.0 : less), slip*less, twist*less, bend*less);
    TAP_OK(w.b.bonds[0] == 1.0 && w.b.broke[0] == 0.0, "%s: holds 1e-6 before", what);
    deform(stretched*(stretched < 0.0 ? 1.0 : more), slip*more, twist*more, bend*more);
    TAP_OK(w.b.bonds[0] == 0.0 && w.b.broke[0] == 1.0, "%s: broken 1e-6 beyond", what);
}

static void strengths(void)
{
    const char *names[] = {"normalStiffness", "shearStiffness", "radius", "normalStrength",
                           "shearStrength", "strengthRatio", "internalFriction"};
    double values[] = {kn, kt, lambda, strength, strength, 1.0, 0.0};
    const double r = lambda*R;

    prepare(names, values, 7);
    breaks("tension", strength/kn, 0.0, 0.0, 0.0);
    breaks("shear", 0.0, strength/kt, 0.0, 0.0);
    breaks("twist", 0.0, 0.0, strength/(kt*r), 0.0);
    breaks("bending", 0.0, 0.0, 0.0, strength/(kn*r));
    breaks("tension and bending", 0.4*strength/kn, 0.0, 0.0, 0.6*strength/(kn*r));
    breaks("shear and twist", 0.0, 0.4*strength/kt, 0.6*strength/(kt*r), 0.0);
    values[5] = 1.7;
    prepare(names, values, 7);
    breaks("tension, strengthRatio 1.7", 1.7*strength/kn, 0.0, 0.0, 0.0);
    values[6] = 0.6;
    prepare(names, values, 7);
    breaks("shear under compression, internalFriction 0.6", -0.5*strength/kn,
           1.3*strength/kt, 0.0, 0.0);
    values[3] = 0.0;
    prepare(names, values, 7);
    breaks("tension, no shear strength left", strength/0.6/kn, 0.0, 0.0, 0.0);
    breaks("shear under tension", 0.5*strength/kn, 0.7*strength/kt, 0.0, 0.0);
    values[6] = 0.0;
    prepare(names, values, 7);
    breaks("shear, no normalStrength", 0.0, strength/kt, 0.0, 0.0);
}

static void other_limits(void)
{
    const char *names[] = {"normalStiffness", "shearStiffness", "radius", "normalStrength"};
    const double values[] = {kn, kt, lambda, strength}, far = 2.0*R*(1.01 - 1.0), distance = 1.01;

    prepare(names, values, 4);
    deform(-2.0*strength/kn, 0.0, 0.0, 0.0);
    TAP_OK(w.b.bonds[0] == 1.0, "compression does not break a bond");
    dem_settings_set_word(dem_bond_linear.settings, settings, "bondLinear", "absNormal", "yes");
    TAP_OK(dem_bond_linear.prepare(settings, &w.pair) == DEM_OK, "absNormal");
    deform(-(1.0 - 1e-6)*strength/kn, 0.0, 0.0, 0.0);
    TAP_OK(w.b.bonds[0] == 1.0, "compression with absNormal: holds 1e-6 before");
    deform(-(1.0 + 1e-6)*strength/kn, 0.0, 0.0, 0.0);
    TAP_OK(w.b.broke[0] == 1.0, "compression with absNormal: broken 1e-6 beyond");
    prepare(names, values, 3);
    dem_settings_set_number(dem_bond_linear.settings, settings, "bondLinear", "breakDistance", &distance, 1);
    TAP_OK(dem_bond_linear.prepare(settings, &w.pair) == DEM_OK, "breakDistance");
    breaks("distance", far, 0.0, 0.0, 0.0);
}

static void forces(void)
{
    const char *names[] = {"normalStiffness", "shearStiffness", "radius"};
    const double values[] = {kn, kt, lambda}, r = lambda*R, A = pi*r*r, u = 1e-6, theta = 1e-3;

    prepare(names, values, 3);
    deform(u, 2.0*u, 0.0, 0.0);
    /* rounding of the distance, 2e-19 of 1e-6 */
    TAP_NEAR(w.b.fn[0]/(-kn*A*u), 1.0, 1e-12, "F_n = -k_n A elongation");
    TAP_NEAR(w.b.fx[0]/(-kt*A*2.0*u), 1.0, 1e-12, "F_t = -k_t A slip");
    TAP_NEAR(w.b.stored[0]/(0.5*A*u*u*(kn + 4.0*kt)), 1.0, 1e-12, "their energy is stored");
    deform(0.0, 0.0, theta, 2.0*theta);
    TAP_NEAR(w.b.mz[0]/(-kt*pi*r*r*r*r/2.0*theta), 1.0, 1e-12, "T_n = -k_t J twist");
    TAP_NEAR(w.b.mx[0]/(-kn*pi*r*r*r*r/4.0*2.0*theta), 1.0, 1e-12, "T_t = -k_n I bending");
    TAP_NEAR(w.b.stored[0]/(0.5*pi*r*r*r*r*theta*theta*(kt/2.0 + kn)), 1.0, 1e-12,
             "their energy is stored");
}

/* meets[k]: 1 where the rows come within makeDistance at step k, 0 where they are apart; returns
   how many of 20 x 64 pairs are bonded at the end */
static int bonded_after(int redraw, const int *meets, int steps)
{
    const char *names[] = {"normalStiffness", "shearStiffness", "probability", "seed"};
    const double values[] = {kn, kt, 0.3, 5.0};
    struct dem_contact_batch *const b = &w.b;
    int bonded = 0;

    for (int block = 0; block < 20; block++)
    {
        prepare(names, values, 4);
        dem_settings_set_word(dem_bond_linear.settings, settings, "bondLinear", "make", "always");
        dem_settings_set_word(dem_bond_linear.settings, settings, "bondLinear", "redraw",
                              redraw ? "yes" : "no");
        TAP_OK(dem_bond_linear.prepare(settings, &w.pair) == DEM_OK, "block %d", block);
        deform(0.0, 0.0, 0.0, 0.0);
        memset(column, 0, sizeof column);
        b->n = DEM_BATCH_ROWS;
        for (int s = 0; s < steps; s++)
        {
            b->previous_time = b->time;
            b->time = 1.0 + 1e-9*s;
            for (int c = 0; c < b->n; c++)
            {
                b->nz[c] = b->hz[c] = b->is_primary[c] = 1.0;
                b->distance[c] = (meets[s] ? 2.0 : 2.01)*R;
                b->gap[c] = b->distance[c] - 2.0*R;
                b->reduced_radius[c] = 0.5*R, b->min_radius[c] = R,
                b->reduced_mass[c] = w.pair.min_mass;
                b->pair_random[c] = (block*DEM_BATCH_ROWS + c + 0.5)/(20.0*DEM_BATCH_ROWS);
            }
            dem_bond_linear.apply(settings, b, history);
        }
        for (int c = 0; c < b->n; c++)
        {
            bonded += column[DEM_BOND_LENGTH][c] > 0.0;
        }
    }
    return bonded;
}

/* p = 0.3: after three meetings 1 - 0.7^3 = 0.657 of the pairs are bonded when each is drawn again,
   and 0.3 when they are drawn once; staying near is one meeting. Four standard deviations. */
static void drawn_again(void)
{
    static const int three[] = {1, 1, 1, 0, 1, 1, 0, 0, 1}, stays[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    const double n = 20.0*DEM_BATCH_ROWS, once = 4.0*sqrt(0.3*0.7/n), again = 4.0*sqrt(0.657*0.343/n);

    TAP_NEAR(bonded_after(0, three, 9)/n, 0.3, once, "drawn once, three meetings");
    TAP_NEAR(bonded_after(1, stays, 9)/n, 0.3, once, "redraw, one long meeting");
    TAP_NEAR(bonded_after(1, three, 9)/n, 0.657, again, "redraw, three meetings");
}

int main(void)
{
    TAP_TRAPS;
    strengths();
    other_limits();
    forces();
    drawn_again();
    TAP_DONE;
}
