#include "window/act_view.h"
#include "window/notice.h"

#include <math.h>
#include <stdio.h>

#define ZOOM_STEP 1.25
#define PAN_STEP 0.1   /* of the view */
#define TURN_STEP 15.0 /* degrees */

static Vec2 looked_at(const Tab *tab) {
    Box frame = tab->view_layers.still.frame;
    return view_layers_floor(&tab->view_layers, vec2_scale(vec2_add(frame.low, frame.high), 0.5));
}

/* Pans by steps of the view's size. */
static void pan(Tab *tab, double right, double down) {
    Box frame = tab->view_layers.still.frame;
    Vec2 middle = vec2_scale(vec2_add(frame.low, frame.high), 0.5);
    Vec2 aside = vec2_add(middle, vec2(right * PAN_STEP * box_width(frame), down * PAN_STEP * box_height(frame)));
    tab_pan(tab, vec2_sub(view_layers_floor(&tab->view_layers, aside), view_layers_floor(&tab->view_layers, middle)));
}

static void turn(Tab *tab, double degrees) {
    tab->camera.azimuth = remainder(tab->camera.azimuth + degrees, 360);
    tab_apply_camera(tab);
}

static void toggle_raised(Window *window, Tab *tab) {
    if (!tab->laboratory->raised) {
        notice_post(window, "A %s has no raised view.", tab->laboratory->word);
        return;
    }
    tab->camera.kind = tab->camera.kind == VIEW_RAISED ? VIEW_PLAN : VIEW_RAISED;
    tab_apply_camera(tab);
}

static void follow(Window *window, Tab *tab) {
    tab->follows = !tab->follows;
    if (tab->follows && !tab->laboratory->selected(tab->session).kind)
        tab_select(tab, tab->laboratory->next(tab->session, (Item){0}, 1));
    if (tab->follows && tab->camera.zoom < 2)
        tab_show_selected(tab);
    notice_post(window, tab->follows ? "Following the selection" : "Following: off");
}

static void toggle_layer(Window *window, Tab *tab, int32_t key) {
    size_t layer = (size_t)(key - '1');
    if (key < '1' || layer >= tab->laboratory->layer_count)
        return;
    tab_toggle_layer(tab, layer);
    const char *name = tab->laboratory->layers[layer], *state = tab_layers(tab) & 1u << layer ? "shown" : "hidden";
    notice_post(window, "%s: %s", name, state);
    snprintf(window->echo, sizeof window->echo, "%zu   %s: %s", layer + 1, name, state);
}

bool act_view_do(Window *window, Tab *tab, Action action, int32_t key) {
    switch (action) {
    case ACTION_FIT:
        tab_fit(tab);
        return true;
    case ACTION_ZOOM_IN:
    case ACTION_ZOOM_OUT:
        tab_zoom(tab, action == ACTION_ZOOM_IN ? ZOOM_STEP : 1 / ZOOM_STEP, looked_at(tab));
        return true;
    case ACTION_ZOOM_SELECTION:
        tab_show_selected(tab);
        return true;
    case ACTION_RAISED:
        toggle_raised(window, tab);
        return true;
    case ACTION_FOLLOW:
        follow(window, tab);
        return true;
    case ACTION_TURN_LEFT:
    case ACTION_TURN_RIGHT:
        turn(tab, action == ACTION_TURN_LEFT ? -TURN_STEP : TURN_STEP);
        return true;
    case ACTION_PAN_LEFT:
    case ACTION_PAN_RIGHT:
        pan(tab, action == ACTION_PAN_LEFT ? -1 : 1, 0);
        return true;
    case ACTION_PAN_UP:
    case ACTION_PAN_DOWN:
        pan(tab, 0, action == ACTION_PAN_UP ? -1 : 1);
        return true;
    case ACTION_DRIVERS:
        toggle_layer(window, tab, (int32_t)('1' + tab_layer(tab, "drivers")));
        return true;
    case ACTION_LAYER:
        toggle_layer(window, tab, key);
        return true;
    default:
        return false;
    }
}
