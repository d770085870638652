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

/* Adds a point behind `least` points, dropping those that would bend inwards: half of Andrew's monotone chain. */
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
    count--; /* the first point is repeated at the end */
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

/* Divides the edge by corners: a quarter of the points round each corner and along the side that follows it. */
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

/* Likenesses --------------------------------------------------------------------------------------------------------*/

/* The drawn chair is the manual chair, 1.10 m by 0.63 m, its axle 0.28 m from the rear. Others are scaled. */
#define DRAWN_LENGTH 1.10
#define DRAWN_WIDTH 0.63
#define DRAWN_AXLE 0.28

/* Design points. */
#define BODY_EDGE 2.0
#define PART_EDGE 1.0
#define LOOK_WIDTH 1.5

#define BODY_OPACITY 0.30

/* m, of a person on foot. */
#define STANDING_HEIGHT 1.40 /* of the shoulders */
#define STANDING_HEAD 1.53
#define DOT_SIZE 0.75 /* 1, of a body: of one of many people, some pixels large */
#define HEAD_RADIUS 0.11
#define LOOK_LENGTH 0.30

/* A box in the chair's frame, x ahead of the axle, y to the left, upright, m. */
typedef struct Part {
    Role role;
    double back, front, right, left, base, height;
} Part;

/* Lowest first, as they hide one another from above. ROLE_CHAIR stands for the role of the drawn chair. */
static const Part parts[] = {
    {ROLE_FURNITURE_LINE, 0.60, 0.80, -0.19, 0.19, 0.08, 0.03},  /* foot plate */
    {ROLE_FURNITURE_LINE, 0.40, 0.52, -0.25, -0.20, 0.00, 0.16}, /* casters */
    {ROLE_FURNITURE_LINE, 0.40, 0.52, 0.20, 0.25, 0.00, 0.16},
    {ROLE_FURNITURE_LINE, -0.14, 0.36, -0.22, 0.22, 0.44, 0.06}, /* seat */
    {ROLE_WALKER, 0.62, 0.80, -0.15, -0.05, 0.11, 0.08},         /* feet */
    {ROLE_WALKER, 0.62, 0.80, 0.05, 0.15, 0.11, 0.08},
    {ROLE_WALKER, 0.50, 0.62, -0.16, -0.04, 0.11, 0.44}, /* shins */
    {ROLE_WALKER, 0.50, 0.62, 0.04, 0.16, 0.11, 0.44},
    {ROLE_WALKER, 0.05, 0.62, -0.17, -0.03, 0.50, 0.14}, /* thighs */
    {ROLE_WALKER, 0.05, 0.62, 0.03, 0.17, 0.50, 0.14},
    {ROLE_CHAIR, 0.06, 0.34, -0.27, -0.20, 0.66, 0.09}, /* forearms */
    {ROLE_CHAIR, 0.06, 0.34, 0.20, 0.27, 0.66, 0.09},
    {ROLE_WALL, -0.22, -0.16, -0.22, 0.22, 0.44, 0.48},  /* back rest */
    {ROLE_CHAIR, -0.16, 0.08, -0.24, 0.24, 0.50, 0.58},  /* trunk */
    {ROLE_WALL, -0.28, -0.16, -0.24, -0.20, 0.90, 0.03}, /* handles */
    {ROLE_WALL, -0.28, -0.16, 0.20, 0.24, 0.90, 0.03},
};

#define WHEEL_RADIUS 0.28
#define WHEEL_OUTSIDE 0.31 /* of the wheel's outer side from the middle */
#define WHEEL_THICK 0.035
#define DRIVER_HEAD 1.24
#define DRIVER_HEAD_AT -0.02

/* Maps the frame of the drawn chair to the house. */
typedef struct Frame {
    Vec2 at, axis;
    double along, across; /* scales */
} Frame;

static Frame frame_of(const Profile *profile, Pose pose) {
    Frame frame = {.at = pose.at, .axis = vec2_heading(pose.heading)};
    if (profile->driving == DRIVING_DRIVER) {
        frame.along = profile->length / DRAWN_LENGTH;
        frame.across = profile->width / DRAWN_WIDTH;
        frame.at = vec2_along(frame.at, DRAWN_AXLE * frame.along - profile->axle, frame.axis);
    } else {
        frame.along = frame.across = profile->width / hypot(DRAWN_LENGTH, DRAWN_WIDTH);
        frame.at = vec2_along(frame.at, (DRAWN_AXLE - DRAWN_LENGTH / 2) * frame.along, frame.axis);
    }
    return frame;
}

static Vec2 place(const Frame *frame, double x, double y) {
    return vec2_add(frame->at, vec2_turn(vec2(x * frame->along, y * frame->across), frame->axis));
}

static void add_part(Scene *scene, const Frame *frame, const Part *part, Role role) {
    Vec2 corners[] = {place(frame, part->back, part->right), place(frame, part->front, part->right),
                      place(frame, part->front, part->left), place(frame, part->back, part->left)};
    Primitive *box = scene_add_polygon(scene, part->role == ROLE_CHAIR ? role : part->role, corners, 4);
    box->base = part->base;
    box->height = part->height;
    box->edge = ROLE_WALL;
    box->width = PART_EDGE;
}

static void add_wheel(Scene *scene, const Frame *frame, double side) {
    double inside = WHEEL_OUTSIDE - WHEEL_THICK;
    Primitive *wheel = scene_add_wheel(scene, ROLE_WALL, WHEEL_RADIUS * frame->along, place(frame, 0, side * inside),
                                       place(frame, 0, side * WHEEL_OUTSIDE));
    wheel->base = WHEEL_RADIUS * frame->along;
}

static void add_head(Scene *scene, Vec2 at, double height) {
    Primitive *head = scene_add_ball(scene, ROLE_PAPER, HEAD_RADIUS, at);
    head->base = height;
    head->edge = ROLE_WALL;
    head->width = PART_EDGE;
}

void silhouette_add_chair(Scene *scene, const Profile *profile, Pose pose, Role role) {
    Primitive *body = silhouette_add(scene, role, profile, pose);
    body->fill_opacity = BODY_OPACITY;
    body->width = BODY_EDGE;
    Frame frame = frame_of(profile, pose);
    add_wheel(scene, &frame, 1);
    add_wheel(scene, &frame, -1);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        add_part(scene, &frame, &parts[i], role);
    add_head(scene, place(&frame, DRIVER_HEAD_AT, 0), DRIVER_HEAD);
}

void silhouette_add_walkers(Scene *scene, const Profile *profile, const Pose *poses, size_t count, bool dots) {
    Vec2 *centres = memory_zeroed(count, sizeof *centres);
    for (size_t i = 0; i < count; i++)
        centres[i] = poses[i].at;
    Primitive *trunks = scene_add_discs(scene, dots ? ROLE_WALL : ROLE_WALKER,
                                        (dots ? DOT_SIZE : 1) * profile->width / 2, centres, count);
    trunks->height = STANDING_HEIGHT;
    trunks->edge = ROLE_PAPER;
    trunks->width = dots ? 0 : PART_EDGE;
    for (size_t i = 0; i < count && count <= SILHOUETTE_HEADINGS && !dots; i++) {
        Vec2 ends[] = {poses[i].at, vec2_along(poses[i].at, LOOK_LENGTH, vec2_heading(poses[i].heading))};
        scene_add_line(scene, ROLE_WALKER, LOOK_WIDTH, ends, 2)->base = STANDING_HEIGHT;
    }
    Primitive *heads = dots ? NULL : scene_add_discs(scene, ROLE_PAPER, HEAD_RADIUS, centres, count);
    if (heads) {
        heads->kind = PRIMITIVE_BALL;
        heads->base = STANDING_HEAD;
        heads->edge = ROLE_WALL;
        heads->width = PART_EDGE;
    }
    memory_free(centres);
}
