/* The findings of many earthquakes on a house: who leaves how often and how fast, and what stops them. Made from a
 * study whose trials are shakes (house_experiment.h). */
#pragma once

#include "base/stop.h"
#include "house/house.h"
#include "study/montecarlo.h"

/* A person of the plan, or a crowd. */
typedef struct ShakeParty {
    const char *id;
    const char *profile;
    size_t people;     /* 1, or as many as the crowd has */
    Vec2 at;           /* m, the start; for a crowd the middle of its area */
    Share out;         /* shakes in which all of it leave */
    double members;    /* 1, the mean share of its members who leave */
    Distribution time; /* s, until all of it are out, of those shakes */
    size_t observable; /* that time's observable in the study */
} ShakeParty;

typedef struct ShakePiece {
    size_t index;     /* in the plan */
    size_t toppled;   /* shakes in which it fell */
    size_t with_loss; /* of them, those in which not all people left */
    Share stops;      /* shakes in which it stops people */
} ShakePiece;

/* The answer of the run without a shake. */
typedef enum ShakeCalm {
    SHAKE_CALM_UNKNOWN, /* not run */
    SHAKE_CALM_OUT,     /* all people leave */
    SHAKE_CALM_NOT_OUT,
    SHAKE_CALM_INTERRUPTED,
} ShakeCalm;

/* Points into study and house, which must outlive the findings. shake_findings_free releases them. */
typedef struct ShakeFindings {
    const Study *study;
    const House *house;  /* before a shake */
    size_t shakes;       /* made, and possible */
    Share all_out;       /* shakes in which all people leave */
    Share caught;        /* in which furniture falls on a person */
    Share elsewhere;     /* in which a wall, a door or other people stop a person */
    Distribution time;   /* s, until all people are out, of the shakes in which all leave */
    ShakeParty *parties; /* (party_count) those who take part */
    size_t party_count;
    ShakePiece *pieces; /* (piece_count) pieces that can fall or stop people, the worst first */
    size_t piece_count;
    size_t toppling;     /* of them can fall */
    const Trial *worst;  /* the first shake in which fewest leave; NULL: all people always leave */
    const char *made_by; /* the settings for the house after that shake, as on a command line; "" if furniture falls on
                            a person, since such a house cannot be read */
    ShakeCalm calm;      /* without a shake */
    double calm_time;    /* s; NAN: not known */
    Arena arena;
} ShakeFindings;

ShakeFindings shake_findings_make(const Study *study);
void shake_findings_free(ShakeFindings *findings);

/* Runs the house once without a shake, for comparison. */
void shake_findings_run_calm(ShakeFindings *findings, size_t route, int jobs, const Stop *stop);

/* Prints "All people are out in 83 of 100 shakes". */
const char *shake_findings_headline(const ShakeFindings *findings, Arena *arena);

/* Prints "half of them within 13.2 s, 95 % within 16.0 s; without a shake 12.9 s", or what of it is known. */
const char *shake_findings_times(const ShakeFindings *findings, Arena *arena);
