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

/* The instant at which the contact is released: two models, see mechanics/contact.h. */
typedef enum BeamRelease {
    RELEASE_FORCE, /* at zero force, before the gap reopens: the contact never pulls */
    RELEASE_GAP,   /* when the gap reopens: linear; the dashpot pulls at the end */
} BeamRelease;

enum { BEAM_VALUES = 24 /* capacity for the rows of the table */ };

typedef struct Beam {
    const char *name;
    const char *note;

    double length, width, thickness; /* m; bending is along the thickness */
    double youngs_modulus;           /* Pa */
    double density;                  /* kg/m3 */
    int elements;                    /* finite elements along the length */
    int modes;                       /* natural modes in the model */
    double damping_ratio;            /* 1, the same for all modes */
    double tip_mass;                 /* kg, a point at the tip */

    double pivot_position;   /* m */
    double pivot_stiffness;  /* N/m, k_t */
    double pivot_rotational; /* N m/rad, k_r */

    double shaker_position;  /* m */
    double shaker_mass;      /* kg, moving mass */
    double shaker_stiffness; /* N/m */
    double shaker_damping;   /* N s/m */

    double frequency; /* Hz */
    double force;     /* N, amplitude */

    double clearance; /* m, half-width; 0: always in contact */
    ContactLaw contact;
    int release; /* BeamRelease */

    int transient_cycles, cycles;

    const char *provenance[BEAM_VALUES]; /* one per row of beam_table, in its order */
    Arena arena;
} Beam;

/* Returns the rows `beam.length`, `drive.frequency`, `joint.clearance` and so on. */
const ParameterTable *beam_table(void);

/* True if the "format" of the file is that of a beam; false also for an unreadable file. */
bool beam_is_file(const char *path);

/* Reads a beam file and applies `count` settings, NAME=VALUE as on the command line. The beam is zeroed, or one
 * that was read before, whose memory is released. On false, the errors give places and reasons, and it is unchanged. */
bool beam_read(Beam *beam, const char *path, const char *const *settings, size_t setting_count, Fault *fault);

/* Checks conditions between values: the parts fit together, the beam is supported, and there are enough degrees of
 * freedom for its modes. Returns false after errors at the place `place`. */
bool beam_check(const Beam *beam, const char *place, Fault *fault);

/* Writes the beam, each value with its provenance, so that reading the file gives the same beam. Writes a temporary
 * file in the same folder, then renames it. Returns 0, or errno. */
int beam_write(const Beam *beam, const char *path);

void beam_free(Beam *beam);

json_t *beam_schema(void);
