/*
 * test_fused.c -- fused kernels give the same bits as the loops of their effects.
 *
 * - Each kernel of laws/fused, in a scene of two materials and sizes that meet
 *   each other and walls of both: particles, forces and history have the same bits with the
 *   kernel and without it.
 * - So do the first laws of a longer list: bonds, cohesion and twisting come after them.
 *
 *     mpirun -np N test_fused ranks    the same on N ranks
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "case/simulation.h"
#include "core/random.h"
#include "laws/fused/fused.h"

enum
{
    SIDE = 6, BEADS = SIDE*SIDE*SIDE, STEPS = 400
};

static MPI_Comm comm = MPI_COMM_NULL;
static int rank;

/* name { settings of its example } */
static void append_law(char *text, const struct dem_effect *law)
{
    if (law != &dem_none)
    {
        sprintf(text + strlen(text), "%s { %s } ", law->name, law->example ? law->example : "");
    }
}

static void laws_of(const struct dem_fused_kernel *kernel, char *text)
{
    text[0] = '\0';
    for (int k = 0; k < DEM_FUSED_LAWS; k++)
    {
        append_law(text, kernel->law[k]);
    }
}

/* beads on a lattice that nearly touch, thrown at each other and at the walls */
static void add_beads(struct dem_case *c)
{
    struct dem_new_particle seed[BEADS];

    for (int k = 0; k < BEADS; k++)
    {
        const double at[3] = {k%SIDE, k/SIDE%SIDE, k/SIDE/SIDE};

        seed[k] = (struct dem_new_particle){
            .diameter = k%3 ? 1e-3 : 0.8e-3, .material = k%2 ? "glass" : "steel", .id = k*7%BEADS};
        for (int m = 0; m < 3; m++)
        {
            seed[k].position[m] = 0.55e-3 + 1.01e-3*at[m];
            seed[k].velocity[m] = 2.0*dem_random_unit(5, (uint64_t)k, (uint64_t)m, 0) - 1.0;
            seed[k].spin[m] = 500.0*(2.0*dem_random_unit(5, (uint64_t)k, (uint64_t)m, 1) - 1.0);
        }
    }
    WORLD_TRY(dem_case_add_particles(c, BEADS, seed));
}

static struct dem *scene(const char *laws)
{
    char *const text = world_text(
        "materials { glass { density 2500; youngsModulus 5e6; poissonsRatio 0.25; } "
        "steel { density 5000; youngsModulus 8e6; poissonsRatio 0.3; } } "
        "effects { %s gravity { acceleration (0 0 -9.81); } } fluid { density 1; viscosity 1e-3; } "
        "domain { x (0 0.0062); periodic (x); } "
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); material steel; } "
        "back { type plane; point (0 0 0); normal (0 1 0); material glass; } "
        "front { type plane; point (0 0.0062 0); normal (0 -1 0); material glass; } } "
        "time { step 2e-6; force yes; }",
        laws);
    struct dem_case *c;
    struct dem *d;

    WORLD_TRY(dem_case_create(&c, comm));
    WORLD_TRY(dem_case_scene_text(c, text, "scene"));
    add_beads(c);
    WORLD_TRY(dem_start(&c, &d));
    return d;
}

/* Number of classes that take this kernel; with `off` they take the loops of the effects. */
static int classes_with(struct dem *d, const struct dem_fused_kernel *kernel, int off)
{
    struct dem_interaction_table *const table = &d->state.interaction_table;
    int with = 0;

    for (int c = 0; c < table->classes; c++)
    {
        with += table->list[c].kernel == kernel;
        table->list[c].kernel = off ? NULL : table->list[c].kernel;
    }
    return with;
}

/* bits of the own particles' forces, of this rank */
static uint64_t force_bits(const struct dem *d)
{
    struct dem_view v;
    uint64_t hash = 0;

    dem_view(d, &v);
    for (size_t k = 0; k < 3*v.n; k++)
    {
        hash = hash*UINT64_C(1099511628211) + dem_math_bits(v.force[k])
               + 3*dem_math_bits(v.torque[k]);
    }
    return hash;
}

/* kernel: which all classes must have; NULL: any */
static void compare(const char *laws, const struct dem_fused_kernel *kernel)
{
    struct dem *const fused = scene(laws), *const apart = scene(laws);
    const struct dem_interaction_table *const table = &fused->state.interaction_table;
    const int classes = classes_with(fused, kernel ? kernel : table->list[0].kernel, 0);

    classes_with(apart, kernel, 1);
    world_run(fused, STEPS*2e-6);
    world_run(apart, STEPS*2e-6);

    const int64_t contacts = world_tally(fused).contacts;
    const uint64_t ours = world_hash(fused), theirs = world_hash(apart);

    if (rank == 0)
    {
        TAP_OK(classes == table->classes && table->list[0].kernel && contacts > BEADS/4,
               "%s: %d classes, %lld contacts", laws, classes, (long long)contacts);
        TAP_OK(ours == theirs && force_bits(fused) == force_bits(apart), "the same bits");
    }
    dem_free(fused);
    dem_free(apart);
}

int main(int arguments, char **argument)
{
    char laws[512];

    if (arguments > 1 && strcmp(argument[1], "ranks") == 0)
    {
        MPI_Init(&arguments, &argument);
        comm = MPI_COMM_WORLD;
        MPI_Comm_rank(comm, &rank);
    }
    else
    {
        TAP_TRAPS;
    }
    for (const struct dem_fused_kernel *const *table = dem_fused_kernels; *table; table++)
    {
        for (const struct dem_fused_kernel *kernel = *table; kernel->apply; kernel++)
        {
            laws_of(kernel, laws);
            compare(laws, kernel);
        }
    }
    compare("hooke { stiffness 500; } linear { friction 0.3; } bondLinear { normalStiffness 1e9; "
            "shearStiffness 1e9; makeDistance 1.02; normalStrength 2e4; walls yes; }", NULL);
    compare("hertz { } dry { restitution 0.8; } mindlin { friction 0.3; } rollingSpring { friction 0.1; } "
            "twistingSpring { friction 0.1; } sjkr { energyDensity 1e3; }", NULL);
    if (comm != MPI_COMM_NULL)
    {
        MPI_Finalize();
    }
    return rank == 0 ? tap_done() : 0;
}
