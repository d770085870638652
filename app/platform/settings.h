/* Remembers preferences and session from one start to the next, in the XDG base directories (0.8):
 *
 *     $XDG_CONFIG_HOME/clearance/settings.json   preferences
 *     $XDG_STATE_HOME/clearance/state.json       recent files, and how each laboratory was shown
 *
 * Only values that differ from the defaults are written. An invalid file is not an error: it is renamed to FILE.bad,
 * the defaults are used, and one line says so. Without a writable folder everything works, but nothing is remembered.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"

#define SETTINGS_TEXT_LEAST 0.75
#define SETTINGS_TEXT_MOST 3.0

enum {
    SETTINGS_RECENT_MOST = 10,
    SETTINGS_WIDTH_LEAST = 320, /* pixels of a window */
    SETTINGS_HEIGHT_LEAST = 200,
    SETTINGS_SIDE_MOST = 16384,
};

/* The contents of settings.json. */
typedef struct SettingsPreferences {
    int theme;           /* Theme */
    double text;         /* size of text, SETTINGS_TEXT_LEAST to SETTINGS_TEXT_MOST; 1: its own size */
    bool sound;          /* off at first */
    bool reduced_motion; /* only the simulation moves */
    bool single_keys;    /* single letters are shortcut keys */
    int width, height;   /* pixels of the window, at most SETTINGS_SIDE_MOST; below the least: not known yet */
    bool full_screen;
} SettingsPreferences;

/* How a laboratory was shown. */
typedef struct SettingsLaboratory {
    const char *word;  /* "house": its key in the file */
    double speed;      /* as a multiple of the laboratory's own pace */
    int layers;        /* bits; -1: the default */
    const char *plots; /* names separated by commas; "": the default; "none" */
} SettingsLaboratory;

/* The contents of state.json. */
typedef struct SettingsState {
    const char *folder;               /* of the last file that was opened, or "" */
    int tried;                        /* bits: the first things to try that were done */
    const char *folds;                /* of the panel, as they were left: see panel.c */
    SettingsLaboratory *laboratories; /* (laboratory_count) in the order in which they were asked for or read */
    size_t laboratory_count, laboratory_capacity;
} SettingsState;

typedef struct Settings {
    SettingsPreferences preferences;
    SettingsState state; /* its texts come from settings_store or live as long as the settings */
    char *recent[SETTINGS_RECENT_MOST];
    size_t recent_count;
    char *preferences_path, *state_path;       /* NULL: there is no folder for it */
    char *preferences_written, *state_written; /* contents of the files, or NULL */
    bool complained;                           /* a failure to write was reported */
    Arena arena;
} Settings;

/* Reads both files; `notes` receives a line for each invalid file. */
void settings_open(Settings *settings, Fault *notes);

/* Writes the files that have changed, each to a temporary file that is then renamed. The first failure, or the lack of
 * a folder, adds a line to `notes`. */
void settings_save(Settings *settings, Fault *notes);
void settings_close(Settings *settings);

/* Returns how the laboratory with this word (Laboratory.word) was shown; valid until the next call. */
SettingsLaboratory *settings_laboratory(Settings *settings, const char *word);

/* Returns a copy of a text that lives as long as the settings, for the fields above. */
const char *settings_store(Settings *settings, const char *text);

/* Puts a file at the front of the recent files, by its absolute path. */
void settings_add_recent(Settings *settings, const char *path);

/* Lists the recent files that still exist, newest first, and returns their number. */
size_t settings_recent(const Settings *settings, const char *paths[SETTINGS_RECENT_MOST]);

/* Returns $XDG_STATE_HOME/clearance/ and makes it if needed. NULL: it cannot be made. Release it by memory_free. */
char *settings_state_folder(void);

/* Returns $XDG_CACHE_HOME/clearance/ and makes it if needed. NULL: it cannot be made. Release it by memory_free. */
char *settings_cache_folder(void);
