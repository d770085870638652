/* Where everything in the window is: design points, y down. Nothing ever overlaps, floats or moves by itself.
 *
 *     +-------------------------------------------------+
 *     | menu                         title   House Beam |
 *     | answer                                          |
 *     +---------------------------------+---------------+
 *     | rail | view             | plots | panel         |
 *     |      |                  |       |               |
 *     +---------------------------------+---------------+
 *     | timeline                                        |
 *     | strip                                           |
 *     +-------------------------------------------------+
 *
 * Where letters are large or the window is small, words go first, those of the rail, too, then the strip, then the
 * plots; the panel becomes a drawer over the view. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"

enum { FRAME_PANES_MOST = 8 };

typedef struct FrameWish {
    bool panel, plots, present;
    size_t plot_count;
    size_t tool_count; /* on the rail; 0: there is none */
    double aspect;     /* width over height of what the view shows */
} FrameWish;

typedef struct Frame {
    Vec2 page;
    Box menu, answer, toolbar, view, panel, timeline, strip; /* those that there is no room for have no width */
    Box panes[FRAME_PANES_MOST];
    size_t pane_count; /* as many of the plots as there is room for */
    int tool_columns;  /* of the rail */
    bool tool_labels;  /* its tools have their names */
    bool compact;      /* bars in short */
    bool drawer;       /* the panel lies over the view */
} Frame;

Frame frame_make(Vec2 page, const FrameWish *wish);
