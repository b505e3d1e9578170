/*
 * scalars.cl -- particle scalars (laws/scalar.h) in a row and at a particle: values of both partners,
 * rates, and their integration, as step/contact_scalars.c and step/body_scalars.c have them.
 *
 * The host defines SCALARS, their number; RATES, 1 if contacts have rates; and for each scalar
 * dem_scalar_column, where its values are; dem_scalar_exchange, where its exchange begins (-1: none);
 * dem_scalar_rated, 1 if it changes; dem_scalar_limits; and dem_scalar_capacity by scalar and material.
 * dem_scalar_heat is the scalar whose content is energy, or -1.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#if SCALARS

struct dem_row_scalars    /* of both partners */
{
    double value[2][SCALARS], rate[2][SCALARS], radius[2];
};

struct dem_particle_scalars
{
    double value[SCALARS], rate[SCALARS], coefficient[SCALARS], to_target[SCALARS];
    double heated, from_contacts;    /* W  heat of this step, and what contacts add to it */
};

static global const double *dem_scalar_values(global const double *columns, uint n, int k)
{
    return columns + (size_t)dem_scalar_column[k]*n;
}

/* wall: the conditions of the wall, one for each scalar; else NULL, and j is the partner. */
static void dem_row_scalars_begin(global const double *columns, uint n, uint i, uint j,
                                  global const struct dem_device_condition *wall,
                                  const struct dem_contact_row *r, struct dem_row_scalars *q)
{
    for (int k = 0; k < SCALARS; k++)
    {
        global const double *const all = dem_scalar_values(columns, n, k);
        const double of_i = all[i];

        q->value[0][k] = of_i;
        q->value[1][k] = wall ? of_i : all[j];
        q->rate[0][k] = q->rate[1][k] = 0.0;
        if (wall && r->time > wall[k].start*(1.0 + 1e-12) && r->time <= wall[k].end*(1.0 + 1e-12))
        {
            q->value[1][k] = wall[k].given ? wall[k].value : of_i;
            q->rate[0][k] = r->touching*(3.14159265358979323846*r->min_radius*r->min_radius*
                                         (wall[k].flux + wall[k].film*(wall[k].value - of_i)));
        }
    }
}

static void dem_row_scalars_end(global double *rates, uint row, const struct dem_row_scalars *q)
{
    for (int k = 0; k < SCALARS; k++)
    {
        rates[2*((size_t)row*SCALARS + k)] = q->rate[0][k];
        rates[2*((size_t)row*SCALARS + k) + 1] = q->rate[1][k];
    }
}

/* ---- of a particle ----------------------------------------------------------------------------- */

/* which: enum dem_scalar_column */
static global double *dem_scalar_exchanged(global double *columns, uint n, uint i, int k, int which)
{
    return columns + (size_t)(dem_scalar_exchange[k] + which)*n + i;
}

/* Rates begin with the rates of contacts, in the order of partner ids, and of the program. */
static void dem_particle_scalars_begin(global double *columns, uint n, uint i, double over_window,
                                       global const double *rates, global const uchar *touch,
                                       global const uint *start, global const uint *entry,
                                       struct dem_particle_scalars *q)
{
    q->heated = q->from_contacts = 0.0;
    for (int k = 0; k < SCALARS; k++)
    {
        q->value[k] = dem_scalar_values(columns, n, k)[i];
        q->rate[k] = q->coefficient[k] = q->to_target[k] = 0.0;
        for (uint e = start[i]; RATES && e < start[i + 1]; e++)
        {
            const uint row = entry[e] >> 1;

            /* also where surfaces have just come apart */
            q->rate[k] += touch[row] ? rates[2*((size_t)row*SCALARS + k) + (entry[e] & 1)] : 0.0;
        }
        q->from_contacts = dem_scalar_heat == k ? q->rate[k] : q->from_contacts;
        if (dem_scalar_exchange[k] >= 0)
        {
            const double b = *dem_scalar_exchanged(columns, n, i, k, DEM_DEVICE_COEFFICIENT);

            q->rate[k] += *dem_scalar_exchanged(columns, n, i, k, DEM_DEVICE_SOURCE) +
                          over_window*
                              *dem_scalar_exchanged(columns, n, i, k, DEM_DEVICE_CARRIED_OVER);
            q->coefficient[k] += b;
            q->to_target[k] += b**dem_scalar_exchanged(columns, n, i, k, DEM_DEVICE_TARGET);
        }
    }
}

/* The step h of all scalars. Returns 1 when a value is out of its range. */
static int dem_particle_scalars_end(global double *columns, uint n, uint i, double h, double mass,
                                    uint material, struct dem_particle_scalars *q)
{
    int bad = 0;

    for (int k = 0; k < SCALARS; k++)
    {
        if (!dem_scalar_rated[k])
        {
            continue;
        }
        const double each = dem_scalar_capacity[k*DEM_DEVICE_MATERIALS + material],
                     per_capacity = h/(each > 0.0 ? each*mass : 1.0), B = q->coefficient[k],
                     z = B*per_capacity,
                     rate = q->rate[k] + q->to_target[k] - B*q->value[k], phi = dem_phi(z),
                     value = q->value[k] + phi*per_capacity*rate;

        columns[(size_t)dem_scalar_column[k]*n + i] = value;
        q->heated = dem_scalar_heat == k ? phi*rate : q->heated;
        bad |= !(value >= dem_scalar_limits[2*k] && value <= dem_scalar_limits[2*k + 1]);
        if (dem_scalar_exchange[k] >= 0)
        {
            const double given = q->to_target[k] - B*q->value[k];

            *dem_scalar_exchanged(columns, n, i, k, DEM_DEVICE_RECEIVED) +=
                h*(phi*given - (1.0 - phi)*q->rate[k]);
            *dem_scalar_exchanged(columns, n, i, k, DEM_DEVICE_TIME) += h*B;
            *dem_scalar_exchanged(columns, n, i, k, DEM_DEVICE_TARGET_TIME) += h*q->to_target[k];
            *dem_scalar_exchanged(columns, n, i, k, DEM_DEVICE_DECAY) *= 1.0 - z*phi;
        }
    }
    return bad;
}
#endif
