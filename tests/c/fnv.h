/* Fowler, Noll and Vo's hash of 64 bits, FNV-1a, for the tests in C. Numbers are little-endian on every supported machine. */

#ifndef FNV_H
#define FNV_H

#include <stddef.h>
#include <stdint.h>

/* The hash of no byte. */
#define FNV_NONE UINT64_C(0xcbf29ce484222325)

static uint64_t fnv(uint64_t hash, const void *bytes, size_t count)
{
    const unsigned char *byte = (const unsigned char *)bytes;
    size_t i;
    for (i = 0; i < count; i++) {
        hash = (hash ^ byte[i]) * UINT64_C(0x100000001b3);
    }
    return hash;
}

#endif
