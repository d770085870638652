#include "inquiry/measure.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/order.h"

/* m: a person who has moved this far from the start has started. Larger than the displacement by which personal spaces
 * settle. */
static const double HAIR = 0.01;

/* Who is asked about ------------------------------------------------------------------------------------------------*/

static bool is_member(const House *house, const char *person, const char *id) {
    size_t length = strlen(id);
    if (strncmp(person, id, length) != 0)
        return false;
    if (!person[length])
        return true;
    const char *number = person + length + 1;
    if (person[length] != '-' || !*number || number[strspn(number, "0123456789")])
        return false;
    for (size_t c = 0; c < house->plan.crowd_count; c++)
        if (strcmp(house->plan.crowds[c].id, id) == 0)
            return true;
    return false;
}

bool measure_is_of(const House *house, size_t person, const Ids *ids) {
    for (size_t i = 0; i < ids->count; i++)
        if (is_member(house, house->people[person].id, ids->at[i]))
            return true;
    return !ids->count;
}

static bool asked(const House *house, const Observation *observation, const MeasureQuestion *question, size_t person) {
    return observation->people[person].took_part && measure_is_of(house, person, &question->of);
}

static void no_value(MeasureAnswer *answer, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void no_value(MeasureAnswer *answer, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(answer->note, sizeof answer->note, format, arguments);
    va_end(arguments);
    answer->value = (double)NAN;
}

/* Returns false, with a note, if one of the people is still in, or there are no people. */
static bool all_out(MeasureAnswer *answer, const House *house, const Observation *observation,
                    const MeasureQuestion *question) {
    size_t count = 0, left = 0, first = SIZE_MAX;
    for (size_t i = 0; i < observation->person_count; i++) {
        if (!asked(house, observation, question, i))
            continue;
        count++;
        if (observation->people[i].completed)
            continue;
        left++;
        first = first == SIZE_MAX ? i : first;
    }
    if (!count)
        no_value(answer, "no person takes part");
    else if (left)
        no_value(answer, "%zu of %zu people did not leave, the first of them %.60s: %s after %.1f s", left, count,
                 house->people[first].id, observation_reason(observation->people[first].reason),
                 observation->people[first].time);
    return count && !left;
}

static size_t find_exit(const House *house, const char *id) {
    for (size_t e = 0; e < house->plan.exit_count; e++)
        if (strcmp(house->plan.exits[e].id, id) == 0)
            return e;
    return SIZE_MAX;
}

/* People ------------------------------------------------------------------------------------------------------------*/

static void take_time(MeasureAnswer *answer, const House *house, const Observation *observation,
                      const MeasureQuestion *question) {
    if (!all_out(answer, house, observation, question))
        return;
    for (size_t i = 0; i < observation->person_count; i++)
        if (asked(house, observation, question, i))
            answer->value = fmax(answer->value, observation->people[i].time);
}

static void take_mean_time(MeasureAnswer *answer, const House *house, const Observation *observation,
                           const MeasureQuestion *question) {
    if (!all_out(answer, house, observation, question))
        return;
    size_t count = 0;
    for (size_t i = 0; i < observation->person_count; i++) {
        if (!asked(house, observation, question, i))
            continue;
        answer->value += observation->people[i].time;
        count++;
    }
    answer->value /= (double)count;
}

static void take_out(MeasureAnswer *answer, const House *house, const Observation *observation,
                     const MeasureQuestion *question) {
    for (size_t i = 0; i < observation->person_count; i++)
        answer->value += asked(house, observation, question, i) && observation->people[i].completed;
}

static void take_wall_crossings(MeasureAnswer *answer, const House *house, const Observation *observation,
                                const MeasureQuestion *question) {
    (void)house, (void)question;
    answer->value = observation->wall_crossings;
}

static void take_exit_count(MeasureAnswer *answer, const House *house, const Observation *observation,
                            const MeasureQuestion *question) {
    size_t exit = find_exit(house, question->exit);
    for (size_t i = 0; i < observation->person_count; i++)
        answer->value += asked(house, observation, question, i) && observation->people[i].completed &&
                         observation->people[i].exit == exit;
}

static void take_assigned(MeasureAnswer *answer, const House *house, const Observation *observation,
                          const MeasureQuestion *question) {
    size_t assigned = 0, kept = 0;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PlanRoute *route = house->people[i].route;
        if (!asked(house, observation, question, i) || !route || route->exit_index == SIZE_MAX)
            continue;
        const PersonObservation *person = &observation->people[i];
        bool good = person->completed && person->exit == route->exit_index;
        assigned++;
        kept += good;
        if (!good && !*answer->note)
            snprintf(answer->note, sizeof answer->note, "%.60s %s%.60s", house->people[i].id,
                     person->completed ? "left by " : "did not leave",
                     person->completed ? house->plan.exits[person->exit].id : "");
    }
    if (!assigned)
        no_value(answer, "no person has an assigned exit");
    else
        answer->value = (double)kept / (double)assigned;
}

static double distance_to_exit(const House *house, const Observation *observation, size_t person) {
    const Exit *exit = &house->plan.exits[observation->people[person].exit];
    return vec2_distance(house->people[person].at,
                         vec2_nearest_on_segment(house->people[person].at, exit->from, exit->to));
}

static void take_overtaking(MeasureAnswer *answer, const House *house, const Observation *observation,
                            const MeasureQuestion *question) {
    const MeasureQuestion others = {.of = question->past};
    if (!all_out(answer, house, observation, question) || !all_out(answer, house, observation, &others))
        return;
    size_t pairs = 0, before = 0;
    for (size_t i = 0; i < observation->person_count; i++) {
        if (!asked(house, observation, question, i))
            continue;
        double behind = distance_to_exit(house, observation, i);
        for (size_t j = 0; j < observation->person_count; j++) {
            if (j == i || !asked(house, observation, &others, j) || behind <= distance_to_exit(house, observation, j))
                continue;
            pairs++;
            before += observation->people[i].time < observation->people[j].time;
        }
    }
    if (!pairs)
        no_value(answer, "no person starts behind another one");
    else
        answer->value = (double)before / (double)pairs;
}

/* Sums and extremes over the people; a person who is still in counts as far as he came. */

static void take_narrowest(MeasureAnswer *answer, const House *house, const Observation *observation,
                           const MeasureQuestion *question) {
    answer->value = HUGE_VAL;
    for (size_t i = 0; i < observation->person_count; i++)
        if (asked(house, observation, question, i))
            answer->value = fmin(answer->value, observation->people[i].narrowest);
    if (answer->value == HUGE_VAL)
        no_value(answer, "no person takes part");
}

static void take_peak_force(MeasureAnswer *answer, const House *house, const Observation *observation,
                            const MeasureQuestion *question) {
    for (size_t i = 0; i < observation->person_count; i++)
        if (asked(house, observation, question, i))
            answer->value = fmax(answer->value, observation->people[i].peak_force);
}

static void take_contacts(MeasureAnswer *answer, const House *house, const Observation *observation,
                          const MeasureQuestion *question) {
    for (size_t i = 0; i < observation->person_count; i++)
        answer->value += asked(house, observation, question, i) ? observation->people[i].contacts : 0;
}

static void take_reversals(MeasureAnswer *answer, const House *house, const Observation *observation,
                           const MeasureQuestion *question) {
    for (size_t i = 0; i < observation->person_count; i++)
        answer->value += asked(house, observation, question, i) ? observation->people[i].reversals : 0;
}

static void take_path_length(MeasureAnswer *answer, const House *house, const Observation *observation,
                             const MeasureQuestion *question) {
    for (size_t i = 0; i < observation->person_count; i++)
        if (asked(house, observation, question, i))
            answer->value = fmax(answer->value, observation->people[i].path_length);
}

static void take_out_share(MeasureAnswer *answer, const House *house, const Observation *observation,
                           const MeasureQuestion *question) {
    size_t count = 0;
    for (size_t i = 0; i < observation->person_count; i++) {
        count += asked(house, observation, question, i);
        answer->value += asked(house, observation, question, i) && observation->people[i].completed;
    }
    if (count)
        answer->value /= (double)count;
    else
        no_value(answer, "no person takes part");
}

/* The trace ---------------------------------------------------------------------------------------------------------*/

/* The motion of a person from one row of the trace to the next. */
typedef struct Move {
    size_t person;
    double from, until; /* s */
    Vec2 a, b;          /* m */
} Move;

/* Walks through the trace; `last` (person_count) stores each person's last row. */
typedef struct Walk {
    const Trace *trace;
    size_t row;
    size_t *last;
} Walk;

static Walk walk_begin(const Observation *observation) {
    Walk walk = {&observation->trace, 0, memory_zeroed(observation->person_count, sizeof *walk.last)};
    for (size_t i = 0; i < observation->person_count; i++)
        walk.last[i] = SIZE_MAX;
    return walk;
}

static bool walk_next(Walk *walk, Move *move) {
    while (walk->row < walk->trace->rows) {
        const double *row = trace_row(walk->trace, walk->row);
        size_t person = (size_t)row[TRACE_PERSON], last = walk->last[person];
        walk->last[person] = walk->row++;
        if (last == SIZE_MAX)
            continue;
        const double *before = trace_row(walk->trace, last);
        *move = (Move){person, before[TRACE_TIME], row[TRACE_TIME], vec2(before[TRACE_X], before[TRACE_Y]),
                       vec2(row[TRACE_X], row[TRACE_Y])};
        return true;
    }
    memory_free(walk->last);
    walk->last = NULL;
    return false;
}

static bool inside(const Points *outline, Vec2 p) {
    bool in = false;
    for (size_t i = 0, j = outline->count - 1; i < outline->count; j = i++) {
        Vec2 a = outline->at[i], b = outline->at[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
            in = !in;
    }
    return in;
}

static double area_of(const Points *outline) {
    double twice = 0;
    for (size_t i = 0, j = outline->count - 1; i < outline->count; j = i++)
        twice += vec2_cross(outline->at[j], outline->at[i]);
    return fabs(twice) / 2;
}

static void take_start(MeasureAnswer *answer, const House *house, const Observation *observation,
                       const MeasureQuestion *question) {
    double *started = memory_zeroed(observation->person_count, sizeof *started); /* s; 0: not started */
    Move move;
    for (Walk walk = walk_begin(observation); walk_next(&walk, &move);)
        if (started[move.person] <= 0 && vec2_distance(move.b, house->people[move.person].at) > HAIR)
            started[move.person] = move.until;
    for (size_t i = 0; i < observation->person_count; i++) {
        if (!asked(house, observation, question, i))
            continue;
        double error = started[i] > 0 ? fabs(started[i] - house->people[i].delay) : HUGE_VAL;
        if (error < answer->value)
            continue;
        answer->value = error;
        snprintf(answer->note, sizeof answer->note, started[i] > 0 ? "%.60s starts at %.2f s" : "%.60s never starts",
                 house->people[i].id, started[i]);
    }
    memory_free(started);
}

/* The path of a person through the area: from the first position in it to the last. */
typedef struct Crossing {
    double from, until; /* s */
    double way;         /* m */
    bool seen;
} Crossing;

/* Computes the speeds (m/s) of the people across the area, or from their start to the exit without an area. Returns
 * their number; the caller frees `*speeds`. */
static size_t crossing_speeds(double **speeds, const House *house, const Observation *observation,
                              const MeasureQuestion *question) {
    Crossing *crossings = memory_zeroed(observation->person_count, sizeof *crossings);
    Move move;
    for (Walk walk = walk_begin(observation); walk_next(&walk, &move);) {
        Crossing *crossing = &crossings[move.person];
        bool counts = question->area.count ? inside(&question->area, move.a) && inside(&question->area, move.b)
                                           : move.until > house->people[move.person].delay;
        if (!counts)
            continue;
        if (!crossing->seen)
            crossing->from = move.from;
        crossing->seen = true;
        crossing->until = move.until;
        crossing->way += vec2_distance(move.a, move.b);
    }
    size_t count = 0;
    *speeds = memory_zeroed(observation->person_count, sizeof **speeds);
    for (size_t i = 0; i < observation->person_count; i++)
        if (asked(house, observation, question, i) && crossings[i].seen)
            (*speeds)[count++] = crossings[i].way / (crossings[i].until - crossings[i].from);
    memory_free(crossings);
    return count;
}

static void take_speed(MeasureAnswer *answer, const House *house, const Observation *observation,
                       const MeasureQuestion *question) {
    double *speeds;
    size_t count = crossing_speeds(&speeds, house, observation, question);
    for (size_t i = 0; i < count; i++)
        answer->value += speeds[i] / (double)count;
    memory_free(speeds);
    if (!count)
        no_value(answer, "no person crosses the area");
}

static void take_speed_deviation(MeasureAnswer *answer, const House *house, const Observation *observation,
                                 const MeasureQuestion *question) {
    double *speeds, mean = 0, squares = 0;
    size_t count = crossing_speeds(&speeds, house, observation, question);
    for (size_t i = 0; i < count; i++)
        mean += speeds[i] / (double)count;
    for (size_t i = 0; i < count; i++)
        squares += (speeds[i] - mean) * (speeds[i] - mean);
    memory_free(speeds);
    if (count < 2)
        no_value(answer, "fewer than two people cross the area");
    else
        answer->value = sqrt(squares / (double)(count - 1));
}

static void take_slowest(MeasureAnswer *answer, const House *house, const Observation *observation,
                         const MeasureQuestion *question) {
    double *speeds;
    size_t count = crossing_speeds(&speeds, house, observation, question);
    answer->value = HUGE_VAL;
    for (size_t i = 0; i < count; i++)
        answer->value = fmin(answer->value, speeds[i]);
    memory_free(speeds);
    if (!count)
        no_value(answer, "no person crosses the area");
}

static void take_fastest(MeasureAnswer *answer, const House *house, const Observation *observation,
                         const MeasureQuestion *question) {
    double *speeds;
    size_t count = crossing_speeds(&speeds, house, observation, question);
    for (size_t i = 0; i < count; i++)
        answer->value = fmax(answer->value, speeds[i]);
    memory_free(speeds);
    if (!count)
        no_value(answer, "no person crosses the area");
}

/* Returns the fraction of the path from a to b at which it passes between the line's ends; negative: it does not. */
static double passes(const Points *line, Vec2 a, Vec2 b) {
    Vec2 along = vec2_sub(line->at[1], line->at[0]), way = vec2_sub(b, a);
    double before = vec2_cross(along, vec2_sub(a, line->at[0])), after = vec2_cross(along, vec2_sub(b, line->at[0]));
    if ((before > 0) == (after > 0))
        return -1;
    double share = before / (before - after);
    double place = vec2_dot(vec2_sub(vec2_along(a, share, way), line->at[0]), along) / vec2_dot(along, along);
    return place >= 0 && place <= 1 ? share : -1;
}

/* Computes the sorted times (s) at which the people pass the exit or, for the first time, the line. */
static size_t passing_times(double **times, const House *house, const Observation *observation,
                            const MeasureQuestion *question) {
    double *passed = memory_zeroed(observation->person_count, sizeof *passed);
    size_t exit = find_exit(house, question->exit), count = 0;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        passed[i] = !question->line.count && person->completed && person->exit == exit ? person->time : -1;
    }
    Move move;
    for (Walk walk = walk_begin(observation); walk_next(&walk, &move);) {
        double share = question->line.count && passed[move.person] < 0 ? passes(&question->line, move.a, move.b) : -1;
        if (share >= 0)
            passed[move.person] = move.from + share * (move.until - move.from);
    }
    for (size_t i = 0; i < observation->person_count; i++)
        if (asked(house, observation, question, i) && passed[i] >= 0)
            passed[count++] = passed[i];
    qsort(passed, count, sizeof *passed, order_rising);
    *times = passed;
    return count;
}

static double gate_width(const House *house, const MeasureQuestion *question) {
    if (question->width > 0)
        return question->width;
    if (question->line.count)
        return vec2_distance(question->line.at[0], question->line.at[1]);
    const Exit *exit = &house->plan.exits[find_exit(house, question->exit)];
    return vec2_distance(exit->from, exit->to);
}

static void take_flow(MeasureAnswer *answer, const House *house, const Observation *observation,
                      const MeasureQuestion *question) {
    double *times;
    size_t count = passing_times(&times, house, observation, question);
    size_t a = (size_t)(question->first * (double)count), b = (size_t)(question->last * (double)count);
    if (b < a + 2 || !(times[b - 1] > times[a]))
        no_value(answer, "people who pass: only %zu", count);
    else
        answer->value = (double)(b - 1 - a) / (times[b - 1] - times[a]) / gate_width(house, question);
    memory_free(times);
}

static void take_passed(MeasureAnswer *answer, const House *house, const Observation *observation,
                        const MeasureQuestion *question) {
    double *times;
    answer->value = (double)passing_times(&times, house, observation, question);
    memory_free(times);
}

static void take_last_passing(MeasureAnswer *answer, const House *house, const Observation *observation,
                              const MeasureQuestion *question) {
    double *times;
    size_t count = passing_times(&times, house, observation, question), expected = 0;
    for (size_t i = 0; i < observation->person_count; i++)
        expected += asked(house, observation, question, i);
    if (count < expected || !count)
        no_value(answer, "%zu of %zu pass", count, expected);
    else
        answer->value = times[count - 1];
    memory_free(times);
}

/* Adds up time (person s) and distance (m) in the area within the window. Returns false, with a note, if the run is
 * shorter. */
static bool stay(double *time, double *way, MeasureAnswer *answer, const House *house, const Observation *observation,
                 const MeasureQuestion *question) {
    *time = *way = 0;
    if (!observation->completed && observation->time < question->until) {
        no_value(answer, "the run ended at %.1f s, within the measured time", observation->time);
        return false;
    }
    Move move;
    for (Walk walk = walk_begin(observation); walk_next(&walk, &move);) {
        double length = move.until - move.from;
        double within = fmin(move.until, question->until) - fmax(move.from, question->from);
        if (within <= 0 || !asked(house, observation, question, move.person) ||
            !inside(&question->area, vec2_scale(vec2_add(move.a, move.b), 0.5)))
            continue;
        *time += within;
        *way += vec2_distance(move.a, move.b) * within / length;
    }
    return true;
}

static void take_density(MeasureAnswer *answer, const House *house, const Observation *observation,
                         const MeasureQuestion *question) {
    double time, way;
    if (stay(&time, &way, answer, house, observation, question))
        answer->value = time / (question->until - question->from) / area_of(&question->area);
}

static void take_area_speed(MeasureAnswer *answer, const House *house, const Observation *observation,
                            const MeasureQuestion *question) {
    double time, way;
    if (!stay(&time, &way, answer, house, observation, question))
        return;
    if (time > 0)
        answer->value = way / time;
    else
        no_value(answer, "no person is in the area at that time");
}

/* The table ---------------------------------------------------------------------------------------------------------*/

static const Measure measures[] = {
    {"time", "s", 0, "time when the last of the people is out", take_time},
    {"mean_time", "s", 0, "mean time when the people are out", take_mean_time},
    {"out", "1", 0, "number of people who leave", take_out},
    {"out_share", "1", 0, "share of the people who leave", take_out_share},
    {"narrowest", "m", 0, "least clearance of a body, at most the reach of its space; negative: contact",
     take_narrowest},
    {"contacts", "1", 0, "number of contacts begun", take_contacts},
    {"peak_force", "N", 0, "largest contact force on a body", take_peak_force},
    {"reversals", "1", 0, "planned changes of direction", take_reversals},
    {"path_length", "m", 0, "longest path of a person", take_path_length},
    {"exit_count", "1", MEASURE_EXIT, "number of people who leave by the exit", take_exit_count},
    {"assigned_exit", "1", 0, "share of people who leave by the exit of their route", take_assigned},
    {"overtaking", "1", MEASURE_PAST, "share of pairs in which the person who starts behind leaves first",
     take_overtaking},
    {"start", "s", 0, "greatest difference between a person's start and delay", take_start},
    {"speed", "m/s", 0, "mean speed through the area, or from start to exit", take_speed},
    {"speed_deviation", "m/s", 0, "standard deviation of that speed", take_speed_deviation},
    {"slowest", "m/s", 0, "least of these speeds", take_slowest},
    {"fastest", "m/s", 0, "greatest of these speeds", take_fastest},
    {"flow", "1/(m s)", MEASURE_GATE, "people per metre and second, between the shares first and last", take_flow},
    {"passed", "1", MEASURE_GATE, "number of people who pass", take_passed},
    {"last_passing", "s", MEASURE_GATE, "time when the last person passes", take_last_passing},
    {"density", "1/m2", MEASURE_AREA | MEASURE_WINDOW, "mean number of people in the area per square metre",
     take_density},
    {"wall_crossings", "1", 0, "number of times that the middle of a body entered a wall, at any step",
     take_wall_crossings},
    {"area_speed", "m/s", MEASURE_AREA | MEASURE_WINDOW, "distance covered per time spent in the area",
     take_area_speed},
};
enum { MEASURES = sizeof measures / sizeof *measures };

const Measure *measure_table(size_t *count) {
    *count = MEASURES;
    return measures;
}

const Measure *measure_find(const char *name) {
    for (size_t m = 0; m < MEASURES; m++)
        if (strcmp(measures[m].name, name) == 0)
            return &measures[m];
    return NULL;
}
