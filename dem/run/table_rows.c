/*
 * table_rows.c -- the rows of lost.csv, bonds.csv, flows.csv, walls.csv and energy.csv.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "dem_query.h"
#include "dem_tables.h"
#include "core/error.h"
#include "core/text.h"
#include "core/vec.h"
#include <math.h>

static int append(const struct dem_table *table, const struct dem *d, const char *columns,
                  struct dem_text *rows)
{
    const int status = rows->status ? rows->status
                     : rows->text   ? dem_table_append(table, d, columns, rows->text)
                                    : DEM_OK;

    dem_text_free(rows);
    return status;
}

int dem_table_add_losses(const struct dem_table *table, const struct dem *d, int64_t n,
                         const struct dem_loss *loss, double offset, const char *const *patch)
{
    struct dem_text t = {0};

    for (int64_t k = 0; k < n; k++)
    {
        const double *const x = loss[k].position, *const v = loss[k].velocity;

        dem_text_add(&t, "%lld,%.10g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,\"%s%s\"\n",
                     (long long)loss[k].id, loss[k].time + offset, x[0], x[1], x[2], v[0], v[1],
                     v[2], loss[k].diameter, loss[k].cause, patch ? patch[k] : "");
    }
    return append(table, d, "id,time,x,y,z,vx,vy,vz,diameter,cause", &t);
}

int dem_table_add_bonds(const struct dem_table *table, const struct dem *d, int64_t n,
                        const struct dem_broken_bond *b, double offset)
{
    struct dem_text t = {0};

    for (int64_t k = 0; k < n; k++)
    {
        const double *const x = b[k].position;

        dem_text_add(&t, "%.10g,%lld,%lld,%.9g,%.9g,%.9g,%s,%.9g\n", b[k].time + offset,
                     (long long)b[k].id[0], (long long)b[k].id[1], x[0], x[1], x[2],
                     dem_broken_bond_cause(b[k].cause), b[k].energy);
    }
    return append(table, d, "time,id1,id2,x,y,z,cause,energy", &t);
}

/* ---- streams and outlets --------------------------------------------------------------------- */

static void remember(struct dem_flow_sums *s, int n, const struct dem_flow *flow, double now)
{
    s->time = now;
    for (int k = 0; k < n; k++)
    {
        s->particles[k] = (double)flow[k].particles;
        s->mass[k] = flow[k].mass;
    }
}

int dem_flow_sums_set(struct dem_flow_sums *s, struct dem *d, double now)
{
    const struct dem_flow *flow;
    int n;

    DEM_TRY(dem_flows(d, &n, &flow));
    remember(s, n, flow, now);
    return DEM_OK;
}

int dem_table_add_flows(const struct dem_table *table, struct dem *d, double now,
                        struct dem_flow_sums *last)
{
    static const char *const way[] = {"out", "in", "forth", "back"};
    const double over = now > last->time ? 1.0/(now - last->time) : 0.0;
    const struct dem_flow *flow;
    struct dem_text t = {0};
    int n;

    DEM_TRY(dem_flows(d, &n, &flow));
    for (int k = 0; k < n; k++)
    {
        const struct dem_flow *const w = &flow[k];

        dem_text_add(&t, "%.10g,%s,%s,%lld,%.9g,%.9g,%.9g,%.9g,%.9g,%lld,%.9g,%.9g\n", now, w->name,
                     way[w->enters], (long long)w->particles, w->mass, w->momentum[0],
                     w->momentum[1], w->momentum[2], w->energy, (long long)w->waiting,
                     over*((double)w->particles - last->particles[k]),
                     over*(w->mass - last->mass[k]));
    }
    remember(last, n, flow, now);
    if (!table || n == 0)
    {
        dem_text_free(&t);
        return DEM_OK;
    }
    return append(table, d,
                  "time[s],name,way,particles,mass[kg],px[Ns],py[Ns],pz[Ns],energy[J],waiting,"
                  "rate[1/s],massRate[kg/s]",
                  &t);
}

int dem_table_add_residence(const struct dem_table *table, struct dem *d, double now)
{
    const struct dem_flow *flow;
    struct dem_text t = {0}, columns = {0};
    int n;

    DEM_TRY(dem_flows(d, &n, &flow));
    dem_text_add(&columns, "time[s],name,particles,mean[s],variance[s2],end[s]");
    for (int b = 0; b < DEM_RESIDENCE_BINS; b++)
    {
        dem_text_add(&columns, ",bin%d", b);
    }
    for (int k = 0; k < n; k++)
    {
        const struct dem_residence *const r = dem_residence(d, k);

        if (r)
        {
            const double over = r->particles > 0 ? 1.0/(double)r->particles : 0.0, mean = over*r->sum;

            dem_text_add(&t, "%.10g,%s,%lld,%.9g,%.9g,%.9g", now, flow[k].name, (long long)r->particles, mean,
                         fmax(over*r->squares - mean*mean, 0.0), r->end);
            for (int b = 0; b < DEM_RESIDENCE_BINS; b++)
            {
                dem_text_add(&t, ",%lld", (long long)r->bin[b]);
            }
            dem_text_add(&t, "\n");
        }
    }
    const int status = columns.status ? columns.status : append(table, d, columns.text, &t);

    dem_text_free(&columns);
    return status;
}

/* ---- cell ------------------------------------------------------------------------------------ */

int dem_table_add_cell(const struct dem_table *table, struct dem *d, double now)
{
    struct dem_text t = {0};
    struct dem_cell_now c;

    DEM_TRY(dem_cell(d, &c));
    if (!table)
    {
        return DEM_OK;
    }
    dem_text_add(&t, "%.10g,%.12g,%.12g,%.12g,%.9g,%.9g,%.9g", now, c.length[0], c.length[1], c.length[2],
                 c.rate[0], c.rate[1], c.rate[2]);
    for (int k = 0; k < 6; k++)
    {
        dem_text_add(&t, ",%.9g", c.stress[k]);
    }
    for (int k = 0; k < 6; k++)
    {
        dem_text_add(&t, ",%.9g", c.fabric[k]);
    }
    dem_text_add(&t, ",%.9g,%.0f,%.9g,%.9g\n", c.solid, c.contacts, c.shear_rate, c.shear);
    return append(table, d,
                  "time[s],Lx[m],Ly[m],Lz[m],Dxx[1/s],Dyy[1/s],Dzz[1/s],sxx[Pa],syy[Pa],szz[Pa],sxy[Pa],"
                  "syz[Pa],szx[Pa],Fxx,Fyy,Fzz,Fxy,Fyz,Fzx,solidFraction,contacts,Dxy[1/s],shear",
                  &t);
}

/* ---- walls ----------------------------------------------------------------------------------- */

/* Work in the interval, mean power, mean torque about the wall's axis, position and speed of a wall that
   is moved by force. */
static int measure_motion(struct dem *d, int wall, double elapsed, const double *impulse,
                          struct dem_text *t)
{
    struct dem_wall_position at;
    double origin[3], axis[3], work, moment[3];

    DEM_TRY(dem_wall_work(d, wall, &work));
    const int turns = dem_wall_axis(d, wall, origin, axis);

    dem_vec_cross(origin, impulse, moment);
    const double torque =
        turns ? (dem_vec_dot(axis, impulse + 3) - dem_vec_dot(axis, moment))/elapsed : 0.0;

    dem_wall_position(d, wall, &at);
    dem_text_add(t, ",%.9g,%.9g,%.9g,%.9g,%.9g", work, work/elapsed, torque, at.moved[0],
                 at.velocity[0]);
    return DEM_OK;
}

static int measure_walls(struct dem *d, double now, double elapsed, struct dem_text *t)
{
    for (int w = 0; w < dem_wall_count(d); w++)
    {
        double value[12];

        DEM_TRY(dem_wall_impulse(d, w, value, value + 3));
        DEM_TRY(dem_wall_load(d, w, value + 6, value + 9));
        dem_text_add(t, "%.10g,%s", now, dem_wall_name(d, w));
        for (int k = 0; k < 12; k++)
        {
            dem_text_add(t, ",%.9g", k < 6 ? value[k]/elapsed : value[k]);
        }
        DEM_TRY(measure_motion(d, w, elapsed, value, t));
        dem_text_add(t, "\n");
    }
    return dem_wall_impulse_reset(d);
}

int dem_table_add_walls(const struct dem_table *table, struct dem *d, double now, double elapsed)
{
    struct dem_text t = {0};
    const int status = measure_walls(d, now, elapsed, &t);

    if (status || !table || !t.text)
    {
        dem_text_free(&t);
        return status;
    }
    return append(table, d,
                  "time[s],wall,fx[N],fy[N],fz[N],tx[Nm],ty[Nm],tz[Nm],fx_now[N],fy_now[N],"
                  "fz_now[N],tx_now[Nm],ty_now[Nm],tz_now[Nm],"
                  "work[J],power[W],axial_torque[Nm],moved,speed",
                  &t);
}

/* ---- energy ---------------------------------------------------------------------------------- */

int dem_table_add_energy(const struct dem_table *table, const struct dem *d, double now,
                         double since, int n, const struct dem_energy_item *item)
{
    struct dem_text columns = {0}, t = {0};

    dem_text_add(&columns, "time[s],since[s]");
    dem_text_add(&t, "%.10g,%.10g", now, since);
    for (int k = 0; k < n; k++)
    {
        dem_text_add(&columns, ",%s[J]", item[k].name);
        dem_text_add(&t, ",%.12g", item[k].value + 0.0);    /* no minus zero */
    }
    dem_text_add(&t, "\n");
    const int status = columns.status ? columns.status : append(table, d, columns.text, &t);

    dem_text_free(&columns);
    return status;
}
