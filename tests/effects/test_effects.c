/*
 * Claims about all effects of the list at once: each tells what the manual needs; each is found by its word, and a word
 * nobody knows gets an answer; a row's result has the same bits wherever it lies in the tray and however many rows there
 * are (whole vectors or the rest); rows of zeros, as the house pads with, and rows apart give zeros and trap nothing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "bodies.h"

#include "base/random.h"

#include <stdlib.h>

enum
{
    ROWS = 37,                                            /* whole vectors of 2, 4, 8 and a rest */
    MEMORY = 16
};

static const struct dem_material glass = {"glass", 2500.0, 60e9, 0.22, 0.0};
static const struct dem_pair_class pair = {.a = &glass, .b = &glass, .reduced_modulus = 31e9, .reduced_shear = 7e9,
                                           .exponent = 1.5, .least_radius = 1e-3, .least_mass = 1e-5};

/* settings in the middle of their range, or their defaults; prepared */
static void settings_of(const struct dem_effect *e, void *settings)
{
    double unlike = 0.0;                                  /* no two alike: one may have to be above the other */

    if (e->settings)
    {
        dem_field_defaults(e->settings, settings);
        for (const struct dem_field *f = e->settings; f->name; f++)
        {
            if (isnan(f->def))
            {
                const double value = (f->least > 0.5 ? 2.0*f->least : 0.5) + unlike, values[3] = {value, 0.5, 0.5};

                dem_field_set_number(e->settings, settings, e->name, f->name, values, f->kind == DEM_FIELD_VECTOR ? 3 : 1);
                unlike += 0.01;
            }
        }
    }
    if (e->prepare && e->prepare(settings, e->stage < DEM_STAGE_BODY ? &pair : NULL))
    {
        printf("Bail out! %s\n", dem_error_text());
        exit(1);
    }
}

static double uniform(int row, int use, double least, double most)
{
    return least + (most - least)*dem_random_unit(1, (uint64_t)row, 0, (uint64_t)use);
}

/* every third row is apart */
static void random_contact(struct dem_block *b, dem_real memory[MEMORY][DEM_BLOCK], int to, int row)
{
    const double a = uniform(row, 0, 0.0, 6.28), z = uniform(row, 1, -1.0, 1.0), tilt = uniform(row, 2, -0.01, 0.01);
    const double apart = row % 3 == 2 ? 0.0 : 1.0;

    b->dt = b->longest = 1e-6;
    b->nx[to] = sqrt(1.0 - z*z)*cos(a), b->ny[to] = sqrt(1.0 - z*z)*sin(a), b->nz[to] = z;
    b->hx[to] = sqrt(1.0 - z*z)*cos(a + tilt), b->hy[to] = sqrt(1.0 - z*z)*sin(a + tilt), b->hz[to] = z;
    b->overlap[to] = apart*uniform(row, 3, 0.0, 1e-5);
    b->touching[to] = apart;
    b->reduced_radius[to] = uniform(row, 4, 1e-3, 2e-3);
    b->reduced_mass[to] = uniform(row, 5, 1e-5, 1e-4);
    b->vn[to] = uniform(row, 6, -1.0, 1.0);
    b->sx[to] = uniform(row, 7, -1.0, 1.0), b->sy[to] = uniform(row, 8, -1.0, 1.0), b->sz[to] = uniform(row, 9, -1.0, 1.0);
    b->wx[to] = uniform(row, 10, -9.0, 9.0), b->wy[to] = uniform(row, 11, -9.0, 9.0), b->wz[to] = uniform(row, 12, -9.0, 9.0);
    b->viscosity[to] = uniform(row, 13, 0.0, 0.01);
    b->least_radius[to] = uniform(row, 50, 1e-3, 2e-3);
    b->gap[to] = apart > 0.0 ? -b->overlap[to] : uniform(row, 51, 0.0, 1.0);
    b->distance[to] = 2.0*b->least_radius[to] + b->gap[to];
    b->rate[to] = b->vn[to];
    b->swing[to] = uniform(row, 52, -9.0, 9.0);
    b->counts[to] = uniform(row, 53, 0.0, 1.0) < 0.8 ? 1.0 : 0.0;
    b->chance[to] = uniform(row, 54, 0.0, 1.0);
    b->kn[to] = apart*uniform(row, 14, 0.0, 1e6);
    b->kt[to] = apart*uniform(row, 15, 0.0, 1e6);
    b->eta[to] = apart*uniform(row, 16, 0.0, 10.0);
    b->sealed[to] = uniform(row, 55, 0.0, 1.0) < 0.2 ? 1.0 : 0.0;
    b->grip[to] = apart*uniform(row, 56, 0.0, 5.0);
    b->fn[to] = apart*uniform(row, 17, -1.0, 5.0);
    for (int m = 0; m < MEMORY; m++)
    {
        memory[m][to] = apart*uniform(row, 18 + m, -1e-6, 1e-6);
    }
}

static void random_body(struct dem_body_block *b, int to, int row)
{
    body_fill(b, to, uniform(row, 0, 1e-4, 1e-2), uniform(row, 1, 1.0, 1000.0), uniform(row, 2, 1e-5, 1e-2),
              uniform(row, 3, 0.1, 1.1), uniform(row, 4, 0.0, 2000.0));
    b->vx[to] = uniform(row, 5, -1.0, 1.0), b->vy[to] = uniform(row, 6, -1.0, 1.0), b->vz[to] = uniform(row, 7, -1.0, 1.0);
    b->gx[to] = uniform(row, 8, -1e4, 1e4), b->gy[to] = uniform(row, 9, -1e4, 1e4), b->gz[to] = uniform(row, 10, -1e4, 1e4);
    b->ax[to] = uniform(row, 11, -20.0, 20.0), b->ay[to] = uniform(row, 12, -20.0, 20.0), b->az[to] = uniform(row, 13, -20.0, 20.0);
    b->ox[to] = uniform(row, 14, -99.0, 99.0), b->oy[to] = uniform(row, 15, -99.0, 99.0), b->oz[to] = uniform(row, 16, -99.0, 99.0);
    b->sx[to] = uniform(row, 17, -99.0, 99.0), b->sy[to] = uniform(row, 18, -99.0, 99.0), b->sz[to] = uniform(row, 19, -99.0, 99.0);
    b->wx[to] = uniform(row, 20, -99.0, 99.0), b->wy[to] = uniform(row, 21, -99.0, 99.0), b->wz[to] = uniform(row, 22, -99.0, 99.0);
    b->mean_diameter[to] = uniform(row, 23, 1e-4, 1e-2);
}

static int all_finite(const dem_real *values)
{
    int all = 1;

    for (int c = 0; c < DEM_BLOCK; c++)
    {
        all &= isfinite(values[c]) ? 1 : 0;
    }
    return all;
}

/* how many of the columns from first to last (results and memory) hold a number that isn't finite */
static int bad_columns(const dem_real *first, const dem_real *last)
{
    int bad = 0;

    for (const dem_real *column = first; column <= last; column += DEM_BLOCK)
    {
        bad += !all_finite(column);
    }
    return bad;
}

static int differs(const dem_real *first, const dem_real *last, const dem_real *other_first, int row)
{
    int bad = 0;

    for (const dem_real *a = first, *b = other_first; a <= last; a += DEM_BLOCK, b += DEM_BLOCK)
    {
        bad += memcmp(a + row, b, sizeof *a) != 0;        /* bits, so that -0 is not 0 */
    }
    return bad;
}

static void act(const struct dem_effect *e, const double *settings, struct dem_block *b, dem_real *const *memory)
{
    if (e->adhere)
    {
        e->adhere(settings, b, memory);
    }
    e->act(settings, b, memory);
}

static void contact_effect(const struct dem_effect *e)
{
    static struct dem_block many, one;
    static _Alignas(64) dem_real memory[MEMORY][DEM_BLOCK], memory_of_one[MEMORY][DEM_BLOCK];
    dem_real *all[MEMORY], *alone[MEMORY];
    double settings[32] = {0};
    int bad = 0;

    for (int m = 0; m < MEMORY; m++)
    {
        all[m] = memory[m];
        alone[m] = memory_of_one[m];
    }
    settings_of(e, settings);
    memset(&many, 0, sizeof many);
    memset(memory, 0, sizeof memory);
    many.n = ROWS;
    for (int row = 0; row < ROWS; row++)
    {
        random_contact(&many, memory, row, row);
    }
    act(e, settings, &many, all);
    for (int row = 0; row < ROWS; row++)
    {
        memset(&one, 0, sizeof one);
        one.n = 1;
        random_contact(&one, memory_of_one, 0, row);
        act(e, settings, &one, alone);
        bad += differs(many.kn, many.broke, one.kn, row) + differs(memory[0], memory[MEMORY - 1], memory_of_one[0], row);
    }
    TAP_OK(bad == 0, "%s: a row has the same bits alone and among others (%d differ)", e->name, bad);
    TAP_OK(bad_columns(many.kn, many.broke) + bad_columns(memory[0], memory[MEMORY - 1]) == 0,
           "%s: all finite", e->name);
    bad = 0;
    for (int row = 2; row < ROWS && e->stage < DEM_STAGE_BOND; row += 3)
    {
        bad += many.kn[row] != 0.0 || many.kt[row] != 0.0 || many.eta[row] != 0.0 || many.fn[row] != 0.0;
        bad += many.fx[row] != 0.0 || many.fy[row] != 0.0 || many.fz[row] != 0.0;
    }
    TAP_OK(bad == 0, "%s: nothing acts on rows apart", e->name);

    bad = 0;
    for (int row = 0; row < ROWS && e->forgets; row++)    /* fn, kn, overlap, touching: 0 in every third row */
    {
        random_contact(&many, memory, row, row);
        for (int m = 0; m < MEMORY; m++)
        {
            memory[m][row] = uniform(row, 60 + m, -1e-6, 1e-6);
        }
    }
    if (e->forgets)
    {
        act(e, settings, &many, all);
    }
    for (int row = 2; row < ROWS && e->forgets; row += 3)
    {
        for (int m = 0; e->memory[m]; m++)
        {
            bad += memory[m][row] != 0.0 || signbit(memory[m][row]);
        }
    }
    TAP_OK(bad == 0, "%s: forgets rows apart where it says so", e->name);

    memset(&many, 0, sizeof many);
    memset(memory, 0, sizeof memory);
    many.n = DEM_BLOCK;
    many.longest = 1e-6;
    act(e, settings, &many, all);
    TAP_OK(bad_columns(many.kn, many.broke) == 0 && many.fn[DEM_BLOCK - 1] == 0.0 && many.fx[0] == 0.0,
           "%s: rows of zeros", e->name);
}

static void body_effect(const struct dem_effect *e)
{
    static struct dem_body_block many, one;
    double settings[32] = {0};
    int bad = 0;

    settings_of(e, settings);
    memset(&many, 0, sizeof many);
    many.n = ROWS;
    for (int row = 0; row < ROWS; row++)
    {
        random_body(&many, row, row);
    }
    dem_effect_on_bodies(e, settings, &many);
    for (int row = 0; row < ROWS; row++)
    {
        memset(&one, 0, sizeof one);
        one.n = 1;
        random_body(&one, 0, row);
        dem_effect_on_bodies(e, settings, &one);
        bad += differs(many.added, many.tz, one.added, row);
    }
    TAP_OK(bad == 0, "%s: a row has the same bits alone and among others (%d differ)", e->name, bad);
    TAP_OK(bad_columns(many.added, many.tz) == 0, "%s: all finite", e->name);
    bad = 0;
    for (int row = 0; row < ROWS; row++)
    {
        bad += many.b[row] < 0.0 || many.t[row] < 0.0 || many.added[row] < 0.0;
    }
    TAP_OK(bad == 0, "%s: no drag pushes, none turns along, nobody takes less than no fluid along", e->name);

    memset(&many, 0, sizeof many);
    many.n = DEM_BLOCK;
    dem_effect_on_bodies(e, settings, &many);
    TAP_OK(bad_columns(many.added, many.tz) == 0 && many.fx[DEM_BLOCK - 1] == 0.0 && many.b[0] == 0.0,
           "%s: rows of zeros", e->name);
    TAP_OK(many.rx[0] == 0.0 && many.t[DEM_BLOCK - 1] == 0.0 && many.added[0] == 0.0, "%s: nor turn, nor take along", e->name);
}

/* what an effect says that it does, it does, and nothing else */
static void books(const struct dem_effect *e)
{
    static struct dem_body_block b;
    double settings[32] = {0};
    int reacts = 0, pushes = 0, turns = 0, added = 0;

    settings_of(e, settings);
    memset(&b, 0, sizeof b);
    b.n = ROWS;
    for (int row = 0; row < ROWS; row++)
    {
        random_body(&b, row, row);
    }
    dem_effect_on_bodies(e, settings, &b);
    for (int row = 0; row < ROWS; row++)
    {
        reacts |= b.rx[row] != 0.0 || b.ry[row] != 0.0 || b.rz[row] != 0.0;
        pushes |= b.fx[row] != 0.0 || b.fy[row] != 0.0 || b.fz[row] != 0.0;
        turns |= b.t[row] != 0.0;
        added |= b.added[row] != 0.0;
    }
    TAP_OK(reacts == e->reacts && added == e->inertia && turns == e->turns && (pushes == 0 || !reacts),
           "%s: its books are those that it tells of", e->name);
}

static void tells(const struct dem_effect *e)
{
    const int body = e->stage >= DEM_STAGE_BODY;
    int fields = 0, bad = 0;

    for (const struct dem_field *f = e->settings; f && f->name; f++)
    {
        fields++;
        bad += f->help == NULL || f->help[0] == '\0' || f->unit == NULL || f->offset >= e->size;
    }
    TAP_OK(e->says && e->source && e->name[0] && e->says[0] && e->source[0],
           "%s: word, sentence, source", e->name);
    TAP_OK(bad == 0 && (fields > 0) == (e->size > 0), "%s: %d settings, each with unit and help", e->name, fields);
    TAP_OK(body ? e->act_on_bodies && !e->act && !e->memory : e->act && !e->act_on_bodies,
           "%s: acts as its stage wants", e->name);
    TAP_OK(!(e->reach || e->shield) || e->stage == DEM_STAGE_BOND || e->stage == DEM_STAGE_FILM,
           "%s: only bonds and films act past touching", e->name);
    TAP_OK(!e->adhere || e->stage == DEM_STAGE_FILM, "%s: only films tell friction beforehand", e->name);
    TAP_OK(!e->open_bodies || e->drag || e->inertia, "%s: only drag and added mass open a window", e->name);
    TAP_OK(!(e->drag || e->reacts || e->inertia || e->turns) || e->stage == DEM_STAGE_FLUID, "%s: only in a fluid", e->name);
    TAP_OK(!e->forgets || (e->memory && e->stage < DEM_STAGE_BOND), "%s: only laws of contact forget", e->name);
    TAP_OK((e->exponent > 0.0) == (e->stage == DEM_STAGE_NORMAL),
           "%s: an exponent for the normal law only", e->name);
    TAP_OK(dem_effects_find(e->name) == e, "%s: found by its word", e->name);
}

int main(void)
{
    int count = 0;

    TAP_TRAPS;
    for (const struct dem_effect *const *e = dem_effects; *e; e++)
    {
        count++;
        tells(*e);
        if ((*e)->stage < DEM_STAGE_BODY)
        {
            contact_effect(*e);
        }
        else
        {
            body_effect(*e);
            books(*e);
        }
    }
    TAP_OK(count > 0, "%d effects", count);
    TAP_OK(dem_effects_find("hertzz") == NULL && dem_effects_find("") == NULL, "an unknown word is not found");
    TAP_OK(dem_effects_unknown("scene.dem, line 3", "hertzz") == DEM_ERROR_INPUT, "%s", dem_error_text());
    TAP_OK(strncmp(dem_error_text(), "scene.dem, line 3: ", 19) == 0, "the message begins with the place");
    TAP_OK(strstr(dem_error_text(), "did you mean hertz") != NULL, "and offers the nearest word");
    TAP_OK(strstr(dem_error_text(), "gidaspow") != NULL, "and lists the others");
    TAP_DONE;
}
