/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "locate/demLocator.C"
#include "locate/demLocatorTets.C"
#include "locate/demLocatorWalk.C"
#include "locate/demSlidingInterface.C"
#include "locate/demParticleRouting.C"
#include "locate/demParticleRoutingQuery.C"
#include "locate/demParticleRoutingMap.C"
#include "locate/demWedge.C"
