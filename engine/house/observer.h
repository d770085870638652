/* Watches a world, step by step, and keeps what an observation needs. */
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
    Vec2 contact;                  /* m, of the hardest */
} Extremes;

/* What is remembered of a person between steps. */
typedef struct Watched {
    Vec2 at;          /* m, the reference point one step ago */
    double offset;    /* m, from the track, one step ago */
    double untouched; /* s, since the body last touched something */
    double ended;     /* m, path length at which the present stretch ends */
    size_t stretch;   /* the present one, plus 1; 0: none yet */
    double time;      /* s */
    Extremes extremes;
    bool leapt; /* since the last row the offset has changed faster than the person moved: it is from another part of
                   the way */
    bool done;
} Watched;

/* Where walkers go, square by square. */
typedef struct Floor {
    Vec2 low;    /* m */
    double side; /* m */
    int nx, ny;
    size_t *stretch; /* (ny x nx) of each square, plus 1; 0: nobody has been there */
} Floor;

typedef struct Observer {
    const World *world;
    PersonObservation *people; /* (count) not owned: those who take part are written */
    Watched *watched;          /* (count) */
    size_t *riders;            /* (rider_count) those of them in chairs */
    size_t rider_count;
    size_t sample_steps; /* between two rows of the trace */
    Trace trace;
    double *door_opened; /* (doors of the plan) s; infinite: not yet */
    int door_changes;    /* of the world, seen so far */
    Floor floor;
    Stretch *stretches; /* (stretch_count) */
    size_t stretch_count, stretch_capacity;
} Observer;

/* How many steps there are between two rows of the trace: run.sample, or more where very many people, until run.until,
 * would fill the memory with rows. */
size_t observer_sample_steps(const House *house);

/* The world has not moved yet. observer_clear releases the observer, not the people. */
void observer_init(Observer *observer, const World *world, PersonObservation *people);
void observer_clear(Observer *observer);

/* After every step_world. Chairs are watched at every step, walkers when world->sensed: what is the greatest of theirs
 * (forces, ring) is the greatest of those moments. */
void observer_watch(Observer *observer);

/* The plan changes: before the world goes over into the new house, what was seen of everybody is brought up to now. */
void observer_catch_up(Observer *observer);

/* Tells what has been seen so far, rows of the trace included, in terms of the changed house, of which `people` (its
 * person_count, zeroed) are, and forgets who is gone. */
void observer_rename(Observer *observer, const Change *change, PersonObservation *people);

/* The world has gone over: new people are there and ways have changed. */
void observer_resume(Observer *observer);

/* After the last step: those still on the way end with `reason`. */
void observer_end(Observer *observer, Reason reason);
