#include "visual/house/space_scene.h"

#include "visual/house/silhouette.h"

#define CIRCLE_EDGE 1.5 /* design points */

/* m: more than any profile's extent from its reference point */
#define BODY_MOST 2.0

/* m: rays begin this far inside the body; a ray from a touching point would otherwise start beyond the obstacle */
#define BODY_DEPTH 0.02

/* 1: covering circles are at most this much wider than the body. */
#define CIRCLE_SLACK 1.1

/* Shortens the rays that meet another body. */
static void shorten_rays(const Standing *other, const EdgePoint *rays, double *reach) {
    Vec2 outline[SILHOUETTE_POINTS];
    silhouette_outline(other->profile, other->pose.at, other->pose.heading, 0, outline);
    for (int i = 0; i < SILHOUETTE_EDGE; i++)
        reach[i] = silhouette_ray(outline, SILHOUETTE_POINTS, rays[i].at, rays[i].normal, reach[i]);
}

Primitive *space_scene_add(Scene *scene, const House *house, const bool *door_open, const Standing *all, size_t count,
                           size_t own) {
    const Profile *profile = all[own].profile;
    Pose pose = all[own].pose;
    EdgePoint rays[SILHOUETTE_EDGE];
    double reach[SILHOUETTE_EDGE];
    silhouette_edge(profile, pose.at, pose.heading, rays);
    for (int i = 0; i < SILHOUETTE_EDGE; i++) {
        rays[i].at = vec2_along(rays[i].at, -BODY_DEPTH, rays[i].normal);
        reach[i] =
            outline_ray_past(&house->outline, door_open, rays[i].at, rays[i].normal, BODY_DEPTH + profile->space_reach);
    }
    for (size_t i = 0; i < count; i++)
        if (i != own && all[i].group == all[own].group &&
            vec2_distance(all[i].pose.at, pose.at) < 2 * BODY_MOST + profile->space_reach)
            shorten_rays(&all[i], rays, reach);
    Vec2 outline[SILHOUETTE_EDGE];
    for (int i = 0; i < SILHOUETTE_EDGE; i++)
        outline[i] = vec2_along(rays[i].at, fmax(BODY_DEPTH, reach[i]), rays[i].normal);
    Primitive *ring = scene_add_polygon(scene, ROLE_RING, outline, SILHOUETTE_EDGE);
    ring->fill_opacity = 0;
    return ring;
}

void space_scene_add_circles(Scene *scene, const Profile *profile, Pose pose) {
    bool round = profile->driving != DRIVING_DRIVER;
    double length = round ? 0 : profile->length, half = profile->width / 2, radius = half;
    size_t count = 1;
    while (!round && (radius = hypot(length / (double)(2 * count), half)) > CIRCLE_SLACK * half)
        count++;
    Vec2 axis = vec2_heading(pose.heading), middle = silhouette_middle(profile, pose.at, pose.heading);
    Vec2 *centres = memory_zeroed(count, sizeof *centres);
    for (size_t i = 0; i < count; i++)
        centres[i] = vec2_along(middle, length * (((double)i + 0.5) / (double)count - 0.5), axis);
    Primitive *circles = scene_add_discs(scene, ROLE_TEXT, radius, centres, count);
    circles->fill_opacity = 0;
    circles->width = CIRCLE_EDGE;
    memory_free(centres);
}
