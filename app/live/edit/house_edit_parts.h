/* What editing a house consists of: for the files house_edit*.c.
 *
 * A gesture is a row of functions. `follow` turns the hand and what is typed into a target; `make` turns the target
 * into changes of the draft. Both are done anew whenever the hand moves: the step is rewound, made, and tried.
 *
 *     hand, fields -> follow -> now -> make -> draft_try -> good, or a refusal */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"
#include "base/text.h"
#include "plan/catalogue.h"
#include "plan/draft.h"
#include "plan/snap_piece.h"
#include "live/live_edit.h"

typedef struct HouseLive HouseLive;
typedef struct EditSearch EditSearch;

enum {
    EDIT_FIELDS = 6,
    EDIT_TYPED = 48,    /* letters of a number that is being typed */
    EDIT_NAME = 128,    /* of a step or a thing */
    EDIT_HANDLES = 128, /* of what is selected */
    EDIT_MEASURES = 32, /* that are shown at once */
};

/* What a gesture has come to. */
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
    void (*follow)(HouseLive *live);
    void (*make)(HouseLive *live);           /* NULL: the draft is not changed by it */
    bool (*limit)(HouseLive *live);          /* brings a refused target to where it may stand; NULL or false: nowhere */
    bool (*put)(HouseLive *live, bool keys); /* a press, or Enter */
    bool (*back)(HouseLive *live);           /* Backspace; NULL: lets go */
    bool (*escape)(HouseLive *live);         /* NULL: lets go */
    void (*release)(HouseLive *live, bool moved); /* of the press that began it, or came later */
    void (*say)(HouseLive *live, Text *words);
    void (*show)(HouseLive *live); /* adds marks */
} EditGesture;

/* What can be taken up of a thing. */
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
    Vec2 proposed_at;     /* m, where the hand was then */
    char exit[EDIT_NAME]; /* of a route: the exit that was pointed at */
} EditChain;

/* Something measured, which stays until it is deleted. */
typedef struct EditMeasure {
    Vec2 from, to; /* m */
} EditMeasure;

/* What a press may turn into. */
typedef enum EditPending { PENDING_NOTHING, PENDING_HANDLE, PENDING_WHOLE, PENDING_BOX } EditPending;

/* An earthquake that was made here. */
typedef struct EditShake {
    uint64_t revision;      /* of the draft after it */
    const char *const *ids; /* (count) of what fell */
    size_t count;
} EditShake;

typedef struct HouseEdit {
    LiveTool tool;
    LiveHand hand; /* the last one */
    bool down;     /* its button */
    bool moved;    /* since it is */
    Vec2 pressed;  /* m, where it went down */
    EditPending pending;
    bool seen; /* the hand has been anywhere */

    char **ids; /* (id_count) of what is selected, the last one last */
    size_t id_count, id_capacity;
    LiveThing *things; /* (id_count) the same for whoever asks */
    size_t thing_capacity;
    LiveThing told; /* that was selected by itself for them */
    int handle;     /* that has the focus of the keys, -1: none */

    const EditGesture *gesture; /* NULL: there is none */
    bool keys;                  /* the hand has no part in it: until its button is pressed, or */
    bool clicked;               /* until it moves */
    Vec2 keys_at;               /* m, where the hand was then */
    char name[EDIT_NAME];       /* of its step */
    Plan begun;                 /* the house before it */
    EditTarget now, good;
    bool has_good, limited;
    char *refusal;
    LiveField fields[EDIT_FIELDS];
    size_t field_count, field;
    char typed[EDIT_TYPED];
    char wrong[128];
    Snap snap; /* of the target */

    EditChain chain;
    EditHandle grip; /* that is held; its id is `held` */
    char *held;
    Vec2 offset;          /* m, from the hand to the handle */
    bool taken;           /* by a click, not by dragging */
    bool sizing;          /* a rectangle is drawn out */
    char made[EDIT_NAME]; /* the id of what was added last */

    size_t items[LIVE_TOOLS]; /* chosen */
    LiveItem *item_rows;
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

    EditSearch *search;   /* for changes that let everybody out, or NULL */
    EditSearch *given_up; /* a list of those that have not ended yet */
    char proposing[64];

    EditShake *shakes; /* (shake_count) */
    size_t shake_count, shake_capacity;
    uint64_t seed;          /* of the last one */
    char shaken[EDIT_NAME]; /* what came of it */
    Arena shake_arena;

    LiveText *texts;
    size_t text_capacity;
    Arena text_arena;

    LiveMark *marks; /* of the gesture that is shown */
    size_t mark_count, mark_capacity;
    Arena words;
    uint64_t pasted;    /* digest of what was pasted last without a pointer, */
    int copies;         /* so often */
    size_t saved_steps; /* that could be undone when it was saved */
    Text doing;
    LiveGesture shown;
} HouseEdit;

void house_edit_begin(HouseLive *live);
void house_edit_clear(HouseLive *live); /* releases all; what is in the hand is let go */

/* Gestures -------------------------------------------------------------------------------------------------------- */

/* Begins one; `name` is of its step. `keys`: the hand has no part in it yet. */
void house_edit_gesture_begin(HouseLive *live, const EditGesture *gesture, const char *name, bool keys);

/* Does it anew, as the hand and the fields are. */
void house_edit_gesture_follow(HouseLive *live);

/* Ends it as a step that stands, or lets it go; false: it does not stand, and is still in the hand. */
bool house_edit_gesture_end(HouseLive *live);
void house_edit_gesture_drop(HouseLive *live);

/* Puts the last good target down, where there is one. False: refused, and nothing has happened. */
bool house_edit_gesture_settle(HouseLive *live);

/* A step of its own: begins it; ends it, and has it followed. False: a fault says why it cannot be. */
void house_edit_gesture_open(HouseLive *live, const char *name);
bool house_edit_gesture_close(HouseLive *live, Fault *fault);

/* Fields: sets how they are called, and what the hand gives; is it typed? then `*value` is what is typed. */
void house_edit_field_list(HouseLive *live, const char *const *names, const char *const *units, size_t count);
bool house_edit_field_typed(const HouseLive *live, size_t field, double *value);
void house_edit_field_show(HouseLive *live, size_t field, double value);
bool house_edit_field_any(const HouseLive *live);
bool house_edit_field_type(HouseLive *live, const char *letters);
bool house_edit_field_back(HouseLive *live);
bool house_edit_field_tab(HouseLive *live, int step);
bool house_edit_field_begins(const char *letters);

/* Where the hand points, with snapping; `ask` as far as it is special. Keeps the snap. */
Vec2 house_edit_gesture_snap(HouseLive *live, SnapAsk ask);

/* Tools ----------------------------------------------------------------------------------------------------------- */

void house_edit_chain_begin(HouseLive *live, bool keys);
void house_edit_chain_clear(HouseLive *live);
void house_edit_wall_make(HouseLive *live);
void house_edit_way_make_exit(HouseLive *live);
void house_edit_way_make_room(HouseLive *live);
void house_edit_way_make_route(HouseLive *live);
void house_edit_way_find_exit(HouseLive *live);
const char *house_edit_way_person(const HouseLive *live); /* whose route is drawn; NULL: there is nobody */
bool house_edit_way_across(HouseLive *live);              /* an exit across the door at the hand */
void house_edit_place_begin(HouseLive *live, bool keys);
void house_edit_door_follow(HouseLive *live);
void house_edit_door_make(HouseLive *live);
bool house_edit_door_limit(HouseLive *live);
void house_edit_piece_follow(HouseLive *live);
void house_edit_piece_make(HouseLive *live);
void house_edit_person_follow(HouseLive *live);
void house_edit_person_make(HouseLive *live);

/* The hand and the keys, as live_edit.h has them. */
void house_edit_hand_take(HouseLive *live, LiveTool tool);
void house_edit_hand_point(HouseLive *live, const LiveHand *hand);
void house_edit_hand_press(HouseLive *live, const LiveHand *hand, bool twice);
void house_edit_hand_release(HouseLive *live, const LiveHand *hand);
bool house_edit_hand_type(HouseLive *live, const char *letters);
bool house_edit_hand_enter(HouseLive *live);
bool house_edit_hand_back(HouseLive *live);
bool house_edit_hand_escape(HouseLive *live);

/* What can be placed: reads the catalogue and the names of the profiles once. */
void house_edit_items_stock(HouseLive *live);
void house_edit_items_clear(HouseLive *live);
const LiveItem *house_edit_items_list(HouseLive *live, size_t *count);

/* Selection ------------------------------------------------------------------------------------------------------- */

/* What is selected by itself, live->selected, and what the editor has are brought together. */
void house_edit_select_meet(HouseLive *live);
void house_edit_select_only(HouseLive *live, const char *id); /* NULL: nothing */
void house_edit_select_toggle(HouseLive *live, const char *id);
void house_edit_select_known(HouseLive *live); /* forgets what is no longer there */
bool house_edit_select_has(const HouseLive *live, const char *id);
void house_edit_select_within(HouseLive *live, Box box, bool more);
void house_edit_select_all(HouseLive *live);
const char *house_edit_select_id(const HouseLive *live, LiveThing thing); /* "": it has none */
LiveThing house_edit_select_thing(const HouseLive *live, const char *id);
const char *house_edit_select_at(HouseLive *live, Vec2 at); /* what lies there, NULL: nothing */

/* "door d2", "wardrobe (f3)" */
void house_edit_select_name(const HouseLive *live, const char *id, char name[EDIT_NAME]);
/* The same, or "5 things". */
void house_edit_select_names(const HouseLive *live, char name[EDIT_NAME]);

/* The handles of what is selected in a plan (EDIT_HANDLES); how many. */
size_t house_edit_handle_list(const HouseLive *live, const Plan *plan, EditHandle *handles);
/* The nearest one within reach; false: none. */
bool house_edit_handle_at(const HouseLive *live, const LiveHand *hand, EditHandle *handle);

/* Marks of the gesture, for what it shows. */
void house_edit_marks_line(HouseLive *live, Vec2 from, Vec2 to);
void house_edit_marks_outline(HouseLive *live, const Vec2 *points, size_t count);
void house_edit_marks_length(HouseLive *live, Vec2 from, Vec2 to);
void house_edit_marks_piece(HouseLive *live, const Furniture *piece); /* and the room that it leaves */
void house_edit_marks_door(HouseLive *live, const Plan *plan, const Door *door);
void house_edit_marks_held(HouseLive *live);
const LiveGesture *house_edit_marks_make(HouseLive *live);

/* Takes a handle up. */
typedef enum EditHold { HOLD_DRAG, HOLD_CLICK, HOLD_KEYS } EditHold;
void house_edit_drag_begin(HouseLive *live, const EditHandle *handle, EditHold how);
void house_edit_drag_whole(HouseLive *live);
void house_edit_drag_box(HouseLive *live);
void house_edit_shape_follow(HouseLive *live); /* points, segments, rectangles: of walls, rooms, exits, routes */
void house_edit_shape_make(HouseLive *live);
/* Moves all that is selected in the open step: walls with the corners of others that lie on theirs, doors along their
 * walls. The plan is what it was before. */
void house_edit_shape_move(HouseLive *live, const Plan *plan, Vec2 by);
void house_edit_body_follow(HouseLive *live); /* furniture and people */
void house_edit_body_make(HouseLive *live);
void house_edit_door_slide_follow(HouseLive *live); /* doors */
void house_edit_door_slide_make(HouseLive *live);
bool house_edit_door_slide_limit(HouseLive *live);

/* What is done to the selection ------------------------------------------------------------------------------------ */

bool house_edit_do_nudge(HouseLive *live, Vec2 by, Fault *fault);
bool house_edit_do_turn(HouseLive *live, double by, Fault *fault);
bool house_edit_do_topple(HouseLive *live, Fault *fault);
bool house_edit_do_remove(HouseLive *live, Fault *fault);
char *house_edit_do_copy(const HouseLive *live);
bool house_edit_do_duplicate(HouseLive *live, Fault *fault);
bool house_edit_do_paste(HouseLive *live, const char *text, Fault *fault);
bool house_edit_split_wall(HouseLive *live, Fault *fault);
bool house_edit_split_can_join(const HouseLive *live); /* the point that has the focus of the keys can be taken out */
bool house_edit_split_join(HouseLive *live, Fault *fault);

extern const EditGesture house_edit_image_gesture;
void house_edit_image_begin(HouseLive *live, bool keys);
bool house_edit_image_set(HouseLive *live, const char *path, Fault *fault);
void house_edit_image_fade(HouseLive *live, double opacity);
LiveImage house_edit_image_get(HouseLive *live);
/* Why the picture is not as it was, in a line; NULL: it is, or there is none. */
const char *house_edit_image_trouble(HouseLive *live);

void house_edit_propose_ask(HouseLive *live);
const LiveProposal *house_edit_propose_list(HouseLive *live, size_t *count, const char **doing);
bool house_edit_propose_accept(HouseLive *live, size_t proposal, Fault *fault);
void house_edit_propose_end(HouseLive *live);

bool house_edit_shake_do(HouseLive *live, Fault *fault);
void house_edit_shake_clear(HouseLive *live);

const LiveText *house_edit_text_list(HouseLive *live, size_t *count);
bool house_edit_text_set(HouseLive *live, const char *name, const char *value, Fault *fault);

/* m, of the narrowest chair in the house; infinite: there is none. */
double house_edit_measure_chair(const HouseLive *live);
void house_edit_measure_say(double length, double chair, char *words, size_t size);
void house_edit_measure_keep(HouseLive *live, Vec2 from, Vec2 to);
bool house_edit_measure_side(HouseLive *live); /* the side at the hand; false: there is none */
