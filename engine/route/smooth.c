#include "route/smooth.h"

#include <string.h>

#include "base/memory.h"
#include "base/real.h"

/* An elastic band (Quinlan and Khatib 1993) with stiffness: each piece of the track without a change of direction or a
 * turn on the spot becomes points p_0 ... p_n, `step` apart, that move sideways so as to lower
 *
 *     E = sum of step (LENGTH |p'|^2 + BENDING |k|^2 + JERK |k'|^2 + CLEARANCE max(0, 1 - c / COMFORT)^2),
 *
 *     k_i = (p_(i+1) - 2 p_i + p_(i-1)) / step^2   curvature, 1/m
 *     c_i                                           clearance of the exact rectangle at p_i, m.
 *
 * The heading at p_i is that of p_(i+1) - p_(i-1), so that the axle never slips sideways; at the two ends it is given,
 * which puts the point beyond the end at p_(-1) = p_1 - 2 step t_0, except at the end of the whole track, where the
 * heading is free. Without the last term E is a parabola in any one displacement, so that three values give its lowest
 * place; with it, that place and two others are tried. Each displacement is a bump over 2 m - 1 points, m from large to
 * 1 (as in a multigrid method). A bump is accepted only when its least clearance does not fall, or stays above FLOOR.
 * Finally the motion between each two poses is swept; a piece that fails stays as searched. */

#define LENGTH 1.0    /* 1 */
#define BENDING 0.25  /* m2 */
#define JERK 0.06     /* m4 */
#define CLEARANCE 3.0 /* 1 */
#define COMFORT 0.12  /* m */
#define FLOOR 0.05    /* m */
#define NUDGE 0.02    /* m, displacement that is tried towards more clearance */
#define COARSE 0.10   /* m, first spacing of points */
#define SPACING 0.05  /* m, final spacing of poses */
#define SHORTEST 0.12 /* m, shorter pieces stay as they are */

enum { WIDEST_BUMP = 16, COARSE_SWEEPS = 12, FINE_SWEEPS = 5 };

typedef struct Band {
    const FreeSpace *space;
    const Rectangle *body;
    Vec2 *points;      /* (count + 1) m */
    Vec2 *normals;     /* unit, to the left */
    Vec2 *tried;       /* m, while a bump is tried: the points of it */
    double *clearance; /* m, up to COMFORT */
    double *tried_clearance;
    int count;        /* number of steps */
    double step;      /* m */
    Vec2 first, last; /* unit tangents at the ends */
    int direction;    /* +1, -1 */
    bool free_end;    /* True if the heading at the last end is free: the band ends straight */
} Band;

static Vec2 point_at(const Band *band, int i) {
    if (i < 0)
        return vec2_along(band->points[1], -2 * band->step, band->first);
    if (i > band->count && band->free_end)
        return vec2_along(band->points[band->count], 1,
                          vec2_sub(band->points[band->count], band->points[band->count - 1]));
    if (i > band->count)
        return vec2_along(band->points[band->count - 1], 2 * band->step, band->last);
    return band->points[i];
}

static Vec2 tangent_at(const Band *band, int i) {
    if (i == 0)
        return band->first;
    if (i == band->count && band->free_end)
        return vec2_unit(vec2_sub(band->points[i], band->points[i - 1]));
    if (i == band->count)
        return band->last;
    return vec2_unit(vec2_sub(band->points[i + 1], band->points[i - 1]));
}

static double clearance_at(const Band *band, int i, double reach) {
    Vec2 axis = vec2_scale(tangent_at(band, i), band->direction);
    return freespace_clearance(band->space, vec2_along(band->points[i], band->body->ahead, axis), axis,
                               band->body->half_length, band->body->half_width, reach, NULL);
}

/* Returns the smooth part of the energy in the terms that involve points low to high. */
static double stiffness(const Band *band, int low, int high) {
    int first = low - 1 < 0 ? 0 : low - 1, last = high + 1 > band->count ? band->count : high + 1;
    double step = band->step, inverse = 1 / (step * step), energy = 0;
    Vec2 before = point_at(band, first - 2), here = point_at(band, first - 1), next = point_at(band, first);
    Vec2 previous = vec2_scale(vec2_add(vec2_sub(next, here), vec2_sub(before, here)), inverse);
    for (int i = first; i <= last + 1; i++) {
        before = here;
        here = next;
        if (i > band->count)
            break;
        next = point_at(band, i + 1);
        Vec2 bend = vec2_scale(vec2_add(vec2_sub(next, here), vec2_sub(before, here)), inverse);
        Vec2 jerk = vec2_scale(vec2_sub(bend, previous), 1 / step),
             slope = vec2_scale(vec2_sub(here, before), 1 / step);
        energy += BENDING * vec2_dot(bend, bend);
        if (i > 0) /* beyond the first end the curvature is free */
            energy += JERK * vec2_dot(jerk, jerk) + LENGTH * vec2_dot(slope, slope);
        previous = bend;
    }
    return energy * step;
}

static double discomfort(double clearance) {
    double lack = fmax(1 - clearance / COMFORT, 0);
    return CLEARANCE * lack * lack;
}

/* A bump about point `centre`, which determines the points that move. */
typedef struct Bump {
    int centre, half; /* points nearer than `half` */
    int low, high;
} Bump;

static void displace(Band *band, const Bump *bump, double by) {
    for (int i = bump->low; i <= bump->high; i++) {
        double shape = 1 - fabs((double)(i - bump->centre)) / bump->half;
        shape = shape * shape * (3 - 2 * shape);
        band->points[i] = vec2_along(band->tried[i], by * shape, band->normals[i]);
    }
}

/* Displaces the points, and undoes that unless the energy falls and no clearance is lost. */
static bool try_displacement(Band *band, const Bump *bump, double by, double smooth_before) {
    displace(band, bump, by);
    int first = bump->low - 1 < 0 ? 0 : bump->low - 1,
        last = bump->high + 1 > band->count ? band->count : bump->high + 1;
    double gain = smooth_before - stiffness(band, bump->low, bump->high);
    double enough = FLOOR;
    for (int i = first; i <= last; i++)
        enough = fmin(enough, band->clearance[i]);
    bool good = true;
    for (int i = first; i <= last && good; i++) {
        double clearance = clearance_at(band, i, COMFORT);
        band->tried_clearance[i] = clearance;
        good = clearance >= enough;
        gain += band->step * (discomfort(band->clearance[i]) - discomfort(clearance));
    }
    if (!good || gain < 1e-7) {
        memcpy(band->points + bump->low, band->tried + bump->low,
               (size_t)(bump->high - bump->low + 1) * sizeof *band->points);
        return false;
    }
    memcpy(band->clearance + first, band->tried_clearance + first,
           (size_t)(last - first + 1) * sizeof *band->clearance);
    return true;
}

static void move_bump(Band *band, int centre, int half) {
    Bump bump = {centre, half, centre - half + 1, centre + half - 1};
    bump.low = bump.low < 1 ? 1 : bump.low;
    bump.high = bump.high > band->count - 1 ? band->count - 1 : bump.high;
    memcpy(band->tried + bump.low, band->points + bump.low, (size_t)(bump.high - bump.low + 1) * sizeof *band->tried);
    double here = stiffness(band, bump.low, bump.high), probe = 0.01;
    displace(band, &bump, probe);
    double more = stiffness(band, bump.low, bump.high);
    displace(band, &bump, -probe);
    double less = stiffness(band, bump.low, bump.high);
    displace(band, &bump, 0);
    double narrowest = COMFORT;
    for (int i = bump.low; i <= bump.high; i++)
        narrowest = fmin(narrowest, band->clearance[i]);
    double width = half * band->step, largest = 0.3 * width, bend = more + less - 2 * here;
    double best = bend > 0 ? probe * (less - more) / (2 * bend) : 0;
    best = fmax(-largest, fmin(largest, best));
    if (fabs(best) > 1e-5)
        for (int attempt = 0; attempt < 3; attempt++, best /= 3)
            if (try_displacement(band, &bump, best, here))
                return;
    for (double nudge = fmin(NUDGE, 0.2 * width); narrowest < COMFORT && nudge > NUDGE / 10; nudge /= 4)
        if (try_displacement(band, &bump, nudge, here) || try_displacement(band, &bump, -nudge, here))
            return;
}

static void relax_band(Band *band, int sweeps, int widest) {
    for (int i = 0; i <= band->count; i++)
        band->clearance[i] = clearance_at(band, i, COMFORT);
    for (int sweep = 0; sweep < sweeps; sweep++)
        for (int half = widest; half >= 1; half /= 2) {
            for (int i = 0; i <= band->count; i++)
                band->normals[i] = vec2_left(tangent_at(band, i));
            int stride = half > 1 ? half / 2 : 1;
            for (int centre = 1 + (half > 1 ? sweep % stride : 0); centre < band->count; centre += stride)
                move_bump(band, centre, half);
        }
}

static void band_reserve(Band *band, int count) {
    band->count = count;
    size_t points = (size_t)count + 1;
    band->points = memory_zeroed(points, sizeof *band->points);
    band->normals = memory_zeroed(points, sizeof *band->normals);
    band->tried = memory_zeroed(points, sizeof *band->tried);
    band->clearance = memory_zeroed(points, sizeof *band->clearance);
    band->tried_clearance = memory_zeroed(points, sizeof *band->tried_clearance);
}

static void band_release(Band *band) {
    memory_free(band->points);
    memory_free(band->normals);
    memory_free(band->tried);
    memory_free(band->clearance);
    memory_free(band->tried_clearance);
}

Vec2 smooth_between(const Pose *a, const Pose *b, int direction, double part) {
    double length = vec2_distance(a->at, b->at) * direction, s = part, r = 1 - part;
    Vec2 out = vec2_scale(vec2_heading(a->heading), length), in = vec2_scale(vec2_heading(b->heading), length);
    Vec2 at = vec2_add(vec2_scale(a->at, r * r * (1 + 2 * s)), vec2_scale(b->at, s * s * (1 + 2 * r)));
    return vec2_along(vec2_along(at, r * r * s, out), -s * s * r, in);
}

/* Makes a band of the poses low to high with about `spacing` between points. */
static Band band_make(const Pose *poses, size_t low, size_t high, double spacing) {
    double length = 0, passed = 0;
    for (size_t i = low; i < high; i++)
        length += vec2_distance(poses[i].at, poses[i + 1].at);
    Band band = {.direction = poses[high].direction};
    int count = (int)fmax(round(length / spacing), 2);
    band_reserve(&band, count);
    band.step = length / count;
    band.first = vec2_scale(vec2_heading(poses[low].heading), band.direction);
    band.last = vec2_scale(vec2_heading(poses[high].heading), band.direction);
    int point = 1;
    for (size_t i = low; i < high; i++) {
        double piece = vec2_distance(poses[i].at, poses[i + 1].at);
        for (; point < count && point * band.step <= passed + piece; point++)
            band.points[point] = smooth_between(&poses[i], &poses[i + 1], band.direction,
                                                piece > 0 ? (point * band.step - passed) / piece : 0);
        passed += piece;
    }
    for (; point < count; point++)
        band.points[point] = poses[high].at;
    band.points[0] = poses[low].at;
    band.points[count] = poses[high].at;
    return band;
}

static size_t band_write(const Band *band, const Pose *start, Pose *poses) {
    double heading = start->heading;
    for (int i = 0; i <= band->count; i++) {
        Vec2 axis = vec2_scale(tangent_at(band, i), band->direction);
        heading += vec2_wrap_angle(real_atan2(axis.y, axis.x) - heading);
        poses[i] = (Pose){band->points[i], heading, 0, band->direction};
    }
    return (size_t)band->count + 1;
}

/* True if the motion from one pose to the next is free. Their clearances are known. */
static bool swept(const Band *band, const Pose *a, const Pose *b) {
    double turn = fabs(b->heading - a->heading);
    double reach = 1.05 * vec2_distance(a->at, b->at) + turn * search_farthest(band->body);
    if (a->clearance + b->clearance >= reach)
        return true;
    if (a->clearance < SEARCH_CLEARANCE / 2 || b->clearance < SEARCH_CLEARANCE / 2)
        return false;
    Pose middle = {smooth_between(a, b, band->direction, 0.5), (a->heading + b->heading) / 2, 0, band->direction};
    middle.clearance =
        search_clearance(band->space, band->body, middle.at, middle.heading, ROUTE_CLEARANCE_REACH, NULL);
    return swept(band, a, &middle) && swept(band, &middle, b);
}

/* Fills in the clearances of `count` poses. Returns false if one of them or a motion between two is not free. */
static bool sweep_poses(const Band *band, Pose *poses, size_t count) {
    for (size_t i = 0; i < count; i++)
        poses[i].clearance =
            search_clearance(band->space, band->body, poses[i].at, poses[i].heading, ROUTE_CLEARANCE_REACH, NULL);
    for (size_t i = 0; i + 1 < count; i++)
        if (!swept(band, &poses[i], &poses[i + 1]))
            return false;
    return true;
}

/* Smooths `count` poses with points `spacing` apart. Returns the new poses (memory_free them), or NULL if they are not
 * free and `sweep` is true. */
static Pose *relaxed(const Pose *poses, size_t count, const FreeSpace *space, const Rectangle *body, double spacing,
                     int sweeps, bool sweep, bool free_end, size_t *result_count) {
    Band band = band_make(poses, 0, count - 1, spacing);
    band.space = space;
    band.body = body;
    band.free_end = free_end;
    relax_band(&band, sweeps, sweep ? WIDEST_BUMP / 2 : WIDEST_BUMP);
    Pose *result = memory_zeroed((size_t)band.count + 1, sizeof *result);
    *result_count = band_write(&band, &poses[0], result);
    if (sweep && !sweep_poses(&band, result, *result_count)) {
        memory_free(result);
        result = NULL;
    }
    band_release(&band);
    return result;
}

/* Smooths the poses low to high into `result`. Returns false if no result is free. */
static bool smooth_piece(const Pose *poses, size_t low, size_t high, const FreeSpace *space, const Rectangle *body,
                         bool free_end, SearchTrack *result) {
    size_t coarse_count, count;
    Pose *coarse =
        relaxed(poses + low, high - low + 1, space, body, COARSE, COARSE_SWEEPS, false, free_end, &coarse_count);
    Pose *smooth = relaxed(coarse, coarse_count, space, body, SPACING, FINE_SWEEPS, true, free_end, &count);
    /* Coarse points may cut an obstacle between them: then start from the searched poses, which are free. */
    if (!smooth)
        smooth = relaxed(poses + low, high - low + 1, space, body, SPACING, FINE_SWEEPS, true, free_end, &count);
    if (!smooth)
        smooth = relaxed(poses + low, high - low + 1, space, body, SPACING / 2, FINE_SWEEPS, true, free_end, &count);
    for (size_t i = 1; smooth && i < count; i++)
        search_track_add(result, smooth[i]);
    memory_free(coarse);
    memory_free(smooth);
    return smooth != NULL;
}

void smooth_track(SearchTrack *track, const FreeSpace *space, const Rectangle *body, const size_t *pins,
                  size_t pin_count) {
    const Pose *poses = track->poses;
    SearchTrack result = {.reversals = track->reversals, .direction = track->direction, .exit = track->exit};
    search_track_add(&result, poses[0]);
    size_t low = 0, pin = 0;
    while (low + 1 < track->count) {
        size_t high = low + 1;
        while (pin < pin_count && pins[pin] <= low)
            pin++;
        double length = vec2_distance(poses[low].at, poses[high].at);
        while (high + 1 < track->count && poses[high + 1].direction == poses[high].direction &&
               !(pin < pin_count && pins[pin] == high)) {
            length += vec2_distance(poses[high].at, poses[high + 1].at);
            high++;
        }
        if (poses[high].direction == 0 || length < SHORTEST ||
            !smooth_piece(poses, low, high, space, body, high + 1 == track->count, &result))
            for (size_t i = low + 1; i <= high; i++)
                search_track_add(&result, poses[i]);
        low = high;
    }
    for (size_t i = 0; i < result.count; i++)
        result.poses[i].clearance =
            search_clearance(space, body, result.poses[i].at, result.poses[i].heading, ROUTE_CLEARANCE_REACH, NULL);
    search_track_clear(track);
    *track = result;
}
