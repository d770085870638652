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

static bool read_house_with(House *house, const char *source, const char *path, const char *const *settings,
                            size_t setting_count) {
    char profiles[4096];
    Fault fault = {0};
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", source);
    *house = (House){.seed = 0};
    bool good = house_read(
        house, path,
        &(HouseOptions){
            .profiles = profiles, .settings = settings, .setting_count = setting_count, .seed = 1, .driving = -1},
        &fault);
    if (!good)
        printf("%s\n", fault.lines[0]);
    return good;
}

static bool read_house(House *house, const char *source, const char *path) {
    return read_house_with(house, source, path, NULL, 0);
}

void houses_read_ube(House *house, const char *source) {
    char path[4096];
    snprintf(path, sizeof path, "%s/houses/ube-techno-house.json", source);
    if (!read_house(house, source, path))
        exit(1);
}

void houses_read_ube_moved(House *house, const char *source, const char *piece, Vec2 centre) {
    char path[4096], x[64], y[64];
    snprintf(path, sizeof path, "%s/houses/ube-techno-house.json", source);
    snprintf(x, sizeof x, "furniture.%s.centre.x=%.4f", piece, centre.x);
    snprintf(y, sizeof y, "furniture.%s.centre.y=%.4f", piece, centre.y);
    if (!read_house_with(house, source, path, (const char *const[]){x, y}, 2))
        exit(1);
}

static void read_made(House *house, const char *source, json_t *plan) {
    char path[] = "/tmp/clearance-bench-XXXXXX";
    int file = mkstemp(path);
    json_dumpfd(plan, file, 0);
    close(file);
    json_decref(plan);
    bool good = read_house(house, source, path);
    unlink(path);
    if (!good)
        exit(1);
}

void houses_read_hall(House *house, const char *source, const char *profile, double side, double density) {
    read_made(house, source, hall(profile, side, density));
}

/* m, of the flat below: its rooms, between the axes of walls, and their number on each side of the corridor. */
#define ROOM_WIDTH 3.6
#define ROOM_DEPTH 3.6
#define WALL 0.12
enum { ROOMS = 4, PIECES = 16 };

static void add_wall(json_t *plan, const char *id, double x0, double y0, double x1, double y1) {
    json_array_append_new(json_object_get(plan, "walls"), json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", id, "points",
                                                                    x0, y0, x1, y1, "thickness", WALL));
}

static void add_door(json_t *plan, const char *wall, int room, double at, double width) {
    char id[16];
    snprintf(id, sizeof id, "d-%s-%d", wall, room);
    json_array_append_new(json_object_get(plan, "doors"), json_pack("{s:s, s:s, s:f, s:f, s:s}", "id", id, "wall", wall,
                                                                    "at", at, "width", width, "kind", "opening"));
}

/* Furnishes a room: chairs and chests along the walls without the door. */
static void furnish(json_t *plan, int room, double x, double y, double inwards) {
    for (int p = 0; p < PIECES; p++) {
        int k = p % 8;
        double along = x - ROOM_WIDTH / 2 + 0.45 + 0.38 * k, deep = 0.3 + 0.05 * (double)((k * 3 + room) % 3);
        char id[16];
        snprintf(id, sizeof id, "f-%d-%d", room, p);
        double cx = p < 8 ? along : x + (k % 2 ? 1 : -1) * (ROOM_WIDTH / 2 - 0.3);
        double cy = p < 8 ? y + inwards * (ROOM_DEPTH - 0.25) : y + inwards * (0.9 + 0.5 * (k / 2));
        json_array_append_new(json_object_get(plan, "furniture"),
                              json_pack("{s:s, s:[f,f], s:[f,f]}", "id", id, "centre", cx, cy, "size",
                                        p < 8 ? 0.34 : deep, p < 8 ? deep : 0.4));
    }
}

static json_t *flat(double corridor, double door) {
    json_t *plan = json_pack("{s:s, s:i, s:s, s:[], s:[], s:[], s:[]}", "format", "clearance-house", "version", 1,
                             "name", "flat of eight rooms", "walls", "doors", "furniture", "exits");
    double low = ROOM_DEPTH, high = low + corridor + WALL, top = high + ROOM_DEPTH, length = ROOMS * ROOM_WIDTH;
    add_wall(plan, "south", 0, 0, length, 0);
    add_wall(plan, "north", 0, top, length, top);
    add_wall(plan, "west", 0, 0, 0, top);
    add_wall(plan, "east", length, 0, length, top);
    add_wall(plan, "low", 0, low, length, low);
    add_wall(plan, "high", 0, high, length, high);
    add_door(plan, "east", 0, (low + high) / 2, corridor);
    for (int r = 0; r < ROOMS; r++) {
        char id[16];
        double x = ROOM_WIDTH * r, middle = x + ROOM_WIDTH / 2;
        for (int side = 0; side < 2 && r > 0; side++) {
            snprintf(id, sizeof id, "p-%d-%d", r, side);
            add_wall(plan, id, x, side ? high : 0, x, side ? top : low);
        }
        add_door(plan, "low", r, middle, door);
        add_door(plan, "high", r, middle, door);
        furnish(plan, 2 * r, middle, low, -1);
        furnish(plan, 2 * r + 1, middle, high, 1);
    }
    json_array_append_new(json_object_get(plan, "exits"),
                          json_pack("{s:s, s:[f,f], s:[f,f]}", "id", "e", "from", length + WALL / 2, low + WALL / 2,
                                    "to", length + WALL / 2, high - WALL / 2));
    json_object_set_new(plan, "people",
                        json_pack("[{s:s, s:s, s:[f,f], s:i}]", "id", "p", "profile", "manual-chair", "at",
                                  ROOM_WIDTH / 2, low - 1.6, "heading", 90));
    return plan;
}

void houses_read_flat(House *house, const char *source, double corridor, double door) {
    read_made(house, source, flat(corridor, door));
}

void houses_read_flat_moved(House *house, const char *source, double corridor, double door, Vec2 away) {
    json_t *plan = flat(corridor, door), *furniture = json_object_get(plan, "furniture");
    json_t *piece = json_array_get(furniture, json_array_size(furniture) - 2 * PIECES + 3);
    json_t *centre = json_object_get(piece, "centre");
    json_array_set_new(centre, 0, json_real(json_number_value(json_array_get(centre, 0)) + away.x));
    json_array_set_new(centre, 1, json_real(json_number_value(json_array_get(centre, 1)) + away.y));
    read_made(house, source, plan);
}
