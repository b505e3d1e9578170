/*
 * test_error.c -- an error keeps its whole sentence, per thread, with its context in front, and
 * returns its status.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/error.h"

#include <stdlib.h>
#include <string.h>
#include <threads.h>

static int needs_small(int n, int *reached)
{
    DEM_REQUIRE(n < 3, DEM_ERROR_INPUT, "n is %d, more than %d; use less", n, 2);
    *reached = 1;
    return DEM_OK;
}

static int passes_on(int n, int *reached)
{
    int ignored;

    DEM_TRY(needs_small(n, &ignored));
    *reached = 1;
    return DEM_OK;
}

static int other_thread(void *first)
{
    strcpy(first, dem_error_text());
    return dem_error(DEM_ERROR_FILE, "of the other thread");
}

static void try_and_require(void)
{
    int reached = 0;

    TAP_OK(passes_on(2, &reached) == DEM_OK && reached,
           "a call that succeeds returns to the caller");
    reached = 0;
    TAP_OK(passes_on(3, &reached) == DEM_ERROR_INPUT && !reached,
           "a call that fails makes the caller return its status");
    TAP_OK(strcmp(dem_error_text(), "n is 3, more than 2; use less") == 0,
           "the sentence contains its numbers: %s", dem_error_text());
}

static void context(void)
{
    dem_error(DEM_ERROR_INPUT, "no value");
    TAP_OK(dem_error_prefix(DEM_ERROR_FILE, "line %d: ", 12) == DEM_ERROR_FILE,
           "context returns the status it is given");
    TAP_OK(strcmp(dem_error_text(), "line 12: no value") == 0, "context is in front: %s",
           dem_error_text());
    dem_error(DEM_ERROR_STATE, "(%s)", dem_error_text());
    TAP_OK(strcmp(dem_error_text(), "(line 12: no value)") == 0,
           "a sentence may quote the previous one: %s", dem_error_text());
}

static void long_sentences(void)
{
    char *word = malloc(2*DEM_ERROR_TEXT_SIZE);

    memset(word, 'x', 2*DEM_ERROR_TEXT_SIZE - 1);
    word[2*DEM_ERROR_TEXT_SIZE - 1] = '\0';
    dem_error(DEM_ERROR_INPUT, "%s", word);
    TAP_OK(strlen(dem_error_text()) == DEM_ERROR_TEXT_SIZE - 1,
           "a long sentence is cut to the buffer");
    TAP_OK(strcmp(dem_error_text() + DEM_ERROR_TEXT_SIZE - 5, "x...") == 0, "and ends with ...");
    dem_error_prefix(DEM_ERROR_INPUT, "here: ");
    TAP_OK(strncmp(dem_error_text(), "here: xxx", 9) == 0
           && strlen(dem_error_text()) == DEM_ERROR_TEXT_SIZE - 1,
           "context before a full sentence cuts the end of the sentence");
    dem_error_prefix(DEM_ERROR_INPUT, "%s", word);
    TAP_OK(strlen(dem_error_text()) == DEM_ERROR_TEXT_SIZE - 1,
           "context that is too long is cut as well");
    free(word);
}

static void threads(void)
{
    char seen[DEM_ERROR_TEXT_SIZE] = "untouched";
    int status = DEM_OK;
    thrd_t thread;

    dem_error(DEM_ERROR_INPUT, "of this thread");
    if (TAP_OK(thrd_create(&thread, other_thread, seen) == thrd_success, "a second thread starts"))
    {
        thrd_join(thread, &status);
        TAP_OK(seen[0] == '\0', "it starts with an empty sentence");
        TAP_OK(status == DEM_ERROR_FILE, "its status is returned");
        TAP_OK(strcmp(dem_error_text(), "of this thread") == 0,
               "its sentence does not replace ours");
    }
}

int main(void)
{
    TAP_TRAPS;
    TAP_OK(dem_error_text()[0] == '\0', "before the first failure the sentence is empty");
    TAP_OK(DEM_OK == 0, "success is zero");
    try_and_require();
    context();
    long_sentences();
    threads();
    TAP_DONE;
}
