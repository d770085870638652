#include "result/names.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/text.h"
#include "house/hazard.h"
#include "plan/plan_geometry.h"
#include "result/census.h"

#define BESIDE 0.25     /* m, from a wall's face to the place that must lie in a room */
#define BESIDE_WALL 0.6 /* m, from a contact with a wall to the room that the wall belongs to */
#define OUTSIDE 1.0     /* m, from a door to the exit that it leads to */
#define LETTERS 26

/* Doors ------------------------------------------------------------------------------------------------------------ */

static bool room_holds(const Room *room, Vec2 p) {
    bool inside = false;
    const Points *outline = &room->outline;
    for (size_t i = 0, j = outline->count - 1; i < outline->count; j = i++) {
        Vec2 a = outline->at[i], b = outline->at[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

static double area_of(const Room *room) {
    double twice = 0;
    const Points *outline = &room->outline;
    for (size_t i = 0; i < outline->count; i++)
        twice += vec2_cross(outline->at[i], outline->at[(i + 1) % outline->count]);
    return fabs(twice) / 2;
}

/* True for rooms that lead to others: those do not give doors their names. */
static bool is_way(const Room *room) {
    static const char *const words[] = {"corridor", "hall", "passage", "entrance", "genkan", "lobby", "street"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strstr(room->name, words[i]))
            return true;
    return false;
}

static const Room *room_at(const Plan *plan, Vec2 at) {
    const Room *found = NULL;
    for (size_t r = 0; r < plan->room_count; r++)
        if (*plan->rooms[r].name && room_holds(&plan->rooms[r], at) &&
            (!found || area_of(&plan->rooms[r]) < area_of(found)))
            found = &plan->rooms[r];
    return found;
}

const char *names_room(const Plan *plan, Vec2 at) {
    const Room *room = room_at(plan, at);
    return room ? room->name : NULL;
}

/* A door between two rooms; NULL: outside, or a room without a name. */
typedef struct Passage {
    Vec2 middle;
    Vec2 out; /* from the room that names it through the door */
    const Room *room, *other;
} Passage;

static Passage passage_of(const Plan *plan, const Door *door) {
    Vec2 from, to;
    plan_geometry_door_ends(plan, door, &from, &to);
    Passage passage = {.middle = vec2_scale(vec2_add(from, to), 0.5)};
    Vec2 left = vec2_left(vec2_unit(vec2_sub(to, from)));
    double reach = plan->walls[door->wall_index].thickness / 2 + BESIDE;
    const Room *sides[] = {room_at(plan, vec2_along(passage.middle, reach, left)),
                           room_at(plan, vec2_along(passage.middle, -reach, left))};
    bool second = sides[1] && (!sides[0] || is_way(sides[0]) > is_way(sides[1]) ||
                               (is_way(sides[0]) == is_way(sides[1]) && area_of(sides[1]) < area_of(sides[0])));
    passage.room = sides[second];
    passage.other = sides[!second];
    passage.out = vec2_scale(left, second ? 1 : -1);
    return passage;
}

/* Returns the exit that lies at a place, or NULL. */
static const Exit *exit_at(const Plan *plan, Vec2 at) {
    for (size_t e = 0; e < plan->exit_count; e++)
        if (vec2_distance(vec2_nearest_on_segment(at, plan->exits[e].from, plan->exits[e].to), at) < OUTSIDE)
            return &plan->exits[e];
    return NULL;
}

/* Returns how a door differs from the others of its room: by the other room, otherwise by the side on which it lies,
 * seen from inside; NULL: by neither. "": there are no others. */
static const char *difference(const Plan *plan, size_t door, const Passage *passage, Arena *arena) {
    size_t others = 0, alike = 0;
    double side = 0;
    for (size_t d = 0; d < plan->door_count; d++) {
        Passage other = passage_of(plan, &plan->doors[d]);
        if (d == door || other.room != passage->room)
            continue;
        others++;
        if (other.other != passage->other)
            continue;
        alike++;
        side = vec2_cross(passage->out, vec2_sub(passage->middle, other.middle));
    }
    if (!others)
        return "";
    if (!alike)
        return passage->other ? text_in_arena(arena, " to %s", passage->other->name) : " outside";
    return alike > 1 || fabs(side) < BESIDE ? NULL : side > 0 ? ", left" : ", right";
}

const char *names_door(const Plan *plan, size_t door, Arena *arena) {
    const char *id = plan->doors[door].id;
    Passage passage = passage_of(plan, &plan->doors[door]);
    const Exit *exit = passage.room && passage.other ? NULL : exit_at(plan, passage.middle);
    if (exit)
        return plan->exit_count > 1 ? text_in_arena(arena, "%s door", exit->id) : "exit door";
    const char *more = passage.room ? difference(plan, door, &passage, arena) : NULL;
    if (!more)
        return text_in_arena(arena, "door %s", id);
    return text_in_arena(arena, "%s door%s", passage.room->name, more);
}

/* People ----------------------------------------------------------------------------------------------------------- */

/* Returns how many people have the person's route, and counts those of them before. */
static size_t count_on_route(const House *house, size_t person, size_t *before) {
    size_t all = 0;
    *before = 0;
    for (size_t i = 0; i < house->person_count; i++) {
        bool same = house->people[i].route == house->people[person].route;
        all += same;
        *before += same && i < person;
    }
    return all;
}

const char *names_person(const House *house, size_t person, Arena *arena) {
    const Inhabitant *who = &house->people[person];
    if (who->route && strlen(who->route->id) <= 2) {
        size_t before, all = count_on_route(house, person, &before);
        return all > 1 ? text_in_arena(arena, "%s-%zu", who->route->id, before + 1)
                       : text_in_arena(arena, "%s", who->route->id);
    }
    if (house->person_count > LETTERS)
        return text_in_arena(arena, "person %zu", person + 1);
    return text_in_arena(arena, "%c", (char)('A' + person));
}

const char *names_profile(const char *profile) {
    static const char *const words[][2] = {{"manual-chair", "wheelchair"},
                                           {"electric-chair", "powered wheelchair"},
                                           {"assisted-chair", "wheelchair with a helper"},
                                           {"miura-chair", "round chair"},
                                           {"elderly", "older adult"},
                                           {"crutches", "with crutches"},
                                           {"rollator", "with a walking frame"}};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(words[i][0], profile) == 0)
            return words[i][1];
    return profile;
}

/* Texts ------------------------------------------------------------------------------------------------------------ */

static const char ENDS[] = " ,;:()\n"; /* of a word */

typedef struct Word {
    const char *at;
    size_t length;
} Word;

static Word word_at(const char *text) {
    return (Word){text, strcspn(text, ENDS)};
}

static bool is_word(Word word, const char *text) {
    return word.length == strlen(text) && memcmp(word.at, text, word.length) == 0;
}

/* Returns the word behind a word and one space; empty: there is none. */
static Word word_behind(Word word) {
    const char *end = word.at + word.length;
    return *end == ' ' ? word_at(end + 1) : (Word){end, 0};
}

static size_t door_called(const Plan *plan, Word word) {
    size_t d = 0;
    while (d < plan->door_count && !is_word(word, plan->doors[d].id))
        d++;
    return d;
}

/* Returns the index of a person, SIZE_MAX: there is none. */
static size_t person_called(const House *house, Word word) {
    for (size_t i = 0; house && house->person_count <= CENSUS_FEW && i < house->person_count; i++)
        if (is_word(word, house->people[i].id))
            return i;
    return SIZE_MAX;
}

static bool is_wall(const Plan *plan, Word word) {
    for (size_t w = 0; w < plan->wall_count; w++)
        if (is_word(word, plan->walls[w].id))
            return true;
    return false;
}

static bool is_piece(const Plan *plan, Word word) {
    for (size_t f = 0; f < plan->furniture_count; f++)
        if (is_word(word, plan->furniture[f].id))
            return true;
    return false;
}

/* True if a piece of furniture is named here. */
static bool begins_piece(const Plan *plan, const char *at) {
    for (size_t f = 0; f < plan->furniture_count; f++) {
        const char *name = *plan->furniture[f].name ? plan->furniture[f].name : plan->furniture[f].id;
        size_t length = strlen(name);
        if (strncmp(at, name, length) == 0 && (!at[length] || strchr(ENDS, at[length])))
            return true;
    }
    return false;
}

/* Adds "the " where a sentence goes on with a thing. */
static void add_article(Text *text) {
    static const char *const before[] = {" pass ", " at ", " overlaps ", " end of ", " m in "};
    for (size_t i = 0; i < sizeof before / sizeof *before; i++) {
        size_t length = strlen(before[i]);
        if (text->used >= length && strcmp(text->text + text->used - length, before[i]) == 0)
            text_add(text, "the ");
    }
}

/* Adds the name that a word and the one behind it stand for; returns the end of what it stands for. */
static const char *add_name(Text *text, const Plan *plan, const House *house, Word word, Arena *arena) {
    Word next = word_behind(word);
    const char *end = word.at + word.length, *next_end = next.at + next.length;
    size_t door = is_word(word, "door") ? door_called(plan, next) : plan->door_count;
    size_t person = person_called(house, is_word(word, "person") ? next : word);
    if (door < plan->door_count) {
        add_article(text);
        text_add(text, names_door(plan, door, arena));
        return next_end;
    }
    if (is_word(word, "wall") && next.length && is_wall(plan, next)) {
        add_article(text);
        text_add(text, "wall");
        return next_end;
    }
    if (is_word(word, "furniture") && next.length && is_piece(plan, next)) {
        text_add(text, "furniture");
        return next_end;
    }
    if (person != SIZE_MAX && (word.length > 1 || is_word(word, "person"))) {
        text_add(text, names_person(house, person, arena));
        return is_word(word, "person") ? next_end : end;
    }
    if (begins_piece(plan, word.at))
        add_article(text);
    text_format(text, "%.*s", (int)word.length, word.at);
    return end;
}

const char *names_text(const House *house, const char *text, Arena *arena) {
    return names_plan_text(&house->plan, house, text, arena);
}

const char *names_plan_text(const Plan *plan, const House *house, const char *text, Arena *arena) {
    Text named = {0};
    for (const char *at = text; *at;) {
        Word id = *at == ' ' && at[1] == '(' ? word_at(at + 2) : (Word){at, 0};
        if (id.length && id.at[id.length] == ')' && is_piece(plan, id)) {
            at = id.at + id.length + 1; /* "chest (f12)" */
        } else if (strchr(ENDS, *at)) {
            text_format(&named, "%c", *at++);
        } else {
            at = add_name(&named, plan, house, word_at(at), arena);
        }
    }
    const char *kept = text_in_arena(arena, "%s", named.text ? named.text : "");
    memory_free(named.text);
    return kept;
}

static Box room_box(const Plan *plan, const char *room) {
    Box box = box_empty();
    for (size_t i = 0; i < plan->room_count; i++)
        for (size_t p = 0; strcmp(plan->rooms[i].name, room) == 0 && p < plan->rooms[i].outline.count; p++)
            box = box_include(box, plan->rooms[i].outline.at[p]);
    return box;
}

static Box walls_box(const Plan *plan) {
    Box box = box_empty();
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t p = 0; p < plan->walls[w].points.count; p++)
            box = box_include(box, plan->walls[w].points.at[p]);
    return box;
}

/* Returns the side of a box, as the plan is drawn, at which a place lies. */
static const char *side_of(Box box, Vec2 at) {
    double left = fabs(at.x - box.low.x), right = fabs(at.x - box.high.x);
    double lower = fabs(at.y - box.low.y), upper = fabs(at.y - box.high.y);
    if (fmin(left, right) < fmin(lower, upper))
        return left < right ? "left" : "right";
    return lower < upper ? "lower" : "upper";
}

/* Returns the name of a place where nothing is near. */
static const char *open_name(const House *house, Vec2 at, Arena *arena) {
    const char *room = names_room(&house->plan, at);
    for (size_t i = 0; i < house->person_count; i++)
        if (vec2_distance(house->people[i].at, at) < HAZARD_RADIUS)
            return "the start";
    return room ? text_in_arena(arena, "open floor of %s", room) : "open floor";
}

const char *names_thing(const House *house, const char *thing, Vec2 at, Arena *arena) {
    enum { WAYS = 8 };
    if (strcmp(thing, OUTLINE_FREE_SPACE) == 0)
        return open_name(house, at, arena);
    const char *name = names_text(house, thing, arena), *room = names_room(&house->plan, at);
    for (int way = 0; way < WAYS && !room; way++)
        room = names_room(&house->plan, vec2_along(at, BESIDE_WALL, vec2_heading(2 * M_PI * way / WAYS)));
    if (strcmp(name, "wall") != 0)
        return name;
    if (room)
        return text_in_arena(arena, "%s wall of %s", side_of(room_box(&house->plan, room), at), room);
    Box walls = walls_box(&house->plan);
    bool inner = box_holds(box_expand(walls, -BESIDE_WALL), at);
    return inner ? name : text_in_arena(arena, "%s wall", side_of(walls, at));
}

/* Returns "wall between bedroom and corridor", "left wall of bedroom", or "wall" without a named room. */
static const char *segment_name(const Plan *plan, Vec2 from, Vec2 to, double thickness, Vec2 at, Arena *arena) {
    Vec2 foot = vec2_nearest_on_segment(at, from, to), left = vec2_left(vec2_unit(vec2_sub(to, from)));
    double reach = thickness / 2 + BESIDE;
    const char *a = names_room(plan, vec2_along(foot, reach, left)),
               *b = names_room(plan, vec2_along(foot, -reach, left));
    if (a && b && strcmp(a, b) != 0)
        return text_in_arena(arena, "wall between %s and %s", a, b);
    if (a && b)
        return text_in_arena(arena, "wall in %s", a);
    const char *room = a ? a : b;
    return room ? text_in_arena(arena, "%s wall of %s", side_of(room_box(plan, room), foot), room) : "wall";
}

const char *names_wall_at(const Plan *plan, size_t wall, Vec2 at, Arena *arena) {
    const Points *points = &plan->walls[wall].points;
    double nearest = HUGE_VAL;
    size_t segment = 0;
    for (size_t i = 0; i + 1 < points->count; i++) {
        double away = vec2_distance(at, vec2_nearest_on_segment(at, points->at[i], points->at[i + 1]));
        segment = away < nearest ? i : segment;
        nearest = fmin(nearest, away);
    }
    return segment_name(plan, points->at[segment], points->at[segment + 1], plan->walls[wall].thickness, at, arena);
}

const char *names_wall(const Plan *plan, size_t wall, Arena *arena) {
    const Points *points = &plan->walls[wall].points;
    const char *name = NULL;
    enum { PARTS = 5 }; /* places looked at along each segment */
    for (size_t i = 0; i + 1 < points->count; i++)
        for (int part = 0; part < PARTS; part++) {
            Vec2 way = vec2_sub(points->at[i + 1], points->at[i]);
            const char *own = names_wall_at(plan, wall, vec2_along(points->at[i], (part + 0.5) / PARTS, way), arena);
            if (name && strcmp(name, own) != 0)
                return "wall";
            name = own;
        }
    return name ? name : "wall";
}

const char *names_number(const char *label) {
    static const char *const words[][2] = {{"changes of direction", "back and forth"},
                                           {"narrowest clearance", "least room to spare"},
                                           {"narrowest at", "least room at"},
                                           {"contacts", "touches"},
                                           {"hardest contact", "hardest touch"},
                                           {"personal space entered", "personal space pressed for"},
                                           {"lost time", "time lost"},
                                           {"profile", "who"}};
    for (size_t i = 0; label && i < sizeof words / sizeof *words; i++)
        if (strcmp(words[i][0], label) == 0)
            return words[i][1];
    return label;
}
