#include "visual/crank/crank_scene.h"

#include <math.h>

#include "base/real.h"

/* Directions in which the picture shows the world's axes: x to the right, y into the picture, z up. */
static const double INTO_RIGHT = 0.45, INTO_UP = 0.38;

#define MILLI 1000.0 /* mm per m */

enum { CORNERS = 72, TURNS_SHOWN = 8 };

/* Design points. */
#define THICK 5.0
#define MIDDLE 2.0
#define THIN 1.0
#define NAME 16.0

/* What is drawn, and where. */
typedef struct Drawing {
    Scene *scene;
    const Crank *crank;
    const Tree *tree;
    const Response *response;
    size_t row;         /* of the trace: the moment shown */
    double unit;        /* m, the crank's radius */
    double loupe;       /* m, radius of the clearance in the loupe */
    Vec2 socket, polar; /* middles of the loupe and of the polar diagram */
    double reach;       /* m, of the largest force in the polar diagram */
} Drawing;

static Vec2 seen(const double *at) {
    return vec2(at[0] + INTO_RIGHT * at[1], at[2] + INTO_UP * at[1]);
}

static void add_segment(Scene *scene, Role role, double width, const double *from, const double *to) {
    scene_add_line(scene, role, width, (Vec2[]){seen(from), seen(to)}, 2);
}

static void add_ring(Scene *scene, Role role, double width, LineStyle style, Vec2 middle, double radius) {
    Vec2 points[CORNERS + 1];
    for (int i = 0; i <= CORNERS; i++) {
        SineCosine turn = real_sincos(2 * M_PI * i / CORNERS);
        points[i] = vec2(middle.x + radius * turn.cosine, middle.y + radius * turn.sine);
    }
    scene_add_line(scene, role, width, points, CORNERS + 1)->style = style;
}

static void add_name(Scene *scene, Vec2 at, const char *text) {
    scene_add_label(scene, ROLE_TEXT, NAME, at, text)->fixed = true;
}

/* The mechanism ---------------------------------------------------------------------------------------------------- */

static void add_guide(const Drawing *d, double place) {
    double low = place - 1.2 * d->unit, high = place + 1.2 * d->unit;
    const double from[3] = {low, 0, 0}, to[3] = {high, 0, 0};
    add_segment(d->scene, ROLE_WALL, THICK, from, to);
    for (double x = low; x < high; x += d->unit / 5) {
        const double top[3] = {x, 0, 0}, foot[3] = {x - d->unit / 8, 0, -d->unit / 8};
        add_segment(d->scene, ROLE_FURNITURE_LINE, THIN, top, foot);
    }
}

static void add_crank(const Drawing *d, double theta) {
    Vec2 circle[CORNERS + 1];
    for (int i = 0; i <= CORNERS; i++)
        circle[i] = seen(tree_pin(d->tree, 2 * M_PI * i / CORNERS, 0).at);
    scene_add_polygon(d->scene, ROLE_FURNITURE, circle, CORNERS)->fill_opacity = 0.6;
    scene_add_line(d->scene, ROLE_FURNITURE_LINE, MIDDLE, circle, CORNERS + 1);
    TreePin pin = tree_pin(d->tree, theta, 0);
    const double size = d->unit / 4;
    double back[3];
    for (size_t i = 0; i < 3; i++)
        back[i] = d->tree->axis[i];
    back[0] -= d->unit * d->tree->tilt_cosine;
    back[1] -= d->unit * d->tree->tilt_sine;
    add_segment(d->scene, ROLE_WALL, THICK, back, d->tree->axis);
    Vec2 middle = seen(back);
    const Vec2 block[] = {vec2(middle.x - size, middle.y - size), vec2(middle.x + size, middle.y - size),
                          vec2(middle.x + size, middle.y + size), vec2(middle.x - size, middle.y + size)};
    scene_add_polygon(d->scene, ROLE_WALL, block, 4);
    add_name(d->scene, vec2(middle.x - size, middle.y - 1.8 * size), "bearing block");
    add_segment(d->scene, ROLE_WALL, THICK, d->tree->axis, pin.at);
    Vec2 at = seen(pin.at);
    scene_add_discs(d->scene, ROLE_DOOR, d->unit / 9, &at, 1);
}

/* The coupler runs from the slider to the pin. Its bending, some hundredths of a millimetre, is not in the record. */
static void add_coupler(const Drawing *d, double theta, double slider) {
    TreePin pin = tree_pin(d->tree, theta, 0);
    const double foot[3] = {slider, 0, 0}, size = d->unit / 3;
    add_segment(d->scene, ROLE_CHAIR, THICK, foot, pin.at);
    const Vec2 box[] = {vec2(slider - size, -size / 2), vec2(slider + size, -size / 2), vec2(slider + size, size / 2),
                        vec2(slider - size, size / 2)};
    scene_add_polygon(d->scene, ROLE_CHAIR, box, 4);
    Vec2 b = seen(pin.at), c = seen(foot);
    add_name(d->scene, vec2((b.x + c.x) / 2 + size, (b.y + c.y) / 2 + size), "coupler");
    add_name(d->scene, vec2(slider, -1.3 * size), "slider");
    add_name(d->scene, vec2(b.x, b.y + size), "joint");
}

/* The loupe -------------------------------------------------------------------------------------------------------- */

static void add_loupe(const Drawing *d) {
    const Trace *trace = &d->response->trace;
    double clearance = d->crank->clearance, factor = clearance > 0 ? d->loupe / clearance : 1;
    size_t most = TURNS_SHOWN * CRANK_SAMPLES, count = trace->rows < most ? trace->rows : most;
    size_t from = trace->rows - count;
    Vec2 *path = arena_allocate(&d->scene->arena, (count + 1) * sizeof *path);
    for (size_t i = 0; i < count; i++) {
        const double *row = trace_row(trace, from + i);
        path[i] = vec2(d->socket.x + factor * row[CRANK_ALONG], d->socket.y + factor * row[CRANK_UP]);
    }
    add_ring(d->scene, ROLE_FURNITURE_LINE, MIDDLE, LINE_SOLID, d->socket, d->loupe);
    scene_add_line(d->scene, ROLE_LOCUS, THIN, path, count);
    const double *row = trace_row(trace, d->row);
    Vec2 ball = vec2(d->socket.x + factor * row[CRANK_ALONG], d->socket.y + factor * row[CRANK_UP]);
    scene_add_discs(d->scene, ROLE_DANGER_MIDDLE, d->loupe / 14, &ball, 1);
    add_name(d->scene, vec2(d->socket.x, d->socket.y + 1.14 * d->loupe),
             scene_text(d->scene, "ball in its socket, from the side: clearance %g mm", MILLI * clearance));
}

/* The polar diagram ------------------------------------------------------------------------------------------------ */

static double round_up(double value) {
    double power = 1;
    while (power * 10 <= value)
        power *= 10;
    for (int i = 1; i <= 5; i++)
        if (i * 2 * power >= value)
            return i * 2 * power;
    return value;
}

static void add_polar(const Drawing *d) {
    const Trace *trace = &d->response->trace;
    double largest = round_up(real_max(1, d->response->peaks.max)), factor = d->reach / largest;
    size_t all = trace->rows / CRANK_SAMPLES, shown = all < TURNS_SHOWN ? all : TURNS_SHOWN;
    for (int ring = 1; ring <= 2; ring++) {
        add_ring(d->scene, ROLE_ROOM, THIN, ring == 2 ? LINE_SOLID : LINE_DOTTED, d->polar, d->reach * ring / 2);
        add_name(
            d->scene,
            vec2(d->polar.x + 0.71 * d->reach * ring / 2 + 0.18 * d->reach, d->polar.y - 0.75 * d->reach * ring / 2),
            scene_text(d->scene, "%g N", largest * ring / 2));
    }
    Vec2 *curve = arena_allocate(&d->scene->arena, (CRANK_SAMPLES + 1) * sizeof *curve);
    for (size_t k = 0; k < shown; k++) {
        for (size_t i = 0; i < CRANK_SAMPLES; i++) {
            const double *row = trace_row(trace, (all - shown + k) * CRANK_SAMPLES + i);
            SineCosine turn = real_sincos(row[CRANK_ANGLE] * M_PI / 180);
            double out = factor * row[CRANK_FORCE];
            curve[i] = vec2(d->polar.x - out * turn.sine, d->polar.y + out * turn.cosine);
        }
        bool last = k + 1 == shown;
        scene_add_line(d->scene, last ? ROLE_LOCUS : ROLE_LOCUS_SECOND, last ? MIDDLE : THIN / 2, curve, CRANK_SAMPLES);
    }
    const double *row = trace_row(trace, d->row);
    SineCosine turn = real_sincos(row[CRANK_ANGLE] * M_PI / 180);
    double out = factor * row[CRANK_FORCE];
    Vec2 peak = vec2(d->polar.x - out * turn.sine, d->polar.y + out * turn.cosine);
    scene_add_discs(d->scene, ROLE_DANGER_MIDDLE, d->reach / 24, &peak, 1);
    add_name(d->scene, vec2(d->polar.x, d->polar.y + 1.14 * d->reach),
             scene_text(d->scene, "force over the crank angle, last %zu revolutions", shown));
}

/* The whole -------------------------------------------------------------------------------------------------------- */

/* Returns the row of the largest force in the revolutions shown. */
static size_t hardest(const Trace *trace) {
    size_t most = TURNS_SHOWN * CRANK_SAMPLES, found = trace->rows < most ? 0 : trace->rows - most;
    for (size_t i = found; i < trace->rows; i++)
        if (trace_row(trace, i)[CRANK_FORCE] > trace_row(trace, found)[CRANK_FORCE])
            found = i;
    return found;
}

static void add_texts(const Drawing *d) {
    const Response *response = d->response;
    const SectionPeaks *peaks = &response->peaks;
    const char *verdict = response->verdict == RESPONSE_PERIODIC
                              ? scene_text(d->scene, "periodic, period %zu", response->orbit.period)
                              : response_verdict_name(response->verdict);
    const double *row = trace_row(&response->trace, d->row);
    d->scene->title = scene_text(d->scene, "%.4g rpm, clearance %g mm: %s", 60 * d->crank->frequency,
                                 MILLI * d->crank->clearance, verdict);
    d->scene->title_role = ROLE_TEXT;
    d->scene->detail = peaks->max - peaks->min < 0.5
                           ? scene_text(d->scene, "largest force %.1f N", peaks->max)
                           : scene_text(d->scene, "largest forces %.0f to %.0f N a revolution", peaks->min, peaks->max);
    d->scene->name = d->crank->name;
    d->scene->note = crank_is_assumed(d->crank) ? "Every number of this mechanism is assumed." : "";
    d->scene->clock = scene_text(d->scene, "%.0f deg, %.0f N", row[CRANK_ANGLE], row[CRANK_FORCE]);
    d->scene->unscaled = true;
}

void crank_scene_make(Scene *scene, const Crank *crank, const Tree *tree, const Response *response) {
    Drawing d = {scene, crank, tree, response, hardest(&response->trace), crank->radius, 0, {0, 0}, {0, 0}, 0};
    const double *row = trace_row(&response->trace, d.row);
    double theta = row[CRANK_ANGLE] * M_PI / 180, slider = row[CRANK_SLIDER];
    double height = tree->axis[2] + INTO_UP * tree->axis[1] + 1.6 * d.unit, foot = -0.5 * d.unit;
    double right = slider + 1.6 * d.unit, middle = (height + foot) / 2, half = 0.75 * (height - foot);
    d.loupe = 0.36 * half;
    d.reach = d.loupe;
    d.socket = vec2(right + 2.2 * d.loupe, middle + 0.48 * half);
    d.polar = vec2(d.socket.x, middle - 0.54 * half);
    add_guide(&d, slider);
    add_crank(&d, theta);
    add_coupler(&d, theta, slider);
    add_loupe(&d);
    add_polar(&d);
    scene->box = (Box){vec2(-2.2 * d.unit, middle - half), vec2(d.polar.x + 2.2 * d.reach, middle + half)};
    add_texts(&d);
}
