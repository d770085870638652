/* An observation as a moving picture, in three layers: the fixed part (the plan, the answer, the dangerous points),
 * the growing part (loci, bodies left along them) and the moving part. Any time of the run can be shown, in any order;
 * shown in rising order, each time adds only the new part. */
#pragma once

#include "draw/scene.h"
#include "inquiry/grade.h"
#include "visual/house/furniture_fall.h"
#include "visual/house/house_scene.h"
#include "visual/house/plan_walls.h"
#include "visual/house/trail.h"

/* Shown on request. */
enum {
    FILM_CIRCLES = 1,   /* discs that cover the chairs */
    FILM_ROUTES = 2,    /* the planned routes */
    FILM_WIDTHS = 4,    /* W1 and W2, the widths before and behind each corner of a route */
    FILM_ALL_NAMES = 8, /* names too long for their pieces stand next to them; not among the names of layers */
};

/* Returns the sum of the FILM_... that a text like "circles,routes" names; -1 on an unknown name, at which *unknown
 * then points. */
int film_shown(const char *text, const char **unknown);

#define FILM_SHOWN_NAMES "circles,routes,widths"

/* Shown unless hidden. */
enum {
    FILM_RINGS = 1,  /* personal spaces; of many people, how crowded it is */
    FILM_LOCI = 2,   /* loci so far, and the bodies left on them */
    FILM_GHOST = 4,  /* the comparison */
    FILM_DANGER = 8, /* discs of dangerous points, and names of impassable places */
    FILM_GRID = 16,
    FILM_NAMES = 32,  /* of furniture and rooms */
    FILM_FORCES = 64, /* stars of contacts */
};

typedef struct FilmOptions {
    Camera camera;
    bool bare;    /* the house alone, without answer and list */
    bool changed; /* the run is of a house that differs from its file: the name says so */
    int panels;   /* places for plots next to the plan, instead of the list */
    int shown;    /* sum of FILM_CIRCLES and so on */
    int hidden;   /* sum of FILM_RINGS and so on */
    const Grade
        *letters;  /* (person_count) of the grades that stand beside the answer, until the film is created; or NULL */
    Before before; /* the comparison, whose loci are shown as "before" */
    bool live;  /* for a window: the interval between bodies does not depend on the length of the run, and the people of
                   the comparison move, too */
    bool rests; /* an answer is being worked out: chairs stand at their starts, grey, without blockages */
    bool ahead; /* the whole loci, thin, also before they are driven */
    const House *observed; /* the house of the observation, if that is another plan with the same people and exits;
                              NULL: the same house */
    const Trail *trails;   /* (person_count) of the observation, if the caller has them already; otherwise NULL */
    const Scene *routes;   /* the result of route_scene_add, shown with the plan; or NULL */
    const Scene *drivers;  /* the band and the touches of many drivers, shown with the plan; or NULL.
                              Must outlive the film */
    const FurnitureFall
        *falling; /* (falling_count) falling furniture, by id; drawn in its present state in each frame */
    size_t falling_count;
    PlanWalls *walls; /* keeps the outlines of the walls from one film to the next, or NULL; must outlive the film */
    Box box;          /* m, must be visible; without a width: the plan and all loci */
} FilmOptions;

typedef struct Film Film;

/* Makes a film; house and observation must outlive it. film_destroy releases it. */
Film *film_create(const House *house, const Observation *observation, const FilmOptions *options);
void film_destroy(Film *film);

/* Announces that the observation and `trails` have more rows; the earlier rows must be unchanged. */
void film_extend(Film *film);

/* Moves the camera within the same kind of view; remakes nothing. */
void film_look(Film *film, Camera camera);

/* Makes the next film_show start from nothing: film_added then holds all. */
void film_restart(Film *film);

/* Returns the fixed layer. */
const Scene *film_still(const Film *film);

/* Moves to a time, s. False: the time lies before the last one, the caller must clear what was added, and film_added
 * holds all. */
bool film_show(Film *film, double time);

/* True if film_show would change nothing. */
bool film_is_unchanged(const Film *film, double time);

/* Returns what the last film_show has added, and the moving layer; valid until the next film_show. */
const Scene *film_added(const Film *film);
const Scene *film_moving(const Film *film);
