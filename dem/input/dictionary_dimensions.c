/*
 * dictionary_dimensions.c -- compare the dimensions [1 -3 0 0 0 0 0] of a value, as OpenFOAM writes them, with
 * the unit that the entry takes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary_tree.h"

#include "core/error.h"

#include <string.h>

enum
{
    BASE = 4,                 /* kg, m, s, K */
    DIMENSIONS = 7            /* of OpenFOAM, which may leave out the last two */
};

static const struct
{
    const char *name;
    int power[BASE];
} units[] = {
    {"1", {0, 0, 0, 0}},   {"rad", {0, 0, 0, 0}}, {"kg", {1, 0, 0, 0}},  {"m", {0, 1, 0, 0}},
    {"s", {0, 0, 1, 0}},   {"K", {0, 0, 0, 1}},   {"N", {1, 1, -2, 0}},  {"Pa", {1, -1, -2, 0}},
    {"J", {1, 2, -2, 0}},  {"W", {1, 2, -3, 0}}};

/* Add `sign` times the powers of a unit of this length, or return false. */
static bool add_unit(const char *unit, size_t length, int sign, int power[BASE])
{
    for (size_t k = 0; k < sizeof units/sizeof *units; k++)
    {
        if (strlen(units[k].name) == length && memcmp(units[k].name, unit, length) == 0)
        {
            for (int i = 0; i < BASE; i++)
            {
                power[i] += sign*units[k].power[i];
            }
            return true;
        }
    }
    return false;
}

/* Powers of a unit such as "kg/m3" or "W/(m K)"; false if the text is none. */
static bool read_unit(const char *unit, int power[BASE])
{
    int sign = 1;

    memset(power, 0, BASE*sizeof *power);
    while (*unit)
    {
        const size_t length = strspn(unit, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
        const size_t size = length > 0 ? length : strspn(unit, "1");
        const char digit = unit[size];
        const bool has_power = length > 0 && digit >= '2' && digit <= '9';

        if (size == 0 || !add_unit(unit, size, has_power ? sign*(digit - '0') : sign, power))
        {
            return false;
        }
        unit += size + has_power;
        sign = *unit == '/' ? -1 : sign;
        unit += strspn(unit, "/( )");
    }
    return true;
}

/* Set the cursor behind the [ of the dimensions, if the value has some. */
static bool find_dimensions(const struct dem_entry *e, struct dem_cursor *c)
{
    *c = (struct dem_cursor){e->tokens, e->tokens + e->count};
    dem_dict_skip_dimensions(c);
    for (c->end = c->at, c->at = e->tokens; c->at < c->end && !dem_dict_is_sign(c->at, '['); c->at++)
    {
    }
    return dem_dict_take_sign(c, '[');
}

int dem_dict_check_dimensions(const struct dem_entry *e, const char *unit)
{
    const char *const path = dem_dict_path(e->parent), *const slash = *path ? "/" : "";
    struct dem_cursor c;
    int power[BASE], n = 0, same = 1;
    double value;

    if (!find_dimensions(e, &c))
    {
        return DEM_OK;
    }
    DEM_REQUIRE(unit && *unit && read_unit(unit, power), DEM_ERROR_INPUT,
                "%s: %s%s%s is read without dimensions; leave out [ ... ]", dem_entry_where(e), path, slash, e->name);
    for (; dem_dict_take_number(&c, &value); n++)
    {
        same &= value == (n < BASE ? power[n] : 0.0);
    }
    DEM_REQUIRE(same && (n == DIMENSIONS || n == DIMENSIONS - 2) && dem_dict_is_sign(c.at, ']'), DEM_ERROR_INPUT,
                "%s: %s%s%s is in %s, [%d %d %d %d 0 0 0], and has other dimensions; correct them and the value, or "
                "leave out [ ... ]", dem_entry_where(e), path, slash, e->name, unit, power[0], power[1], power[2],
                power[3]);
    return DEM_OK;
}
