#include "visual/house/route_scene.h"

#include "base/stop.h"
#include "house/journey.h"
#include "space/passage.h"
#include "result/census.h"

/* Design points. */
#define WAY_WIDTH 2.5
#define WIDTH_WIDTH 2.0
#define TEXT_SIZE 16.0

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

/* W1 and W2 are the paper's: computed on the route of its round body, for every driving model. */
static void add_widths(Scene *scene, const House *house, size_t person, const Route *route) {
    Track track = {0};
    track_build_miura(&track, house, &house->people[person], route);
    for (size_t c = 0; c < track.corner_count; c++) {
        const TrackCorner *corner = &track.corners[c];
        add_width(scene, corner->centre, track_place(&track, corner->from), corner->before, "W1");
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
