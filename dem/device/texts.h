/*
 * texts.h -- texts of the library that devices compile: headers of the core, and the files *.cl of
 * this folder. The build writes them into texts.c of the build folder.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

struct dem_device_text
{
    const char *name;             /* as in #include */
    const char *text;
};

/* All of them, ended by NULL. */
extern const struct dem_device_text dem_device_texts[];
