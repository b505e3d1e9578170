/*
 * facet_links.c -- union-find of triangles that are one facet: see facet_links.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/facet_links.h"
#include <string.h>

size_t dem_facet_links_root(struct dem_facet_link *link, size_t t, int offset[3])
{
    memset(offset, 0, 3*sizeof *offset);
    while (link[t].parent != t)
    {
        const struct dem_facet_link *const up = &link[link[t].parent];

        for (int k = 0; k < 3; k++)
        {
            link[t].offset[k] += up->offset[k];           /* 0 of a root */
            offset[k] += link[t].offset[k];
        }
        t = link[t].parent = up->parent;
    }
    return t;
}

/* A facet continues in its own image, `total` periods away. Along one axis, besides those where it is endless
   already, that makes it endless: its images by one period lie in its plane. */
static void meet_itself(struct dem_facet_link *root, const int total[3])
{
    int axes = 0, along = 0;

    for (int k = 0; k < 3; k++)
    {
        if (total[k] != 0 && !(root->endless >> k & 1))
        {
            axes++;
            along = k;
        }
    }
    root->endless |= (uint8_t)((axes == 1) << along);
}

void dem_facet_links_unite(struct dem_facet_link *link, size_t s, size_t t, const int offset[3])
{
    int of_s[3], of_t[3], total[3];
    const size_t rs = dem_facet_links_root(link, s, of_s), rt = dem_facet_links_root(link, t, of_t);

    for (int k = 0; k < 3; k++)
    {
        total[k] = of_s[k] + offset[k] - of_t[k];
    }
    if (rs == rt)
    {
        meet_itself(&link[rs], total);
        return;
    }
    for (int k = 0; k < 3; k++)
    {
        link[rs < rt ? rt : rs].offset[k] = rs < rt ? total[k] : -total[k];
    }
    link[rs < rt ? rt : rs].parent = rs < rt ? rs : rt;
    link[rs < rt ? rs : rt].endless |= link[rs < rt ? rt : rs].endless;
}

size_t dem_facet_links_endless(const struct dem_facet_link *link, size_t triangles)
{
    size_t n = 0;

    for (size_t t = 0; t < triangles; t++)
    {
        n += (size_t)__builtin_popcount(link[t].endless);
    }
    return n;
}
