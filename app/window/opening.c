#include "window/opening.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "base/file_write.h"
#include "laboratory/import_file.h"
#include "laboratory/shipped.h"
#include "window/autosave.h"
#include "window/dialog_pane.h"
#include "window/notice.h"
#include "window/plan_input.h"

static LaboratoryOptions options_of(const Window *window, bool first) {
    const WindowOptions *given = window->options;
    LaboratoryOptions options = {
        .profiles = shipped_places()->profiles, .driving = -1, .seed = given->seed, .jobs = given->jobs};
    if (first) {
        options.settings = given->settings;
        options.setting_count = given->setting_count;
        options.route = given->route;
        options.driving = given->driving;
    }
    return options;
}

/* Dismisses the faults of the last file that was not opened: the next one has its own. */
static void dismiss_failure(Window *window) {
    if (window->fault_dismissed < window->open_fault)
        window->fault_dismissed = window->open_fault;
}

/* Posts the faults of a file that was not opened. */
static void post_failure(Window *window, Fault *fault) {
    if (!fault->count)
        return;
    notice_fault(window, fault, NAN);
    window->open_fault = messages_last(&window->messages)->number;
}

static bool open_by(Window *window, size_t index, const char *path, const LaboratoryOptions *options, bool remembered) {
    Fault fault = {0};
    Tab *tab = &window->tabs[index];
    bool opened = tab_open(tab, path, options, window->screen, &fault);
    bool several = !opened && fault.count > 1;
    dismiss_failure(window);
    if (!opened) {
        post_failure(window, &fault);
    } else {
        notice_fault(window, &fault, NAN);
        autosave_restart(window, tab);
        if (path && remembered)
            settings_add_recent(&window->settings, path);
    }
    if (several && tab->session)
        dialog_pane_show(window, DIALOG_MESSAGES); /* all of them are seen */
    return opened;
}

static bool open_in(Window *window, size_t index, const char *path, const char *origin, bool remembered) {
    const char *first = window->options->file ? window->options->file : laboratory_file(0, &window->arena);
    bool given = path && strcmp(path, first) == 0 && !window->tabs[index].session;
    LaboratoryOptions options = options_of(window, given);
    options.origin = origin;
    return open_by(window, index, path, &options, remembered);
}

static void enter(Window *window, size_t index) {
    Tab *left = window_tab(window);
    if (window->current != index && left->session) {
        plan_input_reset(window);
        RecordSpan span = left->laboratory->span(left->session);
        player_pause(&left->player, &span);
    }
    Tab *entered = &window->tabs[index];
    window->current = index;
    entered->plot_panes_stale = true;
    window->dirty = true;
}

bool opening_copy(Window *window, const char *path, const char *origin, const char *mark) {
    Tab *tab = autosave_tab(window);
    size_t index = (size_t)(tab - window->tabs);
    plan_input_reset(window);
    if (!open_in(window, index, path, origin, false))
        return false;
    tab->mark = mark;
    memory_free(tab->path);
    tab->path = NULL;
    enter(window, index);
    return true;
}

/* Other programs' files -------------------------------------------------------------------------------------------- */

/* Posts what an import did and left out, one line each, then a summary. */
static void add_notes(Window *window, const char *path, const ImportFile *import) {
    for (size_t i = 0; i < import->notes.count; i++)
        notice_post(window, "%s: %s", path, import->notes.lines[i]);
    const char *more = import->notes.count ? " Press F7 for details." : "";
    if (import->left.text)
        notice_post(window, "Imported a new house from %s. Left out: %s.%s", import->format, import->left.text, more);
    else
        notice_post(window, "Imported a new house from %s.%s", import->format, more);
}

/* Opens the imported house from the recovery file, from which it can be recovered until it is saved. */
static bool open_text(Window *window, const char *path, const ImportFile *import) {
    RecoveryAbout about = {.name = import->name, .edits = 0, .when = (int64_t)time(NULL)};
    int error = recovery_write(window->recovery, import->text, &about);
    if (error) {
        notice_post(window, "%s cannot be imported: %s: %s", path, recovery_path(window->recovery),
                    file_write_reason(error));
        return false;
    }
    if (!opening_copy(window, recovery_path(window->recovery), NULL, " [Imported]"))
        return false;
    window->watch.waits = true;
    return true;
}

/* Asks in a dialog for the unit of a file. */
static void ask_unit(Window *window, const char *path, const ImportFile *import) {
    ImportAsk *ask = &window->import_ask;
    ask->count = import->choice_count;
    memcpy(ask->choices, import->choices, sizeof ask->choices);
    ask->width = import->width;
    snprintf(ask->path, sizeof ask->path, "%s", path);
    snprintf(window->field, sizeof window->field, "%.2f m", import->width * import->choices[0].metres);
    dialog_pane_show(window, DIALOG_UNIT);
}

bool opening_import(Window *window, const char *path, double unit) {
    ImportFile import = {.text = NULL};
    Fault fault = {0};
    int refusal = text_read_refusal(path);
    if (refusal) {
        notice_post(window, "%s cannot be read: %s", path, text_read_reason(refusal));
        return false;
    }
    bool read = window->recovery && import_file_read(&import, path, unit, &fault);
    if (import.choice_count && unit == 0) {
        ask_unit(window, path, &import);
        fault_clear(&fault);
        import_file_clear(&import);
        return false;
    }
    if (!window->recovery)
        notice_post(window, "%s cannot be imported: no folder for recovery files is writable", path);
    dismiss_failure(window);
    post_failure(window, &fault);
    read = read && open_text(window, path, &import);
    if (read)
        add_notes(window, path, &import);
    import_file_clear(&import);
    return read;
}

/* Files and tabs --------------------------------------------------------------------------------------------------- */

bool opening_file(Window *window, const char *path) {
    if (path && import_file_knows(path))
        return opening_import(window, path, 0);
    size_t index = path ? laboratory_of(path) : (size_t)(autosave_tab(window) - window->tabs);
    plan_input_reset(window);
    if (!open_in(window, index, path, NULL, true))
        return false;
    enter(window, index);
    return true;
}

bool opening_with(Window *window, size_t tab, const char *path, const char *const *settings, size_t count) {
    LaboratoryOptions options = options_of(window, false);
    options.settings = settings;
    options.setting_count = count;
    plan_input_reset(window);
    if (!open_by(window, tab, path, &options, false))
        return false;
    enter(window, tab);
    return true;
}

void opening_tab(Window *window, size_t index) {
    if (window->tabs[index].session || open_in(window, index, laboratory_file(index, &window->arena), NULL, true))
        enter(window, index);
}
