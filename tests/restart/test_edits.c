/*
 * test_edits.c -- a snapshot continues with an edited scene: new groups are inserted once, walls
 * go on from where they stood, contacts keep their history, and every difference is a sentence of
 * dem_warnings.
 *
 * Source: kinematics of rigid motion; the contract of dem_case_load in dem.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"
#include <unistd.h>

static const char base[] =
    "materials { glass { density 2500; youngsModulus 1e7; } steel { density 7800; youngsModulus 1e7; } }"
    "effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.4; } "
    "mindlin { friction 0.3; } }"
    "walls { box { type box; material steel; min (0 0 0); max (0.01 0.01 0.04); } }"
    "insert { a { type random; material glass; count 100; diameter 1e-3; min (0 0 0); "
    "max (0.01 0.01 0.006); } } ";

static char file[] = "/tmp/edits.XXXXXX";

static struct dem *start(const char *scene)
{
    return world(scene, 0, NULL);
}

/* Continue with `scene`, edited by n pairs of path and value. */
static int load(struct dem **d, const char *scene, int n, const char *const (*set)[2])
{
    struct dem_case *c = world_begin(scene);

    for (int k = 0; k < n; k++)
    {
        WORLD_TRY(dem_case_set(c, set[k][0], set[k][1]));
    }
    WORLD_TRY(dem_case_load(c, file));
    return dem_start(&c, d);
}

static struct dem *resume(const char *scene, int n, const char *const (*set)[2])
{
    struct dem *d;

    if (load(&d, scene, n, set))
    {
        world_end("dem_start");
    }
    return d;
}

static const char *warnings(struct dem *d)
{
    const struct dem_run_info ahead = {.duration = 1e-3};
    const char *text;

    WORLD_TRY(dem_warnings(d, &ahead, 0, NULL, &text));
    return text;
}

static int lines_of_restart(struct dem *d)
{
    int n = 0;

    for (const char *at = warnings(d); (at = strstr(at, "restart: ")); at++)
    {
        n++;
    }
    return n;
}

static int says(struct dem *d, const char *words)
{
    const int found = strstr(warnings(d), words) != NULL;

    if (!found)
    {
        printf("# no \"%s\" in\n# %s\n", words, warnings(d));
    }
    return found;
}

/* ---- groups ---------------------------------------------------------------------------------- */

/* Largest overlap of two particles, of their diameter, and the number of different ids. */
static double largest_overlap(const struct dem *d)
{
    struct dem_view v;
    double worst = -1.0;

    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        for (size_t k = 0; k < i; k++)
        {
            const struct world_particle p = world_take(&v, i), q = world_take(&v, k);
            const double r[3] = {p.x[0] - q.x[0], p.x[1] - q.x[1], p.x[2] - q.x[2]};
            const double gap = sqrt(r[0]*r[0] + r[1]*r[1] + r[2]*r[2]) - p.radius - q.radius;

            worst = fmax(worst, -0.5*gap/p.radius);
        }
    }
    return worst;
}

static int64_t largest_id(const struct dem *d)
{
    struct dem_view v;
    int64_t largest = -1;

    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        largest = world_id(&v, k) > largest ? world_id(&v, k) : largest;
    }
    return largest;
}

static void groups(void)
{
    static const char *const more[][2] = {
        {"insert/top", "{ type random; material steel; count 150; diameter 1e-3; min (0 0 0); "
                       "max (0.01 0.01 0.012); velocity (0 0 -0.1); }"},
        {"insert/one", "{ type list; material glass; diameter 1e-3; positions ((5e-3 5e-3 0.03)); }"},
        {"insert/rows", "{ type lattice; material glass; count 9; diameter 1e-3; min (0 0 0.02); "
                        "max (0.01 0.01 0.025); }"},
        {"insert/a/count", "101"}};
    struct dem *d = start(base);

    world_run(d, 0.02);
    WORLD_TRY(dem_save(d, file));
    dem_free(d);

    d = resume(base, 0, NULL);
    TAP_OK(lines_of_restart(d) == 0 && world_tally(d).particles == 100,
           "an unchanged scene: no sentence, no particle more");
    dem_free(d);

    d = resume(base, 4, more);
    TAP_OK(world_tally(d).particles == 260, "three new groups of 150, 1 and 9 particles");
    /* 0.01: what contacts of the settling bed have; new particles touch nothing */
    TAP_OK(largest_overlap(d) < 0.01, "they overlap with nothing");
    TAP_OK(largest_id(d) == 259, "ids go on behind the snapshot's");
    TAP_NEAR(world_tally(d).time, 0.02, 1e-12, "time goes on");
    TAP_OK(says(d, "insert/top is new: its 150 particles are inserted now") &&
               says(d, "insert/one is new: its 1 particles") &&
               says(d, "insert/rows is new: its 9 particles"), "each has its sentence");
    TAP_OK(says(d, "insert/a/count was 100, now 101: not applied") && lines_of_restart(d) == 4,
           "a group of the snapshot that was edited: not applied, and told");
    TAP_NEAR(world_at(d, 100).v[2], -0.1, 0.0, "velocity of a new particle");
    world_run(d, 0.01);
    WORLD_TRY(dem_save(d, file));
    const uint64_t half = world_hash(d);

    world_run(d, 0.005);
    const uint64_t whole = world_hash(d);

    dem_free(d);
    d = resume(base, 4, more);
    TAP_OK(world_hash(d) == half && lines_of_restart(d) == 0, "they are not inserted again");
    world_run(d, 0.005);
    TAP_OK(world_hash(d) == whole, "and the run goes on with the same bits");
    dem_free(d);
    d = resume(base, 0, NULL);
    TAP_OK(world_tally(d).particles == 260 && says(d, "insert/top is gone: its particles stay"),
           "a group that the scene leaves out: its particles stay");
    world_run(d, 1e-4);
    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    d = resume(base, 3, more);
    TAP_OK(world_tally(d).particles == 260 && says(d, "insert/top is back in the scene"),
           "nor is one inserted that was left out for a while");
    dem_free(d);
}

static void refused_groups(void)
{
    static const char *const over[][2] = {
        {"insert/b", "{ type list; material glass; diameter 1e-3; positions ((5e-3 5e-3 2e-4)); }"}};
    static const char *const twice[][2] = {
        {"insert/b", "{ type list; material glass; diameter 1e-3; positions ((5e-3 5e-3 0.03)); "
                     "ids (1000); }"}};
    const struct dem_new_particle one = {
        .id = 1000, .position = {5e-3, 5e-3, 0.035}, .diameter = 1e-3, .material = "glass"};
    struct dem *d = world(base, 1, &one);

    world_run(d, 1e-3);
    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    TAP_OK(load(&d, base, 1, over) != 0 && strstr(dem_error_text(), "overlap"),
           "a new particle inside a wall: %s", dem_error_text());
    dem_free(d);
    TAP_OK(load(&d, base, 1, twice) != 0 && strstr(dem_error_text(), "id 1000, which a particle of"),
           "an id that the snapshot has: %s", dem_error_text());
    dem_free(d);
    struct dem_case *c = world_begin(base);
    WORLD_TRY(dem_case_add_particles(c, 1, &one));
    WORLD_TRY(dem_case_load(c, file));
    d = world_start(c);
    TAP_OK(world_tally(d).particles == 101 && lines_of_restart(d) == 0,
           "particles of the program come from the snapshot");
    dem_free(d);
    d = start(base);
    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    c = world_begin(base);
    WORLD_TRY(dem_case_add_particles(c, 1, &one));
    WORLD_TRY(dem_case_load(c, file));
    d = world_start(c);
    TAP_OK(world_tally(d).particles == 101 && says(d, "dem_case_add_particles is new"),
           "particles that the program has not added before are inserted");
    dem_free(d);
}

/* ---- walls ----------------------------------------------------------------------------------- */

/* A plate of two triangles, far from the ball that makes a run of it. */
static const char plate[] =
    "materials { glass { density 2500; youngsModulus 1e6; } } effects { hertz {} }"
    "walls { other { type plane; point (0 0 -2); normal (0 0 1); }"
    " p { type triangles; corners ((0 0 0) (1 0 0) (0 1 0) (1 0 0) (1 1 0) (0 1 0)); %s } }"
    "insert { ball { type list; diameter 1e-2; positions ((0 0 3)); } } time { step 1e-3; force yes; }";

/* The corner that was at (1 1 0). */
static void corner(struct dem *d, double x[3])
{
    double all[18];
    int k = 0;

    while (strcmp(dem_wall_name(d, k), "p") != 0)
    {
        k++;
    }
    WORLD_TRY(dem_wall_corners(d, k, all));
    /* the triangle with (1 1 0) has no corner at the origin; its index is the one in the sorted list */
    memcpy(x, all + 12, 3*sizeof *x);
}

static double distance(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0])*(a[0] - b[0]) + (a[1] - b[1])*(a[1] - b[1]) + (a[2] - b[2])*(a[2] - b[2]));
}

/* From the motion `was` to `now` at 1 s: no jump there, then the displacement in 0.5 s. */
static void edited_motion(const char *what, const char *was, const char *now, const double moved[3])
{
    char *const first = world_text(plate, was), *const second = world_text(plate, now);
    struct dem *d = start(first);
    double stood[3], at[3], later[3], expected[3];

    world_run(d, 1.0);
    corner(d, stood);
    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    d = resume(second, 0, NULL);
    corner(d, at);
    /* 1e-14: round-off of a pose, of lengths of 1 m */
    TAP_NEAR(distance(stood, at), 0.0, 1e-14, "%s: the wall stands where it stood", what);
    world_run(d, 0.5);
    corner(d, later);
    for (int k = 0; k < 3; k++)
    {
        expected[k] = stood[k] + moved[k];
    }
    if (!isnan(moved[0]))
    {
        TAP_NEAR(distance(later, expected), 0.0, 1e-13, "%s: then it moves as the scene says", what);
    }
    TAP_OK(says(d, "the wall ") && strstr(warnings(d), "where it stood"), "%s: it is told", what);
    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    d = resume(second, 0, NULL);
    corner(d, at);
    TAP_OK(memcmp(at, later, sizeof at) == 0 && lines_of_restart(d) == 0,
           "%s: continued once more, the same bits and no sentence", what);
    dem_free(d);
}

static void motions(void)
{
    const double slow[3] = {0.0, 0.0, 0.01}, still[3] = {0.0, 0.0, 0.0};
    /* amplitude 0.1, 1 Hz: from sin(2 pi) to sin(3 pi) */
    const double swings[3] = {0.0, 0.0, 0.0};
    const double unknown[3] = {(double)NAN, 0.0, 0.0};

    edited_motion("slower", "motion { type translation; velocity (0 0 0.1); }",
                  "motion { type translation; velocity (0 0 0.02); }", slow);
    edited_motion("stopped", "motion { type translation; velocity (0 0 0.1); }", "", still);
    edited_motion("begun", "", "motion { type translation; velocity (0 0 0.02); }", slow);
    edited_motion("oscillating", "motion { type translation; velocity (0 0 0.1); }",
                  "motion { type oscillation; amplitude (0 0 0.1); frequency 1; }", swings);
    edited_motion("turning", "motion { type translation; velocity (0 0 0.1); }",
                  "motion { type rotation; origin (0 0 0); axis (0 0 1); omega 2; }", unknown);
    edited_motion("turning the other way", "motion { type rotation; origin (0 0 0); axis (1 2 3); omega 2; }",
                  "motion { type rotation; origin (0.5 0 0); axis (0 1 1); omega -3; }", unknown);
    edited_motion("turned, then lifted", "motion { type rotation; origin (0 0 0); axis (1 2 3); omega 2; }",
                  "motion { type translation; velocity (0 0 0.02); }", slow);
    edited_motion("with an end", "motion { type translation; velocity (0 0 0.1); }",
                  "motion { type translation; velocity (0 0 0.1); end 1; }", still);
}

/* A corner on its way about an axis that begins at the restart: at the angle omega t from there. */
static void rotation_by_angle(void)
{
    char *const first = world_text(plate, "motion { type translation; velocity (0 0 0.1); }");
    char *const second =
        world_text(plate, "motion { type rotation; origin (0 0 0); axis (0 0 1); omega 2; }");
    struct dem *d = start(first);
    double at[3];

    world_run(d, 1.0);
    corner(d, at);
    const double angle = atan2(at[1], at[0]), far = hypot(at[0], at[1]);

    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    d = resume(second, 0, NULL);
    world_run(d, 0.25);
    corner(d, at);
    TAP_NEAR(at[0], far*cos(angle + 0.5), 1e-13, "turned by omega t from where it stood: x");
    TAP_NEAR(at[1], far*sin(angle + 0.5), 1e-13, "turned by omega t from where it stood: y");
    TAP_NEAR(at[2], 0.1, 1e-13, "at the height that it had");
    dem_free(d);
}

/* A ball that rolls down a slope, driven by the spring of its friction. */
static void history(void)
{
    static const char slope[] =
        "materials { glass { density 2500; youngsModulus 1e7; } }"
        "effects { gravity { acceleration (3 0 -9); } hertz {} dry { restitution 0.3; } "
        "mindlin { friction 0.6; } }"
        "walls { %s floor { type plane; point (0 0 0); normal (0 0 1); } }"
        "insert { ball { type list; diameter 2e-3; positions ((0 0 1e-3)); } } ";
    static const char *const other[][2] = {{"walls/floor/point", "(0 0 -1e-6)"}};
    static const char *const moved[][2] = {{"walls/floor/point", "(0 0 5e-4)"}};
    static const char *const lid[][2] = {{"walls/lid", "{ type plane; point (0 0 1e-3); normal (0 0 -1); }"}};
    char *const before = world_text(slope, "");
    char *const added = world_text(slope, "lid { type plane; point (0 0 1); normal (0 0 -1); } "
                                   "side { type triangles; corners ((9 9 9) (9 8 9) (9 9 8)); }");
    struct dem *d = start(before);

    world_run(d, 0.05);
    WORLD_TRY(dem_save(d, file));
    world_run(d, 0.01);
    const uint64_t whole = world_hash(d);
    const struct world_particle stays = world_at(d, 0);

    dem_free(d);
    d = resume(added, 0, NULL);
    TAP_OK(says(d, "walls/lid is new") && says(d, "walls/side is new"), "walls are added");
    world_run(d, 0.01);
    const struct world_particle now = world_at(d, 0);

    TAP_OK(memcmp(now.x, stays.x, sizeof now.x) == 0 && memcmp(now.f, stays.f, sizeof now.f) == 0,
           "contacts keep their history when walls are added before theirs");
    dem_free(d);
    d = resume(before, 0, NULL);
    world_run(d, 0.01);
    TAP_OK(world_hash(d) == whole, "without an edit, the same bits");
    dem_free(d);
    d = resume(before, 1, other);
    TAP_OK(says(d, "walls/floor/point was (0 0 0), now (0 0 -1e-6): the wall begins anew"),
           "a wall that is moved by hand begins anew");
    dem_free(d);
    TAP_OK(load(&d, before, 1, moved) != 0 && strstr(dem_error_text(), "wall floor is new in the scene of the restart, or "),
           "moved into the ball it is refused: %s", dem_error_text());
    TAP_OK(load(&d, before, 1, lid) != 0 && strstr(dem_error_text(), "wall lid is new"), "so is a new one: %s",
           dem_error_text());
}

/* A soft ball sinks into its floor by more than a new wall may be in it. */
static void wall_in_soft_bed(void)
{
    static const char soft[] =
        "materials { gel { density 2500; youngsModulus 1.5e3; } }"
        "effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.3; } }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }"
        "insert { ball { type list; diameter 2e-3; positions ((0 0 1e-3)); } } ";
    static const char *const in[][2] = {{"walls/side", "{ type plane; point (8.4e-4 0 0); normal (-1 0 0); }"}};
    static const char *const beside[][2] = {{"walls/side", "{ type plane; point (9.4e-4 0 0); normal (-1 0 0); }"}};
    struct dem *d = start(soft);

    world_run(d, 0.1);
    WORLD_TRY(dem_save(d, file));
    const double sunk = 0.5 - world_at(d, 0).x[2]/2e-3;

    dem_free(d);
    TAP_OK(sunk > 0.09, "a soft ball has sunk into its floor by %.3f diameters", sunk);
    TAP_OK(load(&d, soft, 1, in) != 0 && strstr(dem_error_text(), "wall side is new in the scene of the restart, or "),
           "a new wall in it by 0.08 is refused: %s", dem_error_text());
    d = resume(soft, 1, beside);
    TAP_OK(says(d, "walls/side is new"), "one in it by 0.03 is not");
    dem_free(d);
}

/* A stretched bond between two spheres that turn round each other breaks at once at a lower strength. */
static void broken_bond(void)
{
    static const char pair[] =
        "materials { glass { density 2500; youngsModulus 1e7; } }"
        "effects { hertz {} bondLinear { normalStiffness 1e9; shearStiffness 1e9; normalStrength 1e9; } }"
        "insert { p { type list; diameter 2e-3; positions ((0 0 0) (2e-3 0 0)); velocities ((0 0.5 0) (0 -0.5 0)); } } time { step 1e-6; }";
    static const char *const weak[][2] = {{"effects/bondLinear/normalStrength", "1"}};
    struct dem *d = start(pair);
    struct dem_case *c = world_begin(pair);
    const struct dem_energy_item *of;
    double since, broken = 0.0, residual = 1.0;
    int n;

    world_run(d, 2e-4);
    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    WORLD_TRY(dem_case_set(c, weak[0][0], weak[0][1]));
    WORLD_TRY(dem_case_load(c, file));
    WORLD_TRY(dem_case_enable_energy(c));
    d = world_start(c);
    world_run(d, 1e-4);
    WORLD_TRY(dem_energy(d, &since, &n, &of));
    for (int k = 0; k < n; k++)
    {
        broken = strcmp(of[k].name, "broken") == 0 ? of[k].value : broken;
        residual = strcmp(of[k].name, "residual") == 0 ? of[k].value : residual;
    }
    TAP_OK(broken > 1e-8 && fabs(residual) < 1e-2*broken, "a bond that breaks at once had its energy before: %g J, residual "
           "%g J", broken, residual);
    dem_free(d);
}

/* ---- what particles lose or keep -------------------------------------------------------------- */

#define WARM(effects, ratio, warm) \
    "materials { glass { density 2500; youngsModulus 1e7; conductivity 1; heatCapacity 800; } } effects { hertz {} " effects \
    "} parcels { ratio " ratio "; } insert { a { type list; diameter 1e-3; " warm "positions ((0 0 0)); } } "

static void scalars(void)
{
    struct dem *d = start(WARM("conduction {} ", "2", "temperature 300; "));

    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    d = resume(WARM("", "3", ""), 0, NULL);
    TAP_OK(says(d, "effects/conduction is gone: it applies no longer; its particle scalars are lost"),
           "the temperatures of a law that is taken out are lost, and the sentence has it");
    TAP_OK(says(d, "parcels/ratio was 2, now 3: parcels of the snapshot keep their ratio")
               && world_scalar(d, "parcelRatio", 0) == 2.0, "parcels keep their ratio");
    dem_free(d);
}

/* A hinge leans on its upper stop. */
static void stops(void)
{
    static const char flap[] =
        "materials { m { density 2500; youngsModulus 1e7; } } effects { hertz {} dry { restitution 0.5; } } walls { flap { "
        "type triangles; corners ((0 -0.02 0) (0 0.02 0) (0.05 0 0)); motion { type hinge; origin (0 0 0); axis (0 1 0); "
        "inertia 3e-5; torque 1e-2; stops (-0.5 0.01); } } } time { step 1e-5; }";
    static const char *const narrow[][2] = {{"walls/flap/motion/stops", "(-0.5 0)"}},
                      *const wide[][2] = {{"walls/flap/motion/stops", "(-0.5 0.02)"}};
    struct dem *d = start(flap);

    world_run(d, 0.1);
    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    TAP_OK(load(&d, flap, 1, narrow) == DEM_ERROR_INPUT && strstr(dem_error_text(), "stops (-0.5 0) rad")
               && strstr(dem_error_text(), "turned by 0.01 rad"),
           "stops that would snap a hinge back are refused: %s", dem_error_text());
    dem_free(d);
    d = resume(flap, 1, wide);
    world_run(d, 0.1);
    TAP_OK(dem_wall_count(d) == 1, "wider ones apply");
    dem_free(d);
}

/* ---- all else -------------------------------------------------------------------------------- */

static void entries(void)
{
    static const char *const set[][2] = {
        {"effects/dry/restitution", "0.9"}, {"effects/gravity/acceleration", "(1 0 -9.81)"},
        {"materials/steel/youngsModulus", "2e7"}, {"materials/clay", "{ density 1500; youngsModulus 1e6; }"},
        {"domain", "{ z (-1 1); leaving remove; }"}, {"time/maxOverlap", "0.3"},
        {"outlets/gap/residence", "2"}, {"outlets/hole", "{ min (0 0 -1); max (1 1 -0.5); }"},
        {"insert/s", "{ type stream; material glass; rate 10; diameter 1e-3; min (0 0 0.03); max (0.01 0.01 0.035); }"},
        {"fluid", "{ density 1; viscosity 1e-5; }"},
        {"averages/grid", "{ min (0 0 0); max (1 1 1); interval 1e-3; }"}};
    static const char *const told[] = {
        "effects/dry/restitution was 0.4, now 0.9: it applies from now on",
        "effects/gravity/acceleration was (0 0 -9.81), now (1 0 -9.81): it applies",
        "materials/steel/youngsModulus was 1e7, now 2e7: it applies", "materials/clay is new",
        "domain/leaving remove is new", "time/maxOverlap 0.3 is new", "outlets/hole is new",
        "outlets/gap/residence was 1, now 2: its residence times are counted anew",
        "insert/s is new: the stream begins now", "fluid/density 1 is new",
        "averages/grid is new: the means of this grid begin now"};
    static const char *const same[][2] = {
        {"effects/dry/restitution", "4e-1"}, {"effects/gravity/acceleration", "( 0.0 0 -9.810 )"},
        {"time/end", "5"}, {"write/interval", "1"}};
    static const char *const periodic[][2] = {{"domain", "{ x (0 0.01); periodic (x); }"}};
    const char *const holed = world_text("%s outlets { gap { min (0 0 -1); max (1 1 -0.9); residence 1; } }", base);
    struct dem *d = start(holed);
    int all = 1;

    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    d = resume(holed, 11, set);
    for (int k = 0; k < 11; k++)
    {
        all &= says(d, told[k]);
    }
    TAP_OK(all, "each changed entry has its sentence");
    dem_free(d);
    struct dem_case *c = world_begin(holed);
    for (int k = 0; k < 4; k++)
    {
        WORLD_TRY(dem_case_set(c, same[k][0], same[k][1]));
    }
    dem_scene_skip(dem_case_dict(c), "time");
    dem_scene_skip(dem_case_dict(c), "write");
    WORLD_TRY(dem_case_load(c, file));
    d = world_start(c);
    TAP_OK(lines_of_restart(d) == 0, "the same numbers in other words, the end and the output: none");
    dem_free(d);
    TAP_OK(load(&d, holed, 1, periodic) != 0 && strstr(dem_error_text(), "not periodic along x"),
           "other periodic axes are refused: %s", dem_error_text());
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    const int made = mkstemp(file);

    TAP_OK(made >= 0 && close(made) == 0, "a file for the snapshots");
    groups();
    refused_groups();
    motions();
    rotation_by_angle();
    history();
    wall_in_soft_bed();
    broken_bond();
    scalars();
    stops();
    entries();
    remove(file);
    TAP_DONE;
}
