/*
 * dem.c -- the public calls that create a simulation, give it a scene, advance it, and save and
 * restore it.
 *
 * Queries are in query.c, the fluid in fluid_api.c, streams and outlets in inflow_api.c, the set-up
 * in setup.c. A caller may trap floating-point exceptions (OpenFOAM does); calls that compute hold
 * the traps and restore them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/restart.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/memory.h"
#include "records/snapshot.h"
#include "laws/effects.h"
#include "step/fall_check.h"
#include "records/bed_packing.h"
#include "ranks/collect.h"
#include "ranks/mpi_error.h"
#include "ranks/agree.h"
#include "step/step.h"
#include "step/step_backup.h"
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- create and free ------------------------------------------------------------------------- */

/* The duplicate inherits the caller's error handler, which as a rule aborts. Errors of the
   duplication itself go to that handler. On failure *own is MPI_COMM_NULL, or a communicator
   that the caller frees. */
static int duplicate(MPI_Comm comm, MPI_Comm *own, int *rank, int *ranks)
{
    DEM_TRY_MPI(MPI_Comm_dup(comm, own));
    DEM_TRY_MPI(MPI_Comm_set_errhandler(*own, MPI_ERRORS_RETURN));
    DEM_TRY_MPI(MPI_Comm_rank(*own, rank));
    DEM_TRY_MPI(MPI_Comm_size(*own, ranks));
    return DEM_OK;
}

int dem_create(struct dem **out, MPI_Comm comm)
{
    MPI_Comm own = MPI_COMM_NULL;
    struct dem *d = NULL;
    int rank = 0, ranks = 1;
    int status = comm == MPI_COMM_NULL ? DEM_OK : duplicate(comm, &own, &rank, &ranks);

    *out = NULL;
    status = status ? status : DEM_NEW(d, 1);
    if (status == DEM_OK)
    {
        dem_attached_stores_attach(&d->stores, &d->state);
        dem_domain_init(&d->state.domain);
        dem_interaction_table_init(&d->state.interaction_table);
        status = dem_decomposition_init(&d->state.decomposition, own, rank, ranks);
    }
    status = dem_collect_agree(&(struct dem_decomposition){.comm = own, .ranks = ranks}, status);
    if (status)
    {
        if (d)
        {
            dem_decomposition_free(&d->state.decomposition);
        }
        dem_memory_free(d);
        if (own != MPI_COMM_NULL)
        {
            (void)MPI_Comm_free(&own);
        }
        return status;
    }
    dem_halo_init(&d->state.halo, &d->state.decomposition);
    dem_wall_store_init(&d->state.wall_store, &d->state.decomposition);
    *out = d;
    return DEM_OK;
}

int dem_create_fortran(struct dem **out, int comm)
{
    return dem_create(out, comm == -1 ? MPI_COMM_NULL : MPI_Comm_f2c((MPI_Fint)comm));
}

void dem_free(struct dem *d)
{
    if (!d)
    {
        return;
    }
    MPI_Comm comm = d->state.decomposition.comm;

    for (size_t k = 0; k < d->mesh_walls; k++)
    {
        dem_memory_free(d->mesh_wall[k].triangles);
        dem_memory_free(d->mesh_wall[k].moved);
    }
    dem_memory_free(d->mesh_wall);
    for (size_t k = 0; k < d->patches; k++)
    {
        dem_memory_free(d->patch[k].triangles);
    }
    dem_memory_free(d->patch);
    dem_memory_free(d->outgoing);
    dem_memory_free(d->initial_material);
    dem_initial_particles_free(&d->initial);
    dem_text_free(&d->plan);
    dem_memory_free(d->verdicts);
    dem_text_free(&d->warnings);
    dem_text_free(&d->impact);
    dem_text_free(&d->effect);
    dem_text_free(&d->value_text);
    dem_text_free(&d->profile);
    dem_scene_free(&d->scene);
    dem_snapshot_scene_free(&d->before);
    dem_memory_free(d->reformed);
    for (size_t k = 0; k < d->notes; k++)
    {
        dem_memory_free(d->note[k]);
    }
    dem_memory_free(d->note);
    dem_dict_free(d->dict);
    dem_halo_free(&d->state.halo);
    dem_pairs_free(&d->state.pairs);
    dem_wall_touches_free(&d->state.touches);
    dem_attached_stores_free(&d->stores);
    dem_backup_free(&d->state.backup);
    dem_contacts_free(&d->state.contacts);
    dem_particles_free(&d->state.particles);
    dem_walls_free(&d->state.walls);
    dem_wall_store_free(&d->state.wall_store);
    dem_interaction_table_free(&d->state.interaction_table);
    dem_applied_forces_free(&d->state.applied_forces);
    dem_load_balance_free(&d->state.load_balance);
    dem_decomposition_free(&d->state.decomposition);
    dem_memory_free(d);
    if (comm != MPI_COMM_NULL)
    {
        (void)MPI_Comm_free(&comm);    /* no caller to report to */
    }
}

/* ---- scene ----------------------------------------------------------------------------------- */

int dem_scene_file(struct dem *d, const char *path)
{
    DEM_TRY(dem_api_require_unchecked(d, "dem_scene_file"));
    DEM_REQUIRE(!d->dict, DEM_ERROR_STATE, "dem_scene_file: a scene has been read already; create "
                "another simulation for %s", path);
    return dem_dict_read_file(&d->dict, path);
}

int dem_scene_text(struct dem *d, const char *text, const char *name)
{
    DEM_TRY(dem_api_require_unchecked(d, "dem_scene_text"));
    DEM_REQUIRE(!d->dict, DEM_ERROR_STATE, "dem_scene_text: a scene has been read already; create "
                "another simulation for %s", name);
    return dem_dict_read_text(&d->dict, text, name);
}

int dem_set(struct dem *d, const char *path, const char *value)
{
    DEM_TRY(dem_api_require_unchecked(d, "dem_set"));
    DEM_REQUIRE(d->dict, DEM_ERROR_STATE, "dem_set comes after the scene has been read");
    return dem_dict_set(d->dict, path, value);
}

int dem_remove_effect(struct dem *d, const char *effect)
{
    DEM_TRY(dem_api_require_unchecked(d, "dem_remove_effect"));
    DEM_REQUIRE(d->dict, DEM_ERROR_STATE, "dem_remove_effect comes after the scene has been read");
    DEM_REQUIRE(dem_dict_remove(d->dict, "effects", false, effect), DEM_ERROR_INPUT,
                "the scene has no effect %s to leave out", effect);
    (void)dem_dict_remove(d->dict, "pairs", true, effect);
    return DEM_OK;
}

/* ---- walls and particles of the program ------------------------------------------------------ */

static int add_wall(struct dem *d, const char *name, const char *material, int64_t n,
                    const double *triangles)
{
    struct dem_mesh_wall *w;

    DEM_TRY(dem_api_require_unchecked(d, "dem_add_wall"));
    DEM_TRY(dem_api_require_count("dem_add_wall", "triangles", n));
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

int dem_add_wall(struct dem *d, const char *name, const char *material, int64_t n,
                 const double *triangles)
{
    return dem_api_agree(d, add_wall(d, name, material, n, triangles));
}

/* The original triangles stay; each call overwrites the moved ones. */
static int copy_moved_corners(struct dem_mesh_wall *w, int64_t n, const double *triangles)
{
    DEM_REQUIRE(n >= 0 && (size_t)n == w->n, DEM_ERROR_INPUT, "wall %s is to move with %lld "
                "triangles, but was added with %zu; a mesh may move, but its faces must stay the "
                "same", w->name, (long long)n, w->n);
    if (!w->moved)
    {
        DEM_TRY(DEM_NEW(w->moved, 9*w->n + 1));
    }
    memcpy(w->moved, triangles, 9*w->n*sizeof *triangles);
    return DEM_OK;
}

int dem_wall_move(struct dem *d, const char *name, int64_t n, const double *triangles)
{
    size_t k = 0;

    while (k < d->mesh_walls && strcmp(d->mesh_wall[k].name, name) != 0)
    {
        k++;
    }
    DEM_REQUIRE(k < d->mesh_walls, DEM_ERROR_INPUT,
                "dem_wall_move: there is no wall %s of dem_add_wall", name);
    DEM_TRY(dem_api_agree(d, copy_moved_corners(&d->mesh_wall[k], n, triangles)));
    return d->is_set_up ? dem_api_move_wall(d, &d->mesh_wall[k], 0) : DEM_OK;
}

static int add_particles(struct dem *d, int64_t n, const struct dem_new_particle *added)
{
    DEM_TRY(dem_api_require_count("dem_add_particles", "particles", n));
    DEM_TRY(DEM_GROW(d->initial_material, d->initial_capacity, d->initial.n + (size_t)n + 1));
    for (int64_t k = 0; k < n; k++)
    {
        struct dem_particle p =
            dem_particle_sphere(added[k].id, added[k].position, added[k].diameter, 1.0, 0);

        memcpy(p.v, added[k].velocity, sizeof p.v);
        memcpy(p.w, added[k].spin, sizeof p.w);
        p.flags = added[k].frozen ? DEM_PARTICLE_FROZEN : 0;
        snprintf(d->initial_material[d->initial.n], sizeof *d->initial_material, "%s",
                 added[k].material);
        DEM_TRY(dem_initial_particles_add(&d->initial, p, "dem_add_particles"));
        /* the next free id is known only when the scene has inserted its own particles */
        d->initial.particle[d->initial.n - 1].id = added[k].id;
    }
    return DEM_OK;
}

int dem_add_particles(struct dem *d, int64_t n, const struct dem_new_particle *added)
{
    fenv_t caller;

    DEM_TRY(dem_api_require_unchecked(d, "dem_add_particles"));
    feholdexcept(&caller);    /* a diameter of 0 ends in a message, not in a signal */
    const int status = add_particles(d, n, added);

    fesetenv(&caller);
    return status;
}

/* ---- check, set-up, plan --------------------------------------------------------------------- */

/* The library checks for numbers that are not finite itself. */
static int without_traps(struct dem *d, int (*call)(struct dem *))
{
    fenv_t caller;

    feholdexcept(&caller);
    const int status = call(d);

    fesetenv(&caller);
    return status;
}

int dem_check(struct dem *d)
{
    DEM_TRY(dem_api_require_unchecked(d, "dem_check"));
    DEM_REQUIRE(d->dict, DEM_ERROR_STATE, "dem_check comes after the scene has been read");
    return without_traps(d, dem_api_read_scene);
}

int dem_setup(struct dem *d)
{
    DEM_REQUIRE(d->checked >= 0, DEM_ERROR_STATE, "dem_setup after a dem_check or dem_setup that "
                "failed; call dem_free and start again");
    DEM_REQUIRE(!d->is_set_up, DEM_ERROR_STATE, "dem_setup has been called already; call it once");
    DEM_REQUIRE(d->dict, DEM_ERROR_STATE, "dem_setup comes after the scene has been read");
    const int status = without_traps(d, dem_api_setup);

    d->checked = status ? -1 : d->checked;
    return status;
}

const struct dem_dict *dem_scene_dict(const struct dem *d)
{
    return d->dict;
}

int dem_bed_slab(const struct dem *d, double up[3], double *low, double *high)
{
    struct dem_bed_packing bed;
    const int found = d->is_set_up && dem_bed_packing_measure(&d->state, &bed);

    memset(up, 0, 3*sizeof *up);
    *low = *high = 0.0;
    if (found)
    {
        memcpy(up, bed.up, sizeof bed.up);
        *low = bed.low;
        *high = bed.high;
    }
    return found;
}

const char *dem_heading(const struct dem *d)
{
    return d->heading;
}

const char *dem_effect_names(const struct dem *d)
{
    return d->heading + DEM_HEADING;
}

const char *dem_fluid_effect_names(const struct dem *d)
{
    return d->fluid_effects;
}

unsigned dem_effect_traits(const char *name)
{
    const struct dem_effect *const effect = dem_effects_find(name);

    if (!effect)
    {
        return 0;
    }
    return (effect->has_pressure_gradient ? DEM_TRAIT_PRESSURE_GRADIENT : 0U) |
           (effect->needs & DEM_NEEDS_ACCELERATION ? DEM_TRAIT_FLUID_ACCELERATION : 0U) |
           (effect->needs & DEM_NEEDS_STRESS ? DEM_TRAIT_FLUID_STRESS : 0U) |
           (effect->needs & DEM_NEEDS_TURBULENCE ? DEM_TRAIT_TURBULENCE : 0U) |
           (effect->needs & DEM_NEEDS_FLUID ? DEM_TRAIT_FLUID : 0U) |
           (effect->needs & DEM_NEEDS_VISCOSITY ? DEM_TRAIT_VISCOSITY : 0U);
}

int dem_gravity_acceleration(const struct dem *d, double g[3])
{
    return dem_interaction_table_gravity(&d->state.interaction_table, g) != NULL;
}

/* ---- advance --------------------------------------------------------------------------------- */

static int check_fluid(const struct dem *d)
{
    DEM_TRY(dem_require_fluid(d));
    DEM_TRY(d->coupled ? dem_api_agree(d, dem_api_require_fluid_scalars(d)) : DEM_OK);
    DEM_REQUIRE(!(d->coupled && d->driven), DEM_ERROR_INPUT,
                "there are driven particles, which the balances of a coupled run do not know; make "
                "them frozen, or let a wall move");
    DEM_REQUIRE(!(d->coupled && d->state.applied_forces.n > 0), DEM_ERROR_INPUT,
                "the scene has forces, which the balances of a coupled run do not know; remove "
                "forces, or run the scene by itself");
    DEM_REQUIRE(!d->with_fluid || d->scene.fluid.given || d->flow_on_request
                    || d->state.flows->plan->streams == 0,
                DEM_ERROR_STATE,
                "insert/%s inserts particles during an advance, but the coupled fluid knows no new "
                "particle before the next exchange; call dem_flow_on_request before dem_check, and "
                "dem_flow_apply between two advances",
                d->state.flows->plan->stream[0].name);
    return DEM_OK;
}

static const double max_steps = 0x1p53;    /* larger whole numbers are not exact in a double */

/* 1 when a window was interrupted and this advance asks for the rest of it: same end, same
   number of steps. */
static int continues_window(const struct dem *d, double duration)
{
    const struct dem_state *const p = &d->state;
    const double rest = p->window.start + p->window.length - p->time;

    return p->window.half_step_ahead && fabs(duration - rest) <= 1e-3*p->dt
        && ceil(p->window.length/d->step*(1.0 - 1e-12)) == (double)p->window.steps;
}

int dem_advance(struct dem *d, double duration)
{
    fenv_t caller;

    DEM_REQUIRE(d->is_set_up, DEM_ERROR_STATE, "dem_advance comes after dem_setup");
    DEM_TRY(dem_api_require_sound(d, "dem_advance"));
    DEM_REQUIRE(isgreater(duration, 0.0) && isfinite(duration), DEM_ERROR_INPUT,
                "duration %g s; give a time above 0", duration);
    DEM_TRY(check_fluid(d));
    DEM_REQUIRE(duration < max_steps*d->step, DEM_ERROR_INPUT,
                "%g s at steps of %g s are more than %g steps; give a longer step or a shorter "
                "time",
                duration, d->step, max_steps);
    const int64_t steps = (int64_t)ceil(duration/d->step*(1.0 - 1e-12));

    feholdexcept(&caller);
    int status = continues_window(d, duration)
                   ? dem_step_continue(&d->state)
                   : dem_step_window(&d->state, duration/(double)(steps > 0 ? steps : 1),
                                     steps > 0 ? steps : 1);

    status = status ? status : dem_fall_check(&d->state);
    fesetenv(&caller);
    d->failed = status != DEM_OK;
    d->ranks_apart = status != DEM_OK && status != DEM_ERROR_NUMBER && status != DEM_ERROR_LOST;
    return status;
}

void dem_set_stop_flag(struct dem *d, const volatile sig_atomic_t *asked)
{
    d->state.stop_request = asked;
}

void dem_set_progress(struct dem *d, double seconds,
                      void (*report)(void *self, double time, int64_t steps), void *self)
{
    d->state.progress = (struct dem_progress){.report = report,
                                              .self = self,
                                              .seconds = seconds,
                                              .last = dem_clock_wall()};
}

int dem_stopped(const struct dem *d)
{
    return d->state.window.half_step_ahead ? d->state.window.stopped : 0;
}

/* ---- save and restore ------------------------------------------------------------------------ */

/* The scene goes behind the averages. */
static int add_scene(struct dem *d, struct dem_snapshot_scene *scene, struct dem_span **span, int *n)
{
    size_t capacity = (size_t)*n;

    DEM_TRY(dem_api_describe_scene(d, scene));
    DEM_TRY(DEM_GROW(*span, capacity, (size_t)*n + DEM_SNAPSHOT_SCENE_SPANS));
    dem_snapshot_scene_spans(scene, *span + *n);
    *n += DEM_SNAPSHOT_SCENE_SPANS;
    return DEM_OK;
}

static int write_snapshot(struct dem *d, const char *path, struct dem_snapshot *s)
{
    struct dem_state *const p = &d->state;
    struct dem_grid_average_record *record = NULL;
    struct dem_snapshot_scene scene = {.text = NULL};
    struct dem_span *span = NULL;
    int status = DEM_OK;

    /* after dem_restore the sums hold later samples */
    if (p->averages->grids > 0 && p->decomposition.rank == 0 && !d->restored)
    {
        status = dem_grid_averages_spans(p->averages, &record, &span, &s->caller_data_count);
    }
    if (p->decomposition.rank == 0)
    {
        status = status ? status : add_scene(d, &scene, &span, &s->caller_data_count);
    }
    status = dem_api_agree(d, status);
    s->caller_data = span;
    status = status ? status
                    : dem_snapshot_write(path, s, &p->decomposition, &p->interaction_table,
                                         &p->particles, &p->contacts, p->pairs.wall_facet);
    dem_snapshot_scene_free(&scene);
    dem_memory_free(record);
    dem_memory_free(span);
    return status;
}

int dem_save(struct dem *d, const char *path)
{
    struct dem_state *const p = &d->state;
    struct dem_snapshot s = {.steps = p->steps, .time = p->time, .domain = &p->domain};

    DEM_REQUIRE(d->is_set_up, DEM_ERROR_STATE, "dem_save comes after dem_setup");
    DEM_TRY(dem_api_require_sound(d, "dem_save"));
    memcpy(s.skin_tuning, &p->pairs.skins, sizeof p->pairs.skins);
    s.flows = p->flows->n;
    s.next_id = p->flows->next_id;
    memcpy(s.flow, p->flows->flow, (size_t)p->flows->n*sizeof *s.flow);
    if (p->window.half_step_ahead)
    {
        s.window = (struct dem_snapshot_window){.ahead = p->window.steps,
                                                .done = p->steps - p->window.steps_before,
                                                .opened = p->window.start,
                                                .dt = p->dt};
    }
    DEM_TRY(write_snapshot(d, path, &s));
    /* A run that loads the file rebuilds its lists first and wraps positions then; the run that
       wrote it does the same, so that both have the same bits. A state without lists (2) stays
       without. */
    p->stale = p->stale == 2 ? 2 : 1;
    return DEM_OK;
}

int dem_backup_every(struct dem *d, int64_t steps)
{
    fenv_t caller;

    DEM_REQUIRE(d->is_set_up, DEM_ERROR_STATE, "dem_backup_every comes after dem_setup");
    DEM_TRY(dem_api_require_sound(d, "dem_backup_every"));
    DEM_REQUIRE(steps >= 0, DEM_ERROR_INPUT, "backups every %lld steps; give a number above 0, or "
                "0 for none", (long long)steps);
    d->state.backup.every = steps;
    feholdexcept(&caller);    /* it checks for numbers that are not finite */
    const int status = dem_step_backup(&d->state);

    fesetenv(&caller);
    return status;
}

int dem_ranks_agree(const struct dem *d)
{
    return !d->ranks_apart;
}

int dem_restore(struct dem *d, double *time)
{
    struct dem_state *const p = &d->state;

    DEM_REQUIRE(p->backup.valid, DEM_ERROR_STATE,
                "there is no backup to restore; dem_backup_every comes before dem_restore");
    DEM_TRY(dem_backup_restore(&p->backup, &p->particles, &p->contacts));
    dem_flows_restore(p->flows);
    dem_wall_statistics_drop_forces(p->wall_statistics);
    dem_walls_rewind(&p->walls);
    dem_unagreed_reset(&p->unagreed);
    d->restored = 1;
    d->failed = 0;
    p->steps = p->backup.steps;
    p->time = *time = p->backup.time;
    p->limits.overlap = 0.0;
    p->stale = 2;
    p->window.half_step_ahead = 0;
    return DEM_OK;
}
