/* A laboratory at work: what a window opens, plays, shows and lets people change. One struct of functions a laboratory;
 * the window knows no more of houses and beams than what stands here, and they know no window, key or pixel.
 *
 * All calls come from one thread. What takes longer than a few milliseconds is done on threads of the laboratory's own;
 * `update` takes over their results. Everything that is recorded can be shown at any time, in any order, and looks the
 * same each time.
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
    const char *route;  /* id, or NULL: everybody */
    const char *origin; /* file that the one opened is a copy of, beside which the rest of it lies; NULL: it is none */
    int driving;        /* Driving, or -1 */
    uint64_t seed;
    int jobs; /* threads */
} LaboratoryOptions;

/* Changes since the last update: bits. */
enum {
    LABORATORY_VIEW = 1,       /* the layers: the static one must be repainted */
    LABORATORY_PLOTS = 2,      /* how many plots there are, or which */
    LABORATORY_WORDS = 4,      /* answer, rows, ticks */
    LABORATORY_PARAMETERS = 8, /* which there are, or their values */
    LABORATORY_TROUBLE = 16,   /* a new error: see `trouble` */
    LABORATORY_ALL = 31,
};

/* The stretch of time that can be displayed. */
typedef struct RecordSpan {
    double begin, end; /* s, recorded */
    bool complete;     /* it is over: no more will come by itself */
    bool endless;      /* more comes whenever it is reached for */
    double pace;       /* s shown in a second at speed 1 */
    double step;       /* s, of one shown frame: from picture to picture when stepping */
    double fastest;    /* the highest speed that makes sense, a power of two */
} RecordSpan;

typedef enum TimelineMarkKind { TIMELINE_CONTACT, TIMELINE_EXIT, TIMELINE_CHANGE, TIMELINE_TROUBLE } TimelineMarkKind;

/* A mark on the timeline. */
typedef struct TimelineMark {
    double time; /* s */
    TimelineMarkKind kind;
} TimelineMark;

typedef struct Result {
    const char *title; /* "Out in 18.4 s", "Chaotic"; before it is known "Driving ...", never NULL */
    Role role;         /* ROLE_TEXT, or ROLE_ERROR when the answer is no */
    const char *detail;
    bool stale;        /* of before the last change: shown grey */
    const char *doing; /* what is being worked out in the background, "types: 40 of 768 runs", or NULL */
    double part;       /* 0 to 1 of that; NAN: not known */
} Result;

/* Something that can be selected; kind 0: nothing. */
typedef struct Item {
    int kind;
    size_t index;
} Item;

static inline bool item_same(Item a, Item b) {
    return a.kind == b.kind && (!a.kind || a.index == b.index);
}

/* A row of the panel: as in a scene's list; choosing it shows its place, or goes to its time. */
typedef struct PanelRow {
    SceneRow row;
    Item thing;  /* selected by choosing it */
    Item place;  /* what matters most is there: of the first row that has one it is shown by "Show place" */
    double time; /* s, shown then; NAN: none */
} PanelRow;

/* A number that can be changed while it runs. */
typedef struct PanelParameter {
    const char *name;       /* as --set takes it: "door.d1.width" */
    const char *group;      /* a heading: "Wheelchair manual-chair", "Door d1" */
    const char *label;      /* "free speed" */
    const Parameter *row;   /* a number, a whole one, a flag or a choice */
    const char *meaning;    /* a sentence */
    const char *provenance; /* or NULL */
    const char *unit;       /* in which it is shown, "mm"; NULL: the row's */
    double factor;          /* value shown = value x factor; 0 counts as 1 */
    double value;           /* of a choice: the place of the word; of a flag 0 or 1 */
    double initial;         /* in the file */
    double low, high;       /* of a slider: the useful part of the row's range; typed values may go beyond it */
    bool logarithmic;       /* slider */
    bool first;             /* of those most looked for: shown without being asked for */
} PanelParameter;

typedef struct Preset {
    const char *name;    /* "III 300 Hz" */
    const char *meaning; /* a sentence */
} Preset;

/* A plot next to the view. Its series may grow from update to update; `until` says how many points are drawn. */
typedef struct LaboratoryPlot {
    const char *name;  /* "phase": in names of files, of --plots where that knows it; lives as long as the program */
    const char *title; /* for menus */
    const Plot *plot;  /* good until the next update */
    unsigned revision; /* another number: other axes or series, what was drawn is void */
    bool still;        /* it does not depend on the time shown */
    double cursor;     /* where an upright line stands, a value of x; NAN: none */
    const char *cursor_words;
    const char *cursor_parameter; /* that a click at a value of x sets; NULL: none */
    double cursor_factor;         /* value of x = this times the parameter's */
    Role now;                     /* of the disc where the series have come to; ROLE_PAPER: each series' own */
    double tail;                  /* s: the end of the lines that is drawn thick */
} LaboratoryPlot;

/* Edits what a laboratory shows: see edit/editor.h. */
typedef struct Editor Editor;

/* Something among a few: which ghost, which route, which pass of a sweep. */
typedef struct PanelChoice {
    const char *name;         /* "Ghost" */
    const char *meaning;      /* a sentence */
    const char *const *words; /* (count) "none", "before", "miura" */
    size_t count, chosen;
} PanelChoice;

enum { LABORATORY_LAYERS_MOST = 9, LABORATORY_OUTLINE_MOST = 128 };

typedef struct Laboratory {
    const char *name;            /* "House" */
    const char *word;            /* "house": begins "clearance-house", the format of its files */
    const char *plots_at_first;  /* "speed,clearance" */
    const char *const *layers;   /* (layer_count) names of what can be shown or hidden */
    const char *const *meanings; /* (layer_count) a sentence each */
    size_t layer_count;          /* at most LABORATORY_LAYERS_MOST */
    unsigned layers_at_first;    /* bits */
    bool raised;                 /* it can be looked at from the side */
    bool numbers_first;          /* the panel begins with the parameters */

    /* Begins with a file (`path` NULL: with an empty one, where there is an editor); the first pictures come with an
     * update. NULL: faults say why. Reading that takes longer than some 50 ms is done in the background, and its faults
     * come as trouble. `close` ends all threads. */
    void *(*open)(const char *path, const LaboratoryOptions *options, Fault *fault);
    void (*close)(void *session);

    /* Takes over new results; returns LABORATORY_... bits. `time` is displayed now. */
    unsigned (*update)(void *session, double time);

    RecordSpan (*span)(const void *session);

    /* Makes the record go up to a time, as far as that can be done at once; returns how far it goes. */
    double (*reach)(void *session, double time);

    /* Moves the layers to a time within the span, s; false: back in time, or all is new: what had been added to the
     * static layer must be forgotten, `added` holds all. */
    bool (*show)(void *session, double time);

    /* True if drawing at `time` gives the same pixels as the last draw. NULL: unknown. */
    bool (*rests)(const void *session, double time);
    const Scene *(*still)(void *session);
    const Scene *(*added)(const void *session);
    const Scene *(*moving)(const void *session);

    /* From where it is looked at; which layers are shown (bits). */
    void (*look)(void *session, Camera camera);
    void (*reveal)(void *session, unsigned layers);

    /* Plots. `until`: how many points of a series are drawn at a time. */
    size_t (*plot_count)(const void *session);
    LaboratoryPlot (*plot)(const void *session, size_t index);
    size_t (*until)(const void *session, size_t plot, size_t series, double time);

    Result (*answer)(void *session);

    /* "7.3 s", "cycle 481, 1.604 s": good until the next call. */
    const char *(*clock)(void *session, double time);

    /* A remark that belongs to every picture: "assumed plan: not measured"; "". */
    const char *(*note)(void *session);
    const char *(*title)(const void *session); /* of what is shown: its name */
    const PanelRow *(*rows)(const void *session, size_t *count);
    const TimelineMark *(*ticks)(void *session, size_t *count);

    /* The last error, with cause and cure, and its time (s; NAN: it belongs to no moment of the record); NULL: none.
     * The last good state stays. */
    const char *(*trouble)(const void *session, double *time);

    /* Parameters, good until the next update that changes them. False: a fault says what is allowed, and the value
     * is as it was. */
    const PanelParameter *(*parameters)(const void *session, size_t *count);
    bool (*set)(void *session, const char *name, double value, Fault *fault);
    void (*reset)(void *session); /* all of them as in the file */

    /* A slider that is dragged: all changes that `set` makes until `settle` are one step of undo, and the clock must be
     * held. NULL: there are no steps. */
    void (*hold)(void *session, const char *name);
    void (*settle)(void *session);

    const Preset *(*presets)(const void *session, size_t *count);
    void (*prefer)(void *session, size_t preset);

    const PanelChoice *(*choices)(void *session, size_t *count);
    void (*choose)(void *session, size_t choice, size_t word);

    /* Restarts with the same parameters; saves the displayed run for comparison (false: there is nothing to save yet);
     * forgets that, and the trace and the points so far. */
    void (*again)(void *session);
    bool (*keep)(void *session, double time);
    void (*clear)(void *session, double time);

    /* Returns the item at a place, m on the floor; `below`: the next item under this one. */
    Item (*pick)(const void *session, Vec2 at, double time, Item below);
    Item (*next)(const void *session, Item thing, int step); /* round, in a fixed order */
    void (*select)(void *session, Item thing);
    Item (*selected)(void *session);
    const char *(*name_thing)(void *session, Item thing); /* "door d2" */

    /* Its outline at a time (m): how many points, at most LABORATORY_OUTLINE_MOST; 0: it is nowhere then. */
    size_t (*outline)(void *session, Item thing, double time, Vec2 *points);

    /* The words behind "clearance" that make what is shown: "run", FILE, "--set", ... (count) */
    const char *const *(*command)(void *session, size_t *count);

    /* Digest of the run that is shown; NULL: it has none. */
    uint64_t (*digest)(void *session);

    /* Writes what is shown, with its changed numbers, as a file that can be opened again; false: a fault says why not.
     */
    bool (*save)(void *session, const char *path, Fault *fault);

    /* An edit may set something moving in the picture alone, as furniture that falls: moves it on by s of real time.
     * Where this is never called, everything is at once in its last place. `animation`: words for what moves, "shaking
     * (seed 3)", or ""; NULL: all rests. Both NULL: nothing ever moves so. */
    void (*animate)(void *session, double seconds);
    const char *(*animation)(void *session);

    /* Fills mono samples, -1 to 1, of the stretch from one time to another; false: it is silent. */
    bool (*sound)(void *session, double from, double to, float *samples, size_t count);

    /* The editor of what is open; NULL: nothing can be edited. */
    Editor *(*editor)(void *session);
} Laboratory;

extern const Laboratory house_laboratory, beam_laboratory;

/* Returns the index of the laboratory that a file belongs to, by what is in it; 0 if nothing in it says so. */
size_t laboratory_of(const char *path);

/* Returns the index of the laboratory with a word ("house"); laboratories_count: none has it. */
size_t laboratory_find(const char *word);

/* Returns the folder of the files that come with the program, and the path of the one that is opened first, in the
 * arena. */
const char *laboratory_folder(size_t index);
const char *laboratory_file(size_t index, Arena *arena);
