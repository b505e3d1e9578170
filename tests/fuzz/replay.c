/*
 * replay.c -- a harness with the plain build: reads each file once and prints the outcome, one line
 * a file.
 *
 *     replay_READER FILE ...          NAME: accepted, or NAME: SENTENCE
 *     replay_snapshot -seed FILE N    writes the state after N steps to FILE, as a seed
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fuzz.h"
#include "fuzz_snapshot.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#pragma weak fuzz_snapshot

static int put_in(const char *path)
{
    FILE *const f = fopen(path, "rb");
    const char *const slash = strrchr(path, '/');
    long size = 0;

    if (!f || fseek(f, 0, SEEK_END) || (size = ftell(f)) < 0 || fseek(f, 0, SEEK_SET))
    {
        perror(path);
        return 1;
    }
    uint8_t *const data = malloc((size_t)size + 1);
    const size_t got = fread(data, 1, (size_t)size, f);

    fclose(f);
    LLVMFuzzerTestOneInput(data, got);
    free(data);
    printf("%s: %s\n", slash ? slash + 1 : path, fuzz_status() ? dem_error_text() : "accepted");
    return fflush(stdout);
}

int main(int argc, char **argv)
{
    int bad = 0;

    if (argc == 4 && strcmp(argv[1], "-seed") == 0 && fuzz_snapshot)
    {
        bad = fuzz_snapshot(argv[2], atoi(argv[3]));
        fprintf(stderr, "%s", bad ? dem_error_text() : "");
        return bad;
    }
    for (int k = 1; k < argc; k++)
    {
        bad |= put_in(argv[k]);
    }
    return bad;
}
