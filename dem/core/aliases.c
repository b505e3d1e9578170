/*
 * aliases.c -- table of Suna's words and the words of other codes for them.
 *
 * The codes are LIGGGHTS, LAMMPS, CFDEMcoupling, MFiX, MercuryDPM and the Lagrangian clouds of OpenFOAM. Upper and
 * lower case are different: E is a modulus and e a restitution. A foreign word may stand in several
 * rows; the caller asks about one word of Suna at a time, so the words that are valid where the
 * foreign word was found decide between the rows.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/aliases.h"

#include <stddef.h>
#include <string.h>

static const struct
{
    const char *ours;
    const char *foreign;    /* words separated by blanks */
    const char *note;       /* appended to "did you mean ..."; mostly empty */
} aliases[] = {
    {"restitution",
     "coefficientOfRestitution coefficientRestitution restitutionCoefficient COR cor e en", ""},
    {"youngsModulus", "E Y youngModulus elasticModulus modulus", ""},
    {"poissonsRatio", "nu poisson poissonRatio", ""},
    {"friction", "mu mus mu_s coefficientOfFriction coefficientFriction frictionCoefficient", ""},
    {"density", "rho rho0 rhop rho_p ro_s0", ""},
    {"diameter", "d d0 dp d_p0 diam", ""},
    {"diameter", "radius r rp", ", twice the radius"},
    {"velocity", "U U0 u v vel", ""},
    {"spin", "omega angularVelocity", ""},
    {"acceleration", "g gravity", ""},
    {"viscosity", "mu muf mu_g0 dynamicViscosity", ""},
    {"viscosity", "nu kinematicViscosity", ", nu times the density"},
    {"voidFraction", "alpha alphac epsilon porosity voidage", ""},
    {"count", "n N number nParticles", ""},
    {"end", "endTime stopTime tstop", ""},
    {"step", "dt deltaT timestep timeStep", ""},
    {"interval", "writeInterval outputInterval every", ""},
    {"folder", "dir directory", ""},
    {"insert", "injection injectionModels particles", ""},
    {"write", "output dump", ""},
    {"stiffness", "kn kt k springConstant", ""},
    {"impactSpeed", "characteristicVelocity characteristicSpeed", ""},
    {"adhesion", "kn2kc", ""},
    {"unloading", "kn2k2Max kn2k2max", ""},
    {"plasticDepth", "phiF phi_F", ""},
    {"energyDensity", "cohesionEnergyDensity", ""},
    {"parcels", "coarsegraining coarseGraining coarsegrain coarseGrain CGP", ""},
    {"shape", "clump template", ""},
    {"shapes", "clumps templates", ""},
    {"meanDiameter", "sauter d32 d_32", ""},
    {"divided", "dividedVoidFraction bigParticle bigParticleVoidFraction", ""},
    {"particleCentre", "centre center centreVoidFraction", ""},
    {"gaussian", "Gauss GaussVoidFraction gaussianKernel", ""},
    {"linear", "trilinear", ""},
    {"kernel", "voidFractionModel voidfractionModel", ""},
    {"equations", "modelType", ""},
    {"II", "A modelA", ", model A"},
    {"I", "Bfull modelBfull", ", model Bfull"},
    {"III", "B modelB", ", model B"},
};

int dem_alias_is_among(const char *words, const char *word)
{
    const size_t n = strlen(word);

    for (const char *at = words; n > 0 && at; at = strchr(at, ' '))
    {
        at += *at == ' ';
        if (strncmp(at, word, n) == 0 && (at[n] == ' ' || at[n] == '\0'))
        {
            return 1;
        }
    }
    return 0;
}

const char *dem_alias_note(const char *foreign, const char *ours)
{
    for (size_t k = 0; k < sizeof aliases/sizeof *aliases; k++)
    {
        if (strcmp(aliases[k].ours, ours) == 0 && dem_alias_is_among(aliases[k].foreign, foreign))
        {
            return aliases[k].note;
        }
    }
    return NULL;
}
