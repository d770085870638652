#include "window/gallery.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "check.h"
#include "desk.h"
#include "scratch.h"
#include "laboratory/laboratories.h"
#include "laboratory/thumbnail.h"
#include "lesson/look.h"

/* Waits until everything is loaded. */
static const GalleryItem *wait_for(Gallery *gallery, size_t *count) {
    while (!gallery_complete(gallery)) {
        gallery_update(gallery);
        usleep(5000);
    }
    return gallery_items(gallery, count);
}

/* Counts the pixels that differ from the first one, which is paper. */
static int drawn(const unsigned char *pixels) {
    int count = 0;
    for (int i = 0; i < GALLERY_WIDTH * GALLERY_HEIGHT; i++)
        count += memcmp(pixels + 4 * i, pixels, 3) != 0;
    return count;
}

/* The assets: the program's own, and a broken house. */
static void make_assets(void) {
    char from[200], to[200];
    desk_make();
    desk_write("assets/houses/corner.json", "{\"format\": \"clearance-house\", \"version\": 1,\n \"wals\": []}");
    for (int i = 0; i < 3; i++) {
        static const char *const files[][2] = {{"houses/hall-10000.json", "assets/houses/hall-10000.json"},
                                               {"houses/ube-techno-house.json", "assets/houses/a-house.json"},
                                               {"assets/beams/ibs.json", "assets/beams/ibs.json"}};
        snprintf(from, sizeof from, "%s", scratch_source(files[i][0]));
        char *text = scratch_read(from);
        snprintf(to, sizeof to, "%s", files[i][1]);
        desk_write(to, text);
        memory_free(text);
    }
    setenv("CLEARANCE_ASSETS", desk_path("assets"), 1);
}

static int cached_pictures(void) {
    int count = 0;
    DIR *folder = opendir(desk_path("cache/clearance"));
    for (struct dirent *entry; folder && (entry = readdir(folder));)
        count += strstr(entry->d_name, ".png") != NULL;
    if (folder)
        closedir(folder);
    return count;
}

TEST(all_that_comes_with_the_program_has_a_name_a_line_and_a_picture) {
    make_assets();
    Gallery *gallery = gallery_create(THEME_PAPER);
    size_t count;
    const GalleryItem *items = gallery_items(gallery, &count);
    CHECK(count == 4);
    static const char *const names[] = {"a-house", "corner", "hall-10000", "ibs"};
    for (size_t i = 0; i < count; i++) {
        CHECK_TEXT(items[i].name, names[i]);
        CHECK(items[i].laboratory == (i == 3));
    }
    items = wait_for(gallery, &count);
    for (size_t i = 0; i < count; i++) {
        CHECK(items[i].is_read && !items[i].fault == (i != 1) && !items[i].pixels == (i == 1));
        CHECK(!items[i].pixels || drawn(items[i].pixels) > 2000);
    }
    CHECK_TEXT(items[0].name, "Ube welfare techno-house (assumed plan)");
    CHECK(strncmp(items[0].line, "A single-storey barrier-free house", 34) == 0);
    CHECK_TEXT(items[1].name, "corner");
    CHECK(items[1].fault && strstr(items[1].fault, "corner.json:2:2: unknown key"));
    CHECK_TEXT(items[3].line, "Gu and Dubowsky's impact beam system (1995)");
    CHECK(cached_pictures() == 3);
    gallery_destroy(gallery);
}

TEST(a_picture_is_kept_and_drawn_anew_in_another_theme) {
    Gallery *gallery = gallery_create(THEME_PAPER);
    size_t count;
    const GalleryItem *items = wait_for(gallery, &count);
    unsigned char paper[4], *kept = memory_zeroed(GALLERY_HEIGHT, 4 * GALLERY_WIDTH);
    memcpy(kept, items[0].pixels, 4 * GALLERY_WIDTH * GALLERY_HEIGHT);
    memcpy(paper, items[0].pixels, 4);
    gallery_set_theme(gallery, THEME_BOARD);
    CHECK(!gallery_complete(gallery));
    items = wait_for(gallery, &count);
    CHECK(items[0].pixels[0] < 100 && paper[0] > 150);
    CHECK(cached_pictures() == 6);
    gallery_set_theme(gallery, THEME_PAPER);
    items = wait_for(gallery, &count);
    CHECK(memcmp(kept, items[0].pixels, 4 * GALLERY_WIDTH * GALLERY_HEIGHT) == 0);
    CHECK(cached_pictures() == 6);
    memory_free(kept);
    gallery_destroy(gallery);
}

TEST(it_can_be_closed_before_all_is_there_and_does_without_a_cache) {
    gallery_destroy(gallery_create(THEME_PAPER));
    setenv("XDG_CACHE_HOME", "/proc", 1);
    Gallery *gallery = gallery_create(THEME_BOARD);
    size_t count;
    const GalleryItem *items = wait_for(gallery, &count);
    CHECK(items[0].pixels && items[3].pixels);
    gallery_destroy(gallery);
    desk_remove();
}

static void check_line(const char *note, const char *expected) {
    char *text = memory_zeroed(strlen(note) + 200, 1), path[SCRATCH_PATH];
    snprintf(text, strlen(note) + 200,
             "{'format': 'clearance-house', 'version': 1, 'note': '%s', "
             "'walls': [{'id': 'w', 'points': [[0, 0], [1, 0]]}]}",
             note);
    scratch_write(path, text);
    Thumbnail thumbnail;
    Fault fault = {0};
    CHECK(thumbnail_read_house(&thumbnail, path, &fault));
    CHECK_TEXT(thumbnail.line, expected);
    CHECK_TEXT(thumbnail.name, strrchr(path, '/') + 1);
    thumbnail_clear(&thumbnail);
    fault_clear(&fault);
    unlink(path);
    memory_free(text);
}

TEST(a_line_is_the_first_sentence_shortened) {
    check_line("", "");
    check_line("one. Two.", "One");
    check_line("walls are 0.12 m thick. And so on", "Walls are 0.12 m thick");
    check_line("after J. Smith. And so on", "After J. Smith");
    check_line("assumed plan: a room. And so on", "A room (assumed plan)");
    check_line(
        "assumed plan: the fundamental passage, a leg of 4 m and W1 = 0.78 m, a right-angle corner to the left, a "
        "leg of 4 m",
        "The fundamental passage, a leg of 4 m and W1 = 0.78 m, a right-angle corner to the left (assumed plan)");
    check_line("a sentence whose first clause is longer than what a card of the gallery has room for, so that a word "
               "ends it, and not a clause",
               "A sentence whose first clause is longer than what a card of the gallery has room for");
    check_line(
        "a sentence of one clause only that is longer than what a card of the gallery has room for, a hundred of them",
        "A sentence of one clause only that is longer than what a card of the gallery has room for");
    check_line(
        "a sentence of one clause only that is a good deal longer than what a card of the gallery has room for",
        "A sentence of one clause only that is a good deal longer than what a card of the gallery has room \u2026");
}

static bool has_plot(const Laboratory *laboratory, void *session, const char *name) {
    for (size_t i = 0; i < laboratory->plot_count(session); i++)
        if (strcmp(laboratory->plot(session, i).name, name) == 0)
            return true;
    return false;
}

TEST(a_lesson_knows_the_layers_and_plots_of_each_laboratory) {
    static const char *const files[] = {[LESSON_HOUSE] = "houses/corner-1.80-1.80.json",
                                        [LESSON_BEAM] = "assets/beams/ibs.json",
                                        [LESSON_CRANK] = "assets/cranks/ssc.json"};
    char profiles[4096];
    snprintf(profiles, sizeof profiles, "%s", scratch_source("assets/profiles"));
    for (int l = LESSON_HOUSE; l <= LESSON_CRANK; l++) {
        const Laboratory *laboratory = laboratories[l].laboratory;
        Fault fault = {0};
        LaboratoryOptions options = {.profiles = profiles, .driving = -1, .seed = 1, .jobs = 1};
        void *session = laboratory->open(scratch_source(files[l]), &options, &fault);
        check_say(&fault);
        size_t count, layers = look_layers((LessonLaboratory)l);
        while (!laboratory->plot_count(session)) { /* a house has plots once its first run has begun */
            laboratory->update(session, 0);
            usleep(5000);
        }
        const char *const *plots = look_plots((LessonLaboratory)l, &count);
        CHECK(layers == (laboratory->layer_count < 9 ? laboratory->layer_count : 9));
        CHECK(count == laboratory->plot_count(session));
        for (size_t p = 0; p < count; p++)
            CHECK(has_plot(laboratory, session, plots[p]));
        laboratory->close(session);
    }
}
