/*
 * test_wall_wear.c -- a sphere so heavy that no force moves it slides along a plate and wears k F L/H off
 * it, each triangle for the part of the way on it; a moving plate, periodic images and the position of the triangles change
 * nothing. A run continued from a snapshot has the volumes of one that ran through, to the last bit.
 *
 * Spheres that hit a plate at several angles each wear off Finnie's volume once, however long the contact
 * is; the largest volume is at tan 2a = 2/3.
 *
 * Sources: Archard, J. Appl. Phys. 24 (1953) 981; Finnie, Wear 3 (1960) 87.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

static const double R = 1e-3, overlap = 1e-5, v = 0.1, T = 0.05, k = 1e-4, H = 1e9;

/* The plate is divided at x = 0.0021 by the edge of two rectangles, of two triangles each. */
static const char *scene(const char *motion, const char *domain, double speed)
{
    return world_text(
        "materials { glass { density 1e22; youngsModulus 1e7; poissonsRatio 0.3; } "
        "rigid { density 1; youngsModulus 1e30; } } effects { hertz {} } %s "
        "walls { plate { type triangles; material rigid; wear { coefficient %g; hardness %g; } %s corners ("
        "(-0.01 -0.01 0) (0.0021 -0.01 0) (0.0021 0.01 0) (-0.01 -0.01 0) (0.0021 0.01 0) (-0.01 0.01 0) "
        "(0.0021 -0.01 0) (0.02 -0.01 0) (0.02 0.01 0) (0.0021 -0.01 0) (0.02 0.01 0) (0.0021 0.01 0)); } } "
        "insert { ball { type list; material glass; diameter %g; positions ((1e-3 2e-3 %.17g)); velocity (%g 0 0); } } time { step 5e-6; }", domain, k, H, motion, 2.0*R, R - overlap, speed);
}

static struct dem *slides(const char *motion, const char *domain, double speed)
{
    return world(scene(motion, domain, speed), 0, NULL);
}

static void wears(const char *motion, const char *domain, double speed, const char *what)
{
    const double F = 4.0/3.0*1e7/0.91*sqrt(R)*pow(overlap, 1.5), all = k*F*v*T/H;
    struct dem *const d = slides(motion, domain, speed);
    double volume[4], corner[36], sum = 0.0, left = 0.0;

    world_run(d, T);
    WORLD_TRY(dem_wall_wear(d, 0, volume));
    WORLD_TRY(dem_wall_corners(d, 0, corner));
    for (int t = 0; t < 4; t++)
    {
        sum += volume[t];
        left += fmin(corner[9*t], fmin(corner[9*t + 3], corner[9*t + 6])) < 0.0 ? volume[t] : 0.0;
    }
    TAP_OK(dem_wall_wears(d, 0) && !dem_wall_wears(d, 1), "%s: wear is summed", what);
    TAP_NEAR(sum/all, 1.0, 1e-12, "%s: k F L/H", what);
    /* the way to the edge, to a step of it */
    TAP_NEAR(left/all, 1.1e-3/(v*T), 1e-4, "%s: on the part before the edge", what);
    dem_free(d);
}

/* Volumes at T, of a run that saves at T/2; with `load`, of one that continues from there. */
static void volumes(const char *file, int load, double *volume)
{
    struct dem *d = slides("", "", v);

    world_run(d, 0.5*T);
    WORLD_TRY(dem_save(d, file));
    if (load)
    {
        struct dem_case *const c = world_begin(scene("", "", v));

        dem_free(d);
        WORLD_TRY(dem_case_load(c, file));
        d = world_start(c);
    }
    world_run(d, 0.5*T);
    WORLD_TRY(dem_wall_wear(d, 0, volume));
    dem_free(d);
}

static void continues(void)
{
    const double F = 4.0/3.0*1e7/0.91*sqrt(R)*pow(overlap, 1.5), all = k*F*v*T/H;
    double whole[4], continued[4], sum = 0.0;

    volumes("worn.dem.tmp", 0, whole);
    volumes("worn.dem.tmp", 1, continued);
    remove("worn.dem.tmp");
    for (int t = 0; t < 4; t++)
    {
        sum += continued[t];
    }
    TAP_NEAR(sum/all, 1.0, 1e-12, "continued from a snapshot: k F L/H");
    TAP_OK(memcmp(whole, continued, sizeof whole) == 0, "continued from a snapshot: the same bits");
}

/* The volume that one sphere wears off at an angle a, over k/H m v^2 for a sphere of this spin and a
   plate of this motion, both of which move by `along` more [m/s]. */
static double hits(double a, const char *spin, const char *motion, double along)
{
    const double m = 2500.0*4.0/3.0*acos(-1.0)*R*R*R;
    double volume[2];
    struct dem *const d = world(world_text(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } "
        "effects { hertz {} dry { restitution 0.5; } mindlin { friction 0.3; } } "
        "walls { plate { type triangles; wear { law finnie; coefficient %g; hardness %g; } %s corners ("
        "(-0.1 -0.1 0) (0.1 -0.1 0) (0.1 0.1 0) (-0.1 -0.1 0) (0.1 0.1 0) (-0.1 0.1 0)); } } insert { ball { "
        "type list; diameter %g; positions ((1e-3 2e-3 %.17g)); velocity (%.17g 0 %.17g); spin %s; } }", k, H,
        motion, 2.0*R, 1.01*R, v*cos(a) + along, -v*sin(a), spin), 0, NULL);

    world_run(d, 0.02);
    WORLD_TRY(dem_wall_wear(d, 0, volume));
    dem_free(d);
    return (volume[0] + volume[1])*H/(k*m*v*v);
}

static void finnie(void)
{
    const double right = acos(0.0), best = 0.5*atan(2.0/3.0);
    double largest = 0.0, at = 0.0;

    for (int n = 0; n < 18; n++)
    {
        const double a = n == 0 ? best : n*right/18.0, s = sin(a), c = cos(a),
                     f = 3.0*s <= c ? 2.0*s*c - 3.0*s*s : c*c/3.0, found = hits(a, "(0 0 0)", "", 0.0);

        TAP_NEAR(found/f, 1.0, 1e-12, "Finnie's law at %g degrees", a*90.0/right);
        at = found > largest ? a : at;
        largest = fmax(largest, found);
    }
    TAP_NEAR(largest, 0.5*(sqrt(13.0) - 3.0), 1e-12, "the largest volume");
    TAP_OK(at == best, "it is at tan 2a = 2/3");
    TAP_NEAR(hits(right, "(0 0 0)", "", 0.0), 0.0, 1e-30, "a path along the normal wears nothing");
    TAP_NEAR(hits(best, "(50 20 0)", "", 0.0)/largest, 1.0, 1e-12, "spin does not count");
    TAP_NEAR(hits(best, "(0 0 0)", "motion { type translation; velocity (0.04 0 0); }", 0.04)/largest, 1.0, 1e-12,
             "the velocity over a plate that moves counts");
}

int main(void)
{
    finnie();
    continues();
    wears("", "", v, "a sphere on a plate");
    wears("motion { type translation; velocity (0.04 0 0.0); }", "", v + 0.04, "a plate that moves");
    wears("", "domain { y (-0.01 0.01); periodic (y); }", v, "a periodic plate");
    world_refused("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} } "
                  "walls { w { type plane; point (0 0 0); normal (0 0 1); wear { coefficient 1; hardness 1; } } }",
                  "build it from triangles");
    world_refused("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} } "
                  "walls { w { type triangles; corners ((0 0 0) (1 0 0) (0 1 0)); wear { coefficient 1; hardness 0; } } }",
                  "give numbers above 0");
    world_refused("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} } walls { "
                  "w { type triangles; corners ((0 0 0) (1 0 0) (0 1 0)); absorb yes; wear { coefficient 1; hardness 1; } } }",
                  "wall w absorbs particles");
    TAP_DONE;
}
