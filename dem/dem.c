/*
 * dem.c -- the door: making a run, driving it, keeping it. Looking at it is in look.c, its fluid in fluid.c; how a scene becomes a
 * running state in ready.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "door.h"
#include "base/error.h"
#include "base/memory.h"
#include "io/snapshot.h"
#include "plan/plan.h"
#include "step/step.h"
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- making -------------------------------------------------------------------------------------------------- */

int dem_create(struct dem **out, MPI_Comm comm)
{
    MPI_Comm own = MPI_COMM_NULL;
    struct dem *d;
    int rank = 0, ranks = 1;

    DEM_TRY(DEM_NEW(d, 1));
    if (comm != MPI_COMM_NULL)
    {
        MPI_Comm_dup(comm, &own);
        MPI_Comm_rank(own, &rank);
        MPI_Comm_size(own, &ranks);
    }
    dem_domain_init(&d->parts.domain);
    dem_recipe_init(&d->parts.recipe);
    DEM_TRY(dem_pieces_init(&d->parts.pieces, own, rank, ranks));
    dem_halo_init(&d->parts.halo, &d->parts.pieces);
    *out = d;
    return DEM_OK;
}

void dem_free(struct dem *d)
{
    if (!d)
    {
        return;
    }
    MPI_Comm comm = d->parts.pieces.comm;

    for (size_t k = 0; k < d->mesh_walls; k++)
    {
        dem_memory_free(d->mesh_wall[k].triangles);
        dem_memory_free(d->mesh_wall[k].now);
    }
    dem_memory_free(d->mesh_wall);
    for (size_t k = 0; k < d->patches; k++)
    {
        dem_memory_free(d->patch[k].triangles);
    }
    dem_memory_free(d->patch);
    dem_memory_free(d->goer);
    dem_memory_free(d->crowd_material);
    dem_crowd_free(&d->crowd);
    dem_averages_free(&d->parts.averages);
    dem_text_free(&d->plan);
    dem_text_free(&d->profile);
    dem_scene_free(&d->scene);
    dem_dict_free(d->dict);
    dem_halo_free(&d->parts.halo);
    dem_pairs_free(&d->parts.pairs);
    dem_wall_touches_free(&d->parts.touches);
    dem_losses_free(&d->parts.losses);
    dem_flows_free(&d->parts.flows);
    dem_bonds_free(&d->parts.bonds);
    dem_kept_free(&d->parts.kept);
    dem_wall_books_free(&d->parts.books);
    dem_ledger_free(&d->parts.ledger);
    dem_durations_free(&d->parts.durations);
    dem_contacts_free(&d->parts.contacts);
    dem_particles_free(&d->parts.particles);
    dem_walls_free(&d->parts.walls);
    dem_recipe_free(&d->parts.recipe);
    dem_balance_free(&d->parts.balance);
    dem_pieces_free(&d->parts.pieces);
    dem_memory_free(d);
    if (comm != MPI_COMM_NULL)
    {
        MPI_Comm_free(&comm);
    }
}

int dem_door_early(const struct dem *d, const char *call)
{
    DEM_REQUIRE(d->checked >= 0, DEM_ERROR_STATE, "%s after a scene that was refused; dem_free, and begin anew", call);
    DEM_REQUIRE(!d->checked, DEM_ERROR_STATE, "%s comes before dem_check and dem_ready", call);
    return DEM_OK;
}

int dem_scene_file(struct dem *d, const char *path)
{
    DEM_TRY(dem_door_early(d, "dem_scene_file"));
    DEM_REQUIRE(!d->dict, DEM_ERROR_STATE, "a scene has been read already");
    return dem_dict_read_file(&d->dict, path);
}

int dem_scene_text(struct dem *d, const char *text, const char *name)
{
    DEM_TRY(dem_door_early(d, "dem_scene_text"));
    DEM_REQUIRE(!d->dict, DEM_ERROR_STATE, "a scene has been read already");
    return dem_dict_read_text(&d->dict, text, name);
}

/* a/b/c with a value becomes the text "a { b { c value; } }", merged into the scene */
int dem_set(struct dem *d, const char *path, const char *value)
{
    char text[1024] = "", close[128] = "";
    size_t used = 0, depth = 0;

    DEM_TRY(dem_door_early(d, "dem_set"));
    DEM_REQUIRE(d->dict, DEM_ERROR_STATE, "dem_set comes after the scene has been read");
    DEM_REQUIRE(strlen(path) + strlen(value) < sizeof text/2, DEM_ERROR_INPUT, "%s = %s is too long", path, value);
    for (const char *at = path; *at; at++)
    {
        text[used++] = *at == '/' ? '{' : *at;
        depth += *at == '/';
    }
    DEM_REQUIRE(depth < sizeof close/2, DEM_ERROR_INPUT, "%s is nested too deeply", path);
    for (size_t k = 0; k < depth; k++)
    {
        close[k] = '}';
    }
    snprintf(text + used, sizeof text - used, " %s; %s", value, close);
    return dem_dict_read_more(d->dict, text, path);
}

int dem_leave_out(struct dem *d, const char *effect)
{
    DEM_TRY(dem_door_early(d, "dem_leave_out"));
    DEM_REQUIRE(d->dict, DEM_ERROR_STATE, "dem_leave_out comes after the scene has been read");
    DEM_REQUIRE(dem_dict_remove(d->dict, "effects", false, effect), DEM_ERROR_INPUT, "the scene has no effect %s to leave out", effect);
    (void)dem_dict_remove(d->dict, "pairs", true, effect);
    return DEM_OK;
}

int dem_add_wall(struct dem *d, const char *name, const char *material, int64_t n, const double *triangles)
{
    struct dem_mesh_wall *w;

    DEM_TRY(dem_door_early(d, "dem_add_wall"));
    DEM_REQUIRE(strlen(name) < sizeof w->name && strlen(material) < sizeof w->material, DEM_ERROR_INPUT,
                "wall %s of %s: a name longer than %zu letters; shorten it", name, material, sizeof w->material - 1);
    DEM_TRY(DEM_GROW(d->mesh_wall, d->mesh_wall_room, d->mesh_walls + 1));
    w = &d->mesh_wall[d->mesh_walls++];
    snprintf(w->name, sizeof w->name, "%s", name);
    snprintf(w->material, sizeof w->material, "%s", material);
    w->n = (size_t)n;
    DEM_TRY(DEM_NEW(w->triangles, 9*w->n + 1));
    memcpy(w->triangles, triangles, 9*w->n*sizeof *triangles);
    return DEM_OK;
}

/* Kept beside the triangles handed in: the next call writes over it. */
static int take_corners(struct dem_mesh_wall *w, int64_t n, const double *triangles)
{
    DEM_REQUIRE(n >= 0 && (size_t)n == w->n, DEM_ERROR_INPUT, "wall %s is to move with %lld triangles, but was handed in with %zu; a mesh "
                "may move, but not change", w->name, (long long)n, w->n);
    if (!w->now)
    {
        DEM_TRY(DEM_NEW(w->now, 9*w->n + 1));
    }
    memcpy(w->now, triangles, 9*w->n*sizeof *triangles);
    return DEM_OK;
}

int dem_wall_move(struct dem *d, const char *name, int64_t n, const double *triangles)
{
    size_t k = 0;

    while (k < d->mesh_walls && strcmp(d->mesh_wall[k].name, name) != 0)
    {
        k++;
    }
    DEM_REQUIRE(k < d->mesh_walls, DEM_ERROR_INPUT, "dem_wall_move: there is no wall %s of dem_add_wall", name);
    DEM_TRY(take_corners(&d->mesh_wall[k], n, triangles));
    return d->ready ? dem_door_tell_wall(d, &d->mesh_wall[k], 0) : DEM_OK;
}

static int add_particles(struct dem *d, int64_t n, const struct dem_seed *seed)
{
    DEM_TRY(DEM_GROW(d->crowd_material, d->crowd_room, d->crowd.n + (size_t)n + 1));
    for (int64_t k = 0; k < n; k++)
    {
        struct dem_particle p = dem_particle_sphere(seed[k].id, seed[k].position, seed[k].diameter, 1.0, 0);

        memcpy(p.v, seed[k].velocity, sizeof p.v);
        memcpy(p.w, seed[k].spin, sizeof p.w);
        p.flags = seed[k].frozen ? DEM_PARTICLE_FROZEN : 0;
        snprintf(d->crowd_material[d->crowd.n], sizeof *d->crowd_material, "%s", seed[k].material);
        DEM_TRY(dem_crowd_add(&d->crowd, p, "dem_add_particles"));
        /* the next free number is known when the scene has inserted its own */
        d->crowd.particle[d->crowd.n - 1].id = seed[k].id;
    }
    return DEM_OK;
}

int dem_add_particles(struct dem *d, int64_t n, const struct dem_seed *seed)
{
    fenv_t caller;

    DEM_TRY(dem_door_early(d, "dem_add_particles"));
    feholdexcept(&caller);                                /* a diameter of 0 is refused with a sentence, not with a signal */
    const int status = add_particles(d, n, seed);

    fesetenv(&caller);
    return status;
}

int dem_load(struct dem *d, const char *path)
{
    DEM_TRY(dem_door_early(d, "dem_load"));
    DEM_REQUIRE(strlen(path) < sizeof d->load, DEM_ERROR_INPUT, "path %s is longer than %zu letters", path, sizeof d->load - 1);
    snprintf(d->load, sizeof d->load, "%s", path);
    return DEM_OK;
}

/* ---- getting ready ------------------------------------------------------------------------------------------- */

/* A caller may trap floating-point errors (OpenFOAM does); the core looks at its numbers itself. */
static int at_ease(struct dem *d, int (*call)(struct dem *))
{
    fenv_t caller;

    feholdexcept(&caller);
    const int status = call(d);

    fesetenv(&caller);
    return status;
}

int dem_check(struct dem *d)
{
    DEM_TRY(dem_door_early(d, "dem_check"));
    DEM_REQUIRE(d->dict, DEM_ERROR_STATE, "dem_check comes after the scene has been read");
    return at_ease(d, dem_door_read);
}

int dem_ready(struct dem *d)
{
    DEM_REQUIRE(d->checked >= 0, DEM_ERROR_STATE, "dem_ready after a scene that was refused; dem_free, and begin anew");
    DEM_REQUIRE(!d->ready, DEM_ERROR_STATE, "dem_ready comes once");
    DEM_REQUIRE(d->dict, DEM_ERROR_STATE, "dem_ready comes after the scene has been read");
    return at_ease(d, dem_door_get_ready);
}

const struct dem_dict *dem_scene_dict(const struct dem *d)
{
    return d->dict;
}

int dem_plan(struct dem *d, const struct dem_prospect *prospect, const char **text)
{
    struct dem_plan plan = {.parts = &d->parts, .scene = &d->scene, .prospect = *prospect, .step = d->step};
    fenv_t caller;

    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_plan comes after dem_ready");
    dem_text_free(&d->plan);
    feholdexcept(&caller);
    const int status = dem_plan_write(&d->plan, &plan);

    fesetenv(&caller);
    *text = d->plan.text;
    d->verdicts = plan.verdicts;
    return status;
}

int dem_verdicts(const struct dem *d, const struct dem_verdict **verdict)
{
    *verdict = d->verdicts.verdict;
    return d->verdicts.n;
}

const char *dem_heading(const struct dem *d)
{
    return d->heading;
}

const char *dem_acting(const struct dem *d)
{
    return d->heading + DEM_HEADING;
}

const char *dem_acting_fluid(const struct dem *d)
{
    return d->in_fluid;
}

/* ---- running ------------------------------------------------------------------------------------------------- */

static int check_fluid(const struct dem *d)
{
    DEM_REQUIRE(!d->with_fluid || d->scene.fluid.given || d->coupled, DEM_ERROR_INPUT,
                "an effect of the scene needs a fluid, and there is none; add fluid { density; viscosity; velocity; } or run it "
                "in OpenFOAM");
    DEM_REQUIRE(!d->with_fluid || d->scene.fluid.given || d->between || d->parts.flows.plan->streams == 0, DEM_ERROR_STATE,
                "insert/%s lets particles in while the fluid is the program's, which knows nothing of them before the next hand-over; call "
                "dem_flow_between before dem_check, and dem_let_through between two advances", d->parts.flows.plan->stream[0].name);
    return DEM_OK;
}

static void tell_viscosity(struct dem_particles *p)
{
    const double *const mu = dem_column(p, DEM_COLUMN_FLUID_VISCOSITY);

    for (size_t i = 0; mu && i < p->n; i++)
    {
        p->record[i].viscosity = mu[i];
    }
}

static const double most_steps = 0x1p53;                  /* whole numbers that a double tells apart */

/* 1 when the window that is open is the one that this advance wants the rest of: its end, and steps as they would be cut now. */
static int goes_on(const struct dem *d, double duration)
{
    const struct dem_parts *const p = &d->parts;
    const double rest = p->opened + p->window - p->time;

    return p->open && fabs(duration - rest) <= 1e-3*p->dt && ceil(p->window/d->step*(1.0 - 1e-12)) == (double)p->ahead;
}

int dem_advance(struct dem *d, double duration)
{
    fenv_t caller;

    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_advance comes after dem_ready");
    DEM_REQUIRE(isgreater(duration, 0.0) && isfinite(duration), DEM_ERROR_INPUT, "duration %g s; give a time above 0", duration);
    DEM_TRY(check_fluid(d));
    DEM_REQUIRE(duration < most_steps*d->step, DEM_ERROR_INPUT, "%g s at steps of %g s are more than %g steps; give a longer step or a "
                "shorter time", duration, d->step, most_steps);
    const int64_t steps = (int64_t)ceil(duration/d->step*(1.0 - 1e-12));

    tell_viscosity(&d->parts.particles);
    feholdexcept(&caller);
    const int status = goes_on(d, duration) ? dem_step_on(&d->parts)
                                            : dem_step_window(&d->parts, duration/(double)(steps > 0 ? steps : 1), steps > 0 ? steps : 1);

    fesetenv(&caller);
    d->broken = status != DEM_OK && status != DEM_ERROR_NUMBER && status != DEM_ERROR_LOST;
    return status;
}

void dem_stop_when(struct dem *d, const volatile sig_atomic_t *asked)
{
    d->parts.asked = asked;
}

int dem_stopped(const struct dem *d)
{
    return d->parts.open ? d->parts.stopped : 0;
}

/* ---- keeping ------------------------------------------------------------------------------------------------- */

static int write_snapshot(struct dem *d, const char *path, struct dem_snapshot *s)
{
    struct dem_parts *const p = &d->parts;
    struct dem_average_record *record = NULL;
    struct dem_span *span = NULL;
    int status = DEM_OK;

    if (p->averages.grids > 0 && p->pieces.rank == 0 && !d->restored)     /* after going back, sums are those of later times */
    {
        status = dem_averages_spans(&p->averages, &record, &span, &s->besides);
    }
    DEM_TRY(dem_door_together(d, status));
    s->beside = span;
    status = dem_snapshot_write(path, s, &p->pieces, &p->recipe, &p->particles, &p->contacts, p->pairs.wall_region);
    dem_memory_free(record);
    dem_memory_free(span);
    return status;
}

int dem_save(struct dem *d, const char *path)
{
    struct dem_parts *const p = &d->parts;
    struct dem_snapshot s = {.steps = p->steps, .time = p->time, .domain = &p->domain};

    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_save comes after dem_ready");
    memcpy(s.learnt, &p->pairs.skins, sizeof p->pairs.skins);
    s.flows = p->flows.n;
    s.next_id = p->flows.next_id;
    memcpy(s.flow, p->flows.flow, (size_t)p->flows.n*sizeof *s.flow);
    if (p->open)
    {
        s.window = (struct dem_snapshot_window){.ahead = p->ahead, .done = p->steps - p->before, .opened = p->opened, .dt = p->dt};
    }
    DEM_TRY(write_snapshot(d, path, &s));
    /* who goes on from the file rebuilds first and wraps positions there: so does who wrote it; without lists it stays without */
    p->stale = p->stale == 2 ? 2 : 1;
    return DEM_OK;
}

int dem_keep(struct dem *d, int64_t steps)
{
    fenv_t caller;

    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_keep comes after dem_ready");
    DEM_REQUIRE(steps >= 0, DEM_ERROR_INPUT, "copies %lld steps apart; give a number above 0, or 0 for none", (long long)steps);
    d->parts.kept.every = steps;
    feholdexcept(&caller);                                /* it looks for numbers that are none */
    const int status = dem_step_keep(&d->parts);

    fesetenv(&caller);
    return status;
}

int dem_ranks_agree(const struct dem *d)
{
    return !d->broken;
}

int dem_restore(struct dem *d, double *time)
{
    struct dem_parts *const p = &d->parts;

    DEM_REQUIRE(p->kept.held, DEM_ERROR_STATE, "there is no copy to go back to; dem_keep comes before dem_restore");
    DEM_TRY(dem_kept_give(&p->kept, &p->particles, &p->contacts));
    dem_flows_go_back(&p->flows);
    dem_wall_books_drop(&p->books);
    dem_walls_go_back(&p->walls);
    d->restored = 1;
    p->steps = p->kept.steps;
    p->time = *time = p->kept.time;
    p->watch.overlap = 0.0;
    p->stale = 2;
    p->open = 0;
    return DEM_OK;
}
