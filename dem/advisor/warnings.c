/*
 * warnings.c -- the list of warnings before the first step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/warnings.h"
#include "advisor/biot.h"
#include "advisor/regime.h"
#include "core/vec.h"
#include "records/totals.h"
#include <math.h>
#include <string.h>

static const double min_density = 50.0;        /* kg/m3  below it: a slip of the unit */
static const double max_modulus = 1e10;        /* Pa  softer particles move the same */
static const double costly_steps = 1e6;        /* of the run */
static const double costly_window = 1e4;       /* DEM steps in a fluid step */
static const double max_crossing = 0.5;        /* of the resolution: default of maxParticleCo */

/* the list while it is written */
struct list
{
    struct dem_text *t;
    const struct dem_plan *p;
    struct dem_regime regime;
    int coupled, n;
    double speed;                /* m/s  fastest particle */
    double step_cost;            /* s  of a particle and step; 0: not measured yet */
};

static void begin(struct list *w)
{
    dem_text_add(w->t, w->n == 0 ? "WARNINGS\n%4d. " : "%4d. ", w->n + 1);
    w->n++;
}

static int has_particles(const struct list *w)
{
    return w->p->inventory.all.n > 0 || w->p->scene->streams.streams > 0;
}

/* ---- walls, gravity, drag -------------------------------------------------------------------- */

static int has_law(const struct list *w, const struct dem_wall *wall)
{
    return dem_interaction_table_wall_has_law(&w->p->state->interaction_table,
                                              wall->frictionless ? DEM_PARTNER_FRICTIONLESS
                                                                 : DEM_PARTNER_WALL,
                                              wall->material);
}

static void warn_of_walls(struct list *w)
{
    const struct dem_walls *const walls = &w->p->state->walls;
    int listed = 0, all = 0;

    for (int k = 0; k < walls->walls; k++)
    {
        all += !has_law(w, &walls->wall[k]);
    }
    if (all == 0 || !has_particles(w))
    {
        return;
    }
    begin(w);
    dem_text_add(w->t, "no contact law acts between particles and wall%s", all > 1 ? "s" : "");
    for (int k = 0; k < walls->walls && listed < 8; k++)
    {
        if (!has_law(w, &walls->wall[k]))
        {
            dem_text_add(w->t, "%s %s", listed++ ? "," : "", walls->wall[k].name);
        }
    }
    dem_text_add(
        w->t,
        "%s: particles pass through; add a normal law and damping to effects, hertz {} dry { restitution 0.9; } "
        "for example\n",
        all > listed ? " and others" : "");
}

/* Contacts of a driven particle with what is not free either are not computed. */
static void warn_of_driven(struct list *w)
{
    if (dem_totals_any_driven(w->p->state) && w->p->state->walls.walls > 0)
    {
        begin(w);
        dem_text_add(
            w->t,
            "driven particles pass through walls, and through frozen and other driven particles: neither partner is "
            "free, so there is no force, also in walls.csv; to press on a particle, leave it free and move the wall "
            "(walls/NAME/motion)\n");
    }
}

static void warn_of_gravity(struct list *w)
{
    const char *const entry = w->coupled ? "constant/g" : "effects/gravity/acceleration";
    double g[3];

    dem_interaction_table_gravity(&w->p->state->interaction_table, g);
    const double size = dem_vec_norm(g);
    const double up = fabs(g[1]) > fabs(g[2]) ? g[1] : g[2];

    if (size == 0.0)
    {
        begin(w);
        dem_text_add(
            w->t,
            "no gravity: particles have no weight; give %s, (0 0 -9.81) for example, if they should have\n",
            entry);
    }
    else if (up > 0.9*size)
    {
        begin(w);
        dem_text_add(
            w->t,
            "gravity (%g %g %g) m/s2 points along +%c: particles rise; change the sign in %s if that is up\n",
            g[0], g[1], g[2], fabs(g[1]) > fabs(g[2]) ? 'y' : 'z', entry);
    }
}

static int has_drag(const struct dem_interaction_table *r)
{
    int drag = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        drag |= r->effect[k]->drag != DEM_DRAG_NONE;
    }
    return drag;
}

static void warn_of_drag(struct list *w)
{
    if ((w->coupled || w->p->scene->fluid.given) && !has_drag(&w->p->state->interaction_table))
    {
        begin(w);
        dem_text_add(
            w->t,
            "a fluid, and no drag: particles do not feel its flow; add a drag law to effects, gidaspow {} or diFelice {} "
            "for example (`dem effects` lists them)\n");
    }
}

/* ---- materials ------------------------------------------------------------------------------- */

static int is_present(const struct dem_plan *p, int material)
{
    return p->state->interaction_table.max_radius[material] > 0.0;
}

static void warn_of_densities(struct list *w)
{
    const struct dem_interaction_table *const r = &w->p->state->interaction_table;

    for (int m = 0; m < r->materials; m++)
    {
        if (is_present(w->p, m) && r->material[m].density < min_density)
        {
            begin(w);
            dem_text_add(
                w->t,
                "materials/%s/density is %g kg/m3; the unit is kg/m3, 2500 for glass: change it unless they are that light\n",
                r->material[m].name, r->material[m].density);
        }
    }
}

/* s: processor time of a particle and step. Collective at its first call. */
static int measure(struct list *w)
{
    struct dem_step_cost cost;

    if (w->step_cost == 0.0 && w->p->inventory.all.n > 0)
    {
        DEM_TRY(dem_step_cost_measure(w->p->state, &w->p->inventory, w->p->step, &cost));
        w->step_cost = cost.step;
    }
    return DEM_OK;
}

static double particles(const struct list *w)
{
    return (double)w->p->inventory.all.n;
}

/* ", 3 h of processor time" for that many steps */
static void add_time(struct list *w, double steps)
{
    if (w->step_cost > 0.0)
    {
        dem_text_add(w->t, ", %s of processor time for %.0f particles",
                     dem_text_time(steps*particles(w)*w->step_cost), particles(w));
    }
}

/* Contact times fall with the modulus as E^-2/5 (Hertz), Rayleigh times as E^-1/2: 2/5 is said. */
static int warn_of_moduli(struct list *w)
{
    const struct dem_interaction_table *const r = &w->p->state->interaction_table;
    const double steps = w->p->run.duration/w->p->step, soft = 1e7;

    for (int m = 0; m < r->materials && steps > costly_steps; m++)
    {
        const double modulus = r->material[m].youngs_modulus;

        if (is_present(w->p, m) && modulus > max_modulus)
        {
            DEM_TRY(measure(w));
            begin(w);
            dem_text_add(w->t,
                         "materials/%s/youngsModulus %g Pa makes the step %.3g s: %.3g steps ahead",
                         r->material[m].name, modulus, w->p->step, steps);
            add_time(w, steps);
            dem_text_add(
                w->t,
                "; with %g Pa some %.2g times fewer, and the same motion as long as overlaps stay below 5 %%\n",
                soft, pow(modulus/soft, 0.4));
        }
    }
    return DEM_OK;
}

/* m/s: largest speed of the fluid, inside or on a patch */
static double fluid_speed(const struct list *w)
{
    const struct dem_uniform_fluid *const given = &w->p->scene->fluid;

    return given->given ? dem_vec_norm(given->velocity)
                        : fmax(w->p->run.speed, w->p->run.patch_speed);
}

/* ---- fluid step ------------------------------------------------------------------------------ */

static int warn_of_window(struct list *w)
{
    const struct dem_run_info *const run = &w->p->run;
    const double steps = fmax(1.0, ceil(run->window/w->p->step*(1.0 - 1e-12)));

    if (run->window > 0.0 && steps > costly_window && has_particles(w))
    {
        DEM_TRY(measure(w));
        begin(w);
        dem_text_add(w->t, "a fluid step of %g s is %.0f DEM steps", run->window, steps);
        add_time(w, steps);
        if (run->duration > run->window && w->step_cost > 0.0)
        {
            dem_text_add(w->t, ", %s for the run",
                         dem_text_time(steps*particles(w)*w->step_cost*run->duration/
                                       run->window));
        }
        dem_text_add(
            w->t,
            "; take a shorter deltaT and endTime in system/controlDict, or a softer material\n");
    }
    return DEM_OK;
}

/* m/s: speed that a particle may reach within a fluid step, and whose it is */
static double reached(const struct list *w, const char **whose)
{
    const struct dem_run_info *const run = &w->p->run;
    const struct dem_regime *const g = &w->regime;
    const int drag = has_drag(&w->p->state->interaction_table);
    double most = w->speed, gravity[3];

    *whose = "of a particle";
    dem_interaction_table_gravity(&w->p->state->interaction_table, gravity);
    if (g->fluid && drag && g->response > 0.0)
    {
        const double taken = fluid_speed(w)*(1.0 - exp(-run->window/g->response));

        *whose = taken > most ? "that the fluid gives to a particle in it" : *whose;
        most = fmax(most, taken);
    }
    const double fall = dem_vec_norm(gravity)*run->window;
    const double terminal = g->fluid && drag && g->slip > 0.0 ? fmin(fall, g->slip) : fall;

    *whose = w->p->inventory.all.n > 0 && terminal > most ? "that gravity gives to a particle in it"
                                                          : *whose;
    return w->p->inventory.all.n > 0 ? fmax(most, terminal) : most;
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

/* ---- impact speed ---------------------------------------------------------------------------- */

static double stream_speed(const struct dem_stream *s, double fluid)
{
    double v[3];

    for (int k = 0; k < 3; k++)
    {
        v[k] = fabs(s->velocity[k]) + s->spread[k];
    }
    return s->with_fluid ? fluid : dem_vec_norm(v);
}

static void warn_of_impact(struct list *w, const char *what, const char *name, double speed)
{
    struct dem_impact impact;
    struct dem_text text = {.text = NULL};

    dem_impact_at(&w->p->state->interaction_table, speed, &impact);
    if (speed > 0.0 && dem_impact_describe(&impact, speed, &text) && text.text)
    {
        begin(w);
        dem_text_add(w->t, "%s%s: %s\n", what, name, text.text);
    }
    dem_text_free(&text);
}

static void warn_of_impacts(struct list *w)
{
    const struct dem_streams *const s = &w->p->scene->streams;
    const struct dem_walls *const walls = &w->p->state->walls;
    const int drag = has_drag(&w->p->state->interaction_table);
    int fastest = 0;

    warn_of_impact(w, "the fastest particle", "", w->speed);
    for (int k = 0; k < walls->walls; k++)
    {
        fastest = walls->wall[k].push > walls->wall[fastest].push ? k : fastest;
    }
    if (walls->walls > 0)
    {
        warn_of_impact(w, "walls/", walls->wall[fastest].name, walls->wall[fastest].push);
    }
    for (int k = 0; k < s->streams; k++)
    {
        warn_of_impact(w, "insert/", s->stream[k].name,
                       stream_speed(&s->stream[k], fluid_speed(w)));
    }
    if (drag && has_particles(w))
    {
        warn_of_impact(w, "the fluid", "", fluid_speed(w));
    }
}

/* ---- heat ------------------------------------------------------------------------------------ */

static void warn_of_biot(struct list *w)
{
    struct dem_biot most;

    dem_biot_number(w->p, &w->regime, &most);
    if (most.number > DEM_BIOT_LIMIT)
    {
        begin(w);
        dem_text_add(w->t, "the Biot number of %s ", most.material->name);
        if (most.other)
        {
            dem_text_add(w->t, "in contact with %s", most.other->name);
        }
        else
        {
            dem_text_add(w->t, "in the fluid");
        }
        dem_text_add(
            w->t,
            " is %.2g, above %g: a particle has one temperature here, but heat spreads in it too slowly for that (materials/%s/"
            "conductivity %g W/(m K)); temperatures lag behind\n",
            most.number, DEM_BIOT_LIMIT, most.material->name, most.material->thermal.conductivity);
    }
}

/* ---- the list -------------------------------------------------------------------------------- */

int dem_warnings_write(struct dem_text *t, struct dem_plan *p, int coupled, int n,
                       const char *const *own)
{
    struct list w = {.t = t, .p = p, .coupled = coupled};

    dem_inventory_take(p->state, &p->inventory);
    dem_regime_set(p, &w.regime);
    w.speed = dem_totals_max_speed(p->state);
    for (int k = 0; k < n; k++)
    {
        begin(&w);
        dem_text_add(t, "%s\n", own[k]);
    }
    if (has_particles(&w))
    {
        warn_of_walls(&w);
        warn_of_driven(&w);
        warn_of_gravity(&w);
        warn_of_drag(&w);
        warn_of_densities(&w);
        warn_of_biot(&w);
        warn_of_impacts(&w);
        warn_of_crossing(&w);
        DEM_TRY(warn_of_window(&w));
        DEM_TRY(warn_of_moduli(&w));
    }
    return t->status;
}
