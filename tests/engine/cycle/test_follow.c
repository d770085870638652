#include <math.h>
#include <stdio.h>
#include <string.h>

#include "beam/beam_cycle.h"
#include "check.h"
#include "cycle/follow_curve.h"
#include "cycle/orbit.h"
#include "oscillator.h"
#include "planar_map.h"

/* A map whose first number is the parameter. */
typedef struct Numbered {
    PlanarMap map;
    double numbers[3];
    double bend; /* the map's number is the parameter less so many times the square of the second one */
} Numbered;

static Cycle map_at(void *context, double value) {
    Numbered *numbered = context;
    numbered->numbers[0] = value - numbered->bend * numbered->numbers[1] * numbered->numbers[1];
    numbered->map.numbers = numbered->numbers;
    return planar_map_cycle(&numbered->map);
}

static const FollowPoint *find_point(const FollowBranch *branch, FollowKind kind, size_t which) {
    for (size_t i = 0; i < branch->count; i++)
        if (branch->points[i].kind == kind && which-- == 0)
            return &branch->points[i];
    return NULL;
}

static void check_point(const FollowBranch *branch, FollowKind kind, size_t which, double value, double tolerance) {
    const FollowPoint *point = find_point(branch, kind, which);
    CHECK(point);
    if (!point)
        return;
    CHECK_NEAR(point->value, value, tolerance);
    if (kind != FOLLOW_TOUCH)
        CHECK_NEAR(hypot(point->re, point->im), 1, 1e-6);
}

/* The fixed point 1 - 1/r of r x (1 - x) flips at r = 3; its orbit of period 2 flips at 1 + sqrt 6. */
TEST(flips_of_the_logistic_map_are_located) {
    Numbered numbered = {.map = {planar_map_logistic, NULL, 0}};
    FollowFamily family = {.at = map_at, .context = &numbered, .from = 2.2, .to = 3.8};
    FollowBranch branch;
    CHECK(follow_run(&branch, &family, 2.7, (double[]){1 - 1 / 2.7, 1 - 1 / 2.7}, 1, 0.02, NULL));
    check_point(&branch, FOLLOW_FLIP, 0, 3, 1e-6);
    CHECK(branch.below == FOLLOW_RANGE && branch.above == FOLLOW_RANGE && !find_point(&branch, FOLLOW_FOLD, 0));
    CHECK(branch.points[0].stable && !branch.points[branch.count - 1].stable);
    follow_clear(&branch);
    double r = 3.2, x = (r + 1 - sqrt((r - 3) * (r + 1))) / (2 * r), y = (r + 1 + sqrt((r - 3) * (r + 1))) / (2 * r);
    family.from = 3.1;
    CHECK(follow_run(&branch, &family, r, (double[]){x, y}, 2, 0.02, NULL));
    check_point(&branch, FOLLOW_FLIP, 0, 1 + sqrt(6), 1e-6);
    follow_clear(&branch);
}

/* Henon's map with b = 0.3: two fixed points meet at a = -(1 - b)^2 / 4, the stable one flips at 3 (1 - b)^2 / 4. */
TEST(a_fold_is_gone_round_to_the_unstable_orbit) {
    Numbered numbered = {.map = {planar_map_henon, NULL, 0}, .numbers = {0, 0.3}};
    FollowFamily family = {.at = map_at, .context = &numbered, .from = -0.5, .to = 0.5};
    const double b = 0.3, a = 0.2, x = (b - 1 + sqrt((1 - b) * (1 - b) + 4 * a)) / (2 * a);
    FollowBranch branch;
    CHECK(follow_run(&branch, &family, a, (double[]){x, b * x}, 1, 0.02, NULL));
    check_point(&branch, FOLLOW_FOLD, 0, -(1 - b) * (1 - b) / 4, 1e-6);
    check_point(&branch, FOLLOW_FLIP, 0, 3 * (1 - b) * (1 - b) / 4, 1e-6);
    follow_clear(&branch);
}

static bool set_second(void *context, double other) {
    Numbered *numbered = context;
    numbered->numbers[1] = other;
    return other < 0.55; /* an end of what is possible */
}

/* Henon's map folds at a = -(1 - b)^2 / 4 and flips at 3 (1 - b)^2 / 4 for every b. */
TEST(curves_over_two_parameters_are_the_closed_form) {
    Numbered numbered = {.map = {planar_map_henon, NULL, 0}, .numbers = {0, 0.3}};
    FollowFamily family = {.at = map_at, .context = &numbered, .from = -0.5, .to = 1.5};
    const double b = 0.3, a = 0.2, x = (b - 1 + sqrt((1 - b) * (1 - b) + 4 * a)) / (2 * a);
    FollowBranch branch;
    CHECK(follow_run(&branch, &family, a, (double[]){x, b * x}, 1, 0.02, NULL));
    for (FollowKind kind = FOLLOW_FOLD; kind <= FOLLOW_FLIP; kind++) {
        const FollowPoint *point = find_point(&branch, kind, 0);
        FollowPlane plane = {&family, set_second, &numbered, 0.3, 0.1, 0.6, 26};
        FollowCurve curve;
        double share = kind == FOLLOW_FOLD ? -0.25 : 0.75;
        CHECK(point && follow_curve_run(&curve, &plane, &branch, (size_t)(point - branch.points), NULL));
        CHECK(curve.whole[0] && !curve.whole[1] && curve.count > 20); /* beyond 0.55 the map is impossible */
        CHECK(curve.other[0] == 0.1 && curve.other[curve.count - 1] > 0.54);
        for (size_t i = 0; i < curve.count; i++) {
            CHECK_NEAR(curve.value[i], share * (1 - curve.other[i]) * (1 - curve.other[i]), 1e-6);
            CHECK(curve.off[i] < 1e-6 && (i == 0 || curve.other[i] > curve.other[i - 1]));
        }
        CHECK(family.from == -0.5 && family.to == 1.5 && numbered.numbers[1] == 0.3);
        follow_curve_clear(&curve);
    }
    follow_clear(&branch);
}

/* The fixed point 1 - 1/r of x' = r x (1 - y), y' = x becomes a torus at r = 2, with the multipliers exp(+-i pi/3). */
TEST(a_torus_begins_where_a_pair_of_multipliers_leaves_the_circle) {
    Numbered numbered = {.map = {planar_map_delayed, NULL, 0}};
    FollowFamily family = {.at = map_at, .context = &numbered, .from = 1.5, .to = 2.2};
    FollowBranch branch;
    CHECK(follow_run(&branch, &family, 1.7, (double[]){1 - 1 / 1.7, 1 - 1 / 1.7}, 1, 0.05, NULL));
    check_point(&branch, FOLLOW_NEIMARK, 0, 2, 1e-6);
    const FollowPoint *torus = find_point(&branch, FOLLOW_NEIMARK, 0);
    CHECK(torus && fabs(atan2(fabs(torus->im), torus->re) / (2 * M_PI) - 1.0 / 6) < 1e-6);
    follow_clear(&branch);
}

/* A torus begins where the map's number is 2 (delayed logistic map), the symmetry is lost where it is 1 (cubic map). */
TEST(curves_of_tori_and_pitchforks_are_the_closed_form) {
    static const struct {
        void (*move)(const void *numbers, double *point, double *derivative);
        FollowKind kind;
        double from, start, point, number;
    } cases[] = {{planar_map_delayed, FOLLOW_NEIMARK, 1.5, 1.7, 1 - 1 / 1.7, 2},
                 {planar_map_cubic, FOLLOW_PITCHFORK, 0.5, 0.8, 1, 1}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        Numbered numbered = {.map = {cases[c].move, NULL, 0}, .numbers = {0, 0}, .bend = 0.5};
        FollowFamily family = {.at = map_at, .context = &numbered, .from = cases[c].from, .to = cases[c].from + 1};
        FollowPlane plane = {&family, set_second, &numbered, 0, -0.4, 0.4, 17};
        FollowBranch branch;
        FollowCurve curve;
        CHECK(follow_run(&branch, &family, cases[c].start, (double[]){cases[c].point, cases[c].point}, 1, 0.02, NULL));
        const FollowPoint *point = find_point(&branch, cases[c].kind, 0);
        CHECK(point && follow_curve_run(&curve, &plane, &branch, (size_t)(point - branch.points), NULL));
        CHECK(curve.kind == cases[c].kind && curve.whole[0] && curve.whole[1] && curve.count >= 17);
        for (size_t i = 0; i < curve.count; i++) {
            CHECK_NEAR(curve.value[i], cases[c].number + 0.5 * curve.other[i] * curve.other[i], 1e-6);
            CHECK(curve.off[i] < 1e-6);
        }
        follow_curve_clear(&curve);
        follow_clear(&branch);
    }
}

/* Sets `speeds` to those of the impacts of the two motions with one impact a cycle of x'' + x = sin(w t), x <= gap, in
 * which v becomes -r v [Shaw and Holmes 1983]: (gap + a v)^2 + (b v)^2 = c^2, with a = (1 + r) / (2 tan(pi / w)),
 * b = (1 - r) / (2 w), c = 1 / (w^2 - 1). They meet where gap = c sqrt(1 + (a / b)^2). */
static double find_speeds(double w, double r, double gap, double speeds[2]) {
    double a = (1 + r) / (2 * tan(M_PI / w)), b = (1 - r) / (2 * w), c = 1 / (w * w - 1), square = a * a + b * b;
    double root = sqrt(fmax(0, square * c * c - b * b * gap * gap));
    speeds[0] = (-a * gap + root) / square;
    speeds[1] = (-a * gap - root) / square;
    return c * sqrt(1 + (a / b) * (a / b));
}

/* Returns the sum of the two multipliers of such a motion, which follows from the acceleration at the impact; their
 * product is r^2. */
static double impact_sum(double w, double r, double gap, double speed) {
    double a = (1 + r) / (2 * tan(M_PI / w)), time = 2 * M_PI / w;
    return -2 * r * cos(time) - (1 + r) * sin(time) * (w * w * gap / speed + (w * w - 1) * a);
}

static double larger_of(double sum, double product) {
    double root = sum * sum / 4 - product;
    return root < 0 ? sqrt(product) : fabs(sum) / 2 + sqrt(root);
}

/* Returns the gap at which the sum of the multipliers is -(1 + r^2). */
static double impact_flip(double w, double r) {
    double a = (1 + r) / (2 * tan(M_PI / w)), b = (1 - r) / (2 * w), c = 1 / (w * w - 1), time = 2 * M_PI / w;
    double share = ((1 + r * r - 2 * r * cos(time)) / ((1 + r) * sin(time)) - (w * w - 1) * a) / (w * w);
    return share * c / hypot(share + a, b);
}

/* Returns the sum of the multipliers by central differences of the map. */
static double differences_sum(const double *numbers, const double *point) {
    const double small = 1e-7;
    double sum = 0, unused[4];
    for (int k = 0; k < 2; k++) {
        double up[2] = {point[0], point[1]}, down[2] = {point[0], point[1]};
        up[k] += small;
        down[k] -= small;
        planar_map_impact(numbers, up, unused);
        planar_map_impact(numbers, down, unused);
        sum += (up[k] - down[k]) / (2 * small);
    }
    return sum;
}

/* The faster one is followed from the flip over the fold to the slower one. */
TEST(an_oscillator_that_hits_one_stop_folds_and_flips_where_its_closed_form_does) {
    const double w = 1.2, r = 0.6;
    Numbered numbered = {.map = {planar_map_impact, NULL, 0}, .numbers = {0, w, r}};
    FollowFamily family = {.at = map_at, .context = &numbered, .from = 0, .to = 25};
    double point[2] = {0}, speeds[2], fold = find_speeds(w, r, 2, speeds), derivative[4], apart = 0;
    map_at(&numbered, 2);
    for (int i = 0; i < 200; i++)
        planar_map_impact(numbered.numbers, point, derivative);
    FollowBranch branch;
    CHECK(follow_run(&branch, &family, 2, point, 1, 0.05, NULL));
    check_point(&branch, FOLLOW_FOLD, 0, fold, 1e-6);
    check_point(&branch, FOLLOW_FLIP, 0, impact_flip(w, r), 1e-6);
    size_t turn = 0;
    while (turn < branch.count && branch.points[turn].kind != FOLLOW_FOLD)
        turn++;
    for (size_t i = 0; i < branch.count; i++) {
        const FollowPoint *at = &branch.points[i];
        find_speeds(w, r, at->value, speeds);
        double sum = impact_sum(w, r, at->value, speeds[i > turn]);
        map_at(&numbered, at->value);
        if (fabs(at->value - fold) < 0.01) /* the two speeds there are a root of what rounding leaves */
            continue;
        CHECK_NEAR(differences_sum(numbered.numbers, follow_state(&branch, i)), sum, 1e-6 * fmax(1, fabs(sum)));
        apart = fmax(apart, fabs(at->largest / larger_of(sum, r * r) - 1));
        CHECK_NEAR(at->largest / larger_of(sum, r * r), 1, 1e-8);
    }
    printf("     fold at %.6f, flip at %.6f; %zu multipliers, at most %.1e beside the closed form\n", fold,
           impact_flip(w, r), branch.count, apart);
    CHECK(branch.below == FOLLOW_RANGE && branch.count > 100 && turn + 10 < branch.count);
    follow_clear(&branch);
}

/* Interruption -------------------------------------------------------------------------------------------------------
 */

/* Henon's map that counts its moves and those from beyond TOUCHED, which count as switches, and requests the end of the
 * work at one of its moves. */
static const double TOUCHED = 1;
static Stop stop;
static size_t moves, stops_at, touches;

static void move_and_stop(const void *numbers, double *point, double *derivative) {
    touches += point[0] > TOUCHED;
    if (++moves == stops_at)
        stop_request(&stop);
    planar_map_henon(numbers, point, derivative);
}

static CycleTally touches_of(const void *motion) {
    (void)motion;
    return (CycleTally){.switches = touches};
}

static Cycle stopping_at(void *context, double value) {
    static CycleKind kind;
    Cycle cycle = map_at(context, value);
    kind = *cycle.kind;
    kind.tally = touches_of;
    return (Cycle){&kind, cycle.given};
}

/* True if each point of a branch is where it belongs on the whole one, with the same bits. */
static bool is_part(const FollowBranch *part, const FollowBranch *whole) {
    bool same = part->start <= whole->start && part->count - part->start <= whole->count - whole->start;
    for (size_t i = 0; i < part->count && same; i++) {
        size_t k = whole->start - part->start + i;
        const FollowPoint *a = &part->points[i], *b = &whole->points[k];
        same = a->kind == b->kind && a->value == b->value && a->peak == b->peak && a->re == b->re && a->im == b->im &&
               a->largest == b->largest && a->stable == b->stable && a->switches == b->switches &&
               memcmp(follow_state(part, i), follow_state(whole, k), part->states * sizeof(double)) == 0;
    }
    return same;
}

TEST(a_branch_that_is_interrupted_is_a_part_of_the_whole_one) {
    enum { STRIDE = 41 };
    Numbered numbered = {.map = {move_and_stop, NULL, 0}, .numbers = {0, 0.3}};
    FollowFamily family = {.at = stopping_at, .context = &numbered, .from = -0.5, .to = 0.5};
    const double b = 0.3, a = 0.2, x = (b - 1 + sqrt((1 - b) * (1 - b) + 4 * a)) / (2 * a);
    FollowBranch whole;
    moves = stops_at = 0;
    CHECK(follow_run(&whole, &family, a, (double[]){x, b * x}, 1, 0.1, &stop));
    check_point(&whole, FOLLOW_FOLD, 0, -(1 - b) * (1 - b) / 4, 1e-6);
    check_point(&whole, FOLLOW_FLIP, 0, 3 * (1 - b) * (1 - b) / 4, 1e-6);
    check_point(&whole, FOLLOW_TOUCH, 0, b, 1e-6); /* where x = 1 */
    size_t all = moves, parts = 0, wrong = 0;
    for (size_t n = 1; n <= all; n += STRIDE) {
        FollowBranch part;
        moves = 0;
        stops_at = n;
        bool any = follow_run(&part, &family, a, (double[]){x, b * x}, 1, 0.1, &stop);
        wrong += any && (!is_part(&part, &whole) || (part.above != FOLLOW_STOPPED && part.count < whole.count));
        parts += any && part.count < whole.count;
        stop_withdraw(&stop);
        follow_clear(&part);
    }
    printf("     %zu of %zu moves, %zu parts\n", all / STRIDE, all, parts);
    CHECK(wrong == 0 && parts > 100);
    stops_at = 0;
    follow_clear(&whole);
}

/* Beams --------------------------------------------------------------------------------------------------------------
 */

typedef struct Driven {
    Rig rig, own;
    bool by_force, shares;
    double frequency, force, clearance;
} Driven;

static Cycle beam_at(void *context, double value) {
    Driven *driven = context;
    if (driven->shares)
        rig_clear_shared(&driven->own);
    driven->own = rig_share(&driven->rig, driven->by_force ? driven->frequency : value,
                            driven->by_force ? value : driven->force, driven->clearance);
    driven->shares = true;
    return beam_cycle_of(&driven->own);
}

static void end(Driven *driven) {
    if (driven->shares)
        rig_clear_shared(&driven->own);
    rig_clear(&driven->rig);
}

/* Without contact the motion is the closed form's, and the branch of set B at 250 Hz ends by touching at 63.0773 N. The
 * slowest of the decays of the free beam is its largest multiplier. */
TEST(the_free_branch_of_set_b_ends_by_touching_where_its_amplitude_is_the_clearance) {
    Driven driven = {.rig = oscillator_beam_rig("ibs", NULL), .by_force = true, .frequency = 250};
    driven.clearance = driven.rig.clearance;
    double state[128];
    beam_at(&driven, 50);
    regime_state(&driven.own.free, driven.own.steady_free.cosine, state);
    double edge = 50 * driven.clearance / rig_free_amplitude(&driven.own);
    FollowFamily family = {.at = beam_at, .context = &driven, .from = 20, .to = 80};
    FollowBranch branch;
    CHECK(follow_run(&branch, &family, 50, state, 1, 0.1, NULL));
    printf("     touches at %.4f N, %zu points\n", edge, branch.count);
    CHECK_NEAR(edge, 63.0773, 1e-4);
    double slowest = -HUGE_VAL;
    for (size_t i = 0; i < driven.own.free.blocks; i++)
        if (driven.own.free.lambda.re[i] != 0)
            slowest = fmax(slowest, driven.own.free.lambda.re[i]);
    for (size_t i = 0; i < branch.count; i++)
        if (branch.points[i].peak == 0)
            CHECK_NEAR(branch.points[i].largest, exp(slowest * driven.own.period), 1e-10);
    check_point(&branch, FOLLOW_TOUCH, 0, edge,
                3e-6 * (family.to - family.from)); /* the difference by force crosses it */
    follow_clear(&branch);
    end(&driven);
}

/* The fixed point 1 of 1 + r (x - 1) - (x - 1)^3 loses its symmetry at r = 1; the points 1 +- sqrt(r - 1), which begin
 * there, flip at 2. */
TEST(a_pitchfork_is_located_and_the_orbit_that_begins_there_is_followed) {
    Numbered numbered = {.map = {planar_map_cubic, NULL, 0}};
    FollowFamily family = {.at = map_at, .context = &numbered, .from = 0.5, .to = 2.5};
    FollowBranch branch, begun, doubled;
    CHECK(follow_run(&branch, &family, 0.8, (double[]){1, 1}, 1, 0.02, NULL));
    check_point(&branch, FOLLOW_PITCHFORK, 0, 1, 1e-6);
    CHECK(!find_point(&branch, FOLLOW_FOLD, 0));
    const FollowPoint *fork = find_point(&branch, FOLLOW_PITCHFORK, 0);
    CHECK(fork && follow_branch_off(&begun, &family, &branch, (size_t)(fork - branch.points), 0.02, NULL));
    check_point(&begun, FOLLOW_FLIP, 0, 2, 1e-6);
    CHECK(begun.period == 1 && begun.points[0].stable);
    for (size_t i = 0; i < begun.count; i++) {
        double x = follow_state(&begun, i)[0] - 1;
        CHECK_NEAR(x * x, begun.points[i].value - 1, 1e-8);
    }
    const FollowPoint *flip = find_point(&begun, FOLLOW_FLIP, 0);
    CHECK(flip && follow_branch_off(&doubled, &family, &begun, (size_t)(flip - begun.points), 0.02, NULL));
    CHECK(doubled.period == 2 && doubled.count > 5 && doubled.points[1].stable && doubled.points[1].value > 2);
    follow_clear(&doubled);
    follow_clear(&begun);
    follow_clear(&branch);
}

/* Tells the mirror image of the orbit at a point of a branch. */
static OrbitImage image_at(Driven *driven, const FollowBranch *branch, size_t at) {
    Orbit orbit;
    Cycle cycle = beam_at(driven, branch->points[at].value);
    CHECK(orbit_find(&orbit, cycle, follow_state(branch, at), branch->period, NULL) == ORBIT_GOOD);
    OrbitImage image = orbit_image(&orbit, cycle, NULL);
    orbit_clear(&orbit);
    return image;
}

/* At 210 Hz two orbits of set B are each other's mirror image. They meet at a pitchfork, not at a fold, for the orbit
 * that is its own image comes through it: unstable beside them, stable beyond. */
TEST(a_pair_of_mirror_images_meets_at_a_pitchfork_of_the_orbit_between_them) {
    Driven driven = {.rig = oscillator_beam_rig("ibs", NULL)};
    driven.force = driven.rig.force;
    driven.clearance = driven.rig.clearance;
    double state[128] = {0};
    CHECK(orbit_map(beam_at(&driven, 210), state, 2000, NULL, NULL) == ORBIT_GOOD);
    FollowFamily family = {.at = beam_at, .context = &driven, .from = 209, .to = 213};
    FollowBranch pair, own;
    CHECK(follow_run(&pair, &family, 210, state, 1, 0.05, NULL));
    size_t last = pair.count - 1;
    CHECK(pair.above == FOLLOW_IMAGE && pair.below == FOLLOW_RANGE && !find_point(&pair, FOLLOW_FOLD, 0));
    CHECK(pair.points[last].kind == FOLLOW_PITCHFORK && image_at(&driven, &pair, 0) == ORBIT_IMAGE_OTHER);
    check_point(&pair, FOLLOW_PITCHFORK, 0, 211.13579, 1e-5);
    CHECK(follow_branch_off(&own, &family, &pair, last, 0.05, NULL));
    CHECK(own.below == FOLLOW_RANGE && own.above == FOLLOW_RANGE);
    check_point(&own, FOLLOW_PITCHFORK, 0, pair.points[last].value, 1e-5);
    for (size_t i = 0; i < own.count; i++)
        if (own.points[i].kind == FOLLOW_STEP) {
            CHECK(image_at(&driven, &own, i) == ORBIT_IMAGE_OWN);
            CHECK(own.points[i].stable == (own.points[i].value > pair.points[last].value));
        }
    follow_clear(&own);
    follow_clear(&pair);
    end(&driven);
}

/* A pitchfork whose pair is unstable lies close to the curve of the pair, where Newton's iteration may end. */
TEST(a_pitchfork_is_located_where_the_curves_that_cross_are_hard_to_keep_apart) {
    Driven driven = {.rig = oscillator_beam_rig("ibs", NULL)};
    driven.force = driven.rig.force;
    driven.clearance = driven.rig.clearance;
    double state[128] = {0};
    FollowFamily family = {.at = beam_at, .context = &driven, .from = 62, .to = 70};
    Orbit orbit;
    FollowBranch branch;
    CHECK(orbit_map(beam_at(&driven, 67), state, 500, NULL, NULL) == ORBIT_GOOD);
    CHECK(orbit_settle(&orbit, beam_at(&driven, 67), state, 1, 1e-2, NULL) == ORBIT_GOOD);
    CHECK(follow_run(&branch, &family, 67, orbit.point, 1, 0.02, NULL));
    check_point(&branch, FOLLOW_PITCHFORK, 0, 64.091645, 1e-5);
    orbit_clear(&orbit);
    follow_clear(&branch);
    end(&driven);
}

/* Carries a motion on at this value for so many cycles and returns the largest force of the last one. */
static double carry_on(Driven *driven, double value, double *state, int cycles) {
    Cycle cycle = beam_at(driven, value);
    CycleMotion motion = cycle_create(cycle, 0, NULL);
    cycle.kind->set_state(motion.own, state);
    double *peak = cycle.kind->peaks(motion.own);
    for (int i = 0; i < cycles; i++) {
        peak[0] = peak[1] = 0;
        CHECK(cycle_run(&motion) == CYCLE_GOOD);
    }
    double largest = fmax(peak[0], peak[1]);
    cycle.kind->state(motion.own, state);
    cycle_destroy(&motion);
    return largest;
}

/* Sweeps from a value on in steps and returns the first value at which the force jumps by more than 5 N. */
static double find_jump(Driven *driven, double from, double step, double *state) {
    double before = carry_on(driven, from, state, 3000);
    for (int i = 1; i < 30; i++) {
        double force = carry_on(driven, from + i * step, state, 3000);
        if (fabs(force - before) > 5)
            return from + i * step;
        before = force;
    }
    return NAN;
}

/* Two stable orbits of period 1 of set B overlap near 276.6 Hz: a sweep leaves either at its fold, within the sweep's
 * step. */
LONG_TEST(sweeps_jump_at_the_folds) {
    const double step = 0.004;
    Driven driven = {.rig = oscillator_beam_rig("ibs", NULL)};
    driven.force = driven.rig.force;
    driven.clearance = driven.rig.clearance;
    double state[128] = {0};
    carry_on(&driven, 276.5, state, 2000);
    FollowFamily family = {.at = beam_at, .context = &driven, .from = 276, .to = 277};
    FollowBranch branch;
    CHECK(follow_run(&branch, &family, 276.5, state, 1, 0.02, NULL));
    check_point(&branch, FOLLOW_FOLD, 0, 276.65797, 1e-4);
    check_point(&branch, FOLLOW_FOLD, 1, 276.63227, 1e-4);
    double folds[2] = {NAN, NAN};
    for (size_t i = 0; i < 2; i++)
        folds[i] = find_point(&branch, FOLLOW_FOLD, i) ? find_point(&branch, FOLLOW_FOLD, i)->value : (double)NAN;
    double up = find_jump(&driven, 276.624, step, state), down = find_jump(&driven, 276.664, -step, state);
    printf("     sweeps jump at %.4f and %.4f Hz, folds at %.5f and %.5f Hz\n", up, down, folds[0], folds[1]);
    CHECK(up > folds[0] && up - folds[0] < step);
    CHECK(down < folds[1] && folds[1] - down < step);
    follow_clear(&branch);
    end(&driven);
}
