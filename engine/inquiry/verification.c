#include "inquiry/verification.h"

#include <stdio.h>
#include <string.h>

#include "base/json.h"
#include "base/text.h"
#include "plan/plan.h"

/* Tables ------------------------------------------------------------------------------------------------------------*/

#define TEXT CONDITION_TEXT

static const Parameter case_rows[] = {
    TEXT(Verification, id, "id", PARAMETER_ID, true, "name of the case"),
    TEXT(Verification, suite, "suite", PARAMETER_TEXT, true, "suite and number of the test"),
    TEXT(Verification, title, "title", PARAMETER_TEXT, true, "tested behaviour"),
    TEXT(Verification, note, "note", PARAMETER_TEXT, false, "source, and what is assumed"),
    TEXT(Verification, house, "house", PARAMETER_TEXT, false, "house file, from the case file's directory"),
    TEXT(Verification, reason, "reason", PARAMETER_TEXT, false, "why the test does not apply"),
    {.name = "applies",
     .kind = PARAMETER_FLAG,
     .offset = offsetof(Verification, applies),
     .unit = "",
     .fallback = 1,
     .meaning = "false: the program has no feature that the test covers"},
};
enum { CASE_ROWS = sizeof case_rows / sizeof *case_rows };

static const Parameter variant_rows[] = {
    TEXT(VerificationVariant, id, "id", PARAMETER_ID, true, "name of the variant"),
    TEXT(VerificationVariant, house, "house", PARAMETER_TEXT, false, "house file; absent: the case's"),
    TEXT(VerificationVariant, set, "set", PARAMETER_TEXT, false, "settings NAME=VALUE NAME=VALUE ... of the variant"),
};
static const ParameterTable variant_table = {"variant", variant_rows, sizeof variant_rows / sizeof *variant_rows};

static const Parameter check_rows[] = {
    CONDITION_ROWS(VerificationCheck, condition),
    TEXT(VerificationCheck, variant, "variant", PARAMETER_ID, false,
         "variant of the house; absent: the unchanged house"),
    TEXT(VerificationCheck, than, "than", PARAMETER_ID, false, "variant for comparison"),
    TEXT(VerificationCheck, than_of, "than_of", PARAMETER_IDS, false, "people for comparison"),
    CONDITION_POINTS(VerificationCheck, than_area, "than_area", 3, "area for comparison"),
    {.name = "seeds",
     .kind = PARAMETER_WHOLE,
     .offset = offsetof(VerificationCheck, seeds),
     .unit = "1",
     .low = 1,
     .high = 1000,
     .fallback = 1,
     .meaning = "seeds over which the mean is taken"},
};
static const ParameterTable check_table = {"check", check_rows, sizeof check_rows / sizeof *check_rows};

/* Reading -----------------------------------------------------------------------------------------------------------*/

static void read_case_rows(Verification *read, const JsonNode *root, Fault *fault) {
    static const ParameterTable table = {"case", case_rows, CASE_ROWS};
    const char *keys[CASE_ROWS + 5] = {"format", "version", "variants", "checks"};
    for (size_t i = 0; i < CASE_ROWS; i++)
        keys[i + 4] = case_rows[i].name;
    json_check_keys(root, keys, fault);
    parameters_reset(&table, read);
    for (size_t i = 0; i < CASE_ROWS; i++) {
        JsonNode member = json_member(root, case_rows[i].name);
        if (member.value)
            parameters_read_value(&case_rows[i], read, &member, &read->arena, fault);
        else if (case_rows[i].needed)
            json_fault(root, fault, "case has no \"%s\" (%s)", case_rows[i].name, case_rows[i].meaning);
    }
}

/* Reads the list `key` into elements of `size` bytes after the first `before`. */
static void *read_list(Verification *read, const JsonNode *root, const char *key, const ParameterTable *table,
                       size_t size, size_t before, size_t *count, Fault *fault) {
    JsonNode node = json_member(root, key);
    if (node.value && !json_is_array(node.value))
        json_fault(&node, fault, "%s must be a list [ ... ]", key);
    *count = before + json_array_size(node.value);
    char *list = arena_allocate(&read->arena, (*count + 1) * size);
    for (size_t i = before; i < *count; i++) {
        JsonNode element = json_element(&node, i - before);
        parameters_read(table, list + i * size, &element, &read->arena, fault);
    }
    return list;
}

/* Returns the path of `file` in the directory of the case. */
static const char *beside(Verification *verification, const char *file) {
    const char *slash = strrchr(verification->path, '/');
    size_t directory = slash && *file != '/' ? (size_t)(slash - verification->path) + 1 : 0;
    size_t size = directory + strlen(file) + 1;
    char *path = arena_allocate(&verification->arena, size);
    snprintf(path, size, "%.*s%s", (int)directory, verification->path, file);
    return path;
}

size_t verification_settings(Verification *verification, const VerificationVariant *variant, const char ***settings) {
    size_t most = strlen(variant->set) / 2 + 1, count = 0;
    *settings = arena_allocate(&verification->arena, most * sizeof **settings);
    for (const char *at = variant->set + strspn(variant->set, " "); *at; at += strspn(at, " ")) {
        size_t length = strcspn(at, " ");
        char *word = arena_allocate(&verification->arena, length + 1);
        memcpy(word, at, length);
        (*settings)[count++] = word;
        at += length;
    }
    return count;
}

static size_t find_variant(const Verification *verification, const char *id) {
    for (size_t v = 0; v < verification->variant_count; v++)
        if (strcmp(verification->variants[v].id, id) == 0)
            return v;
    return SIZE_MAX;
}

static void check_variant(const Verification *read, const char *key, const char *id, const JsonNode *node,
                          Fault *fault) {
    JsonNode member = json_member(node, key);
    if (find_variant(read, id) == SIZE_MAX)
        json_fault(&member, fault, "there is no variant \"%.60s\"", id);
}

static void check_check(VerificationCheck *check, const Verification *read, const JsonNode *node, Fault *fault) {
    if (!condition_find(&check->condition, NULL, 0, node, fault))
        return;
    check->is_ratio = *check->than || check->than_of.count || check->than_area.count;
    condition_check_unit(&check->condition, check->is_ratio ? "1" : check->condition.measure->unit, node, fault);
    condition_check_limits(&check->condition, "a check", node, fault);
    condition_check_needs(&check->condition, node, fault);
    check_variant(read, "variant", check->variant, node, fault);
    if (*check->than)
        check_variant(read, "than", check->than, node, fault);
}

/* Checks ids against the plan of one variant. */
static void check_against_plan(const Verification *read, size_t v, const Plan *plan, const JsonNode *checks,
                               Fault *fault) {
    for (size_t c = 0; c < read->check_count; c++) {
        const VerificationCheck *check = &read->checks[c];
        JsonNode node = json_element(checks, c);
        if (check->sides[0] == v) {
            condition_check_people(&check->condition.question.of, "of", plan, &node, fault);
            condition_check_people(&check->condition.question.past, "past", plan, &node, fault);
        }
        if (check->sides[1] == v && check->than_of.count)
            condition_check_people(&check->than_of, "than_of", plan, &node, fault);
        if (check->sides[0] == v || check->sides[1] == v)
            condition_check_exit(&check->condition, plan, &node, fault);
    }
}

/* Adds errors of a house. Those of a variant's settings point at its `set`; those of the house name the house's file.
 */
static void add_house_faults(const Fault *faults, size_t v, const JsonNode *root, Fault *fault) {
    JsonNode list = json_member(root, "variants");
    JsonNode element = v ? json_element(&list, v - 1) : *root, set = json_member(&element, "set");
    for (size_t l = 0; l < faults->count; l++) {
        if (strncmp(faults->lines[l], "--set", 5) == 0)
            json_fault(&set, fault, "%s", faults->lines[l]);
        else
            fault_add(fault, "%s", faults->lines[l]);
    }
}

static void check_houses(Verification *read, const JsonNode *root, Fault *fault) {
    JsonNode checks = json_member(root, "checks");
    for (size_t v = 0; v < read->variant_count; v++) {
        Plan plan = {0};
        Fault faults = {0};
        const char **settings;
        size_t count = verification_settings(read, &read->variants[v], &settings);
        if (plan_read(&plan, read->variants[v].house, settings, count, &faults))
            check_against_plan(read, v, &plan, &checks, fault);
        add_house_faults(&faults, v, root, fault);
        fault_clear(&faults);
        plan_free(&plan);
    }
}

static void read_variants(Verification *read, const JsonNode *root, Fault *fault) {
    read->variants =
        read_list(read, root, "variants", &variant_table, sizeof *read->variants, 1, &read->variant_count, fault);
    read->variants[0] = (VerificationVariant){.id = "", .house = read->house, .set = ""};
    JsonNode list = json_member(root, "variants");
    for (size_t v = 0; v < read->variant_count; v++) {
        VerificationVariant *variant = &read->variants[v];
        if (v && find_variant(read, variant->id) != v) {
            JsonNode element = json_element(&list, v - 1), id = json_member(&element, "id");
            json_fault(&id, fault, "the variant id \"%.60s\" is already used; ids must be unique", variant->id);
        }
        variant->house = beside(read, *variant->house ? variant->house : read->house);
    }
}

static void read_checks(Verification *read, const JsonNode *root, Fault *fault) {
    size_t before = fault->total;
    read->checks = read_list(read, root, "checks", &check_table, sizeof *read->checks, 0, &read->check_count, fault);
    JsonNode list = json_member(root, "checks");
    for (size_t c = 0; c < read->check_count && fault->total == before; c++) {
        JsonNode element = json_element(&list, c);
        VerificationCheck *check = &read->checks[c];
        check_check(check, read, &element, fault);
        check->sides[0] = find_variant(read, check->variant);
        check->sides[1] = *check->than ? find_variant(read, check->than) : check->sides[0];
        check->condition.value = (double)NAN;
    }
}

static void read_case(Verification *read, const JsonNode *root, Fault *fault) {
    size_t before = fault->total;
    read_case_rows(read, root, fault);
    read_variants(read, root, fault);
    read_checks(read, root, fault);
    if (!read->applies && !*read->reason)
        json_fault(root, fault, "a case that does not apply needs a \"reason\"");
    if (read->applies && !*read->house)
        json_fault(root, fault, "a case that applies needs a \"house\"");
    if (read->applies && !read->check_count)
        json_fault(root, fault, "a case that applies needs \"checks\"");
    if (!read->applies && read->check_count)
        json_fault(root, fault, "a case that does not apply has no \"checks\"");
    if (read->applies && fault->total == before)
        check_houses(read, root, fault);
}

bool verification_read(Verification *verification, const char *path, Fault *fault) {
    size_t before = fault->total;
    JsonFile file = {0};
    if (!json_read(&file, path, fault))
        return false;
    Verification read = {.applies = true};
    read.path = arena_text(&read.arena, path);
    JsonNode root = json_root(&file);
    if (json_check_header(&root, "case", "clearance-case", fault))
        read_case(&read, &root, fault);
    json_free(&file);
    if (fault->total != before) {
        verification_free(&read);
        return false;
    }
    verification_free(verification);
    *verification = read;
    return true;
}

void verification_free(Verification *verification) {
    arena_clear(&verification->arena);
    *verification = (Verification){0};
}
