#include "window/autosave.h"

#include <string.h>
#include <time.h>

#include "base/file_write.h"
#include "base/stopwatch.h"
#include "base/digest.h"
#include "platform/export.h"
#include "window/notice.h"
#include "window/plan_input.h"

#define PATIENCE 2.0 /* s, from an edit until it is written */

Tab *autosave_tab(Window *window) {
    size_t index = 0;
    while (index + 1 < laboratories_count && !laboratories[index].laboratory->editor)
        index++;
    return &window->tabs[index];
}

/* Returns a number that changes with every edit, undo, redo and save. */
static uint64_t state_of(Editor *editor) {
    const char *undo = editor_undo_name(editor);
    uint64_t state = digest_text(DIGEST_START, undo ? undo : "");
    const char *redo = editor_redo_name(editor);
    state = digest_text(state, redo ? redo : "");
    return digest_bytes(state, &(size_t){editor_edit_count(editor)}, sizeof(size_t));
}

static void write_recovery(Window *window, const Tab *tab, Editor *editor) {
    RecoveryAbout about = {.origin = tab->origin ? tab->origin : tab->path,
                           .name = tab->laboratory->title(tab->session),
                           .edits = tab_edit_count(tab),
                           .when = (int64_t)time(NULL)};
    int error = recovery_write(window->recovery, editor_text(editor), &about);
    window->watch.written |= !error;
    if (error && !window->watch.failed)
        notice_post(window, "The recovery file %s cannot be written: %s", recovery_path(window->recovery),
                    file_write_reason(error));
    window->watch.failed = error;
}

const char *const *autosave_command(Window *window, const char *folder, size_t *count) {
    enum { FILE_WORD = 1 };
    static const char *const endings[] = {"house.json", NULL};
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    const char *const *arguments = tab->laboratory->command(tab->session, count);
    if (*arguments[FILE_WORD] || !editor)
        return arguments;
    char *name = export_free_name(folder, tab->laboratory->title(tab->session), endings);
    const char **given = arena_allocate(&window->arena, *count * sizeof *given);
    bool edited = tab->path && editor_is_changed(editor); /* the film, the frames and the report say so */
    char *text = editor_text_of(
        editor, text_in_arena(&window->arena, edited ? "%s (edited)" : "%s", tab->laboratory->title(tab->session)));
    memcpy(given, arguments, *count * sizeof *given);
    given[FILE_WORD] = text_in_arena(&window->arena, "%s.%s", name, endings[0]);
    int error = file_write_bytes(given[FILE_WORD], text, strlen(text));
    if (error)
        notice_post(window, "%s cannot be written: %s", given[FILE_WORD], file_write_reason(error));
    memory_free(name);
    memory_free(text);
    return given;
}

void autosave_update(Window *window) {
    Tab *tab = autosave_tab(window);
    Editor *editor = tab_editor(tab);
    Watch *watch = &window->watch;
    if (!editor || !window->recovery)
        return;
    uint64_t state = state_of(editor);
    if (state != watch->state) {
        watch->state = state;
        watch->since = stopwatch_now();
        watch->waits = true;
    }
    if (!tab_unsaved(tab)) {
        if (watch->written)
            recovery_remove(window->recovery);
        watch->waits = watch->written = false;
    }
    if (!watch->waits || stopwatch_now() - watch->since < PATIENCE)
        return;
    watch->waits = false;
    write_recovery(window, tab, editor);
}

void autosave_restart(Window *window, Tab *tab) {
    Editor *editor = tab_editor(tab);
    tab->mark = NULL;
    memory_free(tab->origin);
    tab->origin = NULL;
    tab->recovered = 0;
    if (tab != autosave_tab(window))
        return;
    if (window->recovery && window->watch.written)
        recovery_remove(window->recovery);
    window->watch = (Watch){.state = editor ? state_of(editor) : 0};
}

void autosave_drop(Window *window) {
    if (window->recovery)
        recovery_remove(window->recovery);
    window->watch.waits = window->watch.written = false;
}
