/* Things among a few: what is shown as a ghost, whose route, which way of driving. */
#include <string.h>

#include "laboratory/house/schedule.h"

#define GHOST "Ghost"
#define ROUTE "Route"
#define DRIVING "Driving"

static PanelChoice *add_choice(HouseSession *live, const char *name, const char *meaning) {
    PanelChoice *choice = &live->choices[live->choice_count];
    *choice = (PanelChoice){.name = name, .meaning = meaning, .words = live->choice_words[live->choice_count]};
    live->choice_count++;
    return choice;
}

/* `chosen`: this is what is so now. */
static void add_word(HouseSession *live, PanelChoice *choice, const char *word, bool chosen) {
    if (choice->count == HOUSE_CHOICE_WORDS)
        return;
    if (chosen)
        choice->chosen = choice->count;
    live->choice_words[choice - live->choices][choice->count++] = word;
}

static bool anybody_rides(const House *house) {
    for (size_t k = 0; k < house->profile_count; k++)
        if (house->profiles[k].driving != DRIVING_WALKER)
            return true;
    return false;
}

static void list(HouseSession *live) {
    bool rides = live->runs[RUN_SHOWN] && anybody_rides(&live->runs[RUN_SHOWN]->house);
    live->choice_count = 0;
    PanelChoice *ghost = add_choice(live, GHOST,
                                    "What is shown behind, for comparison: the run that was kept with K, "
                                    "or the same house with the other way of driving.");
    add_word(live, ghost, "none", live->ghost == GHOST_NONE);
    if (live->runs[RUN_BEFORE])
        add_word(live, ghost, "before", live->ghost == GHOST_BEFORE);
    if (rides)
        add_word(live, ghost, profile_driving_name(house_runs_other_driving(live)), live->ghost == GHOST_RIVAL);
    const Plan *plan = draft_plan(live->draft);
    if (plan->route_count > 1) {
        PanelChoice *route = add_choice(live, ROUTE, "Whose route is driven: everybody's, or one alone.");
        add_word(live, route, "everybody", !live->wish.route);
        for (size_t r = 0; r < plan->route_count; r++) {
            const char *id = plan->routes[r].id;
            add_word(live, route, id, live->wish.route && strcmp(live->wish.route, id) == 0);
        }
    }
    if (!rides)
        return;
    PanelChoice *driving = add_choice(live, DRIVING,
                                      "The way of driving: as each profile says, a driver who turns the "
                                      "chair, or the paper's disc on straight legs and corners.");
    add_word(live, driving, "as in the file", live->wish.driving < 0);
    for (int way = DRIVING_DRIVER; way <= DRIVING_MIURA; way++)
        add_word(live, driving, profile_driving_name(way), live->wish.driving == way);
}

static void take_ghost(HouseSession *live, const char *word) {
    live->ghost = strcmp(word, "none") == 0 ? GHOST_NONE : strcmp(word, "before") == 0 ? GHOST_BEFORE : GHOST_RIVAL;
    live->retell = true;
    live->changed |= LABORATORY_WORDS | LABORATORY_PLOTS;
    house_session_void_film(live);
}

const PanelChoice *house_choices_list(HouseSession *live, size_t *count) {
    list(live);
    *count = live->choice_count;
    return live->choices;
}

void house_choices_take(HouseSession *live, size_t choice, size_t word) {
    list(live);
    if (choice >= live->choice_count || word >= live->choices[choice].count)
        return;
    const PanelChoice *taken = &live->choices[choice];
    if (strcmp(taken->name, GHOST) == 0) {
        take_ghost(live, taken->words[word]);
    } else if (strcmp(taken->name, ROUTE) == 0) {
        live->wish.route = word ? arena_text(&live->arena, taken->words[word]) : NULL;
        house_schedule_request(live);
    } else {
        live->wish.driving = (int)word - 1;
        editor_set_driving(live->editor, live->wish.driving);
        house_schedule_store(live, true);
        house_schedule_request(live);
    }
}
