/*
 * sweep_bodies.h -- forces on single particles (gravity, fluid) and the kick that integrates
 * velocities and spins.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/applied_forces.h"
#include "contacts/contacts.h"
#include "particles/clump_flow.h"
#include "particles/particles.h"
#include "laws/interaction_table.h"
#include "step/body_batch.h"
#include "step/body_scalars.h"
#include "records/energy_balance.h"
#include "step/drift.h"

struct dem_body_sweep    /* options of one sweep over all particles */
{
    /* s  velocities and spins are kicked over this time */
    double kick;
    /* s  the impulse carried over from the last exchange is spread over this; 0: none */
    double window;
    /* contact forces to be summed first, while they are in cache; NULL: summed already */
    const struct dem_contacts *contacts;
    /* 1: a pass sums all particles before it kicks (dem_bodies_finish_sums) */
    int sums_first;
    /* 1: nothing reads forces or positions before the next step: forces are not stored */
    int unobserved;
    /* if unobserved, kicked particles drift at once, over the kick, with this rounding
       (dem_domain.round); NULL: something has to be done before the drift */
    const double *round;
    /* NULL: none */
    const struct dem_applied_forces *applied;
    /* where they act */
    const struct dem_domain *domain;
    /* s  time of the applied forces */
    double time;
    /* energy balance that sums the work; NULL: none */
    struct dem_energy_balance *energy_balance;
    /* rigid bodies of several spheres, which are kicked after the sweep; the sweep keeps their contact
       forces. NULL: none */
    const struct dem_clumps *clumps;
    /* what a fluid does to them; set for arrivals, too, whose `clumps` are NULL. NULL: no fluid */
    const struct dem_clump_flow *clump_flow;
    /* particle scalars, integrated before the kick */
    struct dem_scalar_step scalars;
};

/* Evaluate the body effects at the present state and kick all particles. Contact force and torque
   are constant over the kick; drag is integrated exactly. */
void dem_sweep_bodies(struct dem_particles *, const struct dem_effect_list *effects,
                      const struct dem_body_sweep *);

enum dem_bodies_work
{
    DEM_BODIES_SUM_AND_KICK,
    DEM_BODIES_SUM,     /* contact forces are summed into the columns force and torque; no kick */
    DEM_BODIES_KICK     /* by the forces in these columns */
};

struct dem_body_pass    /* the same sweep in parts, as far as contact forces are known */
{
    enum dem_bodies_work work;
    struct dem_particles *particles;
    /* the body effects */
    const struct dem_effect_list *effects;
    const struct dem_body_sweep *sweep;
    /* first particle that has not been worked on */
    size_t next;
    /* as in the options, or 0 after an event that reads speeds */
    int unobserved;
    /* speeds of the particles that have drifted */
    struct dem_drift_speeds speeds;
    /* of the present batch; NULL: none */
    struct dem_body_scalars *scalars;
    /* values of scalars out of their range */
    int bad_scalars;
    struct dem_body_workspace workspace;
};

/* Begin a pass over the particles; kicks none. The particles, effects and options are only
   referenced: they have to outlive the pass. */
void dem_bodies_begin_pass(struct dem_body_pass *, struct dem_particles *,
                           const struct dem_effect_list *effects, const struct dem_body_sweep *);

/* The work of the pass on the particles up to `end`, in whole batches of DEM_BATCH_ROWS. */
void dem_bodies_work_until(struct dem_body_pass *, size_t end);

/* In a pass that only sums: the rest of the sums; then the pass begins again with the kick. */
void dem_bodies_finish_sums(struct dem_body_pass *);
