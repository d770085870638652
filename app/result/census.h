/* An observation of many people in a few rows: the result of each crowd, what stops the people who are not out, and
 * how many left by each exit. */
#pragma once

#include "house/observation.h"

enum {
    CENSUS_FEW = 6,   /* at most so many people are shown one by one on the plan; more are a crowd */
    CENSUS_ROWS = 30, /* at most so many people are listed one by one; larger numbers are summed up */
};

/* The members of a crowd, or single people of one profile with one route. */
typedef struct Party {
    const Crowd *crowd; /* NULL: single people */
    const Profile *profile;
    const PlanRoute *route; /* or NULL */
    size_t first;           /* the first of them, index into House.people */
    size_t people, out;
    double mean, last; /* s, of the people who are out; NAN if nobody is */
    double lost;       /* s, mean over all */
    int contacts;
    double peak_force; /* N */
} Party;

/* People stopped by the same cause at the same place. */
typedef struct Hold {
    Reason reason;
    size_t first; /* the first of them, index into House.people */
    size_t people;
    Box box;           /* m, round the places where they are stopped; empty if the reason has no place */
    Blockage blockage; /* the most severe cause: a door before a wall, a wall before another person */
} Hold;

typedef struct Census {
    bool interrupted;   /* True if the run was interrupted or is counted until a time: people who are not out are
                           still inside */
    size_t people, out; /* of those who took part */
    size_t stuck;       /* the first person who is not out, or SIZE_MAX */
    double last;        /* s, when the last person left; 0: nobody did */
    int contacts;
    double peak_force; /* N */
    double impact;     /* m/s, of the fastest impact of a chair; 0: none */
    Party *parties;    /* (party_count) in the order of their first members */
    Hold *holds;       /* (hold_count) most people first */
    size_t *left;      /* (exit_count) people who left by each exit */
    size_t *party_of;  /* (person_count) true for each person who took part */
    size_t party_count, party_capacity, hold_count, hold_capacity;
} Census;

/* Counts an observation; house and observation must outlive the census. census_clear releases it. */
Census census_make(const House *house, const Observation *observation);

/* Counts it as it was at a time: people who left later, and those who never did, are still inside. */
Census census_until(const House *house, const Observation *observation, double time);

void census_clear(Census *census);

/* Prints "27 cannot pass door d2 (needs at least 0.39 m, has 0.30 m), 2 stopped by the time limit": the holds of the
 * people who are not out, with or without the widths. */
void census_reasons(const House *house, const Census *census, bool with_widths, char *text, size_t size);

/* Returns "inside wall w1" if people who cannot pass have no room where they start; NULL: they are stopped elsewhere.
 */
const char *census_start(const Blockage *blockage);

/* Returns the id of the crowd or of the only member, or "single people". */
const char *census_party_name(const House *house, const Party *party);

/* Returns the party with this name and profile, or NULL. */
const Party *census_find_party(const House *house, const Census *census, const char *name, const char *profile);

/* True if the profile goes on foot, not in a chair. */
bool census_walks(const Profile *profile);

/* Returns the person with the least clearance; SIZE_MAX if nothing entered any personal space. */
size_t census_narrowest(const House *house, const Observation *observation);

/* Returns the last person out; SIZE_MAX if nobody is. */
size_t census_last(const Observation *observation);

/* Returns the mean time of a route's people, s; negative if one of them did not leave or took no part. */
double census_route_time(const House *house, const Observation *observation, const PlanRoute *route);
