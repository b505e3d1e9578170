/*
 * habits.c -- the table: what users of LIGGGHTS, LAMMPS, MFiX, MercuryDPM and of OpenFOAM's clouds write by habit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Letters count with their case: E is a modulus and e a restitution. A foreign word may stand in several rows; the word
 * that is known where it was written decides.
 */
#include "base/habits.h"

#include <stddef.h>
#include <string.h>

static const struct
{
    const char *ours, *foreign;    /* words between blanks */
    const char *note;
} habits[] =
{
    {"restitution", " coefficientOfRestitution coefficientRestitution restitutionCoefficient COR cor e en ", ""},
    {"youngsModulus", " E Y youngModulus elasticModulus modulus ", ""},
    {"poissonsRatio", " nu poisson poissonRatio ", ""},
    {"friction", " mu mus mu_s coefficientOfFriction coefficientFriction frictionCoefficient ", ""},
    {"density", " rho rho0 rhop rho_p ro_s0 ", ""},
    {"diameter", " d d0 dp d_p0 diam ", ""},
    {"diameter", " radius r rp ", ", twice the radius"},
    {"velocity", " U U0 u v vel ", ""},
    {"spin", " omega angularVelocity ", ""},
    {"acceleration", " g gravity ", ""},
    {"viscosity", " mu muf mu_g0 dynamicViscosity ", ""},
    {"viscosity", " nu kinematicViscosity ", ", nu times the density"},
    {"voidFraction", " alpha alphac epsilon porosity voidage ", ""},
    {"count", " n N number nParticles ", ""},
    {"end", " endTime stopTime tstop ", ""},
    {"step", " dt deltaT timestep timeStep ", ""},
    {"interval", " writeInterval outputInterval every ", ""},
    {"folder", " dir directory ", ""},
    {"insert", " injection injectionModels particles ", ""},
    {"write", " output dump ", ""},
    {"hertz", " hertzMindlin pairSpringSliderDashpot ", ""},
    {"hooke", " lsd LSD linearSpringDashpot springDashpot ", ""},
    {"hookeHysteresis", " hooke/hysteresis luding elastoPlastic ", ""},
    {"mindlinIncremental", " mindlin_rescale mindlin/rescale ", ""},
    {"linear", " linear_history linearHistory ", ""},
    {"sjkr", " sjkr2 cohesion ", ""},
    {"stiffness", " kn kt k springConstant ", ""},
    {"impactSpeed", " characteristicVelocity characteristicSpeed ", ""},
    {"adhesion", " kn2kc ", ""},
    {"unloading", " kn2k2Max kn2k2max ", ""},
    {"plasticDepth", " phiF phi_F ", ""},
    {"energyDensity", " cohesionEnergyDensity ", ""},
    {"meanDiameter", " sauter d32 d_32 ", ""},
    {"dry", " dashpot ", ""},
    {"pressureGradient", " buoyancy archimedes pressureGradientForce ", ""},
    {"gidaspow", " ErgunWenYu ErgunWenYuDrag ergunWenYu ", ""},
    {"wenYu", " WenYuDrag ", ""},
    {"ergun", " ErgunDrag ", ""},
    {"diFelice", " DiFelice DiFeliceDrag ", ""},
    {"rong", " RongDrag ", ""},
    {"kochHill", " KochHill KochHillDrag HillKochLadd ", ""},
    {"beetstra", " Beetstra BeetstraDrag BVK ", ""},
    {"schillerNaumann", " sphereDrag SphereDrag ", ""},
    {"rollingSpring", " rollingFriction epsd epsd2 ", ""},
    {"rollingConstant", " cdt ", ""},
};

/* Is the word one of those between blanks? */
static int is_among(const char *words, const char *word)
{
    const size_t n = strlen(word);

    for (const char *at = strchr(words, ' '); n > 0 && at && at[1]; at = strchr(at + 1, ' '))
    {
        if (strncmp(at + 1, word, n) == 0 && at[n + 1] == ' ')
        {
            return 1;
        }
    }
    return 0;
}

const char *dem_habit(const char *foreign, const char *ours)
{
    for (size_t k = 0; k < sizeof habits/sizeof *habits; k++)
    {
        if (strcmp(habits[k].ours, ours) == 0 && is_among(habits[k].foreign, foreign))
        {
            return habits[k].note;
        }
    }
    return NULL;
}
