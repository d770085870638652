#include "inquiry/grade_places.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "inquiry/grade_try.h"
#include "inquiry/suggest_change.h"
#include "plan/plan_geometry.h"
#include "space/outline.h"

/* m: two blockages nearer to each other than this are one place; what is at most this far from one may be eased for it,
 * such as the door beside a corner. */
static const double SAME_PLACE = 0.5, NEARBY = 1.2;
/* m: steps of changes, the widest door, the farthest move. */
static const double STEP = 0.01, WIDEST = 1.5, FARTHEST = 0.6, LITTLE = 0.05;

enum { CANDIDATES_MOST = 3 };

/* A door or a piece that may be eased. */
typedef struct Candidate {
    bool is_door;
    size_t index;
    double away; /* m, from the place */
} Candidate;

typedef struct Listing {
    const House *house;
    size_t person;
    const Stop *stop;
    Grade *grade;
    Candidate eased[GRADE_PLACES_MOST]; /* (grade->place_count) of each place */
} Listing;

/* Changed houses ---------------------------------------------------------------------------------------------------*/

/* Returns a house with its own doors, furniture and space; the rest is shared. free_changed releases it. */
static House copy_house(const House *house) {
    House copy = *house;
    const Plan *plan = &house->plan;
    copy.plan.doors = memory_zeroed(plan->door_count + 1, sizeof *copy.plan.doors);
    copy.plan.furniture = memory_zeroed(plan->furniture_count + 1, sizeof *copy.plan.furniture);
    if (plan->door_count)
        memcpy(copy.plan.doors, plan->doors, plan->door_count * sizeof *plan->doors);
    if (plan->furniture_count)
        memcpy(copy.plan.furniture, plan->furniture, plan->furniture_count * sizeof *plan->furniture);
    copy.outline = (Outline){0};
    copy.space = (FreeSpace){0};
    return copy;
}

static bool build(House *copy) {
    Fault fault = {0};
    bool built = outline_build(&copy->outline, &copy->plan, &fault);
    fault_clear(&fault);
    if (built)
        freespace_build(&copy->space, &copy->outline, copy->plan.run.cell);
    return built;
}

static void free_copy(House *copy) {
    freespace_free(&copy->space);
    outline_free(&copy->outline);
    memory_free(copy->plan.doors);
    memory_free(copy->plan.furniture);
}

/* Applies a change of a door or a piece to a copy; CHANGE_AWAY leaves a trace of the piece inside a wall, so that the
 * indices of the others stay. */
static void apply(House *copy, const Change *change) {
    if (change->kind == CHANGE_WIDEN) {
        copy->plan.doors[change->index].width = change->width;
        copy->plan.doors[change->index].at = change->at;
        return;
    }
    Furniture *piece = &copy->plan.furniture[change->index];
    piece->centre = vec2_add(piece->centre, change->by);
    if (change->kind != CHANGE_AWAY)
        return;
    piece->centre = copy->plan.walls[0].points.at[0];
    piece->size = vec2(0.01, 0.01);
    piece->toppled = false;
}

static double widest_of(const Plan *plan, size_t door) {
    double low, high;
    suggest_change_room(plan, door, &low, &high);
    return STEP * floor(fmin(high - low, WIDEST) / STEP + 1e-6);
}

/* Returns the change of a candidate that eases most. */
static Change easing(const Plan *plan, const Candidate *candidate) {
    if (candidate->is_door)
        return suggest_change_widen(plan, candidate->index, widest_of(plan, candidate->index));
    return (Change){.kind = CHANGE_AWAY, .index = candidate->index};
}

/* Tries a level with all known places eased except `without` (SIZE_MAX: none), and with one more change (NULL: none).
 */
static GradeTry try_eased(const Listing *listing, const GradeLevel *level, double growth, size_t without,
                          const Change *more) {
    House copy = copy_house(listing->house);
    for (size_t p = 0; p < listing->grade->place_count; p++) {
        Change change = easing(&listing->house->plan, &listing->eased[p]);
        if (p != without)
            apply(&copy, &change);
    }
    if (more)
        apply(&copy, more);
    GradeTry tried = {0};
    if (build(&copy))
        tried = grade_try_growth(&copy, listing->person, growth, level->reversals, listing->stop);
    free_copy(&copy);
    return tried;
}

/* Candidates -------------------------------------------------------------------------------------------------------*/

static bool is_eased(const Listing *listing, bool is_door, size_t index) {
    for (size_t p = 0; p < listing->grade->place_count; p++)
        if (listing->eased[p].is_door == is_door && listing->eased[p].index == index)
            return true;
    return false;
}

/* Adds a candidate in order of distance; a full list drops the farthest. */
static size_t add_candidate(Candidate *list, size_t count, Candidate candidate) {
    size_t i = count < CANDIDATES_MOST ? count : CANDIDATES_MOST - 1;
    if (count == CANDIDATES_MOST && list[i].away <= candidate.away)
        return count;
    for (; i > 0 && list[i - 1].away > candidate.away; i--)
        list[i] = list[i - 1];
    list[i] = candidate;
    return count < CANDIDATES_MOST ? count + 1 : count;
}

/* Returns the distance from a place to a thing, m; 0 for what the blockage names. */
static double away_of(const Plan *plan, bool is_door, size_t index, const Blockage *blockage) {
    char name[sizeof blockage->what];
    outline_name(plan, is_door ? OWNER_DOOR : OWNER_FURNITURE, (int)index, name, sizeof name);
    if (strcmp(name, blockage->what) == 0)
        return 0;
    Vec2 at = blockage->at, corners[4];
    if (is_door) {
        plan_geometry_door_ends(plan, &plan->doors[index], &corners[0], &corners[1]);
        return vec2_distance(at, vec2_nearest_on_segment(at, corners[0], corners[1]));
    }
    double least = HUGE_VAL;
    plan_geometry_corners(&plan->furniture[index], corners);
    for (int c = 0; c < 4; c++)
        least = fmin(least, vec2_distance(at, vec2_nearest_on_segment(at, corners[c], corners[(c + 1) % 4])));
    return least;
}

static size_t list_candidates(const Listing *listing, const Blockage *blockage, Candidate *list) {
    const Plan *plan = &listing->house->plan;
    size_t count = 0;
    for (int kind = 0; kind < 2; kind++) {
        bool is_door = kind == 0;
        size_t things = is_door ? plan->door_count : plan->wall_count ? plan->furniture_count : 0;
        for (size_t i = 0; i < things; i++) {
            double away = away_of(plan, is_door, i, blockage);
            bool fixed = is_door &&
                         (plan->doors[i].state == DOOR_LOCKED || widest_of(plan, i) <= plan->doors[i].width + STEP / 2);
            if (away <= NEARBY && !fixed && !is_eased(listing, is_door, i))
                count = add_candidate(list, count, (Candidate){is_door, i, away});
        }
    }
    return count;
}

/* Places -----------------------------------------------------------------------------------------------------------*/

/* Finds what can be eased for a place: afterwards the body passes, or blocks elsewhere. Sets `*tried` to what it then
 * finds. Returns false if nothing helps. */
static bool ease(const Listing *listing, const GradeLevel *level, GradeTry *tried, Candidate *best) {
    Candidate list[CANDIDATES_MOST];
    Blockage here = tried->blockage;
    size_t count = list_candidates(listing, &here, list);
    for (size_t c = 0; c < count && !stop_requested(listing->stop); c++) {
        Change change = easing(&listing->house->plan, &list[c]);
        GradeTry after = try_eased(listing, level, level->growth, SIZE_MAX, &change);
        if (after.found || (after.blocked && vec2_distance(after.blockage.at, here.at) > SAME_PLACE)) {
            *tried = after;
            *best = list[c];
            return true;
        }
    }
    return false;
}

static void add_place(Listing *listing, const Blockage *blockage, Candidate eased, int letter) {
    Grade *grade = listing->grade;
    listing->eased[grade->place_count] = eased;
    GradePlace *place = &grade->places[grade->place_count++];
    *place = (GradePlace){.letter = letter, .to_next = (double)NAN, .at = blockage->at};
    memcpy(place->what, blockage->what, sizeof place->what);
}

/* Finds how much room a place has with all others eased, m less than the level asks for: all that the way has where no
 * other place blocks the level. */
static double find_missing(const Listing *listing, const GradeLevel *level, size_t p, bool only) {
    if (!isfinite(level->has))
        return (double)NAN;
    if (only)
        return level->growth - level->has;
    double low = fmin(level->has, level->growth), high = level->growth;
    while (high - low > GRADE_RESOLUTION && !stop_requested(listing->stop)) {
        double middle = (low + high) / 2;
        GradeTry tried = try_eased(listing, level, middle, p, NULL);
        if (tried.found)
            low = fmin(fmax(tried.holds, middle), high);
        else
            high = middle;
    }
    return level->growth - low;
}

/* Returns the direction in which a piece makes most room: along one of its sides, away from the place, and where it can
 * be moved at all. */
static double direction_of(const Plan *plan, size_t index, Vec2 at) {
    const Furniture *piece = &plan->furniture[index];
    Vec2 away = vec2_sub(piece->centre, at);
    double best = 0, most = -HUGE_VAL;
    for (int q = 0; q < 4; q++) {
        double direction = radians(piece->angle) + q * M_PI_2;
        double size = q % 2 ? piece->size.y : piece->size.x;
        double ahead = vec2_dot(away, vec2_heading(direction)) - size / 2;
        Change little = suggest_change_move(index, LITTLE, direction);
        if (ahead > most && suggest_change_stands_free(plan, &little)) {
            most = ahead;
            best = direction;
        }
    }
    return best;
}

static Change change_of(const Plan *plan, const Candidate *candidate, Vec2 at, int steps) {
    if (!candidate->is_door)
        return suggest_change_move(candidate->index, steps * STEP, direction_of(plan, candidate->index, at));
    double first = STEP * floor(plan->doors[candidate->index].width / STEP + 1e-6);
    return suggest_change_widen(plan, candidate->index, first + steps * STEP);
}

/* True if the change is possible and lets the body of the level pass. */
static bool suffices(const Listing *listing, const GradeLevel *level, size_t p, int steps) {
    const Plan *plan = &listing->house->plan;
    Change change = change_of(plan, &listing->eased[p], listing->grade->places[p].at, steps);
    if (change.kind != CHANGE_WIDEN && !suggest_change_stands_free(plan, &change))
        return false;
    return try_eased(listing, level, level->growth, p, &change).found;
}

/* Finds the least change of a place that buys the level. */
static void find_change(const Listing *listing, const GradeLevel *level, size_t p) {
    const Plan *plan = &listing->house->plan;
    const Candidate *candidate = &listing->eased[p];
    GradePlace *place = &listing->grade->places[p];
    double most =
        candidate->is_door ? widest_of(plan, candidate->index) - plan->doors[candidate->index].width : FARTHEST;
    int low = 0, high = (int)floor(most / STEP + 1e-6), longest = high;
    /* Small steps first: most places lack a few centimetres. */
    for (int steps = 4; steps < longest && high == longest; steps *= 2) {
        if (suffices(listing, level, p, steps))
            high = steps;
        else
            low = steps;
    }
    if (high == longest && (longest <= 0 || !suffices(listing, level, p, longest)))
        high = 0; /* no move in that direction is enough: the piece must go */
    while (high - low > 1 && !stop_requested(listing->stop)) {
        int middle = (low + high) / 2;
        if (suffices(listing, level, p, middle))
            high = middle;
        else
            low = middle;
    }
    if (!high && candidate->is_door)
        return;
    Change change = high ? change_of(plan, candidate, place->at, high) : easing(plan, candidate);
    Arena arena = {0};
    place->changes = true;
    place->by = suggest_change_size(plan, &change);
    if (candidate->is_door)
        snprintf(place->change, sizeof place->change, "widen door %.60s by %.3g cm to %.2f m",
                 plan->doors[candidate->index].id, 100 * place->by, change.width);
    else
        snprintf(place->change, sizeof place->change, "%s", suggest_change_words(plan, &change, &arena));
    arena_clear(&arena);
}

/* Lists the places that block a level. Returns false if the body does not pass with all of them eased. */
static bool list_level(Listing *listing, const GradeLevel *level, int letter) {
    Grade *grade = listing->grade;
    size_t first = grade->place_count;
    GradeTry tried = try_eased(listing, level, level->growth, SIZE_MAX, NULL);
    while (!tried.found && tried.blocked && grade->place_count < GRADE_PLACES_MOST) {
        Blockage blockage = tried.blockage;
        Candidate eased;
        if (!ease(listing, level, &tried, &eased)) {
            add_place(listing, &blockage, (Candidate){0}, letter);
            break;
        }
        add_place(listing, &blockage, eased, letter);
    }
    for (size_t p = first; tried.found && p < grade->place_count && !stop_requested(listing->stop); p++) {
        grade->places[p].to_next = find_missing(listing, level, p, grade->place_count == 1);
        find_change(listing, level, p);
    }
    return tried.found;
}

void grade_places_find(Grade *grade, const House *house, size_t person, const GradeLevel *levels, size_t count,
                       const Stop *stop) {
    Listing listing = {.house = house, .person = person, .stop = stop, .grade = grade};
    int letter = grade->letter;
    for (size_t l = 0; l < count && !stop_requested(stop); l++) {
        size_t before = grade->place_count;
        bool passes = list_level(&listing, &levels[l], letter);
        if (l == 0 && grade->place_count > before && !isfinite(grade->places[before].to_next))
            grade->places[before].to_next = grade->to_next;
        if (!passes)
            return;
        letter = levels[l].letter;
    }
}
