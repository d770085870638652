/* The parts of a film, for the files that make its layers. */
#pragma once

#include "result/census.h"
#include "visual/house/film.h"
#include "visual/house/people_scene.h"
#include "visual/house/space_scene.h"
#include "visual/house/trail.h"

/* How far a person's locus has been added. */
typedef struct Progress {
    bool begun;     /* true if the person has rows */
    size_t row;     /* of the trail, the last one added */
    double length;  /* m, of the locus */
    double body;    /* s, of the next body */
    Pose last_body; /* the last body added */
} Progress;

struct Film {
    const House *house;
    const Observation *observation;
    FilmOptions options;
    const Trail *trails;   /* (person_count) */
    Trail *listed;         /* the same, if the film owns them */
    Trail *ghosts;         /* (people of the comparison) whose bodies are shown; NULL: none are */
    Progress *progress;    /* (person_count) */
    Standing *standing;    /* (person_count) room for the visible people */
    Pose *poses;           /* (person_count) room for walkers of one profile */
    bool *door_open;       /* (doors of the plan) at the displayed time */
    double *door_opened;   /* (doors) s, opening time; infinite: never */
    size_t *door_observed; /* (doors) index among the doors of the observation; SIZE_MAX: not there */
    bool crowd;
    bool several;   /* people of more than one route take part */
    bool small;     /* the house is so large that chairs are signs rather than likenesses */
    double time;    /* s, displayed last; -1: none */
    bool extended;  /* film_extend was called since then */
    size_t samples; /* of the record, added so far */
    Scene still, added, moving;
};

/* True if the person goes on foot. */
bool film_layers_walks(const Film *film, size_t i);

/* Returns the look of the person's locus: by person in a house, by profile in a crowd. */
LocusLook film_layers_look(const Film *film, size_t i);

/* True if the picture shows how crowded each place is. */
bool film_layers_density(const Film *film);
