#include "laboratory/house/passing.h"

#include "plan/plan_geometry.h"

/* Returns the index of the first row after a time. */
static size_t row_after(const Trail *trail, double time) {
    size_t low = 0, high = trail->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (trail->rows[middle][TRACE_TIME] > time)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/* Returns 1 or -1 if a step crosses a segment to its left or right, otherwise 0. */
static int crossing(Vec2 a, Vec2 b, Vec2 from, Vec2 to) {
    Vec2 along = vec2_sub(to, from);
    bool begins = vec2_cross(along, vec2_sub(a, from)) > 0, ends = vec2_cross(along, vec2_sub(b, from)) > 0;
    Vec2 step = vec2_sub(b, a);
    bool within = (vec2_cross(step, vec2_sub(from, a)) > 0) != (vec2_cross(step, vec2_sub(to, a)) > 0);
    return begins == ends || !within ? 0 : ends ? 1 : -1;
}

/* True if a person is on the other side of a segment after a time than before it. */
static bool has_passed(const Trail *trail, Vec2 from, Vec2 to, double since, double time) {
    int net = 0;
    size_t end = row_after(trail, time), first = row_after(trail, since);
    for (size_t r = first > 0 ? first : 1; r < end; r++) {
        const double *before = trail->rows[r - 1], *row = trail->rows[r];
        net += crossing(vec2(before[TRACE_X], before[TRACE_Y]), vec2(row[TRACE_X], row[TRACE_Y]), from, to);
    }
    return net != 0;
}

double passing_door(const Plan *plan, const Door *door, const Trail *trails, size_t count, double time) {
    Vec2 from, to;
    size_t passed = 0;
    plan_geometry_door_ends(plan, door, &from, &to);
    for (size_t i = 0; i < count; i++)
        passed += has_passed(&trails[i], from, to, time - PASSING_WINDOW, time);
    return (double)passed / PASSING_WINDOW;
}

double passing_exit(const Observation *observation, size_t exit, double time) {
    size_t passed = 0;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        passed += person->took_part && person->completed && person->exit == exit && person->time <= time &&
                  person->time > time - PASSING_WINDOW;
    }
    return (double)passed / PASSING_WINDOW;
}
