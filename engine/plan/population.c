#include "plan/population.h"

#include <math.h>
#include <string.h>

#include "base/digest.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/normal.h"
#include "base/real.h"

static const char *const start_rows[] = {"start.x", "start.y", "start.heading"};
enum { STARTS = sizeof start_rows / sizeof *start_rows };

enum { MOST_ROWS = 30, GROUP_STREAM = MOST_ROWS - 1 };

/* The rows and levels with the first streams, by which the sequence is spread best; all others follow them. */
static const struct {
    const char *name, *level;
} first_streams[] = {{"body.width", "person"},
                     {"body.length", "person"},
                     {"body.hands", "person"},
                     {"drive.free_speed", "person"},
                     {"drive.free_speed", "run"},
                     {"drive.steering_time", "person"},
                     {"drive.steering_time", "run"},
                     {"drive.caution", "person"},
                     {"drive.turn_rate", "person"},
                     {"drive.acceleration", "person"},
                     {"drive.deceleration", "person"},
                     {"drive.push", "person"},
                     {"drive.turning_moment", "person"},
                     {"drive.reaction", "person"},
                     {"start.x", "run"},
                     {"start.y", "run"},
                     {"start.heading", "run"}};

/* 1: neither end of a distribution is ever drawn. */
static const double NEAREST_END = 1e-9;

static double read_number(const JsonNode *object, const char *key, double fallback, Fault *fault) {
    JsonNode node = json_member(object, key);
    if (!node.value)
        return fallback;
    if (!json_is_number(node.value)) {
        json_fault(&node, fault, "%s must be a number", key);
        return fallback;
    }
    return json_number_value(node.value);
}

static bool is_start(const char *name) {
    for (int s = 0; s < STARTS; s++)
        if (strcmp(name, start_rows[s]) == 0)
            return true;
    return false;
}

static int law_of(const JsonNode *node, const char *law, Fault *fault) {
    static const char *const names[] = {"lognormal", "normal", "factor"};
    for (int l = 0; l < 3; l++)
        if (strcmp(law, names[l]) == 0)
            return l;
    json_fault(node, fault, "law is \"%s\", must be lognormal, normal or factor", law);
    return LAW_NORMAL;
}

static void read_row(Population *population, const JsonNode *node, Fault *fault) {
    static const char *const keys[] = {"row",       "level", "law",  "median", "sigma",      "mean",
                                       "deviation", "low",   "high", "group",  "provenance", NULL};
    PopulationRow *row = &population->rows[population->count++];
    if (!json_is_object(node->value)) {
        json_fault(node, fault, "a row must be an object { ... }");
        return;
    }
    json_check_keys(node, keys, fault);
    Arena *arena = &population->arena;
    row->name = json_read_text(node, "row", arena, fault);
    row->level = json_read_text(node, "level", arena, fault);
    row->provenance = json_read_text(node, "provenance", arena, fault);
    const char *group = json_read_text(node, "group", arena, fault);
    row->group = *group ? group : NULL;
    row->law = law_of(node, json_read_text(node, "law", arena, fault), fault);
    row->middle = row->law == LAW_FACTOR ? 1 : read_number(node, row->law == LAW_NORMAL ? "mean" : "median", 0, fault);
    row->spread = read_number(node, row->law == LAW_NORMAL ? "deviation" : "sigma", 0, fault);
    row->low = read_number(node, "low", -HUGE_VAL, fault);
    row->high = read_number(node, "high", HUGE_VAL, fault);
    for (size_t r = 0; r < profile_table()->count; r++)
        if (strcmp(profile_table()->rows[r].name, row->name) == 0)
            row->profile = &profile_table()->rows[r];
    if (!row->profile && !is_start(row->name))
        json_fault(node, fault, "row is \"%s\", must be a number of a profile, start.x, start.y or start.heading",
                   row->name);
    if (strcmp(row->level, "person") != 0 && strcmp(row->level, "run") != 0)
        json_fault(node, fault, "level is \"%s\", must be person or run", row->level);
    if (!*row->provenance)
        json_fault(node, fault, "a row has no \"provenance\" (where its numbers come from)");
    if (!(row->spread >= 0) || (row->law == LAW_LOGNORMAL && !(row->middle > 0)))
        json_fault(node, fault, "%s has no spread of at least 0, or no median above 0", row->name);
    if (row->low > row->high)
        json_fault(node, fault, "low is %g, must be at most high, %g", row->low, row->high);
    for (const PopulationRow *other = population->rows; other < row; other++)
        if (other->name && strcmp(other->name, row->name) == 0 && strcmp(other->level, row->level) == 0)
            json_fault(node, fault, "%s has a second row of the level \"%s\"", row->name, row->level);
}

bool population_read(Population *population, const char *path, Fault *fault) {
    static const char *const keys[] = {"format",  "version",     "id",   "title", "note",
                                       "profile", "correlation", "rows", NULL};
    size_t before = fault->total;
    JsonFile file = {0};
    if (!json_read(&file, path, fault))
        return false;
    Population read = {0};
    JsonNode root = json_root(&file);
    if (json_check_header(&root, "population", "clearance-population", fault)) {
        json_check_keys(&root, keys, fault);
        read.id = json_read_text(&root, "id", &read.arena, fault);
        read.title = json_read_text(&root, "title", &read.arena, fault);
        read.note = json_read_text(&root, "note", &read.arena, fault);
        read.profile = json_read_text(&root, "profile", &read.arena, fault);
        if (!*read.profile)
            json_fault(&root, fault, "a population has no \"profile\" (the profile that it varies)");
        read.correlation = real_clamp(read_number(&root, "correlation", 0, fault), 0, 1);
        JsonNode rows = json_member(&root, "rows");
        size_t count = json_is_array(rows.value) ? json_array_size(rows.value) : 0;
        if (count == 0 || count > MOST_ROWS)
            json_fault(rows.value ? &rows : &root, fault, "rows must be a list of 1 to %d rows", (int)MOST_ROWS);
        read.rows = memory_zeroed(count, sizeof *read.rows);
        for (size_t r = 0; r < count && count <= MOST_ROWS; r++) {
            JsonNode node = json_element(&rows, r);
            read_row(&read, &node, fault);
        }
    }
    json_free(&file);
    if (fault->total != before) {
        population_free(&read);
        return false;
    }
    population_free(population);
    *population = read;
    return true;
}

void population_free(Population *population) {
    memory_free(population->rows);
    arena_clear(&population->arena);
    *population = (Population){0};
}

/* Returns the place of a row's stream in the sequence, which does not depend on the other rows of the file. */
static size_t stream_of(const PopulationRow *row) {
    size_t level = strcmp(row->level, "run") == 0, own = profile_table()->count;
    for (size_t s = 0; s < sizeof first_streams / sizeof *first_streams; s++)
        if (strcmp(first_streams[s].name, row->name) == 0 && strcmp(first_streams[s].level, row->level) == 0)
            return s;
    for (size_t s = 0; s < STARTS && !row->profile; s++)
        own += strcmp(start_rows[s], row->name) == 0 ? s : 0;
    if (row->profile)
        own = (size_t)(row->profile - profile_table()->rows);
    return MOST_ROWS + 2 * own + level;
}

/* Returns p_j, the j-th prime, from 0 on. */
static int prime(size_t j) {
    int number = 2;
    for (size_t found = 0;; number++) {
        bool divides = false;
        for (int d = 2; d * d <= number && !divides; d++)
            divides = number % d == 0;
        if (!divides && found++ == j)
            return number;
    }
}

/* Returns the normal number of a stream, by its name and its place in the sequence. */
static double drawn(const char *name, const char *level, size_t place, size_t driver, uint64_t seed) {
    uint64_t digest = digest_text(digest_text(digest_mix(DIGEST_START, (double)seed), name), level);
    double begin = (double)(digest >> 11) / 9007199254740992.0; /* 2^53 */
    double at = begin + (double)driver * sqrt(prime(place));
    return normal_quantile(real_clamp(at - floor(at), NEAREST_END, 1 - NEAREST_END));
}

static double value_of(const PopulationRow *row, double z, double present) {
    double value = row->middle + row->spread * z;
    if (row->law == LAW_LOGNORMAL)
        value = row->middle * real_exp(row->spread * z);
    if (row->law == LAW_FACTOR)
        value = present * real_exp(row->spread * z);
    value = real_clamp(value, row->low, row->high);
    return row->profile ? real_clamp(value, row->profile->low, row->profile->high) : value;
}

/* Draws a row's value for a driver, into the profile or the start. */
static void draw_row(const Population *population, const PopulationRow *row, size_t driver, uint64_t seed,
                     Profile *profile, PopulationStart *start) {
    double z = drawn(row->name, row->level, stream_of(row), driver, seed);
    if (row->group)
        z = sqrt(1 - population->correlation) * z +
            sqrt(population->correlation) * drawn(row->group, "group", GROUP_STREAM, driver, seed);
    double *field = row->profile                        ? (double *)((char *)profile + row->profile->offset)
                    : strcmp(row->name, "start.x") == 0 ? &start->x
                    : strcmp(row->name, "start.y") == 0 ? &start->y
                                                        : &start->heading;
    *field = value_of(row, z, *field);
}

PopulationStart population_draw(const Population *population, size_t driver, uint64_t seed, Profile *profile) {
    static const char *const levels[] = {"person", "run"};
    PopulationStart start = {0};
    for (int l = 0; l < 2 && driver > 0; l++)
        for (size_t r = 0; r < population->count; r++)
            if (strcmp(population->rows[r].level, levels[l]) == 0)
                draw_row(population, &population->rows[r], driver, seed, profile, &start);
    return start;
}
