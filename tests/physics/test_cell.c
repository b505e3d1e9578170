/*
 * test_cell.c -- periodic cells that deform: the flow is exact, stresses are held, the strength of a
 * packing of equal spheres is its closed form, energy is balanced, the same bits wherever particles are
 * wrapped and after a restart.
 *
 * Source: Thornton, Geotechnique 29 (1979) 441: a face-centred cubic packing compressed along [001] fails
 * at s_z/s_x = 2 (1 + mu)/(1 - mu) under equal side stresses, 3.7143 for mu = 0.3, and at 4.8812 in plane
 * strain; in a cell that has become shorter the planes of contact are steeper, by its strain.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"
#include <unistd.h>

enum
{
    SPHERES = 36
};

#define GLASS "materials { glass { density 2500; youngsModulus 1e8; poissonsRatio 0.3; } } effects { hertz { " \
              "impactSpeed 0.01; } dry { restitution 0.4; } mindlin { friction 0.3; } } "

static const double diameter = 1e-3, pressure = 100.0;
static char file[] = "/tmp/cell.XXXXXX", between[] = "/tmp/cell.XXXXXX";

/* ---- flow ------------------------------------------------------------------------------------ */

/* Particles that touch nothing: x follows the flow, u falls as exp(-D t). */
static void test_flow(void)
{
    static const struct dem_new_particle seeds[] = {
        {.position = {0.002, 0.003, 0.0071}, .diameter = 1e-3, .material = "glass", .id = 0},
        {.position = {0.008, 0.008, 0.0013}, .diameter = 1e-3, .material = "glass", .velocity = {0.0, 0.0, 0.05}, .id = 1}};
    struct dem *const d = world(
        GLASS "time { step 2.5e-6; } domain { x (0 0.01); y (0 0.01); z (0 0.01); periodic (x y z); cell { zz { rate "
        "-2; } } } ", 2, seeds);
    struct dem_cell_now c;

    world_run(d, 0.1);
    WORLD_TRY(dem_cell(d, &c));
    const double shorter = exp(-0.2);

    TAP_OK(fabs(c.length[2]/(0.01*shorter) - 1.0) < 1e-6 && fabs(c.length[0] - 0.01) < 1e-15,
           "a cell of rate -2/s is exp(-0.2) as long after 0.1 s: %.9g", c.length[2]/0.01);
    TAP_OK(fabs(world_at(d, 0).x[2]/c.length[2] - 0.71) < 1e-12, "a particle at rest in the flow keeps its place "
           "in the cell: %.15g", world_at(d, 0).x[2]/c.length[2]);
    TAP_OK(fabs(world_at(d, 1).v[2]/(0.05*exp(0.2)) - 1.0) < 1e-6, "its velocity relative to the flow grows as "
           "exp(-D t): %.9g", world_at(d, 1).v[2]/0.05);
    dem_free(d);
}

/* ---- a face-centred cubic packing ------------------------------------------------------------ */

/* Face-centred cubic, along [110], [-110] and [001]: 3 x 3 x 2 cells of two spheres, at the overlap of the
   pressure, with 12 contacts of each sphere. */
static void packing(struct dem_new_particle *seeds, double length[3])
{
    const double modulus = 1e8/(2.0*(1.0 - 0.09)), volume = diameter*diameter*diameter/sqrt(2.0);
    const double force = 3.0*pressure*volume/(6.0*diameter);
    const double overlap = cbrt(pow(force/(4.0/3.0*modulus*sqrt(0.25*diameter)), 2.0));
    const double near = diameter - overlap, edge[3] = {near, near, sqrt(2.0)*near};

    for (int k = 0; k < SPHERES; k++)
    {
        const int cell[3] = {k/2%3, k/6%3, k/18};

        seeds[k] = (struct dem_new_particle){.diameter = diameter, .material = "glass", .id = k};
        for (int a = 0; a < 3; a++)
        {
            seeds[k].position[a] = edge[a]*(cell[a] + 0.5*(k%2) + 0.25);
            length[a] = edge[a]*(a < 2 ? 3.0 : 2.0);
        }
    }
}

static struct dem *fcc(const char *cell, int energy)
{
    struct dem_new_particle seeds[SPHERES];
    double length[3];

    packing(seeds, length);
    const char *const scene = world_text(
        GLASS "time { maxStartOverlap 0.1; } domain { x (0 %.15g); y (0 %.15g); z (0 %.15g); periodic (x y z); cell "
        "{ %s } } ", length[0], length[1], length[2], cell);

    return energy ? energy_world(scene, SPHERES, seeds) : world(scene, SPHERES, seeds);
}

/* Compress along z; the largest s_z/s_x over what is exact at that strain, from the angle of the contacts:
   `over` of their tangent and the friction. */
static double strength(struct dem *d, double time, double (*exact)(double tangent), double *held)
{
    struct dem_cell_now c;
    double largest = 0.0;

    *held = 0.0;
    for (int k = 0; k < 100; k++)
    {
        world_run(d, time/100.0);
        WORLD_TRY(dem_cell(d, &c));
        /* of a contact between the layers: 1 at the start */
        const double tangent = c.length[2]/2.0/(c.length[0]/3.0*sqrt(2.0));

        largest = fmax(largest, c.stress[2]/c.stress[0]/exact(tangent));
        *held = k > 20 ? fmax(*held, fabs(c.stress[0]/-pressure - 1.0)) : *held;
    }
    return largest;
}

static double triaxial(double tangent)
{
    return 2.0*tangent*(tangent + 0.3)/(1.0 - 0.3*tangent);
}

/* At the start: the axis y keeps its length. */
static double plane_strain(double tangent)
{
    (void)tangent;
    return 4.8812;
}

static void test_strength(void)
{
    struct dem *d = fcc("xx { stress -100; } yy { stress -100; } zz { rate -0.04; } maxRate 2;", 1);
    double held;
    const double ratio = strength(d, 0.2, triaxial, &held);

    TAP_OK(fabs(ratio - 1.0) < 0.01, "a packing under equal side stresses fails at %.4f of 2 T (T + mu)/(1 - mu T), "
           "3.7143 at T = 1", ratio);
    TAP_OK(held < 2e-3, "the side stress is held to %.2g", held);
    TAP_OK(fabs(energy_term(d, "residual")) < 0.01*fabs(energy_term(d, "work_cell"))
               && energy_term(d, "work_cell") > 0.0,
           "the work of the cell, %.4g J, is in the balance, but for %.2g J", energy_term(d, "work_cell"),
           energy_term(d, "residual"));
    dem_free(d);
    d = fcc("xx { stress -100; } zz { rate -0.04; } maxRate 2;", 0);
    const double plane = strength(d, 0.06, plane_strain, &held);

    TAP_OK(fabs(plane - 1.0) < 0.01, "in plane strain at %.4f of 4.8812", plane);
    dem_free(d);
}

/* Three stresses are held while the packing is sheared across [100] and [010], the axes of the principal stresses
   p + s and p - s. It fails at p + s = (1 + mu)/(1 - mu) (p - s + p), Thornton's strength: s = (1 + 3 mu)/2 p. */
static void test_shear_strength(void)
{
    struct dem *const d = fcc("xx { stress -100; } yy { stress -100; } zz { stress -100; } xy { rate 0.05; } maxRate 2;", 0);
    struct dem_cell_now c;
    double held = 0.0, shear = 0.0;

    for (int k = 0; k < 50; k++)
    {
        world_run(d, 0.002);
        WORLD_TRY(dem_cell(d, &c));
        for (int a = 0; a < 3 && k > 10; a++)
        {
            held = fmax(held, fabs(c.stress[a]/-pressure - 1.0));
        }
        shear = fmax(shear, c.stress[3]/pressure);
    }
    TAP_OK(held < 2e-3, "normal stresses along three axes are held to %.2g in simple shear", held);
    TAP_OK(fabs(shear/0.95 - 1.0) < 0.01, "a packing in simple shear fails at %.4f of them, (1 + 3 mu)/2 = 0.95", shear);
    dem_free(d);
}

/* ---- simple shear ---------------------------------------------------------------------------- */

static double nearest(double x, double length)
{
    return x - length*rint(x/length);
}

/* A free particle keeps its velocity u_x + D y in space, also through the faces of y. */
static void test_shear_flow(void)
{
    static const struct dem_new_particle seeds[] = {
        {.position = {0.002, 0.003, 0.0071}, .diameter = 1e-3, .material = "glass", .id = 0},
        {.position = {0.008, 0.008, 0.0013}, .diameter = 1e-3, .material = "glass", .velocity = {0.0, 0.05, 0.0}, .id = 1}};
    struct dem *const d = world(
        GLASS "time { step 2.5e-6; } domain { x (0 0.01); y (0 0.01); z (0 0.01); periodic (x y z); cell { xy { rate "
        "2; } } } ", 2, seeds);
    struct dem_cell_now c;

    world_run(d, 0.1);
    WORLD_TRY(dem_cell(d, &c));
    const struct world_particle one = world_at(d, 0), two = world_at(d, 1);
    const double boxes = rint((two.x[1] - 0.013)/0.01);

    TAP_OK(fabs(c.shear - 0.2) < 1e-12 && fabs(one.x[0] - 0.002 - 0.2*0.003) < 1e-11 && fabs(one.x[1] - 0.003) < 1e-15,
           "a particle at rest in the flow moves with it: by %.9g m", one.x[0] - 0.002);
    TAP_OK(fabs(two.v[0] + 2.0*0.05*0.1) < 1e-9, "u_x of one that moves across falls by D u_y t: %.9g m/s", two.v[0]);
    TAP_OK(fabs(nearest(two.x[0] - 0.008 - 0.2*0.008 - boxes*0.2*0.01, 0.01)) < 1e-9,
           "and in space it goes straight, through a face that slides: off by %.2g m",
           nearest(two.x[0] - 0.008 - 0.2*0.008 - boxes*0.2*0.01, 0.01));
    dem_free(d);
}

/* Eight spheres in a small cell, or four copies of them in one that is twice as long and wide. */
static struct dem *lattice(int copies, double edge, int energy)
{
    struct dem_new_particle seeds[32];
    int n = 0;

    for (int c = 0; c < copies*copies; c++)
    {
        for (int k = 0; k < 8; k++, n++)
        {
            const double to[3] = {k%2, k/2%2, k/4}, cell[3] = {c%copies, c/copies, 0.0};

            seeds[n] = (struct dem_new_particle){.diameter = 1e-3, .material = "glass", .id = n};
            for (int a = 0; a < 3; a++)
            {
                seeds[n].position[a] = edge*(cell[a] + 0.5*to[a] + 0.25);
                seeds[n].velocity[a] = 0.3*sin(7.0*k + 3.0*a);
            }
        }
    }
    const char *const scene = world_text(
        GLASS "time { step 2.5e-6; } domain { x (0 %g); y (0 %g); z (0 %g); periodic (x y z); cell { xy { rate 150; } "
        "} } ", edge*copies, edge*copies, edge);

    return energy ? energy_world(scene, n, seeds) : world(scene, n, seeds);
}

static void test_copies(void)
{
    struct dem *const small = lattice(1, 2.4e-3, 1), *const large = lattice(2, 2.4e-3, 0);
    const double before = energy_term(small, "kinetic_translation");
    double off = 0.0, fastest = 0.0;

    world_run(small, 0.004);
    world_run(large, 0.004);
    for (int k = 0; k < 8; k++)
    {
        const struct world_particle one = world_at(small, k), two = world_at(large, k);

        for (int a = 0; a < 3; a++)
        {
            off = fmax(off, fabs(one.v[a] - two.v[a]));
            fastest = fmax(fastest, fabs(one.v[a]));
        }
    }
    TAP_OK(off < 1e-8*fastest && fastest > 0.01,
           "a sheared cell and four copies of it in one cell move alike: %.2g of %.3g m/s", off, fastest);
    TAP_OK(fabs(energy_term(small, "residual")) < 0.01*(before + energy_term(small, "work_cell")),
           "the work of the shear, %.3g J, is in the balance, but for %.2g J", energy_term(small, "work_cell"),
           energy_term(small, "residual"));
    dem_free(small);
    dem_free(large);
}

/* ---- bits ------------------------------------------------------------------------------------ */

#define GAS(cell) \
    GLASS "time { step 2.5e-6; } domain { x (0 0.008); y (-0.004 0.004); z (0 0.008); periodic (x y z); cell { " cell \
    " } } insert { a { type random; count 150; diameter 1e-3; min (0 -0.004 0); max (0.008 0.004 0.008); velocity (0.3 " \
    "-0.2 0.1); } } "

static const char gas[] = GAS("xx { stress -40; } yy { rate -1; } zz { rate 0.8; end 0.02; } maxRate 3;"),
                  sheared[] = GAS("xx { stress -40; } yy { rate -1; } xy { rate 50; start 0.001; } maxRate 3;");

static uint64_t gas_hash(const char *scene, int save, int reload)
{
    struct dem *d = world(scene, 0, NULL);

    for (int k = 1; k <= 30; k++)
    {
        world_run(d, 1e-3*k - world_tally(d).time);
        if (save && k%7 == 0)
        {
            WORLD_TRY(dem_save(d, file));    /* lists are made anew and particles wrapped after it */
        }
        if (reload && k == 14)
        {
            struct dem_case *const c = world_begin(scene);

            dem_free(d);
            WORLD_TRY(dem_case_load(c, file));
            d = world_start(c);
        }
    }
    const uint64_t hash = world_hash(d);

    dem_free(d);
    return hash;
}

static void test_bits(const char *what, const char *scene)
{
    const uint64_t one = gas_hash(scene, 0, 0), two = gas_hash(scene, 1, 0), three = gas_hash(scene, 1, 1);

    TAP_OK(one == two, "%s: the same bits whenever particles are wrapped: %016llx", what, (unsigned long long)one);
    TAP_OK(three == one, "%s: and after a restart in the middle: %016llx", what, (unsigned long long)three);
}

/* ---- a cell goes on in another scene ---------------------------------------------------------- */

#define BED(cell) \
    GLASS "time { step 2.5e-6; } domain { x (0 0.006); y (0 0.006); z (0 0.006); periodic (x y z); " cell " } insert { a " \
    "{ type random; count 130; diameter 1e-3; min (0 0 0); max (0.006 0.006 0.006); velocity (0.3 -0.2 0.1); } } "

static struct dem *load(const char *scene, const char *path)
{
    struct dem_case *const c = world_begin(scene);

    WORLD_TRY(dem_case_load(c, path));
    return world_start(c);
}

/* go on from the file; `again`: with a restart in between */
static struct dem *go_on(const char *scene, int again)
{
    struct dem *d = load(scene, file);

    world_run(d, 5e-4);
    if (again)
    {
        WORLD_TRY(dem_save(d, between));
        dem_free(d);
        d = load(scene, between);
    }
    world_run(d, 5e-4);
    return d;
}

static int same_run(const char *scene, const char *like, int again)
{
    struct dem *const one = go_on(scene, again), *const two = go_on(like, 0);
    const int same = world_hash(one) == world_hash(two);

    dem_free(one);
    dem_free(two);
    return same;
}

static double length_of(struct dem *d)
{
    struct dem_cell_now c = {.solid = 0.0};

    WORLD_TRY(dem_has_cell(d) ? dem_cell(d, &c) : DEM_OK);
    return c.length[0];
}

static void compress(struct dem_cell_now *c)
{
    struct dem *const d = world(BED("cell { xx { rate -20; } zz { rate -1; } xy { rate 30; } }"), 0, NULL);

    world_run(d, 0.004);
    WORLD_TRY(dem_save(d, file));
    WORLD_TRY(dem_cell(d, c));
    dem_free(d);
}

static void test_taken_out(void)
{
    struct dem_cell_now was;

    compress(&was);
    TAP_OK(same_run(BED("cell { zz { rate -1; } }"), BED("cell { xx { rate 0; } zz { rate -1; } xy { rate 0; } }"), 0),
           "without its entry at a restart an axis keeps its length, and shear its offset, as at the rate 0");
    TAP_OK(same_run(BED(""), BED("cell { xx { rate 0; } zz { rate 0; } xy { rate 0; } }"), 0),
           "and without the whole entry cell");
    struct dem_case *c = world_begin(BED("") "effects { gravity { acceleration (0 0 -9.81); } }");

    WORLD_TRY(dem_case_load(c, file));
    TAP_OK(world_status(c) == DEM_ERROR_INPUT && strstr(dem_error_text(), "lengths of 0.005538")
               && strstr(dem_error_text(), "effects/gravity"),
           "what does not go with a cell is refused: %s", dem_error_text());
    TAP_OK(same_run(BED(""), BED(""), 1), "the same bits with another restart in between");
}

static struct dem *start_from(const char *domain)
{
    struct dem *const d = world(world_text(GLASS "time { step 2.5e-6; } domain { %s periodic (x y z); } start { snapshot "
                                           "\"%s\"; } ", domain, file), 0, NULL);

    world_run(d, 1e-4);
    return d;
}

static int warns(struct dem *d, const char *words)
{
    const struct dem_run_info ahead = {.duration = 1e-3};
    const char *text;

    WORLD_TRY(dem_warnings(d, &ahead, 0, NULL, &text));
    return strstr(text, words) != NULL;
}

static void test_new_run(void)
{
    static const char *const box = "x (0 0.006); y (0 0.006); z (0 0.006);";

    struct dem_cell_now was;

    compress(&was);
    struct dem *d = start_from(world_text("%s cell { yy { rate 0; } }", box));

    TAP_OK(fabs(length_of(d)/was.length[0] - 1.0) < 1e-6 && !warns(d, "start: "),
           "a new run from the snapshot takes the lengths of its cell: %.9g m", length_of(d));
    dem_free(d);
    d = start_from(box);
    TAP_OK(fabs(length_of(d)/was.length[0] - 1.0) < 1e-6 && !warns(d, "start: "), "also without the entry cell: %.9g m",
           length_of(d));
    dem_free(d);
    d = start_from("x (0 0.012); y (0 0.006); z (0 0.006); cell { xx { rate 0; } }");
    TAP_OK(fabs(length_of(d)/0.012 - 1.0) < 1e-6 && warns(d, "has lengths of 0.005538") && warns(d, "of 0.012, 0.006 and"),
           "a domain of other lengths keeps them, with a warning: %.9g m", length_of(d));
    dem_free(d);
    d = start_from(world_text("x (0 %.9g); y (0 0.006); z (0 %.9g);", was.length[0], was.length[2]));
    TAP_OK(!dem_has_cell(d) && warns(d, "displaced by"), "a domain of these lengths is fixed; a warning names the offset");
    dem_free(d);
}

/* ---- refusals -------------------------------------------------------------------------------- */

static void test_refusals(void)
{
    static const char *const cases[][2] = {
        {"domain { z (0 1); cell { zz { rate 1; } } }", "not periodic along z"},
        {"domain { z (0 1); periodic (z); cell { zz { rate 1; stress 1; } } }", "both of rate"},
        {"domain { z (0 1); periodic (z); cell { zz { stress 1; } } }", "maxRate"},
        {"domain { z (0 1); periodic (z); cell { zz { rate 1; } maxRate 1; } }", "no axis has a stress"},
        {"domain { z (0 1); periodic (z); cell { } }", "none of xx, yy, zz, xy"},
        {"domain { y (0 1); periodic (y); cell { xy { rate 1; } } }", "not periodic along x and y"},
        {"domain { z (0 1); periodic (z); cell { zz { rate 1; } } } walls { w { type plane; material glass; point (0 "
         "0 0); normal (1 0 0); } }", "wall w"},
        {"domain { z (0 1); periodic (z); cell { zz { rate 1; } } } outlets { o { point (0 0 0); normal (1 0 0); } }",
         "outlets"},
        {"domain { x (0 1); y (0 1); periodic (x y); cell { xy { rate 1; } } } averages { a { min (0 0 0); max (1 1 1); "
         "cells (1 1 1); interval 1; } }", "averages"},
        {"domain { z (0 1); periodic (z); cell { zz { rate 1; } } } insert { a { type list; diameter 0.1; frozen yes; "
         "positions ((0 0 0.5)); } }", "frozen or driven"},
        {"domain { z (0 1); periodic (z); cell { zz { rate 1; } } } insert { a { type list; diameter 0.1; driven yes; "
         "positions ((0 0 0.5)); } }", "frozen or driven"}};

    for (size_t k = 0; k < sizeof cases/sizeof *cases; k++)
    {
        world_refused(world_text(GLASS "%s", cases[k][0]), cases[k][1]);
    }
    world_refused("materials { glass { density 2500; youngsModulus 1e7; } } effects { hertz {} gravity { acceleration "
                  "(0 0 -9.81); } } domain { z (0 1); periodic (z); cell { zz { rate 1; } } }", "gravity");
}

int main(void)
{
    world_make_file(file);
    world_make_file(between);
    test_flow();
    test_strength();
    test_shear_strength();
    test_shear_flow();
    test_copies();
    test_bits("two stresses", gas);
    test_bits("shear", sheared);
    test_taken_out();
    test_new_run();
    test_refusals();
    unlink(file);
    unlink(between);
    TAP_DONE;
}
