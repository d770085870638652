#include "houses.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static json_t *hall(const char *profile, double side, double density) {
    double a = side, half = a / 2;
    json_t *plan = json_pack("{s:s, s:i, s:s, s:[{s:s, s:[[i,i],[f,i],[f,f],[i,f],[i,i]], s:f}], s:[], s:[]}", "format",
                             "clearance-house", "version", 1, "name", "hall", "walls", "id", "w", "points", 0, 0, a, 0,
                             a, a, 0, a, 0, 0, "thickness", 0.2, "doors", "exits");
    const double out[4][4] = {{half - 1, -0.1, half + 1, -0.1},
                              {a + 0.1, half - 1, a + 0.1, half + 1},
                              {half - 1, a + 0.1, half + 1, a + 0.1},
                              {-0.1, half - 1, -0.1, half + 1}};
    for (int i = 0; i < 4; i++) {
        char id[16];
        snprintf(id, sizeof id, "d%d", i);
        json_array_append_new(json_object_get(plan, "doors"),
                              json_pack("{s:s, s:s, s:i, s:f, s:f, s:s}", "id", id, "wall", "w", "segment", i, "at",
                                        half, "width", 2.0, "kind", "opening"));
        id[0] = 'e';
        json_array_append_new(
            json_object_get(plan, "exits"),
            json_pack("{s:s, s:[f,f], s:[f,f]}", "id", id, "from", out[i][0], out[i][1], "to", out[i][2], out[i][3]));
    }
    int count = (int)(density * a * a);
    json_object_set_new(plan, "crowds",
                        json_pack("[{s:s, s:s, s:i, s:[[f,f],[f,f],[f,f],[f,f]]}]", "id", "c", "profile", profile,
                                  "count", count, "area", 0.2, 0.2, a - 0.2, 0.2, a - 0.2, a - 0.2, 0.2, a - 0.2));
    return plan;
}

static bool read_house(House *house, const char *source, const char *path) {
    char profiles[4096];
    Fault fault = {0};
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", source);
    *house = (House){.seed = 0};
    bool good = house_read(house, path, &(HouseOptions){.profiles = profiles, .seed = 1, .driving = -1}, &fault);
    if (!good)
        printf("%s\n", fault.lines[0]);
    return good;
}

void houses_read_ube(House *house, const char *source) {
    char path[4096];
    snprintf(path, sizeof path, "%s/houses/ube-techno-house.json", source);
    if (!read_house(house, source, path))
        exit(1);
}

void houses_read_hall(House *house, const char *source, const char *profile, double side, double density) {
    char path[] = "/tmp/clearance-bench-XXXXXX";
    int file = mkstemp(path);
    json_t *plan = hall(profile, side, density);
    json_dumpfd(plan, file, 0);
    close(file);
    json_decref(plan);
    bool good = read_house(house, source, path);
    unlink(path);
    if (!good)
        exit(1);
}
