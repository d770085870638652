#include "window/act_view.h"

#include <math.h>

#include "window/act.h"

#define ZOOM_STEP 1.25
#define PAN_STEP 0.1   /* of the view */
#define TURN_STEP 15.0 /* degrees */

static Vec2 looked_at(const Room *room) {
    Box frame = room->scenery.still.frame;
    return scenery_floor(&room->scenery, vec2_scale(vec2_add(frame.low, frame.high), 0.5));
}

/* By parts of the view, on the page. */
static void pan(Room *room, double right, double down) {
    Box frame = room->scenery.still.frame;
    Vec2 middle = vec2_scale(vec2_add(frame.low, frame.high), 0.5);
    Vec2 aside = vec2_add(middle, vec2(right * PAN_STEP * box_width(frame), down * PAN_STEP * box_height(frame)));
    room_pan(room, vec2_sub(scenery_floor(&room->scenery, aside), scenery_floor(&room->scenery, middle)));
}

static void turn(Room *room, double degrees) {
    room->camera.azimuth = remainder(room->camera.azimuth + degrees, 360);
    room_look(room);
}

static void toggle_raised(Window *window, Room *room) {
    if (!room->kind->raised) {
        act_say(window, "a beam is seen from the side only");
        return;
    }
    room->camera.kind = room->camera.kind == VIEW_RAISED ? VIEW_PLAN : VIEW_RAISED;
    room_look(room);
}

static void follow(Window *window, Room *room) {
    room->follows = !room->follows;
    if (room->follows && !room->kind->selected(room->live).kind)
        room_select(room, room->kind->next(room->live, (LiveThing){0}, 1));
    if (room->follows && room->camera.zoom < 2)
        room_show_selected(room);
    act_say(window, room->follows ? "following what is selected" : "not following");
}

static void toggle_layer(Window *window, Room *room, int32_t key) {
    size_t layer = (size_t)(key - '1');
    if (key < '1' || layer >= room->kind->layer_count)
        return;
    room_toggle_layer(room, layer);
    act_say(window, "%s: %s", room->kind->layers[layer], room_layers(room) & 1u << layer ? "shown" : "hidden");
}

bool act_view_do(Window *window, Room *room, Action action, int32_t key) {
    switch (action) {
    case ACTION_FIT:
        room_fit(room);
        return true;
    case ACTION_ZOOM_IN:
    case ACTION_ZOOM_OUT:
        room_zoom(room, action == ACTION_ZOOM_IN ? ZOOM_STEP : 1 / ZOOM_STEP, looked_at(room));
        return true;
    case ACTION_ZOOM_SELECTION:
        room_show_selected(room);
        return true;
    case ACTION_RAISED:
        toggle_raised(window, room);
        return true;
    case ACTION_FOLLOW:
        follow(window, room);
        return true;
    case ACTION_TURN_LEFT:
    case ACTION_TURN_RIGHT:
        turn(room, action == ACTION_TURN_LEFT ? -TURN_STEP : TURN_STEP);
        return true;
    case ACTION_PAN_LEFT:
    case ACTION_PAN_RIGHT:
        pan(room, action == ACTION_PAN_LEFT ? -1 : 1, 0);
        return true;
    case ACTION_PAN_UP:
    case ACTION_PAN_DOWN:
        pan(room, 0, action == ACTION_PAN_UP ? -1 : 1);
        return true;
    case ACTION_LAYER:
        toggle_layer(window, room, key);
        return true;
    default:
        return false;
    }
}
