#include "inquiry/grade.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "house/journey.h"

/* 1: a body that is grown by 1 all round reaches sqrt(2) at its corners. */
#define CORNER M_SQRT1_2

/* 1: changes of direction that grade C allows. */
enum { A_FEW = 2 };

typedef struct Grading {
    const House *house;
    size_t person;
    const Stop *stop;
    double blocked_from; /* m, least growth so far that cannot pass */
    Grade *grade;
} Grading;

/* What a body that is grown finds. */
typedef struct Tried {
    bool found, fits;
    double holds; /* m, growth that this way has room for, at least */
} Tried;

static void note_blockage(Grading *grading, double growth, const Blockage *blockage) {
    if (growth >= grading->blocked_from || !*blockage->what)
        return;
    grading->blocked_from = growth;
    grading->grade->has_place = true;
    grading->grade->at = blockage->at;
    memcpy(grading->grade->what, blockage->what, sizeof grading->grade->what);
}

/* Plans with the body grown by `growth` all round; the axle stays where it is. */
static Tried try_growth(Grading *grading, double growth, int reversals) {
    const House *house = grading->house;
    size_t i = grading->person;
    const Inhabitant *person = &house->people[i];
    House grown = *house;
    Profile body = *person->profile;
    body.width += 2 * growth;
    body.length += 2 * growth;
    body.axle += growth;
    grown.plan.run.reversals = reversals;
    grown.people = memory_zeroed(house->person_count, sizeof *grown.people);
    memcpy(grown.people, house->people, house->person_count * sizeof *grown.people);
    grown.people[i].profile = &body;
    bool *part = memory_zeroed(house->person_count, sizeof *part);
    part[i] = true;
    Journeys journeys = journey_plan_briefly(&grown, part, 1, grading->stop);
    const Route *route = &journeys.of[i].route;
    Tried tried = {route->answer == ROUTE_FOUND, route->fits, growth + fmax(route->narrowest, 0) * CORNER};
    if (route->answer == ROUTE_CANNOT_PASS)
        note_blockage(grading, growth, &route->blockage);
    journey_free_all(&journeys);
    memory_free(part);
    memory_free(grown.people);
    return tried;
}

/* Returns the largest growth up to `most` with which there is a way, m; NAN: none from -GRADE_DEEPEST on. */
static double largest_growth(Grading *grading, int reversals, double most) {
    Tried tried = try_growth(grading, 0, reversals);
    double low = tried.found ? tried.holds : -GRADE_DEEPEST, high = tried.found ? most : 0;
    if (!tried.found) {
        tried = try_growth(grading, low, reversals);
        if (!tried.found)
            return (double)NAN;
        low = tried.holds;
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
    Grading grading = {house, person, stop, HUGE_VAL, &grade};
    const Profile *profile = house->people[person].profile;
    int any = house->plan.run.reversals, few = any < A_FEW ? any : A_FEW;
    double easy = fmax(profile->free_speed * profile->steering_time / 2, GRADE_HANDS);
    double least = largest_growth(&grading, any, easy);
    grade.tightness = least;
    grade.wider = least >= easy;
    double straight = any > 0 ? largest_growth(&grading, 0, easy) : least;
    double limit = easy, has = straight;
    if (straight >= easy) {
        grade.letter = GRADE_A;
    } else if (straight >= GRADE_HANDS) {
        grade.letter = GRADE_B;
    } else {
        double with_few = few == any ? least : largest_growth(&grading, few, GRADE_ARMS_IN);
        limit = GRADE_HANDS;
        if (fmax(straight, with_few) >= GRADE_ARMS_IN) {
            grade.letter = GRADE_C;
        } else if (least >= 0) {
            limit = GRADE_ARMS_IN;
            has = fmax(straight, with_few);
        } else {
            grade.letter = try_growth(&grading, 0, any).fits ? GRADE_E : GRADE_F;
            limit = 0;
            has = least;
        }
    }
    grade.to_next = grade.letter == GRADE_A ? 0 : limit - has;
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
