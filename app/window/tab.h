/* A laboratory in the window: the open file, the moment shown, and the camera. */
#pragma once

#include "laboratory/laboratory.h"
#include "window/plot_panes.h"
#include "laboratory/edit/trial.h"
#include "laboratory/player.h"
#include "window/view_layers.h"

/* The moment shown before a gesture began to change the plan. */
typedef struct TabMoment {
    bool kept;
    double time;  /* s */
    size_t edits; /* in the history; more: the gesture has become an edit */
} TabMoment;

typedef struct Tab {
    const Laboratory *laboratory;
    void *session;    /* NULL: nothing is open */
    char *path;       /* of the file; NULL: it has none */
    char *origin;     /* the file that recovered edits belong to, or NULL */
    const char *mark; /* " [Recovered]", " [Imported]": it has no file of its own; otherwise NULL */
    size_t recovered; /* number of edits that were recovered with it */
    Player player;
    TabMoment moment;
    Camera camera;
    unsigned layers;        /* bits of the layers shown where they fit */
    bool cramped;           /* the text is so large that names do not fit */
    bool named;             /* names are shown nevertheless */
    bool follows;           /* the selection stays in the middle of the view */
    double aspect;          /* width over height that the window is laid out for; it stays while the plan is edited */
    Box shape;              /* m, that the camera is fitted to */
    bool fits;              /* the camera shows everything: it has not been moved */
    double part_scale;      /* of a plan that fits a part of the view, relative to the whole view; 0: unknown */
    bool covered;           /* nothing of the result is shown: a class guesses first */
    bool unsaid;            /* tight places are not marked: a class says first what it has seen */
    bool asked;             /* each piece has its name, since a lesson asks about it */
    bool handled;           /* it has been edited, so the view stays still */
    const char *plots;      /* names of the plots shown, separated by commas; not owned */
    size_t plots_fit;       /* number of plots that open by themselves */
    char plots_fitting[64]; /* their names */
    ViewLayers view_layers;
    Trial trial;             /* the fix that is shown beside the plan */
    ViewLayers trial_layers; /* its picture */
    Camera trial_from;       /* the camera before it was shown, */
    bool trial_fitted;       /* which then showed everything, */
    bool trial_near;         /* and has been brought near */
    PlotPanes panes;
    bool plot_panes_stale; /* the panes must be chosen again */
    uint64_t shaken_in;    /* number of the last earthquake that was seen; 0: none */
    uint64_t fixed_in;     /* number of that after which a piece was fixed to the wall; 0: none is fixed */
    double worked;         /* s of wall time spent simulating */
} Tab;

/* How a house or machine was at a moment. */
typedef struct TabState {
    char *text;     /* of a house, as file text */
    size_t edits;   /* of a house, in its history */
    double *values; /* (value_count) of a machine's parameters */
    size_t value_count;
} TabState;

/* Makes an empty tab of a laboratory; tab_close releases what it holds. */
Tab tab_make(const Laboratory *kind);
void tab_close(Tab *tab, PaintGlScreen *screen);

/* Opens a file in place of the present one. False: faults say why not, and the present one stays open. */
bool tab_open(Tab *tab, const char *path, const LaboratoryOptions *options, PaintGlScreen *screen, Fault *fault);

/* Keeps the plan where it stands on the page while the view changes from one box to another, if it then still fits;
 * closed: the tools left of the view were put away, and a plan that was not moved stands in the middle again. */
void tab_keep_still(Tab *tab, Box from, Box to, bool closed);

/* Fits a plan that was not moved to a part of the view. */
void tab_fit_part(Tab *tab, Box part, Box view);

/* Advances by `seconds` of wall time and takes over new results; returns a sum of LABORATORY_VIEW and the like. */
unsigned tab_update(Tab *tab, double seconds);

/* Return the layers shown; show or hide one; set whether the text is so large that names are hidden at first. */
unsigned tab_layers(const Tab *tab);

/* Returns the index of a layer by its name; layer_count: this laboratory has none of that name. */
size_t tab_layer(const Tab *tab, const char *name);
void tab_toggle_layer(Tab *tab, size_t layer);
void tab_set_cramped(Tab *tab, bool cramped);

/* True if the session opens plots by itself, in a wide window or in any. */
bool tab_opens_plots(const Tab *tab, bool wide);

/* Sets how many plots open by themselves. */
void tab_fit_plots(Tab *tab, size_t count);

/* Returns the names of the plots that are shown: the chosen ones, or those that open by themselves. */
const char *tab_plots(const Tab *tab);

/* Applies the camera to the view. */
void tab_apply_camera(Tab *tab);

/* Zoom about a place, m, that stays fixed; pan; put a place in the middle; fit the whole plan. */
void tab_zoom(Tab *tab, double times, Vec2 about);
void tab_pan(Tab *tab, Vec2 metres);
void tab_look_at(Tab *tab, Vec2 at);
void tab_fit(Tab *tab);

/* Select an item; zoom to the selection. */
void tab_select(Tab *tab, Item item);
void tab_show_selected(Tab *tab);

/* Zooms to an item; false: it is not in the view. */
bool tab_show_item(Tab *tab, Item item);

/* Returns the time that the plan shows; beside a fix that takes longer it stands at its own end. */
double tab_time(const Tab *tab);

/* Returns the stretch of time that can be shown, of plan and fix. */
RecordSpan tab_span(const Tab *tab);

/* False if the record is complete and holds one moment only, as of a plan in which nobody can set off. */
bool tab_can_play(const Tab *tab);

/* Goes to a time. */
void tab_seek(Tab *tab, double time);

/* True if closing it would lose edits. */
bool tab_unsaved(const Tab *tab);

/* Returns the number of edits that closing it would lose, with the recovered ones. */
size_t tab_edit_count(const Tab *tab);

/* Returns the editor of what is open; NULL: nothing is open, or it cannot be edited. */
Editor *tab_editor(const Tab *tab);

/* True if an answer is expected, which is to be shown as soon as it is there, though nothing moves until then. */
bool tab_awaits_answer(const Tab *tab);

/* Returns its title with its mark in the arena: "L corridor (edited)", "L corridor [Recovered]". */
const char *tab_title(const Tab *tab, Arena *arena);

/* Changes a number. False: nothing is open, or a fault says why not. */
bool tab_set(Tab *tab, const char *name, double value, Fault *fault);

/* Changes a number as "NAME=VALUE" says. False as above. */
bool tab_set_words(Tab *tab, const char *setting, Fault *fault);

/* Keeps how what is open is now, in place of what `state` held; brings it back, false: the text of the house must be
 * opened again, since its history does not reach that far; releases it. */
void tab_keep(const Tab *tab, TabState *state);
bool tab_restore(Tab *tab, const TabState *state);
void tab_state_clear(TabState *state);

/* Returns the number of edits of a house that are in effect, as TabState counts them. */
size_t tab_edits(const Tab *tab);

/* Returns the first row that has a place, the most dangerous one; NULL: none has. */
const PanelRow *tab_first_place(const Tab *tab);
