#include "visual/house/blockage_scene.h"

#include <stdio.h>
#include <string.h>

#include "plan/plan_geometry.h"
#include "result/census.h"
#include "result/names.h"
#include "visual/house/silhouette.h"

/* Design points. */
#define BODY_EDGE 3.0
#define CROSS_WIDTH 4.0
#define DIMENSION_WIDTH 3.0
#define TEXT_SIZE 16.0

#define BODY_OPACITY 0.15
#define KEEP_BODY 4.0 /* weight against being covered by labels */
#define KEEP_SIGN 6.0
#define KEEP_NAME 6.0

#define CROSS_HALF 0.12 /* m */
#define NAME_REACH 0.25 /* m, half of a letter's tag */
#define AHEAD 0.10      /* m, from the body to the dimension in front of it */
#define SAME_PLACE 0.5  /* m: people who are stopped nearer to each other share a label */

bool blockage_scene_has(const PersonObservation *observed) {
    return observed->took_part && !observed->completed && *observed->blockage.what &&
           observation_reason_has_place(observed->reason);
}

const char *blockage_scene_widths(Scene *scene, const Blockage *blockage) {
    char widths[ROUTE_WIDTHS];
    Blockage alone = *blockage;
    *alone.beside = 0; /* the piece is seen */
    route_widths(&alone, widths, sizeof widths);
    return scene_text(scene, "%s", widths);
}

/* Returns the door that a text like "door d2" names, or NULL. */
static const Door *named_door(const Plan *plan, const char *what) {
    for (size_t i = 0; i < plan->door_count; i++) {
        char name[sizeof((Blockage *)0)->what];
        snprintf(name, sizeof name, "door %s", plan->doors[i].id);
        if (strcmp(name, what) == 0)
            return &plan->doors[i];
    }
    return NULL;
}

/* Returns the pose of a person who cannot pass: at the start of one who is caught or has no room there, across a door's
 * line, where the chair sticks, otherwise on the route from the start. */
static Pose pose_before(const Plan *plan, const Inhabitant *person, const Blockage *blockage) {
    Vec2 way = vec2_sub(blockage->at, person->at);
    const Door *door = named_door(plan, blockage->what);
    if (person->under || census_start(blockage))
        return (Pose){.at = person->at, .heading = person->heading};
    if (door) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, door, &from, &to);
        Vec2 across = vec2_left(vec2_sub(to, from));
        way = vec2_dot(across, way) < 0 ? vec2_scale(across, -1) : across;
    }
    bool posed = blockage->posed && !door;
    Pose pose = {.heading = posed ? blockage->heading : atan2(way.y, way.x)};
    Vec2 middle = posed ? blockage->middle : blockage->at;
    pose.at = vec2_sub(middle, silhouette_middle(person->profile, vec2(0, 0), pose.heading));
    return pose;
}

static void add_body(Scene *scene, const Profile *profile, Pose pose) {
    Primitive *body = silhouette_add(scene, ROLE_ERROR, profile, pose);
    body->fill_opacity = BODY_OPACITY;
    body->width = BODY_EDGE;
    body->style = LINE_DASHED;
    body->keep_clear = KEEP_BODY;
}

static void add_cross(Scene *scene, Vec2 at) {
    for (int sign = -1; sign <= 1; sign += 2) {
        Vec2 arm = vec2(CROSS_HALF, sign * CROSS_HALF);
        Vec2 ends[] = {vec2_sub(at, arm), vec2_add(at, arm)};
        scene_add_line(scene, ROLE_ERROR, CROSS_WIDTH, ends, 2)->keep_clear = KEEP_SIGN;
    }
}

/* Returns the door's width that is free of the body in it. */
static void add_width(Scene *scene, const Plan *plan, const Door *door, const Profile *profile, double heading) {
    Vec2 from, to, ahead = vec2_scale(vec2_heading(heading), profile->length / 2 + AHEAD);
    plan_geometry_door_ends(plan, door, &from, &to);
    scene_add_dimension(scene, ROLE_ERROR, DIMENSION_WIDTH, vec2_add(from, ahead), vec2_add(to, ahead))->keep_clear =
        KEEP_SIGN;
}

/* Keeps the place of the person's letter free of tags: it stands above the body. */
static void keep_name_clear(Scene *scene, const Profile *profile, Pose pose) {
    Vec2 middle = silhouette_middle(profile, pose.at, pose.heading);
    Primitive *place = scene_add_discs(scene, ROLE_CHAIR, NAME_REACH, &middle, 1);
    place->base = SILHOUETTE_NAME_HEIGHT;
    place->fill_opacity = 0;
    place->width = 0;
    place->keep_clear = KEEP_NAME;
}

void blockage_scene_add(Scene *scene, const House *house, const Observation *observation, size_t person,
                        const Trail *trail) {
    const Inhabitant *inhabitant = &house->people[person];
    const PersonObservation *observed = &observation->people[person];
    const Blockage *blockage = &observed->blockage;
    bool stuck = observed->reason == REASON_BLOCKED && trail->count > 0;
    Pose pose = stuck ? trail_pose(trail, trail_end(trail)) : pose_before(&house->plan, inhabitant, blockage);
    add_body(scene, inhabitant->profile, pose);
    keep_name_clear(scene, inhabitant->profile,
                    stuck ? pose : (Pose){.at = inhabitant->at, .heading = inhabitant->heading});
    add_cross(scene, blockage->at);
    const Door *door = named_door(&house->plan, blockage->what);
    if (!stuck && door && blockage->needs > blockage->has)
        add_width(scene, &house->plan, door, inhabitant->profile, pose.heading);
}

static void add_label(Scene *scene, const House *house, const Blockage *blockage) {
    const char *widths = blockage_scene_widths(scene, blockage);
    Primitive *tag = scene_add_label(scene, ROLE_TEXT, TEXT_SIZE, blockage->at,
                                     *widths ? widths : names_text(house, blockage->what, &scene->arena));
    tag->fill = ROLE_ERROR;
    tag->shape = LABEL_TAG;
    tag->bold = tag->leader = true;
}

/* True if another person is stopped at the same place, by a larger body or an equal one that comes first. */
static bool is_told_by_another(const Observation *observation, size_t person) {
    const Blockage *mine = &observation->people[person].blockage;
    for (size_t i = 0; i < observation->person_count; i++) {
        const Blockage *other = &observation->people[i].blockage;
        if (i == person || !blockage_scene_has(&observation->people[i]) || strcmp(other->what, mine->what) != 0 ||
            vec2_distance(other->at, mine->at) > SAME_PLACE)
            continue;
        if (other->needs > mine->needs || (other->needs == mine->needs && i < person))
            return true;
    }
    return false;
}

void blockage_scene_labels(Scene *scene, const House *house, const Observation *observation) {
    for (size_t i = 0; i < observation->person_count; i++)
        if (blockage_scene_has(&observation->people[i]) && !is_told_by_another(observation, i))
            add_label(scene, house, &observation->people[i].blockage);
}
