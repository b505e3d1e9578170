/*
 * scene_text.h -- parts of dem_scene_text.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "case/simulation.h"

/* Append the paragraph of streams and outlets; nothing without any. */
void dem_flows_text_add(struct dem_text *, const struct dem *);
