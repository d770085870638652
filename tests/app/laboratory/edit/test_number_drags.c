/* Tests numbers that are dragged in the panel: a drag is one step, and other edits end it first. */

#include <string.h>

#include "base/text.h"
#include "check.h"
#include "editing.h"

static const Laboratory *const laboratory = &house_laboratory;

TEST(a_slider_that_is_refused_is_put_down_where_it_stood_last) {
    void *session = editing_open_text(editing_small_house);
    char *before = editing_text(session);
    laboratory->begin_number(session, "door.d1.width");
    CHECK(editing_set(session, "door.d1.width", 1.1) && editing_set(session, "door.d1.width", 1.2) &&
          !editing_set(session, "door.d1.width", 9));
    laboratory->end_number(session);
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"at\": 2, \"width\": 1.2"));
    CHECK(editing_set(session, "door.d1.width", 1.1) && editor_undo(laboratory->editor(session)) &&
          editor_undo(laboratory->editor(session)) && !editor_undo(laboratory->editor(session)));
    CHECK_TEXT(editor_text(laboratory->editor(session)), before);
    laboratory->begin_number(session, "door.d1.width");
    CHECK(!editing_set(session, "door.d1.width", 9));
    laboratory->end_number(session);
    editing_undo_all(session, before);
}

TEST(keys_while_a_slider_is_held_put_it_down_first) {
    void *session = editing_open_text(editing_small_house);
    char *before = editing_text(session);
    Fault fault = {0};
    editing_click(session, 2, 0);
    laboratory->begin_number(session, "door.d1.width");
    CHECK(editing_set(session, "door.d1.width", 1.2) && editor_undo(laboratory->editor(session)));
    CHECK_TEXT(editor_text(laboratory->editor(session)), before);
    CHECK(editing_set(session, "door.d1.width", 1.1)); /* a separate step */
    laboratory->end_number(session);
    CHECK(editor_undo(laboratory->editor(session)));
    CHECK_TEXT(editor_text(laboratory->editor(session)), before);
    editing_click(session, 5.5, 3);
    laboratory->begin_number(session, "door.d1.width");
    CHECK(editing_set(session, "door.d1.width", 1.2) && editor_split(laboratory->editor(session), &fault));
    laboratory->end_number(session);
    CHECK(editor_undo(laboratory->editor(session)) && editor_undo(laboratory->editor(session)) &&
          !editor_undo(laboratory->editor(session)));
    editing_undo_all(session, before);
}

TEST(a_number_that_is_typed_while_a_handle_is_held_stays) {
    void *session = editing_open_text(editing_small_house);
    char *before = editing_text(session);
    editing_click(session, 2, 0);
    editing_click(session, 2, 0); /* its middle is grabbed */
    CHECK(editor_gesture(laboratory->editor(session))->active && editing_set(session, "door.d1.width", 1.2));
    editing_move(session, 2.5, 0);
    editing_click(session, 2.5, 0);
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"at\": 2.5, \"width\": 1.2"));
    editing_undo_all(session, before);
}
