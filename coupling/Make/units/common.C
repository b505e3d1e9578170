/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "common/demCellTree.C"
#include "common/demStop.C"
#include "common/demRankBuffers.C"
#include "common/demSelfCheck.C"
