/* Tests that kept answers change no bit of any other, and that an edit elsewhere costs no search. */

#include <stdio.h>
#include <string.h>

#include "base/random.h"
#include "case.h"
#include "check.h"
#include "house/journey.h"
#include "route/recall.h"

static bool same_bits(const void *one, const void *other, size_t size) {
    return memcmp(one, other, size) == 0;
}

static bool same_blockage(const Blockage *one, const Blockage *other) {
    return same_bits(&one->at, &other->at, sizeof one->at) && strcmp(one->what, other->what) == 0 &&
           same_bits(&one->has, &other->has, sizeof one->has) &&
           same_bits(&one->needs, &other->needs, sizeof one->needs) && one->estimated == other->estimated &&
           same_bits(&one->skid, &other->skid, sizeof one->skid);
}

static bool same_route(const Route *one, const Route *other) {
    if (one->answer != other->answer || one->fits != other->fits || one->reversals != other->reversals ||
        one->exit != other->exit || one->count != other->count || !same_blockage(&one->blockage, &other->blockage))
        return false;
    for (size_t i = 0; i < one->count; i++) {
        const Pose *p = &one->poses[i], *q = &other->poses[i];
        if (!same_bits(&p->at, &q->at, sizeof p->at) || !same_bits(&p->heading, &q->heading, sizeof p->heading) ||
            !same_bits(&p->clearance, &q->clearance, sizeof p->clearance) || p->direction != q->direction)
            return false;
    }
    return true;
}

/* Plans with kept answers on two threads and without on one, and returns the number of people with other routes. */
static size_t differences(const House *house, bool brief, Recall *recall) {
    Journeys kept = journey_plan_recalling(house, NULL, brief, recall, NULL, 2, NULL);
    Journeys fresh = (brief ? journey_plan_briefly : journey_plan_all)(house, NULL, 1, NULL);
    size_t count = 0;
    for (size_t i = 0; i < kept.count; i++)
        count += !same_route(&kept.of[i].route, &fresh.of[i].route);
    journey_free_all(&kept);
    journey_free_all(&fresh);
    return count;
}

/* Edits a shipped house `edits` times, each time from the file, and returns the number of other routes. */
static size_t edit(const char *name, const char *const *rows, size_t row_count, const double (*ranges)[2], int edits,
                   bool brief, uint64_t seed, Recall *recall) {
    Random random = random_seed(seed, 1);
    size_t count = 0;
    for (int i = 0; i < edits; i++) {
        char settings[2][64];
        const char *given[] = {settings[0], settings[1], NULL};
        for (int s = 0; s < 2; s++) {
            size_t row = (size_t)(random_uniform(&random) * (double)row_count);
            double value = ranges[row][0] + random_uniform(&random) * (ranges[row][1] - ranges[row][0]);
            snprintf(settings[s], sizeof settings[s], "%s=%.2f", rows[row], value);
        }
        House house;
        case_house(&house, name, -1, given);
        count += differences(&house, brief, recall);
        house_free(&house);
    }
    return count;
}

TEST(kept_answers_change_no_bit) {
    static const char *const rows[] = {"furniture.wardrobe.centre.x", "furniture.wardrobe.centre.y",
                                       "furniture.sofa.centre.x",     "furniture.sofa.centre.y",
                                       "furniture.wardrobe.angle",    "door.d4.width"};
    static const double ranges[][2] = {{9.0, 9.4}, {8.4, 8.74}, {3.7, 4.1}, {2.9, 3.1}, {0, 90}, {0.7, 0.85}};
    Recall *recall = recall_create();
    CHECK(edit("ube-techno-house", rows, 6, ranges, 12, true, 5, recall) == 0);
    CHECK(recall_found(recall) > 4);
    recall_destroy(recall);
}

TEST(kept_answers_change_no_bit_of_a_reason) {
    static const char *const rows[] = {"furniture.desk.centre.x", "furniture.wardrobe.centre.x",
                                       "furniture.sofa.centre.y", "door.d3.width"};
    static const double shifts[][2] = {{-0.1, 0.1}, {-0.1, 0.1}, {-0.1, 0.1}, {0.7, 0.84}};
    House house;
    double ranges[4][2];
    case_house(&house, "flat-0.910-module", -1, NULL);
    for (int r = 0; r < 4; r++) {
        const void *object;
        Fault fault = {0};
        const Parameter *row = house_parameter(&house, rows[r], &object, "", &fault);
        double value = r < 3 ? *(const double *)((const char *)object + row->offset) : 0;
        ranges[r][0] = value + shifts[r][0];
        ranges[r][1] = value + shifts[r][1];
    }
    house_free(&house);
    Recall *recall = recall_create();
    for (int times = 0; times < 2; times++) /* the second time everything is known */
        CHECK(edit("flat-0.910-module", rows, 4, (const double(*)[2])ranges, 2, true, 9, recall) == 0);
    CHECK(edit("flat-0.910-module", rows, 3, (const double(*)[2])ranges, 1, false, 9, recall) == 0);
    CHECK(recall_found(recall) > 0);
    recall_destroy(recall);
}

TEST(a_piece_moved_where_nobody_looks_costs_no_search) {
    Recall *recall = recall_create();
    for (int move = 0; move < 4; move++) {
        char setting[64];
        House house;
        snprintf(setting, sizeof setting, "furniture.wardrobe.centre.y=%.2f", 8.74 - 0.05 * move);
        case_house(&house, "ube-techno-house", -1, (const char *const[]){setting, NULL});
        CHECK(differences(&house, true, recall) == 0);
        CHECK(recall_found(recall) == 4 * (size_t)move);
        house_free(&house);
    }
    recall_destroy(recall);
}
