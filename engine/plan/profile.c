#include "plan/profile.h"

#include <string.h>
#include <unistd.h>

#include "base/parameters_schema.h"
#include "base/provenance.h"
#include "base/text.h"

/* Driving models that use the row, and whether a file may leave it out. */
enum { CHAIRS = 1, WALKERS = 2, ALL = CHAIRS | WALKERS, OPTIONAL = 4 };

#define ROWS_OF_A_PROFILE(ROW, MAY)                                                                                    \
    ROW(CHAIRS, "body.length", length, "m", 0.1, 3, "length of chair and driver")                                      \
    ROW(ALL, "body.width", width, "m", 0.1, 3, "width")                                                                \
    ROW(CHAIRS, "body.axle", axle, "m", 0, 3, "drive axle ahead of the rear edge")                                     \
    ROW(CHAIRS, "body.corner_radius", corner_radius, "m", 0.01, 1, "rounding of the corners")                          \
    ROW(ALL, "body.mass", mass, "kg", 1, 1000, "mass of chair and driver")                                             \
    ROW(CHAIRS, "body.mass_centre", mass_centre, "m", -1, 1, "mass centre ahead of the drive axle")                    \
    ROW(CHAIRS, "body.radius_of_gyration", radius_of_gyration, "m", 0.05, 2, "radius of gyration in yaw")              \
    MAY(CHAIRS, "body.hands", hands, "m", 0, 0.5, 0, "assumed: not given, so none",                                    \
        "space for a hand at each rim; 0: none")                                                                       \
    ROW(ALL, "drive.free_speed", free_speed, "m/s", 0.05, 5, "free speed on the level, mean")                          \
    ROW(ALL, "drive.free_speed_deviation", free_speed_deviation, "m/s", 0, 2, "standard deviation of the free speed")  \
    ROW(CHAIRS, "drive.minimum_speed", minimum_speed, "m/s", 0.01, 2, "v_min, floor of the speed through corners")     \
    ROW(CHAIRS, "drive.steering_time", steering_time, "s", 0, 10, "b of the steering law v = (W - w) / b")             \
    ROW(ALL, "drive.acceleration", acceleration, "m/s2", 0.01, 10, "a_0, initial acceleration")                        \
    ROW(CHAIRS, "drive.deceleration", deceleration, "m/s2", 0.01, 10, "a_d, deceleration")                             \
    ROW(CHAIRS, "drive.lateral_acceleration", lateral_acceleration, "m/s2", 0.01, 10, "comfortable in a corner")       \
    ROW(CHAIRS, "drive.turn_rate", turn_rate, "rad/s", 0.01, 10, "fastest turn")                                       \
    ROW(ALL, "drive.push", push, "N", 0, 5000, "largest push of the driver; 0: no driver")                             \
    ROW(CHAIRS, "drive.turning_moment", turning_moment, "N m", 0, 1000, "largest turning moment of the driver")        \
    MAY(CHAIRS, "drive.scrub", scrub, "N m", 0, 1000, 0, "assumed: not given, so none",                                \
        "moment that a turn on the spot takes")                                                                        \
    ROW(ALL, "drive.speed_response", speed_response, "s", 0.01, 10, "time to take up a speed")                         \
    ROW(CHAIRS, "drive.turn_response", turn_response, "s", 0.01, 10, "time to take up a turn")                         \
    ROW(CHAIRS, "drive.lateral_gain", lateral_gain, "1/m2", 0, 1000, "steering per distance off the path")             \
    ROW(CHAIRS, "drive.heading_gain", heading_gain, "1/m", 0, 1000, "steering per heading off the path")               \
    ROW(CHAIRS, "drive.side_friction", side_friction, "1", 0, 10, "friction of the wheels sideways")                   \
    ROW(CHAIRS, "drive.reversing_speed", reversing_speed, "m/s", 0.01, 5, "speed backwards")                           \
    ROW(CHAIRS, "drive.reversing_time", reversing_time, "s", 0, 60, "time to change direction")                        \
    MAY(CHAIRS, "drive.skid_time", skid_time, "s/m", 0, 10000, 0, "assumed: not given, so none",                       \
        "time to skid sideways; 0: no skids")                                                                          \
    MAY(CHAIRS, "drive.creep", creep, "m/s", 0.01, 2, 0.1, "assumed", "least speed through a passage")                 \
    MAY(CHAIRS, "drive.caution", caution, "1", 0.1, 10, 3, "assumed", "z, errors kept from a wall")                    \
    MAY(CHAIRS, "drive.sight", sight, "m", 0.1, 20, 2, "assumed", "l_p, way ahead by which the line is held")          \
    MAY(CHAIRS, "drive.drift", drift, "m/rad", 0, 0.2, 0, "assumed: not given, so none",                               \
        "slip outwards in a turn, but for the nominal driver")                                                         \
    MAY(CHAIRS, "drive.spot_error", spot_error, "degree", 0, 30, 0, "assumed: not given, so none",                     \
        "error of a turn on the spot, but for the nominal driver")                                                     \
    MAY(CHAIRS, "drive.reaction", reaction, "s", 0, 2, 0.3, "assumed", "time to notice what is near")                  \
    ROW(WALKERS, "drive.time_gap", time_gap, "s", 0.05, 10, "a walker's time gap to the person ahead")                 \
    ROW(ALL, "space.reach", space_reach, "m", 0, 3, "personal space beyond the body")                                  \
    MAY(CHAIRS, "space.centring", space_centring, "m", 0.05, 20, 0.6, "assumed",                                       \
        "l_r, way in which what is near steers")                                                                       \
    MAY(CHAIRS, "space.price", space_price, "s/m", 0, 100, 0.5, "assumed", "price of space pressed on one side")       \
    ROW(ALL, "space.normal_stiffness", space.normal_stiffness, "N/m", 0, 1e7, "k_n' of the personal space")            \
    ROW(ALL, "space.normal_damping", space.normal_damping, "N s/m", 0, 1e6, "c_n' of the personal space")              \
    ROW(ALL, "space.tangential_stiffness", space.tangential_stiffness, "N/m", 0, 1e7, "k_t' of the personal space")    \
    ROW(ALL, "space.tangential_damping", space.tangential_damping, "N s/m", 0, 1e6, "c_t' of the personal space")      \
    ROW(ALL, "space.friction", space.friction, "1", 0, 10, "Coulomb limit of the personal space")                      \
    ROW(ALL, "contact.normal_stiffness", contact.normal_stiffness, "N/m", 1, 1e8, "k_n of the body")                   \
    ROW(ALL, "contact.normal_damping", contact.normal_damping, "N s/m", 0, 1e6, "c_n of the body")                     \
    ROW(ALL, "contact.tangential_stiffness", contact.tangential_stiffness, "N/m", 0, 1e8, "k_t of the body")           \
    ROW(ALL, "contact.tangential_damping", contact.tangential_damping, "N s/m", 0, 1e6, "c_t of the body")             \
    ROW(ALL, "contact.friction", contact.friction, "1", 0, 10, "Coulomb limit of the body")

#define AS_PARAMETER(who_, name_, field_, unit_, low_, high_, meaning_)                                                \
    {.name = name_,                                                                                                    \
     .kind = PARAMETER_NUMBER,                                                                                         \
     .offset = offsetof(Profile, field_),                                                                              \
     .unit = unit_,                                                                                                    \
     .low = low_,                                                                                                      \
     .high = high_,                                                                                                    \
     .needed = true,                                                                                                   \
     .meaning = meaning_},
#define AS_OPTIONAL(who_, name_, field_, unit_, low_, high_, fallback_, provenance_, meaning_)                         \
    {.name = name_,                                                                                                    \
     .kind = PARAMETER_NUMBER,                                                                                         \
     .offset = offsetof(Profile, field_),                                                                              \
     .unit = unit_,                                                                                                    \
     .low = low_,                                                                                                      \
     .high = high_,                                                                                                    \
     .fallback = fallback_,                                                                                            \
     .provenance = provenance_,                                                                                        \
     .meaning = meaning_},
#define AS_MARK(who_, name_, field_, unit_, low_, high_, meaning_) who_,
#define AS_OPTIONAL_MARK(who_, name_, field_, unit_, low_, high_, fallback_, provenance_, meaning_) (who_) | OPTIONAL,

static const Parameter profile_rows[] = {ROWS_OF_A_PROFILE(AS_PARAMETER, AS_OPTIONAL)};
static const unsigned char row_marks[] = {ROWS_OF_A_PROFILE(AS_MARK, AS_OPTIONAL_MARK)};

enum { ROWS = sizeof profile_rows / sizeof *profile_rows };
_Static_assert((int)ROWS <= (int)PROFILE_NUMBERS, "a provenance for every row");

static const ParameterTable table = {"profile", profile_rows, ROWS};

static const Parameter driving_row = {.name = "driving",
                                      .kind = PARAMETER_CHOICE,
                                      .offset = offsetof(Profile, driving),
                                      .unit = "",
                                      .choices = DRIVING_WORDS,
                                      .needed = true,
                                      .meaning = "driving model"};

static const char *const groups[] = {"body", "drive", "space", "contact"};
enum { GROUPS = sizeof groups / sizeof *groups };

/* Allowed beginnings of a provenance in a file. */
#define SOURCES "paper|reconstructed|fitted: |literature: |assumed"

const ParameterTable *profile_table(void) {
    return &table;
}

const char *profile_driving_name(int driving) {
    static const char *const names[] = {"driver", "miura", "walker"};
    return names[driving];
}

bool profile_row_matters(size_t row, int driving) {
    return row_marks[row] & (driving == DRIVING_WALKER ? WALKERS : CHAIRS);
}

static void read_value(Profile *profile, size_t row, const JsonNode *group, const char *name, Fault *fault) {
    JsonNode node = json_member(group, name);
    if (!node.value && !profile_rows[row].needed) {
        profile->provenance[row] = profile_rows[row].provenance;
        *(double *)((char *)profile + profile_rows[row].offset) = profile_rows[row].fallback;
        return;
    }
    if (!node.value) {
        json_fault(group, fault, "%s has no \"%s\" (%s, %s)", group->key, name, profile_rows[row].meaning,
                   profile_rows[row].unit);
        return;
    }
    if (!json_is_object(node.value)) {
        json_fault(&node, fault, "%s must be {\"value\": number, \"provenance\": text}", name);
        return;
    }
    provenance_read(&profile_rows[row], profile, &profile->provenance[row], &node, SOURCES, &profile->arena, fault);
}

static void read_group(Profile *profile, const JsonNode *root, const char *group, Fault *fault) {
    JsonNode node = json_member(root, group);
    if (!json_is_object(node.value)) {
        if (node.value)
            json_fault(&node, fault, "%s must be an object { ... }", group);
        else
            json_fault(root, fault, "a profile has no \"%s\", must be an object { ... }", group);
        return;
    }
    const char *names[ROWS + 1] = {0};
    size_t count = 0;
    for (size_t i = 0; i < ROWS; i++)
        if (provenance_name(&profile_rows[i], group) && profile_row_matters(i, profile->driving))
            names[count++] = provenance_name(&profile_rows[i], group);
    json_check_keys(&node, names, fault);
    for (size_t i = 0; i < ROWS; i++)
        if (provenance_name(&profile_rows[i], group) && profile_row_matters(i, profile->driving))
            read_value(profile, i, &node, provenance_name(&profile_rows[i], group), fault);
}

static void read_texts(Profile *profile, const JsonNode *root, Fault *fault) {
    static const char *const keys[] = {"format", "version", "name",  "note",    "driving",
                                       "body",   "drive",   "space", "contact", NULL};
    json_check_keys(root, keys, fault);
    profile->name = json_read_text(root, "name", &profile->arena, fault);
    profile->note = json_read_text(root, "note", &profile->arena, fault);
    JsonNode driving = json_member(root, "driving");
    if (!json_object_get(root->value, "name"))
        json_fault(root, fault, "a profile has no \"name\" (a text)");
    if (driving.value)
        parameters_read_value(&driving_row, profile, &driving, &profile->arena, fault);
    else
        json_fault(root, fault, "a profile has no \"driving\" (%s)", driving_row.meaning);
}

/* Makes a walker a disc, since its file gives only one size. */
static void round_walker(Profile *profile) {
    if (profile->driving != DRIVING_WALKER)
        return;
    profile->length = profile->width;
    profile->axle = profile->corner_radius = profile->width / 2;
    profile->radius_of_gyration = profile->width / sqrt(8);
}

const char *profile_find(const char *folders, const char *name, Arena *arena) {
    const char *first = NULL;
    for (const char *at = folders; *at || !first;) {
        size_t length = strcspn(at, "\n");
        const char *path = text_in_arena(arena, "%.*s/%s.json", (int)length, at, name);
        if (access(path, R_OK) == 0)
            return path;
        first = first ? first : path;
        at += length + (at[length] == '\n');
    }
    return first;
}

bool profile_read(Profile *profile, const char *path, Fault *fault) {
    size_t before = fault->total;
    JsonFile file = {0};
    if (!json_read(&file, path, fault))
        return false;
    Profile read = {0};
    JsonNode root = json_root(&file);
    if (json_check_header(&root, "profile", "clearance-profile", fault)) {
        read_texts(&read, &root, fault);
        for (size_t g = 0; g < GROUPS; g++)
            read_group(&read, &root, groups[g], fault);
    }
    json_free(&file);
    round_walker(&read);
    if (fault->total != before) {
        profile_free(&read);
        return false;
    }
    profile_free(profile);
    *profile = read;
    return true;
}

static const Parameter *find_row(const Profile *profile, const char *name, const JsonNode *node, Fault *fault) {
    const Parameter *row = strcmp(name, "driving") == 0 ? &driving_row : parameters_find(&table, name);
    if (!row) {
        parameters_fault_unknown(&table, name, node, fault);
    } else if (row != &driving_row && !profile_row_matters((size_t)(row - profile_rows), profile->driving)) {
        json_fault(node, fault,
                   profile->driving == DRIVING_WALKER ? "%s does not apply to %s: people of this profile walk"
                                                      : "%s does not apply to %s: people of this profile drive",
                   row->name, profile->name);
        row = NULL;
    }
    return row;
}

const Parameter *profile_parameter(const Profile *profile, const char *name, const char *place, Fault *fault) {
    JsonFile file = {.path = place};
    JsonNode node = json_root(&file);
    return find_row(profile, name, &node, fault);
}

bool profile_set(Profile *profile, const char *name, const char *value, const char *place, Fault *fault) {
    size_t before = fault->total;
    char *prefix = text_copy(place);
    JsonFile file = {.path = prefix, .root = json_loads(value, JSON_DECODE_ANY, NULL)};
    JsonNode node = json_root(&file);
    const Parameter *row = find_row(profile, name, &node, fault);
    int before_driving = profile->driving;
    if (row && parameters_read_value(row, profile, &node, &profile->arena, fault) && row != &driving_row)
        profile->provenance[row - profile_rows] = "assumed: set for this run";
    if ((before_driving == DRIVING_WALKER) != (profile->driving == DRIVING_WALKER)) {
        profile->driving = before_driving;
        json_fault(&node, fault,
                   "a walking profile cannot be changed to a driving one, nor the reverse: use another profile");
    }
    round_walker(profile);
    json_decref(file.root);
    memory_free(prefix);
    return fault->total == before;
}

/* m: with a larger reach, neighbours on all sides press so hard that a person is pushed through a wall. */
static const double WALKERS_REACH = 0.5;

bool profile_check(const Profile *profile, double dt, const char *place, Fault *fault) {
    size_t before = fault->total;
    bool walks = profile->driving == DRIVING_WALKER;
    /* A chair: two walls on either side, body and ring of the heavier law counted in full. A walker in a crowd: six
     * others, two of them against a wall behind. */
    const double most_contacts = walks ? 8 : 4;
    if (walks && profile->space_reach > WALKERS_REACH)
        fault_add(fault, "%s: reach is %g m, must be at most %g m for a walker", place, profile->space_reach,
                  WALKERS_REACH);
    if (profile->axle > profile->length)
        fault_add(fault, "%s: axle is %g m ahead of the rear edge, must be at most the length, %g m", place,
                  profile->axle, profile->length);
    if (profile->corner_radius > fmin(profile->length, profile->width) / 2)
        fault_add(fault, "%s: corner_radius is %g m, must be at most half the smaller side, %g m", place,
                  profile->corner_radius, fmin(profile->length, profile->width) / 2);
    /* At a corner of the body a force also turns the body, which makes the mass there appear smaller. */
    double arm = vec2_length(vec2(profile->length / 2, profile->width / 2)) / profile->radius_of_gyration;
    double mass = profile->driving == DRIVING_DRIVER ? profile->mass / (1 + arm * arm) : profile->mass;
    double longest = fmin(contact_longest_step(&profile->contact, mass, most_contacts),
                          contact_longest_step(&profile->space, mass, most_contacts));
    if (dt > longest)
        fault_add(fault, "%s: the step dt is %g s, but the contact law of %s needs at most %.3g s", place, dt,
                  profile->name, longest);
    return fault->total == before;
}

void profile_free(Profile *profile) {
    arena_clear(&profile->arena);
    *profile = (Profile){0};
}

json_t *profile_schema(void) {
    json_t *properties = json_object();
    json_object_set_new(properties, "format", json_pack("{s:s}", "const", "clearance-profile"));
    json_object_set_new(properties, "version", json_pack("{s:i}", "const", 1));
    json_object_set_new(properties, "name", json_pack("{s:s}", "type", "string"));
    json_object_set_new(properties, "note", json_pack("{s:s}", "type", "string"));
    json_object_set_new(properties, "driving", parameters_schema_value(&driving_row));
    for (size_t g = 0; g < GROUPS; g++) {
        json_t *members = json_object(), *needed = json_array();
        for (size_t i = 0; i < ROWS; i++) {
            const char *name = provenance_name(&profile_rows[i], groups[g]);
            if (!name)
                continue;
            json_object_set_new(members, name, provenance_schema(&profile_rows[i], SOURCES));
            if (row_marks[i] == ALL)
                json_array_append_new(needed, json_string(name));
        }
        json_object_set_new(properties, groups[g],
                            json_pack("{s:s, s:b, s:o, s:o}", "type", "object", "additionalProperties", 0, "properties",
                                      members, "required", needed));
    }
    return json_pack("{s:s, s:s, s:s, s:b, s:o, s:[s,s,s,s,s,s,s,s]}", "$schema",
                     "https://json-schema.org/draft/2020-12/schema", "title", "A profile of clearance", "type",
                     "object", "additionalProperties", 0, "properties", properties, "required", "format", "version",
                     "name", "driving", "body", "drive", "space", "contact");
}
