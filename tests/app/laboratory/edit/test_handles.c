/* Tests the handles of the selected item: dragging, clicking and typing do the same, and Escape restores the plan. */

#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "check.h"
#include "editing.h"

static const Laboratory *const laboratory = &house_laboratory;

typedef struct Handle {
    const char *what;   /* clicked to select it */
    Vec2 at, from, to;  /* m: place of selection, its handle, and the handle's destination */
    const char *member; /* part of the resulting text */
} Handle;

static const Handle handles[] = {
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
        const Handle *held = &handles[i];
        void *dragged = editing_open_text(editing_small_house), *clicked = editing_open_text(editing_small_house);
        char *before = editing_text(dragged);
        editing_click(dragged, held->at.x, held->at.y);
        editing_drag(dragged, held->from.x, held->from.y, held->to.x, held->to.y);
        editing_click(clicked, held->at.x, held->at.y);
        editing_click(clicked, held->from.x, held->from.y);
        CHECK(editor_gesture(laboratory->editor(clicked))->active);
        editing_move(clicked, held->to.x, held->to.y);
        editing_click(clicked, held->to.x, held->to.y);
        CHECK(!editor_gesture(laboratory->editor(clicked))->active);
        CHECK_TEXT(editor_text(laboratory->editor(clicked)), editor_text(laboratory->editor(dragged)));
        if (!strstr(editor_text(laboratory->editor(dragged)), held->member)) {
            CHECK_TEXT(held->what, "as expected");
            printf("%s\n%s",
                   editor_undo_name(laboratory->editor(dragged)) ? editor_undo_name(laboratory->editor(dragged))
                                                                 : "nothing done",
                   editor_text(laboratory->editor(dragged)));
        }
        CHECK(editor_undo(laboratory->editor(dragged)) && !editor_undo(laboratory->editor(dragged)));
        CHECK_TEXT(editor_text(laboratory->editor(dragged)), before);
        memory_free(before);
        laboratory->close(dragged);
        laboratory->close(clicked);
    }
}

TEST(escape_leaves_exactly_what_was_before) {
    void *session = editing_open_text(editing_small_house);
    char *before = editing_text(session);
    for (size_t i = 0; i < sizeof handles / sizeof *handles; i++) {
        const Handle *held = &handles[i];
        laboratory->select(session, (Item){0, 0});
        editing_click(session, held->at.x, held->at.y);
        editing_press(session, held->from.x, held->from.y);
        editing_move(session, held->to.x, held->to.y);
        CHECK(editor_gesture(laboratory->editor(session))->active);
        CHECK(strcmp(editor_text(laboratory->editor(session)), before) != 0);
        CHECK(editor_escape(laboratory->editor(session)));
        editing_release(session, held->to.x, held->to.y);
        CHECK_TEXT(editor_text(laboratory->editor(session)), before);
        CHECK(!editor_undo_name(laboratory->editor(session)));
    }
    memory_free(before);
    laboratory->close(session);
}

TEST(a_door_stops_at_the_end_of_its_wall_and_says_why) {
    void *session = editing_open_text(editing_small_house);
    editing_click(session, 2, 0);
    editing_press(session, 2, 0);
    editing_move(session, 3, 0);
    editing_move(session, 3.9, 0);
    CHECK(editor_gesture(laboratory->editor(session))->refusal &&
          strstr(editor_gesture(laboratory->editor(session))->refusal, "past the end of the wall"));
    editing_release(session, 3.9, 0);
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"at\": 3.55, \"width\": 0.9"));
    Fault fault = {0};
    CHECK(!laboratory->set(session, "door.d1.width", 9, &fault));
    CHECK(fault.count && strstr(fault.lines[0], "must be at most 4 m in the wall"));
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"at\": 3.55, \"width\": 0.9"));
    fault_clear(&fault);
    editing_click(session, 3.55, 0); /* its handle is grabbed */
    editing_keys(session, ">9|");
    CHECK(editor_gesture(laboratory->editor(session))->active && editor_gesture(laboratory->editor(session))->refusal);
    editing_keys(session, "<1.2|");
    CHECK(editor_gesture(laboratory->editor(session))->active); /* it would extend past the end */
    editing_keys(session, ">2|");
    CHECK(!editor_gesture(laboratory->editor(session))->active);
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"at\": 2, \"width\": 1.2"));
    laboratory->close(session);
}

TEST(what_is_removed_under_the_button_is_not_moved) {
    void *session = editing_open_text(editing_small_house);
    char *before = editing_text(session);
    Fault fault = {0};
    editing_click(session, 2, 0);
    editing_press(session, 2.45, 0);
    CHECK(editor_remove(laboratory->editor(session), &fault));
    editing_move(session, 2.6, 0);
    editing_release(session, 2.7, 0);
    CHECK(!strstr(editor_text(laboratory->editor(session)), "d1"));
    editing_undo_all(session, before);
}

TEST(an_id_may_be_as_long_as_it_likes) {
    Text text = {0};
    char id[151];
    memset(id, 'd', sizeof id - 1);
    id[sizeof id - 1] = 0;
    const char *at = strstr(editing_small_house, "\"d1\"");
    text_format(&text, "%.*s\"%s\"%s", (int)(at - editing_small_house), editing_small_house, id, at + 4);
    void *session = editing_open_text(text.text);
    char *before = editing_text(session);
    editing_click(session, 2, 0);
    editing_drag(session, 2, 0, 2.5, 0);
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"at\": 2.5"));
    memory_free(text.text);
    text = (Text){0};
    text_format(&text, "door.%s.width", id);
    CHECK(editing_set(session, text.text, 1.2) &&
          strstr(editor_text(laboratory->editor(session)), "\"at\": 2.5, \"width\": 1.2"));
    memory_free(text.text);
    editing_undo_all(session, before);
}

TEST(a_handle_with_the_focus_of_the_keys_is_nudged_and_typed) {
    void *session = editing_open_text(editing_small_house);
    Fault fault = {0};
    editing_click(session, 5.5, 3);
    editor_focus_handle(laboratory->editor(session), 1);
    editor_focus_handle(laboratory->editor(session), 1);
    CHECK(editing_succeeds(editor_nudge(laboratory->editor(session), vec2(0.1, 0.5), &fault), &fault));
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"points\": [[4, 3], [7.1, 3.5]]"));
    CHECK(editor_enter(laboratory->editor(session)));
    editing_keys(session, "2.5>0|");
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"points\": [[4, 3], [6.5, 3]]"));
    editor_focus_handle(laboratory->editor(session), 0);
    CHECK(!editor_enter(laboratory->editor(session)));
    laboratory->close(session);
}
