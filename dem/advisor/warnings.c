/*
 * warnings.c -- the list of warnings before the first step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/warnings.h"
#include "advisor/regime.h"
#include "core/error.h"
#include <math.h>
#include <string.h>

static const double min_density = 50.0;        /* kg/m3  below it: a slip of the unit */
static const double max_diameter = 0.5;        /* m  above it: a slip of the unit */
static const double max_modulus = 1e10;        /* Pa  softer particles move the same */
static const double costly_steps = 1e6;        /* of the run */
static const double costly_window = 1e4;       /* DEM steps in a fluid step */
static const double max_cell = 1000.0;         /* diameters  above it: a slip of the unit */
static const double min_resolution = 0.75;     /* diameters  below it: cells become too full */
static const double max_crossing = 0.5;        /* of the resolution: default of maxParticleCo */

/* the list while it is written */
struct list
{
    struct dem_text *t;
    const struct dem_plan *p;
    struct dem_regime regime;
    int n;
    double step_cost;            /* s  of a particle and step; 0: not known */
    int measured;
};

static void begin(struct list *w)
{
    dem_text_add(w->t, w->n == 0 ? "WARNINGS\n%4d. " : "%4d. ", w->n + 1);
    w->n++;
}

static int has_particles(const struct list *w)
{
    return w->p->scene.particles > 0.0 || w->p->scene.streams > 0;
}

/* 0 when all are frozen */
static int has_free_particles(const struct list *w)
{
    return w->p->scene.moving_mass > 0.0 || w->p->scene.streams > 0;
}

/* ---- walls, gravity, drag -------------------------------------------------------------------- */

static void warn_of_walls(struct list *w)
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
    begin(w);
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
static void warn_of_driven(struct list *w)
{
    if (w->p->scene.driven && dem_wall_count(w->p->d) > 0)
    {
        begin(w);
        dem_text_add(
            w->t,
            "driven particles pass through walls, and through frozen and other driven particles: neither partner is "
            "free, so there is no force, also in walls.csv; to press on a particle, leave it free and move the wall "
            "(walls/NAME/motion)\n");
    }
}

/* An item for each line. */
static void add_lines(struct list *w, const char *line)
{
    for (size_t n; *line; line += n + 1)
    {
        n = strcspn(line, "\n");
        begin(w);
        dem_text_add(w->t, "%.*s\n", (int)n, line);
    }
}

static int warn_of_bodies(struct list *w)
{
    const char *light = "";

    if (w->p->scene.frozen && w->p->scene.wall_bodies > 0)
    {
        begin(w);
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
    add_lines(w, light);
    return DEM_OK;
}

static void warn_of_gravity(struct list *w)
{
    const char *const entry = w->p->scene.coupled ? "constant/g" : "effects/gravity/acceleration";
    const double *const g = w->p->scene.gravity, size = dem_plan_gravity(w->p);
    const double up = fabs(g[1]) > fabs(g[2]) ? g[1] : g[2];

    if (size == 0.0 && has_free_particles(w))
    {
        begin(w);
        dem_text_add(
            w->t, "no gravity: particles have no weight; give %s, (0 0 -9.81) for example, if they should have\n",
            entry);
    }
    else if (up > 0.9*size)
    {
        begin(w);
        dem_text_add(
            w->t, "gravity (%g %g %g) m/s2 points along +%c: particles rise; change the sign in %s if that is up\n",
            g[0], g[1], g[2], fabs(g[1]) > fabs(g[2]) ? 'y' : 'z', entry);
    }
}

static void warn_of_drag(struct list *w)
{
    if ((w->p->scene.coupled || w->p->scene.uniform) && !w->p->scene.drag_law)
    {
        begin(w);
        dem_text_add(
            w->t,
            "a fluid, and no drag: particles do not feel its flow; add a drag law to effects, gidaspow {} or "
            "diFelice {} for example (`dem effects` lists them)\n");
    }
}

/* ---- units ----------------------------------------------------------------------------------- */

static void warn_of_units(struct list *w)
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
            begin(w);
            dem_text_add(
                w->t,
                "materials/%s/density is %g kg/m3; the unit is kg/m3, 2500 for glass: change it unless they are that "
                "light\n",
                m.name, m.density);
        }
    }
    if (diameter > max_diameter)
    {
        begin(w);
        dem_text_add(
            w->t,
            "the largest particle has a diameter of %.4g m; lengths are in m, 1e-3 for 1 mm: change insert unless "
            "they are that large\n",
            diameter);
    }
}

/* ---- stiffness ------------------------------------------------------------------------------- */

/* s: processor time of a particle and step. Collective at its first call. */
static int measure(struct list *w)
{
    struct dem_run_cost cost;

    if (!w->measured && w->p->scene.particles > 0.0)
    {
        DEM_TRY(dem_run_cost(w->p->d, &cost));
        w->step_cost = cost.step;
        w->measured = 1;
    }
    return DEM_OK;
}

/* ", 3 h of processor time" for that many steps */
static void add_time(struct list *w, double steps)
{
    if (w->step_cost > 0.0)
    {
        dem_text_add(w->t, ", %s of processor time for %.0f particles",
                     dem_text_time(steps*w->p->scene.particles*w->step_cost), w->p->scene.particles);
    }
}

/* Contact times fall with the modulus as E^-2/5 (Hertz), Rayleigh times as E^-1/2: 2/5 is said. */
static int warn_of_moduli(struct list *w)
{
    const double step = w->p->scene.step, steps = w->p->run.duration/step, soft = 1e7;
    struct dem_scene_material m;

    for (int k = 0; steps > costly_steps && dem_scene_material(w->p->d, k, &m); k++)
    {
        if (m.present && m.youngs_modulus > max_modulus)
        {
            DEM_TRY(measure(w));
            begin(w);
            dem_text_add(w->t,
                         "materials/%s/youngsModulus %g Pa makes the step %.3g s: %.3g steps ahead",
                         m.name, m.youngs_modulus, step, steps);
            add_time(w, steps);
            dem_text_add(
                w->t, "; with %g Pa some %.2g times fewer, and the same motion as long as overlaps stay below 5 %%\n",
                soft, pow(m.youngs_modulus/soft, 0.4));
        }
    }
    return DEM_OK;
}

/* m/s: largest speed of the fluid, inside or on a patch */
static double fluid_speed(const struct list *w)
{
    return w->p->scene.uniform ? w->p->scene.fluid_speed
                               : fmax(w->p->run.speed, w->p->run.patch_speed);
}

/* ---- fluid step ------------------------------------------------------------------------------ */

static int warn_of_window(struct list *w)
{
    const struct dem_run_info *const run = &w->p->run;
    const double steps = fmax(1.0, ceil(run->window/w->p->scene.step*(1.0 - 1e-12)));

    if (run->window > 0.0 && steps > costly_window && has_particles(w))
    {
        DEM_TRY(measure(w));
        begin(w);
        dem_text_add(w->t, "a fluid step of %g s is %.0f DEM steps", run->window, steps);
        add_time(w, steps);
        if (run->duration > run->window && w->step_cost > 0.0)
        {
            dem_text_add(w->t, ", %s for the run",
                         dem_text_time(steps*w->p->scene.particles*w->step_cost*run->duration/
                                       run->window));
        }
        dem_text_add(
            w->t, "; take a shorter deltaT and endTime in system/controlDict, or a softer material\n");
    }
    return DEM_OK;
}

/* m/s: speed that a particle may reach within a fluid step, and whose it is */
static double reached(const struct list *w, const char **whose)
{
    const struct dem_run_info *const run = &w->p->run;
    const struct dem_regime *const g = &w->regime;
    const int drag = w->p->scene.drag_law != NULL, present = w->p->scene.particles > 0.0;
    double most = w->p->scene.max_speed;

    *whose = "of a particle";
    if (g->fluid && drag && g->response > 0.0)
    {
        const double taken = fluid_speed(w)*(1.0 - exp(-run->window/g->response));

        *whose = taken > most ? "that the fluid gives to a particle in it" : *whose;
        most = fmax(most, taken);
    }
    const double fall = dem_plan_gravity(w->p)*run->window;
    const double terminal = g->fluid && drag && g->slip > 0.0 ? fmin(fall, g->slip) : fall;

    *whose = present && terminal > most ? "that gravity gives to a particle in it" : *whose;
    return present ? fmax(most, terminal) : most;
}

static void warn_of_crossing(struct list *w)
{
    const struct dem_run_info *const run = &w->p->run;
    const char *whose;
    const double speed = reached(w, &whose);
    const double crossing = run->resolution > 0.0 ? speed*run->window/run->resolution : 0.0;

    if (crossing > max_crossing)
    {
        begin(w);
        dem_text_add(
            w->t,
            "a fluid step of %g s is long: at %.3g m/s, the speed %s, particles cross %.3g cells or half kernel widths "
            "(maxParticleCo %g); take deltaT %.2g s in system/controlDict, or adjustTimeStep yes\n",
            run->window, speed, whose, crossing, max_crossing,
            max_crossing*run->resolution/speed);
    }
}

/* ---- cells ----------------------------------------------------------------------------------- */

static void warn_of_cells(struct list *w)
{
    const struct dem_run_info *const run = &w->p->run;
    const double d = w->regime.suspension.diameter;

    if (run->resolution > 0.0 && !run->one_way && run->resolution < min_resolution*d*(1.0 - 1e-9))
    {
        begin(w);
        dem_text_add(
            w->t,
            "the smallest cell, %.3g m, or half the kernel's width, is less than 3/4 of a particle of %.3g m: cells "
            "become too full, and without ownWake each particle feels mainly its own wake; take kernel diffusion "
            "with width 3 in coupling, or cells of two diameters\n",
            run->cell, d);
    }
    else if (d > 0.0 && run->cell > max_cell*d)
    {
        begin(w);
        dem_text_add(
            w->t, "the smallest cell, %.3g m, is %.3g diameters wide; if the mesh is in mm, give scale 0.001 in "
            "system/blockMeshDict, or use transformPoints -scale\n",
            run->cell, run->cell/d);
    }
}

/* ---- impact speed ---------------------------------------------------------------------------- */

static int warn_of_impacts(struct list *w)
{
    const char *lines;

    DEM_TRY(dem_impact_text(w->p->d, has_free_particles(w) ? fluid_speed(w) : 0.0, &lines));
    add_lines(w, lines);
    return DEM_OK;
}

/* ---- heat ------------------------------------------------------------------------------------ */

static void warn_of_biot(struct list *w)
{
    struct dem_biot most;

    dem_biot_number(w->p->d, w->regime.suspension.diameter, w->regime.slip, &most);
    if (most.number > DEM_BIOT_LIMIT)
    {
        begin(w);
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
    struct list w = {.t = t, .p = p};
    const char *note;

    dem_regime_set(p, &w.regime);
    for (int k = 0; (note = dem_scene_note(p->d, k)) != NULL; k++)
    {
        begin(&w);
        dem_text_add(t, "%s\n", note);
    }
    for (int k = 0; k < n; k++)
    {
        begin(&w);
        dem_text_add(t, "%s\n", own[k]);
    }
    if (has_particles(&w))
    {
        warn_of_walls(&w);
        warn_of_driven(&w);
        DEM_TRY(warn_of_bodies(&w));
        warn_of_gravity(&w);
        warn_of_drag(&w);
        warn_of_units(&w);
        warn_of_biot(&w);
        DEM_TRY(warn_of_impacts(&w));
        warn_of_crossing(&w);
        warn_of_cells(&w);
        DEM_TRY(warn_of_window(&w));
        DEM_TRY(warn_of_moduli(&w));
    }
    return t->status;
}
