/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/demParticles.C"
#include "particles/demParticlesReport.C"
#include "particles/demPassedWalls.C"
#include "particles/demVoidFraction.C"
#include "particles/demVoidFractionFlux.C"
#include "particles/demSettle.C"
