#include "laboratory/edit/preview.h"

#include "laboratory/edit/chain.h"
#include "laboratory/edit/enclosure.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/marks.h"
#include "laboratory/edit/place.h"
#include "laboratory/edit/scale.h"

static bool can_show(const Editor *edit) {
    return edit->tool != TOOL_SELECT && edit->seen && !edit->placed && !edit->down && !draft_is_open(edit->draft);
}

/* True if a click places one item, which then can be drawn before the click; otherwise it sets a first point. */
static bool places(const Editor *edit) {
    return edit->tool == TOOL_PERSON || (edit->tool == TOOL_FURNITURE && edit->chosen_rows[TOOL_FURNITURE]) ||
           ((edit->tool == TOOL_DOOR || edit->tool == TOOL_EXIT) && draft_plan(edit->draft)->wall_count);
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

/* Returns what a click begins, or why it begins nothing. */
static const char *beginning(const Editor *edit, bool *refused) {
    const Plan *plan = draft_plan(edit->draft);
    Vec2 outline[LABORATORY_MARK_POINTS];
    *refused = false;
    if (edit_scale_in_hand(edit))
        return "the known distance begins here";
    switch (edit->tool) {
    case TOOL_WALL:
        return "wall begins here";
    case TOOL_MEASURE:
        return "distance begins here";
    case TOOL_FURNITURE:
        return "first corner of the piece, drag to the other";
    case TOOL_AREA:
        return enclosure_find(plan, edit->pointer.at, outline, LABORATORY_MARK_POINTS)
                   ? "first corner of a room; twice: all between these walls"
                   : "first corner of a room";
    case TOOL_ROUTE:
        *refused = !edit_chain_route_person(edit);
        return *refused ? "nobody is here: P places somebody" : "route begins here";
    case TOOL_IMAGE:
        *refused = !plan->background.image;
        return *refused ? "no picture yet: type its file in the panel" : "first of two points of the picture";
    default:
        *refused = true;
        return "no wall yet: W draws one";
    }
}

static void keep_key(Editor *edit) {
    EditPreview *preview = &edit->preview;
    preview->pointer = edit->pointer;
    preview->revision = draft_revision(edit->draft);
    preview->tool = edit->tool;
    preview->row = edit->chosen_rows[edit->tool];
    preview->known = true;
}

static void make_beginning(Editor *edit) {
    EditPreview *preview = &edit->preview;
    keep_marks(edit, edit->mark_count);
    memory_free(preview->words.text);
    preview->words = (Text){0};
    text_add(&preview->words, beginning(edit, &preview->refused));
    preview->warns = false;
    preview->begins = true;
    keep_key(edit);
}

static void make(Editor *edit) {
    EditPreview *preview = &edit->preview;
    preview->begins = false;
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
    keep_key(edit);
}

const EditPreview *edit_preview_make(Editor *edit) {
    if (edit->gesture || !can_show(edit))
        return NULL;
    if (!is_known(edit) && places(edit))
        make(edit);
    else if (!is_known(edit))
        make_beginning(edit);
    return &edit->preview;
}

void edit_preview_clear(Editor *edit) {
    memory_free(edit->preview.marks);
    memory_free(edit->preview.words.text);
    arena_clear(&edit->preview.texts);
    edit->preview = (EditPreview){.known = false};
}
