/* The impact beam system as it is given: a beam on a flexure pivot, driven by a shaker, whose far end rattles in a
 * clearance, each number with its provenance (`paper`, `reconstructed`, `identified`, `literature: source`, `assumed`),
 * read from assets/beams.
 *
 *     pivot: springs            shaker: F sin(2 pi f t), mass, spring, dashpot         joint: |<- clearance ->|
 *     k_t, k_r   o=======================+=============================================o      (either side)
 *                |--- position ---|                                                    tip
 *
 * Source: Gu and Dubowsky, "Chaotic Vibration and Design Criteria for Machine Systems with Clearance Connections",
 * 1995. What of it is lost was identified by search against what it says of its results. Positions are counted from the
 * end away from the joint; 0 switches a mass, a spring of the supports or a dashpot off. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/parameters.h"
#include "mechanics/contact.h"

/* When the contact lets go: two models, see mechanics/contact.h. */
typedef enum BeamRelease {
    RELEASE_FORCE, /* at zero force, before the gap reopens: the law never pulls */
    RELEASE_GAP,   /* when the gap reopens: linear, the dashpot pulls at the end */
} BeamRelease;

enum { BEAM_VALUES = 24 /* room for the rows of the table */ };

typedef struct Beam {
    const char *name;
    const char *note;

    double length, width, thickness; /* m; it bends along its thickness */
    double youngs_modulus;           /* Pa */
    double density;                  /* kg/m3 */
    int elements;                    /* finite elements along the length */
    int modes;                       /* natural modes kept */
    double damping_ratio;            /* 1, of each mode */

    double pivot_position;   /* m */
    double pivot_stiffness;  /* N/m, k_t */
    double pivot_rotational; /* N m/rad, k_r */

    double shaker_position;  /* m */
    double shaker_mass;      /* kg, moving */
    double shaker_stiffness; /* N/m */
    double shaker_damping;   /* N s/m */

    double frequency; /* Hz */
    double force;     /* N, amplitude */

    double clearance; /* m, half-width; 0: always in contact */
    ContactLaw contact;
    int release; /* BeamRelease */

    int transient_cycles, cycles;

    const char *provenance[BEAM_VALUES]; /* of each row of beam_table, in its order */
    Arena arena;
} Beam;

/* The rows, `beam.length`, `drive.frequency`, `joint.clearance` and so on. */
const ParameterTable *beam_table(void);

/* Is this file a beam's, as its "format" says? False also for what cannot be read. */
bool beam_is_file(const char *path);

/* Reads a beam file and changes it by settings (count), NAME=VALUE as on the command line; on false faults say where
 * and what, and the beam is as it was. */
bool beam_read(Beam *beam, const char *path, const char *const *settings, size_t setting_count, Fault *fault);

/* Does what the rows cannot say hold: do the parts fit together, is the beam held, are there freedoms for its modes?
 * False: faults at the place `place`. */
bool beam_check(const Beam *beam, const char *place, Fault *fault);

/* Writes the beam, each value with its provenance, so that reading it again gives the same beam. Beside and renamed. 0,
 * or errno. */
int beam_write(const Beam *beam, const char *path);

void beam_free(Beam *beam);

json_t *beam_schema(void);
