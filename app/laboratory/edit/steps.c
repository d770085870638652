#include "laboratory/edit/steps.h"

#include "laboratory/edit/editor_state.h"

void edit_steps_note(Editor *edit) {
    size_t done = draft_step_count(edit->draft);
    uint64_t revision = done ? draft_step_revision(edit->draft, done - 1) : 0;
    if (revision <= edit->newest_step)
        return;
    edit->newest_step = revision;
    edit->has_new_step = true;
    edit->step_times[edit->step_time_count++ % EDITOR_STEPS_MOST] = (EditStepTime){revision, time(NULL)};
}

bool edit_steps_next(Editor *edit) {
    bool is_new = edit->has_new_step;
    edit->has_new_step = false;
    return is_new;
}

static time_t time_of(const Editor *edit, uint64_t revision) {
    for (size_t i = 0; i < EDITOR_STEPS_MOST && i < edit->step_time_count; i++)
        if (edit->step_times[i].revision == revision)
            return edit->step_times[i].at;
    return 0;
}

size_t edit_steps_list(const Editor *edit, EditStep steps[EDITOR_STEPS_MOST]) {
    size_t all = draft_step_total(edit->draft), done = draft_step_count(edit->draft);
    size_t first = all > EDITOR_STEPS_MOST ? all - EDITOR_STEPS_MOST : 0;
    for (size_t i = first; i < all; i++)
        steps[i - first] = (EditStep){.name = draft_step_name(edit->draft, i),
                                      .number = i + 1,
                                      .at = time_of(edit, draft_step_revision(edit->draft, i)),
                                      .done = i < done};
    return all - first;
}
