#include "rules/rule_set.h"

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/choice.h"
#include "base/parameters_schema.h"
#include "base/text.h"
#include "rules/places.h"

static const double LARGEST = 100; /* m */
static const double NONE = -1;     /* of a limit that is absent */

#define TEXT_ROW(struct_, field_, needed_, meaning_)                                                                   \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_TEXT, .offset = offsetof(struct_, field_), .unit = "", .needed = needed_,   \
        .meaning = meaning_                                                                                            \
    }
#define CHOICE_ROW(struct_, field_, choices_, needed_, meaning_)                                                       \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_CHOICE, .offset = offsetof(struct_, field_), .unit = "",                    \
        .choices = choices_, .needed = needed_, .meaning = meaning_                                                    \
    }
#define LENGTH_ROW(struct_, field_, low_, fallback_, meaning_)                                                         \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_NUMBER, .offset = offsetof(struct_, field_), .unit = "m", .low = low_,      \
        .high = 100, .fallback = fallback_, .meaning = meaning_                                                        \
    }

static const Parameter where_rows[] = {
    TEXT_ROW(RuleWhere, room, false, "only in, or at doors of, rooms with this in their name or id"),
    TEXT_ROW(RuleWhere, not_room, false, "not in, nor at doors of, rooms with this in their name or id"),
    CHOICE_ROW(RuleWhere, doors, "all|inner|entrance", false, "only these doors; an entrance is next to an exit"),
    CHOICE_ROW(RuleWhere, kind, "any|hinged|sliding", false, "only doors of this kind"),
    CHOICE_ROW(RuleWhere, closer, "any|with|without", false, "only doors with a closer, or without one"),
    CHOICE_ROW(RuleWhere, approach, "any|front|hinge|latch", false,
               "only doors that are approached so; within 30 degrees of the normal is front"),
    CHOICE_ROW(RuleWhere, side, "both|pull|push", false, "only on this side; a leaf opens towards who pulls"),
    LENGTH_ROW(RuleWhere, space_least, 0, 0, "only where the space in front of the door is at least as deep"),
    LENGTH_ROW(RuleWhere, space_below, 0, 100, "only where the space in front of the door is less deep"),
};
static const ParameterTable where_table = {"where", where_rows, sizeof where_rows / sizeof *where_rows};

static const Parameter pillar_rows[] = {
    LENGTH_ROW(RulePillar, least, 0, 0, "width that is enough there; 0: no exception"),
    LENGTH_ROW(RulePillar, longest, 0, 0, "length of the way for which it is enough"),
};
static const ParameterTable pillar_table = {"at_pillar", pillar_rows, sizeof pillar_rows / sizeof *pillar_rows};

static const Parameter places_rows[] = {
    LENGTH_ROW(RulePlaces, least, 0, 0, "width that is enough with them; 0: no exception"),
    LENGTH_ROW(RulePlaces, square, 0, 0, "side of the free square"),
    LENGTH_ROW(RulePlaces, each, 0, 0, "length of the way in which there must be one"),
};
static const ParameterTable places_table = {"with_places", places_rows, sizeof places_rows / sizeof *places_rows};

static const Parameter rails_rows[] = {
    LENGTH_ROW(RuleRails, each_side, 0, 0, "depth on either side that does not narrow the corridor"),
    CHOICE_ROW(RuleRails, status, RULE_STATUS_WORDS, true, "how well that number is known"),
};
static const ParameterTable rails_table = {"reduces", rails_rows, sizeof rails_rows / sizeof *rails_rows};

static const Parameter turn_rows[] = {
    LENGTH_ROW(RuleTurn, at_turn, 0, 0, "width between the end of the obstacle and the wall opposite"),
    LENGTH_ROW(RuleTurn, instead, 0, 0, "width there that is enough by itself; 0: none is"),
    LENGTH_ROW(RuleTurn, narrower, 0, 0, "only round obstacles that are narrower"),
};
static const ParameterTable turn_table = {"around", turn_rows, sizeof turn_rows / sizeof *turn_rows};

/* A table within a rule. */
#define TABLE_ROW(name_, field_, table_, meaning_)                                                                     \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_TABLE, .offset = offsetof(Rule, field_), .unit = "", .table = table_,         \
        .meaning = meaning_                                                                                            \
    }

static const Parameter rule_rows[] = {
    {.name = "id",
     .kind = PARAMETER_ID,
     .offset = offsetof(Rule, id),
     .unit = "",
     .needed = true,
     .meaning = "name of the rule"},
    CHOICE_ROW(Rule, what, RULE_WHAT_WORDS, true, "what is measured"),
    LENGTH_ROW(Rule, least, -1, -1, "least dimension; -1: none"),
    LENGTH_ROW(Rule, most, -1, -1, "greatest dimension, or slope; -1: none"),
    LENGTH_ROW(Rule, beyond, 0, 0, "of a manoeuvring space: width beside the opening"),
    {.name = "at_hinge",
     .kind = PARAMETER_FLAG,
     .offset = offsetof(Rule, at_hinge),
     .unit = "",
     .meaning = "true if that width lies beside the hinge, not beside the latch"},
    LENGTH_ROW(Rule, each, 0, 0, "of turning places: length of the way in which there must be one"),
    TABLE_ROW("at_pillar", pillar, &pillar_table, "a narrower stretch that is allowed"),
    TABLE_ROW("with_places", places, &places_table, "a narrower corridor that is allowed with places for turning"),
    TABLE_ROW("reduces", rails, &rails_table, "rails, pieces with rail in their name or id, that do not count in full"),
    TABLE_ROW("around", turn, &turn_table, "of a turn_180: the turn itself"),
    TABLE_ROW("where", where, &where_table, "where the rule holds"),
    TEXT_ROW(Rule, clause, true, "clause of the text"),
    TEXT_ROW(Rule, source, true, "where the number was found"),
    CHOICE_ROW(Rule, status, RULE_STATUS_WORDS, true,
               "read: the text itself was read; read second-hand: a page about it; known: from memory; assumed"),
};
static const ParameterTable rule_table = {"rule", rule_rows, sizeof rule_rows / sizeof *rule_rows};

static const Parameter pay_rows[] = {
    CHOICE_ROW(RulePay, change, PLAN_WORK_WORDS, true, "the work that a change needs"),
    CHOICE_ROW(RulePay, pays, RULE_PAYS_WORDS, true, "whether it is paid for"),
    TEXT_ROW(RulePay, condition, false, "on which condition"),
    TEXT_ROW(RulePay, clause, true, "clause of the text"),
    TEXT_ROW(RulePay, source, true, "where that was found"),
    CHOICE_ROW(RulePay, status, RULE_STATUS_WORDS, true, "as of a rule"),
};
static const ParameterTable pay_table = {"pay", pay_rows, sizeof pay_rows / sizeof *pay_rows};

static const char *const file_keys[] = {"format", "version", "id",   "title", "jurisdiction", "applies", "edition",
                                        "note",   "rules",   "pays", NULL};

const RulePay *rule_set_pay(const RuleSet *set, int change) {
    for (size_t i = 0; i < set->pay_count; i++)
        if (set->pays[i].change == change)
            return &set->pays[i];
    return NULL;
}

const char *rule_set_pays_name(int pays) {
    static const char *const names[] = {"payable", "not listed"};
    return names[pays];
}

const char *rule_set_what_name(int what) {
    static const char *const names[RULE_WHATS] = {
        [RULE_CORRIDOR_WIDTH] = "corridor width",    [RULE_DOOR_CLEAR] = "door clear width",
        [RULE_MANOEUVRE] = "manoeuvring space",      [RULE_LATCH_SPACE] = "space beside the latch",
        [RULE_TURNING_CIRCLE] = "turning circle",    [RULE_TURNING_SQUARE] = "turning square",
        [RULE_TURNING_PLACE] = "places for turning", [RULE_TURN_ROUND] = "turn by 180 degrees",
        [RULE_STEP_HEIGHT] = "step height",          [RULE_SLOPE] = "slope",
    };
    return names[what];
}

const char *rule_set_status_name(int status) {
    static const char *const names[] = {"read", "read second-hand", "known", "assumed"};
    return names[status];
}

/* One file ----------------------------------------------------------------------------------------------------------
 */

static bool is_of_door(int what) {
    return what == RULE_DOOR_CLEAR || what == RULE_MANOEUVRE || what == RULE_LATCH_SPACE;
}

/* Checks what a rule says about places for turning and about rails. */
static void check_places(const Rule *rule, const JsonNode *node, Fault *fault) {
    const RulePlaces *places = &rule->places;
    bool corridor = rule->what == RULE_CORRIDOR_WIDTH, place = rule->what == RULE_TURNING_PLACE;
    if ((rule->each > 0) != place)
        json_fault(node, fault,
                   place ? "rule %s must have each, the metres of the way in which there must be a place"
                         : "rule %s has each, which only a turning_place has",
                   rule->id);
    if (places->least > 0 && !corridor)
        json_fault(node, fault, "rule %s has with_places, which only a corridor_width has", rule->id);
    else if (places->least > 0 && (places->least >= rule->least || places->square <= 0 || places->each <= 0))
        json_fault(
            node, fault,
            "rule %s must have with_places.least below %g m, and with_places.square and with_places.each above 0",
            rule->id, rule->least);
    if (fmax(places->square, place ? rule->least : 0) > PLACES_LARGEST)
        json_fault(node, fault, "rule %s has places of more than %g m, which are not looked for", rule->id,
                   PLACES_LARGEST);
    if (places->least > 0 && rule->pillar.least > 0)
        json_fault(node, fault, "rule %s has at_pillar and with_places, must have one of them", rule->id);
    if (rule->rails.each_side > 0 && !corridor)
        json_fault(node, fault, "rule %s has reduces, which only a corridor_width has", rule->id);
}

/* Checks what a rule says about a turn. */
static void check_turn(const Rule *rule, const JsonNode *node, Fault *fault) {
    const RuleTurn *turn = &rule->turn;
    bool around = turn->at_turn > 0 || turn->instead > 0 || turn->narrower > 0;
    if (rule->what != RULE_TURN_ROUND && around)
        json_fault(node, fault, "rule %s has around, which only a turn_180 has", rule->id);
    if (rule->what == RULE_TURN_ROUND && (turn->at_turn <= 0 || turn->narrower <= 0))
        json_fault(node, fault, "rule %s must have around.at_turn and around.narrower above 0", rule->id);
    if (rule->what == RULE_TURN_ROUND && turn->instead > 0 && turn->instead <= turn->at_turn)
        json_fault(node, fault, "rule %s must have around.instead above %g m, or none", rule->id, turn->at_turn);
}

/* Checks what a row alone does not say. */
static void check_rule(const Rule *rule, const JsonNode *node, Fault *fault) {
    bool least = rule->least >= 0, most = rule->most >= 0;
    bool tops = rule->what == RULE_STEP_HEIGHT || rule->what == RULE_SLOPE;
    if (least == most || most != tops)
        json_fault(node, fault, "rule %s must have %s, and nothing else as its limit", rule->id,
                   tops ? "most" : "least");
    if (rule->beyond > 0 && rule->what != RULE_MANOEUVRE)
        json_fault(node, fault, "rule %s has beyond, which only a manoeuvre has", rule->id);
    if (rule->pillar.least > 0 && rule->what != RULE_CORRIDOR_WIDTH)
        json_fault(node, fault, "rule %s has at_pillar, which only a corridor_width has", rule->id);
    if (rule->pillar.least > 0 && (rule->pillar.least >= rule->least || rule->pillar.longest <= 0))
        json_fault(node, fault, "rule %s must have at_pillar.least below %g m, and at_pillar.longest above 0", rule->id,
                   rule->least);
    check_places(rule, node, fault);
    check_turn(rule, node, fault);
    const RuleWhere *where = &rule->where;
    bool doors = where->doors || where->kind || where->approach || where->side || where->space_least > 0 ||
                 where->space_below < LARGEST;
    if (doors && !is_of_door(rule->what))
        json_fault(node, fault, "rule %s tells doors apart, but measures none", rule->id);
}

static void read_rule(RuleSet *set, const JsonNode *node, Arena *arena, Fault *fault) {
    Rule rule = {.least = NONE};
    size_t before = fault->total;
    if (!parameters_read(&rule_table, &rule, node, arena, fault))
        return;
    check_rule(&rule, node, fault);
    for (size_t i = 0; i < set->count; i++)
        if (strcmp(set->rules[i].id, rule.id) == 0)
            json_fault(node, fault, "rule %s occurs twice, must be unique", rule.id);
    if (fault->total == before)
        set->rules[set->count++] = rule;
}

static void read_pay(RuleSet *set, const JsonNode *node, Arena *arena, Fault *fault) {
    RulePay pay = {0};
    if (!parameters_read(&pay_table, &pay, node, arena, fault))
        return;
    if (rule_set_pay(set, pay.change))
        json_fault(node, fault, "this change occurs twice, must be unique");
    else
        set->pays[set->pay_count++] = pay;
}

/* Returns a list of the file, or a node without a value. A set must have one that is not empty. */
static JsonNode read_list(const JsonNode *root, const char *name, Fault *fault) {
    JsonNode list = json_member(root, name);
    if (!list.value || (json_is_array(list.value) && json_array_size(list.value)))
        return list;
    json_fault(&list, fault, "a file of rules must have \"%s\", a list [ ... ] of them", name);
    return (JsonNode){0};
}

static void read_set(RuleSet *set, const JsonNode *root, Arena *arena, Fault *fault) {
    static const Parameter id_row = {.name = "id", .kind = PARAMETER_ID, .unit = "", .needed = true};
    json_check_keys(root, file_keys, fault);
    size_t before = fault->total;
    JsonNode id = json_member(root, "id"), rules = read_list(root, "rules", fault),
             pays = read_list(root, "pays", fault);
    if (id.value)
        parameters_read_value(&id_row, &set->id, &id, arena, fault);
    else
        json_fault(root, fault, "a file of rules has no \"id\"");
    set->title = json_read_text(root, "title", arena, fault);
    set->jurisdiction = json_read_text(root, "jurisdiction", arena, fault);
    set->applies = json_read_text(root, "applies", arena, fault);
    set->edition = json_read_text(root, "edition", arena, fault);
    set->note = json_read_text(root, "note", arena, fault);
    if (!rules.value && !pays.value && fault->total == before)
        json_fault(root, fault, "a file of rules must have \"rules\", a list [ ... ] of them, or \"pays\"");
    set->rules = arena_allocate(arena, json_array_size(rules.value) * sizeof *set->rules);
    for (size_t i = 0; i < json_array_size(rules.value); i++) {
        JsonNode rule = json_element(&rules, i);
        read_rule(set, &rule, arena, fault);
    }
    set->pays = arena_allocate(arena, json_array_size(pays.value) * sizeof *set->pays);
    for (size_t i = 0; i < json_array_size(pays.value); i++) {
        JsonNode pay = json_element(&pays, i);
        read_pay(set, &pay, arena, fault);
    }
}

bool rule_set_read(RuleSets *sets, const char *path, Fault *fault) {
    size_t before = fault->total;
    JsonFile file = {0};
    RuleSet set = {0};
    if (!json_read(&file, path, fault))
        return false;
    JsonNode root = json_root(&file);
    if (json_check_header(&root, "file of rules", "clearance-rules", fault))
        read_set(&set, &root, &sets->arena, fault);
    for (size_t i = 0; i < sets->count && fault->total == before; i++)
        if (strcmp(sets->sets[i].id, set.id) == 0)
            json_fault(&root, fault, "the set %s has been read already", set.id);
    json_free(&file);
    if (fault->total != before)
        return false;
    sets->sets = memory_reserve(sets->sets, &sets->capacity, sets->count + 1, sizeof *sets->sets);
    sets->sets[sets->count++] = set;
    return true;
}

/* Several files -----------------------------------------------------------------------------------------------------
 */

static bool ends_in_json(const char *name) {
    size_t length = strlen(name);
    return length > 5 && strcmp(name + length - 5, ".json") == 0;
}

static int is_json(const struct dirent *entry) {
    return ends_in_json(entry->d_name);
}

static void read_folder(RuleSets *sets, const char *folder, Fault *fault) {
    struct dirent **entries;
    int count = scandir(folder, &entries, is_json, alphasort);
    if (count < 0)
        fault_add(fault, "%s:1:1: cannot be read: %s", folder, strerror(errno));
    for (int i = 0; i < count; i++) {
        Text path = {0};
        text_format(&path, "%s/%s", folder, entries[i]->d_name);
        rule_set_read(sets, path.text, fault);
        memory_free(path.text);
        free(entries[i]);
    }
    if (count >= 0)
        free(entries);
}

/* Adds "unknown set of rules", with the ids of the folder. */
static void fault_unknown(const char *folder, const char *name, Fault *fault) {
    struct dirent **entries;
    int count = scandir(folder, &entries, is_json, alphasort);
    Text known = {0};
    for (int i = 0; i < count; i++) {
        text_format(&known, "%s%.*s", i ? ", " : "", (int)strlen(entries[i]->d_name) - 5, entries[i]->d_name);
        free(entries[i]);
    }
    if (count >= 0)
        free(entries);
    fault_add(fault, "--rules: there are no rules \"%s\", must be a file or one of: %s", name,
              known.text ? known.text : "none");
    memory_free(known.text);
}

static void read_one(RuleSets *sets, const char *folder, const char *name, Fault *fault) {
    if (strchr(name, '/') || ends_in_json(name)) {
        rule_set_read(sets, name, fault);
        return;
    }
    Text path = {0};
    text_format(&path, "%s/%s.json", folder, name);
    if (text_read_refusal(path.text) == ENOENT)
        fault_unknown(folder, name, fault);
    else
        rule_set_read(sets, path.text, fault);
    memory_free(path.text);
}

bool rule_set_read_all(RuleSets *sets, const char *folder, const char *names, Fault *fault) {
    size_t before = fault->total;
    if (!names)
        read_folder(sets, folder, fault);
    char *list = names ? text_copy(names) : NULL, *rest = list, *name;
    while (list && (name = strsep(&rest, ",")))
        read_one(sets, folder, name, fault);
    memory_free(list);
    return fault->total == before;
}

void rule_set_free_all(RuleSets *sets) {
    memory_free(sets->sets);
    arena_clear(&sets->arena);
    *sets = (RuleSets){0};
}

json_t *rule_set_schema(void) {
    json_t *rules =
        json_pack("{s:s, s:i, s:o}", "type", "array", "minItems", 1, "items", parameters_schema_table(&rule_table));
    json_t *pays =
        json_pack("{s:s, s:i, s:o}", "type", "array", "minItems", 1, "items", parameters_schema_table(&pay_table));
    json_t *properties =
        json_pack("{s:{s:s}, s:{s:i}, s:{s:s, s:s}, s:{s:s}, s:{s:s}, s:{s:s}, s:{s:s}, s:{s:s}, s:o, s:o}", "format",
                  "const", "clearance-rules", "version", "const", 1, "id", "type", "string", "pattern",
                  "^[A-Za-z0-9_-]+$", "title", "type", "string", "jurisdiction", "type", "string", "applies", "type",
                  "string", "edition", "type", "string", "note", "type", "string", "rules", rules, "pays", pays);
    return json_pack("{s:s, s:s, s:s, s:o, s:[s, s, s], s:[{s:[s]}, {s:[s]}], s:b}", "$schema",
                     "https://json-schema.org/draft/2020-12/schema", "title", "rules of accessibility", "type",
                     "object", "properties", properties, "required", "format", "version", "id", "anyOf", "required",
                     "rules", "required", "pays", "additionalProperties", 0);
}
