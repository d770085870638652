/* The spatial slider crank as it is given: a crank whose pin turns in a bearing block on springs, an elastic coupler
 * from the pin to a slider, and a clearance between the pin's socket and the coupler's ball, each number with its
 * provenance, read from assets/cranks.
 *
 *     z ^                      crank: turns about an axis along the guide, tilted by `tilt` about z, at (0, y_A, z_A) +
 * u |        A (x)         u: its bearing block on a flexible support, three springs |       /  r |      P ( o ) the
 * joint: ball B of the coupler in the socket P of the crank, clearance c, d = B - P |     /   \            coupler: a
 * slender elastic rod from C to B
 *       |    /     \
 *       +---C=========> x      slider along x; universal joint at C, first axis z on the slider, second across the rod
 *
 * Gu and Dubowsky (1995) say of such a mechanism that it shows what their beam shows. None of its dimensions is
 * published: the numbers shipped are assumed. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/parameters.h"
#include "mechanics/contact.h"

/* The instant at which the contact is released, see mechanics/contact.h. */
typedef enum CrankRelease {
    CRANK_RELEASE_FORCE, /* at zero force: the contact never pulls */
    CRANK_RELEASE_GAP,   /* when the gap reopens; the dashpot pulls at the end */
} CrankRelease;

enum { CRANK_VALUES = 48 /* capacity for the rows of the table */, CRANK_MODES_MOST = 6 /* of bending, each plane */ };

typedef struct Crank {
    const char *name;
    const char *note;

    double radius, offset_y, offset_z; /* m */
    double tilt;                       /* deg, of the crank's axis against the guide, about z */
    double unbalance, inertia;         /* kg m, kg m2; felt only with a motor */

    double length, diameter, bore; /* m, of the coupler */
    double youngs_modulus;         /* Pa */
    double density;                /* kg/m3 */
    int modes, axial;              /* bending modes in each plane; axial modes, 0 or 1 */
    double damping_ratio;          /* 1, of each mode */
    double end_mass;               /* kg, the ball end */
    bool shortening; /* bending draws the ends together, which stiffens and softens with the axial force */

    double slider_mass, slider_damping; /* kg, N s/m */
    double universal_damping;           /* N m s/rad, about both axes */

    double support_mass;                                                  /* kg, the bearing block */
    double support_stiffness_x, support_stiffness_y, support_stiffness_z; /* N/m */
    double support_damping_ratio;                                         /* 1 */

    double frequency; /* Hz, revolutions per second */
    double motor;     /* N m s/rad, slope of the motor's torque; 0: the speed is imposed */

    double clearance;   /* m, radial; 0: no clearance */
    ContactLaw contact; /* stiffness, damping and friction */
    int release;        /* CrankRelease */
    double slip_speed;  /* m/s, over which friction sets in */
    double ball_radius; /* m */

    double gravity; /* m/s2, against z */

    double start_along, start_across, start_up; /* m, of the ball in its socket, in the coupler's axes */
    double start_velocity;                      /* m/s, of the slider beside the ideal mechanism's */

    int transient_cycles, cycles;

    const char *provenance[CRANK_VALUES]; /* one per row of crank_table, in its order */
    Arena arena;
} Crank;

/* Returns the rows `crank.radius`, `drive.frequency`, `joint.clearance` and so on. */
const ParameterTable *crank_table(void);

/* True if the "format" of the file is that of a crank; false also for an unreadable file. */
bool crank_is_file(const char *path);

/* Reads a crank file and applies `count` settings, NAME=VALUE as on the command line. The crank is zeroed, or
 * one that was read before, whose memory is released. On false, the errors give places and reasons, and it is
 * unchanged.
 */
bool crank_read(Crank *crank, const char *path, const char *const *settings, size_t setting_count, Fault *fault);

/* Checks conditions between values: the mechanism closes at every angle, the rod is slender, the ball starts inside its
 * socket. Returns false after errors at the place `place`. */
bool crank_check(const Crank *crank, const char *place, Fault *fault);

/* True if the provenance of every number says that it is assumed. */
bool crank_is_assumed(const Crank *crank);

/* Writes the crank, each value with its provenance, so that reading the file gives the same crank. Returns 0, or errno.
 */
int crank_write(const Crank *crank, const char *path);

void crank_free(Crank *crank);

json_t *crank_schema(void);
