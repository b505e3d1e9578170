/*
 * test_settings.c -- wrong settings of every effect, in `effects` and in `pairs`, and laws that
 * exclude or need each other are refused by one sentence with line, names, limits and cure.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "core/aliases.h"
#include "laws/effects.h"

/* text of a setting in place of a valid value; NULL: left out */
struct fault
{
    const struct dem_setting *field;
    const char *value;
};

/* a value in the middle of the range; all different, as some must be above others */
static double valid_value(const struct dem_setting *f, int unlike)
{
    return (f->min > 0.5 ? 2.0*f->min : fmin(0.4*f->max, 0.4)) + 0.01*unlike;
}

/* NAME { settings } with the fault */
static void write_effect(char *text, size_t capacity, const struct dem_effect *e, struct fault fault)
{
    size_t at = (size_t)snprintf(text, capacity, "%s { ", e->name);
    int unlike = 0;

    for (const struct dem_setting *f = e->settings; f && f->name; f++)
    {
        const int required = isnan(f->default_value);
        const char *const three = f->kind == DEM_SETTING_VECTOR ? "(0.1 0.2 0.3)" : NULL;

        if (f == fault.field)
        {
            at += (size_t)(fault.value
                               ? snprintf(text + at, capacity - at, "%s %s; ", f->name, fault.value)
                               : 0);
        }
        else if (required && three)
        {
            at += (size_t)snprintf(text + at, capacity - at, "%s %s; ", f->name, three);
        }
        else if (required && f->kind == DEM_SETTING_NUMBER)
        {
            at += (size_t)snprintf(text + at, capacity - at, "%s %g; ", f->name, valid_value(f, unlike++));
        }
        else if (required)
        {
            at += (size_t)snprintf(text + at, capacity - at, "%s %s; ", f->name,
                                   f->kind == DEM_SETTING_SWITCH ? "yes" : f->choices[0]);
        }
    }
    snprintf(text + at, capacity - at, "} ");
}

/* a normal law, where an effect needs one; hertz can be combined with all */
static const char *normal_law_for(const struct dem_effect *e)
{
    return e->stage < DEM_STAGE_BODY && e->stage != DEM_STAGE_NORMAL ? "hertz { } " : "";
}

/* 0, or the status of a scene with these effects; line 3 holds them */
static int scene(const char *effects, const char *pairs)
{
    char *const text = world_text(
        "materials { glass { density 2500; youngsModulus 1e7; conductivity 1; heatCapacity 800; "
        "emissivity 0.9; } }\nfluid { density 1000; viscosity 1e-3; }\n"
        "effects { %s }\n pairs { %s }\n time { step 1e-9; }",
        effects, pairs);
    const struct dem_new_particle seed = {.diameter = 1e-3, .material = "glass"};
    struct dem_case *c;
    struct dem *d = NULL;

    WORLD_TRY(dem_case_create(&c, MPI_COMM_NULL));
    int status = dem_case_scene_text(c, text, "scene");

    status = status ? status : dem_case_add_particles(c, 1, &seed);
    status = status ? status : dem_start(&c, &d);
    dem_case_free(c);
    dem_free(d);
    return status;
}

/* refused, and the sentence holds all these words */
static void refused(int status, const char *what, const char *where, const char *const words[5])
{
    int all = status != 0;

    for (int k = 0; k < 5; k++)
    {
        all &= !words[k] || strstr(dem_error_text(), words[k]);
    }
    all &= strchr(dem_error_text(), '\n') == NULL;        /* one sentence */
    if (!TAP_OK(all, "%s%s", what, where))
    {
        TAP_NOTE("status %d: %s", status, dem_error_text());
    }
}

static void try_fault(const struct dem_effect *e, struct fault fault, const char *limit,
                     const char *cure)
{
    char bad[1024], fine[1024], effects[2048], what[256];
    const char *const words[5] = {e->name, fault.field->name, fault.value, limit, cure};

    write_effect(bad, sizeof bad, e, fault);
    write_effect(fine, sizeof fine, e, (struct fault){0});
    snprintf(effects, sizeof effects, "%s%s", normal_law_for(e), bad);
    snprintf(what, sizeof what, "%s %s %s", e->name, fault.field->name,
             fault.value ? fault.value : "left out");
    refused(scene(effects, ""), what, "", words);
    if (e->stage < DEM_STAGE_BODY && fault.value)
    {
        char pair[1024];

        snprintf(effects, sizeof effects, "%s%s", normal_law_for(e), fine);
        snprintf(pair, sizeof pair, "p { between (glass glass); %s { %s %s; } }", e->name,
                 fault.field->name, fault.value);
        refused(scene(effects, pair), what, " in a pair", words);
    }
}

static const char *printed(char *text, size_t capacity, const struct dem_setting *f, double value)
{
    snprintf(text, capacity, f->kind == DEM_SETTING_VECTOR ? "( 0 0 %.10g )" : "%.10g", value);
    return text;
}

static void numbers(const struct dem_effect *e, const struct dem_setting *f)
{
    char value[64], limit[64];

    if (f->min > -DBL_MAX)
    {
        const int above = f->min == DEM_ABOVE_ZERO;
        const double least = above ? 0.0 : f->min;

        printed(limit, sizeof limit, f, least);
        try_fault(e, (struct fault){f, printed(value, sizeof value, f, above ? 0.0 : least - 0.5)},
                 above ? "above 0" : limit, "give a value");
        try_fault(e, (struct fault){f, printed(value, sizeof value, f, least - 1e3)},
                 above ? "above 0" : limit, "give a value");
    }
    if (f->max < DBL_MAX)
    {
        printed(limit, sizeof limit, f, f->max);
        try_fault(e, (struct fault){f, printed(value, sizeof value, f, f->max*1.01)}, limit,
                 "give a value");
    }
    if (f->flags & DEM_SETTING_WHOLE)
    {
        try_fault(e, (struct fault){f, "1.5"}, "whole", "give a value");
    }
    try_fault(e, (struct fault){f, f->kind == DEM_SETTING_VECTOR ? "( 0 0 nan )" : "nan"}, "takes",
             NULL);
    try_fault(e, (struct fault){f, f->kind == DEM_SETTING_VECTOR ? "( 0 0 inf )" : "-inf"}, "takes",
             NULL);
    try_fault(e, (struct fault){f, "plenty"}, "takes", NULL);
    try_fault(e, (struct fault){f, f->kind == DEM_SETTING_VECTOR ? "3" : "( 1 2 )"}, "takes", NULL);
}

/* the limits of the range are accepted: no sentence about that setting */
static void ends(const struct dem_effect *e, const struct dem_setting *f)
{
    const double end[2] = {f->min, f->max};

    for (int k = 0; k < 2; k++)
    {
        char value[64], effect[1024], effects[2048], sentence[128];

        if (f->kind != DEM_SETTING_NUMBER || !(fabs(end[k]) < DBL_MAX) || end[k] == DEM_ABOVE_ZERO)
        {
            continue;
        }
        write_effect(effect, sizeof effect, e,
                     (struct fault){f, printed(value, sizeof value, f, end[k])});
        snprintf(effects, sizeof effects, "%s%s", normal_law_for(e), effect);
        snprintf(sentence, sizeof sentence, "%s %s is out of range", f->name, value);
        TAP_OK(scene(effects, "") == 0 || !strstr(dem_error_text(), sentence),
               "%s %s %s is in range", e->name, f->name, value);
    }
}

static void all_settings(const struct dem_effect *e)
{
    for (const struct dem_setting *f = e->settings; f && f->name; f++)
    {
        if (f->kind == DEM_SETTING_NUMBER || f->kind == DEM_SETTING_VECTOR)
        {
            numbers(e, f);
            ends(e, f);
        }
        else
        {
            try_fault(e, (struct fault){f, "perhaps"},
                     f->kind == DEM_SETTING_SWITCH ? "yes" : f->choices[0], "known");
            try_fault(e, (struct fault){f, "12.5"}, NULL, NULL);
        }
        if (isnan(f->default_value))
        {
            try_fault(e, (struct fault){f, NULL}, "no value", "give");
        }
    }
}

/* ---- effects that exclude each other ------------------------------------------------------ */

static int same_kind(const struct dem_effect *a, const struct dem_effect *b)
{
    return (a->stage == b->stage && a->stage <= DEM_STAGE_TANGENT) || (a->drag && b->drag);
}

static int twice(const struct dem_effect *a, const struct dem_effect *b)
{
    return (a->excludes && dem_alias_is_among(a->excludes, b->name)) ||
           (b->excludes && dem_alias_is_among(b->excludes, a->name));
}

static void contradiction(const struct dem_effect *a, const struct dem_effect *b)
{
    char one[1024], other[1024], effects[4096];
    const struct dem_effect *const first = a->stage <= b->stage ? a : b;
    const char *const words[5] = {a->name, b->name, same_kind(a, b) ? "one of them" : NULL, NULL,
                                  NULL};
    char what[128];

    write_effect(one, sizeof one, a, (struct fault){0});
    write_effect(other, sizeof other, b, (struct fault){0});
    snprintf(effects, sizeof effects, "%s%s%s",
             first->stage == DEM_STAGE_NORMAL ? "" : normal_law_for(first), one, other);
    snprintf(what, sizeof what, "%s with %s", a->name, b->name);
    if (same_kind(a, b) || twice(a, b))
    {
        refused(scene(effects, ""), what, "", words);
    }
}

/* laws that act on a contact's force, without a normal law */
static void without_normal_law(const struct dem_effect *e)
{
    char effect[1024], what[128];
    const char *const words[5] = {e->name, "normal law", "add", NULL, NULL};

    write_effect(effect, sizeof effect, e, (struct fault){0});
    snprintf(what, sizeof what, "%s without a normal law", e->name);
    refused(scene(effect, ""), what, "", words);
}

int main(void)
{
    int settings = 0, contradictions = 0;

    TAP_TRAPS;
    for (const struct dem_effect *const *e = dem_effects; *e; e++)
    {
        all_settings(*e);
        for (const struct dem_setting *f = (*e)->settings; f && f->name; f++)
        {
            settings++;
        }
        if ((*e)->stage == DEM_STAGE_DAMP || (*e)->stage == DEM_STAGE_TANGENT ||
            (*e)->stage == DEM_STAGE_MOMENT)
        {
            without_normal_law(*e);
        }
        for (const struct dem_effect *const *o = dem_effects; *o != *e; o++)
        {
            contradiction(*o, *e);
            contradictions += same_kind(*o, *e) || twice(*o, *e);
        }
    }
    TAP_OK(settings > 40 && contradictions > 40, "%d settings, %d contradictions", settings,
           contradictions);
    TAP_DONE;
}
