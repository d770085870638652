#include "window/files.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "laboratory/shipped.h"
#include "window/autosave.h"
#include "window/dialog_pane.h"
#include "window/lesson.h"
#include "window/notice.h"
#include "window/opening.h"
#include "window/plan_input.h"

/* Saving ----------------------------------------------------------------------------------------------------------- */

/* True if a file or folder lies in a folder, or is it. */
static bool is_within(const char *path, const char *folder) {
    char file[PATH_MAX], real[PATH_MAX];
    if (!folder || !realpath(path, file) || !realpath(folder, real))
        return false;
    size_t length = strlen(real);
    return strncmp(file, real, length) == 0 && (file[length] == '/' || !file[length]);
}

/* True if the file comes with the program; such files are never overwritten. */
static bool is_shipped(const char *path) {
    for (size_t i = 0; i < laboratories_count; i++)
        if (is_within(path, laboratory_folder(i)))
            return true;
    return is_within(path, shipped_places()->lessons);
}

/* Returns the folder of a file, in the frame's memory. */
static const char *folder_of(Window *window, const char *path) {
    const char *slash = strrchr(path, '/');
    return !slash ? "." : slash == path ? "/" : text_in_arena(&window->arena, "%.*s", (int)(slash - path), path);
}

const char *files_open_folder(Window *window) {
    const Tab *tab = window_tab(window);
    const char *path = tab->path ? tab->path : tab->origin, *last = window->settings.state.folder;
    return path ? folder_of(window, path) : *last ? last : ".";
}

/* Returns the user's folder for documents: $XDG_DOCUMENTS_DIR, or ~/Documents, made if it is missing; NULL: there is
 * none that can be written to. */
static const char *documents(Window *window) {
    const char *given = getenv("XDG_DOCUMENTS_DIR"), *home = getenv("HOME");
    const char *folder = given && *given ? given
                         : home && *home ? text_in_arena(&window->arena, "%s/Documents", home)
                                         : NULL;
    return folder && !text_make_folder(folder) && access(folder, W_OK | X_OK) == 0 ? folder : NULL;
}

/* Returns the folder in which a new file is proposed: that of the open file, else that of the last one; files that come
 * with the program are saved to the documents. */
static const char *save_folder(Window *window) {
    const Tab *tab = window_tab(window);
    const char *last = window->settings.state.folder;
    const char *own = tab->path && !is_shipped(tab->path)        ? folder_of(window, tab->path)
                      : !tab->path && *last && !is_shipped(last) ? last
                                                                 : NULL;
    if (own && access(own, W_OK | X_OK) == 0)
        return own;
    const char *folder = documents(window);
    if (folder)
        return folder;
    char *exports = notice_folder(window);
    folder = exports ? text_in_arena(&window->arena, "%s", exports) : NULL;
    memory_free(exports);
    return folder;
}

static void store_path(Tab *tab, const char *path) {
    char *kept = text_copy(path);
    memory_free(tab->path);
    tab->path = kept;
}

static void note_saved(Window *window, Tab *tab, const char *path) {
    store_path(tab, path);
    tab->mark = NULL;
    memory_free(tab->origin);
    tab->origin = NULL;
    tab->recovered = 0;
    settings_add_recent(&window->settings, path);
    if (tab == autosave_tab(window))
        autosave_drop(window);
    notice_post(window, "Saved: %s", path);
}

static bool save(Window *window, const char *path) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    Fault fault = {0};
    bool saved = editor ? editor_save(editor, path, &fault) : tab->laboratory->save(tab->session, path, &fault);
    notice_fault(window, &fault, NAN);
    if (saved && editor)
        note_saved(window, tab, path);
    else if (saved)
        notice_post(window, "Saved: %s", path);
    else if (window->watch.written)
        notice_post(window, "Not saved. The edits are in the recovery file %s", recovery_path(window->recovery));
    return saved;
}

void files_save(Window *window) {
    Tab *tab = window_tab(window);
    bool own = tab_editor(tab) && tab->path && !tab->mark && !is_shipped(tab->path) && access(tab->path, W_OK) == 0;
    if (!own)
        files_ask_name(window);
    else if (save(window, text_in_arena(&window->arena, "%s", tab->path)) && window->leave)
        files_finish_leaving(window);
}

void files_ask_name(Window *window) {
    Tab *tab = window_tab(window);
    /* a double ending, by which desktops tell a house from other JSON */
    const char *ending = text_in_arena(&window->arena, "%s.json", tab->laboratory->word);
    const char *const endings[] = {ending, NULL};
    const char *folder = tab->origin ? NULL : save_folder(window);
    if (tab->origin) {
        snprintf(window->field, sizeof window->field, "%s", tab->origin);
    } else if (folder) {
        char *name = export_free_name(folder, tab->laboratory->title(tab->session), endings);
        snprintf(window->field, sizeof window->field, "%s.%s", name, ending);
        memory_free(name);
    } else {
        return;
    }
    dialog_pane_show(window, DIALOG_SAVE);
}

bool files_save_as(Window *window, const char *path) {
    Tab *tab = window_tab(window);
    bool own = (tab->origin && strcmp(path, tab->origin) == 0) ||
               (tab->path && strcmp(path, tab->path) == 0 && !is_shipped(path));
    if (!own && access(path, F_OK) == 0) {
        messages_add(&window->messages, MESSAGE_FAULT, NAN, "%s already exists. Choose another name.", path);
        window->dirty = true;
        return false;
    }
    if (!save(window, path))
        return false;
    Leave leave = window->leave;
    dialog_pane_close(window);
    window->leave = leave;
    if (leave)
        files_finish_leaving(window);
    return true;
}

/* Leaving ---------------------------------------------------------------------------------------------------------- */

void files_finish_leaving(Window *window) {
    Leave leave = window->leave;
    dialog_pane_close(window);
    if (leave == LEAVE_QUIT)
        window->quit = true;
    else if (leave != LEAVE_NOTHING)
        lesson_open_any(window, leave == LEAVE_OPEN ? window->leave_path : NULL);
}

/* Returns a tab whose edits would be lost, or NULL. Opening a file closes only what is open in the same tab. */
static const Tab *tab_to_save(Window *window, Leave leave, const char *path) {
    const Tab *closed = leave == LEAVE_OPEN  ? &window->tabs[lesson_tab_of(path)]
                        : leave == LEAVE_NEW ? autosave_tab(window)
                                             : NULL;
    for (size_t i = 0; i < laboratories_count; i++)
        if ((!closed || closed == &window->tabs[i]) && tab_unsaved(&window->tabs[i]))
            return &window->tabs[i];
    return NULL;
}

void files_leave(Window *window, Leave leave, const char *path) {
    snprintf(window->leave_path, sizeof window->leave_path, "%s", path ? path : "");
    plan_input_reset(window);
    window->leave = leave;
    const Tab *tab = tab_to_save(window, leave, path);
    if (!tab && lesson_would_lose(window, leave, path)) {
        dialog_pane_show(window, DIALOG_LESSON);
        window->leave = leave;
        return;
    }
    if (!tab) {
        files_finish_leaving(window);
        return;
    }
    opening_tab(window, (size_t)(tab - window->tabs));
    dialog_pane_show(window, DIALOG_LEAVE);
    window->leave = leave;
}

/* Recovery --------------------------------------------------------------------------------------------------------- */

void files_recover(Window *window, size_t found) {
    RecoveryFound *one = &window->found[found];
    Tab *tab = autosave_tab(window);
    if (!opening_copy(window, one->path, one->origin, " [Recovered]"))
        return;
    if (!recovery_adopt(window->recovery, one))
        notice_post(window, "The recovery file %s no longer exists.", one->path);
    tab->origin = one->origin ? text_copy(one->origin) : NULL;
    tab->recovered = one->edits;
    window->watch.written = true;
    if (one->origin)
        notice_post(window, "Recovered the edits of %s. Save them to keep them.", one->origin);
    else
        notice_post(window, "Recovered an unsaved house. Save it to keep it.");
    dialog_pane_close(window);
}

void files_forget(Window *window, size_t found) {
    recovery_forget(&window->found[found]);
    recovery_free_found(window->found, window->found_count);
    window->found = recovery_find(window->recovery, &window->found_count);
    if (!window->found_count)
        dialog_pane_close(window);
}

void files_start(Window *window) {
    window->recovery = recovery_create();
    if (!window->recovery)
        return;
    window->found = recovery_find(window->recovery, &window->found_count);
    if (window->found_count)
        dialog_pane_show(window, DIALOG_RECOVERED);
}

void files_end(Window *window) {
    if (!window->recovery)
        return;
    recovery_remove(window->recovery);
    recovery_free_found(window->found, window->found_count);
    recovery_destroy(window->recovery);
}
