/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "footprints/demFootprint.C"
#include "footprints/demFootprintRemote.C"
#include "footprints/demSphereKernel.C"
#include "footprints/demGaussianKernel.C"
