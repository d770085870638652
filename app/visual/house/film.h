/* An observation as a moving picture, in three layers: what stays (the plan, the answer, the dangerous points), what
 * comes and stays (loci, the bodies that have been somewhere), and what moves. Any time of the run can be shown, in any
 * order; shown in rising order, each time adds only what is new. */
#pragma once

#include "draw/scene.h"
#include "visual/house/furniture_fall.h"
#include "visual/house/house_scene.h"
#include "visual/house/trail.h"

/* What is shown on demand. */
enum {
    FILM_CIRCLES = 1, /* discs that cover the chairs */
    FILM_ROUTES = 2,  /* the planned ways */
    FILM_WIDTHS = 4,  /* W1 and W2, the widths before and behind each corner of a way */
};

/* "circles,routes" and so on as FILM_... added up; -1: *unknown is where a word begins that is none. */
int film_shown(const char *text, const char **unknown);

#define FILM_SHOWN_NAMES "circles,routes,widths"

/* What is shown unless it is hidden. */
enum {
    FILM_RINGS = 1,  /* personal spaces */
    FILM_LOCI = 2,   /* ways so far, and the bodies left on them */
    FILM_GHOST = 4,  /* what was before */
    FILM_DANGER = 8, /* discs of dangerous points */
    FILM_GRID = 16,
    FILM_NAMES = 32,  /* of people, furniture, rooms and doors */
    FILM_FORCES = 64, /* stars of contacts */
};

typedef struct FilmOptions {
    Camera camera;
    bool bare;     /* the house alone, without answer and list */
    int panels;    /* places for plots beside the plan, in place of the list */
    int shown;     /* FILM_CIRCLES and so on, added up */
    int hidden;    /* FILM_RINGS and so on, added up */
    Before before; /* whose loci are shown as "before" */
    bool live;     /* for a window: bodies are left as often however long the run becomes, and whoever was before is
                      seen moving, too */
    bool ahead;    /* the whole loci, thin, also before anybody has driven them */
    const House *observed; /* whose observation it is, when that is another plan with the same people and exits; NULL:
                              the same */
    const Trail *trails;   /* (person_count) of the observation, where somebody else lists them; otherwise NULL */
    const Scene *ways;     /* what route_scene_add makes, to be shown with the plan; or NULL */
    const FurnitureFall *falling; /* (falling_count) furniture on its way, by its id; each frame it is as it is then */
    size_t falling_count;
    Box box; /* m, what must be seen; without a width: the plan and all ways */
} FilmOptions;

typedef struct Film Film;

/* House and observation must outlive it. film_destroy releases it. */
Film *film_create(const House *house, const Observation *observation, const FilmOptions *options);
void film_destroy(Film *film);

/* The observation has more rows, and `trails` hold them: those it had are the same. */
void film_extend(Film *film);

/* From another place, but in the same kind of view; nothing is made anew. */
void film_look(Film *film, Camera camera);

/* The next film_show begins from nothing: film_added then holds all. */
void film_restart(Film *film);

/* The layer that stays. */
const Scene *film_still(const Film *film);

/* Moves to a time, s. False: back in time, what has been added must be forgotten; film_added then holds all. */
bool film_show(Film *film, double time);

/* Would film_show change nothing? */
bool film_is_unchanged(const Film *film, double time);

/* What has come since the last film_show, and what is there only now; good until the next. */
const Scene *film_added(const Film *film);
const Scene *film_moving(const Film *film);
