/* Watches a world step by step and collects the data of an observation. */
#pragma once

#include "house/change.h"
#include "house/hazard.h"
#include "house/observation.h"
#include "house/world.h"

/* The extremes of a person since the last row of the trace. */
typedef struct Extremes {
    double clearance;              /* m, least */
    double ring;                   /* m, and the greatest of these */
    double body_force, ring_force; /* N */
    Vec2 contact;                  /* m, point of the hardest contact */
} Extremes;

enum { SQUEEZE_PARTS = 10 };

/* The contact force over the last OBSERVATION_SQUEEZE, in equal parts of time. */
typedef struct Squeeze {
    double parts[SQUEEZE_PARTS]; /* N s, each; the present one is at `part` */
    int part;
    double elapsed; /* s, of the present part */
} Squeeze;

/* State of a person that is stored between steps. */
typedef struct Watched {
    Vec2 at;          /* m, the reference point one step ago */
    double offset;    /* m, from the track, one step ago */
    double untouched; /* s, since the last contact of the body */
    size_t touch;     /* index of the last touch of the body, plus 1; 0: none yet */
    double ended;     /* m, path length at which the present stretch ends */
    size_t stretch;   /* index of the present stretch, plus 1; 0: none yet */
    double time;      /* s */
    Extremes extremes;
    Squeeze squeeze;
    bool hands[2]; /* True while something is in the space of the left and the right hand */
    bool backs;    /* True while the chair drives backwards */
    bool leapt; /* True if the offset has changed faster than the person moved since the last row: it belongs to another
                   part of the path */
    bool done;
} Watched;

/* The paths of walkers, square by square. */
typedef struct Floor {
    Vec2 low;    /* m */
    double side; /* m */
    int nx, ny;
    size_t *stretch; /* (ny x nx) stretch of each square, plus 1; 0: not visited */
} Floor;

typedef struct Observer {
    const World *world;
    PersonObservation *people; /* (count) not owned: only people who take part are written */
    Watched *watched;          /* (count) */
    size_t *riders;            /* (rider_count) people in chairs */
    size_t rider_count;
    size_t sample_steps; /* steps between two rows of the trace */
    Trace trace;
    double *door_opened; /* (doors of the plan) s; infinite: not opened yet */
    int door_changes;    /* door changes of the world that have been processed */
    Floor floor;
    Stretch *stretches; /* (stretch_count) */
    size_t stretch_count, stretch_capacity;
    Touch *touches; /* (touch_count) in the order in which they begin */
    size_t touch_count, touch_capacity;
} Observer;

/* Returns the number of steps between two rows of the trace: run.sample, or more if the rows of very many people until
 * run.until would exceed the memory. */
size_t observer_sample_steps(const House *house);

/* Starts watching a world that has not moved yet. observer_clear releases the observer, not the people. */
void observer_init(Observer *observer, const World *world, PersonObservation *people);
void observer_clear(Observer *observer);

/* Records the state after each step_world. Chairs are watched at every step, walkers when world->sensed; the largest
 * values of walkers (forces, ring) are the largest at those moments. */
void observer_watch(Observer *observer);

/* Completes the records up to now before the world moves to a changed house. */
void observer_catch_up(Observer *observer);

/* Converts all records, including the rows of the trace, to the changed house, whose `people` (its person_count,
 * zeroed) are filled in, and drops removed people. */
void observer_rename(Observer *observer, const Change *change, PersonObservation *people);

/* Continues after the world has moved to the changed house: there are new people, and paths have changed. */
void observer_resume(Observer *observer);

/* Ends after the last step: people who are still moving end with `reason`. */
void observer_end(Observer *observer, Reason reason);
