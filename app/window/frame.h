/* The layout of the window: design points, y down. Nothing overlaps, floats or moves by itself.
 *
 *     +-------------------------------------------------+
 *     | menu                         title   House Beam |
 *     | answer                                          |
 *     +---------------------------------+---------------+
 *     | tool | view             | plots | panel         |
 *     | bar  |                  |       |               |
 *     +---------------------------------+---------------+
 *     | timeline                                        |
 *     | strip                                           |
 *     +-------------------------------------------------+
 *
 * If the text is large or the window is small, labels are dropped first, those of the tools too, then the strip, then
 * the plots; the panel becomes a drawer over the view. A closed panel leaves a narrow handle. The card of a lesson
 * takes a column at the left, beside the view; in presentation mode the panel, while it is open, takes the place of the
 * card. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"

enum { FRAME_PANES_MOST = 8 };

#define FRAME_RIM 3.0 /* design points around a plot, for the frame of the focus */

typedef struct FrameWish {
    bool panel, plots, present;
    bool handle;      /* the panel can be opened and closed here */
    bool tall_answer; /* of a presentation: it has a line more */
    size_t plot_count;
    size_t tool_count;   /* in the toolbar; 0: there is none */
    size_t hidden_tools; /* the toolbar would have that many if it were shown */
    double card;         /* width of a lesson's card; 0: there is none */
    double card_line;    /* height of a folded card, a line above the timeline; 0: there is none */
    bool split;          /* the view shows two pictures side by side */
    double aspect;       /* width over height of the view's contents */
} FrameWish;

typedef struct Frame {
    Vec2 page;
    Box menu, answer, card, toolbar, view, panel, timeline, strip; /* a part that does not fit has no width */
    Box handle; /* a column at the right that opens a closed panel, and closes a drawer */
    Box panes[FRAME_PANES_MOST];
    double still_from;    /* from the left of the view to the part for a plan that stands still when the tools open */
    Box heads[2], beside; /* of a split view: a line above each picture, and the second picture */
    size_t pane_count;    /* the number of plots that fit */
    int tool_columns;     /* of the toolbar */
    bool tool_labels;     /* the tools show their names */
    bool compact;         /* the bars are shorter */
    bool drawer;          /* the panel lies over the view */
} Frame;

Frame frame_make(Vec2 page, const FrameWish *wish);

/* Returns the pixels per design point of a window of that size in pixels, for a size of the text (1: normal): larger
 * screens give half of their gain to letters and half to content. Only presentation mode grows in full, as long as its
 * page keeps room for a picture. */
double frame_unit(int width, int height, double density, double text, bool present);

/* True if the names in the view would hide what they name: on a compact page those of a plan, which has many, and in a
 * small view any. */
bool frame_hides_names(const Frame *frame, bool plan);

/* True if a page has room for plots next to the view without being asked. */
bool frame_is_wide(Vec2 page);

/* Returns how many plots a page of this size opens by itself. */
size_t frame_plots(Vec2 page);
