/*
 * dem_numbers.h -- numbers of a scene, from which advice is made: particles, walls, fluid and laws,
 * what each effect says of such a scene, memory and processor time.
 *
 * dem_plan.h makes sentences of them (advisor/); any other program can do so, too. Effects read
 * struct dem_regime: this header includes nothing of the library but dem_types.h.
 *
 * dem.h has the rules for return values, ownership and collective calls. Units are SI.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_NUMBERS_H
#define DEM_NUMBERS_H

#include "dem_types.h"

#ifdef __cplusplus
extern "C" {
#endif

struct dem;

/* ---- scene ----------------------------------------------------------------------------------- */

/* numbers of a scene: dem_scene_numbers; 0 where unknown */
struct dem_scene_numbers
{
    double step;                 /* s  longest step of dem_advance */
    double limit, next_limit;    /* s  smallest and second limit; infinite: none */
    const char *why, *next_why;  /* what sets them; until dem_free */

    /* particles of all ranks */
    double particles;                         /* 1  number */
    double min_diameter, max_diameter;        /* m */
    double squares, volume, mass;             /* m2, m3, kg  sums, of the diameters' squares */
    double moving_volume, moving_mass;        /* m3, kg  of particles that are not frozen */
    double grains, grain_squares;             /* 1, m2  sums over grains; without parcels as above */
    double min_parcel_ratio, max_parcel_ratio;  /* 1  0: no parcels */
    double max_speed;                         /* m/s */
    int driven;                               /* 1: there are driven particles */
    int frozen, wall_bodies;                  /* 1: there are frozen or driven particles; number of walls moved by force */
    int streams;                              /* number of streams */

    double gravity[3];                        /* m/s2 */

    /* room: between planes that face each other along an axis, or periodic faces */
    double width[3];                          /* m */
    int periodic[3];
    double section[3];                        /* m2  constant cross-section normal to an axis */
    double tube;                              /* m  diameter of the narrowest cylinder around
                                                 particles; 0: none */

    /* fluid: the scene's own, or the mean at the particles of a coupled one */
    int uniform, coupled;                     /* 1: the scene's own; 1: coupled */
    double fluid_density, viscosity;          /* kg/m3, Pa s */
    double fluid_speed, vorticity, stress;    /* m/s, 1/s, N/m3  magnitudes, of the scene's own */

    /* laws; contacts: of the first pair of materials */
    const char *drag_law;                     /* NULL: none */
    int pressure_gradient;                    /* 1: it acts on particles */
    double modulus;                           /* Pa  reduced */
    double exponent;                          /* 1  p of the normal law F ~ d^p */
    double impact_speed;                      /* m/s  impactSpeed of the normal law */
    double friction;                          /* 1 */
    double restitution;                       /* 1  NaN: the damping law has no such setting, or
                                                 there is none */
    int damped, adhesive;                     /* 1: there is a damping law; a law holds particles
                                                 together */
    double yield_strength;                    /* Pa  smallest of all materials */
};

/* Collective. */
int dem_scene_numbers(struct dem *, struct dem_scene_numbers *);

/* Collective. Effects with settings, materials, contacts, walls, particles, streams and outlets of
   the scene, as paragraphs of text. Valid until the next call of this thread. */
int dem_scene_text(struct dem *, const char **text);

/* Sentence k, from 0, on an entry that the scene has twice or that differs from the snapshot of the
   run. NULL behind the last; valid until dem_free. */
const char *dem_scene_note(const struct dem *, int k);

/* a material: dem_scene_material */
struct dem_scene_material
{
    const char *name;
    double density, youngs_modulus;  /* kg/m3, Pa */
    int present;                     /* 1: of particles */
};

/* Material k, from 0. Returns 0 behind the last. */
int dem_scene_material(const struct dem *, int k, struct dem_scene_material *);

/* a stream of insert: dem_stream_info */
struct dem_stream_info
{
    const char *name, *patch;           /* patch of the mesh; NULL: none */
    int by_mass, with_fluid;            /* 1: massRate; velocity of the fluid at the patch */
    double rate, volume_rate;           /* 1/s or kg/s; m3/s  mean, 0: all at once */
    double velocity[3], spread[3];      /* m/s */
    double density;                     /* kg/m3 */
    double min_diameter, max_diameter;  /* m  of the grains of parcels; of clumps: of the sphere of the same volume */
};

/* Stream k, from 0. Returns 0 behind the last. */
int dem_stream_info(const struct dem *, int k, struct dem_stream_info *);

/* 0 when particles of some material have no normal law at this wall. */
int dem_wall_has_law(const struct dem *, int wall);

/* Collective. Lines on impacts faster than impactSpeed that overlap by more than 5 % of a diameter,
   or by more than 20 % at any speed: of the fastest particle, the fastest wall, streams, and
   particles in a fluid of this speed [m/s]; without any, of impactSpeed itself, by more than 100 %.
   "" if there is nothing to say. Valid until the next call of this thread. */
int dem_impact_text(struct dem *, double fluid_speed, const char **text);

/* Collective. Lines on free walls and hinges that are too light for the step on the contacts to be expected, of at most
   this number of particles. "" without any. Valid until the next call of this thread. */
int dem_wall_mass_text(struct dem *, double particles, const char **text);

/* Collective. The void fraction of the slab of dem_bed_slab with this mean cross-section [m2]; 0
   when it is not known. */
double dem_bed_void_fraction(const struct dem *, double area);

/* ---- regime ---------------------------------------------------------------------------------- */

struct dem_suspension    /* equal spheres in a uniform fluid */
{
    double diameter, density;         /* m, kg/m3 */
    double fluid_density, viscosity;  /* kg/m3, Pa s */
    double gravity;                   /* m/s2 */
    int feels_gradient;               /* 1: the pressure gradient acts on particles */
};

/* numbers of a scene by which each effect tells whether the scene needs it; 0: unknown, unless
   noted otherwise. Spheres of the Sauter diameter, and the first pair of materials, represent all. */
struct dem_regime
{
    int fluid;                     /* 1: the scene has a fluid */
    int uniform;                   /* 1: from the entry `fluid`, not coupled */
    struct dem_suspension suspension;
    double particles;              /* 1    number */
    double solid_fraction;         /* 1    volume of particles over volume of the domain */
    double flow;                   /* m/s  fluid velocity */
    double slip;                   /* m/s  of particles */
    double reynolds, drag_factor;  /* 1    of that slip; drag over Stokes drag */
    double response;               /* s    relaxation time at that slip */
    double vorticity, stress;      /* 1/s, N/m3 */
    double width;                  /* m    smallest width of the domain */
    double cell;                   /* m    smallest cell of a mesh */
    double mass, radius, modulus;  /* kg, m, Pa  m*, R*, E* */
    double exponent;               /* 1    p of the normal law in use, F ~ d^p; 0 without one */
    double speed, stokes;          /* m/s, 1  impactSpeed of the normal law, and its Stokes number */
    double collision_speed;        /* m/s  relative speed of collisions */
    double collision_time;         /* s    time between them */
    double overlap;                /* 1    largest overlap of an elastic impact at `speed`, over R* */
    double friction;               /* 1    coefficient; 0 without a law */
    double restitution;            /* 1    of the damping law in use: 1 without one, 0 if it has no
                                      such setting */
    int has_restitution;           /* 1: it has that setting */
    int adhesive;                  /* 1: an effect in use holds particles together */
    double weight;                 /* N    of one sphere */
    double yield_speed;            /* m/s  slowest impact that yields, if materials have a
                                      yieldStrength */
};

/* kg/s: drag coefficient of a sphere with the drag law of the scene at a slip [m/s]; 0 without a
   law. */
double dem_drag_coefficient(const struct dem *, const struct dem_suspension *, double void_fraction,
                            double slip);

/* 1: drag of a single sphere over Stokes drag (Schiller and Naumann 1933), of a Reynolds number. */
double dem_single_sphere_drag(double reynolds);

/* the largest Biot number of a scene: dem_biot_number */
struct dem_biot
{
    double number;         /* 1  0: no effect of heat, or no conductivity given */
    const char *material;  /* of the particle */
    const char *other;     /* of its partner in contact; NULL: the fluid */
    double conductivity;   /* W/(m K)  of the particle */
};

/* For particles of this diameter [m] and slip [m/s] in the uniform fluid of the scene. */
void dem_biot_number(const struct dem *, double diameter, double slip, struct dem_biot *);

/* ---- effects --------------------------------------------------------------------------------- */

/* What an effect models. `dem plan` judges in this order; those before REPULSION are judged in a
   fluid only, those after it only where materials have a modulus. */
enum dem_mechanism
{
    DEM_MECHANISM_PRESSURE,
    DEM_MECHANISM_INERTIA,
    DEM_MECHANISM_STRESS,
    DEM_MECHANISM_LIFT,
    DEM_MECHANISM_TORQUE,
    DEM_MECHANISM_FILM,
    DEM_MECHANISM_REPULSION,
    DEM_MECHANISM_ADHESION,
    DEM_MECHANISM_YIELDING,
    DEM_MECHANISM_ROLLING,
    DEM_MECHANISM_TWISTING,
    DEM_MECHANISMS
};

/* range of validity of a drag law */
enum dem_drag
{
    DEM_DRAG_NONE,        /* not a drag law */
    DEM_DRAG_CREEPING,    /* single sphere, Re well below 1 */
    DEM_DRAG_SINGLE,      /* single sphere */
    DEM_DRAG_SUSPENSION,  /* single sphere to suspension */
    DEM_DRAG_PACKED,      /* packed bed */
    DEM_DRAG_BED          /* single sphere to packed bed */
};

/* an effect of the library and its part in a scene: dem_effect_info */
struct dem_effect_info
{
    const char *name, *source;
    enum dem_drag drag;
    enum dem_mechanism mechanism;
    int in_use;            /* 1: the scene has it */
    int excluded;          /* 1: an effect of the scene models the same thing */
    const char *replaces;  /* the effect of the scene whose place it would take; NULL: none */
};

/* Effect k of the library's list, from 0. Returns 0 behind the last. */
int dem_effect_info(const struct dem *, int k, struct dem_effect_info *);

/* whether a scene needs an effect: dem_effect_relevance */
struct dem_relevance
{
    double fraction;              /* 1  fraction of the quantity that is due to the effect */
    double threshold;             /* 1  above it the effect is needed; preset to 0.01 */
    const char *quantity;         /* continues "12 % ...": the quantity, and the source in brackets */
    const char *missing_setting;  /* what the user must give if the effect is not in use; preset to
                                     NULL: nothing */
};

/* Returns 0 if the numbers do not tell, and for a drag law, which is judged by its range. */
int dem_effect_relevance(const struct dem *, int k, const struct dem_regime *,
                         struct dem_relevance *);

/* A line on such a scene in dimensionless numbers of an effect in use. Returns 0 for none. */
int dem_effect_line(const struct dem *, int k, const struct dem_regime *, char *line, size_t size);

/* ---- memory and processor time --------------------------------------------------------------- */

/* what a run takes: dem_run_cost */
struct dem_run_cost
{
    /* s of processor time for one particle of a dense bed: a step without list updates, rebuild of
       the pair list, pruning to candidate contacts; of the slowest rank. step is 0 if such a bed
       fails: its particles move too far or overlap too much in a step */
    double step, rebuild, prune;
    int64_t particles;           /* in the block that was timed */
    double outer, inner;         /* m  movement after which lists are rebuilt and pruned */

    /* bytes as the scene requires */
    double particle, pair, row;  /* of a particle, a listed pair, a candidate contact */
    double pairs, rows;          /* of them, for each particle of a dense bed */
    double bed, copy;            /* of all particles as a dense bed; of its backup (lastGood) */
    double now, max_now;         /* present ones; largest of a rank */
    int64_t listed, candidates;  /* present pairs and candidate contacts */
    int ranks;
};

/* Collective; with particles. Counts bytes, and times steps of a block of spheres with the physics
   of the scene (step/run_cost.c). No particle moves. */
int dem_run_cost(struct dem *, struct dem_run_cost *);

#ifdef __cplusplus
}
#endif
#endif
