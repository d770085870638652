#include "platform/settings.h"

#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file_write.h"
#include "base/parameters.h"
#include "base/text.h"
#include "draw/palette.h"

/* Speeds, as multiples of the laboratory's own pace. */
#define SPEED_LEAST 1e-6
#define SPEED_MOST 1e6

/* Tables ----------------------------------------------------------------------------------------------------------- */

#define PREFERENCE(kind_, field_)                                                                                      \
    .name = #field_, .kind = kind_, .offset = offsetof(SettingsPreferences, field_), .unit = "1"

static const Parameter preferences_rows[] = {
    {PREFERENCE(PARAMETER_CHOICE, theme), .choices = THEME_NAMES, .meaning = "light or dark"},
    {PREFERENCE(PARAMETER_NUMBER, text), .low = SETTINGS_TEXT_LEAST, .high = SETTINGS_TEXT_MOST, .fallback = 1,
     .meaning = "text size"},
    {PREFERENCE(PARAMETER_FLAG, sound), .meaning = "sound is on"},
    {PREFERENCE(PARAMETER_FLAG, reduced_motion), .meaning = "only the simulation moves"},
    {.name = "letters",
     .kind = PARAMETER_FLAG,
     .offset = offsetof(SettingsPreferences, single_keys),
     .unit = "1",
     .fallback = 1,
     .meaning = "single letters are shortcut keys"},
    {PREFERENCE(PARAMETER_WHOLE, width), .high = SETTINGS_SIDE_MOST, .meaning = "pixels of the window"},
    {PREFERENCE(PARAMETER_WHOLE, height), .high = SETTINGS_SIDE_MOST, .meaning = "pixels of the window"},
    {PREFERENCE(PARAMETER_FLAG, full_screen), .meaning = "the window fills the screen"},
};
static const ParameterTable preferences_table = {"settings", preferences_rows,
                                                 sizeof preferences_rows / sizeof *preferences_rows};

#define SHOWN(kind_, field_) .name = #field_, .kind = kind_, .offset = offsetof(SettingsLaboratory, field_), .unit = "1"

static const Parameter laboratory_rows[] = {
    {SHOWN(PARAMETER_NUMBER, speed), .low = SPEED_LEAST, .high = SPEED_MOST, .fallback = 1,
     .meaning = "speed, as a multiple of the usual pace"},
    {SHOWN(PARAMETER_WHOLE, layers), .low = -1, .high = 65535, .fallback = -1, .meaning = "layers shown, as bits"},
    {SHOWN(PARAMETER_TEXT, plots), .meaning = "plots shown"},
};
static const ParameterTable laboratory_table = {"laboratory", laboratory_rows,
                                                sizeof laboratory_rows / sizeof *laboratory_rows};

static const Parameter state_rows[] = {
    {.name = "folder",
     .kind = PARAMETER_TEXT,
     .offset = offsetof(SettingsState, folder),
     .meaning = "folder of the last opened file"},
    {.name = "tried",
     .kind = PARAMETER_WHOLE,
     .offset = offsetof(SettingsState, tried),
     .unit = "1",
     .low = 0,
     .high = 7,
     .meaning = "first things that were tried, as bits"},
    {.name = "folds",
     .kind = PARAMETER_TEXT,
     .offset = offsetof(SettingsState, folds),
     .meaning = "sections of the panel that were opened (+) or closed (-), a line each"},
};
static const ParameterTable state_table = {"state", state_rows, sizeof state_rows / sizeof *state_rows};

/* Places ----------------------------------------------------------------------------------------------------------- */

/* Returns the folder that an XDG variable names, or its default in the home folder. Relative paths are ignored, as the
 * standard requires. NULL: there is none. */
static char *base_folder(const char *variable, const char *in_home) {
    Text text = {0};
    const char *value = getenv(variable), *home = getenv("HOME");
    if (value && *value == '/')
        text_format(&text, "%s/clearance", value);
    else if (home && *home == '/')
        text_format(&text, "%s/%s/clearance", home, in_home);
    return text.text;
}

static char *file_in(const char *variable, const char *in_home, const char *name) {
    char *folder = base_folder(variable, in_home);
    Text text = {0};
    if (folder)
        text_format(&text, "%s/%s", folder, name);
    memory_free(folder);
    return text.text;
}

/* Returns the same folder and makes it if needed. NULL: it cannot be made. */
static char *made_folder(const char *variable, const char *in_home) {
    char *folder = base_folder(variable, in_home);
    if (folder && text_make_folder(folder) == 0)
        return folder;
    memory_free(folder);
    return NULL;
}

char *settings_cache_folder(void) {
    return made_folder("XDG_CACHE_HOME", ".cache");
}

char *settings_state_folder(void) {
    return made_folder("XDG_STATE_HOME", ".local/state");
}

/* Reading ---------------------------------------------------------------------------------------------------------- */

static void remember_recent(Settings *settings, const char *path) {
    if (settings->recent_count < SETTINGS_RECENT_MOST)
        settings->recent[settings->recent_count++] = text_copy(path);
}

/* Takes the list of recent files out of the values: no table describes it. */
static bool read_recent(Settings *settings, const JsonNode *root, Fault *fault) {
    JsonNode list = json_member(root, "recent");
    size_t before = fault->total;
    if (list.value && !json_is_array(list.value))
        json_fault(&list, fault, "recent must be a list of files");
    for (size_t i = 0; i < json_array_size(list.value); i++) {
        JsonNode element = json_element(&list, i);
        const char *path = json_string_value(element.value);
        if (path && *path == '/')
            remember_recent(settings, path);
        else
            json_fault(&element, fault, "each recent file must be an absolute path");
    }
    json_object_del(root->value, "recent");
    return fault->total == before;
}

/* Takes the objects out of the values: each belongs to a laboratory, and its key is the laboratory's word. */
static bool read_laboratories(Settings *settings, const JsonNode *root, Fault *fault) {
    const char *word;
    json_t *value;
    void *next;
    size_t before = fault->total;
    json_object_foreach_safe(root->value, next, word, value) {
        JsonNode node = json_member(root, word);
        if (!json_is_object(value))
            continue;
        parameters_read(&laboratory_table, settings_laboratory(settings, word), &node, &settings->arena, fault);
        json_object_del(root->value, word);
    }
    return fault->total == before;
}

/* Forgets the lists that no table resets: recent files and laboratories. */
static void forget_lists(Settings *settings) {
    while (settings->recent_count)
        memory_free(settings->recent[--settings->recent_count]);
    settings->state.laboratory_count = 0;
}

static void set_aside(const char *path, const Fault *fault, Fault *notes) {
    Text bad = {0};
    text_format(&bad, "%s.bad", path);
    bool kept = rename(path, bad.text) == 0;
    const char *why = fault->count ? fault->lines[0] : path;
    if (kept)
        fault_add(notes, "%s; the defaults are used, and the file is kept as %s", why, bad.text);
    else
        fault_add(notes, "%s; the defaults are used", why);
    memory_free(bad.text);
}

/* Reads a file into `object`, which is reset if the file is invalid; *written receives the text that was read. */
static void read_file(Settings *settings, const char *path, const ParameterTable *table, void *object, char **written,
                      Fault *notes) {
    JsonFile file = {0};
    Fault fault = {0};
    if (!path || (access(path, F_OK) != 0 && errno == ENOENT))
        return;
    bool good = json_read(&file, path, &fault);
    if (good) {
        JsonNode root = json_root(&file);
        *written = json_line(root.value);
        good = (table != &state_table ||
                (read_recent(settings, &root, &fault) && read_laboratories(settings, &root, &fault))) &&
               parameters_read(table, object, &root, &settings->arena, &fault);
    }
    if (!good) {
        parameters_reset(table, object);
        if (table == &state_table)
            forget_lists(settings);
        memory_free(*written);
        *written = NULL;
        set_aside(path, &fault, notes);
    }
    json_free(&file);
    fault_clear(&fault);
}

void settings_open(Settings *settings, Fault *notes) {
    *settings = (Settings){.complained = false};
    parameters_reset(&preferences_table, &settings->preferences);
    parameters_reset(&state_table, &settings->state);
    settings->preferences_path = file_in("XDG_CONFIG_HOME", ".config", "settings.json");
    settings->state_path = file_in("XDG_STATE_HOME", ".local/state", "state.json");
    read_file(settings, settings->preferences_path, &preferences_table, &settings->preferences,
              &settings->preferences_written, notes);
    read_file(settings, settings->state_path, &state_table, &settings->state, &settings->state_written, notes);
}

/* Writing ---------------------------------------------------------------------------------------------------------- */

/* Returns 0 or errno; ENOENT if there is no place for the file. */
static int write_object(const char *path, json_t *object) {
    if (!path)
        return ENOENT;
    char *slash = strrchr(path, '/'), *folder = memory_zeroed(strlen(path) + 1, 1);
    memcpy(folder, path, (size_t)(slash - path));
    int error = text_make_folder(folder);
    memory_free(folder);
    if (error)
        return error;
    char *text = json_dumps(object, JSON_INDENT(2) | JSON_PRESERVE_ORDER);
    Text lines = {0};
    text_format(&lines, "%s\n", text);
    free(text);
    error = file_write_quickly(path, lines.text, lines.used);
    memory_free(lines.text);
    return error;
}

/* Writes the object if it has changed, and releases it. */
static void save_object(Settings *settings, const char *path, json_t *object, char **written, Fault *notes) {
    char *line = json_line(object);
    bool same = *written ? strcmp(*written, line) == 0 : json_object_size(object) == 0;
    int error = same ? 0 : write_object(path, object);
    if (error && !settings->complained) {
        settings->complained = true;
        if (path)
            fault_add(notes, "settings cannot be saved to %s: %s", path, file_write_reason(error));
        else
            fault_add(notes, "settings cannot be saved: HOME is not set");
    }
    if (same || error) {
        memory_free(line);
    } else {
        memory_free(*written);
        *written = line;
    }
    json_decref(object);
}

void settings_save(Settings *settings, Fault *notes) {
    json_t *state = parameters_write(&state_table, &settings->state);
    for (size_t i = 0; i < settings->state.laboratory_count; i++) {
        json_t *laboratory = parameters_write(&laboratory_table, &settings->state.laboratories[i]);
        if (json_object_size(laboratory))
            json_object_set(state, settings->state.laboratories[i].word, laboratory);
        json_decref(laboratory);
    }
    if (settings->recent_count) {
        json_t *recent = json_array();
        for (size_t i = 0; i < settings->recent_count; i++)
            json_array_append_new(recent, json_string(settings->recent[i]));
        json_object_set_new(state, "recent", recent);
    }
    save_object(settings, settings->preferences_path, parameters_write(&preferences_table, &settings->preferences),
                &settings->preferences_written, notes);
    save_object(settings, settings->state_path, state, &settings->state_written, notes);
}

void settings_close(Settings *settings) {
    forget_lists(settings);
    memory_free(settings->state.laboratories);
    memory_free(settings->preferences_path);
    memory_free(settings->state_path);
    memory_free(settings->preferences_written);
    memory_free(settings->state_written);
    arena_clear(&settings->arena);
    *settings = (Settings){.complained = false};
}

/* Its contents ----------------------------------------------------------------------------------------------------- */

SettingsLaboratory *settings_laboratory(Settings *settings, const char *word) {
    SettingsState *state = &settings->state;
    for (size_t i = 0; i < state->laboratory_count; i++)
        if (strcmp(state->laboratories[i].word, word) == 0)
            return &state->laboratories[i];
    state->laboratories = memory_reserve(state->laboratories, &state->laboratory_capacity, state->laboratory_count + 1,
                                         sizeof *state->laboratories);
    SettingsLaboratory *added = &state->laboratories[state->laboratory_count++];
    parameters_reset(&laboratory_table, added);
    added->word = arena_text(&settings->arena, word);
    return added;
}

const char *settings_store(Settings *settings, const char *text) {
    return arena_text(&settings->arena, text);
}

/* True if the text is UTF-8, the only encoding of JSON. */
static bool can_be_written(const char *text) {
    json_t *value = json_string(text);
    json_decref(value);
    return value;
}

void settings_add_recent(Settings *settings, const char *path) {
    char *whole = realpath(path, NULL);
    if (whole && can_be_written(whole)) {
        size_t at = 0;
        while (at < settings->recent_count && strcmp(settings->recent[at], whole) != 0)
            at++;
        if (at == SETTINGS_RECENT_MOST)
            at--;
        if (at < settings->recent_count)
            memory_free(settings->recent[at]);
        else
            settings->recent_count++;
        memmove(settings->recent + 1, settings->recent, at * sizeof *settings->recent);
        settings->recent[0] = text_copy(whole);
    }
    free(whole);
}

size_t settings_recent(const Settings *settings, const char *paths[SETTINGS_RECENT_MOST]) {
    size_t count = 0;
    for (size_t i = 0; i < settings->recent_count; i++) {
        struct stat status;
        if (stat(settings->recent[i], &status) == 0 && S_ISREG(status.st_mode))
            paths[count++] = settings->recent[i];
    }
    return count;
}
