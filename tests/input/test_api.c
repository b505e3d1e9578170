/*
 * test_api.c -- wrong calls of the public headers are refused with one sentence, and numbers that
 * do not exist return nothing. Run it with -fsanitize=address,undefined after a change of the
 * calls.
 *
 * Source: the contract in dem.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "dem_numbers.h"
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

/* What the types leave to be refused: a case without a scene, two scenes, changes of a case that
   has been checked. */
static void order(void)
{
    const struct dem_new_particle seed = {.diameter = 1e-3, .material = "glass"};
    struct dem_quiet quiet;
    struct dem_case *c;

    WORLD_TRY(dem_case_create(&c, MPI_COMM_NULL));
    refused(dem_case_set(c, "time/step", "1"), "scene", "dem_case_set before a scene");
    refused(dem_case_check(c), "scene", "dem_case_check before a scene");
    refused(dem_case_read_quiet(c, &quiet), "scene", "dem_case_read_quiet before a scene");
    TAP_OK(!dem_case_checked(c) && !dem_case_dict(c), "before a scene there is nothing to ask");
    WORLD_TRY(dem_case_scene_text(c, materials, "scene"));
    refused(dem_case_scene_text(c, materials, "scene"), "already", "a second scene");
    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    TAP_OK(!dem_case_checked(c), "before dem_case_check there is nothing to ask");
    WORLD_TRY(dem_case_check(c));
    TAP_OK(dem_step_limit(dem_case_checked(c)).used > 0.0, "dem_case_check finds the step");
    refused(dem_case_check(c), "already", "dem_case_check twice");
    refused(dem_case_set(c, "time/step", "1"), "dem_case_check", "dem_case_set after dem_case_check");
    refused(dem_case_add_particles(c, 1, &seed), "dem_case_check", "particles after dem_case_check");
    refused(dem_case_load(c, "x"), "dem_case_check", "dem_case_load after dem_case_check");
    dem_free(world_start(c));

    WORLD_TRY(dem_case_create(&c, MPI_COMM_NULL));
    refused(world_status(c), "scene", "dem_start before a scene");
    c = world_begin("materials { }");
    refused(dem_case_check(c), "material", "a scene without materials");
    TAP_OK(!dem_case_checked(c), "of a scene that was refused there is nothing to ask");
    refused(dem_case_check(c), "start again", "dem_case_check after a scene that was refused");
    refused(dem_case_set(c, "time/step", "1"), "start again", "dem_case_set after it");
    refused(world_status(c), "start again", "dem_start after it");
}

static void advances(void)
{
    const struct dem_new_particle seed = {.diameter = 1e-3, .material = "glass"};
    struct dem *const d = world(materials, 1, &seed);
    double force[3], torque[3];

    refused(dem_advance(d, 0.0), "above 0", "no duration");
    refused(dem_advance(d, -1.0), "above 0", "a duration below 0");
    refused(dem_advance(d, (double)NAN), "above 0", "a duration that is not a number");
    refused(dem_save(d, "/nowhere/at/all/x"), "/nowhere/at/all/x",
            "a snapshot in a missing folder");
    refused(dem_wall_load(d, 0, force, torque), "wall", "the load on a missing wall");
    refused(dem_advance(d, 1e300), "1e+300", "more steps than can be counted");
    TAP_OK(dem_advance(d, 1e-6) == 0, "after all refusals the run works");
    dem_free(d);
}

/* the status of a start with these particles */
static int try_particles(const char *scene, int n, const struct dem_new_particle *seed)
{
    struct dem_case *const c = world_begin(scene);
    const int status = dem_case_add_particles(c, n, seed);

    if (status)
    {
        dem_case_free(c);
        return status;
    }
    return world_status(c);
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
}

/* Automatic ids follow the scene's, in any order of calls. */
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
    dem_free(d);
}

/* A frozen particle under gravity, hit by another. */
static void frozen(void)
{
    const struct dem_new_particle seed[2] = {
        {.position = {0, 0, 0}, .diameter = 2e-3, .id = 0, .material = "glass", .frozen = 1},
        {.position = {0, 0, 3e-3}, .velocity = {0, 0, -1}, .diameter = 2e-3, .id = 1,
         .material = "glass"}};
    struct dem *const d = world(world_text(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } }"
        "effects { hertz {} gravity { acceleration (0 0 -9.81); } mindlin { friction 0.3; } }"),
        2, seed);

    world_run(d, 0.004);
    const struct world_particle p = world_at(d, 0), q = world_at(d, 1);

    TAP_OK(p.x[2] == 0.0 && p.v[2] == 0.0, "a frozen particle does not move");
    /* the fall of 1 mm adds 2 %, which is lost on the way back: the same speed at the same
       height */
    TAP_NEAR(q.v[2]*q.v[2] + 2.0*9.81*q.x[2], 1.0 + 2.0*9.81*3e-3, 5e-3,
             "another rebounds from it as from a wall");
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
        struct dem *const d = world(world_text(
            "%s insert { a { type lattice; diameter 2e-3; spacing 1.25; jitter 1; count 1; seed %d;"
            "min (0 0 0); max (%g %g %g); } } walls { w { type box; min (0 0 0); max (%g %g %g); } "
            "}",
            materials, b, boxes[b][0], boxes[b][1], boxes[b][2], boxes[b][0], boxes[b][1],
            boxes[b][2]), 0, NULL);
        const struct world_particle p = world_at(d, 0);
        int out = 0;

        for (int k = 0; k < 3; k++)
        {
            out += p.x[k] < 1e-3*(1.0 - 1e-12) || p.x[k] > boxes[b][k] - 1e-3*(1.0 - 1e-12);
        }
        TAP_OK(out == 0, "a lattice in a box of %g x %g x %g m stays inside", boxes[b][0],
               boxes[b][1], boxes[b][2]);
        dem_free(d);
    }
}

/* ---- a checked case, and numbers out of range ------------------------------------------------ */

/* The queries of a case that has been checked: there are no particles yet. */
static void checked(void)
{
    const struct dem_new_particle overlap[2] =
        {{.diameter = 1e-3, .id = -1, .material = "glass"},
         {.position = {1e-4, 0, 0}, .diameter = 1e-3, .id = -1, .material = "glass"}};
    struct dem_case *const c = world_begin(materials);
    struct dem_start_overlap start;
    struct dem_view v;

    WORLD_TRY(dem_case_add_particles(c, 2, overlap));
    WORLD_TRY(dem_case_check(c));
    const struct dem *const d = dem_case_checked(c);

    dem_view(d, &v);
    dem_start_overlap(d, &start);
    TAP_OK(v.n == 0 && !v.position && !v.radius && !v.flags && !v.force && start.wall == 0.0
               && dem_fluid_relaxation(d) == 0.0
               && dem_stopped(d) == 0 && dem_ranks_agree(d) && dem_averages_count(d) == 0,
           "a checked case has no particles, no rates");
    TAP_OK(dem_wall_count(d) == 0 && strcmp(dem_effect_names(d), "hertz") == 0
               && strcmp(dem_material_name(d, 0), "glass") == 0 && !dem_has_bonds(d)
               && !dem_needs_fluid(d) && dem_scene_dict(d) == dem_case_dict(c),
           "it has the names of its effects and materials");
    refused(world_status(c), "overlap", "two particles at one place");
}

static int no_wall(const struct dem *d, int wall)
{
    struct dem_wall_info w = {.triangles = 7, .moves = 1};

    dem_wall_info(d, wall, &w);
    return dem_wall_name(d, wall)[0] == '\0' && w.triangles == 0 && w.moves == 0;
}

static int no_scalar(struct dem *d, int k)
{
    struct dem_scalar_info s = {.written = 1};

    dem_scalar_info(d, k, &s);
    return s.name[0] == '\0' && s.unit[0] == '\0' && s.help[0] == '\0' && s.written == 0
        && !dem_scalar(d, k);
}

static void ranges(void)
{
    static const char scene[] =
        "materials { glass { density 2500; youngsModulus 1e7; conductivity 1; heatCapacity 800; } }"
        "effects { hertz {} conduction {} }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }";
    const struct dem_new_particle one =
        {.position = {0, 0, 1}, .diameter = 1e-3, .id = -1, .material = "glass"};
    static const int numbers[] = {-1, 1, 99, INT32_MAX, INT32_MIN};
    struct dem *const d = world(scene, 1, &one);
    struct dem_scalar_exchange x;
    struct dem_effect_info effect;
    double force[3], torque[3], total, coefficient;
    int walls = 0, scalars = 0, names = 0, loads = 0;

    WORLD_TRY(dem_wall_impulse_reset(d));
    for (size_t k = 0; k < sizeof numbers/sizeof *numbers; k++)
    {
        const int n = numbers[k];

        walls += no_wall(d, n);
        scalars += no_scalar(d, n) && dem_scalar_exchange(d, n, &x) && dem_scalar_total(d, n, &total);
        names += dem_material_name(d, n)[0] == '\0' && (n == 1 || n == 99 || !dem_effect_info(d, n, &effect));
        loads += dem_wall_load(d, n, force, torque) == DEM_ERROR_INPUT
              && dem_wall_impulse(d, n, force, torque) == DEM_ERROR_INPUT
              && dem_wall_corners(d, n, force) == DEM_ERROR_INPUT;
    }
    TAP_OK(walls == 5, "a number that no wall has: no name, zeros");
    TAP_OK(loads == 5, "load, impulse and corners of such a wall are refused");
    TAP_OK(scalars == 5, "a number that no scalar has: no name, no values, no total");
    TAP_OK(names == 5, "a number that no material or effect has: no name");
    TAP_OK(strcmp(dem_wall_name(d, 0), "floor") == 0 && dem_scalar(d, 0)
               && dem_scalar_index(d, "temperature") == 0 && dem_scalar_index(d, "") == -1,
           "the first of each is there");
    TAP_OK(strcmp(dem_signal_name(SIGINT), "SIGINT") == 0 && dem_signal_name(0)[0] == '\0'
               && strcmp(dem_broken_bond_cause(-1), "unknown") == 0
               && dem_scene_name(dem_scene_dict(d), "", -1) == NULL && dem_effect_traits("") == 0,
           "signals, causes, entries and traits that do not exist");
    refused(dem_fluid_reaction(d, 1.0, &coefficient, force), "fluid",
            "the reaction on a fluid that is not there");
    dem_free(d);
}

static void counts(void)
{
    const struct dem_new_particle seed = {.diameter = 1e-3, .material = "glass"};
    const double triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, velocity[3] = {0, 0, 0};
    const struct dem_run_info run = {.duration = 1.0};
    const int64_t id = 0;
    struct dem_case *c = world_begin(materials);
    const char *text;

    refused(dem_case_add_wall(c, "w", "glass", -1, triangle), "dem_case_add_wall: -1 triangles",
            "a wall of -1 triangles");
    refused(dem_case_add_wall(c, "w", "glass", INT64_MAX, triangle), "more than memory",
            "a wall of very many triangles");
    refused(dem_case_add_region(c, "r", 0, -1, triangle), "-1 triangles", "a region of -1 triangles");
    refused(dem_case_add_patch(c, "p", -1, triangle, velocity), "-1 triangles", "a patch of -1 triangles");
    refused(dem_case_add_patch(c, "p", INT64_MIN, triangle, velocity), "triangles",
            "a patch of fewest triangles");
    refused(dem_case_add_particles(c, -1, &seed), "-1 particles", "-1 particles");
    refused(dem_case_add_particles(c, INT64_MAX, &seed), "more than memory", "very many particles");
    WORLD_TRY(dem_case_add_wall(c, "w", "glass", 1, triangle));
    refused(dem_case_move_wall(c, "w", -1, triangle), "-1", "a wall that moves with -1 triangles");
    dem_case_free(c);
    c = world_begin("materials { glass { density 2500; youngsModulus 1e7; } } effects { hertz {} } "
                    "outlets { o { patch p; } } time { step 1e-6; }");
    WORLD_TRY(dem_case_flows_on_request(c));
    struct dem *const d = world_start(c);

    refused(dem_flow_patch(d, "p", 1, triangle, velocity), "no patch p", "a patch that was not added");
    refused(dem_flow_remove(d, "p", -1, &id), "-1 ids", "-1 particles that leave");
    refused(dem_warnings(d, &run, -1, NULL, &text), "-1 sentences", "-1 sentences of the program");
    dem_free(d);
}

static void tables(void)
{
    struct dem *const d = world("materials { glass { density 2500; youngsModulus 1e7; } } "
                                "effects { hertz {} } time { step 1e-6; }", 0, NULL);
    struct dem_table t;
    char folder[700];

    memset(folder, 'x', sizeof folder - 1);
    folder[sizeof folder - 1] = '\0';
    dem_table_name(&t, folder, "lost.csv", 0.0);
    refused(dem_table_begin(&t, d, 0), "longer than", "a table in a folder with a path that is too long");
    refused(dem_table_append(&t, d, "a", "1\n"), "longer than", "its rows");
    dem_table_name(&t, "/nowhere/at/all", "lost.csv", 0.0);
    TAP_OK(dem_table_add_losses(&t, d, 0, NULL, 0.0, NULL) == 0
               && dem_table_add_bonds(&t, d, -1, NULL, 0.0) == 0,
           "a table without rows is not made");
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    order();
    advances();
    checked();
    ranges();
    counts();
    tables();
    particles();
    ids();
    frozen();
    lattices();
    TAP_DONE;
}
