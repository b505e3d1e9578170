/*
 * warnings.c -- the list of warnings before the first step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/warnings.h"
#include "advisor/warning_list.h"
#include "core/error.h"
#include <math.h>

static const double min_density = 50.0;        /* kg/m3  below it: a slip of the unit */
static const double max_diameter = 0.5;        /* m  above it: a slip of the unit */
static const double max_modulus = 1e10;        /* Pa  softer particles move the same */
static const double costly_steps = 1e6;        /* of the run */

/* 0 when all are frozen */
static int has_free_particles(const struct dem_warning_list *w)
{
    return w->p->scene.moving_mass > 0.0 || w->p->scene.streams > 0;
}

/* ---- walls, gravity -------------------------------------------------------------------------- */

static void warn_of_walls(struct dem_warning_list *w)
{
    struct dem *const d = w->p->d;
    const int walls = dem_wall_count(d);
    int listed = 0, all = 0;

    for (int k = 0; k < walls; k++)
    {
        all += !dem_wall_has_law(d, k);
    }
    if (all == 0)
    {
        return;
    }
    dem_warning_begin(w);
    dem_text_add(w->t, "no contact law acts between particles and wall%s", all > 1 ? "s" : "");
    for (int k = 0; k < walls && listed < 8; k++)
    {
        if (!dem_wall_has_law(d, k))
        {
            dem_text_add(w->t, "%s %s", listed++ ? "," : "", dem_wall_name(d, k));
        }
    }
    dem_text_add(
        w->t, "%s: particles pass through; add a normal law and damping to effects, hertz {} dry { restitution 0.9; } "
        "for example\n",
        all > listed ? " and others" : "");
}

/* Contacts of a driven particle with what is not free either are not computed. */
static void warn_of_driven(struct dem_warning_list *w)
{
    if (w->p->scene.driven && dem_wall_count(w->p->d) > 0)
    {
        dem_warning_begin(w);
        dem_text_add(
            w->t,
            "driven particles pass through walls, and through frozen and other driven particles: neither partner is "
            "free, so there is no force, also in walls.csv; to press on a particle, leave it free and move the wall "
            "(walls/NAME/motion)\n");
    }
}

static int warn_of_bodies(struct dem_warning_list *w)
{
    const char *light = "";

    if (w->p->scene.frozen && w->p->scene.wall_bodies > 0)
    {
        dem_warning_begin(w);
        dem_text_add(
            w->t,
            "walls that are moved by force (%d) pass through frozen and driven particles, between which there is no "
            "force; let those particles be free, or build what the walls meet of walls\n",
            w->p->scene.wall_bodies);
    }
    if (w->p->scene.wall_bodies > 0)
    {
        DEM_TRY(dem_wall_mass_text(w->p->d, w->p->scene.streams > 0 ? INFINITY : w->p->scene.particles, &light));
    }
    dem_warning_lines(w, light);
    return DEM_OK;
}

static void warn_of_gravity(struct dem_warning_list *w)
{
    const char *const entry = w->p->scene.coupled ? "constant/g" : "effects/gravity/acceleration";
    const double *const g = w->p->scene.gravity, size = dem_plan_gravity(w->p);
    const double up = fabs(g[1]) > fabs(g[2]) ? g[1] : g[2];

    if (size == 0.0 && has_free_particles(w))
    {
        dem_warning_begin(w);
        dem_text_add(
            w->t, "no gravity: particles have no weight; give %s, (0 0 -9.81) for example, if they should have\n",
            entry);
    }
    else if (up > 0.9*size)
    {
        dem_warning_begin(w);
        dem_text_add(
            w->t, "gravity (%g %g %g) m/s2 points along +%c: particles rise; change the sign in %s if that is up\n",
            g[0], g[1], g[2], fabs(g[1]) > fabs(g[2]) ? 'y' : 'z', entry);
    }
}

/* ---- units ----------------------------------------------------------------------------------- */

static void warn_of_units(struct dem_warning_list *w)
{
    const double ratio = w->p->scene.max_parcel_ratio;
    double diameter = ratio > 0.0 ? w->p->scene.max_diameter/ratio : w->p->scene.max_diameter;
    struct dem_scene_material m;
    struct dem_stream_info s;

    for (int k = 0; dem_stream_info(w->p->d, k, &s); k++)
    {
        diameter = fmax(diameter, s.max_diameter);
    }
    for (int k = 0; dem_scene_material(w->p->d, k, &m); k++)
    {
        if (m.present && m.density < min_density)
        {
            dem_warning_begin(w);
            dem_text_add(
                w->t,
                "materials/%s/density is %g kg/m3; the unit is kg/m3, 2500 for glass: change it unless they are that "
                "light\n",
                m.name, m.density);
        }
    }
    if (diameter > max_diameter)
    {
        dem_warning_begin(w);
        dem_text_add(
            w->t,
            "the largest particle has a diameter of %.4g m; lengths are in m, 1e-3 for 1 mm: change insert unless "
            "they are that large\n",
            diameter);
    }
}

/* ---- stiffness ------------------------------------------------------------------------------- */

/* Contact times fall with the modulus as E^-2/5 (Hertz), Rayleigh times as E^-1/2: 2/5 is said. */
static int warn_of_moduli(struct dem_warning_list *w)
{
    const double step = w->p->scene.step, steps = w->p->run.duration/step, soft = 1e7;
    struct dem_scene_material m;

    for (int k = 0; steps > costly_steps && dem_scene_material(w->p->d, k, &m); k++)
    {
        if (m.present && m.youngs_modulus > max_modulus)
        {
            DEM_TRY(dem_warning_measure_step(w));
            dem_warning_begin(w);
            dem_text_add(w->t,
                         "materials/%s/youngsModulus %g Pa makes the step %.3g s: %.3g steps ahead",
                         m.name, m.youngs_modulus, step, steps);
            dem_warning_add_time(w, steps);
            dem_text_add(
                w->t, "; with %g Pa some %.2g times fewer, and the same motion as long as overlaps stay below 5 %%\n",
                soft, pow(m.youngs_modulus/soft, 0.4));
        }
    }
    return DEM_OK;
}

/* ---- impact speed ---------------------------------------------------------------------------- */

static int warn_of_impacts(struct dem_warning_list *w)
{
    const char *lines;

    DEM_TRY(dem_impact_text(w->p->d, has_free_particles(w) ? dem_warning_fluid_speed(w) : 0.0, &lines));
    dem_warning_lines(w, lines);
    return DEM_OK;
}

/* ---- heat ------------------------------------------------------------------------------------ */

static void warn_of_biot(struct dem_warning_list *w)
{
    struct dem_biot most;

    dem_biot_number(w->p->d, w->regime.suspension.diameter, w->regime.slip, &most);
    if (most.number > DEM_BIOT_LIMIT)
    {
        dem_warning_begin(w);
        dem_text_add(
            w->t,
            "the Biot number of %s %s%s is %.2g, above %g: a particle has one temperature here, but heat spreads in it "
            "too slowly for that (materials/%s/conductivity %g W/(m K)); temperatures lag behind\n",
            most.material, most.other ? "in contact with " : "in the fluid", most.other ? most.other : "",
            most.number, DEM_BIOT_LIMIT, most.material, most.conductivity);
    }
}

/* ---- the list -------------------------------------------------------------------------------- */

int dem_warnings_write(struct dem_text *t, const struct dem_plan *p, int n, const char *const *own)
{
    struct dem_warning_list w = {.t = t, .p = p};
    const char *note;

    dem_regime_set(p, &w.regime);
    for (int k = 0; (note = dem_scene_note(p->d, k)) != NULL; k++)
    {
        dem_warning_begin(&w);
        dem_text_add(t, "%s\n", note);
    }
    for (int k = 0; k < n; k++)
    {
        dem_warning_begin(&w);
        dem_text_add(t, "%s\n", own[k]);
    }
    if (dem_warning_has_particles(&w))
    {
        warn_of_walls(&w);
        warn_of_driven(&w);
        DEM_TRY(warn_of_bodies(&w));
        warn_of_gravity(&w);
        dem_warning_of_drag(&w);
        warn_of_units(&w);
        warn_of_biot(&w);
        DEM_TRY(warn_of_impacts(&w));
        dem_warning_of_crossing(&w);
        dem_warning_of_cells(&w);
        DEM_TRY(dem_warning_of_window(&w));
        DEM_TRY(warn_of_moduli(&w));
    }
    return t->status;
}
