#include "house/house.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/random.h"
#include "house/gap.h"

/* m: on a coarser grid a chair does not find through a door. */
static const double COARSEST_CELL = 0.2;

enum { PLACING_TRIES = 10000 /* random places tried for one member of a crowd */ };

/* NAME.json beside the house file, otherwise among the shipped profiles. */
static const char *profile_path(House *house, const char *house_path, const char *shipped, const char *name) {
    const char *slash = strrchr(house_path, '/');
    size_t directory = slash ? (size_t)(slash - house_path) + 1 : 0;
    size_t size = strlen(house_path) + strlen(shipped) + strlen(name) + sizeof "/.json";
    char *path = arena_allocate(&house->arena, size);
    snprintf(path, size, "%.*s%s.json", (int)directory, house_path, name);
    if (access(path, R_OK) != 0)
        snprintf(path, size, "%s/%s.json", shipped, name);
    return path;
}

static const Profile *find_profile(const House *house, const char *name) {
    for (size_t i = 0; i < house->profile_count; i++)
        if (strcmp(house->profiles[i].name, name) == 0)
            return &house->profiles[i];
    return NULL;
}

static void read_profile(House *house, const char *house_path, const HouseOptions *options, const char *who,
                         const char *name, Fault *fault) {
    for (size_t i = 0; i < house->profile_count; i++)
        if (strcmp(house->profiles[i].name, name) == 0)
            return;
    const char *path = profile_path(house, house_path, options->profiles, name);
    if (access(path, R_OK) != 0) {
        fault_add(fault, "%s:1:1: %s has profile \"%s\", but there is no %s.json beside the house or in %s", house_path,
                  who, name, name, options->profiles);
        return;
    }
    Profile *profile = &house->profiles[house->profile_count];
    if (!profile_read(profile, path, fault))
        return;
    profile->name = arena_text(&profile->arena, name); /* the file's name decides, so that a copy can be changed */
    if (options->driving >= 0)
        profile->driving = options->driving;
    house->profile_count++;
}

static void read_profiles(House *house, const char *path, const HouseOptions *options, Fault *fault) {
    const Plan *plan = &house->plan;
    house->profiles = memory_allocate(plan->person_count + plan->crowd_count, sizeof *house->profiles);
    for (size_t i = 0; i < plan->person_count; i++)
        read_profile(house, path, options, plan->people[i].id, plan->people[i].profile, fault);
    for (size_t i = 0; i < plan->crowd_count; i++)
        read_profile(house, path, options, plan->crowds[i].id, plan->crowds[i].profile, fault);
}

/* profile.NAME.PARAMETER */
static void apply_override(House *house, const Override *override, Fault *fault) {
    const char *name = override->name + strlen("profile.");
    size_t length = strcspn(name, ".");
    for (size_t i = 0; i < house->profile_count; i++) {
        Profile *profile = &house->profiles[i];
        if (strlen(profile->name) == length && memcmp(profile->name, name, length) == 0) {
            profile_set(profile, name + length + 1, override->value, override->place, fault);
            return;
        }
    }
    fault_add(fault, "%sno person has the profile \"%.*s\"", override->place, (int)length, name);
}

static bool inside_outline(const Points *outline, Vec2 p) {
    bool inside = false;
    for (size_t i = 0, j = outline->count - 1; i < outline->count; j = i++) {
        Vec2 a = outline->at[i], b = outline->at[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
}

static double body_reach(const Profile *profile) {
    return vec2_length(vec2(fmax(profile->axle, profile->length - profile->axle), profile->width / 2));
}

static bool place_is_free(const House *house, const Inhabitant *placed) {
    double reach = body_reach(placed->profile);
    if (freespace_distance(&house->space, placed->at) < reach)
        return false;
    for (size_t i = 0; i < house->person_count; i++)
        if (vec2_distance(house->people[i].at, placed->at) < reach + body_reach(house->people[i].profile))
            return false;
    return true;
}

/* A crowd's own stream of chance, whatever its place in the file (FNV-1a). */
static uint64_t stream_of(const char *id) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (; *id; id++)
        hash = (hash ^ (unsigned char)*id) * 0x100000001b3u;
    return hash;
}

/* Stands the members of a crowd in its area, no body on another, their speeds drawn from the profile. */
static void place_crowd(House *house, size_t c, const char *path, Fault *fault) {
    const Crowd *crowd = &house->plan.crowds[c];
    Random random = random_seed(house->seed, stream_of(crowd->id));
    Box box = box_empty();
    for (size_t i = 0; i < crowd->area.count; i++)
        box = box_include(box, crowd->area.at[i]);
    for (int member = 0; member < crowd->count; member++) {
        Inhabitant placed = {.profile = find_profile(house, crowd->profile), .delay = crowd->delay};
        int tries = 0;
        do {
            double u = random_uniform(&random), v = random_uniform(&random);
            placed.at = vec2(box.low.x + u * (box.high.x - box.low.x), box.low.y + v * (box.high.y - box.low.y));
            tries++;
        } while (tries < PLACING_TRIES && !(inside_outline(&crowd->area, placed.at) && place_is_free(house, &placed)));
        if (tries == PLACING_TRIES) {
            fault_add(fault, "%s:1:1: crowd %s: there is room for %d of its %d people, make the area larger", path,
                      crowd->id, member, crowd->count);
            return;
        }
        placed.heading = 2 * M_PI * random_uniform(&random);
        double speed = random_normal(&random, placed.profile->free_speed, placed.profile->free_speed_deviation);
        placed.speed = fmax(speed, placed.profile->minimum_speed / 2);
        size_t size = strlen(crowd->id) + 16;
        char *id = arena_allocate(&house->arena, size);
        snprintf(id, size, "%s-%d", crowd->id, member + 1);
        placed.id = id;
        house->people[house->person_count++] = placed;
    }
}

/* People who stand inside one another would be shot apart. */
static void check_overlaps(const House *house, const char *path, Fault *fault) {
    for (size_t i = 0; i < house->plan.person_count; i++) {
        for (size_t j = 0; j < i; j++) {
            const Inhabitant *a = &house->people[i], *b = &house->people[j];
            if (vec2_distance(a->at, b->at) > body_reach(a->profile) + body_reach(b->profile))
                continue;
            Body bodies[2] = {body_of(a->profile), body_of(b->profile)};
            Vec2 axes[2] = {vec2_heading(a->heading), vec2_heading(b->heading)};
            Gap gaps[GAPS_MOST];
            size_t count =
                gap_to_body(gaps, &bodies[0], house_centre(a), axes[0], &bodies[1], house_centre(b), axes[1], 0);
            if (count)
                fault_add(fault, "%s:1:1: person %s stands inside person %s, must stand apart", path, a->id, b->id);
        }
    }
}

static int compare_inhabitants(const void *a, const void *b) {
    const Inhabitant *p = a, *q = b;
    return strcmp(p->id, q->id);
}

static void place_people(House *house, const char *path, Fault *fault) {
    const Plan *plan = &house->plan;
    size_t count = plan->person_count, before = fault->total;
    for (size_t c = 0; c < plan->crowd_count; c++)
        count += (size_t)plan->crowds[c].count;
    house->people = memory_allocate(count, sizeof *house->people);
    for (size_t i = 0; i < plan->person_count; i++) {
        const Person *person = &plan->people[i];
        const Profile *profile = find_profile(house, person->profile);
        house->people[house->person_count++] =
            (Inhabitant){.id = person->id,
                         .profile = profile,
                         .route = plan_route_of(plan, person->id),
                         .at = person->at,
                         .heading = radians(person->heading),
                         .delay = person->delay,
                         .speed = person->speed > 0 ? person->speed : profile->free_speed};
    }
    check_overlaps(house, path, fault);
    for (size_t c = 0; c < plan->crowd_count && fault->total == before; c++)
        place_crowd(house, c, path, fault);
    qsort(house->people, house->person_count, sizeof *house->people, compare_inhabitants);
    for (size_t i = 1; i < house->person_count; i++)
        if (strcmp(house->people[i].id, house->people[i - 1].id) == 0)
            fault_add(fault, "%s:1:1: person %s has the name of a member of a crowd, must have another", path,
                      house->people[i].id);
}

static void check_profile(const House *house, const char *path, size_t i, Fault *fault) {
    const Profile *profile = &house->profiles[i];
    char place[512];
    snprintf(place, sizeof place, "%.400s:1:1: profile %.60s", path, profile->name);
    profile_check(profile, house->plan.run.dt, place, fault);
}

static bool read_parts(House *house, const char *path, const HouseOptions *options, Fault *fault) {
    size_t before = fault->total;
    if (!plan_read(&house->plan, path, options->settings, options->setting_count, fault))
        return false;
    read_profiles(house, path, options, fault);
    if (fault->total == before)
        for (size_t i = 0; i < house->plan.override_count; i++)
            apply_override(house, &house->plan.overrides[i], fault);
    for (size_t i = 0; i < house->profile_count && fault->total == before; i++)
        check_profile(house, path, i, fault);
    if (fault->total != before || !outline_build(&house->outline, &house->plan, fault))
        return false;
    freespace_build(&house->space, &house->outline, house->plan.run.cell);
    if (house->space.cell > COARSEST_CELL)
        fault_add(fault, "%s:1:1: the house is too large for the route search, %.0f m by %.0f m: it must be smaller",
                  path, house->space.cell * house->space.nx, house->space.cell * house->space.ny);
    if (fault->total == before)
        place_people(house, path, fault);
    return fault->total == before;
}

bool house_read(House *house, const char *path, const HouseOptions *options, Fault *fault) {
    House read = {.seed = options->seed};
    if (!read_parts(&read, path, options, fault)) {
        house_free(&read);
        return false;
    }
    house_free(house);
    *house = read;
    house->space.outline = &house->outline;
    return true;
}

void house_free(House *house) {
    freespace_free(&house->space);
    outline_free(&house->outline);
    memory_free(house->people);
    for (size_t i = 0; i < house->profile_count; i++)
        profile_free(&house->profiles[i]);
    memory_free(house->profiles);
    plan_free(&house->plan);
    arena_clear(&house->arena);
    *house = (House){0};
}
