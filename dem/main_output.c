/*
 * main_output.c -- gather the view on the first rank and hand its columns to the VTK writer.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_output.h"
#include "main_bonds.h"
#include "main_surfaces.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/unknown.h"
#include "io/vtk.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct shown                                              /* one particle as it is written */
{
    double position[3], velocity[3], spin[3], force[3], orientation[4], diameter;
    int64_t id, material;
};

int dem_output_read(struct dem_output *o, const struct dem_dict *write, const char *scene)
{
    static const char *const kinds[] = {"no", "last", "all"};
    const char *const slash = strrchr(scene, '/'), *const name = slash ? slash + 1 : scene, *const dot = strrchr(name, '.');
    const char *folder = "", *kind = "last";

    o->vtk = o->last_good = o->profile = true;
    if (write)
    {
        DEM_TRY(dem_dict_text_or(write, "folder", "", &folder));
        DEM_TRY(dem_dict_switch_or(write, "vtk", true, &o->vtk));
        DEM_TRY(dem_dict_word_or(write, "snapshot", "last", &kind));
        DEM_TRY(dem_dict_switch_or(write, "lastGood", true, &o->last_good));
        DEM_TRY(dem_dict_switch_or(write, "orientation", false, &o->orientation));
        DEM_TRY(dem_dict_switch_or(write, "profile", true, &o->profile));
    }
    o->snapshots = -1;
    for (int k = 0; k < 3; k++)
    {
        o->snapshots = strcmp(kind, kinds[k]) == 0 ? k : o->snapshots;
    }
    if (o->snapshots < 0)
    {
        return dem_error_prefix(dem_unknown_word("kind of snapshot", kind, kinds, 3), "write: ");
    }
    if (folder[0])
    {
        DEM_REQUIRE(strlen(folder) < sizeof o->folder, DEM_ERROR_INPUT, "write/folder has %zu letters; give a name of at most %zu",
                    strlen(folder), sizeof o->folder - 1);
        snprintf(o->folder, sizeof o->folder, "%s", folder);
    }
    else
    {
        DEM_REQUIRE(strlen(name) < sizeof o->folder - 4, DEM_ERROR_INPUT, "the scene's name has %zu letters; give write/folder", strlen(name));
        snprintf(o->folder, sizeof o->folder, "%.*s%s", (int)(dot && dot > name ? dot - name : (long)strlen(name)), name,
                 dot && dot > name ? "" : ".out");
    }
    return DEM_OK;
}

static int gather(const struct dem_program *prog, const struct dem *d, struct shown **all, int64_t *particles)
{
    struct dem_view v;
    struct shown *mine;
    int *count = NULL, *start = NULL, total = 0;
    MPI_Datatype one;

    dem_view(d, &v);
    DEM_TRY(DEM_NEW(mine, v.n + 1));
    for (size_t i = 0; i < v.n; i++)
    {
        struct shown *const s = &mine[i];

        memcpy(s->position, dem_at(v.position, v.stride, i), sizeof s->position);
        memcpy(s->velocity, dem_at(v.velocity, v.stride, i), sizeof s->velocity);
        memcpy(s->spin, dem_at(v.spin, v.stride, i), sizeof s->spin);
        memcpy(s->force, v.force + 3*i, sizeof s->force);
        if (v.orientation)
        {
            memcpy(s->orientation, v.orientation + 4*i, sizeof s->orientation);
        }
        s->diameter = 2.0**dem_at(v.radius, v.stride, i);
        s->id = *(const int64_t *)(const void *)((const char *)v.id + v.stride*i);
        s->material = *(const uint16_t *)(const void *)((const char *)v.material + v.stride*i);
    }
    *particles = (int64_t)v.n;
    *all = mine;
    if (prog->comm == MPI_COMM_NULL)
    {
        return DEM_OK;
    }
    const int here = (int)v.n;

    DEM_TRY(DEM_NEW(count, prog->ranks));
    DEM_TRY(DEM_NEW(start, prog->ranks));
    MPI_Gather(&here, 1, MPI_INT, count, 1, MPI_INT, 0, prog->comm);
    for (int k = 0; k < prog->ranks && prog->rank == 0; k++)
    {
        start[k] = total;
        total += count[k];
    }
    DEM_TRY(DEM_NEW(*all, total + 1));
    MPI_Type_contiguous((int)sizeof *mine, MPI_BYTE, &one);      /* counts of particles: of bytes an int holds 13 million */
    MPI_Type_commit(&one);
    MPI_Gatherv(mine, here, one, *all, count, start, one, 0, prog->comm);
    MPI_Type_free(&one);
    *particles = total;
    dem_memory_free(mine);
    dem_memory_free(count);
    dem_memory_free(start);
    return DEM_OK;
}

static int write_vtk(const struct dem_output *o, const struct shown *s, int64_t n, const char *file)
{
    const size_t stride = sizeof *s;
    const struct dem_vtk_column columns[] =
    {
        {"points", s->position, stride, DEM_VTK_DOUBLE, 3},
        {"id", &s->id, stride, DEM_VTK_INT64, 1},
        {"material", &s->material, stride, DEM_VTK_INT64, 1},
        {"diameter", &s->diameter, stride, DEM_VTK_NARROW, 1},
        {"velocity", s->velocity, stride, DEM_VTK_NARROW, 3},
        {"spin", s->spin, stride, DEM_VTK_NARROW, 3},
        {"force", s->force, stride, DEM_VTK_NARROW, 3},
        {"orientation", s->orientation, stride, DEM_VTK_NARROW, 4},
    };
    char path[640];

    snprintf(path, sizeof path, "%s/%s", o->folder, file);
    return dem_vtk_write(path, n, columns, (int)(sizeof columns/sizeof columns[0]) - !o->orientation);
}

static int check_folder(const struct dem_output *o)
{
    struct stat found;
    char above[sizeof o->folder];

    if (stat(o->folder, &found) == 0)
    {
        DEM_REQUIRE(S_ISDIR(found.st_mode), DEM_ERROR_FILE, "write/folder %s is a file; give another name, or move it away", o->folder);
        DEM_REQUIRE(access(o->folder, W_OK | X_OK) == 0, DEM_ERROR_FILE, "can't write into the folder %s: %s; give another write/folder",
                    o->folder, strerror(errno));
        return DEM_OK;
    }
    snprintf(above, sizeof above, "%s", o->folder);
    for (size_t n = strlen(above); n > 1 && above[n - 1] == '/'; n--)
    {
        above[n - 1] = '\0';
    }
    char *const slash = strrchr(above, '/');

    snprintf(slash ? slash + 1 : above, 2, ".");
    DEM_REQUIRE(access(above, W_OK | X_OK) == 0, DEM_ERROR_FILE, "can't make the folder %s: %s; make the folder above it, or give another "
                "write/folder", o->folder, strerror(errno));
    return DEM_OK;
}

int dem_output_check(const struct dem_output *o, const struct dem_program *prog)
{
    const int writes = o->vtk || o->snapshots || o->walls > 0.0 || o->energy > 0.0;

    return dem_program_together(prog, prog->rank == 0 && writes ? check_folder(o) : DEM_OK);
}

int dem_output_folder(const struct dem_output *o)
{
    errno = 0;
    DEM_REQUIRE(mkdir(o->folder, 0777) == 0 || errno == EEXIST, DEM_ERROR_FILE, "can't make the folder %s: %s", o->folder,
                strerror(errno));
    return DEM_OK;
}

static int write_picture(const struct dem_output *o, const struct dem_program *prog, const struct dem *d, const char *file)
{
    struct shown *all;
    int64_t n;

    DEM_TRY(gather(prog, d, &all, &n));
    const int status = prog->rank == 0 ? write_vtk(o, all, n, file) : DEM_OK;

    dem_memory_free(all);
    return status;
}

/* A picture with its place in the collection. */
static int write_pictures(const struct dem_output *o, const struct dem_program *prog, const struct dem *d, int64_t number,
                          double time)
{
    char file[64], path[640];

    snprintf(file, sizeof file, "particles_%06lld.vtp", (long long)number);
    DEM_TRY(write_picture(o, prog, d, file));
    if (prog->rank > 0)
    {
        return DEM_OK;
    }
    snprintf(path, sizeof path, "%s/particles.pvd", o->folder);
    DEM_TRY(dem_vtk_collection_add(path, time, file));
    return dem_surfaces_write(o, d, number, time);
}

int dem_output_write(const struct dem_output *o, const struct dem_program *prog, struct dem *d, int64_t number, double time)
{
    char path[640];
    int status = prog->rank == 0 && (o->vtk || o->snapshots || dem_averages_count(d)) ? dem_output_folder(o) : DEM_OK;

    if (o->vtk && !status)
    {
        status = write_pictures(o, prog, d, number, time);
    }
    status = status ? status : dem_averages(d, o->folder);
    DEM_TRY(dem_program_together(prog, status));
    if (o->vtk)
    {
        DEM_TRY(dem_bond_picture(d, o->folder, number, time));
    }
    if (o->snapshots == 2)
    {
        snprintf(path, sizeof path, "%s/snapshot_%06lld.dem", o->folder, (long long)number);
    }
    else
    {
        snprintf(path, sizeof path, "%s/snapshot.dem", o->folder);
    }
    return o->snapshots ? dem_save(d, path) : DEM_OK;
}

int dem_output_last_good(const struct dem_output *o, const struct dem_program *prog, struct dem *d)
{
    char path[640];
    int status = prog->rank == 0 ? dem_output_folder(o) : DEM_OK;

    if (o->vtk && !status)
    {
        status = write_picture(o, prog, d, "lastGood.vtp");
    }
    DEM_TRY(dem_program_together(prog, status));
    snprintf(path, sizeof path, "%s/lastGood.dem", o->folder);
    return dem_save(d, path);
}
