#include "window/lesson_view.h"

#include <jansson.h>
#include <math.h>
#include <string.h>

#include "base/digest.h"
#include "window/notice.h"

/* Design points. */
#define ASIDE 9.0 /* of a frame, from its thing */
#define FRAME 3.0
#define HALO 7.0 /* of the ground's colour behind the frame */

enum { THINGS_MOST = 4096 /* that are searched for a name */ };

void lesson_view_set(Window *window, Tab *tab, const char *set) {
    const char *settings[LESSON_SETTINGS_MOST];
    Arena arena = {0};
    size_t count = lesson_add_settings(set, settings, 0, &arena);
    for (size_t i = 0; i < count; i++) {
        Fault fault = {0};
        tab_set_words(tab, settings[i], &fault);
        notice_fault(window, &fault, NAN);
    }
    arena_clear(&arena);
}

const char *lesson_view_numbers(Window *window, const Tab *tab, const LessonStep *step) {
    Item item = tab->laboratory->selected(tab->session);
    if (step->kind != LESSON_TASK || box_width(window->frame.panel) > 0)
        return NULL;
    if (tab->laboratory->numbers_first)
        return "Numbers (Return)";
    return item.kind
               ? text_in_arena(&window->arena, "Numbers: %s (Return)", tab->laboratory->item_name(tab->session, item))
               : NULL;
}

void lesson_view_show_numbers(Window *window) {
    window->panel = window->drawer = true;
    ui_focus_number(window->ui, "panel");
    window->dirty = true;
}

static const char *key_of(const Tab *tab, Item item) {
    const Laboratory *laboratory = tab->laboratory;
    return (laboratory->item_key ? laboratory->item_key : laboratory->item_name)(tab->session, item);
}

Item lesson_view_find(const Tab *tab, const char *name) {
    const Laboratory *laboratory = tab->laboratory;
    Item first = laboratory->next(tab->session, (Item){0}, 1), item = first;
    for (int n = 0; item.kind && n < THINGS_MOST; n++) {
        if (strcmp(key_of(tab, item), name) == 0)
            return item;
        item = laboratory->next(tab->session, item, 1);
        if (item_same(item, first))
            break;
    }
    return (Item){0};
}

/* True if the goal has a condition on what a person has done. */
static bool asks_person(const LessonStep *step) {
    for (size_t g = 0; g < step->goal_count; g++)
        if (person_has(step->goals[g].condition.measure_name))
            return true;
    return false;
}

JudgeQuestion lesson_view_question(Tab *tab, const Play *play) {
    JudgeQuestion question = {.step = play->step, .person = {.answer = (double)NAN}};
    Editor *editor = tab_editor(tab);
    size_t count;
    question.text = editor ? editor_text(editor) : NULL;
    const char *const *words = tab->laboratory->command(tab->session, &count);
    question.state = digest_bytes(DIGEST_START, &question.step, sizeof question.step);
    question.state = digest_text(question.state, question.text ? question.text : "");
    for (size_t i = 0; !question.text && i + 1 < count && question.count < LESSON_SETTINGS_MOST; i++)
        if (strcmp(words[i], "--set") == 0) {
            question.settings[question.count++] = words[i + 1];
            question.state = digest_text(question.state, words[i + 1]);
        }
    if (asks_person(play_step(play))) {
        Item item = tab->laboratory->selected(tab->session);
        question.person = (PersonState){play_answer(play), item.kind ? key_of(tab, item) : NULL};
        question.state = digest_bytes(question.state, &question.person.answer, sizeof question.person.answer);
        question.state = digest_text(question.state, item.kind ? question.person.selected : "");
    }
    return question;
}

void lesson_view_keep(const Window *window, const Tab *tab, LessonView *view) {
    view->looked = (LessonLooks){.shown = {.plots = ""},
                                 .layers = tab->layers,
                                 .plots = tab->plots,
                                 .power = tab->player.power,
                                 .mode = (int)window->plots};
}

void lesson_view_apply(Window *window, Tab *tab, LessonView *view, LessonLook look) {
    LessonLooks *looked = &view->looked;
    const LessonLook *shown = &looked->shown;
    if (look.layered != shown->layered || look.layers != shown->layers)
        tab->layers = look.layered ? look.layers : looked->layers;
    if (strcmp(look.plots, shown->plots) != 0) {
        tab->plots = *look.plots ? look.plots : looked->plots;
        window->plots = *look.plots ? PLOTS_OPEN : looked->mode;
        tab->plot_panes_stale = true;
    }
    if (fabs(look.speed - shown->speed) > 0 && tab->session) {
        RecordSpan span = tab->laboratory->span(tab->session);
        player_normal_speed(&tab->player);
        player_change_speed(&tab->player, look.speed > 0 ? (int)lround(log2(look.speed)) : looked->power, &span);
    }
    looked->shown = look;
    if (tab->session)
        tab->laboratory->set_layers(tab->session, tab_layers(tab));
    window->dirty = true;
}

void lesson_view_look(Window *window, Tab *tab, LessonView *view, const char *name) {
    if (!view->looks || !tab->view_layers.painted)
        return;
    Item item = *name ? lesson_view_find(tab, name) : (Item){0};
    if (*name && (!item.kind || !tab_show_item(tab, item)))
        return;
    if (!*name && view->near)
        tab_fit(tab);
    view->near = *name;
    view->looks = false;
    window->dirty = true;
}

/* Marks ------------------------------------------------------------------------------------------------------------ */

/* Returns the box round a thing on the page; empty: it is not in the view. */
static Box box_of(const Window *window, Tab *tab, const char *name) {
    Vec2 points[LABORATORY_OUTLINE_MOST];
    Item item = lesson_view_find(tab, name);
    size_t count = item.kind ? tab->laboratory->outline(tab->session, item, tab_time(tab), points) : 0;
    Box box = box_empty();
    for (size_t i = 0; i < count && tab->view_layers.painted; i++)
        box = box_include(box, vec2_add(window->frame.view.low, view_layers_point(&tab->view_layers, points[i])));
    return box;
}

static Box intersect(Box a, Box b) {
    return (Box){vec2(fmax(a.low.x, b.low.x), fmax(a.low.y, b.low.y)),
                 vec2(fmin(a.high.x, b.high.x), fmin(a.high.y, b.high.y))};
}

static void frame(Window *window, Box box) {
    const Vec2 corners[] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    ui_draw_polyline(window->ui, corners, 4, true, ROLE_PAPER, HALO);
    ui_draw_polyline(window->ui, corners, 4, true, ROLE_CHAIR, FRAME);
}

/* Draws a frame within a part of the window; 0: the part is not shown. */
static int frame_part(Window *window, Box part) {
    if (box_width(part) <= 2 * HALO)
        return 0;
    frame(window, box_expand(part, -HALO / 2));
    return 1;
}

/* True if the panel lies over the view at this box. */
static bool is_covered(const Window *window, Box box) {
    Box under = intersect(box, window->frame.panel);
    return window->frame.drawer && under.low.x < under.high.x && under.low.y < under.high.y;
}

/* Draws a frame round a thing; 0: it is not in the view. */
static int frame_thing(Window *window, Tab *tab, const char *name) {
    Box box = intersect(box_expand(box_of(window, tab, name), ASIDE), box_expand(window->frame.view, -HALO));
    if (box.low.x >= box.high.x || box.low.y >= box.high.y || is_covered(window, box))
        return 0;
    frame(window, box);
    return 1;
}

void lesson_view_mark(Window *window, Tab *tab, LessonView *view, const LessonTexts *names) {
    int framed = 0;
    for (size_t n = 0; n < names->count; n++) {
        const char *name = names->at[n];
        if (strcmp(name, "plots") == 0)
            for (size_t p = 0; p < window->frame.pane_count; p++)
                framed += frame_part(window, window->frame.panes[p]);
        else
            framed += strcmp(name, "answer") == 0     ? frame_part(window, window->frame.answer)
                      : strcmp(name, "timeline") == 0 ? frame_part(window, window->frame.timeline)
                                                      : frame_thing(window, tab, name);
    }
    view->framed = framed;
}

/* Locks ------------------------------------------------------------------------------------------------------------ */

/* Returns the locked list in which two houses, as file texts, differ; NULL: none. */
static const char *changed_list(const LessonTexts *lock, const char *before, const char *now) {
    json_t *a = json_loads(before, 0, NULL), *b = json_loads(now, 0, NULL);
    const char *changed = NULL;
    for (size_t l = 0; l < lock->count && !changed; l++) {
        json_t *old = json_object_get(a, lock->at[l]), *new = json_object_get(b, lock->at[l]);
        if (json_array_size(old) + json_array_size(new) && !json_equal(old, new))
            changed = lock->at[l];
    }
    json_decref(a);
    json_decref(b);
    return changed;
}

/* Undoes the last edit of a locked list, or puts back an undone one with which the step began. */
static void hold_house(Window *window, Tab *tab, LessonView *view, const LessonTexts *lock, const TabState *begun) {
    Editor *editor = tab_editor(tab);
    if (editor_gesture(editor)->active || editor_drags_number(editor) || !begun->text)
        return;
    const char *text = editor_text(editor);
    uint64_t digest = digest_text(DIGEST_START, text);
    if (digest == view->held)
        return;
    view->held = digest;
    const char *changed = changed_list(lock, begun->text, text);
    if (!changed)
        return;
    if (tab_edits(tab) > begun->edits || !tab_restore(tab, begun))
        editor_undo(editor);
    notice_post(window, "Locked in this lesson: %s (Ctrl+U unlocks it). The change was undone.", changed);
    window->dirty = true;
}

static void hold_number(Window *window, Tab *tab, const char *name, const TabState *begun) {
    size_t count;
    const PanelParameter *parameters = tab->laboratory->parameters(tab->session, &count);
    for (size_t i = 0; i < count && i < begun->value_count; i++) {
        if (strcmp(parameters[i].name, name) != 0 || parameters[i].value == begun->values[i])
            continue;
        Fault none = {0};
        notice_post(window, "Locked in this lesson: %s (Ctrl+U unlocks it). The change was undone.",
                    parameters[i].label);
        tab_set(tab, name, begun->values[i], &none);
        fault_clear(&none);
        window->dirty = true;
        return;
    }
}

void lesson_view_free(Window *window, LessonView *view) {
    view->free = true;
    notice_post(window, "Unlocked: everything can be changed until the lesson ends.");
}

void lesson_view_hold(Window *window, Tab *tab, LessonView *view, const LessonTexts *lock, const TabState *begun) {
    if (!lock->count || view->free)
        return;
    if (tab_editor(tab))
        hold_house(window, tab, view, lock, begun);
    else
        for (size_t l = 0; l < lock->count; l++)
            hold_number(window, tab, lock->at[l], begun);
}
