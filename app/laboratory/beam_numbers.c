#include "laboratory/beam_numbers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"

static bool is_whole(const Parameter *row) {
    return row->kind == PARAMETER_WHOLE || row->kind == PARAMETER_CHOICE;
}

double beam_numbers_get(const Parameter *row, const Beam *beam) {
    const void *field = (const char *)beam + row->offset;
    return is_whole(row) ? *(const int *)field : *(const double *)field;
}

/* The nth word of "force|gap" and its length; NULL: there are not so many. */
static const char *word_at(const char *choices, double place, size_t *length) {
    const char *at = choices;
    for (int i = 0; i < place && at; i++) {
        at = strchr(at, '|');
        at = at ? at + 1 : NULL;
    }
    *length = at ? strcspn(at, "|") : 0;
    return place >= 0 ? at : NULL;
}

static json_t *value_of(const Parameter *row, double value) {
    size_t length;
    if (row->kind != PARAMETER_CHOICE)
        return json_number(value);
    const char *word = word_at(row->choices, value, &length);
    return word ? json_stringn(word, length) : json_string("");
}

bool beam_numbers_set(const Parameter *row, Beam *beam, double value, Fault *fault) {
    if (!isfinite(value)) {
        fault_add(fault, "%s must be a number", row->name);
        return false;
    }
    char place[] = "";
    Arena none = {0}; /* numbers need no room */
    JsonFile file = {.path = place, .root = value_of(row, value)};
    JsonNode node = json_root(&file);
    bool good = parameters_read_value(row, beam, &node, &none, fault);
    json_decref(file.root);
    return good;
}

const char *beam_numbers_text(const Parameter *row, double value, Arena *arena) {
    enum { EXACT = 17 /* digits tell any two numbers apart */ };
    size_t length;
    if (row->kind == PARAMETER_CHOICE) {
        const char *word = word_at(row->choices, value, &length);
        return word ? text_in_arena(arena, "%.*s", (int)length, word) : "";
    }
    char text[40];
    int digits = 6;
    do
        snprintf(text, sizeof text, "%.*g", digits, value);
    while (strtod(text, NULL) != value && digits++ < EXACT);
    return arena_text(arena, text);
}

bool beam_numbers_same_rig(const Beam *a, const Beam *b) {
    Beam like = *b;
    like.frequency = a->frequency;
    like.force = a->force;
    like.clearance = a->clearance;
    const ParameterTable *table = beam_table();
    for (size_t i = 0; i < table->count; i++)
        if (beam_numbers_get(&table->rows[i], a) != beam_numbers_get(&table->rows[i], &like))
            return false;
    return true;
}

bool beam_numbers_followed(const Beam *beam, const Rig *rig) {
    return 1 / (beam->frequency * rig->cell) <= RIG_CELLS_MOST;
}

bool beam_numbers_same(const Beam *a, const Beam *b) {
    return a->frequency == b->frequency && a->force == b->force && a->clearance == b->clearance &&
           beam_numbers_same_rig(a, b);
}
