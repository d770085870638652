#include "visual/beam/beam_scene.h"

#include "visual/beam/beam_joint.h"
#include "visual/machine/pieces.h"
#include "visual/beam/beam_text.h"

/* Positions and sizes, in beam lengths. */
#define THINNEST 0.008    /* half of the thickness, as drawn, at least: thinner beams would be invisible */
#define THICKEST 0.03     /* the same, at most */
#define RISE 0.115        /* the largest deflection, magnified, at most */
#define TIP_RISE 0.105    /* the same of the tip */
#define FLOOR -0.175      /* of pivot and shaker */
#define ROW 0.031         /* from one row of text to the next */
#define BEFORE 0.11       /* of the picture, in front of the beam */
#define BEHIND 0.66       /* the tip, with the loupe */
#define BEHIND_ALONE 0.15 /* behind the beam without a loupe */
#define HIGH 0.195        /* of the picture, above the beam */
#define LOW -0.195        /* below the beam */
#define MAGNIFIED_AT 0.0  /* of the note about the magnification */
#define NAME_BELOW 1.05   /* of ROW, of the names below the drawing and its frame */
#define REST_BEFORE 0.04  /* from the beginning of the rest line to the beam */
#define PIVOT_GROUND 0.030
#define PIVOT_SPRING 0.016
#define PIVOT_SPIRAL 0.030
#define PIVOT_PIN 0.007
#define YOKE_HALF 0.045
#define YOKE_DEPTH 0.013
#define YOKE_TOP -0.060
#define COIL_HALF 0.030
#define COIL_DEPTH 0.040
#define SUSPENSION 0.011
#define DASHPOT 0.008
#define SUSPENSION_ASIDE 0.013 /* of the spring from the middle if a dashpot stands on the other side */
#define NEAR 0.16              /* least distance between pivot and shaker: nearer pivots stand above */
#define PIVOT_BEFORE 0.07      /* of the pivot's text from the end of the beam */
#define PIVOT_BESIDE 0.03      /* of the end of the pivot's text elsewhere */
#define PIVOT_BEHIND 0.20      /* of the pivot's text when shaker and pivot both are at the end */
#define DRIVE_MOST 0.085
#define DRIVE_LABEL 0.175
#define DRIVE_ASIDE 0.06 /* of the pivot's text when the pivot is above */
#define SHAFT_HALF 0.008
#define BALL_MORE 1.25 /* 1, of the half thickness */
#define STOP_HALF 0.022
#define STOP_ROOM 0.031  /* behind the tip at its deepest: the stop, and its compressed spring */
#define LOUPE_RIM 0.003  /* above and below the tip */
#define LOUPE_LEFT 0.135 /* behind the tip */
#define LOUPE_RIGHT 0.65
#define LOUPE_TIP 0.225
#define LOUPE_BALL 0.034
#define LOUPE_GROUND 0.170
#define LOUPE_STOP 0.036
#define LOUPE_SEEN 0.035 /* the displayed part of the beam, on either side of the tip */

/* Design points. */
#define PANELS_HEIGHT 290.0
#define NAME_TEXT 17.0
#define SMALL_TEXT 16.0
#define EDGE 1.5
#define THIN 1.5
#define ROD_WIDTH 4.0
#define PIN_EDGE 2.0

#define ROUNDING 1e-12 /* 1: values within this factor of a round number count as round */
#define STOPS_AWAY 4.0 /* times the reach: farther stops would leave the beam too small to see */

/* Returns the largest round number up to a value: 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten. */
static double round_down(double value) {
    static const double steps[] = {8, 6, 5, 4, 3, 2.5, 2, 1.5, 1};
    double power = pow(10, floor(log10(value) + ROUNDING));
    size_t i = 0;
    while (i + 1 < sizeof steps / sizeof *steps && steps[i] * power > value * (1 + ROUNDING))
        i++;
    return steps[i] * power;
}

/* Returns the factor that magnifies `reach` m to this share of the beam's length. */
static double factor_of(const Beam *beam, double rise, double reach) {
    return reach > 0 ? round_down(rise * beam->length / reach) : HUGE_VAL;
}

/* Returns the joint at the beam, or in the loupe. */
static BeamJoint joint_of(const Beam *beam, const BeamScale *scale, double reach, double tip_reach, bool loupe) {
    double length = beam->length, seen = scale->stops ? fmax(tip_reach, beam->clearance) : tip_reach;
    double factor = fmin(factor_of(beam, TIP_RISE, seen), loupe ? HUGE_VAL : factor_of(beam, RISE, reach));
    BeamJoint joint = {.middle = vec2((1 + (loupe ? LOUPE_TIP : 0)) * length, 0),
                       .factor = isfinite(factor) ? factor : 1,
                       .ball = loupe ? LOUPE_BALL * length : BALL_MORE * scale->half,
                       .half = (loupe ? LOUPE_STOP : STOP_HALF) * length,
                       .loupe = loupe};
    joint.ground = loupe ? LOUPE_GROUND * length : joint.ball + joint.factor * seen + STOP_ROOM * length;
    return joint;
}

BeamScale beam_scene_scale(const Beam *beam, double reach, double tip_reach) {
    BeamScale scale = {.parts = BEAM_SCENE_ALL, .length = beam->length};
    double half = beam->thickness / 2;
    scale.half = fmax(THINNEST * beam->length, fmin(half, THICKEST * beam->length));
    scale.to_scale = scale.half == half;
    scale.stops = beam->clearance <= STOPS_AWAY * tip_reach || tip_reach == 0;
    scale.joint[0] = joint_of(beam, &scale, reach, tip_reach, false);
    scale.joint[1] = joint_of(beam, &scale, reach, tip_reach, true);
    scale.loupe = (Box){{(1 + LOUPE_LEFT) * beam->length, (LOW + LOUPE_RIM) * beam->length},
                        {(1 + LOUPE_RIGHT) * beam->length, (HIGH - LOUPE_RIM) * beam->length}};
    return scale;
}

static size_t joint_count(const BeamScale *scale) {
    return scale->parts & BEAM_SCENE_LOUPE ? BEAM_JOINTS : 1;
}

Box beam_scene_box(const BeamScale *scale, bool alone) {
    double behind = scale->parts & BEAM_SCENE_LOUPE ? BEHIND : BEHIND_ALONE, length = scale->length;
    double text = (!alone ? 0.6 : scale->parts & BEAM_SCENE_SOURCES ? 2.4 : 1.4) * ROW;
    return (Box){{-BEFORE * length, (LOW - text) * length}, {(1 + behind) * length, HIGH * length}};
}

void beam_scene_labels(Scene *scene, const Beam *beam, const Rig *rig, const Response *response, const BeamScale *scale,
                       double slow) {
    bool resolved = response_is_told(response->verdict);
    scene->box = beam_scene_box(scale, false);
    scene->panel_height = PANELS_HEIGHT;
    scene->unscaled = true;
    scene->title = beam_text_title(scene, beam, rig, response);
    scene->title_role = resolved ? ROLE_TEXT : ROLE_ERROR;
    scene->detail = beam_text_detail(scene, response);
    scene->name = scene_text(scene, "%s, %g mm long: deflection \u00d7 %.9g, in the loupe \u00d7 %.9g", beam->name,
                             1000 * scale->length, scale->joint[0].factor, scale->joint[1].factor);
    const char *moment = response->peaks.count ? "at the largest force" : "at the largest deflection";
    const char *slower = slow > 0 ? scene_text(scene, "%g times slower", slow) : moment;
    scene->note = scene_text(scene, scale->to_scale ? "%s; thickness to scale, %s" : "%s; thickness not to scale, %s",
                             slower, beam_text_provenance(scene, beam, "beam.thickness"));
}

/* Adds rows of text to one side of a place, downwards; the name of a part is bold, its numbers are not. */
static void add_rows(Scene *scene, const BeamScale *scale, Vec2 at, int side, const char *const *rows, size_t count,
                     bool note) {
    size_t shown = !(scale->parts & BEAM_SCENE_NAMES) ? 0 : scale->parts & BEAM_SCENE_SOURCES ? count : 1;
    for (size_t i = 0; i < shown; i++) {
        Vec2 from = vec2(at.x, at.y - ROW * scale->length * (double)i), to = vec2(from.x + side, from.y);
        Primitive *label =
            scene_add_label(scene, i ? ROLE_DIM_TEXT : ROLE_TEXT, i ? SMALL_TEXT : NAME_TEXT, from, rows[i]);
        if (side)
            scene_bind_label(scene, label, &to, 1);
        label->bold = i == 0;
        label->note = note;
        label->fixed = label->optional = true; /* a small picture has no room for it */
        if (scale->parts & BEAM_SCENE_LOUPE)
            label->apart = scale->loupe;
    }
}

/* True if the pivot is so near to the shaker that it must stand above. */
static double pivot_side(const Beam *beam) {
    return fabs(beam->pivot_position - beam->shaker_position) < NEAR * beam->length ? 1 : -1;
}

/* Adds ground under (or over) a part, a thick line with hatches behind it. */
static void add_ground(Scene *scene, const BeamScale *scale, Vec2 middle, double half, double up) {
    machine_pieces_ground(scene, vec2(middle.x - half * scale->length, middle.y),
                          vec2(middle.x + half * scale->length, middle.y), up * BEAM_JOINT_GROUND * scale->length);
}

static void still_pivot(Scene *scene, const Beam *beam, const BeamScale *scale) {
    double length = scale->length, side = pivot_side(beam);
    Vec2 foot = vec2(beam->pivot_position, side * -FLOOR * length);
    const char *rows[] = {"flexure pivot",
                          scene_text(scene, "%s, %s", beam_text_quantity(scene, beam->pivot_stiffness, "N/m"),
                                     beam_text_quantity(scene, beam->pivot_rotational, "N m/rad")),
                          beam_text_provenance(scene, beam, "pivot.translational_stiffness")};
    if (beam->pivot_stiffness > 0)
        add_ground(scene, scale, foot, PIVOT_GROUND, side);
    bool left = beam->pivot_position > length / 4;
    double beside = side < 0 && !left ? -PIVOT_BEFORE : left ? -PIVOT_BESIDE : PIVOT_BEHIND;
    Vec2 text = vec2(beam->pivot_position + beside * length, (HIGH - ROW / 2) * length);
    add_rows(scene, scale, text, left ? -1 : 1, rows, 3, false);
}

static void still_shaker(Scene *scene, const Beam *beam, const BeamScale *scale) {
    double length = scale->length, x = beam->shaker_position, bottom = FLOOR * length;
    const char *mass = beam->shaker_mass > 0 ? beam_text_quantity(scene, beam->shaker_mass, "kg") : "no mass";
    const char *rows[] = {scene_text(scene, "shaker: %s", beam_text_quantity(scene, beam->force, "N")),
                          scene_text(scene, "%s, %s; %s", mass,
                                     beam_text_quantity(scene, beam->shaker_stiffness, "N/m"),
                                     beam_text_provenance(scene, beam, "drive.force"))};
    add_ground(scene, scale, vec2(x, bottom), YOKE_HALF + YOKE_DEPTH, -1);
    for (int side = -1; side <= 1; side += 2)
        machine_pieces_block(scene, ROLE_FURNITURE,
                             box_include(box_around(vec2(x + side * YOKE_HALF * length, bottom), 0),
                                         vec2(x + side * (YOKE_HALF + YOKE_DEPTH) * length, YOKE_TOP * length)));
    int way = x > 0.6 * length ? -1 : 1;
    add_rows(scene, scale, vec2(x + way * (YOKE_HALF + YOKE_DEPTH) * length, (LOW + 1.4 * ROW) * length), way, rows, 2,
             false);
}

static void still_joint(Scene *scene, const Beam *beam, const BeamScale *scale) {
    double length = scale->length;
    const char *rows[] = {scene_text(scene, "stops: %s, %s",
                                     beam_text_quantity(scene, beam->contact.normal_stiffness, "N/m"),
                                     beam_text_quantity(scene, beam->contact.normal_damping, "N s/m")),
                          beam_text_provenance(scene, beam, "joint.stiffness")};
    if (!scale->stops)
        rows[0] = scene_text(scene, "stops: outside the picture, at \u00b1%.4g mm", 1000 * beam->clearance);
    for (size_t i = 0; i < joint_count(scale) && scale->stops; i++)
        beam_joint_still(scene, beam, scale, &scale->joint[i]);
    if (scale->parts & BEAM_SCENE_LOUPE)
        add_rows(scene, scale, vec2((1 + LOUPE_LEFT) * length, (LOW - NAME_BELOW * ROW) * length), 1, rows, 2, true);
}

static Primitive *add_frame(Scene *scene, Box box) {
    Primitive *frame = machine_pieces_block(scene, ROLE_PANEL, box);
    frame->edge = ROLE_ROOM;
    return frame;
}

/* Adds the loupe and its content. */
static void still_loupe(Scene *scene, const BeamScale *scale) {
    double length = scale->length;
    Box loupe = scale->loupe;
    double high = scale->joint[0].ground + BEAM_JOINT_GROUND * length;
    Box seen = {{(1 - LOUPE_SEEN) * length, -high}, {(1 + LOUPE_SEEN) * length, high}};
    add_frame(scene, loupe)->fill = ROLE_PAPER;
    add_frame(scene, seen)->fill_opacity = 0;
    for (int side = 0; side < 2; side++) {
        Vec2 ends[] = {{seen.high.x, side ? seen.high.y : seen.low.y},
                       {loupe.low.x, side ? loupe.high.y : loupe.low.y}};
        scene_add_line(scene, ROLE_ROOM, EDGE, ends, 2);
    }
}

static void add_rest(Scene *scene, double from, double to) {
    scene_add_line(scene, ROLE_ROOM, THIN, (Vec2[]){{from, 0}, {to, 0}}, 2)->style = LINE_DASH_DOT;
}

void beam_scene_still(Scene *scene, const Beam *beam, const BeamScale *scale) {
    double length = scale->length;
    add_rest(scene, -REST_BEFORE * length, (1 + LOUPE_SEEN) * length);
    if (scale->parts & BEAM_SCENE_LOUPE) {
        still_loupe(scene, scale);
        add_rest(scene, (1 + LOUPE_LEFT) * length, (1 + LOUPE_RIGHT) * length);
    }
    still_pivot(scene, beam, scale);
    still_shaker(scene, beam, scale);
    still_joint(scene, beam, scale);
}

void beam_scene_magnified(Scene *scene, const BeamScale *scale) {
    double length = scale->length, below = (LOW - NAME_BELOW * ROW) * length;
    const char *all = scene_text(scene, "deflection magnified %.9g times", scale->joint[0].factor), *brief = all;
    if (scale->parts & BEAM_SCENE_LOUPE) {
        brief = scene_text(scene, "beam \u00d7%.9g, loupe \u00d7%.9g", scale->joint[0].factor, scale->joint[1].factor);
        all = scene_text(scene, "%s, in the loupe %.9g times", all, scale->joint[1].factor);
    }
    Vec2 first = vec2(MAGNIFIED_AT * length, below), left = vec2(-BEFORE * length, below);
    Vec2 places[] = {first, vec2(first.x + 1, below), left, vec2(left.x + 1, below)};
    Primitive *label = scene_add_label(scene, ROLE_DIM_TEXT, SMALL_TEXT, first, all);
    scene_bind_label(scene, label, places, sizeof places / sizeof *places);
    label->fixed = label->optional = label->note = true;
    label->brief = brief;
    label->apart = scale->loupe;
}

/* Moving parts ----------------------------------------------------------------------------------------------------- */

static double drawn_at(const BeamScale *scale, const BeamShape *shape, double place) {
    return scale->joint[0].factor * beam_shape_at(shape, place);
}

static void add_pivot(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamShape *shape) {
    double side = pivot_side(beam), length = scale->length;
    Vec2 at = vec2(beam->pivot_position, drawn_at(scale, shape, beam->pivot_position));
    if (beam->pivot_stiffness > 0)
        machine_pieces_spring(scene, vec2(at.x, at.y + side * scale->half), vec2(at.x, side * -FLOOR * length),
                              PIVOT_SPRING * length);
    if (beam->pivot_rotational > 0)
        machine_pieces_spiral(scene, at, PIVOT_SPIRAL * length);
    Primitive *pin = scene_add_discs(scene, ROLE_PAPER, PIVOT_PIN * length, &at, 1);
    pin->edge = ROLE_WALL;
    pin->width = PIN_EDGE;
}

/* Adds the armature, which hangs on the beam, and its suspension, which stands on the floor. */
static void add_shaker(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamShape *shape) {
    double length = scale->length, x = beam->shaker_position, floor = FLOOR * length;
    double top = drawn_at(scale, shape, x) - scale->half, bottom = top - COIL_DEPTH * length;
    bool heavy = beam->shaker_mass > 0, damped = beam->shaker_damping > 0;
    double aside = damped ? SUSPENSION_ASIDE * length : 0;
    Vec2 rod[] = {{x, top}, {x, heavy ? top : bottom}};
    scene_add_line(scene, ROLE_WALL, ROD_WIDTH, rod, 2);
    if (beam->shaker_stiffness > 0)
        machine_pieces_spring(scene, vec2(x - aside, bottom), vec2(x - aside, floor), SUSPENSION * length);
    if (damped)
        machine_pieces_dashpot(scene, vec2(x + aside, bottom), vec2(x + aside, floor), DASHPOT * length);
    if (heavy) {
        Primitive *coil = machine_pieces_block(scene, ROLE_DOOR,
                                               (Box){{x - COIL_HALF * length, bottom}, {x + COIL_HALF * length, top}});
        coil->fill = ROLE_PAPER;
        coil->edge = ROLE_DOOR;
        coil->hatched = true;
    }
}

static void add_beam(Scene *scene, const BeamScale *scale, const BeamShape *shape) {
    size_t count = shape->count;
    Vec2 *outline = arena_allocate(&scene->arena, 2 * count * sizeof *outline);
    for (size_t i = 0; i < count; i++) {
        double y = scale->joint[0].factor * shape->deflection[i];
        outline[i] = vec2(shape->place[i], y + scale->half);
        outline[2 * count - 1 - i] = vec2(shape->place[i], y - scale->half);
    }
    Primitive *beam = scene_add_polygon(scene, ROLE_WALKER, outline, 2 * count);
    beam->edge = ROLE_WALL;
    beam->width = EDGE;
}

/* Adds the ball of the tip; in the loupe with the beam's end. */
static void add_tip(Scene *scene, const BeamScale *scale, const BeamJoint *joint, double deflection) {
    Vec2 tip = beam_joint_tip(joint, deflection);
    if (joint->loupe) {
        double half = joint->ball / BALL_MORE;
        machine_pieces_block(scene, ROLE_WALKER,
                             (Box){{(1 + LOUPE_LEFT) * scale->length, tip.y - half}, {tip.x, tip.y + half}});
    }
    Primitive *ball = scene_add_discs(scene, ROLE_WALKER, joint->ball, &tip, 1);
    ball->edge = ROLE_WALL;
    ball->width = EDGE;
}

/* Adds the shaker's force, above the beam: it pulls up or presses down. */
static void add_drive(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamShape *shape, double drive) {
    double length = scale->length, x = beam->shaker_position + (pivot_side(beam) > 0 ? DRIVE_ASIDE * length : 0);
    if (beam->force <= 0)
        return;
    Vec2 low = vec2(x, drawn_at(scale, shape, beam->shaker_position) + scale->half);
    Vec2 high = vec2(x, low.y + DRIVE_MOST * length * fabs(drive) / beam->force);
    machine_pieces_arrow(scene, ROLE_LOCUS_SECOND, drive > 0 ? low : high, drive > 0 ? high : low, SHAFT_HALF * length);
    Primitive *label = scene_add_label(scene, ROLE_LOCUS_SECOND, NAME_TEXT, vec2(x, DRIVE_LABEL * length),
                                       beam_text_signed_newtons(scene, drive, beam->force));
    Vec2 right = vec2(x + length, DRIVE_LABEL * length);
    scene_bind_label(scene, label, &right, 1);
    label->fixed = label->bold = label->optional = true;
}

void beam_scene_moving(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamShape *shape,
                       const BeamMoment *moment) {
    double tip = shape->deflection[shape->count - 1];
    add_shaker(scene, beam, scale, shape);
    for (size_t i = 0; i < joint_count(scale) && scale->stops; i++)
        beam_joint_stops(scene, beam, scale, &scale->joint[i], tip);
    add_beam(scene, scale, shape);
    for (size_t i = 0; i < joint_count(scale); i++)
        add_tip(scene, scale, &scale->joint[i], tip);
    add_pivot(scene, beam, scale, shape);
    if (scale->parts & BEAM_SCENE_FORCES)
        add_drive(scene, beam, scale, shape, moment->drive);
    for (size_t i = 0; i < joint_count(scale) && scale->stops && scale->parts & BEAM_SCENE_FORCES; i++)
        beam_joint_contact(scene, beam, scale, &scale->joint[i], tip, moment);
    scene->clock = scene_text(scene, "cycle %zu, %.2f ms", moment->cycle, 1000 * moment->time);
}
