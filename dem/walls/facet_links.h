/*
 * facet_links.h -- union-find of triangles: triangles with the same root form one facet.
 *
 * Along periodic axes triangles also meet images of others. Each image has an offset, a number of
 * periods, and union-find adds up the offsets along its links. A facet that meets itself a period away
 * is joined to its own image and has no end there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* A triangle, displaced by `offset` periods, lies where it belongs beside its parent. */
struct dem_facet_link
{
    size_t parent;
    int offset[3];
    uint8_t endless;              /* of a root, see struct dem_facet */
};

/* The root of a triangle, and the offset of the triangle from there. */
size_t dem_facet_links_root(struct dem_facet_link *, size_t triangle, int offset[3]);

/* Triangle t, displaced by `offset` periods, continues triangle s: one facet. */
void dem_facet_links_unite(struct dem_facet_link *, size_t s, size_t t, const int offset[3]);

/* How many axes are endless, of all facets. */
size_t dem_facet_links_endless(const struct dem_facet_link *, size_t triangles);
