#include "laboratory/house/missing.h"

#include <stdio.h>
#include <string.h>

#include "laboratory/edit/editor.h"
#include "result/names.h"

/* Returns "the wall between bedroom and corridor", or "wall w3" if the rooms have no names. */
static const char *wall_name(const Plan *plan, const Blockage *blockage, Scene *scene) {
    Arena arena = {0};
    const char *text = scene_text(scene, "%s", blockage->what);
    for (size_t w = 0; w < plan->wall_count; w++) {
        if (strcmp(blockage->what + strlen("wall "), plan->walls[w].id) != 0)
            continue;
        const char *name = names_wall_at(plan, w, blockage->at, &arena);
        if (strcmp(name, "wall") != 0)
            text = scene_text(scene, "the %s", name);
    }
    arena_clear(&arena);
    return text;
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
        missing->at = blockage->at;
        missing->detail = scene_text(scene, "Add a door (D) in %s", wall_name(&house->plan, blockage, scene));
        size_t exit = observation_walled_exit(house, observation);
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
    *missing = (Missing){.detail = "", .role = ROLE_TEXT, .at = {NAN, NAN}};
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
