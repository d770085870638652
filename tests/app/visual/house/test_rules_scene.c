/* Tests the plan of `clearance rules`: each dimension with its verdict and the share of drivers. */
#include "visual/house/rules_scene.h"

#include <string.h>

#include "case.h"
#include "check.h"
#include "scratch.h"

static size_t count_ends(const Scene *scene, const char *end) {
    size_t count = 0;
    for (size_t i = 0; i < scene->count; i++) {
        const Primitive *label = &scene->primitives[i];
        if (label->kind != PRIMITIVE_LABEL || !label->text || strlen(label->text) < strlen(end))
            continue;
        count += strcmp(label->text + strlen(label->text) - strlen(end), end) == 0;
    }
    return count;
}

TEST(the_share_of_drivers_stands_next_to_the_dimension) {
    RuleSets sets = {0};
    Fault fault = {0};
    House house;
    CHECK(rule_set_read_all(&sets, scratch_source("assets/rules"), "jp-senior-housing-1414", &fault));
    check_say(&fault);
    case_house(&house, "corner-0.78-0.78", -1, NULL);
    Inspection inspection = inspection_make(&house, &sets, 1, NULL);
    for (int tried = 0; tried < 2; tried++) {
        Scene scene = {0};
        inspection.population = tried ? "manual-jp" : NULL;
        inspection.driver_count = tried ? 40 : 0;
        for (size_t p = 0; p < inspection.place_count; p++) {
            inspection.places[p].drivers = tried ? 40 : 0;
            inspection.places[p].refused = tried ? 10 : 0;
        }
        rules_scene_make(&scene, &house, &inspection, "title", "detail");
        CHECK((count_ends(&scene, "75 %") > 0) == tried && count_ends(&scene, "100 %") == 0);
        scene_clear(&scene);
    }
    inspection_free(&inspection);
    house_free(&house);
    rule_set_free_all(&sets);
}
