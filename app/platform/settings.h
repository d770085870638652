/* What is remembered from one time to the next, where the XDG base directories (0.8) have it:
 *
 *     $XDG_CONFIG_HOME/clearance/settings.json   how the person likes it
 *     $XDG_STATE_HOME/clearance/state.json       what was open, and how it was shown
 *
 * Only what differs from the program's own is written. A file that cannot be read is no error: it is kept beside as
 * FILE.bad, all is as at first, and one line says so. Without a place to write to everything works, unremembered. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"

enum {
    SETTINGS_RECENT_MOST = 10,
    SETTINGS_TEXT_MOST = 3,
    SETTINGS_WIDTH_LEAST = 320, /* pixels of a window */
    SETTINGS_HEIGHT_LEAST = 200,
    SETTINGS_SIDE_MOST = 16384,
};

/* settings.json. */
typedef struct SettingsPreferences {
    int theme;           /* Theme */
    int text;            /* size of text, 1 to 3 */
    bool sound;          /* off at first */
    bool reduced_motion; /* nothing moves but what is simulated */
    bool single_keys;    /* single letters are keys */
    int width, height;   /* pixels of the window */
    bool full_screen;
} SettingsPreferences;

/* How a laboratory was shown. */
typedef struct SettingsLaboratory {
    const char *word;  /* "house": its key in the file */
    double speed;      /* 1, of the laboratory's pace */
    int layers;        /* bits; -1: as at first */
    const char *plots; /* names parted by commas; "": as at first; "none" */
} SettingsLaboratory;

/* state.json. */
typedef struct SettingsState {
    const char *folder;               /* last looked into, or "" */
    SettingsLaboratory *laboratories; /* (laboratory_count) as they were asked for or read */
    size_t laboratory_count, laboratory_capacity;
} SettingsState;

typedef struct Settings {
    SettingsPreferences preferences;
    SettingsState state; /* texts by settings_store, or as long-lived as the settings */
    char *recent[SETTINGS_RECENT_MOST];
    size_t recent_count;
    char *preferences_path, *state_path;       /* NULL: there is no place for it */
    char *preferences_written, *state_written; /* what the files hold, or NULL */
    bool complained;                           /* that it cannot be remembered */
    Arena arena;
} Settings;

/* Reads both files; `notes` gets a line for each that could not be read. */
void settings_open(Settings *settings, Fault *notes);

/* Writes what has changed, beside and renamed; quick when nothing has. A failure, also that there is
 * no place, adds a line the first time. */
void settings_save(Settings *settings, Fault *notes);
void settings_close(Settings *settings);

/* Returns how the laboratory with this word (Laboratory.word) was shown; good until another one is asked for. */
SettingsLaboratory *settings_laboratory(Settings *settings, const char *word);

/* A copy of a text that lives as long as the settings, for the fields above. */
const char *settings_store(Settings *settings, const char *text);

/* Puts a file in front of the recent ones, by its absolute path. */
void settings_add_recent(Settings *settings, const char *path);

/* Those of the recent files that are there now, newest first: how many. */
size_t settings_recent(const Settings *settings, const char *paths[SETTINGS_RECENT_MOST]);

/* $XDG_STATE_HOME/clearance/, made if needed; NULL: there is no place. memory_free it. */
char *settings_state_folder(void);

/* $XDG_CACHE_HOME/clearance/, made if needed; NULL: there is no place. memory_free it. */
char *settings_cache_folder(void);
