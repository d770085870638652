#include "window/room.h"

#include <math.h>
#include <string.h>

#include "base/clock.h"
#include "base/text.h"
#include "live/live_edit.h"

#define LEAST_SEEN 8.0 /* m, of what can be edited: a house begins with nothing */
#define ASPECT 1.5     /* of what has no size */
#define ZOOM_LEAST 0.2
#define ZOOM_MOST 64.0
#define ZOOM_NEAR 3.0   /* times its size is seen around what is selected */
#define FOLLOW_FREE 0.2 /* of the view: who is followed moves freely within it */

Room room_make(const LiveKind *kind) {
    return (Room){.kind = kind,
                  .player = player_start(),
                  .layers = kind->layers_at_first,
                  .plots = kind->plots_at_first,
                  .charts_wait = true};
}

static void drop_live(Room *room) {
    if (room->live)
        room->kind->close(room->live);
    memory_free(room->path);
    memory_free(room->origin);
    room->live = NULL;
    room->path = room->origin = NULL;
}

void room_close(Room *room, PaintGlScreen *screen) {
    charts_clear(&room->charts, screen);
    scenery_clear(&room->scenery);
    drop_live(room);
}

static void keep_shape(Room *room) {
    Box box = room->kind->still(room->live)->box;
    double width = box_width(box), height = box_height(box);
    room->shape = box;
    room->aspect = width > 0 && height > 0 ? width / height : ASPECT;
}

/* All of it, but never from so near that there is no room to draw. */
static void fit(Room *room) {
    keep_shape(room);
    room->handled = false;
    room->fits = true;
    double size = fmax(box_width(room->shape), box_height(room->shape));
    room->camera.zoom = room->kind->editor ? fmin(1, fmax(size / LEAST_SEEN, ZOOM_LEAST)) : 1;
}

bool room_open(Room *room, const char *path, const LiveOptions *options, PaintGlScreen *screen, Fault *fault) {
    void *live = room->kind->open(path, options, fault);
    if (!live)
        return false;
    char *kept = path ? text_copy(path) : NULL; /* it may be the path of what is closed */
    charts_clear(&room->charts, screen);
    drop_live(room);
    room->live = live;
    room->path = kept;
    int power = room->player.power;
    room->player = player_start();
    room->player.power = power;
    room->camera = (Camera){.kind = room->camera.kind, .azimuth = VIEW_AZIMUTH, .elevation = VIEW_ELEVATION, .zoom = 1};
    room->follows = false;
    room->charts_wait = true;
    fit(room);
    scenery_forget(&room->scenery);
    room->kind->reveal(live, room_layers(room));
    room_look(room);
    return true;
}

/* What a thing takes up now, m; false: it is nowhere. */
static bool box_of(const Room *room, LiveThing thing, Box *box) {
    Vec2 points[LIVE_OUTLINE_MOST];
    if (!room->live || !thing.kind)
        return false;
    size_t count = room->kind->outline(room->live, thing, room->player.time, points);
    *box = box_empty();
    for (size_t i = 0; i < count; i++)
        *box = box_include(*box, points[i]);
    return count > 0;
}

/* Keeps what is followed in the middle of the view. */
static void follow(Room *room) {
    Box box;
    LiveThing thing = room->kind->selected(room->live);
    if (!room->follows || !room->scenery.painted || !box_of(room, thing, &box))
        return;
    Vec2 at = scenery_point(&room->scenery, vec2_scale(vec2_add(box.low, box.high), 0.5));
    Box plan = room->scenery.still.frame;
    Vec2 middle = vec2_scale(vec2_add(plan.low, plan.high), 0.5), away = vec2_sub(at, middle);
    if (fabs(away.x) < FOLLOW_FREE * box_width(plan) && fabs(away.y) < FOLLOW_FREE * box_height(plan))
        return;
    room_pan(room, vec2_sub(scenery_floor(&room->scenery, at), scenery_floor(&room->scenery, middle)));
}

/* How many times as large a box is that fits the same place as another one. */
static double fitting(const Room *room, Box box, Box other) {
    Box place = room->scenery.still.plan;
    double aspect = box_height(place) > 0 ? box_width(place) / box_height(place) : room->aspect;
    return fmax(box_width(other) / aspect, box_height(other)) / fmax(box_width(box) / aspect, box_height(box));
}

static Vec2 middle_of(Box box) {
    return vec2_scale(vec2_add(box.low, box.high), 0.5);
}

/* A plan that becomes larger or smaller under the hand does not move before the eye. */
static void keep_eye(Room *room) {
    Box box = room->kind->still(room->live)->box, shape = room->shape;
    const LiveEditor *editor = room->kind->editor;
    room->handled |= editor && (editor->edits(room->live) > 0 || editor->gesture(room->live)->active);
    if (!room->handled) {
        if (room->fits)
            fit(room);
        else
            keep_shape(room);
        room_look(room);
        return;
    }
    bool same = box.low.x == shape.low.x && box.low.y == shape.low.y && box.high.x == shape.high.x &&
                box.high.y == shape.high.y;
    if (same || box_width(box) <= 0)
        return;
    room->camera.pan = vec2_add(room->camera.pan, vec2_sub(middle_of(shape), middle_of(box)));
    room->camera.zoom /= fitting(room, box, shape);
    room->shape = box;
    room_look(room);
}

unsigned room_update(Room *room, double seconds) {
    if (!room->live)
        return 0;
    const LiveKind *kind = room->kind;
    double begun = clock_now();
    LiveSpan span = kind->span(room->live);
    double wish = player_wish(&room->player, seconds, &span);
    kind->reach(room->live, wish);
    unsigned changes = kind->update(room->live, room->player.time);
    span = kind->span(room->live);
    player_advance(&room->player, seconds, wish, &span);
    room->worked += clock_now() - begun;
    follow(room);
    if (changes & LIVE_VIEW) {
        keep_eye(room);
        changes |= kind->update(room->live, room->player.time); /* it is looked at so from this moment on */
        scenery_forget(&room->scenery);
    }
    if (changes & LIVE_PLOTS)
        room->charts_wait = true;
    return changes;
}

/* Layers ----------------------------------------------------------------------------------------------------------- */

static bool is_names(const Room *room, size_t layer) {
    return strcmp(room->kind->layers[layer], "names") == 0;
}

unsigned room_layers(const Room *room) {
    unsigned layers = room->layers;
    for (size_t i = 0; i < room->kind->layer_count && room->cramped; i++)
        if (is_names(room, i))
            layers = room->named ? layers | 1u << i : layers & ~(1u << i);
    return layers;
}

void room_toggle_layer(Room *room, size_t layer) {
    if (room->cramped && is_names(room, layer))
        room->named = !room->named;
    else
        room->layers ^= 1u << layer;
    room->kind->reveal(room->live, room_layers(room));
}

void room_cramp(Room *room, bool cramped) {
    if (room->cramped == cramped)
        return;
    room->cramped = cramped;
    room->named = false;
    if (room->live)
        room->kind->reveal(room->live, room_layers(room));
}

/* Looking ---------------------------------------------------------------------------------------------------------- */

void room_look(Room *room) {
    if (room->live)
        room->kind->look(room->live, room->camera);
}

void room_zoom(Room *room, double times, Vec2 about) {
    double zoom = fmin(fmax(room->camera.zoom * times, ZOOM_LEAST), ZOOM_MOST);
    const Scene *still = room->kind->still(room->live);
    Vec2 middle = vec2_add(vec2_scale(vec2_add(still->box.low, still->box.high), 0.5), room->camera.pan);
    Vec2 moved = vec2_scale(vec2_sub(about, middle), 1 - room->camera.zoom / zoom);
    room->fits = false;
    room->camera.pan = vec2_add(room->camera.pan, moved);
    room->camera.zoom = zoom;
    room_look(room);
}

void room_pan(Room *room, Vec2 metres) {
    room->fits = false;
    room->camera.pan = vec2_add(room->camera.pan, metres);
    room_look(room);
}

void room_fit(Room *room) {
    room->camera.pan = vec2(0, 0);
    room->camera.azimuth = VIEW_AZIMUTH;
    room->camera.elevation = VIEW_ELEVATION;
    room->follows = false;
    fit(room);
    room_look(room);
}

void room_select(Room *room, LiveThing thing) {
    room->kind->select(room->live, thing);
}

void room_show_selected(Room *room) {
    Box box;
    if (!box_of(room, room->kind->selected(room->live), &box))
        return;
    room->fits = false;
    const Scene *still = room->kind->still(room->live);
    Vec2 all = vec2_scale(vec2_add(still->box.low, still->box.high), 0.5);
    double size = ZOOM_NEAR * fmax(fmax(box_width(box), box_height(box)), 0.25);
    room->camera.pan = vec2_sub(vec2_scale(vec2_add(box.low, box.high), 0.5), all);
    room->camera.zoom = fmin(fmax(fmin(box_width(still->box), box_height(still->box)) / size, 1), ZOOM_MOST);
    room_look(room);
}

void room_seek(Room *room, double time) {
    LiveSpan span = room->kind->span(room->live);
    player_seek(&room->player, time, &span);
}
