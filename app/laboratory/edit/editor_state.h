/* The state of an editor, for the files of this folder only.
 *
 * A gesture is a table of functions. `follow` turns the pointer and the typed numbers into a target; `make` turns
 * the target into changes of the draft. Both are repeated whenever the pointer moves: the step is rewound, made, and
 * tried.
 *
 *     pointer, fields -> follow -> now -> make -> draft_try -> good, or a refusal */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"
#include "base/text.h"
#include "plan/catalogue.h"
#include "plan/draft.h"
#include "plan/snap_piece.h"
#include "laboratory/edit/editor.h"

typedef struct EditSearch EditSearch;

enum {
    EDIT_FIELDS = 6,
    EDIT_TYPED = 48,    /* characters of a number that is being typed */
    EDIT_NAME = 128,    /* characters of the name of a step or an item */
    EDIT_HANDLES = 128, /* handles of the selection */
    EDIT_MEASURES = 32, /* measured distances displayed at once */
};

/* The target of a gesture. */
typedef struct EditTarget {
    Vec2 at;       /* m: the target place of the item, the handle or the next point */
    Vec2 corner;   /* m: first corner of the drawn rectangle */
    Vec2 size;     /* m: size of a piece of furniture */
    double angle;  /* degree */
    double amount; /* m: thickness of a wall, width of a door */
    double along;  /* m: the middle of a door along its segment */
    size_t wall, segment;
} EditTarget;

typedef struct EditGesture {
    void (*follow)(Editor *edit);
    void (*make)(Editor *edit);  /* NULL: the gesture does not change the draft */
    bool (*limit)(Editor *edit); /* moves a refused target to the nearest valid place; NULL or false: there is none */
    bool (*put)(Editor *edit, bool keys);      /* a press, or Enter */
    bool (*back)(Editor *edit);                /* Backspace; NULL: cancels the gesture */
    bool (*escape)(Editor *edit);              /* Escape; NULL: cancels the gesture */
    void (*release)(Editor *edit, bool moved); /* of the press that began the gesture, or of a later press */
    void (*say)(Editor *edit, Text *words);
    void (*show)(Editor *edit); /* adds marks */
    void (*end)(Editor *edit);  /* releases the data of the gesture; NULL: there are none */
} EditGesture;

/* The kinds of handles of an item. */
typedef enum EditGrip {
    GRIP_POINT,   /* a point of a wall, an outline or a route; an end of an exit */
    GRIP_SEGMENT, /* the middle of a wall's segment */
    GRIP_EDGE,    /* an edge of a door: changes its width */
    GRIP_CORNER,  /* a corner of a piece of furniture: changes its size */
    GRIP_TURN,
    GRIP_MIDDLE,
    GRIP_WHOLE, /* the whole selection */
} EditGrip;

typedef struct EditHandle {
    EditGrip grip;
    const char *id; /* id of the element, valid until the selection or the plan changes */
    DraftList list;
    size_t index; /* index of the point, segment, edge or corner */
    Vec2 at;      /* m */
} EditHandle;

/* A chain of points: a wall, an outline, a route, a distance. */
typedef struct EditChain {
    Vec2 *points;   /* (count) placed points */
    double *amount; /* (count) m, thickness of the segment that ends at the point */
    size_t count, capacity, amount_capacity;
    bool floating;        /* the next point is shown as a part of the chain */
    bool proposed;        /* length and angle of the next segment are proposed in the fields */
    Vec2 proposed_at;     /* m, the pointer's place at the time of the proposal */
    char exit[EDIT_NAME]; /* routes only: the exit that was clicked */
} EditChain;

/* A measured distance; it stays until it is deleted. */
typedef struct EditMeasure {
    Vec2 from, to; /* m */
} EditMeasure;

/* The gesture that a press may begin. */
typedef enum EditPending { PENDING_NOTHING, PENDING_HANDLE, PENDING_WHOLE, PENDING_BOX } EditPending;

/* An earthquake made in the editor. */
typedef struct EditShake {
    uint64_t revision;      /* the draft's revision after the earthquake */
    const char *const *ids; /* (count) ids of the pieces that fell */
    size_t count;
} EditShake;

struct Editor {
    Draft *draft; /* the edited house; belongs to the owner */
    Arena kept;   /* holds the texts of the options */
    EditorOptions options;
    EditorScene scene; /* the displayed house */
    bool changed;      /* the draft has changed since the owner's last request */
    bool shook;        /* an earthquake was made since the owner's last request */
    bool number_held;  /* a number is being dragged: its undo step is open */
    Item selected;     /* the last item of the selection, in the displayed house */

    EditTool tool;
    Pointer pointer; /* the last position of the pointer */
    bool down;       /* the pointer's button is down */
    bool moved;      /* the pointer has moved since the press */
    Vec2 pressed;    /* m, the place of the press */
    EditPending pending;
    bool seen; /* the pointer has been on the plan */

    char **ids; /* (id_count) ids of the selection, in the order of selecting */
    size_t id_count, id_capacity;
    Item *things; /* (id_count) the selection as items of the displayed house */
    size_t thing_capacity;
    Item told;  /* `selected` when it was last synchronised with the ids */
    int handle; /* the handle that has the keyboard focus, -1: none */

    const EditGesture *gesture; /* NULL: there is none */
    bool keys;                  /* the pointer is ignored until its button is pressed, or, */
    bool clicked;               /* if `clicked`, until the pointer moves */
    Vec2 keys_at;               /* m, the pointer's place when the keys took over */
    char name[EDIT_NAME];       /* name of the gesture's undo step */
    Plan begun;                 /* the house before the gesture */
    EditTarget now, good;
    bool has_good, limited;
    char *refusal;
    EditField fields[EDIT_FIELDS];
    size_t field_count, field;
    char typed[EDIT_TYPED];
    char wrong[128];
    Snap snap; /* snap of the target */

    EditChain chain;
    EditHandle grip; /* the dragged handle; its id is `held` */
    char *held;
    Vec2 offset;          /* m, from the pointer to the handle */
    bool taken;           /* grabbed by a click, not by dragging */
    bool sizing;          /* a rectangle is being drawn */
    char made[EDIT_NAME]; /* id of the item added last */

    size_t items[EDIT_TOOLS]; /* index of the chosen row of each tool */
    CatalogueRow *item_rows;
    size_t item_capacity;
    Arena item_words;
    Catalogue catalogue;
    char **profiles; /* (profile_count) names of the shipped profiles */
    size_t profile_count;
    bool stocked;                      /* catalogue and profiles have been read */
    double door_width, wall_thickness; /* m, of the next door, of the next wall */

    char *image;        /* path of the trace image that was read last, or NULL */
    double image_shape; /* 1, height / width of the trace image; 0: there is none */
    bool image_other;   /* the image's bytes differ from the ones that were traced */

    EditMeasure measures[EDIT_MEASURES];
    size_t measure_count;

    EditSearch *search;   /* search for changes that let all people leave, or NULL */
    EditSearch *given_up; /* list of cancelled searches that have not ended yet */
    char proposing[64];

    EditShake *shakes; /* (shake_count) */
    size_t shake_count, shake_capacity;
    uint64_t seed;          /* seed of the last earthquake */
    char shaken[EDIT_NAME]; /* result of the last earthquake */
    Arena shake_arena;

    EditText *texts;
    size_t text_capacity;
    Arena text_arena;

    EditMark *marks; /* marks of the displayed gesture */
    size_t mark_count, mark_capacity;
    Arena words;
    uint64_t pasted;    /* digest of the text that was last pasted without a pointer, */
    int copies;         /* and how many times it was pasted */
    size_t saved_steps; /* number of undo steps at the last save */
    Text doing;
    GestureView shown;
};

/* Gestures -------------------------------------------------------------------------------------------------------- */

/* Begins a gesture; `name` is the name of its step. `keys`: the pointer is ignored at first. */
void edit_gesture_begin(Editor *edit, const EditGesture *gesture, const char *name, bool keys);

/* Repeats the gesture with the present pointer and fields. */
void edit_gesture_follow(Editor *edit);

/* Completes the gesture as one step, or cancels it. False: the step is refused, and the gesture continues. */
bool edit_gesture_end(Editor *edit);
void edit_gesture_drop(Editor *edit);

/* Applies the last valid target, if there is one. False: the target is refused, and nothing has changed. */
bool edit_gesture_settle(Editor *edit);

/* Open and close an undo step without a gesture; closing reports the change to the owner. False: the fault says why
 * the step is invalid. */
void edit_gesture_open(Editor *edit, const char *name);
bool edit_gesture_close(Editor *edit, Fault *fault);

/* Fields: sets their names, and the values of the pointer; true if a field is typed, then `*value` is the typed value.
 */
void edit_field_list(Editor *edit, const char *const *names, const char *const *units, size_t count);
bool edit_field_typed(const Editor *edit, size_t field, double *value);
void edit_field_show(Editor *edit, size_t field, double value);
bool edit_field_any(const Editor *edit);
bool edit_field_type(Editor *edit, const char *letters);
bool edit_field_back(Editor *edit);
bool edit_field_tab(Editor *edit, int step);
bool edit_field_begins(const char *letters);

/* Returns the snapped place of the pointer and stores the snap; `ask` holds the deviations from the usual request. */
Vec2 edit_gesture_snap(Editor *edit, SnapAsk ask);

/* Tools ----------------------------------------------------------------------------------------------------------- */

void edit_chain_begin(Editor *edit, bool keys);
void edit_chain_clear(Editor *edit);
void edit_wall_make(Editor *edit);
void edit_way_make_exit(Editor *edit);
void edit_way_make_room(Editor *edit);
void edit_way_make_route(Editor *edit);
void edit_way_find_exit(Editor *edit);
const char *edit_way_person(const Editor *edit); /* the person whose route is drawn; NULL: the plan has no people */
bool edit_way_across(Editor *edit);              /* places an exit across the door at the pointer */
void edit_place_begin(Editor *edit, bool keys);
void edit_door_follow(Editor *edit);
void edit_door_make(Editor *edit);
bool edit_door_limit(Editor *edit);
void edit_piece_follow(Editor *edit);
void edit_piece_make(Editor *edit);
void edit_person_follow(Editor *edit);
void edit_person_make(Editor *edit);

/* Pointer and keys, as in editor.h. */
void edit_pointer_take(Editor *edit, EditTool tool);
void edit_pointer_point(Editor *edit, const Pointer *pointer);
void edit_pointer_press(Editor *edit, const Pointer *pointer, bool twice);
void edit_pointer_release(Editor *edit, const Pointer *pointer);
bool edit_pointer_type(Editor *edit, const char *letters);
bool edit_pointer_enter(Editor *edit);
bool edit_pointer_back(Editor *edit);
bool edit_pointer_escape(Editor *edit);

/* Prepares the rows that a tool can place: reads the catalogue and the names of the profiles once. */
void edit_items_stock(Editor *edit);
void edit_items_clear(Editor *edit);
const CatalogueRow *edit_items_list(Editor *edit, size_t *count);

/* Selection ------------------------------------------------------------------------------------------------------- */

/* Synchronises the selected ids with `selected`, which the owner may have set. */
void edit_select_meet(Editor *edit);
void edit_select_only(Editor *edit, const char *id); /* id NULL: clears the selection */
void edit_select_toggle(Editor *edit, const char *id);
void edit_select_known(Editor *edit); /* removes ids of removed items from the selection */
bool edit_select_has(const Editor *edit, const char *id);
void edit_select_within(Editor *edit, Box box, bool more);
void edit_select_all(Editor *edit);
const char *edit_select_id(const Editor *edit, Item thing); /* "": the item has no id */
Item edit_select_thing(const Editor *edit, const char *id);
const char *edit_select_at(Editor *edit, Vec2 at); /* id of the item at a place, NULL: none */

/* "door d2", "wardrobe (f3)" */
void edit_select_name(const Editor *edit, const char *id, char name[EDIT_NAME]);
/* Writes the name of the selection: as edit_select_name, or "5 items". */
void edit_select_names(const Editor *edit, char name[EDIT_NAME]);

/* Lists the handles of the selection in a plan (at most EDIT_HANDLES); returns their number. */
size_t edit_handle_list(const Editor *edit, const Plan *plan, EditHandle *handles);
/* Finds the nearest handle within reach; false: none. */
bool edit_handle_at(const Editor *edit, const Pointer *pointer, EditHandle *handle);

/* Add marks to the displayed gesture. */
void edit_marks_line(Editor *edit, Vec2 from, Vec2 to);
void edit_marks_outline(Editor *edit, const Vec2 *points, size_t count);
void edit_marks_length(Editor *edit, Vec2 from, Vec2 to);
void edit_marks_piece(Editor *edit, const Furniture *piece); /* also marks the free space around the piece */
void edit_marks_door(Editor *edit, const Plan *plan, const Door *door);
void edit_marks_held(Editor *edit);
const GestureView *edit_marks_make(Editor *edit, const char *idle); /* `idle`: the text while there is no gesture */

/* How a handle is grabbed. */
typedef enum EditHold { HOLD_DRAG, HOLD_CLICK, HOLD_KEYS } EditHold;
void edit_drag_begin(Editor *edit, const EditHandle *handle, EditHold how);
void edit_drag_whole(Editor *edit);
void edit_drag_box(Editor *edit);
void edit_shape_follow(Editor *edit); /* points, segments, rectangles of walls, rooms, exits, routes */
void edit_shape_make(Editor *edit);
/* Moves the whole selection in the open step: selected walls with the corners of other walls that lie on them, doors
 * along their walls. `plan` is the plan before the move. */
void edit_shape_move(Editor *edit, const Plan *plan, Vec2 by);
void edit_body_follow(Editor *edit); /* furniture and people */
void edit_body_make(Editor *edit);
void edit_door_slide_follow(Editor *edit); /* doors */
void edit_door_slide_make(Editor *edit);
bool edit_door_slide_limit(Editor *edit);

/* Actions on the selection ---------------------------------------------------------------------------------------- */

bool edit_do_nudge(Editor *edit, Vec2 by, Fault *fault);
bool edit_do_turn(Editor *edit, double by, Fault *fault);
bool edit_do_topple(Editor *edit, Fault *fault);
bool edit_do_remove(Editor *edit, Fault *fault);
char *edit_do_copy(const Editor *edit);
bool edit_do_duplicate(Editor *edit, Fault *fault);
bool edit_do_paste(Editor *edit, const char *text, Fault *fault);
bool edit_split_wall(Editor *edit, Fault *fault);
bool edit_split_can_join(const Editor *edit); /* true if the focused point can be removed */
bool edit_split_join(Editor *edit, Fault *fault);

extern const EditGesture edit_image_gesture;
void edit_image_begin(Editor *edit, bool keys);
bool edit_image_set(Editor *edit, const char *path, Fault *fault);
void edit_image_fade(Editor *edit, double opacity);
TraceImage edit_image_get(Editor *edit);
/* Returns one line that says why the trace image differs from the original; NULL: it is unchanged, or there is none. */
const char *edit_image_trouble(Editor *edit);

void edit_propose_ask(Editor *edit);
const Proposal *edit_propose_list(Editor *edit, size_t *count, const char **doing);
bool edit_propose_accept(Editor *edit, size_t proposal, Fault *fault);
void edit_propose_end(Editor *edit);

bool edit_shake_do(Editor *edit, Fault *fault);
void edit_shake_clear(Editor *edit);

const EditText *edit_text_list(Editor *edit, size_t *count);
bool edit_text_set(Editor *edit, const char *name, const char *value, Fault *fault);

/* Returns the width of the narrowest wheelchair in the house, m; infinite: there is none. */
double edit_measure_chair(const Editor *edit);
void edit_measure_say(double length, double chair, char *words, size_t size);
void edit_measure_keep(Editor *edit, Vec2 from, Vec2 to);
bool edit_measure_side(Editor *edit); /* uses the side at the pointer; false: there is none */
