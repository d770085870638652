#include "visual/house/drivers_band.h"

#include <math.h>

#include "base/memory.h"
#include "study/montecarlo.h"

/* m: a driver who passes farther from the nominal way is on another one. */
static const double ASIDE = 0.6;
/* 1: names of rooms and pieces stand beside the band where there is room. */
static const double KEEP_BAND = 1;
/* Points of a driver's path that are searched ahead of the last crossing. */
enum { AHEAD = 30 };

static Vec2 point_of(const DriverPath *path, size_t p) {
    return vec2(path->at[p][0], path->at[p][1]);
}

/* Finds where a driver crosses the line across the nominal way at a station, from point *from of the driver's path on.
 * Returns false if that is nowhere near. */
static bool find_crossing(const DriverPath *path, size_t *from, const BandStation *station, double *aside,
                          double *speed) {
    Vec2 along = vec2(station->left.y, -station->left.x);
    for (size_t p = *from; p + 1 < path->count && p < *from + AHEAD; p++) {
        Vec2 here = vec2_sub(point_of(path, p), station->at), next = vec2_sub(point_of(path, p + 1), station->at);
        double before = vec2_dot(here, along), after = vec2_dot(next, along);
        if (before > 0 || after <= 0)
            continue;
        double part = before / (before - after);
        *aside = vec2_dot(vec2_along(here, part, vec2_sub(next, here)), station->left);
        *speed = path->at[p][2] + part * ((double)path->at[p + 1][2] - path->at[p][2]);
        if (fabs(*aside) > ASIDE)
            continue;
        *from = p;
        return true;
    }
    return false;
}

static void fill_station(BandStation *station, const Drivers *drivers, size_t person, size_t *from, double *numbers) {
    size_t count = drivers->count;
    for (size_t k = 0; k < count; k++) {
        double *aside = &numbers[k], *speed = &numbers[count + k];
        *aside = *speed = (double)NAN;
        station->drivers +=
            find_crossing(&drivers->paths[k * drivers->person_count + person], &from[k], station, aside, speed);
        if (isfinite(*aside))
            continue;
        *speed = (double)NAN;
    }
    Distribution places = montecarlo_distribution(numbers, count);
    Distribution speeds = montecarlo_distribution(numbers + count, count);
    station->low = places.low;
    station->high = places.high;
    station->slow = speeds.low;
    station->fast = speeds.high;
    for (int q = 0; q < 2; q++) {
        station->quarters[q] = places.quarters[q];
        station->speeds[q] = speeds.quarters[q];
    }
}

DriversBand drivers_band_make(const Drivers *drivers, const Trace *nominal, size_t person) {
    DriverPath way = drivers_path(nominal, person);
    DriversBand band = {.stations = memory_zeroed(way.count, sizeof *band.stations)};
    size_t *from = memory_zeroed(drivers->count, sizeof *from);
    double *numbers = memory_zeroed(2 * drivers->count, sizeof *numbers), gone = 0;
    for (size_t p = 1; p + 1 < way.count; p++) {
        Vec2 at = point_of(&way, p), along = vec2_sub(point_of(&way, p + 1), point_of(&way, p - 1));
        gone += vec2_distance(at, point_of(&way, p - 1));
        if (!(vec2_length(along) > DRIVERS_STEP)) /* a change of direction */
            continue;
        BandStation *station = &band.stations[band.count++];
        *station = (BandStation){.at = at, .left = vec2_left(vec2_unit(along)), .way = gone, .speed = way.at[p][2]};
        fill_station(station, drivers, person, from, numbers);
    }
    memory_free(numbers);
    memory_free(from);
    memory_free(way.at);
    return band;
}

void drivers_band_free(DriversBand *band) {
    memory_free(band->stations);
    *band = (DriversBand){0};
}

/* Draws the area between two quantiles, in one piece for each part of the way with enough drivers. */
static void add_area(Scene *scene, const DriversBand *band, bool inner, double opacity, LineStyle style) {
    Vec2 *outline = memory_zeroed(2 * band->count, sizeof *outline);
    for (size_t first = 0; first < band->count;) {
        size_t end = first;
        while (end < band->count && band->stations[end].drivers >= BAND_LEAST)
            end++;
        size_t length = end - first;
        for (size_t s = 0; s < length; s++) {
            const BandStation *station = &band->stations[first + s];
            outline[s] = vec2_along(station->at, inner ? station->quarters[0] : station->low, station->left);
            outline[2 * length - 1 - s] =
                vec2_along(station->at, inner ? station->quarters[1] : station->high, station->left);
        }
        if (length > 1) {
            Primitive *area = scene_add_polygon(scene, ROLE_LOCUS, outline, 2 * length);
            area->fill_opacity = opacity;
            area->edge = ROLE_LOCUS;
            area->edge_opacity = 0.9;
            area->width = 0.8;
            area->style = style;
            area->keep_clear = KEEP_BAND;
        }
        first = end + 1;
    }
    memory_free(outline);
}

void drivers_band_add(Scene *scene, const Drivers *drivers, const Trace *nominal) {
    bool any = false;
    for (size_t i = 0; i < drivers->person_count; i++) {
        DriversBand band = drivers_band_make(drivers, nominal, i);
        for (size_t s = 0; s < band.count; s++)
            any |= band.stations[s].drivers >= BAND_LEAST;
        add_area(scene, &band, false, 0.18, LINE_DASHED);
        add_area(scene, &band, true, 0.35, LINE_SOLID);
        drivers_band_free(&band);
    }
    if (any) {
        SceneRow *row = scene_add_row(scene, ROW_LINE, "drivers, 5 to 95 %");
        row->role = ROLE_LOCUS;
        row->style = LINE_DASHED;
        row->width = 1;
        row = scene_add_row(scene, ROW_LINE, "drivers, 25 to 75 %");
        row->role = ROLE_LOCUS;
        row->width = 1;
    }
}
