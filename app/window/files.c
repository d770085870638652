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
#include "live/shipped.h"
#include "window/act.h"
#include "window/edit.h"

#define PATIENCE 2.0 /* s, from an edit until it is written for the next time */

static Room *house_room(Window *window) {
    return &window->rooms[ROOM_HOUSE];
}

/* Titles ----------------------------------------------------------------------------------------------------------- */

bool files_unsaved(const Room *room) {
    const LiveEditor *editor = edit_of(room);
    if (!editor)
        return false;
    bool something = room->path || editor->edits(room->live) > 0;
    return room->mark || (something && editor->changed(room->live));
}

const char *files_title(Window *window, const Room *room) {
    const char *mark = room->mark ? room->mark : files_unsaved(room) ? " (edited)" : "";
    return text_in_arena(&window->words, "%s%s", room->kind->title(room->live), mark);
}

/* The system's frame says the same as the menu. */
static void show_title(Window *window) {
    const Room *room = window_room(window);
    char title[WINDOW_TITLE];
    snprintf(title, sizeof title, "%s - clearance", files_title(window, room));
    if (strcmp(title, window->title) == 0)
        return;
    snprintf(window->title, sizeof window->title, "%s", title);
    glass_set_title(window->glass, title);
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

static void keep_path(Room *room, const char *path) {
    char *kept = text_copy(path);
    memory_free(room->path);
    room->path = kept;
}

static void note_saved(Window *window, Room *room, const char *path) {
    keep_path(room, path);
    room->mark = NULL;
    memory_free(room->origin);
    room->origin = NULL;
    settings_add_recent(&window->settings, path);
    if (window->recovery && room == house_room(window))
        recovery_remove(window->recovery);
    window->watch.waits = window->watch.written = false;
    act_say(window, "saved: %s", path);
}

static bool save(Window *window, const char *path) {
    Room *room = window_room(window);
    const LiveEditor *editor = edit_of(room);
    Fault fault = {0};
    bool saved = editor ? editor->save(room->live, path, &fault) : room->kind->save(room->live, path, &fault);
    act_complain(window, &fault, NAN);
    if (saved && editor)
        note_saved(window, room, path);
    else if (saved)
        act_say(window, "saved: %s", path);
    else if (window->watch.written)
        act_say(window, "not saved; what was edited is kept in %s", recovery_path(window->recovery));
    return saved;
}

void files_save(Window *window) {
    Room *room = window_room(window);
    bool own = edit_of(room) && room->path && !room->mark && !is_shipped(room->path) && access(room->path, W_OK) == 0;
    if (!own)
        files_ask_name(window);
    else if (save(window, text_in_arena(&window->words, "%s", room->path)) && window->leave)
        files_go_on(window);
}

void files_ask_name(Window *window) {
    static const char *const endings[] = {".json", NULL};
    Room *room = window_room(window);
    char *folder = room->origin ? NULL : act_folder(window);
    if (room->origin) {
        snprintf(window->field, sizeof window->field, "%s", room->origin);
    } else if (folder) {
        char *name = export_free_name(folder, room->kind->title(room->live), endings);
        snprintf(window->field, sizeof window->field, "%s.json", name);
        memory_free(name);
    } else {
        return;
    }
    memory_free(folder);
    act_show_sheet(window, SHEET_SAVE);
}

bool files_save_as(Window *window, const char *path) {
    Room *room = window_room(window);
    bool own = (room->origin && strcmp(path, room->origin) == 0) ||
               (room->path && strcmp(path, room->path) == 0 && !is_shipped(path));
    if (!own && access(path, F_OK) == 0) {
        messages_say(&window->messages, MESSAGE_FAULT, NAN,
                     "%s: there is such a file already, the new one must have another name", path);
        window->dirty = true;
        return false;
    }
    if (!save(window, path))
        return false;
    Leave leave = window->leave;
    act_close_sheet(window);
    window->leave = leave;
    if (leave)
        files_go_on(window);
    return true;
}

/* Leaving ---------------------------------------------------------------------------------------------------------- */

void files_go_on(Window *window) {
    Leave leave = window->leave;
    act_close_sheet(window);
    if (leave == LEAVE_QUIT)
        window->quit = true;
    else if (leave != LEAVE_NOTHING)
        act_open(window, leave == LEAVE_OPEN ? window->leave_path : NULL);
}

void files_leave(Window *window, Leave leave, const char *path) {
    bool beam = leave == LEAVE_OPEN && live_kind_of(path) == &beam_live;
    snprintf(window->leave_path, sizeof window->leave_path, "%s", path ? path : "");
    edit_let_go(window);
    window->leave = leave;
    if (beam || !files_unsaved(house_room(window))) {
        files_go_on(window);
        return;
    }
    act_enter(window, ROOM_HOUSE);
    act_show_sheet(window, SHEET_LEAVE);
    window->leave = leave;
}

/* Recovery --------------------------------------------------------------------------------------------------------- */

/* Another number after every edit, every undoing and every saving. */
static uint64_t state_of(const Room *room, const LiveEditor *editor) {
    const char *undo = editor->undo_name(room->live);
    uint64_t state = digest_text(DIGEST_START, undo ? undo : "");
    const char *redo = editor->redo_name(room->live);
    state = digest_text(state, redo ? redo : "");
    return digest_bytes(state, &(size_t){editor->edits(room->live)}, sizeof(size_t));
}

static void write_recovery(Window *window, const Room *room, const LiveEditor *editor) {
    RecoveryAbout about = {.origin = room->origin ? room->origin : room->path,
                           .name = room->kind->title(room->live),
                           .edits = editor->edits(room->live),
                           .when = (int64_t)time(NULL)};
    int error = recovery_write(window->recovery, editor->text(room->live), &about);
    window->watch.written |= !error;
    if (error && !window->watch.failed)
        act_say(window, "what is edited cannot be kept in %s for the case of a crash: %s",
                recovery_path(window->recovery), strerror(error));
    window->watch.failed = error;
}

const char *const *files_command(Window *window, size_t *count) {
    enum { FILE_WORD = 1 };
    Room *room = window_room(window);
    const LiveEditor *editor = edit_of(room);
    const char *const *words = room->kind->command(room->live, count);
    if (*words[FILE_WORD] || !editor || !window->recovery)
        return words;
    write_recovery(window, room, editor);
    const char **given = arena_allocate(&window->words, *count * sizeof *given);
    memcpy(given, words, *count * sizeof *given);
    given[FILE_WORD] = recovery_path(window->recovery);
    return given;
}

static void watch_house(Window *window) {
    Room *room = house_room(window);
    const LiveEditor *editor = edit_of(room);
    Watch *watch = &window->watch;
    if (!editor || !window->recovery)
        return;
    uint64_t state = state_of(room, editor);
    if (state != watch->state) {
        watch->state = state;
        watch->since = clock_now();
        watch->waits = true;
    }
    if (!files_unsaved(room)) {
        if (watch->written)
            recovery_remove(window->recovery);
        watch->waits = watch->written = false;
    }
    if (!watch->waits || clock_now() - watch->since < PATIENCE)
        return;
    watch->waits = false;
    write_recovery(window, room, editor);
}

void files_watch(Window *window) {
    if (window_room(window)->live)
        show_title(window);
    watch_house(window);
}

void files_begin(Window *window, Room *room) {
    const LiveEditor *editor = edit_of(room);
    room->mark = NULL;
    memory_free(room->origin);
    room->origin = NULL;
    if (room != house_room(window))
        return;
    if (window->recovery && window->watch.written)
        recovery_remove(window->recovery);
    window->watch = (Watch){.state = editor ? state_of(room, editor) : 0};
}

void files_recover(Window *window, size_t found) {
    RecoveryFound *one = &window->found[found];
    Room *room = house_room(window);
    if (!act_open_copy(window, one->path, one->origin, " [Recovered]"))
        return;
    if (!recovery_adopt(window->recovery, one))
        act_say(window, "%s has been moved away meanwhile", one->path);
    room->origin = one->origin ? text_copy(one->origin) : NULL;
    window->watch.written = true;
    act_say(window, "recovered%s%s: save it to keep it", one->origin ? ", of " : "", one->origin ? one->origin : "");
    act_close_sheet(window);
}

void files_forget(Window *window, size_t found) {
    recovery_forget(&window->found[found]);
    recovery_free_found(window->found, window->found_count);
    window->found = recovery_find(window->recovery, &window->found_count);
    if (!window->found_count)
        act_close_sheet(window);
}

void files_start(Window *window) {
    window->recovery = recovery_create();
    if (!window->recovery)
        return;
    window->found = recovery_find(window->recovery, &window->found_count);
    if (window->found_count)
        act_show_sheet(window, SHEET_RECOVERED);
}

void files_end(Window *window) {
    if (!window->recovery)
        return;
    recovery_remove(window->recovery);
    recovery_free_found(window->found, window->found_count);
    recovery_destroy(window->recovery);
}
