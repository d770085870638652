#include "house/observer.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "space/passage.h"

/* s: time without contact before the next touch counts as a new contact. */
static const double NEW_CONTACT = 0.1;
/* m: rounding of the offset in one step. */
static const double OFFSET_ROUNDING = 1e-6;
/* m: smallest compression of the personal space that counts. */
static const double FELT = 1e-3;

enum { MOST_SQUARES = 1 << 21 };

/* 1: limit of the trace's rows, all of which stay in memory; some 2 GB. */
static const double MOST_ROWS = 2e7;

static bool is_watched(const World *world, size_t i) {
    return world->phase[i] != PHASE_ABSENT;
}

/* True if the person is out, or has stopped for good. */
static bool ended(const World *world, size_t i) {
    return world->phase[i] == PHASE_OUT || world->phase[i] == PHASE_STUCK;
}

static const Extremes no_extremes = {.clearance = HUGE_VAL, .contact = {NAN, NAN}};

static void watch_extremes(Extremes *extremes, const Sense *sense) {
    if (sense->body_force > extremes->body_force) {
        extremes->body_force = sense->body_force;
        extremes->contact = sense->contact_at;
    }
    extremes->clearance = real_min(extremes->clearance, sense->clearance);
    extremes->ring = real_max(extremes->ring, sense->ring);
    extremes->ring_force = real_max(extremes->ring_force, sense->ring_force);
}

/* Adds a row with the present state and the extremes since the last row. */
static void add_row(Observer *observer, size_t i, double offset_rate) {
    const World *world = observer->world;
    Extremes *extremes = &observer->watched[i].extremes;
    watch_extremes(extremes, &world->sense[i]);
    Vec2 at = world_reference(world, i);
    trace_add(&observer->trace,
              (double[TRACE_COLUMNS]){
                  [TRACE_TIME] = world->phase[i] == PHASE_OUT ? world->ended[i] : clock_time(&world->clock),
                  [TRACE_PERSON] = (double)i,
                  [TRACE_X] = at.x,
                  [TRACE_Y] = at.y,
                  [TRACE_HEADING] = world->heading[i],
                  [TRACE_SPEED] = vec2_dot(world->velocity[i], world->axis[i]),
                  [TRACE_CLEARANCE] = extremes->clearance,
                  [TRACE_RING] = extremes->ring,
                  [TRACE_BODY_FORCE] = extremes->body_force,
                  [TRACE_RING_FORCE] = extremes->ring_force,
                  [TRACE_OFFSET] = world->drive[i].offset,
                  [TRACE_OFFSET_RATE] = offset_rate,
                  [TRACE_CONTACT_X] = extremes->contact.x,
                  [TRACE_CONTACT_Y] = extremes->contact.y,
              });
    *extremes = no_extremes;
    observer->watched[i].leapt = false;
}

size_t observer_sample_steps(const House *house) {
    const RunSettings *run = &house->plan.run;
    double least = (double)house->person_count * run->until / MOST_ROWS;
    double steps = real_max(run->sample, least) / run->dt;
    return steps > 1 ? (size_t)(steps + 0.5) : 1;
}

/* Lays squares over the house, by which the paths of walkers are collected. */
static void lay_floor(Observer *observer) {
    Floor *floor = &observer->floor;
    Box box = observer->world->bounds;
    double width = box_width(box), height = box_height(box);
    floor->low = box.low;
    floor->side = fmax(2 * HAZARD_STRETCH, sqrt(width * height / MOST_SQUARES));
    floor->nx = (int)fmin(width / floor->side, MOST_SQUARES) + 1;
    floor->ny = (int)fmin(height / floor->side, MOST_SQUARES) + 1;
    floor->stretch = memory_zeroed((size_t)floor->nx * (size_t)floor->ny, sizeof *floor->stretch);
}

/* Prepares the records for the people in the world: a floor for walkers, a list of chairs. */
static void see_who_is_there(Observer *observer) {
    const World *world = observer->world;
    observer->rider_count = 0;
    for (size_t i = 0; i < world->count; i++) {
        if (!is_watched(world, i))
            continue;
        if (!world_rides(world, i) && !observer->floor.stretch)
            lay_floor(observer);
        if (world_rides(world, i))
            observer->riders[observer->rider_count++] = i;
    }
}

/* Returns the exit of a route. */
static size_t exit_of(const Route *route) {
    return route->answer == ROUTE_NO_EXIT ? SIZE_MAX : route->exit;
}

static void begin_person(Observer *observer, size_t i) {
    const World *world = observer->world;
    const Route *route = &world->journeys[i].route;
    double now = clock_time(&world->clock);
    observer->watched[i] =
        (Watched){.at = world_reference(world, i), .untouched = HUGE_VAL, .time = now, .extremes = no_extremes};
    observer->people[i] = (PersonObservation){.took_part = true,
                                              .exit = exit_of(route),
                                              .reversals = route->reversals,
                                              .narrowest = world->body[i].sight,
                                              .narrowest_other = -1,
                                              .narrowest_at = observer->watched[i].at,
                                              .narrowest_heading = world->heading[i]};
    add_row(observer, i, 0);
}

void observer_init(Observer *observer, const World *world, PersonObservation *people) {
    *observer = (Observer){.world = world,
                           .people = people,
                           .watched = memory_zeroed(world->count, sizeof *observer->watched),
                           .riders = memory_zeroed(world->count, sizeof *observer->riders),
                           .door_opened = memory_zeroed(world->house->plan.door_count, sizeof(double)),
                           .door_changes = world->door_changes,
                           .sample_steps = observer_sample_steps(world->house)};
    trace_init(&observer->trace, observation_columns, TRACE_COLUMNS);
    for (size_t d = 0; d < world->house->plan.door_count; d++)
        observer->door_opened[d] = HUGE_VAL;
    see_who_is_there(observer);
    for (size_t i = 0; i < world->count; i++)
        if (is_watched(world, i))
            begin_person(observer, i);
}

void observer_clear(Observer *observer) {
    memory_free(observer->watched);
    memory_free(observer->riders);
    memory_free(observer->door_opened);
    memory_free(observer->floor.stretch);
    memory_free(observer->stretches);
    memory_free(observer->touches);
    trace_clear(&observer->trace);
    *observer = (Observer){0};
}

static size_t add_stretch(Observer *observer, Vec2 at) {
    observer->stretches = memory_reserve(observer->stretches, &observer->stretch_capacity, observer->stretch_count + 1,
                                         sizeof *observer->stretches);
    observer->stretches[observer->stretch_count] = (Stretch){.at = at, .other = -1, .clearance = HUGE_VAL};
    return observer->stretch_count++;
}

/* Returns the square of a walker, shared by all walkers who pass it. */
static Stretch *square_of(Observer *observer, Vec2 at) {
    Floor *floor = &observer->floor;
    int x = cell_grid_index((at.x - floor->low.x) / floor->side, floor->nx - 1);
    int y = cell_grid_index((at.y - floor->low.y) / floor->side, floor->ny - 1);
    size_t *stretch = &floor->stretch[(size_t)y * (size_t)floor->nx + (size_t)x];
    if (*stretch == 0)
        *stretch = add_stretch(observer, at) + 1;
    return &observer->stretches[*stretch - 1];
}

/* Returns the stretch of the path on which the person is. */
static Stretch *stretch_of(Observer *observer, size_t i, Vec2 at) {
    Watched *watched = &observer->watched[i];
    if (!world_rides(observer->world, i))
        return square_of(observer, at);
    if (!watched->stretch || observer->people[i].path_length >= watched->ended) {
        watched->stretch = add_stretch(observer, observer->world->centre[i]) + 1;
        observer->stretches[watched->stretch - 1].other = HAZARD_ALONE;
        watched->ended += HAZARD_STRETCH;
    }
    return &observer->stretches[watched->stretch - 1];
}

/* Records the clearance. Walkers near one another are not a danger of the house, nor is what is out of sight. */
static void watch_clearance(PersonObservation *person, Stretch *stretch, const World *world, size_t i, Vec2 at) {
    const Sense *sense = &world->sense[i];
    bool felt = sense->clearance < world->body[i].sight, rides = world_rides(world, i);
    if (felt && sense->clearance < stretch->clearance && (rides || sense->other < 0)) {
        stretch->clearance = sense->clearance;
        stretch->at = sense->nearest_at;
        stretch->other = sense->other;
    }
    if (sense->clearance < person->narrowest) {
        person->narrowest = sense->clearance;
        person->narrowest_at = at;
        person->narrowest_heading = world->heading[i];
        person->narrowest_to = sense->nearest_at;
        person->narrowest_other = sense->other;
    }
}

static Touch *add_touch(Observer *observer, Touch touch) {
    observer->touches = memory_reserve(observer->touches, &observer->touch_capacity, observer->touch_count + 1,
                                       sizeof *observer->touches);
    observer->touches[observer->touch_count] = touch;
    return &observer->touches[observer->touch_count++];
}

static void watch_contact(PersonObservation *person, Stretch *stretch, Watched *watched, const Sense *sense,
                          double elapsed) {
    if (sense->body_force > 0) {
        person->contacts += watched->untouched >= NEW_CONTACT;
        watched->untouched = 0;
        person->impulse += sense->body_force * elapsed;
        stretch->peak_force = real_max(stretch->peak_force, sense->body_force);
        if (sense->body_force > person->peak_force) {
            person->peak_force = sense->body_force;
            person->peak_at = sense->contact_at;
        }
    } else {
        watched->untouched += elapsed;
    }
}

/* Notes an impact, and how hard the chair is squeezed. */
static void watch_touch(Observer *observer, size_t i, Stretch *stretch, double elapsed, bool begins) {
    PersonObservation *person = &observer->people[i];
    Watched *watched = &observer->watched[i];
    const Sense *sense = &observer->world->sense[i];
    if (begins) {
        add_touch(observer, (Touch){.person = i,
                                    .at = sense->contact_at,
                                    .part = sense->part,
                                    .other = sense->other,
                                    .time = clock_time(&observer->world->clock)});
        watched->touch = observer->touch_count;
    }
    Touch *touch = watched->touch ? &observer->touches[watched->touch - 1] : NULL;
    Squeeze *squeeze = &watched->squeeze;
    squeeze->elapsed += elapsed;
    if (squeeze->elapsed >= OBSERVATION_SQUEEZE / SQUEEZE_PARTS) {
        squeeze->part = (squeeze->part + 1) % SQUEEZE_PARTS;
        squeeze->parts[squeeze->part] = squeeze->elapsed = 0;
    }
    if (sense->body_force > 0) {
        squeeze->parts[squeeze->part] += sense->body_force * elapsed;
        double sum = 0;
        for (int p = 0; p < SQUEEZE_PARTS; p++)
            sum += squeeze->parts[p];
        person->squeeze = real_max(person->squeeze, sum / OBSERVATION_SQUEEZE);
        touch->squeeze = real_max(touch->squeeze, sum / OBSERVATION_SQUEEZE);
        touch->impulse += sense->body_force * elapsed;
    }
    if (!(sense->impact > 0))
        return;
    if (touch && sense->impact > touch->speed) {
        touch->at = sense->contact_at;
        touch->part = sense->part;
        touch->speed = sense->impact;
        touch->mass = sense->mass;
    }
    if (touch)
        touch->energy += sense->energy;
    person->energy += sense->energy;
    stretch->energy += sense->energy;
    stretch->impact = real_max(stretch->impact, sense->impact);
    if (sense->impact > person->impact) {
        person->impact = sense->impact;
        person->impact_energy = sense->energy;
        person->impact_part = sense->part;
        person->impact_at = sense->contact_at;
    }
}

/* Returns the nearest point of a face to a place. */
static Vec2 nearest_on(const Face *face, Vec2 at) {
    Vec2 along = vec2_sub(face->b, face->a);
    double square = vec2_dot(along, along);
    double part = square > 0 ? vec2_dot(vec2_sub(at, face->a), along) / square : 0;
    return vec2_along(face->a, real_clamp(part, 0, 1), along);
}

/* Notes where an obstacle comes between the rims and what they pass, from one row of the trace to the next. */
static void watch_hands(Observer *observer, size_t i, double time) {
    const World *world = observer->world;
    const House *house = world->house;
    const Profile *profile = house->people[i].profile;
    Watched *watched = &observer->watched[i];
    Vec2 axis = world->axis[i], axle = world_reference(world, i);
    bool near = profile->driving == DRIVING_DRIVER && world->sense[i].clearance < profile->hands;
    for (int side = 0; side < 2; side++) {
        int face = -1;
        double out = (side ? -1 : 1) * (profile->width + profile->hands) / 2;
        Vec2 middle = vec2_along(axle, out, vec2_left(axis));
        bool meets = near && freespace_clearance(&house->space, middle, axis, OBSERVATION_RIMS, profile->hands / 2, 0,
                                                 &face) < 0;
        if (meets && !watched->hands[side] && face >= 0)
            add_touch(observer,
                      (Touch){.person = i,
                              .at = nearest_on(&house->outline.faces[face], middle),
                              .part = PART_HAND,
                              .other = -1,
                              .time = time,
                              .speed = vec2_length(world->velocity[i]),
                              .mass = profile->mass,
                              .energy = profile->mass * vec2_dot(world->velocity[i], world->velocity[i]) / 2});
        watched->hands[side] = meets;
    }
}

/* m/s: a chair that rolls back more slowly does not drive backwards. */
static const double ROLLS_BACK = 0.05;

static void watch_backing(PersonObservation *person, Watched *watched, const World *world, size_t i, double moved,
                          double elapsed) {
    bool backs = vec2_dot(world->velocity[i], world->axis[i]) < -ROLLS_BACK;
    if (backs) {
        person->back_length += moved;
        person->back_time += elapsed;
        person->back_times += !watched->backs;
        person->back_out = world->phase[i] == PHASE_OUT;
    }
    watched->backs = backs;
}

/* Records a departure at once, so that it can be displayed while others are still moving. */
static void note_out(Observer *observer, size_t i) {
    PersonObservation *person = &observer->people[i];
    person->completed = true;
    person->exit = observer->world->exit[i];
    person->time = observer->world->ended[i];
}

static void watch_person(Observer *observer, size_t i) {
    const World *world = observer->world;
    PersonObservation *person = &observer->people[i];
    Watched *watched = &observer->watched[i];
    const Sense *sense = &world->sense[i];
    double time = ended(world, i) ? world->ended[i] : clock_time(&world->clock);
    double elapsed = real_max(time - watched->time, 0), free_speed = world->house->people[i].speed;
    Vec2 at = world_reference(world, i);
    double moved = vec2_distance(watched->at, at), change = world->drive[i].offset - watched->offset;
    Stretch *stretch = stretch_of(observer, i, at);
    person->path_length += moved;
    bool rows = world->clock.step % observer->sample_steps == 0 || world->phase[i] == PHASE_OUT;
    bool begins = sense->body_force > 0 && watched->untouched >= NEW_CONTACT;
    watch_clearance(person, stretch, world, i, at);
    watch_contact(person, stretch, watched, sense, elapsed);
    if (world_rides(world, i)) {
        watch_touch(observer, i, stretch, elapsed, begins);
        if (rows)
            watch_hands(observer, i, time);
        watch_backing(person, watched, world, i, moved, elapsed);
    }
    watch_extremes(&watched->extremes, sense);
    watched->leapt |= fabs(change) > moved + OFFSET_ROUNDING;
    person->ring_time += sense->ring > FELT ? elapsed : 0;
    person->ring_peak = real_max(person->ring_peak, sense->ring);
    if (world->phase[i] != PHASE_WAITING) {
        double lost = elapsed - moved / free_speed;
        person->lost_time += lost;
        stretch->lost_time += lost;
    }
    if (rows)
        add_row(observer, i, watched->leapt ? (double)NAN : elapsed > 0 ? change / elapsed : 0);
    watched->at = at;
    watched->time = time;
    watched->offset = world->drive[i].offset;
    watched->done = ended(world, i);
    if (world->phase[i] == PHASE_OUT)
        note_out(observer, i);
}

static void watch_if_going(Observer *observer, size_t i) {
    const World *world = observer->world;
    if (is_watched(world, i) && !(observer->watched[i].done && ended(world, i)))
        watch_person(observer, i);
}

/* Records opened doors, which stay open. */
static void watch_doors(Observer *observer) {
    const World *world = observer->world;
    const Plan *plan = &world->house->plan;
    for (size_t d = 0; d < plan->door_count && world->door_changes != observer->door_changes; d++)
        if (outline_door_moves(&plan->doors[d]) && world->door_open[d])
            observer->door_opened[d] = real_min(observer->door_opened[d], clock_time(&world->clock));
    observer->door_changes = world->door_changes;
}

void observer_watch(Observer *observer) {
    const World *world = observer->world;
    watch_doors(observer);
    bool everybody = world->sensed || world->clock.step % observer->sample_steps == 0;
    for (size_t i = 0; everybody && i < world->count; i++)
        watch_if_going(observer, i);
    for (size_t r = 0; !everybody && r < observer->rider_count; r++)
        watch_if_going(observer, observer->riders[r]);
}

/* A change of the plan --------------------------------------------------------------------------------------------- */

static void catch_up(Observer *observer, size_t i) {
    if (observer->watched[i].time < clock_time(&observer->world->clock))
        watch_if_going(observer, i);
}

void observer_catch_up(Observer *observer) {
    for (size_t i = 0; i < observer->world->count; i++)
        catch_up(observer, i);
}

/* Keeps the rows of people who are still there, with their new indices. */
static void rename_rows(Trace *trace, const Change *change) {
    size_t kept = 0;
    for (size_t r = 0; r < trace->rows; r++) {
        double *row = trace->values + r * trace->width, *place = trace->values + kept * trace->width;
        size_t person = change->person_after[(size_t)row[TRACE_PERSON]];
        if (person == SIZE_MAX)
            continue;
        memmove(place, row, trace->width * sizeof *row);
        place[TRACE_PERSON] = (double)person;
        kept++;
    }
    trace->rows = kept;
}

/* Returns the new index of the nearest person, or -1 for an obstacle or a removed person. */
static int other_after(const Change *change, int other) {
    size_t person = other < 0 ? SIZE_MAX : change->person_after[other];
    return person == SIZE_MAX ? -1 : (int)person;
}

/* Keeps the touches of people who are still there, each of whom finds the last one of the body again. */
static void rename_touches(Observer *observer, const Change *change, Watched *watched, size_t people) {
    size_t kept = 0;
    for (size_t i = 0; i < people; i++)
        watched[i].touch = 0;
    for (size_t t = 0; t < observer->touch_count; t++) {
        Touch touch = observer->touches[t];
        touch.person = change->person_after[touch.person];
        if (touch.person == SIZE_MAX)
            continue;
        touch.other = other_after(change, touch.other);
        observer->touches[kept++] = touch;
        if (touch.part != PART_HAND)
            watched[touch.person].touch = kept;
    }
    observer->touch_count = kept;
}

static PersonObservation renamed_person(const Change *change, PersonObservation person) {
    person.narrowest_other = other_after(change, person.narrowest_other);
    person.exit = person.exit == SIZE_MAX ? SIZE_MAX : change->exit_after[person.exit];
    return person;
}

void observer_rename(Observer *observer, const Change *change, PersonObservation *people) {
    size_t count = change->to->person_count, doors = change->to->plan.door_count;
    Watched *watched = memory_zeroed(count, sizeof *watched);
    double *door_opened = memory_zeroed(doors, sizeof *door_opened);
    for (size_t i = 0; i < count; i++) {
        size_t before = change->person_before[i];
        if (before == SIZE_MAX || !observer->people[before].took_part)
            continue;
        watched[i] = observer->watched[before];
        people[i] = renamed_person(change, observer->people[before]);
    }
    for (size_t d = 0; d < doors; d++)
        door_opened[d] = change->door_before[d] == SIZE_MAX ? HUGE_VAL : observer->door_opened[change->door_before[d]];
    for (size_t s = 0; s < observer->stretch_count; s++)
        observer->stretches[s].other = other_after(change, observer->stretches[s].other);
    rename_touches(observer, change, watched, count);
    rename_rows(&observer->trace, change);
    memory_free(observer->watched);
    memory_free(observer->door_opened);
    memory_free(observer->riders);
    memory_free(observer->floor.stretch);
    observer->watched = watched;
    observer->people = people;
    observer->door_opened = door_opened;
    observer->riders = memory_zeroed(count, sizeof *observer->riders);
    observer->rider_count = 0;
    observer->floor = (Floor){0}; /* squares of the old and the new house are merged by position */
}

void observer_resume(Observer *observer) {
    const World *world = observer->world;
    see_who_is_there(observer);
    for (size_t i = 0; i < world->count; i++) {
        if (!is_watched(world, i))
            continue;
        if (!observer->people[i].took_part) {
            begin_person(observer, i);
        } else if (world->phase[i] != PHASE_OUT) {
            const Route *route = &world->journeys[i].route;
            observer->people[i].exit = exit_of(route);
            observer->people[i].reversals = route->reversals;
            observer->watched[i].offset = world->drive[i].offset;
            observer->watched[i].at = world_reference(world, i);
            observer->watched[i].leapt = true;
        }
    }
}

/* The end --------------------------------------------------------------------------------------------------------- */

/* Fills in the blockage of a stalled person: the cause, and the width there where that is too small. */
static void fill_blockage(const World *world, size_t i, Blockage *blockage) {
    const House *house = world->house;
    const Sense *sense = &world->sense[i];
    double width = house->people[i].profile->width;
    *blockage = (Blockage){.at = sense->clearance < world->body[i].sight ? sense->nearest_at : world->centre[i]};
    if (sense->other >= 0) {
        snprintf(blockage->what, sizeof blockage->what, "person %s", house->people[sense->other].id);
        width += house->people[sense->other].profile->width;
    } else {
        outline_place_name(&house->outline, &house->plan, blockage->at, blockage->what, sizeof blockage->what);
    }
    double has = passage_width(passage_at(&house->outline, world->centre[i], world->axis[i]));
    if (has < width) {
        blockage->has = has;
        blockage->needs = width;
    }
}

/* Adds the last good state of a person when the run ends early. */
static void add_last_row(Observer *observer, size_t i) {
    const World *world = observer->world;
    if (world->phase[i] != PHASE_OUT && world->clock.step % observer->sample_steps != 0)
        add_row(observer, i, 0);
}

/* Returns why a person has not left when the run ends. A blocked person tries again later, so that an interrupted run
 * leaves open whether that person can leave. */
static Reason end_reason(const World *world, size_t i, Reason reason) {
    bool stuck = world->phase[i] == PHASE_STUCK;
    return stuck && !(world->reason[i] == REASON_BLOCKED && reason == REASON_INTERRUPTED) ? (Reason)world->reason[i]
                                                                                          : reason;
}

void observer_end(Observer *observer, Reason reason) {
    const World *world = observer->world;
    for (size_t i = 0; i < world->count; i++) {
        if (!is_watched(world, i))
            continue;
        catch_up(observer, i);
        if (reason == REASON_INTERRUPTED || reason == REASON_OTHER_DIVERGED)
            add_last_row(observer, i);
        PersonObservation *person = &observer->people[i];
        const Route *route = &world->journeys[i].route;
        if (world->phase[i] == PHASE_OUT) {
            note_out(observer, i);
            continue;
        }
        person->reason = end_reason(world, i, reason);
        person->time = ended(world, i) ? world->ended[i] : clock_time(&world->clock);
        if (observation_reason_is_planned(person->reason))
            person->blockage = route->blockage;
        else if (person->reason == REASON_BLOCKED)
            fill_blockage(world, i, &person->blockage);
    }
}
