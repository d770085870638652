/* A kind of person: body, driving model, personal space and contact law, each number with its provenance (`paper`,
 * `reconstructed`, `fitted: to what`, `literature: source`, `assumed`), read from assets/profiles.
 *
 * The body is a rounded rectangle, length by width, its corners rounded by `corner_radius`; the reference point is the
 * middle of the drive axle, `axle` ahead of the rear edge, and the mass centre stands `mass_centre` ahead of the axle.
 * The bodies of the paper (driving `miura`) and of walkers are discs of radius width / 2 about the reference point. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/parameters.h"
#include "mechanics/contact.h"

typedef enum Driving {
    DRIVING_DRIVER, /* own model: a chair that turns and does not slip sideways, along a planned path */
    DRIVING_MIURA,  /* the paper's model: a disc on straight legs and corners */
    DRIVING_WALKER, /* on foot: a disc that follows a floor field and keeps a distance to people ahead */
} Driving;

#define DRIVING_WORDS "driver|miura|walker"

/* Returns "driver", "miura", "walker". */
const char *profile_driving_name(int driving);

enum { PROFILE_NUMBERS = 64 /* capacity for the rows of the table */ };

typedef struct Profile {
    const char *name;
    const char *note;
    int driving; /* Driving */

    double length, width;      /* m */
    double axle;               /* m, from the rear edge to the drive axle */
    double corner_radius;      /* m */
    double mass;               /* kg, chair and driver */
    double mass_centre;        /* m, ahead of the axle */
    double radius_of_gyration; /* m, about the mass centre */
    double hands;              /* m, beside each rim, for the hand that pushes it; 0: nobody pushes the rims */

    double free_speed;           /* m/s */
    double free_speed_deviation; /* m/s */
    double minimum_speed;        /* m/s, v_min, held through corners */
    double steering_time;        /* s, b of v = (W - w) / b */
    double acceleration;         /* m/s2, a_0 */
    double deceleration;         /* m/s2, a_d */
    double lateral_acceleration; /* m/s2, comfortable in a corner */
    double turn_rate;            /* rad/s, largest */
    double push;                 /* N, largest push of the driver */
    double turning_moment;       /* N m, largest turning moment of the driver */
    double scrub;                /* N m, what a turn on the spot takes of it against the scrub of the tyres */
    double speed_response;       /* s */
    double turn_response;        /* s */
    double lateral_gain;         /* 1/m2 */
    double heading_gain;         /* 1/m */
    double side_friction;        /* 1, of the wheels, sideways */
    double reversing_speed;      /* m/s */
    double reversing_time;       /* s, to change direction */
    double skid_time;            /* s/m, to skid with the drive wheels sideways; 0: they do not skid */
    double creep;      /* m/s, the slowest speed through a passage or towards an obstacle, however narrow it is */
    double caution;    /* 1, z: how many standard deviations of the error a driver keeps from a wall */
    double sight;      /* m, l_p, the length in which a driver steers back to the planned line */
    double drift;      /* m/rad, slip outwards of the front edge in a turn (aim.c) */
    double spot_error; /* degree, deviation of the heading after a turn on the spot */
    double reaction;   /* s, until what is near has an effect */
    double time_gap;   /* s, T of a walker's v = s / T, s the free path to the person ahead */

    double space_reach;    /* m, of the personal space beyond the body */
    double space_centring; /* m, l_r, the length in which a driver steers away from what is near */
    double space_price;    /* s/m, what it costs a plan to press the space to the body on one side */
    ContactLaw space;
    ContactLaw contact;

    const char *provenance[PROFILE_NUMBERS]; /* per row of profile_table, in its order */
    Arena arena;
} Profile;

/* Returns the rows `body.width`, `drive.free_speed`, `space.reach`, `contact.normal_stiffness` and so on. */
const ParameterTable *profile_table(void);

/* Reads a profile file. Returns false after an error, with the profile unchanged. */
bool profile_read(Profile *profile, const char *path, Fault *fault);

/* Returns NAME.json in the first of the folders, one a line, that has it; if none has, that in the first of all. */
const char *profile_find(const char *folders, const char *name, Arena *arena);

/* Changes one parameter, for instance "width" to the JSON value "0.70"; errors begin with `place`: "file:line:column:
 * ". */
bool profile_set(Profile *profile, const char *name, const char *value, const char *place, Fault *fault);

/* Returns the row that profile_set would change. NULL: an error, which begins with `place` and names the possible
 * parameters. */
const Parameter *profile_parameter(const Profile *profile, const char *name, const char *place, Fault *fault);

/* True if the driving model uses the row with this index. A file gives exactly these rows. */
bool profile_row_matters(size_t row, int driving);

/* Checks beyond the rows: the parts of the body fit together, and the step `dt` (s) is stable. */
bool profile_check(const Profile *profile, double dt, const char *place, Fault *fault);

void profile_free(Profile *profile);

json_t *profile_schema(void);
