/* Editing what a laboratory shows, while it runs: tools, gestures, pieces, undo. One struct of functions, as in live.h;
 * the window turns mouse and keys into these calls and knows nothing of walls and doors, and what is edited knows no
 * pixel: all places are m on the floor.
 *
 * A gesture is something held in the hand: a wall that is being drawn, a wardrobe that is dragged. Dragging (press,
 * point, release), click-move-click (press and release on a handle without moving takes it up, the next press puts it
 * down) and typing (take a tool, Enter, numbers, Enter) do the same. While a gesture lasts what it would make is
 * checked, run in the background and shown; Escape leaves exactly what was before. Each gesture is one step of undo. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

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
    const char *name; /* "wall" */
    const char *help; /* a sentence */
    const char
        *strip; /* what to do next, before anything is begun: "click where the wall begins, or Enter to type it" */
} EditToolRow;

/* Where the hand is. */
typedef struct Pointer {
    Vec2 at;       /* m */
    double reach;  /* m: what is nearer than this is meant */
    bool free;     /* no snapping now */
    bool straight; /* along one axis only */
    bool more;     /* to what is selected already, not in its place */
    bool nowhere;  /* there is no pointer on the plan: the middle of what is seen is meant */
} Pointer;

/* A number of a gesture that can be typed. */
typedef struct EditField {
    const char *name; /* "length" */
    const char *unit; /* "m", "degree" */
    double value;     /* as the hand has it, or as typed */
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
    bool held;         /* of a handle: it is in the hand, or has the focus of the keys */
} EditMark;

/* What is in the hand and what is to be seen of it; good until the next call of the editor or update. */
typedef struct GestureView {
    bool active;         /* the clock is to be held */
    const char *doing;   /* "wall 2.50 m, 90 degrees"; or what to do next; never NULL */
    const char *refusal; /* why it cannot be put down so, with what would be right; NULL: it can */
    const EditMark *marks;
    size_t mark_count;
    const EditField *fields; /* that can be typed now, Tab goes round */
    size_t field_count, field;
    const char *typed; /* so far, into the field; "" : nothing */
    const char *wrong; /* why what is typed is no value, NULL: it is one */
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

/* A change that would let everybody out. */
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

typedef struct EditorFunctions {
    const EditToolRow *tools; /* [EDIT_TOOLS] */

    void (*take)(void *live, EditTool tool); /* a gesture that was begun is let go */
    EditTool (*tool)(const void *live);

    /* The hand. `press` and `release` are of its main button; `twice`: the second press of a double click. */
    void (*point)(void *live, const Pointer *hand);
    void (*press)(void *live, const Pointer *hand, bool twice);
    void (*release)(void *live, const Pointer *hand);

    /* Keys while the plan has the focus. True: it was used. `type` takes what begins or goes on with a number ("2",
     * ",",
     * "-", "c"); `enter` puts down, or begins with typed places; `back` takes the last point, or letter, away; `tab`
     * goes to the next field (-1: the one before); `escape` lets go. */
    bool (*type)(void *live, const char *letters);
    bool (*enter)(void *live);
    bool (*back)(void *live);
    bool (*tab)(void *live, int step);
    bool (*escape)(void *live);

    const GestureView *(*gesture)(const void *live);

    /* What is selected: all of it (live->selected is the last of it). */
    const Item *(*selection)(const void *live, size_t *count);
    void (*add)(void *live, Item thing); /* or takes it away */
    void (*select_all)(void *live);

    /* Done to what is selected, each a step; false: nothing was done, a fault says why. `handle` walks the handles of
     * what is selected, so that a nudge moves that one: a wall's end, a corner; step 0: none. */
    void (*handle)(void *live, int step);
    bool (*nudge)(void *live, Vec2 by, Fault *fault);
    bool (*turn)(void *live, double degrees, Fault *fault);
    bool (*topple)(void *live, Fault *fault); /* or stands it up */
    bool (*split)(void *live, Fault *fault);  /* a wall, in the middle of its segment nearest to the hand */
    bool (*remove)(void *live, Fault *fault);
    bool (*duplicate)(void *live, Fault *fault);
    char *(*copy)(const void *live); /* text for a clipboard, NULL: nothing is selected; memory_free it */
    bool (*paste)(void *live, const char *text, Fault *fault); /* at the hand */

    /* An earthquake by the next seed, of the house as it stood before the last one if nothing was done since (both
     * NULL: it cannot). `shaken`: what came of it, "shake 3: 4 of 11 pieces fell". */
    bool (*shake)(void *live, Fault *fault);
    const char *(*shaken)(const void *live);

    /* What an edit sets moving in the picture alone, as furniture that falls: moves it on by so many s on the wall.
     * Where nobody calls it, all is at once as it will be. `animation`: words for what moves, "shaking (seed 3)", or
     * ""; NULL: all rests. */
    void (*animate)(void *live, double seconds);
    const char *(*animation)(const void *live);

    /* Undone and done again; names for menus, NULL: there is none. */
    bool (*undo)(void *live);
    bool (*redo)(void *live);
    const char *(*undo_name)(const void *live);
    const char *(*redo_name)(const void *live);

    /* A slider that is held: what live->set changes until `settle` is one step, and the clock is to be held. */
    void (*hold)(void *live, const char *name);
    void (*settle)(void *live);

    const EditText *(*texts)(const void *live, size_t *count);
    bool (*set_text)(void *live, const char *name, const char *value, Fault *fault);

    /* What the tool in the hand places, and which of it. */
    const CatalogueRow *(*items)(const void *live, size_t *count);
    size_t (*item)(const void *live);
    void (*choose)(void *live, size_t item);

    /* Changes that let everybody out, tried by simulation in the background (all three NULL: it cannot). `doing`: how
     * far, NULL: it is over. */
    void (*ask)(void *live);
    const Proposal *(*proposals)(const void *live, size_t *count, const char **doing);
    bool (*accept)(void *live, size_t proposal, Fault *fault);

    /* The picture to trace over; NULL path: none. */
    bool (*set_image)(void *live, const char *path, Fault *fault);
    void (*fade)(void *live, double opacity);
    TraceImage (*image)(const void *live);

    /* Files: a new, empty house in a kind's `open` has no path (NULL). `edits`: steps since the file; `text`: what a
     * file would hold, good until the next call. */
    size_t (*edits)(const void *live);
    bool (*changed)(const void *live);
    const char *(*text)(const void *live);
    bool (*save)(void *live, const char *path, Fault *fault);
} EditorFunctions;
