#include "inquiry/grade.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "inquiry/grade_places.h"
#include "inquiry/grade_try.h"

/* 1: changes of direction that grade C allows. */
enum { A_FEW = 2 };

static int few_of(int any) {
    return any < A_FEW ? any : A_FEW;
}

/* Returns the clearance that costs no speed, m: the limit of grade A. */
static double easy_for(const Profile *profile) {
    return fmax(profile->free_speed * profile->steering_time / 2, GRADE_HANDS);
}

typedef struct Grading {
    const House *house;
    size_t person;
    const Stop *stop;
    double blocked_from; /* m, least growth so far that cannot pass */
    bool weak;           /* True if the body itself passes, but the driver is too weak */
    GradeTry own;        /* of the body as it is, with as many changes of direction as the house allows */
    Grade *grade;
} Grading;

static void note_blockage(Grading *grading, double growth, const Blockage *blockage) {
    if (growth >= grading->blocked_from)
        return;
    grading->blocked_from = growth;
    grading->grade->has_place = true;
    grading->grade->at = blockage->at;
    memcpy(grading->grade->what, blockage->what, sizeof grading->grade->what);
}

static GradeTry try_growth(Grading *grading, double growth, int reversals) {
    GradeTry tried = grade_try_growth(grading->house, grading->person, growth, reversals, grading->stop);
    if (tried.blocked)
        note_blockage(grading, growth, &tried.blockage);
    if (tried.weak && growth == 0) {
        note_blockage(grading, 0, &tried.blockage);
        grading->weak = true;
    }
    return tried;
}

/* Returns the largest growth up to `most` with which there is a way, m; NAN: none from -GRADE_DEEPEST on. It is below 0
 * where there is none for the body itself, even if the way of a smaller one would have room for it: a grade and the
 * answer without one agree. */
static double largest_growth(Grading *grading, int reversals, double most) {
    bool same = reversals == grading->house->plan.run.reversals;
    GradeTry tried = same ? grading->own : try_growth(grading, 0, reversals);
    double low = tried.found ? tried.holds : -GRADE_DEEPEST, high = tried.found ? most : -GRADE_RESOLUTION;
    if (grading->weak)
        return (double)NAN;
    if (!tried.found) {
        tried = try_growth(grading, low, reversals);
        if (!tried.found)
            return (double)NAN;
        low = fmin(tried.holds, high);
    } else if (low < most && try_growth(grading, most, reversals).found) {
        return most;
    }
    while (high - low > GRADE_RESOLUTION && !stop_requested(grading->stop)) {
        double middle = (low + high) / 2;
        tried = try_growth(grading, middle, reversals);
        if (tried.found)
            low = fmin(fmax(tried.holds, middle), high);
        else
            high = middle;
    }
    return fmin(low, most);
}

/* True if there is a way for a body that is so much larger, but for the resolution: if the way `known` has room for it,
 * or by a try, which `known` then is. */
static bool has_room(Grading *grading, GradeTry *known, double growth, int reversals) {
    if (known->holds >= growth && known->reversals <= reversals)
        return true;
    GradeTry tried = try_growth(grading, growth - GRADE_RESOLUTION, reversals);
    if (tried.found)
        *known = tried;
    return tried.found;
}

/* Finds the letter, and what stands in the way of the next one. Stops at `enough`: a letter that is not worse may be
 * found to be any up to that one. */
static void find_letter(Grading *grading, int enough) {
    Grade *grade = grading->grade;
    const House *house = grading->house;
    int any = house->plan.run.reversals;
    GradeTry known = grading->own = try_growth(grading, 0, any);
    if (!known.found)
        grade->letter = known.weak || known.fits ? GRADE_E : GRADE_F;
    else if (enough < GRADE_D && !has_room(grading, &known, GRADE_ARMS_IN, few_of(any)))
        grade->letter = GRADE_D;
    else if (enough < GRADE_C && !has_room(grading, &known, GRADE_HANDS, 0))
        grade->letter = GRADE_C;
    else if (enough < GRADE_B && !has_room(grading, &known, easy_for(house->people[grading->person].profile), 0))
        grade->letter = GRADE_B;
    else
        grade->letter = GRADE_A;
    grade->weak = grading->weak;
}

static Grade letter_of(const House *house, size_t person, int enough, const Stop *stop) {
    Grade grade = {.tightness = (double)NAN, .to_next = (double)NAN};
    find_letter(&(Grading){.house = house, .person = person, .stop = stop, .blocked_from = HUGE_VAL, .grade = &grade},
                enough);
    return stop_requested(stop) ? (Grade){.interrupted = true} : grade;
}

Grade grade_person_letter(const House *house, size_t person, const Stop *stop) {
    return letter_of(house, person, GRADE_A, stop);
}

Grade grade_person(const House *house, size_t person, const Stop *stop) {
    Grade grade = {.tightness = (double)NAN, .to_next = (double)NAN};
    Grading grading = {.house = house, .person = person, .stop = stop, .blocked_from = HUGE_VAL, .grade = &grade};
    int any = house->plan.run.reversals, few = few_of(any);
    double easy = easy_for(house->people[person].profile);
    find_letter(&grading, GRADE_A);
    if (grade.weak) /* room is not what is missing */
        return grade;
    double least = largest_growth(&grading, any, easy);
    grade.tightness = least;
    grade.wider = least >= easy;
    double straight = any > 0 ? largest_growth(&grading, 0, easy) : least, with_few = straight;
    if (grade.letter > GRADE_B)
        with_few = fmax(straight, few == any ? least : largest_growth(&grading, few, GRADE_ARMS_IN));
    const double limits[] = {[GRADE_B] = easy, [GRADE_C] = GRADE_HANDS, [GRADE_D] = GRADE_ARMS_IN, [GRADE_E] = 0};
    double has = straight;
    int before = grade.letter > GRADE_E ? GRADE_E : grade.letter;
    if (before == GRADE_D)
        has = with_few = fmin(with_few, GRADE_ARMS_IN - GRADE_RESOLUTION);
    else if (before == GRADE_E)
        has = least;
    else if (before > GRADE_A)
        has = straight = fmin(straight, limits[before] - GRADE_RESOLUTION);
    grade.to_next = grade.letter == GRADE_A ? 0 : limits[before] - has;
    const GradeLevel better[] = {{GRADE_A, easy, 0, straight},
                                 {GRADE_B, GRADE_HANDS, 0, straight},
                                 {GRADE_C, GRADE_ARMS_IN, few, with_few},
                                 {GRADE_D, 0, any, least}};
    GradeLevel levels[sizeof better / sizeof *better];
    size_t count = 0;
    for (int letter = grade.letter > GRADE_D ? GRADE_D : grade.letter - 1; letter >= GRADE_A; letter--)
        levels[count++] = better[letter];
    grade_places_find(&grade, house, person, levels, count, stop);
    if (grade.place_count) {
        grade.has_place = true;
        grade.at = grade.places[0].at;
        memcpy(grade.what, grade.places[0].what, sizeof grade.what);
    }
    if (stop_requested(stop))
        grade = (Grade){.interrupted = true};
    return grade;
}

typedef struct GradingAll {
    Grade *grades; /* (person_count) */
    const House *house;
    const bool *part; /* (person_count) */
    const Stop *stop;
} GradingAll;

static bool is_driven(const House *house, size_t person) {
    return house->people[person].profile->driving == DRIVING_DRIVER;
}

static void grade_one(void *context, size_t i) {
    const GradingAll *all = context;
    if (is_driven(all->house, i))
        all->grades[i] = grade_person(all->house, i, all->stop);
}

bool grade_all(Grade *grades, const House *house, int jobs, const Stop *stop) {
    GradingAll all = {grades, house, NULL, stop};
    parallel_for(jobs, house->person_count, grade_one, &all);
    return !stop_requested(stop);
}

static void letter_one(void *context, size_t i) {
    const GradingAll *all = context;
    bool asked = is_driven(all->house, i) && all->part[i];
    all->grades[i] = asked ? grade_person_letter(all->house, i, all->stop) : (Grade){.interrupted = true};
}

bool grade_all_letters(Grade *grades, const House *house, const bool *part, int jobs, const Stop *stop) {
    GradingAll all = {grades, house, part, stop};
    parallel_for(jobs, house->person_count, letter_one, &all);
    return !stop_requested(stop);
}

static bool is_answered(const Observation *observation, size_t few) {
    size_t people = 0;
    for (size_t i = 0; i < observation->person_count; i++)
        people += observation->people[i].took_part;
    return observation->completed && people <= few;
}

bool grade_answer(Grade **grades, const House *house, const Observation *observation, size_t few, int jobs,
                  const Stop *stop) {
    *grades = NULL;
    if (!is_answered(observation, few))
        return true;
    bool *out = memory_zeroed(house->person_count, sizeof *out);
    for (size_t i = 0; i < house->person_count; i++)
        out[i] = observation->people[i].completed;
    *grades = memory_zeroed(house->person_count, sizeof **grades);
    bool whole = grade_all_letters(*grades, house, out, jobs, stop);
    memory_free(out);
    if (whole)
        return true;
    memory_free(*grades);
    *grades = NULL;
    return false;
}

bool grade_answer_worst(Grade *worst, const House *house, const Observation *observation, size_t few,
                        const Stop *stop) {
    *worst = (Grade){.interrupted = true};
    size_t asked = is_answered(observation, few) ? house->person_count : 0;
    for (size_t i = 0; i < asked; i++) {
        if (!is_driven(house, i) || !observation->people[i].completed)
            continue;
        Grade grade = letter_of(house, i, worst->interrupted ? GRADE_A : worst->letter, stop);
        if (grade.interrupted)
            return false;
        if (worst->interrupted || grade.letter > worst->letter)
            *worst = grade;
    }
    return true;
}

size_t grade_worst(const House *house, const Grade *grades) {
    size_t worst = SIZE_MAX;
    for (size_t i = 0; i < house->person_count; i++)
        if (is_driven(house, i) && !grades[i].interrupted &&
            (worst == SIZE_MAX || grades[i].letter > grades[worst].letter))
            worst = i;
    return worst;
}

const char *const *grade_letters(void) {
    static const char *const letters[GRADES] = {"A", "B", "C", "D", "E", "F"};
    return letters;
}

const char *grade_letter(int letter) {
    return grade_letters()[letter];
}

const char *grade_words(int letter) {
    static const char *const words[] = {"easy", "with care", "arms in", "touching likely", "helper only", "impossible"};
    return words[letter];
}
