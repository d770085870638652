/* The frame that the axes of a plot enclose: the place of a value, and the part of guides and bands within the frame.
 */
#pragma once

#include "plot/plot_layout.h"

/* Returns the place of a value. Values far outside the axes are moved nearer, so that every painter's coordinates hold
 * them. */
Vec2 plot_frame_point(const PlotLayout *layout, Vec2 value);

/* True if both coordinates are finite, and positive where their axis is logarithmic. */
bool plot_frame_shows(const PlotLayout *layout, Vec2 value);

/* Stores the part of a band that lies within the axes; false if there is none. */
bool plot_frame_band(const PlotLayout *layout, const PlotGuide *guide, Box *band);

/* Stores the ends of a guide line; false if the line lies outside the axes. */
bool plot_frame_guide(const PlotLayout *layout, const PlotGuide *guide, Vec2 ends[2]);
