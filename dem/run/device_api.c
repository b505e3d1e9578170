/*
 * device_api.c -- what makes the steps of a run; the devices of this machine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "core/error.h"
#include "device/device_steps.h"
#include "device/opencl_device.h"

const char *dem_device(const struct dem *d)
{
    return d->device;
}

int dem_device_keep_contacts(struct dem *d)
{
    return d->state.device ? dem_sim_agree(d, dem_device_keep(&d->state)) : DEM_OK;
}

double dem_device_bytes(const struct dem *d)
{
    return d->state.device ? dem_device_memory(&d->state) : 0.0;
}

void dem_device_steps(const struct dem *d, int64_t *made, int64_t *parts, int64_t *repeated)
{
    struct dem_device_counts c = {.steps = 0};

    if (d->state.device)
    {
        dem_device_count(d->state.device, &c);
    }
    *made = c.steps;
    *parts = c.parts;
    *repeated = c.repeated;
}

const char *dem_devices_text(void)
{
    static _Thread_local struct dem_text text;
    struct dem_opencl_info info[DEM_OPENCL_DEVICES];
    int n;

    dem_text_free(&text);
    if (dem_opencl_list(info, &n) != DEM_OK)
    {
        dem_text_add(&text, "%s\n", dem_error_text());
    }
    for (int k = 0; k < n; k++)
    {
        dem_text_add(&text, "%s  (%s, driver %s)  %s, %d units, %s%s\n", info[k].name,
                     info[k].platform, info[k].driver, info[k].gpu ? "GPU" : "no GPU",
                     info[k].units, dem_text_bytes(info[k].memory),
                     info[k].doubles ? "" : ", no double precision");
    }
    return text.status ? "" : text.text;
}
