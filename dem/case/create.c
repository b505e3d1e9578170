/*
 * create.c -- create a case, with the run that it will become, and free both.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "device/device_steps.h"
#include "core/memory.h"
#include "particles/clump_flow.h"
#include "ranks/collect.h"
#include "ranks/mpi_error.h"
#include "step/clump_heat.h"

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

/* A case and its run, without a communicator; frees what it has made when it fails. */
static int allocate(struct dem_case **made)
{
    struct dem_case *c;

    DEM_TRY(DEM_NEW(c, 1));
    if (DEM_NEW(c->d, 1))
    {
        dem_memory_free(c);
        return DEM_ERROR_MEMORY;
    }
    *made = c;
    return DEM_OK;
}

static int begin(struct dem *d, MPI_Comm comm, int rank, int ranks)
{
    dem_attached_stores_attach(&d->stores, &d->state);
    dem_domain_init(&d->state.domain);
    dem_interaction_table_init(&d->state.interaction_table);
    DEM_TRY(dem_decomposition_init(&d->state.decomposition, comm, rank, ranks));
    dem_halo_init(&d->state.halo, &d->state.decomposition);
    dem_wall_store_init(&d->state.wall_store, &d->state.decomposition);
    return DEM_OK;
}

int dem_case_create(struct dem_case **out, MPI_Comm comm)
{
    MPI_Comm own = MPI_COMM_NULL;
    struct dem_case *c = NULL;
    int rank = 0, ranks = 1;
    int status = comm == MPI_COMM_NULL ? DEM_OK : duplicate(comm, &own, &rank, &ranks);

    *out = NULL;
    status = status ? status : allocate(&c);
    status = status ? status : begin(c->d, own, rank, ranks);
    status = dem_collect_agree(&(struct dem_decomposition){.comm = own, .ranks = ranks}, status);
    if (status)
    {
        if (c)
        {
            dem_decomposition_free(&c->d->state.decomposition);
            dem_memory_free(c->d);
        }
        dem_memory_free(c);
        if (own != MPI_COMM_NULL)
        {
            (void)MPI_Comm_free(&own);
        }
        return status;
    }
    *out = c;
    return DEM_OK;
}

int dem_case_create_fortran(struct dem_case **out, int comm)
{
    return dem_case_create(out, comm == -1 ? MPI_COMM_NULL : MPI_Comm_f2c((MPI_Fint)comm));
}

void dem_case_free(struct dem_case *c)
{
    if (!c)
    {
        return;
    }
    dem_memory_free(c->initial_material);
    dem_memory_free(c->allowed);
    dem_initial_particles_free(&c->initial);
    dem_memory_free(c->reformed);
    dem_free(c->d);
    dem_memory_free(c);
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
    dem_text_free(&d->impact);
    dem_text_free(&d->profile);
    dem_device_free(&d->state);
    dem_scene_free(&d->scene);
    dem_snapshot_scene_free(&d->before);
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
    if (d->state.clumps.flow)
    {
        dem_clump_flow_free(d->state.clumps.flow);
        dem_memory_free(d->state.clumps.flow);
    }
    if (d->state.clumps.heat)
    {
        dem_memory_free(d->state.clumps.heat->row);
        dem_memory_free(d->state.clumps.heat);
    }
    dem_clumps_free(&d->state.clumps);
    dem_applied_forces_free(&d->state.applied_forces);
    dem_load_balance_free(&d->state.load_balance);
    dem_decomposition_free(&d->state.decomposition);
    dem_memory_free(d);
    if (comm != MPI_COMM_NULL)
    {
        (void)MPI_Comm_free(&comm);    /* no caller to report to */
    }
}
