#include "base/provenance_file.h"

#include <stdio.h>
#include <string.h>

#include "base/file_write.h"
#include "base/parameters_number.h"
#include "base/parameters_schema.h"

/* Provenance of a value given as a bare number. */
#define WITHOUT "given without provenance"

enum { KEYS_MOST = 64 };

bool provenance_file_is(const ProvenanceFile *kind, const char *path) {
    JsonFile file = {0};
    Fault fault = {0};
    bool is = json_read(&file, path, &fault);
    const char *format = is ? json_string_value(json_object_get(file.root, "format")) : NULL;
    is = format && strcmp(format, kind->format) == 0;
    json_free(&file);
    fault_clear(&fault);
    return is;
}

/* True if a row of the group has no fallback. */
static bool is_needed(const ProvenanceFile *kind, const char *group) {
    for (size_t i = 0; i < kind->table->count; i++)
        if (kind->table->rows[i].needed && provenance_name(&kind->table->rows[i], group))
            return true;
    return false;
}

static void read_value(const ProvenanceFile *kind, const ProvenanceTarget *target, size_t index, const JsonNode *group,
                       const char *name, Fault *fault) {
    const Parameter *row = &kind->table->rows[index];
    JsonNode node = json_member(group, name);
    target->provenance[index] = node.value ? WITHOUT : "assumed: the usual value";
    if (!node.value) {
        if (row->needed)
            json_fault(group, fault, "%s has no \"%s\" (%s, %s)", group->key, name, row->meaning, row->unit);
        return;
    }
    if (json_is_object(node.value))
        provenance_read(row, target->object, &target->provenance[index], &node, kind->sources, target->arena, fault);
    else
        parameters_read_value(row, target->object, &node, target->arena, fault);
}

static void read_group(const ProvenanceFile *kind, const ProvenanceTarget *target, const JsonNode *root,
                       const char *group, Fault *fault) {
    JsonNode node = json_member(root, group);
    if (!json_is_object(node.value) && (node.value || is_needed(kind, group))) {
        if (node.value)
            json_fault(&node, fault, "\"%s\" must be an object { ... }", group);
        else
            json_fault(root, fault, "a %s has no \"%s\", must be an object { ... }", kind->what, group);
        return;
    }
    const char *names[KEYS_MOST] = {0};
    size_t count = 0;
    for (size_t i = 0; i < kind->table->count && count + 1 < KEYS_MOST; i++)
        if (provenance_name(&kind->table->rows[i], group))
            names[count++] = provenance_name(&kind->table->rows[i], group);
    if (node.value)
        json_check_keys(&node, names, fault);
    for (size_t i = 0; i < kind->table->count; i++)
        if (provenance_name(&kind->table->rows[i], group))
            read_value(kind, target, i, &node, provenance_name(&kind->table->rows[i], group), fault);
}

void provenance_file_read(const ProvenanceFile *kind, const ProvenanceTarget *target, const JsonNode *root,
                          Fault *fault) {
    const char *keys[KEYS_MOST] = {"format", "version", "name", "note"};
    for (size_t g = 0; g < kind->group_count; g++)
        keys[4 + g] = kind->groups[g];
    json_check_keys(root, keys, fault);
    parameters_reset(kind->table, target->object);
    *target->name = json_read_text(root, "name", target->arena, fault);
    *target->note = json_read_text(root, "note", target->arena, fault);
    if (!json_object_get(root->value, "name"))
        json_fault(root, fault, "a %s has no \"name\" (a text)", kind->what);
    for (size_t g = 0; g < kind->group_count; g++)
        read_group(kind, target, root, kind->groups[g], fault);
}

void provenance_file_set(const ProvenanceFile *kind, const ProvenanceTarget *target, const char *setting,
                         Fault *fault) {
    const char *equals = strchr(setting, '=');
    if (!equals || equals == setting || !equals[1]) {
        fault_add(fault, "--set %.80s: must be NAME=VALUE, for instance drive.frequency=300", setting);
        return;
    }
    char name[80], path[100];
    snprintf(name, sizeof name, "%.*s", (int)(equals - setting < 79 ? equals - setting : 79), setting);
    snprintf(path, sizeof path, "--set %s: ", name);
    json_t *value = json_loads(equals + 1, JSON_DECODE_ANY, NULL);
    JsonFile file = {.path = path, .root = value ? value : json_string(equals + 1)};
    JsonNode node = json_root(&file);
    const Parameter *row = parameters_find(kind->table, name);
    if (!row)
        parameters_fault_unknown(kind->table, name, &node, fault);
    else if (parameters_read_value(row, target->object, &node, target->arena, fault))
        target->provenance[row - kind->table->rows] = "assumed: set for this run";
    json_decref(file.root);
}

/* Writing: one value a line ---------------------------------------------------------------------------------------- */

static void add_json(Text *lines, json_t *value) {
    char *line = json_line(value);
    text_add(lines, line);
    memory_free(line);
    json_decref(value);
}

static json_t *value_json(const Parameter *row, const void *object) {
    if (row->kind == PARAMETER_FLAG)
        return json_boolean(*(const bool *)((const char *)object + row->offset));
    return parameters_number_json(row, parameters_number_get(row, object));
}

static void add_group(Text *lines, const ProvenanceFile *kind, const ProvenanceTarget *target, const char *group) {
    text_format(lines, ",\n  \"%s\": {", group);
    const char *between = "\n    ";
    for (size_t i = 0; i < kind->table->count; i++) {
        const Parameter *row = &kind->table->rows[i];
        const char *name = provenance_name(row, group);
        if (!name)
            continue;
        text_format(lines, "%s\"%s\": ", between, name);
        bool told = strcmp(target->provenance[i], WITHOUT) != 0;
        json_t *value = value_json(row, target->object);
        add_json(lines, told ? json_pack("{s:o,s:s}", "value", value, "provenance", target->provenance[i]) : value);
        between = ",\n    ";
    }
    text_add(lines, "\n  }");
}

int provenance_file_write(const ProvenanceFile *kind, const ProvenanceTarget *target, const char *path) {
    Text lines = {0};
    text_format(&lines, "{\n  \"format\": \"%s\", \"version\": 1,\n  \"name\": ", kind->format);
    add_json(&lines, json_string(*target->name));
    text_add(&lines, ",\n  \"note\": ");
    add_json(&lines, json_string(*target->note));
    for (size_t g = 0; g < kind->group_count; g++)
        add_group(&lines, kind, target, kind->groups[g]);
    text_add(&lines, "\n}\n");
    int error = file_write_bytes(path, lines.text, lines.used);
    memory_free(lines.text);
    return error;
}

static json_t *group_schema(const ProvenanceFile *kind, const char *group) {
    json_t *members = json_object(), *needed = json_array();
    for (size_t i = 0; i < kind->table->count; i++) {
        const Parameter *row = &kind->table->rows[i];
        const char *name = provenance_name(row, group);
        if (!name)
            continue;
        json_t *bare = parameters_schema_value(row), *whole = provenance_schema(row, kind->sources);
        json_object_set_new(members, name, json_pack("{s:[o,o]}", "anyOf", bare, whole));
        if (row->needed)
            json_array_append_new(needed, json_string(name));
    }
    return json_pack("{s:s, s:b, s:o, s:o}", "type", "object", "additionalProperties", 0, "properties", members,
                     "required", needed);
}

json_t *provenance_file_schema(const ProvenanceFile *kind) {
    json_t *properties = json_object(), *needed = json_pack("[s,s,s]", "format", "version", "name");
    json_object_set_new(properties, "format", json_pack("{s:s}", "const", kind->format));
    json_object_set_new(properties, "version", json_pack("{s:i}", "const", 1));
    json_object_set_new(properties, "name", json_pack("{s:s}", "type", "string"));
    json_object_set_new(properties, "note", json_pack("{s:s}", "type", "string"));
    for (size_t g = 0; g < kind->group_count; g++) {
        json_object_set_new(properties, kind->groups[g], group_schema(kind, kind->groups[g]));
        if (is_needed(kind, kind->groups[g]))
            json_array_append_new(needed, json_string(kind->groups[g]));
    }
    return json_pack("{s:s, s:s, s:s, s:b, s:o, s:o}", "$schema", "https://json-schema.org/draft/2020-12/schema",
                     "title", kind->title, "type", "object", "additionalProperties", 0, "properties", properties,
                     "required", needed);
}
