/*
 * plan_rewrite.c -- apply the verdicts of a plan to the text of a scene (`dem plan -write`).
 *
 * The edited text is kept next to the scene while it is tried (SCENE.part, so that #include and
 * files are found). Each edit must leave a scene that can be opened, otherwise it is undone and
 * reported. After all edits of a plan the scene is planned again, until a plan asks for no further
 * edit. The previous text is kept as SCENE.before. The caller (dem_scene_rewriter) opens and plans the
 * scene: the program, or a solver with its mesh and fluid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan_rewrite.h"
#include "dem.h"
#include "core/error.h"
#include "core/memory.h"
#include "laws/effects.h"
#include "core/file.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>

enum
{
    MAX_PASSES = 6, MAX_EDITS = 48, PATH = 1024
};

struct rewrite
{
    const struct dem_scene_rewriter *by;
    char part[PATH], before[PATH];
    struct dem_text text;                                 /* of the scene, as edited so far */
    /* report: edits made, and edits left to the user */
    struct dem_text changed, left;
    /* effects already edited: none is edited twice */
    const char *edited_effects[MAX_EDITS];
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
    DEM_REQUIRE(!failed, DEM_ERROR_FILE, "cannot write %s: %s", path, strerror(errno));
    return DEM_OK;
}

static int require_absent(const char *path)
{
    DEM_REQUIRE(!dem_file_exists(path), DEM_ERROR_FILE,
                "%s is there already and would be overwritten by -write; move or delete it", path);
    return DEM_OK;
}

/* ---- one edit -------------------------------------------------------------------------------------------------- */

/* NULL, or the reason why this text is not a valid scene; if verdict is not NULL, also the
   verdicts of its plan. */
static const char *judge(const struct rewrite *w, const char *text,
                         const struct dem_verdict **verdict, int *n)
{
    return write_text(w->part, text) ? dem_error_text()
                                     : w->by->evaluate(w->by->self, w->part, verdict, n);
}

/* The reason for an edit, for comments and the report; valid until the next call on this thread. */
static const char *reason(const struct dem_verdict *v)
{
    static _Thread_local char text[256];

    snprintf(text, sizeof text, "%.2g %% %s", 100.0*v->fraction, v->why);
    return text;
}

/* Accepts the edited text if it is a valid scene. */
static int accept_edit(struct rewrite *w, struct dem_text *edited, int places,
                       const struct dem_verdict *v, const char *done)
{
    if (places == 0)
    {
        dem_text_add(
            &w->left,
            "    %s: it is not in the text of %s itself; change it in the included file: %s\n",
            v->effect, w->by->scene, reason(v));
        return DEM_OK;
    }
    const char *const error =
        edited->status ? dem_error_text() : judge(w, edited->text, NULL, NULL);

    if (error)
    {
        dem_text_add(&w->left, "    %s: %s; but then: %s\n", v->effect, reason(v), error);
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

    if (v->missing_setting)
    {
        dem_text_add(&w->left, "    %s%s%s: %s; give it %s\n", v->effect,
                     v->replaces ? " in place of " : "", v->replaces ? v->replaces : "", reason(v),
                     v->missing_setting);
        return DEM_OK;
    }
    if (v->word == DEM_NEGLIGIBLE && effect->stage == DEM_STAGE_NORMAL)
    {
        dem_text_add(&w->left,
                     "    %s is negligible, but contacts need a normal law: choose another one\n",
                     v->effect);
        return DEM_OK;
    }
    if (v->word == DEM_NEGLIGIBLE && effect->stage == DEM_STAGE_DAMP)
    {
        const char *const plain = dem_effects_first(DEM_STAGE_DAMP)->name;

        snprintf(done, sizeof done, "replaced by %s", plain);
        places = dem_edit_rename(&edited, w->text.text, v->effect, plain, reason(v));
    }
    else if (v->word == DEM_NEGLIGIBLE)
    {
        snprintf(done, sizeof done, "commented out");
        places = dem_edit_comment_out(&edited, w->text.text, v->effect, reason(v));
    }
    else if (v->replaces)
    {
        snprintf(done, sizeof done, "in place of %s", v->replaces);
        places = dem_edit_rename(&edited, w->text.text, v->replaces, v->effect, reason(v));
    }
    else
    {
        places = dem_edit_add(&edited, w->text.text, v->effect, reason(v));
    }
    const int status = accept_edit(w, &edited, places, v, done);

    dem_text_free(&edited);
    return status;
}

/* ---- all of them ----------------------------------------------------------------------------------------------- */

static int was_edited(const struct rewrite *w, const char *effect)
{
    for (int k = 0; k < w->edits; k++)
    {
        if (strcmp(w->edited_effects[k], effect) == 0)
        {
            return 1;
        }
    }
    return w->edits == MAX_EDITS;
}

/* One plan and its edits; *more: 1 if there was something to edit. */
static int pass(struct rewrite *w, int *more)
{
    /* a copy: trying an edit replaces those of the caller */
    struct dem_verdict verdict[MAX_EDITS];
    const struct dem_verdict *verdicts;
    int n = 0, status = DEM_OK;
    const char *const error = judge(w, w->text.text, &verdicts, &n);

    *more = 0;
    DEM_REQUIRE(!error, DEM_ERROR_INPUT, "%s", error);
    n = n < MAX_EDITS ? n : MAX_EDITS;
    for (int k = 0; k < n; k++)
    {
        verdict[k] = verdicts[k];
    }
    for (int k = 0; k < n && !status; k++)
    {
        if (verdict[k].word != DEM_NEEDED && !was_edited(w, verdict[k].effect))
        {
            w->edited_effects[w->edits++] = dem_effects_find(verdict[k].effect)->name;
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
    DEM_REQUIRE(rename(scene, w->before) == 0, DEM_ERROR_FILE, "cannot rename %s to %s: %s", scene,
                w->before, strerror(errno));
    if (rename(w->part, scene) != 0)
    {
        const int why = errno, back = rename(w->before, scene) == 0;

        return dem_error(DEM_ERROR_FILE, "cannot rename %s to %s: %s; the original scene is %s",
                         w->part, scene, strerror(why), back ? scene : w->before);
    }
    return DEM_OK;
}

static int report(const struct rewrite *w)
{
    struct dem_text lines = {.n = 0};

    if (w->changed.n > 0)
    {
        dem_text_add(&lines, "%s has been edited as planned, the original text is %s:\n%s",
                     w->by->scene, w->before, w->changed.text);
    }
    else
    {
        dem_text_add(&lines, "%s stays as it is\n", w->by->scene);
    }
    if (w->left.n > 0)
    {
        dem_text_add(&lines, "left to the user:\n%s", w->left.text);
    }
    const int status = lines.status;

    if (!status)
    {
        w->by->report(w->by->self, lines.text);
    }
    dem_text_free(&lines);
    return status;
}

static int rewrite(struct rewrite *w)
{
    int more = 1;

    DEM_TRY(read_text(w->by->scene, &w->text));
    for (int k = 0; k < MAX_PASSES && more; k++)
    {
        DEM_TRY(pass(w, &more));
    }
    return w->changed.n > 0 ? put_in_place(w) : DEM_OK;
}

int dem_scene_rewrite(const struct dem_scene_rewriter *by)
{
    struct rewrite w = {.by = by};

    DEM_REQUIRE(
        strlen(by->scene) + 8 < PATH, DEM_ERROR_INPUT,
        "the name of the scene, %s, is longer than %d characters; run in its folder and give the file name only",
        by->scene, PATH - 9);
    snprintf(w.part, sizeof w.part, "%s.part", by->scene);
    snprintf(w.before, sizeof w.before, "%s.before", by->scene);
    DEM_TRY(require_absent(w.before));
    DEM_TRY(require_absent(w.part));
    int status = rewrite(&w);

    remove(w.part);
    if (!status)
    {
        status = report(&w);
    }
    dem_text_free(&w.text);
    dem_text_free(&w.changed);
    dem_text_free(&w.left);
    return status;
}
