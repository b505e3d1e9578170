/*
 * fused_loop.h -- template: a fused kernel, made of the row functions of its laws. Include it once
 * for each kernel:
 *
 *   #define LAWS hertz, dry, mindlin, rolling_spring, none
 *   #include "laws/fused/fused_loop.h"
 *
 * LAWS: normal, damping, friction, rolling, film; none where there is none.
 *
 * 1. Normal law, damping and the stiffness of friction, which shares a root with hertz.
 * 2. Trial forces of the springs of friction and rolling.
 * 3. The limits of these (slider.h).
 * 4. Forces and moments.
 *
 * In one long loop the latencies of square roots and divisions would add up; in short ones the
 * latencies of several rows overlap.
 *
 * History is cleared where partners are apart, as step/contact_effects.c does after an effect.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define NORMAL(name) DEM_FUSED_NORMAL(name, LAWS)     /* NORMAL(_row): dem_hertz_row */
#define DAMPING(name) DEM_FUSED_DAMPING(name, LAWS)
#define FRICTION(name) DEM_FUSED_FRICTION(name, LAWS)
#define ROLLING(name) DEM_FUSED_ROLLING(name, LAWS)
#define FILM(name) DEM_FUSED_FILM(name, LAWS)

DEM_KERNEL
static void DEM_FUSED_NAME(LAWS)(const void *const settings[DEM_FUSED_LAWS],
                                 struct dem_contact_batch *restrict b, double *const *history)
{
    enum    /* the first history column of each law */
    {
        AT_DAMPING = NORMAL(_columns),
        AT_FRICTION = AT_DAMPING + DAMPING(_columns),
        AT_ROLLING = AT_FRICTION + FRICTION(_columns),
        AT_FILM = AT_ROLLING + ROLLING(_columns),
        COLUMNS = AT_FILM + FILM(_columns)
    };
    const struct NORMAL() normal = *(const struct NORMAL() *)settings[0];
    const struct DAMPING() damping = *(const struct DAMPING() *)settings[1];
    const struct FRICTION() friction = *(const struct FRICTION() *)settings[2];
    const struct ROLLING() rolling = *(const struct ROLLING() *)settings[3];
    const struct FILM() film = *(const struct FILM() *)settings[4];
    const double inverse_dt = dem_contact_batch_inverse_dt(b);
    struct dem_slider_columns slips, rolls;

    NORMAL(_before)(&normal, b);
    DEM_INDEPENDENT_ROWS
    for (int c = 0; c < b->n; c++)
    {
        struct dem_contact_row r = dem_contact_row_load(b, c, inverse_dt);
        double h[DEM_LAW_HISTORY];

        dem_history_load(history, AT_FRICTION, c, h);
        dem_history_load(history + AT_FILM, COLUMNS - AT_FILM, c, h + AT_FILM);
        dem_fused_begin(&r);
        NORMAL(_row)(&normal, &r, h);
        DAMPING(_row)(&damping, &r, h + AT_DAMPING);
        FILM(_adhesion_row)(&film, &r, h + AT_FILM);
        r.kt = FRICTION(_stiffness)(&friction, &r);
        dem_history_clear_apart(&r, AT_FRICTION, h);
        dem_history_store(h, AT_FRICTION, c, history);
        dem_contact_row_store(&r,
                              DEM_SETS_KN | DEM_SETS_KT | DEM_SETS_ETA | DEM_SETS_FN |
                                  DEM_SETS_ADHESIVE_FORCE | DEM_SETS_SCRATCH,
                              b, c);
    }
    DEM_INDEPENDENT_ROWS
    for (int c = 0; c < b->n; c++)
    {
        struct dem_contact_row r = dem_contact_row_load(b, c, inverse_dt);
        double h[DEM_LAW_HISTORY];

        dem_history_load(history + AT_FRICTION, AT_FILM - AT_FRICTION, c, h + AT_FRICTION);
        r.mx = r.my = r.mz = 0.0;
        dem_slider_begin(&r, dem_friction_slider(&friction.common, &r, h + AT_FRICTION), &slips, c,
                         h + AT_FRICTION);
        ROLLING(_begin)(&rolling, &r, &rolls, c, h + AT_ROLLING);
        dem_history_store(h + AT_FRICTION, AT_FILM - AT_FRICTION, c, history + AT_FRICTION);
        dem_contact_row_store(&r, DEM_SETS_MOMENT, b, c);
    }
    dem_slider_limit_forces(&slips, b->n);
    ROLLING(_limit)(&rolls, b->n);
    DEM_INDEPENDENT_ROWS
    for (int c = 0; c < b->n; c++)
    {
        struct dem_contact_row r = dem_contact_row_load(b, c, inverse_dt);
        double h[DEM_LAW_HISTORY];

        dem_history_load(history + AT_FRICTION, COLUMNS - AT_FRICTION, c, h + AT_FRICTION);
        r.fx = r.fy = r.fz = 0.0;
        dem_slider_end(&slips, c, (double *[3]){&r.fx, &r.fy, &r.fz}, h + AT_FRICTION);
        ROLLING(_end)(&rolls, c, &r, h + AT_ROLLING);
        dem_history_clear_apart(&r, AT_FILM - AT_FRICTION, h + AT_FRICTION);
        FILM(_row)(&film, &r, h + AT_FILM);
        dem_history_store(h + AT_FRICTION, COLUMNS - AT_FRICTION, c, history + AT_FRICTION);
        dem_contact_row_store(&r, DEM_SETS_FORCE | DEM_SETS_MOMENT | FILM(_sets), b, c);
    }
}

#undef NORMAL
#undef DAMPING
#undef FRICTION
#undef ROLLING
#undef FILM
#undef LAWS
