#include "visual/house/people_scene.h"

#include <string.h>

#include "result/names.h"
#include "result/tight.h"
#include "visual/house/blockage_scene.h"
#include "result/census.h"
#include "visual/house/silhouette.h"
#include "result/headline.h"
#include "visual/house/space_scene.h"

/* Design points. */
#define LOCUS_WIDTH 4.0
#define AHEAD_WIDTH 1.5 /* design points, of the future locus */
#define TICK_WIDTH 2.0
#define TICK_SMALL 11.0
#define TICK_LARGE 19.0
#define GHOST_EDGE 1.5
#define START_EDGE 2.0
#define DIMENSION_WIDTH 3.0
#define TEXT_SIZE 16.0
#define TICK_TEXT 16.0
#define DISC_TEXT 16.0

#define SWEPT_OPACITY 0.10
#define GHOST_OPACITY 0.10
#define GHOST_EDGE_OPACITY 0.55
#define RING_OPACITY 0.75

/* Weights against being covered by labels. */
#define KEEP_LOCUS 1.5
#define KEEP_START 4.0
#define KEEP_GHOST 0.15
#define KEEP_RING 0.3
#define KEEP_NARROWEST 6.0

#define GHOST_APART 0.3   /* m, between the loci of two runs where one of them is named */
#define NUMBER_SECONDS 5  /* ticks from number to number */
#define GHOST_SECONDS 2.0 /* from body to body */
#define GHOSTS_MOST 12    /* bodies on one locus */
#define TICK_APART 0.05   /* m: ticks of a standing person count as one */
#define SWEPT_STEP 0.05   /* m, from hull to hull; rounded corners hide the rest */
#define SWEPT_TURN 0.05   /* rad */

enum { ROWS_SKIPPED = 6 /* of a trail, from place to place */ };

/* Scores, see hazard.h: 1 is zero clearance, or the threshold of force or lost time. */
#define DANGER_MIDDLE 1.0
#define DANGER_HIGH 3.0

const LocusLook PEOPLE_SCENE_SPACE = {ROLE_RING, LINE_DASHED, 2};
const LocusLook PEOPLE_SCENE_PRESSED = {ROLE_RING, LINE_SOLID, 3.5};

LocusLook people_scene_nth_look(size_t index) {
    static const LocusLook looks[] = {{ROLE_LOCUS, LINE_SOLID, LOCUS_WIDTH},
                                      {ROLE_LOCUS_SECOND, LINE_DASHED, LOCUS_WIDTH},
                                      {ROLE_LOCUS_THIRD, LINE_DASH_DOT, LOCUS_WIDTH},
                                      {ROLE_LOCUS_FOURTH, LINE_DOTTED, LOCUS_WIDTH}};
    return looks[index % (sizeof looks / sizeof *looks)];
}

LocusLook people_scene_look(const House *house, size_t person) {
    const PlanRoute *route = house->people[person].route;
    return people_scene_nth_look(route ? (size_t)(route - house->plan.routes) : person);
}

Role people_scene_danger(const Hazard *hazard) {
    return hazard->score >= DANGER_HIGH     ? ROLE_DANGER_HIGH
           : hazard->score >= DANGER_MIDDLE ? ROLE_DANGER_MIDDLE
                                            : ROLE_DANGER_LOW;
}

/* Adds the union of the bodies along the locus, as hulls of overlapping neighbours. */
static void add_swept(Scene *scene, const Profile *profile, const Trail *trail, Role role) {
    Vec2 *points = memory_zeroed(trail->count * 2 * SILHOUETTE_POINTS, sizeof *points);
    size_t *starts = memory_zeroed(trail->count + 1, sizeof *starts), rings = 0;
    Pose last = trail_pose(trail, trail_begin(trail));
    Vec2 outlines[2][SILHOUETTE_POINTS];
    silhouette_outline(profile, last.at, last.heading, 0, outlines[0]);
    for (size_t i = 1; i < trail->count; i++) {
        const double *row = trail->rows[i];
        Pose pose = {.at = {row[TRACE_X], row[TRACE_Y]}, .heading = row[TRACE_HEADING]};
        if (vec2_distance(pose.at, last.at) < SWEPT_STEP && fabs(pose.heading - last.heading) < SWEPT_TURN &&
            i + 1 < trail->count)
            continue;
        silhouette_outline(profile, pose.at, pose.heading, 0, outlines[1]);
        starts[rings + 1] = starts[rings] + silhouette_hull(outlines[0], outlines[1], points + starts[rings]);
        rings++;
        memcpy(outlines[0], outlines[1], sizeof outlines[0]);
        last = pose;
    }
    Primitive *swept = scene_add_rings(scene, role, points, starts, rings);
    swept->fill_opacity = SWEPT_OPACITY;
    swept->united = true;
    memory_free(points);
    memory_free(starts);
}

void people_scene_body(Scene *scene, const Profile *profile, Pose pose, Role role) {
    Primitive *body = silhouette_add(scene, role, profile, pose);
    body->fill_opacity = GHOST_OPACITY;
    body->edge_opacity = GHOST_EDGE_OPACITY;
    body->width = GHOST_EDGE;
    body->keep_clear = KEEP_GHOST;
}

void people_scene_dress_ring(Primitive *ring, bool pressed) {
    LocusLook look = pressed ? PEOPLE_SCENE_PRESSED : PEOPLE_SCENE_SPACE;
    ring->edge = look.role;
    ring->style = look.style;
    ring->width = look.width;
}

/* Adds the personal space as walls and furniture press it in. */
static void add_ring(Scene *scene, const House *house, size_t person, Pose pose, Role role, bool compressed) {
    Standing standing = {.profile = house->people[person].profile, .pose = pose, .person = person};
    Primitive *ring = space_scene_add(scene, house, NULL, &standing, 1, 0);
    people_scene_dress_ring(ring, compressed);
    ring->edge = role;
    ring->edge_opacity = RING_OPACITY;
    ring->keep_clear = KEEP_RING;
}

double people_scene_least_interval(bool several) {
    return several ? 2 * GHOST_SECONDS : GHOST_SECONDS;
}

double people_scene_interval(const Trail *trail, bool several) {
    double least = people_scene_least_interval(several);
    double duration = trail_end(trail) - trail_begin(trail);
    return fmax(least, ceil(duration / (GHOSTS_MOST * GHOST_SECONDS)) * GHOST_SECONDS);
}

/* Adds bodies at regular times where they have room, every second one with its personal space; where several loci
 * overlap, fewer bodies and no personal space. */
static void add_bodies(Scene *scene, const House *house, size_t person, const Trail *trail, Role role, bool several) {
    const Profile *profile = house->people[person].profile;
    double interval = people_scene_interval(trail, several);
    Pose last = trail_pose(trail, trail_begin(trail));
    int shown = 0;
    for (double time = trail_begin(trail) + interval; time < trail_end(trail); time += interval) {
        Pose pose = trail_pose(trail, time);
        if (vec2_distance(pose.at, last.at) < PEOPLE_SCENE_APART * profile->length)
            continue;
        people_scene_body(scene, profile, pose, role);
        if (++shown % 2 == 0 && !several)
            add_ring(scene, house, person, pose, role, trail_compression(trail, time, time) > PEOPLE_SCENE_COMPRESSED);
        last = pose;
    }
}

static void add_locus(Scene *scene, const Trail *trail, LocusLook look) {
    Vec2 *points = memory_zeroed(trail->count, sizeof *points);
    for (size_t i = 0; i < trail->count; i++)
        points[i] = vec2(trail->rows[i][TRACE_X], trail->rows[i][TRACE_Y]);
    Primitive *locus = scene_add_line(scene, look.role, look.width, points, trail->count);
    locus->style = look.style;
    locus->keep_clear = KEEP_LOCUS;
    memory_free(points);
}

void people_scene_ghost(Scene *scene, const Observation *before) {
    static const LocusLook look = {ROLE_GHOST, LINE_DASHED, AHEAD_WIDTH};
    Trail *trails = trail_list(before);
    for (size_t i = 0; i < before->person_count; i++)
        if (trails[i].count > 1)
            add_locus(scene, &trails[i], look);
    trail_free_list(trails);
}

/* Returns the least distance from a place to the rows of the trails (count), m. */
static double apart(const Trail *trails, size_t count, Vec2 at) {
    double least = HUGE_VAL;
    for (size_t i = 0; i < count; i++)
        for (size_t r = 0; r < trails[i].count; r += ROWS_SKIPPED)
            least = fmin(least, vec2_distance(at, vec2(trails[i].rows[r][TRACE_X], trails[i].rows[r][TRACE_Y])));
    return least;
}

void people_scene_ghost_label(Scene *scene, const Observation *before, const Trail *trails, size_t trail_count,
                              const char *name) {
    Trail *ghosts = trail_list(before);
    for (size_t i = 0; i < before->person_count; i++)
        for (size_t r = 0; r < ghosts[i].count; r += ROWS_SKIPPED) {
            Vec2 at = vec2(ghosts[i].rows[r][TRACE_X], ghosts[i].rows[r][TRACE_Y]);
            if (apart(trails, trail_count, at) < GHOST_APART)
                continue;
            scene_add_label(scene, ROLE_GHOST, TEXT_SIZE, at, name)->bold = true;
            trail_free_list(ghosts);
            return;
        }
    trail_free_list(ghosts);
}

void people_scene_ahead(Scene *scene, const House *house, const Trail *trails) {
    for (size_t i = 0; i < house->person_count; i++) {
        LocusLook look = people_scene_look(house, i);
        look.width = AHEAD_WIDTH;
        if (trails[i].count > 1)
            add_locus(scene, &trails[i], look);
    }
}

/* Adds ticks at the whole seconds at which a person has moved on. */
typedef struct Tick {
    const Trail *trail;
    Pose pose;
    double time; /* s */
    bool numbered;
} Tick;

static Tick first_tick(const Trail *trail) {
    double begin = trail_begin(trail);
    return (Tick){
        .trail = trail, .pose = trail_pose(trail, begin), .time = floor(begin / PEOPLE_SCENE_TICK) * PEOPLE_SCENE_TICK};
}

static bool next_tick(Tick *tick) {
    Vec2 last = tick->pose.at;
    do {
        tick->time += PEOPLE_SCENE_TICK;
        tick->pose = trail_pose(tick->trail, tick->time);
    } while (tick->time < trail_end(tick->trail) && vec2_distance(tick->pose.at, last) < TICK_APART);
    tick->numbered = fmod(round(tick->time / PEOPLE_SCENE_TICK), NUMBER_SECONDS) < 0.5;
    return tick->time < trail_end(tick->trail);
}

void people_scene_ticks(Scene *scene, const Trail *trail, Role role, double from, double to) {
    if (floor(from / PEOPLE_SCENE_TICK) == floor(to / PEOPLE_SCENE_TICK))
        return; /* most pieces of a film hold none */
    Tick tick = first_tick(trail);
    while (next_tick(&tick) && tick.time <= to) {
        Vec2 towards = vec2_add(tick.pose.at, vec2_heading(tick.pose.heading));
        if (tick.time > from)
            scene_add_tick(scene, role, TICK_WIDTH, tick.numbered ? TICK_LARGE : TICK_SMALL, tick.pose.at, towards);
    }
}

/* Adds an arrow in the front half of a body, leaving the rear for the name. */
static void add_arrow(Scene *scene, const Profile *profile, const Inhabitant *person) {
    Vec2 axis = vec2_heading(person->heading), middle = silhouette_middle(profile, person->at, person->heading);
    double half = 0.32 * profile->width, front = 0.40 * profile->length, back = 0.06 * profile->length;
    Vec2 arrow[] = {vec2_along(middle, front, axis), vec2_along(vec2_along(middle, back, axis), half, vec2_left(axis)),
                    vec2_along(vec2_along(middle, back, axis), -half, vec2_left(axis))};
    scene_add_polygon(scene, ROLE_PAPER, arrow, 3);
}

bool people_scene_is_drawn(const Observation *observation, size_t person, double time, bool crowd) {
    const PersonObservation *observed = &observation->people[person];
    bool last = !crowd && observed->time >= observation->time;
    return !observed->completed || last || time <= observed->time + (crowd ? 0 : PEOPLE_SCENE_STAY);
}

void people_scene_start(Scene *scene, const Inhabitant *person, Role role) {
    const Profile *profile = person->profile;
    bool walker = census_walks(profile);
    Primitive *body = silhouette_add(scene, role, profile, (Pose){.at = person->at, .heading = person->heading});
    body->edge = ROLE_WALL;
    body->width = walker ? GHOST_EDGE : START_EDGE;
    body->keep_clear = KEEP_START;
    if (!walker)
        add_arrow(scene, profile, person);
}

static void add_narrowest(Scene *scene, const House *house, const Observation *observation) {
    size_t person = census_narrowest(house, observation);
    if (person == SIZE_MAX)
        return;
    const PersonObservation *observed = &observation->people[person];
    const Profile *profile = house->people[person].profile;
    Pose pose = {.at = observed->narrowest_at, .heading = observed->narrowest_heading};
    Vec2 outline[SILHOUETTE_POINTS];
    silhouette_outline(profile, pose.at, pose.heading, 0, outline);
    people_scene_body(scene, profile, pose, ROLE_TEXT);
    scene_add_dimension(scene, ROLE_TEXT, DIMENSION_WIDTH, silhouette_nearest(outline, observed->narrowest_to),
                        observed->narrowest_to)
        ->keep_clear = KEEP_NARROWEST;
}

static void add_way(Scene *scene, const House *house, const Trail *trail, size_t person) {
    const Profile *profile = house->people[person].profile;
    LocusLook look = people_scene_look(house, person);
    add_swept(scene, profile, trail, look.role);
    add_bodies(scene, house, person, trail, look.role, house->person_count > PEOPLE_SCENE_SEVERAL);
    add_locus(scene, trail, look);
    people_scene_ticks(scene, trail, look.role, -HUGE_VAL, HUGE_VAL);
}

void people_scene_ways(Scene *scene, const House *house, const Observation *observation) {
    Trail *trails = trail_list(observation);
    for (size_t i = 0; i < observation->person_count; i++)
        if (trails[i].count > 1)
            add_way(scene, house, &trails[i], i);
    for (size_t i = 0; i < house->person_count; i++)
        if (observation->people[i].took_part)
            people_scene_start(scene, &house->people[i],
                               census_walks(house->people[i].profile) ? ROLE_WALKER : ROLE_CHAIR);
    for (size_t i = 0; i < house->person_count; i++)
        if (blockage_scene_has(&observation->people[i]))
            blockage_scene_add(scene, house, observation, i, &trails[i]);
    add_narrowest(scene, house, observation);
    trail_free_list(trails);
}

void people_scene_hazards(Scene *scene, const House *house, const Observation *observation) {
    Tight tight[TIGHT_MOST];
    size_t count = tight_places(house, observation, tight);
    for (size_t i = 0; i < count; i++) {
        const Hazard *hazard = &observation->hazards[tight[i].hazard];
        Primitive *disc = scene_add_label(scene, ROLE_TEXT, DISC_TEXT, hazard->at, scene_text(scene, "%zu", i + 1));
        disc->fill = people_scene_danger(hazard);
        disc->shape = LABEL_DISC;
        disc->bold = disc->leader = true;
    }
}

static Primitive *add_tag(Scene *scene, Role fill, Vec2 at, const char *text) {
    Primitive *tag = scene_add_label(scene, ROLE_TEXT, TEXT_SIZE, at, text);
    tag->fill = fill;
    tag->shape = LABEL_TAG;
    tag->bold = true;
    return tag;
}

static void add_narrowest_label(Scene *scene, const House *house, const Observation *observation) {
    size_t person = census_narrowest(house, observation);
    if (person == SIZE_MAX)
        return;
    const PersonObservation *observed = &observation->people[person];
    const char *text = headline_clearance(observed->narrowest, &scene->arena);
    add_tag(scene, ROLE_WALL, observed->narrowest_to, text)->leader = true;
}

static void add_person_labels(Scene *scene, const House *house, size_t i) {
    const Inhabitant *person = &house->people[i];
    const Profile *profile = person->profile;
    Vec2 middle = silhouette_middle(profile, person->at, person->heading);
    Vec2 rear = vec2_along(middle, -profile->length / 4, vec2_heading(person->heading));
    Vec2 outline[SILHOUETTE_POINTS];
    silhouette_outline(profile, person->at, person->heading, 0, outline);
    Primitive *name =
        add_tag(scene, census_walks(profile) ? ROLE_WALKER : ROLE_CHAIR, rear, names_person(house, i, &scene->arena));
    scene_bind_label(scene, name, outline, SILHOUETTE_POINTS);
}

static void add_route_label(Scene *scene, const House *house, const Trail *trail, size_t i) {
    double behind = 0.75 * house->people[i].profile->length;
    Vec2 start = trail_pose(trail, trail_begin(trail)).at;
    double time = trail_begin(trail);
    while (time < trail_end(trail) && vec2_distance(trail_pose(trail, time).at, start) < behind)
        time += PEOPLE_SCENE_TICK / 4;
    add_tag(scene, people_scene_look(house, i).role, trail_pose(trail, time).at, names_person(house, i, &scene->arena));
}

static void add_tick_numbers(Scene *scene, const Trail *trail, Role role) {
    Tick tick = first_tick(trail);
    while (next_tick(&tick))
        if (tick.numbered)
            scene_add_label(scene, role, TICK_TEXT, tick.pose.at, scene_text(scene, "%.0f s", tick.time))->optional =
                true;
}

void people_scene_labels(Scene *scene, const House *house, const Observation *observation) {
    Trail *trails = trail_list(observation);
    blockage_scene_labels(scene, house, observation);
    add_narrowest_label(scene, house, observation);
    for (size_t i = 0; i < house->person_count; i++)
        if (observation->people[i].took_part)
            add_person_labels(scene, house, i);
    people_scene_hazards(scene, house, observation);
    for (size_t i = 0; i < house->person_count; i++)
        if (trails[i].count > 1 && house->people[i].route)
            add_route_label(scene, house, &trails[i], i);
    for (size_t i = 0; i < house->person_count && house->person_count <= PEOPLE_SCENE_SEVERAL; i++)
        if (trails[i].count > 1)
            add_tick_numbers(scene, &trails[i], people_scene_look(house, i).role);
    trail_free_list(trails);
}
