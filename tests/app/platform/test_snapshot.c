#include "platform/snapshot.h"

#include <jansson.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "check.h"
#include "desk.h"
#include "scratch.h"

/* A room with a static disc and a moving one. */
typedef struct Layers {
    Scene still, added, moving;
} Layers;

static void room_make(Layers *room) {
    *room = (Layers){.still = {.title = "Out in 3 s", .name = "room"}};
    Vec2 corners[] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    room->still.box = (Box){{0, 0}, {4, 3}};
    scene_add_polygon(&room->still, ROLE_WALL, corners, 4);
    scene_add_discs(&room->added, ROLE_LOCUS, 0.5, (Vec2[]){{1, 1}}, 1);
    scene_add_discs(&room->moving, ROLE_CHAIR, 0.5, (Vec2[]){{3, 1}}, 1);
}

static void room_clear(Layers *room) {
    scene_clear(&room->still);
    scene_clear(&room->added);
    scene_clear(&room->moving);
}

static const char *const command[] = {"run", "my room.json"};
static const SnapshotNote note = {
    .shows = "room", .command = command, .command_count = 2, .time = 3.5, .digest = "0123"};

static bool begins(const char *path, const char *with) {
    char *text = scratch_read(path);
    bool good = strncmp(text, with, strlen(with)) == 0;
    memory_free(text);
    return good;
}

static void check_note(const char *path) {
    json_t *object = json_load_file(path, 0, NULL);
    CHECK_TEXT(json_string_value(json_object_get(object, "shows")), "room");
    CHECK_TEXT(json_string_value(json_object_get(object, "command")), "clearance run 'my room.json'");
    CHECK_TEXT(json_string_value(json_object_get(object, "digest")), "0123");
    CHECK_NEAR(json_number_value(json_object_get(object, "time")), 3.5, 0);
    const char *program = json_string_value(json_object_get(object, "program"));
    CHECK(program && strncmp(program, "clearance ", 10) == 0);
    json_decref(object);
}

TEST(a_view_is_written_in_each_kind_with_a_note_and_over_nothing) {
    desk_make();
    Layers room;
    room_make(&room);
    Fault fault = {0};
    SnapshotView view = {
        .still = &room.still, .added = &room.added, .moving = &room.moving, .width = 320, .height = 200};
    char *first = snapshot_view(&view, SNAPSHOT_PNG | SNAPSHOT_SVG | SNAPSHOT_PDF, ".", "my room: plan", &note, &fault);
    CHECK_TEXT(first, "./my-room-plan");
    CHECK(begins("my-room-plan.png", "\x89PNG") && begins("my-room-plan.pdf", "%PDF"));
    CHECK(begins("my-room-plan.svg", "<?xml"));
    check_note("my-room-plan.json");
    char *second = snapshot_view(&view, SNAPSHOT_SVG, ".", "my room: plan", &note, &fault);
    CHECK_TEXT(second, "./my-room-plan-2");
    char *a = scratch_read("my-room-plan.svg"), *b = scratch_read("my-room-plan-2.svg");
    CHECK_TEXT(a, b);
    memory_free(a);
    memory_free(b);
    room_clear(&room);
    memory_free(first);
    memory_free(second);
    desk_remove();
}

TEST(the_layers_are_all_in_a_view) {
    desk_make();
    Layers room;
    room_make(&room);
    Fault fault = {0};
    SnapshotView view = {.still = &room.still, .width = 320, .height = 200};
    memory_free(snapshot_view(&view, SNAPSHOT_SVG, ".", "still", &note, &fault));
    view.added = &room.added;
    memory_free(snapshot_view(&view, SNAPSHOT_SVG, ".", "added", &note, &fault));
    view.moving = &room.moving;
    memory_free(snapshot_view(&view, SNAPSHOT_SVG, ".", "all", &note, &fault));
    char *still = scratch_read("still.svg"), *added = scratch_read("added.svg"), *all = scratch_read("all.svg");
    CHECK(*still && strlen(added) > strlen(still) && strlen(all) > strlen(added));
    memory_free(still);
    memory_free(added);
    memory_free(all);
    room_clear(&room);
    desk_remove();
}

TEST(a_raised_view_is_written_of_its_pixels_only) {
    desk_make();
    Layers room;
    room_make(&room);
    room.still.camera = (Camera){.kind = VIEW_RAISED, .azimuth = VIEW_AZIMUTH, .elevation = VIEW_ELEVATION};
    Fault fault = {0};
    unsigned char pixels[8 * 4 * 4];
    memset(pixels, 0x7f, sizeof pixels);
    SnapshotView view = {.still = &room.still, .width = 8, .height = 4};
    CHECK(!snapshot_view(&view, SNAPSHOT_PNG, ".", "raised", &note, &fault));
    view.pixels = pixels;
    CHECK(!snapshot_view(&view, SNAPSHOT_PNG | SNAPSHOT_SVG, ".", "raised", &note, &fault));
    CHECK(fault.count == 2 && access("raised.png", F_OK) != 0 && access("raised.json", F_OK) != 0);
    char *path = snapshot_view(&view, SNAPSHOT_PNG, ".", "raised", &note, &fault);
    CHECK_TEXT(path, "./raised");
    CHECK(begins("raised.png", "\x89PNG"));
    memory_free(path);
    fault_clear(&fault);
    room_clear(&room);
    desk_remove();
}

TEST(a_plot_is_written_also_as_columns) {
    desk_make();
    static const double x[] = {0, 1, 2}, y[] = {0, 1, 4};
    PlotSeries series = {.name = "speed", .x = x, .y = y, .count = 3, .role = ROLE_LOCUS, .width = 2};
    Plot plot = {.title = "Speed",
                 .x = {.title = "time", .unit = "s"},
                 .y = {.title = "speed", .unit = "m/s"},
                 .series = &series,
                 .series_count = 1};
    Fault fault = {0};
    char *path = snapshot_plot(&plot, &(PlotSheet){400, 300, THEME_BOARD, NULL}, SNAPSHOT_PNG | SNAPSHOT_CSV, ".",
                               "speed", &note, &fault);
    CHECK_TEXT(path, "./speed");
    CHECK(begins("speed.png", "\x89PNG") && begins("speed.csv", "time [s],speed [m/s]\r\n0,0\r\n1,1\r\n"));
    memory_free(path);
    desk_remove();
}

TEST(what_cannot_be_written_is_a_fault_and_leaves_nothing_half) {
    desk_make();
    Layers room;
    room_make(&room);
    Fault fault = {0};
    SnapshotView view = {.still = &room.still, .width = 320, .height = 200};
    CHECK(!snapshot_view(&view, SNAPSHOT_PNG, "nowhere", "x", &note, &fault));
    CHECK_TEXT(fault.count ? fault.lines[0] : "", "nowhere/x.json cannot be written: No such file or directory");
    view.width = 0;
    CHECK(!snapshot_view(&view, SNAPSHOT_SVG, ".", "x", &note, &fault));
    CHECK(access("x.json", F_OK) != 0);
    fault_clear(&fault);
    room_clear(&room);
    desk_remove();
}
