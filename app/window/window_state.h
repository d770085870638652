/* All that the window is made of; its parts, each in a file of its own, are functions of it. */
#pragma once

#include "window/export.h"
#include "window/frame.h"
#include "window/folder.h"
#include "window/gallery.h"
#include "window/glass.h"
#include "window/keys.h"
#include "window/messages.h"
#include "window/pace.h"
#include "window/room.h"
#include "window/settings.h"
#include "window/snapshot.h"
#include "window/sound.h"
#include "window/ui.h"
#include "window/window.h"

/* What lies over the window, one at a time. */
typedef enum Sheet {
    SHEET_NONE,
    SHEET_MENU,
    SHEET_KEYS,
    SHEET_GALLERY,
    SHEET_OPEN,
    SHEET_SAVE,
    SHEET_EXPORT,
    SHEET_MESSAGES,
    SHEET_EXPLAIN,
    SHEET_ABOUT,
    SHEETS,
} Sheet;

enum { ROOM_HOUSE, ROOM_BEAM, ROOMS, WINDOW_PATH = 4096, GALLERY_MOST = 64 };

typedef struct Window {
    const WindowOptions *options;
    Glass *glass;
    PaintGlScreen *screen;
    Ui *ui;
    Settings settings;
    Messages messages;
    size_t dismissed;                     /* number of the last message that was put away */
    size_t noted;                         /* number of the last message that was seen, */
    double noted_at;                      /* s on the wall, and since when */
    Gallery *gallery;                     /* NULL: not looked at yet */
    ScreenTexture pictures[GALLERY_MOST]; /* of its items */
    Sound *sound;                         /* NULL: off */
    Export *export;                       /* NULL: nothing is being written */
    Room rooms[ROOMS];
    size_t current;

    Theme theme;
    double text; /* size of letters, 1 to 3 */
    bool present, panel, plots, fullscreen, more;
    bool drawer; /* the panel is open where it lies over the view */

    int width, height; /* pixels */
    double unit;       /* pixels a design point */
    Frame frame;
    UiInput input;
    Vec2 mouse; /* pixels */

    Sheet sheet;
    KeyMenu menu; /* which one is open */
    Folder folder;
    char field[WINDOW_PATH]; /* typed into a sheet */
    char hold[WINDOW_PATH];  /* explained by a sheet */

    Pace pace;
    bool dirty; /* something has changed that is to be seen */
    bool quit;
    int code;    /* exit code */
    Arena words; /* of this frame */
} Window;

static inline Room *window_room(Window *window) {
    return &window->rooms[window->current];
}
