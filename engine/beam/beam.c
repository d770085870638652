#include "beam/beam.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/file_write.h"
#include "base/parameters_number.h"
#include "base/parameters_schema.h"
#include "base/provenance.h"
#include "base/text.h"

#define NUMBER(name_, field_, unit_, low_, high_, meaning_)                                                            \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_NUMBER, .offset = offsetof(Beam, field_), .unit = unit_, .low = low_,         \
        .high = high_, .needed = true, .meaning = meaning_                                                             \
    }
#define WHOLE(name_, field_, low_, high_, fallback_, meaning_)                                                         \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_WHOLE, .offset = offsetof(Beam, field_), .unit = "1", .low = low_,            \
        .high = high_, .fallback = fallback_, .meaning = meaning_                                                      \
    }

static const Parameter beam_rows[] = {
    NUMBER("beam.length", length, "m", 0.001, 100, "length"),
    NUMBER("beam.width", width, "m", 1e-5, 10, "width of the section"),
    NUMBER("beam.thickness", thickness, "m", 1e-5, 10, "thickness, along which it bends"),
    NUMBER("beam.youngs_modulus", youngs_modulus, "Pa", 1e3, 1e13, "Young's modulus"),
    NUMBER("beam.density", density, "kg/m3", 1, 1e5, "density"),
    WHOLE("beam.elements", elements, 2, 200, 20, "finite elements along the length"),
    WHOLE("beam.modes", modes, 1, 64, 12, "natural modes kept"),
    NUMBER("beam.damping_ratio", damping_ratio, "1", 0, 0.9, "damping ratio of each mode"),
    NUMBER("pivot.position", pivot_position, "m", 0, 100, "place of the flexure pivot along the beam"),
    NUMBER("pivot.translational_stiffness", pivot_stiffness, "N/m", 0, 1e12, "k_t of the flexure pivot"),
    NUMBER("pivot.rotational_stiffness", pivot_rotational, "N m/rad", 0, 1e9, "k_r of the flexure pivot"),
    NUMBER("shaker.position", shaker_position, "m", 0, 100, "place of the shaker along the beam"),
    NUMBER("shaker.moving_mass", shaker_mass, "kg", 0, 1e4, "mass that moves with the beam"),
    NUMBER("shaker.stiffness", shaker_stiffness, "N/m", 0, 1e12, "stiffness of the shaker's suspension"),
    NUMBER("shaker.damping", shaker_damping, "N s/m", 0, 1e6, "damping of the shaker's suspension"),
    NUMBER("drive.frequency", frequency, "Hz", 1, 1e5, "frequency of the shaker's force"),
    NUMBER("drive.force", force, "N", 0, 1e6, "amplitude of the shaker's force"),
    NUMBER("joint.clearance", clearance, "m", 0, 1, "half-width of the clearance; 0: always in contact"),
    NUMBER("joint.stiffness", contact.normal_stiffness, "N/m", 1, 1e11, "stiffness of the contact"),
    NUMBER("joint.damping", contact.normal_damping, "N s/m", 0, 1e6, "damping of the contact"),
    {.name = "joint.release",
     .kind = PARAMETER_CHOICE,
     .offset = offsetof(Beam, release),
     .unit = "",
     .choices = "force|gap",
     .meaning = "the contact lets go at zero force, or when the gap reopens"},
    WHOLE("run.transient_cycles", transient_cycles, 0, 1000000, 300, "cycles of the drive before anything is recorded"),
    WHOLE("run.cycles", cycles, 1, 1000000, 100, "cycles of the drive that are recorded"),
};
enum { ROWS = sizeof beam_rows / sizeof *beam_rows };
_Static_assert((int)ROWS <= (int)BEAM_VALUES, "a provenance for every row");

static const ParameterTable table = {"beam", beam_rows, ROWS};

static const char *const groups[] = {"beam", "pivot", "shaker", "drive", "joint", "run"};
enum { GROUPS = sizeof groups / sizeof *groups };

/* Provenance of a value given as a bare number. */
#define WITHOUT "given without provenance"

/* Allowed beginnings of the provenance of a value in a file. */
#define SOURCES "paper|reconstructed|identified|literature: |assumed"

const ParameterTable *beam_table(void) {
    return &table;
}

/* Reads a value, either bare or as {"value": .., "provenance": ..}. */
static void read_value(Beam *beam, size_t row, const JsonNode *group, const char *name, Fault *fault) {
    JsonNode node = json_member(group, name);
    beam->provenance[row] = node.value ? WITHOUT : "assumed: the usual value";
    if (!node.value) {
        if (beam_rows[row].needed)
            json_fault(group, fault, "%s has no \"%s\" (%s, %s)", group->key, name, beam_rows[row].meaning,
                       beam_rows[row].unit);
        return;
    }
    if (json_is_object(node.value))
        provenance_read(&beam_rows[row], beam, &beam->provenance[row], &node, SOURCES, &beam->arena, fault);
    else
        parameters_read_value(&beam_rows[row], beam, &node, &beam->arena, fault);
}

static void read_group(Beam *beam, const JsonNode *root, const char *group, Fault *fault) {
    JsonNode node = json_member(root, group);
    bool optional = strcmp(group, "run") == 0;
    if (!json_is_object(node.value) && (node.value || !optional)) {
        json_fault(node.value ? &node : root, fault, "%s\"%s\"%s", node.value ? "" : "a beam has no ", group,
                   node.value ? " must be an object { ... }" : ", must be an object { ... }");
        return;
    }
    const char *names[ROWS + 1] = {0};
    size_t count = 0;
    for (size_t i = 0; i < ROWS; i++)
        if (provenance_name(&beam_rows[i], group))
            names[count++] = provenance_name(&beam_rows[i], group);
    if (node.value)
        json_check_keys(&node, names, fault);
    for (size_t i = 0; i < ROWS; i++)
        if (provenance_name(&beam_rows[i], group))
            read_value(beam, i, &node, provenance_name(&beam_rows[i], group), fault);
}

static void read_file(Beam *beam, const JsonNode *root, Fault *fault) {
    static const char *const keys[] = {"format", "version", "name",  "note", "beam", "pivot",
                                       "shaker", "drive",   "joint", "run",  NULL};
    json_check_keys(root, keys, fault);
    parameters_reset(&table, beam);
    beam->name = json_read_text(root, "name", &beam->arena, fault);
    beam->note = json_read_text(root, "note", &beam->arena, fault);
    if (!json_object_get(root->value, "name"))
        json_fault(root, fault, "a beam has no \"name\" (a text)");
    for (size_t g = 0; g < GROUPS; g++)
        read_group(beam, root, groups[g], fault);
}

/* Applies a NAME=VALUE of the command line; VALUE is a number or a choice. */
static void read_setting(Beam *beam, const char *setting, Fault *fault) {
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
    const Parameter *row = parameters_find(&table, name);
    if (!row)
        parameters_fault_unknown(&table, name, &node, fault);
    else if (parameters_read_value(row, beam, &node, &beam->arena, fault))
        beam->provenance[row - beam_rows] = "assumed: set for this run";
    json_decref(file.root);
}

/* Two places on the beam must coincide within SAME_PLACE times the length or differ by at least APART_LEAST times
 * the length: each place is a node, and rounding destroys the bending stiffness of elements that are much shorter
 * than the others. */
static const double SAME_PLACE = 1e-9, APART_LEAST = 1e-3;

static void check_apart(const Beam *beam, const JsonNode *group, const char *name, double place, const char *what,
                        double other, Fault *fault) {
    double apart = fabs(place - other), least = APART_LEAST * beam->length;
    if (apart > SAME_PLACE * beam->length && apart < least)
        json_fault(group, fault, "%s is %.3g m from %s, must be there, at %.9g m, or at least %.3g m away", name, apart,
                   what, other, least);
}

/* Checks conditions between values: the parts fit together, the beam is supported, and there are enough degrees of
 * freedom for its modes. */
static void check_whole(const Beam *beam, const JsonNode *root, Fault *fault) {
    JsonNode pivot = json_member(root, "pivot"), shaker = json_member(root, "shaker"), own = json_member(root, "beam");
    if (beam->pivot_position > beam->length)
        json_fault(&pivot, fault, "pivot.position is %.9g m, at most the length, %.9g m", beam->pivot_position,
                   beam->length);
    if (beam->shaker_position > beam->length)
        json_fault(&shaker, fault, "shaker.position is %.9g m, at most the length, %.9g m", beam->shaker_position,
                   beam->length);
    check_apart(beam, &pivot, "pivot.position", beam->pivot_position, "the end", 0, fault);
    check_apart(beam, &pivot, "pivot.position", beam->pivot_position, "the tip", beam->length, fault);
    check_apart(beam, &shaker, "shaker.position", beam->shaker_position, "the end", 0, fault);
    check_apart(beam, &shaker, "shaker.position", beam->shaker_position, "the tip", beam->length, fault);
    check_apart(beam, &shaker, "shaker.position", beam->shaker_position, "the pivot", beam->pivot_position, fault);
    bool two_places = beam->pivot_stiffness > 0 && beam->shaker_stiffness > 0 &&
                      fabs(beam->pivot_position - beam->shaker_position) > SAME_PLACE * beam->length;
    bool turned_and_held = beam->pivot_rotational > 0 && (beam->pivot_stiffness > 0 || beam->shaker_stiffness > 0);
    if (!two_places && !turned_and_held)
        json_fault(&pivot, fault,
                   "nothing holds the beam: pivot.translational_stiffness and one of pivot.rotational_stiffness and "
                   "shaker.stiffness must be over 0");
    int freedoms = 2 * (beam->elements + 1);
    if (beam->modes > freedoms)
        json_fault(&own, fault, "beam.modes is %d, at most the freedoms of %d elements, %d", beam->modes,
                   beam->elements, freedoms);
    if (beam->width * beam->thickness * beam->length * beam->density < 1e-9)
        json_fault(&own, fault, "the beam has a mass of %.3g kg, must be at least 1e-09 kg",
                   beam->width * beam->thickness * beam->length * beam->density);
}

bool beam_check(const Beam *beam, const char *place, Fault *fault) {
    size_t before = fault->total;
    char path[200];
    snprintf(path, sizeof path, "%s: ", place);
    JsonFile file = {.path = path, .root = json_object()};
    JsonNode root = json_root(&file);
    check_whole(beam, &root, fault);
    json_decref(file.root);
    return fault->total == before;
}

bool beam_is_file(const char *path) {
    JsonFile file = {0};
    Fault fault = {0};
    bool is = json_read(&file, path, &fault);
    const char *format = is ? json_string_value(json_object_get(file.root, "format")) : NULL;
    is = format && strcmp(format, "clearance-beam") == 0;
    json_free(&file);
    fault_clear(&fault);
    return is;
}

bool beam_read(Beam *beam, const char *path, const char *const *settings, size_t setting_count, Fault *fault) {
    size_t before = fault->total;
    JsonFile file = {0};
    if (!json_read(&file, path, fault))
        return false;
    Beam read = {0};
    JsonNode root = json_root(&file);
    if (json_check_header(&root, "beam", "clearance-beam", fault)) {
        read_file(&read, &root, fault);
        for (size_t i = 0; i < setting_count; i++)
            read_setting(&read, settings[i], fault);
        if (fault->total == before)
            check_whole(&read, &root, fault);
    }
    json_free(&file);
    if (fault->total != before) {
        beam_free(&read);
        return false;
    }
    beam_free(beam);
    *beam = read;
    return true;
}

/* Writing: one value a line ---------------------------------------------------------------------------------------- */

static void add_json(Text *lines, json_t *value) {
    char *line = json_line(value);
    text_add(lines, line);
    memory_free(line);
    json_decref(value);
}

static void add_group(Text *lines, const Beam *beam, const char *group) {
    text_format(lines, ",\n  \"%s\": {", group);
    const char *between = "\n    ";
    for (size_t i = 0; i < ROWS; i++) {
        const char *name = provenance_name(&beam_rows[i], group);
        if (!name)
            continue;
        text_format(lines, "%s\"%s\": ", between, name);
        bool told = strcmp(beam->provenance[i], WITHOUT) != 0;
        json_t *value = parameters_number_json(&beam_rows[i], parameters_number_get(&beam_rows[i], beam));
        add_json(lines, told ? json_pack("{s:o,s:s}", "value", value, "provenance", beam->provenance[i]) : value);
        between = ",\n    ";
    }
    text_add(lines, "\n  }");
}

int beam_write(const Beam *beam, const char *path) {
    Text lines = {0};
    text_add(&lines, "{\n  \"format\": \"clearance-beam\", \"version\": 1,\n  \"name\": ");
    add_json(&lines, json_string(beam->name));
    text_add(&lines, ",\n  \"note\": ");
    add_json(&lines, json_string(beam->note));
    for (size_t g = 0; g < GROUPS; g++)
        add_group(&lines, beam, groups[g]);
    text_add(&lines, "\n}\n");
    int error = file_write_bytes(path, lines.text, lines.used);
    memory_free(lines.text);
    return error;
}

void beam_free(Beam *beam) {
    arena_clear(&beam->arena);
    *beam = (Beam){0};
}

json_t *beam_schema(void) {
    json_t *properties = json_object();
    json_object_set_new(properties, "format", json_pack("{s:s}", "const", "clearance-beam"));
    json_object_set_new(properties, "version", json_pack("{s:i}", "const", 1));
    json_object_set_new(properties, "name", json_pack("{s:s}", "type", "string"));
    json_object_set_new(properties, "note", json_pack("{s:s}", "type", "string"));
    for (size_t g = 0; g < GROUPS; g++) {
        json_t *members = json_object(), *needed = json_array();
        for (size_t i = 0; i < ROWS; i++) {
            const char *name = provenance_name(&beam_rows[i], groups[g]);
            if (!name)
                continue;
            json_t *bare = parameters_schema_value(&beam_rows[i]), *whole = provenance_schema(&beam_rows[i], SOURCES);
            json_object_set_new(members, name, json_pack("{s:[o,o]}", "anyOf", bare, whole));
            if (beam_rows[i].needed)
                json_array_append_new(needed, json_string(name));
        }
        json_object_set_new(properties, groups[g],
                            json_pack("{s:s, s:b, s:o, s:o}", "type", "object", "additionalProperties", 0, "properties",
                                      members, "required", needed));
    }
    return json_pack("{s:s, s:s, s:s, s:b, s:o, s:[s,s,s,s,s,s,s,s]}", "$schema",
                     "https://json-schema.org/draft/2020-12/schema", "title", "A beam of clearance", "type", "object",
                     "additionalProperties", 0, "properties", properties, "required", "format", "version", "name",
                     "beam", "pivot", "shaker", "drive", "joint");
}
