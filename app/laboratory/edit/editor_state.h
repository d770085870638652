/* The state of an editor, for the files of this folder only. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"
#include "base/text.h"
#include "plan/catalogue.h"
#include "plan/draft.h"
#include "plan/profile.h"
#include "plan/snap_piece.h"
#include "laboratory/edit/editor.h"

typedef struct EditSearch EditSearch;   /* see propose.c */
typedef struct EditGesture EditGesture; /* see gesture.h */

enum {
    EDIT_FIELDS = 6,
    EDIT_TYPED = 48,    /* characters of a number that is being typed */
    EDIT_NAME = 128,    /* characters of the name of a step or an item */
    EDIT_MEASURES = 32, /* measured distances displayed at once */
};

/* What an exit lies on. */
typedef enum EditExitGround { EXIT_NOWHERE, EXIT_ON_DOOR, EXIT_ON_GAP, EXIT_ON_WALL } EditExitGround;

/* The target of a gesture. */
typedef struct EditTarget {
    Vec2 at;       /* m: the target place of the item, the handle or the next point */
    Vec2 corner;   /* m: first corner of the drawn rectangle */
    Vec2 size;     /* m: size of a piece of furniture */
    double angle;  /* degree */
    double amount; /* m: thickness of a wall, width of a door */
    double along;  /* m: the middle of a door along its segment */
    size_t wall, segment;
    EditExitGround ground; /* what an exit lies on, */
    size_t door;           /* the door, */
    Vec2 from, to;         /* m: and its ends */
} EditTarget;

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
    uint64_t seed;          /* its number */
    uint64_t standing;      /* number of the house before it: a revision of the draft */
    const char *const *ids; /* (count) ids of the pieces that fell */
    size_t count;
} EditShake;

/* What a click at the pointer would do; made again when the pointer, the plan or the item in hand has changed. */
typedef struct EditPreview {
    Pointer pointer;
    uint64_t revision;
    EditTool tool;
    size_t row;
    EditMark *marks; /* (mark_count), their texts in `texts` */
    size_t mark_count, mark_capacity;
    Arena texts;
    Text words;   /* what the click does, or why it does nothing */
    bool known;   /* the rest is set */
    bool refused; /* the click does nothing */
    bool begins;  /* the click sets the first point of something */
    bool warns;   /* the click does it, but the item touches something */
} EditPreview;

/* When the step was made that led to a revision of the plan. */
typedef struct EditStepTime {
    uint64_t revision;
    time_t at;
} EditStepTime;

struct Editor {
    Draft *draft;       /* the edited house; belongs to the owner */
    Arena option_texts; /* holds the texts of the options */
    EditorOptions options;
    EditorScene scene;   /* the displayed house */
    bool changed;        /* the draft has changed since the owner's last request */
    bool shook;          /* an earthquake was made since the owner's last request */
    bool number_dragged; /* a number is being dragged: its undo step is open */
    EditStepTime step_times[EDITOR_STEPS_MOST];
    size_t step_time_count; /* of all steps so far */
    uint64_t newest_step;   /* the newest step's revision */
    bool has_new_step;      /* a step was made since the owner's last request */
    Item selected;          /* the last item of the selection, in the displayed house */

    EditTool tool;
    Pointer pointer; /* the last position of the pointer */
    bool down;       /* the pointer's button is down */
    bool moved;      /* the pointer has moved since the press */
    Vec2 pressed;    /* m, the place of the press */
    EditPending pending;
    bool fixed;                /* walls, doors, rooms and exits cannot be moved */
    const char *fixed_pressed; /* which of them the press was on, "walls"; NULL: none */
    bool seen;                 /* the pointer has been on the plan */
    bool placed; /* an item was placed, and the pointer has not moved away from it since; then nothing is previewed */
    Vec2 placed_at; /* m */
    bool cures;     /* the tool was taken for what the house lacks */

    char **ids; /* (id_count) ids of the selection, in the order of selecting */
    size_t id_count, id_capacity;
    Item *selected_items; /* (id_count) the selection as items of the displayed house */
    size_t selected_capacity;
    Item synced; /* `selected` when it was last synchronised with the ids */
    int handle;  /* the handle that has the keyboard focus, -1: none */

    const EditGesture *gesture; /* NULL: there is none */
    bool keys;                  /* the pointer is ignored until its button is pressed, or, */
    bool clicked;               /* if `clicked`, until the pointer moves */
    Vec2 keys_at;               /* m, the pointer's place when the keys took over */
    char name[EDIT_NAME];       /* name of the gesture's undo step */
    Plan plan_before;           /* the house before the gesture */
    EditTarget now, good;
    bool has_good, limited;
    char *refusal;
    EditField fields[EDIT_FIELDS];
    size_t field_count, field;
    char typed[EDIT_TYPED];
    char typed_error[128];
    Snap snap; /* snap of the target */

    EditChain chain;
    EditHandle grip; /* the dragged handle; its id is `dragged_id` */
    char *dragged_id;
    Vec2 offset;              /* m, from the pointer to the handle */
    bool grabbed;             /* grabbed by a click, not by dragging */
    bool sizing;              /* a rectangle is being drawn */
    char added_id[EDIT_NAME]; /* id of the item added last */

    size_t chosen_rows[EDIT_TOOLS]; /* index of the chosen row of each tool */
    CatalogueRow *item_rows;
    size_t row_capacity;
    Arena item_texts;
    Catalogue catalogue;
    char **profiles; /* (profile_count) names of the shipped profiles */
    size_t profile_count;
    bool stocked; /* catalogue and profiles have been read */
    Profile body; /* the profile of row `body_row`, if `body_known` */
    size_t body_row;
    bool body_known;
    double door_width, wall_thickness; /* m, of the next door, of the next wall */

    char *image;        /* path of the trace image that was read last, or NULL */
    double image_shape; /* 1, height / width of the trace image; 0: there is none */
    bool image_other;   /* the image's bytes differ from the ones that were traced */

    EditMeasure measures[EDIT_MEASURES];
    size_t measure_count;
    bool scales;   /* the gesture that sets the scale is being completed */
    bool rescaled; /* the scale was set since the owner's last request */

    uint64_t search_count; /* of all searches so far */
    EditSearch *search;    /* search for changes that let all people leave, or NULL */
    EditSearch *cancelled; /* list of cancelled searches that have not ended yet */
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
    Arena mark_texts;
    uint64_t pasted; /* digest of the text that was last pasted without a pointer, */
    int copies;      /* and how many times it was pasted */
    EditPreview preview;
    char touched[EDIT_NAME]; /* what the item of the preview touches */
    size_t saved_steps;      /* number of undo steps at the last save */
    Text doing;
    GestureView shown;
};
