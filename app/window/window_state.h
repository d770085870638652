/* All that the window is made of; its parts, each in a file of its own, are functions of it. */
#pragma once

#include "laboratory/edit/editor.h"
#include "laboratory/laboratories.h"
#include "platform/export.h"
#include "window/frame.h"
#include "platform/folder.h"
#include "window/gallery.h"
#include "platform/sdl_window.h"
#include "window/keys.h"
#include "window/messages.h"
#include "platform/frame_timer.h"
#include "platform/recovery.h"
#include "window/tab.h"
#include "platform/settings.h"
#include "platform/snapshot.h"
#include "platform/sound.h"
#include "widgets/ui.h"
#include "window/window.h"

/* What lies over the window, one at a time. */
typedef enum Dialog {
    DIALOG_NONE,
    DIALOG_MENU,
    DIALOG_KEYS,
    DIALOG_GALLERY,
    DIALOG_OPEN,
    DIALOG_SAVE,
    DIALOG_EXPORT,
    DIALOG_MESSAGES,
    DIALOG_EXPLAIN,
    DIALOG_ABOUT,
    DIALOG_LEAVE,     /* something is not saved */
    DIALOG_RECOVERED, /* something was left behind by a program that ended otherwise than it should */
    DIALOGS,
} Dialog;

/* What the hand does to what is edited. */
typedef struct PlanInput {
    Pointer pointer;    /* as last told, */
    bool pointer_known; /* if ever */
    bool free;          /* there is no snapping until it is wished for again */
    bool number;        /* one is being changed by its slider */
    bool holds;         /* the clock, */
    bool plays_on;      /* and it goes on afterwards */
    bool waits;         /* the key, for the letters that it types */
    bool done;          /* a key was, of itself: the letters that it types are nobody's */
    SdlWindowEvent key;
} PlanInput;

/* When what is edited is to be written for the case of a crash. */
typedef struct Watch {
    uint64_t state; /* of the steps, as last seen, */
    double since;   /* s on the wall, and since when */
    bool waits;     /* it is not written yet */
    bool written;   /* something is */
    bool failed;
} Watch;

/* What is to be done once what is open has been saved, or need not be. */
typedef enum Leave { LEAVE_NOTHING, LEAVE_QUIT, LEAVE_OPEN, LEAVE_NEW } Leave;

/* What --benchmark-edit measures. */
typedef struct EditBenchmark {
    double begun; /* s on the wall, when the piece was taken up; 0: not yet */
    Vec2 middle;  /* m, of the piece then */
    size_t steps;
    bool waits;      /* for an answer, */
    int frames;      /* since so many, */
    double edited;   /* since that moment */
    double *answers; /* (count) s */
    size_t count, capacity, missed;
} EditBenchmark;

enum { WINDOW_PATH = 4096, WINDOW_TITLE = 256, GALLERY_MOST = 64 };

typedef struct Window {
    const WindowOptions *options;
    SdlWindow *sdl_window;
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
    Tab *tabs;                            /* (laboratories_count) */
    size_t current;

    Theme theme;
    double text; /* size of letters, 1 to 3 */
    bool present, panel, plots, fullscreen, more;
    bool drawer;  /* the panel is open where it lies over the view */
    bool reduced; /* nothing moves but what is simulated */

    int width, height; /* pixels */
    double unit;       /* pixels a design point */
    Frame frame;
    UiInput input;
    Vec2 mouse; /* pixels */

    Dialog dialog;
    KeyMenu menu; /* which one is open */
    Folder folder;
    char field[WINDOW_PATH]; /* typed into a sheet */
    char hold[WINDOW_PATH];  /* explained by a sheet */

    PlanInput plan_input;
    ScreenTexture trace_image; /* of the picture to trace over, */
    char *trace_image_path;    /* from this file; NULL: none */
    Leave leave;
    char leave_path[WINDOW_PATH]; /* of LEAVE_OPEN */
    Recovery *recovery;           /* what there is for the next time; NULL: there is no place for it */
    Watch watch;
    char title[WINDOW_TITLE]; /* that the system shows */
    RecoveryFound *found;     /* (found_count) of times before */
    size_t found_count;

    FrameTimer frame_timer;
    EditBenchmark edit_benchmark;
    size_t inputs; /* presses and releases of keys and buttons that were handled, without repeated keys */
    bool dirty;    /* something has changed that is to be seen */
    bool quit;
    int code;    /* exit code */
    Arena arena; /* of this frame */
} Window;

static inline Tab *window_tab(Window *window) {
    return &window->tabs[window->current];
}
