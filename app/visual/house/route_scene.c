#include "visual/house/route_scene.h"

#include "base/stop.h"
#include "house/journey.h"
#include "space/passage.h"
#include "result/census.h"

/* Design points. */
#define WAY_WIDTH 2.5
#define WIDTH_WIDTH 2.0
#define TEXT_SIZE 16.0

#define TOGETHER 0.6 /* m: of corners nearer to each other, as around one jamb, the narrowest widths are shown */

static void add_way(Scene *scene, const Track *track) {
    Vec2 *points = memory_zeroed(track->count, sizeof *points);
    for (size_t i = 0; i < track->count; i++)
        points[i] = track->points[i].at;
    scene_add_line(scene, ROLE_TEXT, WAY_WIDTH, points, track->count)->style = LINE_DOTTED;
    memory_free(points);
}

/* Adds the width from the corner over the passage, as wide as the passage. */
static void add_width(Scene *scene, Vec2 corner, Vec2 towards, double width, const char *name) {
    Vec2 opposite = vec2_along(corner, width, vec2_unit(vec2_sub(towards, corner)));
    scene_add_dimension(scene, ROLE_TEXT, WIDTH_WIDTH, corner, opposite);
    Vec2 middle = vec2_scale(vec2_add(corner, opposite), 0.5);
    Primitive *tag =
        scene_add_label(scene, ROLE_TEXT, TEXT_SIZE, middle,
                        scene_text(scene, width < PASSAGE_WIDEST ? "%s %.2f m" : "%s over %.1f m", name, width));
    tag->shape = LABEL_TAG;
    tag->leader = true;
}

/* Returns the place at length `s` of the track. */
static Vec2 track_place(const Track *track, double s) {
    size_t i = 0;
    while (i + 1 < track->count && track->points[i].s < s)
        i++;
    return track->points[i].at;
}

/* Returns the width before a corner, or behind it. */
static double width_of(const TrackCorner *corner, bool behind) {
    return behind ? corner->after : corner->before;
}

/* True if another corner that lies together with this one has a smaller width, or an equal one and comes first. */
static bool is_wider(const Track *track, size_t corner, bool behind) {
    double width = width_of(&track->corners[corner], behind);
    for (size_t i = 0; i < track->corner_count; i++) {
        double other = width_of(&track->corners[i], behind);
        if (i != corner && vec2_distance(track->corners[i].centre, track->corners[corner].centre) < TOGETHER &&
            (other < width || (other == width && i < corner)))
            return true;
    }
    return false;
}

/* W1 and W2 are the paper's: computed on the route of its round body, for every driving model. */
static void add_widths(Scene *scene, const House *house, size_t person, const Route *route) {
    Track track = {0};
    track_build_miura(&track, house, &house->people[person], route);
    for (size_t c = 0; c < track.corner_count; c++) {
        const TrackCorner *corner = &track.corners[c];
        if (!is_wider(&track, c, false))
            add_width(scene, corner->centre, track_place(&track, corner->from), corner->before, "W1");
        if (!is_wider(&track, c, true))
            add_width(scene, corner->centre, track_place(&track, corner->to), corner->after, "W2");
    }
    track_free(&track);
}

void route_scene_add(Scene *scene, const House *house, const Observation *observation, bool routes, bool widths,
                     const Stop *stop) {
    if (!routes && !widths)
        return;
    bool *part = memory_zeroed(house->person_count, sizeof *part);
    for (size_t i = 0; i < house->person_count; i++)
        part[i] = observation->people[i].took_part && !census_walks(house->people[i].profile);
    Journeys journeys = journey_plan_all(house, part, 1, stop);
    for (size_t i = 0; i < house->person_count; i++) {
        const Journey *journey = &journeys.of[i];
        if (!part[i] || !journey->track.count)
            continue;
        if (routes)
            add_way(scene, &journey->track);
        if (widths)
            add_widths(scene, house, i, &journey->route);
    }
    journey_free_all(&journeys);
    memory_free(part);
}
