#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/random.h"
#include "base/text.h"
#include "check.h"
#include "plan/draft.h"
#include "plan/draft_clip.h"
#include "plan/draft_file.h"
#include "plan/draft_parameter.h"
#include "scratch.h"

enum { EDITS = 10000, ELEMENTS = 40 /* beyond this number some are removed */ };

static Draft *read_house(const char *name) {
    char path[256];
    snprintf(path, sizeof path, "houses/%s.json", name);
    Fault fault = {0};
    Draft *draft = draft_file_read(scratch_source(path), NULL, 0, &fault);
    CHECK(draft && !fault.count);
    fault_clear(&fault);
    return draft;
}

static bool ends(Draft *draft) {
    Fault fault = {0};
    bool good = draft_end(draft, &fault);
    CHECK(good == !fault.count);
    fault_clear(&fault);
    return good;
}

TEST(a_step_is_undone_and_redone_to_the_same_bytes) {
    Draft *draft = read_house("flat-0.910-module");
    char *first = strdup(draft_text(draft));
    draft_begin(draft, "Widen door d1");
    draft_set_number(draft, draft_plan(draft)->doors[0].id, "width", 0.7);
    CHECK(ends(draft));
    char *last = strdup(draft_text(draft));
    CHECK(strcmp(first, last) != 0);
    CHECK_TEXT(draft_undo_name(draft), "Widen door d1");
    size_t all = draft_step_total(draft);
    CHECK(all == draft_step_count(draft) && draft_step_revision(draft, all - 1) == draft_revision(draft));
    CHECK_TEXT(draft_step_name(draft, all - 1), "Widen door d1");
    CHECK(draft_undo(draft));
    CHECK_TEXT(draft_text(draft), first);
    CHECK(!draft_undo(draft) && !draft_undo_name(draft));
    CHECK(!draft_file_is_changed(draft));
    CHECK(draft_redo(draft));
    CHECK_TEXT(draft_text(draft), last);
    free(first);
    free(last);
    draft_destroy(draft);
}

TEST(what_no_file_may_say_is_refused_and_said_in_words) {
    Draft *draft = read_house("flat-0.910-module");
    char *first = strdup(draft_text(draft));
    const char *door = draft_plan(draft)->doors[0].id;
    Fault fault = {0};
    draft_begin(draft, "Widen");
    draft_set_number(draft, door, "width", 99);
    CHECK(!draft_try(draft, &fault));
    CHECK(fault.count && strstr(fault.lines[0], "width is 99 m, must be at most"));
    CHECK_TEXT(draft_text(draft), first);
    draft_rewind(draft);
    draft_set_number(draft, door, "width", 1e9);
    fault_clear(&fault);
    CHECK(!draft_end(draft, &fault));
    CHECK(fault.count && strncmp(fault.lines[0], "door ", 5) == 0);
    CHECK_TEXT(draft_text(draft), first);
    CHECK(!draft_undo_name(draft) && !draft_is_open(draft));
    fault_clear(&fault);
    free(first);
    draft_destroy(draft);
}

TEST(a_step_that_changes_nothing_is_none) {
    Draft *draft = read_house("flat-0.910-module");
    draft_begin(draft, "Nothing");
    const char *id = draft_plan(draft)->furniture[0].id;
    Vec2 centre = draft_plan(draft)->furniture[0].centre;
    draft_set_point(draft, id, "centre", vec2_add(centre, vec2(1, 0)));
    draft_set_point(draft, id, "centre", centre);
    CHECK(ends(draft));
    CHECK(!draft_undo_name(draft));
    draft_destroy(draft);
}

TEST(a_wall_takes_its_doors_with_it_and_a_person_leaves_its_routes) {
    Draft *draft = read_house("ube-techno-house");
    size_t doors = draft_plan(draft)->door_count, routes = draft_plan(draft)->route_count;
    const char *wall = strdup(draft_plan(draft)->doors[0].wall),
               *person = strdup(draft_plan(draft)->routes[0].people.at[0]);
    draft_begin(draft, "Remove");
    CHECK(draft_remove(draft, wall));
    CHECK(draft_remove(draft, person));
    CHECK(!draft_remove(draft, person));
    CHECK(ends(draft));
    CHECK(draft_plan(draft)->door_count < doors);
    CHECK(draft_plan(draft)->route_count < routes);
    CHECK(draft_undo(draft));
    CHECK(draft_plan(draft)->door_count == doors);
    free((char *)wall);
    free((char *)person);
    draft_destroy(draft);
}

TEST(a_new_name_is_known_everywhere) {
    Draft *draft = read_house("flat-0.910-module");
    char *wall = strdup(draft_plan(draft)->doors[0].wall);
    Fault fault = {0};
    draft_begin(draft, "Rename");
    CHECK(draft_rename(draft, wall, "party-wall", &fault));
    CHECK(!draft_rename(draft, "party-wall", "no good", &fault));
    CHECK(!draft_rename(draft, "party-wall", draft_plan(draft)->people[0].id, &fault));
    CHECK(ends(draft));
    CHECK_TEXT(draft_plan(draft)->doors[0].wall, "party-wall");
    CHECK(fault.count == 2);
    fault_clear(&fault);
    free(wall);
    draft_destroy(draft);
}

TEST(pieces_are_copied_as_text_and_pasted_with_new_names) {
    Draft *draft = read_house("flat-0.910-module");
    size_t walls = draft_plan(draft)->wall_count, doors = draft_plan(draft)->door_count, count;
    const char *ids[] = {strdup(draft_plan(draft)->doors[0].wall), strdup(draft_plan(draft)->furniture[0].id)};
    char *text = draft_clip_copy(draft, ids, 2);
    const char **pasted;
    Fault fault = {0};
    draft_begin(draft, "Paste");
    CHECK(draft_clip_paste(draft, text, vec2(30, 0), &pasted, &count, &fault));
    CHECK(ends(draft));
    CHECK(draft_plan(draft)->wall_count == walls + 1);
    CHECK(draft_plan(draft)->door_count > doors);
    CHECK_TEXT(draft_plan(draft)->doors[doors].wall, draft_plan(draft)->walls[walls].id);
    CHECK_NEAR(draft_plan(draft)->furniture[draft_plan(draft)->furniture_count - 1].centre.x,
               draft_plan(draft)->furniture[0].centre.x + 30, 1e-9);
    memory_free(pasted);
    static const char *const bad[] = {"",
                                      "[]",
                                      "{}",
                                      "{\"format\": \"clearance-pieces\", \"walls\": 3}",
                                      "{\"format\": \"clearance-pieces\", \"walls\": [{}]}",
                                      "wardrobe"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        draft_begin(draft, "Paste");
        CHECK(!draft_clip_paste(draft, bad[i], vec2(0, 0), &pasted, &count, &fault));
        draft_cancel(draft);
    }
    CHECK(fault.count == sizeof bad / sizeof *bad);
    CHECK(!draft_clip_copy(draft, NULL, 0));
    fault_clear(&fault);
    memory_free(text);
    free((char *)ids[0]);
    free((char *)ids[1]);
    draft_destroy(draft);
}

TEST(a_house_from_nothing_is_saved_and_read_again) {
    char path[SCRATCH_PATH];
    scratch_write(path, "");
    Draft *draft = draft_create("new house");
    CHECK(draft_file_is_changed(draft) && !draft_file_path(draft));
    Vec2 points[] = {{0, 0}, {4, 0}};
    draft_begin(draft, "Draw walls");
    const char *id = draft_add(draft, DRAFT_WALLS, json_object());
    CHECK_TEXT(id, "w1");
    draft_set_points(draft, "w1", "points", points, 2);
    CHECK(ends(draft));
    Fault fault = {0};
    CHECK(draft_file_save(draft, path, &fault));
    CHECK(!draft_file_is_changed(draft));
    Draft *again = draft_file_read(path, NULL, 0, &fault);
    CHECK(again && !fault.count);
    CHECK_TEXT(draft_text(again), draft_text(draft));
    CHECK(draft_undo(draft) && draft_file_is_changed(draft));
    draft_destroy(again);
    draft_destroy(draft);
    unlink(path);
}

TEST(an_unchanged_house_is_saved_with_the_bytes_it_was_read_with) {
    char path[SCRATCH_PATH];
    scratch_write(path, "{'format' :\n\n 'clearance-house', 'version': 1, 'walls': [ ],\n   'name': 'odd'}");
    char *bytes = scratch_read(path);
    Fault fault = {0};
    Draft *draft = draft_file_read(path, NULL, 0, &fault);
    draft_begin(draft, "Name");
    draft_set_house(draft, "name", json_string("even"));
    CHECK(ends(draft));
    draft_undo(draft);
    CHECK(draft_file_save(draft, path, &fault));
    char *again = scratch_read(path);
    CHECK_TEXT(again, bytes);
    memory_free(again);
    CHECK(draft_redo(draft) && draft_file_save(draft, path, &fault));
    again = scratch_read(path);
    CHECK(strstr(again, "\"even\""));
    CHECK(!draft_file_save(draft, "/nowhere/house.json", &fault));
    memory_free(again);
    memory_free(bytes);
    fault_clear(&fault);
    draft_destroy(draft);
    unlink(path);
}

TEST(parameters_are_set_by_the_names_that_set_has) {
    Draft *draft = read_house("flat-0.910-module");
    Fault fault = {0};
    char name[64];
    snprintf(name, sizeof name, "exit.%s.to.x", draft_plan(draft)->exits[0].id);
    double to = draft_plan(draft)->exits[0].to.x + 0.125;
    draft_begin(draft, "Set");
    CHECK(draft_parameter_set(draft, name, json_real(to), &fault));
    CHECK(draft_parameter_set(draft, "run.until", json_real(77), &fault));
    CHECK(draft_parameter_set(draft, "profile.manual-chair.width", json_real(0.7), &fault));
    CHECK(!draft_parameter_set(draft, "door.none.width", json_real(1), &fault));
    CHECK(!draft_parameter_set(draft, "wall.d1", json_real(1), &fault));
    CHECK(ends(draft));
    CHECK_NEAR(draft_plan(draft)->exits[0].to.x, to, 0);
    CHECK_NEAR(draft_plan(draft)->run.until, 77, 0);
    CHECK(draft_plan(draft)->override_count == 1);
    draft_file_reset(draft, "Reset scene");
    CHECK(!draft_file_is_changed(draft));
    CHECK_TEXT(draft_undo_name(draft), "Reset scene");
    CHECK(draft_undo(draft) && draft_file_is_changed(draft));
    fault_clear(&fault);
    draft_destroy(draft);
}

/* Random edits ----------------------------------------------------------------------------------------------------- */

static size_t element_count(const Draft *draft) {
    size_t count = 0;
    for (int l = 0; l < DRAFT_LISTS; l++)
        count += draft_count(draft, (DraftList)l);
    return count;
}

static const char *random_id(Draft *draft, Random *random) {
    size_t count = element_count(draft), skip = count ? random_bits(random) % count : 0;
    for (int l = 0; l < DRAFT_LISTS; skip -= draft_count(draft, (DraftList)l), l++)
        if (skip < draft_count(draft, (DraftList)l))
            return json_string_value(json_object_get(draft_at(draft, (DraftList)l, skip), "id"));
    return "w1";
}

static double random_value(Random *random) {
    static const double odd[] = {0, -1, 1e308, -1e-300, 0.8, 90, 1e5};
    return random_bits(random) % 4 ? 6 * random_uniform(random) - 1 : odd[random_bits(random) % 7];
}

static Vec2 random_place(Random *random) {
    return vec2(12 * random_uniform(random) - 1, 10 * random_uniform(random) - 1);
}

static void edit_at_random(Draft *draft, Random *random) {
    static const char *const members[] = {"width",   "at",    "thickness", "angle", "height",
                                          "segment", "delay", "speed",     "id"};
    char id[64];
    snprintf(id, sizeof id, "%s", random_id(draft, random));
    Vec2 points[] = {random_place(random), random_place(random)};
    Fault fault = {0};
    const char **pasted;
    size_t count;
    char *text;
    switch (random_bits(random) % 8) {
    case 0:
        draft_set_point(draft, id, random_bits(random) % 2 ? "centre" : "at", points[0]);
        break;
    case 1:
        draft_set_number(draft, id, members[random_bits(random) % 9], random_value(random));
        break;
    case 2:
        if (element_count(draft) > ELEMENTS || random_bits(random) % 8 == 0)
            draft_remove(draft, id);
        break;
    case 3:
        if (element_count(draft) > ELEMENTS)
            draft_remove(draft, id);
        draft_set_points(draft, draft_add(draft, DRAFT_WALLS, json_object()), "points", points, 2);
        break;
    case 4:
        if (element_count(draft) > ELEMENTS)
            draft_remove(draft, id);
        draft_add(
            draft, DRAFT_FURNITURE,
            json_pack("{s:[f,f],s:[f,f]}", "centre", points[0].x, points[0].y, "size", random_uniform(random), 0.4));
        break;
    case 5:
        if (element_count(draft) > ELEMENTS)
            break;
        text = draft_clip_copy(draft, (const char *[]){id}, 1);
        if (text && draft_clip_paste(draft, text, points[0], &pasted, &count, &fault))
            memory_free(pasted);
        memory_free(text);
        break;
    case 6:
        draft_rename(draft, id, random_id(draft, random), &fault);
        break;
    default:
        draft_set_point(draft, id, "at", points[0]);
    }
    fault_clear(&fault);
}

static void try_random_edits(const char *house, uint64_t seed, size_t edits) {
    Draft *draft = read_house(house);
    Random random = random_seed(seed, 0);
    Fault fault = {0};
    char *first = strdup(draft_text(draft));
    size_t stood = 0;
    for (size_t i = 0; i < edits; i++) {
        draft_begin(draft, "Edit");
        for (size_t n = random_bits(&random) % 3 + 1; n > 0; n--)
            edit_at_random(draft, &random);
        if (random_bits(&random) % 8 == 0)
            draft_try(draft, &fault);
        if (random_bits(&random) % 16 == 0)
            draft_rewind(draft);
        stood += draft_end(draft, &fault);
        fault_clear(&fault);
        for (size_t n = random_bits(&random) % 8; n > 5; n--)
            random_bits(&random) % 2 ? draft_undo(draft) : draft_redo(draft);
        if (i % 500 == 0) {
            Plan plan = {0};
            CHECK(plan_read_text(&plan, "again", draft_text(draft), NULL, 0, &fault) && !fault.count);
            char *again = plan_text(&plan);
            CHECK_TEXT(again, draft_text(draft));
            free(again);
            plan_free(&plan);
        }
    }
    CHECK(stood > edits / 8);
    while (draft_redo(draft)) {
    }
    char *last = strdup(draft_text(draft));
    while (draft_undo(draft)) {
    }
    CHECK(strcmp(draft_text(draft), first) == 0);
    while (draft_redo(draft)) {
    }
    CHECK(strcmp(draft_text(draft), last) == 0);
    free(first);
    free(last);
    draft_destroy(draft);
}

TEST(ten_thousand_random_edits_stand_or_are_refused_and_are_undone_to_the_first_bytes) {
    try_random_edits("flat-0.910-module", 1, EDITS);
}

TEST(random_edits_of_another_house_too) {
    try_random_edits("ube-techno-house", 2, EDITS / 20);
}
