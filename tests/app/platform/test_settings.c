#include "platform/settings.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/text.h"
#include "check.h"
#include "desk.h"
#include "scratch.h"

static void open_quietly(Settings *settings) {
    Fault notes = {0};
    settings_open(settings, &notes);
    CHECK(notes.count == 0);
    fault_clear(&notes);
}

static void save_quietly(Settings *settings) {
    Fault notes = {0};
    settings_save(settings, &notes);
    CHECK(notes.count == 0);
    fault_clear(&notes);
}

TEST(at_first_all_is_as_the_program_has_it_and_nothing_is_written) {
    desk_make();
    Settings settings;
    open_quietly(&settings);
    CHECK(!settings.preferences.sound && settings.preferences.single_keys && !settings.preferences.reduced_motion);
    CHECK(settings.preferences.text == 1 && settings.preferences.width == 0 && settings.preferences.height == 0);
    CHECK(settings_laboratory(&settings, "house")->layers == -1);
    CHECK_NEAR(settings_laboratory(&settings, "beam")->speed, 1, 0);
    CHECK_TEXT(settings.state.folder, "");
    save_quietly(&settings);
    CHECK(access(desk_path("config"), F_OK) != 0 && access(desk_path("state"), F_OK) != 0);
    settings_close(&settings);
    desk_remove();
}

TEST(what_is_set_is_there_the_next_time) {
    desk_make();
    desk_write("houses/a b.json", "{}");
    desk_write("houses/b.json", "{}");
    Settings settings;
    open_quietly(&settings);
    settings.preferences.theme = 1;
    settings.preferences.text = 3;
    settings.preferences.single_keys = false;
    settings.preferences.width = 1920;
    settings.preferences.height = 720;
    settings.state.folder = settings_store(&settings, "/some where");
    settings_laboratory(&settings, "beam")->speed = 0.25;
    settings_laboratory(&settings, "beam")->plots = "phase,section";
    settings_add_recent(&settings, "houses/b.json");
    settings_add_recent(&settings, "houses/a b.json");
    settings_add_recent(&settings, "nowhere.json");
    save_quietly(&settings);
    settings_close(&settings);
    open_quietly(&settings);
    CHECK(settings.preferences.theme == 1 && settings.preferences.text == 3 && !settings.preferences.single_keys);
    CHECK(settings.preferences.width == 1920 && settings.preferences.height == 720);
    CHECK_TEXT(settings.state.folder, "/some where");
    CHECK_TEXT(settings_laboratory(&settings, "beam")->plots, "phase,section");
    CHECK_NEAR(settings_laboratory(&settings, "beam")->speed, 0.25, 0);
    const char *recent[SETTINGS_RECENT_MOST];
    CHECK(settings_recent(&settings, recent) == 2);
    CHECK_TEXT(recent[0], desk_path("houses/a b.json"));
    CHECK_TEXT(recent[1], desk_path("houses/b.json"));
    unlink(recent[0]);
    CHECK(settings_recent(&settings, recent) == 1);
    settings_close(&settings);
    desk_remove();
}

TEST(recent_files_are_ten_and_each_is_there_once) {
    desk_make();
    Settings settings;
    open_quietly(&settings);
    char name[] = "0.json";
    for (int i = 0; i < 24; i++) {
        name[0] = (char)('a' + i % 12);
        desk_write(name, "");
        settings_add_recent(&settings, name);
    }
    settings_add_recent(&settings, "e.json");
    settings_add_recent(&settings, "./e.json");
    const char *recent[SETTINGS_RECENT_MOST];
    CHECK(settings_recent(&settings, recent) == SETTINGS_RECENT_MOST);
    CHECK_TEXT(recent[0], desk_path("e.json"));
    CHECK_TEXT(recent[1], desk_path("l.json"));
    CHECK_TEXT(recent[9], desk_path("c.json"));
    settings_close(&settings);
    desk_remove();
}

static void check_bad(const char *name, const char *text) {
    desk_make();
    desk_write(name, text);
    Settings settings;
    Fault notes = {0};
    settings_open(&settings, &notes);
    CHECK(notes.count == 1);
    CHECK(notes.count && strstr(notes.lines[0], desk_path(name)) && strstr(notes.lines[0], "is kept as "));
    CHECK(settings.preferences.text == 1 && settings.recent_count == 0);
    CHECK_TEXT(settings.state.folder, "");
    char bad[100];
    strcat(strcpy(bad, name), ".bad");
    char *kept = scratch_read(desk_path(bad));
    CHECK_TEXT(kept, text);
    memory_free(kept);
    settings.preferences.text = 2;
    settings.state.folder = "/";
    save_quietly(&settings);
    CHECK(access(desk_path(name), F_OK) == 0);
    settings_close(&settings);
    fault_clear(&notes);
    open_quietly(&settings);
    CHECK(settings.preferences.text == 2);
    settings_close(&settings);
    desk_remove();
}

TEST(text_below_its_own_size_and_in_quarters_is_remembered) {
    static const double sizes[] = {0.75, 1, 1.25, 2};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        Settings settings;
        desk_make();
        open_quietly(&settings);
        settings.preferences.text = sizes[i];
        save_quietly(&settings);
        settings_close(&settings);
        open_quietly(&settings);
        CHECK(settings.preferences.text == sizes[i]);
        settings_close(&settings);
        desk_remove();
    }
}

TEST(a_broken_file_is_kept_beside_and_all_is_as_at_first) {
    check_bad("config/clearance/settings.json", "{\"text\": 3, ");
    check_bad("config/clearance/settings.json", "{\"text\": 4}");
    check_bad("config/clearance/settings.json", "{\"text\": 3, \"colour\": \"red\"}");
    check_bad("config/clearance/settings.json", "[]");
    check_bad("config/clearance/settings.json", "");
    check_bad("state/clearance/state.json", "{\"folder\": \"/x\", \"recent\": [\"/a\", 7]}");
    check_bad("state/clearance/state.json", "{\"folder\": \"/x\", \"recent\": [\"/a\"], \"beam\": {\"speed\": 0}}");
    check_bad("state/clearance/state.json", "{\"recent\": \"all\"}");
}

TEST(without_a_place_it_works_and_says_so_once) {
    desk_make();
    unsetenv("XDG_CONFIG_HOME");
    unsetenv("XDG_STATE_HOME");
    setenv("XDG_CACHE_HOME", "relative", 1);
    unsetenv("HOME");
    Settings settings;
    Fault notes = {0};
    open_quietly(&settings);
    settings.preferences.text = 2;
    settings_save(&settings, &notes);
    settings_save(&settings, &notes);
    CHECK(notes.count == 1);
    CHECK_TEXT(notes.count ? notes.lines[0] : "", "settings cannot be saved: HOME is not set");
    CHECK(settings_cache_folder() == NULL);
    settings_close(&settings);
    fault_clear(&notes);
    setenv("HOME", "/proc", 1);
    open_quietly(&settings);
    settings.preferences.text = 2;
    settings_add_recent(&settings, "/proc/self/status");
    settings_save(&settings, &notes);
    settings_save(&settings, &notes);
    CHECK(notes.count == 1 && strstr(notes.lines[0], "/proc/.config/clearance/settings.json"));
    CHECK(settings.preferences.text == 2);
    settings_close(&settings);
    fault_clear(&notes);
    desk_remove();
}

TEST(the_home_is_used_where_no_variable_says_otherwise) {
    desk_make();
    unsetenv("XDG_CONFIG_HOME");
    setenv("XDG_STATE_HOME", "not/absolute", 1);
    unsetenv("XDG_CACHE_HOME");
    Settings settings;
    open_quietly(&settings);
    CHECK_TEXT(settings.preferences_path, desk_path(".config/clearance/settings.json"));
    CHECK_TEXT(settings.state_path, desk_path(".local/state/clearance/state.json"));
    char *cache = settings_cache_folder();
    CHECK_TEXT(cache, desk_path(".cache/clearance"));
    memory_free(cache);
    settings_close(&settings);
    desk_remove();
}
