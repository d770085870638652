#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/json.h"
#include "check.h"
#include "scratch.h"
#include "house/house.h"
#include "plan/plan_geometry.h"

static const char *const room = "'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0], [4, 3]]}], "
                                "'doors': [{'id': 'd1', 'wall': 'w1', 'at': 1.2, 'width': 0.8}], "
                                "'exits': [{'id': 'e1', 'from': [1, -1], 'to': [2, -1]}], "
                                "'people': [{'id': 'p1', 'profile': 'manual-chair', 'at': [2, 1.5]}]";

/* Reads a draft with settings, ended by NULL; `*first` receives the first error, released by the caller. */
static bool read_with(Plan *plan, const char *members, const char *const *settings, char **first) {
    size_t size = strlen(members) + 64, count = 0;
    char *text = memory_zeroed(size, 1), path[SCRATCH_PATH];
    while (settings && settings[count])
        count++;
    snprintf(text, size, "{'format': 'clearance-house', 'version': 1, %s}", members);
    scratch_write(path, text);
    memory_free(text);
    Fault fault = {0};
    *plan = (Plan){0};
    bool good = plan_read(plan, path, settings, count, &fault);
    CHECK(good == (fault.count == 0));
    *first = NULL;
    if (fault.count) {
        const char *line = fault.lines[0];
        *first = strdup(strncmp(line, path, strlen(path)) == 0 ? line + strlen(path) : line);
    }
    fault_clear(&fault);
    unlink(path);
    return good;
}

/* Writes the plan, reads it and writes it again: returns the bytes, which must be equal; memory_free them. */
static char *round_trip(const Plan *plan) {
    char first[SCRATCH_PATH], second[SCRATCH_PATH];
    Plan again = {0};
    Fault fault = {0};
    scratch_write(first, "");
    scratch_write(second, "");
    CHECK(plan_write(plan, first) == 0);
    CHECK(plan_read(&again, first, NULL, 0, &fault));
    CHECK(plan_write(&again, second) == 0);
    char *once = scratch_read(first), *twice = scratch_read(second);
    CHECK_TEXT(twice, once);
    memory_free(twice);
    fault_clear(&fault);
    plan_free(&again);
    unlink(first);
    unlink(second);
    return once;
}

TEST(every_shipped_house_is_written_as_it_is_shipped) {
    size_t count;
    char **paths = scratch_list("houses", &count);
    for (size_t i = 0; i < count; i++) {
        Plan plan = {0};
        Fault fault = {0};
        CHECK(plan_read(&plan, scratch_source(paths[i]), NULL, 0, &fault));
        for (size_t f = 0; f < fault.count; f++)
            printf("%s\n", fault.lines[f]);
        char *shipped = scratch_read(scratch_source(paths[i])), *written = round_trip(&plan);
        CHECK_TEXT(written, shipped);
        memory_free(shipped);
        memory_free(written);
        fault_clear(&fault);
        plan_free(&plan);
    }
    scratch_free_list(paths, count);
}

TEST(a_house_in_memory_is_read_as_if_from_its_file) {
    size_t count;
    char **paths = scratch_list("houses", &count);
    for (size_t i = 0; i < count; i++) {
        House house = {0};
        Fault fault = {0};
        char profiles[512];
        snprintf(profiles, sizeof profiles, "%s", scratch_source("assets/profiles"));
        HouseOptions options = {.profiles = profiles, .driving = -1};
        char *shipped = scratch_read(scratch_source(paths[i]));
        CHECK(house_read_text(&house, "/nowhere/at-all.json", shipped, &options, &fault));
        CHECK_TEXT(house.plan.path, "/nowhere/at-all.json");
        char *written = plan_text(&house.plan);
        CHECK_TEXT(written, shipped);
        memory_free(written);
        memory_free(shipped);
        fault_clear(&fault);
        house_free(&house);
    }
    scratch_free_list(paths, count);
}

TEST(a_fault_of_a_text_in_memory_says_where_in_the_text) {
    Plan plan = {.name = "untouched"};
    Fault fault = {0};
    CHECK(!plan_read_text(&plan, "drawn.json", "{\"format\": \"clearance-house\",\n \"version\": 2}", NULL, 0, &fault));
    CHECK(fault.count > 0 && strncmp(fault.lines[0], "drawn.json:2:13: ", 17) == 0);
    CHECK(!plan_read_text(&plan, "drawn.json", "\n", NULL, 0, &fault));
    CHECK_TEXT(fault.lines[fault.count - 1], "drawn.json:1:1: empty, must hold one object { ... }");
    CHECK_TEXT(plan.name, "untouched");
    fault_clear(&fault);
}

TEST(every_shipped_house_says_that_its_plan_is_assumed) {
    size_t count;
    char **paths = scratch_list("houses", &count);
    for (size_t i = 0; i < count; i++) {
        Plan plan = {0};
        Fault fault = {0};
        CHECK(plan_read(&plan, scratch_source(paths[i]), NULL, 0, &fault));
        CHECK(*plan.name);
        CHECK(strncmp(plan.note, "assumed plan: ", strlen("assumed plan: ")) == 0);
        for (size_t r = 0; r < plan.route_count; r++)
            CHECK(plan.routes[r].observed.mean == 0); /* not measured */
        fault_clear(&fault);
        plan_free(&plan);
    }
    scratch_free_list(paths, count);
}

TEST(a_corner_house_has_the_clear_widths_of_its_name) {
    size_t count;
    char **paths = scratch_list("houses", &count);
    int corners = 0;
    for (size_t i = 0; i < count; i++) {
        double before, after;
        if (sscanf(paths[i], "houses/corner-%lf-%lf.json", &before, &after) != 2)
            continue;
        House house = {0};
        Fault fault = {0};
        char profiles[4096];
        snprintf(profiles, sizeof profiles, "%s", scratch_source("assets/profiles"));
        CHECK(
            house_read(&house, scratch_source(paths[i]), &(HouseOptions){.profiles = profiles, .driving = -1}, &fault));
        const Outline *outline = &house.outline;
        Vec2 in_first = {2, before / 2}, in_second = {4 + after / 2, before + 2};
        CHECK_NEAR(outline_ray(outline, in_first, vec2(0, 1), 9, NULL) +
                       outline_ray(outline, in_first, vec2(0, -1), 9, NULL),
                   before, 1e-6);
        CHECK_NEAR(outline_ray(outline, in_second, vec2(1, 0), 9, NULL) +
                       outline_ray(outline, in_second, vec2(-1, 0), 9, NULL),
                   after, 1e-6);
        CHECK_NEAR(outline_ray(outline, vec2(1, before / 2), vec2(-1, 0), 9, NULL), 1, 1e-6);
        fault_clear(&fault);
        house_free(&house);
        corners++;
    }
    CHECK(corners == 9);
    scratch_free_list(paths, count);
}

TEST(a_plan_survives_writing_to_the_last_bit) {
    Plan plan, again = {0};
    scratch_plan(&plan,
                 "'name': 'caf\xc3\xa9 \\\"x\\\"', 'note': 'a\\nb', "
                 "'walls': [{'id': 'w1', 'points': [[0.1, 0.30000000000000004], [4, 0], [4, 3.0000000000000004]], "
                 "'thickness': 0, 'height': 2.71828182845904523}], "
                 "'doors': [{'id': 'd1', 'wall': 'w1', 'segment': 1, 'at': 1.2, 'width': 0.7999999999999999, 'kind': "
                 "'hinged', 'state': 'closed', 'hinge': 'end', 'swing': 'right', 'opening_time': 2.5, 'leaf': "
                 "0.035, 'closer': true}], "
                 "'furniture': [{'id': 'f1', 'centre': [1, 9], 'size': [1e-1, 2], 'angle': -33.3, 'topples': 'left', "
                 "'probability': 0.1, 'toppled': true}], "
                 "'rooms': [{'id': 'r1', 'name': 'hall', 'outline': [[0, 0], [1, 0], [1, 1e-7]]}], "
                 "'exits': [{'id': 'e1', 'from': [0, 0], 'to': [-1e5, 1], 'opens': 0.5, 'closes': 60}], "
                 "'people': [{'id': 'p1', 'profile': 'manual-chair', 'at': [9, 9], 'heading': 45, 'delay': 3, 'speed': "
                 "0.5}], 'crowds': [{'id': 'c1', 'profile': 'manual-chair', 'count': 7, 'area': [[0, 0], [1, 0], [1, "
                 "1]], 'delay': 2}], "
                 "'routes': [{'id': 'A', 'people': ['p1'], 'via': [[2, 1]], 'exit': 'e1', 'observed': {'mean': 12.3, "
                 "'deviation': 0.8, 'times': [11.5, 12.3, 13.1], 'drivers': ['a', 'b', 'a'], 'touches': 1}}], "
                 "'drivers': {'count': "
                 "40, 'population': 'whm'}, 'run': {'dt': 0.0005, 'routes': 'alone'}, "
                 "'overrides': {'profile.manual-chair.width': 0.7, 'profile.manual-chair.driving': 'miura'}");
    char *text = round_trip(&plan);
    char path[SCRATCH_PATH];
    Fault fault = {0};
    scratch_write(path, text);
    CHECK(plan_read(&again, path, NULL, 0, &fault));
    unlink(path);
    CHECK_TEXT(again.name, "caf\xc3\xa9 \"x\"");
    CHECK_TEXT(again.note, "a\nb");
    CHECK(again.walls[0].points.at[0].y == 0.1 + 0.2);
    CHECK(again.walls[0].points.at[2].y == nextafter(3, 4));
    CHECK(again.walls[0].height == 2.71828182845904523);
    CHECK(again.doors[0].width == nextafter(0.8, 0) && again.doors[0].wall_index == 0);
    CHECK(again.doors[0].kind == DOOR_HINGED && again.doors[0].hinge == HINGE_END);
    CHECK(again.furniture[0].toppled && again.furniture[0].topples == TOPPLE_LEFT);
    CHECK(again.exits[0].to.x == -1e5 && again.exits[0].closes == 60);
    const Observed *observed = &again.routes[0].observed;
    CHECK(observed->runs == 1 && observed->mean == 12.3 && observed->touches == 1);
    CHECK(observed->times.count == 3 && observed->times.at[2] == 13.1 && observed->drivers.count == 3);
    CHECK(again.doors[0].leaf == 0.035 && again.doors[0].closer);
    CHECK(again.drivers.count == 40 && strcmp(again.drivers.population, "whm") == 0);
    CHECK(again.routes[0].exit_index == 0);
    CHECK(again.run.dt == 0.0005 && again.run.routes == ROUTES_ALONE);
    CHECK(again.override_count == 2);
    memory_free(text);
    fault_clear(&fault);
    plan_free(&again);
    plan_free(&plan);
}

TEST(what_a_file_leaves_out_has_the_value_of_its_table) {
    Plan plan;
    scratch_plan(&plan, room);
    CHECK_NEAR(plan.walls[0].thickness, 0.12, 0);
    CHECK_NEAR(plan.doors[0].opening_time, 3, 0);
    CHECK_NEAR(plan.doors[0].leaf, 0.04, 0);
    CHECK(!plan.doors[0].closer && plan.doors[0].rest == 0 && plan.drivers.count == 0);
    CHECK(plan.doors[0].state == DOOR_OPEN && plan.doors[0].kind == DOOR_OPENING);
    CHECK(isinf(plan.exits[0].closes));
    CHECK_NEAR(plan.run.dt, 0.001, 0);
    CHECK_TEXT(plan.name, "");
    CHECK(plan_route_of(&plan, "p1") == NULL);
    plan_free(&plan);
}

TEST(each_number_is_written_with_the_fewest_digits_of_its_own) {
    json_t *value = json_pack("{s:[f,f], s:i, s:b}", "a", 0.1, 0.1 + 0.2, "b", 7, "c", 1);
    char *line = json_line(value);
    CHECK_TEXT(line, "{\"a\": [0.1, 0.30000000000000004], \"b\": 7, \"c\": true}");
    memory_free(line);
    json_decref(value);
}

TEST(a_mark_of_byte_order_is_no_fault) {
    char path[SCRATCH_PATH];
    Plan plan = {0};
    Fault fault = {0};
    scratch_write(path, "\xef\xbb\xbf{'format': 'clearance-house', 'version': 1, 'walls': [], 'x': 1}");
    CHECK(!plan_read(&plan, path, NULL, 0, &fault));
    CHECK(fault.count == 1 && strstr(fault.lines[0], ":1:58: unknown key \"x\""));
    fault_clear(&fault);
    unlink(path);
}

TEST(a_missing_file_and_a_directory_are_faults) {
    Plan plan = {0};
    Fault fault = {0};
    CHECK(!plan_read(&plan, "/tmp/clearance-there-is-none.json", NULL, 0, &fault));
    CHECK(!plan_read(&plan, "/tmp", NULL, 0, &fault));
    CHECK(fault.count == 2);
    CHECK_TEXT(fault.lines[0], "/tmp/clearance-there-is-none.json:1:1: cannot be read: No such file or directory");
    CHECK_TEXT(fault.lines[1], "/tmp:1:1: cannot be read: Is a directory");
    fault_clear(&fault);
}

TEST(overrides_and_settings_change_the_plan) {
    Plan plan;
    char *fault, members[2000];
    snprintf(members, sizeof members,
             "%s, 'overrides': {'door.d1.width': 0.9, 'run.dt': 0.002, 'profile.manual-chair.width': 0.7}", room);
    const char *const settings[] = {"door.d1.at=2", "door.d1.state=closed",  "person.p1.at=[1, 1]",
                                    "run.until=10", "wall.w1.thickness=0.2", NULL};
    CHECK(read_with(&plan, members, settings, &fault));
    CHECK_NEAR(plan.doors[0].width, 0.9, 0);
    CHECK_NEAR(plan.doors[0].at, 2, 0);
    CHECK(plan.doors[0].state == DOOR_CLOSED);
    CHECK_NEAR(plan.people[0].at.x, 1, 0);
    CHECK_NEAR(plan.run.dt, 0.002, 0);
    CHECK_NEAR(plan.run.until, 10, 0);
    CHECK_NEAR(plan.walls[0].thickness, 0.2, 0);
    CHECK(plan.override_count == 1);
    CHECK_TEXT(plan.overrides[0].name, "profile.manual-chair.width");
    CHECK_TEXT(plan.overrides[0].value, "0.7");
    free(fault);
    plan_free(&plan);
}

TEST(a_setting_changes_one_number_of_a_point) {
    Plan plan;
    char *fault;
    const char *const settings[] = {"person.p1.at=[1, 1]", "person.p1.x=2", "person.p1.at.y=0.9", NULL};
    CHECK(read_with(&plan, room, settings, &fault));
    CHECK(plan.people[0].at.x == 2 && plan.people[0].at.y == 0.9);
    const void *object;
    Fault none = {0};
    const Parameter *row = plan_parameter(&plan, "person.p1.x", &object, "", &none);
    CHECK(row && row->kind == PARAMETER_NUMBER && object == &plan.people[0]);
    CHECK_TEXT(row ? row->name : "", "at.x");
    CHECK(none.total == 0);
    plan_free(&plan);
}

TEST(what_a_setting_renames_is_found_by_its_new_name) {
    Plan plan;
    char *fault;
    const char *const settings[] = {"wall.w1.id=w2", "door.d1.id=d2", "door.d2.wall=w2", "door.d2.width=0.7", NULL};
    CHECK(read_with(&plan, room, settings, &fault));
    CHECK_TEXT(plan.doors[0].id, "d2");
    CHECK_NEAR(plan.doors[0].width, 0.7, 0);
    CHECK(plan.doors[0].wall_index == 0);
    plan_free(&plan);
    CHECK(!read_with(&plan, room, (const char *const[]){"door.d1.id=d2", "door.d1.width=0.7", NULL}, &fault));
    CHECK_TEXT(fault, "--set door.d1.width: there is no door \"d1\"");
    free(fault);
}

TEST(a_setting_comes_after_an_override_and_is_named_in_its_fault) {
    Plan plan;
    char *fault, members[2000];
    snprintf(members, sizeof members, "%s, 'overrides': {'door.d1.width': 0.9}", room);
    CHECK(read_with(&plan, members, (const char *const[]){"door.d1.width=1.1", NULL}, &fault));
    CHECK_NEAR(plan.doors[0].width, 1.1, 0);
    plan_free(&plan);
    const char *const wrong[][2] = {
        {"door.d1.width=0", "--set door.d1.width: width is 0, must be from 0.01 to 100 m"},
        {"door.d1.width=wide", "--set door.d1.width: width must be a number in m"},
        {"door.d9.width=1", "--set door.d9.width: there is no door \"d9\""},
        {"door.d1.wide=1", "--set door.d1.wide: door has no parameter \"wide\", did you mean \"width\"?"},
        {"person.p1.x=1e6", "--set person.p1.x: at.x is 1e+06, must be from -100000 to 100000 m"},
        {"person.p1.z=1", "--set person.p1.z: person has no parameter \"z\", it has id, profile, at, heading, delay, "
                          "speed"},
        {"dor.d1.width=1", "--set dor.d1.width: unknown kind \"dor\", did you mean \"door\"?"},
        {"width=1", "--set width: \"width\" is not a parameter name: it must be run.NAME, or KIND.ID.NAME such as "
                    "door.d1.width or "
                    "profile.manual-chair.width"},
        {"door.d1.width", "--set door.d1.width: must be NAME=VALUE, for instance door.d1.width=0.8"},
        {"door.d1.width=", "--set door.d1.width=: must be NAME=VALUE, for instance door.d1.width=0.8"},
        {"door.d1.state=ajar", "--set door.d1.state: state is \"ajar\", must be open, closed or locked"},
        {"door.d1.wall=w9", ":1:"},
        {"run.dt=1e400", "--set run.dt: dt must be a number in s"},
        {"run.dt=\xff", "--set run.dt: the value is not UTF-8"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        CHECK(!read_with(&plan, room, (const char *const[]){wrong[i][0], NULL}, &fault));
        if (wrong[i][1][0] == ':')
            CHECK(strncmp(fault, wrong[i][1], strlen(wrong[i][1])) == 0);
        else
            CHECK_TEXT(fault, wrong[i][1]);
        free(fault);
    }
}

TEST(several_faults_in_one_file_are_all_listed) {
    Plan plan = {0};
    Fault fault = {0};
    CHECK(!plan_read(&plan, scratch_source("tests/data/bad/houses/many-faults.json"), NULL, 0, &fault));
    CHECK_NEAR((double)fault.count, 9, 0);
    fault_clear(&fault);
}

TEST(a_file_that_is_wrong_everywhere_is_not_listed_to_the_end) {
    enum { MANY = 80 };
    char members[40000] = "'walls': [", *first;
    for (int i = 0; i < MANY; i++) {
        size_t used = strlen(members);
        snprintf(members + used, sizeof members - used, "%s{'id': 'w%d', 'points': [[0, 0]]}", i ? ", " : "", i);
    }
    strcat(members, "], 'doors': [");
    for (int i = 0; i < MANY; i++) {
        size_t used = strlen(members);
        snprintf(members + used, sizeof members - used, "%s{'id': 'd%d', 'wall': 'w%d', 'at': 1, 'width': 1}",
                 i ? ", " : "", i, i);
    }
    strcat(members, "]");
    Plan plan = {0};
    CHECK(!read_with(&plan, members, NULL, &first));
    CHECK(first && strstr(first, "points must be a list of at least 2 points"));
    CHECK(!plan.walls);
    free(first);
}

/* Returns the errors of a bad file, one per line. */
static char *faults_of(const char *path) {
    Fault fault = {0};
    if (strstr(path, "/profiles/")) {
        Profile profile = {.mass = 7};
        CHECK(!profile_read(&profile, path, &fault));
        CHECK(profile.mass == 7 && !profile.name);
    } else {
        Plan plan = {.name = "untouched"};
        Fault ignored = {0};
        if (!plan_read(&plan, path, NULL, 0, &ignored))
            CHECK_TEXT(plan.name, "untouched");
        else
            plan_free(&plan);
        fault_clear(&ignored);
        House house = {.seed = 7};
        CHECK(!house_read(&house, path, &(HouseOptions){.profiles = "assets/profiles", .driving = -1}, &fault));
        CHECK(house.seed == 7 && !house.plan.walls && !house.profiles);
    }
    size_t size = 1;
    for (size_t i = 0; i < fault.count; i++)
        size += strlen(fault.lines[i]) + 1;
    char *lines = memory_zeroed(size, 1);
    for (size_t i = 0; i < fault.count; i++)
        strcat(strcat(lines, fault.lines[i]), "\n");
    fault_clear(&fault);
    return lines;
}

/* Returns the lines of tests/data/bad/expected.txt that begin with the path. */
static char *expected_of(const char *path, const char *expected) {
    char *lines = memory_zeroed(strlen(expected) + 1, 1);
    for (const char *line = expected; *line;) {
        size_t length = strcspn(line, "\n") + 1;
        if (strncmp(line, path, strlen(path)) == 0 && line[strlen(path)] == ':')
            strncat(lines, line, length);
        line += length;
    }
    return lines;
}

TEST(every_bad_file_gives_exactly_its_faults_and_leaves_its_target_as_it_was) {
    CHECK(chdir(check_source()) == 0); /* the expected lines name files relative to it */
    char *expected = scratch_read("tests/data/bad/expected.txt");
    const char *const directories[] = {"tests/data/bad/houses", "tests/data/bad/profiles"};
    size_t lines = 0, files = 0;
    for (int d = 0; d < 2; d++) {
        size_t count;
        char **paths = scratch_list(directories[d], &count);
        for (size_t i = 0; i < count; i++) {
            char *got = faults_of(paths[i]), *wanted = expected_of(paths[i], expected);
            CHECK(*wanted);
            CHECK_TEXT(got, wanted);
            for (const char *c = wanted; *c; c++)
                lines += *c == '\n';
            memory_free(got);
            memory_free(wanted);
        }
        files += count;
        scratch_free_list(paths, count);
    }
    size_t all = 0;
    for (const char *c = expected; *c; c++)
        all += *c == '\n';
    CHECK(lines == all);
    CHECK(files >= 45);
    memory_free(expected);
}

TEST(a_door_has_its_ends_on_its_wall) {
    Plan plan;
    scratch_plan(&plan, "'walls': [{'id': 'w1', 'points': [[0, 0], [3, 4], [3, 9]]}], "
                        "'doors': [{'id': 'd1', 'wall': 'w1', 'at': 2.5, 'width': 1}, "
                        "{'id': 'd2', 'wall': 'w1', 'segment': 1, 'at': 0.4, 'width': 0.8}]");
    Vec2 from = {7, 7}, to = {7, 7};
    plan_geometry_door_ends(&plan, &plan.doors[0], &from, &to);
    CHECK_NEAR(from.x, 1.2, 1e-12);
    CHECK_NEAR(from.y, 1.6, 1e-12);
    CHECK_NEAR(to.x, 1.8, 1e-12);
    CHECK_NEAR(to.y, 2.4, 1e-12);
    plan_geometry_door_ends(&plan, &plan.doors[1], &from, &to);
    CHECK_NEAR(from.y, 4, 1e-12);
    CHECK_NEAR(to.y, 4.8, 1e-12);
    plan_free(&plan);
}

TEST(what_topples_grows_by_its_height_towards_its_face) {
    const Vec2 reach[] = {{0, -1.8}, {0, 1.8}, {-1.8, 0}, {1.8, 0}};
    for (int face = TOPPLE_FRONT; face <= TOPPLE_RIGHT; face++) {
        Furniture piece = {.centre = {5, 5}, .size = {1, 0.4}, .angle = 90, .height = 1.8, .topples = face};
        for (int lies = 0; lies < 2; lies++) {
            Vec2 corners[4];
            Box box = box_empty();
            double area = 0;
            piece.toppled = lies;
            plan_geometry_corners(&piece, corners);
            for (int i = 0; i < 4; i++) {
                area += vec2_cross(corners[i], corners[(i + 1) % 4]) / 2;
                box = box_include(box, vec2_unturn(vec2_sub(corners[i], piece.centre), vec2(0, 1)));
            }
            Vec2 more = vec2_scale(reach[face], lies);
            CHECK_NEAR(box.low.x, -0.5 + fmin(more.x, 0), 1e-12);
            CHECK_NEAR(box.high.x, 0.5 + fmax(more.x, 0), 1e-12);
            CHECK_NEAR(box.low.y, -0.2 + fmin(more.y, 0), 1e-12);
            CHECK_NEAR(box.high.y, 0.2 + fmax(more.y, 0), 1e-12);
            CHECK_NEAR(area, (box.high.x - box.low.x) * (box.high.y - box.low.y), 1e-12);
        }
    }
}

TEST(faults_about_people_and_crowds_begin_with_their_places) {
    char path[SCRATCH_PATH];
    Plan plan = {0};
    Fault fault = {0};
    scratch_write(path, "{'format': 'clearance-house', 'version': 1, 'walls': [], 'name': '\xc3\xa9 ]',\n"
                        " 'crowds' :[ {'id': 'c1', 'profile': 'x', 'count': 1, 'area': [[0, 0], [1, 0], [1, 1]]}\n],\n"
                        " 'note': '\xc3\xa9', 'people': [{'id': 'p1', 'profile': 'x', 'at': [9, 9]},"
                        "{'id': 'p2', 'profile': 'x', 'at': [8, 8]}]}");
    CHECK(plan_read(&plan, path, NULL, 0, &fault));
    const char *const places[] = {":4:26: ", ":4:69: ", ":2:14: "};
    const char *const got[] = {plan.people[0].place, plan.people[1].place, plan.crowds[0].place};
    for (int i = 0; i < 3; i++) {
        CHECK(strncmp(got[i], path, strlen(path)) == 0);
        CHECK_TEXT(got[i] + strlen(path), places[i]);
    }
    plan_free(&plan);
    fault_clear(&fault);
    unlink(path);
}

TEST(people_and_routes_are_found_by_their_ids) {
    Plan plan;
    char members[2000];
    snprintf(members, sizeof members, "%s, 'routes': [{'id': 'A', 'people': []}, {'id': 'B', 'people': ['p1']}]", room);
    scratch_plan(&plan, members);
    CHECK(plan_find_person(&plan, "p1") == 0);
    CHECK(plan_find_person(&plan, "p2") == SIZE_MAX);
    CHECK(plan_find_route(&plan, "B") == 1);
    CHECK(plan_find_route(&plan, "p1") == SIZE_MAX);
    CHECK(plan_route_of(&plan, "p1") == &plan.routes[1]);
    CHECK(plan_route_of(&plan, "p2") == NULL);
    plan_free(&plan);
}

TEST(a_fault_list_that_is_full_does_not_make_a_bad_file_good) {
    Fault fault = {0};
    for (int i = 0; i < FAULT_MOST; i++)
        fault_add(&fault, "an earlier file's fault %d", i);
    Plan plan = {0};
    CHECK(!plan_read(&plan, scratch_source("tests/data/bad/houses/many-faults.json"), NULL, 0, &fault));
    CHECK(fault.count == FAULT_MOST && fault.total > FAULT_MOST);
    CHECK(plan.walls == NULL);
    fault_clear(&fault);
}
