/* Tests drawing of houses: drawing and typing give equal plans, points snap to what their labels name, and each drawing
 * is undone to the same bytes. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "check.h"
#include "editing.h"
#include "running_house.h"

static const Laboratory *const laboratory = &house_laboratory;

static void choose(void *session, const char *group, const char *name) {
    size_t count;
    const CatalogueRow *items = editor_items(laboratory->editor(session), &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(items[i].name, name) == 0 && strcmp(items[i].group, group) == 0) {
            editor_choose_item(laboratory->editor(session), i);
            return;
        }
    CHECK_TEXT(name, "an item");
}

/* A flat of 8 m by 6 m with four rooms: walls that cross in the middle, doors, a person and a wardrobe. */
static void draw_by_hand(void *session) {
    editor_set_tool(laboratory->editor(session), TOOL_WALL);
    editing_click(session, 0.003, 0.004);
    editing_click(session, 8.004, 0.02);
    editing_click(session, 8.02, 6.004);
    editing_click(session, 0.01, 5.99);
    editing_click(session, 0.01, 0.01);
    editing_click(session, 4.004, 0.01);
    editing_click(session, 4.01, 6.01);
    editing_click(session, 4.01, 6.01);
    editing_drag(session, 0.01, 3.004, 8.01, 3.01);
    editor_escape(laboratory->editor(session));
    editor_set_tool(laboratory->editor(session), TOOL_DOOR);
    editing_click(session, 4.02, 1.5);
    editing_click(session, 4.02, 4.503);
    editing_click(session, 2.0, 3.02);
    editing_click(session, 8.02, 1.5);
    editor_set_tool(laboratory->editor(session), TOOL_EXIT);
    editing_click(session, 8.02, 1.5);
    editor_set_tool(laboratory->editor(session), TOOL_PERSON);
    choose(session, "", "wheelchair");
    editing_click(session, 2.0, 4.5);
    editor_set_tool(laboratory->editor(session), TOOL_FURNITURE);
    choose(session, "European", "wardrobe");
    editing_click(session, 1.0, 5.5);
}

static void type_all(void *session) {
    editor_set_tool(laboratory->editor(session), TOOL_WALL);
    editing_keys(session, "|0>0|8>0|6>90|800cm>180|2400mm+3.6m>-90|");
    editing_keys(session, "|4>0|6>90|~");
    editing_keys(session, "|0>3|8|~");
    editor_set_tool(laboratory->editor(session), TOOL_DOOR);
    editing_keys(session, "|4>1.5|");
    editing_keys(session, "|4>4.5|");
    editing_keys(session, "|2>3|");
    editing_keys(session, "|8>1.5|");
    editor_set_tool(laboratory->editor(session), TOOL_EXIT);
    editing_keys(session, "|8>1.5|");
    editor_set_tool(laboratory->editor(session), TOOL_PERSON);
    choose(session, "", "wheelchair");
    editing_keys(session, "|2>4.5|");
    editor_set_tool(laboratory->editor(session), TOOL_FURNITURE);
    choose(session, "European", "wardrobe");
    editing_keys(session, "|1>5,64|");
}

TEST(a_flat_drawn_by_hand_and_one_that_is_typed_are_the_same) {
    void *by_hand = editing_open(NULL), *typed = editing_open(NULL);
    draw_by_hand(by_hand);
    type_all(typed);
    CHECK_TEXT(editor_text(laboratory->editor(typed)), editor_text(laboratory->editor(by_hand)));
    laboratory->close(by_hand);
    laboratory->close(typed);
}

static bool has_before(void *session) {
    size_t count, words = 0;
    const PanelChoice *choices = laboratory->choices(session, &count);
    for (size_t i = 0; i < count; i++)
        for (size_t w = 0; w < choices[i].count; w++)
            words += strcmp(choices[i].options[w], "before") == 0;
    return words > 0;
}

TEST(a_plan_without_exit_is_not_kept_as_before_and_nobody_who_is_undone) {
    void *session = editing_open(NULL);
    editor_set_tool(laboratory->editor(session), TOOL_WALL);
    editing_keys(session, "|0>0|8>0|6>90|800cm>180|6>-90|~");
    editor_set_tool(laboratory->editor(session), TOOL_DOOR);
    editing_click(session, 8.02, 3.5);
    editor_set_tool(laboratory->editor(session), TOOL_PERSON);
    choose(session, "", "wheelchair");
    editing_click(session, 2.0, 4.5);
    running_house_finish(session, 0);
    editor_set_tool(laboratory->editor(session), TOOL_EXIT);
    editing_click(session, 8.02, 3.5);
    running_house_finish(session, 0);
    CHECK(!has_before(session));
    editor_set_tool(laboratory->editor(session), TOOL_FURNITURE);
    choose(session, "European", "wardrobe");
    editing_click(session, 1.0, 1.0);
    running_house_finish(session, 0);
    CHECK(has_before(session));
    editor_set_tool(laboratory->editor(session), TOOL_PERSON);
    choose(session, "", "wheelchair");
    editing_click(session, 2.0, 2.5);
    running_house_finish(session, 0);
    CHECK(!has_before(session));
    CHECK(editor_undo(laboratory->editor(session)));
    running_house_finish(session, 0);
    CHECK(!has_before(session));
    laboratory->close(session);
}

TEST(a_flat_is_undone_to_the_empty_plan_and_redone_to_the_same_bytes) {
    void *session = editing_open(NULL);
    char *empty = editing_text(session);
    draw_by_hand(session);
    char *drawn = editing_text(session);
    size_t steps = editor_edit_count(laboratory->editor(session)), undone = 0, redone = 0;
    while (editor_undo(laboratory->editor(session)))
        undone++;
    CHECK_NEAR((double)undone, (double)steps, 0);
    CHECK_TEXT(editor_text(laboratory->editor(session)), empty);
    CHECK(!editor_undo_name(laboratory->editor(session)));
    while (editor_redo(laboratory->editor(session)))
        redone++;
    CHECK_NEAR((double)redone, (double)steps, 0);
    CHECK_TEXT(editor_text(laboratory->editor(session)), drawn);
    memory_free(empty);
    memory_free(drawn);
    laboratory->close(session);
}

/* Snapping, typing and refusals ------------------------------------------------------------------------------------ */

/* Returns the name of the snap target, "" if there is none. */
static const char *snapped(void *session) {
    const GestureView *gesture = editor_gesture(laboratory->editor(session));
    for (size_t i = 0; i < gesture->mark_count; i++)
        if (gesture->marks[i].kind == MARK_SNAP)
            return gesture->marks[i].text;
    return "";
}

TEST(what_is_snapped_to_has_a_name) {
    void *session = editing_open_text(editing_small_house);
    editor_set_tool(laboratory->editor(session), TOOL_WALL);
    editing_move(session, 6.97, 3.02);
    CHECK_TEXT(snapped(session), "end of wall");
    editing_move(session, 2.0, 0.03);
    CHECK_TEXT(snapped(session), "on lower wall of hall");
    editing_move(session, 4.02, 5.0);
    CHECK_TEXT(snapped(session), "in line with wall");
    editing_move(session, 5.5, 5.5);
    CHECK_TEXT(snapped(session), "");
    Pointer free = editing_pointer(6.97, 3.02);
    free.free = true;
    editor_point(laboratory->editor(session), &free);
    CHECK_TEXT(snapped(session), "");
    editing_click(session, 5.0, 5.0);
    editing_move(session, 5.02, 6.5);
    CHECK_TEXT(snapped(session), "90 degrees");
    Pointer straight = editing_pointer(6.8, 5.6);
    straight.straight = true;
    editor_point(laboratory->editor(session), &straight);
    CHECK_TEXT(snapped(session), "straight across");
    editor_press(laboratory->editor(session), &straight, false);
    editor_release(laboratory->editor(session), &straight);
    editor_escape(laboratory->editor(session));
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"points\": [[5, 5], [6.8, 5]]"));
    laboratory->close(session);
}

TEST(a_length_is_typed_in_any_way_that_people_write_it) {
    static const char *const lengths[] = {"2.5", "2,5", "250cm", "2500 mm", "1.2+1.3", "8ft 2.4251968504in"};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        void *session = editing_open(NULL);
        editor_set_tool(laboratory->editor(session), TOOL_WALL);
        editing_click(session, 1, 1);
        editing_move(session, 3.1, 1.02);
        editing_keys(session, lengths[i]);
        editing_keys(session, "|~");
        CHECK(strstr(editor_text(laboratory->editor(session)), "\"points\": [[1, 1], [3.5, 1]]"));
        laboratory->close(session);
    }
}

TEST(backspace_takes_back_letters_and_then_points) {
    void *session = editing_open(NULL);
    editor_set_tool(laboratory->editor(session), TOOL_WALL);
    editing_click(session, 0, 0);
    editing_click(session, 3, 0);
    editing_click(session, 3, 2);
    editing_keys(session, "4°<<<|");
    CHECK(!strstr(editor_text(laboratory->editor(session)), "[[0, 0], [3, 0], [3, 2]]") ||
          !editor_gesture(laboratory->editor(session))->active);
    editor_undo(laboratory->editor(session));
    editing_click(session, 0, 0);
    editing_click(session, 3, 0);
    editing_click(session, 3, 2);
    editing_keys(session, "<");
    editing_click(session, 5, 0);
    editing_keys(session, "~");
    CHECK(strstr(editor_text(laboratory->editor(session)), "[[0, 0], [3, 0], [5, 0]]"));
    laboratory->close(session);
}

TEST(what_overlaps_is_refused) {
    void *session = editing_open_text(editing_small_house);
    editor_set_tool(laboratory->editor(session), TOOL_DOOR);
    editing_keys(session, "|2.2>0|");
    const GestureView *gesture = editor_gesture(laboratory->editor(session));
    CHECK(gesture->active && gesture->refusal && strstr(gesture->refusal, "overlaps the "));
    editing_keys(session, "~");
    editor_set_tool(laboratory->editor(session), TOOL_PERSON);
    editing_keys(session, "|1>2.6|");
    gesture = editor_gesture(laboratory->editor(session));
    CHECK(gesture->active && gesture->refusal && strstr(gesture->refusal, "stands inside wardrobe,"));
    editing_keys(session, "~");
    CHECK(!editor_undo_name(laboratory->editor(session)));
    editor_set_tool(laboratory->editor(session), TOOL_WALL);
    editing_keys(session, "|1>1|");
    editing_keys(session, "|");
    CHECK(!editor_undo_name(laboratory->editor(session)));
    laboratory->close(session);
}

/* Routes, distances, pictures -------------------------------------------------------------------------------------- */

TEST(a_route_goes_by_the_points_that_are_clicked_to_the_exit) {
    void *session = editing_open_text(editing_small_house);
    editing_click(session, 3, 1.5);
    editor_set_tool(laboratory->editor(session), TOOL_ROUTE);
    editing_click(session, 3, 0.5);
    editing_click(session, 2, 0.5);
    editing_click(session, 2.01, -1);
    CHECK(!editor_gesture(laboratory->editor(session))->active);
    CHECK(strstr(editor_text(laboratory->editor(session)),
                 "\"people\": [\"p1\"], \"via\": [[3, 0.5], [2, 0.5]], \"exit\": \"e1\""));
    laboratory->close(session);
}

TEST(what_is_measured_stays_until_it_is_deleted) {
    void *session = editing_open_text(editing_small_house);
    Fault fault = {0};
    editor_set_tool(laboratory->editor(session), TOOL_MEASURE);
    editing_click(session, 1, 1);
    editing_click(session, 1, 1.78);
    const GestureView *gesture = editor_gesture(laboratory->editor(session));
    CHECK(!gesture->active && gesture->mark_count && strcmp(gesture->marks[0].text, "0.78 m") == 0);
    CHECK(!editor_undo_name(laboratory->editor(session)));
    CHECK(editing_succeeds(editor_remove(laboratory->editor(session), &fault), &fault));
    laboratory->close(session);
}

/* The first bytes of a picture of 200 by 100 pixels. */
static void write_picture(char path[CHECK_PATH]) {
    static const unsigned char bytes[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0,   0, 0, 13, 'I', 'H', 'D',
                                          'R',  0,   0,   0,   200,  0,    0,    0,    100, 8, 2, 0,  0,   0};
    check_temporary(path, "picture-XXXXXX");
    FILE *stream = fdopen(mkstemp(path), "w");
    fwrite(bytes, sizeof bytes, 1, stream);
    fclose(stream);
}

TEST(a_picture_to_trace_over_gets_its_scale_and_is_made_level) {
    void *session = editing_open(NULL);
    Fault fault = {0};
    char path[CHECK_PATH];
    write_picture(path);
    CHECK(!editor_set_image(laboratory->editor(session), "/nowhere/at-all.png", &fault) && fault.count == 1);
    CHECK(!editor_set_image(laboratory->editor(session), check_source(), &fault) && fault.count == 2);
    fault_clear(&fault);
    CHECK(editing_succeeds(editor_set_image(laboratory->editor(session), path, &fault), &fault));
    TraceImage image = editor_image(laboratory->editor(session));
    CHECK_TEXT(image.path, path);
    CHECK_NEAR(image.corners[2].x, 10, 1e-12);
    CHECK_NEAR(image.corners[2].y, 5, 1e-12);
    editor_set_tool(laboratory->editor(session), TOOL_IMAGE);
    editing_click(session, 1, 1);
    editing_click(session, 3, 1);
    editing_keys(session, "4|");
    image = editor_image(laboratory->editor(session));
    CHECK_NEAR(image.corners[0].x, -1, 1e-12);
    CHECK_NEAR(image.corners[1].x, 19, 1e-12);
    editing_click(session, 0, 0);
    editing_click(session, 1, 0.1);
    image = editor_image(laboratory->editor(session));
    CHECK_NEAR(degrees(atan2(image.corners[1].y - image.corners[0].y, image.corners[1].x - image.corners[0].x)),
               -degrees(atan(0.1)), 1e-9);
    CHECK_TEXT(editor_undo_name(laboratory->editor(session)), "Level picture");
    editor_fade_image(laboratory->editor(session), 0.25);
    CHECK_NEAR(editor_image(laboratory->editor(session)).opacity, 0.25, 0);
    char *text = editing_text(session);
    void *again = editing_open_text(text);
    CHECK_TEXT(editor_text(laboratory->editor(again)), text);
    CHECK_TEXT(laboratory->note(again), "");
    laboratory->close(again);
    unlink(path);
    again = editing_open_text(text);
    CHECK_TEXT(laboratory->note(again), "the picture to trace over was not found");
    CHECK(!editor_image(laboratory->editor(again)).path);
    laboratory->close(again);
    CHECK(editing_succeeds(editor_set_image(laboratory->editor(session), NULL, &fault), &fault));
    CHECK(!editor_image(laboratory->editor(session)).path);
    memory_free(text);
    laboratory->close(session);
}
