#include "inquiry/suggest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/stop.h"
#include "base/text.h"
#include "base/visible.h"
#include "house/run.h"
#include "inquiry/suggest_change.h"
#include "inquiry/suggest_search.h"
#include "plan/plan_geometry.h"

enum { TOGETHER_MOST = 6 /* largest number of changes proposed together */ };

/* All possible changes at their maximum: doors at their widest, pieces removed; ordered by distance from the first
 * blocked person. */
typedef struct Elements {
    Change *of;   /* (count) */
    double *away; /* m, distance from there */
    size_t count;
} Elements;

/* Adds a note as one line, whatever the names in it hold. */
static void add_note(SuggestList *list, const char *note) {
    char *line = visible_line(note);
    list->notes = memory_reserve(list->notes, &list->note_capacity, list->note_count + 1, sizeof *list->notes);
    list->notes[list->note_count++] = arena_text(&list->arena, line);
    memory_free(line);
}

/* What there is to be changed -------------------------------------------------------------------------------------- */

static void add_element(Elements *elements, Change change, Vec2 at, Vec2 stuck) {
    size_t i = elements->count++;
    double away = vec2_distance(at, stuck);
    for (; i > 0 && elements->away[i - 1] > away; i--) {
        elements->of[i] = elements->of[i - 1];
        elements->away[i] = elements->away[i - 1];
    }
    elements->of[i] = change;
    elements->away[i] = away;
}

static void add_doors(Elements *elements, const Plan *plan, Vec2 stuck, SuggestList *list) {
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        Vec2 from, to;
        plan_geometry_door_ends(plan, door, &from, &to);
        Change widest;
        if (door->state == DOOR_LOCKED)
            add_note(list, text_in_arena(&list->arena, "door %s is locked and stays locked", door->id));
        else if (suggest_search_widest(plan, d, &widest))
            add_element(elements, widest, vec2_scale(vec2_add(from, to), 0.5), stuck);
        else if (door->width < SUGGEST_SEARCH_WIDEST)
            add_note(list,
                     text_in_arena(&list->arena, "door %s stays %.2f m wide: there is no wall next to it to remove",
                                   door->id, door->width));
    }
}

static Elements list_elements(Search *search, Vec2 stuck, SuggestList *list) {
    const Plan *plan = &search->base->plan;
    size_t most = plan->door_count + plan->furniture_count;
    Elements elements = {arena_allocate(&search->arena, most * sizeof *elements.of),
                         arena_allocate(&search->arena, most * sizeof *elements.away), 0};
    add_doors(&elements, plan, stuck, list);
    for (size_t f = 0; f < plan->furniture_count && plan->wall_count; f++)
        add_element(&elements, (Change){.kind = CHANGE_AWAY, .index = f}, plan->furniture[f].centre, stuck);
    return elements;
}

/* What comes of it ------------------------------------------------------------------------------------------------- */

static int compare_suggestions(const void *a, const void *b) {
    const Suggestion *p = a, *q = b;
    return p->size != q->size ? (p->size < q->size ? -1 : 1) : strcmp(p->text, q->text);
}

/* Adds a suggestion. Of two similar ones, or when the list is full, the smaller one stays. */
static void add_suggestion(SuggestList *list, const Plan *plan, const Change *changes, size_t count, double time) {
    Suggestion one = {.time = time};
    Text words = {0};
    const char **settings = arena_allocate(&list->arena, count * CHANGE_SETTINGS_MOST * sizeof *settings);
    for (size_t i = 0; i < count; i++) {
        one.size += suggest_change_size(plan, &changes[i]);
        one.setting_count += suggest_change_settings(plan, &changes[i], settings + one.setting_count, &list->arena);
        one.works[suggest_change_work(plan, &changes[i])] = true;
        text_add(&words, i ? (i + 1 < count ? ", " : " and ") : "");
        text_add(&words, suggest_change_words(plan, &changes[i], &list->arena));
    }
    words.text[0] = (char)(words.text[0] - 'a' + 'A');
    one.text = arena_text(&list->arena, words.text);
    one.settings = settings;
    memory_free(words.text);
    for (size_t i = 0; i < list->count; i++)
        if (strcmp(list->list[i].text, one.text) == 0)
            return;
    if (list->count < SUGGEST_MOST)
        list->list[list->count++] = one;
    else if (compare_suggestions(&one, &list->list[list->count - 1]) < 0)
        list->list[list->count - 1] = one;
    qsort(list->list, list->count, sizeof *list->list, compare_suggestions);
}

/* One change alone ------------------------------------------------------------------------------------------------- */

/* Finds the elements from `first` to `last`, sufficient together, that are sufficient alone. `good` (elements). */
static void sift(Search *search, const Elements *elements, size_t first, size_t last, bool *good) {
    if (last - first == 1) {
        good[first] = true;
        return;
    }
    size_t middle = first + (last - first) / 2;
    Attempt halves[2] = {
        {.changes = elements->of + first, .count = middle - first, .planned_only = true},
        {.changes = elements->of + middle, .count = last - middle, .planned_only = true},
    };
    if (!suggest_search_try(search, halves, 2))
        return;
    if (halves[0].good)
        sift(search, elements, first, middle, good);
    if (halves[1].good)
        sift(search, elements, middle, last, good);
}

/* Notes an element that is sufficient, but for which no smaller change was found. */
static void note_unfound(SuggestList *list, Search *search, const Change *element) {
    const char *words = suggest_change_words(&search->base->plan, element, &list->arena);
    bool cut_short = search->exhausted || stop_requested(search->task->stop);
    add_note(list, text_in_arena(&list->arena,
                                 cut_short ? "it would help to %s; the smallest sufficient change is not known yet"
                                           : "it would help to %s; no smaller change was found",
                                 words));
}

/* Suggests single changes. Elements that are sufficient but cannot be realised are removed from the list. */
static void suggest_singles(SuggestList *list, Search *search, Elements *elements) {
    const Plan *plan = &search->base->plan;
    bool *good = arena_allocate(&search->arena, elements->count * sizeof *good);
    size_t kept = 0;
    sift(search, elements, 0, elements->count, good);
    for (size_t e = 0; e < elements->count; e++) {
        Change element = elements->of[e];
        Variant variants[VARIANTS_MOST];
        size_t found = good[e] ? suggest_search_variants(search, NULL, 0, &element, variants) : 0;
        for (size_t w = 0; w < found; w++)
            add_suggestion(list, plan, &variants[w].change, 1, variants[w].time);
        if (good[e] && !found)
            note_unfound(list, search, &element);
        if (!good[e] || found)
            elements->of[kept++] = element;
    }
    elements->count = kept;
}

/* Several together ------------------------------------------------------------------------------------------------- */

/* Undoes changes one by one, the farthest first, those of one kind before the others. Returns the number left in
 * `needed`, 0 when all together were not sufficient. */
static size_t put_back(Search *search, const Elements *elements, bool furniture_first, Change *needed) {
    size_t left = elements->count;
    memcpy(needed, elements->of, left * sizeof *needed);
    Attempt all = {.changes = needed, .count = left, .planned_only = true};
    if (!suggest_search_try(search, &all, 1) || !all.good)
        return 0;
    for (int round = 0; round < 2; round++) {
        ChangeKind kind = (round == 0) == furniture_first ? CHANGE_AWAY : CHANGE_WIDEN;
        for (size_t e = left; e-- > 0;) {
            if (needed[e].kind != kind)
                continue;
            Change tried = needed[e];
            memmove(needed + e, needed + e + 1, (left - e - 1) * sizeof *needed);
            Attempt without = {.changes = needed, .count = left - 1, .planned_only = true};
            if (!suggest_search_try(search, &without, 1))
                return 0;
            if (without.good) {
                left--;
                continue;
            }
            memmove(needed + e + 1, needed + e, (left - e - 1) * sizeof *needed);
            needed[e] = tried;
        }
    }
    return left;
}

/* Minimises the needed changes (count) one after another, with the others fixed. */
static bool shrink(Search *search, Change *needed, size_t count, double *time) {
    const Plan *plan = &search->base->plan;
    for (size_t n = 0; n < count; n++) {
        Change element = needed[0];
        memmove(needed, needed + 1, (count - 1) * sizeof *needed);
        Variant variants[VARIANTS_MOST];
        size_t found = suggest_search_variants(search, needed, count - 1, &element, variants), best = 0;
        if (!found || stop_requested(search->task->stop))
            return false; /* a smaller change may not have been tried */
        for (size_t w = 1; w < found; w++)
            if (suggest_change_size(plan, &variants[w].change) < suggest_change_size(plan, &variants[best].change))
                best = w;
        needed[count - 1] = variants[best].change;
        *time = variants[best].time;
    }
    return true;
}

static void suggest_together(SuggestList *list, Search *search, const Elements *elements) {
    Change *needed = arena_allocate(&search->arena, (elements->count + 1) * sizeof *needed);
    for (int furniture_first = 1; furniture_first >= 0; furniture_first--) {
        size_t count = elements->count ? put_back(search, elements, furniture_first, needed) : 0;
        double time;
        if (count > TOGETHER_MOST)
            add_note(list, text_in_arena(&list->arena,
                                         "%zu changes would be needed together: too many for a suggestion", count));
        else if (count && shrink(search, needed, count, &time))
            add_suggestion(list, &search->base->plan, needed, count, time);
    }
}

/* The whole -------------------------------------------------------------------------------------------------------- */

/* Returns the first person who does not leave, or person_count. */
static size_t first_stuck(const Observation *observation) {
    size_t i = 0;
    while (i < observation->person_count && (!observation->people[i].took_part || observation->people[i].completed))
        i++;
    return i;
}

/* Returns "p1 cannot pass wall w1: needs at least 0.87 m, has 0.80 m". */
static const char *stuck_words(const House *house, const Observation *observation, Arena *arena) {
    size_t i = first_stuck(observation);
    const PersonObservation *person = &observation->people[i];
    char widths[ROUTE_WIDTHS];
    route_widths(&person->blockage, widths, sizeof widths);
    const char *reason = observation_reason(person->reason), *between = person->reason == REASON_BLOCKED ? "at " : "";
    return text_in_arena(arena, "%s: %s %s%s%s%s", house->people[i].id, reason, between, person->blockage.what,
                         *widths ? ", " : "", widths);
}

/* Explains why even all changes together are not sufficient. */
static void explain_nothing(SuggestList *list, Search *search, const Elements *elements) {
    House house = {0};
    Attempt all = {.changes = elements->of, .count = elements->count};
    if (!suggest_search_read(search, &all, &house))
        return;
    Observation observation;
    run_house(&observation, &house,
              &(RunOptions){.route = SIZE_MAX, .jobs = search->task->jobs, .stop = search->task->stop});
    if (!observation.completed && !observation.interrupted)
        add_note(list, text_in_arena(&list->arena, "%s: %s. Walls are not moved",
                                     elements->count ? "even with every door as wide as its wall allows and without "
                                                       "furniture"
                                                     : "there is no door to widen and no furniture to move",
                                     stuck_words(&house, &observation, &list->arena)));
    observation_free(&observation);
    house_free(&house);
}

static void suggest_all(SuggestList *list, Search *search, Vec2 stuck) {
    Elements elements = list_elements(search, stuck, list);
    Attempt all = {.changes = elements.of, .count = elements.count, .planned_only = true};
    if (!elements.count || (suggest_search_try(search, &all, 1) && !all.good)) {
        explain_nothing(list, search, &elements);
        return;
    }
    suggest_singles(list, search, &elements);
    if (!list->count)
        suggest_together(list, search, &elements);
}

/* Notes the blocked people, and whether planning alone decides. */
static Vec2 note_stuck(Search *search, const Observation *observation) {
    search->stuck = arena_allocate(&search->arena, (observation->person_count + 1) * sizeof *search->stuck);
    search->by_plan = true;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        bool out = !person->took_part || person->completed;
        search->stuck[i] = !out && observation_reason_is_planned(person->reason);
        search->by_plan &= out || search->stuck[i];
    }
    return observation->people[first_stuck(observation)].blockage.at;
}

bool suggest_find(SuggestList *list, const SuggestTask *task, Fault *fault) {
    House house = {0};
    if (!suggest_search_open(task, &house, task->options, fault))
        return false;
    *list = (SuggestList){0};
    Search search = {
        .task = task, .base = &house, .most = task->most_tries ? task->most_tries : SUGGEST_TRIES, .tries = 1};
    pthread_mutex_init(&search.lock, NULL);
    Observation observation;
    run_house(&observation, &house,
              &(RunOptions){.route = SIZE_MAX, .brief = true, .jobs = task->jobs, .stop = task->stop});
    list->out_already = observation.completed && !observation.interrupted;
    list->time = observation.time;
    if (!observation.completed && !observation.interrupted)
        suggest_all(list, &search, note_stuck(&search, &observation));
    list->tries = search.tries;
    list->exhausted = search.exhausted;
    list->stopped = observation.interrupted || stop_requested(task->stop);
    observation_free(&observation);
    house_free(&house);
    pthread_mutex_destroy(&search.lock);
    arena_clear(&search.arena);
    return true;
}

void suggest_clear(SuggestList *list) {
    memory_free(list->notes);
    arena_clear(&list->arena);
    *list = (SuggestList){0};
}
