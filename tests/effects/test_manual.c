/*
 * Claims: the table on the page of effects (dem/effects/README.md) is what the program prints; `dem effects WORD` prints one
 * of its entries, and a word nobody knows is refused; the effect and the test that dem/README.md shows are the files.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"

#include "main_effects.c"                                 /* of the program, which is not in the library */
#include "main_effects_cost.c"

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
        printf("Bail out! nothing read, or more than there is room for\n");
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

/* the line, counted from 1, where two texts part; 0 if they do not */
static int parting(const char *a, const char *b)
{
    int line = 1;

    for (; *a == *b && *a; a++, b++)
    {
        line += *a == '\n';
    }
    return *a == *b ? 0 : line;
}

/* a whole file stands on dem/README.md */
static void shown(const char *name)
{
    FILE *const file = fopen(name, "r"), *const manual = fopen("../dem/README.md", "r");

    in(file, printed);
    in(manual, page);
    fclose(file);
    fclose(manual);
    TAP_OK(strstr(page, printed) != NULL, "dem/README.md shows %s as it is", name);
}

int main(void)
{
    char *known[] = {"dry"}, *unknown[] = {"herz"};
    FILE *const file = fopen("../dem/effects/README.md", "r");

    in(file, page);
    fclose(file);
    TAP_OK(print(0, NULL) == DEM_OK, "dem effects");

    /* the first block of the page; the blank line after the last effect is not on it */
    char *const block = strstr(page, "\n```\n"), *const end = block ? strstr(block + 5, "```\n") : NULL;

    TAP_OK(block && end, "the page has a block");
    if (block && end)
    {
        *end = '\0';
        printed[strlen(printed) - 1] = '\0';
        const int line = parting(block + 5, printed);

        TAP_OK(line == 0, "the block is what dem effects prints%s", line ? "; make -C dem manual brings it up to date" : "");
        if (line)
        {
            TAP_NOTE("they part in line %d of the block", line);
        }
    }
    TAP_OK(print(1, known) == DEM_OK && strncmp(printed, "dry ", 4) == 0 && strstr(page, "\ndry "), "dem effects dry");
    TAP_OK(print(1, unknown) == DEM_ERROR_INPUT && strstr(dem_error_text(), "hertz"), "%s", dem_error_text());
    shown("../dem/effects/sjkr.c");
    shown("effects/test_sjkr.c");
    TAP_DONE;
}
