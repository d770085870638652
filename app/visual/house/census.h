/* An observation of many people in a few rows: how each crowd fared, what keeps in those who are not out, and how many
 * left by each exit. */
#pragma once

#include "house/observation.h"

enum { CENSUS_ROWS = 30 /* so many people are listed one by one; of more, the sums are told */ };

/* The members of a crowd, or single people of one profile with one route. */
typedef struct Party {
    const Crowd *crowd; /* NULL: single people */
    const Profile *profile;
    const PlanRoute *route; /* or NULL */
    size_t first;           /* the first of them, index into House.people */
    size_t people, out;
    double mean, last; /* s, of those who are out; NAN when nobody is */
    double lost;       /* s, mean of all */
    int contacts;
    double peak_force; /* N */
} Party;

/* People whom the same thing keeps in at the same place. */
typedef struct Hold {
    Reason reason;
    size_t first; /* the first of them, index into House.people */
    size_t people;
    Box box;           /* m, round the places where they are stopped; empty when the reason has no place */
    Blockage blockage; /* the one that tells most: a door rather than a wall, a wall rather than somebody else */
} Hold;

typedef struct Census {
    size_t people, out; /* of those who took part */
    size_t stuck;       /* the first who is not out, or SIZE_MAX */
    double last;        /* s, when the last of those who are out got out; 0: nobody */
    int contacts;
    double peak_force; /* N */
    Party *parties;    /* (party_count) in the order of their first members */
    Hold *holds;       /* (hold_count) most people first */
    size_t *left;      /* (exit_count) how many left by each exit */
    size_t *party_of;  /* (person_count) of each who took part */
    size_t party_count, party_capacity, hold_count, hold_capacity;
} Census;

/* census_clear releases it; house and observation must outlive it. */
Census census_make(const House *house, const Observation *observation);
void census_clear(Census *census);

/* "27 cannot pass door d2 (needs at least 0.39 m, has 0.30 m), 2 time limit": the holds of those who are not out, with
 * or without the widths. */
void census_reasons(const House *house, const Census *census, bool with_widths, char *text, size_t size);

/* The crowd's id, the person's who has no like, or "single people". */
const char *census_party_name(const House *house, const Party *party);

/* The party with this name and profile, or NULL. */
const Party *census_find_party(const House *house, const Census *census, const char *name, const char *profile);

/* On foot, not in a chair? */
bool census_walks(const Profile *profile);

/* The mean time of a route's people, s; less than 0 when somebody did not get out or took no part. */
double census_route_time(const House *house, const Observation *observation, const PlanRoute *route);
