/*
 * sweep_bodies.h -- forces on single particles (gravity, fluid) and the kick that integrates everything.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_SWEEP_BODIES_H
#define DEM_STEP_SWEEP_BODIES_H

#include "space/domain.h"
#include "state/contacts.h"
#include "state/particles.h"
#include "state/recipe.h"
#include "step/body_tray.h"
#include "step/ledger.h"
#include "step/motion.h"

struct dem_body_sweep
{
    double kick;                                          /* s  velocities and spins are kicked over this */
    double window;                                        /* s  the pending impulse of the last exchange is spread over this; 0: none */
    const struct dem_contacts *contacts;                  /* to be summed first, while what they push is at hand; NULL: they are */
    int quiet;                                            /* 1: nobody looks between this step and the next: forces are not kept, */
    const double *round;                                  /* and who is kicked drifts on at once, over the kick, by dem_domain.round;
                                                             NULL: something else is to be done before */
    struct dem_ledger *ledger;                            /* books the work; NULL: nobody does */
};

/* Evaluate the body effects at the present state and kick. The contact force and torque of the columns act as constants; drag is
   integrated exactly. */
void dem_sweep_bodies(struct dem_particles *, const struct dem_chain *bodies, const struct dem_body_sweep *);

struct dem_body_pass                                      /* the same bit by bit, as far as contacts are known */
{
    struct dem_particles *particles;
    const struct dem_chain *bodies;
    const struct dem_body_sweep *sweep;
    size_t next;                                          /* the first who has not been kicked */
    int quiet;                                            /* as asked, unless something has happened that is to be told */
    struct dem_motion_seen seen;                          /* of who has drifted */
    struct dem_body_tray tray;
};

void dem_bodies_begin(struct dem_body_pass *, struct dem_particles *, const struct dem_chain *bodies, const struct dem_body_sweep *);

/* Blocks of DEM_BLOCK, up to the one that `end` is in or ends. */
void dem_bodies_until(struct dem_body_pass *, size_t end);

/* Start a window of the fluid: clear what the particles will tell it, work out what its steps have in common. */
void dem_bodies_open(struct dem_particles *, const struct dem_chain *bodies);

/* Only what laws of drag make of the fluid alone, and the added mass: for a window that is gone on with. */
void dem_bodies_open_laws(struct dem_particles *, const struct dem_chain *bodies);

/* End it: the response R of each particle from its drag impulse (see the definition in sweep_bodies.c). */
void dem_bodies_close(struct dem_particles *, const struct dem_domain *, double window);

#endif
