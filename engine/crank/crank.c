#include "crank/crank.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/provenance_file.h"
#include "base/real.h"

#define NUMBER(name_, field_, unit_, low_, high_, meaning_)                                                            \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_NUMBER, .offset = offsetof(Crank, field_), .unit = unit_, .low = low_,        \
        .high = high_, .needed = true, .meaning = meaning_                                                             \
    }
#define USUAL(name_, field_, unit_, low_, high_, fallback_, meaning_)                                                  \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_NUMBER, .offset = offsetof(Crank, field_), .unit = unit_, .low = low_,        \
        .high = high_, .fallback = fallback_, .meaning = meaning_                                                      \
    }
#define WHOLE(name_, field_, low_, high_, fallback_, meaning_)                                                         \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_WHOLE, .offset = offsetof(Crank, field_), .unit = "1", .low = low_,           \
        .high = high_, .fallback = fallback_, .meaning = meaning_                                                      \
    }

static const Parameter rows[] = {
    NUMBER("crank.radius", radius, "m", 1e-4, 10, "distance of the pin from the crank's axis"),
    NUMBER("crank.offset_y", offset_y, "m", -100, 100, "place of the crank's axis beside the guide"),
    NUMBER("crank.offset_z", offset_z, "m", -100, 100, "height of the crank's axis over the guide"),
    USUAL("crank.tilt", tilt, "deg", -90, 90, 0, "turn of the crank's axis against the guide, about the vertical"),
    USUAL("crank.unbalance", unbalance, "kg m", 0, 1e3, 0,
          "unbalance, whose weight turns the crank; with a motor only"),
    USUAL("crank.inertia", inertia, "kg m2", 1e-9, 1e6, 0.002, "moment of inertia of the crank; with a motor only"),
    NUMBER("coupler.length", length, "m", 0.001, 100, "length of the coupler between its joints"),
    NUMBER("coupler.diameter", diameter, "m", 1e-5, 10, "outer diameter of the coupler"),
    USUAL("coupler.bore", bore, "m", 0, 10, 0, "inner diameter of the coupler"),
    NUMBER("coupler.youngs_modulus", youngs_modulus, "Pa", 1e3, 1e13, "Young's modulus of the coupler"),
    NUMBER("coupler.density", density, "kg/m3", 1, 1e5, "density of the coupler"),
    WHOLE("coupler.modes", modes, 0, CRANK_MODES_MOST, 2, "bending modes of the coupler in each plane"),
    WHOLE("coupler.axial", axial, 0, 1, 1, "axial modes of the coupler"),
    NUMBER("coupler.damping_ratio", damping_ratio, "1", 0, 0.9, "damping ratio of each mode of the coupler"),
    NUMBER("coupler.end_mass", end_mass, "kg", 0, 1e4, "mass of the coupler's ball end"),
    {.name = "coupler.shortening",
     .kind = PARAMETER_FLAG,
     .offset = offsetof(Crank, shortening),
     .unit = "",
     .fallback = 1,
     .meaning = "bending draws the coupler's ends together"},
    NUMBER("slider.mass", slider_mass, "kg", 1e-6, 1e5, "mass of the slider"),
    NUMBER("slider.damping", slider_damping, "N s/m", 0, 1e6, "viscous damping of the guide"),
    NUMBER("universal.damping", universal_damping, "N m s/rad", 0, 1e6,
           "viscous damping of the universal joint's axes"),
    NUMBER("support.mass", support_mass, "kg", 1e-6, 1e6, "mass of the crank's bearing block"),
    NUMBER("support.stiffness_x", support_stiffness_x, "N/m", 1, 1e12, "stiffness of the support along the guide"),
    NUMBER("support.stiffness_y", support_stiffness_y, "N/m", 1, 1e12, "stiffness of the support across the guide"),
    NUMBER("support.stiffness_z", support_stiffness_z, "N/m", 1, 1e12, "stiffness of the support upwards"),
    NUMBER("support.damping_ratio", support_damping_ratio, "1", 0, 0.9, "damping ratio of the support"),
    NUMBER("drive.frequency", frequency, "Hz", 0.1, 1000, "revolutions of the crank per second"),
    USUAL("drive.motor", motor, "N m s/rad", 0, 1e6, 0, "slope of the motor's torque; 0: the speed is imposed"),
    NUMBER("joint.clearance", clearance, "m", 0, 0.1, "radial clearance of the ball in its socket; 0: none"),
    NUMBER("joint.stiffness", contact.normal_stiffness, "N/m", 1, 1e11, "stiffness of the contact"),
    NUMBER("joint.damping", contact.normal_damping, "N s/m", 0, 1e6, "damping of the contact"),
    {.name = "joint.release",
     .kind = PARAMETER_CHOICE,
     .offset = offsetof(Crank, release),
     .unit = "",
     .choices = "force|gap",
     .meaning = "the contact lets go at zero force, or when the gap reopens"},
    USUAL("joint.friction", contact.friction, "1", 0, 2, 0, "coefficient of friction of the ball in its socket"),
    USUAL("joint.slip_speed", slip_speed, "m/s", 1e-6, 10, 0.01, "sliding speed over which friction sets in"),
    USUAL("joint.ball_radius", ball_radius, "m", 1e-5, 10, 0.006, "radius of the ball, for friction"),
    USUAL("gravity.acceleration", gravity, "m/s2", 0, 100, 9.81, "acceleration of gravity, downwards"),
    USUAL("start.along", start_along, "m", -1, 1, 0, "place of the ball in its socket at the start, along the coupler"),
    USUAL("start.across", start_across, "m", -1, 1, 0, "place of the ball at the start, level across the coupler"),
    USUAL("start.up", start_up, "m", -1, 1, 0, "place of the ball at the start, across the coupler, upwards"),
    USUAL("start.velocity", start_velocity, "m/s", -100, 100, 0, "velocity of the slider beside the ideal one"),
    WHOLE("run.transient_cycles", transient_cycles, 0, 1000000, 60, "revolutions before anything is recorded"),
    WHOLE("run.cycles", cycles, 1, 1000000, 40, "revolutions that are recorded"),
};
enum { ROWS = sizeof rows / sizeof *rows };
_Static_assert((int)ROWS <= (int)CRANK_VALUES, "a provenance for every row");

static const ParameterTable table = {"crank", rows, ROWS};

static const char *const groups[] = {"crank", "coupler", "slider",  "universal", "support",
                                     "drive", "joint",   "gravity", "start",     "run"};

static const ProvenanceFile kind = {"crank",
                                    "clearance-crank",
                                    "A spatial slider crank of clearance",
                                    &table,
                                    groups,
                                    sizeof groups / sizeof *groups,
                                    "paper|reconstructed|identified|literature: |assumed"};

static ProvenanceTarget target_of(Crank *crank) {
    return (ProvenanceTarget){crank, crank->provenance, &crank->name, &crank->note, &crank->arena};
}

const ParameterTable *crank_table(void) {
    return &table;
}

/* The coupler is at most this part of its length thick: it bends as a slender rod. */
static const double THICK_MOST = 0.1;
/* The coupler makes an angle with the guide whose cosine is at least this: nearer to 0 the mechanism locks. */
static const double STEEP_MOST = 0.05;
/* The ball starts at most this far from the middle of its socket, as a part of the clearance. */
static const double START_MOST = 1;
enum { ANGLES = 720 /* of the crank, at which the mechanism must close */ };

/* Returns the largest distance, m, of the pin from the guide over a revolution, and the angle, deg, at which it is. */
static double farthest_pin(const Crank *crank, double *angle) {
    double farthest = 0;
    SineCosine tilt = real_sincos(crank->tilt * M_PI / 180);
    for (int i = 0; i < ANGLES; i++) {
        SineCosine turn = real_sincos(2 * M_PI * i / ANGLES);
        double y = crank->offset_y - crank->radius * tilt.cosine * turn.sine;
        double z = crank->offset_z + crank->radius * turn.cosine, far = real_hypot(y, z);
        if (far > farthest) {
            farthest = far;
            *angle = 360.0 * i / ANGLES;
        }
    }
    return farthest;
}

static void check_coupler(const Crank *crank, const JsonNode *coupler, Fault *fault) {
    if (crank->bore >= crank->diameter)
        json_fault(coupler, fault, "coupler.bore is %.9g m, must be below the diameter, %.9g m", crank->bore,
                   crank->diameter);
    if (crank->diameter > THICK_MOST * crank->length)
        json_fault(coupler, fault,
                   "the coupler is %.9g m thick and %.9g m long, must be at least %.0f times as long as thick",
                   crank->diameter, crank->length, 1 / THICK_MOST);
    double angle = 0, far = farthest_pin(crank, &angle), most = crank->length * sqrt(1 - STEEP_MOST * STEEP_MOST);
    if (far > most)
        json_fault(coupler, fault,
                   "the mechanism does not close: at a crank angle of %.0f deg the pin is %.4g m from the guide; a "
                   "coupler of %.4g m reaches %.4g m, so it must be at least %.4g m long",
                   angle, far, crank->length, most, far / sqrt(1 - STEEP_MOST * STEEP_MOST));
}

static void check_whole(const Crank *crank, const JsonNode *root, Fault *fault) {
    JsonNode coupler = json_member(root, "coupler"), start = json_member(root, "start"),
             joint = json_member(root, "joint");
    check_coupler(crank, &coupler, fault);
    double away = real_hypot(real_hypot(crank->start_along, crank->start_across), crank->start_up);
    if (away > START_MOST * crank->clearance)
        json_fault(start.value ? &start : root, fault,
                   "the ball starts %.4g m from the middle of its socket, at most the clearance, %.4g m", away,
                   crank->clearance);
    if (crank->contact.friction > 0 && crank->ball_radius <= crank->clearance)
        json_fault(&joint, fault, "joint.ball_radius is %.4g m, must be above the clearance, %.4g m",
                   crank->ball_radius, crank->clearance);
}

bool crank_check(const Crank *crank, const char *place, Fault *fault) {
    size_t before = fault->total;
    char path[200];
    snprintf(path, sizeof path, "%s: ", place);
    JsonFile file = {.path = path, .root = json_object()};
    JsonNode root = json_root(&file);
    check_whole(crank, &root, fault);
    json_decref(file.root);
    return fault->total == before;
}

bool crank_is_file(const char *path) {
    return provenance_file_is(&kind, path);
}

bool crank_read(Crank *crank, const char *path, const char *const *settings, size_t setting_count, Fault *fault) {
    size_t before = fault->total;
    JsonFile file = {0};
    if (!json_read(&file, path, fault))
        return false;
    Crank read = {0};
    JsonNode root = json_root(&file);
    if (json_check_header(&root, kind.what, kind.format, fault)) {
        ProvenanceTarget target = target_of(&read);
        provenance_file_read(&kind, &target, &root, fault);
        for (size_t i = 0; i < setting_count; i++)
            provenance_file_set(&kind, &target, settings[i], fault);
        if (fault->total == before)
            check_whole(&read, &root, fault);
    }
    json_free(&file);
    if (fault->total != before) {
        crank_free(&read);
        return false;
    }
    crank_free(crank);
    *crank = read;
    return true;
}

bool crank_is_assumed(const Crank *crank) {
    for (size_t i = 0; i < ROWS; i++)
        if (strncmp(crank->provenance[i], "assumed", strlen("assumed")) != 0)
            return false;
    return true;
}

int crank_write(const Crank *crank, const char *path) {
    Crank written = *crank;
    ProvenanceTarget target = target_of(&written);
    return provenance_file_write(&kind, &target, path);
}

void crank_free(Crank *crank) {
    arena_clear(&crank->arena);
    *crank = (Crank){0};
}

json_t *crank_schema(void) {
    return provenance_file_schema(&kind);
}
