#include "experiment/shake_record.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "plan/plan_geometry.h"

/* m: a piece farther than this beyond the width that a stopped person needs is not the cause. */
static const double BESIDE = 0.05;

ShakeRecord shake_record_of(const Plan *plan, size_t usual) {
    ShakeRecord record = {.party_count = plan->person_count + plan->crowd_count, .piece_count = plan->furniture_count};
    record.out = usual;
    record.time = record.out + record.party_count;
    record.toppled = record.time + record.party_count;
    record.blocks = record.toppled + record.piece_count;
    record.elsewhere = record.blocks + record.piece_count;
    record.caught = record.elsewhere + 1;
    record.count = record.caught + 1;
    return record;
}

static Observable describe(Arena *arena, const char *name, const char *id, const char *unit, const char *meaning) {
    return (Observable){text_in_arena(arena, "%s.%s", name, id), unit, text_in_arena(arena, "%s: %s", id, meaning)};
}

void shake_record_describe(const ShakeRecord *record, const Plan *plan, Observable *observables, Arena *arena) {
    for (size_t p = 0; p < record->party_count; p++) {
        bool crowd = p >= plan->person_count;
        const char *id = crowd ? plan->crowds[p - plan->person_count].id : plan->people[p].id;
        observables[record->out + p] = describe(arena, "out", id, "1", crowd ? "share of them who are out" : "is out");
        observables[record->time + p] = describe(arena, "time", id, "s", crowd ? "time until all are out" : "time");
    }
    for (size_t f = 0; f < record->piece_count; f++) {
        const char *id = plan->furniture[f].id;
        observables[record->toppled + f] = describe(arena, "toppled", id, "1", "fell in this shake");
        observables[record->blocks + f] = describe(arena, "blocks", id, "1", "people whom it stops");
    }
    observables[record->elsewhere] = (Observable){"elsewhere", "1", "people stopped by something else than furniture"};
    observables[record->caught] = (Observable){"caught", "1", "people on whom something fell"};
}

/* Returns the person in the plan, or the crowd that has a member NAME-1, NAME-2, ... */
static size_t party_of(const Plan *plan, const char *id) {
    size_t person = plan_find_person(plan, id);
    if (person != SIZE_MAX)
        return person;
    const char *end = strrchr(id, '-');
    size_t length = end ? (size_t)(end - id) : 0, crowd = 0;
    while (crowd < plan->crowd_count &&
           (strlen(plan->crowds[crowd].id) != length || memcmp(plan->crowds[crowd].id, id, length) != 0))
        crowd++;
    return crowd < plan->crowd_count ? plan->person_count + crowd : SIZE_MAX;
}

static double distance_of(const Furniture *piece, Vec2 at) {
    Vec2 corners[4];
    plan_geometry_corners(piece, corners);
    double nearest = HUGE_VAL;
    bool inside = true;
    for (int i = 0; i < 4; i++) {
        Vec2 from = corners[i], to = corners[(i + 1) % 4];
        nearest = fmin(nearest, vec2_distance(at, vec2_nearest_on_segment(at, from, to)));
        inside &= vec2_cross(vec2_sub(to, from), vec2_sub(at, from)) >= 0;
    }
    return inside ? 0 : nearest;
}

/* Returns the piece that a place is named after: "wardrobe (f3)", "start, inside wardrobe (f3)". */
static size_t piece_called(const Plan *plan, const char *what) {
    size_t length = strlen(what);
    for (size_t f = 0; f < plan->furniture_count; f++) {
        char name[sizeof((Blockage *)0)->what];
        outline_name(plan, OWNER_FURNITURE, (int)f, name, sizeof name);
        size_t own = strlen(name);
        bool ends = own <= length && strcmp(what + length - own, name) == 0;
        if (ends && (own == length || what[length - own - 1] == ' '))
            return f;
    }
    return SIZE_MAX;
}

/* Returns the piece that stops a person, or SIZE_MAX. */
static size_t stopped_by(const Plan *before, const House *house, const Inhabitant *person,
                         const PersonObservation *observed) {
    const Plan *plan = &house->plan;
    const Blockage *blockage = &observed->blockage;
    if (person->under)
        return (size_t)(person->under - plan->furniture);
    if (observed->reason != REASON_CANNOT_PASS && observed->reason != REASON_BLOCKED)
        return SIZE_MAX;
    double nearest = fmax(blockage->has, fmax(blockage->needs, person->profile->width)) / 2 + BESIDE;
    size_t found = SIZE_MAX;
    for (size_t f = 0; f < plan->furniture_count; f++) {
        double distance = distance_of(&plan->furniture[f], blockage->at);
        if (plan->furniture[f].toppled && !before->furniture[f].toppled && distance < nearest) {
            nearest = distance;
            found = f;
        }
    }
    return found == SIZE_MAX ? piece_called(plan, blockage->what) : found;
}

/* Completes the record of the parties, given the members who are out and the number who take part. */
static void conclude(const ShakeRecord *record, const size_t *people, double *observed) {
    for (size_t p = 0; p < record->party_count; p++) {
        bool all = observed[record->out + p] == (double)people[p];
        observed[record->time + p] = people[p] && all ? observed[record->time + p] : (double)NAN;
        observed[record->out + p] = people[p] ? observed[record->out + p] / (double)people[p] : (double)NAN;
    }
}

void shake_record_observe(const ShakeRecord *record, const Plan *before, const House *house,
                          const Observation *observation, double *observed) {
    const Plan *plan = &house->plan;
    size_t *people = memory_zeroed(record->party_count, sizeof *people);
    for (size_t o = record->out; o < record->count; o++)
        observed[o] = 0;
    for (size_t f = 0; f < record->piece_count; f++)
        observed[record->toppled + f] = plan->furniture[f].toppled && !before->furniture[f].toppled;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        size_t party = party_of(plan, house->people[i].id);
        if (!person->took_part || party == SIZE_MAX)
            continue;
        people[party]++;
        observed[record->out + party] += person->completed;
        observed[record->time + party] = fmax(observed[record->time + party], person->time);
        observed[record->caught] += house->people[i].under != NULL;
        if (person->completed)
            continue;
        size_t piece = stopped_by(before, house, &house->people[i], person);
        observed[piece == SIZE_MAX ? record->elsewhere : record->blocks + piece]++;
    }
    conclude(record, people, observed);
    memory_free(people);
}
