/* What is said of what is selected in a house: at the top of the panel. */
#include <ctype.h>
#include <stdio.h>

#include "visual/house/blockage_scene.h"
#include "laboratory/house/session_parts.h"
#include "result/house.h"
#include "result/panel.h"
#include "visual/house/people_scene.h"

static void add_pair(HouseSession *live, const char *what, const char *value) {
    house_words_add(live, ROW_PLAIN, what)->row.cells[1] = value;
}

static void say_moment(HouseSession *live, size_t person, double time) {
    Scene *scene = &live->words.moment;
    const double *row = trail_row_at(&live->trails.trails[person], time);
    if (!row)
        return;
    double reach = live->runs[RUN_SHOWN]->house.people[person].profile->space_reach;
    bool free = row[TRACE_CLEARANCE] >= reach;
    add_pair(live, "speed now", scene_text(scene, "%.2f m/s", row[TRACE_SPEED]));
    add_pair(live, "clearance now",
             free ? scene_text(scene, "over %.2f m", reach) : people_scene_clearance(scene, row[TRACE_CLEARANCE]));
    add_pair(live, "contact force now", scene_text(scene, "%.0f N", row[TRACE_BODY_FORCE]));
}

/* Adds a row for each fact of a record that has a value, from row `first` on. */
static void add_record(HouseSession *live, ResultTable *table, size_t first) {
    Arena *arena = &live->words.moment.arena;
    for (size_t r = first; r < table->row_count; r++) {
        SceneRow line;
        const ResultRow *row = result_at(table, 0, r);
        if (!result_panel_row(&line, row, arena))
            continue;
        line.cells[1] = arena_text(arena, line.cells[1]);
        house_words_add(live, line.kind, NULL)->row = line;
    }
    result_clear(table);
}

static void say_person(HouseSession *live, size_t i, double time) {
    if (!live->observation->people[i].took_part) {
        add_pair(live, "not in this run", NULL);
        return;
    }
    ResultTable table = {0};
    result_house_add_person(&table, &live->runs[RUN_SHOWN]->house, live->observation, i);
    add_record(live, &table, 1); /* the name is the heading */
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

static void say_hazard(HouseSession *live, size_t hazard) {
    ResultTable table = {0};
    result_house_add_hazard(&table, live->observation, hazard);
    add_record(live, &table, 1); /* the rank is in the heading */
}

void house_about_say(HouseSession *live, double time) {
    Scene *scene = &live->words.moment;
    const Plan *plan = &live->runs[RUN_SHOWN]->house.plan;
    Item thing = live->selected;
    char name[HOUSE_THING_NAME];
    house_item_name(&live->runs[RUN_SHOWN]->house, live->observation, thing, name, sizeof name);
    if (!*name)
        return;
    *name = (char)toupper((unsigned char)*name);
    house_words_add(live, ROW_HEADING, scene_text(scene, "%s", name));
    if (thing.kind == HOUSE_PERSON) {
        say_person(live, thing.index, time);
    } else if (thing.kind == HOUSE_HAZARD) {
        say_hazard(live, thing.index);
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
