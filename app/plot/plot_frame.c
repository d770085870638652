#include "plot/plot_frame.h"

#define FAR 1e5 /* design points, beyond the page: cairo's coordinates end at about 8e6 pixels */

Vec2 plot_frame_point(const PlotLayout *layout, Vec2 value) {
    Box frame = layout->sheet.frame;
    double right = plot_ticks_part(&layout->x, value.x), up = plot_ticks_part(&layout->y, value.y);
    return vec2(real_clamp(frame.low.x + right * box_width(frame), -FAR, FAR),
                real_clamp(frame.high.y - up * box_height(frame), -FAR, FAR));
}

bool plot_frame_shows(const PlotLayout *layout, Vec2 value) {
    return isfinite(value.x) && isfinite(value.y) && (!layout->x.logarithmic || value.x > 0) &&
           (!layout->y.logarithmic || value.y > 0);
}

bool plot_frame_band(const PlotLayout *layout, const PlotGuide *guide, Box *band) {
    const PlotTicks *axis = guide->upright ? &layout->x : &layout->y;
    double from = fmax(fmin(guide->at, guide->to), axis->low), to = fmin(fmax(guide->at, guide->to), axis->high);
    Vec2 first = plot_frame_point(layout, vec2(from, from)), last = plot_frame_point(layout, vec2(to, to));
    *band = layout->sheet.frame;
    if (guide->upright)
        *band = (Box){{first.x, band->low.y}, {last.x, band->high.y}};
    else
        *band = (Box){{band->low.x, last.y}, {band->high.x, first.y}};
    return from < to;
}

bool plot_frame_guide(const PlotLayout *layout, const PlotGuide *guide, Vec2 ends[2]) {
    Box frame = layout->sheet.frame;
    const PlotTicks *axis = guide->upright ? &layout->x : &layout->y;
    Vec2 at = plot_frame_point(layout, vec2(guide->at, guide->at));
    ends[0] = guide->upright ? vec2(at.x, frame.high.y) : vec2(frame.low.x, at.y);
    ends[1] = guide->upright ? vec2(at.x, frame.low.y) : vec2(frame.high.x, at.y);
    return !guide->band && guide->at >= axis->low && guide->at <= axis->high;
}
