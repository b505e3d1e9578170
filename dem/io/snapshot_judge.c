/*
 * snapshot_judge.c -- what a particle, a remembered row and the books of a file may be. A checksum guards against damage only: a file of
 * right checksums may still hold what no run has written.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/snapshot_judge.h"
#include "base/error.h"
#include "base/vec.h"
#include "io/crowd.h"
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    NUMBERS = offsetof(struct dem_particle, id)/sizeof(double),         /* of a record, before its whole numbers */
    BEHIND = offsetof(struct dem_particle, viscosity)/sizeof(double)    /* the first behind them */
};
_Static_assert(sizeof(struct dem_particle) == (BEHIND + 1)*sizeof(double), "of a record one number comes behind its whole ones");

static const double most_counted = 0x1p53;                /* steps, particles: whole numbers that a double tells apart */
static const double most_time = 1e12;                     /* s */

static int are_finite(const double *x, size_t n)
{
    double bad = 0.0;

    for (size_t k = 0; k < n; k++)
    {
        bad += 0.0*x[k];
    }
    return bad == 0.0;
}

/* ---- particles ------------------------------------------------------------------------------------------------- */

static int name_number(const char *path, const char *what, const char *unit, const struct dem_particle *p, const double *x, int width)
{
    char where[48] = "";

    for (int k = 0; k < width; k++)
    {
        snprintf(where, sizeof where, " in its number %d of %d", k + 1, width);
        DEM_REQUIRE(isfinite(x[k]), DEM_ERROR_FILE, "%s is damaged: %s of particle %lld is %g%s%s%s, and should be finite; use another one", path, what,
                    (long long)p->id, x[k], unit[0] ? " " : "", unit, width > 1 ? where : "");
    }
    return DEM_OK;
}

/* Which of them is not finite. */
static int name_culprit(const char *path, const struct dem_snapshot_head *h, const struct dem_particle *p, const double *packed)
{
    const double *at = packed + DEM_SNAPSHOT_RECORD;

    DEM_TRY(name_number(path, "the position", "m", p, p->x, 3));
    DEM_TRY(name_number(path, "the velocity", "m/s", p, p->v, 3));
    DEM_TRY(name_number(path, "the spin", "1/s", p, p->w, 3));
    DEM_TRY(name_number(path, "the radius", "m", p, &p->radius, 1));
    DEM_TRY(name_number(path, "the mass", "kg", p, &p->mass, 1));
    DEM_TRY(name_number(path, "the inverse of the mass", "1/kg", p, &p->inverse_mass, 1));
    DEM_TRY(name_number(path, "the inverse of the moment of inertia", "1/(kg m2)", p, &p->inverse_inertia, 1));
    DEM_TRY(name_number(path, "the fluid's viscosity at the place", "Pa s", p, &p->viscosity, 1));
    for (int64_t c = 0; c < h->columns; c++)
    {
        DEM_TRY(name_number(path, h->list[h->materials + c].name, "", p, at, (int)h->list[h->materials + c].width));
        at += h->list[h->materials + c].width;
    }
    return DEM_OK;
}

/* A particle's place, and how fast it may be. */
static int judge_motion(const char *path, const struct dem_particle *p)
{
    const double most = dem_particle_most_speed*dem_particle_most_speed;

    DEM_REQUIRE(p->radius > 0.0, DEM_ERROR_FILE, "%s is damaged: particle %lld has a radius of %g m, which must be above 0; use another one", path,
                (long long)p->id, p->radius);
    DEM_REQUIRE(fmax(fabs(p->x[0]), fmax(fabs(p->x[1]), fabs(p->x[2]))) <= dem_crowd_far*p->radius, DEM_ERROR_FILE,
                "%s is damaged: particle %lld at (%g %g %g) m is more than %g radii of %g m from the origin, where a double tells no overlaps apart; "
                "use another one", path, (long long)p->id, p->x[0], p->x[1], p->x[2], dem_crowd_far, p->radius);
    DEM_REQUIRE(dem_vec_dot(p->v, p->v) <= most, DEM_ERROR_FILE, "%s is damaged: particle %lld has velocity (%g %g %g) m/s, the limit is %g m/s, that "
                "of light; use another one", path, (long long)p->id, p->v[0], p->v[1], p->v[2], dem_particle_most_speed);
    DEM_REQUIRE(dem_vec_dot(p->w, p->w)*p->radius*p->radius <= most, DEM_ERROR_FILE,
                "%s is damaged: particle %lld of radius %g m has spin (%g %g %g) 1/s, the limit is %g 1/s, at which its surface goes as fast as light; use "
                "another one", path, (long long)p->id, p->radius, p->w[0], p->w[1], p->w[2], dem_particle_most_speed/p->radius);
    return DEM_OK;
}

/* Added mass is in the inverse of the mass, of a window that is not over; nothing is in that of the moment of inertia. */
static int judge_inertia(const char *path, const struct dem_particle *p)
{
    const double turns = 0.4*p->mass*p->radius*p->radius*p->inverse_inertia;
    const int frozen = p->flags & DEM_PARTICLE_FROZEN, stays = p->inverse_mass == 0.0 && p->inverse_inertia == 0.0;

    DEM_REQUIRE(p->mass > 0.0, DEM_ERROR_FILE, "%s is damaged: particle %lld has a mass of %g kg, which must be above 0; use another one", path,
                (long long)p->id, p->mass);
    DEM_REQUIRE((p->flags & ~DEM_PARTICLE_FROZEN) == 0, DEM_ERROR_FILE, "%s is damaged: particle %lld has flags %#x, and the only one is %#x; use "
                "another one", path, (long long)p->id, p->flags, DEM_PARTICLE_FROZEN);
    DEM_REQUIRE(frozen ? stays : p->inverse_mass > 0.0 && p->inverse_mass*p->mass < 1.0 + 1e-9 && fabs(turns - 1.0) < 1e-9, DEM_ERROR_FILE,
                "%s is damaged: particle %lld, which is %s, of %g kg and radius %g m, has inverses %g 1/kg of its mass and %g 1/(kg m2) of its moment of "
                "inertia; use another one", path, (long long)p->id, frozen ? "frozen" : "free", p->mass, p->radius, p->inverse_mass,
                p->inverse_inertia);
    return DEM_OK;
}

int dem_snapshot_judge_particle(const char *path, const struct dem_snapshot_head *h, const double *packed)
{
    const size_t size = dem_snapshot_particle_doubles(h);
    struct dem_particle p;

    memcpy(&p, packed, sizeof p);
    DEM_REQUIRE(p.id >= 0 && p.id < INT64_MAX, DEM_ERROR_FILE, "%s is damaged: a particle has id %lld, and ids go from 0 to %lld; use another one",
                path, (long long)p.id, (long long)INT64_MAX - 1);
    if (!are_finite(packed, NUMBERS) || !are_finite(packed + BEHIND, size - BEHIND))
    {
        return name_culprit(path, h, &p, packed);
    }
    DEM_TRY(judge_motion(path, &p));
    return judge_inertia(path, &p);
}

/* ---- rows ------------------------------------------------------------------------------------------------------ */

int dem_snapshot_judge_row(const char *path, const struct dem_snapshot_head *h, const double *packed)
{
    const double *const memory = packed + DEM_SNAPSHOT_ROW;
    struct dem_carried name;

    if (are_finite(memory, (size_t)h->memories))
    {
        return DEM_OK;
    }
    memcpy(&name, packed, sizeof name);
    for (int64_t m = 0; m < h->memories; m++)
    {
        const char *const what = h->list[h->materials + h->columns + m].name;

        DEM_REQUIRE(isfinite(memory[m]) || name.high < 0, DEM_ERROR_FILE, "%s is damaged: of particles %lld and %lld it remembers %s %g, which should be "
                    "finite; use another one", path, (long long)name.low, (long long)name.high, what, memory[m]);
        DEM_REQUIRE(isfinite(memory[m]), DEM_ERROR_FILE, "%s is damaged: of particle %lld at a wall it remembers %s %g, which should be finite; use "
                    "another one", path, (long long)name.low, what, memory[m]);
    }
    return DEM_OK;
}

/* ---- the head -------------------------------------------------------------------------------------------------- */

static int is_count(int64_t n)
{
    return n >= 0 && (double)n <= most_counted;
}

static int judge_times(const char *path, const struct dem_snapshot_head *h)
{
    const struct dem_snapshot_window *const w = &h->window;

    DEM_REQUIRE(is_count(h->steps) && isless(fabs(h->time), most_time) && isless(fabs(w->opened), most_time) && isless(fabs(w->dt), most_time),
                DEM_ERROR_FILE, "%s is damaged: its head tells of %lld steps, the time %g s and a window from %g s on in steps of %g s; use another one",
                path, (long long)h->steps, h->time, w->opened, w->dt);
    DEM_REQUIRE(is_count(w->ahead) && is_count(w->done) && w->done <= w->ahead && w->done <= h->steps && (w->ahead == 0 || w->dt > 0.0), DEM_ERROR_FILE,
                "%s is damaged: its head tells of a window of %lld steps of %g s, of which %lld are done, after %lld steps in all; use another one", path,
                (long long)w->ahead, w->dt, (long long)w->done, (long long)h->steps);
    return DEM_OK;
}

static int judge_flow(const char *path, const struct dem_snapshot_flow *f)
{
    const double number[] = {f->mass, f->momentum[0], f->momentum[1], f->momentum[2], f->energy, f->rate, f->start, f->owed, f->since, f->last};

    for (size_t k = 0; k < sizeof number/sizeof *number; k++)
    {
        DEM_REQUIRE(isfinite(number[k]), DEM_ERROR_FILE, "%s is damaged: number %zu of the books of %s is %g, and should be finite; use another one",
                    path, k + 1, f->name, number[k]);
    }
    DEM_REQUIRE(is_count(f->count) && !isnan(f->end), DEM_ERROR_FILE, "%s is damaged: the books of %s tell of %lld particles, until %g s; use another one",
                path, f->name, (long long)f->count, f->end);
    return DEM_OK;
}

int dem_snapshot_judge_head(const char *path, const struct dem_snapshot_head *h)
{
    fenv_t caller;

    feholdexcept(&caller);                                /* a signalling not-a-number traps when it is compared */
    int status = judge_times(path, h);

    for (int64_t k = 0; k < h->flows && !status; k++)
    {
        status = judge_flow(path, &h->flow[k]);
    }
    fesetenv(&caller);
    return status;
}
