#include "window/tab.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/choice.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "laboratory/edit/editor.h"

#define SMALLEST 3.0   /* m: a smaller plan is one that is begun, */
#define LEAST_SEEN 8.0 /* m, and this much of it is seen, as room to draw in */
#define ASPECT 1.5     /* of contents without a size */
#define ZOOM_LEAST 0.2
#define ZOOM_MOST 64.0
#define ZOOM_NEAR 3.0   /* times the size of the selection that zooming to it shows */
#define NEAR_SEEN 4.0   /* m, that zooming to a selection shows at least: what is around it explains it */
#define TRIAL_SEEN 4.5  /* m, about the tight place, while a fix is shown beside it */
#define SAME_PLACE 1.0  /* design points: a plan that fits exactly stands still */
#define FOLLOW_FREE 0.2 /* of the view, within which a followed person moves freely */

Tab tab_make(const Laboratory *kind) {
    return (Tab){.laboratory = kind,
                 .player = player_start(),
                 .layers = kind->layers_at_first,
                 .plots = kind->plots_at_first,
                 .plot_panes_stale = true};
}

static void close_session(Tab *tab) {
    trial_clear(&tab->trial);
    if (tab->session)
        tab->laboratory->close(tab->session);
    memory_free(tab->path);
    memory_free(tab->origin);
    tab->session = NULL;
    tab->path = tab->origin = NULL;
}

void tab_close(Tab *tab, PaintGlScreen *screen) {
    plot_panes_clear(&tab->panes, screen);
    view_layers_clear(&tab->view_layers);
    view_layers_clear(&tab->trial_layers);
    close_session(tab);
}

static void keep_shape(Tab *tab) {
    Box box = tab->laboratory->still(tab->session)->box;
    double width = box_width(box), height = box_height(box);
    tab->shape = box;
    tab->aspect = width > 0 && height > 0 ? width / height : ASPECT;
}

/* Returns the zoom that shows the whole plan, but leaves room to draw in one that is begun. */
static double fitted_zoom(const Tab *tab) {
    double size = fmax(box_width(tab->shape), box_height(tab->shape));
    return tab->laboratory->editor && size < SMALLEST ? fmax(size / LEAST_SEEN, ZOOM_LEAST) : 1;
}

/* Fits the camera to the whole plan. */
static void fit(Tab *tab) {
    keep_shape(tab);
    tab->handled = false;
    tab->fits = true;
    tab->camera.zoom = fitted_zoom(tab) * (tab->part_scale > 0 ? tab->part_scale : 1);
}

bool tab_open(Tab *tab, const char *path, const LaboratoryOptions *options, PaintGlScreen *screen, Fault *fault) {
    void *session = tab->laboratory->open(path, options, fault);
    if (!session)
        return false;
    char *kept = path ? text_copy(path) : NULL; /* copied first: it may belong to what is closed */
    plot_panes_clear(&tab->panes, screen);
    close_session(tab);
    tab->session = session;
    tab->path = kept;
    int power = tab->player.power;
    tab->player = player_start();
    tab->moment.kept = false;
    tab->player.power = power;
    tab->camera = (Camera){.kind = tab->camera.kind, .azimuth = VIEW_AZIMUTH, .elevation = VIEW_ELEVATION, .zoom = 1};
    tab->follows = false;
    tab->plot_panes_stale = true;
    fit(tab);
    view_layers_invalidate(&tab->view_layers);
    tab->laboratory->set_layers(session, tab_layers(tab));
    tab_apply_camera(tab);
    return true;
}

double tab_time(const Tab *tab) {
    return tab->trial.session ? trial_time(tab->laboratory, tab->session, tab->player.time) : tab->player.time;
}

/* Finds the box of an item now, m; false: it is not in the view. */
static bool box_of(const Tab *tab, Item item, Box *box) {
    Vec2 points[LABORATORY_OUTLINE_MOST];
    if (!tab->session || !item.kind)
        return false;
    size_t count = tab->laboratory->outline(tab->session, item, tab->player.time, points);
    *box = box_empty();
    for (size_t i = 0; i < count; i++)
        *box = box_include(*box, points[i]);
    return count > 0;
}

/* Keeps the followed item in the middle of the view. */
static void follow(Tab *tab) {
    Box box;
    Item item = tab->laboratory->selected(tab->session);
    if (!tab->follows || !tab->view_layers.painted || !box_of(tab, item, &box))
        return;
    Vec2 at = view_layers_point(&tab->view_layers, vec2_scale(vec2_add(box.low, box.high), 0.5));
    Box plan = tab->view_layers.still.frame;
    Vec2 middle = vec2_scale(vec2_add(plan.low, plan.high), 0.5), away = vec2_sub(at, middle);
    if (fabs(away.x) < FOLLOW_FREE * box_width(plan) && fabs(away.y) < FOLLOW_FREE * box_height(plan))
        return;
    tab_pan(tab, vec2_sub(view_layers_floor(&tab->view_layers, at), view_layers_floor(&tab->view_layers, middle)));
}

/* Returns the ratio of the scales at which two boxes fit the view. */
static double fitting(const Tab *tab, Box box, Box other) {
    Box place = tab->view_layers.still.plan;
    double aspect = box_height(place) > 0 ? box_width(place) / box_height(place) : tab->aspect;
    return fmax(box_width(other) / aspect, box_height(other)) / fmax(box_width(box) / aspect, box_height(box));
}

static Vec2 middle_of(Box box) {
    return vec2_scale(vec2_add(box.low, box.high), 0.5);
}

bool tab_awaits_answer(const Tab *tab) {
    return tab->session && tab->laboratory->answer(tab->session).due;
}

Editor *tab_editor(const Tab *tab) {
    return tab->session && tab->laboratory->editor ? tab->laboratory->editor(tab->session) : NULL;
}

/* Keeps the view still while an edit changes the size of the plan. */
static void keep_eye(Tab *tab) {
    Box box = tab->laboratory->still(tab->session)->box, shape = tab->shape;
    Editor *editor = tab_editor(tab);
    tab->handled |= editor && (editor_edit_count(editor) > 0 || editor_gesture(editor)->active);
    if (!tab->handled) {
        if (tab->fits)
            fit(tab);
        else
            keep_shape(tab);
        tab_apply_camera(tab);
        return;
    }
    bool same = box.low.x == shape.low.x && box.low.y == shape.low.y && box.high.x == shape.high.x &&
                box.high.y == shape.high.y;
    if (same || box_width(box) <= 0)
        return;
    tab->camera.pan = vec2_add(tab->camera.pan, vec2_sub(middle_of(shape), middle_of(box)));
    tab->camera.zoom /= fitting(tab, box, shape);
    tab->shape = box;
    tab_apply_camera(tab);
}

/* The fix beside the plan --------------------------------------------------------------------------------------- */

/* Looks at the place from near, which both pictures show; `tab->trial_from` is the camera to return to. */
static void look_near(Tab *tab) {
    Box box;
    const PanelRow *row = tab_first_place(tab);
    if (tab->trial_near || !row || !box_of(tab, row->place, &box))
        return;
    const Scene *still = tab->laboratory->still(tab->session);
    double least = fmin(box_width(still->box), box_height(still->box));
    tab->camera.zoom = fmin(fmax(least / TRIAL_SEEN, tab->camera.zoom), ZOOM_MOST);
    tab->camera.pan = vec2_sub(middle_of(box), middle_of(still->box));
    tab->trial_near = true;
    tab->fits = false;
    tab_apply_camera(tab);
}

/* Opens the fix that is chosen beside the plan, or closes it when it was used or dropped. */
static void follow_trial(Tab *tab) {
    Fault fault = {0};
    bool shown = tab->trial.session;
    if (!trial_follow(&tab->trial, tab->laboratory, tab->session, &fault))
        return;
    fault_clear(&fault); /* a proposal that cannot be opened is still listed */
    view_layers_invalidate(&tab->trial_layers);
    if (!shown && tab->trial.session) {
        tab->trial_from = tab->camera;
        tab->trial_fitted = tab->fits;
        tab->trial_near = false;
        look_near(tab);
    } else if (shown && !tab->trial.session) {
        tab->camera = tab->trial_from;
        tab->fits = tab->trial_fitted;
    }
    RecordSpan span = tab_span(tab);
    tab->player.playing = tab->trial.session;
    player_seek(&tab->player, span.begin, &span);
    tab_apply_camera(tab);
    view_layers_invalidate(&tab->view_layers);
}

/* Takes over new results of the fix; both have one camera. */
static void update_trial(Tab *tab) {
    if (!tab->trial.session)
        return;
    unsigned changes = trial_update(&tab->trial, tab->player.time);
    if (!(changes & LABORATORY_VIEW))
        return;
    tab->laboratory->set_layers(tab->trial.session, tab_layers(tab));
    tab->laboratory->set_camera(tab->trial.session, tab->camera);
    trial_update(&tab->trial, tab->player.time);
    view_layers_invalidate(&tab->trial_layers);
}

/* Keeps the moment shown while a gesture changes the plan, since its run is shown again once the gesture is cancelled.
 */
static void keep_moment(Tab *tab) {
    Editor *editor = tab_editor(tab);
    if (!tab->moment.kept && editor && editor_gesture(editor)->active)
        tab->moment = (TabMoment){true, tab->player.time, editor_edit_count(editor)};
}

/* Goes back to the moment before a gesture that was cancelled, as soon as its run is shown up to there. */
static void return_to_moment(Tab *tab, const RecordSpan *span) {
    Editor *editor = tab_editor(tab);
    if (!tab->moment.kept || !editor || editor_gesture(editor)->active)
        return;
    bool cancelled = editor_edit_count(editor) == tab->moment.edits;
    bool works = tab->laboratory->runs && tab->laboratory->runs(tab->session).working;
    bool grows = !span->complete && span->end < tab->moment.time;
    if (cancelled && (works || grows))
        return;
    if (cancelled)
        player_seek(&tab->player, tab->moment.time, span);
    tab->moment.kept = false;
}

/* Updates the session; where another run takes the place of the shown one, the clock goes back to the beginning. */
static unsigned update_session(Tab *tab) {
    unsigned changes = tab->laboratory->update(tab->session, tab_time(tab));
    if (changes & LABORATORY_RESTART) {
        RecordSpan span = tab_span(tab);
        keep_moment(tab);
        player_seek(&tab->player, span.begin, &span);
    }
    return changes;
}

unsigned tab_update(Tab *tab, double seconds) {
    if (!tab->session)
        return 0;
    const Laboratory *kind = tab->laboratory;
    double begun = stopwatch_now();
    follow_trial(tab);
    RecordSpan span = tab_span(tab);
    double wish = player_wish(&tab->player, seconds, &span);
    kind->reach(tab->session, wish);
    unsigned changes = update_session(tab);
    update_trial(tab);
    span = tab_span(tab);
    if (changes & LABORATORY_RESTART)
        wish = tab->player.time;
    if (tab->moment.kept) {
        return_to_moment(tab, &span);
        wish = tab->player.time;
    }
    player_advance(&tab->player, seconds, wish, &span);
    tab->worked += stopwatch_now() - begun;
    follow(tab);
    if (changes & LABORATORY_VIEW) {
        keep_eye(tab);
        changes |= update_session(tab); /* the new camera applies from now on */
        view_layers_invalidate(&tab->view_layers);
    }
    if (kind->tell)
        kind->tell(tab->session, tab_time(tab));
    if (changes & LABORATORY_PLOTS)
        tab->plot_panes_stale = true;
    return changes;
}

/* Plots and speed -------------------------------------------------------------------------------------------------- */

static const char *plots_for(const Tab *tab) {
    return tab->session && tab->laboratory->plots_for ? tab->laboratory->plots_for(tab->session) : NULL;
}

bool tab_opens_plots(const Tab *tab, bool wide) {
    const char *own = plots_for(tab);
    return tab->laboratory->numbers_first || (own ? *own : wide);
}

/* Keeps the first names of a list. */
static void keep_names(char *list, size_t count) {
    for (char *at = list; *at; at++)
        if (*at == ',' && --count == 0)
            *at = 0;
}

void tab_fit_plots(Tab *tab, size_t count) {
    const char *all =
        tab->laboratory->plots_in_order ? tab->laboratory->plots_in_order : tab->laboratory->plots_at_first;
    if (count == tab->plots_fit)
        return;
    tab->plots_fit = count;
    snprintf(tab->plots_fitting, sizeof tab->plots_fitting, "%s", all);
    keep_names(tab->plots_fitting, count);
    tab->plot_panes_stale = true;
}

const char *tab_plots(const Tab *tab) {
    const char *own = plots_for(tab);
    if (tab->plots != tab->laboratory->plots_at_first) /* chosen by hand */
        return tab->plots;
    return own && *own ? own : *tab->plots_fitting ? tab->plots_fitting : tab->plots;
}

/* Layers ----------------------------------------------------------------------------------------------------------- */

static bool is_names(const Tab *tab, size_t layer) {
    return strcmp(tab->laboratory->layers[layer], "names") == 0;
}

/* True for layers that tell nothing of the result. */
static bool is_telling(const char *layer) {
    static const char *const silent[] = {"names", "grid", "rings", "loupe", "sources"};
    for (size_t i = 0; i < sizeof silent / sizeof *silent; i++)
        if (strcmp(layer, silent[i]) == 0)
            return false;
    return true;
}

size_t tab_layer(const Tab *tab, const char *name) {
    size_t layer = 0;
    while (layer < tab->laboratory->layer_count && strcmp(tab->laboratory->layers[layer], name) != 0)
        layer++;
    return layer;
}

unsigned tab_layers(const Tab *tab) {
    unsigned layers = tab->layers;
    for (size_t i = 0; i < tab->laboratory->layer_count; i++)
        if ((tab->covered && is_telling(tab->laboratory->layers[i])) ||
            (tab->unsaid && strcmp(tab->laboratory->layers[i], "danger") == 0))
            layers &= ~(1u << i);
    for (size_t i = 0; i < tab->laboratory->layer_count && tab->cramped; i++)
        if (is_names(tab, i))
            layers = tab->named ? layers | 1u << i : layers & ~(1u << i);
    return tab->asked ? layers | LABORATORY_ALL_NAMES : layers;
}

void tab_toggle_layer(Tab *tab, size_t layer) {
    if (tab->cramped && is_names(tab, layer))
        tab->named = !tab->named;
    else
        tab->layers ^= 1u << layer;
    tab->laboratory->set_layers(tab->session, tab_layers(tab));
}

void tab_set_cramped(Tab *tab, bool cramped) {
    if (tab->cramped == cramped)
        return;
    tab->cramped = cramped;
    tab->named = false;
    if (tab->session)
        tab->laboratory->set_layers(tab->session, tab_layers(tab));
}

/* Looking ---------------------------------------------------------------------------------------------------------- */

void tab_apply_camera(Tab *tab) {
    if (tab->session)
        tab->laboratory->set_camera(tab->session, tab->camera);
    if (tab->trial.session)
        tab->laboratory->set_camera(tab->trial.session, tab->camera);
}

void tab_zoom(Tab *tab, double times, Vec2 about) {
    double zoom = fmin(fmax(tab->camera.zoom * times, ZOOM_LEAST), ZOOM_MOST);
    const Scene *still = tab->laboratory->still(tab->session);
    Vec2 middle = vec2_add(vec2_scale(vec2_add(still->box.low, still->box.high), 0.5), tab->camera.pan);
    Vec2 moved = vec2_scale(vec2_sub(about, middle), 1 - tab->camera.zoom / zoom);
    tab->fits = false;
    tab->camera.pan = vec2_add(tab->camera.pan, moved);
    tab->camera.zoom = zoom;
    tab_apply_camera(tab);
}

void tab_pan(Tab *tab, Vec2 metres) {
    tab->fits = false;
    tab->camera.pan = vec2_add(tab->camera.pan, metres);
    tab_apply_camera(tab);
}

void tab_look_at(Tab *tab, Vec2 at) {
    tab->fits = false;
    tab->camera.pan = vec2_sub(at, middle_of(tab->laboratory->still(tab->session)->box));
    tab_apply_camera(tab);
}

void tab_fit(Tab *tab) {
    tab->camera.pan = vec2(0, 0);
    tab->camera.azimuth = VIEW_AZIMUTH;
    tab->camera.elevation = VIEW_ELEVATION;
    tab->follows = false;
    fit(tab);
    tab_apply_camera(tab);
}

void tab_select(Tab *tab, Item item) {
    tab->laboratory->select(tab->session, item);
}

void tab_show_selected(Tab *tab) {
    tab_show_item(tab, tab->laboratory->selected(tab->session));
}

bool tab_show_item(Tab *tab, Item item) {
    Box box;
    if (!box_of(tab, item, &box))
        return false;
    tab->fits = false;
    const Scene *still = tab->laboratory->still(tab->session);
    Vec2 all = vec2_scale(vec2_add(still->box.low, still->box.high), 0.5);
    double size = fmax(ZOOM_NEAR * fmax(box_width(box), box_height(box)), NEAR_SEEN);
    tab->camera.pan = vec2_sub(vec2_scale(vec2_add(box.low, box.high), 0.5), all);
    tab->camera.zoom = fmin(fmax(fmin(box_width(still->box), box_height(still->box)) / size, 1), ZOOM_MOST);
    tab_apply_camera(tab);
    return true;
}

/* Returns the length of a metre, design points, in a view that the plan is fitted to. */
static double fitted_metre(Box box, Box view, double margin) {
    Box place = box_expand(view, -margin);
    return fmin(box_width(place) / box_width(box), box_height(place) / box_height(box));
}

void tab_keep_still(Tab *tab, Box from, Box to, bool closed) {
    Box box = tab->laboratory->still(tab->session)->box;
    if (!tab->view_layers.painted || tab->camera.kind != VIEW_PLAN || box_width(box) <= 0 || box_height(box) <= 0)
        return;
    double margin = tab->view_layers.still.plan.low.x, now = fitted_metre(box, from, margin) * tab->camera.zoom;
    Vec2 moved = vec2_scale(vec2_sub(middle_of(to), middle_of(from)), 1 / now);
    Vec2 pan = vec2_add(tab->camera.pan, vec2(moved.x, -moved.y));
    double room = box_width(to) / 2 - margin - now * (box_width(box) / 2 + fabs(pan.x));
    if (tab->fits && (closed || room < -SAME_PLACE))
        pan = vec2(0, 0);
    else
        tab->camera.zoom = now / fitted_metre(box, to, margin);
    tab->camera.pan = pan;
    tab_apply_camera(tab);
}

void tab_fit_part(Tab *tab, Box part, Box view) {
    Box box = tab->laboratory->still(tab->session)->box;
    if (!tab->fits || tab->handled || tab->trial.session || !tab->view_layers.painted || box_width(box) <= 0 ||
        box_height(box) <= 0 || box_width(part) <= 0 || box_height(part) <= 0)
        return;
    Camera camera = tab->camera;
    camera.pan = vec2(0, 0);
    camera.zoom = fitted_zoom(tab);
    tab->part_scale = 1;
    if (camera.kind == VIEW_PLAN) {
        double margin = tab->view_layers.still.plan.low.x, metre = fitted_metre(box, part, margin);
        Vec2 aside = vec2_scale(vec2_sub(middle_of(view), middle_of(part)), 1 / (metre * camera.zoom));
        camera.pan = vec2(aside.x, -aside.y);
        tab->part_scale = metre / fitted_metre(box, view, margin);
        camera.zoom *= tab->part_scale;
    }
    if (camera.zoom == tab->camera.zoom && camera.pan.x == tab->camera.pan.x && camera.pan.y == tab->camera.pan.y)
        return;
    tab->camera = camera;
    tab_apply_camera(tab);
}

RecordSpan tab_span(const Tab *tab) {
    return trial_span(&tab->trial, tab->laboratory->span(tab->session));
}

bool tab_can_play(const Tab *tab) {
    RecordSpan span = tab_span(tab);
    return !span.complete || span.end > span.begin;
}

void tab_seek(Tab *tab, double time) {
    RecordSpan span = tab_span(tab);
    player_seek(&tab->player, time, &span);
}

/* Files ------------------------------------------------------------------------------------------------------------ */

bool tab_unsaved(const Tab *tab) {
    Editor *editor = tab_editor(tab);
    if (!editor)
        return false;
    bool something = tab->path || editor_edit_count(editor) > 0;
    return tab->mark || (something && editor_is_changed(editor));
}

size_t tab_edit_count(const Tab *tab) {
    Editor *editor = tab_editor(tab);
    return editor ? tab->recovered + editor_edit_count(editor) : 0;
}

const char *tab_title(const Tab *tab, Arena *arena) {
    bool edited = tab->mark ? tab_editor(tab) && editor_is_changed(tab_editor(tab)) : tab_unsaved(tab);
    return text_in_arena(arena, "%s%s%s", tab->laboratory->title(tab->session), tab->mark ? tab->mark : "",
                         edited ? " (edited)" : "");
}

bool tab_set(Tab *tab, const char *name, double value, Fault *fault) {
    return tab->session && tab->laboratory->set(tab->session, name, value, fault);
}

/* Returns the number that a setting's words mean for a parameter. */
static double value_of(const PanelParameter *parameter, const char *words) {
    const Parameter *row = parameter->row;
    if (row->kind == PARAMETER_CHOICE)
        return choice_place(row->choices, words);
    if (row->kind == PARAMETER_FLAG)
        return strcmp(words, "true") == 0;
    return strtod(words, NULL);
}

bool tab_set_words(Tab *tab, const char *setting, Fault *fault) {
    size_t count, length = strcspn(setting, "=");
    const PanelParameter *parameters = tab->laboratory->parameters(tab->session, &count);
    for (size_t i = 0; i < count; i++)
        if (strncmp(parameters[i].name, setting, length) == 0 && !parameters[i].name[length])
            return tab_set(tab, parameters[i].name, value_of(&parameters[i], setting + length + 1), fault);
    fault_add(fault, "%.*s cannot be changed here", (int)length, setting);
    return false;
}

/* Keeping a state -------------------------------------------------------------------------------------------------- */

size_t tab_edits(const Tab *tab) {
    EditStep steps[EDITOR_STEPS_MOST];
    size_t count = editor_steps(tab_editor(tab), steps), now = count ? steps[0].number - 1 : 0;
    for (size_t i = 0; i < count; i++)
        now = steps[i].done ? steps[i].number : now;
    return now;
}

void tab_keep(const Tab *tab, TabState *state) {
    tab_state_clear(state);
    Editor *editor = tab_editor(tab);
    if (editor) {
        state->text = text_copy(editor_text(editor));
        state->edits = tab_edits(tab);
        return;
    }
    const PanelParameter *parameters = tab->laboratory->parameters(tab->session, &state->value_count);
    state->values = memory_zeroed(state->value_count + 1, sizeof *state->values);
    for (size_t i = 0; i < state->value_count; i++)
        state->values[i] = parameters[i].value;
}

bool tab_restore(Tab *tab, const TabState *state) {
    Editor *editor = tab_editor(tab);
    if (editor && state->text) {
        if (strcmp(editor_text(editor), state->text) != 0)
            editor_go_to_step(editor, state->edits);
        return strcmp(editor_text(editor), state->text) == 0;
    }
    Fault none = {0};
    size_t count;
    for (size_t i = 0; i < state->value_count; i++) {
        const PanelParameter *parameters = tab->laboratory->parameters(tab->session, &count);
        if (i < count && parameters[i].value != state->values[i])
            tab_set(tab, parameters[i].name, state->values[i], &none);
    }
    fault_clear(&none);
    return true;
}

void tab_state_clear(TabState *state) {
    memory_free(state->text);
    memory_free(state->values);
    *state = (TabState){0};
}

const PanelRow *tab_first_place(const Tab *tab) {
    size_t count;
    const PanelRow *rows = tab->laboratory->rows(tab->session, &count);
    for (size_t i = 0; i < count; i++)
        if (rows[i].place.kind)
            return &rows[i];
    return NULL;
}
