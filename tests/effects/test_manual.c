/*
 * test_manual.c -- the list of laws in the manual is current.
 *
 * - The table in docs/effects.md is what the program prints.
 * - `dem effects WORD` prints one entry, and an unknown word is refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"

/* of the program, which is not in the library */
#include "app/command_effects.c"

#include <stdlib.h>
#include <unistd.h>

enum
{
    ROOM = 1 << 18
};

static char printed[ROOM], page[ROOM];

static void in(FILE *from, char *text)
{
    const size_t read = from ? fread(text, 1, ROOM - 1, from) : 0;

    if (read == 0 || read == ROOM - 1)
    {
        printf("Bail out! nothing read, or more than the buffer holds\n");
        exit(1);
    }
    text[read] = '\0';
}

/* what `dem effects ...` prints, into `printed` */
static int print(int argc, char **argv)
{
    struct dem_program program = {.ranks = 1};
    FILE *const file = tmpfile();
    const int own = dup(1);

    fflush(stdout);
    dup2(fileno(file), 1);
    const int status = dem_main_effects(&program, argc, argv);
    fflush(stdout);
    dup2(own, 1);
    close(own);
    rewind(file);
    if (status == DEM_OK)
    {
        in(file, printed);
    }
    fclose(file);
    return status;
}

/* the first line, from 1, in which two texts differ; 0 if none */
static int different_line(const char *a, const char *b)
{
    int line = 1;

    for (; *a == *b && *a; a++, b++)
    {
        line += *a == '\n';
    }
    return *a == *b ? 0 : line;
}

int main(void)
{
    char *known[] = {"dry"}, *unknown[] = {"herz"};
    FILE *const file = fopen("../docs/effects.md", "r");

    in(file, page);
    fclose(file);
    TAP_OK(print(0, NULL) == DEM_OK, "dem effects");

    /* the fenced block after a comment that names it; the blank line after the last effect is not
       in it */
    const char *const mark = "<!-- dem effects -->\n```\n";
    char *const found = strstr(page, mark), *const block = found ? found + strlen(mark) : NULL;
    char *const end = block ? strstr(block, "```\n") : NULL;

    TAP_OK(block && end, "the page has a block");
    if (block && end)
    {
        *end = '\0';
        printed[strlen(printed) - 1] = '\0';
        const int line = different_line(block, printed);

        TAP_OK(line == 0, "the block is what dem effects prints%s",
               line ? "; make -C dem manual brings it up to date" : "");
        if (line)
        {
            TAP_NOTE("they differ in line %d of the block", line);
        }
    }
    TAP_OK(print(1, known) == DEM_OK && strncmp(printed, "dry ", 4) == 0 && strstr(page, "\ndry "),
           "dem effects dry");
    TAP_OK(print(1, unknown) == DEM_ERROR_INPUT && strstr(dem_error_text(), "hertz"), "%s",
           dem_error_text());
    TAP_DONE;
}
