/*
 * energy_csv.c -- write the rows of energy.csv, stop the run when energy is created, and print the
 * largest residual.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/energy_csv.h"
#include "core/error.h"
#include "app/run_tables.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

int dem_energy_log_begin(struct dem_energy_log *log, const struct dem_program *prog,
                         const struct dem_output *o, const struct dem *d)
{
    *log = (struct dem_energy_log){.output = o, .interval = o->energy,
                                   .mechanical.when = o->start, .heat.when = o->start};
    dem_table_name(&log->table, o->folder, "energy.csv", o->start);
    if (log->interval <= 0.0)
    {
        return DEM_OK;
    }
    return dem_program_agree(prog,
                             prog->rank == 0 ? dem_table_begin(&log->table, d, 0) : DEM_OK);
}

struct row
{
    double now, since;
    int n;
    const struct dem_energy_item *item;
};

struct fastest
{
    double speed, x[3];  /* m/s, m */
    int64_t id;
};

/* The fastest particle of all ranks; of equally fast ones, the one on the lowest rank. */
static struct fastest find_fastest(const struct dem_program *prog, const struct dem *d)
{
    struct fastest f = {.speed = -1.0, .id = -1};
    struct
    {
        double speed;
        int rank;
    } mine, all;    /* MPI_DOUBLE_INT */
    struct dem_view v;

    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        const double *const u = dem_at(v.velocity, v.stride, k);
        const double *const x = dem_at(v.position, v.stride, k);
        const double speed = sqrt(u[0]*u[0] + u[1]*u[1] + u[2]*u[2]);

        if (speed > f.speed)
        {
            const int64_t *const id =
                (const int64_t *)(const void *)((const char *)v.id + k*v.stride);

            f = (struct fastest){speed, {x[0], x[1], x[2]}, *id};
        }
    }
    mine.speed = f.speed;
    mine.rank = prog->rank;
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE_INT, MPI_MAXLOC, MPI_COMM_WORLD);
    MPI_Bcast(&f, (int)sizeof f, MPI_BYTE, all.rank, MPI_COMM_WORLD);
    return f;
}

/* Heat balances by itself: what contacts dissipate is lost to the particles' motion and supplied to their heat
   content. The sign of a term in the balance of heat; 0: a term of the mechanical one. */
static double sign_of_heat(const char *name)
{
    return strncmp(name, "heat_", 5) != 0                                          ? 0.0
           : strcmp(name, "heat_content") == 0 || strcmp(name, "heat_left") == 0 ? 1.0
                                                                                   : -1.0;
}

/* The residuals of both balances and their largest terms. The last two items are the total and the residual. */
static void take_balances(const struct row *r, struct dem_energy_extreme *mechanical,
                          struct dem_energy_extreme *heat)
{
    *mechanical = *heat = (struct dem_energy_extreme){.when = r->now};
    for (int k = 0; k < r->n - 2; k++)
    {
        const double sign = sign_of_heat(r->item[k].name), value = r->item[k].value;
        struct dem_energy_extreme *const of = sign == 0.0 ? mechanical : heat;

        of->largest = fmax(of->largest, fabs(value));
        heat->residual += sign*value;
    }
    mechanical->residual = r->item[r->n - 1].value - heat->residual;
}

/* The residual of the balance has grown by more than the limit: an error with the amount, the
   interval, the fastest particle and the probable cause. */
static int check_created(struct dem_energy_log *log, const struct dem_program *prog, struct dem *d,
                         const struct dem_energy_extreme *now)
{
    const double created = now->residual - log->before, since = log->then, largest = now->largest;

    log->before = now->residual;
    log->then = now->when;
    if (log->output->max_created <= 0.0 || created <= log->output->max_created*largest)
    {
        return DEM_OK;
    }
    const struct dem_step_limit step = dem_step_limit(d);
    const struct fastest f = find_fastest(prog, d);

    return dem_error(DEM_ERROR_NUMBER,
                     "%.3g J were created between %.6g and %.6g s, %.3g of the largest term of the "
                     "energy balance; the limit time/maxCreated is %g; the fastest is particle "
                     "%lld at (%g %g %g) m with %g m/s; the step is %.3g s, its limit %.3g s (%s): "
                     "%s",
                     created, since, now->when, created/largest, log->output->max_created,
                     (long long)f.id, f.x[0], f.x[1], f.x[2], f.speed, step.used, step.limit,
                     step.why,
                     step.used > step.limit*(1.0 + 1e-9) ? "use at most the limit"
                                                           : "use a shorter time/step, or check "
                                                             "which effect's loss is negative");
}

static void update_extreme(struct dem_energy_extreme *e, const struct dem_energy_extreme *now)
{
    e->largest = fmax(e->largest, now->largest);
    if (fabs(now->residual) > fabs(e->residual))
    {
        e->residual = now->residual;
        e->when = now->when;
    }
}

int dem_energy_log_append(struct dem_energy_log *log, const struct dem_program *prog, struct dem *d,
                          double now)
{
    struct row r = {.now = now};
    struct dem_energy_extreme mechanical, heat;
    int status = DEM_OK;

    if (!dem_is_due(log->interval, now))
    {
        return DEM_OK;
    }
    DEM_TRY(dem_energy(d, &r.since, &r.n, &r.item));
    take_balances(&r, &mechanical, &heat);
    if (heat.largest > 0.0)
    {
        double stored;

        DEM_TRY(dem_scalar_total(d, dem_scalar_index(d, "temperature"), &stored));
        log->stored_heat = fmax(log->stored_heat, stored);
    }
    update_extreme(&log->mechanical, &mechanical);
    update_extreme(&log->heat, &heat);
    if (prog->rank == 0)
    {
        status = dem_table_add_energy(&log->table, d, r.now, r.since, r.n, r.item);
    }
    DEM_TRY(dem_program_agree(prog, status));
    return check_created(log, prog, d, &mechanical);
}

void dem_energy_log_print(const struct dem_energy_log *log, const struct dem_program *prog)
{
    const struct dem_energy_extreme *const m = &log->mechanical, *const h = &log->heat;

    if (log->interval > 0.0 && prog->rank == 0)
    {
        printf("energy: largest residual %.3g J at t %.6g s, %.2g %% of the largest term, %.4g J\n",
               m->residual, m->when, m->largest > 0.0 ? 100.0*fabs(m->residual)/m->largest : 0.0, m->largest);
        /* less is rounding of temperatures */
        if (h->largest > 1e-12*log->stored_heat)
        {
            printf("heat: content and supply differ by %.3g J at t %.6g s, %.2g %% of the largest term, %.4g J\n",
                   h->residual, h->when, 100.0*fabs(h->residual)/h->largest, h->largest);
        }
    }
}
