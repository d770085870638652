#include "check.h"

#include "base/text.h"
#include "imported.h"

/* Writes a scenario from a topography without its frame; ' stands for quotation marks. */
static Imported import_scenario(const char *release, const char *topography) {
    Text text = {0};
    text_format(
        &text,
        "{'name': 'corner', 'release': '%s', 'scenario': {'topography': {'attributes': {'bounds': {'x': 0, 'y': "
        "0, 'width': 12, 'height': 16}, 'boundingBoxWidth': 1, 'bounded': true}, 'obstacles': ["
        "{'shape': {'type': 'RECTANGLE', 'x': 0.5, 'y': 4, 'width': 8, 'height': 0.5}}, "
        "{'shape': {'type': 'RECTANGLE', 'x': 8, 'y': 4.5, 'width': 0.5, 'height': 7}}, "
        "{'shape': {'type': 'RECTANGLE', 'x': 2, 'y': 6, 'width': 2, 'height': 1}}], 'stairs': [{}, {}], "
        "'dynamicElements': [{'type': 'PEDESTRIAN', 'position': {'x': 7.25, 'y': 2}, 'freeFlowSpeed': 1.5, "
        "'targetIds': [2, 1]}, {'type': 'PEDESTRIAN', 'position': {'x': 5, 'y': 4.25}, 'targetIds': [1]}], "
        "%s}}}",
        release, topography);
    for (char *c = text.text; *c; c++)
        *c = *c == '\'' ? '"' : *c;
    Imported import = imported_text(".scenario", text.text, (ImportOptions){0});
    memory_free(text.text);
    return import;
}

static const char corner[] =
    "  'walls': [\n"
    "    {'id': 'w1', 'points': [[0.5, 0.5], [11.5, 0.5], [11.5, 15.5], [0.5, 15.5], [0.5, 0.5]], 'thickness': 1},\n"
    "    {'id': 'w2', 'points': [[0.5, 4.25], [8.5, 4.25]], 'thickness': 0.5, 'height': 2},\n"
    "    {'id': 'w3', 'points': [[8.25, 4.5], [8.25, 11.5]], 'thickness': 0.5, 'height': 2}\n"
    "  ],\n"
    "  'furniture': [\n"
    "    {'id': 'f1', 'name': 'obstacle', 'centre': [3, 6.5], 'size': [2, 1], 'height': 2}\n"
    "  ],\n"
    "  'exits': [\n"
    "    {'id': 'e1', 'from': [9, 13.5], 'to': [11, 13.5]}\n"
    "  ],\n"
    "  'people': [\n"
    "    {'id': 'p1', 'profile': 'adult', 'at': [7.25, 2], 'speed': 1.5}\n"
    "  ],\n"
    "  'crowds': [\n"
    "    {'id': 'c1', 'profile': 'adult', 'count': 18, 'area': [[1.5, 1.5], [6.5, 1.5], [6.5, 3.5], [1.5, 3.5]], "
    "'delay': 5}\n"
    "  ],\n"
    "  'routes': [\n"
    "    {'id': 'route1', 'people': ['c1', 'p1'], 'via': [[10, 3]], 'exit': 'e1'}\n"
    "  ]\n}\n";

TEST(a_scenario_says_the_same_in_the_words_of_old_and_new_releases) {
    Imported import = import_scenario(
        "2.4", "'targets': [{'id': 1, 'shape': {'type': 'RECTANGLE', 'x': 9, 'y': 12.5, 'width': 2, 'height': 2}, "
               "'absorber': {'enabled': true}}, {'id': 2, 'shape': {'type': 'RECTANGLE', 'x': 9, 'y': 2, 'width': 2, "
               "'height': 2}, 'absorber': {'enabled': false}}], 'sources': [{'shape': {'type': 'RECTANGLE', 'x': 1.5, "
               "'y': 1.5, 'width': 5, 'height': 2}, 'targetIds': [2, 1], 'spawner': {'constraintsTimeStart': 5, "
               "'constraintsTimeEnd': 5, 'eventElementCount': 18}}]");
    imported_check_lists(&import.plan, corner);
    CHECK(imported_left_out(&import, "stairs", 2) &&
          imported_left_out(&import, "people who stand inside an obstacle", 1));
    CHECK_TEXT(import.plan.name, "corner");
    imported_end(&import, true);
    import = import_scenario(
        "1.15",
        "'targets': [{'id': 1, 'shape': {'type': 'RECTANGLE', 'x': 9, 'y': 12.5, 'width': 2, 'height': 2}, "
        "'absorbing': true}, {'id': 2, 'shape': {'type': 'RECTANGLE', 'x': 9, 'y': 2, 'width': 2, 'height': 2}, "
        "'absorbing': false}], 'sources': [{'shape': {'type': 'RECTANGLE', 'x': 1.5, 'y': 1.5, 'width': 5, "
        "'height': 2}, 'targetIds': [2, 1], 'startTime': 5, 'endTime': 5, 'spawnNumber': 18}]");
    imported_check_lists(&import.plan, corner);
    imported_end(&import, true);
}

TEST(a_source_gives_no_more_people_than_it_has_room_for) {
    Imported import = import_scenario(
        "2.4",
        "'teleporter': null, 'targets': [{'id': 1, 'shape': {'type': 'POLYGON', 'points': [{'x': 2, 'y': 12}, {'x': "
        "6, 'y': 12}, {'x': 6, 'y': 13}]}}], 'sources': [{'shape': {'type': 'CIRCLE', 'radius': 0.5, 'center': "
        "{'x': 10, 'y': 10}}, 'spawner': {'eventElementCount': 50}}]");
    CHECK(import.plan.exit_count == 1 && import.plan.crowd_count == 1);
    CHECK(import.good && import.plan.crowds[0].count == 2 && import.plan.crowds[0].area.count == 24);
    CHECK(imported_left_out(&import, "people for whom their source is too small", 48));
    imported_end(&import, true);
}

TEST(of_two_targets_with_one_id_the_first_counts) {
    Imported import = import_scenario(
        "2.4", "'targets': [{'id': 1, 'shape': {'type': 'RECTANGLE', 'x': 9, 'y': 12.5, 'width': 2, 'height': 2}}, "
               "{'id': 2, 'shape': {'type': 'RECTANGLE', 'x': 9, 'y': 2, 'width': 2, 'height': 2}, 'absorber': "
               "{'enabled': false}}, {'id': 1, 'shape': {'type': 'RECTANGLE', 'x': 2, 'y': 12.5, 'width': 2, "
               "'height': 2}}]");
    CHECK(import.plan.exit_count == 2 && import.plan.route_count == 1);
    if (import.plan.route_count == 1)
        CHECK_TEXT(import.plan.routes[0].exit, "e1");
    imported_end(&import, true);
}
