/*
 * hash.h -- one 64-bit number that changes when any bit of what was put in changes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * In order (a snapshot's checksum; how the bytes are cut into calls does not matter):
 *
 *     struct dem_hash h;
 *     dem_hash_start(&h, salt);
 *     dem_hash_bytes(&h, x, sizeof x);
 *     uint64_t sum = dem_hash_value(&h);      may go on after it
 *
 * In any order (the state of all particles on any number of ranks): each record holds its id, and the hashes
 * are added modulo 2^64, which MPI_SUM on MPI_UINT64_T does too.
 *
 *     sum += dem_hash_record(&record, sizeof record, 'p');
 *
 * A record must have no padding: build it from its members. Bits count, not values: 0.0 and -0.0 differ. The salt
 * keeps kinds of records apart. Guards against slips and damage, not against malice.
 *
 * Each 64-bit word (native byte order, the last one filled up with zeros) is added to the state by exclusive or
 * and stirred by the one-to-one mixer of base/random.h; the length goes in last.
 */
#ifndef DEM_IO_HASH_H
#define DEM_IO_HASH_H

#include <stddef.h>
#include <stdint.h>

struct dem_hash
{
    uint64_t state;
    uint64_t length;    /* bytes so far                        */
    uint64_t word;      /* the last length % 8 of them         */
};

void dem_hash_start(struct dem_hash *h, uint64_t salt);
void dem_hash_bytes(struct dem_hash *h, const void *bytes, size_t n);
uint64_t dem_hash_value(const struct dem_hash *h);

/* start, bytes and value in one. */
uint64_t dem_hash_record(const void *bytes, size_t n, uint64_t salt);

#endif
