/*
 * main_plan_write.c -- `dem plan -write`: what the verdicts say goes into the scene.
 *
 * The edited text lies beside the scene while it is tried (SCENE.part, so that #include and files are found). Each edit must leave a scene
 * that can be opened, else it is taken back and told. After all edits of a plan there is another plan, until one asks for no more. The text
 * of before stays as SCENE.before.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_plan.h"
#include "base/error.h"
#include "base/memory.h"
#include "effects/effects.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>

enum
{
    MOST_PASSES = 6, MOST_EDITS = 48, PATH = 1024
};

struct rewrite
{
    struct dem_program *prog;
    const struct dem_request *request;
    char part[PATH], before[PATH];
    struct dem_text text;                                 /* of the scene, as edited so far */
    struct dem_text changed, left;                        /* what was done, and what a user must do; for the end */
    const char *touched[MOST_EDITS];                      /* effects that were edited: none twice */
    int edits;
};

/* ---- files ----------------------------------------------------------------------------------------------------- */

static int read_text(const char *path, struct dem_text *t)
{
    FILE *const f = fopen(path, "rb");
    char piece[4097];
    size_t n, whole = 0;

    DEM_REQUIRE(f, DEM_ERROR_FILE, "can't read %s: %s", path, strerror(errno));
    do
    {
        n = fread(piece, 1, sizeof piece - 1, f);
        piece[n] = '\0';
        whole += n;
        dem_text_add(t, "%s", piece);
    }
    while (n > 0);
    fclose(f);
    DEM_REQUIRE(t->status || t->n == whole, DEM_ERROR_INPUT, "%s has a zero byte; a scene is plain text", path);
    return t->status;
}

static int write_text(const char *path, const char *text)
{
    FILE *const f = fopen(path, "wb");
    int failed = !f || fputs(text, f) < 0;

    failed |= f && fclose(f) != 0;
    DEM_REQUIRE(!failed, DEM_ERROR_FILE, "can't write %s: %s", path, strerror(errno));
    return DEM_OK;
}

static int must_not_be(const char *path)
{
    FILE *const f = fopen(path, "rb");

    if (f)
    {
        fclose(f);
    }
    DEM_REQUIRE(!f, DEM_ERROR_FILE, "%s is there, and -write would write over it; move it away", path);
    return DEM_OK;
}

/* ---- one edit -------------------------------------------------------------------------------------------------- */

static int open_part(const struct rewrite *w, const char *text, struct dem **d, struct dem_schedule *s)
{
    struct dem_request r = *w->request;

    r.scene = w->part;
    r.bare = 1;
    DEM_TRY(write_text(w->part, text));
    return dem_scene_open(w->prog, &r, d, s);
}

/* What comments and lines say; until the next call. */
static const char *reason(const struct dem_verdict *v)
{
    static char text[256];

    snprintf(text, sizeof text, "%.2g %% %s", 100.0*v->share, v->why);
    return text;
}

/* The edited text in place of the one of before, when it is a scene. */
static int settle(struct rewrite *w, struct dem_text *edited, int places, const struct dem_verdict *v, const char *done)
{
    struct dem_schedule s;
    struct dem *d = NULL;

    if (places == 0)
    {
        dem_text_add(&w->left, "    %s: it is not in the text of %s itself; change it where it is: %s\n", v->effect, w->request->scene, reason(v));
        return DEM_OK;
    }
    if (edited->status || open_part(w, edited->text, &d, &s))
    {
        dem_text_add(&w->left, "    %s: %s; but then: %s\n", v->effect, reason(v), dem_error_text());
        return edited->status;
    }
    dem_free(d);
    dem_text_free(&w->text);
    w->text = *edited;
    *edited = (struct dem_text){.n = 0};
    dem_text_add(&w->changed, "    %s %s: %s\n", v->effect, done, reason(v));
    return DEM_OK;
}

static int edit(struct rewrite *w, const struct dem_verdict *v)
{
    const struct dem_effect *const effect = dem_effects_find(v->effect);
    struct dem_text edited = {.n = 0};
    char done[64] = "added";
    int places = 0;

    if (v->lacks)
    {
        dem_text_add(&w->left, "    %s%s%s: %s; give it %s\n", v->effect, v->instead_of ? " in place of " : "", v->instead_of ? v->instead_of : "",
                     reason(v), v->lacks);
        return DEM_OK;
    }
    if (v->word == DEM_NEGLIGIBLE && effect->stage == DEM_STAGE_NORMAL)
    {
        dem_text_add(&w->left, "    %s is negligible, but contacts need a normal law: choose another\n", v->effect);
        return DEM_OK;
    }
    if (v->word == DEM_NEGLIGIBLE && effect->stage == DEM_STAGE_DAMP)
    {
        snprintf(done, sizeof done, "replaced by dry");
        places = dem_edit_rename(&edited, w->text.text, v->effect, "dry", reason(v));
    }
    else if (v->word == DEM_NEGLIGIBLE)
    {
        snprintf(done, sizeof done, "commented out");
        places = dem_edit_leave_out(&edited, w->text.text, v->effect, reason(v));
    }
    else if (v->instead_of)
    {
        snprintf(done, sizeof done, "in place of %s", v->instead_of);
        places = dem_edit_rename(&edited, w->text.text, v->instead_of, v->effect, reason(v));
    }
    else
    {
        places = dem_edit_add(&edited, w->text.text, v->effect, reason(v));
    }
    const int status = settle(w, &edited, places, v, done);

    dem_text_free(&edited);
    return status;
}

/* ---- all of them ----------------------------------------------------------------------------------------------- */

static int touched(const struct rewrite *w, const char *effect)
{
    for (int k = 0; k < w->edits; k++)
    {
        if (strcmp(w->touched[k], effect) == 0)
        {
            return 1;
        }
    }
    return w->edits == MOST_EDITS;
}

/* *more: there was something to edit. */
static int pass(struct rewrite *w, int *more)
{
    const struct dem_verdict *verdict;
    struct dem_schedule s;
    const char *text;
    struct dem *d;

    *more = 0;
    DEM_TRY(open_part(w, w->text.text, &d, &s));
    int status = dem_plan(d, &(struct dem_prospect){.duration = s.end}, &text);
    const int n = status ? 0 : dem_verdicts(d, &verdict);

    for (int k = 0; k < n && !status; k++)
    {
        if (verdict[k].word != DEM_NEEDED && !touched(w, verdict[k].effect))
        {
            w->touched[w->edits++] = dem_effects_find(verdict[k].effect)->name;
            *more = 1;
            status = edit(w, &verdict[k]);
        }
    }
    dem_free(d);
    return status;
}

static int put_in_place(const struct rewrite *w)
{
    const char *const scene = w->request->scene;

    DEM_TRY(write_text(w->part, w->text.text));
    DEM_REQUIRE(rename(scene, w->before) == 0, DEM_ERROR_FILE, "can't rename %s to %s: %s", scene, w->before, strerror(errno));
    DEM_REQUIRE(rename(w->part, scene) == 0, DEM_ERROR_FILE, "can't rename %s to %s: %s; the scene of before is %s", w->part, scene, strerror(errno),
                w->before);
    return DEM_OK;
}

static void tell(const struct rewrite *w)
{
    if (w->changed.n > 0)
    {
        printf("%s has the plan's choice, %s what was before:\n%s", w->request->scene, w->before, w->changed.text);
    }
    else
    {
        printf("%s stays as it is\n", w->request->scene);
    }
    if (w->left.n > 0)
    {
        printf("left to you:\n%s", w->left.text);
    }
}

static int rewrite(struct rewrite *w)
{
    int more = 1;

    DEM_TRY(read_text(w->request->scene, &w->text));
    for (int k = 0; k < MOST_PASSES && more; k++)
    {
        DEM_TRY(pass(w, &more));
    }
    return w->changed.n > 0 ? put_in_place(w) : DEM_OK;
}

int dem_plan_rewrite(struct dem_program *prog, const struct dem_request *r)
{
    struct rewrite w = {.prog = prog, .request = r};

    DEM_REQUIRE(prog->ranks == 1, DEM_ERROR_INPUT, "-write on %d ranks; one writes the scene: leave mpirun out", prog->ranks);
    DEM_REQUIRE(r->sets == 0, DEM_ERROR_INPUT, "-write with -set %s, which is not in the scene; write it there first", r->set[0][0]);
    DEM_REQUIRE(strlen(r->scene) + 8 < PATH, DEM_ERROR_INPUT, "the scene's name is longer than %d letters", PATH - 9);
    snprintf(w.part, sizeof w.part, "%s.part", r->scene);
    snprintf(w.before, sizeof w.before, "%s.before", r->scene);
    DEM_TRY(must_not_be(w.before));
    DEM_TRY(must_not_be(w.part));
    const int status = rewrite(&w);

    remove(w.part);
    if (!status)
    {
        tell(&w);
    }
    dem_text_free(&w.text);
    dem_text_free(&w.changed);
    dem_text_free(&w.left);
    return status;
}
