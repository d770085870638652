#include "visual/crank/crank_scene.h"

#include <math.h>
#include <string.h>

#include "base/real.h"
#include "visual/machine/pieces.h"

/* Directions in which the picture shows the world's axes: x to the right, y into the picture, z up. */
static const double INTO_RIGHT = 0.45, INTO_UP = 0.38;

#define MILLI 1000.0 /* mm per m */

enum { CORNERS = 72, BENDS = 24, TURNS_SHOWN = 8, PATH_TURNS = 3, STROKE_ANGLES = 90, ARC = 12 };

/* Design points. */
#define THICK 5.0
#define MIDDLE 2.0
#define THIN 1.0
#define NAME 15.0

/* In the crank's radius: the largest drawn deflection, and the longest arrow of a force. */
static const double DEFLECTION = 0.35, ARROW = 1.1;

static const double OUTERMOST = 1.6; /* radii of the loupe: the path is drawn no farther from its middle */

/* In the loupe's radius: its title over its middle, above the overlaps that the path shows. */
static const double TITLE = 1.36;

static const double AT_WALL =
    0.95; /* of the loupe's radius: the ball is seen at the wall, and not before or behind it */

static const double ARC_HALF = 0.35; /* rad, half of the arc of the wall that is touched */

/* What is drawn, and how. */
typedef struct Drawing {
    Scene *scene;
    const Tree *tree;
    const CrankScale *scale;
} Drawing;

static Vec2 seen(const double *at) {
    return vec2(at[0] + INTO_RIGHT * at[1], at[2] + INTO_UP * at[1]);
}

static void add_segment(Scene *scene, Role role, double width, const double *from, const double *to) {
    scene_add_line(scene, role, width, (Vec2[]){seen(from), seen(to)}, 2);
}

static Vec2 on_ring(Vec2 middle, double radius, double angle) {
    SineCosine turn = real_sincos(angle);
    return vec2(middle.x + radius * turn.cosine, middle.y + radius * turn.sine);
}

static void add_ring(Scene *scene, Role role, double width, LineStyle style, Vec2 middle, double radius) {
    Vec2 points[CORNERS + 1];
    for (int i = 0; i <= CORNERS; i++)
        points[i] = on_ring(middle, radius, 2 * M_PI * i / CORNERS);
    scene_add_line(scene, role, width, points, CORNERS + 1)->style = style;
}

/* A name that every picture needs, such as a scale. */
static void add_name(const Drawing *d, Vec2 at, const char *text) {
    if (d->scale->parts & CRANK_SCENE_NAMES)
        scene_add_label(d->scene, ROLE_TEXT, NAME, at, text)->fixed = true;
}

/* A name that a small picture leaves out. */
static void add_name_with_room(const Drawing *d, Vec2 at, const char *text) {
    if (!(d->scale->parts & CRANK_SCENE_NAMES))
        return;
    Primitive *label = scene_add_label(d->scene, ROLE_TEXT, NAME, at, text);
    label->fixed = label->optional = true;
}

/* Scale ------------------------------------------------------------------------------------------------------------ */

/* Rounds up to 2, 4, 6, 8 or 10 times a power of ten; the least is 2. */
static double round_up(double value) {
    double power = 1;
    while (power * 10 < value)
        power *= 10;
    for (int i = 1; i <= 5; i++)
        if (i * 2 * power >= value)
            return i * 2 * power;
    return value;
}

/* Rounds down to 1, 2 or 5 times a power of ten, at least 1. */
static double round_down(double value) {
    double power = 1;
    while (power * 10 <= value)
        power *= 10;
    return value >= 5 * power ? 5 * power : value >= 2 * power ? 2 * power : power;
}

CrankScale crank_scene_scale(const Crank *crank, const Tree *tree, double reach, double force) {
    CrankScale scale = {.parts = CRANK_SCENE_ALL, .unit = crank->radius, .largest = round_up(force)};
    scale.bend = reach > 0 ? round_down(DEFLECTION * scale.unit / reach) : 1;
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (int i = 0; i < STROKE_ANGLES; i++) {
        double place = tree_ideal_slider(tree, 2 * M_PI * i / STROKE_ANGLES);
        least = real_min(least, place);
        most = real_max(most, place);
    }
    scale.place = (least + most) / 2;
    double height = tree->axis[2] + INTO_UP * tree->axis[1] + 1.6 * scale.unit, foot = -0.8 * scale.unit;
    double right = most + 1.1 * scale.unit, middle = (height + foot) / 2, half = 0.62 * (height - foot);
    scale.loupe = 0.34 * half;
    scale.reach = 0.30 * half; /* the angles stand around it */
    scale.socket = vec2(right + 0.70 * half, middle + 0.56 * half);
    scale.polar = vec2(scale.socket.x, middle - 0.50 * half);
    scale.box =
        (Box){vec2(-2.3 * scale.unit, middle - 1.06 * half), vec2(scale.polar.x + 0.82 * half, middle + 1.08 * half)};
    return scale;
}

double crank_scene_reach(const Tree *tree, const double *state) {
    const double *eta = state + 3 + tree->axial, *zeta = eta + tree->bending, *u = zeta + tree->bending;
    double reach = real_hypot(real_hypot(u[0], u[1]), u[2]), across = 0, up = 0;
    for (size_t n = 0; n < tree->bending; n++) {
        across += fabs(eta[n]);
        up += fabs(zeta[n]);
    }
    return real_max(reach, real_hypot(across, up));
}

/* The mechanism, fixed --------------------------------------------------------------------------------------------- */

static void add_guide(const Drawing *d) {
    double unit = d->scale->unit, low = d->scale->place - 1.6 * unit, high = d->scale->place + 1.6 * unit;
    machine_pieces_ground(d->scene, vec2(low, -unit / 3), vec2(high, -unit / 3), -unit / 8);
    const double from[3] = {low, 0, 0}, to[3] = {high, 0, 0};
    add_segment(d->scene, ROLE_WALL, MIDDLE, from, to);
}

static void add_disc(const Drawing *d) {
    Vec2 circle[CORNERS + 1];
    for (int i = 0; i <= CORNERS; i++)
        circle[i] = seen(tree_pin(d->tree, 2 * M_PI * i / CORNERS, 0).at);
    scene_add_polygon(d->scene, ROLE_FURNITURE, circle, CORNERS)->fill_opacity = 0.6;
    scene_add_line(d->scene, ROLE_FURNITURE_LINE, MIDDLE, circle, CORNERS + 1)->style = LINE_DASHED;
}

/* Returns the middle of the bearing block, behind the crank, displaced by `by` m. */
static Vec2 block_at(const Drawing *d, const double *by) {
    const Tree *tree = d->tree;
    double at[3], back = 1.2 * d->scale->unit;
    for (size_t i = 0; i < 3; i++)
        at[i] = tree->axis[i] + by[i];
    at[0] -= back * tree->tilt_cosine;
    at[1] -= back * tree->tilt_sine;
    return seen(at);
}

static void add_grounds(const Drawing *d) {
    double unit = d->scale->unit;
    const double rest[3] = {0, 0, 0};
    Vec2 block = block_at(d, rest);
    machine_pieces_ground(d->scene, vec2(block.x - 0.5 * unit, block.y - 1.1 * unit),
                          vec2(block.x + 0.5 * unit, block.y - 1.1 * unit), -unit / 8);
    add_name(d, vec2(block.x, block.y - 1.52 * unit), "bearing block");
}

/* The mechanism, moving -------------------------------------------------------------------------------------------- */

static void add_block(const Drawing *d, const double *shift) {
    double unit = d->scale->unit, half = unit / 4;
    const double rest[3] = {0, 0, 0};
    Vec2 block = block_at(d, shift), foot = block_at(d, rest);
    for (int side = -1; side <= 1; side += 2)
        machine_pieces_spring(d->scene, vec2(foot.x + side * 0.3 * unit, foot.y - 1.1 * unit),
                              vec2(block.x + side * 0.2 * unit, block.y - half), 0.09 * unit);
    machine_pieces_block(d->scene, ROLE_WALL,
                         (Box){vec2(block.x - half, block.y - half), vec2(block.x + half, block.y + half)});
}

/* Adds the axle and the arm to the pin. */
static void add_crank(const Drawing *d, const TreePose *pose, const double *shift) {
    double axle[3], pin[3];
    for (size_t i = 0; i < 3; i++) {
        axle[i] = d->tree->axis[i] + shift[i];
        pin[i] = pose->pin.at[i] + shift[i];
    }
    Vec2 back = block_at(d, shift), at = seen(pin);
    scene_add_line(d->scene, ROLE_WALL, THICK, (Vec2[]){back, seen(axle)}, 2);
    add_segment(d->scene, ROLE_WALL, THICK, axle, pin);
    scene_add_discs(d->scene, ROLE_DOOR, d->scale->unit / 8, &at, 1);
}

/* Adds the bent coupler from the slider to the ball, which sits in the pin, and its chord. */
static void add_coupler(const Drawing *d, const TreePose *pose, const double *state, const double *shift) {
    const Tree *tree = d->tree;
    const double *eta = state + 3 + tree->axial, *zeta = eta + tree->bending;
    double foot[3] = {state[0], 0, 0}, end[3], way[3];
    for (size_t i = 0; i < 3; i++) {
        end[i] = pose->pin.at[i] + shift[i];
        way[i] = end[i] - foot[i];
    }
    Vec2 line[BENDS + 1];
    for (size_t k = 0; k <= BENDS; k++) {
        double part = (double)k / BENDS, across = 0, up = 0, at[3];
        for (size_t n = 0; n < tree->bending; n++) {
            double shape = real_sincos((double)(n + 1) * M_PI * part).sine;
            across += eta[n] * shape;
            up += zeta[n] * shape;
        }
        for (size_t i = 0; i < 3; i++)
            at[i] = foot[i] + part * way[i] + d->scale->bend * (across * pose->across[i] + up * pose->up[i]);
        line[k] = seen(at);
    }
    add_segment(d->scene, ROLE_DIM_TEXT, THIN, foot, end);
    d->scene->primitives[d->scene->count - 1].style = LINE_DASHED;
    scene_add_line(d->scene, ROLE_CHAIR, THICK, line, BENDS + 1);
    double size = d->scale->unit / 3;
    machine_pieces_block(d->scene, ROLE_CHAIR, (Box){vec2(foot[0] - size, -size), vec2(foot[0] + size, size / 3)});
    scene_add_discs(d->scene, ROLE_WALL, size / 5, &line[0], 1);
    scene_add_discs(d->scene, ROLE_DANGER_LOW, d->scale->unit / 12, &line[BENDS], 1);
}

/* Adds the force on the ball: from the wall towards the middle of the socket. */
static void add_force(const Drawing *d, const TreePose *pose, const CrankMoment *moment, const double *shift) {
    double distance =
        sqrt(pose->apart[0] * pose->apart[0] + pose->apart[1] * pose->apart[1] + pose->apart[2] * pose->apart[2]);
    if (!(moment->force > 0) || !(distance > 0) || !(d->scale->parts & CRANK_SCENE_FORCES))
        return;
    double at[3], tip[3], length = ARROW * d->scale->unit * moment->force / d->scale->largest;
    for (size_t i = 0; i < 3; i++) {
        at[i] = pose->pin.at[i] + shift[i];
        tip[i] = at[i] - length * pose->apart[i] / distance;
    }
    machine_pieces_arrow(d->scene, ROLE_IMPACT, seen(at), seen(tip), d->scale->unit / 40);
}

/* The loupe -------------------------------------------------------------------------------------------------------- */

static Vec2 through_loupe(const Drawing *d, double along, double across, double up) {
    CrankSight sight = d->scale->sight;
    double x = sight == CRANK_SIGHT_ALONG ? across : along, y = sight == CRANK_SIGHT_ABOVE ? across : up;
    double distance = real_hypot(real_hypot(along, across), up), clearance = d->tree->clearance;
    double factor = d->scale->loupe / clearance;
    if (distance > clearance) /* the overlap is magnified further */
        factor *= (clearance + CRANK_SCENE_OVERLAP * (distance - clearance)) / distance;
    /* After the clearance was made smaller the path before that may lie far outside. */
    if (factor * distance > OUTERMOST * d->scale->loupe)
        factor = OUTERMOST * d->scale->loupe / distance;
    return vec2(d->scale->socket.x + factor * x, d->scale->socket.y + factor * y);
}

const char *const crank_scene_sights[CRANK_SIGHTS] = {"from the side", "along the coupler", "from above"};

static void add_loupe_still(const Drawing *d) {
    const CrankScale *scale = d->scale;
    add_ring(d->scene, ROLE_FURNITURE_LINE, MIDDLE, LINE_SOLID, scale->socket, scale->loupe);
    add_name(d, vec2(scale->socket.x, scale->socket.y - 1.38 * scale->loupe),
             scene_text(d->scene, "clearance %g mm, overlap x %g", MILLI * d->tree->clearance, CRANK_SCENE_OVERLAP));
    add_name_with_room(d, vec2(scale->socket.x, scale->socket.y - 1.17 * scale->loupe),
                       scene_text(d->scene, "seen %s", crank_scene_sights[scale->sight]));
    add_name_with_room(d, vec2(scale->socket.x, scale->socket.y + TITLE * scale->loupe), "ball in its socket");
}

/* Returns the colour of a share of the largest force. */
static Role role_of(double share) {
    return share > 0.5 ? ROLE_DANGER_HIGH : share > 0.2 ? ROLE_DANGER_MIDDLE : ROLE_DANGER_LOW;
}

/* Returns the share of the largest force with which the wall's spring presses a place of the path; 0: no contact. */
static double press_of(const Drawing *d, const CrankMoment *moment, size_t i) {
    double distance = real_hypot(real_hypot(moment->along[i], moment->across[i]), moment->up[i]);
    return real_max(0, d->tree->stiffness * (distance - d->tree->clearance) / d->scale->largest);
}

/* Adds the arcs of the wall that the ball pressed along its path, each in the colour of its force. Where the ball
 * presses the wall in front of the picture or behind it, there is none. */
static void add_pressed(const Drawing *d, const CrankMoment *moment, const Vec2 *path) {
    Vec2 middle = d->scale->socket, *arc = arena_allocate(&d->scene->arena, (moment->path_count + 1) * sizeof *arc);
    size_t points = 0;
    Role role = ROLE_DANGER_LOW;
    for (size_t i = 0; i <= moment->path_count; i++) {
        bool at_wall = i < moment->path_count && vec2_distance(path[i], middle) > AT_WALL * d->scale->loupe;
        double press = at_wall ? press_of(d, moment, i) : 0;
        if (press > 0)
            arc[points++] = on_ring(middle, d->scale->loupe, atan2(path[i].y - middle.y, path[i].x - middle.x));
        if (points > 1 && (!(press > 0) || role_of(press) != role)) {
            scene_add_line(d->scene, role, THICK, arc, points);
            arc[0] = arc[points - 1];
            points = 1;
        }
        points = press > 0 ? points : 0;
        role = role_of(press);
    }
}

/* Adds the arc of the wall that the ball presses, wider under a larger force. */
static void add_arc(const Drawing *d, Vec2 ball, double force) {
    Vec2 middle = d->scale->socket, points[ARC + 1];
    double angle = atan2(ball.y - middle.y, ball.x - middle.x), share = real_min(1, force / d->scale->largest);
    for (int i = 0; i <= ARC; i++)
        points[i] = on_ring(middle, d->scale->loupe, angle + ARC_HALF * (2.0 * i / ARC - 1));
    scene_add_line(d->scene, role_of(share), THICK + 2 * THICK * share, points, ARC + 1);
}

static void add_loupe(const Drawing *d, const CrankMoment *moment) {
    size_t count = moment->path_count;
    if (!(d->scale->parts & CRANK_SCENE_LOUPE) || d->tree->clearance <= 0 || !count)
        return;
    Vec2 *path = arena_allocate(&d->scene->arena, (count + 1) * sizeof *path);
    for (size_t i = 0; i < count; i++)
        path[i] = through_loupe(d, moment->along[i], moment->across[i], moment->up[i]);
    add_pressed(d, moment, path);
    if (moment->force > 0 && vec2_distance(path[count - 1], d->scale->socket) > AT_WALL * d->scale->loupe)
        add_arc(d, path[count - 1], moment->force);
    scene_add_line(d->scene, ROLE_LOCUS, THIN, path, count);
    scene_add_discs(d->scene, ROLE_DANGER_MIDDLE, d->scale->loupe / 14, &path[count - 1], 1);
}

/* The polar diagram ------------------------------------------------------------------------------------------------ */

/* The angle is the crank's, as in the picture: 0 upwards, and the way round that the pin is seen to go. */
static Vec2 polar_at(const Drawing *d, double angle, double force) {
    SineCosine turn = real_sincos(angle);
    double out = d->scale->reach * force / d->scale->largest;
    return vec2(d->scale->polar.x - out * turn.sine, d->scale->polar.y + out * turn.cosine);
}

/* A name next to the ring, which a small picture leaves out. */
static Primitive *add_name_outside(const Drawing *d, double angle, const char *text) {
    Vec2 at = polar_at(d, angle, d->scale->largest), beyond = polar_at(d, angle, 2 * d->scale->largest);
    Primitive *label = scene_add_label(d->scene, ROLE_TEXT, NAME, at, text);
    scene_bind_label(d->scene, label, &beyond, 1);
    label->fixed = label->optional = true;
    return label;
}

static void add_polar_still(const Drawing *d) {
    const CrankScale *scale = d->scale;
    static const char *const names[] = {"0\u00b0", "90\u00b0", "180\u00b0", "270\u00b0"};
    for (int ring = 1; ring <= 2; ring++)
        add_ring(d->scene, ROLE_ROOM, THIN, ring == 2 ? LINE_SOLID : LINE_DOTTED, scale->polar,
                 scale->reach * ring / 2);
    for (int i = 0; i < 4; i++) {
        Vec2 out = polar_at(d, i * M_PI / 2, scale->largest);
        scene_add_line(d->scene, ROLE_ROOM, THIN, (Vec2[]){scale->polar, out}, 2)->style = LINE_DOTTED;
    }
    if (!(scale->parts & CRANK_SCENE_NAMES))
        return;
    add_name_outside(d, M_PI / 4, scene_text(d->scene, "%g N", scale->largest))->optional = false;
    for (int i = 0; i < 4; i++)
        add_name_outside(d, i * M_PI / 2, names[i]);
    add_name_with_room(d, vec2(scale->polar.x, scale->polar.y - 1.7 * scale->reach), "force over the crank angle");
}

static void add_polar(const Drawing *d, const CrankMoment *moment) {
    size_t count = moment->force_count, present = moment->present < count ? moment->present : 0;
    if (!(d->scale->parts & CRANK_SCENE_POLAR) || !count)
        return;
    Vec2 *curve = arena_allocate(&d->scene->arena, (count + 1) * sizeof *curve);
    for (size_t i = 0; i < count; i++)
        curve[i] = polar_at(d, moment->angle[i], moment->forces[i]);
    if (present)
        scene_add_line(d->scene, ROLE_LOCUS_SECOND, THIN / 2, curve, present);
    scene_add_line(d->scene, ROLE_LOCUS, MIDDLE, curve + present, count - present);
    scene_add_discs(d->scene, ROLE_DANGER_MIDDLE, d->scale->reach / 22, &curve[count - 1], 1);
}

/* The whole -------------------------------------------------------------------------------------------------------- */

void crank_scene_still(Scene *scene, const Crank *crank, const Tree *tree, const CrankScale *scale) {
    Drawing d = {scene, tree, scale};
    const char *text = scale->bend > 1 ? scene_text(scene, "bending and support x %g", scale->bend) : "true to scale";
    add_name(&d, vec2(scale->place, -1.1 * scale->unit), text);
    add_guide(&d);
    add_disc(&d);
    add_grounds(&d);
    if (scale->parts & CRANK_SCENE_LOUPE && crank->clearance > 0)
        add_loupe_still(&d);
    if (scale->parts & CRANK_SCENE_POLAR)
        add_polar_still(&d);
    add_name_with_room(&d, vec2(scale->place, -0.75 * scale->unit), "guide and slider");
}

void crank_scene_moving(Scene *scene, const Tree *tree, const CrankScale *scale, const CrankMoment *moment) {
    Drawing d = {scene, tree, scale};
    TreePose pose = tree_pose(tree, moment->time, moment->state);
    const double *u = moment->state + tree->rod;
    const double shift[3] = {scale->bend * u[0], scale->bend * u[1], scale->bend * u[2]};
    add_block(&d, shift);
    add_crank(&d, &pose, shift);
    add_coupler(&d, &pose, moment->state, shift);
    add_force(&d, &pose, moment, shift);
    add_loupe(&d, moment);
    add_polar(&d, moment);
}

/* A recorded moment ------------------------------------------------------------------------------------------------ */

static size_t hardest(const Trace *trace) {
    size_t most = TURNS_SHOWN * CRANK_SAMPLES, found = trace->rows < most ? 0 : trace->rows - most;
    for (size_t i = found; i < trace->rows; i++)
        if (trace_row(trace, i)[CRANK_FORCE] > trace_row(trace, found)[CRANK_FORCE])
            found = i;
    return found;
}

/* Simulates a revolution again from its recorded beginning, to a row of the trace; `reach`: the largest displacement
 * until then. */
static Turn turn_at(const Tree *tree, const Response *response, size_t row, double *reach) {
    size_t cycle = row / CRANK_SAMPLES, states = response->section.states;
    double until = trace_row(&response->trace, row)[CRANK_ANGLE] * M_PI / 180;
    Turn turn = turn_create(tree, TURN_FINE);
    crank_cycle_set_state(&turn, cycle ? response->section.state + (cycle - 1) * states : response->start);
    size_t begun = turn.cycle;
    turn.unwatched = true;
    *reach = 0;
    while (turn.status == CYCLE_GOOD && turn.cycle == begun) {
        TreePose pose = turn_pose(&turn);
        double left = (until - pose.theta) / pose.theta_rate;
        *reach = real_max(*reach, crank_scene_reach(tree, turn.state));
        if (left <= 1e-9)
            break;
        turn_step(&turn, left);
    }
    return turn;
}

void crank_scene_labels(Scene *scene, const Crank *crank, const Response *response, size_t at) {
    const double *row = trace_row(&response->trace, at);
    const SectionPeaks *peaks = &response->peaks;
    const char *verdict = response->verdict == RESPONSE_PERIODIC
                              ? scene_text(scene, "periodic, period %zu", response->orbit.period)
                              : response_name(response);
    scene->title =
        scene_text(scene, "%.4g rpm, clearance %g mm: %s", 60 * crank->frequency, MILLI * crank->clearance, verdict);
    scene->title_role = ROLE_TEXT;
    scene->detail = peaks->max - peaks->min < 0.5
                        ? scene_text(scene, "largest force %.1f N", peaks->max)
                        : scene_text(scene, "largest forces %.0f to %.0f N a revolution", peaks->min, peaks->max);
    scene->name = crank->name;
    scene->note = crank_is_assumed(crank) ? "Every number of this mechanism is assumed." : "";
    scene->clock = scene_text(scene, "%.0f deg, %.0f N", row[CRANK_ANGLE], row[CRANK_FORCE]);
    scene->unscaled = true;
}

/* Copies the rows up to this one, of the last `turns` revolutions. */
static size_t copy_rows(Scene *scene, const Trace *trace, size_t row, size_t turns, size_t column, double factor,
                        const double **values) {
    size_t most = turns * CRANK_SAMPLES, count = row + 1 < most ? row + 1 : most;
    double *copy = arena_allocate(&scene->arena, count * sizeof *copy);
    for (size_t i = 0; i < count; i++)
        copy[i] = factor * trace_row(trace, row + 1 - count + i)[column];
    *values = copy;
    return count;
}

CrankMoment crank_scene_moment(Scene *scene, const Tree *tree, const Response *response, size_t row, Turn *turn,
                               double *reach) {
    const Trace *trace = &response->trace;
    *turn = turn_at(tree, response, row, reach);
    CrankMoment moment = {.time = turn->time, .state = turn->state, .force = trace_row(trace, row)[CRANK_FORCE]};
    copy_rows(scene, trace, row, PATH_TURNS, CRANK_ALONG, 1, &moment.along);
    copy_rows(scene, trace, row, PATH_TURNS, CRANK_ACROSS, 1, &moment.across);
    moment.path_count = copy_rows(scene, trace, row, PATH_TURNS, CRANK_UP, 1, &moment.up);
    copy_rows(scene, trace, row, TURNS_SHOWN, CRANK_ANGLE, M_PI / 180, &moment.angle);
    moment.force_count = copy_rows(scene, trace, row, TURNS_SHOWN, CRANK_FORCE, 1, &moment.forces);
    if (moment.force_count > CRANK_SAMPLES) /* the last whole revolution is thick */
        moment.present = moment.force_count - CRANK_SAMPLES;
    return moment;
}

void crank_scene_make_at(Scene *scene, const Crank *crank, const Tree *tree, const Response *response, size_t row) {
    double reach;
    Turn turn;
    CrankMoment moment = crank_scene_moment(scene, tree, response, row, &turn, &reach);
    CrankScale scale = crank_scene_scale(crank, tree, reach, response->peaks.max);
    crank_scene_still(scene, crank, tree, &scale);
    crank_scene_moving(scene, tree, &scale, &moment);
    scene->box = scale.box;
    crank_scene_labels(scene, crank, response, row);
}

void crank_scene_make(Scene *scene, const Crank *crank, const Tree *tree, const Response *response) {
    crank_scene_make_at(scene, crank, tree, response, hardest(&response->trace));
}
