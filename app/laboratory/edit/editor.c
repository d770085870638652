#include "laboratory/edit/editor.h"

#include <stdio.h>

#include "plan/draft_file.h"
#include "laboratory/house/session_parts.h"

static const EditToolRow tools[EDIT_TOOLS] = {
    [TOOL_SELECT] = {"select", "Selects what is clicked on, and moves it by its handles.",
                     "click on something, or drag a rectangle round it"},
    [TOOL_WALL] = {"wall", "Draws walls, one after another.", "click where the wall begins, or Enter to type it"},
    [TOOL_DOOR] = {"door", "Places doors and openings in walls.", "click on a wall, or Enter to type the place"},
    [TOOL_FURNITURE] = {"furniture", "Places furniture, its back to a wall that is near.",
                        "click where it stands, or Enter to type the place; a free rectangle is dragged out"},
    [TOOL_PERSON] = {"person", "Places people, who look to where the hand is dragged.",
                     "click where somebody stands, or Enter to type the place"},
    [TOOL_EXIT] = {"exit", "Draws exits: lines that are left by.",
                   "click on a door, or where the exit begins, or Enter to type it"},
    [TOOL_MEASURE] = {"measure", "Measures how far two points are apart, and whether a chair goes through.",
                      "click two points, or double-click a side; Enter types them; Delete forgets what is measured"},
    [TOOL_AREA] = {"room", "Draws the outline of a room, to give it a name.",
                   "click the corners one after another, or Enter to type them"},
    [TOOL_ROUTE] = {"route", "Draws the way of the person who is selected, by points to the exit.",
                    "click the points to pass, at last the exit, or Enter to type them"},
    [TOOL_IMAGE] = {"picture", "Gives the picture that is traced over its scale, and makes it level.",
                    "click two points a known distance apart, then type it"},
};

/* Tools, hand and keys -------------------------------------------------------------------------------------------- */

/* A number that is in the hand is put down before something else is done. */
static HouseSession *settled(void *context) {
    HouseSession *live = context;
    if (live->held)
        house_change_settle(live);
    return live;
}

static void take(void *context, EditTool tool) {
    edit_pointer_take(settled(context), tool);
}

static EditTool tool(const void *context) {
    return ((const HouseSession *)context)->edit.tool;
}

static void point(void *context, const Pointer *hand) {
    edit_pointer_point(context, hand);
}

static void press(void *context, const Pointer *hand, bool twice) {
    edit_pointer_press(settled(context), hand, twice);
}

static void release(void *context, const Pointer *hand) {
    edit_pointer_release(context, hand);
}

static bool type(void *context, const char *letters) {
    return edit_pointer_type(settled(context), letters);
}

static bool enter(void *context) {
    return edit_pointer_enter(settled(context));
}

static bool back(void *context) {
    return edit_pointer_back(settled(context));
}

static bool tab(void *context, int step) {
    return edit_field_tab(context, step);
}

static bool escape(void *context) {
    return edit_pointer_escape(settled(context));
}

static const GestureView *gesture(const void *context) {
    return edit_marks_make((HouseSession *)context);
}

/* Selection ------------------------------------------------------------------------------------------------------- */

static const Item *selection(const void *context, size_t *count) {
    HouseSession *live = (HouseSession *)context;
    Editor *edit = &live->edit;
    edit_select_meet(live);
    *count = 0;
    edit->things = memory_reserve(edit->things, &edit->thing_capacity, edit->id_count, sizeof *edit->things);
    for (size_t i = 0; i < edit->id_count; i++) {
        Item thing = edit_select_thing(live, edit->ids[i]);
        if (thing.kind)
            edit->things[(*count)++] = thing;
    }
    return edit->things;
}

static void add(void *context, Item thing) {
    HouseSession *live = context;
    edit_select_meet(live);
    const char *id = edit_select_id(live, thing);
    if (*id)
        edit_select_toggle(live, id);
}

static void select_all(void *context) {
    edit_gesture_drop(context);
    edit_select_all(context);
}

static void handle(void *context, int step) {
    HouseSession *live = context;
    EditHandle handles[EDIT_HANDLES];
    edit_select_meet(live);
    int count = (int)edit_handle_list(live, draft_plan(live->draft), handles) + 1; /* and none of them */
    live->edit.handle = step ? (live->edit.handle + 1 + count + step % count) % count - 1 : -1;
}

/* What is selected is as it is when something is done to it. */
static HouseSession *ready(void *context) {
    HouseSession *live = settled(context);
    edit_gesture_drop(live);
    edit_select_meet(live);
    return live;
}

static bool nudge(void *context, Vec2 by, Fault *fault) {
    return edit_do_nudge(ready(context), by, fault);
}

static bool turn(void *context, double degrees, Fault *fault) {
    return edit_do_turn(ready(context), degrees, fault);
}

static bool topple(void *context, Fault *fault) {
    return edit_do_topple(ready(context), fault);
}

static bool split(void *context, Fault *fault) {
    return edit_split_wall(ready(context), fault);
}

static bool remove_selected(void *context, Fault *fault) {
    return edit_do_remove(ready(context), fault);
}

static bool duplicate(void *context, Fault *fault) {
    return edit_do_duplicate(ready(context), fault);
}

static char *copy(const void *context) {
    HouseSession *live = (HouseSession *)context;
    edit_select_meet(live);
    return edit_do_copy(live);
}

static bool paste(void *context, const char *text, Fault *fault) {
    return edit_do_paste(ready(context), text, fault);
}

/* Steps ----------------------------------------------------------------------------------------------------------- */

static bool step(void *context, bool (*go)(Draft *draft)) {
    HouseSession *live = settled(context);
    if (live->edit.gesture) {
        edit_gesture_drop(live);
        return true;
    }
    if (!go(live->draft))
        return false;
    edit_select_known(live);
    house_follow_edited(live);
    return true;
}

static bool undo(void *context) {
    return step(context, draft_undo);
}

static bool redo(void *context) {
    return step(context, draft_redo);
}

static const char *undo_name(const void *context) {
    return draft_undo_name(((const HouseSession *)context)->draft);
}

static const char *redo_name(const void *context) {
    return draft_redo_name(((const HouseSession *)context)->draft);
}

static void hold(void *context, const char *name) {
    HouseSession *live = ready(context);
    size_t row = house_value_find(&live->values, name);
    char step[2 * EDIT_NAME] = "Change a number";
    if (row != SIZE_MAX)
        snprintf(step, sizeof step, "%s: %s", live->values.rows[row].group, live->values.rows[row].label);
    house_change_hold(live, step);
}

static void settle(void *context) {
    settled(context);
}

/* Texts, items, files -----------------------------------------------------------------------------------------------
 */

static const EditText *texts(const void *context, size_t *count) {
    HouseSession *live = (HouseSession *)context;
    edit_select_meet(live);
    return edit_text_list(live, count);
}

static bool set_text(void *context, const char *name, const char *value, Fault *fault) {
    return edit_text_set(ready(context), name, value, fault);
}

static const CatalogueRow *items(const void *context, size_t *count) {
    return edit_items_list((HouseSession *)context, count);
}

static size_t item(const void *context) {
    const Editor *edit = &((const HouseSession *)context)->edit;
    return edit->items[edit->tool];
}

static void choose(void *context, size_t item) {
    HouseSession *live = context;
    size_t count;
    edit_items_list(live, &count);
    edit_gesture_drop(live);
    if (item < count)
        live->edit.items[live->edit.tool] = item;
}

static void ask(void *context) {
    edit_propose_ask(ready(context));
}

static const Proposal *proposals(const void *context, size_t *count, const char **doing) {
    return edit_propose_list((HouseSession *)context, count, doing);
}

static bool accept(void *context, size_t proposal, Fault *fault) {
    return edit_propose_accept(ready(context), proposal, fault);
}

static bool shake(void *context, Fault *fault) {
    return edit_shake_do(ready(context), fault);
}

static const char *shaken(const void *context) {
    return ((const HouseSession *)context)->edit.shaken;
}

static void animate(void *context, double seconds) {
    house_fall_move(context, seconds);
}

static const char *animation(const void *context) {
    return house_fall_words(context);
}

static bool set_image(void *context, const char *path, Fault *fault) {
    return edit_image_set(ready(context), path, fault);
}

static void fade(void *context, double opacity) {
    edit_image_fade(context, opacity);
}

static TraceImage image(const void *context) {
    return edit_image_get((HouseSession *)context);
}

static size_t edits(const void *context) {
    const HouseSession *live = context;
    size_t steps = draft_step_count(live->draft), saved = live->edit.saved_steps;
    return steps > saved ? steps - saved : saved - steps;
}

static bool changed(const void *context) {
    return draft_file_is_changed(((const HouseSession *)context)->draft);
}

static const char *text(const void *context) {
    return draft_text(((const HouseSession *)context)->draft);
}

static bool save(void *context, const char *path, Fault *fault) {
    HouseSession *live = ready(context);
    if (!draft_file_save(live->draft, path, fault))
        return false;
    live->edit.saved_steps = draft_step_count(live->draft);
    live->wish.path = arena_text(&live->arena, path);
    return true;
}

void editor_begin(HouseSession *live) {
    live->edit = (Editor){.handle = -1, .door_width = 0.8, .wall_thickness = 0.12};
}

void editor_clear(HouseSession *live) {
    Editor *edit = &live->edit;
    edit_gesture_drop(live);
    edit_propose_end(live);
    edit_shake_clear(live);
    edit_items_clear(live);
    for (size_t i = 0; i < edit->id_count; i++)
        memory_free(edit->ids[i]);
    memory_free(edit->ids);
    memory_free(edit->things);
    memory_free(edit->image);
    memory_free(edit->texts);
    arena_clear(&edit->text_arena);
    memory_free(edit->marks);
    arena_clear(&edit->words);
    memory_free(edit->doing.text);
}

const EditorFunctions house_editor = {
    .tools = tools,
    .take = take,
    .tool = tool,
    .point = point,
    .press = press,
    .release = release,
    .type = type,
    .enter = enter,
    .back = back,
    .tab = tab,
    .escape = escape,
    .gesture = gesture,
    .selection = selection,
    .add = add,
    .select_all = select_all,
    .handle = handle,
    .nudge = nudge,
    .turn = turn,
    .topple = topple,
    .split = split,
    .remove = remove_selected,
    .duplicate = duplicate,
    .copy = copy,
    .paste = paste,
    .undo = undo,
    .redo = redo,
    .undo_name = undo_name,
    .redo_name = redo_name,
    .hold = hold,
    .settle = settle,
    .texts = texts,
    .set_text = set_text,
    .items = items,
    .item = item,
    .choose = choose,
    .shake = shake,
    .shaken = shaken,
    .animate = animate,
    .animation = animation,
    .ask = ask,
    .proposals = proposals,
    .accept = accept,
    .set_image = set_image,
    .fade = fade,
    .image = image,
    .edits = edits,
    .changed = changed,
    .text = text,
    .save = save,
};
