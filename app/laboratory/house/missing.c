#include "laboratory/house/missing.h"

#include <stdio.h>
#include <string.h>

#include "laboratory/edit/editor.h"

/* m beside a wall's face, where its rooms are looked for. */
static const double BESIDE = 0.15;

/* Returns the name of the room at a place; NULL: none, or it has no name. */
static const char *room_at(const Plan *plan, Vec2 at) {
    for (size_t r = 0; r < plan->room_count; r++) {
        const Points *outline = &plan->rooms[r].outline;
        bool inside = false;
        for (size_t i = 0, j = outline->count - 1; i < outline->count; j = i++) {
            Vec2 a = outline->at[i], b = outline->at[j];
            if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x))
                inside = !inside;
        }
        if (inside)
            return *plan->rooms[r].name ? plan->rooms[r].name : NULL;
    }
    return NULL;
}

/* Returns "the wall between bedroom and corridor", or "wall w3" if the rooms have no names. */
static const char *wall_name(const Plan *plan, const Blockage *blockage, Scene *scene) {
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Wall *wall = &plan->walls[w];
        for (size_t s = 0; strcmp(blockage->what + strlen("wall "), wall->id) == 0 && s + 1 < wall->points.count; s++) {
            Vec2 a = wall->points.at[s], b = wall->points.at[s + 1], foot = vec2_nearest_on_segment(blockage->at, a, b);
            if (vec2_distance(foot, blockage->at) > wall->thickness)
                continue;
            Vec2 side = vec2_scale(vec2_left(vec2_unit(vec2_sub(b, a))), wall->thickness / 2 + BESIDE);
            const char *left = room_at(plan, vec2_add(foot, side)), *right = room_at(plan, vec2_sub(foot, side));
            if (left && right && strcmp(left, right) != 0)
                return scene_text(scene, "the wall between %s and %s", left, right);
        }
    }
    return scene_text(scene, "%s", blockage->what);
}

/* True if walls without a door are all that keeps the first stuck person inside. */
static bool lacks_door(const House *house, const Observation *observation, Scene *scene, Missing *missing) {
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        const Blockage *blockage = &person->blockage;
        if (person->reason != REASON_CANNOT_PASS || blockage->has > 0 || strncmp(blockage->what, "wall ", 5) != 0)
            continue;
        *missing =
            (Missing){.title = "Room without a door", .cure = "Add a door", .tool = TOOL_DOOR, .role = ROLE_ERROR};
        missing->detail = scene_text(scene, "D on %s", wall_name(&house->plan, blockage, scene));
        size_t exit = observation_closed_exit(house, observation);
        if (exit != SIZE_MAX) {
            missing->title = scene_text(scene, "No opening at exit %s: add a door", house->plan.exits[exit].id);
            missing->detail = scene_text(scene, "It lies on solid %s.", blockage->what);
        }
        return true;
    }
    return false;
}

bool missing_find(const House *house, const Observation *observation, Scene *scene, Missing *missing) {
    const Plan *plan = &house->plan;
    *missing = (Missing){.detail = "", .role = ROLE_TEXT};
    if (!plan->wall_count && !house->person_count && !plan->exit_count) {
        missing->title = "No plan yet";
        missing->detail = "Draw four walls (W).";
        missing->cure = "Draw walls";
        missing->tool = TOOL_WALL;
    } else if (!plan->exit_count && plan->wall_count) {
        missing->title = "No exit yet";
        missing->detail = "Add an exit (X) on a door or an opening.";
        missing->cure = "Add an exit";
        missing->tool = TOOL_EXIT;
    } else if (!house->person_count) {
        missing->title = "Nobody is here";
        missing->detail = "Place somebody (P).";
        missing->cure = "Place somebody";
        missing->tool = TOOL_PERSON;
    }
    return missing->title || lacks_door(house, observation, scene, missing);
}
