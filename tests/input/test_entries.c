/*
 * test_entries.c -- every entry of a scene and every setting of every effect, one by one, with
 * wrong values.
 *
 * - Refused before particles are placed, by a sentence that names the entry (and the line, where a
 *   ; is missing): left out where it has no default, misspelt, empty, of the wrong kind, too short
 *   a list, not a number, beyond a double or an integer, in other letters, without its semicolon.
 * - With 0, negative numbers, 1e300 or 1e-300 in its place the scene is refused in the same way or
 *   runs, without a crash or an endless loop.
 *
 * The valid scene is the table below; a case replaces one value of it. Then each setting of each
 * effect is tested in a scene of that effect. Entries that only the program reads are tested in
 * run. Build it with DEM_CFLAGS='-g -fsanitize=address,undefined', too.
 *
 * Source: the tables of docs/scene-reference.md.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "laws/effects.h"
#include <sys/resource.h>
#include <unistd.h>

enum kind
{
    NUMBER, VECTOR, COUNT, WORD, SWITCH, WORDS, NUMBERS, VECTORS, KINDS
};

static const struct row
{
    const char *path, *value;
    enum kind kind;
    int needed;
} rows[] =
{
    {"materials/glass/density", "2500", NUMBER, 1},
    {"materials/glass/youngsModulus", "1e7", NUMBER, 1},
    {"materials/glass/poissonsRatio", "0.3", NUMBER, 0},
    {"materials/steel/density", "7800", NUMBER, 1},
    {"materials/steel/youngsModulus", "1e8", NUMBER, 1},
    {"effects/hertz/impactSpeed", "1", NUMBER, 0},
    {"effects/dry/restitution", "0.9", NUMBER, 1},
    {"effects/dry/attraction", "clamped", WORD, 0},
    {"effects/mindlin/friction", "0.3", NUMBER, 1},
    {"effects/mindlin/tangentialDamping", "no", SWITCH, 0},
    {"effects/gravity/acceleration", "(0 0 -9.81)", VECTOR, 0},
    {"effects/gidaspow/blend", "switch", WORD, 0},
    {"effects/virtualMass/coefficient", "0.5", NUMBER, 0},
    {"effects/viscousTorque/correction", "yes", SWITCH, 0},
    {"effects/turbulentDispersion/lifetime", "0.15", NUMBER, 0},
    {"effects/turbulentDispersion/crossing", "no", SWITCH, 0},
    {"effects/turbulentDispersion/length", "0.2", NUMBER, 0},
    {"effects/turbulentDispersion/seed", "3", NUMBER, 0},
    {"pairs/hard/between", "(glass steel)", WORDS, 1},
    {"pairs/hard/dry/restitution", "0.8", NUMBER, 0},
    {"walls/floor/type", "plane", WORD, 1},
    {"walls/floor/material", "steel", WORD, 1},
    {"walls/floor/point", "(0 0 0)", VECTOR, 1},
    {"walls/floor/normal", "(0 0 1)", VECTOR, 1},
    {"walls/floor/until", "9", NUMBER, 0},
    {"walls/floor/from", "0", NUMBER, 0},
    {"walls/cup/type", "box", WORD, 1},
    {"walls/cup/material", "steel", WORD, 1},
    {"walls/cup/min", "(-0.5 -0.5 -0.5)", VECTOR, 1},
    {"walls/cup/max", "(0.5 0.5 0.5)", VECTOR, 1},
    {"walls/ramp/type", "triangles", WORD, 1},
    {"walls/ramp/material", "glass", WORD, 1},
    {"walls/ramp/corners", "((0.2 0 0.1) (0.3 0 0.1) (0.2 0.1 0.1))", VECTORS, 1},
    {"walls/ramp/surfaceVelocity", "(0 1 0)", VECTOR, 0},
    {"walls/ramp/absorb", "no", SWITCH, 0},
    {"walls/cup/frictionless", "no", SWITCH, 0},
    {"walls/drum/type", "cylinder", WORD, 1},
    {"walls/drum/material", "steel", WORD, 1},
    {"walls/drum/point", "(0 0 0)", VECTOR, 1},
    {"walls/drum/axis", "(0 0 1)", VECTOR, 1},
    {"walls/drum/radius", "0.9", NUMBER, 1},
    {"walls/drum/particles", "inside", WORD, 1},
    {"walls/drum/motion/type", "rotation", WORD, 1},
    {"walls/drum/motion/origin", "(0 0 0)", VECTOR, 1},
    {"walls/drum/motion/axis", "(0 0 1)", VECTOR, 1},
    {"walls/drum/motion/omega", "2", NUMBER, 1},
    {"walls/drum/motion/start", "0", NUMBER, 0},
    {"walls/drum/motion/end", "1", NUMBER, 0},
    {"walls/ball/type", "sphere", WORD, 1},
    {"walls/ball/material", "steel", WORD, 1},
    {"walls/ball/centre", "(-0.3 0 0.2)", VECTOR, 1},
    {"walls/ball/radius", "0.1", NUMBER, 1},
    {"walls/ball/particles", "outside", WORD, 1},
    {"walls/ball/motion/type", "oscillation", WORD, 1},
    {"walls/ball/motion/amplitude", "(0 0 0.001)", VECTOR, 1},
    {"walls/ball/motion/frequency", "5", NUMBER, 1},
    {"walls/ball/motion/phase", "0.1", NUMBER, 0},
    {"walls/lid/type", "plane", WORD, 1},
    {"walls/lid/material", "steel", WORD, 1},
    {"walls/lid/point", "(0 0 0.45)", VECTOR, 1},
    {"walls/lid/normal", "(0 0 -1)", VECTOR, 1},
    {"walls/lid/motion/type", "servo", WORD, 1},
    {"walls/lid/motion/pressure", "10", NUMBER, 1},
    {"walls/lid/motion/area", "0.1", NUMBER, 1},
    {"walls/lid/motion/maxSpeed", "0.1", NUMBER, 1},
    {"walls/lid/motion/damping", "5", NUMBER, 0},
    {"walls/lid/motion/axis", "(0 0 -1)", VECTOR, 0},
    {"walls/flap/type", "triangles", WORD, 1},
    {"walls/flap/material", "glass", WORD, 1},
    {"walls/flap/corners", "((0.2 0.5 0.1) (0.3 0.5 0.1) (0.2 0.6 0.1))", VECTORS, 1},
    {"walls/flap/motion/type", "hinge", WORD, 1},
    {"walls/flap/motion/origin", "(0 0 0)", VECTOR, 1},
    {"walls/flap/motion/axis", "(0 1 0)", VECTOR, 1},
    {"walls/flap/motion/inertia", "1", NUMBER, 1},
    {"walls/flap/motion/torque", "1", NUMBER, 0},
    {"walls/flap/motion/mass", "1", NUMBER, 0},
    {"walls/flap/motion/centre", "(0.2 0.5 0.1)", VECTOR, 1},
    {"walls/flap/motion/weight", "yes", SWITCH, 0},
    {"walls/plate/type", "triangles", WORD, 1},
    {"walls/plate/material", "glass", WORD, 1},
    {"walls/plate/corners", "((0.2 0.7 0.1) (0.3 0.7 0.1) (0.2 0.8 0.1))", VECTORS, 1},
    {"walls/plate/wear/law", "finnie", WORD, 0},
    {"walls/plate/wear/coefficient", "1e-4", NUMBER, 1},
    {"walls/plate/wear/hardness", "1e9", NUMBER, 1},
    {"walls/plate/motion/type", "free", WORD, 1},
    {"walls/plate/motion/mass", "1", NUMBER, 1},
    {"walls/plate/motion/damping", "1", NUMBER, 0},
    {"walls/plate/motion/weight", "no", SWITCH, 0},
    {"walls/plate/motion/force", "(0 0 1)", VECTOR, 0},
    {"walls/plate/motion/axis", "(0 0 1)", VECTOR, 0},
    {"walls/raft/type", "triangles", WORD, 1},
    {"walls/raft/material", "glass", WORD, 1},
    {"walls/raft/corners", "((0.2 0.9 0.1) (0.3 0.9 0.1) (0.2 0.95 0.1))", VECTORS, 1},
    {"walls/raft/motion/type", "free", WORD, 1},
    {"walls/raft/motion/mass", "1", NUMBER, 1},
    {"walls/raft/motion/axes", "(x z)", WORDS, 0},
    {"walls/raft/motion/rotations", "(x y z)", WORDS, 1},
    {"walls/raft/motion/weight", "no", SWITCH, 0},
    {"walls/raft/motion/inertia", "(1 1.1 1.2 0 0 0.1)", NUMBERS, 1},
    {"walls/raft/motion/centre", "(0.2 0.9 0.1)", VECTOR, 1},
    {"walls/raft/motion/torque", "(0 0 1)", VECTOR, 0},
    {"walls/raft/motion/angularDamping", "1", NUMBER, 0},
    {"walls/raft/motion/velocity", "(0 0 1)", VECTOR, 0},
    {"walls/raft/motion/spin", "(0 0 1)", VECTOR, 0},
    {"walls/belt/type", "triangles", WORD, 1},
    {"walls/belt/material", "glass", WORD, 1},
    {"walls/belt/corners", "((0.2 0.3 0.1) (0.3 0.3 0.1) (0.2 0.4 0.1))", VECTORS, 1},
    {"walls/belt/surfaceRotation/origin", "(0 0 0)", VECTOR, 1},
    {"walls/belt/surfaceRotation/axis", "(0 0 1)", VECTOR, 1},
    {"walls/belt/surfaceRotation/omega", "1", NUMBER, 1},
    {"walls/loop/type", "triangles", WORD, 1},
    {"walls/loop/material", "glass", WORD, 1},
    {"walls/loop/corners", "((0.5 0.3 0.1) (0.6 0.3 0.1) (0.5 0.4 0.1))", VECTORS, 1},
    {"walls/loop/surfaceRotation/origin", "(0 0 0)", VECTOR, 1},
    {"walls/loop/surfaceRotation/axis", "(0 1 0)", VECTOR, 1},
    {"walls/loop/surfaceRotation/speed", "1", NUMBER, 1},
    {"domain/x", "(-1 1)", NUMBERS, 0},
    {"domain/y", "(-1 1)", NUMBERS, 0},
    {"domain/z", "(-1 1)", NUMBERS, 0},
    {"domain/periodic", "()", WORDS, 0},
    {"domain/leaving", "error", WORD, 0},
    {"insert/few/type", "list", WORD, 1},
    {"insert/few/material", "glass", WORD, 1},
    {"insert/few/positions", "((0 0 0.01) (0.01 0 0.01))", VECTORS, 1},
    {"insert/few/diameters", "(2e-3 1e-3)", NUMBERS, 0},
    {"insert/few/velocities", "((0 0 0) (1 0 0))", VECTORS, 0},
    {"insert/few/spins", "((0 0 0) (1 0 0))", VECTORS, 0},
    {"insert/few/ids", "(7 9007199254740993)", NUMBERS, 0},
    {"insert/box/type", "lattice", WORD, 1},
    {"insert/box/material", "glass", WORD, 1},
    {"insert/box/diameter", "2e-3", NUMBER, 1},
    {"insert/box/velocity", "(0 0 0)", VECTOR, 0},
    {"insert/box/spin", "(0 0 0)", VECTOR, 0},
    {"insert/box/frozen", "no", SWITCH, 0},
    {"insert/box/min", "(0.1 0.1 0.1)", VECTOR, 1},
    {"insert/box/max", "(0.15 0.15 0.15)", VECTOR, 1},
    {"insert/box/count", "20", COUNT, 0},
    {"insert/box/seed", "3", COUNT, 0},
    {"insert/box/spacing", "1.2", NUMBER, 0},
    {"insert/box/jitter", "0.1", NUMBER, 0},
    {"insert/box/inside", "walls", WORD, 0},
    {"insert/any/type", "random", WORD, 1},
    {"insert/any/material", "glass", WORD, 1},
    {"insert/any/diameter", "2e-3", NUMBER, 1},
    {"insert/any/min", "(0.1 0.1 0.2)", VECTOR, 1},
    {"insert/any/max", "(0.15 0.15 0.25)", VECTOR, 1},
    {"insert/any/count", "20", COUNT, 1},
    {"insert/any/seed", "3", COUNT, 0},
    {"insert/drawn/type", "random", WORD, 1},
    {"insert/drawn/material", "steel", WORD, 1},
    {"insert/drawn/sizes/type", "logNormal", WORD, 1},
    {"insert/drawn/sizes/by", "volume", WORD, 0},
    {"insert/drawn/sizes/median", "1e-3", NUMBER, 1},
    {"insert/drawn/sizes/deviation", "0.2", NUMBER, 1},
    {"insert/drawn/sizes/min", "5e-4", NUMBER, 0},
    {"insert/drawn/sizes/max", "2e-3", NUMBER, 0},
    {"insert/drawn/cylinder/from", "(0.1 0 0.3)", VECTOR, 1},
    {"insert/drawn/cylinder/to", "(0.2 0 0.3)", VECTOR, 1},
    {"insert/drawn/cylinder/radius", "0.01", NUMBER, 1},
    {"insert/drawn/mass", "1e-4", NUMBER, 1},
    {"insert/sieved/type", "random", WORD, 1},
    {"insert/sieved/material", "glass", WORD, 1},
    {"insert/sieved/sizes/type", "list", WORD, 1},
    {"insert/sieved/sizes/diameters", "(1e-3 2e-3)", NUMBERS, 1},
    {"insert/sieved/sizes/weights", "(1 3)", NUMBERS, 1},
    {"insert/sieved/sphere/centre", "(0.3 0.2 0.3)", VECTOR, 1},
    {"insert/sieved/sphere/radius", "0.01", NUMBER, 1},
    {"insert/sieved/solidFraction", "0.02", NUMBER, 1},
    {"planes/neck/point", "(0 0 0)", VECTOR, 1},
    {"planes/neck/normal", "(0 0 1)", VECTOR, 1},
    {"planes/neck/radius", "0.1", NUMBER, 0},
    {"stages/first/duration", "1", NUMBER, 1},
    {"stages/last/until", "quiet", WORD, 0},
    {"stages/last/atMost", "1", NUMBER, 0},
    {"fluid/velocity", "(0 0 0)", VECTOR, 0},
    {"fluid/density", "1", NUMBER, 1},
    {"fluid/viscosity", "1e-5", NUMBER, 1},
    {"fluid/voidFraction", "0.9", NUMBER, 0},
    {"fluid/pressureGradient", "(0 0 -9.8)", VECTOR, 0},
    {"fluid/acceleration", "(0.1 0 0)", VECTOR, 0},
    {"fluid/vorticity", "(0 10 0)", VECTOR, 0},
    {"fluid/turbulentEnergy", "1", NUMBER, 0},
    {"fluid/dissipation", "10", NUMBER, 0},
    {"neighbours/outerSkin", "0.3", NUMBER, 0},
    {"neighbours/innerSkin", "0.04", NUMBER, 0},
    {"averages/layer/min", "(0 0 0)", VECTOR, 1},
    {"averages/layer/max", "(0.1 0.1 0.1)", VECTOR, 1},
    {"averages/layer/cells", "(2 1 3)", VECTOR, 0},
    {"averages/layer/interval", "1e-5", NUMBER, 1},
    {"averages/layer/start", "0", NUMBER, 0},
    {"averages/layer/end", "1", NUMBER, 0},
    {"time/step", "auto", WORD, 0},
    {"time/maxOverlap", "0.5", NUMBER, 0},
    {"time/maxStartOverlap", "0.05", NUMBER, 0},
    {"time/force", "no", SWITCH, 0},
};

enum
{
    ROWS = (int)(sizeof rows/sizeof rows[0]),
    ALL = -1,                                             /* no row is replaced */
    PATIENCE = 300                                        /* s until an endless loop is ended */
};

/* Values that are wrong for each kind. */
static const char *const wrong[KINDS][16] = {
    [NUMBER] = {"", "many", "1 2", "(1 2 3)", "nan", "inf", "-inf", "1e400", "-1e400", "1,5",
                "0x10", "1e", "\xc3\xa4", "\"\"", "(1)"},
    [VECTOR] = {"", "many", "1", "(1 2)", "(1 2 3 4)", "(0 0 nan)", "(0 inf 0)", "(1e400 0 0)",
                "1 2 3", "((1 2 3))", "(0 0 \xc3\xa4)", "()", "{}"},
    [COUNT] = {"", "many", "1.5", "nan", "inf", "1e400", "99999999999999999999", "(1)", "1 2",
               "1e-3", "1e-300", "\xc3\xa4"},
    [WORD] = {"", "nosuch", "(a b)", "two words", "\"two words\"", "\xc3\xa4", "\"\"", "nan"},
    [SWITCH] = {"", "maybe", "2", "nan", "(yes)", "yes no", "\xc3\xa4"},
    [WORDS] = {"", "x", "(q)", "(x", "((x))", "(\xc3\xa4)", "2 (x)"},
    [NUMBERS] = {"", "1", "(x)", "(1 nan)", "(1 inf)", "(1e400 1)", "((1 2))", "3 (1 2)", "(1 2",
                 "(1)"},
    [VECTORS] = {"", "1", "(1 2 3)", "((1 2))", "((1 2 nan))", "((1e400 0 0))", "(((1 2 3)))",
                 "2 ((1 2 3))", "((1 2 3)"},
};

/* Values that may be right for one entry and wrong for another. */
static const char *const extreme[KINDS][10] = {
    [NUMBER] = {"0", "-1", "1e300", "-1e300", "1e-300", "1e-308", "1e308", "3e8", "1e15"},
    [VECTOR] = {"(0 0 0)", "(1e300 0 0)", "(0 -1e300 1e300)", "(1e-300 0 0)",
                "(1e308 -1e308 1e308)", "(-1 -1 -1)", "(-1e308 -1e308 -1e308)"},
    [COUNT] = {"0", "-1", "9223372036854775807", "-9223372036854775808", "1e15", "1e8",
               "2147483648"},
    [WORD] = {"auto"},
    [SWITCH] = {"yes", "off"},
    [WORDS] = {"()", "(x x)", "(x y z)", "(glass glass)", "(steel steel)"},
    [NUMBERS] = {"()", "(0 0)", "(0 -1)", "(1e300 1e300)", "(-1e308 1e308)", "(1e-300 2e-300)",
                 "(1 -1)"},
    [VECTORS] = {"()", "((0 0 0))", "((0 0 0) (0 0 0) (0 0 0))",
                 "((1e300 0 0) (0 1e300 0) (0 0 1e300))", "((1e308 0 0) (-1e308 0 0))",
                 "((0 0 1e300) (0 0 -1e300))", "((1e308 0 0) (-1e308 0 0) (0 1e308 0))"},
};

/* ---- the scene ------------------------------------------------------------------------------- */

struct fault
{
    int row;
    /* in place of the row's; no value: left out */
    const char *name, *value, *end;
};

static const char *last_word(const char *path)
{
    const char *const slash = strrchr(path, '/');

    return slash ? slash + 1 : path;
}

/* The word before the last. */
static void group_of(const char *path, char group[64])
{
    const char *const end = strrchr(path, '/');
    const char *from = end;

    while (from > path && from[-1] != '/')
    {
        from--;
    }
    snprintf(group, 64, "%.*s", (int)(end - from), from);
}

/* Print the scene, each entry and each brace on one line. Returns the line of the fault. */
static int print_scene(FILE *to, const struct fault *fault)
{
    const char *last = "";
    int line = 1, here = 0;

    for (int i = 0; i < ROWS; i++)
    {
        const char *const path = rows[i].path, *const word = last_word(path);
        const int slips = i == fault->row;
        size_t same = 0;

        for (size_t c = 0; path[c] && path[c] == last[c]; c++)
        {
            same = path[c] == '/' ? c + 1 : same;
        }
        for (const char *c = strchr(last + same, '/'); *last && c; c = strchr(c + 1, '/'))
        {
            line += fprintf(to, "}\n") > 0;
        }
        for (const char *c = path + same; c < word; c += strcspn(c, "/") + 1)
        {
            fwrite(c, 1, strcspn(c, "/"), to);
            fputs("\n{\n", to);
            line += 2;
        }
        if (!slips || fault->value)
        {
            fprintf(to, "%s %s%s\n", slips ? fault->name : word,
                    slips ? fault->value : rows[i].value, slips ? fault->end : ";");
        }
        here = slips ? line : here;
        line++;
        last = path;
    }
    for (const char *c = strchr(last, '/'); c; c = strchr(c + 1, '/'))
    {
        fprintf(to, "}\n");
    }
    return here;
}

static int is_sentence(const char *text)
{
    return text[0] && strlen(text) < 1000 && !strchr(text, '\n');
}

static int cases;

/* ---- one case -------------------------------------------------------------------------------- */

struct outcome
{
    int refused, failed, line;                            /* before particles are placed; later */
    char sentence[8192];
};

static void advance_briefly(struct dem_case **c, struct outcome *f)
{
    struct dem *d;
    int status = dem_start(c, &d);

    for (int k = 0; k < 3 && !status; k++)
    {
        status = dem_advance(d, dem_step_limit(d).used);
    }
    f->failed = status;
    dem_free(d);
}

static struct outcome try_scene(const struct fault *fault)
{
    static char text[32768];
    struct outcome f = {.refused = 0};
    struct dem_case *c = NULL;
    FILE *const to = fmemopen(text, sizeof text, "w");

    cases++;
    f.line = print_scene(to, fault);
    fclose(to);
    WORLD_TRY(dem_case_create(&c, MPI_COMM_NULL));
    f.refused = dem_case_scene_text(c, text, "scene");
    f.refused = f.refused ? f.refused : dem_case_check(c);
    if (!f.refused)
    {
        advance_briefly(&c, &f);
    }
    snprintf(f.sentence, sizeof f.sentence, "%s", f.refused || f.failed ? dem_error_text() : "");
    dem_case_free(c);
    return f;
}

/* It must be refused before particles are placed, and the sentence must name its word. */
static void must_refuse(const char *what, const struct fault *fault)
{
    const struct row *const r = &rows[fault->row];
    const struct outcome f = try_scene(fault);
    const int good = f.refused && is_sentence(f.sentence) && strstr(f.sentence, last_word(r->path));

    if (!good)
    {
        TAP_OK(0, "%s, %s", r->path, what);
        TAP_NOTE("%s: %s", f.refused ? "refused" : f.failed ? "refused late" : "runs", f.sentence);
    }
}

/* It is refused before particles are placed, with its word or its group, or accepted; a run that
   fails ends with a sentence. */
static int try_extreme(const char *value, const struct fault *fault)
{
    const struct row *const r = &rows[fault->row];
    const struct outcome f = try_scene(fault);
    char group[64], word[64];

    /* without the plural s of a list */
    snprintf(word, sizeof word, "%.*s",
             (int)(strlen(last_word(r->path)) - (r->kind == NUMBERS || r->kind == VECTORS)),
             last_word(r->path));
    group_of(r->path, group);
    const int named = strcasestr(f.sentence, word) || strcasestr(f.sentence, group);
    const int good =
        (!f.refused || named) && ((!f.refused && !f.failed) || is_sentence(f.sentence));

    if (!good)
    {
        TAP_OK(0, "%s %s", r->path, value);
        TAP_NOTE("%s: %s", f.refused ? "refused" : f.failed ? "refused late" : "runs", f.sentence);
    }
    return !f.refused;
}

static void leave_out_semicolon(int k)
{
    const struct fault fault = {.row = k,
                              .name = last_word(rows[k].path),
                              .value = rows[k].value,
                              .end = ""};
    const struct outcome f = try_scene(&fault);
    char asks[64], says[64];

    snprintf(asks, sizeof asks, "is a ; missing at the end of line %d?", f.line);
    snprintf(says, sizeof says, "; end line %d with ;", f.line);
    if (!f.refused || !is_sentence(f.sentence) ||
        (!strstr(f.sentence, asks) && !strstr(f.sentence, says)))
    {
        TAP_OK(0, "%s without its semicolon, line %d", rows[k].path, f.line);
        TAP_NOTE("%s", f.sentence);
    }
}

static void try_row(int k)
{
    const struct row *const r = &rows[k];
    const char *const word = last_word(r->path);
    char misspelt[80];
    int before = tap_count.failed, taken = 0, extremes = 0;

    leave_out_semicolon(k);
    snprintf(misspelt, sizeof misspelt, "%sx", word);
    must_refuse("misspelt", &(struct fault){k, misspelt, r->value, ";"});
    if (r->needed)
    {
        must_refuse("left out", &(struct fault){k, word, NULL, ";"});
    }
    for (int j = 0; wrong[r->kind][j]; j++)
    {
        must_refuse(wrong[r->kind][j], &(struct fault){k, word, wrong[r->kind][j], ";"});
    }
    for (int j = 0; extreme[r->kind][j]; j++)
    {
        taken +=
            try_extreme(extreme[r->kind][j], &(struct fault){k, word, extreme[r->kind][j], ";"});
        extremes++;
    }
    TAP_OK(tap_count.failed == before, "%s: faults are refused by name; of %d extremes %d run",
           r->path, extremes, taken);
}

/* ---- effects --------------------------------------------------------------------------------- */

/* Two particles and a wall, with this effect, and hertz where it needs a normal law. */
static int check_setting(const struct dem_effect *effect, const char *name, const char *value)
{
    char text[1024];
    struct dem_case *c = NULL;

    cases++;
    snprintf(
        text, sizeof text,
        "materials { glass { density 2500; youngsModulus 1e7; } } effects { %s %s { %s %s; } }"
        "insert { two { type list; diameter 1e-3; positions ((0 0 1) (0.0011 0 1)); } } "
        "time { step 1e-9; }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }",
        effect->stage == DEM_STAGE_NORMAL ? "" : "hertz { }", effect->name, name, value);
    WORLD_TRY(dem_case_create(&c, MPI_COMM_NULL));
    int status = dem_case_scene_text(c, text, "scene");

    status = status ? status : dem_case_check(c);
    dem_case_free(c);
    return status;
}

static void settings(const struct dem_effect *effect)
{
    for (const struct dem_setting *f = effect->settings; f && f->name; f++)
    {
        const enum kind kind = f->kind == DEM_SETTING_NUMBER ? NUMBER
                               : f->kind == DEM_SETTING_VECTOR ? VECTOR
                               : f->kind == DEM_SETTING_SWITCH ? SWITCH
                                                               : WORD;
        const char *worst = NULL;
        int taken = 0, extremes = 0;

        for (int j = 0; wrong[kind][j]; j++)
        {
            const int good = check_setting(effect, f->name, wrong[kind][j]) &&
                             is_sentence(dem_error_text()) && strstr(dem_error_text(), f->name) &&
                             strstr(dem_error_text(), effect->name);

            worst = good ? worst : wrong[kind][j];
        }
        for (int j = 0; extreme[kind][j]; j++, extremes++)
        {
            const int status = check_setting(effect, f->name, extreme[kind][j]);

            worst = status && !is_sentence(dem_error_text()) ? extreme[kind][j] : worst;
            taken += !status;
        }
        TAP_OK(!worst,
               "effects/%s/%s: faults are refused by name; of %d extremes %d are accepted %s",
               effect->name, f->name, extremes, taken, worst ? worst : "");
    }
}

/* ---- resources ------------------------------------------------------------------------------------- */

/* Limits of twenty times the time and a hundred times the memory on a machine of 2020, to detect
   cases that take much more. */
static void resources(void)
{
    struct rusage used;

    getrusage(RUSAGE_SELF, &used);
    const double seconds = (double)used.ru_utime.tv_sec + (double)used.ru_stime.tv_sec +
                           1e-6*(double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    const double megabytes = 1e-3*(double)used.ru_maxrss;

#ifdef __SANITIZE_ADDRESS__
    TAP_NOTE("%d cases took %.2f s and %.0f MB", cases, seconds, megabytes);
#else
    TAP_OK(seconds < 10.0 && megabytes < 500.0,
           "%d cases took %.2f s and %.0f MB, less than 10 s and 500 MB", cases, seconds,
           megabytes);
#endif
}

int main(void)
{
    const struct outcome good = try_scene(&(struct fault){.row = ALL});

    TAP_TRAPS;
    alarm(PATIENCE);
    TAP_OK(!good.refused && !good.failed, "the valid scene runs %s", good.sentence);
    for (int k = 0; k < ROWS; k++)
    {
        try_row(k);
    }
    for (const struct dem_effect *const *e = dem_effects; *e; e++)
    {
        settings(*e);
    }
    resources();
    TAP_DONE;
}
