/* Tests rules: every shipped rule against houses at its limit, and 2 mm to both sides of it, upright and turned by 30
 * degrees; and the reader with bad files. */

#include "rules/inspection.h"

#include <jansson.h>
#include <stdio.h>
#include <string.h>

#include "case.h"
#include "check.h"
#include "scratch.h"

#define WALL 0.12 /* m, thickness */

/* A house under construction, turned about the origin. */
typedef struct Drawing {
    json_t *plan;
    double angle; /* degree */
} Drawing;

static json_t *point(const Drawing *drawing, double x, double y) {
    Vec2 at = vec2_turn(vec2(x, y), vec2_heading(radians(drawing->angle)));
    return json_pack("[f, f]", at.x, at.y);
}

static Drawing begin(double angle) {
    return (Drawing){json_pack("{s:s, s:i, s:s, s:[], s:[], s:[], s:[], s:[], s:[]}", "format", "clearance-house",
                               "version", 1, "name", "limit", "walls", "doors", "furniture", "rooms", "exits",
                               "people"),
                     angle};
}

static void add(Drawing *drawing, const char *list, json_t *element) {
    json_array_append_new(json_object_get(drawing->plan, list), element);
}

/* Adds a wall along a line, whose faces stand WALL / 2 to both sides. */
static void add_wall(Drawing *drawing, const char *id, double x, double y, double to_x, double to_y) {
    add(drawing, "walls",
        json_pack("{s:s, s:[o, o], s:f}", "id", id, "points", point(drawing, x, y), point(drawing, to_x, to_y),
                  "thickness", WALL));
}

static void add_exit(Drawing *drawing, double x, double low, double high) {
    add(drawing, "exits",
        json_pack("{s:s, s:o, s:o}", "id", "e1", "from", point(drawing, x, low), "to", point(drawing, x, high)));
}

static void add_room(Drawing *drawing, const char *name, Box box) {
    add(drawing, "rooms",
        json_pack("{s:s, s:s, s:[o, o, o, o]}", "id", "r1", "name", name, "outline",
                  point(drawing, box.low.x, box.low.y), point(drawing, box.high.x, box.low.y),
                  point(drawing, box.high.x, box.high.y), point(drawing, box.low.x, box.high.y)));
}

static void add_person(Drawing *drawing, double x, double y) {
    add(drawing, "people", json_pack("{s:s, s:s, s:o}", "id", "p1", "profile", "adult", "at", point(drawing, x, y)));
}

/* Returns the findings of one rule in the house, which is released, at places that begin with `place`: the number of
 * them, and the verdict of the first. */
static size_t inspect(Drawing *drawing, const Rule *rule, const char *place, int *verdict) {
    House house;
    Rule copy = *rule;
    RuleSet set = {.id = "one", .rules = &copy, .count = 1};
    RuleSets sets = {.sets = &set, .count = 1};
    size_t count = 0;
    case_made(&house, drawing->plan, -1, NULL);
    Inspection inspection = inspection_make(&house, &sets, 1, NULL);
    for (size_t i = 0; i < inspection.finding_count; i++) {
        const Finding *finding = &inspection.findings[i];
        const char *name = finding->place == SIZE_MAX ? "house" : inspection.places[finding->place].name;
        if (strncmp(name, place, strlen(place)) == 0 && !count++)
            *verdict = finding->verdict;
    }
    inspection_free(&inspection);
    house_free(&house);
    return count;
}

/* A corridor along x, in whose middle something narrows it or makes it wider. */
typedef struct Hall {
    double width, length;       /* m */
    double pillar;              /* m, the width at one place, for 0.25 m of the way; 0: nowhere */
    double bay;                 /* m, side of a square with the corridor as its lower part; 0: none */
    double rail_low, rail_high; /* m, by which rails stand out for 2 m; 0: none */
} Hall;

static void add_rail(Drawing *drawing, const char *id, double x, double y, double depth) {
    if (depth > 0)
        add(drawing, "furniture",
            json_pack("{s:s, s:s, s:o, s:[f, f], s:f, s:f}", "id", id, "name", "handrail", "centre",
                      point(drawing, x, y), "size", 2.0, depth, "angle", drawing->angle, "height", 0.9));
}

static Drawing draw_hall(double angle, const Rule *rule, const Hall *hall) {
    Drawing drawing = begin(angle);
    double width = hall->width, length = hall->length, y = (width + WALL) / 2, x = length / 2, bay = hall->bay / 2;
    double top = fmax(width, hall->bay) - width / 2; /* of the bay */
    if (bay > 0) {
        add_wall(&drawing, "w1", -0.5, y, x - bay, y);
        add_wall(&drawing, "w5", x + bay, y, length + 0.5, y);
        add_wall(&drawing, "w6", x - bay - WALL / 2, width / 2, x - bay - WALL / 2, top + WALL);
        add_wall(&drawing, "w7", x + bay + WALL / 2, width / 2, x + bay + WALL / 2, top + WALL);
        add_wall(&drawing, "w8", x - bay - WALL, top + WALL / 2, x + bay + WALL, top + WALL / 2);
    } else {
        add_wall(&drawing, "w1", -0.5, y, length + 0.5, y);
    }
    add_wall(&drawing, "w2", -0.5, -y, length + 0.5, -y);
    add_wall(&drawing, "w3", -WALL / 2, -y, -WALL / 2, y);
    if (hall->pillar > 0)
        add(&drawing, "walls",
            json_pack("{s:s, s:[o, o], s:f}", "id", "w4", "points", point(&drawing, x, width / 2),
                      point(&drawing, x, hall->pillar - width / 2), "thickness", 0.25));
    add_rail(&drawing, "f1", x, width / 2 - hall->rail_high / 2, hall->rail_high);
    add_rail(&drawing, "f2", x, hall->rail_low / 2 - width / 2, hall->rail_low);
    add_exit(&drawing, length, -width / 2, width / 2);
    add_room(&drawing, *rule->where.room ? rule->where.room : "hall", (Box){{0, -width / 2}, {length, top}});
    add_person(&drawing, 0.4, 0);
    return drawing;
}

/* A corridor of 6 m, at one place as narrow as `pillar`; where a rule allows a narrower one with places for turning, so
 * long that it needs one. */
static Drawing draw_corridor(double angle, const Rule *rule, double width, double pillar) {
    Hall hall = {.width = width, .length = fmax(6, rule->places.each + 1.5), .pillar = pillar};
    return draw_hall(angle, rule, &hall);
}

/* Two paths beside a wall that ends 4 m from their beginning, and the turn from one to the other. */
static Drawing draw_turn_round(double angle, double path, double at_turn) {
    Drawing drawing = begin(angle);
    double side = path + WALL, far = 4 + at_turn + WALL / 2;
    add_wall(&drawing, "w1", -0.5, 0, 4, 0);
    add_wall(&drawing, "w2", -0.5, side, far + WALL / 2, side);
    add_wall(&drawing, "w3", -0.5, -side, far + WALL / 2, -side);
    add_wall(&drawing, "w4", far, -side, far, side);
    add_wall(&drawing, "w5", -WALL / 2, -side, -WALL / 2, 0);
    add_exit(&drawing, 0, WALL / 2, WALL / 2 + path);
    add_room(&drawing, "hall", (Box){{0, WALL / 2 - side}, {far - WALL / 2, side - WALL / 2}});
    add_person(&drawing, 0.4, -side / 2);
    return drawing;
}

/* What stands before a door in the wall x = 0, whose middle is at y = 0; the person comes from x < 0. */
typedef struct Front {
    double width;     /* m, of the door */
    double depth;     /* m, from the wall's face to the wall opposite */
    double low, high; /* m, y of the side walls' faces */
    double x, y;      /* m, start of the person */
    const char *swing, *hinge, *kind;
    const char *room;
    double exit; /* m, x of the exit behind it */
    bool closer;
} Front;

static Drawing draw_door(double angle, const Front *front) {
    Drawing drawing = begin(angle);
    double back = -WALL / 2 - front->depth, low = front->low, high = front->high;
    add_wall(&drawing, "w1", 0, low - WALL, 0, high + WALL);
    add_wall(&drawing, "w2", back - WALL / 2, low - WALL, back - WALL / 2, high + WALL);
    add_wall(&drawing, "w3", back - WALL, low - WALL / 2, 0, low - WALL / 2);
    add_wall(&drawing, "w4", back - WALL, high + WALL / 2, 0, high + WALL / 2);
    add_wall(&drawing, "w5", 0, 1.5, 4, 1.5);
    add_wall(&drawing, "w6", 0, -1.5, 4, -1.5);
    add(&drawing, "doors",
        json_pack("{s:s, s:s, s:f, s:f, s:s, s:s, s:s, s:b}", "id", "d1", "wall", "w1", "at", -(low - WALL), "width",
                  front->width, "kind", front->kind, "hinge", front->hinge, "swing", front->swing, "closer",
                  front->closer));
    add_exit(&drawing, front->exit, -1.4, 1.4);
    add_room(&drawing, front->room, (Box){{back, low}, {-WALL / 2, high}});
    add_person(&drawing, front->x, front->y);
    return drawing;
}

static Front usual_front(const Rule *rule) {
    const RuleWhere *where = &rule->where;
    double depth = 3;
    if (where->space_least > 0 || where->space_below < 100)
        depth = where->space_least + fmin(where->space_below - where->space_least, 0.4) / 2;
    return (Front){.width = 1,
                   .depth = depth,
                   .low = -3,
                   .high = 3,
                   .x = -fmin(depth / 2, 2) - WALL / 2,
                   .y = -2.4,
                   .swing = "right",
                   .hinge = "start",
                   .closer = where->closer == CLOSER_WITH,
                   .kind = where->kind == KIND_SLIDING ? "sliding" : "hinged",
                   .room = *where->room ? where->room : "hall",
                   .exit = where->doors == DOORS_ENTRANCE ? 0.5 : 3.5};
}

/* A door with the manoeuvring space of a rule, off by `off` m in its depth or, with `beside`, beside the opening. The
 * wall runs upwards, so that its left is x < 0, where the person is; the hinge at its start is below. */
static Drawing draw_space(double angle, const Rule *rule, double off, bool beside) {
    Front front = usual_front(rule);
    bool latch_rule = rule->what == RULE_LATCH_SPACE, pull = rule->where.side != SIDE_PUSH;
    double beyond = latch_rule ? rule->least : rule->beyond, depth = latch_rule ? 1.6 : rule->least;
    front.swing = pull ? "left" : "right";
    front.depth = depth + (beside ? 0 : off);
    double side = front.width / 2 + beyond + (beside ? off : 0); /* of the wall beside it */
    if (rule->at_hinge)
        front.low = -side;
    else if (beyond > 0)
        front.high = side;
    front.x = -WALL / 2 - 0.3;
    front.y = rule->where.approach == APPROACH_HINGE   ? fmax(front.low + 0.3, -2.4)
              : rule->where.approach == APPROACH_LATCH ? fmin(front.high - 0.3, 2.4)
                                                       : 0;
    if (rule->where.approach == APPROACH_FRONT || rule->where.approach == APPROACH_ANY)
        front.x = -WALL / 2 - front.depth + 0.2;
    return draw_door(angle, &front);
}

static Drawing draw_turning(double angle, const Rule *rule, double size) {
    Front front = usual_front(rule);
    front.width = 0.8;
    front.depth = size + 0.5;
    front.low = -size / 2;
    front.high = size / 2;
    front.x = -WALL / 2 - size / 2;
    front.y = 0;
    return draw_door(angle, &front);
}

/* Returns the verdict on the one corridor of a hall. */
static int inspect_hall(double angle, const Rule *rule, Hall hall) {
    int verdict = -1;
    Drawing drawing = draw_hall(angle, rule, &hall);
    CHECK(inspect(&drawing, rule, "corridor", &verdict) == 1);
    return verdict;
}

/* Checks one rule with a house off its limit by `off` m. */
static void check_limit(const RuleSet *set, const Rule *rule, double angle, double off, int expected) {
    int verdict = -1, pillar = -1, beside = -1, inner = -1;
    size_t count = 0;
    Drawing drawing;
    switch (rule->what) {
    case RULE_CORRIDOR_WIDTH:
        drawing = draw_corridor(angle, rule, rule->least + off, 0);
        count = inspect(&drawing, rule, "corridor", &verdict);
        if (rule->pillar.least > 0) {
            drawing = draw_corridor(angle, rule, rule->least + 0.1, rule->pillar.least + off);
            CHECK(inspect(&drawing, rule, "corridor", &pillar) == 1);
        }
        if (rule->places.least > 0)
            beside = inspect_hall(angle, rule,
                                  (Hall){.width = rule->places.least + off,
                                         .length = rule->places.each + 1.5,
                                         .bay = rule->places.square + 0.01});
        if (rule->rails.each_side > 0)
            beside = inspect_hall(angle, rule,
                                  (Hall){.width = rule->least,
                                         .length = 6,
                                         .rail_low = rule->rails.each_side,
                                         .rail_high = rule->rails.each_side - off});
        if (rule->places.least > 0)
            inner = inspect_hall(angle, rule,
                                 (Hall){.width = rule->places.least,
                                        .length = rule->places.each + 1.5,
                                        .bay = rule->places.square + off});
        break;
    case RULE_TURNING_PLACE:
        verdict = inspect_hall(
            angle, rule, (Hall){.width = rule->least - 0.2, .length = rule->each + 1.5, .bay = rule->least + off});
        count = 1;
        break;
    case RULE_TURN_ROUND:
        drawing = draw_turn_round(angle, rule->least, rule->turn.at_turn + off);
        count = inspect(&drawing, rule, "", &verdict);
        drawing = draw_turn_round(angle, rule->least + off, rule->turn.at_turn);
        CHECK(inspect(&drawing, rule, "", &beside) == 1);
        drawing = draw_turn_round(angle, rule->least - 0.1, rule->turn.instead + off);
        CHECK(inspect(&drawing, rule, "", &inner) == 1);
        break;
    case RULE_DOOR_CLEAR: {
        Front front = usual_front(rule);
        front.width = rule->least + off;
        drawing = draw_door(angle, &front);
        count = inspect(&drawing, rule, "door d1", &verdict);
        break;
    }
    case RULE_MANOEUVRE:
        drawing = draw_space(angle, rule, off, false);
        count = inspect(&drawing, rule, "door d1", &verdict);
        if (rule->beyond > 0) {
            drawing = draw_space(angle, rule, off, true);
            CHECK(inspect(&drawing, rule, "door d1", &beside) == 1);
        }
        break;
    case RULE_LATCH_SPACE:
        drawing = draw_space(angle, rule, off, true);
        count = inspect(&drawing, rule, "door d1", &verdict);
        break;
    case RULE_TURNING_CIRCLE:
    case RULE_TURNING_SQUARE:
        drawing = draw_turning(angle, rule, rule->least + off);
        count = inspect(&drawing, rule, "room r1", &verdict);
        break;
    default:
        drawing = draw_corridor(angle, rule, 1.5, 0);
        count = inspect(&drawing, rule, "house", &verdict);
        expected = RULE_OPEN; /* no plan holds steps and ramps */
    }
    bool good = count == 1 && verdict == expected && (pillar < 0 || pillar == expected) &&
                (beside < 0 || beside == expected) && (inner < 0 || inner == expected);
    if (!good)
        printf("%s, %s, off by %+.3f m, turned by %g degrees: %zu findings, verdict %d, at a pillar %d, beside %d, "
               "within %d, expected %d\n",
               set->id, rule->id, off, angle, count, verdict, pillar, beside, inner, expected);
    CHECK(good);
}

static void check_limits(double angle) {
    RuleSets sets = {0};
    Fault fault = {0};
    CHECK(rule_set_read_all(&sets, scratch_source("assets/rules"), NULL, &fault));
    check_say(&fault);
    CHECK(sets.count >= 13);
    for (size_t s = 0; s < sets.count; s++)
        for (size_t r = 0; r < sets.sets[s].count; r++) {
            const Rule *rule = &sets.sets[s].rules[r];
            check_limit(&sets.sets[s], rule, angle, 0, RULE_PASSES);
            check_limit(&sets.sets[s], rule, angle, -0.002, RULE_FAILS);
            check_limit(&sets.sets[s], rule, angle, 0.002, RULE_PASSES);
        }
    rule_set_free_all(&sets);
}

TEST(a_house_at_the_limit_of_a_rule_passes_and_2_mm_below_fails) {
    check_limits(0);
}

TEST(a_house_turned_by_30_degrees_has_the_same_verdicts) {
    check_limits(30);
}

TEST(a_pillar_that_is_too_long_is_a_narrow_corridor) {
    Rule rule = {.id = "corridor",
                 .least = 0.9,
                 .most = -1,
                 .pillar = {.least = 0.7, .longest = 0.2},
                 .where = {.room = "", .not_room = "", .space_below = 100},
                 .clause = "",
                 .source = ""};
    int verdict = -1;
    Drawing drawing = draw_corridor(0, &rule, 1, 0.75);
    CHECK(inspect(&drawing, &rule, "corridor", &verdict) == 1 && verdict == RULE_FAILS);
    rule.pillar.longest = 0.25;
    drawing = draw_corridor(0, &rule, 1, 0.75);
    CHECK(inspect(&drawing, &rule, "corridor", &verdict) == 1 && verdict == RULE_PASSES);
}

TEST(the_way_between_places_for_turning_is_measured) {
    Rule rule = {.id = "place",
                 .what = RULE_TURNING_PLACE,
                 .least = 1.4,
                 .most = -1,
                 .each = 5,
                 .where = {.room = "", .not_room = "", .space_below = 100},
                 .clause = "",
                 .source = ""};
    /* From the bay's end to the end of the way, beyond the exit, there are some 4.8 m and 5.3 m. */
    CHECK(inspect_hall(0, &rule, (Hall){.width = 1.2, .length = 10.4, .bay = 1.4}) == RULE_PASSES);
    CHECK(inspect_hall(0, &rule, (Hall){.width = 1.2, .length = 11.4, .bay = 1.4}) == RULE_FAILS);
    /* The texts do not say whether a short corridor needs a place. */
    CHECK(inspect_hall(30, &rule, (Hall){.width = 1.2, .length = 5}) == RULE_OPEN);
    CHECK(inspect_hall(30, &rule, (Hall){.width = 1.2, .length = 6}) == RULE_FAILS);
    CHECK(inspect_hall(30, &rule, (Hall){.width = 1.5, .length = 20}) == RULE_PASSES);
}

TEST(a_turn_round_a_wide_obstacle_or_through_a_door_is_none) {
    Rule rule = {.id = "turn",
                 .what = RULE_TURN_ROUND,
                 .least = 1.065,
                 .most = -1,
                 .turn = {.at_turn = 1.22, .narrower = WALL - 0.01},
                 .where = {.room = "", .not_room = "", .space_below = 100},
                 .clause = "",
                 .source = ""};
    int verdict = -1;
    Drawing drawing = draw_turn_round(0, 1, 1);
    CHECK(inspect(&drawing, &rule, "", &verdict) == 0);
    rule.turn.narrower = 1.22;
    drawing = draw_turn_round(0, 1, 1);
    CHECK(inspect(&drawing, &rule, "", &verdict) == 1 && verdict == RULE_FAILS);
    drawing = draw_turn_round(0, 1, 1);
    add_wall(&drawing, "w6", 4, 0, 5, 0);
    add(&drawing, "doors",
        json_pack("{s:s, s:s, s:f, s:f, s:s}", "id", "d1", "wall", "w6", "at", 0.5, "width", 0.9, "kind", "opening"));
    CHECK(inspect(&drawing, &rule, "", &verdict) == 0);
}

TEST(a_verdict_that_rests_on_rails_is_known_no_better_than_their_number) {
    Rule rule = {.id = "corridor",
                 .least = 0.9,
                 .most = -1,
                 .rails = {.each_side = 0.1, .status = STATUS_KNOWN},
                 .where = {.room = "", .not_room = "", .space_below = 100},
                 .clause = "",
                 .source = ""};
    RuleSet set = {.id = "one", .rules = &rule, .count = 1};
    RuleSets sets = {.sets = &set, .count = 1};
    for (int rails = 0; rails < 2; rails++) {
        House house;
        Drawing drawing = draw_hall(30, &rule, &(Hall){.width = 1, .length = 6, .rail_low = rails ? 0.25 : 0});
        case_made(&house, drawing.plan, -1, NULL);
        Inspection inspection = inspection_make(&house, &sets, 1, NULL);
        CHECK(inspection.finding_count == 1 && inspection.findings[0].verdict == (rails ? RULE_FAILS : RULE_PASSES));
        CHECK(inspection.findings[0].status == (rails ? STATUS_KNOWN : STATUS_READ));
        CHECK_NEAR(inspection.findings[0].has, rails ? 0.85 : 1.0, 1e-5);
        CHECK_NEAR(vec2_distance(inspection.findings[0].from, inspection.findings[0].to), rails ? 0.85 : 1, 1e-5);
        inspection_free(&inspection);
        house_free(&house);
    }
}

TEST(furniture_narrows_a_corridor_only_beside_the_rule) {
    Rule rule = {.id = "corridor",
                 .least = 1,
                 .most = -1,
                 .where = {.room = "", .not_room = "", .space_below = 100},
                 .clause = "",
                 .source = ""};
    RuleSet set = {.id = "one", .rules = &rule, .count = 1};
    RuleSets sets = {.sets = &set, .count = 1};
    House house;
    Drawing drawing = draw_corridor(30, &rule, 1.2, 0);
    add(&drawing, "furniture",
        json_pack("{s:s, s:s, s:o, s:[f, f], s:f, s:f}", "id", "f1", "name", "shelf", "centre",
                  point(&drawing, 3, 0.45), "size", 0.8, 0.3, "angle", 30.0, "height", 1.0));
    case_made(&house, drawing.plan, -1, NULL);
    Inspection inspection = inspection_make(&house, &sets, 1, NULL);
    CHECK(inspection.finding_count == 1 && inspection.findings[0].verdict == RULE_PASSES);
    CHECK_NEAR(inspection.findings[0].has, 1.2, 1e-5);
    CHECK_NEAR(inspection.findings[0].furnished, 0.9, 1e-5);
    inspection_free(&inspection);
    house_free(&house);
}

TEST(the_corridor_of_0_78_m_is_legal_and_impassable) {
    RuleSets sets = {0};
    Fault fault = {0};
    House house;
    CHECK(rule_set_read_all(&sets, scratch_source("assets/rules"), "jp-senior-housing-1414", &fault));
    check_say(&fault);
    case_house(&house, "corner-0.78-0.78", -1, NULL);
    Inspection inspection = inspection_make(&house, &sets, 1, NULL);
    const Finding *finding = inspection_legal_impassable(&inspection);
    CHECK(finding && finding->rule->what == RULE_CORRIDOR_WIDTH && finding->status == STATUS_READ);
    CHECK(finding && inspection.places[finding->place].stopped == 1 && inspection.places[finding->place].carried == 0);
    inspection_free(&inspection);
    house_free(&house);
    case_house(&house, "corner-1.20-1.20", -1, NULL);
    inspection = inspection_make(&house, &sets, 1, NULL);
    CHECK(!inspection_legal_impassable(&inspection) && !inspection.counts[RULE_FAILS]);
    inspection_free(&inspection);
    house_free(&house);
    rule_set_free_all(&sets);
}

/* Only these were read; a number that becomes `read` must be added here by who has read it. */
TEST(nothing_is_called_read_that_was_not) {
    RuleSets sets = {0};
    Fault fault = {0};
    size_t read = 0;
    CHECK(rule_set_read_all(&sets, scratch_source("assets/rules"), NULL, &fault));
    for (size_t s = 0; s < sets.count; s++)
        for (size_t r = 0; r < sets.sets[s].count; r++) {
            const Rule *rule = &sets.sets[s].rules[r];
            bool ada = strcmp(sets.sets[s].id, "ada-2010") == 0;
            bool allowed = strcmp(sets.sets[s].id, "jp-senior-housing-1414") == 0 ||
                           (ada && (strcmp(rule->id, "step") == 0 || strcmp(rule->id, "turn-180") == 0));
            read += rule->status == STATUS_READ;
            CHECK(rule->status != STATUS_READ || allowed);
            CHECK(*rule->clause && *rule->source);
        }
    CHECK(read == 6);
    rule_set_free_all(&sets);
}

static void read_bad(const char *path, Fault *fault) {
    RuleSets sets = {0};
    CHECK(!rule_set_read(&sets, path, fault) && sets.count == 0);
    rule_set_free_all(&sets);
}

TEST(bad_files_are_refused_with_the_place) {
    scratch_check_faults("tests/data/bad/rules", read_bad);
}

TEST(unknown_rules_are_named_with_the_known_ones) {
    RuleSets sets = {0};
    Fault fault = {0};
    CHECK(!rule_set_read_all(&sets, scratch_source("assets/rules"), "ada-2010,ada", &fault));
    CHECK(fault.count == 1 && strstr(fault.lines[0], "there are no rules \"ada\"") &&
          strstr(fault.lines[0], "ada-2010, din-18040-2"));
    fault_clear(&fault);
    rule_set_free_all(&sets);
}
