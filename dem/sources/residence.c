/*
 * residence.c -- sums of the ages of particles at outlets, and their lines in snapshots: see residence.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/residence.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/text.h"
#include "ranks/dem_state.h"
#include "sources/flows.h"
#include <math.h>
#include <string.h>

static const char mark[] = "@residence ";

/* s  the upper end of the histogram of a flow; 0: it does not ask */
static double end_of(const struct dem_flows *f, int flow)
{
    const int outlet = flow - f->plan->streams;

    return outlet >= 0 && outlet < f->plan->outlets ? f->plan->outlet[outlet].residence : 0.0;
}

const struct dem_residence *dem_residence_of(const struct dem_flows *f, int flow)
{
    return f->residence && end_of(f, flow) > 0.0 ? &f->residence[flow] : NULL;
}

enum
{
    HEAD = 4
};

/* end n sum squares b0 b1 ...; below 2^53 all are exact as doubles. With another end all begin anew, since bins of
   two widths have no sum. */
static void resume(struct dem_residence *r, const char *words)
{
    double x[HEAD + DEM_RESIDENCE_BINS];

    if (dem_text_numbers(words, x, HEAD + DEM_RESIDENCE_BINS) == HEAD + DEM_RESIDENCE_BINS && x[0] == r->end)
    {
        r->particles = (int64_t)x[1];
        r->sum = x[2];
        r->squares = x[3];
        for (int b = 0; b < DEM_RESIDENCE_BINS; b++)
        {
            r->bin[b] = (int64_t)x[HEAD + b];
        }
    }
}

int dem_residence_begin(struct dem_state *state, const char *text)
{
    struct dem_flows *const f = state->flows;

    if (!dem_column(&state->particles, DEM_COLUMN_BIRTH))
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(f->residence, 2*DEM_SNAPSHOT_FLOWS));
    for (int k = 0; k < f->n; k++)
    {
        const char *words, *rest;

        f->residence[k].end = end_of(f, k);
        for (const char *at = text; end_of(f, k) > 0.0 && (words = dem_text_marked(&at, mark));)
        {
            if ((rest = dem_text_after(words, f->flow[k].name)))
            {
                resume(&f->residence[k], rest);
            }
        }
    }
    return DEM_OK;
}

void dem_residence_free(struct dem_flows *f)
{
    dem_memory_free(f->residence);
}

void dem_residence_record(struct dem_state *state, size_t i)
{
    const double *const birth = dem_column(&state->particles, DEM_COLUMN_BIRTH);

    if (birth && dem_clump_counts(&state->particles.record[i]))
    {
        state->flows->departure[state->flows->departures - 1].age = state->time - birth[i];
    }
}

void dem_residence_add(struct dem_flows *f, int flow, double age)
{
    const double end = f->residence ? end_of(f, flow) : 0.0;

    if (end > 0.0)
    {
        struct dem_residence *const r = &f->residence[flow];
        const double bin = floor(age/end*DEM_RESIDENCE_BINS);

        r->particles++;
        r->sum += age;
        r->squares += age*age;
        r->bin[(int)fmax(0.0, fmin(bin, DEM_RESIDENCE_BINS - 1))]++;
    }
}

void dem_residence_backup(struct dem_flows *f)
{
    if (f->residence)
    {
        memcpy(f->residence + DEM_SNAPSHOT_FLOWS, f->residence, DEM_SNAPSHOT_FLOWS*sizeof *f->residence);
    }
}

void dem_residence_restore(struct dem_flows *f)
{
    if (f->residence)
    {
        memcpy(f->residence, f->residence + DEM_SNAPSHOT_FLOWS, DEM_SNAPSHOT_FLOWS*sizeof *f->residence);
    }
}

/* ---- snapshots ------------------------------------------------------------------------------- */

void dem_residence_describe(const struct dem_flows *f, struct dem_text *t)
{
    for (int k = 0; f->residence && k < f->n; k++)
    {
        const struct dem_residence *const r = dem_residence_of(f, k);

        if (r)
        {
            dem_text_add(t, "%s%s %a %lld %a %a", mark, f->flow[k].name, r->end, (long long)r->particles, r->sum,
                         r->squares);
            for (int b = 0; b < DEM_RESIDENCE_BINS; b++)
            {
                dem_text_add(t, " %lld", (long long)r->bin[b]);
            }
            dem_text_add(t, "\n");
        }
    }
}
