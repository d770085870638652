/* Many earthquakes of a house, computed after one was made in the window: first a few, then all, as `study --shake`
 * does with the house as it stood before. */
#pragma once

#include "base/fault.h"
#include "base/memory.h"
#include "base/stop.h"
#include "house/house.h"

enum { OUTLOOK_STEPS = 2 /* 20 earthquakes, then 100 */, OUTLOOK_SHAKES = 100 };

typedef struct OutlookPerson {
    const char *id; /* of a person of the plan, or of a crowd */
    size_t out;     /* earthquakes after which the person, or the whole crowd, leaves */
} OutlookPerson;

typedef struct OutlookPiece {
    const char *id;
    size_t fell;  /* earthquakes in which it fell */
    size_t stops; /* earthquakes in which it stops people */
} OutlookPiece;

/* The earthquakes of one step. */
typedef struct Outlook {
    size_t shakes;         /* that were simulated, with the numbers from 1 on */
    size_t all_out;        /* of them, those after which all people leave */
    OutlookPerson *people; /* (person_count) those who take part */
    size_t person_count;
    OutlookPiece *pieces; /* (piece_count) pieces that can fall, the one that stops people most often first */
    size_t piece_count;
    Arena arena; /* holds them and their texts */
} Outlook;

/* Returns the number of earthquakes of a step. */
size_t outlook_size(int step);

/* Simulates the earthquakes of a step in a house file's `text`, called `path`; `options` are those of the house as it
 * stands before. Returns false, with an empty outlook, if it was stopped or, with a fault, if the house cannot be read.
 * outlook_clear releases it. */
bool outlook_make(Outlook *outlook, int step, const char *path, const char *text, const HouseOptions *options,
                  const char *route, int jobs, const Stop *stop, Fault *fault);
void outlook_clear(Outlook *outlook);
