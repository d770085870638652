/* Order statistics by digits. A double is mapped to a whole number of 64 bits of the same order; of these, 16 bits are
 * found at a time, the highest first: among the numbers that begin with the bits found so far, as many as have a lower
 * next digit are counted, until the rank is reached. This is a radix sort that keeps only the counts. */
#include "study/numbers.h"

#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/memory.h"

enum { DIGIT = 16 /* bits */, DIGITS = 64 / DIGIT, VALUES = 1 << DIGIT };

/* Returns a whole number that is ordered as the doubles are, -0 before 0. */
static uint64_t key_of(double number) {
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bits >> 63 ? ~bits : bits | UINT64_C(1) << 63;
}

static double number_of(uint64_t key) {
    uint64_t bits = key >> 63 ? key ^ UINT64_C(1) << 63 : ~key;
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

/* Ranks that share the digits found so far, and what they count. */
typedef struct Group {
    uint64_t prefix;
    uint64_t *counts; /* (VALUES) */
} Group;

typedef struct Search {
    const Numbers *numbers;
    const size_t *ranks; /* (count) */
    size_t count;
    uint64_t prefixes[NUMBERS_RANKS_MOST];
    size_t below[NUMBERS_RANKS_MOST]; /* numbers with a lower prefix */
    Group groups[NUMBERS_RANKS_MOST];
    size_t group_count;
} Search;

static Group *group_of(Search *search, uint64_t prefix) {
    for (size_t g = 0; g < search->group_count; g++)
        if (search->groups[g].prefix == prefix)
            return &search->groups[g];
    return NULL;
}

static void make_groups(Search *search) {
    search->group_count = 0;
    for (size_t r = 0; r < search->count; r++) {
        if (group_of(search, search->prefixes[r]))
            continue;
        Group *group = &search->groups[search->group_count++];
        group->prefix = search->prefixes[r];
        memset(group->counts, 0, VALUES * sizeof *group->counts);
    }
}

static void count_digits(Search *search, int digit) {
    int shift = 64 - DIGIT * (digit + 1);
    for (size_t i = 0; i < search->numbers->count; i++) {
        double number = numbers_at(search->numbers, i);
        if (!isfinite(number))
            continue;
        uint64_t key = key_of(number), shifted = key >> shift;
        Group *group = group_of(search, shifted >> DIGIT);
        if (group)
            group->counts[shifted % VALUES]++;
    }
}

static void take_digit(Search *search, size_t r) {
    const Group *group = group_of(search, search->prefixes[r]);
    uint64_t digit = 0;
    while (search->below[r] + group->counts[digit] <= search->ranks[r] && digit + 1 < VALUES)
        search->below[r] += group->counts[digit++];
    search->prefixes[r] = search->prefixes[r] << DIGIT | digit;
}

void numbers_find(const Numbers *numbers, const size_t *ranks, size_t count, double *found) {
    assert(count <= NUMBERS_RANKS_MOST);
    Search search = {.numbers = numbers, .ranks = ranks, .count = count};
    uint64_t *counts = memory_zeroed(count * VALUES, sizeof *counts);
    for (size_t g = 0; g < count; g++)
        search.groups[g].counts = counts + g * VALUES;
    for (int digit = 0; digit < DIGITS; digit++) {
        make_groups(&search);
        count_digits(&search, digit);
        for (size_t r = 0; r < count; r++)
            take_digit(&search, r);
    }
    for (size_t r = 0; r < count; r++)
        found[r] = number_of(search.prefixes[r]);
    memory_free(counts);
}
