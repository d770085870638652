#include "laboratory/beam_scene.h"

#include "laboratory/beam_pieces.h"
#include "laboratory/beam_words.h"

/* Of the beam's length: where everything is. */
#define THINNEST 0.008 /* half of the thickness, as drawn, at least: a thinner beam could not be seen */
#define THICKEST 0.03  /* and at most */
#define BALL_MORE 1.25 /* 1, of the half thickness */
#define RISE 0.105     /* the largest deflection, magnified, at most */
#define GROUND 0.155   /* of the stops, from the middle */
#define FLOOR -0.150   /* of pivot and shaker */
#define GROUND_DEPTH 0.016
#define STOP_DEPTH 0.010
#define STOP_LENGTH 0.055
#define DIMENSION_AT 0.085 /* behind the tip */
#define ROW 0.0275         /* from one row of words to the next */
#define BEFORE 0.11        /* of the picture, before the beam */
#define BEHIND 0.265       /* and behind it */
#define HIGH 0.175
#define LOW -0.170
#define YOKE_HALF 0.045
#define YOKE_DEPTH 0.013
#define YOKE_TOP -0.070
#define COIL_HALF 0.026
#define COIL_DEPTH 0.034
#define NEAR 0.16 /* pivot and shaker that are nearer to each other: the pivot stands above */
#define DRIVE_MOST 0.085
#define FORCE_MOST 0.100
#define BURST_MOST 0.034

/* Design points. */
#define PANELS_HEIGHT 290.0
#define NAME_LETTERS 17.0
#define SMALL_LETTERS 15.0
#define FORCE_LETTERS 22.0
#define EDGE 1.5
#define THIN 1.5
#define DIMENSION_WIDTH 2.0

#define STOPS_AWAY 4.0 /* times the reach: stops that far away would leave nothing to be seen of the beam */

/* The largest round number up to a value: 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten. */
static double round_down(double value) {
    static const double steps[] = {8, 6, 5, 4, 3, 2.5, 2, 1.5, 1};
    double power = pow(10, floor(log10(value)));
    size_t i = 0;
    while (i + 1 < sizeof steps / sizeof *steps && steps[i] * power > value * (1 + 1e-12))
        i++;
    return steps[i] * power;
}

BeamScale beam_scene_scale(const Beam *beam, double reach) {
    BeamScale scale = {.length = beam->length};
    double half = beam->thickness / 2;
    scale.half = fmax(THINNEST * beam->length, fmin(half, THICKEST * beam->length));
    scale.to_scale = scale.half == half;
    scale.ball = BALL_MORE * scale.half;
    scale.stops = beam->clearance <= STOPS_AWAY * reach || reach == 0;
    double seen = scale.stops ? fmax(reach, beam->clearance) : reach;
    scale.factor = seen > 0 ? round_down(RISE * beam->length / seen) : 1;
    scale.gap = scale.factor * beam->clearance;
    return scale;
}

Vec2 beam_scene_tip(const BeamScale *scale, double deflection) {
    return vec2(scale->length, scale->factor * deflection);
}

void beam_scene_words(Scene *scene, const Beam *beam, const Rig *rig, const Response *response, const BeamScale *scale,
                      double slow) {
    double length = scale->length;
    bool resolved = response->verdict == RESPONSE_PERIODIC || response->verdict == RESPONSE_CHAOTIC;
    scene->box = (Box){{-BEFORE * length, LOW * length}, {(1 + BEHIND) * length, HIGH * length}};
    scene->panel_height = PANELS_HEIGHT;
    scene->title = beam_words_title(scene, beam, rig, response);
    scene->title_role = resolved ? ROLE_TEXT : ROLE_ERROR;
    scene->detail = beam_words_detail(scene, response);
    scene->name = scene_text(scene, "%s from the side: deflection \u00d7 %g", beam->name, scale->factor);
    const char *slower = slow > 0 ? scene_text(scene, "%g times slower", slow) : "the moment of the largest force";
    const char *section = beam_words_provenance(scene, beam, "beam.thickness");
    scene->note = scene_text(scene, "%s; thickness%s; section %s", slower,
                             scale->to_scale ? " to scale" : " not to scale", section);
}

/* Rows of words to one side of a place, downwards; a piece's name is bold, what is told of it is not. */
static void add_rows(Scene *scene, const BeamScale *scale, Vec2 at, int side, const char *const *rows, size_t count) {
    for (size_t i = 0; i < count; i++) {
        Vec2 from = vec2(at.x, at.y - ROW * scale->length * (double)i), to = vec2(from.x + side, from.y);
        Primitive *label =
            scene_add_label(scene, i ? ROLE_DIM_TEXT : ROLE_TEXT, i ? SMALL_LETTERS : NAME_LETTERS, from, rows[i]);
        if (side)
            scene_bind_label(scene, label, &to, 1);
        label->bold = i == 0;
        label->fixed = true;
    }
}

/* Is the pivot so near to the shaker that it has to stand above? */
static double pivot_side(const Beam *beam) {
    return fabs(beam->pivot_position - beam->shaker_position) < NEAR * beam->length ? 1 : -1;
}

/* Ground under (or over) something, a thick line with hatches behind it. */
static void add_ground(Scene *scene, const BeamScale *scale, Vec2 middle, double half, double up) {
    beam_pieces_ground(scene, vec2(middle.x - half * scale->length, middle.y),
                       vec2(middle.x + half * scale->length, middle.y), up * GROUND_DEPTH * scale->length);
}

static void still_pivot(Scene *scene, const Beam *beam, const BeamScale *scale) {
    double length = scale->length, side = pivot_side(beam);
    Vec2 foot = vec2(beam->pivot_position, side * -FLOOR * length);
    const char *rows[] = {"flexure pivot",
                          scene_text(scene, "%s, %s", beam_words_quantity(scene, beam->pivot_stiffness, "N/m"),
                                     beam_words_quantity(scene, beam->pivot_rotational, "N m/rad")),
                          beam_words_provenance(scene, beam, "pivot.translational_stiffness")};
    if (beam->pivot_stiffness > 0)
        add_ground(scene, scale, foot, 0.03, side);
    Vec2 words = vec2(beam->pivot_position + (side > 0 ? 0.05 : -0.02) * length,
                      side > 0 ? HIGH * length - ROW * length : 0.125 * length);
    add_rows(scene, scale, words, 1, rows, 3);
}

static void still_shaker(Scene *scene, const Beam *beam, const BeamScale *scale) {
    double length = scale->length, x = beam->shaker_position, bottom = FLOOR * length;
    const char *mass = beam->shaker_mass > 0 ? beam_words_quantity(scene, beam->shaker_mass, "kg") : "no mass";
    const char *rows[] = {"shaker",
                          scene_text(scene, "%s, %s, %s", beam_words_quantity(scene, beam->force, "N"), mass,
                                     beam_words_quantity(scene, beam->shaker_stiffness, "N/m")),
                          beam_words_provenance(scene, beam, "drive.force")};
    add_ground(scene, scale, vec2(x, bottom), YOKE_HALF + YOKE_DEPTH, -1);
    for (int side = -1; side <= 1; side += 2)
        beam_pieces_block(scene, ROLE_FURNITURE,
                          box_include(box_around(vec2(x + side * YOKE_HALF * length, bottom), 0),
                                      vec2(x + side * (YOKE_HALF + YOKE_DEPTH) * length, YOKE_TOP * length)));
    add_rows(scene, scale, vec2(x + (YOKE_HALF + YOKE_DEPTH) * length, YOKE_TOP * length - ROW * length / 2), 1, rows,
             3);
}

/* How far it is to a stop, beside it. */
static void add_gap(Scene *scene, const Beam *beam, const BeamScale *scale, int side) {
    double length = scale->length, x = length + DIMENSION_AT * length;
    double rest = side * scale->ball, face = side * (scale->ball + scale->gap);
    Vec2 lines[2][2] = {{{length, rest}, {x + 0.012 * length, rest}}, {{length, face}, {x + 0.012 * length, face}}};
    for (int i = 0; i < 2; i++)
        scene_add_line(scene, ROLE_DIM_TEXT, THIN, lines[i], 2)->style = LINE_DASHED;
    scene_add_dimension(scene, ROLE_TEXT, DIMENSION_WIDTH, vec2(x, rest), vec2(x, face));
    const char *rows[] = {scene_text(scene, "%.4g mm", 1000 * beam->clearance)};
    add_rows(scene, scale, vec2(x + 0.012 * length, (rest + face) / 2), 1, rows, 1);
}

static void still_joint(Scene *scene, const Beam *beam, const BeamScale *scale) {
    double length = scale->length;
    const char *rows[] = {"stop",
                          scene_text(scene, "%s, %s", beam_words_quantity(scene, beam->contact.normal_stiffness, "N/m"),
                                     beam_words_quantity(scene, beam->contact.normal_damping, "N s/m")),
                          beam_words_provenance(scene, beam, "joint.stiffness")};
    if (!scale->stops) {
        const char *away[] = {scene_text(scene, "stops at \u00b1%g mm: outside", 1000 * beam->clearance)};
        add_rows(scene, scale, vec2(length + 0.02 * length, 0.1 * length), 1, away, 1);
        return;
    }
    for (int side = -1; side <= 1; side += 2) {
        add_ground(scene, scale, vec2(length, side * GROUND * length), STOP_LENGTH / 2 + 0.01, side);
        if (scale->gap > 0)
            add_gap(scene, beam, scale, side);
    }
    add_rows(scene, scale, vec2(length + STOP_LENGTH / 2 * length, (GROUND + 0.008) * length), 1, rows, 3);
    if (scale->gap == 0) {
        const char *none[] = {"no clearance"};
        add_rows(scene, scale, vec2(length + STOP_LENGTH / 2 * length, 0), 1, none, 1);
    }
}

void beam_scene_still(Scene *scene, const Beam *beam, const BeamScale *scale) {
    Vec2 rest[] = {{-0.04 * scale->length, 0}, {(1 + DIMENSION_AT) * scale->length, 0}};
    scene_add_line(scene, ROLE_ROOM, THIN, rest, 2)->style = LINE_DASH_DOT;
    still_pivot(scene, beam, scale);
    still_shaker(scene, beam, scale);
    still_joint(scene, beam, scale);
}

/* What moves --------------------------------------------------------------------------------------------------------*/

static double drawn_at(const BeamScale *scale, const BeamShape *shape, double place) {
    return scale->factor * beam_shape_at(shape, place);
}

static void add_pivot(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamShape *shape) {
    double side = pivot_side(beam), length = scale->length;
    Vec2 at = vec2(beam->pivot_position, drawn_at(scale, shape, beam->pivot_position));
    if (beam->pivot_stiffness > 0)
        beam_pieces_spring(scene, vec2(at.x, at.y + side * scale->half), vec2(at.x, side * -FLOOR * length),
                           0.016 * length);
    if (beam->pivot_rotational > 0)
        beam_pieces_spiral(scene, at, 0.030 * length);
    Primitive *pin = scene_add_discs(scene, ROLE_PAPER, 0.007 * length, &at, 1);
    pin->edge = ROLE_WALL;
    pin->width = 2;
}

/* The armature hangs on the beam; its suspension stands on the floor. */
static void add_shaker(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamShape *shape) {
    double length = scale->length, x = beam->shaker_position, floor = FLOOR * length;
    double top = drawn_at(scale, shape, x) - scale->half, bottom = top - COIL_DEPTH * length;
    bool heavy = beam->shaker_mass > 0, damped = beam->shaker_damping > 0;
    Vec2 rod[] = {{x, top}, {x, heavy ? top : bottom}};
    scene_add_line(scene, ROLE_WALL, 4, rod, 2);
    if (beam->shaker_stiffness > 0)
        beam_pieces_spring(scene, vec2(x - (damped ? 0.012 : 0) * length, bottom),
                           vec2(x - (damped ? 0.012 : 0) * length, floor), 0.011 * length);
    if (damped)
        beam_pieces_dashpot(scene, vec2(x + 0.014 * length, bottom), vec2(x + 0.014 * length, floor), 0.008 * length);
    if (heavy) {
        Primitive *coil =
            beam_pieces_block(scene, ROLE_DOOR, (Box){{x - COIL_HALF * length, bottom}, {x + COIL_HALF * length, top}});
        coil->fill = ROLE_PAPER;
        coil->edge = ROLE_DOOR;
        coil->hatched = true;
    }
}

static void add_beam(Scene *scene, const BeamScale *scale, const BeamShape *shape) {
    size_t count = shape->count;
    Vec2 *outline = arena_allocate(&scene->arena, 2 * count * sizeof *outline);
    for (size_t i = 0; i < count; i++) {
        double y = scale->factor * shape->deflection[i];
        outline[i] = vec2(shape->place[i], y + scale->half);
        outline[2 * count - 1 - i] = vec2(shape->place[i], y - scale->half);
    }
    Primitive *beam = scene_add_polygon(scene, ROLE_WALKER, outline, 2 * count);
    beam->edge = ROLE_WALL;
    beam->width = EDGE;
    Vec2 tip = vec2(scale->length, scale->factor * shape->deflection[count - 1]);
    Primitive *ball = scene_add_discs(scene, ROLE_WALKER, scale->ball, &tip, 1);
    ball->edge = ROLE_WALL;
    ball->width = EDGE;
}

/* A stop, pushed out by the tip where that is in it, and its spring. */
static void add_stop(Scene *scene, const BeamScale *scale, double tip, int side) {
    double length = scale->length, half = STOP_LENGTH / 2 * length;
    double face = side * (scale->ball + fmax(scale->gap, side * tip)), back = face + side * STOP_DEPTH * length;
    beam_pieces_spring(scene, vec2(length, back), vec2(length, side * GROUND * length), 0.018 * length);
    beam_pieces_block(scene, ROLE_WALL,
                      box_include(box_around(vec2(length - half, face), 0), vec2(length + half, back)));
}

/* The shaker's force, above the beam: it pulls up or presses down. */
static void add_drive(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamShape *shape, double drive) {
    double length = scale->length, x = beam->shaker_position + (pivot_side(beam) > 0 ? -0.06 * length : 0);
    if (beam->force <= 0)
        return;
    Vec2 low = vec2(x, drawn_at(scale, shape, beam->shaker_position) + scale->half);
    Vec2 high = vec2(x, low.y + DRIVE_MOST * length * fabs(drive) / beam->force);
    beam_pieces_arrow(scene, ROLE_LOCUS_SECOND, drive > 0 ? low : high, drive > 0 ? high : low, 0.008 * length);
    Primitive *label = scene_add_label(scene, ROLE_LOCUS_SECOND, NAME_LETTERS, vec2(x, (HIGH - 0.02) * length),
                                       scene_text(scene, "%+.0f N", drive));
    label->fixed = label->bold = true;
}

/* The force that a stop has now, or had at the most when it was last touched, beside it. */
static void add_force_words(Scene *scene, const BeamScale *scale, const BeamMoment *moment, int side, bool touched) {
    const BeamImpact *last = moment->last[side > 0 ? 0 : 1];
    if (!touched && !last)
        return;
    double length = scale->length;
    Vec2 at = vec2(length - (STOP_LENGTH / 2 + 0.012) * length, side * (scale->ball + scale->gap + 0.035 * length));
    Vec2 left = vec2(at.x - length, at.y);
    const char *text = touched ? beam_words_newtons(scene, fabs(moment->force))
                               : scene_text(scene, "last %s", beam_words_newtons(scene, last->peak));
    Primitive *label = scene_add_label(scene, ROLE_DIM_TEXT, touched ? FORCE_LETTERS : NAME_LETTERS, at, text);
    scene_bind_label(scene, label, &left, 1);
    label->fixed = true;
    if (touched) {
        label->bold = true;
        label->shape = LABEL_TAG;
        label->fill = ROLE_DANGER_MIDDLE;
    }
}

/* A star where the tip touches, and an arrow as long as the force that throws it back; both also in words. */
static void add_contact(Scene *scene, const BeamScale *scale, const BeamMoment *moment, double tip) {
    int side = moment->force < 0 ? 1 : -1;
    bool touched = moment->force != 0;
    double share = touched ? fabs(moment->force) / fmax(moment->largest, fabs(moment->force)) : 0;
    if (touched) {
        Vec2 at = vec2(scale->length, tip + side * scale->ball);
        beam_pieces_burst(scene, at, BURST_MOST * scale->length * sqrt(share));
        beam_pieces_arrow(scene, ROLE_DANGER_MIDDLE, at, vec2(at.x, at.y - side * FORCE_MOST * scale->length * share),
                          0.008 * scale->length);
    }
    for (int s = -1; s <= 1; s += 2)
        add_force_words(scene, scale, moment, s, touched && s == side);
}

void beam_scene_moving(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamShape *shape,
                       const BeamMoment *moment) {
    double tip = scale->factor * shape->deflection[shape->count - 1];
    add_shaker(scene, beam, scale, shape);
    for (int side = -1; side <= 1 && scale->stops; side += 2)
        add_stop(scene, scale, tip, side);
    add_beam(scene, scale, shape);
    add_pivot(scene, beam, scale, shape);
    add_drive(scene, beam, scale, shape, moment->drive);
    if (scale->stops)
        add_contact(scene, scale, moment, tip);
    scene->clock = scene_text(scene, "cycle %zu, %.2f ms", moment->cycle, 1000 * moment->time);
}
