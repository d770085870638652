#include "exchange/sh3d.h"

#include <math.h>
#include <stdint.h>
#include <string.h>
#include <strings.h>

#include "base/real.h"
#include "base/text.h"
#include "exchange/sh3d_home.h"
#include "exchange/wall_chains.h"

/* All assumed: */
static const double SILL = 0.3;        /* m: an opening with a higher sill is a window */
static const double DOOR_LOWEST = 1.5; /* m: an opening lower than this is a window */
static const double PASSABLE = 1.8;    /* m: a window of this height at the floor is a door */
static const double THRESHOLD = 0.05;  /* m: such a window begins at most this high above the floor */
static const double OVERHEAD = 1.8;    /* m: a piece that hangs above this height does not obstruct */
static const double FLAT = 0.03;       /* m: nor does a piece on the floor that is at most this high */
static const double SAME = 2e-3;       /* m: doors closer than this are one */
static const double OFF_WALL = 0.15;   /* m: largest distance of a door from the faces of its wall */
static const double TURNS = 0.2;       /* rad: a leaf that turns by less slides */

enum {
    MOST_LINES = 2 * HOUSE_BUILDER_POINTS, /* wall lines; a round wall has many */
    NAME_SHOWN = 40                        /* bytes of a storey's name in a message */
};

typedef struct Converter {
    const Home *home;
    HouseBuilder *builder;
    double unit;       /* m */
    const char *level; /* id of the chosen storey, or NULL if there are none */
} Converter;

static Vec2 plan_point(const Converter *converter, Vec2 at) {
    return vec2(at.x * converter->unit, -at.y * converter->unit);
}

/* Storeys --------------------------------------------------------------------------------------------------------- */

static const HomeLevel *lowest_level(const Home *home) {
    const HomeLevel *lowest = home->levels;
    for (size_t l = 1; l < home->level_count; l++)
        if (home->levels[l].elevation < lowest->elevation)
            lowest = &home->levels[l];
    return lowest;
}

static const HomeLevel *named_level(const Home *home, const char *name) {
    for (size_t l = 0; l < home->level_count; l++)
        if (strcmp(home->levels[l].name, name) == 0)
            return &home->levels[l];
    return NULL;
}

/* "Ground floor, First floor, ..."; memory_free it. */
static char *level_names(const Home *home) {
    Text names = {0};
    for (size_t l = 0; l < home->level_count && l < 10; l++)
        text_format(&names, "%s\"%.*s\"", l ? ", " : "", text_fitting(home->levels[l].name, NAME_SHOWN),
                    home->levels[l].name);
    if (home->level_count > 10)
        text_add(&names, ", ...");
    return names.text;
}

static bool choose_level(Converter *converter) {
    const Home *home = converter->home;
    const char *wanted = converter->builder->options->level;
    if (!home->level_count)
        return !wanted ||
               house_builder_fail(converter->builder, "the home has no storeys: leave out --level %s", wanted);
    const HomeLevel *level = wanted ? named_level(home, wanted) : lowest_level(home);
    char *names = level_names(home);
    if (!level)
        house_builder_fail(converter->builder, "unknown storey \"%s\", the storeys are %s", wanted, names);
    else if (home->level_count > 1 && !wanted)
        import_report_note(
            converter->builder->report,
            "the lowest storey, \"%.*s\", is imported; choose another of %s with clearance import --level",
            text_fitting(level->name, NAME_SHOWN), level->name, names);
    memory_free(names);
    converter->level = level ? level->id : NULL;
    return level;
}

/* True if the element lies on the chosen storey; an element without a storey lies on all. */
static bool is_here(const Converter *converter, const char *level) {
    return !converter->level || !*level || strcmp(level, converter->level) == 0;
}

/* Walls ----------------------------------------------------------------------------------------------------------- */

static double height_of(double height, double unit) {
    return height > 0 ? height * unit : 0;
}

/* A positive angle on the screen bulges to the left, seen along the wall. */
static void add_arc(const Converter *converter, const HomeWall *wall, WallLine line, WallLines *lines) {
    Vec2 across = vec2_sub(line.b, line.a), points[WALL_CHAINS_ARC];
    double sweep = -real_clamp(wall->arc, -1.99 * M_PI, 1.99 * M_PI);
    SineCosine half = real_sincos(sweep / 2);
    double off = half.cosine / (2 * half.sine);
    Vec2 centre = vec2_along(vec2_along(line.a, 0.5, across), off, vec2_left(across));
    if (!house_builder_good(converter->builder, centre))
        return;
    size_t count = wall_chains_arc(centre, line.a, sweep, points);
    points[count - 1] = line.b; /* set exactly, without rounding */
    for (size_t i = 0; i < count; i++) {
        line.b = points[i];
        wall_chains_append(lines, line);
        line.a = points[i];
    }
}

static size_t add_walls(const Converter *converter) {
    const Home *home = converter->home;
    WallLines lines = {0};
    size_t elsewhere = 0;
    for (size_t w = 0; w < home->wall_count; w++) {
        const HomeWall *wall = &home->walls[w];
        WallLine line = {plan_point(converter, wall->from), plan_point(converter, wall->to),
                         fabs(wall->thickness) * converter->unit, height_of(wall->height, converter->unit)};
        if (!is_here(converter, wall->level))
            elsewhere++;
        else if (fabs(wall->arc) > 0.01 && vec2_distance(line.a, line.b) > 0)
            add_arc(converter, wall, line, &lines);
        else
            wall_chains_append(&lines, line);
        if (lines.count > MOST_LINES) {
            house_builder_fail(converter->builder, "walls of more than %d pieces, must be fewer", MOST_LINES);
            break;
        }
    }
    size_t doubled = wall_chains_add(converter->builder, lines.list, lines.count);
    if (doubled)
        import_report_note(converter->builder->report, "walls drawn more than once count once (%zu)", doubled);
    memory_free(lines.list);
    return elsewhere;
}

/* Doors ----------------------------------------------------------------------------------------------------------- */

enum { WORDS = 6 };

/* True if the catalogue's or the owner's name of the piece contains one of the words. */
static bool is_called(const HomePiece *piece, const char *const words[WORDS]) {
    for (size_t w = 0; w < WORDS && words[w]; w++)
        if (strcasestr(piece->catalog, words[w]) || strcasestr(piece->name, words[w]))
            return true;
    return false;
}

/* True for a window. A French window counts as a door, and so does any window with sashes that begins at the floor and
 * is as high as a door. */
static bool is_window(const Converter *converter, const HomePiece *piece) {
    static const char *const windows[WORDS] = {"window", "fenster", "fen\u00eatre", "ventana", "finestra", "\u7a93"};
    static const char *const doors[WORDS] = {"french", "door", "t\u00fcr", "porte", "puerta", "porta"};
    double height = piece->height * converter->unit;
    bool like_a_door = piece->sash_count && height >= PASSABLE && piece->elevation * converter->unit <= THRESHOLD;
    return piece->elevation * converter->unit > SILL || height < DOOR_LOWEST ||
           (is_called(piece, windows) && !is_called(piece, doors) && !like_a_door);
}

/* Returns a point of a piece, given in fractions of its width and depth from its back left corner, moved by `reach`
 * times its width along `angle`, which turns counter-clockwise on the screen. */
static Vec2 piece_point(const Converter *converter, const HomePiece *piece, double x, double y, double reach,
                        double angle) {
    double side = piece->mirrored ? -1 : 1;
    Vec2 along = vec2_heading(angle), own = {side * (x - 0.5 + reach * along.x) * piece->width,
                                             (y - 0.5) * piece->depth - reach * along.y * piece->width};
    return plan_point(converter, vec2_add(piece->centre, vec2_turn(own, vec2_heading(piece->angle))));
}

/* A part of a wall's segment, m from its start. */
typedef struct Stretch {
    double low, high;
} Stretch;

/* The opening that a door's sashes give, along the wall from the start of its segment. */
typedef struct Opening {
    double low, high; /* m, clear width */
    double width;     /* m, sum of the sashes' widths */
    Stretch widest;   /* the widest sash */
    size_t hinged;    /* number of sashes that do not slide */
    Door door;
} Opening;

/* A leaf's free end lies in the wall when shut and beside the wall when open. */
static void add_sash(const Converter *converter, const HomePiece *piece, const HomeSash *sash, Vec2 begin, Vec2 along,
                     Opening *opening) {
    Vec2 hinge = piece_point(converter, piece, sash->x_axis, sash->y_axis, 0, 0);
    Vec2 one = piece_point(converter, piece, sash->x_axis, sash->y_axis, sash->width, sash->start);
    Vec2 other = piece_point(converter, piece, sash->x_axis, sash->y_axis, sash->width, sash->end);
    bool first_shut = fabs(vec2_dot(vec2_sub(one, hinge), along)) >= fabs(vec2_dot(vec2_sub(other, hinge), along));
    Vec2 shut = first_shut ? one : other, open = first_shut ? other : one;
    double from = vec2_dot(vec2_sub(hinge, begin), along), to = vec2_dot(vec2_sub(shut, begin), along);
    opening->low = fmin(opening->low, fmin(from, to));
    opening->high = fmax(opening->high, fmax(from, to));
    opening->width += fabs(sash->width) * piece->width * converter->unit;
    if (fabs(to - from) > opening->widest.high - opening->widest.low)
        opening->widest = (Stretch){fmin(from, to), fmax(from, to)};
    bool slides = fabs(sash->end - sash->start) < TURNS;
    opening->hinged += !slides;
    opening->door.kind = slides ? DOOR_SLIDING : DOOR_HINGED;
    opening->door.hinge = from < to ? HINGE_START : HINGE_END;
    opening->door.swing = vec2_cross(along, vec2_sub(open, hinge)) > 0 ? SWING_LEFT : SWING_RIGHT;
}

static Opening opening_of(const Converter *converter, const HomePiece *piece, Vec2 begin, Vec2 along) {
    Opening opening = {.low = HUGE_VAL, .high = -HUGE_VAL};
    for (size_t s = 0; s < piece->sash_count; s++)
        add_sash(converter, piece, &converter->home->sashes[piece->sash + s], begin, along, &opening);
    if (piece->sash_count == 0) { /* a plain hole in the wall */
        double middle = vec2_dot(vec2_sub(plan_point(converter, piece->centre), begin), along);
        opening.low = opening.high = middle;
        opening.width = piece->width * converter->unit;
    }
    if (piece->sash_count > 1 && !opening.hinged) { /* one leaf slides in front of another */
        opening.low = opening.widest.low;
        opening.high = opening.widest.high;
        opening.width = opening.high - opening.low;
    } else if (piece->sash_count != 1) {
        opening.door.kind = DOOR_OPENING;
    }
    opening.door.width = opening.width;
    opening.door.at = (opening.low + opening.high) / 2;
    return opening;
}

/* True if an earlier door has this place. */
static bool repeats(const HouseBuilder *builder, const Door *door) {
    bool found = false;
    for (size_t d = 0; d < builder->plan.door_count && !found; d++) {
        const Door *other = &builder->plan.doors[d];
        found = other->wall_index == door->wall_index && other->segment == door->segment &&
                fabs(other->at - door->at) < SAME && fabs(other->width - door->width) < SAME;
    }
    return found;
}

static void add_door(const Converter *converter, const HomePiece *piece) {
    HouseBuilder *builder = converter->builder;
    Vec2 centre = plan_point(converter, piece->centre), along = vec2_heading(-piece->angle);
    double reach = fabs(piece->depth) * converter->unit / 2 + OFF_WALL;
    size_t wall;
    int segment;
    bool found = house_builder_nearest(builder, centre, along, reach, &wall, &segment);
    size_t door = SIZE_MAX;
    bool repeated = false;
    if (found) {
        const Vec2 *ends = builder->plan.walls[wall].points.at + segment;
        Opening opening = opening_of(converter, piece, ends[0], vec2_unit(vec2_sub(ends[1], ends[0])));
        opening.door.wall_index = wall;
        opening.door.segment = segment;
        repeated = repeats(builder, &opening.door);
        door = repeated ? SIZE_MAX : house_builder_door(builder, &opening.door);
    }
    if (repeated)
        import_report_leave(builder->report, 1, "doors that stand in the place of an earlier door");
    else if (door == SIZE_MAX)
        import_report_leave(builder->report, 1, "%s",
                            found ? "doors that do not fit into their wall" : "doors that are not in a wall");
    else if (piece->sash_count > 1 && builder->plan.doors[door].kind == DOOR_SLIDING)
        import_report_leave(builder->report, 1, "further leaves of sliding doors: the widest leaf opens");
    else if (piece->sash_count > 1)
        import_report_leave(builder->report, 1, "further leaves of doors: such doors became openings");
}

/* Furniture, rooms ------------------------------------------------------------------------------------------------ */

/* Returns the reason why a piece does not obstruct, or NULL. */
static const char *harmless(const Converter *converter, const HomePiece *piece) {
    double bottom = piece->elevation * converter->unit, top = bottom + piece->height * converter->unit;
    if (!piece->visible)
        return "pieces that are hidden";
    if (piece->opens && is_window(converter, piece))
        return "windows";
    if (piece->opens)
        return NULL;
    return bottom >= OVERHEAD ? "pieces that hang above 1.8 m"
           : top <= FLAT      ? "rugs and the like, up to 3 cm high"
                              : NULL;
}

static void add_furniture(const Converter *converter, const HomePiece *piece) {
    Vec2 size = vec2_scale(vec2(piece->width, piece->depth), converter->unit);
    double top = (piece->elevation + piece->height) * converter->unit;
    size_t added = house_builder_piece(converter->builder, piece->name, plan_point(converter, piece->centre), size,
                                       -degrees(piece->angle), top);
    if (added == SIZE_MAX)
        import_report_leave(converter->builder->report, 1, "pieces narrower than 1 cm");
}

static size_t add_pieces(const Converter *converter) {
    size_t elsewhere = 0, doors = 0;
    for (size_t p = 0; p < converter->home->piece_count && !converter->builder->failed; p++) {
        const HomePiece *piece = &converter->home->pieces[p];
        const char *why = harmless(converter, piece);
        converter->builder->line = piece->line;
        if (!is_here(converter, piece->level))
            elsewhere++;
        else if (why)
            import_report_leave(converter->builder->report, 1, "%s", why);
        else if (piece->opens && ++doors > HOUSE_BUILDER_FEW)
            house_builder_fail(converter->builder, "more than %d doors, must be fewer", HOUSE_BUILDER_FEW);
        else if (piece->opens)
            add_door(converter, piece);
        else
            add_furniture(converter, piece);
    }
    return elsewhere;
}

static size_t add_rooms(const Converter *converter) {
    const Home *home = converter->home;
    size_t elsewhere = 0;
    for (size_t r = 0; r < home->room_count; r++) {
        const HomeRoom *room = &home->rooms[r];
        if (!is_here(converter, room->level)) {
            elsewhere++;
            continue;
        }
        Vec2 *points = memory_zeroed(room->point_count, sizeof *points);
        for (size_t i = 0; i < room->point_count; i++)
            points[i] = plan_point(converter, home->points[room->point + i]);
        house_builder_room(converter->builder, room->name, points, room->point_count);
        memory_free(points);
    }
    return elsewhere;
}

/* The whole ------------------------------------------------------------------------------------------------------- */

static bool convert(Converter *converter) {
    const Home *home = converter->home;
    HouseBuilder *builder = converter->builder;
    if (!choose_level(converter))
        return false;
    size_t elsewhere = add_walls(converter);
    elsewhere += add_pieces(converter);
    elsewhere += add_rooms(converter);
    import_report_leave(builder->report, elsewhere, "walls, rooms and furniture on other storeys");
    import_report_leave(builder->report, home->polylines, "drawn lines");
    import_report_leave(builder->report, home->labels, "texts");
    import_report_leave(builder->report, home->dimensions, "dimension lines");
    import_report_leave(builder->report, home->pictures, "background pictures");
    if (builder->plan.door_count)
        import_report_note(builder->report, "all doors are open; their state can be edited");
    return !builder->failed;
}

bool sh3d_read(HouseBuilder *builder) {
    Home home = {0};
    Converter converter = {
        .home = &home, .builder = builder, .unit = builder->options->unit > 0 ? builder->options->unit : 0.01};
    bool good = sh3d_home_read(&home, builder) && convert(&converter);
    sh3d_home_clear(&home);
    return good;
}
