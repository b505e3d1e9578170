/*
 * regime.h -- dimensionless numbers of a scene, and verdicts on its effects.
 *
 * Formulas and sources of the numbers: regime.c; of the verdicts: verdicts.c and each effect.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "advisor/plan.h"

/* 1  Biot number above which a particle has no uniform temperature: Incropera and DeWitt,
   Fundamentals of Heat and Mass Transfer, section 5.1 */
#define DEM_BIOT_LIMIT 0.1

enum
{
    DEM_MAX_VERDICTS = 24
};

enum dem_verdict_word
{
    DEM_NEEDED,      /* on, and needed */
    DEM_NEGLIGIBLE,  /* on, but negligible */
    DEM_MISSING      /* off, though the scene needs it */
};

struct dem_verdict    /* whether the scene needs one effect */
{
    const char *effect;           /* its name */
    enum dem_verdict_word word;
    double fraction;              /* 1  its fraction of the quantity that `why` names */
    char why[200];                /* the reason, and the source of the threshold */
    const char *replaces;         /* the effect that a DEM_MISSING one replaces, or NULL */
    const char *missing_setting;  /* the setting that the user must give for it, or NULL */
};

struct dem_verdicts
{
    struct dem_verdict verdict[DEM_MAX_VERDICTS];
    int n;
};

/* Fills in the numbers that are known. */
void dem_regime_set(const struct dem_plan *, struct dem_regime *);

/* A verdict on each effect that is in use, and on each one that is not and is called for. */
void dem_verdicts(const struct dem_plan *, const struct dem_regime *, struct dem_verdicts *);
