#include "base/provenance.h"

#include <stdio.h>
#include <string.h>

#include "base/parameters_schema.h"

enum { SOURCES_LONGEST = 200 /* characters of the text of all sources */ };

const char *provenance_name(const Parameter *row, const char *group) {
    size_t length = strlen(group);
    return strncmp(row->name, group, length) == 0 && row->name[length] == '.' ? row->name + length + 1 : NULL;
}

/* Returns the length of the first source; the next one begins after the bar. */
static size_t source_length(const char *sources) {
    return strcspn(sources, "|");
}

static bool begins_well(const char *text, const char *sources) {
    for (const char *at = sources; text && *at; at += source_length(at), at += *at == '|')
        if (strncmp(text, at, source_length(at)) == 0)
            return true;
    return false;
}

/* Writes "paper, literature: or assumed". */
static void say_sources(const char *sources, char words[SOURCES_LONGEST]) {
    size_t used = 0;
    for (const char *at = sources; *at && used < SOURCES_LONGEST; at += source_length(at), at += *at == '|') {
        size_t length = source_length(at);
        bool first = at == sources, last = !at[length];
        int written = snprintf(words + used, SOURCES_LONGEST - used, "%s%.*s",
                               first  ? ""
                               : last ? " or "
                                      : ", ",
                               (int)(length - (length && at[length - 1] == ' ')), at);
        used += (size_t)written;
    }
}

void provenance_read(const Parameter *row, void *object, const char **provenance, const JsonNode *node,
                     const char *sources, Arena *arena, Fault *fault) {
    static const char *const keys[] = {"value", "provenance", NULL};
    const char *name = strchr(row->name, '.') + 1;
    json_check_keys(node, keys, fault);
    JsonNode value = json_member(node, "value"), source = json_member(node, "provenance");
    if (value.value)
        parameters_read_value(row, object, &value, arena, fault);
    else
        json_fault(node, fault, "%s has no \"value\"", name);
    if (begins_well(json_string_value(source.value), sources)) {
        *provenance = arena_text(arena, json_string_value(source.value));
        return;
    }
    char words[SOURCES_LONGEST];
    say_sources(sources, words);
    json_fault(source.value ? &source : node, fault, "provenance of %s must begin with %s", name, words);
}

json_t *provenance_schema(const Parameter *row, const char *sources) {
    json_t *provenance = json_pack("{s:s, s:o}", "type", "string", "pattern", json_sprintf("^(%s)", sources));
    return json_pack("{s:s, s:b, s:{s:o, s:o}, s:[s,s]}", "type", "object", "additionalProperties", 0, "properties",
                     "value", parameters_schema_value(row), "provenance", provenance, "required", "value",
                     "provenance");
}
