/*
 * snapshot_validate.c -- range checks of particles, contacts and the header of a snapshot.
 *
 * A checksum detects damage only: a file with correct checksums may still contain values that no
 * run has written.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/snapshot_validate.h"
#include "core/error.h"
#include "core/vec.h"
#include <fenv.h>
#include <math.h>
#include <string.h>

/* of steps, particles: integers that are exact in a double */
static const double max_count = 0x1p53;
static const double max_time = 1e12;       /* s */

/* radii from the origin, where overlaps of 1e-4 radii are lost; without a domain particles fly far */
static const double max_distance = 1e12;

int dem_snapshot_validate_particle(const char *path, const struct dem_snapshot_header *h,
                                   const double *packed)
{
    const double *column = packed + DEM_SNAPSHOT_RECORD;
    struct dem_particle p;

    memcpy(&p, packed, sizeof p);

    const unsigned known = DEM_PARTICLE_FROZEN | DEM_PARTICLE_DRIVEN | DEM_PARTICLE_ABSORBED;
    const int frozen = p.flags & DEM_PARTICLE_FROZEN;
    const double far = fabs(p.x[0]) + fabs(p.x[1]) + fabs(p.x[2]), speed = dem_vec_norm(p.v),
                 surface = dem_vec_norm(p.w)*p.radius,
                 turning = 0.4*p.mass*p.radius*p.radius*p.inverse_inertia;
    const struct
    {
        const char *what;
        double value;
        int valid;
    } check[] = {
        {"id", (double)p.id, p.id >= 0 && p.id < INT64_MAX},
        {"radius [m]", p.radius, isfinite(p.radius) && p.radius > 0.0},
        {"distance [m] from the origin", far, far <= max_distance*p.radius},
        {"speed [m/s]", speed, speed <= dem_particle_max_speed},
        {"speed [m/s] of its surface", surface, surface <= dem_particle_max_speed},
        {"mass [kg]", p.mass, isfinite(p.mass) && p.mass > 0.0},
        {"flags", p.flags, !(p.flags & ~known) && (frozen || !(p.flags & DEM_PARTICLE_DRIVEN))},
        /* inside a window it contains the added mass */
        {"inverse mass [1/kg]", p.inverse_mass,
         frozen ? p.inverse_mass == 0.0 : p.inverse_mass > 0.0 && p.inverse_mass*p.mass < 1.0 + 1e-9},
        {"inverse moment of inertia [1/(kg m2)]", p.inverse_inertia,
         frozen   ? p.inverse_inertia == 0.0
         : p.body ? p.inverse_inertia > 0.0
                  : fabs(turning - 1.0) < 1e-9},
        {"the first id of its clump", (double)p.body,
         p.body == 0 || (p.body > 0 && p.id >= p.body - 1 && p.id - p.body < DEM_CLUMP_SPHERES - 1)},
    };

    for (size_t k = 0; k < sizeof check/sizeof *check; k++)
    {
        DEM_REQUIRE(check[k].valid, DEM_ERROR_FILE,
                    "%s is damaged: particle %lld has %s %g, which no run writes; use another one",
                    path, (long long)p.id, check[k].what, check[k].value);
    }
    for (int64_t c = 0; c < h->columns; c++)
    {
        for (int64_t k = 0; k < h->list[h->materials + c].width; k++, column++)
        {
            DEM_REQUIRE(isfinite(*column), DEM_ERROR_FILE,
                        "%s is damaged: particle %lld has %s %g; use another one", path,
                        (long long)p.id, h->list[h->materials + c].name, *column);
        }
    }
    return DEM_OK;
}

int dem_snapshot_validate_contact(const char *path, const struct dem_snapshot_header *h,
                                  const double *packed)
{
    const double *const history = packed + DEM_SNAPSHOT_CONTACT;
    struct dem_contact_key name;

    memcpy(&name, packed, sizeof name);
    for (int64_t m = 0; m < h->memories; m++)
    {
        DEM_REQUIRE(isfinite(history[m]), DEM_ERROR_FILE,
                    "%s is damaged: a contact of particle %lld has history %s %g; use another one",
                    path, (long long)name.low, h->list[h->materials + h->columns + m].name,
                    history[m]);
    }
    return DEM_OK;
}

/* ---- header ---------------------------------------------------------------------------------- */

static int is_count(int64_t n)
{
    return n >= 0 && (double)n <= max_count;
}

static int check_times(const char *path, const struct dem_snapshot_header *h)
{
    const struct dem_snapshot_window *const w = &h->window;

    DEM_REQUIRE(
        is_count(h->steps) && isless(fabs(h->time), max_time) &&
            isless(fabs(w->opened), max_time) && isless(fabs(w->dt), max_time),
        DEM_ERROR_FILE,
        "%s is damaged: its header gives %lld steps, time %g s and a window from %g s in steps of %g s; use another one",
        path, (long long)h->steps, h->time, w->opened, w->dt);
    DEM_REQUIRE(
        is_count(w->ahead) && is_count(w->done) && w->done <= w->ahead && w->done <= h->steps &&
            (w->ahead == 0 || w->dt > 0.0),
        DEM_ERROR_FILE,
        "%s is damaged: its header gives a window of %lld steps of %g s, of which %lld are done, after %lld steps in all; use another one",
        path, (long long)w->ahead, w->dt, (long long)w->done, (long long)h->steps);
    return DEM_OK;
}

static int check_flow(const char *path, const struct dem_snapshot_flow *f)
{
    const double number[] = {f->mass, f->momentum[0], f->momentum[1], f->momentum[2], f->energy,
                             f->rate, f->owed, f->since, f->last};

    for (size_t k = 0; k < sizeof number/sizeof *number; k++)
    {
        DEM_REQUIRE(
            isfinite(number[k]), DEM_ERROR_FILE,
            "%s is damaged: number %zu of the flow record of %s is %g, and must be finite; use another one",
            path, k + 1, f->name, number[k]);
    }
    DEM_REQUIRE(
        is_count(f->count) && !isnan(f->start) && !isnan(f->end), DEM_ERROR_FILE,
        "%s is damaged: the flow record of %s has %lld particles, from %g to %g s; use another one",
        path, f->name, (long long)f->count, f->start, f->end);
    return DEM_OK;
}

int dem_snapshot_validate_header(const char *path, const struct dem_snapshot_header *h)
{
    fenv_t caller;

    feholdexcept(&caller);    /* comparing a signalling NaN would trap */
    int status = check_times(path, h);

    for (int64_t k = 0; k < h->flows && !status; k++)
    {
        status = check_flow(path, &h->flow[k]);
    }
    fesetenv(&caller);
    return status;
}
