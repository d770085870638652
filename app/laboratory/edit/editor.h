/* Editing a house while it runs: tools, gestures, selection, undo. The window turns mouse and keys into these calls and
 * knows nothing of walls and doors; the editor knows no pixels: all places are m on the floor.
 *
 * An editor changes a draft. It does not know who runs and draws the house: the owner tells it what is displayed
 * (editor_set_scene) and asks it for what has changed since (editor_next_change, editor_next_shake, editor_selected).
 *
 * A gesture is an edit in progress: a wall that is being drawn, a wardrobe that is dragged. Dragging (press,
 * point, release), click-move-click (press and release on a handle without moving takes it up, the next press puts it
 * down) and typing (take a tool, Enter, numbers, Enter) do the same. While a gesture lasts what it would make is
 * checked, run in the background and shown; Escape leaves exactly what was before. Each gesture is one step of undo. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "plan/draft.h"
#include "laboratory/house_items.h"
#include "laboratory/laboratory.h"

typedef enum EditTool {
    TOOL_SELECT,
    TOOL_WALL,
    TOOL_DOOR,
    TOOL_FURNITURE,
    TOOL_PERSON,
    TOOL_EXIT,
    TOOL_MEASURE,
    TOOL_AREA,
    TOOL_ROUTE,
    TOOL_IMAGE, /* places the picture to trace over: two points a known length apart, then two on a level line */
    EDIT_TOOLS,
} EditTool;

typedef struct EditToolRow {
    const char *name;  /* "wall" */
    const char *help;  /* a sentence */
    const char *strip; /* what to do next, before anything is begun: "Click where the wall begins, or press Enter to
                          type the place." */
} EditToolRow;

/* The pointer on the plan. */
typedef struct Pointer {
    Vec2 at;       /* m */
    double reach;  /* m: what is nearer than this is meant */
    bool free;     /* no snapping now */
    bool straight; /* along one axis only */
    bool more;     /* to what is selected already, not in its place */
    bool nowhere;  /* the pointer is not on the plan: the middle of the view is meant */
} Pointer;

/* A number of a gesture that can be typed. */
typedef struct EditField {
    const char *name; /* "length" */
    const char *unit; /* "m", "degree" */
    double value;     /* by the pointer, or as typed */
    bool typed;
} EditField;

typedef enum EditMarkKind {
    MARK_OUTLINE,   /* what is being made or moved, a closed line */
    MARK_LINE,      /* the same, open */
    MARK_GUIDE,     /* thin and dashed: what it is snapped to */
    MARK_DIMENSION, /* a line with ends, words at its middle */
    MARK_SNAP,      /* a small diamond, words beside it: "end of w3" */
    MARK_HANDLE,    /* a small square that can be taken up; a disc where it turns something */
    MARK_GAP,       /* what does not fit or overlaps: bold, words at its middle */
} EditMarkKind;

enum { LABORATORY_MARK_POINTS = 64 };

typedef struct EditMark {
    EditMarkKind kind;
    Vec2 points[LABORATORY_MARK_POINTS]; /* (count) m */
    size_t count;
    const char *words; /* or NULL */
    bool round;        /* of a handle: it turns something */
    bool held;         /* of a handle: it is dragged, or has the keyboard focus */
} EditMark;

/* The gesture in progress and its marks; good until the next call of the editor or update. */
typedef struct GestureView {
    bool active;         /* the clock is to be held */
    const char *doing;   /* "wall 2.50 m, 90 degrees"; or what to do next; never NULL */
    const char *refusal; /* why it cannot be placed there, and what is allowed; NULL: it can */
    const EditMark *marks;
    size_t mark_count;
    const EditField *fields; /* that can be typed now, Tab goes round */
    size_t field_count, field;
    const char *typed; /* so far, into the field; "" : nothing */
    const char *wrong; /* why the typed text is not a value; NULL: it is one */
} GestureView;

/* Something that is placed: a wardrobe of a catalogue, a profile. */
typedef struct CatalogueRow {
    const char *name;  /* "wardrobe" */
    const char *group; /* "Japanese", "European" */
    const char *words; /* "0.90 x 0.60 m, 1.80 m high" */
} CatalogueRow;

/* A word or a text of what is selected: names, ids, notes. */
typedef struct EditText {
    const char *name;  /* "furniture.f3.name", "house.name" */
    const char *group; /* as of a PanelParameter */
    const char *label; /* "name" */
    const char *value;
    const char *help; /* a sentence */
} EditText;

/* A change with which all people could leave. */
typedef struct Proposal {
    const char *words;  /* "Widen door d2 from 0.75 m to 0.79 m" */
    const char *answer; /* "everybody out in 21.3 s" */
} Proposal;

/* The picture to trace over. */
typedef struct TraceImage {
    const char *path;
    Vec2 corners[4]; /* m: lower left, lower right, upper right, upper left */
    double opacity;  /* 0 to 1 */
} TraceImage;

/* With whose profiles, seed and driving model the house is run, and by how many threads. */
typedef struct EditorOptions {
    const char *path;     /* of the house file; "": it has none yet */
    const char *profiles; /* directory of the shipped profiles */
    uint64_t seed;
    int driving; /* Driving, or -1 */
    int jobs;    /* threads */
} EditorOptions;

/* The house that is displayed; house NULL: nothing is displayed yet. */
typedef struct EditorScene {
    HouseScenery scenery;
    uint64_t revision; /* of the draft that this house was made from */
    double time;       /* s, that is displayed */
} EditorScene;

/* An earthquake that was made by editor_shake: the pieces with these ids (count) fell. */
typedef struct EditorShake {
    uint64_t seed;
    const char *const *ids;
    size_t count;
} EditorShake;

/* The draft stays the caller's and must outlive the editor. editor_destroy releases the editor with its threads. */
Editor *editor_create(Draft *draft, const EditorOptions *options);
void editor_destroy(Editor *editor);

/* What the owner of the editor tells it and asks it -----------------------------------------------------------------
 */

void editor_set_scene(Editor *editor, const EditorScene *scene);
void editor_set_driving(Editor *editor, int driving);

/* The file of the house, "": it has none; it changes when the house is saved. The text stays good. */
const char *editor_path(const Editor *editor);

/* True once after each change of the draft, and after the end of a step. */
bool editor_next_change(Editor *editor);

/* True once after each earthquake, with what fell in it; the ids stay good as long as the editor. */
bool editor_next_shake(Editor *editor, EditorShake *shake);

/* The selected item of the displayed house: the last one of the selection. */
Item editor_selected(const Editor *editor);
void editor_set_selected(Editor *editor, Item item);

/* A number of the panel is being dragged: all its changes are one step, called `step`, until editor_settle. */
void editor_hold_number(Editor *editor, const char *step);
bool editor_holds_number(Editor *editor);
void editor_settle(Editor *editor);

/* Sets all numbers back to those in the file, as one step. */
void editor_reset(Editor *editor, const char *step);

/* Why the picture to trace over is missing or another one, in a line; NULL: it is as it was, or there is none. */
const char *editor_image_trouble(Editor *editor);

/* Tools, pointer and keys ------------------------------------------------------------------------------------------ */

const EditToolRow *editor_tool_row(EditTool tool);
void editor_set_tool(Editor *editor, EditTool tool); /* a gesture that was begun ends */
EditTool editor_tool(const Editor *editor);

/* `press` and `release` are of the main button; `twice`: the second press of a double click. */
void editor_point(Editor *editor, const Pointer *pointer);
void editor_press(Editor *editor, const Pointer *pointer, bool twice);
void editor_release(Editor *editor, const Pointer *pointer);

/* Keys while the plan has the focus; true if the key was used. `type` takes characters that begin or continue a number
 * ("2", ",", "-", "c"); `enter` completes the gesture, or begins one with typed places; `back` removes the last point
 * or character; `tab` goes to the next field (-1: the one before); `escape` cancels. */
bool editor_type(Editor *editor, const char *letters);
bool editor_enter(Editor *editor);
bool editor_back(Editor *editor);
bool editor_tab(Editor *editor, int step);
bool editor_escape(Editor *editor);

const GestureView *editor_gesture(Editor *editor);

/* Selection -------------------------------------------------------------------------------------------------------- */

/* All selected items (count) of the displayed house. */
const Item *editor_selection(Editor *editor, size_t *count);
void editor_toggle(Editor *editor, Item item); /* adds it to the selection, or takes it away */
void editor_select_all(Editor *editor);

/* Goes round the handles of the selected item, so that a nudge moves that handle; step 0: no handle. */
void editor_focus_handle(Editor *editor, int step);

/* Done to the selection, each as one step; false: nothing was done, and the fault says why. A wall is split in the
 * middle of its segment nearest to the pointer; `paste` puts the pieces at the pointer. */
bool editor_nudge(Editor *editor, Vec2 by, Fault *fault);
bool editor_turn(Editor *editor, double degrees, Fault *fault);
bool editor_topple(Editor *editor, Fault *fault); /* or stands it up */
bool editor_split(Editor *editor, Fault *fault);
bool editor_remove(Editor *editor, Fault *fault);
bool editor_duplicate(Editor *editor, Fault *fault);
char *editor_copy(Editor *editor); /* text for a clipboard, NULL: nothing is selected; memory_free it */
bool editor_paste(Editor *editor, const char *text, Fault *fault);

/* Makes an earthquake with the next seed, of the house as it stood before the last earthquake if nothing was edited
 * since. `editor_shake_result`: "shake 3: 4 of 11 pieces fell". */
bool editor_shake(Editor *editor, Fault *fault);
const char *editor_shake_result(const Editor *editor);

/* Undo; the names are for menus, NULL: there is nothing to undo or redo. */
bool editor_undo(Editor *editor);
bool editor_redo(Editor *editor);
const char *editor_undo_name(const Editor *editor);
const char *editor_redo_name(const Editor *editor);

/* Texts, catalogue, proposals, picture ------------------------------------------------------------------------------
 */

const EditText *editor_texts(Editor *editor, size_t *count);
bool editor_set_text(Editor *editor, const char *name, const char *value, Fault *fault);

/* The rows that the current tool can place, and the chosen one. */
const CatalogueRow *editor_items(Editor *editor, size_t *count);
size_t editor_item(const Editor *editor);
void editor_choose_item(Editor *editor, size_t item);

/* Looks in the background for changes that let all people leave. `doing`: how far the search is, NULL: it is over. */
void editor_ask_proposals(Editor *editor);
const Proposal *editor_proposals(Editor *editor, size_t *count, const char **doing);
bool editor_accept(Editor *editor, size_t proposal, Fault *fault);

/* The picture to trace over; path NULL: none. */
bool editor_set_image(Editor *editor, const char *path, Fault *fault);
void editor_fade_image(Editor *editor, double opacity);
TraceImage editor_image(Editor *editor);

/* Files ------------------------------------------------------------------------------------------------------------ */

size_t editor_edit_count(const Editor *editor); /* steps since the file was read or saved */
bool editor_is_changed(const Editor *editor);
const char *editor_text(const Editor *editor); /* the text that a file would hold, good until the next call */
bool editor_save(Editor *editor, const char *path, Fault *fault);
