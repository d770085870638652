#include "house/populate.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "space/gap.h"

enum {
    PLACING_TRIES = 10000, /* random positions tried for one member of a crowd */
    MOST_CELLS = 1 << 22,
};

/* Standard deviations from the mean beyond which no speed is drawn: assumed. The cut is symmetric, so that the mean
 * stays the profile's. */
static const double SPEED_SPREAD = 2;

/* People by squares, so that a position is compared only with nearby people. */
typedef struct Squares {
    Box box;
    double side; /* m, at least the reach of two bodies */
    int nx, ny;
    int *first; /* (nx * ny) the last person placed in the square, or -1 */
    int *next;  /* (people) the person placed before in the same square, or -1 */
} Squares;

static double body_reach(const Profile *profile) {
    if (profile->driving == DRIVING_WALKER)
        return profile->width / 2;
    return vec2_length(vec2(fmax(profile->axle, profile->length - profile->axle), profile->width / 2));
}

static Squares squares_make(const House *house, size_t people) {
    double reach = 0;
    for (size_t i = 0; i < house->profile_count; i++)
        reach = fmax(reach, body_reach(&house->profiles[i]));
    Squares squares = {.box = house->outline.box};
    double width = box_width(squares.box), height = box_height(squares.box);
    squares.side = fmax(2 * reach, sqrt(width * height / MOST_CELLS));
    squares.nx = (int)fmin(width / squares.side, MOST_CELLS) + 1;
    squares.ny = (int)fmin(height / squares.side, MOST_CELLS) + 1;
    size_t count = (size_t)squares.nx * (size_t)squares.ny;
    squares.first = memory_zeroed(count, sizeof *squares.first);
    squares.next = memory_zeroed(people, sizeof *squares.next);
    for (size_t i = 0; i < count; i++)
        squares.first[i] = -1;
    return squares;
}

static void square_of(const Squares *squares, Vec2 at, int *x, int *y) {
    *x = (int)fmin(fmax((at.x - squares->box.low.x) / squares->side, 0), squares->nx - 1);
    *y = (int)fmin(fmax((at.y - squares->box.low.y) / squares->side, 0), squares->ny - 1);
}

/* Calls `meets` for the people in the squares round a position until it returns true. */
static int find_near(const Squares *squares, const House *house, const Inhabitant *placed,
                     bool (*meets)(const Inhabitant *one, const Inhabitant *other)) {
    int x, y;
    square_of(squares, placed->at, &x, &y);
    for (int j = y > 0 ? y - 1 : 0; j <= y + 1 && j < squares->ny; j++)
        for (int i = x > 0 ? x - 1 : 0; i <= x + 1 && i < squares->nx; i++)
            for (int k = squares->first[j * squares->nx + i]; k >= 0; k = squares->next[k])
                if (meets(placed, &house->people[k]))
                    return k;
    return -1;
}

static void add_person(House *house, Squares *squares, Inhabitant person) {
    int x, y, index = (int)house->person_count;
    square_of(squares, person.at, &x, &y);
    squares->next[index] = squares->first[y * squares->nx + x];
    squares->first[y * squares->nx + x] = index;
    house->people[house->person_count++] = person;
}

static const Profile *find_profile(const House *house, const char *name) {
    for (size_t i = 0; i < house->profile_count; i++)
        if (strcmp(house->profiles[i].name, name) == 0)
            return &house->profiles[i];
    return NULL;
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

static bool too_near(const Inhabitant *one, const Inhabitant *other) {
    return vec2_distance(one->at, other->at) < body_reach(one->profile) + body_reach(other->profile);
}

/* True if the bodies themselves overlap; the contact law would eject such people. */
static bool overlap(const Inhabitant *one, const Inhabitant *other) {
    if (!too_near(one, other))
        return false;
    Body bodies[2] = {body_of(one->profile), body_of(other->profile)};
    Gap gaps[GAPS_MOST];
    return gap_to_body(gaps, &bodies[0], house_centre(one), vec2_heading(one->heading), &bodies[1], house_centre(other),
                       vec2_heading(other->heading), 0) > 0;
}

/* Returns a crowd's own random stream, independent of its position in the file (FNV-1a). */
static uint64_t stream_of(const char *id) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (; *id; id++)
        hash = (hash ^ (unsigned char)*id) * 0x100000001b3u;
    return hash;
}

static double draw_speed(Random *random, const Profile *profile) {
    double least = profile->driving == DRIVING_WALKER ? 0.1 : profile->minimum_speed / 2; /* m/s */
    double deviation = profile->free_speed_deviation, mean = profile->free_speed;
    double cut = fmin(SPEED_SPREAD * deviation, mean - least);
    if (cut <= 0)
        return mean;
    for (;;) {
        double speed = random_normal(random, mean, deviation);
        if (fabs(speed - mean) <= cut)
            return speed;
    }
}

/* Places the members of a crowd in its area without overlaps. */
static void place_crowd(House *house, Squares *squares, size_t c, Fault *fault) {
    const Crowd *crowd = &house->plan.crowds[c];
    Random random = random_seed(house->seed, stream_of(crowd->id));
    Box box = box_empty();
    for (size_t i = 0; i < crowd->area.count; i++)
        box = box_include(box, crowd->area.at[i]);
    const PlanRoute *route = plan_route_of(&house->plan, crowd->id);
    for (int member = 0; member < crowd->count; member++) {
        Inhabitant placed = {.profile = find_profile(house, crowd->profile), .route = route, .delay = crowd->delay};
        double reach = body_reach(placed.profile);
        bool found = false;
        for (int tries = 0; tries < PLACING_TRIES && !found; tries++) {
            double u = random_uniform(&random), v = random_uniform(&random);
            placed.at = vec2(box.low.x + u * box_width(box), box.low.y + v * box_height(box));
            found = inside_outline(&crowd->area, placed.at) && freespace_distance(&house->space, placed.at) >= reach &&
                    find_near(squares, house, &placed, too_near) < 0;
        }
        if (!found) {
            fault_add(fault, "%scrowd %s: there is room for %d of its %d people, make the area larger", crowd->place,
                      crowd->id, member, crowd->count);
            return;
        }
        placed.heading = 2 * M_PI * random_uniform(&random);
        placed.speed = draw_speed(&random, placed.profile);
        size_t size = strlen(crowd->id) + 16;
        char *id = arena_allocate(&house->arena, size);
        snprintf(id, size, "%s-%d", crowd->id, member + 1);
        placed.id = id;
        add_person(house, squares, placed);
    }
}

static void place_person(House *house, Squares *squares, const Person *person, Fault *fault) {
    const Profile *profile = find_profile(house, person->profile);
    Inhabitant placed = {.id = person->id,
                         .profile = profile,
                         .route = plan_route_of(&house->plan, person->id),
                         .at = person->at,
                         .heading = radians(person->heading),
                         .delay = person->delay,
                         .speed = person->speed > 0 ? person->speed : profile->free_speed};
    int other = find_near(squares, house, &placed, overlap);
    if (other >= 0)
        fault_add(fault, "%sperson %s stands inside person %s, must stand apart", person->place, placed.id,
                  house->people[other].id);
    add_person(house, squares, placed);
}

static int compare_inhabitants(const void *a, const void *b) {
    const Inhabitant *p = a, *q = b;
    return strcmp(p->id, q->id);
}

bool populate_house(House *house, Fault *fault) {
    const Plan *plan = &house->plan;
    size_t count = plan->person_count, before = fault->total;
    for (size_t c = 0; c < plan->crowd_count; c++)
        count += (size_t)plan->crowds[c].count;
    house->people = memory_zeroed(count, sizeof *house->people);
    Squares squares = squares_make(house, count);
    for (size_t i = 0; i < plan->person_count; i++)
        place_person(house, &squares, &plan->people[i], fault);
    for (size_t c = 0; c < plan->crowd_count && fault->total == before; c++)
        place_crowd(house, &squares, c, fault);
    memory_free(squares.first);
    memory_free(squares.next);
    qsort(house->people, house->person_count, sizeof *house->people, compare_inhabitants);
    for (size_t i = 1; i < house->person_count; i++) {
        const char *id = house->people[i].id;
        if (strcmp(id, house->people[i - 1].id) == 0)
            fault_add(fault, "%sperson %s has the name of a member of a crowd; ids must be unique",
                      plan->people[plan_find_person(plan, id)].place, id);
    }
    return fault->total == before;
}
