/* Metamorphic test of route planning: equivalent copies of tight houses must get equal routes, roomier ones no worse.
 *
 * Usage: metamorphic [SEED] [--cases N] [--first SEED] [--kinds LETTERS] [--seconds S] [--each] [--brief]
 *
 *   SEED       one case, with everything about it
 *   --kinds    some of the letters "ciosufbwnl": corner, door in, door out, S, U, flat, bend, wide door, niche, slalom
 *   --seconds  no further case is begun after S s of the processor's
 *   --each     every case is printed in short
 *   --brief    one copy, one drawing and one widening of each case, in turn
 *
 * The exit status is 1 when a limit is exceeded in more than its share of the cases. Every case is planned as drawn,
 * and with these changes:
 *
 *   copies    three, turned by any angle and shifted by up to 1 km, the second one mirrored, too;
 *   drawings  the exit's ends swapped; a wall split in two collinear pieces; the walls drawn in the opposite direction;
 *             a solid added inside a wall;
 *   widened   every passage 1, 2 and 5 cm wider, since all solids shrink by half of that on every side;
 *   roomier   one solid, drawn by lot, 1 and 3 cm smaller on every side;
 *   grown     one solid 1 cm larger on every side, if the answer is no.
 *
 * A different answer is counted apart when the case is at a limit: the body fits with a margin below AT_LIMIT, or it
 * passes when shrunk by SHRUNK but not when grown by as much. Times and changes of direction have no such excuse; of
 * those of houses with more room a share ABOVE may exceed the limit. */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "planned_time.h"
#include "route/fit.h"
#include "tight.h"

#define AT_LIMIT 0.005 /* m, least certain margin on every side */
#define SHRUNK 0.0025  /* m, on every side */
#define FAR 1000.0     /* m, largest shift in either direction */
#define ABOVE                                                                                                          \
    0.04 /* 1, of the cases: now and then a quicker way is found in the narrower house, and not in the wider */

enum { DEFAULT_CASES = 24, COPIES = 3, DRAWINGS = 4, WIDENINGS = 3, ROOMIER = 2, WORST = 10 };

static const double widenings[WIDENINGS] = {0.01, 0.02, 0.05}; /* m, of a passage */
static const double lesser[ROOMIER] = {0.01, 0.03};            /* m, on every side of one solid */

typedef enum Check {
    COPY_ANSWER,
    COPY_REVERSALS,
    COPY_TIME,
    DRAWING_ANSWER,
    DRAWING_TIME,
    WIDENED_ANSWER,
    WIDENED_REVERSALS,
    WIDENED_TIME,
    ROOMIER_ANSWER,
    ROOMIER_REVERSALS,
    ROOMIER_TIME,
    GROWN_ANSWER,
    SWEPT,
    CHECKS,
} Check;

/* What is required: a case fails when its value exceeds `most`; `share` of the cases may fail. */
static const struct Limit {
    const char *name, *unit;
    double scale; /* of the printed value */
    double most, share;
    bool answer; /* True if a case at a limit is counted apart */
} limits[CHECKS] = {
    [COPY_ANSWER] = {"copies: same answer", "differ", 1, 0, 0, true},
    [COPY_REVERSALS] = {"copies: same reversals", "more", 1, 0, 0, false},
    [COPY_TIME] = {"copies: time", "%", 100, 0.02, 0, false},
    [DRAWING_ANSWER] = {"drawings: same answer", "differ", 1, 0, 0, true},
    [DRAWING_TIME] = {"drawings: time", "%", 100, 0.02, 0, false},
    [WIDENED_ANSWER] = {"widened: a yes stays", "no", 1, 0, 0, true},
    [WIDENED_REVERSALS] = {"widened: reversals", "more", 1, 0, ABOVE, false},
    [WIDENED_TIME] = {"widened: time rises", "%", 100, 0.01, ABOVE, false},
    [ROOMIER_ANSWER] = {"roomier: a yes stays", "no", 1, 0, 0, true},
    [ROOMIER_REVERSALS] = {"roomier: reversals", "more", 1, 0, ABOVE, false},
    [ROOMIER_TIME] = {"roomier: time rises", "%", 100, 0.01, ABOVE, false},
    [GROWN_ANSWER] = {"grown: a no stays", "yes", 1, 0, 0, true},
    [SWEPT] = {"swept at 1 mm: overlap", "mm", 1000, 0, 0, false},
};

/* The answer for one house. */
typedef struct Answer {
    bool found;
    int reversals;
    double time;  /* s */
    double swept; /* m, least distance from the solids */
    double cost;  /* s of the processor's, to plan it */
} Answer;

typedef struct Range {
    int first, count;
} Range;

typedef struct Case {
    uint64_t seed;
    TightScene scene;
    Answer drawn, copies[COPIES], drawings[DRAWINGS], widened[WIDENINGS], roomier[ROOMIER], grown;
    Range copy, drawing, widening, lessening; /* those that were planned */
    bool asked[CHECKS];                       /* True if the check has a value */
    double value[CHECKS];
    bool failed[CHECKS], at_limit;
    double badness; /* 1, order of the worst: answers, overlaps, then times beside their limits */
} Case;

/* Planning ----------------------------------------------------------------------------------------------------- */

static double seconds(void) {
    return (double)clock() / CLOCKS_PER_SEC;
}

static Answer plan_scene(const TightScene *scene, const Profile *profile) {
    TightHouse *tight = calloc(1, sizeof *tight);
    tight_build(tight, scene, profile);
    Answer answer = {.swept = HUGE_VAL};
    double begun = seconds();
    Route route = route_drive(&tight->query);
    answer.cost = seconds() - begun;
    answer.found = route.answer == ROUTE_FOUND;
    if (answer.found) {
        answer.reversals = route.reversals;
        answer.time = planned_time(&tight->house, profile, &route);
        answer.swept = tight_sweep(scene, profile, &route);
    }
    route_free(&route);
    tight_free(tight);
    free(tight);
    return answer;
}

/* Plans for a body that is larger by `by` m on every side. */
static Answer plan_grown(const TightScene *scene, const Profile *profile, double by) {
    Profile grown = *profile;
    grown.length += 2 * by;
    grown.width += 2 * by;
    grown.axle += by;
    return plan_scene(scene, &grown);
}

static bool is_at_limit(const TightScene *scene, const Profile *profile) {
    TightHouse *tight = calloc(1, sizeof *tight);
    tight_build(tight, scene, profile);
    Rectangle body = search_body(profile);
    Goal goal = field_exit_goal(SIZE_MAX, 0, 0);
    FitPlace place;
    bool known = fit_margin(&tight->query, &body, &goal, 1, -2 * AT_LIMIT, 2 * AT_LIMIT, &place) == FIT_KNOWN;
    bool near = known && fabs(place.margin + FIT_RESOLUTION / 2) < AT_LIMIT;
    tight_free(tight);
    free(tight);
    return near || (plan_grown(scene, profile, -SHRUNK).found && !plan_grown(scene, profile, SHRUNK).found);
}

static void plan_copies(Case *one, const Profile *profile, Random *random) {
    for (int i = 0; i < one->copy.count; i++) {
        TightScene scene = one->scene;
        double angle = 2 * M_PI * random_uniform(random);
        Vec2 shift = vec2(FAR * (2 * random_uniform(random) - 1), FAR * (2 * random_uniform(random) - 1));
        tight_move(&scene, one->copy.first + i == 1, angle, shift);
        one->copies[i] = plan_scene(&scene, profile);
    }
}

static void plan_drawings(Case *one, const Profile *profile, Random *random) {
    TightScene scenes[DRAWINGS];
    for (int i = 0; i < DRAWINGS; i++)
        scenes[i] = one->scene;
    tight_swap_exit(&scenes[0]);
    tight_split_wall(&scenes[1], random);
    tight_reverse_walls(&scenes[2]);
    tight_add_inside(&scenes[3], random);
    for (int i = 0; i < one->drawing.count; i++)
        one->drawings[i] = plan_scene(&scenes[one->drawing.first + i], profile);
}

static void plan_widened(Case *one, const Profile *profile) {
    for (int i = 0; i < one->widening.count; i++) {
        TightScene scene = one->scene;
        tight_shrink(&scene, widenings[one->widening.first + i] / 2);
        one->widened[i] = plan_scene(&scene, profile);
    }
}

static void plan_roomier(Case *one, const Profile *profile) {
    Random random = random_seed(one->seed, 3);
    size_t solid = (size_t)(random_uniform(&random) * (double)one->scene.count);
    for (int i = 0; i < one->lessening.count; i++) {
        TightScene scene = one->scene;
        tight_grow(&scene, solid, -lesser[one->lessening.first + i]);
        one->roomier[i] = plan_scene(&scene, profile);
    }
}

/* Checks ------------------------------------------------------------------------------------------------------- */

static void note(Case *one, Check check, double value) {
    one->value[check] = one->asked[check] ? fmax(one->value[check], value) : value;
    one->asked[check] = true;
}

/* Compares answers that must be equal; the first one is that of the case as drawn. */
static void check_equal(Case *one, const Answer *others, int count, Check answers, Check reversals, Check times) {
    double shortest = one->drawn.time, longest = one->drawn.time;
    int least = one->drawn.reversals, most = one->drawn.reversals, found = one->drawn.found;
    for (int i = 0; i < count; i++) {
        note(one, answers, others[i].found != one->drawn.found);
        if (!others[i].found)
            continue;
        shortest = found ? fmin(shortest, others[i].time) : others[i].time;
        longest = fmax(longest, others[i].time);
        least = found && least < others[i].reversals ? least : others[i].reversals;
        most = most > others[i].reversals ? most : others[i].reversals;
        found++;
    }
    if (found < 2)
        return;
    note(one, times, longest / shortest - 1);
    if (reversals != CHECKS)
        note(one, reversals, most - least);
}

/* Compares answers each of which must be no worse than those before it. */
static void check_nested(Case *one, const Answer *nested, int count, Check answers, Check reversals, Check times) {
    Answer best = one->drawn;
    for (int i = 0; i < count; i++) {
        const Answer *wider = &nested[i];
        if (best.found)
            note(one, answers, !wider->found);
        if (best.found && wider->found) {
            note(one, times, fmax(0, wider->time / best.time - 1));
            note(one, reversals, wider->reversals > best.reversals ? wider->reversals - best.reversals : 0);
        }
        if (wider->found) {
            best.time = best.found ? fmin(best.time, wider->time) : wider->time;
            best.reversals = best.found && best.reversals < wider->reversals ? best.reversals : wider->reversals;
            best.found = true;
        }
    }
}

static void check_swept(Case *one, const Answer *answers, int count) {
    for (int i = 0; i < count; i++)
        if (answers[i].found)
            note(one, SWEPT, fmax(0, -answers[i].swept));
}

/* Returns all of some changes, or the one whose turn it is. */
static Range some_of(int count, bool all, uint64_t turn) {
    return all ? (Range){0, count} : (Range){(int)(turn % (uint64_t)count), 1};
}

static Case run_case(uint64_t seed, TightKind kind, bool brief, const Profile *profile) {
    Case one = {.seed = seed, .scene = tight_draw(kind, seed)};
    Random random = random_seed(seed, 2);
    one.drawn = plan_scene(&one.scene, profile);
    uint64_t turn = seed / TIGHT_KINDS;
    one.copy = some_of(COPIES, !brief, turn);
    one.drawing = some_of(DRAWINGS, !brief && one.drawn.found, turn); /* a no takes long */
    one.widening = some_of(WIDENINGS, !brief, turn);
    plan_copies(&one, profile, &random);
    plan_drawings(&one, profile, &random);
    one.lessening = some_of(ROOMIER, !brief, turn);
    plan_widened(&one, profile);
    plan_roomier(&one, profile);
    if (!one.drawn.found) {
        TightScene scene = one.scene;
        tight_grow(&scene, (size_t)(random_uniform(&random) * (double)scene.count), 0.01);
        one.grown = plan_scene(&scene, profile);
        note(&one, GROWN_ANSWER, one.grown.found);
        check_swept(&one, &one.grown, 1);
    }
    check_equal(&one, one.copies, one.copy.count, COPY_ANSWER, COPY_REVERSALS, COPY_TIME);
    check_equal(&one, one.drawings, one.drawing.count, DRAWING_ANSWER, CHECKS, DRAWING_TIME);
    check_nested(&one, one.widened, one.widening.count, WIDENED_ANSWER, WIDENED_REVERSALS, WIDENED_TIME);
    check_nested(&one, one.roomier, one.lessening.count, ROOMIER_ANSWER, ROOMIER_REVERSALS, ROOMIER_TIME);
    check_swept(&one, &one.drawn, 1);
    check_swept(&one, one.copies, one.copy.count);
    check_swept(&one, one.drawings, one.drawing.count);
    check_swept(&one, one.widened, one.widening.count);
    check_swept(&one, one.roomier, one.lessening.count);
    bool differs = false;
    for (int c = 0; c < CHECKS; c++) {
        one.failed[c] = one.asked[c] && one.value[c] > limits[c].most;
        differs = differs || (one.failed[c] && limits[c].answer);
    }
    one.at_limit = differs && is_at_limit(&one.scene, profile);
    for (int c = 0; c < CHECKS; c++) {
        bool counts = one.failed[c] && !(limits[c].answer && one.at_limit);
        double beyond = limits[c].answer     ? 1e9
                        : c == SWEPT         ? 1e6 * (1 + one.value[c])
                        : limits[c].most > 0 ? one.value[c] / limits[c].most
                                             : one.value[c];
        one.badness = counts ? fmax(one.badness, beyond) : one.badness;
    }
    return one;
}

/* Printing ----------------------------------------------------------------------------------------------------- */

static int by_value(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int by_badness(const void *a, const void *b) {
    double x = (*(const Case *const *)a)->badness, y = (*(const Case *const *)b)->badness;
    return (x < y) - (x > y);
}

/* Returns the value that a share of the sorted values does not exceed. */
static double quantile(const double *values, size_t count, double share) {
    size_t rank = (size_t)ceil(share * (double)count);
    return values[rank > 0 ? rank - 1 : 0];
}

/* Prints the row of a check for one kind, or for TIGHT_KINDS for all. Returns false if its limit is exceeded. */
static bool print_row(const Case *cases, size_t count, Check check, TightKind kind) {
    const struct Limit *limit = &limits[check];
    double *values = calloc(count + 1, sizeof *values);
    size_t asked = 0, failed = 0, apart = 0;
    for (size_t i = 0; i < count; i++) {
        const Case *one = &cases[i];
        if (!one->asked[check] || (kind != TIGHT_KINDS && one->scene.kind != kind))
            continue;
        bool excused = one->failed[check] && limit->answer && one->at_limit;
        apart += excused;
        failed += one->failed[check] && !excused;
        values[asked++] = limit->scale * one->value[check];
    }
    qsort(values, asked, sizeof *values, by_value);
    if (asked > 0)
        printf("%-24s %-9s %5zu %6zu %8zu %8.2f %8.2f %8.2f %s\n", limit->name,
               kind == TIGHT_KINDS ? "all" : tight_kind_name(kind), asked, failed, apart, quantile(values, asked, 0.5),
               quantile(values, asked, 0.95), values[asked - 1], limit->unit);
    free(values);
    return (double)failed <= limit->share * (double)asked;
}

static void print_answer(const char *name, const Answer *answer) {
    if (answer->found)
        printf("  %-16s yes, %d reversals, %.3f s, swept %.2f mm (%.2f s)\n", name, answer->reversals, answer->time,
               1000 * answer->swept, answer->cost);
    else
        printf("  %-16s no (%.2f s)\n", name, answer->cost);
}

static void print_short(const Answer *answers, int count) {
    for (int i = 0; i < count; i++) {
        if (answers[i].found)
            printf(" %.2f/%d", answers[i].time, answers[i].reversals);
        else
            printf(" no");
    }
}

static void print_case(const Case *one) {
    char sizes[128];
    tight_sizes(&one->scene, sizes, sizeof sizes);
    printf("seed %llu, %s, %s%s\n   failed:", (unsigned long long)one->seed, tight_kind_name(one->scene.kind), sizes,
           one->at_limit ? ", at a limit" : "");
    for (int c = 0; c < CHECKS; c++)
        if (one->failed[c])
            printf(" [%s %.2f %s]", limits[c].name, limits[c].scale * one->value[c], limits[c].unit);
    printf("\n   time/reversals:");
    print_short(&one->drawn, 1);
    printf("; copies");
    print_short(one->copies, one->copy.count);
    printf("; drawings");
    print_short(one->drawings, one->drawing.count);
    printf("; widened");
    print_short(one->widened, one->widening.count);
    printf("; roomier");
    print_short(one->roomier, one->lessening.count);
    printf("\n");
}

static void print_whole_case(const Case *one) {
    static const char *const drawing_names[DRAWINGS] = {"exit swapped", "wall split", "walls reversed", "solid inside"};
    print_case(one);
    print_answer("as drawn", &one->drawn);
    for (int i = 0; i < one->copy.count; i++)
        print_answer(one->copy.first + i == 1 ? "mirrored copy" : "copy", &one->copies[i]);
    for (int i = 0; i < one->drawing.count; i++)
        print_answer(drawing_names[one->drawing.first + i], &one->drawings[i]);
    for (int i = 0; i < one->widening.count; i++) {
        char name[32];
        snprintf(name, sizeof name, "%.0f cm wider", 100 * widenings[one->widening.first + i]);
        print_answer(name, &one->widened[i]);
    }
    for (int i = 0; i < one->lessening.count; i++)
        print_answer("a solid smaller", &one->roomier[i]);
    if (one->asked[GROWN_ANSWER])
        print_answer("a solid grown", &one->grown);
}

/* Prints the table and the worst cases. Returns false if a limit is exceeded. */
static bool print_table(const Case *cases, size_t count) {
    bool good = true;
    printf("%-24s %-9s %5s %6s %8s %8s %8s %8s\n", "check", "kind", "cases", "failed", "at limit", "median", "p95",
           "max");
    for (Check check = 0; check < CHECKS; check++) {
        for (TightKind kind = 0; kind < TIGHT_KINDS; kind++)
            print_row(cases, count, check, kind);
        good = print_row(cases, count, check, TIGHT_KINDS) && good;
    }
    const Case **sorted = calloc(count + 1, sizeof *sorted);
    size_t yes = 0;
    for (size_t i = 0; i < count; i++) {
        sorted[i] = &cases[i];
        yes += cases[i].drawn.found;
    }
    qsort(sorted, count, sizeof *sorted, by_badness);
    printf("%zu cases, %zu of them yes as drawn. The worst:\n", count, yes);
    for (size_t i = 0; i < WORST && i < count && sorted[i]->badness > 0; i++)
        print_case(sorted[i]);
    free(sorted);
    return good;
}

/* The command line ----------------------------------------------------------------------------------------------- */

static const char letters[TIGHT_KINDS + 1] = "ciosufbwnl";

typedef struct Options {
    const char *kinds;
    size_t cases;
    uint64_t first;
    double seconds; /* s, HUGE_VAL: no limit */
    bool single, each, brief;
} Options;

/* Returns false after an argument that is not known. */
static bool read_options(Options *options, int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        const char *name = argv[i];
        bool each = strcmp(name, "--each") == 0, brief = strcmp(name, "--brief") == 0;
        options->each = options->each || each;
        options->brief = options->brief || brief;
        if (each || brief)
            continue;
        options->single = options->single || name[0] != '-';
        const char *value = name[0] != '-' ? name : i + 1 < argc ? argv[++i] : "";
        char *end;
        double number = strtod(value, &end);
        bool numeric = *value && !*end && number >= 0;
        if (numeric && strcmp(name, "--cases") == 0)
            options->cases = (size_t)number;
        else if (numeric && strcmp(name, "--seconds") == 0)
            options->seconds = number;
        else if (numeric && (strcmp(name, "--first") == 0 || value == name))
            options->first = (uint64_t)number;
        else if (*value && strcmp(name, "--kinds") == 0 && strspn(value, letters) == strlen(value))
            options->kinds = value;
        else {
            fprintf(stderr, "%s %s: not an option\n", name, value == name ? "" : value);
            return false;
        }
    }
    return true;
}

static bool read_chair(Profile *profile) {
    const char *source = getenv("CLEARANCE_SOURCE");
    char path[4096];
    snprintf(path, sizeof path, "%s/assets/profiles/manual-chair.json", source ? source : ".");
    Fault fault = {0};
    bool good = profile_read(profile, path, &fault);
    if (!good)
        fprintf(stderr, "%s\n", fault.count ? fault.lines[0] : path);
    fault_clear(&fault);
    return good;
}

int main(int argc, char **argv) {
    Options options = {.kinds = letters, .cases = DEFAULT_CASES, .seconds = HUGE_VAL};
    Profile profile = {0};
    if (!read_options(&options, argc, argv) || !read_chair(&profile))
        return 2;
    setvbuf(stdout, NULL, _IOLBF, 0);
    size_t count = options.single ? 1 : options.cases, done = 0;
    Case *cases = calloc(count + 1, sizeof *cases);
    double begun = seconds();
    for (uint64_t seed = options.first; done < count && seconds() - begun < options.seconds; seed++) {
        TightKind kind = (TightKind)(strchr(letters, options.kinds[seed % strlen(options.kinds)]) - letters);
        cases[done] = run_case(seed, kind, options.brief, &profile);
        if (options.single)
            print_whole_case(&cases[done]);
        else if (options.each)
            print_case(&cases[done]);
        done++;
    }
    bool good = print_table(cases, done);
    printf("%.1f s of the processor's\n", seconds() - begun);
    free(cases);
    profile_free(&profile);
    return !good;
}
