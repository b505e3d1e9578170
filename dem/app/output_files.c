/*
 * output_files.c -- write particles as VTK files, averages, and snapshots with their names.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/output_files.h"
#include "dem_tables.h"
#include "app/walls_vtk.h"
#include "core/error.h"
#include "core/file.h"
#include "core/memory.h"
#include "core/did_you_mean.h"
#include "records/csv_table.h"
#include "records/vtk.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum
{
    MAX_SCALARS = 12  /* of a scene: DEM_SCALARS of laws/scalar.h */
};

/* a particle as it is written */
struct output_particle
{
    double position[3], velocity[3], spin[3], force[3], orientation[4], diameter;
    int64_t id, material, clump;
};

static int read_keep(struct dem_output *o, const struct dem_dict *write)
{
    if (write && dem_dict_has(write, "keep"))
    {
        DEM_TRY(dem_dict_int64(write, "keep", &o->keep));
        DEM_REQUIRE(o->keep >= 1, DEM_ERROR_INPUT,
                    "write/keep %lld snapshots; give 1 or more, or leave it out to keep all",
                    (long long)o->keep);
        DEM_REQUIRE(o->snapshots == 2, DEM_ERROR_INPUT, "write/keep %lld needs snapshot all, but "
                    "snapshot is %s; give snapshot all, or leave keep out", (long long)o->keep,
                    o->snapshots ? "last" : "no");
    }
    return DEM_OK;
}

int dem_output_read(struct dem_output *o, const struct dem_dict *write, const char *scene)
{
    static const char *const kinds[] = {"no", "last", "all"};
    const char *const slash = strrchr(scene, '/'), *const name = slash ? slash + 1 : scene;
    const char *const dot = strrchr(name, '.');
    const char *folder = "", *kind = "last", *precision = "single";

    o->vtk = o->last_good = o->profile = true;
    if (write)
    {
        DEM_TRY(dem_dict_text_or(write, "folder", "", &folder));
        DEM_TRY(dem_dict_switch_or(write, "vtk", true, &o->vtk));
        DEM_TRY(dem_dict_switch_or(write, "csv", false, &o->csv));
        DEM_TRY(dem_dict_word_or(write, "precision", "single", &precision));
        DEM_TRY(dem_dict_word_or(write, "snapshot", "last", &kind));
        DEM_TRY(dem_dict_switch_or(write, "lastGood", true, &o->last_good));
        DEM_TRY(dem_dict_switch_or(write, "orientation", false, &o->orientation));
        DEM_TRY(dem_dict_switch_or(write, "profile", true, &o->profile));
    }
    o->wide = strcmp(precision, "double") == 0;
    DEM_REQUIRE(o->wide || strcmp(precision, "single") == 0, DEM_ERROR_INPUT,
                "write/precision %s; give single or double", precision);
    o->snapshots = -1;
    for (int k = 0; k < 3; k++)
    {
        o->snapshots = strcmp(kind, kinds[k]) == 0 ? k : o->snapshots;
    }
    if (o->snapshots < 0)
    {
        return dem_error_prefix(dem_did_you_mean_error("kind of snapshot", kind, kinds, 3),
                                "write: ");
    }
    DEM_TRY(read_keep(o, write));
    if (folder[0])
    {
        DEM_REQUIRE(strlen(folder) < sizeof o->folder, DEM_ERROR_INPUT,
                    "write/folder has %zu characters; give a name of at most %zu", strlen(folder),
                    sizeof o->folder - 1);
        snprintf(o->folder, sizeof o->folder, "%s", folder);
    }
    else
    {
        DEM_REQUIRE(strlen(name) < sizeof o->folder - 4, DEM_ERROR_INPUT,
                    "the scene's name has %zu characters; give write/folder", strlen(name));
        snprintf(o->folder, sizeof o->folder, "%.*s%s",
                 (int)(dot && dot > name ? dot - name : (long)strlen(name)), name,
                 dot && dot > name ? "" : ".out");
    }
    return DEM_OK;
}

/* Copy the particles of this rank; *mine is freed by the caller. */
static int copy_particles(const struct dem *d, struct output_particle **mine, int64_t *n)
{
    struct dem_view v;

    dem_view(d, &v);
    DEM_TRY(DEM_NEW(*mine, v.n + 1));
    for (size_t i = 0; i < v.n; i++)
    {
        struct output_particle *const s = &(*mine)[i];

        memcpy(s->position, dem_at(v.position, v.stride, i), sizeof s->position);
        memcpy(s->velocity, dem_at(v.velocity, v.stride, i), sizeof s->velocity);
        memcpy(s->spin, dem_at(v.spin, v.stride, i), sizeof s->spin);
        memcpy(s->force, v.force + 3*i, sizeof s->force);
        if (v.orientation)
        {
            memcpy(s->orientation, v.orientation + 4*i, sizeof s->orientation);
        }
        s->clump = v.clump ? *(const int64_t *)(const void *)((const char *)v.clump + v.stride*i) : 0;
        s->diameter = 2.0**dem_at(v.radius, v.stride, i);
        s->id = *(const int64_t *)(const void *)((const char *)v.id + v.stride*i);
        s->material = *(const uint16_t *)(const void *)((const char *)v.material + v.stride*i);
    }
    *n = (int64_t)v.n;
    return DEM_OK;
}

/* Collective. */
static int write_particles(const struct dem_output *o, const struct dem_program *prog,
                           struct dem *d, const char *file)
{
    struct output_particle *s;
    int64_t n;

    DEM_TRY(copy_particles(d, &s, &n));
    const size_t stride = sizeof *s;
    const enum dem_vtk_type real = o->wide ? DEM_VTK_DOUBLE : DEM_VTK_FLOAT32;
    struct dem_vtk_column columns[9 + MAX_SCALARS] =
    {
        {"points", s->position, stride, DEM_VTK_DOUBLE, 3},
        {"id", &s->id, stride, DEM_VTK_INT64, 1},
        {"material", &s->material, stride, DEM_VTK_INT64, 1},
        {"diameter", &s->diameter, stride, real, 1},
        {"velocity", s->velocity, stride, real, 3},
        {"spin", s->spin, stride, real, 3},
        {"force", s->force, stride, real, 3},
        {"orientation", s->orientation, stride, real, 4},
    };
    int count = 8 - !o->orientation;
    char path[640];
    struct dem_view view;

    dem_view(d, &view);
    if (view.clump)
    {
        columns[count++] = (struct dem_vtk_column){"clump", &s->clump, stride, DEM_VTK_INT64, 1};
    }

    for (int k = 0; k < dem_scalar_count(d); k++)
    {
        struct dem_scalar_info info;

        dem_scalar_info(d, k, &info);
        columns[count] = (struct dem_vtk_column){info.name, dem_scalar(d, k), sizeof(double), real, 1};
        count += info.written;
    }
    snprintf(path, sizeof path, "%s/%s", o->folder, file);
    const int status =
        dem_vtk_write(&(const struct dem_file_ranks){prog->comm, prog->rank, dem_heading(d)}, path,
                      n, columns, count);

    dem_memory_free(s);
    return status;
}

struct table    /* of particles at a time */
{
    const struct output_particle *particle;
    struct dem *d;
    double time;
    bool orientation;
    int scalars;
    const double *scalar[MAX_SCALARS];
};

/* 17 digits: a double is read back with the same bits */
static int print_particle(const void *source, int64_t i, char *out, size_t size)
{
    const struct table *const t = source;
    const struct output_particle *const s = &t->particle[i];
    const double *const x = s->position, *const v = s->velocity, *const w = s->spin,
                       *const f = s->force, *const q = s->orientation;
    int n = snprintf(out, size,
                     "%.17g,%lld,%s,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,"
                     "%.17g,%.17g,%.17g",
                     t->time, (long long)s->id, dem_material_name(t->d, (int)s->material),
                     s->diameter, x[0], x[1], x[2], v[0], v[1], v[2], w[0], w[1], w[2], f[0], f[1],
                     f[2]);

    if (t->orientation && n > 0 && (size_t)n < size)
    {
        n += snprintf(out + n, size - (size_t)n, ",%.17g,%.17g,%.17g,%.17g", q[0], q[1], q[2], q[3]);
    }
    for (int k = 0; k < t->scalars && n > 0 && (size_t)n < size; k++)
    {
        n += snprintf(out + n, size - (size_t)n, ",%.17g", t->scalar[k][i]);
    }
    return n;
}

/* Collective. */
static int write_csv(const struct dem_output *o, const struct dem_program *prog, struct dem *d,
                     int64_t number, double time)
{
    struct table t = {.d = d, .time = time, .orientation = o->orientation};
    struct output_particle *s = NULL;
    char path[640], columns[256 + 64*MAX_SCALARS];
    int64_t n = 0;

    snprintf(path, sizeof path, "%s/particles_%06lld.csv", o->folder, (long long)number);
    snprintf(columns, sizeof columns,
             "time[s],id,material,diameter[m],x[m],y[m],z[m],vx[m/s],vy[m/s],vz[m/s],wx[1/s],"
             "wy[1/s],wz[1/s],fx[N],fy[N],fz[N]%s", o->orientation ? ",q0,q1,q2,q3" : "");
    for (int k = 0; k < dem_scalar_count(d); k++)
    {
        const size_t length = strlen(columns);
        struct dem_scalar_info info;

        dem_scalar_info(d, k, &info);
        if (info.written)
        {
            t.scalar[t.scalars++] = dem_scalar(d, k);
            snprintf(columns + length, sizeof columns - length, ",%s[%s]", info.name, info.unit);
        }
    }
    DEM_TRY(dem_program_agree(prog, copy_particles(d, &s, &n)));
    t.particle = s;
    const int status = dem_csv_table_write(
        &(const struct dem_file_ranks){prog->comm, prog->rank, NULL}, path, columns, n,
        print_particle, &t);

    dem_memory_free(s);
    return status;
}

static int check_folder(const struct dem_output *o)
{
    struct stat found;
    char parent[sizeof o->folder];

    if (stat(o->folder, &found) == 0)
    {
        DEM_REQUIRE(S_ISDIR(found.st_mode), DEM_ERROR_FILE,
                    "write/folder %s is a file; give another name, or move it away", o->folder);
        DEM_REQUIRE(access(o->folder, W_OK | X_OK) == 0, DEM_ERROR_FILE, "cannot write into the "
                    "folder %s: %s; give another write/folder",
                    o->folder, strerror(errno));
        return DEM_OK;
    }
    snprintf(parent, sizeof parent, "%s", o->folder);
    for (size_t n = strlen(parent); n > 1 && parent[n - 1] == '/'; n--)
    {
        parent[n - 1] = '\0';
    }
    char *const slash = strrchr(parent, '/');

    snprintf(slash ? slash + 1 : parent, 2, ".");
    DEM_REQUIRE(access(parent, W_OK | X_OK) == 0, DEM_ERROR_FILE, "cannot create the folder %s: "
                "%s; create its parent folder, or give another write/folder", o->folder,
                strerror(errno));
    return DEM_OK;
}

static int writes_files(const struct dem_output *o)
{
    return o->vtk || o->csv || o->snapshots || o->walls > 0.0 || o->energy > 0.0 || o->cell > 0.0;
}

int dem_output_writes(const struct dem_output *o, const struct dem *d)
{
    return writes_files(o) || dem_averages_count(d) > 0;
}

/* A snapshot, which is renamed to its name, must not replace the scene. */
static int check_scene(const struct dem_output *o, const char *scene)
{
    static const char *const files[] = {"snapshot.dem", "lastGood.dem"};
    struct stat found, own;

    for (int k = 0; k < 2 && stat(scene, &own) == 0; k++)
    {
        char path[640];

        snprintf(path, sizeof path, "%s/%s", o->folder, files[k]);
        DEM_REQUIRE(stat(path, &found) != 0 || found.st_dev != own.st_dev
                        || found.st_ino != own.st_ino,
                    DEM_ERROR_INPUT, "the run would overwrite its scene %s by %s; give the scene "
                    "another name, or give another write/folder", scene, path);
    }
    return DEM_OK;
}

static int check_place(const struct dem_output *o, const char *scene)
{
    DEM_TRY(check_folder(o));
    return check_scene(o, scene);
}

int dem_output_check(const struct dem_output *o, const struct dem_program *prog, const char *scene)
{
    return dem_program_agree(prog, prog->rank == 0 && writes_files(o) ? check_place(o, scene)
                                                                      : DEM_OK);
}

static int write_vtk(const struct dem_output *o, const struct dem_program *prog, struct dem *d,
                     int64_t number, double time)
{
    char file[64], path[640];

    snprintf(file, sizeof file, "particles_%06lld.vtp", (long long)number);
    snprintf(path, sizeof path, "%s/particles.pvd", o->folder);
    DEM_TRY(write_particles(o, prog, d, file));
    DEM_TRY(dem_program_agree(prog, prog->rank == 0 ? dem_vtk_collection_add(path, time, file)
                                                    : DEM_OK));
    DEM_TRY(dem_walls_vtk_write(o, d, number, time));
    if (!dem_has_bonds(d))
    {
        return DEM_OK;
    }
    snprintf(file, sizeof file, "bonds_%06lld.vtp", (long long)number);
    return dem_bonds_draw(d, o->folder, file, time);
}

int dem_output_write(const struct dem_output *o, const struct dem_program *prog, struct dem *d,
                     int64_t number, double time)
{
    const int averages = dem_averages_count(d) > 0;

    if (o->vtk)
    {
        DEM_TRY(write_vtk(o, prog, d, number, time));
    }
    if (o->csv)
    {
        DEM_TRY(write_csv(o, prog, d, number, time));
    }
    /* these CSV files have no comment: effects.csv names the effects */
    DEM_TRY(dem_program_agree(prog, prog->rank == 0 && (o->csv || averages)
                                        ? dem_effects_record(d, o->folder, o->start)
                                        : DEM_OK));
    return averages ? dem_program_agree(prog, dem_averages(d, o->folder)) : DEM_OK;
}

void dem_output_snapshot_name(const struct dem_output *o, int64_t number, char *path, size_t size)
{
    if (o->snapshots == 2)
    {
        snprintf(path, size, "%s/snapshot_%06lld.dem", o->folder, (long long)number);
    }
    else
    {
        snprintf(path, size, "%s/snapshot.dem", o->folder);
    }
}

/* An old snapshot is removed only after the new one is complete. */
int dem_output_save(const struct dem_output *o, const struct dem_program *prog, struct dem *d,
                    int64_t number)
{
    char path[640];

    if (!o->snapshots)
    {
        return DEM_OK;
    }
    dem_output_snapshot_name(o, number, path, sizeof path);
    DEM_TRY(dem_save(d, path));
    if (prog->rank == 0 && o->keep > 0 && number >= o->keep)
    {
        dem_output_snapshot_name(o, number - o->keep, path, sizeof path);
        (void)remove(path);    /* it may not exist */
    }
    return DEM_OK;
}

int dem_output_last_good(const struct dem_output *o, const struct dem_program *prog, struct dem *d)
{
    char path[640];

    DEM_TRY(dem_program_agree(prog, prog->rank == 0 ? dem_file_make_folder(o->folder) : DEM_OK));
    if (o->vtk)
    {
        DEM_TRY(write_particles(o, prog, d, "lastGood.vtp"));
    }
    snprintf(path, sizeof path, "%s/lastGood.dem", o->folder);
    return dem_save(d, path);
}
