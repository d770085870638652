/* Tests whole runs: delays, doors, exits, people in the way, and their observation. */

#include "house/run.h"

#include <pthread.h>
#include <stdint.h>
#include <string.h>

#include "case.h"
#include "check.h"
#include "house/observer.h"
#include "house/step.h"
#include "house/world.h"

static Observation run_corridor(double width, const char *const *settings, House *house) {
    json_t *plan = case_corridor(width);
    case_add_person(plan, "manual-chair", 1, 0, 0);
    case_made(house, plan, -1, settings);
    return case_run(house, 1);
}

TEST(a_delay_is_waited_for) {
    House house;
    Observation now = run_corridor(2, NULL, &house);
    house_free(&house);
    Observation later = run_corridor(2, (const char *[]){"person.p1.delay=7.5", NULL}, &house);
    CHECK(now.completed && later.completed);
    CHECK_NEAR(later.time - now.time, 7.5, 2e-3);
    CHECK_NEAR(later.people[0].lost_time, now.people[0].lost_time, 2e-3);
    observation_free(&now);
    observation_free(&later);
    house_free(&house);
}

TEST(a_closed_door_costs_its_time_once) {
    static const char *const times[] = {"door.d1.opening_time=2", "door.d1.opening_time=6"};
    double seconds[2];
    for (int i = 0; i < 2; i++) {
        House house;
        case_house(&house, "closed-door", -1, (const char *[]){times[i], NULL});
        Observation observation = case_run(&house, 1);
        CHECK(observation.completed);
        seconds[i] = observation.time;
        observation_free(&observation);
        house_free(&house);
    }
    CHECK_NEAR(seconds[1] - seconds[0], 4, 0.05);
}

TEST(an_exit_is_waited_for_until_it_opens) {
    House house;
    Observation observation = run_corridor(2, (const char *[]){"exit.e1.opens=60", NULL}, &house);
    CHECK(observation.completed);
    CHECK(observation.time > 60 && observation.time < 62);
    observation_free(&observation);
    house_free(&house);
}

TEST(whoever_comes_after_the_exit_has_closed_is_told_so) {
    House house;
    Observation observation = run_corridor(2, (const char *[]){"exit.e1.closes=5", NULL}, &house);
    CHECK(!observation.completed && observation.people[0].reason == REASON_NO_EXIT);
    observation_free(&observation);
    house_free(&house);
}

TEST(who_starts_on_the_line_of_another_exit_gets_out) {
    House house;
    json_t *plan = case_corridor(2), *exits = json_object_get(plan, "exits");
    case_add_person(plan, "manual-chair", 1, 0, 0);
    json_array_append_new(exits, json_pack("{s:s, s:[f, f], s:[f, f]}", "id", "e2", "from", 1.0, 0.5, "to", 1.0, 0.9));
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed);
    observation_free(&observation);
    house_free(&house);
}

TEST(a_time_limit_ends_the_run) {
    House house;
    Observation observation = run_corridor(2, (const char *[]){"run.until=3", NULL}, &house);
    CHECK(observation.people[0].reason == REASON_TIME_LIMIT);
    CHECK_NEAR(observation.people[0].time, 3, 2e-3);
    observation_free(&observation);
    house_free(&house);
}

TEST(two_who_meet_swerve_and_pass) {
    House house;
    case_house(&house, "two-chairs-corridor", -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed);
    CHECK(observation.people[0].contacts == 0 && observation.people[1].contacts == 0);
    CHECK(observation.people[0].exit != observation.people[1].exit);
    observation_free(&observation);
    house_free(&house);
}

/* Chairs that catch on a jamb or on each other back off, and the one nearer to the exit goes first. */
TEST(eight_chairs_get_through_a_narrow_door) {
    const double backs[] = {7.7, 7.6, 7.3, 7.0};
    for (size_t k = 0; k < sizeof backs / sizeof *backs; k++) {
        double back = backs[k];
        json_t *plan = case_corridor(8);
        json_object_set_new(plan, "crowds",
                            json_pack("[{s:s, s:s, s:i, s:[[f,f],[f,f],[f,f],[f,f]]}]", "id", "c", "profile",
                                      "electric-chair", "count", 8, "area", back, -3.5, 14.5, -3.5, 14.5, 3.5, back,
                                      3.5));
        json_array_append_new(json_object_get(plan, "walls"),
                              json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", "across", "points", 16.1, -4.1, 16.1, 4.1,
                                        "thickness", 0.2));
        json_object_set_new(
            plan, "doors",
            json_pack("[{s:s, s:s, s:f, s:f}]", "id", "neck", "wall", "across", "at", 4.1, "width", 0.8));
        House house;
        case_made(&house, plan, -1, NULL);
        Observation observation = case_run(&house, 1);
        CHECK(observation.completed);
        observation_free(&observation);
        house_free(&house);
    }
}

/* A person parked behind a wall has no effect: the run is the same to the last bit. */
TEST(nobody_is_minded_through_a_wall) {
    double times[2], narrowest[2];
    for (int parked = 0; parked < 2; parked++) {
        House house;
        json_t *plan = case_corridor(1.0);
        case_add_person(plan, "manual-chair", 1, 0, 0);
        if (parked)
            case_add_person(plan, "manual-chair", 9, -1.1, 0);
        case_made(&house, plan, -1, (const char *[]){parked ? "person.p2.delay=1000" : "run.until=600", NULL});
        bool part[2] = {true, true};
        Journeys journeys = journey_plan_all(&house, part, 1, NULL);
        World world = world_create(&house, journeys.of, part);
        narrowest[parked] = 1;
        while (world.phase[0] == PHASE_WAITING || world.phase[0] == PHASE_MOVING) {
            step_world(&world, NULL);
            narrowest[parked] = fmin(narrowest[parked], world.sense[0].clearance);
        }
        CHECK(world.phase[0] == PHASE_OUT);
        times[parked] = world.ended[0];
        world_destroy(&world);
        journey_free_all(&journeys);
        house_free(&house);
    }
    CHECK(times[0] == times[1]);
    CHECK(narrowest[0] == narrowest[1]);
}

/* A chair far beyond its limits: into a thin wall at 5 m/s, pushed with 2 kN. */
TEST(nobody_is_driven_through_a_wall) {
    static const double thicknesses[] = {0, 0.04, 0.12};
    for (int t = 0; t < 3; t++) {
        House house;
        json_t *plan = case_corridor(3);
        json_array_append_new(json_object_get(plan, "walls"),
                              json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", "end", "points", 10.0, -1.5, 10.0, 1.5,
                                        "thickness", thicknesses[t]));
        case_add_person(plan, "manual-chair", 8, 0, 0);
        case_made(&house, plan, -1,
                  (const char *[]){"profile.manual-chair.push=0", "profile.manual-chair.side_friction=0", NULL});
        Journey journey = {.route = {.answer = ROUTE_NO_EXIT}};
        World world = world_create(&house, &journey, NULL);
        world.velocity[0] = vec2(5, 0);
        for (int step = 0; step < 5000; step++) {
            world.velocity[0].x += 2000 / house.people[0].profile->mass * world.clock.dt;
            step_world(&world, NULL);
        }
        CHECK(world.centre[0].x < 10);
        world_destroy(&world);
        house_free(&house);
    }
}

TEST(numbers_that_diverge_stop_the_run_and_name_the_person) {
    House house;
    json_t *plan = case_corridor(2);
    case_add_person(plan, "manual-chair", 1, 0, 0);
    case_made(&house, plan, -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    World world = world_create(&house, journeys.of, NULL);
    step_world(&world, NULL);
    Vec2 good = world.centre[0];
    world.velocity[0] = vec2(1e12, 0);
    size_t who = SIZE_MAX;
    CHECK(step_world(&world, &who) == STEP_DIVERGED);
    CHECK(who == 0 && world.phase[0] == PHASE_STUCK && world.reason[0] == REASON_DIVERGED);
    CHECK(world.centre[0].x == good.x && world.centre[0].y == good.y); /* the last valid state */
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
}

TEST(when_one_person_diverges_the_others_are_not_called_interrupted) {
    House house;
    json_t *plan = case_corridor(2);
    case_add_person(plan, "manual-chair", 1, 0, 0);
    case_add_person(plan, "manual-chair", 3, 0, 0);
    case_made(&house, plan, -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    World world = world_create(&house, journeys.of, NULL);
    PersonObservation people[2] = {{.took_part = false}};
    Observer observer;
    observer_init(&observer, &world, people);
    step_world(&world, NULL);
    world.velocity[0] = vec2(1e12, 0);
    CHECK(step_world(&world, NULL) == STEP_DIVERGED);
    observer_end(&observer, REASON_OTHER_DIVERGED);
    CHECK(people[0].reason == REASON_DIVERGED && people[1].reason == REASON_OTHER_DIVERGED);
    CHECK_TEXT(observation_reason(people[1].reason), "another person diverged");
    observer_clear(&observer);
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
}

TEST(a_hazard_is_where_the_passage_is_narrow) {
    House house;
    case_house(&house, "bedroom-after-earthquake", -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed && observation.hazard_count > 0);
    CHECK_TEXT(observation.hazards[0].what, "bookshelf");
    for (size_t h = 1; h < observation.hazard_count; h++)
        CHECK(observation.hazards[h].score <= observation.hazards[h - 1].score);
    double least = 1;
    for (size_t h = 0; h < observation.hazard_count; h++)
        least = fmin(least, observation.hazards[h].clearance);
    CHECK_NEAR(least, observation.people[0].narrowest, 1e-12);
    observation_free(&observation);
    house_free(&house);
}

TEST(time_lost_where_nothing_is_near_is_lost_in_free_space) {
    House house;
    json_t *plan = case_corridor(8);
    case_add_person(plan, "manual-chair", 5, 0, 180);
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed && observation.hazard_count == 1);
    const Hazard *turn = &observation.hazards[0];
    CHECK_TEXT(turn->what, OUTLINE_FREE_SPACE);
    CHECK(isinf(turn->clearance) && turn->lost_time > 1 && vec2_distance(turn->at, house.people[0].at) < HAZARD_RADIUS);
    observation_free(&observation);
    house_free(&house);
}

TEST(routes_alone_do_not_meet) {
    House house;
    case_house(&house, "ube-techno-house", -1, NULL);
    Observation all = case_run(&house, 1);
    for (size_t r = 0; r < house.plan.route_count; r++) {
        Observation one;
        run_house(&one, &house, &(RunOptions){.route = r, .jobs = 1});
        for (size_t i = 0; i < house.person_count; i++)
            if (one.people[i].took_part)
                CHECK(one.people[i].time == all.people[i].time && one.people[i].narrowest == all.people[i].narrowest);
        observation_free(&one);
    }
    observation_free(&all);
    house_free(&house);
}

/* A contact of a few milliseconds between two rows of the trace is recorded. */
TEST(the_trace_loses_no_extremes) {
    House house;
    case_house(&house, "corner-1.20-0.80", -1,
               (const char *[]){"run.sample=0.5", "run.ring=\"push\"", "profile.manual-chair.turn_response=0.5", NULL});
    Observation observation = case_run(&house, 1);
    const PersonObservation *person = &observation.people[0];
    double force = 0, clearance = HUGE_VAL, ring = 0;
    Vec2 contact = {0, 0};
    for (size_t r = 0; r < observation.trace.rows; r++) {
        const double *row = trace_row(&observation.trace, r);
        CHECK((row[TRACE_BODY_FORCE] > 0) == isfinite(row[TRACE_CONTACT_X]));
        CHECK(isnan(row[TRACE_OFFSET_RATE]) || fabs(row[TRACE_OFFSET_RATE]) <= house.people[0].speed);
        if (row[TRACE_BODY_FORCE] > force)
            contact = vec2(row[TRACE_CONTACT_X], row[TRACE_CONTACT_Y]);
        force = fmax(force, row[TRACE_BODY_FORCE]);
        clearance = fmin(clearance, row[TRACE_CLEARANCE]);
        ring = fmax(ring, row[TRACE_RING]);
    }
    CHECK(person->contacts > 0 && force == person->peak_force && ring == person->ring_peak);
    CHECK(clearance == person->narrowest && vec2_distance(contact, person->peak_at) == 0);
    observation_free(&observation);
    house_free(&house);
}

TEST(it_is_known_when_a_door_was_opened) {
    House house;
    case_house(&house, "closed-door", -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.door_opened[0] > 3 && observation.door_opened[0] < observation.time);
    observation_free(&observation);
    house_free(&house);
    case_house(&house, "ube-techno-house", -1, NULL);
    observation = case_run(&house, 1);
    for (size_t d = 0; d < house.plan.door_count; d++)
        CHECK(!isfinite(observation.door_opened[d]) || outline_door_moves(&house.plan.doors[d]));
    observation_free(&observation);
    house_free(&house);
}

/* The parts that a run has handed over. */
typedef struct Handed {
    Trace traces[8];
    double time[8];
    bool over[8];
    size_t pieces, early; /* `early`: rows later than the part states */
    pthread_mutex_t mutex;
} Handed;

static void take_piece(void *context, const RunPiece *piece) {
    Handed *handed = context;
    pthread_mutex_lock(&handed->mutex);
    CHECK(piece->group < piece->group_count && piece->group_count <= 8 && !handed->over[piece->group]);
    CHECK(piece->time >= handed->time[piece->group]);
    Trace *trace = &handed->traces[piece->group];
    for (size_t r = 0; r < piece->row_count; r++) {
        const double *row = piece->rows + r * TRACE_COLUMNS;
        CHECK(piece->part[(size_t)row[TRACE_PERSON]]);
        handed->early += row[TRACE_TIME] < handed->time[piece->group];
        trace_add(trace, row);
    }
    handed->time[piece->group] = piece->time;
    handed->over[piece->group] = piece->over;
    handed->pieces++;
    pthread_mutex_unlock(&handed->mutex);
}

/* The joined parts are the trace of the run, which equals the run without an observer. */
TEST(a_record_comes_in_pieces) {
    static const char *const names[] = {"ube-techno-house", "two-chairs-corridor"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        House house;
        case_house(&house, names[n], -1, NULL);
        Observation alone = case_run(&house, 1), watched;
        Handed handed = {.mutex = PTHREAD_MUTEX_INITIALIZER};
        for (size_t g = 0; g < 8; g++)
            trace_init(&handed.traces[g], observation_columns, TRACE_COLUMNS);
        run_house(&watched, &house,
                  &(RunOptions){.route = SIZE_MAX, .jobs = 2, .record = take_piece, .context = &handed});
        CHECK(watched.digest == alone.digest && watched.trace.rows == alone.trace.rows);
        CHECK(handed.pieces > 20 && handed.early == 0);
        size_t rows = 0;
        for (size_t g = 0; g < 8; g++) {
            for (size_t r = 0; r < handed.traces[g].rows; r++)
                CHECK(memcmp(trace_row(&handed.traces[g], r), trace_row(&alone.trace, rows + r),
                             TRACE_COLUMNS * sizeof(double)) == 0);
            rows += handed.traces[g].rows;
            CHECK(!handed.traces[g].rows == !handed.over[g]);
            trace_clear(&handed.traces[g]);
        }
        CHECK(rows == alone.trace.rows);
        observation_free(&alone);
        observation_free(&watched);
        house_free(&house);
    }
}

/* A brief answer comes soon and equals the full one, except for the width needed to drive rather than to be carried. */
TEST(a_brief_answer_differs_only_in_what_is_needed_to_pass) {
    static const char *const settings[][2] = {{"door.d1.width=0.5", NULL}, {"door.d1.width=0.9", NULL}};
    for (size_t s = 0; s < 2; s++) {
        House house;
        case_house(&house, "closed-door", -1, settings[s]);
        Observation whole = case_run(&house, 1), brief;
        run_house(&brief, &house, &(RunOptions){.route = SIZE_MAX, .jobs = 1, .brief = true});
        CHECK(whole.digest == brief.digest && whole.trace.rows == brief.trace.rows);
        const PersonObservation *one = &whole.people[0], *other = &brief.people[0];
        CHECK(one->reason == other->reason && one->time == other->time);
        CHECK_TEXT(other->blockage.what, one->blockage.what);
        CHECK(one->blockage.has == other->blockage.has && one->blockage.needs >= other->blockage.needs);
        CHECK(one->reason == REASON_NONE || other->blockage.needs > other->blockage.has);
        observation_free(&whole);
        observation_free(&brief);
        house_free(&house);
    }
}

/* A sofa flush with the wall in which a door is leaves no gap at all; the wall has a door, and is not to blame. */
TEST(furniture_that_bars_a_door_is_named) {
    static const double places[] = {4.86, 4.93};
    for (size_t p = 0; p < sizeof places / sizeof *places; p++) {
        json_t *plan = case_plan("ube-techno-house"), *piece;
        size_t i;
        json_array_foreach(json_object_get(plan, "furniture"), i, piece) {
            if (strcmp(json_string_value(json_object_get(piece, "id")), "sofa") != 0)
                continue;
            json_object_set_new(piece, "centre", json_pack("[f,f]", 4.875, places[p]));
            json_object_set_new(piece, "angle", json_real(90));
        }
        House house = {.driver = 0};
        case_made(&house, plan, -1, NULL);
        Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
        const Route *route = &journeys.of[house_find_person(&house, "p-d")].route;
        CHECK(route->answer == ROUTE_CANNOT_PASS);
        CHECK_TEXT(route->blockage.what, "sofa");
        journey_free_all(&journeys);
        house_free(&house);
    }
}
