/*
 * hash.h -- 64-bit hash for checksums and for order-independent fingerprints of sets of records.
 *
 * Ordered (the checksum of a snapshot; how the bytes are split into calls does not matter):
 *
 *     struct dem_hash h;
 *     dem_hash_start(&h, salt);
 *     dem_hash_bytes(&h, x, sizeof x);
 *     uint64_t sum = dem_hash_value(&h);      dem_hash_bytes may follow
 *
 * Unordered (the state of all particles on any number of ranks): each record holds its id, and the
 * hashes are added modulo 2^64, which MPI_SUM on MPI_UINT64_T does too.
 *
 *     sum += dem_hash_record(&record, sizeof record, 'p');
 *
 * A record must have no padding: build it from its members. Bits count, not values: 0.0 and -0.0
 * differ. The salt separates kinds of records. Detects accidental changes, not deliberate ones.
 *
 * Each 64-bit word (native byte order, the last one padded with zeros) is combined with the state
 * by exclusive or and mixed by the bijective mixer of core/random.h; the length goes in last.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

struct dem_hash
{
    uint64_t state;
    uint64_t length;  /* bytes so far */
    uint64_t word;    /* the last length % 8 bytes */
};

void dem_hash_start(struct dem_hash *h, uint64_t salt);
void dem_hash_bytes(struct dem_hash *h, const void *bytes, size_t n);
uint64_t dem_hash_value(const struct dem_hash *h);

/* dem_hash_start, dem_hash_bytes and dem_hash_value in one call. */
uint64_t dem_hash_record(const void *bytes, size_t n, uint64_t salt);
