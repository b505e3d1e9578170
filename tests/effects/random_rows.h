/*
 * random_rows.h -- random contacts, particles and settings of laws, for test_device.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/random.h"
#include "laws/effects.h"
#include "laws/row.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- random numbers -------------------------------------------------------------------------- */

static uint64_t draws;

static inline double uniform(double min, double max)
{
    return min + (max - min)*dem_random_unit(1, draws++, 0, 0);
}

static inline double positive(double min, double max)
{
    return dem_exp(uniform(dem_log(min), dem_log(max)));
}

static inline double signed_number(double min, double max)
{
    return (uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0)*positive(min, max);
}

static inline int one_in(int n)
{
    return uniform(0.0, 1.0)*n < 1.0;
}

static inline void unit_vector(double *x, double *y, double *z)
{
    const double a = uniform(0.0, 6.283), c = uniform(-1.0, 1.0), s = sqrt(1.0 - c*c);

    *x = s*cos(a), *y = s*sin(a), *z = c;
}

/* Replaces a number by one that is zero, tiny or huge. */
static inline void extreme(double *number)
{
    const double sign = signbit(*number) ? -1.0 : 1.0;

    *number = one_in(3)   ? 0.0
              : one_in(2) ? sign*positive(1e-308, 1e-100)
                          : sign*positive(1e100, 1e300);
}

/* ---- rows ------------------------------------------------------------------------------------ */

/* The numbers of a contact that belong together; all others are of any sign. */
static inline struct dem_contact_row random_contact(double h[DEM_LAW_HISTORY])
{
    struct dem_contact_row r;
    const double radius = positive(1e-6, 0.1),
                 other = one_in(4) ? radius : positive(radius, 3.0*radius);
    const double gap = one_in(2) ? -radius*positive(1e-9, 0.1) : radius*positive(1e-9, 0.3);

#define ANY(column) r.column = one_in(8) ? 0.0 : signed_number(1e-6, 10.0);
    DEM_ROW_COLUMNS(ANY)
    unit_vector(&r.nx, &r.ny, &r.nz);
    if (one_in(4))
    {
        r.hx = r.nx, r.hy = r.ny, r.hz = r.nz;
    }
    else
    {
        unit_vector(&r.hx, &r.hy, &r.hz);
    }
    if (one_in(8))    /* no slip */
    {
        r.sx = r.sy = r.sz = 0.0;
    }
    r.gap = gap;
    r.distance = radius + other + gap;
    r.overlap = gap < 0.0 ? -gap : 0.0;
    r.touching = gap < 0.0 ? 1.0 : 0.0;
    r.reduced_radius = radius*other/(radius + other);
    r.min_radius = radius;
    r.reduced_mass = positive(1e3, 1e4)*radius*radius*radius;
    r.viscosity = one_in(8) ? 0.0 : positive(1e-6, 10.0);
    r.is_primary = one_in(8) ? 0.0 : 1.0;
    r.pair_random = uniform(0.0, 1.0);
    r.bond_replaces = one_in(4) ? (one_in(2) ? 1.0 : 2.0) : 0.0;
    r.scratch = one_in(2) ? uniform(0.7, 2.0) : 0.0;
    r.kn = r.touching*positive(1.0, 1e8);
    r.kt = r.touching*positive(1.0, 1e8);
    r.eta = r.touching*positive(1e-9, 1e3);
    r.bonds = r.broke = r.cause = 0.0;    /* the caller clears them */
    for (int k = 0; k < DEM_LAW_HISTORY; k++)
    {
        /* many laws remember 0 or 1, a bond -3 to -1 of its length or a length */
        h[k] = one_in(3)   ? floor(uniform(-3.0, 2.0))
               : one_in(2) ? r.distance
                           : signed_number(1e-9, 1e-2);
    }
    r.scalars[0] = (struct dem_contact_scalar){
        .i = one_in(2) ? positive(1.0, 2e3) : radius*radius*radius*positive(1e-6, 0.1),
        .j = one_in(2) ? positive(1.0, 2e3) : radius*radius*radius*positive(1e-6, 0.1),
        .rate_i = signed_number(1e-9, 1.0), .rate_j = signed_number(1e-9, 1.0),
        .radius_i = radius, .radius_j = other};
    return r;
}

static inline struct dem_body_row random_body(void)
{
    struct dem_body_row r;

#define ANY_OF_BODY(column) r.column = one_in(8) ? 0.0 : signed_number(1e-6, 10.0);
    DEM_BODY_COLUMNS(ANY_OF_BODY)
    r.radius = positive(1e-6, 0.1);
    r.volume = 4.0/3.0*3.14159265358979324*r.radius*r.radius*r.radius;
    r.sphericity = one_in(4) ? 1.0 : uniform(0.2, 1.0);
    r.crosswise = uniform(0.2, 2.0);
    r.lengthwise = uniform(0.2, 2.0);
    r.density = one_in(8) ? 0.0 : positive(0.1, 1e4);
    r.mass = r.volume*positive(10.0, 2e4);
    r.void_fraction = one_in(8) ? uniform(-0.1, 1.2) : uniform(0.2, 1.0);
    r.viscosity = one_in(16) ? 0.0 : positive(1e-6, 10.0);
    r.mean_diameter = one_in(8) ? 0.0 : r.radius*positive(0.5, 8.0);
    r.added_mass = r.mass*positive(1e-3, 1.0);
    if (one_in(8))    /* no slip */
    {
        r.ux = r.vx, r.uy = r.vy, r.uz = r.vz;
    }
    r.voidage_factor[0] = positive(1e-2, 1e3);
    r.voidage_factor[1] = uniform(0.0, 1.0);
    for (int k = 0; k < DEM_EFFECT_SCALARS; k++)
    {
        r.scalars[k].value = positive(1e-2, 5e3);
    }
    r.scalars[0].rate = signed_number(1e-9, 1.0);
    r.scalars[0].coefficient = positive(1e-9, 1.0);
    r.scalars[0].to_target = signed_number(1e-9, 1.0);
    return r;
}

/* ---- settings -------------------------------------------------------------------------------- */

static inline struct dem_material random_material(const char *name)
{
    struct dem_material m = {.density = positive(100.0, 1e4),
                             .youngs_modulus = positive(1e5, 1e11),
                             .poissons_ratio = uniform(0.0, 0.49),
                             .thermal = {.conductivity = positive(0.01, 400.0),
                                         .heat_capacity = positive(100.0, 5e3),
                                         .emissivity = uniform(0.01, 1.0)}};

    snprintf(m.name, sizeof m.name, "%s", name);
    m.thermal.real_modulus = one_in(2) ? 0.0 : m.youngs_modulus*positive(1.0, 1e3);
    return m;
}

static inline double random_setting(const struct dem_setting *s)
{
    const double min = s->min > 1e-12 ? s->min : 1e-12, max = s->max < 1e12 ? s->max : 1e12;

    if (!isnan(s->default_value) && one_in(3))
    {
        return s->default_value;
    }
    if (s->min <= 0.0 && one_in(8))
    {
        return 0.0;
    }
    const double value = max/min > 1e12 ? positive(fmax(min, 1e-6), fmin(max, 1e6))
                                        : positive(min, max);

    return s->flags & DEM_SETTING_WHOLE ? floor(value) : value;
}

/* Settings that the law accepts, prepared for a random pair of materials. */
static inline void random_settings(const struct dem_effect *e, char *settings)
{
    for (int attempt = 0; attempt < 1000; attempt++)
    {
        const struct dem_material a = random_material("a"), b = random_material("b");
        const double a_compliance = (1.0 - a.poissons_ratio*a.poissons_ratio)/a.youngs_modulus,
                     b_compliance = (1.0 - b.poissons_ratio*b.poissons_ratio)/b.youngs_modulus;
        const struct dem_pair_class pair = {
            .a = &a, .b = &b, .with_wall = one_in(3),
            .reduced_modulus = 1.0/(a_compliance + b_compliance),
            .reduced_shear = positive(1e5, 1e10), .exponent = one_in(3) ? 1.0 : 1.5,
            .min_radius = 1e-3, .min_mass = 1e-5, .max_radius_sum = 4e-3,
            .fluid_density = one_in(2) ? 0.0 : 1000.0};

        for (const struct dem_setting *s = e->settings; s && s->name; s++)
        {
            double numbers[3] = {random_setting(s), random_setting(s), random_setting(s)};
            int choice = 0, choices = s->kind == DEM_SETTING_SWITCH ? 2 : 0;

            while (s->kind == DEM_SETTING_CHOICE && s->choices[choices])
            {
                choices++;
            }
            choice = (int)uniform(0.0, choices);
            memcpy(settings + s->offset, choices ? (void *)&choice : (void *)numbers,
                   choices                         ? sizeof choice
                   : s->kind == DEM_SETTING_VECTOR ? sizeof numbers
                                                   : sizeof *numbers);
        }
        if (!e->prepare || e->prepare(settings, e->stage < DEM_STAGE_BODY ? &pair : NULL) == DEM_OK)
        {
            return;
        }
    }
    printf("Bail out! %s accepts no random settings: %s\n", e->name, dem_error_text());
    exit(1);
}
