#include <stdlib.h>
#include <string.h>

#include "beam/beam.h"
#include "check.h"
#include "scratch.h"
#include "plan/plan.h"
#include "plan/profile.h"
#include "rules/rule_set.h"

/* Returns the schema as `clearance schema KIND` prints it. */
static void check_file(const char *path, json_t *schema) {
    char *made = json_dumps(schema, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
    char *shipped = scratch_read(scratch_source(path));
    size_t length = strlen(shipped);
    CHECK(length && shipped[length - 1] == '\n');
    if (length)
        shipped[length - 1] = 0;
    CHECK_TEXT(shipped, made);
    free(made);
    memory_free(shipped);
    json_decref(schema);
}

TEST(the_shipped_schemas_are_those_of_the_tables) {
    check_file("assets/schema/house.schema.json", plan_schema());
    check_file("assets/schema/profile.schema.json", profile_schema());
    check_file("assets/schema/rules.schema.json", rule_set_schema());
    check_file("assets/schema/beam.schema.json", beam_schema());
}

TEST(a_schema_describes_every_parameter_of_a_profile) {
    json_t *schema = profile_schema();
    json_t *groups = json_object_get(schema, "properties");
    for (size_t i = 0; i < profile_table()->count; i++) {
        const Parameter *row = &profile_table()->rows[i];
        char group[32];
        size_t length = strcspn(row->name, ".");
        memcpy(group, row->name, length);
        group[length] = 0;
        json_t *members = json_object_get(json_object_get(groups, group), "properties");
        json_t *value =
            json_object_get(json_object_get(json_object_get(members, row->name + length + 1), "properties"), "value");
        CHECK_NEAR(json_number_value(json_object_get(value, "minimum")), row->low, 0);
        CHECK_NEAR(json_number_value(json_object_get(value, "maximum")), row->high, 0);
    }
    json_decref(schema);
}
