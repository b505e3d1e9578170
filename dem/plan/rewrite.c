/*
 * rewrite.c -- what the verdicts of a plan say goes into the scene.
 *
 * The edited text lies beside the scene while it is tried (SCENE.part, so that #include and files are found). Each edit must leave a scene
 * that can be opened, else it is taken back and told. After all edits of a plan there is another plan, until one asks for no more. The text
 * of before stays as SCENE.before. Who opens and plans is the caller (dem_rewriter): the program, or a solver with its mesh and fluid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/rewrite.h"
#include "dem.h"
#include "base/error.h"
#include "base/memory.h"
#include "effects/effects.h"
#include "io/file.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>

enum
{
    MOST_PASSES = 6, MOST_EDITS = 48, PATH = 1024
};

struct rewrite
{
    const struct dem_rewriter *by;
    char part[PATH], before[PATH];
    struct dem_text text;                                 /* of the scene, as edited so far */
    struct dem_text changed, left;                        /* what was done, and what a user must do; for the end */
    const char *touched[MOST_EDITS];                      /* effects that were edited: none twice */
    int edits;
};

/* ---- files ----------------------------------------------------------------------------------------------------- */

static int read_text(const char *path, struct dem_text *t)
{
    char *text;

    DEM_TRY(dem_file_load_text(path, &text));
    dem_text_add(t, "%s", text);
    dem_memory_free(text);
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
    DEM_REQUIRE(!dem_file_exists(path), DEM_ERROR_FILE, "%s is there, and -write would write over it; move it away", path);
    return DEM_OK;
}

/* ---- one edit -------------------------------------------------------------------------------------------------- */

/* NULL, or why this text is no scene; with `verdict` what a plan says of it. */
static const char *judge(const struct rewrite *w, const char *text, const struct dem_verdict **verdict, int *n)
{
    return write_text(w->part, text) ? dem_error_text() : w->by->judge(w->by->self, w->part, verdict, n);
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
    if (places == 0)
    {
        dem_text_add(&w->left, "    %s: it is not in the text of %s itself; change it where it is: %s\n", v->effect, w->by->scene, reason(v));
        return DEM_OK;
    }
    const char *const wrong = edited->status ? dem_error_text() : judge(w, edited->text, NULL, NULL);

    if (wrong)
    {
        dem_text_add(&w->left, "    %s: %s; but then: %s\n", v->effect, reason(v), wrong);
        return edited->status;
    }
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
    struct dem_verdict verdict[MOST_EDITS];               /* those that are looked at go when an edit is tried */
    const struct dem_verdict *said;
    int n = 0, status = DEM_OK;
    const char *const wrong = judge(w, w->text.text, &said, &n);

    *more = 0;
    DEM_REQUIRE(!wrong, DEM_ERROR_INPUT, "%s", wrong);
    n = n < MOST_EDITS ? n : MOST_EDITS;
    for (int k = 0; k < n; k++)
    {
        verdict[k] = said[k];
    }
    for (int k = 0; k < n && !status; k++)
    {
        if (verdict[k].word != DEM_NEEDED && !touched(w, verdict[k].effect))
        {
            w->touched[w->edits++] = dem_effects_find(verdict[k].effect)->name;
            *more = 1;
            status = edit(w, &verdict[k]);
        }
    }
    return status;
}

static int put_in_place(const struct rewrite *w)
{
    const char *const scene = w->by->scene;

    DEM_TRY(write_text(w->part, w->text.text));
    DEM_REQUIRE(rename(scene, w->before) == 0, DEM_ERROR_FILE, "can't rename %s to %s: %s", scene, w->before, strerror(errno));
    if (rename(w->part, scene) != 0)
    {
        const int why = errno, back = rename(w->before, scene) == 0;

        return dem_error(DEM_ERROR_FILE, "can't rename %s to %s: %s; the scene of before is %s", w->part, scene, strerror(why), back ? scene : w->before);
    }
    return DEM_OK;
}

static int tell(const struct rewrite *w)
{
    struct dem_text lines = {.n = 0};

    if (w->changed.n > 0)
    {
        dem_text_add(&lines, "%s has the plan's choice, %s what was before:\n%s", w->by->scene, w->before, w->changed.text);
    }
    else
    {
        dem_text_add(&lines, "%s stays as it is\n", w->by->scene);
    }
    if (w->left.n > 0)
    {
        dem_text_add(&lines, "left to you:\n%s", w->left.text);
    }
    const int status = lines.status;

    if (!status)
    {
        w->by->tell(w->by->self, lines.text);
    }
    dem_text_free(&lines);
    return status;
}

static int rewrite(struct rewrite *w)
{
    int more = 1;

    DEM_TRY(read_text(w->by->scene, &w->text));
    for (int k = 0; k < MOST_PASSES && more; k++)
    {
        DEM_TRY(pass(w, &more));
    }
    return w->changed.n > 0 ? put_in_place(w) : DEM_OK;
}

int dem_rewrite(const struct dem_rewriter *by)
{
    struct rewrite w = {.by = by};

    DEM_REQUIRE(strlen(by->scene) + 8 < PATH, DEM_ERROR_INPUT, "the scene's name, %s, is longer than %d letters; go to its folder and give the name alone",
                by->scene, PATH - 9);
    snprintf(w.part, sizeof w.part, "%s.part", by->scene);
    snprintf(w.before, sizeof w.before, "%s.before", by->scene);
    DEM_TRY(must_not_be(w.before));
    DEM_TRY(must_not_be(w.part));
    int status = rewrite(&w);

    remove(w.part);
    if (!status)
    {
        status = tell(&w);
    }
    dem_text_free(&w.text);
    dem_text_free(&w.changed);
    dem_text_free(&w.left);
    return status;
}
