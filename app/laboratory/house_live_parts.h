/* What a house at work consists of: for the files house_live_*.c. */
#pragma once

#include "laboratory/film.h"
#include "laboratory/house_live.h"
#include "laboratory/house_live_things.h"
#include "laboratory/house_live_values.h"
#include "laboratory/house_live_worker.h"
#include "laboratory/house_plots.h"

typedef enum HouseGhost { GHOST_NONE, GHOST_BEFORE, GHOST_RIVAL } HouseGhost;

enum { HOUSE_CHOICES = 3, HOUSE_CHOICE_WORDS = 32 /* of one choice, at most */ };

/* The plots of what is shown, and how far their axes have grown. */
typedef struct LiveHousePlots {
    HousePlots plots;
    bool made;
    unsigned revision[HOUSE_PLOTS_KNOWN];
    Box grown[HOUSE_PLOTS_KNOWN]; /* while the run goes on */
    size_t person;                /* whose they are, or SIZE_MAX */
} LiveHousePlots;

/* What is said of what is shown. */
typedef struct HouseWords {
    Scene scene; /* holds answer, rows and texts */
    LiveRow *rows;
    LiveTick *ticks;
    size_t row_count, row_capacity, tick_count, tick_capacity;
    const char *title, *detail;
    Role role;
    double said; /* s, of a steady clock, when they were last made */
    double time; /* s, the moment that they tell of */
} HouseWords;

typedef struct HouseLive {
    HouseWish wish; /* as at the opening, route and driving as they are now */
    Plan plan;      /* as at the opening: names of routes, the title */
    Arena arena;    /* of the wish */

    HouseWorker *worker;
    HouseRun *shown;  /* NULL: nothing is read yet */
    HouseRun *latest; /* asked for after the one shown; NULL: none */
    HouseRun *older;  /* begun before the latest was asked for; NULL: none */
    HouseRun *before; /* kept, perhaps the one shown; NULL: none */
    HouseRun *rival;  /* the same house with the other way of driving; NULL: none */
    bool rival_over;  /* and can be shown */
    bool kept_itself; /* the one before, by the first change */

    Observation growing;            /* of the one shown while it goes on */
    const Observation *observation; /* of the one shown */
    bool whole;                     /* it is over */
    Film *film;
    Trail *trails; /* (person_count) of the one shown */
    bool remake;   /* the film must be made anew */
    bool fresh;    /* nothing of the film has been shown yet */
    Scene nothing; /* shown before anything is read */

    HouseGhost ghost;
    Camera camera;
    unsigned layers;
    LiveThing selected;
    unsigned changed; /* LIVE_... since the last update */
    HouseValues values;
    LiveHousePlots plots;
    HouseWords words;
    Text trouble;
    double trouble_time; /* s */
    double time;         /* s, shown last */

    LiveChoice choices[HOUSE_CHOICES]; /* (choice_count) */
    const char *choice_words[HOUSE_CHOICES][HOUSE_CHOICE_WORDS];
    size_t choice_count;
    const char **command; /* (command_count) */
    size_t command_count;
    Arena command_arena;
    char clock[32], doing[96], done[96], name[HOUSE_THING_NAME];
} HouseLive;

/* s, of a steady clock. */
double house_live_part_now(void);

/* What can be pointed at. Something is shown. */
static inline HouseScenery house_live_part_scenery(const HouseLive *live) {
    return (HouseScenery){&live->shown->house, live->observation, live->trails};
}

/* What is shown as a ghost; none: without an observation. */
Before house_live_part_ghost(const HouseLive *live);

/* The way of driving that the house has not. */
int house_live_part_rival(const HouseLive *live);

/* Of how much of the record it is known that it will not change any more, s. */
double house_live_part_end(const HouseLive *live);

/* The plots of what is shown now; `anew`: of another run, person or ghost, not only of more of the same. */
void house_live_plots_make(HouseLive *live, bool anew);
void house_live_plots_clear(HouseLive *live);
LivePlot house_live_plots_at(const HouseLive *live, size_t index);

/* Makes all words; `time` is shown. */
void house_live_words_make(HouseLive *live, double time);
void house_live_words_clear(HouseLive *live);

/* Has what is said of the moment changed since? */
bool house_live_words_moved(const HouseLive *live, double time);

LiveAnswer house_live_words_answer(HouseLive *live);

/* Is something else in work, or farther, than when this was asked last? */
bool house_live_words_does_other(HouseLive *live);

/* Ghost, route, driving, as far as there is something to choose. */
void house_live_choices_list(HouseLive *live);
void house_live_choices_take(HouseLive *live, size_t choice, size_t word);

/* Asks for a run of the present wish and values. */
void house_live_part_ask(HouseLive *live);

/* Releases a run that is neither shown nor before. */
void house_live_part_release(HouseLive *live, HouseRun *run);
