/*
 * clump_shape.h -- templates of rigid bodies: the entry `shapes` of a scene.
 *
 *     shapes { nut { spheres ((0 0 0 1e-3) (1e-3 0 0 1e-3)); } }      x y z r of each sphere [m]
 *
 * The body is the union of its spheres (sphere_union.h): what several of them hold counts once.
 * Multiplied by the density of the material of a group they are mass and inertia.
 *
 * A sphere of a body has a share of its mass, volume and forces of the fluid: by r^3, changed so that the
 * centre of these shares is the centre of the union. Fields that are alike at all spheres, gravity or a
 * pressure gradient, then turn no body, and sums over spheres have the momentum of the body.
 *
 * Limit of the time step. A body of mass M with contacts of all its n spheres at once, each with the
 * stiffness k and the dashpot c = 2 z sqrt(k M), has at most omega^2 = N k/M and the rate N c/M,
 *
 *   N = max(n, M sum rho_k^2/I_a),   rho_k: distance of centre k from the principal axis a       [1]
 *
 * Limits of the laws are a sqrt(m/k) with a = 0.16 to 0.2 for the mass m of a sphere. So m = M/N gives
 * the frequency its limit, and m = 4 M/N^2 keeps the rate times the step below 2, where a dashpot
 * becomes unstable: it is 4 a z, or 1.7 z for 256 spheres where k grows as the mass^(1/5).
 * step_volume is the smaller of the two over the density; where it is larger than the smallest
 * sphere, that sphere sets the step.
 *
 * Limit of the step by bonds. Bonds on all spheres have areas pi r_k^2 and act r_k off the centres. With
 * the volume V and moments I_a over the density, the rates of translation, of rotation by the offsets and
 * of rotation by these arms, by twist and by bending are proportional to
 *
 *   max(sum pi r_k^2/V, sum pi r_k^2 rho_k^2/I_a, 2/5 sum pi r_k^4/I_a) = 3/(4 r)
 *
 * where r is the radius of the sphere with the same value. As for spheres (laws/bond/bond_linear.c) the
 * largest counts. Together they are at most three times that: a frequency at most sqrt(3) times as high,
 * which the factor 0.2 of the limit leaves room for. bond_radius is r min(1, 4/N), for the dashpots.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "input/dictionary.h"
#include "particles/particles.h"

struct dem_clump_shape
{
    const char *name;
    size_t n;
    const double (*sphere)[4];        /* x, y, z [m] in the axes of the scene, radius [m] */
    double (*offset)[3];              /* m  from the centre, in principal axes; owned */
    double *share;                    /* 1  of each sphere; owned */
    double volume, centre[3];         /* m3, m  of the union */
    double inertia[3];                /* m5  principal moments over the density */
    double principal[4];              /* quaternion from the principal axes to the scene's */
    double solid;                     /* m3  sum of the volumes of the spheres */
    double step_volume, bond_radius;  /* m3, m  for limits of the time step, see above */
    double bound, reach;              /* m  radius of the sphere around the centre that holds the
                                         body; largest offset */
};

struct dem_clump_shapes
{
    size_t n, capacity;
    struct dem_clump_shape *shape;
};

/* The entry shapes of a scene, which must outlive them. To be freed also after a failure. */
int dem_clump_shapes_read(struct dem_clump_shapes *, const struct dem_dict *scene);
void dem_clump_shapes_free(struct dem_clump_shapes *);

/* The shape with this name; an error that begins with `where` lists those that exist. */
int dem_clump_shapes_find(const struct dem_clump_shapes *, const char *name, const char *where,
                          const struct dem_clump_shape **);

/* The shape of this volume [m3], of several the one with the smallest step_volume; NULL: none. */
const struct dem_clump_shape *dem_clump_shapes_with_volume(const struct dem_clump_shapes *,
                                                           double volume);

/* The smallest bond_radius [m] of all shapes; 0: there is none. */
double dem_clump_shapes_bond_radius(const struct dem_clump_shapes *);
