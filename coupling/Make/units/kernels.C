/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "kernels/demLinearWeights.C"
#include "kernels/demLinearWeightsOwn.C"
#include "kernels/demEvenBed.C"
#include "kernels/demSmoother.C"
#include "kernels/demSmootherLumps.C"
#include "kernels/demKernel.C"
