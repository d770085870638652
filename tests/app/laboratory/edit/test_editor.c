/* Tests editing of a running house: drawing and typing give equal plans, every step is undone to the same bytes, and
 * no invalid house can result. */

#include "base/text.h"
#include "laboratory/edit/editor.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "plan/draft.h"
#include "laboratory/house/session.h"

static const Laboratory *const kind = &house_laboratory;

enum { LONGEST = 65536 };

#define REACH 0.05 /* m */

static void *open_live(const char *name) {
    char path[4096], profiles[4096];
    snprintf(path, sizeof path, "%s/houses/%s.json", check_source(), name ? name : "");
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    LaboratoryOptions options = {.profiles = profiles, .driving = -1, .seed = 1, .jobs = 1};
    void *live = kind->open(name ? path : NULL, &options, &fault);
    check_say(&fault);
    return live;
}

static Pointer hand(double x, double y) {
    return (Pointer){.at = {x, y}, .reach = REACH};
}

static void move_to(void *live, double x, double y) {
    Pointer at = hand(x, y);
    editor_point(kind->editor(live), &at);
}

static void press(void *live, double x, double y) {
    Pointer at = hand(x, y);
    editor_point(kind->editor(live), &at);
    editor_press(kind->editor(live), &at, false);
}

static void release(void *live, double x, double y) {
    Pointer at = hand(x, y);
    editor_point(kind->editor(live), &at);
    editor_release(kind->editor(live), &at);
}

static void click(void *live, double x, double y) {
    press(live, x, y);
    release(live, x, y);
}

static void drag(void *live, double x, double y, double to_x, double to_y) {
    press(live, x, y);
    move_to(live, (x + to_x) / 2, (y + to_y) / 2);
    release(live, to_x, to_y);
}

/* Types characters one by one; | is Enter, > is Tab, < is Backspace, ~ is Escape. */
static void keys(void *live, const char *text) {
    for (; *text; text++) {
        char letter[2] = {*text, 0};
        if (*text == '|')
            CHECK(editor_enter(kind->editor(live)));
        else if (*text == '>')
            CHECK(editor_tab(kind->editor(live), 1));
        else if (*text == '<')
            CHECK(editor_back(kind->editor(live)));
        else if (*text == '~')
            CHECK(editor_escape(kind->editor(live)));
        else if (!editor_type(kind->editor(live), letter))
            CHECK_TEXT(letter, "a letter that is taken");
    }
}

/* Returns a hash that distinguishes texts. */
static char *keep_text(void *live) {
    return text_copy(editor_text(kind->editor(live)));
}

/* Checks that undo restored the stored text, and releases it. */
static void undo_all(void *live, char *before) {
    while (editor_undo(kind->editor(live)))
        ;
    CHECK_TEXT(editor_text(kind->editor(live)), before);
    memory_free(before);
    kind->close(live);
}

static void choose(void *live, const char *group, const char *name) {
    size_t count;
    const CatalogueRow *items = editor_items(kind->editor(live), &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(items[i].name, name) == 0 && strcmp(items[i].group, group) == 0) {
            editor_choose_item(kind->editor(live), i);
            return;
        }
    CHECK_TEXT(name, "an item");
}

/* A flat of 8 m by 6 m with four rooms: walls that cross in the middle, doors, a person and a wardrobe. */
static void draw_by_hand(void *live) {
    editor_set_tool(kind->editor(live), TOOL_WALL);
    click(live, 0.003, 0.004);
    click(live, 8.004, 0.02);
    click(live, 8.02, 6.004);
    click(live, 0.01, 5.99);
    click(live, 0.01, 0.01);
    click(live, 4.004, 0.01);
    click(live, 4.01, 6.01);
    click(live, 4.01, 6.01);
    drag(live, 0.01, 3.004, 8.01, 3.01);
    editor_escape(kind->editor(live));
    editor_set_tool(kind->editor(live), TOOL_DOOR);
    click(live, 4.02, 1.5);
    click(live, 4.02, 4.503);
    click(live, 2.0, 3.02);
    click(live, 8.02, 1.5);
    editor_set_tool(kind->editor(live), TOOL_EXIT);
    click(live, 8.02, 1.5);
    editor_set_tool(kind->editor(live), TOOL_PERSON);
    choose(live, "", "manual-chair");
    click(live, 2.0, 4.5);
    editor_set_tool(kind->editor(live), TOOL_FURNITURE);
    choose(live, "European", "wardrobe");
    click(live, 1.0, 5.5);
}

static void type_all(void *live) {
    editor_set_tool(kind->editor(live), TOOL_WALL);
    keys(live, "|0>0|8>0|6>90|800cm>180|2400mm+3.6m>-90|");
    keys(live, "|4>0|6>90|~");
    keys(live, "|0>3|8|~");
    editor_set_tool(kind->editor(live), TOOL_DOOR);
    keys(live, "|4>1.5|");
    keys(live, "|4>4.5|");
    keys(live, "|2>3|");
    keys(live, "|8>1.5|");
    editor_set_tool(kind->editor(live), TOOL_EXIT);
    keys(live, "|8>1.1|0.8>90|");
    editor_set_tool(kind->editor(live), TOOL_PERSON);
    choose(live, "", "manual-chair");
    keys(live, "|2>4.5|");
    editor_set_tool(kind->editor(live), TOOL_FURNITURE);
    choose(live, "European", "wardrobe");
    keys(live, "|1>5,64|");
}

TEST(a_flat_drawn_by_hand_and_one_that_is_typed_are_the_same) {
    void *by_hand = open_live(NULL), *typed = open_live(NULL);
    draw_by_hand(by_hand);
    type_all(typed);
    CHECK_TEXT(editor_text(kind->editor(typed)), editor_text(kind->editor(by_hand)));
    kind->close(by_hand);
    kind->close(typed);
}

TEST(a_flat_is_undone_to_the_empty_plan_and_redone_to_the_same_bytes) {
    void *live = open_live(NULL);
    char *empty = keep_text(live);
    draw_by_hand(live);
    char *drawn = keep_text(live);
    size_t steps = editor_edit_count(kind->editor(live)), undone = 0, redone = 0;
    while (editor_undo(kind->editor(live)))
        undone++;
    CHECK_NEAR((double)undone, (double)steps, 0);
    CHECK_TEXT(editor_text(kind->editor(live)), empty);
    CHECK(!editor_undo_name(kind->editor(live)));
    while (editor_redo(kind->editor(live)))
        redone++;
    CHECK_NEAR((double)redone, (double)steps, 0);
    CHECK_TEXT(editor_text(kind->editor(live)), drawn);
    memory_free(empty);
    memory_free(drawn);
    kind->close(live);
}

/* Handles --------------------------------------------------------------------------------------------------------- */

/* A room of 4 m by 3 m with a door, an exit across it, a person on a route, a wardrobe and the room's outline. */
static const char small_house[] =
    "{\"format\": \"clearance-house\", \"version\": 1, \"walls\": [{\"id\": \"w1\", \"points\": [[0, 0], [4, 0], [4, "
    "3], [0, 3], [0, 0]]}, {\"id\": \"w2\", \"points\": [[4, 3], [7, 3]]}], \"doors\": [{\"id\": \"d1\", \"wall\": "
    "\"w1\", \"at\": 2, \"width\": 0.9, \"kind\": \"hinged\"}], \"furniture\": [{\"id\": \"f1\", \"name\": "
    "\"wardrobe\", \"centre\": [1, 2.6], \"size\": [1, 0.6], \"height\": 1.8, \"topples\": \"front\"}], \"rooms\": "
    "[{\"id\": \"r1\", \"name\": \"hall\", \"outline\": [[0.06, 0.06], [3.94, 0.06], [3.94, 2.94], [0.06, 2.94]]}], "
    "\"exits\": [{\"id\": \"e1\", \"from\": [1.5, -1], \"to\": [2.5, -1]}], \"people\": [{\"id\": \"p1\", "
    "\"profile\": \"adult\", \"at\": [3, 1.5]}], \"routes\": [{\"id\": \"A\", \"people\": [\"p1\"], \"via\": [[2, "
    "1]], \"exit\": \"e1\"}]}";

static void *open_text(const char *text) {
    char path[] = "/tmp/clearance-edit-XXXXXX";
    char profiles[4096];
    int file = mkstemp(path);
    FILE *stream = fdopen(file, "w");
    fputs(text, stream);
    fclose(stream);
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    LaboratoryOptions options = {.profiles = profiles, .driving = -1, .seed = 1, .jobs = 1};
    void *live = kind->open(path, &options, &fault);
    check_say(&fault);
    unlink(path);
    for (int i = 0; i < 2000 && !kind->span(live).complete; i++) {
        kind->update(live, 0);
        nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL);
    }
    return live;
}

typedef struct Held {
    const char *what;   /* clicked to select it */
    Vec2 at, from, to;  /* m: place of selection, its handle, and the handle's destination */
    const char *member; /* part of the resulting text */
} Held;

static const Held handles[] = {
    {"a wall's end", {5.5, 3}, {7, 3}, {7, 4}, "[[4, 3], [7, 4]]"},
    {"a corner of two walls", {5.5, 3}, {4, 3}, {4.5, 3}, "[[0, 0], [4, 0], [4.5, 3], [0, 3], [0, 0]]"},
    {"a piece of a wall", {5.5, 3}, {5.5, 3}, {5.5, 3.5}, "[[4, 3.5], [7, 3.5]]"},
    {"a closed wall's first point",
     {3.5, 0},
     {0, 0},
     {-0.5, -0.5},
     "[[-0.5, -0.5], [4, 0], [4, 3], [0, 3], [-0.5, -0.5]]"},
    {"a door's middle", {2, 0}, {2, 0}, {2.5, 0}, "\"at\": 2.5, \"width\": 0.9"},
    {"a door to another wall", {2, 0}, {2, 0}, {5.5, 3.02}, "\"wall\": \"w2\", \"at\": 1.5"},
    {"a door's edge", {2, 0}, {2.45, 0}, {2.6, 0}, "\"at\": 2.075, \"width\": 1.05"},
    {"a door's other edge", {2, 0}, {1.55, 0}, {1.6, 0}, "\"at\": 2.025, \"width\": 0.85"},
    {"a piece's middle", {1, 2.6}, {1, 2.6}, {2, 1.5}, "\"centre\": [2, 1.5]"},
    {"a piece's corner", {1, 2.6}, {1.5, 2.3}, {1.7, 2.2}, "\"centre\": [1.1, 2.55], \"size\": [1.2, 0.7]"},
    {"a piece's turn", {1, 2.6}, {1, 1.85}, {2, 2.6}, "\"angle\": 90"},
    {"an exit's end", {2, -1}, {2.5, -1}, {3, -1}, "\"to\": [3, -1]"},
    {"an exit's middle", {2, -1}, {2, -1}, {2, -1.5}, "\"from\": [1.5, -1.5], \"to\": [2.5, -1.5]"},
    {"a person", {3, 1.5}, {3, 1.5}, {3, 1}, "\"at\": [3, 1]"},
    {"a person's heading", {3, 1.5}, {3.9, 1.5}, {3, 2.4}, "\"heading\": 90"},
    {"a route's point", {3, 1.5}, {2, 1}, {1, 1}, "\"via\": [[1, 1]]"},
    {"a room's corner", {2.5, 2}, {3.94, 2.94}, {3.5, 2.5}, "[3.5, 2.5]"},
};

TEST(a_handle_that_is_clicked_twice_does_what_dragging_does) {
    for (size_t i = 0; i < sizeof handles / sizeof *handles; i++) {
        const Held *held = &handles[i];
        void *dragged = open_text(small_house), *clicked = open_text(small_house);
        char *before = keep_text(dragged);
        click(dragged, held->at.x, held->at.y);
        drag(dragged, held->from.x, held->from.y, held->to.x, held->to.y);
        click(clicked, held->at.x, held->at.y);
        click(clicked, held->from.x, held->from.y);
        CHECK(editor_gesture(kind->editor(clicked))->active);
        move_to(clicked, held->to.x, held->to.y);
        click(clicked, held->to.x, held->to.y);
        CHECK(!editor_gesture(kind->editor(clicked))->active);
        CHECK_TEXT(editor_text(kind->editor(clicked)), editor_text(kind->editor(dragged)));
        if (!strstr(editor_text(kind->editor(dragged)), held->member)) {
            CHECK_TEXT(held->what, "as expected");
            printf("%s\n%s",
                   editor_undo_name(kind->editor(dragged)) ? editor_undo_name(kind->editor(dragged)) : "nothing done",
                   editor_text(kind->editor(dragged)));
        }
        CHECK(editor_undo(kind->editor(dragged)) && !editor_undo(kind->editor(dragged)));
        CHECK_TEXT(editor_text(kind->editor(dragged)), before);
        memory_free(before);
        kind->close(dragged);
        kind->close(clicked);
    }
}

TEST(escape_leaves_exactly_what_was_before) {
    void *live = open_text(small_house);
    char *before = keep_text(live);
    for (size_t i = 0; i < sizeof handles / sizeof *handles; i++) {
        const Held *held = &handles[i];
        kind->select(live, (Item){0, 0});
        click(live, held->at.x, held->at.y);
        press(live, held->from.x, held->from.y);
        move_to(live, held->to.x, held->to.y);
        CHECK(editor_gesture(kind->editor(live))->active);
        CHECK(strcmp(editor_text(kind->editor(live)), before) != 0);
        CHECK(editor_escape(kind->editor(live)));
        release(live, held->to.x, held->to.y);
        CHECK_TEXT(editor_text(kind->editor(live)), before);
        CHECK(!editor_undo_name(kind->editor(live)));
    }
    memory_free(before);
    kind->close(live);
}

/* Snapping, typing and refusals ------------------------------------------------------------------------------------ */

/* Returns the name of the snap target, "" if there is none. */
static const char *snapped(void *live) {
    const GestureView *gesture = editor_gesture(kind->editor(live));
    for (size_t i = 0; i < gesture->mark_count; i++)
        if (gesture->marks[i].kind == MARK_SNAP)
            return gesture->marks[i].text;
    return "";
}

TEST(what_is_snapped_to_has_a_name) {
    void *live = open_text(small_house);
    editor_set_tool(kind->editor(live), TOOL_WALL);
    move_to(live, 6.97, 3.02);
    CHECK_TEXT(snapped(live), "end of w2");
    move_to(live, 2.0, 0.03);
    CHECK_TEXT(snapped(live), "on w1");
    move_to(live, 4.02, 5.0);
    CHECK_TEXT(snapped(live), "in line with w1");
    move_to(live, 5.5, 5.5);
    CHECK_TEXT(snapped(live), "");
    Pointer free = hand(6.97, 3.02);
    free.free = true;
    editor_point(kind->editor(live), &free);
    CHECK_TEXT(snapped(live), "");
    click(live, 5.0, 5.0);
    move_to(live, 5.02, 6.5);
    CHECK_TEXT(snapped(live), "90 degrees");
    Pointer straight = hand(6.8, 5.6);
    straight.straight = true;
    editor_point(kind->editor(live), &straight);
    CHECK_TEXT(snapped(live), "straight across");
    editor_press(kind->editor(live), &straight, false);
    editor_release(kind->editor(live), &straight);
    editor_escape(kind->editor(live));
    CHECK(strstr(editor_text(kind->editor(live)), "\"points\": [[5, 5], [6.8, 5]]"));
    kind->close(live);
}

TEST(a_length_is_typed_in_any_way_that_people_write_it) {
    static const char *const lengths[] = {"2.5", "2,5", "250cm", "2500 mm", "1.2+1.3", "8ft 2.4251968504in"};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        void *live = open_live(NULL);
        editor_set_tool(kind->editor(live), TOOL_WALL);
        click(live, 1, 1);
        move_to(live, 3.1, 1.02);
        keys(live, lengths[i]);
        keys(live, "|~");
        CHECK(strstr(editor_text(kind->editor(live)), "\"points\": [[1, 1], [3.5, 1]]"));
        kind->close(live);
    }
}

TEST(backspace_takes_back_letters_and_then_points) {
    void *live = open_live(NULL);
    editor_set_tool(kind->editor(live), TOOL_WALL);
    click(live, 0, 0);
    click(live, 3, 0);
    click(live, 3, 2);
    keys(live, "4°<<<|");
    CHECK(!strstr(editor_text(kind->editor(live)), "[[0, 0], [3, 0], [3, 2]]") ||
          !editor_gesture(kind->editor(live))->active);
    editor_undo(kind->editor(live));
    click(live, 0, 0);
    click(live, 3, 0);
    click(live, 3, 2);
    keys(live, "<");
    click(live, 5, 0);
    keys(live, "~");
    CHECK(strstr(editor_text(kind->editor(live)), "[[0, 0], [3, 0], [5, 0]]"));
    kind->close(live);
}

TEST(a_door_stops_at_the_end_of_its_wall_and_says_why) {
    void *live = open_text(small_house);
    click(live, 2, 0);
    press(live, 2, 0);
    move_to(live, 3, 0);
    move_to(live, 3.9, 0);
    CHECK(editor_gesture(kind->editor(live))->refusal &&
          strstr(editor_gesture(kind->editor(live))->refusal, "past the end of wall w1"));
    release(live, 3.9, 0);
    CHECK(strstr(editor_text(kind->editor(live)), "\"at\": 3.55, \"width\": 0.9"));
    Fault fault = {0};
    CHECK(!kind->set(live, "door.d1.width", 9, &fault));
    CHECK(fault.count && strstr(fault.lines[0], "must be at most 4 m in wall w1"));
    CHECK(strstr(editor_text(kind->editor(live)), "\"at\": 3.55, \"width\": 0.9"));
    fault_clear(&fault);
    click(live, 3.55, 0); /* its handle is grabbed */
    keys(live, ">9|");
    CHECK(editor_gesture(kind->editor(live))->active && editor_gesture(kind->editor(live))->refusal);
    keys(live, "<1.2|");
    CHECK(editor_gesture(kind->editor(live))->active); /* it would extend past the end */
    keys(live, ">2|");
    CHECK(!editor_gesture(kind->editor(live))->active);
    CHECK(strstr(editor_text(kind->editor(live)), "\"at\": 2, \"width\": 1.2"));
    kind->close(live);
}

static bool set(void *live, const char *name, double value) {
    Fault fault = {0};
    bool good = kind->set(live, name, value, &fault);
    CHECK(good == !fault.count);
    fault_clear(&fault);
    return good;
}

TEST(a_slider_that_is_refused_is_put_down_where_it_stood_last) {
    void *live = open_text(small_house);
    char *before = keep_text(live);
    kind->begin_number(live, "door.d1.width");
    CHECK(set(live, "door.d1.width", 1.1) && set(live, "door.d1.width", 1.2) && !set(live, "door.d1.width", 9));
    kind->end_number(live);
    CHECK(strstr(editor_text(kind->editor(live)), "\"at\": 2, \"width\": 1.2"));
    CHECK(set(live, "door.d1.width", 1.1) && editor_undo(kind->editor(live)) && editor_undo(kind->editor(live)) &&
          !editor_undo(kind->editor(live)));
    CHECK_TEXT(editor_text(kind->editor(live)), before);
    kind->begin_number(live, "door.d1.width");
    CHECK(!set(live, "door.d1.width", 9));
    kind->end_number(live);
    undo_all(live, before);
}

TEST(keys_while_a_slider_is_held_put_it_down_first) {
    void *live = open_text(small_house);
    char *before = keep_text(live);
    Fault fault = {0};
    click(live, 2, 0);
    kind->begin_number(live, "door.d1.width");
    CHECK(set(live, "door.d1.width", 1.2) && editor_undo(kind->editor(live)));
    CHECK_TEXT(editor_text(kind->editor(live)), before);
    CHECK(set(live, "door.d1.width", 1.1)); /* a separate step */
    kind->end_number(live);
    CHECK(editor_undo(kind->editor(live)));
    CHECK_TEXT(editor_text(kind->editor(live)), before);
    click(live, 5.5, 3);
    kind->begin_number(live, "door.d1.width");
    CHECK(set(live, "door.d1.width", 1.2) && editor_split(kind->editor(live), &fault));
    kind->end_number(live);
    CHECK(editor_undo(kind->editor(live)) && editor_undo(kind->editor(live)) && !editor_undo(kind->editor(live)));
    undo_all(live, before);
}

TEST(a_number_that_is_typed_while_a_handle_is_held_stays) {
    void *live = open_text(small_house);
    char *before = keep_text(live);
    click(live, 2, 0);
    click(live, 2, 0); /* its middle is grabbed */
    CHECK(editor_gesture(kind->editor(live))->active && set(live, "door.d1.width", 1.2));
    move_to(live, 2.5, 0);
    click(live, 2.5, 0);
    CHECK(strstr(editor_text(kind->editor(live)), "\"at\": 2.5, \"width\": 1.2"));
    undo_all(live, before);
}

TEST(what_is_removed_under_the_button_is_not_moved) {
    void *live = open_text(small_house);
    char *before = keep_text(live);
    Fault fault = {0};
    click(live, 2, 0);
    press(live, 2.45, 0);
    CHECK(editor_remove(kind->editor(live), &fault));
    move_to(live, 2.6, 0);
    release(live, 2.7, 0);
    CHECK(!strstr(editor_text(kind->editor(live)), "d1"));
    undo_all(live, before);
}

TEST(an_id_may_be_as_long_as_it_likes) {
    Text text = {0};
    char id[151];
    memset(id, 'd', sizeof id - 1);
    id[sizeof id - 1] = 0;
    const char *at = strstr(small_house, "\"d1\"");
    text_format(&text, "%.*s\"%s\"%s", (int)(at - small_house), small_house, id, at + 4);
    void *live = open_text(text.text);
    char *before = keep_text(live);
    click(live, 2, 0);
    drag(live, 2, 0, 2.5, 0);
    CHECK(strstr(editor_text(kind->editor(live)), "\"at\": 2.5"));
    memory_free(text.text);
    text = (Text){0};
    text_format(&text, "door.%s.width", id);
    CHECK(set(live, text.text, 1.2) && strstr(editor_text(kind->editor(live)), "\"at\": 2.5, \"width\": 1.2"));
    memory_free(text.text);
    undo_all(live, before);
}

TEST(what_overlaps_is_refused) {
    void *live = open_text(small_house);
    editor_set_tool(kind->editor(live), TOOL_DOOR);
    keys(live, "|2.2>0|");
    const GestureView *gesture = editor_gesture(kind->editor(live));
    CHECK(gesture->active && gesture->refusal && strstr(gesture->refusal, "overlaps door d1"));
    keys(live, "~");
    editor_set_tool(kind->editor(live), TOOL_PERSON);
    keys(live, "|1>2.6|");
    gesture = editor_gesture(kind->editor(live));
    CHECK(gesture->active && gesture->refusal && strstr(gesture->refusal, "stands inside wardrobe (f1)"));
    keys(live, "~");
    CHECK(!editor_undo_name(kind->editor(live)));
    editor_set_tool(kind->editor(live), TOOL_WALL);
    keys(live, "|1>1|");
    keys(live, "|");
    CHECK(!editor_undo_name(kind->editor(live)));
    kind->close(live);
}

/* What is done to the selection ------------------------------------------------------------------------------------ */

static bool succeeds(bool good, Fault *fault) {
    check_say(fault);
    return good;
}

TEST(what_is_selected_is_nudged_turned_toppled_copied_and_removed_by_steps_with_names) {
    void *live = open_text(small_house);
    char *before = keep_text(live);
    Fault fault = {0};
    click(live, 1, 2.6);
    CHECK(succeeds(editor_nudge(kind->editor(live), vec2(0.01, -0.1), &fault), &fault));
    CHECK_TEXT(editor_undo_name(kind->editor(live)), "Nudge");
    CHECK(strstr(editor_text(kind->editor(live)), "\"centre\": [1.01, 2.5]"));
    CHECK(succeeds(editor_turn(kind->editor(live), 15, &fault), &fault));
    CHECK_TEXT(editor_undo_name(kind->editor(live)), "Turn wardrobe (f1)");
    for (int i = 0; i < 5; i++)
        CHECK(succeeds(editor_turn(kind->editor(live), 15, &fault), &fault));
    CHECK(strstr(editor_text(kind->editor(live)), "\"angle\": 90"));
    CHECK(succeeds(editor_topple(kind->editor(live), &fault), &fault));
    CHECK_TEXT(editor_undo_name(kind->editor(live)), "Topple wardrobe (f1)");
    CHECK(strstr(editor_text(kind->editor(live)), "\"toppled\": true"));
    CHECK(succeeds(editor_topple(kind->editor(live), &fault), &fault));
    CHECK_TEXT(editor_undo_name(kind->editor(live)), "Stand up wardrobe (f1)");
    CHECK(succeeds(editor_duplicate(kind->editor(live), &fault), &fault));
    CHECK(strstr(editor_text(kind->editor(live)), "\"id\": \"f2\""));
    char *pieces = editor_copy(kind->editor(live));
    CHECK(pieces && strstr(pieces, "clearance-pieces"));
    move_to(live, 3, 2);
    CHECK(succeeds(editor_paste(kind->editor(live), pieces, &fault), &fault));
    CHECK(strstr(editor_text(kind->editor(live)), "\"id\": \"f3\", \"name\": \"wardrobe\", \"centre\": [3, 2]"));
    memory_free(pieces);
    CHECK(succeeds(editor_remove(kind->editor(live), &fault), &fault));
    CHECK_TEXT(editor_undo_name(kind->editor(live)), "Remove wardrobe (f3)");
    CHECK(!editor_remove(kind->editor(live), &fault) && fault.count);
    fault_clear(&fault);
    undo_all(live, before);
}

TEST(what_is_pasted_without_a_pointer_lies_beside_what_it_was_copied_from) {
    void *live = open_text(small_house);
    Fault fault = {0};
    Pointer nowhere = {.at = {4, 3}, .reach = REACH, .nowhere = true};
    click(live, 1, 2.5);
    char *pieces = editor_copy(kind->editor(live));
    editor_point(kind->editor(live), &nowhere);
    CHECK(succeeds(editor_paste(kind->editor(live), pieces, &fault), &fault));
    CHECK(strstr(editor_text(kind->editor(live)), "\"id\": \"f2\", \"name\": \"wardrobe\", \"centre\": [1.3, 2.3]"));
    CHECK(succeeds(editor_paste(kind->editor(live), pieces, &fault), &fault));
    CHECK(strstr(editor_text(kind->editor(live)), "\"id\": \"f3\", \"name\": \"wardrobe\", \"centre\": [1.6, 2]"));
    CHECK(!editor_paste(kind->editor(live), "{\"format\": \"clearance-pieces\",\n \"walls\": [", &fault));
    CHECK(fault.count == 1 && strstr(fault.lines[0], "the pasted text is broken at its line 2"));
    fault_clear(&fault);
    CHECK(
        !editor_paste(kind->editor(live), "{\"format\": \"clearance-pieces\", \"walls\": [{\"id\": \"w9\"}]}", &fault));
    CHECK(fault.count && strstr(fault.lines[0], "what is pasted cannot be put here: "));
    fault_clear(&fault);
    memory_free(pieces);
    kind->close(live);
}

TEST(a_handle_with_the_focus_of_the_keys_is_nudged_and_typed) {
    void *live = open_text(small_house);
    Fault fault = {0};
    click(live, 5.5, 3);
    editor_focus_handle(kind->editor(live), 1);
    editor_focus_handle(kind->editor(live), 1);
    CHECK(succeeds(editor_nudge(kind->editor(live), vec2(0.1, 0.5), &fault), &fault));
    CHECK(strstr(editor_text(kind->editor(live)), "\"points\": [[4, 3], [7.1, 3.5]]"));
    CHECK(editor_enter(kind->editor(live)));
    keys(live, "2.5>0|");
    CHECK(strstr(editor_text(kind->editor(live)), "\"points\": [[4, 3], [6.5, 3]]"));
    editor_focus_handle(kind->editor(live), 0);
    CHECK(!editor_enter(kind->editor(live)));
    kind->close(live);
}

TEST(a_wall_is_split_and_a_point_taken_out_and_doors_stay_where_they_are) {
    void *live = open_text(small_house);
    char *before = keep_text(live);
    Fault fault = {0};
    click(live, 3.5, 0);
    CHECK(!editor_split(kind->editor(live), &fault) && strstr(fault.lines[0], "door d1 lies in the middle"));
    fault_clear(&fault);
    CHECK(kind->set(live, "door.d1.at", 3, &fault));
    CHECK(succeeds(editor_split(kind->editor(live), &fault), &fault));
    CHECK(strstr(editor_text(kind->editor(live)), "[[0, 0], [2, 0], [4, 0], [4, 3], [0, 3], [0, 0]]"));
    CHECK(strstr(editor_text(kind->editor(live)), "\"segment\": 1, \"at\": 1, \"width\": 0.9"));
    editor_focus_handle(kind->editor(live), 1);
    editor_focus_handle(kind->editor(live), 1);
    CHECK(succeeds(editor_remove(kind->editor(live), &fault), &fault));
    CHECK(strstr(editor_text(kind->editor(live)), "[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]"));
    CHECK(strstr(editor_text(kind->editor(live)), "\"at\": 3, \"width\": 0.9"));
    undo_all(live, before);
}

TEST(a_rectangle_on_empty_floor_selects_what_lies_within) {
    void *live = open_text(small_house);
    size_t count;
    drag(live, 0.7, 2.0, 3.5, 2.93);
    editor_selection(kind->editor(live), &count);
    CHECK_NEAR((double)count, 0, 0); /* not wholly */
    drag(live, 0.2, 1.0, 3.5, 2.93);
    editor_selection(kind->editor(live), &count);
    CHECK_NEAR((double)count, 2, 0);
    drag(live, 1.0, 2.5, 1.2, 2.3); /* on the wardrobe: both move */
    CHECK_TEXT(editor_undo_name(kind->editor(live)), "Move 2 things");
    CHECK(strstr(editor_text(kind->editor(live)), "\"centre\": [1.2, 2.4]") &&
          strstr(editor_text(kind->editor(live)), "\"at\": [3.2, 1.3]"));
    editor_select_all(kind->editor(live));
    editor_selection(kind->editor(live), &count);
    CHECK_NEAR((double)count, 6, 0);
    kind->close(live);
}

TEST(texts_are_changed_and_things_renamed_everywhere) {
    void *live = open_text(small_house);
    Fault fault = {0};
    size_t count;
    click(live, 3, 1.5);
    const EditText *texts = editor_texts(kind->editor(live), &count);
    CHECK(count == 3 && strcmp(texts[0].name, "person.p1.id") == 0);
    CHECK(succeeds(editor_set_text(kind->editor(live), "person.p1.id", "anna", &fault), &fault));
    CHECK(strstr(editor_text(kind->editor(live)), "\"people\": [\"anna\"]"));
    CHECK(!editor_set_text(kind->editor(live), "person.anna.id", "w1", &fault));
    CHECK(!editor_set_text(kind->editor(live), "person.anna.id", "no spaces", &fault));
    CHECK(!editor_set_text(kind->editor(live), "person.nobody.id", "x", &fault));
    CHECK_NEAR((double)fault.count, 3, 0);
    fault_clear(&fault);
    CHECK(succeeds(editor_set_text(kind->editor(live), "house.name", "Ube \"1\"", &fault), &fault));
    CHECK_TEXT(kind->title(live), "Ube \"1\"");
    CHECK(succeeds(editor_set_text(kind->editor(live), "furniture.f1.name", "tall one", &fault), &fault));
    CHECK_TEXT(editor_undo_name(kind->editor(live)), "Name wardrobe (f1)");
    kind->close(live);
}

TEST(a_route_goes_by_the_points_that_are_clicked_to_the_exit) {
    void *live = open_text(small_house);
    click(live, 3, 1.5);
    editor_set_tool(kind->editor(live), TOOL_ROUTE);
    click(live, 3, 0.5);
    click(live, 2, 0.5);
    click(live, 2.01, -1);
    CHECK(!editor_gesture(kind->editor(live))->active);
    CHECK(strstr(editor_text(kind->editor(live)),
                 "\"people\": [\"p1\"], \"via\": [[3, 0.5], [2, 0.5]], \"exit\": \"e1\""));
    kind->close(live);
}

TEST(what_is_measured_stays_until_it_is_deleted) {
    void *live = open_text(small_house);
    Fault fault = {0};
    editor_set_tool(kind->editor(live), TOOL_MEASURE);
    click(live, 1, 1);
    click(live, 1, 1.78);
    const GestureView *gesture = editor_gesture(kind->editor(live));
    CHECK(!gesture->active && gesture->mark_count && strcmp(gesture->marks[0].text, "0.78 m") == 0);
    CHECK(!editor_undo_name(kind->editor(live)));
    CHECK(succeeds(editor_remove(kind->editor(live), &fault), &fault));
    kind->close(live);
}

/* Shakes, proposals, pictures ---------------------------------------------------------------------------------------
 */

TEST(a_shake_topples_what_its_seed_draws_and_is_one_step) {
    void *live = open_text(small_house);
    char *before = keep_text(live);
    Fault fault = {0};
    int toppled = 0;
    for (int i = 0; i < 20; i++) {
        char words[64];
        CHECK(succeeds(editor_shake(kind->editor(live), &fault), &fault));
        bool falls = strstr(editor_text(kind->editor(live)), "\"toppled\": true");
        snprintf(words, sizeof words, "hake %d: %s of 1 piece fell", i + 1, falls ? "1" : "none");
        CHECK_TEXT(editor_shake_result(kind->editor(live)) + 1, words);
        toppled += falls;
        if (!falls) {
            CHECK(!editor_undo_name(kind->editor(live))); /* nothing has changed */
            continue;
        }
        CHECK_TEXT(editor_undo_name(kind->editor(live)) + 1, words);
        CHECK(editor_undo(kind->editor(live)));
        CHECK_TEXT(editor_text(kind->editor(live)), before);
    }
    CHECK(toppled > 2 && toppled < 18);
    memory_free(before);
    kind->close(live);
}

static const char narrow_house[] =
    "{\"format\": \"clearance-house\", \"version\": 1, \"walls\": [{\"id\": \"w1\", \"points\": [[0, 0], [4, 0], [4, "
    "3], [0, 3], [0, 0]]}], \"doors\": [{\"id\": \"d1\", \"wall\": \"w1\", \"at\": 2, \"width\": 0.5}], \"exits\": "
    "[{\"id\": \"e1\", \"from\": [1.5, -1], \"to\": [2.5, -1]}], \"people\": [{\"id\": \"p1\", \"profile\": "
    "\"manual-chair\", \"at\": [2, 2], \"heading\": -90}]}";

TEST(a_change_that_lets_everybody_out_is_proposed_and_taken) {
    void *live = open_text(narrow_house);
    Fault fault = {0};
    size_t count = 0;
    const char *doing = "";
    editor_ask_proposals(kind->editor(live));
    const Proposal *proposals = editor_proposals(kind->editor(live), &count, &doing);
    for (int i = 0; i < 20000 && doing && !count; i++) {
        nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL);
        proposals = editor_proposals(kind->editor(live), &count, &doing);
    }
    CHECK(count > 0 && !doing);
    CHECK(count && strstr(proposals[0].text, "Widen door d1") && strstr(proposals[0].answer, "everybody out in"));
    CHECK(succeeds(editor_accept(kind->editor(live), 0, &fault), &fault));
    CHECK(!strstr(editor_text(kind->editor(live)), "\"width\": 0.5"));
    CHECK(strstr(editor_undo_name(kind->editor(live)), "Widen door d1"));
    editor_proposals(kind->editor(live), &count, &doing);
    CHECK(count == 0 && !doing); /* they belonged to another house */
    CHECK(!editor_accept(kind->editor(live), 0, &fault) && fault.count == 1);
    fault_clear(&fault);
    editor_ask_proposals(kind->editor(live));
    editor_ask_proposals(kind->editor(live));
    kind->close(live); /* while two people are on their way */
}

/* The first bytes of a picture of 200 by 100 pixels. */
static void write_picture(char path[64]) {
    static const unsigned char bytes[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0,   0, 0, 13, 'I', 'H', 'D',
                                          'R',  0,   0,   0,   200,  0,    0,    0,    100, 8, 2, 0,  0,   0};
    strcpy(path, "/tmp/clearance-picture-XXXXXX");
    FILE *stream = fdopen(mkstemp(path), "w");
    fwrite(bytes, sizeof bytes, 1, stream);
    fclose(stream);
}

TEST(a_picture_to_trace_over_gets_its_scale_and_is_made_level) {
    void *live = open_live(NULL);
    Fault fault = {0};
    char path[64];
    write_picture(path);
    CHECK(!editor_set_image(kind->editor(live), "/nowhere/at-all.png", &fault) && fault.count == 1);
    CHECK(!editor_set_image(kind->editor(live), check_source(), &fault) && fault.count == 2);
    fault_clear(&fault);
    CHECK(succeeds(editor_set_image(kind->editor(live), path, &fault), &fault));
    TraceImage image = editor_image(kind->editor(live));
    CHECK_TEXT(image.path, path);
    CHECK_NEAR(image.corners[2].x, 10, 1e-12);
    CHECK_NEAR(image.corners[2].y, 5, 1e-12);
    editor_set_tool(kind->editor(live), TOOL_IMAGE);
    click(live, 1, 1);
    click(live, 3, 1);
    keys(live, "4|");
    image = editor_image(kind->editor(live));
    CHECK_NEAR(image.corners[0].x, -1, 1e-12);
    CHECK_NEAR(image.corners[1].x, 19, 1e-12);
    click(live, 0, 0);
    click(live, 1, 0.1);
    image = editor_image(kind->editor(live));
    CHECK_NEAR(degrees(atan2(image.corners[1].y - image.corners[0].y, image.corners[1].x - image.corners[0].x)),
               -degrees(atan(0.1)), 1e-9);
    CHECK_TEXT(editor_undo_name(kind->editor(live)), "Level picture");
    editor_fade_image(kind->editor(live), 0.25);
    CHECK_NEAR(editor_image(kind->editor(live)).opacity, 0.25, 0);
    char *text = keep_text(live);
    void *again = open_text(text);
    CHECK_TEXT(editor_text(kind->editor(again)), text);
    CHECK_TEXT(kind->note(again), "");
    kind->close(again);
    unlink(path);
    again = open_text(text);
    CHECK_TEXT(kind->note(again), "the picture to trace over is not there");
    CHECK(!editor_image(kind->editor(again)).path);
    kind->close(again);
    CHECK(succeeds(editor_set_image(kind->editor(live), NULL, &fault), &fault));
    CHECK(!editor_image(kind->editor(live)).path);
    memory_free(text);
    kind->close(live);
}

/* Any sequence at all ---------------------------------------------------------------------------------------------- */

static uint64_t state;

static double any(double low, double high) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(state >> 11) / 9007199254740992.0;
}

static Pointer any_hand(void) {
    return (Pointer){.at = {any(-1, 8), any(-2, 4)},
                     .reach = any(0.01, 0.3),
                     .free = any(0, 1) < 0.1,
                     .straight = any(0, 1) < 0.1,
                     .more = any(0, 1) < 0.1};
}

static void act_at_random(void *live) {
    static const char *const letters[] = {"1", "2", ".", "-", "5", "c", "m", "0", "x", " "};
    Fault fault = {0};
    Pointer at = any_hand();
    size_t count;
    switch ((int)any(0, 29)) {
    case 0:
        editor_set_tool(kind->editor(live), (EditTool)any(0, EDIT_TOOLS));
        break;
    case 1 ... 5:
        editor_point(kind->editor(live), &at);
        break;
    case 6 ... 8:
        editor_press(kind->editor(live), &at, any(0, 1) < 0.2);
        break;
    case 9 ... 11:
        editor_release(kind->editor(live), &at);
        break;
    case 12 ... 13:
        editor_type(kind->editor(live), letters[(int)any(0, 10)]);
        break;
    case 14:
        editor_enter(kind->editor(live));
        break;
    case 15:
        editor_tab(kind->editor(live), any(0, 1) < 0.5 ? 1 : -1);
        break;
    case 16:
        editor_back(kind->editor(live));
        break;
    case 17:
        if (any(0, 1) < 0.3)
            editor_escape(kind->editor(live));
        editor_focus_handle(kind->editor(live), (int)any(-2, 3));
        break;
    case 18:
        editor_nudge(kind->editor(live), vec2(any(-0.2, 0.2), any(-0.2, 0.2)), &fault);
        break;
    case 19:
        editor_turn(kind->editor(live), any(-90, 90), &fault);
        editor_topple(kind->editor(live), &fault);
        break;
    case 20:
        if (any(0, 1) < 0.3)
            editor_remove(kind->editor(live), &fault);
        else
            editor_split(kind->editor(live), &fault);
        break;
    case 21:
        if (any(0, 1) < 0.2)
            editor_duplicate(kind->editor(live), &fault);
        break;
    case 22:
        editor_undo(kind->editor(live));
        break;
    case 23:
        editor_redo(kind->editor(live));
        break;
    case 24:
        editor_items(kind->editor(live), &count);
        if (count)
            editor_choose_item(kind->editor(live), (size_t)any(0, (double)count));
        if (any(0, 1) < 0.02)
            editor_select_all(kind->editor(live));
        break;
    case 25:
        editor_gesture(kind->editor(live));
        editor_selection(kind->editor(live), &count);
        editor_texts(kind->editor(live), &count);
        break;
    case 26:
        kind->begin_number(live, "door.d1.width");
        break;
    case 27:
        kind->set(live, any(0, 1) < 0.5 ? "door.d1.width" : "furniture.f1.height", any(0.3, 3), &fault);
        break;
    case 28:
        kind->end_number(live);
        if (any(0, 1) < 0.1)
            kind->reset(live);
        break;
    }
    fault_clear(&fault);
}

static void check_reads(void *live) {
    Plan plan = {0};
    Fault fault = {0};
    CHECK(plan_read_text(&plan, "edited", editor_text(kind->editor(live)), NULL, 0, &fault));
    for (size_t i = 0; i < fault.count; i++)
        printf("%s\n", fault.lines[i]);
    plan_free(&plan);
    fault_clear(&fault);
}

TEST(any_calls_keep_the_plan_good_and_are_undone_to_the_first_bytes) {
    const char *seed = getenv("CLEARANCE_EDIT_SEED"), *calls = getenv("CLEARANCE_EDIT_CALLS");
    state = seed ? strtoull(seed, NULL, 10) : 7;
    void *live = open_text(small_house);
    char *before = keep_text(live);
    for (int i = 0, most = calls ? atoi(calls) : 10000; i < most; i++) {
        act_at_random(live);
        if (i % 100 == 0)
            check_reads(live);
    }
    editor_set_tool(kind->editor(live), TOOL_SELECT);
    while (editor_escape(kind->editor(live)))
        ;
    check_reads(live);
    while (editor_redo(kind->editor(live)))
        ;
    char *after = keep_text(live);
    while (editor_undo(kind->editor(live)))
        ;
    CHECK_TEXT(editor_text(kind->editor(live)), before);
    while (editor_redo(kind->editor(live)))
        ;
    CHECK_TEXT(editor_text(kind->editor(live)), after);
    memory_free(before);
    memory_free(after);
    kind->close(live);
}
