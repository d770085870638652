/* The headline of a run of a house: window, pictures, terminal and report take it from here. */
#pragma once

#include "draw/palette.h"
#include "result/census.h"

#define HEADLINE_LONG 99.95 /* s: longer times are read in minutes and seconds */

/* A window and a picture show title and detail, terminal and report only the sentence: tables follow there. */
typedef struct Headline {
    const char *title;    /* "Out in 18.4 s", "2 of 4 are not out" */
    const char *detail;   /* how near people came to anything, or why people are not out; "": nothing to add */
    const char *sentence; /* title and reasons: "p1 cannot pass door d2: needs at least 0.80 m, has 0.75 m" */
    Role role;            /* of the title */
} Headline;

/* The texts live in the arena, or as long as the program. */
Headline headline_make(const House *house, const Observation *observation, const Census *census, Arena *arena);

/* Returns only the sentence. */
const char *headline_sentence(const House *house, const Observation *observation, Arena *arena);

/* Returns ", backs 2.1 m" or ", p-c backs 4.0 m, over the exit", of the person who goes farthest backwards; "": nobody
 * goes far, or over the exit. */
const char *headline_backwards(const House *house, const Observation *observation, Arena *arena);

/* Returns "0.26 m", "0.064 m" below a decimetre, or "touches" from 0 down. */
const char *headline_clearance(double clearance, Arena *arena);

/* Returns a time as people read it: "20.8 s", from 100 s on "1:44". */
const char *headline_duration(double seconds, Arena *arena);

/* Returns a count that is as wide as the largest one, by blanks of a digit's width before it. */
const char *headline_count(size_t count, size_t most, Arena *arena);

/* Returns how much longer a time is than another as both are shown, s: 20.3 s is 2.5 s more than 17.8 s, whatever their
 * hidden digits are. */
double headline_difference(double before, double now);
