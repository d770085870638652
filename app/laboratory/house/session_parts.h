/* The state of a house session, for the files of this folder. */
#pragma once

#include "plan/draft.h"
#include "visual/house/film.h"
#include "laboratory/edit/editor.h"
#include "laboratory/house/session.h"
#include "laboratory/house/fall.h"
#include "laboratory/house_items.h"
#include "laboratory/house/values.h"
#include "laboratory/house/worker.h"
#include "visual/house/house_plots.h"

typedef enum HouseGhost { GHOST_NONE, GHOST_BEFORE, GHOST_RIVAL } HouseGhost;

/* In the order of the keys 1 to 9. */
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
    LAYERS,
} HouseLayer;
_Static_assert((int)LAYERS <= (int)LABORATORY_LAYERS_MOST, "a key for each layer");

enum { HOUSE_CHOICES = 3, HOUSE_CHOICE_WORDS = 32 /* of one choice, at most */ };

/* Plots of what is shown, and how far their axes have grown. */
typedef struct ShownPlots {
    HousePlots plots;
    bool made;
    unsigned revision[HOUSE_PLOTS_KNOWN];
    Box grown[HOUSE_PLOTS_KNOWN]; /* while the run goes on */
} ShownPlots;

/* The texts about the displayed run. */
typedef struct HouseWords {
    Scene clean;                 /* holds the answer of the draft when the run is mixed */
    Scene run;                   /* holds what is said of the run: its answer, its list */
    Scene moment;                /* holds what is said of what is selected, and of before and now */
    double before[HAZARDS_MOST]; /* s, shortly before a person reaches each dangerous point */
    PanelRow *rows;              /* (row_count) */
    TimelineMark *ticks;         /* (tick_count) */
    size_t row_count, row_capacity, tick_count, tick_capacity;
    const char *title, *detail;
    Role role;
    double said; /* s, of a steady clock, when they were last made */
    double time; /* s, the moment that they tell of */
    char doing[96], done[96], clock[32], note[192], name[HOUSE_THING_NAME];
} HouseWords;

/* The roles of runs: see runs.h. */
typedef enum HouseRunRole {
    RUN_SHOWN,
    RUN_LATEST,
    RUN_OLDER,
    RUN_MIXED,
    RUN_CLEAN,
    RUN_EARLY,
    RUN_BEFORE,
    RUN_RIVAL,
    RUN_ROUTES,
    RUN_ROLES,
} HouseRunRole;

typedef struct HouseSession {
    Draft *draft;            /* the house as it is edited */
    Editor *editor;          /* of that */
    HouseWish wish;          /* without the house; route and driving as they are now */
    LaboratoryOptions given; /* with which it was opened */
    Arena arena;             /* of both */
    HouseHistory history;    /* that is to be shown */
    double time;             /* s, that is shown */

    HouseWorker *worker;
    HouseRun *runs[RUN_ROLES]; /* see runs.h; NULL: none */
    bool kept_itself;          /* the one before, by a change */

    Observation growing;            /* of the one shown while it goes on */
    const Observation *observation; /* of the one shown */
    TrailGrowth trails;             /* of that */
    bool whole;                     /* the one shown is over */
    Film *film;                     /* NULL: none was made yet */
    bool film_is_stale;             /* it must be made before it is displayed again */
    size_t epoch;                   /* of the run, that the film is of */
    bool fresh;                     /* nothing of the film has been shown yet */
    Scene nothing;                  /* shown before anything is read */
    HouseFall fall;                 /* in the picture alone */

    HouseGhost ghost;
    Camera camera;
    unsigned layers;
    Item selected;
    unsigned changed;           /* LABORATORY_... bits since the last update */
    bool retell;                /* the texts of the run are out of date, not only those of the moment */
    HouseValues values, opened; /* as they are; and as they were at the opening */
    ShownPlots plots;
    HouseWords words;
    Text trouble;
    double trouble_time; /* s; NAN: of no moment */

    PanelChoice choices[HOUSE_CHOICES]; /* (choice_count) */
    const char *choice_words[HOUSE_CHOICES][HOUSE_CHOICE_WORDS];
    size_t choice_count;
    const char **command; /* of house_command_words */
    Arena command_arena;
} HouseSession;

/* The items that can be pointed at; a run is displayed. */
static inline HouseScenery house_scenery(const HouseSession *session) {
    return (HouseScenery){&session->runs[RUN_SHOWN]->house, session->observation, session->trails.trails};
}

/* The film must be made again before it is displayed. */
static inline void house_session_void_film(HouseSession *session) {
    session->film_is_stale = true;
    session->changed |= LABORATORY_VIEW;
}

static inline bool house_session_has_film(const HouseSession *session) {
    return session->film && !session->film_is_stale;
}

/* Makes it, where that is to be, for a time. */
void house_show_make(HouseSession *session, double time);

/* Makes the plots of the displayed run; `anew`: of another run, person or ghost, not only with more rows. */
void house_session_plots_make(HouseSession *session, bool anew);
void house_session_plots_clear(HouseSession *session);
LaboratoryPlot house_session_plots_at(const HouseSession *session, size_t index);
