/*
 * profile.c -- figures into a short table.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/profile.h"
#include "base/error.h"
#include <string.h>

static double ratio(double a, double b)
{
    return b > 0.0 ? a/b : 0.0;
}

/* Phases that took less than a thousandth are left out. */
static void tell_phases(struct dem_text *t, const struct dem_profile *f)
{
    dem_text_add(t, "profile: %s of clock, %s of processor, %lld steps\n    %-12s  share  time%s\n", dem_text_time(f->wall),
                 dem_text_time(f->processor), (long long)f->steps, "phase", f->ranks > 1 ? "      of the slowest rank" : "");
    for (int k = 0; k < DEM_PROFILE_PHASES; k++)
    {
        const double share = ratio(f->phase[k].mean, f->wall);

        if (share >= 1e-3)
        {
            dem_text_add(t, "    %-12s %5.1f %%  %s", f->phase[k].name, 100.0*share, dem_text_time(f->phase[k].mean));
            if (f->ranks > 1)
            {
                dem_text_add(t, "%*s%s", 10 - (int)strlen(dem_text_time(f->phase[k].mean)), "", dem_text_time(f->phase[k].most));
            }
            dem_text_add(t, "\n");
        }
    }
}

static void tell_every(struct dem_text *t, const char *what, int64_t times, int64_t steps)
{
    dem_text_add(t, "%s %lld times", what, (long long)times);
    if (times > 0)
    {
        dem_text_add(t, ", every %.4g steps", (double)steps/(double)times);
    }
}

static void tell_ranks(struct dem_text *t, const struct dem_profile *f)
{
    const double each = ratio(1.0, (double)f->steps*f->ranks);

    dem_text_add(t, "    ranks: the busiest works %.3g of the mean; a step and rank: %.3g messages, %s, %.3g all-reduces; a rebuild and "
                 "rank: %.3g letters, %s; cut anew %d times\n", f->busiest, (double)f->messages*each, dem_text_bytes((double)f->message_bytes*each),
                 ratio((double)f->agreements, (double)f->steps), ratio((double)f->letters, (double)f->rebuilds*f->ranks),
                 dem_text_bytes(ratio((double)f->letter_bytes, (double)f->rebuilds*f->ranks)), f->cuts);
}

/* What the step was good for. */
static void tell_accuracy(struct dem_text *t, const struct dem_profile *f)
{
    static const char *const more[] = {"", "more than "};
    const int most = 128;                                 /* longer ones are not told apart */

    dem_text_add(t, "    accuracy: largest overlap %.3g %% of a diameter", 100.0*f->largest_overlap);
    if (f->watched > 0)
    {
        const int a = f->least_steps > most, b = f->median_steps > most;

        dem_text_add(t, "; the shortest of %lld contacts watched from their beginning lasted %s%d steps, the median %s%d", (long long)f->watched,
                     more[a], a ? most : f->least_steps, more[b], b ? most : f->median_steps);
    }
    dem_text_add(t, "\n");
}

int dem_profile_write(struct dem_text *t, const struct dem_profile *f)
{
    const double seconds = f->wall - f->outside, speed = 1e-6*ratio((double)f->particle_steps, seconds);

    if (f->steps == 0)
    {
        dem_text_add(t, "%s", "");
        return t->status;
    }
    tell_phases(t, f);
    dem_text_add(t, "    speed: %.4g million particle-steps/s", speed);
    dem_text_add(t, f->ranks > 1 ? ", %.4g a core\n" : "\n", speed/f->ranks);
    tell_every(t, "    lists: renewed", f->rebuilds, f->steps);
    tell_every(t, ", pruned", f->prunes, f->steps);
    dem_text_add(t, "; skins %.3g and %.3g diameters\n", ratio(f->outer_skin, f->diameter), ratio(f->inner_skin, f->diameter));
    dem_text_add(t, "    a particle: %.3g contacts, %.3g near rows, %.4g bytes\n", ratio((double)f->contacts, (double)f->particles),
                 ratio((double)f->row_steps, (double)f->particle_steps), ratio(f->bytes, (double)f->particles));
    tell_accuracy(t, f);
    if (f->ranks > 1)
    {
        tell_ranks(t, f);
    }
    return t->status;
}
