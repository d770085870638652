/* A running laboratory: the window opens and plays it, and people change its parameters. Each laboratory is one struct
 * of functions; the window knows houses, beams and cranks only through this header, and laboratories do not know
 * windows, keys or pixels.
 *
 * All calls come from one thread. Work that takes longer than a few milliseconds runs on threads of the laboratory;
 * `update` takes over the results. Every recorded time can be displayed, in any order, and looks the same each time.
 *
 *     open -> { set, choose ... }   update -> reach -> show -> scenes, plots   answer, rows, ticks                   */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/fault.h"
#include "base/parameters.h"
#include "base/text.h"
#include "plot/plot.h"
#include "draw/scene.h"

typedef struct LaboratoryOptions {
    const char *profiles;        /* directory of the shipped profiles */
    const char *const *settings; /* (setting_count) NAME=VALUE */
    size_t setting_count;
    const char *route;  /* id, or NULL: all people */
    const char *origin; /* the original of the opened copy; related files lie in its folder; NULL: the opened file is
                           not a copy */
    int driving;        /* Driving, or -1 */
    uint64_t seed;
    int jobs; /* threads */
} LaboratoryOptions;

/* Changes since the last update: bits. */
enum {
    LABORATORY_VIEW = 1,       /* the layers: the static one must be repainted */
    LABORATORY_PLOTS = 2,      /* the number or the kind of plots */
    LABORATORY_TEXTS = 4,      /* answer, rows, ticks */
    LABORATORY_PARAMETERS = 8, /* the list of parameters, or their values */
    LABORATORY_ERROR = 16,     /* a new error: see `error` */
    LABORATORY_ALL = 31,
    LABORATORY_RESTART = 32, /* another run takes the place of the shown one: the clock goes back to the beginning */
};

/* The stretch of time that can be displayed. */
typedef struct RecordSpan {
    double begin, end; /* s, recorded */
    bool complete;     /* the record is complete: it does not grow by itself */
    bool endless;      /* the record grows whenever a later time is reached for */
    double pace;       /* s of record per second of playback at speed 1 */
    double step;       /* s, duration of one displayed frame: the size of a single step */
    double fastest;    /* highest useful speed, a power of two */
} RecordSpan;

typedef enum TimelineMarkKind { TIMELINE_CONTACT, TIMELINE_EXIT, TIMELINE_CHANGE, TIMELINE_ERROR } TimelineMarkKind;

/* A mark on the timeline. */
typedef struct TimelineMark {
    double time; /* s */
    TimelineMarkKind kind;
} TimelineMark;

/* Something that can be selected; kind 0: nothing. */
typedef struct Item {
    int kind;
    size_t index;
} Item;

static inline bool item_same(Item a, Item b) {
    return a.kind == b.kind && (!a.kind || a.index == b.index);
}

typedef struct Result {
    const char *title; /* "Out in 18.4 s", "Chaotic"; "Finding ways" before the result is known; never NULL */
    Role role;         /* ROLE_TEXT, or ROLE_ERROR if the answer is negative */
    const char *detail;
    bool stale;        /* the answer is older than the last change: shown grey, nobody moves, and no other number of
                          either run is shown */
    bool due;          /* the answer is older than the last change, also as long as that is too short to be shown */
    const char *doing; /* work in the background, "types: 40 of 768 runs", or NULL */
    bool grading;      /* True while the grade in the title is worked out, which needs no words */
    bool shaking;      /* True while many earthquakes are worked out, of which the panel tells */
    double part;       /* completed share of that work, 0 to 1; NAN: unknown */
    const char *cure;  /* words of a button that takes a tool: "Add an exit"; NULL: none */
    int tool;          /* that EditTool */
    Vec2 cure_at;      /* m, where it is needed; NAN: anywhere */
    Item last;         /* the last person of a crowd who leaves, once all have; kind 0: none */
    double last_time;  /* s, shortly before that */
    bool broken;       /* nothing can be run, so no fix can be tried */
} Result;

/* The action of a row of the panel that is a button. */
typedef enum RowAct { ROW_ACT_NONE, ROW_ACT_SHAKE, ROW_ACT_STAND_UP, ROW_ACT_FIX } RowAct;

/* A row of the panel, as in a scene's list; choosing it shows its place, or goes to its time. The second cell of a
 * heading is told while its list is folded. */
typedef struct PanelRow {
    SceneRow row;
    RowAct act;       /* not NONE: the row is a button with the text of the first cell; neighbours stand side by side */
    const char *help; /* of a button */
    bool has_bar;     /* a bar between the first cell and the others */
    double bar;       /* 1, its filled part */
    bool advice;      /* of a heading: its list tells what a lesson may ask for, and is left out there */
    Item item;        /* item that choosing the row selects */
    Item place;       /* place of the row's main result; "Show place" uses the first row that has one */
    double time;      /* s, time that choosing the row displays; NAN: none */
} PanelRow;

/* A parameter that can be changed while the laboratory runs. */
typedef struct PanelParameter {
    const char *name;       /* name as in --set: "door.d1.width" */
    const char *group;      /* a heading: "Wheelchair manual-chair", "Door d1" */
    const char *label;      /* "free speed" */
    const Parameter *row;   /* type of the value: a number, an integer, a flag or a choice */
    const char *meaning;    /* a sentence */
    const char *provenance; /* or NULL */
    const char *unit;       /* displayed unit, "mm"; NULL: the row's unit */
    double factor;          /* displayed value = value x factor; 0 counts as 1 */
    double value;           /* choice: index of the word; flag: 0 or 1 */
    double initial;         /* value in the file */
    double low, high;       /* range of the slider: the useful part of the row's range; typed values may exceed it */
    bool logarithmic;       /* the slider is logarithmic */
    bool first;             /* one of the main parameters: shown by default */
    bool idle;              /* without effect as the others are: not shown */
} PanelParameter;

typedef struct Preset {
    const char *name;    /* "III 300 Hz" */
    const char *meaning; /* a sentence */
} Preset;

/* A plot next to the view. Its series may grow at each update; `until` returns how many points are drawn. */
typedef struct LaboratoryPlot {
    const char *name;  /* "phase": used in file names and by --plots; lives as long as the program */
    const char *title; /* title for menus */
    const Plot *plot;  /* valid until the next update */
    unsigned revision; /* changes with the axes or series: the drawn plot is then invalid */
    bool still;        /* the plot does not depend on the displayed time */
    double cursor;     /* place of a vertical line, a value of x; NAN: none */
    const char *cursor_text;
    const char *cursor_parameter;   /* parameter that a click at a value of x sets; NULL: none */
    double cursor_factor;           /* value of x = cursor_factor x the parameter's value */
    double cursor_y;                /* the same for y, with a level line, of a plot that has cursor_y_parameter; */
    const char *cursor_y_parameter; /* NULL: none */
    double cursor_y_factor;
    Role now;    /* role of the disc at the present end of the series; ROLE_PAPER: each series' own role */
    double tail; /* s: length of the line's end that is drawn thick */
    bool ahead;  /* the rest of the series, after the displayed time, is drawn pale */
} LaboratoryPlot;

/* Edits the displayed house: see edit/editor.h. */
typedef struct Editor Editor;

/* A choice among a few words: the ghost, the route, the pass of a sweep. */
typedef struct PanelChoice {
    const char *name;           /* "Ghost" */
    const char *meaning;        /* a sentence */
    const char *const *options; /* (count) "none", "before", "miura" */
    size_t count, chosen;
} PanelChoice;

enum { LABORATORY_LAYERS_MOST = 10, LABORATORY_OUTLINE_MOST = 128 };

/* A bit of layers: names too long for their pieces stand next to them, instead of being left out. */
enum { LABORATORY_ALL_NAMES = 1 << LABORATORY_LAYERS_MOST };

/* The runs that the parts of the window show: equal numbers are the same run, 0 is none. */
typedef struct LaboratoryRuns {
    uint64_t answer, picture, rows, plots;
    bool working; /* a newer run is being computed: the answer is grey, and the other parts show no numbers */
} LaboratoryRuns;

typedef struct Laboratory {
    const char *name;            /* "House" */
    const char *word;            /* "house": part of the format name "clearance-house" of its files */
    const char *plots_at_first;  /* "speed,clearance" */
    const char *plots_in_order;  /* "speed,clearance,force": the plots of larger windows; NULL: plots_at_first */
    const char *const *layers;   /* (layer_count) names of the layers that can be shown or hidden */
    const char *const *meanings; /* (layer_count) a sentence each */
    size_t layer_count;          /* at most LABORATORY_LAYERS_MOST */
    unsigned layers_at_first;    /* bits of the layers that are shown at first */
    bool raised;                 /* a raised view is available */
    bool numbers_first;          /* the panel begins with the parameters */

    /* Opens a file (`path` NULL: an empty one, if there is an editor); the first pictures come with an update. NULL:
     * faults give the reasons. Reading that takes longer than about 50 ms runs in the background and reports its
     * faults by `error`. `close` ends all threads. */
    void *(*open)(const char *path, const LaboratoryOptions *options, Fault *fault);
    void (*close)(void *session);

    /* Takes over new results; returns LABORATORY_... bits. `time` is the displayed time. */
    unsigned (*update)(void *session, double time);

    /* Brings the texts to the time at which the layers will be shown, which update did not know yet. NULL: no text
     * counts what the picture counts. */
    void (*tell)(void *session, double time);

    RecordSpan (*span)(const void *session);

    /* Extends the record towards a time as far as possible at once; returns the end of the record. */
    double (*reach)(void *session, double time);

    /* Moves the layers to a time within the span, s. False: the time went back, or all is new: discard all additions
     * to the static layer, since `added` holds the complete set. */
    bool (*show)(void *session, double time);

    /* True if drawing at `time` gives the same pixels as the last draw. NULL: unknown. */
    bool (*is_unchanged)(const void *session, double time);
    const Scene *(*still)(void *session);
    const Scene *(*added)(const void *session);
    const Scene *(*moving)(const void *session);

    /* Set the camera and the bits of the shown layers, with LABORATORY_ALL_NAMES or without. */
    void (*set_camera)(void *session, Camera camera);
    void (*set_layers)(void *session, unsigned layers);

    /* Plots. `until`: number of points of a series that are drawn at a time. */
    /* Names of the plots that this session opens by itself; "": none, there is nothing to plot; NULL, or returning
     * NULL: plots_at_first, if there is room. */
    const char *(*plots_for)(const void *session);

    /* Notes which plots are in the window, names separated by commas: what is costly is computed only while it is
     * shown. NULL: all plots are made anyway. */
    void (*note_plots)(void *session, const char *names);

    size_t (*plot_count)(const void *session);
    LaboratoryPlot (*plot)(const void *session, size_t index);
    size_t (*points_until)(const void *session, size_t plot, size_t series, double time);

    Result (*answer)(void *session);

    /* Returns "7.3 s", "cycle 481, 1.604 s", valid until the next call. */
    const char *(*clock)(void *session, double time);

    /* Returns a remark that belongs to every picture: "assumed plan: not measured"; "" for none. */
    const char *(*note)(void *session);
    const char *(*title)(const void *session); /* name of the displayed house or beam */
    const PanelRow *(*rows)(const void *session, size_t *count);
    const TimelineMark *(*marks)(void *session, size_t *count);

    /* Returns the last error, with cause and remedy, and its time (s; NAN: it belongs to no time of the record);
     * NULL: none. The last valid state stays displayed. */
    const char *(*error)(const void *session, double *time);

    /* Parameters, valid until the next update that changes them. False: the fault says which values are allowed, and
     * the value is unchanged. */
    const PanelParameter *(*parameters)(const void *session, size_t *count);
    bool (*set)(void *session, const char *name, double value, Fault *fault);
    void (*reset)(void *session); /* sets all parameters back to the values in the file */

    /* Start and end the dragging of a slider: all changes by `set` before `settle` form one undo step, and the clock
     * must be paused. NULL: there are no undo steps. */
    void (*begin_number)(void *session, const char *name);
    void (*end_number)(void *session);

    const Preset *(*presets)(const void *session, size_t *count);
    void (*apply_preset)(void *session, size_t preset);

    const PanelChoice *(*choices)(void *session, size_t *count);
    void (*choose)(void *session, size_t choice, size_t word);

    /* Returns the runs that are shown, for tests. NULL: every part always shows the present one. */
    LaboratoryRuns (*runs)(void *session);

    /* Gives up the work on the last change, and undoes it: the shown run stays. NULL: there is no such work. */
    void (*stop)(void *session);

    /* Follows the running orbit along the orbit diagram in the background, or removes the lines of the one that is
     * displayed or being followed. Returns true if it is being followed now. NULL: it has no orbits. */
    bool (*follow)(void *session);

    /* Restart with the same parameters; save the displayed run for comparison (false: there is nothing to save yet);
     * discard the saved run, the trace and the points so far. */
    void (*restart)(void *session);
    bool (*save_run)(void *session, double time);
    void (*clear_runs)(void *session, double time);

    /* Returns the item at a place, m on the floor; `below`: the next item under this one. */
    Item (*pick)(const void *session, Vec2 at, double time, Item below);
    Item (*next)(const void *session, Item item, int step); /* cycles through the items in a fixed order */
    void (*select)(void *session, Item item);
    Item (*selected)(void *session);
    const char *(*item_name)(void *session, Item item);        /* "bedroom door" */
    const char *(*item_key)(void *session, Item item);         /* "door d2", as in files; NULL: the same as the name */
    const char *(*name_at)(void *session, Item item, Vec2 at); /* at a place on it, m; NULL: the same everywhere */

    /* Writes the outline of an item at a time (m), its parts with a point that is not a number between them; returns
     * the number of points, at most LABORATORY_OUTLINE_MOST; 0: the item has no place at that time. */
    size_t (*outline)(void *session, Item item, double time, Vec2 *points);

    /* Returns the words after "clearance" that reproduce the displayed run: "run", FILE, "--set", ... (count). */
    const char *const *(*command)(void *session, size_t *count);

    /* Returns the digest of the displayed run; NULL: the laboratory has none. */
    uint64_t (*digest)(void *session);

    /* Writes the displayed house or beam, with its changed parameters, as a file that can be opened; false: the
     * fault gives the reason. */
    bool (*save)(void *session, const char *path, Fault *fault);

    /* Advances an animation that an edit started in the picture only, such as falling furniture, by s of real time.
     * If it is never called, everything is in its final place at once. `animation`: text for the moving items,
     * "shaking (seed 3)", or ""; NULL: all rests. Both functions NULL: there are no animations. */
    void (*animate)(void *session, double seconds);
    const char *(*animation)(void *session);

    /* Fills mono samples, -1 to 1, for the interval between two times; false: the interval is silent. */
    bool (*sound)(void *session, double from, double to, float *samples, size_t count);

    /* Returns the editor; NULL: the open file cannot be edited. */
    Editor *(*editor)(void *session);

    /* Opens a session of the same plan with a proposal of the editor, closed as others are; NULL: the
     * index is invalid, or the fault says why not. The function is NULL without proposals. */
    void *(*open_proposal)(void *session, size_t proposal, Fault *fault);
} Laboratory;

extern const Laboratory house_laboratory, beam_laboratory, crank_laboratory;

/* Returns the index of the laboratory that a file belongs to by its contents; 0 if the contents do not say. */
size_t laboratory_of(const char *path);

/* Returns the index of the laboratory with a word ("house"); laboratories_count: none has it. */
size_t laboratory_find(const char *word);

/* Returns the folder of the shipped files, and the path of the file that is opened by default, in the arena. */
const char *laboratory_folder(size_t index);
const char *laboratory_file(size_t index, Arena *arena);
