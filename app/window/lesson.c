#include "window/lesson.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <time.h>

#include "base/file_write.h"
#include "classroom/card.h"
#include "classroom/judge.h"
#include "classroom/progress.h"
#include "laboratory/shipped.h"
#include "window/autosave.h"
#include "window/dialog_pane.h"
#include "window/lesson_view.h"
#include "window/notice.h"
#include "window/opening.h"
#include "window/plan_input.h"

/* Design points. */
#define CARD_WIDTH 0.34 /* of the page */
#define CARD_LEAST 300.0
#define CARD_MOST 432.0
#define PRESENT_WIDTH 0.42
#define PRESENT_MACHINE 0.37 /* whose view is wide */
#define CARD_LINE 52.0       /* a folded card */

enum { LONGEST = 1 << 20 /* bytes of a lesson */ };

/* The laboratories of lessons. */
static const char *const words[] = {[LESSON_HOUSE] = "house", [LESSON_BEAM] = "beam", [LESSON_CRANK] = "crank"};

struct GivenLesson {
    Play play;
    Judge *judge;
    size_t tab;
    void *session;                     /* of the tab; another one means that something else was opened there */
    TabState left[LESSON_STEPS_MOST];  /* how the house or machine was when a step was left */
    TabState begun[LESSON_STEPS_MOST]; /* and when it began */
    LessonView view;
    bool waits;     /* a step has begun, and its run shall play once it is there */
    bool restarted; /* the machine was restarted for it */
    bool folded;    /* the card is one line */
    Progress *kept; /* of the last time, until the class continues or restarts it; NULL: none */
    bool offered;   /* the choice was shown */
    int unkept;     /* errno of the last writing; the guesses live only here */
    uint64_t asked; /* digest of the state and step that were asked about; 0: none */
    bool judged;    /* that goal is known */
};

static Tab *tab_of(Window *window) {
    return &window->tabs[window->lesson->tab];
}

static bool is_answered(Tab *tab) {
    if (!tab->session || tab->laboratory->answer(tab->session).stale)
        return false;
    RecordSpan span = tab->laboratory->span(tab->session);
    return span.complete || span.endless;
}

/* States ----------------------------------------------------------------------------------------------------------- */

/* Reopens a kept house, without the history of its edits. */
static void reopen(Window *window, const TabState *left) {
    Tab *tab = tab_of(window);
    RecoveryAbout about = {.origin = tab->path, .name = tab->laboratory->title(tab->session)};
    if (window->recovery && !recovery_write(window->recovery, left->text, &about))
        opening_copy(window, recovery_path(window->recovery), window->lesson->play.lesson.file, " [Lesson]");
    window->lesson->session = tab->session;
}

static void restore_state(Window *window, const TabState *left) {
    if (!tab_restore(tab_of(window), left))
        reopen(window, left);
}

/* Begins the step that the play has come to: its settings, and what it can be started again from. */
static void begin_step(Window *window) {
    GivenLesson *given = window->lesson;
    lesson_view_set(window, tab_of(window), play_step(&given->play)->set);
    tab_keep(tab_of(window), &given->begun[given->play.step]);
}

/* Progress --------------------------------------------------------------------------------------------------------- */

/* Writes the guesses and the place, or forgets those of a lesson that restarts; says once that this cannot be done.
 */
static void keep_progress(Window *window, bool forgets) {
    GivenLesson *given = window->lesson;
    char *folder = settings_state_folder();
    int error = !folder   ? EACCES
                : forgets ? progress_forget(&given->play.lesson, folder)
                          : progress_write(&given->play, folder, (int64_t)time(NULL));
    if (error && !given->unkept)
        notice_post(window, "The guesses cannot be kept%s%s: %s. They are lost when the lesson is closed.",
                    folder ? " in " : "", folder ? folder : "",
                    folder ? file_write_reason(error) : "no folder is writable");
    given->unkept = error;
    memory_free(folder);
}

static void read_progress(Window *window) {
    GivenLesson *given = window->lesson;
    char *folder = settings_state_folder();
    Progress *kept = memory_zeroed(1, sizeof *kept);
    Fault notes = {0};
    bool found = folder && progress_read(kept, &given->play.lesson, folder, &notes);
    notice_fault(window, &notes, NAN);
    memory_free(folder);
    if (found)
        given->kept = kept;
    else
        memory_free(kept);
}

/* Opening and closing ---------------------------------------------------------------------------------------------- */

static bool is_lesson_file(const char *path) {
    size_t size;
    char *text = text_read_refusal(path) ? NULL : text_read_file(path, LONGEST, &size);
    bool is = text && strstr(text, "\"clearance-lesson\"");
    memory_free(text);
    return is;
}

/* Hides of the result what must not be seen or said yet; without a lesson, nothing. */
static void cover(Tab *tab, const Play *play) {
    tab->covered = play && play_hides(play);
    tab->unsaid = play && play_asks(play);
    tab->asked = play && play->lesson.names;
    if (tab->session)
        tab->laboratory->set_layers(tab->session, tab_layers(tab));
}

void lesson_close(Window *window) {
    GivenLesson *given = window->lesson;
    if (!given)
        return;
    lesson_view_apply(window, tab_of(window), &given->view, (LessonLook){.plots = ""});
    cover(tab_of(window), NULL);
    window->lesson = NULL;
    judge_destroy(given->judge);
    memory_free(given->kept);
    for (size_t s = 0; s < LESSON_STEPS_MOST; s++) {
        tab_state_clear(&given->left[s]);
        tab_state_clear(&given->begun[s]);
    }
    lesson_free(&given->play.lesson);
    memory_free(given);
    window->dirty = true;
}

/* The shown state has no answer yet, and so no verdict. */
static void forget(GivenLesson *given) {
    given->asked = 0;
    given->judged = false;
}

/* Puts the clock to the beginning; a run that shall be watched then plays from there. */
static void begin_playing(Window *window) {
    GivenLesson *given = window->lesson;
    Tab *tab = tab_of(window);
    RecordSpan span = tab->laboratory->span(tab->session);
    const LessonStep *step = play_step(&given->play);
    if (step->kind != LESSON_OBSERVE && !play_hides(&given->play))
        return;
    player_pause(&tab->player, &span);
    player_seek(&tab->player, span.begin, &span);
    given->waits = step->kind == LESSON_OBSERVE;
    given->restarted = false;
}

static void show_step(Window *window) {
    GivenLesson *given = window->lesson;
    Tab *tab = tab_of(window);
    forget(given);
    if (play_hides(&given->play))
        tab_select(tab, (Item){0});
    lesson_view_apply(window, tab, &given->view, play_look(&given->play));
    cover(tab, &given->play);
    window->drawer = false;
    begin_playing(window);
    tab->plot_panes_stale = true;
    given->view.looks = true;
    window->dirty = true;
}

static bool open_lesson(Window *window, const char *path) {
    GivenLesson *given = memory_zeroed(1, sizeof *given);
    Fault fault = {0};
    const char *settings[LESSON_SETTINGS_MOST];
    Arena arena = {0};
    if (!lesson_read(&given->play.lesson, path, &fault)) {
        notice_fault(window, &fault, NAN);
        memory_free(given);
        return false;
    }
    lesson_close(window);
    const Lesson *lesson = &given->play.lesson;
    given->tab = laboratory_find(words[lesson->laboratory]);
    size_t count = lesson_add_settings(lesson->set, settings, 0, &arena);
    bool opened = opening_with(window, given->tab, lesson->file, settings, count);
    given->judge = opened ? judge_create(lesson->path, shipped_places()->profiles, window->options->jobs) : NULL;
    arena_clear(&arena);
    if (!given->judge) {
        if (opened)
            notice_post(window, "The lesson cannot be given: the system has no more threads; close other programs");
        lesson_free(&given->play.lesson);
        memory_free(given);
        return false;
    }
    window->lesson = given;
    given->session = tab_of(window)->session;
    lesson_view_keep(window, tab_of(window), &given->view);
    settings_add_recent(&window->settings, path);
    ui_focus(window->ui, "view");
    begin_step(window);
    show_step(window);
    read_progress(window);
    return true;
}

const Progress *lesson_kept(const Window *window) {
    return window->lesson ? window->lesson->kept : NULL;
}

void lesson_restart(Window *window) {
    GivenLesson *given = window->lesson;
    memory_free(given->kept);
    given->kept = NULL;
    keep_progress(window, true);
}

/* Goes to the step where the lesson was left; the house or machine is as each step begins it. */
static void go_on_with(Window *window) {
    GivenLesson *given = window->lesson;
    Play *play = &given->play;
    Progress *kept = given->kept;
    given->kept = NULL;
    memcpy(play->steps, kept->steps, sizeof play->steps);
    for (; play->step < kept->step; begin_step(window)) {
        tab_keep(tab_of(window), &given->left[play->step]);
        play->step++;
    }
    memory_free(kept);
    show_step(window);
}

/* Offers what was kept, once no other dialog is shown; a choice that was not made goes on with it. */
static void offer_kept(Window *window) {
    GivenLesson *given = window->lesson;
    if (!given->kept || window->dialog != DIALOG_NONE)
        return;
    if (given->offered)
        go_on_with(window);
    else
        dialog_pane_show(window, DIALOG_KEPT);
    given->offered = true;
}

bool lesson_open_any(Window *window, const char *path) {
    return path && is_lesson_file(path) ? open_lesson(window, path) : opening_file(window, path);
}

/* What is shown ---------------------------------------------------------------------------------------------------- */

bool lesson_is_shown(const Window *window) {
    return window->lesson && window->lesson->tab == window->current;
}

bool lesson_hides(const Window *window) {
    return lesson_is_shown(window) && play_hides(&window->lesson->play);
}

bool lesson_hides_words(const Window *window) {
    return lesson_is_shown(window) && (play_hides(&window->lesson->play) || play_asks(&window->lesson->play));
}

bool lesson_has_panel(const Window *window) {
    return !lesson_is_shown(window) || play_step(&window->lesson->play)->kind == LESSON_TASK;
}

const char *lesson_title(Window *window) {
    if (lesson_is_shown(window))
        return text_in_arena(&window->arena, "Lesson: %s", window->lesson->play.lesson.title);
    return tab_title(window_tab(window), &window->arena);
}

/* True if the question stands in the place of the answer, in the largest letters: in front of a class. */
static bool has_headline(const Window *window) {
    const Play *play = &window->lesson->play;
    bool asks = play_asks(play) || play_step(play)->kind == LESSON_PREDICT;
    return window->present && asks && *play_step(play)->ask && !strchr(play_step(play)->ask, '{');
}

const char *lesson_question(const Window *window) {
    const Play *play = &window->lesson->play;
    return has_headline(window) ? play_step(play)->ask : play_question(play);
}

/* Keys ------------------------------------------------------------------------------------------------------------- */

static const PlayKey keys_of[] = {PLAY_NEXT, PLAY_BACK, PLAY_HINT, PLAY_VOTE}; /* from ACTION_LESSON_NEXT on */

/* Carries out a key of the play. */
static void press_key(Window *window, PlayKey key, int digit) {
    GivenLesson *given = window->lesson;
    Play *play = &given->play;
    size_t step = play->step;
    plan_input_reset(window);
    window->echo[0] = 0;
    if (key == PLAY_NEXT || key == PLAY_BACK)
        tab_keep(tab_of(window), &given->left[step]);
    window->dirty = true;
    if (!play_key(play, key, digit) && key == PLAY_NEXT) {
        lesson_leave(window);
        return;
    }
    if (play->step > step)
        begin_step(window);
    else if (play->step < step)
        restore_state(window, &given->left[play->step]);
    if (play->step != step)
        show_step(window);
    else
        cover(tab_of(window), play);
    keep_progress(window, !play_is_begun(play));
}

/* Puts the house or machine back as the step began. */
static void restart_step(Window *window) {
    GivenLesson *given = window->lesson;
    plan_input_reset(window);
    restore_state(window, &given->begun[given->play.step]);
    show_step(window);
}

static void fold(Window *window) {
    window->lesson->folded = !window->lesson->folded;
    window->dirty = true;
}

/* True for "?" on the keyboards on which it is Shift with another key; elsewhere the button and the menu do it. */
static bool is_question_mark(const SdlWindowEvent *event) {
    bool shifted = event->key == sdl_window_key("/") || event->key == sdl_window_key("\u00df");
    return event->mods == SDL_WINDOW_EVENT_SHIFT && shifted;
}

bool lesson_key(Window *window, const SdlWindowEvent *event) {
    if (!lesson_is_shown(window) || window->dialog != DIALOG_NONE || ui_types(window->ui) ||
        (event->mods && !is_question_mark(event)))
        return false;
    if (is_question_mark(event)) {
        press_key(window, PLAY_HINT, 0);
        return true;
    }
    size_t count;
    const char *const *names = play_key_names(&count);
    for (size_t k = 0; k < count; k++) {
        PlayKey key;
        int digit;
        if (event->key != sdl_window_key(names[k]) || !play_read_key(names[k], &key, &digit) ||
            !play_takes(&window->lesson->play, key))
            continue;
        press_key(window, key, digit);
        return true;
    }
    return false;
}

bool lesson_do(Window *window, Action action) {
    if (action < ACTION_LESSON_NEXT || action > ACTION_LESSON_LEAVE)
        return false;
    if (!lesson_is_shown(window))
        return true;
    if (action == ACTION_LESSON_LEAVE)
        lesson_leave(window);
    else if (action == ACTION_LESSON_FOLD)
        fold(window);
    else if (action == ACTION_LESSON_FREE)
        lesson_view_free(window, &window->lesson->view);
    else if (action != ACTION_LESSON_RESTART)
        press_key(window, keys_of[action - ACTION_LESSON_NEXT], 0);
    else if (play_restarts(&window->lesson->play))
        restart_step(window);
    return true;
}

const char *lesson_reason(const Window *window, Action action) {
    if (!lesson_is_shown(window))
        return "No lesson is open: choose one with \"Lessons\"";
    const Play *play = &window->lesson->play;
    if (action == ACTION_LESSON_RESTART)
        return play_restarts(play) ? NULL : "Nothing plays or is changed in this step";
    if (action == ACTION_LESSON_FREE)
        return play->lesson.lock.count && !window->lesson->view.free ? NULL : "Nothing is locked in this lesson";
    return action < ACTION_LESSON_RESTART ? play_reason(play, keys_of[action - ACTION_LESSON_NEXT]) : NULL;
}

void lesson_close_panel(Window *window) {
    window->drawer = false;
    ui_focus(window->ui, "view");
    window->dirty = true;
}

/* Leaving ---------------------------------------------------------------------------------------------------------- */

void lesson_leave(Window *window) {
    if (play_is_begun(&window->lesson->play))
        dialog_pane_show(window, DIALOG_LESSON);
    else
        lesson_close(window);
}

size_t lesson_tab_of(const char *path) {
    Fault none = {0};
    Lesson lesson = {.path = NULL};
    size_t tab = laboratory_of(path);
    if (is_lesson_file(path) && lesson_read(&lesson, path, &none))
        tab = laboratory_find(words[lesson.laboratory]);
    lesson_free(&lesson);
    fault_clear(&none);
    return tab;
}

bool lesson_would_lose(const Window *window, Leave leave, const char *path) {
    const GivenLesson *given = window->lesson;
    if (!given || !given->unkept || !play_is_begun(&given->play))
        return false;
    if (leave == LEAVE_OPEN)
        return is_lesson_file(path) || laboratory_of(path) == given->tab;
    return leave == LEAVE_QUIT || (leave == LEAVE_NEW && tab_editor(&window->tabs[given->tab]));
}

bool lesson_is_kept(const Window *window) {
    return !window->lesson->unkept;
}

void lesson_end(Window *window) {
    if (lesson_is_last(window))
        keep_progress(window, true);
    lesson_close(window);
}

bool lesson_is_last(const Window *window) {
    const Play *play = &window->lesson->play;
    return play->step + 1 == play->lesson.step_count;
}

/* The goal --------------------------------------------------------------------------------------------------------- */

/* Asks for the goal in the state on the screen, once for each state. */
static void ask(Window *window, Tab *tab) {
    GivenLesson *given = window->lesson;
    JudgeQuestion question = lesson_view_question(tab, &given->play);
    if (question.state == given->asked)
        return;
    given->asked = question.state;
    given->judged = false;
    judge_ask(given->judge, &question);
    window->dirty = true;
}

static void take(Window *window) {
    GivenLesson *given = window->lesson;
    Play *play = &given->play;
    Fault fault = {0};
    JudgeNews news = judge_take(given->judge, &play->lesson, &fault);
    window->dirty |= news.counted;
    play->numbered = news.numbered;
    if (news.judged && news.state == given->asked && news.step == play->step) {
        play_judge(play);
        given->judged = true;
        window->dirty = true;
        if (window->present && window->drawer && !ui_types(window->ui))
            lesson_close_panel(window); /* the verdict is seen */
        notice_fault(window, &fault, NAN);
    }
    fault_clear(&fault);
}

/* Plays the run that shall be watched, as soon as it is there; a machine is computed further until its time comes. */
static void play_on(Window *window, Tab *tab) {
    GivenLesson *given = window->lesson;
    const LessonStep *step = play_step(&given->play);
    if (!given->waits || !is_answered(tab))
        return;
    if (!given->restarted && !tab_editor(tab) && *step->set)
        tab->laboratory->restart(tab->session); /* what it did with the numbers before is not to be watched */
    given->restarted = true;
    if (tab->laboratory->span(tab->session).endless && tab->laboratory->reach(tab->session, step->from) < step->from) {
        window->dirty = true;
        return;
    }
    given->waits = false;
    RecordSpan span = tab->laboratory->span(tab->session);
    player_normal_speed(&tab->player);
    player_change_speed(&tab->player, step->speed > 0 ? (int)lround(log2(step->speed)) : 0, &span);
    player_seek(&tab->player, fmax(step->from, span.begin), &span);
    tab->player.playing = true;
    window->dirty = true;
}

void lesson_update(Window *window) {
    GivenLesson *given = window->lesson;
    if (!given)
        return;
    Tab *tab = tab_of(window);
    if (tab->session != given->session) {
        lesson_close(window);
        return;
    }
    take(window);
    if (!tab->session || !lesson_is_shown(window))
        return;
    offer_kept(window);
    lesson_view_look(window, tab, &given->view, play_step(&given->play)->show);
    lesson_view_hold(window, tab, &given->view, &given->play.lesson.lock, &given->begun[given->play.step]);
    if (play_hides(&given->play) && tab->player.playing) {
        RecordSpan span = tab->laboratory->span(tab->session);
        player_pause(&tab->player, &span);
        player_seek(&tab->player, span.begin, &span);
    }
    play_on(window, tab);
    if (play_step(&given->play)->goal_count && is_answered(tab) && !plan_input_animation(tab))
        ask(window, tab);
    else
        forget(given);
}

bool lesson_works(const Window *window) {
    const GivenLesson *given = window->lesson;
    return given && play_step(&given->play)->goal_count && !given->judged;
}

/* The card --------------------------------------------------------------------------------------------------------- */

/* True if the card is a line. In presentation mode the panel takes the place of a whole card. */
static bool is_line(const Window *window) {
    return window->lesson->folded && !(window->present && window->drawer);
}

double lesson_line(const Window *window) {
    return lesson_is_shown(window) && is_line(window) ? CARD_LINE : 0;
}

double lesson_width(const Window *window, Vec2 page) {
    if (!lesson_is_shown(window) || is_line(window))
        return 0;
    if (window->present)
        return (window->tabs[window->current].laboratory->numbers_first ? PRESENT_MACHINE : PRESENT_WIDTH) * page.x;
    return fmin(fmax(CARD_WIDTH * page.x, CARD_LEAST), CARD_MOST);
}

void lesson_show(Window *window) {
    if (!lesson_is_shown(window) || box_width(window->frame.card) <= 0)
        return;
    CardLook look = {.working = lesson_works(window),
                     .folded = is_line(window),
                     .headline = has_headline(window),
                     .numbers = lesson_view_numbers(window, tab_of(window), play_step(&window->lesson->play))};
    CardPress press = card_show(window->ui, &window->lesson->play, window->frame.card, &look, &window->arena);
    if (press.folds)
        fold(window);
    else if (press.restarts)
        restart_step(window);
    else if (press.numbers)
        lesson_view_show_numbers(window);
    else if (press.leaves)
        lesson_leave(window);
    else if (press.pressed)
        press_key(window, press.key, press.digit);
}

void lesson_mark(Window *window) {
    GivenLesson *given = window->lesson;
    if (lesson_is_shown(window) && tab_of(window)->session)
        lesson_view_mark(window, tab_of(window), &given->view, &play_step(&given->play)->mark);
}

json_t *lesson_state(const Window *window) {
    if (!window->lesson)
        return json_null();
    json_t *state = play_state(&window->lesson->play);
    json_object_set_new(state, "working", json_boolean(lesson_works(window)));
    json_object_set_new(state, "hides_words", json_boolean(lesson_hides_words(window)));
    json_object_set_new(state, "framed", json_integer(window->lesson->view.framed));
    json_object_set_new(state, "folded", json_boolean(window->lesson->folded));
    return state;
}
