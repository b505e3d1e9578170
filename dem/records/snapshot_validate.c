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
#include "particles/initial_particles.h"
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    /* index in the record of a particle */
    FIRST_INTEGER = offsetof(struct dem_particle, id)/sizeof(double),
    AFTER_INTEGERS = offsetof(struct dem_particle, unused)/sizeof(double)
};
_Static_assert(sizeof(struct dem_particle) == (AFTER_INTEGERS + 1)*sizeof(double),
               "one double follows the integers of a record");

/* of steps, particles: integers that are exact in a double */
static const double max_count = 0x1p53;
static const double max_time = 1e12;       /* s */

static int are_finite(const double *x, size_t n)
{
    double bad = 0.0;

    for (size_t k = 0; k < n; k++)
    {
        bad += 0.0*x[k];
    }
    return bad == 0.0;
}

/* ---- particles ------------------------------------------------------------------------------- */

/* DEM_ERROR_FILE with the first of `width` numbers that is not finite. */
static int check_finite(const char *path, const char *what, const char *unit,
                        const struct dem_particle *p, const double *x, int width)
{
    char component[48] = "";

    for (int k = 0; k < width; k++)
    {
        snprintf(component, sizeof component, " in component %d of %d", k + 1, width);
        DEM_REQUIRE(
            isfinite(x[k]), DEM_ERROR_FILE,
            "%s is damaged: %s of particle %lld is %g%s%s%s, and must be finite; use another one",
            path, what, (long long)p->id, x[k], unit[0] ? " " : "", unit,
            width > 1 ? component : "");
    }
    return DEM_OK;
}

/* Find and report the number that is not finite. */
static int report_not_finite(const char *path, const struct dem_snapshot_header *h,
                             const struct dem_particle *p, const double *packed)
{
    const double *at = packed + DEM_SNAPSHOT_RECORD;

    DEM_TRY(check_finite(path, "the position", "m", p, p->x, 3));
    DEM_TRY(check_finite(path, "the velocity", "m/s", p, p->v, 3));
    DEM_TRY(check_finite(path, "the spin", "1/s", p, p->w, 3));
    DEM_TRY(check_finite(path, "the radius", "m", p, &p->radius, 1));
    DEM_TRY(check_finite(path, "the mass", "kg", p, &p->mass, 1));
    DEM_TRY(check_finite(path, "the inverse of the mass", "1/kg", p, &p->inverse_mass, 1));
    DEM_TRY(check_finite(path, "the inverse of the moment of inertia", "1/(kg m2)", p,
                         &p->inverse_inertia, 1));
    DEM_TRY(check_finite(path, "the unused number", "", p, &p->unused, 1));
    for (int64_t c = 0; c < h->columns; c++)
    {
        DEM_TRY(check_finite(path, h->list[h->materials + c].name, "", p, at,
                             (int)h->list[h->materials + c].width));
        at += h->list[h->materials + c].width;
    }
    return DEM_OK;
}

/* radii from the origin, where overlaps of 1e-4 radii are lost; without a domain particles fly far */
static const double max_distance = 1e12;

/* Radius, position, velocity and spin. */
static int check_motion(const char *path, const struct dem_particle *p)
{
    const double limit = dem_particle_max_speed*dem_particle_max_speed;

    DEM_REQUIRE(
        p->radius > 0.0, DEM_ERROR_FILE,
        "%s is damaged: particle %lld has a radius of %g m, which must be above 0; use another one",
        path, (long long)p->id, p->radius);
    DEM_REQUIRE(
        fmax(fabs(p->x[0]), fmax(fabs(p->x[1]), fabs(p->x[2]))) <= max_distance*p->radius,
        DEM_ERROR_FILE,
        "%s is damaged: particle %lld at (%g %g %g) m is more than %g radii of %g m from the origin, where double precision cannot resolve overlaps; "
        "use another one",
        path, (long long)p->id, p->x[0], p->x[1], p->x[2], max_distance, p->radius);
    DEM_REQUIRE(
        dem_vec_dot(p->v, p->v) <= limit, DEM_ERROR_FILE,
        "%s is damaged: particle %lld has velocity (%g %g %g) m/s, the limit is %g m/s, the "
        "speed of light; use another one",
        path, (long long)p->id, p->v[0], p->v[1], p->v[2], dem_particle_max_speed);
    DEM_REQUIRE(
        dem_vec_dot(p->w, p->w)*p->radius*p->radius <= limit, DEM_ERROR_FILE,
        "%s is damaged: particle %lld of radius %g m has spin (%g %g %g) 1/s, the limit is %g 1/s, at which its surface moves at the speed of "
        "light; use another one",
        path, (long long)p->id, p->radius, p->w[0], p->w[1], p->w[2],
        dem_particle_max_speed/p->radius);
    return DEM_OK;
}

/* Inside a window the inverse mass contains the added mass; the inverse moment of inertia
   contains nothing else. */
static int check_inertia(const char *path, const struct dem_particle *p)
{
    const double inertia_ratio = 0.4*p->mass*p->radius*p->radius*p->inverse_inertia;
    const int known = DEM_PARTICLE_FROZEN | DEM_PARTICLE_DRIVEN | DEM_PARTICLE_ABSORBED,
              frozen = p->flags & DEM_PARTICLE_FROZEN,
              immobile = p->inverse_mass == 0.0 && p->inverse_inertia == 0.0;

    DEM_REQUIRE(
        p->mass > 0.0, DEM_ERROR_FILE,
        "%s is damaged: particle %lld has a mass of %g kg, which must be above 0; use another one",
        path, (long long)p->id, p->mass);
    DEM_REQUIRE((p->flags & ~known) == 0 && (frozen || !(p->flags & DEM_PARTICLE_DRIVEN)),
                DEM_ERROR_FILE,
                "%s is damaged: particle %lld has flags %#x, and the only valid ones are %#x, "
                "driven (%#x) only with frozen (%#x); use another one",
                path, (long long)p->id, p->flags, known, DEM_PARTICLE_DRIVEN, DEM_PARTICLE_FROZEN);
    DEM_REQUIRE(
        frozen ? immobile
               : p->inverse_mass > 0.0 && p->inverse_mass*p->mass < 1.0 + 1e-9 &&
                     fabs(inertia_ratio - 1.0) < 1e-9,
        DEM_ERROR_FILE,
        "%s is damaged: particle %lld, which is %s, of %g kg and radius %g m, has inverses %g 1/kg of its mass and %g 1/(kg m2) of its moment of "
        "inertia; use another one",
        path, (long long)p->id, frozen ? "frozen" : "free", p->mass, p->radius, p->inverse_mass,
        p->inverse_inertia);
    return DEM_OK;
}

int dem_snapshot_validate_particle(const char *path, const struct dem_snapshot_header *h,
                                   const double *packed)
{
    const size_t size = dem_snapshot_particle_doubles(h);
    struct dem_particle p;

    memcpy(&p, packed, sizeof p);
    DEM_REQUIRE(p.id >= 0 && p.id < INT64_MAX, DEM_ERROR_FILE,
                "%s is damaged: a particle has id %lld, and ids go from 0 to %lld; use another one",
                path, (long long)p.id, (long long)INT64_MAX - 1);
    if (!are_finite(packed, FIRST_INTEGER) ||
        !are_finite(packed + AFTER_INTEGERS, size - AFTER_INTEGERS))
    {
        return report_not_finite(path, h, &p, packed);
    }
    DEM_TRY(check_motion(path, &p));
    return check_inertia(path, &p);
}

/* ---- contacts -------------------------------------------------------------------------------- */

int dem_snapshot_validate_contact(const char *path, const struct dem_snapshot_header *h,
                                  const double *packed)
{
    const double *const history = packed + DEM_SNAPSHOT_CONTACT;
    struct dem_contact_key name;

    if (are_finite(history, (size_t)h->memories))
    {
        return DEM_OK;
    }
    memcpy(&name, packed, sizeof name);
    for (int64_t m = 0; m < h->memories; m++)
    {
        const char *const what = h->list[h->materials + h->columns + m].name;

        DEM_REQUIRE(isfinite(history[m]) || name.high < 0, DEM_ERROR_FILE,
                    "%s is damaged: the contact of particles %lld and %lld "
                    "has history %s %g, which must be finite; use another one",
                    path, (long long)name.low, (long long)name.high, what, history[m]);
        DEM_REQUIRE(isfinite(history[m]), DEM_ERROR_FILE,
                    "%s is damaged: the contact of particle %lld with a wall has history "
                    "%s %g, which must be finite; use another one",
                    path, (long long)name.low, what, history[m]);
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
