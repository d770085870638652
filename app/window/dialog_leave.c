#include "window/dialog_leave.h"

#include "window/dialog_pane.h"
#include "window/files.h"
#include "window/lesson.h"
#include "window/plan_input.h"

/* Design points. */
#define WIDTH 660.0
#define HEIGHT 240.0
#define WIDE 860.0
#define HIGH 460.0
#define EDGE 24.0
#define LESSON_WIDTH 560.0
#define LESSON_HEIGHT 200.0
#define KEPT_HEIGHT 152.0
#define LESSON_LINE 28.0 /* what else is lost */

void dialog_leave_show(Window *window) {
    const Tab *tab = window_tab(window);
    size_t edits = tab_edit_count(tab);
    const char *title = tab->laboratory->title(tab->session);
    const char *words = !edits       ? text_in_arena(&window->arena, "%s is not saved yet.", title)
                        : edits == 1 ? text_in_arena(&window->arena, "%s has 1 unsaved edit.", title)
                                     : text_in_arena(&window->arena, "%s has %zu unsaved edits.", title, edits);
    bool loses = lesson_would_lose(window, window->leave, window->leave_path);
    dialog_pane_begin(window, dialog_pane_centred(window, WIDTH, HEIGHT + (loses ? LESSON_LINE : 0), EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Save before closing?");
    ui_text(window->ui, UI_BODY, ROLE_TEXT, words);
    ui_text(window->ui, UI_SMALL, ROLE_DIM_TEXT, tab->path ? tab->path : "It has no file yet.");
    if (loses)
        ui_text(window->ui, UI_BODY, ROLE_TEXT, "The guesses of the class and the place in the lesson are lost, too.");
    ui_row(window->ui, 3);
    bool saves =
        ui_button(window->ui, &(UiButton){.label = "Save", .help = "Save: Save to its file, or ask for a name"});
    bool drops = ui_button(window->ui, &(UiButton){.label = "Don't save", .help = "Don't save: Discard the edits"});
    if (ui_button(window->ui, &(UiButton){.label = "Cancel", .help = "Cancel (Escape): Return to the house"}))
        dialog_pane_close(window);
    else if (saves)
        files_save(window);
    else if (drops)
        files_finish_leaving(window);
    ui_pane_end(window->ui);
}

void dialog_leave_show_lesson(Window *window) {
    Leave leave = window->leave;
    bool last = lesson_is_last(window);
    dialog_pane_begin(window, dialog_pane_centred(window, LESSON_WIDTH, LESSON_HEIGHT, EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, last ? "End the lesson?" : "Leave the lesson?");
    bool kept = lesson_is_kept(window) && !last;
    const char *guesses = kept   ? "The guesses of the class and the place in the lesson are kept for the next time."
                          : last ? "The guesses of the class are forgotten; the next time, it restarts."
                                 : "The guesses of the class and the place in the lesson are lost.";
    ui_text(window->ui, UI_BODY, ROLE_TEXT,
            text_in_arena(&window->arena, "%s%s", guesses, leave ? "" : " What is open stays open, with its changes."));
    ui_row(window->ui, 2);
    bool stays = ui_button(window->ui, &(UiButton){.label = "Stay", .help = "Stay (Escape): Return to the lesson"});
    bool leaves =
        ui_button(window->ui, &(UiButton){.label = last ? "End" : "Leave",
                                          .help = kept ? "Leave: Keep the guesses" : "Leave: Forget the guesses"});
    ui_pane_end(window->ui);
    if (stays || leaves)
        dialog_pane_close(window);
    if (!leaves)
        return;
    lesson_end(window);
    window->leave = leave;
    if (leave)
        files_finish_leaving(window);
}

void dialog_leave_show_kept(Window *window) {
    const Progress *kept = lesson_kept(window);
    if (!kept) {
        dialog_pane_close(window);
        return;
    }
    int hands = progress_hands(kept);
    const char *counted = !hands       ? ""
                          : hands == 1 ? " 1 hand was counted."
                                       : text_in_arena(&window->arena, " %d hands were counted.", hands);
    dialog_pane_begin(window, dialog_pane_centred(window, LESSON_WIDTH, KEPT_HEIGHT, EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Go on with this lesson?");
    ui_text(window->ui, UI_BODY, ROLE_TEXT,
            text_in_arena(&window->arena,
                          "It was left in step %zu at %s.%s The house or machine is as the step begins.",
                          kept->step + 1, dialog_pane_when(window, kept->when), counted));
    ui_row(window->ui, 2);
    bool goes =
        ui_button(window->ui, &(UiButton){.label = "Go on", .help = "Go on (Escape): From the step where it was left"});
    bool restarts = ui_button(window->ui, &(UiButton){.label = "Restart", .help = "Restart: Forget the guesses"});
    ui_pane_end(window->ui);
    if (goes || restarts)
        dialog_pane_close(window);
    if (restarts)
        lesson_restart(window);
}

/* Shows a recovered file; true if it was opened or discarded, which changes the list. */
static bool show_found(Window *window, size_t index) {
    const RecoveryFound *found = &window->found[index];
    const char *edits = !found->edits       ? "not saved"
                        : found->edits == 1 ? "1 edit"
                                            : text_in_arena(&window->arena, "%zu edits", found->edits);
    ui_heading(window->ui,
               text_in_arena(&window->arena, "%s, %s, %s", found->name, dialog_pane_when(window, found->when), edits));
    ui_text(window->ui, UI_SMALL, ROLE_DIM_TEXT, text_in_arena(&window->arena, "Recovery file: %s", found->path));
    const char *origin = !found->origin ? "It had no file yet."
                         : found->origin_when
                             ? text_in_arena(&window->arena, "Its file: %s, saved %s", found->origin,
                                             dialog_pane_when(window, found->origin_when))
                             : text_in_arena(&window->arena, "Its file no longer exists: %s", found->origin);
    ui_text(window->ui, UI_SMALL, ROLE_DIM_TEXT, origin);
    ui_row(window->ui, 2);
    bool opens =
        ui_button(window->ui, &(UiButton){.id = text_in_arena(&window->arena, "open %zu", index),
                                          .label = "Open",
                                          .help = "Open: Open the recovered house; no file changes until you save"});
    bool forgets = ui_button(window->ui, &(UiButton){.id = text_in_arena(&window->arena, "forget %zu", index),
                                                     .label = "Discard",
                                                     .help = "Discard: Delete this recovery file"});
    if (opens)
        files_recover(window, index);
    else if (forgets)
        files_forget(window, index);
    return opens || forgets;
}

void dialog_leave_show_recovered(Window *window) {
    dialog_pane_begin(window, dialog_pane_centred(window, WIDE, HIGH, EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Recovered edits");
    ui_text(window->ui, UI_BODY, ROLE_TEXT,
            "The program ended before these edits were saved. The original files are unchanged.");
    bool changed = false;
    for (size_t i = 0; i < window->found_count && !changed; i++)
        changed = show_found(window, i);
    ui_gap(window->ui, 8);
    if (!changed &&
        ui_button(window->ui, &(UiButton){.label = "Later", .help = "Later (Escape): Ask again at the next start"}))
        dialog_pane_close(window);
    ui_pane_end(window->ui);
}
