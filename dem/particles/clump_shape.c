/*
 * clump_shape.c -- reads templates of rigid bodies; volume, centre and principal moments of inertia of
 * a union of spheres.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/clump_shape.h"
#include "core/did_you_mean.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "particles/particles.h"
#include <math.h>
#include <string.h>

enum
{
    COLUMNS = 1024                    /* along x and y, at least */
};

struct moments    /* integrals of 1, x, and x x^T over a body, about `origin` */
{
    double origin[3], volume, first[3], second[3][3];
};

/* ---- integrals ------------------------------------------------------------------------------- */

static int overlap(const struct dem_clump_shape *s)
{
    int any = 0;

    for (size_t i = 0; i < s->n; i++)
    {
        for (size_t j = 0; j < i; j++)
        {
            double d[3];

            dem_vec_minus(s->sphere[i], s->sphere[j], d);
            any |= dem_vec_norm(d) < (s->sphere[i][3] + s->sphere[j][3])*(1.0 - 1e-12);
        }
    }
    return any;
}

static void add_spheres(const struct dem_clump_shape *s, struct moments *m)
{
    for (size_t i = 0; i < s->n; i++)
    {
        const double *const at = s->sphere[i], r = at[3], V = dem_sphere_volume(r);
        double d[3];

        dem_vec_minus(at, m->origin, d);
        m->volume += V;
        for (int a = 0; a < 3; a++)
        {
            m->first[a] += V*d[a];
            for (int b = 0; b < 3; b++)
            {
                m->second[a][b] += V*(d[a]*d[b] + (a == b ? 0.2*r*r : 0.0));
            }
        }
    }
}

/* The part of a column at (x, y) of cross-section `area` between two heights. */
static void add_part(struct moments *m, const double at[2], double area, const double z[2])
{
    const double V = area*(z[1] - z[0]), middle = 0.5*(z[0] + z[1]);
    const double d[3] = {at[0], at[1], middle};

    m->volume += V;
    for (int a = 0; a < 3; a++)
    {
        m->first[a] += V*d[a];
        for (int b = 0; b < 3; b++)
        {
            m->second[a][b] += V*d[a]*d[b];
        }
    }
    m->second[2][2] += V*(z[1] - z[0])*(z[1] - z[0])/12.0;
}

/* The parts of a column inside the spheres, sorted and merged. */
static void add_column(const struct dem_clump_shape *s, struct moments *m, const double at[2],
                       double area)
{
    double part[DEM_CLUMP_SPHERES][2];
    size_t n = 0;

    for (size_t i = 0; i < s->n; i++)
    {
        const double *const c = s->sphere[i];
        const double x = at[0] - (c[0] - m->origin[0]), y = at[1] - (c[1] - m->origin[1]);
        const double square = c[3]*c[3] - x*x - y*y;
        size_t k = n;

        if (square > 0.0)
        {
            const double z = c[2] - m->origin[2], half = sqrt(square);

            for (; k > 0 && part[k - 1][0] > z - half; k--)
            {
                memcpy(part[k], part[k - 1], sizeof *part);
            }
            part[k][0] = z - half;
            part[k][1] = z + half;
            n++;
        }
    }
    for (size_t k = 0; k < n; k++)
    {
        while (k + 1 < n && part[k + 1][0] <= part[k][1])
        {
            part[k + 1][0] = part[k][0];
            part[k + 1][1] = fmax(part[k][1], part[k + 1][1]);
            k++;
        }
        add_part(m, at, area, part[k]);
    }
}

/* Largest width of a column [m]. */
static double width(const struct dem_clump_shape *s)
{
    double sum[3] = {0.0, 0.0, 0.0};

    for (size_t k = 0; k < s->n; k++)
    {
        const double r = s->sphere[k][3];

        sum[0] += r;
        sum[1] += r*r;
        sum[2] += r*r*r;
    }
    return fmax(sqrt(sum[2]/sum[0])/150.0, sqrt(3.14159265358979324*sum[1]/8e6));
}

/* The spheres that a row of columns meets at y, in the order of where they begin, and the first and last
   column of each. */
struct row
{
    size_t n;
    double sphere[DEM_CLUMP_SPHERES][4];
    long range[DEM_CLUMP_SPHERES][2];
};

static void find_row(struct row *w, const struct dem_clump_shape *s, const struct moments *m, double y,
                     double half, double h)
{
    w->n = 0;
    for (size_t k = 0; k < s->n; k++)
    {
        const double *const c = s->sphere[k];
        const double d = y - (c[1] - m->origin[1]), x = c[0] - m->origin[0] + half;

        if (fabs(d) < c[3])
        {
            const double reach = sqrt(c[3]*c[3] - d*d);
            const long from = (long)fmax(0.0, floor((x - reach)/h - 0.5));
            size_t at = w->n++;

            for (; at > 0 && w->range[at - 1][0] > from; at--)
            {
                memcpy(w->range[at], w->range[at - 1], sizeof *w->range);
                memcpy(w->sphere[at], w->sphere[at - 1], sizeof *w->sphere);
            }
            w->range[at][0] = from;
            w->range[at][1] = (long)ceil((x + reach)/h - 0.5);
            memcpy(w->sphere[at], c, sizeof *w->sphere);
        }
    }
}

/* Only columns that meet a sphere, with the spheres that they may meet. */
static void add_columns(const struct dem_clump_shape *s, struct moments *m, const double half[3])
{
    const double most = width(s);
    const long n[2] = {(long)fmax(COLUMNS, ceil(2.0*half[0]/most)),
                       (long)fmax(COLUMNS, ceil(2.0*half[1]/most))};
    const double h[2] = {2.0*half[0]/(double)n[0], 2.0*half[1]/(double)n[1]};
    struct row w;

    for (long j = 0; j < n[1]; j++)
    {
        const double y = ((double)j + 0.5)*h[1] - half[1];
        struct dem_clump_shape near = {.n = 0};
        size_t first = 0, end = 0;

        find_row(&w, s, m, y, half[0], h[0]);
        for (long i = w.n > 0 ? w.range[0][0] : n[0]; i < n[0]; i++)
        {
            while (end < w.n && w.range[end][0] <= i)
            {
                end++;
            }
            while (first < end && w.range[first][1] < i)
            {
                first++;
            }
            if (first == end && end == w.n)
            {
                break;
            }
            near.sphere = (const double (*)[4])(w.sphere + first);
            near.n = end - first;
            add_column(&near, m, (const double[2]){((double)i + 0.5)*h[0] - half[0], y}, h[0]*h[1]);
        }
    }
}

/* ---- principal axes -------------------------------------------------------------------------- */

/* Jacobi rotations of a symmetric matrix A; the columns of R are its eigenvectors. */
static void diagonalise(double A[3][3], double R[3][3])
{
    const double small = 1e-14*(fabs(A[0][0]) + fabs(A[1][1]) + fabs(A[2][2]));

    for (int turn = 0; turn < 60; turn++)
    {
        const int p = turn%3 == 2, q = turn%3 == 0 ? 1 : 2;

        if (fabs(A[p][q]) > small)
        {
            const double theta = 0.5*(A[q][q] - A[p][p])/A[p][q];
            const double t = (theta < 0.0 ? -1.0 : 1.0)/(fabs(theta) + sqrt(theta*theta + 1.0));
            const double c = 1.0/sqrt(t*t + 1.0), s = t*c;

            for (int k = 0; k < 3; k++)
            {
                const double a = A[k][p], b = A[k][q], e = R[k][p], f = R[k][q];

                A[k][p] = c*a - s*b, A[k][q] = s*a + c*b;
                R[k][p] = c*e - s*f, R[k][q] = s*e + c*f;
            }
            for (int k = 0; k < 3; k++)
            {
                const double a = A[p][k], b = A[q][k];

                A[p][k] = c*a - s*b, A[q][k] = s*a + c*b;
            }
        }
    }
}

/* The quaternion of a rotation matrix: of four forms the one with the largest divisor. */
static void quaternion(double R[3][3], double q[4])
{
    const double size[4] = {1.0 + R[0][0] + R[1][1] + R[2][2], 1.0 + R[0][0] - R[1][1] - R[2][2],
                            1.0 - R[0][0] + R[1][1] - R[2][2], 1.0 - R[0][0] - R[1][1] + R[2][2]};
    const double odd[3] = {R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]};
    int most = 0;

    for (int k = 1; k < 4; k++)
    {
        most = size[k] > size[most] ? k : most;
    }
    const double scale = 0.5/sqrt(size[most]);

    q[most] = scale*size[most];
    for (int k = 0; k < 4; k++)
    {
        if (k != most)
        {
            q[k] = scale*(most == 0 ? odd[k - 1]
                          : k == 0  ? odd[most - 1]
                                    : R[most - 1][k - 1] + R[k - 1][most - 1]);
        }
    }
}

/* See clump_shape.h. */
static double step_volume(const struct dem_clump_shape *s)
{
    double contacts = (double)s->n;

    for (int a = 0; a < 3; a++)
    {
        const int b = (a + 1)%3, c = (a + 2)%3;
        double squares = 0.0;

        for (size_t k = 0; k < s->n; k++)
        {
            const double *const r = s->offset[k];

            squares += r[b]*r[b] + r[c]*r[c];
        }
        contacts = fmax(contacts, s->volume*squares/s->inertia[a]);
    }
    return s->volume/contacts*fmin(1.0, 4.0/contacts);
}

/* Centre, inertia and offsets from the integrals. */
static int finish(struct dem_clump_shape *s, const struct moments *m)
{
    double A[3][3], R[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}, square[3];

    s->volume = m->volume;
    for (int a = 0; a < 3; a++)
    {
        s->centre[a] = m->origin[a] + m->first[a]/m->volume;
        for (int b = 0; b < 3; b++)
        {
            A[a][b] = m->second[a][b] - m->first[a]*m->first[b]/m->volume;
        }
    }
    diagonalise(A, R);
    quaternion(R, s->principal);
    for (int a = 0; a < 3; a++)
    {
        square[a] = A[a][a];
    }
    for (int a = 0; a < 3; a++)
    {
        s->inertia[a] = square[(a + 1)%3] + square[(a + 2)%3];
    }
    DEM_TRY(DEM_NEW(s->offset, s->n));
    for (size_t k = 0; k < s->n; k++)
    {
        double d[3];

        dem_vec_minus(s->sphere[k], s->centre, d);
        for (int a = 0; a < 3; a++)
        {
            s->offset[k][a] = R[0][a]*d[0] + R[1][a]*d[1] + R[2][a]*d[2];
        }
        s->reach = fmax(s->reach, dem_vec_norm(d));
        s->bound = fmax(s->bound, dem_vec_norm(d) + s->sphere[k][3]);
        s->solid += dem_sphere_volume(s->sphere[k][3]);
    }
    s->step_volume = step_volume(s);
    return DEM_OK;
}

/* ---- reading --------------------------------------------------------------------------------- */

static int measure(struct dem_clump_shape *s)
{
    struct moments m = {.volume = 0.0};
    double half[3];

    for (int k = 0; k < 3; k++)
    {
        double low = INFINITY, high = -INFINITY;

        for (size_t i = 0; i < s->n; i++)
        {
            low = fmin(low, s->sphere[i][k] - s->sphere[i][3]);
            high = fmax(high, s->sphere[i][k] + s->sphere[i][3]);
        }
        m.origin[k] = 0.5*(low + high);
        half[k] = 0.5*(high - low);
    }
    if (overlap(s))
    {
        add_columns(s, &m, half);
    }
    else
    {
        add_spheres(s, &m);
    }
    return finish(s, &m);
}

static int read_shape(struct dem_clump_shape *s, const struct dem_dict *dict)
{
    *s = (struct dem_clump_shape){.name = dem_dict_name(dict)};
    DEM_TRY(dem_dict_fours(dict, "spheres", "m", &s->sphere, &s->n));
    DEM_REQUIRE(s->n > 0 && s->n <= DEM_CLUMP_SPHERES, DEM_ERROR_INPUT,
                "%s: shapes/%s has %zu spheres; give 1 to %d", dem_dict_where(dict), s->name, s->n,
                DEM_CLUMP_SPHERES);
    for (size_t k = 0; k < s->n; k++)
    {
        const double *const at = s->sphere[k], r = at[3];

        DEM_REQUIRE(isnormal(r*r*r*r*r) && r > 0.0 &&
                        fmax(fabs(at[0]), fmax(fabs(at[1]), fabs(at[2]))) <= 1e3*s->sphere[0][3],
                    DEM_ERROR_INPUT,
                    "%s: shapes/%s: sphere %zu at (%g %g %g) m has radius %g m; give a radius above 0, "
                    "and coordinates of at most 1000 radii of the first sphere",
                    dem_dict_where(dict), s->name, k + 1, at[0], at[1], at[2], r);
    }
    return measure(s);
}

int dem_clump_shapes_read(struct dem_clump_shapes *all, const struct dem_dict *scene)
{
    const struct dem_dict *shapes;

    DEM_TRY(dem_dict_sub_if(scene, "shapes", &shapes));
    for (size_t k = 0; shapes && k < dem_dict_count(shapes); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(shapes, k);

        DEM_REQUIRE(dem_entry_is_dict(e), DEM_ERROR_INPUT,
                    "%s: shapes holds entries like %s { spheres ((x y z r) ...); }",
                    dem_entry_where(e), dem_entry_name(e));
        DEM_TRY(DEM_GROW(all->shape, all->capacity, all->n + 1));
        DEM_TRY(read_shape(&all->shape[all->n++], dem_entry_dict(e)));
    }
    return DEM_OK;
}

void dem_clump_shapes_free(struct dem_clump_shapes *all)
{
    for (size_t k = 0; k < all->n; k++)
    {
        dem_memory_free(all->shape[k].offset);
    }
    dem_memory_free(all->shape);
    memset(all, 0, sizeof *all);
}

int dem_clump_shapes_find(const struct dem_clump_shapes *all, const char *name, const char *where,
                          const struct dem_clump_shape **found)
{
    const char **names;

    for (size_t k = 0; k < all->n; k++)
    {
        if (strcmp(all->shape[k].name, name) == 0)
        {
            *found = &all->shape[k];
            return DEM_OK;
        }
    }
    DEM_REQUIRE(all->n > 0, DEM_ERROR_INPUT,
                "%s: shape %s, but the scene has no shapes; add shapes { %s { spheres ((x y z r) ...); "
                "} }", where, name, name);
    DEM_TRY(DEM_NEW(names, all->n));
    for (size_t k = 0; k < all->n; k++)
    {
        names[k] = all->shape[k].name;
    }
    const int status = dem_did_you_mean_error("shape", name, names, (int)all->n);

    dem_memory_free(names);
    return dem_error_prefix(status, "%s: ", where);
}

const struct dem_clump_shape *dem_clump_shapes_with_volume(const struct dem_clump_shapes *all,
                                                           double volume)
{
    const struct dem_clump_shape *found = NULL;

    for (size_t k = 0; k < all->n; k++)
    {
        const struct dem_clump_shape *const s = &all->shape[k];

        if (fabs(volume - s->volume) < 1e-9*volume && (!found || s->step_volume < found->step_volume))
        {
            found = s;
        }
    }
    return found;
}
