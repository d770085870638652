/* What a film consists of: for the files that make its layers. */
#pragma once

#include "visual/house/census.h"
#include "visual/house/film.h"
#include "visual/house/people_scene.h"
#include "visual/house/space_scene.h"
#include "visual/house/trail.h"

/* How far a person's way has been added. */
typedef struct Progress {
    bool begun;     /* somebody who has rows */
    size_t row;     /* of the trail, the last one added */
    double length;  /* m, of the locus */
    double body;    /* s, when the next body is left behind */
    Pose last_body; /* the last one left */
} Progress;

struct Film {
    const House *house;
    const Observation *observation;
    FilmOptions options;
    const Trail *trails;   /* (person_count) */
    Trail *listed;         /* the same, when they are its own */
    Trail *ghosts;         /* (people of the one before) whose bodies are shown; NULL: none are */
    Progress *progress;    /* (person_count) */
    Standing *standing;    /* (person_count) room for who is there */
    Pose *poses;           /* (person_count) room for walkers of one profile */
    bool *door_open;       /* (doors of the plan) at the time that is shown */
    double *door_opened;   /* (doors) s, when; infinite: never */
    size_t *door_observed; /* (doors) where it is among those of the observation; SIZE_MAX: nowhere */
    bool crowd;
    bool several;   /* people of more than one route take part */
    bool small;     /* a house so large that chairs are signs rather than likenesses */
    double time;    /* s, shown last; -1: none */
    bool extended;  /* since then */
    size_t samples; /* of the record, that have been added */
    Scene still, added, moving;
};

/* True if the person goes on foot. */
bool film_layers_walks(const Film *film, size_t i);

/* Returns the look of the person's locus: by person in a house, by profile in a crowd. */
LocusLook film_layers_look(const Film *film, size_t i);
