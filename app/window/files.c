#include "window/files.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/digest.h"
#include "base/text.h"
#include "laboratory/shipped.h"
#include "window/act.h"
#include "window/plan_input.h"

#define PATIENCE 2.0 /* s, from an edit until it is written for the next time */

static Tab *house_tab(Window *window) {
    return &window->tabs[TAB_HOUSE];
}

/* Titles ----------------------------------------------------------------------------------------------------------- */

bool files_unsaved(const Tab *tab) {
    const EditorFunctions *editor = plan_input_of(tab);
    if (!editor)
        return false;
    bool something = tab->path || editor->edits(tab->live) > 0;
    return tab->mark || (something && editor->changed(tab->live));
}

const char *files_title(Window *window, const Tab *tab) {
    const char *mark = tab->mark ? tab->mark : files_unsaved(tab) ? " (edited)" : "";
    return text_in_arena(&window->arena, "%s%s", tab->kind->title(tab->live), mark);
}

/* The system's frame says the same as the menu. */
static void show_title(Window *window) {
    const Tab *tab = window_tab(window);
    char title[WINDOW_TITLE];
    snprintf(title, sizeof title, "%s - clearance", files_title(window, tab));
    if (strcmp(title, window->title) == 0)
        return;
    snprintf(window->title, sizeof window->title, "%s", title);
    sdl_window_set_title(window->sdl_window, title);
    window->dirty = true;
}

/* Saving ----------------------------------------------------------------------------------------------------------- */

/* Those that come with the program are never written over. */
static bool is_shipped(const char *path) {
    char file[PATH_MAX], folder[PATH_MAX];
    const Shipped *shipped = shipped_places();
    if (!realpath(path, file) || !realpath(shipped->houses, folder))
        return false;
    size_t length = strlen(folder);
    return strncmp(file, folder, length) == 0 && file[length] == '/';
}

static void keep_path(Tab *tab, const char *path) {
    char *kept = text_copy(path);
    memory_free(tab->path);
    tab->path = kept;
}

static void note_saved(Window *window, Tab *tab, const char *path) {
    keep_path(tab, path);
    tab->mark = NULL;
    memory_free(tab->origin);
    tab->origin = NULL;
    settings_add_recent(&window->settings, path);
    if (window->recovery && tab == house_tab(window))
        recovery_remove(window->recovery);
    window->watch.waits = window->watch.written = false;
    act_say(window, "saved: %s", path);
}

static bool save(Window *window, const char *path) {
    Tab *tab = window_tab(window);
    const EditorFunctions *editor = plan_input_of(tab);
    Fault fault = {0};
    bool saved = editor ? editor->save(tab->live, path, &fault) : tab->kind->save(tab->live, path, &fault);
    act_complain(window, &fault, NAN);
    if (saved && editor)
        note_saved(window, tab, path);
    else if (saved)
        act_say(window, "saved: %s", path);
    else if (window->watch.written)
        act_say(window, "not saved; what was edited is kept in %s", recovery_path(window->recovery));
    return saved;
}

void files_save(Window *window) {
    Tab *tab = window_tab(window);
    bool own = plan_input_of(tab) && tab->path && !tab->mark && !is_shipped(tab->path) && access(tab->path, W_OK) == 0;
    if (!own)
        files_ask_name(window);
    else if (save(window, text_in_arena(&window->arena, "%s", tab->path)) && window->leave)
        files_finish_leaving(window);
}

void files_ask_name(Window *window) {
    static const char *const endings[] = {".json", NULL};
    Tab *tab = window_tab(window);
    char *folder = tab->origin ? NULL : act_folder(window);
    if (tab->origin) {
        snprintf(window->field, sizeof window->field, "%s", tab->origin);
    } else if (folder) {
        char *name = export_free_name(folder, tab->kind->title(tab->live), endings);
        snprintf(window->field, sizeof window->field, "%s.json", name);
        memory_free(name);
    } else {
        return;
    }
    memory_free(folder);
    act_show_dialog(window, DIALOG_SAVE);
}

bool files_save_as(Window *window, const char *path) {
    Tab *tab = window_tab(window);
    bool own = (tab->origin && strcmp(path, tab->origin) == 0) ||
               (tab->path && strcmp(path, tab->path) == 0 && !is_shipped(path));
    if (!own && access(path, F_OK) == 0) {
        messages_add(&window->messages, MESSAGE_FAULT, NAN,
                     "%s: there is such a file already, the new one must have another name", path);
        window->dirty = true;
        return false;
    }
    if (!save(window, path))
        return false;
    Leave leave = window->leave;
    act_close_dialog(window);
    window->leave = leave;
    if (leave)
        files_finish_leaving(window);
    return true;
}

/* Leaving ---------------------------------------------------------------------------------------------------------- */

void files_finish_leaving(Window *window) {
    Leave leave = window->leave;
    act_close_dialog(window);
    if (leave == LEAVE_QUIT)
        window->quit = true;
    else if (leave != LEAVE_NOTHING)
        act_open(window, leave == LEAVE_OPEN ? window->leave_path : NULL);
}

void files_leave(Window *window, Leave leave, const char *path) {
    bool beam = leave == LEAVE_OPEN && laboratory_of(path) == &beam_laboratory;
    snprintf(window->leave_path, sizeof window->leave_path, "%s", path ? path : "");
    plan_input_reset(window);
    window->leave = leave;
    if (beam || !files_unsaved(house_tab(window))) {
        files_finish_leaving(window);
        return;
    }
    act_enter(window, TAB_HOUSE);
    act_show_dialog(window, DIALOG_LEAVE);
    window->leave = leave;
}

/* Recovery --------------------------------------------------------------------------------------------------------- */

/* Another number after every edit, every undoing and every saving. */
static uint64_t state_of(const Tab *tab, const EditorFunctions *editor) {
    const char *undo = editor->undo_name(tab->live);
    uint64_t state = digest_text(DIGEST_START, undo ? undo : "");
    const char *redo = editor->redo_name(tab->live);
    state = digest_text(state, redo ? redo : "");
    return digest_bytes(state, &(size_t){editor->edits(tab->live)}, sizeof(size_t));
}

static void write_recovery(Window *window, const Tab *tab, const EditorFunctions *editor) {
    RecoveryAbout about = {.origin = tab->origin ? tab->origin : tab->path,
                           .name = tab->kind->title(tab->live),
                           .edits = editor->edits(tab->live),
                           .when = (int64_t)time(NULL)};
    int error = recovery_write(window->recovery, editor->text(tab->live), &about);
    window->watch.written |= !error;
    if (error && !window->watch.failed)
        act_say(window, "what is edited cannot be kept in %s for the case of a crash: %s",
                recovery_path(window->recovery), strerror(error));
    window->watch.failed = error;
}

const char *const *files_command(Window *window, size_t *count) {
    enum { FILE_WORD = 1 };
    Tab *tab = window_tab(window);
    const EditorFunctions *editor = plan_input_of(tab);
    const char *const *words = tab->kind->command(tab->live, count);
    if (*words[FILE_WORD] || !editor || !window->recovery)
        return words;
    write_recovery(window, tab, editor);
    const char **given = arena_allocate(&window->arena, *count * sizeof *given);
    memcpy(given, words, *count * sizeof *given);
    given[FILE_WORD] = recovery_path(window->recovery);
    return given;
}

static void watch_house(Window *window) {
    Tab *tab = house_tab(window);
    const EditorFunctions *editor = plan_input_of(tab);
    Watch *watch = &window->watch;
    if (!editor || !window->recovery)
        return;
    uint64_t state = state_of(tab, editor);
    if (state != watch->state) {
        watch->state = state;
        watch->since = clock_now();
        watch->waits = true;
    }
    if (!files_unsaved(tab)) {
        if (watch->written)
            recovery_remove(window->recovery);
        watch->waits = watch->written = false;
    }
    if (!watch->waits || clock_now() - watch->since < PATIENCE)
        return;
    watch->waits = false;
    write_recovery(window, tab, editor);
}

void files_watch(Window *window) {
    if (window_tab(window)->live)
        show_title(window);
    watch_house(window);
}

void files_begin(Window *window, Tab *tab) {
    const EditorFunctions *editor = plan_input_of(tab);
    tab->mark = NULL;
    memory_free(tab->origin);
    tab->origin = NULL;
    if (tab != house_tab(window))
        return;
    if (window->recovery && window->watch.written)
        recovery_remove(window->recovery);
    window->watch = (Watch){.state = editor ? state_of(tab, editor) : 0};
}

void files_recover(Window *window, size_t found) {
    RecoveryFound *one = &window->found[found];
    Tab *tab = house_tab(window);
    if (!act_open_copy(window, one->path, one->origin, " [Recovered]"))
        return;
    if (!recovery_adopt(window->recovery, one))
        act_say(window, "%s has been moved away meanwhile", one->path);
    tab->origin = one->origin ? text_copy(one->origin) : NULL;
    window->watch.written = true;
    act_say(window, "recovered%s%s: save it to keep it", one->origin ? ", of " : "", one->origin ? one->origin : "");
    act_close_dialog(window);
}

void files_forget(Window *window, size_t found) {
    recovery_forget(&window->found[found]);
    recovery_free_found(window->found, window->found_count);
    window->found = recovery_find(window->recovery, &window->found_count);
    if (!window->found_count)
        act_close_dialog(window);
}

void files_start(Window *window) {
    window->recovery = recovery_create();
    if (!window->recovery)
        return;
    window->found = recovery_find(window->recovery, &window->found_count);
    if (window->found_count)
        act_show_dialog(window, DIALOG_RECOVERED);
}

void files_end(Window *window) {
    if (!window->recovery)
        return;
    recovery_remove(window->recovery);
    recovery_free_found(window->found, window->found_count);
    recovery_destroy(window->recovery);
}
