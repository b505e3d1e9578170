/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "transfer/demOverpackingLimiter.C"
#include "transfer/demOverpackingLimiterTransport.C"
#include "transfer/demTransfer.C"
