/* Tests actions on the selection, its texts, earthquakes and proposals: each is one step with a name. */

#include <stdio.h>
#include <string.h>
#include <time.h>

#include "base/text.h"
#include "check.h"
#include "editing.h"

static const Laboratory *const laboratory = &house_laboratory;

TEST(what_is_selected_is_nudged_turned_toppled_copied_and_removed_by_steps_with_names) {
    void *session = editing_open_text(editing_small_house);
    char *before = editing_text(session);
    Fault fault = {0};
    editing_click(session, 1, 2.6);
    CHECK(editing_succeeds(editor_nudge(laboratory->editor(session), vec2(0.01, -0.1), &fault), &fault));
    CHECK_TEXT(editor_undo_name(laboratory->editor(session)), "Nudge wardrobe");
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"centre\": [1.01, 2.5]"));
    CHECK(editing_succeeds(editor_turn(laboratory->editor(session), 15, &fault), &fault));
    CHECK_TEXT(editor_undo_name(laboratory->editor(session)), "Turn wardrobe");
    for (int i = 0; i < 5; i++)
        CHECK(editing_succeeds(editor_turn(laboratory->editor(session), 15, &fault), &fault));
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"angle\": 90"));
    CHECK(editing_succeeds(editor_topple(laboratory->editor(session), &fault), &fault));
    CHECK_TEXT(editor_undo_name(laboratory->editor(session)), "Topple wardrobe");
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"toppled\": true"));
    CHECK(editing_succeeds(editor_topple(laboratory->editor(session), &fault), &fault));
    CHECK_TEXT(editor_undo_name(laboratory->editor(session)), "Stand up wardrobe");
    CHECK(editing_succeeds(editor_duplicate(laboratory->editor(session), &fault), &fault));
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"id\": \"f2\""));
    char *pieces = editor_copy(laboratory->editor(session));
    CHECK(pieces && strstr(pieces, "clearance-pieces"));
    editing_move(session, 3, 2);
    CHECK(editing_succeeds(editor_paste(laboratory->editor(session), pieces, &fault), &fault));
    CHECK(
        strstr(editor_text(laboratory->editor(session)), "\"id\": \"f3\", \"name\": \"wardrobe\", \"centre\": [3, 2]"));
    memory_free(pieces);
    CHECK(editing_succeeds(editor_remove(laboratory->editor(session), &fault), &fault));
    CHECK_TEXT(editor_undo_name(laboratory->editor(session)), "Remove wardrobe");
    CHECK(!editor_remove(laboratory->editor(session), &fault) && fault.count);
    fault_clear(&fault);
    editing_undo_all(session, before);
}

TEST(what_is_pasted_without_a_pointer_lies_beside_what_it_was_copied_from) {
    void *session = editing_open_text(editing_small_house);
    Fault fault = {0};
    Pointer nowhere = {.at = {4, 3}, .reach = EDITING_REACH, .nowhere = true};
    editing_click(session, 1, 2.5);
    char *pieces = editor_copy(laboratory->editor(session));
    editor_point(laboratory->editor(session), &nowhere);
    CHECK(editing_succeeds(editor_paste(laboratory->editor(session), pieces, &fault), &fault));
    CHECK(strstr(editor_text(laboratory->editor(session)),
                 "\"id\": \"f2\", \"name\": \"wardrobe\", \"centre\": [1.3, 2.3]"));
    CHECK(editing_succeeds(editor_paste(laboratory->editor(session), pieces, &fault), &fault));
    CHECK(strstr(editor_text(laboratory->editor(session)),
                 "\"id\": \"f3\", \"name\": \"wardrobe\", \"centre\": [1.6, 2]"));
    CHECK(!editor_paste(laboratory->editor(session), "{\"format\": \"clearance-pieces\",\n \"walls\": [", &fault));
    CHECK(fault.count == 1 && strstr(fault.lines[0], "the pasted text is broken at its line 2"));
    fault_clear(&fault);
    CHECK(!editor_paste(laboratory->editor(session),
                        "{\"format\": \"clearance-pieces\", \"walls\": [{\"id\": \"w9\"}]}", &fault));
    CHECK(fault.count && strstr(fault.lines[0], "the pasted items cannot be placed here: "));
    fault_clear(&fault);
    memory_free(pieces);
    laboratory->close(session);
}

TEST(a_wall_is_split_and_a_point_taken_out_and_doors_stay_where_they_are) {
    void *session = editing_open_text(editing_small_house);
    char *before = editing_text(session);
    Fault fault = {0};
    editing_click(session, 3.5, 0);
    CHECK(!editor_split(laboratory->editor(session), &fault) && strstr(fault.lines[0], "door lies in the middle"));
    fault_clear(&fault);
    CHECK(laboratory->set(session, "door.d1.at", 3, &fault));
    CHECK(editing_succeeds(editor_split(laboratory->editor(session), &fault), &fault));
    CHECK(strstr(editor_text(laboratory->editor(session)), "[[0, 0], [2, 0], [4, 0], [4, 3], [0, 3], [0, 0]]"));
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"segment\": 1, \"at\": 1, \"width\": 0.9"));
    editor_focus_handle(laboratory->editor(session), 1);
    editor_focus_handle(laboratory->editor(session), 1);
    CHECK(editing_succeeds(editor_remove(laboratory->editor(session), &fault), &fault));
    CHECK(strstr(editor_text(laboratory->editor(session)), "[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]"));
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"at\": 3, \"width\": 0.9"));
    editing_undo_all(session, before);
}

TEST(a_rectangle_on_empty_floor_selects_what_lies_within) {
    void *session = editing_open_text(editing_small_house);
    size_t count;
    editing_drag(session, 0.7, 2.0, 3.5, 2.93);
    editor_selection(laboratory->editor(session), &count);
    CHECK_NEAR((double)count, 0, 0); /* not wholly */
    editing_drag(session, 0.2, 1.0, 3.5, 2.93);
    editor_selection(laboratory->editor(session), &count);
    CHECK_NEAR((double)count, 2, 0);
    editing_drag(session, 1.0, 2.5, 1.2, 2.3); /* on the wardrobe: both move */
    CHECK_TEXT(editor_undo_name(laboratory->editor(session)), "Move 2 items");
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"centre\": [1.2, 2.4]") &&
          strstr(editor_text(laboratory->editor(session)), "\"at\": [3.2, 1.3]"));
    editor_select_all(laboratory->editor(session));
    editor_selection(laboratory->editor(session), &count);
    CHECK_NEAR((double)count, 6, 0);
    laboratory->close(session);
}

TEST(texts_are_changed_and_things_renamed_everywhere) {
    void *session = editing_open_text(editing_small_house);
    Fault fault = {0};
    size_t count;
    editing_click(session, 3, 1.5);
    const EditText *texts = editor_texts(laboratory->editor(session), &count);
    CHECK(count == 3 && strcmp(texts[0].name, "person.p1.id") == 0);
    CHECK(editing_succeeds(editor_set_text(laboratory->editor(session), "person.p1.id", "anna", &fault), &fault));
    CHECK(strstr(editor_text(laboratory->editor(session)), "\"people\": [\"anna\"]"));
    CHECK(!editor_set_text(laboratory->editor(session), "person.anna.id", "w1", &fault));
    CHECK(!editor_set_text(laboratory->editor(session), "person.anna.id", "no spaces", &fault));
    CHECK(!editor_set_text(laboratory->editor(session), "person.nobody.id", "x", &fault));
    CHECK_NEAR((double)fault.count, 3, 0);
    fault_clear(&fault);
    CHECK(editing_succeeds(editor_set_text(laboratory->editor(session), "house.name", "Ube \"1\"", &fault), &fault));
    CHECK_TEXT(laboratory->title(session), "Ube \"1\"");
    CHECK(editing_succeeds(editor_set_text(laboratory->editor(session), "furniture.f1.name", "tall one", &fault),
                           &fault));
    CHECK_TEXT(editor_undo_name(laboratory->editor(session)), "Name wardrobe");
    laboratory->close(session);
}

/* Returns the text of the selection with this name; NULL: there is none. */
static const char *text_called(void *session, const char *name) {
    size_t count;
    const EditText *texts = editor_texts(laboratory->editor(session), &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(texts[i].name, name) == 0)
            return texts[i].value;
    return NULL;
}

/* Sets a text that must be refused. */
static void check_refused(void *session, const char *name, const char *value) {
    Fault fault = {0};
    char *before = editing_text(session);
    CHECK(!editor_set_text(laboratory->editor(session), name, value, &fault) && fault.count == 1);
    char *after = editing_text(session);
    CHECK_TEXT(after, before);
    memory_free(before);
    memory_free(after);
    fault_clear(&fault);
}

TEST(corners_ends_and_closing_times_are_typed_and_each_is_one_step) {
    void *session = editing_open_text(editing_small_house);
    Editor *editor = laboratory->editor(session);
    char *before = editing_text(session);
    Fault fault = {0};
    editing_click(session, 0, 0.5);
    CHECK_TEXT(text_called(session, "wall.w1.corners"), "0 0; 4 0; 4 3; 0 3; 0 0");
    CHECK(
        editing_succeeds(editor_set_text(editor, "wall.w1.corners", "0 0; 450cm 0; 4,5 3; 0 3; 0 0;", &fault), &fault));
    CHECK(strstr(editor_text(editor), "\"points\": [[0, 0], [4.5, 0], [4.5, 3], [0, 3], [0, 0]]"));
    CHECK(strstr(editor_undo_name(editor), "Change the corners of ") == editor_undo_name(editor));
    check_refused(session, "wall.w1.corners", "0 0");
    check_refused(session, "wall.w1.corners", "0 0; 4; 4 3");
    check_refused(session, "wall.w1.corners", "0 0; 4 0 3; 4 3");
    check_refused(session, "wall.w1.corners", "0 0; 4 kg; 4 3");
    check_refused(session, "wall.w1.corners", "");
    CHECK(editing_succeeds(editor_set_text(editor, "room.r1.corners", "0 0; 4 0; 4 3", &fault), &fault));
    CHECK(strstr(editor_text(editor), "\"outline\": [[0, 0], [4, 0], [4, 3]]"));
    CHECK_TEXT(editor_undo_name(editor), "Change the corners of hall");
    check_refused(session, "exit.e1.ends", "4.8 1");
    CHECK(editing_succeeds(editor_set_text(editor, "exit.e1.ends", "5.2 1; 5.2 2", &fault), &fault));
    CHECK(strstr(editor_text(editor), "\"from\": [5.2, 1], \"to\": [5.2, 2]"));
    CHECK(editing_succeeds(editor_set_text(editor, "exit.e1.closes", "1.5 min", &fault), &fault));
    CHECK(strstr(editor_text(editor), "\"closes\": 90"));
    check_refused(session, "exit.e1.closes", "soon");
    CHECK(editing_succeeds(editor_set_text(editor, "exit.e1.closes", "never", &fault), &fault));
    CHECK(!strstr(editor_text(editor), "closes"));
    editing_undo_all(session, before);
}

/* Earthquakes and proposals ---------------------------------------------------------------------------------------- */

TEST(a_shake_topples_what_its_seed_draws_and_is_one_step) {
    void *session = editing_open_text(editing_small_house);
    char *before = editing_text(session);
    Fault fault = {0};
    int toppled = 0;
    for (int i = 0; i < 20; i++) {
        char words[64];
        CHECK(editing_succeeds(editor_shake(laboratory->editor(session), &fault), &fault));
        bool falls = strstr(editor_text(laboratory->editor(session)), "\"toppled\": true");
        snprintf(words, sizeof words, "Shake %d: fallen pieces: %d of 1", i + 1, falls);
        CHECK_TEXT(editor_shake_result(laboratory->editor(session)), words);
        toppled += falls;
        if (!falls) {
            CHECK(!editor_undo_name(laboratory->editor(session))); /* nothing has changed */
            continue;
        }
        CHECK_TEXT(editor_undo_name(laboratory->editor(session)), words);
        CHECK(editor_undo(laboratory->editor(session)));
        CHECK_TEXT(editor_text(laboratory->editor(session)), before);
    }
    CHECK(toppled > 2 && toppled < 18);
    memory_free(before);
    laboratory->close(session);
}

/* Shakes until the wardrobe falls. */
static void topple_by_shakes(Editor *editor) {
    Fault fault = {0};
    for (int i = 0; i < 20 && !strstr(editor_text(editor), "\"toppled\": true"); i++)
        CHECK(editing_succeeds(editor_shake(editor, &fault), &fault));
}

TEST(what_is_fixed_to_the_wall_stands_in_the_same_shake) {
    void *session = editing_open_text(editing_small_house);
    Editor *editor = laboratory->editor(session);
    EditorShake before, after;
    Fault fault = {0};
    CHECK(!editor_last_shake(editor, &before));
    topple_by_shakes(editor);
    CHECK(editor_last_shake(editor, &before) && before.count == 1);
    CHECK_TEXT(before.ids[0], "f1");
    CHECK(!editor_fix_to_wall(editor, (Item){HOUSE_WALL, 0}, &fault) && fault.count == 1);
    fault_clear(&fault);
    CHECK(editing_succeeds(editor_fix_to_wall(editor, (Item){HOUSE_FURNITURE, 0}, &fault), &fault));
    CHECK_TEXT(editor_undo_name(editor), "Fix wardrobe to the wall");
    CHECK(!strstr(editor_text(editor), "\"topples\": \"front\"") && !strstr(editor_text(editor), "\"toppled\": true"));
    CHECK(editor_last_shake(editor, &after) && after.count == 0 && after.seed == before.seed);
    CHECK(after.standing != before.standing); /* a hundred shakes of it are others */
    CHECK(editor_undo(editor) && editor_last_shake(editor, &after));
    CHECK(after.count == 1 && after.seed == before.seed && after.standing == before.standing);
    laboratory->close(session);
}

TEST(what_fell_stands_up_as_one_step) {
    void *session = editing_open_text(editing_small_house);
    Editor *editor = laboratory->editor(session);
    EditorShake shake;
    Fault fault = {0};
    CHECK(!editor_stand_up(editor, &fault) && fault.count == 1);
    fault_clear(&fault);
    topple_by_shakes(editor);
    CHECK(editing_succeeds(editor_stand_up(editor, &fault), &fault));
    CHECK_TEXT(editor_undo_name(editor), "Stand up what fell");
    CHECK(!editor_last_shake(editor, &shake) && !strstr(editor_text(editor), "\"toppled\": true"));
    CHECK(editor_undo(editor) && editor_last_shake(editor, &shake) && shake.count == 1);
    laboratory->close(session);
}

static const char narrow_house[] =
    "{\"format\": \"clearance-house\", \"version\": 1, \"walls\": [{\"id\": \"w1\", \"points\": [[0, 0], [4, 0], [4, "
    "3], [0, 3], [0, 0]]}], \"doors\": [{\"id\": \"d1\", \"wall\": \"w1\", \"at\": 2, \"width\": 0.5}], \"exits\": "
    "[{\"id\": \"e1\", \"from\": [1.5, -1], \"to\": [2.5, -1]}], \"people\": [{\"id\": \"p1\", \"profile\": "
    "\"manual-chair\", \"at\": [2, 2], \"heading\": -90}]}";

TEST(a_change_that_lets_everybody_out_is_proposed_and_taken) {
    void *session = editing_open_text(narrow_house);
    Fault fault = {0};
    size_t count = 0;
    const char *doing = "";
    editor_ask_proposals(laboratory->editor(session));
    const Proposal *proposals = editor_proposals(laboratory->editor(session), &count, &doing);
    while (doing && !count) {
        nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL);
        proposals = editor_proposals(laboratory->editor(session), &count, &doing);
    }
    CHECK(count > 0 && !doing);
    CHECK(count && strstr(proposals[0].text, "Widen door d1") && strstr(proposals[0].answer, "all people are out in"));
    CHECK(editing_succeeds(editor_accept(laboratory->editor(session), 0, &fault), &fault));
    CHECK(!strstr(editor_text(laboratory->editor(session)), "\"width\": 0.5"));
    CHECK(strstr(editor_undo_name(laboratory->editor(session)), "Widen door d1"));
    editor_proposals(laboratory->editor(session), &count, &doing);
    CHECK(count == 0 && !doing); /* they belonged to another house */
    CHECK(!editor_accept(laboratory->editor(session), 0, &fault) && fault.count == 1);
    fault_clear(&fault);
    editor_ask_proposals(laboratory->editor(session));
    editor_ask_proposals(laboratory->editor(session));
    laboratory->close(session); /* while two people are on their way */
}
