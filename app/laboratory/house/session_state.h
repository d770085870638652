/* The state of a house session, for the files of this folder only. */
#pragma once

#include "plan/draft.h"
#include "visual/house/film.h"
#include "laboratory/edit/editor.h"
#include "laboratory/house/missing.h"
#include "result/tight.h"
#include "laboratory/house/session.h"
#include "laboratory/house/fall.h"
#include "laboratory/house_items.h"
#include "laboratory/house/values.h"
#include "laboratory/house/worker.h"
#include "visual/house/house_plots.h"

typedef enum HouseGhost { GHOST_NONE, GHOST_BEFORE, GHOST_RIVAL } HouseGhost;

/* The layers, in the order of the keys 1 to 9; the last one has the key of ACTION_DRIVERS. */
typedef enum HouseLayer {
    LAYER_RINGS,
    LAYER_LOCI,
    LAYER_GHOST,
    LAYER_DANGER,
    LAYER_WIDTHS,
    LAYER_GRID,
    LAYER_NAMES,
    LAYER_FORCES,
    LAYER_CIRCLES,
    LAYER_DRIVERS,
    LAYERS,
} HouseLayer;
_Static_assert((int)LAYERS <= (int)LABORATORY_LAYERS_MOST, "a bit for each layer");

enum { HOUSE_CHOICES = 4, HOUSE_CHOICE_OPTIONS = 32 /* a choice has at most this many */ };

/* The plots of the displayed run, and how far their axes have grown. */
typedef struct ShownPlots {
    HousePlots plots;
    bool made;
    unsigned revision[HOUSE_PLOTS_KNOWN];
    Box grown[HOUSE_PLOTS_KNOWN]; /* extent of the axes while the run is in progress */
} ShownPlots;

/* The texts about the displayed run. */
typedef struct HouseTexts {
    Scene run;                 /* holds the texts about the run: its answer, its list */
    Scene moment;              /* holds the texts about the selection and the comparison */
    double before[TIGHT_MOST]; /* s, shortly before a person reaches each dangerous point, or when a jam is worst */
    PanelRow *rows;            /* (row_count) */
    TimelineMark *marks;       /* (mark_count) */
    size_t row_count, row_capacity, mark_count, mark_capacity;
    size_t last; /* the last person out; SIZE_MAX: nobody is */
    const char *title, *detail;
    Role role;
    Missing missing; /* what the house lacks; title NULL: nothing */
    double said;     /* s, of a steady clock, at the last update of the texts */
    double time;     /* s, the time that the texts describe */
    char doing[128], done[128], clock[32], note[192], name[HOUSE_ITEM_NAME];
} HouseTexts;

/* The roles of runs: see runs.h. */
typedef enum HouseRunRole {
    RUN_SHOWN,
    RUN_LATEST,
    RUN_OLDER,
    RUN_MIXED,
    RUN_EARLY,
    RUN_BEFORE,
    RUN_RIVAL,
    RUN_ROUTES,
    RUN_GRADES,
    RUN_CREW,
    RUN_SHAKES,
    RUN_ROLES,
} HouseRunRole;

typedef struct HouseSession {
    Draft *draft;            /* the edited house */
    Editor *editor;          /* the editor of the draft */
    HouseWish wish;          /* without the house; with the present route and driving model */
    LaboratoryOptions given; /* the options at the opening */
    Arena arena;             /* holds the texts of wish and options */
    HouseHistory history;    /* the history that must be displayed */
    double time;             /* s, the displayed time */

    HouseWorker *worker, *crew_worker;
    const Crew *crew;          /* the drivers that the picture shows; NULL: none */
    const Outlook *outlook;    /* the earthquakes that the panel shows; NULL: none */
    uint64_t standing;         /* of the house whose earthquakes they are: EditorShake.standing */
    HouseRun *runs[RUN_ROLES]; /* see runs.h; NULL: none */
    bool stored_by_itself;     /* the saved run was saved automatically by a change */
    bool undone;               /* the shown run is that of the draft again, and its numbers must be taken over */
    bool changes_on_the_way;   /* an edit applies from the displayed time on; otherwise from the beginning */
    double edited;             /* s, of a steady clock, when the newest run was requested; NAN: it is displayed */
    bool settles;              /* that was so long ago that the old run is no longer displayed as if it held */

    Observation growing;                  /* the observation of the displayed run while it is in progress */
    const Observation *observation;       /* the observation of the displayed run */
    TrailGrowth trails;                   /* trails of that observation */
    bool whole;                           /* the displayed run is over */
    Film *film;                           /* NULL: not made yet */
    PlanWalls walls;                      /* of the film */
    bool film_is_stale;                   /* the film must be rebuilt before it is displayed */
    size_t epoch;                         /* the epoch of the run that the film shows */
    uint64_t film_of, texts_of, plots_of; /* identities of the runs that they show, see house_runs_identity */
    bool fresh;                           /* nothing of the film has been displayed yet */
    Scene nothing;                        /* displayed before the first house is read */
    Scene plain;                          /* the plan of a file whose house cannot be run */
    HouseFall fall;                       /* only in the picture */

    HouseGhost ghost;
    Camera camera;
    unsigned layers;
    Item selected;
    unsigned changed;           /* LABORATORY_... bits since the last update */
    bool texts_are_stale;       /* the texts of the run are out of date, not only the texts of the moment */
    HouseValues values, opened; /* the present values; the values at the opening */
    ShownPlots plots;
    HouseTexts texts;
    Text error;
    double error_time; /* s; NAN: the error belongs to no time */

    PanelChoice choices[HOUSE_CHOICES]; /* (choice_count) */
    const char *choice_options[HOUSE_CHOICES][HOUSE_CHOICE_OPTIONS];
    size_t choice_count;
    const char **command; /* the words of the command line */
    Arena command_arena;
} HouseSession;
