/*
 * profile_text.c -- write the profile of a run as a short table.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "core/error.h"
#include "dem_query.h"
#include "ranks/collect.h"
#include "records/run_profile.h"

static double ratio(double a, double b)
{
    return b > 0.0 ? a/b : 0.0;
}

/* Phases that took less than 0.1 % of the time are left out. */
static void write_phases(struct dem_text *t, const struct dem_profile *f)
{
    dem_text_add(t,
                 "profile: wall clock %s, processor %s, %lld steps\n"
                 "    %-12s  share  time%s\n",
                 dem_text_time(f->wall), dem_text_time(f->processor), (long long)f->steps, "phase",
                 f->ranks > 1 ? "       of the slowest rank" : "");
    for (int k = 0; k < DEM_PROFILE_PHASES; k++)
    {
        const double fraction = ratio(f->phase[k].mean, f->wall);

        if (fraction >= 1e-3)
        {
            dem_text_add(t, f->ranks > 1 ? "    %-12s %5.1f %%  %-10s %s\n" : "    %-12s %5.1f %%  %s\n",
                         f->phase[k].name, 100.0*fraction, dem_text_time(f->phase[k].mean),
                         dem_text_time(f->phase[k].max));
        }
    }
}

static void write_interval(struct dem_text *t, const char *what, int64_t times, int64_t steps)
{
    dem_text_add(t, "%s %lld times", what, (long long)times);
    if (times > 0)
    {
        dem_text_add(t, ", every %.4g steps", (double)steps/(double)times);
    }
}

static void write_ranks(struct dem_text *t, const struct dem_profile *f)
{
    const double per_step_and_rank = ratio(1.0, (double)f->steps*f->ranks);

    dem_text_add(
        t,
        "    ranks: maximum over mean work %.3g; a step and rank: %.3g messages, %s, "
        "%.3g all-reduces; a rebuild and rank: %.3g messages, %s; repartitioned %d times\n",
        f->imbalance, (double)f->messages*per_step_and_rank,
        dem_text_bytes((double)f->message_bytes*per_step_and_rank),
        ratio((double)f->agreements, (double)f->steps),
        ratio((double)f->rebuild_messages, (double)f->rebuilds*f->ranks),
        dem_text_bytes(ratio((double)f->rebuild_message_bytes, (double)f->rebuilds*f->ranks)),
        f->cuts);
}

static void write_profile(struct dem_text *t, const struct dem_profile *f)
{
    const double seconds = f->wall - f->outside,
                 speed = 1e-6*ratio((double)f->particle_steps, seconds);

    dem_text_add(t, "%s", "");
    if (f->steps == 0)
    {
        return;
    }
    write_phases(t, f);
    dem_text_add(t, "    speed: %.4g million particle-steps/s", speed);
    dem_text_add(t, f->ranks > 1 ? ", %.4g a core\n" : "\n", speed/f->ranks);
    write_interval(t, "    lists: rebuilt", f->rebuilds, f->steps);
    write_interval(t, ", pruned", f->prunes, f->steps);
    dem_text_add(t, "; skins %.3g and %.3g diameters\n", ratio(f->outer_skin, f->diameter),
                 ratio(f->inner_skin, f->diameter));
    dem_text_add(t, "    a particle: %.3g contacts, %.3g candidate contacts, %.4g bytes\n",
                 ratio((double)f->contacts, (double)f->particles),
                 ratio((double)f->row_steps, (double)f->particle_steps),
                 ratio(f->bytes, (double)f->particles));
    dem_text_add(t, "    accuracy: largest overlap %.3g %% of a diameter\n",
                 100.0*f->largest_overlap);
    if (f->ranks > 1)
    {
        write_ranks(t, f);
    }
}

int dem_profile(struct dem *d, struct dem_profile *profile)
{
    dem_profile_take(&d->state, profile);
    return dem_collect_status(&d->state.decomposition);
}

int dem_profile_text(struct dem *d, const char **text)
{
    struct dem_profile profile;

    DEM_TRY(dem_profile(d, &profile));
    dem_text_free(&d->profile);
    write_profile(&d->profile, &profile);
    *text = d->profile.text;
    return d->profile.status;
}
