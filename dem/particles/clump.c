/*
 * clump.c -- one rigid body of several spheres: rotation, spin, wrapping, places of new spheres (formulas and source: clump.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/clump.h"
#include "core/error.h"
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

/* ---- motion ---------------------------------------------------------------------------------- */

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
        r->x[k] = b->x[k] + ((arm[k] + d->round[k]) - d->round[k]);
        r->v[k] = b->v[k] + turning[k];
        r->w[k] = w[k];
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
        double w[3], arm[3], turning[3];

        dem_clump_spin(b, w);
        dem_clump_rotate(b->q, b->offset, arm);
        dem_vec_cross(w, arm, turning);
        for (int a = 0; a < 3; a++)
        {
            p->record[i].v[a] = b->v[a] + turning[a];
            p->record[i].w[a] = w[a];
        }
    }
}
