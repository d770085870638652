/* The first byte of the input says which file of the settings the rest is. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "fuzz.h"
#include "platform/settings.h"

static void write_file(const char *folder, const char *file, const uint8_t *data, size_t size) {
    char name[128], path[FUZZ_PATH];
    snprintf(path, sizeof path, "%s/%s", fuzz_folder(), folder);
    mkdir(path, 0700);
    snprintf(path, sizeof path, "%s/%s/clearance", fuzz_folder(), folder);
    mkdir(path, 0700);
    snprintf(name, sizeof name, "%s/clearance/%s", folder, file);
    fuzz_write(path, name, data, size);
}

static void begin(void) {
    char path[FUZZ_PATH];
    snprintf(path, sizeof path, "%s/config", fuzz_folder());
    setenv("XDG_CONFIG_HOME", path, 1);
    snprintf(path, sizeof path, "%s/state", fuzz_folder());
    setenv("XDG_STATE_HOME", path, 1);
}

static void check_values(const Settings *settings) {
    const SettingsPreferences *preferences = &settings->preferences;
    fuzz_expect(preferences->text >= SETTINGS_TEXT_LEAST && preferences->text <= SETTINGS_TEXT_MOST,
                "a size of text is in range");
    fuzz_expect(preferences->theme >= 0, "a theme is in range");
    fuzz_expect(preferences->width >= 0 && preferences->width <= SETTINGS_SIDE_MOST && preferences->height >= 0 &&
                    preferences->height <= SETTINGS_SIDE_MOST,
                "a window's size is in range");
    fuzz_expect(settings->recent_count <= SETTINGS_RECENT_MOST, "recent files have room");
    for (size_t i = 0; i < settings->state.laboratory_count; i++)
        fuzz_expect(settings->state.laboratories[i].speed > 0, "a speed is in range");
}

static void open_well(Settings *settings, bool clean) {
    Fault notes = {0};
    const char *paths[SETTINGS_RECENT_MOST];
    settings_open(settings, &notes);
    fuzz_expect(!clean || notes.count == 0, "settings that were written are read");
    fuzz_expect_faults(notes.total == 0, &notes, "");
    check_values(settings);
    fuzz_expect(settings_recent(settings, paths) <= settings->recent_count, "recent files are among those read");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    begin();
    uint8_t which = fuzz_take(&data, &size);
    bool state = which & 1;
    write_file("config", "settings.json", data, state ? 0 : size);
    write_file("state", "state.json", data, state ? size : 0);
    Settings settings;
    Fault notes = {0};
    open_well(&settings, false);
    settings_laboratory(&settings, "house")->speed = 2;
    settings.preferences.sound = which & 2;
    settings_add_recent(&settings, fuzz_source("houses/closed-door.json"));
    SettingsPreferences preferences = settings.preferences;
    settings_save(&settings, &notes);
    fuzz_expect_faults(true, &notes, "");
    settings_close(&settings);
    open_well(&settings, true);
    fuzz_expect(memcmp(&preferences, &settings.preferences, sizeof preferences) == 0, "preferences survive writing");
    fuzz_expect(settings_laboratory(&settings, "house")->speed == 2, "a laboratory survives writing");
    settings_close(&settings);
    return 0;
}
