/* Mutates JSON structurally: replaces numbers by numbers and values by other values of the same file, repeats,
 * removes and swaps members and elements. libFuzzer's own byte mutations test the parser, these test the code behind
 * it. */
#include <jansson.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed);

/* The place of a value in the document. */
typedef struct Slot {
    json_t *parent;
    const char *key; /* key in an object, NULL in an array */
    size_t index;
} Slot;

typedef struct Slots {
    Slot *at;
    size_t count, capacity;
} Slots;

static size_t draw(unsigned *state, size_t below) {
    *state = *state * 1664525 + 1013904223;
    return (*state >> 8) % below;
}

static void collect(Slots *slots, json_t *value) {
    const char *key;
    size_t i;
    json_t *child;
    json_object_foreach(value, key, child) {
        slots->at = memory_reserve(slots->at, &slots->capacity, slots->count + 1, sizeof *slots->at);
        slots->at[slots->count++] = (Slot){value, key, 0};
        collect(slots, child);
    }
    json_array_foreach(value, i, child) {
        slots->at = memory_reserve(slots->at, &slots->capacity, slots->count + 1, sizeof *slots->at);
        slots->at[slots->count++] = (Slot){value, NULL, i};
        collect(slots, child);
    }
}

static json_t *value_of(const Slot *slot) {
    return slot->key ? json_object_get(slot->parent, slot->key) : json_array_get(slot->parent, slot->index);
}

static void put(const Slot *slot, json_t *value) {
    if (slot->key)
        json_object_set_new(slot->parent, slot->key, value);
    else
        json_array_set_new(slot->parent, slot->index, value);
}

static json_t *other_number(unsigned *state, double from) {
    static const double numbers[] = {0,    1,    2,     3,    -1,    0.5,    0.12,   0.01,   1e-3,   1e-6,
                                     1e-7, 1e-9, 1e-12, 90,   45,    -180,   360,    1e5,    -1e5,   99999.9,
                                     5,    100,  1e6,   1e15, 1e300, 1e-300, 5e-324, 0x1p31, 0x1p53, -0.0};
    switch (draw(state, 4)) {
    case 0:
        return json_real(numbers[draw(state, sizeof numbers / sizeof *numbers)]);
    case 1:
        return json_real(from + 1e-7 * ((double)draw(state, 41) - 20));
    case 2:
        return json_real(from * ((double)draw(state, 41) / 10 - 2));
    default:
        return json_real(((double)draw(state, 2001) - 1000) / 100);
    }
}

static void change(const Slots *slots, unsigned *state) {
    const Slot *slot = &slots->at[draw(state, slots->count)], *other = &slots->at[draw(state, slots->count)];
    json_t *value = value_of(slot), *from = value_of(other);
    if (!value || !from)
        return; /* an earlier mutation removed it */
    switch (draw(state, 8)) {
    case 0:
        put(slot, json_deep_copy(from));
        break;
    case 1:
        if (slot->key)
            json_object_del(slot->parent, slot->key);
        else
            json_array_remove(slot->parent, slot->index);
        break;
    case 2:
        if (!slot->key)
            json_array_insert_new(slot->parent, slot->index, json_deep_copy(value));
        break;
    case 3:
        if (!slot->key && !other->key) {
            json_array_append_new(slot->parent, json_deep_copy(from));
            break;
        }
        if (other->key && json_is_object(value))
            json_object_set_new(value, other->key, json_deep_copy(from));
        break;
    default: /* most values of a file are numbers */
        if (json_is_number(value))
            put(slot, other_number(state, json_number_value(value)));
        else if (json_typeof(value) == json_typeof(from))
            put(slot, json_deep_copy(from));
    }
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed) {
    json_t *root = seed % 3 ? json_loadb((const char *)data, size, 0, NULL) : NULL;
    unsigned state = seed;
    for (size_t changes = 1 + draw(&state, 3); root && changes > 0; changes--) {
        Slots slots = {0};
        collect(&slots, root);
        if (slots.count)
            change(&slots, &state);
        memory_free(slots.at);
    }
    char *text = root ? json_dumps(root, JSON_ENCODE_ANY) : NULL;
    json_decref(root);
    size_t length = text ? strlen(text) : 0;
    bool fits = text && length <= most;
    if (fits)
        memcpy(data, text, length);
    free(text);
    return fits ? length : LLVMFuzzerMutate(data, size, most);
}
