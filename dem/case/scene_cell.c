/*
 * scene_cell.c -- the entry domain/cell: a periodic domain that deforms (particles/cell.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_cell.h"
#include "case/restart.h"
#include "core/error.h"
#include "core/text.h"
#include "ranks/collect.h"
#include "step/cell_motion.h"
#include <math.h>
#include <string.h>

enum
{
    ROOM = 8    /* largest coordinates over the ones of the scene */
};

/* Entry 3 is the simple shear, which crosses the faces of y. */
static int read_axis(struct dem_cell_axis *a, const struct dem_domain *d, const struct dem_dict *dict, int k)
{
    static const char *const name[] = {"xx", "yy", "zz", "xy"};
    const struct dem_dict *entry;

    DEM_TRY(dem_dict_sub_if(dict, name[k], &entry));
    if (!entry)
    {
        return DEM_OK;
    }
    a->deforms = 1;
    a->held = dem_dict_has(entry, "stress");
    DEM_REQUIRE(k < 3 ? d->periodic[k] : d->periodic[0] && d->periodic[1], DEM_ERROR_INPUT,
                "%s: domain/cell/%s, but the domain is not periodic along %s; add it to periodic",
                dem_dict_where(entry), name[k], k < 3 ? name[k] + 1 : "x and y");
    DEM_REQUIRE(k < 3 || !a->held, DEM_ERROR_INPUT,
                "%s: domain/cell/xy has a stress; simple shear has a rate", dem_dict_where(entry));
    DEM_REQUIRE(a->held + dem_dict_has(entry, "rate") == 1, DEM_ERROR_INPUT,
                "%s: domain/cell/%s has %s of rate (1/s) and stress (Pa, tension positive); give one of "
                "them", dem_dict_where(entry), name[k], a->held ? "both" : "none");
    DEM_TRY(dem_dict_number(entry, a->held ? "stress" : "rate", a->held ? "Pa" : "1/s",
                            a->held ? &a->target : &a->rate));
    DEM_TRY(dem_dict_time_or(entry, "start", -INFINITY, &a->start, &a->stage[0]));
    DEM_TRY(dem_dict_time_or(entry, "end", INFINITY, &a->end, &a->stage[1]));
    DEM_REQUIRE(fabs(a->rate) < 1e9 && fabs(a->target) < 1e30, DEM_ERROR_INPUT,
                "%s: domain/cell/%s: rate %g 1/s, stress %g Pa; give smaller numbers",
                dem_dict_where(entry), name[k], a->rate, a->target);
    return dem_dict_check_times(entry, "start", "end", (const double[2]){a->start, a->end}, a->stage);
}

/* Powers of 2, so that the unit stays one. */
static void give_room(struct dem_cell *c, struct dem_domain *d, int k)
{
    c->first_max[k] = d->max[k];
    if (c->axis[k].deforms)
    {
        d->unit[k] *= ROOM;
        d->round[k] *= ROOM;
        d->length[k] = d->unit[k]*rint(d->length[k]/d->unit[k]);
        d->max[k] = d->min[k] + d->length[k];
        c->farthest[k] = 0x1p53*d->unit[k];
    }
}

int dem_scene_read_cell(struct dem_cell *c, struct dem_domain *d, const struct dem_dict *domain)
{
    const struct dem_dict *dict;
    int held = 0;

    DEM_TRY(dem_dict_sub_if(domain, "cell", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    for (int k = 0; k < 3; k++)
    {
        DEM_TRY(read_axis(&c->axis[k], d, dict, k));
        c->active |= c->axis[k].deforms;
        held |= c->axis[k].held;
        give_room(c, d, k);
    }
    DEM_TRY(read_axis(&c->shear, d, dict, 3));
    c->active |= c->shear.deforms;
    DEM_REQUIRE(c->active, DEM_ERROR_INPUT,
                "%s: domain/cell has none of xx, yy, zz, xy; give one, like zz { rate -0.1; }",
                dem_dict_where(dict));
    DEM_REQUIRE(held || !dem_dict_has(dict, "maxRate"), DEM_ERROR_INPUT,
                "%s: domain/cell/maxRate limits the rates with which stresses are held, but no axis has a stress; "
                "give one, like xx { stress -1e4; }, or remove maxRate", dem_dict_where(dict));
    DEM_TRY(held ? dem_dict_number(dict, "maxRate", "1/s", &c->max_rate) : DEM_OK);
    DEM_REQUIRE(!held || (c->max_rate > 0.0 && isfinite(c->max_rate)), DEM_ERROR_INPUT,
                "%s: domain/cell/maxRate %g 1/s; give the largest rate with which a stress may be "
                "sought, above 0", dem_dict_where(dict), c->max_rate);
    return DEM_OK;
}

int dem_cell_refuse(const struct dem *d)
{
    const struct dem_state *const state = &d->state;
    const struct dem_interaction_table *const r = &state->interaction_table;

    if (!state->cell.active)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(state->walls.walls == 0, DEM_ERROR_INPUT,
                "domain/cell deforms the whole space, but wall %s would not follow; remove the walls, or "
                "let a wall move in place of the cell", state->walls.wall[0].name);
    for (int k = 0; k < r->chosen; k++)
    {
        DEM_REQUIRE(r->effect[k]->stage < DEM_STAGE_BODY, DEM_ERROR_INPUT,
                    "domain/cell and effects/%s: in a periodic cell that deforms velocities are relative "
                    "to its flow, and there is no gravity or fluid; remove one of them",
                    r->effect[k]->name);
    }
    DEM_REQUIRE(d->scene.averages == 0, DEM_ERROR_INPUT,
                "domain/cell and averages: grids of averages stay where they are and do not follow a cell; "
                "remove one of them");
    DEM_REQUIRE(d->scene.shapes.n == 0, DEM_ERROR_INPUT,
                "domain/cell and shapes: rigid bodies of several spheres do not follow a cell; remove one of "
                "them");
    DEM_REQUIRE(d->scene.streams.streams + d->scene.streams.outlets + d->scene.streams.planes == 0
                    && state->applied_forces.n == 0, DEM_ERROR_INPUT,
                "domain/cell does not go with forces, streams, groups with `at`, outlets "
                "or planes; remove them");
    return DEM_OK;
}

int dem_cell_refuse_fixed(const struct dem_state *state)
{
    int64_t fixed = 0;

    if (!state->cell.active)
    {
        return DEM_OK;
    }
    for (size_t i = 0; i < state->particles.n; i++)
    {
        fixed += (state->particles.record[i].flags & (DEM_PARTICLE_FROZEN | DEM_PARTICLE_DRIVEN)) != 0;
    }
    dem_collect_sum_int64(&state->decomposition, &fixed, 1);
    DEM_REQUIRE(fixed == 0, DEM_ERROR_INPUT,
                "domain/cell, and %lld particles are frozen or driven, but a cell moves all of them with its "
                "flow; let them be free, or leave the cell out", (long long)fixed);
    return DEM_OK;
}

/* ---- snapshots ------------------------------------------------------------------------------- */

static const char mark[] = "@cell ";

void dem_cell_describe(const struct dem *d, struct dem_text *t)
{
    const struct dem_cell *const c = &d->state.cell;

    if (c->active)
    {
        dem_text_add(t, "%s", mark);
        for (int k = 0; k < 3; k++)
        {
            dem_text_add(t, "%a %a %a ", d->state.domain.length[k], c->rate[k], c->integral[k]);
        }
        dem_text_add(t, "%a %a\n", d->state.domain.offset, c->strain);
    }
}

/* the cell of a snapshot: m, 1/s, Pa, m, 1 */
struct saved
{
    double length[3], rate[3], integral[3], offset, strain;
};

/* 0: it has none. */
static int read_saved(struct saved *s, const char *text)
{
    const char *const words = dem_text_marked(&text, mark);
    double x[11];

    if (!words || dem_text_numbers(words, x, 11) != 11)
    {
        return 0;
    }
    for (int k = 0; k < 3; k++)
    {
        s->length[k] = x[3*k];
        s->rate[k] = x[3*k + 1];
        s->integral[k] = x[3*k + 2];
    }
    s->offset = x[9];
    s->strain = x[10];
    return 1;
}

static const struct dem_cell_axis at_rest = {.deforms = 1, .start = -INFINITY, .end = INFINITY};

/* Set lengths and offset. What differs from the scene without an entry of its own gets the rate 0; 1: all of
   the cell is such. */
static int take(struct dem_state *state, const struct saved *s)
{
    struct dem_cell *const c = &state->cell;
    struct dem_domain *const d = &state->domain;
    const int given = c->active;

    for (int k = 0; k < 3; k++)
    {
        if (!c->axis[k].deforms)
        {
            const int kept = d->periodic[k] && fabs(s->length[k] - d->length[k]) > ROOM*d->unit[k];

            c->axis[k] = kept ? at_rest : c->axis[k];
            c->active |= kept;
            give_room(c, d, k);
        }
    }
    if (s->offset != 0.0 && !c->shear.deforms)
    {
        c->shear = at_rest;
        c->active = 1;
    }
    if (c->active)
    {
        dem_cell_set_lengths(state, s->length, s->offset);
    }
    return c->active && !given;
}

/* A cell that the scene does not have is refused as one that it has. */
static int refuse_taken(const struct dem *d, const char *path)
{
    const double *const length = d->state.domain.length;

    return dem_error_prefix(dem_cell_refuse(d), "%s: its cell has deformed to lengths of %.9g, %.9g and %.9g m (0: "
                            "not periodic), which stay as with domain/cell { xx { rate 0; } }; for a domain that is "
                            "fixed give it these lengths in a new run with start { snapshot; }: ", path, length[0],
                            length[1], length[2]);
}

int dem_cell_resume(struct dem *d, const char *path)
{
    struct dem_cell *const c = &d->state.cell;
    struct saved s;

    if (!read_saved(&s, d->before.text))
    {
        return DEM_OK;
    }
    memcpy(c->rate, s.rate, sizeof s.rate);
    memcpy(c->integral, s.integral, sizeof s.integral);
    c->strain = s.strain;
    return take(&d->state, &s) ? refuse_taken(d, path) : DEM_OK;
}

enum cell_fit
{
    FIT_NOW,      /* the domain has the lengths of the snapshot */
    FIT_SCENE,    /* or of the scene that made it, before the cell deformed */
    FIT_NONE
};

/* The worst axis; *length becomes what the cell gets. */
static enum cell_fit fit(const struct dem *d, double length[3])
{
    static const double same = 1e-6;
    const struct dem_domain *const box = &d->state.domain;
    const struct dem_cell *const c = &d->state.cell;
    enum cell_fit worst = FIT_NOW;

    for (int k = 0; k < 3; k++)
    {
        const double *const was = d->before.tail.domain[k], max = c->active ? c->first_max[k] : box->max[k];
        const int apart = box->periodic[k] && was[0] != 0.0 && fabs(box->length[k] - length[k]) > same*length[k];
        const enum cell_fit here = !apart ? FIT_NOW : was[1] == box->min[k] && was[2] == max ? FIT_SCENE : FIT_NONE;

        length[k] = apart ? length[k] : box->length[k];
        worst = here > worst ? here : worst;
    }
    return worst;
}

int dem_cell_start(struct dem *d, const char *path)
{
    const struct dem_domain *const box = &d->state.domain;
    const double *const now = box->length;
    struct saved s;

    if (!read_saved(&s, d->before.text))
    {
        return DEM_OK;
    }
    const struct saved was = s;
    const enum cell_fit as = fit(d, s.length);

    if (as == FIT_NONE)
    {
        return dem_sim_note(d, "start: the cell of %s has lengths of %.9g, %.9g and %.9g m, this domain of %.9g, %.9g "
                            "and %.9g m (0: not periodic), so contacts across its faces are lost; give one of the two "
                            "the other's lengths", path, was.length[0], was.length[1], was.length[2], now[0], now[1],
                            now[2]);
    }
    s.offset = box->periodic[0] && box->periodic[1] ? box->unit[0]*rint(s.offset/box->unit[0]) : 0.0;
    if (as == FIT_NOW && !d->state.cell.active && s.offset != 0.0)
    {
        return dem_sim_note(d, "start: images across y of the cell of %s are displaced by %.9g m, in this domain by 0, "
                            "so contacts across these faces are lost; keep it by domain/cell { xy { rate 0; } }",
                            path, s.offset);
    }
    return take(&d->state, &s) ? refuse_taken(d, path) : DEM_OK;
}
