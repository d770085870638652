/* What many earthquakes say about a house: who gets out how often and how fast, and what stops them. Made of a study
 * whose trials are shakes (house_experiment.h). */
#pragma once

#include "house/house.h"
#include "study/montecarlo.h"

/* A person of the plan, or a crowd. */
typedef struct ShakeParty {
    const char *id;
    const char *profile;
    size_t people;     /* 1, or as many as the crowd has */
    Vec2 at;           /* m, where it begins; of a crowd the middle of its area */
    Share out;         /* shakes in which all of it get out */
    double members;    /* 1, the mean share of its members who get out */
    Distribution time; /* s, until all of it are out, of those shakes */
    size_t observable; /* of the study: that time */
} ShakeParty;

typedef struct ShakePiece {
    size_t index;     /* in the plan */
    size_t toppled;   /* shakes in which it fell */
    size_t with_loss; /* of them, those in which somebody did not get out */
    Share stops;      /* shakes in which it stops somebody */
} ShakePiece;

/* Points into study and house, which must outlive it. shake_findings_free releases it. */
typedef struct ShakeFindings {
    const Study *study;
    const House *house;  /* before a shake */
    size_t shakes;       /* made, and possible */
    Share everybody;     /* shakes in which everybody gets out */
    Share caught;        /* in which something falls on somebody */
    Share elsewhere;     /* in which somebody is stopped by a wall, a door or other people */
    Distribution time;   /* s, until everybody is out, of those in which they get out */
    ShakeParty *parties; /* (party_count) those who take part */
    size_t party_count;
    ShakePiece *pieces; /* (piece_count) what can fall or stops somebody, the worst first */
    size_t piece_count;
    size_t toppling;     /* of them can fall */
    const Trial *worst;  /* in which fewest get out, the first of those; NULL: everybody always does */
    const char *made_by; /* the settings that make the house of that shake, as on a command line; "" when something
                            falls on somebody, for such a house cannot be read */
    bool calm_out;       /* without a shake everybody gets out */
    double calm_time;    /* s; NAN: it was not run */
    Arena arena;
} ShakeFindings;

ShakeFindings shake_findings_make(const Study *study);
void shake_findings_free(ShakeFindings *findings);

/* Runs the house once without a shake, for comparison. */
void shake_findings_run_calm(ShakeFindings *findings, size_t route, int jobs, const volatile sig_atomic_t *stop);

/* "Everybody gets out in 83 of 100 shakes" */
const char *shake_findings_headline(const ShakeFindings *findings, Arena *arena);

/* "half of them within 13.2 s, 95 % within 16.0 s; without a shake 12.9 s", or "" when nobody gets out. */
const char *shake_findings_times(const ShakeFindings *findings, Arena *arena);
