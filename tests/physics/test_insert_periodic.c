/*
 * test_insert_periodic.c -- insertion at periodic faces is uniform up to the face and overlaps no
 * image.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#define PHYSICS "materials { glass { density 2500; youngsModulus 1e5; } }" \
                "effects { hertz { } dry { restitution 0.3; } } time { step 1e-5; } "

enum
{
    MOST = 4000,
    PLANES = 10
};

/* m */
static const double diameter = 1e-3, radius = 5e-4, width = 0.012;

static struct
{
    size_t n;
    double x[MOST][3], length[3];
} got;

static void read_particles(struct dem *d)
{
    struct dem_view v;

    dem_view(d, &v);
    got.n = v.n;
    memcpy(got.length, v.period, sizeof got.length);
    for (size_t i = 0; i < v.n && i < MOST; i++)
    {
        memcpy(got.x[world_id(&v, i)], dem_at(v.position, v.stride, i), sizeof got.x[0]);
    }
}

/* the particles of a scene in a cube of this width, periodic along these axes */
static void insert(const char *periodic, const char *groups)
{
    struct dem *const d = world(world_text(
        "%s domain { min (0 0 0); max (%g %g %g); periodic (%s); } %s",
        PHYSICS, width, width, width, periodic, groups), 0, NULL);

    read_particles(d);
    dem_free(d);
}

/* from b, or its nearest image, to a */
static double difference(const double a[3], const double b[3], int k)
{
    const double r = a[k] - b[k];

    return got.length[k] > 0.0 ? r - got.length[k]*rint(r/got.length[k]) : r;
}

static double distance(const double a[3], const double b[3])
{
    double square = 0.0;

    for (int k = 0; k < 3; k++)
    {
        square += difference(a, b, k)*difference(a, b, k);
    }
    return sqrt(square);
}

/* diameters; the largest overlap of two of the same size, of all pairs of images */
static double overlap(void)
{
    double least = INFINITY;

    for (size_t i = 0; i < got.n; i++)
    {
        for (size_t j = 0; j < i; j++)
        {
            least = fmin(least, distance(got.x[i], got.x[j]));
        }
    }
    return 1.0 - least/diameter;
}

/* the largest difference of the area of spheres in a plane from its mean over the planes, as a
   fraction of the mean; the first plane is the periodic face */
static double unevenness(int axis)
{
    const double mean = (double)got.n*world_pi/6.0*diameter*diameter*diameter/width;
    double worst = 0.0;

    for (int p = 0; p < PLANES; p++)
    {
        const double plane[3] = {p*width/PLANES, p*width/PLANES, p*width/PLANES};
        double area = 0.0;

        for (size_t i = 0; i < got.n; i++)
        {
            const double off = difference(got.x[i], plane, axis);

            area += fabs(off) < radius ? world_pi*(radius*radius - off*off) : 0.0;
        }
        worst = fmax(worst, fabs(area/mean - 1.0));
    }
    return worst;
}

/* A plane cuts n = N d/L spheres. For random places the cut areas have a relative deviation of
   sqrt(1.2/n), in dense packings less: four of these. */
static double noise(void)
{
    return 4.0*sqrt(1.2/((double)got.n*diameter/width));
}

/* rounding of positions and distances, in diameters */
static const double rounding = 1e-10;

/* ---- uniform --------------------------------------------------------------------------------- */

static void test_box(void)
{
    insert("x y z", "insert { g { type random; solidFraction 0.5; diameter 1e-3; min (0 0 0); "
                    "max (0.012 0.012 0.012); } }");
    TAP_NEAR((double)got.n*world_pi/6.0*1e-9, 0.5*width*width*width, world_pi/12.0*1e-9,
             "the solid fraction holds for the whole domain, %zu spheres", got.n);
    for (int k = 0; k < 3; k++)
    {
        TAP_NEAR(unevenness(k), 0.0, noise(), "box: uniform in planes across %c", "xyz"[k]);
    }
    TAP_NEAR(fmax(overlap(), 0.0), 0.0, rounding, "no overlap of images at a solid fraction of 0.5");
    insert("x", "insert { g { type random; solidFraction 0.4; diameter 1e-3; min (0.004 0 0); "
                "max (0.016 0.012 0.012); } }");
    TAP_NEAR(unevenness(0), 0.0, noise(), "a box as wide as the domain, elsewhere: uniform, too");
    TAP_NEAR(fmax(overlap(), 0.0), 0.0, rounding, "no overlap");
}

static void test_cylinder(const char *from, const char *to, const char *where)
{
    char *const text = world_text(
        "insert { g { type random; solidFraction 0.5; diameter 1e-3; cylinder { from (0.006 0.006 "
        "%s); to (0.006 0.006 %s); radius 0.006; } } }", from, to);
    double furthest = 0.0;

    insert("z", text);
    for (size_t i = 0; i < got.n; i++)
    {
        furthest = fmax(furthest, hypot(got.x[i][0] - 0.006, got.x[i][1] - 0.006));
    }
    TAP_NEAR(unevenness(2), 0.0, noise(), "cylinder %s: uniform along its axis", where);
    TAP_OK(furthest <= 0.0055*(1.0 + rounding), "inside its side");
    TAP_NEAR(fmax(overlap(), 0.0), 0.0, rounding, "no overlap");
}

/* The surface of a box between the corners. */
static void box_surface(const double low[3], const double high[3], double triangles[12][9])
{
    static const int corner[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                      {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                      {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

    for (int t = 0; t < 12; t++)
    {
        for (int c = 0; c < 9; c++)
        {
            triangles[t][c] = (corner[t][c/3] >> c%3 & 1 ? high : low)[c%3];
        }
    }
}

static void test_mesh(void)
{
    static const double low[3] = {0.0, 0.0, 0.003}, high[3] = {0.012, 0.012, 0.009};
    double triangles[12][9], least = INFINITY, most = 0.0;
    struct dem_case *const c = world_begin(
        PHYSICS "domain { min (0 0 0); max (0.012 0.012 0.012); periodic (x y); }"
        "walls { floor { type plane; point (0 0 0.003); normal (0 0 1); } "
        "lid { type plane; point (0 0 0.009); normal (0 0 -1); } }"
        "insert { g { type random; solidFraction 0.45; diameter 1e-3; inside mesh; } }");

    box_surface(low, high, triangles);
    WORLD_TRY(dem_case_add_region(c, "mesh", 0, 12, triangles[0]));
    struct dem *const d = world_start(c);
    read_particles(d);
    dem_free(d);
    for (size_t i = 0; i < got.n; i++)
    {
        least = fmin(least, got.x[i][2]);
        most = fmax(most, got.x[i][2]);
    }
    TAP_NEAR(unevenness(0), 0.0, noise(), "mesh with cyclic patches: uniform across x");
    TAP_NEAR(unevenness(1), 0.0, noise(), "and across y");
    TAP_OK(least >= 0.0035*(1.0 - rounding) && most <= 0.0085*(1.0 + rounding), "off the walls");
    TAP_NEAR(fmax(overlap(), 0.0), 0.0, rounding, "no overlap");
}

/* ---- one face, across faces ------------------------------------------------------------------ */

static void test_one_face(void)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {0.0, 0.0, 0.0};

    insert("x z", "insert { g { type random; solidFraction 0.4; diameter 1e-3; min (0 0 0.006); "
                  "max (0.006 0.012 0.012); } }");
    for (size_t i = 0; i < got.n; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            low[k] = fmin(low[k], got.x[i][k]);
            high[k] = fmax(high[k], got.x[i][k]);
        }
    }
    TAP_OK(low[0] < 0.1*radius && high[2] > width - 0.1*radius,
           "a box that ends at a face: centres up to it, %g m away", fmax(low[0], width - high[2]));
    TAP_OK(high[0] <= (0.006 - radius)*(1.0 + rounding)
               && low[2] >= (0.006 + radius)*(1.0 - rounding)
               && low[1] >= radius*(1.0 - rounding) && high[1] <= width - radius*(1.0 - rounding),
           "a radius off its other sides");
    TAP_NEAR(fmax(overlap(), 0.0), 0.0, rounding, "no overlap");
}

static void test_across(void)
{
    static const double corner[3] = {0.0, 0.0, 0.0};
    double furthest = 0.0;
    size_t through = 0;

    insert("x y z", "insert { g { type random; solidFraction 0.45; diameter 1e-3; sphere { centre "
                    "(0 0 0); radius 0.005; } } }");
    for (size_t i = 0; i < got.n; i++)
    {
        furthest = fmax(furthest, distance(got.x[i], corner));
        through += got.x[i][0] > 0.006;
    }
    TAP_OK(furthest <= 0.0045*(1.0 + rounding), "a sphere around a corner: all inside");
    TAP_OK(fabs((double)through/(double)got.n - 0.5) < 2.0/sqrt((double)got.n),
           "half of them beyond the face");    /* twice the deviation of random sides */
    TAP_NEAR(fmax(overlap(), 0.0), 0.0, rounding, "no overlap");
}

/* ---- earlier groups -------------------------------------------------------------------------- */

static void test_earlier(void)
{
    insert("x y", "insert { list { type list; diameter 1e-3; positions ((0.0001 0.006 0.0015) "
                  "(0.006 0.0119 0.0015)); } lattice { type lattice; diameter 1e-3; min (0 0 0.002); "
                  "max (0.003 0.012 0.004); spacing 1; } random { type random; diameter 1e-3; "
                  "solidFraction 0.35; min (0.003 0 0.002); max (0.012 0.012 0.006); seed 2; } "
                  "last { type random; diameter 1e-3; solidFraction 0.3; seed 3; min (0.006 -0.006 0.0); "
                  "max (0.018 0.006 0.002); } }");
    TAP_NEAR(fmax(overlap(), 0.0), 0.0, rounding,
             "no overlap with earlier groups beyond the faces, %zu spheres", got.n);
}

static void test_lattice(void)
{
    insert("x y z", "insert { g { type lattice; diameter 1e-3; min (0 0 0); "
                    "max (0.012 0.012 0.012); spacing 1; } }");
    TAP_OK(got.n == 1728, "a lattice without gaps fills the domain");
    TAP_NEAR(fmax(overlap(), 0.0), 0.0, rounding, "its layers do not overlap through the faces");
}

/* ---- streams --------------------------------------------------------------------------------- */

static void test_stream(void)
{
    struct dem *const d = world(world_text(
        "%s domain { min (0 0 0); max (0.012 0.012 0.012); periodic (x y); } insert { "
        "feed { type stream; rate 2e7; diameter 1e-3; min (0 0.009 0.004); max (0.012 0.012 0.008); } "
        "side { type stream; rate 2e7; diameter 1e-3; min (0 -0.003 0.004); max (0.012 0.003 0.006); } "
        "jet { type stream; rate 1e6; diameter 1e-3; velocity (3 0 0); disc { centre "
        "(0.0119 0.006 0.002); normal (1 0 0); radius 0.002; } } }", PHYSICS),
        0, NULL);
    size_t at_x = 0, at_y = 0;

    world_run(d, 33e-5);    /* streams are checked in the 32nd step */
    read_particles(d);
    for (size_t i = 0; i < got.n; i++)
    {
        at_x += fmin(got.x[i][0], width - got.x[i][0]) < 0.5*radius;
        at_y += width - got.x[i][1] < 0.5*radius && got.x[i][2] > 0.004;
    }
    TAP_OK(got.n > 100, "streams insert %zu spheres", got.n);
    /* at least half of the uniform share, radius/width, of the spheres in the two regions */
    TAP_OK((double)at_x > 0.5*(double)got.n*radius/width, "%zu of them near the face of x", at_x);
    TAP_OK(at_y > 0, "%zu near the face of y, at which one region ends", at_y);
    TAP_NEAR(fmax(overlap(), 0.0), 0.0, rounding, "no overlap of images");
    dem_free(d);
}

/* ---- refused --------------------------------------------------------------------------------- */

static void test_refused(const char *group, const char *cause)
{
    world_refused(world_text(
        "%s domain { min (0 0 0); max (0.012 0.012 0.012); periodic (x); }"
        " insert { %s }", PHYSICS, group),
                  cause);
}

int main(void)
{
    TAP_TRAPS;
    test_box();
    test_cylinder("0", "0.012", "between the faces");
    test_cylinder("0.018", "0.006", "across the faces");
    test_mesh();
    test_one_face();
    test_across();
    test_earlier();
    test_lattice();
    test_stream();
    test_refused("g { type random; diameter 1e-3; count 10; min (-0.001 0 0); max (0.012 0.01 0.01); }",
                 "overlaps its own image");
    test_refused("g { type lattice; diameter 1e-3; count 10; min (0 0 0); max (0.013 0.01 0.01); }",
                 "overlaps its own image");
    test_refused("g { type stream; diameter 1e-3; rate 10; sphere { centre (0.006 0.006 0.006); "
                 "radius 0.007; } }", "overlaps its own image");
    test_refused("g { type list; diameter 1e-3; positions ((0.0002 0.006 0.006) "
                 "(0.0115 0.006 0.006)); }", "overlap by 0.3 of a diameter at the start");
    TAP_DONE;
}
