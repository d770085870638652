#include "exchange/wall_strip.h"

#include <math.h>

static const double ALONG = 0.1; /* 1: sine of the largest angle between a strip and lines along it */

bool wall_strip_clip(Vec2 a, Vec2 b, Vec2 from, Vec2 axis, double low, double high, double half, double part[2]) {
    Vec2 p = vec2_unturn(vec2_sub(a, from), axis), q = vec2_unturn(vec2_sub(b, from), axis);
    double start[2] = {p.x, p.y}, way[2] = {q.x - p.x, q.y - p.y};
    double least[2] = {low, -half}, most[2] = {high, half};
    part[0] = 0;
    part[1] = 1;
    for (int i = 0; i < 2; i++) {
        if (fabs(way[i]) < 1e-12) {
            if (start[i] < least[i] || start[i] > most[i])
                return false;
            continue;
        }
        double one = (least[i] - start[i]) / way[i], two = (most[i] - start[i]) / way[i];
        part[0] = fmax(part[0], fmin(one, two));
        part[1] = fmin(part[1], fmax(one, two));
    }
    return part[1] > part[0];
}

WallStrip wall_strip_between(Vec2 a, Vec2 b, double half) {
    return (WallStrip){.from = a, .axis = vec2_unit(vec2_sub(b, a)), .width = vec2_distance(a, b), .half = half};
}

/* Adds a stretch; stretches that overlap become one. */
static void add_stretch(WallStrip *strip, double low, double high) {
    for (size_t i = 0; i < strip->count;) {
        const double *part = strip->parts[i];
        if (part[1] < low || part[0] > high) {
            i++;
            continue;
        }
        low = fmin(low, part[0]);
        high = fmax(high, part[1]);
        strip->count--;
        strip->parts[i][0] = strip->parts[strip->count][0];
        strip->parts[i][1] = strip->parts[strip->count][1];
        i = 0;
    }
    if (strip->count == WALL_STRIP_PARTS)
        return;
    strip->parts[strip->count][0] = low;
    strip->parts[strip->count++][1] = high;
}

void wall_strip_cover(WallStrip *strip, Vec2 a, Vec2 b) {
    double part[2];
    Vec2 way = vec2_sub(b, a);
    if (fabs(vec2_cross(vec2_unit(way), strip->axis)) > ALONG ||
        !wall_strip_clip(a, b, strip->from, strip->axis, 0, strip->width, strip->half, part))
        return;
    double start = vec2_dot(vec2_sub(a, strip->from), strip->axis), length = vec2_dot(way, strip->axis);
    double one = start + part[0] * length, two = start + part[1] * length;
    add_stretch(strip, fmin(one, two), fmax(one, two));
}

double wall_strip_length(const WallStrip *strip) {
    double length = 0;
    for (size_t i = 0; i < strip->count; i++)
        length += strip->parts[i][1] - strip->parts[i][0];
    return length;
}

/* Lines -------------------------------------------------------------------------------------------------------- */

typedef struct Visit {
    WallStrip strip;
    const WallLines *lines;
    Vec2 origin;
} Visit;

static bool visit_line(void *context, int item) {
    Visit *visit = context;
    const WallLine *line = &visit->lines->list[item];
    wall_strip_cover(&visit->strip, vec2_sub(line->a, visit->origin), vec2_sub(line->b, visit->origin));
    return true;
}

double wall_strip_closed(const WallLines *lines, const Broadphase *tree, Vec2 origin, Vec2 a, Vec2 b, double half) {
    Visit visit = {wall_strip_between(a, b, half), lines, origin};
    Box box = box_include(box_include(box_empty(), a), b);
    broadphase_visit(tree, box_expand(box, half), visit_line, &visit);
    return wall_strip_length(&visit.strip);
}
