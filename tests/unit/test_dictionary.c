/*
 * test_dictionary.c -- the text of a scene gives the values that OpenFOAM would read from it;
 * errors name their line.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/error.h"
#include "input/dictionary.h"
#include "input/dictionary_tree.h"

#include <stdlib.h>
#include <string.h>

static struct dem_dict *read_good(const char *text)
{
    struct dem_dict *d = NULL;

    TAP_OK(dem_dict_read_text(&d, text, "scene.dem") == DEM_OK, "reads: %.40s",
           strchr(text, '\n') ? "..." : text);
    if (!d)
    {
        printf("Bail out! %s\n", dem_error_text());
        exit(1);
    }
    return d;
}

/* The first dictionaries of the list d/name, at most `limit`; their number. Marks it as read. */
static size_t items(const struct dem_dict *d, const char *name, const struct dem_dict **item,
                    size_t limit)
{
    size_t n = 0;

    for (size_t k = 0; k < dem_dict_count(d); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(d, k);

        for (size_t i = 0; strcmp(e->name, name) == 0 && dem_entry_token(e, i); i++)
        {
            if (e->tokens[i].dict && n < limit)
            {
                item[n++] = e->tokens[i].dict;
            }
        }
    }
    return n;
}

static const char scene[] =
    "/* a scene */\n"
    "FoamFile { version 2.0; format ascii; class dictionary; object demProperties; }\n"
    "// all of the syntax\n"
    "d 2e-3; half 0.5;\n"
    "defaults { restitution 0.9; friction 0.3; inner { depth 2; } }\n"
    "materials\n"
    "{\n"
    "    glass { density rho [1 -3 0 0 0 0 0] 2500; $defaults; friction 0.2; size $d; }\n"
    "    steel { density [1 -3 0 0 0 0 0] 7800; name \"stainless \\\"316\\\" steel\"; }\n"
    "    copy $glass;\n"
    "    glass { young 1e7; inner { width $..young; depth $:half; } }\n"
    "}\n"
    "g (0 0 -9.81);  g3 3(0 0 -9.81);  gd g [0 1 -2 0 0 0 0] (0 0 -9.81);\n"
    "radii ( 1e-3 $d ${half} .5 -1. +2 );\n"
    "counted List<scalar> 3 ( 1 2 3 );\n"
    "points 2 ( (0 0 1) (1 2 3) );\n"
    "words ( a \"b c\" div(phi,U) constant/wall.stl );\n"
    "walls ( floor { normal (0 0 1); } { normal (1 0 0); k $half; } $defaults );\n"
    "n 1000000007; big 9223372036854775807; million 1e6;\n"
    "on1 yes; off1 off;\n"
    "deep $materials.glass.inner.depth; near $defaults.friction;\n"
    "dotted.name 7; seven $dotted.name;\n"
    "a 1; a $a 2; empty ; quoted \"\";;\n";

static void numbers(void)
{
    struct dem_dict *d = read_good(scene);
    const struct dem_dict *materials, *glass, *steel, *copy, *inner;
    double x = 0.0;
    int64_t n = 0;

    TAP_OK(!dem_dict_sub(d, "materials", &materials) && !dem_dict_sub(materials, "glass", &glass)
           && !dem_dict_sub(materials, "steel", &steel) && !dem_dict_sub(materials, "copy", &copy)
           && !dem_dict_sub(glass, "inner", &inner), "dictionaries in dictionaries");
    TAP_OK(!dem_dict_number(glass, "density", "kg/m3", &x) && x == 2500.0,
           "a number with name and dimensions");
    TAP_OK(!dem_dict_number(steel, "density", "kg/m3", &x) && x == 7800.0,
           "a number with dimensions");
    TAP_OK(!dem_dict_number(glass, "restitution", "1", &x) && x == 0.9, "$dict; inserts entries");
    TAP_OK(!dem_dict_number(glass, "friction", "1", &x) && x == 0.2,
           "a later entry replaces an inserted one");
    TAP_OK(!dem_dict_number(glass, "young", "Pa", &x) && x == 1e7,
           "dictionaries of one name merge");
    TAP_OK(!dem_dict_number(glass, "size", "m", &x) && x == 2e-3, "$name is found further out");
    TAP_OK(!dem_dict_number(copy, "friction", "1", &x) && x == 0.2,
           "name $dict; copies a dictionary");
    TAP_OK(!dem_dict_has(copy, "young"), "... as it was at that line");
    TAP_OK(!dem_dict_number(inner, "width", "m", &x) && x == 1e7,
           "$..name looks one dictionary out");
    TAP_OK(!dem_dict_number(inner, "depth", "m", &x) && x == 0.5, "$:name looks at the top");
    TAP_OK(!dem_dict_number(d, "deep", "m", &x) && x == 0.5, "$dict.sub.sub.name looks inward");
    TAP_OK(!dem_dict_number(d, "near", "1", &x) && x == 0.3,
           "$dict.name reads the template, not its copies");
    TAP_OK(!dem_dict_number(d, "seven", "1", &x) && x == 7.0, "a name with a dot of its own");
    TAP_OK(!dem_dict_number_or(d, "absent", "m", 4.5, &x) && x == 4.5,
           "an absent number takes the fallback");
    TAP_OK(!dem_dict_number_or(d, "d", "m", 4.5, &x) && x == 2e-3, "a present number does not");
    TAP_OK(!dem_dict_int64(d, "n", &n) && n == 1000000007, "a whole number");
    TAP_OK(!dem_dict_int64(d, "big", &n) && n == INT64_MAX, "the largest whole number, exactly");
    TAP_OK(!dem_dict_int64(d, "million", &n) && n == 1000000, "1e6 is a whole number");
    TAP_OK(!dem_dict_int64_or(d, "absent", -3, &n) && n == -3,
           "an absent whole number takes the fallback");
    dem_dict_free(d);
}

static void dimensions(void)
{
    static const struct
    {
        const char *unit, *value;
    } of[] = {{"W/(m K)", "[1 1 -3 -1 0 0 0]"}, {"J/(kg K)", "[0 2 -2 -1 0]"}, {"Pa s", "[1 -1 -1 0 0 0 0]"},
              {"1/s", "[0 0 -1 0 0 0 0]"}, {"rad/s", "w [0 0 -1 0 0 0 0]"}, {"1", "[0 0 0 0 0 0 0]"},
              {"N m s/rad", "[1 2 -1 0 0 0 0]"}, {"m2/s3", "[0 2 -3 0 0 0 0]"}};

    for (size_t k = 0; k < sizeof of/sizeof *of; k++)
    {
        char text[64];
        double x = 0.0;

        snprintf(text, sizeof text, "a %s 3;", of[k].value);
        struct dem_dict *const d = read_good(text);

        TAP_OK(!dem_dict_number(d, "a", of[k].unit, &x) && x == 3.0, "%s is %s", of[k].value, of[k].unit);
        TAP_OK(dem_dict_number(d, "a", "kg m2", &x) == DEM_ERROR_INPUT, "... and not kg m2");
        dem_dict_free(d);
    }
}

static void words_and_vectors(void)
{
    struct dem_dict *d = read_good(scene);
    const struct dem_dict *materials, *steel;
    const double fallback[3] = {1, 2, 3};
    const char *text = "";
    double v[3];
    bool yes;

    for (int i = 0; i < 3; i++)
    {
        static const char *const names[] = {"g", "g3", "gd"};

        TAP_OK(!dem_dict_vector(d, names[i], "m/s2", v) && v[0] == 0 && v[1] == 0 && v[2] == -9.81,
               "vector %s", names[i]);
    }
    TAP_OK(!dem_dict_vector_or(d, "absent", "m", fallback, v) && v[0] == 1 && v[2] == 3,
           "an absent vector");
    TAP_OK(!dem_dict_sub(d, "materials", &materials) && !dem_dict_sub(materials, "steel", &steel) &&
               !dem_dict_text(steel, "name", &text) && strcmp(text, "stainless \"316\" steel") == 0,
           "string: %s", text);
    TAP_OK(!dem_dict_text(d, "quoted", &text) && *text == '\0', "an empty string is a text");
    TAP_OK(dem_dict_word(d, "quoted", &text) == DEM_ERROR_INPUT, "... but not a word");
    TAP_OK(dem_dict_word(steel, "name", &text) == DEM_ERROR_INPUT,
           "a string with spaces is not a word");
    TAP_OK(!dem_dict_word_or(d, "absent", "none", &text) && strcmp(text, "none") == 0,
           "an absent word");
    TAP_OK(!dem_dict_text_or(d, "absent", NULL, &text) && !text, "an absent text");
    TAP_OK(!dem_dict_switch(d, "on1", &yes) && yes, "yes");
    TAP_OK(!dem_dict_switch(d, "off1", &yes) && !yes, "off");
    TAP_OK(!dem_dict_switch_or(d, "absent", true, &yes) && yes, "an absent switch");
    dem_dict_free(d);
}

static void lists(void)
{
    struct dem_dict *d = read_good(scene);
    const struct dem_dict *walls[4];
    const char *const *words;
    const double *x, (*v)[3];
    double k = 0.0;
    size_t n = 0;

    TAP_OK(!dem_dict_numbers(d, "radii", "m", &x, &n) && n == 6 && x[0] == 1e-3 && x[1] == 2e-3 &&
               x[2] == 0.5 && x[3] == 0.5 && x[4] == -1 && x[5] == 2,
           "numbers and macros in a list");
    TAP_OK(!dem_dict_numbers(d, "counted", "1", &x, &n) && n == 3 && x[2] == 3,
           "a list with type and length");
    TAP_OK(!dem_dict_vectors(d, "points", "m", &v, &n) && n == 2 && v[0][2] == 1 && v[1][0] == 1 &&
               v[1][2] == 3,
           "a list of vectors");
    TAP_OK(!dem_dict_words(d, "words", &words, &n) && n == 4 && strcmp(words[1], "b c") == 0 &&
               strcmp(words[2], "div(phi,U)") == 0 && strcmp(words[3], "constant/wall.stl") == 0,
           "a list of words");
    n = items(d, "walls", walls, 4);
    TAP_OK(n == 3, "a list of three dictionaries, found %zu", n);
    TAP_OK(n == 3 && strcmp(dem_dict_name(walls[0]), "floor") == 0 &&
               strcmp(dem_dict_path(walls[0]), "walls/floor") == 0 &&
               strcmp(dem_dict_path(walls[1]), "walls[1]") == 0,
           "with and without a name");
    TAP_OK(n == 3 && !dem_dict_number(walls[1], "k", "1", &k) && k == 0.5,
           "a macro inside an item looks outward");
    TAP_OK(n == 3 && !dem_dict_number(walls[2], "friction", "1", &k) && k == 0.3,
           "a macro as an item");
    dem_dict_free(d);
}

static void in_order(void)
{
    struct dem_dict *d = read_good("b 1 (2 x); a { z \"q r\"; }\n\nc 3;");
    const struct dem_entry *e;
    const struct dem_dict *a = NULL;

    TAP_OK(dem_dict_count(d) == 3 && !dem_dict_entry(d, 3), "three entries");
    e = dem_dict_entry(d, 0);
    TAP_OK(strcmp(dem_entry_name(e), "b") == 0 && dem_entry_tokens(e) == 5,
           "the order of the text");
    TAP_OK(strcmp(dem_entry_token(e, 0), "1") == 0 && strcmp(dem_entry_token(e, 1), "(") == 0 &&
               !dem_entry_token(e, 5),
           "raw words");
    e = dem_dict_entry(d, 1);
    TAP_OK(dem_entry_is_dict(e) && (a = dem_entry_dict(e)) && strcmp(dem_dict_path(a), "a") == 0,
           "a dictionary");
    e = dem_dict_entry(d, 2);
    TAP_OK(strcmp(dem_entry_where(e), "scene.dem, line 3") == 0, "position of an entry: %s",
           dem_entry_where(e));
    TAP_OK(strcmp(dem_dict_where(d), "scene.dem") == 0 && *dem_dict_path(d) == '\0',
           "position of the top level");
    TAP_OK(dem_dict_refuse_unread(d) == DEM_ERROR_INPUT &&
               strstr(dem_error_text(), "unknown entry \"z\" in a"),
           "entries taken in a loop count as read, the others are refused: %s", dem_error_text());
    TAP_OK(a && dem_dict_has(a, "z") && dem_dict_refuse_unread(d) == DEM_ERROR_INPUT &&
               strstr(dem_error_text(), "entry \"z\" of a has no effect"),
           "one that is known, but not read: %s", dem_error_text());
    dem_dict_mark_read(d);
    TAP_OK(dem_dict_refuse_unread(d) == DEM_OK, "unless all are accepted");
    dem_dict_free(d);
}

static void more(void)
{
    static const char *const bad[][2] = {{"n", "{"}, {"n", "4; m 5"}, {"n", "4 }"}, {"a/", "1"},
                                         {"a//x", "1"}, {"a b/x", "1"}, {"n", "$nothing"},
                                         {"n", "{ x 1; } { y 2; }"}, {"", "1"}};
    struct dem_dict *d = read_good("a { x 1; y 2; } n 3;");
    const struct dem_dict *a;
    double x = 0.0, y = 0.0, n = 0.0;

    TAP_OK(!dem_dict_set(d, "a/x", "$n") && !dem_dict_set(d, "n", "4"), "entries are set");
    TAP_OK(!dem_dict_sub(d, "a", &a) && !dem_dict_number(a, "x", "m", &x) &&
               !dem_dict_number(a, "y", "m", &y) && !dem_dict_number(d, "n", "1", &n) && x == 3 &&
               y == 2 && n == 4,
           "replaces entries, keeps others and can refer to the first text");
    TAP_OK(strcmp(dem_entry_where(dem_dict_entry(d, 1)), "n, line 1") == 0,
           "their position is the path");
    TAP_OK(!dem_dict_set(d, "b/c/x", "(1 2)") && !dem_dict_set(d, "a", "{ z 5; }") &&
               !dem_dict_set(d, "e", "{}"), "new dictionaries, and a dictionary as value");
    TAP_OK(!dem_dict_sub(d, "a", &a) && !dem_dict_number(a, "z", "m", &x) && x == 5 &&
               !dem_dict_number(a, "y", "m", &y) && y == 2 && dem_dict_has(d, "e"),
           "which is merged into one that is there");
    dem_dict_free(d);
    for (size_t k = 0; k < sizeof bad/sizeof bad[0]; k++)
    {
        d = read_good("a { x 1; } n 3;");
        TAP_OK(dem_dict_set(d, bad[k][0], bad[k][1]) == DEM_ERROR_INPUT &&
                   strstr(dem_error_text(), bad[k][0]), "refused: %s", dem_error_text());
        dem_dict_free(d);
    }
}

struct spring
{
    double restitution, direction[3], count;
    int law, on;
};

static const char *const laws[] = {"tsuji", "none", NULL};
static const struct dem_setting spring_fields[] = {
    DEM_SETTING(spring, restitution, "1", DEM_SETTING_REQUIRED, 0.0, 1.0,
                "speed after over speed before"),
    DEM_SETTING_VECTOR(spring, direction, "m", 0.0, -1.0, 1.0, "where to"),
    DEM_SETTING_COUNT(spring, count, "count", 3.0, 0.0, 9.0, "how many"),
    DEM_SETTING_CHOICE(spring, law, "law", 0, laws, "damping law"),
    DEM_SETTING_SWITCH(spring, on, "on", 1, "acts at all"),
    {0},
};

static void fields(void)
{
    struct dem_dict *d =
        read_good("effects { dry { restitution 0.8; direction (0 1 0); law none; on no; } }");
    const struct dem_dict *effects, *dry;
    struct spring s;

    TAP_OK(!dem_dict_sub(d, "effects", &effects) && !dem_dict_sub(effects, "dry", &dry)
           && !dem_dict_settings(dry, spring_fields, &s), "a struct from its table of fields");
    TAP_OK(s.restitution == 0.8 && s.direction[1] == 1 && s.count == 3 && s.law == 1 && s.on == 0,
           "with its values");
    TAP_OK(dem_dict_refuse_unread(d) == DEM_OK, "all entries were read");
    dem_dict_free(d);
}

/* A small reader of scenes. */
static int read_scene(const struct dem_dict *d)
{
    const struct dem_dict *materials, *glass, *effects, *dry, *walls[1];
    const double *radii;
    const char *word;
    struct spring s;
    double density, v[3];
    int64_t n;
    size_t count;
    bool yes;

    DEM_TRY(dem_dict_sub_if(d, "materials", &materials));
    if (materials)
    {
        DEM_TRY(dem_dict_sub(materials, "glass", &glass));
        DEM_TRY(dem_dict_number(glass, "density", "kg/m3", &density));
    }
    DEM_TRY(dem_dict_sub_if(d, "effects", &effects));
    if (effects)
    {
        DEM_TRY(dem_dict_sub(effects, "dry", &dry));
        DEM_TRY(dem_dict_settings(dry, spring_fields, &s));
    }
    DEM_TRY(dem_dict_vector_or(d, "g", "m/s2", (const double[]){0, 0, 0}, v));
    DEM_TRY(dem_dict_int64_or(d, "n", 0, &n));
    DEM_TRY(dem_dict_switch_or(d, "on", true, &yes));
    DEM_TRY(dem_dict_word_or(d, "shape", "sphere", &word));
    DEM_TRY(dem_dict_has(d, "radii") ? dem_dict_numbers(d, "radii", "m", &radii, &count) : DEM_OK);
    count = dem_dict_has(d, "walls") ? items(d, "walls", walls, 1) : 0;
    return dem_dict_refuse_unread(d);
}

static const struct
{
    const char *text, *sentence;
} bad[] = {
    /* grammar */
    {"materials\n{\n glass\n {\n  density 2500\n }\n}",
     "scene.dem, line 6: found } in the value of density, expected ; after \"density 2500\"; "
     "end line 5 with ;"},
    {"materials\n{\n glass { density 2500; }\n",
     "scene.dem, line 4: found end of file, expected } to close materials { of line 2"},
    {"n 3\nmaterials { glass { density 1; } }",
     "scene.dem, line 2: found { in the value of n, expected ; after \"n 3\"; end line 1 with ;"},
    {"n 3", "scene.dem, line 1: found end of file, expected ; after \"n 3\"; end line 1 with ;"},
    {"n", "scene.dem, line 1: found end of file, expected ; after \"n\"; end line 1 with ;"},
    {"n 3;\n}\n", "scene.dem, line 2: found } that no { opened; remove it"},
    {"solid materials { }",
     "scene.dem, line 1: { cannot follow \"solid materials\"; "
     "a dictionary has one name: name { ... }"},
    {"g (0 0\n -9.81;\nn 3;",
     "scene.dem, line 2: found ;, expected ) to close what line 1 opened in g"},
    {"g (0 0 -9.81]; ", "scene.dem, line 1: found ], expected ) to close what line 1 opened"},
    {"g 0 0 -9.81);", "scene.dem, line 1: found ) that nothing opened; remove it"},
    {"(1 2 3);",
     "scene.dem, line 1: found (, expected the name of an entry; write name value; "
     "or name { ... }"},
    {"n 1; /* two\nlines",
     "scene.dem, line 1: the comment /* that begins here is never closed; add */"},
    {"n 1;\nshape \"sphere;\nn 2;",
     "scene.dem, line 2: the string that begins here is not closed on its line; add \""},
    {"n ${a;", "scene.dem, line 1: expected } to close ${a"},
    {"shape #ff0000;",
     "scene.dem, line 1: #ff0000 cannot stand inside the value of shape; "
     "put it on a line of its own, "
     "between entries, or in quotes if it is a text"},
    /* macros and directives */
    {"radius 1;\nn $radios;",
     "scene.dem, line 2: nothing above this line defines $radios; did you mean $radius?"},
    {"n $zzz;", "scene.dem, line 1: nothing above this line defines $zzz; define it first"},
    {"n $ a;", "scene.dem, line 1: $ stands alone; write $name directly, without a space"},
    {"a 1;\n$a;",
     "scene.dem, line 2: $a is a value; only a dictionary can be inserted here. Write name $a;"},
    {"a { b { $a; } }", "scene.dem, line 1: $a; would insert the dictionary into itself"},
    {"a { x 1; }\nn 1 $a;",
     "scene.dem, line 2: $a is a dictionary, and n takes a value; write n { $a; } to insert it"},
    {"a { x 1; }\nb { $a }", "scene.dem, line 2: found }, expected ; after $a; end line 2 with ;"},
    {"#calc \"1+1\";",
     "scene.dem, line 1: #calc is not known here; "
     "of OpenFOAM's directives this reader has #include only"},
    {"#include \"x\"",
     "scene.dem, line 1: a text passed in memory cannot #include; expand it first"},
    {"#line 40 \"demProperties\"\nn 1\n;m",
     "demProperties, line 41: found end of file, expected ; after \"m\"; end line 41 with ;"},
    {"#line x", "scene.dem, line 1: write #line <number> \"file\""},
    /* values */
    {"\nmaterials\n{\n glass { young 1; }\n}",
     "scene.dem, line 4: materials/glass needs density (kg/m3)"},
    {"materials { }", "scene.dem, line 1: materials needs glass (a dictionary)"},
    {"materials 3;", "scene.dem, line 1: materials takes a dictionary { ... }, found \"3\""},
    {"materials { glass { density 2500\n young 1e7; } }",
     "scene.dem, line 1: materials/glass/density takes one number (kg/m3), found \"2500 young "
     "1e7\"; "
     "is a ; missing at the end of line 1?"},
    {"materials { glass { density 2500 young 1e7; } }",
     "scene.dem, line 1: materials/glass/density takes one number (kg/m3), found \"2500 young "
     "1e7\"; "
     "is a ; missing at the end of line 1?"},
    {"materials { glass { density 2500 kg; } }",
     "scene.dem, line 1: materials/glass/density takes one number (kg/m3), found \"2500 kg\""},
    {"materials { glass { young 1e7\n density 2500; } }",
     "scene.dem, line 1: materials/glass needs density (kg/m3); it is part of the value of young: "
     "is a ; missing at the end of line 1?"},
    {"materials { glass { density [0 1 0 0 0 0 0] 2500; } }",
     "scene.dem, line 1: materials/glass/density is in kg/m3, [1 -3 0 0 0 0 0], and has other dimensions; correct "
     "them and the value, or leave out [ ... ]"},
    {"materials { glass { density rho [1 -3 0 0] 2500; } }",
     "scene.dem, line 1: materials/glass/density is in kg/m3, [1 -3 0 0 0 0 0], and has other dimensions; correct "
     "them and the value, or leave out [ ... ]"},
    {"materials { glass { density [kg m^-3] 2500; } }",
     "scene.dem, line 1: materials/glass/density is in kg/m3, [1 -3 0 0 0 0 0], and has other dimensions; correct "
     "them and the value, or leave out [ ... ]"},
    {"materials [1 -3 0 0 0 0 0] 3;", "scene.dem, line 1: materials is read without dimensions; leave out [ ... ]"},
    {"materials { glass { density 2,5; } }",
     "scene.dem, line 1: materials/glass/density takes one number (kg/m3), found \"2,5\""},
    {"materials { glass { density 1e999; } }",
     "scene.dem, line 1: materials/glass/density takes one number (kg/m3), found \"1e999\""},
    {"materials { glass { density nan; } }",
     "scene.dem, line 1: materials/glass/density takes one number (kg/m3), found \"nan\""},
    {"materials { glass { density; } }",
     "scene.dem, line 1: materials/glass/density takes one number (kg/m3), found nothing"},
    {"materials { glass { density { } } }",
     "scene.dem, line 1: materials/glass/density takes one number (kg/m3), found a dictionary"},
    {"materials { glass { densitty 3; } }",
     "scene.dem, line 1: materials/glass needs density (kg/m3); "
     "is \"densitty\" in line 1 meant to be it?"},
    {"materials { glass { rho 3; } }",
     "scene.dem, line 1: materials/glass needs density (kg/m3); "
     "is \"rho\" in line 1 meant to be it?"},
    {"g (0 -9.81);", "scene.dem, line 1: g takes a vector (x y z) (m/s2), found \"( 0 -9.81 )\""},
    {"n 2.5;", "scene.dem, line 1: n takes one whole number, found \"2.5\""},
    {"n 1e300;", "scene.dem, line 1: n takes one whole number, found \"1e300\""},
    {"n 9223372036854775808;",
     "scene.dem, line 1: n takes one whole number, found \"9223372036854775808\""},
    {"on maybe;", "scene.dem, line 1: on takes yes or no (on, off, true, false), found \"maybe\""},
    {"shape a b;", "scene.dem, line 1: shape takes one word, found \"a b\""},
    {"radii 3 (1 2);",
     "scene.dem, line 1: the list radii is declared with length 3 and has 2 items; "
     "correct the length or leave it out"},
    {"radii (1 x);",
     "scene.dem, line 1: radii takes a list of numbers ( ... ) (m), found \"( 1 x )\""},
    /* fields */
    {"effects { dry {\nrestitution 1.5; } }",
     "scene.dem, line 2: effects/dry: restitution 1.5 is out of range; "
     "give a value from 0 to 1 (speed after over speed before)"},
    {"effects { dry {\nrestitutoin 0.5; } }",
     "scene.dem, line 1: effects/dry needs restitution; "
     "is \"restitutoin\" in line 2 meant to be it?"},
    /* entries that are not read */
    {"effects { dry { restitution 0.9;\n lawn 3; } }",
     "scene.dem, line 2: unknown entry \"lawn\" in effects/dry; "
     "did you mean law? known: law, on, count, direction, restitution"},
    {"walls ( floor { normal 1; } );",
     "scene.dem, line 1: unknown entry \"normal\" in walls/floor; remove it"},
};

static void refusals(void)
{
    for (size_t i = 0; i < sizeof bad/sizeof *bad; i++)
    {
        struct dem_dict *d = NULL;
        int status = dem_dict_read_text(&d, bad[i].text, "scene.dem");

        status = status == DEM_OK ? read_scene(d) : status;
        if (!TAP_OK(status == DEM_ERROR_INPUT && strcmp(dem_error_text(), bad[i].sentence) == 0,
                    "%s", bad[i].sentence))
        {
            printf("# found: %s\n", status == DEM_OK ? "nothing" : dem_error_text());
        }
        dem_dict_free(d);
    }
}

static void write_file(const char *path, const char *text)
{
    FILE *f = fopen(path, "w");

    if (f)
    {
        fputs(text, f);
        fclose(f);
    }
}

static void files(void)
{
    char folder[] = "/tmp/dictionary.XXXXXX", top[64], inner[64], sentence[256];
    struct dem_dict *d = NULL;
    double x = 0.0;

    TAP_OK(mkdtemp(folder) != NULL, "a folder for files");
    snprintf(top, sizeof top, "%s/scene.dem", folder);
    snprintf(inner, sizeof inner, "%s/glass.dem", folder);
    write_file(top, "d 3;\n#include \"glass.dem\"\nafter $density;\n");
    write_file(inner, "density $d;\n");
    TAP_OK(!dem_dict_read_file(&d, top) && !dem_dict_number(d, "after", "1", &x) && x == 3.0,
           "#include is relative to its file, and both see each other's entries");
    snprintf(sentence, sizeof sentence, "%s, line 1", inner);
    TAP_OK(dem_dict_count(d) == 3 && strcmp(dem_entry_where(dem_dict_entry(d, 1)), sentence) == 0,
           "an entry knows its file");
    dem_dict_free(d);

    write_file(inner, "\ndensity {");
    snprintf(sentence, sizeof sentence,
             "%s, line 2: found end of file, expected } to close density { of line 2", inner);
    TAP_OK(dem_dict_read_file(&d, top) == DEM_ERROR_INPUT && !d &&
               strcmp(dem_error_text(), sentence) == 0,
           "braces balance in each file: %s", dem_error_text());
    write_file(inner, "#include \"scene.dem\"\n");
    TAP_OK(dem_dict_read_file(&d, top) == DEM_ERROR_INPUT &&
               strstr(dem_error_text(), "include itself"),
           "a file that includes itself: %s", dem_error_text());
    remove(inner);
    TAP_OK(dem_dict_read_file(&d, top) == DEM_ERROR_FILE &&
               strstr(dem_error_text(), "line 2: cannot open"),
           "an absent file: %s", dem_error_text());
    remove(top);
    TAP_OK(dem_dict_read_file(&d, folder) == DEM_ERROR_FILE &&
               strstr(dem_error_text(), "cannot read"),
           "a folder: %s", dem_error_text());
    remove(folder);
}

static void limits(void)
{
    char *text = calloc(1, 1 << 16);
    struct dem_dict *d = NULL;
    char line[32];

    memset(text, '(', 70);
    memcpy(text, "n ", 2);
    TAP_OK(dem_dict_read_text(&d, text, "x") && strstr(dem_error_text(), "64 brackets"), "%s",
           dem_error_text());
    text[0] = '\0';
    for (int i = 0; i < 70; i++)
    {
        strcat(text, "n{");
    }
    TAP_OK(dem_dict_read_text(&d, text, "x") && strstr(dem_error_text(), "64 dictionaries"), "%s",
           dem_error_text());
    strcpy(text, "a0 1;");
    for (int i = 1; i < 40; i++)
    {
        snprintf(line, sizeof line, "a%d $a%d $a%d;", i, i - 1, i - 1);
        strcat(text, line);
    }
    TAP_OK(dem_dict_read_text(&d, text, "x") && strstr(dem_error_text(), "macros copy more"), "%s",
           dem_error_text());
    free(text);
}

int main(void)
{
    TAP_TRAPS;
    numbers();
    dimensions();
    words_and_vectors();
    lists();
    in_order();
    more();
    fields();
    refusals();
    files();
    limits();
    TAP_DONE;
}
