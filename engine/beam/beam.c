#include "beam/beam.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/provenance_file.h"

#define NUMBER(name_, field_, unit_, low_, high_, meaning_)                                                            \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_NUMBER, .offset = offsetof(Beam, field_), .unit = unit_, .low = low_,         \
        .high = high_, .needed = true, .meaning = meaning_                                                             \
    }
#define WHOLE(name_, field_, low_, high_, fallback_, meaning_)                                                         \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_WHOLE, .offset = offsetof(Beam, field_), .unit = "1", .low = low_,            \
        .high = high_, .fallback = fallback_, .meaning = meaning_                                                      \
    }

static const Parameter beam_rows[] = {
    NUMBER("beam.length", length, "m", 0.001, 100, "length"),
    NUMBER("beam.width", width, "m", 1e-5, 10, "width of the section"),
    NUMBER("beam.thickness", thickness, "m", 1e-5, 10, "thickness, along which it bends"),
    NUMBER("beam.youngs_modulus", youngs_modulus, "Pa", 1e3, 1e13, "Young's modulus"),
    NUMBER("beam.density", density, "kg/m3", 1, 1e5, "density"),
    WHOLE("beam.elements", elements, 2, 200, 20, "finite elements along the length"),
    WHOLE("beam.modes", modes, 1, 64, 12, "natural modes kept"),
    NUMBER("beam.damping_ratio", damping_ratio, "1", 0, 0.9, "damping ratio of each mode"),
    {.name = "beam.tip_mass",
     .kind = PARAMETER_NUMBER,
     .offset = offsetof(Beam, tip_mass),
     .unit = "kg",
     .high = 1e4,
     .meaning = "mass at the tip, as of the joint's part there; 0: none"},
    NUMBER("pivot.position", pivot_position, "m", 0, 100, "place of the flexure pivot along the beam"),
    NUMBER("pivot.translational_stiffness", pivot_stiffness, "N/m", 0, 1e12, "k_t of the flexure pivot"),
    NUMBER("pivot.rotational_stiffness", pivot_rotational, "N m/rad", 0, 1e9, "k_r of the flexure pivot"),
    NUMBER("shaker.position", shaker_position, "m", 0, 100, "place of the shaker along the beam"),
    NUMBER("shaker.moving_mass", shaker_mass, "kg", 0, 1e4, "mass that moves with the beam"),
    NUMBER("shaker.stiffness", shaker_stiffness, "N/m", 0, 1e12, "stiffness of the shaker's suspension"),
    NUMBER("shaker.damping", shaker_damping, "N s/m", 0, 1e6, "damping of the shaker's suspension"),
    NUMBER("drive.frequency", frequency, "Hz", 1, 1e5, "frequency of the shaker's force"),
    NUMBER("drive.force", force, "N", 0, 1e6, "amplitude of the shaker's force"),
    NUMBER("joint.clearance", clearance, "m", 0, 1, "half-width of the clearance; 0: always in contact"),
    NUMBER("joint.stiffness", contact.normal_stiffness, "N/m", 1, 1e11, "stiffness of the contact"),
    NUMBER("joint.damping", contact.normal_damping, "N s/m", 0, 1e6, "damping of the contact"),
    {.name = "joint.release",
     .kind = PARAMETER_CHOICE,
     .offset = offsetof(Beam, release),
     .unit = "",
     .choices = "force|gap",
     .meaning = "the contact lets go at zero force, or when the gap reopens"},
    WHOLE("run.transient_cycles", transient_cycles, 0, 1000000, 300, "cycles of the drive before anything is recorded"),
    WHOLE("run.cycles", cycles, 1, 1000000, 100, "cycles of the drive that are recorded"),
};
enum { ROWS = sizeof beam_rows / sizeof *beam_rows };
_Static_assert((int)ROWS <= (int)BEAM_VALUES, "a provenance for every row");

static const ParameterTable table = {"beam", beam_rows, ROWS};

static const char *const groups[] = {"beam", "pivot", "shaker", "drive", "joint", "run"};

static const ProvenanceFile kind = {"beam",
                                    "clearance-beam",
                                    "A beam of clearance",
                                    &table,
                                    groups,
                                    sizeof groups / sizeof *groups,
                                    "paper|reconstructed|identified|literature: |assumed"};

static ProvenanceTarget target_of(Beam *beam) {
    return (ProvenanceTarget){beam, beam->provenance, &beam->name, &beam->note, &beam->arena};
}

const ParameterTable *beam_table(void) {
    return &table;
}

/* Two places on the beam must coincide within SAME_PLACE times the length or differ by at least APART_LEAST times
 * the length: each place is a node, and rounding destroys the bending stiffness of elements that are much shorter
 * than the others. */
static const double SAME_PLACE = 1e-9, APART_LEAST = 1e-3;

static void check_apart(const Beam *beam, const JsonNode *group, const char *name, double place, const char *what,
                        double other, Fault *fault) {
    double apart = fabs(place - other), least = APART_LEAST * beam->length;
    if (apart > SAME_PLACE * beam->length && apart < least)
        json_fault(group, fault, "%s is %.3g m from %s, must be there, at %.9g m, or at least %.3g m away", name, apart,
                   what, other, least);
}

/* Checks conditions between values: the parts fit together, the beam is supported, and there are enough degrees of
 * freedom for its modes. */
static void check_whole(const Beam *beam, const JsonNode *root, Fault *fault) {
    JsonNode pivot = json_member(root, "pivot"), shaker = json_member(root, "shaker"), own = json_member(root, "beam");
    if (beam->pivot_position > beam->length)
        json_fault(&pivot, fault, "pivot.position is %.9g m, at most the length, %.9g m", beam->pivot_position,
                   beam->length);
    if (beam->shaker_position > beam->length)
        json_fault(&shaker, fault, "shaker.position is %.9g m, at most the length, %.9g m", beam->shaker_position,
                   beam->length);
    check_apart(beam, &pivot, "pivot.position", beam->pivot_position, "the end", 0, fault);
    check_apart(beam, &pivot, "pivot.position", beam->pivot_position, "the tip", beam->length, fault);
    check_apart(beam, &shaker, "shaker.position", beam->shaker_position, "the end", 0, fault);
    check_apart(beam, &shaker, "shaker.position", beam->shaker_position, "the tip", beam->length, fault);
    check_apart(beam, &shaker, "shaker.position", beam->shaker_position, "the pivot", beam->pivot_position, fault);
    bool two_places = beam->pivot_stiffness > 0 && beam->shaker_stiffness > 0 &&
                      fabs(beam->pivot_position - beam->shaker_position) > SAME_PLACE * beam->length;
    bool turned_and_held = beam->pivot_rotational > 0 && (beam->pivot_stiffness > 0 || beam->shaker_stiffness > 0);
    if (!two_places && !turned_and_held)
        json_fault(&pivot, fault,
                   "nothing holds the beam: pivot.translational_stiffness and one of pivot.rotational_stiffness and "
                   "shaker.stiffness must be over 0");
    int freedoms = 2 * (beam->elements + 1);
    if (beam->modes > freedoms)
        json_fault(&own, fault, "beam.modes is %d, at most the freedoms of %d elements, %d", beam->modes,
                   beam->elements, freedoms);
    if (beam->width * beam->thickness * beam->length * beam->density < 1e-9)
        json_fault(&own, fault, "the beam has a mass of %.3g kg, must be at least 1e-09 kg",
                   beam->width * beam->thickness * beam->length * beam->density);
}

bool beam_check(const Beam *beam, const char *place, Fault *fault) {
    size_t before = fault->total;
    char path[200];
    snprintf(path, sizeof path, "%s: ", place);
    JsonFile file = {.path = path, .root = json_object()};
    JsonNode root = json_root(&file);
    check_whole(beam, &root, fault);
    json_decref(file.root);
    return fault->total == before;
}

bool beam_is_file(const char *path) {
    return provenance_file_is(&kind, path);
}

bool beam_read(Beam *beam, const char *path, const char *const *settings, size_t setting_count, Fault *fault) {
    size_t before = fault->total;
    JsonFile file = {0};
    if (!json_read(&file, path, fault))
        return false;
    Beam read = {0};
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
        beam_free(&read);
        return false;
    }
    beam_free(beam);
    *beam = read;
    return true;
}

int beam_write(const Beam *beam, const char *path) {
    Beam written = *beam;
    ProvenanceTarget target = target_of(&written);
    return provenance_file_write(&kind, &target, path);
}

void beam_free(Beam *beam) {
    arena_clear(&beam->arena);
    *beam = (Beam){0};
}

json_t *beam_schema(void) {
    return provenance_file_schema(&kind);
}
