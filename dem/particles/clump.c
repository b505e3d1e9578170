/*
 * clump.c -- moves rigid bodies of several spheres (formulas and source: clump.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/clump.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "core/vec.h"
#include "particles/quaternion.h"
#include <math.h>
#include <string.h>

/* ---- rotations ------------------------------------------------------------------------------- */

void dem_clump_rotate(const double q[4], const double v[3], double out[3])
{
    dem_quaternion_rotate(q, 1.0, v, out);
}

void dem_clump_rotate_back(const double q[4], const double v[3], double out[3])
{
    dem_quaternion_rotate(q, -1.0, v, out);
}

void dem_clump_product(const double a[4], const double b[4], double out[4])
{
    dem_quaternion_product(a, b, out);
}

void dem_clump_spin(const struct dem_clump *b, double w[3])
{
    dem_quaternion_spin(b->q, b->inertia, b->momentum, w);
}

int dem_clump_check_spin(const struct dem_clump *b, const struct dem_particle *first, double dt,
                         int error)
{
    double w[3];

    dem_clump_spin(b, w);
    const double spin = dem_vec_norm(w);

    DEM_REQUIRE(spin*dt <= DEM_CLUMP_MAX_TURN, error,
                "the clump of particle %lld at (%g %g %g) m turns by %.3g rad in a step of %.3g s, at %.3g 1/s; "
                "the limit is %g rad; use a time/step of at most %.3g s, or check its spin and the forces on it",
                (long long)first->id, b->x[0], b->x[1], b->x[2], spin*dt, dt, spin, DEM_CLUMP_MAX_TURN,
                DEM_CLUMP_MAX_TURN/spin);
    return DEM_OK;
}

static void share_of_body(const struct dem_clump *b, struct dem_particle_share *s)
{
    double body[3];

    dem_clump_rotate_back(b->q, b->momentum, body);
    s->mass = b->mass;
    s->kinetic[0] = 0.5*b->mass*dem_vec_dot(b->v, b->v);
    for (int k = 0; k < 3; k++)
    {
        s->momentum[k] = b->mass*b->v[k];
        s->kinetic[1] += 0.5*body[k]*body[k]/b->inertia[k];
    }
}

void dem_particle_share(const struct dem_particles *p, size_t i, struct dem_particle_share *s)
{
    const struct dem_particle *const r = &p->record[i];
    const struct dem_clump *const b = dem_clump_of(p, i);
    const double inertia = 0.4*r->mass*r->radius*r->radius;

    *s = (struct dem_particle_share){.mass = 0.0};
    if (b && dem_clump_counts(r))
    {
        share_of_body(b, s);
    }
    else if (!b)
    {
        s->mass = r->mass;
        s->kinetic[0] = 0.5*r->mass*dem_vec_dot(r->v, r->v);
        s->kinetic[1] = 0.5*inertia*dem_vec_dot(r->w, r->w);
        for (int k = 0; k < 3; k++)
        {
            s->momentum[k] = r->mass*r->v[k];
        }
    }
}

/* ---- lists ----------------------------------------------------------------------------------- */

double dem_clumps_reach(const struct dem_particles *p)
{
    double reach = 0.0;

    for (size_t i = 0; i < p->n; i++)
    {
        const struct dem_clump *const b = dem_clump_of(p, i);

        reach = b ? fmax(reach, dem_vec_norm(b->offset)) : reach;
    }
    return reach;
}

void dem_clumps_free(struct dem_clumps *c)
{
    dem_memory_free(c->start);
    dem_memory_free(c->member);
    dem_memory_free(c->arm);
    memset(c, 0, sizeof *c);
}

/* Sorted by id, the spheres of a body follow each other. */
static void fill(struct dem_clumps *c, const struct dem_particles *p, size_t members, uint64_t *key,
                 uint32_t *scratch)
{
    size_t k = 0;

    for (size_t i = 0; i < p->n; i++)
    {
        if (p->record[i].body)
        {
            key[k] = (uint64_t)p->record[i].id;
            c->member[k++] = (uint32_t)i;
        }
    }
    dem_sort_keys(key, c->member, members, key + members, scratch);
    for (k = 0; k < members; k++)
    {
        if (k == 0 || p->record[c->member[k]].body != p->record[c->member[k - 1]].body)
        {
            c->start[c->n++] = k;
        }
    }
    c->start[c->n] = members;
    for (k = 0; k < members; k++)
    {
        const struct dem_clump *const b = dem_clump_at(p, c->member[k]);

        dem_clump_rotate(b->q, b->offset, c->arm[k]);
    }
}

int dem_clumps_index(struct dem_clumps *c, const struct dem_particles *p)
{
    uint32_t *scratch = NULL;
    uint64_t *key = NULL;
    size_t members = 0;

    c->n = 0;
    if (!dem_column(p, DEM_COLUMN_CLUMP))
    {
        return DEM_OK;
    }
    for (size_t i = 0; i < p->n; i++)
    {
        members += p->record[i].body != 0;
    }
    DEM_TRY(DEM_GROW(c->start, c->start_capacity, members + 1));
    DEM_TRY(DEM_GROW(c->member, c->member_capacity, members + 1));
    DEM_TRY(DEM_GROW(c->arm, c->arm_capacity, members + 1));
    int status = DEM_NEW(key, 2*members + 1);

    status = status ? status : DEM_NEW(scratch, members + 1);
    if (!status)
    {
        fill(c, p, members, key, scratch);
    }
    dem_memory_free(key);
    dem_memory_free(scratch);
    return status;
}

/* ---- motion ---------------------------------------------------------------------------------- */

static double rounded(const struct dem_domain *d, int k, double value)
{
    return (value + d->round[k]) - d->round[k];
}

/* The displacement [m] that brings sphere i to its place, R r_k from the centre. */
static void displacement(const struct dem_particles *p, size_t i, const struct dem_domain *d,
                         const double arm[3], double move[3])
{
    const struct dem_clump *const b = dem_clump_at(p, i);

    for (int k = 0; k < 3; k++)
    {
        const double to = b->x[k] + rounded(d, k, arm[k]) - p->record[i].x[k];

        move[k] = d->periodic[k] ? to - d->length[k]*rint(to/d->length[k]) : to;
    }
}

void dem_clump_wrap(const struct dem_domain *d, const struct dem_particles *p, size_t i)
{
    struct dem_clump *const b = dem_clump_of(p, i);
    struct dem_particle centre = {.radius = 0.0};

    if (b)
    {
        memcpy(centre.x, b->x, sizeof b->x);
        dem_domain_wrap(d, &centre);
        memcpy(b->x, centre.x, sizeof b->x);
    }
}

void dem_clump_put(const struct dem_clump *b, const struct dem_domain *d, struct dem_particle *r)
{
    double w[3], arm[3], turning[3];

    dem_clump_rotate(b->q, b->offset, arm);
    dem_clump_spin(b, w);
    dem_vec_cross(w, arm, turning);
    for (int k = 0; k < 3; k++)
    {
        r->x[k] = b->x[k] + rounded(d, k, arm[k]);
        r->v[k] = b->v[k] + turning[k];
        r->w[k] = w[k];
    }
}

/* Bodies that turn side by side: drift them, and write their places to all spheres. */
static void drift_several(const struct dem_clumps *c, struct dem_particles *p, const struct dem_domain *d,
                          double dt, const size_t *of, int n)
{
    struct dem_clump *body[DEM_CLUMP_LANES] = {NULL};
    double spin[DEM_CLUMP_LANES][3], move[3];

    for (int m = 0; m < n; m++)
    {
        body[m] = dem_clump_at(p, c->member[c->start[of[m]]]);
        for (int k = 0; k < 3; k++)
        {
            body[m]->x[k] += rounded(d, k, dt*body[m]->v[k]);
        }
    }
    dem_clump_turn_several(body, n, dt, spin);
    for (int m = 0; m < n; m++)
    {
        for (size_t k = c->start[of[m]]; k < c->start[of[m] + 1]; k++)
        {
            struct dem_particle *const r = &p->record[c->member[k]];
            struct dem_clump *const to = dem_clump_at(p, c->member[k]);

            memmove(to->x, body[m]->x, sizeof to->x);
            memmove(to->q, body[m]->q, sizeof to->q);
            dem_clump_rotate(to->q, to->offset, c->arm[k]);
            displacement(p, c->member[k], d, c->arm[k], move);
            for (int a = 0; a < 3; a++)
            {
                r->v[a] = move[a]/dt;
                r->w[a] = spin[m][a];
            }
        }
    }
}

void dem_clumps_drift(const struct dem_clumps *c, struct dem_particles *p,
                      const struct dem_domain *d, double dt)
{
    size_t moving[DEM_CLUMP_LANES];
    int n = 0;

    for (size_t body = 0; body < c->n; body++)
    {
        moving[n] = body;
        n += !dem_clumps_frozen(c, body, p);
        if (n == DEM_CLUMP_LANES || (n > 0 && body + 1 == c->n))
        {
            drift_several(c, p, d, dt, moving, n);
            n = 0;
        }
    }
}

/* Velocity and spin of a sphere from its body, which has the spin w. */
static void set_velocity(struct dem_particles *p, size_t i, const double arm[3], const double w[3])
{
    const struct dem_clump *const b = dem_clump_at(p, i);
    double turning[3];

    dem_vec_cross(w, arm, turning);
    for (int a = 0; a < 3; a++)
    {
        p->record[i].v[a] = b->v[a] + turning[a];
        p->record[i].w[a] = w[a];
    }
}

void dem_clump_fall(struct dem_particles *p, size_t i, const double g[3], double h)
{
    struct dem_clump *const b = dem_clump_of(p, i);

    for (int a = 0; b && a < 3; a++)
    {
        b->v[a] += h*g[a];
    }
    if (b)
    {
        double w[3], arm[3];

        dem_clump_spin(b, w);
        dem_clump_rotate(b->q, b->offset, arm);
        set_velocity(p, i, arm, w);
    }
}

void dem_clump_contact_sums(const struct dem_clumps *c, size_t body, const struct dem_particles *p,
                            double F[3], double T[3])
{
    const double *const force = dem_column(p, DEM_COLUMN_FORCE),
                 *const torque = dem_column(p, DEM_COLUMN_TORQUE);

    for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
    {
        const size_t i = c->member[k];
        double moment[3];

        dem_vec_cross(c->arm[k], force + 3*i, moment);
        for (int a = 0; a < 3; a++)
        {
            F[a] += force[3*i + (size_t)a];
            T[a] += moment[a] + torque[3*i + (size_t)a];
        }
    }
}

void dem_clump_spread(const struct dem_clumps *c, size_t body, struct dem_particles *p)
{
    const struct dem_clump *const b = dem_clump_at(p, c->member[c->start[body]]);
    double w[3];

    dem_clump_spin(b, w);
    for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
    {
        struct dem_clump *const to = dem_clump_at(p, c->member[k]);

        memmove(to->v, b->v, sizeof to->v);
        memmove(to->momentum, b->momentum, sizeof to->momentum);
        set_velocity(p, c->member[k], c->arm[k], w);
    }
}

void dem_clumps_kick(const struct dem_clumps *c, struct dem_particles *p, const double g[3], double h)
{
    for (size_t body = 0; body < c->n; body++)
    {
        struct dem_clump *const b = dem_clump_at(p, c->member[c->start[body]]);
        double F[3] = {0.0, 0.0, 0.0}, T[3] = {0.0, 0.0, 0.0};
        const int moves = !dem_clumps_frozen(c, body, p);

        dem_clump_contact_sums(c, body, p, F, T);
        for (int a = 0; a < 3 && moves; a++)
        {
            b->v[a] += h*(F[a]/b->mass + g[a]);
            b->momentum[a] += h*T[a];
        }
        dem_clump_spread(c, body, p);
    }
}
