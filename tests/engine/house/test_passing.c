/* Tests that people who meet keep to the left, as in Japan, in whichever direction their corridor leads, and that
 * chairs in a crowd come through a narrow neck. */

#include <stdio.h>

#include "base/random.h"
#include "case.h"
#include "check.h"
#include "house/step.h"
#include "house/world.h"

static const double turns[] = {0, 37, 90, 155, -110}; /* degrees */
enum { TURNS = sizeof turns / sizeof *turns };

static const double LENGTH = 24; /* m, of the corridor */

/* A corridor from the origin along `along`, and its mirror image if `mirrored`. */
typedef struct Corridor {
    json_t *plan;
    Vec2 along, across;
    double width, degrees;
} Corridor;

static json_t *place(const Corridor *corridor, double x, double y) {
    Vec2 at = vec2_along(vec2_scale(corridor->along, x), y, corridor->across);
    return json_pack("[f,f]", at.x, at.y);
}

static void add(const Corridor *corridor, const char *list, json_t *object) {
    json_array_append_new(json_object_get(corridor->plan, list), object);
}

static Corridor make_corridor(double width, double degrees, bool mirrored) {
    Corridor corridor = {.width = width, .degrees = degrees, .along = vec2_heading(radians(degrees))};
    corridor.across = vec2_scale(vec2_left(corridor.along), mirrored ? -1 : 1);
    corridor.plan = json_pack("{s:s, s:i, s:s, s:[], s:[], s:[], s:[]}", "format", "clearance-house", "version", 1,
                              "name", "corridor", "walls", "exits", "routes", "people");
    double wall = width / 2 + 0.1;
    for (int side = -1; side <= 1; side += 2)
        add(&corridor, "walls",
            json_pack("{s:s, s:[o,o], s:f}", "id", side < 0 ? "right" : "left", "points",
                      place(&corridor, 0, side * wall), place(&corridor, LENGTH, side * wall), "thickness", 0.2));
    for (int end = 0; end < 2; end++) {
        double x = end ? 1 : LENGTH - 1;
        add(&corridor, "exits",
            json_pack("{s:s, s:o, s:o}", "id", end ? "near" : "far", "from", place(&corridor, x, -width / 2), "to",
                      place(&corridor, x, width / 2)));
    }
    return corridor;
}

/* Adds people who go to the far end, or to the near one. */
static void add_stream(Corridor *corridor, bool to_near, const char *profile, const Vec2 *places, int count) {
    json_t *people = json_array();
    for (int i = 0; i < count; i++) {
        char id[16];
        snprintf(id, sizeof id, "%s%d", to_near ? "n" : "f", i);
        double x = to_near ? LENGTH - places[i].x : places[i].x;
        add(corridor, "people",
            json_pack("{s:s, s:s, s:o, s:f}", "id", id, "profile", profile, "at", place(corridor, x, places[i].y),
                      "heading", remainder(corridor->degrees + (to_near ? 180 : 0), 360)));
        json_array_append_new(people, json_string(id));
    }
    add(corridor, "routes",
        json_pack("{s:s, s:o, s:s}", "id", to_near ? "n" : "f", "people", people, "exit", to_near ? "near" : "far"));
}

typedef struct Sides {
    int left, right; /* people who passed the corridor's middle on that side of it */
} Sides;

static Sides count_sides(const World *start, Corridor *corridor, double until) {
    World world = world_copy(start);
    Sides sides = {0};
    double *before = memory_zeroed(world.count, sizeof *before);
    for (size_t i = 0; i < world.count; i++)
        before[i] = vec2_dot(world.centre[i], corridor->along) - LENGTH / 2;
    while (clock_time(&world.clock) < until) {
        step_world(&world, NULL);
        for (size_t i = 0; i < world.count; i++) {
            double now = vec2_dot(world.centre[i], corridor->along) - LENGTH / 2;
            double side = vec2_cross(corridor->along, world.centre[i]) * (now < before[i] ? -1 : 1);
            if ((now < 0) != (before[i] < 0)) {
                sides.left += side > 0.05;
                sides.right += side < -0.05;
            }
            before[i] = now;
        }
    }
    memory_free(before);
    world_destroy(&world);
    return sides;
}

static Sides meet_on_foot(double width, int count, double degrees, bool mirrored) {
    Corridor corridor = make_corridor(width, degrees, mirrored);
    Random random = random_seed(5, (uint64_t)count);
    for (int stream = 0; stream < 2; stream++) {
        Vec2 places[32];
        for (int i = 0; i < count; i++) /* two abreast at most, 0.6 m apart */
            places[i] = vec2(8 - 0.6 * (i / 2), (i % 2 ? 0.3 : -0.3) * width + 0.2 * (random_uniform(&random) - 0.5));
        add_stream(&corridor, stream, "adult", places, count);
    }
    House house;
    case_made(&house, corridor.plan, -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    World world = world_create(&house, journeys.of, NULL);
    Sides sides = count_sides(&world, &corridor, 20);
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
    return sides;
}

TEST(two_streams_that_meet_keep_to_the_left) {
    for (int t = 0; t < TURNS; t++)
        for (int mirrored = 0; mirrored < 2; mirrored++) {
            Sides few = meet_on_foot(2, 6, turns[t], mirrored), many = meet_on_foot(3, 20, turns[t], mirrored);
            CHECK(few.left >= 11);
            CHECK(few.right == 0);
            CHECK(many.left >= 30);
        }
}

/* Replaces a planned path by the straight line `beside` m to the left of the corridor's middle as it is driven. */
static void straighten(Track *track, const Corridor *corridor, Vec2 way, double beside) {
    Vec2 left = vec2_left(way);
    double begin = vec2_dot(track->points[0].at, way);
    for (size_t k = 0; k < track->count; k++) {
        TrackPoint *point = &track->points[k];
        double x = vec2_dot(point->at, way);
        point->at = vec2_along(vec2_scale(way, x), beside, left);
        point->heading = real_atan2(way.y, way.x);
        point->s = x - begin;
        point->curvature = point->bending = 0;
        point->room_left = corridor->width / 2 - beside;
        point->room_right = corridor->width / 2 + beside;
    }
}

/* Both drive along the middle, or each `beside` m to the left of it. */
static Sides meet_in_chairs(const char *profile, double width, double degrees, double beside) {
    Corridor corridor = make_corridor(width, degrees, false);
    for (int stream = 0; stream < 2; stream++)
        add_stream(&corridor, stream, profile, &(Vec2){5, stream ? -beside : beside}, 1);
    House house;
    case_made(&house, corridor.plan, -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    for (int i = 0; i < 2; i++)
        straighten(&journeys.of[i].track, &corridor, vec2_scale(corridor.along, i ? -1 : 1), beside);
    World world = world_create(&house, journeys.of, NULL);
    Sides sides = count_sides(&world, &corridor, 25);
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
    return sides;
}

/* The paths are straight lines here: a planned path that leans to one side of the corridor by more than 15 cm makes its
 * chair pass on that side. A few centimetres to either side decide nothing. */
TEST(two_chairs_head_on_pass_left_to_left) {
    const double besides[] = {0, 0.03, -0.06};
    for (int t = 0; t < TURNS; t++)
        for (int b = 0; b < 3; b++)
            CHECK(meet_in_chairs("manual-chair", b ? 2.4 : 1.8, turns[t], besides[b]).left == 2);
    CHECK(meet_in_chairs("electric-chair", 1.8, 37, -0.06).left == 2);
}

/* Each brakes for the way that the other needs to stop, too. Corridors of 1.52 m let them pass. */
TEST(two_chairs_that_cannot_pass_do_not_meet_in_a_blow) {
    const double widths[] = {1.20, 1.35, 1.45};
    for (size_t w = 0; w < sizeof widths / sizeof *widths; w++)
        for (int off = -1; off <= 0; off++) {
            Corridor corridor = make_corridor(widths[w], turns[w], off < 0);
            add_stream(&corridor, false, "manual-chair", &(Vec2){3, 0.05 * off}, 1);
            add_stream(&corridor, true, "manual-chair", &(Vec2){3, -0.05 * off}, 1);
            House house;
            case_made(&house, corridor.plan, -1, NULL);
            Observation observation = case_run(&house, 2);
            for (size_t i = 0; i < observation.person_count; i++)
                CHECK(observation.people[i].impact < 0.3);
            observation_free(&observation);
            house_free(&house);
        }
}

/* After it has given way, a chair is up to 0.4 m off its line, and brakes for the wall beside the door. */
TEST(a_chair_that_has_come_off_its_line_does_not_drive_into_the_wall_beside_a_door) {
    json_t *plan = json_pack(
        "{s:s, s:i, s:s, s:[{s:s, s:[[f,f],[f,f],[f,f],[f,f],[f,f]]}], s:[{s:s, s:s, s:i, s:f, s:f}], "
        "s:[{s:s, s:[f,f], s:[f,f]}], s:[]}",
        "format", "clearance-house", "version", 1, "name", "three chairs, one door", "walls", "id", "w1", "points", 0.0,
        0.0, 10.0, 0.0, 10.0, 6.0, 0.0, 6.0, 0.0, 0.0, "doors", "id", "d1", "wall", "w1", "segment", 1, "at", 3.0,
        "width", 1.0, "exits", "id", "e1", "from", 11.0, 2.2, "to", 11.0, 3.8, "people");
    for (int i = 0; i < 3; i++)
        case_add_person(plan, "manual-chair", 7, 1 + 2 * i, 0);
    House house;
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed);
    for (size_t i = 0; i < observation.person_count; i++)
        CHECK(!(observation.people[i].impact > 0.1 && observation.people[i].impact_at.x > 9.9));
    observation_free(&observation);
    house_free(&house);
}

/* Seeds of the neck of 0.80 m in which, among 100, a chair was wedged: it held its heading against the jamb that would
 * have turned it straight, or two chairs let each other go first for ever. */
LONG_TEST(no_chair_is_wedged_in_a_neck_of_0_80_m) {
    const uint64_t seeds[] = {3, 8, 12, 16, 18, 37, 45};
    char path[4096], profiles[4096];
    snprintf(path, sizeof path, "%s/tests/cases/houses/neck-manual-chair.json", check_source());
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    for (size_t k = 0; k < sizeof seeds / sizeof *seeds; k++) {
        House house;
        Fault fault = {0};
        HouseOptions options = {.profiles = profiles,
                                .settings = (const char *[]){"door.neck.width=0.8"},
                                .setting_count = 1,
                                .seed = seeds[k],
                                .driving = -1};
        CHECK(house_read(&house, path, &options, &fault));
        Observation observation = case_run(&house, 2);
        printf("  seed %zu: all out in %.1f s\n", (size_t)seeds[k], observation.time);
        CHECK(observation.completed);
        observation_free(&observation);
        house_free(&house);
    }
}
