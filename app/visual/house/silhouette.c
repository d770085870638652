#include "visual/house/silhouette.h"

#include <stdlib.h>
#include <string.h>

Primitive *silhouette_add(Scene *scene, Role role, const Profile *profile, Pose pose) {
    Vec2 outline[SILHOUETTE_POINTS];
    silhouette_outline(profile, pose.at, pose.heading, 0, outline);
    return scene_add_polygon(scene, role, outline, SILHOUETTE_POINTS);
}

Vec2 silhouette_middle(const Profile *profile, Vec2 at, double heading) {
    if (profile->driving != DRIVING_DRIVER)
        return at;
    return vec2_along(at, profile->length / 2 - profile->axle, vec2_heading(heading));
}

void silhouette_outline(const Profile *profile, Vec2 at, double heading, double grown,
                        Vec2 outline[SILHOUETTE_POINTS]) {
    bool round = profile->driving != DRIVING_DRIVER;
    double length = round ? profile->width : profile->length;
    double radius = (round ? profile->width / 2 : profile->corner_radius) + grown;
    Vec2 axis = vec2_heading(heading), middle = silhouette_middle(profile, at, heading);
    Vec2 core = vec2(length / 2 + grown - radius, profile->width / 2 + grown - radius);
    const int pieces = SILHOUETTE_POINTS / 4;
    for (int corner = 0; corner < 4; corner++)
        for (int i = 0; i < pieces; i++) {
            Vec2 way = vec2_heading(M_PI / 2 * (corner + (double)i / (pieces - 1)));
            Vec2 centre = vec2(corner == 0 || corner == 3 ? core.x : -core.x, corner < 2 ? core.y : -core.y);
            outline[corner * pieces + i] = vec2_add(middle, vec2_turn(vec2_along(centre, radius, way), axis));
        }
}

static int compare_points(const void *a, const void *b) {
    const Vec2 *first = a, *second = b;
    int x = (first->x > second->x) - (first->x < second->x);
    return x ? x : (first->y > second->y) - (first->y < second->y);
}

/* Half of Andrew's monotone chain: adds a point behind `least` points, dropping those that would bend inwards. */
static size_t chain_add(Vec2 *hull, size_t count, size_t least, Vec2 p) {
    while (count > least && vec2_cross(vec2_sub(hull[count - 1], hull[count - 2]), vec2_sub(p, hull[count - 2])) <= 0)
        count--;
    hull[count] = p;
    return count + 1;
}

size_t silhouette_hull(const Vec2 first[SILHOUETTE_POINTS], const Vec2 second[SILHOUETTE_POINTS],
                       Vec2 hull[2 * SILHOUETTE_POINTS]) {
    enum { COUNT = 2 * SILHOUETTE_POINTS };
    Vec2 points[COUNT], chain[2 * COUNT];
    memcpy(points, first, COUNT / 2 * sizeof *points);
    memcpy(points + COUNT / 2, second, COUNT / 2 * sizeof *points);
    qsort(points, COUNT, sizeof *points, compare_points);
    size_t count = 0;
    for (size_t i = 0; i < COUNT; i++)
        count = chain_add(chain, count, 1, points[i]);
    size_t lower = count;
    for (size_t i = COUNT - 1; i-- > 0;)
        count = chain_add(chain, count, lower, points[i]);
    count--; /* the first point has come again */
    memcpy(hull, chain, count * sizeof *hull);
    return count;
}

Vec2 silhouette_nearest(const Vec2 outline[SILHOUETTE_POINTS], Vec2 to) {
    Vec2 best = outline[0];
    for (int i = 0; i < SILHOUETTE_POINTS; i++) {
        Vec2 on_side = vec2_nearest_on_segment(to, outline[i], outline[(i + 1) % SILHOUETTE_POINTS]);
        if (vec2_distance(on_side, to) < vec2_distance(best, to))
            best = on_side;
    }
    return best;
}

/* A quarter of the points round each corner and the side that follows it. */
void silhouette_edge(const Profile *profile, Vec2 at, double heading, EdgePoint edge[SILHOUETTE_EDGE]) {
    enum { QUARTER = SILHOUETTE_EDGE / 4, ARC = QUARTER / 2 };
    bool round = profile->driving != DRIVING_DRIVER;
    double radius = round ? profile->width / 2 : profile->corner_radius;
    Vec2 axis = vec2_heading(heading), middle = silhouette_middle(profile, at, heading);
    Vec2 core = vec2((round ? profile->width : profile->length) / 2 - radius, profile->width / 2 - radius);
    for (int corner = 0; corner < 4; corner++) {
        Vec2 here = vec2(corner == 0 || corner == 3 ? core.x : -core.x, corner < 2 ? core.y : -core.y);
        Vec2 next = vec2(corner < 2 ? -core.x : core.x, corner == 0 || corner == 3 ? core.y : -core.y);
        for (int i = 0; i < QUARTER; i++) {
            double arc = fmin(1, (double)i / ARC), side = fmax(0, (double)(i - ARC) / (QUARTER - ARC));
            Vec2 normal = vec2_heading(M_PI / 2 * (corner + arc));
            Vec2 centre = vec2_along(here, side, vec2_sub(next, here));
            edge[corner * QUARTER + i] =
                (EdgePoint){.at = vec2_add(middle, vec2_turn(vec2_along(centre, radius, normal), axis)),
                            .normal = vec2_turn(normal, axis)};
        }
    }
}

double silhouette_ray(const Vec2 *outline, size_t count, Vec2 from, Vec2 way, double reach) {
    for (size_t i = 0, j = count - 1; i < count; j = i++) {
        Vec2 side = vec2_sub(outline[i], outline[j]), to = vec2_sub(outline[j], from);
        double across = vec2_cross(way, side), along = vec2_cross(to, side) / across;
        double part = vec2_cross(to, way) / across;
        if (part >= 0 && part <= 1 && along >= 0 && along < reach)
            reach = along;
    }
    return reach;
}
