#include "inquiry/suggest.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "check.h"
#include "scratch.h"
#include "base/stop.h"
#include "house/run.h"
#include "inquiry/suggest_change.h"

/* A corridor of 8 m, 1.2 m clear, straight ahead of a chair of 0.63 m; its exit is at the right end. */
#define CORRIDOR                                                                                                       \
    "{'format': 'clearance-house', 'version': 1, 'name': 'corridor', 'walls': ["                                       \
    "{'id': 'south', 'points': [[0, -0.05], [8, -0.05]], 'thickness': 0.1},"                                           \
    "{'id': 'north', 'points': [[0, 1.25], [8, 1.25]], 'thickness': 0.1},"                                             \
    "{'id': 'west', 'points': [[-0.05, -0.05], [-0.05, 1.25]], 'thickness': 0.1},"                                     \
    "{'id': 'first', 'points': [[3, 0], [3, 1.2]], 'thickness': 0.1},"                                                 \
    "{'id': 'second', 'points': [[5.5, 0], [5.5, 1.2]], 'thickness': 0.1}],"                                           \
    "'exits': [{'id': 'e1', 'from': [7.5, 0], 'to': [7.5, 1.2]}],"                                                     \
    "'people': [{'id': 'p1', 'profile': 'manual-chair', 'at': [0.8, 0.6]}],"
#define DOORS(first_, second_)                                                                                         \
    "'doors': [{'id': 'd1', 'wall': 'first', 'at': 0.6, 'width': " first_ "},"                                         \
    "{'id': 'd2', 'wall': 'second', 'at': 0.6, 'width': " second_ "}]"

typedef struct Case {
    char path[SCRATCH_PATH], profiles[4096];
    HouseOptions options;
} Case;

static void open_case(Case *made, const char *text) {
    scratch_write(made->path, text);
    snprintf(made->profiles, sizeof made->profiles, "%s/assets/profiles", check_source());
    made->options = (HouseOptions){.profiles = made->profiles, .seed = 1, .driving = -1};
}

static void find(SuggestList *list, const Case *made, int jobs) {
    Fault fault = {0};
    SuggestTask task = {.path = made->path, .options = &made->options, .jobs = jobs};
    CHECK(suggest_find(list, &task, &fault));
    check_say(&fault);
}

/* True if all people leave with these settings; returns the time. */
static bool all_out(const Case *made, const char *const *settings, size_t count, double *time) {
    House house = {0};
    Fault fault = {0};
    HouseOptions options = made->options;
    options.settings = settings;
    options.setting_count = count;
    bool good = house_read(&house, made->path, &options, &fault);
    if (good) {
        Observation observation;
        run_house(&observation, &house, &(RunOptions){.route = SIZE_MAX, .jobs = 1});
        good = observation.completed;
        *time = observation.time;
        observation_free(&observation);
        house_free(&house);
    }
    fault_clear(&fault);
    return good;
}

/* Each suggestion alone is sufficient, with the stated time. */
static void check_all(const Case *made, const SuggestList *list) {
    for (size_t i = 0; i < list->count; i++) {
        const Suggestion *one = &list->list[i];
        double time = 0;
        CHECK(all_out(made, one->settings, one->setting_count, &time));
        CHECK(time == one->time);
        CHECK(i == 0 || list->list[i - 1].size <= one->size);
    }
}

/* Returns the first suggestion whose text contains this, or NULL. */
static const Suggestion *with_words(const SuggestList *list, const char *words) {
    for (size_t i = 0; i < list->count; i++)
        if (strstr(list->list[i].text, words))
            return &list->list[i];
    return NULL;
}

TEST(a_house_that_everybody_leaves_needs_no_change) {
    Case made;
    SuggestList list;
    open_case(&made, CORRIDOR DOORS("0.9", "0.9") "}");
    find(&list, &made, 1);
    CHECK(list.out_already && list.count == 0 && list.time > 0);
    suggest_clear(&list);
    unlink(made.path);
}

TEST(a_narrow_door_is_widened_to_what_the_chair_needs) {
    Case made;
    SuggestList list;
    open_case(&made, CORRIDOR DOORS("0.6", "0.9") "}");
    find(&list, &made, 1);
    CHECK(!list.out_already && list.count == 1);
    CHECK_TEXT(list.list[0].settings[0], "door.d1.width=0.64"); /* a corridor of 0.63 m has no space for planning */
    CHECK_TEXT(list.list[0].text, "Widen door d1 from 0.60 m to 0.64 m");
    CHECK_NEAR(list.list[0].size, 0.04, 1e-9);
    check_all(&made, &list);
    const char *less = "door.d1.width=0.63";
    double time;
    CHECK(!all_out(&made, &less, 1, &time));
    suggest_clear(&list);
    unlink(made.path);
}

LONG_TEST(two_narrow_doors_in_a_row_are_widened_together) {
    Case made;
    SuggestList list;
    open_case(&made, CORRIDOR DOORS("0.6", "0.55") "}");
    find(&list, &made, 1);
    CHECK(list.count == 1 && list.list[0].setting_count == 2);
    CHECK(with_words(&list, "iden door d1 from 0.60 m to 0.64 m"));
    CHECK(with_words(&list, "iden door d2 from 0.55 m to 0.64 m"));
    CHECK_NEAR(list.list[0].size, 0.13, 1e-9);
    check_all(&made, &list);
    suggest_clear(&list);
    unlink(made.path);
}

/* A wardrobe before a niche leaves 0.55 m of the corridor's 1.2 m. The chair passes when there are 0.64 m, so that the
 * wardrobe must go 9 cm into the niche. */
#define NICHE                                                                                                          \
    "{'format': 'clearance-house', 'version': 1, 'name': 'niche', 'walls': ["                                          \
    "{'id': 'south', 'points': [[0, -0.05], [8, -0.05]], 'thickness': 0.1},"                                           \
    "{'id': 'west', 'points': [[-0.05, -0.05], [-0.05, 1.25]], 'thickness': 0.1},"                                     \
    "{'id': 'north', 'points': [[0, 1.25], [3.2, 1.25], [3.2, 1.85], [4.8, 1.85], [4.8, 1.25], [8, 1.25]],"            \
    "'thickness': 0.1}],"                                                                                              \
    "'furniture': [{'id': 'f1', 'name': 'wardrobe', 'centre': [4, 0.95], 'size': [1.5, 0.8], 'height': 1.8}],"         \
    "'exits': [{'id': 'e1', 'from': [7.5, 0], 'to': [7.5, 1.2]}],"                                                     \
    "'people': [{'id': 'p1', 'profile': 'manual-chair', 'at': [0.8, 0.32]}]}"

LONG_TEST(a_wardrobe_in_a_corridor_is_moved_as_far_as_it_must_by_any_number_of_threads) {
    Case made;
    SuggestList list, other;
    open_case(&made, NICHE);
    find(&list, &made, 1);
    CHECK(list.count == 1);
    CHECK_TEXT(list.list[0].settings[0], "furniture.f1.centre.y=1.04");
    CHECK_TEXT(list.list[0].text, "Move wardrobe (f1) 0.09 m up on the plan");
    check_all(&made, &list);
    const char *less = "furniture.f1.centre.y=1.03";
    double time;
    CHECK(!all_out(&made, &less, 1, &time));
    find(&other, &made, 3);
    CHECK(other.count == 1 && other.tries == list.tries && other.list[0].time == list.list[0].time);
    CHECK_TEXT(other.list[0].text, list.list[0].text);
    suggest_clear(&list);
    suggest_clear(&other);
    unlink(made.path);
}

/* A wardrobe in a niche has fallen across the corridor and can move neither sideways nor back. */
LONG_TEST(what_has_toppled_may_be_stood_up) {
    Case made;
    SuggestList list;
    open_case(
        &made,
        "{'format': 'clearance-house', 'version': 1, 'name': 'niche', 'walls': ["
        "{'id': 'south', 'points': [[0, -0.05], [8, -0.05]], 'thickness': 0.1},"
        "{'id': 'north', 'points': [[0, 1.25], [2.95, 1.25], [2.95, 1.85], [3.95, 1.85], [3.95, 1.25], [8, 1.25]],"
        "'thickness': 0.1}, {'id': 'west', 'points': [[-0.05, -0.05], [-0.05, 1.25]], 'thickness': 0.1}],"
        "'furniture': [{'id': 'f1', 'name': 'wardrobe', 'centre': [3.45, 1.55], 'size': [0.85, 0.45],"
        "'height': 1, 'topples': 'front', 'toppled': true}],"
        "'exits': [{'id': 'e1', 'from': [7.5, 0], 'to': [7.5, 1.2]}],"
        "'people': [{'id': 'p1', 'profile': 'manual-chair', 'at': [0.8, 0.6]}]}");
    find(&list, &made, 2);
    CHECK(list.count == 1 && list.list[0].size == 1);
    CHECK_TEXT(list.list[0].text, "Stand wardrobe (f1) up");
    CHECK_TEXT(list.list[0].settings[0], "furniture.f1.toppled=false");
    check_all(&made, &list);
    suggest_clear(&list);
    unlink(made.path);
}

TEST(walls_are_not_moved_and_that_is_said) {
    Case made = {.options = {.seed = 1, .driving = -1}};
    snprintf(made.profiles, sizeof made.profiles, "%s/assets/profiles", check_source());
    snprintf(made.path, sizeof made.path, "%s", scratch_source("houses/corner-0.78-0.78.json"));
    made.options.profiles = made.profiles;
    SuggestList list;
    find(&list, &made, 1);
    CHECK(!list.out_already && list.count == 0 && list.note_count == 1);
    CHECK(strstr(list.notes[0], "no door to widen and no furniture to move"));
    CHECK(strstr(list.notes[0], "Walls are not moved"));
    suggest_clear(&list);
}

TEST(the_tries_are_bounded_and_a_flag_ends_them) {
    Case made;
    SuggestList list;
    Fault fault = {0};
    open_case(&made, CORRIDOR DOORS("0.6", "0.55") "}");
    SuggestTask task = {.path = made.path, .options = &made.options, .jobs = 1, .most_tries = 4};
    CHECK(suggest_find(&list, &task, &fault) && list.exhausted && list.tries <= 4 && list.count == 0);
    suggest_clear(&list);
    Stop stop = {1};
    task = (SuggestTask){.path = made.path, .options = &made.options, .jobs = 1, .stop = &stop};
    CHECK(suggest_find(&list, &task, &fault) && list.stopped && list.count == 0);
    suggest_clear(&list);
    task.path = "no such house";
    CHECK(!suggest_find(&list, &task, &fault) && fault.count == 1);
    fault_clear(&fault);
    unlink(made.path);
}

TEST(a_door_is_widened_only_where_its_wall_is_free) {
    Plan plan = {0};
    scratch_plan(&plan, "'walls': [{'id': 'w', 'points': [[0, 0], [4, 0]], 'thickness': 0.1},"
                        "{'id': 'side', 'points': [[1, 0], [1, 3]], 'thickness': 0.2}],"
                        "'doors': [{'id': 'd1', 'wall': 'w', 'at': 1.5, 'width': 0.6},"
                        "{'id': 'd2', 'wall': 'w', 'at': 3, 'width': 0.8}]");
    double low, high;
    suggest_change_room(&plan, 0, &low, &high);
    CHECK_NEAR(low, 1.1, 1e-9); /* next to the other wall's face */
    CHECK_NEAR(high, 2.6, 1e-9);
    Change change = suggest_change_widen(&plan, 0, 0.8);
    CHECK_NEAR(change.at, 1.5, 1e-9);
    change = suggest_change_widen(&plan, 0, 1); /* where one side is used up, it grows to the other */
    CHECK_NEAR(change.at, 1.6, 1e-9);
    suggest_change_room(&plan, 1, &low, &high);
    CHECK_NEAR(low, 1.8, 1e-9);
    CHECK_NEAR(high, 4, 1e-9);
    plan_free(&plan);
}

TEST(a_piece_is_not_moved_through_walls_or_into_others_or_an_open_leaf) {
    Plan plan = {0};
    scratch_plan(&plan, "'walls': [{'id': 'w', 'points': [[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]], 'thickness': 0.1},"
                        "{'id': 'mid', 'points': [[2, 0], [2, 3]], 'thickness': 0.1}],"
                        "'doors': [{'id': 'd1', 'wall': 'mid', 'at': 1.5, 'width': 0.9, 'kind': 'hinged'}],"
                        "'furniture': [{'id': 'f1', 'centre': [1, 1.5], 'size': [0.4, 0.4]},"
                        "{'id': 'f2', 'centre': [1, 2.3], 'size': [0.4, 0.4]}]");
    static const struct {
        double far, direction;
        bool free;
    } moves[] = {{0.3, 0, true},       {0.7, 0, true},          {0.8, 0, false},
                 {1.6, 0, false},      {0.35, M_PI / 2, true},  {0.5, M_PI / 2, false},
                 {1, -M_PI / 2, true}, {1.3, -M_PI / 2, false}, {0.67, -0.733, false} /* the leaf of the open door */};
    for (size_t m = 0; m < sizeof moves / sizeof *moves; m++) {
        Change change = suggest_change_move(0, moves[m].far, moves[m].direction);
        CHECK(suggest_change_stands_free(&plan, &change) == moves[m].free);
    }
    plan_free(&plan);
}
