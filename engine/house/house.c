#include "house/house.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "house/populate.h"
#include "house/shake.h"

/* m: on a coarser grid a chair finds no path through a door. */
static const double COARSEST_CELL = 0.2;

/* Returns NAME.json in the folder of the house file, otherwise in the first of the folders that has it. */
static const char *profile_path(House *house, const char *house_path, const char *folders, const char *name) {
    const char *slash = strrchr(house_path, '/');
    size_t directory = slash ? (size_t)(slash - house_path) + 1 : 0;
    size_t size = strlen(house_path) + strlen(name) + sizeof ".json";
    char *path = arena_allocate(&house->arena, size);
    snprintf(path, size, "%.*s%s.json", (int)directory, house_path, name);
    return access(path, R_OK) == 0 ? path : profile_find(folders, name, &house->arena);
}

static void read_profile(House *house, const char *house_path, const HouseOptions *options, const char *place,
                         const char *who, const char *name, Fault *fault) {
    for (size_t i = 0; i < house->profile_count; i++)
        if (strcmp(house->profiles[i].name, name) == 0)
            return;
    const char *path = profile_path(house, house_path, options->profiles, name);
    if (access(path, R_OK) != 0) {
        fault_add(fault, "%s%s has profile \"%s\", but there is no %s.json in the folder of the house or in %.*s",
                  place, who, name, name, (int)strcspn(options->profiles, "\n"), options->profiles);
        return;
    }
    Profile *profile = &house->profiles[house->profile_count];
    if (!profile_read(profile, path, fault))
        return;
    profile->name = arena_text(&profile->arena, name); /* the file's name decides, so that a copy can be edited */
    if (options->driving >= 0 && profile->driving != DRIVING_WALKER)
        profile->driving = options->driving;
    house->profile_count++;
}

static void read_profiles(House *house, const char *path, const HouseOptions *options, Fault *fault) {
    const Plan *plan = &house->plan;
    house->profiles = memory_zeroed(plan->person_count + plan->crowd_count, sizeof *house->profiles);
    for (size_t i = 0; i < plan->person_count; i++) {
        const Person *person = &plan->people[i];
        read_profile(house, path, options, person->place, person->id, person->profile, fault);
    }
    for (size_t i = 0; i < plan->crowd_count; i++) {
        const Crowd *crowd = &plan->crowds[i];
        read_profile(house, path, options, crowd->place, crowd->id, crowd->profile, fault);
    }
}

/* Returns the profile of profile.NAME.PARAMETER; `*parameter` is set to the beginning of PARAMETER. */
static Profile *find_profile(const House *house, const char *path, const char **parameter, const char *place,
                             Fault *fault) {
    const char *name = path + strlen("profile.");
    size_t length = strcspn(name, ".");
    *parameter = name + length + 1;
    for (size_t i = 0; i < house->profile_count; i++) {
        Profile *profile = &house->profiles[i];
        if (strlen(profile->name) == length && memcmp(profile->name, name, length) == 0)
            return profile;
    }
    fault_add(fault, "%sno person has the profile \"%.*s\"", place, (int)length, name);
    return NULL;
}

static void apply_override(House *house, const Override *override, Fault *fault) {
    const char *parameter;
    Profile *profile = find_profile(house, override->name, &parameter, override->place, fault);
    if (profile)
        profile_set(profile, parameter, override->value, override->place, fault);
}

const Parameter *house_parameter(const House *house, const char *name, const void **object, const char *place,
                                 Fault *fault) {
    if (!plan_is_of_profile(name))
        return plan_parameter(&house->plan, name, object, place, fault);
    const char *parameter;
    const Profile *profile = find_profile(house, name, &parameter, place, fault);
    *object = profile;
    return profile ? profile_parameter(profile, parameter, place, fault) : NULL;
}

size_t house_find_person(const House *house, const char *id) {
    size_t low = 0, high = house->person_count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        int order = strcmp(house->people[middle].id, id);
        if (order == 0)
            return middle;
        if (order < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return SIZE_MAX;
}

/* Returns the place where the profile is first named. */
static const char *place_of(const House *house, const Profile *profile) {
    const Plan *plan = &house->plan;
    for (size_t i = 0; i < plan->person_count; i++)
        if (strcmp(plan->people[i].profile, profile->name) == 0)
            return plan->people[i].place;
    for (size_t i = 0; i < plan->crowd_count; i++)
        if (strcmp(plan->crowds[i].profile, profile->name) == 0)
            return plan->crowds[i].place;
    return "";
}

static void check_profile(const House *house, size_t i, Fault *fault) {
    const Profile *profile = &house->profiles[i];
    char place[512];
    snprintf(place, sizeof place, "%.400sprofile %.60s", place_of(house, profile), profile->name);
    profile_check(profile, house->plan.run.dt, place, fault);
    if (house->plan.run.hands == SWITCH_OFF)
        house->profiles[i].hands = 0;
}

/* Lists the obstacles for the widest walker. */
static void list_obstacles(House *house) {
    double reach = 0;
    for (size_t i = 0; i < house->profile_count; i++)
        if (house->profiles[i].driving == DRIVING_WALKER)
            reach = fmax(reach, house->profiles[i].width / 2 + house->profiles[i].space_reach);
    if (reach > 0)
        obstacle_grid_init(&house->obstacles, &house->outline, &house->plan, reach);
}

/* Builds everything that depends on the plan alone. */
static bool build_space(House *house, const char *path, Fault *fault) {
    size_t before = fault->total;
    if (!outline_build(&house->outline, &house->plan, fault))
        return false;
    freespace_build(&house->space, &house->outline, house->plan.run.cell);
    if (house->space.cell > COARSEST_CELL)
        fault_add(fault, "%s:1:1: the house is too large for the route search, %.0f m by %.0f m: it must be smaller",
                  path, house->space.cell * house->space.nx, house->space.cell * house->space.ny);
    list_obstacles(house);
    return fault->total == before;
}

static void free_space(House *house) {
    freespace_free(&house->space);
    obstacle_grid_clear(&house->obstacles);
    outline_free(&house->outline);
}

/* Finds the people who are under furniture that already lies. */
static void catch_people(House *house) {
    const Plan *plan = &house->plan;
    bool *lies = memory_zeroed(plan->furniture_count, sizeof *lies);
    for (size_t f = 0; f < plan->furniture_count; f++)
        lies[f] = plan->furniture[f].toppled;
    for (size_t i = 0; i < house->person_count; i++)
        house->people[i].under = shake_catches(plan, lies, &house->people[i]);
    memory_free(lies);
}

/* Places people as without a shake, then lets furniture fall, on some of them. */
static bool shake_house(House *house, const char *path, Fault *fault) {
    Plan *plan = &house->plan;
    bool *topples = memory_zeroed(plan->furniture_count, sizeof *topples), any = false;
    shake_draw(plan, house->seed, topples);
    for (size_t f = 0; f < plan->furniture_count; f++)
        any |= topples[f];
    for (size_t i = 0; i < house->person_count && any; i++)
        if (!house->people[i].under)
            house->people[i].under = shake_catches(plan, topples, &house->people[i]);
    for (size_t f = 0; f < plan->furniture_count; f++)
        plan->furniture[f].toppled |= topples[f];
    memory_free(topples);
    if (!any)
        return true;
    free_space(house);
    return build_space(house, path, fault);
}

/* Builds everything that follows from the plan, which has been read. */
static bool build_parts(House *house, const char *path, const HouseOptions *options, Fault *fault) {
    size_t before = fault->total;
    read_profiles(house, path, options, fault);
    if (fault->total == before)
        for (size_t i = 0; i < house->plan.override_count; i++)
            apply_override(house, &house->plan.overrides[i], fault);
    for (size_t i = 0; i < house->profile_count && fault->total == before; i++)
        check_profile(house, i, fault);
    if (fault->total != before || !build_space(house, path, fault))
        return false;
    if (!populate_house(house, fault))
        return false;
    catch_people(house);
    return !options->shake || shake_house(house, path, fault);
}

/* Reads from `text` or, if that is NULL, from the file. */
static bool read_house(House *house, const char *path, const char *text, const HouseOptions *options, Fault *fault) {
    House read = {.seed = options->seed};
    const char *const *settings = options->settings;
    size_t count = options->setting_count;
    bool planned = text ? plan_read_text(&read.plan, path, text, settings, count, fault)
                        : plan_read(&read.plan, path, settings, count, fault);
    if (!planned || !build_parts(&read, path, options, fault)) {
        house_free(&read);
        return false;
    }
    house_free(house);
    *house = read;
    house->space.outline = &house->outline;
    return true;
}

bool house_read(House *house, const char *path, const HouseOptions *options, Fault *fault) {
    return read_house(house, path, NULL, options, fault);
}

bool house_read_text(House *house, const char *path, const char *text, const HouseOptions *options, Fault *fault) {
    return read_house(house, path, text, options, fault);
}

void house_free(House *house) {
    free_space(house);
    memory_free(house->people);
    for (size_t i = 0; i < house->profile_count; i++)
        profile_free(&house->profiles[i]);
    memory_free(house->profiles);
    plan_free(&house->plan);
    arena_clear(&house->arena);
    *house = (House){0};
}
