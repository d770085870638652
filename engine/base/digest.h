/* A digest of numbers: 64 bits that change when any bit of the input changes. */
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "base/vec2.h"

#define DIGEST_START 0xcbf29ce484222325u

static inline uint64_t digest_mix(uint64_t digest, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    digest = (digest ^ bits) * 0x9e3779b97f4a7c15u;
    return digest ^ (digest >> 29);
}

static inline uint64_t digest_pair(uint64_t digest, Vec2 pair) {
    return digest_mix(digest_mix(digest, pair.x), pair.y);
}

static inline uint64_t digest_bytes(uint64_t digest, const void *bytes, size_t count) {
    const unsigned char *byte = (const unsigned char *)bytes;
    for (size_t i = 0; i < count; i++)
        digest = (digest ^ byte[i]) * 0x100000001b3u;
    return (digest ^ count) * 0x9e3779b97f4a7c15u;
}

/* Mixes in a text with its terminating 0, so that two texts differ from their concatenation. */
static inline uint64_t digest_text(uint64_t digest, const char *text) {
    return digest_bytes(digest, text, strlen(text) + 1);
}

/* Mixes in another digest; the order matters. */
static inline uint64_t digest_chain(uint64_t digest, uint64_t next) {
    return (digest ^ next) * 0x100000001b3u;
}
