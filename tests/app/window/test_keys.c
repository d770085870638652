/* Tests the table of keys: each shortcut is unique in each context and has its texts. */

#include "window/keys.h"

#include "check.h"
#include "platform/sdl_window.h"

TEST(every_key_of_the_table_is_a_key) {
    for (size_t i = 0; i < keys_count(); i++) {
        int32_t key;
        int mods;
        keys_read(keys_at(i).key, &key, &mods);
        CHECK_TEXT(key ? "" : keys_at(i).key, "");
    }
}

TEST(a_key_finds_its_own_row) {
    for (size_t i = 0; i < keys_count(); i++) {
        int32_t key;
        int mods;
        keys_read(keys_at(i).key, &key, &mods);
        KeyPlace place = keys_at(i).place == KEY_CANVAS ? KEY_VIEW : keys_at(i).place;
        CHECK(keys_find(key, mods, place, true) == keys_at(i).action);
    }
}

TEST(a_key_of_the_plan_means_something_else_where_nothing_is_edited) {
    CHECK(keys_find('x', 0, KEY_PLAN, true) == ACTION_TOOL_EXIT);
    CHECK(keys_find('x', 0, KEY_VIEW, true) == ACTION_CLEAR);
    CHECK(keys_find('x', 0, KEY_PLOT, true) == ACTION_CLEAR);
    CHECK(keys_find('k', 0, KEY_PLAN, true) == ACTION_KEEP);
    CHECK(keys_find('z', 0, KEY_PLAN, true) == ACTION_ZOOM_SELECTION);
    CHECK(!keys_find('w', 0, KEY_VIEW, true));
}

TEST(every_action_has_a_name_and_a_sentence) {
    for (Action action = ACTION_NONE + 1; action < ACTIONS; action++) {
        KeyRow row = keys_row(action);
        CHECK(row.name && row.help && *row.help);
    }
}

TEST(single_letters_can_be_switched_off) {
    CHECK(keys_find('r', 0, KEY_VIEW, true) == ACTION_AGAIN);
    CHECK(!keys_find('r', 0, KEY_VIEW, false));
    CHECK(keys_find(sdl_window_key("Space"), 0, KEY_VIEW, false) == ACTION_PLAY);
    CHECK(!keys_find('r', 0, KEY_ANYWHERE, true));
}

TEST(three_keys_at_once_only_where_everybody_knows_them) {
    for (size_t i = 0; i < keys_count(); i++) {
        int32_t key;
        int mods;
        keys_read(keys_at(i).key, &key, &mods);
        int held =
            !!(mods & SDL_WINDOW_EVENT_SHIFT) + !!(mods & SDL_WINDOW_EVENT_CONTROL) + !!(mods & SDL_WINDOW_EVENT_ALT);
        Action action = keys_at(i).action;
        CHECK(held < 2 || action == ACTION_LARGER || action == ACTION_REDO || action == ACTION_SAVE_COPY ||
              action == ACTION_HISTORY);
    }
}
