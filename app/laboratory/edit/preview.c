#include "laboratory/edit/preview.h"

#include "laboratory/edit/gesture.h"
#include "laboratory/edit/marks.h"
#include "laboratory/edit/place.h"

static bool can_show(const Editor *edit) {
    const Plan *plan = draft_plan(edit->draft);
    bool walls = plan->wall_count, rectangle = edit->chosen_rows[TOOL_FURNITURE] == 0;
    if (!edit->seen || edit->placed || edit->down || draft_is_open(edit->draft))
        return false;
    return edit->tool == TOOL_PERSON || (edit->tool == TOOL_FURNITURE && !rectangle) ||
           ((edit->tool == TOOL_DOOR || edit->tool == TOOL_EXIT) && walls);
}

static bool is_known(const Editor *edit) {
    const EditPreview *preview = &edit->preview;
    const Pointer *a = &preview->pointer, *b = &edit->pointer;
    return preview->known && preview->revision == draft_revision(edit->draft) && preview->tool == edit->tool &&
           preview->row == edit->chosen_rows[edit->tool] && a->at.x == b->at.x && a->at.y == b->at.y &&
           a->reach == b->reach && a->free == b->free;
}

/* Copies the marks from `first` on into the preview. */
static void keep_marks(Editor *edit, size_t first) {
    EditPreview *preview = &edit->preview;
    arena_clear(&preview->texts);
    preview->mark_count = 0;
    for (size_t i = first; i < edit->mark_count; i++) {
        preview->marks =
            memory_reserve(preview->marks, &preview->mark_capacity, preview->mark_count + 1, sizeof *preview->marks);
        EditMark *mark = &preview->marks[preview->mark_count++];
        *mark = edit->marks[i];
        mark->text = mark->text ? arena_text(&preview->texts, mark->text) : NULL;
    }
}

static void write_words(Editor *edit) {
    EditPreview *preview = &edit->preview;
    const char *touched = edit->gesture->warn ? edit->gesture->warn(edit) : NULL;
    memory_free(preview->words.text);
    preview->words = (Text){0};
    preview->refused = edit->refusal && !edit->limited;
    preview->warns = touched && !preview->refused;
    text_add(&preview->words, "");
    if (preview->refused)
        text_add(&preview->words, edit->refusal);
    else if (touched)
        text_format(&preview->words, "touches %s", touched);
    else if (edit->gesture->promise)
        edit->gesture->promise(edit, &preview->words);
}

static void make(Editor *edit) {
    EditPreview *preview = &edit->preview;
    bool changed = edit->changed;
    size_t first = edit->mark_count;
    edit_place_begin(edit, false);
    edit->gesture->show(edit);
    edit_marks_snap(edit);
    keep_marks(edit, first);
    edit->mark_count = first;
    write_words(edit);
    edit_gesture_cancel(edit);
    edit->changed = changed;
    preview->pointer = edit->pointer;
    preview->revision = draft_revision(edit->draft);
    preview->tool = edit->tool;
    preview->row = edit->chosen_rows[edit->tool];
    preview->known = true;
}

const EditPreview *edit_preview_make(Editor *edit) {
    if (edit->gesture || !can_show(edit))
        return NULL;
    if (!is_known(edit))
        make(edit);
    return &edit->preview;
}

void edit_preview_clear(Editor *edit) {
    memory_free(edit->preview.marks);
    memory_free(edit->preview.words.text);
    arena_clear(&edit->preview.texts);
    edit->preview = (EditPreview){.known = false};
}
