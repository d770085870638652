#include "live/house/house_live.h"

#include <stdio.h>
#include <string.h>

#include "plan/draft_file.h"
#include "live/house/house_live_parts.h"
#include "live/live_save.h"

#define STEP (1.0 / 30) /* s, of one shown frame */
#define FASTEST 16.0

static size_t rows_recorded(const HouseLive *live) {
    return live->shown ? live->observation->trace.rows : 0;
}

static unsigned update(void *context, double time) {
    HouseLive *live = context;
    size_t rows = rows_recorded(live);
    live->time = time;
    house_live_follow_all(live, time);
    house_live_fall_follow(live);
    if (house_live_words_moved(live, time))
        live->changed |= LIVE_WORDS;
    unsigned changed = live->changed;
    live->changed = 0;
    if (live->shown) {
        house_live_show_make(live, time);
        changed |= live->changed; /* the plan was another one then */
        live->changed = 0;
        if (changed & LIVE_VIEW)
            film_look(live->film, live->camera);
        live->fresh = live->fresh || changed & LIVE_VIEW;
        if (changed & LIVE_PLOTS)
            house_live_plots_make(live, true);
        if (changed & LIVE_WORDS)
            house_live_words_make(live, time);
        if (changed & LIVE_PARAMETERS)
            house_live_value_sort(&live->values, &live->shown->house, live->selected);
    }
    bool other = house_live_words_does_other(live) || rows_recorded(live) != rows;
    return changed | (other ? LIVE_WORDS : 0);
}

/* Opening and closing --------------------------------------------------------------------------------------------- */

static void keep_wish(HouseLive *live, const char *path, const LiveOptions *options) {
    const char **settings = arena_allocate(&live->arena, (options->setting_count + 1) * sizeof *settings);
    for (size_t i = 0; i < options->setting_count; i++)
        settings[i] = arena_text(&live->arena, options->settings[i]);
    live->given = *options;
    live->given.settings = settings;
    live->given.origin = NULL;
    live->wish = (HouseWish){.path = arena_text(&live->arena, path),
                             .profiles = arena_text(&live->arena, options->profiles),
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

static Draft *open_draft(const char *path, const LiveOptions *options, Fault *fault) {
    if (!path)
        return draft_create("new house");
    Draft *draft = draft_file_read(path, options->settings, options->setting_count, fault);
    if (draft && know_route(draft_plan(draft), path, options->route, fault))
        return draft;
    draft_destroy(draft);
    return NULL;
}

static void *open_house(const char *path, const LiveOptions *options, Fault *fault) {
    Draft *draft = open_draft(path, options, fault);
    HouseWorker *worker = draft ? house_live_worker_create() : NULL;
    if (draft && !worker)
        fault_add(fault, "no house can be run: the system gives no more threads, close some other programs");
    if (!worker) {
        draft_destroy(draft);
        return NULL;
    }
    HouseLive *live = memory_zeroed(1, sizeof *live);
    live->draft = draft;
    house_edit_begin(live);
    live->nothing = (Scene){.box = {{0, 0}, {1, 1}}, .bare = true, .unscaled = true};
    live->layers = house_live.layers_at_first;
    keep_wish(live, options->origin ? options->origin : path ? path : "", options);
    live->worker = worker;
    house_live_history_begin(&live->history, draft_text(draft), draft_revision(draft));
    house_live_follow_ask(live);
    return live;
}

static void close_house(void *context) {
    HouseLive *live = context;
    house_edit_clear(live);
    if (live->film)
        film_destroy(live->film);
    house_live_follow_end(live);
    house_live_fall_clear(live);
    house_live_plots_clear(live);
    house_live_words_clear(live);
    house_live_value_clear(&live->values);
    house_live_value_clear(&live->opened);
    draft_destroy(live->draft);
    house_live_history_clear(&live->history);
    memory_free(live->trouble.text);
    memory_free(live->command);
    arena_clear(&live->command_arena);
    arena_clear(&live->arena);
    memory_free(live);
}

/* Showing --------------------------------------------------------------------------------------------------------- */

static LiveSpan span(const void *context) {
    const HouseLive *live = context;
    return (LiveSpan){.end = house_live_follow_reach(live),
                      .complete = live->whole || (!live->shown && !live->latest),
                      .pace = 1,
                      .step = STEP,
                      .fastest = FASTEST};
}

static double reach(void *context, double time) {
    (void)time;
    return house_live_follow_reach(context);
}

static bool show(void *context, double time) {
    HouseLive *live = context;
    live->time = time;
    house_live_show_make(live, time);
    if (!live->film)
        return false;
    if (live->fresh)
        film_forget(live->film);
    bool onwards = film_show(live->film, time) && !live->fresh;
    live->fresh = false;
    return onwards;
}

static bool rests(const void *context, double time) {
    const HouseLive *live = context;
    return live->film && !live->fresh && !live->fall.count && house_live_run_epoch(live->shown, time) == live->epoch &&
           film_rests(live->film, time);
}

static const Scene *still(const void *context) {
    const HouseLive *live = context;
    house_live_show_make((HouseLive *)context, live->time); /* if a call since the last update has made it void */
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
    if (camera.kind != live->camera.kind)
        house_live_show_anew(live);
    live->camera = camera;
    live->changed |= LIVE_VIEW;
}

static void reveal(void *context, unsigned layers) {
    HouseLive *live = context;
    if (layers != live->layers)
        house_live_show_anew(live);
    live->layers = layers;
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

/* Words ----------------------------------------------------------------------------------------------------------- */

static LiveAnswer answer(const void *context) {
    return house_live_words_answer((HouseLive *)context);
}

static const char *say_clock(const void *context, double time) {
    HouseWords *words = &((HouseLive *)context)->words;
    snprintf(words->clock, sizeof words->clock, "%.1f s", time);
    return words->clock;
}

static void add_note(HouseLive *live, const char *more) {
    char *words = live->words.note;
    size_t used = strlen(words);
    snprintf(words + used, sizeof live->words.note - used, "%s%s", used ? "; " : "", more);
}

static const char *note(const void *context) {
    HouseLive *live = (HouseLive *)context;
    const HouseWish *wish = live->shown ? &live->shown->wish : NULL;
    const char *picture = house_edit_image_trouble(live);
    *live->words.note = 0;
    if (wish && wish->epoch_count > 1) {
        char mixed[64];
        snprintf(mixed, sizeof mixed, "mixed: plan changed at %.1f s, R runs it clean",
                 wish->epochs[wish->epoch_count - 1].time);
        add_note(live, mixed);
    }
    if (house_scene_is_assumed(draft_plan(live->draft)))
        add_note(live, "assumed plan: not measured");
    if (picture)
        add_note(live, picture);
    return live->words.note;
}

static const char *title(const void *context) {
    const HouseLive *live = context;
    const char *name = draft_plan(live->draft)->name;
    return *name ? name : "house";
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

/* Pointing -------------------------------------------------------------------------------------------------------- */

static LiveThing pick(const void *context, Vec2 at, double time, LiveThing below) {
    const HouseLive *live = context;
    HouseScenery scenery = live->shown ? house_live_scenery(live) : (HouseScenery){NULL, NULL, NULL};
    return live->shown ? house_live_thing_at(&scenery, at, time, below) : (LiveThing){0, 0};
}

static LiveThing next(const void *context, LiveThing thing, int step) {
    const HouseLive *live = context;
    HouseScenery scenery = live->shown ? house_live_scenery(live) : (HouseScenery){NULL, NULL, NULL};
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
    HouseWords *words = &live->words;
    *words->name = 0;
    if (live->shown)
        house_live_thing_name(&live->shown->house, live->observation, thing, words->name, sizeof words->name);
    return words->name;
}

static size_t outline(const void *context, LiveThing thing, double time, Vec2 *points) {
    const HouseLive *live = context;
    if (!live->shown)
        return 0;
    HouseScenery scenery = house_live_scenery(live);
    size_t count = house_live_thing_outline(&scenery, thing, time, points);
    const FurnitureFall *fall = NULL;
    if (count && thing.kind == HOUSE_FURNITURE)
        fall = house_live_fall_find(live, house_live_thing_id(&live->shown->house, thing));
    if (fall)
        furniture_fall_corners(&fall->piece, furniture_fall_share(fall), points);
    return count;
}

static const char *const *command(const void *context, size_t *count) {
    return house_live_command_words((HouseLive *)context, count);
}

static bool save(const void *context, const char *path, Fault *fault) {
    return live_save_house(draft_text(((const HouseLive *)context)->draft), path, fault);
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
    return live->whole && !live->latest && !live->mixed ? live->observation->digest : 0;
}

static const char *const layer_names[LAYERS] = {
    [LAYER_RINGS] = "rings",   [LAYER_LOCI] = "ways",     [LAYER_GHOST] = "ghost",
    [LAYER_DANGER] = "danger", [LAYER_WIDTHS] = "widths", [LAYER_GRID] = "grid",
    [LAYER_NAMES] = "names",   [LAYER_FORCES] = "forces", [LAYER_CIRCLES] = "circles",
};

static const char *const layer_meanings[LAYERS] = {
    [LAYER_RINGS] = "Personal spaces, pressed in where something is near.",
    [LAYER_LOCI] = "The ways so far, with a tick each second and bodies left behind.",
    [LAYER_GHOST] = "What was before, or the other way of driving.",
    [LAYER_DANGER] = "Discs of the dangerous points, by rank.",
    [LAYER_WIDTHS] = "The planned ways, and the widths W1 and W2 before and behind each corner.",
    [LAYER_GRID] = "Lines a metre apart.",
    [LAYER_NAMES] = "Names of people, rooms, doors and furniture.",
    [LAYER_FORCES] = "Stars of contacts, with their forces.",
    [LAYER_CIRCLES] = "Discs that cover the chairs, as simpler methods have them.",
};

const LiveKind house_live = {
    .name = "House",
    .word = "house",
    .plots_at_first = "speed,clearance",
    .layers = layer_names,
    .meanings = layer_meanings,
    .layer_count = LAYERS,
    .layers_at_first = (1u << LAYERS) - 1 - (1u << LAYER_WIDTHS) - (1u << LAYER_CIRCLES),
    .raised = true,
    .open = open_house,
    .close = close_house,
    .update = update,
    .span = span,
    .reach = reach,
    .show = show,
    .rests = rests,
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
    .parameters = house_live_change_parameters,
    .set = house_live_change_set,
    .reset = house_live_change_reset,
    .presets = house_live_change_presets,
    .prefer = house_live_change_prefer,
    .choices = house_live_change_choices,
    .choose = house_live_change_choose,
    .again = house_live_change_again,
    .keep = house_live_change_keep,
    .clear = house_live_change_clear,
    .pick = pick,
    .next = next,
    .select = select_thing,
    .selected = selected,
    .name_thing = name_thing,
    .outline = outline,
    .command = command,
    .save = save,
    .sound = sound,
    .editor = &house_edit,
};
