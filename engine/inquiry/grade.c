#include "inquiry/grade.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "inquiry/grade_places.h"
#include "inquiry/grade_try.h"

/* 1: changes of direction that grade C allows. */
enum { A_FEW = 2 };

typedef struct Grading {
    const House *house;
    size_t person;
    const Stop *stop;
    double blocked_from; /* m, least growth so far that cannot pass */
    bool weak;           /* True if the body itself passes, but the driver is too weak */
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
    GradeTry tried = try_growth(grading, 0, reversals);
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

Grade grade_person(const House *house, size_t person, const Stop *stop) {
    Grade grade = {.letter = GRADE_D};
    Grading grading = {house, person, stop, HUGE_VAL, false, &grade};
    const Profile *profile = house->people[person].profile;
    int any = house->plan.run.reversals, few = any < A_FEW ? any : A_FEW;
    double easy = fmax(profile->free_speed * profile->steering_time / 2, GRADE_HANDS);
    double least = largest_growth(&grading, any, easy);
    if (grading.weak) { /* room is not what is missing */
        grade.letter = GRADE_E;
        grade.weak = true;
        grade.tightness = grade.to_next = (double)NAN;
        return grade;
    }
    grade.tightness = least;
    grade.wider = least >= easy;
    double straight = any > 0 ? largest_growth(&grading, 0, easy) : least;
    double limit = easy, has = straight, with_few = straight;
    if (straight >= easy) {
        grade.letter = GRADE_A;
    } else if (straight >= GRADE_HANDS) {
        grade.letter = GRADE_B;
    } else {
        with_few = fmax(straight, few == any ? least : largest_growth(&grading, few, GRADE_ARMS_IN));
        limit = GRADE_HANDS;
        if (with_few >= GRADE_ARMS_IN) {
            grade.letter = GRADE_C;
        } else if (least >= 0) {
            limit = GRADE_ARMS_IN;
            has = with_few;
        } else {
            grade.letter = try_growth(&grading, 0, any).fits ? GRADE_E : GRADE_F;
            limit = 0;
            has = least;
        }
    }
    grade.to_next = grade.letter == GRADE_A ? 0 : limit - has;
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
    const Stop *stop;
} GradingAll;

static void grade_one(void *context, size_t i) {
    const GradingAll *all = context;
    if (all->house->people[i].profile->driving == DRIVING_DRIVER)
        all->grades[i] = grade_person(all->house, i, all->stop);
}

bool grade_all(Grade *grades, const House *house, int jobs, const Stop *stop) {
    GradingAll all = {grades, house, stop};
    parallel_for(jobs, house->person_count, grade_one, &all);
    return !stop_requested(stop);
}

const char *grade_letter(int letter) {
    static const char *const letters[] = {"A", "B", "C", "D", "E", "F"};
    return letters[letter];
}

const char *grade_words(int letter) {
    static const char *const words[] = {"easy", "with care", "arms in", "touching likely", "helper only", "impossible"};
    return words[letter];
}
