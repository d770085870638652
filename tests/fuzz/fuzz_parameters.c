/* The input is one JSON value, read as every row of every table and as every table. */
#include <stddef.h>
#include <string.h>

#include "fuzz.h"
#include "plan/plan_tables.h"
#include "plan/profile.h"

/* One row of each kind. */
typedef struct Every {
    double number;
    int whole, choice;
    bool flag;
    const char *text, *id;
    Ids ids;
    NumberList numbers;
    Vec2 point;
    Points points;
    Observed table;
} Every;

#define EVERY(kind_, field_) .name = #field_, .kind = kind_, .offset = offsetof(Every, field_), .unit = "m"

static const Parameter inner_rows[] = {
    {.name = "mean", .kind = PARAMETER_NUMBER, .offset = offsetof(Observed, mean), .unit = "s", .high = HUGE_VAL},
    {.name = "runs", .kind = PARAMETER_WHOLE, .offset = offsetof(Observed, runs), .unit = "1", .low = -9, .high = 9},
};
static const ParameterTable inner = {"inner", inner_rows, sizeof inner_rows / sizeof *inner_rows};

static const Parameter every_rows[] = {
    {EVERY(PARAMETER_NUMBER, number), .low = -1e300, .high = HUGE_VAL, .fallback = 0.5},
    {EVERY(PARAMETER_WHOLE, whole), .low = -2147483648.0, .high = 2147483647, .fallback = 7},
    {EVERY(PARAMETER_CHOICE, choice), .choices = "one|two|three"},
    {EVERY(PARAMETER_FLAG, flag)},
    {EVERY(PARAMETER_TEXT, text)},
    {EVERY(PARAMETER_ID, id)},
    {EVERY(PARAMETER_IDS, ids)},
    {EVERY(PARAMETER_NUMBERS, numbers), .low = -1e9, .high = 1e9},
    {EVERY(PARAMETER_POINT, point), .needed = true},
    {EVERY(PARAMETER_POINTS, points)},
    {EVERY(PARAMETER_TABLE, table), .table = &inner},
};
static const ParameterTable every = {"every", every_rows, sizeof every_rows / sizeof *every_rows};

enum { LARGEST = 4096 /* bytes: of the structs that tables describe */ };
_Static_assert(sizeof(Profile) <= LARGEST && sizeof(RunSettings) <= LARGEST && sizeof(PlanRoute) <= LARGEST, "");

static void read_row(const ParameterTable *table, const Parameter *row, const JsonNode *node, Arena *arena) {
    _Alignas(max_align_t) unsigned char object[LARGEST], before[LARGEST];
    Fault fault = {0};
    memset(object, 0xa5, sizeof object);
    parameters_reset(table, object);
    memcpy(before, object, sizeof object);
    bool good = parameters_read_value(row, object, node, arena, &fault);
    fuzz_expect(good || row->kind == PARAMETER_TABLE || memcmp(object, before, sizeof object) == 0,
                "a field that cannot be read is as it was");
    fuzz_expect_faults(good, &fault, node->file->path);
}

static void read_table(const ParameterTable *table, const JsonNode *node, Arena *arena) {
    _Alignas(max_align_t) unsigned char object[LARGEST];
    Fault fault = {0};
    for (size_t i = 0; i < table->count; i++)
        read_row(table, &table->rows[i], node, arena);
    bool good = parameters_read(table, object, node, arena, &fault);
    fuzz_expect_faults(good, &fault, node->file->path);
    if (good) {
        json_t *written = parameters_write(table, object), *again;
        JsonFile file = {.path = (char[]){"again: "}, .root = written};
        JsonNode root = json_root(&file);
        fuzz_expect(parameters_read(table, object, &root, arena, &fault), "what was written is read");
        again = parameters_write(table, object);
        fuzz_expect(json_equal(written, again), "values survive writing");
        json_decref(written);
        json_decref(again);
    }
    const char *word = json_string_value(node->value);
    if (word && !parameters_find(table, word)) {
        parameters_fault_unknown(table, word, node, &fault);
        fuzz_expect_faults(false, &fault, node->file->path);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size);
    Fault fault = {0};
    JsonFile file = {0};
    bool good = json_read(&file, path, &fault);
    fuzz_expect_faults(good, &fault, path);
    if (!good)
        return 0;
    Arena arena = {0};
    JsonNode root = json_root(&file), member = json_member(&root, "value");
    const JsonNode *node =
        member.value ? &member : &root; /* a file holds an object or a list, a row also other values */
    read_table(&every, node, &arena);
    read_table(profile_table(), node, &arena);
    read_table(&plan_tables_run, node, &arena);
    for (int l = 0; l < PLAN_LISTS; l++)
        read_table(&plan_tables_lists[l].table, node, &arena);
    arena_clear(&arena);
    json_free(&file);
    return 0;
}
