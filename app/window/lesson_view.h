/* Applies a step of a lesson to the open house or machine: settings, layers, plots and speed, frames round the things
 * that the step names, a look at one of them from near, locks, and the question of the step's goal. */
#pragma once

#include "classroom/judge.h"
#include "classroom/play.h"
#include "window/window_state.h"

/* Changes the numbers "NAME=VALUE NAME=VALUE ..."; posts the fault of one that cannot be changed. */
void lesson_view_set(Window *window, Tab *tab, const char *set);

/* Finds a thing by its name, as Tab reads it; kind 0: there is none. */
Item lesson_view_find(const Tab *tab, const char *name);

/* Returns the question of whether the goal of the shown step is reached; its texts are those of what is open. */
JudgeQuestion lesson_view_question(Tab *tab, const Play *play);

/* Returns the label of a button for the numbers of what is selected, or of the machine, while the panel is not shown
 * and the step asks for a change; NULL: there is none. In the frame's arena. */
const char *lesson_view_numbers(Window *window, const Tab *tab, const LessonStep *step);

/* Opens the panel at the first of those numbers. */
void lesson_view_show_numbers(Window *window);

/* The layers, plots and speed that the lesson shows, and those of the user before. */
typedef struct LessonLooks {
    LessonLook shown;
    unsigned layers;
    const char *plots;
    int power; /* of the speed */
    int mode;  /* of window->plots */
} LessonLooks;

typedef struct LessonView {
    bool looks;    /* a step has begun: the view has to show its thing from near, or all again */
    bool near;     /* the view shows a thing from near */
    int framed;    /* things with a frame */
    bool free;     /* the teacher has freed what is locked */
    uint64_t held; /* digest of the house that was last looked at for what is locked */
    LessonLooks looked;
} LessonView;

/* Keep how the window shows the tab, before a lesson begins; show what a step wants, where it differs from the step
 * before, and otherwise what was kept. An empty look brings all of it back. */
void lesson_view_keep(const Window *window, const Tab *tab, LessonView *view);
void lesson_view_apply(Window *window, Tab *tab, LessonView *view, LessonLook look);

/* After the beginning of a step, shows the thing of that name from near once the view has it; "": all, after a step
 * that had one. */
void lesson_view_look(Window *window, Tab *tab, LessonView *view, const char *name);

/* Draws a frame round each thing of the view, and each part of the window, that has one of the names. */
void lesson_view_mark(Window *window, Tab *tab, LessonView *view, const LessonTexts *names);

/* Frees what is locked, and says so. */
void lesson_view_free(Window *window, LessonView *view);

/* Takes back a change, since the step began so, of what is locked, and says so. */
void lesson_view_hold(Window *window, Tab *tab, LessonView *view, const LessonTexts *lock, const TabState *begun);
