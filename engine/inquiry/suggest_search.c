#include "inquiry/suggest_search.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "base/stop.h"
#include "house/journey.h"
#include "house/run.h"

#define STEP 0.01    /* m, of suggestions */
#define ON_STEP 1e-6 /* of a step: keeps whole numbers of steps whole */

enum {
    DIRECTIONS = 16,   /* in which a piece is moved */
    LADDERS_MOST = 16, /* tried at the same time */
};

/* Radii of the rings on which a piece is tried, in steps. */
static const int rings[] = {5, 10, 15, 20, 30, 40, 60, 80, 120};
enum { RINGS = sizeof rings / sizeof *rings };

/* Trying ----------------------------------------------------------------------------------------------------------- */

typedef struct Batch {
    Search *search;
    Attempt *attempts;
} Batch;

bool suggest_search_open(const SuggestTask *task, House *house, const HouseOptions *options, Fault *fault) {
    if (task->text)
        return house_read_text(house, task->path, task->text, options, fault);
    return house_read(house, task->path, options, fault);
}

bool suggest_search_read(const Search *search, const Attempt *attempt, House *house) {
    HouseOptions options = *search->task->options;
    Arena arena = {0};
    const char **settings =
        memory_zeroed(options.setting_count + attempt->count * CHANGE_SETTINGS_MOST, sizeof *settings);
    for (size_t i = 0; i < options.setting_count; i++)
        settings[i] = options.settings[i];
    for (size_t i = 0; i < attempt->count; i++)
        options.setting_count += suggest_change_settings(&search->base->plan, &attempt->changes[i],
                                                         settings + options.setting_count, &arena);
    options.settings = settings;
    Fault fault = {0};
    bool good = suggest_search_open(search->task, house, &options, &fault);
    fault_clear(&fault);
    memory_free(settings);
    arena_clear(&arena);
    return good;
}

static void tell_progress(Search *search) {
    const SuggestTask *task = search->task;
    pthread_mutex_lock(&search->lock);
    search->reported++;
    if (task->progress)
        task->progress(task->context, search->reported);
    pthread_mutex_unlock(&search->lock);
}

static void try_one(void *context, size_t index) {
    Batch *batch = context;
    Search *search = batch->search;
    const Stop *stop = search->task->stop;
    Attempt *attempt = &batch->attempts[index];
    House house = {0};
    attempt->good = false;
    if (stop_requested(stop) || !suggest_search_read(search, attempt, &house))
        return;
    attempt->good = journey_possible(&house, search->stuck, stop) == JOURNEY_POSSIBLE;
    if (attempt->good && !(attempt->planned_only && search->by_plan)) {
        Observation observation;
        run_house(&observation, &house, &(RunOptions){.route = SIZE_MAX, .jobs = 1, .stop = stop});
        attempt->good = observation.completed;
        attempt->time = observation.time;
        observation_free(&observation);
    }
    house_free(&house);
    tell_progress(search);
}

bool suggest_search_try(Search *search, Attempt *attempts, size_t count) {
    if (search->tries + count > search->most)
        search->exhausted = true;
    if (search->exhausted || stop_requested(search->task->stop))
        return false;
    search->tries += count;
    Batch batch = {search, attempts};
    parallel_for(search->task->jobs, count, try_one, &batch);
    return !stop_requested(search->task->stop);
}

/* Returns the changes (count) and one more, in the search's arena. */
static const Change *with_one(Search *search, const Change *changes, size_t count, Change one) {
    Change *all = arena_allocate(&search->arena, (count + 1) * sizeof *all);
    if (count)
        memcpy(all, changes, count * sizeof *all);
    all[count] = one;
    return all;
}

/* Ladders: how small a change can be ------------------------------------------------------------------------------- */

/* A door, or a piece in one direction: step `low` is not sufficient, step `high` is. */
typedef struct Ladder {
    const Change *element;
    double direction; /* rad, direction of a piece */
    int low, high;
    double time; /* s, on step `high` */
} Ladder;

static double first_width(const Plan *plan, size_t door) {
    return STEP * floor(plan->doors[door].width / STEP + ON_STEP);
}

static Change on_step(const Search *search, const Ladder *ladder, int step) {
    const Plan *plan = &search->base->plan;
    size_t index = ladder->element->index;
    if (ladder->element->kind == CHANGE_WIDEN)
        return suggest_change_widen(plan, index, STEP * round(first_width(plan, index) / STEP + step));
    return suggest_change_move(index, STEP * step, ladder->direction);
}

static bool can_be(const Search *search, const Change *change) {
    return change->kind == CHANGE_WIDEN || suggest_change_stands_free(&search->base->plan, change);
}

/* Tries each ladder (count) on its step; fills in `good` and the ladders' times. Returns false if they were not tried.
 */
static bool climb(Search *search, const Change *others, size_t other_count, Ladder *ladders, size_t count,
                  const int *steps, bool *good) {
    Attempt attempts[LADDERS_MOST];
    size_t whose[LADDERS_MOST], used = 0;
    for (size_t l = 0; l < count; l++) {
        Change change = on_step(search, &ladders[l], steps[l]);
        good[l] = false;
        if (steps[l] <= 0 || !can_be(search, &change))
            continue;
        whose[used] = l;
        attempts[used++] =
            (Attempt){.changes = with_one(search, others, other_count, change), .count = other_count + 1};
    }
    if (!suggest_search_try(search, attempts, used))
        return false;
    for (size_t a = 0; a < used; a++) {
        good[whose[a]] = attempts[a].good;
        if (attempts[a].good)
            ladders[whose[a]].time = attempts[a].time;
    }
    return true;
}

/* Bisects all ladders (count) together. Returns false if stopped before the end. */
static bool bisect(Search *search, const Change *others, size_t other_count, Ladder *ladders, size_t count) {
    int steps[LADDERS_MOST];
    bool good[LADDERS_MOST], open = true;
    while (open) {
        open = false;
        for (size_t l = 0; l < count; l++) {
            bool here = ladders[l].high - ladders[l].low > 1;
            steps[l] = here ? (ladders[l].low + ladders[l].high) / 2 : 0;
            open |= here;
        }
        if (open && !climb(search, others, other_count, ladders, count, steps, good))
            return false;
        for (size_t l = 0; l < count && open; l++) {
            if (steps[l] && good[l])
                ladders[l].high = steps[l];
            else if (steps[l])
                ladders[l].low = steps[l];
        }
    }
    return true;
}

/* Doors ------------------------------------------------------------------------------------------------------------ */

bool suggest_search_widest(const Plan *plan, size_t door, Change *widest) {
    double low, high;
    suggest_change_room(plan, door, &low, &high);
    double width = STEP * floor(fmin(high - low, SUGGEST_SEARCH_WIDEST) / STEP + ON_STEP);
    *widest = suggest_change_widen(plan, door, width);
    return width > plan->doors[door].width + STEP * ON_STEP;
}

static size_t widen(Search *search, const Change *others, size_t other_count, const Change *element, Variant *variant) {
    int steps = (int)lround((element->width - first_width(&search->base->plan, element->index)) / STEP);
    Ladder ladder = {.element = element, .high = steps};
    bool good;
    if (!climb(search, others, other_count, &ladder, 1, &steps, &good) || !good ||
        !bisect(search, others, other_count, &ladder, 1))
        return 0;
    *variant = (Variant){on_step(search, &ladder, ladder.high), ladder.time};
    return 1;
}

/* Furniture -------------------------------------------------------------------------------------------------------- */

/* Finds the ladders of the sufficient directions on the first ring that has any. */
static size_t find_ring(Search *search, const Change *others, size_t other_count, const Change *element,
                        Ladder ladders[DIRECTIONS]) {
    double own = radians(search->base->plan.furniture[element->index].angle);
    for (int r = 0; r < RINGS; r++) {
        int steps[DIRECTIONS];
        bool good[DIRECTIONS];
        size_t found = 0;
        for (int d = 0; d < DIRECTIONS; d++) {
            ladders[d] = (Ladder){element, own + 2 * M_PI * d / DIRECTIONS, r ? rings[r - 1] : 0, rings[r], 0};
            steps[d] = rings[r];
        }
        if (!climb(search, others, other_count, ladders, DIRECTIONS, steps, good))
            return 0;
        for (int d = 0; d < DIRECTIONS; d++)
            if (good[d])
                ladders[found++] = ladders[d];
        if (found)
            return found;
    }
    return 0;
}

static size_t move(Search *search, const Change *others, size_t other_count, const Change *element, Variant *variant) {
    Ladder ladders[DIRECTIONS];
    size_t count = find_ring(search, others, other_count, element, ladders), best = 0;
    if (!count || !bisect(search, others, other_count, ladders, count))
        return 0;
    for (size_t l = 1; l < count; l++)
        if (ladders[l].high < ladders[best].high)
            best = l;
    *variant = (Variant){on_step(search, &ladders[best], ladders[best].high), ladders[best].time};
    return 1;
}

/* Tries turns by a quarter in both directions, by a half if the piece lies, and standing up. */
static size_t turn_and_raise(Search *search, const Change *others, size_t other_count, const Change *element,
                             Variant *variants) {
    const Plan *plan = &search->base->plan;
    bool lies = plan->furniture[element->index].toppled;
    const Change all[] = {{.kind = CHANGE_TURN, .index = element->index, .angle = 90},
                          {.kind = CHANGE_RAISE, .index = element->index},
                          {.kind = CHANGE_TURN, .index = element->index, .angle = -90},
                          {.kind = CHANGE_TURN, .index = element->index, .angle = 180}};
    Attempt attempts[sizeof all / sizeof *all];
    size_t count = 0, found = 0;
    for (size_t i = 0; i < (lies ? sizeof all / sizeof *all : 1); i++)
        if (all[i].kind == CHANGE_RAISE || suggest_change_stands_free(plan, &all[i]))
            attempts[count++] =
                (Attempt){.changes = with_one(search, others, other_count, all[i]), .count = other_count + 1};
    if (!suggest_search_try(search, attempts, count))
        return 0;
    for (size_t a = 0; a < count; a++)
        if (attempts[a].good)
            variants[found++] = (Variant){attempts[a].changes[other_count], attempts[a].time};
    return found;
}

size_t suggest_search_variants(Search *search, const Change *others, size_t count, const Change *element,
                               Variant variants[VARIANTS_MOST]) {
    if (element->kind == CHANGE_WIDEN)
        return widen(search, others, count, element, variants);
    size_t found = turn_and_raise(search, others, count, element, variants);
    return found + move(search, others, count, element, variants + found);
}
