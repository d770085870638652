/* What is said of what is selected in a house: at the top of the panel. */
#include <ctype.h>
#include <stdio.h>

#include "visual/house/blockage_scene.h"
#include "laboratory/house/session_parts.h"
#include "visual/house/people_scene.h"

static void add_pair(HouseSession *live, const char *what, const char *value) {
    house_words_add(live, ROW_PLAIN, what)->row.cells[1] = value;
}

static void say_moment(HouseSession *live, size_t person, double time) {
    Scene *scene = &live->words.moment;
    const double *row = trail_row_at(&live->trails.trails[person], time);
    if (!row)
        return;
    double reach = live->shown->house.people[person].profile->space_reach;
    bool free = row[TRACE_CLEARANCE] >= reach;
    add_pair(live, "speed now", scene_text(scene, "%.2f m/s", row[TRACE_SPEED]));
    add_pair(live, "clearance now",
             free ? scene_text(scene, "over %.2f m", reach) : people_scene_clearance(scene, row[TRACE_CLEARANCE]));
    add_pair(live, "contact force now", scene_text(scene, "%.0f N", row[TRACE_BODY_FORCE]));
}

static const char *result_of(HouseSession *live, const PersonObservation *observed) {
    if (observed->completed)
        return scene_text(&live->words.moment, "out in %.1f s", observed->time);
    return live->whole ? observation_reason(observed->reason) : "on the way";
}

static void say_narrowest(HouseSession *live, size_t person) {
    Scene *scene = &live->words.moment;
    const House *house = &live->shown->house;
    const PersonObservation *observed = &live->observation->people[person];
    char place[HOUSE_THING_NAME];
    if (!(observed->narrowest < house->people[person].profile->space_reach)) {
        add_pair(live, "narrowest", "stays free");
        return;
    }
    if (observed->narrowest_other >= 0)
        snprintf(place, sizeof place, "person %s", house->people[observed->narrowest_other].id);
    else
        outline_place_name(&house->outline, &house->plan, observed->narrowest_to, place, sizeof place);
    add_pair(live, scene_text(scene, "narrowest, %s", place), people_scene_clearance(scene, observed->narrowest));
}

static void say_person(HouseSession *live, size_t i, double time) {
    Scene *scene = &live->words.moment;
    const Inhabitant *person = &live->shown->house.people[i];
    const PersonObservation *observed = &live->observation->people[i];
    add_pair(live, "profile", arena_text(&scene->arena, person->profile->name));
    if (person->route)
        add_pair(live, "route", arena_text(&scene->arena, person->route->id));
    if (!observed->took_part) {
        add_pair(live, "takes no part", NULL);
        return;
    }
    add_pair(live, "result", result_of(live, observed));
    add_pair(live, "length of the way", scene_text(scene, "%.2f m", observed->path_length));
    say_narrowest(live, i);
    add_pair(live, "contacts", scene_text(scene, "%d", observed->contacts));
    if (observed->contacts)
        add_pair(live, "hardest contact", scene_text(scene, "%.0f N", observed->peak_force));
    add_pair(live, "personal space pressed", scene_text(scene, "%.1f s", observed->ring_time));
    say_moment(live, i, time);
}

static void say_door(HouseSession *live, const Door *door) {
    static const char *const kinds[] = {"opening", "hinged", "sliding"}, *const states[] = {"open", "closed", "locked"};
    Scene *scene = &live->words.moment;
    add_pair(live, "clear width", scene_text(scene, "%.3f m", door->width));
    add_pair(live, "kind", kinds[door->kind]);
    add_pair(live, "state", states[door->state]);
    add_pair(live, "in wall", arena_text(&scene->arena, door->wall));
}

static void say_hazard(HouseSession *live, const Hazard *hazard) {
    Scene *scene = &live->words.moment;
    add_pair(live, "clearance", people_scene_clearance(scene, hazard->clearance));
    add_pair(live, "hardest contact", scene_text(scene, "%.0f N", hazard->peak_force));
    add_pair(live, "lost time", scene_text(scene, "%.1f s", hazard->lost_time));
}

void house_about_say(HouseSession *live, double time) {
    Scene *scene = &live->words.moment;
    const Plan *plan = &live->shown->house.plan;
    Item thing = live->selected;
    char name[HOUSE_THING_NAME];
    house_item_name(&live->shown->house, live->observation, thing, name, sizeof name);
    if (!*name)
        return;
    *name = (char)toupper((unsigned char)*name);
    house_words_add(live, ROW_HEADING, scene_text(scene, "%s", name));
    if (thing.kind == HOUSE_PERSON) {
        say_person(live, thing.index, time);
    } else if (thing.kind == HOUSE_HAZARD) {
        say_hazard(live, &live->observation->hazards[thing.index]);
    } else if (thing.kind == HOUSE_STOP) {
        const char *widths = blockage_scene_widths(scene, &live->observation->people[thing.index].blockage);
        if (*widths)
            house_words_add(live, ROW_PLAIN, widths);
    } else if (thing.kind == HOUSE_DOOR) {
        say_door(live, &plan->doors[thing.index]);
    } else if (thing.kind == HOUSE_FURNITURE) {
        const Furniture *piece = &plan->furniture[thing.index];
        add_pair(live, "size", scene_text(scene, "%.2f x %.2f m", piece->size.x, piece->size.y));
        add_pair(live, "height", scene_text(scene, "%.2f m", piece->height));
        add_pair(live, "toppled", piece->toppled ? "yes" : "no");
    } else if (thing.kind == HOUSE_WALL) {
        add_pair(live, "thickness", scene_text(scene, "%.3f m", plan->walls[thing.index].thickness));
    } else if (thing.kind == HOUSE_EXIT) {
        const Exit *exit = &plan->exits[thing.index];
        add_pair(live, "width", scene_text(scene, "%.2f m", vec2_distance(exit->from, exit->to)));
    }
}
