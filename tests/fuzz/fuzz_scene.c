/*
 * fuzz_scene.c -- any bytes as the text of a scene: read and checked as by dem plan, up to the
 * placing of particles.
 *
 * A zero byte ends the text, as in a string. Files that it names are searched for in the current
 * folder. The harness also reads the entries of the program and of the coupling (time/end and
 * others, write, coupling), which would otherwise be refused as unknown.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fuzz.h"
#include "input/dictionary.h"
#include <stdlib.h>
#include <string.h>

static void read_other_entries(const struct dem_dict *scene)
{
    static const char *const whole[] = {"write", "coupling"};
    const struct dem_dict *sub;
    double number;

    for (int k = 0; k < 2; k++)
    {
        if (!dem_dict_sub_if(scene, whole[k], &sub) && sub)
        {
            dem_dict_mark_read(sub);
        }
    }
    if (!dem_dict_sub_if(scene, "time", &sub) && sub)
    {
        (void)dem_dict_number(sub, "end", "s", &number);
        (void)dem_dict_number_or(sub, "maxCreated", "1", 0.0, &number);
        if (!dem_dict_sub_if(sub, "untilQuiet", &sub) && sub)
        {
            dem_dict_mark_read(sub);
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *const text = malloc(size + 1);
    struct dem_case *c;

    memcpy(text, data, size);
    text[size] = '\0';
    fuzz_trap();
    int status = dem_case_create(&c, MPI_COMM_NULL);

    if (!status)
    {
        status = dem_case_scene_text(c, text, "scene");
        if (!status)
        {
            read_other_entries(dem_case_dict(c));
        }
        status = status ? status : dem_case_check(c);
        fuzz_judge(status);
        dem_case_free(c);
    }
    fuzz_untrap();
    free(text);
    return 0;
}
