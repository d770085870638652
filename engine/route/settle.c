#include "route/settle.h"

#include "base/memory.h"
#include "base/real.h"
#include "route/fields.h"
#include "route/recall.h"

/* The search is led by the times of a disc that is smaller than the body (field.h). Where the disc passes a gap that is
 * narrower than the body, the search is led there, and may have spent all its nodes before it turns to a longer way on
 * which there is room. So a no is not given while there is another way for the disc: the gaps on its way are barred to
 * it, and the search begins again. */

#define NARROWER 2e-3    /* m, on either side: a gap that is narrower than the body by this much is too narrow */
#define STEP 0.05        /* m, along the disc's way, and at least a cell of the field */
#define ASIDE 0.01       /* m, steps across it */
#define BESIDE 0.60      /* m, how far */
#define AT_THE_GOAL 0.05 /* s */

enum { DIRECTIONS = 16, STEPS_MOST = 20000 };

static double distance_at(const FreeSpace *space, Vec2 at, double reach) {
    Rectangle point = {0};
    return search_clearance(space, &point, at, 0, reach, NULL);
}

/* Finds the place of a gap across a way at which the obstacles are farthest. Returns that distance, m. */
static double middle_of_gap(const FreeSpace *space, Vec2 at, Vec2 across, double reach, Vec2 *middle) {
    double widest = distance_at(space, at, reach);
    *middle = at;
    for (int side = -1; side <= 1; side += 2)
        for (double aside = ASIDE; aside < BESIDE && widest < reach; aside += ASIDE) {
            Vec2 there = vec2_along(at, side * aside, across);
            double distance = distance_at(space, there, reach);
            if (distance <= 0)
                break;
            if (distance > widest) {
                widest = distance;
                *middle = there;
            }
        }
    return widest;
}

/* Returns the place at one step from another to which the field takes the least time. */
static Vec2 step_on(const Field *field, Vec2 at, double *time) {
    Vec2 best = at;
    double step = fmax(STEP, field->ground->space->cell);
    for (int d = 0; d < DIRECTIONS; d++) {
        Vec2 there = vec2_along(at, step, vec2_heading(2 * M_PI * d / DIRECTIONS));
        double then = field_time(field, there);
        if (then < *time) {
            *time = then;
            best = there;
        }
    }
    return best;
}

/* Follows the disc's way from a place, and gives the bar of the narrowest gap on it that the body cannot pass. Its
 * radius is 0 without such a gap, and below 0 without a way. */
static void find_gap(const Field *field, const FreeSpace *space, double half_width, Vec2 at, FieldBar *bar) {
    double time = field_time(field, at), least = half_width - NARROWER;
    *bar = (FieldBar){.radius = time < HUGE_VAL ? 0 : -1};
    for (int s = 0; s < STEPS_MOST && time > AT_THE_GOAL && time < HUGE_VAL; s++) {
        double before = time;
        Vec2 next = step_on(field, at, &time);
        if (!(time < before))
            break;
        Vec2 middle, across = vec2_left(vec2_unit(vec2_sub(next, at)));
        double widest =
            distance_at(space, next, least) < least ? middle_of_gap(space, next, across, least, &middle) : least;
        if (widest < least) {
            least = widest;
            *bar = (FieldBar){middle, widest + 1.5 * space->cell};
        }
        at = next;
    }
}

/* Bars the gaps that the body cannot pass on the disc's way, one after another. Returns true if there were such gaps,
 * and there is another way without any. */
static bool bar_gaps(FieldBars *bars, const RecallQuestion *question) {
    RouteQuery barred = *question->query, *query = &barred;
    barred.bars = bars;
    bool free = false, blocked = false;
    while (!free && !blocked && bars->count < FIELD_BARS_MOST) {
        FieldBar bar = {.radius = 0};
        for (size_t leg = 0; leg < question->goal_count && bar.radius == 0; leg++) {
            const Field *field = search_field(query, &question->goals[leg], question->radius);
            find_gap(field, query->space, question->body->half_width, leg ? question->goals[leg - 1].at : query->at,
                     &bar);
            fields_release(query->fields, field);
        }
        blocked = bar.radius < 0;
        free = bar.radius == 0;
        if (bar.radius > 0)
            bars->all[bars->count++] = bar;
    }
    return free && bars->count > 0;
}

/* Decides, or takes the kept answer to an equal question in another house where it still holds. */
static DecideAnswer decide(const RecallQuestion *question, SearchTrack *track, size_t *pins, FitPlace *tightest) {
    const RouteQuery *query = question->query;
    if (!query->recall)
        return decide_directly(query, question->body, question->goals, question->goal_count, question->coarsely,
                               question->depth, track, pins, tightest);
    RecallAnswer answer = {.pins = pins};
    if (recall_find(query->recall, question, &answer)) {
        search_track_clear(track);
        *track = answer.track;
        if (answer.has_tightest)
            *tightest = answer.tightest;
        return (DecideAnswer)answer.decided;
    }
    RecallWatch watch;
    recall_watch(&watch, question);
    RouteQuery watched = *query;
    watched.space = &watch.space;
    watched.watched = query->space;
    watched.times = watch.times;
    DecideAnswer decided = decide_directly(&watched, question->body, question->goals, question->goal_count,
                                           question->coarsely, question->depth, track, pins, tightest);
    answer = (RecallAnswer){.decided = (int)decided, .track = *track, .pins = pins};
    answer.has_tightest = decided == DECIDE_NONE || decided == DECIDE_TOO_NARROW;
    if (answer.has_tightest)
        answer.tightest = *tightest;
    recall_keep(query->recall, question, &watch, decided == DECIDE_INTERRUPTED ? NULL : &answer);
    return decided;
}

static DecideAnswer settle(const RecallQuestion *question, SearchTrack *track, size_t *pins, FitPlace *tightest) {
    DecideAnswer decided = decide(question, track, pins, tightest);
    FieldBars bars = {.count = 0};
    if (decided != DECIDE_NONE || !bar_gaps(&bars, question))
        return decided;
    RouteQuery round = *question->query; /* its answer hangs on more than what is noted, so that it is not kept */
    round.bars = &bars;
    FitPlace known;
    decided = decide_directly(&round, question->body, question->goals, question->goal_count, question->coarsely,
                              question->depth, track, pins, &known);
    return decided == DECIDE_TOO_NARROW ? DECIDE_NONE : decided;
}

DecideAnswer settle_way(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                        double depth, SearchTrack *track, size_t *pins, FitPlace *tightest) {
    RecallQuestion question = {query, body, goals, goal_count, decide_radius(body), depth, false};
    return settle(&question, track, pins, tightest);
}

DecideAnswer settle_quickly(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                            SearchTrack *track) {
    size_t *pins = memory_zeroed(goal_count, sizeof *pins);
    RecallQuestion question = {query, body, goals, goal_count, decide_radius(body), 0, true};
    FitPlace tightest;
    DecideAnswer answer = settle(&question, track, pins, &tightest);
    memory_free(pins);
    return answer;
}
