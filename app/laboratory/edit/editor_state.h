/* The state of an editor, for the files of this folder only.
 *
 * A gesture is a row of functions. `follow` turns the pointer and the typed numbers into a target; `make` turns the
 * target into changes of the draft. Both are repeated whenever the pointer moves: the step is rewound, made, and tried.
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
    EDIT_TYPED = 48,    /* letters of a number that is being typed */
    EDIT_NAME = 128,    /* of a step or a thing */
    EDIT_HANDLES = 128, /* of what is selected */
    EDIT_MEASURES = 32, /* that are shown at once */
};

/* The target of a gesture. */
typedef struct EditTarget {
    Vec2 at;       /* m: where the thing, the handle or the next point goes */
    Vec2 corner;   /* m: of a rectangle that is drawn, where it began */
    Vec2 size;     /* m, of a piece of furniture */
    double angle;  /* degree */
    double amount; /* m: a wall's thickness, a door's width */
    double along;  /* m: a door's middle on its segment */
    size_t wall, segment;
} EditTarget;

typedef struct EditGesture {
    void (*follow)(Editor *edit);
    void (*make)(Editor *edit);           /* NULL: the draft is not changed by it */
    bool (*limit)(Editor *edit);          /* brings a refused target to where it may stand; NULL or false: nowhere */
    bool (*put)(Editor *edit, bool keys); /* a press, or Enter */
    bool (*back)(Editor *edit);           /* Backspace; NULL: lets go */
    bool (*escape)(Editor *edit);         /* NULL: lets go */
    void (*release)(Editor *edit, bool moved); /* of the press that began it, or came later */
    void (*say)(Editor *edit, Text *words);
    void (*show)(Editor *edit); /* adds marks */
    void (*end)(Editor *edit);  /* forgets what the gesture has collected; NULL: nothing */
} EditGesture;

/* The kinds of handles of an item. */
typedef enum EditGrip {
    GRIP_POINT,   /* of a wall, an outline, a route; an end of an exit */
    GRIP_SEGMENT, /* the middle of a wall's piece */
    GRIP_EDGE,    /* of a door: its width */
    GRIP_CORNER,  /* of a piece of furniture: its size */
    GRIP_TURN,
    GRIP_MIDDLE,
    GRIP_WHOLE, /* all that is selected */
} EditGrip;

typedef struct EditHandle {
    EditGrip grip;
    const char *id; /* of the element, good as long as the selection and the plan */
    DraftList list;
    size_t index; /* of a point, segment, edge or corner */
    Vec2 at;      /* m */
} EditHandle;

/* Points one after another: a wall, an outline, a way, a distance. */
typedef struct EditChain {
    Vec2 *points;   /* (count) put down */
    double *amount; /* (count) m, the thickness of what ends there */
    size_t count, capacity, amount_capacity;
    bool floating;        /* the next point is a part of what is made */
    bool proposed;        /* length and angle of the next one stand in the fields */
    Vec2 proposed_at;     /* m, where the pointer was then */
    char exit[EDIT_NAME]; /* of a route: the exit that was pointed at */
} EditChain;

/* Something measured, which stays until it is deleted. */
typedef struct EditMeasure {
    Vec2 from, to; /* m */
} EditMeasure;

/* The gesture that a press may begin. */
typedef enum EditPending { PENDING_NOTHING, PENDING_HANDLE, PENDING_WHOLE, PENDING_BOX } EditPending;

/* An earthquake that was made here. */
typedef struct EditShake {
    uint64_t revision;      /* of the draft after it */
    const char *const *ids; /* (count) of what fell */
    size_t count;
} EditShake;

struct Editor {
    Draft *draft; /* the house as it is edited; the owner's */
    Arena kept;   /* holds the texts of the options */
    EditorOptions options;
    EditorScene scene; /* that is displayed */
    bool changed;      /* the draft, since the owner asked last */
    bool shook;        /* an earthquake was made since the owner asked last */
    bool number_held;  /* a number is being dragged: its step is open */
    Item selected;     /* the last of the selection, in the displayed house */

    EditTool tool;
    Pointer pointer; /* the last one */
    bool down;       /* its button */
    bool moved;      /* since it is */
    Vec2 pressed;    /* m, where it went down */
    EditPending pending;
    bool seen; /* the pointer has been on the plan */

    char **ids; /* (id_count) of what is selected, the last one last */
    size_t id_count, id_capacity;
    Item *things; /* (id_count) the same, as items of the displayed house */
    size_t thing_capacity;
    Item told;  /* `selected`, when the two were last compared */
    int handle; /* that has the focus of the keys, -1: none */

    const EditGesture *gesture; /* NULL: there is none */
    bool keys;                  /* the pointer is ignored: until its button is pressed, or */
    bool clicked;               /* until it moves */
    Vec2 keys_at;               /* m, where the pointer was then */
    char name[EDIT_NAME];       /* of its step */
    Plan begun;                 /* the house before it */
    EditTarget now, good;
    bool has_good, limited;
    char *refusal;
    EditField fields[EDIT_FIELDS];
    size_t field_count, field;
    char typed[EDIT_TYPED];
    char wrong[128];
    Snap snap; /* of the target */

    EditChain chain;
    EditHandle grip; /* that is held; its id is `held` */
    char *held;
    Vec2 offset;          /* m, from the pointer to the handle */
    bool taken;           /* by a click, not by dragging */
    bool sizing;          /* a rectangle is drawn out */
    char made[EDIT_NAME]; /* the id of what was added last */

    size_t items[EDIT_TOOLS]; /* chosen */
    CatalogueRow *item_rows;
    size_t item_capacity;
    Arena item_words;
    Catalogue catalogue;
    char **profiles; /* (profile_count) names of the shipped ones */
    size_t profile_count;
    bool stocked;                      /* the two are read */
    double door_width, wall_thickness; /* m, of the next one */

    char *image;        /* path of the picture to trace over that was looked for last, or NULL */
    double image_shape; /* 1, its height by its width; 0: there is none */
    bool image_other;   /* its bytes are not those that were traced over */

    EditMeasure measures[EDIT_MEASURES];
    size_t measure_count;

    EditSearch *search;   /* for changes with which all people could leave, or NULL */
    EditSearch *given_up; /* a list of those that have not ended yet */
    char proposing[64];

    EditShake *shakes; /* (shake_count) */
    size_t shake_count, shake_capacity;
    uint64_t seed;          /* of the last one */
    char shaken[EDIT_NAME]; /* what came of it */
    Arena shake_arena;

    EditText *texts;
    size_t text_capacity;
    Arena text_arena;

    EditMark *marks; /* of the gesture that is shown */
    size_t mark_count, mark_capacity;
    Arena words;
    uint64_t pasted;    /* digest of what was pasted last without a pointer, */
    int copies;         /* so often */
    size_t saved_steps; /* that could be undone when it was saved */
    Text doing;
    GestureView shown;
};

/* Gestures -------------------------------------------------------------------------------------------------------- */

/* Begins a gesture; `name` is the name of its step. `keys`: the pointer is ignored at first. */
void edit_gesture_begin(Editor *edit, const EditGesture *gesture, const char *name, bool keys);

/* Repeats the gesture with the pointer and the fields as they are. */
void edit_gesture_follow(Editor *edit);

/* Completes the gesture as one step, or cancels it; false: the step is refused, and the gesture goes on. */
bool edit_gesture_end(Editor *edit);
void edit_gesture_drop(Editor *edit);

/* Puts the last good target down, where there is one. False: refused, and nothing has happened. */
bool edit_gesture_settle(Editor *edit);

/* A step of its own: begins it; ends it, and has it followed. False: a fault says why it cannot be. */
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

/* Returns the snapped place of the pointer and stores the snap; `ask` has what differs from the usual. */
Vec2 edit_gesture_snap(Editor *edit, SnapAsk ask);

/* Tools ----------------------------------------------------------------------------------------------------------- */

void edit_chain_begin(Editor *edit, bool keys);
void edit_chain_clear(Editor *edit);
void edit_wall_make(Editor *edit);
void edit_way_make_exit(Editor *edit);
void edit_way_make_room(Editor *edit);
void edit_way_make_route(Editor *edit);
void edit_way_find_exit(Editor *edit);
const char *edit_way_person(const Editor *edit); /* whose route is drawn; NULL: the plan has no people */
bool edit_way_across(Editor *edit);              /* an exit across the door at the pointer */
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

/* The rows that a tool can place: reads the catalogue and the names of the profiles once. */
void edit_items_stock(Editor *edit);
void edit_items_clear(Editor *edit);
const CatalogueRow *edit_items_list(Editor *edit, size_t *count);

/* Selection ------------------------------------------------------------------------------------------------------- */

/* Makes `selected`, which the owner may have set, and the selected ids agree. */
void edit_select_meet(Editor *edit);
void edit_select_only(Editor *edit, const char *id); /* NULL: nothing */
void edit_select_toggle(Editor *edit, const char *id);
void edit_select_known(Editor *edit); /* forgets the ids that were removed */
bool edit_select_has(const Editor *edit, const char *id);
void edit_select_within(Editor *edit, Box box, bool more);
void edit_select_all(Editor *edit);
const char *edit_select_id(const Editor *edit, Item thing); /* "": it has none */
Item edit_select_thing(const Editor *edit, const char *id);
const char *edit_select_at(Editor *edit, Vec2 at); /* what lies there, NULL: nothing */

/* "door d2", "wardrobe (f3)" */
void edit_select_name(const Editor *edit, const char *id, char name[EDIT_NAME]);
/* The same, or "5 things". */
void edit_select_names(const Editor *edit, char name[EDIT_NAME]);

/* The handles of what is selected in a plan (EDIT_HANDLES); how many. */
size_t edit_handle_list(const Editor *edit, const Plan *plan, EditHandle *handles);
/* The nearest one within reach; false: none. */
bool edit_handle_at(const Editor *edit, const Pointer *pointer, EditHandle *handle);

/* Marks of the gesture, for what it shows. */
void edit_marks_line(Editor *edit, Vec2 from, Vec2 to);
void edit_marks_outline(Editor *edit, const Vec2 *points, size_t count);
void edit_marks_length(Editor *edit, Vec2 from, Vec2 to);
void edit_marks_piece(Editor *edit, const Furniture *piece); /* and the room that it leaves */
void edit_marks_door(Editor *edit, const Plan *plan, const Door *door);
void edit_marks_held(Editor *edit);
const GestureView *edit_marks_make(Editor *edit, const char *idle); /* `idle`: the text without a gesture */

/* Takes a handle up. */
typedef enum EditHold { HOLD_DRAG, HOLD_CLICK, HOLD_KEYS } EditHold;
void edit_drag_begin(Editor *edit, const EditHandle *handle, EditHold how);
void edit_drag_whole(Editor *edit);
void edit_drag_box(Editor *edit);
void edit_shape_follow(Editor *edit); /* points, segments, rectangles: of walls, rooms, exits, routes */
void edit_shape_make(Editor *edit);
/* Moves all that is selected in the open step: walls with the corners of others that lie on theirs, doors along their
 * walls. The plan is what it was before. */
void edit_shape_move(Editor *edit, const Plan *plan, Vec2 by);
void edit_body_follow(Editor *edit); /* furniture and people */
void edit_body_make(Editor *edit);
void edit_door_slide_follow(Editor *edit); /* doors */
void edit_door_slide_make(Editor *edit);
bool edit_door_slide_limit(Editor *edit);

/* What is done to the selection ------------------------------------------------------------------------------------ */

bool edit_do_nudge(Editor *edit, Vec2 by, Fault *fault);
bool edit_do_turn(Editor *edit, double by, Fault *fault);
bool edit_do_topple(Editor *edit, Fault *fault);
bool edit_do_remove(Editor *edit, Fault *fault);
char *edit_do_copy(const Editor *edit);
bool edit_do_duplicate(Editor *edit, Fault *fault);
bool edit_do_paste(Editor *edit, const char *text, Fault *fault);
bool edit_split_wall(Editor *edit, Fault *fault);
bool edit_split_can_join(const Editor *edit); /* the point that has the focus of the keys can be taken out */
bool edit_split_join(Editor *edit, Fault *fault);

extern const EditGesture edit_image_gesture;
void edit_image_begin(Editor *edit, bool keys);
bool edit_image_set(Editor *edit, const char *path, Fault *fault);
void edit_image_fade(Editor *edit, double opacity);
TraceImage edit_image_get(Editor *edit);
/* Why the picture is not as it was, in a line; NULL: it is, or there is none. */
const char *edit_image_trouble(Editor *edit);

void edit_propose_ask(Editor *edit);
const Proposal *edit_propose_list(Editor *edit, size_t *count, const char **doing);
bool edit_propose_accept(Editor *edit, size_t proposal, Fault *fault);
void edit_propose_end(Editor *edit);

bool edit_shake_do(Editor *edit, Fault *fault);
void edit_shake_clear(Editor *edit);

const EditText *edit_text_list(Editor *edit, size_t *count);
bool edit_text_set(Editor *edit, const char *name, const char *value, Fault *fault);

/* m, of the narrowest chair in the house; infinite: there is none. */
double edit_measure_chair(const Editor *edit);
void edit_measure_say(double length, double chair, char *words, size_t size);
void edit_measure_keep(Editor *edit, Vec2 from, Vec2 to);
bool edit_measure_side(Editor *edit); /* the side at the pointer; false: there is none */
