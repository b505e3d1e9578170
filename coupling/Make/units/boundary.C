/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "boundary/demWalls.C"
#include "boundary/demRegions.C"
#include "boundary/demOutletPatch.C"
#include "boundary/demPatchTriangles.C"
#include "boundary/demInletsOutlets.C"
#include "boundary/demInletsOutletsJudge.C"
