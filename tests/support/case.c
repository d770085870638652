#include "case.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "check.h"
#include "house/run.h"

static void read_case(House *house, const char *path, int driving, const char *const *settings) {
    char profiles[4096];
    size_t count = 0;
    *house = (House){.seed = 0};
    Fault fault = {0};
    while (settings && settings[count])
        count++;
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    HouseOptions options = {
        .profiles = profiles, .settings = settings, .setting_count = count, .seed = 1, .driving = driving};
    bool good = house_read(house, path, &options, &fault);
    check_say(&fault);
    check_true(good, "the house is read", __FILE__, __LINE__);
    if (!good)
        exit(1);
}

void case_house(House *house, const char *name, int driving, const char *const *settings) {
    char path[4096];
    snprintf(path, sizeof path, "%s/houses/%s.json", check_source(), name);
    read_case(house, path, driving, settings);
}

const char *const case_touching[] = {"run.ring=\"push\"", "profile.manual-chair.turn_response=0.5", NULL};

void case_made(House *house, json_t *plan, int driving, const char *const *settings) {
    char path[CHECK_PATH];
    check_temporary(path, "case-XXXXXX");
    int file = mkstemp(path);
    check_true(file >= 0 && json_dumpfd(plan, file, JSON_REAL_PRECISION(17)) == 0, "the house is written", __FILE__,
               __LINE__);
    close(file);
    json_decref(plan);
    read_case(house, path, driving, settings);
    unlink(path);
}

json_t *case_plan(const char *name) {
    char path[4096];
    snprintf(path, sizeof path, "%s/houses/%s.json", check_source(), name);
    return json_load_file(path, 0, NULL);
}

Observation case_run(const House *house, int jobs) {
    Observation observation;
    run_house(&observation, house, &(RunOptions){.route = SIZE_MAX, .jobs = jobs});
    return observation;
}

json_t *case_corridor(double width) {
    const double half = 0.1, y = width / 2 + half;
    return json_pack("{s:s, s:i, s:s, s:[{s:s, s:[[f,f],[f,f]], s:f}, {s:s, s:[[f,f],[f,f]], s:f}], s:[{s:s, s:[f,f], "
                     "s:[f,f]}], s:[]}",
                     "format", "clearance-house", "version", 1, "name", "corridor", "walls", "id", "south", "points",
                     0.0, -y, 20.0, -y, "thickness", 2 * half, "id", "north", "points", 0.0, y, 20.0, y, "thickness",
                     2 * half, "exits", "id", "e1", "from", 18.0, -width / 2, "to", 18.0, width / 2, "people");
}

static json_t *turned(double x, double y, double angle) {
    return json_pack("[f,f]", x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle));
}

json_t *case_corner(double w1, double w2, double angle) {
    const double outer = 4 + w2 + 0.06, points[6][2] = {{outer, 4 + w1},    {outer, -0.06},    {-0.06, -0.06},
                                                        {-0.06, w1 + 0.06}, {3.94, w1 + 0.06}, {3.94, 4 + w1}};
    json_t *wall = json_array();
    for (int p = 0; p < 6; p++)
        json_array_append_new(wall, turned(points[p][0], points[p][1], angle));
    return json_pack("{s:s, s:i, s:s, s:[{s:s, s:o, s:f}], s:[{s:s, s:o, s:o}], s:[{s:s, s:s, s:o, s:f}]}", "format",
                     "clearance-house", "version", 1, "name", "corner", "walls", "id", "w1", "points", wall,
                     "thickness", 0.12, "exits", "id", "e1", "from", turned(4, 4 + w1, angle), "to",
                     turned(4 + w2, 4 + w1, angle), "people", "id", "p1", "profile", "manual-chair", "at",
                     turned(1, w1 / 2, angle), "heading", angle * 180 / M_PI);
}

json_t *case_side_door(double wide, double door, bool from_room, double angle) {
    const double wall = wide + 0.06, far = wide + 4, low = 3 - door / 2, high = 3 + door / 2;
    const double walls[7][4] = {{-0.06, wall, -0.06, -0.06}, {-0.06, -0.06, 6.06, -0.06}, {-0.06, wall, low, wall},
                                {high, wall, 6.06, wall},    {1.44, wall, 1.44, far},     {4.56, wall, 4.56, far},
                                {1.44, far, 4.56, far}};
    json_t *list = json_array();
    for (int w = 0; w < (from_room ? 7 : 6); w++) {
        char id[16];
        snprintf(id, sizeof id, "w%d", w + 1);
        json_array_append_new(list, json_pack("{s:s, s:[o,o], s:f}", "id", id, "points",
                                              turned(walls[w][0], walls[w][1], angle),
                                              turned(walls[w][2], walls[w][3], angle), "thickness", 0.12));
    }
    Vec2 at = from_room ? vec2(3, wide + 2.2) : vec2(1, wide / 2);
    Vec2 from = from_room ? vec2(6, 0) : vec2(1.5, far - 1), to = from_room ? vec2(6, wide) : vec2(4.5, far - 1);
    return json_pack("{s:s, s:i, s:s, s:o, s:[{s:s, s:o, s:o}], s:[{s:s, s:s, s:o, s:f}]}", "format", "clearance-house",
                     "version", 1, "name", "side door", "walls", list, "exits", "id", "e1", "from",
                     turned(from.x, from.y, angle), "to", turned(to.x, to.y, angle), "people", "id", "p1", "profile",
                     "manual-chair", "at", turned(at.x, at.y, angle), "heading",
                     angle * 180 / M_PI - (from_room ? 90 : 0));
}

void case_add_person(json_t *plan, const char *profile, double x, double y, double heading) {
    char id[16];
    json_t *people = json_object_get(plan, "people");
    snprintf(id, sizeof id, "p%zu", json_array_size(people) + 1);
    json_array_append_new(
        people, json_pack("{s:s, s:s, s:[f,f], s:f}", "id", id, "profile", profile, "at", x, y, "heading", heading));
}
