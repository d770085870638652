/* A laboratory in the window: what is open in it, which moment is shown, and how it is looked at. */
#pragma once

#include "live/live.h"
#include "window/charts.h"
#include "window/player.h"
#include "window/scenery.h"

typedef struct Room {
    const LiveKind *kind;
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
    Scenery scenery;
    Charts charts;
    bool charts_wait; /* they are to be chosen anew */
    double worked;    /* s on the wall, that simulating has taken */
} Room;

/* Of a laboratory, empty. room_close releases what it holds. */
Room room_make(const LiveKind *kind);
void room_close(Room *room, PaintGlScreen *screen);

/* Opens a file in place of what is open. False: faults say why, and what is open stays. */
bool room_open(Room *room, const char *path, const LiveOptions *options, PaintGlScreen *screen, Fault *fault);

/* Moves on by so many s on the wall, and takes over what has come since; returns LIVE_... */
unsigned room_update(Room *room, double seconds);

/* The layers that are shown now; shows or hides one; where letters are large, names are hidden at first. */
unsigned room_layers(const Room *room);
void room_toggle_layer(Room *room, size_t layer);
void room_cramp(Room *room, bool cramped);

/* Shows what is in the camera now. */
void room_look(Room *room);

/* Enlarges about a place, m, that stays where it is; moves what is seen; shows all. */
void room_zoom(Room *room, double times, Vec2 about);
void room_pan(Room *room, Vec2 metres);
void room_fit(Room *room);

/* Selects a thing; brings what is selected before the eye. */
void room_select(Room *room, LiveThing thing);
void room_show_selected(Room *room);

/* Shows a moment. */
void room_seek(Room *room, double time);
