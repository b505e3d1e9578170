/*
 * describe.c -- the public calls that say what will run: scene, walls, regions, patches and
 * particles of the program, a snapshot, and options of the run.
 *
 * A caller may trap floating-point exceptions (OpenFOAM does); calls that compute hold the traps
 * and restore them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "dem_fluid.h"
#include "core/error.h"
#include "core/memory.h"
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* What has been checked stays as it is. */
static int require_open(const struct dem_case *c, const char *call)
{
    DEM_REQUIRE(!c->checked, DEM_ERROR_STATE, c->checked < 0
                ? "%s after a dem_case_check that failed; call dem_case_free and start again"
                : "%s comes before dem_case_check", call);
    return DEM_OK;
}

/* ---- scene ----------------------------------------------------------------------------------- */

static int require_no_scene(const struct dem_case *c, const char *call, const char *name)
{
    DEM_TRY(require_open(c, call));
    DEM_REQUIRE(!c->d->dict, DEM_ERROR_STATE, "%s: a scene has been read already; create another "
                "case for %s", call, name);
    return DEM_OK;
}

int dem_case_scene_file(struct dem_case *c, const char *path)
{
    DEM_TRY(require_no_scene(c, "dem_case_scene_file", path));
    return dem_dict_read_file(&c->d->dict, path);
}

int dem_case_scene_text(struct dem_case *c, const char *text, const char *name)
{
    DEM_TRY(require_no_scene(c, "dem_case_scene_text", name));
    return dem_dict_read_text(&c->d->dict, text, name);
}

static int require_scene(const struct dem_case *c, const char *call)
{
    DEM_TRY(require_open(c, call));
    DEM_REQUIRE(c->d->dict, DEM_ERROR_STATE, "%s comes after the scene has been read", call);
    return DEM_OK;
}

int dem_case_set(struct dem_case *c, const char *path, const char *value)
{
    DEM_TRY(require_scene(c, "dem_case_set"));
    return dem_dict_set(c->d->dict, path, value);
}

int dem_case_remove(struct dem_case *c, const char *path, int *removed)
{
    DEM_TRY(require_scene(c, "dem_case_remove"));
    *removed = dem_dict_unset(c->d->dict, path);
    return DEM_OK;
}

int dem_case_remove_effect(struct dem_case *c, const char *effect)
{
    DEM_TRY(require_scene(c, "dem_case_remove_effect"));
    DEM_REQUIRE(dem_dict_remove(c->d->dict, "effects", false, effect), DEM_ERROR_INPUT,
                "the scene has no effect %s to leave out", effect);
    (void)dem_dict_remove(c->d->dict, "pairs", true, effect);
    return DEM_OK;
}

const struct dem_dict *dem_case_dict(const struct dem_case *c)
{
    return c->d->dict;
}

int dem_case_load(struct dem_case *c, const char *path)
{
    DEM_TRY(require_open(c, "dem_case_load"));
    DEM_REQUIRE(strlen(path) < sizeof c->load_path, DEM_ERROR_INPUT, "path %s is longer than %zu "
                "characters", path, sizeof c->load_path - 1);
    snprintf(c->load_path, sizeof c->load_path, "%s", path);
    return DEM_OK;
}

int dem_case_start_from(struct dem_case *c, const char *path)
{
    DEM_TRY(dem_case_load(c, path));
    c->new_run = 1;
    return DEM_OK;
}

/* ---- walls, regions, patches ----------------------------------------------------------------- */

static int add_wall(struct dem_case *c, const char *name, const char *material, int64_t n,
                    const double *triangles)
{
    struct dem *const d = c->d;
    struct dem_mesh_wall *w;

    DEM_TRY(require_open(c, "dem_case_add_wall"));
    DEM_TRY(dem_sim_require_count("dem_case_add_wall", "triangles", n));
    DEM_REQUIRE(strlen(name) < sizeof w->name && strlen(material) < sizeof w->material,
                DEM_ERROR_INPUT, "wall %s of %s: a name longer than %zu characters; shorten it",
                name, material, sizeof w->material - 1);
    DEM_TRY(DEM_GROW(d->mesh_wall, d->mesh_wall_capacity, d->mesh_walls + 1));
    w = &d->mesh_wall[d->mesh_walls];
    *w = (struct dem_mesh_wall){.n = (size_t)n};
    DEM_TRY(DEM_NEW(w->triangles, 9*w->n + 1));
    snprintf(w->name, sizeof w->name, "%s", name);
    snprintf(w->material, sizeof w->material, "%s", material);
    memcpy(w->triangles, triangles, 9*w->n*sizeof *triangles);
    d->mesh_walls++;
    return DEM_OK;
}

int dem_case_add_wall(struct dem_case *c, const char *name, const char *material, int64_t n,
                      const double *triangles)
{
    return dem_sim_agree(c->d, add_wall(c, name, material, n, triangles));
}

int dem_case_move_wall(struct dem_case *c, const char *name, int64_t n, const double *triangles)
{
    struct dem_mesh_wall *wall;

    return dem_sim_copy_corners(c->d, "dem_case_move_wall", name, n, triangles, &wall);
}

int dem_case_add_region(struct dem_case *c, const char *name, int zone, int64_t n,
                        const double *triangles)
{
    struct dem *const d = c->d;
    struct dem_insertion_regions *const g = &d->scene.insertion.regions;
    double *corners;
    size_t total;

    DEM_TRY(require_open(c, "dem_case_add_region"));
    DEM_REQUIRE(strlen(name) < sizeof g->surface->name, DEM_ERROR_INPUT,
                "zone %s: a name longer than %zu characters; shorten it", name,
                sizeof g->surface->name - 1);
    int status = dem_sim_require_count("dem_case_add_region", "triangles", n);

    status = status ? status : DEM_GROW(g->surface, g->capacity, g->n + 1);
    DEM_TRY(dem_sim_gather(&d->state, status, 9, (size_t)n, triangles, &corners, &total));
    struct dem_closed_surface *const s = &g->surface[g->n++];

    *s = (struct dem_closed_surface){.what = zone ? "zone" : "mesh", .zone = zone};
    snprintf(s->name, sizeof s->name, "%s", name);
    return dem_sim_agree(d, dem_closed_surface_init(s, total, corners));
}

static int new_patch(struct dem_case *c, const char *name, struct dem_flow_patch **patch)
{
    struct dem *const d = c->d;

    DEM_TRY(require_open(c, "dem_case_add_patch"));
    *patch = dem_sim_find_patch(d, name);
    DEM_REQUIRE(!*patch, DEM_ERROR_INPUT, "dem_case_add_patch: patch %s has been added already", name);
    DEM_REQUIRE(strlen(name) < sizeof d->patch->name, DEM_ERROR_INPUT,
                "patch %s: a name longer than %zu characters; shorten it", name,
                sizeof d->patch->name - 1);
    DEM_TRY(DEM_GROW(d->patch, d->patch_capacity, d->patches + 1));
    *patch = &d->patch[d->patches++];
    snprintf((*patch)->name, sizeof (*patch)->name, "%s", name);
    return DEM_OK;
}

int dem_case_add_patch(struct dem_case *c, const char *name, int64_t n, const double *triangles,
                       const double *velocity)
{
    struct dem_flow_patch *patch = NULL;
    int status = dem_sim_require_count("dem_case_add_patch", "triangles", n);

    status = status ? status : new_patch(c, name, &patch);
    return dem_sim_gather_patch(c->d, status, patch, n, triangles, velocity);
}

int dem_case_flows_on_request(struct dem_case *c)
{
    DEM_TRY(require_open(c, "dem_case_flows_on_request"));
    c->d->flow_on_request = 1;
    return DEM_OK;
}

/* ---- particles ------------------------------------------------------------------------------- */

static int add_particles(struct dem_case *c, int64_t n, const struct dem_new_particle *added)
{
    DEM_TRY(dem_sim_require_count("dem_case_add_particles", "particles", n));
    DEM_TRY(DEM_GROW(c->initial_material, c->initial_capacity, c->initial.n + (size_t)n + 1));
    for (int64_t k = 0; k < n; k++)
    {
        struct dem_particle p =
            dem_particle_sphere(added[k].id, added[k].position, added[k].diameter, 1.0, 0);

        memcpy(p.v, added[k].velocity, sizeof p.v);
        memcpy(p.w, added[k].spin, sizeof p.w);
        p.flags = added[k].frozen ? DEM_PARTICLE_FROZEN : 0;
        snprintf(c->initial_material[c->initial.n], sizeof *c->initial_material, "%s",
                 added[k].material);
        DEM_TRY(dem_initial_particles_add(&c->initial, p, "dem_case_add_particles"));
        /* the next free id is known only when the scene has inserted its own particles */
        c->initial.particle[c->initial.n - 1].id = added[k].id;
    }
    return DEM_OK;
}

int dem_case_add_particles(struct dem_case *c, int64_t n, const struct dem_new_particle *added)
{
    fenv_t caller;

    DEM_TRY(require_open(c, "dem_case_add_particles"));
    feholdexcept(&caller);    /* a diameter of 0 ends in a message, not in a signal */
    const int status = add_particles(c, n, added);

    fesetenv(&caller);
    return status;
}

int dem_case_allow_diameters(struct dem_case *c, const char *material, double min, double max)
{
    struct dem_allowed_diameters *a;

    DEM_TRY(require_open(c, "dem_case_allow_diameters"));
    DEM_REQUIRE(min > 0.0 && max >= min && isfinite(max), DEM_ERROR_INPUT,
                "material %s: diameters from %g to %g m; give two numbers above 0, the smaller first",
                material, min, max);
    DEM_REQUIRE(strlen(material) < sizeof a->material, DEM_ERROR_INPUT,
                "material %s: its name is longer than %zu characters", material,
                sizeof a->material - 1);
    DEM_TRY(DEM_GROW(c->allowed, c->allowed_capacity, c->alloweds + 1));
    a = &c->allowed[c->alloweds++];
    snprintf(a->material, sizeof a->material, "%s", material);
    a->min = min;
    a->max = max;
    return DEM_OK;
}

/* ---- what only some runs need ---------------------------------------------------------------- */

int dem_case_enable_energy(struct dem_case *c)
{
    DEM_TRY(require_open(c, "dem_case_enable_energy"));
    c->energy = 1;
    return DEM_OK;
}

int dem_case_enable_orientation(struct dem_case *c)
{
    DEM_TRY(require_open(c, "dem_case_enable_orientation"));
    c->orientation = 1;
    return DEM_OK;
}

int dem_case_enable_virial(struct dem_case *c)
{
    DEM_TRY(require_open(c, "dem_case_enable_virial"));
    c->virial = 1;
    return DEM_OK;
}

int dem_case_exchange_scalar(struct dem_case *c, const char *name)
{
    DEM_TRY(require_open(c, "dem_case_exchange_scalar"));
    DEM_REQUIRE(strlen(name) < sizeof c->exchanged[0], DEM_ERROR_INPUT,
                "dem_case_exchange_scalar: name %s is longer than %zu characters", name,
                sizeof c->exchanged[0] - 1);
    DEM_REQUIRE(c->exchanges < DEM_SCALARS, DEM_ERROR_STATE,
                "dem_case_exchange_scalar: called more than %d times", DEM_SCALARS);
    snprintf(c->exchanged[c->exchanges++], sizeof c->exchanged[0], "%s", name);
    return DEM_OK;
}

void dem_case_fluid_displaced(struct dem_case *c, double density)
{
    c->displaced_density = density;
}

void dem_case_fluid_own_wake(struct dem_case *c)
{
    c->own_wake = 1;
}

void dem_case_start_time(struct dem_case *c, double time)
{
    c->start_time = time;
}

void dem_case_fluid_density(struct dem_case *c, double density)
{
    c->fluid_density = density;
}
