/* Edits a house while it runs: tools, gestures, selection, undo. The window translates mouse and keys into these
 * calls and does not depend on walls and doors; the editor does not depend on pixels: all places are m on the floor.
 *
 * An editor changes a draft. It does not run or draw the house: the owner reports the displayed house
 * (editor_set_scene) and polls for changes (editor_next_change, editor_next_shake, editor_selected).
 *
 * A gesture is an edit in progress: a wall that is being drawn, a wardrobe that is being dragged. Dragging (press,
 * point, release), click-move-click (press and release on a handle without moving grabs it, the next press drops it)
 * and typing (choose a tool, Enter, numbers, Enter) are equivalent. During a gesture its result is checked, run in
 * the background and displayed; Escape restores exactly the previous state. Each gesture is one undo step. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

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
    TOOL_IMAGE, /* places the trace image: two points a known length apart, then two points on a level line */
    EDIT_TOOLS,
} EditTool;

typedef struct EditToolRow {
    const char *name;  /* "wall" */
    const char *help;  /* a sentence */
    const char *strip; /* what to do next before a gesture begins: "Click where the wall begins, or press Enter to type
                          the place." */
} EditToolRow;

/* The pointer on the plan. */
typedef struct Pointer {
    Vec2 at;       /* m */
    double reach;  /* m: items closer than this are hit */
    bool free;     /* snapping is off */
    bool straight; /* along one axis only */
    bool more;     /* extends the selection instead of replacing it */
    bool nowhere;  /* the pointer is not on the plan: the middle of the view is used */
} Pointer;

/* A number of a gesture that can be typed. */
typedef struct EditField {
    const char *name; /* "length" */
    const char *unit; /* "m", "degree" */
    double value;     /* from the pointer, or typed */
    bool typed;       /* it does not follow the pointer */
    bool moved;       /* typed not by digits but by arrows, or proposed */
} EditField;

typedef enum EditMarkKind {
    MARK_OUTLINE,   /* the item being made or moved, a closed line */
    MARK_LINE,      /* the item being made or moved, an open line */
    MARK_EXIT,      /* an exit that is placed, a line */
    MARK_RING,      /* a closed line round an opening that an exit could lie on, text beside it */
    MARK_SWING,     /* the leaf of a door and the way of its edge, an open line */
    MARK_GUIDE,     /* thin and dashed: the snap target */
    MARK_DIMENSION, /* a line with end ticks, text at its middle */
    MARK_SNAP,      /* a small diamond, text next to it: "end of w3" */
    MARK_START,     /* a small diamond: the first point of what is drawn */
    MARK_PLACE,     /* a cross: the place that arrows move */
    MARK_HANDLE,    /* a small square that can be grabbed; a disc for rotation */
    MARK_GAP,       /* a misfit or an overlap: bold, text at its middle */
} EditMarkKind;

enum { LABORATORY_MARK_POINTS = 64 };

typedef struct EditMark {
    EditMarkKind kind;
    Vec2 points[LABORATORY_MARK_POINTS]; /* (count) m */
    size_t count;
    const char *text; /* or NULL */
    bool round;       /* a handle that rotates the item */
    bool active;      /* a handle that is being dragged or has the keyboard focus */
} EditMark;

/* The gesture in progress and its marks; valid until the next call of the editor or update. */
typedef struct GestureView {
    bool active;          /* the clock must be paused */
    const char *doing;    /* "wall 2.50 m, 90 degrees", or the next action; never NULL */
    const char *refusal;  /* why the place is invalid, and which places are allowed; NULL: the place is valid */
    const char *preview;  /* what a click here does, or why it does nothing: "door: exit"; NULL: no words */
    bool preview_refused; /* the click does nothing */
    bool preview_warns;   /* the item would touch something */
    const EditMark *marks;
    size_t mark_count;
    const EditField *fields; /* numbers that can be typed now; Tab cycles through them */
    size_t field_count, field;
    const char *typed;       /* text typed into the field so far; "": none */
    const char *typed_error; /* why the typed text is not a value; NULL: the text is valid */
} GestureView;

/* An item that can be placed: a wardrobe of the catalogue, a profile. */
typedef struct CatalogueRow {
    const char *name;   /* "wardrobe" */
    const char *group;  /* "Japanese", "European" */
    const char *detail; /* "0.90 x 0.60 m, 1.80 m high" */
    Vec2 size;          /* m, of furniture on the floor; 0: none */
} CatalogueRow;

enum { EDITOR_TEXT_MOST = 4096 + 1 /* bytes of a text: the longest line that can be typed, and the zero */ };

/* A text of the selected item: a name, an id, a note. */
typedef struct EditText {
    const char *name;  /* "furniture.f3.name", "house.name" */
    const char *group; /* group heading, as in PanelParameter */
    const char *label; /* "name" */
    const char *value;
    const char *help; /* a sentence */
} EditText;

/* A change with which all people could leave. */
typedef struct Proposal {
    const char *text;            /* "Widen bedroom door from 0.75 m to 0.79 m" */
    const char *answer;          /* "all people are out in 21.3 s" */
    const char *size;            /* "4 cm": the size of the change */
    const char *const *settings; /* (setting_count) NAME=VALUE */
    size_t setting_count;
    Item item;         /* what is changed first, */
    const char *label; /* and its new width, "0.79 m"; NULL: it is not a width */
} Proposal;

enum { EDITOR_STEPS_MOST = 20 };

/* An undo step. */
typedef struct EditStep {
    const char *name; /* valid until the next edit */
    size_t number;    /* steps in effect just after it */
    time_t at;        /* when it was made; 0: unknown */
    bool done;        /* it is in effect, not undone */
} EditStep;

/* The picture to trace over (the trace image). */
typedef struct TraceImage {
    const char *path;
    Vec2 corners[4]; /* m: lower left, lower right, upper right, upper left */
    double opacity;  /* 0 to 1 */
} TraceImage;

/* Profiles, driving model and number of threads with which the editor runs the house. */
typedef struct EditorOptions {
    const char *path;     /* path of the house file; "": the house has no file yet */
    const char *profiles; /* directory of the shipped profiles */
    uint64_t seed;
    int driving; /* Driving, or -1 */
    int jobs;    /* threads */
} EditorOptions;

/* The displayed house; house NULL: nothing is displayed yet. */
typedef struct EditorScene {
    HouseScenery scenery;
    uint64_t revision; /* the draft's revision that this house was made from */
    double time;       /* s, the displayed time */
} EditorScene;

/* An earthquake made by editor_shake: the pieces with these ids (count) fell. */
typedef struct EditorShake {
    uint64_t seed;
    uint64_t standing; /* the same number for all earthquakes of the same house */
    const char *const *ids;
    size_t count;
} EditorShake;

/* Creates an editor. The draft stays the caller's and must outlive the editor. editor_destroy ends the editor's
 * threads and releases it. */
Editor *editor_create(Draft *draft, const EditorOptions *options);
void editor_destroy(Editor *editor);

/* Exchange with the owner of the editor --------------------------------------------------------------------------- */

void editor_set_scene(Editor *editor, const EditorScene *scene);
void editor_set_driving(Editor *editor, int driving);

/* Returns the path of the house file, "": none. The path changes when the house is saved; the text stays valid. */
const char *editor_path(const Editor *editor);

/* True once after each change of the draft, and after the end of each undo step. */
bool editor_next_change(Editor *editor);

/* True once after each earthquake, with the pieces that fell; the ids stay valid as long as the editor. */
bool editor_next_shake(Editor *editor, EditorShake *shake);

/* Returns the selected item of the displayed house: the last one of the selection. */
Item editor_selected(const Editor *editor);
void editor_set_selected(Editor *editor, Item item);

/* Starts dragging a number of the panel: all its changes until editor_end_number form one undo step, called `step`. */
void editor_begin_number(Editor *editor, const char *step);
bool editor_drags_number(Editor *editor);
void editor_end_number(Editor *editor);

/* Cancels the gesture or the dragged number, then restores the house of the file as one step. False: the draft was as
 * in the file. */
bool editor_reset(Editor *editor, const char *step);

/* Returns one line that says why the trace image is missing or differs from the original; NULL: it is unchanged, or
 * there is none. */
const char *editor_image_error(Editor *editor);

/* Tools, pointer and keys ------------------------------------------------------------------------------------------ */

const EditToolRow *editor_tool_row(EditTool tool);
void editor_set_tool(Editor *editor, EditTool tool); /* ends the gesture in progress */
EditTool editor_tool(const Editor *editor);

/* While `fixed`, the pointer selects walls, doors, rooms and exits, but does not move them. */
void editor_fix(Editor *editor, bool fixed);

/* Return what is fixed and selected, "walls", and what a drag tries to move all the same; NULL: nothing. */
const char *editor_fixed_selected(const Editor *editor);
const char *editor_fixed_dragged(const Editor *editor);

/* Goes on to what the house lacks, after the tool for it was taken. An exit that can only lie on one opening is placed
 * there. Once an exit is placed and nobody is in the house, the tool for people follows. */
void editor_cure(Editor *editor);

/* Pass the pointer's movement and the main button; `twice`: the second press of a double click. */
void editor_point(Editor *editor, const Pointer *pointer);
void editor_press(Editor *editor, const Pointer *pointer, bool twice);
void editor_release(Editor *editor, const Pointer *pointer);

/* Keys while the plan has the focus; true if the key was used. `type` takes characters that begin or continue a
 * number ("2", ",", "-", "c"); `enter` completes the gesture, or begins one with typed places; `back` removes the
 * last point or character; `tab` goes to the next field (-1: the previous field); `escape` cancels. */
bool editor_type(Editor *editor, const char *characters);
bool editor_enter(Editor *editor);
bool editor_back(Editor *editor);
bool editor_tab(Editor *editor, int step);
bool editor_escape(Editor *editor);

const GestureView *editor_gesture(Editor *editor);

/* Selection -------------------------------------------------------------------------------------------------------- */

/* Returns all selected items (count) of the displayed house. */
const Item *editor_selection(Editor *editor, size_t *count);
void editor_select_all(Editor *editor);

/* Cycles through the handles of the selected item; nudging moves the focused handle. Step 0: no handle. */
void editor_focus_handle(Editor *editor, int step);

/* Actions on the selection, each as one undo step; false: nothing changed, and the fault says why. A wall is split
 * in the middle of its segment nearest to the pointer; `paste` puts the pieces at the pointer. */
bool editor_nudge(Editor *editor, Vec2 by, Fault *fault);
bool editor_turn(Editor *editor, double degrees, Fault *fault);
bool editor_topple(Editor *editor, Fault *fault); /* topples the piece, or stands it up */
bool editor_can_topple(Editor *editor);           /* True if what is selected falls to a side */
bool editor_split(Editor *editor, Fault *fault);
bool editor_remove(Editor *editor, Fault *fault);
bool editor_duplicate(Editor *editor, Fault *fault);
char *editor_copy(Editor *editor); /* text for a clipboard, NULL: nothing is selected; release it with memory_free */
bool editor_paste(Editor *editor, const char *text, Fault *fault);

/* Makes an earthquake with the next seed. It starts from the house as it stood before the last earthquake if nothing
 * was edited since. `editor_shake_result`: "Shake 3: fallen pieces: 4 of 11". */
bool editor_shake(Editor *editor, Fault *fault);
const char *editor_shake_result(const Editor *editor);

/* Returns the earthquake whose outcome the house is, also after undoing; false: there is none. */
bool editor_last_shake(const Editor *editor, EditorShake *shake);

/* Stands up what fell in that earthquake, as one step. */
bool editor_stand_up(Editor *editor, Fault *fault);

/* Fixes a piece of furniture to the wall, as one step: it stands, and never falls. The house is then the outcome of the
 * same earthquake for the house with that piece fixed, since each piece falls or not on its own. */
bool editor_fix_to_wall(Editor *editor, Item item, Fault *fault);

/* Undo and redo; the names are for menus, NULL: there is nothing to undo or redo. */
bool editor_undo(Editor *editor);
bool editor_redo(Editor *editor);
const char *editor_undo_name(const Editor *editor);
const char *editor_redo_name(const Editor *editor);

/* Writes the last steps, oldest first, of which the later ones may be undone; returns how many. */
size_t editor_steps(const Editor *editor, EditStep steps[EDITOR_STEPS_MOST]);

/* Undoes or redoes steps until the first `number` of them are in effect. */
void editor_go_to_step(Editor *editor, size_t number);

/* True once after each new step. */
bool editor_next_step(Editor *editor);

/* Takes the tool that sets the scale of the house by two points and their real distance; true once after it was set. */
void editor_take_scale(Editor *editor);
bool editor_rescaled(Editor *editor);

/* Texts, catalogue, proposals, picture ---------------------------------------------------------------------------- */

const EditText *editor_texts(Editor *editor, size_t *count);
bool editor_set_text(Editor *editor, const char *name, const char *value, Fault *fault);

/* Returns the rows that the current tool can place, and the chosen row. */
const CatalogueRow *editor_items(Editor *editor, size_t *count);
size_t editor_item(const Editor *editor);
void editor_choose_item(Editor *editor, size_t item);

/* Searches in the background for changes that let all people leave. `doing`: the progress of the search, NULL: the
 * search is over. */
void editor_ask_proposals(Editor *editor);
const Proposal *editor_proposals(Editor *editor, size_t *count, const char **doing);
bool editor_accept(Editor *editor, size_t proposal, Fault *fault);

/* Chooses the proposal that is shown beside the plan. Returns a number that is the same for one proposal of one search
 * only; 0: none. */
void editor_choose_proposal(Editor *editor, size_t proposal);
uint64_t editor_chosen_proposal(Editor *editor, size_t *proposal);

/* Returns how many houses the search has tried so far; true while it searches. */
size_t editor_proposal_tries(const Editor *editor);
bool editor_seeks_proposals(const Editor *editor);

/* Returns the last measured distance, m; 0: none. Setting it scales the whole house, as one step. */
double editor_measured(const Editor *editor);
bool editor_set_measured(Editor *editor, double length, Fault *fault);

/* Drops the proposals, or the search for them. False: there were none. */
bool editor_drop_proposals(Editor *editor);

/* Moves the place of the gesture that was begun by keys; false: there is none. */
bool editor_move_gesture(Editor *editor, Vec2 by);

/* Sets the trace image; path NULL: none. */
bool editor_set_image(Editor *editor, const char *path, Fault *fault);
void editor_fade_image(Editor *editor, double opacity);
TraceImage editor_image(Editor *editor);

/* Files ------------------------------------------------------------------------------------------------------------ */

size_t editor_edit_count(const Editor *editor); /* undo steps since the file was read or saved */
uint64_t editor_revision(const Editor *editor); /* differs after every change, also within a gesture */
bool editor_is_changed(const Editor *editor);
const char *editor_text(const Editor *editor);                /* the house as file text, valid until the next call */
char *editor_text_of(const Editor *editor, const char *name); /* the same with another name; memory_free it */
bool editor_save(Editor *editor, const char *path, Fault *fault);
