#include "laboratory/house_live.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#include "base/parallel.h"
#include "laboratory/house_live_parts.h"

#define STEP (1.0 / 30) /* s, of one shown frame */
#define FASTEST 16.0
#define GRACE 0.3 /* s: a run that is over within so much is waited for, before anything of it is shown, or stopped */
#define MARGIN 2  /* samples at the end of a record that still changes are not shown */
#define TAKE_PART 16  /* rows are taken over when they are such a part of all, so that this costs little in sum */
#define TAKE_NEAR 1.0 /* s: or when what is shown comes so near to the end */
#define OUTSIDE 1.0   /* m, round exits: there people are seen to leave */

/* Layers, in the order of the keys 1 to 9. */
enum { RINGS, LOCI, GHOST, DANGER, WIDTHS, GRID, NAMES, FORCES, CIRCLES, LAYERS };
_Static_assert((int)LAYERS <= (int)LIVE_LAYERS_MOST, "a key for each layer");

double house_live_part_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Runs
 * ---------------------------------------------------------------------------------------------------------------*/

void house_live_part_release(HouseLive *live, HouseRun *run) {
    if (run && run != live->shown && run != live->before)
        house_live_worker_abandon(live->worker, run);
}

Before house_live_part_ghost(const HouseLive *live) {
    if (live->ghost == GHOST_BEFORE && live->before && live->before != live->shown)
        return (Before){.house = &live->before->house, .observation = &live->before->observation};
    if (live->ghost == GHOST_RIVAL && live->rival_over)
        return (Before){.house = &live->rival->house,
                        .observation = &live->rival->observation,
                        .word = profile_driving_name(live->rival->wish.driving)};
    return (Before){.house = NULL};
}

int house_live_part_rival(const HouseLive *live) {
    const House *house = &live->shown->house;
    for (size_t k = 0; k < house->profile_count; k++)
        if (house->profiles[k].driving != DRIVING_WALKER)
            return house->profiles[k].driving == DRIVING_MIURA ? DRIVING_DRIVER : DRIVING_MIURA;
    return DRIVING_MIURA;
}

/* Keeps the present values with a run, to come back to them. */
static void note_values(const HouseLive *live, HouseRun *run) {
    double *values = memory_allocate(live->values.count, sizeof *values);
    for (size_t i = 0; i < live->values.count; i++)
        values[i] = live->values.rows[i].value;
    house_live_run_note(run, values, live->values.count);
    memory_free(values);
}

static HouseRun *make_run(HouseLive *live, int driving) {
    const char **settings = memory_allocate(live->wish.setting_count + live->values.count, sizeof *settings);
    Arena arena = {0};
    HouseWish wish = live->wish;
    wish.settings = settings;
    wish.driving = driving;
    memcpy(settings, live->wish.settings, live->wish.setting_count * sizeof *settings);
    wish.setting_count += house_live_value_settings(&live->values, settings + live->wish.setting_count, &arena);
    HouseRun *run = house_live_run_create(&wish);
    note_values(live, run);
    arena_clear(&arena);
    memory_free(settings);
    return run;
}

static void drop_rival(HouseLive *live) {
    house_live_part_release(live, live->rival);
    live->rival = NULL;
    live->rival_over = false;
}

/* The first change after a run that is over keeps it, so that what the change does is seen without asking. */
static void keep_by_itself(HouseLive *live) {
    if (!live->whole || live->before)
        return;
    live->before = live->shown;
    live->kept_itself = true;
    live->ghost = live->ghost == GHOST_NONE ? GHOST_BEFORE : live->ghost;
    house_live_choices_list(live);
}

void house_live_part_ask(HouseLive *live) {
    if (live->latest && house_live_run_stage(live->latest) == HOUSE_WAITS) {
        house_live_worker_abandon(live->worker, live->latest);
    } else if (live->latest) {
        house_live_part_release(live, live->older);
        live->older = live->latest;
    }
    keep_by_itself(live);
    if (live->rival && !live->rival_over)
        drop_rival(live);
    live->latest = make_run(live, live->wish.driving);
    house_live_worker_ask(live->worker, live->latest, true);
    live->changed |= LIVE_WORDS | LIVE_PARAMETERS;
}

static void say_trouble(HouseLive *live, double time) {
    live->trouble_time = time;
    live->changed |= LIVE_TROUBLE | LIVE_WORDS;
}

static void clear_trouble(HouseLive *live) {
    memory_free(live->trouble.text);
    live->trouble = (Text){0};
    live->changed |= LIVE_WORDS;
}

/* Whose numbers were lost, when, and what would help. */
static void tell_divergence(HouseLive *live) {
    for (size_t i = 0; i < live->observation->person_count; i++) {
        const PersonObservation *person = &live->observation->people[i];
        const Inhabitant *who = &live->shown->house.people[i];
        if (person->reason != REASON_DIVERGED)
            continue;
        text_format(&live->trouble,
                    "%sthe numbers of person %s diverged at %.3f s, the run ends with the last good state: smaller "
                    "run.dt or softer contact of %s would help",
                    live->trouble.used ? "\n" : "", who->id, person->time, who->profile->name);
        say_trouble(live, person->time);
    }
}

/* What is shown
 * ------------------------------------------------------------------------------------------------------*/

double house_live_part_end(const HouseLive *live) {
    if (!live->shown)
        return 0;
    const Observation *observation = live->observation;
    return live->whole ? observation->time : fmax(0, observation->time - MARGIN * observation->sample);
}

/* The plan, and room before its exits: the same while people go out and wherever they drive. */
static Box box_of(const House *house) {
    Box box = house->outline.box;
    for (size_t e = 0; e < house->plan.exit_count; e++) {
        const Exit *exit = &house->plan.exits[e];
        Vec2 across = vec2_scale(vec2_left(vec2_unit(vec2_sub(exit->to, exit->from))), OUTSIDE);
        box = box_include(box_include(box, vec2_add(exit->from, across)), vec2_sub(exit->from, across));
        box = box_include(box_include(box, vec2_add(exit->to, across)), vec2_sub(exit->to, across));
    }
    return box_expand(box, HOUSE_SCENE_MARGIN);
}

static int hidden_of(unsigned layers) {
    static const int bits[][2] = {{RINGS, FILM_RINGS}, {LOCI, FILM_LOCI},   {GHOST, FILM_GHOST},  {DANGER, FILM_DANGER},
                                  {GRID, FILM_GRID},   {NAMES, FILM_NAMES}, {FORCES, FILM_FORCES}};
    int hidden = 0;
    for (size_t i = 0; i < sizeof bits / sizeof *bits; i++)
        hidden |= layers & 1u << bits[i][0] ? 0 : bits[i][1];
    return hidden;
}

static void make_film(HouseLive *live) {
    if (live->film)
        film_destroy(live->film);
    int shown = (live->layers & 1u << CIRCLES ? FILM_CIRCLES : 0) |
                (live->layers & 1u << WIDTHS ? FILM_ROUTES | FILM_WIDTHS : 0);
    FilmOptions options = {.camera = live->camera,
                           .bare = true,
                           .shown = shown,
                           .hidden = hidden_of(live->layers),
                           .before = house_live_part_ghost(live),
                           .live = true,
                           .box = box_of(&live->shown->house)};
    live->film = film_create(&live->shown->house, live->observation, &options);
    live->remake = false;
    live->fresh = true;
}

static void list_trails(HouseLive *live) {
    if (live->trails)
        trail_free_list(live->trails);
    live->trails = trail_list(live->observation);
}

/* A person is the same by name; a dangerous point of another run is another one. */
static void select_again(HouseLive *live, const House *before, const House *now) {
    LiveThing *thing = &live->selected;
    if (thing->kind == HOUSE_HAZARD)
        *thing = (LiveThing){0, 0};
    if (thing->kind != HOUSE_PERSON)
        return;
    const char *id = before->people[thing->index].id;
    for (size_t i = 0; i < now->person_count; i++)
        if (strcmp(now->people[i].id, id) == 0) {
            thing->index = i;
            return;
        }
    *thing = (LiveThing){0, 0};
}

static void finish(HouseLive *live) {
    observation_free(&live->growing);
    live->whole = true;
    live->observation = &live->shown->observation;
    tell_divergence(live);
}

/* Another run takes the place of the one shown. */
static void swap_in(HouseLive *live, HouseRun *run) {
    HouseRun *last = live->shown;
    if (live->film)
        film_destroy(live->film);
    live->film = NULL;
    observation_free(&live->growing);
    clear_trouble(live);
    if (last)
        select_again(live, &last->house, &run->house);
    live->shown = run;
    live->whole = false;
    live->growing = house_live_run_begin(run);
    live->observation = &live->growing;
    house_live_part_release(live, last);
    drop_rival(live);
    if (house_live_run_stage(run) == HOUSE_OVER)
        finish(live);
    else
        house_live_run_take(run, &live->growing, 0);
    list_trails(live);
    live->remake = true;
    live->changed |= LIVE_ALL & ~LIVE_TROUBLE;
}

/* The first house that has been read tells which numbers there are. */
static void list_values(HouseLive *live) {
    house_live_value_list(&live->values, &live->shown->house);
    note_values(live, live->shown);
}

/* Following what is in work
 * ------------------------------------------------------------------------------------------*/

/* There is no such house: everything is again as in the one shown, which goes on if it was stopped. */
static void turn_back(HouseLive *live, HouseRun *run) {
    clear_trouble(live);
    for (size_t i = 0; i < run->fault.count; i++)
        text_format(&live->trouble, "%s%s", i ? "\n" : "", run->fault.lines[i]);
    say_trouble(live, 0);
    live->changed |= LIVE_PARAMETERS;
    if (!live->shown)
        return;
    for (size_t i = 0; i < live->values.count; i++)
        live->values.rows[i].value = live->shown->values[i];
    live->wish.driving = live->shown->wish.driving;
    house_live_choices_list(live);
    if (!live->whole && house_live_run_stage(live->shown) == HOUSE_STOPPED)
        house_live_part_ask(live);
}

/* Is it time to show a run that has been asked for? */
static bool is_ready(HouseLive *live, HouseRun *run, double time) {
    HouseStage stage = house_live_run_stage(run);
    if (stage == HOUSE_OVER || (!live->shown && (stage == HOUSE_PLANS || stage == HOUSE_DRIVES)))
        return true;
    return stage == HOUSE_DRIVES && house_live_run_age(run) > GRACE && house_live_run_reach(run) > time + TAKE_NEAR;
}

static void follow_asked(HouseLive *live, HouseRun **asked, double time) {
    HouseRun *run = *asked;
    if (!run)
        return;
    HouseStage stage = house_live_run_stage(run);
    if (stage == HOUSE_FAILED || stage == HOUSE_STOPPED) {
        bool latest = run == live->latest;
        *asked = NULL;
        if (latest && stage == HOUSE_FAILED)
            turn_back(live, run);
        house_live_part_release(live, run);
    } else if (is_ready(live, run, time)) {
        *asked = NULL;
        if (asked == &live->latest) {
            house_live_part_release(live, live->older);
            live->older = NULL;
        }
        swap_in(live, run);
        if (!live->values.count)
            list_values(live);
        house_live_choices_list(live);
    }
}

/* What has begun before the latest was asked for may end, so that something is seen while a slider moves, but not for
 * long. */
static void hurry(HouseLive *live) {
    if (!live->latest || house_live_run_stage(live->latest) != HOUSE_WAITS)
        return;
    if (live->older && house_live_run_age(live->older) > GRACE) {
        house_live_part_release(live, live->older);
        live->older = NULL;
    }
    if (live->shown && !live->whole)
        parallel_stop(&live->shown->stop);
}

static void follow_shown(HouseLive *live, double time) {
    if (!live->shown || live->whole)
        return;
    if (house_live_run_stage(live->shown) == HOUSE_OVER) {
        film_destroy(live->film);
        live->film = NULL;
        finish(live);
        list_trails(live);
        live->remake = true;
        live->changed |= LIVE_VIEW | LIVE_WORDS | LIVE_PLOTS;
        return;
    }
    bool near = time + TAKE_NEAR > house_live_part_end(live);
    size_t least = near ? 1 : live->observation->trace.rows / TAKE_PART + 1;
    if (!house_live_run_take(live->shown, &live->growing, least))
        return;
    list_trails(live);
    if (live->film)
        film_extend(live->film);
    house_live_plots_make(live, false);
    live->changed |= house_live_part_now() - live->words.said > GRACE ? LIVE_WORDS : 0;
}

static void follow_rival(HouseLive *live) {
    if (live->ghost != GHOST_RIVAL || !live->whole || live->latest || live->rival_over)
        return;
    if (!live->rival) {
        live->rival = make_run(live, house_live_part_rival(live));
        house_live_worker_ask(live->worker, live->rival, false);
        live->changed |= LIVE_WORDS;
    }
    HouseStage stage = house_live_run_stage(live->rival);
    if (stage != HOUSE_OVER && stage != HOUSE_FAILED)
        return;
    live->rival_over = stage == HOUSE_OVER;
    if (!live->rival_over) {
        live->ghost = GHOST_NONE;
        drop_rival(live);
        house_live_choices_list(live);
    }
    live->remake = true;
    live->changed |= LIVE_VIEW | LIVE_WORDS | LIVE_PLOTS;
}

static unsigned update(void *context, double time) {
    HouseLive *live = context;
    follow_asked(live, &live->older, time);
    follow_asked(live, &live->latest, time);
    hurry(live);
    follow_shown(live, time);
    follow_rival(live);
    if (house_live_words_moved(live, time))
        live->changed |= LIVE_WORDS;
    unsigned changed = live->changed;
    live->changed = 0;
    if (!live->shown)
        return changed | (house_live_words_does_other(live) ? LIVE_WORDS : 0);
    if (live->remake || !live->film)
        make_film(live);
    else if (changed & LIVE_VIEW)
        film_look(live->film, live->camera);
    live->fresh = live->fresh || changed & LIVE_VIEW;
    if (changed & LIVE_PLOTS)
        house_live_plots_make(live, true);
    if (changed & LIVE_WORDS)
        house_live_words_make(live, time);
    if (changed & LIVE_PARAMETERS)
        house_live_value_sort(&live->values, &live->shown->house, live->selected);
    return changed | (house_live_words_does_other(live) ? LIVE_WORDS : 0);
}

/* Opening and closing
 * ------------------------------------------------------------------------------------------------*/

static void keep_wish(HouseLive *live, const char *path, const LiveOptions *options) {
    const char **settings = arena_allocate(&live->arena, (options->setting_count + 1) * sizeof *settings);
    for (size_t i = 0; i < options->setting_count; i++)
        settings[i] = arena_text(&live->arena, options->settings[i]);
    live->wish = (HouseWish){.path = arena_text(&live->arena, path),
                             .profiles = arena_text(&live->arena, options->profiles),
                             .settings = settings,
                             .setting_count = options->setting_count,
                             .route = options->route ? arena_text(&live->arena, options->route) : NULL,
                             .driving = options->driving,
                             .seed = options->seed,
                             .jobs = options->jobs};
}

static bool know_route(const Plan *plan, const char *path, const char *route, Fault *fault) {
    if (!route || plan_find_route(plan, route) != SIZE_MAX)
        return true;
    Text known = {0};
    for (size_t r = 0; r < plan->route_count; r++)
        text_format(&known, "%s%s", r ? ", " : ", its routes are ", plan->routes[r].id);
    fault_add(fault, "%s has no route \"%s\"%s", path, route, known.text ? known.text : "");
    memory_free(known.text);
    return false;
}

static void *open_house(const char *path, const LiveOptions *options, Fault *fault) {
    Plan plan = {0};
    if (!plan_read(&plan, path, options->settings, options->setting_count, fault))
        return NULL;
    if (!know_route(&plan, path, options->route, fault)) {
        plan_free(&plan);
        return NULL;
    }
    HouseLive *live = memory_allocate(1, sizeof *live);
    live->plan = plan;
    live->nothing = (Scene){.box = {{0, 0}, {1, 1}}, .bare = true, .unscaled = true};
    live->layers = house_live.layers_at_first;
    keep_wish(live, path, options);
    live->worker = house_live_worker_create();
    house_live_choices_list(live);
    house_live_part_ask(live);
    return live;
}

static void close_house(void *context) {
    HouseLive *live = context;
    HouseRun *runs[] = {live->shown, live->latest, live->older, live->rival,
                        live->before == live->shown ? NULL : live->before};
    if (live->film)
        film_destroy(live->film);
    if (live->trails)
        trail_free_list(live->trails);
    for (size_t i = 0; i < sizeof runs / sizeof *runs; i++)
        house_live_worker_abandon(live->worker, runs[i]);
    house_live_worker_destroy(live->worker);
    house_live_plots_clear(live);
    house_live_words_clear(live);
    house_live_value_clear(&live->values);
    observation_free(&live->growing);
    plan_free(&live->plan);
    memory_free(live->trouble.text);
    memory_free(live->command);
    arena_clear(&live->command_arena);
    arena_clear(&live->arena);
    memory_free(live);
}

/* Showing
 * ------------------------------------------------------------------------------------------------------------*/

static LiveSpan span(const void *context) {
    const HouseLive *live = context;
    return (LiveSpan){
        .end = house_live_part_end(live), .complete = live->whole, .pace = 1, .step = STEP, .fastest = FASTEST};
}

static double reach(void *context, double time) {
    (void)time;
    return house_live_part_end(context);
}

static bool show(void *context, double time) {
    HouseLive *live = context;
    if (!live->film)
        return false;
    if (live->fresh)
        film_forget(live->film);
    bool onwards = film_show(live->film, time) && !live->fresh;
    live->fresh = false;
    return onwards;
}

static const Scene *still(const void *context) {
    const HouseLive *live = context;
    return live->film ? film_still(live->film) : &live->nothing;
}

static const Scene *added(const void *context) {
    const HouseLive *live = context;
    return live->film ? film_added(live->film) : &live->nothing;
}

static const Scene *moving(const void *context) {
    const HouseLive *live = context;
    return live->film ? film_moving(live->film) : &live->nothing;
}

static void look(void *context, Camera camera) {
    HouseLive *live = context;
    live->remake = live->remake || camera.kind != live->camera.kind;
    live->camera = camera;
    live->changed |= LIVE_VIEW;
}

static void reveal(void *context, unsigned layers) {
    HouseLive *live = context;
    live->layers = layers;
    live->remake = true;
    live->changed |= LIVE_VIEW;
}

static size_t plot_count(const void *context) {
    const HouseLive *live = context;
    return live->plots.made ? HOUSE_PLOTS_KNOWN : 0;
}

static LivePlot plot(const void *context, size_t index) {
    return house_live_plots_at(context, index);
}

static size_t until(const void *context, size_t plot, size_t series, double time) {
    const HouseLive *live = context;
    return house_plots_until(&live->plots.plots, plot, series, time);
}

/* Words
 * --------------------------------------------------------------------------------------------------------------*/

static LiveAnswer answer(const void *context) {
    return house_live_words_answer((HouseLive *)context);
}

static const char *say_clock(const void *context, double time) {
    HouseLive *live = (HouseLive *)context;
    snprintf(live->clock, sizeof live->clock, "%.1f s", time);
    return live->clock;
}

static const char *note(const void *context) {
    const HouseLive *live = context;
    return house_scene_is_assumed(&live->plan) ? "assumed plan: not measured" : "";
}

static const char *title(const void *context) {
    const HouseLive *live = context;
    return *live->plan.name ? live->plan.name : "house";
}

static const LiveRow *rows(const void *context, size_t *count) {
    const HouseLive *live = context;
    *count = live->words.row_count;
    return live->words.rows;
}

static const LiveTick *ticks(const void *context, size_t *count) {
    const HouseLive *live = context;
    *count = live->words.tick_count;
    return live->words.ticks;
}

static const char *trouble(const void *context, double *time) {
    const HouseLive *live = context;
    *time = live->trouble_time;
    return live->trouble.text;
}

/* Changing
 * -----------------------------------------------------------------------------------------------------------*/

static const LiveParameter *parameters(const void *context, size_t *count) {
    const HouseLive *live = context;
    *count = live->values.count;
    return live->values.listed;
}

static bool set(void *context, const char *name, double value, Fault *fault) {
    HouseLive *live = context;
    size_t row = house_live_value_find(&live->values, name);
    if (row == SIZE_MAX) {
        fault_add(fault, "there is no number called \"%s\"", name);
        return false;
    }
    double before = live->values.rows[row].value;
    if (!house_live_value_set(&live->values, row, value, fault))
        return false;
    if (value != before)
        house_live_part_ask(live);
    return true;
}

static void reset(void *context) {
    HouseLive *live = context;
    for (size_t i = 0; i < live->values.count; i++)
        live->values.rows[i].value = live->values.rows[i].initial;
    house_live_part_ask(live);
}

static const LivePreset *presets(const void *context, size_t *count) {
    (void)context;
    *count = 0;
    return NULL;
}

static void prefer(void *context, size_t preset) {
    (void)context;
    (void)preset;
}

static const LiveChoice *choices(const void *context, size_t *count) {
    const HouseLive *live = context;
    *count = live->choice_count;
    return live->choices;
}

static void choose(void *context, size_t choice, size_t word) {
    house_live_choices_take(context, choice, word);
}

/* What is recorded is what would come: only a run that was stopped or broke down is made again. */
static void again(void *context) {
    HouseLive *live = context;
    if (live->trouble.text && !live->latest)
        house_live_part_ask(live);
}

static void keep(void *context, double time) {
    HouseLive *live = context;
    (void)time;
    if (!live->whole)
        return;
    HouseRun *last = live->before;
    live->before = live->shown;
    house_live_part_release(live, last);
    live->kept_itself = false;
    live->ghost = GHOST_BEFORE;
    live->remake = true;
    live->changed |= LIVE_VIEW | LIVE_WORDS | LIVE_PLOTS;
    house_live_choices_list(live);
}

static void clear(void *context, double time) {
    HouseLive *live = context;
    (void)time;
    HouseRun *last = live->before;
    live->before = NULL;
    house_live_part_release(live, last);
    live->ghost = GHOST_NONE;
    live->remake = true;
    live->changed |= LIVE_VIEW | LIVE_WORDS | LIVE_PLOTS;
    house_live_choices_list(live);
}

/* Pointing
 * -----------------------------------------------------------------------------------------------------------*/

static LiveThing pick(const void *context, Vec2 at, double time, LiveThing below) {
    const HouseLive *live = context;
    HouseScenery scenery = live->shown ? house_live_part_scenery(live) : (HouseScenery){NULL, NULL, NULL};
    return live->shown ? house_live_thing_at(&scenery, at, time, below) : (LiveThing){0, 0};
}

static LiveThing next(const void *context, LiveThing thing, int step) {
    const HouseLive *live = context;
    HouseScenery scenery = live->shown ? house_live_part_scenery(live) : (HouseScenery){NULL, NULL, NULL};
    return live->shown ? house_live_thing_next(&scenery, thing, step) : (LiveThing){0, 0};
}

static void select_thing(void *context, LiveThing thing) {
    HouseLive *live = context;
    bool known =
        live->shown && thing.index < house_live_thing_count(&live->shown->house, live->observation, thing.kind);
    LiveThing chosen = known ? thing : (LiveThing){0, 0};
    if (live_same(chosen, live->selected))
        return;
    bool people = chosen.kind == HOUSE_PERSON || live->selected.kind == HOUSE_PERSON;
    live->selected = chosen;
    live->changed |= LIVE_WORDS | LIVE_PARAMETERS | (people ? LIVE_PLOTS : 0);
}

static LiveThing selected(const void *context) {
    return ((const HouseLive *)context)->selected;
}

static const char *name_thing(const void *context, LiveThing thing) {
    HouseLive *live = (HouseLive *)context;
    *live->name = 0;
    if (live->shown)
        house_live_thing_name(&live->shown->house, live->observation, thing, live->name, sizeof live->name);
    return live->name;
}

static size_t outline(const void *context, LiveThing thing, double time, Vec2 *points) {
    const HouseLive *live = context;
    if (!live->shown)
        return 0;
    HouseScenery scenery = house_live_part_scenery(live);
    return house_live_thing_outline(&scenery, thing, time, points);
}

/* The words behind "clearance"
 * ---------------------------------------------------------------------------------------*/

static const char *const *command(const void *context, size_t *count) {
    HouseLive *live = (HouseLive *)context;
    Arena *arena = &live->command_arena;
    arena_clear(arena);
    memory_free(live->command);
    size_t most = 8 + 2 * (live->wish.setting_count + live->values.count), used = 0;
    const char **words = memory_allocate(most, sizeof *words);
    const char **settings = memory_allocate(live->values.count, sizeof *settings);
    size_t changed = house_live_value_settings(&live->values, settings, arena);
    words[used++] = "run";
    words[used++] = live->wish.path;
    for (size_t i = 0; i < live->wish.setting_count + changed; i++) {
        words[used++] = "--set";
        words[used++] = i < live->wish.setting_count ? live->wish.settings[i] : settings[i - live->wish.setting_count];
    }
    if (live->wish.route) {
        words[used++] = "--route";
        words[used++] = live->wish.route;
    }
    if (live->wish.driving >= 0) {
        words[used++] = "--driving";
        words[used++] = profile_driving_name(live->wish.driving);
    }
    if (live->wish.seed != 1) {
        words[used++] = "--seed";
        words[used++] = text_in_arena(arena, "%llu", (unsigned long long)live->wish.seed);
    }
    memory_free(settings);
    live->command = words;
    live->command_count = used;
    *count = used;
    return words;
}

static bool sound(const void *context, double from, double to, float *samples, size_t count) {
    (void)context;
    (void)from;
    (void)to;
    (void)samples;
    (void)count;
    return false;
}

uint64_t house_live_digest(const void *context) {
    const HouseLive *live = context;
    return live->whole && !live->latest ? live->observation->digest : 0;
}

static const char *const layer_names[LAYERS] = {
    [RINGS] = "rings", [LOCI] = "ways",   [GHOST] = "ghost",   [DANGER] = "danger",   [WIDTHS] = "widths",
    [GRID] = "grid",   [NAMES] = "names", [FORCES] = "forces", [CIRCLES] = "circles",
};

static const char *const layer_meanings[LAYERS] = {
    [RINGS] = "Personal spaces, pressed in where something is near.",
    [LOCI] = "The ways so far, with a tick each second and bodies left behind.",
    [GHOST] = "What was before, or the other way of driving.",
    [DANGER] = "Discs of the dangerous points, by rank.",
    [WIDTHS] = "The planned ways, and the widths W1 and W2 before and behind each corner.",
    [GRID] = "Lines a metre apart.",
    [NAMES] = "Names of people, rooms, doors and furniture.",
    [FORCES] = "Stars of contacts, with their forces.",
    [CIRCLES] = "Discs that cover the chairs, as simpler methods have them.",
};

const LiveKind house_live = {
    .name = "House",
    .word = "house",
    .plots_at_first = "speed,clearance",
    .layers = layer_names,
    .meanings = layer_meanings,
    .layer_count = LAYERS,
    .layers_at_first = (1u << LAYERS) - 1 - (1u << WIDTHS) - (1u << CIRCLES),
    .raised = true,
    .open = open_house,
    .close = close_house,
    .update = update,
    .span = span,
    .reach = reach,
    .show = show,
    .still = still,
    .added = added,
    .moving = moving,
    .look = look,
    .reveal = reveal,
    .plot_count = plot_count,
    .plot = plot,
    .until = until,
    .answer = answer,
    .clock = say_clock,
    .note = note,
    .title = title,
    .rows = rows,
    .ticks = ticks,
    .trouble = trouble,
    .parameters = parameters,
    .set = set,
    .reset = reset,
    .presets = presets,
    .prefer = prefer,
    .choices = choices,
    .choose = choose,
    .again = again,
    .keep = keep,
    .clear = clear,
    .pick = pick,
    .next = next,
    .select = select_thing,
    .selected = selected,
    .name_thing = name_thing,
    .outline = outline,
    .command = command,
    .sound = sound,
};
