/* Tests runs in which the plan changes: paths continue, people leave, and no edit breaks an invariant. */

#include "house/change.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/random.h"
#include "case.h"
#include "check.h"
#include "house/run.h"

enum { HOUSES = 5 };

/* The house and its later versions. */
typedef struct Story {
    House houses[HOUSES];
    double times[HOUSES]; /* s; 0 for the first */
    size_t count;
} Story;

static Observation run_story(const Story *story, int jobs) {
    RunChange changes[HOUSES];
    for (size_t c = 1; c < story->count; c++)
        changes[c - 1] = (RunChange){story->times[c], &story->houses[c]};
    RunOptions options = {.route = SIZE_MAX, .jobs = jobs, .changes = changes, .change_count = story->count - 1};
    Observation observation;
    run_house(&observation, &story->houses[0], &options);
    CHECK(observation.mixed_count < story->count);
    CHECK(observation.person_count == story->houses[story->count - 1].person_count);
    return observation;
}

static void end_story(Story *story, Observation *observation) {
    observation_free(observation);
    for (size_t h = 0; h < story->count; h++)
        house_free(&story->houses[h]);
    story->count = 0;
}

static void add_house(Story *story, double time, const char *name, const char *const *settings) {
    case_house(&story->houses[story->count], name, -1, settings);
    story->times[story->count++] = time;
}

static void add_made(Story *story, double time, json_t *plan, const char *const *settings) {
    case_made(&story->houses[story->count], plan, -1, settings);
    story->times[story->count++] = time;
}

/* Compares the rows of the traces up to `time`, bit by bit. */
static void check_prefix(const Observation *changed, const Observation *unchanged, double time) {
    size_t a = 0, b = 0, same = 0;
    for (;;) {
        while (a < changed->trace.rows && trace_row(&changed->trace, a)[TRACE_TIME] > time)
            a++;
        while (b < unchanged->trace.rows && trace_row(&unchanged->trace, b)[TRACE_TIME] > time)
            b++;
        if (a == changed->trace.rows || b == unchanged->trace.rows)
            break;
        size_t size = TRACE_COLUMNS * sizeof(double);
        same += memcmp(trace_row(&changed->trace, a++), trace_row(&unchanged->trace, b++), size) == 0;
    }
    size_t rows = 0;
    for (size_t r = 0; r < unchanged->trace.rows; r++)
        rows += trace_row(&unchanged->trace, r)[TRACE_TIME] <= time;
    CHECK(a == changed->trace.rows && b == unchanged->trace.rows);
    CHECK(rows > 0 && same == rows);
}

static void check_numbers(const Observation *observation) {
    size_t lost = 0;
    for (size_t r = 0; r < observation->trace.rows; r++)
        for (int c = 0; c < TRACE_OFFSET; c++)
            lost += !isfinite(trace_row(&observation->trace, r)[c]);
    CHECK(lost == 0);
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        CHECK(isfinite(person->time) && isfinite(person->lost_time) && isfinite(person->path_length));
        CHECK(person->reason != REASON_DIVERGED);
        CHECK(!person->completed || person->reason == REASON_NONE);
    }
}

TEST(the_same_house_again_lets_everybody_out) {
    static const char *const names[] = {"ube-techno-house", "two-chairs-corridor", "closed-door", "corner-1.00-1.00"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        Story story = {0};
        add_house(&story, 0, names[n], NULL);
        Observation alone = case_run(&story.houses[0], 1);
        add_house(&story, 4.3, names[n], NULL);
        Observation mixed = run_story(&story, 1);
        CHECK(mixed.completed && mixed.mixed_count == 1);
        CHECK_NEAR(mixed.mixed[0], 4.3, 1e-9);
        CHECK_NEAR(mixed.time, alone.time, 0.1 * alone.time);
        CHECK(mixed.digest != alone.digest);
        check_prefix(&mixed, &alone, 4.3);
        check_numbers(&mixed);
        observation_free(&alone);
        end_story(&story, &mixed);
    }
}

TEST(a_change_after_the_end_of_time_changes_nothing) {
    Story story = {0};
    add_house(&story, 0, "corner-0.90-0.90", (const char *[]){"run.until=5", NULL});
    Observation alone = case_run(&story.houses[0], 1);
    add_house(&story, 5, "corner-1.20-1.20", NULL);
    Observation mixed = run_story(&story, 1);
    CHECK(mixed.mixed_count == 0 && mixed.digest == alone.digest && mixed.trace.rows == alone.trace.rows);
    CHECK(mixed.people[0].reason == REASON_TIME_LIMIT);
    observation_free(&alone);
    end_story(&story, &mixed);
}

TEST(a_door_that_is_widened_or_unlocked_lets_out_who_was_stuck) {
    static const char *const before[] = {"door.d1.width=0.5", "door.d1.state=locked"};
    for (int i = 0; i < 2; i++) {
        const char *profile = i ? "person.p1.profile=manual-chair" : "person.p1.profile=miura-chair";
        Story story = {0};
        add_house(&story, 0, "closed-door", (const char *[]){before[i], profile, NULL});
        Observation alone = case_run(&story.houses[0], 1);
        CHECK(!alone.completed && alone.people[0].reason == REASON_CANNOT_PASS);
        add_house(&story, 3, "closed-door", (const char *[]){profile, NULL});
        Observation mixed = run_story(&story, 1);
        CHECK(mixed.completed && mixed.people[0].reason == REASON_NONE);
        CHECK(mixed.people[0].lost_time > 3);
        observation_free(&alone);
        Observation clean = case_run(&story.houses[1], 1);
        CHECK_NEAR(mixed.time, clean.time + 3, 1);
        observation_free(&clean);
        end_story(&story, &mixed);
    }
}

TEST(a_door_that_was_opened_stays_open) {
    Story story = {0};
    add_house(&story, 0, "closed-door", NULL);
    Observation alone = case_run(&story.houses[0], 1);
    add_house(&story, alone.door_opened[0] + 0.5, "closed-door", NULL);
    Observation mixed = run_story(&story, 1);
    CHECK(mixed.completed && mixed.door_opened[0] == alone.door_opened[0]);
    CHECK_NEAR(mixed.time, alone.time, 1);
    observation_free(&alone);
    end_story(&story, &mixed);
}

/* Returns the plan with its door closed. */
static json_t *corridor_with(const char *profile, double width, bool dropped, double x, double y, double sx,
                             double sy) {
    json_t *plan = case_corridor(width);
    case_add_person(plan, profile, 1, 0, 0);
    json_array_append_new(json_object_get(plan, "walls"),
                          json_pack("{s:s, s:[[f,f],[f,f]]}", "id", "west", "points", 0.0, -width / 2, 0.0, width / 2));
    if (dropped)
        json_object_set_new(plan, "furniture",
                            json_pack("[{s:s, s:s, s:[f,f], s:[f,f]}]", "id", "f1", "name", "wardrobe", "centre", x, y,
                                      "size", sx, sy));
    return plan;
}

static const char *const movers[] = {"manual-chair", "miura-chair", "adult"};

TEST(a_wardrobe_on_the_way_is_driven_round) {
    for (int m = 0; m < 3; m += 2) { /* the paper's disc also sticks there in a constant plan */
        Story story = {0};
        add_made(&story, 0, corridor_with(movers[m], 2.6, false, 0, 0, 0, 0), NULL);
        add_made(&story, 3, corridor_with(movers[m], 2.6, true, 9, 0.6, 0.6, 1.2), NULL);
        Observation mixed = run_story(&story, 1);
        CHECK(mixed.completed && mixed.wall_crossings == 0);
        CHECK(mixed.people[0].peak_force < 200);

        size_t inside = 0;
        for (size_t r = 0; r < mixed.trace.rows; r++) {
            const double *row = trace_row(&mixed.trace, r);
            inside += fabs(row[TRACE_X] - 9) < 0.3 && fabs(row[TRACE_Y] - 0.6) < 0.6;
        }
        CHECK(inside == 0);
        end_story(&story, &mixed);
    }
}

TEST(a_wardrobe_across_the_way_is_reported) {
    Story story = {0};
    add_made(&story, 0, corridor_with("miura-chair", 2.6, false, 0, 0, 0, 0), NULL);
    add_made(&story, 3, corridor_with("miura-chair", 2.6, true, 9, -0.15, 0.6, 2.1), NULL);
    Observation mixed = run_story(&story, 1);
    CHECK(!mixed.completed && mixed.people[0].reason == REASON_CANNOT_PASS);
    CHECK_NEAR(mixed.people[0].blockage.has, 0.4, 0.02);
    CHECK_NEAR(mixed.people[0].blockage.at.x, 9, 0.5);
    CHECK_NEAR(mixed.people[0].time, 3, 1e-9);
    end_story(&story, &mixed);
}

/* Returns the place of person 0 at a time, m along the corridor. */
static double place_at(const Observation *observation, double time) {
    double x = 0;
    for (size_t r = 0; r < observation->trace.rows; r++)
        if (trace_row(&observation->trace, r)[TRACE_TIME] <= time)
            x = trace_row(&observation->trace, r)[TRACE_X];
    return x;
}

TEST(who_stands_in_a_wardrobe_is_held_by_it_until_it_is_moved_away) {
    for (int m = 0; m < 3; m++)
        for (int small = 0; small < 2; small++) {
            Story story = {0};
            add_made(&story, 0, corridor_with(movers[m], 2.6, false, 0, 0, 0, 0), NULL);
            Observation alone = case_run(&story.houses[0], 1);
            double x = place_at(&alone, 3), size = small ? 0.5 : 1.9;
            observation_free(&alone);
            add_made(&story, 3, corridor_with(movers[m], 2.6, true, x + 0.2, 0.1, size, size), NULL);
            Observation held = run_story(&story, 1);
            CHECK(!held.completed && held.people[0].reason == REASON_CANNOT_PASS);
            CHECK_TEXT(held.people[0].blockage.what, "start, inside wardrobe (f1)");
            check_numbers(&held);
            CHECK_NEAR(place_at(&held, 100), x, 0.01);
            observation_free(&held);
            add_made(&story, 7, corridor_with(movers[m], 2.6, true, 5, -1, 0.3, 0.3), NULL);
            Observation freed = run_story(&story, 1);
            CHECK(freed.completed && freed.mixed_count == 2);
            CHECK(freed.people[0].time > 7);
            CHECK(freed.people[0].peak_force < 200);
            end_story(&story, &freed);
        }
}

TEST(a_door_does_not_shut_on_whoever_stands_in_it) {
    static const char *const open[] = {"door.d1.state=open", NULL};
    Story story = {0};
    add_house(&story, 0, "closed-door", open);
    Observation alone = case_run(&story.houses[0], 1);
    double through = 0;
    for (size_t r = 0; r < alone.trace.rows && !(through > 0); r++)
        if (trace_row(&alone.trace, r)[TRACE_X] > 3.4)
            through = trace_row(&alone.trace, r)[TRACE_TIME];
    add_house(&story, through, "closed-door", NULL);
    Observation mixed = run_story(&story, 1);
    CHECK(mixed.completed);
    CHECK_NEAR(mixed.time, alone.time, 1);
    observation_free(&alone);
    end_story(&story, &mixed);
}

TEST(an_exit_that_is_shut_is_turned_away_from) {
    for (int other = 0; other < 2; other++) {
        Story story = {0};
        for (int shut = 0; shut < 2; shut++) {
            json_t *plan = case_corridor(2.6), *exits = json_object_get(plan, "exits");
            case_add_person(plan, "manual-chair", 12, 0, 0);
            json_array_append_new(exits,
                                  json_pack("{s:s, s:[f,f], s:[f,f]}", "id", "e2", "from", 2.0, -1.3, "to", 2.0, 1.3));
            if (!other)
                json_array_remove(exits, 1);
            if (shut)
                json_array_remove(exits, 0);
            add_made(&story, 3 * shut, plan, NULL);
        }
        Observation mixed = run_story(&story, 1);
        if (other)
            CHECK(mixed.completed && mixed.people[0].exit == 0 && mixed.people[0].path_length > 10);
        else
            CHECK(!mixed.completed && mixed.people[0].reason == REASON_NO_EXIT);
        end_story(&story, &mixed);
    }
}

static json_t *corridor_of(const char *const *ids, size_t count) {
    json_t *plan = case_corridor(2.6);
    for (size_t i = 0; i < count; i++) {
        case_add_person(plan, "adult", 1 + 2 * (double)(ids[i][0] - 'a'), 0, 0);
        json_t *people = json_object_get(plan, "people");
        json_object_set_new(json_array_get(people, json_array_size(people) - 1), "id", json_string(ids[i]));
    }
    return plan;
}

TEST(people_come_and_go) {
    Story story = {0};
    add_made(&story, 0, corridor_of((const char *[]){"b", "c", "e"}, 3), NULL);
    add_made(&story, 2, corridor_of((const char *[]){"a", "c", "d", "e"}, 4),
             (const char *[]){"person.a.delay=1.5", NULL});
    add_made(&story, 60, corridor_of((const char *[]){"c", "e"}, 2), NULL);
    Observation alone = case_run(&story.houses[0], 1);
    Observation mixed = run_story(&story, 1);
    CHECK(mixed.completed && mixed.person_count == 2 && mixed.mixed_count == 2);
    for (int p = 0; p < 2; p++) {
        CHECK(mixed.people[p].took_part && mixed.people[p].completed && mixed.people[p].time < 60);
        CHECK_NEAR(mixed.people[p].time, alone.people[p + 1].time, 0.5);
    }
    observation_free(&mixed);
    story.count = 2;
    mixed = run_story(&story, 1);
    CHECK(mixed.completed && mixed.person_count == 4);
    double least[4] = {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL}, moves = HUGE_VAL;
    for (size_t r = 0; r < mixed.trace.rows; r++) {
        const double *row = trace_row(&mixed.trace, r);
        size_t person = (size_t)row[TRACE_PERSON];
        CHECK(person < 4);
        least[person] = fmin(least[person], row[TRACE_TIME]);
        if (person == 0 && row[TRACE_X] > 1.01)
            moves = fmin(moves, row[TRACE_TIME]);
    }
    CHECK(least[1] == 0 && least[3] == 0);
    CHECK_NEAR(least[0], 2, 1e-9);
    CHECK_NEAR(least[2], 2, 1e-9);
    CHECK(moves > 3.5 && moves < 4); /* the delay counts from when the person came */
    observation_free(&alone);
    story.count = 3;
    end_story(&story, &mixed);
}

/* The joined parts name all people of the house that they refer to. */
typedef struct Pieces {
    const Story *story;
    size_t rows[HOUSES];
    bool over;
} Pieces;

static void take_piece(void *context, const RunPiece *piece) {
    Pieces *pieces = context;
    size_t h = (size_t)(piece->house - pieces->story->houses);
    CHECK(h < pieces->story->count && !pieces->over);
    for (size_t r = 0; r < piece->row_count; r++) {
        const double *row = piece->rows + r * TRACE_COLUMNS;
        CHECK(row[TRACE_PERSON] < (double)piece->house->person_count);
        CHECK(row[TRACE_TIME] >= pieces->story->times[h]);
        CHECK(h + 1 >= pieces->story->count || row[TRACE_TIME] <= pieces->story->times[h + 1] + 1e-3);
    }
    pieces->rows[h] += piece->row_count;
    pieces->over = piece->over;
}

TEST(pieces_of_a_record_say_of_which_house_they_are) {
    Story story = {0};
    add_made(&story, 0, corridor_of((const char *[]){"b", "c", "e"}, 3), NULL);
    add_made(&story, 2.0004, corridor_of((const char *[]){"a", "c", "d", "e"}, 4), NULL);
    Pieces pieces = {.story = &story};
    RunChange change = {story.times[1], &story.houses[1]};
    Observation observation;
    run_house(&observation, &story.houses[0],
              &(RunOptions){.route = SIZE_MAX,
                            .jobs = 1,
                            .record = take_piece,
                            .context = &pieces,
                            .changes = &change,
                            .change_count = 1});
    size_t early = 0;
    for (size_t r = 0; r < observation.trace.rows; r++)
        early += trace_row(&observation.trace, r)[TRACE_TIME] <= story.times[1];
    CHECK(pieces.over && pieces.rows[0] > early && early > 0); /* people who have left are not in the last part */
    CHECK(pieces.rows[1] == observation.trace.rows - early);
    CHECK_NEAR(observation.mixed[0], 2.001, 1e-9);
    end_story(&story, &observation);
}

TEST(groups_change_at_the_same_time_and_any_number_of_jobs_gives_the_same) {
    Story story = {0};
    add_house(&story, 0, "ube-techno-house", NULL);
    add_house(&story, 2.5, "ube-techno-house", (const char *[]){"furniture.sofa.centre.x=3.9", NULL});
    add_house(&story, 6, "ube-techno-house", (const char *[]){"furniture.sofa.centre.x=4", "door.d4.width=0.6", NULL});
    Observation one = run_story(&story, 1), four = run_story(&story, 4);
    CHECK(one.digest == four.digest && one.trace.rows == four.trace.rows && one.mixed_count == 2);
    CHECK(memcmp(one.trace.values, four.trace.values, one.trace.rows * TRACE_COLUMNS * sizeof(double)) == 0);
    check_numbers(&one);
    observation_free(&four);
    end_story(&story, &one);
}

LONG_TEST(a_crowd_goes_on_whatever_the_number_of_jobs) {
    static const char *const until[] = {"run.until=3", NULL};
    Story story = {0};
    add_house(&story, 0, "shopping-centre", until);
    add_house(&story, 1.5, "shopping-centre", until);
    Observation alone = case_run(&story.houses[0], 4), one = run_story(&story, 1), four = run_story(&story, 4);
    CHECK(one.digest == four.digest && one.trace.rows == four.trace.rows && one.mixed_count == 1);
    CHECK(one.people[7].path_length > 0 && one.wall_crossings == 0);
    size_t held = 0; /* a person pressed against a wall is not counted as inside it */
    for (size_t i = 0; i < one.person_count; i++)
        held += one.people[i].reason == REASON_CANNOT_PASS && alone.people[i].reason != REASON_CANNOT_PASS;
    CHECK(held == 0);
    check_prefix(&one, &alone, 1.5);
    check_numbers(&one);
    observation_free(&alone);
    observation_free(&four);
    end_story(&story, &one);
}

/* Random edits ------------------------------------------------------------------------------------------------------*/

static double between(Random *random, double low, double high) {
    return low + (high - low) * random_uniform(random);
}

static size_t below(Random *random, size_t count) {
    return (size_t)(random_uniform(random) * (double)count);
}

static json_t *pick(Random *random, json_t *plan, const char *list) {
    json_t *array = json_object_get(plan, list);
    return json_array_size(array) ? json_array_get(array, below(random, json_array_size(array))) : NULL;
}

static void add_to(json_t *plan, const char *list, json_t *element) {
    if (!json_object_get(plan, list))
        json_object_set_new(plan, list, json_array());
    json_array_append_new(json_object_get(plan, list), element);
}

static json_t *somewhere(Random *random) {
    return json_pack("[f,f]", between(random, -1, 6), between(random, -1, 6));
}

static const char *any_profile(Random *random) {
    static const char *const profiles[] = {"elderly", "miura-chair", "adult", "child"};
    return profiles[below(random, sizeof profiles / sizeof *profiles)];
}

static void edit(Random *random, json_t *plan, int n) {
    static const char *const states[] = {"open", "closed", "locked"};
    static const char *const lists[] = {"furniture", "people", "exits", "doors", "walls"};
    json_t *piece = pick(random, plan, "furniture"), *door = pick(random, plan, "doors"),
           *exit = pick(random, plan, "exits");
    json_t *person = pick(random, plan, "people");
    char id[16];
    snprintf(id, sizeof id, "n%d", n);
    switch (below(random, 11)) {
    case 0:
    case 1:
        add_to(plan, "furniture",
               json_pack("{s:s, s:o, s:[f,f], s:f}", "id", id, "centre", somewhere(random), "size",
                         between(random, 0.2, 2), between(random, 0.2, 2), "angle", between(random, -180, 180)));
        break;
    case 2:
    case 3:
        if (piece)
            json_object_set_new(piece, "centre", somewhere(random));
        break;
    case 4:
        if (door)
            json_object_set_new(door, "width", json_real(between(random, 0.4, 1.2)));
        break;
    case 5:
        if (door)
            json_object_set_new(door, "state", json_string(states[below(random, 3)]));
        break;
    case 6:
        add_to(plan, "people",
               json_pack("{s:s, s:s, s:o, s:f, s:f}", "id", id, "profile", any_profile(random), "at", somewhere(random),
                         "heading", between(random, -180, 180), "delay", between(random, 0, 3)));
        break;
    case 7:
        if (person)
            json_object_set_new(person, "profile", json_string(any_profile(random)));
        break;
    case 8:
        if (exit)
            json_object_set_new(exit, "closes", json_real(between(random, 1, 20)));
        break;
    case 9:
        add_to(plan, "exits",
               json_pack("{s:s, s:o, s:o}", "id", id, "from", somewhere(random), "to", somewhere(random)));
        break;
    default: {
        json_t *list = json_object_get(plan, lists[below(random, 5)]);
        if (json_array_size(list))
            json_array_remove(list, below(random, json_array_size(list)));
    }
    }
}

/* False: the plan is invalid. */
static bool add_edited(Story *story, double time, const json_t *plan) {
    char *text = json_dumps(plan, JSON_REAL_PRECISION(17)), profiles[4096];
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    HouseOptions options = {.profiles = profiles, .seed = 1, .driving = -1};
    bool good = house_read_text(&story->houses[story->count], "edited.json", text, &options, &fault);
    fault_clear(&fault);
    memory_free(text);
    if (good)
        story->times[story->count++] = time;
    return good;
}

LONG_TEST(no_edit_breaks_a_run) {
    enum { STORIES = 12 };
    size_t edited = 0;
    for (int s = 0; s < STORIES; s++) {
        Random random = random_seed(7, (uint64_t)s);
        json_t *plan = case_plan("closed-door");
        add_to(plan, "people", json_pack("{s:s, s:s, s:[f,f]}", "id", "p2", "profile", "adult", "at", 3.0, 2.2));
        add_to(plan, "people", json_pack("{s:s, s:s, s:[f,f]}", "id", "p3", "profile", "miura-chair", "at", 2.7, 1.4));
        json_object_set_new(plan, "run", json_pack("{s:f, s:f}", "until", 8.0, "patience", 3.0));
        if (s % 4) /* few edits with a chair that plans its route, since an impossible route takes long */
            json_object_set_new(json_array_get(json_object_get(plan, "people"), 0), "profile", json_string("elderly"));
        Story story = {0};
        add_edited(&story, 0, plan);
        double time = 0;
        for (int n = 0; n < 12 && story.count < HOUSES; n++) {
            json_t *tried = json_deep_copy(plan);
            for (size_t k = 0; k <= below(&random, 3); k++)
                edit(&random, tried, 10 * n + (int)k);
            time += between(&random, 0.2, 2);
            bool good = add_edited(&story, time, tried);
            json_decref(good ? plan : tried);
            plan = good ? tried : plan;
        }
        json_decref(plan);
        edited += story.count - 1;
        Observation alone = case_run(&story.houses[0], 1), mixed = run_story(&story, 1), again = run_story(&story, 2);
        CHECK(mixed.digest == again.digest && mixed.trace.rows == again.trace.rows);
        check_numbers(&mixed);
        bool same = mixed.person_count == alone.person_count; /* people would have other indices otherwise */
        for (size_t i = 0; same && i < mixed.person_count; i++)
            same = strcmp(story.houses[0].people[i].id, story.houses[story.count - 1].people[i].id) == 0;
        if (same && mixed.mixed_count)
            check_prefix(&mixed, &alone, mixed.mixed[0] - 1e-9);
        observation_free(&alone);
        observation_free(&again);
        end_story(&story, &mixed);
    }
    CHECK(edited > 2 * STORIES);
}
