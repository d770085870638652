#include "laboratory/house/values.h"

#include <ctype.h>
#include <string.h>

#include "base/choice.h"
#include "base/parameters_number.h"
#include "laboratory/house_items.h"
#include "result/names.h"

/* A parameter of the plan that is offered, with the useful part of its range. */
typedef struct Offer {
    const char *name;  /* name in the parameter table */
    const char *label; /* NULL: the name */
    double low, high;  /* in the row's unit; low == high: around the value in the file */
} Offer;

static const Offer door_offers[] = {{"width", "width", 0.5, 1.5},
                                    {"at", "place along the wall", 0, 0},
                                    {"kind", "kind", 0, 0},
                                    {"hinge", "hinge at the wall's", 0, 0},
                                    {"swing", "opens to the wall's", 0, 0},
                                    {"state", "state", 0, 0},
                                    {"opening_time", "opening time", 0, 10},
                                    {"leaf", "thickness of the leaf", 0, 0.1},
                                    {"rest", "leaf stays in the way by", 0, 0.3},
                                    {"closer", "closes by itself", 0, 0}};
static const Offer furniture_offers[] = {{"centre.x", "place, x", 0, 0},
                                         {"centre.y", "place, y", 0, 0},
                                         {"angle", "angle", -180, 180},
                                         {"size.x", "width", 0, 0},
                                         {"size.y", "depth", 0, 0},
                                         {"height", "height", 0, 0},
                                         {"probability", "falls with probability", 0, 1},
                                         {"topples", "falls to", 0, 0},
                                         {"toppled", "fallen", 0, 0}};
static const Offer wall_offers[] = {{"thickness", "thickness", 0, 0.5}, {"height", "height", 0, 0}};
static const Offer exit_offers[] = {{"opens", "opens at", 0, 60}};
static const Offer person_offers[] = {{"delay", "delay", 0, 30},
                                      {"speed", "free speed (0: usual)", 0, 2},
                                      {"at.x", "start, x", 0, 0},
                                      {"at.y", "start, y", 0, 0},
                                      {"heading", "heading at the start", -180, 180}};
static const Offer crowd_offers[] = {{"count", "people", 0, 0}, {"delay", "delay", 0, 60}};
static const Offer run_offers[] = {{"routes", "routes", 0, 0},
                                   {"until", "time limit", 0, 0},
                                   {"patience", "patience", 0, 0},
                                   {"clearance_warning", "warning: clearance below", 0, 0.2},
                                   {"force_warning", "warning: force above", 0, 0},
                                   {"loss_warning", "warning: lost time above", 0, 0},
                                   {"reversals", "maximum changes of direction", 0, 10},
                                   {"cell", "cell of the route search", 0, 0},
                                   {"sample", "time between records", 0, 0},
                                   {"dt", "time step", 0, 0}};

/* Numbers of a profile that most people want to change. */
static const char *const key_rows[] = {"body.length", "body.width", "drive.free_speed", "space.reach"};

enum { KEY_DOORS = 6 /* number of doors whose widths are shown by default */ };

#define AROUND 1.0      /* m, half the range of a slider for a place */
#define DECADE 10.0     /* factor up and down of a logarithmic slider */
#define STIFF_FROM 10.0 /* a parameter larger than this, with a range of several decades, has a logarithmic slider */

#define COUNT(array_) (sizeof(array_) / sizeof *(array_))

/* The list -------------------------------------------------------------------------------------------------------- */

static const char *sentence(Arena *arena, const char *text) {
    return text_in_arena(arena, "%c%s.", toupper((unsigned char)*text), text + 1);
}

/* True for stiffnesses, dampings and similar parameters that span decades. */
static bool spans_decades(const Parameter *row, double value) {
    return row->kind == PARAMETER_NUMBER && value >= STIFF_FROM && row->high >= 1e5 && strcmp(row->unit, "m") != 0 &&
           strcmp(row->unit, "s") != 0;
}

/* True for places on the floor or along a wall. */
static bool is_place(const Offer *offer) {
    size_t length = offer ? strlen(offer->name) : 0;
    return length && strncmp(offer->name, "size", 4) != 0 &&
           (strcmp(offer->name, "at") == 0 || strcmp(offer->name + length - 2, ".x") == 0 ||
            strcmp(offer->name + length - 2, ".y") == 0);
}

static void set_range(PanelParameter *parameter, const Offer *offer) {
    const Parameter *row = parameter->row;
    double value = parameter->initial;
    parameter->low = value / 2;
    parameter->high = value > 0 ? 2 * value : 1;
    if (offer && offer->low < offer->high) {
        parameter->low = fmin(offer->low, value);
        parameter->high = fmax(offer->high, 1.5 * value);
    } else if (is_place(offer)) {
        parameter->low = value - AROUND;
        parameter->high = value + AROUND;
    } else if (spans_decades(row, value)) {
        parameter->logarithmic = true;
        parameter->low = value / DECADE;
        parameter->high = value * DECADE;
    } else if (row->kind == PARAMETER_WHOLE) {
        parameter->low = floor(parameter->low);
        parameter->high = ceil(fmax(parameter->high, value + 1));
    }
    parameter->low = fmax(parameter->low, row->low);
    parameter->high = fmin(parameter->high, row->high);
}

/* Adds the parameter called `name` if the house has it. */
static PanelParameter *add_value(HouseValues *values, const House *house, const char *name, const Offer *offer,
                                 ValueOwner owner) {
    Fault fault = {0};
    const void *object;
    const Parameter *row = house_parameter(house, name, &object, "", &fault);
    fault_clear(&fault);
    double value = row ? parameters_number_get(row, object) : NAN;
    if (!isfinite(value))
        return NULL;
    values->owners = memory_reserve(values->owners, &values->owner_capacity, values->count + 1, sizeof owner);
    values->rows = memory_reserve(values->rows, &values->capacity, values->count + 1, sizeof *values->rows);
    values->owners[values->count] = owner;
    PanelParameter *parameter = &values->rows[values->count++];
    *parameter = (PanelParameter){.name = name,
                                  .row = row,
                                  .label = offer && offer->label ? offer->label : row->meaning,
                                  .meaning = sentence(&values->arena, row->meaning),
                                  .value = value,
                                  .initial = value};
    if (row->provenance && !row->needed && value == row->fallback && *row->provenance)
        parameter->provenance = row->provenance;
    if (row->kind == PARAMETER_NUMBER || row->kind == PARAMETER_WHOLE)
        set_range(parameter, offer);
    return parameter;
}

/* True if a value of a door has no effect on one of its kind. */
static bool is_idle(const Door *door, const char *name) {
    bool leafless = door->kind == DOOR_OPENING, slides = door->kind == DOOR_SLIDING;
    if (strcmp(name, "swing") == 0 || strcmp(name, "leaf") == 0)
        return leafless || slides;
    if (strcmp(name, "hinge") == 0)
        return leafless || (slides && door->rest == 0);
    if (strcmp(name, "rest") == 0)
        return !slides;
    return strcmp(name, "opening_time") == 0 && door->state != DOOR_CLOSED;
}

/* Adds the values of one item of the plan: KIND.ID.NAME. */
static void add_offers(HouseValues *values, const House *house, const char *kind, const char *id, const char *group,
                       ValueOwner owner, const Offer *offers, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const char *name = text_in_arena(&values->arena, "%s.%s.%s", kind, id, offers[i].name);
        PanelParameter *parameter = add_value(values, house, name, &offers[i], owner);
        if (!parameter)
            continue;
        parameter->group = group;
        const char *row = offers[i].name;
        if (owner.item.kind == HOUSE_DOOR)
            parameter->idle = is_idle(&house->plan.doors[owner.item.index], row);
        else if (owner.item.kind == HOUSE_FURNITURE) /* what does not fall has no probability */
            parameter->idle =
                strcmp(row, "probability") == 0 && house->plan.furniture[owner.item.index].topples == TOPPLE_NO;
    }
}

static void add_items(HouseValues *values, const House *house, int kind, const char *word, const Offer *offers,
                      size_t offer_count) {
    for (size_t i = 0; i < house_item_count(house, NULL, kind); i++) {
        Item item = {kind, i};
        char name[HOUSE_ITEM_NAME];
        if (kind == HOUSE_PERSON && plan_find_person(&house->plan, house->people[i].id) == SIZE_MAX)
            continue; /* a person of a crowd has no parameters of its own */
        house_item_name(house, NULL, item, name, sizeof name);
        *name = (char)toupper((unsigned char)*name);
        add_offers(values, house, word, house_item_id(house, item), arena_text(&values->arena, name),
                   (ValueOwner){.item = item, .key = kind == HOUSE_DOOR && i < KEY_DOORS}, offers, offer_count);
    }
}

static void add_people(HouseValues *values, const House *house) {
    add_items(values, house, HOUSE_PERSON, "person", person_offers, COUNT(person_offers));
    for (size_t c = 0; c < house->plan.crowd_count; c++) {
        const char *id = house->plan.crowds[c].id;
        add_offers(values, house, "crowd", id, text_in_arena(&values->arena, "Crowd %s", id), (ValueOwner){.key = true},
                   crowd_offers, COUNT(crowd_offers));
    }
}

static const char *part_of_profile(const char *name) {
    static const char *const parts[][2] = {
        {"body.", "body"}, {"drive.", "driving"}, {"space.", "space"}, {"contact.", "contact"}};
    for (size_t i = 0; i < COUNT(parts); i++)
        if (strncmp(name, parts[i][0], strlen(parts[i][0])) == 0)
            return parts[i][1];
    return "";
}

/* Returns "free speed" for "drive.free_speed". */
static const char *leaf_words(Arena *arena, const char *name) {
    char *text = arena_allocate(arena, strlen(name) + 1);
    strcpy(text, strchr(name, '.') + 1);
    for (char *at = text; *at; at++)
        *at = *at == '_' ? ' ' : *at;
    return text;
}

static void add_profile(HouseValues *values, const House *house, const Profile *profile) {
    const ParameterTable *table = profile_table();
    const char *word = names_profile(profile->name);
    char *what = arena_allocate(&values->arena, strlen(word) + 1);
    strcpy(what, word);
    *what = (char)toupper((unsigned char)*what);
    for (size_t r = 0; r < table->count; r++) {
        if (!profile_row_matters(r, profile->driving))
            continue;
        const char *row = table->rows[r].name;
        ValueOwner owner = {.profile = arena_text(&values->arena, profile->name)};
        for (size_t k = 0; k < COUNT(key_rows); k++)
            owner.key = owner.key || strcmp(row, key_rows[k]) == 0;
        const char *name = text_in_arena(&values->arena, "profile.%s.%s", profile->name, row);
        PanelParameter *parameter = add_value(values, house, name, NULL, owner);
        if (!parameter)
            continue;
        parameter->label = leaf_words(&values->arena, row);
        parameter->group = text_in_arena(&values->arena, "%s: %s", what, part_of_profile(row));
        parameter->provenance = arena_text(&values->arena, profile->provenance[r]);
    }
}

/* Lists the rows as they are, until they are sorted for a selection. */
static void list_in_order(HouseValues *values) {
    for (size_t i = 0; i < values->count; i++)
        values->listed[i] = values->rows[i];
}

void house_value_list(HouseValues *values, const House *house) {
    for (size_t k = 0; k < house->profile_count; k++)
        add_profile(values, house, &house->profiles[k]);
    add_items(values, house, HOUSE_DOOR, "door", door_offers, COUNT(door_offers));
    add_people(values, house);
    add_items(values, house, HOUSE_FURNITURE, "furniture", furniture_offers, COUNT(furniture_offers));
    add_items(values, house, HOUSE_WALL, "wall", wall_offers, COUNT(wall_offers));
    add_items(values, house, HOUSE_EXIT, "exit", exit_offers, COUNT(exit_offers));
    for (size_t i = 0; i < COUNT(run_offers); i++) {
        PanelParameter *parameter =
            add_value(values, house, text_in_arena(&values->arena, "run.%s", run_offers[i].name), &run_offers[i],
                      (ValueOwner){.key = false});
        parameter->group = "Run";
    }
    values->listed = memory_zeroed(values->count, sizeof *values->listed);
    list_in_order(values);
}

void house_value_rebuild(HouseValues *values, const HouseValues *opened, const House *house) {
    house_value_clear(values);
    house_value_list(values, house);
    for (size_t i = 0, next = 0; i < values->count; i++) {
        PanelParameter *parameter = &values->rows[i];
        /* most rows are in the same order */
        size_t at = next < opened->count && strcmp(opened->rows[next].name, parameter->name) == 0
                        ? next
                        : house_value_find(opened, parameter->name);
        if (at == SIZE_MAX)
            continue;
        next = at + 1;
        parameter->initial = opened->rows[at].value;
        parameter->low = fmin(opened->rows[at].low, parameter->value);
        parameter->high = fmax(opened->rows[at].high, parameter->value);
    }
    list_in_order(values);
}

void house_value_clear(HouseValues *values) {
    memory_free(values->rows);
    memory_free(values->owners);
    memory_free(values->listed);
    arena_clear(&values->arena);
    *values = (HouseValues){0};
}

/* True if a value belongs to the selected item, or is a main one of the selected person's profile. */
static bool comes_first(const ValueOwner *owner, const PanelParameter *parameter, const House *house, Item selected) {
    if (selected.kind == HOUSE_NOTHING || selected.kind == HOUSE_HAZARD || selected.kind == HOUSE_STOP)
        return owner->key && (owner->item.kind != HOUSE_DOOR || strcmp(parameter->label, "width") == 0);
    if (item_same(owner->item, selected))
        return true;
    return selected.kind == HOUSE_PERSON && owner->key && owner->profile &&
           strcmp(owner->profile, house->people[selected.index].profile->name) == 0;
}

/* Ranks the selected item before its profile. */
static int rank_of(const ValueOwner *owner, const PanelParameter *parameter, Item selected) {
    if (!parameter->first)
        return 2;
    return selected.kind && item_same(owner->item, selected) ? 0 : 1;
}

void house_value_follow(HouseValues *values, const Plan *plan, Item item) {
    for (size_t i = 0; i < values->count && item.kind; i++) {
        const void *object;
        Fault fault = {0};
        if (!item_same(values->owners[i].item, item))
            continue;
        const Parameter *row = plan_parameter(plan, values->rows[i].name, &object, "", &fault);
        double value = row ? parameters_number_get(row, object) : NAN;
        if (isfinite(value))
            values->rows[i].value = value;
        fault_clear(&fault);
    }
}

void house_value_sort(HouseValues *values, const House *house, Item selected) {
    size_t listed = 0;
    for (size_t i = 0; i < values->count; i++)
        values->rows[i].first = comes_first(&values->owners[i], &values->rows[i], house, selected);
    for (int rank = 0; rank <= 2; rank++)
        for (size_t i = 0; i < values->count; i++)
            if (rank_of(&values->owners[i], &values->rows[i], selected) == rank)
                values->listed[listed++] = values->rows[i];
}

/* Setting values -------------------------------------------------------------------------------------------------- */

size_t house_value_find(const HouseValues *values, const char *name) {
    for (size_t i = 0; i < values->count; i++)
        if (strcmp(values->rows[i].name, name) == 0)
            return i;
    return SIZE_MAX;
}

bool house_value_set(HouseValues *values, size_t row, double value, Fault *fault) {
    PanelParameter *parameter = &values->rows[row];
    const Parameter *is = parameter->row;
    bool number = is->kind == PARAMETER_NUMBER || is->kind == PARAMETER_WHOLE;
    double low = number ? is->low : 0, high = number ? is->high : 1;
    if (is->kind == PARAMETER_CHOICE)
        high = (double)choice_count(is->choices) - 1;
    const char *unit = parameters_unit(is), *space = *unit ? " " : "";
    if (!(value >= low && value <= high)) {
        fault_add(fault, "%s: %g%s%s is out of range, %g%s%s to %g%s%s", parameter->label, value, space, unit, low,
                  space, unit, high, space, unit);
        return false;
    }
    if (is->kind != PARAMETER_NUMBER && value != floor(value)) {
        fault_add(fault, "%s: %g must be a whole number", parameter->label, value);
        return false;
    }
    parameter->value = value;
    return true;
}

size_t house_value_settings(const HouseValues *values, const char **settings, Arena *arena) {
    size_t count = 0;
    for (size_t i = 0; i < values->count; i++)
        if (values->rows[i].value != values->rows[i].initial)
            settings[count++] =
                text_in_arena(arena, "%s=%s", values->rows[i].name,
                              parameters_number_text(values->rows[i].row, values->rows[i].value, arena));
    return count;
}
