/* A third laboratory, by a row of the table alone. The table below takes the place of the program's own, which is in an
 * object of its own. */
#include "laboratory/laboratories.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "check.h"
#include "desk.h"
#include "laboratory/shipped.h"
#include "platform/sdl_window.h"
#include "platform/settings.h"
#include "scratch.h"
#include "window/gallery.h"
#include "window/keys.h"
#include "window/script.h"
#include "window/window.h"

/* Called by the leak sanitizer, where there is one. SDL unloads the graphics driver, whose leaks have no names then and
 * cannot be suppressed by name. */
int __lsan_is_turned_off(void);
int __lsan_is_turned_off(void) {
    return 1;
}

static Laboratory garden;

const LaboratoryRow laboratories[] = {
    {&house_laboratory, "Houses.", "F2", offsetof(Shipped, houses), "corner-1.00-1.00.json", "speed",
     thumbnail_read_house},
    {&beam_laboratory, "Beams.", "F3", offsetof(Shipped, beams), "ibs.json", "phase", thumbnail_read_beam},
    {&garden, "Gardens.", "F8", offsetof(Shipped, furniture), "garden.json", "speed", thumbnail_read_house},
};
const size_t laboratories_count = 3;

static void *open_garden(const char *path, const LaboratoryOptions *options, Fault *fault) {
    (void)path;
    return house_laboratory.open(scratch_source("houses/corner-1.00-1.00.json"), options, fault);
}

/* Makes the garden a house by another name, and puts a garden among the files that come with the program. */
static void make_garden(void) {
    desk_make();
    desk_write("assets/furniture/garden.json", "{\"format\": \"clearance-garden\"}");
    CHECK(symlink(scratch_source("assets/profiles"), desk_path("assets/profiles")) == 0);
    CHECK(symlink(scratch_source("houses"), desk_path("assets/houses")) == 0);
    setenv("CLEARANCE_ASSETS", desk_path("assets"), 1);
    setenv("SDL_VIDEODRIVER", "offscreen", 1);
    garden = house_laboratory;
    garden.name = "Garden";
    garden.word = "garden";
    garden.open = open_garden;
}

TEST(a_file_of_a_third_laboratory_is_known) {
    make_garden();
    CHECK(laboratory_of(desk_path("assets/furniture/garden.json")) == 2);
    CHECK(laboratory_find("garden") == 2 && laboratory_find("meadow") == 3);
    Gallery *gallery = gallery_create(THEME_PAPER);
    size_t count;
    const GalleryItem *items = gallery_items(gallery, &count);
    CHECK(count > 1 && items[0].laboratory == 0 && items[count - 1].laboratory == 2);
    gallery_destroy(gallery);
}

TEST(a_third_laboratory_has_its_key) {
    CHECK(keys_find(sdl_window_key("F8"), 0, KEY_VIEW, true) == ACTION_LABORATORY + 2);
    CHECK_TEXT(keys_row(ACTION_LABORATORY + 2).name, "Garden");
}

TEST(a_window_opens_a_third_laboratory_by_file_key_and_script_and_remembers_it) {
    char script[SCRATCH_PATH], text[4096];
    snprintf(text, sizeof text,
             "expect laboratory garden\nkey F2\nwait 2\nexpect laboratory house\nkey F8\nwait 2\n"
             "expect laboratory garden\nspeed 0.25\nlaboratory house\nexpect laboratory house\nlaboratory garden\n"
             "expect laboratory garden\nexpect speed 0.25\nopen %s\nexpect laboratory house\nquit\n",
             scratch_source("houses/corner-1.00-1.00.json"));
    scratch_write(script, text);
    char *file = text_copy(desk_path("assets/furniture/garden.json"));
    WindowOptions options = {
        .file = file, .driving = -1, .theme = -1, .width = 800, .height = 600, .script = script, .jobs = 1};
    CHECK(window_run(&options) == 0);
    Settings settings;
    Fault notes = {0};
    settings_open(&settings, &notes);
    CHECK_NEAR(settings_laboratory(&settings, "garden")->speed, 0.25, 0);
    settings_close(&settings);
    fault_clear(&notes);
    memory_free(file);
    unlink(script);
    desk_remove();
}
