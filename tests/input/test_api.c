/*
 * test_api.c -- wrong calls of dem.h.
 *
 * - Calls in the wrong order and impossible particles are refused with one sentence; a scene that
 *   was refused stays refused.
 * - Particles of the caller and of the scene never share an id.
 * - A frozen particle does not move under any force.
 * - Lattices stay in their box.
 *
 * Source: the contract in dem.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

static const char materials[] =
    "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } "
    "effects { hertz {} }";

static void refused(int status, const char *word, const char *what)
{
    TAP_OK(status != 0 && strstr(dem_error_text(), word), "%s: refused, names \"%s\"", what, word);
    if (!status || !strstr(dem_error_text(), word))
    {
        TAP_NOTE("status %d: %s", status, dem_error_text());
    }
}

static void order(void)
{
    const struct dem_new_particle seed = {.diameter = 1e-3, .material = "glass"};
    struct dem *d;

    WORLD_TRY(dem_create(&d, MPI_COMM_NULL));
    refused(dem_set(d, "time/step", "1"), "scene", "dem_set before a scene");
    refused(dem_setup(d), "scene", "dem_setup before a scene");
    refused(dem_check(d), "scene", "dem_check before a scene");
    refused(dem_advance(d, 1.0), "dem_setup", "dem_advance before dem_setup");
    refused(dem_save(d, "/nowhere/x"), "dem_setup", "dem_save before dem_setup");
    WORLD_TRY(dem_scene_text(d, materials, "scene"));
    refused(dem_scene_text(d, materials, "scene"), "already", "a second scene");
    WORLD_TRY(dem_add_particles(d, 1, &seed));
    WORLD_TRY(dem_check(d));
    TAP_OK(dem_step_limit(d).used > 0.0, "dem_check returns the step");
    refused(dem_check(d), "dem_check", "dem_check twice");
    refused(dem_set(d, "time/step", "1"), "dem_check", "dem_set after dem_check");
    WORLD_TRY(dem_setup(d));
    refused(dem_setup(d), "dem_setup", "dem_setup twice");
    refused(dem_add_particles(d, 1, &seed), "dem_setup", "particles after dem_setup");
    refused(dem_set(d, "time/step", "1"), "dem_setup", "dem_set after dem_setup");
    refused(dem_load(d, "x"), "dem_setup", "dem_load after dem_setup");
    refused(dem_advance(d, 0.0), "above 0", "no duration");
    refused(dem_advance(d, -1.0), "above 0", "a duration below 0");
    refused(dem_advance(d, (double)NAN), "above 0", "a duration that is not a number");
    refused(dem_save(d, "/nowhere/at/all/x"), "/nowhere/at/all/x",
            "a snapshot in a missing folder");
    double force[3], torque[3];

    refused(dem_wall_load(d, 0, force, torque), "wall", "the load on a missing wall");
    refused(dem_advance(d, 1e300), "1e+300", "more steps than can be counted");
    TAP_OK(dem_advance(d, 1e-6) == 0, "after all refusals the run works");
    dem_free(d);
    d = world_begin("materials { }");
    refused(dem_check(d), "material", "a scene without materials");
    refused(dem_setup(d), "start again", "dem_setup after a scene that was refused");
    refused(dem_check(d), "start again", "dem_check after a scene that was refused");
    dem_free(d);
}

/* dem_setup with these particles */
static int try_particles(const char *scene, int n, const struct dem_new_particle *seed)
{
    struct dem *d = world_begin(scene);
    int status = dem_add_particles(d, n, seed);

    status = status ? status : dem_setup(d);
    dem_free(d);
    return status;
}

static void particles(void)
{
    const struct dem_new_particle good = {.diameter = 1e-3, .material = "glass"};
    struct dem_new_particle seed[2] = {good, good};

    seed[1].position[0] = 1.0;
    refused(try_particles(materials, 2, seed), "id 0", "one id for two particles");
    seed[1].id = 1;
    TAP_OK(try_particles(materials, 2, seed) == 0, "different ids are accepted");
    seed[1].material = "glas";
    refused(try_particles(materials, 2, seed), "glass", "an unknown material");
    seed[1] = good;
    seed[1].id = 1;
    seed[1].diameter = 0.0;
    refused(try_particles(materials, 2, seed), "diameter", "a diameter of 0");
    seed[1].diameter = (double)NAN;
    refused(try_particles(materials, 2, seed), "diameter", "a diameter that is not a number");
    seed[1].diameter = 1e-3;
    seed[1].velocity[2] = (double)INFINITY;
    refused(try_particles(materials, 2, seed), "not a number", "an infinite velocity");
    seed[1] = good;
    seed[1].id = 1;
    refused(try_particles(materials, 2, seed), "overlap", "two at one position");
    seed[1].position[0] = 1.0;
    seed[1].frozen = 1;
    seed[1].velocity[0] = 1.0;
    refused(try_particles(materials, 2, seed), "frozen", "a frozen particle with a velocity");
    seed[1].velocity[0] = 0.0;
    seed[1].position[0] = 1e300;
    char *const periodic =
        world_text("%s domain { min (0 0 0); max (1 1 1); periodic (x y z); }", materials);

    refused(try_particles(periodic, 2, seed), "particle 1",
            "a position very many periodic boxes away");
    free(periodic);
}

/* Automatic ids follow those of the scene, in any order of calls. */
static void ids(void)
{
    const struct dem_new_particle seed[2] =
        {{.position = {1, 0, 0}, .diameter = 1e-3, .id = -1, .material = "glass"},
         {.position = {2, 0, 0}, .diameter = 1e-3, .id = -1, .material = "glass"}};
    char *const scene = world_text(
        "%s insert { a { type list; diameter 1e-3; positions ((0 0 0) (0 1 0) (0 2 0)); }"
        "b { type list; diameter 1e-3; positions ((0 0 1)); } }",
        materials);
    struct dem *const d = world(scene, 2, seed);
    struct dem_view v;
    int seen[6] = {0}, wrong = 0;

    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        const int64_t id = world_id(&v, k);

        wrong += id < 0 || id > 5 || seen[id]++;
    }
    TAP_OK(v.n == 6 && wrong == 0, "scene and program together: ids 0 to 5, each once");
    free(scene);
    dem_free(d);
}

/* A frozen particle under gravity, hit by another. */
static void frozen(void)
{
    const struct dem_new_particle seed[2] =
        {{.position = {0, 0, 0}, .diameter = 2e-3, .id = 0, .material = "glass", .frozen = 1},
         {.position = {0, 0, 3e-3},
          .velocity = {0, 0, -1},
          .diameter = 2e-3,
          .id = 1,
          .material = "glass"}};
    char *const scene = world_text(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } }"
        "effects { hertz {} gravity { acceleration (0 0 -9.81); } mindlin { friction 0.3; } }");
    struct dem *const d = world(scene, 2, seed);

    world_run(d, 0.004);
    const struct world_particle p = world_at(d, 0), q = world_at(d, 1);

    TAP_OK(p.x[2] == 0.0 && p.v[2] == 0.0, "a frozen particle does not move");
    /* the fall of 1 mm adds 2 %, which is lost on the way back: the same speed at the same
       height */
    TAP_NEAR(q.v[2]*q.v[2] + 2.0*9.81*q.x[2], 1.0 + 2.0*9.81*3e-3, 5e-3,
             "another rebounds from it as from a wall");
    free(scene);
    dem_free(d);
}

static void lattices(void)
{
    static const double boxes[][3] = {{0.01, 0.01, 0.01},
                                      {0.01, 0.01, 0.00205},
                                      {0.0021, 0.01, 0.01},
                                      {0.002, 0.002, 0.002}};

    for (int b = 0; b < 4; b++)
    {
        char *const scene = world_text(
            "%s insert { a { type lattice; diameter 2e-3; spacing 1.25; jitter 1; count 1; seed %d;"
            "min (0 0 0); max (%g %g %g); } } walls { w { type box; min (0 0 0); max (%g %g %g); } "
            "}",
            materials, b, boxes[b][0], boxes[b][1], boxes[b][2], boxes[b][0], boxes[b][1],
            boxes[b][2]);
        struct dem *const d = world(scene, 0, NULL);
        const struct world_particle p = world_at(d, 0);
        int out = 0;

        for (int k = 0; k < 3; k++)
        {
            out += p.x[k] < 1e-3*(1.0 - 1e-12) || p.x[k] > boxes[b][k] - 1e-3*(1.0 - 1e-12);
        }
        TAP_OK(out == 0, "a lattice in a box of %g x %g x %g m stays inside", boxes[b][0],
               boxes[b][1], boxes[b][2]);
        free(scene);
        dem_free(d);
    }
}

int main(void)
{
    TAP_TRAPS;
    order();
    particles();
    ids();
    frozen();
    lattices();
    TAP_DONE;
}
