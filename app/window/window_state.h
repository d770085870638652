/* The state of the window. Its parts, each in a file of its own, are functions of it. */
#pragma once

#include "laboratory/edit/editor.h"
#include "laboratory/import_file.h"
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

/* The dialogs, one of which is shown at a time. */
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
    DIALOG_HISTORY,   /* of the edits */
    DIALOG_LEAVE,     /* edits are not saved */
    DIALOG_LESSON,    /* the lesson shall be left */
    DIALOG_KEPT,      /* a lesson was left before its end */
    DIALOG_RECOVERED, /* a program that crashed has left edits */
    DIALOG_UNIT,      /* the unit of an imported plan is in doubt */
    DIALOGS,
} Dialog;

enum {
    FOLDS_MOST = 64,
    WINDOW_PATH = 4096,
    WINDOW_TITLE = 256,
    GALLERY_MOST = 64,
    STRIP_KEYS_MOST = 4,
    HEADINGS_MOST = 8,
    HEADING = 64,
    FOLD_NAME = 96,
};

/* The state of mouse and keys over the plan. */
typedef struct PlanInput {
    Pointer pointer;    /* as last sent to the editor, */
    bool pointer_known; /* if it was ever sent */
    bool free;          /* snapping is off */
    bool number;        /* a slider is being dragged */
    bool refused;       /* a drag tries to move something that is fixed */
    bool pans;          /* the left button was pressed on the floor: dragging moves the view, */
    bool panned;        /* and has */
    bool twice;         /* it was a double click */
    Vec2 pressed_at;    /* where that was */
    bool holds;         /* playback is paused by a gesture, */
    bool plays_on;      /* and resumes afterwards */
    bool waits;         /* `key` waits for its text */
    bool done;          /* the key was handled, so its text is ignored */
    SdlWindowEvent key;
} PlanInput;

/* An imported plan whose unit is asked for. */
typedef struct ImportAsk {
    char path[WINDOW_PATH];
    ImportChoice choices[IMPORT_CHOICES]; /* (count) the likeliest first */
    size_t count;
    double width; /* of the plan, in the file's unit */
} ImportAsk;

/* When the recovery file must be written. */
typedef struct Watch {
    uint64_t state; /* number of the edits' state, see autosave.c, */
    double since;   /* s of wall time, since that state */
    bool waits;     /* the state is not written yet */
    bool written;   /* the recovery file exists */
    bool failed;
} Watch;

/* The action that follows the question whether to save. */
typedef enum Leave { LEAVE_NOTHING, LEAVE_QUIT, LEAVE_OPEN, LEAVE_NEW } Leave;

/* State of the door's width to which the second of the first things to try gives the focus.
 * Changed: it was typed or dragged. */
typedef enum Narrowing { NARROWING_NONE, NARROWING_OPEN, NARROWING_CHANGED } Narrowing;

/* The measurements of --benchmark-edit. */
typedef struct EditBenchmark {
    double begun;          /* s of wall time, when the piece was grabbed; 0: not yet */
    Vec2 middle;           /* m, of the piece at that time */
    size_t steps, unmoved; /* unmoved: those that left the plan as it was, since pieces snap */
    uint64_t revision;     /* of the plan before the step */
    bool waits;            /* for a result, */
    int frames;            /* frames since the step, */
    double edited;         /* s of wall time of the step */
    double *answers;       /* (count) s */
    size_t count, capacity, missed;
} EditBenchmark;

/* The name of what is selected, as it stands in the view. */
typedef struct SelectedName {
    char text[WINDOW_TITLE]; /* "": none */
    Box box;                 /* design points, */
    Vec2 pointed;            /* the middle of the thing */
} SelectedName;

/* A text that was typed in a field of the panel and could not be applied: it stays there to be corrected. */
typedef struct RefusedText {
    char name[WINDOW_TITLE]; /* of the field, as in EditText; "": none */
    const Tab *tab;          /* of that house, */
    size_t edits;            /* which had so many edits */
    char typed[EDITOR_TEXT_MOST];
} RefusedText;

/* A fold of the panel as it was left. */
typedef struct Fold {
    char name[FOLD_NAME]; /* task and title, "watch/People" */
    bool open;
} Fold;

/* The lesson that is being given: see lesson.h. */
typedef struct GivenLesson GivenLesson;

typedef struct Window {
    const WindowOptions *options;
    SdlWindow *sdl_window;
    PaintGlScreen *screen;
    Ui *ui;
    Settings settings;
    Messages messages;
    size_t dismissed;                     /* number of the last dismissed message, and */
    size_t fault_dismissed;               /* of the last dismissed fault */
    size_t undo_message;                  /* number of the message with a button that undoes; 0: none, */
    size_t message_before;                /* of the last message of the frame before */
    size_t noted;                         /* number of the last message noticed, */
    double noted_at;                      /* s of wall time, since that state */
    Gallery *gallery;                     /* NULL: not opened yet */
    ScreenTexture pictures[GALLERY_MOST]; /* of its items */
    Sound *sound;                         /* NULL: off */
    Export *export;                       /* NULL: no export runs */
    GivenLesson *lesson;                  /* NULL: none */
    Tab *tabs;                            /* (laboratories_count) */
    size_t current;
    size_t framed; /* the tab that `frame` was made for last */

    Theme theme;
    double text; /* text size, 1 to 3 */
    bool present, panel, fullscreen;
    enum { PLOTS_AUTO, PLOTS_OPEN, PLOTS_CLOSED } plots; /* as chosen; otherwise by the room there is */
    bool plots_shown;
    bool plots_asked;       /* since the last frame */
    bool editing;           /* the toolbar is shown */
    Fold folds[FOLDS_MOST]; /* (fold_count) folds of the panel that were touched */
    size_t fold_count;
    size_t folds_open;    /* untouched ones that are open, so far in this frame; */
    size_t folds_opening; /* touched ones, so far, */
    size_t folds_opened;  /* and in the frame before */
    bool noted_in_bar;    /* the note of the laboratory stands in the title bar or beside the answer */
    bool note_crowded;    /* it has no room in the view: the timeline shows it */
    Box note;             /* where it stands in the view; empty: elsewhere */
    bool drawer;          /* the panel is open as a drawer over the view, or in place of a lesson's card */
    bool lessons_only;    /* the gallery shows lessons alone */
    bool reduced;         /* nothing moves but what is simulated */

    bool answer_tall;                      /* the detail stands below the title */
    char headings[HEADINGS_MOST][HEADING]; /* (heading_count) of the selection, in the panel */
    size_t heading_count;
    size_t panel_subject;                    /* number of the thing that was selected last */
    const char *strip_keys[STRIP_KEYS_MOST]; /* (strip_count) keys that the strip names */
    size_t strip_count;
    int width, height; /* pixels */
    double unit;       /* pixels a design point */
    Frame frame;
    Box tries; /* the strip of first things to try; without a width: there is none */
    Narrowing narrowing;
    RefusedText refused_text;
    UiInput input;
    Vec2 mouse; /* pixels */

    Dialog dialog;
    KeyMenu menu;      /* the open menu */
    KeyMenu menu_seen; /* in the frame before */
    struct {
        bool down, opened; /* the left button was down in the last frame; that press opened the menu */
        Vec2 mouse;        /* pixels, in the last frame */
    } menu_press;
    Folder folder;
    char field[WINDOW_PATH];         /* text typed into a dialog */
    char refused[WINDOW_PATH];       /* the typed path that cannot be opened, */
    int refusal;                     /* and why, an errno; told until another text is typed */
    size_t open_fault;               /* number of the last message about a file that could not be opened */
    const char *shown[GALLERY_MOST]; /* (shown_count) names of the cards and, after "# ", groups on the start page */
    size_t shown_count;
    size_t corner;          /* the corner that has a card there */
    char hold[WINDOW_PATH]; /* text of DIALOG_EXPLAIN */

    ImportAsk import_ask;
    PlanInput plan_input;
    ScreenTexture trace_image; /* of the picture to trace, */
    char *trace_image_path;    /* from this file; NULL: none */
    Leave leave;
    char leave_path[WINDOW_PATH]; /* of LEAVE_OPEN */
    Recovery *recovery;           /* the recovery file; NULL: there is no folder for it */
    Watch watch;
    SelectedName selected_name;
    char hovered[WINDOW_TITLE]; /* the name shown at the pointer, "": none */
    char echo[WINDOW_TITLE];    /* the last key and its name, for presentation mode, */
    double echo_at;             /* s of wall time */
    char title[WINDOW_TITLE];   /* in the system's frame */
    RecoveryFound *found;       /* (found_count) recovery files of earlier runs */
    size_t found_count;

    FrameTimer frame_timer;
    EditBenchmark edit_benchmark;
    bool pans;       /* --benchmark-window moves the view, */
    double panned;   /* s, for which it has done so */
    size_t searched; /* how far the search for fixes had got in the last frame: twice the tries, and 1 while it goes */
    size_t inputs;   /* presses and releases of keys and buttons that were handled, without repeated keys */
    double work_begun; /* s of wall time, since when the answer has been grey; 0: it is not */
    bool dirty;        /* a new frame must be drawn */
    bool plays;        /* the player moved in the last turn: one that waits for its record needs no frames */
    bool quit;
    int code;    /* exit code */
    Arena arena; /* of this frame */
} Window;

static inline Tab *window_tab(Window *window) {
    return &window->tabs[window->current];
}
