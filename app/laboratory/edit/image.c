#include "laboratory/edit/image.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/digest.h"
#include "base/text.h"
#include "plan/draft_file.h"
#include "laboratory/edit/chain.h"
#include "laboratory/edit/field.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/marks.h"

static const double FIRST_WIDTH = 10; /* m, width before the scale is known */
static const double FIRST_OPACITY = 0.5;
static const double LEAST_APART = 0.01; /* m, least distance of two points that define a scale or an angle */

enum { IMAGE_LARGEST = 256 * 1024 * 1024 /* bytes */, HEADER = 24 /* bytes of a PNG header that includes the size */ };

enum { ITEM_SCALE, ITEM_LEVEL }; /* the rows of the tool */

#define FADE "Fade picture"

static const EditGesture image_gesture;

/* Files ----------------------------------------------------------------------------------------------------------- */

/* Returns height / width of a PNG file's bytes; 0: not a PNG file. */
static double shape_of(const char *bytes, size_t count) {
    static const unsigned char signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    const unsigned char *at = (const unsigned char *)bytes;
    if (count < HEADER || memcmp(at, signature, sizeof signature) != 0)
        return 0;
    double width = at[16] * 16777216.0 + at[17] * 65536.0 + at[18] * 256.0 + at[19];
    double height = at[20] * 16777216.0 + at[21] * 65536.0 + at[22] * 256.0 + at[23];
    return width > 0 ? height / width : 0;
}

/* Reads shape and digest of a file. False: errno gives the reason, 0 if the file is not a PNG picture. */
static bool look_at(const char *path, double *shape, char digest[17]) {
    size_t count = 0;
    char *bytes = text_read_file(path, IMAGE_LARGEST, &count);
    *shape = 0;
    if (!bytes)
        return false;
    *shape = shape_of(bytes, count);
    snprintf(digest, 17, "%016llx", (unsigned long long)digest_bytes(DIGEST_START, bytes, count));
    memory_free(bytes);
    errno = 0;
    return *shape > 0;
}

/* Returns the folder of the house file with its "/"; release it with memory_free. "": the house has no file. */
static char *folder_of(const Editor *edit) {
    const char *path = edit->options.path;
    char whole[PATH_MAX];
    Text folder = {0};
    text_add(&folder, "");
    if (*path && realpath(path, whole)) {
        *(strrchr(whole, '/') + 1) = 0;
        text_add(&folder, whole);
    }
    return folder.text;
}

/* Returns the path as written to the house file: relative to the house's folder if the image lies within it. Release
 * the path with memory_free. */
static char *as_written(const Editor *edit, const char *path) {
    char whole[PATH_MAX], *folder = folder_of(edit);
    size_t length = strlen(folder);
    Text text = {0};
    const char *found = realpath(path, whole) ? whole : path;
    text_add(&text, length && strncmp(found, folder, length) == 0 ? found + length : found);
    memory_free(folder);
    return text.text;
}

/* Returns the path that a house file's `image` stands for: the inverse of as_written. */
static char *as_found(const Editor *edit, const char *image) {
    char *folder = *image == '/' ? NULL : folder_of(edit);
    Text text = {0};
    text_format(&text, "%s%s", folder ? folder : "", image);
    memory_free(folder);
    return text.text;
}

/* Looks for the trace image again if its path has changed. */
static void find(Editor *edit) {
    const Background *background = &draft_plan(edit->draft)->background;
    char *path = background->image ? as_found(edit, background->image) : NULL;
    if (edit->image && path && strcmp(edit->image, path) == 0) {
        memory_free(path);
        return;
    }
    memory_free(edit->image);
    edit->image = path;
    edit->image_shape = 0;
    edit->image_other = false;
    char digest[17] = "";
    if (path && look_at(path, &edit->image_shape, digest))
        edit->image_other = *background->digest && strcmp(digest, background->digest) != 0;
}

const char *edit_image_error(Editor *edit) {
    find(edit);
    if (!edit->image)
        return NULL;
    return !edit->image_shape  ? "the picture to trace over was not found"
           : edit->image_other ? "the picture to trace over has changed since it was chosen"
                               : NULL;
}

/* Setting --------------------------------------------------------------------------------------------------------- */

static json_t *element_of(const Background *background) {
    return json_pack("{s:s, s:[o, o], s:o, s:o, s:o, s:s}", "image", background->image, "at",
                     json_number(background->at.x), json_number(background->at.y), "width",
                     json_number(background->width), "angle", json_number(background->angle), "opacity",
                     json_number(background->opacity), "digest", background->digest);
}

static bool remove_image(Editor *edit, Fault *fault) {
    edit_gesture_begin_step(edit, "Remove picture");
    draft_set_house(edit->draft, "background", NULL);
    return edit_gesture_end_step(edit, fault);
}

bool edit_image_set(Editor *edit, const char *path, Fault *fault) {
    char digest[17] = "";
    double shape;
    if (!path || !*path)
        return remove_image(edit, fault);
    if (!look_at(path, &shape, digest)) {
        if (errno)
            fault_add(fault, "%s cannot be read: %s", path, text_read_reason(errno));
        else
            fault_add(fault, "%s is not a PNG picture; only PNG pictures can be traced over", path);
        return false;
    }
    char *image = as_written(edit, path);
    Background background = {.image = image, .width = FIRST_WIDTH, .opacity = FIRST_OPACITY, .digest = digest};
    edit_gesture_begin_step(edit, "Trace over a picture");
    draft_set_house(edit->draft, "background", element_of(&background));
    memory_free(image);
    edit->chosen_rows[TOOL_IMAGE] = ITEM_SCALE;
    memory_free(edit->image); /* the image will be read again */
    edit->image = NULL;
    return edit_gesture_end_step(edit, fault);
}

void edit_image_fade(Editor *edit, double opacity) {
    Fault none = {0};
    if (!draft_plan(edit->draft)->background.image)
        return;
    Background background = draft_plan(edit->draft)->background;
    char *image = text_copy(background.image), *digest = text_copy(background.digest);
    background.image = image;
    background.digest = digest;
    background.opacity = real_clamp(opacity, 0, 1);
    const char *last = draft_undo_name(edit->draft);
    edit_gesture_cancel(edit);
    if (last && strcmp(last, FADE) == 0)
        draft_undo(edit->draft); /* one undo step, however often the slider reports its position */
    edit_gesture_begin_step(edit, FADE);
    draft_set_house(edit->draft, "background", element_of(&background));
    edit_gesture_end_step(edit, &none);
    fault_clear(&none);
    memory_free(image);
    memory_free(digest);
}

TraceImage edit_image_get(Editor *edit) {
    const Background *background = &draft_plan(edit->draft)->background;
    find(edit);
    if (!background->image || !edit->image_shape)
        return (TraceImage){.path = NULL};
    Vec2 axis = snap_heading(background->angle), along = vec2_scale(axis, background->width);
    Vec2 up = vec2_scale(vec2_left(axis), background->width * edit->image_shape);
    Vec2 at = background->at;
    return (TraceImage){.path = edit->image,
                        .corners = {at, vec2_add(at, along), vec2_add(vec2_add(at, along), up), vec2_add(at, up)},
                        .opacity = background->opacity};
}

/* The tool --------------------------------------------------------------------------------------------------------- */

static bool levels(const Editor *edit) {
    return edit->chosen_rows[TOOL_IMAGE] == ITEM_LEVEL;
}

static void list_fields(Editor *edit) {
    static const char *const place[] = {"x", "y"}, *const length[] = {"real length"}, *const metres[] = {"m", "m"};
    bool both = edit->chain.count == 2;
    edit_field_list(edit, both ? length : place, metres, both ? 1 : 2);
}

void edit_image_begin(Editor *edit, bool keys) {
    edit_gesture_begin(edit, &image_gesture, levels(edit) ? "Level picture" : "Scale picture", keys);
    list_fields(edit);
    edit_gesture_update(edit);
}

static void update(Editor *edit) {
    EditTarget *now = &edit->now;
    if (edit->chain.count == 2) {
        now->amount = vec2_distance(edit->chain.points[0], edit->chain.points[1]);
        edit_field_typed(edit, 0, &now->amount);
        edit_field_show(edit, 0, now->amount);
        return;
    }
    if (!edit->keys)
        now->at = edit->pointer.at;
    edit_field_typed(edit, 0, &now->at.x);
    edit_field_typed(edit, 1, &now->at.y);
    edit_field_show(edit, 0, now->at.x);
    edit_field_show(edit, 1, now->at.y);
}

/* Turns and scales the picture about a fixed point. */
static void turn_about(Background *background, Vec2 point, double angle, double factor) {
    Vec2 from = vec2_scale(vec2_sub(background->at, point), factor);
    Vec2 at = vec2_add(point, vec2_turn(from, snap_heading(angle)));
    background->at = vec2(snap_tidy(at.x), snap_tidy(at.y));
    background->angle = snap_tidy(remainder(background->angle + angle, 360));
    background->width = snap_tidy(background->width * factor);
}

static void make(Editor *edit) {
    Background background = edit->plan_before.background;
    if (edit->chain.count < 2 || !background.image)
        return;
    Vec2 a = edit->chain.points[0], along = vec2_sub(edit->chain.points[1], a);
    double angle = snap_angle(along);
    if (levels(edit))
        turn_about(&background, a, snap_tidy(round(angle / 90) * 90 - angle), 1);
    else
        turn_about(&background, a, 0, edit->now.amount / vec2_length(along));
    draft_set_house(edit->draft, "background", element_of(&background));
}

static bool finish(Editor *edit) {
    bool levelled = levels(edit);
    if (edit->refusal || !edit_gesture_end(edit))
        return false;
    edit->chosen_rows[TOOL_IMAGE] = levelled ? ITEM_SCALE : ITEM_LEVEL;
    return true;
}

static bool confirm(Editor *edit, bool keys) {
    EditChain *chain = &edit->chain;
    (void)keys;
    if (chain->count == 2)
        return finish(edit);
    if (chain->count == 1 && vec2_distance(chain->points[0], edit->now.at) < LEAST_APART)
        return false;
    chain->points = memory_reserve(chain->points, &chain->capacity, chain->count + 1, sizeof *chain->points);
    chain->points[chain->count++] = edit->now.at;
    list_fields(edit);
    edit_gesture_update(edit);
    return chain->count == 2 && levels(edit) ? finish(edit) : true;
}

static bool back(Editor *edit) {
    if (edit->chain.count <= 1) {
        edit_gesture_cancel(edit);
        return true;
    }
    edit->chain.count--;
    list_fields(edit);
    edit_gesture_update(edit);
    return true;
}

static void release(Editor *edit, bool moved) {
    if (moved && edit->chain.count < 2)
        confirm(edit, false);
}

static void describe(Editor *edit, Text *text) {
    if (edit->chain.count == 2)
        text_add(text, "Type the real length, then press Enter.");
    else
        text_add(text, levels(edit) ? "Click a second point that is level with the first, or straight above it."
                                    : "Click a second point at a known distance from the first.");
}

static void show(Editor *edit) {
    if (edit->chain.count)
        edit_marks_line(edit, edit->chain.points[0], edit->chain.count == 2 ? edit->chain.points[1] : edit->now.at);
}

static const EditGesture image_gesture = {.update = update,
                                          .make = make,
                                          .confirm = confirm,
                                          .back = back,
                                          .release = release,
                                          .describe = describe,
                                          .show = show,
                                          .end = edit_chain_clear};
