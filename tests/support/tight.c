#include "tight.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* m: thickness of the walls, and how far those beside an exit extend behind it. */
#define THICK 0.12
#define BEHIND 0.5

/* m: the widths are drawn from this much below to this much above the least with which the chair can be driven. */
#define BELOW 0.05
#define ABOVE 0.15

static const char *const kind_names[TIGHT_KINDS] = {"corner", "door in", "door out",  "S",     "U",
                                                    "flat",   "bend",    "wide door", "niche", "slalom"};

static const char *const size_names[TIGHT_KINDS][TIGHT_SIZES] = {{"W1", "W2"},    {"C", "D", "x"},
                                                                 {"C", "D", "x"}, {"W", "middle", "axes"},
                                                                 {"W", "turn"},   {"C", "D", "gap", "shelf"},
                                                                 {"W", "angle"},  {"C", "D", "x", "out"},
                                                                 {"C", "D", "x"}, {"C", "gap", "apart"}};

const char *tight_kind_name(TightKind kind) {
    return kind_names[kind];
}

void tight_sizes(const TightScene *scene, char *text, size_t size) {
    size_t used = 0;
    text[0] = '\0';
    for (int i = 0; i < TIGHT_SIZES && size_names[scene->kind][i] && used < size; i++)
        used += (size_t)snprintf(text + used, size - used, "%s%s %.4f", i ? ", " : "", size_names[scene->kind][i],
                                 scene->sizes[i]);
}

/* Drawing ------------------------------------------------------------------------------------------------------ */

static void add_solid(TightScene *scene, Vec2 a, Vec2 b, double half, bool wall) {
    scene->solids[scene->count++] = (TightSolid){a, b, half, wall};
}

/* Adds a wall that fills an upright rectangle. */
static void add_wall(TightScene *scene, double x0, double y0, double x1, double y1) {
    if (x1 - x0 >= y1 - y0)
        add_solid(scene, vec2(x0, (y0 + y1) / 2), vec2(x1, (y0 + y1) / 2), (y1 - y0) / 2, true);
    else
        add_solid(scene, vec2((x0 + x1) / 2, y0), vec2((x0 + x1) / 2, y1), (x1 - x0) / 2, true);
}

/* Adds a piece of furniture, turned by `angle` rad. */
static void add_piece(TightScene *scene, Vec2 centre, Vec2 size, double angle) {
    Vec2 along = vec2_heading(angle);
    add_solid(scene, vec2_along(centre, -size.x / 2, along), vec2_along(centre, size.x / 2, along), size.y / 2, false);
}

/* Places the exit between two places; its ends lie inside the walls. */
static void add_exit(TightScene *scene, Vec2 from, Vec2 to) {
    Vec2 along = vec2_unit(vec2_sub(to, from));
    scene->exit[0] = vec2_along(from, -THICK / 2, along);
    scene->exit[1] = vec2_along(to, THICK / 2, along);
}

static double between(Random *random, double low, double high) {
    return low + (high - low) * random_uniform(random);
}

static double near_limit(Random *random, double limit) {
    return between(random, limit - BELOW, limit + ABOVE);
}

/* Interpolates in a table of (x, y) with rising x; the ends hold beyond it. */
static double interpolate(const double (*table)[2], size_t count, double x) {
    for (size_t i = 1; i < count; i++)
        if (x <= table[i][0]) {
            double part = fmax(0, (x - table[i - 1][0]) / (table[i][0] - table[i - 1][0]));
            return table[i - 1][1] + part * (table[i][1] - table[i - 1][1]);
        }
    return table[count - 1][1];
}

/* m: the least W2 for W1, and the least doors into a room and out of it for the corridor's width, all without a change
 * of direction. */
static const double corner_limits[][2] = {{0.75, 0.99}, {0.80, 0.96}, {0.85, 0.93}, {0.91, 0.91},
                                          {1.06, 0.85}, {1.25, 0.80}, {1.39, 0.75}};
static const double in_limits[][2] = {{0.90, 0.83}, {0.95, 0.81}, {1.00, 0.79},
                                      {1.05, 0.73}, {1.10, 0.70}, {1.20, 0.66}};
static const double out_limits[][2] = {{0.90, 0.92}, {0.95, 0.81}, {1.00, 0.73},
                                       {1.05, 0.69}, {1.10, 0.67}, {1.20, 0.65}};
#define LIMIT_OF(table_, x_) interpolate(table_, sizeof(table_) / sizeof *(table_), x_)

/* m: the least width of S-bends and U-turns that are equally wide everywhere, about. */
#define BEND_LIMIT 0.91

/* m: no passage is narrower than this. */
#define LEAST 0.65

/* A leg along x, and one upwards from its end. */
static void draw_corner(TightScene *scene, Random *random) {
    const double leg = 4;
    double w1 = between(random, 0.78, 1.30);
    double w2 = near_limit(random, LIMIT_OF(corner_limits, w1));
    add_wall(scene, -THICK, -THICK, leg + w2 + THICK, 0);
    add_wall(scene, -THICK, -THICK, 0, w1 + THICK);
    add_wall(scene, -THICK, w1, leg, w1 + THICK);
    add_wall(scene, leg - THICK, w1, leg, w1 + leg + BEHIND);
    add_wall(scene, leg + w2, -THICK, leg + w2 + THICK, w1 + leg + BEHIND);
    add_exit(scene, vec2(leg, w1 + leg), vec2(leg + w2, w1 + leg));
    scene->at = vec2(1, w1 / 2);
    scene->sizes[0] = w1;
    scene->sizes[1] = w2;
}

/* A corridor of width c along x with a door of width d in its upper side, and a room above. */
static void build_door(TightScene *scene, double c, double d, double x, bool in) {
    const double length = 6, room = 3;
    double left = x - room / 2, right = x + room / 2, begin = in ? -THICK : -BEHIND;
    add_wall(scene, begin, -THICK, length + THICK, 0);
    add_wall(scene, length, -THICK, length + THICK, c + THICK);
    add_wall(scene, begin, c, x - d / 2, c + THICK);
    add_wall(scene, x + d / 2, c, length + THICK, c + THICK);
    add_wall(scene, left - THICK, c, left, c + room + BEHIND);
    add_wall(scene, right, c, right + THICK, c + room + BEHIND);
    if (in) {
        add_wall(scene, -THICK, -THICK, 0, c + THICK);
        add_exit(scene, vec2(left, c + room), vec2(right, c + room));
        scene->at = vec2(1, c / 2);
    } else {
        add_wall(scene, left - THICK, c + room, right + THICK, c + room + THICK);
        add_exit(scene, vec2(0.2, 0), vec2(0.2, c));
        scene->at = vec2(x, c + 2.2);
        scene->heading = -M_PI_2;
    }
    scene->sizes[0] = c;
    scene->sizes[1] = d;
    scene->sizes[2] = x;
}

static void draw_door(TightScene *scene, Random *random, bool in) {
    double c = between(random, 0.90, 1.20);
    double d = fmax(LEAST, near_limit(random, in ? LIMIT_OF(in_limits, c) : LIMIT_OF(out_limits, c)));
    build_door(scene, c, d, between(random, 2.8, 3.2), in);
}

/* A door that is wider than the corridor, where that is too narrow for a door of its width. */
static void draw_wide_door(TightScene *scene, Random *random) {
    double c = between(random, 0.80, 0.95), d = between(random, 0.90, 1.20);
    bool in = random_uniform(random) < 0.5;
    build_door(scene, c, d, between(random, 2.8, 3.2), in);
    scene->sizes[3] = !in;
}

/* Two legs, the second one turned to the left by any angle. */
static void draw_bend(TightScene *scene, Random *random) {
    const double leg = 4;
    double angle = radians(between(random, 20, 140)), w = between(random, 0.80, 1.05);
    double half = w / 2 + THICK / 2, inset = tan(angle / 2);
    Vec2 corner = vec2(leg, 0), along = vec2_heading(angle);
    for (int side = -1; side <= 1; side += 2) {
        /* m along the legs: to where the faces of the walls meet, or, outside, to where the walls do */
        double until = -side * inset * (side > 0 ? w / 2 : w / 2 + THICK);
        Vec2 across = vec2_scale(vec2_left(along), side * half);
        add_solid(scene, vec2(-THICK, side * half), vec2(leg + until, side * half), THICK / 2, true);
        add_solid(scene, vec2_add(vec2_along(corner, -until, along), across),
                  vec2_add(vec2_along(corner, leg + BEHIND, along), across), THICK / 2, true);
    }
    add_wall(scene, -THICK, -w / 2 - THICK, 0, w / 2 + THICK);
    Vec2 end = vec2_along(corner, leg, along);
    add_exit(scene, vec2_along(end, w / 2, vec2_left(along)), vec2_along(end, -w / 2, vec2_left(along)));
    scene->at = vec2(1, 0);
    scene->sizes[0] = w;
    scene->sizes[1] = degrees(angle);
}

/* A niche above a corridor, with the chair in it as it drove in. */
static void draw_niche(TightScene *scene, Random *random) {
    const double length = 6, depth = 1.4;
    double c = between(random, 0.95, 1.35), d = between(random, LEAST + 0.1, 1.05);
    double x = between(random, 3.4, 4), left = x - d / 2, right = x + d / 2, top = c + depth;
    add_wall(scene, -BEHIND, -THICK, length + THICK, 0);
    add_wall(scene, length, -THICK, length + THICK, c + THICK);
    add_wall(scene, -BEHIND, c, left, c + THICK);
    add_wall(scene, right, c, length + THICK, c + THICK);
    add_wall(scene, left - THICK, c, left, top + THICK);
    add_wall(scene, right, c, right + THICK, top + THICK);
    add_wall(scene, left - THICK, top, right + THICK, top + THICK);
    add_exit(scene, vec2(0.2, 0), vec2(0.2, c));
    scene->at = vec2(x, c + depth - 0.95);
    scene->heading = M_PI_2;
    scene->sizes[0] = c;
    scene->sizes[1] = d;
    scene->sizes[2] = x;
}

/* A corridor with three pieces of furniture on alternate sides. */
static void draw_slalom(TightScene *scene, Random *random) {
    const double length = 7, deep = 0.4;
    double c = between(random, 1.3, 1.7), gap = between(random, LEAST + 0.03, 0.95), apart = between(random, 1.1, 1.7);
    add_wall(scene, -THICK, -THICK, length + BEHIND, 0);
    add_wall(scene, -THICK, c, length + BEHIND, c + THICK);
    add_wall(scene, -THICK, -THICK, 0, c + THICK);
    for (int i = 0; i < 3; i++) {
        double x = 2.4 + i * apart, y = i % 2 ? c - (c - gap) / 2 : (c - gap) / 2;
        add_piece(scene, vec2(x, y), vec2(deep, c - gap), 0);
    }
    add_exit(scene, vec2(length, 0), vec2(length, c));
    scene->at = vec2(0.6, c / 2);
    scene->sizes[0] = c;
    scene->sizes[1] = gap;
    scene->sizes[2] = apart;
}

/* Two legs along x whose axes are apart, and a leg upwards between them. */
static void draw_s(TightScene *scene, Random *random) {
    const double leg = 3;
    double w = near_limit(random, BEND_LIMIT), middle = near_limit(random, BEND_LIMIT);
    double axes = between(random, 1.2, 1.6), end = leg + middle + leg;
    add_wall(scene, -THICK, -THICK, leg + middle + THICK, 0);
    add_wall(scene, -THICK, -THICK, 0, w + THICK);
    add_wall(scene, -THICK, w, leg, w + THICK);
    add_wall(scene, leg - THICK, w, leg, axes + w + THICK);
    add_wall(scene, leg - THICK, axes + w, end + BEHIND, axes + w + THICK);
    add_wall(scene, leg + middle, -THICK, leg + middle + THICK, axes);
    add_wall(scene, leg + middle, axes - THICK, end + BEHIND, axes);
    add_exit(scene, vec2(end, axes), vec2(end, axes + w));
    scene->at = vec2(1, w / 2);
    scene->sizes[0] = w;
    scene->sizes[1] = middle;
    scene->sizes[2] = axes;
}

/* A leg along x, and one back beside it, one wall between the two. */
static void draw_u(TightScene *scene, Random *random) {
    const double leg = 3;
    double w = near_limit(random, BEND_LIMIT), turn = near_limit(random, BEND_LIMIT), top = 2 * w + THICK;
    add_wall(scene, -THICK, -THICK, leg + turn + THICK, 0);
    add_wall(scene, -THICK, -THICK, 0, w + THICK);
    add_wall(scene, -BEHIND, w, leg, w + THICK);
    add_wall(scene, leg + turn, -THICK, leg + turn + THICK, top + THICK);
    add_wall(scene, -BEHIND, top, leg + turn + THICK, top + THICK);
    add_exit(scene, vec2(0, w + THICK), vec2(0, top));
    scene->at = vec2(1, w / 2);
    scene->sizes[0] = w;
    scene->sizes[1] = turn;
}

/* A room with a bed, a wardrobe and a table, its door, and a corridor with a shelf. The chair starts between the bed
 * and the upper wall, in front of the gap between the bed and the wardrobe. */
static void draw_flat(TightScene *scene, Random *random) {
    const double length = 5.5, width = 3.2, height = 3.6, bed = 2, tilt = radians(4);
    double c = between(random, 0.95, 1.20), floor = c + THICK, top = floor + height;
    double d = fmax(LEAST, near_limit(random, LIMIT_OF(out_limits, c)));
    double gap = between(random, LEAST + 0.02, LEAST + ABOVE), shelf = between(random, LEAST + 0.02, LEAST + ABOVE);
    double x = between(random, 1.2, 2), wardrobe = width - bed - gap;
    add_wall(scene, -THICK, -THICK, length + BEHIND, 0);
    add_wall(scene, -THICK, -THICK, 0, top + THICK);
    add_wall(scene, -THICK, c, x - d / 2, floor);
    add_wall(scene, x + d / 2, c, length + BEHIND, floor);
    add_wall(scene, width, c, width + THICK, top + THICK);
    add_wall(scene, -THICK, top, width + THICK, top + THICK);
    add_piece(scene, vec2(bed / 2, floor + 1.85), vec2(bed, 0.95), 0);
    add_piece(scene, vec2(width - wardrobe / 2, floor + 1.7), vec2(wardrobe, 0.9), 0);
    add_piece(scene, vec2(0.35, floor + between(random, 0.4, 0.8)), vec2(0.5, 0.45), between(random, -tilt, tilt));
    add_piece(scene, vec2(width - 0.3, floor + 0.35), vec2(0.4, 0.4), between(random, 0, M_PI_2));
    add_piece(scene, vec2(4.2, (c - shelf) / 2), vec2(0.6, c - shelf), 0);
    add_exit(scene, vec2(length, 0), vec2(length, c));
    scene->at = vec2(bed + gap / 2, top - 0.37);
    scene->heading = -M_PI_2;
    scene->sizes[0] = c;
    scene->sizes[1] = d;
    scene->sizes[2] = gap;
    scene->sizes[3] = shelf;
}

TightScene tight_draw(TightKind kind, uint64_t seed) {
    TightScene scene = {.kind = kind};
    Random random = random_seed(seed, 1);
    switch (kind) {
    case TIGHT_CORNER:
        draw_corner(&scene, &random);
        break;
    case TIGHT_IN:
    case TIGHT_OUT:
        draw_door(&scene, &random, kind == TIGHT_IN);
        break;
    case TIGHT_S:
        draw_s(&scene, &random);
        break;
    case TIGHT_U:
        draw_u(&scene, &random);
        break;
    case TIGHT_BEND:
        draw_bend(&scene, &random);
        break;
    case TIGHT_WIDE_DOOR:
        draw_wide_door(&scene, &random);
        break;
    case TIGHT_NICHE:
        draw_niche(&scene, &random);
        break;
    case TIGHT_SLALOM:
        draw_slalom(&scene, &random);
        break;
    case TIGHT_FLAT:
    case TIGHT_KINDS:
        draw_flat(&scene, &random);
        break;
    }
    return scene;
}

/* Changes ------------------------------------------------------------------------------------------------------ */

static void move_point(Vec2 *point, bool mirrored, Vec2 axis, Vec2 shift) {
    *point = vec2_add(vec2_turn(vec2(point->x, mirrored ? -point->y : point->y), axis), shift);
}

void tight_move(TightScene *scene, bool mirrored, double angle, Vec2 shift) {
    Vec2 axis = vec2_heading(angle);
    for (size_t i = 0; i < scene->count; i++) {
        move_point(&scene->solids[i].a, mirrored, axis, shift);
        move_point(&scene->solids[i].b, mirrored, axis, shift);
    }
    for (int end = 0; end < 2; end++)
        move_point(&scene->exit[end], mirrored, axis, shift);
    move_point(&scene->at, mirrored, axis, shift);
    scene->heading = (mirrored ? -scene->heading : scene->heading) + angle;
}

void tight_grow(TightScene *scene, size_t solid, double by) {
    TightSolid *grown = &scene->solids[solid];
    Vec2 along = vec2_unit(vec2_sub(grown->b, grown->a));
    grown->a = vec2_along(grown->a, -by, along);
    grown->b = vec2_along(grown->b, by, along);
    grown->half += by;
}

void tight_shrink(TightScene *scene, double by) {
    for (size_t i = 0; i < scene->count; i++)
        tight_grow(scene, i, -by);
}

void tight_swap_exit(TightScene *scene) {
    Vec2 first = scene->exit[0];
    scene->exit[0] = scene->exit[1];
    scene->exit[1] = first;
}

/* Returns the index of a wall; every scene has some. */
static size_t any_wall(const TightScene *scene, Random *random) {
    for (;;) {
        size_t i = (size_t)(random_uniform(random) * (double)scene->count);
        if (scene->solids[i].wall)
            return i;
    }
}

void tight_split_wall(TightScene *scene, Random *random) {
    size_t wall = any_wall(scene, random);
    TightSolid *first = &scene->solids[wall], second = *first;
    Vec2 at = vec2_along(first->a, between(random, 0.3, 0.7), vec2_sub(first->b, first->a));
    first->b = at;
    add_solid(scene, at, second.b, second.half, true);
}

void tight_reverse_walls(TightScene *scene) {
    for (size_t i = 0; i < scene->count; i++)
        if (scene->solids[i].wall) {
            Vec2 a = scene->solids[i].a;
            scene->solids[i].a = scene->solids[i].b;
            scene->solids[i].b = a;
        }
}

void tight_add_inside(TightScene *scene, Random *random) {
    TightSolid around = scene->solids[any_wall(scene, random)];
    Vec2 along = vec2_sub(around.b, around.a);
    add_solid(scene, vec2_along(around.a, 0.3, along), vec2_along(around.a, 0.6, along), around.half / 2, false);
}

/* The sweep ---------------------------------------------------------------------------------------------------- */

typedef struct Slab {
    Vec2 centre, axis;
    Vec2 half; /* m, along the axis and across */
} Slab;

static Slab rectangle_of(const TightSolid *solid) {
    Vec2 along = vec2_sub(solid->b, solid->a);
    return (Slab){vec2_scale(vec2_add(solid->a, solid->b), 0.5), vec2_unit(along),
                  vec2(vec2_length(along) / 2, solid->half)};
}

/* Returns the gap of two rectangles along the four normals of their sides, the largest one. */
static double separation(const Slab *a, const Slab *b) {
    const Vec2 normals[4] = {a->axis, vec2_left(a->axis), b->axis, vec2_left(b->axis)};
    Vec2 apart = vec2_sub(b->centre, a->centre);
    double most = -HUGE_VAL;
    for (int n = 0; n < 4; n++) {
        double reach = 0;
        for (int side = 0; side < 2; side++) {
            const Slab *of = side ? b : a;
            reach += of->half.x * fabs(vec2_dot(of->axis, normals[n]));
            reach += of->half.y * fabs(vec2_dot(vec2_left(of->axis), normals[n]));
        }
        most = fmax(most, fabs(vec2_dot(apart, normals[n])) - reach);
    }
    return most;
}

/* Returns the place on the arc from one pose to another whose heading turns evenly, `part` of the way along it. */
static Vec2 on_arc(const Pose *from, Vec2 move, double turn, double part) {
    if (fabs(turn) < 1e-9)
        return vec2_along(from->at, part, move);
    /* The chord's length grows as sin(turn / 2), and its direction is that of the heading half-way. */
    double share = sin(part * turn / 2) / sin(turn / 2);
    return vec2_along(from->at, share, vec2_turn(move, vec2_heading((part - 1) * turn / 2)));
}

double tight_sweep(const TightScene *scene, const Profile *profile, const Route *route) {
    const double step = 0.001; /* m, of the body's farthest point */
    double ahead = profile->length / 2 - profile->axle, least = HUGE_VAL;
    double reach = hypot(profile->length / 2 + fabs(ahead), profile->width / 2);
    for (size_t i = 1; i < route->count; i++) {
        const Pose *from = &route->poses[i - 1], *to = &route->poses[i];
        Vec2 move = vec2_sub(to->at, from->at);
        double turn = vec2_wrap_angle(to->heading - from->heading);
        int steps = 1 + (int)((vec2_length(move) + reach * fabs(turn)) / step);
        for (int k = 0; k <= steps; k++) {
            double part = (double)k / steps;
            Vec2 axis = vec2_heading(from->heading + part * turn);
            Slab body = {vec2_along(on_arc(from, move, turn, part), ahead, axis), axis,
                         vec2(profile->length / 2, profile->width / 2)};
            for (size_t s = 0; s < scene->count; s++) {
                Slab solid = rectangle_of(&scene->solids[s]);
                least = fmin(least, separation(&body, &solid));
            }
        }
    }
    return least;
}

/* Houses ------------------------------------------------------------------------------------------------------- */

void tight_build(TightHouse *tight, const TightScene *scene, const Profile *profile) {
    const double cell = 0.05;
    *tight = (TightHouse){.house = {.plan = {.name = "tight"}}};
    Plan *plan = &tight->house.plan;
    plan->walls = tight->walls;
    plan->furniture = tight->furniture;
    plan->exits = &tight->exit;
    plan->exit_count = 1;
    for (size_t i = 0; i < scene->count; i++) {
        const TightSolid *solid = &scene->solids[i];
        Vec2 along = vec2_sub(solid->b, solid->a);
        if (solid->wall) {
            Vec2 *points = &tight->points[2 * plan->wall_count];
            points[0] = solid->a;
            points[1] = solid->b;
            tight->walls[plan->wall_count++] =
                (Wall){.id = "w", .points = {points, 2}, .thickness = 2 * solid->half, .height = 2.4};
        } else {
            tight->furniture[plan->furniture_count++] =
                (Furniture){.id = "f",
                            .name = "piece",
                            .centre = vec2_scale(vec2_add(solid->a, solid->b), 0.5),
                            .size = vec2(vec2_length(along), 2 * solid->half),
                            .angle = degrees(atan2(along.y, along.x)),
                            .height = 0.8};
        }
    }
    plan->run.cell = cell;
    tight->exit = (Exit){.id = "e1", .from = scene->exit[0], .to = scene->exit[1], .closes = HUGE_VAL};
    Fault fault = {0};
    if (!outline_build(&tight->house.outline, plan, &fault)) {
        fprintf(stderr, "%s\n", fault.count ? fault.lines[0] : "the solids cannot be united");
        exit(2);
    }
    fault_clear(&fault);
    freespace_build(&tight->house.space, &tight->house.outline, cell);
    tight->query = (RouteQuery){.plan = plan,
                                .space = &tight->house.space,
                                .profile = profile,
                                .at = scene->at,
                                .heading = scene->heading,
                                .exit = SIZE_MAX,
                                .most_reversals = 6,
                                .brief = true};
}

void tight_free(TightHouse *tight) {
    freespace_free(&tight->house.space);
    outline_free(&tight->house.outline);
}
