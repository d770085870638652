#include "laboratory/edit/editor.h"

#include "plan/draft_file.h"
#include "laboratory/edit/action.h"
#include "laboratory/edit/body.h"
#include "laboratory/edit/chain.h"
#include "laboratory/edit/exit.h"
#include "laboratory/edit/field.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/handle.h"
#include "laboratory/edit/image.h"
#include "laboratory/edit/marks.h"
#include "laboratory/edit/place.h"
#include "laboratory/edit/pointer.h"
#include "laboratory/edit/preview.h"
#include "laboratory/edit/propose.h"
#include "laboratory/edit/scale.h"
#include "laboratory/edit/select.h"
#include "laboratory/edit/shake.h"
#include "laboratory/edit/steps.h"
#include "laboratory/edit/text.h"
#include "laboratory/edit/tool_items.h"

static const EditToolRow tools[EDIT_TOOLS] = {
    [TOOL_SELECT] = {"select", "Select an item with a click, and move it by its handles.",
                     "Click an item, or drag a rectangle around several."},
    [TOOL_WALL] = {"wall", "Draw walls, one after another.",
                   "Click where the wall begins, or press Enter to type the place."},
    [TOOL_DOOR] = {"door", "Place doors and openings in walls.", "Click a wall, or press Enter to type the place."},
    [TOOL_FURNITURE] = {"furniture", "Place furniture, with its back to a near wall.",
                        "Click where the piece stands, or press Enter to type the place; drag a free rectangle."},
    [TOOL_PERSON] = {"person", "Place people; drag to turn them.",
                     "Click where the person stands, or press Enter to type the place."},
    [TOOL_EXIT] = {"exit", "Place exits on doors and openings; a solid wall gets a door.",
                   "Click a door, an opening or a wall, or press Enter to type the place."},
    [TOOL_MEASURE] =
        {"measure", "Measure a distance, and whether a chair fits through.",
         "Click two points, double-click a side, or press Enter to type them; Delete removes the measures."},
    [TOOL_AREA] = {"room", "Draw the outline of a room, to give it a name.",
                   "Double-click between walls, or click the corners one after another, or press Enter to type them."},
    [TOOL_ROUTE] = {"route", "Draw the route of the selected person, by points to the exit.",
                    "Click the points to pass, then the exit, or press Enter to type them."},
    [TOOL_IMAGE] = {"picture", "Set the scale of the picture to trace over, and level it.",
                    "Click two points a known distance apart, then type the distance."},
};

const EditToolRow *editor_tool_row(EditTool tool) {
    return &tools[tool];
}

Editor *editor_create(Draft *draft, const EditorOptions *options) {
    Editor *edit = memory_zeroed(1, sizeof *edit);
    edit->draft = draft;
    edit->options = *options;
    edit->options.path = arena_text(&edit->option_texts, options->path);
    edit->options.profiles = arena_text(&edit->option_texts, options->profiles);
    edit->handle = -1;
    edit->door_width = 0.8;
    edit->wall_thickness = 0.12;
    return edit;
}

void editor_destroy(Editor *edit) {
    edit_gesture_cancel(edit);
    edit_propose_end(edit);
    edit_shake_clear(edit);
    edit_tool_items_clear(edit);
    edit_body_clear(edit);
    edit_preview_clear(edit);
    for (size_t i = 0; i < edit->id_count; i++)
        memory_free(edit->ids[i]);
    memory_free(edit->ids);
    memory_free(edit->selected_items);
    memory_free(edit->image);
    memory_free(edit->texts);
    arena_clear(&edit->text_arena);
    memory_free(edit->marks);
    arena_clear(&edit->mark_texts);
    arena_clear(&edit->option_texts);
    memory_free(edit->doing.text);
    memory_free(edit);
}

/* Calls of the owner ---------------------------------------------------------------------------------------------- */

void editor_set_scene(Editor *edit, const EditorScene *scene) {
    edit->scene = *scene;
}

void editor_set_driving(Editor *edit, int driving) {
    edit->options.driving = driving;
}

const char *editor_path(const Editor *edit) {
    return edit->options.path;
}

bool editor_next_change(Editor *edit) {
    bool changed = edit->changed;
    edit->changed = false;
    edit_steps_note(edit);
    return changed;
}

bool editor_next_shake(Editor *edit, EditorShake *shake) {
    bool shook = edit->shook;
    edit->shook = false;
    if (shook) {
        const EditShake *last = &edit->shakes[edit->shake_count - 1];
        *shake = (EditorShake){last->seed, last->standing, last->ids, last->count};
    }
    return shook;
}

Item editor_selected(const Editor *edit) {
    return edit->selected;
}

void editor_set_selected(Editor *edit, Item item) {
    edit->selected = item;
}

void editor_end_number(Editor *edit) {
    Fault none = {0}; /* a refused value was reported when it was set */
    if (!edit->number_dragged)
        return;
    edit->number_dragged = false;
    draft_end(edit->draft, &none);
    fault_clear(&none);
    edit->changed = true;
}

/* Cancels the gesture and completes the dragged number, before another action on the selection. */
static void prepare(Editor *edit) {
    editor_end_number(edit);
    edit_gesture_cancel(edit);
    edit_select_sync(edit);
}

void editor_begin_number(Editor *edit, const char *step) {
    prepare(edit);
    draft_begin(edit->draft, step);
    edit->number_dragged = true;
}

bool editor_drags_number(Editor *edit) {
    edit->number_dragged = edit->number_dragged &&
                           draft_is_open(edit->draft); /* the end of the step also ends the dragging of its number */
    return edit->number_dragged;
}

bool editor_reset(Editor *edit, const char *step) {
    edit_gesture_cancel(edit);
    if (edit->number_dragged) {
        draft_cancel(edit->draft);
        edit->number_dragged = false;
        edit->changed = true;
    }
    uint64_t before = draft_revision(edit->draft);
    draft_file_reset(edit->draft, step);
    edit->changed |= draft_revision(edit->draft) != before;
    return draft_revision(edit->draft) != before;
}

const char *editor_image_error(Editor *edit) {
    return edit_image_error(edit);
}

/* Tools, pointer and keys ------------------------------------------------------------------------------------------ */

void editor_set_tool(Editor *edit, EditTool tool) {
    editor_end_number(edit);
    edit_pointer_set_tool(edit, tool);
}

void editor_cure(Editor *edit) {
    edit_place_cure(edit);
}

EditTool editor_tool(const Editor *edit) {
    return edit->tool;
}

void editor_fix(Editor *edit, bool fixed) {
    if (fixed != edit->fixed)
        edit->handle = -1;
    edit->fixed = fixed;
}

const char *editor_fixed_selected(const Editor *edit) {
    return edit_select_fixed(edit);
}

const char *editor_fixed_dragged(const Editor *edit) {
    return edit->down && edit->moved ? edit->fixed_pressed : NULL;
}

void editor_point(Editor *edit, const Pointer *pointer) {
    edit_pointer_move(edit, pointer);
}

void editor_press(Editor *edit, const Pointer *pointer, bool twice) {
    editor_end_number(edit);
    edit_pointer_press(edit, pointer, twice);
}

void editor_release(Editor *edit, const Pointer *pointer) {
    edit_pointer_release(edit, pointer);
}

bool editor_type(Editor *edit, const char *characters) {
    editor_end_number(edit);
    return edit_pointer_type(edit, characters);
}

bool editor_enter(Editor *edit) {
    editor_end_number(edit);
    return edit_pointer_enter(edit);
}

bool editor_back(Editor *edit) {
    editor_end_number(edit);
    return edit_pointer_back(edit);
}

bool editor_tab(Editor *edit, int step) {
    return edit_field_tab(edit, step);
}

bool editor_escape(Editor *edit) {
    editor_end_number(edit);
    return edit_pointer_escape(edit);
}

/* Returns the text of the tool's strip while there is no gesture. */
static const char *strip_text(Editor *edit) {
    const Plan *plan = draft_plan(edit->draft);
    const char *trouble = edit->tool == TOOL_IMAGE ? edit_image_error(edit) : NULL;
    if (trouble)
        return trouble;
    if (edit->tool == TOOL_IMAGE && !plan->background.image)
        return "First enter the picture's file in the panel.";
    if (edit->tool == TOOL_ROUTE && !edit_chain_route_person(edit))
        return "First place the person whose route you draw.";
    if ((edit->tool == TOOL_DOOR || edit->tool == TOOL_EXIT) && !plan->wall_count)
        return edit->tool == TOOL_DOOR ? "First draw a wall for the door." : "First draw a wall for the exit.";
    if (edit_scale_in_hand(edit))
        return "Click two points a known distance apart, then type that distance.";
    return tools[edit->tool].strip;
}

const GestureView *editor_gesture(Editor *edit) {
    return edit_marks_make(edit, edit_preview_make(edit), edit_exit_rings, edit->gesture ? "" : strip_text(edit));
}

/* Selection -------------------------------------------------------------------------------------------------------- */

const Item *editor_selection(Editor *edit, size_t *count) {
    edit_select_sync(edit);
    *count = 0;
    edit->selected_items =
        memory_reserve(edit->selected_items, &edit->selected_capacity, edit->id_count, sizeof *edit->selected_items);
    for (size_t i = 0; i < edit->id_count; i++) {
        Item item = edit_select_item(edit, edit->ids[i]);
        if (item.kind)
            edit->selected_items[(*count)++] = item;
    }
    return edit->selected_items;
}

void editor_select_all(Editor *edit) {
    edit_gesture_cancel(edit);
    edit_select_all(edit);
}

void editor_focus_handle(Editor *edit, int step) {
    EditHandle handles[EDIT_HANDLES];
    edit_select_sync(edit);
    int count =
        (int)edit_handle_list(edit, draft_plan(edit->draft), handles) + 1; /* and the position without a handle */
    edit->handle = step ? (edit->handle + 1 + count + step % count) % count - 1 : -1;
}

bool editor_nudge(Editor *edit, Vec2 by, Fault *fault) {
    prepare(edit);
    return edit_action_nudge(edit, by, fault);
}

bool editor_turn(Editor *edit, double degrees, Fault *fault) {
    prepare(edit);
    return edit_action_turn(edit, degrees, fault);
}

bool editor_topple(Editor *edit, Fault *fault) {
    prepare(edit);
    return edit_action_topple(edit, fault);
}

bool editor_can_topple(Editor *edit) {
    return edit_action_can_topple(edit);
}

bool editor_split(Editor *edit, Fault *fault) {
    prepare(edit);
    return edit_action_split(edit, fault);
}

bool editor_remove(Editor *edit, Fault *fault) {
    prepare(edit);
    return edit_action_remove(edit, fault);
}

bool editor_duplicate(Editor *edit, Fault *fault) {
    prepare(edit);
    return edit_action_duplicate(edit, fault);
}

char *editor_copy(Editor *edit) {
    edit_select_sync(edit);
    return edit_action_copy(edit);
}

bool editor_paste(Editor *edit, const char *text, Fault *fault) {
    prepare(edit);
    return edit_action_paste(edit, text, fault);
}

bool editor_shake(Editor *edit, Fault *fault) {
    prepare(edit);
    return edit_shake_do(edit, fault);
}

const char *editor_shake_result(const Editor *edit) {
    return edit->shaken;
}

bool editor_last_shake(const Editor *edit, EditorShake *shake) {
    const EditShake *last = edit_shake_last(edit);
    if (last)
        *shake = (EditorShake){last->seed, last->standing, last->ids, last->count};
    return last;
}

bool editor_stand_up(Editor *edit, Fault *fault) {
    prepare(edit);
    return edit_shake_stand_up(edit, fault);
}

bool editor_fix_to_wall(Editor *edit, Item item, Fault *fault) {
    prepare(edit);
    return edit_shake_fix(edit, edit_select_id(edit, item), fault);
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

static bool step(Editor *edit, bool (*go)(Draft *draft)) {
    editor_end_number(edit);
    if (edit->gesture) {
        edit_gesture_cancel(edit);
        return true;
    }
    if (!go(edit->draft))
        return false;
    edit_select_prune(edit);
    edit->changed = true;
    return true;
}

bool editor_undo(Editor *edit) {
    return step(edit, draft_undo);
}

bool editor_redo(Editor *edit) {
    return step(edit, draft_redo);
}

const char *editor_undo_name(const Editor *edit) {
    return draft_undo_name(edit->draft);
}

const char *editor_redo_name(const Editor *edit) {
    return draft_redo_name(edit->draft);
}

size_t editor_steps(const Editor *edit, EditStep steps[EDITOR_STEPS_MOST]) {
    return edit_steps_list(edit, steps);
}

void editor_go_to_step(Editor *edit, size_t number) {
    while (draft_step_count(edit->draft) > number && editor_undo(edit))
        continue;
    while (draft_step_count(edit->draft) < number && editor_redo(edit))
        continue;
}

bool editor_next_step(Editor *edit) {
    return edit_steps_next(edit);
}

/* Texts, catalogue, proposals, picture ---------------------------------------------------------------------------- */

const EditText *editor_texts(Editor *edit, size_t *count) {
    edit_select_sync(edit);
    return edit_text_list(edit, count);
}

bool editor_set_text(Editor *edit, const char *name, const char *value, Fault *fault) {
    prepare(edit);
    return edit_text_set(edit, name, value, fault);
}

const CatalogueRow *editor_items(Editor *edit, size_t *count) {
    return edit_tool_items_list(edit, count);
}

size_t editor_item(const Editor *edit) {
    return edit->chosen_rows[edit->tool];
}

void editor_choose_item(Editor *edit, size_t item) {
    size_t count;
    edit_tool_items_list(edit, &count);
    edit_gesture_cancel(edit);
    if (item < count)
        edit->chosen_rows[edit->tool] = item;
}

void editor_ask_proposals(Editor *edit) {
    prepare(edit);
    edit_propose_ask(edit);
}

const Proposal *editor_proposals(Editor *edit, size_t *count, const char **doing) {
    return edit_propose_list(edit, count, doing);
}

bool editor_accept(Editor *edit, size_t proposal, Fault *fault) {
    prepare(edit);
    return edit_propose_accept(edit, proposal, fault);
}

void editor_choose_proposal(Editor *edit, size_t proposal) {
    edit_propose_choose(edit, proposal);
}

uint64_t editor_chosen_proposal(Editor *edit, size_t *proposal) {
    return edit_propose_chosen(edit, proposal);
}

size_t editor_proposal_tries(const Editor *edit) {
    return edit_propose_tries(edit);
}

bool editor_seeks_proposals(const Editor *edit) {
    return edit_propose_seeks(edit);
}

double editor_measured(const Editor *edit) {
    if (!edit->measure_count)
        return 0;
    const EditMeasure *last = &edit->measures[edit->measure_count - 1];
    return vec2_distance(last->from, last->to);
}

bool editor_set_measured(Editor *edit, double length, Fault *fault) {
    prepare(edit);
    return edit_scale_set(edit, length, fault);
}

void editor_take_scale(Editor *edit) {
    editor_set_tool(edit, TOOL_MEASURE);
    editor_choose_item(edit, ITEM_SET_SCALE);
}

bool editor_rescaled(Editor *edit) {
    bool was = edit->rescaled;
    edit->rescaled = false;
    return was;
}

bool editor_drop_proposals(Editor *edit) {
    return edit_propose_drop(edit);
}

bool editor_move_gesture(Editor *edit, Vec2 by) {
    return edit_pointer_nudge(edit, by);
}

bool editor_set_image(Editor *edit, const char *path, Fault *fault) {
    prepare(edit);
    return edit_image_set(edit, path, fault);
}

void editor_fade_image(Editor *edit, double opacity) {
    edit_image_fade(edit, opacity);
}

TraceImage editor_image(Editor *edit) {
    return edit_image_get(edit);
}

/* Files ------------------------------------------------------------------------------------------------------------ */

uint64_t editor_revision(const Editor *edit) {
    return draft_revision(edit->draft);
}

size_t editor_edit_count(const Editor *edit) {
    size_t steps = draft_step_count(edit->draft), saved = edit->saved_steps;
    return steps > saved ? steps - saved : saved - steps;
}

bool editor_is_changed(const Editor *edit) {
    return draft_file_is_changed(edit->draft);
}

const char *editor_text(const Editor *edit) {
    return draft_text(edit->draft);
}

char *editor_text_of(const Editor *edit, const char *name) {
    Plan plan = *draft_plan(edit->draft);
    plan.name = name;
    return plan_text(&plan);
}

bool editor_save(Editor *edit, const char *path, Fault *fault) {
    prepare(edit);
    if (!draft_file_save(edit->draft, path, fault))
        return false;
    edit->saved_steps = draft_step_count(edit->draft);
    edit->options.path = arena_text(&edit->option_texts, path);
    return true;
}
