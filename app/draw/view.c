#include "draw/view.h"

#define DISTANCE 1.5 /* of the camera, in diagonals of the house: nearer looks more dramatic, farther flatter */
#define NEAREST 0.1  /* m before the camera: nearer points are clipped */

View view_plan(double metre, Vec2 origin) {
    const double depth = 1e-3; /* per m: higher points are nearer */
    return (View){.rows = {{metre, 0, 0, origin.x}, {0, -metre, 0, origin.y}, {0, 0, -depth, 0}, {0, 0, 0, 1}}};
}

typedef struct Direction {
    double x, y, z;
} Direction;

static void set_row(double row[4], double scale, Direction way, double offset) {
    row[0] = scale * way.x;
    row[1] = scale * way.y;
    row[2] = scale * way.z;
    row[3] = offset;
}

/* Returns the view of a page whose origin is the point that the camera looks at, F = 1. */
static View look_at(Camera camera, Box box, double top) {
    double turn = radians(camera.azimuth), rise = radians(camera.elevation);
    Direction right = {cos(turn), sin(turn), 0};
    Direction back = {sin(turn) * cos(rise), -cos(turn) * cos(rise), sin(rise)};
    Direction up = {-sin(turn) * sin(rise), cos(turn) * sin(rise), cos(rise)};
    Vec2 middle = vec2_scale(vec2_add(box.low, box.high), 0.5);
    double diagonal = vec2_distance(box.low, box.high) + top, distance = DISTANCE * diagonal;
    double across = middle.x * right.x + middle.y * right.y;
    double along = middle.x * up.x + middle.y * up.y + top / 2 * up.z;
    double towards = middle.x * back.x + middle.y * back.y + top / 2 * back.z;
    double near = distance - diagonal, far = distance + diagonal, slope = (far + near) / (far - near);
    View view = {.raised = true};
    set_row(view.rows[0], 1, right, -across);
    set_row(view.rows[1], -1, up, along);
    set_row(view.rows[3], -1, back, distance + towards);
    set_row(view.rows[2], -slope, back, slope * view.rows[3][3] - 2 * far * near / (far - near));
    return view;
}

View view_raised(Camera camera, Box box, double top, Box place) {
    View view = look_at(camera, box, top);
    Box seen = box_empty();
    for (int corner = 0; corner < 8; corner++) {
        Vec2 at = {corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y};
        seen = box_include(seen, view_point(&view, at, corner & 4 ? top : 0));
    }
    double width = box_width(place), height = box_height(place);
    double scale = fmin(width / box_width(seen), height / box_height(seen));
    scale *= camera.zoom > 0 ? camera.zoom : 1;
    Vec2 middle = vec2_scale(vec2_add(place.low, place.high), 0.5);
    Vec2 shift = vec2_along(middle, -scale / 2, vec2_add(seen.low, seen.high));
    for (int column = 0; column < 4; column++) {
        view.rows[0][column] = scale * view.rows[0][column] + shift.x * view.rows[3][column];
        view.rows[1][column] = scale * view.rows[1][column] + shift.y * view.rows[3][column];
    }
    Vec2 centre = vec2_scale(vec2_add(box.low, box.high), 0.5);
    Vec2 away = vec2_sub(view_point(&view, centre, 0), view_point(&view, vec2_add(centre, camera.pan), 0));
    for (int column = 0; column < 4; column++) {
        view.rows[0][column] += away.x * view.rows[3][column];
        view.rows[1][column] += away.y * view.rows[3][column];
    }
    return view;
}

static double row_value(const double row[4], Vec2 at, double height) {
    return row[0] * at.x + row[1] * at.y + row[2] * height + row[3];
}

Vec2 view_point(const View *view, Vec2 at, double height) {
    double w = row_value(view->rows[3], at, height);
    return vec2(row_value(view->rows[0], at, height) / w, row_value(view->rows[1], at, height) / w);
}

Vec2 view_floor(const View *view, Vec2 page) {
    const double *x = view->rows[0], *y = view->rows[1], *w = view->rows[3];
    double a = x[0] - page.x * w[0], b = x[1] - page.x * w[1], c = page.x * w[3] - x[3];
    double d = y[0] - page.y * w[0], e = y[1] - page.y * w[1], f = page.y * w[3] - y[3];
    double determinant = a * e - b * d;
    return vec2((c * e - b * f) / determinant, (a * f - c * d) / determinant);
}

double view_depth(const View *view, Vec2 at, double height) {
    return row_value(view->rows[2], at, height) / row_value(view->rows[3], at, height);
}

bool view_sees(const View *view, const Vec2 *points, size_t count, double height) {
    for (size_t i = 0; i < count; i++)
        if (row_value(view->rows[3], points[i], height) < NEAREST)
            return false;
    return true;
}

double view_scale(const View *view, Vec2 at, double height) {
    double w = row_value(view->rows[3], at, height);
    const double *x = view->rows[0], *y = view->rows[1], *depth = view->rows[3];
    if (!view->raised)
        return x[0] / w;
    /* W is constant across the line of sight */
    Vec2 right = vec2_left(vec2_unit(vec2(depth[0], depth[1])));
    if (vec2_dot(right, right) < 0.5)
        right = vec2(1, 0); /* straight from above */
    return vec2_length(vec2(x[0] * right.x + x[1] * right.y, y[0] * right.x + y[1] * right.y)) / w;
}
