/*
 * mesh.h -- surfaces of triangles for tests: a flat floor cut at random, boxes, in any position.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "physics/world.h"

#include "core/random.h"

struct mesh
{
    size_t n, room;
    double *corner;                                       /* 9 a triangle */
};

static inline void mesh_triangle(struct mesh *m, const double a[3], const double b[3],
                                 const double c[3])
{
    if (m->n == m->room)
    {
        m->room = 2*m->room + 64;
        m->corner = realloc(m->corner, 9*m->room*sizeof *m->corner);
    }
    memcpy(m->corner + 9*m->n, a, 3*sizeof *a);
    memcpy(m->corner + 9*m->n + 3, b, 3*sizeof *b);
    memcpy(m->corner + 9*m->n + 6, c, 3*sizeof *c);
    m->n++;
}

/* a, b, c, d in turn */
static inline void mesh_quad(struct mesh *m, const double a[3], const double b[3],
                             const double c[3], const double d[3])
{
    mesh_triangle(m, a, b, c);
    mesh_triangle(m, a, c, d);
}

/* Random numbers that do not depend on the C library. */
static inline double mesh_random(uint64_t number, uint64_t use)
{
    return dem_random_unit(20240101, number, 0, use);
}

/* z = 0 over [from, to] x [from, to], cut into about `size`: lines at random distances (down to
   1/100 of the others), inner nodes shifted in the plane, each quadrilateral cut along a random
   diagonal, triangles facing up or down. */
static inline struct mesh mesh_floor(double from, double to, double size)
{
    const int n = (int)((to - from)/size) + 1;
    struct mesh m = {0};
    double *const line = malloc((size_t)(n + 1)*sizeof *line),
                  (*const node)[3] = malloc((size_t)((n + 1)*(n + 1))*sizeof *node);

    for (int k = 0; k <= n; k++)
    {
        line[k] = from + (to - from)*k/n;
        line[k] -= k > 0 && k < n && k%5 == 0 ? 0.99*(to - from)/n
                                                : 0.0;       /* slivers: 1/100 of a cell wide */
    }
    for (int k = 0; k < (n + 1)*(n + 1); k++)
    {
        const int i = k%(n + 1), j = k/(n + 1);
        const double sx = i > 0 && i < n ? fmin(line[i + 1] - line[i], line[i] - line[i - 1]) : 0.0;
        const double sy = j > 0 && j < n ? fmin(line[j + 1] - line[j], line[j] - line[j - 1]) : 0.0;

        node[k][0] = line[i] + 0.4*sx*(2.0*mesh_random((uint64_t)k, 1) - 1.0);
        node[k][1] = line[j] + 0.4*sy*(2.0*mesh_random((uint64_t)k, 2) - 1.0);
        node[k][2] = 0.0;
    }
    for (int k = 0; k < n*n; k++)
    {
        const int a = k%n + k/n*(n + 1), corner[4] = {a, a + 1, a + n + 2, a + n + 1};
        const int turn = (int)(4.0*mesh_random((uint64_t)k, 3));

        mesh_quad(&m, node[corner[turn]], node[corner[(turn + 1)%4]],
                  node[corner[(turn + 2)%4]], node[corner[(turn + 3)%4]]);
        if (mesh_random((uint64_t)k, 4) < 0.5)
        {
            double *const last = m.corner + 9*(m.n - 1);

            for (int s = 0; s < 3; s++)
            {
                const double swap = last[s];

                last[s] = last[3 + s];
                last[3 + s] = swap;
            }
        }
    }
    free(line);
    free(node);
    return m;
}

static inline void mesh_hand_over(struct dem_case *c, const char *name, const char *material,
                                  struct mesh *m)
{
    WORLD_TRY(dem_case_add_wall(c, name, material, (int64_t)m->n, m->corner));
    free(m->corner);
    *m = (struct mesh){0};
}

static inline void mesh_add_floor(struct dem_case *c, const char *name, const char *material,
                                  double from, double to, double size)
{
    struct mesh m = mesh_floor(from, to, size);

    mesh_hand_over(c, name, material, &m);
}

/* The six sides of a box, each of two triangles, seen alike from inside and outside. */
static inline struct mesh mesh_box(const double min[3], const double max[3])
{
    struct mesh m = {0};

    for (int axis = 0; axis < 3; axis++)
    {
        const int u = (axis + 1)%3, v = (axis + 2)%3;

        for (int side = 0; side < 2; side++)
        {
            double c[4][3];

            for (int k = 0; k < 4; k++)
            {
                c[k][axis] = side ? max[axis] : min[axis];
                c[k][u] = k == 1 || k == 2 ? max[u] : min[u];
                c[k][v] = k >= 2 ? max[v] : min[v];
            }
            mesh_quad(&m, c[0], c[1], c[2], c[3]);
        }
    }
    return m;
}
