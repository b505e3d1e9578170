/*
 * test_hostile.c -- files and numbers that no user intends (pipes, include bombs, 20 000 names,
 * astronomic values) are refused quickly, with one sentence.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"
#include "dem_query.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum
{
    NAMES = 20000,
    PATIENCE = 100  /* s: for all; a pipe that is opened for reading waits for ever */
};

static const char head[] =
    "materials { glass { density 2500; youngsModulus 1e7; } } "
    "effects { hertz {} dry { restitution 0.9; } gravity { acceleration (0 0 -9.81); } } ";

static char folder[] = "/tmp/test_hostile_XXXXXX";

/* The status of a start from a scene, of a file or this text, and a snapshot unless NULL. */
static int status_of(const char *file, const char *text, const char *snapshot)
{
    struct dem_case *c;
    struct dem *d = NULL;
    int status = dem_case_create(&c, MPI_COMM_NULL);

    status = status ? status : file ? dem_case_scene_file(c, file) : dem_case_scene_text(c, text, "scene");
    status = status || !snapshot ? status : dem_case_load(c, snapshot);
    status = status ? status : dem_case_check(c);
    status = status ? status : dem_start(&c, &d);
    dem_case_free(c);
    dem_free(d);
    return status;
}

static int run_file(const char *path)
{
    return status_of(path, NULL, NULL);
}

static void refused(int status, const char *words, const char *what)
{
    TAP_OK(status && strstr(dem_error_text(), words) && !strchr(dem_error_text(), '\n'),
           "%s is refused: %s", what, status ? dem_error_text() : "accepted");
}

__attribute__((format(printf, 2, 3)))
static void refused_scene(const char *words, const char *format, ...)
{
    char text[2048];
    va_list arguments;
    const int n = snprintf(text, sizeof text, "%s", head);

    va_start(arguments, format);
    vsnprintf(text + n, sizeof text - (size_t)n, format, arguments);
    va_end(arguments);
    refused(status_of(NULL, text, NULL), words, text + n);
}

/* ---- files ----------------------------------------------------------------------------------- */

static void write_file(const char *path, const char *text)
{
    FILE *const f = fopen(path, "w");

    if (!f || fputs(text, f) < 0 || fclose(f))
    {
        perror(path);
        exit(1);
    }
}

static void other_files(const char *path, const char *kind)
{
    char text[512], including[256];

    refused(run_file(path), kind, "a scene");
    snprintf(including, sizeof including, "%s/including", folder);
    snprintf(text, sizeof text, "#include \"%s\"\n", path);
    write_file(including, text);
    refused(run_file(including), kind, "an include");
    refused_scene(kind, "insert { t { type table; file \"%s\"; } }", path);
    refused_scene(kind, "walls { w { type stl; file \"%s\"; } }", path);
    refused_scene(kind, "insert { r { type random; count 1; sizes { type table; file \"%s\"; } "
                  "min (0 0 0); max (1 1 1); } }", path);
    refused(status_of(NULL, head, path), kind, "a snapshot");
}

/* Each of these files includes the next one ten times: 1e11 files. */
static void bomb(void)
{
    char path[256], text[1024];

    for (int k = 0; k < 12; k++)
    {
        size_t n = 0;

        text[0] = '\0';
        for (int m = 0; m < 10 && k < 11; m++)
        {
            n += (size_t)snprintf(text + n, sizeof text - n, "#include \"i%d\"\n", k + 1);
        }
        snprintf(path, sizeof path, "%s/i%d", folder, k);
        write_file(path, text);
    }
    snprintf(path, sizeof path, "%s/i0", folder);
    refused(run_file(path), "more than 1000 files", "includes within includes");

    char *const flat = calloc(1001, 16);

    for (int k = 0; k < 1001; k++)
    {
        strcat(flat + 15*k, "#include \"i11\"\n");
    }
    snprintf(path, sizeof path, "%s/flat", folder);
    write_file(path, flat);
    refused(run_file(path), "more than 1000 files", "1001 includes of an empty file");
    free(flat);
}

/* ---- names ----------------------------------------------------------------------------------- */

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9*(double)t.tv_nsec;
}

/* Processor time to read n sections or entries named x0, x1, ... of this form. */
static double time_of(const char *before, const char *each, const char *after, int n)
{
    char *const text = malloc(sizeof head + 512 + (size_t)n*(strlen(each) + 48));
    size_t at = (size_t)sprintf(text, "%s time { step 1e-5; } %s", head, before);

    for (int k = 0; k < n; k++)
    {
        at += (size_t)sprintf(text + at, "x%d %s ", k, each);
    }
    strcpy(text + at, after);
    const double start = seconds();
    struct dem_case *c;
    int status = dem_case_create(&c, MPI_COMM_NULL);

    status = status ? status : dem_case_scene_text(c, text, "scene");
    dem_case_free(c);
    free(text);
    const double took = seconds() - start;

    TAP_OK(status == 0 || strstr(dem_error_text(), "unknown entry"), "%s%s: %s", before, each,
           status ? dem_error_text() : "read");
    return took;
}

/* Eight times as many take eight times as long, or 64 times where each is compared with each; the
   geometric mean is between them. Under 0.2 s they are fast enough on any machine. */
static void linear(const char *before, const char *each, const char *after)
{
    const double few = time_of(before, each, after, NAMES/8),
                 many = time_of(before, each, after, NAMES);

    TAP_OK(many < 0.2 || many < 22.6*few, "%s x 20000: %.2g s, %.2g s for an eighth", before, many,
           few);
}

int main(void)
{
    char pipe[256];

    alarm(PATIENCE);
    if (!mkdtemp(folder))
    {
        perror(folder);
        return 1;
    }
    snprintf(pipe, sizeof pipe, "%s/pipe", folder);
    TAP_OK(mkfifo(pipe, 0600) == 0, "a pipe is made");
    other_files(pipe, "it is a pipe");
    other_files("/dev/zero", "it is a device");
    other_files(folder, "it is a folder");
    bomb();

    linear("walls {", "{ type plane; point (0 0 0); normal (0 0 1); }", "}");
    linear("insert {", "{ type list; diameter 1e-3; positions ((0 0 0)); }", "}");
    linear("outlets {", "{ point (0 0 0); normal (0 0 1); }", "}");
    linear("averages {", "{ min (0 0 0); max (1 1 1); cells (1 1 1); interval 1; }", "}");
    linear("unused {", "1;", "}");

    refused_scene("positions are multiples of", "domain { x (0 1e12); periodic (x); } "
                  "insert { g { type list; diameter 1e-3; positions ((0 0 0)); } }");
    refused_scene("positions are multiples of", "domain { x (0 1e300); periodic (x); } "
                  "insert { g { type list; diameter 1e-3; positions ((0 0 0)); } }");
    refused_scene("positions are multiples of", "domain { y (4.9e6 4.900001e6); periodic (y); } "
                  "insert { g { type list; diameter 1e-3; positions ((0 4.9e6 0)); } }");
    refused_scene("radii of", "insert { g { type list; diameter 1e-3; positions ((0 0 1e7)); } }");
    refused_scene("from the origin", "insert { g { type stream; rate 1; diameter 1e-3; "
                  "min (1e7 0 0); max (1.1e7 1 1); } }");
    refused_scene("speed of light", "insert { g { type list; diameter 1e-3; positions ((0 0 1)); "
                  "spin (1e300 0 0); } }");
    refused_scene("speed of light", "insert { g { type list; diameter 1e-3; "
                  "positions ((0 0 1) (1 0 1)); spins ((0 0 0) (0 6e11 0)); } }");
    refused_scene("speed of light", "insert { g { type stream; rate 1; diameter 1e-3; "
                  "min (0 0 0); max (1 1 1); spin (0 0 1e12); } }");
    refused_scene("pass the largest", "insert { a { type list; diameter 1e-3; "
                  "positions ((0 0 0)); ids (9223372036854775806); } "
                  "b { type list; diameter 1e-3; positions ((1 0 0)); } }");
    refused_scene("the list positions is empty",
                  "insert { g { type list; diameter 1e-3; positions (); } }");
    refused_scene("line 1: the name of this entry has a comma", "walls { a,b { type plane; point (0 0 0); "
                  "normal (0 0 1); } }");
    snprintf(pipe, sizeof pipe, "rm -r %s", folder);
    TAP_OK(system(pipe) == 0, "its files are removed");
    TAP_DONE;
}
