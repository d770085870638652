/* A laboratory in the window: what is open in it, which moment is shown, and how it is looked at. */
#pragma once

#include "laboratory/laboratory.h"
#include "window/plot_panes.h"
#include "window/player.h"
#include "window/view_layers.h"

typedef struct Tab {
    const Laboratory *kind;
    void *live;       /* NULL: nothing is open */
    char *path;       /* of the file; NULL: it has none */
    char *origin;     /* of what was recovered: the file that it was of, or NULL */
    const char *mark; /* " [Recovered]", " [Imported]": no file of its own holds it; otherwise NULL */
    Player player;
    Camera camera;
    unsigned layers;   /* shown where there is room for them, bits */
    bool cramped;      /* letters are so large that names have no room */
    bool named;        /* they are shown all the same */
    bool follows;      /* what is selected stays in the middle */
    double aspect;     /* width over height that the view is laid out for: it stays while the plan changes */
    Box shape;         /* m, that the camera is fitted to */
    bool fits;         /* all of it is seen, as nobody has looked nearer */
    bool handled;      /* somebody has edited it: it does not move before the eye any more */
    const char *plots; /* names of those shown, separated by commas; not owned */
    ViewLayers view_layers;
    PlotPanes panes;
    bool plot_panes_stale; /* they are to be chosen anew */
    double worked;         /* s on the wall, that simulating has taken */
} Tab;

/* Of a laboratory, empty. tab_close releases what it holds. */
Tab tab_make(const Laboratory *kind);
void tab_close(Tab *tab, PaintGlScreen *screen);

/* Opens a file in place of what is open. False: faults say why, and what is open stays. */
bool tab_open(Tab *tab, const char *path, const LaboratoryOptions *options, PaintGlScreen *screen, Fault *fault);

/* Moves on by so many s on the wall, and takes over what has come since; returns LIVE_... */
unsigned tab_update(Tab *tab, double seconds);

/* The layers that are shown now; shows or hides one; where letters are large, names are hidden at first. */
unsigned tab_layers(const Tab *tab);
void tab_toggle_layer(Tab *tab, size_t layer);
void tab_set_cramped(Tab *tab, bool cramped);

/* Shows what is in the camera now. */
void tab_apply_camera(Tab *tab);

/* Enlarges about a place, m, that stays where it is; moves what is seen; shows all. */
void tab_zoom(Tab *tab, double times, Vec2 about);
void tab_pan(Tab *tab, Vec2 metres);
void tab_fit(Tab *tab);

/* Selects a thing; brings what is selected before the eye. */
void tab_select(Tab *tab, Item thing);
void tab_show_selected(Tab *tab);

/* Shows a moment. */
void tab_seek(Tab *tab, double time);

/* True if closing it would lose edits. */
bool tab_unsaved(const Tab *tab);

/* The editor of what is open; NULL: nothing is open, or it cannot be edited. */
Editor *tab_editor(const Tab *tab);

/* Returns its title with its mark in the arena: "L corridor (edited)", "L corridor [Recovered]". */
const char *tab_title(const Tab *tab, Arena *arena);

/* Changes a number. False: nothing is open, or a fault says why not. */
bool tab_set(Tab *tab, const char *name, double value, Fault *fault);

/* Returns the first row that has a place, the most dangerous one; NULL: none has. */
const PanelRow *tab_first_place(const Tab *tab);
