/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cloud/demProfile.C"
#include "cloud/demReports.C"
#include "cloud/demLastGood.C"
#include "cloud/demCloud.C"
#include "cloud/demTimeStepControl.C"
