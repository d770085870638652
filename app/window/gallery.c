#include "window/gallery.h"

#include <cairo.h>
#include <inttypes.h>
#include <pthread.h>
#include <stdint.h>
#include <string.h>

#include "base/digest.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "classroom/play.h"
#include "draw/cairo_memory.h"
#include "draw/layout.h"
#include "laboratory/laboratories.h"
#include "laboratory/shipped.h"
#include "paint/paint_cairo.h"
#include "paint/png.h"
#include "platform/folder.h"
#include "platform/settings.h"

enum {
    STRIDE = 4 * GALLERY_WIDTH, /* bytes a row */
    DRAWING = 1,                /* version of the drawing: to be increased when the pictures change */
};

/* The result of reading a file on the thread; texts and pixels are separate blocks. */
typedef struct Found {
    char *name, *line, *fault;
    size_t people;
    unsigned char *pixels; /* STRIDE x GALLERY_HEIGHT */
} Found;

struct Gallery {
    GalleryItem *items; /* (count) for the caller */
    Found *shown;       /* (count) owns the texts and pixels of the items */
    size_t count;
    Arena arena;
    char *cache; /* folder, or NULL */
    pthread_t thread;
    bool runs;            /* there is a thread */
    pthread_mutex_t lock; /* of the members below */
    pthread_cond_t changed;
    Found *found; /* (count) since the last update */
    bool news, closing;
    bool drawn; /* all pictures are drawn in this theme */
    Theme theme;
    unsigned revision; /* of the theme */
};

/* A picture -------------------------------------------------------------------------------------------------------- */

static void paint(const Scene *scene, unsigned char *pixels, Theme theme) {
    cairo_surface_t *surface =
        cairo_image_surface_create_for_data(pixels, CAIRO_FORMAT_RGB24, GALLERY_WIDTH, GALLERY_HEIGHT, STRIDE);
    cairo_t *cairo = cairo_create(surface);
    double unit = layout_unit(GALLERY_WIDTH, GALLERY_HEIGHT);
    cairo_scale(cairo, unit, unit);
    paint_cairo_scene(cairo, scene, vec2(GALLERY_WIDTH / unit, GALLERY_HEIGHT / unit), theme);
    cairo_memory_end(cairo);
    cairo_surface_finish(surface);
    cairo_surface_destroy(surface);
}

static bool read_thumbnail(Thumbnail *thumbnail, const GalleryItem *item, Fault *fault) {
    return laboratories[item->laboratory].read_thumbnail(thumbnail, item->drawn, fault);
}

/* Returns the path of a file's cached picture, to be released by memory_free. NULL: there is no cache. */
static char *cached_path(const Gallery *gallery, const char *path, Theme theme) {
    size_t size;
    char *text = gallery->cache ? text_read_file(path, JSON_LARGEST_FILE, &size) : NULL;
    if (!text)
        return NULL;
    uint64_t digest = digest_text(digest_bytes(DIGEST_START, text, size), CLEARANCE_VERSION);
    Text cached = {0};
    text_format(&cached, "%s/picture-%d-%d-%016" PRIx64 ".png", gallery->cache, DRAWING, (int)theme, digest);
    memory_free(text);
    return cached.text;
}

/* Reads a cached picture; false: it does not exist, or has another format. */
static bool read_cached(const char *path, unsigned char *pixels) {
    if (text_read_refusal(path))
        return false;
    cairo_surface_t *surface = cairo_image_surface_create_from_png(path);
    bool good = cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS &&
                cairo_image_surface_get_width(surface) == GALLERY_WIDTH &&
                cairo_image_surface_get_height(surface) == GALLERY_HEIGHT &&
                cairo_image_surface_get_format(surface) == CAIRO_FORMAT_RGB24;
    for (int y = 0; y < GALLERY_HEIGHT && good; y++)
        memcpy(pixels + y * STRIDE, cairo_image_surface_get_data(surface) + y * cairo_image_surface_get_stride(surface),
               STRIDE);
    cairo_surface_destroy(surface);
    return good;
}

/* Reads or draws the picture of an item. NULL: a fault says why not. */
static unsigned char *picture_of(const Gallery *gallery, const GalleryItem *item, Theme theme, Fault *fault) {
    unsigned char *pixels = memory_zeroed(GALLERY_HEIGHT, STRIDE);
    char *cached = cached_path(gallery, item->drawn, theme);
    Thumbnail thumbnail;
    bool good = cached && read_cached(cached, pixels);
    if (!good && (good = read_thumbnail(&thumbnail, item, fault))) {
        paint(&thumbnail.scene, pixels, theme);
        thumbnail_clear(&thumbnail);
        if (cached)
            png_write(cached, pixels, GALLERY_WIDTH, GALLERY_HEIGHT);
    }
    memory_free(cached);
    if (good)
        return pixels;
    memory_free(pixels);
    return NULL;
}

/* The thread ------------------------------------------------------------------------------------------------------- */

/* Moves the members that are not NULL, and releases those they replace. */
static void hand_over(Found *to, Found *from) {
    char **texts[][2] = {{&to->name, &from->name}, {&to->line, &from->line}, {&to->fault, &from->fault}};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        if (*texts[i][1]) {
            memory_free(*texts[i][0]);
            *texts[i][0] = *texts[i][1];
        }
    to->people = from->people ? from->people : to->people;
    if (from->pixels) {
        memory_free(to->pixels);
        to->pixels = from->pixels;
    }
    *from = (Found){.name = NULL};
}

static void found_clear(Found *found) {
    memory_free(found->name);
    memory_free(found->line);
    memory_free(found->fault);
    memory_free(found->pixels);
}

static void put(Gallery *gallery, size_t i, Found *found) {
    pthread_mutex_lock(&gallery->lock);
    hand_over(&gallery->found[i], found);
    gallery->news = true;
    pthread_mutex_unlock(&gallery->lock);
}

static char *fault_line(Fault *fault) {
    char *line = text_copy(fault->count ? fault->lines[0] : "it cannot be drawn");
    fault_clear(fault);
    return line;
}

static void find_text(Gallery *gallery, size_t i) {
    Thumbnail thumbnail;
    Fault fault = {0};
    Found found = {.name = NULL};
    if (read_thumbnail(&thumbnail, &gallery->items[i], &fault)) {
        if (!gallery->items[i].lesson)
            found.name = text_copy(thumbnail.name);
        found.people = thumbnail.people;
        found.line = text_copy(gallery->items[i].lesson ? gallery->items[i].about : thumbnail.line);
        thumbnail_clear(&thumbnail);
    } else {
        found.line = text_copy("");
        found.fault = fault_line(&fault);
    }
    put(gallery, i, &found);
}

static void find_picture(Gallery *gallery, size_t i, Theme theme) {
    Fault fault = {0};
    Found found = {.pixels = picture_of(gallery, &gallery->items[i], theme, &fault)};
    if (!found.pixels)
        found.fault = fault_line(&fault);
    put(gallery, i, &found);
}

/* True while the thread must go on drawing in the theme of this revision. */
static bool goes_on(Gallery *gallery, unsigned revision) {
    pthread_mutex_lock(&gallery->lock);
    bool on = !gallery->closing && gallery->revision == revision;
    pthread_mutex_unlock(&gallery->lock);
    return on;
}

/* Waits for another theme; false: the gallery is closing. */
static bool wait_for_theme(Gallery *gallery, unsigned *revision, Theme *theme) {
    pthread_mutex_lock(&gallery->lock);
    gallery->drawn = gallery->revision == *revision;
    gallery->news = true;
    while (!gallery->closing && gallery->revision == *revision)
        pthread_cond_wait(&gallery->changed, &gallery->lock);
    *revision = gallery->revision;
    *theme = gallery->theme;
    bool on = !gallery->closing;
    pthread_mutex_unlock(&gallery->lock);
    return on;
}

static void *work(void *context) {
    Gallery *gallery = context;
    unsigned revision = 0;
    Theme theme;
    pthread_mutex_lock(&gallery->lock);
    theme = gallery->theme;
    pthread_mutex_unlock(&gallery->lock);
    for (size_t i = 0; i < gallery->count; i++)
        find_text(gallery, i);
    do
        for (size_t i = 0; i < gallery->count && goes_on(gallery, revision); i++)
            find_picture(gallery, i, theme);
    while (wait_for_theme(gallery, &revision, &theme));
    return NULL;
}

/* The list --------------------------------------------------------------------------------------------------------- */

/* Adds the files of a laboratory in a folder. */
static void add_folder(Gallery *gallery, size_t laboratory, const char *from) {
    Folder folder = {.count = 0};
    Fault fault = {0};
    if (folder_read(&folder, from, NULL, &fault)) {
        size_t capacity = gallery->count;
        gallery->items =
            memory_reserve(gallery->items, &capacity, gallery->count + folder.count, sizeof *gallery->items);
        for (size_t i = 0; i < folder.count; i++)
            if (folder.entries[i].format && laboratory_find(folder.entries[i].format) == laboratory)
                gallery->items[gallery->count++] =
                    (GalleryItem){.path = arena_text(&gallery->arena, folder.entries[i].path),
                                  .drawn = arena_text(&gallery->arena, folder.entries[i].path),
                                  .name = thumbnail_name_of(folder.entries[i].name, &gallery->arena),
                                  .line = "",
                                  .laboratory = laboratory};
    }
    fault_clear(&fault);
    folder_clear(&folder);
}

/* Adds the files that come with the program for a laboratory, then those of the person and the site. */
static void add_folders(Gallery *gallery, size_t laboratory) {
    const char *shipped = laboratory_folder(laboratory), *name = strrchr(shipped, '/');
    add_folder(gallery, laboratory, shipped);
    for (size_t i = 0; name && shipped_own(i); i++)
        add_folder(gallery, laboratory, text_in_arena(&gallery->arena, "%s%s", shipped_own(i), name));
}

/* Adds the shipped lessons, with their titles. An invalid file is left out. */
static void add_lessons(Gallery *gallery) {
    static const char *const words[] = {[LESSON_HOUSE] = "house", [LESSON_BEAM] = "beam", [LESSON_CRANK] = "crank"};
    Folder folder = {.count = 0};
    Fault fault = {0};
    size_t capacity = gallery->count;
    if (folder_read(&folder, shipped_places()->lessons, NULL, &fault))
        gallery->items =
            memory_reserve(gallery->items, &capacity, gallery->count + folder.count, sizeof *gallery->items);
    for (size_t i = 0; i < folder.count; i++) {
        Lesson lesson = {.path = NULL};
        const char *format = folder.entries[i].format;
        if (!format || strcmp(format, "lesson") != 0 || !lesson_read(&lesson, folder.entries[i].path, &fault))
            continue;
        gallery->items[gallery->count++] = (GalleryItem){
            .lesson = true,
            .path = arena_text(&gallery->arena, folder.entries[i].path),
            .drawn = arena_text(&gallery->arena, lesson.file),
            .name = arena_text(&gallery->arena, lesson.title),
            .line = "",
            .about = text_in_arena(&gallery->arena, "A lesson of %d minutes, %s", lesson.minutes, lesson.level),
            .laboratory = laboratory_find(words[lesson.laboratory])};
        lesson_free(&lesson);
    }
    fault_clear(&fault);
    folder_clear(&folder);
}

Gallery *gallery_create(Theme theme) {
    Gallery *gallery = memory_zeroed(1, sizeof *gallery);
    gallery->theme = theme;
    gallery->cache = settings_cache_folder();
    for (size_t i = 0; i < laboratories_count; i++)
        add_folders(gallery, i);
    add_lessons(gallery);
    gallery->shown = memory_zeroed(gallery->count + 1, sizeof *gallery->shown);
    gallery->found = memory_zeroed(gallery->count + 1, sizeof *gallery->found);
    pthread_mutex_init(&gallery->lock, NULL);
    pthread_cond_init(&gallery->changed, NULL);
    gallery->runs = pthread_create(&gallery->thread, NULL, work, gallery) == 0;
    gallery->drawn = !gallery->runs; /* without a thread there are names but no pictures */
    return gallery;
}

void gallery_destroy(Gallery *gallery) {
    pthread_mutex_lock(&gallery->lock);
    gallery->closing = true;
    pthread_cond_signal(&gallery->changed);
    pthread_mutex_unlock(&gallery->lock);
    if (gallery->runs)
        pthread_join(gallery->thread, NULL);
    pthread_cond_destroy(&gallery->changed);
    pthread_mutex_destroy(&gallery->lock);
    for (size_t i = 0; i < gallery->count; i++) {
        found_clear(&gallery->found[i]);
        found_clear(&gallery->shown[i]);
    }
    memory_free(gallery->items);
    memory_free(gallery->found);
    memory_free(gallery->shown);
    memory_free(gallery->cache);
    arena_clear(&gallery->arena);
    memory_free(gallery);
}

void gallery_set_theme(Gallery *gallery, Theme theme) {
    pthread_mutex_lock(&gallery->lock);
    if (gallery->theme != theme) {
        gallery->theme = theme;
        gallery->revision++;
        gallery->drawn = !gallery->runs;
        pthread_cond_signal(&gallery->changed);
    }
    pthread_mutex_unlock(&gallery->lock);
}

bool gallery_update(Gallery *gallery) {
    pthread_mutex_lock(&gallery->lock);
    bool news = gallery->news;
    for (size_t i = 0; i < gallery->count && news; i++) {
        Found *shown = &gallery->shown[i];
        GalleryItem *item = &gallery->items[i];
        hand_over(shown, &gallery->found[i]);
        item->name = shown->name ? shown->name : item->name;
        item->line = shown->line ? shown->line : "";
        item->is_read = shown->line;
        item->people = shown->people;
        item->fault = shown->fault;
        item->pixels = shown->fault ? NULL : shown->pixels;
    }
    gallery->news = false;
    pthread_mutex_unlock(&gallery->lock);
    return news;
}

bool gallery_complete(Gallery *gallery) {
    pthread_mutex_lock(&gallery->lock);
    bool complete = gallery->drawn && !gallery->news;
    pthread_mutex_unlock(&gallery->lock);
    return complete;
}

const GalleryItem *gallery_items(const Gallery *gallery, size_t *count) {
    *count = gallery->count;
    return gallery->items;
}
